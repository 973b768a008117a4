//! Numbers of `report.json` by their key paths, as in `evaluation.pw` and `limits[0].loss_in_iou`.

use serde_json::Value;
use tomolith::error::nearest_name;
use tomolith::metrics::METRICS;
use tomolith::{Error, Result};

/// Tables of a report, and numbers of an evaluation beside its metrics.
const TABLES: [&str; 17] = [
    "evaluation",
    "optimization",
    "exposure",
    "limits",
    "published",
    "lights",
    "species",
    "one_exposure",
    "time",
    "properties",
    "history",
    "levels",
    "scenarios",
    "process_window",
    "movies",
    "run",
    "part",
];
const MORE: [&str; 3] = ["gel_threshold", "band_half_width", "sub_angles"];

/// Refuses, before any run, what no report has; `key` is where it is asked for.
///
/// # Errors
/// [`Error::Config`] with the nearest name.
pub(crate) fn must_exist(path: &str, key: &str) -> Result<()> {
    let steps: Vec<&str> = path.split(['.', '[']).collect();
    if !TABLES.contains(&steps[0]) {
        return Err(unknown(path, key, steps[0], TABLES.iter().copied(), ""));
    }
    if ["evaluation", "optimization"].contains(&steps[0]) && steps.len() == 2 {
        let names = || METRICS.iter().map(|metric| metric.name).chain(MORE);
        if !names().any(|name| name == steps[1]) {
            return Err(unknown(
                path,
                key,
                steps[1],
                names(),
                &format!("{}.", steps[0]),
            ));
        }
    }
    Ok(())
}

fn unknown<'a>(
    path: &str,
    key: &str,
    word: &str,
    names: impl Iterator<Item = &'a str> + Clone,
    table: &str,
) -> Error {
    let all = names.clone().collect::<Vec<_>>().join(", ");
    Error::Config {
        key: key.to_owned(),
        found: format!("`{path}` is in no report.json"),
        accepted: match table {
            "" => format!("a path that begins with one of {all}"),
            table => format!("{table} with one of {all}"),
        },
        nearest: nearest_name(word, names).map(|name| format!("{table}{name}")),
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
            "published": { "bclp.pw": 1, "ver": { "value": 0.125, "unit": "" } },
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
        ] {
            assert_eq!(number(&report, path), found, "{path}");
        }
        assert!(
            number(&report, "evaluation.p")
                .unwrap_err()
                .contains("there is no `p`")
        );
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
    }
}
