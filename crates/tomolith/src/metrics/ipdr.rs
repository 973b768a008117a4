//! In-part dose range.
//!
//! ```text
//! IPDR = max over part m − min over part m
//! ```
//!
//! None without part.

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
    summary: "Spread of the dose inside the part: strongest minus weakest voxel; small means evenly cured.",
    unit: "response",
    better: Better::Lower,
    metric: &InPartDoseRange,
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
        InPartDoseRange.measure(&Print::new(&labels, &response).unwrap())
    }

    fn near(found: Measure, expected: f64) -> bool {
        found.is_some_and(|found| (found - expected).abs() < 1e-6)
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
