//! The stages of a run: target → voxels → patterns → judgment → files.

pub(crate) mod benchmark;
pub(crate) mod cost;
pub(crate) mod many;
pub(crate) mod ranks;
pub mod resolved;

use super::output::folder::Leaves;
use super::progress::stage;
use crate::error::{Error, Result};
use crate::io::read_text;
use crate::job::dose::cache::KeptParts;
use crate::job::dose::model_probe::try_orders;
use crate::job::dose::written as device;
use crate::job::dose::written::Written;
use crate::job::evaluate::evaluate_patterns;
use crate::job::evaluate::in_time::InTime;
use crate::job::evaluate::limits::Fall;
use crate::job::optimize::checkpoint::keep;
use crate::job::optimize::{CheckpointPlan, Optimized, iterations_of_ceiling, optimize, rehearse};
use crate::job::output::files as write;
use crate::job::output::files::{Done, Headline};
use crate::job::output::folder::RunFolder;
use crate::job::output::replace::must_be_same;
use crate::job::output::summary::{GrayQuality, Plan, Quality, SpeciesSummary, Summary};
use crate::job::progress::{Event, Progress, watched};
use crate::job::resolve::{Scene, Voxels};
use crate::job::run::cost::{Work, mean_sub_angles};
use crate::job::run::ranks::must_fit;
use crate::job::spec::read::Job;
use crate::metrics::Evaluation;
use crate::models::Run;
use crate::optimize::checkpoint::CHECKPOINT;
use crate::optimize::{Counters, KeptBy};
use crate::ranks::{Communicator, together};
use crate::report::number::significant;
use crate::report::{Timing, time_sentence};
use crate::units::{concise, counted};

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// The stage whose parts are told apart.
const OPTIMIZING: &str = "optimizing";

/// Runs a job from end to end; outputs appear in its run folder.
///
/// # Errors
/// [`Error::Config`], [`Error::Mesh`], [`Error::Resources`], … before any heavy work for input that cannot be used, or a folder
/// that holds a finished run of another job;
/// [`Error::NonFinite`] and [`Error::Canceled`] with the best patterns kept in `checkpoint/`; [`Error::Io`].
pub fn run(job: &Job, resume: bool, progress: &mut dyn Progress, cancel: &Run) -> Result<Summary> {
    run_leaving(job, resume, Leaves::All, progress, cancel)
}

/// Runs a job as [`run`] does; only some of its outputs appear in the run folder.
///
/// # Errors
/// As [`run`].
pub fn run_leaving(
    job: &Job,
    resume: bool,
    leaves: Leaves,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Summary> {
    watched(progress, cancel, |progress| {
        let kept = &mut KeptParts::default();
        run_stages(job, resume, leaves, kept, progress, cancel)
    })
}

pub(crate) fn run_stages(
    job: &Job,
    resume: bool,
    leaves: Leaves,
    kept: &mut KeptParts,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Summary> {
    let mut clock = Clock::new(progress, cancel);
    let mut scene = begin(job, resume, &mut clock)?;
    let folder = open(job, &scene, clock.progress)?;
    let sampled = sample(job, &mut scene, kept, &mut clock)?;
    let optimized = optimized(job, &scene, &sampled.0, (resume, leaves), kept, &mut clock)?;
    scene.respond_as(optimized.found.as_ref());
    let of = (scene, sampled);
    evaluate(job, of, (optimized, kept), leaves, folder, clock)
}

/// The stages of one of several ranks; the first one goes on to the end.
pub(crate) fn run_shared(
    job: &Job,
    resume: bool,
    leaves: Leaves,
    ranks: &Arc<dyn Communicator>,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Option<Summary>> {
    let mut clock = Clock::new(progress, cancel);
    let begun = begin(job, resume, &mut clock);
    let begun = begun.and_then(|scene| scene.among(ranks).map_err(|e| job.locate(e)));
    let mut scene = together(ranks.as_ref(), begun)?;
    let folder = match ranks.is_first() {
        true => open(job, &scene, clock.progress).map(Some),
        false => Ok(None),
    };
    let folder = scene.agreed(folder)?;
    let kept = &mut KeptParts::default();
    let sampled = sample(job, &mut scene, kept, &mut clock);
    // The scene's model probe may have taken another model
    let still_fits = |sampled| match must_fit(&scene, ranks.as_ref()) {
        Ok(()) => Ok(sampled),
        Err(error) => Err(job.locate(error)),
    };
    let sampled = scene.agreed(sampled.and_then(still_fits))?;
    let optimized = optimized(job, &scene, &sampled.0, (resume, leaves), kept, &mut clock)?;
    scene.respond_as(optimized.found.as_ref());
    let of = (scene, sampled);
    let evaluated = |folder| evaluate(job, of, (optimized, kept), leaves, folder, clock);
    folder.map(evaluated).transpose()
}

/// The objects of a job whose folder is free.
fn resolved(job: &Job, cancel: &Run) -> Result<Scene> {
    RunFolder::check(&job.folder()).map_err(|e| job.locate(e))?;
    Scene::new(job, cancel)
}

/// Reads the job, and refuses a folder that holds another one's run.
fn begin(job: &Job, resume: bool, clock: &mut Clock<'_>) -> Result<Scene> {
    clock.stage("reading the job");
    let mut scene = resolved(job, clock.cancel)?;
    scene.note_levels();
    clock.cancel.check()?;
    must_be_same(job, resume)?;
    Ok(scene)
}

/// The voxels, and what people should be warned of.
fn sample(
    job: &Job,
    scene: &mut Scene,
    kept: &mut KeptParts,
    clock: &mut Clock<'_>,
) -> Result<(Voxels, Vec<String>)> {
    let stage = clock.stage("sampling the target");
    let sampled = voxels(job, scene, kept, clock.progress, &stage)?;
    scene.must_start(&sampled.0).map_err(|e| job.locate(e))?;
    try_orders(scene, clock.progress, &stage).map_err(|e| job.locate(e))?;
    Ok(sampled)
}

/// The patterns.
fn optimized(
    job: &Job,
    scene: &Scene,
    voxels: &Voxels,
    (resume, leaves): (bool, Leaves),
    kept: &mut KeptParts,
    clock: &mut Clock<'_>,
) -> Result<Optimized> {
    let stage = clock.stage(OPTIMIZING);
    let checkpoints = CheckpointPlan {
        folder: &RunFolder::checkpoint_in(&job.folder()),
        resume,
        keeps_end: leaves == Leaves::All,
    };
    let progress = &mut *clock.progress;
    let optimized = optimize(scene, voxels, checkpoints, kept, progress, &stage);
    optimized.map_err(|e| job.locate(e))
}

/// Evaluates the patterns, and writes everything.
fn evaluate(
    job: &Job,
    (scene, (voxels, mut warnings)): (Scene, (Voxels, Vec<String>)),
    (optimized, kept): (Optimized, &KeptParts),
    leaves: Leaves,
    folder: RunFolder,
    mut clock: Clock<'_>,
) -> Result<Summary> {
    warnings.extend(optimized.warnings.clone());
    let stage = clock.stage("evaluating the written patterns");
    let levels = optimized.levels.as_ref();
    let asked = levels.map_or(&optimized.raw, |levels| &levels.asked);
    let patterns = Written::of_raw(asked.clone(), &scene)?;
    let evaluated = evaluate_patterns(
        &scene,
        &voxels,
        &patterns.shown,
        Some(&optimized.raw),
        kept.evaluation_model(),
        clock.progress,
        &stage,
    );
    if evaluated.is_err() {
        // The dearest part is done: nobody should lose it to a Ctrl-C that came too late
        let place = folder.checkpoint();
        keep(&scene, &optimized.raw, &place, clock.progress, &stage)?;
    }
    let evaluated = evaluated?;
    let done = Done {
        job,
        scene,
        voxels,
        patterns,
        evaluated,
        optimized: Some(optimized),
        source: None,
        leaves,
        warnings,
    };
    finish(done, folder, clock)
}

/// Simulates patterns of an earlier run under a job; everything but the optimization.
///
/// The outputs go beside the run, to its folder's name with `-simulated`, or to a folder that the command line names:
/// never into the folder of a run, whose history and checkpoint belong to other patterns.
///
/// # Errors
/// [`Error::Config`] when the named folder holds a run;
/// As [`run`]; [`Error::Shape`] and [`Error::Format`] for patterns that do not fit the job's lights.
pub fn simulate(
    job: &Job,
    source: &Path,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Summary> {
    watched(progress, cancel, |progress| {
        simulate_stages(job, source, progress, cancel)
    })
}

fn simulate_stages(
    job: &Job,
    source: &Path,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Summary> {
    let mut clock = Clock::new(progress, cancel);
    clock.stage("reading the job and the patterns");
    let job = &beside_the_run(job)?;
    let mut scene = resolved(job, cancel)?;
    let (patterns, notes) = device::read(&scene, source, cancel)?;
    scene.notes.extend(notes);
    respond_as_found(&mut scene, source)?;
    cancel.check()?;
    let folder = open(job, &scene, clock.progress)?;
    let stage = clock.stage("sampling the target");
    let kept = &mut KeptParts::default();
    let (voxels, warnings) = voxels(job, &scene, kept, clock.progress, &stage)?;
    try_orders(&mut scene, clock.progress, &stage).map_err(|e| job.locate(e))?;
    let stage = clock.stage("evaluating the patterns");
    let evaluated = evaluate_patterns(
        &scene,
        &voxels,
        &patterns.shown,
        patterns.raw.as_deref(),
        None,
        clock.progress,
        &stage,
    )?;
    let done = Done {
        job,
        scene,
        voxels,
        patterns,
        evaluated,
        optimized: None,
        source: Some(source),
        leaves: Leaves::All,
        warnings,
    };
    finish(done, folder, clock)
}

/// Takes the response that the run found whose patterns these are, where its parameters were unknowns.
fn respond_as_found(scene: &mut Scene, source: &Path) -> Result<()> {
    let Some(free) = scene.kinds.free.clone() else {
        return Ok(());
    };
    let folder = if source.is_dir() {
        Some(source)
    } else {
        source.parent()
    };
    let report = folder.and_then(|folder| read_text(folder.join("report.json")).ok());
    let report = report.and_then(|text| serde_json::from_str(&text).ok());
    let found = report.map(|report| free.found_by(&report)).transpose()?;
    let found = found.flatten();
    scene.notes.push(match &found {
        Some(found) => format!("the response is the one found with the patterns: {}", found.sentence()),
        None => "no run with a response that was found lies beside the patterns: the response is that of the job, without [co_optimize]".to_owned(),
    });
    scene.respond_as(found.as_ref());
    Ok(())
}

/// The job with a folder that holds no run.
fn beside_the_run(job: &Job) -> Result<Job> {
    let folder = job.folder();
    if job.document.option("output.folder").is_none() {
        let mut name = folder.clone().into_os_string();
        name.push("-simulated");
        let mut job = job.clone();
        job.spec.output.folder = Some(name.into());
        return Ok(job);
    }
    if RunFolder::holds_a_run(&folder) {
        return Err(job.locate(Error::config(
            "output.folder",
            format!(
                "`{}` holds a run: a simulation would mix with it",
                folder.display()
            ),
            "another folder; without one it is the job's with `-simulated` at its end",
        )));
    }
    Ok(job.clone())
}

/// Writes everything, and makes it visible at once.
fn finish(done: Done<'_>, folder: RunFolder, mut clock: Clock<'_>) -> Result<Summary> {
    let stage = clock.stage("writing");
    let timings = clock.timings(done.optimized.as_ref());
    let written = write::all(&done, &folder, timings, clock.progress, &stage)
        .map_err(|e| missing(e, &done.scene, &folder));
    let written = written.and_then(|headline| stage.check().map(|()| headline));
    if let (Err(error), Some(optimized)) = (&written, &done.optimized) {
        let place = folder.checkpoint();
        let kept = keep(&done.scene, &optimized.raw, &place, clock.progress, &stage);
        // Where the disk is full, what could not be written first is the news
        if matches!(error, Error::Canceled) {
            kept?;
        }
    }
    let summary = summary(&done, written?, folder.path(), clock.begin);
    let checkpoint = folder.checkpoint();
    folder.publish()?;
    if done.leaves < Leaves::All && checkpoint.exists() {
        std::fs::remove_dir_all(&checkpoint).map_err(|e| Error::io(&checkpoint, e))?;
    }
    Ok(summary)
}

/// Says of a disk that is full what is missing now, and what is left to go on from.
fn missing(error: Error, scene: &Scene, folder: &RunFolder) -> Error {
    let is_full = error.is_full_disk();
    match error {
        Error::Io { path, source } if is_full => {
            let rest = if folder.checkpoint().join(CHECKPOINT).exists() {
                "`--resume` then goes on from the checkpoint"
            } else {
                "there was no room for a checkpoint either, so the run must begin anew"
            };
            let text = format!(
                "{source}; patterns, frames, dose, print and report of this run are missing, and what the folder held before is as \
                 it was: make room for {} MB, {rest}",
                scene.extent.disk_mb()
            );
            Error::io(path, std::io::Error::new(source.kind(), text))
        }
        other => other,
    }
}

/// Tells the stages, and keeps how long they took.
struct Clock<'p> {
    begin: Instant,
    stages: Vec<(&'static str, Instant)>,
    progress: &'p mut dyn Progress,
    cancel: &'p Run,
}

impl<'p> Clock<'p> {
    fn new(progress: &'p mut dyn Progress, cancel: &'p Run) -> Self {
        Clock {
            begin: Instant::now(),
            stages: Vec::new(),
            progress,
            cancel,
        }
    }

    /// Begins a stage; what it returns is the whole of it.
    fn stage(&mut self, name: &'static str) -> Run {
        self.stages.push((name, Instant::now()));
        stage(self.progress, self.cancel, name)
    }

    /// The stages that are over; behind the optimization its parts.
    fn timings(&self, optimized: Option<&Optimized>) -> Vec<Timing> {
        let ends = self.stages.iter().skip(1).map(|(_, begin)| *begin);
        let mut timings = Vec::new();
        for ((name, begin), end) in self.stages.iter().zip(ends) {
            let seconds = (end - *begin).as_secs_f64();
            timings.push(Timing {
                name: (*name).to_owned(),
                seconds,
            });
            let of_it = optimized.filter(|_| *name == OPTIMIZING);
            timings.extend(
                of_it
                    .and_then(|own| parts_of(seconds, own))
                    .into_iter()
                    .flatten(),
            );
        }
        timings
    }
}

/// Where the time of an optimization went; None when some of it was spent before a resume.
fn parts_of(seconds: f64, optimized: &Optimized) -> Option<Vec<Timing>> {
    let in_loop = optimized.outcome.history.last()?.seconds;
    let Counters {
        model_s,
        objective_s,
        ..
    } = optimized.outcome.counters;
    let (metrics_s, levels_s) = (optimized.metrics_s, optimized.levels_s);
    let ceiling_s = optimized
        .ceiling
        .as_ref()
        .map_or(0.0, |found| found.seconds);
    let parts = [
        ("ceiling of the pixels", ceiling_s),
        ("pixels and start", seconds - in_loop - levels_s - ceiling_s),
        ("dose and adjoint", model_s),
        ("objective", objective_s),
        ("metrics", metrics_s),
        (
            "steps, checkpoints",
            in_loop - model_s - objective_s - metrics_s,
        ),
        ("levels", levels_s),
    ];
    let is_known = parts.iter().all(|(_, seconds)| *seconds >= 0.0);
    let is_done = |name: &str| match name {
        "ceiling of the pixels" => optimized.ceiling.is_some(),
        "levels" => optimized.levels.is_some(),
        _ => true,
    };
    is_known.then(|| {
        let timing = |(name, seconds): &(&str, f64)| Timing {
            name: format!("{OPTIMIZING}: {name}"),
            seconds: *seconds,
        };
        let done = parts.iter().filter(|(name, _)| is_done(name));
        done.map(timing).collect()
    })
}

/// Validates a job and says what it will cost, without running it.
///
/// # Errors
/// As [`run`], for input that cannot be used.
pub fn check(job: &Job, progress: &mut dyn Progress, cancel: &Run) -> Result<Plan> {
    watched(progress, cancel, |progress| {
        check_stages(job, progress, cancel)
    })
}

fn check_stages(job: &Job, progress: &mut dyn Progress, cancel: &Run) -> Result<Plan> {
    stage(progress, cancel, "reading the job");
    let mut scene = resolved(job, cancel)?;
    scene.note_levels();
    let sampling = stage(progress, cancel, "sampling the target");
    let begin = Instant::now();
    let voxels = (scene.voxels_under(&scene.grid, &sampling)).map_err(|e| job.locate(e))?;
    let sampling_s = begin.elapsed().as_secs_f64();
    scene.must_start(&voxels).map_err(|e| job.locate(e))?;
    try_orders(&mut scene, progress, &sampling).map_err(|e| job.locate(e))?;
    let trying = stage(progress, cancel, "trying the start of the optimization").aside();
    if !rehearse(&scene, &voxels, &trying).map_err(|e| job.locate(e))? {
        let text = "the start of the optimization takes too long to be tried here: a run may still find fault with it";
        scene.notes.push(text.to_owned());
    }
    let mut warnings = scene.warnings.clone();
    warnings.extend(scene.warnings_of(&voxels).map_err(|e| job.locate(e))?);
    // How much there is to time is not known beforehand
    let timing = stage(progress, cancel, "timing a few frames on this machine").aside();
    let rates =
        benchmark::rates(&scene, &voxels, sampling_s, &timing).map_err(|e| job.locate(e))?;
    let paths = scene.optics.family(&scene.grid)?.monte_carlo_paths();
    let of_ceiling = iterations_of_ceiling(&scene, &voxels);
    scene.notes.extend(print_time(&scene, of_ceiling));
    let work = Work {
        extent: &scene.extent,
        iterations: scene.spec.stop.iterations + of_ceiling,
        sub_angles: [
            mean_sub_angles(&scene.optics.lights),
            scene.spec.evaluate.sub_angles as f64,
        ],
        monte_carlo_paths: paths.map(|paths| paths.evaluating / paths.optimizing),
        levels: scene.spec.evaluate.improves_levels(),
        wall_s: scene.spec.stop.wall_s,
    };
    let cost = work.cost(&rates);
    if scene.spec.schedule.is_some() {
        let text = "the seconds are those without the print in time, which comes on top";
        scene.notes.push(text.to_owned());
    }
    let memory_budget_mb =
        crate::job::resolve::resources::memory_budget_mb(scene.spec.resources.memory_gb);
    if let Some((text, is_much)) = work.of_scenarios(&rates, memory_budget_mb) {
        let told = if is_much {
            &mut warnings
        } else {
            &mut scene.notes
        };
        told.push(text);
    }
    let [x, y, z] = [2, 1, 0].map(|axis| scene.grid.shape[axis]);
    let refine = scene.extent.refine;
    Ok(Plan {
        part: scene.name.clone(),
        model: rates.model,
        voxels: [x, y, z],
        pitch_mm: scene.grid.pitch_mm,
        evaluation_voxels: [x * refine, y * refine, z * refine],
        frames: scene.extent.frames,
        pixels: scene.extent.pixels,
        active_pixels: scene.extent.active_pixels,
        memory_mb: scene
            .extent
            .optimization_mb()
            .max(scene.extent.evaluation_mb()),
        memory_budget_mb,
        disk_mb: scene.extent.disk_mb(),
        seconds: cost.optimization_s + cost.rest_s,
        iterations: scene.spec.stop.iterations,
        optimization_s: cost.optimization_s,
        updates_per_s: 1.0 / rates.calls.dose.per_update_s,
        notes: scene.notes.clone(),
        warnings,
    })
}

/// What is known of the print's time before a run; None where nothing is.
fn print_time(scene: &Scene, of_ceiling: usize) -> Option<String> {
    if of_ceiling > 0 {
        return Some(format!(
            "the run looks for the lowest ceiling of the pixels at which the part prints as well, which takes as long as some {of_ceiling} iterations: the print time M/t is known \
             then. bounds.max or printer.time_s set it beforehand"
        ));
    }
    let (largest, [lower, upper]) = (scene.spec.bounds.max?, scene.kinds.thresholds()?);
    let threshold = scene.spec.evaluate.threshold;
    let gel = threshold.unwrap_or_else(|| f64::midpoint(lower, upper));
    let is_dose = scene.response().is_identity() && gel > 0.0;
    is_dose.then(|| {
        format!(
            "the print time M/t is at most about {} mm: bounds.max over a gel dose of {}",
            significant(largest / gel, 3),
            significant(gel, 3)
        )
    })
}

/// Takes the run folder, and tells what is known so far.
fn open(job: &Job, scene: &Scene, progress: &mut dyn Progress) -> Result<RunFolder> {
    let [nz, ny, nx] = scene.grid.shape;
    let pitch = concise(scene.grid.pitch_mm);
    let text = format!(
        "{}: {nx} × {ny} × {nz} voxels of {pitch} mm, {}",
        scene.name,
        counted(scene.extent.frames, "frame")
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
fn voxels(
    job: &Job,
    scene: &Scene,
    kept: &mut KeptParts,
    progress: &mut dyn Progress,
    run: &Run,
) -> Result<(Voxels, Vec<String>)> {
    let target = kept.target(scene, &run.part(0.72));
    let voxels = target.and_then(|target| scene.voxels_of(target, &scene.grid, &run.part(0.08)));
    let voxels = voxels.map_err(|e| job.locate(e))?;
    let found = scene.warnings_of(&voxels).map_err(|e| job.locate(e))?;
    for text in found.iter().cloned() {
        progress.event(&Event::Warning { text });
    }
    let warnings = scene.warnings.iter().cloned().chain(found).collect();
    Ok((voxels, warnings))
}

fn summary(done: &Done<'_>, headline: Headline, folder: &Path, begin: Instant) -> Summary {
    let optimized = done.optimized.as_ref();
    Summary {
        folder: folder.to_owned(),
        report: match done.leaves {
            Leaves::All => "report.html",
            Leaves::Metrics | Leaves::Patterns => "report.json",
        },
        iterations: optimized
            .and_then(|o| o.outcome.history.last())
            .map(|row| row.iteration),
        stopped: optimized.map(|o| o.outcome.reason),
        fall: optimized
            .filter(|o| o.outcome.kept.by == KeptBy::Loss)
            .and_then(|o| Fall::of(&o.outcome.history)),
        kept: optimized.map(|o| o.outcome.kept),
        gap: optimized.and_then(|o| o.outcome.gap()),
        found_window: optimized.and_then(|o| o.window),
        found_response: optimized.and_then(|o| Some(o.found.as_ref()?.sentence())),
        evaluation: quality(&done.evaluated.evaluation),
        standing: quality(&done.evaluated.standing),
        optimization: done.evaluated.optimization.as_ref().map(quality),
        exposure: headline.exposures.first().copied().flatten(),
        species: species(done, &headline),
        one_exposure: headline.one_exposure,
        in_time: done
            .evaluated
            .in_time
            .iter()
            .flat_map(InTime::summary)
            .collect(),
        one_moment: done.evaluated.in_time.as_ref().and_then(InTime::together),
        scenarios: done.evaluated.scenarios.clone(),
        print_time: time_sentence(
            done.evaluated.evaluation.measures.get("time_mm"),
            optimized.and_then(|o| Some(&o.ceiling.as_ref()?.report)),
        ),
        limits: headline.limits.into_iter().next().unwrap_or_default(),
        required_iou: done.scene.spec.evaluate.require_iou,
        required_in_band: done.scene.spec.evaluate.require_in_band,
        evaluation_voxels: [2, 1, 0].map(|axis| done.evaluated.evaluation.grid.shape[axis]),
        evaluation_pitch_mm: done.evaluated.evaluation.grid.pitch_mm,
        refine: done.scene.extent.refine,
        seconds: begin.elapsed().as_secs_f64(),
    }
}

/// Every species, where the job names several.
fn species(done: &Done<'_>, headline: &Headline) -> Vec<SpeciesSummary> {
    if done.evaluated.others.is_empty() {
        return Vec::new();
    }
    let others = done.evaluated.others.iter().map(|other| &other.evaluation);
    let all = std::iter::once(&done.evaluated.evaluation).chain(others);
    let of = |(s, evaluation): (usize, &Evaluation)| SpeciesSummary {
        name: done.scene.species_name(s).unwrap_or_default().to_owned(),
        evaluation: quality(evaluation),
        exposure: headline.exposures[s],
        limits: headline.limits[s].clone(),
    };
    all.enumerate().map(of).collect()
}

fn quality(evaluation: &Evaluation) -> Quality {
    let get = |name| evaluation.measures.get(name);
    Quality {
        iou: get("iou"),
        ver: get("ver"),
        pw: get("pw"),
        threshold: evaluation.gel_threshold,
        gray: evaluation.half_width.map(|half_width| GrayQuality {
            half_width,
            in_band: get("in_band"),
            rms_error: get("rms_error"),
            max_error_part: get("max_error_part"),
            max_error_void: get("max_error_void"),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cancels when a stage begins, and remembers what is told.
    struct Canceler<'r> {
        at: &'static str,
        run: &'r Run,
        stages: Vec<String>,
    }

    impl Progress for Canceler<'_> {
        fn event(&mut self, event: &Event) {
            if let Event::Stage { name } = event {
                self.stages.push(name.clone());
                if name == self.at {
                    self.run.cancel();
                }
            }
        }
    }

    #[test]
    fn a_request_to_stop_ends_the_stage_at_hand() {
        let place = tempfile::tempdir().unwrap();
        let file = place.path().join("job.toml");
        let text = r#"
            target = { phantom = "gyroid", size_mm = 2.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 2.0 } }
            light = [{ pixels = [24, 24], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
            objective = { threshold = {} }
            stop = { iterations = 3 }
        "#;
        std::fs::write(&file, text).unwrap();
        let job = Job::read(&file, &[]).unwrap();
        let stages = [
            "reading the job",
            "sampling the target",
            OPTIMIZING,
            "evaluating the written patterns",
            "writing",
        ];
        for (i, at) in stages.into_iter().enumerate() {
            let folder = place.path().join(i.to_string());
            let run = Run::new();
            let mut canceler = Canceler {
                at,
                run: &run,
                stages: Vec::new(),
            };
            let job = job.clone().with_folder(&folder, "--output");
            let ended = super::run(&job, false, &mut canceler, &run);
            assert!(matches!(ended, Err(Error::Canceled)), "{at}: {ended:?}");
            assert_eq!(canceler.stages, stages[..=i], "{at}");
            // Of a run whose patterns are there they are kept; nothing else is left
            assert_eq!(
                folder.join("checkpoint/patterns.npz").exists(),
                i >= 3,
                "{at}"
            );
            for name in ["report.json", "patterns.npz", "dose.npy", ".new"] {
                assert!(!folder.join(name).exists(), "{at}: {name}");
            }
        }
    }
}
