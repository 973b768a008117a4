//! Any model of the host, its patterns and doses in sealed fields: how a job brings a model that has no backend.

use super::field::SealedField;
use std::ops::Range;
use tomolith_core::dose::{DoseModel, Run};
use tomolith_core::error::Result;
use tomolith_core::field::{Field, HostField};
use tomolith_core::forward;

/// The model.
pub(crate) struct Sealed<M>(pub(crate) M);

fn opened(field: &SealedField) -> HostField {
    HostField::from_slice(&field.to_host())
}

impl<M: DoseModel<Field = HostField>> DoseModel for Sealed<M> {
    type Field = SealedField;

    forward!(DoseModel, self => self.0; patterns, outputs, z_coupling, is_linear, updates);

    fn new_patterns(&self) -> Result<SealedField> {
        Ok(SealedField::of(self.0.new_patterns()?.as_slice()))
    }

    fn new_dose(&self) -> Result<SealedField> {
        Ok(SealedField::of(self.0.new_dose()?.as_slice()))
    }

    fn dose(&self, x: &SealedField, dose: &mut SealedField, run: &Run) -> Result<()> {
        let mut host = self.0.new_dose()?;
        self.0.dose(&opened(x), &mut host, run)?;
        dose.copy_from_host(host.as_slice());
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &SealedField,
        cotangent: &SealedField,
        grad: &mut SealedField,
        run: &Run,
    ) -> Result<()> {
        let mut host = opened(grad);
        self.0
            .pullback_of(frames, &opened(x), &opened(cotangent), &mut host, run)?;
        grad.copy_from_host(host.as_slice());
        Ok(())
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &SealedField,
        dose: &mut SealedField,
        run: &Run,
    ) -> Result<()> {
        let mut host = opened(dose);
        self.0.dose_of(frames, &opened(x), &mut host, run)?;
        dose.copy_from_host(host.as_slice());
        Ok(())
    }

    fn along(
        &self,
        x: &SealedField,
        d: &SealedField,
        run: &Run,
    ) -> Result<Option<Vec<SealedField>>> {
        let terms = self.0.along(&opened(x), &opened(d), run)?;
        let seal = |term: &HostField| SealedField::of(term.as_slice());
        Ok(terms.map(|terms| terms.iter().map(seal).collect()))
    }

    fn describe(&self) -> String {
        format!("sealed: {}", self.0.describe())
    }
}
