//! A round vial in air or in a bath.
//!
//! # Model
//! Two concentric circles: surroundings (index n_s), glass (n_g), resin (n_r). A ray at distance u from the axis is
//! refracted at each wall; Bouguer's invariant n·b is the same in every medium, so inside the resin it passes the axis at
//! b = u·n_s/n_r. Light is therefore tangent only up to n_s·R_o/n_r; beyond, a point is lit by up to two rays of one
//! frame.
//!
//! # Source
//! Nicolet et al. 2024 (ray-traced vials); Born & Wolf §3.2 for Bouguer's formula.
//!
//! # Example
//! ```
//! use tomolith_optics::vial::{Vial, cylinder::Cylinder};
//! let vial = Cylinder { inner_radius_mm: 8.0, outer_radius_mm: 8.7, refractive_index: 1.58 };
//! // in air, resin of index 1.4849: tangent light up to 8.7/1.4849 = 5.859 mm
//! assert!((vial.reach_mm(100.0, 1.0, 1.4849) - 5.859).abs() < 1e-3);
//! ```

use super::{BuildVial, CrossSection, Medium, Vial, Wall, inner_below_outer, positive};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::Mm;

/// See the [module page](self).
#[derive(Clone, Debug)]
pub struct Cylinder {
    /// Radius of the resin, mm.
    pub inner_radius_mm: f64,
    /// Outer radius of the glass, mm.
    pub outer_radius_mm: f64,
    /// Refractive index of the glass.
    pub refractive_index: f64,
}

impl Cylinder {
    /// A vial of these radii, of the resin and of the glass.
    #[must_use]
    pub const fn new(inner_radius_mm: f64, outer_radius_mm: f64, refractive_index: f64) -> Self {
        Cylinder {
            inner_radius_mm,
            outer_radius_mm,
            refractive_index,
        }
    }
}

impl Vial for Cylinder {
    fn walls(&self) -> Vec<Wall> {
        vec![
            Wall {
                curve: CrossSection::Circle(self.outer_radius_mm),
                inside: Medium::Clear(self.refractive_index),
            },
            Wall {
                curve: CrossSection::Circle(self.inner_radius_mm),
                inside: Medium::Resin,
            },
        ]
    }
}

/// Keys of `[vial.cylinder]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Radius of the resin, mm, > 0.
    pub inner_radius_mm: Mm,
    /// Outer radius of the glass, mm, > inner.
    pub outer_radius_mm: Mm,
    /// Refractive index of the glass.
    #[schemars(range(min = 1.0, max = 4.0))]
    pub refractive_index: f64,
}

/// Row of [`VIALS`](super::VIALS).
pub const KIND: Kind<BuildVial> = Kind {
    name: "cylinder",
    summary: "A round glass vial in air or in a bath: Snell and Fresnel at both walls.",
    example: "[vial.cylinder]\ninner_radius_mm = 7.6\nouter_radius_mm = 8.3\nrefractive_index = 1.58\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        let inner = positive(section, "inner_radius_mm", params.inner_radius_mm.0)?;
        let outer = positive(section, "outer_radius_mm", params.outer_radius_mm.0)?;
        inner_below_outer(
            section,
            ("inner_radius_mm", inner),
            ("outer_radius_mm", outer),
        )?;
        Ok(Box::new(Cylinder::new(
            inner,
            outer,
            params.refractive_index,
        )))
    },
};
