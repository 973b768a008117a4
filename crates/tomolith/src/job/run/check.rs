//! `check`: what a job will do and cost, without running it.

use super::cost::{Demand, mean_sub_angles};
use super::{benchmark, resolved};
use crate::error::Result;
use crate::job::dose::in_time::diffuses;
use crate::job::dose::model_probe::try_orders;
use crate::job::evaluate::light_paths::scene;
use crate::job::optimize::iterations_of_ceiling;
use crate::job::optimize::rehearsal::{Rehearsal, rehearse};
use crate::job::optimize::stage::bytes_on_card;
use crate::job::output::summary::Plan;
use crate::job::progress::{Progress, stage, watched};
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::card::Card;
use crate::job::spec::read::Job;
use crate::models::{Quantity, Work};
use crate::report::number::significant;
use crate::report::page::{Page, check_page};
use std::time::Instant;

/// Validates a job and says what it will cost, without running it.
///
/// # Errors
/// As [`run`](fn@super::run), for input that cannot be used.
pub fn check(job: &Job, progress: &mut dyn Progress, work: &Work) -> Result<Plan> {
    watched(progress, work, |progress| {
        check_stages(job, progress, work).map_err(|e| job.locate(e))
    })
}

/// A page with vial, part, lit radius and rays of a job before it runs.
///
/// # Errors
/// As [`run`](fn@super::run), for input that cannot be used.
pub fn picture(job: &Job, work: &Work) -> Result<Page> {
    let drawn = || {
        let resolved = resolved(job, work)?;
        let voxels = &resolved.voxels(&resolved.grid, work)?[0];
        let program = concat!("Tomolith ", env!("CARGO_PKG_VERSION"));
        let text = job.complete().to_toml()?;
        let (inside, labels) = (&voxels.target.inside, &voxels.labels);
        Ok(check_page(
            &resolved.name,
            program,
            &text,
            inside,
            labels,
            &scene(&resolved),
        ))
    };
    drawn().map_err(|e| job.locate(e))
}

fn check_stages(job: &Job, progress: &mut dyn Progress, work: &Work) -> Result<Plan> {
    stage(progress, work, "reading the job");
    let mut resolved = resolved(job, work)?;
    resolved.note_levels();
    let sampling = stage(progress, work, "sampling the target");
    let begin = Instant::now();
    let voxels = resolved.voxels(&resolved.grid, &sampling)?;
    let sampling_s = begin.elapsed().as_secs_f64();
    resolved.must_start(&voxels)?;
    // Before the start, which would blame the light for a part without voxels
    let of_voxels = resolved.warnings_of(&voxels)?;
    try_orders(&mut resolved, progress, &sampling)?;
    let trying = stage(progress, work, "trying the start of the optimization").aside();
    let memory_used = |job: &ResolvedJob| job.optics.card.as_ref().and_then(Card::memory_used);
    let _earlier = memory_used(&resolved);
    let of_ceiling = match iterations_of_ceiling(&resolved, &voxels) {
        0 => 0,
        // No ceiling of amplitudes is looked for
        _ if benchmark::quantity(&resolved, &sampling)? != Quantity::Energy => 0,
        iterations => iterations,
    };
    let Rehearsal {
        is_tried,
        iterations_s,
    } = rehearse(&resolved, &voxels, of_ceiling, &trying)?;
    if !is_tried {
        let text = "the start of the optimization takes too long to be tried here: a run may still find fault with it";
        resolved.notes.push(text.to_owned());
        resolved.warnings.extend(too_large_for_card(&resolved));
    }
    if let Some(memory) = memory_used(&resolved) {
        let least = if is_tried { "" } else { "at least " };
        let text = format!("the start of the optimization takes {least}{memory}");
        resolved.notes.push(text);
    }
    let mut warnings = resolved.warnings.clone();
    warnings.extend(of_voxels);
    warnings.extend(resolved.compares_coarsely().filter(|_| of_ceiling > 0));
    // How much there is to time is not known beforehand
    let timing = stage(progress, work, "timing a few frames on this machine").aside();
    let rates = benchmark::rates(&resolved, &voxels[0], sampling_s, &timing)?;
    let paths = resolved.optics.family(&resolved.grid)?.monte_carlo_paths();
    resolved.notes.extend(print_time(&resolved, of_ceiling));
    let demand = Demand {
        extent: &resolved.extent,
        iterations: resolved.stop().iterations + of_ceiling,
        sub_angles: [
            mean_sub_angles(&resolved.optics.lights),
            mean_sub_angles(&resolved.optics.lights_turning(&resolved.evaluated_angles)),
        ],
        misses_turning: resolved.misses_turning(),
        monte_carlo_paths: paths.map(|paths| paths.evaluating / paths.optimizing),
        levels: resolved.evaluation().improves_levels() || resolved.improves_pixels(),
        wall_s: resolved.stop().wall_s,
        longer: 1.0,
    };
    let demand = demand.as_timed(&rates, iterations_s);
    let cost = demand.cost(&rates);
    if resolved.schedule().is_some() {
        let text = "the seconds are those without the print in time, which comes on top";
        resolved.notes.push(text.to_owned());
    }
    let memory_budget_mb = resolved.memory_budget_mb();
    if let Some((text, is_much)) = demand.of_scenarios(&rates, memory_budget_mb) {
        let texts = if is_much {
            &mut warnings
        } else {
            &mut resolved.notes
        };
        texts.push(text);
    }
    if resolved.improves_pixels() {
        let text = "the machine's pixels lie across those of the light: after the optimization patterns are improved for what it shows, by some 60 model calls";
        resolved.notes.push(text.to_owned());
    }
    let is_in_time = resolved.is_optimized_in_time() || diffuses(&resolved);
    if resolved.optics.card.is_some() && is_in_time {
        let text = "the card computes doses; the loop around them runs on the processor";
        resolved.notes.push(text.to_owned());
    }
    let [x, y, z] = [2, 1, 0].map(|axis| resolved.grid.shape[axis]);
    let refine = resolved.extent.refine;
    Ok(Plan {
        part: resolved.name.clone(),
        model: rates.model,
        voxels: [x, y, z],
        pitch_mm: resolved.grid.pitch_mm,
        evaluation_voxels: [x * refine, y * refine, z * refine],
        frames: resolved.extent.frames,
        pixels: resolved.extent.pixels,
        active_pixels: resolved.extent.active_pixels,
        memory_mb: resolved
            .extent
            .optimization_mb()
            .max(resolved.extent.evaluation_mb()),
        memory_budget_mb,
        disk_mb: resolved.extent.disk_mb(),
        seconds: cost.optimization_s + cost.rest_s,
        iterations: resolved.levels.last().map_or(0, |level| level.until),
        optimization_s: cost.optimization_s,
        updates_per_s: 1.0 / rates.calls.dose.per_update_s,
        notes: resolved.notes.clone(),
        warnings,
    })
}

/// Warns of a loop that a card can hardly hold, by the estimate of the pixels that meet the part.
fn too_large_for_card(resolved: &ResolvedJob) -> Option<String> {
    let (card, extent) = (resolved.optics.card.as_ref()?, &resolved.extent);
    let pairs = resolved.method.pairs().unwrap_or_default();
    let bytes = bytes_on_card(extent.active_pixels, extent.finest.len(), pairs);
    match card.holds(bytes) {
        Ok(true) => None,
        Ok(false) => Some(
            "the optimization is likely to be too large for the card: then the processor does it"
                .to_owned(),
        ),
        Err(error) => Some(format!("the optimization is likely to be refused: {error}")),
    }
}

/// What is known of the print's time before a run; None where nothing is.
fn print_time(resolved: &ResolvedJob, of_ceiling: usize) -> Option<String> {
    if of_ceiling > 0 {
        return Some(format!(
            "the run looks for the lowest ceiling of the pixels at which the part prints as well, which takes as long as some {of_ceiling} iterations, and more where it rises on the finest voxels: the print time N·M/t is known \
             then. bounds.max or printer.time_s set it beforehand"
        ));
    }
    let lights = 0..resolved.optics.lights.len();
    let white: f64 = lights
        .map(|i| Some(resolved.optics.lights[i].pixels.frames() as f64 * resolved.bounds_of(i).1?))
        .sum::<Option<f64>>()?;
    let [lower, upper] = resolved.first().goal.thresholds()?;
    let threshold = resolved.evaluation().threshold;
    let gel = threshold.unwrap_or_else(|| f64::midpoint(lower, upper));
    let is_dose = resolved.first().goal.response.is_identity() && gel > 0.0;
    is_dose.then(|| {
        format!(
            "the print time N·M/t is at most about {} mm: frames times bounds.max over a gel dose of {}",
            significant(white / gel, 3),
            significant(gel, 3)
        )
    })
}
