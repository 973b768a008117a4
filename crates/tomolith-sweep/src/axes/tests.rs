use super::*;
use serde_json::json;

/// Points of axes whose runs take nobody knows how long.
fn points(
    axes: &[Axis],
    when: &[Condition],
    sample: Option<SampleSpec>,
) -> Result<Vec<SweepPoint>> {
    super::points(axes, when, sample, &|| None)
}

fn axis(text: Value, is_drawn: bool) -> Result<Axis> {
    Axis::new(&serde_json::from_value(text).unwrap(), "axes[0]", is_drawn)
}

fn linear(name: &str, from: f64, to: f64, step: f64) -> Axis {
    axis(
        json!({ "key": format!("a.{name}"), "linear": { "from": from, "to": to, "step": step } }),
        false,
    )
    .unwrap()
}

#[test]
fn a_value_counts_once() {
    let twice = json!({ "key": "k", "values": [1, 2, 1] });
    let error = axis(twice, false).unwrap_err().to_string();
    assert!(
        error.starts_with("axes[0].values[2]: 1, as values[0]"),
        "{error}"
    );
    assert!(axis(json!({ "key": "k", "values": [1, 2] }), false).is_ok());
}

#[test]
fn ranges_have_neat_values_and_both_ends() {
    assert_eq!(
        linear("x", 0.1, 0.7, 0.1).values(),
        [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7].map(Value::from)
    );
    assert_eq!(
        linear("x", 9.0, 5.0, -2.0).values(),
        [9, 7, 5].map(Value::from)
    );
    let log = json!({ "key": "k", "log": { "from": 1e-4, "to": 1.0, "count": 5 } });
    assert_eq!(
        axis(log, false).unwrap().values(),
        [1e-4, 1e-3, 0.01, 0.1, 1.0].map(Value::from)
    );
    let half = json!({ "key": "k", "linear": { "from": 0, "to": 1, "count": 3 } });
    assert_eq!(
        axis(half, false).unwrap().values(),
        [0.0, 0.5, 1.0].map(Value::from)
    );
    let whole = json!({ "key": "k", "log": { "from": 10, "to": 40, "count": 4, "whole": true } });
    assert_eq!(
        axis(whole, false).unwrap().values(),
        [10, 16, 25, 40].map(Value::from)
    );
}

#[test]
fn slips_name_their_keys() {
    let slips = r#"
        { "key": "k", "values": [] } → axes[0].values: an empty list
        { "key": "k" } → axes[0]: no values
        { "key": "k", "values": [1], "linear": { "from": 0, "to": 1, "count": 2 } } → axes[0]: more than one of values
        { "key": "k", "linear": { "from": 0, "to": 1 } } → axes[0].linear: neither step nor count
        { "key": "k", "linear": { "from": 0, "to": 1, "step": 0.1, "count": 2 } } → axes[0].linear: both step and count
        { "key": "k", "linear": { "from": 0, "to": 1, "step": -0.1 } } → axes[0].linear.step: found -0.1
        { "key": "k", "linear": { "from": 0, "to": 1, "count": 0 } } → axes[0].linear.count: found 0
        { "key": "k", "log": { "from": 0, "to": 1, "count": 3 } } → axes[0].log: from 0 to 1
        { "key": "k", "linear": { "from": 0, "to": 1, "step": 1e-300 } } → axes[0].linear: more than 10000000 values; accepted: 10000000 at most
        { "key": "k", "linear": { "from": 0, "to": 1e300, "step": 1e-300 } } → axes[0].linear: more than 10000000 values
        { "key": "k", "linear": { "from": 0, "to": 1, "step": 0 } } → axes[0].linear.step: found 0
        { "key": "k.run", "values": [1] } → axes[0].name: found "run"
        { "values": [1] } → axes[0]: neither key nor name
        { "name": "k", "values": [1] } → axes[0].key: the key is missing
        { "name": "k", "cases": [] } → axes[0].cases: an empty list
        { "key": "a.k", "cases": [{ "name": "a" }] } → axes[0].key: found both a key and cases
        { "name": "k", "cases": [{ "name": "a" }, { "name": "a" }] } → axes[0].cases[1].name: found "a" once more
    "#;
    for slip in slips.trim().lines() {
        let (text, start) = slip.split_once(" → ").unwrap();
        let message = axis(serde_json::from_str(text).unwrap(), false);
        let message = message.unwrap_err().to_string();
        assert!(message.starts_with(start), "{text}: {message}");
    }
}

#[test]
fn tables_that_are_alike_are_told_apart() {
    let labels = |values: Value| {
        let axis = axis(json!({ "key": "k", "values": values }), false).unwrap();
        let labels = axis.values().iter().map(|value| axis.label(value));
        labels.collect::<Vec<_>>()
    };
    let ospw = |lower: f64| json!({ "ospw": { "lower": lower, "upper": 0.9 } });
    let osmo = json!({ "osmo": { "lower": 0.5 } });
    assert_eq!(labels(json!([ospw(0.5), osmo])), ["ospw", "osmo"]);
    assert_eq!(
        labels(json!([ospw(0.4), ospw(0.5), osmo])),
        ["ospw lower=0.4", "ospw lower=0.5", "osmo"]
    );
    let pair = |lower: f64| json!({ "lower": lower, "upper": "8 mm" });
    assert_eq!(
        labels(json!([pair(0.4), pair(0.5), {}, 2])),
        ["lower=0.4 upper=8 mm", "lower=0.5 upper=8 mm", "{}", "2"]
    );
}

#[test]
fn a_case_sets_all_its_keys() {
    let cases = json!({ "name": "method", "cases": [
        { "name": "as it is" },
        { "name": "osmo", "set": { "optimizer": { "osmo": {} }, "objective": { "osmo": {} } } },
    ] });
    let axis = axis(cases, false).unwrap();
    assert_eq!(axis.values(), ["as it is", "osmo"].map(Value::from));
    assert_eq!(axis.settings(&"as it is".into()), []);
    let osmo = json!({ "osmo": {} });
    assert_eq!(
        axis.settings(&"osmo".into()),
        [("objective", &osmo), ("optimizer", &osmo)]
    );
    assert_eq!(
        axis.path_of("optimizer", |_| true).unwrap(),
        "cases[1].set.optimizer"
    );
    assert_eq!(axis.path_of("bounds", |_| true), None);
}

#[test]
fn pairs_that_break_a_condition_are_no_points() {
    let axes = [
        linear("lower", 0.1, 0.3, 0.1),
        linear("upper", 0.1, 0.3, 0.1),
    ];
    let when = ["lower < upper".parse().unwrap()];
    let found = points(&axes, &when, None).unwrap();
    let pairs: Vec<_> = found.iter().map(|p| p.values.clone()).collect();
    assert_eq!(
        pairs,
        [[0.1, 0.2], [0.1, 0.3], [0.2, 0.3]].map(|p| p.map(Value::from).to_vec())
    );
    assert_eq!(found[1].place, [0.0, 1.0]);
    let message = points(&axes, &["lower > 1".parse().unwrap()], None)
        .unwrap_err()
        .to_string();
    let expected = "when: all 9 points are left out: 9 by \"lower > 1\"; ";
    assert!(message.starts_with(expected), "{message}");
}

#[test]
fn a_condition_that_divides_by_zero_is_refused_with_the_point() {
    let axes = [linear("x", 0.0, 2.0, 1.0), linear("y", 1.0, 2.0, 1.0)];
    let refused = |when: &[&str]| {
        let when: Vec<Condition> = when.iter().map(|text| text.parse().unwrap()).collect();
        points(&axes, &when, None).map_err(|e| e.to_string())
    };
    let message = refused(&["y/x < 3"]).unwrap_err();
    let expected = "when[0]: a side of \"y/x < 3\" is inf at x = 0, y = 1: it divides by 0";
    assert!(message.starts_with(expected), "{message}");
    // A condition before it may leave such points out
    assert_eq!(refused(&["x > 0", "y/x < 3"]).unwrap().len(), 4);
}

#[test]
fn a_thousand_million_runs_are_refused_with_their_number() {
    let axes = vec![linear("x", 1.0, 1000.0, 1.0); 3];
    let message = combinations(&axes, None, &|| None).unwrap_err().to_string();
    assert!(message.starts_with("axes: 1000000000 runs"), "{message}");
    let axes = vec![linear("x", 1.0, 1000.0, 1.0); 100];
    let message = combinations(&axes, None, &|| None).unwrap_err().to_string();
    let expected = "axes: more than 1000000000000 runs; accepted: ";
    assert!(message.starts_with(expected), "{message}");
    assert!(points(&vec![linear("x", 1.0, 400.0, 1.0); 2], &[], None).is_err());
}

#[test]
fn draws_are_the_same_everywhere_and_fill_every_part() {
    let range = |key: &str| {
        axis(
            json!({ "key": key, "linear": { "from": -1, "to": 1 } }),
            true,
        )
        .unwrap()
    };
    let axes = [range("x"), range("y")];
    let draw = DrawSpec { count: 20, seed: 3 };
    let cube = points(&axes, &[], Some(SampleSpec::LatinHypercube(draw))).unwrap();
    for i in 0..2 {
        let mut parts: Vec<usize> = cube
            .iter()
            .map(|p| (10.0 * (p.values[i].as_f64().unwrap() + 1.0)) as usize)
            .collect();
        parts.sort_unstable();
        assert_eq!(parts, (0..20).collect::<Vec<_>>());
    }
    let when = ["x < y".parse().unwrap()];
    let found = points(&axes, &when, Some(SampleSpec::Random(draw))).unwrap();
    assert_eq!(found.len(), 20);
    assert!(
        found
            .iter()
            .all(|p| p.values[0].as_f64() < p.values[1].as_f64())
    );
    assert_eq!(
        points(&axes, &when, Some(SampleSpec::Random(draw))).unwrap(),
        found
    );
    for (count, start) in [(0, "found 0"), (1_000_000_000, "1000000000 runs")] {
        let sample = SampleSpec::Random(DrawSpec { count, seed: 0 });
        let message = combinations(&axes, Some(sample), &|| None)
            .unwrap_err()
            .to_string();
        let expected = format!("sample.random.count: {start}");
        assert!(message.starts_with(&expected), "{message}");
    }
    let none = points(
        &axes,
        &["x > 2".parse().unwrap()],
        Some(SampleSpec::Random(draw)),
    );
    let message = none.unwrap_err().to_string();
    let expected = "when: 20000 draws gave 0 of 20 points; left out: 20000 by \"x > 2\"; ";
    assert!(message.starts_with(expected), "{message}");
}
