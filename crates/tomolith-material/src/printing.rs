//! A whole print as a dose model: patterns → what the material reads out at the end of the schedule.
//!
//! **Equation** s_{i+1} = step(s_i, A_i(x)), A_i the energy of block i; output = readout of s_n. The pullback is the chain rule backward in time: states are kept
//! every √n blocks and computed anew between.
//!
//! **Linear?** No, and `along` is None and `dose_of` refused, unless the material has no memory: then it is the dose model itself, with the same bits.
//!
//! **Limits** Absorption stays as the models have it: shading is renewed between optimizations (see [`print`](crate::print)).
//!
//! **Cost** `dose`: one turn through the schedule. `pullback`: two of them, and one pullback of each block's frames. Memory of the pullback: about 2√n states and √n volumes of energy per light.

use crate::illumination::{Illumination, factor};
use crate::memoryless::add_mixed;
use crate::print::{check_step, default_step_s, must_fit};
use crate::schedule::{Block, Schedule};
use crate::{Material, Model, State};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::{
    DoseLayout, DoseModel, Facts, PatternLayout, Renewal, Run, Space, ZCoupling, elements_of,
    frames_of,
};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::units::concise;

/// See the [module page](self).
pub struct Printing {
    optics: Vec<Arc<Model>>,
    schedule: Schedule,
    material: Box<dyn Material>,
    blocks: Vec<Block>,
    patterns: Vec<PatternLayout>,
    outputs: Vec<DoseLayout>,
    /// Elements of each light in the pattern field.
    ranges: Vec<Range<usize>>,
}

impl Printing {
    /// A print of these lights, one dose model each, in blocks of at most `step_s` (None: as [`PrintRun`](crate::print::PrintRun) chooses).
    ///
    /// # Errors
    /// [`Error::Config`] where schedule, mixing matrix and lights do not fit, or the step is not stable; [`Error::Unsupported`] where voxels do not fit.
    pub fn new(
        optics: Vec<Box<Model>>,
        schedule: Schedule,
        material: Box<dyn Material>,
        step_s: Option<f64>,
    ) -> Result<Self> {
        let models: Vec<&Model> = optics.iter().map(AsRef::as_ref).collect();
        must_fit(material.as_ref(), &schedule, &models)?;
        let step_s = step_s.unwrap_or_else(|| default_step_s(material.as_ref(), &schedule));
        check_step(material.as_ref(), step_s)?;
        let blocks = if material.is_memoryless() {
            Vec::new()
        } else {
            schedule.blocks(step_s)?
        };
        let (mut patterns, mut ranges, mut offset) = (Vec::new(), Vec::new(), 0);
        for model in &optics {
            let len: usize = model.patterns().iter().map(PatternLayout::len).sum();
            for layout in model.patterns() {
                let mut layout = layout.clone();
                layout.offset += offset;
                layout.runs.iter_mut().for_each(|run| run.offset += offset);
                patterns.push(layout);
            }
            ranges.push(offset..offset + len);
            offset += len;
        }
        let layout = material.domain().layout();
        let species = material.species();
        let output = |(s, name): (usize, &String)| {
            DoseLayout::new(name, layout.grid.clone(), s * layout.len())
        };
        Ok(Printing {
            outputs: species.iter().enumerate().map(output).collect(),
            optics: optics.into_iter().map(Arc::from).collect(),
            schedule,
            material,
            blocks,
            patterns,
            ranges,
        })
    }

    /// The material.
    #[must_use]
    pub fn material(&self) -> &dyn Material {
        self.material.as_ref()
    }

    /// The schedule.
    #[must_use]
    pub fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    /// The dose model of a light.
    #[must_use]
    pub fn light(&self, light: usize) -> &Model {
        self.optics[light].as_ref()
    }

    /// The patterns of a light, as a field of its own dose model.
    fn of_light(&self, light: usize, x: &HostField) -> HostField {
        HostField::from_slice(&x.as_slice()[self.ranges[light].clone()])
    }

    fn of_lights(&self, x: &HostField) -> Vec<HostField> {
        (0..self.optics.len())
            .map(|l| self.of_light(l, x))
            .collect()
    }

    /// Whether the dose model of the only light is all there is.
    fn is_plain(&self) -> bool {
        let drives = self.material.drives();
        let energies = || self.schedule.energies(0);
        self.material.is_memoryless()
            && drives.species() == 1
            && drives.lights() == 1
            && drives.only(0) == Some(0)
            && self.material.readout(0).scale == 1.0
            && energies().iter().all(|&e| e as f32 == 1.0)
    }

    /// Values of a light times the factor of all energy of their frames.
    fn scale_by_energy(&self, light: usize, x: &mut HostField) {
        for (frame, energy) in self.schedule.energies(light).into_iter().enumerate() {
            for (range, quantity) in elements_of(self.light(light).patterns(), &(frame..frame + 1))
            {
                let factor = factor(quantity, energy);
                x.as_mut_slice()[range]
                    .iter_mut()
                    .for_each(|v| *v *= factor);
            }
        }
    }

    /// dose += what the dose of a light is worth to every network, without memory.
    fn mix(&self, light: usize, of_light: &HostField, dose: &mut HostField) {
        for (s, output) in self.outputs.iter().enumerate() {
            let weight = self.material.drives().row(s)[light] * self.material.readout(s).scale;
            let mut own = HostField::from_slice(&dose.as_slice()[output.range()]);
            add_mixed(&[weight], &[&of_light.as_slice()[..output.len()]], &mut own);
            dose.as_mut_slice()[output.range()].copy_from_slice(own.as_slice());
        }
    }

    /// The transpose of [`mix`](Self::mix) over all networks.
    fn unmix(&self, light: usize, cotangent: &HostField, of_light: &mut HostField) {
        of_light.fill(0.0);
        for (s, output) in self.outputs.iter().enumerate() {
            let weight = self.material.drives().row(s)[light] * self.material.readout(s).scale;
            add_mixed(
                &[weight],
                &[&cotangent.as_slice()[output.range()]],
                of_light,
            );
        }
    }

    /// One step; the energy of each light is left in `light`.
    fn step(
        &self,
        block: &Block,
        x: &[HostField],
        light: &mut [Illumination],
        state: &mut State,
        run: &Run,
    ) -> Result<()> {
        run.check()?;
        for (l, (light, x)) in light.iter_mut().zip(x).enumerate() {
            light.absorb(self.light(l), x, &block.lit[l], run)?;
        }
        let absorbed: Vec<&[f32]> = light.iter().map(Illumination::absorbed).collect();
        self.material.step(state, &absorbed, block.seconds)
    }

    fn illuminations(&self) -> Result<Vec<Illumination>> {
        self.optics
            .iter()
            .map(|m| Illumination::new(m.as_ref()))
            .collect()
    }

    /// What is read out of a state.
    fn read(&self, state: &State, dose: &mut HostField) {
        for (s, output) in self.outputs.iter().enumerate() {
            let readout = self.material.readout(s);
            let values = state.volumes[readout.volume].as_slice();
            let to = &mut dose.as_mut_slice()[output.range()];
            to.iter_mut()
                .zip(values)
                .for_each(|(to, v)| *to = readout.scale * v);
        }
    }

    /// The transpose of [`read`](Self::read).
    fn unread(&self, state: &State, cotangent: &HostField) -> State {
        let mut back = state.zeros_like();
        for (s, output) in self.outputs.iter().enumerate() {
            let readout = self.material.readout(s);
            let to = back.volumes[readout.volume].as_mut_slice().iter_mut();
            let from = &cotangent.as_slice()[output.range()];
            to.zip(from).for_each(|(to, c)| *to += readout.scale * c);
        }
        back
    }

    /// The gradient of some frames, counted through all lights.
    fn pull_through_time(
        &self,
        frames: &Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        let x = self.of_lights(x);
        let mut work = Work {
            light: self.illuminations()?,
            of_energy: (self.optics.iter().map(|model| model.new_dose())).collect::<Result<_>>()?,
            wanted: self.own_frames(frames),
        };
        let stride = (self.blocks.len() as f64).sqrt().ceil().max(1.0) as usize;
        let mut state = self.material.start()?;
        let mut kept = Vec::new();
        for (i, block) in self.blocks.iter().enumerate() {
            if i % stride == 0 {
                kept.push(state.clone());
            }
            self.step(block, &x, &mut work.light, &mut state, run)?;
        }
        for (range, _) in elements_of(&self.patterns, frames) {
            grad.as_mut_slice()[range].fill(0.0);
        }
        let mut back = self.unread(&state, cotangent);
        for (segment, mut state) in kept.into_iter().enumerate().rev() {
            let blocks = &self.blocks[segment * stride..];
            let blocks = &blocks[..stride.min(blocks.len())];
            let mut states = Vec::new();
            for block in blocks {
                let before = state.clone();
                self.step(block, &x, &mut work.light, &mut state, run)?;
                let lights = work.light.iter();
                let absorbed = lights.map(|l| l.absorbed().to_vec()).collect::<Vec<_>>();
                states.push((before, absorbed));
            }
            while let Some((before, absorbed)) = states.pop() {
                let block = &blocks[states.len()];
                let before = (&before, &absorbed[..]);
                self.pull_step(block, &x, before, &mut work, (&mut back, grad), run)?;
            }
        }
        Ok(())
    }

    /// One step back: `back` from after it to before it, and what its light is worth added to `grad`.
    fn pull_step(
        &self,
        block: &Block,
        x: &[HostField],
        (before, absorbed): (&State, &[Vec<f32>]),
        work: &mut Work,
        (back, grad): (&mut State, &mut HostField),
        run: &Run,
    ) -> Result<()> {
        run.check()?;
        let views: Vec<&[f32]> = absorbed.iter().map(Vec::as_slice).collect();
        self.material
            .pullback_step(before, &views, block.seconds, back, &mut work.of_energy)?;
        for (l, light) in work.light.iter_mut().enumerate() {
            let own = &mut grad.as_mut_slice()[self.ranges[l].clone()];
            let lit = (block.lit[l].as_slice(), &work.wanted[l]);
            light.pull(self.light(l), &x[l], lit, (&work.of_energy[l], own), run)?;
        }
        Ok(())
    }

    /// Which of the frames of each light are among these of all lights.
    fn own_frames(&self, frames: &Range<usize>) -> Vec<Range<usize>> {
        let mut first = 0;
        let mut own = |model: &Model| {
            let end = first + frames_of(model.patterns());
            let own = frames.start.clamp(first, end) - first..frames.end.clamp(first, end) - first;
            first = end;
            own
        };
        self.optics.iter().map(|model| own(&**model)).collect()
    }

    /// The gradient of some frames where the material has no memory.
    fn pull_at_once(
        &self,
        frames: &Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        for (light, frames) in self.own_frames(frames).into_iter().enumerate() {
            if frames.is_empty() {
                continue;
            }
            let model = self.light(light);
            let mut own = self.of_light(light, x);
            self.scale_by_energy(light, &mut own);
            let mut of_light = model.new_dose()?;
            self.unmix(light, cotangent, &mut of_light);
            let mut back = model.new_patterns()?;
            model.pullback_of(frames.clone(), &own, &of_light, &mut back, &run.aside())?;
            self.scale_by_energy(light, &mut back);
            let grad = &mut grad.as_mut_slice()[self.ranges[light].clone()];
            for (range, _) in elements_of(model.patterns(), &frames) {
                grad[range.clone()].copy_from_slice(&back.as_slice()[range]);
            }
        }
        Ok(())
    }
}

/// What the way back through time needs, made once.
struct Work {
    light: Vec<Illumination>,
    of_energy: Vec<HostField>,
    /// Frames of each light whose gradient the caller wants.
    wanted: Vec<Range<usize>>,
}

impl Renewal<HostField> for Printing {
    fn renew(&self, iteration: usize, x: &HostField, run: &Run) -> Result<bool> {
        let mut any = false;
        for (light, model) in self.optics.iter().enumerate() {
            if let Some(model) = model.renewal() {
                any |= model.renew(iteration, &self.of_light(light, x), run)?;
            }
        }
        Ok(any)
    }
}

impl DoseModel for Printing {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: &self.outputs,
            z_coupling: if self.material.is_memoryless() {
                ZCoupling::widest(self.optics.iter().map(|model| model.z_coupling()))
            } else {
                ZCoupling::Full
            },
            is_linear: self.material.is_memoryless()
                && self.optics.iter().all(|model| model.is_linear()),
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, run: &Run) -> Result<()> {
        if self.is_plain() {
            return self.optics[0].dose(x, dose, run);
        }
        if self.material.is_memoryless() {
            dose.fill(0.0);
            for light in 0..self.optics.len() {
                let mut own = self.of_light(light, x);
                self.scale_by_energy(light, &mut own);
                let mut of_light = self.light(light).new_dose()?;
                self.light(light).dose(&own, &mut of_light, &run.aside())?;
                self.mix(light, &of_light, dose);
            }
            return Ok(());
        }
        let x = self.of_lights(x);
        let mut light = self.illuminations()?;
        let mut state = self.material.start()?;
        let steps = run.steps(self.blocks.len());
        for block in &self.blocks {
            self.step(block, &x, &mut light, &mut state, run)?;
            steps.add(1);
        }
        self.read(&state, dose);
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        if self.is_plain() {
            return self.optics[0].pullback_of(frames, x, cotangent, grad, run);
        }
        if self.material.is_memoryless() {
            self.pull_at_once(&frames, x, cotangent, grad, run)
        } else {
            self.pull_through_time(&frames, x, cotangent, grad, run)
        }
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        if !self.material.is_memoryless() {
            return Err(Error::unsupported(
                "the dose of some frames",
                "what a frame does to this material depends on the frames before it",
            ));
        }
        if self.is_plain() {
            return self.optics[0].dose_of(frames, x, dose, run);
        }
        for (light, range) in self.own_frames(&frames).into_iter().enumerate() {
            if range.is_empty() {
                continue;
            }
            let mut x = self.of_light(light, x);
            self.scale_by_energy(light, &mut x);
            let mut of_light = self.light(light).new_dose()?;
            self.light(light)
                .dose_of(range, &x, &mut of_light, &run.aside())?;
            self.mix(light, &of_light, dose);
        }
        Ok(())
    }

    fn along(&self, x: &HostField, d: &HostField, run: &Run) -> Result<Option<Vec<HostField>>> {
        if !self.material.is_memoryless() {
            return Ok(None);
        }
        if self.is_plain() {
            return self.optics[0].along(x, d, run);
        }
        let mut terms: Vec<HostField> = Vec::new();
        for light in 0..self.optics.len() {
            let [mut x, mut d] = [x, d].map(|v| self.of_light(light, v));
            self.scale_by_energy(light, &mut x);
            self.scale_by_energy(light, &mut d);
            let Some(own) = self.light(light).along(&x, &d, &run.aside())? else {
                return Ok(None);
            };
            for (i, term) in own.iter().enumerate() {
                if terms.len() == i {
                    terms.push(self.new_dose()?);
                }
                self.mix(light, term, &mut terms[i]);
            }
        }
        Ok(Some(terms))
    }

    fn of_light(&self, i: usize) -> Option<Arc<Model>> {
        self.optics.get(i).cloned()
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        let renewed = self.optics.iter().any(|model| model.renewal().is_some());
        renewed.then_some(self as _)
    }

    fn updates(&self) -> u64 {
        let of_light = |l: usize| {
            let updates = self.light(l).updates();
            if self.material.is_memoryless() {
                return updates;
            }
            let shown: usize = self.blocks.iter().map(|b| b.lit[l].len()).sum();
            updates * shown as u64 / self.schedule.frames()[l].max(1) as u64
        };
        (0..self.optics.len()).map(of_light).sum()
    }

    fn describe(&self) -> String {
        let lights: Vec<String> = self.optics.iter().map(|m| m.describe()).collect();
        let lights = lights.join(" + ");
        if self.material.is_memoryless() {
            return lights;
        }
        let blocks = self.blocks.len();
        format!(
            "{lights}, printed in {} s and {blocks} steps",
            concise(self.schedule.end_s())
        )
    }
}

#[cfg(test)]
mod tests;
