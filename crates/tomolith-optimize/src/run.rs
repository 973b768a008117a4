//! The loop around an optimizer: stopping, history, observers, the best patterns, checkpoints.

use super::checkpoint::{Checkpoint, Checkpoints, Contents, DiskSpace, Saved};
use super::keep::{Keep, Keeper, KeptBy, KeptIterate};
use super::{Counters, Gap, Optimizer, Position, Problem};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::time::Instant;
use tomolith_core::dose::Renewal;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;
use tomolith_core::kind::check_ranges;
use tomolith_core::work::Work;

tomolith_core::keys! {
    /// `[stop]` of a job: when to stop. A loss of zero always stops.
    pub struct Stop {
        /// Largest number of steps
        pub iterations: usize = 45,
        /// Stop when the norm of the projected gradient falls below this part of its first value; 0: never
        #[schemars(range(min = 0.0))]
        pub projected_gradient: f64 = 0.0,
        /// Stop when the mean change of the loss over the last five steps falls to this part of the loss; 0: never;
        /// 0.001 is Li et al. (2024), eq. 28
        #[schemars(range(min = 0.0))]
        pub change: f64 = 0.0,
        /// Steps after which `change` is looked at; 0: as soon as there are five
        pub change_after: usize = 0,
        /// Rise of the IoU over five steps or more, where observers measure it, above which `change` does not stop
        #[schemars(range(min = 0.0, max = 1.0))]
        pub rise: Option<f64>,
        /// Stop when no patterns can have a loss lower than that of these by more than this part of it; 0: never; convex problems only
        #[schemars(extend("minimum" = 0.0, "exclusiveMaximum" = 1.0))]
        pub gap: f64 = 0.0,
        /// Stop when the loss falls to this part of the first one; 0: only at 0
        #[schemars(extend("minimum" = 0.0, "exclusiveMaximum" = 1.0))]
        pub relative_loss: f64 = 0.0,
        /// The loss that counts as the first one, where it is not that of the start
        pub first_loss: Option<f64>,
        /// Stop after this many seconds; no limit when it is not given
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub seconds: Option<f64>,
        /// Which patterns are returned: "best" by the measure that the method improves, or "last"
        pub keep: Keep = Keep::Best,
    }
}

/// Steps over which the change of the loss is averaged.
const STEADY: usize = 5;
/// Steps from one look at the gap to the next, for runs that stop by it.
const GAP_EVERY: usize = 5;

impl Stop {
    /// After so many iterations.
    #[must_use]
    pub fn after(iterations: usize) -> Self {
        Stop {
            iterations,
            ..Stop::default()
        }
    }

    /// Refuses numbers out of range.
    ///
    /// # Errors
    /// [`Error::Config`] naming the key.
    pub fn validate(&self) -> Result<()> {
        check_ranges("stop", self)
    }
}

/// Why a run stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum StopReason {
    /// All iterations are done.
    Iterations,
    /// The loss is zero.
    ZeroLoss,
    /// The projected gradient is small enough.
    ProjectedGradient,
    /// The loss hardly changes any more.
    Steady,
    /// No patterns can do much better.
    Gap,
    /// No better point was found: as good as f32 gets.
    NoProgress,
    /// An observer asked for it (a metric reached its goal).
    Observer,
    /// The time is over.
    WallTime,
    /// The user asked for it.
    Canceled,
}

impl StopReason {
    /// Whether a limit ended the run, not what it had reached.
    #[must_use]
    pub fn is_a_limit(self) -> bool {
        matches!(self, StopReason::Iterations | StopReason::WallTime)
    }
}

/// A row of the history; row 0 is the start.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Row {
    /// Steps done.
    pub iteration: usize,
    /// Loss after the step.
    pub loss: f64,
    /// Norm of the projected gradient before the step (None in row 0).
    pub projected_gradient: Option<f64>,
    /// Length of the step (None in row 0).
    pub step: Option<f64>,
    /// Forward calls so far.
    pub forward: u64,
    /// Adjoint calls so far.
    pub adjoint: u64,
    /// Seconds so far, those before a resume included.
    pub seconds: f64,
    /// The print after the step, where an observer measured it.
    #[serde(default)]
    pub print: Option<MeasuredPrint>,
    /// Parameters of the response that the loss is of, where these are [unknowns](super::free_response).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub response: Vec<f64>,
}

impl Row {
    /// After so many steps, of which nothing else is known.
    #[must_use]
    pub fn at(iteration: usize) -> Self {
        Row {
            iteration,
            loss: f64::NAN,
            projected_gradient: None,
            step: None,
            forward: 0,
            adjoint: 0,
            seconds: 0.0,
            print: None,
            response: Vec::new(),
        }
    }
}

/// What an observer measured of a print.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
pub struct MeasuredPrint {
    /// IoU at the best threshold.
    pub iou: Option<f64>,
    /// Process window, in units of the response.
    pub process_window: Option<f64>,
}

/// The projected gradient of a row relative to the first of the history; none where there is none, or the first is 0.
#[must_use]
pub fn relative_gradient(history: &[Row], row: &Row) -> Option<f64> {
    let first = history.iter().find_map(|row| row.projected_gradient)?;
    row.projected_gradient
        .map(|norm| norm / first)
        .filter(|ratio| ratio.is_finite())
}

/// What observers see after each step, and once at the start.
pub struct StepReport<'a, F: Field> {
    /// The newest row of the history.
    pub row: &'a Row,
    /// The projected gradient of the newest row, relative to the first; a resumed run knows the first of the run before.
    pub relative_gradient: Option<f64>,
    /// Loss of the best patterns so far.
    pub best_loss: f64,
    /// The patterns.
    pub patterns: &'a F,
    /// Their dose.
    pub dose: SeenDose<'a, F>,
    /// Model calls and where the time went.
    pub counters: &'a Counters,
}

/// The dose after a step.
pub struct SeenDose<'a, F: Field> {
    problem: &'a Problem<'a, F>,
    patterns: &'a F,
    at: &'a Position<F>,
}

impl<F: Field> SeenDose<'_, F> {
    /// The dose in all voxels; computed first where searches have left some out.
    ///
    /// # Errors
    /// Those of the model.
    pub fn whole(&self) -> Result<Cow<'_, F>> {
        self.problem.whole_dose(self.patterns, self.at)
    }

    /// The dose as searches know it, and where that is the dose of every voxel: from this value on. Voxels that searches have left out have an earlier dose below it.
    #[must_use]
    pub fn known(&self) -> (&F, f32) {
        (&self.at.dose, self.problem.known_from(self.at))
    }
}

/// Watches a run: progress, history files, metrics that stop it.
pub trait Observer<F: Field> {
    /// Called at the start and after every step; `Break` ends the run.
    fn on_step(&mut self, report: &StepReport<F>) -> ControlFlow<()>;
    /// What it measured of the print at the last call of [`on_step`](Self::on_step): a part of the history, and of checkpoints.
    fn print(&self) -> Option<MeasuredPrint> {
        None
    }
    /// Called when checkpoints no longer fit on the disk, and when they do again.
    fn on_disk_space(&mut self, _space: &DiskSpace) {}
}

impl<F: Field, O: FnMut(&StepReport<F>) -> ControlFlow<()>> Observer<F> for O {
    fn on_step(&mut self, report: &StepReport<F>) -> ControlFlow<()> {
        self(report)
    }
}

/// What a run came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Loss of the patterns that are the result.
    pub loss: f64,
    /// Which patterns these are.
    pub kept: KeptIterate,
    /// Why it stopped.
    pub reason: StopReason,
    /// A row per step, and one for the start.
    pub history: Vec<Row>,
    /// Parameters of the response with the patterns that are the result, where these are [unknowns](super::free_response); else empty.
    pub response: Vec<f64>,
    /// A loss that no patterns within the bounds go below, of the run's last voxels; None where there is no such [bound](super::Gap).
    pub bound: Option<f64>,
    /// Model calls and where the time went.
    pub counters: Counters,
}

impl Outcome {
    /// That of a run which was canceled before its first loss.
    fn of_nothing(counters: Counters) -> Self {
        Outcome {
            loss: f64::NAN,
            kept: KeptIterate {
                iteration: 0,
                by: KeptBy::Last,
            },
            reason: StopReason::Canceled,
            history: Vec::new(),
            response: Vec::new(),
            bound: None,
            counters,
        }
    }

    /// How far the loss is from the lowest one, where that is known.
    #[must_use]
    pub fn gap(&self) -> Option<Gap> {
        let loss = self.loss;
        self.bound.map(|bound| Gap { loss, bound })
    }
}

/// Runs an optimizer from `x` until something stops it; `x` is left at the best patterns found ([`Keep`]), also after an error.
///
/// With checkpoints, a checkpoint of the same job in their folder is resumed first (`x` is then overwritten).
///
/// # Errors
/// [`Error::Unsupported`] when the optimizer [needs](super::Requirements) what the problem lacks;
/// [`Error::NonFinite`] with the iteration when loss or gradient is no number; what a model, a checkpoint or [`Stop`] refuses.
/// A canceled run is no error; canceled before its first loss, that is NaN and the history empty.
pub fn run<F: Field>(
    problem: &mut Problem<F>,
    optimizer: &mut dyn Optimizer<F>,
    x: &mut F,
    stop: &Stop,
    checkpoints: Option<&mut Checkpoints>,
    observers: &mut [&mut dyn Observer<F>],
) -> Result<Outcome> {
    run_after(
        Vec::new(),
        problem,
        optimizer,
        x,
        stop,
        checkpoints,
        observers,
    )
}

/// As [`run`], after the steps of another run, on other voxels perhaps: its history goes on, and so do the numbers of iterations. The last
/// of its rows is replaced by the same patterns' loss here.
///
/// # Errors
/// As [`run`].
pub fn run_after<F: Field>(
    earlier: Vec<Row>,
    problem: &mut Problem<F>,
    optimizer: &mut dyn Optimizer<F>,
    x: &mut F,
    stop: &Stop,
    checkpoints: Option<&mut Checkpoints>,
    observers: &mut [&mut dyn Observer<F>],
) -> Result<Outcome> {
    must_fit(problem, optimizer, stop)?;
    let saved = checkpoints.as_deref();
    let Some(mut state) = begin(earlier, problem, optimizer, x, stop.keep, saved)? else {
        return Ok(Outcome::of_nothing(problem.counters));
    };
    problem.work().set_patient(true);
    let result = state.iterate(problem, optimizer, x, stop, checkpoints, observers);
    problem.work().set_patient(false);
    if result.as_ref().is_ok_and(|r| *r != StopReason::Canceled) {
        // It comes after the last row, so its seconds are none of the loop's
        let Counters {
            model_s,
            objective_s,
            ..
        } = problem.counters;
        state.tighten(problem, x)?;
        problem.counters = Counters {
            model_s,
            objective_s,
            ..problem.counters
        };
    }
    let loss = state.keeper.best().loss;
    let response = state.keeper.best().response.clone();
    let kept = state.keeper.end(x);
    Ok(Outcome {
        loss,
        response,
        kept,
        reason: result?,
        history: state.history,
        bound: state.bound,
        counters: problem.counters,
    })
}

/// Whether this optimizer can solve this problem and stop as asked.
fn must_fit<F: Field>(
    problem: &Problem<F>,
    optimizer: &dyn Optimizer<F>,
    stop: &Stop,
) -> Result<()> {
    stop.validate()?;
    optimizer.requirements().check(problem)?;
    if stop.gap > 0.0 && !problem.has_lower_bound() {
        return Err(Error::unsupported(
            "stop.gap",
            "how far a loss is from the lowest one is known for a linear model, a convex objective of the dose itself ([response.identity]) and pixels with a largest value (bounds.max); leave it out",
        ));
    }
    Ok(())
}

/// Writes a checkpoint, and tells where there is no room for it.
fn keep<F: Field>(
    checkpoints: &mut Checkpoints,
    saved: Saved<'_, F>,
    work: &Work,
    observers: &mut [&mut dyn Observer<F>],
) -> Result<()> {
    if let Some(space) = checkpoints.try_write(saved, work)? {
        observers
            .iter_mut()
            .for_each(|observer| observer.on_disk_space(&space));
    }
    Ok(())
}

/// A run between two steps.
struct State<F> {
    at: Position<F>,
    history: Vec<Row>,
    keeper: Keeper<F>,
    begin: Instant,
    /// Seconds before a resume.
    before_s: f64,
    /// The highest of the losses that no patterns go below, and the row at which one was last looked for.
    bound: Option<f64>,
    bound_at: Option<usize>,
}

/// Resumes, or starts anew; None when canceled before the first loss.
fn begin<F: Field>(
    mut earlier: Vec<Row>,
    problem: &mut Problem<F>,
    optimizer: &mut dyn Optimizer<F>,
    x: &mut F,
    keep: Keep,
    checkpoints: Option<&Checkpoints>,
) -> Result<Option<State<F>>> {
    let begin = Instant::now();
    let checkpoint = checkpoints
        .map(Checkpoints::open_of_level)
        .transpose()?
        .flatten();
    if let Some(mut checkpoint) = checkpoint {
        checkpoint.read_field("patterns", x)?;
        if checkpoint.contents() == Contents::All {
            return resume(checkpoint, problem, optimizer, x, keep, begin).map(Some);
        }
        if checkpoint.has("best") {
            checkpoint.read_field("best", x)?;
        }
    }
    problem.set_response_values(earlier.last().map_or(&[], |row| &row.response))?;
    let mut at = match problem.evaluate_at(x) {
        Err(Error::Canceled) => return Ok(None),
        other => other?,
    };
    problem.fit_response(x, &mut at, &[])?;
    if !at.loss.is_finite() {
        return Err(Error::NonFinite {
            what: "the loss".to_owned(),
            value: at.loss,
            iteration: 0,
        });
    }
    let last = earlier.pop();
    for row in &mut earlier {
        // Gradients of other voxels are no measure of these
        row.projected_gradient = None;
    }
    let mut state = State {
        keeper: Keeper::new(problem, optimizer, keep, &at),
        at,
        history: earlier,
        begin,
        before_s: last.as_ref().map_or(0.0, |row| row.seconds),
        bound: None,
        bound_at: None,
    };
    state.record(problem, last.map_or(0, |row| row.iteration), None);
    Ok(Some(state))
}

/// The state of a checkpoint that has all of it; the patterns have been read.
fn resume<F: Field>(
    mut checkpoint: Checkpoint,
    problem: &mut Problem<F>,
    optimizer: &mut dyn Optimizer<F>,
    x: &mut F,
    keep: Keep,
    begin: Instant,
) -> Result<State<F>> {
    let mut dose = problem.model().new_dose()?;
    checkpoint.read_field("dose", &mut dose)?;
    let history = checkpoint.history().to_vec();
    let done = history.last().map_or(0, |row| row.iteration);
    let renewal = problem.model().renewal();
    match renewal.and_then(|model| Some((model, model.memory()?))) {
        Some((model, mut memory)) => {
            checkpoint.read_field("model", &mut memory)?;
            model.restore(&memory);
        }
        None => drop(problem.renew(done.max(1), x)?),
    }
    problem.set_response_values(history.last().map_or(&[], |row| &row.response))?;
    let unknown = checkpoint.flags("unknown")?;
    let at = problem.place_at(x, dose)?.with_unknown(unknown);
    optimizer.restore(&mut checkpoint, problem, x)?;
    problem.counters = checkpoint.counters();
    let mut keeper = Keeper::new(problem, optimizer, keep, &at);
    let mut best = None;
    if checkpoint.has("best") {
        let mut field = x.zeros_like();
        checkpoint.read_field("best", &mut field)?;
        best = Some(field);
    }
    keeper.resume(checkpoint.best(), best);
    let before_s = history.last().map_or(0.0, |row| row.seconds);
    Ok(State {
        at,
        history,
        keeper,
        begin,
        before_s,
        bound: None,
        bound_at: None,
    })
}

impl<F: Field> State<F> {
    /// Steps until something stops the run; checkpoints of it where one is due.
    fn iterate(
        &mut self,
        problem: &mut Problem<F>,
        optimizer: &mut dyn Optimizer<F>,
        x: &mut F,
        stop: &Stop,
        mut checkpoints: Option<&mut Checkpoints>,
        observers: &mut [&mut dyn Observer<F>],
    ) -> Result<StopReason> {
        loop {
            match self.look_at_gap(problem, x, stop) {
                Err(Error::Canceled) => return Ok(StopReason::Canceled),
                other => other?,
            }
            if let Some(reason) = self.reason_to_stop(problem, x, stop, observers) {
                let is_canceled = reason == StopReason::Canceled;
                let keeps = |checkpoints: &&mut Checkpoints| is_canceled || checkpoints.keeps_end();
                if let Some(checkpoints) = checkpoints.as_deref_mut().filter(keeps) {
                    let memory = problem.model().renewal().and_then(Renewal::memory);
                    let saved = self.saved(problem, optimizer, x, memory.as_ref());
                    keep(checkpoints, saved, problem.work(), observers)?;
                }
                return Ok(reason);
            }
            match self.step(problem, optimizer, x) {
                // A step that was broken into has lost the position: the last checkpoint stays
                Err(Error::Canceled) => return Ok(StopReason::Canceled),
                other => other?,
            }
            if let Some(checkpoints) = checkpoints.as_deref_mut() {
                let memory = problem.model().renewal().and_then(Renewal::memory);
                let saved = self.saved(problem, optimizer, x, memory.as_ref());
                if checkpoints.is_due(&saved) {
                    keep(checkpoints, saved, problem.work(), observers)?;
                }
            }
        }
    }

    fn record(&mut self, problem: &Problem<F>, iteration: usize, step: Option<super::Step>) {
        self.history.push(Row {
            iteration,
            loss: self.at.loss,
            projected_gradient: step.map(|s| s.projected_gradient),
            step: step.map(|s| s.length),
            forward: problem.counters.forward,
            adjoint: problem.counters.adjoint,
            seconds: self.before_s + self.begin.elapsed().as_secs_f64(),
            print: None,
            response: problem.response_values().to_vec(),
        });
    }

    /// Looks for a bound of the loss now and then, in runs that stop by it.
    fn look_at_gap(&mut self, problem: &mut Problem<F>, x: &F, stop: &Stop) -> Result<()> {
        let done = self.history.last().map_or(0, |row| row.iteration);
        if stop.gap > 0.0 && done > 0 && done.is_multiple_of(GAP_EVERY) {
            self.tighten(problem, x)?;
        }
        Ok(())
    }

    /// Looks for a higher bound of the loss, unless these patterns gave theirs.
    fn tighten(&mut self, problem: &mut Problem<F>, x: &F) -> Result<()> {
        let row = self.history.last().map(|row| row.iteration);
        if self.bound_at != row {
            self.bound_at = row;
            let found = problem.lower_bound(x, &self.at)?;
            self.bound = found.map(|found| self.bound.map_or(found, |bound| bound.max(found)));
        }
        Ok(())
    }

    /// How far the best patterns are from the bound.
    fn gap(&self) -> Option<Gap> {
        let loss = self.keeper.best().loss;
        self.bound.map(|bound| Gap { loss, bound })
    }

    /// Asked before every step; tells the observers.
    fn reason_to_stop(
        &mut self,
        problem: &Problem<F>,
        x: &F,
        stop: &Stop,
        observers: &mut [&mut dyn Observer<F>],
    ) -> Option<StopReason> {
        let row = self.history.last()?;
        let report = StepReport {
            row,
            relative_gradient: relative_gradient(&self.history, row),
            best_loss: self.keeper.best().loss,
            patterns: x,
            dose: SeenDose {
                problem,
                patterns: x,
                at: &self.at,
            },
            counters: &problem.counters,
        };
        let mut broken = false;
        let mut print = row.print;
        for observer in observers.iter_mut() {
            broken |= observer.on_step(&report).is_break();
            print = observer.print().or(print);
        }
        self.history.last_mut()?.print = print;
        let row = self.history.last()?;
        let first = self.history.iter().find_map(|row| row.projected_gradient);
        let small = |norm: f64| norm <= stop.projected_gradient * first.unwrap_or(0.0);
        let first_loss = stop
            .first_loss
            .or_else(|| self.history.first().map(|row| row.loss));
        broken |= first_loss.is_some_and(|first| row.loss < stop.relative_loss * first);
        // A method at rest goes on while the response moves
        let is_settled = problem.is_response_settled(response_before(&self.history));
        // On other paths the loss may be above zero again
        let goes_on = problem.model().renewal().is_some();
        // Ranks have clocks and signals of their own
        let is_asked = x.any(problem.work().is_stop_asked());
        let is_late = stop
            .seconds
            .is_some_and(|limit| x.any(row.seconds >= limit));
        if is_asked {
            Some(StopReason::Canceled)
        } else if row.loss == 0.0 && !goes_on {
            Some(StopReason::ZeroLoss)
        } else if row.projected_gradient.is_some_and(small) && is_settled {
            Some(StopReason::ProjectedGradient)
        } else if stop.change > 0.0
            && row.iteration >= stop.change_after
            && self.change().is_some_and(|c| c <= stop.change * row.loss)
            && !(stop.rise.zip(self.rise())).is_some_and(|(most, rise)| rise > most)
            && is_settled
        {
            Some(StopReason::Steady)
        } else if stop.gap > 0.0 && self.gap().is_some_and(|gap| gap.relative() <= stop.gap) {
            Some(StopReason::Gap)
        } else if row.step == Some(0.0) && !goes_on && is_settled {
            Some(StopReason::NoProgress)
        } else if broken {
            Some(StopReason::Observer)
        } else if row.iteration >= stop.iterations {
            Some(StopReason::Iterations)
        } else if is_late {
            Some(StopReason::WallTime)
        } else {
            None
        }
    }

    /// Mean change of the loss over the last steps; None before there are enough.
    fn change(&self) -> Option<f64> {
        let last = self.history.len().checked_sub(STEADY + 1)?;
        let losses = self.history[last..].windows(2);
        let changes = losses.map(|pair| (pair[1].loss - pair[0].loss).abs());
        Some(changes.sum::<f64>() / STEADY as f64)
    }

    /// Rise of the IoU up to the last print that was measured, from the last one at least [`STEADY`] steps before it.
    fn rise(&self) -> Option<f64> {
        let mut measured = self.history.iter().rev().filter_map(|row| {
            let iou = row.print.and_then(|print| print.iou)?;
            Some((row.iteration, iou))
        });
        let (last, iou) = measured.next()?;
        let (_, before) = measured.find(|(iteration, _)| iteration + STEADY <= last)?;
        Some(iou - before)
    }

    /// One step, its row, and the best patterns.
    fn step(
        &mut self,
        problem: &mut Problem<F>,
        optimizer: &mut dyn Optimizer<F>,
        x: &mut F,
    ) -> Result<()> {
        let iteration = self.history.last().map_or(0, |row| row.iteration) + 1;
        if problem.renew(iteration, x)? {
            // Losses of another map are no measure of this one
            optimizer.forget();
            self.at = problem.evaluate_at(x)?;
            self.keeper.begin_anew(problem, &self.at, iteration - 1);
        }
        // A method that may raise the loss could lose its best patterns by the step
        let before = self.keeper.before(x);
        let step = optimizer.step(problem, x, &mut self.at);
        let step = match step.and_then(|step| finite(step, self.at.loss, iteration)) {
            Ok(step) => step,
            Err(error) => {
                self.keeper.go_back(before);
                return Err(error);
            }
        };
        problem.fit_response(x, &mut self.at, response_before(&self.history))?;
        self.keeper.after(problem, &self.at, iteration, before);
        self.record(problem, iteration, Some(step));
        Ok(())
    }

    fn saved<'a>(
        &'a self,
        problem: &Problem<F>,
        optimizer: &'a dyn Optimizer<F>,
        x: &'a F,
        model: Option<&'a F>,
    ) -> Saved<'a, F> {
        Saved {
            patterns: x,
            best: self.keeper.best().clone(),
            best_patterns: self.keeper.patterns(),
            dose: &self.at.dose,
            unknown: self.at.unknown(),
            model,
            memory: optimizer.memory(),
            counters: problem.counters,
            history: &self.history,
        }
    }
}

/// Parameters of the response before those of the last row; empty where there are none.
fn response_before(history: &[Row]) -> &[f64] {
    let before = history.len().checked_sub(2);
    before.map_or(&[], |row| &history[row].response)
}

/// A step that led to numbers.
fn finite(step: super::Step, loss: f64, iteration: usize) -> Result<super::Step> {
    for (what, value) in [
        ("the loss", loss),
        ("the gradient", step.projected_gradient),
    ] {
        if !value.is_finite() {
            return Err(Error::NonFinite {
                what: what.to_owned(),
                value,
                iteration,
            });
        }
    }
    Ok(step)
}

#[cfg(test)]
mod tests;
