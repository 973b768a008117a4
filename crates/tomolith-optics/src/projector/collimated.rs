//! Parallel rays, perpendicular to the lateral axis of the pixels.
//!
//! # Model
//! The ray of the image point (u, z) is y = u, at height z, along −x. It has no aperture: the light of a point is one ray.

use super::{BuildProjector, Projector, Ray, pixel_pitch};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::Pitch;

/// See the [module page](self).
#[derive(Clone, Debug, PartialEq)]
pub struct Collimated {
    /// Distance of columns and of rows, mm.
    pub pixel_pitch_mm: [f64; 2],
}

impl Projector for Collimated {
    fn pixel_pitch_mm(&self) -> [f64; 2] {
        self.pixel_pitch_mm
    }

    fn ray(&self, [u, z]: [f64; 2], _aperture: [f64; 2]) -> Ray {
        Ray::new([0.0, u, z], [-1.0, 0.0, 0.0])
    }

    fn is_collimated(&self) -> bool {
        true
    }
}

/// Keys of `[light.projector.collimated]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Distance of columns and of rows at the vial, mm, > 0: one number, or [columns, rows].
    pub pixel_pitch_mm: Pitch,
}

/// Row of [`PROJECTORS`](super::PROJECTORS).
pub const KIND: Kind<BuildProjector> = Kind {
    name: "collimated",
    summary: "Parallel rays.",
    example: "[light.projector.collimated]\npixel_pitch_mm = 0.02\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        Ok(Box::new(Collimated {
            pixel_pitch_mm: pixel_pitch(section, params.pixel_pitch_mm)?,
        }))
    },
};
