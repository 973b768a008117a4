//! The buffer at a target's surface: which voxels lie near a voxel of the other kind.
//!
//! Exact Euclidean distances between voxel centers, by one pass of lower envelopes of parabolas per axis (Felzenszwalb and
//! Huttenlocher, Theory of Computing 8 (2012) 415). **Cost** two transforms, about 20 ns per voxel each and 4 bytes.
//!
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_core::target::Target;
//! use tomolith_objective::buffer::near_the_other_kind;
//! let grid = VolumeGrid::centered([1, 1, 6], 0.5);
//! let inside = Volume { grid, values: vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0] };
//! let target = Target { name: "wall".into(), inside, gray: false };
//! // centers of the 2nd and 4th voxel are 1 mm apart, of the 1st and 4th 1.5 mm
//! assert_eq!(near_the_other_kind(&target, 1.0), [false, true, true, true, true, false]);
//! ```

use tomolith_core::parallel::{InParallel, elements, table};
use tomolith_core::target::Target;

/// Whether each voxel (array order) has a voxel of the other kind, part or void, within `distance_mm` of its center.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "distances are f32")]
pub fn near_the_other_kind(target: &Target, distance_mm: f64) -> Vec<bool> {
    let grid = &target.inside.grid;
    let reach = (distance_mm / grid.pitch_mm).powi(2) * (1.0 + 1e-6);
    let tall = (grid.height_mm / grid.pitch_mm).powi(2) as f32;
    let part = table(grid.len(), |i| target.is_part(i));
    let mut near = vec![false; part.len()];
    for kind in [true, false] {
        let squared = squared_distances(grid.shape, tall, |i| part[i] == kind);
        elements(&mut near, |i, near| {
            *near |= part[i] != kind && f64::from(squared[i]) <= reach;
        });
    }
    near
}

/// Squared distance of every voxel to the nearest seed, in squares of a voxel's width, +∞ when there is no seed; `tall` is the
/// square of a voxel's height in the same unit.
fn squared_distances(
    shape: [usize; 3],
    tall: f32,
    seed: impl Fn(usize) -> bool + Sync,
) -> Vec<f32> {
    let [nz, ny, nx] = shape;
    let mut d = table(nz * ny * nx, |i| if seed(i) { 0.0 } else { f32::INFINITY });
    if d.is_empty() {
        return d;
    }
    // Along x and y, slice by slice
    d.chunks_mut(nx * ny).par_each(|slice| {
        let mut envelope = Envelope::default();
        for row in slice.chunks_mut(nx) {
            envelope.transform(row, 0, 1, nx);
        }
        for ix in 0..nx {
            envelope.transform(slice, ix, nx, ny);
        }
    });
    // Along z: slices of rows, turned so that each row of x is one thread's
    let mut planes: Vec<Vec<&mut [f32]>> = (0..ny).map(|_| Vec::with_capacity(nz)).collect();
    for (i, row) in d.chunks_mut(nx).enumerate() {
        planes[i % ny].push(row);
    }
    planes.iter_mut().par_each(|rows| {
        let mut envelope = Envelope::default();
        let mut line = vec![0.0f32; nz];
        for ix in 0..nx {
            for (value, row) in line.iter_mut().zip(rows.iter()) {
                *value = row[ix] / tall;
            }
            envelope.transform(&mut line, 0, 1, nz);
            for (value, row) in line.iter().zip(rows.iter_mut()) {
                row[ix] = *value * tall;
            }
        }
    });
    d
}

/// The lower envelope of the parabolas (x − i)² + fᵢ of one line.
#[derive(Default)]
struct Envelope {
    /// Vertex of each parabola of the envelope, and where it begins to be the lowest.
    pieces: Vec<(usize, f64, f64)>,
}

impl Envelope {
    /// Replaces `n` values at `first + k·stride` by the envelope at those places.
    #[expect(clippy::cast_possible_truncation, reason = "distances are f32")]
    fn transform(&mut self, values: &mut [f32], first: usize, stride: usize, n: usize) {
        self.pieces.clear();
        for i in 0..n {
            let f = f64::from(values[first + i * stride]);
            if f.is_infinite() {
                continue;
            }
            let x = i as f64;
            let begin = loop {
                let Some(&(j, g, begin)) = self.pieces.last() else {
                    break f64::NEG_INFINITY;
                };
                let y = j as f64;
                let cross = ((f + x * x) - (g + y * y)) / (2.0 * (x - y));
                if cross > begin {
                    break cross;
                }
                self.pieces.pop();
            };
            self.pieces.push((i, f, begin));
        }
        let mut piece = 0;
        for i in 0..n {
            let x = i as f64;
            while self
                .pieces
                .get(piece + 1)
                .is_some_and(|&(_, _, begin)| begin <= x)
            {
                piece += 1;
            }
            if let Some(&(j, f, _)) = self.pieces.get(piece) {
                values[first + i * stride] = ((x - j as f64).powi(2) + f) as f32;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_equal_those_of_a_search_over_all_pairs() {
        let shape = [5, 7, 6];
        let [nz, ny, nx] = shape;
        let n = nz * ny * nx;
        let seed = |i: usize| (i * 2_654_435_761) % 23 == 5;
        let place = |i: usize| [i / (ny * nx), i / nx % ny, i % nx];
        // Cubes, and voxels three times as high as wide
        for high in [1.0f32, 3.0] {
            let found = squared_distances(shape, high * high, seed);
            for (i, &found) in found.iter().enumerate() {
                let square = |j: usize| {
                    let [z, y, x] =
                        std::array::from_fn(|axis| place(i)[axis] as f32 - place(j)[axis] as f32);
                    (high * z).powi(2) + y * y + x * x
                };
                let seeds = (0..n).filter(|&j| seed(j));
                let nearest = seeds.map(square).fold(f32::INFINITY, f32::min);
                assert!((found - nearest).abs() < 1e-4, "voxel {:?}", place(i));
            }
        }
        assert!(
            squared_distances(shape, 1.0, |_| false)
                .iter()
                .all(|d| d.is_infinite())
        );
    }
}
