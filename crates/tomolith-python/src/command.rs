//! The command `tomolith`, which the wheel brings along: `python/tomolith/__main__.py` calls it.

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the command; `words` are those of its line, `itself` start it anew. Returns its exit code.
#[pyfunction(name = "_command")]
pub(crate) fn command(py: Python<'_>, words: Vec<OsString>, itself: Vec<OsString>) -> u8 {
    py.detach(|| tomolith_cli::main_with(&words, &itself))
}
