//! Coherent light: fields at depths behind a plane of pixels, and their adjoint.
//!
//! # Equation
//! ```text
//! ψ(x, u, z) = Σ_f Ψ(f)·P(f)·W(x, f)·H(f)^(x/h)·e^(2πi f·r),        H = e^(2πi h (w − 1/λ))
//! ```
//! The phase is computed in f64 in its reduced form w − 1/λ: the whole one would be 10⁵ rad at 10 mm.
//!
//! # Source
//! Wechsler et al. 2024, eqs. 2 and 3, with λ = λ₀/n (their text prints k = 2π/(λ₀n)); Matsushima & Shimobaba 2009 for W.

use super::light::Way;
use super::number::Number;
use super::sampling::{Beam, fade};
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
    /// What passes of each mode.
    pupils: Vec<Vec<T>>,
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
            pupils: Vec::new(),
        };
        waves.steps = waves.modes.iter().map(|m| waves.step(m)).collect();
        waves.pupils = waves.modes.iter().map(|m| waves.pupil(m)).collect();
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

    /// H of all frequencies of a mode.
    fn step(&self, mode: &Mode) -> Vec<Complex<T>> {
        let [bu, bz] = self.windows.sampling.band.map(|b| b as i64);
        let k = self.beam.wavenumber;
        let h = self.windows.sampling.step;
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

    /// What passes of all frequencies of a mode: its own limit is the lens's, the pattern's that of the pixels.
    fn pupil(&self, mode: &Mode) -> Vec<T> {
        let [bu, bz] = self.windows.sampling.band.map(|b| b as i64);
        let pixels = self.windows.sampling.padded.map(|n| 0.5 * n as f64);
        let mut values = Vec::with_capacity(((2 * bu + 1) * (2 * bz + 1)) as usize);
        for fz in -bz..=bz {
            for fu in -bu..=bu {
                let (_, across) = self.along(mode, [fu, fz]);
                let by_lens = (self.beam.aperture).map_or(1.0, |aperture| {
                    fade(self.beam.soft_edge, across.sqrt() / aperture)
                });
                let shares = [fu as f64 / pixels[0], fz as f64 / pixels[1]];
                let by_pixels = shares.map(|share| fade(self.beam.soft_edge, share.abs()));
                values.push(T::of(by_lens * by_pixels[0] * by_pixels[1]));
            }
        }
        values
    }

    /// Deletes of a spectrum what would come back from the far side of the window at this depth.
    pub(super) fn limit_to(&self, mode: &Mode, depth: f64, spectrum: &mut [Complex<T>]) {
        if depth == 0.0 {
            return;
        }
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
        for ((mode, step), pupil) in self.modes.iter().zip(&self.steps).zip(&self.pupils) {
            for scratch in &mut scratches {
                let spectrum = scratch.spectrum.iter().zip(pupil);
                for (here, (value, &passes)) in scratch.here.iter_mut().zip(spectrum) {
                    *here = value.scale(passes);
                }
            }
            for depth in 0..self.windows.sampling.depths {
                let x = depth as f64 * self.windows.sampling.step;
                for scratch in &mut scratches {
                    if depth > 0 {
                        for (v, &h) in scratch.here.iter_mut().zip(step) {
                            *v = *v * h;
                        }
                    }
                    self.limit_to(mode, x, &mut scratch.here);
                    let (here, parts) = scratch.split();
                    if self.limit == BandLimit::Tapered && depth > 0 {
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
        for ((mode, step), pupil) in self.modes.iter().zip(&self.steps).zip(&self.pupils) {
            scratch.power.clear();
            let passes = pupil.iter().map(|&passes| Complex::new(passes, T::zero()));
            scratch.power.extend(passes);
            for depth in 0..self.windows.sampling.depths {
                if depth > 0 {
                    for (p, &h) in scratch.power.iter_mut().zip(step) {
                        *p = *p * h;
                    }
                }
                let x = depth as f64 * self.windows.sampling.step;
                self.limit_to(mode, x, &mut scratch.power);
                let is_tapered = self.limit == BandLimit::Tapered && depth > 0;
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

    /// |ψ|², 2·Re ψχ* and |χ|² of two images at all samples, added to three arrays.
    pub(super) fn shine_along(
        &self,
        scratches: [&mut Scratch<T>; 2],
        [first, second, third]: [&mut [T]; 3],
        row: usize,
    ) {
        let two = T::of(2.0);
        self.propagate(scratches, |depth, mode, [psi, chi]| {
            let weight = T::of(mode.weight);
            let add = |samples: &mut [T], value: &dyn Fn(usize) -> T| {
                self.windows.add_at(depth, (samples, row), weight, value);
            };
            add(first, &|i| psi[i].norm_sqr());
            add(second, &|i| two * (psi[i] * chi[i].conj()).re);
            add(third, &|i| chi[i].norm_sqr());
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
        let depths = self.windows.sampling.depths * self.modes.len();
        3.0 * (image + depths as f64 * depth)
    }
}
