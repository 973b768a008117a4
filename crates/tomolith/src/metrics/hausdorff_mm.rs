//! Hausdorff distance between the print's surface and the target's, mm; see [`surface`](super::surface).
//!
//! None when one of them is empty.

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct Hausdorff;

impl Metric for Hausdorff {
    fn measure(&self, print: &Print<'_>) -> Measure {
        Some(print.distance()?.hausdorff_mm)
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "hausdorff_mm",
    title: "Surface deviation, largest",
    summary: "The largest distance between the print's surface and the target's (Hausdorff).",
    unit: "mm",
    better: Better::Lower,
    metric: &Hausdorff,
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
        Hausdorff.measure(&Print::new(&labels, &response).unwrap())
    }

    fn near(found: Measure, expected: f64) -> bool {
        found.is_some_and(|found| (found - expected).abs() < 1e-6)
    }

    #[test]
    fn of_a_print_that_is_the_part_is_zero_and_of_none_is_none() {
        let (labels, response) = ([VOID, PART, PART, VOID, OUTSIDE], [0.0, 1.0, 1.0, 0.0, 0.0]);
        assert!(near(measure(&labels, &response), 0.0));
        assert_eq!(measure(&[VOID, PART], &[0.0, 0.0]), None);
        assert_eq!(measure(&[VOID], &[1.0]), None);
    }

    #[test]
    fn of_a_missing_voxel_is_positive() {
        let (labels, response) = ([PART, PART, PART, VOID], [1.0, 1.0, 0.2, 0.4]);
        let found = measure(&labels, &response).unwrap();
        assert!(found > 0.3 && found < 0.7, "{found}"); // the pitch is 0.5 mm
    }
}
