//! Curves of the page: doses, errors and tones, IoU over the threshold, the history of the optimization.

use super::super::ReportData;
use super::super::maps::histograms::joined;
use super::super::number::{escape, significant};
use super::super::plot::{Axis, Plot};
use tomolith_core::field::BLOCK;
use tomolith_core::grid::Volume;
use tomolith_core::parallel::InParallel;
use tomolith_core::target::label;
use tomolith_io::csv::HistoryRow;

pub(super) fn dose_plots(data: &ReportData<'_>) -> String {
    if let (Some(half_width), Some(wanted)) = (data.evaluation.half_width, data.inside) {
        let tones = gray_tones(data, wanted);
        return format!(
            "<div class=\"two\"><section><h2>How far the response is off</h2><p class=\"muted\">Voxels per error, on a logarithmic scale. The gray band is what the objective \
             asks for.</p>{}</section><section><h2>Response against gray value</h2><p class=\"muted\">Mean response of the voxels of each gray value, and one standard deviation \
             to either side. The dashed line is what was asked for.</p>{}</section></div>",
            error_plot(data, half_width),
            tone_plot(&tones),
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

/// Bins of the error, about, and of the gray value.
const ERRORS: f64 = 80.0;
const TONES: usize = 32;

/// Per gray value from 0 to 1: voxels, sum of their responses and of the squares.
type Tones = Vec<[f64; 3]>;

fn gray_tones(data: &ReportData<'_>, wanted: &Volume<f32>) -> Tones {
    let empty = || vec![[0.0; 3]; TONES];
    let blocks: Vec<Tones> = data
        .labels
        .values
        .chunks(BLOCK)
        .zip(data.response.values.chunks(BLOCK))
        .zip(wanted.values.chunks(BLOCK))
        .par_map(|((labels, response), wanted)| {
            let mut tones = empty();
            for ((&label, &m), &f) in labels.iter().zip(response).zip(wanted) {
                if ![label::PART, label::VOID].contains(&label) {
                    continue;
                }
                let (m, f) = (f64::from(m), f64::from(f));
                let tone = &mut tones[((f * TONES as f64) as usize).min(TONES - 1)];
                *tone = [tone[0] + 1.0, tone[1] + m, tone[2] + m * m];
            }
            tones
        });
    blocks.iter().fold(empty(), |mut all, block| {
        for (sum, tone) in all.iter_mut().zip(block) {
            *sum = std::array::from_fn(|i| sum[i] + tone[i]);
        }
        all
    })
}

fn error_plot(data: &ReportData<'_>, half_width: f64) -> String {
    let Some(errors) = &data.evaluation.errors else {
        return String::new();
    };
    let largest = ["max_error_part", "max_error_void"]
        .iter()
        .filter_map(|name| data.evaluation.measures.get(name))
        .fold(0.0, f64::max);
    // Not narrower than a few bins
    let least = 8.0 * errors.reach / errors.counts.len() as f64;
    let reach = largest.max(2.0 * half_width).max(least).min(errors.reach);
    let column = |class: usize| {
        let counts: Vec<f64> = errors.counts.iter().map(|n| n[class] as f64).collect();
        joined(
            [-errors.reach, errors.reach],
            &counts,
            [-reach, reach],
            ERRORS,
        )
    };
    let [(ends, bright), (_, dark)] = [column(0), column(1)];
    let most = bright.iter().chain(&dark).copied().fold(1.0, f64::max);
    let mut plot = Plot::new(
        Axis::linear("response − gray value", ends[0], ends[1]),
        Axis::log_with_zero("voxels", 1.0, most),
    );
    plot.band(-half_width, half_width, "window", "objective's band");
    plot.steps(ends, &dark, "void", "dark (below ½)");
    plot.steps(ends, &bright, "part", "bright");
    plot.svg("Histogram of the error of bright and dark voxels")
}

fn tone_plot(tones: &Tones) -> String {
    let tone = |(i, [count, sum, squares]): (usize, &[f64; 3])| {
        let mean = sum / count;
        let deviation = (squares / count - mean * mean).max(0.0).sqrt();
        (*count > 0.0).then(|| ((i as f64 + 0.5) / TONES as f64, mean, deviation))
    };
    let tones: Vec<(f64, f64, f64)> = tones.iter().enumerate().filter_map(tone).collect();
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

/// Label of an axis that is a difference of responses, which has no logarithm.
const RESPONSE: &str = "response";

pub(super) fn history(rows: &[HistoryRow]) -> String {
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
    .into_iter()
    .map(|(title, label, points)| (title.to_owned(), label, points))
    .chain(of_response(rows))
    .filter(|(_, _, points)| points.len() > 1)
    .map(|(title, label, points)| {
        format!(
            "<section><h2>{}</h2>{}</section>",
            escape(&title),
            history_plot(&title, label, &points)
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

/// Parameters of the response that were found with the patterns.
fn of_response(rows: &[HistoryRow]) -> Vec<(String, &'static str, Vec<[f64; 2]>)> {
    let names = rows.last().map_or(&[][..], |row| &row.response);
    let curve = |(i, (name, _)): (usize, &(String, f64))| {
        let points = measured(rows, |r| r.response.get(i).map(|(_, value)| *value));
        (format!("Response: {name}"), "found so far", points)
    };
    names.iter().enumerate().map(curve).collect()
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
