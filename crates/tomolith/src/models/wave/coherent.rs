//! Coherent light: fields at depths behind a plane of pixels, and their adjoint.
//!
//! # Equation
//! ```text
//! ψ(x, u, z) = Σ_f Ψ(f)·P(f)·W(x, f)·H(f)^(x/h)·e^(2πi f·r),        H = e^(2πi h (w − 1/λ)),        x = h/2, 3h/2, …
//! ```
//! The phase is computed in f64 in its reduced form w − 1/λ: the whole one would be 10⁵ rad at 10 mm.
//!
//! # Source
//! Wechsler et al. 2024, eqs. 2 and 3, with λ = λ₀/n (their text prints k = 2π/(λ₀n)); Matsushima & Shimobaba 2009 for W.

use super::light::Way;
use super::number::Number;
use super::sampling::Beam;
use super::spectrum::{Scratch, Windows, complex, zero};
use rustfft::num_complex::Complex;
use std::f64::consts::TAU;

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
    /// P·H^½ of each mode: the first depth lies half a step behind the focal plane.
    starts: Vec<Vec<Complex<T>>>,
}

impl<T: Number> Coherent<T> {
    pub(super) fn new(
        windows: Windows<T>,
        (beam, limit): (Beam, BandLimit),
        modes: Vec<Mode>,
    ) -> Self {
        let mut waves = Coherent {
            windows,
            limit,
            beam,
            modes,
            steps: Vec::new(),
            starts: Vec::new(),
        };
        let step = waves.windows.sampling.along.step;
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
                    let phase = -TAU * h * across / (k + square.sqrt());
                    complex(phase.sin_cos(), 1.0)
                } else {
                    let fading = (-TAU * h * (-square).sqrt()).exp();
                    complex((-TAU * h * k).sin_cos(), fading)
                });
            }
        }
        values
    }

    /// P·H^½ of all frequencies of a mode.
    fn start(&self, mode: &Mode) -> Vec<Complex<T>> {
        let sampling = &self.windows.sampling;
        let [bu, bz] = sampling.band.map(|b| b as i64);
        let mut values = self.kernel(mode, 0.5 * sampling.along.step);
        let frequencies = (-bz..=bz).flat_map(|fz| (-bu..=bu).map(move |fu| [fu, fz]));
        for (value, index) in values.iter_mut().zip(frequencies) {
            let f = [0, 1].map(|i| index[i] as f64 / self.windows.window[i]);
            *value = value.scale(T::of(self.beam.passes(f, mode.frequency)));
        }
        values
    }

    /// The depth of a plane that is computed.
    fn depth(&self, index: usize) -> f64 {
        (index as f64 + 0.5) * self.windows.sampling.along.step
    }

    /// Deletes of a spectrum what would come back from the far side of the window at this depth.
    pub(super) fn limit_to(&self, mode: &Mode, depth: f64, spectrum: &mut [Complex<T>]) {
        let [bu, bz] = self.windows.sampling.band.map(|b| b as i64);
        let [nu, _] = self.windows.counts();
        let k2 = self.beam.wavenumber.powi(2);
        let [gu, gz] = self.windows.sampling.guard;
        for (row, fz) in spectrum.chunks_exact_mut(nu).zip(-bz..=bz) {
            let z = fz as f64 / self.windows.window[1] + mode.frequency[1];
            // u²·x² ≤ g_u²·w² and z²·x² ≤ g_z²·w²
            let most = ((k2 - z * z) * gu * gu / (depth * depth + gu * gu))
                .min(k2 - z * z - z * z * depth * depth / (gz * gz));
            let reach = |at: f64| (at - mode.frequency[0]) * self.windows.window[0];
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
            row[..(low + bu) as usize].fill(zero());
            row[(high + 1 + bu) as usize..].fill(zero());
        }
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

    /// `scratch.here` = a spectrum as it is at a depth, limited; without the taper it stays in place for the next depth.
    fn tapered(&self, mode: &Mode, depth: f64, here: &[Complex<T>], out: &mut Vec<Complex<T>>) {
        let [bu, bz] = self.windows.sampling.band.map(|b| b as i64);
        out.clear();
        let indices = (-bz..=bz).flat_map(|fz| (-bu..=bu).map(move |fu| [fu, fz]));
        out.extend(
            here.iter()
                .zip(indices)
                .map(|(&v, index)| v * T::of(self.taper(mode, depth, index))),
        );
    }

    /// Calls `see(depth, mode, fields)` for every depth and mode of the images whose spectra lie in the scratches.
    pub(super) fn propagate<const N: usize>(
        &self,
        mut scratches: [&mut Scratch<T>; N],
        mut see: impl FnMut(usize, &Mode, [&[Complex<T>]; N]),
    ) {
        let mut tapered = Vec::new();
        for ((mode, step), start) in self.modes.iter().zip(&self.steps).zip(&self.starts) {
            for scratch in &mut scratches {
                let spectrum = scratch.spectrum.iter().zip(start);
                for (here, (&value, &start)) in scratch.here.iter_mut().zip(spectrum) {
                    *here = value * start;
                }
            }
            for depth in 0..self.windows.sampling.along.count {
                let x = self.depth(depth);
                for scratch in &mut scratches {
                    if depth > 0 {
                        for (v, &h) in scratch.here.iter_mut().zip(step) {
                            *v = *v * h;
                        }
                    }
                    self.limit_to(mode, x, &mut scratch.here);
                    let (here, parts) = scratch.split();
                    if self.limit == BandLimit::Tapered {
                        self.tapered(mode, x, here, &mut tapered);
                        self.windows.field(&tapered, parts);
                    } else {
                        self.windows.field(here, parts);
                    }
                }
                let fields = scratches.each_ref().map(|scratch| scratch.field.as_slice());
                see(depth, mode, fields);
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
        let mut back = vec![zero(); len];
        let mut tapered = Vec::new();
        for ((mode, step), start) in self.modes.iter().zip(&self.steps).zip(&self.starts) {
            scratch.power.clone_from(start);
            for depth in 0..self.windows.sampling.along.count {
                if depth > 0 {
                    for (p, &h) in scratch.power.iter_mut().zip(step) {
                        *p = *p * h;
                    }
                }
                let x = self.depth(depth);
                self.limit_to(mode, x, &mut scratch.power);
                let is_tapered = self.limit == BandLimit::Tapered;
                if is_tapered {
                    self.tapered(mode, x, &scratch.power, &mut tapered);
                }
                let power = std::mem::take(&mut scratch.power);
                let kernel = if is_tapered { &tapered } else { &power };
                for ((v, &s), &p) in scratch.here.iter_mut().zip(&scratch.spectrum).zip(kernel) {
                    *v = s * p;
                }
                let (here, parts) = scratch.split();
                self.windows.field(here, parts);
                cotangent(depth, mode, &mut scratch.field);
                self.windows.field_back(&mut back, scratch.split().1);
                for ((sum, &b), &p) in scratch.sum.iter_mut().zip(&back).zip(kernel) {
                    *sum = *sum + b * p.conj();
                }
                scratch.power = power;
            }
        }
        self.windows.transform_back(scratch, take);
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
            let own = |i: usize| chi[i].norm_sqr();
            self.windows.add_at(depth, (first, row), weight, both);
            self.windows.add_at(depth, (second, row), weight, own);
        });
    }
}

impl<T: Number> Way<T> for Coherent<T> {
    const IS_LINEAR: bool = false;

    fn windows(&self) -> &Windows<T> {
        &self.windows
    }

    fn shine(&self, scratch: &mut Scratch<T>, samples: &mut [T], row: usize) {
        self.propagate([scratch], |depth, mode, [field]| {
            let weight = T::of(mode.weight);
            let value = |i: usize| field[i].norm_sqr();
            self.windows.add_at(depth, (samples, row), weight, value);
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
            self.windows
                .multiply_by(depth, (samples, row), twice, field);
        };
        self.pull_back(scratch, ask, take);
    }

    fn operations(&self) -> f64 {
        let [image, depth] = self.windows.operations();
        let depths = self.windows.sampling.along.count * self.modes.len();
        3.0 * (image + depths as f64 * depth)
    }
}
