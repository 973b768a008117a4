//! Exposure latitude: over which exposures a print stays nearly as good as at the best one.
//!
//! An exposure s times as long brings s times the dose, which is the same as a resin that gels at a dose s times smaller. So for a
//! target of part and void the exposures are the gel thresholds, turned round: all thresholds next to the best one over which IoU
//! is at least its best − 0.01, exact ([`Scan::round_best`](super::scan::Scan::round_best)).
//!
//! A gray target has no threshold. There it is the rms error that stays within 0.01 of its least, over factors s of the exposure;
//! exact, from three sums, where the response is proportional to the dose. The share of voxels in the band would need a
//! sorted list of all voxels' doses, and may rise and fall several times.
//!
//! Part voxels 0.875 and 0.75, void voxels 0.5 and 0.125:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::latitude::Latitude;
//! use tomolith_metrics::{evaluate, print::Print};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 4], 0.5);
//! let labels = Volume { grid: grid.clone(), values: vec![PART, PART, VOID, VOID] };
//! let response = Volume { grid, values: vec![0.875, 0.75, 0.5, 0.125] };
//! let evaluation = evaluate(&Print::new(&labels, &response).unwrap());
//! // From 0.5 to 0.75 the part prints whole and alone; beyond, IoU is 1/2 or 2/3
//! assert_eq!(evaluation.latitude, Some(Latitude::Thresholds { iou: 1.0, at: [0.5, 0.625, 0.75] }));
//! ```

use super::print::Print;

/// Loss of IoU, or rms error in units of the response, up to which a print is nearly as good.
pub const TOLERANCE: f64 = 0.01;

/// Over what a print stays nearly as good.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Latitude {
    /// Part and void.
    Thresholds {
        /// The best IoU.
        iou: f64,
        /// Gel thresholds, in units of the response: the lowest, the best, and the first that is too high (infinite where none is).
        at: [f64; 3],
    },
    /// Gray values.
    Exposures {
        /// The least rms error.
        rms: f64,
        /// Factors of the exposure, 1 as written: the shortest, the best, the longest. For a response that is proportional to the dose.
        at: [f64; 3],
    },
}

/// The latitude of a print; `None` where nothing of the part prints.
pub(super) fn latitude(print: &Print<'_>) -> Option<Latitude> {
    if let Some(errors) = print.gray_errors() {
        let (rms, at) = errors.exposures(TOLERANCE)?;
        return Some(Latitude::Exposures { rms, at });
    }
    let round = print.scan().round_best()?;
    let at = [round.from, print.best()?.middle(), round.to];
    Some(Latitude::Thresholds { iou: round.iou, at })
}
