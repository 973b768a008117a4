//! A telecentric lens: every image point is lit by the same cone, whose axis is parallel to x.
//!
//! # Model
//! The image plane is x = `focus_mm` (0: through the rotation axis). A point of it is lit from a disc of radius
//! `aperture_radius_mm` at the distance `working_distance_mm` in front of it, so that sin of the cone's half angle is
//! about aperture/distance; the disc moves along with the point, so pixels have the same pitch everywhere. All points of
//! the disc give the same power.

use super::{BuildProjector, Projector, Ray, pixel_pitch};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::{Mm, Pitch};

/// See the [module page](self).
#[derive(Clone, Debug, PartialEq)]
pub struct Telecentric {
    /// Distance of columns and of rows in the image, mm.
    pub pixel_pitch_mm: [f64; 2],
    /// Radius of the disc that lights a point, mm.
    pub aperture_radius_mm: f64,
    /// From the disc to the image, mm.
    pub working_distance_mm: f64,
    /// x of the image plane, mm.
    pub focus_mm: f64,
}

impl Projector for Telecentric {
    fn pixel_pitch_mm(&self) -> [f64; 2] {
        self.pixel_pitch_mm
    }

    fn ray(&self, [u, z]: [f64; 2], aperture: [f64; 2]) -> Ray {
        let [a, b] = aperture.map(|v| v * self.aperture_radius_mm);
        let image = [self.focus_mm, u, z];
        Ray::through(
            [self.focus_mm + self.working_distance_mm, u + a, z + b],
            image,
        )
    }

    fn is_collimated(&self) -> bool {
        self.aperture_radius_mm == 0.0
    }

    fn has_aperture(&self) -> bool {
        self.aperture_radius_mm > 0.0
    }
}

/// Keys of `[light.projector.telecentric]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Distance of columns and of rows in the image, mm, > 0: one number, or [columns, rows].
    pub pixel_pitch_mm: Pitch,
    /// Radius of the disc that lights an image point, mm; 0 is collimated light.
    #[schemars(extend("minimum" = 0.0))]
    pub aperture_radius_mm: Mm,
    /// From the disc to the image, mm.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub working_distance_mm: Mm,
    /// The image lies this far before the rotation axis, seen from the projector, mm.
    #[serde(default)]
    pub focus_mm: Mm,
}

/// Row of [`PROJECTORS`](super::PROJECTORS).
pub const KIND: Kind<BuildProjector> = Kind {
    name: "telecentric",
    summary: "Cones of light with parallel axes: a pitch that does not depend on the distance, and a depth of focus.",
    example: "[light.projector.telecentric]\npixel_pitch_mm = 0.02\naperture_radius_mm = 1.0\nworking_distance_mm = 100.0\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        Ok(Box::new(Telecentric {
            pixel_pitch_mm: pixel_pitch(section, params.pixel_pitch_mm)?,
            aperture_radius_mm: params.aperture_radius_mm.0,
            working_distance_mm: params.working_distance_mm.0,
            focus_mm: params.focus_mm.0,
        }))
    },
};
