//! Numbers of `report.json` by their key paths, as in `evaluation.pw` and `limits[0].loss_in_iou`; of a list, `[min]`, `[max]` and `[mean]` take
//! one number of all entries that have it, as in `published.slices[max].pw`.

use serde_json::Value;
use tomolith::error::nearest_name;
use tomolith::metrics::METRICS;
use tomolith::{Error, Result};

/// The number that stands in no table.
const TIME_TO_PRINT: &str = "time_to_print_s";

/// The names in a table of a report, `""` for the whole, where every report has the same ones there or none; indices are `[]`. Lists have no names.
const TABLES: [(&str, &str); 10] = [
    (
        "",
        "evaluation optimization exposure limits published lights species one_exposure time properties history levels scenarios \
         process_window response movies run part ceiling objective_window one_moment time_to_print_s",
    ),
    (
        "exposure",
        "measure best tolerance threshold dose percent time_s reported_percent",
    ),
    (
        "history",
        "iterations loss projected_gradient forward_calls adjoint_calls kept lower_bound gap",
    ),
    (
        "levels",
        "rounded_loss diffused_loss loss scale steps calls",
    ),
    ("optimization.objectives", ""),
    (
        "optimization.objectives[]",
        "key weight loss voxels rms_error max_error",
    ),
    (
        "process_window",
        "outliers thresholds part_above part_below void_below window range ipdr",
    ),
    ("published.slices", ""),
    (
        "published.slices[]",
        "z_mm part void pw ipdr ver pw_trimmed ipdr_trimmed",
    ),
    ("scenarios", "of threshold rows window worst_iou"),
];

/// What stands in a table of a report, as in [`TABLES`].
fn names(table: &str, is_end: bool) -> Option<Vec<&'static str>> {
    match table {
        // They hold tables, too, in which a path does not end
        "evaluation" | "optimization" if is_end => {
            let more = ["gel_threshold", "band_half_width", "sub_angles"];
            Some(METRICS.iter().map(|m| m.name).chain(more).collect())
        }
        "evaluation.errors" | "optimization.errors" => {
            Some(vec!["band_edge_peak", "range", "band", "part", "void"])
        }
        _ => {
            let (_, names) = TABLES.iter().find(|(name, _)| *name == table)?;
            Some(names.split_whitespace().collect())
        }
    }
}

/// Refuses, before any run, a metric that no report has; `key` is the key that names it.
pub(crate) fn must_exist(path: &str, key: &str) -> Result<()> {
    must_be_closed(path, key)?;
    let steps: Vec<&str> = path.split(['.', '[']).collect();
    let mut table = String::new();
    for (i, step) in steps.iter().enumerate() {
        if step.ends_with(']') {
            table.push_str("[]");
            continue;
        }
        let names = names(&table, i + 1 == steps.len());
        if let Some(names) = names.filter(|names| !names.contains(step)) {
            return Err(unknown(path, key, step, &names, &table));
        }
        let dot = if table.is_empty() { "" } else { "." };
        table = format!("{table}{dot}{step}");
    }
    let is_table = steps.len() == 1 && path != TIME_TO_PRINT;
    if is_table || names(&table, true).is_some() {
        let found = format!("`{path}` is a whole table of report.json");
        let accepted = "a number in it, such as evaluation.iou";
        return Err(Error::config(key, found, accepted));
    }
    Ok(())
}

/// Refuses brackets that hold neither an index nor what is taken of a list.
fn must_be_closed(path: &str, key: &str) -> Result<()> {
    for part in path.split('[').skip(1) {
        let word = part.split_once(']').map(|(word, _)| word);
        if word.is_none_or(|word| word.parse::<usize>().is_err() && take(word).is_none()) {
            let found = format!("`{path}`: `[{part}`");
            return Err(Error::config(
                key,
                found,
                "an index from 0, [min], [max] or [mean]",
            ));
        }
    }
    Ok(())
}

fn unknown(path: &str, key: &str, word: &str, names: &[&str], table: &str) -> Error {
    let (all, table) = (names.join(", "), table.replace("[]", "[…]"));
    let accepted = match (table.as_str(), names) {
        ("", _) => format!("a path that begins with one of {all}"),
        (table, []) => format!("{table} with an index from 0, [min], [max] or [mean]"),
        (table, _) => format!("{table}. with one of {all}"),
    };
    let dot = if table.is_empty() { "" } else { "." };
    Error::Config {
        key: key.to_owned(),
        found: format!("`{path}` is in no report.json"),
        accepted,
        nearest: nearest_name(word, names.iter().copied())
            .map(|name| format!("{table}{dot}{name}")),
        place: None,
    }
}

/// The number at a path; none where it is not defined.
///
/// # Errors
/// What stands there instead, when that is no number.
pub(crate) fn number(report: &Value, path: &str) -> Result<Option<f64>, String> {
    let mut at = report;
    let mut rest = path;
    while !rest.is_empty() && !at.is_null() {
        // Some names of published numbers have dots
        let whole = at.get(rest).map(|_| (rest, ""));
        let (step, after) = whole
            .or_else(|| rest.split_once(['.', '[']))
            .unwrap_or((rest, ""));
        let step = step.trim_end_matches(']');
        if let (Value::Array(list), Some(take)) = (at, take(step)) {
            let whole = |why: String| why.replace(&format!("`{after}`"), &format!("`{path}`"));
            let numbers = list.iter().map(|entry| number(entry, after).map_err(whole));
            let numbers = numbers.filter_map(Result::transpose);
            let numbers = numbers.collect::<Result<Vec<f64>, _>>();
            return numbers.map(take);
        }
        let inner = match at {
            Value::Array(list) => step
                .parse::<usize>()
                .ok()
                .map(|i| list.get(i).unwrap_or(&Value::Null)),
            other => other.get(step),
        };
        at =
            inner.ok_or_else(|| format!("`{path}` is not in report.json: there is no `{step}`"))?;
        rest = after;
    }
    if let Some(inner) = at.get("value") {
        at = inner;
    }
    match at {
        Value::Null => Ok(None),
        Value::Number(number) => Ok(number.as_f64()),
        Value::Bool(flag) => Ok(Some(f64::from(u8::from(*flag)))),
        other => Err(format!(
            "`{path}` of report.json is no number: {}",
            kind(other)
        )),
    }
}

/// What a word in brackets takes of many numbers.
fn take(word: &str) -> Option<fn(Vec<f64>) -> Option<f64>> {
    Some(match word {
        "min" => |numbers| numbers.into_iter().reduce(f64::min),
        "max" => |numbers| numbers.into_iter().reduce(f64::max),
        "mean" => |numbers| {
            let count = numbers.len() as f64;
            (count > 0.0).then(|| numbers.iter().sum::<f64>() / count)
        },
        _ => return None,
    })
}

fn kind(value: &Value) -> &'static str {
    match value {
        Value::String(_) => "a text",
        Value::Array(_) => "a list",
        _ => "a table",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_by_their_paths() {
        let report = serde_json::json!({
            "evaluation": { "pw": 0.25, "iou": null, "notes": ["a"] },
            "optimization": null,
            "limits": [{ "loss_in_iou": 0.5 }],
            "published": { "slices": [{ "pw": 0.25, "ver": null }, { "pw": null, "ver": null }, { "pw": 0.75, "ver": null }], "bclp.pw": 1, "ver": { "value": 0.125, "unit": "" } },
            "met": true,
        });
        for (path, found) in [
            ("evaluation.pw", Ok(Some(0.25))),
            ("evaluation.iou", Ok(None)),
            ("optimization.iou", Ok(None)),
            ("limits[0].loss_in_iou", Ok(Some(0.5))),
            ("limits[3].loss_in_iou", Ok(None)),
            ("published.ver", Ok(Some(0.125))),
            ("met", Ok(Some(1.0))),
            ("published.slices[min].pw", Ok(Some(0.25))),
            ("published.slices[max].pw", Ok(Some(0.75))),
            ("published.slices[mean].pw", Ok(Some(0.5))),
            ("published.slices[max].ver", Ok(None)),
        ] {
            assert_eq!(number(&report, path), found, "{path}");
        }
        assert!(
            number(&report, "evaluation.p")
                .unwrap_err()
                .contains("there is no `p`")
        );
        let text = number(&report, "published.slices[max]").unwrap_err();
        assert!(text.contains("`published.slices[max]`"), "{text}");
        assert!(
            number(&report, "evaluation.notes")
                .unwrap_err()
                .contains("a list")
        );
    }

    #[test]
    fn a_misspelt_metric_is_refused_with_its_neighbor() {
        must_exist("evaluation.pw", "").unwrap();
        must_exist("evaluation.part.mean", "").unwrap();
        let message = must_exist("evaluation.ipdrr", "metrics[0]")
            .unwrap_err()
            .to_string();
        assert!(
            message.starts_with("metrics[0]: `evaluation.ipdrr` is in no report.json")
                && message.contains("did you mean `evaluation.ipdr`"),
            "{message}"
        );
        let message = must_exist("evaluaton.pw", "best.highest")
            .unwrap_err()
            .to_string();
        assert!(message.contains("did you mean `evaluation`"), "{message}");
        must_exist("scenarios.rows[1].iou", "").unwrap();
        must_exist("published.slices[max].pw", "").unwrap();
        for wrong in [
            "published.slices[maximum].pw",
            "published.slices[max.pw",
            "published.slices[max]",
            "published.slices[max].pww",
            "published.slices.pw",
        ] {
            let message = must_exist(wrong, "metrics[0]").unwrap_err().to_string();
            assert!(message.contains(wrong), "{message}");
        }
        must_exist("optimization.objectives[0].rms_error", "").unwrap();
        for (path, part) in [
            ("history.iteration", "did you mean `history.iterations`"),
            ("scenarios.worst", "scenarios. with one of of, threshold"),
            ("evaluation", "is a whole table"),
            (
                "optimization.objectives[0].rms_eror",
                "did you mean `optimization.objectives[…].rms_error`",
            ),
            (
                "optimization.errors.band_edge_peek",
                "did you mean `optimization.errors.band_edge_peak`",
            ),
        ] {
            let message = must_exist(path, "metrics[0]").unwrap_err().to_string();
            assert!(message.contains(part), "{path}: {message}");
        }
    }

    #[test]
    fn the_names_are_those_that_reports_have() {
        let page = include_str!("../../../docs/report.md");
        let tables = page.split("\n## ").next().unwrap_or_default();
        let keys = tables.lines().filter_map(|line| line.strip_prefix("| `"));
        let keys = keys.filter_map(|line| line.split('`').next());
        let no_numbers = ["schema", "notes", "is_toy"];
        let named: Vec<&str> = keys.filter(|key| !no_numbers.contains(key)).collect();
        assert!(named.len() > 20, "{named:?}");
        for key in named {
            assert!(names("", true).unwrap().contains(&key), "{key}");
        }
        must_exist("time_to_print_s", "metrics[0]").unwrap();
        must_exist("one_moment.seconds", "metrics[0]").unwrap();
        use tomolith::report::latitude::{Bracket, ExposureWindow};
        let percent = Bracket {
            low: None,
            best: Some(100.0),
            high: None,
        };
        let exposure = ExposureWindow {
            measure: "iou",
            best: 1.0,
            tolerance: 0.01,
            threshold: None,
            dose: None,
            percent,
            time_s: None,
            reported_percent: None,
        };
        let objective = tomolith::report::ObjectiveReport {
            key: String::new(),
            weight: 1.0,
            loss: None,
            voxels: 0,
            rms_error: None,
            max_error: None,
        };
        let scenarios = tomolith::report::ScenarioTable::new("mean", None, Vec::new());
        for (table, value) in [
            ("exposure", serde_json::to_value(exposure)),
            ("scenarios", serde_json::to_value(scenarios)),
            ("optimization.objectives[]", serde_json::to_value(objective)),
        ] {
            let (names, value) = (names(table, true).unwrap(), value.unwrap());
            let there: Vec<&String> = value.as_object().unwrap().keys().collect();
            assert_eq!(there.len(), names.len(), "{table}: {there:?}");
            let is_known = |key: &&String| names.contains(&key.as_str());
            assert!(there.iter().all(is_known), "{there:?}");
        }
    }
}
