//! A print whose inhibitor is frozen: linear light, less the dose that the inhibitor took in the last simulation.
//!
//! **Equation** degree of cure r_s = (A_s(x) − c_s)/E_d. A_s: drive that the patterns leave in all of the schedule, linear in x.
//! c_s = A_s(x₀) − E_s(x₀) + Σ Oᵢ(x₀)/κᵢ: what inhibitors took from the drive of the patterns x₀ of the last simulation, what flowed in between included,
//! and what is left of them at its end. Where voxels are alone this is exact for any x: their inhibitor takes what it takes. A voxel into which dose diffused, or
//! whose network did not feel an antagonist, has more dose than drive: c is negative there, so that r is the degree of cure of the last simulation everywhere.
//!
//! **Rounds** [`renew`](Renewal::renew) simulates the print of the patterns anew after every so many iterations, so that a method solves, simulates
//! and solves again. Before the first time c is what the start of the material holds. c is the [memory](Renewal::memory) that checkpoints keep.
//!
//! **Source** the quasi-linear tier of `docs/material.md`.
//!
//! **Limits** A threshold of the dose ([`Photopolymer::requirement`]); light stays as the models have it, unshaded.
//!
//! **Cost** that of the light, and one print in time per round. Memory: a volume per network.

use crate::illumination::factor;
use crate::lights::Lights;
use crate::photopolymer::Photopolymer;
use crate::print::{LightSource, PrintRun};
use crate::schedule::Schedule;
use crate::{Model, State};
use std::ops::{ControlFlow, Range};
use std::sync::{Arc, PoisonError, RwLock};
use tomolith_core::dose::{DoseModel, Facts, Renewal, Space, Work, elements_of};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{BLOCK, Field, HostField};
use tomolith_core::parallel::InParallel;

/// See the [module page](self).
pub struct Frozen {
    lights: Lights,
    material: Photopolymer,
    step_s: Option<f64>,
    /// 1/E_d per network, mm³/mJ.
    per_dose: Vec<f32>,
    /// c, in the order of the outputs.
    taken: RwLock<HostField>,
    every: usize,
}

impl Frozen {
    /// A print of these lights, simulated anew every so many iterations.
    ///
    /// # Errors
    /// As [`Printing::new`](crate::printing::Printing::new); [`Error::Unsupported`] for a network whose gel dose depends on the power.
    pub fn new(
        optics: Vec<Box<Model>>,
        schedule: Schedule,
        material: Photopolymer,
        step_s: Option<f64>,
        every: usize,
    ) -> Result<Self> {
        let species = material.drives().species();
        let mut per_dose = Vec::with_capacity(species);
        for s in 0..species {
            let Some(needed) = material.requirement(s) else {
                return Err(Error::unsupported(
                    "a frozen inhibitor",
                    "the dose that gels depends on the power; a network with a threshold",
                ));
            };
            per_dose.push((1.0 / needed.dose) as f32);
        }
        let lights = Lights::new(optics, schedule, &material)?;
        let frozen = Frozen {
            taken: RwLock::new(lights.facts().host_field(Space::Dose)),
            lights,
            step_s,
            per_dose,
            every: every.max(1),
            material,
        };
        let start = frozen.material.start()?;
        frozen.take(&start, None);
        Ok(frozen)
    }

    /// Prints these patterns and freezes what its inhibitors took.
    ///
    /// # Errors
    /// Those of the print.
    pub fn simulate(&self, x: &HostField, work: &Work) -> Result<()> {
        let patterns: Vec<HostField> = (0..self.lights.optics.len())
            .map(|light| self.lights.of_light(light, x))
            .collect();
        let models = self.lights.optics.iter().map(AsRef::as_ref);
        let sources = models.zip(&patterns);
        let sources = sources.map(|(model, patterns)| LightSource { model, patterns });
        let schedule = &self.lights.schedule;
        let mut print = PrintRun::new(&self.material, schedule, sources.collect())?;
        if let Some(step_s) = self.step_s {
            print = print.with_step_s(step_s)?;
        }
        let end = print.run(work, &mut |_| ControlFlow::Continue(()))?;
        let mut drive = self.new_dose()?;
        self.drive(x, &mut drive, work)?;
        self.take(&end, Some(&drive));
        Ok(())
    }

    /// c of a state that this drive has led to (None: the start).
    fn take(&self, state: &State, drive: Option<&HostField>) {
        let mut taken = self.taken.write().unwrap_or_else(PoisonError::into_inner);
        for (s, output) in self.lights.outputs.iter().enumerate() {
            let Some(needed) = self.material.requirement(s) else {
                continue;
            };
            let readout = self.material.readout(s);
            let dose = state.volumes[readout.volume].as_slice();
            let per_unit = readout.scale / readout.gel * needed.dose as f32;
            let values = &mut taken.as_mut_slice()[output.range()];
            match drive {
                None => values.fill(0.0),
                Some(drive) => values
                    .iter_mut()
                    .zip(&drive.as_slice()[output.range()])
                    .zip(dose)
                    .for_each(|((c, a), e)| *c = a - per_unit * e),
            }
            for (volume, capacity) in needed.inhibitors {
                let left = state.volumes[volume].as_slice();
                let capacity = capacity as f32;
                values
                    .iter_mut()
                    .zip(left)
                    .for_each(|(c, o)| *c += capacity * o);
            }
        }
    }
}

/// sum += weight·energy.
fn add(weight: f32, energy: &[f32], sum: &mut [f32]) {
    if weight == 0.0 {
        return;
    }
    let chunks = sum.chunks_mut(BLOCK).zip(energy.chunks(BLOCK));
    chunks.par_each(|(sum, energy)| {
        let pairs = sum.iter_mut().zip(energy);
        pairs.for_each(|(sum, e)| *sum += weight * e);
    });
}

impl Frozen {
    /// A_s(x), the drive of each network.
    fn drive(&self, x: &HostField, drive: &mut HostField, work: &Work) -> Result<()> {
        drive.fill(0.0);
        for (light, model) in self.lights.optics.iter().enumerate() {
            let patterns = self.lit(light, x);
            let mut of_light = model.new_dose()?;
            model.dose(&patterns, &mut of_light, &work.aside())?;
            self.mix(light, &of_light, drive);
        }
        Ok(())
    }

    /// The patterns of a light, as strong as in all of the schedule.
    fn lit(&self, light: usize, x: &HostField) -> HostField {
        let mut patterns = self.lights.of_light(light, x);
        self.scale_by_energy(light, &mut patterns);
        patterns
    }

    /// Values of a light times the factor of all energy of their frames.
    fn scale_by_energy(&self, light: usize, x: &mut HostField) {
        let patterns = self.lights.light(light).patterns();
        for (frame, energy) in self.lights.schedule.energies(light).into_iter().enumerate() {
            for (range, quantity) in elements_of(patterns, &(frame..frame + 1)) {
                let factor = factor(quantity, energy);
                let values = x.as_mut_slice()[range].iter_mut();
                values.for_each(|v| *v *= factor);
            }
        }
    }

    /// drive += what the dose of a light is worth to every network.
    fn mix(&self, light: usize, of_light: &HostField, drive: &mut HostField) {
        for (s, output) in self.lights.outputs.iter().enumerate() {
            let weight = self.material.drives().row(s)[light];
            let drive = &mut drive.as_mut_slice()[output.range()];
            add(weight, of_light.as_slice(), drive);
        }
    }

    /// The transpose of [`mix`](Self::mix) over all networks.
    fn unmix(&self, light: usize, cotangent: &HostField, of_light: &mut HostField) {
        of_light.fill(0.0);
        for (s, output) in self.lights.outputs.iter().enumerate() {
            let weight = self.material.drives().row(s)[light];
            let cotangent = &cotangent.as_slice()[output.range()];
            add(weight, cotangent, of_light.as_mut_slice());
        }
    }

    /// Doses as degrees of cure.
    fn scale(&self, doses: &mut HostField) {
        for (output, &per_dose) in self.outputs().iter().zip(&self.per_dose) {
            let values = &mut doses.as_mut_slice()[output.range()];
            values.iter_mut().for_each(|v| *v *= per_dose);
        }
    }
}

impl Renewal<HostField> for Frozen {
    fn renew(&self, iteration: usize, x: &HostField, work: &Work) -> Result<bool> {
        let is_due = iteration > 1 && (iteration - 1).is_multiple_of(self.every);
        if is_due {
            self.simulate(x, &work.aside())?;
        }
        Ok(is_due)
    }

    fn memory(&self) -> Option<HostField> {
        let taken = self.taken.read().unwrap_or_else(PoisonError::into_inner);
        Some(taken.clone())
    }

    fn restore(&self, memory: &HostField) {
        let mut taken = self.taken.write().unwrap_or_else(PoisonError::into_inner);
        taken.copy_from(memory);
    }
}

impl DoseModel for Frozen {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        self.lights.facts()
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn updates(&self) -> u64 {
        self.lights.optics.iter().map(|model| model.updates()).sum()
    }

    fn of_light(&self, i: usize) -> Option<Arc<Model>> {
        self.lights.optics.get(i).cloned()
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        Some(self)
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, work: &Work) -> Result<()> {
        self.drive(x, dose, work)?;
        let taken = self.taken.read().unwrap_or_else(PoisonError::into_inner);
        for (output, &per_dose) in self.outputs().iter().zip(&self.per_dose) {
            let blocks = dose.as_mut_slice()[output.range()].chunks_mut(BLOCK);
            let taken = taken.as_slice()[output.range()].chunks(BLOCK);
            blocks.zip(taken).par_each(|(dose, taken)| {
                let pairs = dose.iter_mut().zip(taken);
                pairs.for_each(|(d, c)| *d = per_dose * (*d - c));
            });
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let mut scaled = cotangent.clone();
        self.scale(&mut scaled);
        for (light, frames) in self.lights.own_frames(&frames).into_iter().enumerate() {
            if frames.is_empty() {
                continue;
            }
            let model = self.lights.light(light);
            let patterns = self.lit(light, x);
            let mut of_light = model.new_dose()?;
            self.unmix(light, &scaled, &mut of_light);
            let mut back = model.new_patterns()?;
            model.pullback_of(
                frames.clone(),
                &patterns,
                &of_light,
                &mut back,
                &work.aside(),
            )?;
            self.scale_by_energy(light, &mut back);
            let grad = &mut grad.as_mut_slice()[self.lights.ranges[light].clone()];
            for (range, _) in elements_of(model.patterns(), &frames) {
                grad[range.clone()].copy_from_slice(&back.as_slice()[range]);
            }
        }
        Ok(())
    }

    fn dose_of(&self, _: Range<usize>, _: &HostField, _: &mut HostField, _: &Work) -> Result<()> {
        Err(Error::unsupported(
            "the dose of some frames",
            "what inhibitors take belongs to all frames",
        ))
    }

    fn along(&self, x: &HostField, d: &HostField, work: &Work) -> Result<Option<Vec<HostField>>> {
        let mut terms: Vec<HostField> = Vec::new();
        for (light, model) in self.lights.optics.iter().enumerate() {
            let [x, d] = [x, d].map(|v| self.lit(light, v));
            let Some(curve) = model.along(&x, &d, &work.aside())? else {
                return Ok(None);
            };
            for (i, term) in curve.iter().enumerate() {
                if terms.len() == i {
                    terms.push(self.new_dose()?);
                }
                self.mix(light, term, &mut terms[i]);
            }
        }
        terms.iter_mut().for_each(|term| self.scale(term));
        Ok(Some(terms))
    }

    fn describe(&self) -> String {
        format!(
            "{}, less what inhibitors take",
            self.lights.light(0).describe()
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::{domain_of, network, oxygen, photopolymer, wandering};
    use crate::mixing::Mixing;
    use crate::photopolymer::{Params, Photopolymer};
    use crate::printing::Printing;
    use crate::schedule::{Power, Turns};
    use tomolith_core::check;
    use tomolith_core::check::small::SmallModel;
    use tomolith_core::dose::frames_of;
    use tomolith_core::near;

    fn material() -> Photopolymer {
        photopolymer(network(vec![oxygen(0.15, 0.05)], 0.3), domain_of(&optics()))
    }

    /// Voxels of 1 mm.
    fn optics() -> SmallModel {
        SmallModel::new(12, 12, 4)
    }

    fn frozen() -> Frozen {
        frozen_of(material())
    }

    fn frozen_of(material: Photopolymer) -> Frozen {
        let schedule = Schedule::of_turns(&[Turns::new(12, 10.0, 3.0)]).unwrap();
        let optics: Vec<Box<Model>> = vec![Box::new(optics())];
        Frozen::new(optics, schedule, material, None, 5).unwrap()
    }

    fn patterns(model: &Frozen) -> HostField {
        let mut x = model.new_patterns().unwrap();
        let noise = check::noise(4, x.len());
        let values = x.as_mut_slice().iter_mut().zip(noise);
        values.for_each(|(x, n)| *x = 0.5 + 0.4 * n);
        x
    }

    /// The degree of cure of the print in time, and of the frozen model.
    fn both(model: &Frozen, x: &HostField) -> (Vec<f32>, Vec<f32>) {
        both_of(model, x, material())
    }

    fn both_of(model: &Frozen, x: &HostField, material: Photopolymer) -> (Vec<f32>, Vec<f32>) {
        let schedule = model.lights.schedule.clone();
        let optics = vec![Box::new(optics()) as Box<Model>];
        let printing = Printing::new(optics, schedule, material, None);
        let work = Work::new();
        let mut degree = model.new_dose().unwrap();
        printing.unwrap().dose(x, &mut degree, &work).unwrap();
        let frozen = check::dose(model, x);
        (degree.as_slice().to_vec(), frozen.as_slice().to_vec())
    }

    /// Two networks in two lights, one of which works against the first network.
    fn in_two_lights() -> Frozen {
        let mixing = Mixing::new(vec![vec![1.0, -0.4], vec![0.0, 2.0]]).unwrap();
        let networks = [0.3, 0.7].map(|dose| network(Vec::new(), dose));
        let params = Params::new(networks.to_vec());
        let material = Photopolymer::new(params, mixing, domain_of(&optics())).unwrap();
        let first = Turns {
            power: Power::Irradiance(0.3),
            ..Turns::new(12, 6.0, 1.5)
        };
        let schedule = Schedule::of_turns(&[first, Turns::new(12, 4.0, 2.0)]).unwrap();
        let optics: Vec<Box<Model>> = vec![Box::new(optics()), Box::new(optics())];
        Frozen::new(optics, schedule, material, None, 5).unwrap()
    }

    #[test]
    fn its_derivative_is_exact() {
        derivative_is_exact(&frozen());
        derivative_is_exact(&in_two_lights());
    }

    fn derivative_is_exact(model: &Frozen) {
        let (x, work) = (patterns(model), Work::new());
        model.simulate(&x, &work).unwrap();
        let mut d = x.clone();
        d.scale(0.1);
        let terms = model.along(&x, &d, &work).unwrap().unwrap();
        assert_eq!(terms.len(), 1);
        let mut moved = x.clone();
        moved.axpy(1.0, &d);
        let [mut before, mut after] = [model.new_dose().unwrap(), model.new_dose().unwrap()];
        model.dose(&x, &mut before, &work).unwrap();
        model.dose(&moved, &mut after, &work).unwrap();
        after.axpy(-1.0, &before);
        after.axpy(-1.0, &terms[0]);
        assert!(after.max_abs() < 1e-5, "{}", after.max_abs());
        // ⟨F′d, c⟩ = ⟨d, F′ᵀc⟩
        let c = HostField::from_slice(&check::noise(9, terms[0].len()));
        let mut back = x.zeros_like();
        model.pullback(&x, &c, &mut back, &work).unwrap();
        let (mut part, all) = (x.zeros_like(), frames_of(model.patterns()));
        for frames in [0..5, 5..all - 1, all - 1..all] {
            model.pullback_of(frames, &x, &c, &mut part, &work).unwrap();
        }
        assert!(part.as_slice() == back.as_slice());
        let (forth, back) = (terms[0].dot(&c), back.dot(&d));
        near!(forth, back, 1e-5 * forth.abs().max(1.0));
    }

    #[test]
    fn it_is_the_print_where_it_was_simulated() {
        let model = frozen();
        let x = patterns(&model);
        // Before, oxygen neither flows nor is anything known of it but its capacity
        let (_, before) = both(&model, &x);
        model.simulate(&x, &Work::new()).unwrap();
        let (print, frozen) = both(&model, &x);
        let mut worst = 0.0f32;
        let mut moved = 0.0f32;
        for ((print, frozen), before) in print.iter().zip(&frozen).zip(&before) {
            if *print > 0.0 {
                worst = worst.max((print - frozen).abs());
                moved = moved.max((print - before).abs());
            }
        }
        assert!(worst < 1e-4 && moved > 0.02, "{worst} {moved}");
    }

    #[test]
    fn dose_that_flows_into_a_voxel_is_its_own() {
        let material = || photopolymer(wandering(0.3, 0.05), domain_of(&optics()));
        let model = frozen_of(material());
        let (x, work) = (patterns(&model), Work::new());
        let drive = check::dose(&model, &x);
        model.simulate(&x, &work).unwrap();
        let (print, frozen) = both_of(&model, &x, material());
        let pairs = print.iter().zip(&frozen);
        let off = pairs.map(|(p, f)| (p - f).abs()).fold(0.0, f32::max);
        let gained = print.iter().zip(drive.as_slice());
        let gained = gained.filter(|(p, a)| **p > **a + 0.02).count();
        assert!(off < 1e-4 && gained > 20, "{off} {gained}");
    }

    #[test]
    fn a_simulation_is_canceled_with_the_run_that_asked_for_it() {
        let model = frozen();
        let (x, work) = (patterns(&model), Work::new());
        let before = model.memory().unwrap();
        work.cancel();
        let error = model.renew(6, &x, &work).unwrap_err();
        assert!(matches!(error, Error::Canceled), "{error}");
        assert_eq!(model.memory().unwrap().as_slice(), before.as_slice());
    }

    #[test]
    fn it_is_simulated_anew_between_rounds() {
        let model = frozen();
        let (x, work) = (patterns(&model), Work::new());
        for iteration in [1, 5, 7] {
            assert!(!model.renew(iteration, &x, &work).unwrap(), "{iteration}");
        }
        assert!(model.renew(6, &x, &work).unwrap());
        let (print, frozen) = both(&model, &x);
        let off = print.iter().zip(&frozen).filter(|(p, _)| **p > 0.0);
        assert!(off.map(|(p, f)| (p - f).abs()).fold(0.0, f32::max) < 1e-4);
    }

    #[test]
    fn another_model_goes_on_from_its_memory() {
        let (model, other) = (frozen(), frozen());
        let (x, work) = (patterns(&model), Work::new());
        model.simulate(&x, &work).unwrap();
        let (_, unlike) = both(&other, &x);
        other.restore(&model.memory().unwrap());
        let ((_, expected), (_, found)) = (both(&model, &x), both(&other, &x));
        assert!(found == expected && found != unlike);
    }
}
