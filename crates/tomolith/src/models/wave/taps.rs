//! Interpolation of band-limited samples with few taps.
//!
//! # Equation
//! A signal whose spectrum is a triangle up to B cycles a sample, plus a constant, has the correlation k(τ) = sinc²(Bτ) + c. Between two
//! samples, at t of the way, the weights of the W nearest ones with the smallest mean square error solve
//! ```text
//! Σⱼ k(xᵢ − xⱼ)·wⱼ = k(t − xᵢ),        error² = k(0) − Σᵢ wᵢ·k(t − xᵢ)
//! ```
//! |ψ|² is such a signal: the square of a field whose spectrum is flat up to B/2 has a triangle up to B.
//!
//! # Source
//! Wiener's interpolation of a stationary process (any text on optimal linear estimation); the triangle is the autocorrelation of a box.

use std::f64::consts::PI;

/// Rows of the table: linear between them, the weights are right to (π·B/512)²/8 < 5·10⁻⁶.
const ROWS: usize = 512;

/// Size of the constant part of a signal relative to its variance: the weights then sum to 1 to 10⁻⁷.
const CONSTANT: f64 = 1e6;

/// Interpolation from `taps` samples.
#[derive(Clone, Debug)]
pub(super) struct Taps {
    /// Number of samples, even.
    pub(super) taps: usize,
    /// `ROWS + 1` rows of weights.
    table: Vec<f32>,
    /// Root mean square error of a signal of that band, relative to its standard deviation.
    pub(super) error: f64,
}

fn correlation(band: f64, distance: f64) -> f64 {
    let x = PI * band * distance;
    let sinc = if x.abs() < 1e-9 { 1.0 } else { x.sin() / x };
    sinc * sinc
}

impl Taps {
    /// The best weights for signals up to `band` cycles a sample, below 1/2.
    #[expect(clippy::cast_possible_truncation, reason = "a table of f32")]
    pub(super) fn new(taps: usize, band: f64) -> Self {
        let places: Vec<f64> = (0..taps)
            .map(|i| i as f64 - (taps / 2 - 1) as f64)
            .collect();
        let with_constant = |distance: f64| correlation(band, distance) + CONSTANT;
        let mut matrix: Vec<Vec<f64>> = (places.iter())
            .map(|a| places.iter().map(|b| with_constant(a - b)).collect())
            .collect();
        for (i, row) in matrix.iter_mut().enumerate() {
            // Rounding of f32 samples
            row[i] += 1e-10;
        }
        let mut table = Vec::with_capacity((ROWS + 1) * taps);
        let mut square = 0.0;
        for row in 0..=ROWS {
            let t = row as f64 / ROWS as f64;
            let right = places.iter().map(|x| with_constant(t - x)).collect();
            let weights = solve(matrix.clone(), right);
            square += squared_error(band, &places, &weights, t) / (ROWS + 1) as f64;
            table.extend(weights.iter().map(|&w| w as f32));
        }
        Taps {
            taps,
            table,
            error: square.max(0.0).sqrt(),
        }
    }

    /// The widest band (cycles a sample) that so many taps interpolate with this error.
    pub(super) fn widest_band(taps: usize, error: f64) -> f64 {
        let (mut low, mut high) = (0.0, 0.5);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            if Taps::new(taps, middle).error <= error {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    /// The first of the samples around a place (in samples), and their weights, written over `weights`.
    pub(super) fn at(&self, place: f64, weights: &mut Vec<f64>) -> i64 {
        let below = place.floor();
        let row = (place - below) * ROWS as f64;
        let index = (row as usize).min(ROWS - 1);
        let share = row - index as f64;
        let [low, high] = [index, index + 1].map(|i| &self.table[i * self.taps..][..self.taps]);
        weights.clear();
        weights.extend(
            (low.iter().zip(high))
                .map(|(&a, &b)| f64::from(a) + share * (f64::from(b) - f64::from(a))),
        );
        below as i64 - (self.taps as i64 / 2 - 1)
    }
}

/// Mean square error of weights at t, for a triangle alone.
fn squared_error(band: f64, places: &[f64], weights: &[f64], t: f64) -> f64 {
    let mut error = 1.0;
    for (x, w) in places.iter().zip(weights) {
        error -= 2.0 * w * correlation(band, t - x);
        for (y, v) in places.iter().zip(weights) {
            error += w * v * correlation(band, x - y);
        }
    }
    error
}

/// Gauss with pivots, for a handful of unknowns.
fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    let n = right.len();
    for i in 0..n {
        let largest = |&a: &usize, &b: &usize| matrix[a][i].abs().total_cmp(&matrix[b][i].abs());
        let pivot = (i..n).max_by(largest).unwrap_or(i);
        matrix.swap(i, pivot);
        right.swap(i, pivot);
        for j in i + 1..n {
            let factor = matrix[j][i] / matrix[i][i];
            let (above, below) = matrix.split_at_mut(j);
            for (to, from) in below[0][i..].iter_mut().zip(&above[i][i..]) {
                *to -= factor * from;
            }
            right[j] -= factor * right[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| matrix[i][j] * right[j]).sum();
        right[i] = (right[i] - known) / matrix[i][i];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_stays_one_and_a_wave_within_the_band_is_met() {
        for (taps, band) in [(4, 0.2), (6, 0.25), (8, 0.3)] {
            let found = Taps::new(taps, band);
            let mut weights = Vec::new();
            let (mut worst, mut square) = (0.0f64, 0.0);
            for i in 0..1000 {
                let place = 7.0 + f64::from(i) / 999.0 * 0.999;
                let first = found.at(place, &mut weights);
                let sum: f64 = weights.iter().sum();
                worst = worst.max((sum - 1.0).abs());
                // Half way up the band
                let wave = |x: f64| (PI * band * x + 0.3).sin();
                let value: f64 = (weights.iter().enumerate())
                    .map(|(k, w)| w * wave((first + k as i64) as f64))
                    .sum();
                square += (value - wave(place)).powi(2) / 1000.0;
            }
            assert!(worst < 5e-7, "{taps}: {worst}");
            // A sine of this power, 1/2, half way up the band errs no more than noise of power 1 that fills it, most of it lower
            let error = square.sqrt();
            assert!(
                error < 1.5 * found.error,
                "{taps} {band}: {error} {}",
                found.error
            );
        }
    }

    #[test]
    fn more_taps_and_a_narrower_band_err_less() {
        // Samples twice as close as the signal's Nyquist limit, B = 1/2: the same system solved in numpy
        for (taps, expected) in [(2, 0.056), (4, 6.0e-3), (6, 7.9e-4), (8, 1.1e-4)] {
            let error = Taps::new(taps, 0.25).error;
            assert!((error / expected - 1.0).abs() < 0.05, "{taps}: {error}");
        }
        let widest = Taps::widest_band(6, 1e-3);
        assert!(
            (Taps::new(6, widest).error / 1e-3 - 1.0).abs() < 0.1,
            "{widest}"
        );
    }
}
