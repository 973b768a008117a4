//! Several models that act as one: a sum over lights ([`spectral`](super::spectral)), or the same light under several scenarios
//! ([`scenarios`](super::scenarios)), wherever their fields live.
//!
//! Each model has its patterns, which are those of some of the joint lights, and its dose q. The joint doses are r = M q, with a row of M per
//! output and a column per model.

use crate::{DoseModel, PatternLayout, Work, ZCoupling, elements_of, frames_of};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::form::{Form, Joint};
use tomolith_core::dose::layout::PixelRun;
use tomolith_core::dose::{Facts, Renewal, Space};
use tomolith_core::error::Result;
use tomolith_core::field::scratch::Scratch;
use tomolith_core::field::{Field, HostField, Stretch};

/// A model that others share.
pub type SharedModel<F = HostField> = Arc<dyn DoseModel<Field = F>>;

/// Models that act as one; see the [module](self).
pub struct Several<F = HostField> {
    pub(crate) models: Vec<SharedModel<F>>,
    pub(crate) joint: Arc<Joint>,
    /// A field without elements, where theirs live.
    like: F,
    /// The dose of a model.
    scratch: Scratch<F>,
}

/// Pixels that joint lights and those of a model both have, as few stretches.
pub(crate) fn shown(joint: &[PatternLayout], single: &[PatternLayout]) -> Vec<Stretch> {
    let runs = |layouts: &'_ [PatternLayout]| -> Vec<PixelRun> {
        layouts
            .iter()
            .flat_map(|l| l.runs.iter().copied())
            .collect()
    };
    let mut parts: Vec<Stretch> = Vec::new();
    for (joint, single) in runs(joint).iter().zip(&runs(single)) {
        let begin = joint.bottom.max(single.bottom);
        let end = (joint.bottom + joint.count).min(single.bottom + single.count);
        if begin >= end {
            continue;
        }
        let place = |run: &PixelRun| run.offset + (begin - run.bottom) as usize;
        let next = Stretch {
            to: place(single),
            from: place(joint),
            count: (end - begin) as usize,
        };
        match parts.last_mut() {
            Some(last)
                if [last.to + last.count, last.from + last.count] == [next.to, next.from] =>
            {
                last.count += next.count;
            }
            _ => parts.push(next),
        }
    }
    parts
}

/// The other way.
fn back(part: &Stretch) -> Stretch {
    Stretch {
        to: part.from,
        from: part.to,
        count: part.count,
    }
}

impl<F: Field> Several<F> {
    /// Models, one at least, that act as one in this way.
    ///
    /// # Errors
    /// Not enough memory.
    pub fn new(models: Vec<SharedModel<F>>, joint: Arc<Joint>) -> Result<Self> {
        let q = models[0].new_dose()?;
        let nothing = Facts {
            patterns: &[],
            outputs: &[],
            ..models[0].facts()
        };
        let like = q.zeros_of(&nothing, Space::Patterns);
        let scratch = Scratch::default();
        scratch.give_back(q);
        Ok(Several {
            models,
            joint,
            like,
            scratch,
        })
    }

    /// The part of a run that one of the models has.
    fn part(&self, work: &Work) -> Work {
        work.part(1.0 / self.models.len() as f64)
    }

    /// The models that show some of the joint frames, and which of their own frames these are.
    fn parts(&self, frames: &Range<usize>) -> impl Iterator<Item = (usize, Range<usize>)> {
        let patterns = &self.joint.patterns;
        let of_model = |(k, lit): (usize, &Range<usize>)| {
            let first = frames_of(&patterns[..lit.start]);
            let end = first + frames_of(&patterns[lit.clone()]);
            let local =
                frames.start.clamp(first, end) - first..frames.end.clamp(first, end) - first;
            (!local.is_empty()).then_some((k, local))
        };
        self.joint.lit.iter().enumerate().filter_map(of_model)
    }

    /// The patterns of a model: the joint ones where it has the same, and where they do not matter, which is when they are empty.
    pub(crate) fn shown<'x>(&self, k: usize, x: &'x F) -> Result<Cow<'x, F>> {
        let (parts, pixels) = (&self.joint.shown[k], self.joint.pixels[k]);
        let is_all = |part: &Stretch| [part.count, pixels] == [x.len(); 2];
        if x.is_empty() || (parts.len() == 1 && is_all(&parts[0])) {
            return Ok(Cow::Borrowed(x));
        }
        let mut patterns = self.models[k].new_patterns()?;
        patterns.set_stretches(false, 1.0, x, parts);
        Ok(Cow::Owned(patterns))
    }

    /// grad += the gradient of a model: the transpose of [`shown`](Self::shown).
    fn gather(&self, k: usize, found: &F, grad: &mut F) {
        let parts: Vec<Stretch> = self.joint.shown[k].iter().map(back).collect();
        grad.set_stretches(true, 1.0, found, &parts);
    }

    /// Where an output lies in the joint doses, and the dose of a model.
    fn place(&self, output: usize) -> Stretch {
        let range = self.joint.outputs[output].range();
        Stretch {
            to: range.start,
            from: 0,
            count: range.len(),
        }
    }

    /// Every output that a model drives, and what its dose counts there.
    fn driven(&self, k: usize) -> impl Iterator<Item = (usize, f32)> {
        let rows = self.joint.matrix.iter().enumerate();
        let all = rows.map(move |(output, row)| (output, row[k]));
        all.filter(|(_, m)| *m != 0.0)
    }

    /// doses += M_·k q
    fn add(&self, k: usize, q: &F, doses: &mut F) {
        for (output, m) in self.driven(k) {
            doses.set_stretches(true, m, q, &[self.place(output)]);
        }
    }

    /// What comes of a field for the dose of a model.
    fn lend<R>(&self, with: impl FnOnce(&mut F) -> Result<R>) -> Result<R> {
        let len = self.joint.outputs[0].range().len();
        let mut q = match self.scratch.take(len) {
            Some(q) => q,
            None => self.models[0].new_dose()?,
        };
        let found = with(&mut q);
        self.scratch.give_back(q);
        found
    }

    /// c ← M_·kᵀ cotangent
    fn split(&self, k: usize, cotangent: &F, c: &mut F) {
        let mut driven = self.driven(k);
        match driven.next() {
            Some((output, m)) => c.set_stretches(false, m, cotangent, &[back(&self.place(output))]),
            None => c.fill(0.0),
        }
        for (output, m) in driven {
            c.set_stretches(true, m, cotangent, &[back(&self.place(output))]);
        }
    }
}

impl<F: Field> Renewal<F> for Several<F> {
    fn renew(&self, iteration: usize, x: &F, work: &Work) -> Result<bool> {
        let mut any = false;
        for (k, model) in self.models.iter().enumerate() {
            if let Some(model) = model.renewal() {
                any |= model.renew(iteration, &*self.shown(k, x)?, work)?;
            }
        }
        Ok(any)
    }
}

impl<F: Field> DoseModel for Several<F> {
    type Field = F;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.joint.patterns,
            outputs: &self.joint.outputs,
            z_coupling: ZCoupling::widest(self.models.iter().map(|model| model.z_coupling())),
            is_linear: self.models.iter().all(|model| model.is_linear()),
        }
    }

    fn new_field(&self, space: Space) -> Result<F> {
        let field = self.like.zeros_of(&self.facts(), space);
        field.check().map(|()| field)
    }

    fn dose(&self, x: &F, dose: &mut F, work: &Work) -> Result<()> {
        let mut is_new = vec![true; self.joint.outputs.len()];
        self.lend(|q| {
            for (k, model) in self.models.iter().enumerate() {
                model.dose(&*self.shown(k, x)?, q, &self.part(work))?;
                for (output, m) in self.driven(k) {
                    let adds = !std::mem::take(&mut is_new[output]);
                    dose.set_stretches(adds, m, q, &[self.place(output)]);
                }
            }
            // What no light drives
            let undriven = self.joint.outputs.iter().zip(&is_new);
            let undriven = undriven.filter(|(_, is_new)| **is_new);
            undriven.for_each(|(output, _)| dose.clear(output.range()));
            Ok(())
        })
    }

    fn dose_of(&self, frames: Range<usize>, x: &F, dose: &mut F, work: &Work) -> Result<()> {
        self.lend(|q| {
            for (k, local) in self.parts(&frames) {
                q.fill(0.0);
                self.models[k].dose_of(local, &*self.shown(k, x)?, q, &self.part(work))?;
                self.add(k, q, dose);
            }
            Ok(())
        })
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &F,
        cotangent: &F,
        grad: &mut F,
        work: &Work,
    ) -> Result<()> {
        elements_of(&self.joint.patterns, &frames).for_each(|(range, _)| grad.clear(range));
        self.lend(|c| {
            for (k, local) in self.parts(&frames) {
                self.split(k, cotangent, c);
                let (model, part) = (&self.models[k], self.part(work));
                let mut found = model.new_patterns()?;
                model.pullback_of(local, &*self.shown(k, x)?, c, &mut found, &part)?;
                self.gather(k, &found, grad);
            }
            Ok(())
        })
    }

    /// The joint dose, power by power; None where one of the models has none.
    fn along(&self, x: &F, d: &F, work: &Work) -> Result<Option<Vec<F>>> {
        let mut all: Vec<F> = Vec::new();
        for (k, model) in self.models.iter().enumerate() {
            let [x, d] = [self.shown(k, x)?, self.shown(k, d)?];
            let Some(powers) = model.along(&x, &d, work)? else {
                return Ok(None);
            };
            for (power, q) in powers.iter().enumerate() {
                if power == all.len() {
                    all.push(self.new_dose()?);
                }
                self.add(k, q, &mut all[power]);
            }
        }
        Ok(Some(all))
    }

    fn renewal(&self) -> Option<&dyn Renewal<F>> {
        let renewed = self.models.iter().any(|model| model.renewal().is_some());
        renewed.then_some(self as _)
    }

    fn updates(&self) -> u64 {
        self.models.iter().map(|model| model.updates()).sum()
    }

    fn of_light(&self, i: usize) -> Option<SharedModel<F>> {
        let lit = &self.joint.lit;
        let is_alone = lit.iter().filter(|lit| lit.contains(&i)).count() == 1;
        let mut models = self.models.iter().zip(lit);
        let model = models.find(|(_, lit)| is_alone && **lit == (i..i + 1));
        model.map(|(model, _)| model.clone())
    }

    /// None where one of the models has none.
    fn form(&self) -> Option<Form> {
        let forms = self.models.iter().map(|model| model.form());
        let forms: Option<Vec<Form>> = forms.collect();
        Some(Form::Joint(forms?, self.joint.clone()))
    }

    fn describe(&self) -> String {
        let models: Vec<String> = self.models.iter().map(|model| model.describe()).collect();
        (self.joint.describe)(self.joint.outputs.len(), &models)
    }
}
