//! What is known of one light before any pattern: its beams, where they meet the tiles, which lanes are lit.

use super::chains::{Avx512, Chain};
use super::is_straight;
use super::kernel::Isa;
use super::mapped::Mapped;
use super::radon::{self, Kernel};
use super::strips::{self, Beam};
use super::tiles::{self, Deposit, Local, Meeting, Spans, TILE, Tile, TileEntries};
use super::turned::Turned;
use super::uniform_strips::UniformStrips;
use super::views::{SeenViews, Views};
use super::walls::Walls;
use super::z_overlap::{Intervals, Levels, ZOverlaps};
use crate::{PatternLayout, Work};
use std::ops::Range;
use tomolith_core::field::LANES;
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

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
    /// Of the views of the first part of the turn.
    pub(super) beams: Vec<Beam>,
    pub(super) views: Views,
    pub(super) turned: Turned,
    pub(super) of_view: Vec<Range<usize>>,
    /// Of each frame.
    sub_angles: u64,
    /// Beams of uniform strips, for a single slice.
    pub(super) uniform_strips: Vec<Option<UniformStrips>>,
    /// How tiles and beams meet: `[tile][beam]`.
    pub(super) meetings: Vec<Meeting>,
    pub(super) levels: Levels,
    pub(super) deposit: Deposit,
    pub(super) walls: Walls,
    pub(super) kernel: Kernel,
    mapped: Option<Mapped>,
    /// Vectors of lanes that an active pixel of (view, column) lights, half-open.
    pub(super) lit: Vec<(u16, u16)>,
    /// Vectors of slices that one of (frame, column) lights.
    lit_by_frame: Vec<(u16, u16)>,
    pub(super) columns: usize,
}

/// The beams of a light, as the kernel wants them.
fn beams(
    vial: &dyn Vial,
    light: &Light,
    kernel: Kernel,
    pixels: &PatternGrid,
    grid: &VolumeGrid,
    deposit: &Deposit,
) -> Vec<Beam> {
    let sub_angles = light.sub_angles.max(1);
    if kernel == Kernel::DistanceDriven {
        let tracer = light.tracer(vial);
        strips::beams(&tracer, vial.is_round(), pixels, sub_angles, grid, deposit)
    } else {
        let radius = vial.resin_wall().inscribed_radius();
        radon::beams(kernel, radius, pixels, sub_angles, grid)
    }
}

fn of_views(beams: &[Beam], count: usize) -> Vec<Range<usize>> {
    let mut of_view = vec![0..0; count];
    for (i, beam) in beams.iter().enumerate() {
        let range = &mut of_view[beam.frame as usize];
        *range = if range.start == range.end {
            i..i + 1
        } else {
            range.start..i + 1
        };
    }
    of_view
}

/// Vectors of lanes that each (view, column) lights, of those that each (frame, column) lights.
fn lit(views: &Views, columns: usize, by_frame: &[(u16, u16)]) -> Vec<(u16, u16)> {
    let of_slot = |slot| {
        let of_side = |side| by_frame[views.pixel_column(slot, side)];
        let lit = views.sides().map(of_side).filter(|lit| lit.1 > lit.0);
        lit.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
            .unwrap_or_default()
    };
    (0..views.count() * columns).map(of_slot).collect()
}

impl LightPlan {
    /// For a light with a kernel, whose views repeat so.
    pub(super) fn new(
        vial: &dyn Vial,
        light: &Light,
        kernel: Kernel,
        turned: Turned,
        grid: &VolumeGrid,
        tiles: &[Tile],
        work: &Work,
    ) -> Self {
        let resin = light.resin;
        let deposit = Deposit {
            attenuation: resin.attenuation_per_mm,
            active_share: resin.absorption_per_mm / resin.attenuation_per_mm,
            pure_radon: resin.pure_radon,
        };
        let views = Views::of(vial, light);
        let pixels = views.pixels(&light.pixels);
        let mut found_from = pixels.clone();
        found_from.azimuths.truncate(turned.period);
        let beams = beams(vial, light, kernel, &found_from, grid, &deposit);
        let walls = Walls::new(vial, grid);
        let mapped = light
            .map
            .as_ref()
            .map(|map| Mapped::new(map, resin, grid, &walls, &beams));
        let is_even = mapped.is_none();
        let may_be_uniform = grid.shape[0] == 1
            && is_even
            && kernel == Kernel::DistanceDriven
            && is_straight(vial, light);
        let uniform_strips: Vec<Option<UniformStrips>> = beams.iter().par_map(|beam| {
            let strips = || UniformStrips::new(beam, &pixels, grid, &deposit);
            may_be_uniform.then(strips).flatten()
        });
        let bounds: Vec<Vec<Spans>> = beams.iter().par_map(Spans::of_beam);
        let meeting =
            |tile, ((beam, uniform), bounds): ((&Beam, &Option<UniformStrips>), &Vec<Spans>)| {
                let meeting = tiles::meeting(beam, bounds, uniform.as_ref(), &walls, tile);
                Meeting {
                    chain: meeting.chain && is_even,
                    ..meeting
                }
            };
        let steps = work.steps(tiles.len());
        let of_tile = |tile| -> Vec<Meeting> {
            steps.add(1);
            let beams = beams.iter().zip(&uniform_strips).zip(&bounds);
            let until_canceled = beams.take_while(|_| !steps.is_canceled());
            until_canceled.map(|beam| meeting(tile, beam)).collect()
        };
        let meetings = tiles.iter().par_map(of_tile).concat();
        let path = KernelPath::of(Isa::in_use());
        let (rows, slices) = (Intervals::of_rows(&pixels), Intervals::of_slices(grid));
        let overlaps = ZOverlaps::new(&rows, &slices, path);
        let levels = Levels::new(&rows, &slices, &overlaps, path);
        let lit_by = |overlaps: &ZOverlaps| -> Vec<(u16, u16)> {
            let vectors = |&work| {
                let (first, end) = overlaps.lanes_of(work);
                ((first / LANES) as u16, end.div_ceil(LANES) as u16)
            };
            light.layout(0).runs.iter().map(vectors).collect()
        };
        let lit = lit(&views, pixels.columns, &lit_by(&levels.overlaps));
        LightPlan {
            of_view: of_views(&beams, views.count()),
            sub_angles: light.sub_angles.max(1) as u64,
            beams,
            turned,
            views,
            uniform_strips,
            meetings,
            levels,
            deposit,
            walls,
            kernel,
            mapped,
            lit,
            lit_by_frame: lit_by(&overlaps),
            columns: light.pixels.columns,
        }
    }

    /// How a tile and a beam meet.
    pub(super) fn meeting(&self, tile: usize, beam: usize) -> Meeting {
        self.meetings[tile * self.beams.len() + beam]
    }

    pub(super) fn is_lit(&self, slot: usize) -> bool {
        self.lit[slot].1 > self.lit[slot].0
    }

    /// Pixels of a slice, of some views, by slot.
    pub(super) fn expand(
        &self,
        layout: &PatternLayout,
        SeenViews { views, sides }: &SeenViews,
        x: &[f32],
        slots: &mut [f32],
    ) {
        let of_views = slots.chunks_mut(self.columns).enumerate();
        of_views.skip(views.start).take(views.len()).par_each_with(
            || vec![0.0; self.levels.overlaps.buffer()],
            |buffer, (view, pixels)| {
                pixels.fill(0.0);
                for (column, pixel) in pixels.chunks_mut(1).enumerate() {
                    let slot = view * self.columns + column;
                    self.add_expanded(layout, slot, sides.clone(), x, pixel, buffer);
                }
            },
        );
    }

    /// Adds to the lanes of a slot its rows of pixels, as seen from some sides.
    pub(super) fn add_expanded(
        &self,
        layout: &PatternLayout,
        slot: usize,
        sides: Range<usize>,
        x: &[f32],
        lanes: &mut [f32],
        buffer: &mut [f32],
    ) {
        for side in sides {
            let run = layout.runs[self.views.pixel_column(slot, side)];
            let values = &x[run.offset..][..run.count as usize];
            // Late in a run most pixels are dark
            if values.iter().any(|value| *value != 0.0) {
                self.levels
                    .overlaps
                    .add_expanded(values, run, lanes, buffer);
            }
        }
    }

    /// Lanes of slots → rows of pixels, of some frames. `grad` is that of all.
    pub(super) fn collect<'a>(
        &self,
        layout: &PatternLayout,
        frames: Range<usize>,
        lanes_of: impl Fn(usize) -> &'a [f32] + Sync,
        grad: &mut [f32],
    ) {
        let elements = &mut grad[layout.elements_of(frames.clone())];
        let of_frames = &layout.runs[frames.start * self.columns..frames.end * self.columns];
        layout
            .split_frames(frames, elements)
            .into_iter()
            .zip(of_frames.chunks(self.columns))
            .par_each_with(
                || {
                    [
                        vec![0.0; self.levels.overlaps.buffer()],
                        vec![0.0; self.levels.overlaps.buffer()],
                    ]
                },
                |[buffer, rows], ((frame, mut piece), runs)| {
                    for (column, run) in runs.iter().enumerate() {
                        let (values, tail) = piece.split_at_mut(run.count as usize);
                        if run.count > 0 {
                            let lanes = lanes_of(self.views.slot(frame, column));
                            self.levels
                                .overlaps
                                .collect(lanes, *run, values, buffer, rows);
                        }
                        piece = tail;
                    }
                },
            );
    }

    /// Everything that a beam lights in a tile.
    pub(super) fn enumerate(
        &self,
        path: KernelPath,
        beam: usize,
        meeting: Meeting,
        local: &Local,
        found: &mut TileEntries,
    ) {
        let first = self.beams[beam].frame as usize * self.columns;
        let keep = |column| self.is_lit(first + column as usize);
        self.enumerate_columns(path, beam, meeting, local, keep, found);
    }

    /// What the columns of a beam that `keep` wants light in a tile.
    pub(super) fn enumerate_columns(
        &self,
        path: KernelPath,
        beam: usize,
        meeting: Meeting,
        local: &Local,
        keep: impl Fn(u32) -> bool,
        found: &mut TileEntries,
    ) {
        let index = beam;
        let beam = &self.beams[index];
        let (first, end) = (meeting.first as usize, meeting.end as usize);
        if let Some(wide) = path.wide.filter(|_| meeting.chain) {
            return wide.add_chain(&Chain::new(beam, first, end), local, keep, found);
        }
        if let Some(mapped) = &self.mapped {
            return mapped.enumerate(index, beam, first..end, local, keep, found);
        }
        let strips = &beam.strips[first..end];
        match self.kernel {
            Kernel::DistanceDriven => {
                let resin_rows = self.walls.resin_rows(local, beam.major);
                found.add(strips, local, &resin_rows, &self.deposit, keep);
            }
            kernel => found.add_radon(kernel, strips, local, keep),
        }
    }

    /// Whether a column of a view of the first part lights anything in any part of the turn.
    pub(super) fn is_lit_in_any_part(&self, view: usize, column: u32) -> bool {
        let first = view * self.columns + column as usize;
        let mut slots = (first..self.lit.len()).step_by(self.turned.period * self.columns);
        slots.any(|slot| self.is_lit(slot))
    }

    /// Pairs of frame and voxel, for the frames of a view of the first part of the turn and of those that repeat it, of which an active pixel
    /// lights the voxel at any angle, times the angles: voxels of a tile, and those that it is turned to.
    pub(super) fn updates_in(
        &self,
        view: usize,
        index: usize,
        tile: &Tile,
        nz: usize,
        entries: &mut TileEntries,
    ) -> u64 {
        entries.clear();
        let path = KernelPath::of(Isa::in_use());
        for i in self.of_view[view].clone() {
            let meeting = self.meeting(index, i);
            let local = Local::new(tile, self.beams[i].major);
            let keep = |column| self.is_lit_in_any_part(view, column);
            self.enumerate_columns(path, i, meeting, &local, keep, entries);
        }
        let of_runs = entries.runs.iter().flat_map(|run| {
            let voxels = entries.of(run).slots.iter();
            voxels.map(|&voxel| (run.column, voxel as usize))
        });
        self.pairs::<{ TILE * TILE }>(view, nz, of_runs)
    }

    /// Pairs of columns and voxels that they light: of `N` voxels, each as often as it comes.
    pub(super) fn pairs<const N: usize>(
        &self,
        view: usize,
        nz: usize,
        lit: impl Iterator<Item = (u32, usize)> + Clone,
    ) -> u64 {
        let of_frame = |frame| {
            let mut lanes = [(u16::MAX, 0u16); N];
            for (column, voxel) in lit.clone() {
                let lit = self.lit_in(frame, column);
                if lit.1 > lit.0 {
                    let seen = &mut lanes[voxel];
                    *seen = (seen.0.min(lit.0), seen.1.max(lit.1));
                }
            }
            let lit = lanes.into_iter().filter(|lit| lit.1 > lit.0);
            lit.map(|lit| slices(lit, nz)).sum::<u64>()
        };
        self.sub_angles * self.frames_of(view).map(of_frame).sum::<u64>()
    }

    /// Pairs of a patch, from columns and a bit for each voxel that they light.
    pub(super) fn pairs_of_patch(&self, view: usize, nz: usize, lit: &[(u32, u8)]) -> u64 {
        let of_frame = |frame| {
            let mut seen = (0, 0);
            let mut voxels = 0u8;
            for &(column, bits) in lit {
                let lit = self.lit_in(frame, column);
                if lit.1 > lit.0 {
                    if voxels != 0 && lit != seen {
                        // Columns whose pixels end at different heights
                        return None;
                    }
                    (seen, voxels) = (lit, voxels | bits);
                }
            }
            Some(u64::from(voxels.count_ones()) * slices(seen, nz))
        };
        let total: Option<u64> = self.frames_of(view).map(of_frame).sum();
        total.map_or_else(
            || {
                let each = lit.iter().flat_map(|&(column, bits)| {
                    let is_lit = move |voxel: &usize| bits >> voxel & 1 == 1;
                    (0..8).filter(is_lit).map(move |voxel| (column, voxel))
                });
                self.pairs::<8>(view, nz, each)
            },
            |total| self.sub_angles * total,
        )
    }

    /// The frames that a view of the first part stands for: the pixel column of their first one, and whether columns are seen in reverse.
    fn frames_of(&self, view: usize) -> impl Iterator<Item = (usize, bool)> {
        let slot = move |part| (part * self.turned.period + view) * self.columns;
        let parts = 0..self.turned.parts;
        parts.flat_map(move |part| {
            let sides = self.views.sides();
            sides.map(move |side| (self.views.pixel_column(slot(part), side), side > 0))
        })
    }

    /// Vectors of slices that a column of such a frame lights.
    fn lit_in(&self, (first, in_reverse): (usize, bool), column: u32) -> (u16, u16) {
        let column = column as usize;
        self.lit_by_frame[if in_reverse {
            first - column
        } else {
            first + column
        }]
    }
}

/// Slices of so many in a range of vectors.
fn slices(lit: (u16, u16), nz: usize) -> u64 {
    (lit.1 as usize * LANES).min(nz) as u64 - (lit.0 as usize * LANES) as u64
}
