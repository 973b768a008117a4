//! `sweep`: a job with many values of its keys.

use crate::work::{TomolithError, beside_telling, plain};
use pyo3::prelude::*;
use std::path::PathBuf;
use tomolith_sweep::{Sweep, run};

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
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    let threads = threads.unwrap_or_else(cores);
    if !(1..=256).contains(&threads) {
        let text = format!("threads: found {threads}; accepted: 1 to 256");
        return Err(TomolithError::new_err(text));
    }
    let outcome = beside_telling(py, (progress, cancel), |told, cancel| {
        let mut sweep = Sweep::read(&file)?;
        if let Some(folder) = &folder {
            sweep = sweep.with_folder(folder);
        }
        run(&sweep.plan(threads, cancel)?, None, told, cancel)
    })?;
    Ok(plain(py, &outcome)?.unbind())
}
