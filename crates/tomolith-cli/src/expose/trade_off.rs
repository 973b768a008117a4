//! `tomolith expose RUN --trade-off`: quality against time, and the job of a chosen ceiling.

use super::ExposeArguments;
use crate::answer::Answer;
use serde::Deserialize as _;
use std::path::Path;
use tomolith::io::{must_be_new, write_text};
use tomolith::job::{Document, Job};
use tomolith::report::TradeOff;
use tomolith::report::json::read as read_report;
use tomolith::report::number::significant;
use tomolith::{Error, Result};

/// Shows the ceilings that a run tried, and writes the job of one.
pub(super) fn trade_off(given: &ExposeArguments) -> Result<()> {
    let report = read_report(&given.run)?;
    let rows = Vec::<TradeOff>::deserialize(&report["ceiling"]["trade_off"]).map_err(|_| {
        Error::config(
            "RUN",
            "a run that looked for no ceiling of its pixels",
            "a run with bounds.ceiling = \"lowest\" and without bounds.max; for other jobs a sweep over bounds.max",
        )
    })?;
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
        "brightest pixel, N·M/t, IoU, VER, mean deviation (on pixels of twice the width)",
    );
    for (i, row) in rows.iter().enumerate() {
        answer.line(&(i + 1).to_string(), sentence(row));
    }
    if let Some(file) = &given.output {
        answer.line("written", file.display().to_string());
    }
    answer.set("rows", &rows);
    answer.tell(given.manner);
    Ok(())
}

fn sentence(row: &TradeOff) -> String {
    let number = |value: Option<f64>, digits: usize| {
        value.map_or_else(|| "–".to_owned(), |v| format!("{v:.digits$}"))
    };
    let seconds = (row.time_s).map(|s| format!(", {} s", significant(s, 3)));
    format!(
        "{:.4}, {} mm{}, {}, {}, {} µm{}",
        row.brightest,
        (row.print_time_mm).map_or_else(|| "–".to_owned(), |mm| significant(mm, 3)),
        seconds.unwrap_or_default(),
        number(row.iou, 4),
        number(row.ver, 4),
        number(row.surface_mean_mm.map(|mm| 1e3 * mm), 2),
        match (row.is_chosen, row.is_evaluated) {
            (true, true) => " (this run, as it was evaluated)",
            (true, false) => " (this run)",
            _ => "",
        },
    )
}

/// Writes the job of a run with a largest pixel.
fn write_job(run: &Path, file: &Path, largest: f64) -> Result<()> {
    must_be_new("--output", file)?;
    let mut document = Document::read(&run.join("job.toml"))?;
    document.set(&format!("bounds.max={largest}"))?;
    let mut spec = Job::from_document(document)?.complete();
    // That of the run is another job's; without one a job has a folder by the name of its file
    spec.output.folder = None;
    let text = spec.to_toml()?;
    write_text(file, &text)
}
