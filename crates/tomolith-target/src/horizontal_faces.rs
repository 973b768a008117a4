//! Where the horizontal faces of a part lie, and how large they are.
//!
//! Level light ends with a row of pixels, so a horizontal face prints at an edge of a row. What that costs follows from heights and areas alone.
//!
//! **Method** Of a mesh they are its level triangles. Else, along every column of voxels the inside fraction rises where material begins and falls where it ends. Two changes of one sign that follow each other are one face
//! within a voxel, at the mean of their heights; so a flat face lies where it is, to an eighth of a voxel, and not where a voxel ends. Slanted surfaces are faces of
//! every height, so a layer one voxel high counts where its faces are more than three times the median of its neighbors', eight to each side, with what they are more than that.
//!
//! **Cost** One pass over the triangles; or one over the voxels, in parallel.
//!
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_target::HorizontalFaces;
//! // One column of voxels of 1 mm from z = −2 to 2: the part begins at −1 and ends in the middle of the last voxel
//! let grid = VolumeGrid::centered([4, 1, 1], 1.0);
//! let faces = HorizontalFaces::of(&Volume { grid, values: vec![0.0, 1.0, 1.0, 0.5] });
//! assert_eq!(faces.volume_mm3, 2.5);
//! assert_eq!(faces.areas, [(-1.0, 1.0), (1.5, 1.0)]);
//! ```

use tomolith_core::grid::Volume;
use tomolith_core::parallel::InParallel;
use tomolith_io::mesh::Mesh;

/// Heights that a voxel is divided into.
const HEIGHTS: usize = 8;
/// Layers to each side that a layer is compared with, and how many times their median makes flat faces of its own.
const NEIGHBORS: usize = 8;
const STANDS_OUT: f64 = 3.0;
/// Changes of the inside fraction below this are rounding.
const LEAST: f32 = 1e-3;

/// A triangle that rises by less is level, mm; level ones that lie so near each other have one height.
const LEVEL_MM: f64 = 1e-3;

/// The horizontal faces of a part, without slanted surfaces.
#[derive(Clone, Debug, PartialEq)]
pub struct HorizontalFaces {
    /// Volume of the part, mm³.
    pub volume_mm3: f64,
    /// Heights z, mm, from the lowest, and the area of all faces there, mm².
    pub areas: Vec<(f64, f64)>,
}

impl HorizontalFaces {
    /// Those of a closed mesh of a known volume, mm³.
    #[must_use]
    pub fn of_mesh(mesh: &Mesh, volume_mm3: f64) -> Self {
        let level = (0..mesh.triangles.len()).filter_map(|i| {
            let [a, b, c] = mesh.corners(i);
            let low = a[2].min(b[2]).min(c[2]);
            let is_level = a[2].max(b[2]).max(c[2]) - low <= LEVEL_MM;
            let along = |axis: usize| [b[axis] - a[axis], c[axis] - a[axis]];
            let ([bx, cx], [by, cy]) = (along(0), along(1));
            is_level.then(|| (low, (bx * cy - by * cx).abs() / 2.0))
        });
        let mut level: Vec<(f64, f64)> = level.collect();
        level.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut areas: Vec<(f64, f64)> = Vec::new();
        for (height, area) in level {
            match areas.last_mut() {
                Some(face) if height - face.0 <= LEVEL_MM => face.1 += area,
                _ => areas.push((height, area)),
            }
        }
        HorizontalFaces { volume_mm3, areas }
    }

    /// Those of a part of whose voxels these fractions are inside, 0…1.
    #[must_use]
    pub fn of(inside: &Volume<f32>) -> Self {
        let grid = &inside.grid;
        let [slices, rows, _] = grid.shape;
        let of_rows = (0..rows).par_map(|row| areas_of_row(inside, row));
        let mut areas = vec![0.0; slices * HEIGHTS + 1];
        for row in of_rows {
            areas
                .iter_mut()
                .zip(row)
                .for_each(|(sum, area)| *sum += area);
        }
        let voxel_mm2 = grid.pitch_mm.powi(2);
        let bottom = grid.z(0) - grid.height_mm / 2.0;
        let height = |i: usize| bottom + i as f64 / HEIGHTS as f64 * grid.height_mm;
        let sum = |slice: &[f32]| slice.iter().map(|&share| f64::from(share)).sum::<f64>();
        let slices = inside.values.chunks(grid.shape[1] * grid.shape[2]);
        let filled: f64 = slices.par_map(sum).into_iter().sum();
        HorizontalFaces {
            volume_mm3: filled * voxel_mm2 * grid.height_mm,
            areas: (flat(&areas).into_iter().enumerate())
                .filter(|(_, area)| *area > 0.0)
                .map(|(i, area)| (height(i), area * voxel_mm2))
                .collect(),
        }
    }
}

/// Areas without those of slanted surfaces, for every height.
fn flat(areas: &[f64]) -> Vec<f64> {
    // Layers around the faces of voxels
    let layer = |i: usize| (i + HEIGHTS / 2) / HEIGHTS;
    let mut sums = vec![0.0; layer(areas.len() - 1) + 1];
    for (i, area) in areas.iter().enumerate() {
        sums[layer(i)] += area;
    }
    let share = |l: usize| {
        let below = sums[l.saturating_sub(NEIGHBORS)..l].iter();
        let above = sums[l + 1..].iter().take(NEIGHBORS);
        let mut neighbors: Vec<f64> = below.chain(above).copied().collect();
        neighbors.sort_by(f64::total_cmp);
        let median = neighbors.get(neighbors.len() / 2).copied().unwrap_or(0.0);
        let stands_out = sums[l] > STANDS_OUT * median;
        if stands_out {
            1.0 - median / sums[l]
        } else {
            0.0
        }
    };
    let shares: Vec<f64> = (0..sums.len()).map(share).collect();
    let of_height = |(i, area): (usize, &f64)| area * shares[layer(i)];
    areas.iter().enumerate().map(of_height).collect()
}

/// Areas, in voxels, of the faces in one row of columns, for every height.
fn areas_of_row(inside: &Volume<f32>, row: usize) -> Vec<f64> {
    let [slices, rows, columns] = inside.grid.shape;
    let mut areas = vec![0.0; slices * HEIGHTS + 1];
    let mut add = |change: f32, height: f64| {
        areas[(height * HEIGHTS as f64).round() as usize] += f64::from(change.abs());
    };
    let nothing = vec![0.0; columns];
    let mut below = &nothing[..];
    // The change at the end of the slice before, that is not yet known to be a whole face
    let mut open = vec![0.0f32; columns];
    for z in 0..=slices {
        let above = match z < slices {
            true => &inside.values[(z * rows + row) * columns..][..columns],
            false => &nothing,
        };
        for ((open, &below), &above) in open.iter_mut().zip(below).zip(above) {
            let change = if (above - below).abs() < LEAST {
                0.0
            } else {
                above - below
            };
            if *open == 0.0 {
                *open = change;
            } else if *open * change > 0.0 {
                let face = *open + change;
                add(face, z as f64 - f64::from(*open / face));
                *open = 0.0;
            } else {
                add(*open, z as f64 - 1.0);
                *open = change;
            }
        }
        below = above;
    }
    for change in open.into_iter().filter(|&change| change != 0.0) {
        add(change, slices as f64);
    }
    areas
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::VolumeGrid;

    #[test]
    fn level_triangles_of_a_mesh_are_its_faces_at_their_exact_heights() {
        // A wedge: its base of 2 × 1 mm at z = 0.3, its back upright, its top slanted but for a step of 0.5 mm² at 1.3
        let vertices = [
            [0.0, 0.0, 0.3],
            [2.0, 0.0, 0.3],
            [2.0, 1.0, 0.3],
            [0.0, 1.0, 0.3],
            [0.0, 0.0, 1.3],
            [0.5, 0.0, 1.3],
            [0.5, 1.0, 1.3],
            [0.0, 1.0, 1.3],
        ];
        let triangles = [
            [0, 2, 1],
            [0, 3, 2],
            [4, 5, 6],
            [4, 6, 7],
            [5, 1, 2],
            [5, 2, 6],
        ];
        let mesh = Mesh {
            vertices: vertices.to_vec(),
            triangles: triangles.to_vec(),
        };
        let faces = HorizontalFaces::of_mesh(&mesh, 1.25);
        assert_eq!(faces.areas, [(0.3, 2.0), (1.3, 0.5)]);
    }

    #[test]
    fn a_cone_has_its_base_alone_and_a_plate_on_it_two_faces() {
        // A cone 2 mm high on z = −1.03 with a base of 2 mm, sampled in 8 heights of a voxel, and a plate of 0.33 mm at its tip
        let grid = VolumeGrid::centered([60, 60, 60], 0.05);
        let inside = |[x, y, z]: [f64; 3]| {
            let (radius, z) = (x.hypot(y), z + 1.03);
            (0.0..2.0).contains(&z) && radius < 1.0 - z / 2.0
                || (1.8..2.13).contains(&z) && radius < 0.8
        };
        let fraction = |i: usize| {
            let [x, y, z] = grid.middle(i);
            let heights = (0..8).map(|k| z + ((f64::from(k) + 0.5) / 8.0 - 0.5) * 0.05);
            heights.filter(|&z| inside([x, y, z])).count() as f32 / 8.0
        };
        let values = (0..grid.len()).map(fraction).collect();
        let faces = HorizontalFaces::of(&Volume { grid, values });
        let pi = std::f64::consts::PI;
        for (height, expected) in [(-1.03, pi), (0.77, 0.63 * pi), (1.1, 0.64 * pi)] {
            let near = faces
                .areas
                .iter()
                .filter(|(z, _)| (z - height).abs() < 0.03);
            let area: f64 = near.map(|(_, area)| area).sum();
            assert!(
                (area / expected - 1.0).abs() < 0.06,
                "{height}: {area} {faces:?}"
            );
        }
        let all: f64 = faces.areas.iter().map(|(_, area)| area).sum();
        assert!((all / (2.27 * pi) - 1.0).abs() < 0.04, "{all}");
    }
}
