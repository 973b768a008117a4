//! Fields at depths between those that are transformed.
//!
//! # Equation
//! |ψ|² changes along the depth by the difference of two frequencies of ψ: it has twice the band, and wants twice as many depths. So
//! ψ is transformed at few depths, turned back by the middle of its band, and interpolated at those where |ψ|² is wanted:
//! ```text
//! ψ(x)·e^(2πi c x) = Σ_k w_k(x)·ψ_k,        ψ_(−1−k) = ψ_k*
//! ```
//! with the weights of [`Taps`](super::taps::Taps); the images before the focal plane are those of real patterns. The turn is not seen in |ψ|².
//! The adjoint, with the real product Re ψχ*, brings w_k·χ to the same fields.

use super::number::Number;
use super::resample::mirrored;
use super::sampling::Sampling;
use super::spectrum::zero;
use rustfft::num_complex::Complex;

/// Numbers of a field that stay in the nearest memory while they are summed.
const AT_ONCE: usize = 512;

/// How fields between are interpolated, depth by depth.
pub(super) struct Between<T> {
    /// First of the fields that each is interpolated from, and the weights.
    rows: Vec<(i64, Vec<T>)>,
    taps: usize,
}

/// Fields of the last depths that were transformed, those that are asked of them, and one between.
#[derive(Default)]
pub(super) struct Kept<T> {
    fields: Vec<Vec<Complex<T>>>,
    asked: Vec<Vec<Complex<T>>>,
    pub(super) between: Vec<Complex<T>>,
}

impl<T: Number> Kept<T> {
    /// Takes the field of a depth, and leaves another in its place that nobody needs any more.
    pub(super) fn take(&mut self, depth: usize, taps: usize, field: &mut Vec<Complex<T>>) {
        let len = field.len();
        self.fields.resize_with(taps, Vec::new);
        let own = &mut self.fields[depth % taps];
        own.resize(len, zero());
        std::mem::swap(own, field);
    }

    /// Nothing is asked of a depth yet.
    pub(super) fn clear_asked(&mut self, depth: usize, taps: usize, len: usize) {
        self.asked.resize_with(taps, Vec::new);
        let own = &mut self.asked[depth % taps];
        own.clear();
        own.resize(len, zero());
    }

    /// What is asked of a depth.
    pub(super) fn asked(&self, depth: usize) -> &[Complex<T>] {
        &self.asked[depth % self.asked.len()]
    }
}

impl<T: Number> Between<T> {
    /// None where fields are transformed at all depths that are wanted.
    pub(super) fn new(sampling: &Sampling) -> Option<Self> {
        let fields = sampling.fields.as_ref()?;
        let mut weights = Vec::new();
        let row = |k: usize| {
            let place = fields.depths.place(sampling.along.computed.at(k));
            let first = fields.taps.at(place, &mut weights);
            (first, weights.iter().map(|w| T::of(*w)).collect())
        };
        Some(Between {
            rows: (0..sampling.along.computed.count).map(row).collect(),
            taps: fields.taps.taps,
        })
    }

    /// Fields that one between is interpolated from.
    pub(super) fn taps(&self) -> usize {
        self.taps
    }

    /// Whether the field between of this index can be had once a depth is transformed.
    pub(super) fn is_ready(&self, index: usize, depth: usize) -> bool {
        (self.rows.get(index))
            .is_some_and(|(first, _)| first + (self.taps as i64) <= depth as i64 + 1)
    }

    /// Whether nobody asks anything of a depth from the field between of this index on.
    pub(super) fn is_done(&self, depth: usize, index: usize) -> bool {
        (self.rows.get(index)).is_none_or(|(first, _)| *first > depth as i64)
    }

    /// `kept.between` = the field of an index
    pub(super) fn forth(&self, index: usize, kept: &mut Kept<T>) {
        let (first, weights) = &self.rows[index];
        let Kept {
            fields, between, ..
        } = kept;
        between.resize(fields[mirrored(*first) % self.taps].len(), zero());
        for (block, to) in between.chunks_mut(AT_ONCE).enumerate() {
            to.fill(zero());
            for (slot, &weight) in (*first..).zip(weights) {
                let from = &fields[mirrored(slot) % self.taps][block * AT_ONCE..][..to.len()];
                let conjugate = if slot < 0 { -weight } else { weight };
                for (to, from) in to.iter_mut().zip(from) {
                    to.re = to.re + weight * from.re;
                    to.im = to.im + conjugate * from.im;
                }
            }
        }
    }

    /// What `kept.between` asks of the fields that it was interpolated from.
    pub(super) fn back(&self, index: usize, kept: &mut Kept<T>) {
        let (first, weights) = &self.rows[index];
        let Kept { asked, between, .. } = kept;
        for (block, from) in between.chunks(AT_ONCE).enumerate() {
            for (slot, &weight) in (*first..).zip(weights) {
                let to = &mut asked[mirrored(slot) % self.taps][block * AT_ONCE..][..from.len()];
                let conjugate = if slot < 0 { -weight } else { weight };
                for (to, from) in to.iter_mut().zip(from) {
                    to.re = to.re + weight * from.re;
                    to.im = to.im + conjugate * from.im;
                }
            }
        }
    }
}
