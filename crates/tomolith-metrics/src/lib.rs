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
pub use published::Published;

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

impl MetricKind {
    /// A row of an error, the smaller the better.
    const fn error(
        unit: &'static str,
        name: &'static str,
        title: &'static str,
        summary: &'static str,
        measure: fn(&Print<'_>) -> Measure,
    ) -> Self {
        MetricKind {
            name,
            title,
            summary,
            unit,
            better: Better::Lower,
            measure,
        }
    }
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
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    /// Metric, voxels as label (part, void or outside) and response, value, and why.
    const BY_HAND: &str = "
iou | P0.9 P0.8 P0.3 V0.5 V0.1 O2 | 0.75 | three of 3 + 1, from 0.1 on
iou | V0.1 V0.2 | none | no part
iou | V0 P0 | 0 | no print
iou | | none | nothing
best_threshold | V0.4 P0.9 O0.6 | 0.65 | the middle of the gap
best_threshold | P0.8 | 0.4 | from 0 on
best_threshold | V0.8 | none | no part
ver | P0.5 P0.9 V0.6 V0.5 V0.1 O0.9 | 0.2 | 0.5 is the weakest; 0.6 is wrong, an equal 0.5 is not
ver | P1 | 0 | no void
ver | V1 | none | no part
ipdr | P0.9 P0.7 V5 O9 | 0.2 | inside the part
ipdr | V1 | none | no part
pw | P0.9 P0.7 V0.4 O3 | 0.3 | a gap
pw | P0.9 P0.3 V0.4 | -0.1 | an overlap
pw | P1 | none | no void
pw | V1 | none | no part
cv | P1 P3 V9 O9 | 0.5 | mean 2, deviation 1
cv | P0 | none | a mean of 0
cv | V1 | none | no part
gamma | V0.375 P0.875 | 50 | from 0.375 to 0.875
gamma | V0.375 P7 | 62.5 | the scale ends at 1
gamma | V1 | none | no part
gamma | V0 P0 | none | no print
over_mm3 | P0.9 P0.5 V0.6 V0.3 O9 | 0.125 | a threshold in [0.3, 0.5) prints both and one of the void
over_mm3 | P0 V0 | 0 | no print
over_mm3 | O1 | none | no voxel that counts
under_mm3 | P0.9 P0.8 P0.1 V0.3 V0.3 V0.2 O0 | 0.125 | the weak one is lost rather than three of the void printed
under_mm3 | P0.9 P0.2 V0.5 V0.4 V0.3 | 0.125 | a threshold from 0.5 to 0.9
under_mm3 | P0 V0 | 0.125 | no print
under_mm3 | O1 | none | no voxel that counts
";

    #[test]
    fn every_definition_by_hand() {
        for row in BY_HAND.trim().lines() {
            let columns: Vec<&str> = row.split('|').map(str::trim).collect();
            let [name, voxels, expected, _] = columns[..] else {
                panic!("{row}")
            };
            let kind = METRICS.iter().find(|kind| kind.name == name).unwrap();
            let voxels = voxels.split_whitespace().map(|voxel| voxel.split_at(1));
            let (labels, response): (Vec<u8>, Vec<f32>) = voxels
                .map(|(label, response)| {
                    let labels = [("P", PART), ("V", VOID), ("O", OUTSIDE)];
                    let (_, label) = labels
                        .into_iter()
                        .find(|(letter, _)| *letter == label)
                        .unwrap();
                    (label, response.parse::<f32>().unwrap())
                })
                .unzip();
            let found = measured(kind.measure, &labels, &response);
            assert_eq!(found.is_none(), expected == "none", "{row}: {found:?}");
            if let Some(found) = found {
                let expected: f64 = expected.parse().unwrap();
                assert!((found - expected).abs() < 1e-6, "{row}: {found}");
            }
        }
    }
}
