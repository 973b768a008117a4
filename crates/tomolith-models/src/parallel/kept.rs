//! Dose and adjoint along stored entries.
//!
//! Entries are those of the first part of the turn ([`turned`](super::turned)). They serve all parts at once: a slot holds the lanes of the pixels that
//! its column stands for, part after part, and a voxel those of the voxels that it is turned to. What is read of an entry is so used for up to four
//! columns and voxels. Such lanes of voxels are made for the tiles that the turn maps onto one another, and stay in the cache: the dose takes its own from
//! them, the adjoint turns its cotangent into them.
//!
//! Some views alone are those of all, with lanes of the others dark; groups that hold none of them are left out.

use super::block_sparsity::NonzeroBlocks;
use super::cached::{Bench, LightEntries, PATCHES, Place, TileCotangent, Wanted, patch};
use super::patches;
use super::plan::LightPlan;
use super::regions::Chosen;
use super::views::SeenViews;
use super::{DoseLayout, Parallel, TILE, Tile, groups, tile_rows};
use crate::Work;
use std::ops::Range;
use tomolith_core::dose::layout::row_of;
use tomolith_core::error::Result;
use tomolith_core::field::{HostField, LANES};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;

/// Bands of tiles whose adjoints are summed apart, at most: as many on any number of cores, so that sums have the same order.
const BANDS: usize = 8;
/// Bytes that the lanes of all bands may take.
const OF_BANDS: usize = 1 << 27;

/// Tiles, with those that the turn maps onto them, that a band has at least.
const IN_A_BAND: usize = 12;

/// Bands for so many floats of lanes.
fn bands(lanes: usize) -> usize {
    (OF_BANDS / (lanes * size_of::<f32>()).max(1)).clamp(1, BANDS)
}

/// Bytes of the lanes of bands in addition to those of all pixels.
pub(super) fn bytes_of_bands(lights: &[Light], grid: &VolumeGrid) -> f64 {
    let of_light = |light: &Light| {
        let pixels = &light.pixels;
        let rows = grid.shape[0].min(pixels.rows).next_multiple_of(LANES);
        let lanes = pixels.frames() * pixels.columns * rows;
        (bands(lanes) - 1) * lanes * size_of::<f32>()
    };
    lights.iter().map(of_light).max().unwrap_or_default() as f64
}

/// Lanes of all parts of a turn, one after the other.
#[derive(Clone, Copy)]
pub(super) struct Wide {
    pub(super) parts: usize,
    /// Floats of a part, and of a row of all.
    pub(super) part: usize,
    pub(super) row: usize,
    /// Slots of the first part.
    slots: usize,
}

impl Wide {
    pub(super) fn of(plan: &LightPlan) -> Self {
        let (parts, part) = (plan.turned.parts, plan.levels.used * LANES);
        Wide {
            parts,
            part,
            row: row_of(parts * part),
            slots: plan.turned.period * plan.columns,
        }
    }

    /// The layout with one float for each vector of lanes.
    pub(super) fn pooled(self) -> Self {
        let part = self.part / LANES;
        Wide {
            part,
            row: (self.parts * part).next_multiple_of(LANES),
            ..self
        }
    }

    /// Floats of all slots.
    pub(super) fn of_all(self) -> usize {
        self.slots * self.row
    }

    /// Where the lanes of a part lie within those of all.
    fn lanes(self, part: usize) -> Range<usize> {
        part * self.part..(part + 1) * self.part
    }

    /// Where those of a slot of any part lie.
    fn of_slot(self, slot: usize) -> Range<usize> {
        let first = slot % self.slots * self.row;
        let lanes = self.lanes(slot / self.slots);
        first + lanes.start..first + lanes.end
    }

    /// Floats of a tile.
    fn of_tile(self) -> usize {
        TILE * TILE * self.row
    }
}

/// Of each group of views of the first part those that some views repeat: the first to the last of them.
fn repeated(views: &Range<usize>, period: usize) -> Vec<Range<usize>> {
    let mut is_wanted = vec![false; period];
    let wanted = views.clone().map(|view| view % period);
    wanted.for_each(|view| is_wanted[view] = true);
    let of_group = |mut group: Range<usize>| {
        let first = group.find(|&view| is_wanted[view])?;
        let last = group.rev().find(|&view| is_wanted[view]);
        Some(first..last.unwrap_or(first) + 1)
    };
    groups(0..period).filter_map(of_group).collect()
}

/// Lanes of slots with the entries that they are summed with.
pub(super) struct Source<'a> {
    pub(super) entries: LightEntries<'a>,
    pub(super) wide: Wide,
    pub(super) lanes: &'a [f32],
    /// Views of the first part of the turn.
    pub(super) groups: Vec<Range<usize>>,
    /// Vectors of lanes that are wanted, a bit for each, `[tile][patch]`; None: all.
    pub(super) wanted: Option<&'a [u64]>,
}

/// A cotangent, with the entries that it is summed with.
struct Cotangent<'a> {
    entries: LightEntries<'a>,
    /// Views whose lanes are wanted.
    views: &'a Range<usize>,
    /// Rows of lanes, voxel after voxel; which of them hold anything, in short and in long blocks.
    values: &'a [f32],
    nonzero: &'a [NonzeroBlocks; 2],
}

/// What a thread needs to add light to tiles.
#[derive(Default)]
pub(super) struct Desk {
    bench: Bench,
    /// Lanes of all parts for the voxels of some tiles.
    pub(super) turned: HostField,
    /// Those that a row of voxels takes, the slices that they reach, and what spreading them needs.
    lanes: Vec<f32>,
    slices: Vec<f32>,
    buffer: Vec<f32>,
}

/// Where the lanes of a row of voxels lie among those of tiles that the turn maps onto one another: first float and step from voxel to voxel, for each part.
pub(super) struct Lines {
    wide: Wide,
    of_part: [(usize, isize); 4],
}

impl Lines {
    /// The lanes of a voxel from each part, which add up to its own.
    #[inline(always)]
    pub(super) fn of_voxel<'a>(
        &self,
        x: usize,
        turned: &'a HostField,
    ) -> impl Iterator<Item = &'a [f32]> {
        let of_part = self.of_part[..self.wide.parts].iter();
        of_part.map(move |(first, step)| {
            let from = first.wrapping_add_signed(step * x as isize);
            &turned.as_slice()[from..][..self.wide.part]
        })
    }
}

impl Desk {
    /// Lanes of so many tiles, of any content.
    fn turned(&mut self, len: usize) -> &mut [f32] {
        if self.turned.as_slice().len() < len {
            self.turned = HostField::zeros(len);
        }
        &mut self.turned.as_mut_slice()[..len]
    }
}

impl Parallel {
    /// dose += light of these views of one light; of regions that are `only` wanted, it is written over their dose.
    pub(super) fn add_kept(
        &self,
        light: usize,
        seen: &SeenViews,
        only: Option<(&Chosen, &[u64])>,
        x: &[f32],
        dose: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let entries = self.entries(light, work)?;
        let plan = entries.plan;
        let wide = Wide::of(plan);
        let groups = repeated(&seen.views, plan.turned.period);
        let mut lanes = self.scratch.borrow(wide.of_all());
        self.expand_parts(light, wide, seen, x, lanes.as_mut_slice());
        let source = Source {
            entries,
            wide,
            lanes: lanes.as_slice(),
            groups,
            wanted: only.map(|(_, wanted)| wanted),
        };
        let chosen = only.map(|(chosen, _)| chosen);
        let DoseLayout { row, grid, .. } = &self.output;
        let rows = tile_rows(&self.tiles, dose, *row, grid.shape[2]);
        self.each_orbit(&source, rows, work, |tiles, (index, rows), desk| {
            self.add_turned(plan, tiles, index, rows, chosen, desk);
        });
        drop(source);
        self.scratch.give_back(lanes);
        work.check()
    }

    /// Sums lanes for all tiles, together with those that the turn maps onto them, and gives what each has of `targets` to `finish`.
    pub(super) fn each_orbit<T: Send>(
        &self,
        source: &Source<'_>,
        targets: Vec<T>,
        work: &Work,
        finish: impl Fn(&[usize], (usize, T), &mut Desk) + Sync,
    ) {
        let wide = source.wide;
        let (row, used) = (wide.row / LANES, (wide.parts * wide.part).div_ceil(LANES));
        let lengths = patches::block_lengths(self.path.isa, wide.parts);
        let nonzero = NonzeroBlocks::of(source.lanes, row, used, lengths);
        let steps = work.steps(self.tiles.len() * source.groups.len());
        let mut targets: Vec<_> = targets.into_iter().map(Some).collect();
        let of_orbit = |orbit: &Vec<usize>| {
            let members = orbit.iter().map(|&i| Some((i, targets[i].take()?)));
            members.collect::<Option<Vec<_>>>().unwrap_or_default()
        };
        let orbits: Vec<_> = self.orbits.iter().map(of_orbit).collect();
        orbits
            .into_iter()
            .par_each_with(Desk::default, |desk: &mut Desk, orbit| {
                let _ = desk.turned(orbit.len() * wide.of_tile());
                let of_tiles = desk.turned.as_mut_slice().chunks_mut(wide.of_tile());
                for (&(index, _), turned) in orbit.iter().zip(of_tiles) {
                    let wanted = (source.wanted)
                        .map(|all| &all[index * PATCHES * PATCHES..][..PATCHES * PATCHES]);
                    let wanted = Wanted::of(wanted);
                    if wanted.is_empty() {
                        steps.add(source.groups.len());
                        continue;
                    }
                    let tile = &self.tiles[index];
                    let [nx, ny] = tile.size;
                    let turned = &mut turned[..nx * ny * wide.row];
                    for (i, lanes) in turned.chunks_exact_mut(wide.row).enumerate() {
                        if wanted.is_by(patch([i % nx, i / nx])) {
                            lanes.fill(0.0);
                        }
                    }
                    let mut rows: Vec<&mut [f32]> = turned.chunks_mut(nx * wide.row).collect();
                    for views in &source.groups {
                        if steps.is_canceled() {
                            return;
                        }
                        steps.add(1);
                        source.entries.add(
                            Place { index, tile, views },
                            source.lanes,
                            &nonzero,
                            wanted,
                            &mut rows,
                            &mut desk.bench,
                        );
                    }
                }
                let tiles: Vec<usize> = orbit.iter().map(|(index, _)| *index).collect();
                for target in orbit {
                    finish(&tiles, target, desk);
                }
            });
    }

    /// Rows of pixels → lanes of slots, of some views; others are dark.
    fn expand_parts(
        &self,
        light: usize,
        wide: Wide,
        SeenViews { views, sides }: &SeenViews,
        x: &[f32],
        lanes: &mut [f32],
    ) {
        let (plan, layout) = (&self.lights[light], &self.patterns[light]);
        let buffer = || vec![0.0; plan.levels.overlaps.buffer()];
        lanes
            .chunks_mut(plan.columns * wide.row)
            .enumerate()
            .par_each_with(buffer, |buffer, (first_view, lanes)| {
                lanes.fill(0.0);
                for (column, lanes) in lanes.chunks_mut(wide.row).enumerate() {
                    for part in 0..wide.parts {
                        let view = part * plan.turned.period + first_view;
                        if views.contains(&view) {
                            let slot = view * plan.columns + column;
                            let lanes = &mut lanes[wide.lanes(part)];
                            plan.add_expanded(layout, slot, sides.clone(), x, lanes, buffer);
                        }
                    }
                }
            });
    }

    /// Where row `y` of a tile's voxels takes its lanes from: a turn maps tiles onto `tiles` and rows onto lines.
    pub(super) fn lines(
        &self,
        plan: &LightPlan,
        wide: Wide,
        tiles: &[usize],
        tile: &Tile,
        y: usize,
    ) -> Lines {
        let of_part = |part: usize| {
            let [u, v] = plan.turned.origin(part, [tile.start[0], tile.start[1] + y]);
            let from = tiles.iter().position(|&i| self.tiles[i].holds([u, v]));
            let from = from.unwrap_or_default();
            let Tile { start, size } = self.tiles[tiles[from]];
            let voxel = (v - start[1]) * size[0] + u - start[0];
            let [along_x, along_y] = plan.turned.origin_step(part);
            let step = along_y * size[0] as isize + along_x;
            let first = from * wide.of_tile() + voxel * wide.row + wide.lanes(part).start;
            (first, step * wide.row as isize)
        };
        Lines {
            wide,
            of_part: std::array::from_fn(|part| of_part(part % wide.parts)),
        }
    }

    /// Adds to the dose of a tile its lanes of all parts, which lie in those of `tiles`; writes them over the doses of regions that are `chosen` only.
    fn add_turned(
        &self,
        plan: &LightPlan,
        tiles: &[usize],
        index: usize,
        rows: Vec<&mut [f32]>,
        chosen: Option<&Chosen>,
        desk: &mut Desk,
    ) {
        if chosen.is_some_and(|chosen| chosen.is_empty_in(index)) {
            return;
        }
        let (tile, row, wide) = (&self.tiles[index], plan.levels.row, Wide::of(plan));
        let Desk {
            turned,
            lanes,
            slices,
            buffer,
            ..
        } = desk;
        lanes.clear();
        lanes.resize(TILE * row, 0.0);
        for (y, dose) in rows.into_iter().enumerate() {
            let lanes = &mut lanes[..tile.size[0] * row];
            let lines = self.lines(plan, wide, tiles, tile, y);
            for (x, lanes) in lanes.chunks_mut(row).enumerate() {
                if chosen.is_some_and(|chosen| !chosen.has(index, [x, y])) {
                    continue;
                }
                let sums = lanes[..wide.part].as_chunks_mut::<LANES>().0;
                sums.fill([0.0; LANES]);
                for values in lines.of_voxel(x, turned) {
                    let values = values.as_chunks::<LANES>().0;
                    for (sums, values) in sums.iter_mut().zip(values) {
                        sums.iter_mut()
                            .zip(values)
                            .for_each(|(sum, value)| *sum += value);
                    }
                }
            }
            let Some(chosen) = chosen else {
                match &plan.levels.spread {
                    Some(spread) => spread.add_to(dose, lanes, buffer),
                    None => dose
                        .iter_mut()
                        .zip(&*lanes)
                        .for_each(|(d, lane)| *d += lane),
                }
                continue;
            };
            let columns = dose.chunks_mut(self.output.row).zip(lanes.chunks(row));
            for (x, (dose, lanes)) in columns.enumerate() {
                if !chosen.has(index, [x, y]) {
                    continue;
                }
                let mut all = lanes;
                if let Some(spread) = &plan.levels.spread {
                    slices.clear();
                    slices.resize(self.output.row, 0.0);
                    spread.add_to(slices, lanes, buffer);
                    all = slices;
                }
                for range in chosen.slices(index, [x, y]) {
                    dose[range.clone()].copy_from_slice(&all[range]);
                }
            }
        }
    }

    /// grad = Aᵀ c for these views of one light.
    pub(super) fn adjoint_kept(
        &self,
        light: usize,
        seen: &SeenViews,
        cotangent: &[f32],
        grad: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let entries = self.entries(light, work)?;
        let (plan, views) = (entries.plan, &seen.views);
        let wide = Wide::of(plan);
        let of_rows = self.of_rows(plan, cotangent);
        let cotangent = of_rows.as_ref().map_or(cotangent, HostField::as_slice);
        let (row, lengths) = (
            plan.levels.row / LANES,
            patches::block_lengths(self.path.isa, wide.parts),
        );
        let nonzero = NonzeroBlocks::in_blocks(cotangent, row, plan.levels.used, lengths);
        let cotangent = Cotangent {
            entries,
            views,
            values: cotangent,
            nonzero: &nonzero,
        };
        let groups = repeated(views, plan.turned.period);
        let (len, per_view) = (wide.slots * wide.row, plan.columns * wide.row);
        let bands = bands(len).min(self.orbits.len() / IN_A_BAND).max(1);
        // Few long chunks turn the cotangent less often; the result does not depend on their length
        let chunks = (4 * rayon::current_num_threads()).div_ceil(bands);
        let chunk = groups.len().div_ceil(chunks).max(1);
        let mut lanes = self.scratch.borrow(bands * len);
        let mut tasks = Vec::new();
        for (band, mut rest) in lanes.as_mut_slice().chunks_mut(len).enumerate() {
            let mut end = 0;
            for groups in groups.chunks(chunk) {
                let (first, last) = (groups[0].start, groups[groups.len() - 1].end);
                let (_, from) = rest.split_at_mut((first - end) * per_view);
                let (share, after) = from.split_at_mut((last - first) * per_view);
                tasks.push((band, groups, share));
                (rest, end) = (after, last);
            }
        }
        let per_band = self.orbits.len().div_ceil(bands);
        tasks
            .into_iter()
            .par_each_with(Desk::default, |desk: &mut Desk, (band, groups, lanes)| {
                lanes.fill(0.0);
                let orbits = self.orbits.iter().skip(band * per_band).take(per_band);
                for &index in orbits.flatten() {
                    if work.is_canceled() {
                        return;
                    }
                    self.collect_kept(&cotangent, index, groups, lanes, desk);
                }
            });
        let (sum, others) = lanes.as_mut_slice().split_at_mut(len);
        let of_views = sum.chunks_mut(per_view).enumerate();
        of_views.par_each(|(view, sum)| {
            if groups.iter().any(|group| group.contains(&view)) {
                for others in others.chunks(len) {
                    let other = &others[view * per_view..][..per_view];
                    sum.iter_mut()
                        .zip(other)
                        .for_each(|(sum, other)| *sum += other);
                }
            }
        });
        let frames = plan.views.frames_of(seen);
        let lanes_of = |slot: usize| &sum[wide.of_slot(slot)];
        plan.collect(&self.patterns[light], frames, lanes_of, grad);
        self.scratch.give_back(lanes);
        if let Some(of_rows) = of_rows {
            self.scratch.give_back(of_rows);
        }
        work.check()
    }

    /// Adds to the lanes of groups of views, from the first to the last, what the cotangent that a tile is turned to gives.
    fn collect_kept(
        &self,
        whole: &Cotangent<'_>,
        index: usize,
        groups: &[Range<usize>],
        lanes: &mut [f32],
        desk: &mut Desk,
    ) {
        let (tile, nx) = (&self.tiles[index], self.output.grid.shape[2]);
        let (plan, wide) = (whole.entries.plan, Wide::of(whole.entries.plan));
        let row = plan.levels.row;
        let at = |y: usize| (0..tile.size[0]).map(move |x| [tile.start[0] + x, y]);
        let places: Vec<usize> = (tile.start[1]..tile.start[1] + tile.size[1])
            .flat_map(at)
            .flat_map(|at| (0..wide.parts).map(move |part| plan.turned.place_in(part, at)))
            .map(|[x, y]| y * nx + x)
            .collect();
        let per_view = plan.columns * wide.row;
        let mut collect = |cotangent: &TileCotangent, held: Wanted, bench: &mut Bench| {
            for views in groups {
                let range = views.start - groups[0].start..views.end - groups[0].start;
                let lanes = &mut lanes[range.start * per_view..range.end * per_view];
                (whole.entries).collect(
                    Place { index, tile, views },
                    cotangent,
                    held,
                    lanes,
                    bench,
                );
            }
        };
        if wide.parts == 1 && wide.row == row {
            let [short, long] = whole.nonzero;
            let nonzero = match short.cost_of(&places) < long.cost_of(&places) {
                true => short,
                false => long,
            };
            let cotangent = TileCotangent {
                values: whole.values,
                nonzero,
                of_tile: nonzero.of_tile(tile, nx),
                first: places[0],
                line: nx,
            };
            let held = cotangent.held(tile);
            return collect(&cotangent, Wanted::of(held.as_deref()), &mut desk.bench);
        }
        let [row_there, part] = [wide.row, wide.part].map(|len| len / LANES);
        let nonzero_there =
            NonzeroBlocks::side_by_side(whole.nonzero, row_there, wide.parts, part, &places);
        let local = Tile {
            start: [0, 0],
            ..*tile
        };
        let of_tile = nonzero_there.of_tile(&local, tile.size[0]);
        if of_tile.is_empty() {
            return;
        }
        let period = plan.turned.period;
        let turned = desk.turned(wide.of_tile());
        for (lanes, places) in turned
            .chunks_mut(wide.row)
            .zip(places.chunks_exact(wide.parts))
        {
            for (part, &place) in places.iter().enumerate() {
                let copy = &mut lanes[wide.lanes(part)];
                if whole.views.start < (part + 1) * period
                    && part * period < whole.views.end
                    && whole.nonzero[0].any(place)
                {
                    // Sixteen at a time: a call that copies would take longer than so few floats
                    let lanes = whole.values[place * row..][..wide.part]
                        .as_chunks::<LANES>()
                        .0;
                    let copy = copy.as_chunks_mut::<LANES>().0;
                    copy.iter_mut()
                        .zip(lanes)
                        .for_each(|(copy, lane)| *copy = *lane);
                } else {
                    copy.fill(0.0);
                }
            }
        }
        let cotangent = TileCotangent {
            values: desk.turned.as_slice(),
            nonzero: &nonzero_there,
            of_tile,
            first: 0,
            line: tile.size[0],
        };
        let held = cotangent.held(tile);
        collect(&cotangent, Wanted::of(held.as_deref()), &mut desk.bench);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn views_of_any_part_ask_for_those_of_the_first() {
        assert_eq!(repeated(&(0..40), 20), [0..8, 8..16, 16..20]);
        assert_eq!(repeated(&(25..30), 20), [5..8, 8..10]);
        // Around the end of a part: the first to the last of a group that the caller wants
        assert_eq!(repeated(&(18..27), 20), [0..7, 18..20]);
        assert_eq!(repeated(&(5..22), 20), [0..8, 8..16, 16..20]);
        assert!(repeated(&(3..3), 20).is_empty());
    }
}
