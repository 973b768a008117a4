//! Any model of the host, its patterns and doses in sealed fields: how a job brings a model that has no backend.

use super::field::SealedField;
use std::ops::Range;
use tomolith_core::dose::{DoseModel, Run};
use tomolith_core::error::Result;
use tomolith_core::field::HostField;
use tomolith_core::forward;

/// The model.
pub(crate) struct SealedModel<M>(pub(crate) M);

impl<M: DoseModel<Field = HostField>> DoseModel for SealedModel<M> {
    type Field = SealedField;

    forward!(DoseModel, self => self.0; patterns, outputs, z_coupling, is_linear, updates);

    fn new_patterns(&self) -> Result<SealedField> {
        self.0.new_patterns().map(SealedField)
    }

    fn new_dose(&self) -> Result<SealedField> {
        self.0.new_dose().map(SealedField)
    }

    fn dose(&self, x: &SealedField, dose: &mut SealedField, run: &Run) -> Result<()> {
        self.0.dose(&x.0, &mut dose.0, run)
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &SealedField,
        cotangent: &SealedField,
        grad: &mut SealedField,
        run: &Run,
    ) -> Result<()> {
        let (x, cotangent, grad) = (&x.0, &cotangent.0, &mut grad.0);
        self.0.pullback_of(frames, x, cotangent, grad, run)
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &SealedField,
        dose: &mut SealedField,
        run: &Run,
    ) -> Result<()> {
        self.0.dose_of(frames, &x.0, &mut dose.0, run)
    }

    fn along(
        &self,
        x: &SealedField,
        d: &SealedField,
        run: &Run,
    ) -> Result<Option<Vec<SealedField>>> {
        let terms = self.0.along(&x.0, &d.0, run)?;
        Ok(terms.map(|terms| terms.into_iter().map(SealedField).collect()))
    }

    fn describe(&self) -> String {
        format!("sealed: {}", self.0.describe())
    }
}
