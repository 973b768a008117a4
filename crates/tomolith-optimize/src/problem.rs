//! The problem an optimizer solves, and the one line search.
//!
//! ```text
//! min over x   L( F(x) ) + Σ λᵢ·Rᵢ(x)   subject to   min ≤ x ≤ max          (L contains the response)
//! ```
//!
//! A search walks the *feasible segment* x + α·(x̄ − x), α ∈ [0, 1], whose end x̄ lies within the bounds; no point of it needs
//! clamping, so for a linear model the dose along it is F(x) + α·F(x̄ − x): one forward call serves the whole search, which
//! then costs passes over the dose only; for waves it is a quadratic in α, whose three coefficients serve it. (Searching first and clamping afterwards promises losses that are not delivered.)

mod needed;

use super::free_response::FreeResponse;
use std::borrow::Cow;
use std::sync::OnceLock;
use std::time::Instant;
use tomolith_core::dose::{DoseModel, PatternLayout, Quantity, Work};
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::field::{Bounds, Field};
use tomolith_objective::Objective;
use tomolith_objective::penalty::Penalties;

/// Smallest and largest value of a light's pixels, mJ/mm² (energy, also for models whose unknown is the amplitude).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Smallest energy, 0 or above.
    pub min: f64,
    /// Largest energy, +∞ for none.
    pub max: f64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            min: 0.0,
            max: f64::INFINITY,
        }
    }
}

/// What was done so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Counters {
    /// Dose calls.
    pub forward: u64,
    /// Pullback calls.
    pub adjoint: u64,
    /// Seconds in the model.
    pub model_s: f64,
    /// Seconds in passes over the dose: loss, gradient, line search.
    pub objective_s: f64,
}

/// Model, objective and bounds; see the [module](self).
pub struct Problem<'a, F: Field> {
    model: &'a dyn DoseModel<Field = F>,
    objective: Held<'a, F>,
    penalties: Penalties<F>,
    bounds: Bounds,
    /// The bounds where patterns live, from the first patterns on.
    compiled: OnceLock<F::Bounds>,
    /// Levels of a pixel, when patterns are rounded in every step.
    levels: Option<u32>,
    /// Target per element of the dose field, below 0 where a voxel does not count.
    target: Option<F>,
    /// 1 at the part's surface, else 0.
    edges: Option<F>,
    /// From what dose on the loss may feel each region of the model's voxels, from the first search on; None where it feels all.
    limits: OnceLock<Option<Vec<f32>>>,
    work: &'a Work,
    /// What was done so far.
    pub counters: Counters,
}

enum Held<'a, F> {
    Fixed(&'a dyn Objective<F>),
    /// Its response has unknown parameters.
    Free(FreeResponse<'a, F>),
}

impl<F: Field> Held<'_, F> {
    fn get(&self) -> &dyn Objective<F> {
        match self {
            Held::Fixed(objective) => *objective,
            Held::Free(free) => free.objective(),
        }
    }

    /// The objective, where none of its parameters are unknowns.
    fn fixed(&self) -> Option<&dyn Objective<F>> {
        match self {
            Held::Fixed(objective) => Some(*objective),
            Held::Free(_) => None,
        }
    }
}

/// Where the patterns are: their dose, and what an optimizer needs of it.
pub struct Position<F> {
    /// F(x); an earlier dose where a search has left voxels out ([`SeenDose`](super::SeenDose)).
    pub dose: F,
    /// ∂L/∂dose at x; a search uses it as its work space.
    pub cotangent: F,
    /// L at x, penalties included.
    pub loss: f64,
    /// Regions of the model whose dose is an earlier one; empty for none.
    unknown: Vec<bool>,
}

impl<F> Position<F> {
    /// Before anything is known.
    pub(super) fn new(dose: F, cotangent: F) -> Self {
        Position {
            dose,
            cotangent,
            loss: f64::NAN,
            unknown: Vec::new(),
        }
    }

    /// Regions of the model whose dose is an earlier one; empty for none.
    pub(super) fn unknown(&self) -> &[bool] {
        &self.unknown
    }

    /// The position with these regions marked as unknown.
    pub(super) fn with_unknown(self, unknown: Vec<bool>) -> Self {
        Position { unknown, ..self }
    }
}

/// What a search found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineSearchResult {
    /// Position on the segment, 0 when nothing better was found.
    pub alpha: f32,
    /// Slope at the end of the search relative to that at its beginning; 1 when α = 0.
    pub slope: f64,
}

impl<'a, F: Field> Problem<'a, F> {
    /// A problem; `limits` has one entry per light of the model.
    ///
    /// # Errors
    /// [`Error::Config`] for limits that are no range, [`Error::Shape`] for another number of them.
    pub fn new(
        model: &'a dyn DoseModel<Field = F>,
        objective: &'a dyn Objective<F>,
        limits: &[Limits],
        work: &'a Work,
    ) -> Result<Self> {
        Self::of(model, Held::Fixed(objective), limits, work)
    }

    /// A problem in which parameters of the response are unknowns, too.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_free_response(
        model: &'a dyn DoseModel<Field = F>,
        objective: FreeResponse<'a, F>,
        limits: &[Limits],
        work: &'a Work,
    ) -> Result<Self> {
        Self::of(model, Held::Free(objective), limits, work)
    }

    fn of(
        model: &'a dyn DoseModel<Field = F>,
        objective: Held<'a, F>,
        limits: &[Limits],
        work: &'a Work,
    ) -> Result<Self> {
        let bounds = bounds(model.patterns(), limits)?;
        Ok(Problem {
            model,
            objective,
            penalties: Penalties::default(),
            bounds,
            compiled: OnceLock::new(),
            levels: None,
            target: None,
            edges: None,
            limits: OnceLock::new(),
            work,
            counters: Counters::default(),
        })
    }

    /// The same problem with penalties on the patterns.
    #[must_use]
    pub fn with_penalties(mut self, penalties: Penalties<F>) -> Self {
        self.penalties = penalties;
        self
    }

    /// The penalties on the patterns.
    #[must_use]
    pub fn penalties(&self) -> &Penalties<F> {
        &self.penalties
    }

    /// The same problem with patterns of so many bits: every step ends on one of 2^bits levels, even between the bounds
    /// (without an upper one, up to the largest pixel). None: no rounding.
    ///
    /// # Errors
    /// [`Error::Config`] for other than 1 to 16 bits.
    pub fn with_bits(mut self, bits: Option<u32>) -> Result<Self> {
        if let Some(bits) = bits {
            let accepted = "1 to 16 bits, or leave the key out for patterns that are not rounded";
            in_range((1..=16).contains(&bits), "bounds.bits", bits, accepted)?;
        }
        self.levels = bits.map(|bits| 1 << bits);
        Ok(self)
    }

    /// The same problem with its target as a dose field, for methods that [need](super::Requirements::target) one: 1 in the part and 0
    /// in the void, or gray values; below 0 where a voxel does not count.
    #[must_use]
    pub fn with_target(mut self, target: F) -> Self {
        self.target = Some(target);
        self
    }

    /// The same problem with marks per element of the dose field, for methods that [need](super::Requirements::edges) them: 1 where a voxel
    /// has a neighbor of the other kind, part or void, by a face, else 0.
    #[must_use]
    pub fn with_edges(mut self, edges: F) -> Self {
        self.edges = Some(edges);
        self
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> &'a dyn DoseModel<Field = F> {
        self.model
    }

    /// The objective.
    #[must_use]
    pub fn objective(&self) -> &dyn Objective<F> {
        self.objective.get()
    }

    /// The parameters of the response at hand, where these are unknowns.
    pub(super) fn response_values(&self) -> &[f64] {
        match &self.objective {
            Held::Fixed(_) => &[],
            Held::Free(free) => free.values(),
        }
    }

    /// Takes other parameters of the response, where there are any.
    pub(super) fn set_response_values(&mut self, values: &[f64]) -> Result<()> {
        match &mut self.objective {
            Held::Free(free) if values.len() == free.values().len() => free.set(values),
            _ => Ok(()),
        }
    }

    /// Whether the parameters of the response moved by no more than their tolerance from these.
    pub(super) fn is_response_settled(&self, before: &[f64]) -> bool {
        match &self.objective {
            Held::Fixed(_) => true,
            Held::Free(free) => free.is_settled(before),
        }
    }

    /// Minimizes the loss at a position over the parameters of the response, where these are unknowns; no model call. `before`: those that the
    /// last time began with.
    pub(super) fn fit_response(
        &mut self,
        x: &F,
        at: &mut Position<F>,
        before: &[f64],
    ) -> Result<()> {
        let Held::Free(free) = &mut self.objective else {
            return Ok(());
        };
        let begin = Instant::now();
        let was = free.values().to_vec();
        free.fit(&at.dose, before)?;
        let has_moved = free.values() != was;
        self.counters.objective_s += begin.elapsed().as_secs_f64();
        if has_moved {
            self.weigh(x, at);
        }
        Ok(())
    }

    /// The bounds of every pixel, where `x` lives.
    #[must_use]
    pub fn bounds(&self, x: &F) -> &F::Bounds {
        self.compiled.get_or_init(|| x.compile_bounds(&self.bounds))
    }

    /// The levels that pixels are rounded to in every step, or None.
    #[must_use]
    pub fn levels(&self) -> Option<u32> {
        self.levels
    }

    /// The target, as given to [`with_target`](Self::with_target).
    ///
    /// # Errors
    /// [`Error::Unsupported`] when there is none.
    pub fn target(&self) -> Result<&F> {
        self.target.as_ref().ok_or_else(|| {
            Error::unsupported(
                "a method that looks at the target",
                "the problem was built without one",
            )
        })
    }

    /// The marks given to [`with_edges`](Self::with_edges).
    ///
    /// # Errors
    /// [`Error::Unsupported`] when there are none.
    pub fn edges(&self) -> Result<&F> {
        self.edges.as_ref().ok_or_else(|| {
            Error::unsupported(
                "a method that looks at the part's surface",
                "the problem was built without its marks",
            )
        })
    }

    /// What stops the work.
    #[must_use]
    pub fn work(&self) -> &'a Work {
        self.work
    }

    /// F(x), counted.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn dose(&mut self, x: &F, dose: &mut F) -> Result<()> {
        let begin = Instant::now();
        let done = self.model.dose(x, dose, self.work);
        self.counters.model_s += begin.elapsed().as_secs_f64();
        self.counters.forward += 1;
        done
    }

    /// Lets the model [become another map](tomolith_core::dose::Renewal) before the step of an iteration, and says whether it did.
    ///
    /// # Errors
    /// [`Error::Canceled`], and what refuses a simulation.
    pub fn renew(&mut self, iteration: usize, x: &F) -> Result<bool> {
        let begin = Instant::now();
        let renewal = self.model.renewal();
        let done = renewal.map_or(Ok(false), |model| model.renew(iteration, x, self.work));
        self.counters.model_s += begin.elapsed().as_secs_f64();
        done
    }

    /// ∂L/∂x at a position, penalties included; counted.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn gradient(&mut self, x: &F, at: &Position<F>, gradient: &mut F) -> Result<()> {
        self.project(x, &at.cotangent, gradient)?;
        self.penalties.add_gradient(x, 1.0, gradient);
        Ok(())
    }

    /// Whether the problem is known to be convex, with a largest value for every pixel.
    #[must_use]
    pub fn has_lower_bound(&self) -> bool {
        self.model.is_linear()
            && self.model.renewal().is_none()
            && self.objective().is_convex()
            && self.penalties.is_convex()
            && self.bounds.pieces().all(|(_, _, upper)| upper.is_finite())
    }

    /// A loss that no patterns within the bounds go below, from the gradient at a position; see [`Gap`](super::Gap). None where the problem
    /// is not known to be convex, or a pixel has no largest value. One adjoint call, counted.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn lower_bound(&mut self, x: &F, at: &Position<F>) -> Result<Option<f64>> {
        if !self.has_lower_bound() {
            return Ok(None);
        }
        if at.loss == 0.0 {
            return Ok(Some(0.0));
        }
        let (mut gradient, mut step) = (x.zeros_like(), x.zeros_like());
        self.gradient(x, at, &mut gradient)?;
        // A step as long as can be ends at the corner of the bounds that lies furthest downhill
        let sums = step.project_step(x, &gradient, f32::MAX, self.bounds(x));
        Ok(Some(at.loss + sums.slope))
    }

    /// F′(x)ᵀ d: a dose field as the pixels see it, counted; with a linear model x may be any patterns.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn project(&mut self, x: &F, dose: &F, patterns: &mut F) -> Result<()> {
        let begin = Instant::now();
        let done = self.model.pullback(x, dose, patterns, self.work);
        self.counters.model_s += begin.elapsed().as_secs_f64();
        self.counters.adjoint += 1;
        done
    }

    /// L at any dose, and ∂L/∂dose written over `cotangent`; no model call.
    pub fn objective_at(&mut self, dose: &F, cotangent: &mut F) -> f64 {
        self.timed(|objective, _| objective.value_and_gradient(dose, cotangent))
    }

    /// Brings x into the bounds and, with a bit depth, to its levels; evaluates it.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn evaluate(&mut self, x: &mut F, at: &mut Position<F>) -> Result<()> {
        self.project_onto_bounds(x);
        self.measure(x, at)
    }

    /// Dose, loss and cotangent of patterns that need no bringing into the bounds.
    pub(super) fn measure(&mut self, x: &F, at: &mut Position<F>) -> Result<()> {
        self.dose(x, &mut at.dose)?;
        at.unknown.clear();
        self.weigh(x, at);
        Ok(())
    }

    /// Loss and cotangent of patterns whose dose is there.
    fn weigh(&mut self, x: &F, at: &mut Position<F>) {
        let Position {
            dose,
            cotangent,
            loss,
            ..
        } = at;
        *loss = self.timed(|objective, penalties| {
            objective.value_and_gradient(dose, cotangent) + penalties.value(x)
        });
    }

    /// Evaluates patterns of any scale after scaling them so that the largest dose of the voxels that count is 1; returns the
    /// largest dose before. Patterns that the bounds cut then cost a second forward call, and the largest dose is another.
    /// `scratch` is overwritten.
    ///
    /// # Errors
    /// [`Error::Unsupported`] when the dose is zero everywhere, or there is no target; [`Error::Canceled`].
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    pub fn evaluate_scaled(
        &mut self,
        x: &mut F,
        scratch: &mut F,
        at: &mut Position<F>,
    ) -> Result<f64> {
        self.dose(x, &mut at.dose)?;
        let largest = f64::from(at.dose.max_marked(self.target()?));
        if largest == 0.0 {
            return Err(Error::unsupported(
                "normalizing by the largest dose",
                "the dose became zero everywhere; use thresholds closer to 1, fewer steps, or another method",
            ));
        }
        let scale = (1.0 / largest) as f32;
        x.scale(scale);
        at.dose.scale(scale);
        let cut = scratch.project_step(x, x, 0.0, self.bounds(x)).square > 0.0;
        if cut {
            x.move_along(scratch, 1.0, self.bounds(x));
            self.dose(x, &mut at.dose)?;
        }
        self.weigh(x, at);
        Ok(largest)
    }

    /// Into the bounds, and to the levels.
    fn project_onto_bounds(&self, x: &mut F) {
        let zero = x.zeros_like();
        x.move_along(&zero, 0.0, self.bounds(x));
        self.round(x);
    }

    /// To the levels, when there are any.
    fn round(&self, x: &mut F) {
        if let Some(levels) = self.levels {
            x.quantize(levels, self.bounds(x));
        }
    }

    /// Brings x into the bounds and, with a bit depth, to its levels; evaluates it.
    ///
    /// # Errors
    /// [`Error::Canceled`], or not enough memory.
    pub fn evaluate_at(&mut self, x: &mut F) -> Result<Position<F>> {
        let mut at = Position::new(self.model.new_dose()?, self.model.new_dose()?);
        self.evaluate(x, &mut at)?;
        Ok(at)
    }

    /// The position of patterns whose dose is known.
    ///
    /// # Errors
    /// When there is not enough memory.
    pub fn place_at(&mut self, x: &F, dose: F) -> Result<Position<F>> {
        let mut at = Position::new(dose, self.model.new_dose()?);
        self.weigh(x, &mut at);
        Ok(at)
    }

    /// Takes a full step, `step` = x̄ − x, whatever the loss does; one forward call.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn full_step(&mut self, x: &mut F, step: &F, at: &mut Position<F>) -> Result<()> {
        x.move_along(step, 1.0, self.bounds(x));
        self.round(x);
        self.measure(x, at)
    }

    /// Goes to the best place found on the feasible segment of `step` = x̄ − x; `slope` is the gradient times the step and
    /// must be negative. Never raises the loss.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn search(
        &mut self,
        x: &mut F,
        step: &F,
        slope: f64,
        at: &mut Position<F>,
    ) -> Result<LineSearchResult> {
        let course = match self.needed_dose(x, step, at)? {
            true => Some(Course::Line),
            false => self.course(x, step, at)?,
        };
        let Some(mut course) = course else {
            return self.backtrack(x, step, slope, at);
        };
        let Position {
            dose,
            cotangent,
            loss,
            ..
        } = at;
        let found = self.timed(|objective, penalties| {
            let found = segment_minimum(*loss, slope, |alpha| {
                sum(
                    course.slope(objective, dose, cotangent, alpha),
                    penalties.slope_along(x, step, alpha),
                )
            });
            *loss = course.advance(objective, dose, cotangent, found.alpha);
            found
        });
        if found.alpha != 0.0 {
            x.move_along(step, found.alpha, self.bounds(x));
        }
        at.loss += self.timed(|_, penalties| penalties.value(x));
        Ok(found)
    }

    /// The dose along d from a position, None where it is no polynomial; counted as a forward call for each coefficient.
    fn course(&mut self, x: &F, d: &F, at: &mut Position<F>) -> Result<Option<Course<F>>> {
        if self.model.is_linear() {
            self.dose(d, &mut at.cotangent)?;
            return Ok(Some(Course::Line));
        }
        let begin = Instant::now();
        let terms = self.model.along(x, d, self.work);
        self.counters.model_s += begin.elapsed().as_secs_f64();
        let Some(terms) = terms? else { return Ok(None) };
        self.counters.forward += terms.len() as u64;
        let place = at.dose.clone();
        Ok(Some(Course::Curve { terms, place }))
    }

    /// The search for models whose dose is no polynomial of the step: shrinks the step until the loss falls enough (Armijo), one
    /// forward call a trial.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn backtrack(
        &mut self,
        x: &mut F,
        step: &F,
        slope: f64,
        at: &mut Position<F>,
    ) -> Result<LineSearchResult> {
        let before = at.loss;
        let mut alpha = 1.0f64;
        let mut found = LineSearchResult {
            alpha: 0.0,
            slope: 1.0,
        };
        for _ in 0..20 {
            let mut trial = x.clone();
            trial.move_along(step, alpha as f32, self.bounds(x));
            let Position { cotangent, .. } = &mut *at;
            self.dose(&trial, cotangent)?;
            let loss = self
                .timed(|objective, penalties| objective.value(cotangent) + penalties.value(&trial));
            if loss <= before + 1e-4 * alpha * slope {
                found = LineSearchResult {
                    alpha: alpha as f32,
                    slope: 0.0,
                };
                *x = trial;
                at.dose.copy_from(&at.cotangent);
                break;
            }
            // Minimum of the parabola through both losses and the slope, kept inside the segment
            let curvature = loss - before - alpha * slope;
            let parabola = -0.5 * slope * alpha * alpha / curvature;
            let inside = parabola.is_finite() && curvature > 0.0;
            alpha = if inside {
                parabola.clamp(0.1 * alpha, 0.5 * alpha)
            } else {
                0.1 * alpha
            };
        }
        self.weigh(x, at);
        Ok(found)
    }

    /// A length t for a first projected gradient step x − t·g: where the loss stops falling along −g, bounds apart. Costs one
    /// forward call. `direction` is overwritten with the negative gradient, without pixels that the bounds hold.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn first_length(
        &mut self,
        x: &F,
        gradient: &F,
        direction: &mut F,
        at: &mut Position<F>,
    ) -> Result<f64> {
        // A tiny step tells which pixels the bounds hold
        let size = f64::from(x.max_abs()).max(f64::from(f32::MIN_POSITIVE));
        let largest = f64::from(gradient.max_abs());
        if largest == 0.0 || !largest.is_finite() {
            return Ok(if largest == 0.0 { 0.0 } else { f64::NAN });
        }
        let unit = if x.max_abs() > 0.0 {
            1e-3 * size / largest
        } else {
            1.0 / largest
        };
        let sums = direction.project_step(x, gradient, unit as f32, self.bounds(x));
        if sums.slope >= 0.0 {
            return Ok(unit);
        }
        if let Cow::Owned(whole) = self.whole_dose(x, at)? {
            at.dose = whole;
            at.unknown.clear();
        }
        let mut course = match self.course(x, direction, at)? {
            Some(course) => course,
            None => {
                // The secant of a step that is tiny
                let mut moved = x.clone();
                moved.move_along(direction, 1.0, self.bounds(x));
                self.dose(&moved, &mut at.cotangent)?;
                at.cotangent.axpy(-1.0, &at.dose);
                Course::Line
            }
        };
        let Position {
            dose,
            cotangent,
            loss,
            ..
        } = at;
        let length = self.timed(|objective, penalties| {
            ray_minimum(*loss, sums.slope, |alpha| {
                sum(
                    course.slope(objective, dose, cotangent, alpha),
                    penalties.slope_along(x, direction, alpha),
                )
            })
        });
        self.weigh(x, at);
        Ok(unit * length)
    }

    fn timed<T>(&mut self, work: impl FnOnce(&dyn Objective<F>, &Penalties<F>) -> T) -> T {
        let begin = Instant::now();
        let result = work(self.objective.get(), &self.penalties);
        self.counters.objective_s += begin.elapsed().as_secs_f64();
        result
    }
}

/// The dose along a step from a position, where no place on it needs a forward call.
enum Course<F> {
    /// dose + α·step, the step's dose in the place of the cotangent.
    Line,
    /// Terms of α, α², …; the cotangent and `place` are work space.
    Curve { terms: Vec<F>, place: F },
}

impl<F: Field> Course<F> {
    /// L and dL/dα at α.
    fn slope(
        &mut self,
        objective: &dyn Objective<F>,
        dose: &F,
        cotangent: &mut F,
        alpha: f32,
    ) -> (f64, f64) {
        match self {
            Course::Line => objective.slope_along(dose, cotangent, alpha),
            Course::Curve { terms, place } => {
                place.clone_from(dose);
                advance_on(terms, alpha, place, cotangent);
                objective.slope_along(place, cotangent, 0.0)
            }
        }
    }

    /// Goes to α, leaves the cotangent there, and returns L.
    fn advance(
        &self,
        objective: &dyn Objective<F>,
        dose: &mut F,
        cotangent: &mut F,
        alpha: f32,
    ) -> f64 {
        match self {
            Course::Line if alpha != 0.0 => return objective.advance(dose, cotangent, alpha),
            Course::Curve { terms, .. } if alpha != 0.0 => {
                advance_on(terms, alpha, dose, cotangent);
            }
            _ => {}
        }
        objective.value_and_gradient(dose, cotangent)
    }
}

/// Adds what a polynomial gains up to α; its derivative there.
fn advance_on<F: Field>(curve: &[F], alpha: f32, place: &mut F, slope: &mut F) {
    slope.fill(0.0);
    for (power, term) in (1..).zip(curve) {
        place.axpy(alpha.powi(power), term);
        slope.axpy(power as f32 * alpha.powi(power - 1), term);
    }
}

/// Value and slope of L and R together.
fn sum(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0 + b.0, a.1 + b.1)
}

/// The bounds of every pixel of these lights.
///
/// # Errors
/// [`Error::Config`] for limits that are no range, [`Error::Shape`] for another number of them than lights.
#[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
pub fn bounds(lights: &[PatternLayout], limits: &[Limits]) -> Result<Bounds> {
    if limits.len() != lights.len() {
        return Err(Error::shape(
            "limits, one per light",
            vec![lights.len()],
            vec![limits.len()],
        ));
    }
    let pieces = lights.iter().zip(limits).map(|(light, limits)| {
        // Also refuses NaN
        if !(limits.min >= 0.0 && limits.min < limits.max) {
            return Err(Error::config(
                "bounds.min",
                format!("min {} and max {}", limits.min, limits.max),
                "0 ≤ min < max",
            ));
        }
        let value = |energy: f64| match light.quantity {
            Quantity::Energy => energy,
            Quantity::Amplitude => energy.sqrt(),
        };
        Ok((
            light.len(),
            value(limits.min) as f32,
            value(limits.max) as f32,
        ))
    });
    Ok(Bounds::of_pieces(pieces.collect::<Result<Vec<_>>>()?))
}

/// The slope at which a search is content, relative to that at its beginning.
const CONTENT: f64 = 0.1;

/// The slope of a plateau, relative to that at the beginning: all responses are saturated there.
const DEAD: f64 = 1e-6;

/// Where on [0, 1] a function falls most: the root of its slope for a convex one, some lower place for any other. `at` gives
/// value and slope; `value` and `slope` (negative) are those at 0. A plateau above 0 is too far, though it be lower: no step leaves it.
fn segment_minimum(
    value: f64,
    slope: f64,
    mut at: impl FnMut(f32) -> (f64, f64),
) -> LineSearchResult {
    let mut best = LineSearchResult {
        alpha: 0.0,
        slope: 1.0,
    };
    let mut lowest = value;
    // Ends of the bracket with their slopes; the right end is the first one that is too far
    let (mut left, mut right) = ((0.0f32, slope), None::<(f32, f64)>);
    let mut alpha = 1.0f32;
    let is_dead = |(v, s): (f64, f64)| v > 0.0 && s.abs() <= DEAD * slope.abs();
    let mut has_plateau = false;
    for _ in 0..40 {
        let (v, s) = at(alpha);
        if alpha == 1.0 && is_dead((v, s)) {
            has_plateau = is_dead(at(0.5));
        }
        let is_beyond = has_plateau && is_dead((v, s));
        if v < lowest && !is_beyond {
            lowest = v;
            best = LineSearchResult {
                alpha,
                slope: s / slope,
            };
        }
        let content = !is_beyond
            && v < value
            && (s.abs() <= CONTENT * slope.abs() || (alpha == 1.0 && s <= 0.0));
        if content {
            return LineSearchResult {
                alpha,
                slope: s / slope,
            };
        }
        if v <= value && s < 0.0 && !is_beyond {
            left = (alpha, s);
        } else {
            // A slope that is no number, or a higher place, only says "nearer"
            let is_near = v <= value && !is_beyond;
            right = Some((alpha, if is_near { s } else { f64::NAN }));
        }
        let Some(end) = right else { break };
        alpha = between(left, end);
        if alpha <= left.0 || alpha >= end.0 {
            break;
        }
    }
    best
}

/// A place inside a bracket: where the slopes, joined by a line, cross 0, kept away from the ends.
#[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
fn between(left: (f32, f64), right: (f32, f64)) -> f32 {
    let width = f64::from(right.0) - f64::from(left.0);
    let share = left.1 / (left.1 - right.1);
    let share = if share.is_finite() {
        share.clamp(0.02, 0.98)
    } else {
        0.25
    };
    (f64::from(left.0) + share * width) as f32
}

/// Where on [0, ∞) a function falls most, to within a tenth of its slope.
#[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
fn ray_minimum(value: f64, slope: f64, mut at: impl FnMut(f32) -> (f64, f64)) -> f64 {
    // A loss that is nowhere negative falls no longer than this at its first slope
    let mut reach = (value / slope.abs()).clamp(1e-30, 1e30);
    for _ in 0..20 {
        let (v, s) = at(reach as f32);
        // A saturating response flattens out without ever rising
        if v > value || s >= CONTENT * slope || s.is_nan() {
            break;
        }
        reach *= 4.0;
    }
    let found = segment_minimum(value, slope * reach, |alpha| {
        let (v, s) = at((f64::from(alpha) * reach) as f32);
        (v, s * reach)
    });
    f64::from(found.alpha) * reach
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_ends_before_a_plateau_however_low() {
        // Falls from 1 to 0.6 at 0.1, rises to 0.7 at 0.2, and is 0.2 from 0.3 on, where all responses are saturated
        let at = |alpha: f32| match f64::from(alpha) {
            a if a < 0.1 => (1.0 - 4.0 * a, -4.0),
            a if a < 0.2 => (0.6 + (a - 0.1), 1.0),
            a if a < 0.3 => (0.7 - 5.0 * (a - 0.2), -5.0),
            _ => (0.2, 0.0),
        };
        let found = segment_minimum(1.0, -4.0, at);
        assert!(found.alpha > 0.05 && found.alpha < 0.3, "{found:?}");
        // The end of a segment is a minimum like any other, and so is 0
        let parabola = |alpha: f32| {
            let left = 1.0 - f64::from(alpha);
            (0.5 + left * left, -2.0 * left)
        };
        assert_eq!(segment_minimum(1.5, -2.0, parabola).alpha, 1.0);
        let reached = |alpha: f32| match f64::from(alpha) {
            a if a < 0.4 => (1.0 - 2.5 * a, -2.5),
            _ => (0.0, 0.0),
        };
        assert_eq!(segment_minimum(1.0, -2.5, reached).alpha, 1.0);
    }
}
