//! Regions of stored entries: a patch of 2 × 2 voxel columns along a vector of lanes.
//!
//! **Bound** The largest of the sixteen lanes of a vector stands for all of them, so that a sum over one lane bounds those of sixteen: the kernel of the dose, on a
//! sixteenth of its lanes. In an optimized boat of 256³ voxels (every fourth column, light that is not absorbed) 83 % of the lit vectors stay below 0.8 by this bound, and 89 % in truth.
//!
//! Lanes that are rows of pixels reach slices of two vectors, where rows and slices do not begin together. Such slices belong to both regions.

use super::cached::{PATCHES, patch};
use super::kept::{Desk, Source, Wide};
use super::plan::LightPlan;
use super::{Finding, Parallel, Tile};
use crate::Work;
use std::ops::Range;
use tomolith_core::dose::frames_of;
use tomolith_core::dose::regions::{ByElement, Regions};
use tomolith_core::error::Result;
use tomolith_core::field::{HostField, LANES};
use tomolith_core::parallel::InParallel;

/// Patches of a tile.
const OF_TILE: usize = PATCHES * PATCHES;
/// What a bound may be off by rounding, and the doses that it is a bound of: they are sums of some thousand terms.
const ROUNDING: f32 = 1e-3;
/// Vectors of all parts of a turn that bounds are worth it for: those of sixteen cost as much as one of the dose. Each has a bit.
const VECTORS: Range<usize> = 4..u64::BITS as usize + 1;

pub(super) struct Chosen {
    /// A bit for each vector, `[tile][patch]`.
    vectors: Vec<u64>,
    /// Slices that the lanes of each vector reach.
    slices: Vec<Range<usize>>,
}

impl Chosen {
    /// Whether there are none in a tile.
    pub(super) fn is_empty_in(&self, tile: usize) -> bool {
        let patches = &self.vectors[tile * OF_TILE..][..OF_TILE];
        patches.iter().all(|vectors| *vectors == 0)
    }

    /// Whether a voxel column of a tile, counted from its first, lies in one.
    pub(super) fn has(&self, tile: usize, at: [usize; 2]) -> bool {
        self.vectors[tile * OF_TILE + patch(at)] != 0
    }

    /// Ranges of slices of a voxel column of a tile, counted from its first.
    pub(super) fn slices(
        &self,
        tile: usize,
        [x, y]: [usize; 2],
    ) -> impl Iterator<Item = Range<usize>> + '_ {
        let vectors = self.vectors[tile * OF_TILE + patch([x, y])];
        let is_chosen = move |vector: &usize| vectors >> vector & 1 == 1;
        let vectors = (0..self.slices.len()).filter(is_chosen);
        vectors.map(|vector| self.slices[vector].clone())
    }
}

/// The largest of some numbers, 0 where none is above it.
fn largest(values: &[f32]) -> f32 {
    let larger = |most: f32, value: &f32| if *value > most { *value } else { most };
    let (lanes, rest) = values.as_chunks::<8>();
    let mut most = [0.0; 8];
    for lanes in lanes {
        for (most, value) in most.iter_mut().zip(lanes) {
            *most = larger(*most, value);
        }
    }
    let most = most.iter().fold(0.0, larger);
    rest.iter().fold(most, larger)
}

/// Voxels `[x, y]` of a tile, counted from its first.
fn voxels(tile: &Tile) -> impl Iterator<Item = [usize; 2]> + use<> {
    let [nx, ny] = tile.size;
    (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y]))
}

impl Parallel {
    /// The regions of this model, where entries of one light are stored; None where there are none.
    pub(super) fn as_regions(&self) -> Option<&dyn Regions<HostField>> {
        let [plan] = self.lights.as_slice() else {
            return None;
        };
        let is_kept = self.finding == Finding::Once && !self.is_plane();
        let frames = 0..frames_of(&self.patterns);
        let is_whole = plan.views.of_frames(frames).len() == 1;
        let vectors = plan.turned.parts * plan.levels.used;
        (is_kept && is_whole && VECTORS.contains(&vectors)).then_some(self as _)
    }

    fn the_plan(&self) -> &LightPlan {
        &self.lights[0]
    }

    /// Slices that the lanes of each vector reach.
    fn slices_of_vectors(&self) -> Vec<Range<usize>> {
        let levels = &self.the_plan().levels;
        let of_vector = |vector: usize| {
            let lanes = vector * LANES..(vector + 1) * LANES;
            match &levels.spread {
                None => lanes.start..lanes.end.min(self.output.row),
                Some(spread) => spread.slices_of(lanes),
            }
        };
        (0..levels.used).map(of_vector).collect()
    }

    /// What `fold` makes of each region's elements, one row of slices after the other, from `first` on.
    fn each_region<T: Copy + Send + Sync>(
        &self,
        first: T,
        fold: impl Fn(T, usize, Range<usize>) -> T + Sync,
    ) -> Vec<T> {
        let (slices, nx) = (self.slices_of_vectors(), self.output.grid.shape[2]);
        let count = slices.len();
        let of_tile = |(index, tile): (usize, &Tile)| {
            let mut found = vec![first; OF_TILE * count];
            for [x, y] in voxels(tile) {
                let column = (tile.start[1] + y) * nx + tile.start[0] + x;
                let row = column * self.output.row;
                for (vector, slices) in slices.iter().enumerate() {
                    let region = patch([x, y]) * count + vector;
                    let all = index * OF_TILE * count + region;
                    let elements = row + slices.start..row + slices.end;
                    found[region] = fold(found[region], all, elements);
                }
            }
            found
        };
        self.tiles.iter().enumerate().par_map(of_tile).concat()
    }

    /// The regions that are chosen, and for each patch of the first part of the turn the vectors of all parts that their doses need.
    fn wanted(&self, chosen: &[bool]) -> (Chosen, Vec<u64>) {
        let (plan, slices) = (self.the_plan(), self.slices_of_vectors());
        let count = slices.len();
        let of_patch = |regions: &[bool]| {
            let bits = regions.iter().enumerate();
            bits.fold(0u64, |all, (i, is_wanted)| all | u64::from(*is_wanted) << i)
        };
        let vectors: Vec<u64> = chosen.chunks(count).map(of_patch).collect();
        let shares = |a: &Range<usize>, b: &Range<usize>| a.start < b.end && b.start < a.end;
        let sharing = |slice| slices.iter().map(|other| shares(slice, other)).collect();
        let sharing: Vec<Vec<bool>> = slices.iter().map(sharing).collect();
        let widen = |bits: &u64| {
            let set_bits = (0..count).filter(|i| bits >> i & 1 == 1);
            set_bits.fold(*bits, |all, i| all | of_patch(&sharing[i]))
        };
        let widened: Vec<u64> = vectors.iter().map(widen).collect();
        let nx = self.output.grid.shape[2];
        let mut patch_at = vec![0u32; self.output.grid.shape[1] * nx];
        for (index, tile) in self.tiles.iter().enumerate() {
            for [x, y] in voxels(tile) {
                let place = (tile.start[1] + y) * nx + tile.start[0] + x;
                patch_at[place] = (index * OF_TILE + patch([x, y])) as u32;
            }
        }
        let of_tile = |tile: &Tile| {
            let mut wanted = vec![0; OF_TILE];
            for [x, y] in voxels(tile) {
                let at = [tile.start[0] + x, tile.start[1] + y];
                for part in 0..plan.turned.parts {
                    let [x_there, y_there] = plan.turned.place_in(part, at);
                    let there = patch_at[y_there * nx + x_there] as usize;
                    wanted[patch([x, y])] |= widened[there] << (part * count);
                }
            }
            wanted
        };
        let wanted = self.tiles.iter().par_map(of_tile).concat();
        (Chosen { vectors, slices }, wanted)
    }

    /// For each slot and vector of all parts the largest pixel of x + step that reaches it: a lane is a mean of pixels.
    fn expand_bounds(&self, pooled: Wide, x: &[f32], step: &[f32], lanes: &mut [f32]) {
        let (plan, layout) = (self.the_plan(), &self.patterns[0]);
        let overlaps = &plan.levels.overlaps;
        let rows = |vector: usize| overlaps.rows_of(vector * LANES..(vector + 1) * LANES);
        let rows: Vec<Range<usize>> = (0..pooled.part).map(rows).collect();
        let views = lanes.chunks_mut(plan.columns * pooled.row).enumerate();
        views.par_each_with(Vec::new, |values: &mut Vec<f32>, (first_view, lanes)| {
            lanes.fill(0.0);
            for (column, lanes) in lanes.chunks_mut(pooled.row).enumerate() {
                let parts = lanes.chunks_mut(pooled.part).take(pooled.parts);
                for (part, bounds) in parts.enumerate() {
                    let view = part * plan.turned.period + first_view;
                    for side in plan.views.sides() {
                        let slot = view * plan.columns + column;
                        let run = layout.runs[plan.views.pixel_column(slot, side)];
                        let elements = run.offset..run.offset + run.count as usize;
                        let pairs = x[elements.clone()].iter().zip(&step[elements]);
                        values.clear();
                        values.extend(pairs.map(|(x, step)| x + step));
                        let place = |row: usize| row.saturating_sub(run.bottom as usize);
                        for (bound, rows) in bounds.iter_mut().zip(&rows) {
                            let end = place(rows.end).min(values.len());
                            let pixels = &values[place(rows.start).min(end)..end];
                            *bound += largest(pixels);
                        }
                    }
                }
            }
        });
    }
}

impl Regions<HostField> for Parallel {
    fn count(&self) -> usize {
        self.tiles.len() * OF_TILE * self.the_plan().levels.used
    }

    fn least(&self, value_of: &ByElement) -> Vec<f32> {
        self.each_region(f32::INFINITY, |least, _, mut elements| {
            elements
                .try_fold(least, |least, i| match value_of(i).min(least) {
                    0.0 => Err(0.0),
                    least => Ok(least),
                })
                .unwrap_or_else(|least| least)
        })
    }

    fn holds_any(&self, field: &HostField, chosen: &[bool]) -> Vec<bool> {
        let is_nonzero = |value: &f32| *value != 0.0;
        self.each_region(false, |found, region, elements| {
            found || chosen[region] && field.as_slice()[elements].iter().any(is_nonzero)
        })
    }

    fn bounds(&self, x: &HostField, step: &HostField, work: &Work) -> Result<Vec<f32>> {
        let plan = self.the_plan();
        let pooled = Wide::of(plan).pooled();
        let mut lanes = self.scratch.borrow(pooled.of_all());
        self.expand_bounds(pooled, x.as_slice(), step.as_slice(), lanes.as_mut_slice());
        let source = Source {
            entries: self.entries(0, work)?,
            wide: pooled,
            lanes: lanes.as_slice(),
            groups: super::groups(0..plan.turned.period).collect(),
            wanted: None,
        };
        let mut bounds = vec![0.0f32; self.count()];
        let of_tiles = bounds.chunks_mut(OF_TILE * pooled.part).collect();
        let raise = |tiles: &[usize], (index, found): (usize, &mut [f32]), desk: &mut Desk| {
            let tile = &self.tiles[index];
            let mut bounds = vec![0.0; pooled.part];
            for y in 0..tile.size[1] {
                let lines = self.lines(plan, pooled, tiles, tile, y);
                for x in 0..tile.size[0] {
                    bounds.fill(0.0);
                    for values in lines.of_voxel(x, &desk.turned) {
                        let pairs = bounds.iter_mut().zip(values);
                        pairs.for_each(|(bound, value)| *bound += value);
                    }
                    let found = &mut found[patch([x, y]) * pooled.part..];
                    for (found, bound) in found.iter_mut().zip(&bounds) {
                        *found = found.max(bound * (1.0 + ROUNDING));
                    }
                }
            }
        };
        self.each_orbit(&source, of_tiles, work, raise);
        drop(source);
        self.scratch.give_back(lanes);
        work.check()?;
        Ok(bounds)
    }

    fn dose_in(
        &self,
        chosen: &[bool],
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let (chosen, wanted) = self.wanted(chosen);
        let only = Some((&chosen, wanted.as_slice()));
        let all = self.the_plan().views.all();
        let (x, dose) = (x.as_slice(), dose.as_mut_slice());
        self.add_kept(0, &all, only, x, dose, work)
    }
}
