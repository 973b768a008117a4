//! `ResolvedJob` and `Task`: a job as objects, for loops of one's own.

use crate::arrays::{field, of_field, of_patterns, of_volume, patterns};
use crate::work::{TomolithError, beside, plain, raised};
use numpy::{PyArray1, PyArray3};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use tomolith::field::Field;
use tomolith::job;
use tomolith::metrics::Evaluation;
use tomolith::objective::Objective;
use tomolith::objective::penalty::PatternPenalty;
use tomolith::units::counted;

/// Elements of a field.
type Vector<'py> = Bound<'py, PyArray1<f32>>;

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
        let task = beside(py, |run| self.0.task(run))?;
        Ok(Task {
            task,
            job: Arc::clone(&self.0),
        })
    }

    /// What patterns print, measured as `tomolith run` does: `patterns` is a list with an array `[frame, row, column]` for each light,
    /// or the array of a single light.
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        patterns: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let patterns = self::patterns(patterns, self.0.lights().iter().map(|light| &light.pixels))?;
        let print = beside(py, |run| self.0.evaluate(&patterns, run))?;
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

/// What an optimizer needs: x are the pixels that may be lit, d the doses of the voxels, both float32 with one axis.
#[pyclass(module = "tomolith", frozen)]
pub(crate) struct Task {
    task: job::Task,
    job: Arc<job::ResolvedJob>,
}

#[pymethods]
impl Task {
    /// Where the job begins.
    #[getter]
    fn start<'py>(&self, py: Python<'py>) -> PyResult<Vector<'py>> {
        of_field(py, "start", &self.task.start)
    }

    /// Counts of the voxels of the optimization `(nz, ny, nx)`: those of `target`, `labels` and `volumes`.
    #[getter]
    fn shape(&self) -> (usize, usize, usize) {
        self.task.labels.grid.shape.into()
    }

    /// Edge of those voxels across the axis, and along it, mm.
    #[getter]
    fn voxel_mm(&self) -> (f64, f64) {
        let grid = &self.task.labels.grid;
        (grid.pitch_mm, grid.height_mm)
    }

    /// Where they lie, `((x, y, z), (x, y, z))`, mm: the lowest corner and the highest. Slices that only light beside the part reaches are left out.
    #[getter]
    fn box_mm(&self) -> [(f64, f64, f64); 2] {
        self.task.labels.grid.bounds_mm().map(Into::into)
    }

    /// Lower and upper bound of each element of x.
    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<(Vector<'py>, Vector<'py>)> {
        let bounds = self.task.bounds().map_err(raised)?;
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        for (len, low, high) in bounds.pieces() {
            lower.resize(lower.len() + len, low);
            upper.resize(upper.len() + len, high);
        }
        Ok((PyArray1::from_vec(py, lower), PyArray1::from_vec(py, upper)))
    }

    /// The inside fraction of each voxel, `[z, y, x]`.
    #[getter]
    fn target<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<f32>>> {
        of_volume(py, &self.task.target.inside)
    }

    /// 2 where a voxel is part, 1 void, 0 where it does not count, `[z, y, x]`.
    #[getter]
    fn labels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray3<u8>>> {
        of_volume(py, &self.task.labels)
    }

    /// d = F(x)
    fn dose<'py>(&self, py: Python<'py>, x: &Bound<'py, PyAny>) -> PyResult<Vector<'py>> {
        let x = field("x", x, self.task.start.len())?;
        let dose = beside(py, |run| {
            let mut dose = self.task.model.new_dose()?;
            self.task.model.dose(&x, &mut dose, run)?;
            Ok(dose)
        })?;
        of_field(py, "dose", &dose)
    }

    /// (∂F/∂x)ᵀ c at x: the adjoint of a model that is linear.
    fn pullback<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        cotangent: &Bound<'py, PyAny>,
    ) -> PyResult<Vector<'py>> {
        let x = field("x", x, self.task.start.len())?;
        let model = &self.task.model;
        let len = model.new_dose().map_err(raised)?.len();
        let cotangent = field("cotangent", cotangent, len)?;
        let gradient = beside(py, |run| {
            let mut gradient = x.zeros_like();
            model.pullback(&x, &cotangent, &mut gradient, run)?;
            Ok(gradient)
        })?;
        of_field(py, "gradient", &gradient)
    }

    /// Loss and its gradient at x, penalties included.
    fn value_and_gradient<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
    ) -> PyResult<(f64, Vector<'py>)> {
        let x = field("x", x, self.task.start.len())?;
        let job::Task {
            model,
            objective,
            penalties,
            ..
        } = &self.task;
        let (value, gradient) = beside(py, |run| {
            let mut dose = model.new_dose()?;
            let (mut cotangent, mut gradient) = (dose.zeros_like(), x.zeros_like());
            model.dose(&x, &mut dose, run)?;
            let loss = objective.value_and_gradient(&dose, &mut cotangent);
            model.pullback(&x, &cotangent, &mut gradient, run)?;
            Ok((
                loss + penalties.add_gradient(&x, 1.0, &mut gradient),
                gradient,
            ))
        })?;
        if !value.is_finite() {
            return Err(TomolithError::new_err(format!(
                "loss: found {value}; accepted: patterns whose loss is a number"
            )));
        }
        Ok((value, of_field(py, "gradient", &gradient)?))
    }

    /// The images in x: an array `[frame, row, column]` for each light.
    fn patterns<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
    ) -> PyResult<Vec<Bound<'py, PyArray3<f32>>>> {
        let x = field("x", x, self.task.start.len())?;
        self.task
            .patterns(&x)
            .iter()
            .map(|patterns| of_patterns(py, patterns))
            .collect()
    }

    /// The x of such images; pixels that stay dark are left out.
    fn pixels<'py>(&self, py: Python<'py>, patterns: &Bound<'py, PyAny>) -> PyResult<Vector<'py>> {
        let layouts = self.task.model.patterns();
        let patterns = self::patterns(patterns, layouts.iter().map(|layout| &layout.grid))?;
        let mut x = self.task.start.zeros_like();
        for (layout, patterns) in layouts.iter().zip(&patterns) {
            layout.fill_field(patterns, x.as_mut_slice());
        }
        of_field(py, "x", &x)
    }

    /// The volumes in d: an array `[z, y, x]` for each output.
    fn volumes<'py>(
        &self,
        py: Python<'py>,
        dose: &Bound<'py, PyAny>,
    ) -> PyResult<Vec<Bound<'py, PyArray3<f32>>>> {
        let model = &self.task.model;
        let dose = field("dose", dose, model.new_dose().map_err(raised)?.len())?;
        let outputs = model.outputs().iter();
        outputs
            .map(|output| of_volume(py, &output.volume_of(dose.as_slice())))
            .collect()
    }

    /// What the images in x print: [`ResolvedJob.evaluate`] of them.
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let patterns = self.patterns(py, x)?;
        let job = ResolvedJob(Arc::clone(&self.job));
        job.evaluate(py, patterns.into_pyobject(py)?.as_any())
    }

    fn __repr__(&self) -> String {
        format!("<tomolith.Task of {} pixels>", self.task.start.len())
    }
}
