//! Which iterate of a run its patterns are.
//!
//! A method that never raises its loss ends at its best. Of any other one the best iterate is stored next to the present one, by the
//! measure that the method improves:
//!
//! - one that descends the loss: the lowest loss;
//! - one that [normalizes](super::Optimizer::normalizes) its doses, and whose loss is only reported: the best print on the job's
//!   voxels, as [`quick`] sees it. That is the best IoU over thresholds, and where it is 1 the widest process window. Row 0 of its
//!   history is the job's `[start]`, at another scale and no iterate of the method, so it is never kept. A gray target has no IoU: its
//!   last iterate is the result.
//!
//! Of equal iterates the later one wins.
//!
//! **Cost** one more pattern field for methods that may raise the loss; a pass over the dose a step where the print decides.

use super::{Optimizer, Position, Problem};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::field::Field;
use tomolith_core::target::label;
use tomolith_metrics::quick::{Quick, quick};

/// Which patterns a run returns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Keep {
    /// The best by the measure that the method improves.
    #[default]
    Best,
    /// Those of the last step.
    Last,
}

/// What the patterns of a run are the best of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum KeptBy {
    /// The lowest loss.
    Loss,
    /// The best IoU on the job's voxels; where that is 1, the widest process window.
    Print,
    /// The last step.
    Last,
}

/// The iterate that a run returned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct KeptIterate {
    /// Steps that led to it.
    pub iteration: usize,
    /// Why it is the result.
    pub by: KeptBy,
}

impl KeptBy {
    /// The reason in words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            KeptBy::Loss => "lowest loss",
            KeptBy::Print => "best IoU on the job's voxels",
            KeptBy::Last => "the last",
        }
    }
}

/// The best iterate so far, as a checkpoint holds it.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
pub(super) struct Best {
    iteration: usize,
    pub(super) loss: f64,
    /// What was measured of it; lower is better.
    score: f64,
    /// Parameters of its response, where these are unknowns.
    #[serde(default)]
    pub(super) response: Vec<f64>,
}

impl Best {
    fn at<F: Field>(problem: &Problem<F>, at: &Position<F>, iteration: usize, score: f64) -> Self {
        Best {
            iteration,
            loss: at.loss,
            score,
            response: problem.response_values().to_vec(),
        }
    }
}

/// What iterates are compared by.
enum Measure {
    Loss,
    /// Labels of the model's voxels.
    Print(Vec<u8>),
    Last,
}

impl Measure {
    fn of<F: Field>(problem: &Problem<F>, optimizer: &dyn Optimizer<F>, keep: Keep) -> Self {
        if optimizer.is_monotone() || !optimizer.normalizes() && keep == Keep::Best {
            return Measure::Loss;
        }
        match keep {
            Keep::Last => Measure::Last,
            Keep::Best => labels(problem).map_or(Measure::Last, Measure::Print),
        }
    }

    /// How good a position is; lower is better.
    fn score<F: Field>(&self, problem: &Problem<F>, at: &Position<F>) -> f64 {
        let Measure::Print(labels) = self else {
            return at.loss;
        };
        let dose = at.dose.to_host();
        let dose = problem.model().outputs()[0].voxels_of(&dose);
        match quick(labels, &dose) {
            Some(Quick {
                process_window: Some(window),
                ..
            }) if window >= 0.0 => -1.0 - window,
            Some(Quick { iou, .. }) => -iou,
            None => f64::MAX,
        }
    }
}

/// Part and void as the target of a problem has them; None without a target, and for gray values.
fn labels<F: Field>(problem: &Problem<F>) -> Option<Vec<u8>> {
    let target = problem.target().ok()?.to_host();
    // A target is that of one dose
    let [output] = problem.model().outputs() else {
        return None;
    };
    let voxels = output.voxels();
    let label = |&value: &f32| match value {
        1.0 => Some(label::PART),
        0.0 => Some(label::VOID),
        value if value < 0.0 => Some(label::OUTSIDE),
        _ => None,
    };
    target[..voxels].iter().map(label).collect()
}

/// Keeps the best iterate of a run.
pub(super) struct Keeper<F> {
    measure: Measure,
    /// Whether no step can lose the best patterns.
    is_safe: bool,
    best: Best,
    /// The best patterns, when they are not the present ones.
    patterns: Option<F>,
}

impl<F: Field> Keeper<F> {
    /// At the start of a run.
    pub(super) fn new(
        problem: &Problem<F>,
        optimizer: &dyn Optimizer<F>,
        keep: Keep,
        at: &Position<F>,
    ) -> Self {
        let measure = Measure::of(problem, optimizer, keep);
        let score = match measure {
            Measure::Loss => at.loss,
            _ => f64::MAX,
        };
        Keeper {
            measure,
            is_safe: optimizer.is_monotone(),
            best: Best::at(problem, at, 0, score),
            patterns: None,
        }
    }

    /// As a checkpoint left it.
    pub(super) fn resume(&mut self, best: Best, patterns: Option<F>) {
        (self.best, self.patterns) = (best, patterns);
    }

    pub(super) fn best(&self) -> &Best {
        &self.best
    }

    /// The best patterns, when they are not the present ones.
    pub(super) fn patterns(&self) -> Option<&F> {
        self.patterns.as_ref()
    }

    /// The present patterns are the best: the model has become another one, and what was measured before says nothing.
    pub(super) fn begin_anew(&mut self, problem: &Problem<F>, at: &Position<F>, iteration: usize) {
        self.patterns = None;
        self.best = Best::at(problem, at, iteration, self.measure.score(problem, at));
    }

    /// Before a step: the patterns, where the step could lose the best of them.
    pub(super) fn before(&self, x: &F) -> Option<F> {
        (!self.is_safe && self.patterns.is_none()).then(|| x.clone())
    }

    /// After a step that failed.
    pub(super) fn go_back(&mut self, before: Option<F>) {
        if before.is_some() {
            self.patterns = before;
        }
    }

    /// After a step that led to a position.
    pub(super) fn after(
        &mut self,
        problem: &Problem<F>,
        at: &Position<F>,
        iteration: usize,
        before: Option<F>,
    ) {
        let score = self.measure.score(problem, at);
        if score <= self.best.score || matches!(self.measure, Measure::Last) {
            self.patterns = None;
            self.best = Best::at(problem, at, iteration, score);
        } else {
            self.go_back(before);
        }
    }

    /// Leaves the best patterns in `x`.
    pub(super) fn end(self, x: &mut F) -> KeptIterate {
        if let Some(best) = self.patterns {
            *x = best;
        }
        KeptIterate {
            iteration: self.best.iteration,
            by: match self.measure {
                Measure::Loss => KeptBy::Loss,
                Measure::Print(_) => KeptBy::Print,
                Measure::Last => KeptBy::Last,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cal::{Cal, Params};
    use crate::checkpoint;
    use crate::reference::{FREE, Scripted};
    use crate::start::StartInput;
    use crate::{Checkpoints, Limits, Outcome, Stop, run};
    use serde_json::json;
    use std::sync::Arc;
    use tomolith_core::check::{self, small::SmallModel};
    use tomolith_core::dose::Work;
    use tomolith_core::error::{Error, Result};
    use tomolith_core::field::HostField;
    use tomolith_core::response::Identity;
    use tomolith_objective::check::of_ring;

    /// A run on the ring, whose target may be made gray: patterns, print, and what the run says.
    fn go(
        optimizer: &mut dyn Optimizer<HostField>,
        stop: Stop,
        gray: bool,
        checkpoints: Option<&mut Checkpoints>,
    ) -> (HostField, f64, Result<Outcome>) {
        let model = SmallModel::new(16, 24, 1);
        let (target, labels) = model.ring();
        let objective = of_ring(&model, "osmo", json!({}), Arc::new(Identity));
        let input = StartInput::new(&model, &target, &labels, &FREE);
        let mut target = input.target_field().unwrap();
        if gray {
            target.scale(0.5);
        }
        let flag = Work::new();
        let mut problem = Problem::new(&model, &*objective, &[Limits::default()], &flag)
            .unwrap()
            .with_target(target);
        let mut x = check::even_patterns(&model, 0.5);
        let outcome = run(&mut problem, optimizer, &mut x, &stop, checkpoints, &mut []);
        let dose = check::dose(&model, &x);
        let dose = model.layout().volume_of(dose.as_slice());
        let iou = quick(&labels.values, &dose.values).unwrap().iou;
        (x, iou, outcome)
    }

    const SCRIPT: [(f32, f64); 4] = [(0.0, 1.0), (1.0, 3.0), (0.0, 2.0), (0.0, 4.0)];

    /// A method that normalizes its doses: so much of the target's projection its patterns are (the rest is even light).
    fn scripted(script: &[(f32, f64)]) -> Scripted<f32> {
        Scripted {
            script: script.to_vec(),
            show: |share, problem, x| {
                let (target, mut projected) = (problem.target()?.clone(), x.zeros_like());
                problem.project(x, &target, &mut projected)?;
                x.fill(1.0 - share);
                x.axpy(share / projected.max_abs(), &projected);
                Ok(())
            },
            normalizes: true,
            done: 0,
        }
    }

    fn steps(iterations: usize, keep: Keep) -> Stop {
        Stop {
            keep,
            ..Stop::after(iterations)
        }
    }

    #[test]
    fn a_method_whose_loss_only_watches_is_kept_by_its_print() {
        let (_, worst, _) = go(&mut scripted(&SCRIPT), steps(1, Keep::Best), false, None);
        let (_, best, outcome) = go(&mut scripted(&SCRIPT), steps(4, Keep::Best), false, None);
        let outcome = outcome.unwrap();
        assert!(best > worst + 0.1, "{best} is not above {worst}");
        let by = KeptBy::Print;
        assert_eq!(outcome.kept, KeptIterate { iteration: 2, by });
        assert_eq!(outcome.loss, 3.0);
        // Row 0 is not its own, however good its loss
        let (_, _, outcome) = go(
            &mut scripted(&[(0.0, 1e9)]),
            steps(1, Keep::Best),
            false,
            None,
        );
        assert_eq!(outcome.unwrap().kept.iteration, 1);
    }

    #[test]
    fn the_last_is_kept_where_it_is_asked_for_and_where_nothing_says_which_is_best() {
        let by = KeptBy::Last;
        for (keep, gray) in [(Keep::Last, false), (Keep::Best, true)] {
            let (x, _, outcome) = go(&mut scripted(&SCRIPT), steps(4, keep), gray, None);
            assert_eq!(outcome.unwrap().kept, KeptIterate { iteration: 4, by });
            assert!(x.as_slice().iter().all(|&v| v == 1.0), "even light");
        }
    }

    #[test]
    fn a_step_that_fails_leaves_the_patterns_before_it() {
        let script = [(1.0, 3.0), (0.0, f64::NAN)];
        let (x, ..) = go(&mut scripted(&script), steps(1, Keep::Last), false, None);
        for keep in [Keep::Last, Keep::Best] {
            let (before, _, outcome) = go(&mut scripted(&script), steps(9, keep), false, None);
            assert!(
                matches!(outcome, Err(Error::NonFinite { iteration: 2, .. })),
                "{outcome:?}"
            );
            assert_eq!(before.as_slice(), x.as_slice(), "{keep:?}");
        }
    }

    #[test]
    fn a_resumed_run_keeps_the_iterate_of_the_uninterrupted_one() {
        let cal = || {
            let params = Params {
                learning_rate: 0.5,
                momentum: 0.5,
                d_h: 0.4,
                ..Params::default()
            };
            Cal::new(params).unwrap()
        };
        let (x, _, whole) = go(&mut cal(), steps(12, Keep::Best), false, None);
        let whole = whole.unwrap();
        let lowest = (1..=12).min_by(|&a, &b| {
            let loss = |row: usize| whole.history[row].loss;
            loss(a).total_cmp(&loss(b))
        });
        assert!(
            whole.kept.iteration < 12 && Some(whole.kept.iteration) != lowest,
            "{:?}, lowest loss at {lowest:?}: the test shows nothing",
            whole.kept
        );
        let folder = tempfile::tempdir().unwrap();
        for part in 1..=12 {
            let params = checkpoint::Params::default();
            let mut checkpoints = Checkpoints::new(folder.path(), 1, &params).unwrap();
            let stop = steps(part, Keep::Best);
            let (again, _, outcome) = go(&mut cal(), stop, false, Some(&mut checkpoints));
            if part == 12 {
                assert_eq!(again.as_slice(), x.as_slice());
                assert_eq!(outcome.unwrap().kept, whole.kept);
            }
        }
    }
}
