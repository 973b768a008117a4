//! The tables of a job, typed: names, units, defaults and meaning of every key.
//!
//! Tables that name a kind (`[vial.cylinder]`, `[objective.threshold]`, …) keep their content as it stands; the
//! family's own table of kinds reads and checks it (see [`crate::job::spec::kinds`]). The range of a number stands at its key; what keys mean together is
//! checked in [`crate::job::spec::validate`].
//!
//! Paths of meshes and images are relative to the job file; `output.folder` is relative to the current folder.

pub(crate) mod all_errors;
mod angles;
pub mod document;
pub(crate) mod file_names;
pub mod import;
pub(crate) mod job_files;
pub mod kinds;
mod light;
mod material;
pub(crate) mod not_finite;
pub(crate) mod output;
pub mod profiles;
pub mod read;
pub mod reference_page;
mod resin;
pub(crate) mod scenario;
pub mod schema;
mod search;
pub(crate) mod species;
pub mod validate;
mod vial;

use crate::error::{Error, Result};
use crate::exposure::PrinterSpec;
pub use crate::exposure::Rotation;
use crate::kind::{MISSING, Section};
use crate::optimize::checkpoint;
use crate::target::TargetSpec;
use crate::units::{Mm, concise};
pub use angles::Angles;
use document::Document;
pub use light::{
    LightBoundsSpec, LightPrinterSpec, LightResinSpec, LightSpec, ProjectorSpec, SelectionSpec,
};
pub use material::{Against, DiffusionSpec, MaterialSpec, PropertySpec, ScheduleSpec, SpeciesSpec};
pub use output::{EvaluateSpec, Levelling, MovieCoding, OutputSpec, VolumeFormat};
pub use resin::{DoseConvention, MapSpec, ResinSpec};
use schemars::JsonSchema;
pub use search::{
    BoundsSpec, Ceiling, CeilingTolerance, CoOptimizeSpec, MultiresolutionSpec, RobustOf,
    RobustSpec, ScenarioSpec, StopSpec,
};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
pub use vial::{BathSpec, MotionSpec, ObstacleSpec, VialCommon, VialSpec};

/// A whole job.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobSpec {
    /// What should be printed.
    pub target: TargetSpec,
    /// The voxels on which the dose is computed.
    #[serde(default)]
    pub grid: GridSpec,
    /// The photosensitive material.
    pub resin: ResinSpec,
    /// What stands around the resin, `[vial.KIND]`.
    pub vial: VialSpec,
    /// An absorbing bath round the vial; its index is `vial.surrounding_index`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bath: Option<BathSpec>,
    /// How the vial moves before the projectors.
    #[serde(default, skip_serializing_if = "is_default")]
    pub motion: MotionSpec,
    /// Bodies in the light.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<ObstacleSpec>,
    /// How light becomes dose, `[model.KIND]`; the cheapest model that is exact for the optics when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model: Option<Value>,
    /// One table `[[light]]` per projector or wavelength.
    pub light: Vec<LightSpec>,
    /// What hardens in the resin, one table `[[species]]` per network: its own lights, target, objective and response. One species that all
    /// lights drive alike when left out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub species: Vec<SpeciesSpec>,
    /// What the resin becomes in the light over time; with a schedule and without this table, solid at its critical dose.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<MaterialSpec>,
    /// When which frame shines, and how strongly: with it, runs and simulations print in time, too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub schedule: Option<ScheduleSpec>,
    /// Properties of the printed material, one table `[[property]]` each: maps of what the species respond with.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub property: Vec<PropertySpec>,
    /// What is minimized: one kind, `[objective.KIND]`. When there is none: `threshold`, and `l2` for a gray image, whose
    /// values are to be reproduced.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Value>,
    /// Several objectives that are summed, `[[objectives]]` with one kind each; in place of `objective`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objectives: Option<Vec<Value>>,
    /// What may be otherwise than the job says, one table `[[scenario]]` each: the patterns are optimized for the job and all of these.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub scenario: Vec<ScenarioSpec>,
    /// What is minimized over the scenarios.
    #[serde(default, skip_serializing_if = "is_default")]
    pub robust: RobustSpec,
    /// Penalties on the patterns, `[[penalties]]` with one kind each and `weight`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub penalties: Vec<Value>,
    /// The material's response to the dose, `[response.KIND]`.
    #[serde(default = "identity")]
    pub response: Value,
    /// Parameters of the response that are found together with the patterns; none when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub co_optimize: Option<CoOptimizeSpec>,
    /// The method that minimizes the objective, `[optimizer.KIND]`.
    #[serde(default = "lbfgs")]
    pub optimizer: Value,
    /// The patterns to start from, `[start.KIND]`.
    #[serde(default = "fbp")]
    pub start: Value,
    /// Coarser levels that the optimization starts on; none when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub multiresolution: Option<MultiresolutionSpec>,
    /// Limits of the pattern values.
    #[serde(default)]
    pub bounds: BoundsSpec,
    /// When the optimization ends.
    #[serde(default)]
    pub stop: StopSpec,
    /// Checkpoints, from which an interrupted run continues.
    #[serde(default)]
    pub checkpoint: checkpoint::Params,
    /// How the written patterns are evaluated.
    #[serde(default)]
    pub evaluate: EvaluateSpec,
    /// The machine that shows the patterns; without it they are shown as they are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub printer: Option<PrinterSpec>,
    /// How much of the computer the run may use.
    #[serde(default, skip_serializing_if = "is_default")]
    pub resources: ResourcesSpec,
    /// What is written, and where.
    #[serde(default)]
    pub output: OutputSpec,
}

tomolith_core::keys! {
    /// What a run may use of the computer.
    #[derive(PartialEq)]
    pub struct ResourcesSpec {
        /// Memory that the run plans with, GB (10⁹ bytes); 80 % of the computer's, or of its container's, when left out. A job that needs more is
        /// refused before any work. Results do not depend on what else runs.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub memory_gb: Option<f64>,
        /// Where doses are computed: "cpu" (the default), "gpu" (the first graphics card), "gpu:NAME" (a card whose name contains this), or "auto" (a card
        /// where there is one that is large enough, else the processor). Needs a program with the feature `gpu`; patterns differ by rounding.
        pub device: Option<String>,
    }
}

tomolith_core::keys! {
    /// Where the dose is computed: cubic voxels.
    ///
    /// Without a shape, the grid is the target's box with a margin of 10 % and at least 4 voxels on each side.
    pub struct GridSpec {
        /// Edge of a voxel; the (smaller) pixel pitch of the first light when neither pitch nor shape is given.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub pitch_mm: Option<Mm>,
        /// Counts [x, y, z]; the pitch then follows the target, or is `pitch_mm`.
        #[schemars(inner(range(min = 1, max = 16384)))]
        pub shape: Option<[usize; 3]>,
        /// How many times finer than the job's the optimization's voxels are, across the axis; along z they are as high as a row of pixels. When left out: with
        /// `surface = "fraction"` and level light up to a quarter of a pixel, with `"cells"` up to half a pixel, as far as the time allows; else 1.
        #[schemars(range(min = 1, max = 32))]
        pub refine: Option<usize>,
        /// Which voxels count: the whole `box`, or the `cylinder` about the axis that is inscribed in it.
        pub region: Region = Region::Box,
        /// Accepts a grid (`shape` × `pitch_mm`) that is too small for the part; only what lies in the grid is printed.
        pub clip: bool = false,
        /// Moves the grid along z, by half a voxel at most, so that its slices lie on rows of pixels of the first light.
        pub on_rows: bool = true,
    }
}

/// Which voxels of the grid count.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Region {
    /// All of them.
    #[default]
    Box,
    /// Those in the cylinder about the axis that is inscribed in the grid, as in studies of the literature.
    Cylinder,
}

/// Whether a table says nothing.
fn is_default<T: Default + PartialEq>(table: &T) -> bool {
    *table == T::default()
}

fn kind(name: &str) -> Value {
    let mut map = Map::new();
    map.insert(name.to_owned(), Value::Object(Map::new()));
    Value::Object(map)
}

fn identity() -> Value {
    kind("identity")
}

fn lbfgs() -> Value {
    kind("lbfgs")
}

fn fbp() -> Value {
    kind("fbp")
}

/// The objective of a job that names none: the threshold preset with its defaults for a part and void; for a gray image, whose values are to
/// be reproduced, least squares; against the degree of cure a part beyond the gel point and a void below it, by a fifth.
pub(crate) fn default_objective(spec: &JobSpec) -> Value {
    let target = &spec.target;
    let in_time = spec.schedule.as_ref();
    if in_time.is_some_and(ScheduleSpec::optimizes_cure) {
        return serde_json::json!({ "osp": { "lower": 0.8, "upper": 1.2, "surface": "fraction" } });
    }
    let is_gray = target.image.is_some() && target.gray != Some(false);
    Value::String(if is_gray { "l2" } else { "threshold" }.to_owned())
}

/// What no job may leave out, without the parameters of kinds: the key, and how it may look.
const REQUIRED: [(&str, &str); 14] = [
    (
        "target",
        "a table [target], for example with phantom = \"gear\" and size_mm = 5.0",
    ),
    (
        "resin",
        "a table [resin], for example with refractive_index = 1.5 and absorption_per_mm = 0.05",
    ),
    (
        "vial",
        "a table [vial.KIND], for example [vial.index_matched] with radius_mm = 8.0; `tomolith kinds vial` lists the kinds",
    ),
    (
        "light",
        "a table [[light]], for example with pixels = [128, 128], angles = 360 and \
         projector.collimated = { pixel_pitch_mm = 0.05 }",
    ),
    (
        "light.pixels",
        "columns and rows, for example pixels = [128, 128]",
    ),
    ("light.angles", "how many frames, for example angles = 360"),
    (
        "light.projector",
        "the optics, for example projector.collimated = { pixel_pitch_mm = 0.05 }; `tomolith kinds projector` lists them",
    ),
    (
        "bath.absorption_per_mm",
        "a number in 1/mm, for example absorption_per_mm = 0.01",
    ),
    (
        "bath.radius_mm",
        "where the bath ends, for example radius_mm = 20.0",
    ),
    (
        "resin.absorption_map.absorption",
        "a file, for example absorption = \"absorption.npy\"",
    ),
    (
        "resin.absorption_map.pitch_mm",
        "the edge of a cell, for example pitch_mm = 0.1",
    ),
    ("obstacles.mesh", "a file, for example mesh = \"rod.stl\""),
    (
        "vial.bottom.z_mm",
        "the height at which the resin ends, for example z_mm = -10.0",
    ),
    (
        "scenario.set",
        "keys and their values there, for example set = { \"resin.absorption_per_mm\" = 0.06 }",
    ),
];

/// Says of a missing key what it is and how it may look.
pub(crate) fn with_example(mut error: Error) -> Error {
    if let Error::Config {
        key,
        found,
        accepted,
        ..
    } = &mut error
        && found == MISSING
    {
        let mut name = key.clone();
        while let (Some(from), Some(to)) = (name.find('['), name.find(']')) {
            name.replace_range(from..=to, "");
        }
        let name = name.replace("vial.top", "vial.bottom");
        if let Some((_, example)) = REQUIRED.iter().find(|(key, _)| *key == name) {
            if !name.contains('.') {
                *found = "the table is missing".to_owned();
            }
            *accepted = (*example).to_owned();
        }
    }
    error
}

impl JobSpec {
    /// Reads the tables of a document; ranges are not checked yet.
    ///
    /// # Errors
    /// [`Error::Config`] with key path, file and line: unknown keys, wrong types, missing keys, tables that are planned
    /// but not built.
    pub fn from_document(document: &Document) -> Result<Self> {
        let root = document.root.as_object().cloned().unwrap_or_default();
        if root.contains_key("axes") && !root.contains_key("target") {
            return Err(document.locate(Error::config(
                "axes",
                "a sweep where a job is read",
                "a job file, with [target]; `tomolith sweep` runs a sweep",
            )));
        }
        let has_rpm = document.root.pointer("/output/rpm").is_some();
        let read = || {
            let mut spec = Section::new("", Value::Object(root)).parse::<JobSpec>()?;
            spec.turn_at_one_speed(has_rpm)?;
            Ok(spec)
        };
        read().map_err(|e| document.locate(with_example(e)))
    }

    /// Movies turn as fast as the schedule.
    fn turn_at_one_speed(&mut self, has_rpm: bool) -> Result<()> {
        let seconds = self
            .schedule
            .as_ref()
            .and_then(|table| table.seconds_per_turn);
        let Some(seconds) = seconds.filter(|s| *s > 0.0) else {
            return Ok(());
        };
        let rpm = 60.0 / seconds;
        if !has_rpm {
            self.output.rpm = rpm;
        } else if (rpm - self.output.rpm).abs() > 1e-6 * rpm {
            return Err(Error::config(
                "schedule.seconds_per_turn",
                format!(
                    "a turn of {} s, and output.rpm = {}",
                    concise(seconds),
                    concise(self.output.rpm)
                ),
                "one of the two, or 60 / output.rpm",
            ));
        }
        Ok(())
    }

    /// The objectives, one section each, with their key paths.
    ///
    /// # Errors
    /// [`Error::Config`] when `objectives` is empty, or both are given.
    pub fn objectives(&self) -> Result<Vec<Section>> {
        match (&self.objective, &self.objectives) {
            (Some(one), None) => Ok(vec![Section::new("objective", one.clone())]),
            (None, Some(many)) if !many.is_empty() => Ok(many
                .iter()
                .enumerate()
                .map(|(i, value)| Section::new(format!("objectives[{i}]"), value.clone()))
                .collect()),
            (Some(_), Some(_)) => Err(Error::config(
                "objectives",
                "both `objective` and `objectives`",
                "one of the two",
            )),
            (None, Some(_)) => Err(Error::config(
                "objectives",
                "an empty list",
                "at least one entry, or leave the key out",
            )),
            (None, None) => Ok(vec![Section::new("objective", default_objective(self))]),
        }
    }

    /// The job as TOML, every default written out.
    ///
    /// # Errors
    /// [`Error::Config`] when a value cannot be written as TOML.
    pub fn to_toml(&self) -> Result<String> {
        if let Some(folder) = &self.output.folder
            && folder.to_str().is_none()
        {
            return Err(Error::config(
                "output.folder",
                format!("`{}`, which is no Unicode text", folder.display()),
                "a path of Unicode text, which job.toml can hold",
            ));
        }
        toml::to_string(self.erased())
            .map_err(|e| Error::config("", e.to_string(), "a job that TOML can hold"))
    }

    /// The job as a value.
    pub(crate) fn to_value(&self) -> Result<Value> {
        serde_json::to_value(self.erased()).map_err(|e| Error::config("", e.to_string(), "a job"))
    }

    /// Writes the job in any format: what is derived for its tables is compiled once, not once a format.
    fn erased(&self) -> &dyn erased_serde::Serialize {
        self
    }
}
