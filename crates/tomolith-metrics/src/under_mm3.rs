//! Undercured volume: part voxels that are not above the gel threshold, mm³.
//!
//! None without any voxel that counts; the whole part when nothing is printed.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let [part, void] = print.scan().totals();
    (part + void > 0).then(|| (part - print.printed()[0]) as f64 * print.grid().voxel_mm3())
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "under_mm3",
    title: "Undercured volume",
    summary: "Volume of the part that stays liquid.",
    unit: "mm³",
    better: Better::Lower,
    measure,
};
