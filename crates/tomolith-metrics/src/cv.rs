//! Coefficient of variation of the dose in the part.
//!
//! ```text
//! CV = standard deviation of m over the part / mean of m over the part
//! ```
//!
//! (deviation of all voxels: divided by their number). None without part, or when the mean is 0.
//!
//! Part voxels 1 and 3:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::{evaluate, print::Print};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 3], 0.5);
//! let labels = Volume { grid: grid.clone(), values: vec![PART, PART, VOID] };
//! let response = Volume { grid, values: vec![1.0, 3.0, 0.5] };
//! let measures = evaluate(&Print::new(&labels, &response).unwrap()).measures;
//! assert!((measures.get("cv").unwrap() - 0.5).abs() < 1e-6); // mean 2, standard deviation 1
//! ```

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
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&DoseVariation, labels, response)
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
