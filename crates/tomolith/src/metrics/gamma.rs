//! Process window Γ: how far the threshold may be off.
//!
//! ```text
//! Γ = 100 % · length of {t in [0, 1]: IoU(t) > 0.95·max IoU}
//! ```
//!
//! exact, from the breakpoints of IoU(t). None without part.

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct Gamma;

impl Metric for Gamma {
    fn measure(&self, print: &Print<'_>) -> Measure {
        Some(100.0 * print.scan().length_near_best()?)
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "gamma",
    title: "Process window Γ",
    summary: "How much the threshold may vary: share of the dose scale 0…1 over which IoU stays within 5 % of its best.",
    unit: "%",
    better: Better::Higher,
    metric: &Gamma,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Volume, VolumeGrid};
    use crate::target::label::{PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        let grid = VolumeGrid::centered([1, 1, labels.len()], 0.5);
        let labels = Volume {
            grid: grid.clone(),
            values: labels.to_vec(),
        };
        let response = Volume {
            grid,
            values: response.to_vec(),
        };
        Gamma.measure(&Print::new(&labels, &response).unwrap())
    }

    fn near(found: Measure, expected: f64) -> bool {
        found.is_some_and(|found| (found - expected).abs() < 1e-6)
    }

    #[test]
    fn is_the_length_of_the_good_thresholds() {
        assert!(near(measure(&[VOID, PART], &[0.375, 0.875]), 50.0));
        assert!(near(measure(&[VOID, PART], &[0.375, 7.0]), 62.5)); // the scale ends at 1
        // Twenty part voxels: the weakest may be lost (19/20 is not above 0.95), so only up to it
        let labels: Vec<u8> = (0..22).map(|i| if i == 0 { VOID } else { PART }).collect();
        let response: Vec<f32> = (0..22)
            .map(|i| {
                if i == 0 {
                    0.25
                } else if i == 1 {
                    0.5
                } else {
                    0.75
                }
            })
            .collect();
        assert!(near(measure(&labels[..21], &response[..21]), 25.0));
        assert!(near(measure(&labels, &response), 50.0)); // 20/21 is above
        assert_eq!(measure(&[VOID], &[1.0]), None);
    }
}
