//! A run as it is read from its folder.

use crate::page::{Page, bare_run};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::units::concise;
use tomolith_io::npy::read_volume;
use tomolith_io::read_text;

/// What a folder must hold.
const ACCEPTED: &str = "the folder of a run of Tomolith, with report.json";

/// A run to be compared.
#[derive(Clone, Debug)]
pub struct ComparedRun {
    /// Its name on the page.
    pub name: String,
    /// `report.json`.
    pub report: Value,
    /// `job.toml`.
    pub job_text: String,
    /// The job, flat: key path → value.
    pub job: BTreeMap<String, String>,
    /// `dose.npy`, on the job's voxels; None where the folder has none.
    pub dose: Option<PathBuf>,
    /// `report.html`; None where there is none, or one of an earlier version.
    pub page: Option<Page>,
    /// `history.csv`: column → numbers, not a number where there is none; empty for a simulation.
    pub history: BTreeMap<String, Vec<f64>>,
}

/// A run of a sweep by the values of its axes, as the sweep's table has them.
pub(super) fn in_sweep(folder: &Path) -> Option<String> {
    let table = folder.parent()?.parent()?.join("table.json");
    let table: Value = serde_json::from_str(&read_text(table).ok()?).ok()?;
    let is_this = |row: &&Value| row["id"].as_str().is_some_and(|id| folder.ends_with(id));
    let row = table["rows"].as_array()?.iter().find(is_this)?;
    let axes = table["axes"]
        .as_array()?
        .iter()
        .zip(row["values"].as_array()?);
    let texts = axes.filter_map(|(axis, value)| {
        let text = match value.as_f64() {
            Some(number) => concise(number),
            None => value
                .as_str()
                .map_or_else(|| value.to_string(), str::to_owned),
        };
        Some(format!("{} {text}", axis.as_str()?))
    });
    Some(texts.collect::<Vec<_>>().join(", ")).filter(|name| !name.is_empty())
}

impl ComparedRun {
    /// Reads a run folder.
    ///
    /// # Errors
    /// [`Error::Format`] when it is no folder of a run; [`Error::Io`] when its report cannot be read.
    pub fn read(folder: &Path) -> Result<Self> {
        if let Some(found) = is_no_run(folder) {
            return Err(Error::format(folder, found, ACCEPTED));
        }
        let report = crate::json::read(folder)?;
        let job_text = read_text(folder.join("job.toml")).unwrap_or_default();
        let job: Value = toml::from_str(&job_text).unwrap_or_default();
        let mut flat = BTreeMap::new();
        flatten("", &job, &mut flat);
        flat.remove("output.folder");
        let history = read_text(folder.join("history.csv")).unwrap_or_default();
        let name = || {
            folder
                .file_name()
                .map(|name| name.to_string_lossy().into_owned())
        };
        let name = in_sweep(folder).or_else(name);
        let name = name.unwrap_or_else(|| folder.display().to_string());
        let dose = Some(folder.join("dose.npy")).filter(|path| path.is_file());
        Ok(ComparedRun {
            name,
            report,
            dose,
            page: Page::read(&folder.join("report.html")).ok(),
            job_text,
            job: flat,
            history: columns(&history),
        })
    }

    /// `optimization`, or `simulation` of patterns that were given: what gave the patterns of this run.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        if self.report["history"].is_null() {
            "simulation"
        } else {
            "optimization"
        }
    }

    /// The dose, where there is one. Its voxels lie in the box of those that the run was evaluated on.
    pub(crate) fn read_dose(&self) -> Result<Option<Volume<f32>>> {
        let Some(path) = &self.dose else {
            return Ok(None);
        };
        let (shape, values) = read_volume(path)?;
        let (Some(fine), Some(pitch)) = (
            self.number("/evaluation/grid/shape_zyx/2"),
            self.number("/evaluation/grid/pitch_mm"),
        ) else {
            return Ok(None);
        };
        let center = |axis: usize| self.number(&format!("/evaluation/grid/center_xyz_mm/{axis}"));
        let pitch_mm = pitch * fine / shape[2].max(1) as f64;
        let grid = VolumeGrid {
            center_mm: std::array::from_fn(|axis| center(axis).unwrap_or(0.0)),
            ..VolumeGrid::centered(shape, pitch_mm)
        };
        Ok((!grid.is_empty()).then_some(Volume { grid, values }))
    }

    /// What a page shows of the numbers of the run, without its volumes.
    #[must_use]
    pub fn bare(&self) -> Value {
        let mut data = bare_run(&self.name, "done", &self.job_text);
        data["report"] = self.report.clone();
        data["history"] = json!(self.history);
        data
    }

    pub(super) fn number(&self, pointer: &str) -> Option<f64> {
        self.report.pointer(pointer)?.as_f64()
    }

    /// Model calls after row `i` of the history.
    pub(super) fn calls(&self, i: usize) -> Option<f64> {
        let at = |name: &str| self.history.get(name)?.get(i).copied();
        Some(at("forward_calls")? + at("adjoint_calls")?)
    }
}

/// Why a path is not the folder of a run; None when it holds a report.
fn is_no_run(folder: &Path) -> Option<&'static str> {
    if !folder.exists() {
        Some("there is no such folder")
    } else if !folder.is_dir() {
        Some("a file, not a folder")
    } else if folder.join("report.json").is_file() {
        None
    } else if folder.join("checkpoint").is_dir() {
        Some("its run has not ended: `tomolith run JOB --open` shows a run while it goes on")
    } else {
        Some("no report.json in it, so no run has ended here")
    }
}

pub(super) fn flatten(path: &str, value: &Value, flat: &mut BTreeMap<String, String>) {
    let below = |key: &str| {
        if path.is_empty() {
            key.to_owned()
        } else {
            format!("{path}.{key}")
        }
    };
    match value {
        Value::Object(map) if !map.is_empty() => map
            .iter()
            .for_each(|(key, value)| flatten(&below(key), value, flat)),
        Value::Array(list) if list.iter().any(Value::is_object) => {
            for (i, value) in list.iter().enumerate() {
                flatten(&format!("{path}[{i}]"), value, flat);
            }
        }
        Value::Null => {}
        Value::Object(_) => drop(flat.insert(path.to_owned(), "(defaults)".to_owned())),
        Value::String(text) => drop(flat.insert(path.to_owned(), text.clone())),
        other => drop(flat.insert(path.to_owned(), other.to_string())),
    }
}

/// Columns of a table with a header; a cell that cannot be read as a number becomes NaN, which is null in JSON.
pub(crate) fn columns(text: &str) -> BTreeMap<String, Vec<f64>> {
    let mut lines = text.lines();
    let names: Vec<&str> = lines
        .next()
        .unwrap_or_default()
        .split(',')
        .filter(|name| !name.is_empty())
        .collect();
    let mut table: BTreeMap<String, Vec<f64>> = names
        .iter()
        .map(|name| ((*name).to_owned(), Vec::new()))
        .collect();
    for line in lines {
        for (name, cell) in names.iter().zip(line.split(',')) {
            if let Some(column) = table.get_mut(*name) {
                column.push(cell.parse().unwrap_or(f64::NAN));
            }
        }
    }
    table
}
