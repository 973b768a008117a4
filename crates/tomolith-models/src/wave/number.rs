//! The two kinds of number that the kernels are written for: f32 at work, f64 as the reference.

use crate::parallel::kernel::{Block, Entries, Isa, MAX_BLOCK, accumulate};
use std::sync::Arc;
use tomolith_core::field::LANES;
use tomolith_fourier::{Fft, FftNum};

/// A real number of the wave model.
pub(super) trait Number: FftNum + Default {
    /// The nearest number of this kind.
    fn of(value: f64) -> Self;

    /// Fourier transforms of a length, there and back.
    fn transforms(length: usize) -> [Arc<dyn Fft<Self>>; 2];

    /// out[z] += Σ weights[i]·source[slots[i]][z], for so many lanes from the first on, at which `out` begins; rows of `source` are `row` numbers apart.
    fn add_rows(
        out: &mut [Self],
        source: &[Self],
        slots: &[u32],
        weights: &[Self],
        row: usize,
        first: usize,
        lanes: usize,
    ) {
        add_plainly(out, source, slots, weights, row, first, lanes);
    }
}

/// The plain loop of [`Number::add_rows`].
fn add_plainly<T: Number>(
    out: &mut [T],
    source: &[T],
    slots: &[u32],
    weights: &[T],
    row: usize,
    first: usize,
    lanes: usize,
) {
    for (&slot, &weight) in slots.iter().zip(weights) {
        let from = &source[slot as usize * row + first..][..lanes];
        for (o, &s) in out[..lanes].iter_mut().zip(from) {
            *o = *o + weight * s;
        }
    }
}

#[cfg(test)]
impl Number for f64 {
    fn of(value: f64) -> Self {
        value
    }

    fn transforms(length: usize) -> [Arc<dyn Fft<f64>>; 2] {
        let mut plans = rustfft::FftPlanner::new();
        [
            plans.plan_fft_forward(length),
            plans.plan_fft_inverse(length),
        ]
    }
}

impl Number for f32 {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn of(value: f64) -> Self {
        value as f32
    }

    fn transforms(length: usize) -> [Arc<dyn Fft<f32>>; 2] {
        tomolith_fourier::complex(length)
    }

    fn add_rows(
        out: &mut [f32],
        source: &[f32],
        slots: &[u32],
        weights: &[f32],
        row: usize,
        first: usize,
        lanes: usize,
    ) {
        if !row.is_multiple_of(LANES) {
            return add_plainly(out, source, slots, weights, row, first, lanes);
        }
        let entries = Entries { slots, weights };
        for begin in (0..lanes).step_by(MAX_BLOCK * LANES) {
            let count = (lanes - begin).div_ceil(LANES).min(MAX_BLOCK);
            let block = Block {
                row: row / LANES,
                first: (first + begin) / LANES,
                count,
            };
            accumulate(Isa::in_use(), &mut out[begin..], source, entries, block);
        }
    }
}
