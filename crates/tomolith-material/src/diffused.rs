//! A dose that diffuses while it is written, as a dose model: F followed by a multiplier per cosine mode.
//!
//! **Equation** dose = Σ_a K_a F_a(x), a: arcs of frames, each with the multiplier of the times at which it shines,
//!
//! ```text
//! K(k) = Σ_m w_m ⟨e^(−Dk²(T − t))⟩_m        mean over exposure m; even over T: (1 − e^(−Dk²T))/(Dk²T)
//! ```
//! with Σ w_m the energy of a frame over that of its light's frames on average (1 in whole turns; 4/3 and 2/3 after 1.5 turns),
//! and k the modes of a box with no flux through its walls ([`spectral`](crate::diffusion::spectral)). K is symmetric, so the derivative's transpose is
//! F′ᵀK. Linear where F is; a line polynomial of F stays one.
//!
//! **Source** the heat equation; the rotation sum is that of the published time-domain blur, in closed form (`docs/material.md`).
//!
//! **Limits** Walls are those of the box: cosine modes belong to it, and glass, bodies and inserts within it hold nothing back. Where an even dose ends at such
//! a wall it comes out as 1 − ½·[(1 + 2a²)·erfc(a) − (2a/√π)·e^(−a²)] of what it is, a = distance/(2√(DT)): 0.5 at the wall, 0.86 one √(DT) from it, 0.972
//! two and 0.996 three, where the explicit step between walls has 1 everywhere. Doses with surface-aware cells are refused.
//!
//! **Cost** one pair of cosine transforms per arc and call; a volume per arc and output. Frames are traced once, however many arcs.

use crate::diffusion::spectral::{Modes, Spectral};
use crate::illumination::must_show;
use crate::schedule::{Exposure, Schedule};
use std::ops::Range;
use tomolith_core::dose::{
    DoseModel, Facts, Renewal, Space, Work, ZCoupling, elements_of, frames_of,
};
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::field::{Field, HostField};
use tomolith_core::units::exact;

/// A span of even light, counted back from the end, s; its share of the energy of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// How long before the end it ends, s.
    pub before_s: f64,
    /// How long it takes, s; 0: a flash.
    pub seconds: f64,
    /// Share of the energy.
    pub share: f64,
}

/// Mean of e^(−rate·t) over these spans: what is left of a mode with rate = Dk², 1/s.
fn left_of(rate: f64, spans: &[Span]) -> f64 {
    let of_span = |span: &Span| {
        let x = rate * span.seconds;
        let mean = if x > 1e-12 { -(-x).exp_m1() / x } else { 1.0 };
        span.share * (-rate * span.before_s).exp() * mean
    };
    spans.iter().map(of_span).sum()
}

/// Neighboring frames with one multiplier.
struct Arc {
    frames: Range<usize>,
    /// One per output.
    modes: Vec<Modes>,
}

/// See the [module page](self).
pub struct Diffused<M: ?Sized> {
    arcs: Vec<Arc>,
    spectral: Vec<Spectral>,
    diffusion: f64,
    model: Box<M>,
}

impl<M: DoseModel<Field = HostField> + ?Sized> Diffused<M> {
    /// All lights of a schedule until its end, the frames of each in so many arcs; neighbors with the same times are one.
    ///
    /// # Errors
    /// As [`of_spans`](Self::of_spans); [`Error::Config`] where the schedule is of other frames, or shows some never.
    pub fn of_schedule(
        model: Box<M>,
        diffusion: f64,
        schedule: &Schedule,
        arcs: usize,
    ) -> Result<Self> {
        let of_lights = schedule.frames();
        must_show(frames_of(model.patterns()), 0, of_lights.iter().sum())?;
        let mut all: Vec<(Range<usize>, Vec<Span>)> = Vec::new();
        let mut first = 0;
        for (light, &frames) in of_lights.iter().enumerate() {
            let cuts = cuts(&schedule.energies(light), arcs);
            for cut in cuts.windows(2) {
                let spans = spans_of_frames(schedule, light, cut[0]..cut[1])?;
                match all.last_mut() {
                    Some((before, same)) if *same == spans => before.end = first + cut[1],
                    _ => all.push((first + cut[0]..first + cut[1], spans)),
                }
            }
            first += frames;
        }
        Self::of_spans(model, diffusion, &all)
    }

    /// Any spans of time for arcs of neighboring frames, which cover all frames.
    ///
    /// # Errors
    /// [`Error::Config`] for a diffusion coefficient (mm²/s) that is negative or not finite, and at `arcs` where frames are left out;
    /// [`Error::Unsupported`] for doses with cells.
    pub fn of_spans(
        model: Box<M>,
        diffusion: f64,
        arcs: &[(Range<usize>, Vec<Span>)],
    ) -> Result<Self> {
        in_range(
            diffusion >= 0.0 && diffusion.is_finite(),
            "diffusion_mm2_per_s",
            diffusion,
            "a finite number, 0 or more",
        )?;
        let ends: Vec<usize> = arcs.iter().map(|(frames, _)| frames.end).collect();
        let begins = arcs.iter().map(|(frames, _)| frames.start);
        if !begins.eq([0].into_iter().chain(ends.iter().copied()).take(arcs.len()))
            || ends.last() != Some(&frames_of(model.patterns()))
        {
            return Err(Error::config(
                "arcs",
                format!(
                    "frames {:?}",
                    arcs.iter().map(|(f, _)| f).collect::<Vec<_>>()
                ),
                format!(
                    "neighbors that cover frames 0 to {}",
                    frames_of(model.patterns())
                ),
            ));
        }
        if model.outputs().iter().any(|output| output.cells.is_some()) {
            return Err(Error::unsupported(
                "a dose with surface-aware cells",
                "dose diffuses between voxels, not between the halves of one",
            ));
        }
        let spectral: Vec<Spectral> = model.outputs().iter().map(Spectral::new).collect();
        let arc = |(frames, spans): &(Range<usize>, Vec<Span>)| Arc {
            frames: frames.clone(),
            modes: spectral
                .iter()
                .map(|s| Modes::of(s, |k2| left_of(diffusion * k2, spans)))
                .collect(),
        };
        Ok(Diffused {
            arcs: arcs.iter().map(arc).collect(),
            spectral,
            diffusion,
            model,
        })
    }

    fn multiply(&self, arc: &Arc, dose: &mut HostField) {
        let outputs = self.model.outputs().iter().zip(&self.spectral);
        for ((output, spectral), modes) in outputs.zip(&arc.modes) {
            spectral.multiply(&mut dose.as_mut_slice()[output.range()], modes);
        }
    }

    /// Arcs that have some of these frames, and which.
    fn arcs_of(&self, frames: &Range<usize>) -> impl Iterator<Item = (Range<usize>, &Arc)> {
        let Range { start, end } = *frames;
        let both = move |arc: &Arc| start.max(arc.frames.start)..end.min(arc.frames.end);
        let arcs = self.arcs.iter().map(move |arc| (both(arc), arc));
        arcs.filter(|(both, _)| !both.is_empty())
    }

    /// A field with the elements of some frames only.
    fn only(&self, frames: &Range<usize>, d: &HostField) -> HostField {
        let mut part = d.zeros_like();
        for (range, _) in elements_of(self.patterns(), frames) {
            part.as_mut_slice()[range.clone()].copy_from_slice(&d.as_slice()[range]);
        }
        part
    }
}

/// Where arcs of frames with these energies begin and end: so many of equal length, and wherever the energy changes, as it does within a broken turn.
fn cuts(energies: &[f64], arcs: usize) -> Vec<usize> {
    let frames = energies.len();
    let arcs = arcs.clamp(1, frames.max(1));
    let changes = |i: usize| {
        let [before, after] = [energies[i - 1], energies[i]];
        (before - after).abs() > 1e-9 * before.max(after)
    };
    let mut cuts: Vec<usize> = (0..=arcs).map(|i| i * frames / arcs).collect();
    cuts.extend((1..frames).filter(|i| changes(*i)));
    cuts.sort_unstable();
    cuts.dedup();
    cuts
}

/// When neighboring frames of a light shine, all with the same energy.
fn spans_of_frames(schedule: &Schedule, light: usize, frames: Range<usize>) -> Result<Vec<Span>> {
    let exposures = schedule.exposures().iter();
    let chosen: Vec<&Exposure> = exposures
        .filter(|e| e.light == light && frames.contains(&e.frame))
        .collect();
    if chosen.is_empty() {
        return Err(Error::config(
            format!("light[{light}].turns"),
            format!(
                "some of its frames are never shown, such as frame {}",
                frames.start
            ),
            "a schedule that shows every frame: at least one turn",
        ));
    }
    let energies = schedule.energies(light);
    let mean = |energies: &[f64]| energies.iter().sum::<f64>() / energies.len() as f64;
    let weight = mean(&energies[frames]) / mean(&energies);
    Ok(spans_of(&chosen, weight, schedule.end_s()))
}

/// Exposures as spans, whose shares are this weight together; those that follow one another with the same power are one.
fn spans_of(exposures: &[&Exposure], weight: f64, end_s: f64) -> Vec<Span> {
    let energy = |e: &Exposure| e.seconds * e.irradiance_mw_per_mm2;
    let whole: f64 = exposures.iter().map(|e| energy(e)).sum();
    let follows = |a: &&Exposure, b: &&Exposure| {
        (b.begin_s - a.begin_s - a.seconds).abs() < 1e-9 * (1.0 + end_s)
            && a.irradiance_mw_per_mm2 == b.irradiance_mw_per_mm2
    };
    let joined = exposures.chunk_by(follows).map(|group| {
        let last = group[group.len() - 1];
        let seconds = last.begin_s + last.seconds - group[0].begin_s;
        Span {
            before_s: (end_s - last.begin_s - last.seconds).max(0.0),
            seconds,
            share: weight * group.iter().map(|e| energy(e)).sum::<f64>() / whole,
        }
    });
    joined.collect()
}

impl<M: DoseModel<Field = HostField> + ?Sized> DoseModel for Diffused<M> {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            z_coupling: ZCoupling::Full,
            ..self.model.facts()
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        self.model.new_field(space)
    }

    fn updates(&self) -> u64 {
        self.model.updates()
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        self.model.renewal()
    }

    fn of_light(&self, i: usize) -> Option<std::sync::Arc<crate::Model>> {
        self.model.of_light(i)
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, work: &Work) -> Result<()> {
        if let [arc] = &self.arcs[..] {
            self.model.dose(x, dose, work)?;
            self.multiply(arc, dose);
            return Ok(());
        }
        dose.fill(0.0);
        self.dose_of(0..frames_of(self.patterns()), x, dose, work)
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let mut diffused = cotangent.zeros_like();
        for (both, arc) in self.arcs_of(&frames) {
            diffused.copy_from(cotangent);
            self.multiply(arc, &mut diffused);
            (self.model).pullback_of(both, x, &diffused, grad, &work.aside())?;
        }
        Ok(())
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let mut diffused = dose.zeros_like();
        for (both, arc) in self.arcs_of(&frames) {
            diffused.fill(0.0);
            self.model.dose_of(both, x, &mut diffused, &work.aside())?;
            self.multiply(arc, &mut diffused);
            dose.axpy(1.0, &diffused);
        }
        Ok(())
    }

    fn along(&self, x: &HostField, d: &HostField, work: &Work) -> Result<Option<Vec<HostField>>> {
        let mut sums: Option<Vec<HostField>> = None;
        for arc in &self.arcs {
            let part = (self.arcs.len() > 1).then(|| self.only(&arc.frames, d));
            let terms = self
                .model
                .along(x, part.as_ref().unwrap_or(d), &work.aside())?;
            let Some(mut terms) = terms else {
                return Ok(None);
            };
            terms.iter_mut().for_each(|term| self.multiply(arc, term));
            match &mut sums {
                None => sums = Some(terms),
                Some(sums) => {
                    let pairs = sums.iter_mut().zip(&terms);
                    pairs.for_each(|(sum, term)| sum.axpy(1.0, term));
                }
            }
        }
        Ok(sums)
    }

    fn describe(&self) -> String {
        let arcs = match self.arcs.len() {
            1 => String::new(),
            n => format!(", {n} arcs"),
        };
        let model = self.model.describe();
        format!("{model}, diffused at {} mm²/s{arcs}", exact(self.diffusion))
    }
}

#[cfg(test)]
mod tests;
