//! A cone of light from a point.
//!
//! # Model
//! All rays start at x = `distance_mm` on the optical axis; the ray of (u, z) passes that point of the plane through the
//! rotation axis, where pixels have their pitch. (A [`lens`](super::lens) without aperture.)

use super::lens::Lens;
use super::{BuildProjector, Projector, Ray, pixel_pitch};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::{Mm, Pitch};

/// See the [module page](self).
#[derive(Clone, Debug, PartialEq)]
pub struct Diverging(Lens);

impl Diverging {
    /// A cone whose pixels have `pixel_pitch_mm` at the rotation axis, `distance_mm` from its tip.
    #[must_use]
    pub fn new(pixel_pitch_mm: [f64; 2], distance_mm: f64) -> Self {
        Diverging(Lens {
            pixel_pitch_mm,
            aperture_radius_mm: 0.0,
            distance_mm,
            focus_distance_mm: distance_mm,
        })
    }
}

impl Projector for Diverging {
    fn pixel_pitch_mm(&self) -> [f64; 2] {
        self.0.pixel_pitch_mm
    }

    fn ray(&self, point: [f64; 2], aperture: [f64; 2]) -> Ray {
        self.0.ray(point, aperture)
    }
}

/// Keys of `[light.projector.diverging]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Distance of columns and of rows at the rotation axis, mm, > 0: one number, or [columns, rows].
    pub pixel_pitch_mm: Pitch,
    /// From the tip of the cone to the rotation axis, mm.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub distance_mm: Mm,
}

/// Row of [`PROJECTORS`](super::PROJECTORS).
pub const KIND: Kind<BuildProjector> = Kind {
    name: "diverging",
    summary: "A cone of light from a point.",
    example: "[light.projector.diverging]\npixel_pitch_mm = 0.02\ndistance_mm = 150.0\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        Ok(Box::new(Diverging::new(
            pixel_pitch(section, params.pixel_pitch_mm)?,
            params.distance_mm.0,
        )))
    },
};
