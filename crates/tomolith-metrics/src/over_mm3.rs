//! Overcured volume: void voxels above the gel threshold, mm³.
//!
//! None without any voxel that counts; 0 when nothing is printed.
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
//! assert!((measures.get("over_mm3").unwrap() - 0.125).abs() < 1e-6); // at the threshold 0.2 one void voxel of (0.5 mm)³ gels
//! ```

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct Overcured;

impl Metric for Overcured {
    fn measure(&self, print: &Print<'_>) -> Measure {
        let [part, void] = print.scan().totals();
        (part + void > 0).then(|| print.printed()[1] as f64 * print.grid().voxel_mm3())
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "over_mm3",
    title: "Overcured volume",
    summary: "Volume that gels though it should stay liquid.",
    unit: "mm³",
    better: Better::Lower,
    metric: &Overcured,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&Overcured, labels, response)
    }

    #[test]
    fn counts_gelled_void() {
        // Best threshold in [0.3, 0.5): both part voxels, one void voxel, of 0.125 mm³
        assert!(near(
            measure(
                &[PART, PART, VOID, VOID, OUTSIDE],
                &[0.9, 0.5, 0.6, 0.3, 9.0]
            ),
            0.125
        ));
        assert_eq!(measure(&[PART, VOID], &[0.0, 0.0]), Some(0.0));
        assert_eq!(measure(&[OUTSIDE], &[1.0]), None);
    }
}
