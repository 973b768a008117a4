//! What each of several objectives comes to: its loss, and the errors of its response, on the optimization's voxels.

use crate::error::Result;
use crate::field::HostField;
use crate::grid::Volume;
use crate::job::resolve::goal::JobObjective;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::metrics::gray::gray_errors;
use crate::models::DoseLayout;
use crate::objective::ObjectiveInput;
use crate::objective::voxel_weights::Ground;
use crate::report::ObjectiveReport;
use crate::target::label;
use tomolith_core::parallel::elements;

/// Every entry of a job's `objectives`, one after the other; none of a job with `objective`.
pub(crate) fn measured(
    job: &ResolvedJob,
    voxels: &Voxels,
    dose: &Volume<f32>,
) -> Result<Vec<ObjectiveReport>> {
    if !job.first().goal.is_list() {
        return Ok(Vec::new());
    }
    let layout = DoseLayout::new("dose", dose.grid.clone(), 0);
    let on = On {
        job,
        voxels,
        dose,
        layout: &layout,
    };
    let objectives = job.first().goal.objectives().iter();
    objectives.map(|objective| on.report(objective)).collect()
}

/// A dose, and where it lies.
struct On<'a> {
    job: &'a ResolvedJob,
    voxels: &'a Voxels,
    dose: &'a Volume<f32>,
    layout: &'a DoseLayout,
}

impl On<'_> {
    fn report(&self, objective: &JobObjective) -> Result<ObjectiveReport> {
        let labels = self.labels(objective)?;
        let counted = labels.iter().filter(|label| **label != label::OUTSIDE);
        let voxels = counted.count() as u64;
        let gray = &self.voxels.target;
        let errors = gray.gray.then(|| {
            let response = self.response(objective);
            gray_errors(&labels, &response, &gray.inside.values, 0.0)
        });
        let errors = errors.flatten();
        Ok(ObjectiveReport {
            key: objective.key.clone(),
            weight: objective.common.weight,
            loss: self.loss(objective)?.filter(|loss| loss.is_finite()),
            voxels,
            rms_error: errors.map(|errors| errors.rms),
            max_error: errors.and_then(|e| e.largest.into_iter().flatten().reduce(f64::max)),
        })
    }

    /// Its loss without its factor in the sum; None where a dose per voxel does not tell it.
    fn loss(&self, objective: &JobObjective) -> Result<Option<f64>> {
        if objective.has_cells() || self.job.is_optimized_in_time() {
            return Ok(None);
        }
        let input = ObjectiveInput {
            layout: self.layout,
            labels: &self.voxels.labels,
            target: &self.voxels.target,
            response: self.job.first().goal.response.clone(),
        };
        let built = objective.build(&input, &self.job.base, true)?;
        let dose = HostField::from_slice(&self.layout.field_of(self.dose));
        Ok(Some(built.value(&dose)))
    }

    /// Labels of the voxels that count for it; all others are outside.
    fn labels(&self, objective: &JobObjective) -> Result<Vec<u8>> {
        let ground = Ground {
            layout: self.layout,
            labels: &self.voxels.labels,
            target: &self.voxels.target,
            base: &self.job.base,
        };
        let mut labels = self.voxels.labels.values.clone();
        let weight = objective.common.voxel_weights(&ground)?.weight;
        if !weight.is_empty() {
            let weight = self.layout.volume_of(&weight).values;
            elements(&mut labels, |i, label| {
                if weight[i] == 0.0 {
                    *label = label::OUTSIDE;
                }
            });
        }
        Ok(labels)
    }

    fn response(&self, objective: &JobObjective) -> Vec<f32> {
        let mut values = self.dose.values.clone();
        if !objective.response.is_identity() {
            elements(&mut values, |_, value| {
                *value = objective.response.value(*value)
            });
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::job_of;
    use crate::models::Work;

    /// 4 × 4 voxels of 1 mm, whose centers are 0.71, 1.58 and 2.12 mm from the axis, all of gray value 0.
    fn square(objectives: &str) -> (ResolvedJob, Voxels) {
        let text = format!(
            r#"
            target = {{ phantom = {{ gratings = {{ size_mm = 2.0, height_mm = 1.0 }} }} }}
            grid = {{ pitch_mm = 1.0, shape = [4, 4, 1] }}
            resin = {{ refractive_index = 1.5, pure_radon = true }}
            vial = {{ index_matched = {{ radius_mm = 4.0 }} }}
            light = [{{ pixels = [8, 1], angles = 12, projector = {{ collimated = {{ pixel_pitch_mm = 1.0 }} }} }}]
            {objectives}
            "#
        );
        let job = ResolvedJob::under(&job_of(&text, &[]), &Work::new()).unwrap();
        let mut voxels = job.voxels(&job.grid, &Work::new()).unwrap().remove(0);
        voxels.target.gray = true;
        voxels.target.inside.values.fill(0.0);
        voxels.labels.values.fill(label::VOID);
        (job, voxels)
    }

    #[test]
    fn losses_and_errors_are_those_of_the_region_without_weights_and_factors() {
        let (job, voxels) = square(
            r#"
            [[objectives]]
            bclp = { epsilon = 0.1, p = 2, q = 1 }
            region = { radius_mm = [0.0, 1.0] }
            weight = 3.0
            [[objectives]]
            bclp = { epsilon = 0.0, p = 2, q = 2 }
            region = { radius_mm = [1.0, 2.0] }
            weights = { regions = [{ radius_mm = [0.0, 2.0], value = 2.0 }] }
            weight = 0.0
            "#,
        );
        // 0.5 in the four inner voxels; 0.25 in seven of the eight about them, 0.75 in the last; 9 in the corners
        let mut dose = Volume::filled(job.grid.clone(), 0.25f32);
        for (i, value) in dose.values.iter_mut().enumerate() {
            let [x, y] = [i % 4, i / 4].map(|at| at == 0 || at == 3);
            match (x, y) {
                (true, true) => *value = 9.0,
                (false, false) => *value = 0.5,
                _ => {}
            }
        }
        dose.values[1] = 0.75;
        let found = measured(&job, &voxels, &dose).unwrap();
        // √(4·0.4²), √(4·0.5²/4); 2·(7·0.25² + 0.75²), √((7·0.25² + 0.75²)/8)
        let expected = [
            ("objectives[0].bclp", 3.0, 4, [0.8, 0.5, 0.5]),
            ("objectives[1].bclp", 0.0, 8, [2.0, 0.125f64.sqrt(), 0.75]),
        ];
        assert_eq!(found.len(), 2);
        for (report, (key, weight, voxels, numbers)) in found.iter().zip(expected) {
            assert_eq!(
                (report.key.as_str(), report.weight, report.voxels),
                (key, weight, voxels)
            );
            let values = [report.loss, report.rms_error, report.max_error].map(Option::unwrap);
            for (value, number) in values.iter().zip(numbers) {
                assert!((value - number).abs() < 1e-6, "{key}: {value} for {number}");
            }
        }
    }

    #[test]
    fn a_part_has_losses_and_no_gray_errors_and_one_objective_is_no_list() {
        let (job, mut voxels) =
            square("[[objectives]]\nl2 = {}\nregion = { radius_mm = [0.0, 1.0] }");
        voxels.target.gray = false;
        let dose = Volume::filled(job.grid.clone(), 0.5f32);
        let found = measured(&job, &voxels, &dose).unwrap();
        assert_eq!((found[0].voxels, found[0].rms_error), (4, None));
        assert!((found[0].loss.unwrap() - 1.0).abs() < 1e-6); // 4·0.5²
        let (job, voxels) = square("[objective.l2]");
        assert!(measured(&job, &voxels, &dose).unwrap().is_empty());
    }
}
