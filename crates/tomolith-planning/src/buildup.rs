//! Dose that builds up at a point of a turning vial, and when it has cured.
//!
//! **Equation** (Wang et al. 2022, supplement, S11), in units in which unattenuated light brings 1 a second
//!
//! ```text
//! E(t) = ∫₀ᵗ exp(−L(θ)/D_p) dt′      θ = v·t′ − φ      L = √(R² − r²·sin²θ) − r·cosθ
//! ```
//!
//! Turn averages have closed forms on the axis and at the wall, κ = R/D_p: e^(−κ) and ½ + ½·[I₀(2κ) − L₀(2κ)] (modified Bessel and Struve
//! functions; Abramowitz and Stegun 9.6.12, 12.2.1, and the asymptotic series that follows from 12.2.3).
//!
//! **Cost** microseconds a point. **Limits** straight light of one direction, one even attenuation.
//!
//! ```
//! use tomolith_planning::buildup::{TurningVial, wall_rate};
//! let vial = TurningVial { radius_mm: 1.0, penetration_mm: 0.1, turn_deg_per_s: 5.0 };
//! assert!((vial.mean_rate(1.0) - wall_rate(10.0)).abs() < 1e-8);
//! // A wall point that begins in the light has its dose after half of the first half turn, and no more for half a turn
//! assert!((vial.dose(1.0, 0.0, 50.0) - vial.dose(1.0, 0.0, 20.0)).abs() < 0.03);
//! ```

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A vial of resin that turns in even light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurningVial {
    /// R, mm.
    pub radius_mm: f64,
    /// D_p, mm.
    pub penetration_mm: f64,
    /// v, degrees per s; 0 for a vial at rest.
    pub turn_deg_per_s: f64,
}

/// Gauss's points and weights on [−1, 1].
const GAUSS: [[f64; 2]; 5] = [
    [0.0, 0.568_888_888_888_888_9],
    [0.538_469_310_105_683_1, 0.478_628_670_499_366_47],
    [-0.538_469_310_105_683_1, 0.478_628_670_499_366_47],
    [0.906_179_845_938_664, 0.236_926_885_056_189_08],
    [-0.906_179_845_938_664, 0.236_926_885_056_189_08],
];
/// Panels of an integral over a quarter turn.
const PANELS: usize = 48;

impl TurningVial {
    /// Share of the light that reaches a point (r in units of R) when it stands at an angle from the side that faces the light, rad.
    #[must_use]
    pub fn rate(&self, r: f64, theta: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        let half_chord = (1.0 - (r * sin).powi(2)).max(0.0).sqrt();
        // On the side of the light both terms may be equal: their difference is (1 − r²)/(half chord + r·cos θ)
        let path = match cos > 0.0 && r > 0.0 {
            true => (1.0 - r * r) / (half_chord + r * cos),
            false => half_chord - r * cos,
        };
        (-path.max(0.0) * self.radius_mm / self.penetration_mm).exp()
    }

    /// ∫ of the rate by the angle, from 0 to `to` (rad, any sign).
    fn swept(&self, r: f64, to: f64) -> f64 {
        // Whole turns, then quarters, at whose ends the path of a wall point has a kink
        let turns = (to / TAU).floor();
        let rest = to - turns * TAU;
        let quarters = (rest / FRAC_PI_2).floor();
        let quarter = |from: f64, to: f64| {
            let h = (to - from) / PANELS as f64;
            let panel = |k: usize| {
                let middle = from + (k as f64 + 0.5) * h;
                let point = |[x, w]: &[f64; 2]| w * self.rate(r, middle + 0.5 * h * x);
                0.5 * h * GAUSS.iter().map(point).sum::<f64>()
            };
            (0..PANELS).map(panel).sum::<f64>()
        };
        let begin = |q: usize| q as f64 * FRAC_PI_2;
        let whole = if turns == 0.0 {
            0.0
        } else {
            turns * TAU * self.mean_rate(r)
        };
        let done: f64 = (0..quarters as usize)
            .map(|q| quarter(begin(q), begin(q + 1)))
            .sum();
        whole + done + quarter(quarters * FRAC_PI_2, rest)
    }

    /// Mean over a turn.
    #[must_use]
    pub fn mean_rate(&self, r: f64) -> f64 {
        // Even in the angle
        self.swept(r, PI) / PI
    }

    /// Mean over a long time of a point that began at an angle φ (rad): that of a turn, or of where it stays in a vial at rest.
    #[must_use]
    pub fn lasting_rate(&self, r: f64, phase: f64) -> f64 {
        if self.turn_deg_per_s == 0.0 {
            self.rate(r, -phase)
        } else {
            self.mean_rate(r)
        }
    }

    /// Dose after a time (s) of a point that began at an angle φ (rad) behind the side that faces the light, in s of unattenuated light.
    #[must_use]
    pub fn dose(&self, r: f64, phase: f64, seconds: f64) -> f64 {
        let speed = self.turn_deg_per_s.to_radians();
        if speed == 0.0 {
            return seconds * self.rate(r, -phase);
        }
        (self.swept(r, speed * seconds - phase) - self.swept(r, -phase)) / speed
    }

    /// The first time at which the dose is reached, s; None in light that never brings it (fainter than 1e-300).
    #[must_use]
    pub fn curing_s(&self, r: f64, phase: f64, dose_s: f64) -> Option<f64> {
        let speed = self.turn_deg_per_s.to_radians();
        if speed == 0.0 {
            let time = dose_s / self.rate(r, -phase);
            return time.is_finite().then_some(time);
        }
        let turn_s = TAU / speed;
        let per_turn = turn_s * self.mean_rate(r);
        let turns = (dose_s / per_turn).floor();
        if !turns.is_finite() {
            return None;
        }
        let rest = dose_s - turns * per_turn;
        let (mut low, mut high) = (0.0, turn_s);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if self.dose(r, phase, middle) < rest {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(turns * turn_s + high)
    }
}

/// The turn average at the wall, in closed form: ½ + ½·[I₀(2κ) − L₀(2κ)].
#[must_use]
pub fn wall_rate(kappa: f64) -> f64 {
    0.5 + 0.5 * bessel_less_struve(2.0 * kappa)
}

/// I₀(x) − L₀(x), x ≥ 0: both power series up to 15, beyond that (2/π)·Σ ((2k−1)!!)²/x^(2k+1).
#[must_use]
pub fn bessel_less_struve(x: f64) -> f64 {
    if x > 15.0 {
        let (mut term, mut sum) = (1.0 / x, 0.0);
        for k in 0..8 {
            sum += term;
            term *= (f64::from(2 * k + 1) / x).powi(2);
        }
        return 2.0 / PI * sum;
    }
    let half = 0.5 * x;
    let (mut bessel, mut struve) = (1.0, 2.0 * x / PI);
    let mut sum = 0.0;
    for k in 0..80 {
        sum += bessel - struve;
        let next = f64::from(k + 1);
        bessel *= (half / next).powi(2);
        struve *= (half / (next + 0.5)).powi(2);
    }
    sum
}
