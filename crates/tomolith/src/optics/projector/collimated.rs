//! Parallel rays, perpendicular to the lateral axis of the pixels.
//!
//! # Model
//! The ray of the image point (u, z) is y = u, at height z, along −x. It has no aperture: the light of a point is one ray.
//!
//! # Parameters
//! | key | unit | range | meaning |
//! |---|---|---|---|
//! | `pixel_pitch_mm` | mm | > 0 | distance of columns and of rows |

use super::{BuildProjector, Projector, Ray};
use crate::kind::Kind;
use crate::optics::vial::positive;
use crate::units::Mm;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// See the [module page](self).
#[derive(Clone, Debug, PartialEq)]
pub struct Collimated {
    /// Distance of columns and of rows, mm.
    pub pixel_pitch_mm: f64,
}

impl Projector for Collimated {
    fn pixel_pitch_mm(&self) -> f64 {
        self.pixel_pitch_mm
    }

    fn ray(&self, [u, z]: [f64; 2], _aperture: [f64; 2]) -> Ray {
        Ray {
            from: [0.0, u, z],
            direction: [-1.0, 0.0, 0.0],
        }
    }

    fn is_collimated(&self) -> bool {
        true
    }
}

/// Keys of `[projector.collimated]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Distance of columns and of rows at the vial, mm, > 0.
    pub pixel_pitch_mm: Mm,
}

/// Row of [`PROJECTORS`](super::PROJECTORS).
pub const KIND: Kind<BuildProjector> = Kind {
    name: "collimated",
    summary: "Parallel rays.",
    example: "[projector.collimated]\npixel_pitch_mm = 0.02\n",
    schema: || schemars::schema_for!(Params),
    build: |section| {
        let params: Params = section.parse()?;
        Ok(Box::new(Collimated {
            pixel_pitch_mm: positive(section, "pixel_pitch_mm", params.pixel_pitch_mm.0)?,
        }))
    },
};
