use super::*;
use crate::checkpoint::Params;
use crate::gradient::{self, Gradient};
use crate::lbfgs::{self, Lbfgs};
use crate::reference::{Model, Scripted, solve};
use crate::{Limits, OPTIMIZERS};
use serde_json::json;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use tomolith_core::check::{self, small::SmallModel};
use tomolith_core::dose::{DoseModel, Facts, Renewal, Space, Work};
use tomolith_core::field::HostField;
use tomolith_core::response::Identity;
use tomolith_objective::Objective;
use tomolith_objective::check::of_ring;

type Observers<'a> = &'a mut [&'a mut dyn Observer<HostField>];

fn objective(model: &SmallModel, name: &str) -> Box<dyn Objective<HostField>> {
    of_ring(model, name, json!({}), Arc::new(Identity))
}

fn newton() -> Lbfgs<HostField> {
    Lbfgs::new(lbfgs::Params::default()).unwrap()
}

fn gradient() -> Gradient<HostField> {
    Gradient::new(gradient::Params::default()).unwrap()
}

/// A run on the ring from uniform patterns.
fn go(
    model: &Model,
    objective: &dyn Objective<HostField>,
    optimizer: &mut dyn Optimizer<HostField>,
    stop: Stop,
) -> (HostField, Result<Outcome>) {
    solve(model, objective, Limits::default(), 0.5, optimizer, &stop)
}

/// The same with checkpoints, watched.
fn go_on(
    model: &Model,
    objective: &dyn Objective<HostField>,
    method: &mut dyn Optimizer<HostField>,
    stop: Stop,
    checkpoints: Option<&mut Checkpoints>,
    observers: Observers,
) -> (HostField, Result<Outcome>) {
    let flag = Work::new();
    let mut problem = Problem::new(model, objective, &[Limits::default()], &flag).unwrap();
    let mut x = check::even_patterns(model, 0.5);
    let outcome = run(&mut problem, method, &mut x, &stop, checkpoints, observers);
    (x, outcome)
}

fn losses(outcome: &Outcome) -> Vec<f64> {
    outcome.history.iter().map(|row| row.loss).collect()
}

#[test]
fn every_reason_to_stop_stops() {
    let model = SmallModel::new(16, 24, 1);
    let (threshold, l2) = (objective(&model, "threshold"), objective(&model, "l2"));
    let reason = |objective: &dyn Objective<HostField>, stop: Stop| {
        go(&model, objective, &mut newton(), stop).1.unwrap()
    };
    assert_eq!(reason(&*l2, Stop::after(3)).reason, StopReason::Iterations);
    assert_eq!(reason(&*l2, Stop::after(0)).history.len(), 1);
    let zero = reason(&*threshold, Stop::after(500));
    assert_eq!((zero.reason, zero.loss), (StopReason::ZeroLoss, 0.0));
    let small = Stop {
        projected_gradient: 0.01,
        ..Stop::after(500)
    };
    let small = reason(&*l2, small);
    assert_eq!(small.reason, StopReason::ProjectedGradient);
    // Half of what there is to gain
    let (end, start) = (small.loss, small.history[0].loss);
    let relative_loss = 0.5 * (1.0 + end / start);
    let part = |first_loss| {
        let stop = Stop {
            relative_loss,
            first_loss,
            ..Stop::after(500)
        };
        let outcome = reason(&*l2, stop);
        assert_eq!(outcome.reason, StopReason::Observer);
        let losses = losses(&outcome);
        let limit = relative_loss * first_loss.unwrap_or(losses[0]);
        let (last, before) = losses.split_last().unwrap();
        assert!(
            *last < limit && before.iter().all(|loss| *loss >= limit),
            "{losses:?}"
        );
        losses
    };
    let losses = part(None);
    assert_eq!(part(Some(9.0 * losses[0])), losses[..1]);
    let norms: Vec<f64> = small
        .history
        .iter()
        .filter_map(|row| row.projected_gradient)
        .collect();
    assert!(norms.last().unwrap() <= &(0.01 * norms[0]));
    let hurried = Stop {
        seconds: Some(1e-9),
        ..Stop::after(500)
    };
    assert_eq!(reason(&*l2, hurried).reason, StopReason::WallTime);
    let mut third = |report: &StepReport<HostField>| match report.row.iteration {
        3 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    };
    let (_, outcome) = go_on(
        &model,
        &*l2,
        &mut newton(),
        Stop::after(9),
        None,
        &mut [&mut third],
    );
    let outcome = outcome.unwrap();
    assert_eq!(
        (outcome.reason, outcome.history.len()),
        (StopReason::Observer, 4)
    );
    // One forward call at the start, one for the first length, and one of each a step
    assert_eq!((outcome.counters.forward, outcome.counters.adjoint), (5, 3));
    let flat = reason(&*l2, Stop::after(5000));
    assert_eq!(flat.reason, StopReason::NoProgress, "f32 ends somewhere");
}

#[test]
fn canceling_keeps_the_best() {
    let model = SmallModel::new(16, 24, 1);
    let objective = objective(&model, "l2");
    let flag = Work::new();
    let mut problem = Problem::new(&model, &*objective, &[Limits::default()], &flag).unwrap();
    let mut x = check::even_patterns(&model, 0.5);
    let mut cancel = |report: &StepReport<HostField>| {
        if report.row.iteration == 4 {
            flag.cancel();
        }
        ControlFlow::Continue(())
    };
    let (method, stop, observers) = (&mut newton(), Stop::after(50), &mut [&mut cancel as _]);
    let outcome = run(&mut problem, method, &mut x, &stop, None, observers).unwrap();
    assert_eq!(
        (outcome.reason, outcome.history.len()),
        (StopReason::Canceled, 5)
    );
    assert_eq!(
        loss_of(&model, &*objective, &x),
        (outcome.loss * 1e4).round() / 1e4
    );
}

fn loss_of(model: &SmallModel, objective: &dyn Objective<HostField>, x: &HostField) -> f64 {
    let dose = check::dose(model, x);
    let loss = objective.value(&dose);
    // The loop's dose is a sum of steps, this one is computed at once
    (loss * 1e4).round() / 1e4
}

#[test]
fn a_fixed_step_that_is_too_long_ends_at_the_best() {
    let model = SmallModel::new(16, 24, 1);
    let objective = objective(&model, "l2");
    let params = gradient::Params {
        step: Some(8.0),
        ..gradient::Params::default()
    };
    let (x, outcome) = go(
        &model,
        &*objective,
        &mut Gradient::new(params).unwrap(),
        Stop::after(12),
    );
    let outcome = outcome.unwrap();
    let losses = losses(&outcome);
    assert!(
        losses.windows(2).any(|w| w[1] > w[0]),
        "the step is not too long: {losses:?}"
    );
    assert_eq!(
        outcome.loss,
        losses.iter().copied().fold(f64::INFINITY, f64::min)
    );
    assert_eq!(
        loss_of(&model, &*objective, &x),
        (outcome.loss * 1e4).round() / 1e4
    );
}

/// A method that walks straight ahead, to raise the loss or to break it.
fn straight(losses: [f64; 4]) -> Scripted<f32> {
    Scripted {
        script: (1u8..).map(f32::from).zip(losses).collect(),
        show: |value, _, x| {
            x.fill(*value);
            Ok(())
        },
        normalizes: false,
        done: 0,
    }
}

#[test]
fn the_best_is_kept_when_the_loss_rises_and_when_it_is_no_number() {
    let model = SmallModel::new(6, 4, 1);
    let objective = objective(&model, "l2");
    let mut rising = straight([3.0, 2.0, 5.0, 2.5]);
    let (x, outcome) = go(&model, &*objective, &mut rising, Stop::after(4));
    let outcome = outcome.unwrap();
    let by = KeptBy::Loss;
    assert_eq!(
        (outcome.loss, outcome.kept),
        (2.0, KeptIterate { iteration: 2, by })
    );
    assert_eq!(x.as_slice()[0], 2.0);
    let mut broken = straight([3.0, 2.0, 5.0, f64::NAN]);
    let (x, outcome) = go(&model, &*objective, &mut broken, Stop::after(9));
    assert!(
        matches!(outcome, Err(Error::NonFinite { iteration: 4, .. })),
        "{outcome:?}"
    );
    assert_eq!(x.as_slice()[0], 2.0);
}

/// A model around another: dose of x², as for amplitudes; adjoints that are no numbers from some call on; a fifth brighter
/// after every so many iterations; and no dose at all below an induction, max(0, F(x) − c).
struct Twisted {
    inner: SmallModel,
    every: Option<usize>,
    round: AtomicU64,
    squared: bool,
    induction: f32,
    good_adjoints: u64,
    adjoints: AtomicU64,
}

impl Twisted {
    fn of(inner: SmallModel) -> Self {
        Twisted {
            inner,
            every: None,
            round: AtomicU64::new(0),
            squared: false,
            induction: 0.0,
            good_adjoints: u64::MAX,
            adjoints: AtomicU64::new(0),
        }
    }

    fn gain(&self) -> f64 {
        1.0 + 0.2 * self.round.load(Ordering::Relaxed) as f64
    }
}

impl Renewal<HostField> for Twisted {
    fn renew(&self, iteration: usize, _x: &HostField, _run: &Work) -> Result<bool> {
        let round = self.every.map_or(0, |every| (iteration - 1) / every) as u64;
        Ok(self.round.swap(round, Ordering::Relaxed) != round)
    }
}

impl DoseModel for Twisted {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            is_linear: !self.squared && self.induction == 0.0,
            ..self.inner.facts()
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        self.inner.new_field(space)
    }

    fn updates(&self) -> u64 {
        self.inner.updates()
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        self.every.map(|_| self as _)
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, work: &Work) -> Result<()> {
        let mut x = x.clone();
        if self.squared {
            x.as_mut_slice().iter_mut().for_each(|v| *v *= *v);
        }
        x.scale(self.gain() as f32);
        self.inner.dose(&x, dose, work)?;
        if self.induction > 0.0 {
            let values = dose.as_mut_slice().iter_mut();
            values.for_each(|v| *v = (*v - self.induction).max(0.0));
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let mut cotangent = cotangent.clone();
        if self.induction > 0.0 {
            cotangent.keep_positive(&check::dose(self, x));
        }
        self.inner.pullback_of(frames, x, &cotangent, grad, work)?;
        grad.scale(self.gain() as f32);
        if self.squared {
            grad.as_mut_slice()
                .iter_mut()
                .zip(x.as_slice())
                .for_each(|(g, x)| *g *= 2.0 * x);
        }
        if self.adjoints.fetch_add(1, Ordering::Relaxed) >= self.good_adjoints {
            grad.as_mut_slice()[5] = f32::NAN;
        }
        Ok(())
    }

    fn dose_of(&self, _: Range<usize>, _: &HostField, _: &mut HostField, _: &Work) -> Result<()> {
        Err(Error::Canceled)
    }

    fn along(&self, _: &HostField, _: &HostField, _: &Work) -> Result<Option<Vec<HostField>>> {
        Ok(None)
    }

    fn describe(&self) -> String {
        "a twisted model".to_owned()
    }
}

#[test]
fn a_steady_loss_ends_the_run_by_equation_28() {
    let model = SmallModel::new(16, 24, 1);
    let l2 = objective(&model, "l2");
    let stop = Stop {
        change: 0.01,
        ..Stop::after(500)
    };
    let (_, outcome) = go(&model, &*l2, &mut newton(), stop);
    let outcome = outcome.unwrap();
    assert_eq!(outcome.reason, StopReason::Steady);
    let losses = losses(&outcome);
    let met = |k: usize| {
        let changes = (k - 4..=k).map(|i| (losses[i] - losses[i - 1]).abs());
        changes.sum::<f64>() / 5.0 <= 0.01 * losses[k]
    };
    let last = losses.len() - 1;
    assert!(met(last) && (5..last).all(|k| !met(k)), "{losses:?}");
    // Not before so many steps
    let stop = Stop {
        change: 0.01,
        change_after: last + 3,
        ..Stop::after(500)
    };
    let (_, outcome) = go(&model, &*l2, &mut newton(), stop);
    let outcome = outcome.unwrap();
    assert_eq!(outcome.reason, StopReason::Steady);
    assert!(outcome.history.len() >= last + 4);
}

/// Sees the IoU rise by 0.01 in every step up to an iteration.
struct Rising {
    until: usize,
    iou: f64,
}

impl Observer<HostField> for Rising {
    fn on_step(&mut self, report: &StepReport<HostField>) -> ControlFlow<()> {
        self.iou = 0.01 * report.row.iteration.min(self.until) as f64;
        ControlFlow::Continue(())
    }

    fn print(&self) -> Option<MeasuredPrint> {
        Some(MeasuredPrint {
            iou: Some(self.iou),
            process_window: None,
        })
    }
}

#[test]
fn a_steady_loss_ends_no_run_whose_print_becomes_better() {
    let model = SmallModel::new(16, 24, 1);
    let l2 = objective(&model, "l2");
    let last = |rise: Option<f64>, until: usize| {
        let stop = Stop {
            change: 0.1,
            rise,
            ..Stop::after(500)
        };
        let mut rising = Rising { until, iou: 0.0 };
        let seen: Observers = &mut [&mut rising];
        let (_, outcome) = go_on(&model, &*l2, &mut newton(), stop, None, seen);
        let outcome = outcome.unwrap();
        assert_eq!(outcome.reason, StopReason::Steady);
        outcome.history.len() - 1
    };
    let steady = last(None, 0);
    // From five steps before to the last it rises by 0.05 until then, and by 0.02 three steps later
    let until = steady + 3;
    assert_eq!(last(Some(0.025), until), until + 3);
    assert_eq!(last(Some(0.06), until), steady);
    assert_eq!(last(Some(0.025), 0), steady);
}

#[test]
fn pairs_that_do_not_fit_are_refused_with_both_keys_before_any_work() {
    let inner = SmallModel::new(10, 8, 1);
    let l2 = objective(&inner, "l2");
    let twisted = Twisted {
        squared: true,
        ..Twisted::of(inner)
    };
    let flag = Work::new();
    let refusal = |row: &tomolith_core::kind::Kind<crate::BuildOptimizer>,
                   model: &dyn DoseModel<Field = HostField>,
                   bits: Option<u32>| {
        let made = (row.build)(&tomolith_core::check::example(row)).unwrap();
        let (method, stop) = (&mut *made.make().unwrap(), Stop::after(1));
        let mut problem = Problem::new(model, &*l2, &[Limits::default()], &flag)
            .unwrap()
            .with_bits(bits)
            .unwrap();
        let mut x = model.new_patterns().unwrap();
        let outcome = run(&mut problem, method, &mut x, &stop, None, &mut []);
        assert!(outcome.is_ok() || problem.counters == Counters::default());
        outcome.err().map(|e| e.to_string())
    };
    for row in OPTIMIZERS {
        let bits = refusal(row, &twisted.inner, Some(8));
        let curved = refusal(row, &twisted, None);
        let expect = |found: &Option<String>, names: &[&str], word: &str| {
            let found = found.as_deref().unwrap_or_default();
            let is_named = found.starts_with(&format!("optimizer.{} ", row.name));
            assert_eq!(
                names.contains(&row.name),
                found.contains(word) && is_named,
                "{}: {found}",
                row.name
            );
        };
        expect(&bits, &["lbfgs", "gradient", "pm"], "bounds.bits");
        expect(&curved, &["fista", "osmo", "cal"], "not linear");
    }
    for bits in [0, 17] {
        let refused = Problem::new(&twisted.inner, &*l2, &[Limits::default()], &flag)
            .unwrap()
            .with_bits(Some(bits));
        assert!(matches!(refused, Err(Error::Config { key, .. }) if key == "bounds.bits"));
    }
}

#[test]
fn patterns_of_few_bits_stay_on_their_levels_in_every_step() {
    let model = SmallModel::new(16, 24, 1);
    let l2 = objective(&model, "l2");
    let flag = Work::new();
    let limits = [Limits {
        min: 0.25,
        max: 1.75,
    }];
    for name in ["gradient", "bclp", "adam", "fista"] {
        let row = OPTIMIZERS.iter().find(|row| row.name == name).unwrap();
        let mut section = tomolith_core::check::example(row);
        if name == "gradient" {
            section.value["step"] = 0.5.into();
        }
        let method = &mut *(row.build)(&section).unwrap().make().unwrap();
        let mut problem = Problem::new(&model, &*l2, &limits, &flag)
            .unwrap()
            .with_bits(Some(4))
            .unwrap();
        let mut x = check::even_patterns(&model, 0.5);
        let mut off = None;
        let mut watch = |report: &StepReport<HostField>| {
            // 16 levels from 0.25 to 1.75 are 0.1 apart
            let level = |v: f32| f64::from(v - 0.25) / 0.1;
            let wrong = |&v: &f32| (level(v) - level(v).round()).abs() > 1e-4;
            off = off.or_else(|| report.patterns.as_slice().iter().copied().find(wrong));
            ControlFlow::Continue(())
        };
        let (stop, observers) = (Stop::after(15), &mut [&mut watch as _]);
        let outcome = run(&mut problem, method, &mut x, &stop, None, observers).unwrap();
        assert_eq!(off, None, "{name} leaves the levels");
        assert!(
            outcome.loss < 0.8 * outcome.history[0].loss,
            "{name}: {} of {}",
            outcome.loss,
            outcome.history[0].loss
        );
    }
}

#[test]
fn a_gradient_that_is_no_number_stops_the_run_and_keeps_what_was_good() {
    for optimizer in [&mut newton() as &mut dyn Optimizer<_>, &mut gradient()] {
        let inner = SmallModel::new(16, 24, 1);
        let objective = objective(&inner, "l2");
        let model = Twisted {
            good_adjoints: 3,
            ..Twisted::of(inner)
        };
        let (x, outcome) = go(&model, &*objective, optimizer, Stop::after(9));
        assert!(
            matches!(&outcome, Err(Error::NonFinite { what, iteration: 4, .. }) if what == "the gradient"),
            "{outcome:?}"
        );
        assert!(x.as_slice().iter().all(|v| v.is_finite() && *v >= 0.0));
        let start = HostField::from_slice(&vec![0.5; x.len()]);
        let [end, begin] = [&x, &start].map(|x| loss_of(&model.inner, &*objective, x));
        assert!(end < 0.5 * begin, "{end} {begin}");
    }
}

#[test]
fn a_model_that_is_not_linear_is_searched_by_its_own_calls() {
    for optimizer in [&mut newton() as &mut dyn Optimizer<_>, &mut gradient()] {
        let inner = SmallModel::new(16, 24, 1);
        let objective = objective(&inner, "threshold");
        let model = Twisted {
            squared: true,
            ..Twisted::of(inner)
        };
        let (_, outcome) = go(&model, &*objective, optimizer, Stop::after(60));
        let losses = losses(&outcome.unwrap());
        assert!(losses.windows(2).all(|w| w[1] <= w[0]), "{losses:?}");
        assert!(losses.last().unwrap() < &(1e-2 * losses[0]), "{losses:?}");
    }
}

#[test]
fn a_model_that_becomes_another_is_measured_anew_and_resumed_to_the_same_bits() {
    let brighter = || Twisted {
        every: Some(3),
        ..Twisted::of(SmallModel::new(10, 8, 2))
    };
    let objective = objective(&brighter().inner, "l2");
    let solve = |iterations: usize, checkpoints: Option<&mut Checkpoints>| {
        let (stop, model) = (Stop::after(iterations), brighter());
        let newton = &mut newton();
        let (x, outcome) = go_on(&model, &*objective, newton, stop, checkpoints, &mut []);
        (x, outcome.unwrap())
    };
    let (x, whole) = solve(7, None);
    // A call at the start, one a step, one for the first length; both changes need a dose and a first length again
    assert_eq!(whole.counters.forward, 9 + 4);
    // The best patterns are the best of the last model
    let last = &whole.history[7..];
    assert_eq!(whole.loss, last[0].loss);
    let folder = tempfile::tempdir().unwrap();
    for part in [2, 3, 5, 7] {
        let mut checkpoints = Checkpoints::new(folder.path(), 1, &Params::default()).unwrap();
        let (again, outcome) = solve(part, Some(&mut checkpoints));
        if part == 7 {
            assert_eq!(again.as_slice(), x.as_slice());
            assert_eq!(outcome.loss, whole.loss);
        }
    }
}

#[test]
fn a_checkpoint_of_another_job_or_cut_short_is_refused_in_one_sentence() {
    let model = SmallModel::new(10, 8, 2);
    let objective = objective(&model, "l2");
    let folder = tempfile::tempdir().unwrap();
    let checkpoints =
        |fingerprint| Checkpoints::new(folder.path(), fingerprint, &Params::default()).unwrap();
    let resume_by = |optimizer: &mut dyn Optimizer<HostField>, fingerprint| {
        let (stop, mut checkpoints) = (Stop::after(5), checkpoints(fingerprint));
        let checkpoints = Some(&mut checkpoints);
        go_on(&model, &*objective, optimizer, stop, checkpoints, &mut []).1
    };
    let resume = |fingerprint| resume_by(&mut newton(), fingerprint);
    resume(1).unwrap();
    let refusal = resume(2).unwrap_err().to_string();
    assert!(refusal.contains("a checkpoint of another job"), "{refusal}");
    let few = lbfgs::Params {
        memory: 3,
        ..Default::default()
    };
    let (mut few, mut plain) = (Lbfgs::new(few).unwrap(), gradient());
    for other in [&mut few as &mut dyn Optimizer<_>, &mut plain] {
        let outcome = resume_by(other, 1);
        assert!(
            matches!(outcome, Err(Error::Unsupported { .. })),
            "{outcome:?}"
        );
    }
    // Cut anywhere
    let file = checkpoints(1).file();
    let whole = std::fs::read(&file).unwrap();
    for length in (0..whole.len()).step_by(whole.len() / 60) {
        std::fs::write(&file, &whole[..length]).unwrap();
        let refusal = resume(1).unwrap_err();
        assert!(
            matches!(refusal, Error::Format { .. }),
            "{length} of {} bytes: {refusal}",
            whole.len()
        );
    }
}

#[test]
fn a_checkpoint_of_patterns_begins_anew_from_the_best() {
    let model = SmallModel::new(16, 24, 1);
    let objective = objective(&model, "l2");
    let folder = tempfile::tempdir().unwrap();
    let params = Params {
        every_s: Some(1e-9),
        contents: Contents::Patterns,
    };
    let mut checkpoints = Checkpoints::new(folder.path(), 1, &params).unwrap();
    let file = checkpoints.file();
    let mut after = |steps| {
        let (stop, checkpoints) = (Stop::after(steps), Some(&mut checkpoints));
        go_on(
            &model,
            &*objective,
            &mut newton(),
            stop,
            checkpoints,
            &mut [],
        )
    };
    let (x, first) = after(6);
    let size = std::fs::metadata(&file).unwrap().len();
    assert!(size < 4 * x.len() as u64 + 8000, "{size} bytes");
    let (_, second) = after(3);
    let (first, second) = (first.unwrap(), second.unwrap());
    assert_eq!(second.history.len(), 4);
    assert!((second.history[0].loss - first.loss).abs() < 1e-5 * first.loss);
}

#[test]
fn a_dose_that_begins_beyond_a_threshold_is_optimized() {
    let model = Twisted {
        induction: 0.1,
        ..Twisted::of(SmallModel::new(16, 24, 1))
    };
    let objective = objective(&model.inner, "l2");
    let stop = Stop::after(30);
    let outcome = go(&model, &*objective, &mut newton(), stop).1.unwrap();
    let losses = &outcome.history;
    // A tiny step alone makes no dose: its length must come from the dose that is there
    assert!(losses[1].loss < 0.9 * losses[0].loss, "{losses:?}");
    assert!(outcome.loss < 0.5 * losses[0].loss, "{losses:?}");
}
