//! BCLP: band-constrained Lp norm.
//!
//! **Equation** L = ( Σ_v w_v·max(|m_v − f_v| − ε, 0)^p )^(q/p): the band [f − ε, f + ε].
//!
//! **Source** Li, Toombs, Taylor and Wallin, Additive Manufacturing 94 (2024) 104447, eq. 1; gradient eq. 4; the symbols are
//! theirs. Like their program, the sum is over voxels without the volume of a voxel.
//!
//! **Parameters** see [`Params`]; the paper uses the logistic response with B = 10. **Limits** with q < p the gradient is
//! singular at L = 0, where it is set to 0; p < 1 as in [`band`](super::band). **Cost** one pass; a power other than 1 and 2
//! costs a `powf` per voxel outside its band.

use super::preset::{AroundTarget, Preset, SurfaceHandling, not_negative, positive};
use super::{BuildObjective, read};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

tomolith_core::keys! {
    /// The parameters of BCLP.
    pub struct Params {
        /// ε: half the width of the bands in units of the response, 0 or above (default 0.05)
        pub epsilon: f64 = 0.05,
        /// Power of the distance from the band, above 0 (default 2)
        pub p: f64 = 2.0,
        /// Power of the norm, above 0 (default 1)
        pub q: f64 = 1.0,
        /// Weight of part voxels, 0 or above (default 1)
        pub part_weight: f64 = 1.0,
        /// Weight of void voxels, 0 or above (default 1)
        pub void_weight: f64 = 1.0,
        /// How voxels cut by the surface are weighed: "voxel" (default), "fraction", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Voxel,
    }
}

impl Preset for Params {
    type Bands = AroundTarget;

    #[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
    fn bands(&self) -> Result<AroundTarget> {
        not_negative("epsilon", self.epsilon)?;
        positive("p", self.p)?;
        positive("q", self.q)?;
        not_negative("part_weight", self.part_weight)?;
        not_negative("void_weight", self.void_weight)?;
        Ok(AroundTarget {
            half_width: self.epsilon as f32,
            part_weight: self.part_weight as f32,
            void_weight: self.void_weight as f32,
            p: self.p,
            q: self.q,
        })
    }
    fn surface(&self) -> SurfaceHandling {
        self.surface
    }

    fn epsilon(&self) -> Option<f64> {
        Some(self.epsilon)
    }
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "bclp",
        summary: "band-constrained Lp norm: the target plus or minus epsilon",
        example: "[objective.bclp]\nepsilon = 0.05\np = 2\nq = 1",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}
