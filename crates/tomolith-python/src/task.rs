//! `Task`: the model, objective, start and bounds of a job over arrays, for loops of one's own.

use crate::arrays::{
    IMAGES, VOXELS, arrays, must_be_finite, must_be_light, of_patterns, of_volume, one_or_list,
    read_only,
};
use crate::resolved::printed;
use crate::work::{interruptible, must_have_threads, raised, refused};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use tomolith::dose::{PatternLayout, Quantity};
use tomolith::field::{Field, HostField};
use tomolith::grid::{Patterns, Volume};
use tomolith::job;
use tomolith::objective::Objective;

/// What an optimizer needs: dose model F, loss, start and bounds, on the finest voxels of the optimization.
///
/// Patterns are an array `[frame, row, column]`, or a list of one for each light where a job has several lights. Doses are an array
/// `[z, y, x]`, or a list of one for each species. All are float32; other real numbers are converted. Values of pixels that are not `lit` do
/// not count, and gradients are 0 there. A wrong shape or type, a masked array, NaN, and results beyond float32 raise `TomolithError`.
#[pyclass(module = "tomolith", frozen)]
pub(crate) struct Task {
    task: job::Task,
    job: Arc<job::ResolvedJob>,
    /// Where the unknowns lie in images, whether they are energies or amplitudes.
    lights: Vec<PatternLayout>,
}

impl Task {
    pub(crate) fn new(task: job::Task, job: Arc<job::ResolvedJob>) -> Self {
        let as_they_are = |layout: &PatternLayout| {
            let mut layout = layout.clone();
            layout.quantity = Quantity::Energy;
            layout
        };
        let lights = task.model.patterns().iter().map(as_they_are).collect();
        Task { task, job, lights }
    }

    fn unknowns(&self, what: &str, images: &Bound<'_, PyAny>) -> PyResult<HostField> {
        must_have_threads()?;
        let shapes: Vec<_> = self.lights.iter().map(|light| light.grid.shape()).collect();
        let images = arrays(what, IMAGES, images, &shapes)?;
        let mut x = self.task.start.zeros_like();
        for (light, values) in self.lights.iter().zip(images) {
            let grid = light.grid.clone();
            light.fill_field(&Patterns { grid, values }, x.as_mut_slice());
        }
        Ok(x)
    }

    fn images<'py>(&self, py: Python<'py>, what: &str, x: &[f32]) -> PyResult<Bound<'py, PyAny>> {
        must_have_threads()?;
        must_be_finite(what, x)?;
        let images = |light: &PatternLayout| of_patterns(py, light.patterns_of(x));
        one_or_list(py, self.lights.iter().map(images))
    }

    /// What doses weigh, as a field.
    fn cotangent(&self, doses: &Bound<'_, PyAny>) -> PyResult<HostField> {
        let outputs = self.task.model.outputs();
        let shapes: Vec<_> = outputs.iter().map(|output| output.grid.shape).collect();
        let doses = arrays("cotangent", VOXELS, doses, &shapes)?;
        let mut field = self.task.model.new_dose().map_err(raised)?;
        for (output, values) in outputs.iter().zip(doses) {
            let grid = output.grid.clone();
            let mut weights = output.field_of(&Volume { grid, values });
            if let Some(cells) = &output.cells {
                // The dose of a cut voxel is the mean of its cells
                let shares = cells.shares(weights.len());
                weights.iter_mut().zip(shares).for_each(|(w, s)| *w *= s);
            }
            field.as_mut_slice()[output.range()].copy_from_slice(&weights);
        }
        Ok(field)
    }
}

#[pymethods]
impl Task {
    /// Patterns that the job begins with.
    #[getter]
    fn start<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.images(py, "start", self.task.start.as_slice())
            .and_then(read_only)
    }

    /// Which pixels may be lit, as booleans in the shape of the patterns.
    #[getter]
    fn lit<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        must_have_threads()?;
        let ones = vec![1.0; self.task.start.len()];
        let lit = |light: &PatternLayout| {
            let image = light.patterns_of(&ones);
            let values = image.values.iter().map(|&v| v > 0.0).collect();
            numpy::PyArrayMethods::reshape(
                &numpy::PyArray1::<bool>::from_vec(py, values),
                image.grid.shape(),
            )
        };
        one_or_list(py, self.lights.iter().map(lit)).and_then(read_only)
    }

    /// What a pixel's value is: "energy" (areal dose over the exposure), or "amplitude", its square root, of models of coherent light.
    #[getter]
    fn quantity(&self) -> &'static str {
        match self.task.model.quantity() {
            Quantity::Energy => "energy",
            Quantity::Amplitude => "amplitude",
        }
    }

    /// Whether the dose is linear in the patterns.
    #[getter]
    fn is_linear(&self) -> bool {
        self.task.model.is_linear()
    }

    /// The species that doses are of, in their order.
    #[getter]
    fn outputs(&self) -> Vec<String> {
        let outputs = self.task.model.outputs().iter();
        outputs.map(|output| output.species.clone()).collect()
    }

    /// At how many angles of a frame, during which the vial turns on, the dose is averaged: a number for each light.
    #[getter]
    fn sub_angles(&self) -> Vec<usize> {
        self.task.sub_angles.clone()
    }

    /// Counts of voxels `(nz, ny, nx)`.
    #[getter]
    fn shape(&self) -> (usize, usize, usize) {
        self.task.labels.grid.shape.into()
    }

    /// Edge of the voxels across the axis, and along it, mm.
    #[getter]
    fn voxel_mm(&self) -> (f64, f64) {
        let grid = &self.task.labels.grid;
        (grid.pitch_mm, grid.height_mm)
    }

    /// Where the voxels lie, `((x, y, z), (x, y, z))`, mm: the lowest corner and the highest. Slices above and below the part are left out.
    #[getter]
    fn box_mm(&self) -> [(f64, f64, f64); 2] {
        self.task.labels.grid.bounds_mm().map(Into::into)
    }

    /// Least and largest value of each pixel, in the shape of the patterns; both are 0 where a pixel is not `lit`.
    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        must_have_threads()?;
        let bounds = self.task.bounds().map_err(raised)?;
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        for (len, low, high) in bounds.pieces() {
            lower.resize(lower.len() + len, low);
            upper.resize(upper.len() + len, high);
        }
        let images = |x: &[f32]| {
            let images = |light: &PatternLayout| of_patterns(py, light.patterns_of(x));
            one_or_list(py, self.lights.iter().map(images)).and_then(read_only)
        };
        Ok((images(&lower)?, images(&upper)?))
    }

    /// The share of each voxel that lies in the part, float32 `[z, y, x]`.
    #[getter]
    fn target<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        read_only(of_volume(py, self.task.target.inside.clone())?.into_any())
    }

    /// 2 where a voxel is part, 1 void, 0 where it does not count, uint8 `[z, y, x]`.
    #[getter]
    fn labels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        read_only(of_volume(py, self.task.labels.clone())?.into_any())
    }

    /// F(patterns), `[z, y, x]`. Negative values are allowed.
    fn dose<'py>(
        &self,
        py: Python<'py>,
        patterns: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let x = self.unknowns("patterns", patterns)?;
        let model = &self.task.model;
        let dose = interruptible(py, |work| {
            let mut dose = model.new_dose()?;
            model.dose(&x, &mut dose, work)?;
            Ok(dose)
        })?;
        must_be_finite("dose", dose.as_slice())?;
        let volumes = model.outputs().iter();
        one_or_list(
            py,
            volumes.map(|output| of_volume(py, output.volume_of(dose.as_slice()))),
        )
    }

    /// (∂F/∂patterns)ᵀ cotangent: the gradient with respect to `patterns` of any loss whose gradient with respect to the dose is
    /// `cotangent`, an array as `dose` returns it. Of a linear model it is the adjoint, whatever `patterns` are.
    fn pullback<'py>(
        &self,
        py: Python<'py>,
        patterns: &Bound<'py, PyAny>,
        cotangent: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let x = self.unknowns("patterns", patterns)?;
        let cotangent = self.cotangent(cotangent)?;
        let gradient = interruptible(py, |work| {
            let mut gradient = x.zeros_like();
            self.task
                .model
                .pullback(&x, &cotangent, &mut gradient, work)?;
            Ok(gradient)
        })?;
        self.images(py, "gradient", gradient.as_slice())
    }

    /// The job's loss with its penalties, and its gradient in the shape of the patterns.
    fn value_and_gradient<'py>(
        &self,
        py: Python<'py>,
        patterns: &Bound<'py, PyAny>,
    ) -> PyResult<(f64, Bound<'py, PyAny>)> {
        let x = self.unknowns("patterns", patterns)?;
        let job::Task {
            model,
            objective,
            penalties,
            ..
        } = &self.task;
        let (value, gradient) = interruptible(py, |work| {
            let mut dose = model.new_dose()?;
            let (mut cotangent, mut gradient) = (dose.zeros_like(), x.zeros_like());
            model.dose(&x, &mut dose, work)?;
            let loss = objective.value_and_gradient(&dose, &mut cotangent);
            model.pullback(&x, &cotangent, &mut gradient, work)?;
            let priced = penalties.add_gradient(&x, 1.0, &mut gradient);
            Ok((loss + priced, gradient))
        })?;
        if !value.is_finite() {
            return Err(refused("loss", value, "patterns whose loss is a number"));
        }
        Ok((value, self.images(py, "gradient", gradient.as_slice())?))
    }

    /// What patterns print, as `ResolvedJob.evaluate`.
    fn evaluate<'py>(
        &self,
        py: Python<'py>,
        patterns: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let energies = self.task.patterns(&self.unknowns("patterns", patterns)?);
        must_be_light(&energies)?;
        printed(py, &self.job, &energies)
    }

    /// A linear model as a `scipy.sparse.linalg.LinearOperator`: a column for each pixel, light by light, a row for each voxel, species by
    /// species, both in the order of `array.ravel()`. Needs SciPy.
    fn operator<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let module = slf.py().import("tomolith._operator")?;
        module.call_method1("operator", (slf,))
    }

    fn __repr__(&self) -> String {
        let [nz, ny, nx] = self.task.labels.grid.shape;
        let lit = self.task.start.len();
        format!("<tomolith.Task: {lit} pixels that may be lit, {nz} × {ny} × {nx} voxels>")
    }
}
