//! A closed mesh → the fraction of each voxel that is inside.
//!
//! **Exact where the winding number is 0 or 1.** The volume that a closed surface cuts out of voxel i of an x row is a sum
//! over the pieces of the triangles in that row. Let A be the signed area of a piece's projection along x (positive when
//! its outside looks to +x) and x̄ the mean of x on it, both exact for a flat piece. A piece in voxel k (x from k to k + 1,
//! in voxels) adds A·(x̄ − k) to voxel k and A to every voxel below k (divergence theorem). So triangles are cut by the
//! voxel planes, first z, then y, then x, and one sum along the row finishes. Ties (faces on a voxel plane, shells that
//! touch, rays through an edge) need no rules: they have no area. Cost: one piece per crossed voxel.
//!
//! **Sampled where shells overlap.** There the sum counts a place twice. Rows where a line sees a winding number other
//! than 0 and 1, or the sum leaves [0, 1], and those that negative volumes reach, are computed again from 64 lines per voxel row, exact along each line:
//! inside ⇔ winding number > 0. See [`Lines`].
//!
//! Results do not depend on the number of threads: a slice is one task, and sums run in the order of the triangles.

use super::lines::{Crossing, Lines, Scaled};
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::parallel::{InParallel, table};
use tomolith_core::work::Work;
use tomolith_io::mesh::Mesh;

/// Slices that share one search for their triangles.
const SLICES: usize = 8;

/// How far the sum of a voxel may leave [0, 1], or a line run through an overlap (in voxels), before the row counts as
/// overlapped: shells that touch up to the rounding of their files do not.
const TOLERANCE: f64 = 1e-3;

/// Fractions are kept in f32, whose step below 1 is 2⁻²⁴: a sum that lies nearer to 1 becomes 1. The same holds for 0: what
/// is less than that is no material, but what rounding leaves of a sum over surfaces that cancel.
const STEP: f64 = 1.0 / (1 << 24) as f64;

fn fraction(sum: f64) -> f32 {
    if sum < STEP { 0.0 } else { sum.min(1.0) as f32 }
}

/// Inside fraction of every voxel of `grid`, for a closed mesh in mm, less what lies in the negative one.
pub(super) fn inside_fractions(
    mesh: &Mesh,
    negative: Option<&Mesh>,
    grid: &VolumeGrid,
    work: &Work,
) -> Result<Volume<f32>> {
    let mut values = zeros(grid)?;
    let [nz, ny, nx] = grid.shape;
    if !values.is_empty() {
        let scaled = Scaled::new(mesh, negative, grid);
        let mut overlapped = vec![false; nz * ny];
        let blocks = work.steps(nz.div_ceil(SLICES));
        values
            .chunks_mut(nx * ny * SLICES)
            .zip(overlapped.chunks_mut(ny * SLICES))
            .enumerate()
            .par_each(|(block, (values, overlapped))| {
                if blocks.is_canceled() {
                    return;
                }
                let first = block * SLICES;
                fill_slices(&scaled, first, [ny, nx], values, overlapped);
                blocks.add(1);
            });
        work.check()?;
        if overlapped.contains(&true) {
            let rows = with_neighbors(&overlapped, ny);
            values
                .chunks_mut(nx * ny)
                .zip(rows.chunks(ny))
                .enumerate()
                .par_each(|(iz, (slice, rows))| {
                    if rows.contains(&true) && !work.is_canceled() {
                        sample_rows(&scaled, iz, nx, rows, slice);
                    }
                });
            work.check()?;
        }
    }
    Ok(Volume::new(grid.clone(), values))
}

/// Zeros for the grid, or an error instead of an abort when there is not enough memory.
pub(super) fn zeros(grid: &VolumeGrid) -> Result<Vec<f32>> {
    let refused = |len: u128| Error::Resources {
        what: format!("memory for {:?} voxels", grid.shape),
        needed_mb: u64::try_from(len * 4 / 1_000_000).unwrap_or(u64::MAX),
        available_mb: None,
        advice: "choose a larger grid.pitch_mm".to_owned(),
    };
    let len: u128 = grid.shape.iter().map(|&n| n as u128).product();
    // A probe that may fail; zeroed memory itself comes from the system page by page, in the threads that fill it
    usize::try_from(len)
        .ok()
        .and_then(|len| Vec::<f32>::new().try_reserve_exact(len).ok())
        .ok_or_else(|| refused(len))?;
    Ok(vec![0.0; grid.len()])
}

/// The exact sums of some slices, and which rows are overlapped.
fn fill_slices(
    mesh: &Scaled,
    first: usize,
    [ny, nx]: [usize; 2],
    values: &mut [f32],
    overlapped: &mut [bool],
) {
    let slices = overlapped.len() / ny;
    let active = mesh.between(first as f64, (first + slices) as f64);
    let mut lines = Lines::default();
    let mut sums = Sums::new(ny, nx);
    for (i, (slice, overlapped)) in values
        .chunks_mut(nx * ny)
        .zip(overlapped.chunks_mut(ny))
        .enumerate()
    {
        let z = (first + i) as f64;
        for &t in &active {
            let [low, high] = mesh.z_range(t);
            if low >= z + 1.0 || high <= z {
                continue;
            }
            let corners = mesh.corners(t);
            if mesh.is_negative(t) {
                let [low, high] = Polygon::new(corners).range(1).map(|y| y.max(0.0) as usize);
                overlapped
                    .iter_mut()
                    .take(high + 1)
                    .skip(low)
                    .for_each(|row| *row = true);
            } else {
                sums.add_triangle(corners, z);
            }
        }
        sums.finish(slice, overlapped);
        // The middle line of every row looks for places that the sum counts twice
        lines.cast(mesh, &active, z + 0.5, |j| j as f64 + 0.5, 0..ny);
        lines.for_each_line(|row, crossings| {
            if !overlapped[row] {
                overlapped[row] = is_overlapped(crossings, nx as f64);
            }
        });
    }
}

/// Whether the winding number leaves {0, 1} inside the grid, over more than rounding.
fn is_overlapped(crossings: &[Crossing], nx: f64) -> bool {
    let mut winding = 0;
    crossings.windows(2).any(|pair| {
        winding += pair[0].step;
        let length = pair[1].x.min(nx) - pair[0].x.max(0.0);
        !(0..=1).contains(&winding) && length > TOLERANCE
    })
}

/// The rows and those next to them, so that the rim of an overlap is sampled too.
fn with_neighbors(rows: &[bool], ny: usize) -> Vec<bool> {
    let nz = rows.len() / ny;
    let near = |i: usize, n: usize| i.saturating_sub(1)..(i + 2).min(n);
    table(rows.len(), |i| {
        near(i / ny, nz).any(|z| near(i % ny, ny).any(|y| rows[z * ny + y]))
    })
}

/// Lines per voxel row: 16 heights with 4 lines each, all 64 at different y.
const HEIGHTS: usize = 16;
const LINES: usize = 4;

/// Computes the marked rows of slice `iz` again from lines, inside ⇔ winding number > 0.
fn sample_rows(mesh: &Scaled, iz: usize, nx: usize, rows: &[bool], slice: &mut [f32]) {
    let active = mesh.between(iz as f64, iz as f64 + 1.0);
    let mut lines = Lines::default();
    let mut sums = vec![0.0f64; slice.len()];
    for height in 0..HEIGHTS {
        let z = iz as f64 + (height as f64 + 0.5) / HEIGHTS as f64;
        // Bit-reversed, so that lines of neighboring heights lie far apart
        let shift = (f64::from((height as u8).reverse_bits() >> 4) + 0.5) / HEIGHTS as f64;
        let y = |line: usize| (line as f64 + shift) / LINES as f64;
        lines.cast(mesh, &active, z, y, 0..rows.len() * LINES);
        lines.for_each_line(|line, crossings| {
            let row = line / LINES;
            if rows[row] {
                add_inside(crossings, &mut sums[row * nx..][..nx]);
            }
        });
    }
    let share = 1.0 / (HEIGHTS * LINES) as f64;
    for (row, &marked) in rows.iter().enumerate() {
        if marked {
            let span = row * nx..(row + 1) * nx;
            for (value, sum) in slice[span.clone()].iter_mut().zip(&sums[span]) {
                *value = fraction(sum * share);
            }
        }
    }
}

/// Adds the length of the line that is inside to every voxel of the row.
fn add_inside(crossings: &[Crossing], row: &mut [f64]) {
    let end = row.len() as f64;
    let mut winding = 0;
    for pair in crossings.windows(2) {
        winding += pair[0].step;
        let (a, b) = (pair[0].x.clamp(0.0, end), pair[1].x.clamp(0.0, end));
        if winding > 0 && b > a {
            let (first, last) = (a as usize, (b as usize).min(row.len() - 1));
            for (i, value) in row.iter_mut().enumerate().take(last + 1).skip(first) {
                *value += b.min(i as f64 + 1.0) - a.max(i as f64);
            }
        }
    }
}

/// The sums of one slice: `sums[y][x]` holds differences along x until [`finish`](Self::finish).
struct Sums {
    ny: usize,
    nx: usize,
    differences: Vec<f64>,
    touched: Vec<bool>,
}

impl Sums {
    fn new(ny: usize, nx: usize) -> Self {
        Sums {
            ny,
            nx,
            differences: vec![0.0; ny * nx],
            touched: vec![false; ny],
        }
    }

    /// The part of a triangle between the planes z and z + 1.
    fn add_triangle(&mut self, corners: [[f64; 3]; 3], z: f64) {
        let [a, b, c] = corners;
        let along_x = (b[1] - a[1]) * (c[2] - a[2]) - (c[1] - a[1]) * (b[2] - a[2]);
        if along_x == 0.0 {
            return;
        }
        let mut rest = Polygon::new(corners);
        rest = rest.cut(2, z).1;
        rest = rest.cut(2, z + 1.0).0;
        let [low, _] = rest.range(1);
        let first = low.floor().max(0.0);
        if first > low {
            rest = rest.cut(1, first).1;
        }
        let mut y = first;
        while rest.len >= 3 && y < self.ny as f64 {
            let (row, above) = rest.cut(1, y + 1.0);
            self.add_row(row, y as usize);
            rest = above;
            y += 1.0;
        }
    }

    /// A piece that lies in one row.
    fn add_row(&mut self, mut rest: Polygon, row: usize) {
        let [low, high] = rest.range(0);
        if rest.len < 3 || high <= 0.0 {
            return;
        }
        self.touched[row] = true;
        let end = self.nx as f64;
        let sums = &mut self.differences[row * self.nx..][..self.nx];
        let mut x = low.floor().max(0.0);
        if x > low {
            rest = rest.cut(0, x).1;
        }
        while rest.len >= 3 && x < end {
            let (piece, beyond) = rest.cut(0, x + 1.0);
            let (area, moment) = piece.area_and_moment(x);
            let i = x as usize;
            sums[i] += moment;
            if i > 0 {
                sums[i - 1] += area - moment;
            }
            rest = beyond;
            x += 1.0;
        }
        // What lies beyond the grid has the whole row below it
        if rest.len >= 3 {
            sums[self.nx - 1] += rest.area_and_moment(0.0).0;
        }
    }

    /// Sums along the rows, writes the fractions and clears.
    fn finish(&mut self, slice: &mut [f32], overlapped: &mut [bool]) {
        for (row, overlapped) in overlapped.iter_mut().enumerate() {
            if !std::mem::take(&mut self.touched[row]) {
                continue;
            }
            let span = row * self.nx..(row + 1) * self.nx;
            let mut sum = 0.0;
            for (value, difference) in slice[span.clone()]
                .iter_mut()
                .zip(&mut self.differences[span])
                .rev()
            {
                sum += std::mem::take(difference);
                *value = fraction(sum);
                *overlapped |= !(-TOLERANCE..=1.0 + TOLERANCE).contains(&sum);
            }
        }
    }
}

/// Corners of a convex flat piece: a triangle cut by six planes has at most nine.
#[derive(Clone, Copy)]
struct Polygon {
    corners: [[f64; 3]; 10],
    len: usize,
}

impl Polygon {
    fn new(corners: [[f64; 3]; 3]) -> Self {
        let mut polygon = Polygon::EMPTY;
        corners.into_iter().for_each(|corner| polygon.push(corner));
        polygon
    }

    const EMPTY: Polygon = Polygon {
        corners: [[0.0; 3]; 10],
        len: 0,
    };

    fn push(&mut self, corner: [f64; 3]) {
        self.corners[self.len] = corner;
        self.len += 1;
    }

    fn range(&self, axis: usize) -> [f64; 2] {
        let corners = self.corners[..self.len].iter();
        corners.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], c| {
            [low.min(c[axis]), high.max(c[axis])]
        })
    }

    /// The parts below and above the plane `axis = at`.
    fn cut(&self, axis: usize, at: f64) -> (Polygon, Polygon) {
        let [low, high] = self.range(axis);
        if high <= at {
            return (*self, Polygon::EMPTY);
        }
        if low >= at {
            return (Polygon::EMPTY, *self);
        }
        let (mut below, mut above) = (Polygon::EMPTY, Polygon::EMPTY);
        let mut from = self.corners[self.len - 1];
        for &to in &self.corners[..self.len] {
            if (from[axis] < at && to[axis] > at) || (from[axis] > at && to[axis] < at) {
                let share = (at - from[axis]) / (to[axis] - from[axis]);
                let mut cut: [f64; 3] =
                    std::array::from_fn(|i| from[i] + share * (to[i] - from[i]));
                cut[axis] = at;
                below.push(cut);
                above.push(cut);
            }
            if to[axis] <= at {
                below.push(to);
            }
            if to[axis] >= at {
                above.push(to);
            }
            from = to;
        }
        (below, above)
    }

    /// Signed area A of the projection along x, and ∫ (x − origin) dA.
    fn area_and_moment(&self, origin: f64) -> (f64, f64) {
        let (mut area, mut moment) = (0.0, 0.0);
        let a = self.corners[0];
        for pair in self.corners[..self.len].windows(2).skip(1) {
            let [b, c] = [pair[0], pair[1]];
            let piece = ((b[1] - a[1]) * (c[2] - a[2]) - (c[1] - a[1]) * (b[2] - a[2])) / 2.0;
            area += piece;
            moment += piece * ((a[0] + b[0] + c[0]) / 3.0 - origin);
        }
        (area, moment)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnosis::{Repair, examine};
    use crate::placing::turned;
    use std::path::Path;
    use tomolith_core::near;
    use tomolith_io::mesh::samples::{ball, cuboid, inverted, together};

    fn sampled(mesh: Mesh, grid: &VolumeGrid) -> Volume<f32> {
        let (mesh, _) = examine(mesh, Path::new("test"), Repair::Safe, &Work::new()).unwrap();
        inside_fractions(&mesh, None, grid, &Work::new()).unwrap()
    }

    fn volume(volume: &Volume<f32>) -> f64 {
        let sum: f64 = volume.values.iter().map(|&v| f64::from(v)).sum();
        sum * volume.grid.voxel_mm3()
    }

    /// Length that [a, b] shares with [low, low + 1], all in voxels.
    fn overlap(a: f64, b: f64, low: f64) -> f64 {
        (b.min(low + 1.0) - a.max(low)).max(0.0)
    }

    #[test]
    fn a_box_fills_every_voxel_by_the_product_of_its_overlaps() {
        // Faces between, on and across voxel planes
        let (low, high) = ([0.3, 2.0, 1.25], [4.7, 5.0, 6.5]);
        let grid = VolumeGrid::centered([8, 7, 6], 1.0).about([3.0, 3.5, 4.0]);
        let volume = sampled(cuboid(low, high), &grid);
        for iz in 0..8 {
            for iy in 0..7 {
                for ix in 0..6 {
                    let exact: f64 = [ix, iy, iz]
                        .iter()
                        .enumerate()
                        .map(|(axis, &i)| overlap(low[axis], high[axis], i as f64))
                        .product();
                    let found = f64::from(*volume.at(iz, iy, ix));
                    near!(found, exact, 1e-7, "{ix} {iy} {iz}");
                }
            }
        }
    }

    #[test]
    fn the_part_of_a_mesh_beyond_the_grid_does_not_matter() {
        let mesh = turned(ball([0.0; 3], 2.0, 2), [10.0, 20.0, 30.0]);
        let wide = VolumeGrid::centered([48, 48, 48], 0.1);
        let narrow =
            VolumeGrid::centered([16, 12, 10], 0.1).about([0.1 * 11.0, 0.1 * 4.0, -0.1 * 12.0]);
        let (wide, narrow) = (sampled(mesh.clone(), &wide), sampled(mesh, &narrow));
        for iz in 0..16 {
            for iy in 0..12 {
                for ix in 0..10 {
                    let a = *narrow.at(iz, iy, ix);
                    let b = *wide.at(iz + 4, iy + 22, ix + 30);
                    assert!((a - b).abs() < 1e-6, "{ix} {iy} {iz}: {a} {b}");
                }
            }
        }
    }

    #[test]
    fn the_sum_of_the_fractions_is_the_volume_of_the_mesh() {
        let tilted = turned(cuboid([0.0; 3], [5.0, 0.7, 3.0]), [31.0, -17.0, 66.0]);
        for mesh in [ball([0.1, 0.2, 0.3], 2.5, 3), tilted] {
            let exact = mesh.signed_volume();
            for n in [16, 33, 128] {
                let grid = VolumeGrid::centered([n; 3], 6.5 / n as f64);
                let found = volume(&sampled(mesh.clone(), &grid));
                assert!((found / exact - 1.0).abs() < 1e-7, "{n}: {found} {exact}");
            }
        }
    }

    #[test]
    fn touching_shells_unite_without_a_seam() {
        let grid = VolumeGrid::centered([8, 8, 16], 0.5);
        let one = sampled(cuboid([-3.0, -1.1, -1.3], [3.0, 1.0, 1.0]), &grid);
        // Cut at x = 0.2 (inside a voxel) and at x = 1.0 (on a voxel plane), as one welded mesh and as separate shells
        let (low, high) = ([-3.0, -1.1, -1.3], [3.0, 1.0, 1.0]);
        let at = |from: f64, to: f64| cuboid([from, low[1], low[2]], [to, high[1], high[2]]);
        let parts = together(&[at(-3.0, 0.2), at(0.2, 1.0), at(1.0, 3.0)]);
        for mesh in [parts.welded(), parts] {
            let many = sampled(mesh, &grid);
            for (a, b) in one.values.iter().zip(&many.values) {
                assert!((a - b).abs() < 1e-6, "{a} {b}");
            }
        }
    }

    #[test]
    fn cavities_are_hollow_and_nested_shells_full() {
        let grid = VolumeGrid::centered([30; 3], 0.2);
        let outer = cuboid([-2.0; 3], [2.0; 3]);
        let inner = cuboid([-1.0; 3], [1.0; 3]);
        let hollow = sampled(together(&[outer.clone(), inverted(inner.clone())]), &grid);
        assert!((volume(&hollow) - 56.0).abs() < 1e-4); // 64 − 8
        assert_eq!(*hollow.at(15, 15, 15), 0.0);
        // Inside out as a whole: the same
        let whole = inverted(together(&[outer.clone(), inverted(inner.clone())]));
        assert_eq!(sampled(whole, &grid), hollow);
        let full = sampled(together(&[outer, inner]), &grid);
        assert!((volume(&full) - 64.0).abs() < 1e-4);
        assert_eq!(*full.at(15, 15, 15), 1.0);
    }

    #[test]
    fn overlapping_shells_are_their_union() {
        // Two cubes of edge 2 that share a cube of edge 1: 8 + 8 − 1
        let mesh = together(&[cuboid([-1.5; 3], [0.5; 3]), cuboid([-0.5; 3], [1.5; 3])]);
        let grid = VolumeGrid::centered([40; 3], 0.1);
        let union = sampled(mesh, &grid);
        near!(volume(&union), 15.0, 15.0 * 1e-3, "{}", volume(&union));
        assert!(union.values.iter().all(|v| (0.0..=1.0).contains(v)));
        // Two balls at distance 1, radius 1: 2·4/3·π less a lens of π·(4 + 1)·(2 − 1)²/12
        let balls = together(&[
            ball([-0.5, 0.01, 0.02], 1.0, 5),
            ball([0.5, 0.01, 0.02], 1.0, 5),
        ]);
        let exact = std::f64::consts::PI * (8.0 / 3.0 - 5.0 / 12.0);
        let union = volume(&sampled(balls, &grid));
        assert!((union / exact - 1.0).abs() < 1e-3, "{union} {exact}");
    }

    #[test]
    fn negative_volumes_are_taken_out_of_all_shells_wherever_they_end() {
        // Two shells that overlap, a rod through both that sticks out, and a box that ends flush with a face
        let part = together(&[cuboid([-2.0; 3], [2.0; 3]), cuboid([-1.0; 3], [1.0; 3])]);
        let rod = cuboid([-0.5, -0.5, -3.0], [0.5, 0.5, 3.0]);
        let flush = cuboid([1.0, 1.0, 1.0], [2.0; 3]);
        let negative = together(&[rod, flush]);
        for pitch in [0.1, 0.13] {
            let grid = VolumeGrid::centered([48; 3], pitch);
            let left = inside_fractions(&part, Some(&negative), &grid, &Work::new()).unwrap();
            let found = volume(&left);
            near!(found, (64.0 - 4.0 - 1.0), 0.05, "{pitch}");
            for (i, value) in left.values.iter().enumerate() {
                let taken = grid.middle(i);
                let half = pitch / 2.0;
                let in_rod = taken[0].abs() + half < 0.5 && taken[1].abs() + half < 0.5;
                let in_flush = taken.iter().all(|v| v - half > 1.0);
                assert!(!(in_rod || in_flush) || *value == 0.0, "{taken:?}: {value}");
            }
        }
    }

    #[test]
    fn rounding_leaves_nothing_outside_and_misses_nothing_inside() {
        let mesh = turned(ball([0.0; 3], 2.0, 4), [13.0, 29.0, 47.0]);
        let grid = VolumeGrid::centered([67; 3], 0.07);
        let values = sampled(mesh, &grid).values;
        let least = values
            .iter()
            .filter(|v| **v > 0.0)
            .fold(1.0f32, |a, b| a.min(*b));
        assert!(f64::from(least) >= STEP, "{least:e}");
        for (i, value) in values.iter().enumerate() {
            let away = grid.middle(i).iter().map(|v| v * v).sum::<f64>().sqrt();
            // Half a diagonal of a voxel; the ball of triangles is up to 1 % smaller
            if away > 2.0 + 0.061 {
                assert_eq!(*value, 0.0);
            } else if away < 1.98 - 0.061 {
                assert_eq!(*value, 1.0);
            }
        }
    }

    #[test]
    fn sampled_rows_agree_with_the_exact_sums() {
        let mesh = turned(ball([0.0; 3], 1.5, 3), [5.0, 6.0, 7.0]);
        let grid = VolumeGrid::centered([20, 18, 22], 0.2);
        let exact = sampled(mesh.clone(), &grid);
        let scaled = Scaled::new(&mesh, None, &grid);
        let (mut worst, mut sum) = (0.0f32, 0.0f64);
        for iz in 0..20 {
            let mut slice = vec![0.0; 18 * 22];
            sample_rows(&scaled, iz, 22, &[true; 18], &mut slice);
            for (a, b) in slice.iter().zip(&exact.values[iz * 18 * 22..]) {
                worst = worst.max((a - b).abs());
                sum += f64::from(a - b);
            }
        }
        assert!(worst < 0.04, "{worst}");
        assert!(
            sum.abs() * grid.voxel_mm3() < 1e-4 * mesh.signed_volume(),
            "{sum}"
        );
    }

    #[test]
    fn results_do_not_depend_on_the_number_of_threads() {
        let mesh = together(&[ball([0.0; 3], 1.0, 3), ball([0.7, 0.2, 0.1], 1.0, 3)]);
        let grid = VolumeGrid::centered([31, 30, 29], 0.13);
        let with =
            |threads| tomolith_core::check::on_threads(threads, || sampled(mesh.clone(), &grid));
        let one = with(1);
        assert_eq!(one, with(2));
        assert_eq!(one, with(8));
    }

    #[test]
    fn too_large_a_grid_is_refused() {
        let grid = VolumeGrid::centered([1 << 20; 3], 1e-3);
        let refused = inside_fractions(&cuboid([0.0; 3], [1.0; 3]), None, &grid, &Work::new());
        assert!(matches!(refused, Err(Error::Resources { .. })));
    }

    #[test]
    fn equal_shells_of_which_one_is_flipped_are_their_union() {
        let (one, two) = (cuboid([-1.5; 3], [0.5; 3]), cuboid([-0.5; 3], [1.5; 3]));
        let grid = VolumeGrid::centered([40; 3], 0.1);
        let both = sampled(together(&[one.clone(), two.clone()]), &grid);
        assert!((volume(&both) - 15.0).abs() < 1e-2, "{}", volume(&both));
        assert_eq!(
            sampled(together(&[inverted(one.clone()), two.clone()]), &grid),
            both
        );
        assert_eq!(sampled(together(&[one, inverted(two)]), &grid), both);
    }
}
