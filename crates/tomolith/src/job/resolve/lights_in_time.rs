//! The light of a print in time: the models of the lights, through resin that shades where it has cured.

use crate::error::{Error, Result};

use crate::job::resolve::ResolvedJob;
use crate::models::{Family, HostModel, OpticalScene, Purpose, Work, planner};
use crate::optics::absorption_map::AbsorptionMap;
use crate::optics::light::{Light, Selection};
use std::sync::{Arc, OnceLock};
use tomolith_material::Absorption;
use tomolith_material::shaded::Shaded;

/// Refuses shading of light that no model follows through a resin that absorbs differently from place to place.
pub(crate) fn must_be_shaded(job: &ResolvedJob) -> Result<()> {
    let work = Work::new();
    let lights = Lights::new(job, Vec::new(), &work);
    // Two slices are enough to change along z
    let map = AbsorptionMap::new([2, 1, 1], job.grid.pitch_mm, vec![0.0; 2], vec![0.0; 2])?;
    let map = Arc::new(map);
    for (i, shading) in job.spec.shading().iter().enumerate() {
        if lights.is_straight(shading.light)? {
            continue;
        }
        let covered = lights.family(shading.light, Some(&map));
        covered.map_err(|error| at_shading(i, error))?;
    }
    Ok(())
}

/// Blames the shading for a model that does not cover it.
fn at_shading(i: usize, error: Error) -> Error {
    match error {
        Error::Config {
            key,
            found,
            accepted,
            ..
        } => Error::config(
            format!("material.photopolymer.shading[{i}]"),
            format!("cured resin shades, and {key} does not cover that: {found}"),
            accepted,
        ),
        other => other,
    }
}

/// The light of the evaluation, one model each.
pub(crate) struct Lights<'a> {
    pub(crate) job: &'a ResolvedJob,
    pub(crate) lights: Vec<Light>,
    /// Straight light in resin where nothing has cured, made on first use.
    pub(crate) plain: Vec<OnceLock<Option<Arc<tomolith_material::Model>>>>,
    pub(crate) work: &'a Work,
}

impl<'a> Lights<'a> {
    pub(crate) fn new(job: &'a ResolvedJob, lit: Vec<Vec<(u32, u32)>>, work: &'a Work) -> Self {
        let mut lights = job.optics.lights_turning(&job.evaluated_angles);
        for (light, lit) in lights.iter_mut().zip(lit) {
            light.active = Some(lit);
            light.selection = Selection::default();
        }
        let plain = lights.iter().map(|_| OnceLock::new()).collect();
        Lights {
            job,
            lights,
            plain,
            work,
        }
    }

    /// The model of a light in the resin as the job has it, or with this absorption.
    pub(crate) fn model(&self, i: usize, absorption: Option<&Absorption>) -> Result<HostModel> {
        let Some(absorption) = absorption else {
            return self.planned(i, None);
        };
        if let Some(plain) = self.straight(i)? {
            let resin = &self.lights[i].resin;
            let plain_mu = [resin.absorption_per_mm, resin.attenuation_per_mm];
            return Ok(Box::new(Shaded::new(plain, plain_mu, absorption)?));
        }
        let grid = &absorption.active_per_mm.grid;
        let [active, total] = [&absorption.active_per_mm, &absorption.attenuation_per_mm];
        let (active, total) = (active.values.clone(), total.values.clone());
        let map = AbsorptionMap::new(grid.shape, grid.pitch_mm, active, total)?;
        self.planned(i, Some(Arc::new(map.about(grid.center_mm))))
    }

    /// The scene of a light alone.
    fn scene_of<'s>(&'s self, i: usize, light: &'s [Light], purpose: Purpose) -> OpticalScene<'s> {
        let all = self.job.optics.scene();
        OpticalScene {
            lights: light,
            optics: &all.optics[i..=i],
            purpose,
            ..all
        }
    }

    fn planned(&self, i: usize, map: Option<Arc<AbsorptionMap>>) -> Result<HostModel> {
        let light = [self.mapped(i, map.as_ref())];
        let purpose = if map.is_some() {
            Purpose::Probe
        } else {
            Purpose::Optimize
        };
        let scene = self.scene_of(i, &light, purpose);
        let asked = self.job.optics.model.as_ref();
        let plan = planner::plan(asked, scene, &self.job.grid, None, self.work)?;
        Ok(Box::new(plan.model))
    }

    /// A light in the resin of the job, or in one with this map.
    fn mapped(&self, i: usize, map: Option<&Arc<AbsorptionMap>>) -> Light {
        let mut light = self.lights[i].clone();
        light.map = map.cloned().or(light.map);
        light
    }

    /// The family of models of a light.
    pub(crate) fn family(&self, i: usize, map: Option<&Arc<AbsorptionMap>>) -> Result<Family> {
        let light = [self.mapped(i, map)];
        let scene = self.scene_of(i, &light, Purpose::Optimize);
        planner::choose(self.job.optics.model.as_ref(), &scene, &self.job.grid)
    }

    /// Whether a light runs level and straight through resin that absorbs alike everywhere, cones and waves about such a way among them.
    pub(crate) fn is_straight(&self, i: usize) -> Result<bool> {
        let (light, vial) = (&self.lights[i], self.job.optics.vial.as_ref());
        let index = light.resin.refractive_index;
        let outside = vial.surrounding_index(light.surrounding_index, index);
        Ok(self.family(i, None)?.capabilities().is_along_frames
            && vial.walls().len() == 1
            && vial.is_round()
            && outside == index
            && light.map.is_none()
            && !light.resin.pure_radon)
    }

    /// The model of the resin in which nothing has cured, where light runs level and straight through it.
    fn straight(&self, i: usize) -> Result<Option<Arc<tomolith_material::Model>>> {
        if let Some(known) = self.plain[i].get() {
            return Ok(known.clone());
        }
        let model = if self.is_straight(i)? {
            Some(Arc::from(self.planned(i, None)?))
        } else {
            None
        };
        Ok(self.plain[i].get_or_init(|| model).clone())
    }
}
