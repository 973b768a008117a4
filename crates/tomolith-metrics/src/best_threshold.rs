//! The gel threshold of the best IoU.
//!
//! The middle of the longest interval of thresholds t over which {m > t} has the best IoU; thresholds start at 0 (or at
//! the smallest response, when that is negative). None without part, or when no threshold prints any of it.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    print.best().map(|best| best.middle())
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "best_threshold",
    title: "Best threshold",
    summary: "The gel threshold with the best IoU (the middle of all equally good ones).",
    unit: "response",
    better: Better::Neutral,
    measure,
};
