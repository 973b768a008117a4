//! BCLP's descent: projected gradient with a raw step, as published.
//!
//! **Step** with η = `step` and the projection P onto the bounds (and levels, with `bounds.bits`)
//!
//! ```text
//! x ← P(x − η·∇L(x))
//! ```
//!
//! **Alternate handling** (`alternate = true`): odd steps correct overdose only, even steps underdose only, by the positive or
//! negative part of ∂L/∂dose. With one-sided bands that is the published weight w_k, 1 in the void in their even iterations
//! (counted from 0) and 1 in the part in the others. A step that would find no error of its kind takes the other kind instead;
//! no model call is spent on nothing. Each correction keeps the factor q·L^((q−p)/q) of the whole loss, which is 1 for p = q,
//! the case they studied; they saw no benefit.
//!
//! **Units** η is in x² per unit of loss. A dose model that is α times another one needs η/α² of the other. A step given for
//! line integrals in voxels, Aᵀ, becomes for F = φ·Aᵀ in our patterns x = b/φ: η_F = η_A/φ²; for pure Radon φ is pitch-free,
//! 1 in each of the frames that are summed.
//!
//! **Source** Li, Toombs, Taylor and Wallin, Additive Manufacturing 94 (2024) 104447: eq. 5; S.10 and eqs. 25–27 for the
//! alternate handling. Their stop rule, eq. 28, is `stop.change = 0.001`; their start, eqs. 2, 3 and S.5, is `[start.fbp]`
//! with `scale = "analytic"`; their objective is [`bclp`](tomolith_objective::bclp).
//!
//! **Parameters** see [`Params`]. **Limits** a step that is too long makes the loss rise; the best patterns are kept. **Cost** one
//! forward and one adjoint call a step; two pattern fields.

use super::alternating::AlternatingHalf;
use super::{
    BuildOptimizer, Checkpoint, MakeOptimizer, Memory, Optimizer, Position, Problem, Requirements,
    Step, read, read_saved_numbers, zeros,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, check_ranges, schema_of};

/// The parameters of BCLP's descent.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// η: length of a step, in units of x per unit of gradient
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub step: f64,
    /// Whether overdose and underdose are corrected in turn, or together
    #[serde(default)]
    pub alternate: bool,
}

/// BCLP's descent; see the [module](self).
pub struct Bclp<F> {
    params: Params,
    steps: u64,
    /// Gradient, step.
    fields: Option<[F; 2]>,
}

/// The numbers of a checkpoint: steps done, under the method's name.
#[derive(Deserialize, Serialize)]
struct SavedNumbers {
    bclp: u64,
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildOptimizer<F>> {
    Kind {
        name: "bclp",
        summary: "BCLP's descent as published: a raw step, over- and underdose together or in turn",
        example: "[optimizer.bclp]\nstep = 1.2",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}

impl<F: Field> MakeOptimizer<F> for Params {
    fn make(&self) -> Result<Box<dyn Optimizer<F>>> {
        Ok(Box::new(Bclp::new(self.clone())?))
    }
}

impl<F: Field> Bclp<F> {
    /// The method with these parameters.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) for a step that is not above 0.
    pub fn new(params: Params) -> Result<Self> {
        check_ranges("", &params)?;
        Ok(Bclp {
            params,
            steps: 0,
            fields: None,
        })
    }

    /// The step that corrects one kind of error, all of it when None; returns its squared norm.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn search_direction(
        &self,
        half: Option<AlternatingHalf>,
        problem: &mut Problem<F>,
        x: &F,
        at: &mut Position<F>,
        [gradient, step]: &mut [F; 2],
    ) -> Result<f64> {
        if let Some(half) = half {
            // The cotangent is taken anew after the step
            half.keep(&mut at.cotangent);
            if at.cotangent.max_abs() == 0.0 {
                return Ok(0.0);
            }
        }
        problem.gradient(x, at, gradient)?;
        let sums = step.project_step(x, gradient, self.params.step as f32, problem.bounds(x));
        Ok(sums.square)
    }
}

impl<F: Field> Optimizer<F> for Bclp<F> {
    fn step(&mut self, problem: &mut Problem<F>, x: &mut F, at: &mut Position<F>) -> Result<Step> {
        let mut fields = self.fields.take().unwrap_or_else(|| zeros(x));
        let half = self
            .params
            .alternate
            .then(|| AlternatingHalf::of(self.steps));
        let mut square = self.search_direction(half, problem, x, at, &mut fields)?;
        if let (Some(half), 0.0) = (half, square) {
            at.loss = problem.objective_at(&at.dose, &mut at.cotangent);
            square = self.search_direction(Some(half.other()), problem, x, at, &mut fields)?;
        }
        let mut length = 0.0;
        if square > 0.0 || square.is_nan() {
            problem.full_step(x, &fields[1], at)?;
            length = self.params.step;
        }
        self.steps += 1;
        self.fields = Some(fields);
        Ok(Step {
            projected_gradient: square.sqrt() / self.params.step,
            length,
        })
    }

    fn requirements(&self) -> Requirements {
        Requirements::of("bclp")
    }

    fn memory(&self) -> Memory<'_> {
        Memory::of::<F>(SavedNumbers { bclp: self.steps }, &[])
    }

    fn restore(&mut self, memory: &mut Checkpoint, _: &Problem<F>, _: &F) -> Result<()> {
        let SavedNumbers { bclp } = read_saved_numbers(memory)?;
        self.steps = bclp;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::{Case, assert_near};
    use serde_json::json;
    use tomolith_core::field::HostField;
    use tomolith_core::near;

    fn bclp(step: f64, alternate: bool) -> Bclp<HostField> {
        Bclp::new(Params { step, alternate }).unwrap()
    }

    /// Eq. 4 with the identity response, p and q, for the ring with ε: cotangent of every voxel.
    fn cotangent(dose: &[f64], target: &[f64], [epsilon, p, q]: [f64; 3]) -> (f64, Vec<f64>) {
        let error = |f: f64, t: f64| ((f - t).abs() - epsilon).max(0.0);
        let counted = |t: f64| t >= 0.0;
        let sum: f64 = dose
            .iter()
            .zip(target)
            .filter(|(_, t)| counted(**t))
            .map(|(&f, &t)| error(f, t).powf(p))
            .sum();
        let loss = sum.powf(q / p);
        let factor = q * loss.powf((q - p) / q);
        let slopes = dose.iter().zip(target).map(|(&f, &t)| {
            if counted(t) && error(f, t) > 0.0 {
                factor * error(f, t).powf(p - 1.0) * (f - t).signum()
            } else {
                0.0
            }
        });
        (loss, slopes.collect())
    }

    #[test]
    fn it_follows_equation_5_step_by_step() {
        let (epsilon, p, q, step) = (0.05, 2.0, 1.0, 0.4);
        let case = Case::new();
        let objective = case.objective("bclp", json!({"epsilon": epsilon}));
        let found = case.run(&*objective, &mut bclp(step, false), 8, None);
        let (mut x, target) = (case.start(), case.marked_target());
        for (found, row) in found.patterns.iter().zip(&found.outcome.history) {
            assert_near(found, &x, 2e-5, "patterns");
            let (loss, slopes) = cotangent(&case.dense.forward(&x), &target, [epsilon, p, q]);
            near!(row.loss, loss, 1e-5 * loss, "{} for {loss}", row.loss);
            let gradient = case.dense.adjoint(&slopes);
            for (x, g) in x.iter_mut().zip(&gradient) {
                *x = (*x - step * g).max(0.0);
            }
        }
    }

    #[test]
    fn alternate_handling_follows_s_10_step_by_step() {
        // Part above 1.2, void below 0.4, p = q = 2, η = ½: even iterations of theirs correct the void, odd ones the part
        let case = Case::new();
        let objective = case.objective("osmo", json!({"d_h": 1.2, "d_l": 0.4}));
        let found = case.run(&*objective, &mut bclp(0.5, true), 8, None);
        let (mut x, target) = (case.start(), case.marked_target());
        for (k, found) in found.patterns.iter().enumerate() {
            assert_near(found, &x, 2e-5, "patterns");
            let dose = case.dense.forward(&x);
            let correction: Vec<f64> = dose
                .iter()
                .zip(&target)
                .map(|(&f, &t)| match (t, k % 2) {
                    (0.0, 0) => -(f - 0.4).max(0.0),
                    (1.0, 1) => (1.2 - f).max(0.0),
                    _ => 0.0,
                })
                .collect();
            assert!(
                correction.iter().any(|c| *c != 0.0),
                "iteration {k} has nothing to correct, so the test shows nothing"
            );
            let change = case.dense.adjoint(&correction);
            for (x, change) in x.iter_mut().zip(&change) {
                *x = (*x + change).max(0.0);
            }
        }
    }

    #[test]
    fn penalties_of_pm_follow_the_same_descent() {
        // Li et al., section 3.2: PM as projected gradient, p = 1, both weights and a buffer of one voxel
        let case = Case::new();
        let json = json!({"d_h": 0.8, "d_l": 0.3, "rho_1": 2.0, "rho_2": 0.5, "buffer_mm": 1.0});
        let objective = case.objective("pm", json);
        let step = 0.02;
        let found = case.run(&*objective, &mut bclp(step, false), 8, None);
        let (mut x, target) = (case.start(), case.marked_target());
        let eroded = case.without_neighbors_of_the_other_kind();
        assert!(eroded.iter().any(|e| *e) && eroded.iter().any(|e| !e));
        for (k, (found, row)) in found
            .patterns
            .iter()
            .zip(&found.outcome.history)
            .enumerate()
        {
            assert_near(found, &x, 5e-5, "patterns");
            let dose = case.dense.forward(&x);
            let (mut loss, mut slopes) = (0.0, vec![0.0; dose.len()]);
            for i in 0..dose.len() {
                match target[i] {
                    1.0 if eroded[i] && dose[i] < 0.8 => {
                        loss += 2.0 * (0.8 - dose[i]);
                        slopes[i] = -2.0;
                    }
                    0.0 if eroded[i] && dose[i] > 0.3 => {
                        loss += 0.5 * (dose[i] - 0.3);
                        slopes[i] = 0.5;
                    }
                    _ => {}
                }
            }
            near!(row.loss, loss, 1e-4 * loss, "step {k}");
            let gradient = case.dense.adjoint(&slopes);
            for (x, g) in x.iter_mut().zip(&gradient) {
                *x = (*x - step * g).max(0.0);
            }
        }
    }
}
