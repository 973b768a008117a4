//! Intersection over union of the print with the part.
//!
//! ```text
//! IoU(t) = #{part: m > t} / (#part + #{void: m > t})
//! ```
//!
//! at the gel threshold: the best one over all thresholds ([`scan`](super::scan)), or the given one. None without part;
//! 0 when no threshold prints any of it.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let scan = print.scan();
    scan.part()?;
    match (print.gel_threshold(), print.best()) {
        (None, _) => Some(0.0),
        (Some(threshold), Some(best)) if threshold == best.middle() => Some(best.iou),
        (Some(threshold), _) => scan.iou_at(threshold),
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "iou",
    title: "IoU",
    summary: "Volume in both print and part, divided by the volume in either; 1 is a perfect print.",
    unit: "",
    better: Better::Higher,
    measure,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{near, row};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn of_a_given_threshold() {
        let labels = row(&[PART, PART, PART, VOID, VOID, OUTSIDE]);
        let response = row(&[0.9, 0.8, 0.3, 0.5, 0.1, 2.0]);
        let print = Print::new(&labels, &response)
            .unwrap()
            .with_threshold(0.6)
            .unwrap();
        assert!(near(measure(&print), 2.0 / 3.0));
    }
}
