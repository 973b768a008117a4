//! Fourier transforms of the frames of one light, with as little of each as is needed.
//!
//! Only frequencies within the band are kept; transforms along z are made for the columns of pixels and the lateral samples that
//! voxels need. What happens to a spectrum on its way to a depth is not known here: [`coherent`](super::coherent),
//! [`cones`](super::cones).

use super::number::Number;
use super::sampling::{Sampling, Side};
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::TAU;
use std::ops::Range;
use std::sync::Arc;

/// Transforms of the frames of one light.
pub(super) struct Windows<T: Number> {
    pub(super) sampling: Sampling,
    pixels: [usize; 2],
    /// Length of the window along u and z, mm.
    pub(super) window: [f64; 2],
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
    pub(super) power: Vec<Complex<T>>,
    /// Sum of the adjoint.
    pub(super) sum: Vec<Complex<T>>,
    /// Lateral samples × frequencies along z.
    mixed: Vec<Complex<T>>,
    lines: Vec<Complex<T>>,
    /// Lateral samples × voxels along z.
    pub(super) field: Vec<Complex<T>>,
    rest: Vec<Complex<T>>,
}

pub(super) fn zero<T: Number>() -> Complex<T> {
    Complex::new(T::zero(), T::zero())
}

pub(super) fn complex<T: Number>((sin, cos): (f64, f64), size: f64) -> Complex<T> {
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

impl<T: Number> Windows<T> {
    pub(super) fn new(
        sampling: Sampling,
        [u, z]: [&Side; 2],
        (heights, voxels): (Heights, usize),
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
        Windows {
            pixels: [u.pixels, z.pixels],
            window,
            shifts,
            samples,
            heights: (first, heights.stride, fine_z),
            voxels,
            sampling,
            forward,
            inverse,
            fine_forward,
            fine_inverse,
        }
    }

    /// Frequencies along u and z.
    pub(super) fn counts(&self) -> [usize; 2] {
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
    pub(super) fn transform_back(
        &self,
        scratch: &mut Scratch<T>,
        mut take: impl FnMut(usize, &[Complex<T>]),
    ) {
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
    pub(super) fn field(&self, from: &[Complex<T>], parts: Parts<'_, T>) {
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
    pub(super) fn field_back(&self, onto: &mut [Complex<T>], parts: Parts<'_, T>) {
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

    /// samples of a depth += `weight` times a function of the field's elements; rows of samples are `row` numbers apart
    pub(super) fn add_at(
        &self,
        depth: usize,
        (samples, row): (&mut [T], usize),
        weight: T,
        value: impl Fn(usize) -> T,
    ) {
        let of_depth = &mut samples[depth * self.width() * row..][..self.width() * row];
        for (j, lanes) in of_depth.chunks_exact_mut(row).enumerate() {
            for (i, to) in lanes[..self.voxels].iter_mut().enumerate() {
                *to = *to + weight * value(j * self.voxels + i);
            }
        }
    }

    /// Multiplies the elements of the field by what samples of a depth ask.
    pub(super) fn multiply_by(
        &self,
        depth: usize,
        (samples, row): (&[T], usize),
        weight: T,
        field: &mut [Complex<T>],
    ) {
        let of_depth = &samples[depth * self.width() * row..][..self.width() * row];
        let lanes = of_depth.chunks_exact(row);
        for (lanes, field) in lanes.zip(field.chunks_exact_mut(self.voxels)) {
            for (&asked, value) in lanes.iter().zip(field) {
                *value = value.scale(weight * asked);
            }
        }
    }

    /// Multiplications and additions of the transforms of an image and of one depth, 5·n·log₂n for each of length n.
    pub(super) fn operations(&self) -> [f64; 2] {
        let of = |n: usize, times: usize| 5.0 * n as f64 * (n as f64).log2() * times as f64;
        let [mu, mz] = self.sampling.padded;
        let [_, nz] = self.counts();
        [
            of(mz, self.pixels[0]) + of(mu, nz),
            of(self.sampling.fine, nz) + of(self.heights.2, self.width()),
        ]
    }
}

/// What a transform works on.
pub(super) struct Parts<'a, T: Number> {
    mixed: &'a mut [Complex<T>],
    lines: &'a mut [Complex<T>],
    field: &'a mut [Complex<T>],
    rest: &'a mut [Complex<T>],
}

impl<T: Number> Scratch<T> {
    pub(super) fn split(&mut self) -> (&[Complex<T>], Parts<'_, T>) {
        let parts = Parts {
            mixed: &mut self.mixed,
            lines: &mut self.lines,
            field: &mut self.field,
            rest: &mut self.rest,
        };
        (&self.here, parts)
    }
}
