//! Walls and gaps that are too thin for the voxels of a grid.
//!
//! A voxel is part where at least half of it is inside. At a surface some voxel beside it always is; a wall thinner than half a voxel leaves shares in voxels
//! without any such neighbor, and a narrow gap leaves them in voxels without one that is void. What is in those voxels is in no label, so no metric knows of it. An
//! objective that weighs inside fractions still aims at it.
//!
//! **Limits** A wall that crosses voxels at an angle keeps some of them; what it loses beside those is not counted.
//!
//! A sheet of 0.2 voxels is all in its voxels, and none of it is part:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_target::thin::Thin;
//! let grid = VolumeGrid::centered([3, 3, 3], 0.5);
//! let values = (0..27).map(|i| if i % 3 == 1 { 0.2 } else { 0.0 }).collect();
//! let thin = Thin::of(&Volume { grid, values });
//! assert!((thin.walls_mm3 - 9.0 * 0.2 * 0.125).abs() < 1e-6 && thin.gaps_mm3 == 0.0);
//! ```

use tomolith_core::grid::Volume;
use tomolith_core::parallel::table;

/// Shares that rounding and the tips of edges leave do not count.
const SHARE: f32 = 0.02;

/// What the voxels of a grid leave out of a part, mm³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thin {
    /// Material that no voxel has as part.
    pub walls_mm3: f64,
    /// Gaps that no voxel has as void.
    pub gaps_mm3: f64,
    /// The whole part.
    pub part_mm3: f64,
}

impl Thin {
    /// Of the inside fractions of a part.
    #[must_use]
    pub fn of(inside: &Volume<f32>) -> Self {
        let [nz, ny, nx] = inside.grid.shape;
        let of_slice = |z: usize| {
            let mut sums = [0.0f64; 3];
            for (i, &share) in inside.values[z * ny * nx..(z + 1) * ny * nx]
                .iter()
                .enumerate()
            {
                sums[2] += f64::from(share);
                let at = [z, i / nx, i % nx];
                if (SHARE..0.5).contains(&share) && !has_neighbor(inside, at, |s| s >= 0.5) {
                    sums[0] += f64::from(share);
                }
                let gap = 1.0 - share;
                if gap >= SHARE && share >= 0.5 && !has_neighbor(inside, at, |s| s < 0.5) {
                    sums[1] += f64::from(gap);
                }
            }
            sums
        };
        let slices = table(nz, of_slice);
        let voxel_mm3 = inside.grid.voxel_mm3();
        let [walls_mm3, gaps_mm3, part_mm3] =
            [0, 1, 2].map(|k| voxel_mm3 * slices.iter().map(|sums| sums[k]).sum::<f64>());
        Thin {
            walls_mm3,
            gaps_mm3,
            part_mm3,
        }
    }
}

/// Whether one of the 26 voxels round `[z, y, x]` has such a share; what lies beyond the grid is void.
fn has_neighbor(inside: &Volume<f32>, [z, y, x]: [usize; 3], fits: impl Fn(f32) -> bool) -> bool {
    let [nz, ny, nx] = inside.grid.shape;
    let is_at_end = z == 0 || y == 0 || x == 0 || z + 1 == nz || y + 1 == ny || x + 1 == nx;
    let around = |i: usize, n: usize| i.saturating_sub(1)..(i + 2).min(n);
    let mut within = around(z, nz).flat_map(|z| around(y, ny).map(move |y| (z * ny + y) * nx));
    (is_at_end && fits(0.0))
        || within.any(|row| around(x, nx).any(|x| fits(inside.values[row + x])))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{TargetSpec, build, voxelize};
    use tomolith_core::grid::VolumeGrid;
    use tomolith_core::near;

    #[test]
    fn parts_that_voxels_resolve_lose_nothing() {
        for part in ["sphere", "gear", "gyroid", "dog_bones"] {
            let spec: TargetSpec =
                toml::from_str(&format!("phantom = \"{part}\"\nsize_mm = 4.0")).unwrap();
            let shape = build(&spec, std::path::Path::new("."), "target").unwrap();
            let grid = VolumeGrid::centered([41, 41, 41], 0.1);
            let thin = Thin::of(&voxelize(&*shape, &spec.name(), &grid).unwrap().inside);
            assert!(thin.walls_mm3 < 1e-3 * thin.part_mm3, "{part}: {thin:?}");
            assert!(thin.gaps_mm3 < 1e-3 * thin.part_mm3, "{part}: {thin:?}");
        }
    }

    #[test]
    fn a_slit_between_two_voxels_is_a_gap() {
        let grid = VolumeGrid::centered([5, 5, 6], 0.1);
        // 0.04 mm in the middle of a block, 0.02 in each of two voxels
        let values = (0..150).map(|i| if matches!(i % 6, 2 | 3) { 0.8 } else { 1.0 });
        let thin = Thin::of(&Volume {
            grid,
            values: values.collect(),
        });
        // The voxels at the ends of the grid have void beside them
        near!(thin.gaps_mm3, 9.0 * 0.04 * 0.01, 1e-7);
        assert_eq!(thin.walls_mm3, 0.0);
    }
}
