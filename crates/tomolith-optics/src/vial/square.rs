//! A square cuvette that turns with the resin.
//!
//! # Model
//! Two concentric squares, faces normal to x and y of the resin frame. Each lit face bends its part of a frame into one
//! straight parallel bundle; near an edge a ray may enter through one face and reach the resin through the next.
//!
//! # Source
//! Nicolet et al. 2024 (square cuvette, 10.07 / 12.43 mm).
//!
//! # Limits
//! Sharp edges; light that is totally reflected at a wall is lost.
//!
//! # Example
//! ```
//! use tomolith_optics::vial::{Vial, square::Square};
//! let vial = Square { inner_width_mm: 10.0, outer_width_mm: 12.4, refractive_index: 1.54 };
//! assert!(vial.in_resin([4.9, -4.9, 0.0]) && !vial.in_resin([5.1, 0.0, 0.0]));
//! assert!(!vial.is_round());
//! ```

use super::{BuildVial, CrossSection, Medium, Vial, Wall, inner_below_outer, positive};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::Mm;

/// See the [module page](self).
#[derive(Clone, Debug)]
pub struct Square {
    /// Full width of the resin, mm.
    pub inner_width_mm: f64,
    /// Full outer width, mm.
    pub outer_width_mm: f64,
    /// Refractive index of the wall.
    pub refractive_index: f64,
}

impl Square {
    /// A cuvette of these widths, of the resin and of the wall.
    #[must_use]
    pub const fn new(inner_width_mm: f64, outer_width_mm: f64, refractive_index: f64) -> Self {
        Square {
            inner_width_mm,
            outer_width_mm,
            refractive_index,
        }
    }
}

impl Vial for Square {
    fn walls(&self) -> Vec<Wall> {
        vec![
            Wall {
                curve: CrossSection::Square(self.outer_width_mm / 2.0),
                inside: Medium::Clear(self.refractive_index),
            },
            Wall {
                curve: CrossSection::Square(self.inner_width_mm / 2.0),
                inside: Medium::Resin,
            },
        ]
    }
}

/// Keys of `[vial.square]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Full width of the resin, mm, > 0.
    pub inner_width_mm: Mm,
    /// Full outer width, mm, > inner.
    pub outer_width_mm: Mm,
    /// Refractive index of the wall.
    #[schemars(range(min = 1.0, max = 4.0))]
    pub refractive_index: f64,
}

/// Row of [`VIALS`](super::VIALS).
pub const KIND: Kind<BuildVial> = Kind {
    name: "square",
    summary: "A square cuvette that turns with the resin.",
    example: "[vial.square]\ninner_width_mm = 10.07\nouter_width_mm = 12.43\nrefractive_index = 1.58\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        let inner = positive(section, "inner_width_mm", params.inner_width_mm.0)?;
        let outer = positive(section, "outer_width_mm", params.outer_width_mm.0)?;
        inner_below_outer(
            section,
            ("inner_width_mm", inner),
            ("outer_width_mm", outer),
        )?;
        Ok(Box::new(Square::new(inner, outer, params.refractive_index)))
    },
};
