//! FISTA: projected gradient from an extrapolated point, with restart.
//!
//! **Step** with x₋ the patterns before x, and t = 1 at the start and after a restart
//!
//! ```text
//! y  = x + β·(x − x₋)                     β = (t₋ − 1)/t,  t = (1 + √(1 + 4·t₋²))/2
//! x₊ = P(y − (1/L)·∇L(y))
//! ```
//!
//! The dose at y is a combination of doses at hand, so a step costs one forward and one adjoint call like any other.
//!
//! **L** is the largest curvature of the loss: `curvature`, that of the objective in the dose, times ‖F‖², found by power
//! iteration on FᵀF from uniform patterns until it changes by less than 1 % (10 times at most; a model without negative weights
//! needs about three). Should a step still fall less than L promises, L is doubled and the step taken again, one forward call
//! each. `step` gives 1/L instead, and nothing is checked.
//!
//! **Restart** `gradient`: when the step points against the way it came, (y − x₊)·(x₊ − x) > 0; `loss`: when the loss rose; `none`
//! as published first. A restart costs nothing.
//!
//! **Start** the Core Imaging Library, with which TVAM AID runs FISTA, begins from `[start.zero]`; y = x, t = 1 as here, no
//! restart, and L from a power iteration.
//!
//! **Source** Beck and Teboulle, SIAM J. Imaging Sci. 2 (2009) 183; O'Donoghue and Candès, Found. Comput. Math. 15 (2015) 715
//! (restart); Pellizzon et al., arXiv 2602.12178 (its use here).
//!
//! **Parameters** see [`Params`]. **Limits** linear models, convex objectives; the loss may rise, the best patterns are kept. Kinks
//! (p = 1) have no L: the doubling stops at 1024 times the first. **Cost** one call each way a step; at the start two calls a
//! power iteration; four pattern fields and a dose field.

use super::{
    BuildOptimizer, Checkpoint, MakeOptimizer, Memory, Optimizer, Position, Problem, Requirements,
    Step, read, read_saved_fields, read_saved_numbers,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, check_ranges, schema_of};

/// When the extrapolation begins anew.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Restart {
    /// When a step points against the way it came.
    #[default]
    Gradient,
    /// When the loss rose.
    Loss,
    /// Never.
    None,
}

tomolith_core::keys! {
    /// The parameters of FISTA.
    pub struct Params {
        /// When the extrapolation begins anew: "gradient", "loss" or "none"
        pub restart: Restart = Restart::Gradient,
        /// Largest second derivative of the objective by a voxel's dose; 2: squared distances of weight 1
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub curvature: f64 = 2.0,
        /// Fixed step 1/L, in units of x per unit of gradient; from the model when it is not given
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub step: Option<f64>,
    }
}

/// Power iterations, at most.
const POWERS: usize = 10;
/// The largest factor by which L may grow beyond its first value.
const GROWTH: f64 = 1024.0;
/// What a loss may lie above its bound by the rounding of its sum.
const ROUNDING: f64 = 1e-5;
/// What a dose in f32 may be wrong by, as a share of it.
const DOSE_ROUNDING: f64 = 1e-6;

/// FISTA; see the [module](self).
pub struct Fista<F> {
    params: Params,
    saved: SavedNumbers,
    fields: Option<Fields<F>>,
}

struct Fields<F> {
    /// x₋ between steps, y in one.
    before: F,
    dose: F,
    gradient: F,
    step: F,
    trial: F,
}

#[derive(Clone, Copy, Debug, Deserialize, Serialize)]
struct SavedNumbers {
    t: f64,
    /// L and what it was at first; 0 before the first step.
    lipschitz: [f64; 2],
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildOptimizer<F>> {
    Kind {
        name: "fista",
        summary: "FISTA with restart, step 1/L by power iteration: for linear models and convex objectives",
        example: "[optimizer.fista]\nrestart = \"gradient\"",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}

impl<F: Field> MakeOptimizer<F> for Params {
    fn make(&self) -> Result<Box<dyn Optimizer<F>>> {
        Ok(Box::new(Fista::new(self.clone())?))
    }
}

impl<F: Field> Fista<F> {
    /// The method with these parameters.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) naming the key that is out of range.
    pub fn new(params: Params) -> Result<Self> {
        check_ranges("", &params)?;
        Ok(Fista {
            params,
            saved: SavedNumbers {
                t: 1.0,
                lipschitz: [0.0; 2],
            },
            fields: None,
        })
    }

    fn fields(problem: &Problem<F>, x: &F) -> Result<Fields<F>> {
        Ok(Fields {
            before: x.clone(),
            dose: problem.model().new_dose()?,
            gradient: x.zeros_like(),
            step: x.zeros_like(),
            trial: x.zeros_like(),
        })
    }

    /// ‖F‖² times the curvature.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn largest_curvature(&self, problem: &mut Problem<F>, fields: &mut Fields<F>) -> Result<f64> {
        let Fields {
            dose,
            gradient,
            step,
            ..
        } = fields;
        step.fill(1.0);
        let mut square = 0.0;
        for _ in 0..POWERS {
            let norm = step.norm();
            if norm == 0.0 {
                break;
            }
            step.scale((1.0 / norm) as f32);
            problem.dose(step, dose)?;
            problem.project(step, dose, gradient)?;
            std::mem::swap(step, gradient);
            let last = square;
            square = step.norm();
            if (square - last).abs() <= 0.01 * square {
                break;
            }
        }
        Ok(self.params.curvature * square)
    }

    /// L at the first step.
    fn begin(&mut self, problem: &mut Problem<F>, fields: &mut Fields<F>) -> Result<()> {
        let lipschitz = match self.params.step {
            Some(step) => 1.0 / step,
            // No light, no curvature; any step will do
            None => match self.largest_curvature(problem, fields)? {
                0.0 => 1.0,
                curvature => curvature,
            },
        };
        self.saved.lipschitz = [lipschitz; 2];
        Ok(())
    }

    /// y into `before`, its dose into `dose`, ∂L/∂dose at y into the position; returns L(y).
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn extrapolate(
        &mut self,
        problem: &mut Problem<F>,
        x: &F,
        at: &mut Position<F>,
        fields: &mut Fields<F>,
    ) -> f64 {
        let last = self.saved.t;
        self.saved.t = 0.5 * (1.0 + (1.0 + 4.0 * last * last).sqrt());
        let beta = ((last - 1.0) / self.saved.t) as f32;
        if beta == 0.0 {
            fields.before.copy_from(x);
            fields.dose.copy_from(&at.dose);
            return at.loss;
        }
        for (before, now) in [(&mut fields.before, x), (&mut fields.dose, &at.dose)] {
            before.scale(-beta);
            before.axpy(1.0 + beta, now);
        }
        problem.objective_at(&fields.dose, &mut at.cotangent)
            + problem.penalties().value(&fields.before)
    }
}

impl<F: Field> Optimizer<F> for Fista<F> {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn step(&mut self, problem: &mut Problem<F>, x: &mut F, at: &mut Position<F>) -> Result<Step> {
        let mut fields = match self.fields.take() {
            Some(fields) => fields,
            None => {
                let mut fields = Self::fields(problem, x)?;
                self.begin(problem, &mut fields)?;
                fields
            }
        };
        let (last, loss_at_y) = (at.loss, self.extrapolate(problem, x, at, &mut fields));
        let Fields {
            before: y,
            dose,
            gradient,
            step,
            trial,
        } = &mut fields;
        problem.gradient(x, at, gradient)?;
        std::mem::swap(&mut at.dose, dose);
        let checked = self.params.step.is_none() && problem.levels().is_none();
        let [lipschitz, first] = self.saved.lipschitz;
        let mut lipschitz = lipschitz;
        let sums = loop {
            let length = (1.0 / lipschitz) as f32;
            let sums = step.project_step(y, gradient, length, problem.bounds(x));
            trial.copy_from(y);
            trial.axpy(1.0, step);
            problem.evaluate(trial, at)?;
            let promised = loss_at_y + sums.slope + 0.5 * lipschitz * sums.square;
            // Near a loss of zero what rounding does to the doses is more than a step gains
            let is_accepted = at.loss <= promised + ROUNDING * loss_at_y
                || at.loss <= promised + DOSE_ROUNDING * at.cotangent.norm() * at.dose.norm();
            if is_accepted || !checked || lipschitz >= GROWTH * first || !at.loss.is_finite() {
                break sums;
            }
            lipschitz *= 2.0;
        };
        self.saved.lipschitz = [lipschitz, first];
        let restart = match self.params.restart {
            // (y − x₊)·(x₊ − x) with y − x₊ = −step
            Restart::Gradient => step.dot(trial) - step.dot(x) < 0.0,
            Restart::Loss => at.loss > last,
            Restart::None => false,
        };
        if restart {
            self.saved.t = 1.0;
        }
        std::mem::swap(x, y);
        std::mem::swap(x, trial);
        self.fields = Some(fields);
        Ok(Step {
            projected_gradient: sums.square.sqrt() * lipschitz,
            // Where no step leads away from y, x₊ = y is the minimum
            length: if sums.square == 0.0 {
                0.0
            } else {
                1.0 / lipschitz
            },
        })
    }

    fn requirements(&self) -> Requirements {
        Requirements {
            linear: Some("the dose of an extrapolated point is a combination of two doses"),
            convex: Some("its step and its momentum rest on a bound of the curvature"),
            ..Requirements::of("fista")
        }
    }

    fn memory(&self) -> Memory<'_> {
        let fields = (self.fields.as_ref()).map(|f| [("before", &f.before), ("dose", &f.dose)]);
        Memory::of(self.saved, fields.as_slice().as_flattened())
    }

    fn restore(&mut self, memory: &mut Checkpoint, problem: &Problem<F>, x: &F) -> Result<()> {
        self.saved = read_saved_numbers(memory)?;
        if self.saved.lipschitz[0] > 0.0 {
            let mut fields = Self::fields(problem, x)?;
            let saved = &mut [("before", &mut fields.before), ("dose", &mut fields.dose)];
            read_saved_fields(memory, saved)?;
            self.fields = Some(fields);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Limits;
    use crate::reference::{Case, assert_near};
    use serde_json::json;
    use tomolith_core::dose::Work;
    use tomolith_core::field::HostField;
    use tomolith_core::near;

    fn fista(params: Params) -> Fista<HostField> {
        Fista::new(params).unwrap()
    }

    #[test]
    fn it_follows_beck_and_teboulle_step_by_step() {
        let case = Case::new();
        let objective = case.objective("l2", json!({}));
        // Both rules restart near step 28; later losses are too alike for f32 to tell a rise
        let step = 0.9;
        for restart in [Restart::None, Restart::Gradient, Restart::Loss] {
            let params = Params {
                restart,
                step: Some(step),
                ..Params::default()
            };
            let found = case.run(&*objective, &mut fista(params), 45, None);
            let marked = case.marked_target();
            let loss_and_slopes = |x: &[f64]| {
                let dose = case.dense.forward(x);
                let errors: Vec<f64> = dose
                    .iter()
                    .zip(&marked)
                    .map(|(f, &t)| if t < 0.0 { 0.0 } else { f - t })
                    .collect();
                let slopes: Vec<f64> = errors.iter().map(|e| 2.0 * e).collect();
                (errors.iter().map(|e| e * e).sum::<f64>(), slopes)
            };
            let (mut x, mut before, mut t) = (case.start(), case.start(), 1.0f64);
            let mut restarts = 0;
            for k in 1..=45 {
                let next = 0.5 * (1.0 + (1.0 + 4.0 * t * t).sqrt());
                let beta = (t - 1.0) / next;
                let y: Vec<f64> = x
                    .iter()
                    .zip(&before)
                    .map(|(x, b)| x + beta * (x - b))
                    .collect();
                let gradient = case.dense.adjoint(&loss_and_slopes(&y).1);
                let new: Vec<f64> = y
                    .iter()
                    .zip(&gradient)
                    .map(|(y, g)| (y - step * g).max(0.0))
                    .collect();
                let against: f64 = (0..x.len())
                    .map(|i| (y[i] - new[i]) * (new[i] - x[i]))
                    .sum();
                let again = match restart {
                    Restart::Gradient => against > 0.0,
                    Restart::Loss => loss_and_slopes(&new).0 > loss_and_slopes(&x).0,
                    Restart::None => false,
                };
                t = if again { 1.0 } else { next };
                restarts += usize::from(again);
                before = std::mem::replace(&mut x, new);
                let what = format!("{restart:?}, step {k}");
                assert_near(&found.patterns[k], &x, 1e-4, &what);
            }
            assert_eq!(
                restart == Restart::None,
                restarts == 0,
                "{restart:?}: {restarts}"
            );
        }
    }

    #[test]
    fn the_power_iteration_finds_the_largest_curvature() {
        let case = Case::of(14, 20);
        let dense = &case.dense;
        let mut v = vec![1.0; 14 * 20];
        let mut square = 0.0;
        for _ in 0..500 {
            let w = dense.adjoint(&dense.forward(&v));
            square = w.iter().map(|w| w * w).sum::<f64>().sqrt();
            v = w.iter().map(|w| w / square).collect();
        }
        let objective = case.objective("l2", json!({}));
        let flag = Work::new();
        let mut problem =
            Problem::new(&case.model, &*objective, &[Limits::default()], &flag).unwrap();
        let x = HostField::zeros(14 * 20);
        let method = fista(Params::default());
        let mut fields = Fista::fields(&problem, &x).unwrap();
        let found = method.largest_curvature(&mut problem, &mut fields).unwrap();
        near!(found / (2.0 * square), 1.0, 0.01, "{found}");
    }

    #[test]
    fn a_curvature_that_is_too_small_is_found_out() {
        let case = Case::new();
        let objective = case.objective("l2", json!({}));
        let good = case.run(&*objective, &mut fista(Params::default()), 30, None);
        let params = Params {
            curvature: 0.05,
            ..Params::default()
        };
        let mut small = fista(params);
        let found = case.run(&*objective, &mut small, 30, None);
        let [now, first] = small.saved.lipschitz;
        assert!(now >= 8.0 * first, "L stayed at {now}");
        assert!(
            found.outcome.loss < 1.1 * good.outcome.loss,
            "{} against {}",
            found.outcome.loss,
            good.outcome.loss
        );
    }

    /// Raised there, L grows until momentum is all that moves the patterns, away from the minimum.
    #[test]
    fn rounding_near_a_loss_of_zero_raises_no_l() {
        let case = Case::new();
        let objective = case.objective("l2n", json!({"lower": 0.85, "upper": 0.9}));
        let params = Params {
            restart: Restart::None,
            ..Params::default()
        };
        let mut method = fista(params);
        let found = case.run(&*objective, &mut method, 4000, None);
        let [now, first] = method.saved.lipschitz;
        let last = found.outcome.history.last().unwrap().loss;
        assert_eq!(
            now,
            first,
            "L grew {} times, to a loss of {last:e}",
            now / first
        );
        assert!(
            last <= 2.0 * found.outcome.loss,
            "{last:e} after {:e}",
            found.outcome.loss
        );
    }

    #[test]
    fn an_objective_that_is_not_convex_is_refused_with_both_keys() {
        let case = Case::new();
        let objective = case.objective("bclp", json!({"p": 0.5}));
        let (.., outcome) = case.try_run(&*objective, &mut fista(Params::default()), 3, None);
        let refusal = outcome.unwrap_err().to_string();
        tomolith_core::contains!(refusal, "optimizer.fista", "objective");
    }
}
