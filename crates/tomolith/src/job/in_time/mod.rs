//! The print in time: the written patterns of a job with a schedule, shown turn by turn to the job's material.
//!
//! Runs and simulations do it beside their evaluation, on the job's own voxels, in the light of the model that judges. Equations and units:
//! `docs/material.md`. Shading makes the light anew every [`ScheduleSpec::shading_every_s`](super::spec::ScheduleSpec).
//!
//! **Limits** Walls are those of the vial, of bodies and of inserts. With `diffusion = "spectral"` and a dose that diffuses walls are those of the
//! grid's box. Straight light in an index-matched vial is shaded along its way; other light that is shaded takes the family that covers an absorption
//! which changes from place to place, most often rays.

mod light;
mod material;
mod models;
mod schedule;
mod watch;

use super::outcome::TimeSummary;
use super::scene::{Scene, Voxels};
use super::scheduled::sent_mj;
use crate::error::Result;
use crate::field::HostField;
use crate::grid::{PatternGrid, Patterns, Volume};
use crate::io::frames::FrameSet;
use crate::io::mp4::write_movie;
use crate::metrics::Evaluation;
use crate::models::{HostModel, Run};
use crate::report::OneMoment;
use light::Lights;
pub(super) use light::must_be_shaded;
use material::domain;
pub(super) use material::material;
pub(super) use models::{diffused, diffuses, is_optimized, planned_in_time, shows_every_frame};
pub(super) use schedule::schedule;
use std::ops::ControlFlow;
use std::path::Path;
use tomolith_material::curves::{CurvePoint, IdealExposure, Phases};
use tomolith_material::photopolymer::Photopolymer;
use tomolith_material::print::{LightSource, Moment, PrintRun};
use tomolith_material::schedule::Schedule;
use tomolith_material::{Absorption, Material};
use watch::Watched;

/// What patterns print over time.
pub(crate) struct InTime {
    /// Per network.
    pub(crate) networks: Vec<NetworkInTime>,
}

/// What a network becomes.
pub(crate) struct NetworkInTime {
    pub(crate) name: String,
    pub(crate) points: Vec<CurvePoint>,
    /// Energy that all lights have sent to the vial at each of these moments, mJ.
    pub(crate) sent_mj: Vec<f64>,
    pub(crate) requirement_mj: Option<f64>,
    pub(crate) ideal: IdealExposure,
    pub(crate) phases: Phases,
    /// What is solid then, measured.
    pub(crate) evaluation: Option<Evaluation>,
    /// When each voxel gels, s; ∞ where it does not.
    pub(crate) cure_times: Volume<f32>,
    /// Degree of cure (1 at the gel point) over time.
    pub(crate) snapshots: Vec<(f64, Volume<f32>)>,
    /// Labels of the same voxels.
    pub(crate) labels: Volume<u8>,
    /// The middle slice at every moment: brightness up to the gel point, white beyond it.
    slices: Vec<Vec<u16>>,
}

impl InTime {
    /// What is said of every network at the end.
    pub(crate) fn summary(&self) -> Vec<TimeSummary> {
        let of = |network: &NetworkInTime| {
            let best_s = network.phases.curing_end_s;
            let mut moments = network.points.iter().zip(&network.sent_mj);
            let best = best_s.and_then(|best| moments.find(|(p, _)| p.seconds >= best));
            TimeSummary {
                name: network.name.clone(),
                induction_end_s: network.phases.induction_end_s,
                best_s,
                best_jaccard: best.map(|(p, _)| p.jaccard),
                best_mj: best.map(|(_, mj)| *mj),
                ideal_exposure_s: match network.ideal {
                    IdealExposure::At(seconds) => Some(seconds),
                    _ => None,
                },
                largest_share: match network.ideal {
                    IdealExposure::NotReached(share) => Some(share),
                    _ => None,
                },
            }
        };
        self.networks.iter().map(of).collect()
    }

    /// The best moment of several networks.
    pub(crate) fn together(&self) -> Option<OneMoment> {
        let of = |network: &NetworkInTime| {
            let points = network.points.iter();
            points.map(|p| [p.seconds, p.jaccard]).collect()
        };
        let networks = self.networks.iter();
        let curves: Vec<(&str, Vec<[f64; 2]>)> =
            networks.map(|n| (n.name.as_str(), of(n))).collect();
        let first = self.networks.first()?;
        let moments = first.points.iter().zip(&first.sent_mj);
        let sent: Vec<[f64; 2]> = moments.map(|(p, mj)| [p.seconds, *mj]).collect();
        OneMoment::of(&curves, &sent)
    }
}

/// Length of the movie of a print, s.
const MOVIE_S: f64 = 8.0;

impl NetworkInTime {
    /// The middle slice as it grows, 8 s long.
    ///
    /// # Errors
    /// [`Error::Io`], or what an encoder refuses.
    pub(crate) fn write_movie(&self, path: &Path, run: &Run) -> Result<()> {
        let [_, ny, nx] = self.labels.grid.shape;
        let grid = PatternGrid::full_turn(self.slices.len(), 0.0, ny, nx, 1.0);
        let values = self.slices.concat();
        let set = FrameSet {
            light: None,
            grid: &grid,
            bits: 8,
            full_scale: 1.0,
            values: &values,
        };
        write_movie(path, &set, self.slices.len() as f64 / MOVIE_S, &run.aside())
    }
}

/// Patterns before the material of a job.
pub(crate) struct Shown<'a> {
    pub(crate) material: Photopolymer,
    pub(crate) schedule: Schedule,
    lights: Lights<'a>,
    models: Vec<HostModel>,
    fields: Vec<HostField>,
    /// Whether cured resin shades.
    shaded: bool,
}

impl<'a> Shown<'a> {
    /// Models of the light as it is before anything cures.
    pub(crate) fn new(scene: &'a Scene, patterns: &[Patterns], run: &'a Run) -> Result<Self> {
        let domain = domain(scene, &scene.grid)?;
        let material = material(&scene.spec, scene.mixing.as_deref(), domain)?;
        let lights = Lights::new(scene, patterns, run);
        let start = material.start()?;
        let mut models = Vec::with_capacity(patterns.len());
        let mut fields = Vec::with_capacity(patterns.len());
        let mut shaded = false;
        for (i, patterns) in patterns.iter().enumerate() {
            let absorption = material.absorption(&start, i);
            shaded |= absorption.is_some();
            let model = lights.model(i, absorption.as_ref())?;
            let mut x = model.new_patterns()?;
            model.patterns()[0].fill_field(patterns, x.as_mut_slice());
            models.push(model);
            fields.push(x);
        }
        Ok(Shown {
            material,
            schedule: schedule(&scene.spec)?,
            lights,
            models,
            fields,
            shaded,
        })
    }

    /// Prints, and shows every moment.
    ///
    /// # Errors
    /// As [`PrintRun::run`].
    pub(crate) fn print(&self, look: &mut dyn FnMut(&Moment)) -> Result<()> {
        let given = self.lights.scene.spec.schedule.clone().unwrap_or_default();
        let sources = self.models.iter().zip(&self.fields);
        let sources = sources.map(|(model, patterns)| LightSource {
            model: model.as_ref(),
            patterns,
        });
        let mut print = PrintRun::new(&self.material, &self.schedule, sources.collect())?;
        if let Some(step_s) = given.step_s {
            print = print.with_step_s(step_s).map_err(|e| e.under("schedule"))?;
        }
        let mut renew = |i: usize, absorption: &Absorption| self.lights.model(i, Some(absorption));
        if self.shaded {
            print = print.with_renewal(given.shading_every_s, &mut renew);
        }
        let mut observe = |moment: &Moment| {
            look(moment);
            ControlFlow::Continue(())
        };
        print.run(self.lights.run, &mut observe).map(drop)
    }
}

/// Shows patterns to the material of a job; None where it has no schedule.
///
/// # Errors
/// [`Error::Config`] where models, schedule and material do not fit; [`Error::Canceled`].
pub(crate) fn print_in_time(
    scene: &Scene,
    voxels: &[&Voxels],
    patterns: &[Patterns],
    run: &Run,
) -> Result<Option<InTime>> {
    let Some(given) = &scene.spec.schedule else {
        return Ok(None);
    };
    let shown = Shown::new(scene, patterns, run)?;
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
    let names = Material::species(material);
    let mut networks = Vec::with_capacity(names.len());
    for ((watched, name), (scene, voxels)) in watched
        .into_iter()
        .zip(names)
        .zip(scene.species().zip(voxels))
    {
        let mut network = watched.finish(material, name, scene, voxels, patterns)?;
        let seconds: Vec<f64> = network.points.iter().map(|p| p.seconds).collect();
        network.sent_mj = sent_mj(&shown.schedule, patterns, &seconds);
        networks.push(network);
    }
    Ok(Some(InTime { networks }))
}

#[cfg(test)]
mod tests;
