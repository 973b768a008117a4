//! The `orders` dose model: a resin that scatters, without random numbers.
//!
//! # Model
//! Straight light is `parallel`, with the total attenuation. What is scattered out of it is followed order by order as a convolution
//! with the kernel of free flight, on cells much larger than voxels. Light that leaves the resin does not come back.
//!
//! # Equation
//! ```text
//! dose = A x + I₁·K₁·c(x) + I₂·Σ_{n≥2} K^n·c(x)
//! ```
//! A: [`Parallel`]. c: moments of the straight light on cells, by [`Parallel`] with patterns weighted by cos mφ and sin mφ. K: free
//! flight and scattering (`flight.rs`). I₁, I₂: interpolation from the cells of order 1 and of later orders to voxels.
//!
//! # Source
//! docs/scattering.md, eqs. 1 and 2; Chandrasekhar, *Radiative Transfer* (1950), ch. I; forward lobes: Wiscombe, J. Atmos. Sci. 34
//! (1977) 1408.
//!
//! # Parameters
//! | key | range | default | meaning |
//! |---|---|---|---|
//! | `cell_mm` | > 0 | 0.04/μ_s, between 1/32 and 1/12 of the resin's radius | edge of the cells of order 1 |
//!
//! # Limits
//! Collimated light normal to the axis; a vial that is the same at all heights and whose resin fills a circle or a square; no reflections at
//! walls; at most 3 % of the scattered light in a forward lobe beyond degree 3 (Henyey–Greenstein to g = 0.41). Errors against random paths: docs/scattering.md.
//!
//! # Cost
//! Beside `parallel`: the same on 1/100 to 1/1000 of the voxels, for every harmonic (three for Rayleigh), and Fourier transforms of the
//! cells of the resin, padded: four of the fine ones, about sixty of the coarse ones.
//!
//! # Example
//! In a resin that scatters, some light reaches heights that no pixel lights:
//! ```
//! use std::sync::Arc;
//! use tomolith::field::{Field, HostField};
//! use tomolith::grid::{PatternGrid, VolumeGrid};
//! use tomolith::models::{DoseModel, Run, orders, parallel::Light};
//! use tomolith::optics::phase::{Scattering, rayleigh::Rayleigh};
//! use tomolith::optics::{resin::Resin, vial::index_matched::IndexMatched};
//! let mut light = Light::new(PatternGrid::full_turn(8, 0.0, 2, 16, 0.25), Resin::absorbing(1.5, 0.1));
//! light.resin.attenuation_per_mm = 0.3;
//! let scattering = Scattering { per_mm: 0.2, phase: Arc::new(Rayleigh {}) };
//! let vial = IndexMatched { radius_mm: 3.0 };
//! let grid = VolumeGrid::centered([16, 8, 8], 0.25);
//! let model = orders::model(&vial, vec![light], &[Some(scattering)], &orders::Params::default(), grid).unwrap();
//! let mut x = model.new_patterns().unwrap();
//! x.fill(1.0);
//! let mut dose = model.new_dose().unwrap();
//! model.dose(&x, &mut dose, &Run::new()).unwrap();
//! let dose = model.outputs()[0].volume_of(dose.as_slice());
//! let (lit, dark) = (*dose.at(8, 4, 4), *dose.at(0, 4, 4)); // pixels reach ±0.25 mm, these lie at 0.125 and −1.875 mm
//! assert!(dark > 0.005 * lit && dark < 0.05 * lit);
//! ```

mod bins;
mod convolver;
mod far;
mod flight;
mod glow;
mod harmonics;

use super::parallel::{Light, Parallel};
use super::{Choice, ChooseModel, DoseLayout, LinearOperator, PatternLayout, Run, ZCoupling};
use crate::error::{Error, Result};
use crate::field::HostField;
use crate::grid::VolumeGrid;
use crate::kind::Kind;
use crate::optics::phase::Scattering;
use crate::optics::vial::Vial;
use glow::{Folded, Glow};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Keys of `[model.orders]`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Edge of the cells on which light scattered once is computed, mm; later orders use larger ones.
    pub cell_mm: Option<f64>,
}

/// Row of [`MODELS`](super::MODELS).
pub const KIND: Kind<ChooseModel> = Kind {
    name: "orders",
    summary: "Collimated light in a resin that scatters, order by order: convolutions instead of random paths.",
    example: "[model.orders]\ncell_mm = 0.2\n",
    schema: || schemars::schema_for!(Params),
    build: |section| {
        let params: Params = section.parse()?;
        match params.cell_mm {
            Some(edge) if !(edge.is_finite() && edge > 0.0) => Err(Error::config(
                format!("{}.cell_mm", section.path),
                format!("found {edge}"),
                "a finite number > 0",
            )),
            _ => Ok(Choice::Orders(params)),
        }
    },
};

/// See the [module page](self).
pub struct Orders {
    straight: Parallel,
    /// Of each light that is scattered.
    glows: Vec<Glow>,
}

/// Largest part of scattered light that may count as straight: above, the dose is more than 1 % off (docs/scattering.md).
const LOBE: f64 = 0.03;

/// The model of a vial, its lights with what scatters them, and the voxels where dose is wanted.
///
/// # Errors
/// As [`Parallel::new`]; [`Error::Unsupported`] where [`beyond`] says why.
pub fn model(
    vial: &dyn Vial,
    mut lights: Vec<Light>,
    scattering: &[Option<Scattering>],
    params: &Params,
    grid: VolumeGrid,
) -> Result<Orders> {
    if let Some(reason) = beyond(vial, &lights, scattering, &grid) {
        return Err(Error::Unsupported {
            what: "model.orders".into(),
            reason: format!("{reason}; use [model.scatter]"),
        });
    }
    let layout = DoseLayout::new("dose", grid.clone(), 0);
    let mut plans = Vec::new();
    let (mut offset, mut first_frame) = (0, 0);
    for (light, scattering) in lights.iter_mut().zip(scattering) {
        let place = (offset, first_frame);
        offset += light.layout(0).len();
        first_frame += light.pixels.frames();
        if let Some(scattering) = scattering {
            let folded = Folded::new(scattering);
            light.resin.attenuation_per_mm -= folded.straight_per_mm;
            plans.push((place, light.clone(), folded));
        }
    }
    let straight = Parallel::new(vial, lights, grid)?;
    let glows = plans
        .into_iter()
        .map(|(place, light, folded)| Glow::new(vial, light, &folded, params, &layout, place))
        .collect::<Result<_>>()?;
    Ok(Orders { straight, glows })
}

/// Why the model does not cover a vial and its lights, beside what [`Parallel`] does not; None when it does.
#[must_use]
pub fn beyond(
    vial: &dyn Vial,
    lights: &[Light],
    scattering: &[Option<Scattering>],
    grid: &VolumeGrid,
) -> Option<&'static str> {
    let folded = scattering.iter().flatten().map(Folded::new);
    if folded.into_iter().any(|f| f.lobe > LOBE) {
        Some("much light is scattered into a narrow forward lobe")
    } else if !vial.is_convex() {
        Some("the resin is not all in sight of itself")
    } else if lights.iter().any(|light| light.map.is_some()) {
        Some("the absorption changes across the plane")
    } else if grid.shape[0] == 1 {
        Some("a single slice does not say how high light is scattered")
    } else {
        None
    }
}

impl LinearOperator for Orders {
    type Field = HostField;

    fn patterns(&self) -> &[PatternLayout] {
        LinearOperator::patterns(&self.straight)
    }

    fn outputs(&self) -> &[DoseLayout] {
        LinearOperator::outputs(&self.straight)
    }

    fn new_patterns(&self) -> Result<HostField> {
        LinearOperator::new_patterns(&self.straight)
    }

    fn new_dose(&self) -> Result<HostField> {
        LinearOperator::new_dose(&self.straight)
    }

    fn add_forward(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        self.straight.add_forward(frames.clone(), x, dose, run)?;
        for glow in &self.glows {
            glow.add_forward(frames.clone(), x.as_slice(), dose.as_mut_slice(), run)?;
        }
        Ok(())
    }

    fn adjoint(&self, cotangent: &HostField, grad: &mut HostField, run: &Run) -> Result<()> {
        self.straight.adjoint(cotangent, grad, run)?;
        for glow in &self.glows {
            glow.add_adjoint(cotangent.as_slice(), grad.as_mut_slice(), run)?;
        }
        Ok(())
    }

    fn z_coupling(&self) -> ZCoupling {
        ZCoupling::Full
    }

    fn updates(&self) -> u64 {
        LinearOperator::updates(&self.straight) + self.glows.iter().map(Glow::updates).sum::<u64>()
    }

    fn describe(&self) -> String {
        let of_light: Vec<String> = self.glows.iter().map(Glow::describe).collect();
        format!(
            "orders ({}; scattered light on {})",
            LinearOperator::describe(&self.straight),
            of_light.join(" and ")
        )
    }
}

#[cfg(test)]
mod tests;
