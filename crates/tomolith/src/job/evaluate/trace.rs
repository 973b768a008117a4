//! The light of single pixels: where its power goes, and a picture of its dose.

use crate::error::{Error, Result};
use crate::grid::Volume;
use crate::job::resolve::ResolvedJob;
use crate::job::spec::read::Job;
use crate::models::rays::Rays;
use crate::models::{DoseModel, Work};
use crate::optics::power_balance::PowerBalance;
use crate::optics::space::PathSegment;
use serde::Serialize;

/// A pixel of a job.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Pixel {
    /// Light, counted from 0.
    pub light: usize,
    /// Frame.
    pub frame: usize,
    /// Column, from 0.
    pub column: usize,
    /// Row, 0 = top.
    pub row: usize,
}

/// What became of a pixel's light.
#[derive(Clone, Debug, Serialize)]
pub struct Traced {
    /// The pixel.
    pub pixel: Pixel,
    /// Pieces of its middle ray in the resin, in order.
    pub segments: Vec<TracedSegment>,
    /// Where its power went: mean of its rays, per emitted power.
    pub account: PowerBalance,
    /// Monte Carlo paths of which it is the mean; None of a model that draws none.
    pub paths: Option<usize>,
}

/// Paths of a pixel where a job names no number of them: the standard error of a share is then at most 0.8 percentage points.
const PATHS: usize = 4096;

/// A straight piece in the resin.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct TracedSegment {
    /// Where it enters, mm.
    pub from_mm: [f64; 3],
    /// Where it ends, mm.
    pub to_mm: [f64; 3],
    /// Power at its beginning, per emitted power.
    pub power: f64,
}

impl From<PathSegment> for TracedSegment {
    fn from(segment: PathSegment) -> Self {
        TracedSegment {
            from_mm: segment.ray.from,
            to_mm: segment.ray.at(segment.length),
            power: segment.power,
        }
    }
}

/// Rays of the job's model, or of its optics, with the number of Monte Carlo paths of a pixel; refuses jobs whose light is not made of rays.
fn rays(resolved: &ResolvedJob) -> Result<(Rays, Option<usize>)> {
    let mut family = resolved.optics.family(&resolved.grid)?;
    if let Some(paths) = family.compared_with() {
        family = paths(PATHS, 0);
    }
    let paths = family.monte_carlo_paths().map(|paths| paths.optimizing);
    let none = || {
        Err(Error::config(
            format!("model.{}", family.name()),
            "`tomolith trace` follows rays, but this model has none",
            "another model: `--set 'model={rays={}}'` follows the rays that the same projector would send",
        ))
    };
    let rays = family.rays(&resolved.optics.scene(), &resolved.grid);
    Ok((rays.unwrap_or_else(none)?, paths))
}

/// Traces pixels of a job by the `rays` model, or the `monte_carlo` model where the resin scatters, and gives the dose of all of them at a value of 1.
///
/// # Errors
/// As a run, before any work; [`Error::Config`] for a pixel that is not there.
pub fn trace(job: &Job, pixels: &[Pixel], work: &Work) -> Result<(Vec<Traced>, Volume<f32>)> {
    let resolved = ResolvedJob::under(job, work)?;
    let (model, paths) = rays(&resolved).map_err(|e| job.locate(e))?;
    let lights = &resolved.optics.lights;
    for pixel in pixels {
        let Some(light) = lights.get(pixel.light) else {
            let found = format!("there is no light {}", pixel.light);
            let accepted = format!("lights below {}", lights.len());
            return Err(Error::config("--light", found, accepted));
        };
        let shape = light.pixels.shape();
        let inside = pixel.frame < shape[0] && pixel.row < shape[1] && pixel.column < shape[2];
        if !inside {
            return Err(Error::config(
                "--pixel",
                format!(
                    "there is no frame {}, column {}, row {} of light {}",
                    pixel.frame, pixel.column, pixel.row, pixel.light
                ),
                format!(
                    "frames below {}, columns below {}, rows below {}",
                    shape[0], shape[2], shape[1]
                ),
            ));
        }
    }
    let mut x = model.new_patterns()?;
    let mut traced = Vec::with_capacity(pixels.len());
    for &pixel in pixels {
        let layout = &model.patterns()[pixel.light];
        let run = layout.runs[pixel.frame * layout.grid.columns + pixel.column];
        let from_below = layout.grid.rows - 1 - pixel.row;
        x.as_mut_slice()[run.offset + from_below - run.bottom as usize] = 1.0;
        let (segments, account) = model.trace(pixel.light, pixel.frame, pixel.column, from_below);
        traced.push(Traced {
            pixel,
            segments: segments.into_iter().map(TracedSegment::from).collect(),
            account,
            paths,
        });
    }
    let mut dose = model.new_dose()?;
    model.dose(&x, &mut dose, work)?;
    let volume = model.outputs()[0].volume_of(dose.as_slice());
    Ok((traced, volume))
}
