//! In-part dose range.
//!
//! ```text
//! IPDR = max over part m − min over part m
//! ```
//!
//! None without part.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let part = print.scan().part()?;
    Some(f64::from(part.max) - f64::from(part.min))
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "ipdr",
    title: "In-part dose range",
    summary: "Largest minus smallest dose in the part; small means evenly cured.",
    unit: "response",
    better: Better::Lower,
    measure,
};
