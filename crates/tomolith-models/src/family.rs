//! A family of dose models: what it covers, what it takes, what it builds.
//!
//! One file or folder a family, and one row in [`MODELS`](crate::MODELS). A [`ModelFamily`] is a family with its parameters, as the row reads
//! them from a job. The [planner](crate::planner) and the job ask it whatever they need to know, and know no family by name.

use super::parallel;
use super::rays::Rays;
use super::rays::matrix_cache::CachedEntries;
use super::rays::solid::Solid;
use super::scene::OpticalScene;
use super::{DoseModel, Work};
use std::fmt;
use std::sync::Arc;
use tomolith_core::dose::form::Form;
use tomolith_core::error::Result;
use tomolith_core::field::HostField;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::kind::{Kind, Section};
use tomolith_optics::light::Light;

/// A dose model in host memory.
pub type HostModel = Box<dyn DoseModel<Field = HostField>>;

/// A family with its parameters.
pub type Family = Arc<dyn ModelFamily>;

/// How a row of [`MODELS`](crate::MODELS) makes its family.
pub struct MakeFamily {
    /// From a section of a job.
    pub read: fn(&Section) -> Result<Family>,
    /// With default parameters, where a job names no model; None: only a job that names it gets it.
    pub unasked: Option<fn() -> Family>,
}

/// A row of [`MODELS`](crate::MODELS).
pub type ModelKind = Kind<MakeFamily>;

/// What the doses of a model are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Doses are computed again and again: the model stores between calls what saves time.
    Optimize,
    /// One dose that evaluates patterns, on voxels so many times as fine as the job's: sharper than the optimization's.
    Evaluate {
        /// How many times as fine.
        refine: usize,
    },
    /// One dose like those of the optimization.
    Probe,
}

/// What the models of a family are like.
#[derive(Clone, Copy, Debug)]
pub struct Capabilities {
    /// What is linear in the family's stead, for people; None: its dose is linear in the patterns.
    pub linear_instead: Option<&'static str>,
    /// Whether its light spreads and no rays stand for it: starts and shadows are found with straight light through the same pixels, its linear
    /// relative.
    pub has_surrogate: bool,
    /// What of its light predicts, when it is timed, the time of all.
    pub timed_by: TimedBy,
    /// Whether every pixel lights every voxel.
    pub fills: bool,
    /// Whether its pixels and voxels are those of a file, and no others.
    pub is_stored: bool,
    /// Whether straight resin weakens all light of a frame along the frame's direction, so that resin which absorbs more can do so afterwards.
    pub is_along_frames: bool,
    /// Whether what becomes of its rays is to be looked at before any work.
    pub is_traced: bool,
    /// Whether a target's surface may cut its voxels into cells.
    pub has_cells: bool,
    /// Which voxels the program may make finer than the job's.
    pub refines: Refines,
}

/// What of a model's light is timed to predict the time of all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimedBy {
    /// Groups of neighboring frames, which its kernel takes together.
    NeighboringFrames,
    /// Single frames: all pixels of a frame are taken together.
    Frames,
    /// Single pixels.
    Pixels,
}

/// Which voxels of a model the program may make finer than a job's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refines {
    /// None.
    Nothing,
    /// Whole ones.
    Voxels,
    /// Those that a surface cuts into cells.
    Cells,
}

impl Default for Capabilities {
    fn default() -> Self {
        Capabilities {
            linear_instead: None,
            has_surrogate: false,
            timed_by: TimedBy::NeighboringFrames,
            fills: false,
            is_stored: false,
            is_along_frames: false,
            is_traced: false,
            has_cells: false,
            refines: Refines::Nothing,
        }
    }
}

impl Capabilities {
    /// Whether the dose is linear in the patterns.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        self.linear_instead.is_none()
    }
}

/// Memory of a model in addition to patterns and doses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// The stored rays, where they are few ([`Rays::cached`]); None of a model that stores none.
    pub cached_entries: Option<CachedEntries>,
    /// What else is stored between the calls of an optimization, bytes, 0 where that is too much; None of a model that stores nothing.
    pub cached_bytes: Option<f64>,
    /// Entries along which a call of an optimization sums, where these are stored, as a measure of its time; 0 elsewhere.
    pub entries: f64,
    /// Memory of frames at work, bytes; 0 where that is little.
    pub working_bytes: usize,
    /// Whether the kernel runs along the rows of pixels where these are fewer than slices of voxels.
    pub runs_along_rows: bool,
}

/// Monte Carlo paths of a family.
pub struct MonteCarloPaths {
    /// Of a pixel in a frame, in the optimization.
    pub optimizing: usize,
    /// Paths of a pixel in what is reported.
    pub evaluating: usize,
    /// The family with other paths, for every purpose.
    pub redrawn: Family,
}

/// What a model is built of.
#[derive(Clone)]
pub struct ModelInput<'a> {
    /// Vial, lights, and what is between them.
    pub scene: OpticalScene<'a>,
    /// The voxels.
    pub grid: &'a VolumeGrid,
    /// What cuts them into cells; None: whole voxels.
    pub cells: Option<Arc<Solid>>,
    /// The run that building is a part of.
    pub work: &'a Work,
}

impl<'a> ModelInput<'a> {
    /// Of a scene on a grid; cuts voxels into cells where the scene has a shape.
    ///
    /// # Errors
    /// As [`Solid::new`].
    pub fn new(scene: OpticalScene<'a>, grid: &'a VolumeGrid, work: &'a Work) -> Result<Self> {
        let cells = scene.solid.map(|shape| Solid::new(shape, grid));
        Ok(ModelInput {
            scene,
            grid,
            cells: cells.transpose()?.map(Arc::new),
            work,
        })
    }

    /// The input with other pixels of its lights.
    pub(crate) fn lit_by<'b>(&'b self, lights: &'b [Light]) -> ModelInput<'b> {
        let scene = self.scene.lit_by(lights);
        let cells = self.cells.clone();
        ModelInput {
            scene,
            cells,
            ..*self
        }
    }

    /// Rays, with cells where a surface cuts voxels.
    pub(crate) fn with_cells(&self, model: Rays) -> Rays {
        match &self.cells {
            Some(cells) => model.with_cells(Arc::clone(cells)),
            None => model,
        }
    }
}

/// A family of dose models with its parameters: all that the planner and a job ask of it.
pub trait ModelFamily: fmt::Debug + Send + Sync {
    /// Its name in job files.
    fn name(&self) -> &'static str;

    /// What its models are like.
    fn capabilities(&self) -> Capabilities {
        Capabilities::default()
    }

    /// Why it cannot give the dose of a scene on a grid; None: it can. Asked before anything else.
    fn unsupported(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Option<&'static str>;

    /// What a job that names it may have instead where it is [unsupported](Self::unsupported).
    fn instead(&self) -> &'static str {
        "another model, or no [model] for the cheapest that is exact"
    }

    /// Refuses parameters that do not fit a scene, before any work; returns the notes on those that do.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) of numbers that contradict each other.
    fn check(&self, _scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Result<Vec<String>> {
        Ok(Vec::new())
    }

    /// Memory of a model in addition to patterns and doses, before it is built.
    ///
    /// # Errors
    /// As [`check`](Self::check).
    fn cost(&self, _scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Result<Cost> {
        Ok(Cost::default())
    }

    /// The model, for the purpose of the scene.
    ///
    /// # Errors
    /// What the model refuses; [`Error::Canceled`](tomolith_core::Error::Canceled).
    fn build(&self, input: &ModelInput<'_>) -> Result<HostModel>;

    /// The model as data, for a backend that computes it elsewhere; None where it has no such form.
    ///
    /// # Errors
    /// As [`build`](Self::build).
    fn form(&self, _input: &ModelInput<'_>) -> Result<Option<Form>> {
        Ok(None)
    }

    /// The model of [`unscattered`](Self::unscattered) light as data.
    ///
    /// # Errors
    /// As [`build`](Self::build).
    fn unscattered_form(&self, input: &ModelInput<'_>) -> Result<Option<Form>> {
        if self.capabilities().has_surrogate {
            return parallel::Params::default().form(input);
        }
        self.form(input)
    }

    /// Whether a model for [`Purpose::Optimize`] has the doses, to the bit, of one for [`Purpose::Evaluate`] on the same voxels, and stores no more
    /// between calls, so that one model serves both.
    fn evaluates_alike(&self, _scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> bool {
        false
    }

    /// The model of its light that is not scattered and does not spread: which pixels can meet a voxel, in one call.
    ///
    /// # Errors
    /// As [`build`](Self::build).
    fn unscattered(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        if self.capabilities().has_surrogate {
            return parallel::Params::default().build(input);
        }
        let mut input = input.clone();
        input.scene.purpose = Purpose::Probe;
        self.build(&input)
    }

    /// Single rays of the same light, to see where it goes; None where no rays stand for it.
    fn rays(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Option<Result<Rays>> {
        (!self.capabilities().has_surrogate).then(|| scene.rays(grid))
    }

    /// What it draws at random; None: nothing.
    fn monte_carlo_paths(&self) -> Option<MonteCarloPaths> {
        None
    }

    /// The Monte Carlo paths that its scattered light is compared with, so many of a pixel and drawn from a seed; None where it claims to be
    /// exact.
    fn compared_with(&self) -> Option<fn(paths_per_pixel: usize, seed: u64) -> Family> {
        None
    }

    /// What to say of it where no cheaper family is in question.
    fn merit(&self) -> String {
        "as the job names it".to_owned()
    }

    /// What to say where a job names it though a cheaper family covers the scene, too.
    fn despite(&self, cheaper: &str, _scene: &OpticalScene<'_>) -> String {
        format!("as the job names it; [model.{cheaper}] covers these optics too and is faster")
    }
}
