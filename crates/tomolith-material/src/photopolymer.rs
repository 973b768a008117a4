//! A photopolymer: networks that cure after inhibitors are used up, while what is mobile diffuses.
//!
//! # Model
//! Per network, in each block of time: the drive of the lights → bleaching of the initiator → inhibitors, one after the other → dose, or conversion by a
//! rate law. Inhibitors (and the dose, with `dose_diffusion_mm2_per_s`) diffuse. Equations, units and sources: `docs/material.md`; Wang et al. 2022, Note 4 and Fig. S12.
//!
//! # Limits
//! Heat, shrinkage and sedimentation are not modeled. An antagonist
//! (negative drive) makes inhibitor, of the network's first; without one it does nothing.
//!
//! # Cost
//! State: a volume per inhibitor and network, one or two more with bleaching. A step reads and writes each once; diffusion by faces once more.

mod params;

use crate::diffusion::faces::{self, longest_step_s};
use crate::diffusion::{
    Scheme,
    spectral::{Modes, Spectral},
};
use crate::domain::Domain;
use crate::mixing::Mixing;
use crate::print::exceeded_limit_s;
use crate::reaction::{Stage, smooth_step};
use crate::{Absorption, Readout, Requirement, State};
pub use params::{Curing, Inhibitor, Initial, Network, Params, Shading, at_height};
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::Volume;
use tomolith_core::parallel::{InParallel, elements, table};
use tomolith_core::units::exact;

/// Voxels that a thread takes through all stages at a time: they stay in the second cache.
const CHUNK: usize = 4096;

/// Share of a step that is rounding of the times that cut it.
const ROUNDING: f64 = 1e-6;

/// A volume of the state.
#[derive(Clone, Debug)]
struct Slot {
    name: String,
    /// mm²/s
    diffusion: f64,
    /// Share of it that cured resin has.
    cured_diffusion: f64,
    from_air: bool,
}

/// The slots and stages of a network.
struct Chain {
    slots: Range<usize>,
    /// Places count from the first slot.
    stages: Vec<Stage>,
    /// Slot of dose or conversion.
    cure: usize,
    /// Degree of cure per unit of it.
    per_gel: f32,
    /// Slots of the initiator now, and as the light was computed.
    initiator: Option<[usize; 2]>,
}

/// See the [module page](self).
pub struct Photopolymer {
    params: Params,
    mixing: Mixing,
    domain: Domain,
    slots: Vec<Slot>,
    chains: Vec<Chain>,
    spectral: Option<Spectral>,
    spare: Mutex<Vec<HostField>>,
}

impl Photopolymer {
    /// A material of these parameters on these voxels.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of the first parameter that cannot be used; the spectral scheme is refused at `diffusion` with walls, air, or a D
    /// that changes.
    pub fn new(params: Params, mixing: Mixing, domain: Domain) -> Result<Self> {
        params.validate(&mixing)?;
        let mut slots = Vec::new();
        let chains = params.networks.iter();
        let chains: Vec<Chain> = chains.map(|n| chain_of(n, &mut slots)).collect();
        let mut material = Photopolymer {
            mixing,
            domain,
            slots,
            chains,
            spectral: None,
            spare: Mutex::default(),
            params,
        };
        if material.params.diffusion == Scheme::Spectral && material.moves() {
            material.check_spectral()?;
            material.spectral = Some(Spectral::new(material.domain.layout()));
        }
        Ok(material)
    }

    /// Its parameters.
    #[must_use]
    pub fn params(&self) -> &Params {
        &self.params
    }

    /// Whether anything diffuses.
    fn moves(&self) -> bool {
        self.slots.iter().any(|slot| slot.diffusion > 0.0)
    }

    fn check_spectral(&self) -> Result<()> {
        let moving = || self.slots.iter().filter(|slot| slot.diffusion > 0.0);
        let reason = if self.domain.resin().is_some() {
            "walls within the box"
        } else if self.domain.has_air() && moving().any(|slot| slot.from_air) {
            "air on top"
        } else if moving().any(|slot| slot.cured_diffusion < 1.0) {
            "cured_diffusion below 1"
        } else {
            return Ok(());
        };
        Err(Error::config(
            "diffusion",
            format!("spectral, with {reason}"),
            "faces; cosine modes know an even D in a box without openings only",
        ))
    }

    fn borrow(&self) -> HostField {
        let mut spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner);
        spare.pop().unwrap_or_else(|| self.domain.zeros())
    }

    fn give_back(&self, field: HostField) {
        let mut spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner);
        spare.push(field);
    }

    /// What air holds a slot at.
    fn air_of(&self, slot: &Slot) -> Option<f32> {
        (self.domain.has_air() && slot.from_air).then_some(1.0)
    }

    fn chain_of(&self, slot: usize) -> usize {
        let within = |chain: &Chain| chain.slots.contains(&slot);
        self.chains.iter().position(within).unwrap_or_default()
    }

    /// Degree of cure less 1, per width: the argument of H.
    fn argument(&self, network: usize) -> impl Fn(f32) -> f32 + use<> {
        let per_gel = self.chains[network].per_gel;
        let width = self.params.networks[network].gel_width as f32;
        move |cure| {
            let beyond = cure * per_gel - 1.0;
            if width > 0.0 {
                beyond / width
            } else if beyond >= 0.0 {
                f32::INFINITY
            } else {
                f32::NEG_INFINITY
            }
        }
    }

    /// Share of D in every voxel, where it changes.
    fn share_of(&self, slot: usize, state: &State) -> Option<HostField> {
        let fall = (1.0 - self.slots[slot].cured_diffusion) as f32;
        if fall == 0.0 {
            return None;
        }
        let network = self.chain_of(slot);
        let argument = self.argument(network);
        let mut share = self.borrow();
        share.zip_blocks(&state.volumes[self.chains[network].cure], |_, cure| {
            1.0 - fall * smooth_step(argument(cure)).0
        });
        if let Some(resin) = self.domain.resin() {
            elements(share.as_mut_slice(), |i, v| *v *= resin[i]);
        }
        Some(share)
    }

    fn faces<'a>(
        &'a self,
        slot: usize,
        share: Option<&'a HostField>,
        seconds: f64,
    ) -> faces::Step<'a> {
        let species = &self.slots[slot];
        faces::Step::new(
            &self.domain,
            species.diffusion,
            seconds,
            share.map(HostField::as_slice),
            self.air_of(species),
        )
    }

    /// All that moves, by faces, each with the cure as it was before.
    fn diffuse(&self, state: &mut State, seconds: f64) {
        // The cure moves last: it tells the others their D
        let mut slots: Vec<usize> = (0..self.slots.len()).collect();
        slots.sort_by_key(|slot| self.chains.iter().any(|chain| chain.cure == *slot));
        for slot in slots {
            if self.slots[slot].diffusion > 0.0 {
                let share = self.share_of(slot, state);
                let mut next = self.borrow();
                let step = self.faces(slot, share.as_ref(), seconds);
                step.apply(&state.volumes[slot], &mut next);
                std::mem::swap(&mut state.volumes[slot], &mut next);
                self.give_back(next);
                share.into_iter().for_each(|share| self.give_back(share));
            }
        }
    }

    /// The transpose, at the state before.
    fn pull_diffuse(&self, before: &State, cotangent: &mut State, seconds: f64) {
        let mut of_cure: Vec<(usize, HostField)> = Vec::new();
        for slot in 0..self.slots.len() {
            if self.slots[slot].diffusion == 0.0 {
                continue;
            }
            let share = self.share_of(slot, before);
            let step = self.faces(slot, share.as_ref(), seconds);
            let mut next = self.borrow();
            if share.is_some() {
                let mut grad = self.borrow();
                step.pull_share(&before.volumes[slot], &cotangent.volumes[slot], &mut grad);
                self.share_to_cure(slot, before, &mut grad);
                of_cure.push((self.chains[self.chain_of(slot)].cure, grad));
            }
            step.transposed().apply(&cotangent.volumes[slot], &mut next);
            std::mem::swap(&mut cotangent.volumes[slot], &mut next);
            self.give_back(next);
            share.into_iter().for_each(|share| self.give_back(share));
        }
        for (cure, grad) in of_cure {
            cotangent.volumes[cure].axpy(1.0, &grad);
            self.give_back(grad);
        }
    }

    /// From what shares of D are worth to what the cure is worth.
    fn share_to_cure(&self, slot: usize, before: &State, grad: &mut HostField) {
        let fall = (1.0 - self.slots[slot].cured_diffusion) as f32;
        let network = self.chain_of(slot);
        let argument = self.argument(network);
        let width = self.params.networks[network].gel_width as f32;
        let per_unit = self.chains[network].per_gel / width.max(f32::MIN_POSITIVE);
        grad.zip_blocks(&before.volumes[self.chains[network].cure], |grad, cure| {
            let slope = smooth_step(argument(cure)).1;
            if slope > 0.0 {
                -fall * slope * per_unit * grad
            } else {
                0.0
            }
        });
        self.domain.only_resin(grad);
    }

    /// All that moves, by modes.
    fn spread(&self, volumes: &mut [HostField], spectral: &Spectral, seconds: f64) {
        for (slot, volume) in self.slots.iter().zip(volumes) {
            if slot.diffusion > 0.0 {
                let modes = Modes::diffusion(spectral, slot.diffusion, seconds);
                spectral.multiply(volume.as_mut_slice(), &modes);
            }
        }
    }

    /// Light on all networks.
    fn react(&self, state: &mut State, absorbed: &[&[f32]], seconds: f64) {
        if absorbed.iter().all(|energy| energy.is_empty()) {
            return;
        }
        for (s, chain) in self.chains.iter().enumerate() {
            let chunks = chunks_of(&mut state.volumes[chain.slots.clone()]);
            chunks.into_iter().enumerate().par_each_with(
                || vec![0.0; CHUNK],
                |u, (i, mut states)| {
                    let u = &mut u[..states[0].len()];
                    drive(self.mixing.row(s), absorbed, i * CHUNK, u);
                    for stage in &chain.stages {
                        stage.forward(&mut states, u, seconds as f32);
                    }
                },
            );
        }
    }

    /// The transpose, at the state before.
    fn pull_react(
        &self,
        before: &State,
        absorbed: &[&[f32]],
        seconds: f64,
        cotangent: &mut State,
        grad: &mut [HostField],
    ) {
        let seconds = seconds as f32;
        for (grad, energy) in grad.iter_mut().zip(absorbed) {
            if !energy.is_empty() {
                grad.fill(0.0);
            }
        }
        for (s, chain) in self.chains.iter().enumerate() {
            let row = self.mixing.row(s);
            let before = &before.volumes[chain.slots.clone()];
            let states = chunks_of(&mut cotangent.volumes[chain.slots.clone()]);
            let grads = chunks_of(grad);
            let both: Vec<_> = states.into_iter().zip(grads).collect();
            both.into_iter().enumerate().par_each_with(
                Desk::default,
                |desk, (i, (mut states, mut grads))| {
                    let from = i * CHUNK;
                    let mut u = vec![0.0; states[0].len()];
                    drive(row, absorbed, from, &mut u);
                    let du = desk.pull(chain, before, from, u, seconds, &mut states);
                    for ((grad, &weight), energy) in grads.iter_mut().zip(row).zip(absorbed) {
                        if weight != 0.0 && !energy.is_empty() {
                            let sums = grad.iter_mut().zip(du.iter());
                            sums.for_each(|(sum, du)| *sum += weight * du);
                        }
                    }
                },
            );
        }
    }

    fn check_step(&self, seconds: f64) -> Result<()> {
        match exceeded_limit_s(self, seconds * (1.0 - ROUNDING)) {
            None => Ok(()),
            Some(limit) => Err(Error::config(
                "step_s",
                format!("found {} s", exact(seconds)),
                format!(
                    "at most {limit} s, the stability limit of diffusion through voxel faces; or diffusion = \"spectral\""
                ),
            )),
        }
    }
}

/// u ← Σ_λ weight_λ·energy_λ of the voxels from `from` on.
fn drive(weights: &[f32], absorbed: &[&[f32]], from: usize, u: &mut [f32]) {
    u.fill(0.0);
    for (&weight, energy) in weights.iter().zip(absorbed) {
        if weight != 0.0 && !energy.is_empty() {
            let energy = &energy[from..from + u.len()];
            u.iter_mut().zip(energy).for_each(|(u, e)| *u += weight * e);
        }
    }
}

/// Chunks of volumes, all volumes of a chunk together.
fn chunks_of(volumes: &mut [HostField]) -> Vec<Vec<&mut [f32]>> {
    let count = volumes.first().map_or(0, |v| v.len().div_ceil(CHUNK));
    let mut chunks: Vec<Vec<&mut [f32]>> = (0..count).map(|_| Vec::new()).collect();
    for volume in volumes {
        let parts = volume.as_mut_slice().chunks_mut(CHUNK);
        chunks
            .iter_mut()
            .zip(parts)
            .for_each(|(all, part)| all.push(part));
    }
    chunks
}

/// Working memory of the transposed stages.
#[derive(Default)]
struct Desk {
    /// States and drive before each stage.
    states: Vec<Vec<Vec<f32>>>,
    drives: Vec<Vec<f32>>,
    du: Vec<f32>,
}

impl Desk {
    /// Cotangents of a chunk that begins at voxel `from` and has the drive `u`, from after the stages to before them; returns that of the drive.
    fn pull(
        &mut self,
        chain: &Chain,
        before: &[HostField],
        from: usize,
        mut u: Vec<f32>,
        seconds: f32,
        cotangent: &mut [&mut [f32]],
    ) -> &[f32] {
        let mut states: Vec<Vec<f32>> = before
            .iter()
            .map(|v| v.as_slice()[from..from + u.len()].to_vec())
            .collect();
        self.states.clear();
        self.drives.clear();
        for stage in &chain.stages {
            self.states.push(states.clone());
            self.drives.push(u.clone());
            let mut views: Vec<&mut [f32]> = states.iter_mut().map(Vec::as_mut_slice).collect();
            stage.forward(&mut views, &mut u, seconds);
        }
        self.du.clear();
        self.du.resize(u.len(), 0.0);
        for (i, stage) in chain.stages.iter().enumerate().rev() {
            let views: Vec<&[f32]> = self.states[i].iter().map(Vec::as_slice).collect();
            stage.pullback(&views, &self.drives[i], cotangent, &mut self.du, seconds);
        }
        &self.du
    }
}

fn chain_of(network: &Network, slots: &mut Vec<Slot>) -> Chain {
    let first = slots.len();
    let mut stages = Vec::new();
    let still = |name: String| Slot {
        name,
        diffusion: 0.0,
        cured_diffusion: 1.0,
        from_air: false,
    };
    let mut initiator = None;
    if network.bleaching_mm3_per_mj > 0.0 {
        slots.push(still(format!("{}.initiator", network.name)));
        slots.push(still(format!("{}.initiator_in_light", network.name)));
        stages.push(Stage::Bleach {
            share: 0,
            lit: 1,
            rate: network.bleaching_mm3_per_mj as f32,
        });
        initiator = Some([first, first + 1]);
    }
    for inhibitor in &network.inhibitors {
        let at = slots.len() - first;
        let capacity = inhibitor.capacity_mj_per_mm3 as f32;
        stages.push(match inhibitor.half_saturation {
            None => Stage::Inhibit { at, capacity },
            Some(half) => Stage::InhibitSmoothly {
                at,
                capacity,
                half: half as f32,
            },
        });
        slots.push(Slot {
            name: format!("{}.{}", network.name, inhibitor.name),
            diffusion: inhibitor.diffusion_mm2_per_s,
            cured_diffusion: inhibitor.cured_diffusion,
            from_air: inhibitor.from_air,
        });
    }
    let cure = slots.len();
    let at = cure - first;
    let (name, gel) = match network.curing {
        Curing::Threshold {
            critical_dose_mj_per_mm3,
        } => {
            stages.push(Stage::Dose { at });
            ("dose", critical_dose_mj_per_mm3)
        }
        Curing::RateLaw {
            rate_per_s,
            exponent,
            gel_conversion,
        } => {
            stages.push(Stage::Rate {
                at,
                rate: rate_per_s as f32,
                exponent: exponent as f32,
            });
            ("conversion", gel_conversion)
        }
    };
    slots.push(Slot {
        diffusion: network.dose_diffusion_mm2_per_s,
        ..still(format!("{}.{name}", network.name))
    });
    Chain {
        slots: first..slots.len(),
        stages,
        cure,
        per_gel: (1.0 / gel) as f32,
        initiator,
    }
}

/// What the print asks of it.
///
/// Energies that a block of frames leaves are slices in the order of the domain's layout, mJ/mm³, one per light; an empty slice is a light that is dark.
impl Photopolymer {
    /// Which light drives which network, and how strongly.
    #[must_use]
    pub fn drives(&self) -> &Mixing {
        &self.mixing
    }

    /// The voxels.
    #[must_use]
    pub fn domain(&self) -> &Domain {
        &self.domain
    }

    /// Names of the networks, one per row of [`drives`](Self::drives).
    #[must_use]
    pub fn species(&self) -> Vec<String> {
        self.params
            .networks
            .iter()
            .map(|n| n.name.clone())
            .collect()
    }

    /// Names of the volumes of a state.
    #[must_use]
    pub fn volumes(&self) -> Vec<String> {
        self.slots.iter().map(|slot| slot.name.clone()).collect()
    }

    /// The state before the first frame.
    ///
    /// # Errors
    /// When there is not enough memory.
    pub fn start(&self) -> Result<State> {
        let mut volumes = Vec::with_capacity(self.slots.len());
        for (network, chain) in self.params.networks.iter().zip(&self.chains) {
            if chain.initiator.is_some() {
                volumes.extend([self.domain.even(1.0), self.domain.even(1.0)]);
            }
            for inhibitor in &network.inhibitors {
                volumes.push(self.domain.filled(|z| inhibitor.initial.at(z) as f32));
            }
            volumes.push(self.domain.zeros());
        }
        Ok(State {
            seconds: 0.0,
            volumes,
        })
    }

    /// What a block of time makes of the state, in which lights leave these energies, evenly over `seconds`.
    ///
    /// # Errors
    /// [`Error::Config`] at `step_s` for a step above [`longest_step_s`](Self::longest_step_s).
    pub fn step(&self, state: &mut State, absorbed: &[&[f32]], seconds: f64) -> Result<()> {
        match &self.spectral {
            Some(spectral) => {
                self.spread(&mut state.volumes, spectral, seconds / 2.0);
                self.react(state, absorbed, seconds);
                self.spread(&mut state.volumes, spectral, seconds / 2.0);
            }
            None => {
                self.check_step(seconds)?;
                self.diffuse(state, seconds);
                self.react(state, absorbed, seconds);
            }
        }
        state.seconds += seconds;
        Ok(())
    }

    /// The transpose of the step's derivative, at the state before the step: the cotangent goes from after the step to before it, and `grad` of
    /// each light that is not dark is overwritten.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn pullback_step(
        &self,
        before: &State,
        absorbed: &[&[f32]],
        seconds: f64,
        cotangent: &mut State,
        grad: &mut [HostField],
    ) -> Result<()> {
        let mut middle = before.clone();
        match &self.spectral {
            Some(spectral) => {
                self.spread(&mut cotangent.volumes, spectral, seconds / 2.0);
                self.spread(&mut middle.volumes, spectral, seconds / 2.0);
                self.pull_react(&middle, absorbed, seconds, cotangent, grad);
                self.spread(&mut cotangent.volumes, spectral, seconds / 2.0);
            }
            None => {
                self.check_step(seconds)?;
                self.diffuse(&mut middle, seconds);
                self.pull_react(&middle, absorbed, seconds, cotangent, grad);
                self.pull_diffuse(before, cotangent, seconds);
            }
        }
        cotangent.seconds = before.seconds;
        Ok(())
    }

    /// What is looked at, per network.
    #[must_use]
    pub fn readout(&self, species: usize) -> Readout {
        let chain = &self.chains[species];
        Readout {
            volume: chain.cure,
            scale: chain.per_gel,
            gel: 1.0,
        }
    }

    /// The longest step that is stable, s.
    #[must_use]
    pub fn longest_step_s(&self) -> f64 {
        if self.params.diffusion == Scheme::Spectral {
            return f64::INFINITY;
        }
        let moving = self.slots.iter().filter(|slot| slot.diffusion > 0.0);
        let limit =
            |slot: &Slot| longest_step_s(&self.domain, slot.diffusion, self.air_of(slot).is_some());
        moving.map(limit).fold(f64::INFINITY, f64::min)
    }

    /// The dose that gels; None where it depends on the power.
    #[must_use]
    pub fn requirement(&self, species: usize) -> Option<Requirement> {
        let network = &self.params.networks[species];
        let dose = match network.curing {
            Curing::Threshold {
                critical_dose_mj_per_mm3,
            } => critical_dose_mj_per_mm3,
            // Of first order, ln(1/(1 − C)) = kE
            Curing::RateLaw {
                rate_per_s,
                exponent: 1.0,
                gel_conversion,
            } => -(-gel_conversion).ln_1p() / rate_per_s,
            Curing::RateLaw { .. } => return None,
        };
        let first = self.chains[species].cure - network.inhibitors.len();
        let inhibitors = network.inhibitors.iter().enumerate();
        Some(Requirement {
            dose,
            inhibitors: inhibitors
                .map(|(i, inhibitor)| (first + i, inhibitor.capacity_mj_per_mm3))
                .collect(),
        })
    }

    /// How a light is absorbed now; None where that never changes.
    #[must_use]
    pub fn absorption(&self, state: &State, light: usize) -> Option<Absorption> {
        let shading = self.params.shading.iter().find(|s| s.light == light)?;
        let chain = &self.chains[shading.network];
        let argument = self.argument(shading.network);
        let layout = self.domain.layout();
        let cure = layout.volume_of(state.volumes[chain.cure].as_slice());
        let initiator = chain
            .initiator
            .map(|[now, _]| layout.volume_of(state.volumes[now].as_slice()));
        let [active, total] =
            [shading.active_per_mm, shading.attenuation_per_mm].map(|ends| ends.map(|v| v as f32));
        let of_voxel = |i: usize| {
            let h = smooth_step(argument(cure.values[i])).0;
            let between = |[before, after]: [f32; 2]| before + (after - before) * h;
            let (unbleached, total) = (between(active), between(total));
            let left = initiator.as_ref().map_or(1.0, |p| p.values[i]);
            let active = unbleached * left;
            (active, (total - unbleached + active).max(active))
        };
        let voxels = table(cure.values.len(), of_voxel);
        let (active, total): (Vec<f32>, Vec<f32>) = voxels.into_iter().unzip();
        let volume = |values| Volume::new(layout.grid.clone(), values);
        Some(Absorption {
            active_per_mm: volume(active),
            attenuation_per_mm: volume(total),
        })
    }

    /// The dose model of a light was made anew from [`absorption`](Self::absorption).
    pub fn light_was_renewed(&self, state: &mut State, light: usize) {
        let shading = self.params.shading.iter().find(|s| s.light == light);
        let chain = shading.map(|s| &self.chains[s.network]);
        if let Some([now, lit]) = chain.and_then(|chain| chain.initiator) {
            let (first, second) = state.volumes.split_at_mut(lit);
            second[0].copy_from(&first[now]);
        }
    }
}

#[cfg(test)]
mod tests;
