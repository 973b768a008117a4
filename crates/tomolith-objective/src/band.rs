//! The band: one form for nearly every voxel-wise loss published for TVAM.
//!
//! **What it models.** A voxel is right while its response lies in a band [lower, upper]; outside, it costs its distance
//! from the band, to a power. Equation, limits and cost are those of the [data](tomolith_core::field::bands) that it is made of, which
//! the field's backend compiles when the first dose is seen.
//!
//! **Source** Li et al., Additive Manufacturing 94 (2024) 104447, eqs. 1 and 4 (their f_T ± ε is our [lower, upper]; their
//! band half-width ε, weight w, powers p and q are ours). The other presets are special bands; their files say which.
//!
//! **Parameters** p > 0, q > 0. lower ≤ upper; ±∞ where there is no bound; lower = upper is a legal band. A weight of 0 is a
//! voxel that does not count.
//!
//! **Shapes** the model's own dose field ([`DoseLayout`]); bands are given per label (a byte per voxel and
//! a table, the usual and cheap case), shared by part and void ([`Bands::Shared`]), or per voxel ([`Bands::Voxels`]).
//!
//! ```
//! use std::sync::Arc;
//! use tomolith_core::field::{Field, HostField};
//! use tomolith_objective::{Band, BandObjective, Bands, Objective};
//! use tomolith_core::response::Identity;
//! // two part voxels in [0.95, 1], two void voxels in (−∞, 0.9], p = q = 2
//! let bands = Bands::labels(vec![2, 2, 1, 1], &[(1, Band::below(0.9)), (2, Band::new(0.95, 1.0, 1.0))]);
//! let objective = BandObjective::new(0..4, bands, 2.0, 2.0, Arc::new(Identity)).unwrap();
//! let dose = HostField::from_slice(&[0.5, 0.97, 0.92, 0.5]);
//! let mut gradient = dose.zeros_like();
//! let loss = objective.value_and_gradient(&dose, &mut gradient);
//! assert!((loss - 0.2029).abs() < 1e-6); // 0.45² + 0.02²
//! for (found, expected) in gradient.as_slice().iter().zip([-0.9, 0.0, 0.04, 0.0]) {
//!     assert!((found - expected).abs() < 1e-6); // −2·0.45, in the band, 2·0.02, in the band
//! }
//! ```
//!
//! [`DoseLayout`]: tomolith_core::dose::DoseLayout

use super::{Objective, VoxelWeights};
use std::ops::Range;
use std::sync::{Arc, OnceLock};
use tomolith_core::dose::regions::ByElement;
use tomolith_core::error::Result;
pub use tomolith_core::field::{Band, Bands};
use tomolith_core::field::{BandKernel, BandLoss, Field, HostField};
use tomolith_core::response::Response;

/// The band objective; see the [module](self).
pub struct BandObjective<F: Field = HostField> {
    loss: Arc<BandLoss>,
    /// The loss where doses live, from the first dose on.
    kernel: OnceLock<F::Bands>,
}

impl<F: Field> BandObjective<F> {
    /// An objective on the `elements` of the model's dose field (see [`DoseLayout::range`]), which must begin at a multiple
    /// of 16; `bands` has one entry per element.
    ///
    /// # Errors
    /// Those of [`BandLoss::new`].
    ///
    /// [`DoseLayout::range`]: tomolith_core::dose::DoseLayout::range
    pub fn new(
        elements: Range<usize>,
        bands: Bands,
        p: f64,
        q: f64,
        response: Arc<dyn Response>,
    ) -> Result<Self> {
        let loss = BandLoss::new(elements, bands, p, q, response)?;
        Ok(BandObjective {
            loss: Arc::new(loss),
            kernel: OnceLock::new(),
        })
    }

    fn kernel(&self, dose: &F) -> &F::Bands {
        self.kernel.get_or_init(|| F::Bands::new(&self.loss, dose))
    }
}

impl<F: Field> Objective<F> for BandObjective<F> {
    fn value(&self, dose: &F) -> f64 {
        self.kernel(dose).value(dose)
    }

    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64 {
        self.kernel(dose).value_and_gradient(dose, grad)
    }

    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64) {
        self.kernel(dose).slope_along(dose, step, alpha)
    }

    fn advance(&self, dose: &mut F, step: &mut F, alpha: f32) -> f64 {
        self.kernel(dose).advance(dose, step, alpha)
    }

    fn is_convex(&self) -> bool {
        self.loss.is_convex()
    }

    fn harmless(&self) -> Option<Box<ByElement<'_>>> {
        (self.loss.elements().start == 0).then(|| self.loss.harmless())
    }

    fn set_voxel_weights(&mut self, voxel_weights: &VoxelWeights) -> Result<()> {
        self.kernel = OnceLock::new();
        Arc::make_mut(&mut self.loss)
            .set_voxel_weights(&voxel_weights.weight, &voxel_weights.tolerance)
    }

    fn set_response(&mut self, response: &Arc<dyn Response>) -> Result<()> {
        // Without its kernel nobody else holds the loss, and nothing is copied
        self.kernel = OnceLock::new();
        Arc::make_mut(&mut self.loss).set_response(Arc::clone(response));
        Ok(())
    }

    fn must_be_reached(&self) -> Result<()> {
        self.loss.must_be_reached()
    }
}
