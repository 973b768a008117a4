//! Pattern efficiency η.
//!
//! ```text
//! η = mean of x / max of x
//! ```
//!
//! over all pixels of all frames and lights, dark and masked ones included: how well the projector's power is used.
//! None when no patterns are given or all are dark.
//!
//! Eight pixels, six of them with 1 and two with 3:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::{evaluate, print::{PatternStats, Print}};
//! use tomolith_core::target::label::PART;
//! let grid = VolumeGrid::centered([1, 1, 1], 0.5);
//! let (labels, response) = (Volume { grid: grid.clone(), values: vec![PART] }, Volume { grid, values: vec![1.0] });
//! let stats = PatternStats { pixels: 8, sum: 12.0, max: 3.0, white: 6.0 };
//! let print = Print::new(&labels, &response).unwrap().with_patterns(stats);
//! assert_eq!(evaluate(&print).measures.get("eta"), Some(0.5)); // mean 1.5, maximum 3
//! ```

use super::print::Print;
use super::{Better, Measure, MetricKind};

/// See the [module page](self).
fn measure(print: &Print<'_>) -> Measure {
    let patterns = print.patterns()?;
    (patterns.max > 0.0).then(|| patterns.sum / patterns.pixels as f64 / f64::from(patterns.max))
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "eta",
    title: "Pattern efficiency η",
    summary: "Mean pixel divided by the brightest one: how much of the projector's power the patterns use.",
    unit: "",
    better: Better::Higher,
    measure,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::{PatternStats, samples::row};

    #[test]
    fn is_mean_over_maximum() {
        let (labels, response) = (row(&[]), row(&[]));
        let print = || Print::new(&labels, &response).unwrap();
        let eta_of = |sum, max| {
            let pixels = 8;
            measure(&print().with_patterns(PatternStats {
                pixels,
                sum,
                max,
                white: 0.0,
            }))
        };
        assert_eq!(eta_of(6.0, 3.0), Some(0.25));
        assert_eq!(eta_of(0.0, 0.0), None);
        assert_eq!(measure(&print()), None);
    }
}
