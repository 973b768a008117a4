//! `report.json`.
//!
//! ```text
//! schema        "tomolith.report/1"
//! part          name of the part
//! evaluation    the numbers of metrics::METRICS on the finer grid, from the written patterns, vial turning;
//!               with gel_threshold, farthest (the place of hausdorff_mm, and whether print or target is without the other there),
//!               band_half_width (gray targets), sub_angles, grid, part and void (response: min, max, mean, deviation), notes,
//!               iou_curve, histogram (voxels of part and void per bin of the response over a range), errors (gray targets, else null: bright
//!               and dark voxels per bin of response − gray value, 800 bins from −1 to 1, or to the power of ten that holds all; band, the
//!               objective's; band_edge_peak, how many times more voxels are at its edges than a little inside or outside), and standing_still: the same without turning
//! optimization  the same on the optimization's grid; and objectives, one for each entry of the job's `objectives` (none of a job with `objective`):
//!               key, weight (its factor in the sum), loss (its own, without that factor; null for cells and for prints in time), voxels (those
//!               that count: in its region, and with a weight above 0), rms_error and max_error (its response against the gray values over
//!               these, each once whatever it weighs; null for a target of part and void)
//! exposure      over which exposures the print stays nearly as good as at the best one: measure (iou, or rms_error of gray targets), best (its value
//!               there), tolerance (how much worse it may get), and low, best, high of each of: percent (exposures, % of the best one), time_s (null
//!               where the job gives no times), dose and threshold (what gels, in units of the job and of the response; null for gray targets; the
//!               highest belongs to the shortest exposure); reported_percent (the exposure of all other numbers: 100, unless the job sets a
//!               threshold or is gray). An end without limit is null; all of it is null where the report cannot state it
//! limits        what makes the print worse, the largest loss first: cause (grid, levels, turning, optics, iterations), loss_in_iou (or
//!               loss_in_rms_error; below 0: a gain), key (the one to change), advice
//! published     numbers with other authors' signs or normalizations: value, unit, source, note; slices; unit_systems;
//!               keep_dark (responses in the bodies that are to stay dark: volume_mm3, mean, largest, part_mean);
//!               insert (what of the inserts' surface is touched: insert_mm2 in all, target_mm2 by the target, print_mm2 by the print, share
//!               of the print's in all, of_target: of what the target touches, the share that the print touches);
//!               paths (scattering by Monte Carlo paths: their numbers, IoU and PW on the optimization's and on independent ones, noise per voxel);
//!               orders (scattering order by order: how far it is from Monte Carlo paths in part and void, over the part's mean dose)
//! lights        frames, size and scale of each light's patterns; budget (time, turns, energies: those of the schedule where the job has one),
//!               irradiance (of white in that schedule, and the most that the printer gives; else null)
//! species       where a job names several: name, driven_by (factor of each light), evaluation, exposure, limits and objective_window as here; the first is that of
//!               `evaluation`
//! one_exposure  of several species: gel_dose (at which all of them gel), species and iou (of each then), where the lowest of them is the largest;
//!               limited_by (the species with the lowest), percent and time_s as in exposure, of the lowest IoU
//! time          the print in time where the job has a schedule, per network: name, induction_end_s (the first voxel is solid), best_s and
//!               best_jaccard, window_s (within 0.01 of the best), ideal_exposure_s, requirement_mj, largest_share_of_requirement (where it is
//!               never met), best_mj (energy that all lights have sent to the vial by best_s), evaluation (what is solid at best_s), curves
//! one_moment    of several networks: seconds (when the lowest Jaccard index is the largest), networks, jaccard, limited_by, sent_mj, window_s; else null
//! properties    of the printed material: name, unit, and min, median, max where something is solid
//! history       how many iterations and model calls, the last loss, the last projected gradient relative to the first;
//!               kept: the iteration whose patterns these are, and by what it was kept (loss, print, last);
//!               lower_bound: a loss that no patterns within the bounds go below (linear models, convex objectives), gap: (loss − lower_bound)/loss
//! levels        patterns that were improved on few levels: loss of plain rounding, loss, full scale over the brightest pixel, steps,
//!               model calls; else null
//! ceiling       of the pixels, where the run looked for one: brightest (without a ceiling, mJ/mm²), even_dose (mean in the part with all pixels at 1), points (factor of that, and of every print iou, ver,
//!               surface_mean_mm and gamma, on pixels of twice the width), chosen (which of them; null: none is good enough), finest (that one on the finest voxels: tried, another ceiling over it; before and after,
//!               the prints below both; changed_by, what the ceiling was multiplied by), trade_off (what was tried and what the run took, the longest print first: brightest, time_mm, time_s, iou, ver,
//!               surface_mean_mm, is_chosen, is_evaluated: by the run's evaluation, not on pixels of twice the width); else null
//! scenarios     where a job has any: of (mean or worst), threshold (the job's), window (least of the part − largest of the void over all of
//!               them, trimmed), worst_iou (at that threshold), rows (the job, then each scenario: name, iou, iou_at_threshold, gamma,
//!               part_low, void_high); else null
//! process_window  of an objective that looks for it, before the patterns are written, on the optimization's voxels: outliers (the share left
//!               out), thresholds (l and u of the objective), part_above, part_below, void_below (what all but the outliers are), window (part_above
//!               − void_below), range (part_below − part_above), ipdr (its bound); else null
//! objective_window  thresholds of the objective, where it has any: the void should stay below the first, the part above the second; else null
//! time_to_print_s  of all lights: one after the other, or side by side in a schedule; null where times are not known
//! movies        what a decoder makes of each movie
//! notes         sentences: choices that were made
//! warnings      sentences
//! is_toy        whether the job was run with `--toy`
//! run           program, models that gave the doses (with their kernels on this machine), date and times: all that may differ between two equal runs
//! ```
//!
//! What is not defined is null; no number is infinite or not a number.

use super::ceiling::ceiling_json;
use super::time::time_json;
use super::{LightReport, MapReport, ObjectiveReport, ReportData, SpeciesReport};
use serde_json::{Map, Value, json};
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::kind::table_of;
use tomolith_io::read_text;
use tomolith_metrics::Evaluation;
use tomolith_metrics::error_histogram::ErrorHistogram;
use tomolith_metrics::evaluation::Histogram;
use tomolith_metrics::spread::Spread;

/// Reads the report of a run from its folder.
///
/// # Errors
/// [`Error::Io`] where there is none that can be read; [`Error::Format`] when it is none of this version.
pub fn read(folder: &Path) -> Result<Value> {
    let path = folder.join("report.json");
    let text = read_text(&path)?;
    let refused =
        |found: String| Error::format(&path, found, "the report of a run of this version");
    let report: Value = serde_json::from_str(&text).map_err(|e| refused(e.to_string()))?;
    match report["schema"].as_str() {
        Some(super::SCHEMA) => Ok(report),
        Some(other) => Err(refused(format!("a report of the schema {other}"))),
        None => Err(refused("a report that does not say its schema".to_owned())),
    }
}

/// A number, or null.
fn number(value: impl Into<Option<f64>>) -> Value {
    value
        .into()
        .filter(|v| v.is_finite())
        .map_or(Value::Null, Value::from)
}

/// How long all lights take, s: one after the other, or side by side as the schedule says. None where a time is not known.
fn time_to_print_s(data: &ReportData<'_>) -> Option<f64> {
    let time_s = |light: &LightReport<'_>| light.budget.time_s;
    let mut times = data.lights.iter().map(time_s);
    if data.lights.iter().any(|light| light.irradiance.is_some()) {
        return times.try_fold(0.0f64, |longest, own| Some(longest.max(own?)));
    }
    times.sum()
}

/// The report as JSON.
#[must_use]
pub fn report_json(data: &ReportData<'_>) -> Value {
    let mut evaluation = evaluation_json(data.evaluation);
    let standing = data
        .standing
        .map_or(Value::Null, |s| Value::Object(evaluation_json(s)));
    evaluation.insert("standing_still".to_owned(), standing);
    let lights: Vec<Value> = data
        .lights
        .iter()
        .map(|light| {
            let grid = &light.patterns.grid;
            json!({
                "name": light.name,
                "wavelength_nm": number(light.wavelength_nm),
                "frames": grid.frames(),
                "rows": grid.rows,
                "columns": grid.columns,
                "pitch_mm": grid.square_pitch_mm().map_or_else(|| json!(grid.pitch_mm), number),
                "bits": light.bits,
                "full_scale": number(f64::from(light.full_scale)),
                "canvas": light.canvas,
                "budget": light.budget,
                "irradiance": light.irradiance,
            })
        })
        .collect();
    let history = data.history.last().map(|last| {
        json!({
            "iterations": last.iteration,
            "loss": number(last.loss),
            "projected_gradient": number(last.projected_gradient),
            "forward_calls": last.forward_calls,
            "adjoint_calls": last.adjoint_calls,
            "kept": data.kept,
            "lower_bound": number(data.gap.map(|gap| gap.bound)),
            "gap": number(data.gap.map(|gap| gap.relative())),
        })
    });
    let movies: Vec<Value> = data
        .movies
        .iter()
        .map(|movie| {
            json!({
                "file": movie.file,
                "frames": movie.check.frames,
                "frame_rate": number(movie.check.frame_rate),
                "width": movie.check.width,
                "height": movie.check.height,
                "largest_error_of_255": movie.check.largest_error,
                "rms_error_of_255": number(movie.check.rms_error),
            })
        })
        .collect();
    let timings = data.timings.iter();
    let timings = table_of(timings.map(|t| (t.name.clone(), number(t.seconds))));
    let models = data.models.iter();
    let models = table_of(models.map(|(stage, model)| ((*stage).to_owned(), json!(model))));
    let species: Vec<Value> = data.species.iter().map(species_json).collect();
    let found = data.found_response.iter();
    let found = table_of(found.map(|(name, v)| (name.clone(), json!(v))));
    let response = (!found.is_empty()).then_some(found);
    json!({
        "schema": super::SCHEMA,
        "part": data.part,
        "evaluation": evaluation,
        "optimization": data.optimization.map(|own| optimization_json(own, data.objectives)),
        "exposure": data.exposure,
        "limits": data.limits.causes,
        "published": data.published,
        "lights": lights,
        "species": species,
        "one_exposure": data.one_exposure,
        "time": data.time.iter().map(time_json).collect::<Vec<_>>(),
        "one_moment": data.one_moment,
        "properties": data.maps.iter().map(map_json).collect::<Vec<_>>(),
        "history": history,
        "levels": data.levels,
        "ceiling": data.ceiling.map(|own| ceiling_json(own, &data.trade_off())),
        "scenarios": data.scenarios,
        "process_window": data.found_window,
        "response": response,
        "objective_window": data.window,
        "time_to_print_s": number(time_to_print_s(data)),
        "movies": movies,
        "notes": data.notes,
        "warnings": data.warnings,
        "is_toy": data.is_toy,
        "run": {
            "program": data.program,
            "models": models,
            "created": data.created,
            "timings_s": timings,
        },
    })
}

/// The numbers of the optimization's grid, with those of each objective.
fn optimization_json(evaluation: &Evaluation, objectives: &[ObjectiveReport]) -> Value {
    let mut map = evaluation_json(evaluation);
    map.insert("objectives".to_owned(), json!(objectives));
    Value::Object(map)
}

fn map_json(map: &MapReport<'_>) -> Value {
    let spread = map.spread();
    let at = |i: usize| number(spread.map(|spread| spread[i]));
    json!({ "name": map.name, "unit": map.unit, "min": at(0), "median": at(1), "max": at(2) })
}

fn species_json(species: &SpeciesReport<'_>) -> Value {
    let driven_by = species.driven_by.iter();
    let driven_by = table_of(driven_by.map(|(light, factor)| (light.clone(), number(*factor))));
    json!({
        "name": species.name,
        "driven_by": driven_by,
        "evaluation": evaluation_json(species.evaluation),
        "exposure": species.exposure,
        "objective_window": species.window,
        "limits": species.limits.causes,
    })
}

/// The numbers and curves of an evaluation.
#[must_use]
pub fn evaluation_json(evaluation: &Evaluation) -> Map<String, Value> {
    let measures = evaluation.measures.0.iter();
    let mut map = table_of(measures.map(|(name, value)| ((*name).to_owned(), number(*value))));
    let grid = &evaluation.grid;
    let rest = [
        ("gel_threshold", number(evaluation.gel_threshold)),
        ("farthest", json!(evaluation.farthest)),
        ("band_half_width", number(evaluation.half_width)),
        ("sub_angles", evaluation.sub_angles.into()),
        (
            "grid",
            json!({
                "shape_zyx": grid.shape,
                "pitch_mm": number(grid.pitch_mm),
                "center_xyz_mm": grid.center_mm.map(number),
            }),
        ),
        ("part", spread_json(evaluation.part)),
        ("void", spread_json(evaluation.void)),
        ("notes", json!(evaluation.notes)),
        ("iou_curve", json!(evaluation.curve)),
        ("histogram", histogram_json(&evaluation.histogram)),
        (
            "errors",
            errors_json(evaluation.errors.as_ref(), evaluation.half_width),
        ),
    ];
    map.extend(rest.map(|(name, value)| (name.to_owned(), value)));
    map
}

/// Voxels per bin of part and void.
fn histogram_json(histogram: &Histogram) -> Value {
    let column = |i: usize| histogram.counts.iter().map(|n| n[i]).collect::<Vec<u64>>();
    json!({ "range": histogram.range, "part": column(0), "void": column(1) })
}

/// Voxels per bin of the error, bright and dark, and the band that the objective asks for.
fn errors_json(errors: Option<&ErrorHistogram>, half_width: Option<f64>) -> Value {
    let Some((errors, half_width)) = errors.zip(half_width) else {
        return Value::Null;
    };
    let column = |i: usize| errors.counts.iter().map(|n| n[i]).collect::<Vec<u64>>();
    json!({
        "range": [-errors.reach, errors.reach],
        "band": [-half_width, half_width],
        "part": column(0),
        "void": column(1),
        "band_edge_peak": number(errors.band_edge_peak(half_width)),
    })
}

fn spread_json(spread: Option<Spread>) -> Value {
    spread.map_or(Value::Null, |s| {
        json!({
            "voxels": s.count,
            "min": number(f64::from(s.min)),
            "max": number(f64::from(s.max)),
            "mean": number(s.mean),
            "deviation": number(s.deviation),
        })
    })
}
