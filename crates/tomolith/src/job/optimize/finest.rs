//! The ceiling of the pixels, which was found on a coarser level, tried on the finest one.
//!
//! **Method** After the last iteration the ceiling falls by √2 where little light lies above that, else it is doubled, and some iterations more show what the print is then.
//! A lower one that prints as well as the job tolerates is taken. Where the double prints better than that, the ceiling rises by √2, and where that is not enough once more,
//! each time for some iterations; then the next double is tried, up to eight times the ceiling. The history goes on with what is taken. A lower one that the coarser level refused by far is not tried: of the published boat that saves an eighth
//! of the optimization.
//!
//! **What is compared** IoU, VER and Γ. The mean deviation is not: on these voxels it changes from iteration to iteration by up to a tenth, whatever the ceiling is, where a
//! twentieth is tolerated.

use super::ceiling::{FoundCeiling, are_good};
use super::stage::{Around, SoFar, Stage};
use super::start::clip;
use crate::error::Result;
use crate::field::HostField;
use crate::job::progress::Progress;
use crate::models::Work;
use crate::optimize::{Limits, Outcome, StopReason};
use crate::report::{CeilingQuality, FinestTrial};
use std::time::Instant;

/// Iterations below the double. With four, prints of docs/fidelity.md below half of their ceiling gain more than is tolerated, and those below their ceiling
/// do not; with two, the star's gain is not seen.
pub(crate) const TRY: usize = 4;
/// Iterations for each step that is taken.
const EACH: usize = 8;
/// By how much it rises at most.
const MOST: f64 = 8.0;
/// By how much the ceiling falls, and the share of the light above that up to which it is tried.
const LOWER: f64 = std::f64::consts::FRAC_1_SQRT_2;
const SLACK: f64 = 0.02;

/// What the optimization ended with, and the highest ceilings that there may be.
pub(crate) struct Ended<'a> {
    pub(crate) x: &'a mut HostField,
    pub(crate) bounds: &'a mut [Limits],
    pub(crate) highest: &'a [Limits],
    pub(crate) outcome: Outcome,
}

/// Goes on from the ceiling that was found to a better one, if there is one on this level; what the optimization came to then.
pub(crate) fn settle(
    stage: &Stage<'_>,
    ended: Ended<'_>,
    found: &mut FoundCeiling,
    sofar: &mut SoFar,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Outcome> {
    let begin = Instant::now();
    let has_slack = excess(ended.x, stage, ended.bounds, LOWER) < SLACK;
    if has_slack && !found.may_become(LOWER, stage.job) {
        return Ok(ended.outcome);
    }
    let qualities = stage.qualities(ended.x, false, &[], work)?;
    let mut go_on = GoOn {
        stage,
        sofar,
        progress,
        work,
    };
    let seconds = |outcome: &Outcome| outcome.history.last().map_or(0.0, |row| row.seconds);
    let in_loop = seconds(&ended.outcome);
    let (outcome, trial) = match has_slack {
        true => go_on.lower(ended, qualities)?,
        false => go_on.raise(ended, qualities)?,
    };
    found.report.finest = Some(trial);
    // What is taken counts to the loop
    let in_loop = seconds(&outcome) - in_loop;
    found.seconds += (begin.elapsed().as_secs_f64() - in_loop).max(0.0);
    Ok(outcome)
}

/// Share of the light above a part of its ceiling.
fn excess(x: &HostField, stage: &Stage<'_>, bounds: &[Limits], part: f64) -> f64 {
    let mut sums = [0.0; 2];
    for (light, bound) in stage.model.patterns().iter().zip(bounds) {
        for &value in &x.as_slice()[light.range()] {
            sums[0] += (f64::from(value) - part * bound.max).max(0.0);
            sums[1] += f64::from(value);
        }
    }
    sums[0] / sums[1].max(f64::MIN_POSITIVE)
}

/// Ceilings times a factor, within those that there may be.
fn scaled(bounds: &[Limits], highest: &[Limits], factor: f64) -> Vec<Limits> {
    let limits_of = |(bound, highest): (&Limits, &Limits)| Limits {
        min: bound.min,
        max: (bound.max * factor).clamp(bound.min, highest.max),
    };
    bounds.iter().zip(highest).map(limits_of).collect()
}

/// What further iterations are done with.
struct GoOn<'a, 's> {
    stage: &'a Stage<'s>,
    sofar: &'a mut SoFar,
    progress: &'a mut dyn Progress,
    work: &'a Work,
}

impl GoOn<'_, '_> {
    /// Some iterations more, after those of an outcome.
    fn on(&mut self, x: &mut HostField, bounds: &[Limits], after: &Outcome) -> Result<Outcome> {
        clip(x, self.stage.model.patterns(), bounds)?;
        let until = after.history.last().map_or(0, |row| row.iteration) + EACH;
        self.sofar.rows.clone_from(&after.history);
        self.sofar.counters = after.counters;
        let around = Around {
            until,
            wider: 0,
            change: 0.0,
            bounds,
            checkpoints: None,
            sofar: self.sofar,
            progress: self.progress,
            work: self.work,
        };
        self.stage.run(x, around)
    }

    fn is_as_good(&self, qualities: &[CeilingQuality], other: &[CeilingQuality]) -> bool {
        are_good(self.stage.job, 1, other, qualities)
    }

    /// Lowers the ceiling, and takes that where it prints as well.
    fn lower(
        &mut self,
        ended: Ended<'_>,
        before: Vec<CeilingQuality>,
    ) -> Result<(Outcome, FinestTrial)> {
        let bounds = scaled(ended.bounds, ended.highest, LOWER);
        let mut x = ended.x.clone();
        let metrics_s = self.sofar.metrics_s;
        let mut outcome = self.on(&mut x, &bounds, &ended.outcome)?;
        let mut trial = FinestTrial {
            tried: LOWER,
            after: self.stage.qualities(&x, false, &before, self.work)?,
            before,
            changed_by: 1.0,
        };
        let is_over = outcome.reason == StopReason::Canceled;
        if is_over || self.is_as_good(&trial.after, &trial.before) {
            trial.changed_by = LOWER;
            *ended.x = x;
            ended.bounds.clone_from_slice(&bounds);
        } else {
            outcome = ended.outcome;
            self.sofar.metrics_s = metrics_s;
        }
        Ok((outcome, trial))
    }

    /// Whether the IoU of no print is lower than that of another one by more than the job tolerates.
    fn overlaps_as_well(&self, qualities: &[CeilingQuality], other: &[CeilingQuality]) -> bool {
        let tolerance = self.stage.job.bounds().tolerance.iou;
        let mut pairs = qualities.iter().zip(other);
        pairs.all(|(quality, other)| {
            let least = other.iou.map_or(0.0, |iou| iou - tolerance);
            quality.iou.is_some_and(|iou| iou >= least)
        })
    }

    /// Raises the ceiling where its double prints better, and on as long as no IoU is lower there.
    fn raise(
        &mut self,
        mut ended: Ended<'_>,
        before: Vec<CeilingQuality>,
    ) -> Result<(Outcome, FinestTrial)> {
        let (mut trial, mut qualities) = self.towards_double(&mut ended, before, false)?;
        let mut last = trial.changed_by;
        while last >= 2.0 && trial.changed_by < MOST {
            let (further, found) = self.towards_double(&mut ended, qualities, true)?;
            last = further.changed_by;
            trial.changed_by *= last;
            qualities = found;
        }
        Ok((ended.outcome, trial))
    }

    /// Doubles the ceiling, and raises it where that prints better, up to there; how good the print is then.
    fn towards_double(
        &mut self,
        ended: &mut Ended<'_>,
        before: Vec<CeilingQuality>,
        must_overlap: bool,
    ) -> Result<(FinestTrial, Vec<CeilingQuality>)> {
        let lowest = ended.bounds.to_vec();
        let mut x = ended.x.clone();
        let limits = scaled(&lowest, ended.highest, 2.0);
        let stage = self.stage;
        stage.improve_within(&mut x, &limits, TRY, self.work)?;
        let mut trial = FinestTrial {
            tried: 2.0,
            after: stage.qualities(&x, false, &[], self.work)?,
            before,
            changed_by: 1.0,
        };
        let mut qualities = trial.before.clone();
        for step in [std::f64::consts::SQRT_2, 2.0] {
            let is_over = ended.outcome.reason == StopReason::Canceled;
            let is_worse = must_overlap && !self.overlaps_as_well(&trial.after, &qualities);
            if is_over || is_worse || self.is_as_good(&qualities, &trial.after) {
                break;
            }
            let raised = scaled(&lowest, ended.highest, step);
            // The bound of the start may cut it
            let by = raised
                .iter()
                .zip(&lowest)
                .map(|(now, low)| now.max / low.max);
            trial.changed_by = by.fold(1.0, f64::max).min(step);
            ended.bounds.clone_from_slice(&raised);
            ended.outcome = self.on(ended.x, ended.bounds, &ended.outcome)?;
            qualities = stage.qualities(ended.x, false, &trial.after, self.work)?;
        }
        Ok((trial, qualities))
    }
}
