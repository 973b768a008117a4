//! What patterns cost by themselves: data, and the passes over patterns that a penalty is computed with.
//!
//! **Equation** R = Σ_i |x_i|^M ([`PatternCost::Power`]), or over pairs of pixels with a weight and Δ their difference
//! ([`PatternCost::Differences`])
//!
//! ```text
//! R = Σ_pairs w·φ(Δ),   φ = ½·Δ²                          (no `edge`)
//!                       φ = δ·(√(δ² + Δ²) − δ)             (`edge` = δ: total variation, rounded below δ)
//! ```
//!
//! A [`CostKernel`] is what a backend makes of the data, and its passes; [`HostCosts`] is that of host memory. Sources and
//! parameters are in the crate of objectives.
//!
//! **Limits** patterns are not negative, so the slope of |x|^M at 0 is that toward lit pixels; for M < 1 it would be infinite, and
//! below [`CHORD`] |x|^M is replaced by its chord. **Order of sums** of the host: terms in f64, one after the other within a block of
//! [`BLOCK`] elements (of a frame for differences), then the blocks (frames).

use super::bands::CHORD;
use super::{BLOCK, Field as _, HostField};
use crate::parallel::InParallel;
use std::sync::Arc;

/// A penalty on patterns as plain data; see the [module](self).
#[derive(Clone, Debug)]
pub enum PatternCost {
    /// Σ |x|^M
    Power {
        /// M, above 0.
        exponent: f64,
    },
    /// Σ w·φ(xᵢ − xⱼ)
    Differences {
        /// Every frame, in the order of the field; together they are all of it.
        frames: Vec<FramePairs>,
        /// δ, above 0; None for squares.
        edge: Option<f64>,
    },
}

/// Pairs of elements (first + i, second + i) for i below `count`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelPairs {
    /// First element of the first pair.
    pub first: usize,
    /// Second element of the first pair.
    pub second: usize,
    /// How many pairs.
    pub count: usize,
    /// w
    pub weight: f64,
}

/// The elements of a frame, and the pairs that begin in it.
#[derive(Clone, Debug)]
pub struct FramePairs {
    /// How many elements.
    pub len: usize,
    /// Both ends in this frame.
    pub inside: Vec<PixelPairs>,
    /// The second end in the next frame.
    pub onward: Vec<PixelPairs>,
    /// The frame whose next one this is.
    pub previous: Option<usize>,
}

impl PatternCost {
    /// Whether R is convex.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        match self {
            PatternCost::Power { exponent } => *exponent >= 1.0,
            PatternCost::Differences { .. } => true,
        }
    }
}

/// |x|^M and its derivative.
#[inline]
#[must_use]
pub fn power(m: f64, x: f32) -> (f64, f64) {
    let size = f64::from(x.abs());
    let sign = if x < 0.0 { -1.0 } else { 1.0 };
    if m == 2.0 {
        return (size * size, 2.0 * f64::from(x));
    }
    let chord = f64::from(CHORD);
    if m < 1.0 && size < chord {
        let slope = chord.powf(m - 1.0);
        return (slope * size, sign * slope);
    }
    let rise = size.powf(m - 1.0);
    (rise * size, sign * m * rise)
}

/// φ and dφ/dΔ
#[inline]
#[must_use]
pub fn difference(edge: Option<f64>, difference: f64) -> (f64, f64) {
    match edge {
        None => (0.5 * difference * difference, difference),
        Some(edge) => {
            let share = difference / edge;
            let root = share.mul_add(share, 1.0).sqrt();
            // δ²(√(1 + s²) − 1) without cancellation
            (difference * difference / (1.0 + root), difference / root)
        }
    }
}

/// The passes of a penalty over patterns, where the fields F live.
pub trait CostKernel<F>: Send + Sync {
    /// Brings the data to where `like` lives.
    fn new(cost: &Arc<PatternCost>, like: &F) -> Self;
    /// R(x)
    fn value(&self, x: &F) -> f64;
    /// gradient ← gradient + scale·∂R/∂x; R(x).
    fn add_gradient(&self, x: &F, scale: f64, gradient: &mut F) -> f64;
    /// R of x + α·step and its derivative by α.
    fn slope_along(&self, x: &F, step: &F, alpha: f32) -> (f64, f64);
}

/// [`CostKernel`] in host memory: the data as they are.
#[derive(Clone, Debug)]
pub struct HostCosts(Arc<PatternCost>);

impl CostKernel<HostField> for HostCosts {
    fn new(cost: &Arc<PatternCost>, _: &HostField) -> Self {
        HostCosts(cost.clone())
    }

    fn value(&self, x: &HostField) -> f64 {
        let values = x.as_slice();
        x.total(match &*self.0 {
            PatternCost::Power { exponent } => {
                let term = |b: &[f32]| b.iter().map(|&x| power(*exponent, x).0).sum();
                let sums: Vec<f64> = values.chunks(BLOCK).par_map(term);
                sums.iter().sum()
            }
            PatternCost::Differences { frames, edge } => {
                let apart = |i: usize, j: usize| f64::from(values[i]) - f64::from(values[j]);
                sum_pairs(frames, |i, j, w| {
                    (w * difference(*edge, apart(i, j)).0, 0.0)
                })
                .0
            }
        })
    }

    fn add_gradient(&self, x: &HostField, scale: f64, gradient: &mut HostField) -> f64 {
        match &*self.0 {
            PatternCost::Power { exponent } => x.total(add_power(*exponent, x, scale, gradient)),
            PatternCost::Differences { frames, edge } => {
                add_differences(frames, *edge, x.as_slice(), scale, gradient.as_mut_slice());
                self.value(x)
            }
        }
    }

    fn slope_along(&self, x: &HostField, step: &HostField, alpha: f32) -> (f64, f64) {
        let share = x;
        let (x, step) = (x.as_slice(), step.as_slice());
        let (sum, along) = match &*self.0 {
            PatternCost::Power { exponent } => {
                let blocks = x.chunks(BLOCK).zip(step.chunks(BLOCK));
                let sums: Vec<(f64, f64)> = blocks.par_map(|(x, step)| {
                    x.iter()
                        .zip(step)
                        .fold((0.0, 0.0), |(sum, along), (&x, &p)| {
                            let (term, slope) = power(*exponent, x + alpha * p);
                            (sum + term, along + slope * f64::from(p))
                        })
                });
                sums.iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1))
            }
            PatternCost::Differences { frames, edge } => {
                let at = |i: usize| f64::from(x[i] + alpha * step[i]);
                sum_pairs(frames, |i, j, w| {
                    let (term, slope) = difference(*edge, at(i) - at(j));
                    (
                        w * term,
                        w * slope * (f64::from(step[i]) - f64::from(step[j])),
                    )
                })
            }
        };
        let mut all = [sum, along];
        share.add_up(&mut all);
        (all[0], all[1])
    }
}

#[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
fn add_power(exponent: f64, x: &HostField, scale: f64, gradient: &mut HostField) -> f64 {
    let blocks = x
        .as_slice()
        .chunks(BLOCK)
        .zip(gradient.as_mut_slice().chunks_mut(BLOCK));
    let sums: Vec<f64> = blocks.par_map(|(x, gradient)| {
        let mut sum = 0.0;
        for (&x, g) in x.iter().zip(gradient) {
            let (term, slope) = power(exponent, x);
            sum += term;
            *g += (scale * slope) as f32;
        }
        sum
    });
    sums.iter().sum()
}

/// Sums `each(first, second, weight)` over all pairs, frame by frame.
fn sum_pairs(
    frames: &[FramePairs],
    each: impl Fn(usize, usize, f64) -> (f64, f64) + Sync,
) -> (f64, f64) {
    let sums: Vec<(f64, f64)> = frames.iter().par_map(|frame| {
        let mut sum = (0.0, 0.0);
        for p in frame.inside.iter().chain(&frame.onward) {
            for i in 0..p.count {
                let term = each(p.first + i, p.second + i, p.weight);
                sum = (sum.0 + term.0, sum.1 + term.1);
            }
        }
        sum
    });
    sums.iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1))
}

#[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
fn add_differences(
    frames: &[FramePairs],
    edge: Option<f64>,
    values: &[f32],
    scale: f64,
    gradient: &mut [f32],
) {
    let push = |p: &PixelPairs, i: usize| {
        let apart = f64::from(values[p.first + i]) - f64::from(values[p.second + i]);
        (scale * p.weight * difference(edge, apart).1) as f32
    };
    let (mut rest, mut begin) = (gradient, 0);
    let mut pieces = Vec::with_capacity(frames.len());
    for frame in frames {
        let piece = rest.split_off_mut(..frame.len).unwrap_or_default();
        pieces.push((begin, piece, frame));
        begin += frame.len;
    }
    // Each frame gathers what its own pairs and those of the one before push on it
    pieces.iter_mut().par_each(|(begin, gradient, frame)| {
        for p in &frame.inside {
            for i in 0..p.count {
                let push = push(p, i);
                gradient[p.first + i - *begin] += push;
                gradient[p.second + i - *begin] -= push;
            }
        }
        for p in &frame.onward {
            (0..p.count).for_each(|i| gradient[p.first + i - *begin] += push(p, i));
        }
        let before = frame.previous.map_or(&[][..], |p| &frames[p].onward);
        for p in before {
            (0..p.count).for_each(|i| gradient[p.second + i - *begin] -= push(p, i));
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn below_one_the_chord_keeps_value_and_slope_a_pair() {
        let c = f64::from(CHORD);
        assert_eq!(power(0.5, 0.0), (0.0, c.powf(-0.5)));
        assert!((power(0.5, CHORD).0 - c.sqrt()).abs() < 1e-12);
        let (term, slope) = power(0.5, CHORD / 2.0);
        assert!((term - slope * c / 2.0).abs() < 1e-12);
        assert_eq!(power(0.5, 0.25), (0.5, 1.0));
        assert!(!PatternCost::Power { exponent: 0.5 }.is_convex());
    }

    #[test]
    fn steps_cost_their_height_once_they_are_edges() {
        let (term, slope) = difference(Some(1e-3), 2.0);
        assert!((term / 1e-3 - (2.0 - 1e-3)).abs() < 1e-6 && (slope / 1e-3 - 1.0).abs() < 1e-6);
        let (term, _) = difference(Some(1e-3), 1e-5);
        assert!((term / 0.5e-10 - 1.0).abs() < 1e-4);
    }
}
