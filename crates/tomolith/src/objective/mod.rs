//! Objectives: how wrong a dose is.
//!
//! *What must it do, and who does it.* Nearly every voxel-wise loss published for TVAM is one form, the band
//! ([`band`]); the table [`OBJECTIVES`] holds its presets.

use crate::error::Result;
use crate::field::Field;

/// A real-valued function of a dose field. It knows no optics.
pub trait Objective<F: Field>: Send + Sync {
    /// L(dose)
    fn value(&self, dose: &F) -> f64;
    /// L(dose), and ∂L/∂dose written over `grad`; the value equals [`value`](Self::value) bit for bit.
    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64;
    /// L(dose + α·step), for line searches, without a temporary field.
    fn value_along(&self, dose: &F, step: &F, alpha: f32) -> f64;
    /// α ↦ (L, dL/dα) of dose + α·step.
    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64);
}

/// A boxed result, to keep signatures short.
pub type BoxedObjective<F> = Result<Box<dyn Objective<F>>>;
