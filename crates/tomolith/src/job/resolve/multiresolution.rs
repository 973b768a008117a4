//! Coarser levels: half the voxels, pixels and frames along every axis.
//!
//! A level has an eighth of the voxels and half of the frames of the next, so an iteration costs a sixteenth of it. Targets and
//! objectives are made anew on each grid; thresholds mean the same, since doses do. Details finer than two voxels of the coarsest level
//! are only seen later.

use super::optics::Optics;
use crate::grid::{PatternGrid, VolumeGrid};
use crate::job::resolve::ResolvedJob;
use crate::models::planner;
use crate::optics::light::Light;
use std::sync::Arc;

/// Smallest number of voxels along an edge, and of frames, that a level may have.
const LEAST: usize = 8;

/// What to say of levels that are too small to be made.
pub(crate) fn left_out(job: &ResolvedJob) -> Option<String> {
    let asked = job.spec.multiresolution.as_ref()?.levels;
    let made = (1..=asked)
        .filter(|level| is_large_enough(&job.optics, &job.grid, 1 << level))
        .count();
    (made < asked).then(|| {
        format!(
            "multiresolution.levels = {asked}: {made} of them can be made; the others have fewer than {LEAST} voxels along an edge, fewer than {LEAST} frames, \
             or pixels that the model cannot work with"
        )
    })
}

/// Whether a level is large enough, and its pixels are some that the model can work with: not larger than its aperture's.
pub(crate) fn is_large_enough(optics: &Optics, grid: &VolumeGrid, factor: usize) -> bool {
    let grid = coarser_grid(grid, factor);
    let lights = coarser_lights(&optics.lights, factor);
    let job = optics.scene().lit_by(&lights);
    let covered = planner::choose(optics.model.as_ref(), &job, &grid)
        .and_then(|family| family.check(&job, &grid));
    grid.shape[1] >= LEAST
        && lights.iter().all(|light| light.pixels.frames() >= LEAST)
        && covered.is_ok()
}

/// The same lights with every `factor`-th frame and pixels `factor` times as large.
pub(crate) fn coarser_lights(lights: &[Light], factor: usize) -> Vec<Light> {
    let lights = lights.iter();
    lights.map(|light| coarser_light(light, factor)).collect()
}

/// The same box with voxels `factor` times as large (a little more of a box where the count is no multiple).
pub(crate) fn coarser_grid(grid: &VolumeGrid, factor: usize) -> VolumeGrid {
    VolumeGrid {
        shape: grid.shape.map(|n| n.div_ceil(factor)),
        pitch_mm: grid.pitch_mm * factor as f64,
        height_mm: grid.height_mm * factor as f64,
        center_mm: grid.center_mm,
    }
}

/// The same light with every `factor`-th frame and pixels `factor` times as large.
fn coarser_light(light: &Light, factor: usize) -> Light {
    let pixels = &light.pixels;
    let (rows, columns) = (
        pixels.rows.div_ceil(factor),
        pixels.columns.div_ceil(factor),
    );
    Light {
        pixels: PatternGrid {
            azimuths: pixels.azimuths.iter().copied().step_by(factor).collect(),
            frame_arc: pixels.frame_arc * factor as f64,
            rows,
            columns,
            pitch_mm: pixels.pitch_mm.map(|mm| mm * factor as f64),
            offset_mm: pixels.offset_mm,
        },
        active: None,
        point_spread: (light.point_spread.as_ref()).map(|spread| Arc::new(spread.coarser(factor))),
        selection: light.selection.mapped(|mask| {
            let fewer = mask.every(factor);
            fewer.coarser(factor, rows, columns)
        }),
        ..light.clone()
    }
}
