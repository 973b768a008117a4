//! Metrics: one number of the report a file, or a few that one pass gives.
//!
//! *What must it do, and who does it.* A [`Metric`] turns a predicted [`Print`] into one number, or into none where it
//! is not defined (no part, no print): never into a number that is not finite. The table [`METRICS`] holds them all, in
//! the order of the report; `report.json` uses their names. [`evaluation`] applies the table.

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

/// One number of the report.
pub trait Metric: Send + Sync {
    /// Measures a print.
    fn measure(&self, print: &Print<'_>) -> Measure;
}

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
    /// The metric.
    pub metric: &'static dyn Metric,
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
