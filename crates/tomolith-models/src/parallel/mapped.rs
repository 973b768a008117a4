//! Resin whose absorption changes across the plane: a map μ(x, y), the same at all heights.
//!
//! Light still runs straight (an index-matched vial), so a strip walks through the rows of the grid with the mean
//! attenuation of the voxels it covers. With D the attenuation met so far and μ̄ the mean in a row that is w mm long,
//!
//! ```text
//! energy left in voxel i of the row = power · e^(−D) · (1 − e^(−μ̄w))/μ̄ · cover(i)/width · μ_active(i),     D ← D + μ̄w
//! ```
//! which sums to what the strip loses when all attenuation is active. D is stored where rows of tiles begin, so that tiles
//! stay independent. Where the map ends the resin has its plain numbers. The enumerator is scalar: several times slower than
//! a uniform resin.

use super::strips::{Beam, Major, Strip};
use super::tiles::{Local, TILE, TileEntries};
use super::walls::Walls;
use std::sync::Arc;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::InParallel;
use tomolith_optics::absorption_map::AbsorptionMap;
use tomolith_optics::resin::Resin;

/// A map on the grid of a model, and what the strips of every beam meet of it.
pub(super) struct Mapped {
    map: Arc<AbsorptionMap>,
    resin: Resin,
    grid: VolumeGrid,
    walls: Walls,
    /// Active absorption and total attenuation of every voxel of the plane.
    voxels: Vec<[f32; 2]>,
    /// For each beam: attenuation from the wall to where each row of tiles begins and the last ends, strip after strip.
    depths: Vec<Vec<f32>>,
}

/// A row of a strip: what it covers, voxels, and its way, mm.
struct Piece {
    row: i64,
    left: f64,
    right: f64,
    way: f64,
}

impl Mapped {
    pub(super) fn new(
        map: &Arc<AbsorptionMap>,
        resin: Resin,
        grid: &VolumeGrid,
        walls: &Walls,
        beams: &[Beam],
    ) -> Self {
        let mut mapped = Mapped {
            map: map.clone(),
            resin,
            grid: grid.clone(),
            walls: walls.clone(),
            voxels: Vec::new(),
            depths: Vec::new(),
        };
        let [_, ny, nx] = grid.shape;
        mapped.voxels = (0..ny * nx)
            .map(|i| mapped.sampled((i % nx) as i64, (i / nx) as i64))
            .map(|both| both.map(|v| v as f32))
            .collect();
        mapped.depths = beams.iter().par_map(|beam| mapped.depths_of(beam));
        mapped
    }

    /// Active absorption and total attenuation of a voxel, on the grid or beyond.
    fn sampled(&self, ix: i64, iy: i64) -> [f64; 2] {
        let [low, _] = self.grid.bounds_mm();
        let at = |low: f64, i: i64| low + (i as f64 + 0.5) * self.grid.pitch_mm;
        let plain = [self.resin.absorption_per_mm, self.resin.attenuation_per_mm];
        self.map
            .at([at(low[0], ix), at(low[1], iy)])
            .unwrap_or(plain)
    }

    fn voxel(&self, major: Major, row: i64, across: i64) -> [f64; 2] {
        let [_, ny, nx] = self.grid.shape;
        let (ix, iy) = if major == Major::X {
            (row, across)
        } else {
            (across, row)
        };
        if (0..nx as i64).contains(&ix) && (0..ny as i64).contains(&iy) {
            self.voxels[iy as usize * nx + ix as usize].map(f64::from)
        } else {
            self.sampled(ix, iy)
        }
    }

    fn rows(&self, major: Major) -> usize {
        self.grid.shape[if major == Major::X { 2 } else { 1 }]
    }

    /// The piece of a strip in a row; None where it is not lit.
    fn piece(&self, major: Major, strip: &Strip, row: i64) -> Option<Piece> {
        let [low, high] = strip.span.map(f64::from);
        let (from, to) = ((row as f64).max(low), (row as f64 + 1.0).min(high));
        if from >= to {
            return None;
        }
        let middle = 0.5 * (from + to);
        let [a, b] = strip
            .edges
            .map(|[offset, slope]| f64::from(offset) + f64::from(slope) * middle);
        let resin_row = self.walls.resin_row(major, row);
        let [left, right] = resin_row.within([a.min(b) as f32, a.max(b) as f32]);
        Some(Piece {
            row,
            left: f64::from(left),
            right: f64::from(right),
            way: (to - from) * f64::from(strip.row_mm),
        })
    }

    /// Attenuation over a piece.
    fn loss(&self, major: Major, piece: &Piece) -> f64 {
        let cells = piece.left.floor() as i64..=piece.right.floor() as i64;
        let terms = cells.map(|cell| {
            let cover = piece.right.min(cell as f64 + 1.0) - piece.left.max(cell as f64);
            cover.max(0.0) * self.voxel(major, piece.row, cell)[1]
        });
        terms.sum::<f64>() / (piece.right - piece.left) * piece.way
    }

    fn depths_of(&self, beam: &Beam) -> Vec<f32> {
        let rows = self.rows(beam.major) as i64;
        let marks = self.marks(beam.major);
        let mut all = Vec::with_capacity(beam.strips.len() * marks);
        for strip in &beam.strips {
            let [low, high] = strip.span.map(|t| t.floor() as i64);
            // Rows in the direction of travel; marks are faces between rows
            let mut depths = vec![0.0f32; marks];
            let mut depth = 0.0;
            let walk: Box<dyn Iterator<Item = i64>> = if strip.upward {
                Box::new(low.min(0)..rows)
            } else {
                Box::new((0..=high.max(rows - 1)).rev())
            };
            for row in walk {
                let face_before = if strip.upward { row } else { row + 1 };
                self.mark(&mut depths, face_before, rows, depth);
                if let Some(piece) = self.piece(beam.major, strip, row) {
                    depth += self.loss(beam.major, &piece);
                }
            }
            self.mark(
                &mut depths,
                if strip.upward { rows } else { 0 },
                rows,
                depth,
            );
            all.extend(depths);
        }
        all
    }

    fn mark(&self, depths: &mut [f32], face: i64, rows: i64, depth: f64) {
        if (0..=rows).contains(&face) && (face % TILE as i64 == 0 || face == rows) {
            depths[(face as usize).div_ceil(TILE)] = depth as f32;
        }
    }

    /// Faces at which attenuation is stored: where rows of tiles begin, and where the last ends.
    fn marks(&self, major: Major) -> usize {
        self.rows(major).div_ceil(TILE) + 1
    }

    /// Appends what strips `first..end` of a beam light in the tile; `keep` says which columns count.
    pub(super) fn enumerate(
        &self,
        index: usize,
        beam: &Beam,
        strips: std::ops::Range<usize>,
        local: &Local,
        keep: impl Fn(u32) -> bool,
        found: &mut TileEntries,
    ) {
        let marks = self.marks(beam.major);
        let first_row = local.origin[0] as i64;
        for i in strips {
            let strip = &beam.strips[i];
            if !keep(strip.column) {
                continue;
            }
            let begin = found.slots.len() as u32;
            let tile_row = first_row as usize / TILE;
            let mark = tile_row + usize::from(!strip.upward);
            let mut depth = f64::from(self.depths[index][i * marks + mark]);
            for step in 0..local.rows {
                let row = if strip.upward {
                    step
                } else {
                    local.rows - 1 - step
                };
                if let Some(piece) = self.piece(beam.major, strip, first_row + row as i64) {
                    let loss = self.loss(beam.major, &piece);
                    let passed = if loss > 0.0 {
                        -(-loss).exp_m1() / loss
                    } else {
                        1.0
                    };
                    let energy = f64::from(strip.power) * (-depth).exp() * passed * piece.way;
                    self.share(beam.major, &piece, energy, local, row, found);
                    depth += loss;
                }
            }
            found.end_run(strip.column, begin);
        }
    }

    /// Shares what a piece leaves, per unit of absorption, among the voxels of the tile.
    fn share(
        &self,
        major: Major,
        piece: &Piece,
        energy: f64,
        local: &Local,
        row: usize,
        found: &mut TileEntries,
    ) {
        let first = local.origin[1] as i64;
        let end = first + local.across as i64;
        let cells =
            (piece.left.floor() as i64).max(first)..=(piece.right.floor() as i64).min(end - 1);
        for cell in cells {
            let cover = piece.right.min(cell as f64 + 1.0) - piece.left.max(cell as f64);
            let active = self.voxel(major, piece.row, cell)[0];
            if cover > 0.0 && active > 0.0 {
                let weight = energy * cover / (piece.right - piece.left) * active;
                found.push(local, [row, (cell - first) as usize], weight as f32);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parallel::Parallel;
    use tomolith_core::check;
    use tomolith_core::dose::DoseModel;
    use tomolith_core::grid::PatternGrid;
    use tomolith_optics::light::Light;
    use tomolith_optics::vial::index_matched::IndexMatched;

    fn model(map: AbsorptionMap, azimuths: Vec<f64>, nz: usize) -> Parallel {
        let pixels = PatternGrid {
            azimuths,
            frame_arc: 0.0,
            rows: nz,
            columns: 45,
            pitch_mm: [0.1; 2],
            offset_mm: [0.0; 2],
        };
        let mut light = Light::new(pixels, Resin::absorbing(1.5, 0.3));
        light.map = Some(Arc::new(map));
        let grid = VolumeGrid::centered([nz, 33, 35], 0.1).about([0.05, -0.05, 0.0]);
        Parallel::new(&IndexMatched { radius_mm: 2.0 }, vec![light], grid).unwrap()
    }

    fn dose(model: &Parallel) -> Vec<f32> {
        let x = check::even_patterns(model, 1.0);
        let dose = check::dose(model, &x);
        model.outputs()[0].volume_of(dose.as_slice()).values
    }

    fn turn() -> Vec<f64> {
        (0..7).map(|k| 0.2 + f64::from(k) * 0.9).collect()
    }

    #[test]
    fn a_map_passes_the_model_check() {
        // Odd cells, not those of the grid, beyond which the resin is plain
        let total: Vec<f32> = check::noise(1, 90).iter().map(|v| 0.4 + 0.3 * v).collect();
        let active: Vec<f32> = total.iter().map(|t| 0.6 * t).collect();
        for nz in [1, 5] {
            let map = AbsorptionMap::new([1, 9, 10], 0.27, active.clone(), total.clone()).unwrap();
            check::model::model(&model(map, turn(), nz), 3).unwrap();
        }
    }

    #[test]
    fn an_even_map_is_an_even_resin() {
        let map = AbsorptionMap::new([1, 2, 2], 5.0, vec![0.3; 4], vec![0.3; 4]).unwrap();
        let mapped = dose(&model(map, turn(), 1));
        let mut even = model(
            AbsorptionMap::new([1, 1, 1], 1.0, vec![0.3], vec![0.3]).unwrap(),
            turn(),
            1,
        );
        // A map far smaller than the resin leaves all else plain
        let small = dose(&even);
        let mut light = Light::new(even.patterns()[0].grid.clone(), Resin::absorbing(1.5, 0.3));
        light.active = None;
        let grid = even.outputs()[0].grid.clone();
        even = Parallel::new(&IndexMatched { radius_mm: 2.0 }, vec![light], grid).unwrap();
        let plain = dose(&even);
        for ((a, b), c) in mapped.iter().zip(&small).zip(&plain) {
            assert!(
                (a - c).abs() < 1e-5 * 7.0 && (b - c).abs() < 1e-5 * 7.0,
                "{a} {b} {c}"
            );
        }
    }

    #[test]
    fn light_falls_by_what_it_has_passed() {
        // From +x through μ = 1 where x > 0 and μ = 0.25 (half of it active) where x < 0
        let map = AbsorptionMap::new([1, 1, 2], 4.0, vec![0.125, 1.0], vec![0.25, 1.0]).unwrap();
        let model = model(map, vec![0.0], 1);
        let found = dose(&model);
        let grid = &model.outputs()[0].grid;
        let iy = 16; // y = −0.05: columns at 0 and −0.1 share it, whose chords differ by 1.3e-3 of their length
        for ix in 0..35 {
            let (low, high) = (grid.x(ix) - 0.05, grid.x(ix) + 0.05);
            let chord = (4.0f64 - grid.y(iy).powi(2)).sqrt();
            let passed = |x: f64| (-(chord - x.max(0.0)) + 0.25 * x.min(0.0)).exp();
            if low < -chord || high > chord || (low < 0.0 && high > 1e-12) {
                continue;
            }
            let share = if high <= 1e-12 { 0.5 } else { 1.0 };
            let expected = share * (passed(high) - passed(low)) / 0.1;
            let found = f64::from(found[iy * 35 + ix]);
            assert!(
                (found / expected - 1.0).abs() < 1.5e-3,
                "{ix}: {found}, not {expected}"
            );
        }
    }

    #[test]
    fn maps_that_cannot_be_are_refused() {
        for (active, total) in [
            (0.2, 0.1),
            (-0.1, 0.1),
            (f32::NAN, 0.1),
            (0.1, f32::INFINITY),
        ] {
            assert!(AbsorptionMap::new([1, 1, 1], 1.0, vec![active], vec![total]).is_err());
        }
    }
}
