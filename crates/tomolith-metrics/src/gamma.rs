//! Threshold range Γ, the process window of Nicolet et al. 2024: how far the threshold may be off.
//!
//! ```text
//! Γ = 100 % · length of {t in [0, 1]: IoU(t) > 0.95·max IoU}
//! ```
//!
//! exact, from the breakpoints of IoU(t). None without part, and where all such thresholds lie above 1.

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    // Where nothing turns solid at any threshold there is no range either
    print.best()?;
    Some(100.0 * print.scan().length_near_best()?)
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "gamma",
    title: "Threshold range Γ",
    summary: "Range of thresholds, as a share of the dose scale 0…1, over which IoU stays above 95 % of its best: the process window of Nicolet et al. 2024.",
    unit: "%",
    better: Better::Higher,
    measure,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{PART, VOID};

    #[test]
    fn a_threshold_is_good_above_95_percent_of_the_best() {
        // Twenty part voxels: the weakest may not be lost (19/20 is not above 0.95), nor may the void gel (20/22)
        let print = |parts: usize| {
            let labels: Vec<u8> = [VOID, VOID].into_iter().chain(vec![PART; parts]).collect();
            let mut response = vec![0.75; parts + 2];
            response[..3].copy_from_slice(&[0.25, 0.25, 0.5]);
            measured(measure, &labels, &response)
        };
        assert!(near(print(20), 25.0));
        assert!(near(print(21), 50.0)); // 20/21 is above 0.95, 21/23 is not
        let brighter = measured(measure, &[VOID, PART], &[1.5, 3.0]);
        assert_eq!(brighter, None);
    }
}
