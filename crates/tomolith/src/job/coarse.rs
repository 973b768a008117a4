//! A start from coarser levels: the problem is solved on half the voxels, pixels and frames first, and what was found there is the
//! start of the next level.
//!
//! A level has an eighth of the voxels and half of the frames of the next, so an iteration costs a sixteenth of it; the outermost
//! level begins from the job's `[start]`. Targets and objectives are made anew on each grid; thresholds mean the same, since
//! doses do. Details finer than two voxels of the coarsest level are only seen later.

use super::optimise::{limits, starting_patterns};
use super::scene::Scene;
use crate::error::Result;
use crate::grid::{PatternGrid, Patterns, VolumeGrid};
use crate::models::dimmed::darken;
use crate::models::parallel::Light;
use crate::models::{Run, planner};
use crate::optimize::start::given::Given;
use crate::optimize::{self, Counters, Problem, Stop};

/// Smallest number of voxels along an edge, and of frames, that a level may have.
const LEAST: usize = 8;

/// What the coarser levels came to.
pub(super) struct Coarse {
    /// The start of the finest level.
    pub(super) start: Given,
    /// One sentence for people.
    pub(super) note: String,
}

/// What to say of levels that are too small to be made.
pub(super) fn left_out(scene: &Scene) -> Option<String> {
    let asked = scene.spec.coarse.as_ref()?.levels;
    let made = (1..=asked).filter(|level| has(scene, 1 << level)).count();
    (made < asked).then(|| {
        format!(
            "coarse.levels = {asked}: {made} of them can be made; the others have fewer than {LEAST} voxels along an edge, fewer than {LEAST} frames, \
             or pixels that the model cannot work with"
        )
    })
}

/// Whether a level is large enough, and its pixels are some that the model can work with: not larger than its aperture's.
fn has(scene: &Scene, factor: usize) -> bool {
    let grid = coarser_grid(&scene.grid, factor);
    let lights = coarser_lights(scene, factor);
    let covered = scene
        .setup()
        .must_be_covered(&scene.optics.model, &lights, &grid);
    grid.shape[1] >= LEAST
        && lights.iter().all(|light| light.pixels.frames() >= LEAST)
        && covered.is_ok()
}

fn coarser_lights(scene: &Scene, factor: usize) -> Vec<Light> {
    let lights = scene.optics.lights.iter();
    lights.map(|light| coarser_light(light, factor)).collect()
}

/// Solves the coarser levels of a job; None when it asks for none, or is too small for any.
///
/// # Errors
/// Those of the optimisation itself.
pub(super) fn solve(scene: &Scene, run: &Run) -> Result<Option<Coarse>> {
    let Some(coarse) = &scene.spec.coarse else {
        return Ok(None);
    };
    let mut found: Option<Given> = None;
    let mut done = Vec::new();
    for level in (1..=coarse.levels).rev() {
        let factor = 1 << level;
        if !has(scene, factor) {
            continue;
        }
        let grid = coarser_grid(&scene.grid, factor);
        let lights = coarser_lights(scene, factor);
        let (patterns, counters) = solve_level(scene, &grid, lights, found.as_ref(), run)?;
        done.push(format!(
            "{:?} voxels: {} calls in {:.1} s",
            grid.shape,
            counters.forward + counters.adjoint,
            counters.model_s + counters.objective_s
        ));
        found = Some(Given(patterns));
    }
    Ok(found.map(|start| Coarse {
        start,
        note: format!("started from coarser levels ({})", done.join("; ")),
    }))
}

/// One level, from the patterns of the one before or the job's start.
fn solve_level(
    scene: &Scene,
    grid: &VolumeGrid,
    lights: Vec<Light>,
    start: Option<&Given>,
    run: &Run,
) -> Result<(Vec<Patterns>, Counters)> {
    let voxels = scene.voxels(grid)?;
    let plan = planner::plan(
        &scene.optics.model,
        scene.setup(),
        lights,
        grid.clone(),
        Some(&voxels.wanted()),
        run,
    )?;
    let (model, dark) = (plan.model.as_ref(), &plan.dark);
    let models = (model, plan.straight.as_deref());
    let objective = scene.objective(&model.outputs()[0], &voxels)?;
    let mut x = match start {
        Some(given) => starting_patterns(scene, &voxels, models, given, run)?,
        None => starting_patterns(scene, &voxels, models, scene.start()?.as_ref(), run)?,
    };
    darken(&mut x, dark);
    let mut optimizer = scene.optimizer()?;
    let limits = limits(&scene.spec, model, &x, optimizer.normalises());
    let mut problem =
        Problem::new(model, &objective, &limits, run)?.with_bits(scene.spec.bounds.bits)?;
    if optimizer.needs().target.is_some() {
        problem = problem.with_target(super::optimise::target_field(scene, &voxels, model)?);
    }
    let stop = Stop {
        iterations: scene.spec.coarse.as_ref().map_or(0, |c| c.iterations),
        ..Stop::default()
    };
    optimize::run(
        &mut problem,
        optimizer.as_mut(),
        &mut x,
        &stop,
        None,
        &mut [],
    )?;
    darken(&mut x, dark);
    let patterns = model
        .patterns()
        .iter()
        .map(|layout| layout.patterns_of(x.as_slice()))
        .collect();
    Ok((patterns, problem.counters))
}

/// The same box with voxels `factor` times as large (a little more of a box where the count is no multiple).
pub(super) fn coarser_grid(grid: &VolumeGrid, factor: usize) -> VolumeGrid {
    VolumeGrid {
        shape: grid.shape.map(|n| n.div_ceil(factor)),
        pitch_mm: grid.pitch_mm * factor as f64,
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
        selection: light.selection.mapped(|mask| {
            let fewer = mask.every(factor);
            fewer.coarser(factor, rows, columns)
        }),
        ..light.clone()
    }
}
