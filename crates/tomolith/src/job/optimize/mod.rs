//! The optimization of a job: from voxels to patterns.

pub(crate) mod ceiling;
pub(crate) mod checkpoint;
pub(crate) mod finest;
pub(crate) mod gray_levels;
pub(crate) mod rehearsal;
pub(crate) mod row_balance;
mod search;
pub(crate) mod stage;
pub(crate) mod start;
pub(crate) mod task;
pub(crate) mod watch;

use crate::error::Result;
use crate::grid::Patterns;
use crate::job::dose::cache::RunCache;
use crate::job::progress::Progress;
use crate::job::resolve::free_parameters::FoundResponse;
use crate::job::resolve::identity::{fingerprint, without_names};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::models::Work;
use crate::objective::FoundWindow;
use crate::optimize::{Checkpoints, Outcome, Row, StopReason};
use ceiling::FoundCeiling;
pub(crate) use ceiling::iterations as iterations_of_ceiling;
use checkpoint::{CARD, resumes, tables};
use gray_levels::Levelled;
use search::Search;
pub(crate) use stage::Stage;
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
/// What ends it early leaves the best patterns so far in the checkpoint folder.
pub(crate) fn optimize(
    job: &ResolvedJob,
    voxels: &[Voxels],
    plan: CheckpointPlan<'_>,
    cache: &mut RunCache,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Optimized> {
    let (checkpoints, resumed) = open_checkpoints(job, voxels, plan, progress)?;
    let mut search = Search::begin(job, voxels, checkpoints, resumed, cache, progress, work)?;
    let shares = job.own_levels();
    for (i, (level, share)) in job.levels.iter().zip(shares.as_ref()).enumerate() {
        let stage = search.stage(i, share)?;
        let start = search.start(i, level, &stage)?;
        if resumed.is_some_and(|at| i < at) {
            // Its rows stand in the checkpoint, or, with patterns alone, nowhere: the next level still begins where this one ended
            search.sofar.rows = vec![Row::at(level.until)];
            continue;
        }
        let mut x = search.patterns(level, &stage, start)?;
        let ran = search.run(i, level, &stage, &mut x);
        let ran = ran.map(|outcome| match outcome.reason {
            StopReason::Canceled => None,
            _ => Some(outcome),
        });
        let is_last = i + 1 == job.levels.len();
        let goes_on = !is_last && matches!(ran, Ok(Some(_)));
        let raw = job.whole_patterns(level, stage.patterns(&mut x), goes_on);
        match ran {
            Ok(Some(outcome)) if goes_on => search.carry(outcome, raw),
            ran => return search.end(stage, ran, &x, raw, plan.folder),
        }
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
    let mut tables = tables(job)?;
    let fingerprint = job.agreed(fingerprint(&tables, &voxels[0], &job.base))?;
    job.must_agree(fingerprint)?;
    let checkpoints = Checkpoints::new(plan.folder, fingerprint, job.checkpoint())?;
    let card = job.optics.card.as_ref();
    if let Some(card) = card {
        tables[CARD] = card.version().into();
    }
    let mut checkpoints = checkpoints.describing(without_names(tables));
    let resumed = if plan.resume || job.is_first() {
        resumes(&checkpoints, plan.resume, card, progress)
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
