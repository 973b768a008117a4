//! `[[scenario]]`, `[robust]`, `[co_optimize]`, `[multiresolution]`, `[bounds]` and `[stop]`: what the optimization looks for, where, and how long.

use crate::optimize::Keep;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

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

tomolith_core::keys! {
    /// Parameters of the response that are unknowns, too: found together with the patterns, within ranges.
    ///
    /// Li et al. (2024), section 3.4.1, propose it; docs/material.md says how. It says what a resin of this form could do at best, and which one.
    pub struct CoOptimizeSpec {
        /// Parameters of `[response.KIND]` and the range of each, [smallest, largest], as `{ steepness = [10.0, 150.0], midpoint = [0.3, 0.7] }`.
        /// The search begins at the values of `[response.KIND]`, brought into the ranges. A range above 0 is searched along its logarithm.
        pub response: BTreeMap<String, [f64; 2]> = BTreeMap::new(),
        /// Part of its range to which a parameter is found. The optimization does not end by `stop.change`,
        /// `stop.projected_gradient` or for want of progress while a step moves one by more.
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 0.25))]
        pub tolerance: f64 = 1e-3,
    }
}

tomolith_core::keys! {
    /// A start from coarser levels: each has half the voxels, pixels and frames along every axis of the next.
    pub struct MultiresolutionSpec {
        /// Number of coarser levels.
        #[schemars(range(min = 1, max = 6))]
        pub levels: usize = 1,
        /// Iterations on each of them.
        pub iterations: usize = 20,
    }
}

tomolith_core::keys! {
    /// Limits of pattern values, in units of the response's dose.
    pub struct BoundsSpec {
        /// Smallest value: the projector's background, which also lights pixels that miss the part.
        #[schemars(range(min = 0.0, max = 1e9))]
        pub min: f64 = 0.0,
        /// Largest value; when left out, what `ceiling` says, and never more than the largest pixel of the start (no limit for a dark start).
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1e9))]
        pub max: Option<f64>,
        /// How bright pixels may be where neither `max` nor `printer.time_s` says so: "lowest" (default; the lowest ceiling at which the print is as good as without
        /// one, since a print lasts as long as its brightest pixel), or as bright as the brightest of the "start".
        pub ceiling: Ceiling = Ceiling::default(),
        /// By how much a print may be worse with the ceiling than without it.
        pub tolerance: CeilingTolerance = CeilingTolerance::default(),
        /// Bits to which patterns are rounded in every step; no rounding when left out.
        #[schemars(range(min = 1, max = 16))]
        pub bits: Option<u32>,
    }
}

impl BoundsSpec {
    /// Whether a low ceiling of the pixels is looked for.
    pub(crate) fn seek_ceiling(&self) -> bool {
        self.max.is_none() && self.ceiling == Ceiling::Lowest
    }
}

/// What says how bright pixels may be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Ceiling {
    /// The lowest at which the print is as good as without one.
    #[default]
    Lowest,
    /// The brightest pixel of the start.
    Start,
}

tomolith_core::keys! {
    /// By how much a print may be worse with the lowest ceiling than without it.
    #[derive(PartialEq)]
    pub struct CeilingTolerance {
        /// IoU that may be lost.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub iou: f64 = 0.001,
        /// VER that may be added.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub ver: f64 = 0.005,
        /// Share by which the mean surface deviation may grow.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub deviation: f64 = 0.05,
        /// Share by which Γ, the range of exposures that print nearly as well, may shrink.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub latitude: f64 = 0.25,
    }
}

tomolith_core::keys! {
    /// When the optimization ends: at the first of these.
    pub struct StopSpec {
        /// Iterations of the optimizer.
        pub iterations: usize = 45,
        /// Norm of the projected gradient, relative to that of the start, at which it ends.
        #[schemars(range(min = 0.0))]
        pub projected_gradient: Option<f64>,
        /// Mean change of the loss over five steps, relative to the loss, at which it ends; 0: never. When left out,
        /// `lbfgs` ends at 0.0005 on the finest voxels, once the IoU there rises by no more than half of `bounds.tolerance.iou`; from given patterns, in time and for
        /// other methods: never.
        #[schemars(range(min = 0.0))]
        pub change: Option<f64>,
        /// Iterations after which `change` is looked at; 0 when left out. From patterns that are good already the loss changes little while
        /// the print still does.
        pub change_after: Option<usize>,
        /// Part of the loss by which patterns could still be better at most, at which it ends: 0.05 is 5 %. For linear models and convex
        /// objectives; looked at after every fifth iteration. 0: never.
        #[schemars(range(min = 0.0, max = 0.99))]
        pub gap: Option<f64>,
        /// Loss at which the optimization ends; it always ends at 0.
        #[schemars(range(min = 0.0))]
        pub loss: f64 = 0.0,
        /// Part of the first loss at which it ends, or 0: never. With `start.patterns.bounds_as` the first loss is that of the start named there.
        #[schemars(range(min = 0.0, max = 0.99))]
        pub relative_loss: Option<f64>,
        /// IoU on the optimization's grid at which it ends; not for gray targets.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub iou: Option<f64>,
        /// Wall time after which it ends, s.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub wall_s: Option<f64>,
        /// Which patterns the run ends with: the "best" by the measure that the method improves (the loss; for `osmo` and `cal` the IoU on
        /// the job's voxels, and where that is 1 the process window), or those of the "last" iteration.
        pub keep: Keep = Keep::Best,
    }
}
