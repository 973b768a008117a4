//! A form → the fraction of each voxel that is inside.
//!
//! Blocks of voxels farther from the surface than their corners are full or empty; the others are halved, down to 4³ cells
//! in a voxel (upright prisms: 8² cells of the outline times the exact overlap of heights), and a cell of edge c at signed distance d counts
//! clamp(½ − d/c, 0, 1). For a flat wall along the grid that is exact; over a wall in any direction the errors of the
//! cells cancel, so that volumes converge with the square of the voxel.

use super::{Body, Prism};
use crate::error::Result;
use crate::grid::{Volume, VolumeGrid, sample};
use crate::target::placing::Map;
use crate::target::voxels::zeros;
use rayon::prelude::*;

/// Cells along the edge of a voxel of a solid, a power of two.
const CELLS: usize = 4;

/// Voxels along the edge of a block that is looked at as a whole, a power of two.
const BLOCK: usize = 16;

/// Cells along the edge of a voxel of an outline.
const OUTLINE_CELLS: usize = 8;

/// Inside fraction of every voxel of `grid` for a body placed by `map`.
///
/// # Errors
/// [`Error::Resources`](crate::Error::Resources) when the memory cannot be had.
pub fn inside_fractions(body: &Body, map: &Map, grid: &VolumeGrid) -> Result<Volume<f32>> {
    let mut values = zeros(grid)?;
    if !values.is_empty() {
        match body {
            Body::Prisms(prisms) if map.rotation[2] == [0.0, 0.0, 1.0] => {
                fill_upright(prisms, map, grid, &mut values);
            }
            Body::Prisms(prisms) => fill_solid(
                &|p| {
                    let each = prisms.iter().map(|prism| prism.distance(p));
                    each.fold(f64::INFINITY, f64::min)
                },
                map,
                grid,
                &mut values,
            ),
            Body::Solid(surface) => fill_solid(surface, map, grid, &mut values),
        }
    }
    Ok(Volume {
        grid: grid.clone(),
        values,
    })
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
    let [nz, ny, nx] = grid.shape;
    for prism in prisms {
        let outline = outline_fractions(prism, map, grid);
        let ends = prism.z.map(|z| map.apply([0.0, 0.0, z])[2]);
        let heights: Vec<f64> = (0..nz)
            .map(|iz| {
                let (z, half) = (grid.z(iz), grid.pitch_mm / 2.0);
                let overlap = ends[1].min(z + half) - ends[0].max(z - half);
                (overlap / grid.pitch_mm).clamp(0.0, 1.0)
            })
            .collect();
        values
            .par_chunks_mut(nx * ny)
            .zip(&heights)
            .filter(|(_, height)| **height > 0.0)
            .for_each(|(slice, height)| {
                for (value, share) in slice.iter_mut().zip(&outline) {
                    *value = value.max((share * height) as f32);
                }
            });
    }
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
    fractions
        .par_chunks_mut(nx)
        .enumerate()
        .for_each(|(iy, row)| {
            for (ix, value) in row.iter_mut().enumerate() {
                let (x, y) = (grid.x(ix), grid.y(iy));
                let middle = distance(x, y);
                *value = if middle.abs()
                    >= (pitch - cell) * std::f64::consts::FRAC_1_SQRT_2 + cell / 2.0
                {
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

fn fill_solid(surface: SurfaceRef, map: &Map, grid: &VolumeGrid, values: &mut [f32]) {
    let [_, ny, nx] = grid.shape;
    let octree = Octree { surface, map, grid };
    values
        .par_chunks_mut(nx * ny * BLOCK)
        .enumerate()
        .for_each(|(slab, values)| {
            for iy in (0..ny).step_by(BLOCK) {
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

    /// Share of a cut cube, with the distance `d` of its middle: of its halves, down to cells.
    fn cut_share(&self, middle: [f64; 3], edge: f64, d: f64) -> f64 {
        let cell = self.grid.pitch_mm / CELLS as f64;
        if edge < 1.5 * cell {
            return share(d, cell);
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
}
