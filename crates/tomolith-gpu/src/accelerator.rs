//! Dose models of forms on the card, with fields there or on the host: then patterns are copied there, doses back.

use crate::device::Gpu;
use crate::field::GpuField;
use crate::paths::GpuPaths;
use crate::rays::GpuRays;
use crate::strips::GpuStrips;
use crate::waves::GpuWaves;
use std::ops::Range;
use tomolith_core::dose::form::Form;
use tomolith_core::dose::{Accelerator, DoseModel, Facts, Renewal, Space, Work, frames_of};
use tomolith_core::error::Result;
use tomolith_core::field::{Field, HostField};
use tomolith_models::several::{Several, SharedModel};

/// The model of a form on a card.
///
/// # Errors
/// [`Error::Device`](tomolith_core::Error::Device), [`Error::Canceled`](tomolith_core::Error::Canceled);
/// [`Error::Resources`](tomolith_core::Error::Resources) where the card is too small.
pub fn model_on(
    gpu: &Gpu,
    form: &Form,
    work: &Work,
) -> Result<Box<dyn DoseModel<Field = GpuField>>> {
    Ok(match form {
        Form::Strips(form) => Box::new(GpuStrips::new(gpu, form, work)?),
        Form::Rays(form) => Box::new(GpuRays::new(gpu, form, work)?),
        Form::Paths(form) => Box::new(GpuPaths::new(gpu, form, work)?),
        Form::Waves(form) => Box::new(GpuWaves::new(gpu, form, work)?),
        Form::Joint(forms, joint) => {
            let models = forms.iter().map(|form| model_on(gpu, form, work));
            let models = models.map(|model| model.map(SharedModel::from));
            Box::new(Several::new(models.collect::<Result<_>>()?, joint.clone())?)
        }
    })
}

/// A model on the card whose fields are the host's.
struct OnHost {
    gpu: Gpu,
    model: Box<dyn DoseModel<Field = GpuField>>,
    form: Form,
}

impl OnHost {
    /// Numbers of the host on the card.
    fn there(&self, space: Space, values: &HostField) -> Result<GpuField> {
        let mut there = self.model.new_field(space)?;
        there.copy_from_host(values.as_slice());
        Ok(there)
    }

    /// Where a derivative is taken; nothing where the place does not matter.
    fn place(&self, x: &HostField) -> Result<GpuField> {
        if self.model.is_linear() {
            return Ok(GpuField::zeros(&self.gpu, 0, 1));
        }
        self.there(Space::Patterns, x)
    }

    /// F(x) of some frames on the card.
    fn dose_there(&self, frames: Range<usize>, x: &HostField, work: &Work) -> Result<GpuField> {
        let x = self.there(Space::Patterns, x)?;
        let mut dose = self.model.new_dose()?;
        self.model.dose_of(frames, &x, &mut dose, work)?;
        Ok(dose)
    }
}

impl Renewal<HostField> for OnHost {
    fn renew(&self, iteration: usize, x: &HostField, work: &Work) -> Result<bool> {
        let renewal = self.model.renewal();
        renewal.map_or(Ok(false), |model| {
            model.renew(iteration, &self.place(x)?, work)
        })
    }
}

impl DoseModel for OnHost {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        self.model.facts()
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, work: &Work) -> Result<()> {
        let there = self.dose_there(0..frames_of(self.patterns()), x, work)?;
        there.read_into(dose.as_mut_slice());
        self.gpu.check()
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let there = self.dose_there(frames, x, work)?;
        let mut added = dose.zeros_like();
        there.read_into(added.as_mut_slice());
        self.gpu.check()?;
        dose.axpy(1.0, &added);
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let (x, cotangent) = (self.place(x)?, self.there(Space::Dose, cotangent)?);
        let mut found = self.there(Space::Patterns, grad)?;
        (self.model).pullback_of(frames, &x, &cotangent, &mut found, work)?;
        found.read_into(grad.as_mut_slice());
        self.gpu.check()
    }

    fn along(&self, x: &HostField, d: &HostField, work: &Work) -> Result<Option<Vec<HostField>>> {
        let (x, d) = (self.place(x)?, self.there(Space::Patterns, d)?);
        let Some(terms) = self.model.along(&x, &d, work)? else {
            return Ok(None);
        };
        let mut found = Vec::new();
        for term in terms {
            let mut coefficient = self.new_dose()?;
            term.read_into(coefficient.as_mut_slice());
            found.push(coefficient);
        }
        self.gpu.check().map(|()| Some(found))
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        self.model.renewal().map(|_| self as _)
    }

    fn updates(&self) -> u64 {
        self.model.updates()
    }

    fn form(&self) -> Option<Form> {
        Some(self.form.clone())
    }

    fn describe(&self) -> String {
        self.model.describe()
    }
}

impl Accelerator for Gpu {
    fn model(
        &self,
        form: &Form,
        work: &Work,
    ) -> Result<Option<Box<dyn DoseModel<Field = HostField>>>> {
        Ok(Some(Box::new(OnHost {
            gpu: self.clone(),
            model: model_on(self, form, work)?,
            form: form.clone(),
        })))
    }
}
