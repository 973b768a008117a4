//! One model of a job and its scenarios: their doses side by side, from the same patterns.

use crate::error::Result;
use crate::job::dose::species::planned;
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::refinement::Level;
use crate::job::resolve::scenarios::Scenario;
use crate::models::masked::MaskedModel;
use crate::models::scenarios::{self, SharedModel};
use crate::models::{HostModel, OpticalScene, Purpose, Work};
use std::sync::Arc;

impl Scenario {
    /// The dose of all pixels, in a process among ranks of its own frames, on the voxels of a level of `job`.
    fn model(&self, job: &ResolvedJob, level: &Level, work: &Work) -> Result<HostModel> {
        let mut lights = job.own_lights(&self.optics.lights);
        for (light, of_level) in lights.iter_mut().zip(&level.lights) {
            light.sub_angles = of_level.sub_angles;
        }
        let scene = OpticalScene {
            lights: &lights,
            purpose: Purpose::Optimize,
            ..self.optics.scene()
        };
        let asked = self.optics.model.as_ref();
        let plan = planned(job, asked, scene, &level.grid, None, work)?;
        Ok(Box::new(plan.model))
    }
}

/// The model of the job and of all scenarios, where there are any; and that of the job, where it is another one.
pub(crate) fn joined(
    resolved: &ResolvedJob,
    model: MaskedModel,
    dark: &[bool],
    level: &Level,
    work: &Work,
) -> Result<(SharedModel, Option<SharedModel>)> {
    if resolved.scenarios.is_empty() {
        return Ok((Arc::new(model), None));
    }
    let others = resolved.scenarios.iter();
    let others = others.map(|scenario| scenario.model(resolved, level, work));
    let first: SharedModel = Arc::new(model);
    let all = scenarios::joined(first.clone(), others.collect::<Result<_>>()?)?;
    // What is dark in the job is so in all
    let all = MaskedModel::new(Box::new(all), dark.to_vec(), 1.0);
    Ok((Arc::new(all), Some(first)))
}
