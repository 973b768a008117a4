//! Every number of a run that can be compared, as a row of a table.

use super::run::ComparedRun;
use Better::{Higher, Lower, Neutral};
use tomolith_metrics::{Better, METRICS};

/// Reads a number of a run, where it has one.
pub(super) type ValueOf = Box<dyn Fn(&ComparedRun) -> Option<f64>>;

pub(super) struct Row {
    /// What programs call it, the same in every version.
    pub(super) key: String,
    pub(super) name: String,
    pub(super) unit: &'static str,
    pub(super) better: Better,
    pub(super) value: ValueOf,
}

/// A number of each light.
fn of_lights<'a>(run: &'a ComparedRun, name: &'a str) -> impl Iterator<Item = f64> + 'a {
    (0..).map_while(move |i| run.number(&format!("/lights/{i}/{name}")))
}

/// Every number that the page lists.
pub(super) fn rows(runs: &[ComparedRun]) -> Vec<Row> {
    let mut rows: Vec<Row> = METRICS
        .iter()
        .map(|kind| {
            let place = format!("/evaluation/{}", kind.name);
            at(&place, kind.title, kind.unit, kind.better)
        })
        .collect();
    rows.extend([
        Row {
            key: "evaluation_pitch_mm".to_owned(),
            ..at(
                "/evaluation/grid/pitch_mm",
                "Edge of the evaluation's voxels",
                "mm",
                Neutral,
            )
        },
        at("/history/loss", "Loss, at the end", "", Neutral),
        at("/history/iterations", "Iterations", "", Neutral),
        Row {
            key: "model_calls".to_owned(),
            name: "Model calls".to_owned(),
            unit: "",
            better: Lower,
            value: Box::new(|run| {
                run.calls(run.history.get("forward_calls")?.len().checked_sub(1)?)
            }),
        },
        Row {
            key: "optimization_s".to_owned(),
            name: "Time of the optimization".to_owned(),
            unit: "s",
            better: Lower,
            value: Box::new(|run| {
                let seconds = run.history.get("seconds")?.iter().rev();
                let searched = run.number("/run/timings_s/optimizing: ceiling of the pixels");
                let of_loop = seconds.copied().find(|v| v.is_finite())?;
                Some(of_loop + searched.unwrap_or(0.0))
            }),
        },
        at("/time_to_print_s", "Time to print", "s", Lower),
        Row {
            key: "energy_per_turn_mj".to_owned(),
            name: "Energy per turn, of all lights".to_owned(),
            unit: "mJ",
            better: Neutral,
            value: Box::new(|run| {
                let lights = of_lights(run, "budget/energy_per_turn_mj");
                lights.reduce(|sum, of_light| sum + of_light)
            }),
        },
        Row {
            key: "light_used".to_owned(),
            name: "Share of the light that is used, of one light".to_owned(),
            unit: "",
            better: Higher,
            value: Box::new(|run| {
                let mut lights = of_lights(run, "budget/light_used");
                lights.next().filter(|_| lights.next().is_none())
            }),
        },
        at(
            "/time/0/best_jaccard",
            "IoU of the print in time, at its best",
            "",
            Higher,
        ),
        at(
            "/time/0/best_s",
            "The best moment of the print in time",
            "s",
            Neutral,
        ),
        Row {
            key: "window_s".to_owned(),
            name: "How long the print in time stays within 0.01 of its best IoU".to_owned(),
            unit: "s",
            better: Higher,
            value: Box::new(|run| {
                let end = |i: usize| run.number(&format!("/time/0/window_s/{i}"));
                Some(end(1)? - end(0)?)
            }),
        },
        at(
            "/scenarios/worst_iou",
            "The least IoU over scenarios, at the job's threshold",
            "",
            Higher,
        ),
        Row {
            key: "scenarios_pw".to_owned(),
            ..at(
                "/scenarios/window",
                "Window over scenarios, trimmed",
                "",
                Higher,
            )
        },
    ]);
    rows.extend(scenarios(runs).into_iter().map(of_scenario));
    rows
}

/// A number of the report, by the last part of its place.
fn at(place: &str, name: &str, unit: &'static str, better: Better) -> Row {
    let place = place.to_owned();
    Row {
        key: place.rsplit('/').next().unwrap_or_default().to_owned(),
        name: name.to_owned(),
        unit,
        better,
        value: Box::new(move |run| run.number(&place)),
    }
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
    let word = name.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
    Row {
        key: format!("iou_in_{}", word.to_ascii_lowercase()),
        name: format!("IoU in {name}, at the job's threshold"),
        unit: "",
        better: Higher,
        value: Box::new(move |run| {
            let rows = run.report.pointer("/scenarios/rows")?.as_array()?;
            rows.iter().find(|row| row["name"] == name)?["iou_at_threshold"].as_f64()
        }),
    }
}
