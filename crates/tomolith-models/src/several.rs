//! Several models that act as one: a sum over lights ([`spectral`](super::spectral)), or the same light under several scenarios
//! ([`scenarios`](super::scenarios)).
//!
//! Each model has its patterns, which are those of some of the joint lights, and its dose q. The joint doses are r = M q, with a row of M per
//! output and a column per model.

use crate::{DoseLayout, DoseModel, PatternLayout, Work, ZCoupling, elements_of, frames_of};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::layout::PixelRun;
use tomolith_core::dose::{Facts, Renewal, Space};
use tomolith_core::error::Result;
use tomolith_core::field::scratch::Scratch;
use tomolith_core::field::{BLOCK, Field, HostField};
use tomolith_core::parallel::InParallel;

/// A model that others share.
pub type SharedModel = Arc<dyn DoseModel<Field = HostField>>;

/// Models that act as one; see the [module](self).
pub struct Several {
    pub(crate) models: Vec<SharedModel>,
    pub(crate) patterns: Vec<PatternLayout>,
    pub(crate) outputs: Vec<DoseLayout>,
    /// M, a row per output.
    pub(crate) matrix: Vec<Vec<f32>>,
    /// Which of the joint lights each model has.
    pub(crate) lit: Vec<Range<usize>>,
    pub(crate) describe: fn(&Several) -> String,
    /// The dose of a model.
    pub(crate) scratch: Scratch,
}

/// sum += m·v
fn add_scaled(sum: &mut [f32], m: f32, v: &[f32]) {
    let blocks = sum.chunks_mut(BLOCK).zip(v.chunks(BLOCK));
    blocks.par_each(|(sum, v)| sum.iter_mut().zip(v).for_each(|(s, &v)| *s += m * v));
}

/// sum ← 0 + m·v
fn set_scaled(sum: &mut [f32], m: f32, v: &[f32]) {
    let blocks = sum.chunks_mut(BLOCK).zip(v.chunks(BLOCK));
    blocks.par_each(|(sum, v)| sum.iter_mut().zip(v).for_each(|(s, &v)| *s = 0.0 + m * v));
}

impl Several {
    /// The part of a run that one of the models has.
    fn part(&self, work: &Work) -> Work {
        work.part(1.0 / self.models.len() as f64)
    }

    /// The models that show some of the joint frames, and which of their own frames these are.
    fn parts(&self, frames: &Range<usize>) -> impl Iterator<Item = (usize, Range<usize>)> {
        let of_model = |(k, lit): (usize, &Range<usize>)| {
            let first = frames_of(&self.patterns[..lit.start]);
            let end = first + frames_of(&self.patterns[lit.clone()]);
            let local =
                frames.start.clamp(first, end) - first..frames.end.clamp(first, end) - first;
            (!local.is_empty()).then_some((k, local))
        };
        self.lit.iter().enumerate().filter_map(of_model)
    }

    /// Runs of pixels that a model has and the joint patterns have, in the joint field and in that of the model.
    fn each_common(&self, k: usize, mut with: impl FnMut(Range<usize>, Range<usize>)) {
        let joint = self.patterns[self.lit[k].clone()].iter();
        let layouts = joint.zip(self.models[k].patterns());
        for (joint, single) in
            layouts.flat_map(|(joint, single)| joint.runs.iter().zip(&single.runs))
        {
            let begin = joint.bottom.max(single.bottom);
            let end = (joint.bottom + joint.count).min(single.bottom + single.count);
            if begin < end {
                let pixels_of = |run: &PixelRun| {
                    let first = run.offset + (begin - run.bottom) as usize;
                    first..first + (end - begin) as usize
                };
                with(pixels_of(joint), pixels_of(single));
            }
        }
    }

    /// The patterns of a model.
    pub(crate) fn shown(&self, k: usize, x: &HostField) -> Result<HostField> {
        let mut patterns = self.models[k].new_patterns()?;
        self.each_common(k, |from, to| {
            patterns.as_mut_slice()[to].copy_from_slice(&x.as_slice()[from]);
        });
        Ok(patterns)
    }

    /// grad += the gradient of a model: the transpose of [`shown`](Self::shown).
    fn gather(&self, k: usize, back: &HostField, grad: &mut HostField) {
        self.each_common(k, |to, from| {
            let pixels = grad.as_mut_slice()[to].iter_mut();
            let back = &back.as_slice()[from];
            pixels.zip(back).for_each(|(grad, back)| *grad += back);
        });
    }

    /// Every output that a model drives, and what its dose counts there.
    fn driven(&self, k: usize) -> impl Iterator<Item = (Range<usize>, f32)> {
        let rows = self.outputs.iter().zip(&self.matrix);
        let all = rows.map(move |(layout, row)| (layout.range(), row[k]));
        all.filter(|(_, m)| *m != 0.0)
    }

    /// doses += M_·k q
    fn add(&self, k: usize, q: &HostField, doses: &mut HostField) {
        for (range, m) in self.driven(k) {
            add_scaled(&mut doses.as_mut_slice()[range], m, q.as_slice());
        }
    }

    /// doses ← M q of all models, each of which writes its q.
    fn join(
        &self,
        doses: &mut HostField,
        mut write: impl FnMut(usize, &mut HostField) -> Result<()>,
    ) -> Result<()> {
        let mut is_new = vec![true; self.outputs.len()];
        self.scratch.lend(self.dose_len(), |q| {
            for k in 0..self.models.len() {
                write(k, q)?;
                for ((layout, row), is_new) in
                    self.outputs.iter().zip(&self.matrix).zip(&mut is_new)
                {
                    let output = &mut doses.as_mut_slice()[layout.range()];
                    match (
                        row[k] != 0.0,
                        std::mem::replace(is_new, *is_new && row[k] == 0.0),
                    ) {
                        (true, true) => set_scaled(output, row[k], q.as_slice()),
                        (true, false) => add_scaled(output, row[k], q.as_slice()),
                        (false, _) => {}
                    }
                }
            }
            Ok(())
        })?;
        let undriven = self
            .outputs
            .iter()
            .zip(is_new)
            .filter(|(_, is_new)| *is_new);
        undriven.for_each(|(layout, _)| doses.as_mut_slice()[layout.range()].fill(0.0));
        Ok(())
    }

    /// Elements of the dose of a model.
    fn dose_len(&self) -> usize {
        self.outputs[0].range().len()
    }

    /// c ← M_·kᵀ cotangent
    fn split(&self, k: usize, cotangent: &HostField, c: &mut HostField) {
        let mut driven = self.driven(k);
        match driven.next() {
            Some((range, m)) => set_scaled(c.as_mut_slice(), m, &cotangent.as_slice()[range]),
            None => c.fill(0.0),
        }
        for (range, m) in driven {
            add_scaled(c.as_mut_slice(), m, &cotangent.as_slice()[range]);
        }
    }
}

impl Renewal<HostField> for Several {
    fn renew(&self, iteration: usize, x: &HostField, work: &Work) -> Result<bool> {
        let mut any = false;
        for (k, model) in self.models.iter().enumerate() {
            if let Some(model) = model.renewal() {
                any |= model.renew(iteration, &self.shown(k, x)?, work)?;
            }
        }
        Ok(any)
    }
}

impl DoseModel for Several {
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

    fn dose(&self, x: &HostField, dose: &mut HostField, work: &Work) -> Result<()> {
        self.join(dose, |k, q| {
            self.models[k].dose(&self.shown(k, x)?, q, &self.part(work))
        })
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        self.scratch.lend(self.dose_len(), |q| {
            for (k, local) in self.parts(&frames) {
                q.fill(0.0);
                self.models[k].dose_of(local, &self.shown(k, x)?, q, &self.part(work))?;
                self.add(k, q, dose);
            }
            Ok(())
        })
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        for (range, _) in elements_of(&self.patterns, &frames) {
            grad.as_mut_slice()[range].fill(0.0);
        }
        self.scratch.lend(self.dose_len(), |c| {
            for (k, local) in self.parts(&frames) {
                self.split(k, cotangent, c);
                let (model, part) = (&self.models[k], self.part(work));
                let mut back = model.new_patterns()?;
                model.pullback_of(local, &self.shown(k, x)?, c, &mut back, &part)?;
                self.gather(k, &back, grad);
            }
            Ok(())
        })
    }

    /// The joint dose, power by power; None where one of the models has none.
    fn along(&self, x: &HostField, d: &HostField, work: &Work) -> Result<Option<Vec<HostField>>> {
        let mut all: Vec<HostField> = Vec::new();
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

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        let renewed = self.models.iter().any(|model| model.renewal().is_some());
        renewed.then_some(self as _)
    }

    fn updates(&self) -> u64 {
        self.models.iter().map(|model| model.updates()).sum()
    }

    fn of_light(&self, i: usize) -> Option<SharedModel> {
        let mut lit = self.models.iter().zip(&self.lit);
        let is_alone = self.lit.iter().filter(|lit| lit.contains(&i)).count() == 1;
        let model = lit.find(|(_, lit)| is_alone && **lit == (i..i + 1));
        model.map(|(model, _)| model.clone())
    }

    fn describe(&self) -> String {
        (self.describe)(self)
    }
}
