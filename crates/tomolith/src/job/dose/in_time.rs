//! The dose models of an optimization against what is printed in time, or against a dose that diffuses.

use super::doses::lit_rows;
use crate::error::Result;
use crate::field::HostField;
use crate::grid::{Patterns, VolumeGrid};
use crate::job::dose::species::joined;
use crate::job::resolve::lights_in_time::Lights;
use crate::job::resolve::material::domain;
use crate::job::resolve::refinement::Level;
use crate::job::resolve::{ResolvedJob, Voxels, at_section};
use crate::models::{Family, HostModel, OpticalScene, Work, planner};
use std::ops::ControlFlow;
use tomolith_material::Absorption;
use tomolith_material::diffused::Diffused;
use tomolith_material::domain::Domain;
use tomolith_material::frozen::Frozen;
use tomolith_material::photopolymer::Photopolymer;
use tomolith_material::print::{LightSource, Moment, PrintRun};
use tomolith_material::printing::Printing;
use tomolith_material::schedule::Schedule;

/// Whether the doses of a job diffuse.
pub(crate) fn diffuses(job: &ResolvedJob) -> bool {
    job.diffusion().is_some()
}

/// A model whose dose is that at the end of the schedule, where the job's dose diffuses.
pub(crate) fn diffused(job: &ResolvedJob, model: HostModel) -> Result<HostModel> {
    let Some(diffusion) = job.diffusion() else {
        return Ok(model);
    };
    let given = job.schedule().cloned().unwrap_or_default();
    let turns = if given.own_patterns {
        given.turns as usize
    } else {
        1
    };
    let arcs = diffusion.arcs.unwrap_or(turns);
    let schedule = job.exposures()?;
    let diffused = Diffused::of_schedule(model, diffusion.mm2_per_s, &schedule, arcs);
    Ok(Box::new(
        diffused.map_err(|e| at_section("material.diffusion", e))?,
    ))
}

/// The dose models of a level, joined to what the job is optimized against.
pub(crate) fn planned_in_time(
    job: &ResolvedJob,
    asked: Option<&Family>,
    optics: OpticalScene<'_>,
    level: &Level,
    voxels: &[Voxels],
    work: &Work,
) -> Result<planner::ModelPlan> {
    let rows = job.rows().unwrap_or_default();
    let given = job.schedule().cloned().unwrap_or_default();
    let join = |models: Vec<HostModel>| -> Result<HostModel> {
        let schedule = job.exposures()?;
        let domain = domain(job, &level.grid)?;
        let (material, step_s) = (job.photopolymer(domain)?, given.step_s);
        if given.is_exact() {
            return Ok(Box::new(Printing::new(models, schedule, material, step_s)?));
        }
        let every = job.stop().iterations.div_ceil(given.rounds + 1);
        let frozen = Frozen::new(models, schedule, material, step_s, every)?;
        Ok(Box::new(frozen))
    };
    let mut plan = joined(&rows, asked, optics, &level.grid, Some(voxels), work, join)?;
    plan.reason = format!("{}; against the degree of cure", plan.reason);
    Ok(plan)
}

impl ResolvedJob {
    /// Whether patterns are optimized against what they print in time.
    pub(crate) fn is_optimized_in_time(&self) -> bool {
        self.schedule()
            .is_some_and(|schedule| schedule.optimizes_cure())
    }

    /// The factor of patterns of light `i` that would bring a dose of 1, so that species `s` becomes solid at the end of the schedule.
    pub(crate) fn dose_needed(&self, s: usize, i: usize) -> Result<f64> {
        if !self.is_optimized_in_time() {
            return Ok(1.0);
        }
        let energies = self.exposures()?.energies(i);
        let mean = energies.iter().sum::<f64>() / energies.len().max(1) as f64;
        let domain = Domain::new(VolumeGrid::centered([1, 1, 1], 0.1));
        let material = self.photopolymer(domain)?;
        let start = material.start()?;
        let Some(needed) = material.requirement(s) else {
            return Ok(1.0 / mean);
        };
        let dose_of = |&(volume, capacity): &(usize, f64)| {
            capacity * f64::from(start.volumes[volume].as_slice()[0])
        };
        let inhibited: f64 = needed.inhibitors.iter().map(dose_of).sum();
        Ok((needed.dose + inhibited) / mean)
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
    pub(crate) fn new(job: &'a ResolvedJob, patterns: &[Patterns], work: &'a Work) -> Result<Self> {
        let domain = domain(job, &job.grid)?;
        let material = job.photopolymer(domain)?;
        let lights = Lights::new(job, patterns.iter().map(lit_rows).collect(), work);
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
            schedule: job.exposures()?,
            lights,
            models,
            fields,
            shaded,
        })
    }

    /// Prints, and shows every moment.
    pub(crate) fn print(&self, look: &mut dyn FnMut(&Moment)) -> Result<()> {
        let given = self.lights.job.schedule().cloned().unwrap_or_default();
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
        print.run(self.lights.work, &mut observe).map(drop)
    }
}
