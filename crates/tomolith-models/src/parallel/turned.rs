//! Views that are those of an earlier part of the turn, turned by right angles.
//!
//! A round vial looks the same from everywhere, and a square grid about the axis looks the same after a quarter turn (a rectangular one after half a turn).
//! Where the frames of all lights are those of the first quarter again and again, what a column brings to a voxel is what it brought to the voxel a quarter turn
//! before: the matrix of a slice is that of the first part of the turn. [`cached`](super::cached) finds that part alone, and [`kept`](super::kept)
//! turns fields in place of entries.

use super::cached::Finding;
use super::tiles::Tile;
use super::views::{SAME, Views};
use std::f64::consts::FRAC_PI_2;
use tomolith_core::grid::VolumeGrid;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// Rows of pixels or slices above which parts are not served together where entries are kept: an entry is used often enough, and turned lanes no longer
/// stay in the cache.
const MOST_ROWS: usize = 96;

/// How the views of a light repeat those of its first part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Turned {
    /// Views of the first part: all of them where nothing repeats.
    pub(super) period: usize,
    /// How many parts there are.
    pub(super) parts: usize,
    /// Right angles, counter-clockwise, from one part to the next.
    step: usize,
    /// Voxels of the plane `[x, y]`.
    voxels: [usize; 2],
}

impl Turned {
    /// Of each light: of all of them, or of none, because they share their tiles; of none in a single slice, and where rows are long, unless entries are
    /// found in each call.
    pub(super) fn of_lights(
        vial: &dyn Vial,
        lights: &[Light],
        grid: &VolumeGrid,
        finding: Finding,
    ) -> Vec<Self> {
        let of_light = |light| Self::of(vial, light, grid, &Views::of(vial, light));
        let turned: Vec<Self> = lights.iter().map(of_light).collect();
        let nz = grid.shape[0];
        let most = match finding {
            Finding::InEachCall => usize::MAX,
            Finding::Once => MOST_ROWS,
            Finding::OfAllViews => 0,
        };
        let is_short = |light: &Light| nz > 1 && nz.min(light.pixels.rows) <= most;
        if lights.iter().all(is_short) && turned.iter().all(Self::repeats) {
            return turned;
        }
        let whole = |turned: Self| Turned {
            period: turned.period * turned.parts,
            parts: 1,
            step: 0,
            ..turned
        };
        turned.into_iter().map(whole).collect()
    }

    fn of(vial: &dyn Vial, light: &Light, grid: &VolumeGrid, views: &Views) -> Self {
        let [_, ny, nx] = grid.shape;
        let all = Turned {
            period: views.count().max(1),
            parts: 1,
            step: 0,
            voxels: [nx, ny],
        };
        let about_axis = |i: usize| grid.center_mm[i].abs() < SAME * grid.pitch_mm;
        let is_even = |n: usize| n.is_multiple_of(2);
        let looks_alike = vial.is_round() && light.map.is_none() && about_axis(0) && about_axis(1);
        if !looks_alike || !is_even(nx) || !is_even(ny) {
            return all;
        }
        let azimuths = &views.pixels(&light.pixels).azimuths;
        // The quarter in either direction where the grid is square, then the half
        let steps: &[usize] = if nx == ny { &[1, 3, 2] } else { &[2] };
        let frames = light.pixels.frames();
        let part = |&step: &usize| {
            let parts = if step == 2 { 2 } else { 4 };
            let period = frames / parts;
            let repeats = frames.is_multiple_of(parts)
                && (1..views.count()).contains(&period)
                && azimuths
                    .iter()
                    .zip(&azimuths[period..])
                    .all(|(first, next)| {
                        let turn = (next - first) / FRAC_PI_2 - step as f64;
                        (turn - 4.0 * (turn / 4.0).round()).abs() < SAME
                    });
            repeats.then(|| Turned {
                period,
                parts: views.count() / period,
                step,
                ..all
            })
        };
        steps.iter().find_map(part).unwrap_or(all)
    }

    /// Whether there are several parts.
    pub(super) fn repeats(&self) -> bool {
        self.parts > 1
    }

    /// Tiles that right angles turn into one another, each once; each alone where nothing repeats.
    pub(super) fn orbits(&self, tiles: &[Tile]) -> Vec<Vec<usize>> {
        let turns: &[usize] = match self.voxels {
            _ if !self.repeats() => &[0],
            [nx, ny] if nx == ny => &[0, 1, 2, 3],
            _ => &[0, 2],
        };
        let mut orbits: Vec<Vec<usize>> = Vec::new();
        let mut is_done = vec![false; tiles.len()];
        for (i, tile) in tiles.iter().enumerate() {
            if !is_done[i] {
                let turned = |&right_angles: &usize| {
                    let corner = turn(tile.start, self.voxels, right_angles);
                    tiles.iter().position(|tile| tile.holds(corner))
                };
                let orbit: Vec<usize> = turns.iter().filter_map(turned).collect();
                orbit.iter().for_each(|&i| is_done[i] = true);
                orbits.push(orbit);
            }
        }
        orbits
    }

    /// Where a voxel `[x, y]` of the first part lies in this one.
    pub(super) fn place_in(&self, part: usize, at: [usize; 2]) -> [usize; 2] {
        turn(at, self.voxels, part * self.step % 4)
    }

    /// Where a voxel `[x, y]` of this part lies in the first one.
    pub(super) fn origin(&self, part: usize, at: [usize; 2]) -> [usize; 2] {
        turn(at, self.voxels, (4 - part * self.step % 4) % 4)
    }

    /// By how much [`origin`](Self::origin) moves with a step along x.
    pub(super) fn origin_step(&self, part: usize) -> [isize; 2] {
        match part * self.step % 4 {
            0 => [1, 0],
            1 => [0, -1],
            2 => [-1, 0],
            _ => [0, 1],
        }
    }
}

/// Turns a place `[x, y]` among so many counter-clockwise; a quarter turn of a square alone.
fn turn([x, y]: [usize; 2], [nx, ny]: [usize; 2], right_angles: usize) -> [usize; 2] {
    match right_angles {
        0 => [x, y],
        1 => [ny - 1 - y, x],
        2 => [nx - 1 - x, ny - 1 - y],
        _ => [y, nx - 1 - x],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;
    use tomolith_core::grid::PatternGrid;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::{index_matched::IndexMatched, square::Square};

    fn parts(vial: &dyn Vial, frames: usize, shape: [usize; 3]) -> (usize, usize) {
        let pixels = PatternGrid::full_turn(frames, 0.3, 4, 8, 0.1);
        let light = Light::new(pixels, Resin::absorbing(1.5, 0.1));
        let grid = VolumeGrid::centered(shape, 0.1);
        let turned = Turned::of(vial, &light, &grid, &Views::of(vial, &light));
        (turned.period, turned.step)
    }

    #[test]
    fn round_vials_and_even_grids_about_the_axis_repeat() {
        let round = IndexMatched { radius_mm: 2.0 };
        let square = Square::new(4.0, 4.5, 1.5);
        assert_eq!(parts(&round, 12, [4, 8, 8]), (3, 1));
        assert_eq!(parts(&round, 12, [4, 6, 8]), (6, 2));
        assert_eq!(parts(&round, 6, [4, 8, 8]), (3, 2));
        assert_eq!(parts(&round, 7, [4, 8, 8]), (7, 0));
        assert_eq!(parts(&round, 12, [4, 7, 7]), (12, 0));
        assert_eq!(parts(&square, 12, [4, 8, 8]), (12, 0));
    }

    #[test]
    fn what_is_turned_comes_back() {
        let round = IndexMatched { radius_mm: 2.0 };
        for (frames, shape) in [(12, [4, 8, 8]), (12, [4, 6, 8])] {
            let pixels = PatternGrid::full_turn(frames, 0.3, 4, 8, 0.1);
            let light = Light::new(pixels, Resin::absorbing(1.5, 0.1));
            let grid = VolumeGrid::centered(shape, 0.1);
            let views = Views::of(&round, &light);
            let turned = Turned::of(&round, &light, &grid, &views);
            let turn = TAU / turned.parts as f64;
            for part in 0..turned.parts {
                let at = [1, 3];
                let there = turned.place_in(part, at);
                assert_eq!(turned.origin(part, there), at);
                let [u, v] = turned.origin(part, [2, 3]);
                let from = turned.origin(part, [1, 3]);
                let step = [u as isize - from[0] as isize, v as isize - from[1] as isize];
                assert_eq!(turned.origin_step(part), step);
                // Counter-clockwise, as azimuths are counted
                let [[x, y], [u, v]] = [at, there].map(|[x, y]| [grid.x(x), grid.y(y)]);
                let (sin, cos) = (part as f64 * turn).sin_cos();
                assert!(
                    (x * cos - y * sin - u).abs() < 1e-12 && (x * sin + y * cos - v).abs() < 1e-12
                );
            }
        }
    }
}
