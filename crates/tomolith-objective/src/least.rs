//! Least squares (`l2`) and least absolute deviation (`l1`): part to 1, void to 0, or gray values as they are.
//!
//! **Equation** L = Σ_v w_v·|m_v − f_v|^p with p = q = 2 or 1: the band [f, f].
//!
//! **Source** Nicolet et al. (2024), section 4, L2; Li et al. (2024), eq. 1 with ε = 0.
//!
//! **Parameters** see [`Params`]. **Limits** a dose cannot be 1 in the part and 0 beside it: the optimum of either is a
//! compromise that a threshold objective does not need to make. The gradient of `l1` jumps at 0, which quasi-Newton steps
//! do not like. **Cost** the label pass of [`band`](super::band); 12 bytes per voxel more for a gray target.
//! **Check** doses 1, 2, 3, 4 with the first two part: 0 + 1 + 9 + 16 = 26.

use super::preset::{BandPreset, LARGEST, SurfaceHandling};
use super::{BuildObjective, read};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

tomolith_core::keys! {
    /// The parameters of `l2` and `l1`.
    pub struct Params {
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

/// Bands of width 0 to a power.
#[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
pub(super) fn to_power(power: f64, params: &Params) -> Result<BandPreset> {
    let weights = [params.part_weight as f32, params.void_weight as f32];
    Ok(BandPreset::around_target(
        0.0,
        weights,
        [power; 2],
        params.surface,
    ))
}

/// The row of least squares.
#[must_use]
pub const fn l2<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "l2",
        summary: "least squares: part to 1, void to 0, or gray values as they are",
        example: "[objective.l2]",
        schema: schema_of::<Params>,
        build: |section| read(section, |params| to_power(2.0, params)),
    }
}

/// The row of least absolute deviation.
#[must_use]
pub const fn l1<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "l1",
        summary: "least absolute deviation: part to 1, void to 0, or gray values as they are",
        example: "[objective.l1]",
        schema: schema_of::<Params>,
        build: |section| read(section, |params| to_power(1.0, params)),
    }
}
