//! The matrix of a slice, found once and stored between calls.
//!
//! An optimization computes doses again and again. Where the entries (column, voxel, weight) of all frames take at most [`MOST`] bytes, they are
//! stored, by patches of 2 × 2 voxels ([`patches`]): what few rows of pixels bring takes less time to sum than to find. What all angles of a
//! frame bring from a column to a voxel is one entry, so that a frame averaged over four angles costs little more than one that stands
//! still. Views that repeat those of a quarter turn before have the same entries, turned: only those of the first quarter are found and stored, and
//! serve all ([`kept`](super::kept)). Dose and adjoint are sums along the same entries. Whether they are stored depends on the job alone, so a resumed
//! run has the bits of the uninterrupted one.
//!
//! # Cost
//! 20 bytes for each column of each frame that lights a patch, and the time of one dose without stored entries; a quarter of both where quarters
//! repeat.

use super::block_sparsity::{LENGTHS, NonzeroBlocks, NonzeroTile, is_nonzero};
use super::kernel::{Block, MAX_BLOCK};
use super::patches::{self, ColumnEntry, Patches, VOXELS};
use super::plan::{KernelPath, LightPlan};
use super::tiles::{Local, TILE, Tile, TileEntries};
use super::turned::Turned;
use super::{GROUP, groups, is_straight, updates_of_group};
use crate::Work;
use std::f64::consts::PI;
use std::ops::Range;
use tomolith_core::error::Result;
use tomolith_core::field::LANES;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// Most bytes that are stored.
const MOST: f64 = (1u64 << 31) as f64;

/// Bytes of an entry: a slot, and weights of the patch.
const BYTES: f64 = (size_of::<u32>() + size_of::<[f32; VOXELS]>()) as f64;

/// Voxels along the edge of a patch, and patches along that of a tile.
pub(super) const EDGE: usize = 2;
pub(super) const PATCHES: usize = TILE / EDGE;

/// When a model finds the entries of a slice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Finding {
    /// In each call: those of the first part of the turn serve all of it.
    InEachCall,
    /// In each call, those of all views: the geometry that a card gets has them all.
    OfAllViews,
    /// In the first call, which stores them.
    Once,
}

/// Bytes that an optimization stores of these lights; None where that would be too much, or rows have no lanes.
pub(super) fn bytes(lights: &[Light], vial: &dyn Vial, grid: &VolumeGrid) -> Option<f64> {
    let turned = Turned::of_lights(vial, lights, grid, Finding::Once);
    let of_light = |(light, turned): (&Light, &Turned)| {
        BYTES * expected(light, vial, grid) / turned.parts as f64
    };
    let bytes = lights.iter().zip(&turned).map(of_light).sum();
    (grid.shape[0] > 1 && bytes <= MOST).then_some(bytes)
}

/// Entries that calls sum along: what is stored of the first part of a turn serves all parts.
pub(super) fn entries(lights: &[Light], vial: &dyn Vial, grid: &VolumeGrid) -> f64 {
    lights.iter().map(|light| expected(light, vial, grid)).sum()
}

/// Entries of one light, of about that number: a patch has one in each frame, and as many more as columns cross it and the arc that it
/// turns through.
fn expected(light: &Light, vial: &dyn Vial, grid: &VolumeGrid) -> f64 {
    let [_, ny, nx] = grid.shape.map(|n| n as f64);
    let pixels = &light.pixels;
    // Walls that refract bring columns nearer to each other
    let column_mm = if is_straight(vial, light) {
        pixels.pitch_mm[0]
    } else {
        pixels.pitch_mm[0] / light.resin.refractive_index
    };
    let angles = light.sub_angles.max(1) as f64;
    let radius_mm = f64::hypot(nx, ny) / 2.0 * grid.pitch_mm;
    let turned_mm = 2.0 / 3.0 * radius_mm * pixels.frame_arc * (1.0 - 1.0 / angles);
    // Widths as seen from all sides, on average: of a square, and of an arc
    let wide_mm = 4.0 / PI * EDGE as f64 * grid.pitch_mm + 2.0 / PI * turned_mm;
    nx * ny / VOXELS as f64 * pixels.frames() as f64 * (1.0 + wide_mm / column_mm)
}

/// Entries of a light from the views of the first part of the turn, by tile and group of views.
pub(super) struct CachedEntries {
    /// `[tile][group]`; none where they are found in each call.
    groups: Vec<Group>,
    per_tile: usize,
}

/// What a group of views brings to a tile; slots are counted from the first one of the group on.
#[derive(Default)]
struct Group {
    patches: Patches,
    /// Slots of all entries, each once.
    lit_by: Vec<u32>,
}

/// What finding the entries of a tile needs, made once a thread.
#[derive(Default)]
struct Finder {
    found: TileEntries,
    /// What columns bring to a patch, `[patch][column]`.
    joined: Vec<[f32; VOXELS]>,
    patches: Vec<Vec<ColumnEntry>>,
}

impl Finder {
    /// The entries of a tile from views of a group of the first part of the turn, patch by patch, of those slots that are `needed`.
    fn find(
        &mut self,
        path: KernelPath,
        plan: &LightPlan,
        Place { index, tile, views }: Place,
        needed: impl Fn(usize) -> bool,
    ) -> Patches {
        self.patches.resize(PATCHES * PATCHES, Vec::new());
        self.patches.iter_mut().for_each(Vec::clear);
        let first_of_group = first_of_group(views);
        for view in views.clone() {
            let first = ((view - first_of_group) * plan.columns) as u32;
            self.found.clear();
            for beam in plan.of_view[view].clone() {
                let meeting = plan.meeting(index, beam);
                let local = Local::new(tile, plan.beams[beam].major);
                let keep = |column| {
                    needed(view * plan.columns + column as usize)
                        && plan.is_lit_in_any_part(view, column)
                };
                plan.enumerate_columns(path, beam, meeting, &local, keep, &mut self.found);
            }
            self.add_found(first);
        }
        Patches::new(&self.patches)
    }

    /// Joins what all angles of a view bring from a column to a patch; `first` is the slot of its first column.
    fn add_found(&mut self, first: u32) {
        let columns = self.found.runs.iter().map(|run| run.column);
        let Some((least, most)) = columns.clone().min().zip(columns.max()) else {
            return;
        };
        let span = (most - least + 1) as usize;
        self.joined.clear();
        self.joined.resize(PATCHES * PATCHES * span, [0.0; VOXELS]);
        for run in &self.found.runs {
            let entries = self.found.of(run);
            for (&voxel, &weight) in entries.slots.iter().zip(entries.weights) {
                let [y, x] = [voxel as usize / TILE, voxel as usize % TILE];
                let patch = y / EDGE * PATCHES + x / EDGE;
                let corner = y % EDGE * EDGE + x % EDGE;
                self.joined[patch * span + (run.column - least) as usize][corner] += weight;
            }
        }
        for (entries, joined) in self.patches.iter_mut().zip(self.joined.chunks_exact(span)) {
            for (slot, weights) in (first + least..).zip(joined) {
                if *weights != [0.0; VOXELS] {
                    entries.push((slot, *weights));
                }
            }
        }
    }
}

/// What adding light to tiles needs, made once a thread.
#[derive(Default)]
pub(super) struct Bench {
    /// What finds entries that are not stored, and what it found last.
    finder: Finder,
    found: Group,
    /// Which slots of a group are lit.
    lit: Vec<bool>,
    /// Which entries of a patch count.
    chosen: Vec<u32>,
    /// Lanes of voxels of a patch that are outside the tile.
    outside: Vec<f32>,
}

impl Group {
    fn of(patches: Patches) -> Self {
        let mut is_lit = vec![false; patches.rows()];
        for &slot in patches.slots() {
            is_lit[slot as usize] = true;
        }
        let lit_by = (0..)
            .zip(is_lit)
            .filter_map(|(slot, is_lit)| is_lit.then_some(slot));
        let lit_by = lit_by.collect();
        Group { patches, lit_by }
    }

    /// Notes in `lit` which slots `is_lit` says are; how many.
    fn light(&self, lit: &mut Vec<bool>, is_lit: impl Fn(u32) -> bool) -> usize {
        if lit.len() < self.patches.rows() {
            lit.resize(self.patches.rows(), false);
        }
        // Entries have no other slots
        let each = self.lit_by.iter().map(|&slot| {
            lit[slot as usize] = is_lit(slot);
            usize::from(lit[slot as usize])
        });
        each.sum()
    }
}

/// Lanes that are read soon. They lie far apart, so that the processor would wait for each; asked for ahead, a few with every patch, they are in the cache.
struct Ahead<'a> {
    /// Slots of each step, counted from `first` on.
    slots: std::slice::Chunks<'a, u32>,
    first: usize,
    block: usize,
    lanes: &'a [f32],
    nonzero: &'a NonzeroBlocks,
}

impl Ahead<'_> {
    fn go_on(&mut self) {
        let Some(&block) = self.nonzero.blocks.get(self.block) else {
            return;
        };
        for &slot in self.slots.next().unwrap_or_default() {
            let slot = self.first + slot as usize;
            if self.nonzero.any_in(slot, self.block) {
                let from = (slot * block.row + block.first) * LANES;
                patches::prefetch(&self.lanes[from..from + block.count * LANES]);
            }
        }
    }
}

/// A cotangent of which a tile's voxels are read, as rows of lanes.
pub(super) struct TileCotangent<'a> {
    pub(super) values: &'a [f32],
    /// Which rows hold anything, and which of those of the tile.
    pub(super) nonzero: &'a NonzeroBlocks,
    pub(super) of_tile: NonzeroTile,
    /// The row of the tile's first voxel, and rows from one line of voxels to the next.
    pub(super) first: usize,
    pub(super) line: usize,
}

impl TileCotangent<'_> {
    /// A bit for each vector of lanes that holds anything in a voxel of a patch; None where rows have more vectors than bits.
    pub(super) fn held(&self, tile: &Tile) -> Option<Vec<u64>> {
        let row = self.nonzero.blocks.first().map_or(0, |block| block.row);
        if row > u64::BITS as usize {
            return None;
        }
        let mut held = vec![0; PATCHES * PATCHES];
        for y in 0..tile.size[1] {
            for x in 0..tile.size[0] {
                let voxel = self.first + y * self.line + x;
                for block in self.nonzero.blocks_of(voxel) {
                    let from = (voxel * row + block.first) * LANES;
                    let lanes = self.values[from..][..block.count * LANES]
                        .as_chunks::<LANES>()
                        .0;
                    for (vector, lanes) in (block.first..).zip(lanes) {
                        held[patch([x, y])] |= u64::from(is_nonzero(lanes)) << vector;
                    }
                }
            }
        }
        Some(held)
    }
}

/// The patch of a voxel `[x, y]` of a tile, counted from its first.
pub(super) fn patch([x, y]: [usize; 2]) -> usize {
    y / EDGE * PATCHES + x / EDGE
}

/// Which vectors of lanes are wanted of the patches of a tile.
#[derive(Clone, Copy)]
pub(super) struct Wanted<'a> {
    /// A bit for each vector of a patch; None: all.
    vectors: Option<&'a [u64]>,
    /// Those that any patch wants.
    of_any: u64,
}

impl<'a> Wanted<'a> {
    pub(super) fn of(vectors: Option<&'a [u64]>) -> Self {
        let all = |vectors: &[u64]| vectors.iter().fold(0, |all, bits| all | bits);
        Wanted {
            vectors,
            of_any: vectors.map_or(u64::MAX, all),
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.of_any == 0
    }

    /// Whether any patch wants a vector of a block.
    fn any_in(&self, block: Block) -> bool {
        self.vectors.is_none() || within(self.of_any, block) != 0
    }

    /// Whether a patch wants any vector.
    pub(super) fn is_by(&self, patch: usize) -> bool {
        self.vectors.is_none_or(|vectors| vectors[patch] != 0)
    }

    /// The parts of a block that a patch wants, each from its first to its last vector: vectors with a gap of one between them are one part.
    fn parts(&self, patch: usize, block: Block) -> impl Iterator<Item = Block> {
        let mut bits = match self.vectors {
            None => u64::MAX >> (u64::BITS as usize - block.count.min(64)),
            Some(vectors) => within(vectors[patch], block),
        };
        bits |= bits << 1 & bits >> 1;
        std::iter::from_fn(move || {
            (bits != 0).then(|| {
                let first = bits.trailing_zeros();
                let count = (bits >> first).trailing_ones();
                bits &= u64::MAX.checked_shl(first + count).unwrap_or(0);
                Block {
                    first: block.first + first as usize,
                    count: count as usize,
                    ..block
                }
            })
        })
    }
}

/// Bits of the vectors of a block, the first one's lowest.
fn within(vectors: u64, block: Block) -> u64 {
    vectors >> block.first & (u64::MAX >> (u64::BITS as usize - block.count))
}

/// A tile with its number, and views of a group.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub(super) index: usize,
    pub(super) tile: &'a Tile,
    pub(super) views: &'a Range<usize>,
}

impl CachedEntries {
    /// Finds entries in each call.
    pub(super) fn in_each_call() -> Self {
        CachedEntries {
            groups: Vec::new(),
            per_tile: 0,
        }
    }

    /// Finds all entries of a light.
    pub(super) fn of(
        plan: &LightPlan,
        path: KernelPath,
        tiles: &[Tile],
        work: &Work,
    ) -> Result<Self> {
        let period = plan.turned.period;
        let of_tiles = tiles.iter().enumerate();
        let found = of_tiles.par_map_with(Finder::default, |finder, (index, tile)| {
            let groups = groups(0..period).take_while(|_| !work.is_canceled());
            let find = |views| {
                let views = &views;
                finder.find(path, plan, Place { index, tile, views }, |_| true)
            };
            groups.map(find).map(Group::of).collect::<Vec<_>>()
        });
        work.check()?;
        Ok(CachedEntries {
            groups: found.into_iter().flatten().collect(),
            per_tile: groups(0..period).count(),
        })
    }

    /// Whether they are stored.
    pub(super) fn is_kept(&self) -> bool {
        self.per_tile > 0
    }

    /// Pairs of frame and voxel that are lit, as [`LightPlan::updates_in`] counts them.
    pub(super) fn updates(&self, plan: &LightPlan, nz: usize) -> u64 {
        let views: Vec<_> = groups(0..plan.turned.period).collect();
        let of_groups = self.groups.iter().enumerate().par_map(|(i, group)| {
            let views = &views[i % self.per_tile];
            let mut lit = Vec::new();
            let of_view = |view| {
                let first = ((view - views.start) * plan.columns) as u32;
                let slots = first..first + plan.columns as u32;
                let of_patch = |patch| {
                    lit.clear();
                    let entries = group.patches.of_slots(patch, slots.clone());
                    lit.extend(
                        entries.map(|(slot, weights)| (slot - slots.start, lit_by(weights))),
                    );
                    plan.pairs_of_patch(view, nz, &lit)
                };
                (0..PATCHES * PATCHES).map(of_patch).sum::<u64>()
            };
            updates_of_group(views.clone(), self.groups.len(), of_view)
        });
        of_groups.into_iter().sum::<u64>()
    }

    /// Bytes of all entries.
    #[cfg(test)]
    pub(super) fn bytes(&self) -> usize {
        let of_groups = self.groups.iter().map(|group| group.patches.len());
        let entries: usize = of_groups.sum();
        entries * BYTES as usize
    }
}

/// The entries of a light, stored or found in each call.
#[derive(Clone, Copy)]
pub(super) struct LightEntries<'a> {
    pub(super) plan: &'a LightPlan,
    pub(super) path: KernelPath,
    pub(super) cached: &'a CachedEntries,
}

impl LightEntries<'_> {
    /// What the group that views belong to brings to a tile: all of it where it is stored, else that of the views' slots that are `needed`.
    fn group<'a>(
        &'a self,
        place: Place,
        needed: impl Fn(usize) -> bool,
        finder: &mut Finder,
        found: &'a mut Group,
    ) -> &'a Group {
        let CachedEntries { groups, per_tile } = self.cached;
        if self.cached.is_kept() {
            return &groups[place.index * per_tile + place.views.start / GROUP];
        }
        *found = Group::of(finder.find(self.path, self.plan, place, needed));
        found
    }

    /// Adds to the voxels of a tile what views of a group bring, where it is wanted; `slots` has the lanes of all slots of the light.
    pub(super) fn add(
        &self,
        place: Place<'_>,
        slots: &[f32],
        nonzero: &NonzeroBlocks,
        wanted: Wanted<'_>,
        rows: &mut [&mut [f32]],
        bench: &mut Bench,
    ) {
        let (path, columns) = (self.path, self.plan.columns);
        let is_lit = |slot| nonzero.any(slot);
        let group = self.group(place, is_lit, &mut bench.finder, &mut bench.found);
        let first = first_of_group(place.views) * columns;
        let slot_range = slots_of(place.views, columns);
        let is_whole = is_whole(&slot_range, group);
        for (i, &block) in nonzero.blocks.iter().enumerate() {
            if !wanted.any_in(block) {
                continue;
            }
            let lit = group.light(&mut bench.lit, |slot| {
                slot_range.contains(&slot) && nonzero.any_in(first + slot as usize, i)
            });
            if lit == 0 {
                continue;
            }
            // Looking at an entry takes as long as adding a register of zeros
            let dark = group.lit_by.len() - lit;
            let chooses = !is_whole || 4 * dark * block.count > 3 * group.lit_by.len();
            let source = &slots[first * block.row * LANES..];
            let mut ahead = self.ahead(place, group, i, slots, nonzero, wanted);
            for (y, lines) in rows.chunks_mut(EDGE).enumerate() {
                let across = lines[0].len() / (block.row * LANES);
                for x in 0..across.div_ceil(EDGE) {
                    ahead.go_on();
                    let patch = y * PATCHES + x;
                    let mut parts = wanted.parts(patch, block).peekable();
                    let entries = parts.peek().and_then(|_| group.patches.of(patch, 0));
                    let Some(mut entries) = entries else {
                        continue;
                    };
                    if chooses {
                        let is_lit = |slot: u32| bench.lit[slot as usize];
                        entries = entries.choose(&mut bench.chosen, is_lit);
                    }
                    if !entries.is_empty() {
                        for part in parts {
                            let out = voxels_of(lines, x * EDGE, part, &mut bench.outside);
                            patches::gather(path.isa, out, source, entries, part);
                        }
                    }
                }
            }
        }
    }

    /// What is read after block `i` of a group: its next block, else the first one of the tile's next group. Nothing where blocks are long: there it saves no time.
    fn ahead<'a>(
        &'a self,
        Place { index, views, .. }: Place,
        group: &'a Group,
        i: usize,
        slots: &'a [f32],
        nonzero: &'a NonzeroBlocks,
        wanted: Wanted<'_>,
    ) -> Ahead<'a> {
        let (plan, per_tile) = (self.plan, self.cached.per_tile);
        let has_long_blocks = patches::block_lengths(self.path.isa, plan.turned.parts) == LENGTHS;
        let blocks = &nonzero.blocks;
        let next_of = |mut range: Range<usize>| range.find(|&i| wanted.any_in(blocks[i]));
        let group_after = views.start / GROUP + 1;
        let (first, lit_by, block) = match next_of(i + 1..blocks.len()) {
            _ if has_long_blocks => (0, [].as_slice(), 0),
            Some(block) => (first_of_group(views), group.lit_by.as_slice(), block),
            None if group_after < per_tile => {
                let group = &self.cached.groups[index * per_tile + group_after];
                let block = next_of(0..i + 1).unwrap_or(i);
                (group_after * GROUP, group.lit_by.as_slice(), block)
            }
            None => (0, [].as_slice(), 0),
        };
        Ahead {
            slots: lit_by.chunks(lit_by.len().div_ceil(PATCHES * PATCHES).max(1)),
            first: first * plan.columns,
            block,
            lanes: slots,
            nonzero,
        }
    }

    /// Adds to the lanes of views of a group, and of no others, what the cotangent of a tile's voxels gives (transpose of [`add`](Self::add)).
    pub(super) fn collect(
        &self,
        place: Place<'_>,
        cotangent: &TileCotangent,
        held: Wanted<'_>,
        lanes: &mut [f32],
        bench: &mut Bench,
    ) {
        let TileCotangent {
            values, nonzero, ..
        } = *cotangent;
        if cotangent.of_tile.is_empty() {
            return;
        }
        let group = self.group(place, |_| true, &mut bench.finder, &mut bench.found);
        if group.lit_by.is_empty() {
            return;
        }
        let size = place.tile.size;
        let slot_range = slots_of(place.views, self.plan.columns);
        let is_whole = is_whole(&slot_range, group);
        let dark = [0.0; MAX_BLOCK * LANES];
        for (i, &block) in nonzero.blocks.iter().enumerate() {
            if !cotangent.of_tile.any_in(i) {
                continue;
            }
            for patch in 0..PATCHES * PATCHES {
                let mut parts = held.parts(patch, block).peekable();
                let entries = parts
                    .peek()
                    .and_then(|_| group.patches.of(patch, slot_range.start));
                let Some(mut entries) = entries else {
                    continue;
                };
                let voxel = |corner: usize| {
                    let x = patch % PATCHES * EDGE + corner % EDGE;
                    let y = patch / PATCHES * EDGE + corner / EDGE;
                    let voxel = cotangent.first + y * cotangent.line + x;
                    let is_inside = x < size[0] && y < size[1];
                    (is_inside && nonzero.any_in(voxel, i)).then_some(voxel)
                };
                let voxels = [0, 1, 2, 3].map(voxel);
                if voxels == [None; VOXELS] {
                    continue;
                }
                if !is_whole {
                    entries = entries.choose(&mut bench.chosen, |slot| slot_range.contains(&slot));
                }
                for part in parts {
                    let values = voxels.map(|voxel| match voxel {
                        Some(voxel) => {
                            let from = (voxel * part.row + part.first) * LANES;
                            &values[from..from + part.count * LANES]
                        }
                        None => &dark[..part.count * LANES],
                    });
                    patches::spread(self.path.isa, lanes, values, entries, part);
                }
            }
        }
    }
}

/// A bit for each voxel of a patch that a column lights.
fn lit_by(weights: &[f32; VOXELS]) -> u8 {
    let bit = |(i, weight): (usize, &f32)| u8::from(*weight != 0.0) << i;
    weights.iter().enumerate().map(bit).sum()
}

/// The first view of the group that views belong to.
fn first_of_group(views: &Range<usize>) -> usize {
    views.start - views.start % GROUP
}

/// Slots of some views of a group, counted from its first one on.
fn slots_of(views: &Range<usize>, columns: usize) -> Range<u32> {
    let first = views.start - first_of_group(views);
    let slot = |view: usize| (view * columns) as u32;
    slot(first)..slot(first + views.len())
}

/// Whether all that light is in a group of slots is of these.
fn is_whole(slots: &Range<u32>, group: &Group) -> bool {
    let ends = [group.lit_by.first(), group.lit_by.last()];
    ends.iter().flatten().all(|slot| slots.contains(slot))
}

/// The lanes of a patch's voxels; those outside the tile are `outside`'s.
fn voxels_of<'a>(
    lines: &'a mut [&mut [f32]],
    x: usize,
    block: Block,
    outside: &'a mut Vec<f32>,
) -> [&'a mut [f32]; VOXELS] {
    let (row, len) = (block.row * LANES, block.count * LANES);
    outside.resize(VOXELS * len, 0.0);
    let mut spare = outside.chunks_mut(len);
    let mut of_line = lines.iter_mut().map(|line| {
        let column = &mut line[x * row..];
        column.chunks_mut(row).take(EDGE)
    });
    let [mut upper, mut lower] = [of_line.next(), of_line.next()];
    let mut next = |corner: usize| {
        let line = if corner < EDGE {
            &mut upper
        } else {
            &mut lower
        };
        match line.as_mut().and_then(Iterator::next) {
            Some(voxel) => &mut voxel[block.first * LANES..][..len],
            None => spare.next().unwrap_or_default(),
        }
    };
    [0, 1, 2, 3].map(&mut next)
}
