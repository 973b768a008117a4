//! The lights that act on a species.

use super::ResolvedJob;
use crate::optics::light::Light;

/// A light that acts on a species: its place among those of the job, and its name where there are several.
#[derive(Clone, Copy)]
pub(crate) struct Acting<'a> {
    pub(crate) index: usize,
    pub(crate) name: Option<&'a str>,
    pub(crate) light: &'a Light,
}

/// The lights that drive or inhibit species `s`.
pub(crate) fn acting_on(job: &ResolvedJob, s: usize) -> Vec<Acting<'_>> {
    let lights = job.optics.lights.iter().zip(job.light_names());
    let all = lights
        .enumerate()
        .map(|(index, (light, name))| Acting { index, name, light });
    let factor = |light: &Acting<'_>| match &job.mixing {
        Some(rows) => rows[s].1[light.index],
        None => 1.0,
    };
    all.filter(|light| factor(light) != 0.0).collect()
}
