//! The voxels and pixels on which patterns are optimized, from coarse to fine.
//!
//! **Voxels finer than pixels.** A print has details that a voxel as large as a pixel does not see, so an objective that weighs a voxel by the
//! share that is part (`surface = "fraction"`, the default) is asked on voxels of a quarter of a pixel, as far as [`BUDGET`] allows. Along z
//! they stay as high as a row of pixels: collimated light is the same at all heights of a row, and the share of a voxel that is part says
//! all that finer slices would. A voxel of height q and width p/4 costs 16 times a cube of the pixel, where cubes of p/4 would cost 64
//! times.
//!
//! **Turning.** Where the vial turns by more than half a pixel at the rim of the part during a frame, the frame is averaged at up to
//! [`MOST_ANGLES`] angles. Each angle costs as much as a frame that stands still.
//!
//! **Coarse first** only where the job's own voxels cost more than the budget: half of the iterations run on half as many frames,
//! pixels and voxels along every axis. Elsewhere coarse iterations would save a third of the time and print less well (docs/fidelity.md).
//!
//! **Cells** are cut from voxels of half a pixel, as far as [`BUDGET_OF_CELLS`] allows: a mean over a cell does not hold the light within it.

use super::build::Optics;
use super::cells;
use super::multiresolution::{coarser_grid, coarser_lights, is_large_enough};
use super::resolve::optimizer;
use super::spec::{Against, JobSpec};
use crate::error::Result;
use crate::grid::VolumeGrid;
use crate::models::parallel::Light;
use crate::models::{ModelFamily, Refines};
use crate::objective::voxel_weights::Common;
use crate::objective::{OBJECTIVES, threshold};
use crate::report::number::significant;

/// What a dose on voxels finer than the job's, at more angles, may cost, in voxel-angle updates: 40 iterations on the gyroid of
/// docs/fidelity.md, which nearly reaches it, take a minute of processor time.
const BUDGET: f64 = 1.3e10;
/// Finding the pixels that light a column of voxels takes as long as lighting so many of its voxels.
const COLUMN: usize = 64;
/// Voxels across a pixel, as fine as the judge's of docs/fidelity.md; finer ones have not been tried.
const PER_PIXEL: f64 = 4.0;
/// The same where voxels are cut into cells.
const CELLS_PER_PIXEL: f64 = 2.0;
/// Voxel-angle updates of a dose by rays through cells that are affordable: 0.3 to 5 s on two cores, with and without kept walks.
const BUDGET_OF_CELLS: f64 = 8e8;
/// Angles at which a frame is averaged at most.
const MOST_ANGLES: usize = 4;
/// Rounding of lengths, in voxels.
const ROUNDING: f64 = 1e-6;

/// Some iterations on some voxels with some lights.
#[derive(Clone, Debug)]
pub(crate) struct Level {
    /// The voxels.
    pub(crate) grid: VolumeGrid,
    /// The lights, with the angles at which their frames are averaged.
    pub(crate) lights: Vec<Light>,
    /// The iterations after it, counted from the start.
    pub(crate) until: usize,
}

impl Level {
    fn new(grid: VolumeGrid, lights: &[Light], sub_angles: Option<usize>, until: usize) -> Self {
        let mut lights = lights.to_vec();
        for light in &mut lights {
            light.sub_angles = sub_angles.unwrap_or(light.sub_angles);
        }
        Level {
            grid,
            lights,
            until,
        }
    }
}

/// What the iterations of all levels cost, relative to `iterations` on the job's own voxels.
pub(super) fn effort(
    levels: &[Level],
    grid: &VolumeGrid,
    lights: &[Light],
    iterations: usize,
) -> f64 {
    let mut done = 0;
    let mut sum = 0.0;
    for level in levels {
        sum += (level.until - done) as f64 * updates(&level.grid, &level.lights);
        done = level.until;
    }
    sum / (iterations.max(1) as f64 * updates(grid, lights))
}

/// What a dose costs, in voxel-angle updates before masks.
fn updates(grid: &VolumeGrid, lights: &[Light]) -> f64 {
    let angles = |light: &Light| light.pixels.frames() * light.sub_angles;
    let [nz, ny, nx] = grid.shape;
    ((nz + COLUMN) * ny * nx) as f64 * lights.iter().map(angles).sum::<usize>() as f64
}

/// The levels of a job, the finest last.
///
/// # Errors
/// [`Error::Config`](crate::Error::Config) for an objective that is none.
pub(super) fn levels(
    spec: &JobSpec,
    (optics, family): (&Optics, &dyn ModelFamily),
    grid: &VolumeGrid,
    bounds_mm: [[f64; 3]; 2],
) -> Result<Vec<Level>> {
    let lights = &optics.lights;
    let iterations = spec.stop.iterations;
    if let Some(coarse) = &spec.multiresolution {
        let mut levels: Vec<Level> = (1..=coarse.levels)
            .rev()
            .filter(|level| is_large_enough(optics, grid, 1 << level))
            .map(|level| {
                (
                    coarser_grid(grid, 1 << level),
                    coarser_lights(lights, 1 << level),
                )
            })
            .enumerate()
            .map(|(i, (grid, lights))| Level::new(grid, &lights, None, (i + 1) * coarse.iterations))
            .collect();
        let until = levels.len() * coarse.iterations + iterations;
        levels.push(Level::new(grid.clone(), lights, None, until));
        return Ok(levels);
    }
    let refines = family.capabilities().refines;
    if !is_free(spec, refines)? {
        let has_cells = has_free_cells(spec, refines)?;
        let fine = has_cells.then(|| of_cells(spec, lights, grid));
        let grid = fine.unwrap_or_else(|| grid.clone());
        return Ok(vec![Level::new(grid, lights, None, iterations)]);
    }
    let (fine, sub_angles) = match spec.grid.refine {
        Some(refine) => {
            let along = along(grid, lights).min(refine);
            let across = refine.next_multiple_of(along);
            (
                grid.divided(across, along),
                fit_angles(spec, lights, bounds_mm, |_| true),
            )
        }
        None => finest(spec, lights, grid, bounds_mm),
    };
    let half = iterations / 2;
    let is_costly = spec.grid.refine.is_none() && updates(grid, lights) > BUDGET;
    let mut levels = Vec::new();
    if is_costly && half > 0 && is_large_enough(optics, grid, 2) {
        let lights = coarser_lights(lights, 2);
        levels.push(Level::new(coarser_grid(grid, 2), &lights, None, half));
    }
    levels.push(Level::new(fine, lights, Some(sub_angles), iterations));
    Ok(levels)
}

/// How much finer than a job's voxels those of an evaluation are at least.
pub(super) const LEAST_REFINE: usize = 2;
/// Voxels of an evaluation that is made finer than that.
const JUDGED: usize = 30_000_000;

/// How many times finer than the job's the voxels of the evaluation are: no coarser than the optimization's, as far as they are not too many.
pub(super) fn judged(grid: &VolumeGrid, levels: &[Level]) -> usize {
    let finest = levels
        .last()
        .map_or(1, |level| level.grid.shape[2] / grid.shape[2]);
    (LEAST_REFINE..=finest.max(LEAST_REFINE))
        .rev()
        .find(|&refine| grid.refined(refine).len() <= JUDGED)
        .unwrap_or(LEAST_REFINE)
}

/// What to say of voxels that the job did not ask for.
pub(super) fn note(levels: &[Level], grid: &VolumeGrid) -> Option<String> {
    let of = |level: &Level| {
        let [nz, ny, nx] = level.grid.shape;
        let angles = match level.lights[0].sub_angles {
            1 => String::new(),
            angles => format!(", {angles} angles a frame"),
        };
        let pitch = significant(level.grid.pitch_mm, 3);
        format!("{nx} × {ny} × {nz} voxels {pitch} mm wide{angles}")
    };
    match levels {
        [first, .., last] => Some(format!(
            "patterns are optimized on {} up to iteration {}, then on {}",
            of(first),
            first.until,
            of(last)
        )),
        [level] if level.grid != *grid => Some(format!("patterns are optimized on {}", of(level))),
        _ => None,
    }
}

/// Whether the program chooses the levels: the objective sees fractions, the model takes voxels of any width, and nothing is asked of the
/// job's own voxels.
fn is_free(spec: &JobSpec, refines: Refines) -> Result<bool> {
    Ok(refines == Refines::Voxels && !asks_of_voxels(spec) && sees_fractions(spec)?)
}

/// Whether a run ends by what the job's own voxels say, or prints in time on them.
fn asks_of_voxels(spec: &JobSpec) -> bool {
    let in_time = spec.schedule.as_ref();
    let is_in_time = in_time.is_some_and(|schedule| schedule.optimize != Against::Dose);
    spec.stop.iou.is_some() || spec.stop.loss > 0.0 || is_in_time
}

/// Whether the program chooses the voxels of a job with surface-aware cells.
fn has_free_cells(spec: &JobSpec, refines: Refines) -> Result<bool> {
    if refines != Refines::Cells || asks_of_voxels(spec) || cells::key(spec)?.is_none() {
        return Ok(false);
    }
    for section in spec.objectives()? {
        if Common::split(section)?.0.has_fields() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The voxels of a job with cells: at most half a pixel, as far as [`BUDGET_OF_CELLS`] allows. A mean over a cell does not hold the
/// light within it (docs/measured/rays.md).
fn of_cells(spec: &JobSpec, lights: &[Light], grid: &VolumeGrid) -> VolumeGrid {
    let wanted = across(grid, lights, CELLS_PER_PIXEL);
    (1..=spec.grid.refine.unwrap_or(wanted))
        .rev()
        .map(|refine| grid.refined(refine))
        .find(|fine| spec.grid.refine.is_some() || updates(fine, lights) <= BUDGET_OF_CELLS)
        .unwrap_or_else(|| grid.clone())
}

/// Parts into which a voxel is cut, so that so many of them are no wider than the narrowest pixel.
fn across(grid: &VolumeGrid, lights: &[Light], per_pixel: f64) -> usize {
    let pixel = |light: &Light| light.pixels.pitch_mm[0];
    let narrowest = lights.iter().map(pixel).fold(f64::INFINITY, f64::min);
    (grid.pitch_mm * per_pixel / narrowest - ROUNDING)
        .ceil()
        .max(1.0) as usize
}

/// Slices into which a voxel is cut, so that none is higher than a row of pixels.
fn along(grid: &VolumeGrid, lights: &[Light]) -> usize {
    let row = |light: &Light| light.pixels.pitch_mm[1];
    let lowest = lights.iter().map(row).fold(f64::INFINITY, f64::min);
    (grid.height_mm / lowest - ROUNDING).ceil().max(1.0) as usize
}

/// The finest voxels that the budget allows, and the angles at which frames are averaged.
fn finest(
    spec: &JobSpec,
    lights: &[Light],
    grid: &VolumeGrid,
    bounds_mm: [[f64; 3]; 2],
) -> (VolumeGrid, usize) {
    let along = along(grid, lights);
    let wanted = across(grid, lights, PER_PIXEL);
    let cost = |grid: &VolumeGrid, angles: usize| {
        let frames = lights
            .iter()
            .map(|light| light.pixels.frames())
            .sum::<usize>();
        let [nz, ny, nx] = grid.shape;
        ((nz + COLUMN) * ny * nx) as f64 * (frames * angles) as f64
    };
    let turning = fit_angles(spec, lights, bounds_mm, |_| true);
    let fine = (1..=wanted.next_multiple_of(along))
        .rev()
        .filter(|across| across % along == 0)
        .map(|across| grid.divided(across, along))
        .find(|fine| cost(fine, turning.min(2)) <= BUDGET);
    match fine {
        Some(fine) => {
            let angles = fit_angles(spec, lights, bounds_mm, |n| cost(&fine, n) <= BUDGET);
            (fine, angles)
        }
        None => (grid.clone(), spec.light[0].sub_angles.unwrap_or(1)),
    }
}

/// Angles at which frames are averaged: those of the job, or one for every half pixel that the rim of the part moves during a frame.
fn fit_angles(
    spec: &JobSpec,
    lights: &[Light],
    [low, high]: [[f64; 3]; 2],
    fits: impl Fn(usize) -> bool,
) -> usize {
    if let Some(given) = spec.light[0].sub_angles {
        return given;
    }
    let rim = f64::hypot(high[0].max(-low[0]), high[1].max(-low[1]));
    let moved = |light: &Light| rim * light.pixels.frame_arc / light.pixels.pitch_mm[0];
    let most = lights.iter().map(moved).fold(0.0, f64::max);
    let wanted = (2.0 * most - ROUNDING)
        .ceil()
        .clamp(1.0, MOST_ANGLES as f64) as usize;
    (1..=wanted).rev().find(|&n| fits(n)).unwrap_or(1)
}

/// Whether all objectives weigh a voxel by its inside fraction, none has numbers of its own for the job's voxels, and the method minimizes
/// them: one that compares doses with the target itself knows part and void alone.
///
/// # Errors
/// [`Error::Config`](crate::Error::Config) for an objective that is none.
pub(super) fn sees_fractions(spec: &JobSpec) -> Result<bool> {
    if optimizer(spec)?.requirements().target.is_some() {
        return Ok(false);
    }
    for section in spec.objectives()? {
        let (common, section) = Common::split(section)?;
        let (kind, inner) = section.kind(OBJECTIVES)?;
        let default = if kind.name == "threshold" {
            "fraction"
        } else {
            "voxel"
        };
        let surface = inner.value.get("surface").and_then(|s| s.as_str());
        if surface.unwrap_or(default) != "fraction" || common.has_fields() {
            return Ok(false);
        }
    }
    Ok(true)
}

/// By how much a wider window lowers what the void may have.
pub(super) const WIDER: f64 = 0.05;

/// The job with a wider window: what the void may have at most is lower by `steps` of [`WIDER`]. None where the job names thresholds, or no
/// lower one is left.
///
/// # Errors
/// [`Error::Config`](crate::Error::Config) for an objective that is none.
pub(super) fn widened(spec: &JobSpec, steps: usize) -> Result<Option<JobSpec>> {
    let sections = spec.objectives()?;
    let [section] = sections.as_slice() else {
        return Ok(None);
    };
    let (kind, inner) = Common::split(section.clone())?.1.kind(OBJECTIVES)?;
    let named = ["lower", "upper"]
        .iter()
        .any(|key| inner.value.get(key).is_some());
    let lower = threshold::Params::default().lower - steps as f64 * WIDER;
    if kind.name != threshold::NAME || named || lower < WIDER {
        return Ok(None);
    }
    let mut spec = spec.clone();
    let mut parameters = inner.value.as_object().cloned().unwrap_or_default();
    parameters.insert("lower".to_owned(), lower.into());
    let mut table = match spec.objective.take() {
        Some(serde_json::Value::Object(table)) => table,
        _ => serde_json::Map::new(),
    };
    table.insert(kind.name.to_owned(), parameters.into());
    spec.objective = Some(table.into());
    Ok(Some(spec))
}

#[cfg(test)]
mod tests {
    use super::super::build::Optics;
    use super::*;
    use crate::job::Job;
    use crate::models::{OpticalScene, planner};
    use crate::target::Shape;
    use std::sync::Arc;

    /// Pitches of the levels of a small job, with further lines.
    fn pitches(surface: &str, more: &[&str]) -> Vec<f64> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("job.toml");
        let text = format!(
            r#"
            target = {{ phantom = {{ sphere = {{}} }}, size_mm = 0.8 }}
            grid = {{ pitch_mm = 0.1 }}
            resin = {{ refractive_index = 1.5, absorption_per_mm = 0.1 }}
            vial = {{ index_matched = {{ radius_mm = 1.0 }} }}
            light = [{{ pixels = [24, 16], angles = 12, projector = {{ collimated = {{ pixel_pitch_mm = 0.1 }} }} }}]
            objective = {{ threshold = {{ surface = "{surface}" }} }}
            "#
        );
        std::fs::write(&file, text).unwrap();
        let more: Vec<String> = more.iter().map(|&s| s.to_owned()).collect();
        let job = Job::read(&file, &more).unwrap();
        let optics = Optics::new(&job.spec, &job.base()).unwrap();
        let grid = VolumeGrid::centered([10, 10, 10], 0.1);
        let bounds = [[-0.4; 3], [0.4; 3]];
        let shape = crate::target::build(&job.spec.target, &job.base(), "target").unwrap();
        let shape: Arc<dyn Shape> = Arc::from(shape);
        let scene = OpticalScene {
            solid: (surface == "cells").then_some(&shape),
            ..optics.scene()
        };
        let family = planner::choose(optics.model.as_ref(), &scene, &grid).unwrap();
        let of = (&optics, family.as_ref());
        let levels = levels(&job.spec, of, &grid, bounds).unwrap();
        levels.iter().map(|level| level.grid.pitch_mm).collect()
    }

    #[test]
    fn cells_are_cut_from_half_pixels_where_the_job_leaves_it_open() {
        assert_eq!(pitches("cells", &[]), [0.05]);
        assert_eq!(pitches("cells", &["grid.refine=1"]), [0.1]);
        assert_eq!(pitches("cells", &["stop.iou=0.9"]), [0.1]);
        assert_eq!(pitches("voxel", &[]), [0.1]);
        assert_eq!(pitches("fraction", &[]), [0.025]);
    }
}
