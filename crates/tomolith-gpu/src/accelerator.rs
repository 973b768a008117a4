//! Models on the card whose fields are the host's: patterns are copied there, doses back.

use crate::device::Gpu;
use crate::field::GpuField;
use crate::strips::GpuStrips;
use std::ops::Range;
use tomolith_core::dose::strips::StripForm;
use tomolith_core::dose::{Accelerator, DoseModel, Facts, LinearOperator, Run, Space};
use tomolith_core::error::Result;
use tomolith_core::field::{Field, HostField};

/// A model on the card whose fields are the host's.
struct OnHost {
    model: GpuStrips,
    form: StripForm,
}

impl OnHost {
    /// F(x) of some frames on the card.
    fn dose_there(&self, frames: Range<usize>, x: &HostField, run: &Run) -> Result<GpuField> {
        let mut there = DoseModel::new_patterns(&self.model)?;
        there.copy_from_host(x.as_slice());
        let mut dose = DoseModel::new_dose(&self.model)?;
        self.model.add_forward(frames, &there, &mut dose, run)?;
        Ok(dose)
    }
}

impl DoseModel for OnHost {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        LinearOperator::facts(&self.model)
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, run: &Run) -> Result<()> {
        let all = 0..LinearOperator::frames(&self.model);
        let there = self.dose_there(all, x, run)?;
        there.read_into(dose.as_mut_slice());
        self.model.gpu().check()
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        let there = self.dose_there(frames, x, run)?;
        let mut own = dose.zeros_like();
        there.read_into(own.as_mut_slice());
        self.model.gpu().check()?;
        dose.axpy(1.0, &own);
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        let mut there = DoseModel::new_dose(&self.model)?;
        there.copy_from_host(cotangent.as_slice());
        let mut found = DoseModel::new_patterns(&self.model)?;
        found.copy_from_host(grad.as_slice());
        self.model.adjoint_of(frames, &there, &mut found, run)?;
        found.read_into(grad.as_mut_slice());
        self.model.gpu().check()
    }

    fn updates(&self) -> u64 {
        LinearOperator::updates(&self.model)
    }

    fn strips(&self) -> Option<StripForm> {
        Some(self.form.clone())
    }

    fn describe(&self) -> String {
        LinearOperator::describe(&self.model)
    }
}

impl Accelerator for Gpu {
    fn model(
        &self,
        form: &StripForm,
        run: &Run,
    ) -> Result<Option<Box<dyn DoseModel<Field = HostField>>>> {
        Ok(Some(Box::new(OnHost {
            model: GpuStrips::new(self, form, run)?,
            form: form.clone(),
        })))
    }
}
