//! What every optimizer must do.

use crate::checkpoint::Params;
use crate::{Checkpoints, Limits, MakeOptimizer, Outcome, Problem, StepReport, Stop, run};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use tomolith_core::check::small::SmallModel;
use tomolith_core::check::{dose, even_patterns, noisy_patterns, on_threads};
use tomolith_core::dose::Work;
use tomolith_core::error::Error;
use tomolith_core::field::{Field, HostField};
use tomolith_core::response::Identity;
use tomolith_objective::{BandObjective, Bands};

/// Checks an optimizer on a small convex problem whose least loss is known to be 0: least squares against the dose of patterns
/// most of whose pixels are dark, within bounds.
///
/// - after 100 steps the loss is below a thousandth of its start (not required of a method that normalizes its doses, which follows a
///   rule of its own; its largest wanted dose is 1);
/// - no pixel ever leaves the bounds, and the loss never rises when the method says so;
/// - a run that is cut off and resumed from its checkpoint has the bits of the uninterrupted one;
/// - the same bits for 1, 2 and 8 threads.
///
/// Its checkpoint lies in `folder`, which holds none before.
///
/// # Errors
/// What is wrong, in one sentence.
pub fn optimizer(method: &dyn MakeOptimizer, folder: &Path) -> Result<(), String> {
    let normalizes = method.make().map_err(text)?.normalizes();
    let problem = TestProblem::new(normalizes)?;
    let whole = problem.run(method, 100, None)?;
    let losses: Vec<f64> = whole.1.history.iter().map(|row| row.loss).collect();
    if !normalizes && whole.1.loss > 1e-3 * losses[0] {
        return Err(format!(
            "the loss fell from {} to {} only",
            losses[0], whole.1.loss
        ));
    }
    problem.resumes(method, folder)?;
    problem.ignores_threads(method)
}

struct TestProblem {
    model: SmallModel,
    objective: BandObjective,
    /// The dose that is wanted.
    target: HostField,
}

const LIMITS: Limits = Limits { min: 0.0, max: 1.5 };

type Done = (HostField, Outcome);

impl TestProblem {
    fn new(normalizes: bool) -> Result<Self, String> {
        let model = SmallModel::new(14, 20, 3);
        let mut patterns = noisy_patterns(&model, 3);
        for x in patterns.as_mut_slice() {
            *x = if *x > 0.4 { *x } else { 0.0 };
        }
        let mut dose = dose(&model, &patterns);
        if normalizes {
            dose.scale(1.0 / dose.max_abs());
        }
        let values: Arc<[f32]> = dose.as_slice().into();
        let weight = vec![1.0; values.len()].into();
        let bands = Bands::Voxels {
            lower: values.clone(),
            upper: values,
            weight,
        };
        let range = model.layout().range();
        let objective =
            BandObjective::new(range, bands, 2.0, 2.0, Arc::new(Identity)).map_err(text)?;
        Ok(TestProblem {
            model,
            objective,
            target: dose,
        })
    }

    fn run(
        &self,
        method: &dyn MakeOptimizer,
        iterations: usize,
        checkpoints: Option<&mut Checkpoints>,
    ) -> Result<Done, String> {
        let run_flag = Work::new();
        let mut optimizer = method.make().map_err(text)?;
        let monotone = optimizer.is_monotone();
        let mut problem =
            Problem::new(&self.model, &self.objective, &[LIMITS], &run_flag).map_err(text)?;
        problem = problem.with_target(self.target.clone());
        let mut x = even_patterns(&self.model, 0.5);
        let stop = Stop::after(iterations);
        let (mut wrong, mut last) = (None, f64::INFINITY);
        let mut watch = |report: &StepReport<HostField>| {
            let inside = |&v: &f32| (0.0..=1.5).contains(&v);
            if !report.patterns.as_slice().iter().all(inside) {
                wrong = Some(format!(
                    "a pixel left the bounds in step {}",
                    report.row.iteration
                ));
            }
            if monotone && report.row.loss > last {
                wrong = Some(format!(
                    "the loss rose from {last} to {} in step {}",
                    report.row.loss, report.row.iteration
                ));
            }
            last = report.row.loss;
            if wrong.is_some() {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let outcome = run(
            &mut problem,
            &mut *optimizer,
            &mut x,
            &stop,
            checkpoints,
            &mut [&mut watch],
        );
        let outcome = outcome.map_err(text)?;
        wrong.map_or(Ok((x, outcome)), Err)
    }

    fn resumes(&self, method: &dyn MakeOptimizer, folder: &Path) -> Result<(), String> {
        let whole = self.run(method, 20, None)?;
        for iterations in [0, 1, 7, 8, 20] {
            let params = Params::default();
            let mut checkpoints = Checkpoints::new(folder, 42, &params).map_err(text)?;
            let part = self.run(method, iterations, Some(&mut checkpoints))?;
            if iterations == 20 {
                same("a resumed run", &whole, &part)?;
            }
        }
        Ok(())
    }

    fn ignores_threads(&self, method: &dyn MakeOptimizer) -> Result<(), String> {
        let runs = [1, 2, 8].map(|threads| on_threads(threads, || self.run(method, 12, None)));
        let [one, two, eight] = runs;
        let one = one?;
        same("two threads", &one, &two?)?;
        same("eight threads", &one, &eight?)
    }
}

/// Compares bit for bit, times apart.
fn same(what: &str, a: &Done, b: &Done) -> Result<(), String> {
    let bits = |x: &HostField| x.as_slice().iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    if bits(&a.0) != bits(&b.0) {
        return Err(format!("{what}: other patterns"));
    }
    let rows = |o: &Outcome| {
        let row = |r: &crate::Row| {
            (
                r.iteration,
                r.loss,
                r.projected_gradient,
                r.step,
                r.forward,
                r.adjoint,
            )
        };
        o.history.iter().map(row).collect::<Vec<_>>()
    };
    if rows(&a.1) == rows(&b.1) {
        Ok(())
    } else {
        Err(format!("{what}: another history"))
    }
}

fn text(error: Error) -> String {
    error.to_string()
}
