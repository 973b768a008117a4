//! From the samples that are computed to closer ones, and back: the same for all frames.
//!
//! # Equation
//! ```text
//! closer[k'][j'][z] = Σ_k c_k(k') Σ_j b_j(j')·computed[k][j][z]
//! ```
//! with the weights of [`Taps`]: first along u at every depth, then along the depths, which are mirrored about the focal plane. Each is there only
//! where it saves time ([`sampling`](super::sampling)).

use super::number::Number;
use super::sampling::Sampling;
use super::taps::Taps;
use tomolith_core::dose::waves::{Axis, Interpolation, SparseRows};

/// Index of a depth: those before the focal plane are mirror images of those behind it.
pub(super) fn mirrored(depth: i64) -> usize {
    (if depth < 0 { -1 - depth } else { depth }) as usize
}

/// A sparse matrix, row by row.
struct Rows<T> {
    starts: Vec<u32>,
    slots: Vec<u32>,
    weights: Vec<T>,
}

impl<T: Number> Rows<T> {
    fn of(rows: &[Vec<(u32, f64)>]) -> Self {
        let mut starts = vec![0];
        starts.extend(rows.iter().scan(0, |at, row| {
            *at += row.len() as u32;
            Some(*at)
        }));
        Rows {
            starts,
            slots: rows.iter().flatten().map(|(slot, _)| *slot).collect(),
            weights: rows.iter().flatten().map(|(_, w)| T::of(*w)).collect(),
        }
    }

    /// out = these combinations of blocks of `source`: block i is `rows` rows of `row` numbers
    fn apply(&self, source: &[T], out: &mut [T], rows: usize, row: usize) {
        out.fill(T::zero());
        let mut slots = Vec::new();
        // Row by row, so that what is combined is near
        for j in 0..rows {
            for (i, range) in self.starts.windows(2).enumerate() {
                let entries = range[0] as usize..range[1] as usize;
                let of_row = |&slot: &u32| slot * rows as u32 + j as u32;
                slots.clear();
                slots.extend(self.slots[entries.clone()].iter().map(of_row));
                let to = &mut out[(i * rows + j) * row..][..row];
                T::add_rows(to, source, &slots, &self.weights[entries], row, 0, row);
            }
        }
    }
}

impl Rows<f32> {
    fn form(&self) -> SparseRows {
        let entries = self.slots.iter().zip(&self.weights);
        SparseRows {
            starts: self.starts.clone(),
            entries: entries.map(|(&slot, &weight)| (slot, weight)).collect(),
        }
    }
}

/// An interpolation and its transpose.
struct Step<T> {
    forth: Rows<T>,
    back: Rows<T>,
    /// Blocks before and after.
    counts: [usize; 2],
}

impl<T: Number> Step<T> {
    /// `places`: of what is wanted, in samples; `index`: where a sample is kept.
    fn new(taps: &Taps, from: usize, places: &[f64], index: impl Fn(i64) -> usize) -> Self {
        let mut weights = Vec::new();
        let mut forth = Vec::with_capacity(places.len());
        let mut back = vec![Vec::new(); from];
        for (i, &place) in places.iter().enumerate() {
            let first = taps.at(place, &mut weights);
            let slots = (first..).map(|slot| index(slot) as u32);
            let entries: Vec<(u32, f64)> = slots.zip(weights.iter().copied()).collect();
            for &(slot, weight) in &entries {
                back[slot as usize].push((i as u32, weight));
            }
            forth.push(entries);
        }
        Step {
            forth: Rows::of(&forth),
            back: Rows::of(&back),
            counts: [from, places.len()],
        }
    }
}

impl Step<f32> {
    fn form(&self) -> Interpolation {
        Interpolation {
            forth: self.forth.form(),
            back: self.back.form(),
        }
    }
}

/// The interpolations of one light.
pub(super) struct Resample<T> {
    across: Option<Step<T>>,
    along: Option<Step<T>>,
    /// Depths that are computed, and samples along u after the first step.
    depths: usize,
    width: usize,
}

impl Resample<f32> {
    /// The interpolations as data: along u, along the depth.
    pub(super) fn form(&self) -> [Option<Interpolation>; 2] {
        [&self.across, &self.along].map(|step| step.as_ref().map(Step::form))
    }
}

impl<T: Number> Resample<T> {
    /// `computed` and `last`: samples along u, before and after.
    pub(super) fn new(sampling: &Sampling, computed: Axis, last: Axis) -> Self {
        let across = sampling.across.closer.as_ref().map(|(_, taps)| {
            let at = |i: usize| (last.from + i as f64 * last.step - computed.from) / computed.step;
            let places: Vec<f64> = (0..last.count).map(at).collect();
            Step::new(taps, computed.count, &places, |slot| slot as usize)
        });
        let depths = sampling.along.computed;
        let along = sampling.along.closer.as_ref().map(|(closer, taps)| {
            let at = |k: usize| depths.place(closer.at(k));
            let places: Vec<f64> = (0..closer.count).map(at).collect();
            Step::new(taps, depths.count, &places, mirrored)
        });
        Resample {
            across,
            along,
            depths: depths.count,
            width: last.count,
        }
    }

    /// Whether samples are used as they are computed.
    pub(super) fn is_idle(&self) -> bool {
        self.across.is_none() && self.along.is_none()
    }

    /// `last` = what follows from the computed samples; rows of `row` numbers.
    pub(super) fn forth(&self, computed: &[T], last: &mut [T], between: &mut Vec<T>, row: usize) {
        match (&self.across, &self.along) {
            (Some(across), None) => self.across(across, computed, last, row),
            (None, Some(along)) => along.forth.apply(computed, last, self.width, row),
            (Some(across), Some(along)) => {
                between.resize(self.depths * self.width * row, T::zero());
                self.across(across, computed, between, row);
                along.forth.apply(between, last, self.width, row);
            }
            (None, None) => last.copy_from_slice(computed),
        }
    }

    /// The transpose of [`forth`](Self::forth).
    pub(super) fn back(&self, last: &[T], computed: &mut [T], between: &mut Vec<T>, row: usize) {
        match (&self.across, &self.along) {
            (Some(across), None) => self.across_back(across, last, computed, row),
            (None, Some(along)) => along.back.apply(last, computed, self.width, row),
            (Some(across), Some(along)) => {
                between.resize(self.depths * self.width * row, T::zero());
                along.back.apply(last, between, self.width, row);
                self.across_back(across, between, computed, row);
            }
            (None, None) => computed.copy_from_slice(last),
        }
    }

    fn across(&self, step: &Step<T>, from: &[T], to: &mut [T], row: usize) {
        let planes = from.chunks_exact(step.counts[0] * row);
        let to = to.chunks_exact_mut(step.counts[1] * row);
        for (from, to) in planes.zip(to).take(self.depths) {
            step.forth.apply(from, to, 1, row);
        }
    }

    fn across_back(&self, step: &Step<T>, from: &[T], to: &mut [T], row: usize) {
        let planes = from.chunks_exact(step.counts[1] * row);
        let to = to.chunks_exact_mut(step.counts[0] * row);
        for (from, to) in planes.zip(to).take(self.depths) {
            step.back.apply(from, to, 1, row);
        }
    }
}
