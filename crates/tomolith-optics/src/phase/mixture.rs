//! Several phase functions at once, each with its share.

use super::{BuildPhase, PHASES, Phase};
use crate::random::Stream;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section, schema_of};

/// See the [module page](self).
#[derive(Debug)]
pub struct Mixture(Vec<(f64, Box<dyn Phase>)>);

impl Phase for Mixture {
    fn density(&self, cosine: f64) -> f64 {
        self.0
            .iter()
            .map(|(share, phase)| share * phase.density(cosine))
            .sum()
    }

    fn draw(&self, random: &mut Stream) -> f64 {
        let mut left = random.uniform();
        let last = self.0.len() - 1;
        for (share, phase) in &self.0[..last] {
            if left < *share {
                return phase.draw(random);
            }
            left -= share;
        }
        self.0[last].1.draw(random)
    }
}

/// Keys of `[resin.phase.mixture]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// The phase functions with their shares, one or more: `{ share = 0.7, phase = { rayleigh = {} } }`.
    pub parts: Vec<Part>,
}

/// One phase function of a mixture.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Its share of the scattered light; shares are scaled to a sum of 1.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub share: f64,
    /// The phase function, one kind.
    pub phase: Value,
}

/// Row of [`PHASES`].
pub const KIND: Kind<BuildPhase> = Kind {
    name: "mixture",
    summary: "Several phase functions, each with its share.",
    example: "[resin.phase.mixture]\nparts = [{ share = 0.7, phase = { rayleigh = {} } }, { share = 0.3, phase = { henyey_greenstein = { g = 0.9 } } }]\n",
    schema: schema_of::<Params>,
    build,
};

fn build(section: &Section) -> Result<Box<dyn Phase>> {
    let params: Params = section.parse()?;
    if params.parts.is_empty() {
        return Err(section.refused("parts", "none", "one or more"));
    }
    let total: f64 = params.parts.iter().map(|part| part.share).sum();
    let mut parts = Vec::with_capacity(params.parts.len());
    for (i, part) in params.parts.into_iter().enumerate() {
        let inner = Section::new(format!("{}.parts[{i}].phase", section.path), part.phase);
        parts.push((part.share / total, inner.read(PHASES)?));
    }
    Ok(Box::new(Mixture(parts)))
}
