//! What a job will cost: memory, disk and time, before any work.
//!
//! Memory counts the arrays the method needs. Time is measured, on this machine and as busy as it is: a dose and an adjoint
//! call of the job's own model with few of its frames and with some more, one pass of its objective, and the metrics on two
//! thinned copies of the dose. Two sizes tell what a call costs at any size from what grows with it. The adjoint is asked
//! for what the objective says of a good dose, one that is off by half a percent and blurred at surfaces: bands that most
//! voxels keep make it cheap, as they do in a run. These rates are multiplied by what the job asks for ([`Work::cost`]). An
//! optimisation that ends before its last iteration takes less.

use super::build::Optics;
use super::scene::{Scene, Voxels};
use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::{Volume, VolumeGrid};
use crate::metrics::evaluate;
use crate::metrics::print::Print;
use crate::models::layout::row_of;
use crate::models::rays::kept;
use crate::models::scatter::JUDGING;
use crate::models::{Choice, Run, planner};
use crate::objective::Objective;
use rayon::prelude::*;
use std::time::Instant;

/// Dose, its change along a step, gradient (4 bytes each), inside fraction (4), labels (1), response (4 while metrics run).
const BYTES_PER_VOXEL: f64 = 21.0;
/// Dose turning and standing, the second also as what is derived from it (4 bytes each), labels and what metrics need at a
/// time: 10 to 11 bytes measured at 512³ and 800³.
const BYTES_PER_FINE_VOXEL: f64 = 12.0;
/// Voxels that the light of a pixel meets in a plane of voxels.
const VOXELS_PER_PLANE: f64 = 1.7;
/// Raw, quantised and as levels.
const BYTES_PER_PIXEL: f64 = 10.0;
/// Weight, lower and upper end of the band, where they differ from voxel to voxel.
const BYTES_PER_VOXEL_OF_FIELDS: f64 = 12.0;
/// A level of a machine's canvas.
const BYTES_PER_CANVAS_PIXEL: f64 = 2.0;
/// What every run needs: the program, the report, one movie frame, …
const BASE_MB: f64 = 20.0;
/// Compressed size of a pattern value in the npz, the frames and the movie, beside 8 bytes of raw values.
const BYTES_PER_PIXEL_ON_DISK: f64 = 10.0;
/// Bytes of dose.npy (4) and dose.vti (9: dose, target, label) per voxel, and some more.
const BYTES_PER_VOXEL_ON_DISK: f64 = 20.0;
/// Bytes of print.stl per face of a cube of as many voxels as are evaluated: the part has about twelve triangles (50 bytes
/// each) where the cube has one voxel's face on each of its six sides.
const BYTES_PER_FACE_ON_DISK: f64 = 600.0;
/// Pattern vectors of an optimiser beside its memory of 2m.
const VECTORS: usize = 4;
/// Updates of the calls that are timed, about; and neighbouring frames, as many as the kernel does at once: they share what
/// they light.
const TRIAL_UPDATES: usize = 50_000_000;
const TRIAL_FRAMES: usize = 8;
/// Groups of neighbouring frames at least: one and the opposite one.
const TRIAL_GROUPS: usize = 2;
/// How many times more frames the second of the timed calls has.
const MORE_FRAMES: usize = 4;
/// Voxels along the longest edge of the thinned copies whose metrics are timed.
const TRIAL_EDGES: [usize; 2] = [80, 160];
/// Forward and adjoint calls beside those of the iterations: the start, its dose, the raw patterns' dose.
const OTHER_CALLS: f64 = 4.0;
/// Models made to judge: on the job's voxels for raw and for written patterns, on finer ones standing and turning.
const MODELS: f64 = 4.0;
/// What measuring a voxel of a thinned copy costs, times so many: for each voxel of the finer grid the metrics standing and
/// turning, the published numbers and the surface's file, at half the price, as it has less surface for its voxels; for each of
/// the job's own the metrics and files; for each pixel a PNG, a movie, its check and the arrays.
const MEASURES_PER_FINE_VOXEL: f64 = 1.2;
const MEASURES_PER_VOXEL: f64 = 2.4;
const MEASURES_PER_PIXEL: f64 = 1.8;
/// Passes over the dose of an iteration, the line search's included.
const PASSES: f64 = 5.0;
/// What the dose that the adjoint is timed with has of the wanted one, and what it has everywhere.
const GOOD: [f32; 2] = [0.99, 0.005];

/// The extent of the problem, known before anything is built.
#[derive(Clone, Debug)]
pub(crate) struct Extent {
    /// Voxels.
    pub(crate) grid: VolumeGrid,
    /// How many times finer the evaluation is.
    pub(crate) refine: usize,
    /// Frames of all lights.
    pub(crate) frames: usize,
    /// Pixels whose light can meet the target, of all lights.
    pub(crate) active_pixels: usize,
    /// All pixels of all lights.
    pub(crate) pixels: usize,
    /// Columns of all frames of all lights.
    pub(crate) columns: usize,
    /// The optimiser's memory m.
    pub(crate) memory: usize,
    /// Objectives whose weights or bands differ from voxel to voxel.
    pub(crate) fields: usize,
    /// Pixels of all frames on the machine's canvases, 0 without a machine.
    pub(crate) canvas: usize,
    /// Whether the model keeps the walks of its rays where they are few.
    pub(crate) keeps_walks: bool,
    /// Bytes of a canvas pixel in `frames.npz`, 0 when it is not written.
    pub(crate) stacked: usize,
}

impl Extent {
    /// For a target with this box.
    pub(crate) fn new(
        optics: &Optics,
        grid: &VolumeGrid,
        [low, high]: [[f64; 3]; 2],
        refine: usize,
        memory: usize,
    ) -> Self {
        let corner = f64::hypot(high[0].max(-low[0]), high[1].max(-low[1]));
        let radius = corner.min(optics.vial.resin_wall().inscribed_radius());
        let active = |light: &crate::models::parallel::Light| {
            let [across, along] = light.pixels.pitch_mm;
            let field = light.selection.field_mm(&light.pixels);
            let lit = |axis: usize, pitch: f64| {
                ((field[1][axis] - field[0][axis]) / pitch).round() as usize
            };
            // Refraction lets a narrower bundle fill the same part
            let columns = (2.0 * radius / across).ceil() as usize + 1;
            let (sin, cos) = optics.tilt_rad().abs().sin_cos();
            let seen = (high[2] - low[2]) * cos + 2.0 * radius * sin;
            let rows = (seen / along).ceil() as usize + 1;
            light.pixels.frames() * lit(0, across).min(columns) * lit(1, along).min(rows)
        };
        Extent {
            grid: grid.clone(),
            refine,
            frames: optics.lights.iter().map(|l| l.pixels.frames()).sum(),
            active_pixels: optics.lights.iter().map(active).sum(),
            pixels: optics.lights.iter().map(|l| l.pixels.len()).sum(),
            columns: optics
                .lights
                .iter()
                .map(|l| l.pixels.frames() * l.pixels.columns)
                .sum(),
            memory,
            fields: 0,
            canvas: 0,
            keeps_walks: matches!(optics.model_for(1, grid), Choice::Rays(_)),
            stacked: 0,
        }
    }

    /// Bytes of walks that are kept: about 1.7 voxels of every voxel plane that a pixel's light crosses.
    fn walks(&self) -> f64 {
        let planes = self.grid.shape.iter().copied().max().unwrap_or(0) as f64;
        let entries = self.active_pixels as f64 * VOXELS_PER_PLANE * planes;
        let most = kept::MOST as f64;
        // It may turn out less than estimated
        if self.keeps_walks && entries <= 2.0 * most {
            entries.min(most) * kept::BYTES as f64
        } else {
            0.0
        }
    }

    fn lanes(&self, factor: usize) -> f64 {
        let [nz, ny, nx] = self.grid.shape.map(|n| n * factor);
        (row_of(nz) * ny * nx) as f64
    }

    /// Bytes of the pixels brought to the voxels' heights, which the model keeps between calls.
    fn scratch(&self, factor: usize) -> f64 {
        (self.columns * row_of(self.grid.shape[0] * factor) * 4) as f64
    }

    /// Memory of the optimisation, MB: of the voxels and of the pixels.
    pub(crate) fn optimisation(&self) -> [f64; 2] {
        let vectors = (2 * self.memory + VECTORS) as f64;
        let patterns = self.active_pixels as f64 * 4.0 * vectors;
        let per_voxel = BYTES_PER_VOXEL + self.fields as f64 * BYTES_PER_VOXEL_OF_FIELDS;
        [
            self.lanes(1) * per_voxel / 1e6,
            (self.scratch(1) + self.walks() + patterns) / 1e6,
        ]
    }

    /// Memory of the evaluation, MB: of the voxels and of the pixels.
    pub(crate) fn evaluation(&self) -> [f64; 2] {
        let patterns = self.pixels as f64 * BYTES_PER_PIXEL;
        [
            self.lanes(self.refine) * BYTES_PER_FINE_VOXEL / 1e6,
            (self.scratch(self.refine) + patterns) / 1e6 + self.canvas_mb(),
        ]
    }

    /// Memory of the levels of all canvases, which are made to be written, MB.
    pub(crate) fn canvas_mb(&self) -> f64 {
        self.canvas as f64 * BYTES_PER_CANVAS_PIXEL / 1e6
    }

    /// Memory of the optimisation, MB.
    pub(crate) fn optimisation_mb(&self) -> u64 {
        whole_mb(self.optimisation())
    }

    /// Memory of the evaluation, MB.
    pub(crate) fn evaluation_mb(&self) -> u64 {
        whole_mb(self.evaluation())
    }

    /// Size of the run folder, MB.
    pub(crate) fn disk_mb(&self) -> u64 {
        let voxels = self.grid.len() as f64;
        let checkpoint = self.active_pixels as f64 * 4.0 * (2 * self.memory + VECTORS) as f64;
        let fine = voxels * self.refine.pow(3) as f64;
        let bytes = voxels * BYTES_PER_VOXEL_ON_DISK
            + fine.powf(2.0 / 3.0) * BYTES_PER_FACE_ON_DISK
            + self.pixels as f64 * BYTES_PER_PIXEL_ON_DISK
            + (self.canvas * self.stacked) as f64
            + checkpoint;
        (10.0 + bytes / 1e6) as u64
    }
}

/// Memory of a stage with what every run needs, MB.
pub(crate) fn whole_mb(parts: [f64; 2]) -> u64 {
    (BASE_MB + parts[0] + parts[1]) as u64
}

/// How fast this machine is with this job.
#[derive(Clone, Debug)]
pub(crate) struct Rates {
    /// Which model.
    pub(crate) model: String,
    /// Making the model, s: what does not grow with the frames.
    pub(crate) model_s: f64,
    /// Dose calls.
    pub(crate) dose: CallRate,
    /// Adjoint calls.
    pub(crate) adjoint: CallRate,
    /// Updates of one dose call per frame: what masks leave.
    pub(crate) updates_per_frame: f64,
    /// One pass of the objective, s.
    pub(crate) objective_s: f64,
    /// One step of a pattern vector, s per pixel.
    pub(crate) vector_s: f64,
    /// Sampling the target, s per voxel.
    pub(crate) sampling_s: f64,
    /// Measuring a print, above all the distances of surfaces, s per voxel.
    pub(crate) measuring_s: f64,
}

/// What a call costs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CallRate {
    /// With any number of frames, s.
    pub(crate) begin_s: f64,
    /// Beside that, s per update.
    pub(crate) per_update_s: f64,
}

impl CallRate {
    /// From two calls (updates, seconds): the line through both. Where the second is not larger or did not take longer, all
    /// is put on its size.
    fn through([few, more]: [(f64, f64); 2]) -> Self {
        let per_update_s = (more.1 - few.1) / (more.0 - few.0);
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

    fn seconds(&self, updates: f64) -> f64 {
        self.begin_s + updates * self.per_update_s
    }
}

/// What a job asks for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Work<'a> {
    pub(crate) extent: &'a Extent,
    /// The most iterations there will be.
    pub(crate) iterations: usize,
    /// Angles at which a frame of the optimisation and of the evaluation is averaged.
    pub(crate) sub_angles: [usize; 2],
    /// Whether light is followed along random paths.
    pub(crate) random_paths: bool,
    /// Limit of the optimisation's time, s.
    pub(crate) wall_s: Option<f64>,
}

/// How long it will take, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cost {
    /// The optimisation, when no iteration is saved.
    pub(crate) optimisation_s: f64,
    /// Everything else: sampling, evaluation, files.
    pub(crate) rest_s: f64,
}

impl Work<'_> {
    /// The evaluation's dose calls, in calls of the optimisation.
    fn judging_calls(&self) -> f64 {
        let refine = self.extent.refine as f64;
        if self.random_paths {
            // On the job's voxels raw, written, and twice for the noise; on finer ones, which a path crosses more of,
            // standing and turning
            return JUDGING as f64 * (4.0 + 2.0 * refine);
        }
        refine.powi(3) * (1.0 + self.sub_angles[1] as f64)
    }

    /// Rates times work.
    pub(crate) fn cost(&self, rates: &Rates) -> Cost {
        let Work {
            extent, iterations, ..
        } = *self;
        let own = self.sub_angles[0] as f64;
        let (voxels, finer) = (extent.grid.len() as f64, extent.refine.pow(3) as f64);
        let updates = rates.updates_per_frame * extent.frames as f64;
        let [dose_s, adjoint_s] = [rates.dose, rates.adjoint].map(|rate| rate.seconds(updates));
        let vectors = extent.active_pixels as f64 * rates.vector_s;
        let step_s = own * (dose_s + adjoint_s)
            + PASSES * rates.objective_s
            + (4 * extent.memory + VECTORS) as f64 * vectors;
        let optimisation_s = (iterations as f64 * step_s).min(self.wall_s.unwrap_or(f64::INFINITY))
            + OTHER_CALLS * own * dose_s
            + rates.model_s;
        let measures = voxels * (MEASURES_PER_FINE_VOXEL * finer + MEASURES_PER_VOXEL)
            + extent.pixels as f64 * MEASURES_PER_PIXEL;
        Cost {
            optimisation_s,
            rest_s: MODELS * rates.model_s
                + self.judging_calls() * dose_s
                + measures * rates.measuring_s
                + voxels * (finer + 1.0) * rates.sampling_s,
        }
    }
}

/// Measures the rates of this machine with a job's own optics, grid, objective and target; `sampling_s` is how long
/// the target's voxels took.
///
/// # Errors
/// As the planner; [`Error::Cancelled`](crate::Error::Cancelled).
pub(crate) fn rates(scene: &Scene, voxels: &Voxels, sampling_s: f64, run: &Run) -> Result<Rates> {
    let few = (TRIAL_UPDATES / scene.grid.len().max(1) / scene.optics.lights.len())
        .max(1)
        .next_multiple_of(TRIAL_GROUPS * TRIAL_FRAMES);
    let (model_s, plan) = timed(|| trial(scene, voxels, few, run));
    let plan = plan?;
    let (few, model) = (Calls::of(&plan, scene, voxels, run)?, plan.model);
    let layout = &model.outputs()[0];
    let (mut x, mut dose, mut gradient) =
        (model.new_patterns()?, model.new_dose()?, model.new_dose()?);
    x.fill(1.0);
    let zeros = x.zeros_like();
    let (vector_s, ()) = timed(|| x.axpy(0.5, &zeros));
    let objective = scene.objective(layout, voxels)?;
    model.dose(&x, &mut dose, run)?;
    objective.value_and_gradient(&dose, &mut gradient);
    let (objective_s, _) = timed(|| objective.value_and_gradient(&dose, &mut gradient));
    let vector_s = vector_s / x.len().max(1) as f64;
    drop((x, dose, gradient, zeros, objective, model));
    let more = trial(scene, voxels, few.frames * MORE_FRAMES, run)?;
    let more = Calls::of(&more, scene, voxels, run)?;
    let rate = |i: usize| {
        CallRate::through([&few, &more].map(|calls| (calls.updates as f64, calls.seconds[i])))
    };
    Ok(Rates {
        model_s,
        dose: rate(0),
        adjoint: rate(1),
        updates_per_frame: few.updates as f64 / few.frames.max(1) as f64,
        objective_s,
        vector_s,
        sampling_s: sampling_s / scene.grid.len().max(1) as f64,
        measuring_s: measuring(voxels)?,
        model: plan.reason,
    })
}

/// The job's model with about so many of its frames.
fn trial(scene: &Scene, voxels: &Voxels, frames: usize, run: &Run) -> Result<planner::Plan> {
    let mut lights = scene.optics.lights_turning(1);
    for light in &mut lights {
        let chosen = in_groups(light.pixels.frames(), frames);
        let azimuths = &mut light.pixels.azimuths;
        *azimuths = chosen.iter().map(|&frame| azimuths[frame]).collect();
        light.selection = light.selection.mapped(|mask| mask.of_frames(&chosen));
    }
    // A matrix is known for its own pixels only: what the geometry would take stands for it
    let choice = match &scene.optics.model {
        Choice::Matrix(_) => Choice::default(),
        other => other.clone(),
    };
    planner::plan(
        &choice,
        scene.setup(),
        lights,
        scene.grid.clone(),
        Some(&voxels.wanted()),
        run,
    )
}

/// About so many of `frames` frames: evenly spaced groups of neighbours.
fn in_groups(frames: usize, wanted: usize) -> Vec<usize> {
    if wanted >= frames {
        return (0..frames).collect();
    }
    let groups = wanted.div_ceil(TRIAL_FRAMES);
    let mut chosen: Vec<usize> = (0..groups)
        .flat_map(|group| {
            let first = group * frames / groups;
            first..(first + TRIAL_FRAMES).min(frames)
        })
        .collect();
    chosen.dedup();
    chosen
}

/// What the calls of a model take.
struct Calls {
    frames: usize,
    updates: u64,
    /// A dose and an adjoint.
    seconds: [f64; 2],
}

impl Calls {
    fn of(plan: &planner::Plan, scene: &Scene, voxels: &Voxels, run: &Run) -> Result<Self> {
        let model = plan.model.as_ref();
        let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
        let mut gradient = x.zeros_like();
        x.fill(1.0);
        model.dose(&x, &mut dose, run)?; // caches, threads and pages wake up
        let cotangent = cotangent_of_a_good_dose(plan, scene, voxels)?;
        let mut seconds = [f64::INFINITY; 2];
        // The better of two: what disturbs a clock makes it longer
        for _ in 0..2 {
            let (forward, done) = timed(|| model.dose(&x, &mut dose, run));
            done?;
            let (back, done) = timed(|| model.pullback(&x, &cotangent, &mut gradient, run));
            done?;
            seconds = [seconds[0].min(forward), seconds[1].min(back)];
        }
        Ok(Calls {
            frames: model.patterns().iter().map(|p| p.grid.frames()).sum(),
            updates: model.updates(),
            seconds,
        })
    }
}

/// What the objective says of a dose that is nearly the wanted one.
fn cotangent_of_a_good_dose(
    plan: &planner::Plan,
    scene: &Scene,
    voxels: &Voxels,
) -> Result<HostField> {
    let layout = &plan.model.outputs()[0];
    let response = scene.response()?;
    let wanted = Volume {
        grid: layout.grid.clone(),
        values: (voxels.target.inside.values.par_iter())
            .map(|&inside| response.inverse(GOOD[0] * inside + GOOD[1]).clamp(0.0, 1.0))
            .collect(),
    };
    let mut dose = plan.model.new_dose()?;
    dose.as_mut_slice()[layout.range()].copy_from_slice(&layout.field_of(&wanted));
    let mut cotangent = plan.model.new_dose()?;
    scene
        .objective(layout, voxels)?
        .value_and_gradient(&dose, &mut cotangent);
    Ok(cotangent)
}

/// Seconds, and what came out.
fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = work();
    (start.elapsed().as_secs_f64().max(1e-7), result)
}

/// Seconds per voxel to measure a print, beside what measuring any print takes: from every n-th voxel of the target taken for
/// its dose, so that surfaces are as long as a good print's, and as close to the part's.
fn measuring(voxels: &Voxels) -> Result<f64> {
    let longest = voxels.labels.grid.shape.iter().copied().max();
    let mut found = [(0.0, 0.0); 2];
    for (found, edge) in found.iter_mut().zip(TRIAL_EDGES) {
        let step = longest.unwrap_or(1).div_ceil(edge);
        let labels = thinned(&voxels.labels, step);
        let inside = thinned(&voxels.target.inside, step);
        let (seconds, measured) = timed(|| -> Result<_> {
            let print = Print::new(&labels, &inside)?.with_inside(&inside)?;
            Ok(evaluate(&print))
        });
        drop(measured?);
        *found = (labels.values.len() as f64, seconds);
    }
    Ok(CallRate::through(found).per_update_s)
}

/// Every `step`-th voxel along each axis.
fn thinned<T: Copy>(volume: &Volume<T>, step: usize) -> Volume<T> {
    let grid = VolumeGrid {
        shape: volume.grid.shape.map(|n| n.div_ceil(step)),
        pitch_mm: volume.grid.pitch_mm * step as f64,
        center_mm: volume.grid.center_mm,
    };
    let [nz, ny, nx] = grid.shape;
    let mut values = Vec::with_capacity(grid.len());
    for z in 0..nz {
        for y in 0..ny {
            let row = &volume.values[volume.grid.index(z * step, y * step, 0)..];
            values.extend((0..nx).map(|x| row[x * step]));
        }
    }
    Volume { grid, values }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent() -> Extent {
        Extent {
            grid: VolumeGrid::centered([10, 10, 10], 0.1),
            refine: 2,
            frames: 30,
            active_pixels: 500,
            pixels: 2000,
            columns: 600,
            memory: 10,
            fields: 0,
            canvas: 0,
            keeps_walks: false,
            stacked: 0,
        }
    }

    fn rates() -> Rates {
        Rates {
            model: String::new(),
            model_s: 0.25,
            dose: CallRate {
                begin_s: 0.5,
                per_update_s: 1e-3,
            },
            adjoint: CallRate {
                begin_s: 0.1,
                per_update_s: 5e-4,
            },
            updates_per_frame: 100.0,
            objective_s: 0.01,
            vector_s: 1e-5,
            sampling_s: 1e-3,
            measuring_s: 2e-3,
        }
    }

    #[test]
    fn time_is_work_times_rates() {
        let extent = extent();
        let work = Work {
            extent: &extent,
            iterations: 7,
            sub_angles: [1, 4],
            random_paths: false,
            wall_s: None,
        };
        let cost = work.cost(&rates());
        // A dose: 30 frames of 100 updates at 1000/s, and ½ s = 3.5 s; an adjoint: at 2000/s, and 0.1 s. A step: both, 5
        // passes, 44 vectors of 500 pixels
        let step = 3.5 + 1.6 + 5.0 * 0.01 + 44.0 * 500.0 * 1e-5;
        assert!(
            (cost.optimisation_s - (7.0 * step + 4.0 * 3.5 + 0.25)).abs() < 1e-9,
            "{cost:?}"
        );
        // Eight times the voxels, standing and turning (1 + 4 calls); 1.2 measures of each, 2.4 of the own grid's, 1.8 of
        // each pixel; both grids sampled
        let measures = 1000.0 * (1.2 * 8.0 + 2.4) + 1.8 * 2000.0;
        let rest = 8.0 * 5.0 * 3.5 + measures * 2e-3 + 9.0 * 1000.0 * 1e-3 + 4.0 * 0.25;
        assert!((cost.rest_s - rest).abs() < 1e-9, "{cost:?}");
        // Random paths: sixteen times as many, six times on the job's voxels' worth of four and two finer ones
        let paths = Work {
            random_paths: true,
            ..work
        }
        .cost(&rates());
        assert!((paths.rest_s - rest - (16.0 * 8.0 - 40.0) * 3.5).abs() < 1e-9);
        // Averaged frames cost as many calls; a limit of the wall time cuts the iterations, not the rest
        let averaged = Work {
            sub_angles: [3, 4],
            ..work
        }
        .cost(&rates());
        assert!(
            (averaged.optimisation_s - cost.optimisation_s - 2.0 * (7.0 * 5.1 + 4.0 * 3.5)).abs()
                < 1e-9
        );
        let limited = Work {
            wall_s: Some(1.0),
            ..work
        }
        .cost(&rates());
        assert_eq!(
            (limited.optimisation_s, limited.rest_s),
            (1.0 + 4.0 * 3.5 + 0.25, cost.rest_s)
        );
    }

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
    fn frames_of_a_trial_are_neighbours_all_around() {
        assert_eq!(in_groups(5, 16), [0, 1, 2, 3, 4]);
        let chosen = in_groups(400, 16);
        let expected: Vec<usize> = (0..8).chain(200..208).collect();
        assert_eq!(chosen, expected);
        assert!(in_groups(17, 16).windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn memory_is_that_of_the_arrays() {
        let extent = extent();
        let lanes = row_of(10) as f64 * 100.0;
        let [voxels, pixels] = extent.optimisation();
        assert!((voxels - lanes * 21.0 / 1e6).abs() < 1e-12);
        let scratch = 600.0 * row_of(10) as f64 * 4.0;
        // 2m + 4 = 24 vectors of f32
        assert!((pixels - (scratch + 500.0 * 4.0 * 24.0) / 1e6).abs() < 1e-12);
        assert_eq!(whole_mb([300.0, 4.5]), 324);
        // 500 pixels of 10 voxel planes
        let keeping = Extent {
            keeps_walks: true,
            ..extent.clone()
        };
        let walks = keeping.optimisation()[1] - pixels;
        assert!((walks - 500.0 * 1.7 * 10.0 * 16.0 / 1e6).abs() < 1e-12);
        // Two objectives with fields, and 4·10⁶ pixels of canvas that also go to a stack of two bytes each
        let larger = Extent {
            fields: 2,
            canvas: 4_000_000,
            stacked: 2,
            ..extent.clone()
        };
        assert!((larger.optimisation()[0] - lanes * 45.0 / 1e6).abs() < 1e-12);
        assert!((larger.evaluation()[1] - extent.evaluation()[1] - 8.0).abs() < 1e-12);
        assert_eq!(larger.disk_mb(), extent.disk_mb() + 8);
    }

    #[test]
    fn a_thinned_copy_keeps_every_nth_voxel() {
        let grid = VolumeGrid::centered([3, 2, 5], 0.1);
        let values: Vec<u32> = (0..30).collect();
        let thin = thinned(&Volume { grid, values }, 2);
        assert_eq!(thin.grid.shape, [2, 1, 3]);
        assert_eq!(thin.values, [0, 2, 4, 20, 22, 24]);
        assert!((thin.grid.pitch_mm - 0.2).abs() < 1e-15);
    }
}
