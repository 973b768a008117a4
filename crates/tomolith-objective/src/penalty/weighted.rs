//! The weighted sum of penalties.

use super::PatternPenalty;
use crate::preset::not_negative;
use tomolith_core::error::Result;
use tomolith_core::field::Field;

/// Σ λᵢ·Rᵢ; empty by default.
pub struct Penalties<F>(Vec<(f64, Box<dyn PatternPenalty<F>>)>);

impl<F> Default for Penalties<F> {
    fn default() -> Self {
        Penalties(Vec::new())
    }
}

impl<F: Field> Penalties<F> {
    /// The sum of these, each with its λ.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) when a weight is negative or not finite.
    pub fn new(parts: Vec<(f64, Box<dyn PatternPenalty<F>>)>) -> Result<Self> {
        for (i, (weight, _)) in parts.iter().enumerate() {
            not_negative(&format!("penalties[{i}].weight"), *weight)?;
        }
        Ok(Penalties(parts))
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<F: Field> PatternPenalty<F> for Penalties<F> {
    fn value(&self, x: &F) -> f64 {
        self.0
            .iter()
            .map(|(weight, part)| weight * part.value(x))
            .sum()
    }

    fn add_gradient(&self, x: &F, scale: f64, gradient: &mut F) -> f64 {
        let add = |(weight, part): &(f64, Box<dyn PatternPenalty<F>>)| {
            weight * part.add_gradient(x, scale * weight, gradient)
        };
        self.0.iter().map(add).sum()
    }

    fn slope_along(&self, x: &F, step: &F, alpha: f32) -> (f64, f64) {
        self.0
            .iter()
            .fold((0.0, 0.0), |(value, slope), (weight, part)| {
                let (v, s) = part.slope_along(x, step, alpha);
                (value + weight * v, slope + weight * s)
            })
    }

    fn is_convex(&self) -> bool {
        self.0.iter().all(|(_, part)| part.is_convex())
    }
}
