//! The stages of a run, and where its time went.

use crate::job::optimize::Optimized;
use crate::job::progress::{Progress, stage};
use crate::models::Work;
use crate::optimize::Counters;
use crate::report::Timing;
use std::time::Instant;

/// The stage whose parts are timed separately.
pub(crate) const OPTIMIZING: &str = "optimizing";

/// Announces the stages, and records how long they took.
pub(crate) struct Clock<'p> {
    pub(crate) begin: Instant,
    stages: Vec<(&'static str, Instant)>,
    pub(crate) progress: &'p mut dyn Progress,
    pub(crate) work: &'p Work,
}

impl<'p> Clock<'p> {
    pub(crate) fn new(progress: &'p mut dyn Progress, work: &'p Work) -> Self {
        Clock {
            begin: Instant::now(),
            stages: Vec::new(),
            progress,
            work,
        }
    }

    /// Begins a stage; what it returns is the whole of it.
    pub(crate) fn stage(&mut self, name: &'static str) -> Work {
        self.stages.push((name, Instant::now()));
        stage(self.progress, self.work, name)
    }

    /// The stages that are over; behind the optimization its parts.
    pub(crate) fn timings(&self, optimized: Option<&Optimized>) -> Vec<Timing> {
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
                    .and_then(|optimized| parts_of(seconds, optimized))
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
