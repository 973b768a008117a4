//! Sampling lattice of waves: spacing, and the number of samples that an error needs.
//!
//! Depths lie at (k + ½) steps from the focal plane, their mirror images on its other side. Where the focal plane lies outside the part, they begin
//! at the nearest voxel instead.

use super::taps::{Ends, OVERHANG, Signal, Taps};

/// Samples at start + (k + ½) steps, k = 0 … count − 1; lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lattice {
    pub(super) start: f64,
    pub(super) step: f64,
    pub(super) count: usize,
    pub(super) ends: Ends,
}

impl Lattice {
    /// Where a sample lies.
    pub(super) fn at(&self, index: usize) -> f64 {
        self.start + (index as f64 + 0.5) * self.step
    }

    /// A place in samples.
    pub(super) fn place(&self, mm: f64) -> f64 {
        (mm - self.start) / self.step - 0.5
    }

    /// `count` depths that serve those from `nearest` to `deepest`.
    fn of_depths([nearest, deepest]: [f64; 2], ends: Ends, count: usize) -> Self {
        let (step, start) = if ends == Ends::Both {
            let step = (deepest - nearest) / (count as f64 - 1.0 + 2.0 * OVERHANG);
            (step, nearest + (OVERHANG - 0.5) * step)
        } else {
            (deepest / (count as f64 - 0.5 + OVERHANG), 0.0)
        };
        Lattice {
            start,
            step,
            count,
            ends,
        }
    }

    /// The fewest depths that hold a signal from `depths[0]` to `depths[1]` with such an error, and no more than `most`.
    pub(super) fn fewest(
        taps: usize,
        signal: &Signal,
        depths: [f64; 2],
        error: f64,
        most: f64,
    ) -> Self {
        let lattice_with =
            |ends: Ends| Lattice::fewest_with(taps, signal, depths, ends, error, most);
        let mirrored = lattice_with(Ends::Mirrored);
        if depths[0] > 0.0 && depths[1] > depths[0] {
            let both = lattice_with(Ends::Both);
            if both.count < mirrored.count {
                return both;
            }
        }
        mirrored
    }

    fn fewest_with(
        taps: usize,
        signal: &Signal,
        depths: [f64; 2],
        ends: Ends,
        error: f64,
        most: f64,
    ) -> Self {
        let least = if ends == Ends::Both { taps } else { taps / 2 };
        let lattice = |count: usize| Lattice::of_depths(depths, ends, count);
        let holds = |count: usize| Taps::error_in_disc(taps, signal, &lattice(count)) <= error;
        let mut enough = least;
        while !holds(enough) && (enough as f64) < most {
            enough *= 2;
        }
        let mut short = (enough / 2).max(least - 1);
        while enough - short > 1 {
            let middle = usize::midpoint(enough, short);
            if holds(middle) {
                enough = middle;
            } else {
                short = middle;
            }
        }
        lattice(enough)
    }
}
