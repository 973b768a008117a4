//! `simulate`: what given patterns print under a job; everything but the optimization.

use super::clock::Clock;
use super::{finish, open, resolved, sample};
use crate::error::{Error, Result};
use crate::io::read_text;
use crate::job::dose::cache::RunCache;
use crate::job::dose::written;
use crate::job::evaluate::{Origin, evaluate_patterns};
use crate::job::output::files::Done;
use crate::job::output::folder::{Leaves, RunFolder};
use crate::job::output::summary::Summary;
use crate::job::progress::{Progress, watched};
use crate::job::resolve::ResolvedJob;
use crate::job::spec::read::Job;
use crate::models::Work;
use crate::units::concise;
use serde_json::Value;
use std::path::Path;

/// Simulates patterns of an earlier run under a job; everything but the optimization.
///
/// The outputs go next to the run, into a folder of its name with `-simulated`, or to a folder that the command line names:
/// never into the folder of a run, whose history and checkpoint belong to other patterns.
///
/// # Errors
/// [`Error::Config`] when the named folder holds a run;
/// As [`run`](fn@super::run); [`Error::Shape`] and [`Error::Format`] for patterns that do not fit the job's lights.
pub fn simulate(
    job: &Job,
    source: &Path,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Summary> {
    watched(progress, work, |progress| {
        simulate_stages(job, source, progress, work).map_err(|e| job.locate(e))
    })
}

fn simulate_stages(
    job: &Job,
    source: &Path,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Summary> {
    let mut clock = Clock::new(progress, work);
    clock.stage("reading the job and the patterns");
    let job = &beside_the_run(job)?;
    let mut resolved = resolved(job, work)?;
    let (patterns, notes) = written::read(&resolved, source, work)?;
    // A dose too large or too small only moves the threshold; in time it prints something else
    let is_in_time = resolved.schedule().is_some();
    let texts = match is_in_time {
        true => &mut resolved.warnings,
        false => &mut resolved.notes,
    };
    texts.extend(notes);
    let doubts = written::doubts_of_frames(&resolved, &patterns)?;
    resolved.warnings.extend(doubts);
    let report = report_beside(source);
    respond_as_found(&mut resolved, report.as_ref())?;
    let pitch_mm = report.and_then(|report| report.pointer("/evaluation/grid/pitch_mm")?.as_f64());
    let other = pitch_mm.and_then(|pitch_mm| other_voxels(&resolved, pitch_mm));
    resolved.warnings.extend(other);
    work.check()?;
    let folder = open(job, &resolved, clock.progress)?;
    let (voxels, warnings) = sample(&mut resolved, &mut RunCache::default(), &mut clock)?;
    let stage = clock.stage("evaluating the patterns");
    let evaluated = evaluate_patterns(
        &resolved,
        &voxels,
        &patterns.shown,
        Origin {
            raw: patterns.raw.as_deref(),
            ..Origin::default()
        },
        clock.progress,
        &stage,
    )?;
    let done = Done {
        job,
        resolved,
        voxels,
        patterns,
        evaluated,
        optimized: None,
        source: Some(source),
        leaves: Leaves::All,
        warnings,
    };
    finish(&done, folder, clock)
}

/// The report of the run that the patterns are from, where it stands beside them.
fn report_beside(source: &Path) -> Option<Value> {
    let folder = if source.is_dir() {
        source
    } else {
        source.parent()?
    };
    let text = read_text(folder.join("report.json")).ok()?;
    serde_json::from_str(&text).ok()
}

/// Warns where the run of the patterns was evaluated on voxels of another pitch.
fn other_voxels(resolved: &ResolvedJob, pitch_mm: f64) -> Option<String> {
    let [grid, fine] = [resolved.grid.pitch_mm, resolved.fine_grid().pitch_mm];
    let refine = grid / pitch_mm;
    let is_whole = (refine - refine.round()).abs() < 1e-6 && refine > 0.5;
    ((pitch_mm / fine - 1.0).abs() > 1e-6).then(|| {
        let same = match is_whole {
            true => format!("evaluate.refine = {} gives those of the run", refine.round()),
            false => "the same [grid] and evaluate.refine give those of the run".to_owned(),
        };
        format!(
            "the run of these patterns was evaluated on voxels of {} mm, this print is on voxels of {} mm: finer voxels see more errors, so the two do not compare; {same}",
            concise(pitch_mm),
            concise(fine)
        )
    })
}

/// Takes the response that the run found whose patterns these are, where its parameters were unknowns.
fn respond_as_found(resolved: &mut ResolvedJob, report: Option<&Value>) -> Result<()> {
    let Some(free) = resolved.method.free.clone() else {
        return Ok(());
    };
    let found = report.map(|report| free.found_by(report)).transpose()?;
    let found = found.flatten();
    resolved.notes.push(match &found {
        Some(found) => format!("the response is the one found with the patterns: {}", found.sentence()),
        None => "the folder of the patterns has no report.json with a fitted response: the response is that of the job, without [co_optimize]".to_owned(),
    });
    resolved.respond_as(found.as_ref());
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
        return Err(Error::config(
            "output.folder",
            format!(
                "`{}` holds a run: a simulation would mix with it",
                folder.display()
            ),
            "another folder; without one it is the job's with `-simulated` at its end",
        ));
    }
    Ok(job.clone())
}
