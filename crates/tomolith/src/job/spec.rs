//! The tables of a job, typed: names, units, defaults and meaning of every key.
//!
//! Tables that name a kind (`[vial.cylinder]`, `[objective.threshold]`, …) keep their content as it stands; the
//! family's own table of kinds reads and checks it (see [`super::kinds`]). Ranges are checked in [`super::validate`].
//!
//! Paths of meshes and images are relative to the job file; `output.folder` is relative to the current folder.

use super::document::Document;
use crate::error::{Error, Result};
use crate::exposure::PrinterSpec;
pub use crate::exposure::Rotation;
use crate::kind::{MISSING, Section};
use crate::optics::gradient;
use crate::optics::interface::Polarization;
use crate::optics::obstacle::BodyMaterial;
use crate::optics::projector::{PROJECTORS, Projector};
use crate::optics::vial::ended::EndSpec;
use crate::optimize::{Keep, checkpoint};
use crate::target::TargetSpec;
use crate::units::{Mm, Pitch, concise};
use schemars::JsonSchema;
use serde::de::{MapAccess, Visitor, value::MapAccessDeserializer};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::path::PathBuf;
use tomolith_material::photopolymer::Params;
use tomolith_material::schedule::Power;

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
    #[serde(default, skip_serializing_if = "MotionSpec::is_default")]
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
    #[serde(default, skip_serializing_if = "RobustSpec::is_default")]
    pub robust: RobustSpec,
    /// Penalties on the patterns, `[[penalties]]` with one kind each and `weight`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub penalties: Vec<Value>,
    /// The material's response to the dose, `[response.KIND]`.
    #[serde(default = "identity")]
    pub response: Value,
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
    #[serde(default, skip_serializing_if = "ResourcesSpec::is_default")]
    pub resources: ResourcesSpec,
    /// What is written, and where.
    #[serde(default)]
    pub output: OutputSpec,
}

/// What a run may use of the computer.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ResourcesSpec {
    /// Memory that the run plans with, GB (10⁹ bytes); 80 % of the computer's, or of its container's, when left out. A job that needs more is
    /// refused before any work. Results do not depend on what else runs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub memory_gb: Option<f64>,
}

impl ResourcesSpec {
    fn is_default(&self) -> bool {
        *self == ResourcesSpec::default()
    }
}

/// Where the dose is computed: cubic voxels.
///
/// Without a shape, the grid is the target's box with a margin of 10 % and at least 4 voxels on each side.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct GridSpec {
    /// Edge of a voxel; the (smaller) pixel pitch of the first light when neither pitch nor shape is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_mm: Option<Mm>,
    /// Counts [x, y, z]; the pitch then follows the target, or is `pitch_mm`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shape: Option<[usize; 3]>,
    /// How many times finer than the job's the optimization's voxels are, across the axis; along z they are as high as a row of pixels. When left out: with
    /// `surface = "fraction"` and level light up to a quarter of a pixel, with `"cells"` up to half a pixel, as far as the time allows; else 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refine: Option<usize>,
    /// Which voxels count: the whole `box`, or the `cylinder` about the axis that is inscribed in it.
    pub region: Region,
    /// Accepts a grid (`shape` × `pitch_mm`) that is too small for the part; only what lies in the grid is printed.
    pub clip: bool,
    /// Moves the grid along z, by half a voxel at most, so that its slices lie on rows of pixels of the first light.
    pub on_rows: bool,
}

impl Default for GridSpec {
    fn default() -> Self {
        GridSpec {
            pitch_mm: None,
            refine: None,
            shape: None,
            region: Region::Box,
            clip: false,
            on_rows: true,
        }
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

/// The resin at the light's wavelength.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ResinSpec {
    /// Refractive index, 1 to 4.
    pub refractive_index: f64,
    /// Napierian absorption of the active species, 1/mm, > 0: what makes dose. Required, except with `pure_radon`, which does not use it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub absorption_per_mm: Option<f64>,
    /// Total Napierian attenuation, 1/mm; absorption + scattering when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub attenuation_per_mm: Option<f64>,
    /// Refractive index that changes with the distance from the axis; from 1 to 4 everywhere in the resin.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gradient: Option<gradient::Params>,
    /// Absorption that changes from place to place.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub absorption_map: Option<MapSpec>,
    /// Napierian scattering, 1/mm; a part of the total attenuation.
    pub scattering_per_mm: f64,
    /// Phase function of the scattering, `[resin.phase.KIND]`.
    pub phase: Value,
    /// Dose is the plain sum of fluence, with no absorption at all (the Radon convention of the literature).
    pub pure_radon: bool,
    /// Definition of dose: "energy" (default), absorbed per volume, or "drtvam", that times (n_surrounding/n_resin)², as in Dr.TVAM.
    pub dose_convention: DoseConvention,
    /// Dose at which the resin turns solid, mJ/mm³; ties the relative dose to exposure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub critical_dose_mj_per_mm3: Option<f64>,
}

/// What a dose counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DoseConvention {
    /// Absorbed energy per volume, Σ over the frames.
    #[default]
    Energy,
    /// Dr.TVAM's: (n_surrounding/n_resin)² of it, which its refracted light carries; for comparisons side by side.
    Drtvam,
}

/// Absorption per cell, centered on the axis; beyond the cells the resin has its plain numbers. Files are `.npy` of any number type, 1/mm:
/// 2D [y, x], the same at all heights, or 3D [z, y, x], centered on z = 0; row 0 = most negative y, level 0 = lowest.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MapSpec {
    /// Absorption of the active species, which makes dose.
    pub absorption: PathBuf,
    /// Total attenuation; absorption + `resin.scattering_per_mm` when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub attenuation: Option<PathBuf>,
    /// Edge of a cell.
    pub pitch_mm: Mm,
}

/// What surrounds the vial and absorbs, up to a round wall.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BathSpec {
    /// Napierian absorption, 1/mm.
    pub absorption_per_mm: f64,
    /// Its outer radius, about the axis; larger than the vial's.
    pub radius_mm: Mm,
}

/// The vial: one kind, `[vial.KIND]`, and what is said of every kind.
#[derive(Clone, Debug, PartialEq)]
pub struct VialSpec {
    /// Keys of every kind.
    pub common: VialCommon,
    /// The kind and its parameters, `{cylinder: {…}}`.
    pub kind: Value,
}

/// Keys of `[vial]` beside its kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct VialCommon {
    /// Refractive index of what surrounds the vial: 1 for air, the bath's for a bath.
    pub surrounding_index: f64,
    /// The lower end of the resin; without it the resin has no end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bottom: Option<EndSpec>,
    /// The upper end of the resin.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub top: Option<EndSpec>,
}

impl Default for VialCommon {
    fn default() -> Self {
        VialCommon {
            surrounding_index: 1.0,
            bottom: None,
            top: None,
        }
    }
}

/// One projector, or one wavelength.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LightSpec {
    /// Its name, for files; needed when there are several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Vacuum wavelength, nm.
    #[serde(default = "violet")]
    pub wavelength_nm: f64,
    /// Pixels of a pattern, [columns, rows].
    pub pixels: [usize; 2],
    /// Offset of the image's center from the rotation axis [along the columns, up]; 0 when left out.
    #[serde(default, skip_serializing_if = "is_about_axis")]
    pub offset_mm: [Mm; 2],
    /// Azimuths of the frames: a count (full turn; for a single frame the vial stands), {count, start_deg, arc_deg} or {list_deg}.
    pub angles: Angles,
    /// Angles at which the optimization averages a frame, which is exposed while the vial turns through its arc. When left out: one for
    /// every half pixel that the rim of the part moves, 4 at most, as far as the time allows; 1 where light is not collimated and level.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sub_angles: Option<usize>,
    /// Sense in which the VIAL turns, seen from above.
    #[serde(default)]
    pub rotation: Rotation,
    /// Polarization before the vial: "s" has its electric field in the plane of ray and vial axis (along the axis where the ray is
    /// level), "p" normal to both; they tilt with the axis.
    #[serde(default)]
    pub polarization: Polarization,
    /// What the resin is to this light, where that differs from `[resin]`.
    #[serde(default, skip_serializing_if = "LightResinSpec::is_default")]
    pub resin: LightResinSpec,
    /// How strong a pattern value of 1 is in the print in time, where that differs from `schedule.power`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub power: Option<Power>,
    /// How many turns it is shown in the print in time, where that differs from `schedule.turns`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turns: Option<f64>,
    /// What the machine is to this light, where that differs from `[printer]`.
    #[serde(default, skip_serializing_if = "LightPrinterSpec::is_default")]
    pub printer: LightPrinterSpec,
    /// Limits of this light's pattern values, where they differ from `[bounds]`.
    #[serde(default, skip_serializing_if = "LightBoundsSpec::is_default")]
    pub bounds: LightBoundsSpec,
    /// Which pixels may be lit; the others stay dark. All that can help the part when left out.
    #[serde(default, skip_serializing_if = "SelectionSpec::is_default")]
    pub selection: SelectionSpec,
    /// How the projector spreads the light of one pixel, measured: an image of it (PNG, TIFF, NPY; one number per pixel of the light, row 0 on top, the lit
    /// pixel in the middle), or a CSV table of radius in mm and light. Every pixel keeps its light when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub psf: Option<PathBuf>,
    /// The optics, `projector.KIND`.
    pub projector: ProjectorSpec,
}

/// What the resin is at the wavelength of one light; what is left out is that of `[resin]`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct LightResinSpec {
    /// Refractive index, 1 to 4.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refractive_index: Option<f64>,
    /// Napierian absorption of the active species, 1/mm, > 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub absorption_per_mm: Option<f64>,
    /// Napierian attenuation by everything, 1/mm; absorption + scattering of this light where one of these is given and this is not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub attenuation_per_mm: Option<f64>,
    /// Napierian scattering, 1/mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scattering_per_mm: Option<f64>,
}

impl LightResinSpec {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// Limits of one light's pattern values; what is left out is that of `[bounds]`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct LightBoundsSpec {
    /// Smallest value, ≥ 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// Largest value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
}

impl LightBoundsSpec {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// What the machine is to one light; what is left out is that of `[printer]`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct LightPrinterSpec {
    /// Value (level over highest level) and intensity of the device, points [value, intensity].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gray_curve: Option<Vec<[f64; 2]>>,
    /// The same from a file with two columns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gray_curve_file: Option<PathBuf>,
    /// Irradiance of the brightest device pixel at the highest level, at the vial.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_irradiance_mw_per_cm2: Option<f64>,
}

impl LightPrinterSpec {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }

    fn has_curve(&self) -> bool {
        self.gray_curve.is_some() || self.gray_curve_file.is_some()
    }
}

impl JobSpec {
    /// The machine as it is to one light; None where the job has none.
    #[must_use]
    pub fn printer_of(&self, light: usize) -> Option<PrinterSpec> {
        let mut printer = self.printer.clone()?;
        let own = &self.light[light].printer;
        if own.has_curve() {
            printer.gray_curve.clone_from(&own.gray_curve);
            printer.gray_curve_file.clone_from(&own.gray_curve_file);
        }
        let peak = own.peak_irradiance_mw_per_cm2;
        printer.peak_irradiance_mw_per_cm2 = peak.or(printer.peak_irradiance_mw_per_cm2);
        Some(printer)
    }

    /// Blames what is wrong with the machine of a light on the light where it is the light that says it.
    pub(crate) fn at_printer_of(&self, light: usize, mut error: Error) -> Error {
        let own = &self.light[light].printer;
        if let Error::Config { key, .. } = &mut error {
            let is_curve = key.starts_with("printer.gray_curve") && own.has_curve();
            let is_peak =
                key.starts_with("printer.peak") && own.peak_irradiance_mw_per_cm2.is_some();
            if is_curve || is_peak {
                *key = format!("light[{light}].{key}");
            }
        }
        error
    }
}

/// What hardens, or is inhibited: r = Σ M·(dose of a light alone), with a target and a loss of its own.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpeciesSpec {
    /// Its name, for files and the report.
    pub name: String,
    /// The row of M: how strongly each light drives it, by the name of the light; below 0 where a light inhibits. Lights that are left out
    /// do nothing; every light counts 1 when the key is left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub driven_by: Option<BTreeMap<String, f64>>,
    /// Where it should form; the job's `[target]` when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub target: Option<TargetSpec>,
    /// What is minimized for it, one kind; the job's objective when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Value>,
    /// What it does with its dose, one kind; the job's `[response]` when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub response: Option<Value>,
}

/// The job with some keys set otherwise: a vial that is wider, a resin that absorbs more, an axis that is off.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScenarioSpec {
    /// Its name in the report; its number when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Keys of `vial`, `resin`, `light`, `motion` or `bath` and their values here, as `{ "vial.index_matched.radius_mm" = 5.08 }`.
    pub set: Map<String, Value>,
}

/// What is minimized over the job and its scenarios.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct RobustSpec {
    /// "mean" (default) of their losses, or nearly the "worst" of them.
    pub of: RobustOf,
}

impl RobustSpec {
    fn is_default(&self) -> bool {
        *self == RobustSpec::default()
    }
}

/// How the losses of scenarios become one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RobustOf {
    /// Their mean.
    #[default]
    Mean,
    /// Their mean of power 8, which is nearly the largest.
    Worst,
}

impl RobustOf {
    /// Its name in a job.
    pub(crate) fn name(self) -> &'static str {
        match self {
            RobustOf::Mean => "mean",
            RobustOf::Worst => "worst",
        }
    }
}

/// A resin that answers light over time: one of `photopolymer` and `diffusion`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialSpec {
    /// Networks that cure after inhibitors are used up.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub photopolymer: Option<Params>,
    /// A dose that spreads while it is written, and solid resin where it reaches `resin.critical_dose_mj_per_mm3`. All doses of the job are those
    /// at the end of the schedule then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub diffusion: Option<DiffusionSpec>,
    /// Whether air lies on the top of the grid and keeps inhibitors saturated there.
    #[serde(default)]
    pub air_on_top: bool,
}

/// How a dose spreads.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DiffusionSpec {
    /// Diffusion coefficient, mm²/s (10⁻¹⁰ m²/s = 10⁻⁴ mm²/s), 0 or more.
    pub mm2_per_s: f64,
    /// Groups of neighboring frames of each light that share their times; one when left out, as many as turns with `schedule.own_patterns`. More are
    /// closer to a schedule of few turns, and each takes a pullback of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arcs: Option<usize>,
}

/// Frames are shown turn by turn, all lights side by side.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ScheduleSpec {
    /// Duration of a turn, s; that of `output.rpm` when left out, which follows it where the job does not set it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds_per_turn: Option<f64>,
    /// How many turns, above 0; a broken number ends within a turn.
    pub turns: f64,
    /// Share of a frame's time in which it shines, above 0 to 1.
    pub duty: f64,
    /// How strong a pattern value of 1 is: { energy_mj_per_mm2 = 1.0 } in all turns (the meaning of pattern files), {
    /// energy_per_turn_mj_per_mm2 = … }, or { irradiance_mw_per_mm2 = … }. `light.power` says it of one light.
    pub power: Power,
    /// Dark time before the first turn, s.
    pub dark_before_s: f64,
    /// Dark time between turns, s.
    pub dark_between_s: f64,
    /// Dark time after the last turn, s.
    pub dark_after_s: f64,
    /// Longest step of time, s; a hundredth of the print, at most 1 s and what is stable, when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_s: Option<f64>,
    /// How often the light is computed anew where cured resin shades, s.
    pub shading_every_s: f64,
    /// Pictures of the print as it grows.
    pub snapshots: usize,
    /// What the patterns are optimized against: the "dose" alone, as without a schedule; the degree of cure at the end of the schedule (1: solid)
    /// with the inhibitor "frozen" as the last of several simulations found it; or the same through time by its "exact" derivative, for small jobs.
    pub optimize: Against,
    /// Simulations of the print during an optimization against "frozen".
    pub rounds: usize,
    /// Whether every turn has patterns of its own. Only optimize = "exact" and `material.diffusion` tell one turn from another.
    pub own_patterns: bool,
    /// Whether rows of the optimized patterns are made brighter or darker, until what is solid at each height has absorbed what the part needs
    /// there at one and the same time.
    pub level_heights: bool,
}

/// What patterns are optimized against.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Against {
    /// The dose.
    #[default]
    Dose,
    /// The degree of cure, inhibitor frozen between simulations.
    Frozen,
    /// The degree of cure.
    Exact,
}

impl Default for ScheduleSpec {
    fn default() -> Self {
        ScheduleSpec {
            seconds_per_turn: None,
            turns: 1.0,
            duty: 1.0,
            power: Power::default(),
            dark_before_s: 0.0,
            dark_between_s: 0.0,
            dark_after_s: 0.0,
            step_s: None,
            shading_every_s: 2.0,
            snapshots: 8,
            optimize: Against::Dose,
            rounds: 4,
            own_patterns: false,
            level_heights: false,
        }
    }
}

/// A property of the printed material, such as its modulus: a map of a species' response, or of the ratio of two.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PropertySpec {
    /// Its name, for files and the report.
    pub name: String,
    /// Its unit.
    #[serde(default)]
    pub unit: String,
    /// The species whose response is mapped; the only one when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<String>,
    /// The species by whose response that is divided first; none when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub over: Option<String>,
    /// The map, one kind as in `[response]`: `{ logistic = { … } }`, `{ table = { … } }`.
    pub map: Value,
    /// Whether the map gives the decimal logarithm of the property.
    #[serde(default)]
    pub log10: bool,
}

/// Which pixels of a light may be lit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SelectionSpec {
    /// Columns that may be lit, [first, count]; the optical axis stays in the middle of all columns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub columns: Option<[usize; 2]>,
    /// Rows that may be lit, [first, count], row 0 = top; the optical axis stays in the middle of all rows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rows: Option<[usize; 2]>,
    /// Image of all pixels, relative to the job file (.png, .tif or .npy): those that are 0 (black) stay dark.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mask: Option<PathBuf>,
    /// Pixels whose middle ray meets the vial closer than this to an edge of its outer wall stay dark (square vials and meshes).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner_radius_mm: Option<Mm>,
    /// Switches off pixels that deliver less than this fraction of the best pixel's dose to the part, 0 to below 1.
    pub min_contribution: f64,
}

impl SelectionSpec {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }

    /// The same for pixels so many times as large; its mask is left out.
    pub(crate) fn coarsen(&mut self, factor: usize) {
        for [first, count] in self.columns.iter_mut().chain(&mut self.rows) {
            let end = (*first + *count).div_ceil(factor);
            *first /= factor;
            *count = end - *first;
        }
        self.mask = None;
    }
}

/// The optics of a light: one kind, `projector.KIND`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct ProjectorSpec(pub Value);

impl ProjectorSpec {
    /// The projector; `path` is its key.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub fn build(&self, path: &str) -> Result<Box<dyn Projector>> {
        let (kind, section) = Section::new(path, self.0.clone()).kind(PROJECTORS)?;
        (kind.build)(&section)
    }

    /// Makes pixels larger by a factor.
    pub(crate) fn coarsen(&mut self, factor: f64) {
        for parameters in self.0.as_object_mut().into_iter().flatten() {
            if let Some(pitch) = parameters.1.get_mut("pixel_pitch_mm")
                && let Ok(Pitch(mm)) = serde_json::from_value(pitch.clone())
            {
                let larger = Pitch(mm.map(|mm| factor * mm));
                *pitch = serde_json::to_value(larger).unwrap_or_default();
            }
        }
    }
}

/// How the vial moves: it turns about its own axis, normal to the light, unless something else is said here.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MotionSpec {
    /// Light comes from above by this angle: −80 to 80.
    pub tilt_deg: f64,
    /// Axis of the vial [x, y], seen from the rotation axis, in the frame that turns with it.
    pub offset_mm: [f64; 2],
    /// Largest run-out of the rotation axis along the columns.
    pub axis_runout_mm: f64,
    /// Azimuth of the light at which the run-out is largest.
    pub axis_runout_deg: f64,
}

impl MotionSpec {
    fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// A body in the light: a closed mesh in the frame of the vial, mm.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObstacleSpec {
    /// Mesh file, relative to the job.
    pub mesh: PathBuf,
    /// What it does to light: "black", "mirror", or { dielectric = { refractive_index = 1.5 } }.
    #[serde(default)]
    pub material: BodyMaterial,
    /// Millimeters per unit of the file.
    #[serde(default = "unity")]
    pub scale: f64,
    /// Position of the file's origin [x, y, z].
    #[serde(default)]
    pub offset_mm: [f64; 3],
}

/// The angles of a light.
#[derive(Clone, Debug, PartialEq)]
pub enum Angles {
    /// `count` frames, evenly over `arc_deg` from `start_deg`; the arc's end is not repeated.
    Even {
        /// Number of frames.
        count: usize,
        /// First azimuth.
        start_deg: f64,
        /// The arc, 360 for the full turn.
        arc_deg: f64,
    },
    /// These azimuths.
    List(Vec<f64>),
}

/// A start from coarser levels: each has half the voxels, pixels and frames along every axis of the next.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct MultiresolutionSpec {
    /// Number of coarser levels, 1 to 6.
    pub levels: usize,
    /// Iterations on each of them.
    pub iterations: usize,
}

impl Default for MultiresolutionSpec {
    fn default() -> Self {
        MultiresolutionSpec {
            levels: 1,
            iterations: 20,
        }
    }
}

/// Limits of pattern values, in units of the response's dose.
#[derive(Clone, Debug, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct BoundsSpec {
    /// Smallest value, ≥ 0.
    pub min: f64,
    /// Largest value; when left out, the largest pixel of the start (none for a dark start).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
    /// Bits to which patterns are rounded in every step, 1 to 16; no rounding when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bits: Option<u32>,
}

/// When the optimization ends: at the first of these.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct StopSpec {
    /// Iterations of the optimizer.
    pub iterations: usize,
    /// Norm of the projected gradient, relative to that of the start, at which it ends.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub projected_gradient: Option<f64>,
    /// Mean change of the loss over five steps, relative to the loss, at which it ends (0.001 in the BCLP paper); 0: never.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub change: Option<f64>,
    /// Part of the loss by which patterns could still be better at most, at which it ends: 0.05 is 5 %. For linear models and convex
    /// objectives; looked at after every fifth iteration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// Loss at which the optimization ends; it always ends at 0.
    pub loss: f64,
    /// Part of the first loss at which it ends, 0 to below 1. With `start.patterns.bounds_as` the first loss is that of the start named there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub relative_loss: Option<f64>,
    /// IoU on the optimization's grid at which it ends, 0 to 1; not for gray targets.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub iou: Option<f64>,
    /// Wall time after which it ends, s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wall_s: Option<f64>,
    /// Which patterns the run ends with: the "best" by the measure that the method improves (the loss; for `osmo` and `cal` the IoU on
    /// the job's voxels, and where that is 1 the process window), or those of the "last" iteration.
    pub keep: Keep,
}

/// How the written patterns are judged: their dose is simulated again, turning and on a finer grid.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct EvaluateSpec {
    /// Bits to which patterns are quantized, 1 to 16.
    pub bit_depth: u32,
    /// How patterns are put on the levels of 5 bits or fewer: "optimized" on these levels after the optimization, or "rounded". With more bits they
    /// are rounded.
    pub levels: Levelling,
    /// Angles at which the arc of a frame is averaged.
    pub sub_angles: usize,
    /// How many times finer than the job's the voxels of the evaluation are; lowered, with a warning, where the memory budget is too small. When left out: as fine as the
    /// optimization's, up to 3·10⁷ voxels, and at least 2.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refine: Option<usize>,
    /// Dose at which the resin turns solid; the one with the best IoU when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub threshold: Option<f64>,
    /// Percent of the voxels that trimmed metrics leave out at each end, in part and in void, 0 to below 50.
    pub trim_percent: f64,
    /// Whether distances between the surfaces of print and target are measured. They take most of the time of a small evaluation, and a sweep that collects none
    /// leaves them out.
    pub surfaces: bool,
    /// IoU that the evaluation must reach: below it the command ends with exit code 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub require_iou: Option<f64>,
    /// Gray targets: share of the voxels that must be in their bands, 0 to 1; below it the command ends with exit code 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub require_in_band: Option<f64>,
}

/// How patterns come to few levels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Levelling {
    /// They are improved on them.
    #[default]
    #[serde(rename = "optimized")]
    Optimized,
    /// Each pixel takes the nearest.
    Rounded,
}

/// What is written, and where.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct OutputSpec {
    /// The run folder, relative to the current folder; `out/` and the job's name when left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub folder: Option<PathBuf>,
    /// Turns of the vial per minute: gives the movie its frame rate.
    pub rpm: f64,
    /// The movie: "h264" (default; 8 bits, within a few levels, every player shows it) or "lossless" (PNG frames in a
    /// QuickTime file, every level exact at any bit depth).
    pub movie: MovieCoding,
}

/// How the movie's frames are coded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum MovieCoding {
    /// MP4 with H.264.
    #[default]
    H264,
    /// QuickTime with PNG.
    Lossless,
}

impl MovieCoding {
    /// How the name of the file ends.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            MovieCoding::H264 => "mp4",
            MovieCoding::Lossless => "mov",
        }
    }
}

fn is_about_axis(offset: &[Mm; 2]) -> bool {
    offset.iter().all(|mm| mm.0 == 0.0)
}
fn violet() -> f64 {
    405.0
}
fn kind(name: &str) -> Value {
    let mut map = Map::new();
    map.insert(name.to_owned(), Value::Object(Map::new()));
    Value::Object(map)
}
fn unity() -> f64 {
    1.0
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

impl ResinSpec {
    /// Absorption of the active species, 1/mm: 0 for the plain sum of fluence.
    #[must_use]
    pub fn active_per_mm(&self) -> f64 {
        self.absorption_per_mm
            .filter(|_| !self.pure_radon)
            .unwrap_or(0.0)
    }
}

impl Default for ResinSpec {
    fn default() -> Self {
        ResinSpec {
            refractive_index: 1.5,
            absorption_per_mm: None,
            attenuation_per_mm: None,
            gradient: None,
            absorption_map: None,
            scattering_per_mm: 0.0,
            phase: kind("rayleigh"),
            pure_radon: false,
            dose_convention: DoseConvention::Energy,
            critical_dose_mj_per_mm3: None,
        }
    }
}

impl Default for StopSpec {
    fn default() -> Self {
        StopSpec {
            iterations: 40,
            projected_gradient: None,
            change: None,
            gap: None,
            loss: 0.0,
            relative_loss: None,
            iou: None,
            wall_s: None,
            keep: Keep::Best,
        }
    }
}

impl Default for EvaluateSpec {
    fn default() -> Self {
        EvaluateSpec {
            bit_depth: 8,
            levels: Levelling::Optimized,
            sub_angles: 4,
            refine: None,
            threshold: None,
            trim_percent: 0.025,
            surfaces: true,
            require_iou: None,
            require_in_band: None,
        }
    }
}

impl Default for OutputSpec {
    fn default() -> Self {
        OutputSpec {
            folder: None,
            rpm: 10.0,
            movie: MovieCoding::default(),
        }
    }
}

impl<'de> Deserialize<'de> for VialSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct VialVisitor;
        impl<'de> Visitor<'de> for VialVisitor {
            type Value = VialSpec;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a table [vial.KIND]; `tomolith kinds vial` lists the kinds")
            }
            fn visit_str<E: serde::de::Error>(self, name: &str) -> Result<VialSpec, E> {
                Ok(VialSpec {
                    common: VialCommon::default(),
                    kind: Value::String(name.to_owned()),
                })
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<VialSpec, A::Error> {
                let (mut common, mut kind) = (VialCommon::default(), Map::new());
                while let Some(key) = map.next_key::<String>()? {
                    match key.as_str() {
                        "surrounding_index" => common.surrounding_index = map.next_value()?,
                        "bottom" => common.bottom = map.next_value()?,
                        "top" => common.top = map.next_value()?,
                        _ => drop(kind.insert(key, map.next_value()?)),
                    }
                }
                Ok(VialSpec {
                    common,
                    kind: Value::Object(kind),
                })
            }
        }
        deserializer.deserialize_any(VialVisitor)
    }
}

impl Serialize for VialSpec {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let common = serde_json::to_value(&self.common).map_err(serde::ser::Error::custom)?;
        let mut map = common.as_object().cloned().unwrap_or_default();
        match &self.kind {
            Value::Object(kind) => map.extend(kind.clone()),
            Value::String(name) => drop(map.insert(name.clone(), Value::Object(Map::new()))),
            _ => {}
        }
        map.serialize(serializer)
    }
}

impl JsonSchema for VialSpec {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "VialSpec".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "type": "object" }) // filled in from the table of vials, see `super::schema`
    }
}

/// The table form of [`Angles`].
#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct AnglesTable {
    /// Number of frames.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    count: Option<usize>,
    /// First azimuth.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    start_deg: Option<f64>,
    /// The arc over which they are spread; the full turn when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    arc_deg: Option<f64>,
    /// These azimuths, in place of the others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    list_deg: Option<Vec<f64>>,
}

impl<'de> Deserialize<'de> for Angles {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct AnglesVisitor;
        impl<'de> Visitor<'de> for AnglesVisitor {
            type Value = Angles;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a count of frames, {count, start_deg, arc_deg} or {list_deg}")
            }
            fn visit_u64<E: serde::de::Error>(self, count: u64) -> Result<Angles, E> {
                let count = usize::try_from(count).unwrap_or(usize::MAX);
                Ok(Angles::Even {
                    count,
                    start_deg: 0.0,
                    arc_deg: 360.0,
                })
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Angles, A::Error> {
                let table = AnglesTable::deserialize(MapAccessDeserializer::new(map))?;
                match (table.count, table.list_deg) {
                    (Some(count), None) => Ok(Angles::Even {
                        count,
                        start_deg: table.start_deg.unwrap_or(0.0),
                        arc_deg: table.arc_deg.unwrap_or(360.0),
                    }),
                    (None, Some(list)) if table.start_deg.is_none() && table.arc_deg.is_none() => {
                        Ok(Angles::List(list))
                    }
                    (None, None) => Err(serde::de::Error::custom(
                        "neither count nor list_deg, expected one of them",
                    )),
                    _ => Err(serde::de::Error::custom(
                        "list_deg together with other keys, expected list_deg alone",
                    )),
                }
            }
        }
        deserializer.deserialize_any(AnglesVisitor)
    }
}

impl Serialize for Angles {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let table = match self.clone() {
            Angles::Even {
                count,
                start_deg,
                arc_deg,
            } => AnglesTable {
                count: Some(count),
                start_deg: Some(start_deg),
                arc_deg: Some(arc_deg),
                list_deg: None,
            },
            Angles::List(list) => AnglesTable {
                count: None,
                start_deg: None,
                arc_deg: None,
                list_deg: Some(list),
            },
        };
        table.serialize(serializer)
    }
}

impl JsonSchema for Angles {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Angles".into()
    }
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let table = generator.subschema_for::<AnglesTable>();
        schemars::json_schema!({
            "description": "A count of frames (full turn), {count, start_deg, arc_deg} or {list_deg}",
            "anyOf": [{ "type": "integer", "minimum": 1 }, table]
        })
    }
}

impl Angles {
    /// The same angles turn after turn, each turn with frames of its own. An arc that is no whole turn cannot be shown so.
    pub(crate) fn turn_after_turn(&self, turns: usize) -> Option<Angles> {
        match self {
            Angles::Even {
                count,
                start_deg,
                arc_deg,
            } => (*arc_deg == 360.0 && *count > 1).then_some(Angles::Even {
                count: count * turns,
                start_deg: *start_deg,
                arc_deg: arc_deg * turns as f64,
            }),
            Angles::List(list) => Some(Angles::List(list.repeat(turns))),
        }
    }

    /// Number of frames.
    #[must_use]
    pub fn count(&self) -> usize {
        match self {
            Angles::Even { count, .. } => *count,
            Angles::List(list) => list.len(),
        }
    }

    /// Azimuth from which each frame's light arrives (rad), and the arc of one frame (rad; 0 for a list, and for one frame on a whole
    /// turn: it comes from one direction, so the vial stands while it is shown. One pattern on a turning vial is the same frame at
    /// many angles).
    ///
    /// ```
    /// use tomolith::job::{Angles, Rotation};
    /// let angles = Angles::Even { count: 4, start_deg: 0.0, arc_deg: 360.0 };
    /// let (azimuths, arc) = angles.azimuths(Rotation::Clockwise);
    /// assert!((azimuths[1] - std::f64::consts::FRAC_PI_2).abs() < 1e-12); // a quarter turn further
    /// assert!((arc - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    /// // One frame, for which the vial stands
    /// let one = Angles::Even { count: 1, start_deg: 0.0, arc_deg: 360.0 };
    /// assert_eq!(one.azimuths(Rotation::Clockwise), (vec![0.0], 0.0));
    /// let (azimuths, _) = angles.azimuths(Rotation::Counterclockwise);
    /// assert!((azimuths[1] + std::f64::consts::FRAC_PI_2).abs() < 1e-12); // the other way round
    /// ```
    #[must_use]
    pub fn azimuths(&self, rotation: Rotation) -> (Vec<f64>, f64) {
        match self {
            Angles::Even {
                count,
                start_deg,
                arc_deg,
            } => {
                let sense = match rotation {
                    Rotation::Clockwise => 1.0,
                    Rotation::Counterclockwise => -1.0,
                };
                let (start, arc) = (start_deg.to_radians(), arc_deg.to_radians());
                let azimuths = (0..*count)
                    .map(|k| start + sense * arc * k as f64 / *count as f64)
                    .collect();
                if *count == 1 && *arc_deg == 360.0 {
                    return (azimuths, 0.0);
                }
                (azimuths, arc / (*count).max(1) as f64)
            }
            Angles::List(list) => (list.iter().map(|a| a.to_radians()).collect(), 0.0),
        }
    }
}

/// The objective of a job that names none: the threshold preset with its defaults for a part and void; for a gray image, whose values are to
/// be reproduced, least squares; against the degree of cure a part beyond the gel point and a void below it, by a fifth.
pub(crate) fn default_objective(spec: &JobSpec) -> Value {
    let target = &spec.target;
    let in_time = spec.schedule.as_ref();
    if in_time.is_some_and(|schedule| schedule.optimize != Against::Dose) {
        return serde_json::json!({ "osp": { "lower": 0.8, "upper": 1.2, "surface": "fraction" } });
    }
    let is_gray = target.image.is_some() && target.gray != Some(false);
    Value::String(if is_gray { "l2" } else { "threshold" }.to_owned())
}

/// What no job may leave out, without the parameters of kinds: the key, and how it may look.
const REQUIRED: [(&str, &str); 13] = [
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
];

/// Says of a missing key what it is and how it may look.
pub(super) fn with_example(mut error: Error) -> Error {
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
        let has_rpm = document.root.pointer("/output/rpm").is_some();
        let read = || {
            let mut spec = Section::new("", Value::Object(root)).parse::<JobSpec>()?;
            spec.turn_at_one_speed(has_rpm)?;
            for (i, light) in spec.light.iter().enumerate() {
                light.projector.build(&format!("light[{i}].projector"))?;
            }
            Ok(spec)
        };
        read().map_err(|e| document.locate(with_example(e)))
    }

    /// Movies turn as fast as the schedule.
    fn turn_at_one_speed(&mut self, has_rpm: bool) -> Result<()> {
        let seconds = self.schedule.as_ref().and_then(|own| own.seconds_per_turn);
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
        toml::to_string(self.erased())
            .map_err(|e| Error::config("", e.to_string(), "a job that TOML can hold"))
    }

    /// The job as a value.
    pub(super) fn to_value(&self) -> Result<Value> {
        serde_json::to_value(self.erased()).map_err(|e| Error::config("", e.to_string(), "a job"))
    }

    /// Writes the job in any format: what is derived for its tables is compiled once, not once a format.
    fn erased(&self) -> &dyn erased_serde::Serialize {
        self
    }
}
