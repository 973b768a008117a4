//! Every number of a run that can be compared, as a row of a table.

use super::run::ComparedRun;
use tomolith_metrics::{Better, METRICS};

/// Reads a number of a run, where it has one.
pub(super) type ValueOf = Box<dyn Fn(&ComparedRun) -> Option<f64>>;

/// A row of numbers.
pub(super) struct Row {
    /// What programs call it, the same in every version.
    pub(super) key: String,
    pub(super) name: String,
    pub(super) unit: &'static str,
    pub(super) better: Better,
    pub(super) value: ValueOf,
}

/// Every number that the page lists.
pub(super) fn rows(runs: &[ComparedRun]) -> Vec<Row> {
    let mut rows: Vec<Row> = METRICS
        .iter()
        .map(|kind| {
            let place = format!("/evaluation/{}", kind.name);
            Row {
                key: kind.name.to_owned(),
                name: kind.title.to_owned(),
                unit: kind.unit,
                better: kind.better,
                value: Box::new(move |run| run.number(&place)),
            }
        })
        .collect();
    rows.push(pointer(
        "evaluation_pitch_mm",
        "Edge of the evaluation's voxels",
        "mm",
        Better::Neutral,
        "/evaluation/grid/pitch_mm",
    ));
    rows.extend(of_optimization());
    rows.extend(of_print());
    rows.extend(scenarios(runs).into_iter().map(of_scenario));
    rows
}

/// A number of the report.
fn pointer(
    key: &str,
    name: &str,
    unit: &'static str,
    better: Better,
    pointer: &'static str,
) -> Row {
    Row {
        key: key.to_owned(),
        name: name.to_owned(),
        unit,
        better,
        value: Box::new(move |run| run.number(pointer)),
    }
}

fn of_optimization() -> [Row; 4] {
    [
        pointer(
            "loss",
            "Loss, at the end",
            "",
            Better::Neutral,
            "/history/loss",
        ),
        pointer(
            "iterations",
            "Iterations",
            "",
            Better::Neutral,
            "/history/iterations",
        ),
        Row {
            key: "model_calls".to_owned(),
            name: "Model calls".to_owned(),
            unit: "",
            better: Better::Lower,
            value: Box::new(|run| {
                run.calls(run.history.get("forward_calls")?.len().checked_sub(1)?)
            }),
        },
        Row {
            key: "optimization_s".to_owned(),
            name: "Time of the optimization".to_owned(),
            unit: "s",
            better: Better::Lower,
            value: Box::new(|run| {
                let seconds = run.history.get("seconds")?.iter().rev();
                seconds.copied().find(|v| v.is_finite())
            }),
        },
    ]
}

fn of_print() -> [Row; 8] {
    [
        pointer(
            "time_to_print_s",
            "Time to print",
            "s",
            Better::Lower,
            "/time_to_print_s",
        ),
        pointer(
            "energy_per_turn_mj",
            "Energy per turn",
            "mJ",
            Better::Neutral,
            "/lights/0/budget/energy_per_turn_mj",
        ),
        pointer(
            "light_used",
            "Share of the light that is used",
            "",
            Better::Higher,
            "/lights/0/budget/light_used",
        ),
        pointer(
            "best_jaccard",
            "IoU of the print in time, at its best",
            "",
            Better::Higher,
            "/time/0/best_jaccard",
        ),
        pointer(
            "best_s",
            "The best moment of the print in time",
            "s",
            Better::Neutral,
            "/time/0/best_s",
        ),
        Row {
            key: "window_s".to_owned(),
            name: "How long the print in time stays within 0.01 of its best IoU".to_owned(),
            unit: "s",
            better: Better::Higher,
            value: Box::new(|run| {
                let end = |i: usize| run.number(&format!("/time/0/window_s/{i}"));
                Some(end(1)? - end(0)?)
            }),
        },
        pointer(
            "worst_iou",
            "The least IoU over scenarios, at the job's threshold",
            "",
            Better::Higher,
            "/scenarios/worst_iou",
        ),
        pointer(
            "scenarios_pw",
            "Window over scenarios, trimmed",
            "",
            Better::Higher,
            "/scenarios/window",
        ),
    ]
}

/// The scenarios of all runs, each name once.
pub(super) fn scenarios(runs: &[ComparedRun]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let rows = |run: &ComparedRun| run.report.pointer("/scenarios/rows")?.as_array().cloned();
    for row in runs.iter().filter_map(rows).flatten() {
        let name = row["name"].as_str().unwrap_or_default().to_owned();
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// The IoU of a scenario.
fn of_scenario(name: String) -> Row {
    let word = |c: char| {
        if c.is_ascii_alphanumeric() {
            c.to_ascii_lowercase()
        } else {
            '_'
        }
    };
    Row {
        key: format!("iou_in_{}", name.chars().map(word).collect::<String>()),
        name: format!("IoU in {name}, at the job's threshold"),
        unit: "",
        better: Better::Higher,
        value: Box::new(move |run| {
            let rows = run.report.pointer("/scenarios/rows")?.as_array()?;
            rows.iter().find(|row| row["name"] == name)?["iou_at_threshold"].as_f64()
        }),
    }
}
