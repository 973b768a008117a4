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

use super::preset::{BandPreset, HIGHEST_POWER, LARGEST, SurfaceHandling};
use super::{BuildObjective, read};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

tomolith_core::keys! {
    /// The parameters of BCLP.
    pub struct Params {
        /// ε: half the width of the bands in units of the response
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub epsilon: f64 = 0.05,
        /// Power of the distance from the band
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = HIGHEST_POWER))]
        pub p: f64 = 2.0,
        /// Power of the norm
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = HIGHEST_POWER))]
        pub q: f64 = 1.0,
        /// Weight of part voxels
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub part_weight: f64 = 1.0,
        /// Weight of void voxels
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub void_weight: f64 = 1.0,
        /// How voxels cut by the surface are weighed: "voxel", "fraction", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Voxel,
    }
}

#[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
fn preset(params: &Params) -> Result<BandPreset> {
    let Params { epsilon, p, q, .. } = *params;
    let weights = [params.part_weight as f32, params.void_weight as f32];
    Ok(BandPreset {
        epsilon: Some(epsilon),
        ..BandPreset::around_target(epsilon as f32, weights, [p, q], params.surface)
    })
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "bclp",
        summary: "band-constrained Lp norm: the target plus or minus epsilon",
        example: "[objective.bclp]\nepsilon = 0.05\np = 2\nq = 1",
        schema: schema_of::<Params>,
        build: |section| read(section, preset),
    }
}
