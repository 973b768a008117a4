//! `[[species]]`, `[material]`, `[schedule]` and `[[property]]`: what hardens, when, and to what.

use super::JobSpec;
use crate::target::TargetSpec;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use tomolith_material::photopolymer::{Network, Params, Shading};
use tomolith_material::schedule::Power;

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
    /// Diffusion coefficient, mm²/s (10⁻¹⁰ m²/s = 10⁻⁴ mm²/s).
    #[schemars(range(min = 0.0))]
    pub mm2_per_s: f64,
    /// Groups of neighboring frames of each light that share their times; one when left out, as many as turns with `schedule.own_patterns`. More are
    /// closer to a schedule of few turns, and each takes a pullback of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1))]
    pub arcs: Option<usize>,
}

tomolith_core::keys! {
    /// Frames are shown turn by turn, all lights side by side.
    #[derive(PartialEq)]
    pub struct ScheduleSpec {
        /// Duration of a turn, s; that of `output.rpm` when left out, which follows it where the job does not set it.
        pub seconds_per_turn: Option<f64>,
        /// How many turns, above 0; a broken number ends within a turn.
        pub turns: f64 = 1.0,
        /// Share of a frame's time in which it shines, above 0 to 1.
        pub duty: f64 = 1.0,
        /// How strong a pattern value of 1 is: { energy_mj_per_mm2 = 1.0 } in all turns (the meaning of pattern files), {
        /// energy_per_turn_mj_per_mm2 = … }, or { irradiance_mw_per_mm2 = … }. `light.power` says it of one light.
        pub power: Power = Power::default(),
        /// Dark time before the first turn, s.
        pub dark_before_s: f64 = 0.0,
        /// Dark time between turns, s.
        pub dark_between_s: f64 = 0.0,
        /// Dark time after the last turn, s.
        pub dark_after_s: f64 = 0.0,
        /// Longest step of time, s; a hundredth of the print, at most 1 s and what is stable, when left out.
        pub step_s: Option<f64>,
        /// How often the light is computed anew where cured resin shades, s; 0: in every step.
        #[schemars(range(min = 0.0))]
        pub shading_every_s: f64 = 2.0,
        /// Pictures of the print as it grows; each is stored as a volume.
        #[schemars(range(max = 100))]
        pub snapshots: usize = 8,
        /// What the patterns are optimized against: the "dose" alone, as without a schedule; the degree of cure at the end of the schedule (1: solid)
        /// with the inhibitor "frozen" as the last of several simulations found it; or the same through time by its "exact" derivative, for small jobs.
        pub optimize: Against = Against::Dose,
        /// Simulations of the print during an optimization against "frozen".
        pub rounds: usize = 4,
        /// Whether every turn has patterns of its own. Only optimize = "exact" and `material.diffusion` tell one turn from another.
        pub own_patterns: bool = false,
        /// Whether rows of the optimized patterns are made brighter or darker, until what is solid at each height has absorbed what the part needs
        /// there at one and the same time.
        pub level_heights: bool = false,
    }
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

impl ScheduleSpec {
    /// Whether patterns are optimized against the degree of cure.
    pub(crate) fn optimizes_cure(&self) -> bool {
        self.optimize != Against::Dose
    }

    /// Whether that is by its exact derivative.
    pub(crate) fn is_exact(&self) -> bool {
        self.optimize == Against::Exact
    }
}

impl JobSpec {
    /// What cures after inhibitors are used up.
    pub(crate) fn photopolymer(&self) -> Option<&Params> {
        self.material.as_ref()?.photopolymer.as_ref()
    }

    pub(crate) fn networks(&self) -> &[Network] {
        self.photopolymer().map_or(&[], |params| &params.networks)
    }

    /// What of it shades.
    pub(crate) fn shading(&self) -> &[Shading] {
        self.photopolymer().map_or(&[], |params| &params.shading)
    }

    /// Whether a job optimizes against a resin with a memory, whose cure is no linear function of the patterns.
    pub(crate) fn optimizes_cure(&self) -> bool {
        let schedule = self.schedule.as_ref();
        schedule.is_some_and(ScheduleSpec::optimizes_cure) && self.photopolymer().is_some()
    }

    /// Whether an optimization shows all frames of the schedule, so that none may be left out.
    pub(crate) fn shows_every_frame(&self) -> bool {
        let diffuses = |material: &MaterialSpec| material.diffusion.is_some();
        let schedule = self.schedule.as_ref();
        schedule.is_some_and(ScheduleSpec::optimizes_cure)
            || self.material.as_ref().is_some_and(diffuses)
    }
}
