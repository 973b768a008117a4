//! `sweep`: a job with many values of its keys. `reproduce`: the numbers of a paper next to those of sweeps, jobs and commands.

use crate::work::{Observer, advising, interruptible_observed, plain, refused};
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use tomolith::Result;
use tomolith_cli::Itself;
use tomolith_sweep::{Host, Study, StudyCost, Sweep, SweepEvent, SweepPlan, Watch, run};

/// Runs a sweep file, as `tomolith sweep`, and returns its counts and its best job as a dict. Runs that were finished before stay. `threads`: 1 to 256, the
/// cores of this machine without it; `progress` and `cancel` as in `Job.run`.
#[pyfunction]
#[pyo3(signature = (file, *, folder=None, threads=None, progress=None, cancel=None))]
pub(crate) fn sweep(
    py: Python<'_>,
    file: PathBuf,
    folder: Option<PathBuf>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
    cancel: Option<Py<PyAny>>,
) -> PyResult<Py<PyAny>> {
    let threads = usable(threads)?;
    let outcome = interruptible_observed(py, progress, cancel, |progress, work| {
        let mut sweep = Sweep::read(&file)?;
        if let Some(folder) = &folder {
            sweep = sweep.with_folder(folder, "folder");
        }
        run(&sweep.plan(threads, work)?, None, progress, work)
    })
    .map_err(|e| advising(py, e, "the same call goes on with what is left"))?;
    Ok(plain(py, &outcome)?.unbind())
}

/// Runs a study, as `tomolith reproduce`, and returns its rows (the paper's number, Tomolith's, the verdict) and files as a dict. `study` is its folder, such as
/// `papers/bclp`; `quick` takes a size that ends in minutes; `folder` is where results go, `out/papers/NAME` without it. What was finished before stays. The rest is as in
/// `sweep`; events of a sweep have its name in the study in `of`.
#[pyfunction]
#[pyo3(signature = (study, *, quick=false, folder=None, threads=None, progress=None, cancel=None))]
pub(crate) fn reproduce(
    py: Python<'_>,
    study: PathBuf,
    quick: bool,
    folder: Option<PathBuf>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
    cancel: Option<Py<PyAny>>,
) -> PyResult<Py<PyAny>> {
    let count = usable(threads)?;
    let python: OsString = py.import("sys")?.getattr("executable")?.extract()?;
    let program = [python, "-m".into(), "tomolith".into()];
    let found = interruptible_observed(py, progress, cancel, |observer, work| {
        let study = Study::read(&study, quick)?;
        let folder = folder.unwrap_or_else(|| study.output());
        let itself = Itself {
            program: &program,
            threads,
            work,
        };
        let mut host = Told { observer, itself };
        tomolith_sweep::reproduce(&study, &folder, count, &mut host, work)
    })
    .map_err(|e| advising(py, e, "the same call goes on with what is left"))?;
    Ok(plain(py, &found)?.unbind())
}

fn usable(threads: Option<usize>) -> PyResult<usize> {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    match threads.unwrap_or_else(cores) {
        threads @ 1..=256 => Ok(threads),
        threads => Err(refused("threads", threads, "1 to 256")),
    }
}

/// A study that reports its events to an observer.
struct Told<'h, 'a> {
    observer: &'h mut Observer<'a>,
    itself: Itself<'h>,
}

impl Host for Told<'_, '_> {
    fn begins(&mut self, costs: &[StudyCost]) {
        self.observer
            .tell(&json!({ "event": "study", "runs": costs }));
    }

    fn watch(&mut self, name: &str, _: &SweepPlan) -> Box<dyn Watch + '_> {
        Box::new(OfStudy {
            name: name.to_owned(),
            observer: self.observer,
        })
    }

    fn must_be_command(&self, words: &[String], writes: bool) -> Result<()> {
        self.itself.must_be_command(words, writes)
    }

    fn command(&mut self, words: &[String], folder: &Path) -> Result<Value> {
        self.itself.command(words, folder)
    }
}

struct OfStudy<'h, 'a> {
    name: String,
    observer: &'h Observer<'a>,
}

impl Watch for OfStudy<'_, '_> {
    fn event(&mut self, event: &SweepEvent) {
        let mut event = json!(event);
        event["of"] = json!(self.name);
        self.observer.tell(&event);
    }
}
