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

use super::preset::{AroundTarget, SurfaceHandling, not_negative};
use super::{BuildObjective, ObjectiveInput};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::Kind;

/// The parameters of `l2` and `l1`.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Weight of part voxels, 0 or above (default 1)
    pub part_weight: f64,
    /// Weight of void voxels, 0 or above (default 1)
    pub void_weight: f64,
    /// How voxels cut by the surface are weighed: "voxel" (default), "fraction", or "cells" with a dose on either side
    pub surface: SurfaceHandling,
}

impl Default for Params {
    fn default() -> Self {
        Params {
            part_weight: 1.0,
            void_weight: 1.0,
            surface: SurfaceHandling::Voxel,
        }
    }
}

impl Params {
    /// Bands of width 0 with p = q = `power`.
    #[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
    pub(super) fn bands(&self, power: f64) -> Result<AroundTarget> {
        not_negative("part_weight", self.part_weight)?;
        not_negative("void_weight", self.void_weight)?;
        Ok(AroundTarget {
            half_width: 0.0,
            part_weight: self.part_weight as f32,
            void_weight: self.void_weight as f32,
            p: power,
            q: power,
        })
    }
}

const fn kind<F: Field>(
    name: &'static str,
    summary: &'static str,
    example: &'static str,
    build: BuildObjective<F>,
) -> Kind<BuildObjective<F>> {
    Kind {
        name,
        summary,
        example,
        schema: || schemars::schema_for!(Params),
        build,
    }
}

/// The row of least squares.
#[must_use]
pub const fn l2<F: Field>() -> Kind<BuildObjective<F>> {
    kind(
        "l2",
        "least squares: part to 1, void to 0, or gray values as they are",
        "[objective.l2]",
        |section, input: &ObjectiveInput| {
            let params: Params = section.parse()?;
            let bands = params.bands(2.0).map_err(|e| e.under(&section.path))?;
            bands
                .build(params.surface, input)
                .map_err(|e| e.under(&section.path))
        },
    )
}

/// The row of least absolute deviation.
#[must_use]
pub const fn l1<F: Field>() -> Kind<BuildObjective<F>> {
    kind(
        "l1",
        "least absolute deviation: part to 1, void to 0, or gray values as they are",
        "[objective.l1]",
        |section, input: &ObjectiveInput| {
            let params: Params = section.parse()?;
            let bands = params.bands(1.0).map_err(|e| e.under(&section.path))?;
            bands
                .build(params.surface, input)
                .map_err(|e| e.under(&section.path))
        },
    )
}
