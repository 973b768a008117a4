//! CAL: computed axial lithography's iteration, as published.
//!
//! **Step** with the target T, the logistic σ and the projection A = Fᵀ/φ in units of voxels
//!
//! ```text
//! f = N F(b)                                  the dose of the patterns b, divided by its largest value
//! δ = A( σ((f − d_h)/sigmoid) − T )           in voxels that count
//! g = (1 − m)·δ + m/(1 − m^(k+1))·δ_before    k = 1, 2, …; m = momentum
//! b ← max(b − learning_rate·g, 0)             rounded to `bounds.bits` levels between 0 and its largest pixel
//! ```
//!
//! It is the gradient of no objective: the slope of σ is left out. The job's objective only watches; the iterate with the best
//! print is [kept](super::keep). The average has two terms, since δ_before is the last δ itself, not a running mean.
//!
//! **Units** learning rates are published for sums over angles of line integrals in voxels. Here b is the pattern in units of the
//! exact inversion ([`Projection::inverse`](super::filter::Projection::inverse)), c = π/(2Nφ²), in which the published step is
//! learning_rate·c·Fᵀ(…). For pure Radon and pixels as large as voxels that is the published iteration.
//!
//! **Start** b = c·max(R Fᵀ T, 0) with the window `filter` of the [ramp](super::filter); the job's `[start]` is only row 0.
//!
//! **Scale** as [`osmo`](super::osmo): the patterns returned give the largest counted dose 1.
//!
//! **Source** Kelly et al., Science 363 (2019) 1075; the form, the sigmoid and the two-term average of the VAMToolbox family (2.0).
//!
//! **Parameters** see [`Params`]. **Limits** linear models; the loss may rise. **Cost** one forward and one adjoint call a step, one
//! of each more at the first; three pattern fields and the target.

use super::filter::{Filter, target_projection};
use super::{
    BuildOptimizer, Checkpoint, MakeOptimizer, Memory, Optimizer, Position, Problem, Requirements,
    Step, read, read_saved_fields, read_saved_numbers, zeros,
};
use serde::{Deserialize, Serialize};
use tomolith_core::error::Result;
use tomolith_core::field::{Bounds, Field};
use tomolith_core::kind::{Kind, check_ranges, schema_of};

tomolith_core::keys! {
    /// The parameters of CAL.
    pub struct Params {
        /// Window of the ramp that the target's projection is filtered with: "ram_lak", "shepp_logan", "cosine", "hamming",
        /// "hann", or "none"
        pub filter: Filter = Filter::RamLak,
        /// Length of a step
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub learning_rate: f64 = 0.01,
        /// Share of the last correction
        #[schemars(extend("minimum" = 0.0, "exclusiveMaximum" = 1.0))]
        pub momentum: f64 = 0.0,
        /// Width of the logistic, in units of the largest dose
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub sigmoid: f64 = 0.01,
        /// Threshold of the logistic, a share of the largest dose
        pub d_h: f64 = 0.8,
    }
}

/// CAL; see the [module](self).
pub struct Cal<F> {
    params: Params,
    saved: SavedNumbers,
    /// δ = A(σ − T), to within its factor, the one before, and work space.
    fields: Option<[F; 3]>,
}

#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize)]
struct SavedNumbers {
    /// Steps done.
    cal: i32,
    /// Largest dose of b: the patterns are b divided by it.
    largest: f64,
    /// c of the exact inversion.
    inverse: f64,
}

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildOptimizer<F>> {
    Kind {
        name: "cal",
        summary: "CAL as published: steps along the projected error of a sigmoid, doses relative to the largest",
        example: "[optimizer.cal]\nlearning_rate = 0.01\nd_h = 0.8",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}

impl<F: Field> MakeOptimizer<F> for Params {
    fn make(&self) -> Result<Box<dyn Optimizer<F>>> {
        Ok(Box::new(Cal::new(self.clone())?))
    }
}

impl<F: Field> Cal<F> {
    /// The method with these parameters.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) naming the key that is out of range.
    pub fn new(params: Params) -> Result<Self> {
        check_ranges("", &params)?;
        Ok(Cal {
            params,
            saved: SavedNumbers::default(),
            fields: None,
        })
    }

    /// The start as published.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn begin(
        &mut self,
        problem: &mut Problem<F>,
        x: &mut F,
        at: &mut Position<F>,
    ) -> Result<[F; 3]> {
        let projection = target_projection(problem, self.params.filter, x)?;
        let mut fields = zeros(x);
        self.saved.inverse = projection.inverse();
        *x = projection.patterns;
        x.clamp(0.0, f32::INFINITY);
        x.scale(self.saved.inverse as f32);
        self.saved.largest = problem.evaluate_scaled(x, &mut fields[2], at)?;
        Ok(fields)
    }

    /// δ of the dose at hand, to within its factor; the cotangent is work space.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn error(
        &self,
        problem: &mut Problem<F>,
        x: &F,
        at: &mut Position<F>,
        delta: &mut F,
    ) -> Result<()> {
        let (d_h, width) = (self.params.d_h as f32, self.params.sigmoid as f32);
        at.cotangent.copy_from(&at.dose);
        at.cotangent.logistic_error(problem.target()?, d_h, width);
        problem.project(x, &at.cotangent, delta)
    }
}

impl<F: Field> Optimizer<F> for Cal<F> {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn step(&mut self, problem: &mut Problem<F>, x: &mut F, at: &mut Position<F>) -> Result<Step> {
        let mut fields = match self.fields.take() {
            Some(fields) => fields,
            None => self.begin(problem, x, at)?,
        };
        let [delta, before, scratch] = &mut fields;
        std::mem::swap(delta, before);
        self.error(problem, x, at, delta)?;
        let m = self.params.momentum;
        let past = m / (1.0 - m.powi(self.saved.cal + 2));
        let step = self.params.learning_rate * self.saved.inverse;
        x.scale(self.saved.largest as f32);
        x.axpy((-step * (1.0 - m)) as f32, delta);
        if m > 0.0 {
            x.axpy((-step * past) as f32, before);
        }
        x.clamp(0.0, f32::INFINITY);
        if let Some(levels) = problem.levels() {
            let open = x.compile_bounds(&Bounds::uniform(x.len(), 0.0, f32::INFINITY));
            x.quantize(levels, &open);
        }
        self.saved.largest = problem.evaluate_scaled(x, scratch, at)?;
        self.saved.cal += 1;
        let projected_gradient = delta.norm();
        self.fields = Some(fields);
        Ok(Step {
            projected_gradient,
            length: self.params.learning_rate,
        })
    }

    fn requirements(&self) -> Requirements {
        Requirements {
            linear: Some("the error of the object is projected to the patterns by the adjoint"),
            unpenalized: Some("its step is the object's error, where patterns have no price"),
            target: Some("it compares the dose with the target itself"),
            ..Requirements::of("cal")
        }
    }

    fn normalizes(&self) -> bool {
        true
    }

    fn memory(&self) -> Memory<'_> {
        let fields = self.fields.as_ref().map(|[delta, ..]| ("delta", delta));
        Memory::of(self.saved, fields.as_slice())
    }

    fn restore(&mut self, memory: &mut Checkpoint, _: &Problem<F>, x: &F) -> Result<()> {
        self.saved = read_saved_numbers(memory)?;
        if self.saved.cal > 0 {
            let mut fields = zeros(x);
            read_saved_fields(memory, &mut [("delta", &mut fields[0])])?;
            self.fields = Some(fields);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reference::{Case, assert_near, ramp};
    use std::f64::consts::PI;
    use tomolith_core::field::HostField;

    /// The iteration as the notes write it, with A = Fᵀ/φ and a dose that is a sum over angles.
    fn published(case: &Case, params: &Params, levels: Option<f64>) -> Vec<Vec<f64>> {
        let (target, marked) = (case.dense.target(), case.marked_target());
        let projection = case.dense.adjoint(&target);
        let frames = case.frames as f64;
        let share = projection.iter().sum::<f64>() / (frames * target.iter().sum::<f64>());
        let project =
            |v: &[f64]| -> Vec<f64> { case.dense.adjoint(v).iter().map(|g| g / share).collect() };
        let dose =
            |b: &[f64]| -> Vec<f64> { case.dense.forward(b).iter().map(|f| f / share).collect() };
        let top = |f: &[f64]| {
            f.iter()
                .zip(&marked)
                .filter(|(_, t)| **t >= 0.0)
                .fold(0.0, |m: f64, (f, _)| m.max(*f))
        };
        let mut b: Vec<f64> = ramp(&project(&target), case.n)
            .iter()
            .map(|v| v.max(0.0))
            .collect();
        let mut before = vec![0.0; b.len()];
        let mut history = Vec::new();
        for k in 1..=5 {
            let f = dose(&b);
            let largest = top(&f);
            let error: Vec<f64> = f
                .iter()
                .zip(&marked)
                .map(|(f, &t)| {
                    if t < 0.0 {
                        return 0.0;
                    }
                    let s = 1.0 / (1.0 + (-(f / largest - params.d_h) / params.sigmoid).exp());
                    s - t
                })
                .collect();
            let delta = project(&error);
            let m = params.momentum;
            for i in 0..b.len() {
                let g = delta[i] * (1.0 - m) + before[i] * m / (1.0 - m.powi(k + 1));
                b[i] = (b[i] - params.learning_rate * g).max(0.0);
            }
            before = delta;
            if let Some(n) = levels {
                let high = b.iter().copied().fold(0.0, f64::max);
                for v in &mut b {
                    *v = (*v / high * (n - 1.0) + 0.5).floor() / (n - 1.0) * high;
                }
            }
            // Our patterns: largest dose 1 in the units of F
            let largest = top(&case.dense.forward(&b));
            history.push(b.iter().map(|v| v / largest).collect());
        }
        assert!(PI * frames * share > 0.0);
        history
    }

    #[test]
    fn it_follows_the_published_iteration_step_by_step() {
        let case = Case::new();
        let objective = case.objective("l2", serde_json::json!({}));
        for (momentum, bits) in [(0.0, None), (0.4, None), (0.4, Some(7))] {
            let params = Params {
                learning_rate: 0.5,
                sigmoid: 0.1,
                d_h: 0.7,
                momentum,
                ..Params::default()
            };
            let expected = published(&case, &params, bits.map(|b: u32| f64::from(1 << b)));
            let mut cal = Cal::<HostField>::new(params).unwrap();
            let found = case.run(&*objective, &mut cal, 5, bits);
            for (k, expected) in expected.iter().enumerate() {
                let what = format!("momentum {momentum}, {bits:?} bits, step {}", k + 1);
                assert_near(&found.patterns[k + 1], expected, 5e-5, &what);
            }
            let change: f64 = expected[0]
                .iter()
                .zip(&expected[4])
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            assert!(
                change > 0.05,
                "patterns barely move, so the test shows nothing"
            );
        }
    }
}
