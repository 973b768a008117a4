//! The light budget: where the light of the patterns goes.
//!
//! **Equation** sent = Σ x·(pixel pitch)², absorbed in a region = Σ_v d_v·(voxel pitch)³, both in the unit of dose times mm³: mJ
//! where doses are mJ/mm³, else relative as they are; shares are absorbed over sent. What is neither in the part nor in the void of the grid is reflected, leaves the vial, or is absorbed
//! elsewhere. Doses are those of the active species; with pure Radon (a sum of fluences) the shares mean nothing.

use super::{List, TOMOLITH};
use tomolith_core::field::BLOCK;
use tomolith_core::grid::{Patterns, Volume};
use tomolith_core::parallel::InParallel;
use tomolith_core::target::label;

/// Energies of a print, in the unit of its doses times mm³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightBudget {
    /// Sent by the projectors.
    pub sent: f64,
    /// Absorbed in the part.
    pub part: f64,
    /// Absorbed in the void.
    pub void: f64,
    /// Absorbed in voxels of the grid that do not count.
    pub outside: f64,
}

/// The budget of patterns and their dose; labels are of the dose's voxels.
#[must_use]
pub fn light_budget(dose: &Volume<f32>, labels: &Volume<u8>, patterns: &[Patterns]) -> LightBudget {
    let sums: Vec<[f64; 3]> = dose
        .values
        .chunks(BLOCK)
        .zip(labels.values.chunks(BLOCK))
        .par_map(|(dose, labels)| {
            // In registers, whatever the label
            let [mut part, mut void, mut outside] = [0.0; 3];
            for (&dose, &own) in dose.iter().zip(labels) {
                let dose = f64::from(dose);
                let (is_part, is_void) = (own == label::PART, own == label::VOID);
                part += if is_part { dose } else { 0.0 };
                void += if is_void { dose } else { 0.0 };
                outside += if is_part || is_void { 0.0 } else { dose };
            }
            [part, void, outside]
        });
    let voxel = dose.grid.voxel_mm3();
    let of = |at: usize| voxel * sums.iter().map(|s| s[at]).sum::<f64>();
    let sent = patterns.iter().map(|light| {
        let sums: Vec<f64> = light
            .values
            .chunks(BLOCK)
            .par_map(|b| b.iter().map(|&x| f64::from(x)).sum());
        sums.iter().sum::<f64>() * light.grid.pixel_mm2()
    });
    LightBudget {
        sent: sent.sum(),
        part: of(0),
        void: of(1),
        outside: of(2),
    }
}

pub(super) fn list(
    list: &mut List,
    dose: &Volume<f32>,
    labels: &Volume<u8>,
    patterns: &[Patterns],
) {
    let budget = light_budget(dose, labels, patterns);
    let share = |energy: f64| (budget.sent > 0.0).then(|| energy / budget.sent);
    list.add(
        "light_sent",
        TOMOLITH,
        "dose × mm³",
        (!patterns.is_empty()).then_some(budget.sent),
        "Σ pattern value × pixel area: mJ if doses are in mJ/mm³, else relative",
    );
    list.add(
        "light_in_part",
        TOMOLITH,
        "",
        share(budget.part),
        "share of it that is absorbed in the part",
    );
    list.add(
        "light_in_void",
        TOMOLITH,
        "",
        share(budget.void),
        "share of it that is absorbed in the void",
    );
    let absorbed = budget.part + budget.void;
    let useful = (absorbed > 0.0).then(|| budget.part / absorbed);
    list.add(
        "dose_in_part",
        TOMOLITH,
        "",
        useful,
        "share of the absorbed light that is absorbed in the part",
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::{PatternGrid, VolumeGrid};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn energies_are_those_of_pixels_and_voxels() {
        let mut patterns = Patterns::dark(PatternGrid::full_turn(2, 0.0, 1, 2, 0.5));
        patterns.values = vec![1.0, 2.0, 3.0, 2.0];
        let grid = VolumeGrid::centered([1, 1, 3], 0.5);
        let dose = Volume::new(grid.clone(), vec![4.0, 2.0, 1.0]);
        let labels = Volume::new(grid, vec![PART, VOID, OUTSIDE]);
        let budget = light_budget(&dose, &labels, &[patterns.clone()]);
        // 8·0.25 mJ sent; a voxel is 0.125 mm³
        assert_eq!(
            budget,
            LightBudget {
                sent: 2.0,
                part: 0.5,
                void: 0.25,
                outside: 0.125
            }
        );
        let mut numbers = List::default();
        list(&mut numbers, &dose, &labels, &[patterns]);
        let values: Vec<_> = numbers.0.iter().map(|n| n.value.unwrap()).collect();
        assert_eq!(values, [2.0, 0.25, 0.125, 0.5 / 0.75]);
    }
}
