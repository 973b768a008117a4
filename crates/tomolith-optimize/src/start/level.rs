//! Starts that do not look at the target's shape: `uniform`, every pixel alike, and `zero`, all dark.
//!
//! **Equation** x = c with c from least squares between the dose of the part and the wanted one; x = 0, or the lower bound.
//!
//! **Parameters** none. **Cost** one forward call; none for `zero`.

use super::{BuildStart, InitialPatterns, StartInput};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::dose::Work;
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

/// They have no parameters.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {}

/// Every pixel alike.
#[derive(Clone, Copy, Debug)]
pub struct Uniform;

/// All dark.
#[derive(Clone, Copy, Debug)]
pub struct Zero;

/// The row of `uniform`.
#[must_use]
pub const fn uniform<F: Field>() -> Kind<BuildStart<F>> {
    Kind {
        name: "uniform",
        summary: "every pixel alike, the part's doses right by least squares",
        example: "[start.uniform]",
        schema: schema_of::<Params>,
        build: |section| {
            section.parse::<Params>()?;
            Ok(Box::new(Uniform))
        },
    }
}

/// The row of `zero`.
#[must_use]
pub const fn zero<F: Field>() -> Kind<BuildStart<F>> {
    Kind {
        name: "zero",
        summary: "all pixels dark, or at their lower bound",
        example: "[start.zero]",
        schema: schema_of::<Params>,
        build: |section| {
            section.parse::<Params>()?;
            Ok(Box::new(Zero))
        },
    }
}

impl<F: Field> InitialPatterns<F> for Uniform {
    fn patterns(&self, input: &StartInput<F>, work: &Work) -> Result<F> {
        input.require_linear("uniform")?;
        let mut x = input.model.new_patterns()?;
        x.fill(1.0);
        input.scaled(x, &input.wanted_dose()?, work)
    }
}

impl<F: Field> InitialPatterns<F> for Zero {
    fn asks_for_doses(&self) -> bool {
        false
    }

    fn patterns(&self, input: &StartInput<F>, _: &Work) -> Result<F> {
        input.bounded(input.model.new_patterns()?)
    }
}
