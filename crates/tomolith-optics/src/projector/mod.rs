//! Projectors: the ray that leaves a point of a pixel.
//!
//! *What must it do, and who does it.* A projector is its ray bundle: for a point (u, z) of the pixels' image and a point of the
//! aperture it gives one ray in its own frame, in which the light comes from +x, y is the lateral coordinate u of the
//! pixel columns, z is up, and the rotation axis passes the origin. The image lies in a plane x = const; pixels have
//! their pitch there, and a pattern value is an areal dose there.

pub mod collimated;
pub mod diverging;
pub mod lens;
pub mod telecentric;

use crate::vial::positive;
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section};
use tomolith_core::units::Pitch;

/// A straight line with a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// A point of it, mm.
    pub from: [f64; 3],
    /// Unit direction of travel.
    pub direction: [f64; 3],
}

impl Ray {
    /// The ray from a point in a unit direction.
    #[must_use]
    pub const fn new(from: [f64; 3], direction: [f64; 3]) -> Self {
        Ray { from, direction }
    }

    /// The ray from a point toward another.
    #[must_use]
    pub fn through(from: [f64; 3], to: [f64; 3]) -> Self {
        let way: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
        let length = way.iter().map(|w| w * w).sum::<f64>().sqrt();
        Ray {
            from,
            direction: way.map(|w| w / length),
        }
    }

    /// The point `distance` mm further on.
    #[must_use]
    pub fn at(&self, distance: f64) -> [f64; 3] {
        std::array::from_fn(|i| self.from[i] + distance * self.direction[i])
    }
}

/// The optics of a light.
pub trait Projector: std::fmt::Debug + Send + Sync {
    /// Distance of columns and of rows in the image, mm.
    fn pixel_pitch_mm(&self) -> [f64; 2];

    /// The ray through `point` = [u, z] of the image (mm) and `aperture` in the unit disc.
    fn ray(&self, point: [f64; 2], aperture: [f64; 2]) -> Ray;

    /// Whether all rays of a frame are parallel.
    fn is_collimated(&self) -> bool {
        false
    }

    /// Whether the rays of one image point differ.
    fn has_aperture(&self) -> bool {
        false
    }
}

/// Builds a projector from its section.
pub type BuildProjector = fn(&Section) -> Result<Box<dyn Projector>>;

/// Every projector.
pub static PROJECTORS: &[Kind<BuildProjector>] = &[
    collimated::KIND,
    telecentric::KIND,
    lens::KIND,
    diverging::KIND,
];

/// Refuses pixels without a size.
fn pixel_pitch(section: &Section, Pitch(mm): Pitch) -> Result<[f64; 2]> {
    for (i, pitch) in mm.into_iter().enumerate() {
        let key = if mm[0] == mm[1] {
            "pixel_pitch_mm".to_owned()
        } else {
            format!("pixel_pitch_mm[{i}]")
        };
        positive(section, &key, pitch)?;
    }
    Ok(mm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::example;

    #[test]
    fn every_example_builds_and_images_its_points() {
        for kind in PROJECTORS {
            let projector = (kind.build)(&example(kind)).unwrap();
            let aim = [0.7, -0.4];
            let principal = projector.ray(aim, [0.0, 0.0]);
            assert!(principal.direction[0] < 0.0, "light comes from +x");
            // Rays of one image point meet in the image, wherever they pass the aperture
            let other = projector.ray(aim, [0.3, 0.6]);
            assert_eq!(
                projector.has_aperture(),
                principal != other,
                "{}",
                kind.name
            );
            let image = meeting(&principal, &other).unwrap_or(0.0);
            for ray in [principal, other] {
                let point = ray.at((image - ray.from[0]) / ray.direction[0]);
                assert!((point[1] - aim[0]).abs() < 1e-12, "{}", kind.name);
                assert!((point[2] - aim[1]).abs() < 1e-12, "{}", kind.name);
            }
        }
    }

    /// The x at which two rays have the same y.
    fn meeting(a: &Ray, b: &Ray) -> Option<f64> {
        let line = |ray: &Ray| {
            let slope = ray.direction[1] / ray.direction[0];
            (ray.from[1] - slope * ray.from[0], slope)
        };
        let ((y0, s0), (y1, s1)) = (line(a), line(b));
        (s0 != s1).then(|| (y1 - y0) / (s0 - s1))
    }
}
