//! The penalties of the process-window study: `l2n`, `osp` and `ospw`.
//!
//! **Equation** p = q = 2, thresholds τ_l = `lower` < τ_u = `upper`
//!
//! | kind | part | void | name in the study |
//! |---|---|---|---|
//! | `l2n` | [τ_u, τ_u] | [τ_l, τ_l] | L2N: both sides, both regions |
//! | `osp` | [τ_u, ∞) | (−∞, τ_l] | OSP: one-sided |
//! | `ospw` | [τ_u, τ_u + w] | (−∞, τ_l] | OSPW(w): one-sided, with a window of width w in the part |
//!
//! **Source** Pellizzon, Huber, Spangenberg and Jørgensen, arXiv 2602.12178, section 2; the default thresholds (0.70, 0.90)
//! and w = 0 are those the study recommends: OSPW(0) had the widest process window at the smallest dose range in the part.
//!
//! **Parameters** see [`Params`] and [`WindowParams`]. **Cost** the label pass of [`band`](super::band).

use super::band::Band;
use super::preset::{BandPreset, LARGEST, SurfaceHandling, below};
use super::{BuildObjective, read};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

tomolith_core::keys! {
    /// The parameters of `l2n` and `osp`.
    pub struct Params {
        /// τ_l: threshold of void voxels, below `upper`
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub lower: f64 = 0.7,
        /// τ_u: threshold of part voxels
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub upper: f64 = 0.9,
        /// How voxels cut by the surface are weighed: "voxel", "fraction", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Voxel,
    }
}

tomolith_core::keys! {
    /// The parameters of `ospw`.
    pub struct WindowParams {
        /// τ_l: threshold of void voxels, below `upper`
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub lower: f64 = 0.7,
        /// τ_u: threshold of part voxels
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub upper: f64 = 0.9,
        /// Width of the part's band above τ_u
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub w: f64 = 0.0,
        /// How voxels cut by the surface are weighed: "voxel", "fraction", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Voxel,
    }
}

/// Squared distances from the bands of thresholds.
fn squared(thresholds: [f64; 2], bands: [Band; 2], surface: SurfaceHandling) -> Result<BandPreset> {
    let [lower, upper] = thresholds;
    below("lower", lower, "upper", upper)?;
    Ok(BandPreset {
        thresholds: Some(thresholds),
        ..BandPreset::new(bands, [2.0; 2], surface)
    })
}

#[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
fn both_sides(params: &Params) -> Result<BandPreset> {
    let thresholds @ [lower, upper] = [params.lower, params.upper];
    let bands = [Band::exactly(upper as f32), Band::exactly(lower as f32)];
    squared(thresholds, bands, params.surface)
}

#[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
fn one_side(params: &Params) -> Result<BandPreset> {
    let thresholds @ [lower, upper] = [params.lower, params.upper];
    let bands = [Band::above(upper as f32), Band::below(lower as f32)];
    squared(thresholds, bands, params.surface)
}

#[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
fn with_window(params: &WindowParams) -> Result<BandPreset> {
    let thresholds @ [lower, upper] = [params.lower, params.upper];
    let part = Band::new(upper as f32, (upper + params.w) as f32, 1.0);
    squared(
        thresholds,
        [part, Band::below(lower as f32)],
        params.surface,
    )
}

/// The row of L2N.
#[must_use]
pub const fn l2n<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "l2n",
        summary: "L2N: part to the upper threshold, void to the lower one, both sides",
        example: "[objective.l2n]\nlower = 0.7\nupper = 0.9",
        schema: schema_of::<Params>,
        build: |section| read(section, both_sides),
    }
}

/// The row of OSP.
#[must_use]
pub const fn osp<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "osp",
        summary: "OSP: part above the upper threshold, void below the lower one",
        example: "[objective.osp]\nlower = 0.7\nupper = 0.9",
        schema: schema_of::<Params>,
        build: |section| read(section, one_side),
    }
}

/// The row of OSPW.
#[must_use]
pub const fn ospw<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "ospw",
        summary: "OSPW(w): part between the upper threshold and w above it, void below the lower one",
        example: "[objective.ospw]\nlower = 0.7\nupper = 0.9\nw = 0.0",
        schema: schema_of::<WindowParams>,
        build: |section| read(section, with_window),
    }
}
