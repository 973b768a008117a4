//! Along z: rows of pixels ↔ lanes of voxels.
//!
//! A pixel is a box, so a voxel receives the mean over its height: Σ overlap(row, voxel)/pitch · value. Exact for any ratio
//! of the two pitches and any offset.

use super::chains::Avx512;
use crate::grid::{PatternGrid, VolumeGrid};
use crate::models::layout::PixelRun;

/// Overlaps of rows and lanes, in both directions.
#[derive(Clone, Debug)]
pub(super) struct Heights {
    wide: Option<Avx512>,
    rows: usize,
    lanes: usize,
    /// Rows → lanes: taps · lanes weights, tap-major, and the first row of each lane.
    to_lanes: Taps,
    /// Lanes → rows.
    to_rows: Taps,
    /// Lanes that each row lights, half-open.
    lit: Vec<(u32, u32)>,
}

#[derive(Clone, Debug)]
struct Taps {
    first: Vec<u32>,
    weights: Vec<Vec<f32>>,
    /// Where `first` starts, when it grows by one from each to the next: equal pitches.
    consecutive: Option<usize>,
}

impl Taps {
    /// out[i] += Σ weight · source[first + tap]
    fn apply(&self, wide: Option<Avx512>, source: &[f32], out: &mut [f32]) {
        for (tap, weights) in self.weights.iter().enumerate() {
            if let Some(start) = self.consecutive {
                for ((o, &w), &s) in out.iter_mut().zip(weights).zip(&source[start + tap..]) {
                    *o += w * s;
                }
            } else if let Some(wide) = wide {
                wide.add_gathered(out, weights, source, &self.first, tap);
            } else {
                for ((o, &w), &first) in out.iter_mut().zip(weights).zip(&self.first) {
                    *o += w * source[first as usize + tap];
                }
            }
        }
    }

    /// As [`apply`](Self::apply) where [`consecutive`](Self::consecutive) says `start`: `source` holds elements from
    /// `source_first` on and is 0 elsewhere, `out` those from `out_first` on.
    fn apply_shifted(
        &self,
        start: usize,
        (source, source_first): (&[f32], usize),
        (out, out_first): (&mut [f32], usize),
    ) {
        for (tap, weights) in self.weights.iter().enumerate() {
            let wanted = start + tap + out_first;
            let skipped = source_first.saturating_sub(wanted).min(out.len());
            let from = wanted.saturating_sub(source_first).min(source.len());
            let weights = &weights[out_first + skipped..];
            for ((o, &w), &s) in out[skipped..].iter_mut().zip(weights).zip(&source[from..]) {
                *o += w * s;
            }
        }
    }

    fn new(count: usize, sources: usize, overlap: impl Fn(usize, usize) -> f64) -> Self {
        let spans: Vec<(usize, usize)> = (0..count)
            .map(|i| {
                let first = (0..sources).find(|&s| overlap(i, s) > 0.0).unwrap_or(0);
                let end = (first..sources)
                    .take_while(|&s| overlap(i, s) > 0.0)
                    .count();
                (first, end)
            })
            .collect();
        let taps = spans.iter().map(|s| s.1).max().unwrap_or(0);
        let weights = (0..taps)
            .map(|tap| {
                spans
                    .iter()
                    .enumerate()
                    .map(|(i, &(first, n))| {
                        if tap < n {
                            overlap(i, first + tap) as f32
                        } else {
                            0.0
                        }
                    })
                    .collect()
            })
            .collect();
        let first: Vec<u32> = spans.iter().map(|s| s.0 as u32).collect();
        let steps_by_one = first.windows(2).all(|pair| pair[1] == pair[0] + 1);
        let consecutive = first
            .first()
            .filter(|_| steps_by_one)
            .map(|&start| start as usize);
        Taps {
            first,
            weights,
            consecutive,
        }
    }

    fn reach(&self) -> usize {
        self.weights.len()
    }
}

impl Heights {
    /// Overlaps of the rows of `pixels` (lowest first) with the slices of `grid`.
    pub(super) fn new(pixels: &PatternGrid, grid: &VolumeGrid, wide: Option<Avx512>) -> Self {
        let (rows, lanes) = (pixels.rows, grid.shape[0]);
        let (low, pitch) = (pixels.field_mm()[0][1], pixels.pitch_mm[1]);
        let row_low = |i: usize| low + i as f64 * pitch;
        let lane_low = |i: usize| grid.z(i) - grid.height_mm / 2.0;
        let overlap = |lane: usize, row: usize| {
            let high = (row_low(row) + pitch).min(lane_low(lane) + grid.height_mm);
            let width = high - row_low(row).max(lane_low(lane));
            // Touching faces share rounding errors, not light
            if width > 1e-9 * grid.height_mm {
                width / grid.height_mm
            } else {
                0.0
            }
        };
        let to_rows = Taps::new(rows, lanes, |row, lane| overlap(lane, row));
        let lit = (0..rows)
            .map(|row| {
                let first = to_rows.first[row];
                let count = to_rows.weights.iter().filter(|w| w[row] > 0.0).count();
                (first, first + count as u32)
            })
            .collect();
        Heights {
            wide,
            rows,
            lanes,
            to_lanes: Taps::new(lanes, rows, overlap),
            to_rows,
            lit,
        }
    }

    /// Length of the buffer that [`add_expanded`](Self::add_expanded) and [`collect`](Self::collect) need.
    pub(super) fn buffer(&self) -> usize {
        (self.rows + self.to_lanes.reach()).max(self.lanes + self.to_rows.reach())
    }

    /// Lanes lit by a run of rows: a half-open range.
    pub(super) fn lanes_of(&self, run: PixelRun) -> (usize, usize) {
        let rows = run.bottom as usize..(run.bottom + run.count) as usize;
        self.lit[rows]
            .iter()
            .filter(|lit| lit.1 > lit.0)
            .copied()
            .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
            .map_or((0, 0), |(a, b)| (a as usize, b as usize))
    }

    /// Adds the values of a run of rows to `lanes` (whole row of lanes).
    pub(super) fn add_expanded(
        &self,
        values: &[f32],
        run: PixelRun,
        lanes: &mut [f32],
        buffer: &mut [f32],
    ) {
        let low = run.bottom as usize;
        if let Some(start) = self.to_lanes.consecutive {
            let lanes = &mut lanes[..self.lanes];
            return (self.to_lanes).apply_shifted(start, (values, low), (lanes, 0));
        }
        buffer.fill(0.0);
        buffer[low..low + values.len()].copy_from_slice(values);
        self.to_lanes
            .apply(self.wide, buffer, &mut lanes[..self.lanes]);
    }

    /// Lanes → the rows of a run (transpose of [`add_expanded`](Self::add_expanded)); `values` are overwritten.
    pub(super) fn collect(
        &self,
        lanes: &[f32],
        run: PixelRun,
        values: &mut [f32],
        buffer: &mut [f32],
        rows: &mut [f32],
    ) {
        if let Some(start) = self.to_rows.consecutive {
            values.fill(0.0);
            let out = (values, run.bottom as usize);
            return (self.to_rows).apply_shifted(start, (&lanes[..self.lanes], 0), out);
        }
        buffer[..self.lanes].copy_from_slice(&lanes[..self.lanes]);
        buffer[self.lanes..].fill(0.0);
        rows.fill(0.0);
        self.to_rows
            .apply(self.wide, buffer, &mut rows[..self.rows]);
        values.copy_from_slice(&rows[run.bottom as usize..][..run.count as usize]);
    }
}
