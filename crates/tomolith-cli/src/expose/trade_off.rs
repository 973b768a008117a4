//! `tomolith expose RUN --trade-off`: quality against time, and the job of a chosen ceiling.

use super::{ExposeArguments, json_of};
use crate::answer::Answer;
use serde::Serialize;
use serde_json::Value;
use std::io::Write;
use std::path::Path;
use tomolith::io::{read_text, write_whole};
use tomolith::job::{Document, Job};
use tomolith::report::number::significant;
use tomolith::{Error, Result};

/// A ceiling that the run tried, and what it printed on pixels of twice the width: of several prints the worst numbers.
#[derive(Serialize)]
struct Row {
    brightest: f64,
    time_mm: Option<f64>,
    time_s: Option<f64>,
    iou: Option<f64>,
    ver: Option<f64>,
    surface_mean_mm: Option<f64>,
    is_chosen: bool,
    /// Whether the numbers are those of the run's evaluation: a ceiling that the finest voxels changed was not tried on wider pixels.
    is_evaluated: bool,
}

/// Shows the ceilings that a run tried, and writes the job of one.
pub(super) fn trade_off(given: &ExposeArguments) -> Result<()> {
    let rows = rows(&json_of(&given.run, "report.json")?);
    if rows.is_empty() {
        return Err(Error::config(
            "RUN",
            "a run that looked for no ceiling of its pixels",
            "a run with bounds.ceiling = \"lowest\" and without bounds.max; for other jobs a sweep over bounds.max",
        ));
    }
    let chosen = given.row.map(|row| {
        let found = row.checked_sub(1).and_then(|i| rows.get(i));
        found.ok_or_else(|| {
            let accepted = format!("1 to {}", rows.len());
            Error::config("--row", format!("row {row}"), accepted)
        })
    });
    if let (Some(row), Some(file)) = (chosen.transpose()?, &given.output) {
        write_job(&given.run, file, row.brightest)?;
    }
    let mut answer = Answer::default();
    answer.line(
        "row",
        "brightest pixel, M/t, IoU, VER, mean deviation (on pixels of twice the width)",
    );
    for (i, row) in rows.iter().enumerate() {
        answer.line(&(i + 1).to_string(), row.sentence());
    }
    if let Some(file) = &given.output {
        answer.line("written", file.display().to_string());
    }
    answer.set("rows", &rows);
    answer.tell(given.manner);
    Ok(())
}

/// What the run tried, the longest print first.
fn rows(report: &Value) -> Vec<Row> {
    let ceiling = &report["ceiling"];
    let dose = report["exposure"]["dose"]["best"].as_f64();
    // Seconds are known where the run's job names power and critical dose
    let of_run = &report["exposure"]["time_s"]["best"];
    let of_run = of_run
        .as_f64()
        .zip(report["evaluation"]["time_mm"].as_f64());
    let points = ceiling["points"].as_array().into_iter().flatten();
    let row = |(i, point): (usize, &Value)| {
        let worst = |key: &str, worse: fn(f64, f64) -> f64| {
            let prints = point["prints"].as_array().into_iter().flatten();
            let values = prints.filter_map(|print| print[key].as_f64());
            values.reduce(worse)
        };
        let brightest = ceiling["brightest"].as_f64()? * point["factor"].as_f64()?;
        let time_mm = dose.map(|dose| brightest / dose);
        Some(Row {
            brightest,
            time_mm,
            time_s: of_run
                .zip(time_mm)
                .map(|((s, of_run), time)| s * time / of_run),
            iou: worst("iou", f64::min),
            ver: worst("ver", f64::max),
            surface_mean_mm: worst("surface_mean_mm", f64::max),
            is_chosen: ceiling["chosen"].as_u64() == Some(i as u64),
            is_evaluated: false,
        })
    };
    let mut rows: Vec<Row> = points.enumerate().filter_map(row).collect();
    let changed_by = ceiling["finest"]["changed_by"].as_f64();
    let changed_by = changed_by.filter(|by| (by - 1.0).abs() > 1e-9);
    let chosen = rows.iter_mut().find(|row| row.is_chosen);
    if let Some((by, chosen)) = changed_by.zip(chosen) {
        chosen.is_chosen = false;
        let of_run = |key: &str| report["evaluation"][key].as_f64();
        let own = Row {
            brightest: by * chosen.brightest,
            time_mm: chosen.time_mm.map(|time| by * time),
            time_s: chosen.time_s.map(|time| by * time),
            iou: of_run("iou"),
            ver: of_run("ver"),
            surface_mean_mm: of_run("surface_mean_mm"),
            is_chosen: true,
            is_evaluated: true,
        };
        rows.push(own);
    }
    rows.sort_by(|a, b| b.brightest.total_cmp(&a.brightest));
    rows
}

impl Row {
    fn sentence(&self) -> String {
        let number = |value: Option<f64>, digits: usize| {
            value.map_or_else(|| "–".to_owned(), |v| format!("{v:.digits$}"))
        };
        let seconds = (self.time_s).map(|s| format!(", {} s", significant(s, 3)));
        format!(
            "{:.4}, {} mm{}, {}, {}, {} µm{}",
            self.brightest,
            number(self.time_mm, 3),
            seconds.unwrap_or_default(),
            number(self.iou, 4),
            number(self.ver, 4),
            number(self.surface_mean_mm.map(|mm| 1e3 * mm), 2),
            match (self.is_chosen, self.is_evaluated) {
                (true, true) => " (this run, as it was evaluated)",
                (true, false) => " (this run)",
                _ => "",
            },
        )
    }
}

/// Writes the job of a run with a largest pixel.
fn write_job(run: &Path, file: &Path, largest: f64) -> Result<()> {
    if file.exists() {
        return Err(Error::config(
            "--output",
            format!("`{}` is there already", file.display()),
            "a new file",
        ));
    }
    let path = run.join("job.toml");
    let text = read_text(&path)?;
    let mut document = Document::toml(&path, &text)?;
    document.set(&format!("bounds.max={largest}"))?;
    let text = Job::from_document(document)?.complete().to_toml()?;
    write_whole(file, |out| Ok(out.write_all(text.as_bytes())?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_ceiling_that_the_finest_voxels_changed_has_a_row_of_its_own() {
        let point = |factor: f64| json!({ "factor": factor, "prints": [{ "iou": 0.9, "ver": 0.1, "surface_mean_mm": 0.01 }] });
        let report = |by: f64| {
            json!({
                "ceiling": { "brightest": 0.8, "points": [point(1.0), point(0.5)], "chosen": 1, "finest": { "changed_by": by } },
                "exposure": { "dose": { "best": 0.8 } },
                "evaluation": { "iou": 0.95, "time_mm": 0.7 },
            })
        };
        let chosen = |rows: &[Row]| rows.iter().position(|row| row.is_chosen);
        let same = rows(&report(1.0));
        assert_eq!((same.len(), chosen(&same)), (2, Some(1)));
        let raised = rows(&report(1.5));
        assert_eq!((raised.len(), chosen(&raised)), (3, Some(1)));
        assert!((raised[1].time_mm.unwrap() - 0.75).abs() < 1e-9);
        assert_eq!((raised[1].iou, raised[2].iou), (Some(0.95), Some(0.9)));
    }
}
