//! Voxel error rate.
//!
//! ```text
//! VER = #{void: m > min over part m} / (#part + #void)
//! ```
//!
//! (Other authors count m ≥ min.) None without part.
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
//! assert!((measures.get("ver").unwrap() - 0.2).abs() < 1e-6); // one void voxel of five voxels is above 0.3, the weakest of the part
//! ```

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct Ver;

impl Metric for Ver {
    fn measure(&self, print: &Print<'_>) -> Measure {
        let scan = print.scan();
        let part = scan.part()?;
        // Without dose nothing gels at any threshold
        if part.max <= 0.0 {
            return None;
        }
        let smallest = part.min;
        let [part, void] = scan.totals();
        let wrong = scan.count_above(f64::from(smallest))[1];
        Some(wrong as f64 / (part + void) as f64)
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "ver",
    title: "Voxel error rate",
    summary: "Share of the voxels that gel wrongly once the last voxel of the part has gelled.",
    unit: "",
    better: Better::Lower,
    metric: &Ver,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&Ver, labels, response)
    }

    #[test]
    fn counts_void_above_the_weakest_part_voxel() {
        let labels = [PART, PART, VOID, VOID, VOID, OUTSIDE];
        // 0.5 is the weakest; 0.6 is wrong, an equal 0.5 is not
        assert!(near(measure(&labels, &[0.5, 0.9, 0.6, 0.5, 0.1, 0.9]), 0.2));
        assert_eq!(measure(&[PART], &[1.0]), Some(0.0));
        assert_eq!(measure(&[VOID], &[1.0]), None);
    }
}
