//! A form → the fraction of each voxel that is inside.
//!
//! Voxels farther from the surface than half their diagonal are full or empty; the others are cut into 4³ cells (upright
//! prisms: 8² cells of the outline times the exact overlap of heights), and a cell of edge c at signed distance d counts
//! clamp(½ − d/c, 0, 1). For a flat wall along the grid that is exact; over a wall in any direction the errors of the
//! cells cancel, so that volumes converge with the square of the voxel.

use super::{Body, Prism};
use crate::error::Result;
use crate::grid::{Volume, VolumeGrid, sample};
use crate::target::placing::Map;
use crate::target::voxels::zeros;
use rayon::prelude::*;

/// Cells along the edge of a voxel of a solid.
const CELLS: usize = 4;

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
                *value = if middle.abs() > pitch * std::f64::consts::FRAC_1_SQRT_2 + cell {
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

fn fill_solid(
    surface: &(dyn Fn([f64; 3]) -> f64 + Send + Sync),
    map: &Map,
    grid: &VolumeGrid,
    values: &mut [f32],
) {
    let [_, ny, nx] = grid.shape;
    let pitch = grid.pitch_mm;
    let cell = pitch / CELLS as f64;
    let far = pitch * 3f64.sqrt() / 2.0 + cell;
    let distance = |p| map.scale * surface(map.undo(p));
    values
        .par_chunks_mut(nx)
        .enumerate()
        .for_each(|(row, values)| {
            let (y, z) = (grid.y(row % ny), grid.z(row / ny));
            for (ix, value) in values.iter_mut().enumerate() {
                let x = grid.x(ix);
                let middle = distance([x, y, z]);
                *value = if middle.abs() > far {
                    f32::from(u8::from(middle < 0.0))
                } else {
                    let offset = |i| sample(i, CELLS, cell);
                    let sum: f64 = (0..CELLS.pow(3))
                        .map(|i| {
                            let at = [
                                x + offset(i % CELLS),
                                y + offset(i / CELLS % CELLS),
                                z + offset(i / CELLS / CELLS),
                            ];
                            share(distance(at), cell)
                        })
                        .sum();
                    (sum / CELLS.pow(3) as f64) as f32
                };
            }
        });
}
