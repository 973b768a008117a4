//! Interpolation of band-limited samples with few taps.
//!
//! # Equation
//! A stationary signal of correlation k(τ) has samples a step apart. The weights of W of them with the smallest mean square error at a
//! place x solve
//! ```text
//! Σⱼ k(xᵢ − xⱼ)·wⱼ = k(x − xᵢ),        error² = k(0) − Σᵢ wᵢ·k(x − xᵢ)
//! ```
//! |ψ|² of a field ψ = 1 + χ, with χ of power spectrum S and Fourier transform γ of S, has the variable part
//! ```text
//! k(τ) = |γ(τ)|² + 2·Re γ(τ)
//! ```
//! (χ is taken as circular noise): light of patterns of random pixels, of which the mean is as strong as the rest.
//!
//! # Source
//! Wiener's interpolation of a stationary process (any text on optimal linear estimation); moments of Gaussian noise for |χ|².

use super::lattice::Lattice;
use std::f64::consts::TAU;
use tomolith_core::dose::waves::PlaceTaps;
use tomolith_core::least_squares::solve;

/// Rows of a table: linear between them, weights are right to (π·B/512)²/8 < 5·10⁻⁶ for B cycles a sample.
const ROWS: usize = 512;

/// Rows that are enough to know an error.
const FEW_ROWS: usize = 16;

/// Size of the constant part of light relative to its variance: the weights then sum to 1 to 10⁻⁷.
const CONSTANT: f64 = 1e6;

/// Lines that a spectrum is gathered into.
const LINES: usize = 256;

/// How far behind the last sample a place may lie, in steps.
pub(super) const OVERHANG: f64 = 0.25;

/// What is interpolated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Light that is linear in its pixels.
    Light,
    Field,
    /// A field's square.
    Square,
}

/// A stationary random signal.
#[derive(Clone, Debug)]
pub(super) struct Signal {
    /// Frequencies and weights of γ.
    lines: Vec<(f64, f64)>,
    /// What errors are relative to.
    power: f64,
    kind: Kind,
}

impl Signal {
    /// Light that is linear in its pixels; `lines`: frequencies and weights of its power.
    pub(super) fn of_light(lines: impl Iterator<Item = (f64, f64)> + Clone) -> Self {
        Signal {
            power: lines.clone().map(|line| line.1).sum(),
            lines: gathered(lines),
            kind: Kind::Light,
        }
    }

    /// A field with these lines, and others of smooth patterns that must be met better: errors are relative to the former alone.
    pub(super) fn of_field(
        lines: impl Iterator<Item = (f64, f64)> + Clone,
        smooth: impl Iterator<Item = (f64, f64)> + Clone,
    ) -> Self {
        Signal {
            power: lines.clone().map(|line| line.1).sum(),
            lines: gathered(lines.chain(smooth)),
            kind: Kind::Field,
        }
    }

    /// The square of a field with a constant part of power 1 and another with these lines.
    pub(super) fn of_square(lines: impl Iterator<Item = (f64, f64)> + Clone) -> Self {
        let all: f64 = lines.clone().map(|line| line.1).sum();
        Signal {
            power: all * all + 2.0 * all,
            lines: gathered(lines),
            kind: Kind::Square,
        }
    }

    /// Relative to the power.
    fn correlation(&self, distance: f64) -> f64 {
        let (mut re, mut im) = (0.0, 0.0);
        for &(frequency, weight) in &self.lines {
            let (sin, cos) = (TAU * frequency * distance).sin_cos();
            re += weight * cos;
            im += weight * sin;
        }
        if self.kind == Kind::Square {
            (re * re + im * im + 2.0 * re) / self.power
        } else {
            re / self.power
        }
    }
}

/// The same lines, of which those near each other are one.
fn gathered(lines: impl Iterator<Item = (f64, f64)> + Clone) -> Vec<(f64, f64)> {
    let low = lines.clone().fold(f64::INFINITY, |a, (f, _)| a.min(f));
    let high = lines.clone().fold(f64::NEG_INFINITY, |a, (f, _)| a.max(f));
    let width = ((high - low) / LINES as f64).max(f64::MIN_POSITIVE);
    let mut bins = vec![(0.0, 0.0); LINES];
    for (frequency, weight) in lines {
        let bin = &mut bins[(((frequency - low) / width) as usize).min(LINES - 1)];
        bin.0 += frequency * weight;
        bin.1 += weight;
    }
    let lit = bins.into_iter().filter(|bin| bin.1 > 0.0);
    lit.map(|(moment, weight)| (moment / weight, weight))
        .collect()
}

/// What lies beyond the first and the last sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ends {
    /// More samples, on both sides.
    More,
    /// Mirror images before the first, none behind the last.
    Mirrored,
    /// None.
    Both,
}

/// Interpolation from a few samples.
#[derive(Clone, Debug)]
pub(super) struct Taps {
    /// Number of samples, even.
    pub(super) taps: usize,
    /// `ROWS + 1` rows of weights for samples around a place; then for those that lie 1, 2 … samples lower, at the end of all samples.
    tables: Vec<Vec<f32>>,
    ends: Ends,
    /// Index of the last sample.
    last: i64,
}

/// Correlations of samples `step` apart, at multiples of a step over `rows`.
struct Table {
    rows: usize,
    values: Vec<f64>,
    /// Size of the signal's constant part.
    constant: f64,
}

impl Table {
    fn new(signal: &Signal, step: f64, taps: usize, rows: usize) -> Self {
        let at = |i: usize| signal.correlation(i as f64 * step / rows as f64);
        Table {
            rows,
            values: (0..=(taps + 1) * rows).map(at).collect(),
            constant: if signal.kind == Kind::Field {
                0.0
            } else {
                CONSTANT
            },
        }
    }

    /// At `steps` + `row`/rows steps.
    fn at(&self, steps: i64, row: usize) -> f64 {
        self.values[(steps * self.rows as i64 + row as i64).unsigned_abs() as usize]
    }

    /// Weights of the samples from `first` on, relative to the one below the place, and their mean square error.
    fn weights(&self, taps: usize, first: i64, row: usize) -> (Vec<f64>, f64) {
        let nodes: Vec<i64> = (first..first + taps as i64).collect();
        let matrix = (nodes.iter())
            .map(|&a| {
                let row = nodes.iter().map(|&b| {
                    // Rounding of f32 samples
                    let noise = if a == b { 1e-10 } else { 0.0 };
                    self.at(a - b, 0) + self.constant + noise
                });
                row.collect()
            })
            .collect();
        let right: Vec<f64> = nodes.iter().map(|&a| self.at(-a, row)).collect();
        let weights = solve(matrix, right.iter().map(|r| r + self.constant).collect());
        let mut error = self.at(0, 0);
        for ((a, w), r) in nodes.iter().zip(&weights).zip(&right) {
            let others = nodes.iter().zip(&weights);
            error -= 2.0 * w * r;
            error += others.map(|(b, v)| w * v * self.at(a - b, 0)).sum::<f64>();
        }
        (weights, error.max(0.0))
    }
}

/// The lowest of the samples that are used, relative to the one below the place; `lower`: by how much more than usual.
fn first_of(taps: usize, lower: usize) -> i64 {
    1 - (taps / 2 + lower) as i64
}

impl Taps {
    /// The best weights for a signal.
    #[expect(clippy::cast_possible_truncation, reason = "a table of f32")]
    pub(super) fn new(taps: usize, signal: &Signal, lattice: &Lattice) -> Self {
        let table = Table::new(signal, lattice.step, taps, ROWS);
        let ends = lattice.ends;
        let lower = if ends == Ends::More { 0 } else { taps / 2 };
        let table_of = |lower: usize| {
            let rows = (0..=ROWS).map(|row| table.weights(taps, first_of(taps, lower), row).0);
            rows.flatten().map(|w| w as f32).collect()
        };
        Taps {
            taps,
            tables: (0..=lower).map(table_of).collect(),
            ends,
            last: lattice.count as i64 - 1,
        }
    }

    /// The weights as data.
    pub(super) fn form(&self) -> PlaceTaps {
        PlaceTaps {
            taps: self.taps,
            tables: self.tables.clone(),
            last: self.last as usize,
            is_turned: self.ends == Ends::Both,
        }
    }

    /// Root mean square error between samples `step` apart, relative to the standard deviation of the signal.
    pub(super) fn error(taps: usize, signal: &Signal, step: f64) -> f64 {
        let table = Table::new(signal, step, taps, FEW_ROWS);
        mean_square(&table, taps, 0).sqrt()
    }

    /// The largest distance of samples with such an error, at most `most`.
    pub(super) fn widest(taps: usize, signal: &Signal, error: f64, most: f64) -> f64 {
        if Taps::error(taps, signal, most) <= error {
            return most;
        }
        let (mut low, mut high) = (0.0, most);
        for _ in 0..16 {
            let middle = 0.5 * (low + high);
            if Taps::error(taps, signal, middle) <= error {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    /// The same error for depths of a disc, which ends [`OVERHANG`] steps behind the last one. At least `taps`/2 samples, `taps` without images.
    pub(super) fn error_in_disc(taps: usize, signal: &Signal, lattice: &Lattice) -> f64 {
        let table = Table::new(signal, lattice.step, taps, FEW_ROWS);
        // From the middle of the disc: the focal plane, or that of all samples
        let last = if lattice.ends == Ends::Both {
            0.5 * (lattice.count as f64 - 1.0)
        } else {
            lattice.count as f64 - 0.5
        };
        let radius = last + OVERHANG;
        // ∫ 2·√(1 − x²) dx
        let below = |x: f64| {
            let x = (x / radius).min(1.0);
            x * (1.0 - x * x).sqrt() + x.asin()
        };
        let all = below(radius);
        let from = |lower: usize| (last + lower as f64 - (taps / 2) as f64).max(0.0);
        let mut square = mean_square(&table, taps, 0) * below(from(1)) / all;
        for lower in 1..=taps / 2 {
            let share = (below(from(lower + 1)) - below(from(lower))) / all;
            square += mean_square(&table, taps, lower) * share;
        }
        square.sqrt()
    }

    /// The first of the samples for a place (in samples), and their weights, written over `weights`.
    pub(super) fn at(&self, place: f64, weights: &mut Vec<f64>) -> i64 {
        if self.ends == Ends::Both && place < 0.5 * self.last as f64 {
            // The same seen from the other end
            let first = self.seen_from_below(self.last as f64 - place, weights);
            weights.reverse();
            return self.last - (first + self.taps as i64 - 1);
        }
        self.seen_from_below(place, weights)
    }

    fn seen_from_below(&self, place: f64, weights: &mut Vec<f64>) -> i64 {
        let below = place.floor();
        let usual = below as i64 + first_of(self.taps, 0);
        let highest = usual + self.taps as i64 - 1;
        let lower = if self.ends == Ends::More {
            0
        } else {
            (highest - self.last).clamp(0, self.taps as i64 / 2)
        };
        let table = &self.tables[lower as usize];
        let row = (place - below) * ROWS as f64;
        let index = (row as usize).min(ROWS - 1);
        let share = row - index as f64;
        let [low, high] = [index, index + 1].map(|i| &table[i * self.taps..][..self.taps]);
        weights.clear();
        weights.extend(
            (low.iter().zip(high))
                .map(|(&a, &b)| f64::from(a) + share * (f64::from(b) - f64::from(a))),
        );
        usual - lower
    }
}

/// Mean square error over the places between two samples; behind the last sample, as far as [`OVERHANG`].
fn mean_square(table: &Table, taps: usize, lower: usize) -> f64 {
    let is_behind = lower == taps / 2;
    let rows = if is_behind {
        (table.rows as f64 * OVERHANG) as usize
    } else {
        table.rows
    };
    let first = first_of(taps, lower);
    let sum: f64 = (0..=rows)
        .map(|row| table.weights(taps, first, row).1)
        .sum();
    sum / (rows + 1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// Light whose power is even up to a frequency, in cycles a step.
    fn even(highest: f64) -> Signal {
        let lines = (0..400).map(move |i| ((f64::from(i) + 0.5) / 400.0 * highest, 1.0));
        Signal::of_light(lines)
    }

    fn lattice(step: f64, count: usize, ends: Ends) -> Lattice {
        Lattice {
            start: 0.0,
            step,
            count,
            ends,
        }
    }

    #[test]
    fn without_images_both_ends_are_alike() {
        let found = Taps::new(6, &even(0.3), &lattice(1.0, 9, Ends::Both));
        let (mut low, mut high) = (Vec::new(), Vec::new());
        for i in 0..100 {
            let place = f64::from(i) / 100.0 * 3.9 - 0.25;
            let first = found.at(place, &mut low);
            let other = found.at(8.0 - place, &mut high);
            high.reverse();
            assert!(
                first >= 0 && first + other + 5 == 8 && low == high,
                "{place}"
            );
        }
    }

    #[test]
    fn a_constant_stays_one_and_a_wave_within_the_band_is_met() {
        for (taps, band) in [(2, 0.05), (4, 0.2), (6, 0.25), (8, 0.3)] {
            for ends in [Ends::More, Ends::Mirrored, Ends::Both] {
                let signal = even(band);
                let found = Taps::new(taps, &signal, &lattice(1.0, 9, ends));
                let mut weights = Vec::new();
                let (mut worst, mut square) = (0.0f64, 0.0);
                for i in 0..1000 {
                    let place = 7.0 + f64::from(i) / 999.0 * 0.999;
                    let first = found.at(place, &mut weights);
                    assert!(ends == Ends::More || first + taps as i64 - 1 <= 8);
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
                // A sine of power 1/2 half way up the band errs no more than noise of power 1 that fills it
                let lower = if ends == Ends::More { 0 } else { taps / 2 - 1 };
                let table = Table::new(&signal, 1.0, taps, FEW_ROWS);
                let expected = mean_square(&table, taps, lower).sqrt();
                assert!(
                    square.sqrt() < 1.5 * expected,
                    "{taps} {band}: {} {expected}",
                    square.sqrt()
                );
            }
        }
    }

    #[test]
    fn more_taps_and_a_shorter_step_err_less() {
        // The same systems solved in numpy: a field of even power up to 1 that fades as cos⁴ over its last quarter, with its constant; 2 and 3
        // samples a period of it
        let fade = |f: f64| {
            (0.5 * PI * ((f - 0.75) / 0.25).clamp(0.0, 1.0))
                .cos()
                .powi(4)
        };
        let lines = (-192..192).map(move |i| {
            let f = (f64::from(i) + 0.5) / 192.0;
            (f, fade(f.abs()) / 384.0)
        });
        let signal = Signal::of_square(lines);
        for (taps, expected) in [
            (2, [0.102, 0.0474]),
            (4, [0.0358, 0.00722]),
            (6, [0.016, 0.00123]),
        ] {
            for (step, expected) in [0.25, 1.0 / 6.0].into_iter().zip(expected) {
                let error = Taps::error(taps, &signal, step);
                assert!((error / expected - 1.0).abs() < 0.15, "{taps}: {error}");
            }
        }
        let widest = Taps::widest(6, &signal, 1e-3, 1.0);
        assert!((Taps::error(6, &signal, widest) / 1e-3 - 1.0).abs() < 0.01);
    }

    #[test]
    fn few_samples_of_a_disc_hold_its_depths() {
        // An even band of ½ cycle over the radius: with every doubling of the taps that few samples give the error falls
        let signal = even(0.5);
        let error_of = |count: usize, taps: usize| {
            let step = 1.0 / (count as f64 - 0.5 + OVERHANG);
            Taps::error_in_disc(taps, &signal, &lattice(step, count, Ends::Mirrored))
        };
        assert!(error_of(3, 2) > 10.0 * error_of(3, 4));
        assert!(error_of(3, 4) > 2.0 * error_of(3, 6));
        assert!(error_of(3, 4) > 2.0 * error_of(4, 4));
        // And what it says is what waves of random phases leave, at the places of the disc
        let (count, taps) = (4, 4);
        let depths = lattice(1.0 / (count as f64 - 0.25), count, Ends::Mirrored);
        let found = Taps::new(taps, &signal, &depths);
        let (mut square, mut weight, mut weights) = (0.0, 0.0, Vec::new());
        for i in 0..200 {
            let x = (f64::from(i) + 0.5) / 200.0;
            let share = (1.0 - x * x).sqrt();
            let first = found.at(x * 3.75 - 0.5, &mut weights);
            for line in 0..50 {
                let f = TAU * 0.5 * (f64::from(line) + 0.5) / 50.0;
                // cos² + sin² of the error: any phase
                let (mut re, mut im) = (-(f * x).cos(), -(f * x).sin());
                for (k, w) in weights.iter().enumerate() {
                    let place = ((first + k as i64) as f64 + 0.5) / 3.75;
                    re += w * (f * place).cos();
                    im += w * (f * place).sin();
                }
                square += share * (re * re + im * im) / 50.0;
            }
            weight += share;
        }
        let (found, expected) = ((square / weight).sqrt(), error_of(count, taps));
        assert!((found / expected - 1.0).abs() < 0.1, "{found} {expected}");
    }
}
