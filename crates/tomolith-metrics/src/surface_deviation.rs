//! How far the print's surface is from the target's: mean, 95th percentile and largest distance.
//!
//! `surface_mean_mm` and `surface_p95_mm` are over the area of both surfaces, `hausdorff_mm` is the largest distance of
//! all, both ways; see [`surface`](super::surface). None when one of the surfaces is empty.
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::{evaluate, print::Print};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 40], 0.1);
//! let ramp = |end: f64| (0..40).map(|i| (0.5 - (grid.x(i) - end)).clamp(0.0, 1.0) as f32).collect::<Vec<_>>();
//! let inside = Volume { grid: grid.clone(), values: ramp(0.0) };
//! let response = Volume { grid: grid.clone(), values: ramp(0.1) };
//! let labels = Volume { values: inside.values.iter().map(|&s| if s >= 0.5 { PART } else { VOID }).collect(), grid };
//! let print = Print::new(&labels, &response).unwrap().with_inside(&inside).unwrap().with_threshold(0.5).unwrap();
//! let measures = evaluate(&print).measures;
//! assert!((measures.get("hausdorff_mm").unwrap() - 0.1).abs() < 1e-5); // the face that is off
//! assert!(measures.get("surface_mean_mm").unwrap() < 0.01); // nearly all of the surface is right,
//! assert!(measures.get("surface_p95_mm").unwrap() < 0.1); // more than 95 % of it
//! ```

use super::MetricKind;

/// Row of [`METRICS`](super::METRICS): the mean.
pub const MEAN: MetricKind = MetricKind::error(
    "mm",
    "surface_mean_mm",
    "Surface deviation, mean",
    "Mean distance between the print's surface and the target's.",
    |print| print.distance().map(|d| d.mean_mm),
);

/// Row of [`METRICS`](super::METRICS): the 95th percentile.
pub const P95: MetricKind = MetricKind::error(
    "mm",
    "surface_p95_mm",
    "Surface deviation, 95 %",
    "95 % of the print's and the target's surface is closer to the other one than this.",
    |print| print.distance().map(|d| d.p95_mm),
);

/// Row of [`METRICS`](super::METRICS): the largest distance.
pub const HAUSDORFF: MetricKind = MetricKind::error(
    "mm",
    "hausdorff_mm",
    "Surface deviation, largest",
    "The largest distance between the print's surface and the target's (Hausdorff).",
    |print| print.distance().map(|d| d.hausdorff_mm),
);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::Print;
    use crate::print::samples::{measured, row};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn a_print_that_is_the_part_is_nowhere_off_and_none_has_no_distance() {
        for row in [MEAN, P95, HAUSDORFF] {
            let labels = [VOID, PART, PART, VOID, OUTSIDE];
            let right = measured(row.measure, &labels, &[0.0, 1.0, 1.0, 0.0, 0.0]);
            assert!(right.unwrap().abs() < 1e-6, "{}", row.name);
            assert_eq!(measured(row.measure, &[VOID, PART], &[0.0, 0.0]), None);
            assert_eq!(measured(row.measure, &[VOID], &[1.0]), None);
        }
    }

    #[test]
    fn distances_that_are_left_out_are_not_measured() {
        let (labels, response) = (row(&[VOID, PART]), row(&[0.0, 1.0]));
        let print = || Print::new(&labels, &response).unwrap();
        assert!((MEAN.measure)(&print()).is_some());
        assert_eq!((MEAN.measure)(&print().without_distance()), None);
    }

    #[test]
    fn a_missing_voxel_is_seen_by_each_and_the_largest_is_the_largest() {
        let (labels, response) = ([PART, PART, PART, VOID], [1.0, 1.0, 0.2, 0.4]);
        let [mean, p95, largest] =
            [MEAN, P95, HAUSDORFF].map(|row| measured(row.measure, &labels, &response).unwrap());
        // The pitch is 0.5 mm
        assert!(0.1 < mean && mean < p95 && p95 <= largest && largest < 0.7);
    }
}
