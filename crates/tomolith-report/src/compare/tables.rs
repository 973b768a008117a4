//! Keys that differ, and why numbers may not be comparable.

use super::rows::rows;
use super::run::ComparedRun;
use crate::number::{escape, significant};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Why numbers of runs may not be comparable.
pub(super) fn warnings(runs: &[ComparedRun]) -> Vec<String> {
    let differ = |what: &dyn Fn(&ComparedRun) -> String| {
        runs.iter().map(what).collect::<BTreeSet<_>>().len() > 1
    };
    let mut warnings = Vec::new();
    if differ(&|run| run.report["part"].to_string()) {
        warnings.push("The runs print parts of different names.".to_owned());
    }
    if differ(&|run| run.report["evaluation"]["grid"].to_string()) {
        warnings.push("The runs were evaluated on different voxels: distances and error rates depend on them.".to_owned());
    }
    for run in runs.iter().filter(|run| !prints(run)) {
        warnings.push(format!(
            "Nothing of the part turns solid in {}: none of its numbers is marked as the best.",
            run.name
        ));
    }
    if differ(&|run| run.job.get("objective").cloned().unwrap_or_default() + &objective(run)) {
        warnings.push(
            "The runs minimize different losses, whose numbers cannot be compared.".to_owned(),
        );
    }
    let mut curves = runs
        .iter()
        .map(|run| &run.report["evaluation"]["iou_curve"]);
    if curves.any(Value::is_null) {
        warnings.push("Reports of earlier versions hold no curves: run `tomolith simulate` on their patterns to get them.".to_owned());
    }
    warnings
}

/// The keys of a run that say what is minimized.
fn objective(run: &ComparedRun) -> String {
    let keys = run
        .job
        .iter()
        .filter(|(key, _)| key.starts_with("objective"));
    keys.map(|(key, value)| format!("{key}={value};")).collect()
}

/// Name of the model that gave the dose that a run is evaluated by.
pub(super) fn evaluation_model_of(run: &ComparedRun) -> Option<&str> {
    let model = run.report.pointer("/run/models/evaluation");
    let model = model.and_then(Value::as_str)?;
    // "2 species by 2 lights, each alone: parallel (…"
    let model = model.rsplit("each alone: ").next()?;
    model.split([' ', ',', ':']).next()
}

/// Whether some of the part turns solid in a run; true for gray targets, which have no IoU, and for earlier reports.
pub(super) fn prints(run: &ComparedRun) -> bool {
    run.number("/evaluation/iou") != Some(0.0) && run.number("/evaluation/part/max") != Some(0.0)
}

/// Whether one model evaluated all runs: what it says of a print is no better than what another one says.
pub(super) fn is_fair(runs: &[ComparedRun]) -> bool {
    (runs.windows(2)).all(|pair| evaluation_model_of(&pair[0]) == evaluation_model_of(&pair[1]))
}

/// All numbers as a table, for readers without a script.
pub(super) fn plain(runs: &[ComparedRun]) -> String {
    let heads: String = (runs.iter())
        .map(|run| format!("<th>{}</th>", escape(&run.name)))
        .collect();
    let mut out = format!("<table><tr><th></th>{heads}</tr>");
    for row in rows(runs) {
        let cell = |run: &ComparedRun| {
            let value = (row.value)(run);
            let text = value.map_or("–".to_owned(), |value| significant(value, 4));
            format!("<td>{text}</td>")
        };
        let cells: String = runs.iter().map(cell).collect();
        // Writing into a string cannot fail
        let _ = write!(
            out,
            "<tr><td>{} {}</td>{cells}</tr>",
            escape(&row.name),
            row.unit
        );
    }
    out + "</table>"
}

/// Keys of the jobs that are not the same in all runs, with their values.
pub(super) fn differing(runs: &[ComparedRun]) -> Vec<(String, Vec<Option<String>>)> {
    let keys: BTreeSet<&String> = runs.iter().flat_map(|run| run.job.keys()).collect();
    keys.into_iter()
        .map(|key| {
            (
                key.clone(),
                runs.iter()
                    .map(|run| run.job.get(key).cloned())
                    .collect::<Vec<_>>(),
            )
        })
        .filter(|(_, values)| values.iter().any(|value| *value != values[0]))
        .collect()
}
