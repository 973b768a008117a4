//! What should be printed, on voxels: the share of each that is inside, and which are part, void or uncounted.

use crate::grid::Volume;
use crate::parallel::{InParallel, table};

/// A shape sampled on a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Name of the part, for files and titles.
    pub name: String,
    /// Inside fraction, or gray values when `gray`.
    pub inside: Volume<f32>,
    /// Whether the values are gray values to be reproduced.
    pub gray: bool,
}

impl Target {
    /// Whether a voxel is part: its inside fraction is at least one half.
    #[must_use]
    pub fn is_part(&self, index: usize) -> bool {
        self.inside.values[index] >= 0.5
    }
}

/// Labels of voxels: a byte each.
pub mod label {
    /// Outside the resin or the region that counts: weight 0, in no metric.
    pub const OUTSIDE: u8 = 0;
    /// Must stay liquid.
    pub const VOID: u8 = 1;
    /// Must turn solid.
    pub const PART: u8 = 2;
}

/// Labels every voxel: part where the inside fraction is at least one half, void elsewhere, [`label::OUTSIDE`] where
/// `counts([x, y, z])` (mm, voxel center) is false.
pub fn label_voxels(target: &Target, counts: impl Fn([f64; 3]) -> bool + Sync) -> Volume<u8> {
    let grid = &target.inside.grid;
    let nx = grid.shape[2];
    label_slices(target, |iz, i| {
        counts([grid.x(i % nx), grid.y(i / nx), grid.z(iz)])
    })
}

/// As [`label_voxels`], where the same columns of voxels count at every height: each column is looked up once.
pub fn label_columns(target: &Target, counts: impl Fn([f64; 2]) -> bool + Sync) -> Volume<u8> {
    let grid = &target.inside.grid;
    let [_, ny, nx] = grid.shape;
    let plane = table(nx * ny, |i| counts([grid.x(i % nx), grid.y(i / nx)]));
    label_slices(target, |_, i| plane[i])
}

/// Labels by slice, and by voxel of the slice.
fn label_slices(target: &Target, counts: impl Fn(usize, usize) -> bool + Sync) -> Volume<u8> {
    let grid = &target.inside.grid;
    let [_, ny, nx] = grid.shape;
    let mut values = vec![label::OUTSIDE; grid.len()];
    if !values.is_empty() {
        values
            .chunks_mut(nx * ny)
            .enumerate()
            .par_each(|(iz, slice)| {
                for (i, value) in slice.iter_mut().enumerate() {
                    if counts(iz, i) {
                        *value = if target.is_part(iz * nx * ny + i) {
                            label::PART
                        } else {
                            label::VOID
                        };
                    }
                }
            });
    }
    Volume::new(grid.clone(), values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VolumeGrid;

    #[test]
    fn columns_are_labeled_as_their_voxels_are() {
        let grid = VolumeGrid::centered([3, 5, 7], 0.1);
        let values = (0..grid.len()).map(|i| (i % 4) as f32 / 3.0).collect();
        let target = Target {
            inside: Volume { grid, values },
            name: String::new(),
            gray: false,
        };
        let counts = |x: f64, y: f64| x.hypot(y) < 0.25;
        let labels = label_columns(&target, |[x, y]| counts(x, y));
        assert_eq!(labels, label_voxels(&target, |[x, y, _]| counts(x, y)));
        let count_of = |wanted| labels.values.iter().filter(|l| **l == wanted).count();
        assert!(
            [label::OUTSIDE, label::VOID, label::PART]
                .map(count_of)
                .iter()
                .all(|n| *n > 3)
        );
    }
}
