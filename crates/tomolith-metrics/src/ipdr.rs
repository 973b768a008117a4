//! In-part dose range.
//!
//! ```text
//! IPDR = max over part m − min over part m
//! ```
//!
//! None without part.
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
//! assert!((measures.get("ipdr").unwrap() - 0.6).abs() < 1e-6); // 0.9 − 0.3
//! ```

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct InPartDoseRange;

impl Metric for InPartDoseRange {
    fn measure(&self, print: &Print<'_>) -> Measure {
        let part = print.scan().part()?;
        Some(f64::from(part.max) - f64::from(part.min))
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "ipdr",
    title: "In-part dose range",
    summary: "Largest minus smallest dose in the part; small means evenly cured.",
    unit: "response",
    better: Better::Lower,
    metric: &InPartDoseRange,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&InPartDoseRange, labels, response)
    }

    #[test]
    fn is_the_range_inside_the_part() {
        assert!(near(
            measure(&[PART, PART, VOID, OUTSIDE], &[0.9, 0.7, 5.0, 9.0]),
            0.2
        ));
        assert_eq!(measure(&[VOID], &[1.0]), None);
    }
}
