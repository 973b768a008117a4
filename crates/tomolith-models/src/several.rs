//! Several models that act as one: what a sum over lights ([`spectral`](super::spectral)) and the same light under several scenarios
//! ([`scenarios`](super::scenarios)) have in common.
//!
//! Each model has its patterns and its dose. How these follow from the joint ones and back is all that a [`Joint`] says.

use crate::{DoseLayout, DoseModel, PatternLayout, Run, ZCoupling, elements_of};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::{Facts, Renewal, Space};
use tomolith_core::error::Result;
use tomolith_core::field::{Field, HostField};

/// A model that others share.
pub type SharedModel = Arc<dyn DoseModel<Field = HostField>>;

/// Models that act as one; see the [module](self).
pub struct Several<J> {
    pub(crate) models: Vec<SharedModel>,
    pub(crate) patterns: Vec<PatternLayout>,
    pub(crate) outputs: Vec<DoseLayout>,
    pub(crate) joint: J,
}

/// What the patterns and the dose of one of several models have to do with the joint ones. Models count as `k`.
pub trait Joint: Send + Sync + Sized {
    /// The models that show some of the joint frames, and which of their own frames these are.
    fn parts(all: &Several<Self>, frames: &Range<usize>) -> Vec<(usize, Range<usize>)>;

    /// The patterns of a model.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn shown(all: &Several<Self>, k: usize, x: &HostField) -> Result<HostField>;

    /// doses += what they have of the dose `q` of a model.
    fn add(all: &Several<Self>, k: usize, q: &HostField, doses: &mut HostField);

    /// The cotangent of a model: the transpose of [`add`](Self::add). Overwrites `c`.
    fn split(all: &Several<Self>, k: usize, cotangent: &HostField, c: &mut HostField);

    /// grad += the gradient of a model, of some of its frames: the transpose of [`shown`](Self::shown).
    fn gather(
        all: &Several<Self>,
        k: usize,
        frames: Range<usize>,
        own: &HostField,
        grad: &mut HostField,
    );

    /// As [`DoseModel::of_light`].
    fn of_light(_all: &Several<Self>, _i: usize) -> Option<SharedModel> {
        None
    }

    /// As [`DoseModel::describe`].
    fn describe(all: &Several<Self>) -> String;
}

impl<J> Several<J> {
    /// The part of a run that one of the models has.
    fn part(&self, run: &Run) -> Run {
        run.part(1.0 / self.models.len() as f64)
    }
}

impl<J: Joint> Renewal<HostField> for Several<J> {
    fn renew(&self, iteration: usize, x: &HostField, run: &Run) -> Result<bool> {
        let mut any = false;
        for (k, model) in self.models.iter().enumerate() {
            if let Some(model) = model.renewal() {
                any |= model.renew(iteration, &J::shown(self, k, x)?, run)?;
            }
        }
        Ok(any)
    }
}

impl<J: Joint> DoseModel for Several<J> {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: &self.outputs,
            z_coupling: ZCoupling::widest(self.models.iter().map(|model| model.z_coupling())),
            is_linear: self.models.iter().all(|model| model.is_linear()),
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, run: &Run) -> Result<()> {
        dose.fill(0.0);
        let mut q = self.models[0].new_dose()?;
        for (k, model) in self.models.iter().enumerate() {
            model.dose(&J::shown(self, k, x)?, &mut q, &self.part(run))?;
            J::add(self, k, &q, dose);
        }
        Ok(())
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        let mut q = self.models[0].new_dose()?;
        for (k, own) in J::parts(self, &frames) {
            q.fill(0.0);
            self.models[k].dose_of(own, &J::shown(self, k, x)?, &mut q, &self.part(run))?;
            J::add(self, k, &q, dose);
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        for (range, _) in elements_of(&self.patterns, &frames) {
            grad.as_mut_slice()[range].fill(0.0);
        }
        let mut c = self.models[0].new_dose()?;
        for (k, own) in J::parts(self, &frames) {
            J::split(self, k, cotangent, &mut c);
            let (model, part) = (&self.models[k], self.part(run));
            let mut back = model.new_patterns()?;
            model.pullback_of(own.clone(), &J::shown(self, k, x)?, &c, &mut back, &part)?;
            J::gather(self, k, own, &back, grad);
        }
        Ok(())
    }

    /// The joint dose, power by power; None where one of the models has none.
    fn along(&self, x: &HostField, d: &HostField, run: &Run) -> Result<Option<Vec<HostField>>> {
        let mut all: Vec<HostField> = Vec::new();
        for (k, model) in self.models.iter().enumerate() {
            let [x, d] = [J::shown(self, k, x)?, J::shown(self, k, d)?];
            let Some(powers) = model.along(&x, &d, run)? else {
                return Ok(None);
            };
            for (power, q) in powers.iter().enumerate() {
                if power == all.len() {
                    all.push(self.new_dose()?);
                }
                J::add(self, k, q, &mut all[power]);
            }
        }
        Ok(Some(all))
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        let renewed = self.models.iter().any(|model| model.renewal().is_some());
        renewed.then_some(self as _)
    }

    fn updates(&self) -> u64 {
        self.models.iter().map(|model| model.updates()).sum()
    }

    fn of_light(&self, i: usize) -> Option<SharedModel> {
        J::of_light(self, i)
    }

    fn describe(&self) -> String {
        J::describe(self)
    }
}
