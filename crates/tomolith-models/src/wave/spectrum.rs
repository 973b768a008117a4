//! Fourier transforms of the frames of one light, with as little of each as is needed.
//!
//! Only frequencies within the band are kept. A field is transformed along z first, for every frequency along u, then along u at the heights of voxels
//! only: lateral samples lie closer than pixels, and fewer lines are as long. What happens to a spectrum on its way to a depth is not known here: [`coherent`](super::coherent),
//! [`cones`](super::cones).

use super::depth_interpolation::InterpolationBuffers;
use super::number::Number;
use super::sampling::Sampling;
use super::window::{Side, operations};
use std::f64::consts::TAU;
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::waves::{Axis, Comb, Transforms};
use tomolith_fourier::Complex;
use tomolith_fourier::Fft;

/// Transforms of the frames of one light.
pub(super) struct Windows<T: Number> {
    pub(super) sampling: Sampling,
    pixels: [usize; 2],
    /// Length of the window along u and z, mm.
    pub(super) window: [f64; 2],
    /// Shift of the heights, and the scale of the transforms, one per frequency along z.
    shifts: Vec<Complex<T>>,
    /// Lateral samples that are computed.
    samples: Range<i64>,
    /// Those that voxels are interpolated from.
    pub(super) last: Axis,
    /// First pixel along u, mm.
    from: f64,
    /// Sample of a voxel's height: first, and the way to the next, in a window of `heights.2`.
    heights: (usize, usize, usize),
    pub(super) voxels: usize,
    forward: [Arc<dyn Fft<T>>; 2],
    inverse: [Arc<dyn Fft<T>>; 2],
    fine_forward: [Arc<dyn Fft<T>>; 2],
    fine_inverse: [Arc<dyn Fft<T>>; 2],
}

/// Lines that are moved together: a cache line.
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
    /// Frequencies along u × heights of voxels, or frequencies along z × pixels.
    mixed: Vec<Complex<T>>,
    lines: Vec<Complex<T>>,
    /// Lateral samples × voxels along z.
    pub(super) field: Vec<Complex<T>>,
    rest: Vec<Complex<T>>,
    /// Fields at the last depths, and those between them.
    pub(super) interpolation: InterpolationBuffers<T>,
    /// Light at all depths and lateral samples that are computed.
    pub(super) computed: Vec<T>,
    /// Light at closer lateral samples.
    pub(super) between: Vec<T>,
    /// What voxels ask of the samples they are interpolated from.
    pub(super) samples: Vec<T>,
}

#[cfg(test)]
impl<T: Number> Scratch<T> {
    /// Of all arrays.
    pub(super) fn bytes(&self) -> usize {
        let fields = [
            &self.spectrum,
            &self.here,
            &self.power,
            &self.sum,
            &self.mixed,
            &self.lines,
            &self.field,
            &self.rest,
        ];
        let complex: usize = fields.iter().map(|all| all.capacity()).sum();
        let real = [&self.computed, &self.between, &self.samples];
        let real: usize = real.iter().map(|all| all.capacity()).sum();
        (2 * complex + real) * std::mem::size_of::<T>() + self.interpolation.bytes()
    }
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

/// Where a transform of length n > `band` holds frequency `i` − `band`; it repeats after n.
fn placed(i: usize, band: usize, n: usize) -> usize {
    if i < band { n - band + i } else { i - band }
}

/// Frequencies from −`band` to `band`, as a transform holds them.
fn spread<T: Number>(from: &[Complex<T>], band: usize, line: &mut [Complex<T>]) {
    let n = line.len();
    line[band + 1..n - band].fill(zero());
    line[n - band..].copy_from_slice(&from[..band]);
    line[..=band].copy_from_slice(&from[band..]);
}

/// The inverse of [`spread`].
fn collect<T: Number>(line: &[Complex<T>], band: usize, to: &mut [Complex<T>]) {
    to[..band].copy_from_slice(&line[line.len() - band..]);
    to[band..].copy_from_slice(&line[..=band]);
}

/// Lateral samples that voxels are interpolated from, and the indices of those that are computed, counted from the first pixel.
fn lateral(sampling: &Sampling, u: &Side) -> (Axis, Range<i64>) {
    let across = &sampling.across;
    let index = |mm: f64| (mm - u.from) / across.computed.step;
    let half = across.taps.taps as i64 / 2;
    let [low, high] = u.voxels_at(0.0);
    let Some((closer, taps)) = &across.closer else {
        let samples = index(low).floor() as i64 - half..index(high).ceil() as i64 + half + 1;
        let last = Axis {
            from: u.from + samples.start as f64 * across.computed.step,
            step: across.computed.step,
            count: (samples.end - samples.start) as usize,
        };
        return (last, samples);
    };
    let last = Axis {
        from: low - half as f64 * closer.step,
        step: closer.step,
        count: closer.count,
    };
    let (end, half) = (
        last.from + closer.count as f64 * closer.step,
        taps.taps as i64 / 2,
    );
    let samples = index(last.from).floor() as i64 - half..index(end).ceil() as i64 + half + 1;
    (last, samples)
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
        heights: Heights,
        voxels: usize,
    ) -> Self {
        let window = [
            sampling.padded[0] as f64 * u.pitch,
            sampling.padded[1] as f64 * z.pitch,
        ];
        let fine_z = sampling.padded[1] * heights.finer;
        let sample_z = window[1] / fine_z as f64;
        // The first voxel's height in samples above the first row of pixels
        let place = (z.voxels_at(0.0)[0] - z.from) / sample_z;
        let whole = place.round();
        let shift = (place - whole) * sample_z;
        let first = (whole as i64).rem_euclid(fine_z as i64) as usize;
        let scale = 1.0 / (sampling.padded[0] * sampling.padded[1]) as f64;
        let bz = sampling.band[1] as i64;
        let shifts = (-bz..=bz)
            .map(|f| complex((TAU * f as f64 / window[1] * shift).sin_cos(), scale))
            .collect();
        let (last, samples) = lateral(&sampling, u);
        let both = |lengths: [usize; 2]| {
            let [[forward_u, inverse_u], [forward_z, inverse_z]] = lengths.map(T::transforms);
            ([forward_u, forward_z], [inverse_u, inverse_z])
        };
        let (forward, inverse) = both(sampling.padded);
        let (fine_forward, fine_inverse) = both([sampling.across.computed.count, fine_z]);
        Windows {
            pixels: [u.pixels, z.pixels],
            window,
            shifts,
            samples,
            last,
            from: u.from,
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

    /// Lateral samples that are computed.
    pub(super) fn width(&self) -> usize {
        (self.samples.end - self.samples.start) as usize
    }

    pub(super) fn computed(&self) -> Axis {
        let step = self.sampling.across.computed.step;
        Axis {
            from: self.from + self.samples.start as f64 * step,
            step,
            count: self.width(),
        }
    }

    pub(super) fn scratch(&self) -> Scratch<T> {
        let [nu, nz] = self.counts();
        let [mu, mz] = self.sampling.padded;
        let longest = mu
            .max(mz)
            .max(self.sampling.across.computed.count)
            .max(self.heights.2);
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
            mixed: vec![zero(); self.mixed()],
            lines: vec![zero(); TOGETHER * longest],
            field: vec![zero(); self.width() * self.voxels],
            rest: vec![zero(); rest.unwrap_or(0)],
            interpolation: InterpolationBuffers::default(),
            computed: Vec::new(),
            between: Vec::new(),
            samples: Vec::new(),
        }
    }

    /// Numbers between the two directions of a transform: frequencies along u × heights of voxels, or frequencies along z × pixels.
    pub(super) fn mixed(&self) -> usize {
        let [nu, nz] = self.counts();
        (nu * self.voxels).max(self.sampling.padded[0] * nz)
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
                mixed[i * mu + column] = line[placed(i, bz, mz)] * shift;
            }
        }
        for (row, to) in mixed
            .chunks_exact_mut(mu)
            .zip(spectrum.chunks_exact_mut(nu))
        {
            self.forward[0].process_with_scratch(row, rest);
            collect(row, bu, to);
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
            for (i, &v) in from.iter().enumerate() {
                let at = &mut row[placed(i, bu, mu)];
                *at = *at + v;
            }
            self.inverse[0].process_with_scratch(row, rest);
        }
        for column in 0..self.pixels[0] {
            let line = &mut lines[..mz];
            line.fill(zero());
            for (i, shift) in self.shifts.iter().enumerate() {
                let at = &mut line[placed(i, bz, mz)];
                *at = *at + mixed[i * mu + column] * shift.conj();
            }
            self.inverse[1].process_with_scratch(line, rest);
            take(column, &line[..self.pixels[1]]);
        }
    }

    /// `scratch.field` = the field of a spectrum at the lateral samples and the heights of the voxels.
    pub(super) fn field(&self, from: &[Complex<T>], parts: Parts<'_, T>) {
        let [nu, _] = self.counts();
        let [bu, bz] = self.sampling.band;
        let (fine, (start, stride, high)) = (self.sampling.across.computed.count, self.heights);
        let Parts {
            mixed,
            lines,
            field,
            rest,
        } = parts;
        for first in (0..nu).step_by(TOGETHER) {
            let group = first..(first + TOGETHER).min(nu);
            let lines = &mut lines[..group.len() * high];
            lines.fill(zero());
            for (iz, row) in from.chunks_exact(nu).enumerate() {
                let at = placed(iz, bz, high);
                for (line, &v) in lines.chunks_exact_mut(high).zip(&row[group.clone()]) {
                    // Heights further apart than the band asks for see frequencies together
                    line[at] = line[at] + v;
                }
            }
            self.fine_inverse[1].process_with_scratch(lines, rest);
            let mut at = start;
            for to in mixed.chunks_exact_mut(nu).take(self.voxels) {
                for (to, line) in to[group.clone()].iter_mut().zip(lines.chunks_exact(high)) {
                    *to = line[at];
                }
                at = next(at, stride, high);
            }
        }
        let first = self.samples.start.rem_euclid(fine as i64) as usize;
        let heights = mixed[..self.voxels * nu].chunks(TOGETHER * nu);
        for (group, rows) in heights.enumerate() {
            let count = rows.len() / nu;
            for (line, row) in lines.chunks_exact_mut(fine).zip(rows.chunks_exact(nu)) {
                spread(row, bu, line);
            }
            self.fine_inverse[0].process_with_scratch(&mut lines[..count * fine], rest);
            let mut at = first;
            for to in field.chunks_exact_mut(self.voxels).take(self.width()) {
                for (i, to) in to[group * TOGETHER..][..count].iter_mut().enumerate() {
                    *to = lines[i * fine + at];
                }
                at = next(at, 1, fine);
            }
        }
    }

    /// The adjoint of [`field`](Self::field): `onto` = the spectrum of a field.
    pub(super) fn field_back(&self, onto: &mut [Complex<T>], parts: Parts<'_, T>) {
        let [nu, _] = self.counts();
        let [bu, bz] = self.sampling.band;
        let (fine, (start, stride, high)) = (self.sampling.across.computed.count, self.heights);
        let Parts {
            mixed,
            lines,
            field,
            rest,
        } = parts;
        let first = self.samples.start.rem_euclid(fine as i64) as usize;
        let heights = mixed[..self.voxels * nu].chunks_mut(TOGETHER * nu);
        for (group, rows) in heights.enumerate() {
            let count = rows.len() / nu;
            lines[..count * fine].fill(zero());
            let mut at = first;
            for from in field.chunks_exact(self.voxels).take(self.width()) {
                for (i, &from) in from[group * TOGETHER..][..count].iter().enumerate() {
                    lines[i * fine + at] = lines[i * fine + at] + from;
                }
                at = next(at, 1, fine);
            }
            self.fine_forward[0].process_with_scratch(&mut lines[..count * fine], rest);
            for (line, row) in lines.chunks_exact(fine).zip(rows.chunks_exact_mut(nu)) {
                collect(line, bu, row);
            }
        }
        for first in (0..nu).step_by(TOGETHER) {
            let group = first..(first + TOGETHER).min(nu);
            let lines = &mut lines[..group.len() * high];
            lines.fill(zero());
            let mut at = start;
            for from in mixed.chunks_exact(nu).take(self.voxels) {
                for (&from, line) in from[group.clone()].iter().zip(lines.chunks_exact_mut(high)) {
                    line[at] = from;
                }
                at = next(at, stride, high);
            }
            self.fine_forward[1].process_with_scratch(lines, rest);
            for (iz, row) in onto.chunks_exact_mut(nu).enumerate() {
                let at = placed(iz, bz, high);
                for (line, v) in lines.chunks_exact(high).zip(&mut row[group.clone()]) {
                    *v = line[at];
                }
            }
        }
    }

    /// samples of a depth += `weight` times a function of the field's elements; rows of samples are `row` numbers apart
    pub(super) fn add_at(
        &self,
        depth: usize,
        samples: &mut [T],
        row: usize,
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
        samples: &[T],
        row: usize,
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

    /// Multiplications and additions of the transforms of an image and of one depth.
    pub(super) fn operations(&self) -> [f64; 2] {
        let cost_of = |n: usize, times: usize| operations(n as f64) * times as f64;
        let [mu, mz] = self.sampling.padded;
        let [nu, nz] = self.counts();
        [
            cost_of(mz, self.pixels[0]) + cost_of(mu, nz),
            cost_of(self.heights.2, nu) + cost_of(self.sampling.across.computed.count, self.voxels),
        ]
    }
}

impl Windows<f32> {
    pub(super) fn form(&self) -> Transforms {
        let lateral = self.sampling.across.computed.count;
        let (first, stride, high) = self.heights;
        Transforms {
            padded: self.sampling.padded,
            band: self.sampling.band,
            shifts: self.shifts.iter().map(|s| [s.re, s.im]).collect(),
            samples: [
                Comb {
                    length: lateral,
                    first: self.samples.start.rem_euclid(lateral as i64) as usize,
                    stride: 1,
                    count: self.width(),
                },
                Comb {
                    length: high,
                    first,
                    stride,
                    count: self.voxels,
                },
            ],
        }
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
