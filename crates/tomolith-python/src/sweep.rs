//! `sweep`: a job with many values of its keys.

use crate::work::{beside_telling, plain};
use pyo3::prelude::*;
use std::path::PathBuf;
use tomolith_sweep::{Sweep, run};

/// Runs a sweep file, as `tomolith sweep`: what it came to. What was finished before stays.
#[pyfunction]
#[pyo3(signature = (file, *, folder=None, threads=None, progress=None))]
pub(crate) fn sweep(
    py: Python<'_>,
    file: PathBuf,
    folder: Option<PathBuf>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Py<PyAny>> {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    let threads = threads.unwrap_or_else(cores).max(1);
    let outcome = beside_telling(py, progress, |told, cancel| {
        let mut sweep = Sweep::read(&file)?;
        if let Some(folder) = &folder {
            sweep = sweep.with_folder(folder);
        }
        run(&sweep.plan(threads, cancel)?, None, told, cancel)
    })?;
    Ok(plain(py, &outcome)?.unbind())
}
