//! L-BFGS with bounds: a quasi-Newton step on the pixels that the bounds do not hold.
//!
//! **Step** from x with the gradient g
//!
//! ```text
//! held      pixels at a bound with g pointing out of it; the others are free
//! d       = −H·g on the free pixels, H the inverse curvature of the last m pairs (two-loop recursion), γ·P where no pair knows better
//! x̄       = clip(x + 1.5·d)                 brought into the bounds
//! x       ← x + α·(x̄ − x), α ∈ [0, 1]       the exact minimum on the feasible segment, one forward call
//! ```
//!
//! P in H is the half ramp ([`half_ramp`](tomolith_core::field::half_ramp)): patterns that are smooth along a row of pixels light what their
//! neighbors light, too, and change the dose more than fine ones. It saved a fifth to two fifths of the steps that H₀ = γ takes (`docs/choices.md`).
//!
//! When x̄ − x is no descent, or much less of one than the projected gradient step clip(x − γ·g) − x, that step is taken. A pair
//! (s, y) is the change of x and of the gradient in a step, y only where x moved, so that it knows the curvature of the face of
//! the box it was taken on; it is kept when s·y is positive enough (curvature check). Only z = P·y is remembered of y: the
//! recursion needs no more of it. The segment reaches half as far again
//! as d: the search decides how far to go, at no model call, and steps that stop short of d are then no more frequent than
//! those that go on.
//!
//! **Source** Nocedal, Math. Comp. 35 (1980) 773 (two-loop recursion); Bertsekas, SIAM J. Control Optim. 20 (1982) 221
//! (projected Newton on the free variables); Byrd, Lu, Nocedal and Zhu, SIAM J. Sci. Comput. 16 (1995) 1190 (the segment between x
//! and a point inside the bounds).
//!
//! **Parameters** see [`Params`]. **Limits** built for losses with a continuous gradient; with p = 1 it still never raises the
//! loss but may stop early. The loss never rises.
//!
//! **Cost** one forward and one adjoint call a step, one forward more at the first. Vector work is one pass over the pairs for
//! all products, one for their combination, one to move, and P twice (see [`Pairs`]). Memory: 4m + 20 bytes per pixel
//! in addition to x (pairs are stored in 16 bits) and two dose fields.

use super::{
    BuildOptimizer, Checkpoint, MakeOptimizer, Memory, Optimizer, Position, Problem, Requirements,
    SavedArray, Step, read, read_saved_fields, read_saved_numbers,
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use tomolith_core::dose::PatternLayout;
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::field::{
    ColumnRun, Direction, Field, HalfRamp, HalfRampKernel, Latest, Pairs, Products,
};
use tomolith_core::kind::{Kind, check_ranges, schema_of};

tomolith_core::keys! {
    /// The parameters of L-BFGS with bounds.
    pub struct Params {
        /// Number of pairs remembered
        #[schemars(range(min = 1, max = 30))]
        pub memory: usize = 6,
        /// Curvature check: a pair is kept when s·y > tolerance·‖s‖·‖y‖
        #[schemars(extend("minimum" = 0.0, "exclusiveMaximum" = 1.0))]
        pub tolerance: f64 = 1e-6,
    }
}

/// How much further than the quasi-Newton step the feasible segment reaches.
const STRETCH: f32 = 1.5;
/// A direction must promise at least this part of what the projected gradient step promises.
const DESCENT: f64 = 1e-3;

/// What it is called in a job.
pub const NAME: &str = "lbfgs";

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildOptimizer<F>> {
    Kind {
        name: NAME,
        summary: "L-BFGS with bounds: quasi-Newton steps on the free pixels, line search",
        example: "[optimizer.lbfgs]\nmemory = 6",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}

impl<F: Field> MakeOptimizer<F> for Params {
    fn make(&self) -> Result<Box<dyn Optimizer<F>>> {
        Ok(Box::new(Lbfgs::new(self.clone())?))
    }

    fn pairs(&self) -> Option<usize> {
        Some(self.memory)
    }

    fn with_pairs(&self, pairs: usize) -> Option<Arc<dyn MakeOptimizer<F>>> {
        Some(Arc::new(Params {
            memory: pairs,
            ..*self
        }))
    }
}

/// L-BFGS with bounds; see the [module](self).
pub struct Lbfgs<F: Field> {
    name: &'static str,
    params: Params,
    curvature: Curvature,
    fields: Option<Fields<F>>,
}

struct Fields<F: Field> {
    pairs: F::Pairs,
    ramp: F::HalfRamp,
    gradient: F,
    before: F,
    step: F,
    /// The change of the gradient, then the free gradient.
    part: F,
    /// P of that part.
    image: F,
}

impl<F: Field> Fields<F> {
    fn like(x: &F, memory: usize, problem: &Problem<F>) -> Self {
        Fields {
            pairs: F::Pairs::new(memory, problem.bounds(x)),
            ramp: F::HalfRamp::new(half_ramp(problem.model().patterns()), x),
            part: x.zeros_like(),
            image: x.zeros_like(),
            gradient: x.zeros_like(),
            before: x.zeros_like(),
            step: x.zeros_like(),
        }
    }
}

/// The rows of pixels of all lights.
fn half_ramp(lights: &[PatternLayout]) -> HalfRamp {
    let frames = lights.iter().flat_map(|light| {
        let frames = light.runs.chunks(light.grid.columns.max(1));
        frames.map(|runs| {
            let of_column = runs.iter().map(|run| ColumnRun {
                first: run.offset,
                bottom: run.bottom as usize,
                count: run.count as usize,
            });
            of_column.collect()
        })
    });
    HalfRamp {
        frames: frames.collect(),
    }
}

/// What is known of the curvature: products of pairs, from which the two-loop recursion needs no vector.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
struct Curvature {
    /// Slots in use, oldest first.
    order: Vec<usize>,
    /// `[i][j]` = s_i·y_j, for i not younger than j.
    s_y: Vec<Vec<f64>>,
    /// `[i][j]` = z_i·y_j
    z_y: Vec<Vec<f64>>,
    /// γ: inverse curvature, in units of P, where no pair knows better.
    scale: f64,
    /// The scale without P: the length of a projected gradient step.
    length: f64,
    /// α of the last step, None before the first.
    alpha: Option<f32>,
}

impl Curvature {
    fn new(memory: usize) -> Self {
        Curvature {
            s_y: vec![vec![0.0; memory]; memory],
            z_y: vec![vec![0.0; memory]; memory],
            ..Self::default()
        }
    }

    /// The slot for the next pair: a free one, or that of the oldest.
    fn next_slot(&mut self) -> usize {
        match (0..self.s_y.len()).find(|slot| !self.order.contains(slot)) {
            Some(slot) => slot,
            None => self.order.remove(0),
        }
    }

    /// Keeps the newest pair when its curvature is positive enough.
    fn take(&mut self, slot: usize, products: &Products, tolerance: f64) {
        let (s_y, y_y) = (products.s_y[slot], products.y_y);
        if s_y > 0.0 && s_y > tolerance * (products.s_s * y_y).sqrt() {
            self.order.push(slot);
            for &i in &self.order {
                self.s_y[i][slot] = products.s_y[i];
                self.z_y[i][slot] = products.z_y[i];
                self.z_y[slot][i] = products.z_y[i];
            }
            self.scale = s_y / products.z_y[slot];
            self.length = s_y / y_y;
        } else if self.alpha == Some(1.0) {
            // The loss fell to the end of the segment without curving
            self.scale *= 4.0;
            self.length *= 4.0;
        }
    }

    /// −H·g as a combination of P·g, the s and the z: Nocedal's two loops on products instead of vectors.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn direction(&self, products: Option<&Products>) -> Direction {
        let memory = self.s_y.len();
        let mut direction = Direction {
            scale: self.scale as f32,
            length: self.length as f32,
            along_s: vec![0.0; memory],
            along_z: vec![0.0; memory],
            stretch: STRETCH,
        };
        let Some(products) = products else {
            return direction;
        };
        let mut alpha = vec![0.0; memory];
        for (age, &j) in self.order.iter().enumerate().rev() {
            let younger = self.order[age + 1..].iter();
            let removed: f64 = younger.map(|&i| alpha[i] * self.s_y[j][i]).sum();
            alpha[j] = (products.s_g[j] - removed) / self.s_y[j][j];
        }
        let mut along_s = vec![0.0; memory];
        for (age, &j) in self.order.iter().enumerate() {
            let removed: f64 = self.order.iter().map(|&i| alpha[i] * self.z_y[j][i]).sum();
            let added: f64 = self.order[..age]
                .iter()
                .map(|&i| along_s[i] * self.s_y[i][j])
                .sum();
            let beta = (self.scale * (products.z_g[j] - removed) + added) / self.s_y[j][j];
            along_s[j] = alpha[j] - beta;
        }
        for &j in &self.order {
            direction.along_s[j] = -along_s[j] as f32;
            direction.along_z[j] = (self.scale * alpha[j]) as f32;
        }
        direction
    }
}

impl<F: Field> Lbfgs<F> {
    /// The method with these parameters.
    ///
    /// # Errors
    /// [`Error::Config`] naming the key that is out of range.
    pub fn new(params: Params) -> Result<Self> {
        check_ranges("", &params)?;
        let most = F::Pairs::MAX_MEMORY;
        let accepted = format!("1 to {most}");
        in_range(params.memory <= most, "memory", params.memory, accepted)?;
        Ok(Lbfgs {
            name: NAME,
            curvature: Curvature::new(params.memory),
            params,
            fields: None,
        })
    }

    /// The same solver as the row of another method, whose name messages then give.
    #[must_use]
    pub fn named(mut self, name: &'static str) -> Self {
        self.name = name;
        self
    }

    /// The direction of the next step, its slope, and the norm of the projected gradient.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn search_direction(
        &mut self,
        problem: &mut Problem<F>,
        x: &F,
        at: &mut Position<F>,
        fields: &mut Fields<F>,
    ) -> Result<Aim> {
        let Fields {
            pairs,
            ramp,
            gradient,
            before,
            step,
            part,
            image,
        } = fields;
        std::mem::swap(gradient, before);
        problem.gradient(x, at, gradient)?;
        let products = if let Some(alpha) = self.curvature.alpha {
            let slot = self.curvature.next_slot();
            part.change_where_moved(step, before, gradient);
            ramp.apply(part, image);
            let latest = Latest {
                x,
                step,
                alpha,
                gradient,
                change: part,
                image,
            };
            let products = pairs.record(slot, &latest, problem.bounds(x));
            self.curvature.take(slot, &products, self.params.tolerance);
            Some(products)
        } else {
            self.curvature.length = problem.first_length(x, gradient, step, at)?;
            self.curvature.scale = self.curvature.length;
            None
        };
        let direction = self.curvature.direction(products.as_ref());
        part.free_gradient(x, gradient, problem.bounds(x));
        ramp.apply(part, image);
        let sums = pairs.direction(&direction, x, gradient, image, problem.bounds(x), step);
        let length = self.curvature.length;
        let mut slope = sums.slope;
        if slope > DESCENT * sums.gradient_slope || slope.is_nan() {
            slope = step
                .project_step(x, gradient, length as f32, problem.bounds(x))
                .slope;
        }
        let projected_gradient = if length == 0.0 {
            0.0
        } else {
            sums.gradient_square.sqrt() / length
        };
        Ok(Aim {
            slope,
            projected_gradient,
        })
    }
}

struct Aim {
    slope: f64,
    projected_gradient: f64,
}

impl<F: Field> Optimizer<F> for Lbfgs<F> {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn step(&mut self, problem: &mut Problem<F>, x: &mut F, at: &mut Position<F>) -> Result<Step> {
        let mut fields = self
            .fields
            .take()
            .unwrap_or_else(|| Fields::like(x, self.params.memory, problem));
        let Aim {
            slope,
            projected_gradient,
        } = self.search_direction(problem, x, at, &mut fields)?;
        let mut alpha = 0.0;
        if slope != 0.0 {
            alpha = problem.search(x, &fields.step, slope, at)?.alpha;
            if alpha == 0.0 && !self.curvature.order.is_empty() {
                // What the pairs remember misleads
                self.curvature.order.clear();
                let length = self.curvature.length as f32;
                let sums = fields
                    .step
                    .project_step(x, &fields.gradient, length, problem.bounds(x));
                alpha = problem.search(x, &fields.step, sums.slope, at)?.alpha;
            }
        }
        self.curvature.alpha = Some(alpha);
        self.fields = Some(fields);
        Ok(Step {
            projected_gradient,
            length: f64::from(alpha),
        })
    }

    fn is_monotone(&self) -> bool {
        true
    }

    fn forget(&mut self) {
        self.curvature = Curvature::new(self.params.memory);
    }

    fn requirements(&self) -> Requirements {
        Requirements {
            continuous: Some(
                "it measures curvature along its steps and searches along a line, and rounding changes both",
            ),
            ..Requirements::of(self.name)
        }
    }

    fn memory(&self) -> Memory<'_> {
        let fields = (self.fields.as_ref()).map(|f| [("gradient", &f.gradient), ("step", &f.step)]);
        let mut memory = Memory::of(&self.curvature, fields.as_slice().as_flattened());
        let parts = self.fields.iter().flat_map(|fields| fields.pairs.parts());
        let parts = parts.map(|part| (part.name.to_owned(), SavedArray::of_part(part)));
        memory.arrays.extend(parts);
        memory
    }

    fn restore(&mut self, memory: &mut Checkpoint, problem: &Problem<F>, x: &F) -> Result<()> {
        let curvature: Curvature = read_saved_numbers(memory)?;
        if curvature.s_y.len() != self.params.memory {
            return Err(Error::unsupported(
                "the checkpoint",
                format!("its optimizer remembered {} pairs", curvature.s_y.len()),
            ));
        }
        if curvature.alpha.is_some() {
            let mut fields = Fields::like(x, self.params.memory, problem);
            let saved = &mut [
                ("gradient", &mut fields.gradient),
                ("step", &mut fields.step),
            ];
            read_saved_fields(memory, saved)?;
            fields
                .pairs
                .restore(&mut |name, bytes| memory.array(name, bytes))?;
            self.fields = Some(fields);
        }
        self.curvature = curvature;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gradient::{self, Gradient};
    use crate::reference::{self, Dense};
    use crate::{Limits, Outcome, Stop};
    use serde_json::{Value, json};
    use std::sync::Arc;
    use tomolith_core::check::{self, small::SmallModel};
    use tomolith_core::field::HostField;
    use tomolith_core::near;
    use tomolith_core::response::{Identity, Logistic};
    use tomolith_objective::Objective;
    use tomolith_objective::check::of_ring;

    fn objective(model: &SmallModel, name: &str, json: Value) -> Box<dyn Objective<HostField>> {
        of_ring(model, name, json, Arc::new(Identity))
    }

    fn solve(
        model: &SmallModel,
        objective: &dyn Objective<HostField>,
        optimizer: &mut dyn Optimizer<HostField>,
        stop: &Stop,
    ) -> (HostField, Outcome) {
        let limits = Limits::default();
        let (x, outcome) = reference::solve(model, objective, limits, 0.5, optimizer, stop);
        (x, outcome.unwrap())
    }

    fn never_rises(outcome: &Outcome) -> bool {
        outcome.history.windows(2).all(|w| w[1].loss <= w[0].loss)
    }

    /// The optimum of Σ w(Ax − b)², x ≥ 0, by projected gradient steps in f64 on the written-down matrix: least loss, dose, share
    /// of dark pixels, and the projected gradient's norm relative to that at the start.
    fn plain_optimum(matrix: &Dense, wanted: &[f64], weight: &[f64]) -> (f64, Vec<f64>, f64, f64) {
        let forward = |x: &[f64]| matrix.forward(x);
        let gradient = |dose: &[f64]| -> Vec<f64> {
            let rest = (0..dose.len()).map(|i| 2.0 * weight[i] * (dose[i] - wanted[i]));
            matrix.adjoint(&rest.collect::<Vec<_>>())
        };
        let pixels = gradient(wanted).len();
        // Largest row sum times largest column sum bounds the square of a matrix's norm
        let largest = |sums: Vec<f64>| sums.into_iter().fold(0.0, f64::max);
        let rows = largest(forward(&vec![1.0; pixels]));
        let t = 1.0 / (2.0 * rows * largest(matrix.adjoint(weight)));
        let norm = |x: &[f64], g: &[f64]| {
            let square: f64 = x
                .iter()
                .zip(g)
                .map(|(x, g)| ((x - t * g).max(0.0) - x).powi(2))
                .sum();
            square.sqrt() / t
        };
        let mut x = vec![0.5; pixels];
        let first = norm(&x, &gradient(&forward(&x)));
        for _ in 0..12_000 {
            let g = gradient(&forward(&x));
            x.iter_mut()
                .zip(&g)
                .for_each(|(x, g)| *x = (*x - t * g).max(0.0));
        }
        let dose = forward(&x);
        let last = norm(&x, &gradient(&dose));
        let loss = (0..dose.len())
            .map(|i| weight[i] * (dose[i] - wanted[i]).powi(2))
            .sum();
        let dark = x.iter().filter(|&&v| v == 0.0).count() as f64 / pixels as f64;
        (loss, dose, dark, last / first)
    }

    #[test]
    fn agrees_with_a_plain_optimum_at_which_most_pixels_are_dark() {
        let model = SmallModel::new(16, 48, 1);
        let objective = objective(&model, "l2", json!({"void_weight": 5.0}));
        let (target, labels) = model.ring();
        let wanted: Vec<f64> = target.inside.values.iter().map(|&v| f64::from(v)).collect();
        let weight: Vec<f64> = labels
            .values
            .iter()
            .map(|&l| [0.0, 5.0, 1.0][usize::from(l)])
            .collect();
        let matrix = Dense::new(&model);
        let (loss, dose, dark, optimality) = plain_optimum(&matrix, &wanted, &weight);
        assert!(dark > 0.8, "only {dark} of the pixels are at the bound");
        assert!(optimality < 1e-6, "the plain optimum is none: {optimality}");

        let stop = Stop {
            iterations: 300,
            projected_gradient: 1e-6,
            ..Stop::default()
        };
        let mut optimizer = Lbfgs::new(Params::default()).unwrap();
        let (x, outcome) = solve(&model, &*objective, &mut optimizer, &stop);
        near!(outcome.loss, loss, 1e-5 * loss, "the least loss");
        let found = check::dose(&model, &x);
        let found = model.layout().volume_of(found.as_slice());
        for (i, (found, expected)) in found.values.iter().zip(&dose).enumerate() {
            near!(f64::from(*found), expected, 2e-3, "voxel {i}: dose {found}");
        }
        let dark =
            x.as_slice().iter().filter(|&&v| v == 0.0).count() as f64 / x.as_slice().len() as f64;
        assert!(dark > 0.8, "only {dark} of the pixels are at the bound");
    }

    #[test]
    fn needs_fewer_steps_than_the_gradient_and_never_rises() {
        let model = SmallModel::new(40, 60, 2);
        for (name, json) in [
            ("threshold", json!({})),
            ("ospw", json!({})),
            ("l2", json!({})),
            ("bclp", json!({})),
            ("l1", json!({})),
        ] {
            let objective = objective(&model, name, json);
            let stop = Stop::after(40);
            let mut lbfgs = Lbfgs::new(Params::default()).unwrap();
            let (_, newton) = solve(&model, &*objective, &mut lbfgs, &stop);
            let mut gradient = Gradient::new(gradient::Params::default()).unwrap();
            let (_, plain) = solve(&model, &*objective, &mut gradient, &stop);
            assert!(never_rises(&newton) && never_rises(&plain), "{name}");
            assert!(
                newton.loss <= plain.loss,
                "{name}: {} against {}",
                newton.loss,
                plain.loss
            );
            if name == "threshold" {
                assert_eq!(newton.loss, 0.0);
            }
        }
    }

    #[test]
    fn the_loss_never_rises_through_a_sigmoid_or_with_singular_powers() {
        let model = SmallModel::new(24, 36, 2);
        for (name, json) in [
            ("dose_matching", json!({})),
            ("bclp", json!({})),
            ("bclp", json!({"p": 0.5, "q": 0.5})),
            ("bclp", json!({"p": 4.0, "q": 0.5})),
        ] {
            let response = Arc::new(Logistic::new(Default::default()).unwrap());
            let objective = of_ring(&model, name, json.clone(), response);
            let mut optimizer = Lbfgs::new(Params::default()).unwrap();
            let stop = Stop::after(40);
            let (_, outcome) = solve(&model, &*objective, &mut optimizer, &stop);
            let first = outcome.history[0].loss;
            assert!(never_rises(&outcome), "{name} {json}: {outcome:?}");
            assert!(outcome.loss < 0.7 * first, "{name} {json}: {first}");
        }
    }

    #[test]
    fn a_method_that_remembers_pairs_may_be_told_to_remember_fewer() {
        for row in crate::OPTIMIZERS {
            let method = (row.build)(&tomolith_core::check::example(row)).unwrap();
            let fewer = method.with_pairs(3).and_then(|method| method.pairs());
            let remembers = ["lbfgs", "pm"].contains(&row.name);
            assert_eq!(method.pairs().is_some(), remembers, "{}", row.name);
            assert_eq!(fewer, remembers.then_some(3), "{}", row.name);
        }
    }
}
