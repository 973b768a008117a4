//! Process window.
//!
//! ```text
//! PW = min over part m − max over void m
//! ```
//!
//! Positive: a range of thresholds prints the part without error. (Some authors use the opposite sign.) None without
//! part or without void.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let scan = print.scan();
    let (part, void) = (scan.part()?, scan.void()?);
    // Without dose there is nothing to tell apart
    let is_dark = part.max <= 0.0 && void.max <= 0.0;
    (!is_dark).then(|| f64::from(part.min) - f64::from(void.max))
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "pw",
    title: "Process window PW",
    summary: "Smallest dose in the part minus largest dose in the void; below 0 they overlap.",
    unit: "response",
    better: Better::Higher,
    measure,
};
