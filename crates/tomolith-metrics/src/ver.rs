//! Voxel error rate.
//!
//! ```text
//! VER = #{void: m > min over part m} / (#part + #void)
//! ```
//!
//! (Other authors count m ≥ min.) None without part.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let scan = print.scan();
    let part = scan.part()?;
    // Without dose nothing gels at any threshold
    if part.max <= 0.0 {
        return None;
    }
    let smallest = part.min;
    let [part, void] = scan.totals();
    let wrong = scan.count_above(f64::from(smallest))[1];
    Some(wrong as f64 / (part + void) as f64)
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "ver",
    title: "Voxel error rate",
    summary: "Share of the voxels that gel wrongly once the last voxel of the part has gelled.",
    unit: "",
    better: Better::Lower,
    measure,
};
