//! Every optimiser on some targets, and OSPW(0) against OSMO: the tables of `docs/optimisers.md`.
//!
//! `cargo run --release -p tomolith --example optimisers -- [all | claim | coarse] [voxels along an edge] [iterations]`
//!
//! Doses of different methods have different scales (some are divided by their largest value), so every number is taken after
//! scaling the dose to a mean of 0.9 in the part; the loss is OSPW(0) at (0.7, 0.9) there.
#![expect(clippy::print_stdout, reason = "a bench prints its tables")]

use serde_json::{Value, json};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;
use tomolith::Error;
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
use tomolith::kind::Section;
use tomolith::metrics::scan::Scan;
use tomolith::models::parallel::Light;
use tomolith::models::planner::{self, Plan};
use tomolith::models::{Choice, DoseModel, Run};
use tomolith::objective::{OBJECTIVES, Objective, ObjectiveInput};
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;
use tomolith::optimize::start::given::Given;
use tomolith::optimize::start::{STARTS, Start, StartInput};
use tomolith::optimize::{Limits, OPTIMIZERS, Outcome, Problem, PublishedScale, Stop, run};
use tomolith::response::Identity;
use tomolith::target::{self, Target, TargetSpec, label, label_voxels};

/// Edge of the field, mm.
const FIELD: f64 = 6.4;
/// Mean dose of the part at which doses are compared.
const MEAN: f64 = 0.9;

/// A target with its model.
struct Case {
    name: &'static str,
    target: Target,
    labels: Volume<u8>,
    plan: Plan,
}

impl Case {
    fn new(name: &'static str, phantom: Value, shape: [usize; 3]) -> Result<Self, Error> {
        let spec: TargetSpec = Section::new("target", json!({ "phantom": phantom })).parse()?;
        let grid = VolumeGrid::centered(shape, FIELD / shape[1] as f64);
        let shape = target::build(&spec, Path::new("."), "target")?;
        let target = target::voxelise(shape.as_ref(), name, &grid)?;
        let labels = label_voxels(&target, |[x, y, _]| x.hypot(y) < FIELD / 2.0);
        let wanted = Volume {
            grid: grid.clone(),
            values: labels
                .values
                .iter()
                .map(|&l| u8::from(l == label::PART))
                .collect(),
        };
        let [rows, n, _] = grid.shape;
        let pixels = PatternGrid::full_turn(frames(n), 0.0, rows, n, grid.pitch_mm);
        let light = Light::new(pixels, Resin::pure_radon(1.4849));
        let vial = IndexMatched {
            radius_mm: 0.75 * FIELD,
        };
        let plan = planner::plan(
            &Choice::default(),
            &vial,
            vec![light],
            grid,
            Some(&wanted),
            &Run::new(),
        )?;
        Ok(Case {
            name,
            target,
            labels,
            plan,
        })
    }

    fn model(&self) -> &dyn DoseModel<Field = HostField> {
        self.plan.model.as_ref()
    }

    fn objective(&self, name: &str, json: Value) -> Result<Box<dyn Objective<HostField>>, Error> {
        let input = ObjectiveInput {
            layout: &self.model().outputs()[0],
            labels: &self.labels,
            target: &self.target,
            response: Arc::new(Identity),
        };
        let (row, section) = Section::new("objective", json!({ name: json })).kind(OBJECTIVES)?;
        (row.build)(&section, &input)
    }

    fn input<'a>(&'a self, limits: &'a [Limits]) -> StartInput<'a> {
        StartInput {
            model: self.model(),
            target: &self.target,
            labels: &self.labels,
            response: &Identity,
            limits,
        }
    }

    fn start(&self, name: &str, limits: &[Limits]) -> Result<HostField, Error> {
        let (row, section) = Section::new("start", json!(name)).kind(STARTS)?;
        (row.build)(&section)?.patterns(&self.input(limits), &Run::new())
    }

    /// Solves, and measures at the common scale.
    fn solve(&self, method: &Method, start: Origin) -> Result<Solved, Error> {
        let limits = [Limits::default()];
        let input = self.input(&limits);
        let run_flag = Run::new();
        let mut x = match start {
            Origin::Row(name) => self.start(name, &limits)?,
            Origin::Given(given) => given.patterns(&input, &run_flag)?,
        };
        let objective = self.objective(method.objective.0, method.objective.1.clone())?;
        let (row, section) = Section::new("optimizer", json!({ method.optimizer: method.params }))
            .kind(OPTIMIZERS)?;
        let mut optimizer = (row.build)(&section)?;
        let mut problem = Problem::new(self.model(), objective.as_ref(), &limits, &run_flag)?
            .with_target(input.target_field()?);
        let stop = Stop {
            iterations: method.iterations,
            change: method.change,
            ..Stop::default()
        };
        let begin = Instant::now();
        let outcome = run(
            &mut problem,
            optimizer.as_mut(),
            &mut x,
            &stop,
            None,
            &mut [],
        )?;
        let seconds = begin.elapsed().as_secs_f64();
        let mut dose = self.model().new_dose()?;
        self.model().dose(&x, &mut dose, &run_flag)?;
        let quality = self.measure(&mut dose)?;
        let patterns = self
            .model()
            .patterns()
            .iter()
            .map(|light| light.patterns_of(x.as_slice()))
            .collect();
        Ok(Solved {
            outcome,
            seconds,
            quality,
            patterns,
        })
    }

    #[expect(clippy::cast_possible_truncation, reason = "doses are f32")]
    fn measure(&self, dose: &mut HostField) -> Result<Quality, Error> {
        let labels = self.model().outputs()[0].field_of(&self.labels);
        let scale = PublishedScale::of(dose.as_slice(), &labels)
            .ok_or_else(|| Error::config("dose", "no dose in the part", "some"))?;
        dose.scale(scale.at_mean(1.0, MEAN) as f32);
        let loss = self.objective("ospw", json!({}))?.value(dose);
        let scan = Scan::new(&labels, dose.as_slice())?;
        let (part, void) = scan
            .part()
            .zip(scan.void())
            .ok_or_else(|| Error::config("target", "no part or no void", "both"))?;
        Ok(Quality {
            loss,
            pw: f64::from(part.min) - f64::from(void.max),
            ipdr: f64::from(part.max) - f64::from(part.min),
            iou: scan.best_plateau().map_or(0.0, |p| p.iou),
            largest: scale.at_mean(scale.largest, MEAN),
        })
    }
}

/// Where a run begins.
#[derive(Clone, Copy)]
enum Origin<'a> {
    Row(&'static str),
    Given(&'a Given),
}

/// What is run, with its own objective.
struct Method {
    name: String,
    optimizer: &'static str,
    params: Value,
    objective: (&'static str, Value),
    iterations: usize,
    change: f64,
}

struct Solved {
    outcome: Outcome,
    seconds: f64,
    quality: Quality,
    patterns: Vec<Patterns>,
}

/// Numbers at a mean part dose of 0.9.
struct Quality {
    loss: f64,
    pw: f64,
    ipdr: f64,
    iou: f64,
    largest: f64,
}

/// Frames for n columns: enough for the finest detail of the part.
fn frames(n: usize) -> usize {
    (3 * n / 2).next_multiple_of(4)
}

fn cases(n: usize) -> Result<Vec<Case>, Error> {
    Ok(vec![
        Case::new(
            "disc",
            json!({"cylinder": {"size_mm": 3.2, "height_mm": 20.0}}),
            [1, n, n],
        )?,
        Case::new(
            "gear",
            json!({"gear": {"size_mm": 5.0, "height_mm": 20.0, "teeth": 12, "bore_mm": 1.6}}),
            [1, n, n],
        )?,
    ])
}

fn gyroid(n: usize) -> Result<Case, Error> {
    let phantom = json!({"gyroid": {"size_mm": 4.0, "cells": 2, "wall_mm": 0.38}});
    Case::new("gyroid", phantom, [n, n, n])
}

fn methods(iterations: usize, step: f64, largest: f64) -> Vec<Method> {
    let ospw = || ("ospw", json!({}));
    let method = |name: &str, optimizer, params, objective| Method {
        name: name.to_owned(),
        optimizer,
        params,
        objective,
        iterations,
        change: 0.0,
    };
    vec![
        method("lbfgs", "lbfgs", json!({}), ospw()),
        method("gradient, automatic", "gradient", json!({}), ospw()),
        method("gradient, 1/L", "gradient", json!({"step": step}), ospw()),
        method(
            "gradient, 1/L, momentum 0.9",
            "gradient",
            json!({"step": 4.0 * step, "momentum": 0.9}),
            ospw(),
        ),
        method("fista", "fista", json!({}), ospw()),
        method(
            "fista, no restart",
            "fista",
            json!({"restart": "none"}),
            ospw(),
        ),
        method("adam", "adam", json!({"step": ADAM * largest}), ospw()),
        method("osmo", "osmo", json!({}), ("osmo", json!({}))),
        method(
            "cal",
            "cal",
            json!({"sigmoid": 0.05}),
            ("osmo", json!({"d_h": 0.8, "d_l": 0.7})),
        ),
        method(
            "pm",
            "pm",
            json!({}),
            ("pm", json!({"d_h": 0.9, "d_l": 0.7})),
        ),
        method(
            "bclp, 1/L",
            "bclp",
            json!({"step": step}),
            ("bclp", json!({"epsilon": 0.1, "q": 2})),
        ),
        method(
            "bclp, alternate",
            "bclp",
            json!({"step": step, "alternate": true}),
            ospw(),
        ),
    ]
}

/// Adam's step as a share of the start's largest pixel.
const ADAM: f64 = 0.03;

/// 1/L for squared bands: 2·‖F‖² by power iteration.
fn longest_step(case: &Case) -> Result<f64, Error> {
    let (run, model) = (Run::new(), case.model());
    let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
    x.fill(1.0);
    let mut square = 0.0;
    for _ in 0..10 {
        let norm = x.norm();
        #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
        x.scale((1.0 / norm) as f32);
        model.dose(&x, &mut dose, &run)?;
        let mut next = x.zeros_like();
        model.pullback(&x, &dose, &mut next, &run)?;
        square = next.norm();
        x = next;
    }
    Ok(0.5 / square)
}

fn all(n: usize, iterations: usize) -> Result<(), Error> {
    let mut list = cases(n)?;
    list.push(gyroid(n)?);
    for case in &list {
        println!(
            "\n**{}**, {:?} voxels, {} frames, {iterations} iterations\n",
            case.name,
            case.labels.grid.shape,
            frames(n)
        );
        println!("| method | loss | PW | IPDR | IoU | largest | calls | seconds |");
        println!("|---|---|---|---|---|---|---|---|");
        let step = longest_step(case)?;
        let largest = f64::from(case.start("fbp", &[Limits::default()])?.max_abs());
        for method in methods(iterations, step, largest) {
            row(&method.name, case.solve(&method, Origin::Row("fbp")))?;
        }
    }
    Ok(())
}

fn row(name: &str, solved: Result<Solved, Error>) -> Result<(), Error> {
    match solved {
        Ok(solved) => {
            let (q, c) = (&solved.quality, solved.outcome.counters);
            println!(
                "| {name} | {:.4} | {:.3} | {:.3} | {:.4} | {:.2} | {} + {} | {:.2} |",
                q.loss, q.pw, q.ipdr, q.iou, q.largest, c.forward, c.adjoint, solved.seconds
            );
            Ok(())
        }
        Err(error @ Error::Unsupported { .. }) => {
            println!("| {name} | {error} |||||||");
            Ok(())
        }
        Err(error) => Err(error),
    }
}

/// OSPW(0) with FISTA at default thresholds against OSMO at the pairs that its rivals found best.
fn claim(n: usize, iterations: usize) -> Result<(), Error> {
    let pairs = [(0.85, 0.90), (0.84, 0.96), (0.76, 0.88), (0.60, 0.76)];
    let mut list = cases(n)?;
    list.push(Case::new(
        "siemens_star",
        json!({"siemens_star": {"size_mm": 5.0, "height_mm": 20.0, "spokes": 10, "hub_mm": 0.8}}),
        [1, n, n],
    )?);
    for case in &list {
        println!("\n**{}**, {n}² voxels, {} frames\n", case.name, frames(n));
        println!("| method | loss | PW | IPDR | IoU | largest | calls | seconds |");
        println!("|---|---|---|---|---|---|---|---|");
        let fista = |iterations, change| Method {
            name: String::new(),
            optimizer: "fista",
            params: json!({"restart": "none"}),
            objective: ("ospw", json!({})),
            iterations,
            change,
        };
        let osmo = |(d_l, d_h): (f64, f64), iterations, change| Method {
            name: String::new(),
            optimizer: "osmo",
            params: json!({}),
            objective: ("osmo", json!({"d_l": d_l, "d_h": d_h})),
            iterations,
            change,
        };
        // As published, at equal model calls (a step of OSMO has two each way), and at convergence
        row(
            &format!("OSPW(0) (0.70, 0.90), {iterations} steps"),
            case.solve(&fista(iterations, 0.0), Origin::Row("zero")),
        )?;
        row(
            &format!("OSPW(0) (0.70, 0.90), {} steps", 2 * iterations),
            case.solve(&fista(2 * iterations, 0.0), Origin::Row("zero")),
        )?;
        row(
            "OSPW(0) (0.70, 0.90), to Eq. 28 with 1e-4",
            case.solve(&fista(20 * iterations, 1e-4), Origin::Row("zero")),
        )?;
        for pair in pairs {
            row(
                &format!("OSMO {pair:?}, {iterations} steps"),
                case.solve(&osmo(pair, iterations, 0.0), Origin::Row("fbp")),
            )?;
            row(
                &format!("OSMO {pair:?}, to Eq. 28 with 1e-4"),
                case.solve(&osmo(pair, 3 * iterations, 1e-4), Origin::Row("fbp")),
            )?;
        }
    }
    Ok(())
}

/// Seconds to a loss, from the job's start and from coarser levels.
fn coarse(n: usize, iterations: usize) -> Result<(), Error> {
    let levels = [gyroid(n / 4)?, gyroid(n / 2)?, gyroid(n)?];
    let method = |iterations| Method {
        name: String::new(),
        optimizer: "lbfgs",
        params: json!({}),
        objective: ("ospw", json!({})),
        iterations,
        change: 0.0,
    };
    let plain = levels[2].solve(&method(iterations), Origin::Row("fbp"))?;
    let begin = Instant::now();
    let first = levels[0].solve(&method(20), Origin::Row("fbp"))?;
    let first = Given(first.patterns);
    let second = levels[1].solve(&method(20), Origin::Given(&first))?;
    let second = Given(second.patterns);
    let before = begin.elapsed().as_secs_f64();
    let fine = levels[2].solve(&method(iterations), Origin::Given(&second))?;
    println!("\ngyroid {n}³; {before:.1} s on the coarser levels, 20 steps each\n");
    println!(
        "| loss of plain step | s | coarse-to-fine step at that loss | s, coarser levels included |"
    );
    println!("|---|---|---|---|");
    for row in plain.outcome.history.iter().step_by(5) {
        let reached = fine.outcome.history.iter().find(|r| r.loss <= row.loss);
        let (step, seconds) = reached.map_or(("–".to_owned(), "–".to_owned()), |r| {
            (
                r.iteration.to_string(),
                format!("{:.1}", before + r.seconds),
            )
        });
        println!(
            "| {:.4} at {} | {:.1} | {step} | {seconds} |",
            row.loss, row.iteration, row.seconds
        );
    }
    Ok(())
}

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize, default| {
        arguments
            .get(i)
            .and_then(|a| a.parse::<usize>().ok())
            .unwrap_or(default)
    };
    println!("{} threads", rayon::current_num_threads());
    match arguments.first().map(String::as_str) {
        Some("claim") => claim(number(1, 128), number(2, 1000)),
        Some("coarse") => coarse(number(1, 128), number(2, 40)),
        _ => all(number(1, 64), number(2, 60)),
    }
}
