//! Coefficient of variation of the dose in the part.
//!
//! ```text
//! CV = standard deviation of m over the part / mean of m over the part
//! ```
//!
//! (deviation of all voxels: divided by their number). None without part, or when the mean is 0.

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct DoseVariation;

impl Metric for DoseVariation {
    fn measure(&self, print: &Print<'_>) -> Measure {
        let part = print.scan().part()?;
        (part.mean != 0.0).then(|| part.deviation / part.mean)
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "cv",
    title: "Dose variation",
    summary: "Standard deviation of the dose inside the part, divided by its mean; small means evenly cured.",
    unit: "",
    better: Better::Lower,
    metric: &DoseVariation,
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
        DoseVariation.measure(&Print::new(&labels, &response).unwrap())
    }

    fn near(found: Measure, expected: f64) -> bool {
        found.is_some_and(|found| (found - expected).abs() < 1e-6)
    }

    #[test]
    fn is_deviation_over_mean() {
        // 1 and 3: mean 2, deviation 1
        assert!(near(
            measure(&[PART, PART, VOID, OUTSIDE], &[1.0, 3.0, 9.0, 9.0]),
            0.5
        ));
        assert_eq!(measure(&[PART], &[0.0]), None);
        assert_eq!(measure(&[VOID], &[1.0]), None);
    }
}
