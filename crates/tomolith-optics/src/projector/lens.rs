//! A thin lens before the vial.
//!
//! # Model
//! The lens is a disc of radius `aperture_radius_mm` at x = `distance_mm`. All its points light an image point equally;
//! the image lies `focus_distance_mm` behind the lens, where pixels have their pitch. `distance_mm` ≠ `focus_distance_mm`
//! puts the image beside the rotation axis.

use super::{BuildProjector, Projector, Ray, pixel_pitch};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};
use tomolith_core::units::{Mm, Pitch};

/// See the [module page](self).
#[derive(Clone, Debug, PartialEq)]
pub struct Lens {
    /// Distance of columns and of rows in the image, mm.
    pub pixel_pitch_mm: [f64; 2],
    /// Radius of the lens, mm.
    pub aperture_radius_mm: f64,
    /// From the lens to the rotation axis, mm.
    pub distance_mm: f64,
    /// From the lens to the image, mm.
    pub focus_distance_mm: f64,
}

impl Projector for Lens {
    fn pixel_pitch_mm(&self) -> [f64; 2] {
        self.pixel_pitch_mm
    }

    fn ray(&self, [u, z]: [f64; 2], aperture: [f64; 2]) -> Ray {
        let [a, b] = aperture.map(|v| v * self.aperture_radius_mm);
        let image = [self.distance_mm - self.focus_distance_mm, u, z];
        Ray::through([self.distance_mm, a, b], image)
    }

    fn has_aperture(&self) -> bool {
        self.aperture_radius_mm > 0.0
    }
}

/// Keys of `[light.projector.lens]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Distance of columns and of rows in the image, mm, > 0: one number, or [columns, rows].
    pub pixel_pitch_mm: Pitch,
    /// Radius of the lens, mm; 0 is a diverging bundle from a point.
    #[schemars(extend("minimum" = 0.0))]
    pub aperture_radius_mm: Mm,
    /// From the lens to the rotation axis, mm.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub distance_mm: Mm,
    /// From the lens to the image, mm; default: `distance_mm`.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub focus_distance_mm: Option<Mm>,
}

/// Row of [`PROJECTORS`](super::PROJECTORS).
pub const KIND: Kind<BuildProjector> = Kind {
    name: "lens",
    summary: "A lens of finite aperture that images the pixels at a distance.",
    example: "[light.projector.lens]\npixel_pitch_mm = 0.02\naperture_radius_mm = 4.0\ndistance_mm = 150.0\nfocus_distance_mm = 152.0\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        let Mm(distance_mm) = params.distance_mm;
        Ok(Box::new(Lens {
            pixel_pitch_mm: pixel_pitch(section, params.pixel_pitch_mm)?,
            aperture_radius_mm: params.aperture_radius_mm.0,
            distance_mm,
            focus_distance_mm: params.focus_distance_mm.map_or(distance_mm, |f| f.0),
        }))
    },
};
