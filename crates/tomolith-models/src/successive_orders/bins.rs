//! Patterns on pixels as large as the cells that they light.

use crate::PatternLayout;
use crate::cell_blur::CellBlur;
use std::ops::Range;
use tomolith_core::dose::scattered::{self, Share};
use tomolith_core::grid::PatternGrid;
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;

/// Pixels of a light, and the larger ones that share out their energy.
pub(super) struct Bins {
    pixels: PatternLayout,
    /// The larger pixels: as many rows of each (frame, column), from the lowest lit one.
    pub(super) layout: PatternLayout,
    shares: scattered::Bins,
}

/// Bins of `factor` pixels along an axis of `count`, centered on it like the pixels.
fn shares(count: usize, factor: usize) -> (usize, Vec<Share>) {
    let bins = count.div_ceil(factor);
    // In halves of a pixel, where every edge of pixels and bins is whole
    let before = bins * factor - count;
    let of_pixel = |i: usize| {
        let low = 2 * i + before;
        let bin = low / (2 * factor);
        let room = 2 * factor * (bin + 1) - low;
        let in_first = room.min(2) as f32 / 2.0;
        Share {
            bin: bin as u32,
            parts: [in_first, 1.0 - in_first],
        }
    };
    (bins, (0..count).map(of_pixel).collect())
}

impl Bins {
    /// Bins of about `edge_mm`, never smaller than pixels; the light of bins.
    pub(super) fn new(light: &Light, edge_mm: f64) -> (Self, Light) {
        let pixels = light.layout(0);
        let grid = &pixels.grid;
        let [across, along] = grid
            .pitch_mm
            .map(|pitch| ((edge_mm / pitch).floor() as usize).max(1));
        let (columns, of_column) = shares(grid.columns, across);
        let (rows, of_row) = shares(grid.rows, along);
        // Rows are counted from below, and the shares are symmetric
        let lit = lit_rows(&pixels).map_or(0..0, |lit| {
            of_row[lit.start].bin..(of_row[lit.end - 1].bin + 2).min(rows as u32)
        });
        let active = (lit.start, lit.end - lit.start);
        let larger = PatternGrid {
            columns,
            rows,
            pitch_mm: [
                across as f64 * grid.pitch_mm[0],
                along as f64 * grid.pitch_mm[1],
            ],
            ..grid.clone()
        };
        let light = Light {
            active: Some(vec![active; larger.frames() * columns]),
            pixels: larger,
            ..light.clone()
        };
        let layout = light.layout(0);
        let shares = scattered::Bins {
            columns: of_column,
            rows: of_row,
            scale: (grid.pixel_mm2() / layout.grid.pixel_mm2()) as f32,
        };
        let bins = Bins {
            layout,
            pixels,
            shares,
        };
        (bins, light)
    }

    /// (Frame, column) pairs of the pixels.
    pub(super) fn slots(&self) -> usize {
        self.pixels.runs.len()
    }

    /// Lowest and highest edge of what is lit, mm.
    pub(super) fn heights_mm(&self) -> [f64; 2] {
        let grid = &self.layout.grid;
        let run = self.layout.runs.first().copied().unwrap_or_default();
        let low = grid.field_mm()[0][1];
        let edge = |row: u32| low + f64::from(row) * grid.pitch_mm[1];
        [edge(run.bottom), edge(run.bottom + run.count)]
    }

    pub(super) fn form(&self) -> scattered::Bins {
        self.shares.clone()
    }

    /// What becomes of pixels that are taken together.
    pub(super) fn blur(&self) -> CellBlur {
        CellBlur::bins(self.pixels.grid.pitch_mm, self.layout.grid.pitch_mm)
    }

    fn lit_rows(&self) -> Range<usize> {
        let run = self.layout.runs.first().copied().unwrap_or_default();
        run.bottom as usize..(run.bottom + run.count) as usize
    }

    /// Every pixel of a (frame, column), counted from its first, with the rows that share it, counted from the lowest lit one, and their parts.
    fn for_each_part(&self, slot: usize, mut visit: impl FnMut(usize, usize, f32)) {
        let (run, lowest) = (self.pixels.runs[slot], self.lit_rows().start);
        let rows = &self.shares.rows[run.bottom as usize..][..run.count as usize];
        for (pixel, share) in rows.iter().enumerate() {
            for (next, part) in lit_parts(*share) {
                visit(pixel, share.bin as usize + next - lowest, part);
            }
        }
    }

    /// The bins that share a (frame, column), from the lowest lit one on, and their parts.
    fn bins_of(&self, slot: usize) -> impl Iterator<Item = (Range<usize>, f32)> {
        let (columns, larger) = (self.pixels.grid.columns, self.layout.grid.columns);
        let share = self.shares.columns[slot % columns];
        lit_parts(share).map(move |(next, part)| {
            let run = self.layout.runs[slot / columns * larger + share.bin as usize + next];
            (run.offset..run.offset + run.count as usize, part)
        })
    }

    /// No light in any row of bins: `[frame, column][row]`.
    pub(super) fn dark_rows(&self) -> Vec<f32> {
        vec![0.0; self.slots() * self.lit_rows().len()]
    }

    /// Light of pixels by rows of bins, `[frame, column][row]`.
    pub(super) fn in_rows(&self, x: &[f32]) -> Vec<f32> {
        let mut rows = self.dark_rows();
        let columns = self.pixels.grid.columns;
        let count = self.lit_rows().len().max(1);
        let of_frames = rows.chunks_mut(count * columns).enumerate();
        of_frames.par_each(|(frame, rows)| {
            for (column, rows) in rows.chunks_mut(count).enumerate() {
                let slot = frame * columns + column;
                let pixels = &x[self.pixels.runs[slot].offset..];
                self.for_each_part(slot, |pixel, row, part| rows[row] += part * pixels[pixel]);
            }
        });
        rows
    }

    /// Bins of mean values of pixels by [rows](Self::in_rows), these times the weight of their (frame, column).
    pub(super) fn fill(&self, rows: &[f32], weights: &[f32], bins: &mut [f32]) {
        let (frames, columns) = (self.pixels.grid.frames(), self.pixels.grid.columns);
        let (scale, count) = (self.shares.scale, self.lit_rows().len());
        let len = self.layout.len() / frames;
        let of_frames = bins.chunks_mut(len.max(1)).enumerate();
        of_frames.par_each(|(frame, bins)| {
            bins.fill(0.0);
            for slot in frame * columns..(frame + 1) * columns {
                let rows = &rows[slot * count..][..count];
                for (range, part) in self.bins_of(slot) {
                    let weight = scale * weights[slot] * part;
                    let bins = &mut bins[range.start - frame * len..range.end - frame * len];
                    let both = bins.iter_mut().zip(rows);
                    both.for_each(|(bin, row)| *bin += weight * row);
                }
            }
        });
    }

    /// Transpose of [`fill`](Self::fill), added to the rows of some frames.
    pub(super) fn add_back(
        &self,
        frames: Range<usize>,
        bins: &[f32],
        weights: &[f32],
        rows: &mut [f32],
    ) {
        let columns = self.pixels.grid.columns;
        let (scale, count) = (self.shares.scale, self.lit_rows().len());
        let of_frames = rows.chunks_mut((count * columns).max(1)).enumerate();
        let of_frames: Vec<_> = of_frames
            .filter(|(frame, _)| frames.contains(frame))
            .collect();
        of_frames.into_iter().par_each(|(frame, rows)| {
            for (column, rows) in rows.chunks_mut(count).enumerate() {
                let slot = frame * columns + column;
                for (range, part) in self.bins_of(slot) {
                    let weight = scale * weights[slot] * part;
                    let both = rows.iter_mut().zip(&bins[range]);
                    both.for_each(|(row, bin)| *row += weight * bin);
                }
            }
        });
    }

    /// Transpose of [`in_rows`](Self::in_rows), added to the pixels of some frames; `x` has those of all.
    pub(super) fn add_rows(&self, frames: Range<usize>, rows: &[f32], x: &mut [f32]) {
        let (columns, count) = (self.pixels.grid.columns, self.lit_rows().len());
        let x = &mut x[self.pixels.elements_of(frames.clone())];
        let by_frame = self.pixels.split_frames(frames, x);
        by_frame.into_iter().par_each(|(frame, pixels)| {
            let first = self.pixels.runs[frame * columns].offset;
            for slot in frame * columns..(frame + 1) * columns {
                let rows = &rows[slot * count..][..count];
                let pixels = &mut pixels[self.pixels.runs[slot].offset - first..];
                self.for_each_part(slot, |pixel, row, part| pixels[pixel] += part * rows[row]);
            }
        });
    }
}

/// Which of the two bins have a part, and how much.
fn lit_parts(share: Share) -> impl Iterator<Item = (usize, f32)> {
    let parts = share.parts.into_iter().enumerate();
    parts.filter(|&(_, part)| part > 0.0)
}

/// Rows from the lowest to the highest that any column lights, counted from below.
fn lit_rows(pixels: &PatternLayout) -> Option<Range<usize>> {
    let lit = pixels.runs.iter().filter(|run| run.count > 0);
    let low = lit.clone().map(|run| run.bottom).min()?;
    let high = lit.map(|run| run.bottom + run.count).max()?;
    Some(low as usize..high as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::noise;
    use tomolith_optics::resin::Resin;

    #[test]
    fn bins_hold_the_energy_of_their_pixels_and_adding_back_is_the_transpose() {
        // 11 columns in 4 bins of 3: half a pixel of the first bin lies beside the pixels; 6 rows in 2
        let mut light = Light::new(
            PatternGrid::full_turn(2, 0.0, 6, 11, 0.1),
            Resin::absorbing(1.5, 0.1),
        );
        let runs: Vec<(u32, u32)> = (0..22).map(|i| (1 + i % 2, 1 + i % 3)).collect();
        light.active = Some(runs);
        let (bins, larger) = Bins::new(&light, 0.31);
        assert_eq!((larger.pixels.columns, larger.pixels.rows), (4, 2));
        let len = light.layout(0).len();
        let (x, weights) = (noise(1, len), noise(2, 22));
        let mut found = vec![f32::NAN; larger.layout(0).len()];
        let rows = bins.in_rows(&x);
        bins.fill(&rows, &[1.0; 22], &mut found);
        let (energy, binned): (f32, f32) = (x.iter().sum(), found.iter().sum());
        assert!((energy - 9.0 * binned).abs() < 1e-5, "{energy} {binned}");
        bins.fill(&rows, &weights, &mut found);
        let back = noise(3, found.len());
        let mut sum = vec![0.0; len];
        let mut rows = bins.dark_rows();
        bins.add_back(0..2, &back, &weights, &mut rows);
        bins.add_rows(0..2, &rows, &mut sum);
        let dot = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
        assert!((dot(&found, &back) - dot(&x, &sum)).abs() < 1e-5);
    }

    #[test]
    fn a_pixel_astride_two_bins_is_shared_by_its_length_in_each() {
        let (bins, shares) = shares(5, 2);
        assert_eq!(bins, 3);
        let parts: Vec<(u32, [f32; 2])> = shares.iter().map(|s| (s.bin, s.parts)).collect();
        let (whole, half) = ([1.0, 0.0], [0.5, 0.5]);
        // Bins that end with the pixels have nothing beyond
        let (bins, shares) = super::shares(12, 3);
        assert!(
            shares
                .iter()
                .all(|s| s.parts == whole && (s.bin as usize) < bins)
        );
        assert_eq!(
            parts,
            [(0, whole), (0, half), (1, whole), (1, half), (2, whole)]
        );
    }
}
