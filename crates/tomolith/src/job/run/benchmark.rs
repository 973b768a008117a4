//! Benchmark of a job on this machine with its present load, before any work.
//!
//! The model that the optimizer asks and that of the evaluation are made for a small sample of the job's pixels, and for a larger one: the line
//! through both tells what a call costs at any size from what grows with it. A sample is some frames; where a model takes pixels alone, of
//! each frame only some blocks of pixels, spread evenly, so that the answer takes seconds whatever a ray costs. The optimizer's adjoint is timed on what
//! the objective says of a good dose, one that is off by half a percent and blurred at surfaces: bands that most voxels keep
//! make it cheap, as they do in a run. One pass of the objective is timed as well, and the metrics on two copies of the
//! target.
//!
//! # Cost
//! Some seconds; memory below what the run needs.

use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::{PixelMask, Volume, VolumeGrid};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::metrics::evaluate;
use crate::metrics::print::Print;
use crate::models::layout::PatternLayout;
use crate::models::planner::{self, ModelPlan};
use crate::models::rays::matrix_cache;
use crate::models::{DoseModel, Family, OpticalScene, Purpose, Quantity, TimedBy, Work};
use crate::objective::Objective;
use crate::optics::light::{Light, Selection};
use std::sync::Arc;
use std::time::Instant;
use tomolith_core::parallel::table;

/// Updates of the calls that are timed, about, where a kernel takes neighboring frames together; and such frames, as many as it does at
/// once: they share what they light.
const TIMED_UPDATES: usize = 50_000_000;
const TIMED_FRAMES: usize = 8;
/// Groups of neighboring frames at least: one in each quarter of the turn, since what is found of a quarter serves all of them.
const TIMED_GROUPS: usize = 4;
/// Pixels of a frame that are enough to begin with where pixels are taken alone: rays through many walls take long.
const TIMED_PIXELS: usize = 32;
/// Blocks of rows at most, of which a column of such a sample has one.
const BLOCKS: usize = 8;
/// Seconds above which calls are long enough to time, and above which a call is timed once.
const TIMED_S: f64 = 0.3;
const LONG_S: f64 = 1.0;
/// Seconds that are long enough for the evaluation's first sample, and for its frames that are taken alone, which are as few as threads.
const ENOUGH_S: f64 = 10.0;
/// How many times larger the second of the timed samples is, where these take long and where not.
const SOME_MORE: usize = 2;
const MANY_MORE: usize = 4;
/// How many times larger a sample that takes too little time becomes at most.
const MOST_GROWTH: f64 = 32.0;
/// Voxels along the longest edge of the larger of the copies whose metrics are timed, at most; the other one has half as many.
const TIMED_EDGE: usize = 160;
/// Voxels of the evaluation up to which its own grid is tried; beyond, the job's.
const TIMED_VOXELS: usize = 20_000_000;
/// What the dose that the adjoint is timed with has of the wanted one, and what it has everywhere.
const GOOD: [f32; 2] = [0.99, 0.005];

/// How fast this machine is with this job.
#[derive(Clone, Debug)]
pub(crate) struct Rates {
    pub(crate) model: String,
    /// Calls of the optimization's model.
    pub(crate) calls: CallRates,
    /// Calls of the model of the evaluation.
    pub(crate) evaluating: CallRates,
    /// How many times finer than the job's the voxels of these are.
    pub(crate) evaluating_refine: usize,
    /// Doses of one step: the coefficients of the dose along it.
    pub(crate) doses_per_step: f64,
    /// One pass of the objective, s.
    pub(crate) objective_s: f64,
    /// One step of a pattern vector, s per pixel.
    pub(crate) vector_s: f64,
    /// Sampling the target, s per voxel.
    pub(crate) sampling_s: f64,
    /// Measuring a print.
    pub(crate) measuring: MeasuringRate,
}

/// How fast a model is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CallRates {
    /// Updates of one dose call per frame: what masks leave.
    pub(crate) updates_per_frame: f64,
    /// Making the model, pixels chosen.
    pub(crate) making: CallRate,
    /// What the first call takes beyond others: walks that are kept.
    pub(crate) first: CallRate,
    pub(crate) dose: CallRate,
    pub(crate) adjoint: CallRate,
}

/// What a call costs, by its updates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CallRate {
    /// With any number of frames, s.
    pub(crate) begin_s: f64,
    /// Beside that, s per update.
    pub(crate) per_update_s: f64,
}

/// Part of the mean cost of an update that the slope is at least.
const LEAST_SLOPE: f64 = 0.25;

impl CallRate {
    /// From two calls (updates, seconds): the line through both, whose slope is a quarter of the second's mean at least, since a disturbed clock makes the few
    /// frames look slow. Where the second is not larger or did not take longer, all is put on its size.
    fn through([few, more]: [(f64, f64); 2]) -> Self {
        let slope = (more.1 - few.1) / (more.0 - few.0);
        let per_update_s = match slope > 0.0 {
            true => slope.max(LEAST_SLOPE * more.1 / more.0),
            false => slope,
        };
        let begin_s = few.1 - per_update_s * few.0;
        if more.0 > few.0 && per_update_s > 0.0 && begin_s >= 0.0 {
            return CallRate {
                begin_s,
                per_update_s,
            };
        }
        CallRate {
            begin_s: 0.0,
            per_update_s: more.1 / more.0.max(1.0),
        }
    }

    pub(crate) fn seconds(&self, updates: f64) -> f64 {
        self.begin_s + updates * self.per_update_s
    }
}

/// Measures the rates of this machine with a job's own optics, grid, objective and target; `sampling_s` is how long
/// the target's voxels took.
pub(crate) fn rates(
    job: &ResolvedJob,
    voxels: &Voxels,
    sampling_s: f64,
    work: &Work,
) -> Result<Rates> {
    let mut optics = job.optimizing();
    let (mut measured, mut plan) = by_optimizer(job, optics, voxels, work)?;
    let updates = measured[measured.len() - 1].updates_per_frame() * job.extent.frames as f64;
    let walks = job.extent.cached_entries;
    if walks.is_some_and(|walks| updates * walks.per_update > matrix_cache::MOST as f64)
        || job.extent.cached_bytes == Some(0.0)
    {
        // What few frames can keep is too much for all
        optics.purpose = Purpose::Probe;
        (measured, plan) = by_optimizer(job, optics, voxels, work)?;
    }
    // A line has one coefficient that is not known, a quadratic two
    let doses_per_step = if plan.model.is_linear() { 1.0 } else { 2.0 };
    let (objective_s, vector_s) = passes(&plan.model, job, voxels, work)?;
    drop(plan.model);
    let fine = job.fine_grid();
    let is_small = fine.len() <= TIMED_VOXELS && !job.optics.scene().scatters();
    let (evaluating_refine, grid) = if is_small {
        (job.extent.refine, fine)
    } else {
        (1, job.grid.clone())
    };
    let evaluated = by_evaluation(job, evaluating_refine, &grid, &measured, work)?;
    Ok(Rates {
        calls: CallRates::of(&measured),
        evaluating: CallRates::of(&evaluated),
        evaluating_refine,
        doses_per_step,
        objective_s,
        vector_s,
        sampling_s: sampling_s / job.grid.len().max(1) as f64,
        measuring: measuring(voxels, job.extent.refine, work)?,
        model: plan.reason,
    })
}

/// What of the job's pixels is timed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sample {
    /// Frames of a light, in groups of so many neighbors.
    frames: usize,
    together: usize,
    /// One in so many of their pixels.
    one_in: usize,
}

impl Sample {
    /// The smallest sample of a job.
    fn least(job: &ResolvedJob, timed_by: TimedBy) -> Self {
        let alone = Sample {
            frames: rayon::current_num_threads(),
            together: 1,
            one_in: 1,
        };
        match timed_by {
            TimedBy::NeighboringFrames => Sample {
                frames: TIMED_GROUPS * TIMED_FRAMES,
                together: TIMED_FRAMES,
                one_in: 1,
            },
            TimedBy::Frames => alone,
            TimedBy::Pixels => {
                let lights = job.optics.lights.iter();
                let pixels = lights.map(|light| light.pixels.rows * light.pixels.columns);
                let one_in = pixels.max().unwrap_or(1).div_ceil(TIMED_PIXELS);
                Sample {
                    one_in: in_blocks(one_in),
                    ..alone
                }
            }
        }
    }

    /// A sample so many times as large: of more pixels, then of more frames.
    fn grown(self, times: usize) -> Self {
        let one_in = in_blocks(self.one_in.div_ceil(times));
        let left = (times * one_in / self.one_in).max(1);
        Sample {
            frames: self.frames * left,
            one_in,
            ..self
        }
    }

    /// Whether it has every pixel.
    fn is_all(&self, job: &ResolvedJob) -> bool {
        let frames = job.optics.lights.iter().map(|light| light.pixels.frames());
        self.one_in == 1 && frames.max().is_none_or(|frames| self.frames >= frames)
    }

    /// The pixels of a light that it has, of these frames: columns at even distances, and of each one block of rows in turn.
    fn mask(&self, light: &Light) -> Option<PixelMask> {
        let (rows, columns) = (light.pixels.rows, light.pixels.columns);
        let blocks = self.one_in.min(BLOCKS).min(rows);
        let every = (self.one_in / blocks).clamp(1, columns);
        (self.one_in > 1).then(|| {
            PixelMask::new(
                [light.pixels.frames(), rows, columns],
                |frame, row, column| {
                    let shifted = column + frame * every / 2;
                    shifted % every == every / 2
                        && row * blocks / rows == (shifted / every + frame) % blocks
                },
            )
        })
    }

    /// The lights of a job with these pixels alone.
    fn lights(&self, job: &ResolvedJob) -> Vec<Light> {
        let mut lights = job.optics.lights_standing();
        for light in &mut lights {
            let chosen = in_groups(light.pixels.frames(), self.frames, self.together);
            let azimuths = &mut light.pixels.azimuths;
            *azimuths = chosen.iter().map(|&frame| azimuths[frame]).collect();
            light.selection = light.selection.mapped(|mask| mask.of_frames(&chosen));
            light.selection.masks.extend(self.mask(light).map(Arc::new));
        }
        lights
    }
}

/// One pixel in so many, or in somewhat fewer: a multiple of the blocks of rows.
fn in_blocks(one_in: usize) -> usize {
    if one_in > BLOCKS {
        one_in / BLOCKS * BLOCKS
    } else {
        one_in
    }
}

/// Calls of the optimizer's model with samples that grow until they take long enough, and the last of these models.
fn by_optimizer(
    job: &ResolvedJob,
    optics: OpticalScene<'_>,
    voxels: &Voxels,
    work: &Work,
) -> Result<(Vec<Calls>, ModelPlan)> {
    let asked = computed(job);
    let timed_by = timed_by(job)?;
    // Doses of few pixels are as long as those of many
    let mut cotangent: Option<HostField> = None;
    let mut measure = |sample: Sample| -> Result<(Calls, ModelPlan)> {
        let lights = &sample.lights(job);
        let optics = optics.lit_by(lights);
        let wanted = voxels.wanted();
        let (making_s, plan) =
            timed(|| planner::plan(asked, optics, &job.grid, Some(&wanted), work));
        let plan = plan?;
        if cotangent.is_none() {
            cotangent = Some(cotangent_of_a_good_dose(&plan, job, voxels, work)?);
        }
        let calls = Calls::of(&plan, sample, making_s, cotangent.as_ref(), work)?;
        Ok((calls, plan))
    };
    let mut sample = Sample::least(job, timed_by);
    let (few, mut plan) = measure(sample)?;
    let mut calls = vec![few];
    let mut times = SOME_MORE;
    while calls[calls.len() - 1].seconds() < TIMED_S && !sample.is_all(job) {
        let seconds = calls[calls.len() - 1].seconds();
        let by_pixels = timed_by == TimedBy::Pixels;
        sample = if by_pixels {
            sample.grown((TIMED_S / seconds).clamp(2.0, MOST_GROWTH).ceil() as usize)
        } else {
            times = MANY_MORE;
            let frames = TIMED_UPDATES / job.grid.len().max(1) / job.optics.lights.len();
            let frames = frames.max(sample.frames).next_multiple_of(sample.frames);
            Sample { frames, ..sample }
        };
        let (next, next_plan) = measure(sample)?;
        calls.push(next);
        plan = next_plan;
        if !by_pixels {
            break;
        }
    }
    // Single pixels that take long are timed well enough: no more of them are needed
    let is_enough = timed_by == TimedBy::Pixels && calls[calls.len() - 1].seconds() > LONG_S;
    if !sample.is_all(job) && !is_enough {
        let (more, next_plan) = measure(sample.grown(times))?;
        calls.push(more);
        plan = next_plan;
    }
    Ok((calls, plan))
}

/// Calls of the model of the evaluation on a grid, with the pixels that the optimizer's samples lit, until they take long enough; Monte Carlo
/// paths as many as the optimizer's.
fn by_evaluation(
    job: &ResolvedJob,
    refine: usize,
    grid: &VolumeGrid,
    samples: &[Calls],
    work: &Work,
) -> Result<Vec<Calls>> {
    let family = job.optics.family(grid)?;
    let purpose = match family.monte_carlo_paths() {
        Some(_) => Purpose::Probe,
        None => Purpose::Evaluate { refine },
    };
    // Few frames that are taken alone say nothing of what making the model takes
    let enough = match timed_by(job)? {
        TimedBy::Frames => ENOUGH_S,
        _ => TIMED_S,
    };
    let mut found: Vec<Calls> = Vec::new();
    for calls in samples {
        // What every call begins with is in all of them, and may be most of what small samples take
        let grown = match found.as_slice() {
            [] => false,
            [one] => one.seconds() > ENOUGH_S,
            [first, .., last] => {
                last.seconds() - first.seconds() > enough || last.seconds() > ENOUGH_S
            }
        };
        if grown {
            break;
        }
        let mut lights = calls.sample.lights(job);
        for (light, layout) in lights.iter_mut().zip(&calls.layouts) {
            let lit = layout.runs.iter().map(|run| (run.bottom, run.count));
            (light.active, light.selection) = (Some(lit.collect()), Selection::default());
        }
        let optics = OpticalScene {
            lights: &lights,
            purpose,
            ..job.optics.scene()
        };
        let (making_s, plan) = timed(|| planner::plan(computed(job), optics, grid, None, work));
        found.push(Calls::of(&plan?, calls.sample, making_s, None, work)?);
    }
    Ok(found)
}

/// What the unknowns of the optimizer's model are.
pub(crate) fn quantity(job: &ResolvedJob, work: &Work) -> Result<Quantity> {
    let lights = &Sample::least(job, timed_by(job)?).lights(job);
    let optics = job.optics.scene().lit_by(lights);
    let plan = planner::plan(computed(job), optics, &job.grid, None, work)?;
    Ok(plan.model.quantity())
}

/// The model that the job names. A stored one is known for its own pixels only: what the geometry would take stands for it.
fn computed(job: &ResolvedJob) -> Option<&Family> {
    let asked = job.optics.model.as_ref();
    asked.filter(|family| !family.capabilities().is_stored)
}

/// What of the model's light predicts the time of all.
fn timed_by(job: &ResolvedJob) -> Result<TimedBy> {
    let optics = job.optics.scene();
    let family = planner::choose(computed(job), &optics, &job.grid)?;
    Ok(family.capabilities().timed_by)
}

/// About so many of `frames` frames: evenly spaced groups of so many neighbors.
fn in_groups(frames: usize, wanted: usize, together: usize) -> Vec<usize> {
    if wanted >= frames {
        return (0..frames).collect();
    }
    let groups = wanted.div_ceil(together);
    let mut chosen: Vec<usize> = (0..groups)
        .flat_map(|group| {
            let first = group * frames / groups;
            first..(first + together).min(frames)
        })
        .collect();
    chosen.dedup();
    chosen
}

/// What the calls of a model take.
#[derive(Clone)]
struct Calls {
    /// The frames to time, and all frames of all lights.
    sample: Sample,
    frames: usize,
    layouts: Vec<PatternLayout>,
    updates: u64,
    /// Making it, what the first dose takes beyond others, a dose, an adjoint (0 if none was timed).
    seconds: [f64; 4],
}

impl Calls {
    fn of(
        plan: &ModelPlan,
        sample: Sample,
        making_s: f64,
        cotangent: Option<&HostField>,
        work: &Work,
    ) -> Result<Self> {
        let model = &plan.model;
        let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
        let mut gradient = x.zeros_like();
        x.fill(1.0);
        // Caches, threads and pages wake up, walks are kept
        let (first, done) = timed(|| model.dose(&x, &mut dose, work));
        done?;
        // The better of two: what disturbs a clock makes it longer
        let mut dose_s = f64::INFINITY;
        for _ in 0..2 {
            let (seconds, done) = timed(|| model.dose(&x, &mut dose, work));
            done?;
            dose_s = dose_s.min(seconds);
            if seconds > LONG_S {
                break;
            }
        }
        let mut adjoint_s: Option<f64> = None;
        for cotangent in cotangent.iter().cycle().take(2) {
            let (seconds, done) = timed(|| model.pullback(&x, cotangent, &mut gradient, work));
            done?;
            adjoint_s = Some(adjoint_s.map_or(seconds, |least| least.min(seconds)));
            if seconds > LONG_S {
                break;
            }
        }
        let first_s = (first - dose_s).max(0.0);
        Ok(Calls {
            sample,
            frames: model.patterns().iter().map(|p| p.grid.frames()).sum(),
            layouts: model.patterns().to_vec(),
            updates: model.updates(),
            seconds: [making_s, first_s, dose_s, adjoint_s.unwrap_or(0.0)],
        })
    }

    /// Of one of each.
    fn seconds(&self) -> f64 {
        self.seconds.iter().sum()
    }

    fn updates_per_frame(&self) -> f64 {
        let updates = self.updates as f64 * self.sample.one_in as f64;
        updates / self.frames.max(1) as f64
    }
}

impl CallRates {
    /// From calls with a sample and with larger ones.
    fn of(calls: &[Calls]) -> Self {
        let last = &calls[calls.len() - 1];
        let before = &calls[calls.len().saturating_sub(2)];
        let rate = |i: usize| {
            let point = |calls: &Calls| (calls.updates as f64, calls.seconds[i]);
            CallRate::through([before, last].map(point))
        };
        CallRates {
            updates_per_frame: last.updates_per_frame(),
            making: rate(0),
            first: rate(1),
            dose: rate(2),
            adjoint: rate(3),
        }
    }
}

/// Seconds of one pass of the objective, and of one step of a pattern vector per pixel.
fn passes(
    model: &dyn DoseModel<Field = HostField>,
    job: &ResolvedJob,
    voxels: &Voxels,
    work: &Work,
) -> Result<(f64, f64)> {
    let (mut x, mut dose, mut gradient) =
        (model.new_patterns()?, model.new_dose()?, model.new_dose()?);
    x.fill(1.0);
    let zeros = x.zeros_like();
    let (vector_s, ()) = timed(|| x.axpy(0.5, &zeros));
    let objective = job.objective(
        job.first(),
        job.first().goal.on_host(),
        &model.outputs()[0],
        voxels,
    )?;
    model.dose(&x, &mut dose, work)?;
    objective.value_and_gradient(&dose, &mut gradient); // caches and pages wake up
    work.check()?;
    let (of_one_s, _) = timed(|| objective.value_and_gradient(&dose, &mut gradient));
    // Every species has an objective of its own on as many voxels
    let objective_s = of_one_s * model.outputs().len() as f64;
    Ok((objective_s, vector_s / x.len().max(1) as f64))
}

/// What the objective says of a dose that is nearly the wanted one.
fn cotangent_of_a_good_dose(
    plan: &ModelPlan,
    job: &ResolvedJob,
    voxels: &Voxels,
    work: &Work,
) -> Result<HostField> {
    let outputs = plan.model.outputs();
    let layout = &outputs[0];
    let response = &job.first().goal.response;
    let wanted = Volume {
        grid: layout.grid.clone(),
        values: table(voxels.target.inside.values.len(), |i| {
            let inside = voxels.target.inside.values[i];
            response.inverse(GOOD[0] * inside + GOOD[1]).clamp(0.0, 1.0)
        }),
    };
    work.check()?;
    let mut dose = plan.model.new_dose()?;
    dose.as_mut_slice()[layout.range()].copy_from_slice(&layout.field_of(&wanted));
    work.check()?;
    let mut cotangent = plan.model.new_dose()?;
    let objective = job.objective(job.first(), job.first().goal.on_host(), layout, voxels)?;
    work.check()?;
    objective.value_and_gradient(&dose, &mut cotangent);
    work.check()?;
    // That of the first species stands for those of all
    let first = cotangent.as_slice()[layout.range()].to_vec();
    for other in &outputs[1..] {
        cotangent.as_mut_slice()[other.range()].copy_from_slice(&first);
    }
    Ok(cotangent)
}

/// Seconds, and what came out.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = work();
    (start.elapsed().as_secs_f64().max(1e-7), result)
}

/// What measuring a print costs: numbers for each voxel, and distances along its surface, which grows with the square of the edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MeasuringRate {
    /// s per voxel.
    pub(crate) per_voxel_s: f64,
    /// s per voxel to the power of ⅔.
    pub(crate) per_face_s: f64,
    /// s per voxel of the larger copy, all in all.
    pub(crate) mean_s: f64,
}

impl MeasuringRate {
    /// From two measurements (voxels, seconds): what grows faster than faces is put on voxels, at most all of it; of one size, all.
    fn through([few, more]: [(f64, f64); 2]) -> Self {
        let mean_s = more.1 / more.0.max(1.0);
        let faces = more.0.max(1.0).powf(2.0 / 3.0);
        let share = faces / few.0.max(1.0).powf(2.0 / 3.0);
        let per_voxel_s = match more.0 > few.0 {
            true => (more.1 - share * few.1) / (more.0 - share * few.0),
            false => mean_s,
        };
        let per_voxel_s = per_voxel_s.clamp(0.0, mean_s);
        MeasuringRate {
            per_voxel_s,
            per_face_s: (more.1 - per_voxel_s * more.0) / faces,
            mean_s,
        }
    }

    /// A print of so many voxels, s.
    pub(crate) fn seconds(self, voxels: f64) -> f64 {
        self.per_voxel_s * voxels + self.per_face_s * voxels.powf(2.0 / 3.0)
    }
}

/// What measuring a print on voxels `refine` times finer costs: the target is
/// taken for its dose, so that surfaces are as long as a good print's, and as close to the part's.
fn measuring(voxels: &Voxels, refine: usize, work: &Work) -> Result<MeasuringRate> {
    let longest = voxels.labels.grid.shape.iter().copied().max().unwrap_or(1);
    let edge = (longest * refine).min(TIMED_EDGE);
    let mut found = [(0.0, 0.0); 2];
    for (found, edge) in found.iter_mut().zip([edge.div_ceil(2), edge]) {
        let labels = resampled(&voxels.labels, edge);
        let inside = resampled(&voxels.target.inside, edge);
        let (seconds, measured) = timed(|| -> Result<_> {
            let print = Print::under(&labels, &inside, work.aside())?.with_inside(&inside)?;
            Ok(evaluate(&print))
        });
        drop(measured?);
        work.check()?;
        *found = (labels.values.len() as f64, seconds);
    }
    Ok(MeasuringRate::through(found))
}

/// The same volume with `edge` voxels along its longest axis: every n-th voxel, or some of them several times.
fn resampled<T: Copy>(volume: &Volume<T>, edge: usize) -> Volume<T> {
    let shape = volume.grid.shape;
    let longest = shape.iter().copied().max().unwrap_or(1);
    let grid = VolumeGrid {
        shape: shape.map(|n| (n * edge).div_ceil(longest)),
        pitch_mm: volume.grid.pitch_mm * longest as f64 / edge as f64,
        height_mm: volume.grid.pitch_mm * longest as f64 / edge as f64,
        center_mm: volume.grid.center_mm,
    };
    let [nz, ny, nx] = grid.shape;
    let source = |i: usize| i * longest / edge;
    let mut values = Vec::with_capacity(grid.len());
    for z in 0..nz {
        for y in 0..ny {
            let row = &volume.values[volume.grid.index(source(z), source(y), 0)..];
            values.extend((0..nx).map(|x| row[source(x)]));
        }
    }
    Volume { grid, values }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_measurements_tell_what_grows_from_what_does_not() {
        let line = |measured| {
            let rate = CallRate::through(measured);
            (rate.begin_s, rate.per_update_s)
        };
        let (begin, slope) = line([(10.0, 3.0), (40.0, 6.0)]);
        assert!((begin - 2.0).abs() < 1e-12 && (slope - 0.1).abs() < 1e-12);
        // A job that is too small for two sizes, and a clock that was disturbed
        assert_eq!(line([(10.0, 3.0), (10.0, 5.0)]), (0.0, 0.5));
        assert_eq!(line([(10.0, 3.0), (40.0, 2.0)]), (0.0, 0.05));
    }

    #[test]
    fn measuring_grows_with_voxels_and_faces() {
        let seconds = |measured, voxels| MeasuringRate::through(measured).seconds(voxels);
        // 2 µs a voxel and 100 µs a face: 1000 and 8000 voxels, 100 and 400 faces
        let both = [(1e3, 0.012), (8e3, 0.056)];
        tomolith_core::near!(seconds(both, 64e3), 0.128 + 0.16, 1e-12);
        // Slower than faces, faster than voxels, and one size only
        tomolith_core::near!(seconds([(1e3, 0.02), (8e3, 0.04)], 64e3), 0.16, 1e-12);
        tomolith_core::near!(seconds([(1e3, 1e-4), (8e3, 0.04)], 64e3), 0.32, 1e-12);
        tomolith_core::near!(seconds([(8e3, 0.04), (8e3, 0.04)], 64e3), 0.32, 1e-12);
    }

    #[test]
    fn samples_are_spread_evenly_and_grow_to_all_pixels() {
        let pixels = crate::grid::PatternGrid::full_turn(4, 0.0, 70, 90, 0.1);
        let light = Light::new(pixels, crate::optics::resin::Resin::absorbing(1.5, 0.1));
        let mut sample = Sample {
            frames: 2,
            together: 1,
            one_in: in_blocks(100),
        };
        while sample.one_in > 1 {
            let mask = sample.mask(&light).unwrap();
            let lit = |row: usize| {
                let places = (0..360).map(|i| [i / 90, row, i % 90]);
                places.filter(|&at| mask.allows(at)).count()
            };
            let all: usize = (0..70).map(lit).sum();
            let expected = (4 * 70 * 90) as f64 / sample.one_in as f64;
            tomolith_core::near!(all as f64 / expected, 1.0, 0.15, "{sample:?}: {all}");
            sample = sample.grown(4);
        }
        assert!(sample.mask(&light).is_none());
        assert_eq!(sample.frames, 4);
        assert_eq!(sample.grown(3).frames, 12);
    }

    #[test]
    fn frames_of_a_trial_are_neighbors_all_around() {
        assert_eq!(in_groups(5, 16, 8), [0, 1, 2, 3, 4]);
        let chosen = in_groups(400, 16, 8);
        let expected: Vec<usize> = (0..8).chain(200..208).collect();
        assert_eq!(chosen, expected);
        assert_eq!(in_groups(400, 2, 1), [0, 200]);
        assert!(
            in_groups(17, 16, 8)
                .windows(2)
                .all(|pair| pair[0] < pair[1])
        );
    }

    #[test]
    fn a_copy_has_every_nth_voxel_or_each_several_times() {
        let grid = VolumeGrid::centered([3, 2, 5], 0.1);
        let values: Vec<u32> = (0..30).collect();
        let volume = Volume { grid, values };
        // 5 voxels become 3: those at 0, ⌊5/3⌋ and ⌊10/3⌋
        let thin = resampled(&volume, 3);
        assert_eq!(thin.grid.shape, [2, 2, 3]);
        assert_eq!(thin.values, [0, 1, 3, 5, 6, 8, 10, 11, 13, 15, 16, 18]);
        assert!((thin.grid.pitch_mm - 0.5 / 3.0).abs() < 1e-15);
        let fine = resampled(&volume, 10);
        assert_eq!(fine.grid.shape, [6, 4, 10]);
        assert_eq!(fine.values[..6], [0, 0, 1, 1, 2, 2]);
        assert_eq!(fine.values[6 * 4 * 10 - 1], 29);
    }
}
