//! Overcured volume: void voxels above the gel threshold, mm³.
//!
//! None without any voxel that counts; 0 when nothing is printed.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let [part, void] = print.scan().totals();
    (part + void > 0).then(|| print.printed()[1] as f64 * print.grid().voxel_mm3())
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "over_mm3",
    title: "Overcured volume",
    summary: "Volume that gels though it should stay liquid.",
    unit: "mm³",
    better: Better::Lower,
    measure,
};
