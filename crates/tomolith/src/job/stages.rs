//! The stages of a run: target → voxels → patterns → judgement → files.

use super::estimate::{self, Extent};
use super::folder::RunFolder;
use super::judge::judge;
use super::optimise::optimise;
use super::outcome::{Plan, Quality, Summary};
use super::progress::{Event, Progress};
use super::read::Job;
use super::scene::{Scene, Voxels};
use super::write::{self, Done, Written};
use crate::error::{Error, Result};
use crate::exposure::quantise;
use crate::grid::Patterns;
use crate::io::npy::read_patterns;
use crate::metrics::Evaluation;
use crate::models::{Run, matrix, planner};
use crate::report::Timing;
use std::path::Path;
use std::time::Instant;

/// Model calls of one iteration: an adjoint and a forward call.
const CALLS_PER_ITERATION: f64 = 2.0;
/// Share of the time that is not spent in the model: optimiser, metrics, files.
const OVERHEAD: f64 = 0.25;

/// Writes the matrix of a job's dose model as SciPy's CSR `.npz` (see [`models::matrix`](crate::models::matrix)); returns
/// its number of rows, columns and entries. All pixels count, not only those that help to print the part.
///
/// # Errors
/// As [`check`], and [`matrix::export`].
pub fn export_matrix(job: &Job, path: &Path, cancel: &Run) -> Result<[usize; 3]> {
    let scene = Scene::new(job)?;
    let optics = &scene.optics;
    let grid = scene.grid.clone();
    let lights = optics.lights.clone();
    let plan = planner::plan(
        &optics.model,
        optics.vial.as_ref(),
        lights,
        grid,
        None,
        cancel,
    )
    .map_err(|e| job.locate(e))?;
    matrix::export(plan.model.as_ref(), path, cancel)
}

/// Runs a job from end to end; outputs appear in its run folder.
///
/// # Errors
/// [`Error::Config`], [`Error::Mesh`], [`Error::Resources`], … before any heavy work for input that cannot be used;
/// [`Error::NonFinite`] and [`Error::Cancelled`] with the best patterns kept in `checkpoint/`; [`Error::Io`].
pub fn run(job: &Job, resume: bool, progress: &mut dyn Progress, cancel: &Run) -> Result<Summary> {
    let mut clock = Clock::new(progress);
    clock.stage("reading the job");
    let scene = Scene::new(job)?;
    let folder = open(job, &scene, clock.progress)?;
    clock.stage("sampling the target");
    let (voxels, warnings) = voxels(job, &scene, clock.progress)?;
    clock.stage("optimising");
    let optimised = optimise(&scene, &voxels, &folder, resume, clock.progress, cancel)
        .map_err(|e| job.locate(e))?;
    clock.stage("evaluating the written patterns");
    let patterns = Written::quantised(optimised.raw.clone(), scene.spec.evaluate.bit_depth)?;
    let judged = judge(
        &scene,
        &voxels,
        &patterns.shown,
        patterns.raw.as_deref(),
        clock.progress,
        cancel,
    )?;
    let done = Done {
        job,
        scene,
        voxels,
        patterns,
        judged,
        optimised: Some(optimised),
        warnings,
    };
    finish(done, folder, clock)
}

/// Simulates patterns of an earlier run under a job; everything but the optimisation.
///
/// # Errors
/// As [`run`]; [`Error::Shape`] and [`Error::Format`] for patterns that do not fit the job's lights.
pub fn simulate(
    job: &Job,
    patterns: &Path,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Summary> {
    let mut clock = Clock::new(progress);
    clock.stage("reading the job and the patterns");
    let scene = Scene::new(job)?;
    let patterns = read(&scene, patterns)?;
    let folder = open(job, &scene, clock.progress)?;
    clock.stage("sampling the target");
    let (voxels, warnings) = voxels(job, &scene, clock.progress)?;
    clock.stage("evaluating the patterns");
    let judged = judge(
        &scene,
        &voxels,
        &patterns.shown,
        patterns.raw.as_deref(),
        clock.progress,
        cancel,
    )?;
    let done = Done {
        job,
        scene,
        voxels,
        patterns,
        judged,
        optimised: None,
        warnings,
    };
    finish(done, folder, clock)
}

/// Writes everything, and makes it visible at once.
fn finish(done: Done<'_>, folder: RunFolder, mut clock: Clock<'_>) -> Result<Summary> {
    clock.stage("writing");
    let timings = clock.timings();
    write::all(&done, &folder, timings, clock.progress)?;
    let summary = summary(&done, folder.path(), clock.begin);
    folder.publish()?;
    Ok(summary)
}

/// Tells the stages, and keeps how long they took.
struct Clock<'p> {
    begin: Instant,
    stages: Vec<(&'static str, Instant)>,
    progress: &'p mut dyn Progress,
}

impl<'p> Clock<'p> {
    fn new(progress: &'p mut dyn Progress) -> Self {
        Clock {
            begin: Instant::now(),
            stages: Vec::new(),
            progress,
        }
    }

    fn stage(&mut self, name: &'static str) {
        self.stages.push((name, Instant::now()));
        self.progress.event(&Event::Stage {
            name: name.to_owned(),
        });
    }

    /// The stages that are over.
    fn timings(&self) -> Vec<Timing> {
        let ends = self.stages.iter().skip(1).map(|(_, begin)| *begin);
        let pairs = self.stages.iter().zip(ends);
        pairs
            .map(|((name, begin), end)| Timing {
                name: (*name).to_owned(),
                seconds: (end - *begin).as_secs_f64(),
            })
            .collect()
    }
}

/// Validates a job and says what it will cost, without running it.
///
/// # Errors
/// As [`run`], for input that cannot be used.
pub fn check(job: &Job, cancel: &Run) -> Result<Plan> {
    let scene = Scene::new(job)?;
    let voxels = scene.voxels(&scene.grid).map_err(|e| job.locate(e))?;
    let mut warnings = scene.warnings.clone();
    warnings.extend(
        scene
            .optics
            .warnings(&voxels.target.inside, &voxels.labels, voxels.target.grey)
            .map_err(|e| job.locate(e))?,
    );
    let speed = estimate::speed(&scene.optics, &scene.grid, cancel)?;
    let [x, y, z] = [2, 1, 0].map(|axis| scene.grid.shape[axis]);
    let refine = scene.extent.refine;
    Ok(Plan {
        part: scene.name.clone(),
        model: speed.model,
        voxels: [x, y, z],
        pitch_mm: scene.grid.pitch_mm,
        evaluation_voxels: [x * refine, y * refine, z * refine],
        frames: scene.extent.frames,
        pixels: scene.extent.pixels,
        active_pixels: scene.extent.active_pixels,
        memory_mb: scene
            .extent
            .optimisation_mb()
            .max(scene.extent.evaluation_mb()),
        available_memory_mb: super::resources::available_memory_mb(),
        disk_mb: scene.extent.disk_mb(),
        seconds: seconds(&scene, &scene.extent, speed.updates_per_s, speed.lit),
        updates_per_s: speed.updates_per_s,
        notes: scene.notes.clone(),
        warnings,
    })
}

/// Time of a whole run.
fn seconds(scene: &Scene, extent: &Extent, updates_per_s: f64, lit: f64) -> f64 {
    let call = (extent.grid.len() * extent.frames) as f64 * lit;
    let evaluate = &scene.spec.evaluate;
    let fine = extent.refine.pow(3) as f64 * (1 + evaluate.sub_angles) as f64;
    let calls = CALLS_PER_ITERATION * scene.spec.stop.iterations as f64 + fine + 1.0;
    let limit = scene.spec.stop.wall_s.unwrap_or(f64::INFINITY);
    let model = (calls * call / updates_per_s).min(limit + fine * call / updates_per_s);
    model * (1.0 + OVERHEAD) + extent.measure_s()
}

/// Takes the run folder, and tells what is known so far.
fn open(job: &Job, scene: &Scene, progress: &mut dyn Progress) -> Result<RunFolder> {
    let [nz, ny, nx] = scene.grid.shape;
    let pitch = scene.grid.pitch_mm;
    let text = format!(
        "{}: {nx} × {ny} × {nz} voxels of {pitch:.4} mm, {} frames",
        scene.name, scene.extent.frames
    );
    for text in std::iter::once(text).chain(scene.notes.iter().cloned()) {
        progress.event(&Event::Note { text });
    }
    for text in scene.warnings.iter().cloned() {
        progress.event(&Event::Warning { text });
    }
    RunFolder::open(&job.folder(), &job.resolved().to_toml()?)
}

/// The voxels, and everything that people should be warned of.
fn voxels(job: &Job, scene: &Scene, progress: &mut dyn Progress) -> Result<(Voxels, Vec<String>)> {
    let voxels = scene.voxels(&scene.grid).map_err(|e| job.locate(e))?;
    let (inside, labels) = (&voxels.target.inside, &voxels.labels);
    let found = scene
        .optics
        .warnings(inside, labels, voxels.target.grey)
        .map_err(|e| job.locate(e))?;
    for text in found.iter().cloned() {
        progress.event(&Event::Warning { text });
    }
    let warnings = scene
        .warnings
        .iter()
        .chain(&scene.notes)
        .cloned()
        .chain(found)
        .collect();
    Ok((voxels, warnings))
}

/// Patterns of a file, one set per light of the job.
fn read(scene: &Scene, path: &Path) -> Result<Written> {
    let arrays = read_patterns(path)?;
    let (mut shown, mut raw) = (Vec::new(), Vec::new());
    for (i, light) in scene.optics.lights.iter().enumerate() {
        let name = scene.light_name(i);
        let found = arrays
            .iter()
            .find(|a| a.light.as_deref() == name)
            .ok_or_else(|| Error::Format {
                path: path.to_owned(),
                found: format!(
                    "no patterns for the light {}",
                    name.unwrap_or("(the only one)")
                ),
                accepted: "one array `patterns`, or `patterns_<light>` for each light of the job"
                    .to_owned(),
            })?;
        let grid = &light.pixels;
        if found.shape != grid.shape() {
            return Err(Error::Shape {
                what: format!("{}: patterns [angle, row, column]", path.display()),
                expected: grid.shape().to_vec(),
                found: found.shape.to_vec(),
            });
        }
        shown.push(Patterns {
            grid: grid.clone(),
            values: found.shown.clone(),
        });
        raw.extend(found.raw.clone().map(|values| Patterns {
            grid: grid.clone(),
            values,
        }));
    }
    let bits = scene.spec.evaluate.bit_depth;
    let quantised = shown
        .iter()
        .map(|patterns| quantise(patterns, bits))
        .collect::<Result<_>>()?;
    let raw = (raw.len() == shown.len()).then_some(raw);
    Ok(Written {
        quantised,
        shown,
        raw,
    })
}

fn summary(done: &Done<'_>, folder: &Path, begin: Instant) -> Summary {
    let optimised = done.optimised.as_ref();
    Summary {
        folder: folder.to_owned(),
        iterations: optimised
            .and_then(|o| o.outcome.history.last())
            .map(|row| row.iteration),
        stopped: optimised.map(|o| o.outcome.reason),
        evaluation: quality(&done.judged.evaluation),
        standing: quality(&done.judged.standing),
        optimisation: done.judged.optimisation.as_ref().map(quality),
        required_iou: done.scene.spec.evaluate.require_iou,
        seconds: begin.elapsed().as_secs_f64(),
    }
}

fn quality(evaluation: &Evaluation) -> Quality {
    let get = |name| evaluation.measures.get(name);
    Quality {
        iou: get("iou"),
        ver: get("ver"),
        pw: get("pw"),
        threshold: evaluation.gel_threshold,
    }
}
