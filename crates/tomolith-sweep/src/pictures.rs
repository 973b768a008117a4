//! The pictures of a sweep, one file per metric: a curve over one axis, a map over two, small multiples over more; dots over each axis of
//! points that were drawn.

use crate::axes::Axis;
use crate::expression::Expression;
use crate::plan::SweepPlan;
use crate::table::{State, Table};
use serde_json::Value;
use std::path::{Path, PathBuf};
use tomolith::Result;
use tomolith::io::{read_text, write_text};
use tomolith::report::maps::{Cell, Guide, MapAxis, Panel, PlotCurve, curves, heat_maps};
use tomolith::report::number::significant;

/// Small multiples in a picture, at most.
const PANELS: usize = 24;

/// Writes the picture of every metric.
pub(crate) fn write(plan: &SweepPlan, table: &Table<'_>, folder: &Path) -> Result<Vec<PathBuf>> {
    let file = |path: &String| {
        let file = folder.join(file_name(path));
        let svg = picture(plan, table, path);
        write_text(&file, &svg)?;
        Ok(file)
    };
    if plan.sweep.axes.is_empty() {
        return Ok(Vec::new());
    }
    plan.sweep.metrics.iter().map(file).collect()
}

fn file_name(metric: &str) -> String {
    format!("{}.svg", tomolith::text::file_name(metric, '-'))
}

/// Removes the pictures of metrics that the table of an earlier call had and this sweep does not collect.
pub(crate) fn remove_outdated(plan: &SweepPlan, folder: &Path) {
    let before = read_text(folder.join("table.csv")).unwrap_or_default();
    let head = before.lines().next().unwrap_or_default();
    let metrics = head.split(',').skip_while(|name| *name != "state").skip(1);
    for metric in metrics.take_while(|name| *name != "feasible") {
        if !plan.sweep.metrics.iter().any(|name| name == metric) {
            // Gone already is as good
            let _ = std::fs::remove_file(folder.join(file_name(metric)));
        }
    }
}

fn picture(plan: &SweepPlan, table: &Table<'_>, metric: &str) -> String {
    let axes = &plan.sweep.axes;
    let caption = caption(plan, table, metric);
    let cell = |i: usize| Cell {
        value: table.metric(i, metric),
        // Without `best.where` there is no feasible region to outline
        is_feasible: plan.sweep.best.conditions.is_empty() || table.is_feasible(i),
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
    let scale = |axis: &Axis| MapAxis {
        name: axis.name.clone(),
        labels: labels(axis),
    };
    let (panels, left_out) = panels(plan, &cell);
    let caption = match left_out {
        0 => caption,
        n => format!("{caption} {n} more maps are in the table only."),
    };
    heat_maps(
        metric,
        [&scale(&axes[0]), &scale(&axes[1])],
        &panels,
        &guides(plan),
        &caption,
    )
}

fn labels(axis: &Axis) -> Vec<String> {
    let labels = axis.values().iter().map(|value| axis.label(value));
    labels.collect()
}

/// Steps along an axis in which a guide is looked for.
const STEPS: usize = 200;

/// Where the equations of the guides hold, between the cells of the first two axes.
fn guides(plan: &SweepPlan) -> Vec<Guide> {
    let axes = &plan.sweep.axes;
    let guide = |(name, [left, right]): &(String, [Expression; 2])| {
        let values = [0, 1].map(|a| {
            let numbers = axes[a].values().iter().filter_map(Value::as_f64);
            numbers.collect::<Vec<f64>>()
        });
        let off = |[x, y]: [f64; 2]| {
            let value_of = |name: &str| {
                let a = usize::from(axes[0].name != name);
                Some(between(&values[a], [x, y][a]))
            };
            Some(left.value(&value_of)? - right.value(&value_of)?)
        };
        let last = values.each_ref().map(|values| (values.len() - 1) as f64);
        // A line that is steep is found along x, a flat one along y
        let along = [0, 1].map(|a| zeros(a, last, &off));
        let [of_rows, of_columns] = along;
        Guide {
            name: name.clone(),
            points: if of_rows.len() >= of_columns.len() {
                of_rows
            } else {
                of_columns
            },
        }
    };
    let guides = plan.sweep.guides.iter().map(guide);
    // A guide outside of the map gets no line in the legend
    guides.filter(|guide| !guide.points.is_empty()).collect()
}

/// The value at a place between two cells.
fn between(values: &[f64], place: f64) -> f64 {
    let i = (place.max(0.0) as usize).min(values.len().saturating_sub(2));
    let next = values[(i + 1).min(values.len() - 1)];
    values[i] + (place - i as f64) * (next - values[i])
}

/// Places where a function of both axes changes its sign along axis `a`, one for each of many places on the other; half a cell beyond the outer ones counts.
fn zeros(a: usize, last: [f64; 2], off: &dyn Fn([f64; 2]) -> Option<f64>) -> Vec<[f64; 2]> {
    let place = |a: usize, i: usize| -0.5 + (last[a] + 1.0) * i as f64 / STEPS as f64;
    let at = |along: f64, across: f64| {
        if a == 0 {
            [along, across]
        } else {
            [across, along]
        }
    };
    let zero = |k: usize| {
        let across = place(1 - a, k);
        let value = |i: usize| off(at(place(a, i), across)).filter(|value| value.is_finite());
        (1..=STEPS).find_map(|i| {
            let (before, after) = (value(i - 1)?, value(i)?);
            let is_between = before != after && before * after <= 0.0;
            let step = place(a, i) - place(a, i - 1);
            is_between.then(|| at(place(a, i - 1) + step * before / (before - after), across))
        })
    };
    (0..=STEPS).filter_map(zero).collect()
}

fn caption(plan: &SweepPlan, table: &Table<'_>, metric: &str) -> String {
    let best = &plan.sweep.best;
    let Some(i) = table.best else {
        return "No run meets the conditions of best.where.".to_owned();
    };
    let number = |path: &str| {
        table
            .metric(i, path)
            .map_or("–".to_owned(), |v| significant(v, 4))
    };
    let which = if best.is_highest { "highest" } else { "lowest" };
    let ranked = format!("{which} {} = {}", best.metric, number(&best.metric));
    let value = if metric == best.metric {
        String::new()
    } else {
        format!("; there {metric} = {}", number(metric))
    };
    format!("Best: {ranked} at {}{value}.", plan.words(i))
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
        labels: (!are_numbers).then(|| labels(axis)),
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
            .position(|(index, _)| index == rest)
            .unwrap_or_else(|| {
                let words = axes[2..]
                    .iter()
                    .zip(rest)
                    .map(|(axis, &k)| format!("{} = {}", axis.name, axis.label(&axis.values()[k])));
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_guide_runs_where_its_equation_holds() {
        // Cells at 0, 0.5, 1 and 0, 0.25, 0.5, 0.75, 1: x = 0.75·y goes from the corner to (0.75, 1), half a cell further on both sides
        let [x, y] = [vec![0.0, 0.5, 1.0], vec![0.0, 0.25, 0.5, 0.75, 1.0]];
        let off = |[i, j]: [f64; 2]| Some(between(&x, i) - 0.75 * between(&y, j));
        let points = zeros(0, [2.0, 4.0], &off);
        assert_eq!(points.len(), STEPS + 1);
        for [i, j] in points {
            assert!((i - 2.0 * 0.75 * 0.25 * j).abs() < 1e-9, "{i} {j}");
        }
        // A level line is found from column to column
        let level = |[_, j]: [f64; 2]| Some(between(&y, j) - 0.6);
        assert!(zeros(0, [2.0, 4.0], &level).is_empty());
        let points = zeros(1, [2.0, 4.0], &level);
        assert_eq!(points.len(), STEPS + 1);
        assert!(points.iter().all(|[_, j]| (j - 2.4).abs() < 1e-9));
    }
}
