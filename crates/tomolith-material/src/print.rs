//! A print in time: a material is stepped through a schedule, in the light of any dose models.
//!
//! **Blocks** The schedule is cut into blocks of at most `step_s`; light is even within one. By default a hundredth of the print, at most 1 s and at most
//! the material's stability limit. A longer step than that is refused, and the limit named.
//!
//! **Shading** Where the material tells how its absorption changes, a callback may make new dose models of it, every so often. Without one lights stay as
//! they were at the start.
//!
//! **Cost** Per block one `dose_of` of its frames, one step of the material, and what the observer does. Memory: per light a volume of absorbed energy,
//! the state, one spare volume.

use crate::illumination::{Illumination, must_show};
use crate::photopolymer::Photopolymer;
use crate::schedule::{Block, Schedule};
use crate::{Absorption, Model, State};
use std::ops::ControlFlow;
use tomolith_core::dose::{Work, frames_of};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::units::exact;

/// The longest step of a schedule that names none, s.
const LONGEST_S: f64 = 1.0;

/// The fewest steps of a print whose schedule names none.
const FEWEST_STEPS: f64 = 100.0;

/// A light of the print: its dose model and its patterns, a field of that model.
#[derive(Clone, Copy)]
pub struct LightSource<'a> {
    /// Patterns → absorbed energy, mJ/mm³ per mJ/mm².
    pub model: &'a Model,
    /// Pattern values.
    pub patterns: &'a HostField,
}

impl<'a> LightSource<'a> {
    /// Patterns and the model that shows them.
    pub fn new(model: &'a Model, patterns: &'a HostField) -> Self {
        LightSource { model, patterns }
    }
}

/// Makes the dose model of a light (by its number) anew for an absorption; its layouts must stay.
pub type Renew<'a> = dyn FnMut(usize, &Absorption) -> Result<Box<Model>> + 'a;

/// A moment of the print: the start, and the end of every block.
pub struct Moment<'m> {
    /// Time, s.
    pub seconds: f64,
    /// Steps done, and in all.
    pub steps: [usize; 2],
    /// How long the block took that ends now, s; 0 at the start.
    pub block_s: f64,
    /// The material.
    pub material: &'m Photopolymer,
    /// Its state now.
    pub state: &'m State,
    /// Energy that each light left in the block that ends now, mJ/mm³; empty in the dark.
    pub absorbed: &'m [&'m [f32]],
}

/// See the [module page](self).
pub struct PrintRun<'a> {
    material: &'a Photopolymer,
    lights: Vec<LightSource<'a>>,
    renewed: Vec<Option<Box<Model>>>,
    schedule: &'a Schedule,
    step_s: f64,
    renewal: Option<(f64, &'a mut Renew<'a>)>,
}

impl<'a> PrintRun<'a> {
    /// A print of these lights.
    ///
    /// # Errors
    /// [`Error::Config`] where schedule, mixing matrix and lights do not fit; [`Error::Shape`] where voxels or patterns do not.
    pub fn new(
        material: &'a Photopolymer,
        schedule: &'a Schedule,
        lights: Vec<LightSource<'a>>,
    ) -> Result<Self> {
        let models: Vec<&Model> = lights.iter().map(|l| l.model).collect();
        must_fit(material, schedule, &models)?;
        for light in &lights {
            let pixels = light.model.patterns().iter().map(|p| p.len()).sum();
            if light.patterns.len() != pixels {
                return Err(Error::shape(
                    "patterns of a light",
                    vec![pixels],
                    vec![light.patterns.len()],
                ));
            }
        }
        Ok(PrintRun {
            material,
            renewed: lights.iter().map(|_| None).collect(),
            lights,
            schedule,
            step_s: default_step_s(material, schedule),
            renewal: None,
        })
    }

    /// Blocks of at most that, s.
    ///
    /// # Errors
    /// [`Error::Config`] at `step_s` above the stability limit, which it names.
    pub fn with_step_s(mut self, step_s: f64) -> Result<Self> {
        check_step(self.material, step_s)?;
        self.step_s = step_s;
        Ok(self)
    }

    /// New dose models at least so many seconds apart.
    #[must_use]
    pub fn with_renewal(mut self, every_s: f64, renew: &'a mut Renew<'a>) -> Self {
        self.renewal = Some((every_s, renew));
        self
    }

    /// Prints, and shows every moment; it ends early where the observer says so. Returns the last state.
    ///
    /// # Errors
    /// Those of material, dose models and callback; [`Error::Canceled`].
    pub fn run(
        &mut self,
        work: &Work,
        observer: &mut dyn FnMut(&Moment) -> ControlFlow<()>,
    ) -> Result<State> {
        let blocks = self.schedule.blocks(self.step_s)?;
        let mut state = self.material.start()?;
        let mut light = Vec::new();
        for source in &self.lights {
            light.push(Illumination::new(source.model)?);
        }
        let dark: Vec<&[f32]> = light.iter().map(|_| &[] as &[f32]).collect();
        let start = self.moment(&state, [0, blocks.len()], 0.0, &dark);
        if observer(&start).is_break() {
            return Ok(state);
        }
        let mut renewed_at = 0.0;
        let steps = work.steps(blocks.len());
        for (i, block) in blocks.iter().enumerate() {
            work.check()?;
            self.renew(&mut state, block, &mut renewed_at)?;
            self.shine(&mut light, block, work)?;
            let absorbed: Vec<&[f32]> = light.iter().map(Illumination::absorbed).collect();
            self.material.step(&mut state, &absorbed, block.seconds)?;
            steps.add(1);
            let moment = self.moment(&state, [i + 1, blocks.len()], block.seconds, &absorbed);
            if observer(&moment).is_break() {
                break;
            }
        }
        Ok(state)
    }

    fn moment<'m>(
        &'m self,
        state: &'m State,
        steps: [usize; 2],
        block_s: f64,
        absorbed: &'m [&'m [f32]],
    ) -> Moment<'m> {
        Moment {
            seconds: state.seconds,
            steps,
            block_s,
            material: self.material,
            state,
            absorbed,
        }
    }

    fn shine(&self, light: &mut [Illumination], block: &Block, work: &Work) -> Result<()> {
        for (l, (light, source)) in light.iter_mut().zip(&self.lights).enumerate() {
            let model = self.renewed[l].as_deref().unwrap_or(source.model);
            light.absorb(model, source.patterns, &block.lit[l], work)?;
        }
        Ok(())
    }

    /// New models where it is time for them, of lights that shine soon.
    fn renew(&mut self, state: &mut State, block: &Block, at: &mut f64) -> Result<()> {
        let Some((every_s, renew)) = &mut self.renewal else {
            return Ok(());
        };
        let is_due = block.begin_s - *at >= *every_s * (1.0 - 1e-9);
        if !is_due || block.lit.iter().all(Vec::is_empty) {
            return Ok(());
        }
        *at = block.begin_s;
        for (l, source) in self.lights.iter().enumerate() {
            let Some(absorption) = self.material.absorption(state, l) else {
                continue;
            };
            let model = renew(l, &absorption)?;
            if model.outputs() != source.model.outputs()
                || model.patterns() != source.model.patterns()
            {
                return Err(Error::unsupported(
                    format!("a renewed dose model of light {l}"),
                    "it has other voxels or pixels than the first",
                ));
            }
            self.renewed[l] = Some(model);
            self.material.light_was_renewed(state, l);
        }
        Ok(())
    }
}

/// The step of a print that names none: a hundredth of it, at most a second, at most what is stable, s.
#[must_use]
pub fn default_step_s(material: &Photopolymer, schedule: &Schedule) -> f64 {
    let plain = LONGEST_S.min(schedule.end_s() / FEWEST_STEPS);
    plain.min(material.longest_step_s())
}

/// The longest stable step where a step is longer, s: with five digits, none of them rounded up, so that the number in the message is accepted.
#[must_use]
pub fn exceeded_limit_s(material: &Photopolymer, step_s: f64) -> Option<f64> {
    let limit = material.longest_step_s();
    if step_s <= limit {
        return None;
    }
    let unit = 10f64.powi(limit.log10().floor() as i32 - 4);
    // 0.016667 and not 0.016667000000000001
    let text = format!("{:.4e}", (limit / unit).floor() * unit);
    Some(text.parse().unwrap_or(limit))
}

pub(crate) fn check_step(material: &Photopolymer, step_s: f64) -> Result<()> {
    if step_s > 0.0 && exceeded_limit_s(material, step_s).is_none() {
        return Ok(());
    }
    let most = exceeded_limit_s(material, f64::INFINITY).map_or_else(String::new, |limit| {
        format!(
            " and at most {limit} s, the stability limit of diffusion through voxel faces (or diffusion = \"spectral\")"
        )
    });
    Err(Error::config(
        "step_s",
        format!("found {} s", exact(step_s)),
        format!("a time above 0{most}"),
    ))
}

/// Refuses lights that do not fit to material and schedule.
pub(crate) fn must_fit(
    material: &Photopolymer,
    schedule: &Schedule,
    models: &[&Model],
) -> Result<()> {
    for (what, count) in [
        ("columns of the mixing matrix", material.drives().lights()),
        ("lights of the schedule", schedule.frames().len()),
    ] {
        if count != models.len() {
            return Err(Error::config(
                "light",
                format!("{} dose models for {count} {what}", models.len()),
                "one dose model per light",
            ));
        }
    }
    let layout = material.domain().layout();
    for (l, model) in models.iter().enumerate() {
        must_show(frames_of(model.patterns()), l, schedule.frames()[l])?;
        let fits = matches!(model.outputs(), [output] if output.grid == layout.grid
            && output.cells.is_none()
            && output.offset == 0);
        if !fits {
            return Err(Error::unsupported(
                format!("the dose model of light {l}"),
                "its dose must be one, on the voxels of the material, without surface-aware cells",
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
