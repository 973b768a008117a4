//! Adam, projected onto the bounds.
//!
//! **Step** k = 1, 2, … with the gradient g, per pixel
//!
//! ```text
//! m ← β₁·m + (1 − β₁)·g       v ← β₂·v + (1 − β₂)·g²
//! x ← P( x − η_k · m/(1 − β₁^k) / (√(v/(1 − β₂^k)) + ε) )
//! ```
//!
//! with η_k = `step`, or `step`/√k for `schedule = "root"`: every pixel moves by about η_k whatever its gradient, so a constant step
//! ends in noise of that size.
//!
//! **Source** Kingma and Ba, ICLR 2015, algorithm 1; the decay 1/√k is that of their section 4.
//!
//! **Parameters** see [`Params`]. **Limits** none but memory; built for noisy gradients, which a dose model's are not. The loss may
//! rise, the best patterns are kept. **Cost** one forward and one adjoint call a step; four pattern fields.

use super::{
    BuildOptimizer, Checkpoint, MakeOptimizer, Memory, Optimizer, Position, Problem, Requirements,
    Step, read, read_saved_fields, read_saved_numbers, zeros,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, check_ranges, schema_of};

/// How the step changes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StepSchedule {
    /// All steps are `step`.
    #[default]
    Constant,
    /// Step k is `step`/√k.
    Root,
}

tomolith_core::keys! {
    /// The parameters of Adam.
    pub struct Params {
        /// Length of the first step in units of x
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub step: f64 = 0.1,
        /// How it changes: "constant" or "root" (step/√k)
        pub schedule: StepSchedule = StepSchedule::Constant,
        /// β₁: share of the past in the mean of gradients
        #[schemars(extend("minimum" = 0.0, "exclusiveMaximum" = 1.0))]
        pub beta_1: f64 = 0.9,
        /// β₂: the same for their squares
        #[schemars(extend("minimum" = 0.0, "exclusiveMaximum" = 1.0))]
        pub beta_2: f64 = 0.999,
        /// ε: added to the root of the squares, in units of the gradient
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub epsilon: f64 = 1e-8,
    }
}

/// Adam; see the [module](self).
pub struct Adam<F> {
    params: Params,
    steps: i32,
    /// Gradient, its mean, the mean of its squares, step.
    fields: Option<[F; 4]>,
}

/// The numbers of a checkpoint: steps done, under the method's name.
#[derive(Deserialize, Serialize)]
struct SavedNumbers {
    adam: i32,
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildOptimizer<F>> {
    Kind {
        name: "adam",
        summary: "Adam within bounds: steps of one length for all pixels, whatever their gradient",
        example: "[optimizer.adam]\nstep = 0.1",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}

impl<F: Field> MakeOptimizer<F> for Params {
    fn make(&self) -> Result<Box<dyn Optimizer<F>>> {
        Ok(Box::new(Adam::new(self.clone())?))
    }
}

impl<F: Field> Adam<F> {
    /// The method with these parameters.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) naming the key that is out of range.
    pub fn new(params: Params) -> Result<Self> {
        check_ranges("", &params)?;
        Ok(Adam {
            params,
            steps: 0,
            fields: None,
        })
    }
}

impl<F: Field> Optimizer<F> for Adam<F> {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn step(&mut self, problem: &mut Problem<F>, x: &mut F, at: &mut Position<F>) -> Result<Step> {
        let mut fields = self.fields.take().unwrap_or_else(|| zeros(x));
        let [gradient, mean, square, step] = &mut fields;
        problem.gradient(x, at, gradient)?;
        self.steps += 1;
        let k = self.steps;
        let Params {
            beta_1,
            beta_2,
            epsilon,
            ..
        } = self.params;
        let length = match self.params.schedule {
            StepSchedule::Root => self.params.step / f64::from(k).sqrt(),
            StepSchedule::Constant => self.params.step,
        };
        let (b1, b2, epsilon) = (beta_1 as f32, beta_2 as f32, epsilon as f32);
        mean.mix(b1, gradient);
        square.mix_squares(b2, gradient);
        let grown = (1.0 / (1.0 - beta_2.powi(k))) as f32;
        gradient.copy_from(mean);
        gradient.divide_by_roots(square, grown, epsilon);
        let t = (length / (1.0 - beta_1.powi(k))) as f32;
        let sums = step.project_step(x, gradient, t, problem.bounds(x));
        let mut taken = 0.0;
        if sums.square != 0.0 {
            problem.full_step(x, step, at)?;
            taken = length;
        }
        self.fields = Some(fields);
        Ok(Step {
            projected_gradient: sums.square.sqrt() / length,
            length: taken,
        })
    }

    fn requirements(&self) -> Requirements {
        Requirements::of("adam")
    }

    fn memory(&self) -> Memory<'_> {
        let fields = self.fields.as_ref();
        let fields = fields.map(|[_, mean, square, _]| [("mean", mean), ("square", square)]);
        Memory::of(
            SavedNumbers { adam: self.steps },
            fields.as_slice().as_flattened(),
        )
    }

    fn restore(&mut self, memory: &mut Checkpoint, _: &Problem<F>, x: &F) -> Result<()> {
        let SavedNumbers { adam } = read_saved_numbers(memory)?;
        self.steps = adam;
        if adam > 0 {
            let mut fields = zeros(x);
            let [_, mean, square, _] = &mut fields;
            read_saved_fields(memory, &mut [("mean", mean), ("square", square)])?;
            self.fields = Some(fields);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::{Case, assert_near};
    use tomolith_core::field::HostField;

    #[test]
    fn it_follows_algorithm_1_step_by_step() {
        let case = Case::new();
        let objective = case.objective("l2", serde_json::json!({}));
        for schedule in [StepSchedule::Root, StepSchedule::Constant] {
            let params = Params {
                step: 0.03,
                schedule,
                beta_1: 0.8,
                beta_2: 0.95,
                epsilon: 1e-3,
            };
            let mut adam = Adam::<HostField>::new(params).unwrap();
            let found = case.run(&*objective, &mut adam, 8, None);
            let marked = case.marked_target();
            let mut x = case.start();
            let (mut m, mut v) = (vec![0.0; x.len()], vec![0.0; x.len()]);
            for k in 1..=8 {
                let slopes: Vec<f64> = case
                    .dense
                    .forward(&x)
                    .iter()
                    .zip(&marked)
                    .map(|(f, &t)| if t < 0.0 { 0.0 } else { 2.0 * (f - t) })
                    .collect();
                let g = case.dense.adjoint(&slopes);
                let step = match schedule {
                    StepSchedule::Root => 0.03 / f64::from(k).sqrt(),
                    StepSchedule::Constant => 0.03,
                };
                for i in 0..x.len() {
                    m[i] = 0.8 * m[i] + 0.2 * g[i];
                    v[i] = 0.95 * v[i] + 0.05 * g[i] * g[i];
                    let (mean, square) = (
                        m[i] / (1.0 - 0.8f64.powi(k)),
                        v[i] / (1.0 - 0.95f64.powi(k)),
                    );
                    x[i] = (x[i] - step * mean / (square.sqrt() + 1e-3)).max(0.0);
                }
                let at = usize::try_from(k).unwrap();
                let what = format!("{schedule:?}, step {k}");
                assert_near(&found.patterns[at], &x, 1e-4, &what);
            }
        }
    }
}
