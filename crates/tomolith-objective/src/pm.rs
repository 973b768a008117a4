//! Penalty minimization: part above d_h, void below d_l; voxels near the surface do not count.
//!
//! **Equation** part in [d_h, ∞) with weight ρ₁, void in (−∞, d_l] with weight ρ₂, p = q; voxels within `buffer_mm` of a voxel
//! of the other kind have weight 0
//!
//! ```text
//! L = ρ₁·Σ_R1 max(d_h − m, 0)^p + ρ₂·Σ_R2 max(m − d_l, 0)^p
//! ```
//!
//! **Source** Bhattacharya, Toombs and Taylor, Additive Manufacturing 47 (2021) 102299; in the form of Li et al. (2024),
//! eq. 8: R₁ is the eroded part, R₂ the eroded void. (Some programs call the void's weight ρ₁.)
//!
//! **Parameters** see [`Params`]. **Limits** a buffer wider than a feature leaves that feature without any penalty.
//! **Cost** the label pass of [`band`](super::band); the buffer costs two distance transforms once.

use super::band::Band;
use super::preset::{BandPreset, HIGHEST_POWER, LARGEST, SurfaceHandling, below};
use super::{BuildObjective, read};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::Mm;

tomolith_core::keys! {
    /// The parameters of penalty minimization.
    pub struct Params {
        /// Smallest response of part voxels without penalty
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub d_h: f64 = 0.8,
        /// Largest response of void voxels without penalty, below `d_h`
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub d_l: f64 = 0.7,
        /// Weight of the part
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub rho_1: f64 = 1.0,
        /// Weight of the void
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub rho_2: f64 = 1.0,
        /// Power of the distance from the band
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = HIGHEST_POWER))]
        pub p: f64 = 1.0,
        /// Voxels this near to a voxel of the other kind do not count, mm; with 0 all count
        #[schemars(extend("minimum" = 0.0, "maximum" = LARGEST))]
        pub buffer_mm: Mm = Mm(0.0),
        /// How voxels cut by the surface are weighed: "voxel", "fraction", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Voxel,
    }
}

#[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
fn preset(params: &Params) -> Result<BandPreset> {
    let Params { d_h, d_l, .. } = *params;
    below("d_l", d_l, "d_h", d_h)?;
    let part = Band::above(d_h as f32).weighing(params.rho_1 as f32);
    let void = Band::below(d_l as f32).weighing(params.rho_2 as f32);
    Ok(BandPreset {
        thresholds: Some([d_l, d_h]),
        buffer_mm: params.buffer_mm.0,
        ..BandPreset::new([part, void], [params.p; 2], params.surface)
    })
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "pm",
        summary: "penalty minimization: part above d_h, void below d_l, a free buffer at the surface",
        example: "[objective.pm]\nd_h = 0.8\nd_l = 0.7\nbuffer_mm = 0.05",
        schema: schema_of::<Params>,
        build: |section| read(section, preset),
    }
}
