//! Threshold: the part above one dose, the void below another, nothing above the ceiling.
//!
//! **What it models.** A resin that turns solid somewhere between two doses: part voxels in [`upper`, `ceiling`], void voxels
//! below `lower`. Everything between `lower` and `upper` is process window.
//!
//! **Equation** p = q = `exponent`
//!
//! ```text
//! L = w_part·Σ_part max(upper − m, m − ceiling, 0)^K + w_void·Σ_void max(m − lower, 0)^K
//! ```
//!
//! **Source** Nicolet et al., Inverse Rendering for Tomographic Volumetric Additive Manufacturing (2024), section 4 (T_L is
//! our `lower`, T_U our `upper`, K our `exponent`); Wechsler et al. (2024).
//!
//! **Parameters** see [`Params`]. **Cost** the label pass of [`band`](super::band), bound by memory for whole exponents from 1 to 8.
//! **Check** doses .5, .97 (part), .92, .5 (void) with lower .9 and upper .95 cost 0.45² + 0.02² = 0.2029.

use super::band::Band;
use super::preset::{BandPreset, HIGHEST_POWER, LARGEST, SurfaceHandling, below};
use super::{BuildObjective, Chosen, read};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::exact;

tomolith_core::keys! {
    /// The parameters of the threshold objective.
    pub struct Params {
        /// Largest response of void voxels without penalty, below `upper` (default 0.7)
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub lower: Option<f64>,
        /// Smallest response of part voxels without penalty (default 0.9)
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub upper: Option<f64>,
        /// Largest response of part voxels without penalty, at least `upper`
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub ceiling: f64 = 1.0,
        /// Power of the distance from the band (default 2; 4 where the program chooses voxels of at most half a pixel)
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = HIGHEST_POWER))]
        pub exponent: Option<f64>,
        /// Weight of part voxels
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub part_weight: f64 = 1.0,
        /// Weight of void voxels
        #[schemars(range(min = 0.0, max = LARGEST))]
        pub void_weight: f64 = 1.0,
        /// How voxels cut by the surface are weighed: "fraction", "voxel" as published, or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Fraction,
    }
}

/// Largest response of void voxels without penalty where a job names none.
pub const LOWER: f64 = 0.7;
/// Smallest response of part voxels without penalty where a job names none.
pub const UPPER: f64 = 0.9;
/// The exponent of the publications.
const PUBLISHED: f64 = 2.0;

#[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
fn preset(params: &Params) -> Result<BandPreset> {
    let lower = params.lower.unwrap_or(LOWER);
    let upper = params.upper.unwrap_or(UPPER);
    let exponent = params.exponent.unwrap_or(PUBLISHED);
    below("lower", lower, "upper", upper)?;
    if params.ceiling < upper {
        return Err(tomolith_core::Error::config(
            "ceiling",
            format!(
                "ceiling {} is below upper {}",
                exact(params.ceiling),
                exact(upper)
            ),
            "ceiling ≥ upper",
        ));
    }
    let weight = params.part_weight as f32;
    let part = Band::new(upper as f32, params.ceiling as f32, weight);
    let void = Band::below(lower as f32).weighing(params.void_weight as f32);
    Ok(BandPreset {
        thresholds: Some([lower, upper]),
        open: Some(params.clone()),
        ..BandPreset::new([part, void], [exponent; 2], params.surface)
    })
}

impl Params {
    /// The preset with a parameter that the program chooses; None where the job names it.
    pub(super) fn with(&self, chosen: Chosen) -> Option<BandPreset> {
        let mut params = self.clone();
        let named = match chosen {
            Chosen::Lower(lower) => params.lower.replace(lower).or(self.upper),
            Chosen::Exponent(exponent) => params.exponent.replace(exponent),
        };
        match named {
            Some(_) => None,
            None => preset(&params).ok(),
        }
    }
}

/// What it is called in a job.
pub const NAME: &str = "threshold";

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: NAME,
        summary: "part between an upper threshold and the ceiling, void below a lower threshold",
        example: "[objective.threshold]\nlower = 0.7\nupper = 0.9",
        schema: schema_of::<Params>,
        build: |section| read(section, preset),
    }
}
