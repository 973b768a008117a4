//! The `parallel` dose model: collimated light through geometry that does not change along z.
//!
//! # Model
//! Light of pixel column u enters the vial, is refracted and weakened at its walls ([`Tracer`]), and runs along straight
//! lines through resin that absorbs it. The geometry of one slice serves all heights, so the inner loop walks along z.
//!
//! # Equation
//! With pattern values x (mJ/mm²), voxel volume V, column u and height z of a point r as seen by frame k:
//!
//! ```text
//! forward   dose(v) = Σ_k (μ_a/V) ∫_V x_k(u_k(r), z) · T_k · |du/dt| · e^(−μ_t·s_k(r)) dV
//! adjoint   grad(k, column, row) = Σ_v (∂dose(v)/∂x_k(column, row)) · c(v)
//! ```
//! T: transmittance of the walls; |du/dt|: what refraction focuses or spreads; s: way through resin. In pure Radon mode
//! the factors μ_a and e^(−μ_t s) are 1. All rays that reach a point count (several branches beyond n_s·R_o/n_r, two
//! legs in a double tube).
//!
//! # Discretisation
//! `kernel = "distance-driven"`: see [`strips`] and [`tiles`]. Along z pixels are boxes and the overlap with a voxel is
//! exact. A pixel's absorbed energy is conserved to rounding, a uniform light gives a uniform fluence, and the error of a
//! voxel falls with the square of the pitch.
//!
//! # Source
//! Design: Nicolet et al. 2024, §3 (volumetric rendering equation without scattering); kernel: De Man & Basu 2004.
//!
//! # Shapes
//! Patterns and dose as in [`layout`](crate::models::layout).
//!
//! # Limits
//! Collimated light, walls and absorption that do not change along z, light reflected at a wall is lost.
//!
//! # Cost
//! One *update* is one voxel lit by one frame: about two fused multiply-adds and two loads of one float each, shared
//! geometry aside. Memory beside the fields: lanes of all pixels once (frames·columns·nz floats).
//!
//! # Example
//! Uniform light of 1 mJ/mm² from four sides through an index-matched cylinder makes, at the axis, four times
//! μ·e^(−μR):
//! ```
//! use tomolith::field::{Field, HostField};
//! use tomolith::grid::{PatternGrid, VolumeGrid};
//! use tomolith::models::{DoseModel, Run, parallel::{Light, Parallel}};
//! use tomolith::optics::{resin::Resin, vial::index_matched::IndexMatched};
//! let pixels = PatternGrid::full_turn(4, 0.0, 4, 40, 0.1);
//! let light = Light::new(pixels, Resin::absorbing(1.5, 0.1));
//! let grid = VolumeGrid::centered([4, 31, 31], 0.1);
//! let model = Parallel::new(&IndexMatched { radius_mm: 2.0 }, vec![light], grid).unwrap();
//! let mut x = model.new_patterns().unwrap();
//! x.fill(1.0);
//! let mut dose = model.new_dose().unwrap();
//! model.dose(&x, &mut dose, &Run::new()).unwrap();
//! let volume = model.outputs()[0].volume_of(dose.as_slice());
//! let expected = 4.0 * 0.1 * (-0.1f64 * 2.0).exp();
//! assert!((f64::from(*volume.at(2, 15, 15)) / expected - 1.0).abs() < 1e-4);
//! ```

mod chains;
mod heights;
pub mod kernel;
mod strips;
mod tiles;

use crate::error::{Error, Result};
use crate::field::{Field, HostField, LANES};
use crate::grid::{PatternGrid, Volume, VolumeGrid};
use crate::models::layout::PixelRun;
use crate::models::{DoseLayout, LinearOperator, PatternLayout, Quantity, Run, ZCoupling};
use crate::optics::interface::Polarisation;
use crate::optics::resin::Resin;
use crate::optics::trace::Tracer;
use crate::optics::vial::Vial;
use chains::{Avx512, Chain, Taps};
use heights::Heights;
use kernel::{Block, Entries, Isa, MAX_BLOCK, accumulate};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::{Mutex, OnceLock, PoisonError};
use strips::{Beam, Major};
use tiles::{Deposit, Local, Meeting, Slots, TILE, Tile, TileEntries};

/// One light: its pixels and what the resin does at its wavelength.
#[derive(Clone, Debug)]
pub struct Light {
    /// Frames, rows, columns.
    pub pixels: PatternGrid,
    /// The resin at this wavelength.
    pub resin: Resin,
    /// Index of what surrounds the vial.
    pub surrounding_index: f64,
    /// Polarisation at the projector.
    pub polarisation: Polarisation,
    /// Positions within a frame's arc that are averaged; 1: the vial stands still during a frame.
    pub sub_angles: usize,
    /// Rows that may be lit, per (frame, column): `(bottom, count)` counted from the lowest row. None: all.
    pub active: Option<Vec<(u32, u32)>>,
}

impl Light {
    /// Unpolarised light in air, standing still, all pixels active.
    #[must_use]
    pub fn new(pixels: PatternGrid, resin: Resin) -> Self {
        Light {
            pixels,
            resin,
            surrounding_index: 1.0,
            polarisation: Polarisation::Unpolarised,
            sub_angles: 1,
            active: None,
        }
    }
}

/// See the [module page](self).
pub struct Parallel {
    lights: Vec<LightPlan>,
    patterns: Vec<PatternLayout>,
    outputs: Vec<DoseLayout>,
    tiles: Vec<Tile>,
    path: KernelPath,
    /// Lanes of pixels, kept between calls.
    scratch: Mutex<Vec<HostField>>,
    updates: OnceLock<u64>,
}

/// Which kernels run.
#[derive(Clone, Copy, Debug)]
struct KernelPath {
    isa: Isa,
    /// Chains as vectors, where the machine can.
    wide: Option<Avx512>,
}

impl KernelPath {
    fn of(isa: Isa) -> Self {
        KernelPath {
            isa,
            wide: Avx512::detect().filter(|_| isa == Isa::Avx512),
        }
    }
}

/// What is known of one light before any pattern.
struct LightPlan {
    beams: Vec<Beam>,
    /// Beams of each frame.
    of_frame: Vec<Range<usize>>,
    /// How tiles and beams meet: `[tile][beam]`.
    meetings: Vec<Meeting>,
    heights: Heights,
    deposit: Deposit,
    /// Vectors of lanes that an active pixel of (frame, column) lights, half-open.
    lit: Vec<(u16, u16)>,
    columns: usize,
    first_frame: usize,
}

/// Frames whose entries are sorted together: more need more cache, fewer more passes over the dose.
const GROUP: usize = 8;

impl Parallel {
    /// The model of a vial, its lights and the voxels where dose is wanted.
    ///
    /// # Errors
    /// [`Error::Config`] when there is nothing to light or nothing that absorbs.
    pub fn new(vial: &dyn Vial, lights: Vec<Light>, grid: VolumeGrid) -> Result<Self> {
        if grid.is_empty() {
            return Err(Error::config(
                "grid",
                format!("shape {:?} [z, y, x]", grid.shape),
                "at least one voxel",
            ));
        }
        let [_, ny, nx] = grid.shape;
        let tiles = Tile::cover(nx, ny);
        let (mut plans, mut patterns) = (Vec::new(), Vec::new());
        let (mut offset, mut first_frame) = (0, 0);
        for light in lights {
            check(&light)?;
            let all =
                vec![(0, light.pixels.rows as u32); light.pixels.frames() * light.pixels.columns];
            let active = light.active.as_deref().unwrap_or(&all);
            let layout = PatternLayout::new(light.pixels.clone(), Quantity::Energy, offset, active);
            plans.push(LightPlan::new(
                vial,
                &light,
                &layout,
                &grid,
                &tiles,
                first_frame,
            ));
            offset += layout.len();
            first_frame += light.pixels.frames();
            patterns.push(layout);
        }
        Ok(Parallel {
            lights: plans,
            patterns,
            outputs: vec![DoseLayout::new("dose", grid, 0)],
            tiles,
            path: KernelPath::of(Isa::in_use()),
            scratch: Mutex::new(Vec::new()),
            updates: OnceLock::new(),
        })
    }

    /// Uses a given instruction set; for tests and benches.
    #[must_use]
    pub fn with_isa(mut self, isa: Isa) -> Self {
        self.path = KernelPath::of(isa);
        self
    }

    /// For each light the rows, per (frame, column), whose light meets a voxel of `wanted` (file order `[z, y, x]`, any
    /// value but 0): the run from the lowest to the highest such row. What lies outside cannot help to print the part.
    ///
    /// # Errors
    /// [`Error::Cancelled`], [`Error::Shape`].
    pub fn useful_rows(&self, wanted: &Volume<u8>, run: &Run) -> Result<Vec<Vec<(u32, u32)>>> {
        let layout = &self.outputs[0];
        if wanted.grid.shape != layout.grid.shape {
            return Err(Error::Shape {
                what: "wanted voxels".into(),
                expected: layout.grid.shape.to_vec(),
                found: wanted.grid.shape.to_vec(),
            });
        }
        let mask: Vec<f32> = layout
            .field_of(wanted)
            .iter()
            .map(|&w| f32::from(w != 0))
            .collect();
        let mut seen = LinearOperator::new_patterns(self)?;
        self.adjoint(&HostField::from_slice(&mask), &mut seen, run)?;
        let useful = |run: &PixelRun| {
            let values = &seen.as_slice()[run.offset..][..run.count as usize];
            let first = values.iter().position(|&v| v > 0.0);
            let last = values.iter().rposition(|&v| v > 0.0);
            first
                .zip(last)
                .map_or((0, 0), |(a, b)| (run.bottom + a as u32, (b - a + 1) as u32))
        };
        Ok(self
            .patterns
            .iter()
            .map(|p| p.runs.iter().map(useful).collect())
            .collect())
    }

    fn row(&self) -> usize {
        self.outputs[0].row / LANES
    }

    /// Blocks of lanes of nearly equal length.
    fn blocks(&self) -> Vec<Block> {
        let row = self.row();
        let count = row.div_ceil(MAX_BLOCK);
        (0..count)
            .map(|i| {
                let (first, end) = (i * row / count, (i + 1) * row / count);
                Block {
                    row,
                    first,
                    count: end - first,
                }
            })
            .collect()
    }

    fn borrow_scratch(&self, len: usize) -> HostField {
        let mut pool = self.scratch.lock().unwrap_or_else(PoisonError::into_inner);
        let found = pool.iter().position(|f| f.len() == len);
        found.map_or_else(|| HostField::zeros(len), |i| pool.swap_remove(i))
    }

    fn return_scratch(&self, field: HostField) {
        self.scratch
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(field);
    }

    /// dose += light of these frames of one light.
    fn add_light(
        &self,
        light: usize,
        frames: Range<usize>,
        x: &[f32],
        dose: &mut [f32],
        run: &Run,
    ) -> Result<()> {
        let plan = &self.lights[light];
        let row = self.outputs[0].row;
        let mut lanes = self.borrow_scratch(plan.lit.len() * row);
        plan.expand(
            &self.patterns[light],
            frames.clone(),
            x,
            lanes.as_mut_slice(),
            row,
        );
        let [_, _, nx] = self.outputs[0].grid.shape;
        let blocks = self.blocks();
        let source = lanes.as_slice();
        tile_rows(dose, row, nx)
            .into_par_iter()
            .zip(self.tiles.par_iter().enumerate())
            .for_each_init(Gatherer::default, |gatherer, (mut rows, (index, tile))| {
                for group in plan.groups(frames.clone()) {
                    if run.is_cancelled() {
                        return;
                    }
                    gatherer.load(self.path, plan, group, index, tile);
                    for block in &blocks {
                        gatherer.add_block(self.path, plan, *block, source, &mut rows);
                    }
                }
            });
        self.return_scratch(lanes);
        if run.is_cancelled() {
            Err(Error::Cancelled)
        } else {
            Ok(())
        }
    }

    /// grad = Aᵀ c for one light.
    fn adjoint_light(
        &self,
        light: usize,
        cotangent: &[f32],
        grad: &mut [f32],
        run: &Run,
    ) -> Result<()> {
        let plan = &self.lights[light];
        let row = self.outputs[0].row;
        let mut lanes = self.borrow_scratch(plan.lit.len() * row);
        let frames = plan.of_frame.len();
        // Few long chunks read the dose less often; the result does not depend on their length
        let chunk = frames.div_ceil(4 * rayon::current_num_threads()).max(1);
        let blocks = self.blocks();
        let nx = self.outputs[0].grid.shape[2];
        lanes
            .as_mut_slice()
            .par_chunks_mut(chunk * plan.columns * row)
            .enumerate()
            .for_each_init(TileEntries::default, |entries, (i, lanes)| {
                lanes.fill(0.0);
                let first = i * chunk;
                for (index, tile) in self.tiles.iter().enumerate() {
                    for frame in first..(first + chunk).min(frames) {
                        if run.is_cancelled() {
                            return;
                        }
                        let own = &mut lanes[(frame - first) * plan.columns * row..]
                            [..plan.columns * row];
                        plan.collect_tile(
                            self.path,
                            frame,
                            (index, tile, nx),
                            &blocks,
                            cotangent,
                            own,
                            entries,
                        );
                    }
                }
            });
        plan.collect(&self.patterns[light], lanes.as_slice(), grad, row);
        self.return_scratch(lanes);
        if run.is_cancelled() {
            Err(Error::Cancelled)
        } else {
            Ok(())
        }
    }
}

fn check(light: &Light) -> Result<()> {
    if light.pixels.is_empty() {
        return Err(Error::config(
            "light",
            format!("{:?} frames, rows, columns", light.pixels.shape()),
            "at least one pixel",
        ));
    }
    let resin = &light.resin;
    if !resin.pure_radon && !(resin.absorption_per_mm > 0.0 && resin.absorption_per_mm.is_finite())
    {
        return Err(Error::config(
            "resin.absorption_per_mm",
            format!("found {}", resin.absorption_per_mm),
            "a finite number > 0 (or `pure_radon = true`)",
        ));
    }
    Ok(())
}

impl LightPlan {
    fn new(
        vial: &dyn Vial,
        light: &Light,
        layout: &PatternLayout,
        grid: &VolumeGrid,
        tiles: &[Tile],
        first_frame: usize,
    ) -> Self {
        let tracer = Tracer::new(
            vial,
            light.resin,
            light.surrounding_index,
            light.polarisation,
        );
        let resin = light.resin;
        let deposit = Deposit {
            attenuation: resin.attenuation_per_mm,
            active_share: resin.absorption_per_mm / resin.attenuation_per_mm,
            pure_radon: resin.pure_radon,
        };
        let beams = strips::beams(
            &tracer,
            vial.is_round(),
            &light.pixels,
            light.sub_angles.max(1),
            grid,
            &deposit,
        );
        let frames = light.pixels.frames();
        let mut of_frame = vec![0..0; frames];
        for (i, beam) in beams.iter().enumerate() {
            let range = &mut of_frame[beam.frame as usize];
            *range = if range.start == range.end {
                i..i + 1
            } else {
                range.start..i + 1
            };
        }
        let meetings = tiles
            .par_iter()
            .flat_map_iter(|tile| beams.iter().map(|beam| tiles::meeting(beam, tile)))
            .collect();
        let heights = Heights::new(&light.pixels, grid, KernelPath::of(Isa::in_use()).wide);
        let lit = layout
            .runs
            .iter()
            .map(|&run| {
                let (first, end) = heights.lanes_of(run);
                ((first / LANES) as u16, end.div_ceil(LANES) as u16)
            })
            .collect();
        LightPlan {
            beams,
            of_frame,
            meetings,
            heights,
            deposit,
            lit,
            columns: light.pixels.columns,
            first_frame,
        }
    }

    /// Frames in groups.
    fn groups(&self, frames: Range<usize>) -> impl Iterator<Item = Range<usize>> + use<> {
        let end = frames.end;
        frames
            .step_by(GROUP)
            .map(move |first| first..(first + GROUP).min(end))
    }

    fn is_lit(&self, slot: usize) -> bool {
        self.lit[slot].1 > self.lit[slot].0
    }

    fn is_lit_in(&self, slot: usize, block: Block) -> bool {
        let (first, end) = self.lit[slot];
        (first as usize) < block.first + block.count && (end as usize) > block.first
    }

    /// Rows of pixels → lanes, of some frames.
    fn expand(
        &self,
        layout: &PatternLayout,
        frames: Range<usize>,
        x: &[f32],
        lanes: &mut [f32],
        row: usize,
    ) {
        let per_frame = self.columns * row;
        lanes[frames.start * per_frame..frames.end * per_frame]
            .par_chunks_mut(per_frame)
            .zip(
                layout.runs[frames.start * self.columns..frames.end * self.columns]
                    .par_chunks(self.columns),
            )
            .for_each_init(
                || vec![0.0; self.heights.buffer()],
                |buffer, (lanes, runs)| {
                    for (lanes, run) in lanes.chunks_mut(row).zip(runs) {
                        if run.count > 0 {
                            let values = &x[run.offset..][..run.count as usize];
                            self.heights.expand(values, *run, lanes, buffer);
                        } else {
                            lanes.fill(0.0);
                        }
                    }
                },
            );
    }

    /// Lanes → rows of pixels, of all frames. `grad` is the whole field.
    fn collect(&self, layout: &PatternLayout, lanes: &[f32], grad: &mut [f32], row: usize) {
        let mut pieces = Vec::with_capacity(self.of_frame.len());
        let mut rest = &mut grad[layout.range()];
        for runs in layout.runs.chunks(self.columns) {
            let len = runs.iter().map(|r| r.count as usize).sum();
            let (piece, tail) = rest.split_at_mut(len);
            pieces.push(piece);
            rest = tail;
        }
        pieces
            .into_par_iter()
            .zip(lanes.par_chunks(self.columns * row))
            .zip(layout.runs.par_chunks(self.columns))
            .for_each_init(
                || {
                    [
                        vec![0.0; self.heights.buffer()],
                        vec![0.0; self.heights.buffer()],
                    ]
                },
                |[buffer, rows], ((mut piece, lanes), runs)| {
                    for (lanes, run) in lanes.chunks(row).zip(runs) {
                        let (values, tail) = piece.split_at_mut(run.count as usize);
                        if run.count > 0 {
                            self.heights.collect(lanes, *run, values, buffer, rows);
                        }
                        piece = tail;
                    }
                },
            );
    }

    /// Adds to the lanes of one frame what the cotangent of one tile gives.
    fn collect_tile(
        &self,
        path: KernelPath,
        frame: usize,
        (index, tile, nx): (usize, &Tile, usize),
        blocks: &[Block],
        cotangent: &[f32],
        lanes: &mut [f32],
        found: &mut TileEntries,
    ) {
        found.clear();
        let place = (tile, Slots::within_plane(tile, nx));
        for i in self.of_frame[frame].clone() {
            self.enumerate(
                path,
                i,
                self.meetings[index * self.beams.len() + i],
                place,
                found,
            );
        }
        let first_slot = frame * self.columns;
        for &block in blocks {
            for run in &found.runs {
                if self.is_lit_in(first_slot + run.column as usize, block) {
                    let from = (run.column as usize * block.row + block.first) * LANES;
                    let out = &mut lanes[from..from + block.count * LANES];
                    accumulate(path.isa, out, cotangent, found.of(run), block);
                }
            }
        }
    }

    /// Everything that a beam lights in a tile.
    fn enumerate(
        &self,
        path: KernelPath,
        beam: usize,
        meeting: Meeting,
        (tile, slots): (&Tile, Slots),
        found: &mut TileEntries,
    ) {
        let beam = &self.beams[beam];
        let (first, end) = (meeting.first as usize, meeting.end as usize);
        let keep = |column| self.is_lit(beam.frame as usize * self.columns + column as usize);
        let local = Local::new(tile, beam.major, slots);
        if let Some(wide) = path.wide.filter(|_| meeting.chain) {
            return wide.add_chain(&Chain::new(beam, first, end), &local, keep, found);
        }
        found.add(&beam.strips[first..end], &local, &self.deposit, keep);
    }
}

/// The dose, cut into tiles: for each tile its rows of voxels.
fn tile_rows(dose: &mut [f32], row: usize, nx: usize) -> Vec<Vec<&mut [f32]>> {
    let across = nx.div_ceil(TILE);
    let mut tiles: Vec<Vec<&mut [f32]>> = Vec::new();
    for (y, line) in dose.chunks_mut(nx * row).enumerate() {
        if y % TILE == 0 {
            tiles.extend((0..across).map(|_| Vec::with_capacity(TILE)));
        }
        let first = (y / TILE) * across;
        for (tile, piece) in tiles[first..].iter_mut().zip(line.chunks_mut(TILE * row)) {
            tile.push(piece);
        }
    }
    tiles
}

/// What a group of frames brings to a tile: chains as taps, all else as entries sorted by voxel.
#[derive(Default)]
struct Gatherer {
    chains: Vec<Taps>,
    /// How many of `chains` are in use.
    chain_count: usize,
    loose: Sorter,
}

impl Gatherer {
    /// Enumerates what a group of frames lights in a tile.
    fn load(
        &mut self,
        path: KernelPath,
        plan: &LightPlan,
        frames: Range<usize>,
        index: usize,
        tile: &Tile,
    ) {
        self.chain_count = 0;
        self.loose.found.clear();
        for frame in frames {
            for i in plan.of_frame[frame].clone() {
                let meeting = plan.meetings[index * plan.beams.len() + i];
                if let Some(wide) = path.wide.filter(|_| meeting.chain) {
                    self.load_chain(wide, plan, i, meeting, tile);
                } else if meeting.end > meeting.first {
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
        beam: usize,
        meeting: Meeting,
        tile: &Tile,
    ) {
        if self.chains.len() == self.chain_count {
            self.chains.push(Taps::default());
        }
        let taps = &mut self.chains[self.chain_count];
        self.chain_count += 1;
        let beam = &plan.beams[beam];
        let chain = Chain::new(beam, meeting.first as usize, meeting.end as usize);
        let local = Local::new(tile, beam.major, Slots::WITHIN_TILE);
        wide.find_taps(
            taps,
            &chain,
            &local,
            beam.major == Major::X,
            beam.frame * plan.columns as u32,
        );
    }

    /// Adds one block of lanes to the voxels of a tile.
    fn add_block(
        &mut self,
        path: KernelPath,
        plan: &LightPlan,
        block: Block,
        source: &[f32],
        rows: &mut [&mut [f32]],
    ) {
        if let Some(wide) = path.wide {
            let used = self.chains[..self.chain_count].iter();
            let lit: Vec<&Taps> = used
                .filter(|taps| taps.slots().any(|slot| plan.is_lit_in(slot, block)))
                .collect();
            if !lit.is_empty() {
                wide.gather_tile(rows, source, &lit, block);
            }
        }
        self.loose.add_block(path, plan, block, source, rows);
    }
}

/// Entries of a group of frames, sorted by voxel.
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
    kept_slots: Vec<u32>,
    kept_weights: Vec<f32>,
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
        plan.enumerate(
            path,
            beam,
            meeting,
            (tile, Slots::WITHIN_TILE),
            &mut self.found,
        );
        let first = plan.beams[beam].frame * plan.columns as u32;
        for run in &mut self.found.runs[before..] {
            run.column += first;
        }
    }

    /// Counting sort; within a voxel the order of frames and columns is kept, so sums are reproducible.
    fn sort(&mut self) {
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
        plan: &LightPlan,
        block: Block,
        source: &[f32],
        rows: &mut [&mut [f32]],
    ) {
        let slots = self.found.runs.iter().map(|run| run.column as usize);
        let dark = slots.filter(|&slot| !plan.is_lit_in(slot, block)).count();
        if dark == self.found.runs.len() {
            return;
        }
        for (y, line) in rows.iter_mut().enumerate() {
            for (x, voxel) in line.chunks_exact_mut(block.row * LANES).enumerate() {
                let v = y * TILE + x;
                let own = self.starts[v] as usize..self.starts[v + 1] as usize;
                let mut entries = Entries {
                    slots: &self.slots[own.clone()],
                    weights: &self.weights[own],
                };
                if dark > 0 {
                    self.kept_slots.clear();
                    self.kept_weights.clear();
                    for (&slot, &weight) in entries.slots.iter().zip(entries.weights) {
                        if plan.is_lit_in(slot as usize, block) {
                            self.kept_slots.push(slot);
                            self.kept_weights.push(weight);
                        }
                    }
                    entries = Entries {
                        slots: &self.kept_slots,
                        weights: &self.kept_weights,
                    };
                }
                if !entries.slots.is_empty() {
                    let out = &mut voxel[block.first * LANES..][..block.count * LANES];
                    accumulate(path.isa, out, source, entries, block);
                }
            }
        }
    }
}

impl LinearOperator for Parallel {
    type Field = HostField;

    fn patterns(&self) -> &[PatternLayout] {
        &self.patterns
    }

    fn outputs(&self) -> &[DoseLayout] {
        &self.outputs
    }

    fn new_patterns(&self) -> Result<HostField> {
        Ok(HostField::zeros(
            self.patterns.iter().map(PatternLayout::len).sum(),
        ))
    }

    fn new_dose(&self) -> Result<HostField> {
        Ok(HostField::zeros(self.outputs[0].len()))
    }

    fn add_forward(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        for (light, plan) in self.lights.iter().enumerate() {
            let count = plan.of_frame.len();
            let local = |f: usize| f.saturating_sub(plan.first_frame).min(count);
            let own = local(frames.start)..local(frames.end);
            if !own.is_empty() {
                self.add_light(light, own, x.as_slice(), dose.as_mut_slice(), run)?;
            }
        }
        Ok(())
    }

    fn adjoint(&self, cotangent: &HostField, grad: &mut HostField, run: &Run) -> Result<()> {
        for light in 0..self.lights.len() {
            self.adjoint_light(light, cotangent.as_slice(), grad.as_mut_slice(), run)?;
        }
        Ok(())
    }

    fn frames(&self) -> usize {
        self.lights.iter().map(|plan| plan.of_frame.len()).sum()
    }

    fn z_coupling(&self) -> ZCoupling {
        ZCoupling::None
    }

    fn updates(&self) -> u64 {
        *self.updates.get_or_init(|| self.count_updates())
    }

    fn describe(&self) -> String {
        format!(
            "parallel (distance-driven kernel, {} path)",
            self.path.isa.name()
        )
    }
}

impl Parallel {
    /// Pairs of voxel and frame (and sub-angle) of which at least one active pixel lights the voxel.
    fn count_updates(&self) -> u64 {
        let nz = self.outputs[0].grid.shape[0];
        self.lights
            .iter()
            .map(|plan| {
                let tiles = self.tiles.par_iter().enumerate();
                tiles
                    .map_init(TileEntries::default, |entries, (index, tile)| {
                        (0..plan.of_frame.len())
                            .map(|frame| plan.updates_in(frame, index, tile, nz, entries))
                            .sum::<u64>()
                    })
                    .sum::<u64>()
            })
            .sum()
    }
}

impl LightPlan {
    fn updates_in(
        &self,
        frame: usize,
        index: usize,
        tile: &Tile,
        nz: usize,
        entries: &mut TileEntries,
    ) -> u64 {
        let mut total = 0;
        for i in self.of_frame[frame].clone() {
            entries.clear();
            let meeting = self.meetings[index * self.beams.len() + i];
            self.enumerate(
                KernelPath::of(Isa::in_use()),
                i,
                meeting,
                (tile, Slots::WITHIN_TILE),
                entries,
            );
            let mut lanes = [(u16::MAX, 0u16); TILE * TILE];
            for run in &entries.runs {
                let lit = self.lit[frame * self.columns + run.column as usize];
                for &voxel in entries.of(run).slots {
                    let seen = &mut lanes[voxel as usize];
                    *seen = (seen.0.min(lit.0), seen.1.max(lit.1));
                }
            }
            total += lanes
                .iter()
                .filter(|l| l.1 > l.0)
                .map(|l| (l.1 as usize * LANES).min(nz) as u64 - (l.0 as usize * LANES) as u64)
                .sum::<u64>();
        }
        total
    }
}

#[cfg(test)]
mod tests;
