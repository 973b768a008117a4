//! Projected gradient: the plain method, every step of it easy to understand.
//!
//! **Step** p = P(x − t·g) − x with the gradient g and the projection P onto the bounds; then x ← x + α·p.
//!
//! **Automatic length** t is the Barzilai–Borwein length of the last step, s·s/s·y and s·y/y·y in turn (s the change of x, y that
//! of the gradient, both only where x moved), and α the exact minimum on the feasible segment: the loss never rises.
//! **Fixed length** t is given, α = 1, and the loss may rise. With momentum m the gradient is replaced by its running mean
//! u ← m·u + (1 − m)·g, u = 0 at the start: the heavy ball as the VAMToolbox family writes it.
//!
//! **Source** Barzilai and Borwein, IMA J. Numer. Anal. 8 (1988) 141; Birgin, Martínez and Raydan, SIAM J. Optim. 10 (2000) 1196.
//!
//! **Parameters** see [`Params`]. **Cost** one forward and one adjoint call a step; 12 bytes read and 4 written per pixel to make
//! the step, 12 for its secant, 12 to move. Memory: three pattern vectors (step and two gradients).

use super::{
    BuildOptimizer, Checkpoint, MakeOptimizer, Memory, Optimizer, Position, Problem, Requirements,
    Step, read, read_saved_fields, read_saved_numbers, zeros,
};
use serde::{Deserialize, Serialize};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, check_ranges, schema_of};
use tomolith_core::units::exact;

tomolith_core::keys! {
    /// The parameters of the projected gradient.
    pub struct Params {
        /// Fixed length t of a step, in units of x per unit of gradient; automatic when it is not given
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub step: Option<f64>,
        /// Share of the past in the running mean of gradients; needs a fixed step
        #[schemars(extend("minimum" = 0.0, "exclusiveMaximum" = 1.0))]
        pub momentum: f64 = 0.0,
    }
}

/// The projected gradient method.
pub struct Gradient<F> {
    params: Params,
    length: f64,
    alpha: f64,
    steps: u64,
    /// Gradient, the one before, step.
    fields: Option<[F; 3]>,
}

#[derive(Deserialize, Serialize)]
struct SavedNumbers {
    length: f64,
    alpha: f64,
    steps: u64,
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildOptimizer<F>> {
    Kind {
        name: "gradient",
        summary: "projected gradient, step length automatic or fixed",
        example: "[optimizer.gradient]",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}

impl<F: Field> MakeOptimizer<F> for Params {
    fn make(&self) -> Result<Box<dyn Optimizer<F>>> {
        Ok(Box::new(Gradient::new(self.clone())?))
    }
}

impl<F: Field> Gradient<F> {
    /// The method with these parameters.
    ///
    /// # Errors
    /// [`Error::Config`] for a step that is not above 0.
    pub fn new(params: Params) -> Result<Self> {
        check_ranges("", &params)?;
        if params.momentum > 0.0 && params.step.is_none() {
            return Err(Error::config(
                "momentum",
                format!("found {} without `step`", exact(params.momentum)),
                "momentum with a fixed step; the automatic length has its own memory",
            ));
        }
        Ok(Gradient {
            params,
            length: 0.0,
            alpha: 0.0,
            steps: 0,
            fields: None,
        })
    }

    /// t of the next step from the secant of the last one.
    fn next_length(&self, gradient: &F, before: &F, step: &F) -> f64 {
        let secant = step.secant(before, gradient);
        if secant.py <= 0.0 {
            return self.length * 4.0;
        }
        // The step was α·p, so s·s/s·y carries one α, and s·y/y·y another
        let length = if self.steps.is_multiple_of(2) {
            secant.pp / secant.py
        } else {
            secant.py / secant.yy
        };
        (self.alpha * length).clamp(self.length * 1e-3, self.length * 1e3)
    }
}

impl<F: Field> Optimizer<F> for Gradient<F> {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn step(&mut self, problem: &mut Problem<F>, x: &mut F, at: &mut Position<F>) -> Result<Step> {
        let mut fields = self.fields.take().unwrap_or_else(|| zeros(x));
        let [gradient, before, step] = &mut fields;
        std::mem::swap(gradient, before);
        problem.gradient(x, at, gradient)?;
        let mut measured = None;
        if let (true, Some(length)) = (self.params.momentum > 0.0, self.params.step) {
            // Steps follow the mean, but how near the end is the gradient says
            let sums = step.project_step(x, gradient, length as f32, problem.bounds(x));
            measured = Some(sums.square);
            let m = self.params.momentum as f32;
            gradient.scale(1.0 - m);
            gradient.axpy(m, before);
        }
        self.length = match self.params.step {
            Some(length) => length,
            None if self.steps == 0 => problem.first_length(x, gradient, step, at)?,
            None => self.next_length(gradient, before, step),
        };
        let sums = step.project_step(x, gradient, self.length as f32, problem.bounds(x));
        let projected_gradient = if self.length == 0.0 {
            0.0
        } else {
            measured.unwrap_or(sums.square).sqrt() / self.length
        };
        let length = if sums.square == 0.0 {
            0.0
        } else if self.params.step.is_some() {
            problem.full_step(x, step, at)?;
            self.length
        } else {
            self.alpha = f64::from(problem.search(x, step, sums.slope, at)?.alpha);
            self.alpha
        };
        self.steps += 1;
        self.fields = Some(fields);
        Ok(Step {
            projected_gradient,
            length,
        })
    }

    fn is_monotone(&self) -> bool {
        self.params.step.is_none()
    }

    fn requirements(&self) -> Requirements {
        Requirements {
            continuous: self.params.step.is_none().then_some(
                "the automatic step length comes from a line search, which rounding breaks; give `step`",
            ),
            ..Requirements::of("gradient")
        }
    }

    fn memory(&self) -> Memory<'_> {
        let saved = SavedNumbers {
            length: self.length,
            alpha: self.alpha,
            steps: self.steps,
        };
        let fields = self.fields.as_ref();
        let fields = fields.map(|[gradient, _, step]| [("gradient", gradient), ("step", step)]);
        Memory::of(saved, fields.as_slice().as_flattened())
    }

    fn restore(&mut self, memory: &mut Checkpoint, _: &Problem<F>, x: &F) -> Result<()> {
        let saved: SavedNumbers = read_saved_numbers(memory)?;
        (self.length, self.alpha, self.steps) = (saved.length, saved.alpha, saved.steps);
        if self.steps > 0 {
            let mut fields = zeros(x);
            let [gradient, _, step] = &mut fields;
            read_saved_fields(memory, &mut [("gradient", gradient), ("step", step)])?;
            self.fields = Some(fields);
        }
        Ok(())
    }
}
