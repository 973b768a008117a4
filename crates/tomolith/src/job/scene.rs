//! What a job is about, before any heavy work: the shape, the optics, the grid, and what they will cost.

use super::build::Optics;
use super::estimate::Extent;
use super::folder::RunFolder;
use super::read::Job;
use super::resources::{available_disk_mb, available_memory_mb, require};
use super::spec::{GridSpec, JobSpec};
use crate::error::{Error, Result};
use crate::field::HostField;
use crate::grid::{Volume, VolumeGrid};
use crate::kind::Section;
use crate::models::DoseLayout;
use crate::objective::{OBJECTIVES, Objective, ObjectiveInput, Sum};
use crate::optimize::start::{STARTS, Start};
use crate::optimize::{OPTIMIZERS, Optimizer};
use crate::response::{RESPONSES, Response};
use crate::target::{self, Resolution, Role, Shape, Target, default_grid, label, label_voxels};
use serde_json::Value;
use std::sync::Arc;

/// Least memory of a quasi-Newton method that is still worth having.
const LEAST_MEMORY: usize = 3;
/// Share of the free memory that a run may plan with.
const USABLE: f64 = 0.9;

/// A job that can be run.
pub(crate) struct Scene {
    /// The tables; the optimiser's memory may have been lowered.
    pub(crate) spec: JobSpec,
    /// Name of the part.
    pub(crate) name: String,
    /// The shape.
    pub(crate) shape: Box<dyn Shape>,
    /// Vial and lights.
    pub(crate) optics: Optics,
    /// Voxels of the optimisation.
    pub(crate) grid: VolumeGrid,
    /// How large it all is.
    pub(crate) extent: Extent,
    /// Choices that were made.
    pub(crate) notes: Vec<String>,
    /// What may be wrong.
    pub(crate) warnings: Vec<String>,
}

/// The target on a grid.
pub(crate) struct Voxels {
    pub(crate) target: Target,
    pub(crate) labels: Volume<u8>,
}

impl Scene {
    /// Reads the target and refuses whatever can be refused before heavy work.
    ///
    /// # Errors
    /// Everything of the sections "Bad input": see [`Error`].
    pub(crate) fn new(job: &Job) -> Result<Self> {
        Self::of_spec(job).map_err(|e| job.locate(e))
    }

    fn of_spec(job: &Job) -> Result<Self> {
        let spec = job.spec.clone();
        RunFolder::check(&job.folder())?;
        let optics = Optics::new(&spec)?;
        try_kinds(&spec)?;
        let shape =
            target::build(&spec.target, &job.base(), "target").map_err(|e| at_target(&spec, e))?;
        optics.must_hold(shape.as_ref())?;
        let grid = grid_of(&spec, &optics, shape.as_ref())?;
        let memory = quasi_newton_memory(&job.resolved().optimizer).unwrap_or(0);
        let extent = Extent::new(
            &optics,
            &grid,
            shape.bounds_mm(),
            spec.evaluate.refine,
            memory,
        );
        let mut scene = Scene {
            name: spec.target.name(),
            warnings: shape.warnings(),
            notes: Vec::new(),
            spec,
            shape,
            optics,
            grid,
            extent,
        };
        if scene.spec.resin.pure_radon && scene.spec.resin.absorption_per_mm > 0.0 {
            scene
                .warnings
                .push("resin.pure_radon = true: the absorption is not used".to_owned());
        }
        scene.fit_memory()?;
        let disk = available_disk_mb(&job.folder());
        require(
            "disk for the run folder",
            scene.extent.disk_mb(),
            disk,
            "free some, or choose another output.folder",
        )?;
        Ok(scene)
    }

    /// Lowers the optimiser's memory and the refinement of the evaluation until both fit, and says so.
    fn fit_memory(&mut self) -> Result<()> {
        let free = available_memory_mb().map(|mb| (mb as f64 * USABLE) as u64);
        let fits = |needed: u64| free.is_none_or(|free| needed <= free);
        let asked = self.extent.memory;
        while !fits(self.extent.optimisation_mb()) && self.extent.memory > LEAST_MEMORY {
            self.extent.memory -= 1;
        }
        if self.extent.memory < asked {
            let memory = self.extent.memory;
            set_quasi_newton_memory(&mut self.spec.optimizer, memory);
            self.notes.push(format!(
                "memory is short: optimizer.lbfgs.memory is {memory}, not {asked}"
            ));
        }
        let asked = self.extent.refine;
        while !fits(self.extent.evaluation_mb()) && self.extent.refine > 1 {
            self.extent.refine -= 1;
        }
        if self.extent.refine < asked {
            let refine = self.extent.refine;
            self.notes.push(format!(
                "memory is short: the evaluation's grid is {refine} times as fine, not {asked}"
            ));
        }
        let advice = "take a larger grid.pitch_mm, or fewer light.angles or pixels";
        require(
            "memory for the optimisation",
            self.extent.optimisation_mb(),
            free,
            advice,
        )?;
        require(
            "memory for the evaluation",
            self.extent.evaluation_mb(),
            free,
            advice,
        )
    }

    /// The finer grid of the evaluation.
    pub(crate) fn fine_grid(&self) -> VolumeGrid {
        self.grid.refined(self.extent.refine)
    }

    /// The target on a grid.
    ///
    /// # Errors
    /// As [`target::voxelise`].
    pub(crate) fn voxels(&self, grid: &VolumeGrid) -> Result<Voxels> {
        let target = target::voxelise(self.shape.as_ref(), &self.name, grid)?;
        let mut labels = label_voxels(
            &target,
            self.optics.counts(self.spec.grid.region, &self.grid),
        );
        // There is no resin in an insert
        if let Some(insert) = self.shape.body(Role::Insert) {
            let inside = insert.sample(grid)?.values;
            for (label, inside) in labels.values.iter_mut().zip(inside) {
                *label = if inside >= 0.5 {
                    label::OUTSIDE
                } else {
                    *label
                };
            }
        }
        Ok(Voxels { target, labels })
    }

    /// Voxels that no light may pass, when the target has any.
    ///
    /// # Errors
    /// As [`target::voxelise`].
    pub(crate) fn keep_dark(&self, grid: &VolumeGrid) -> Result<Option<Volume<bool>>> {
        let sampled = self
            .shape
            .body(Role::KeepDark)
            .map(|dark| dark.sample(grid));
        Ok(sampled.transpose()?.map(|inside| Volume {
            grid: inside.grid,
            values: inside.values.iter().map(|&s| s >= 0.5).collect(),
        }))
    }

    /// The response of the material.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn response(&self) -> Result<Arc<dyn Response>> {
        response(&self.spec)
    }

    /// The sum of the job's objectives.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn objective(&self, layout: &DoseLayout, voxels: &Voxels) -> Result<Sum<HostField>> {
        let Voxels { target, labels } = voxels;
        objectives(
            &self.spec,
            &ObjectiveInput {
                layout,
                labels,
                target,
                response: self.response()?,
            },
        )
    }

    /// The optimiser.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn optimizer(&self) -> Result<Box<dyn Optimizer<HostField>>> {
        optimizer(&self.spec)
    }

    /// Where the optimiser begins.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn start(&self) -> Result<Box<dyn Start>> {
        start(&self.spec)
    }
}

impl Voxels {
    /// Voxels that should get dose: 1 where something is to be printed, else 0.
    pub(crate) fn wanted(&self) -> Volume<u8> {
        let (labels, inside) = (&self.labels.values, &self.target.inside.values);
        let wanted = |(&l, &s): (&u8, &f32)| {
            u8::from(l == label::PART || (self.target.grey && l == label::VOID && s > 0.0))
        };
        Volume {
            grid: self.labels.grid.clone(),
            values: labels.iter().zip(inside).map(wanted).collect(),
        }
    }
}

fn response(spec: &JobSpec) -> Result<Arc<dyn Response>> {
    let section = Section::new("response", spec.response.clone());
    let (kind, inner) = section.kind(RESPONSES)?;
    Ok(Arc::from((kind.build)(&inner)?))
}

fn optimizer(spec: &JobSpec) -> Result<Box<dyn Optimizer<HostField>>> {
    let section = Section::new("optimizer", spec.optimizer.clone());
    let (kind, inner) = section.kind(OPTIMIZERS)?;
    (kind.build)(&inner)
}

fn start(spec: &JobSpec) -> Result<Box<dyn Start>> {
    let section = Section::new("start", spec.start.clone());
    let (kind, inner) = section.kind(STARTS)?;
    (kind.build)(&inner)
}

/// Says which key named the file that could not be read.
fn at_target(spec: &JobSpec, error: Error) -> Error {
    let key = match (&spec.target.mesh, &spec.target.stack) {
        (Some(_), _) => "target.mesh",
        (None, Some(_)) => "target.stack",
        (None, None) => "target.image",
    };
    match error {
        Error::Io { .. } => Error::config(key, error.to_string(), "a file that can be read"),
        Error::Mesh { ref accepted, .. } | Error::Format { ref accepted, .. } => {
            let accepted = accepted.clone();
            let text = error.to_string();
            let found = text
                .split("; accepted: ")
                .next()
                .unwrap_or(&text)
                .to_owned();
            Error::config(key, found, accepted)
        }
        other => other,
    }
}

fn objectives(spec: &JobSpec, input: &ObjectiveInput<'_>) -> Result<Sum<HostField>> {
    let mut parts: Vec<(f64, Box<dyn Objective<HostField>>)> = Vec::new();
    for mut section in spec.objectives()? {
        let weight = section
            .value
            .as_object_mut()
            .and_then(|map| map.remove("weight"));
        let weight = match weight {
            None => 1.0,
            Some(value) => value.as_f64().ok_or_else(|| {
                Error::config(
                    format!("{}.weight", section.path),
                    format!("found {value}"),
                    "a number, 0 or more",
                )
            })?,
        };
        let (kind, inner) = section.kind(OBJECTIVES)?;
        parts.push((weight, (kind.build)(&inner, input)?));
    }
    Sum::new(parts)
}

/// Builds every kind once on a few voxels, so that bad parameters are refused before heavy work.
fn try_kinds(spec: &JobSpec) -> Result<()> {
    let grid = VolumeGrid::centered([4, 4, 4], 0.1);
    let layout = DoseLayout::new("dose", grid.clone(), 0);
    let target = Target {
        name: String::new(),
        inside: Volume::filled(grid, 1.0),
        grey: false,
    };
    let labels = label_voxels(&target, |_| true);
    let response = response(spec)?;
    objectives(
        spec,
        &ObjectiveInput {
            layout: &layout,
            labels: &labels,
            target: &target,
            response,
        },
    )?;
    optimizer(spec)?;
    start(spec).map(drop)
}

/// The grid of a job: given, or round the target and cut by the resin.
fn grid_of(spec: &JobSpec, optics: &Optics, shape: &dyn Shape) -> Result<VolumeGrid> {
    let bounds = shape.bounds_mm();
    let under = |e: Error| e.under("grid");
    let GridSpec {
        pitch_mm,
        shape: counts,
        ..
    } = &spec.grid;
    match (pitch_mm, counts) {
        (Some(pitch), Some([x, y, z])) => Ok(VolumeGrid {
            shape: [*z, *y, *x],
            pitch_mm: pitch.0,
            center_mm: [0.0, 0.0, (bounds[0][2] + bounds[1][2]) / 2.0],
        }),
        (None, Some(counts)) => default_grid(bounds, Resolution::Shape(*counts)).map_err(under),
        (pitch, None) => {
            let pitch = pitch.map_or(optics.lights[0].pixels.pitch_mm, |pitch| pitch.0);
            let grid = default_grid(bounds, Resolution::Pitch(pitch)).map_err(under)?;
            Ok(cut(&grid, optics.vial.resin_wall().inscribed_radius()))
        }
    }
}

/// Without the rows and columns that lie wholly beyond `limit` from the axis.
fn cut(grid: &VolumeGrid, limit: f64) -> VolumeGrid {
    let mut cut = grid.clone();
    for (axis, dimension) in [(0, 2), (1, 1)] {
        let half = |n: usize| n as f64 * grid.pitch_mm / 2.0;
        let (n, center) = (grid.shape[dimension], grid.center_mm[axis]);
        let beyond =
            |reach: f64| (((reach - limit) / grid.pitch_mm).floor().max(0.0) as usize).min(n / 2);
        let (high, low) = (beyond(half(n) + center), beyond(half(n) - center));
        cut.shape[dimension] = n - high - low;
        cut.center_mm[axis] = center + half(low) - half(high);
    }
    cut
}

/// The parameter `memory` of the one kind of a section, when it has one.
fn quasi_newton_memory(section: &Value) -> Option<usize> {
    let memory = section
        .as_object()?
        .values()
        .next()?
        .get("memory")?
        .as_u64()?;
    usize::try_from(memory).ok()
}

fn set_quasi_newton_memory(section: &mut Value, memory: usize) {
    if let Value::String(name) = section {
        *section = Value::Object(
            [(name.clone(), Value::Object(serde_json::Map::new()))]
                .into_iter()
                .collect(),
        );
    }
    if let Some(Value::Object(parameters)) = section
        .as_object_mut()
        .and_then(|map| map.values_mut().next())
    {
        parameters.insert("memory".to_owned(), memory.into());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_is_cut_by_the_resin_and_stays_where_it_was() {
        let grid = VolumeGrid {
            shape: [3, 40, 50],
            pitch_mm: 0.1,
            center_mm: [0.3, 0.0, 1.0],
        };
        let cut = cut(&grid, 1.95);
        // x from −2.2 to 2.8 keeps whole voxels up to beyond ±1.95: −2.0 … 2.0; y from −2 to 2 stays
        assert_eq!(cut.shape, [3, 40, 40]);
        let [low, high] = cut.bounds_mm();
        assert!(
            (low[0] + 2.0).abs() < 1e-12 && (high[0] - 2.0).abs() < 1e-12,
            "{low:?} {high:?}"
        );
        assert_eq!(super::cut(&grid, 10.0), grid);
    }

    #[test]
    fn the_memory_of_a_quasi_newton_method_is_found_and_lowered() {
        let mut section = serde_json::json!({ "lbfgs": { "memory": 10 } });
        assert_eq!(quasi_newton_memory(&section), Some(10));
        set_quasi_newton_memory(&mut section, 4);
        assert_eq!(quasi_newton_memory(&section), Some(4));
        assert_eq!(
            quasi_newton_memory(&serde_json::json!({ "gradient": {} })),
            None
        );
    }
}
