//! Intersection over union of the print with the part.
//!
//! ```text
//! IoU(t) = #{part: m > t} / (#part + #{void: m > t})
//! ```
//!
//! at the gel threshold: the best one over all thresholds ([`scan`](super::scan)), or the given one. None without part;
//! 0 when no threshold prints any of it.
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
//! assert!((measures.get("iou").unwrap() - 0.75).abs() < 1e-6); // a threshold from 0.1 to 0.3: three part voxels, and one of the void
//! ```

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct Iou;

impl Metric for Iou {
    fn measure(&self, print: &Print<'_>) -> Measure {
        let scan = print.scan();
        scan.part()?;
        match (print.gel_threshold(), print.best()) {
            (None, _) => Some(0.0),
            (Some(threshold), Some(best)) if threshold == best.middle() => Some(best.iou),
            (Some(threshold), _) => scan.iou_at(threshold),
        }
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "iou",
    title: "IoU",
    summary: "Volume in both print and part, divided by the volume in either; 1 is a perfect print.",
    unit: "",
    better: Better::Higher,
    metric: &Iou,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::grid::{Volume, VolumeGrid};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&Iou, labels, response)
    }

    #[test]
    fn of_the_best_and_of_a_given_threshold() {
        let (labels, response) = (
            [PART, PART, PART, VOID, VOID, OUTSIDE],
            [0.9, 0.8, 0.3, 0.5, 0.1, 2.0],
        );
        // t in [0.5, 0.8): two of three; t in [0.1, 0.3): three of 3 + 1: the best
        assert!(near(measure(&labels, &response), 0.75));
        let grid = VolumeGrid::centered([1, 1, 6], 0.5);
        let labels = Volume {
            grid: grid.clone(),
            values: labels.to_vec(),
        };
        let response = Volume {
            grid,
            values: response.to_vec(),
        };
        let print = Print::new(&labels, &response)
            .unwrap()
            .with_threshold(0.6)
            .unwrap();
        assert!(near(Iou.measure(&print), 2.0 / 3.0));
    }

    #[test]
    fn without_part_there_is_none_and_without_print_it_is_zero() {
        assert_eq!(measure(&[VOID, VOID], &[0.1, 0.2]), None);
        assert_eq!(measure(&[VOID, PART], &[0.0, 0.0]), Some(0.0));
        assert_eq!(measure(&[], &[]), None);
    }
}
