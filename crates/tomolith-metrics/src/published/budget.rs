//! The light budget: where the light of the patterns goes.
//!
//! **Equation** sent = Σ x·(pixel pitch)², absorbed in a region = Σ_v d_v·(voxel pitch)³, both in the unit of dose times mm³: mJ
//! where doses are mJ/mm³, else relative as they are; shares are absorbed over sent. What is neither in the part nor in the void of the grid is reflected, leaves the vial, or is absorbed
//! elsewhere. Doses are those of the active species; of a dose that is no absorbed light (pure Radon, lights with factors) there are no shares of the light.

use super::{List, Options, TOMOLITH};
use tomolith_core::field::BLOCK;
use tomolith_core::grid::{Patterns, Volume};
use tomolith_core::parallel::InParallel;
use tomolith_core::target::label;

/// Energies of patterns and their dose, in the unit of doses times mm³: sent by the projectors, absorbed in the part, and in the void.
fn light_budget(dose: &Volume<f32>, labels: &Volume<u8>, patterns: &[Patterns]) -> [f64; 3] {
    let sums: Vec<[f64; 2]> = dose
        .values
        .chunks(BLOCK)
        .zip(labels.values.chunks(BLOCK))
        .par_map(|(dose, labels)| {
            // In registers, whatever the label
            let [mut part, mut void] = [0.0; 2];
            for (&dose, &label) in dose.iter().zip(labels) {
                let dose = f64::from(dose);
                part += if label == label::PART { dose } else { 0.0 };
                void += if label == label::VOID { dose } else { 0.0 };
            }
            [part, void]
        });
    let voxel = dose.grid.voxel_mm3();
    let energy_of = |at: usize| voxel * sums.iter().map(|s| s[at]).sum::<f64>();
    let sent = patterns.iter().map(|light| {
        let sums: Vec<f64> = light
            .values
            .chunks(BLOCK)
            .par_map(|b| b.iter().map(|&x| f64::from(x)).sum());
        sums.iter().sum::<f64>() * light.grid.pixel_mm2()
    });
    [sent.sum(), energy_of(0), energy_of(1)]
}

pub(super) fn list(
    list: &mut List,
    dose: &Volume<f32>,
    labels: &Volume<u8>,
    options: &Options<'_>,
) {
    let patterns = options.patterns;
    let [sent, part, void] = light_budget(dose, labels, patterns);
    let share = |energy: f64| (options.is_absorbed && sent > 0.0).then(|| energy / sent);
    list.add(
        "light_sent",
        TOMOLITH,
        "dose × mm³",
        (!patterns.is_empty()).then_some(sent),
        "Σ pattern value × pixel area: mJ if doses are in mJ/mm³, else relative",
    );
    list.add(
        "light_in_part",
        TOMOLITH,
        "",
        share(part),
        "share of it that is absorbed in the part",
    );
    list.add(
        "light_in_void",
        TOMOLITH,
        "",
        share(void),
        "share of it that is absorbed in the void",
    );
    let absorbed = part + void;
    let useful = (absorbed > 0.0).then(|| part / absorbed);
    list.add(
        "dose_in_part",
        TOMOLITH,
        "",
        useful,
        "share of the dose of part and void that is in the part",
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
        // 8·0.25 mJ sent; a voxel is 0.125 mm³
        let mut numbers = List::default();
        let options = Options {
            patterns: &[patterns],
            ..Options::default()
        };
        list(&mut numbers, &dose, &labels, &options);
        let values = |list: &List| list.0.iter().map(|n| n.value).collect::<Vec<_>>();
        let useful = Some(0.5 / 0.75);
        assert_eq!(
            values(&numbers),
            [Some(2.0), Some(0.25), Some(0.125), useful]
        );
        // A sum of fluences is no share of the light
        let mut numbers = List::default();
        let fluence = Options {
            is_absorbed: false,
            ..options
        };
        list(&mut numbers, &dose, &labels, &fluence);
        assert_eq!(values(&numbers), [Some(2.0), None, None, useful]);
    }
}
