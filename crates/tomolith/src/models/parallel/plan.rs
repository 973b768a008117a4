//! What is known of one light before any pattern: its beams, where they meet the tiles, which lanes are lit.

use super::chains::{Avx512, Chain};
use super::comb::Comb;
use super::heights::Heights;
use super::kernel::{Block, Isa, accumulate};
use super::mapped::Mapped;
use super::radon::{self, Kernel};
use super::strips::{self, Beam};
use super::tiles::{self, Deposit, Local, Meeting, Slots, TILE, Tile, TileEntries};
use super::{GROUP, Light, is_straight};
use crate::field::LANES;
use crate::grid::VolumeGrid;
use crate::models::PatternLayout;
use crate::optics::trace::Tracer;
use crate::optics::vial::Vial;
use rayon::prelude::*;
use std::ops::Range;

/// Which kernels run.
#[derive(Clone, Copy, Debug)]
pub(super) struct KernelPath {
    pub(super) isa: Isa,
    /// Chains as vectors, where the machine can.
    pub(super) wide: Option<Avx512>,
}

impl KernelPath {
    pub(super) fn of(isa: Isa) -> Self {
        KernelPath {
            isa,
            wide: Avx512::detect().filter(|_| isa == Isa::Avx512),
        }
    }
}

/// What is known of one light before any pattern.
pub(super) struct LightPlan {
    pub(super) beams: Vec<Beam>,
    /// Beams of each frame.
    pub(super) of_frame: Vec<Range<usize>>,
    /// Beams that are combs, for a single slice.
    pub(super) combs: Vec<Option<Comb>>,
    /// How tiles and beams meet: `[tile][beam]`.
    pub(super) meetings: Vec<Meeting>,
    heights: Heights,
    deposit: Deposit,
    pub(super) kernel: Kernel,
    mapped: Option<Mapped>,
    /// Vectors of lanes that an active pixel of (frame, column) lights, half-open.
    pub(super) lit: Vec<(u16, u16)>,
    pub(super) columns: usize,
    pub(super) first_frame: usize,
}

impl LightPlan {
    pub(super) fn new(
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
        )
        .in_bath(light.bath);
        let resin = light.resin;
        let deposit = Deposit {
            attenuation: resin.attenuation_per_mm,
            active_share: resin.absorption_per_mm / resin.attenuation_per_mm,
            pure_radon: resin.pure_radon,
        };
        let sub_angles = light.sub_angles.max(1);
        let beams = if light.kernel == Kernel::DistanceDriven {
            strips::beams(
                &tracer,
                vial.is_round(),
                &light.pixels,
                sub_angles,
                grid,
                &deposit,
            )
        } else {
            let radius = vial.resin_wall().inscribed_radius();
            radon::beams(light.kernel, radius, &light.pixels, sub_angles, grid)
        };
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
        let mapped = light
            .map
            .as_ref()
            .map(|map| Mapped::new(map, resin, grid, &beams));
        let is_even = mapped.is_none();
        let is_comb = grid.shape[0] == 1
            && is_even
            && light.kernel == Kernel::DistanceDriven
            && is_straight(vial, light);
        let combs: Vec<Option<Comb>> = beams
            .par_iter()
            .map(|beam| {
                let comb = || Comb::new(beam, &light.pixels, grid, &deposit);
                is_comb.then(comb).flatten()
            })
            .collect();
        let meeting = |tile, (beam, comb): (&Beam, &Option<Comb>)| {
            let meeting = tiles::meeting(beam, comb.as_ref(), tile);
            Meeting {
                chain: meeting.chain && is_even,
                ..meeting
            }
        };
        let meetings = tiles
            .par_iter()
            .flat_map_iter(|tile| {
                beams
                    .iter()
                    .zip(&combs)
                    .map(move |pair| meeting(tile, pair))
            })
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
            combs,
            meetings,
            heights,
            deposit,
            kernel: light.kernel,
            mapped,
            lit,
            columns: light.pixels.columns,
            first_frame,
        }
    }

    /// Frames in groups.
    pub(super) fn groups(
        &self,
        frames: Range<usize>,
    ) -> impl Iterator<Item = Range<usize>> + use<> {
        let end = frames.end;
        frames
            .step_by(GROUP)
            .map(move |first| first..(first + GROUP).min(end))
    }

    fn is_lit(&self, slot: usize) -> bool {
        self.lit[slot].1 > self.lit[slot].0
    }

    pub(super) fn is_lit_in(&self, slot: usize, block: Block) -> bool {
        let (first, end) = self.lit[slot];
        (first as usize) < block.first + block.count && (end as usize) > block.first
    }

    /// Rows of pixels → lanes, of some frames.
    pub(super) fn expand(
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
    pub(super) fn collect(
        &self,
        layout: &PatternLayout,
        lanes: &[f32],
        grad: &mut [f32],
        row: usize,
    ) {
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

    /// Adds to the lanes of a group of frames what the cotangent of one tile gives.
    pub(super) fn collect_tile(
        &self,
        path: KernelPath,
        frames: Range<usize>,
        (index, tile, nx): (usize, &Tile, usize),
        blocks: &[Block],
        (cotangent, lanes): (&[f32], &mut [f32]),
        found: &mut TileEntries,
    ) {
        found.clear();
        let place = (tile, Slots::within_plane(tile, nx));
        for frame in frames.clone() {
            let before = found.runs.len();
            for i in self.of_frame[frame].clone() {
                let meeting = self.meetings[index * self.beams.len() + i];
                self.enumerate(path, i, meeting, place, found);
            }
            let columns_before = ((frame - frames.start) * self.columns) as u32;
            for run in &mut found.runs[before..] {
                run.column += columns_before;
            }
        }
        found.sort_by_place();
        let first_slot = frames.start * self.columns;
        for &block in blocks {
            for &i in &found.by_place {
                let run = &found.runs[i as usize];
                if self.is_lit_in(first_slot + run.column as usize, block) {
                    let from = (run.column as usize * block.row + block.first) * LANES;
                    let out = &mut lanes[from..from + block.count * LANES];
                    accumulate(path.isa, out, cotangent, found.of(run), block);
                }
            }
        }
    }

    /// Everything that a beam lights in a tile.
    pub(super) fn enumerate(
        &self,
        path: KernelPath,
        beam: usize,
        meeting: Meeting,
        (tile, slots): (&Tile, Slots),
        found: &mut TileEntries,
    ) {
        let index = beam;
        let beam = &self.beams[index];
        let (first, end) = (meeting.first as usize, meeting.end as usize);
        let keep = |column| self.is_lit(beam.frame as usize * self.columns + column as usize);
        let local = Local::new(tile, beam.major, slots);
        if let Some(wide) = path.wide.filter(|_| meeting.chain) {
            return wide.add_chain(&Chain::new(beam, first, end), &local, keep, found);
        }
        if let Some(mapped) = &self.mapped {
            return mapped.enumerate((index, beam), first..end, &local, keep, found);
        }
        let strips = &beam.strips[first..end];
        match self.kernel {
            Kernel::DistanceDriven => found.add(strips, &local, &self.deposit, keep),
            kernel => found.add_radon(kernel, strips, &local, keep),
        }
    }

    pub(super) fn updates_in(
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
