//! The doses of an evaluation, in the order that takes the least memory.

use super::limits::ENOUGH_BITS;
use super::{headline, objectives, print, share};
use crate::error::Result;
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::job::dose::cache::EvaluationModel;
use crate::job::dose::doses::{Doses, Exposed};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::metrics::print::PatternStats;
use crate::metrics::{Evaluation, Measure, evaluate};
use crate::models::Work;
use crate::report::ObjectiveReport;

/// The headline number of the written patterns on the optimization's voxels.
pub(super) enum OwnPrint {
    /// That of the print that is evaluated, which is the same.
    Evaluated,
    /// Measured apart, of every species.
    Apart(Vec<Measure>),
}

/// The doses of an evaluation, one after the other, each measured before the next takes its memory: on the optimization's voxels as optimized, then
/// turning, then on finer ones turning.
pub(super) struct EvaluationSteps<'a> {
    job: &'a ResolvedJob,
    shown: &'a [Patterns],
    work: &'a Work,
    /// The finer voxels.
    pub(super) grid: VolumeGrid,
    as_optimized: Exposed,
    own_turning: Exposed,
    turning: Exposed,
    doses: Doses<'a>,
}

impl<'a> EvaluationSteps<'a> {
    pub(super) fn new(
        job: &'a ResolvedJob,
        shown: &'a [Patterns],
        evaluation_model: Option<&'a EvaluationModel>,
        work: &'a Work,
    ) -> Self {
        let grid = job.fine_grid();
        let [own_turning, turning] = [&job.grid, &grid]
            .map(|grid| Exposed::new(grid, job.optics.lights_turning(&job.evaluated_angles)));
        EvaluationSteps {
            job,
            shown,
            work,
            as_optimized: Exposed::new(&job.grid, job.optics.lights.clone()),
            grid,
            own_turning,
            turning,
            doses: Doses::new(job, &job.optics).by(evaluation_model),
        }
    }

    pub(super) fn words(&self) -> String {
        let [nz, ny, nx] = self.grid.shape;
        let how = match self.job.most_evaluated_angles() {
            1 => "the vial stands still during each frame".to_owned(),
            n => format!("turning ({n} angles per frame)"),
        };
        format!("evaluating on {nx} × {ny} × {nz} voxels: {how}")
    }

    /// The raw patterns on the optimization's voxels, of every species, where there are raw ones.
    pub(super) fn unwritten(
        &mut self,
        voxels: &[Voxels],
        raw: Option<&[Patterns]>,
    ) -> Result<(Vec<Evaluation>, Vec<ObjectiveReport>)> {
        let Some(raw) = raw else {
            self.doses.will_show(&[self.shown]);
            return Ok((Vec::new(), Vec::new()));
        };
        let (job, work) = (self.job, self.work);
        self.doses.will_show(&[raw, self.shown]);
        let (doses, _) = (self.doses).of(&self.as_optimized, raw, &work.part(share::OWN_DOSE))?;
        let objectives = objectives::measured(job, &voxels[0], &doses[0])?;
        work.check()?;
        let stats = PatternStats::of(raw);
        let sub_angles = job.optics.lights.iter().map(|light| light.sub_angles);
        let sub_angles = sub_angles.max().unwrap_or(1);
        let each = job.species.iter().zip(voxels).zip(doses);
        let each = each.map(|((species, voxels), dose)| {
            let response = species.goal.responses(dose);
            let work = work.part(share::OWN_NUMBERS / job.species.len() as f64);
            let print =
                print(job, species, voxels, &response, work.part(1.0))?.with_patterns(stats);
            let evaluation = evaluate(&print);
            // Numbers of a canceled run mean nothing
            work.check()?;
            Ok(evaluation.with_sub_angles(sub_angles))
        });
        Ok((each.collect::<Result<_>>()?, objectives))
    }

    /// The written patterns on the optimization's voxels: as optimized, and while the vial turns, where the optimization did not count that.
    pub(super) fn on_own_voxels(
        &mut self,
        voxels: &[Voxels],
        has_raw: bool,
    ) -> Result<[Option<OwnPrint>; 2]> {
        let misses_turning = self.job.misses_turning();
        let written = (has_raw || misses_turning)
            .then(|| self.own_print(self.as_optimized.clone(), voxels))
            .transpose()?;
        if has_raw && self.as_optimized != self.turning {
            self.doses.will_show(&[self.shown]);
        }
        let turning = misses_turning
            .then(|| self.own_print(self.own_turning.clone(), voxels))
            .transpose()?;
        Ok([written, turning])
    }

    fn own_print(&mut self, exposed: Exposed, voxels: &[Voxels]) -> Result<OwnPrint> {
        if exposed == self.turning {
            return Ok(OwnPrint::Evaluated);
        }
        let work = self.work.part(share::OWN_DOSE);
        let (doses, _) = self.doses.of(&exposed, self.shown, &work)?;
        let measured = self.headlines(voxels, doses, share::OWN_NUMBERS)?;
        Ok(OwnPrint::Apart(measured))
    }

    pub(super) fn fine_voxels(&self, voxels: &[Voxels]) -> Result<Vec<Voxels>> {
        if self.grid == self.job.grid {
            return Ok(voxels.to_vec());
        }
        (self.job).voxels(&self.grid, &self.work.part(share::SAMPLING))
    }

    /// The headline numbers of raw patterns on the finer voxels, turning, where the written ones have few levels and targets are not gray.
    pub(super) fn unrounded(
        &mut self,
        voxels: &[Voxels],
        raw: Option<&[Patterns]>,
    ) -> Result<Vec<Measure>> {
        let is_gray = voxels.iter().any(|voxels| voxels.target.gray);
        let has_few = self.job.evaluation().bit_depth < ENOUGH_BITS && !is_gray;
        let Some(raw) = raw.filter(|_| has_few) else {
            return Ok(Vec::new());
        };
        self.doses.will_show(&[raw, self.shown]);
        let (doses, _) = (self.doses).of(&self.turning, raw, &self.work.aside())?;
        let found = self.headlines(&self.fine_voxels(voxels)?, doses, 0.0)?;
        self.doses.will_show(&[self.shown]);
        Ok(found)
    }

    /// The doses of the written patterns while the vial turns, and the model that gave them.
    pub(super) fn while_turning(&mut self) -> Result<(Vec<Volume<f32>>, String)> {
        let work = self.work.part(share::TURNING);
        let doses = (self.doses).of(&self.turning, self.shown, &work);
        self.doses.forget();
        doses
    }

    /// The headline number of every species, at the best threshold.
    fn headlines(
        &self,
        voxels: &[Voxels],
        doses: Vec<Volume<f32>>,
        share: f64,
    ) -> Result<Vec<Measure>> {
        let job = self.job;
        let each = job.species.iter().zip(voxels).zip(doses);
        let each = each.map(|((species, voxels), dose)| {
            let response = species.goal.responses(dose);
            let work = self.work.part(share / job.species.len() as f64);
            let print = print(job, species, voxels, &response, work)?;
            Ok(match print.best() {
                Some(best) if !voxels.target.gray => Some(best.iou),
                _ => (headline(voxels.target.gray).measure)(&print),
            })
        });
        each.collect()
    }
}
