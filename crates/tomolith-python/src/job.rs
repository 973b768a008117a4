//! `Job`: a job file, and the whole run of it.

use crate::resolved::ResolvedJob;
use crate::work::{TomolithError, interruptible, interruptible_observed, plain, raised};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde_json::Value;
use std::path::{Path, PathBuf};
use tomolith::job::{self, Document, Summary};

/// A job: its tables, checked.
///
/// `source` is the path of a job file (TOML or JSON) or a dict of its tables (docs/job.md), which may hold numbers and arrays of numpy, and paths; `set` holds
/// changes, as a dict of dotted keys, `{"stop.iterations": 10}`, or a list, `["stop.iterations=10"]`; `folder` is the run folder, `out/NAME` without it. A key or value that cannot be used raises `TomolithError` with the
/// key, the line, and what is accepted. Jobs can be pickled.
#[pyclass(module = "tomolith", frozen)]
pub(crate) struct Job(job::Job);

#[pymethods]
impl Job {
    #[new]
    #[pyo3(signature = (source, *, set=None, folder=None))]
    fn new(
        source: &Bound<'_, PyAny>,
        set: Option<&Bound<'_, PyAny>>,
        folder: Option<PathBuf>,
    ) -> PyResult<Self> {
        let mut document = match source.cast::<PyDict>() {
            Ok(tables) => {
                let text = text_of(tables)?;
                Document::json("job.json", text)
            }
            Err(_) => Document::read(&source.extract::<PathBuf>()?),
        }
        .map_err(raised)?;
        let changes = set.map_or(Ok(Vec::new()), changes_of)?;
        (changes.iter())
            .try_for_each(|change| document.set(change))
            .map_err(raised)?;
        let job = job::Job::from_document(document).map_err(raised)?;
        Ok(Job(match folder {
            Some(folder) => job.with_folder(&folder, "folder"),
            None => job,
        }))
    }

    /// Its name: that of the file, without ending.
    #[getter]
    fn name(&self) -> String {
        self.0.name()
    }

    /// The run folder.
    #[getter]
    fn folder(&self) -> PathBuf {
        self.0.folder()
    }

    /// The job with every default written out, as a dict.
    #[getter]
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        plain(py, &self.0.complete())
    }

    /// What the run would take, as `tomolith check --json`.
    fn check<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let plan = interruptible(py, |work| job::check(&self.0, &mut job::Silent, work))?;
        plain(py, &plan)
    }

    /// The whole run, as `tomolith run`; returns its `Run`.
    ///
    /// `progress` is called with a dict for each event: its key `event` is "stage", "note", "warning", "iteration" or "part". An object with
    /// the methods `event(dict)` and `snapshot(dict)` may name in its attribute `wants`, which is read after each event, the copies that it gets at the next iteration and
    /// at the end: "patterns" `[frame, row, column]`, "dose" and "print" `[z, y, x]`. What it raises ends the run.
    ///
    /// `cancel`, such as a `threading.Event`, ends the run when it is set, which raises `Canceled`; Ctrl-C raises `KeyboardInterrupt`. Both leave a checkpoint, from which
    /// `resume=True` goes on. A folder that holds a finished run of another job is refused without `overwrite=True`, a folder in use always.
    #[pyo3(signature = (*, resume=false, overwrite=false, progress=None, cancel=None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        resume: bool,
        overwrite: bool,
        progress: Option<Py<PyAny>>,
        cancel: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let job = self.replacing(overwrite);
        let summary = interruptible_observed(py, progress, cancel, |progress, work| {
            job::run(&job, resume, progress, work)
        })?;
        done(py, &summary)
    }

    /// What patterns print, as `tomolith simulate` and, with a schedule, `tomolith print`; returns a `Run` of its own folder. `patterns` is a `Run`, a run folder
    /// or a file of patterns; arrays are evaluated by `ResolvedJob.evaluate`. The rest is as in `run`.
    #[pyo3(signature = (patterns, *, overwrite=false, progress=None, cancel=None))]
    fn simulate<'py>(
        &self,
        py: Python<'py>,
        patterns: PathBuf,
        overwrite: bool,
        progress: Option<Py<PyAny>>,
        cancel: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let job = self.replacing(overwrite);
        let summary = interruptible_observed(py, progress, cancel, |progress, work| {
            job::simulate(&job, Path::new(&patterns), progress, work)
        })?;
        done(py, &summary)
    }

    /// The job of a text, in another process.
    #[staticmethod]
    fn _restored(file: PathBuf, tables: String, folder: PathBuf) -> PyResult<Self> {
        let document = Document::json(file, tables).map_err(raised)?;
        let job = job::Job::from_document(document).map_err(raised)?;
        Ok(Job(job.with_folder(&folder, "folder")))
    }

    /// Its tables, and where paths in them begin.
    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, (String, String, String))> {
        let job = &slf.get().0;
        let place = |path: &Path| match std::path::absolute(path) {
            Ok(path) => path.display().to_string(),
            Err(_) => path.display().to_string(),
        };
        let tables = job.document.root.to_string();
        let state = (place(&job.document.file), tables, place(&job.folder()));
        Ok((slf.get_type().getattr("_restored")?, state))
    }

    /// The job as objects: model, objective, start, and what patterns print.
    fn resolve(&self, py: Python<'_>) -> PyResult<ResolvedJob> {
        interruptible(py, |_| job::ResolvedJob::new(&self.0).map(ResolvedJob::new))
    }

    fn __repr__(&self) -> String {
        format!("<tomolith.Job {}>", self.0.name())
    }
}

/// Changes of keys, each as `--set` takes it.
fn changes_of(given: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    let Ok(changes) = given.cast::<PyDict>() else {
        return given.extract();
    };
    let change = |(key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        if let Ok(number) = value.extract::<f64>()
            && !number.is_finite()
        {
            // As TOML writes it, for the words of the command
            let number = number.to_string().to_lowercase();
            return Ok(format!("{key}={number}"));
        }
        let alone = PyDict::new(given.py());
        alone.set_item("value", value)?;
        let text = text_of(&alone)?;
        let table: Value =
            serde_json::from_str(&text).map_err(|e| TomolithError::new_err(format!("set: {e}")))?;
        Ok(Document::assignment(
            &key.extract::<String>()?,
            &table["value"],
        ))
    };
    changes.iter().map(change).collect()
}

/// The run of a folder, and what the command says at its end.
fn done<'py>(py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyAny>> {
    let run = py.import("tomolith._run")?.getattr("Run")?;
    run.call1((&summary.folder, plain(py, summary)?))
}

/// The tables as JSON; numbers and arrays of numpy and paths are taken for what they are.
fn text_of(tables: &Bound<'_, PyDict>) -> PyResult<String> {
    let py = tables.py();
    let plain = wrap_pyfunction!(plain_value, py)?;
    let options = PyDict::new(py);
    options.set_item("default", plain)?;
    options.set_item("allow_nan", false)?;
    let json = py.import("json")?;
    let text = json.call_method("dumps", (tables,), Some(&options));
    text.map_err(|e| match not_finite(tables.as_any(), "") {
        Some(found) => TomolithError::new_err(format!("{found}; accepted: a finite number")),
        None => TomolithError::new_err(format!("job: {}", e.value(py))),
    })?
    .extract()
}

/// The place of a number that is not finite, and the number.
fn not_finite(value: &Bound<'_, PyAny>, place: &str) -> Option<String> {
    if let Ok(table) = value.cast::<PyDict>() {
        let dot = if place.is_empty() { "" } else { "." };
        return table
            .iter()
            .find_map(|(key, value)| not_finite(&value, &format!("{place}{dot}{key}")));
    }
    if let Ok(list) = value.cast::<PyList>() {
        let mut each = list.iter().enumerate();
        return each.find_map(|(i, value)| not_finite(&value, &format!("{place}[{i}]")));
    }
    let number = value
        .extract::<f64>()
        .ok()
        .filter(|number| !number.is_finite())?;
    Some(format!("{place}: found {number}"))
}

#[pyfunction]
fn plain_value<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    if value.hasattr("tolist")? {
        return value.call_method0("tolist");
    }
    let path = value.extract::<PathBuf>().map_err(|_| {
        let kind = value.get_type();
        TomolithError::new_err(format!(
            "found a value of {kind}; accepted: numbers, strings, lists, dicts, paths, arrays"
        ))
    })?;
    Ok(path.into_pyobject(value.py())?.str()?.into_any())
}

impl Job {
    fn replacing(&self, overwrite: bool) -> job::Job {
        let job = self.0.clone();
        if overwrite { job.overwriting() } else { job }
    }
}
