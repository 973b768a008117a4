//! `report.json`: its keys are in `docs/report.md`.
//!
//! What is not defined is null; no number is infinite or not a number.

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
        None => Err(refused("no `schema`".to_owned())),
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
        return times.try_fold(0.0f64, |longest, seconds| Some(longest.max(seconds?)));
    }
    times.sum()
}

/// The report as JSON.
#[must_use]
pub fn report_json(data: &ReportData<'_>) -> Value {
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
            // No loss falls below 0, whatever the bound is
            "gap": number(data.gap.map(|gap| gap.relative().min(1.0))),
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
    let first = data.first();
    let named = data.species.iter().filter(|s| !s.name.is_empty());
    let species: Vec<Value> = named.map(species_json).collect();
    let found = data.found_response.iter();
    let found = table_of(found.map(|(name, v)| (name.clone(), json!(v))));
    let response = (!found.is_empty()).then_some(found);
    json!({
        "schema": super::SCHEMA,
        "part": data.part,
        "evaluation": evaluation_json(first.evaluation),
        "optimization": data.optimization.map(|evaluation| optimization_json(evaluation, data.objectives)),
        "exposure": first.exposure,
        "limits": first.limits.causes,
        "published": data.published,
        "lights": lights,
        "species": species,
        "one_exposure": data.one_exposure,
        "time": data.time.iter().map(|time| time_json(time)).collect::<Vec<_>>(),
        "one_moment": data.one_moment,
        "properties": data.maps.iter().map(map_json).collect::<Vec<_>>(),
        "history": history,
        "levels": data.levels,
        "ceiling": data.ceiling.map(|ceiling| {
            let mut ceiling = json!(ceiling);
            ceiling["trade_off"] = json!(data.trade_off());
            ceiling
        }),
        "scenarios": data.scenarios,
        "process_window": data.found_window,
        "response": response,
        "objective_window": first.window,
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
