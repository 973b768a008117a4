//! One set of patterns under several scenarios: a vial that is a little wider, a resin that absorbs a little more, an axis that is off.
//!
//! **What it models.** The same images are shown whatever the machine does, and each scenario makes another dose of them: one output per
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
pub use crate::several::SharedModel;
use crate::several::{Joint, Several};
use std::ops::Range;
use tomolith_core::dose::{DoseLayout, PatternLayout};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;

/// Several models of the same images; see the [module](self).
pub type Scenarios = Several<SameImages>;

/// The models are lit by the same images, and each has its output.
pub struct SameImages;

impl Scenarios {
    /// The first model and how the dose may differ from it. Each model has one output, on the same voxels, and lights of the same pixels.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for models that do not fit the first one.
    pub fn new(first: SharedModel, others: Vec<HostModel>) -> Result<Self> {
        let mut models = vec![first];
        models.extend(others.into_iter().map(SharedModel::from));
        let refuse = |reason: &str| Error::unsupported("a scenario", reason);
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
        Ok(Several {
            patterns: models[0].patterns().to_vec(),
            models,
            outputs,
            joint: SameImages,
        })
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

impl Joint for SameImages {
    fn parts(all: &Scenarios, frames: &Range<usize>) -> Vec<(usize, Range<usize>)> {
        let models = 0..all.models.len();
        models.map(|k| (k, frames.clone())).collect()
    }

    fn shown(all: &Scenarios, k: usize, x: &HostField) -> Result<HostField> {
        if k == 0 {
            return Ok(x.clone());
        }
        let mut own = all.models[k].new_patterns()?;
        for (from, to) in all.patterns.iter().zip(all.models[k].patterns()) {
            each_common(from, to, |from, to| {
                own.as_mut_slice()[to].copy_from_slice(&x.as_slice()[from]);
            });
        }
        Ok(own)
    }

    fn add(all: &Scenarios, k: usize, q: &HostField, doses: &mut HostField) {
        let block = doses.as_mut_slice()[all.outputs[k].range()].iter_mut();
        block.zip(q.as_slice()).for_each(|(sum, q)| *sum += q);
    }

    fn split(all: &Scenarios, k: usize, cotangent: &HostField, c: &mut HostField) {
        let own = &cotangent.as_slice()[all.outputs[k].range()];
        c.as_mut_slice().copy_from_slice(own);
    }

    /// The gradient of a model is 0 where the caller does not want it.
    fn gather(
        all: &Scenarios,
        k: usize,
        _frames: Range<usize>,
        own: &HostField,
        grad: &mut HostField,
    ) {
        for (to, from) in all.patterns.iter().zip(all.models[k].patterns()) {
            each_common(to, from, |to, from| {
                let pixels = grad.as_mut_slice()[to].iter_mut();
                pixels
                    .zip(&own.as_slice()[from])
                    .for_each(|(grad, own)| *grad += own);
            });
        }
    }

    fn describe(all: &Scenarios) -> String {
        let models = all.models.len();
        format!("{models} scenarios, the job: {}", all.models[0].describe())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parallel::Parallel;
    use tomolith_core::check;
    use tomolith_core::dose::DoseModel;
    use tomolith_core::field::Field;
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
        let joint = scenarios();
        let mut x = joint.new_patterns().unwrap();
        let values: Vec<f32> = check::noise(3, x.len()).iter().map(|n| 1.0 + n).collect();
        x.copy_from_host(&values);
        let dose = check::dose(&joint, &x);
        let images = joint.patterns()[0].patterns_of(x.as_slice());
        let alone = models();
        for (model, layout) in alone.iter().zip(joint.outputs()) {
            let mut own = model.new_patterns().unwrap();
            model.patterns()[0].fill_field(&images, own.as_mut_slice());
            let q = check::dose(&**model, &own);
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
