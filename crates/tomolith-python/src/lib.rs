//! Tomolith for Python: what `tomolith::job` offers, over numpy arrays. No physics and no algorithm is here.
//!
//! | Python | Rust |
//! |---|---|
//! | `Job` | [`tomolith::job::Job`] and the stages of a run; what these leave is the `Run` of `python/tomolith/_run.py` |
//! | `ResolvedJob` | [`tomolith::job::ResolvedJob`]: what patterns print, in time too |
//! | `Task` | [`tomolith::job::Task`]: model, objective, start and bounds, for loops of one's own |
//! | `sweep`, `reproduce` | [`tomolith_sweep::run`], [`tomolith_sweep::reproduce`] |
//! | the command `tomolith` | [`tomolith_cli::main_with`] |
//!
//! The package is `python/tomolith`, its manual docs/python.md. Calls leave Python's lock to other threads while they compute, and end at Ctrl-C.

mod arrays;
mod command;
mod job;
mod resolved;
mod sweep;
mod task;
mod work;

use pyo3::prelude::*;

/// The compiled part of the package `tomolith`.
#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add(
        "TomolithError",
        module.py().get_type::<work::TomolithError>(),
    )?;
    module.add("Canceled", module.py().get_type::<work::Canceled>())?;
    module.add_class::<job::Job>()?;
    module.add_class::<resolved::ResolvedJob>()?;
    module.add_class::<task::Task>()?;
    module.add_function(wrap_pyfunction!(work::forked, module)?)?;
    module.add_function(wrap_pyfunction!(command::command, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::reproduce, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::sweep, module)?)
}
