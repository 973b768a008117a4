//! The dose of a tile: what a group of views brings to its voxels, gathered voxel by voxel.

use super::block_sparsity::{Chosen, NonzeroBlocks};
use super::chains::{Avx512, Chain, GUARD, Taps};
use super::kernel::{Entries, accumulate};
use super::plan::{KernelPath, LightPlan};
use super::strips::Major;
use super::tiles::{Local, Meeting, Slots, TILE, Tile, TileEntries};
use std::ops::Range;
use tomolith_core::field::LANES;

/// What a group of views brings to a tile: chains as taps, all else as entries sorted by voxel.
#[derive(Default)]
pub(super) struct Gatherer {
    chains: Vec<Taps>,
    /// How many of `chains` are in use.
    chain_count: usize,
    loose: Sorter,
}

impl Gatherer {
    /// Enumerates what a group of views lights in a tile; `nonzero` tells of slots, `row`: vectors of a row of lanes.
    pub(super) fn load(
        &mut self,
        path: KernelPath,
        plan: &LightPlan,
        views: Range<usize>,
        (index, tile): (usize, &Tile),
        nonzero: &NonzeroBlocks,
        row: usize,
    ) {
        self.chain_count = 0;
        self.loose.found.clear();
        for view in views {
            for i in plan.of_view[view].clone() {
                let meeting = plan.meetings[index * plan.beams.len() + i];
                let strips = &plan.beams[i].strips[meeting.first as usize..meeting.end as usize];
                let first = view * plan.columns;
                if !(strips.iter()).any(|strip| nonzero.any(first + strip.column as usize)) {
                    continue;
                }
                if let Some(wide) = path.wide.filter(|_| meeting.chain) {
                    self.load_chain(wide, plan, (i, meeting), tile, row);
                } else {
                    self.loose.load(path, plan, i, meeting, tile);
                }
            }
        }
        self.loose.sort();
    }

    fn load_chain(
        &mut self,
        wide: Avx512,
        plan: &LightPlan,
        (beam, meeting): (usize, Meeting),
        tile: &Tile,
        row: usize,
    ) {
        if self.chains.len() == self.chain_count {
            self.chains.push(Taps::default());
        }
        let taps = &mut self.chains[self.chain_count];
        self.chain_count += 1;
        let beam = &plan.beams[beam];
        let chain = Chain::new(beam, meeting.first as usize, meeting.end as usize);
        let local = Local::new(tile, beam.major, Slots::WITHIN_TILE);
        let slot = beam.frame * plan.columns as u32;
        let hop = beam.columns.step * row as i32;
        wide.find_taps(taps, &chain, &local, beam.major == Major::X, (slot, hop));
    }

    /// Adds one block of lanes to the voxels of a tile; `source` has [`GUARD`] rows before slot 0.
    pub(super) fn add_block(
        &mut self,
        path: KernelPath,
        nonzero: &NonzeroBlocks,
        block: usize,
        source: &[f32],
        rows: &mut [&mut [f32]],
    ) {
        if let Some(wide) = path.wide {
            let used = self.chains[..self.chain_count].iter();
            let lit: Vec<&Taps> = used
                .filter(|taps| taps.slots().any(|slot| nonzero.any_in(slot, block)))
                .collect();
            if !lit.is_empty() {
                wide.gather_tile(rows, source, &lit, nonzero.blocks[block]);
            }
        }
        self.loose.add_block(
            path,
            nonzero,
            block,
            &source[GUARD * nonzero.blocks[block].row * LANES..],
            rows,
        );
    }
}

/// Entries of a group of views, sorted by voxel.
#[derive(Default)]
struct Sorter {
    /// By strip; a run's column is its slot: frame and column of the light.
    found: TileEntries,
    /// By voxel: slots and weights.
    slots: Vec<u32>,
    weights: Vec<f32>,
    /// First entry of each voxel.
    starts: Vec<u32>,
    /// Entries that are lit in the block at hand.
    chosen: Chosen,
}

impl Sorter {
    /// Enumerates what a beam lights in a tile.
    fn load(
        &mut self,
        path: KernelPath,
        plan: &LightPlan,
        beam: usize,
        meeting: Meeting,
        tile: &Tile,
    ) {
        let before = self.found.runs.len();
        let local = Local::new(tile, plan.beams[beam].major, Slots::WITHIN_TILE);
        plan.enumerate(path, beam, meeting, &local, &mut self.found);
        let first = plan.beams[beam].frame * plan.columns as u32;
        for run in &mut self.found.runs[before..] {
            run.column += first;
        }
    }

    /// Counting sort; within a voxel the order of frames and columns is kept, so sums are reproducible.
    fn sort(&mut self) {
        if self.found.runs.is_empty() {
            return;
        }
        self.starts.clear();
        self.starts.resize(TILE * TILE + 2, 0);
        for &voxel in &self.found.slots {
            self.starts[voxel as usize + 2] += 1;
        }
        for i in 2..self.starts.len() {
            self.starts[i] += self.starts[i - 1];
        }
        self.slots.resize(self.found.slots.len(), 0);
        self.weights.resize(self.found.slots.len(), 0.0);
        for run in &self.found.runs {
            let of_run = self.found.of(run);
            for (&voxel, &weight) in of_run.slots.iter().zip(of_run.weights) {
                let next = &mut self.starts[voxel as usize + 1];
                self.slots[*next as usize] = run.column;
                self.weights[*next as usize] = weight;
                *next += 1;
            }
        }
    }

    /// Adds one block of lanes to the voxels of a tile.
    fn add_block(
        &mut self,
        path: KernelPath,
        nonzero: &NonzeroBlocks,
        block: usize,
        source: &[f32],
        rows: &mut [&mut [f32]],
    ) {
        let is_lit = |slot: u32| nonzero.any_in(slot as usize, block);
        let slots = self.found.runs.iter().map(|run| run.column);
        let dark = slots.filter(|&slot| !is_lit(slot)).count();
        if dark == self.found.runs.len() {
            return;
        }
        let block = nonzero.blocks[block];
        for (y, line) in rows.iter_mut().enumerate() {
            for (x, voxel) in line.chunks_exact_mut(block.row * LANES).enumerate() {
                let v = y * TILE + x;
                let own = self.starts[v] as usize..self.starts[v + 1] as usize;
                let mut entries = Entries {
                    slots: &self.slots[own.clone()],
                    weights: &self.weights[own],
                };
                if dark > 0 {
                    entries = self.chosen.of(entries, is_lit);
                }
                if !entries.slots.is_empty() {
                    let out = &mut voxel[block.first * LANES..][..block.count * LANES];
                    accumulate(path.isa, out, source, entries, block);
                }
            }
        }
    }
}
