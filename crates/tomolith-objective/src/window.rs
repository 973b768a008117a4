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
use super::preset::{PartAndVoid, Preset, SurfaceHandling, below, finite, not_negative};
use super::{BuildObjective, read};
use serde::Deserialize;
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

tomolith_core::keys! {
    /// The parameters of `l2n` and `osp`.
    pub struct Params {
        /// τ_l: threshold of void voxels, below `upper` (default 0.7)
        pub lower: f64 = 0.7,
        /// τ_u: threshold of part voxels (default 0.9)
        pub upper: f64 = 0.9,
        /// How voxels cut by the surface are weighed: "voxel" (default), "fraction", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Voxel,
    }
}

tomolith_core::keys! {
    /// The parameters of `ospw`.
    pub struct WindowParams {
        /// τ_l: threshold of void voxels, below `upper` (default 0.7)
        pub lower: f64 = 0.7,
        /// τ_u: threshold of part voxels (default 0.9)
        pub upper: f64 = 0.9,
        /// Width of the part's band above τ_u, 0 or above (default 0)
        pub w: f64 = 0.0,
        /// How voxels cut by the surface are weighed: "voxel" (default), "fraction", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Voxel,
    }
}

/// Squared distances from the bands of thresholds.
fn squared(lower: f64, upper: f64, [part, void]: [Band; 2]) -> Result<PartAndVoid> {
    finite("lower", lower)?;
    finite("upper", upper)?;
    below("lower", lower, "upper", upper)?;
    Ok(PartAndVoid {
        part,
        void,
        p: 2.0,
        q: 2.0,
    })
}

/// What the rows of `l2n` and `osp` read.
#[derive(Clone, Debug, Deserialize)]
#[serde(transparent)]
struct Sided<const BOTH: bool>(Params);

impl<const BOTH: bool> Preset for Sided<BOTH> {
    type Bands = PartAndVoid;

    #[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
    fn bands(&self) -> Result<PartAndVoid> {
        let Params { lower, upper, .. } = self.0;
        let (l, u) = (lower as f32, upper as f32);
        let bands = match BOTH {
            true => [Band::exactly(u), Band::exactly(l)],
            false => [Band::above(u), Band::below(l)],
        };
        squared(lower, upper, bands)
    }

    fn surface(&self) -> SurfaceHandling {
        self.0.surface
    }

    fn thresholds(&self) -> Option<[f64; 2]> {
        Some([self.0.lower, self.0.upper])
    }
}

/// The row of L2N.
#[must_use]
pub const fn l2n<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "l2n",
        summary: "L2N: part to the upper threshold, void to the lower one, both sides",
        example: "[objective.l2n]\nlower = 0.7\nupper = 0.9",
        schema: schema_of::<Params>,
        build: read::<F, Sided<true>>,
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
        build: read::<F, Sided<false>>,
    }
}

impl Preset for WindowParams {
    type Bands = PartAndVoid;

    #[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
    fn bands(&self) -> Result<PartAndVoid> {
        let WindowParams {
            lower, upper, w, ..
        } = *self;
        not_negative("w", w)?;
        let part = Band::new(upper as f32, (upper + w) as f32, 1.0);
        squared(lower, upper, [part, Band::below(lower as f32)])
    }
    fn surface(&self) -> SurfaceHandling {
        self.surface
    }

    fn thresholds(&self) -> Option<[f64; 2]> {
        Some([self.lower, self.upper])
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
        build: read::<F, WindowParams>,
    }
}
