//! The dose models of an optimization against what is printed in time, or against a dose that diffuses.

use super::material::{domain, material};
use super::schedule::schedule;
use crate::error::Result;
use crate::grid::VolumeGrid;
use crate::job::refinement::Level;
use crate::job::scene::{Scene, Voxels, at_section};
use crate::job::spec::{Against, JobSpec, MaterialSpec};
use crate::job::species::joined;
use crate::models::{Family, HostModel, OpticalScene, Run, planner};
use tomolith_material::Material;
use tomolith_material::diffused::Diffused;
use tomolith_material::domain::Domain;
use tomolith_material::frozen::Frozen;
use tomolith_material::printing::Printing;

/// Whether the doses of a job diffuse.
pub(crate) fn diffuses(scene: &Scene) -> bool {
    let material = scene.spec.material.as_ref();
    material.is_some_and(|material| material.diffusion.is_some())
}

/// A model whose dose is that at the end of the schedule, where the job's dose diffuses.
///
/// # Errors
/// As [`Diffused::of_schedule`].
pub(crate) fn diffused(scene: &Scene, model: HostModel) -> Result<HostModel> {
    let own = scene.spec.material.as_ref();
    let Some(diffusion) = own.and_then(|material| material.diffusion) else {
        return Ok(model);
    };
    let given = scene.spec.schedule.clone().unwrap_or_default();
    let turns = if given.own_patterns {
        given.turns as usize
    } else {
        1
    };
    let arcs = diffusion.arcs.unwrap_or(turns);
    let schedule = schedule(&scene.spec)?;
    let diffused = Diffused::of_schedule(model, diffusion.mm2_per_s, &schedule, arcs);
    Ok(Box::new(
        diffused.map_err(|e| at_section("material.diffusion", e))?,
    ))
}

/// The dose models of a level, joined to what the job is optimized against.
///
/// # Errors
/// [`Error::Config`] where they do not fit.
pub(crate) fn planned_in_time(
    scene: &Scene,
    optics: (Option<&Family>, OpticalScene<'_>),
    level: &Level,
    voxels: &[&Voxels],
    run: &Run,
) -> Result<planner::ModelPlan> {
    let rows = scene.rows().unwrap_or_default();
    let given = scene.spec.schedule.clone().unwrap_or_default();
    let join = |models: Vec<HostModel>| -> Result<HostModel> {
        let schedule = schedule(&scene.spec)?;
        let domain = domain(scene, &level.grid)?;
        let material = Box::new(material(&scene.spec, scene.mixing.as_deref(), domain)?);
        Ok(match given.optimize {
            Against::Exact => Box::new(Printing::new(models, schedule, material, given.step_s)?),
            _ => {
                let every = scene.spec.stop.iterations.div_ceil(given.rounds + 1);
                Box::new(Frozen::new(
                    models,
                    schedule,
                    material,
                    given.step_s,
                    every,
                )?)
            }
        })
    };
    let mut plan = joined(&rows, optics, &level.grid, Some(voxels), run, join)?;
    plan.reason = format!("{}; against the degree of cure", plan.reason);
    Ok(plan)
}

/// Whether a job optimizes against a resin with a memory, whose cure is no linear function of the patterns.
pub(crate) fn is_optimized(spec: &JobSpec) -> bool {
    let has_memory = |material: &MaterialSpec| material.photopolymer.is_some();
    let against = spec.schedule.as_ref().map(|given| given.optimize);
    against.is_some_and(|against| against != Against::Dose)
        && spec.material.as_ref().is_some_and(has_memory)
}

/// Whether an optimization shows all frames of the schedule, so that none may be left out.
pub(crate) fn shows_every_frame(spec: &JobSpec) -> bool {
    let diffuses = |material: &MaterialSpec| material.diffusion.is_some();
    let against = spec.schedule.as_ref().map(|given| given.optimize);
    against.is_some_and(|against| against != Against::Dose)
        || spec.material.as_ref().is_some_and(diffuses)
}

impl Scene {
    /// Whether patterns are optimized against what they print in time.
    pub(crate) fn is_optimized_in_time(&self) -> bool {
        let given = self.spec.schedule.as_ref();
        given.is_some_and(|schedule| schedule.optimize != Against::Dose)
    }

    /// The factor of patterns of light `i` that would bring a dose of 1, so that species `s` becomes solid at the end of the schedule.
    pub(crate) fn dose_needed(&self, s: usize, i: usize) -> Result<f64> {
        if !self.is_optimized_in_time() {
            return Ok(1.0);
        }
        let energies = schedule(&self.spec)?.energies(i);
        let mean = energies.iter().sum::<f64>() / energies.len().max(1) as f64;
        let domain = Domain::new(VolumeGrid::centered([1, 1, 1], 0.1));
        let material = material(&self.spec, self.mixing.as_deref(), domain)?;
        let start = material.start()?;
        let Some(needed) = material.requirement(s) else {
            return Ok(1.0 / mean);
        };
        let of = |&(volume, capacity): &(usize, f64)| {
            capacity * f64::from(start.volumes[volume].as_slice()[0])
        };
        let inhibited: f64 = needed.inhibitors.iter().map(of).sum();
        Ok((needed.dose + inhibited) / mean)
    }
}
