//! Collimated light through what is the same at all heights: one path for all rows of a column.
//!
//! Where nothing changes with height, the rays of all rows of a column run above each other, level or slanted. They make a
//! [`ColumnRay`]: its way through the plane is walked once, and in each voxel of the plane the lanes along z take what the
//! rows bring, by the [kernel of `parallel`](crate::parallel::kernel), or by that of [slanted rays](super::slanted).
//!
//! # Equation
//! Of level rays, with the deposit d of the way in a voxel (x, y) of the plane, lane(z) = Σ x(row) over the rows in slice z:
//!
//! ```text
//! forward   dose(x, y, z) += d(x, y) · lane(z)
//! adjoint   grad(row) += Σ d(x, y) · c(x, y, z of the row)
//! ```
//! These are the entries of the single rays, so it is the same matrix but for the rounding of sums.
//!
//! # Cost
//! A traced ray for each column and sample, and one multiply-add for each voxel; with AVX2 slanted rays take one and a half times as long for a dose, twice and a half for an adjoint. Ways that are
//! [kept](Rays::cached) take 8 bytes a voxel of the plane, 16 where they are slanted.

use super::slanted::{self, Slant};
use super::{Rays, traversal};
use crate::parallel::kernel::{Block, Entries, Isa, MAX_BLOCK, accumulate};
use crate::{DoseLayout, Work};
use std::ops::Range;
use tomolith_core::error::Result;
use tomolith_core::field::LANES;
use tomolith_core::parallel::{InParallel, table};
use tomolith_optics::space::PathSegment;
use traversal::Ways;

/// The rays that one sample sends from rows of a column.
pub(super) struct ColumnRay {
    /// Element of the lowest row, elements from one row to the next, and the lane of each row from there on.
    first: usize,
    stride: usize,
    lanes: Vec<u32>,
    form: Form,
    /// Voxels that one of its rays passes, as they are counted.
    passed: f64,
}

/// Which way the rays of a column run.
enum Form {
    /// Lanes are slices of the grid. Voxels (x, y) on the way, as rows of the dose, and what a pixel of value 1 leaves in each.
    Level {
        places: Vec<u32>,
        deposits: Vec<f32>,
    },
    Slanted(Slant),
}

/// Bytes of a voxel of the plane on the way of a column ray, level or slanted.
pub(super) const BYTES: [usize; 2] = [8, 16];

/// Column rays that are taken together: their lanes stay in the second-level cache.
const CHUNK: usize = 256;

/// Tasks of one chunk for each thread.
const TASKS: usize = 4;

impl ColumnRay {
    /// Voxels that its rays pass.
    pub(super) fn updates(&self) -> f64 {
        self.passed * self.lanes.len() as f64
    }

    /// The rows of this column ray, and the lane of each.
    fn rows(&self) -> impl Iterator<Item = (usize, usize)> {
        let pixels = (self.first..).step_by(self.stride);
        pixels.zip(self.lanes.iter().map(|&lane| lane as usize))
    }

    /// The values of its rows by lanes, of which there are `row` where they are slices.
    fn values(&self, x: &[f32], row: usize) -> Vec<f32> {
        let mut values = vec![0.0; self.lanes_of(row)];
        self.rows()
            .for_each(|(pixel, lane)| values[lane] += x[pixel]);
        values
    }

    fn lanes_of(&self, row: usize) -> usize {
        match &self.form {
            Form::Level { .. } => row,
            Form::Slanted(slant) => slant.heights.len(),
        }
    }

    /// Numbers that it consists of, in those of a way.
    fn numbers(&self) -> usize {
        self.lanes.len()
            + match &self.form {
                Form::Level { places, .. } => places.len(),
                Form::Slanted(slant) => slant.numbers(),
            }
    }
}

/// The column rays of all lights, in the order of pixels.
pub(super) struct ColumnRaysCache(Vec<ColumnRay>);

impl ColumnRaysCache {
    /// Those of a model; None when their ways and rows are more than `most` numbers.
    pub(super) fn of(model: &Rays, most: usize, work: &Work) -> Result<Option<Self>> {
        let (mut all, mut numbers) = (Vec::new(), 0);
        for (light, layout) in model.patterns.iter().enumerate() {
            for pairs in model.chunks(light, 0..layout.grid.frames()) {
                work.check()?;
                let column_rays = model.column_rays(light, pairs, |_| true);
                numbers += column_rays.iter().map(ColumnRay::numbers).sum::<usize>();
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
        let step = source.row_step_mm() / self.lattice.pitch();
        let of_pair = |pair: usize| {
            let (run, mut found) = (layout.runs[pair], Vec::new());
            let pixels = run.offset..run.offset + run.count as usize;
            if !pixels.clone().any(&wants) {
                return found;
            }
            let (frame, column, bottom) = (pair / columns, pair % columns, run.bottom as usize);
            source.for_each_path_segment(frame, column, bottom, |path| {
                if source.is_level() {
                    found.extend(self.level(path, area, &pixels, step));
                } else {
                    found.extend(self.slanted(path, area, &pixels, step));
                }
            });
            found
        };
        let by_pair: Vec<Vec<ColumnRay>> = pairs.into_iter().par_map(of_pair);
        by_pair.into_iter().flatten().collect()
    }

    /// The column ray of level light; `step`: slices from row to row.
    fn level(
        &self,
        mut path: PathSegment,
        area: f64,
        pixels: &Range<usize>,
        step: f64,
    ) -> Option<ColumnRay> {
        let slices = self.lattice.counts[2] as f64;
        let lowest = self.lattice.to_first_slice(&mut path.ray);
        let (axis, way) = self.lattice.segment(&path, area, 0)?;
        let heights = (0..pixels.len()).map(|i| (lowest + step * i as f64).floor());
        let below = heights.clone().take_while(|&z| z < 0.0).count();
        let within = heights.skip(below).take_while(|&z| z < slices);
        let voxels = way.passed() as usize + 8;
        let (mut places, mut deposits) = (Vec::with_capacity(voxels), Vec::with_capacity(voxels));
        traversal::for_each(
            self.gait,
            Ways::new(&self.lattice, axis),
            &way,
            |voxel, deposit| {
                places.push((voxel / self.output.row) as u32);
                deposits.push(deposit);
            },
        );
        Some(ColumnRay {
            first: pixels.start + below,
            stride: 1,
            lanes: within.map(|z| z as u32).collect(),
            form: Form::Level { places, deposits },
            passed: way.passed(),
        })
    }

    /// The column rays of slanted light: one of all rows, or of every second, third… where slices are higher than rows, so that no two
    /// begin in one slice.
    fn slanted(
        &self,
        path: PathSegment,
        area: f64,
        pixels: &Range<usize>,
        step: f64,
    ) -> Vec<ColumnRay> {
        let ways = slanted::ways(&self.lattice, &path, area);
        let (lowest, passed) = (self.lattice.place(path.ray.from)[2], ways.len() as f64);
        let (slices, pitch) = (self.lattice.counts[2], self.lattice.pitch());
        let stride = (1.0 / step - 1e-9).ceil().max(1.0) as usize;
        let of_class = |class: usize| {
            let rows = (class..pixels.len()).step_by(stride);
            let heights = rows.map(|row| lowest + step * row as f64);
            let (slant, below, lanes) = Slant::new(&path, pitch, ways.clone(), heights, slices)?;
            Some(ColumnRay {
                first: pixels.start + class + below * stride,
                stride,
                lanes,
                form: Form::Slanted(slant),
                passed,
            })
        };
        (0..stride.min(pixels.len())).filter_map(of_class).collect()
    }
}

/// The vectors of lanes that some level column rays light, in blocks that the kernel takes.
fn blocks(column_rays: &[ColumnRay], layout: &DoseLayout) -> Vec<Block> {
    let is_level = |column_ray: &&ColumnRay| matches!(column_ray.form, Form::Level { .. });
    let lit = || (column_rays.iter().filter(is_level)).flat_map(|column_ray| &column_ray.lanes);
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
    let values: Vec<Vec<f32>> = column_rays
        .iter()
        .par_map(|column_ray: &ColumnRay| column_ray.values(x, row));
    let is_lit = table(column_rays.len(), |i| {
        column_rays[i].rows().any(|(pixel, _)| x[pixel] != 0.0)
    });
    let [nz, ny, nx] = layout.grid.shape;
    let tasks = TASKS * rayon::current_num_threads();
    let rows = ny.div_ceil(tasks) * nx;
    dose.chunks_mut(rows * row)
        .enumerate()
        .par_each(|(task, dose)| {
            let band = (task * rows) as u32..((task + 1) * rows) as u32;
            let at = |place: u32| (place - band.start) as usize * row;
            for (i, column_ray) in column_rays.iter().enumerate().filter(|&(i, _)| is_lit[i]) {
                match &column_ray.form {
                    Form::Level { places, deposits } => {
                        let entries = places.iter().zip(deposits);
                        for (&place, deposit) in entries.filter(|(place, _)| band.contains(place)) {
                            let voxels = &mut dose[at(place)..][..row];
                            let entry = Entries {
                                slots: &[0],
                                weights: std::slice::from_ref(deposit),
                            };
                            for &block in &blocks {
                                let out = &mut voxels[block.first * LANES..][..block.count * LANES];
                                accumulate(isa, out, &values[i], entry, block);
                            }
                        }
                    }
                    Form::Slanted(slant) => {
                        let mut room = slant.room();
                        for &way in slant.ways_in(&band) {
                            let voxels = &mut dose[at(way.place)..][..nz];
                            slant.add(isa, &values[i], way, &mut room, voxels);
                        }
                    }
                }
            }
        });
}

/// grad += what column rays collect of a cotangent
pub(super) fn collect(column_rays: &[ColumnRay], layout: &DoseLayout, c: &[f32], grad: &mut [f32]) {
    let (isa, row) = (Isa::in_use(), layout.row);
    let slices = layout.grid.shape[0];
    let blocks = blocks(column_rays, layout);
    let of_column_ray = |column_ray: &ColumnRay| {
        let mut lanes = vec![0.0; column_ray.lanes_of(row)];
        match &column_ray.form {
            Form::Level { places, deposits } => {
                let entries = Entries {
                    slots: places,
                    weights: deposits,
                };
                for &block in &blocks {
                    let out = &mut lanes[block.first * LANES..][..block.count * LANES];
                    accumulate(isa, out, c, entries, block);
                }
            }
            Form::Slanted(slant) => {
                let [mut room, ..] = slant.room();
                for &way in &slant.ways {
                    let voxels = &c[way.place as usize * row..][..slices];
                    slant.collect(isa, voxels, way, &mut room, &mut lanes);
                }
            }
        }
        lanes
    };
    let lanes: Vec<Vec<f32>> = column_rays.iter().par_map(of_column_ray);
    for (column_ray, lane) in column_rays.iter().zip(lanes) {
        column_ray
            .rows()
            .for_each(|(pixel, z)| grad[pixel] += lane[z]);
    }
}
