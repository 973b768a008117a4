//! One interface between two transparent media: Snell's law and Fresnel's transmittances.
//!
//! # Equation
//! With incidence angle θ₁ in index n₁ and θ₂ in n₂ (n₁ sin θ₁ = n₂ sin θ₂):
//!
//! ```text
//! R_s = ((n₁ cos θ₁ − n₂ cos θ₂) / (n₁ cos θ₁ + n₂ cos θ₂))²
//! R_p = ((n₁ cos θ₂ − n₂ cos θ₁) / (n₁ cos θ₂ + n₂ cos θ₁))²        T = 1 − R   (power)
//! ```
//! s: electric field normal to the plane of incidence (along z in a z-invariant geometry); p: in that plane.
//!
//! # Source
//! Born & Wolf, *Principles of Optics*, §1.5.2, eqs. (20)–(21) and (33).
//!
//! # Example
//! ```
//! use tomolith_optics::interface::{Transmittance, refract};
//! let (direction, t) = refract([1.0, 0.0], [-1.0, 0.0], 1.0, 1.5).unwrap();
//! assert_eq!(direction, [1.0, 0.0]); // normal incidence does not bend
//! assert!((t.s - 0.96).abs() < 1e-12 && (t.p - 0.96).abs() < 1e-12); // ((1.5 − 1)/(1.5 + 1))² = 4 % is lost
//! ```

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Power transmittance of each polarization.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transmittance {
    /// Electric field normal to the plane of incidence.
    pub s: f64,
    /// Electric field in the plane of incidence.
    pub p: f64,
}

/// Polarization of a light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Polarization {
    /// Half s, half p. Each half keeps its own transmittance through all walls; they are averaged at the end.
    #[default]
    Unpolarized,
    /// Electric field along the rotation axis; of light that is tilted toward it, along the axis as seen across the ray.
    S,
    /// Electric field across the rotation axis and the ray.
    P,
}

impl Polarization {
    /// Power that starts in s and in p.
    #[must_use]
    pub fn split(self) -> Transmittance {
        let (s, p) = match self {
            Polarization::Unpolarized => (0.5, 0.5),
            Polarization::S => (1.0, 0.0),
            Polarization::P => (0.0, 1.0),
        };
        Transmittance { s, p }
    }
}

/// The refracted direction and the power that passes, for a unit `direction` that meets a wall whose unit `normal`
/// points against it; None at total reflection.
#[must_use]
pub fn refract(
    direction: [f64; 2],
    normal: [f64; 2],
    n1: f64,
    n2: f64,
) -> Option<([f64; 2], Transmittance)> {
    let cos1 = -(direction[0] * normal[0] + direction[1] * normal[1]);
    let ratio = n1 / n2;
    let sin2_squared = ratio * ratio * (1.0 - cos1 * cos1).max(0.0);
    if sin2_squared >= 1.0 {
        return None;
    }
    let cos2 = (1.0 - sin2_squared).sqrt();
    let bend = ratio * cos1 - cos2;
    let refracted = [
        ratio * direction[0] + bend * normal[0],
        ratio * direction[1] + bend * normal[1],
    ];
    let r_s = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2);
    let r_p = (n1 * cos2 - n2 * cos1) / (n1 * cos2 + n2 * cos1);
    let transmittance = Transmittance {
        s: 1.0 - r_s * r_s,
        p: 1.0 - r_p * r_p,
    };
    Some((refracted, transmittance))
}

/// The power that a metal of index n + ik reflects of s and p light that meets it from index `n1` with incidence cosine `cos1`.
///
/// # Source
/// Born & Wolf, *Principles of Optics*, § 14.2: n₂ cos θ₂ = u + iv.
///
/// # Example
/// ```
/// use tomolith_optics::interface::reflected_by_metal;
/// let [s, p] = reflected_by_metal(1.0, 1.0, [2.0, 3.0]); // ((1 − 2)² + 3²)/((1 + 2)² + 3²) = 10/18
/// assert!((s - 10.0 / 18.0).abs() < 1e-12 && (p - s).abs() < 1e-12);
/// ```
#[must_use]
pub fn reflected_by_metal(cos1: f64, n1: f64, [n, k]: [f64; 2]) -> [f64; 2] {
    let (real, imaginary) = (n * n - k * k, 2.0 * n * k);
    let along = real - n1 * n1 * (1.0 - cos1 * cos1).max(0.0);
    let whole = along.hypot(imaginary);
    let [u, v] = [whole + along, whole - along].map(|twice| (twice.max(0.0) / 2.0).sqrt());
    let ratio = |[a, b]: [f64; 2], [c, d]: [f64; 2]| {
        ((a - c).powi(2) + (b - d).powi(2)) / ((a + c).powi(2) + (b + d).powi(2))
    };
    [
        ratio([n1 * cos1, 0.0], [u, v]),
        ratio([real * cos1, imaginary * cos1], [n1 * u, n1 * v]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;

    fn at(angle: f64, n1: f64, n2: f64) -> Option<([f64; 2], Transmittance)> {
        refract([angle.cos(), angle.sin()], [-1.0, 0.0], n1, n2)
    }

    #[test]
    fn brewster_angle_passes_all_p_light() {
        let (n1, n2) = (1.0f64, 1.4849);
        let (_, t) = at((n2 / n1).atan(), n1, n2).unwrap();
        near!(t.p, 1.0, 1e-14, "p light is reflected at Brewster's angle");
        assert!(t.s < 0.88, "s light is not");
    }

    #[test]
    fn a_metal_that_absorbs_nothing_reflects_as_glass_does() {
        for angle in [0.0f64, 0.3, 0.9, 1.5] {
            let [s, p] = reflected_by_metal(angle.cos(), 1.2, [1.6, 0.0]);
            let (_, passed) = at(angle, 1.2, 1.6).unwrap();
            assert!((s + passed.s - 1.0).abs() < 1e-12 && (p + passed.p - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn snell_bends_and_total_reflection_begins_at_the_critical_angle() {
        let (direction, _) = at(0.7, 1.0, 1.58).unwrap();
        assert!((direction[1] - 0.7f64.sin() / 1.58).abs() < 1e-14);
        let critical = (1.0f64 / 1.5).asin();
        assert!(at(critical - 1e-6, 1.5, 1.0).is_some());
        assert!(at(critical + 1e-6, 1.5, 1.0).is_none());
    }
}
