//! Fields at depths behind a plane of pixels, and their adjoint, with as little of each Fourier transform as is needed.
//!
//! # Equation
//! ```text
//! ψ(x, u, z) = Σ_f Ψ(f)·W(x, f)·H(f)^(x/h)·e^(2πi f·r),        Ψ = F[x]·(pupil and shift),        H = e^(2πi h (w − 1/λ))
//! ```
//! Only frequencies within the band are kept; transforms along z are made for the columns of pixels and the lateral samples that
//! voxels need. The phase is computed in f64 in its reduced form w − 1/λ: the whole one would be 10⁵ rad at 10 mm.
//!
//! # Source
//! Wechsler et al. 2024, eqs. 2 and 3, with λ = λ₀/n (their text prints k = 2π/(λ₀n)); Matsushima & Shimobaba 2009 for W.

use super::number::Number;
use super::sampling::{Beam, Sampling, Side};
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::TAU;
use std::ops::Range;
use std::sync::Arc;

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

/// Transforms of the frames of one light.
pub(super) struct Waves<T: Number> {
    pub(super) sampling: Sampling,
    limit: BandLimit,
    pixels: [usize; 2],
    beam: Beam,
    /// Length of the window along u and z, mm.
    window: [f64; 2],
    pub(super) modes: Vec<Mode>,
    /// H of each mode.
    steps: Vec<Vec<Complex<T>>>,
    /// What passes of each mode.
    pupils: Vec<Vec<T>>,
    /// Shift of the heights, and the scale of the transforms, one per frequency along z.
    shifts: Vec<Complex<T>>,
    /// Lateral samples that voxels need.
    pub(super) samples: Range<i64>,
    /// Sample of a voxel's height: first, and the way to the next, in a window of `heights.2`.
    heights: (usize, usize, usize),
    pub(super) voxels: usize,
    forward: [Arc<dyn Fft<T>>; 2],
    inverse: [Arc<dyn Fft<T>>; 2],
    fine_forward: [Arc<dyn Fft<T>>; 2],
    fine_inverse: [Arc<dyn Fft<T>>; 2],
}

/// Frequencies along z that are moved together: a cache line.
const TOGETHER: usize = 8;

/// Arrays of one thread.
pub(super) struct Scratch<T: Number> {
    /// Of the pixels.
    pub(super) spectrum: Vec<Complex<T>>,
    /// At a depth.
    pub(super) here: Vec<Complex<T>>,
    /// H^k, for the adjoint.
    power: Vec<Complex<T>>,
    /// Sum of the adjoint.
    sum: Vec<Complex<T>>,
    /// Lateral samples × frequencies along z.
    mixed: Vec<Complex<T>>,
    lines: Vec<Complex<T>>,
    /// Lateral samples × voxels along z.
    pub(super) field: Vec<Complex<T>>,
    rest: Vec<Complex<T>>,
}

fn zero<T: Number>() -> Complex<T> {
    Complex::new(T::zero(), T::zero())
}

fn complex<T: Number>((sin, cos): (f64, f64), size: f64) -> Complex<T> {
    Complex::new(T::of(size * cos), T::of(size * sin))
}

/// The sample `stride` < `count` behind `at`, in a window that repeats.
fn next(at: usize, stride: usize, count: usize) -> usize {
    let to = at + stride;
    if to < count { to } else { to - count }
}

/// How the heights of voxels lie on the rows of pixels: `ratio[0]` samples for `ratio[1]` rows' distance …
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Heights {
    /// Samples between two rows of pixels.
    pub(super) finer: usize,
    /// Samples from one voxel to the next.
    pub(super) stride: usize,
}

impl<T: Number> Waves<T> {
    pub(super) fn new(
        (beam, sampling, limit): (Beam, Sampling, BandLimit),
        [u, z]: [&Side; 2],
        (heights, voxels): (Heights, usize),
        modes: Vec<Mode>,
    ) -> Self {
        let window = [
            sampling.padded[0] as f64 * u.pitch,
            sampling.padded[1] as f64 * z.pitch,
        ];
        let fine_z = sampling.padded[1] * heights.finer;
        let sample_z = window[1] / fine_z as f64;
        // The first voxel's height in samples above the first row of pixels
        let place = (z.voxels[0] - z.from) / sample_z;
        let whole = place.round();
        let shift = (place - whole) * sample_z;
        let first = (whole as i64).rem_euclid(fine_z as i64) as usize;
        let scale = 1.0 / (sampling.padded[0] * sampling.padded[1]) as f64;
        let bz = sampling.band[1] as i64;
        let shifts = (-bz..=bz)
            .map(|f| complex((TAU * f as f64 / window[1] * shift).sin_cos(), scale))
            .collect();
        let sample_u = window[0] / sampling.fine as f64;
        let half = sampling.across.taps as i64 / 2;
        let samples = ((u.voxels[0] - u.from) / sample_u).floor() as i64 - half
            ..((u.voxels[1] - u.from) / sample_u).ceil() as i64 + half + 1;
        let mut plans = FftPlanner::new();
        let mut both = |n: [usize; 2]| {
            let forward = n.map(|n| plans.plan_fft_forward(n));
            (forward, n.map(|n| plans.plan_fft_inverse(n)))
        };
        let (forward, inverse) = both(sampling.padded);
        let (fine_forward, fine_inverse) = both([sampling.fine, fine_z]);
        let mut waves = Waves {
            pixels: [u.pixels, z.pixels],
            limit,
            beam,
            window,
            steps: Vec::new(),
            pupils: Vec::new(),
            modes,
            shifts,
            samples,
            heights: (first, heights.stride, fine_z),
            voxels,
            sampling,
            forward,
            inverse,
            fine_forward,
            fine_inverse,
        };
        waves.steps = waves.modes.iter().map(|m| waves.step(m)).collect();
        waves.pupils = waves.modes.iter().map(|m| waves.pupil(m)).collect();
        waves
    }

    /// Frequencies along u and z.
    fn counts(&self) -> [usize; 2] {
        self.sampling.band.map(|b| 2 * b + 1)
    }

    /// Lateral samples.
    pub(super) fn width(&self) -> usize {
        (self.samples.end - self.samples.start) as usize
    }

    pub(super) fn scratch(&self) -> Scratch<T> {
        let [nu, nz] = self.counts();
        let [mu, mz] = self.sampling.padded;
        let longest = mu.max(mz).max(self.sampling.fine).max(self.heights.2);
        let plans = [
            &self.forward,
            &self.inverse,
            &self.fine_forward,
            &self.fine_inverse,
        ];
        let rest = plans.iter().flat_map(|pair| pair.iter());
        let rest = rest.map(|plan| plan.get_inplace_scratch_len()).max();
        Scratch {
            spectrum: vec![zero(); nu * nz],
            here: vec![zero(); nu * nz],
            power: Vec::new(),
            sum: Vec::new(),
            mixed: vec![zero(); (self.width() * nz).max(mu * nz)],
            lines: vec![zero(); TOGETHER * longest],
            field: vec![zero(); self.width() * self.voxels],
            rest: vec![zero(); rest.unwrap_or(0)],
        }
    }

    /// w of a component of a mode, or how it fades.
    fn along(&self, mode: &Mode, [fu, fz]: [i64; 2]) -> (f64, f64) {
        let f = [
            fu as f64 / self.window[0] + mode.frequency[0],
            fz as f64 / self.window[1] + mode.frequency[1],
        ];
        let across = f[0] * f[0] + f[1] * f[1];
        (self.beam.wavenumber.powi(2) - across, across)
    }

    /// H of all frequencies of a mode.
    fn step(&self, mode: &Mode) -> Vec<Complex<T>> {
        let [bu, bz] = self.sampling.band.map(|b| b as i64);
        let k = self.beam.wavenumber;
        let h = self.sampling.step;
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
        let [bu, bz] = self.sampling.band.map(|b| b as i64);
        let pixels = self.sampling.padded.map(|n| 0.5 * n as f64);
        let mut values = Vec::with_capacity(((2 * bu + 1) * (2 * bz + 1)) as usize);
        for fz in -bz..=bz {
            for fu in -bu..=bu {
                let (_, across) = self.along(mode, [fu, fz]);
                let by_lens = (self.beam.aperture)
                    .map_or(1.0, |aperture| self.beam.fade(across.sqrt() / aperture));
                let shares = [fu as f64 / pixels[0], fz as f64 / pixels[1]];
                let by_pixels = shares.map(|share| self.beam.fade(share.abs()));
                values.push(T::of(by_lens * by_pixels[0] * by_pixels[1]));
            }
        }
        values
    }

    /// Deletes of a spectrum what would come back from the far side of the window at this depth.
    fn limit_to(&self, mode: &Mode, depth: f64, spectrum: &mut [Complex<T>]) {
        if depth == 0.0 {
            return;
        }
        let [bu, bz] = self.sampling.band.map(|b| b as i64);
        let [nu, _] = self.counts();
        let k2 = self.beam.wavenumber.powi(2);
        let [gu, gz] = self.sampling.guard;
        for (row, fz) in spectrum.chunks_exact_mut(nu).zip(-bz..=bz) {
            let z = fz as f64 / self.window[1] + mode.frequency[1];
            // u²·x² ≤ g_u²·w² and z²·x² ≤ g_z²·w²
            let most = ((k2 - z * z) * gu * gu / (depth * depth + gu * gu))
                .min(k2 - z * z - z * z * depth * depth / (gz * gz));
            let reach = |at: f64| (at - mode.frequency[0]) * self.window[0];
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
        let f = [0, 1].map(|i| index[i] as f64 / self.window[i] + mode.frequency[i]);
        let k2 = self.beam.wavenumber.powi(2);
        let mut left = 1.0;
        if square < 0.0 {
            return 0.0;
        }
        for i in 0..2 {
            let slope = depth / self.sampling.guard[i];
            // 1 at the limit
            let ratio = (f[i].powi(2) * (1.0 + slope * slope) + f[1 - i].powi(2)) / k2;
            let share = ((1.0 - ratio) / 0.2).clamp(0.0, 1.0);
            left *= (0.25 * TAU * share).sin().powi(2);
        }
        left
    }

    /// `scratch.here` = a spectrum as it is at a depth, limited; without the taper it stays in place for the next depth.
    fn tapered(&self, mode: &Mode, depth: f64, here: &[Complex<T>], out: &mut Vec<Complex<T>>) {
        let [bu, bz] = self.sampling.band.map(|b| b as i64);
        out.clear();
        let indices = (-bz..=bz).flat_map(|fz| (-bu..=bu).map(move |fu| [fu, fz]));
        out.extend(
            here.iter()
                .zip(indices)
                .map(|(&v, index)| v * T::of(self.taper(mode, depth, index))),
        );
    }

    /// `scratch.spectrum` = the spectrum of an image, given column by column from low z to high z.
    pub(super) fn transform<'a>(
        &self,
        scratch: &mut Scratch<T>,
        columns: impl Iterator<Item = (usize, &'a [T])>,
    ) where
        T: 'a,
    {
        let [mu, mz] = self.sampling.padded;
        let [nu, nz] = self.counts();
        let [bu, bz] = self.sampling.band;
        let Scratch {
            spectrum,
            mixed,
            lines,
            rest,
            ..
        } = scratch;
        mixed[..mu * nz].fill(zero());
        for (column, (bottom, values)) in columns.enumerate() {
            if values.iter().all(|v| v.is_zero()) {
                continue;
            }
            let line = &mut lines[..mz];
            line.fill(zero());
            for (to, &value) in line[bottom..].iter_mut().zip(values) {
                to.re = value;
            }
            self.forward[1].process_with_scratch(line, rest);
            for (i, shift) in self.shifts.iter().enumerate() {
                mixed[i * mu + column] = line[(i + mz - bz) % mz] * shift;
            }
        }
        for (row, to) in mixed
            .chunks_exact_mut(mu)
            .zip(spectrum.chunks_exact_mut(nu))
        {
            self.forward[0].process_with_scratch(row, rest);
            to[..bu].copy_from_slice(&row[mu - bu..]);
            to[bu..].copy_from_slice(&row[..=bu]);
        }
    }

    /// The adjoint of [`transform`](Self::transform) of `scratch.sum`: real parts, column by column, handed to `take`.
    fn transform_back(&self, scratch: &mut Scratch<T>, mut take: impl FnMut(usize, &[Complex<T>])) {
        let [mu, mz] = self.sampling.padded;
        let [nu, nz] = self.counts();
        let [bu, bz] = self.sampling.band;
        let Scratch {
            sum,
            mixed,
            lines,
            rest,
            ..
        } = scratch;
        for (row, from) in mixed[..mu * nz]
            .chunks_exact_mut(mu)
            .zip(sum.chunks_exact(nu))
        {
            row.fill(zero());
            row[mu - bu..].copy_from_slice(&from[..bu]);
            row[..=bu].copy_from_slice(&from[bu..]);
            self.inverse[0].process_with_scratch(row, rest);
        }
        for column in 0..self.pixels[0] {
            let line = &mut lines[..mz];
            line.fill(zero());
            for (i, shift) in self.shifts.iter().enumerate() {
                line[(i + mz - bz) % mz] = mixed[i * mu + column] * shift.conj();
            }
            self.inverse[1].process_with_scratch(line, rest);
            take(column, &line[..self.pixels[1]]);
        }
    }

    /// `scratch.field` = the field of a spectrum at the lateral samples and the heights of the voxels.
    fn field(&self, from: &[Complex<T>], parts: Parts<'_, T>) {
        let [nu, nz] = self.counts();
        let [bu, bz] = self.sampling.band;
        let fine = self.sampling.fine;
        let Parts {
            mixed,
            lines,
            field,
            rest,
        } = parts;
        let first = self.samples.start.rem_euclid(fine as i64) as usize;
        for (group, rows) in from.chunks(TOGETHER * nu).enumerate() {
            let count = rows.len() / nu;
            for (line, row) in lines.chunks_exact_mut(fine).zip(rows.chunks_exact(nu)) {
                line[bu + 1..fine - bu].fill(zero());
                line[fine - bu..].copy_from_slice(&row[..bu]);
                line[..=bu].copy_from_slice(&row[bu..]);
            }
            self.fine_inverse[0].process_with_scratch(&mut lines[..count * fine], rest);
            let mut at = first;
            for to in mixed.chunks_exact_mut(nz).take(self.width()) {
                for (i, to) in to[group * TOGETHER..][..count].iter_mut().enumerate() {
                    *to = lines[i * fine + at];
                }
                at = next(at, 1, fine);
            }
        }
        let (start, stride, high) = self.heights;
        let lines = &mut lines[..high];
        for (from, to) in (mixed.chunks_exact(nz)).zip(field.chunks_exact_mut(self.voxels)) {
            lines[bz + 1..high - bz].fill(zero());
            lines[high - bz..].copy_from_slice(&from[..bz]);
            lines[..=bz].copy_from_slice(&from[bz..]);
            self.fine_inverse[1].process_with_scratch(lines, rest);
            let mut at = start;
            for to in to {
                *to = lines[at];
                at = next(at, stride, high);
            }
        }
    }

    /// The adjoint of [`field`](Self::field): `onto` = the spectrum of a field.
    fn field_back(&self, onto: &mut [Complex<T>], parts: Parts<'_, T>) {
        let [nu, nz] = self.counts();
        let [bu, bz] = self.sampling.band;
        let fine = self.sampling.fine;
        let Parts {
            mixed,
            lines,
            field,
            rest,
        } = parts;
        let (start, stride, high) = self.heights;
        for (to, from) in (mixed.chunks_exact_mut(nz)).zip(field.chunks_exact(self.voxels)) {
            let line = &mut lines[..high];
            line.fill(zero());
            let mut at = start;
            for &from in from {
                line[at] = from;
                at = next(at, stride, high);
            }
            self.fine_forward[1].process_with_scratch(line, rest);
            to[..bz].copy_from_slice(&line[high - bz..]);
            to[bz..].copy_from_slice(&line[..=bz]);
        }
        let first = self.samples.start.rem_euclid(fine as i64) as usize;
        for (group, rows) in onto.chunks_mut(TOGETHER * nu).enumerate() {
            let count = rows.len() / nu;
            lines[..count * fine].fill(zero());
            let mut at = first;
            for from in mixed.chunks_exact(nz).take(self.width()) {
                for (i, &from) in from[group * TOGETHER..][..count].iter().enumerate() {
                    lines[i * fine + at] = lines[i * fine + at] + from;
                }
                at = next(at, 1, fine);
            }
            self.fine_forward[0].process_with_scratch(&mut lines[..count * fine], rest);
            for (line, row) in lines.chunks_exact(fine).zip(rows.chunks_exact_mut(nu)) {
                row[..bu].copy_from_slice(&line[fine - bu..]);
                row[bu..].copy_from_slice(&line[..=bu]);
            }
        }
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
            for depth in 0..self.sampling.depths {
                let x = depth as f64 * self.sampling.step;
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
                        self.field(&tapered, parts);
                    } else {
                        self.field(here, parts);
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
            for depth in 0..self.sampling.depths {
                if depth > 0 {
                    for (p, &h) in scratch.power.iter_mut().zip(step) {
                        *p = *p * h;
                    }
                }
                let x = depth as f64 * self.sampling.step;
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
                self.field(here, parts);
                cotangent(depth, mode, &mut scratch.field);
                self.field_back(&mut back, scratch.split().1);
                for ((sum, &b), &p) in scratch.sum.iter_mut().zip(&back).zip(kernel) {
                    *sum = *sum + b * p.conj();
                }
                scratch.power = power;
            }
        }
        self.transform_back(scratch, take);
    }

    /// Multiplications and additions of the Fourier transforms of one frame's dose and pullback, 5·n·log₂n for each of length n.
    pub(super) fn operations(&self) -> f64 {
        let of = |n: usize, times: usize| 5.0 * n as f64 * (n as f64).log2() * times as f64;
        let [mu, mz] = self.sampling.padded;
        let [_, nz] = self.counts();
        let image = of(mz, self.pixels[0]) + of(mu, nz);
        let depth = of(self.sampling.fine, nz) + of(self.heights.2, self.width());
        3.0 * (image + (self.sampling.depths * self.modes.len()) as f64 * depth)
    }
}

/// What a transform works on.
struct Parts<'a, T: Number> {
    mixed: &'a mut [Complex<T>],
    lines: &'a mut [Complex<T>],
    field: &'a mut [Complex<T>],
    rest: &'a mut [Complex<T>],
}

impl<T: Number> Scratch<T> {
    fn split(&mut self) -> (&[Complex<T>], Parts<'_, T>) {
        let parts = Parts {
            mixed: &mut self.mixed,
            lines: &mut self.lines,
            field: &mut self.field,
            rest: &mut self.rest,
        };
        (&self.here, parts)
    }
}
