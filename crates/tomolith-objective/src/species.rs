//! One objective for each block of a dose: for several species, or for one part under several scenarios.
//!
//! ```text
//! sum     L = Σ_k L_k(r_k)            species
//! mean    L = 1/n·Σ_k L_k(r_k)        scenarios
//! worst   L = (1/n·Σ_k L_k(r_k)^8)^(1/8)  scenarios: at most the largest L_k, at least n^(−1/8) times it, and smooth
//! ```
//!
//! r_k is block k of the dose field; its objective knows its own block only. All three are convex where every L_k is and none is negative.
//!
//! **Source** the norm in place of a largest value: Li et al., Additive Manufacturing 94 (2024) 104447, section 2.3.1 (there over voxels).
//!
//! **Cost** a copy of each block per call, in addition to the passes of the objectives.

use super::{FoundWindow, Objective};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::{DoseLayout, Facts, Space, ZCoupling};
use tomolith_core::error::Result;
use tomolith_core::field::scratch::Scratch;
use tomolith_core::field::{Field, HostField, Stretch};
use tomolith_core::response::Response;

/// How the losses of blocks become one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Join {
    /// Their sum.
    #[default]
    Sum,
    /// Their mean.
    Mean,
    /// Nearly the largest of them.
    Worst,
}

/// Power of the norm that stands for the largest loss.
const STEEP: i32 = 8;

impl Join {
    /// The joint loss, and its derivative by each of these.
    fn value_and_slopes(self, losses: &[f64]) -> (f64, Vec<f64>) {
        let count = losses.len();
        match self {
            Join::Sum => (losses.iter().sum(), vec![1.0; count]),
            Join::Mean => {
                let share = 1.0 / count as f64;
                (share * losses.iter().sum::<f64>(), vec![share; count])
            }
            Join::Worst => {
                let worst = losses.iter().copied().fold(0.0, f64::max);
                if worst == 0.0 || !worst.is_finite() {
                    return (worst, vec![0.0; count]);
                }
                let relative = |loss: &f64| (loss / worst).max(0.0);
                let share = 1.0 / count as f64;
                let powers: f64 = losses.iter().map(|l| relative(l).powi(STEEP)).sum();
                let norm = (share * powers).powf(1.0 / f64::from(STEEP));
                let slope = |l| share * (relative(l) / norm).powi(STEEP - 1);
                (worst * norm, losses.iter().map(slope).collect())
            }
        }
    }
}

/// Objectives of the blocks of a dose field.
pub struct PerBlock<F = HostField> {
    parts: Vec<Part<F>>,
    join: Join,
    /// Copies of blocks, and slopes.
    scratch: Scratch<F>,
}

struct Part<F> {
    range: Range<usize>,
    /// Of the block alone.
    layout: DoseLayout,
    objective: Box<dyn Objective<F>>,
}

impl<F> Part<F> {
    /// From a field of all blocks to one of this block.
    fn taken(&self) -> Stretch {
        Stretch {
            to: 0,
            from: self.range.start,
            count: self.range.len(),
        }
    }

    /// The way back.
    fn put(&self) -> Stretch {
        Stretch {
            to: self.range.start,
            from: 0,
            count: self.range.len(),
        }
    }
}

impl<F: Field> PerBlock<F> {
    /// One objective for each of these blocks, built on a layout that begins at 0.
    #[must_use]
    pub fn new(parts: Vec<(&DoseLayout, Box<dyn Objective<F>>)>, join: Join) -> Self {
        let part = |(layout, objective): (&DoseLayout, _)| Part {
            range: layout.range(),
            layout: DoseLayout {
                offset: 0,
                ..layout.clone()
            },
            objective,
        };
        PerBlock {
            parts: parts.into_iter().map(part).collect(),
            join,
            scratch: Scratch::default(),
        }
    }

    /// What comes of a field of the size of a block, with any content, which lives where `all` does.
    fn lend<R>(&self, part: &Part<F>, all: &F, with: impl FnOnce(&mut F) -> R) -> R {
        let block = self.scratch.take(part.range.len());
        let mut block = block.unwrap_or_else(|| {
            let facts = Facts {
                patterns: &[],
                outputs: std::slice::from_ref(&part.layout),
                z_coupling: ZCoupling::None,
                is_linear: true,
            };
            all.zeros_of(&facts, Space::Dose)
        });
        let found = with(&mut block);
        self.scratch.give_back(block);
        found
    }

    /// What comes of a block of a field.
    fn of_block<R>(&self, field: &F, part: &Part<F>, with: impl FnOnce(&F) -> R) -> R {
        self.lend(part, field, |block| {
            block.set_stretches(false, 1.0, field, &[part.taken()]);
            with(block)
        })
    }
}

impl<F: Field> Objective<F> for PerBlock<F> {
    fn value(&self, dose: &F) -> f64 {
        let value = |part: &Part<F>| self.of_block(dose, part, |dose| part.objective.value(dose));
        let losses: Vec<f64> = self.parts.iter().map(value).collect();
        self.join.value_and_slopes(&losses).0
    }

    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64 {
        let mut losses = Vec::with_capacity(self.parts.len());
        for part in &self.parts {
            losses.push(self.lend(part, dose, |slope| {
                let loss = self.of_block(dose, part, |dose| {
                    part.objective.value_and_gradient(dose, slope)
                });
                grad.set_stretches(false, 1.0, slope, &[part.put()]);
                loss
            }));
        }
        let (loss, slopes) = self.join.value_and_slopes(&losses);
        for (part, slope) in self.parts.iter().zip(slopes) {
            if slope != 1.0 {
                self.lend(part, dose, |block| {
                    block.set_stretches(false, slope as f32, grad, &[part.taken()]);
                    grad.set_stretches(false, 1.0, block, &[part.put()]);
                });
            }
        }
        loss
    }

    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64) {
        let along = |part: &Part<F>| {
            self.of_block(dose, part, |dose| {
                self.of_block(step, part, |step| {
                    part.objective.slope_along(dose, step, alpha)
                })
            })
        };
        let (losses, rises): (Vec<f64>, Vec<f64>) = self.parts.iter().map(along).unzip();
        let (loss, slopes) = self.join.value_and_slopes(&losses);
        let rise = slopes.iter().zip(&rises).map(|(slope, rise)| slope * rise);
        (loss, rise.sum())
    }

    fn is_convex(&self) -> bool {
        self.parts.iter().all(|part| part.objective.is_convex())
    }

    fn set_response(&mut self, response: &Arc<dyn Response>) -> Result<()> {
        let mut parts = self.parts.iter_mut();
        parts.try_for_each(|part| part.objective.set_response(response))
    }

    /// That of the first block: the first species, or the job as it is.
    fn window(&self, dose: &F) -> Option<FoundWindow> {
        let part = self.parts.first()?;
        self.of_block(dose, part, |dose| part.objective.window(dose))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OBJECTIVES, check};
    use tomolith_core::check::example;
    use tomolith_core::check::small::SmallModel;
    use tomolith_core::near;
    use tomolith_core::response::Identity;

    #[test]
    fn the_sum_over_species_passes_the_check_and_each_sees_its_own_block() {
        let model = SmallModel::new(12, 2, 7);
        let objective_of = |name: &str| {
            let row = OBJECTIVES.iter().find(|row| row.name == name).unwrap();
            check::of_ring(&model, name, example(row).value, Arc::new(Identity))
        };
        let first = model.layout().clone();
        let second = DoseLayout {
            offset: first.len(),
            ..first.clone()
        };
        let joined = |join| {
            PerBlock::new(
                vec![
                    (&first, objective_of("threshold")),
                    (&second, objective_of("l2")),
                ],
                join,
            )
        };
        let noise = tomolith_core::check::noise(5, 2 * first.len());
        let dose: Vec<f32> = noise.iter().map(|v| 0.6 + 0.8 * v).collect();
        let field = HostField::from_slice(&dose);
        let [one, two] = [&dose[..first.len()], &dose[first.len()..]].map(HostField::from_slice);
        let alone = [
            objective_of("threshold").value(&one),
            objective_of("l2").value(&two),
        ];
        let sum: f64 = alone.iter().sum();
        let powers: f64 = alone.iter().map(|l| l.powi(8)).sum();
        let norm = (0.5 * powers).powf(0.125);
        for (join, expected) in [
            (Join::Sum, sum),
            (Join::Mean, 0.5 * sum),
            (Join::Worst, norm),
        ] {
            let both = joined(join);
            check::objective(&both, &field).unwrap();
            let found = both.value(&field);
            near!(found, expected, 1e-12 * expected, "{join:?}: {found}");
        }
        assert_eq!(joined(Join::Sum).value(&field), sum);
        assert!(norm <= alone[1] && norm > 0.9 * alone[1]);
    }
}
