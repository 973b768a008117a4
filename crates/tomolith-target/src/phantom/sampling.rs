//! A form → the fraction of each voxel that is inside.
//!
//! Blocks of voxels farther from the surface than their corners are full or empty; the others are halved down to 2³ voxels.
//! What a nearly flat surface leaves of each is the share that its plane cuts off, from seven distances for the eight;
//! where it bends, at the form's edges above all, voxels are looked at one by one and halved on, down to 4³ cells (upright prisms: 8² cells of the
//! outline times the exact overlap of heights), and a cell of edge c at signed distance d counts clamp(½ − d/c, 0, 1).
//! Over a wall in any direction the errors of the cells cancel, so that volumes converge with the square of the voxel.

use super::{Body, GrayForm, Prism};
use crate::placing::Map;
use crate::voxels::zeros;
use tomolith_core::error::Result;
use tomolith_core::grid::{Volume, VolumeGrid, sample};
use tomolith_core::parallel::InParallel;
use tomolith_core::work::Work;

/// Cells along the edge of a voxel of a solid, a power of two.
const CELLS: usize = 4;

/// Sum over the axes by which the distance may leave a straight line, between the middle of a cube and its faces, for the
/// surface to count as flat there; as a share of the edge.
const MOST_BEND: f64 = 0.02;

/// Least slope of a distance that is trusted to be one.
const LEAST_SLOPE: f64 = 0.5;

/// Voxels along the edge of a block that is looked at as a whole, a power of two.
const BLOCK: usize = 16;

/// Cells along the edge of a voxel of an outline.
const OUTLINE_CELLS: usize = 8;

/// Points along the edge of a pixel of gray values.
const GRAY_CELLS: usize = 4;

/// Inside fraction (or gray value) of every voxel of `grid` for a body placed by `map`.
///
/// # Errors
/// [`Error::Resources`](tomolith_core::Error::Resources) when the memory cannot be had; [`Error::Canceled`](tomolith_core::Error::Canceled).
pub fn inside_fractions(
    body: &Body,
    map: &Map,
    grid: &VolumeGrid,
    work: &Work,
) -> Result<Volume<f32>> {
    let mut values = zeros(grid)?;
    if !values.is_empty() {
        match body {
            Body::Prisms(prisms) if map.rotation[2] == [0.0, 0.0, 1.0] => {
                fill_upright(prisms, map, grid, &mut values);
            }
            Body::Prisms(prisms) => {
                fill_solid(&|p| nearest(prisms, p), map, grid, &mut values, work)
            }
            Body::Solid(surface) => fill_solid(surface, map, grid, &mut values, work),
            Body::GrayFunction(form) => fill_gray(form, map, grid, &mut values),
        }
    }
    work.check()?;
    Ok(Volume::new(grid.clone(), values))
}

impl Body {
    /// Signed distance to the surface, or less; None for gray values.
    pub(super) fn distance(&self, p: [f64; 3]) -> Option<f64> {
        match self {
            Body::Prisms(prisms) => Some(nearest(prisms, p)),
            Body::Solid(surface) => Some(surface(p)),
            Body::GrayFunction(_) => None,
        }
    }
}

/// Signed distance to a union of prisms.
fn nearest(prisms: &[Prism], p: [f64; 3]) -> f64 {
    let each = prisms.iter().map(|prism| prism.distance(p));
    each.fold(f64::INFINITY, f64::min)
}

impl Prism {
    fn distance(&self, p: [f64; 3]) -> f64 {
        let vertical = (self.z[0] - p[2]).max(p[2] - self.z[1]);
        let lateral = (self.outline)([p[0], p[1]]);
        if vertical > 0.0 && lateral > 0.0 {
            vertical.hypot(lateral)
        } else {
            vertical.max(lateral)
        }
    }
}

/// Share of a cell of edge `cell` at signed distance `d` from a flat wall.
fn share(d: f64, cell: f64) -> f64 {
    (0.5 - d / cell).clamp(0.0, 1.0)
}

fn fill_upright(prisms: &[Prism], map: &Map, grid: &VolumeGrid, values: &mut [f32]) {
    let [_, ny, nx] = grid.shape;
    for prism in prisms {
        let outline = outline_fractions(prism, map, grid);
        let heights = height_shares(prism.z, map, grid);
        values
            .chunks_mut(nx * ny)
            .zip(&heights)
            .filter(|(_, height)| **height > 0.0)
            .par_each(|(slice, height)| {
                for (value, share) in slice.iter_mut().zip(&outline) {
                    *value = value.max((share * height) as f32);
                }
            });
    }
}

/// Share of every slice that lies between two heights of the form.
fn height_shares(z: [f64; 2], map: &Map, grid: &VolumeGrid) -> Vec<f64> {
    let ends = z.map(|z| map.apply([0.0, 0.0, z])[2]);
    let half = grid.pitch_mm / 2.0;
    (0..grid.shape[0])
        .map(|iz| {
            let overlap = ends[1].min(grid.z(iz) + half) - ends[0].max(grid.z(iz) - half);
            (overlap / grid.pitch_mm).clamp(0.0, 1.0)
        })
        .collect()
}

/// Gray values: the mean over 4² points of every pixel, times the share of its height.
fn fill_gray(form: &GrayForm, map: &Map, grid: &VolumeGrid, values: &mut [f32]) {
    let [_, ny, nx] = grid.shape;
    let cell = grid.pitch_mm / GRAY_CELLS as f64;
    let mut layer = vec![0.0f64; nx * ny];
    layer.chunks_mut(nx).enumerate().par_each(|(iy, row)| {
        for (ix, value) in row.iter_mut().enumerate() {
            let offset = |i| sample(i, GRAY_CELLS, cell);
            let sum: f64 = (0..GRAY_CELLS * GRAY_CELLS)
                .map(|i| {
                    let x = grid.x(ix) + offset(i % GRAY_CELLS);
                    let p = map.undo([x, grid.y(iy) + offset(i / GRAY_CELLS), 0.0]);
                    (form.value)([p[0], p[1]])
                })
                .sum();
            *value = sum / (GRAY_CELLS * GRAY_CELLS) as f64;
        }
    });
    values
        .chunks_mut(nx * ny)
        .zip(height_shares(form.z, map, grid))
        .filter(|(_, height)| *height > 0.0)
        .par_each(|(slice, height)| {
            for (value, gray) in slice.iter_mut().zip(&layer) {
                *value = (gray * height) as f32;
            }
        });
}

/// Share of every pixel `[y, x]` that is inside the outline.
fn outline_fractions(prism: &Prism, map: &Map, grid: &VolumeGrid) -> Vec<f64> {
    let [_, ny, nx] = grid.shape;
    let pitch = grid.pitch_mm;
    let cell = pitch / OUTLINE_CELLS as f64;
    let distance = |x: f64, y: f64| {
        let p = map.undo([x, y, 0.0]);
        map.scale * (prism.outline)([p[0], p[1]])
    };
    let mut fractions = vec![0.0; nx * ny];
    fractions.chunks_mut(nx).enumerate().par_each(|(iy, row)| {
        for (ix, value) in row.iter_mut().enumerate() {
            let (x, y) = (grid.x(ix), grid.y(iy));
            let middle = distance(x, y);
            *value =
                if middle.abs() >= (pitch - cell) * std::f64::consts::FRAC_1_SQRT_2 + cell / 2.0 {
                    f64::from(middle < 0.0)
                } else {
                    let offset = |i| sample(i, OUTLINE_CELLS, cell);
                    let sum: f64 = (0..OUTLINE_CELLS * OUTLINE_CELLS)
                        .map(|i| {
                            let (i, j) = (i % OUTLINE_CELLS, i / OUTLINE_CELLS);
                            share(distance(x + offset(i), y + offset(j)), cell)
                        })
                        .sum();
                    sum / (OUTLINE_CELLS * OUTLINE_CELLS) as f64
                };
        }
    });
    fractions
}

fn fill_solid(surface: SurfaceRef, map: &Map, grid: &VolumeGrid, values: &mut [f32], work: &Work) {
    let [nz, ny, nx] = grid.shape;
    let octree = Octree { surface, map, grid };
    let rows = work.steps(nz.div_ceil(BLOCK) * ny.div_ceil(BLOCK));
    values
        .chunks_mut(nx * ny * BLOCK)
        .enumerate()
        .par_each(|(slab, values)| {
            for iy in (0..ny).step_by(BLOCK) {
                if rows.is_canceled() {
                    return;
                }
                rows.add(1);
                for ix in (0..nx).step_by(BLOCK) {
                    octree.fill_block([ix, iy, slab * BLOCK], BLOCK, slab * BLOCK, values);
                }
            }
        });
}

type SurfaceRef<'a> = &'a (dyn Fn([f64; 3]) -> f64 + Send + Sync);

/// Blocks of voxels, halved down to single voxels and then to cells wherever the surface may pass.
struct Octree<'a> {
    surface: SurfaceRef<'a>,
    map: &'a Map,
    grid: &'a VolumeGrid,
}

impl Octree<'_> {
    /// Share of a cube about `middle` with edge `edge` (mm), when no cell in it is cut by the surface.
    fn uniform(&self, middle: [f64; 3], edge: f64) -> Result<f64, f64> {
        let cell = self.grid.pitch_mm / CELLS as f64;
        let d = self.map.scale * (self.surface)(self.map.undo(middle));
        // The middles of the outermost cells lie this far from the middle of the cube
        let reach = (edge - cell) * 3f64.sqrt() / 2.0;
        if d.abs() >= reach + cell / 2.0 {
            Ok(f64::from(d < 0.0))
        } else {
            Err(d)
        }
    }

    /// Fills the voxels from `first` = [x, y, z] on, `size` along each axis; `values` starts at the slice `z0`.
    fn fill_block(&self, first: [usize; 3], size: usize, z0: usize, values: &mut [f32]) {
        let [nz, ny, nx] = self.grid.shape;
        let [x, y, z] = first;
        if x >= nx || y >= ny || z >= nz {
            return;
        }
        let pitch = self.grid.pitch_mm;
        let half = (size - 1) as f64 / 2.0 * pitch;
        let middle = [
            self.grid.x(x) + half,
            self.grid.y(y) + half,
            self.grid.z(z) + half,
        ];
        match self.uniform(middle, size as f64 * pitch) {
            Ok(share) => {
                for iz in z..(z + size).min(nz) {
                    for iy in y..(y + size).min(ny) {
                        let row = ((iz - z0) * ny + iy) * nx;
                        values[row + x..row + (x + size).min(nx)].fill(share as f32);
                    }
                }
            }
            Err(d) if size == 2 && self.fill_flat(first, middle, d, z0, values) => {}
            Err(_) if size > 1 => {
                let size = size / 2;
                for i in 0..8 {
                    let child = [
                        x + (i & 1) * size,
                        y + (i >> 1 & 1) * size,
                        z + (i >> 2) * size,
                    ];
                    self.fill_block(child, size, z0, values);
                }
            }
            Err(d) => {
                let index = ((z - z0) * ny + y) * nx + x;
                values[index] = self.cut_share(middle, pitch, d) as f32;
            }
        }
    }

    /// Fills a block of 2³ voxels that a nearly flat surface cuts; false where it bends too much.
    fn fill_flat(
        &self,
        first: [usize; 3],
        middle: [f64; 3],
        d: f64,
        z0: usize,
        values: &mut [f32],
    ) -> bool {
        let Some(flat) = self.flat(middle, 2.0 * self.grid.pitch_mm, d) else {
            return false;
        };
        let [nz, ny, nx] = self.grid.shape;
        for i in 0..8 {
            let [x, y, z] = [0, 1, 2].map(|axis| first[axis] + (i >> axis & 1));
            if x < nx && y < ny && z < nz {
                values[((z - z0) * ny + y) * nx + x] = flat.half(i).share() as f32;
            }
        }
        true
    }

    /// Share of a cut cube, with the distance `d` of its middle: that of the plane through it where the surface is flat
    /// enough, else of its halves, down to cells.
    fn cut_share(&self, middle: [f64; 3], edge: f64, d: f64) -> f64 {
        let cell = self.grid.pitch_mm / CELLS as f64;
        if edge < 1.5 * cell {
            return share(d, cell);
        }
        if let Some(flat) = self.flat(middle, edge, d) {
            return flat.share();
        }
        let half = edge / 2.0;
        let sum: f64 = (0..8)
            .map(|i| {
                let side = |axis: usize| {
                    if i >> axis & 1 == 0 {
                        -half / 2.0
                    } else {
                        half / 2.0
                    }
                };
                let child = std::array::from_fn(|axis| middle[axis] + side(axis));
                self.uniform(child, half)
                    .unwrap_or_else(|d| self.cut_share(child, half, d))
            })
            .sum();
        sum / 8.0
    }

    /// The surface in a cube where it is nearly flat, from the distances at the middles of the cube's six faces. None where
    /// they bend too much or hardly change, at edges of the form above all.
    fn flat(&self, middle: [f64; 3], edge: f64, d: f64) -> Option<Flat> {
        let (mut slopes, mut bends) = ([0.0; 3], [0.0f64; 3]);
        for axis in 0..3 {
            let [low, high] = [-0.5, 0.5].map(|side| {
                let mut at = middle;
                at[axis] += side * edge;
                self.map.scale * (self.surface)(self.map.undo(at))
            });
            slopes[axis] = high - low;
            bends[axis] = high + low - 2.0 * d;
        }
        let bend: f64 = bends.iter().map(|b| b.abs()).sum();
        // Where four corners meet the distance is flat and small, and says nothing about the surface
        let slope: f64 = slopes.iter().map(|s| s.abs()).sum();
        let flat = bend <= MOST_BEND * edge && slope >= LEAST_SLOPE * edge;
        flat.then_some(Flat { d, slopes, bends })
    }
}

/// A nearly flat surface in a cube of edge 1: distance d + Σ (slope·p + 2·bend·p²) at p from the middle.
struct Flat {
    d: f64,
    slopes: [f64; 3],
    bends: [f64; 3],
}

impl Flat {
    /// Share of the cube that is inside: of the plane, moved to where the mean of the distance over the cube is right.
    fn share(&self) -> f64 {
        plane_share(self.d + self.bends.iter().sum::<f64>() / 6.0, self.slopes)
    }

    /// The same surface in one of the cube's eight halves; bit i of `which`: the upper half along axis i.
    fn half(&self, which: usize) -> Flat {
        let mut half = Flat {
            d: self.d,
            slopes: self.slopes.map(|s| s / 2.0),
            bends: self.bends.map(|b| b / 4.0),
        };
        for axis in 0..3 {
            let at = if which >> axis & 1 == 0 { -0.25 } else { 0.25 };
            half.d += self.slopes[axis] * at + 2.0 * self.bends[axis] * at * at;
            half.slopes[axis] += 2.0 * self.bends[axis] * at;
        }
        half
    }
}

/// Share of the unit cube about the origin where d + slopes·p < 0: with a = |slopes|, t = Σa/2 − d and all subsets S of the
/// axes, Σ (−1)^|S| max(0, t − Σ_S a)³ / (6·a₁·a₂·a₃).
fn plane_share(d: f64, slopes: [f64; 3]) -> f64 {
    let sum: f64 = slopes.iter().map(|s| s.abs()).sum();
    if sum <= 2.0 * d.abs() {
        return f64::from(d < 0.0);
    }
    // Walls along an axis: a slope of zero would be 0/0, and a tiny one loses digits
    let a = slopes.map(|s| s.abs().max(1e-4 * sum));
    let t = a.iter().sum::<f64>() / 2.0 - d;
    let sum: f64 = (0..8)
        .map(|subset| {
            let (mut rest, mut sign) = (t, 1.0);
            for (axis, a) in a.iter().enumerate() {
                if subset >> axis & 1 == 1 {
                    rest -= a;
                    sign = -sign;
                }
            }
            sign * rest.max(0.0).powi(3)
        })
        .sum();
    (sum / (6.0 * a[0] * a[1] * a[2])).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;

    #[test]
    fn planes_cut_off_what_counting_points_says() {
        let count = |d: f64, s: [f64; 3]| {
            const N: usize = 60;
            let at = |i: usize| sample(i, N, 1.0 / N as f64);
            let inside = (0..N * N * N).filter(|i| {
                d + s[0] * at(i % N) + s[1] * at(i / N % N) + s[2] * at(i / N / N) < 0.0
            });
            inside.count() as f64 / (N * N * N) as f64
        };
        for slopes in [
            [0.5, -0.6, 0.62],
            [0.9, 0.1, -0.4],
            [-0.3, 0.8, 0.0],
            [0.0, 0.0, 1.0],
        ] {
            for d in [-0.9, -0.31, -0.1, 0.0, 0.07, 0.4, 0.8] {
                let (found, expected) = (plane_share(d, slopes), count(d, slopes));
                near!(found, expected, 0.01, "{slopes:?} {d}");
            }
        }
        // A corner of the unit cube: legs of ½ cut off a tetrahedron of (½)³/6
        assert!((plane_share(1.0, [1.0; 3]) - 1.0 / 48.0).abs() < 1e-12);
        // A wall along an axis is exact to the floor of the slopes
        assert!((plane_share(0.2, [0.0, 1.0, 0.0]) - 0.3).abs() < 1e-7);
    }

    /// The largest and the rms error of fractions against 16³ points in every voxel.
    fn errors(surface: impl Fn([f64; 3]) -> f64 + Send + Sync + 'static, n: usize) -> [f64; 2] {
        const POINTS: usize = 16;
        let grid = VolumeGrid::centered([n; 3], 2.3 / n as f64);
        let surface: super::super::ImplicitSurface = Box::new(surface);
        let body = Body::Solid(surface);
        let found = inside_fractions(&body, &Map::IDENTITY, &grid, &Work::new()).unwrap();
        let Body::Solid(surface) = body else {
            unreachable!()
        };
        let at = |i: usize| sample(i, POINTS, grid.pitch_mm / POINTS as f64);
        let (mut worst, mut squares, mut cut) = (0.0f64, 0.0, 0);
        for (i, &share) in found.values.iter().enumerate() {
            let middle = grid.middle(i);
            if surface(middle).abs() > grid.pitch_mm {
                continue;
            }
            let inside = (0..POINTS.pow(3)).filter(|i| {
                let [x, y, z] = [i % POINTS, i / POINTS % POINTS, i / POINTS / POINTS];
                surface([middle[0] + at(x), middle[1] + at(y), middle[2] + at(z)]) < 0.0
            });
            let exact = inside.count() as f64 / POINTS.pow(3) as f64;
            let error = f64::from(share) - exact;
            (worst, squares, cut) = (worst.max(error.abs()), squares + error * error, cut + 1);
        }
        [worst, (squares / f64::from(cut)).sqrt()]
    }

    #[test]
    fn fractions_are_those_of_many_points_for_round_and_for_cornered_forms() {
        // 16³ points are right to 1/16 along a wall, on average far better
        let [worst, rms] = errors(|p| tomolith_core::vector::dot(p, p).sqrt() - 1.0, 14);
        assert!(worst < 0.03 && rms < 0.008, "ball: {worst} {rms}");
        let box_and_ball = |p: [f64; 3]| {
            let ball = 0.9 - tomolith_core::vector::dot(p, p).sqrt();
            ball.max(super::super::cuboid(p, [0.83; 3]))
        };
        let [worst, rms] = errors(box_and_ball, 14);
        assert!(
            worst < 0.12 && rms < 0.015,
            "box less a ball: {worst} {rms}"
        );
    }
}
