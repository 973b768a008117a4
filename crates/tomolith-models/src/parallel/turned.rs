//! Views that are those of an earlier part of the turn, turned by right angles.
//!
//! A round vial looks the same from everywhere, and a square grid about the axis looks the same after a quarter turn (a rectangular one after half a turn).
//! Where the frames are those of the first quarter again and again, what a column brings to a voxel is what it brought to the voxel a quarter turn
//! before: the matrix of a slice is that of the first part of the turn. [`cached`](super::cached) finds that part alone and copies
//! it, turned.

use super::cached::EDGE;
use super::views::{SAME, Views};
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;
use tomolith_core::grid::VolumeGrid;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// How the views of a light repeat those of its first part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Turned {
    /// Views of the first part: all of them where nothing repeats.
    pub(super) period: usize,
    /// Right angles, counter-clockwise, from one part to the next.
    step: usize,
    /// Patches of the plane `[x, y]`.
    patches: [usize; 2],
}

impl Turned {
    pub(super) fn of(vial: &dyn Vial, light: &Light, grid: &VolumeGrid, views: &Views) -> Self {
        let [_, ny, nx] = grid.shape;
        let all = Turned {
            period: views.count().max(1),
            step: 0,
            patches: [nx, ny].map(|n| n.div_ceil(EDGE)),
        };
        let about_axis = |i: usize| grid.center_mm[i].abs() < SAME * grid.pitch_mm;
        let is_even = |n: usize| n.is_multiple_of(EDGE);
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
            repeats.then_some(Turned {
                period,
                step,
                ..all
            })
        };
        steps.iter().find_map(part).unwrap_or(all)
    }

    /// Right angles that views of one part are turned by.
    pub(super) fn right_angles(&self, views: &Range<usize>) -> usize {
        views.start / self.period * self.step % 4
    }

    /// Where the patch came from that lies there after so many right angles.
    pub(super) fn origin(&self, at: [usize; 2], right_angles: usize) -> [usize; 2] {
        turn(at, self.patches, (4 - right_angles) % 4)
    }

    /// Where the voxels of a patch, its first to its fourth, lie after so many right angles.
    pub(super) fn corners(right_angles: usize) -> [usize; EDGE * EDGE] {
        match right_angles {
            0 => [0, 1, 2, 3],
            1 => [1, 3, 0, 2],
            2 => [3, 2, 1, 0],
            _ => [2, 0, 3, 1],
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
        let square = Square {
            inner_width_mm: 4.0,
            outer_width_mm: 4.5,
            refractive_index: 1.5,
        };
        assert_eq!(parts(&round, 12, [4, 8, 8]), (3, 1));
        assert_eq!(parts(&round, 12, [4, 6, 8]), (6, 2));
        assert_eq!(parts(&round, 6, [4, 8, 8]), (3, 2));
        assert_eq!(parts(&round, 7, [4, 8, 8]), (7, 0));
        assert_eq!(parts(&round, 12, [4, 7, 7]), (12, 0));
        assert_eq!(parts(&square, 12, [4, 8, 8]), (12, 0));
    }

    #[test]
    fn voxels_of_a_patch_turn_as_patches_do() {
        for right_angles in 0..4 {
            for (corner, now) in Turned::corners(right_angles).into_iter().enumerate() {
                let [x, y] = turn([corner % EDGE, corner / EDGE], [EDGE; 2], right_angles);
                assert_eq!(y * EDGE + x, now);
            }
        }
    }
}
