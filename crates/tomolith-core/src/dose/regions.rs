//! Regions of voxels: doses where they matter.
//!
//! A loss of bands feels a void voxel only where its dose is above a threshold, and most voxels of a vial stay far below. A model that bounds the dose of a region
//! at a small part of the cost of the dose lets a search leave such regions out: their doses are not computed, and every loss, gradient and step is the same.
//!
//! **Bound** With patterns x ≥ 0 and weights a ≥ 0, Σ a·x ≤ Σ a·x̂, where x̂ is the largest of several neighbors: neighbors along z share their weights, so that one
//! sum bounds all of them.

use crate::error::Result;
use crate::work::Work;

/// A number for each element of a dose field.
pub type ByElement<'a> = dyn Fn(usize) -> f32 + Sync + 'a;

/// A linear model with weights that are not negative, whose dose can be computed in some regions of its voxels, and bounded in all of them.
pub trait Regions<F>: Send + Sync {
    /// How many regions there are. Together they hold every voxel that can be lit; they may overlap.
    fn count(&self) -> usize;
    /// The smallest number of each region's elements; 0 and above, ∞ for a region without voxels.
    fn least(&self, value_of: &ByElement) -> Vec<f32>;
    /// Whether a dose field holds anything but 0 in each region that is chosen; false for all others.
    fn holds_any(&self, field: &F, chosen: &[bool]) -> Vec<bool>;
    /// What F(x + step) is nowhere above in each region, rounding included; x + step is nowhere negative.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn bounds(&self, x: &F, step: &F, work: &Work) -> Result<Vec<f32>>;
    /// F(x) in the voxels of the regions that are chosen: overwrites these, and leaves all others.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn dose_in(&self, chosen: &[bool], x: &F, dose: &mut F, work: &Work) -> Result<()>;
}
