//! One objective per species of a dose.
//!
//! L = Σ_s L_s(r_s), where r_s is the block of species s in the dose field. The objective of a species knows its own block only.
//!
//! **Cost** a copy of each block per call, beside the objectives' own passes.

use super::Objective;
use std::ops::Range;
use tomolith_core::dose::DoseLayout;
use tomolith_core::field::{Field, HostField};

/// Objectives of the blocks of a dose field.
pub struct PerSpecies {
    parts: Vec<(Range<usize>, Box<dyn Objective<HostField>>)>,
}

impl PerSpecies {
    /// The sum over these species; each objective is built on a layout that begins at 0.
    #[must_use]
    pub fn new(parts: Vec<(&DoseLayout, Box<dyn Objective<HostField>>)>) -> Self {
        let parts = parts.into_iter();
        PerSpecies {
            parts: parts.map(|(layout, o)| (layout.range(), o)).collect(),
        }
    }
}

fn block(field: &HostField, range: &Range<usize>) -> HostField {
    HostField::from_slice(&field.as_slice()[range.clone()])
}

impl Objective<HostField> for PerSpecies {
    fn value(&self, dose: &HostField) -> f64 {
        let value =
            |(range, part): &(_, Box<dyn Objective<HostField>>)| part.value(&block(dose, range));
        self.parts.iter().map(value).sum()
    }

    fn value_and_gradient(&self, dose: &HostField, grad: &mut HostField) -> f64 {
        let mut loss = 0.0;
        for (range, part) in &self.parts {
            let own = block(dose, range);
            let mut slope = own.zeros_like();
            loss += part.value_and_gradient(&own, &mut slope);
            grad.as_mut_slice()[range.clone()].copy_from_slice(slope.as_slice());
        }
        loss
    }

    fn slope_along(&self, dose: &HostField, step: &HostField, alpha: f32) -> (f64, f64) {
        let sum =
            |(loss, slope): (f64, f64),
             (range, part): &(Range<usize>, Box<dyn Objective<HostField>>)| {
                let (value, rise) =
                    part.slope_along(&block(dose, range), &block(step, range), alpha);
                (loss + value, slope + rise)
            };
        self.parts.iter().fold((0.0, 0.0), sum)
    }

    fn is_convex(&self) -> bool {
        self.parts.iter().all(|(_, part)| part.is_convex())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OBJECTIVES, ObjectiveInput, check};
    use std::sync::Arc;
    use tomolith_core::check::example;
    use tomolith_core::check::small::SmallModel;
    use tomolith_core::response::Identity;

    #[test]
    fn the_sum_over_species_passes_the_check_and_each_sees_its_own_block() {
        let model = SmallModel::new(12, 2, 7);
        let (target, labels) = model.ring();
        let input = ObjectiveInput {
            layout: model.layout(),
            labels: &labels,
            target: &target,
            response: Arc::new(Identity),
        };
        let of = |name: &str| {
            let row = OBJECTIVES.iter().find(|row| row.name == name).unwrap();
            (row.build)(&example(row), &input).unwrap()
        };
        let first = model.layout().clone();
        let second = DoseLayout {
            offset: first.len(),
            ..first.clone()
        };
        let both = PerSpecies::new(vec![(&first, of("threshold")), (&second, of("l2"))]);
        let noise = tomolith_core::check::noise(2 * first.len(), 5);
        let dose: Vec<f32> = noise.iter().map(|v| 0.6 + 0.8 * v).collect();
        check::objective(&both, &HostField::from_slice(&dose)).unwrap();
        let [one, two] = [&dose[..first.len()], &dose[first.len()..]].map(HostField::from_slice);
        let alone = of("threshold").value(&one) + of("l2").value(&two);
        assert_eq!(both.value(&HostField::from_slice(&dose)), alone);
    }
}
