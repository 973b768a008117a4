//! When each height of a print is done: the budget of dose, slice by slice.
//!
//! **Definition** At height z, contribution(z, t) = Σ A_v V over gelled voxels of that height, requirement(z) = Σ (E_d + Σ O(0)/κ) V over the part there; the
//! height is done when the first reaches the second (as [`Curves::ideal_exposure`](crate::curves::Curves::ideal_exposure) has it for the whole print).
//! Where voxels do not exchange inhibitor, g times the light at a height brings that g times as soon.
//!
//! **Source** Wang et al. 2022, supplement, Note 4: the requirement differs from slice to slice, so gray values are to be rescaled slice by slice.
//!
//! **Cost** one pass over the voxels per moment; one volume.

use crate::curves::{IdealExposure, add_drive};
use crate::photopolymer::Photopolymer;
use crate::print::Moment;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::grid::Volume;
use tomolith_core::parallel::InParallel;
use tomolith_core::target::label;

/// Rows of lanes that are summed at once.
const ROWS: usize = 256;

/// See the [module page](self).
pub struct Heights {
    species: usize,
    /// 0 where voxels do not count, in the order of the layout.
    counted: Vec<bool>,
    /// Per height, mJ/mm³ times voxels.
    requirement: Vec<f64>,
    contribution: Vec<f64>,
    done: Vec<Option<f64>>,
    absorbed: HostField,
    before_s: f64,
}

impl Heights {
    /// Heights of a network, for the labels of its target (file order).
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a network whose gel dose depends on the power; those of the start.
    ///
    /// # Panics
    /// When labels are of another shape than the material's voxels.
    pub fn new(material: &Photopolymer, species: usize, labels: &Volume<u8>) -> Result<Self> {
        let Some(needed) = material.requirement(species) else {
            return Err(Error::unsupported(
                "what each height needs",
                "the dose that gels depends on the power; a network with a threshold",
            ));
        };
        let layout = material.domain().layout();
        let [nz, ..] = layout.grid.shape;
        let labels = layout.field_of(labels);
        let start = material.start()?;
        let mut requirement = vec![0.0; nz];
        for (i, _) in labels.iter().enumerate().filter(|l| *l.1 == label::PART) {
            let inhibited = |&(volume, capacity): &(usize, f64)| {
                capacity * f64::from(start.volumes[volume].as_slice()[i])
            };
            let inhibited: f64 = needed.inhibitors.iter().map(inhibited).sum();
            if let Some(sum) = requirement.get_mut(i % layout.row) {
                *sum += needed.dose + inhibited;
            }
        }
        Ok(Heights {
            species,
            counted: labels.iter().map(|l| *l != label::OUTSIDE).collect(),
            contribution: vec![0.0; nz],
            done: vec![None; nz],
            requirement,
            absorbed: material.domain().zeros(),
            before_s: 0.0,
        })
    }

    /// Looks at a moment.
    pub fn watch(&mut self, moment: &Moment) {
        let material = moment.material;
        let row = material.drives().row(self.species);
        add_drive(row, moment.absorbed, &mut self.absorbed);
        let now = self.contributions(moment);
        for (z, (&needed, now)) in self.requirement.iter().zip(now).enumerate() {
            let before = std::mem::replace(&mut self.contribution[z], now);
            if needed > 0.0 && now >= needed && self.done[z].is_none() {
                let share = (needed - before) / (now - before).max(f64::MIN_POSITIVE);
                self.done[z] = Some(self.before_s + share * (moment.seconds - self.before_s));
            }
        }
        self.before_s = moment.seconds;
    }

    /// What gelled voxels have absorbed, per height.
    fn contributions(&self, moment: &Moment) -> Vec<f64> {
        let readout = moment.material.readout(self.species);
        let gel = readout.gel / readout.scale;
        let values = moment.state.volumes[readout.volume].as_slice();
        let (row, nz) = (
            moment.material.domain().layout().row,
            self.contribution.len(),
        );
        let chunk = row * ROWS;
        let sums: Vec<Vec<f64>> = values
            .chunks(chunk)
            .zip(self.absorbed.as_slice().chunks(chunk))
            .zip(self.counted.chunks(chunk))
            .par_map(|((values, doses), counted)| {
                let mut sums = vec![0.0; nz];
                for (i, ((&value, &dose), &counted)) in
                    values.iter().zip(doses).zip(counted).enumerate()
                {
                    if counted && value >= gel && i % row < nz {
                        sums[i % row] += f64::from(dose);
                    }
                }
                sums
            });
        let whole = vec![0.0; nz];
        sums.into_iter().fold(whole, |mut whole, part| {
            whole.iter_mut().zip(part).for_each(|(w, o)| *w += o);
            whole
        })
    }

    /// When each height was done; None where nothing is part.
    #[must_use]
    pub fn done(&self) -> Vec<Option<IdealExposure>> {
        let exposure_of = |z: usize| {
            let needed = self.requirement[z];
            (needed > 0.0).then(|| match self.done[z] {
                Some(seconds) => IdealExposure::At(seconds),
                None => IdealExposure::NotReached(self.contribution[z] / needed),
            })
        };
        (0..self.done.len()).map(exposure_of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::fixtures::{network, oxygen, photopolymer};
    use crate::photopolymer::{Inhibitor, Initial};
    use tomolith_core::grid::VolumeGrid;

    #[test]
    fn a_height_is_done_when_its_oxygen_and_its_dose_are_paid() {
        let axial = Inhibitor {
            initial: Initial::Axial(vec![[-0.1, 0.2], [0.1, 1.0]]),
            ..oxygen(0.5, 0.0)
        };
        let grid = VolumeGrid::centered([3, 4, 5], 0.1);
        let material = photopolymer(network(vec![axial], 0.3), Domain::new(grid.clone()));
        let labels = Volume::filled(grid, label::PART);
        let mut heights = Heights::new(&material, 0, &labels).unwrap();
        let mut state = material.start().unwrap();
        let light = vec![0.01; state.volumes[0].as_slice().len()];
        for i in 0..=70 {
            let lit: &[&[f32]] = if i == 0 { &[&[]] } else { &[&light] };
            if i > 0 {
                material.step(&mut state, lit, 1.0).unwrap();
            }
            heights.watch(&Moment {
                seconds: f64::from(i),
                steps: [i as usize, 70],
                block_s: 1.0,
                material: &material,
                state: &state,
                absorbed: lit,
            });
        }
        // (E_d + O/κ)/r: 0.3 + 0.5 of 0.2, 0.6, 1 at 0.01 mJ/mm³ a second, found within a step; the last ends at 80 s
        let done = heights.done();
        for (found, exact) in done.iter().zip([40.0, 60.0]) {
            let Some(IdealExposure::At(found)) = found else {
                panic!("{found:?}")
            };
            assert!((found - exact).abs() <= 1.0, "{found} {exact}");
        }
        assert_eq!(done[2], Some(IdealExposure::NotReached(0.0)));
    }
}
