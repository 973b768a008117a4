//! The gel threshold of the best IoU.
//!
//! The middle of the longest interval of thresholds t over which {m > t} has the best IoU; thresholds start at 0 (or at
//! the smallest response, when that is negative). None without part, or when no threshold prints any of it.

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct BestThreshold;

impl Metric for BestThreshold {
    fn measure(&self, print: &Print<'_>) -> Measure {
        print.best().map(|best| best.middle())
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "best_threshold",
    title: "Best threshold",
    summary: "The gel threshold at which print and part overlap best (the middle of all that are equally good).",
    unit: "response",
    better: Better::Neutral,
    metric: &BestThreshold,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Volume, VolumeGrid};
    use crate::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        let grid = VolumeGrid::centered([1, 1, labels.len()], 0.5);
        let labels = Volume {
            grid: grid.clone(),
            values: labels.to_vec(),
        };
        let response = Volume {
            grid,
            values: response.to_vec(),
        };
        BestThreshold.measure(&Print::new(&labels, &response).unwrap())
    }

    fn near(found: Measure, expected: f64) -> bool {
        found.is_some_and(|found| (found - expected).abs() < 1e-6)
    }

    #[test]
    fn is_the_middle_of_the_gap() {
        assert!(near(
            measure(&[VOID, PART, OUTSIDE], &[0.4, 0.9, 0.6]),
            0.65
        ));
        assert!(near(measure(&[PART], &[0.8]), 0.4)); // from 0 on
        assert_eq!(measure(&[VOID], &[0.8]), None);
    }
}
