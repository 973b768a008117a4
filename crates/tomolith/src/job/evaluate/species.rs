//! The species of a job beside the first: what each prints, and its headline number at every step on the way there.

use crate::error::Result;
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::job::evaluate::{averaged, headline_of, measure};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::metrics::{Evaluation, Measure};
use crate::models::Run;

/// The headline number of a species before the print that is evaluated: None where it was not measured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Steps {
    /// Patterns as they were optimized, on the optimization's grid.
    pub(crate) optimized: Measure,
    /// Patterns as they were written, on the same grid.
    pub(crate) written: Measure,
    /// On the finer grid, the vial standing still during each frame.
    pub(crate) standing: Measure,
}

/// The print of a species beside the first: written patterns, turning vial, finer grid.
pub(crate) struct Species {
    pub(crate) evaluation: Evaluation,
    /// What led there.
    pub(crate) steps: Steps,
    /// Its dose, averaged to the optimization's voxels.
    pub(crate) dose: Volume<f32>,
    /// Its target on the finer grid.
    pub(crate) fine: Voxels,
    /// Its response there.
    pub(crate) response: Volume<f32>,
}

/// Targets of the species beside the first, on a grid.
pub(crate) fn voxels(job: &ResolvedJob, grid: &VolumeGrid, run: &Run) -> Result<Vec<Voxels>> {
    let others = job.others.iter();
    others
        .map(|other| other.voxels_under(grid, &run.aside()))
        .collect()
}

/// Measures the species beside the first while the first is measured.
pub(crate) struct Others<'a> {
    job: &'a ResolvedJob,
    steps: Vec<Steps>,
}

impl<'a> Others<'a> {
    pub(crate) fn new(job: &'a ResolvedJob) -> Self {
        let steps = vec![Steps::default(); job.others.len()];
        Others { job, steps }
    }

    /// Notes the doses of patterns as they were optimized, on the optimization's grid.
    pub(crate) fn optimized(
        &mut self,
        voxels: &[Voxels],
        doses: Vec<Volume<f32>>,
        run: &Run,
    ) -> Result<()> {
        self.note(voxels, doses, run, |steps| &mut steps.optimized)
    }

    /// Notes those of written patterns on the same grid.
    pub(crate) fn written(
        &mut self,
        voxels: &[Voxels],
        doses: Vec<Volume<f32>>,
        run: &Run,
    ) -> Result<()> {
        self.note(voxels, doses, run, |steps| &mut steps.written)
    }

    /// Notes those of written patterns on the finer grid, standing still.
    pub(crate) fn standing(
        &mut self,
        fine: &[Voxels],
        doses: Vec<Volume<f32>>,
        run: &Run,
    ) -> Result<()> {
        self.note(fine, doses, run, |steps| &mut steps.standing)
    }

    fn note(
        &mut self,
        voxels: &[Voxels],
        doses: Vec<Volume<f32>>,
        run: &Run,
        step: impl Fn(&mut Steps) -> &mut Measure,
    ) -> Result<()> {
        let scenes = self.job.others.iter().zip(voxels).zip(doses);
        for (steps, ((job, voxels), dose)) in self.steps.iter_mut().zip(scenes) {
            *step(steps) = headline_of(job, voxels, dose, run.aside())?;
        }
        Ok(())
    }

    /// What is printed in the end: the doses of written patterns on the finer grid while the vial turns.
    pub(crate) fn turning(
        self,
        fine: Vec<Voxels>,
        doses: Vec<Volume<f32>>,
        shown: &[Patterns],
        run: &Run,
    ) -> Result<Vec<Species>> {
        let scenes = self.job.others.iter().zip(fine).zip(doses);
        let evaluated =
            |(steps, ((job, fine), dose)): (Steps, ((&ResolvedJob, Voxels), Volume<f32>))| {
                let mean = averaged(&dose, &job.grid);
                let response = job.responses(dose);
                let evaluation = measure(job, &fine, &response, shown, run.aside())?;
                Ok(Species {
                    evaluation: evaluation.with_sub_angles(job.evaluated_angles()),
                    steps,
                    dose: mean,
                    fine,
                    response,
                })
            };
        self.steps.into_iter().zip(scenes).map(evaluated).collect()
    }
}
