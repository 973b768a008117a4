//! Resin between two concentric tubes.
//!
//! # Model
//! Four concentric circles: surroundings, outer glass, resin, inner glass, and a clear medium inside the inner tube (air,
//! water or an index-matched fluid). A ray that crosses the inner tube lights the resin twice, before and after it; one
//! that is totally reflected there is lost behind it.
//!
//! # Source
//! The set-up of Nicolet et al. 2024 (double cylindrical vial).
//!
//! # Example
//! ```
//! use tomolith_optics::vial::{Vial, double_tube::DoubleTube};
//! let vial = DoubleTube::new([7.354, 6.363, 3.18, 2.58], [1.5, 1.5, 1.33]);
//! assert!(vial.in_resin([5.0, 0.0, 0.0])); // between the tubes
//! assert!(!vial.in_resin([3.0, 0.0, 0.0]) && !vial.in_resin([1.0, 0.0, 0.0])); // inner glass, core
//! ```

use super::{BuildVial, CrossSection, Medium, Vial, Wall, inner_below_outer, positive};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::Mm;

/// See the [module page](self).
#[derive(Clone, Debug)]
pub struct DoubleTube {
    radii_mm: [f64; 4],
    refractive_indices: [f64; 3],
}

impl DoubleTube {
    /// Tubes of these radii from outside to inside, mm: outer glass, resin, inner glass, core; with the refractive indices of the outer tube, the inner
    /// tube, and what is inside it.
    #[must_use]
    pub const fn new(radii_mm: [f64; 4], refractive_indices: [f64; 3]) -> Self {
        DoubleTube {
            radii_mm,
            refractive_indices,
        }
    }
}

impl Vial for DoubleTube {
    fn walls(&self) -> Vec<Wall> {
        let [outer, inner, core] = self.refractive_indices.map(Medium::Clear);
        let inside = [outer, Medium::Resin, inner, core];
        self.radii_mm
            .iter()
            .zip(inside)
            .map(|(&r, inside)| Wall {
                curve: CrossSection::Circle(r),
                inside,
            })
            .collect()
    }
}

/// Keys of `[vial.double_tube]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Outer radius of the outer tube, mm.
    pub outer_radius_mm: Mm,
    /// Inner radius of the outer tube: where the resin begins, mm.
    pub resin_outer_radius_mm: Mm,
    /// Outer radius of the inner tube: where the resin ends, mm.
    pub resin_inner_radius_mm: Mm,
    /// Inner radius of the inner tube, mm.
    pub inner_radius_mm: Mm,
    /// Refractive index of the outer tube.
    #[schemars(range(min = 1.0, max = 4.0))]
    pub outer_refractive_index: f64,
    /// Refractive index of the inner tube.
    #[schemars(range(min = 1.0, max = 4.0))]
    pub inner_refractive_index: f64,
    /// Refractive index of what is inside the inner tube.
    #[schemars(range(min = 1.0, max = 4.0))]
    #[serde(default = "air")]
    pub core_refractive_index: f64,
}

fn air() -> f64 {
    1.0
}

/// Row of [`VIALS`](super::VIALS).
pub const KIND: Kind<BuildVial> = Kind {
    name: "double_tube",
    summary: "Resin between two concentric tubes.",
    example: "[vial.double_tube]\nouter_radius_mm = 7.354\nresin_outer_radius_mm = 6.363\nresin_inner_radius_mm = 3.18\n\
              inner_radius_mm = 2.58\nouter_refractive_index = 1.5\ninner_refractive_index = 1.5\ncore_refractive_index = 1.33\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        let keys = [
            ("outer_radius_mm", params.outer_radius_mm.0),
            ("resin_outer_radius_mm", params.resin_outer_radius_mm.0),
            ("resin_inner_radius_mm", params.resin_inner_radius_mm.0),
            ("inner_radius_mm", params.inner_radius_mm.0),
        ];
        for (key, value) in keys {
            positive(section, key, value)?;
        }
        for pair in keys.windows(2) {
            inner_below_outer(section, pair[1], pair[0])?;
        }
        let indices = [
            params.outer_refractive_index,
            params.inner_refractive_index,
            params.core_refractive_index,
        ];
        Ok(Box::new(DoubleTube::new(keys.map(|key| key.1), indices)))
    },
};
