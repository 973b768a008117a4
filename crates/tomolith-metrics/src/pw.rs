//! Process window.
//!
//! ```text
//! PW = min over part m − max over void m
//! ```
//!
//! Positive: a range of thresholds prints the part without error. (Some authors use the opposite sign.) None without
//! part or without void.
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
//! assert!((measures.get("pw").unwrap() - -0.2).abs() < 1e-6); // 0.3 − 0.5: part and void overlap
//! ```

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct ProcessWindow;

impl Metric for ProcessWindow {
    fn measure(&self, print: &Print<'_>) -> Measure {
        let scan = print.scan();
        let (part, void) = (scan.part()?, scan.void()?);
        // Without dose there is nothing to tell apart
        let is_dark = part.max <= 0.0 && void.max <= 0.0;
        (!is_dark).then(|| f64::from(part.min) - f64::from(void.max))
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "pw",
    title: "Process window PW",
    summary: "Smallest dose in the part minus largest dose in the void; below 0 they overlap.",
    unit: "response",
    better: Better::Higher,
    metric: &ProcessWindow,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&ProcessWindow, labels, response)
    }

    #[test]
    fn is_the_gap_with_its_sign() {
        assert!(near(
            measure(&[PART, PART, VOID, OUTSIDE], &[0.9, 0.7, 0.4, 3.0]),
            0.3
        ));
        assert!(near(measure(&[PART, PART, VOID], &[0.9, 0.3, 0.4]), -0.1));
        assert_eq!(measure(&[PART], &[1.0]), None);
        assert_eq!(measure(&[VOID], &[1.0]), None);
    }
}
