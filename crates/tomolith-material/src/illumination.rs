//! Light of single frames, through a dose model that knows whole exposures.

use crate::Model;
use std::ops::Range;
use tomolith_core::dose::{Quantity, Work, elements_of};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};

/// Refuses a model of other frames than the schedule shows.
pub(crate) fn must_show(found: usize, light: usize, frames: usize) -> Result<()> {
    if found == frames {
        return Ok(());
    }
    Err(Error::config(
        format!("light[{light}].frames"),
        format!("the schedule shows {frames} frames, the patterns have {found}"),
        "as many (times the turns, where every turn has patterns of its own)",
    ))
}

/// The factor of a pattern value that multiplies its energy.
pub(crate) fn factor(quantity: Quantity, energy: f64) -> f32 {
    match quantity {
        Quantity::Energy => energy as f32,
        Quantity::Amplitude => energy.sqrt() as f32,
    }
}

/// Patterns as strong as they shine in a block, and what they leave.
pub(crate) struct Illumination {
    lit: HostField,
    absorbed: HostField,
    /// What the frames of a cotangent get, for [`pull`](Self::pull).
    back: HostField,
    /// Frames whose gradient the caller wants.
    wanted: Range<usize>,
    is_dark: bool,
}

impl Illumination {
    pub(crate) fn new(model: &Model) -> Result<Self> {
        Ok(Illumination {
            lit: model.new_patterns()?,
            absorbed: model.new_dose()?,
            back: HostField::default(),
            wanted: 0..0,
            is_dark: true,
        })
    }

    /// Only these frames get a gradient.
    pub(crate) fn with_wanted(mut self, frames: Range<usize>) -> Self {
        self.wanted = frames;
        self
    }

    /// Energy of these frames, mJ/mm³, `lit` with mJ/mm² of a pattern value of 1.
    pub(crate) fn absorb(
        &mut self,
        model: &Model,
        x: &HostField,
        lit: &[(usize, f64)],
        work: &Work,
    ) -> Result<()> {
        self.is_dark = lit.is_empty();
        if self.is_dark {
            return Ok(());
        }
        self.light(model, x, lit);
        self.absorbed.fill(0.0);
        for neighbors in lit.chunk_by(|a, b| b.0 == a.0 + 1) {
            let frames = neighbors[0].0..neighbors[neighbors.len() - 1].0 + 1;
            model.dose_of(frames, &self.lit, &mut self.absorbed, &work.aside())?;
        }
        Ok(())
    }

    fn light(&mut self, model: &Model, x: &HostField, lit: &[(usize, f64)]) {
        for &(frame, energy) in lit {
            for (range, quantity) in elements_of(model.patterns(), &(frame..frame + 1)) {
                let factor = factor(quantity, energy);
                let from = &x.as_slice()[range.clone()];
                let to = &mut self.lit.as_mut_slice()[range];
                to.iter_mut()
                    .zip(from)
                    .for_each(|(to, from)| *to = factor * from);
            }
        }
    }

    /// What was absorbed last; empty in the dark.
    pub(crate) fn absorbed(&self) -> &[f32] {
        if self.is_dark {
            &[]
        } else {
            self.absorbed.as_slice()
        }
    }

    /// grad += the transpose of [`absorb`](Self::absorb) on a cotangent, for the frames that are wanted of those that shine.
    pub(crate) fn pull(
        &mut self,
        model: &Model,
        x: &HostField,
        lit: &[(usize, f64)],
        cotangent: &HostField,
        grad: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        if self.back.is_empty() {
            self.back = model.new_patterns()?;
        }
        self.light(model, x, lit);
        for neighbors in lit.chunk_by(|a, b| b.0 == a.0 + 1) {
            let first = neighbors[0].0.max(self.wanted.start);
            let end = (neighbors[neighbors.len() - 1].0 + 1).min(self.wanted.end);
            if first < end {
                let frames = first..end;
                model.pullback_of(frames, &self.lit, cotangent, &mut self.back, &work.aside())?;
            }
        }
        let is_wanted = |(frame, _): &&(usize, f64)| self.wanted.contains(frame);
        for &(frame, energy) in lit.iter().filter(is_wanted) {
            for (range, quantity) in elements_of(model.patterns(), &(frame..frame + 1)) {
                let factor = factor(quantity, energy);
                let from = &self.back.as_slice()[range.clone()];
                grad[range]
                    .iter_mut()
                    .zip(from)
                    .for_each(|(to, from)| *to += factor * from);
            }
        }
        Ok(())
    }
}
