//! Rayleigh's phase function for unpolarized light: particles much smaller than the wavelength.
//!
//! # Equation
//! Density ⅜(1 + c²) of the cosine c. Its distribution ½ + ⅜(c + c³/3) = ξ is the cubic c³ + 3c = 8ξ − 4, which has one
//! real root: with q = 4ξ − 2, c = ∛(√(q² + 1) + q) − ∛(√(q² + 1) − q).
//!
//! # Source
//! Bohren & Huffman, *Absorption and Scattering of Light by Small Particles*, § 5.2; root: Cardano.

use super::{BuildPhase, Phase};
use crate::random::Stream;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::kind::{Kind, schema_of};

/// See the [module page](self).
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rayleigh {}

impl Phase for Rayleigh {
    fn density(&self, cosine: f64) -> f64 {
        0.375 * (1.0 + cosine * cosine)
    }

    fn draw(&self, random: &mut Stream) -> f64 {
        let q = 4.0 * random.uniform() - 2.0;
        let root = q.hypot(1.0);
        ((root + q).cbrt() - (root - q).cbrt()).clamp(-1.0, 1.0)
    }
}

/// Row of [`PHASES`](super::PHASES).
pub const KIND: Kind<BuildPhase> = Kind {
    name: "rayleigh",
    summary: "Particles much smaller than the wavelength: as much light forwards as backwards.",
    example: "[resin.phase.rayleigh]\n",
    schema: schema_of::<Rayleigh>,
    build: |section| Ok(Box::new(section.parse::<Rayleigh>()?)),
};
