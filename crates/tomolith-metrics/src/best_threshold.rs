//! The gel threshold of the best IoU.
//!
//! The middle of the longest interval of thresholds t over which {m > t} has the best IoU; thresholds start at 0 (or at
//! the smallest response, when that is negative). None without part, or when no threshold prints any of it.
//!
//! Part voxels 0.9, 0.8 and 0.3, void voxels 0.5 and 0.1:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::{evaluate, print::Print};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 5], 0.5);
//! let labels = Volume { grid: grid.clone(), values: vec![PART, PART, PART, VOID, VOID] };
//! let response = Volume { grid, values: vec![0.9, 0.8, 0.3, 0.5, 0.1] };
//! let measures = evaluate(&Print::new(&labels, &response).unwrap()).measures;
//! assert!((measures.get("best_threshold").unwrap() - 0.2).abs() < 1e-6); // the middle of 0.1 to 0.3, where IoU is 3/4; from 0.5 to 0.8 it is 2/3
//! ```

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
    summary: "The gel threshold with the best IoU (the middle of all equally good ones).",
    unit: "response",
    better: Better::Neutral,
    metric: &BestThreshold,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&BestThreshold, labels, response)
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
