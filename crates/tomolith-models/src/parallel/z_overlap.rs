//! Overlap along z: rows of pixels ↔ lanes of voxels.
//!
//! A pixel is a box, so a voxel receives the mean over its height: Σ overlap(row, voxel)/pitch · value. Exact for any ratio
//! of the two pitches and any offset.

use super::TOGETHER;
use super::block_sparsity::is_nonzero;
use super::chains::LOOKED_UP;
use super::kernel::{self, Isa};
use super::plan::KernelPath;
use crate::layout::{PixelRun, row_of};
use std::ops::Range;
use tomolith_core::dose::strips;
use tomolith_core::field::{HostField, LANES};
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_core::parallel::InParallel;

/// Intervals of equal height, one above the other: rows of pixels or slices of voxels.
#[derive(Clone, Debug)]
pub(super) struct Intervals {
    lows_mm: Vec<f64>,
    pitch_mm: f64,
}

impl Intervals {
    /// The rows of pixels, lowest first.
    pub(super) fn of_rows(pixels: &PatternGrid) -> Self {
        let (low, pitch_mm) = (pixels.field_mm()[0][1], pixels.pitch_mm[1]);
        let lows_mm = (0..pixels.rows)
            .map(|row| low + row as f64 * pitch_mm)
            .collect();
        Intervals { lows_mm, pitch_mm }
    }

    pub(super) fn of_slices(grid: &VolumeGrid) -> Self {
        let low = |slice| grid.z(slice) - grid.height_mm / 2.0;
        Intervals {
            lows_mm: (0..grid.shape[0]).map(low).collect(),
            pitch_mm: grid.height_mm,
        }
    }

    fn count(&self) -> usize {
        self.lows_mm.len()
    }

    /// Share of interval `i` that lies within interval `k` of others.
    fn overlap(&self, i: usize, others: &Intervals, k: usize) -> f64 {
        let high = (others.lows_mm[k] + others.pitch_mm).min(self.lows_mm[i] + self.pitch_mm);
        let width = high - others.lows_mm[k].max(self.lows_mm[i]);
        // Touching faces share rounding errors, not light
        if width > 1e-9 * self.pitch_mm {
            width / self.pitch_mm
        } else {
            0.0
        }
    }
}

/// The heights that a kernel runs along.
///
/// Light stays at its height, so all voxels of a column that lie in one row of pixels get the same from every column of
/// pixels. Where rows are fewer than slices the kernel runs along the rows, and each row is spread over its slices at the end;
/// the adjoint first sums the slices of a row. Otherwise it runs along the slices.
pub(super) struct Levels {
    /// Floats of a row of lanes, and vectors that hold anything but padding.
    pub(super) row: usize,
    pub(super) used: usize,
    /// Rows of pixels → lanes of the kernel.
    pub(super) overlaps: ZOverlaps,
    /// Lanes of the kernel → slices; None where they are the slices.
    pub(super) spread: Option<Spread>,
}

impl Levels {
    /// For rows and slices; `all` is what they share.
    pub(super) fn new(
        rows: &Intervals,
        slices: &Intervals,
        all: &ZOverlaps,
        path: KernelPath,
    ) -> Self {
        let row = row_of(slices.count());
        let lit = |row: &usize| all.lit[*row].1 > all.lit[*row].0;
        let first = (0..rows.count()).find(lit).unwrap_or(0);
        let end = (0..rows.count()).rfind(lit).map_or(first, |last| last + 1);
        if row == 1
            || end == first
            || (end - first).div_ceil(LANES) >= slices.count().div_ceil(LANES)
        {
            return Levels {
                row,
                used: slices.count().div_ceil(LANES),
                overlaps: all.clone(),
                spread: None,
            };
        }
        let lit = Intervals {
            lows_mm: rows.lows_mm[first..end].to_vec(),
            pitch_mm: rows.pitch_mm,
        };
        let row = row_of(end - first).max(LANES);
        Levels {
            row,
            used: (end - first).div_ceil(LANES),
            overlaps: ZOverlaps::new(rows, &lit, path),
            spread: Some(Spread {
                overlaps: ZOverlaps::new(&lit, slices, path),
                row,
                row_of_slices: row_of(slices.count()),
            }),
        }
    }
}

/// Lanes of the kernel that are rows of pixels, and the slices of voxels.
pub(super) struct Spread {
    overlaps: ZOverlaps,
    /// Floats of a row of lanes, and of a row of slices.
    row: usize,
    row_of_slices: usize,
}

impl Spread {
    fn all_rows(&self) -> PixelRun {
        PixelRun {
            offset: 0,
            bottom: 0,
            count: self.overlaps.rows as u32,
        }
    }

    /// Slices that some lanes reach.
    pub(super) fn slices_of(&self, lanes: Range<usize>) -> Range<usize> {
        let end = lanes.end.min(self.overlaps.rows);
        let (first, end) = self.overlaps.lanes_of(PixelRun {
            offset: 0,
            bottom: lanes.start as u32,
            count: (end - lanes.start) as u32,
        });
        first..end
    }

    /// Lanes → slices as data, or slices → lanes.
    pub(super) fn form(&self, to_slices: bool) -> strips::Taps {
        self.overlaps.form(to_slices)
    }

    /// Adds rows of lanes to as many rows of slices; `buffer` has [`buffer`](ZOverlaps::buffer) floats.
    pub(super) fn add_to(&self, dose: &mut [f32], lanes: &[f32], buffer: &mut Vec<f32>) {
        buffer.resize(self.overlaps.buffer(), 0.0);
        let slices = dose.chunks_exact_mut(self.row_of_slices);
        for (slices, lanes) in slices.zip(lanes.chunks_exact(self.row)) {
            if is_nonzero(lanes) {
                let rows = &lanes[..self.overlaps.rows];
                (self.overlaps).add_expanded(rows, self.all_rows(), slices, buffer);
            }
        }
    }

    /// Rows of slices → rows of lanes (transpose of [`add_to`](Self::add_to)); `lanes` are overwritten.
    pub(super) fn collect(&self, slices: &[f32], lanes: &mut HostField) {
        let buffers = || [(); 2].map(|()| vec![0.0; self.overlaps.buffer()]);
        lanes
            .as_mut_slice()
            .chunks_mut(TOGETHER * self.row)
            .zip(slices.chunks(TOGETHER * self.row_of_slices))
            .par_each_with(buffers, |[buffer, rows], (lanes, slices)| {
                let lanes = lanes.chunks_exact_mut(self.row);
                for (lanes, slices) in lanes.zip(slices.chunks_exact(self.row_of_slices)) {
                    let (values, padding) = lanes.split_at_mut(self.overlaps.rows);
                    padding.fill(0.0);
                    if is_nonzero(slices) {
                        (self.overlaps).collect(slices, self.all_rows(), values, buffer, rows);
                    } else {
                        values.fill(0.0);
                    }
                }
            });
    }
}

/// Overlaps of rows and lanes, in both directions.
#[derive(Clone, Debug)]
pub(super) struct ZOverlaps {
    path: KernelPath,
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
    /// Whether the first taps of sixteen neighbors lie within [`LOOKED_UP`] elements, and those of eight within half of that.
    near: [bool; 2],
}

impl Taps {
    /// out[i] += Σ weight · source[first + tap]
    fn apply(&self, path: KernelPath, source: &[f32], out: &mut [f32]) {
        for (tap, weights) in self.weights.iter().enumerate() {
            if let Some(start) = self.consecutive {
                for ((o, &w), &s) in out.iter_mut().zip(weights).zip(&source[start + tap..]) {
                    *o += w * s;
                }
            } else if let Some(wide) = path.wide {
                wide.add_gathered(out, weights, source, &self.first, tap, self.near[0]);
            } else if path.isa == Isa::Avx2 && self.near[1] {
                kernel::add_looked_up(out, weights, source, &self.first, tap);
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
        source: &[f32],
        source_first: usize,
        out: &mut [f32],
        out_first: usize,
    ) {
        // Slices: one row of pixels, one row of voxels
        if let ([weights], [s], [o]) = (self.weights.as_slice(), source, &mut *out) {
            if start + out_first == source_first {
                *o += weights[out_first] * s;
            }
            return;
        }
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
        // One without any stays where its neighbor below is
        let first: Vec<u32> = spans
            .iter()
            .scan(0, |last, &(first, count)| {
                *last = if count > 0 { first as u32 } else { *last };
                Some(*last)
            })
            .collect();
        let steps_by_one = first.windows(2).all(|pair| pair[1] == pair[0] + 1);
        let consecutive = first
            .first()
            .filter(|_| steps_by_one)
            .map(|&start| start as usize);
        let are_near = |count: usize| {
            first.chunks(count).all(|some| {
                let within = some[0]..some[0] + 2 * count as u32;
                some.iter().all(|first| within.contains(first))
            })
        };
        let near = [LANES, LANES / 2].map(are_near);
        Taps {
            first,
            weights,
            consecutive,
            near,
        }
    }

    fn reach(&self) -> usize {
        self.weights.len()
    }
}

impl ZOverlaps {
    /// Overlaps of rows (lowest first) with lanes.
    pub(super) fn new(rows: &Intervals, lanes: &Intervals, path: KernelPath) -> Self {
        let overlap = |lane: usize, row: usize| lanes.overlap(lane, rows, row);
        let [row_count, lane_count] = [rows, lanes].map(Intervals::count);
        let to_rows = Taps::new(row_count, lane_count, |row, lane| overlap(lane, row));
        let lit = (0..row_count)
            .map(|row| {
                let first = to_rows.first[row];
                let count = to_rows.weights.iter().filter(|w| w[row] > 0.0).count();
                (first, first + count as u32)
            })
            .collect();
        ZOverlaps {
            path,
            rows: row_count,
            lanes: lane_count,
            to_lanes: Taps::new(lane_count, row_count, overlap),
            to_rows,
            lit,
        }
    }

    /// Rows → lanes as data, or lanes → rows.
    pub(super) fn form(&self, to_lanes: bool) -> strips::Taps {
        let taps = if to_lanes {
            &self.to_lanes
        } else {
            &self.to_rows
        };
        strips::Taps {
            first: taps.first.clone(),
            weights: taps.weights.clone(),
        }
    }

    /// Length of the buffer that [`add_expanded`](Self::add_expanded) and [`collect`](Self::collect) need.
    pub(super) fn buffer(&self) -> usize {
        LOOKED_UP + (self.rows + self.to_lanes.reach()).max(self.lanes + self.to_rows.reach())
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

    /// Rows that light any of some lanes: from the first to the last.
    pub(super) fn rows_of(&self, lanes: Range<usize>) -> Range<usize> {
        let meets = |row: &usize| {
            let (first, end) = self.lit[*row];
            (first as usize) < lanes.end && (end as usize) > lanes.start
        };
        let first = (0..self.rows).find(meets).unwrap_or(0);
        let end = (0..self.rows).rfind(meets).map_or(first, |last| last + 1);
        first..end
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
            return (self.to_lanes).apply_shifted(start, values, low, lanes, 0);
        }
        buffer.fill(0.0);
        buffer[low..low + values.len()].copy_from_slice(values);
        self.to_lanes
            .apply(self.path, buffer, &mut lanes[..self.lanes]);
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
            let (lanes, bottom) = (&lanes[..self.lanes], run.bottom as usize);
            return (self.to_rows).apply_shifted(start, lanes, 0, values, bottom);
        }
        buffer[..self.lanes].copy_from_slice(&lanes[..self.lanes]);
        buffer[self.lanes..].fill(0.0);
        rows.fill(0.0);
        self.to_rows
            .apply(self.path, buffer, &mut rows[..self.rows]);
        values.copy_from_slice(&rows[run.bottom as usize..][..run.count as usize]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::Parallel;
    use super::*;
    use crate::{DoseModel, Work};
    use tomolith_core::check::{self, model::model, noise};
    use tomolith_core::field::Field;
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::{Vial, cylinder::Cylinder, index_matched::IndexMatched};

    /// Slices that are finer than rows of pixels.
    fn slices() -> VolumeGrid {
        VolumeGrid::centered([40, 21, 22], 0.05).about([0.0, 0.0, 0.1])
    }

    /// A light and the same with each row of pixels as so many equal ones, some of them dark for good.
    fn pair(rows: usize, pitch: f64, times: usize, resin: Resin) -> [Light; 2] {
        let pixels = PatternGrid {
            pitch_mm: [0.11, pitch],
            ..PatternGrid::full_turn(6, 0.2, rows, 12, 0.1)
        };
        let finer = PatternGrid {
            rows: rows * times,
            pitch_mm: [0.11, pitch / times as f64],
            ..pixels.clone()
        };
        let active = |times: usize| {
            let run = |column: usize| {
                let (bottom, count) = (column % 4, rows - 4 - column % 3);
                ((bottom * times) as u32, (count * times) as u32)
            };
            Some((0..6 * 12).map(run).collect())
        };
        [(pixels, 1), (finer, times)].map(|(pixels, times)| {
            let mut light = Light::new(pixels, resin);
            light.active = active(times);
            light
        })
    }

    /// Dose of pixels, and what a cotangent gives them; of both lights.
    fn dose_and_adjoint(
        vial: &dyn Vial,
        light: Light,
        values: &[f32],
        times: usize,
    ) -> (Vec<f32>, Vec<f32>) {
        let model = Parallel::new(vial, vec![light], slices()).unwrap();
        assert_eq!(model.lights[0].levels.spread.is_some(), times == 1);
        let mut x = model.new_patterns().unwrap();
        for (i, x) in x.as_mut_slice().iter_mut().enumerate() {
            *x = values[i / times];
        }
        let mut dose = model.new_dose().unwrap();
        (model.dose_of(0..6, &x, &mut dose, &Work::new())).unwrap();
        let mut cotangent = dose.zeros_like();
        let row = model.outputs()[0].row;
        for (i, c) in noise(4, cotangent.len()).into_iter().enumerate() {
            if i % row < 40 && i % 7 != 0 {
                cotangent.as_mut_slice()[i] = c;
            }
        }
        let mut gradient = x.zeros_like();
        (model.pullback(&x, &cotangent, &mut gradient, &Work::new())).unwrap();
        let of_rows = gradient.as_slice().chunks(times);
        let gradient = of_rows.map(|rows| rows.iter().sum()).collect();
        let dose = model.outputs()[0].volume_of(dose.as_slice()).values;
        (dose, gradient)
    }

    fn assert_near(found: &[f32], expected: &[f32], what: &str) {
        let off = check::largest_difference(found, expected);
        assert!(off <= 2e-6, "{what}: {off}");
    }

    #[test]
    fn a_kernel_along_rows_gives_what_one_along_slices_gives() {
        let straight = IndexMatched { radius_mm: 2.0 };
        let glass = Cylinder::new(2.0, 2.2, 1.58);
        let vials: [(&dyn Vial, Resin); 3] = [
            (&straight, Resin::absorbing(1.48, 0.2)),
            (&straight, Resin::pure_radon(1.48)), // opposite frames are one view
            (&glass, Resin::absorbing(1.48, 0.2)),
        ];
        // Two slices a row; rows that end within the grid; rows beyond it
        for (rows, pitch, times) in [(20, 0.1, 2), (13, 0.13, 4), (24, 0.12, 3)] {
            for (vial, resin) in vials {
                let what = format!("{rows} rows {vial:?}");
                let [light, finer] = pair(rows, pitch, times, resin);
                let values: Vec<f32> = (noise(2, 6 * 12 * rows).iter())
                    .map(|v| v.max(0.0))
                    .collect();
                let (dose, gradient) = dose_and_adjoint(vial, light.clone(), &values, 1);
                let (expected, of_each) = dose_and_adjoint(vial, finer, &values, times);
                assert_near(&dose, &expected, &what);
                assert_near(&gradient, &of_each, &what);
            }
        }
    }

    #[test]
    fn a_kernel_along_rows_passes_the_model_check_on_every_path() {
        let vial = IndexMatched { radius_mm: 2.0 };
        for isa in Isa::available() {
            let [light, _] = pair(13, 0.13, 4, Resin::absorbing(1.48, 0.2));
            let both = Parallel::new(&vial, vec![light.clone(), light], slices()).unwrap();
            model(&both.with_isa(isa), 3).unwrap_or_else(|e| panic!("{isa:?}: {e}"));
        }
    }

    #[test]
    fn registers_are_looked_up_as_memory_is() {
        let intervals_of = |low: f64, pitch_mm: f64, count: usize| Intervals {
            lows_mm: (0..count).map(|i| low + i as f64 * pitch_mm).collect(),
            pitch_mm,
        };
        let rows = intervals_of(0.0, 1.0, 53);
        // Finer and coarser lanes, up to several rows each; below, within and above the rows
        for (low, pitch, count) in [
            (0.0, 0.5, 106),
            (-7.3, 0.31, 80),
            (30.2, 1.9, 33),
            (-20.0, 5.5, 19),
        ] {
            let lanes = intervals_of(low, pitch, count);
            let run = PixelRun {
                offset: 0,
                bottom: 0,
                count: 53,
            };
            let of_path = |isa: &Isa| {
                let overlaps = ZOverlaps::new(&rows, &lanes, KernelPath::of(*isa));
                let mut buffers = [(); 2].map(|()| vec![0.0; overlaps.buffer()]);
                let [buffer, others] = &mut buffers;
                let (mut expanded, mut collected) = (vec![0.0; count], vec![0.0; 53]);
                overlaps.add_expanded(&noise(1, 53), run, &mut expanded, buffer);
                overlaps.collect(&noise(2, count), run, &mut collected, buffer, others);
                (expanded, collected)
            };
            let plain = of_path(&Isa::Scalar);
            for isa in Isa::available() {
                let found = of_path(&isa);
                assert_near(&found.0, &plain.0, "rows to lanes");
                assert_near(&found.1, &plain.1, "lanes to rows");
                assert!(isa != Isa::Avx2 || found == plain);
            }
        }
    }
}
