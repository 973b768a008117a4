//! What each of several objectives comes to.
//!
//! A loss is the objective's own: its factor in the sum, `weight`, is left out of it, and so one of factor 0 is only measured. Errors are those of
//! its response against the gray values, every voxel that counts once: in its region, and with a weight above 0.

use serde::Serialize;
use tomolith_metrics::Measure;

/// One of several objectives.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ObjectiveReport {
    /// Its key in the job, such as `objectives[0].bclp`.
    pub key: String,
    /// Its factor in the sum.
    pub weight: f64,
    /// Its loss without this factor; None where a dose per voxel does not tell it.
    pub loss: Measure,
    /// Voxels that count.
    pub voxels: u64,
    /// Root mean square difference between response and gray value; None for a target of part and void.
    pub rms_error: Measure,
    /// The largest such difference.
    pub max_error: Measure,
}
