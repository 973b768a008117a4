//! Every optimizer and every objective on six targets.

use crate::case::{Case, Method, Origin, Sample, Track};
use crate::picture::{Curve, Panel, picture};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::fs::OpenOptions;
use std::io::Write as _;
use std::path::Path;
use tomolith::Error;
use tomolith::grid::Patterns;

/// Model calls at which the tables measure.
const COLUMNS: [u64; 3] = [40, 100, 400];

/// What a case is made of: name, `[target]`, edge of the field in mm, voxels, frames.
type Recipe = (&'static str, Value, f64, [usize; 3], usize);

/// Those of four flat parts, a gyroid and the boat that are named, or all; the boat only when its mesh is given.
fn six(mesh: Option<&Path>, names: &[&str]) -> impl Iterator<Item = Result<Case, Error>> {
    let flat = |name, n: usize, phantom: Value| {
        let target = json!({ "phantom": phantom });
        (name, target, 6.4, [1, n, n], 45 * n / 32)
    };
    let mut recipes: Vec<Recipe> = vec![
        flat(
            "disc",
            128,
            json!({"cylinder": {"size_mm": 3.2, "height_mm": 20.0}}),
        ),
        flat(
            "dog-bones",
            128,
            json!({"dog_bones": {"size_mm": 5.0, "height_mm": 20.0}}),
        ),
        flat(
            "chart",
            192,
            json!({"resolution_chart": {"size_mm": 4.4, "height_mm": 20.0}}),
        ),
        flat(
            "gear",
            128,
            json!({"gear": {"size_mm": 5.0, "height_mm": 20.0, "teeth": 12, "bore_mm": 1.6}}),
        ),
        gyroid_recipe(64),
    ];
    match mesh {
        // 10 mm long and 8 mm high
        Some(mesh) => recipes.push((
            "boat",
            json!({"mesh": mesh, "size_mm": 10.0}),
            11.6,
            [67, 96, 96],
            72,
        )),
        None => println!("the boat is left out: no mesh was given"),
    }
    recipes.retain(|recipe| names.is_empty() || names.contains(&recipe.0));
    recipes
        .into_iter()
        .map(|(name, spec, field_mm, shape, frames)| Case::new(name, spec, field_mm, shape, frames))
}

/// A gyroid of 2 × 2 × 2 cells, n voxels along the edges of the field.
fn gyroid_recipe(n: usize) -> Recipe {
    let spec = json!({"phantom": {"gyroid": {"size_mm": 4.0, "cells": 2, "wall_mm": 0.38}}});
    ("gyroid", spec, 6.4, [n, n, n], 3 * n / 4)
}

/// The gyroid of the six, in n voxels.
pub(crate) fn gyroid(n: usize) -> Result<Case, Error> {
    let (name, spec, field_mm, shape, frames) = gyroid_recipe(n);
    Case::new(name, spec, field_mm, shape, frames)
}

fn methods(step: f64, largest: f64) -> Vec<Method> {
    let ospw = || ("ospw", json!({}));
    let mut methods = vec![
        Method::new("lbfgs", ("lbfgs", json!({})), ospw()),
        Method::new("gradient, automatic", ("gradient", json!({})), ospw()),
        Method::new(
            "gradient, 1/L, momentum 0.9",
            ("gradient", json!({"step": step, "momentum": 0.9})),
            ospw(),
        ),
        Method::new("fista", ("fista", json!({})), ospw()),
    ];
    let adam = json!({"step": ADAM * largest});
    methods.push(Method::new("adam", ("adam", adam), ospw()));
    methods.extend([
        Method::new("osmo", ("osmo", json!({})), ("osmo", json!({}))),
        Method::new(
            "cal",
            ("cal", json!({"sigmoid": 0.05})),
            ("osmo", json!({"d_h": 0.8, "d_l": 0.7})),
        ),
        Method::new(
            "pm",
            ("pm", json!({})),
            ("pm", json!({"d_h": 0.9, "d_l": 0.7})),
        ),
        Method::new(
            "bclp, 1/L",
            ("bclp", json!({ "step": step })),
            ("bclp", json!({"epsilon": 0.1, "q": 2})),
        ),
        Method::new(
            "bclp, alternate",
            ("bclp", json!({"step": step, "alternate": true})),
            ospw(),
        ),
    ]);
    methods
}

/// Adam's step as a share of the start's largest pixel.
const ADAM: f64 = 0.03;

/// Every optimizer on the targets of these names (none: all): tables, and every measurement into a file when one is given.
pub(crate) fn optimizers(
    mesh: Option<&Path>,
    names: &[&str],
    file: Option<&Path>,
) -> Result<(), Error> {
    let mut lines = String::new();
    for case in six(mesh, names) {
        let case = case?;
        println!("\n**{}**, {}\n", case.name, case.size());
        let at = |what: &str| COLUMNS.map(|c| format!("{what} {c}")).join(" | ");
        println!(
            "| method | {} | {} | {} | {} |",
            at("loss"),
            at("PW"),
            at("IoU"),
            at("s")
        );
        println!("|---{}|", "|---".repeat(4 * COLUMNS.len()));
        let step = case.longest_step()?;
        let largest = case.brightest()?;
        for method in methods(step, largest) {
            let marks = [4, 6, 10, 14, 20, 28, 40, 56, 70, 100, 140, 200, 280, 400];
            let track = Track {
                iterations: usize::MAX,
                calls: Some(COLUMNS[2]),
                marks: marks.to_vec(),
                ..Track::default()
            };
            let solved = case.solve(&method, Origin::Row("fbp"), f64::INFINITY, track)?;
            row(&method.name, &solved.samples);
            for s in &solved.samples {
                let q = &s.quality;
                let numbers = [s.seconds, q.loss, q.common.pw, q.iou].map(|v| format!("{v:.5e}"));
                let _ = writeln!(
                    lines,
                    "{};{};{};{}",
                    case.name,
                    method.name,
                    s.calls,
                    numbers.join(";")
                );
            }
        }
    }
    if let Some(file) = file {
        let saved = OpenOptions::new().create(true).append(true).open(file);
        saved
            .and_then(|mut saved| saved.write_all(lines.as_bytes()))
            .map_err(|e| Error::config("file", e.to_string(), "a file that can be written"))?;
    }
    Ok(())
}

/// Draws what [`optimizers`] put into a file.
pub(crate) fn draw(points: &Path, file: &Path) -> Result<(), Error> {
    let refuse = |e: std::io::Error| Error::config("file", e.to_string(), "a file");
    let mut panels: Vec<Panel> = Vec::new();
    for line in std::fs::read_to_string(points).map_err(refuse)?.lines() {
        let fields: Vec<&str> = line.split(';').collect();
        let [target, method, _, seconds, loss, ..] = fields[..] else {
            continue;
        };
        let number = |text: &str| text.parse().unwrap_or(f64::NAN);
        if panels.last().is_none_or(|panel| panel.title != target) {
            panels.push(Panel {
                title: target.to_owned(),
                curves: Vec::new(),
            });
        }
        let Some(panel) = panels.last_mut() else {
            continue;
        };
        if panel.curves.last().is_none_or(|curve| curve.name != method) {
            panel.curves.push(Curve {
                name: method.to_owned(),
                points: Vec::new(),
            });
        }
        if let Some(curve) = panel.curves.last_mut() {
            curve.points.push([number(seconds), number(loss)]);
        }
    }
    std::fs::write(file, picture(&panels)).map_err(refuse)
}

fn row(name: &str, samples: &[Sample]) {
    let at = |number: &dyn Fn(&Sample) -> String| {
        let found = COLUMNS.map(|c| {
            let sample = samples.iter().find(|s| s.calls >= c).or(samples.last());
            sample.map_or(String::new(), number)
        });
        found.join(" | ")
    };
    println!(
        "| {name} | {} | {} | {} | {} |",
        at(&|s| format!("{:.4}", s.quality.loss)),
        at(&|s| format!("{:.3}", s.quality.common.pw)),
        at(&|s| format!("{:.4}", s.quality.iou)),
        at(&|s| format!("{:.2}", s.seconds)),
    );
}

/// Every objective with the default optimizer, pixels bounded by the start as in a job, patterns of eight bits, judged on the
/// grid it was optimized on and on one of half the pitch.
pub(crate) fn objectives(mesh: Option<&Path>, names: &[&str], calls: u64) -> Result<(), Error> {
    let list: [(&str, &'static str, Value); 9] = [
        ("threshold (0.85, 0.95, 1)", "threshold", json!({})),
        (
            "threshold (0.70, 0.90, 1)",
            "threshold",
            json!({"lower": 0.7, "upper": 0.9}),
        ),
        ("OSPW(0) (0.70, 0.90)", "ospw", json!({})),
        (
            "OSPW(0) (0.85, 0.95)",
            "ospw",
            json!({"lower": 0.85, "upper": 0.95}),
        ),
        (
            "OSPW(0.1) (0.60, 0.90)",
            "ospw",
            json!({"lower": 0.6, "upper": 0.9, "w": 0.1}),
        ),
        ("OSP (0.70, 0.90)", "osp", json!({})),
        ("L2N (0.70, 0.90)", "l2n", json!({})),
        ("BCLP ε = 0.1", "bclp", json!({"epsilon": 0.1, "q": 2})),
        (
            "PM (0.7, 0.9), p = 2",
            "pm",
            json!({"d_h": 0.9, "d_l": 0.7, "p": 2.0}),
        ),
    ];
    for case in six(mesh, names) {
        let case = case?;
        let fine = case.finer()?;
        let largest = case.brightest()?;
        println!("\n**{}**, {}, {calls} calls\n", case.name, case.size());
        println!(
            "| objective | PW | IPDR | IoU | 8 bits: PW | IPDR | IoU | half the pitch: PW | IPDR | IoU |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|");
        for (name, kind, params) in &list {
            let method = Method::new(*name, ("lbfgs", json!({})), (kind, params.clone()));
            let track = Track {
                iterations: usize::MAX,
                calls: Some(calls),
                ..Track::default()
            };
            let solved = case.solve(&method, Origin::Row("fbp"), largest, track)?;
            let shown = in_levels(solved.patterns.clone());
            let qualities = [
                case.quality_of(solved.patterns)?,
                case.quality_of(shown.clone())?,
                fine.quality_of(shown)?,
            ];
            let numbers = qualities
                .map(|q| format!("{:.3} | {:.3} | {:.4}", q.common.pw, q.common.ipdr, q.iou));
            println!("| {name} | {} |", numbers.join(" | "));
        }
    }
    Ok(())
}

/// The patterns in 255 levels of their largest pixel.
fn in_levels(mut patterns: Vec<Patterns>) -> Vec<Patterns> {
    for light in &mut patterns {
        let largest = light.values.iter().copied().fold(0.0, f32::max);
        for value in &mut light.values {
            *value = (*value / largest * 255.0).round() / 255.0 * largest;
        }
    }
    patterns
}
