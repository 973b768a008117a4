//! A response whose parameters are unknowns, too.
//!
//! ```text
//! min over x, θ   L( M_θ(F(x)) ) + Σ λᵢ·Rᵢ(x)      subject to   min ≤ x ≤ max,   θ_min ≤ θ ≤ θ_max
//! ```
//!
//! **Source** proposed, not done, by Li et al., Additive Manufacturing 94 (2024) 104447, section 3.4.1. The method is variable projection (Golub and
//! Pereyra, SIAM J. Numer. Anal. 10 (1973) 413): after every step of the optimizer L is minimized over θ at the dose at hand, so that the optimizer
//! descends φ(x) = min over θ of L. By the envelope theorem the gradient of φ is that of L by x with θ held, so gradients of different steps belong to
//! one function, and a method keeps what it has learned of curvature.
//!
//! **Search over θ** pattern search (Hooke and Jeeves, J. ACM 8 (1961) 212) in a unit cube: a step up or down along each axis in turn, once more the
//! same way after a success, half the step after none. A parameter whose range lies above 0 moves along its logarithm, others evenly. The first
//! step is a quarter of the range, later ones twice what the last search moved, the finest a quarter of the tolerance. It never raises the loss and
//! finds a minimum from where it is, not the lowest of several.
//!
//! **Cost** a value of the objective on the dose at hand per trial, at most 40 for each parameter and step; no dose.

use std::fmt::Debug;
use std::sync::Arc;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;
use tomolith_core::response::Response;
use tomolith_core::units::exact;
use tomolith_objective::Objective;

/// One parameter: where it begins and between what it lies.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeParameter {
    /// Its name.
    pub name: String,
    /// Smallest and largest value.
    pub range: [f64; 2],
    /// Where the search begins; brought into the range.
    pub start: f64,
}

/// The response with these parameters.
pub type Respond<'a> = Box<dyn Fn(&[f64]) -> Result<Arc<dyn Response>> + Send + Sync + 'a>;

/// An objective whose response has unknown parameters; see the [module](self).
pub struct FreeResponse<'a, F> {
    objective: Box<dyn Objective<F> + 'a>,
    parameters: Vec<FreeParameter>,
    respond: Respond<'a>,
    tolerance: f64,
    values: Vec<f64>,
}

/// First step of a search that knows nothing, as a share of the range.
const FIRST: f64 = 0.25;
/// Most values of the objective per parameter and search.
const MOST_VALUES: usize = 40;

impl FreeParameter {
    /// Refuses a range that is none.
    ///
    /// # Errors
    /// [`Error::Config`] with the parameter's name as the key.
    pub fn validate(&self) -> Result<()> {
        let [low, high] = self.range;
        if low < high && (high - low).is_finite() && self.start.is_finite() {
            return Ok(());
        }
        Err(Error::config(
            self.name.clone(),
            format!("found [{}, {}]", exact(low), exact(high)),
            "its smallest and its largest value, for example [10.0, 150.0]; the first below the second",
        ))
    }

    /// The place of a value in the range, 0 to 1.
    fn place(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let place = if low > 0.0 {
            (value / low).ln() / (high / low).ln()
        } else {
            (value - low) / (high - low)
        };
        place.clamp(0.0, 1.0)
    }

    /// The value at a place of the range; the ends are met exactly.
    fn value(&self, place: f64) -> f64 {
        let [low, high] = self.range;
        if place <= 0.0 {
            low
        } else if place >= 1.0 {
            high
        } else if low > 0.0 {
            (low * (high / low).powf(place)).clamp(low, high)
        } else {
            (low + (high - low) * place).clamp(low, high)
        }
    }
}

/// The best place so far of a search.
#[derive(Clone)]
struct Best {
    place: Vec<f64>,
    loss: f64,
    /// Trials that are left.
    left: usize,
}

impl<'a, F: Field> FreeResponse<'a, F> {
    /// An objective with a response of these unknown parameters, found to `tolerance`, a part of their ranges.
    ///
    /// # Errors
    /// [`Error::Config`] for a range that is none, no parameter, or a tolerance out of range; what `respond` refuses;
    /// [`Error::Unsupported`] for an objective that knows no response.
    pub fn new(
        objective: Box<dyn Objective<F> + 'a>,
        parameters: Vec<FreeParameter>,
        respond: Respond<'a>,
        tolerance: f64,
    ) -> Result<Self> {
        parameters.iter().try_for_each(FreeParameter::validate)?;
        if parameters.is_empty() {
            return Err(Error::config("response", "no parameter", "at least one"));
        }
        if !(tolerance > 0.0 && tolerance <= FIRST) {
            let found = format!("found {}", exact(tolerance));
            return Err(Error::config("tolerance", found, "above 0, at most 0.25"));
        }
        let starts: Vec<f64> = parameters.iter().map(|p| p.start).collect();
        let mut free = FreeResponse {
            objective,
            parameters,
            respond,
            tolerance,
            values: Vec::new(),
        };
        free.set(&starts)?;
        Ok(free)
    }

    /// The objective with the parameters at hand.
    pub(super) fn objective(&self) -> &dyn Objective<F> {
        self.objective.as_ref()
    }

    /// The parameters at hand.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Takes other parameters, brought into their ranges.
    pub(super) fn set(&mut self, values: &[f64]) -> Result<()> {
        let pairs = self.parameters.iter().zip(values);
        let values = pairs.map(|(p, value)| value.clamp(p.range[0], p.range[1]));
        self.values = values.collect();
        self.respond_at(&self.values.clone())
    }

    fn respond_at(&mut self, values: &[f64]) -> Result<()> {
        let response = (self.respond)(values)?;
        self.objective.set_response(&response)
    }

    /// By how much the parameters at hand differ from others, as a part of their ranges; None from parameters of another number.
    pub(super) fn distance(&self, from: &[f64]) -> Option<f64> {
        let pairs = self.parameters.iter().zip(self.values.iter().zip(from));
        let moved = pairs.map(|(p, (is, was))| (p.place(*is) - p.place(*was)).abs());
        (from.len() == self.values.len()).then(|| moved.fold(0.0, f64::max))
    }

    /// Whether the last search moved them by no more than the tolerance from `before`.
    pub(super) fn is_settled(&self, before: &[f64]) -> bool {
        self.distance(before)
            .is_some_and(|moved| moved <= self.tolerance)
    }

    /// Minimizes the objective of a dose over the parameters. `before` are those that the last search began at, where there was one: it says how
    /// far this one may have to go.
    pub(super) fn fit(&mut self, dose: &F, before: &[f64]) -> Result<()> {
        let finest = 0.25 * self.tolerance;
        let mut step = self
            .distance(before)
            .map_or(FIRST, |moved| (2.0 * moved).clamp(2.0 * finest, FIRST));
        let places = self.parameters.iter().zip(&self.values);
        let begin = Best {
            place: places.map(|(p, value)| p.place(*value)).collect(),
            loss: self.objective.value(dose),
            left: MOST_VALUES * self.parameters.len(),
        };
        let mut best = begin.clone();
        while step >= finest && best.left > 0 && best.loss > 0.0 {
            let from = best.place.clone();
            self.sweep(dose, step, &mut best)?;
            if best.place == from {
                step *= 0.5;
            } else {
                let further = best.place.iter().zip(&from);
                let further = further.map(|(is, was)| (2.0 * is - was).clamp(0.0, 1.0));
                self.try_at(dose, further.collect(), &mut best)?;
            }
        }
        if best.place != begin.place {
            self.values = self.values_at(&best.place);
        }
        // The last trial need not have been the best
        self.respond_at(&self.values.clone())
    }

    /// A step up or down along each axis.
    fn sweep(&mut self, dose: &F, step: f64, best: &mut Best) -> Result<()> {
        for axis in 0..self.parameters.len() {
            for way in [step, -step] {
                let mut place = best.place.clone();
                place[axis] = (place[axis] + way).clamp(0.0, 1.0);
                if self.try_at(dose, place, best)? {
                    break;
                }
            }
        }
        Ok(())
    }

    /// Takes a place if the loss is lower there.
    fn try_at(&mut self, dose: &F, place: Vec<f64>, best: &mut Best) -> Result<bool> {
        if place == best.place || best.left == 0 {
            return Ok(false);
        }
        best.left -= 1;
        self.respond_at(&self.values_at(&place))?;
        let loss = self.objective.value(dose);
        let is_better = loss < best.loss;
        if is_better {
            (best.place, best.loss) = (place, loss);
        }
        Ok(is_better)
    }

    fn values_at(&self, place: &[f64]) -> Vec<f64> {
        let pairs = self.parameters.iter().zip(place);
        pairs.map(|(p, place)| p.value(*place)).collect()
    }
}

#[cfg(test)]
mod tests;
