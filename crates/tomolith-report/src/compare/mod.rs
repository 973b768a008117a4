//! Several runs on one page: numbers side by side, histograms and IoU over the threshold laid over each other, loss against
//! model calls and seconds, and which keys of the jobs differ.
//!
//! A run is read from its folder: `report.json`, `history.csv` and `job.toml`. Nothing is computed again, so that runs of
//! other machines and other days can be compared. The page is one file without any outside resource.

mod plots;
mod rows;
mod run;
mod tables;

use super::figures;
use super::number::escape;
use plots::{curves, histograms, history};
use rows::rows;
pub use run::ComparedRun;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::{Read as _, Write as _};
use std::path::Path;
use tables::{differing, keys, numbers, warnings};
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::Volume;
use tomolith_io::{open_regular, write_whole};

/// Runs on one page, at most: lines of more cannot be told apart.
const MOST: usize = 12;

/// Colors; later runs have them again, dashed.
const COLORS: usize = 6;

/// Reads run folders; folders of the same name are called by their whole path.
///
/// # Errors
/// As [`ComparedRun::read`]; [`Error::Config`] when there are none or too many.
pub fn read_runs(folders: &[impl AsRef<Path>]) -> Result<Vec<ComparedRun>> {
    if folders.is_empty() || folders.len() > MOST {
        return Err(Error::config(
            "RUN",
            format!("{} runs", folders.len()),
            format!("1 to {MOST} run folders"),
        ));
    }
    let mut runs = folders
        .iter()
        .map(|folder| ComparedRun::read(folder.as_ref()))
        .collect::<Result<Vec<_>>>()?;
    let names: Vec<String> = runs.iter().map(|run| run.name.clone()).collect();
    for (i, run) in runs.iter_mut().enumerate() {
        if names.iter().filter(|name| **name == run.name).count() > 1 {
            run.name = folders[i].as_ref().display().to_string();
        }
    }
    Ok(runs)
}

/// Every number of every run, as `tomolith compare --json` prints it.
#[must_use]
pub fn compare_json(runs: &[ComparedRun]) -> Value {
    let rows: Vec<Value> = rows(runs)
        .iter()
        .map(|row| json!({ "key": row.key, "name": row.name, "unit": row.unit, "values": runs.iter().map(|run| (row.value)(run)).collect::<Vec<_>>() }))
        .collect();
    let differing: Vec<Value> = differing(runs)
        .into_iter()
        .map(|(key, values)| json!({ "key": key, "values": values }))
        .collect();
    json!({
        "schema": "tomolith.compare/1",
        "runs": runs.iter().map(|run| &run.name).collect::<Vec<_>>(),
        "kinds": runs.iter().map(ComparedRun::kind).collect::<Vec<_>>(),
        "numbers": rows,
        "differing_keys": differing,
    })
}

/// Writes the page.
///
/// # Errors
/// [`Error::Io`].
pub fn write_compare(path: &Path, runs: &[ComparedRun]) -> Result<()> {
    let page = compare_html(runs);
    write_whole(path, |file| Ok(file.write_all(page.as_bytes())?))
}

/// Whether a file is a page of [`write_compare`].
#[must_use]
pub fn is_comparison(path: &Path) -> bool {
    let mut start = Vec::new();
    let read = open_regular(path).map(|file| file.take(START as u64).read_to_end(&mut start));
    read.is_ok() && String::from_utf8_lossy(&start).contains(MARK)
}

/// In the title of every page, and within how many bytes.
const MARK: &str = " · Tomolith</title>";
const START: usize = 200;

/// The page.
#[must_use]
pub fn compare_html(runs: &[ComparedRun]) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{} runs{MARK}\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>{}{}</style></head><body>",
        runs.len(),
        include_str!("../style.css"),
        include_str!("../compare.css")
    );
    let _ = write!(page, "{}<main>", head(runs));
    let plots = [
        (
            "Loss against model calls",
            "Dose and adjoint calls. Compare methods by model calls, not by iterations.",
            history(runs, "loss", ComparedRun::calls, "model calls"),
        ),
        (
            "Loss against time",
            "On the machine of each run.",
            history(runs, "loss", ComparedRun::seconds, "seconds"),
        ),
        (
            "Dose of part and void",
            "Share of the voxels per unit of the response; part in full lines, void in dotted ones.",
            histograms(runs),
        ),
        (
            "IoU over the gel threshold",
            "A broad plateau tolerates errors of exposure.",
            curves(runs),
        ),
        (
            "IoU against model calls",
            "On the grid of each optimization, where it was measured.",
            history(runs, "iou", ComparedRun::calls, "model calls"),
        ),
        (
            "IoU against time",
            "The same, on the machine of each run.",
            history(runs, "iou", ComparedRun::seconds, "seconds"),
        ),
    ];
    page.push_str(&warnings(runs));
    page.push_str(&numbers(runs));
    page.push_str(&pictures(runs));
    page.push_str("<div class=\"two\">");
    for (title, note, plot) in plots {
        let plot =
            plot.unwrap_or_else(|| "<p class=\"note\">No run holds these numbers.</p>".to_owned());
        let _ = write!(
            page,
            "<section><h2>{title}</h2><p class=\"muted\">{note}</p>{}{plot}</section>",
            key(runs)
        );
    }
    page.push_str("</div>");
    page.push_str(&keys(runs));
    page.push_str(
        "</main><footer>Tomolith · Numbers are predictions of a model, not measurements. Doses are relative unless the job says otherwise.\
         </footer></body></html>\n",
    );
    page
}

/// Doses beside each other.
fn pictures(runs: &[ComparedRun]) -> String {
    let doses: Vec<(&str, &Volume<f32>)> = runs
        .iter()
        .filter_map(|run| Some((run.name.as_str(), run.dose.as_ref()?)))
        .collect();
    let [(first, dose), others @ ..] = &doses[..] else {
        return String::new();
    };
    if others.is_empty() {
        return String::new();
    }
    let (alike, unlike): (Vec<_>, Vec<_>) =
        (others.iter()).partition(|(_, other)| other.grid == dose.grid);
    let names = |runs: &[&(&str, &Volume<f32>)]| {
        let names: Vec<String> = runs.iter().map(|(name, _)| escape(name)).collect();
        names.join(", ")
    };
    let mut notes = String::new();
    if !alike.is_empty() {
        let _ = write!(
            notes,
            " Below, where the dose of {} is higher (red) or lower (blue) than that of {}: gray up to 5 % of the largest dose, full color from 20 %.",
            names(&alike),
            escape(first)
        );
    }
    if !unlike.is_empty() {
        let _ = write!(
            notes,
            " No difference is drawn for {}: its voxels differ from those of {}.",
            names(&unlike),
            escape(first)
        );
    }
    format!(
        "<section><h2>Doses</h2><p class=\"muted\">Written patterns, vial turning, on each job's voxels and one scale.{notes}</p>{}</section>",
        figures::doses(&doses)
    )
}

fn head(runs: &[ComparedRun]) -> String {
    let parts: BTreeSet<&str> = runs
        .iter()
        .filter_map(|run| run.report["part"].as_str())
        .collect();
    let parts: Vec<String> = parts.into_iter().map(escape).collect();
    format!(
        "<header><div class=\"brand\">Tomolith comparison</div><h1>{} runs</h1><p class=\"lead\">Part: {}</p></header>",
        runs.len(),
        parts.join(", ")
    )
}

/// Color class of a run.
fn class(i: usize) -> String {
    format!(
        "run{}{}",
        i % COLORS,
        if i < COLORS { "" } else { " again" }
    )
}

fn key(runs: &[ComparedRun]) -> String {
    let one = |(i, run): (usize, &ComparedRun)| {
        format!(
            "<span><svg viewBox=\"0 0 22 8\" aria-hidden=\"true\"><path class=\"s-{}\" d=\"M1 4H21\"/></svg>{}</span>",
            class(i),
            escape(&run.name)
        )
    };
    format!(
        "<div class=\"runs\">{}</div>",
        runs.iter().enumerate().map(one).collect::<String>()
    )
}

#[cfg(test)]
mod tests;
