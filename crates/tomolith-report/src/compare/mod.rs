//! Several runs on one page: numbers side by side, curves laid over each other, doses next to each other, and which keys of the jobs differ.
//!
//! A run is read from its folder: `report.json`, `history.csv`, `job.toml`, `dose.npy`, and the target of its `report.html`. Nothing is computed again, so
//! that runs of other machines and other days can be compared.

mod rows;
mod run;
mod tables;

use crate::page::{Page, PageKind, compared, made_as, page_data, word};
use rows::rows;
pub use run::ComparedRun;
pub(crate) use run::columns;
use serde_json::{Value, json};
use std::io::Read as _;
use std::path::Path;
use tables::{differing, evaluation_model_of, is_fair, prints, warnings};
use tomolith_core::error::{Error, Result};
use tomolith_io::{open_regular, write_text};

/// Runs on one page, at most: nobody can distinguish the lines of more.
const MOST: usize = 12;

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
        .map(|row| json!({ "key": row.key, "name": row.name, "unit": row.unit, "better": word(row.better), "values": runs.iter().map(|run| (row.value)(run)).collect::<Vec<_>>() }))
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

/// What `compare` says as JSON, and what only its page says.
#[must_use]
pub fn comparison(runs: &[ComparedRun]) -> Value {
    let mut value = compare_json(runs);
    let models: Vec<Option<&str>> = runs.iter().map(evaluation_model_of).collect();
    value["models"] = json!(models);
    value["marks_best"] = json!(is_fair(runs));
    value["prints"] = json!(runs.iter().map(prints).collect::<Vec<_>>());
    value["warnings"] = json!(warnings(runs));
    value
}

/// The page.
///
/// # Errors
/// Those of reading a dose.
pub fn compare_page(runs: &[ComparedRun]) -> Result<Page> {
    let title = format!("{} runs", runs.len());
    let (all, blobs) = compared(runs)?;
    let mut data = page_data(PageKind::Compare, &title, "Tomolith", all);
    data["compare"] = comparison(runs);
    Ok(Page {
        data,
        blobs,
        plain: tables::plain(runs),
    })
}

/// Writes the page.
///
/// # Errors
/// [`Error::Io`].
pub fn write_compare(path: &Path, runs: &[ComparedRun]) -> Result<()> {
    let page = compare_page(runs)?.html();
    write_text(path, &page)
}

/// Whether a file is a page of [`write_compare`].
#[must_use]
pub fn is_comparison(path: &Path) -> bool {
    let mut start = Vec::new();
    let read = open_regular(path).map(|file| file.take(START as u64).read_to_end(&mut start));
    read.is_ok() && String::from_utf8_lossy(&start).contains(&made_as("compare"))
}

/// Within how many bytes of a page that stands.
const START: usize = 200;

#[cfg(test)]
mod tests;
