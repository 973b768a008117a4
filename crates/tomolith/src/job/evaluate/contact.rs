//! How much of an insert's surface a print touches.
//!
//! The surface is cut into pieces that are no longer than a voxel. A piece is touched where the voxel at its middle, one voxel out along
//! its normal, is printed: gaps below a voxel are not seen.

use crate::grid::{Volume, VolumeGrid};
use crate::report::number::significant;
use crate::target::{Role, Shape};
use serde::Serialize;
use std::fmt;
use tomolith_core::vector::{cross, dot, minus};

/// What of the surface of all inserts is touched, mm².
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Contact {
    /// The whole surface of the inserts, beyond the grid, too.
    pub(crate) insert_mm2: f64,
    /// What the target touches of it.
    pub(crate) target_mm2: f64,
    /// What the print touches of it.
    pub(crate) print_mm2: f64,
    /// What the print touches, as a share of the whole.
    pub(crate) share: f64,
    /// What the print touches of what the target touches, as a share of that.
    pub(crate) of_target: f64,
}

impl Contact {
    /// Of a print, solid above `threshold`; None without inserts.
    pub(crate) fn of(
        shape: &dyn Shape,
        inside: &Volume<f32>,
        response: &Volume<f32>,
        threshold: f64,
    ) -> Option<Self> {
        let insert = shape.body(Role::Insert)?;
        let grid = &inside.grid;
        let mut found = Contact::default();
        let mut both = 0.0;
        for mesh in insert.meshes() {
            for i in 0..mesh.triangles.len() {
                in_pieces(mesh.corners(i), grid, &mut |area, voxel| {
                    found.insert_mm2 += area;
                    let Some(voxel) = voxel else { return };
                    let wanted = inside.values[voxel] >= 0.5;
                    let printed = f64::from(response.values[voxel]) > threshold;
                    found.target_mm2 += if wanted { area } else { 0.0 };
                    found.print_mm2 += if printed { area } else { 0.0 };
                    both += if wanted && printed { area } else { 0.0 };
                });
            }
        }
        let share = |part: f64, whole: f64| if whole > 0.0 { part / whole } else { 0.0 };
        found.share = share(found.print_mm2, found.insert_mm2);
        found.of_target = share(both, found.target_mm2);
        Some(found)
    }
}

impl fmt::Display for Contact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "touched by the print on {} of {} mm² ({:.1} %): {:.1} % of the {} mm² that the target touches",
            significant(self.print_mm2, 3),
            significant(self.insert_mm2, 3),
            100.0 * self.share,
            100.0 * self.of_target,
            significant(self.target_mm2, 3)
        )
    }
}

/// Cuts a triangle at the middle of its longest edge until it is no longer than a voxel, or lies beyond the grid; gives the area of each piece
/// and the voxel one voxel out from its middle, None beyond the grid.
fn in_pieces(
    triangle: [[f64; 3]; 3],
    grid: &VolumeGrid,
    piece: &mut impl FnMut(f64, Option<usize>),
) {
    let normal = |[a, b, c]: [[f64; 3]; 3]| cross(minus(b, a), minus(c, a));
    let mut waiting = vec![triangle];
    while let Some(corners) = waiting.pop() {
        let twice = normal(corners);
        let area = dot(twice, twice).sqrt() / 2.0;
        if area == 0.0 {
            continue;
        }
        let edge = |i: usize| {
            let way = minus(corners[(i + 1) % 3], corners[i]);
            dot(way, way)
        };
        let longest = (0..3)
            .max_by(|&i, &j| edge(i).total_cmp(&edge(j)))
            .unwrap_or(0);
        if edge(longest).sqrt() > grid.pitch_mm && !is_beyond(&corners, grid) {
            let [a, b, c] = [0, 1, 2].map(|i| corners[(longest + i) % 3]);
            let middle = std::array::from_fn(|i| (a[i] + b[i]) / 2.0);
            waiting.extend([[a, middle, c], [middle, b, c]]);
            continue;
        }
        let out = grid.pitch_mm / (2.0 * area);
        let outside = std::array::from_fn(|i| {
            let middle = (corners[0][i] + corners[1][i] + corners[2][i]) / 3.0;
            middle + out * twice[i]
        });
        piece(area, voxel_at(outside, grid));
    }
}

/// Whether a triangle lies on one side of the grid, farther than the voxels next to it.
fn is_beyond(corners: &[[f64; 3]; 3], grid: &VolumeGrid) -> bool {
    let [low, high] = grid.bounds_mm();
    let far = 2.0 * grid.pitch_mm;
    (0..3).any(|i| {
        corners.iter().all(|corner| corner[i] < low[i] - far)
            || corners.iter().all(|corner| corner[i] > high[i] + far)
    })
}

fn voxel_at(place: [f64; 3], grid: &VolumeGrid) -> Option<usize> {
    let [low, _] = grid.bounds_mm();
    let edges = [grid.pitch_mm, grid.pitch_mm, grid.height_mm];
    let [nz, ny, nx] = grid.shape;
    let mut index = [0; 3];
    for (i, count) in [nx, ny, nz].into_iter().enumerate() {
        let along = (place[i] - low[i]) / edges[i];
        if !(along >= 0.0 && along < count as f64) {
            return None;
        }
        index[i] = along as usize;
    }
    Some(grid.index(index[2], index[1], index[0]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::mesh::samples::{cuboid, stl_binary};
    use crate::job::{Document, Job};
    use crate::target;

    #[test]
    fn a_sleeve_touches_the_sides_of_its_rod_as_far_as_it_is_printed() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, low: [f64; 3], high: [f64; 3]| {
            std::fs::write(folder.path().join(name), stl_binary(&cuboid(low, high))).unwrap();
        };
        // A rod of 1 × 1 × 20 mm and a block on one of its sides, 2 mm high
        write("rod.stl", [-0.5, -0.5, -10.0], [0.5, 0.5, 10.0]);
        write("block.stl", [0.5, -0.5, -1.0], [1.5, 0.5, 1.0]);
        let text = r#"
            target.body = [{ mesh = "block.stl" }, { mesh = "rod.stl", role = "insert" }]
            target.center = false
            grid.pitch_mm = 0.1
            resin = { refractive_index = 1.5, absorption_per_mm = 0.05 }
            vial.index_matched.radius_mm = 4.0
            light = [{ pixels = [60, 30], angles = 8, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        "#;
        let document = Document::toml(folder.path().join("job.toml"), text).unwrap();
        let job = Job::from_document(document).unwrap();
        let run = crate::models::Work::new();
        let shape = target::build_under(&job.spec.target, folder.path(), "target", &run).unwrap();
        let grid = VolumeGrid::centered([30, 40, 40], 0.1);
        let inside = shape.sample_under(&grid, &run).unwrap();
        // The upper half is printed
        let mut response = inside.clone();
        for (i, value) in response.values.iter_mut().enumerate() {
            *value *= f32::from(grid.middle(i)[2] > 0.0);
        }
        let found = Contact::of(shape.as_ref(), &inside, &response, 0.5).unwrap();
        assert!((found.insert_mm2 - 82.0).abs() < 1e-9, "{found:?}");
        assert!((found.target_mm2 - 2.0).abs() < 0.1, "{found:?}");
        assert!((found.print_mm2 - 1.0).abs() < 0.1, "{found:?}");
        assert!((found.of_target - 0.5).abs() < 0.05, "{found:?}");
        assert!((found.share - found.print_mm2 / 82.0).abs() < 1e-12);
    }
}
