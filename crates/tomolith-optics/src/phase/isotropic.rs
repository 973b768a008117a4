//! Light goes everywhere alike: density ½ of the cosine.

use super::{BuildPhase, Phase};
use crate::random::Stream;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};

/// See the [module page](self).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Isotropic {}

impl Phase for Isotropic {
    fn density(&self, _cosine: f64) -> f64 {
        0.5
    }

    fn draw(&self, random: &mut Stream) -> f64 {
        2.0 * random.uniform() - 1.0
    }

    fn henyey_greenstein(&self) -> Option<f64> {
        Some(0.0)
    }
}

/// Row of [`PHASES`](super::PHASES).
pub const KIND: Kind<BuildPhase> = Kind {
    name: "isotropic",
    summary: "Scattered light goes into all directions equally.",
    example: "[resin.phase.isotropic]\n",
    schema: schema_of::<Isotropic>,
    build: |section| Ok(Box::new(section.parse::<Isotropic>()?)),
};
