//! Coherent light: fields at depths behind a plane of pixels, and their adjoint.
//!
//! # Equation
//! ```text
//! ψ(x, u, z) = Σ_f Ψ(f)·P(f)·W(x, f)·H(f)^(x/h)·e^(2πi f·r),        H = e^(2πi h (w − 1/λ)),        x = x₀, x₀ + h, …
//! ```
//! The phase is computed in f64 in its reduced form w − 1/λ: the whole one would be 10⁵ rad at 10 mm.
//!
//! # Source
//! Wechsler et al. 2024, eqs. 2 and 3, with λ = λ₀/n (their text prints k = 2π/(λ₀n)); Matsushima & Shimobaba 2009 for W.

use super::beam::Beam;
use super::depth_interpolation::DepthInterpolation;
use super::light::{Propagation, SpreadingForm};
use super::lights::{Lights, ModelPropagation};
use super::number::Number;
use super::spectrum::{Scratch, Windows, complex, zero};
use crate::{DoseModel, Work};
use std::f64::consts::TAU;
use std::ops::Range;
use tomolith_core::dose::waves::{FieldTap, Transfer, WaveMode};
use tomolith_core::error::Result;
use tomolith_core::field::HostField;
use tomolith_fourier::Complex;

/// Where W falls.
#[derive(
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    serde::Serialize,
    serde::Deserialize,
    schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum BandLimit {
    /// At the limit.
    #[default]
    Hard,
    /// By sin² between 0.894 and 1 of it.
    Tapered,
}

/// One mode of the light: a plane wave that carries the pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mode {
    /// Its frequency along u and z, 1/mm.
    pub(super) frequency: [f64; 2],
    /// Its part of the energy.
    pub(super) weight: f64,
}

/// Waves of one light.
pub(super) struct Coherent<T: Number> {
    windows: Windows<T>,
    limit: BandLimit,
    beam: Beam,
    pub(super) modes: Vec<Mode>,
    /// H of each mode.
    steps: Vec<Vec<Complex<T>>>,
    /// P·H^(x₀/h) of each mode, x₀ the first depth.
    starts: Vec<Vec<Complex<T>>>,
    /// Fields that are not transformed but interpolated.
    interpolation: Option<DepthInterpolation<T>>,
    /// What fields are turned back by, 1/mm.
    middle: f64,
}

impl<T: Number> Coherent<T> {
    pub(super) fn new(windows: Windows<T>, beam: Beam, limit: BandLimit, modes: Vec<Mode>) -> Self {
        let interpolation = DepthInterpolation::new(&windows.sampling);
        let mut waves = Coherent {
            middle: windows
                .sampling
                .fields
                .as_ref()
                .map_or(0.0, |fields| fields.middle),
            interpolation,
            windows,
            limit,
            beam,
            modes,
            steps: Vec::new(),
            starts: Vec::new(),
        };
        let step = waves.windows.sampling.transformed().step;
        waves.steps = waves.modes.iter().map(|m| waves.kernel(m, step)).collect();
        waves.starts = waves.modes.iter().map(|m| waves.start(m)).collect();
        waves
    }

    /// w of a component of a mode, or how it fades.
    fn along(&self, mode: &Mode, [fu, fz]: [i64; 2]) -> (f64, f64) {
        let f = [
            fu as f64 / self.windows.window[0] + mode.frequency[0],
            fz as f64 / self.windows.window[1] + mode.frequency[1],
        ];
        let across = f[0] * f[0] + f[1] * f[1];
        (self.beam.wavenumber.powi(2) - across, across)
    }

    /// H of all frequencies of a mode, over a depth h.
    fn kernel(&self, mode: &Mode, h: f64) -> Vec<Complex<T>> {
        let [bu, bz] = self.windows.sampling.band.map(|b| b as i64);
        let k = self.beam.wavenumber;
        let mut values = Vec::with_capacity(((2 * bu + 1) * (2 * bz + 1)) as usize);
        for fz in -bz..=bz {
            for fu in -bu..=bu {
                let (square, across) = self.along(mode, [fu, fz]);
                values.push(if square >= 0.0 {
                    // w − 1/λ without the difference of large numbers
                    let phase = TAU * h * (self.middle - across / (k + square.sqrt()));
                    complex(phase.sin_cos(), 1.0)
                } else {
                    let fading = (-TAU * h * (-square).sqrt()).exp();
                    complex((TAU * h * (self.middle - k)).sin_cos(), fading)
                });
            }
        }
        values
    }

    /// P·H^(x₀/h) of all frequencies of a mode.
    fn start(&self, mode: &Mode) -> Vec<Complex<T>> {
        let sampling = &self.windows.sampling;
        let [bu, bz] = sampling.band.map(|b| b as i64);
        let mut values = self.kernel(mode, sampling.transformed().at(0));
        let frequencies = (-bz..=bz).flat_map(|fz| (-bu..=bu).map(move |fu| [fu, fz]));
        for (value, index) in values.iter_mut().zip(frequencies) {
            let f = [0, 1].map(|i| index[i] as f64 / self.windows.window[i]);
            *value = value.scale(T::of(self.beam.passes(f, mode.frequency)));
        }
        values
    }

    /// The depth of a plane that is transformed.
    fn depth(&self, index: usize) -> f64 {
        self.windows.sampling.transformed().at(index)
    }

    /// Brings a spectrum that has come to the depth before on to this one; `wave`: index of its mode.
    fn advance(&self, wave: usize, depth: usize, spectrum: &mut [Complex<T>]) {
        if depth > 0 {
            for (v, &h) in spectrum.iter_mut().zip(&self.steps[wave]) {
                *v = *v * h;
            }
        }
        self.limit_to(&self.modes[wave], self.depth(depth), spectrum);
    }

    /// Deletes of a spectrum what would come back from the far side of the window at this depth.
    pub(super) fn limit_to(&self, mode: &Mode, depth: f64, spectrum: &mut [Complex<T>]) {
        let [nu, _] = self.windows.counts();
        let rows = spectrum.chunks_exact_mut(nu);
        for (row, passing) in rows.zip(self.passing(mode, depth)) {
            row[..passing.start].fill(zero());
            row[passing.end..].fill(zero());
        }
    }

    /// The frequencies along u that pass at a depth, of each along z.
    fn passing(&self, mode: &Mode, depth: f64) -> impl Iterator<Item = Range<usize>> {
        let [bu, bz] = self.windows.sampling.band.map(|b| b as i64);
        let [window_u, window_z] = self.windows.window;
        let [mode_u, mode_z] = mode.frequency;
        let k2 = self.beam.wavenumber.powi(2);
        let [gu, gz] = self.windows.sampling.guard;
        (-bz..=bz).map(move |fz| {
            let z = fz as f64 / window_z + mode_z;
            // u²·x² ≤ g_u²·w² and z²·x² ≤ g_z²·w²
            let most = ((k2 - z * z) * gu * gu / (depth * depth + gu * gu))
                .min(k2 - z * z - z * z * depth * depth / (gz * gz));
            let reach = |at: f64| (at - mode_u) * window_u;
            let edge = most.max(0.0).sqrt();
            let (low, high) = if most < 0.0 {
                (1, 0)
            } else {
                // A hair more, for frequencies that lie on the limit
                let low = (reach(-edge) - 1e-9).ceil() as i64;
                (low, (reach(edge) + 1e-9).floor() as i64)
            };
            let low = low.clamp(-bu, bu + 1);
            let high = high.clamp(low - 1, bu);
            (low + bu) as usize..(high + 1 + bu) as usize
        })
    }

    /// How much less of a component the tapered limit leaves at a depth.
    fn taper(&self, mode: &Mode, depth: f64, index: [i64; 2]) -> f64 {
        let (square, _) = self.along(mode, index);
        let f = [0, 1].map(|i| index[i] as f64 / self.windows.window[i] + mode.frequency[i]);
        let k2 = self.beam.wavenumber.powi(2);
        let mut left = 1.0;
        if square < 0.0 {
            return 0.0;
        }
        for i in 0..2 {
            let slope = depth / self.windows.sampling.guard[i];
            // 1 at the limit
            let ratio = (f[i].powi(2) * (1.0 + slope * slope) + f[1 - i].powi(2)) / k2;
            let share = ((1.0 - ratio) / 0.2).clamp(0.0, 1.0);
            left *= (0.25 * TAU * share).sin().powi(2);
        }
        left
    }

    /// A spectrum as the tapered limit leaves it at a depth, or as it is.
    fn tapered<'a>(
        &self,
        wave: usize,
        depth: usize,
        here: &'a [Complex<T>],
        out: &'a mut Vec<Complex<T>>,
    ) -> &'a [Complex<T>] {
        if self.limit == BandLimit::Hard {
            return here;
        }
        let [bu, bz] = self.windows.sampling.band.map(|b| b as i64);
        let indices = (-bz..=bz).flat_map(|fz| (-bu..=bu).map(move |fu| [fu, fz]));
        let left = |index| self.taper(&self.modes[wave], self.depth(depth), index);
        out.clear();
        out.extend(
            here.iter()
                .zip(indices)
                .map(|(&v, index)| v * T::of(left(index))),
        );
        out
    }

    /// Calls `see(depth, mode, fields)` for every depth where light is wanted and every mode, of the images whose spectra lie in the scratches.
    pub(super) fn propagate<const N: usize>(
        &self,
        mut scratches: [&mut Scratch<T>; N],
        mut see: impl FnMut(usize, &Mode, [&[Complex<T>]; N]),
    ) {
        let mut tapered = Vec::new();
        for (wave, (mode, start)) in self.modes.iter().zip(&self.starts).enumerate() {
            for scratch in &mut scratches {
                let spectrum = scratch.spectrum.iter().zip(start);
                for (here, (&value, &start)) in scratch.here.iter_mut().zip(spectrum) {
                    *here = value * start;
                }
            }
            let mut next = 0;
            for depth in 0..self.windows.sampling.transformed().count {
                for scratch in &mut scratches {
                    self.advance(wave, depth, &mut scratch.here);
                    let (here, parts) = scratch.split();
                    let here = self.tapered(wave, depth, here, &mut tapered);
                    self.windows.field(here, parts);
                }
                let Some(interpolation) = &self.interpolation else {
                    see(
                        depth,
                        mode,
                        scratches.each_ref().map(|s| s.field.as_slice()),
                    );
                    continue;
                };
                let ready = interpolation.ready(next, depth);
                for scratch in &mut scratches {
                    interpolation.keep(depth, &scratch.field, &mut scratch.interpolation);
                    interpolation.forth(
                        ready.clone(),
                        scratch.field.len(),
                        &mut scratch.interpolation,
                    );
                }
                for (i, index) in ready.clone().enumerate() {
                    let fields = scratches
                        .each_ref()
                        .map(|s| s.interpolation.now[i].as_slice());
                    see(index, mode, fields);
                }
                next = ready.end;
            }
        }
    }

    /// The adjoint of [`propagate`](Self::propagate) at that image: `cotangent(depth, mode, field)` turns each field ψ into what is sent
    /// back; the sum, as real parts of columns of pixels, goes to `take`.
    pub(super) fn pull_back(
        &self,
        scratch: &mut Scratch<T>,
        mut cotangent: impl FnMut(usize, &Mode, &mut [Complex<T>]),
        take: impl FnMut(usize, &[Complex<T>]),
    ) {
        let len = scratch.spectrum.len();
        scratch.sum.clear();
        scratch.sum.resize(len, zero());
        let mut back = Back::default();
        for (wave, (mode, start)) in self.modes.iter().zip(&self.starts).enumerate() {
            scratch.power.clone_from(start);
            back.begin(start);
            let mut next = 0;
            for depth in 0..self.windows.sampling.transformed().count {
                self.field_of_image(wave, depth, scratch, &mut back.tapered);
                let Some(interpolation) = &self.interpolation else {
                    cotangent(depth, mode, &mut scratch.field);
                    self.send(wave, depth, scratch, &mut back);
                    continue;
                };
                interpolation.keep(depth, &scratch.field, &mut scratch.interpolation);
                let (ready, len) = (interpolation.ready(next, depth), scratch.field.len());
                interpolation.forth(ready.clone(), len, &mut scratch.interpolation);
                for (index, field) in ready.clone().zip(&mut scratch.interpolation.now) {
                    cotangent(index, mode, field);
                }
                next = ready.end;
                interpolation.send(ready, &mut scratch.interpolation);
                let done = interpolation.done(back.sent, next);
                interpolation.back(done.clone(), len, &mut scratch.interpolation);
                for (i, depth) in done.enumerate() {
                    std::mem::swap(&mut scratch.field, &mut scratch.interpolation.now[i]);
                    self.send(wave, depth, scratch, &mut back);
                }
            }
        }
        self.windows.transform_back(scratch, take);
    }

    /// `scratch.field` = the field of the image at a depth, `scratch.power` brought to it.
    fn field_of_image(
        &self,
        wave: usize,
        depth: usize,
        scratch: &mut Scratch<T>,
        tapered: &mut Vec<Complex<T>>,
    ) {
        self.advance(wave, depth, &mut scratch.power);
        let kernel = self.tapered(wave, depth, &scratch.power, tapered);
        for ((v, &s), &p) in scratch.here.iter_mut().zip(&scratch.spectrum).zip(kernel) {
            *v = s * p;
        }
        let (here, parts) = scratch.split();
        self.windows.field(here, parts);
    }

    /// `scratch.sum` += what `scratch.field` at a depth sends back.
    fn send(&self, wave: usize, depth: usize, scratch: &mut Scratch<T>, back: &mut Back<T>) {
        self.advance(wave, depth, &mut back.power);
        self.windows
            .field_back(&mut back.spectrum, scratch.split().1);
        let kernel = self.tapered(wave, depth, &back.power, &mut back.tapered);
        for ((sum, &b), &p) in scratch.sum.iter_mut().zip(&back.spectrum).zip(kernel) {
            *sum = *sum + b * p.conj();
        }
        back.sent += 1;
    }

    /// 2·Re ψχ* and |χ|² of two images at all samples, added to `samples` one after the other.
    pub(super) fn shine_along(
        &self,
        scratches: [&mut Scratch<T>; 2],
        samples: &mut [T],
        row: usize,
    ) {
        let two = T::of(2.0);
        let (first, second) = samples.split_at_mut(samples.len() / 2);
        self.propagate(scratches, |depth, mode, [psi, chi]| {
            let weight = T::of(mode.weight);
            let both = |i: usize| two * (psi[i] * chi[i].conj()).re;
            let power = |i: usize| chi[i].norm_sqr();
            self.windows.add_at(depth, first, row, weight, both);
            self.windows.add_at(depth, second, row, weight, power);
        });
    }
}

impl ModelPropagation for Coherent<f32> {
    const MODEL: &'static str = super::KIND.name;

    fn modes(&self) -> usize {
        self.modes.len()
    }

    /// Not with a tapered band limit.
    fn form(&self) -> Option<SpreadingForm> {
        if self.limit != BandLimit::Hard {
            return None;
        }
        let numbers = |values: &[Complex<f32>]| values.iter().map(|v| [v.re, v.im]).collect();
        let depths = 0..self.windows.sampling.transformed().count;
        let mode_form = |(wave, mode): (usize, &Mode)| {
            let rows = |depth| self.passing(mode, self.depth(depth));
            let passing = depths.clone().flat_map(rows);
            WaveMode {
                weight: f32::of(mode.weight),
                transfer: Transfer::Steps {
                    start: numbers(&self.starts[wave]),
                    step: numbers(&self.steps[wave]),
                    passing: passing
                        .map(|p| [p.start, p.end].map(|i| i as u32))
                        .collect(),
                },
            }
        };
        let sums = (self.interpolation.as_ref()).map_or_else(
            || alone(self.windows.sampling.along.computed.count),
            DepthInterpolation::form,
        );
        let modes = self.modes.iter().enumerate();
        Some((modes.map(mode_form).collect(), sums))
    }

    /// F′(x)d and F(d): the fields of x and of d, multiplied.
    fn along(
        lights: &Lights<Self>,
        x: &HostField,
        d: &HostField,
        work: &Work,
    ) -> Result<Vec<HostField>> {
        let mut terms = [lights.new_dose()?, lights.new_dose()?];
        for (light, layout) in lights.each() {
            let doses = terms.each_mut().map(HostField::as_mut_slice);
            light.add_along(layout, [x.as_slice(), d.as_slice()], doses, work)?;
        }
        Ok(terms.into())
    }
}

/// Sums of the field of the same depth alone.
pub(super) fn alone(depths: usize) -> [Vec<Vec<FieldTap>>; 2] {
    let field = |depth: usize| {
        vec![FieldTap {
            field: depth as u32,
            weights: [1.0; 2],
        }]
    };
    [(); 2].map(|()| (0..depths).map(field).collect())
}

/// What is on its way back: fields are sent some depths later than the image comes by.
#[derive(Default)]
struct Back<T: Number> {
    /// P·H^k of the depth that was sent last.
    power: Vec<Complex<T>>,
    /// Depths that were sent.
    sent: usize,
    spectrum: Vec<Complex<T>>,
    tapered: Vec<Complex<T>>,
}

impl<T: Number> Back<T> {
    fn begin(&mut self, start: &[Complex<T>]) {
        self.power.clear();
        self.power.extend_from_slice(start);
        self.sent = 0;
        self.spectrum.resize(start.len(), zero());
    }
}

impl<T: Number> Propagation<T> for Coherent<T> {
    const IS_LINEAR: bool = false;

    fn windows(&self) -> &Windows<T> {
        &self.windows
    }

    fn shine(&self, scratch: &mut Scratch<T>, samples: &mut [T], row: usize) {
        self.propagate([scratch], |depth, mode, [field]| {
            let weight = T::of(mode.weight);
            let value = |i: usize| field[i].norm_sqr();
            self.windows.add_at(depth, samples, row, weight, value);
        });
    }

    /// 2·Re of the adjoint of ψ ↦ samples·ψ
    fn send_back(
        &self,
        samples: &[T],
        row: usize,
        scratch: &mut Scratch<T>,
        take: &mut dyn FnMut(usize, &[Complex<T>]),
    ) {
        let ask = |depth: usize, mode: &Mode, field: &mut [Complex<T>]| {
            let twice = T::of(2.0 * mode.weight);
            self.windows.multiply_by(depth, samples, row, twice, field);
        };
        self.pull_back(scratch, ask, take);
    }
}
