//! Phase functions: where scattered light goes.
//!
//! *What must it do, and who does it.* A phase function is a density of the cosine between the old and the new direction
//! (its integral over −1…1 is 1; all azimuths are alike), and a way to draw from it.

pub mod henyey_greenstein;
pub mod isotropic;
pub mod mixture;
pub mod rayleigh;
pub mod table;

use crate::random::Stream;
use std::sync::Arc;
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section};

/// Where scattered light goes.
pub trait Phase: std::fmt::Debug + Send + Sync {
    /// Density of the cosine, −1…1.
    fn density(&self, cosine: f64) -> f64;

    /// Draws a cosine.
    fn draw(&self, random: &mut Stream) -> f64;

    /// Its mean cosine, where it is Henyey and Greenstein's (0: isotropic): a backend that draws by itself has their formula.
    fn henyey_greenstein(&self) -> Option<f64> {
        None
    }
}

/// What scatters in a resin.
#[derive(Clone, Debug)]
pub struct Scattering {
    /// Napierian scattering μ_s, 1/mm; part of the total attenuation.
    pub per_mm: f64,
    /// Where it sends light.
    pub phase: Arc<dyn Phase>,
}

impl Scattering {
    /// So much light, 1/mm, sent where the phase function says.
    #[must_use]
    pub fn new(per_mm: f64, phase: impl Phase + 'static) -> Self {
        let phase = Arc::new(phase);
        Scattering { per_mm, phase }
    }
}

/// Builds a phase function from its section.
pub type BuildPhase = fn(&Section) -> Result<Box<dyn Phase>>;

/// Every phase function; the first is the default.
pub static PHASES: &[Kind<BuildPhase>] = &[
    rayleigh::KIND,
    isotropic::KIND,
    henyey_greenstein::KIND,
    table::KIND,
    mixture::KIND,
];

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::example;
    use tomolith_core::near;

    /// Bins of equal width in the cosine.
    const BINS: usize = 50;
    const DRAWS: u64 = 200_000;

    /// Probability of a bin, by Simpson's rule on sixteen pieces.
    fn probability(phase: &dyn Phase, bin: usize) -> f64 {
        let width = 2.0 / BINS as f64;
        let low = -1.0 + bin as f64 * width;
        let h = width / 32.0;
        (0..=32)
            .map(|i| {
                let weight = match i {
                    0 | 32 => 1.0,
                    i if i % 2 == 1 => 4.0,
                    _ => 2.0,
                };
                weight * phase.density(low + f64::from(i) * h)
            })
            .sum::<f64>()
            * h
            / 3.0
    }

    #[test]
    fn every_example_integrates_to_one_and_draws_what_its_density_says() {
        for kind in PHASES {
            let phase = (kind.build)(&example(kind)).unwrap();
            let expected: Vec<f64> = (0..BINS)
                .map(|bin| probability(phase.as_ref(), bin))
                .collect();
            near!(expected.iter().sum::<f64>(), 1.0, 1e-4, "{}", kind.name);
            let mut counts = [0.0; BINS];
            for i in 0..DRAWS {
                let cosine = phase.draw(&mut Stream::new([5, 0, i, 0]));
                assert!((-1.0..=1.0).contains(&cosine), "{}: {cosine}", kind.name);
                counts[(((cosine + 1.0) * 0.5 * BINS as f64) as usize).min(BINS - 1)] += 1.0;
            }
            // χ² of bins with at least ten draws: mean is their number, standard deviation √(2·number)
            let (mut chi, mut bins) = (0.0, 0.0);
            for (count, p) in counts.iter().zip(&expected) {
                let mean = p * DRAWS as f64;
                if mean >= 10.0 {
                    chi += (count - mean) * (count - mean) / mean;
                    bins += 1.0;
                }
            }
            assert!(
                chi < bins + 4.0 * (2.0f64 * bins).sqrt(),
                "{}: {chi} of {bins}",
                kind.name
            );
        }
    }
}
