//! An optimization up to its first iteration, for `check`: what a run refuses there, `check` refuses with the same words.

use super::stage::{SoFar, Stage};
use crate::error::{Error, Result};
use crate::job::dose::cache::RunCache;
use crate::job::progress::Silent;
use crate::job::resolve::refinement::Level;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::models::Run;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// How long it may take.
const LONGEST: Duration = Duration::from_secs(3);
/// How often a request to stop is looked for.
const PAUSE: Duration = Duration::from_millis(20);

/// Makes the model, the start, the bounds and the first loss of every level, as [`optimize`](crate::job::optimize::optimize) does; whether there was time for all of it.
///
/// # Errors
/// What [`optimize`](crate::job::optimize::optimize) refuses before its first step; [`Error::Canceled`].
pub(crate) fn rehearse(job: &ResolvedJob, voxels: &[Voxels], cancel: &Run) -> Result<bool> {
    let limited = Run::new();
    let done = thread::scope(|threads| {
        let (over, wait) = channel::<()>();
        let limited = &limited;
        threads.spawn(move || {
            let begin = Instant::now();
            while wait.recv_timeout(PAUSE) == Err(RecvTimeoutError::Timeout) {
                if cancel.is_canceled() || begin.elapsed() > LONGEST {
                    limited.cancel();
                    // The second request breaks into what is done patiently
                    limited.cancel();
                }
            }
        });
        let done = (job.levels.iter()).try_for_each(|level| begin(job, voxels, level, limited));
        drop(over);
        done
    });
    cancel.check()?;
    match done {
        Err(Error::Canceled) => Ok(false),
        done => done.map(|()| true),
    }
}

/// A level up to its first iteration.
fn begin(job: &ResolvedJob, voxels: &[Voxels], level: &Level, run: &Run) -> Result<()> {
    let level = Level {
        until: 0,
        ..level.clone()
    };
    let silent = &mut Silent;
    let stage = Stage::new(job, voxels, &level, None, silent, run)?;
    let given = job.own_start(&level)?;
    let parts = (&mut RunCache::default(), None);
    let first = stage.first_patterns(job, given.as_ref(), true, parts, run)?;
    let (mut x, bounds) = (first.patterns, first.bounds);
    let sofar = &mut SoFar::default();
    stage.run((job, 0, 0), (&mut x, &bounds), None, sofar, silent, run)?;
    Ok(())
}
