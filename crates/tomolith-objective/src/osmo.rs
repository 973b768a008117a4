//! OSMO's implicit loss: what object-space model optimization descends, as an objective.
//!
//! **Equation** L = Σ_part max(D_h − m, 0)² + Σ_void max(m − D_l, 0)²: part in [D_h, ∞), void in (−∞, D_l], p = q = 2.
//!
//! **Source** Rackson et al., Additive Manufacturing 48 (2021) 102367; that its corrections are gradients of this loss is
//! shown by Li et al. (2024), section 3.3 and eq. 25. The OSMO *method* iterates in object space and is no objective.
//!
//! **Parameters** see [`Params`]; the defaults are those of Pellizzon et al., arXiv 2602.12178. Doses are absolute here: the
//! method's normalization by the largest dose is not part of the loss. **Cost** the label pass of [`band`](super::band).

use super::band::Band;
use super::preset::{BandPreset, LARGEST, SurfaceHandling, below};
use super::{BuildObjective, read};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

tomolith_core::keys! {
    /// The parameters of OSMO's implicit loss.
    pub struct Params {
        /// D_h: smallest response of part voxels without penalty
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub d_h: f64 = 0.9,
        /// D_l: largest response of void voxels without penalty, below `d_h`
        #[schemars(range(min = -LARGEST, max = LARGEST))]
        pub d_l: f64 = 0.85,
        /// How voxels cut by the surface are weighed: "voxel", "fraction", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Voxel,
    }
}

#[expect(clippy::cast_possible_truncation, reason = "bands are f32")]
fn preset(params: &Params) -> Result<BandPreset> {
    let Params { d_h, d_l, surface } = *params;
    below("d_l", d_l, "d_h", d_h)?;
    let bands = [Band::above(d_h as f32), Band::below(d_l as f32)];
    Ok(BandPreset {
        thresholds: Some([d_l, d_h]),
        ..BandPreset::new(bands, [2.0; 2], surface)
    })
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "osmo",
        summary: "OSMO's implicit loss: part above D_h, void below D_l, squared",
        example: "[objective.osmo]\nd_h = 0.9\nd_l = 0.85",
        schema: schema_of::<Params>,
        build: |section| read(section, preset),
    }
}
