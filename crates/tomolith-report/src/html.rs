//! `report.html`: one page without any outside resource.
//!
//! The best exposure and what limits the print; headline numbers with the vial turning, as it prints, and standing still; dose
//! histogram and IoU over the threshold; the surface in the colors of its deviation; three slices of target, dose and error; the history of the optimization; sinogram and frames; all numbers; times,
//! warnings, the job. Text from outside (part, job, warnings) is escaped. The page needs no script; the
//! one it may have makes a slider of buttons.

use super::figures::{BODIES, FATES, dose_bar, error_bar, property, sinogram, slices, strip};
use super::number::{escape, significant, told_apart};
use super::plot::{Axis, Plot};
use super::species::{drive, together};
use super::{
    LightReport, MapReport, MovieReport, ReportData, ScenarioTable, SpeciesReport, growth,
    latitude, limits, relief, time,
};
use rayon::prelude::*;
use std::fmt::Write as _;
use tomolith_core::field::BLOCK;
use tomolith_core::grid::Volume;
use tomolith_core::target::label;
use tomolith_io::csv::HistoryRow;
use tomolith_metrics::{Better, Evaluation, METRICS, Measure, MetricKind, surface_deviation};

/// Numbers at the head of the page.
const HEADLINE: [&str; 8] = [
    "iou",
    "pw",
    "ver",
    "gamma",
    "surface_mean_mm",
    "hausdorff_mm",
    "over_mm3",
    "under_mm3",
];

/// Numbers at the head of the page of a gray target.
const GRAY_HEADLINE: [&str; 4] = ["in_band", "rms_error", "max_error_part", "max_error_void"];

/// The page.
#[must_use]
pub fn report_html(data: &ReportData<'_>) -> String {
    let title = escape(data.part);
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title} · Tomolith</title>\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>{}</style></head><body>",
        include_str!("style.css")
    );
    page.push_str(&head(data));
    page.push_str("<main>");
    for part in [
        first(data),
        warnings(data),
        cards(data),
        dose_plots(data),
        surface(data),
        slices_section(data),
        species(data),
        data.scenarios
            .map(ScenarioTable::section)
            .unwrap_or_default(),
        maps(data),
        in_time(data),
        history(data.history),
        patterns(data),
        table(data),
        published(data),
        times_and_movies(data),
        notes(data),
        job(data),
    ] {
        page.push_str(&part);
    }
    let _ = writeln!(
        page,
        "</main><footer>{}{} · Numbers are predictions of a model, not measurements. \
         Doses are relative unless the job says otherwise.</footer></body></html>",
        escape(data.program),
        if data.created.is_empty() {
            String::new()
        } else {
            format!(", {}", escape(data.created))
        },
    );
    page
}

fn head(data: &ReportData<'_>) -> String {
    let mut facts = data.facts.clone();
    let grid = &data.evaluation.grid;
    let [nz, ny, nx] = grid.shape;
    facts.push((
        "Evaluated on".to_owned(),
        format!(
            "{nx} × {ny} × {nz} voxels of {} µm",
            significant(grid.pitch_mm * 1e3, 3)
        ),
    ));
    for light in &data.lights {
        let g = &light.patterns.grid;
        let wave = light
            .wavelength_nm
            .map_or(String::new(), |nm| format!(", {} nm", significant(nm, 4)));
        let name = if light.name.is_empty() {
            "Light".to_owned()
        } else {
            format!("Light {}", light.name)
        };
        facts.push((
            name,
            format!(
                "{} frames of {} × {}, {} bit{wave}",
                g.frames(),
                g.columns,
                g.rows,
                light.bits
            ),
        ));
    }
    let facts: String = facts
        .iter()
        .map(|(name, value)| format!("<li><b>{}</b>{}</li>", escape(name), escape(value)))
        .collect();
    format!(
        "<header><div class=\"brand\">Tomolith print report</div><h1>{}</h1><p class=\"lead\">{}{}</p><ul class=\"facts\">{facts}</ul></header>",
        escape(data.part),
        sentence(data.evaluation),
        first_of(data),
    )
}

/// Which of several species the headline is about, and what all of them reach together.
fn first_of(data: &ReportData<'_>) -> String {
    let Some((first, others)) = data.species.split_first() else {
        return String::new();
    };
    let Some(one) = data.one_exposure else {
        let of = |other: &SpeciesReport<'_>| {
            format!(" {}: {}", escape(other.name), sentence(other.evaluation))
        };
        let others: String = others.iter().map(of).collect();
        return match others.is_empty() {
            true => others,
            false => format!(" That is {}.{others}", escape(first.name)),
        };
    };
    let of = |(species, iou): (&SpeciesReport<'_>, &f64)| {
        format!("{} <b>{}</b>", escape(species.name), significant(*iou, 4))
    };
    let all: Vec<String> = data.species.iter().zip(&one.iou).map(of).collect();
    format!(
        " That is {} alone. At one exposure the species reach {}.",
        escape(first.name),
        all.join(", ")
    )
}

/// What a reader looks for first: how long to expose, and what to change.
fn first(data: &ReportData<'_>) -> String {
    let exposure = latitude::section(data);
    let of_species: Vec<_> = data
        .species
        .iter()
        .map(|own| (own.name, own.limits))
        .collect();
    let limits = match of_species.len() {
        0 | 1 => limits::section(data.limits),
        _ => limits::section_of_species(&of_species),
    };
    format!("<div class=\"two\">{exposure}{limits}</div>")
}

/// The prints of the species beside the first.
fn species(data: &ReportData<'_>) -> String {
    let of = |species: &SpeciesReport<'_>| {
        let own = data.of_species(species);
        format!(
            "<section><h2>Species {}</h2><p class=\"muted\">{}</p><p>{}</p></section>{}{}",
            escape(species.name),
            escape(&drive(species)),
            sentence(species.evaluation),
            dose_plots(&own),
            slices_section(&own),
        )
    };
    let Some((first, others)) = data.species.split_first() else {
        return String::new();
    };
    let intro = if others.is_empty() {
        String::new()
    } else {
        format!(
            "<section><h2>Several species</h2><p>Everything above is about <b>{}</b> ({}). The others follow.</p>{}</section>",
            escape(first.name),
            escape(&drive(first)),
            together(data),
        )
    };
    others
        .iter()
        .fold(intro, |page, species| page + &of(species))
}

/// The print in time.
fn in_time(data: &ReportData<'_>) -> String {
    let own_um = 1e3 * data.evaluation.grid.pitch_mm;
    let together = data.one_moment.as_ref().map_or_else(String::new, |moment| {
        format!(
            "<section><h2>The print in time: when to stop</h2><p>{}</p></section>",
            escape(&moment.sentence())
        )
    });
    let networks = data.time.iter().enumerate();
    let page = networks.fold(together, |page, (i, network)| {
        page + &time::section(network, i, own_um)
    });
    match data.time.iter().all(|network| network.snapshots.is_empty()) {
        true => page,
        false => page + growth::SCRIPT,
    }
}

/// Properties of the printed material.
fn maps(data: &ReportData<'_>) -> String {
    let of = |map: &MapReport<'_>| {
        let name = escape(map.name);
        let Some(spread) = map.spread() else {
            return format!("<section><h2>Predicted {name}</h2><p>Nothing is solid.</p></section>");
        };
        let said = told_apart(&spread, 3);
        let [low, median, high] = [0, 1, 2].map(|i| &said[i]);
        let unit = escape(map.unit);
        format!(
            "<section><h2>Predicted {name}</h2><p>From {low} to {high} {unit} where something is solid, half of it below {median} {unit}. \
             Nothing is drawn where all is liquid.</p>{}</section>",
            property(map)
        )
    };
    data.maps.iter().map(of).collect()
}

/// The surface, for a target that has one.
fn surface(data: &ReportData<'_>) -> String {
    let of_part = data.deviation.filter(|_| !is_gray(data));
    of_part.map_or_else(String::new, |deviation| {
        relief::section(deviation, data.evaluation.grid.pitch_mm)
    })
}

/// The result in words.
fn sentence(evaluation: &Evaluation) -> String {
    let get = |name| evaluation.measures.get(name);
    if let (Some(half_width), Some(in_band), Some(rms)) =
        (evaluation.half_width, get("in_band"), get("rms_error"))
    {
        return format!(
            "The response of <b>{} %</b> of the voxels lies within ±{} of the target's gray value; the rms error is {}.",
            significant(100.0 * in_band, 3),
            significant(half_width, 3),
            significant(rms, 3),
        );
    }
    let (Some(iou), Some(over), Some(under), Some(threshold)) = (
        get("iou"),
        get("over_mm3"),
        get("under_mm3"),
        evaluation.gel_threshold,
    ) else {
        return evaluation
            .notes
            .iter()
            .map(|n| escape(n))
            .collect::<Vec<_>>()
            .join(" ");
    };
    let amount = |mm3: f64| {
        if mm3 == 0.0 {
            "nothing".to_owned()
        } else {
            format!("{} mm³", significant(mm3, 2))
        }
    };
    let mut text = format!(
        "At a gel threshold of {} the predicted print and the part overlap with an IoU of <b>{}</b>: {} gels that should not, {} stays liquid.",
        significant(threshold, 3),
        significant(iou, 4),
        amount(over),
        amount(under),
    );
    if let Some(mean) = get("surface_mean_mm") {
        let _ = write!(
            text,
            " Its surface is {} µm off on average.",
            significant(mean * 1e3, 2)
        );
    }
    text
}

fn warnings(data: &ReportData<'_>) -> String {
    let mut all: Vec<&String> = data.warnings.iter().collect();
    all.extend(&data.evaluation.notes);
    if all.is_empty() {
        return String::new();
    }
    let items: String = all
        .iter()
        .map(|w| format!("<li>{}</li>", escape(w)))
        .collect();
    format!("<section class=\"warn\"><h2>Please note</h2><ul>{items}</ul></section>")
}

/// Choices that were made.
fn notes(data: &ReportData<'_>) -> String {
    if data.notes.is_empty() {
        return String::new();
    }
    let items: String = data
        .notes
        .iter()
        .map(|note| format!("<li>{}</li>", escape(note)))
        .collect();
    format!("<section><h2>How it was computed</h2><ul>{items}</ul></section>")
}

/// A measure with its unit, lengths in µm.
fn shown(kind: &MetricKind, value: Measure, digits: usize) -> (String, &'static str) {
    match (value, kind.unit) {
        (None, _) => ("–".to_owned(), ""),
        (Some(v), "mm") => (significant(v * 1e3, digits), "µm"),
        (Some(v), "response") => (significant(v, digits), ""),
        (Some(v), unit) => (significant(v, digits), unit),
    }
}

/// A length in voxels, in brackets; empty for what is no length.
fn in_voxels(kind: &MetricKind, value: Measure, pitch_mm: f64) -> String {
    value
        .filter(|_| kind.unit == "mm")
        .map_or_else(String::new, |mm| {
            format!("({} voxels)", significant(mm / pitch_mm, 2))
        })
}

/// Whether gray values were asked for.
fn is_gray(data: &ReportData<'_>) -> bool {
    data.evaluation.half_width.is_some()
}

/// Names of the numbers at the head of the page.
fn headline(data: &ReportData<'_>) -> &'static [&'static str] {
    if is_gray(data) {
        &GRAY_HEADLINE
    } else {
        &HEADLINE
    }
}

fn cards(data: &ReportData<'_>) -> String {
    let mut out = String::from("<div class=\"cards\">");
    for kind in headline(data)
        .iter()
        .filter_map(|name| METRICS.iter().find(|k| k.name == *name))
    {
        let digits = if kind.name == "iou" { 4 } else { 3 };
        let measure = data.evaluation.measures.get(kind.name);
        let (value, unit) = shown(kind, measure, digits);
        let voxels = in_voxels(kind, measure, data.evaluation.grid.pitch_mm);
        let still = data.standing.map_or(String::new(), |standing| {
            let (value, unit) = shown(kind, standing.measures.get(kind.name), digits);
            format!("<div class=\"still\"><span>standing still</span><b>{value} {unit}</b></div>")
        });
        let _ = write!(
            out,
            "<div class=\"card\"><h3>{}</h3><div class=\"big\">{value}<small>{unit} {voxels}</small></div><p>{}{}</p>{still}</div>",
            escape(kind.title),
            escape(kind.summary),
            place(kind, data.evaluation),
        );
    }
    out.push_str("</div>");
    if let Some(standing) = data.standing {
        out.push_str(&turning_note(data.evaluation, standing));
    }
    out
}

/// Where the largest deviation is, for its card.
fn place(kind: &MetricKind, evaluation: &Evaluation) -> String {
    match evaluation.farthest {
        Some(farthest) if kind.name == surface_deviation::HAUSDORFF.name => {
            let [x, y, z] = farthest.at_mm.map(|mm| significant(mm, 3));
            let side = farthest.side.words();
            format!(" It is at x = {x}, y = {y}, z = {z} mm: {side}.")
        }
        _ => String::new(),
    }
}

/// Why there are two values.
fn turning_note(turning: &Evaluation, standing: &Evaluation) -> String {
    let (name, title) = if turning.half_width.is_some() {
        ("rms_error", "rms error")
    } else {
        ("pw", "process window")
    };
    let window = match (turning.measures.get(name), standing.measures.get(name)) {
        (Some(turning), Some(standing)) => format!(
            " Here the {title} is {} standing still and {} turning.",
            significant(standing, 3),
            significant(turning, 3)
        ),
        _ => String::new(),
    };
    if turning.sub_angles == 1 {
        return String::new();
    }
    format!(
        "<section><h2>Turning and standing still</h2><p>The vial keeps turning while a frame is shown, which blurs the frame over its arc. The large numbers include this \
         ({} positions per frame); “standing still” is what the same patterns would do if the vial stood still during each frame.{window} \
         More frames per turn bring the two together.</p></section>",
        turning.sub_angles,
    )
}

fn dose_plots(data: &ReportData<'_>) -> String {
    if let (Some(half_width), Some(wanted)) = (data.evaluation.half_width, data.inside) {
        let curves = gray_curves(data, wanted, half_width);
        return format!(
            "<div class=\"two\"><section><h2>How far the response is off</h2><p class=\"muted\">Voxels per error, on a logarithmic scale. The gray band is what the objective \
             asks for.</p>{}</section><section><h2>Response against gray value</h2><p class=\"muted\">Mean response of the voxels of each gray value, and one standard deviation \
             to either side. The dashed line is what was asked for.</p>{}</section></div>",
            error_plot(&curves, half_width),
            tone_plot(&curves),
        );
    }
    format!(
        "<div class=\"two\"><section><h2>How much dose part and void get</h2><p class=\"muted\">Voxels per bin, on a logarithmic scale. The farther the two peaks are apart, \
         the safer the print.</p>{}</section><section><h2>How much the threshold matters</h2><p class=\"muted\">Overlap of print and part if the resin gels at this dose. A broad plateau \
         tolerates errors of exposure.</p>{}</section></div>",
        histogram_plot(data),
        iou_plot(data),
    )
}

/// Bins of the error, and of the gray value.
const ERRORS: usize = 81;
const TONES: usize = 32;

/// What a gray print does, counted.
struct GrayCurves {
    /// Largest error that is drawn.
    reach: f64,
    /// Bright (gray ≥ ½) and dark voxels per error from −reach to reach.
    errors: [Vec<f64>; 2],
    /// Per gray value from 0 to 1: voxels, sum of their responses and of the squares.
    tones: Vec<[f64; 3]>,
}

fn gray_curves(data: &ReportData<'_>, wanted: &Volume<f32>, half_width: f64) -> GrayCurves {
    let largest = ["max_error_part", "max_error_void"]
        .iter()
        .filter_map(|name| data.evaluation.measures.get(name))
        .fold(0.0, f64::max);
    let reach = largest.max(2.0 * half_width).max(1e-6);
    let empty = || GrayCurves {
        reach,
        errors: [vec![0.0; ERRORS], vec![0.0; ERRORS]],
        tones: vec![[0.0; 3]; TONES],
    };
    let blocks: Vec<GrayCurves> = data
        .labels
        .values
        .par_chunks(BLOCK)
        .zip(data.response.values.par_chunks(BLOCK))
        .zip(wanted.values.par_chunks(BLOCK))
        .map(|((labels, response), wanted)| {
            let mut curves = empty();
            for ((&label, &m), &f) in labels.iter().zip(response).zip(wanted) {
                let class = match label {
                    label::PART => 0,
                    label::VOID => 1,
                    _ => continue,
                };
                let (m, f) = (f64::from(m), f64::from(f));
                let bin = (m - f + reach) / (2.0 * reach) * ERRORS as f64;
                curves.errors[class][(bin.max(0.0) as usize).min(ERRORS - 1)] += 1.0;
                let tone = &mut curves.tones[((f * TONES as f64) as usize).min(TONES - 1)];
                *tone = [tone[0] + 1.0, tone[1] + m, tone[2] + m * m];
            }
            curves
        })
        .collect();
    blocks.iter().fold(empty(), |mut all, block| {
        for class in 0..2 {
            for (sum, count) in all.errors[class].iter_mut().zip(&block.errors[class]) {
                *sum += count;
            }
        }
        for (sum, tone) in all.tones.iter_mut().zip(&block.tones) {
            *sum = std::array::from_fn(|i| sum[i] + tone[i]);
        }
        all
    })
}

fn error_plot(curves: &GrayCurves, half_width: f64) -> String {
    let reach = curves.reach;
    let most = curves.errors.iter().flatten().copied().fold(1.0, f64::max);
    let mut plot = Plot::new(
        Axis::linear("response − gray value", -reach, reach),
        Axis::log_with_zero("voxels", 1.0, most),
    );
    plot.band(-half_width, half_width, "window", "objective's band");
    plot.steps([-reach, reach], &curves.errors[1], "void", "dark (below ½)");
    plot.steps([-reach, reach], &curves.errors[0], "part", "bright");
    plot.svg("Histogram of the error of bright and dark voxels")
}

fn tone_plot(curves: &GrayCurves) -> String {
    let tone = |(i, [count, sum, squares]): (usize, &[f64; 3])| {
        let mean = sum / count;
        let deviation = (squares / count - mean * mean).max(0.0).sqrt();
        (*count > 0.0).then(|| ((i as f64 + 0.5) / TONES as f64, mean, deviation))
    };
    let tones: Vec<(f64, f64, f64)> = curves.tones.iter().enumerate().filter_map(tone).collect();
    let line =
        |sign: f64| -> Vec<[f64; 2]> { tones.iter().map(|(f, m, d)| [*f, m + sign * d]).collect() };
    let high = line(1.0).iter().map(|p| p[1]).fold(1.0, f64::max);
    let mut plot = Plot::new(
        Axis::linear("gray value of the target", 0.0, 1.0),
        Axis::linear("response", 0.0, high),
    );
    plot.line(&[[0.0, 0.0], [1.0, 1.0]], "still", "asked for");
    plot.line(&line(1.0), "void", "± deviation");
    plot.line(&line(-1.0), "void", "");
    plot.line(&line(0.0), "accent", "mean");
    plot.svg("Response against gray value")
}

fn histogram_plot(data: &ReportData<'_>) -> String {
    let histogram = &data.evaluation.histogram;
    let column = |c: usize| {
        histogram
            .counts
            .iter()
            .map(|n| n[c] as f64)
            .collect::<Vec<f64>>()
    };
    let (part, void) = (column(0), column(1));
    let most = part.iter().chain(&void).copied().fold(1.0, f64::max);
    let [low, high] = histogram.range;
    let mut plot = Plot::new(
        Axis::linear("response to the dose", low, high),
        Axis::log_with_zero("voxels", 1.0, most),
    );
    if let Some([lower, upper]) = data.window {
        plot.band(lower, upper, "window", "objective's window");
    }
    plot.steps(histogram.range, &void, "void", "void");
    plot.steps(histogram.range, &part, "part", "part");
    if let Some(threshold) = data.evaluation.gel_threshold {
        plot.line_at(threshold, "gel", "gel threshold");
    }
    plot.svg("Histogram of the dose in part and void")
}

fn iou_plot(data: &ReportData<'_>) -> String {
    let curve = &data.evaluation.curve;
    let [low, high] = data.evaluation.histogram.range;
    let mut plot = Plot::new(
        Axis::linear("gel threshold", low, high),
        Axis::linear("IoU", 0.0, 1.0),
    );
    if let Some(standing) = data.standing {
        plot.line(&standing.curve, "still", "standing still");
    }
    plot.line(
        curve,
        "accent",
        if data.standing.is_some() {
            "turning"
        } else {
            "IoU"
        },
    );
    if let (Some(threshold), Some(iou)) = (
        data.evaluation.gel_threshold,
        data.evaluation.measures.get("iou"),
    ) {
        plot.line_at(
            threshold,
            "gel",
            &format!("threshold {}", significant(threshold, 3)),
        );
        plot.dot([threshold, iou], "gel");
    }
    plot.svg("IoU against the gel threshold")
}

fn slices_section(data: &ReportData<'_>) -> String {
    if let Some(half_width) = data.evaluation.half_width {
        return format!(
            "<section><h2>Slices through the middle of the image</h2><p class=\"muted\">The gray values of the target, the response to the dose, and the difference. \
             Where a pixel stands for several voxels, it shows the largest difference.</p>{}<div class=\"legends\">{}{}</div></section>",
            slices(data),
            dose_bar(data),
            error_bar(half_width),
        );
    }
    let is_there = |mark: u8| data.bodies.is_some_and(|b| b.values.contains(&mark));
    let bodies = BODIES.iter().filter(|(mark, ..)| is_there(*mark));
    let fates: String = FATES
        .iter()
        .copied()
        .filter(|(_, name)| !name.is_empty())
        .chain(bodies.map(|(_, color, name)| (*color, *name)))
        .map(|([r, g, b, a], name)| {
            format!(
                "<span><i style=\"background:rgba({r},{g},{b},{:.2})\"></i>{name}</span>",
                f64::from(a) / 255.0
            )
        })
        .collect();
    format!(
        "<section><h2>Slices through the middle of the part's box</h2><p class=\"muted\">The target, the dose with the part's outline in white, and the errors of the print. \
         Where a pixel stands for several voxels, it shows the worst of them.</p>{}<div class=\"legends\">{}<div class=\"fates\">{fates}</div></div></section>",
        slices(data),
        dose_bar(data),
    )
}

/// Label of an axis that is a difference of responses, which has no logarithm.
const RESPONSE: &str = "response";

fn history(rows: &[HistoryRow]) -> String {
    let Some(last) = rows.last() else {
        return String::new();
    };
    let plots: String = [
        ("Loss", "loss", series(rows, |r| r.loss)),
        (
            "Projected gradient",
            "relative to the first",
            measured(rows, |r| r.projected_gradient),
        ),
        (
            "Voxels that would print wrongly",
            "1 − IoU",
            measured(rows, |r| r.iou.map(|v| 1.0 - v)),
        ),
        (
            "Process window",
            RESPONSE,
            measured(rows, |r| r.process_window),
        ),
    ]
    .iter()
    .filter(|(_, _, points)| points.len() > 1)
    .map(|(title, label, points)| {
        format!(
            "<section><h2>{title}</h2>{}</section>",
            history_plot(title, label, points)
        )
    })
    .collect();
    // Gradients of coarser voxels are not kept
    let first = rows.iter().find(|row| row.projected_gradient.is_some());
    let finer = first
        .map(|row| row.iteration.saturating_sub(1))
        .filter(|&n| n > 0);
    let finer = finer.map_or_else(String::new, |n| {
        format!(" After iteration {n} the voxels became finer: earlier numbers belong to coarser voxels, and the gradient curve begins there.")
    });
    format!(
        "<div class=\"two\">{plots}</div><p class=\"note\" style=\"margin:-8px 4px 20px\">{} iterations, {} dose and {} adjoint calls, {} s. Compare methods by model calls, not by iterations.{finer}</p>",
        last.iteration,
        last.forward_calls,
        last.adjoint_calls,
        significant(last.seconds, 3),
    )
}

fn series(rows: &[HistoryRow], value: impl Fn(&HistoryRow) -> f64) -> Vec<[f64; 2]> {
    rows.iter()
        .map(|r| [(r.forward_calls + r.adjoint_calls) as f64, value(r)])
        .filter(|p| p[1].is_finite())
        .collect()
}

/// A series with gaps: metrics are not measured after every iteration, and the start has no gradient.
fn measured(rows: &[HistoryRow], value: impl Fn(&HistoryRow) -> Option<f64>) -> Vec<[f64; 2]> {
    series(rows, |r| value(r).unwrap_or(f64::NAN))
}

fn history_plot(title: &str, label: &str, points: &[[f64; 2]]) -> String {
    let last = points.last().map_or(1.0, |p| p[0]);
    let values = || points.iter().map(|p| p[1]);
    let positive = || values().filter(|v| *v > 0.0);
    let (low, high) = (
        positive().fold(f64::INFINITY, f64::min),
        positive().fold(0.0, f64::max),
    );
    let least = values().fold(0.0, f64::min);
    if high == 0.0 && least == 0.0 {
        return format!(
            "<p>It is 0 at each of the {} points that were measured.</p>",
            points.len()
        );
    }
    let y = if least < 0.0 || label == RESPONSE {
        Axis::linear(label, least, high)
    } else if values().any(|v| v == 0.0) {
        Axis::log_with_zero(label, low, high)
    } else {
        Axis::log(label, low, high)
    };
    let mut plot = Plot::new(Axis::linear("model calls (dose and adjoint)", 0.0, last), y);
    plot.line(points, "accent", "");
    plot.zeros(points, "accent");
    plot.svg(&format!("{title} against model calls"))
}

fn patterns(data: &ReportData<'_>) -> String {
    data.lights
        .iter()
        .map(|light| {
            let of = if light.name.is_empty() { String::new() } else { format!(" of light {}", escape(light.name)) };
            format!(
                "<section><h2>Light patterns{of}</h2><p class=\"muted\">One row of all frames (a sinogram), and some frames as the projector shows them. \
                 White is {} over the whole exposure, relative as all doses are.</p>{}{}</section>",
                significant(f64::from(light.full_scale), 4),
                sinogram(light.patterns, light.full_scale),
                strip(light.patterns, light.full_scale),
            ) + &machine(light)
        })
        .collect()
}

/// Time, energy and use of the light.
fn machine(light: &LightReport<'_>) -> String {
    let budget = &light.budget;
    let of = if light.name.is_empty() {
        String::new()
    } else {
        format!(", light {}", escape(light.name))
    };
    let number = |value: Option<f64>, unit: &str| {
        value.map_or_else(
            || "–".to_owned(),
            |value| format!("{} {unit}", significant(value, 3)),
        )
    };
    let canvas = light.canvas.map_or_else(
        || "the patterns as they are".to_owned(),
        |[columns, rows]| format!("{columns} × {rows} pixels"),
    );
    let brightest = light.irradiance.map(|irradiance| {
        let own = number(Some(irradiance.white_mw_per_cm2), "mW/cm²");
        let share = irradiance.peak_mw_per_cm2.map_or_else(String::new, |peak| {
            let percent = 100.0 * irradiance.white_mw_per_cm2 / peak;
            format!(", {} % of what the printer gives", significant(percent, 3))
        });
        ("White, while it shines", own + &share)
    });
    let rows: String = [
        ("Device", canvas),
        (
            "Time to print",
            budget.time_s.map_or_else(|| "–".to_owned(), clock),
        ),
        ("Turns of the vial", number(budget.turns, "")),
        (
            "White, of a frame over the whole print",
            number(budget.white_mj_per_mm2, "mJ/mm²"),
        ),
        (
            "Energy at the vial per turn",
            number(budget.energy_per_turn_mj, "mJ"),
        ),
        ("Energy at the vial in all", number(budget.energy_mj, "mJ")),
        (
            "Share of the device's light that is used",
            number(Some(100.0 * budget.light_used), "%"),
        ),
    ]
    .into_iter()
    .chain(brightest)
    .map(|(name, value)| format!("<tr><td>{name}</td><td>{value}</td></tr>"))
    .collect();
    let missing = if light.irradiance.is_some() {
        "<p class=\"note\">The job's schedule says how long and how bright the light is.</p>"
    } else if budget.time_s.is_none() {
        "<p class=\"note\">Times need resin.critical_dose_mj_per_mm3 and printer.peak_irradiance_mw_per_cm2.</p>"
    } else {
        ""
    };
    format!(
        "<section><h2>On the printer{of}</h2><table class=\"plain\"><tbody>{rows}</tbody></table>{missing}</section>"
    )
}

/// Seconds as hours, minutes and seconds.
pub(super) fn clock(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    match whole {
        0..60 => format!("{} s", significant(seconds, 3)),
        60..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole / 60 % 60),
    }
}

fn table(data: &ReportData<'_>) -> String {
    let columns: Vec<(&str, String, &Evaluation)> = [
        ("Turning", Some(data.evaluation)),
        ("Standing still", data.standing),
        ("Optimization", data.optimization),
    ]
    .into_iter()
    .filter_map(|(name, e)| {
        e.map(|e| {
            (
                name,
                format!("{} µm voxels", significant(e.grid.pitch_mm * 1e3, 3)),
                e,
            )
        })
    })
    .collect();
    let heads: String = columns
        .iter()
        .map(|(name, grid, _)| format!("<th>{name}<br>{grid}</th>"))
        .collect();
    let mut rows = String::new();
    let known = |kind: &&MetricKind| {
        let mut measured = columns.iter().map(|c| c.2.measures.get(kind.name));
        measured.any(|m| m.is_some())
    };
    // The numbers of the other kind of target are left out; a gray target's own come first
    let mut kinds: Vec<&MetricKind> = METRICS.iter().filter(known).collect();
    kinds.sort_by_key(|kind| is_gray(data) && !GRAY_HEADLINE.contains(&kind.name));
    for kind in kinds {
        let better = match kind.better {
            Better::Higher => " ↑",
            Better::Lower => " ↓",
            Better::Neutral => "",
        };
        let unit = match kind.unit {
            "response" | "" => "",
            "mm" => "µm",
            unit => unit,
        };
        let _ = write!(
            rows,
            "<tr><td>{}{better} <span class=\"unit\">{unit}</span><small>{}</small></td>",
            escape(kind.title),
            escape(kind.summary)
        );
        for (i, (_, _, evaluation)) in columns.iter().enumerate() {
            let measure = evaluation.measures.get(kind.name);
            let (value, _) = shown(kind, measure, 4);
            let voxels = in_voxels(kind, measure, evaluation.grid.pitch_mm);
            let class = if i == 0 { " class=\"head\"" } else { "" };
            let _ = write!(
                rows,
                "<td{class}>{value} <span class=\"unit\">{voxels}</span></td>"
            );
        }
        rows.push_str("</tr>");
    }
    let gray = if is_gray(data) {
        " For a gray target, “part” is where its value is at least ½."
    } else {
        ""
    };
    format!(
        "<section><h2>All numbers</h2><p class=\"muted\">↑ larger is better, ↓ smaller is better. The first columns are on the finer grid, from the patterns as they were written; \
         the last one is of the patterns before they are written, on the job's own voxels, the vial standing still.{gray}</p><div class=\"scroll\"><table><thead><tr><th></th>{heads}</tr></thead><tbody>{rows}</tbody></table></div></section>"
    )
}

/// Numbers with other authors' signs and normalizations.
fn published(data: &ReportData<'_>) -> String {
    let text =
        |about: &serde_json::Value, key: &str| escape(about[key].as_str().unwrap_or_default());
    let rows: String = data
        .published
        .iter()
        .filter(|(_, about)| about["source"].is_string())
        .map(|(name, about)| {
            let value = about["value"]
                .as_f64()
                .map_or("–".to_owned(), |v| significant(v, 4));
            format!(
                "<tr><td>{}</td><td>{value} {}</td><td>{}</td><td>{}</td></tr>",
                escape(name),
                text(about, "unit"),
                text(about, "note"),
                text(about, "source"),
            )
        })
        .collect();
    if rows.is_empty() {
        return String::new();
    }
    format!(
        "<section><details><summary>Numbers as they were published</summary><div class=\"scroll\"><table><thead><tr><th>Name</th><th>Value</th><th>Definition</th><th>Source</th></tr></thead><tbody>{rows}</tbody></table></div></details></section>"
    )
}

fn times_and_movies(data: &ReportData<'_>) -> String {
    let mut out = String::new();
    if !data.movies.is_empty() {
        let column = |name: &str, cell: &dyn Fn(&MovieReport) -> String| {
            let cells: String = data
                .movies
                .iter()
                .map(|m| format!("<td>{}</td>", cell(m)))
                .collect();
            format!("<tr><td>{name}</td>{cells}</tr>")
        };
        let heads: String = data
            .movies
            .iter()
            .map(|movie| {
                format!(
                    "<th class=\"file\">{}</th>",
                    escape(&movie.file).replace('_', "_<wbr>")
                )
            })
            .collect();
        let rows = [
            column("Largest gray error", &|m| {
                format!("{} of 255", m.check.largest_error)
            }),
            column("rms gray error", &|m| significant(m.check.rms_error, 2)),
            column("Frames", &|m| m.check.frames.to_string()),
            column("Rate", &|m| {
                format!("{} /s", significant(m.check.frame_rate, 4))
            }),
            column("Pixels", &|m| {
                format!("{} × {}", m.check.width, m.check.height)
            }),
            column("Size", &|m| {
                format!("{} MB", significant(m.check.bytes as f64 / 1e6, 3))
            }),
        ]
        .concat();
        let _ = write!(
            out,
            "<section><h2>Movie</h2><p class=\"muted\">Written, then decoded again and compared with the frames. H.264 is lossy: the PNG frames are exact.</p>\
             <div class=\"scroll\"><table class=\"movies\"><thead><tr><th>File</th>{heads}</tr></thead><tbody>{rows}</tbody></table></div></section>"
        );
    }
    let longest = data.timings.iter().map(|t| t.seconds).fold(0.0, f64::max);
    if longest > 0.0 {
        let total: f64 = data.timings.iter().map(|t| t.seconds).sum();
        let rows: String = data
            .timings
            .iter()
            .map(|t| {
                format!(
                    "<div class=\"row\"><label>{}</label><div><i style=\"width:{:.1}%\"></i></div><span>{} s</span></div>",
                    escape(&t.name),
                    100.0 * t.seconds / longest,
                    significant(t.seconds, 3),
                )
            })
            .collect();
        let _ = write!(
            out,
            "<section><h2>Where the time went</h2><p class=\"muted\">{} s until this page was written.</p><div class=\"time\">{rows}</div></section>",
            significant(total, 3),
        );
    }
    out
}

fn job(data: &ReportData<'_>) -> String {
    if data.job_text.is_empty() {
        return String::new();
    }
    format!(
        "<section><details><summary>The job, with every default</summary><pre>{}</pre></details></section>",
        escape(data.job_text)
    )
}
