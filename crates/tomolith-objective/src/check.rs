//! What every objective must do.

use crate::{OBJECTIVES, Objective, ObjectiveInput};
use serde_json::{Value, json};
use std::sync::Arc;
use tomolith_core::check::noise;
use tomolith_core::check::small::SmallModel;
use tomolith_core::field::{Field, HostField};
use tomolith_core::kind::Section;
use tomolith_core::response::Response;

/// The objective `[objective.NAME]` with these parameters for the ring of a small model.
///
/// # Panics
/// When it is refused.
pub fn of_ring(
    model: &SmallModel,
    name: &str,
    parameters: Value,
    response: Arc<dyn Response>,
) -> Box<dyn Objective<HostField>> {
    let (target, labels) = model.ring();
    let input = ObjectiveInput {
        layout: model.layout(),
        labels: &labels,
        target: &target,
        response,
    };
    let section = Section::new("objective", json!({ name: parameters }));
    section.read(OBJECTIVES).unwrap().make(&input).unwrap()
}

/// Checks an objective around a dose:
///
/// - the gradient is the derivative: the remainder L(d + hv) − L(d) − h·g·v falls with h² (for directions v that keep away from
///   voxels at whose band's edge the slope jumps; so it holds for every power, also p ≤ 1);
/// - `value`, `value_and_gradient`, `slope_along` and `advance` agree, the values bit for bit;
/// - one that claims to be convex has slopes that never fall along a line;
/// - whatever stood in `grad` before is overwritten;
/// - doses that it calls [harmless](Objective::harmless) cost nothing and have no gradient.
///
/// # Errors
/// What is wrong, in one sentence.
pub fn objective(objective: &dyn Objective<HostField>, dose: &HostField) -> Result<(), String> {
    let step = HostField::from_slice(&noise(7, dose.len()));
    agreement(objective, dose, &step)?;
    convexity(objective, dose, &step)?;
    harmlessness(objective, dose, &step)?;
    remainder(objective, dose, &step)
}

fn gradient_at(objective: &dyn Objective<HostField>, dose: &HostField) -> (f64, HostField) {
    let mut gradient = dose.zeros_like();
    gradient.fill(f32::NAN);
    let value = objective.value_and_gradient(dose, &mut gradient);
    (value, gradient)
}

fn moved(dose: &HostField, step: &HostField, alpha: f32) -> HostField {
    let mut moved = dose.clone();
    moved.axpy(alpha, step);
    moved
}

fn agreement(
    objective: &dyn Objective<HostField>,
    dose: &HostField,
    step: &HostField,
) -> Result<(), String> {
    for alpha in [0.0f32, 0.3, -0.7] {
        let there = moved(dose, step, alpha);
        let (value, gradient) = gradient_at(objective, &there);
        if !value.is_finite() || gradient.max_abs().is_nan() {
            return Err(format!(
                "at α = {alpha} the loss is {value}, or its gradient is no number"
            ));
        }
        let (along, slope) = objective.slope_along(dose, step, alpha);
        let (mut advanced, mut cotangent) = (dose.clone(), step.clone());
        for (what, found) in [
            ("value", objective.value(&there)),
            ("slope_along", along),
            (
                "advance",
                objective.advance(&mut advanced, &mut cotangent, alpha),
            ),
        ] {
            if found.to_bits() != value.to_bits() {
                return Err(format!(
                    "{what} gives {found}, value_and_gradient {value} (α = {alpha})"
                ));
            }
        }
        if advanced.as_slice() != there.as_slice() || cotangent.as_slice() != gradient.as_slice() {
            return Err(format!(
                "advance leaves another dose or gradient (α = {alpha})"
            ));
        }
        let expected = gradient.dot(step);
        let size = gradient.norm() * step.norm();
        if (slope - expected).abs() > 1e-6 * size {
            return Err(format!(
                "slope_along gives {slope}, gradient times step {expected} (α = {alpha})"
            ));
        }
    }
    Ok(())
}

/// A convex function's slope along a line never falls.
fn convexity(
    objective: &dyn Objective<HostField>,
    dose: &HostField,
    step: &HostField,
) -> Result<(), String> {
    if !objective.is_convex() {
        return Ok(());
    }
    let slopes = [-1.0, -0.5, -0.1, 0.0, 0.2, 0.6, 1.0]
        .map(|alpha| objective.slope_along(dose, step, alpha).1);
    let size = slopes
        .iter()
        .fold(0.0, |size: f64, slope| size.max(slope.abs()));
    if slopes.windows(2).any(|w| w[1] < w[0] - 1e-5 * size) {
        return Err(format!(
            "it claims to be convex, but its slopes along a line are {slopes:?}"
        ));
    }
    Ok(())
}

/// Doses from 0 up to what is harmless are all the same.
fn harmlessness(
    objective: &dyn Objective<HostField>,
    dose: &HostField,
    noise: &HostField,
) -> Result<(), String> {
    let Some(harmless) = objective.harmless() else {
        return Ok(());
    };
    let limits: Vec<f32> = (0..dose.len()).map(harmless).collect();
    let with = |share: &dyn Fn(usize) -> f32| {
        let each = dose.as_slice().iter().zip(&limits).enumerate();
        let values = each.map(|(i, (&dose, &limit))| match limit > 0.0 {
            true => share(i) * limit.min(10.0),
            false => dose,
        });
        HostField::from_slice(&values.collect::<Vec<f32>>())
    };
    let (dark, _) = gradient_at(objective, &with(&|_| 0.0));
    let (lit, gradient) = gradient_at(objective, &with(&|i| noise.as_slice()[i].abs().sqrt()));
    let slopes = gradient.as_slice().iter().zip(&limits);
    let costs = slopes.filter(|(slope, limit)| **limit > 0.0 && **slope != 0.0);
    match costs.count() {
        0 if lit == dark => Ok(()),
        count => Err(format!(
            "harmless doses have the loss {lit} in place of {dark}, and {count} have a gradient"
        )),
    }
}

/// Largest step of the Taylor test, in units of dose.
const REACH: f32 = 0.02;

fn remainder(
    objective: &dyn Objective<HostField>,
    dose: &HostField,
    noise: &HostField,
) -> Result<(), String> {
    let (value, gradient) = gradient_at(objective, dose);
    // Uphill, so that nothing cancels, by ½ to 1: a voxel nearer to an edge than the reach is sure to cross it
    let mut step = noise.clone();
    for (v, g) in step.as_mut_slice().iter_mut().zip(gradient.as_slice()) {
        let sign = if *g == 0.0 { *v } else { *g };
        *v = (0.5 + 0.5 * v.abs()).copysign(sign);
    }
    let ends = [REACH, -REACH].map(|h| gradient_at(objective, &moved(dose, &step, h)).1);
    let mut smooth = 0;
    for (i, v) in step.as_mut_slice().iter_mut().enumerate() {
        let [before, here, after] = [&ends[1], &gradient, &ends[0]].map(|g| g.as_slice()[i]);
        // Where the slope is smooth it changes evenly; at an edge all of the change is on one side
        let uneven = (after - 2.0 * here + before).abs();
        if uneven <= 0.3 * (after - before).abs() + 1e-5 * here.abs() {
            smooth += 1;
        } else {
            *v = 0.0;
        }
    }
    if smooth * 2 < dose.len() {
        return Err(format!(
            "only {smooth} of {} voxels keep away from an edge: choose another dose",
            dose.len()
        ));
    }
    let slope = gradient.dot(&step);
    let remainders: Vec<(f64, f64)> = (0..4)
        .map(|k| {
            let h = REACH * 0.5f32.powi(k);
            let change = objective.value(&moved(dose, &step, h)) - value;
            (f64::from(h), (change - f64::from(h) * slope).abs())
        })
        .collect();
    // Doses and terms are rounded to f32, each in its own way
    let noise = 1e-6 * gradient.norm() + 3e-8 * value;
    let clear = remainders
        .iter()
        .take_while(|(_, r)| *r > 10.0 * noise)
        .count();
    if clear > 0 {
        // One below the noise still tells that it fell
        let (first, last) = (remainders[0], remainders[clear.clamp(2, 4) - 1]);
        let order = (first.1 / last.1).log2() / (first.0 / last.0).log2();
        // Terms of second order may cancel by chance; then what is left must be small compared with the slope
        if order < 1.7 && last.1 > 2e-3 * last.0 * slope.abs() {
            return Err(format!(
                "the Taylor remainder falls with order {order:.2}, not 2: {remainders:?}"
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Σ d² with a gradient that is a little too large.
    struct Wrong(f32);

    impl Objective<HostField> for Wrong {
        fn value(&self, dose: &HostField) -> f64 {
            dose.dot(dose)
        }

        fn value_and_gradient(&self, dose: &HostField, grad: &mut HostField) -> f64 {
            grad.copy_from(dose);
            grad.scale(2.0 * self.0);
            dose.dot(dose)
        }

        fn slope_along(&self, dose: &HostField, step: &HostField, alpha: f32) -> (f64, f64) {
            let mut there = dose.clone();
            there.axpy(alpha, step);
            (there.dot(&there), 2.0 * f64::from(self.0) * there.dot(step))
        }

        fn is_convex(&self) -> bool {
            true
        }
    }

    #[test]
    fn a_gradient_that_is_off_by_one_percent_is_found() {
        let dose = HostField::from_slice(&noise(1, 500));
        objective(&Wrong(1.0), &dose).unwrap();
        let complaint = objective(&Wrong(1.01), &dose).unwrap_err();
        assert!(complaint.contains("order"), "{complaint}");
    }
}
