//! Henyey and Greenstein's phase function: one number g, the mean cosine.
//!
//! # Equation
//! Density ½(1 − g²)/(1 + g² − 2gc)^(3/2); drawn as c = (1 + g² − ((1 − g²)/(1 − g + 2gξ))²)/(2g), or 2ξ − 1 at g = 0.
//!
//! # Source
//! Henyey & Greenstein, Astrophys. J. 93, 70 (1941).

use super::{BuildPhase, Phase};
use crate::random::Stream;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};

/// See the [module page](self).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HenyeyGreenstein {
    /// Mean cosine: 0 isotropic, toward 1 ever more forward.
    #[schemars(range(min = -0.999, max = 0.999))]
    pub g: f64,
}

/// Nearer to 0 than this, g makes no difference that doubles can hold.
const LEAST_G: f64 = 1e-6;

impl Phase for HenyeyGreenstein {
    fn density(&self, cosine: f64) -> f64 {
        let g = self.g;
        0.5 * (1.0 - g * g) / (1.0 + g * g - 2.0 * g * cosine).powf(1.5)
    }

    fn draw(&self, random: &mut Stream) -> f64 {
        let (g, xi) = (self.g, random.uniform());
        if g.abs() < LEAST_G {
            return 2.0 * xi - 1.0;
        }
        let root = (1.0 - g * g) / (1.0 - g + 2.0 * g * xi);
        ((1.0 + g * g - root * root) / (2.0 * g)).clamp(-1.0, 1.0)
    }

    fn henyey_greenstein(&self) -> Option<f64> {
        Some(self.g)
    }
}

/// Row of [`PHASES`](super::PHASES).
pub const KIND: Kind<BuildPhase> = Kind {
    name: "henyey_greenstein",
    summary: "One number: the mean cosine of the angle of scattering.",
    example: "[resin.phase.henyey_greenstein]\ng = 0.8\n",
    schema: schema_of::<HenyeyGreenstein>,
    build: |section| Ok(Box::new(section.parse::<HenyeyGreenstein>()?)),
};
