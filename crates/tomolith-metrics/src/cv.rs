//! Coefficient of variation of the dose in the part.
//!
//! ```text
//! CV = standard deviation of m over the part / mean of m over the part
//! ```
//!
//! (deviation of all voxels: divided by their number). None without part, or when the mean is 0.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let part = print.scan().part()?;
    (part.mean != 0.0).then(|| part.deviation / part.mean)
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "cv",
    title: "Dose variation",
    summary: "Standard deviation of the dose inside the part, divided by its mean; small means evenly cured.",
    unit: "",
    better: Better::Lower,
    measure,
};
