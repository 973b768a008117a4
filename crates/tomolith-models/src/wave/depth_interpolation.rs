//! Fields at depths between those that are transformed.
//!
//! # Equation
//! |ψ|² changes along the depth by the difference of two frequencies of ψ: it has twice the band, and wants twice as many depths. So
//! ψ is transformed at few depths, turned back by the middle of its band, and interpolated at those where |ψ|² is wanted:
//! ```text
//! ψ(x)·e^(2πi c x) = Σ_k w_k(x)·ψ_k,        ψ_(−1−k) = ψ_k*
//! ```
//! with the weights of [`Taps`](super::taps::Taps); the images before the focal plane are those of real patterns. The turn is not seen in |ψ|².
//! The adjoint, with the real product Re ψχ*, brings Σ_x w_k(x)·χ(x) to ψ_k, conjugated where its image was used.
//!
//! # Cost
//! Fields are too large to stay near: those of a few depths are summed together, block by block, with the kernel of [`Number::add_rows`]; real and
//! imaginary parts are rows of their own. Memory: the fields that those few are interpolated from, and on the way back those that are interpolated from them.

use super::number::Number;
use super::resample::mirrored;
use super::sampling::Sampling;
use super::spectrum::zero;
use std::ops::Range;
use tomolith_core::dose::waves::FieldTap;
use tomolith_core::field::LANES;
use tomolith_fourier::Complex;

/// A sum of fields: which, and the weights of their real and imaginary parts.
#[derive(Clone, Debug, Default)]
struct Sum<T> {
    fields: Vec<u32>,
    weights: [Vec<T>; 2],
}

impl<T: Number> Sum<T> {
    fn add(&mut self, field: usize, weight: f64, is_image: bool) {
        self.fields.push(field as u32);
        self.weights[0].push(T::of(weight));
        (self.weights[1]).push(T::of(if is_image { -weight } else { weight }));
    }
}

/// Depths whose fields wait for each other.
const TOGETHER: usize = 4;

/// Numbers of a row that are summed at a time.
const BLOCK: usize = 256;

/// The last few of a row of fields: real parts, then imaginary ones.
#[derive(Default)]
struct Ring<T> {
    numbers: Vec<T>,
    size: usize,
    /// Numbers of a row.
    row: usize,
}

impl<T: Number> Ring<T> {
    /// Keeps a field in place of the oldest one of so many.
    fn put(&mut self, index: usize, size: usize, field: &[Complex<T>]) {
        // An odd number of cache lines: the same block of all rows would else fall into one set of the cache
        self.row = (field.len().div_ceil(LANES) | 1) * LANES;
        self.size = size;
        self.numbers.resize(2 * size * self.row, T::zero());
        let slot = &mut self.numbers[2 * (index % size) * self.row..][..2 * self.row];
        let (re, im) = slot.split_at_mut(self.row);
        for ((re, im), v) in re.iter_mut().zip(im).zip(field) {
            (*re, *im) = (v.re, v.im);
        }
    }

    /// Each of `outs` = a sum of those that are kept, with `len` numbers.
    fn sums(&self, sums: &[Sum<T>], len: usize, outs: &mut Vec<Vec<Complex<T>>>) {
        outs.resize_with(outs.len().max(sums.len()), Vec::new);
        let rows = |sum: &Sum<T>| {
            [0, 1].map(|part| {
                let row_of = |field: &u32| 2 * (field % self.size as u32) + part;
                sum.fields.iter().map(row_of).collect::<Vec<u32>>()
            })
        };
        let slots: Vec<[Vec<u32>; 2]> = sums.iter().map(rows).collect();
        for out in &mut outs[..sums.len()] {
            out.resize(len, zero());
        }
        for first in (0..len).step_by(BLOCK) {
            // 0 where no field was kept: then all sums are 0
            let lanes = self.row.saturating_sub(first).min(BLOCK);
            for ((sum, slots), out) in sums.iter().zip(&slots).zip(outs.iter_mut()) {
                let mut parts = [[T::zero(); BLOCK]; 2];
                for ((to, slots), weights) in parts.iter_mut().zip(slots).zip(&sum.weights) {
                    T::add_rows(to, &self.numbers, slots, weights, self.row, first, lanes);
                }
                let [re, im] = &parts;
                for ((out, &re), &im) in out[first..].iter_mut().zip(re).zip(im) {
                    *out = Complex::new(re, im);
                }
            }
        }
    }
}

/// Interpolation of fields between the depths that are transformed.
pub(super) struct DepthInterpolation<T> {
    /// What each is interpolated from.
    forth: Vec<Sum<T>>,
    /// What is asked of each that is transformed.
    back: Vec<Sum<T>>,
    /// First of the fields that each is interpolated from; below 0: images.
    first: Vec<i64>,
    taps: usize,
    /// Fields between that are kept on the way back.
    ring_size: usize,
}

/// Buffers: fields of the last depths that were transformed, and what was sent back between them.
#[derive(Default)]
pub(super) struct InterpolationBuffers<T> {
    fields: Ring<T>,
    sent: Ring<T>,
    /// Fields between, or what is asked of those that are transformed.
    pub(super) now: Vec<Vec<Complex<T>>>,
}

#[cfg(test)]
impl<T> InterpolationBuffers<T> {
    /// Of all arrays.
    pub(super) fn bytes(&self) -> usize {
        let now: usize = self.now.iter().map(Vec::capacity).sum();
        let rings = self.fields.numbers.capacity() + self.sent.numbers.capacity();
        (2 * now + rings) * std::mem::size_of::<T>()
    }
}

impl<T: Number> DepthInterpolation<T> {
    /// None where fields are transformed at all depths that are wanted.
    pub(super) fn new(sampling: &Sampling) -> Option<Self> {
        let fields = sampling.fields.as_ref()?;
        let wanted = sampling.along.computed;
        let mut interpolation = DepthInterpolation {
            forth: vec![Sum::default(); wanted.count],
            back: vec![Sum::default(); fields.depths.count],
            first: Vec::with_capacity(wanted.count),
            taps: fields.taps.taps,
            ring_size: 0,
        };
        let mut weights = Vec::new();
        for index in 0..wanted.count {
            let place = fields.depths.place(wanted.at(index));
            let first = fields.taps.at(place, &mut weights);
            interpolation.first.push(first);
            for (slot, &weight) in (first..).zip(&weights) {
                let depth = mirrored(slot);
                interpolation.forth[index].add(depth, weight, slot < 0);
                interpolation.back[depth].add(index, weight, slot < 0);
            }
        }
        interpolation.ring_size = interpolation.most_kept();
        Some(interpolation)
    }

    /// Both sums as data.
    pub(super) fn form(&self) -> [Vec<Vec<FieldTap>>; 2]
    where
        T: Into<f32>,
    {
        let taps_of = |sum: &Sum<T>| {
            let weights = sum.weights[0].iter().zip(&sum.weights[1]);
            let taps = sum.fields.iter().zip(weights);
            taps.map(|(&field, (&re, &im))| FieldTap {
                field,
                weights: [re.into(), im.into()],
            })
            .collect()
        };
        [&self.forth, &self.back].map(|sums| sums.iter().map(taps_of).collect())
    }

    /// How many fields between those that are sent back at once wait for.
    fn most_kept(&self) -> usize {
        let (mut most, mut next, mut sent) = (1, 0, 0);
        for depth in 0..self.back.len() {
            next = self.ready(next, depth).end;
            let done = self.done(sent, next);
            let waiting = self.back[done.clone()].iter().flat_map(|sum| &sum.fields);
            most = most.max(waiting.min().map_or(0, |lowest| next - *lowest as usize));
            sent = done.end;
        }
        most
    }

    /// Fields between, from `next` on, that can be had once a depth is transformed: those of a few depths at once.
    pub(super) fn ready(&self, next: usize, depth: usize) -> Range<usize> {
        let is_last = depth + 1 == self.back.len();
        if !is_last && !(depth + 1).is_multiple_of(TOGETHER) {
            return next..next;
        }
        let is_ready = |first: &&i64| **first + self.taps as i64 <= depth as i64 + 1;
        next..next + self.first[next..].iter().take_while(is_ready).count()
    }

    /// Depths, from `sent` on, of which no field between from `next` on asks anything.
    pub(super) fn done(&self, sent: usize, next: usize) -> Range<usize> {
        let first = self.first.get(next).map(|first| (*first).max(0) as usize);
        sent..first.unwrap_or(self.back.len()).max(sent)
    }

    /// Keeps the field of a depth that was transformed.
    pub(super) fn keep(
        &self,
        depth: usize,
        field: &[Complex<T>],
        buffers: &mut InterpolationBuffers<T>,
    ) {
        buffers.fields.put(depth, self.taps + TOGETHER, field);
    }

    /// `buffers.now` = these fields, of `len` numbers
    pub(super) fn forth(
        &self,
        which: Range<usize>,
        len: usize,
        buffers: &mut InterpolationBuffers<T>,
    ) {
        let InterpolationBuffers { fields, now, .. } = buffers;
        fields.sums(&self.forth[which], len, now);
    }

    /// Keeps what `buffers.now` sends back from these fields.
    pub(super) fn send(&self, which: Range<usize>, buffers: &mut InterpolationBuffers<T>) {
        let InterpolationBuffers { sent, now, .. } = buffers;
        for (index, field) in which.zip(now) {
            sent.put(index, self.ring_size, field);
        }
    }

    /// `buffers.now` = what was sent back to these depths
    pub(super) fn back(
        &self,
        which: Range<usize>,
        len: usize,
        buffers: &mut InterpolationBuffers<T>,
    ) {
        let InterpolationBuffers { sent, now, .. } = buffers;
        sent.sums(&self.back[which], len, now);
    }
}

#[cfg(test)]
mod tests {
    use super::super::lattice::Lattice;
    use super::super::sampling::{Fields, Ladder};
    use super::super::taps::{Ends, Signal, Taps};
    use super::*;
    use std::f64::consts::TAU;
    use tomolith_core::near;

    /// 30 depths a step apart, 50 wanted ones, of light whose field has frequencies up to 0.3.
    fn sampling() -> Sampling {
        let lattice = |step: f64, count: usize| Lattice {
            start: 0.0,
            step,
            count,
            ends: Ends::Mirrored,
        };
        let lines = (-100..100).map(|i| ((f64::from(i) + 0.5) / 100.0 * 0.3, 1.0));
        let signal = Signal::of_field(lines.clone(), lines.take(1));
        let (depths, wanted) = (lattice(1.0, 30), lattice(0.59, 50));
        let ladder = |lattice: Lattice| Ladder {
            computed: lattice,
            closer: None,
            taps: Taps::new(4, &signal, &lattice),
        };
        Sampling {
            padded: [2, 2],
            guard: [1.0; 2],
            band: [1, 1],
            fields: Some(Fields {
                depths,
                middle: 0.0,
                taps: Taps::new(8, &signal, &depths),
            }),
            along: ladder(wanted),
            across: ladder(wanted),
        }
    }

    /// All fields between; then what is sent back to all depths when `cotangent` is asked of them.
    fn pass(
        interpolation: &DepthInterpolation<f64>,
        fields: &[Vec<Complex<f64>>],
        cotangent: impl Fn(usize, usize) -> Complex<f64>,
    ) -> [Vec<Vec<Complex<f64>>>; 2] {
        let (mut buffers, mut next, mut sent) = (InterpolationBuffers::default(), 0, 0);
        let [mut all, mut back] = [Vec::new(), Vec::new()];
        for (depth, field) in fields.iter().enumerate() {
            interpolation.keep(depth, field, &mut buffers);
            let ready = interpolation.ready(next, depth);
            interpolation.forth(ready.clone(), field.len(), &mut buffers);
            for (index, field) in ready.clone().zip(&mut buffers.now) {
                all.push(field.clone());
                for (i, v) in field.iter_mut().enumerate() {
                    *v = cotangent(index, i);
                }
            }
            next = ready.end;
            interpolation.send(ready, &mut buffers);
            let done = interpolation.done(sent, next);
            sent = done.end;
            interpolation.back(done.clone(), field.len(), &mut buffers);
            back.extend_from_slice(&buffers.now[..done.len()]);
        }
        [all, back]
    }

    #[test]
    fn waves_of_real_patterns_are_met_and_what_is_sent_back_is_the_transpose() {
        let sampling = sampling();
        let interpolation = DepthInterpolation::<f64>::new(&sampling).unwrap();
        // Field i at depth x: a wave of a frequency below 0.25, real at the focus, so that its image is its conjugate
        let wave = |i: usize, x: f64| {
            Complex::from_polar(1.0, TAU * x * 0.25 * (i as f64 / 299.0 - 0.5) * 2.0)
        };
        let fields: Vec<Vec<Complex<f64>>> = (0..30)
            .map(|k| (0..300).map(|i| wave(i, k as f64 + 0.5)).collect())
            .collect();
        let noise = |k: usize, i: usize| {
            let at =
                |j: usize| ((k * 7919 + i * 104_729 + j * 15_485_863) % 1009) as f64 / 504.0 - 1.0;
            Complex::new(at(0), at(1))
        };
        let [all, back] = pass(&interpolation, &fields, noise);
        assert_eq!((all.len(), back.len()), (50, 30));
        for (k, field) in all.iter().enumerate() {
            for (i, v) in field.iter().enumerate() {
                let expected = wave(i, (k as f64 + 0.5) * 0.59);
                assert!((v - expected).norm() < 0.02, "{k} {i}: {v} {expected}");
            }
        }
        let product = |a: Complex<f64>, b: Complex<f64>| (a * b.conj()).re;
        let asked: f64 = (all.iter().enumerate())
            .flat_map(|(k, field)| {
                field
                    .iter()
                    .enumerate()
                    .map(move |(i, v)| product(*v, noise(k, i)))
            })
            .sum();
        let found: f64 = (fields.iter().zip(&back))
            .flat_map(|(a, b)| a.iter().zip(b).map(|(a, b)| product(*a, *b)))
            .sum();
        near!(asked, found, 1e-9 * 50.0 * 300.0);
    }
}
