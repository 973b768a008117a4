//! `Job`: a job file, and the whole run of it.

use crate::resolved::ResolvedJob;
use crate::work::{
    TomolithError, advising, interruptible, interruptible_observed, plain, raised, refused,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use serde_json::Value;
use std::path::{Path, PathBuf};
use tomolith::job::{self, Document, RunFolder, Summary};

/// A job: its tables, checked.
///
/// `source` is the path of a job file (TOML or JSON) or a dict of its tables (docs/job.md), which may hold numbers and arrays of numpy, and paths; its `target.stack` may be an array `[z, y, x]`. `set` holds
/// changes, as a dict of dotted keys, `{"stop.iterations": 10}`, or a list, `["stop.iterations=10"]`; `folder` is the run folder, `out/NAME` without it. A key or value that cannot be used raises `TomolithError` with the
/// key, the line, and what is accepted. Jobs can be pickled.
#[pyclass(module = "tomolith", frozen)]
pub(crate) struct Job {
    job: job::Job,
    /// The folder of its arrays, which goes when the job does; none where it has no arrays.
    files: Option<Py<PyAny>>,
}

/// What a job is restored from: where its paths begin, its tables, its folder.
type State<'py> = (String, Bound<'py, PyAny>, String);

#[pymethods]
impl Job {
    #[new]
    #[pyo3(signature = (source, *, set=None, folder=None))]
    fn new(
        source: &Bound<'_, PyAny>,
        set: Option<&Bound<'_, PyAny>>,
        folder: Option<PathBuf>,
    ) -> PyResult<Self> {
        let (mut document, files) = match source.cast::<PyDict>() {
            Ok(tables) => document_of(tables, Path::new("job.json"))?,
            Err(_) => {
                let file: PathBuf = source.extract()?;
                (Document::read(&file).map_err(raised)?, None)
            }
        };
        let changes = set.map_or(Ok(Vec::new()), changes_of)?;
        (changes.iter())
            .try_for_each(|change| document.set(change))
            .map_err(raised)?;
        let job = job::Job::from_document(document).map_err(raised)?;
        let job = match folder {
            Some(folder) => job.with_folder(&folder, "folder"),
            None => job,
        };
        Ok(Job { job, files })
    }

    /// Its name: that of the file, without ending.
    #[getter]
    fn name(&self) -> String {
        self.job.name()
    }

    /// The run folder.
    #[getter]
    fn folder(&self) -> PathBuf {
        self.job.folder()
    }

    /// The job with every default written out, as a dict.
    #[getter]
    fn tables<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        plain(py, &self.job.complete())
    }

    /// What the run would take, as `tomolith check --json`.
    fn check<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let plan = interruptible(py, |work| job::check(&self.job, &mut job::Silent, work))?;
        plain(py, &plan)
    }

    /// The whole run, as `tomolith run`; returns its `Run`.
    ///
    /// `progress` is called with a dict for each event: its key `event` is "stage", "note", "warning", "iteration" or "part". An object with
    /// the methods `event(dict)` and `snapshot(dict)` may name in its attribute `wants`, which is read after each event, the copies that it gets at the next iteration and
    /// at the end: "patterns" `[frame, row, column]`, "dose" and "print" `[z, y, x]`. What it raises ends the run.
    ///
    /// `cancel`, such as a `threading.Event`, ends the run when it is set, which raises `Canceled`; Ctrl-C raises `KeyboardInterrupt`. After the first iteration both leave a checkpoint, from which
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
        })
        .map_err(|e| match RunFolder::holds_a_checkpoint(&job.folder()) {
            true => advising(py, e, "Job.run(resume=True) goes on from the checkpoint"),
            false => e,
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

    /// The job of its tables, in another process.
    #[staticmethod]
    fn _restored(file: PathBuf, tables: &Bound<'_, PyDict>, folder: PathBuf) -> PyResult<Self> {
        let (document, files) = document_of(tables, &file)?;
        let job = job::Job::from_document(document).map_err(raised)?;
        let job = job.with_folder(&folder, "folder");
        Ok(Job { job, files })
    }

    /// Its tables, and where paths in them begin.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, State<'py>)> {
        let (py, Job { job, files }) = (slf.py(), slf.get());
        let place = |path: &Path| match std::path::absolute(path) {
            Ok(path) => path.display().to_string(),
            Err(_) => path.display().to_string(),
        };
        let mut tables = plain(py, &job.document.root)?;
        if let Some(files) = files {
            let arrays = py.import("tomolith._arrays")?;
            tables = arrays.call_method1("with_arrays", (tables, files))?;
        }
        let state = (place(&job.document.file), tables, place(&job.folder()));
        Ok((slf.get_type().getattr("_restored")?, state))
    }

    /// The job as objects: model, objective, start, and what patterns print.
    fn resolve(&self, py: Python<'_>) -> PyResult<ResolvedJob> {
        interruptible(py, |_| {
            job::ResolvedJob::new(&self.job).map(ResolvedJob::new)
        })
    }

    fn __repr__(&self) -> String {
        format!("<tomolith.Job {}>", self.job.name())
    }
}

/// Tables as a document, and the folder of the arrays in them.
fn document_of(tables: &Bound<'_, PyDict>, file: &Path) -> PyResult<(Document, Option<Py<PyAny>>)> {
    let arrays = tables.py().import("tomolith._arrays")?;
    let (tables, files): (Bound<'_, PyDict>, Option<Py<PyAny>>) =
        arrays.call_method1("with_files", (tables,))?.extract()?;
    let document = Document::tables(file, text_of(&tables)?).map_err(raised)?;
    Ok((document, files))
}

/// Changes of keys, each as `--set` takes it.
fn changes_of(given: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    let Ok(changes) = given.cast::<PyDict>() else {
        let accepted =
            "set: a dict of keys and values, or a list of texts such as [\"stop.iterations=3\"]";
        return given.extract().map_err(|_| PyTypeError::new_err(accepted));
    };
    let change = |(key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        if let Ok(number) = value.extract::<f64>()
            && !number.is_finite()
        {
            // As TOML writes it, for the words of the command
            let number = number.to_string().to_lowercase();
            return Ok(format!("{key}={number}"));
        }
        if (value.getattr("ndim")).is_ok_and(|ndim| ndim.gt(2).unwrap_or(false)) {
            let found = format!("set: an array for `{key}`");
            let accepted = "arrays in a dict of tables: Job({\"target\": {\"stack\": array}, …})";
            return Err(TomolithError::new_err(format!(
                "{found}; accepted: {accepted}"
            )));
        }
        let alone = PyDict::new(given.py());
        alone.set_item(&key, value)?;
        let text = text_of(&alone)?;
        let table: Value =
            serde_json::from_str(&text).map_err(|e| TomolithError::new_err(format!("set: {e}")))?;
        let key = key.extract::<String>()?;
        Ok(Document::assignment(&key, &table[&key]))
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
        Some((key, found)) => refused(key, found, "a finite number"),
        None => TomolithError::new_err(format!("job: {}", e.value(py))),
    })?
    .extract()
}

/// The place of a number that is not finite, and the number.
fn not_finite(value: &Bound<'_, PyAny>, place: &str) -> Option<(String, f64)> {
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
    if let Ok(list) = value.call_method0("tolist")
        && list.is_instance_of::<PyList>()
    {
        return not_finite(&list, place);
    }
    let number = value
        .extract::<f64>()
        .ok()
        .filter(|number| !number.is_finite())?;
    Some((place.to_owned(), number))
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
        let job = self.job.clone();
        if overwrite { job.overwriting() } else { job }
    }
}
