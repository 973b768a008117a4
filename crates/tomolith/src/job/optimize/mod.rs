//! The optimization of a job: from voxels to patterns.

pub(crate) mod ceiling;
pub(crate) mod checkpoint;
pub(crate) mod finest;
pub(crate) mod gray_levels;
pub(crate) mod rehearsal;
pub(crate) mod row_balance;
pub(crate) mod stage;
pub(crate) mod start;
pub(crate) mod task;
pub(crate) mod watch;

use crate::error::{Error, Result};
use crate::grid::{PatternGrid, Patterns};
use crate::job::dose::cache;
use crate::job::dose::cache::RunCache;
use crate::job::dose::doses::Exposed;
use crate::job::progress::{Event, Progress};
use crate::job::resolve::free_parameters::FoundResponse;
use crate::job::resolve::identity::fingerprint;
use crate::job::resolve::{ResolvedJob, Voxels, at_section};
use crate::models::Run;
use crate::objective::FoundWindow;
use crate::optimize::start::given::Given;
use crate::optimize::{Checkpoints, Outcome, Row, StopReason};
use ceiling::FoundCeiling;
pub(crate) use ceiling::iterations as iterations_of_ceiling;
use checkpoint::{begin_anew, keep, lost, resumes, tables};
use gray_levels::Levelled;
pub(crate) use stage::Stage;
use stage::{EndOfLevel, SoFar};
use std::path::Path;
use watch::idle;

/// What an optimization came to.
pub(crate) struct Optimized {
    /// Per light, before quantization.
    pub(crate) raw: Vec<Patterns>,
    /// Loss, history, why it ended.
    pub(crate) outcome: Outcome,
    /// Which model, and why.
    pub(crate) model: String,
    /// Voxel-angle updates of one model call.
    pub(crate) updates: u64,
    /// How long measuring prints on the way took, s.
    pub(crate) metrics_s: f64,
    /// The patterns on few levels of the machine, where they were improved on them.
    pub(crate) levels: Option<Levelled>,
    /// How long that took, s.
    pub(crate) levels_s: f64,
    /// The process window of the patterns before they are written, where an objective looks for it.
    pub(crate) window: Option<FoundWindow>,
    /// The response that was found, where its parameters are unknowns.
    pub(crate) found: Option<FoundResponse>,
    /// The ceiling of the pixels, where the program looked for one.
    pub(crate) ceiling: Option<FoundCeiling>,
    /// By how many steps the thresholds of the last iterations lie further apart than those of the job.
    pub(crate) wider: usize,
    /// Warnings, which have been sent.
    pub(crate) warnings: Vec<String>,
}

impl Optimized {
    /// By how much the IoU on the level's voxels rose over the last quarter of the iterations; None where it was not measured.
    pub(crate) fn gain_in_the_end(&self) -> Option<f64> {
        let measured = || {
            self.outcome
                .history
                .iter()
                .filter(|row| row.print.is_some())
        };
        let last = measured().next_back()?;
        let begin = last.iteration - last.iteration.div_ceil(4);
        let before = measured().rfind(|row| row.iteration <= begin)?;
        Some(last.print?.iou? - before.print?.iou?)
    }
}

/// Where a run has its checkpoints, and which.
#[derive(Clone, Copy)]
pub(crate) struct CheckpointPlan<'a> {
    pub(crate) folder: &'a Path,
    /// Whether it goes on from the one that is there.
    pub(crate) resume: bool,
    /// Whether it writes a checkpoint at its end, for a run with more iterations.
    pub(crate) keeps_end: bool,
}

/// Runs the optimizer of a job, or goes on from the checkpoint in its folder. Uses the cached model if it fits this job; otherwise builds one and
/// caches it for the next run.
///
/// # Errors
/// [`Error::Canceled`] and [`Error::NonFinite`] leave the best patterns so far in the checkpoint folder.
pub(crate) fn optimize(
    job: &ResolvedJob,
    voxels: &[Voxels],
    plan: CheckpointPlan<'_>,
    cache: &mut RunCache,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Optimized> {
    let (mut checkpoints, resumed) = open_checkpoints(job, voxels, plan, progress)?;
    let key = cache::key(job, &voxels[0])?;
    let mut evaluation_model = cache.take(key);
    let mut carried: Option<Vec<Patterns>> = None;
    let (mut bounds, mut of_start) = (Vec::new(), Vec::new());
    let mut pixels: Option<Vec<&PatternGrid>> = None;
    let mut sofar = SoFar::default();
    let of_run = (&mut checkpoints, resumed.is_some());
    let mut ceiling = ceiling::find_once(job, voxels, of_run, cancel)?;
    if let Some(found) = &ceiling {
        let text = found.report.sentence();
        progress.event(&Event::Note { text });
    }
    let own_levels = job.own_levels();
    for (i, (level, own_level)) in job.levels.iter().zip(own_levels.as_ref()).enumerate() {
        let is_last = i + 1 == job.levels.len();
        let stage = Stage::new(
            job,
            voxels,
            own_level,
            evaluation_model.take(),
            progress,
            cancel,
        );
        let stage = job.agreed(stage)?;
        let mut stage = stage.shared(job);
        if i == 0 {
            let text = stage.reason.clone();
            progress.event(&Event::Note { text });
        }
        let mut start = None;
        let own = level.lights.iter().map(|light| &light.pixels).collect();
        if pixels.as_ref() != Some(&own) {
            let given = job.own_start(level)?;
            let parts = (&mut *cache, key);
            let brightens = resumed.is_none();
            let first = stage.first_patterns(job, given.as_ref(), brightens, parts, cancel)?;
            (bounds, sofar.first_loss) = (first.bounds, first.loss);
            of_start.clone_from(&bounds);
            let mut x = first.patterns;
            if let Some(found) = &ceiling {
                found.lower(&mut bounds, level);
                start::clip(&mut x, stage.model.patterns(), &bounds)?;
            }
            let goes_on = ceiling.as_mut().filter(|_| i == 0 && resumed.is_none());
            if let Some(found) = goes_on.and_then(FoundCeiling::take_patterns) {
                let is_closer;
                (x, is_closer) = stage.closer(job, (x, &bounds), found, cancel)?;
                if is_closer {
                    sofar.rows = vec![Row::at(job.stop().iterations / ceiling::SHARE)];
                }
            }
            (start, pixels) = (Some(x), Some(own));
        }
        if resumed.is_some_and(|at| i < at) {
            // Its rows stand in the checkpoint, or, with patterns alone, nowhere: the next level still begins where this one ended
            sofar.rows = vec![Row::at(level.until)];
            continue;
        }
        let mut x = match (carried.take(), start) {
            (None, Some(x)) => x,
            (None, None) => stage.model.new_patterns()?,
            (Some(raw), _) => {
                let given = Given(job.own_patterns(level, raw));
                let mut x = stage.start(job, &given, cancel)?;
                start::clip(&mut x, stage.model.patterns(), &bounds)?;
                x
            }
        };
        checkpoints.begin_level(i);
        if let Some(shares) = job.shares(level, stage.model.patterns()) {
            checkpoints.share(shares);
        }
        let ran = stage.run_and_widen(
            job,
            (&mut x, &bounds),
            &mut checkpoints,
            &mut sofar,
            progress,
            cancel,
        );
        let ran = match (ran, &mut ceiling) {
            (Ok(outcome), Some(found))
                if is_last && outcome.reason != StopReason::Canceled && found.is_lower() =>
            {
                let ended = finest::Ended {
                    x: &mut x,
                    bounds: &mut bounds,
                    highest: &of_start,
                    outcome,
                };
                finest::settle(&stage, job, ended, found, &mut sofar, progress, cancel)
            }
            (ran, _) => ran,
        };
        let goes_on = matches!(&ran, Ok(outcome) if outcome.reason != StopReason::Canceled);
        let raw = stage.patterns(&mut x);
        let raw = job.whole_patterns(level, raw, goes_on && !is_last);
        let ended = match ran {
            Ok(outcome) if outcome.reason == StopReason::Canceled => Err(Error::Canceled),
            Ok(outcome) if is_last => {
                let end = stage.end(job, &outcome, (&x, &bounds), &raw, progress, cancel);
                end.map(|end| (outcome, end))
            }
            Ok(outcome) => {
                sofar.rows = outcome.history;
                sofar.counters = outcome.counters;
                carried = Some(raw);
                continue;
            }
            // A checkpoint that does not fit: nothing was done
            Err(error @ Error::Format { .. }) => return Err(begin_anew(error)),
            Err(error) => Err(error),
        };
        return match ended {
            Ok((outcome, end)) => {
                // One that leaves pixels dark does not give the doses of all patterns
                let exposed = Exposed::new(&stage.level.grid, stage.level.lights.clone());
                let key = key.filter(|_| stage.dark.is_empty());
                cache.put(key, exposed, &stage.model, &stage.reason);
                Ok(optimized(
                    job,
                    stage,
                    (raw, outcome, end),
                    (sofar, ceiling),
                    progress,
                ))
            }
            Err(error) => {
                match &error {
                    Error::Device { .. } => lost(plan.folder, progress),
                    // Refused before the first step
                    Error::Unsupported { what, .. } if what.starts_with("stop.") => {}
                    _ => keep(job, &raw, plan.folder, progress, cancel)?,
                }
                Err(at_section("optimizer", error))
            }
        };
    }
    unreachable!("a job has a level")
}

/// The checkpoints of a run, and the level that it goes on in.
fn open_checkpoints(
    job: &ResolvedJob,
    voxels: &[Voxels],
    plan: CheckpointPlan<'_>,
    progress: &mut dyn Progress,
) -> Result<(Checkpoints, Option<usize>)> {
    let tables = tables(job)?;
    let fingerprint = job.agreed(fingerprint(&tables, &voxels[0], &job.base))?;
    job.must_agree(fingerprint)?;
    let checkpoints = Checkpoints::new(plan.folder, fingerprint, job.checkpoint())?;
    let mut checkpoints = checkpoints.describing(tables);
    let resumed = if plan.resume || job.is_first() {
        resumes(&checkpoints, plan.resume, progress)
    } else {
        Ok(None)
    };
    let resumed = job.agreed(resumed)?;
    if resumed.is_none() {
        checkpoints.begin_anew();
    }
    if !plan.keeps_end {
        checkpoints.leave_out_end();
    }
    Ok((checkpoints, resumed))
}

/// The result of an optimization; its warnings have been sent.
fn optimized(
    job: &ResolvedJob,
    stage: Stage<'_>,
    (raw, outcome, end): (Vec<Patterns>, Outcome, EndOfLevel),
    (sofar, ceiling): (SoFar, Option<FoundCeiling>),
    progress: &mut dyn Progress,
) -> Optimized {
    let mut warnings = sofar.warnings;
    let at_end = warnings_at_end(job, &outcome, end.window.as_ref(), stage.found.as_ref());
    let of_ceiling = ceiling.as_ref().and_then(|found| found.report.warning());
    for text in at_end.into_iter().chain(of_ceiling) {
        warnings.push(text.clone());
        progress.event(&Event::Warning { text });
    }
    Optimized {
        raw: end.levelled.unwrap_or(raw),
        levels: end.levels,
        levels_s: end.seconds,
        outcome,
        updates: stage.model.updates(),
        model: stage.reason,
        metrics_s: sofar.metrics_s,
        window: end.window,
        found: stage.found,
        ceiling,
        wider: sofar.wider,
        warnings,
    }
}

/// What people should know of how an optimization ended: that it did nothing, what its process window falls short of, and that a parameter
/// ended at an end of its range.
fn warnings_at_end(
    job: &ResolvedJob,
    outcome: &Outcome,
    window: Option<&FoundWindow>,
    found: Option<&FoundResponse>,
) -> Vec<String> {
    let (normalizes, bits) = (job.method.normalizes, job.bounds().bits);
    let idle = idle(&outcome.history, normalizes, bits);
    let of_window = window.and_then(FoundWindow::warning);
    let of_response = job.method.free.as_ref().zip(found);
    let of_response = of_response.map(|(free, found)| free.at_ends(found));
    let of_response = of_response.into_iter().flatten();
    idle.into_iter()
        .chain(of_window)
        .chain(of_response)
        .collect()
}

#[cfg(test)]
mod tests;
