//! The print in time: the written patterns of a job with a schedule, shown turn by turn to the job's material.
//!
//! Runs and simulations do it after their evaluation, on the job's voxels, in the light of the model of the evaluation. Equations and units:
//! `docs/material.md`. Shading makes the light anew every [`ScheduleSpec::shading_every_s`](crate::job::spec::ScheduleSpec).
//!
//! **Limits** Walls are those of the vial, of bodies and of inserts. With `diffusion = "spectral"` and a dose that diffuses walls are those of the
//! grid's box. Straight light in an index-matched vial is shaded along its way; other light that is shaded takes the family that covers an absorption
//! which changes from place to place, most often rays.

mod watch;

use crate::error::Result;
use crate::grid::{PatternGrid, Patterns, Volume};
use crate::io::frames::FrameSet;
use crate::io::mp4::write_movie;
use crate::job::dose::in_time::Shown;
use crate::job::resolve::scheduled::sent_mj;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::models::Work;
use crate::report::number::significant;
use crate::report::{OneMoment, TimeReport};
use serde::Serialize;
use std::path::Path;
use watch::Watched;

/// What a network becomes over time.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TimeSummary {
    /// Its name.
    pub name: String,
    /// When the first voxel is solid, s; None where none ever is.
    pub induction_end_s: Option<f64>,
    /// When solid and part overlap most, s.
    pub best_s: Option<f64>,
    /// Their Jaccard index then.
    pub best_jaccard: Option<f64>,
    /// Energy that all lights have sent to the vial by then, mJ.
    pub best_mj: Option<f64>,
    /// When what solid voxels have absorbed meets what the part needs, s; None where it never does.
    pub ideal_exposure_s: Option<f64>,
    /// Where it never does: the largest share of what the part needs that solid voxels have absorbed, or the part itself if nothing is solid.
    pub largest_share: Option<f64>,
}

impl std::fmt::Display for TimeSummary {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let seconds = |at: Option<f64>| {
            at.map_or_else(
                || "never".to_owned(),
                |s| format!("after {} s", significant(s, 3)),
            )
        };
        write!(
            f,
            "{}: first solid {}, best {} (IoU {}{})",
            self.name,
            seconds(self.induction_end_s),
            seconds(self.best_s),
            self.best_jaccard
                .map_or_else(|| "–".to_owned(), |j| format!("{j:.4}")),
            self.best_mj.map_or_else(String::new, |mj| {
                format!(", {} mJ sent to the vial", significant(mj, 3))
            }),
        )?;
        // A rate law whose dose depends on the power needs no dose that could be named
        if self.ideal_exposure_s.is_some() || self.largest_share.is_some() {
            write!(f, ", ideal exposure {}", seconds(self.ideal_exposure_s))?;
        }
        let Some(share) = self.largest_share else {
            return Ok(());
        };
        let percent = significant(100.0 * share, 3);
        let why = if self.induction_end_s.is_some() {
            format!(
                "solid voxels absorb {percent} % of what the part needs: more turns, or more power"
            )
        } else if share < 1.0 {
            format!(
                "the part absorbs {percent} % of what the part needs: more turns, or more power"
            )
        } else {
            format!(
                "the part absorbs {percent} % of what the part needs, but too unevenly or too slowly for any of it to become solid"
            )
        };
        write!(f, " ({why})")
    }
}

/// What patterns print over time.
pub(crate) struct InTime {
    pub(crate) networks: Vec<NetworkInTime>,
}

/// What a network becomes.
pub(crate) struct NetworkInTime {
    pub(crate) report: TimeReport,
    /// Labels of the same voxels.
    pub(crate) labels: Volume<u8>,
    /// The middle slice at every moment: brightness up to the gel point, white beyond it.
    slices: Vec<Vec<u16>>,
}

impl InTime {
    /// The closing lines about every network.
    pub(crate) fn summary(&self) -> Vec<TimeSummary> {
        let summary_of = |NetworkInTime { report, .. }: &NetworkInTime| {
            let best = report.best();
            TimeSummary {
                name: report.name.clone(),
                induction_end_s: report.phases.induction_end_s,
                best_s: report.phases.curing_end_s,
                best_jaccard: best.map(|(p, _)| p.jaccard),
                best_mj: best.map(|(_, mj)| mj),
                ideal_exposure_s: report.ideal_s(),
                largest_share: report.reached(),
            }
        };
        self.networks.iter().map(summary_of).collect()
    }

    /// The best moment of several networks.
    pub(crate) fn together(&self) -> Option<OneMoment> {
        let curve_of = |network: &NetworkInTime| {
            let points = network.report.points.iter();
            points.map(|p| [p.seconds, p.jaccard]).collect()
        };
        let networks = self.networks.iter();
        let curves: Vec<(&str, Vec<[f64; 2]>)> = networks
            .map(|n| (n.report.name.as_str(), curve_of(n)))
            .collect();
        let first = &self.networks.first()?.report;
        let moments = first.points.iter().zip(&first.sent_mj);
        let sent: Vec<[f64; 2]> = moments.map(|(p, mj)| [p.seconds, *mj]).collect();
        OneMoment::of(&curves, &sent)
    }
}

/// Length of the movie of a print, s.
const MOVIE_S: f64 = 8.0;

impl NetworkInTime {
    /// The middle slice as it grows, 8 s long.
    pub(crate) fn write_movie(&self, path: &Path, work: &Work) -> Result<()> {
        let [_, ny, nx] = self.labels.grid.shape;
        let grid = PatternGrid::full_turn(self.slices.len(), 0.0, ny, nx, 1.0);
        let values = self.slices.concat();
        let set = FrameSet {
            light: None,
            grid: &grid,
            bits: 8,
            full_scale: 1.0,
            channel: None,
            values: &values,
        };
        write_movie(
            path,
            &set,
            self.slices.len() as f64 / MOVIE_S,
            &work.aside(),
        )
    }
}

/// Shows patterns to the material of a job; None where it has no schedule.
pub(crate) fn print_in_time(
    job: &ResolvedJob,
    voxels: &[Voxels],
    patterns: &[Patterns],
    work: &Work,
) -> Result<Option<InTime>> {
    let Some(given) = job.schedule() else {
        return Ok(None);
    };
    let shown = Shown::new(job, patterns, work)?;
    let material = &shown.material;
    let end = shown.schedule.end_s();
    let times: Vec<f64> = (1..=given.snapshots)
        .map(|i| end * i as f64 / given.snapshots as f64)
        .collect();
    let mut watched = Vec::with_capacity(voxels.len());
    for (s, voxels) in voxels.iter().enumerate() {
        watched.push(Watched::new(material, s, voxels, &times)?);
    }
    shown.print(&mut |moment| watched.iter_mut().for_each(|watched| watched.look(moment)))?;
    let names = material.species();
    let mut networks = Vec::with_capacity(names.len());
    for ((watched, name), voxels) in watched.into_iter().zip(names).zip(voxels) {
        let seconds: Vec<f64> = (watched.curves.points().iter().map(|p| p.seconds)).collect();
        let sent_mj = sent_mj(&shown.schedule, patterns, &seconds);
        networks.push(watched.finish(material, name, sent_mj, job, voxels, patterns)?);
    }
    Ok(Some(InTime { networks }))
}

#[cfg(test)]
mod tests;
