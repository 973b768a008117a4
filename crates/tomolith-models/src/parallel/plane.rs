//! A single slice: lanes over voxels and strips in place of z.
//!
//! Dose works tile by tile, all frames for one tile; the adjoint frame by frame, all tiles for a few frames. Straight
//! evenly spaced strips are [`uniform_strips`](super::uniform_strips), other chains vectors over
//! strips, and what is left (tiles that a resin wall cuts, the kernels `line`, `linear` and `strip`) single entries of the common enumerator.

use super::chains::{Avx512, Chain, Taps, WINDOW};
use super::loose::Loose;
use super::plan::LightPlan;
use super::strips::{Beam, Major};
use super::tiles::{Local, Meeting, TILE, Tile, TileEntries};
use super::uniform_strips::{Integrals, Square, UniformStrips};
use super::views::SeenViews;
use super::{Parallel, tile_rows};
use crate::Work;
use std::ops::Range;
use tomolith_core::error::Result;
use tomolith_core::parallel::InParallel;

/// What one task of the dose needs.
#[derive(Default)]
struct Bench {
    taps: Taps,
    entries: TileEntries,
}

/// Which of two squares has its lanes across the rows of this axis.
fn square_of(major: Major) -> usize {
    usize::from(major == Major::X)
}

impl LightPlan {
    /// Beams of some views: they lie one after the other.
    fn beams_of(&self, views: Range<usize>) -> Range<usize> {
        let mut lit = self.of_view[views].iter().filter(|beams| !beams.is_empty());
        let first = lit.next();
        let last = lit.next_back().or(first);
        first.zip(last).map_or(0..0, |(a, b)| a.start..b.end)
    }

    fn frame<'v>(&self, values: &'v [f32], beam: usize) -> &'v [f32] {
        let first = self.beams[beam].frame as usize * self.columns;
        &values[first..first + self.columns]
    }
}

impl Parallel {
    /// dose += light of these views of one light, for a single slice.
    pub(super) fn add_light_of_plane(
        &self,
        light: usize,
        seen: &SeenViews,
        x: &[f32],
        dose: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let plan = &self.lights[light];
        let mut pixels = self.scratch.borrow(plan.lit.len());
        let layout = &self.patterns[light];
        plan.expand(layout, seen, x, pixels.as_mut_slice());
        let values = pixels.as_slice();
        let beams = plan.beams_of(seen.views.clone());
        let stride = UniformStrips::stride(plan.columns);
        let mut sources = self.scratch.borrow(beams.len() * stride);
        sources
            .as_mut_slice()
            .chunks_mut(stride)
            .zip(beams.clone())
            .par_each(|(source, beam)| {
                if let Some(uniform) = &plan.uniform_strips[beam] {
                    uniform.fill(plan.frame(values, beam), source);
                }
            });
        let all = sources.as_slice();
        let loose = self.loose(light, work)?;
        let nx = self.output.grid.shape[2];
        tile_rows(&self.tiles, dose, 1, nx)
            .into_iter()
            .zip(self.tiles.iter().enumerate())
            .par_each_with(Bench::default, |bench, (mut rows, (index, tile))| {
                // Dose of the tile: lanes along x, and along y
                let mut along: [Square; 2] = [[0.0; TILE * TILE]; 2];
                for beam in beams.clone() {
                    if work.is_canceled() {
                        return;
                    }
                    let meeting = plan.meeting(index, beam);
                    let square = &mut along[square_of(plan.beams[beam].major)];
                    if let (true, Some(uniform)) =
                        (meeting.uniform_strips, &plan.uniform_strips[beam])
                    {
                        let source = &all[(beam - beams.start) * stride..][..stride];
                        uniform.add_dose(
                            self.path.isa,
                            tile,
                            plan.beams[beam].major,
                            source,
                            square,
                        );
                    } else if let Some(wide) = self.path.wide.filter(|_| meeting.chain) {
                        let values = plan.frame(values, beam);
                        bench.add_chain(wide, &plan.beams[beam], meeting, tile, values, square);
                    } else if meeting.end > meeting.first {
                        let values = plan.frame(values, beam);
                        let square = &mut along[square_of(Major::Y)];
                        let scratch = &mut bench.entries;
                        let found = self.loose_entries(plan, loose, index, beam, scratch);
                        add_loose(found, values, square);
                    }
                }
                for (y, row) in rows.iter_mut().enumerate() {
                    for (x, dose) in row.iter_mut().enumerate() {
                        *dose += along[0][y * TILE + x] + along[1][x * TILE + y];
                    }
                }
            });
        self.scratch.give_back(sources);
        self.scratch.give_back(pixels);
        work.check()
    }

    /// grad = Aᵀ c for these views of one light, for a single slice.
    pub(super) fn adjoint_light_of_plane(
        &self,
        light: usize,
        seen: &SeenViews,
        cotangent: &[f32],
        grad: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let (plan, views) = (&self.lights[light], &seen.views);
        let mut pixels = self.scratch.borrow(plan.lit.len());
        // Few long chunks read the cotangent less often; the result does not depend on their length
        let chunk = views
            .len()
            .div_ceil(4 * rayon::current_num_threads())
            .max(1);
        let loose = self.loose(light, work)?;
        pixels.as_mut_slice()[views.start * plan.columns..views.end * plan.columns]
            .chunks_mut(chunk * plan.columns)
            .enumerate()
            .par_each_with(Gathering::default, |gathering, (i, pixels)| {
                pixels.fill(0.0);
                let first = views.start + i * chunk;
                gathering.begin(plan, first..(first + chunk).min(views.end));
                for tile in 0..self.tiles.len() {
                    if work.is_canceled() {
                        return;
                    }
                    gathering.add_tile(self, plan, loose, tile, cotangent, pixels);
                }
                gathering.end(plan, pixels);
            });
        let frames = plan.views.frames_of(seen);
        let layout = &self.patterns[light];
        let lanes_of = |slot: usize| &pixels.as_slice()[slot..=slot];
        plan.collect(layout, frames, lanes_of, grad);
        self.scratch.give_back(pixels);
        work.check()
    }
}

impl Bench {
    fn add_chain(
        &mut self,
        wide: Avx512,
        beam: &Beam,
        meeting: Meeting,
        tile: &Tile,
        values: &[f32],
        square: &mut Square,
    ) {
        let chain = Chain::new(beam, meeting.first as usize, meeting.end as usize);
        let local = Local::new(tile, beam.major);
        wide.find_taps(&mut self.taps, &chain, &local);
        let mut window = [0.0; WINDOW];
        for (to, column) in window.iter_mut().zip(chain.columns_of_pixels()) {
            *to = values[column];
        }
        wide.add_taps(&self.taps, local.rows, &window, square);
    }
}

/// Entries one by one; `square` has its lanes along x.
fn add_loose(found: &TileEntries, values: &[f32], square: &mut Square) {
    for run in &found.runs {
        let value = values[run.column as usize];
        let of_run = found.of(run);
        for (&voxel, &weight) in of_run.slots.iter().zip(of_run.weights) {
            square[voxel as usize] += weight * value;
        }
    }
}

/// What one task of the adjoint needs: some frames, tile after tile.
#[derive(Default)]
struct Gathering {
    frames: Range<usize>,
    beams: Range<usize>,
    /// Strips of the beams of uniform strips.
    sources: Vec<f32>,
    /// Cotangent of the tile: lanes along x, and along y.
    integrals: [Integrals; 2],
    entries: TileEntries,
}

impl Gathering {
    fn begin(&mut self, plan: &LightPlan, frames: Range<usize>) {
        self.beams = plan.beams_of(frames.clone());
        self.frames = frames;
        self.sources.clear();
        self.sources
            .resize(self.beams.len() * UniformStrips::stride(plan.columns), 0.0);
    }

    /// Reads the cotangent of a tile; false when it is zero.
    fn load(&mut self, tile: &Tile, nx: usize, cotangent: &[f32]) -> bool {
        let [across, down] = &mut self.integrals;
        across.value.fill(0.0);
        down.value.fill(0.0);
        let mut is_lit = false;
        for y in 0..tile.size[1] {
            let first = (tile.start[1] + y) * nx + tile.start[0];
            for (x, &c) in cotangent[first..first + tile.size[0]].iter().enumerate() {
                across.value[y * TILE + x] = c;
                down.value[x * TILE + y] = c;
                is_lit |= c != 0.0;
            }
        }
        across.integrate();
        down.integrate();
        is_lit
    }

    fn add_tile(
        &mut self,
        model: &Parallel,
        plan: &LightPlan,
        loose: Option<&Loose>,
        index: usize,
        cotangent: &[f32],
        pixels: &mut [f32],
    ) {
        let tile = &model.tiles[index];
        if !self.load(tile, model.output.grid.shape[2], cotangent) {
            return;
        }
        let stride = UniformStrips::stride(plan.columns);
        for i in self.beams.clone() {
            let (beam, meeting) = (&plan.beams[i], plan.meeting(index, i));
            let integrals = &self.integrals[square_of(beam.major)];
            if let (true, Some(uniform)) = (meeting.uniform_strips, &plan.uniform_strips[i]) {
                let source = &mut self.sources[(i - self.beams.start) * stride..][..stride];
                uniform.add_adjoint(model.path.isa, tile, beam.major, integrals, source);
                continue;
            }
            if meeting.end == meeting.first {
                continue;
            }
            let first = (beam.frame as usize - self.frames.start) * plan.columns;
            let pixels = &mut pixels[first..first + plan.columns];
            if let Some(wide) = model.path.wide.filter(|_| meeting.chain) {
                let chain = Chain::new(beam, meeting.first as usize, meeting.end as usize);
                let local = Local::new(tile, beam.major);
                let sums = wide.chain_adjoint(&chain, &local, integrals);
                for (column, sum) in chain.columns_of_pixels().zip(sums) {
                    pixels[column] += sum;
                }
            } else {
                let scratch = &mut self.entries;
                let found = model.loose_entries(plan, loose, index, i, scratch);
                let values = &self.integrals[square_of(Major::Y)].value;
                for run in &found.runs {
                    let of_run = found.of(run);
                    let terms = of_run.slots.iter().zip(of_run.weights);
                    pixels[run.column as usize] += terms
                        .map(|(&voxel, &weight)| weight * values[voxel as usize])
                        .sum::<f32>();
                }
            }
        }
    }

    fn end(&self, plan: &LightPlan, pixels: &mut [f32]) {
        let stride = UniformStrips::stride(plan.columns);
        for (source, beam) in self.sources.chunks(stride).zip(self.beams.clone()) {
            if let Some(uniform) = &plan.uniform_strips[beam] {
                let first = (plan.beams[beam].frame as usize - self.frames.start) * plan.columns;
                uniform.collect(source, &mut pixels[first..first + plan.columns]);
            }
        }
    }
}
