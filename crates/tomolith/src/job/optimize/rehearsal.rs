//! The begin of an optimization, for `check`: what a run refuses before its first iteration, `check` refuses with the same words. Where there is time, the first
//! iterations are timed: they hold all that a job does in an iteration.

use super::stage::{Around, SoFar, Stage};
use crate::error::{Error, Result};
use crate::job::dose::cache::RunCache;
use crate::job::progress::Silent;
use crate::job::resolve::refinement::Level;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::models::Work;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// How long it may take.
const LONGEST: Duration = Duration::from_secs(3);
/// Iterations of each level that are timed.
const TIMED: usize = 2;
/// How often a request to stop is looked for.
const PAUSE: Duration = Duration::from_millis(20);

/// What was tried of an optimization.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Rehearsal {
    /// Whether there was time for what comes before the first iteration of every level.
    pub(crate) is_tried: bool,
    /// What all iterations take at the pace of the first ones of their level, s, and so many more on the finest; None where there was no time for them.
    pub(crate) iterations_s: Option<f64>,
}

/// Makes the model, the start, the bounds and the first loss of every level, as [`optimize`](crate::job::optimize::optimize) does, and some iterations; `more` iterations are counted
/// on the finest level.
pub(crate) fn rehearse(
    job: &ResolvedJob,
    voxels: &[Voxels],
    more: usize,
    work: &Work,
) -> Result<Rehearsal> {
    let limited = Work::new();
    let done = thread::scope(|threads| {
        let (over, wait) = channel::<()>();
        let limited = &limited;
        threads.spawn(move || {
            let begin = Instant::now();
            while wait.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
                if work.is_canceled() || begin.elapsed() > LONGEST {
                    limited.cancel();
                    // The second request breaks into what is done patiently
                    limited.cancel();
                }
            }
        });
        let of_levels = |iterations| -> Result<Vec<f64>> {
            let levels = job.levels.iter();
            let pace = |level| pace(job, voxels, level, iterations, limited);
            levels.map(pace).collect()
        };
        let done = of_levels(0).map(|_| of_levels(TIMED).ok());
        drop(over);
        done
    });
    work.check()?;
    let paces = match done {
        Err(Error::Canceled) => return Ok(Rehearsal::default()),
        done => done?,
    };
    let all = |paces: Vec<f64>| {
        let mut before = 0;
        let of_levels = job.levels.iter().zip(&paces).map(|(level, pace)| {
            let iterations = level.until - std::mem::replace(&mut before, level.until);
            iterations as f64 * pace
        });
        of_levels.sum::<f64>() + more as f64 * paces.last().copied().unwrap_or(0.0)
    };
    Ok(Rehearsal {
        is_tried: true,
        iterations_s: paces.map(all),
    })
}

/// Some first iterations of a level, and what each of them takes, s.
fn pace(
    job: &ResolvedJob,
    voxels: &[Voxels],
    level: &Level,
    iterations: usize,
    work: &Work,
) -> Result<f64> {
    let level = Level {
        until: iterations,
        ..level.clone()
    };
    let silent = &mut Silent;
    let stage = Stage::new(job, voxels, &level, None, silent, work)?;
    let given = job.own_start(&level)?;
    let cache = &mut RunCache::default();
    let first = stage.first_patterns(given.as_ref(), true, cache, None, work)?;
    let (mut x, bounds) = (first.patterns, first.bounds);
    let (begin, sofar) = (Instant::now(), &mut SoFar::default());
    let around = Around {
        until: iterations,
        wider: 0,
        change: 0.0,
        bounds: &bounds,
        checkpoints: None,
        sofar,
        progress: silent,
        work,
    };
    let ran = stage.run(&mut x, around)?;
    work.check()?;
    // What begins them takes as long as another one
    let done = ran.history.last().map_or(0, |row| row.iteration) + 1;
    Ok(begin.elapsed().as_secs_f64() / done as f64)
}
