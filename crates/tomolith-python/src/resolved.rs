//! `ResolvedJob`: a job as objects, and what patterns print.

use crate::arrays::patterns;
use crate::task::Task;
use crate::work::{interruptible, plain};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use tomolith::grid::Patterns;
use tomolith::job;
use tomolith::metrics::Evaluation;
use tomolith::units::counted;

/// A job whose files are read and whose objects are built.
#[pyclass(module = "tomolith", frozen)]
pub(crate) struct ResolvedJob(Arc<job::ResolvedJob>);

impl ResolvedJob {
    pub(crate) fn new(job: job::ResolvedJob) -> Self {
        ResolvedJob(Arc::new(job))
    }
}

#[pymethods]
impl ResolvedJob {
    /// Counts of the job's voxels `(nz, ny, nx)`.
    #[getter]
    fn shape(&self) -> (usize, usize, usize) {
        self.0.grid().shape.into()
    }

    /// Edge of a voxel, mm.
    #[getter]
    fn pitch_mm(&self) -> f64 {
        self.0.grid().pitch_mm
    }

    /// What people should know, one sentence each.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.0.warnings().to_vec()
    }

    /// What an optimizer needs, on the finest voxels of the optimization.
    fn task(&self, py: Python<'_>) -> PyResult<Task> {
        let task = interruptible(py, |work| self.0.task(work))?;
        Ok(Task::new(task, Arc::clone(&self.0)))
    }

    /// What patterns print, measured as `tomolith run` does: `patterns` is a list with an array `[frame, row, column]` for each light,
    /// or the array of a single light. The response is that of the job, where a run with `co_optimize` finds another.
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        patterns: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let patterns = self::patterns(patterns, self.0.lights().iter().map(|light| &light.pixels))?;
        printed(py, &self.0, &patterns)
    }

    fn __repr__(&self) -> String {
        let [nz, ny, nx] = self.0.grid().shape;
        format!(
            "<tomolith.ResolvedJob: {nz} × {ny} × {nx} voxels, {}>",
            counted(self.0.lights().len(), "light")
        )
    }
}

/// The measures of a print, and the threshold that they belong to.
fn numbers<'py>(py: Python<'py>, evaluation: &Evaluation) -> PyResult<Bound<'py, PyDict>> {
    let numbers = PyDict::new(py);
    numbers.set_item("threshold", evaluation.gel_threshold)?;
    numbers.update(
        plain(py, &evaluation.measures)?
            .cast::<PyDict>()?
            .as_mapping(),
    )?;
    Ok(numbers)
}

/// What patterns print, as a dict.
pub(crate) fn printed<'py>(
    py: Python<'py>,
    job: &job::ResolvedJob,
    patterns: &[Patterns],
) -> PyResult<Bound<'py, PyDict>> {
    let print = interruptible(py, |work| job.evaluate(patterns, work))?;
    let of_print = numbers(py, &print.evaluation)?;
    let species = PyDict::new(py);
    for (name, evaluation) in &print.species {
        species.set_item(name, numbers(py, evaluation)?)?;
    }
    of_print.set_item("species", species)?;
    of_print.set_item("one_exposure", plain(py, &print.one_exposure)?)?;
    of_print.set_item("in_time", plain(py, &print.in_time)?)?;
    Ok(of_print)
}
