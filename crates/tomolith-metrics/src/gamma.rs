//! Threshold range Γ, the process window of Nicolet et al. 2024: how far the threshold may be off.
//!
//! ```text
//! Γ = 100 % · length of {t in [0, 1]: IoU(t) > 0.95·max IoU}
//! ```
//!
//! exact, from the breakpoints of IoU(t). None without part.
//!
//! Part voxels 0.9, 0.8 and 0.3, void voxels 0.5 and 0.1:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::{evaluate, print::Print};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 5], 0.5);
//! let labels = Volume { grid: grid.clone(), values: vec![PART, PART, PART, VOID, VOID] };
//! let response = Volume { grid, values: vec![0.9, 0.8, 0.3, 0.5, 0.1] };
//! let measures = evaluate(&Print::new(&labels, &response).unwrap()).measures;
//! assert!((measures.get("gamma").unwrap() - 20.0).abs() < 1e-5); // IoU is above 0.95·3/4 from 0.1 to 0.3 only: 20 % of 0…1
//! ```

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct Gamma;

impl Metric for Gamma {
    fn measure(&self, print: &Print<'_>) -> Measure {
        // Where nothing turns solid at any threshold there is no range either
        print.best()?;
        Some(100.0 * print.scan().length_near_best()?)
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "gamma",
    title: "Threshold range Γ",
    summary: "Range of thresholds, as a share of the dose scale 0…1, over which IoU stays above 95 % of its best: the process window of Nicolet et al. 2024.",
    unit: "%",
    better: Better::Higher,
    metric: &Gamma,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{measured, near};
    use tomolith_core::target::label::{PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        measured(&Gamma, labels, response)
    }

    #[test]
    fn is_the_length_of_the_good_thresholds() {
        assert!(near(measure(&[VOID, PART], &[0.375, 0.875]), 50.0));
        assert!(near(measure(&[VOID, PART], &[0.375, 7.0]), 62.5)); // the scale ends at 1
        // Twenty part voxels: the weakest may not be lost (19/20 is not above 0.95), nor may the void gel (20/22)
        let print = |parts: usize| {
            let labels: Vec<u8> = [VOID, VOID].into_iter().chain(vec![PART; parts]).collect();
            let mut response = vec![0.75; parts + 2];
            response[..3].copy_from_slice(&[0.25, 0.25, 0.5]);
            measure(&labels, &response)
        };
        assert!(near(print(20), 25.0));
        assert!(near(print(21), 50.0)); // 20/21 is above 0.95, 21/23 is not
        assert_eq!(measure(&[VOID], &[1.0]), None);
        assert_eq!(measure(&[VOID, PART], &[0.0, 0.0]), None);
    }
}
