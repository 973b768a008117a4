//! Histories, histograms and curves of all runs, laid over each other.

use super::class;
use super::run::ComparedRun;
use crate::plot::{Axis, Plot};
use serde_json::Value;

/// A column of the histories against calls or seconds.
pub(super) fn history(
    runs: &[ComparedRun],
    column: &str,
    x: fn(&ComparedRun, usize) -> Option<f64>,
    label: &str,
) -> Option<String> {
    let lines: Vec<Vec<[f64; 2]>> = runs
        .iter()
        .map(|run| run.points(|i| x(run, i), column))
        .collect();
    let all = || lines.iter().flatten();
    let most = all().map(|p| p[0]).reduce(f64::max)?;
    let positive = || all().map(|p| p[1]).filter(|y| *y > 0.0);
    let axis = match (
        column,
        positive().reduce(f64::min),
        positive().reduce(f64::max),
    ) {
        ("loss", Some(low), Some(high)) if all().any(|p| p[1] <= 0.0) => {
            Axis::log_with_zero("loss", low, high)
        }
        ("loss", Some(low), Some(high)) => Axis::log("loss", low, high),
        _ => Axis::linear("IoU", all().map(|p| p[1]).fold(1.0, f64::min), 1.0),
    };
    let mut plot = Plot::new(Axis::linear(label, 0.0, most), axis);
    for (i, line) in lines
        .iter()
        .enumerate()
        .filter(|(_, line)| !line.is_empty())
    {
        plot.line(line, &class(i), "");
        plot.zeros(line, &class(i));
    }
    Some(plot.svg(&format!("{column} against {label}")))
}

fn numbers_of(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_f64)
        .collect()
}

pub(super) fn curves(runs: &[ComparedRun]) -> Option<String> {
    let curve = |run: &ComparedRun| -> Vec<[f64; 2]> {
        let points = run.report["evaluation"]["iou_curve"]
            .as_array()
            .into_iter()
            .flatten();
        points
            .filter_map(|point| numbers_of(point).try_into().ok())
            .collect()
    };
    let lines: Vec<Vec<[f64; 2]>> = runs.iter().map(curve).collect();
    let most = lines.iter().flatten().map(|p| p[0]).reduce(f64::max)?;
    let mut plot = Plot::new(
        Axis::linear("gel threshold", 0.0, most),
        Axis::linear("IoU", 0.0, 1.0),
    );
    for (i, line) in lines
        .iter()
        .enumerate()
        .filter(|(_, line)| !line.is_empty())
    {
        plot.line(line, &class(i), "");
    }
    Some(plot.svg("IoU against the gel threshold"))
}

/// Outline of a histogram as shares of all its voxels, per unit of the response.
pub(super) fn outline(histogram: &Value, of: &str) -> Vec<[f64; 2]> {
    let (range, counts) = (numbers_of(&histogram["range"]), numbers_of(&histogram[of]));
    let total: f64 = counts.iter().sum();
    let (&[low, high], true) = (range.as_slice(), total > 0.0) else {
        return Vec::new();
    };
    let width = (high - low) / counts.len() as f64;
    let step = |(i, n): (usize, &f64)| {
        let (left, height) = (low + i as f64 * width, n / (total * width));
        [[left, height], [left + width, height]]
    };
    counts.iter().enumerate().flat_map(step).collect()
}

/// Least share of the voxels per unit of response that the axis shows, against the largest.
const FAINTEST: f64 = 1e-6;

pub(super) fn histograms(runs: &[ComparedRun]) -> Option<String> {
    let lines: Vec<[Vec<[f64; 2]>; 2]> = runs
        .iter()
        .map(|run| ["part", "void"].map(|of| outline(&run.report["evaluation"]["histogram"], of)))
        .collect();
    let all = || lines.iter().flatten().flatten();
    let (right, most) = (
        all().map(|p| p[0]).reduce(f64::max)?,
        all().map(|p| p[1]).reduce(f64::max)?,
    );
    let least = all()
        .map(|p| p[1])
        .filter(|y| *y > 0.0)
        .reduce(f64::min)?
        .max(FAINTEST * most);
    let mut plot = Plot::new(
        Axis::linear("response to the dose", 0.0, right),
        Axis::log_with_zero("share per unit", least, most),
    );
    for (i, [part, void]) in lines.iter().enumerate() {
        plot.line(part, &class(i), "");
        plot.line(void, &format!("{} dotted", class(i)), "");
    }
    Some(plot.svg("Histograms of the dose in part and void"))
}
