//! Undercured volume: part voxels that are not above the gel threshold, mm³.
//!
//! None without any voxel that counts; the whole part when nothing is printed.
//!
//! Part voxels 0.9 and 0.2, void voxels 0.5, 0.4 and 0.3:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::{evaluate, print::Print};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 5], 0.5);
//! let labels = Volume { grid: grid.clone(), values: vec![PART, PART, VOID, VOID, VOID] };
//! let response = Volume { grid, values: vec![0.9, 0.2, 0.5, 0.4, 0.3] };
//! let measures = evaluate(&Print::new(&labels, &response).unwrap()).measures;
//! assert!((measures.get("under_mm3").unwrap() - 0.125).abs() < 1e-6); // the best threshold lies between 0.5 and 0.9: one part voxel of (0.5 mm)³ stays liquid
//! ```

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct Undercured;

impl Metric for Undercured {
    fn measure(&self, print: &Print<'_>) -> Measure {
        let [part, void] = print.scan().totals();
        (part + void > 0).then(|| (part - print.printed()[0]) as f64 * print.grid().voxel_mm3())
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "under_mm3",
    title: "Undercured volume",
    summary: "Volume of the part that stays liquid.",
    unit: "mm³",
    better: Better::Lower,
    metric: &Undercured,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&Undercured, labels, response)
    }

    #[test]
    fn counts_liquid_part() {
        // The best threshold loses the weak voxel rather than three of the void
        let (labels, response) = (
            [PART, PART, PART, VOID, VOID, VOID, OUTSIDE],
            [0.9, 0.8, 0.1, 0.3, 0.3, 0.2, 0.0],
        );
        assert!(near(measure(&labels, &response), 0.125));
        assert!(near(measure(&[PART, VOID], &[0.0, 0.0]), 0.125));
        assert_eq!(measure(&[OUTSIDE], &[1.0]), None);
    }
}
