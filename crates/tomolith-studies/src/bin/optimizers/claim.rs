//! The claims of Pellizzon et al. (2025): OSPW(0) against OSMO on flat parts, four penalties on the gyroid.
//!
//! FISTA starts from zero and never restarts, as the Core Imaging Library runs it; OSMO has two calls each way a step.

use crate::case::{Case, Method, Origin, Sample, Solved, Track, Window};
use serde_json::json;
use tomolith::Error;

/// What a penalty is called, its row and its parameters.
fn fista(name: &str, objective: &'static str, params: serde_json::Value) -> Method {
    let optimizer = ("fista", json!({"restart": "none"}));
    Method::new(name, optimizer, (objective, params))
}

fn osmo((d_l, d_h): (f64, f64)) -> Method {
    let objective = ("osmo", json!({"d_l": d_l, "d_h": d_h}));
    Method::new(
        format!("OSMO ({d_l:.2}, {d_h:.2})"),
        ("osmo", json!({})),
        objective,
    )
}

/// OSPW(0) at its default thresholds against OSMO at its default pair and at the pair found best for the part.
pub(crate) fn flat(only: Option<&str>, which: Option<&str>) -> Result<(), Error> {
    let iterations = 1000;
    let is_meant = |method: &Method| which.is_none_or(|which| method.name.starts_with(which));
    let bodies = [
        (
            "disc",
            json!({"cylinder": {"size_mm": 3.2, "height_mm": 20.0}}),
            256,
            (0.84, 0.96),
        ),
        (
            "dog-bones",
            json!({"dog_bones": {"size_mm": 5.0, "height_mm": 20.0}}),
            256,
            (0.76, 0.88),
        ),
        (
            "chart",
            json!({"resolution_chart": {"size_mm": 4.4, "height_mm": 20.0}}),
            256,
            (0.60, 0.76),
        ),
    ];
    println!(
        "\n| part | method | when | calls | PW | IPDR | PW, mean 0.9 | IPDR, mean 0.9 | loss | largest |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for (name, phantom, n, best) in bodies {
        if only.is_some_and(|only| only != name) {
            continue;
        }
        let case = Case::new(name, json!({ "phantom": phantom }), 6.4, [1, n, n], 360)?;
        println!("| **{name}** | {} | | | | | | | | |", case.size());
        // 1000 steps of FISTA; the calls of 1000 steps of OSMO; its own end
        let track = Track {
            iterations: 3 * iterations,
            steps: vec![iterations, 2 * iterations],
            change: 1e-4,
            ..Track::default()
        };
        let penalty = fista("OSPW(0) (0.70, 0.90)", "ospw", json!({}));
        // OSMO needs half as many steps for the same calls
        let shorter = Track {
            iterations,
            steps: vec![iterations / 2, iterations],
            ..track.clone()
        };
        let runs = [
            (penalty, "zero", track),
            (osmo(best), "fbp", shorter.clone()),
            (osmo((0.85, 0.90)), "fbp", shorter),
        ];
        for (method, start, track) in runs {
            if is_meant(&method) {
                rows(
                    name,
                    &method,
                    &case.solve(&method, Origin::Row(start), f64::INFINITY, track)?,
                );
            }
        }
    }
    Ok(())
}

fn rows(part: &str, method: &Method, solved: &Solved) {
    let marked = solved
        .samples
        .iter()
        .map(|s| (format!("{} steps", s.iteration), s));
    let end = solved
        .converged
        .iter()
        .map(|s| (format!("eq. 28 with 1e-4, {} steps", s.iteration), s));
    for (when, sample) in marked.chain(end) {
        println!(
            "| {part} | {} | {when} | {} | {} |",
            method.name,
            sample.calls,
            numbers(sample)
        );
    }
}

fn numbers(sample: &Sample) -> String {
    let q = &sample.quality;
    format!(
        "{:.3} | {:.3} | {:.3} | {:.3} | {:.4} | {:.2}",
        q.own.pw, q.own.ipdr, q.common.pw, q.common.ipdr, q.loss, q.largest
    )
}

/// A gyroid of 2 × 2 × 2 cells, `edge` voxels wide, in the smallest field that holds it.
///
/// The wall repeats every cell and is the same seen from either end: a quarter of the slices, half a cell, has all of them.
fn gyroid(edge: usize, wall: f64, frames: usize) -> Result<Case, Error> {
    let (pitch, n) = (0.025, (1.4143 * edge as f64).ceil() as usize);
    let slices = edge.div_ceil(4);
    let size = edge as f64 * pitch;
    let spec = json!({
        "phantom": {"gyroid": {"size_mm": size, "cells": 2, "wall_mm": wall * size}},
        "offset_mm": [0.0, 0.0, -0.5 * slices as f64 * pitch],
    });
    Case::new("gyroid", spec, n as f64 * pitch, [slices, n, n], frames)
}

/// Four penalties, and OSMO, on the gyroid.
pub(crate) fn volume(
    edge: usize,
    wall: f64,
    frames: usize,
    iterations: usize,
    only: Option<&str>,
) -> Result<(), Error> {
    let case = gyroid(edge, wall, frames)?;
    println!(
        "\n**gyroid**, {edge} slices of which {} differ, wall {wall} of the edge: {}\n",
        edge.div_ceil(4),
        case.size()
    );
    println!(
        "| method | steps | PW | IPDR | PW, mean 0.9 | IPDR, mean 0.9 | loss | largest | mean | trimmed PW | trimmed IPDR | CPU s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|");
    let methods = [
        fista("OSPW(0)", "ospw", json!({})),
        osmo((0.85, 0.90)),
        fista("OSPW(0.1)", "ospw", json!({"w": 0.1})),
        fista("OSP", "osp", json!({})),
        fista("L2N", "l2n", json!({})),
    ];
    for method in methods {
        // OSP is not OSPW
        let stem = method.name.split([' ', '(']).next();
        if only.is_some_and(|only| ![Some(method.name.as_str()), stem].contains(&Some(only))) {
            continue;
        }
        let start = if method.optimizer == "osmo" {
            "fbp"
        } else {
            "zero"
        };
        let track = Track {
            iterations,
            steps: vec![iterations / 10, iterations / 3],
            change: 0.0,
            ..Track::default()
        };
        let solved = case.solve(&method, Origin::Row(start), f64::INFINITY, track)?;
        let Window { pw, ipdr } = case.trimmed(solved.patterns)?;
        for (i, sample) in solved.samples.iter().enumerate() {
            let trimmed = if i + 1 == solved.samples.len() {
                format!("{pw:.3} | {ipdr:.3}")
            } else {
                "| ".to_owned()
            };
            println!(
                "| {} | {} | {} | {:.3} | {trimmed} | {:.0} |",
                method.name,
                sample.iteration,
                numbers(sample),
                sample.quality.part_mean,
                sample.seconds
            );
        }
    }
    Ok(())
}
