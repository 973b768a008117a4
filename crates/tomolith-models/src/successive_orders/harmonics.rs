//! Real spherical harmonics, orthonormal on the sphere, and what a phase function is made of.
//!
//! Y_lm for m ≥ 0 goes with cos mφ, for m < 0 with sin |m|φ; no Condon–Shortley sign (Abramowitz & Stegun, ch. 8, without
//! the factor (−1)^m).

use std::f64::consts::{PI, SQRT_2};
use tomolith_core::dose::scattered::DirectionHarmonic;
use tomolith_optics::phase::Phase;

/// Degree and order of a harmonic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Harmonic {
    pub(super) l: usize,
    pub(super) m: isize,
}

impl Harmonic {
    /// Its value in a unit direction.
    pub(super) fn at(self, direction: [f64; 3]) -> f64 {
        self.norm() * self.form(direction)
    }

    /// The harmonic without its norm, which is the same in all directions.
    pub(super) fn form(self, [x, y, z]: [f64; 3]) -> f64 {
        let m = self.m.unsigned_abs();
        // (x + iy)^m
        let (mut re, mut im) = (1.0, 0.0);
        for _ in 0..m {
            (re, im) = (re * x - im * y, re * y + im * x);
        }
        let around = match self.m {
            0 => 1.0,
            m if m > 0 => SQRT_2 * re,
            _ => SQRT_2 * im,
        };
        legendre(self.l, m, z) * around
    }

    /// √((2l+1)/4π · (l−m)!/(l+m)!)
    pub(super) fn norm(self) -> f64 {
        let m = self.m.unsigned_abs();
        let ratio: f64 = (self.l - m + 1..=self.l + m).map(|i| i as f64).product();
        ((2 * self.l + 1) as f64 / (4.0 * PI * ratio)).sqrt()
    }

    /// As data.
    pub(super) fn to_form(self) -> DirectionHarmonic {
        let around = if self.m == 0 { 1.0 } else { SQRT_2 };
        DirectionHarmonic {
            degree: self.l,
            order: self.m,
            scale: (self.norm() * around) as f32,
        }
    }

    /// Sign of Y(−d)/Y(d) with one coordinate of d turned over: x, y, z.
    pub(super) fn parities(self) -> [f64; 3] {
        let sign = |odd: bool| if odd { -1.0 } else { 1.0 };
        let m = self.m.unsigned_abs();
        [
            sign((m % 2 == 1) != (self.m < 0)),
            sign(self.m < 0),
            sign((self.l + m) % 2 == 1),
        ]
    }
}

/// P_l^m(z)/(1 − z²)^(m/2), by upward recursion.
fn legendre(l: usize, m: usize, z: f64) -> f64 {
    let mut below = 0.0;
    let mut value: f64 = (0..m).map(|i| (2 * i + 1) as f64).product();
    for k in m + 1..=l {
        let next = ((2 * k - 1) as f64 * z * value - (k + m - 1) as f64 * below) / (k - m) as f64;
        (below, value) = (value, next);
    }
    value
}

/// Coefficients f_l = ∫ p(cos)·P_l(cos) dcos, l = 0 … `degree`; f_0 = 1.
pub(super) fn coefficients(phase: &dyn Phase, degree: usize) -> Vec<f64> {
    /// Pieces of Simpson's rule: a lobe of g = 0.95 is 0.05 wide.
    const PIECES: usize = 4096;
    let width = 2.0 / PIECES as f64;
    let mut sums = vec![0.0; degree + 1];
    for i in 0..=PIECES {
        let weight = match i {
            0 | PIECES => 1.0,
            i if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let cosine = -1.0 + i as f64 * width;
        let density = weight * width / 3.0 * phase.density(cosine);
        for (l, sum) in sums.iter_mut().enumerate() {
            *sum += density * legendre(l, 0, cosine);
        }
    }
    let whole = sums[0];
    sums.iter().map(|sum| sum / whole).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_optics::phase::henyey_greenstein::HenyeyGreenstein;
    use tomolith_optics::phase::rayleigh::Rayleigh;

    fn all(degree: usize) -> Vec<Harmonic> {
        (0..=degree)
            .flat_map(|l| (-(l as isize)..=l as isize).map(move |m| Harmonic { l, m }))
            .collect()
    }

    #[test]
    fn harmonics_are_orthonormal_and_turn_over_as_their_parities_say() {
        // Midpoints in φ and Gauss points of degree 9 in z: exact up to degree 6 products
        let points = [
            (0.0, 128.0 / 225.0),
            (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
            (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
            (0.906_179_845_938_664, 0.236_926_885_056_189_1),
            (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
        ];
        let all = all(3);
        for (i, a) in all.iter().enumerate() {
            for (j, b) in all.iter().enumerate() {
                let mut sum = 0.0;
                for (z, weight) in points {
                    for k in 0..16 {
                        let phi = 2.0 * PI * (f64::from(k) + 0.5) / 16.0;
                        let across = f64::sqrt(1.0 - z * z);
                        let d = [across * phi.cos(), across * phi.sin(), z];
                        sum += weight * 2.0 * PI / 16.0 * a.at(d) * b.at(d);
                    }
                }
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((sum - expected).abs() < 1e-12, "{a:?} {b:?}: {sum}");
            }
            let d = [0.6, 0.48, 0.64];
            for axis in 0..3 {
                let mut turned = d;
                turned[axis] = -turned[axis];
                assert!((a.at(turned) - a.parities()[axis] * a.at(d)).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn rayleigh_has_a_tenth_of_degree_two_and_henyey_greenstein_powers_of_g() {
        let rayleigh = coefficients(&Rayleigh {}, 4);
        for (found, expected) in rayleigh.iter().zip([1.0, 0.0, 0.1, 0.0, 0.0]) {
            assert!((found - expected).abs() < 1e-12, "{rayleigh:?}");
        }
        let lobe = coefficients(&HenyeyGreenstein { g: 0.8 }, 4);
        for (l, found) in lobe.iter().enumerate() {
            assert!((found - 0.8f64.powi(l as i32)).abs() < 1e-8, "{lobe:?}");
        }
    }
}
