//! The pictures of a sweep, one file per metric: a curve over one axis, a map over two, small multiples over more; dots over each axis of
//! points that were drawn.

use crate::axes::{Axis, label};
use crate::plan::SweepPlan;
use crate::table::{State, Table};
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use tomolith::Result;
use tomolith::io::write_whole;
use tomolith::report::maps::{Cell, ColorScale, Panel, PlotCurve, curves, heat_maps};
use tomolith::report::number::significant;

/// Small multiples in a picture, at most.
const PANELS: usize = 24;

/// Writes the picture of every metric.
///
/// # Errors
/// [`Error::Io`](tomolith::Error::Io).
pub(crate) fn write(plan: &SweepPlan, table: &Table<'_>, folder: &Path) -> Result<Vec<PathBuf>> {
    let file = |path: &String| {
        let file = folder.join(file_name(path));
        let svg = picture(plan, table, path);
        write_whole(&file, |out| Ok(out.write_all(svg.as_bytes())?))?;
        Ok(file)
    };
    if plan.sweep.axes.is_empty() {
        return Ok(Vec::new());
    }
    plan.sweep.metrics.iter().map(file).collect()
}

fn file_name(metric: &str) -> String {
    let kept = |c: char| match c.is_alphanumeric() || "._-".contains(c) {
        true => c,
        false => '-',
    };
    format!("{}.svg", metric.chars().map(kept).collect::<String>())
}

/// Removes the pictures of metrics that the table of an earlier call had and this sweep does not collect.
pub(crate) fn remove_outdated(plan: &SweepPlan, folder: &Path) {
    let before = std::fs::read_to_string(folder.join("table.csv")).unwrap_or_default();
    let head = before.lines().next().unwrap_or_default();
    let metrics = head.split(',').skip_while(|name| *name != "state").skip(1);
    for metric in metrics.take_while(|name| *name != "feasible") {
        if !plan.sweep.metrics.iter().any(|own| own == metric) {
            // Gone already is as good
            let _ = std::fs::remove_file(folder.join(file_name(metric)));
        }
    }
}

/// The picture of a metric.
fn picture(plan: &SweepPlan, table: &Table<'_>, metric: &str) -> String {
    let axes = &plan.sweep.axes;
    let caption = caption(plan, table, metric);
    let cell = |i: usize| Cell {
        value: table.metric(i, metric),
        is_feasible: table.is_feasible(i),
        is_best: table.best == Some(i),
        has_failed: matches!(table.states[i], State::Failed(_)),
    };
    if plan.sweep.spec.sample.is_some() {
        let curves_of: Vec<PlotCurve> = (0..axes.len())
            .map(|a| curve(plan, a, false, &cell))
            .collect();
        return curves(metric, &curves_of, &caption);
    }
    if axes.len() == 1 {
        return curves(metric, &[curve(plan, 0, true, &cell)], &caption);
    }
    let scale = |axis: &Axis| ColorScale {
        name: axis.name.clone(),
        labels: axis.values().iter().map(label).collect(),
    };
    let (panels, left_out) = panels(plan, &cell);
    let caption = match left_out {
        0 => caption,
        n => format!("{caption} {n} more maps are in the table only."),
    };
    heat_maps(
        metric,
        &scale(&axes[0]),
        &scale(&axes[1]),
        &panels,
        &caption,
    )
}

fn caption(plan: &SweepPlan, table: &Table<'_>, metric: &str) -> String {
    let best = &plan.sweep.best;
    let Some(i) = table.best else {
        return "No run meets what is asked.".to_owned();
    };
    let number = |path: &str| {
        table
            .metric(i, path)
            .map_or("–".to_owned(), |v| significant(v, 4))
    };
    let which = if best.is_highest { "highest" } else { "lowest" };
    let ranked = format!("{which} {} = {}", best.metric, number(&best.metric));
    let own = if metric == best.metric {
        String::new()
    } else {
        format!("; there {metric} = {}", number(metric))
    };
    format!("Best: {ranked} at {}{own}.", plan.words(i))
}

/// One metric over one axis.
fn curve(plan: &SweepPlan, a: usize, is_joined: bool, cell: &dyn Fn(usize) -> Cell) -> PlotCurve {
    let axis = &plan.sweep.axes[a];
    let values = || plan.runs.iter().map(|run| &run.point.values[a]);
    let are_numbers = values().all(Value::is_number);
    let place = |value: &Value| {
        let index = || axis.values().iter().position(|v| v == value).unwrap_or(0) as f64;
        value.as_f64().filter(|_| are_numbers).unwrap_or_else(index)
    };
    let mut points: Vec<(f64, Cell)> = values()
        .enumerate()
        .map(|(i, value)| (place(value), cell(i)))
        .collect();
    if are_numbers {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    PlotCurve {
        name: axis.name.clone(),
        labels: (!are_numbers).then(|| axis.values().iter().map(label).collect()),
        is_log: axis.is_log && are_numbers,
        is_joined: is_joined && are_numbers,
        points,
    }
}

/// A map over the first two axes for each combination of the others, and how many are left out.
fn panels(plan: &SweepPlan, cell: &dyn Fn(usize) -> Cell) -> (Vec<Panel>, usize) {
    let axes = &plan.sweep.axes;
    let [columns, rows] = [0, 1].map(|a| axes[a].values().len());
    let mut panels: Vec<(Vec<usize>, Panel)> = Vec::new();
    for (i, run) in plan.runs.iter().enumerate() {
        let Some(index) = &run.point.index else {
            continue;
        };
        let rest = &index[2..];
        let at = panels
            .iter()
            .position(|(own, _)| own == rest)
            .unwrap_or_else(|| {
                let words = axes[2..]
                    .iter()
                    .zip(rest)
                    .map(|(axis, &k)| format!("{} = {}", axis.name, label(&axis.values()[k])));
                let panel = Panel {
                    title: words.collect::<Vec<_>>().join(", "),
                    cells: vec![None; columns * rows],
                };
                panels.push((rest.to_vec(), panel));
                panels.len() - 1
            });
        panels[at].1.cells[index[1] * columns + index[0]] = Some(cell(i));
    }
    panels.sort_by(|a, b| a.0.cmp(&b.0));
    let left_out = panels.len().saturating_sub(PANELS);
    (
        panels
            .into_iter()
            .take(PANELS)
            .map(|(_, panel)| panel)
            .collect(),
        left_out,
    )
}
