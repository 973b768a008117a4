//! Working memory of frames in addition to patterns and doses, estimated before it is allocated.
//!
//! # Equation
//! ```text
//! bytes = kernels + samples of frames that are gathered together + threads · (scratches of a dose along a line + samples asked by voxels)
//! ```
//! Large where there are many depths: 0.8 GB a thread for 550 pixels across and 193 depths, which is why
//! [`check`](crate::job) reckons it.

use super::number::Number;
use super::spectrum::Windows;
use crate::DoseLayout;
use std::mem::size_of;
use tomolith_core::grid::VolumeGrid;
use tomolith_fourier::Complex;

/// Samples of frames that lie in memory together, in bytes: about a volume of 256³.
const TOGETHER: usize = 64 << 20;

/// Frames whose samples, of so many bytes, lie in memory together.
pub(super) fn frames_together(bytes: usize, threads: usize) -> usize {
    (TOGETHER / bytes.max(1)).clamp(threads, threads.max(16))
}

/// Complex numbers of the size of a spectrum that a frame needs on its way back: its own, at a depth, kernels, sums.
const SPECTRA: usize = 6;

/// Fields that wait for each other on their way between depths, in addition to those they are interpolated from.
const WAITING: usize = 8;

impl<T: Number> Windows<T> {
    /// Numbers of the samples that voxels of one frame are interpolated from; rows are `row` numbers apart.
    fn samples(&self, row: usize) -> usize {
        self.sampling.along.last().count * self.last.count * row
    }

    /// Bytes of one frame at work, `doses` of them: 2 along a line of waves.
    pub(super) fn of_frame(&self, row: usize, doses: usize) -> usize {
        let [nu, nz] = self.counts();
        let field = self.width() * self.voxels;
        let waiting = (self.sampling.fields.as_ref())
            .map_or(0, |fields| 2 * (fields.taps.taps + WAITING) * field);
        let fields = SPECTRA * nu * nz + self.mixed() + field + waiting;
        let sampling = &self.sampling;
        let depths = sampling.along.computed.count;
        let is_along = sampling.along.closer.is_some();
        let is_across = sampling.across.closer.is_some();
        let computed = if is_along || is_across {
            doses * depths * self.width() * row
        } else {
            0
        };
        let between = if is_along && is_across {
            depths * self.last.count * row
        } else {
            0
        };
        // Scratches are taken as they come: each has had every part in the end
        doses
            * (fields * size_of::<Complex<T>>()
                + (computed + between + self.samples(row)) * size_of::<T>())
    }

    /// Bytes of frames at work, `doses` at a time, in addition to patterns and one dose; `kernels`: complex numbers for each frequency that are kept for all
    /// frames.
    pub(super) fn working_bytes(&self, grid: &VolumeGrid, doses: usize, kernels: usize) -> usize {
        let layout = DoseLayout::new("dose", grid.clone(), 0);
        let (row, threads) = (layout.row, rayon::current_num_threads());
        let [nu, nz] = self.counts();
        let samples = doses * self.samples(row) * size_of::<T>();
        let more = (doses - 1) * layout.len() * size_of::<T>();
        more + kernels * nu * nz * size_of::<Complex<T>>()
            + frames_together(samples, threads) * samples
            + threads * self.of_frame(row, doses)
    }
}
