//! A weighted sum of objectives.

use super::{FoundWindow, Objective};
use std::sync::Arc;
use tomolith_core::dose::regions::ByElement;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;
use tomolith_core::response::Response;

/// L = Σ_k weight_k·L_k. A gradient of more than one part needs a temporary field.
pub struct Sum<F> {
    parts: Vec<(f64, Box<dyn Objective<F>>)>,
}

impl<F: Field> Sum<F> {
    /// The sum of these parts.
    ///
    /// # Errors
    /// [`Error::Config`] when there is no part, or a weight is negative or not finite.
    pub fn new(parts: Vec<(f64, Box<dyn Objective<F>>)>) -> Result<Self> {
        if parts.is_empty() {
            return Err(Error::config("objectives", "no objective", "at least one"));
        }
        for (i, (weight, _)) in parts.iter().enumerate() {
            super::preset::not_negative(&format!("objectives[{i}].weight"), *weight)?;
        }
        Ok(Sum { parts })
    }

    /// The sum with the weights of sums over voxels multiplied by `factor`: voxels of another size then cost the same for their volume.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        let sums = self.parts.iter_mut().filter(|(_, part)| !part.is_mean());
        sums.for_each(|(weight, _)| *weight *= factor);
        self
    }
}

impl<F: Field> Objective<F> for Sum<F> {
    fn value(&self, dose: &F) -> f64 {
        self.parts
            .iter()
            .map(|(w, part)| w * part.value(dose))
            .sum()
    }

    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64 {
        let mut temporary = None;
        let mut loss = 0.0;
        for (i, (weight, part)) in self.parts.iter().enumerate() {
            if i == 0 {
                loss += weight * part.value_and_gradient(dose, grad);
                grad.scale(*weight as f32);
            } else {
                let temporary = temporary.get_or_insert_with(|| grad.zeros_like());
                loss += weight * part.value_and_gradient(dose, temporary);
                grad.axpy(*weight as f32, temporary);
            }
        }
        loss
    }

    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64) {
        self.parts
            .iter()
            .fold((0.0, 0.0), |(loss, slope), (w, part)| {
                let (value, rise) = part.slope_along(dose, step, alpha);
                (loss + w * value, slope + w * rise)
            })
    }

    fn is_convex(&self) -> bool {
        self.parts.iter().all(|(_, part)| part.is_convex())
    }

    fn harmless(&self) -> Option<Box<ByElement<'_>>> {
        let parts = self.parts.iter().map(|(_, part)| part.harmless());
        let mut parts: Vec<_> = parts.collect::<Option<_>>()?;
        if parts.len() == 1 {
            return parts.pop();
        }
        Some(Box::new(move |i| {
            let limits = parts.iter().map(|part| part(i));
            limits.fold(f32::INFINITY, f32::min)
        }))
    }

    fn set_response(&mut self, response: &Arc<dyn Response>) -> Result<()> {
        let mut parts = self.parts.iter_mut();
        parts.try_for_each(|(_, part)| part.set_response(response))
    }

    fn window(&self, dose: &F) -> Option<FoundWindow> {
        self.parts.iter().find_map(|(_, part)| part.window(dose))
    }
}
