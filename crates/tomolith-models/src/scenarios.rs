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
use crate::several::{self, Several};
use std::sync::Arc;
use tomolith_core::dose::form::Joint;
use tomolith_core::dose::{DoseLayout, Space};
use tomolith_core::error::{Error, Result};

/// The first model and how the dose may differ from it. Each model has one output, on the same voxels, and lights of the same pixels.
///
/// # Errors
/// [`Error::Unsupported`] for models that do not fit the first one.
pub fn joined(first: SharedModel, others: Vec<HostModel>) -> Result<Several> {
    let mut models = vec![first];
    models.extend(others.into_iter().map(SharedModel::from));
    let refuse = |reason: &str| Error::unsupported("a scenario", reason);
    let mut outputs: Vec<DoseLayout> = Vec::with_capacity(models.len());
    for model in &models {
        let [layout] = model.outputs() else {
            return Err(refuse("its model has several outputs"));
        };
        let is_same = |other: &DoseLayout| other.grid == layout.grid && other.len() == layout.len();
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
            ..layout.clone()
        });
    }
    let one = |row: usize| {
        (0..models.len())
            .map(|k| f32::from(u8::from(k == row)))
            .collect()
    };
    let patterns = models[0].patterns().to_vec();
    let shown = |model: &SharedModel| several::shown(&patterns, model.patterns());
    let joint = Joint {
        matrix: (0..models.len()).map(one).collect(),
        lit: vec![0..patterns.len(); models.len()],
        shown: models.iter().map(shown).collect(),
        pixels: models
            .iter()
            .map(|model| model.facts().len(Space::Patterns))
            .collect(),
        outputs,
        describe: |scenarios, models| format!("{scenarios} scenarios, the job: {}", models[0]),
        patterns,
    };
    Several::new(models, Arc::new(joint))
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

    fn scenarios() -> Several {
        let [job, others @ ..] = models();
        joined(job.into(), others.into()).unwrap()
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
            let mut patterns = model.new_patterns().unwrap();
            model.patterns()[0].fill_field(&images, patterns.as_mut_slice());
            let q = check::dose(&**model, &patterns);
            assert_eq!(q.as_slice(), &dose.as_slice()[layout.range()]);
        }
        assert!(alone[2].new_patterns().unwrap().len() < x.len());
    }

    #[test]
    fn other_images_are_refused() {
        let refused = joined(
            model_of(0.2, 20, None).into(),
            vec![model_of(0.2, 18, None)],
        );
        assert!(matches!(refused.map(drop), Err(Error::Unsupported { .. })));
    }
}
