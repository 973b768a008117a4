//! The voxels and pixels on which patterns are optimized, from coarse to fine.
//!
//! **Voxels finer than pixels.** A print has details that a voxel as large as a pixel does not see, so an objective that weighs a voxel by the
//! share that is part (`surface = "fraction"`, the default) is optimized on voxels of a quarter of a pixel, as far as [`BUDGET`] allows. Along z
//! they stay as high as a row of pixels: collimated light is the same at all heights of a row, and the share of a voxel that is part says
//! all that finer slices would. A voxel of height q and width p/4 costs 16 times a cube of the pixel, where cubes of p/4 would cost 64
//! times.
//!
//! **Turning.** Where the vial turns by more than half a pixel at the rim of the part during a frame, the frame is averaged at up to
//! [`MOST_ANGLES`] angles, which cost little where the model stores its entries, and elsewhere as much as so many frames that stand still.
//!
//! **Fourth powers.** On such voxels [`threshold`] counts deviations to the power of [`EXPONENT`] unless the job names one: the largest decide what prints
//! wrong. On voxels as wide as a pixel that prints less well (docs/choices.md).
//!
//! **No higher than the light.** Light stays at its height, so rows of pixels that reach no part stay dark, and slices that only these rows light have no dose:
//! such slices are left out.
//!
//! **Coarse first** only where the job's voxels cost more than the budget: half of the iterations run on half as many frames,
//! pixels and voxels along every axis. Elsewhere coarse iterations would save a third of the time and print less well (docs/choices.md).
//!
//! **Cells** are cut from voxels of half a pixel, as far as [`BUDGET_OF_CELLS`] allows: a mean over a cell does not hold the light within it.

use super::ResolvedJob;
use super::goal::Goal;
use super::method::Method;
use super::multiresolution::{coarser_grid, coarser_lights, is_large_enough};
use super::optics::Optics;
use super::species::Species;
use crate::grid::VolumeGrid;
use crate::job::spec::output::LEAST_REFINE;
use crate::job::spec::{JobSpec, ScheduleSpec};
use crate::models::{ModelFamily, Refines};
use crate::objective::{Chosen, threshold};
use crate::optics::light::Light;
use crate::report::number::significant;

/// What a dose on voxels finer than the job's, at more angles, may cost, in voxel-angle updates: 40 iterations on the gyroid of
/// docs/fidelity.md, which nearly reaches it, take a minute of processor time.
const BUDGET: f64 = 1.3e10;
/// Finding the pixels that light a column of voxels takes as long as lighting so many of its voxels.
const COLUMN: usize = 64;
/// Voxels across a pixel, as fine as those of the evaluation in docs/fidelity.md; finer ones have not been tried.
const PER_PIXEL: f64 = 4.0;
/// Voxels across a pixel where they are cut into cells.
const CELLS_PER_PIXEL: f64 = 2.0;
/// Voxel-angle updates of a dose by rays through cells that are affordable: 0.3 to 5 s on two cores, with and without stored rays.
const BUDGET_OF_CELLS: f64 = 8e8;
/// Angles at which a frame is averaged at most.
const MOST_ANGLES: usize = 4;
/// Angles of a frame that count against the budget at most: more are free where the model stores its entries, and cost up to twice the time where they
/// are too many to store.
const PAID_ANGLES: usize = 2;
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

/// What a job asks of its voxels.
#[derive(Clone, Copy)]
pub(crate) struct Asked<'a> {
    pub(crate) spec: &'a JobSpec,
    pub(crate) method: &'a Method,
    pub(crate) species: &'a [Species],
}

impl Level {
    fn new(grid: VolumeGrid, lights: &[Light], until: usize) -> Self {
        let lights = lights.to_vec();
        Level {
            grid,
            lights,
            until,
        }
    }
}

/// Lights whose frames are averaged at so many angles, a number for each light.
fn turned(lights: &[Light], sub_angles: &[usize]) -> Vec<Light> {
    let turned = |(light, &sub_angles): (&Light, &usize)| Light {
        sub_angles,
        ..light.clone()
    };
    lights.iter().zip(sub_angles).map(turned).collect()
}

/// What the iterations of all levels cost, relative to `iterations` on the job's voxels. `entries`: along which calls sum on the finest
/// voxels and on the job's, 0 where they are not stored; the time of a call is proportional to them.
pub(crate) fn effort(
    levels: &[Level],
    grid: &VolumeGrid,
    lights: &[Light],
    iterations: usize,
    entries: [f64; 2],
) -> f64 {
    if levels.len() == 1 && entries.iter().all(|&entries| entries > 0.0) {
        return entries[0] / entries[1];
    }
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
pub(crate) fn levels(
    asked: Asked<'_>,
    optics: &Optics,
    family: &dyn ModelFamily,
    grid: &VolumeGrid,
    bounds_mm: [[f64; 3]; 2],
) -> Vec<Level> {
    let (spec, lights) = (asked.spec, &optics.lights);
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
            .map(|(i, (grid, lights))| Level::new(grid, &lights, (i + 1) * coarse.iterations))
            .collect();
        let until = levels.len() * coarse.iterations + iterations;
        levels.push(Level::new(grid.clone(), lights, until));
        return levels;
    }
    let refines = family.capabilities().refines;
    if !is_free(asked, refines) {
        let has_cells = has_free_cells(asked, refines);
        let fine = has_cells.then(|| of_cells(spec, lights, grid));
        let grid = fine.unwrap_or_else(|| grid.clone());
        return vec![Level::new(grid, lights, iterations)];
    }
    let (fine, sub_angles) = match spec.grid.refine {
        Some(refine) => {
            let along = along(grid, lights).min(refine);
            let across = refine.next_multiple_of(along);
            (
                grid.divided(across, along),
                turning_angles(spec, lights, bounds_mm),
            )
        }
        None => finest(spec, lights, grid, bounds_mm),
    };
    let half = iterations / 2;
    let is_costly =
        spec.grid.refine.is_none() && updates(grid, lights) > BUDGET && !spec.shows_every_frame();
    let mut levels = Vec::new();
    if is_costly && half > 0 && is_large_enough(optics, grid, 2) {
        let lights = coarser_lights(lights, 2);
        levels.push(Level::new(coarser_grid(grid, 2), &lights, half));
    }
    let is_chosen = spec.grid.refine.is_none() && fine != *grid;
    let fine = if is_chosen && is_dark_beyond(asked, lights) {
        within_lit_rows(fine, lights, bounds_mm)
    } else {
        fine
    };
    levels.push(Level::new(fine, &turned(lights, &sub_angles), iterations));
    levels
}

/// Whether rows of pixels that do not reach the part stay dark, nothing counts the voxels that they light, and no dose diffuses there.
fn is_dark_beyond(asked: Asked<'_>, lights: &[Light]) -> bool {
    let Asked {
        spec,
        method,
        species,
    } = asked;
    let spreads = lights.iter().any(|light| light.point_spread.is_some());
    let seeks = species.iter().any(|species| species.goal.seeks_window());
    let has_one_part = spec.species.len() <= 1 && spec.scenario.is_empty();
    let stays = spec.material.is_none();
    let is_lit = lights.iter().any(|light| light.selection.has_background);
    let starts_dark = method.start.files().is_none() && !is_lit;
    has_one_part && stays && starts_dark && !spreads && !seeks
}

/// The slices of a grid that are lit by rows of pixels which reach the part.
fn within_lit_rows(grid: VolumeGrid, lights: &[Light], [low, high]: [[f64; 3]; 2]) -> VolumeGrid {
    let (mut lit_low, mut lit_high) = (low[2], high[2]);
    for light in lights {
        let pitch = light.pixels.pitch_mm[1];
        let edge = light.pixels.field_mm()[0][1];
        let row = |z: f64| (z - edge) / pitch;
        lit_low = lit_low.min(edge + pitch * (row(low[2]) + ROUNDING).floor());
        lit_high = lit_high.max(edge + pitch * (row(high[2]) - ROUNDING).ceil());
    }
    let bottom = grid.bounds_mm()[0][2];
    let slice = |z: f64| (z - bottom) / grid.height_mm;
    let first = (slice(lit_low) + ROUNDING).floor().max(0.0) as usize;
    let end = ((slice(lit_high) - ROUNDING).ceil() as usize).min(grid.shape[0]);
    if end <= first {
        return grid;
    }
    let moved = (first + end) as f64 / 2.0 - grid.shape[0] as f64 / 2.0;
    let [x, y, z] = grid.center_mm;
    VolumeGrid {
        shape: [end - first, grid.shape[1], grid.shape[2]],
        center_mm: [x, y, z + moved * grid.height_mm],
        ..grid
    }
}

/// Voxels of an evaluation that is made finer than that.
const JUDGED: usize = 30_000_000;

/// How many times finer than the job's the voxels of the evaluation are: no coarser than the optimization's, as far as they are not too many.
pub(crate) fn evaluation_refine(grid: &VolumeGrid, levels: &[Level]) -> usize {
    let finest = levels
        .last()
        .map_or(1, |level| level.grid.shape[2] / grid.shape[2]);
    (LEAST_REFINE..=finest.max(LEAST_REFINE))
        .rev()
        .find(|&refine| grid.refined(refine).len() <= JUDGED)
        .unwrap_or(LEAST_REFINE)
}

/// Voxels, and the angles at which the frames of lights are averaged, in words.
pub(crate) fn described(grid: &VolumeGrid, lights: &[Light]) -> String {
    let [nz, ny, nx] = grid.shape;
    let mut angles: Vec<usize> = lights.iter().map(|light| light.sub_angles).collect();
    angles.dedup();
    let angles = match &angles[..] {
        [1] => String::new(),
        [angles] => format!(", {angles} angles a frame"),
        of_lights => {
            let of_lights: Vec<String> = of_lights.iter().map(ToString::to_string).collect();
            format!(
                ", {} angles a frame, light by light",
                of_lights.join(" and ")
            )
        }
    };
    let pitch = significant(grid.pitch_mm, 3);
    format!("{nx} × {ny} × {nz} voxels {pitch} mm wide{angles}")
}

/// What to say of voxels that the job did not ask for.
pub(crate) fn note(levels: &[Level], grid: &VolumeGrid) -> Option<String> {
    let text_of = |level: &Level| described(&level.grid, &level.lights);
    let last = levels.last()?;
    if levels.len() == 1 && last.grid == *grid {
        return None;
    }
    let of_level = |level: &Level| match level.until == last.until {
        true => text_of(level),
        false => format!("{} up to iteration {}", text_of(level), level.until),
    };
    let all: Vec<String> = levels.iter().map(of_level).collect();
    Some(format!(
        "patterns are optimized on {}",
        all.join(", then on ")
    ))
}

/// What to say of `grid.refine` where nothing becomes finer by it.
pub(crate) fn unheard(spec: &JobSpec, levels: &[Level], grid: &VolumeGrid) -> Option<String> {
    let refine = spec.grid.refine.filter(|refine| *refine > 1)?;
    let finest = levels.last()?;
    (finest.grid.pitch_mm >= grid.pitch_mm).then(|| {
        format!(
            "grid.refine = {refine} changes nothing here: finer voxels are for collimated light, objectives with surface = \"fraction\" (or \"cells\") and \
             without region, weights and tolerance, and a job without [multiresolution], osmo, cal, and ends that the job's own voxels decide (stop.iou, stop.loss, stop.relative_loss); lower grid.pitch_mm"
        )
    })
}

/// What to say where weights or bands of the job's voxels keep the optimization from finer ones.
pub(crate) fn held_back(asked: Asked<'_>, family: &dyn ModelFamily) -> Option<String> {
    let goals = || asked.species.iter().map(|species| &species.goal);
    let would_refine = goals().all(Goal::weighs_fractions)
        && may_refine(asked, family.capabilities().refines)
        && asked.spec.multiresolution.is_none();
    (would_refine && goals().any(Goal::has_fields)).then(|| {
        "objectives with region, weights or tolerance keep the optimization on the job's own voxels, and at one angle a frame where light.sub_angles is not \
         set. For finer voxels lower grid.pitch_mm; to count the turn of the vial set light.sub_angles"
            .to_owned()
    })
}

/// Most voxels on which trials of a ceiling are judged that are finer than those of the optimization: those of the evaluation (docs/fidelity.md).
const MOST_JUDGED: usize = 30_000_000;

/// How many times finer than those of a level the voxels are on which its prints are judged while ceilings are tried: as many as in the evaluation, unless the
/// program chooses voxels so fine that the optimization sees inside of pixels, or paths are drawn at random.
pub(crate) fn judged_finer(job: &ResolvedJob, family: &dyn ModelFamily) -> usize {
    let is_fine = job.sees_within_pixels || family.monte_carlo_paths().is_some();
    if is_fine || !job.bounds().seek_ceiling() || job.schedule().is_some() {
        return 1;
    }
    let finest = job.levels.last().map_or(&job.grid, |level| &level.grid);
    (finest.pitch_mm / job.fine_grid().pitch_mm).round() as usize
}

/// These voxels, at most so many times finer, as far as they are affordable.
pub(crate) fn judged(grid: &VolumeGrid, finer: usize) -> VolumeGrid {
    (1..=finer)
        .rev()
        .map(|refine| grid.refined(refine))
        .find(|grid| grid.len() <= MOST_JUDGED)
        .unwrap_or_else(|| grid.clone())
}

/// Whether the program chooses the levels: the objective sees fractions, the model takes voxels of any width, and nothing is asked of the
/// job's own voxels.
pub(crate) fn is_free(asked: Asked<'_>, refines: Refines) -> bool {
    let mut goals = asked.species.iter().map(|species| &species.goal);
    may_refine(asked, refines) && goals.all(Goal::sees_fractions)
}

/// Whether model, method and ends of the run leave the voxels to the program.
fn may_refine(asked: Asked<'_>, refines: Refines) -> bool {
    refines == Refines::Voxels && !asks_of_voxels(asked.spec) && !asked.method.needs_target()
}

/// Whether the voxels are the program's choice unless the run ends by what the job's own voxels say.
pub(crate) fn depends_on_stop(asked: Asked<'_>, refines: Refines) -> bool {
    match refines {
        Refines::Voxels => asked
            .species
            .iter()
            .all(|species| species.goal.sees_fractions()),
        Refines::Cells => asked.species.iter().all(|species| species.has_cells),
        _ => false,
    }
}

/// Whether a run ends by what the job's own voxels say, or prints in time on them.
fn asks_of_voxels(spec: &JobSpec) -> bool {
    let in_time = spec.schedule.as_ref();
    let is_in_time = in_time.is_some_and(ScheduleSpec::optimizes_cure);
    let of_loss = spec.stop.loss > 0.0 || spec.stop.relative_loss.is_some_and(|part| part > 0.0);
    spec.stop.iou.is_some() || of_loss || is_in_time
}

/// Whether the program chooses the voxels of a job with surface-aware cells.
fn has_free_cells(asked: Asked<'_>, refines: Refines) -> bool {
    let mut species = asked.species.iter();
    refines == Refines::Cells
        && !asks_of_voxels(asked.spec)
        && species.all(|species| species.has_cells && !species.goal.has_fields())
}

/// The voxels of a job with cells: at most half a pixel, as far as [`BUDGET_OF_CELLS`] allows. A mean over a cell does not hold the
/// light within it (docs/choices.md).
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
) -> (VolumeGrid, Vec<usize>) {
    let along = along(grid, lights);
    let wanted = across(grid, lights, PER_PIXEL);
    let angles = turning_angles(spec, lights, bounds_mm);
    let of_light =
        |(light, &angles): (&Light, &usize)| light.pixels.frames() * angles.min(PAID_ANGLES);
    let frames: usize = lights.iter().zip(&angles).map(of_light).sum();
    let cost = |grid: &VolumeGrid| {
        let [nz, ny, nx] = grid.shape;
        ((nz + COLUMN) * ny * nx) as f64 * frames as f64
    };
    let fine = (1..=wanted.next_multiple_of(along))
        .rev()
        .filter(|across| across % along == 0)
        .map(|across| grid.divided(across, along))
        .find(|fine| cost(fine) <= BUDGET);
    match fine {
        Some(fine) => (fine, angles),
        None => {
            let given = spec.light.iter().map(|light| light.sub_angles.unwrap_or(1));
            (grid.clone(), given.collect())
        }
    }
}

/// By how many pixels of a light the rim of a part in this box moves during a frame; 0 for lists of angles.
pub(crate) fn moved_pixels(light: &Light, [low, high]: [[f64; 3]; 2]) -> f64 {
    let rim = f64::hypot(high[0].max(-low[0]), high[1].max(-low[1]));
    rim * light.pixels.frame_arc / light.pixels.pitch_mm[0]
}

/// Angles at which the frames of each light are averaged: those of the job, or one for every half pixel that the rim of the part moves during a
/// frame.
fn turning_angles(spec: &JobSpec, lights: &[Light], part_mm: [[f64; 3]; 2]) -> Vec<usize> {
    let wanted = |light: &Light| {
        (2.0 * moved_pixels(light, part_mm) - ROUNDING)
            .ceil()
            .clamp(1.0, MOST_ANGLES as f64) as usize
    };
    let lights = lights.iter().zip(&spec.light);
    lights
        .map(|(light, job)| job.sub_angles.unwrap_or_else(|| wanted(light)))
        .collect()
}

/// Angles at which an evaluation averages a frame at least, where the job leaves it open.
pub(crate) const LEAST_ANGLES: usize = 4;
/// Most angles of a turn for which an evaluation takes more of them.
const ANGLES_OF_A_TURN: usize = 720;
/// Most angles of a frame.
const ANGLES_OF_A_FRAME: f64 = 64.0;

/// Angles at which an evaluation averages the frames of each light: one where the vial stands.
pub(crate) fn evaluated_angles(
    spec: &JobSpec,
    lights: &[Light],
    part_mm: [[f64; 3]; 2],
) -> Vec<usize> {
    let wanted = |light: &Light| {
        let moved = moved_pixels(light, part_mm).ceil().min(ANGLES_OF_A_FRAME) as usize;
        moved.clamp(
            LEAST_ANGLES,
            LEAST_ANGLES.max(ANGLES_OF_A_TURN / light.pixels.frames()),
        )
    };
    let angles = |light: &Light| match spec.evaluate.sub_angles {
        _ if light.pixels.frame_arc == 0.0 => 1,
        Some(angles) => angles,
        None => wanted(light),
    };
    lights.iter().map(angles).collect()
}

/// Power of the deviations on voxels that are fine enough.
const EXPONENT: f64 = 4.0;

/// Whether deviations count to the power of [`EXPONENT`] where the job names none: on voxels that the program chooses, at most half as wide as a pixel.
pub(crate) fn are_sharpened(asked: Asked<'_>, family: &dyn ModelFamily, finest: &Level) -> bool {
    asked.spec.multiresolution.is_none()
        && is_free(asked, family.capabilities().refines)
        && across(&finest.grid, &finest.lights, 2.0) == 1
}

/// A goal with that power; None where its job names one, or another objective.
pub(crate) fn sharpened(goal: &Goal) -> Option<Goal> {
    goal.with(Chosen::Exponent(EXPONENT))
}

/// By how much a wider window lowers what the void may have.
const WIDER: f64 = 0.05;

/// The void's threshold after so many steps.
pub(crate) fn lower_after(steps: usize) -> f64 {
    // Without the digits of a sum
    let lower = threshold::LOWER - steps as f64 * WIDER;
    (1e6 * lower).round() / 1e6
}

/// A goal with a wider window: what the void may have at most is lower by `steps` of [`WIDER`]. None where the job names thresholds, or
/// no lower one is left.
pub(crate) fn widened(goal: &Goal, steps: usize) -> Option<Goal> {
    let lower = lower_after(steps);
    if lower < WIDER {
        return None;
    }
    goal.with(Chosen::Lower(lower))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use crate::job::resolve::ResolvedJob;
    use crate::job::tests::job_of;
    use crate::models::{OpticalScene, Work, planner};
    use crate::target::Shape;
    use std::sync::Arc;

    /// A small job, with further lines.
    fn small(surface: &str, more: &[&str]) -> Job {
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
        job_of(&text, more)
    }

    /// Its levels, and whether its deviations are to another power.
    fn levels_of(surface: &str, more: &[&str]) -> (Vec<Level>, bool) {
        let job = small(surface, more);
        let optics = Optics::new(&job.spec, &job.base()).unwrap();
        let grid = VolumeGrid::centered([10, 10, 10], 0.1);
        let bounds = [[-0.4; 3], [0.4; 3]];
        let shape = crate::target::build(&job.spec.target, &job.base(), "target").unwrap();
        let shape: Arc<dyn Shape> = Arc::from(shape);
        let resolved = OpticalScene {
            solid: (surface == "cells").then_some(&shape),
            ..optics.scene()
        };
        let family = planner::choose(optics.model.as_ref(), &resolved, &grid).unwrap();
        let method = Method::read(&job.spec, &job.base()).unwrap();
        let species = Species::of_job(&job, &method, None, &Work::new()).unwrap();
        let asked = Asked {
            spec: &job.spec,
            method: &method,
            species: &species,
        };
        let levels = levels(asked, &optics, family.as_ref(), &grid, bounds);
        let are_sharpened = are_sharpened(asked, family.as_ref(), &levels[levels.len() - 1]);
        let is_sharpened = are_sharpened && sharpened(&species[0].goal).is_some();
        (levels, is_sharpened)
    }

    fn pitches(surface: &str, more: &[&str]) -> Vec<f64> {
        let (levels, _) = levels_of(surface, more);
        levels.iter().map(|level| level.grid.pitch_mm).collect()
    }

    #[test]
    fn fourth_powers_are_those_of_fine_voxels_that_the_program_chose() {
        let is_sharpened = |surface: &str, more: &[&str]| levels_of(surface, more).1;
        assert!(is_sharpened("fraction", &[]));
        assert!(is_sharpened("fraction", &["grid.refine=2"]));
        assert!(!is_sharpened("fraction", &["grid.refine=1"]));
        assert!(!is_sharpened("fraction", &["stop.iou=0.9"]));
        assert!(!is_sharpened(
            "fraction",
            &["objective.threshold.exponent=3"]
        ));
        for surface in ["voxel", "cells"] {
            assert!(!is_sharpened(surface, &[]), "{surface}");
        }
    }

    #[test]
    fn a_refinement_that_changes_nothing_is_told() {
        let note_of = |surface: &str, more: &[&str]| {
            let (levels, _) = levels_of(surface, more);
            let spec = small(surface, more).spec;
            unheard(&spec, &levels, &VolumeGrid::centered([10, 10, 10], 0.1))
        };
        assert_eq!(note_of("fraction", &["grid.refine=2"]), None);
        assert_eq!(note_of("voxel", &["grid.refine=1"]), None);
        assert_eq!(note_of("voxel", &[]), None);
        let text = note_of("voxel", &["grid.refine=2"]).unwrap();
        assert!(
            text.starts_with("grid.refine = 2 changes nothing here"),
            "{text}"
        );
    }

    #[test]
    fn objectives_of_no_weight_and_fields_of_defaults_decide_nothing() {
        let job = |objectives: &str| {
            let text = format!(
                r#"
                target = {{ phantom = {{ sphere = {{}} }}, size_mm = 0.8 }}
                resin = {{ refractive_index = 1.5, absorption_per_mm = 0.1 }}
                vial = {{ index_matched = {{ radius_mm = 1.0 }} }}
                light = [{{ pixels = [24, 16], angles = 12, projector = {{ collimated = {{ pixel_pitch_mm = 0.1 }} }} }}]
                objectives = [{{ threshold = {{}}{objectives} }}]
                "#
            );
            job_of(&text, &[])
        };
        for (objectives, is_free) in [
            (" }, { l2 = {}, weight = 0.0", true),
            (" }, { l2 = {}, weight = 0.5", false),
            (
                ", region = \"all\", weights = { part = 1.0 }, tolerance = { void = 0.0 }",
                true,
            ),
            (", region = \"part\"", false),
            (", weights = { part = 2.0 }", false),
        ] {
            let job = job(objectives);
            let goal = Goal::read(&job.spec, &job.base()).unwrap();
            assert_eq!(goal.sees_fractions(), is_free, "{objectives}");
            assert_eq!(
                sharpened(&goal).is_some(),
                is_free || goal.has_fields(),
                "{objectives}"
            );
            let resolved = ResolvedJob::new(&job).unwrap();
            let is_told = |note: &String| note.contains("region, weights or tolerance");
            assert_eq!(
                resolved.notes.iter().any(is_told),
                goal.has_fields(),
                "{objectives}"
            );
        }
    }

    #[test]
    fn every_light_is_averaged_at_its_own_angles() {
        let text = r#"
            target = { phantom = { sphere = {} }, size_mm = 0.8 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 1.0 } }
            [[light]]
            name = "a"
            pixels = [24, 16]
            angles = 40
            projector = { collimated = { pixel_pitch_mm = 0.1 } }
            [[light]]
            name = "b"
            pixels = [24, 16]
            angles = 6
            projector = { collimated = { pixel_pitch_mm = 0.1 } }
        "#;
        let angles = |more: &[&str]| {
            let job = job_of(text, more);
            let optics = Optics::new(&job.spec, &job.base()).unwrap();
            let bounds = [[-0.4; 3], [0.4; 3]];
            turning_angles(&job.spec, &optics.lights, bounds)
        };
        // The rim, at 0.57 mm, moves by 0.089 and 0.59 mm during a frame: 1.8 and 12 half pixels
        assert_eq!(angles(&[]), [2, 4]);
        assert_eq!(angles(&["light[1].sub_angles=3"]), [2, 3]);
        assert_eq!(angles(&["light[0].sub_angles=1"]), [1, 4]);
        let evaluated = |more: &[&str]| {
            let job = job_of(text, more);
            let optics = Optics::new(&job.spec, &job.base()).unwrap();
            evaluated_angles(&job.spec, &optics.lights, [[-0.4; 3], [0.4; 3]])
        };
        assert_eq!(evaluated(&[]), [4, 6]);
        assert_eq!(evaluated(&["light[1].angles=2"]), [4, 18]);
        assert_eq!(
            evaluated(&["light[1].angles={ list_deg = [0, 9] }"]),
            [4, 1]
        );
        assert_eq!(evaluated(&["evaluate.sub_angles=3"]), [3, 3]);
        let levels = |sub_angles: &[usize]| {
            let job = job_of(text, &[]);
            let optics = Optics::new(&job.spec, &job.base()).unwrap();
            let grid = VolumeGrid::centered([10, 10, 10], 0.1);
            let fine = grid.refined(2);
            note(
                &[Level::new(fine, &turned(&optics.lights, sub_angles), 9)],
                &grid,
            )
            .unwrap()
        };
        assert!(
            levels(&[2, 2]).ends_with(", 2 angles a frame"),
            "{}",
            levels(&[2, 2])
        );
        assert!(levels(&[1, 1]).ends_with("mm wide"));
        assert!(levels(&[2, 4]).ends_with(", 2 and 4 angles a frame, light by light"));
    }

    #[test]
    fn slices_that_no_row_of_the_part_lights_are_left_out() {
        let shape = |more: &[&str]| {
            let (levels, _) = levels_of("fraction", more);
            let grid = &levels.last().unwrap().grid;
            (grid.shape[0], grid.bounds_mm().map(|corner| corner[2]))
        };
        let (slices, [low, high]) = shape(&[]);
        // The sphere ends 0.4 mm from its middle, with a row of pixels; the job's grid 0.5 mm
        assert_eq!(slices, 8);
        assert!((low + 0.4).abs() < 1e-9 && (high - 0.4).abs() < 1e-9);
        // Rows half a pixel higher: the lowest and the highest reach 0.05 mm beyond it
        let (slices, [low, high]) = shape(&["light[0].offset_mm=[0,0.05]"]);
        assert_eq!(slices, 10);
        assert!((low + 0.5).abs() < 1e-9 && (high - 0.5).abs() < 1e-9);
        for asked in [
            "grid.refine=4",
            "bounds.min=0.1",
            "light[0].bounds.min=0.1",
            "bounds.max=2",
        ] {
            let is_whole = asked != "bounds.max=2";
            assert_eq!(shape(&[asked]).0, if is_whole { 10 } else { 8 }, "{asked}");
        }
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
