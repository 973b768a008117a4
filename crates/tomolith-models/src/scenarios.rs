//! One set of patterns under several scenarios: a vial that is a little wider, a resin that absorbs a little more, an axis that is off.
//!
//! **What it models.** The same images are shown whatever the machine does, and each scenario makes its own dose of them: one output per
//! scenario, all of one field.
//!
//! **Equation** with F_k the dose of scenario k and c its part of the cotangent
//!
//! ```text
//! F(x) = ( F_1(x), F_2(x), … )        F′(x)ᵀ c = Σ_k F_k′(x)ᵀ c_k
//! ```
//!
//! **Shapes** patterns are those of the first model; a pixel that it leaves out stays dark in all scenarios. The others should have every
//! pixel that the first one has: one that they leave out lights nothing there. **Cost** the calls of all models, a copy of the patterns and
//! of a dose for each, one after the other.

use crate::HostModel;
use crate::several;
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::{DoseLayout, DoseModel, PatternLayout, Run, ZCoupling};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};

/// A model that others share.
pub type SharedModel = Arc<dyn DoseModel<Field = HostField>>;

/// Several models of the same images; see the [module](self).
pub struct Scenarios {
    models: Vec<SharedModel>,
    outputs: Vec<DoseLayout>,
}

impl Scenarios {
    /// The first model and how the dose may differ from it. Each model has one output, on the same voxels, and lights of the same pixels.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for models that do not fit the first one.
    pub fn new(first: SharedModel, others: Vec<HostModel>) -> Result<Self> {
        let mut models = vec![first];
        models.extend(others.into_iter().map(SharedModel::from));
        let refuse = |reason: &str| Error::Unsupported {
            what: "a scenario".to_owned(),
            reason: reason.to_owned(),
        };
        let mut outputs: Vec<DoseLayout> = Vec::with_capacity(models.len());
        for model in &models {
            let [own] = model.outputs() else {
                return Err(refuse("its model has several outputs"));
            };
            let is_same = |other: &DoseLayout| other.grid == own.grid && other.len() == own.len();
            if !outputs.first().is_none_or(is_same) {
                return Err(refuse("its voxels are not those of the job"));
            }
            let images = |model: &SharedModel| -> Vec<_> {
                let lights = model.patterns().iter();
                lights.map(|p| (p.grid.shape(), p.quantity)).collect()
            };
            if images(model) != images(&models[0]) {
                return Err(refuse("its lights have other pixels or frames"));
            }
            let offset = outputs.last().map_or(0, |last| last.range().end);
            outputs.push(DoseLayout {
                offset,
                ..own.clone()
            });
        }
        Ok(Scenarios { models, outputs })
    }

    /// The patterns as model `k` has them.
    fn shown(&self, k: usize, x: &HostField) -> Result<HostField> {
        if k == 0 {
            return Ok(x.clone());
        }
        let mut own = self.models[k].new_patterns()?;
        let layouts = self.models[0].patterns().iter();
        for (from, to) in layouts.zip(self.models[k].patterns()) {
            each_common(from, to, |from, to| {
                own.as_mut_slice()[to].copy_from_slice(&x.as_slice()[from]);
            });
        }
        Ok(own)
    }

    /// grad += what model `k` has of the gradient.
    fn gather(&self, k: usize, own: &HostField, grad: &mut HostField) {
        let layouts = self.models[0].patterns().iter();
        for (to, from) in layouts.zip(self.models[k].patterns()) {
            each_common(to, from, |to, from| {
                let pixels = grad.as_mut_slice()[to].iter_mut();
                pixels
                    .zip(&own.as_slice()[from])
                    .for_each(|(grad, own)| *grad += own);
            });
        }
    }

    /// The block of output `k`.
    fn block(&self, k: usize, field: &HostField) -> HostField {
        HostField::from_slice(&field.as_slice()[self.outputs[k].range()])
    }

    /// field_k += q
    fn add(&self, k: usize, q: &HostField, field: &mut HostField) {
        let block = field.as_mut_slice()[self.outputs[k].range()].iter_mut();
        block.zip(q.as_slice()).for_each(|(sum, q)| *sum += q);
    }
}

/// Runs of pixels that two layouts of the same images both have, in the fields of either.
fn each_common(
    a: &PatternLayout,
    b: &PatternLayout,
    mut with: impl FnMut(Range<usize>, Range<usize>),
) {
    for (a, b) in a.runs.iter().zip(&b.runs) {
        let begin = a.bottom.max(b.bottom);
        let end = (a.bottom + a.count).min(b.bottom + b.count);
        if begin < end {
            let of = |offset: usize, bottom: u32| {
                offset + (begin - bottom) as usize..offset + (end - bottom) as usize
            };
            with(of(a.offset, a.bottom), of(b.offset, b.bottom));
        }
    }
}

impl DoseModel for Scenarios {
    type Field = HostField;

    fn patterns(&self) -> &[PatternLayout] {
        self.models[0].patterns()
    }

    fn outputs(&self) -> &[DoseLayout] {
        &self.outputs
    }

    fn new_patterns(&self) -> Result<HostField> {
        self.models[0].new_patterns()
    }

    fn new_dose(&self) -> Result<HostField> {
        let end = self.outputs.last().map_or(0, |last| last.range().end);
        Ok(HostField::zeros(end))
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, run: &Run) -> Result<()> {
        let mut q = self.models[0].new_dose()?;
        for (k, model) in self.models.iter().enumerate() {
            model.dose(
                &self.shown(k, x)?,
                &mut q,
                &several::part(&self.models, run),
            )?;
            dose.as_mut_slice()[self.outputs[k].range()].copy_from_slice(q.as_slice());
        }
        Ok(())
    }

    fn pullback(
        &self,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        grad.fill(0.0);
        for (k, model) in self.models.iter().enumerate() {
            let mut own = model.new_patterns()?;
            let (shown, c) = (self.shown(k, x)?, self.block(k, cotangent));
            model.pullback(&shown, &c, &mut own, &several::part(&self.models, run))?;
            self.gather(k, &own, grad);
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
        for (k, model) in self.models.iter().enumerate() {
            let mut q = model.new_dose()?;
            model.dose_of(frames.clone(), &self.shown(k, x)?, &mut q, run)?;
            self.add(k, &q, dose);
        }
        Ok(())
    }

    fn along(&self, x: &HostField, d: &HostField, run: &Run) -> Result<Option<Vec<HostField>>> {
        let own = |k: usize| Ok([self.shown(k, x)?, self.shown(k, d)?]);
        let add = |k: usize, q: &HostField, sum: &mut HostField| self.add(k, q, sum);
        several::along(&self.models, own, || self.new_dose(), add, run)
    }

    fn z_coupling(&self) -> ZCoupling {
        several::z_coupling(&self.models)
    }

    fn is_linear(&self) -> bool {
        several::is_linear(&self.models)
    }

    fn renew(&self, iteration: usize, x: &HostField, run: &Run) -> Result<bool> {
        several::renew(&self.models, iteration, |k| self.shown(k, x), run)
    }

    fn is_renewed(&self) -> bool {
        several::is_renewed(&self.models)
    }

    fn updates(&self) -> u64 {
        several::updates(&self.models)
    }

    fn describe(&self) -> String {
        let models = self.models.len();
        format!("{models} scenarios, the job: {}", self.models[0].describe())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parallel::Parallel;
    use tomolith_core::check;
    use tomolith_core::grid::{PatternGrid, VolumeGrid};
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    fn model_of(absorption: f64, columns: usize, rows: Option<(u32, u32)>) -> HostModel {
        let pixels = PatternGrid::full_turn(6, 0.1, 12, columns, 0.1);
        let mut light = Light::new(pixels, Resin::absorbing(1.48, absorption));
        light.active = rows.map(|rows| vec![rows; 6 * columns]);
        let grid = VolumeGrid::centered([10, 14, 14], 0.1);
        let vial = IndexMatched { radius_mm: 2.0 };
        Box::new(Parallel::new(&vial, vec![light], grid).unwrap())
    }

    /// The job; more absorption; one in which the outer rows light nothing.
    fn models() -> [HostModel; 3] {
        [
            model_of(0.2, 20, None),
            model_of(0.4, 20, None),
            model_of(0.2, 20, Some((3, 7))),
        ]
    }

    fn scenarios() -> Scenarios {
        let [job, others @ ..] = models();
        Scenarios::new(job.into(), others.into()).unwrap()
    }

    #[test]
    fn it_is_a_linear_model_with_its_adjoint() {
        check::model::model(&scenarios(), 11).unwrap();
    }

    #[test]
    fn each_output_is_the_dose_of_the_same_images_in_its_scenario() {
        let (joint, run) = (scenarios(), Run::new());
        let mut x = joint.new_patterns().unwrap();
        let values: Vec<f32> = check::noise(3, x.len()).iter().map(|n| 1.0 + n).collect();
        x.copy_from_host(&values);
        let mut dose = joint.new_dose().unwrap();
        joint.dose(&x, &mut dose, &run).unwrap();
        let images = joint.patterns()[0].patterns_of(x.as_slice());
        let alone = models();
        for (model, layout) in alone.iter().zip(joint.outputs()) {
            let mut own = model.new_patterns().unwrap();
            model.patterns()[0].fill_field(&images, own.as_mut_slice());
            let mut q = model.new_dose().unwrap();
            model.dose(&own, &mut q, &run).unwrap();
            assert_eq!(q.as_slice(), &dose.as_slice()[layout.range()]);
        }
        assert!(alone[2].new_patterns().unwrap().len() < x.len());
    }

    #[test]
    fn other_images_are_refused() {
        let refused = Scenarios::new(
            model_of(0.2, 20, None).into(),
            vec![model_of(0.2, 18, None)],
        );
        assert!(matches!(refused.map(drop), Err(Error::Unsupported { .. })));
    }
}
