//! A rank's share of a model whose frames are spread over several processes.
//!
//! **What it models** The dose of all frames, from a model of the frames that this rank has. Fields of patterns are shares
//! ([`HostField::shared`]), so whoever asks for their sums gets those of all ranks; doses are whole on every rank.
//!
//! **Equation** with F_r the dose of rank r's frames and x_r their patterns
//!
//! ```text
//! F(x) = Σ_r F_r(x_r)        (F′(x)ᵀ c)_r = F_r′(x_r)ᵀ c
//! ```
//!
//! **Cost** of a dose that of the share, and the sum of a dose field over ranks; of a pullback that of the share alone. **Limits** models whose
//! dose is a sum over frames. Every rank makes the same calls; where one of them fails, all do ([`together`]).

use crate::several::SharedModel;
use crate::{DoseModel, Work};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::{Facts, Renewal, Space};
use tomolith_core::error::Result;
use tomolith_core::field::{Field, HostField};
use tomolith_core::ranks::{Communicator, together};

/// A model of this rank's frames, whose dose is that of all ranks' frames; see the [module](self).
pub struct Sharded {
    model: SharedModel,
    /// Shares of the model of each light, where it has them.
    lights: Vec<SharedModel>,
    ranks: Arc<dyn Communicator>,
    /// Of all ranks.
    updates: u64,
}

impl Sharded {
    /// A share. Called by all ranks.
    #[must_use]
    pub fn new(model: SharedModel, ranks: Arc<dyn Communicator>) -> Self {
        let mut updates = [model.updates() as f64];
        ranks.all_reduce(&mut updates);
        let lights = (0..model.patterns().len()).map_while(|i| model.of_light(i));
        let of_all = |light| Arc::new(Sharded::new(light, Arc::clone(&ranks))) as SharedModel;
        let lights = lights.map(of_all).collect();
        Sharded {
            model,
            lights,
            ranks,
            updates: updates[0] as u64,
        }
    }

    /// The dose of all ranks, if they all have theirs.
    fn add_up(&self, done: Result<()>, dose: &mut HostField) -> Result<()> {
        together(self.ranks.as_ref(), done)?;
        self.ranks.all_reduce_f32(dose.as_mut_slice());
        Ok(())
    }
}

impl DoseModel for Sharded {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        self.model.facts()
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        let field = self.model.new_field(space)?;
        Ok(match space {
            Space::Patterns => field.shared(Arc::clone(&self.ranks)),
            Space::Dose => field,
        })
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        self.model.renewal()
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, work: &Work) -> Result<()> {
        let done = self.model.dose(x, dose, work);
        self.add_up(done, dose)
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let mut of_frames = dose.zeros_like();
        let done = self.model.dose_of(frames, x, &mut of_frames, work);
        self.add_up(done, &mut of_frames)?;
        dose.axpy(1.0, &of_frames);
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
        let done = self.model.pullback_of(frames, x, cotangent, grad, work);
        together(self.ranks.as_ref(), done)
    }

    fn along(&self, x: &HostField, d: &HostField, work: &Work) -> Result<Option<Vec<HostField>>> {
        let local = self.model.along(x, d, work);
        let mut curve = together(self.ranks.as_ref(), local)?;
        for coefficient in curve.iter_mut().flatten() {
            self.ranks.all_reduce_f32(coefficient.as_mut_slice());
        }
        Ok(curve)
    }

    fn updates(&self) -> u64 {
        self.updates
    }

    fn of_light(&self, i: usize) -> Option<SharedModel> {
        self.lights.get(i).cloned()
    }

    fn describe(&self) -> String {
        format!(
            "{}; frames over {} ranks",
            self.model.describe(),
            self.ranks.size()
        )
    }
}
