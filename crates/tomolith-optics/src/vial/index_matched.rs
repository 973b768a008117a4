//! Resin in a bath of its own index: light passes straight, nothing is reflected.
//!
//! # Model
//! A cylinder of resin of radius `radius_mm` whose wall and surroundings have the resin's refractive index. Rays stay
//! straight; only the resin absorbs.
//!
//! # Limits
//! The bath does not absorb. `vial.surrounding_index` has no effect.
//!
//! # Example
//! ```
//! use tomolith_optics::vial::{Vial, index_matched::IndexMatched};
//! let vial = IndexMatched { radius_mm: 6.0 };
//! assert!(vial.in_resin([5.9, 0.0, 0.0]) && !vial.in_resin([6.1, 0.0, 0.0]));
//! assert_eq!(vial.reach_mm(5.0, 1.0, 1.0), 5.0); // a projector that covers ±5 mm lights 5 mm from all sides
//! ```

use super::{BuildVial, CrossSection, Medium, Vial, Wall, positive};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::Mm;

/// See the [module page](self).
#[derive(Clone, Debug)]
pub struct IndexMatched {
    /// Radius of the resin, mm.
    pub radius_mm: f64,
}

impl Vial for IndexMatched {
    fn walls(&self) -> Vec<Wall> {
        vec![Wall {
            curve: CrossSection::Circle(self.radius_mm),
            inside: Medium::Resin,
        }]
    }

    fn surrounding_index(&self, _asked: f64, resin: f64) -> f64 {
        resin
    }
}

/// Keys of `[vial.index_matched]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Radius of the resin, mm, > 0.
    pub radius_mm: Mm,
}

/// Row of [`VIALS`](super::VIALS).
pub const KIND: Kind<BuildVial> = Kind {
    name: "index_matched",
    summary: "Resin in a bath of its own refractive index: straight rays, no reflections.",
    example: "[vial.index_matched]\nradius_mm = 6.0\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        Ok(Box::new(IndexMatched {
            radius_mm: positive(section, "radius_mm", params.radius_mm.0)?,
        }))
    },
};
