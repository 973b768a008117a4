//! Objectives: how wrong a dose is.
//!
//! *What must it do, and who does it.* Nearly every voxel-wise loss published for TVAM is one form, the band
//! ([`band`]); the table [`OBJECTIVES`] holds its presets. Several objectives are added by [`Sum`].

pub mod band;
pub mod bclp;
pub mod buffer;
pub mod dose_matching;
pub mod least;
pub mod osmo;
pub mod pm;
pub mod preset;
pub mod sum;
pub mod threshold;
pub mod window;

use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::Volume;
use crate::kind::{Kind, Section};
use crate::models::DoseLayout;
use crate::response::Response;
use crate::target::Target;
pub use band::{Band, BandObjective, Bands};
use std::sync::Arc;
pub use sum::Sum;

/// A real-valued function of a dose field. It knows no optics.
pub trait Objective<F: Field>: Send + Sync {
    /// L(dose)
    fn value(&self, dose: &F) -> f64;
    /// L(dose), and ∂L/∂dose written over `grad`; the value equals [`value`](Self::value) bit for bit.
    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64;
    /// L(dose + α·step), for line searches, without a temporary field.
    fn value_along(&self, dose: &F, step: &F, alpha: f32) -> f64 {
        self.slope_along(dose, step, alpha).0
    }
    /// α ↦ (L, dL/dα) of dose + α·step.
    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64);
    /// Ends a line search in one pass: dose ← dose + α·step, step ← ∂L/∂dose there; returns L there, bit for bit what
    /// [`value_and_gradient`](Self::value_and_gradient) gives at the new dose.
    fn advance(&self, dose: &mut F, step: &mut F, alpha: f32) -> f64 {
        dose.axpy(alpha, step);
        self.value_and_gradient(dose, step)
    }
    /// Whether L is convex in the dose, so that a line search finds its minimum where the slope changes sign.
    fn is_convex(&self) -> bool;
}

/// A boxed result, to keep signatures short.
pub type BoxedObjective<F> = Result<Box<dyn Objective<F>>>;

/// What an objective is built on.
#[derive(Clone)]
pub struct ObjectiveInput<'a> {
    /// Where the voxels lie in the model's dose field.
    pub layout: &'a DoseLayout,
    /// Label of each voxel ([`target::label`](crate::target::label)), array order.
    pub labels: &'a Volume<u8>,
    /// The target on the same grid.
    pub target: &'a Target,
    /// M of the one equation; bands are in its units.
    pub response: Arc<dyn Response>,
}

/// Builds an objective from its section.
pub type BuildObjective = fn(&Section, &ObjectiveInput) -> BoxedObjective<HostField>;

/// Every objective.
pub static OBJECTIVES: &[Kind<BuildObjective>] = &[
    threshold::KIND,
    least::L2,
    least::L1,
    dose_matching::KIND,
    pm::KIND,
    osmo::KIND,
    bclp::KIND,
    window::L2N,
    window::OSP,
    window::OSPW,
];
