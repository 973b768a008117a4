//! How a path segment leaves its energy in voxels: the exact integral, or random points.
//!
//! The random ones are those of Nicolet et al. 2024, § 4.3, with the weights that make their means right. They are there for
//! comparison: the integral has their mean and no variance.
//!
//! | kind | points of a segment of power P | energy of a point |
//! |---|---|---|
//! | `simple` | at most one, at a free path t of μ_t | P·μ_a/μ_t |
//! | `ratio` | at steps of free paths of the majorant μ̄ | P·(μ_a/μ̄)·(1 − μ_t/μ̄)^(points before) |
//!
//! (The article's `accumulate_simple` leaves P·μ_a·e^(−μ_t·t): its mean along the segment is μ_a·μ_t·e^(−2μ_t·t) and not μ_a·e^(−μ_t·t), as it
//! does not divide by the density of t.)

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_optics::projector::Ray;
use tomolith_optics::random::Stream;
use tomolith_optics::space::PathSegment;

/// How energy is accumulated along a leg.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Accumulation {
    /// The exact integral in every voxel.
    #[default]
    Integral,
    /// Random points, denser than the resin's free paths.
    Ratio {
        /// Points per mm, at least the attenuation of the resin.
        majorant_per_mm: f64,
    },
    /// One random point, where light is taken.
    Simple,
}

/// Length of a point in mm: far below any voxel.
const POINT_MM: f64 = 1e-5;

impl Accumulation {
    /// What is wrong with it in a resin of this attenuation; None when nothing is.
    pub(crate) fn trouble(self, attenuation: f64) -> Option<String> {
        match self {
            Accumulation::Integral => None,
            _ if attenuation <= 0.0 => {
                Some("random accumulators need a resin that attenuates".into())
            }
            Accumulation::Ratio { majorant_per_mm }
                if majorant_per_mm.is_nan() || majorant_per_mm < attenuation =>
            {
                Some(format!(
                    "a majorant of {majorant_per_mm} per mm, below the attenuation of {attenuation} per mm"
                ))
            }
            _ => None,
        }
    }

    /// Calls `visit` with the segment, or with a short one for every point.
    pub(super) fn for_each(
        self,
        segment: PathSegment,
        random: impl FnOnce() -> Stream,
        mut visit: impl FnMut(PathSegment),
    ) {
        let attenuation = segment.uptake.attenuation_per_mm;
        // What a segment of the length of a point leaves of its power in the resin
        let taken = -(-attenuation * POINT_MM).exp_m1();
        let point = |at: f64, part: f64| PathSegment {
            ray: Ray {
                from: segment.ray.at(at - POINT_MM / 2.0),
                ..segment.ray
            },
            length: POINT_MM,
            power: part * segment.power / taken,
            ..segment
        };
        let free = |random: &mut Stream, mu: f64| -(-random.uniform()).ln_1p() / mu;
        match self {
            Accumulation::Integral => visit(segment),
            Accumulation::Simple => {
                let at = free(&mut random(), attenuation);
                if at < segment.length {
                    visit(point(at, 1.0));
                }
            }
            Accumulation::Ratio { majorant_per_mm } => {
                let mut random = random();
                let share = attenuation / majorant_per_mm;
                let (mut at, mut left) = (free(&mut random, majorant_per_mm), 1.0);
                while at < segment.length {
                    visit(point(at, left * share));
                    left *= 1.0 - share;
                    at += free(&mut random, majorant_per_mm);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;
    use tomolith_optics::resin::Uptake;

    #[test]
    fn points_take_on_average_what_the_integral_takes() {
        let segment = PathSegment {
            ray: Ray::new([0.0; 3], [1.0, 0.0, 0.0]),
            length: 5.0,
            power: 2.0,
            order: 0,
            uptake: Uptake {
                attenuation_per_mm: 0.4,
                active_per_mm: 0.4,
            },
        };
        let mu = segment.uptake.attenuation_per_mm;
        // Energy below and above 2 mm, of power 2: 2(1 − e^−0.8) and 2(e^−0.8 − e^−2)
        let exact = [
            2.0 * (1.0 - (-0.8f64).exp()),
            2.0 * ((-0.8f64).exp() - (-2.0f64).exp()),
        ];
        let taken = -(-mu * POINT_MM).exp_m1();
        let spread = |kind: Accumulation| {
            const DRAWS: u64 = 40_000;
            let (mut sums, mut squares) = ([0.0; 2], [0.0; 2]);
            for i in 0..DRAWS {
                let mut draw = [0.0; 2];
                kind.for_each(
                    segment,
                    || Stream::new([7, i, 0, 0]),
                    |piece| {
                        draw[usize::from(piece.ray.from[0] > 2.0)] += piece.power * taken;
                    },
                );
                for k in 0..2 {
                    sums[k] += draw[k] / DRAWS as f64;
                    squares[k] += draw[k] * draw[k] / DRAWS as f64;
                }
            }
            let deviation = |k: usize| (squares[k] - sums[k] * sums[k]).sqrt();
            let error = 4.0 / (DRAWS as f64).sqrt();
            for k in 0..2 {
                let allowed = error * deviation(k);
                near!(sums[k], exact[k], allowed, "{kind:?}: {sums:?} {exact:?}");
            }
            deviation(0)
        };
        let simple = spread(Accumulation::Simple);
        let [few, many] =
            [1.0, 40.0].map(|majorant_per_mm| spread(Accumulation::Ratio { majorant_per_mm }));
        assert!(many < 0.3 * few && few < simple, "{simple} {few} {many}");
    }
}
