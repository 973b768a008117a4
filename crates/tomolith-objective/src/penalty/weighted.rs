//! The weighted sum of penalties.

use crate::preset::not_negative;
use std::sync::{Arc, OnceLock};
use tomolith_core::error::Result;
use tomolith_core::field::{CostKernel, Field, PatternCost};

/// R = Σ λᵢ·Rᵢ where patterns live; empty by default. It knows no optics.
pub struct Penalties<F: Field>(Vec<Part<F>>);

/// A penalty, compiled by the field's backend when it sees the first patterns.
struct Part<F: Field> {
    /// λ
    weight: f64,
    cost: Arc<PatternCost>,
    /// The penalty where patterns live.
    kernel: OnceLock<F::Costs>,
}

impl<F: Field> Part<F> {
    fn kernel(&self, x: &F) -> &F::Costs {
        self.kernel.get_or_init(|| F::Costs::new(&self.cost, x))
    }
}

impl<F: Field> Default for Penalties<F> {
    fn default() -> Self {
        Penalties(Vec::new())
    }
}

impl<F: Field> Penalties<F> {
    /// The sum of these, each with its λ.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) when a weight is negative or not finite.
    pub fn new(parts: Vec<(f64, PatternCost)>) -> Result<Self> {
        let part = |(i, (weight, cost))| {
            not_negative(&format!("penalties[{i}].weight"), weight)?;
            Ok(Part {
                weight,
                cost: Arc::new(cost),
                kernel: OnceLock::new(),
            })
        };
        let parts = parts.into_iter().enumerate().map(part);
        Ok(Penalties(parts.collect::<Result<_>>()?))
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// R(x)
    pub fn value(&self, x: &F) -> f64 {
        let value = |part: &Part<F>| part.weight * part.kernel(x).value(x);
        self.0.iter().map(value).sum()
    }

    /// gradient ← gradient + scale·∂R/∂x; returns R(x).
    pub fn add_gradient(&self, x: &F, scale: f64, gradient: &mut F) -> f64 {
        let add = |part: &Part<F>| {
            let scale = scale * part.weight;
            part.weight * part.kernel(x).add_gradient(x, scale, gradient)
        };
        self.0.iter().map(add).sum()
    }

    /// α ↦ (R, dR/dα) of x + α·step, for line searches, without a temporary field.
    pub fn slope_along(&self, x: &F, step: &F, alpha: f32) -> (f64, f64) {
        self.0.iter().fold((0.0, 0.0), |(value, slope), part| {
            let (v, s) = part.kernel(x).slope_along(x, step, alpha);
            (value + part.weight * v, slope + part.weight * s)
        })
    }

    /// Whether R is convex.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        self.0.iter().all(|part| part.cost.is_convex())
    }
}
