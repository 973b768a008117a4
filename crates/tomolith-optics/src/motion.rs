//! How the vial moves before the projector: from a ray of the projector to a ray of the vial.
//!
//! # Model
//! The vial turns about the rotation axis z. Seen from it, the light of a frame comes from the azimuth α of that frame.
//! - `tilt`: the axis leans away from the perpendicular of the light. Light of tilt τ > 0 comes from above and
//!   travels along −(cos τ cos α, cos τ sin α, sin τ). The pixels' columns keep their direction; their rows lean along.
//! - `offset`: where the axis of the vial stands, seen from the rotation axis, in the frame that turns.
//! - `axis_runout`: a rotation axis that runs out: at azimuth α it stands `amplitude`·cos(α − `phase`) aside along the columns.
//!
//! # Equation
//! A point p of the projector's frame becomes R_z(α)·(R_y(τ)·p − (0, amplitude·cos(α − phase), 0)) − offset.
//!
//! # Source
//! Nicolet et al. 2024, § 5 (an axis tilted by 6.8°).
//!
//! # Example
//! ```
//! use tomolith_optics::motion::Motion;
//! use tomolith_optics::projector::Ray;
//! let motion = Motion { tilt_rad: 0.1, ..Motion::default() };
//! let ray = Ray { from: [0.0, 2.0, 0.0], direction: [-1.0, 0.0, 0.0] };
//! let seen = motion.seen_from_vial(ray, 0.0);
//! assert_eq!(seen.from, [0.0, 2.0, 0.0]); // a point on the hinge stays
//! assert!((seen.direction[2] + 0.1f64.sin()).abs() < 1e-15); // light from above travels down
//! ```

use super::projector::Ray;

/// See the [module page](self).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Angle between the light and the plane normal to the axis, rad, > 0: light from above.
    pub tilt_rad: f64,
    /// Axis of the vial, seen from the rotation axis, mm.
    pub offset_mm: [f64; 2],
    /// Largest run-out of the rotation axis, mm.
    pub axis_runout_mm: f64,
    /// Azimuth at which it runs out farthest along the columns, rad.
    pub axis_runout_rad: f64,
}

impl Motion {
    /// Whether a round vial looks the same from every azimuth.
    #[must_use]
    pub fn is_symmetric(&self) -> bool {
        self.offset_mm == [0.0; 2] && self.axis_runout_mm == 0.0
    }

    /// A ray of the projector, as the vial sees it in a frame from this azimuth (rad).
    #[must_use]
    pub fn seen_from_vial(&self, ray: Ray, azimuth: f64) -> Ray {
        let leaning = |[x, y, z]: [f64; 3]| {
            let (sin, cos) = self.tilt_rad.sin_cos();
            [cos * x - sin * z, y, sin * x + cos * z]
        };
        let turned = |v| turned(v, azimuth);
        let aside = self.axis_runout_mm * (azimuth - self.axis_runout_rad).cos();
        let [x, y, z] = leaning(ray.from);
        let [x, y, z] = turned([x, y - aside, z]);
        Ray {
            from: [x - self.offset_mm[0], y - self.offset_mm[1], z],
            direction: turned(leaning(ray.direction)),
        }
    }
}

/// A vector turned about z, counter-clockwise seen from above.
#[must_use]
pub fn turned([x, y, z]: [f64; 3], angle: f64) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y, z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    const RAY: Ray = Ray::new([3.0, 1.0, 0.5], [-1.0, 0.0, 0.0]);

    fn near(a: [f64; 3], b: [f64; 3]) -> bool {
        a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-14)
    }

    #[test]
    fn columns_grow_along_minus_sin_cos_and_light_travels_against_the_azimuth() {
        let seen = Motion::default().seen_from_vial(RAY, FRAC_PI_2);
        assert!(near(seen.direction, [0.0, -1.0, 0.0]));
        assert!(near(seen.from, [-1.0, 3.0, 0.5]));
    }

    #[test]
    fn an_offset_vial_sees_the_ray_where_it_stood_less_the_offset_at_any_azimuth() {
        let motion = Motion {
            offset_mm: [0.2, -0.3],
            ..Motion::default()
        };
        for azimuth in [0.0, 1.1, 4.0] {
            let (plain, seen) = (
                Motion::default().seen_from_vial(RAY, azimuth),
                motion.seen_from_vial(RAY, azimuth),
            );
            assert!(near(
                seen.from,
                [plain.from[0] - 0.2, plain.from[1] + 0.3, plain.from[2]]
            ));
            assert_eq!(seen.direction, plain.direction);
        }
    }

    #[test]
    fn a_runout_shifts_along_the_columns_most_at_its_phase() {
        let motion = Motion {
            axis_runout_mm: 0.1,
            axis_runout_rad: 0.7,
            ..Motion::default()
        };
        let lateral = |azimuth: f64| turned(motion.seen_from_vial(RAY, azimuth).from, -azimuth)[1];
        assert!((lateral(0.7) - 0.9).abs() < 1e-14);
        assert!((lateral(0.7 + FRAC_PI_2) - 1.0).abs() < 1e-14);
    }
}
