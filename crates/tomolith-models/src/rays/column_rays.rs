//! Level light: one path for all rows of a column.
//!
//! Where nothing changes with height, the rays of all rows of a column run above each other. They make a [`ColumnRay`]: its way through
//! the plane is walked once, and in each voxel of the plane the lanes along z take what the rows bring, by the
//! [kernel of `parallel`](crate::parallel::kernel).
//!
//! # Equation
//! With the deposit d of the way in a voxel (x, y) of the plane, lane(z) = Σ x(row) over the rows in slice z:
//!
//! ```text
//! forward   dose(x, y, z) += d(x, y) · lane(z)
//! adjoint   grad(row) += Σ d(x, y) · c(x, y, z of the row)
//! ```
//! These are the entries of the single rays, so it is the same matrix but for the rounding of sums.
//!
//! # Cost
//! A traced ray for each column and sample, and one multiply-add for each voxel. Ways that are [kept](Rays::cached) take 8 bytes a voxel of
//! the plane.

use super::{Rays, traversal};
use crate::parallel::kernel::{Block, Entries, Isa, MAX_BLOCK, accumulate};
use crate::{DoseLayout, Run};
use std::ops::Range;
use tomolith_core::error::Result;
use tomolith_core::field::LANES;
use tomolith_core::parallel::{InParallel, lines, table};
use traversal::Ways;

/// The rays that one sample sends from all rows of a column.
pub(super) struct ColumnRay {
    /// Element of the lowest row that lies in the grid, and the slice of each row from there on.
    first: usize,
    slices: Vec<u32>,
    /// Voxels (x, y) on the way, as rows of the dose, and what a pixel of value 1 leaves in each.
    places: Vec<u32>,
    deposits: Vec<f32>,
    /// Voxels that one of its rays passes, as they are counted.
    passed: f64,
}

/// Bytes of a voxel of the plane on the way of a column ray.
pub(super) const BYTES: usize = 8;

/// Column rays that are taken together: their lanes stay in the second-level cache.
const CHUNK: usize = 256;

/// Tasks of one chunk for each thread.
const TASKS: usize = 4;

impl ColumnRay {
    /// Voxels that its rays pass.
    pub(super) fn updates(&self) -> f64 {
        self.passed * self.slices.len() as f64
    }

    /// The rows of this column ray, and the lane of each.
    fn rows(&self) -> impl Iterator<Item = (usize, usize)> {
        (self.first..).zip(self.slices.iter().map(|&z| z as usize))
    }
}

/// The column rays of all lights, in the order of pixels.
pub(super) struct ColumnRaysCache(Vec<ColumnRay>);

impl ColumnRaysCache {
    /// Those of a model; None when their ways and rows are more than `most` numbers.
    pub(super) fn of(model: &Rays, most: usize, run: &Run) -> Result<Option<Self>> {
        let (mut all, mut numbers) = (Vec::new(), 0);
        for (light, layout) in model.patterns.iter().enumerate() {
            for pairs in model.chunks(light, 0..layout.grid.frames()) {
                run.check()?;
                let column_rays = model.column_rays(light, pairs, |_| true);
                let of_column_ray =
                    |column_ray: &ColumnRay| column_ray.places.len() + column_ray.slices.len();
                numbers += column_rays.iter().map(of_column_ray).sum::<usize>();
                if numbers > most {
                    return Ok(None);
                }
                all.extend(column_rays);
            }
        }
        Ok(Some(ColumnRaysCache(all)))
    }

    /// Those of a range of pixels, some at a time.
    pub(super) fn of_pixels(&self, pixels: &Range<usize>) -> impl Iterator<Item = &[ColumnRay]> {
        let before = |pixel| {
            self.0
                .partition_point(|column_ray| column_ray.first < pixel)
        };
        self.0[before(pixels.start)..before(pixels.end)].chunks(CHUNK)
    }
}

impl Rays {
    /// The column rays of some (frame, column) pairs of which `wants` chooses a pixel, in their order.
    pub(super) fn column_rays(
        &self,
        light: usize,
        pairs: Range<usize>,
        wants: impl Fn(usize) -> bool + Sync,
    ) -> Vec<ColumnRay> {
        let (source, layout) = (&self.sources[light], &self.patterns[light]);
        let columns = layout.grid.columns;
        let area = layout.grid.pixel_mm2() / source.rays() as f64;
        let step = layout.grid.pitch_mm[1] / self.lattice.pitch();
        let (slices, row) = (self.lattice.counts[2] as f64, self.output.row);
        let of_pair = |pair: usize| {
            let (run, mut found) = (layout.runs[pair], Vec::new());
            let pixels = run.offset..run.offset + run.count as usize;
            if !pixels.clone().any(&wants) {
                return found;
            }
            source.for_each_path_segment(
                pair / columns,
                pair % columns,
                run.bottom as usize,
                |mut path_segment| {
                    let lowest = self.lattice.to_first_slice(&mut path_segment.ray);
                    let Some((axis, way)) = self.lattice.segment(&path_segment, area, 0) else {
                        return;
                    };
                    let heights = (0..pixels.len()).map(|i| (lowest + step * i as f64).floor());
                    let below = heights.clone().take_while(|&z| z < 0.0).count();
                    let voxels = way.passed() as usize + 8;
                    let mut column_ray = ColumnRay {
                        first: pixels.start + below,
                        slices: (heights.skip(below))
                            .take_while(|&z| z < slices)
                            .map(|z| z as u32)
                            .collect(),
                        places: Vec::with_capacity(voxels),
                        deposits: Vec::with_capacity(voxels),
                        passed: way.passed(),
                    };
                    let ways = Ways::new(&self.lattice, axis);
                    traversal::for_each(self.gait, ways, &way, |voxel, deposit| {
                        column_ray.places.push((voxel / row) as u32);
                        column_ray.deposits.push(deposit);
                    });
                    found.push(column_ray);
                },
            );
            found
        };
        let by_pair: Vec<Vec<ColumnRay>> = pairs.into_iter().par_map(of_pair);
        by_pair.into_iter().flatten().collect()
    }
}

/// The vectors of lanes that some column rays light, in blocks that the kernel takes.
fn blocks(column_rays: &[ColumnRay], layout: &DoseLayout) -> Vec<Block> {
    let lit = || column_rays.iter().flat_map(|column_ray| &column_ray.slices);
    let (low, high) = (lit().min(), lit().max());
    let (Some(&low), Some(&high)) = (low, high) else {
        return Vec::new();
    };
    let vectors = low as usize / LANES..high as usize / LANES + 1;
    let block = |first: usize| Block {
        row: layout.row / LANES,
        first,
        count: MAX_BLOCK.min(vectors.end - first),
    };
    vectors.clone().step_by(MAX_BLOCK).map(block).collect()
}

/// dose += what column rays of pixels of these values leave; in every voxel they are summed in their order, on any number of threads.
pub(super) fn add(column_rays: &[ColumnRay], layout: &DoseLayout, x: &[f32], dose: &mut [f32]) {
    let (isa, row) = (Isa::in_use(), layout.row);
    let blocks = blocks(column_rays, layout);
    let mut lanes = vec![0.0; column_rays.len() * row];
    lines(&mut lanes, row, |i, lane| {
        let rows = column_rays[i].rows();
        rows.for_each(|(pixel, z)| lane[z] += x[pixel]);
    });
    let is_lit = table(column_rays.len(), |i| {
        column_rays[i].rows().any(|(pixel, _)| x[pixel] != 0.0)
    });
    let [_, ny, nx] = layout.grid.shape;
    let tasks = TASKS * rayon::current_num_threads();
    let rows = ny.div_ceil(tasks) * nx;
    dose.chunks_mut(rows * row)
        .enumerate()
        .par_each(|(task, dose)| {
            let own = (task * rows) as u32..((task + 1) * rows) as u32;
            for (i, column_ray) in column_rays.iter().enumerate().filter(|&(i, _)| is_lit[i]) {
                let entries = column_ray.places.iter().zip(&column_ray.deposits);
                for (&place, deposit) in entries.filter(|(place, _)| own.contains(place)) {
                    let voxels = &mut dose[(place - own.start) as usize * row..][..row];
                    let entry = Entries {
                        slots: &[i as u32],
                        weights: std::slice::from_ref(deposit),
                    };
                    for &block in &blocks {
                        let out = &mut voxels[block.first * LANES..][..block.count * LANES];
                        accumulate(isa, out, &lanes, entry, block);
                    }
                }
            }
        });
}

/// grad += what column rays collect of a cotangent
pub(super) fn collect(column_rays: &[ColumnRay], layout: &DoseLayout, c: &[f32], grad: &mut [f32]) {
    let isa = Isa::in_use();
    let blocks = blocks(column_rays, layout);
    let of_column_ray = |column_ray: &ColumnRay| {
        let mut lane = vec![0.0; layout.row];
        let entries = Entries {
            slots: &column_ray.places,
            weights: &column_ray.deposits,
        };
        for &block in &blocks {
            let out = &mut lane[block.first * LANES..][..block.count * LANES];
            accumulate(isa, out, c, entries, block);
        }
        lane
    };
    let lanes: Vec<Vec<f32>> = column_rays.iter().par_map(of_column_ray);
    for (column_ray, lane) in column_rays.iter().zip(lanes) {
        column_ray
            .rows()
            .for_each(|(pixel, z)| grad[pixel] += lane[z]);
    }
}
