//! Numbers side by side, keys that differ, and why numbers may not be comparable.

use super::class;
use super::rows::rows;
use super::run::ComparedRun;
use crate::number::{escape, significant};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use tomolith_metrics::Better;

/// Why numbers of runs may not be comparable.
pub(super) fn warnings(runs: &[ComparedRun]) -> String {
    let differ = |what: &dyn Fn(&ComparedRun) -> String| {
        runs.iter().map(what).collect::<BTreeSet<_>>().len() > 1
    };
    let mut said = Vec::new();
    if differ(&|run| run.report["part"].to_string()) {
        said.push("The runs print parts of different names.".to_owned());
    }
    if differ(&|run| run.report["evaluation"]["grid"].to_string()) {
        said.push("The runs were evaluated on different voxels: distances and error rates depend on them.".to_owned());
    }
    for run in runs.iter().filter(|run| !prints(run)) {
        said.push(format!(
            "Nothing of the part turns solid in {}: none of its numbers is marked as the best.",
            escape(&run.name)
        ));
    }
    if differ(&|run| run.job.get("objective").cloned().unwrap_or_default() + &objective(run)) {
        said.push(
            "The runs minimize different losses, whose numbers cannot be compared.".to_owned(),
        );
    }
    if runs
        .iter()
        .any(|run| run.report["evaluation"]["iou_curve"].is_null())
    {
        said.push("Reports of earlier versions hold no curves: run `tomolith simulate` on their patterns to get them.".to_owned());
    }
    if said.is_empty() {
        return String::new();
    }
    let items: String = said.iter().map(|text| format!("<li>{text}</li>")).collect();
    format!("<section class=\"warn\"><h2>Please note</h2><ul>{items}</ul></section>")
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
fn evaluation_model_of(run: &ComparedRun) -> Option<&str> {
    let model = run.report.pointer("/run/models/evaluation");
    let model = model.and_then(Value::as_str)?;
    // "2 species by 2 lights, each alone: parallel (…"
    let model = model.rsplit("each alone: ").next()?;
    model.split([' ', ',', ':']).next()
}

/// What a run is and who judged it, under its name.
fn origin(run: &ComparedRun) -> String {
    let judged_by = evaluation_model_of(run).map_or_else(String::new, |name| {
        format!(", evaluated by {}", escape(name))
    });
    format!("<br><span class=\"muted\">{}{judged_by}</span>", run.kind())
}

/// Whether some of the part turns solid in a run; of gray targets, which have no IoU, and earlier reports it is not asked.
fn prints(run: &ComparedRun) -> bool {
    run.number("/evaluation/iou") != Some(0.0) && run.number("/evaluation/part/max") != Some(0.0)
}

pub(super) fn numbers(runs: &[ComparedRun]) -> String {
    let heads: String = runs
        .iter()
        .enumerate()
        .map(|(i, run)| {
            format!(
                "<th><i class=\"dot c-{}\"></i>{}{}</th>",
                class(i),
                escape(&run.name),
                origin(run)
            )
        })
        .collect();
    let mut body = String::new();
    let prints: Vec<bool> = runs.iter().map(prints).collect();
    // What one model says of a print is no better than what another says
    let is_fair = (runs.windows(2))
        .all(|pair| evaluation_model_of(&pair[0]) == evaluation_model_of(&pair[1]));
    for row in rows(runs) {
        let values: Vec<Option<f64>> = runs.iter().map(|run| (row.value)(run)).collect();
        // Nothing is good of a print that is not there
        let of_prints = values.iter().zip(&prints).filter(|(_, prints)| **prints);
        let known = of_prints.filter_map(|(value, _)| *value);
        let best = match row.better {
            _ if runs.len() < 2 || !is_fair => None,
            Better::Higher => known.reduce(f64::max),
            Better::Lower => known.reduce(f64::min),
            Better::Neutral => None,
        };
        if values.iter().all(Option::is_none) {
            continue;
        }
        let (factor, unit) = if row.unit == "mm" {
            (1e3, "µm")
        } else {
            (1.0, row.unit)
        };
        let unit = if unit == "response" { "" } else { unit };
        let arrow = match row.better {
            Better::Higher => " ↑",
            Better::Lower => " ↓",
            Better::Neutral => "",
        };
        let _ = write!(
            body,
            "<tr><td>{}{arrow} <span class=\"unit\">{unit}</span></td>",
            escape(&row.name)
        );
        for (value, prints) in values.into_iter().zip(&prints) {
            let text = value.map_or("–".to_owned(), |value| significant(value * factor, 4));
            let class = if *prints && best.is_some() && value == best {
                " class=\"head\""
            } else {
                ""
            };
            let _ = write!(body, "<td{class}>{text}</td>");
        }
        body.push_str("</tr>");
    }
    let best = if is_fair {
        "the best is bold."
    } else {
        "the best is not marked, because the runs were evaluated by different models: compare only columns with the same one."
    };
    format!(
        "<section><h2>Numbers</h2><p class=\"muted\">Written patterns, vial turning, on the voxels of each evaluation. ↑ larger is better, ↓ smaller is better; \
         {best}</p><div class=\"scroll\"><table><thead><tr><th></th>{heads}</tr></thead><tbody>{body}</tbody></table></div></section>"
    )
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

pub(super) fn keys(runs: &[ComparedRun]) -> String {
    let differing = differing(runs);
    if differing.is_empty() {
        return "<section><h2>What differs in the jobs</h2><p class=\"muted\">Nothing.</p></section>".to_owned();
    }
    let heads: String = runs
        .iter()
        .map(|run| format!("<th>{}</th>", escape(&run.name)))
        .collect();
    let body: String = differing
        .iter()
        .map(|(key, values)| {
            let cells: String = values
                .iter()
                .map(|value| {
                    format!(
                        "<td>{}</td>",
                        value.as_ref().map_or("–".to_owned(), |value| escape(value))
                    )
                })
                .collect();
            format!("<tr><td>{}</td>{cells}</tr>", escape(key))
        })
        .collect();
    format!(
        "<section><h2>What differs in the jobs</h2><div class=\"scroll\"><table class=\"keys\"><thead><tr><th></th>{heads}</tr></thead>\
         <tbody>{body}</tbody></table></div></section>"
    )
}
