//! Responses: dose → what the material does.
//!
//! *What must it do, and who does it.* A [`Response`] is M of the one equation, voxel by voxel. Bands, metrics and
//! thresholds are in units of the response.

use crate::error::Result;
use crate::kind::{Kind, Section};

/// A scalar, increasing map of the dose.
pub trait Response: std::fmt::Debug + Send + Sync {
    /// M(d)
    fn value(&self, dose: f32) -> f32;
    /// M(d) and dM/dd
    fn value_and_slope(&self, dose: f32) -> (f32, f32);
    /// The dose d with M(d) = m; m outside the range of M is first brought to the nearest value inside.
    fn inverse(&self, response: f32) -> f32;
    /// Whether M(d) = d, so that kernels may skip it.
    fn is_identity(&self) -> bool {
        false
    }
}

/// Builds a response from its section.
pub type BuildResponse = fn(&Section) -> Result<Box<dyn Response>>;

/// Every response.
pub static RESPONSES: &[Kind<BuildResponse>] = &[];
