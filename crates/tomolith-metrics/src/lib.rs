//! Metrics: one number of the report a file, or a few that one pass gives.
//!
//! *What must it do, and who does it.* A metric turns a predicted [`Print`] into one number, or into none where it
//! is not defined (no part, no print): never into a number that is not finite. The table [`METRICS`] holds them all, in
//! the order of the report; `report.json` uses their names. [`evaluation`] applies the table.
//!
//! Part voxels 0.9, 0.8 and 0.3, void voxels 0.5 and 0.1, each of (0.5 mm)³:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_core::target::label::{PART, VOID};
//! use tomolith_metrics::{evaluate, print::Print};
//! let grid = VolumeGrid::centered([1, 1, 5], 0.5);
//! let labels = Volume { grid: grid.clone(), values: vec![PART, PART, PART, VOID, VOID] };
//! let response = Volume { grid, values: vec![0.9, 0.8, 0.3, 0.5, 0.1] };
//! let measures = evaluate(&Print::new(&labels, &response).unwrap()).measures;
//! for (name, expected) in [
//!     ("iou", 0.75), // a threshold from 0.1 to 0.3: three part voxels, and one of the void
//!     ("best_threshold", 0.2), // the middle of 0.1 to 0.3; from 0.5 to 0.8 the IoU is 2/3
//!     ("ver", 0.2), // one of five voxels is in the void and above 0.3, the weakest of the part
//!     ("pw", -0.2), // 0.3 − 0.5: part and void overlap
//!     ("ipdr", 0.6), // 0.9 − 0.3
//!     ("gamma", 20.0), // IoU is above 0.95·3/4 from 0.1 to 0.3 only: 20 % of 0…1
//!     ("over_mm3", 0.125), // at the threshold 0.2 one void voxel gels,
//!     ("under_mm3", 0.0), // and no part voxel stays liquid
//! ] {
//!     assert!((measures.get(name).unwrap() - expected).abs() < 1e-5, "{name}");
//! }
//! ```

use print::Print;

pub mod best_threshold;
mod buckets;
pub mod cv;
pub mod error_histogram;
pub mod eta;
pub mod evaluation;
pub mod gamma;
pub mod gray;
pub mod iou;
pub mod ipdr;
pub mod isosurface;
pub mod latitude;
pub mod nearest;
pub mod over_mm3;
pub mod print;
pub mod published;
pub mod pw;
pub mod quick;
pub mod scan;
pub mod spread;
pub mod surface;
pub mod surface_deviation;
pub mod time;
pub mod under_mm3;
pub mod ver;

pub use evaluation::{Evaluation, Measures, evaluate};
pub use published::{Published, published};

/// A number, or none where it is not defined.
pub type Measure = Option<f64>;

/// Whether larger or smaller values of a metric are better.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Better {
    /// The larger, the better.
    Higher,
    /// The smaller, the better.
    Lower,
    /// Neither.
    Neutral,
}

/// A row of [`METRICS`].
pub struct MetricKind {
    /// Its name in `report.json`.
    pub name: &'static str,
    /// Its name for people.
    pub title: &'static str,
    /// One sentence in plain words.
    pub summary: &'static str,
    /// Its unit, empty for a plain number.
    pub unit: &'static str,
    /// Which way it is better.
    pub better: Better,
    /// Measures a print.
    pub measure: fn(&Print<'_>) -> Measure,
}

/// Every metric, in the order of the report.
pub static METRICS: &[MetricKind] = &[
    iou::KIND,
    best_threshold::KIND,
    ver::KIND,
    pw::KIND,
    ipdr::KIND,
    gamma::KIND,
    eta::KIND,
    time::KIND,
    cv::KIND,
    over_mm3::KIND,
    under_mm3::KIND,
    surface_deviation::MEAN,
    surface_deviation::P95,
    surface_deviation::HAUSDORFF,
    gray::IN_BAND,
    gray::RMS,
    gray::MAX_PART,
    gray::MAX_VOID,
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::measured;
    use tomolith_core::target::label::{OUTSIDE as O, PART as P, VOID as V};

    #[test]
    fn every_definition_by_hand() {
        type Row = (
            MetricKind,
            &'static [u8],
            &'static [f32],
            Option<f64>,
            &'static str,
        );
        let rows: [Row; 30] = [
            (
                iou::KIND,
                &[P, P, P, V, V, O],
                &[0.9, 0.8, 0.3, 0.5, 0.1, 2.0],
                Some(0.75),
                "three of 3 + 1, from 0.1 on",
            ),
            (iou::KIND, &[V, V], &[0.1, 0.2], None, "no part"),
            (iou::KIND, &[V, P], &[0.0, 0.0], Some(0.0), "no print"),
            (iou::KIND, &[], &[], None, "nothing"),
            (
                best_threshold::KIND,
                &[V, P, O],
                &[0.4, 0.9, 0.6],
                Some(0.65),
                "the middle of the gap",
            ),
            (best_threshold::KIND, &[P], &[0.8], Some(0.4), "from 0 on"),
            (best_threshold::KIND, &[V], &[0.8], None, "no part"),
            (
                ver::KIND,
                &[P, P, V, V, V, O],
                &[0.5, 0.9, 0.6, 0.5, 0.1, 0.9],
                Some(0.2),
                "0.5 is the weakest; 0.6 is wrong, an equal 0.5 is not",
            ),
            (ver::KIND, &[P], &[1.0], Some(0.0), "no void"),
            (ver::KIND, &[V], &[1.0], None, "no part"),
            (
                ipdr::KIND,
                &[P, P, V, O],
                &[0.9, 0.7, 5.0, 9.0],
                Some(0.2),
                "inside the part",
            ),
            (ipdr::KIND, &[V], &[1.0], None, "no part"),
            (
                pw::KIND,
                &[P, P, V, O],
                &[0.9, 0.7, 0.4, 3.0],
                Some(0.3),
                "a gap",
            ),
            (
                pw::KIND,
                &[P, P, V],
                &[0.9, 0.3, 0.4],
                Some(-0.1),
                "an overlap",
            ),
            (pw::KIND, &[P], &[1.0], None, "no void"),
            (pw::KIND, &[V], &[1.0], None, "no part"),
            (
                cv::KIND,
                &[P, P, V, O],
                &[1.0, 3.0, 9.0, 9.0],
                Some(0.5),
                "mean 2, deviation 1",
            ),
            (cv::KIND, &[P], &[0.0], None, "a mean of 0"),
            (cv::KIND, &[V], &[1.0], None, "no part"),
            (
                gamma::KIND,
                &[V, P],
                &[0.375, 0.875],
                Some(50.0),
                "from 0.375 to 0.875",
            ),
            (
                gamma::KIND,
                &[V, P],
                &[0.375, 7.0],
                Some(62.5),
                "the scale ends at 1",
            ),
            (gamma::KIND, &[V], &[1.0], None, "no part"),
            (gamma::KIND, &[V, P], &[0.0, 0.0], None, "no print"),
            (
                over_mm3::KIND,
                &[P, P, V, V, O],
                &[0.9, 0.5, 0.6, 0.3, 9.0],
                Some(0.125),
                "a threshold in [0.3, 0.5) prints both and one of the void",
            ),
            (over_mm3::KIND, &[P, V], &[0.0, 0.0], Some(0.0), "no print"),
            (over_mm3::KIND, &[O], &[1.0], None, "no voxel that counts"),
            (
                under_mm3::KIND,
                &[P, P, P, V, V, V, O],
                &[0.9, 0.8, 0.1, 0.3, 0.3, 0.2, 0.0],
                Some(0.125),
                "the weak voxel is lost rather than three of the void printed",
            ),
            (
                under_mm3::KIND,
                &[P, P, V, V, V],
                &[0.9, 0.2, 0.5, 0.4, 0.3],
                Some(0.125),
                "a threshold from 0.5 to 0.9",
            ),
            (
                under_mm3::KIND,
                &[P, V],
                &[0.0, 0.0],
                Some(0.125),
                "no print",
            ),
            (under_mm3::KIND, &[O], &[1.0], None, "no voxel that counts"),
        ];
        for (kind, labels, response, expected, why) in rows {
            let found = measured(kind.measure, labels, response);
            let is_near = match (found, expected) {
                (Some(found), Some(expected)) => (found - expected).abs() < 1e-6,
                (found, expected) => found == expected,
            };
            assert!(is_near, "{}, {why}: {found:?}", kind.name);
        }
    }
}
