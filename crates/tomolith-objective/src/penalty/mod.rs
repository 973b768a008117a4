//! Penalties on patterns: R of the one equation.
//!
//! *What must it do, and who does it.* A penalty is a function of the patterns alone, as data: a [`PatternCost`]. The table [`PENALTIES`]
//! holds what makes them, and [`Penalties`] is their weighted sum, with its gradient and its course along a step, which a `Problem` of an
//! optimization adds to the loss. A job lists them as `[[penalties]]`, one kind each, with `weight` = λ.

pub mod smoothness;
pub mod sparsity;
mod weighted;

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use std::fmt::Debug;
use std::sync::Arc;
use tomolith_core::dose::PatternLayout;
use tomolith_core::error::Result;
use tomolith_core::field::PatternCost;
use tomolith_core::kind::{Kind, Read, Section};
pub use weighted::Penalties;

/// A penalty with its parameters, before it knows any patterns.
pub trait MakePenalty: Debug + Send + Sync {
    /// The penalty on patterns of these layouts, one per light, one after the other in the field.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) with the key of a parameter out of range; never for parameters that a row
    /// [read](BuildPenalty).
    fn make(&self, lights: &[PatternLayout]) -> Result<PatternCost>;
    /// Whether it compares pixels of different frames.
    fn joins_frames(&self) -> bool {
        false
    }
}

/// Reads the parameters of a penalty from its section.
pub type BuildPenalty = Read<Arc<dyn MakePenalty>>;

/// The `build` of a row whose parameters are P; refuses those out of range.
fn read<P>(section: &Section) -> Result<Arc<dyn MakePenalty>>
where
    P: MakePenalty + DeserializeOwned + JsonSchema + 'static,
{
    let params: P = section.parse()?;
    params.make(&[]).map_err(|e| e.under(&section.path))?;
    Ok(Arc::new(params))
}

/// Every penalty.
pub static PENALTIES: &[Kind<BuildPenalty>] = &[sparsity::KIND, smoothness::KIND];

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use tomolith_core::check::{self, example, refuses};
    use tomolith_core::dose::Quantity;
    use tomolith_core::field::{Field, HostField};
    use tomolith_core::grid::PatternGrid;
    use tomolith_core::near;

    /// Two lights, the second with gaps and an arc that does not close.
    pub(super) fn layouts() -> Vec<PatternLayout> {
        let first = PatternGrid::full_turn(5, 0.0, 7, 4, 0.1);
        let one = PatternLayout::new(first, Quantity::Energy, 0, &[(0, 7); 20]);
        let mut second = PatternGrid::full_turn(3, 0.0, 9, 6, 0.1);
        second.frame_arc = 0.0;
        let runs: Vec<(u32, u32)> = (0..18).map(|i| (i % 4, (i * 5) % 6)).collect();
        let two = PatternLayout::new(second, Quantity::Energy, one.len(), &runs);
        vec![one, two]
    }

    fn patterns(len: usize, seed: u64) -> HostField {
        // No step of the checks takes a pixel through 0, where a power of 1 has a kink
        let values: Vec<f32> = check::noise(seed, len)
            .iter()
            .map(|v| 0.75 + 0.2 * v)
            .collect();
        HostField::from_slice(&values)
    }

    /// A penalty of weight 1 where patterns live.
    pub(super) fn alone(cost: PatternCost) -> Penalties<HostField> {
        Penalties::new(vec![(1.0, cost)]).unwrap()
    }

    /// Value, gradient and course along a step belong together; the gradient is the derivative.
    fn check_penalty(name: &str, section: &Section, row: &Kind<BuildPenalty>) {
        let layouts = layouts();
        let len = layouts.iter().map(PatternLayout::len).sum();
        let penalty = alone((row.build)(section).unwrap().make(&layouts).unwrap());
        let (x, step) = (
            patterns(len, 3),
            HostField::from_slice(&check::noise(9, len)),
        );
        let mut gradient = x.zeros_like();
        gradient.fill(0.25);
        let value = penalty.add_gradient(&x, 2.0, &mut gradient);
        near!(value, penalty.value(&x), 1e-9 * (1.0 + value), "{name}");
        let mut rest = gradient.clone();
        rest.as_mut_slice()
            .iter_mut()
            .for_each(|g| *g = 0.5 * (*g - 0.25));
        let slope = rest.dot(&step);
        let (along, there) = penalty.slope_along(&x, &step, 0.0);
        assert!((along - value).abs() < 1e-9 * (1.0 + value), "{name}");
        near!(there, slope, 1e-5 * rest.norm() * step.norm(), "{name}");
        for alpha in [-0.3f32, 0.1, 0.5] {
            let mut moved = x.clone();
            moved.axpy(alpha, &step);
            let (value, slope) = penalty.slope_along(&x, &step, alpha);
            near!(value, penalty.value(&moved), 1e-6 * (1.0 + value));
            let h = 1e-2;
            let ends = [alpha + h, alpha - h].map(|a| penalty.slope_along(&x, &step, a).0);
            let difference = (ends[0] - ends[1]) / f64::from(2.0 * h);
            assert!(
                (difference - slope).abs() < 2e-3 * (1.0 + slope.abs()),
                "{name} at {alpha}: {slope}, differences {difference}"
            );
        }
        if penalty.is_convex() {
            let slopes =
                [-0.5f32, -0.2, 0.0, 0.3, 0.9].map(|a| penalty.slope_along(&x, &step, a).1);
            assert!(
                slopes.windows(2).all(|w| w[1] >= w[0] - 1e-6 * w[0].abs()),
                "{name}: {slopes:?}"
            );
        }
    }

    #[test]
    fn every_row_is_a_value_with_its_gradient() {
        for row in PENALTIES {
            check_penalty(row.name, &example(row), row);
        }
        for (row, json) in [
            (
                smoothness::KIND,
                json!({"rows": 0.0, "columns": 2.0, "angles": 0.5}),
            ),
            (smoothness::KIND, json!({"edge": 0.2})),
            (sparsity::KIND, json!({"exponent": 1.0})),
            (sparsity::KIND, json!({"exponent": 1.5})),
            (sparsity::KIND, json!({"exponent": 4.0})),
        ] {
            let section = Section::new("penalties[0]", json.clone());
            check_penalty(&json.to_string(), &section, &row);
        }
    }

    #[test]
    fn parameters_out_of_range_are_named() {
        for (kind, json, key) in [
            ("sparsity", json!({"exponent": 0.0}), "exponent"),
            ("smoothness", json!({"rows": -1.0}), "rows"),
            ("smoothness", json!({"edge": 0.0}), "edge"),
            (
                "smoothness",
                json!({"rows": 0, "columns": 0, "angles": 0}),
                "rows",
            ),
        ] {
            let row = PENALTIES.iter().find(|row| row.name == kind).unwrap();
            let section = Section::new(format!("penalties[0].{kind}"), json);
            let key = format!("penalties[0].{kind}.{key}");
            refuses((row.build)(&section), &key);
        }
    }
}
