use super::plots::outline;
use super::run::{columns, flatten};
use super::*;
use std::collections::BTreeMap;
use tomolith_core::grid::VolumeGrid;

fn run(name: &str, iou: f64, memory: &str) -> ComparedRun {
    let mut flat = BTreeMap::new();
    let job: Value = toml::from_str(&format!(
        "[optimizer.lbfgs]\nmemory = {memory}\n[[light]]\npixels = [3, 4]"
    ))
    .unwrap();
    flatten("", &job, &mut flat);
    ComparedRun {
        name: name.to_owned(),
        report: json!({
            "schema": "tomolith.report/1", "part": "gear <b>",
            "evaluation": {
                "iou": iou, "ver": 0.1, "surface_mean_mm": 0.012,
                "iou_curve": [[0.0, 0.2], [0.5, iou], [1.0, 0.0]],
                "histogram": { "range": [0.0, 1.0], "part": [0, 1, 9], "void": [8, 2, 0] },
            },
            "lights": [{ "budget": { "time_s": null, "light_used": 0.2 } }],
            "time": [{ "best_jaccard": iou, "best_s": 40.0, "window_s": [39.5, 41.0] }],
            "history": { "loss": 0.5, "iterations": 2 },
        }),
        job: flat,
        dose: None,
        history: columns(
            "iteration,loss,forward_calls,adjoint_calls,seconds,iou\n0,4,1,0,0.1,\n1,2,2,1,0.2,0.8\n2,0.5,4,2,0.4,\n",
        ),
    }
}

#[test]
fn doses_lie_beside_each_other_and_their_differences_below() {
    let mut runs = [run("rays", 0.99, "10"), run("waves", 0.9, "10")];
    assert!(!compare_html(&runs).contains("<h2>Doses"));
    let of =
        |shape: [usize; 3], value: f32| Volume::filled(VolumeGrid::centered(shape, 0.1), value);
    runs[0].dose = Some(of([3, 4, 5], 0.5));
    runs[1].dose = Some(of([3, 4, 5], 1.0));
    let figures = |runs: &[ComparedRun]| compare_html(runs).matches("<figure>").count();
    // Two planes of two doses and one difference
    assert_eq!(figures(&runs), 6);
    assert!(compare_html(&runs).contains("<figcaption>waves, less rays</figcaption>"));
    assert!(compare_html(&runs).contains("Below, where the dose of waves is higher"));
    // No difference of other voxels, and none is announced
    runs[1].dose = Some(of([3, 4, 6], 1.0));
    assert_eq!(figures(&runs), 4);
    let page = compare_html(&runs);
    assert!(!page.contains("Below, what"), "{page}");
    assert!(
        page.contains("No difference is drawn for waves: its voxels differ from those of rays.")
    );
}

#[test]
fn nothing_is_best_of_a_run_that_prints_nothing() {
    let mut runs = [run("rays", 0.99, "10"), run("dark", 0.99, "10")];
    runs[1].report["lights"][0]["budget"]["light_used"] = 0.9.into();
    let best = |runs: &[ComparedRun]| compare_html(runs).contains("<td class=\"head\">0.9</td>");
    assert!(best(&runs));
    runs[1].report["evaluation"]["part"] = json!({ "max": 0.0 });
    assert!(!best(&runs));
    assert!(compare_html(&runs).contains("Nothing of the part turns solid in dark"));
}

#[test]
fn the_page_names_the_model_that_judged() {
    let mut runs = [run("rays", 0.99, "10"), run("waves", 0.9, "10")];
    runs[1].report["run"] = json!({ "models": { "evaluation": "wave (4 depths): as asked" } });
    let page = compare_html(&runs);
    assert_eq!(page.matches(", evaluated by").count(), 1);
    assert!(page.contains("waves<br><span class=\"muted\">optimization, evaluated by wave</span>"));
    // What one model says is no better than what another says
    assert!(page.contains("the best is not marked") && !page.contains("<td class=\"head\">"));
    let alone = "2 species by 2 lights, each alone: parallel (distance-driven kernel)";
    runs[1].report["run"]["models"]["evaluation"] = alone.into();
    assert!(compare_html(&runs).contains("evaluated by parallel"));
}

#[test]
fn simulations_are_told_from_optimizations() {
    let mut runs = [run("made", 0.99, "10"), run("given", 0.9, "10")];
    runs[1].report["history"] = Value::Null;
    assert_eq!(
        compare_json(&runs)["kinds"],
        json!(["optimization", "simulation"])
    );
    let page = compare_html(&runs);
    for (name, kind) in [("made", "optimization"), ("given", "simulation")] {
        let head = format!("{name}<br><span class=\"muted\">{kind}</span>");
        assert!(page.contains(&head), "{page}");
    }
}

#[test]
fn scenarios_have_rows_in_runs_that_have_them() {
    let mut runs = [run("a", 0.9, "10"), run("b", 0.95, "5"), run("c", 0.9, "5")];
    assert!(!compare_html(&runs).contains("scenario"));
    let row = |name: &str, iou: f64| json!({ "name": name, "iou_at_threshold": iou });
    runs[0].report["scenarios"] = json!({
        "worst_iou": 0.91, "window": -0.02, "rows": [row("the job", 0.99), row("Wide vial", 0.91)]
    });
    runs[1].report["scenarios"] = json!({
        "worst_iou": 0.93, "window": -0.03, "rows": [row("the job", 0.98), row("pale", 0.93)]
    });
    let json = compare_json(&runs);
    let of = |key: &str| {
        let rows = json["numbers"].as_array().unwrap();
        rows.iter().find(|row| row["key"] == key).unwrap()["values"].clone()
    };
    assert_eq!(of("worst_iou"), json!([0.91, 0.93, null]));
    assert_eq!(of("scenarios_pw"), json!([-0.02, -0.03, null]));
    assert_eq!(of("iou_in_wide_vial"), json!([0.91, null, null]));
    assert_eq!(of("iou_in_pale"), json!([null, 0.93, null]));
    assert!(compare_html(&runs).contains("IoU in Wide vial, at the job"));
}

#[test]
fn numbers_stand_side_by_side_and_the_best_is_marked() {
    let runs = [run("a", 0.9, "10"), run("b", 0.95, "5")];
    let json = compare_json(&runs);
    let row = |name: &str| {
        let rows = json["numbers"].as_array().unwrap();
        rows.iter().find(|row| row["name"] == name).unwrap()["values"].clone()
    };
    assert_eq!(
        row("How long the print in time stays within 0.01 of its best IoU"),
        json!([1.5, 1.5])
    );
    assert_eq!(row("Model calls"), json!([6.0, 6.0]));
    let keys = json["numbers"].as_array().unwrap().iter();
    let keys: Vec<&str> = keys.map(|row| row["key"].as_str().unwrap()).collect();
    assert!(
        keys.contains(&"iou") && keys.contains(&"optimization_s"),
        "{keys:?}"
    );
    let is_snake = |key: &&str| {
        key.chars()
            .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
    };
    assert!(keys.iter().all(is_snake), "{keys:?}");
    assert_eq!(row("Time of the optimization"), json!([0.4, 0.4]));
    assert_eq!(
        json["differing_keys"],
        json!([{ "key": "optimizer.lbfgs.memory", "values": ["10", "5"] }])
    );
    let page = compare_html(&runs);
    assert!(
        page.contains("<td>0.9</td><td class=\"head\">0.95</td>")
            || page.contains("<td class=\"head\">0.9500</td>"),
        "{page}"
    );
    assert!(page.contains("gear &lt;b&gt;") && !page.contains("gear <b>"));
    assert_eq!(page.matches("<svg class=\"plot\"").count(), 6);
    for tag in ["section", "svg", "table", "div"] {
        assert_eq!(
            page.matches(&format!("<{tag}")).count(),
            page.matches(&format!("</{tag}>")).count(),
            "{tag}"
        );
    }
    for bad in ["NaN", "inf\"", "http:", "https:", "<script"] {
        assert!(!page.contains(bad), "{bad}");
    }
}

#[test]
fn outlines_have_area_one() {
    let outline = outline(
        &json!({ "range": [0.5, 2.5], "part": [1, 0, 3, 4] }),
        "part",
    );
    let area: f64 = outline
        .chunks(2)
        .map(|step| (step[1][0] - step[0][0]) * step[0][1])
        .sum();
    assert!((area - 1.0).abs() < 1e-12, "{outline:?}");
    assert_eq!((outline[0], outline[7][0]), ([0.5, 0.25], 2.5));
}

#[test]
fn runs_without_history_or_curves_still_make_a_page() {
    let mut bare = run("bare", 0.5, "1");
    bare.history.clear();
    bare.report["evaluation"] = json!({ "iou": 0.5 });
    let page = compare_html(&[bare]);
    assert!(page.contains("No run holds these numbers.") && page.contains("hold no curves"));
}

#[test]
fn folders_that_are_no_runs_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let empty = read_runs(&[folder.path()]).unwrap_err().to_string();
    assert!(empty.contains("no report.json in it"), "{empty}");
    std::fs::write(folder.path().join("report.json"), "{\"schema\": \"other\"}").unwrap();
    assert!(matches!(
        read_runs(&[folder.path()]),
        Err(Error::Format { .. })
    ));
    assert!(matches!(
        read_runs(&[] as &[&Path]),
        Err(Error::Config { .. })
    ));
}
