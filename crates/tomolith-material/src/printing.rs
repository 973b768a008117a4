//! A whole print as a dose model: patterns → what the material reads out at the end of the schedule.
//!
//! **Equation** s_{i+1} = step(s_i, A_i(x)), A_i the energy of block i; output = readout of s_n. The pullback is the chain rule backward in time: states are kept
//! every √n blocks and computed anew between.
//!
//! **Linear?** No; `along` is None, and `dose_of` is refused.
//!
//! **Limits** Absorption stays as the models have it: shading is renewed between optimizations (see [`print`](crate::print)).
//!
//! **Cost** `dose`: one turn through the schedule. `pullback`: two of them, and one pullback of each block's frames. Memory of the pullback: about 2√n states and √n volumes of energy per light.

use crate::illumination::Illumination;
use crate::lights::Lights;
use crate::photopolymer::Photopolymer;
use crate::print::{check_step, default_step_s};
use crate::schedule::{Block, Schedule};
use crate::{Model, State};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::{DoseModel, Facts, Renewal, Space, Work, elements_of};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::units::concise;

/// See the [module page](self).
pub struct Printing {
    lights: Lights,
    material: Photopolymer,
    blocks: Vec<Block>,
}

impl Printing {
    /// A print of these lights, one dose model each, in blocks of at most `step_s` (None: as [`PrintRun`](crate::print::PrintRun) chooses).
    ///
    /// # Errors
    /// [`Error::Config`] where schedule, mixing matrix and lights do not fit, or the step is not stable; [`Error::Unsupported`] where voxels do not fit.
    pub fn new(
        optics: Vec<Box<Model>>,
        schedule: Schedule,
        material: Photopolymer,
        step_s: Option<f64>,
    ) -> Result<Self> {
        let lights = Lights::new(optics, schedule, &material)?;
        let schedule = &lights.schedule;
        let step_s = step_s.unwrap_or_else(|| default_step_s(&material, schedule));
        check_step(&material, step_s)?;
        Ok(Printing {
            blocks: schedule.blocks(step_s)?,
            lights,
            material,
        })
    }

    fn of_lights(&self, x: &HostField) -> Vec<HostField> {
        (0..self.lights.optics.len())
            .map(|l| self.lights.of_light(l, x))
            .collect()
    }

    /// One step; the energy of each light is left in `light`.
    fn step(
        &self,
        block: &Block,
        x: &[HostField],
        light: &mut [Illumination],
        state: &mut State,
        work: &Work,
    ) -> Result<()> {
        work.check()?;
        for (l, (light, x)) in light.iter_mut().zip(x).enumerate() {
            light.absorb(self.lights.light(l), x, &block.lit[l], work)?;
        }
        let absorbed: Vec<&[f32]> = light.iter().map(Illumination::absorbed).collect();
        self.material.step(state, &absorbed, block.seconds)
    }

    fn illuminations(&self) -> Result<Vec<Illumination>> {
        self.lights
            .optics
            .iter()
            .map(|m| Illumination::new(m.as_ref()))
            .collect()
    }

    /// What is read out of a state.
    fn read(&self, state: &State, dose: &mut HostField) {
        for (s, output) in self.lights.outputs.iter().enumerate() {
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
        for (s, output) in self.lights.outputs.iter().enumerate() {
            let readout = self.material.readout(s);
            let to = back.volumes[readout.volume].as_mut_slice().iter_mut();
            let from = &cotangent.as_slice()[output.range()];
            to.zip(from).for_each(|(to, c)| *to += readout.scale * c);
        }
        back
    }

    /// One step back: the cotangent from after it to before it, and what its light is worth added to `grad`.
    fn pull_step(
        &self,
        block: &Block,
        before: &State,
        absorbed: &[Vec<f32>],
        scratch: &mut Scratch,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        work.check()?;
        let Scratch {
            x,
            light,
            back,
            of_energy,
        } = scratch;
        let views: Vec<&[f32]> = absorbed.iter().map(Vec::as_slice).collect();
        self.material
            .pullback_step(before, &views, block.seconds, back, of_energy)?;
        for (l, light) in light.iter_mut().enumerate() {
            let light_grad = &mut grad.as_mut_slice()[self.lights.ranges[l].clone()];
            let model = self.lights.light(l);
            light.pull(model, &x[l], &block.lit[l], &of_energy[l], light_grad, work)?;
        }
        Ok(())
    }
}

/// What the way back through time needs, made once.
struct Scratch {
    /// Patterns of each light.
    x: Vec<HostField>,
    light: Vec<Illumination>,
    /// Cotangent of the state.
    back: State,
    of_energy: Vec<HostField>,
}

impl Renewal<HostField> for Printing {
    fn renew(&self, iteration: usize, x: &HostField, work: &Work) -> Result<bool> {
        let mut any = false;
        for (light, model) in self.lights.optics.iter().enumerate() {
            if let Some(model) = model.renewal() {
                any |= model.renew(iteration, &self.lights.of_light(light, x), work)?;
            }
        }
        Ok(any)
    }
}

impl DoseModel for Printing {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        self.lights.facts()
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, work: &Work) -> Result<()> {
        let x = self.of_lights(x);
        let mut light = self.illuminations()?;
        let mut state = self.material.start()?;
        let steps = work.steps(self.blocks.len());
        for block in &self.blocks {
            self.step(block, &x, &mut light, &mut state, work)?;
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
        work: &Work,
    ) -> Result<()> {
        let x = self.of_lights(x);
        let light = self.illuminations()?.into_iter();
        let light = light.zip(self.lights.own_frames(&frames));
        let mut light: Vec<_> = light
            .map(|(light, frames)| light.with_wanted(frames))
            .collect();
        let stride = (self.blocks.len() as f64).sqrt().ceil().max(1.0) as usize;
        let mut state = self.material.start()?;
        let mut checkpoints = Vec::new();
        for (i, block) in self.blocks.iter().enumerate() {
            if i % stride == 0 {
                checkpoints.push(state.clone());
            }
            self.step(block, &x, &mut light, &mut state, work)?;
        }
        for (range, _) in elements_of(&self.lights.patterns, &frames) {
            grad.as_mut_slice()[range].fill(0.0);
        }
        let of_energy = self.lights.optics.iter().map(|model| model.new_dose());
        let mut scratch = Scratch {
            x,
            light,
            back: self.unread(&state, cotangent),
            of_energy: of_energy.collect::<Result<_>>()?,
        };
        for (segment, mut state) in checkpoints.into_iter().enumerate().rev() {
            let blocks = &self.blocks[segment * stride..];
            let blocks = &blocks[..stride.min(blocks.len())];
            let mut states = Vec::new();
            for block in blocks {
                let before = state.clone();
                self.step(block, &scratch.x, &mut scratch.light, &mut state, work)?;
                let lights = scratch.light.iter();
                let absorbed = lights.map(|l| l.absorbed().to_vec()).collect::<Vec<_>>();
                states.push((before, absorbed));
            }
            while let Some((before, absorbed)) = states.pop() {
                let block = &blocks[states.len()];
                self.pull_step(block, &before, &absorbed, &mut scratch, grad, work)?;
            }
        }
        Ok(())
    }

    fn dose_of(&self, _: Range<usize>, _: &HostField, _: &mut HostField, _: &Work) -> Result<()> {
        Err(Error::unsupported(
            "the dose of some frames",
            "what a frame does to this material depends on the frames before it",
        ))
    }

    fn of_light(&self, i: usize) -> Option<Arc<Model>> {
        self.lights.optics.get(i).cloned()
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        let renewed = self
            .lights
            .optics
            .iter()
            .any(|model| model.renewal().is_some());
        renewed.then_some(self as _)
    }

    fn updates(&self) -> u64 {
        let of_light = |l: usize| {
            let updates = self.lights.light(l).updates();
            let shown: usize = self.blocks.iter().map(|b| b.lit[l].len()).sum();
            updates * shown as u64 / self.lights.schedule.frames()[l].max(1) as u64
        };
        (0..self.lights.optics.len()).map(of_light).sum()
    }

    fn describe(&self) -> String {
        let lights: Vec<String> = self.lights.optics.iter().map(|m| m.describe()).collect();
        let blocks = self.blocks.len();
        format!(
            "{}, printed in {} s and {blocks} steps",
            lights.join(" + "),
            concise(self.lights.schedule.end_s())
        )
    }
}

#[cfg(test)]
mod tests;
