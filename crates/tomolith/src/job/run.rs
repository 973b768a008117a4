//! Run, simulate, check: the stages of a job in their order.
//!
//! ```text
//! begin      spec → objects that fit together; a folder that is free, or holds this job
//! sample     the target on voxels, what people should be warned of, the dose model that suits
//! optimize   voxels → patterns
//! evaluate   patterns as the machine shows them → what they print
//! finish     files, visible at once
//! ```

pub(crate) mod benchmark;
mod check;
mod clock;
mod cost;
pub(crate) mod many;
pub(crate) mod ranks;
mod simulate;

pub use check::{check, picture};
pub use simulate::simulate;

use super::dose::cache::RunCache;
use super::dose::model_probe::try_orders;
use super::dose::written::Written;
use super::evaluate::{Origin, evaluate_patterns};
use super::optimize::checkpoint::{discard_best, keep};
use super::optimize::{CheckpointPlan, Optimized, optimize};
use super::output::files::{self, Done};
use super::output::folder::{Leaves, RunFolder};
use super::output::replace::must_be_same;
use super::output::summary::{Summary, summary};
use super::progress::{Event, Progress, watched};
use super::resolve::{ResolvedJob, Voxels};
use super::spec::read::Job;
use crate::error::{Error, Result};
use crate::models::Work;
use crate::optimize::checkpoint::CHECKPOINT;
use crate::ranks::{Communicator, together};
use crate::units::{concise, counted};
use clock::{Clock, OPTIMIZING};
use std::sync::Arc;

/// Runs a job from end to end; outputs appear in its run folder.
///
/// # Errors
/// [`Error::Config`], [`Error::Mesh`], [`Error::Resources`], … before any heavy work for input that cannot be used, or a folder
/// that holds a finished run of another job;
/// [`Error::NonFinite`] and [`Error::Canceled`] with the best patterns left in `checkpoint/`; [`Error::Io`].
pub fn run(job: &Job, resume: bool, progress: &mut dyn Progress, work: &Work) -> Result<Summary> {
    run_leaving(job, resume, Leaves::All, progress, work)
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
    work: &Work,
) -> Result<Summary> {
    watched(progress, work, |progress| {
        many::run_here(
            job,
            resume,
            leaves,
            &mut RunCache::default(),
            progress,
            work,
        )
    })
}

/// How a job is run.
#[derive(Clone, Copy)]
struct How<'a> {
    resume: bool,
    leaves: Leaves,
    /// The processes that share the frames of the optimization.
    ranks: Option<&'a Arc<dyn Communicator>>,
}

/// The stages of a run; None on all ranks but the first.
fn stages(
    job: &Job,
    how: How<'_>,
    cache: &mut RunCache,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Option<Summary>> {
    let mut clock = Clock::new(progress, work);
    let mut resolved = begin(job, how, &mut clock)?;
    let folder = match resolved.is_first() {
        true => open(job, &resolved, clock.progress).map(Some),
        false => Ok(None),
    };
    let folder = resolved.agreed(folder)?;
    let sampled = sample(&mut resolved, cache, &mut clock).and_then(|sampled| {
        resolved.must_start(&sampled.0)?;
        Ok(sampled)
    });
    let (voxels, warnings) = resolved.agreed(sampled)?;
    let patterns = optimized(job, &resolved, &voxels, how, cache, &mut clock)?;
    resolved.respond_as(patterns.found.as_ref());
    let Some(folder) = folder else {
        return Ok(None);
    };
    let sampled = Sampled {
        resolved,
        voxels,
        warnings,
    };
    let clocked = &mut clock;
    let done = evaluated(job, sampled, patterns, how.leaves, cache, &folder, clocked)?;
    finish(&done, folder, clock).map(Some)
}

/// The objects of a job whose folder is free.
fn resolved(job: &Job, work: &Work) -> Result<ResolvedJob> {
    RunFolder::check(&job.folder())?;
    ResolvedJob::under(job, work)
}

/// Reads the job, and refuses a folder that holds another one's run.
fn begin(job: &Job, how: How<'_>, clock: &mut Clock<'_>) -> Result<ResolvedJob> {
    clock.stage("reading the job");
    let resolved = resolved(job, clock.work).and_then(|mut resolved| {
        resolved.note_levels();
        clock.work.check()?;
        must_be_same(job, how.resume)?;
        match how.ranks {
            Some(ranks) => resolved.among(ranks),
            None => Ok(resolved),
        }
    });
    match how.ranks {
        Some(ranks) => together(ranks.as_ref(), resolved),
        None => resolved,
    }
}

/// Takes the run folder, and tells what is known so far.
fn open(job: &Job, resolved: &ResolvedJob, progress: &mut dyn Progress) -> Result<RunFolder> {
    let [nz, ny, nx] = resolved.grid.shape;
    let pitch = concise(resolved.grid.pitch_mm);
    let text = format!(
        "{}: {nx} × {ny} × {nz} voxels of {pitch} mm, {}",
        resolved.name,
        counted(resolved.extent.frames, "frame")
    );
    for text in std::iter::once(text).chain(resolved.notes.iter().cloned()) {
        progress.event(&Event::Note { text });
    }
    for text in resolved.warnings.iter().cloned() {
        progress.event(&Event::Warning { text });
    }
    RunFolder::open(&job.folder(), &job.complete().to_toml()?)
}

/// The voxels, and everything that people should be warned of; takes the dose model that suits them.
fn sample(
    resolved: &mut ResolvedJob,
    cache: &mut RunCache,
    clock: &mut Clock<'_>,
) -> Result<(Vec<Voxels>, Vec<String>)> {
    let work = clock.stage("sampling the target");
    let targets = cache.targets(resolved, &work.part(0.72))?;
    let voxels = resolved.voxels_of(targets, &resolved.grid, &work.part(0.08))?;
    let found = resolved.warnings_of(&voxels)?;
    for text in found.iter().cloned() {
        clock.progress.event(&Event::Warning { text });
    }
    let warnings = resolved.warnings.iter().cloned().chain(found).collect();
    try_orders(resolved, clock.progress, &work)?;
    // Another model may not be one that ranks can share
    resolved.must_be_shared()?;
    Ok((voxels, warnings))
}

fn optimized(
    job: &Job,
    resolved: &ResolvedJob,
    voxels: &[Voxels],
    how: How<'_>,
    cache: &mut RunCache,
    clock: &mut Clock<'_>,
) -> Result<Optimized> {
    let stage = clock.stage(OPTIMIZING);
    let checkpoints = CheckpointPlan {
        folder: &RunFolder::checkpoint_in(&job.folder()),
        resume: how.resume,
        keeps_end: how.leaves == Leaves::All,
    };
    optimize(resolved, voxels, checkpoints, cache, clock.progress, &stage)
}

/// A job with its voxels, and what people were warned of.
struct Sampled {
    resolved: ResolvedJob,
    voxels: Vec<Voxels>,
    warnings: Vec<String>,
}

/// What the written patterns print.
fn evaluated<'a>(
    job: &'a Job,
    sampled: Sampled,
    optimized: Optimized,
    leaves: Leaves,
    cache: &RunCache,
    folder: &RunFolder,
    clock: &mut Clock<'_>,
) -> Result<Done<'a>> {
    let Sampled {
        resolved,
        voxels,
        mut warnings,
    } = sampled;
    warnings.extend(optimized.warnings.clone());
    let stage = clock.stage("evaluating the written patterns");
    let levels = optimized.levels.as_ref();
    let asked = levels.map_or(&optimized.raw, |levels| &levels.asked);
    let patterns = Written::of_raw(asked.clone(), &resolved)?;
    let evaluated = evaluate_patterns(
        &resolved,
        &voxels,
        &patterns.shown,
        Origin {
            raw: Some(&optimized.raw),
            model: cache.evaluation_model(),
            is_optimized: true,
        },
        clock.progress,
        &stage,
    );
    if evaluated.is_err() {
        // The dearest part is done: nobody should lose it to a Ctrl-C that came too late
        let place = folder.checkpoint();
        keep(&resolved, &optimized.raw, &place, clock.progress, &stage)?;
    }
    Ok(Done {
        job,
        resolved,
        voxels,
        patterns,
        evaluated: evaluated?,
        optimized: Some(optimized),
        source: None,
        leaves,
        warnings,
    })
}

/// Writes everything, and makes it visible at once.
fn finish(done: &Done<'_>, folder: RunFolder, mut clock: Clock<'_>) -> Result<Summary> {
    let stage = clock.stage("writing");
    let timings = clock.timings(done.optimized.as_ref());
    let written = files::all(done, &folder, timings, clock.progress, &stage)
        .map_err(|e| missing(e, &done.resolved, &folder));
    let written = written.and_then(|headline| stage.check().map(|()| headline));
    if let (Err(error), Some(optimized)) = (&written, &done.optimized) {
        let place = folder.checkpoint();
        let saved = keep(
            &done.resolved,
            &optimized.raw,
            &place,
            clock.progress,
            &stage,
        );
        // Where the disk is full, what could not be written first is the news
        if matches!(error, Error::Canceled) {
            saved?;
        }
    }
    let summary = summary(done, written?, folder.path(), clock.begin);
    let checkpoint = folder.checkpoint();
    folder.publish()?;
    if done.leaves < Leaves::All && checkpoint.exists() {
        std::fs::remove_dir_all(&checkpoint).map_err(|e| Error::io(&checkpoint, e))?;
    }
    discard_best(&checkpoint)?;
    Ok(summary)
}

/// Says of a disk that is full what is missing now, and what is left to go on from.
fn missing(error: Error, resolved: &ResolvedJob, folder: &RunFolder) -> Error {
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
                resolved.extent.disk_mb()
            );
            Error::io(path, std::io::Error::new(source.kind(), text))
        }
        other => other,
    }
}

#[cfg(test)]
mod tests;
