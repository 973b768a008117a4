//! Penalties on patterns beside a sealed field.

use super::field::SealedField;
use std::sync::Arc;
use tomolith_core::field::costs::{FramePairs, PixelPairs, difference, power};
use tomolith_core::field::{BLOCK, CostKernel, Field as _, PatternCost};

/// The penalty.
pub(crate) struct SealedCosts(Arc<PatternCost>);

impl SealedCosts {
    /// R at x(i) and Σ ∂R/∂xᵢ·stepᵢ.
    fn pass(
        &self,
        len: usize,
        x: impl Fn(usize) -> f32,
        step: impl Fn(usize) -> f32,
    ) -> (f64, f64) {
        let sum =
            |terms: &[(f64, f64)]| terms.iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        match &*self.0 {
            PatternCost::Power { exponent } => {
                let term = |i: usize| {
                    let (term, slope) = power(*exponent, x(i));
                    (term, slope * f64::from(step(i)))
                };
                let block = |begin: usize| {
                    let terms: Vec<_> = (begin..len.min(begin + BLOCK)).map(term).collect();
                    sum(&terms)
                };
                sum(&(0..len).step_by(BLOCK).map(block).collect::<Vec<_>>())
            }
            PatternCost::Differences { frames, edge } => {
                let frame = |frame: &FramePairs| {
                    let mut terms = Vec::new();
                    for p in frame.inside.iter().chain(&frame.onward) {
                        for (i, j) in (0..p.count).map(|i| (p.first + i, p.second + i)) {
                            let apart = f64::from(x(i)) - f64::from(x(j));
                            let (term, slope) = difference(*edge, apart);
                            let along = f64::from(step(i)) - f64::from(step(j));
                            terms.push((p.weight * term, p.weight * slope * along));
                        }
                    }
                    sum(&terms)
                };
                sum(&frames.iter().map(frame).collect::<Vec<_>>())
            }
        }
    }
}

impl CostKernel<SealedField> for SealedCosts {
    fn new(cost: &Arc<PatternCost>, _: &SealedField) -> Self {
        SealedCosts(cost.clone())
    }

    fn value(&self, x: &SealedField) -> f64 {
        self.pass(x.len(), |i| x.at(i), |_| 0.0).0
    }

    fn add_gradient(&self, x: &SealedField, scale: f64, gradient: &mut SealedField) -> f64 {
        match &*self.0 {
            PatternCost::Power { exponent } => {
                for i in 0..x.len() {
                    let slope = power(*exponent, x.at(i)).1;
                    gradient.set(i, gradient.at(i) + (scale * slope) as f32);
                }
            }
            PatternCost::Differences { frames, edge } => {
                let mut add = |p: &PixelPairs, ends: [bool; 2]| {
                    for (i, j) in (0..p.count).map(|i| (p.first + i, p.second + i)) {
                        let apart = f64::from(x.at(i)) - f64::from(x.at(j));
                        let push = (scale * p.weight * difference(*edge, apart).1) as f32;
                        if ends[0] {
                            gradient.set(i, gradient.at(i) + push);
                        }
                        if ends[1] {
                            gradient.set(j, gradient.at(j) - push);
                        }
                    }
                };
                for frame in frames {
                    frame.inside.iter().for_each(|p| add(p, [true, true]));
                    frame.onward.iter().for_each(|p| add(p, [true, false]));
                    let before = frame.previous.map_or(&[][..], |p| &frames[p].onward);
                    before.iter().for_each(|p| add(p, [false, true]));
                }
            }
        }
        self.value(x)
    }

    fn slope_along(&self, x: &SealedField, step: &SealedField, alpha: f32) -> (f64, f64) {
        self.pass(x.len(), |i| x.at(i) + alpha * step.at(i), |i| step.at(i))
    }
}
