//! Resin whose refractive index changes with the distance from the axis: light runs along curves.
//!
//! # Model
//! ```text
//! n²(ρ) = n₀²·(1 + q·ρ² + p·ρ⁴)        ρ² = x² + y²
//! ```
//! n₀ is `resin.refractive_index`, the index on the axis. Warm or half-converted resin has such profiles; so have lenses.
//!
//! # Equation
//! With ds = n·dτ the ray equation is Newton's: d²r/dτ² = ½∇n²(r), dr/dτ = n·d (Born & Wolf, *Principles of Optics*, § 3.2). Steps
//! are those of Störmer and Verlet, symplectic and of second order: half a kick, a straight chord, half a kick. |dr/dτ| then stays near
//! n without drift; the direction is its unit vector. Light is absorbed along the chords.
//!
//! # Parameters
//! | key | unit | range | default | meaning |
//! |---|---|---|---|---|
//! | `quadratic_per_mm2` | 1/mm² | n from 1 to 4 in the resin | 0 | q |
//! | `quartic_per_mm4` | 1/mm⁴ | n from 1 to 4 in the resin | 0 | p |
//! | `step_mm` | mm | 1e-3 to 10 | a curve is at most 1e-3 mm from its chord; a quarter of the resin's radius | length of a chord |
//!
//! # Limits
//! The error of a path falls with the square of `step_mm` (tests of `optics/space`: Luneburg's lens). Where a wall is met the last chord is cut.
//!
//! # Example
//! In Luneburg's lens, n² = 2 − ρ²/R², light that enters parallel to x at height b leaves at (R, 0): it has gone down by b.
//! ```
//! use tomolith_optics::gradient::IndexGradient;
//! use tomolith_optics::projector::Ray;
//! let radius: f64 = 4.0;
//! let lens = IndexGradient { quadratic_per_mm2: -0.5 / radius.powi(2), quartic_per_mm4: 0.0, step_mm: 0.01 };
//! let axis = 2.0f64.sqrt();
//! assert!((lens.index(axis, [radius, 0.0, 0.0]) - 1.0).abs() < 1e-12);
//! let b = 1.0;
//! let mut ray = Ray { from: [-(radius * radius - b * b).sqrt(), b, 0.0], direction: [1.0, 0.0, 0.0] };
//! while ray.from[0] < radius - 0.005 {
//!     ray = lens.chord(axis, ray, lens.step_mm).end;
//! }
//! assert!(ray.from[1].abs() < 0.005); // within half a chord of the focus
//! ```

use super::projector::Ray;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::vector::{dot, unit};

/// Keys of `[resin.gradient]`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// q in n² = n₀²·(1 + q·ρ² + p·ρ⁴), 1/mm².
    pub quadratic_per_mm2: f64,
    /// p, 1/mm⁴.
    pub quartic_per_mm4: f64,
    /// Length of the chords that replace curved rays, mm, 0.001 to 10.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_mm: Option<f64>,
}

impl Params {
    /// The profile in resin of this radius (mm).
    #[must_use]
    pub fn within(&self, radius: f64) -> IndexGradient {
        let mut gradient = IndexGradient {
            quadratic_per_mm2: self.quadratic_per_mm2,
            quartic_per_mm4: self.quartic_per_mm4,
            step_mm: radius / 4.0,
        };
        let of_radius = |i: u32| gradient.curvature(radius * f64::from(i) / 64.0);
        let sharpest = (0..=64).map(of_radius).fold(0.0, f64::max);
        // A chord s of a circle of curvature κ is s²κ/8 from it
        let longest = (8.0 * BESIDE_MM / sharpest).sqrt();
        gradient.step_mm = self
            .step_mm
            .unwrap_or(gradient.step_mm.min(longest).max(1e-3));
        gradient
    }
}

/// How far a curve may be from its chords, mm.
const BESIDE_MM: f64 = 1e-3;

/// See the [module page](self).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IndexGradient {
    /// q in n² = n₀²·(1 + q·ρ² + p·ρ⁴), 1/mm².
    pub quadratic_per_mm2: f64,
    /// p, 1/mm⁴.
    pub quartic_per_mm4: f64,
    /// Length of a chord, mm.
    pub step_mm: f64,
}

/// A straight piece in place of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    /// Its beginning and direction.
    pub ray: Ray,
    /// Its length, mm.
    pub length: f64,
    /// Where it ends, and where light is bound for there.
    pub end: Ray,
}

impl IndexGradient {
    /// n²/n₀² at a distance from the axis (mm).
    #[must_use]
    pub fn relative_square(&self, rho: f64) -> f64 {
        let square = rho * rho;
        1.0 + square * (self.quadratic_per_mm2 + square * self.quartic_per_mm4)
    }

    /// The sharpest bend of light at a distance from the axis, |∇n|/n, 1/mm.
    fn curvature(&self, rho: f64) -> f64 {
        let pull = rho * (self.quadratic_per_mm2 + 2.0 * rho * rho * self.quartic_per_mm4);
        pull.abs() / self.relative_square(rho)
    }

    /// The refractive index at a point (mm); `axis` is the one on the axis.
    #[must_use]
    pub fn index(&self, axis: f64, [x, y, _]: [f64; 3]) -> f64 {
        axis * self.relative_square(x.hypot(y)).max(0.0).sqrt()
    }

    /// ½∇n², 1/mm.
    fn pull(&self, axis: f64, [x, y, _]: [f64; 3]) -> [f64; 3] {
        let square = x * x + y * y;
        let along = axis * axis * (self.quadratic_per_mm2 + 2.0 * square * self.quartic_per_mm4);
        [along * x, along * y, 0.0]
    }

    /// A chord of about `length` mm from where a ray begins; `axis` is the index on the axis.
    #[must_use]
    pub fn chord(&self, axis: f64, ray: Ray, length: f64) -> Chord {
        let index = self.index(axis, ray.from);
        let step = length / index;
        let kicked = |momentum: [f64; 3], at: [f64; 3]| {
            let pull = self.pull(axis, at);
            std::array::from_fn(|i| momentum[i] + 0.5 * step * pull[i])
        };
        let half: [f64; 3] = kicked(ray.direction.map(|d| index * d), ray.from);
        let chord = Ray::new(ray.from, unit(half));
        let length = step * dot(half, half).sqrt();
        let to = chord.at(length);
        let end = Ray::new(to, unit(kicked(half, to)));
        Chord {
            ray: chord,
            length,
            end,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chords_are_as_long_as_the_curve_allows() {
        let step_of = |quadratic_per_mm2: f64, step_mm| {
            let params = Params {
                quadratic_per_mm2,
                step_mm,
                ..Params::default()
            };
            params.within(8.0).step_mm
        };
        // At the wall ρ = 8: κ = 8·1e-3/(1 − 0.064), s = √(8e-3/κ)
        let kappa = 8e-3 / (1.0 - 0.064);
        assert!((step_of(-1e-3, None) - (8e-3f64 / kappa).sqrt()).abs() < 1e-12);
        assert_eq!((step_of(0.0, None), step_of(-1e-3, Some(0.3))), (2.0, 0.3));
    }
}
