//! The gray flower of Li et al. (2024), section 3.4.2, with their settings, and what their text leaves open varied one by
//! one: the tables of `docs/papers/bclp.md`.
//!
//! `flower [IMAGE | phantom] [voxels along an edge] [EPSILON | all] [ROW]`, with the last two only the runs at that ε, and whose
//! name contains ROW. What they published stands beside jobs in `papers/bclp`.
//!
//! IMAGE is a square gray picture whose inscribed circle holds the flower; `phantom` is Tomolith's own stand-in. Every row is
//! one run: BCLP with p = 2, q = 1, w = 1, their raw step until their stop rule (eq. 28), starting from their filtered
//! back-projection. Losses are sums over voxels, as theirs. One voxel is one millimeter and light is a plain sum of line
//! integrals, so that a step η of theirs, given for an absorption of 0.001 per voxel-length unit, is η·10⁻⁶ here: 10⁻⁵.
#![expect(clippy::print_stdout, reason = "a bench prints its tables")]

use rayon::prelude::*;
use serde_json::{Value, json};
use std::f64::consts::{PI, SQRT_2};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;
use tomolith::Error;
use tomolith::field::HostField;
use tomolith::grid::{PatternGrid, Volume, VolumeGrid};
use tomolith::io::csr::Csr;
use tomolith::kind::Section;
use tomolith::models::matrix::MatrixModel;
use tomolith::models::parallel::{Kernel, Parallel};
use tomolith::models::{DoseModel, Work};
use tomolith::objective::{OBJECTIVES, ObjectiveInput};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;
use tomolith::optimize::start::{STARTS, StartInput};
use tomolith::optimize::{Limits, OPTIMIZERS, Outcome, Problem, Row, Stop, StopReason, run};
use tomolith::response::{Identity, Logistic, Response, logistic};
use tomolith::target::{self, Target, TargetSpec, label, label_voxels};

/// Half widths ε and the published losses.
const PUBLISHED: [(f64, f64); 3] = [(0.1, 0.879), (0.05, 6.20), (0.0, 18.9)];
/// Their B.
const STEEPNESS: f64 = 10.0;
/// Steps after which a run ends that their rule does not stop.
const PATIENCE: usize = 30_000;

/// What M is.
#[derive(Clone, Copy, PartialEq)]
enum Material {
    Logistic,
    /// The logistic between doses 0 and 1, and beyond them its value and its slope there: their tabulated one.
    Clamped,
    Identity,
}

/// How light is followed.
#[derive(Clone, Copy, PartialEq)]
enum Operator {
    /// By [`Parallel`] with one of its kernels.
    Kernel(Kernel),
    /// By the stored matrix of a ray tracer as theirs: one ray for each pixel, a deposit every half voxel, shared among the
    /// four voxels around it.
    Traced,
}

#[derive(Clone)]
struct Setting {
    epsilon: f64,
    material: Material,
    operator: Operator,
    voxels: usize,
    frames: usize,
    /// Degrees over which the frames are spread.
    arc: f64,
    /// Distance of the columns in voxels.
    columns: f64,
    start: Value,
    /// Factor on the patterns of the start.
    brightness: f32,
    optimizer: (&'static str, Value),
    iterations: usize,
    change: f64,
    /// Gray values of the picture → gray values of the target.
    gray: fn(f32) -> f32,
    /// How far the picture is sharpened: this times its difference from the mean with its neighbors is added.
    detail: f32,
}

impl Setting {
    /// What the article states, and where it states nothing, the first of what is varied below.
    fn published(voxels: usize) -> Self {
        Setting {
            epsilon: 0.05,
            material: Material::Clamped,
            operator: Operator::Kernel(Kernel::DistanceDriven),
            voxels,
            frames: 360,
            arc: 360.0,
            columns: 1.0,
            start: json!({"fbp": {"scale": "analytic"}}),
            brightness: 1.0,
            optimizer: ("bclp", json!({"step": STEP})),
            iterations: PATIENCE,
            change: 0.001,
            gray: |value| value,
            detail: 0.0,
        }
    }
}

/// Their η = 10 in units of line integrals.
const STEP: f64 = 1e-5;

/// A response between doses 0 and 1 only; see [`Material::Clamped`].
#[derive(Debug)]
struct Clamped(Logistic);

impl Response for Clamped {
    fn value(&self, dose: f32) -> f32 {
        self.0.value(dose.clamp(0.0, 1.0))
    }
    fn value_and_slope(&self, dose: f32) -> (f32, f32) {
        self.0.value_and_slope(dose.clamp(0.0, 1.0))
    }
    fn inverse(&self, response: f32) -> f32 {
        self.0.inverse(response).clamp(0.0, 1.0)
    }
}

/// What a run came to.
struct Solved {
    outcome: Outcome,
    seconds: f64,
    /// Share of the voxels in the circle that lie outside their band.
    violating: f64,
    /// Share of them with a dose above 1.
    beyond_one: f64,
}

fn response(setting: &Setting) -> Result<Arc<dyn Response>, Error> {
    let logistic = Logistic::new(logistic::Params {
        steepness: STEEPNESS,
        ..Default::default()
    })?;
    Ok(match setting.material {
        Material::Logistic => Arc::new(logistic),
        Material::Clamped => Arc::new(Clamped(logistic)),
        Material::Identity => Arc::new(Identity),
    })
}

/// The matrix of [`Operator::Traced`], from pixels to voxels of edge 1 on a square of `n`²; light deposits in the inscribed
/// circle only.
fn traced(n: usize, pixels: &PatternGrid) -> Csr {
    let half = (n as f64 - 1.0) / 2.0;
    let reach = n as f64 / 2.0;
    let of_pixel = |i: usize| -> Vec<(u32, f32)> {
        let (sin, cos) = pixels.azimuths[i / n].sin_cos();
        let across = (i % n) as f64 - half;
        let mut found = Vec::new();
        for step in 0..=4 * n {
            let along = 0.5 * step as f64 - reach;
            let place = [along * cos - across * sin, along * sin + across * cos];
            let [x, y] = place.map(|c| c + half);
            let shares = |c: f64| [(c.floor(), 1.0 - c.fract()), (c.floor() + 1.0, c.fract())];
            for (y, of_y) in shares(y) {
                for (x, of_x) in shares(x) {
                    if (x - half).hypot(y - half) <= half {
                        let voxel = y as usize * n + x as usize;
                        found.push((voxel as u32, (0.5 * of_x * of_y) as f32));
                    }
                }
            }
        }
        found.sort_unstable_by_key(|&(voxel, _)| voxel);
        found.dedup_by(|next, sum| {
            let same = next.0 == sum.0;
            if same {
                sum.1 += next.1;
            }
            same
        });
        found
    };
    let rows: Vec<Vec<(u32, f32)>> = (0..pixels.len()).into_par_iter().map(of_pixel).collect();
    let mut by_pixel = Csr {
        columns: n * n,
        starts: vec![0],
        ..Csr::default()
    };
    for row in rows {
        for (voxel, share) in row {
            by_pixel.indices.push(voxel);
            by_pixel.values.push(share);
        }
        by_pixel.starts.push(by_pixel.values.len());
    }
    by_pixel.transposed()
}

/// Adds `detail` times what the mean over 3 × 3 pixels, weighted 1, 2, 1, takes away; grays stay between 0 and 1.
fn sharpen(values: &mut [f32], n: usize, detail: f32) {
    let mean = |pixels: &[f32], i: usize, stride: usize, at: usize| {
        let before = if at == 0 { i } else { i - stride };
        let after = if at + 1 == n { i } else { i + stride };
        0.25 * (pixels[before] + 2.0 * pixels[i] + pixels[after])
    };
    let rows: Vec<f32> = (0..n * n).map(|i| mean(values, i, 1, i % n)).collect();
    let means: Vec<f32> = (0..n * n).map(|i| mean(&rows, i, n, i / n)).collect();
    for (value, mean) in values.iter_mut().zip(means) {
        *value = (*value + detail * (*value - mean)).clamp(0.0, 1.0);
    }
}

/// The picture on the voxels of the inscribed circle.
fn picture(image: &str, setting: &Setting, edge: f64) -> Result<(Target, Volume<u8>), Error> {
    let source = match image {
        "phantom" => json!({"phantom": {"flower": {"size_mm": edge, "height_mm": edge}}}),
        path => json!({"image": path, "size_mm": edge, "height_mm": edge}),
    };
    let spec: TargetSpec = Section::new("target", source).parse()?;
    let grid = VolumeGrid::centered(
        [1, setting.voxels, setting.voxels],
        edge / setting.voxels as f64,
    );
    let shape = target::build(&spec, Path::new("."), "target")?;
    let mut target = target::voxelize(shape.as_ref(), "flower", &grid)?;
    for value in &mut target.inside.values {
        *value = (setting.gray)(*value);
    }
    sharpen(&mut target.inside.values, setting.voxels, setting.detail);
    // Voxels whose centers lie in the circle through the centers of the outermost ones
    let radius = (edge - grid.pitch_mm) / 2.0;
    let labels = label_voxels(&target, |[x, y, _]| x.hypot(y) <= radius * (1.0 + 1e-12));
    Ok((target, labels))
}

fn solve(image: &str, setting: &Setting) -> Result<Solved, Error> {
    let edge = 512.0;
    let (target, labels) = picture(image, setting, edge)?;
    let grid = labels.grid.clone();
    let pixels = PatternGrid {
        azimuths: (0..setting.frames)
            .map(|k| setting.arc.to_radians() * k as f64 / setting.frames as f64)
            .collect(),
        frame_arc: 0.0,
        rows: 1,
        columns: setting.voxels,
        pitch_mm: [setting.columns * grid.pitch_mm, grid.pitch_mm],
        offset_mm: [0.0; 2],
    };
    let model: Box<dyn DoseModel<Field = HostField>> = match setting.operator {
        Operator::Traced => Box::new(MatrixModel::new(
            &traced(setting.voxels, &pixels),
            vec![pixels],
            grid,
        )?),
        Operator::Kernel(kernel) => {
            let light = Light::new(pixels, Resin::pure_radon(1.5));
            // Beyond the corners: rows that no wall cuts are quick, and light that nothing absorbs does not care
            let vial = IndexMatched { radius_mm: edge };
            Box::new(Parallel::under(
                &vial,
                vec![light],
                kernel,
                grid,
                &Work::new(),
            )?)
        }
    };
    let model = model.as_ref();
    let response = response(setting)?;
    let limits = [Limits::default()];
    let input = StartInput {
        model,
        target: &target,
        labels: &labels,
        response: response.as_ref(),
        limits: &limits,
        absorption: None,
    };
    let flag = Work::new();
    let start = Section::new("start", setting.start.clone()).read(STARTS)?;
    let mut x = start.patterns(&input, &flag)?;
    for value in x.as_mut_slice() {
        *value *= setting.brightness;
    }
    let layout = &model.outputs()[0];
    let objective_input = ObjectiveInput {
        layout,
        labels: &labels,
        target: &target,
        response: response.clone(),
    };
    let bclp = json!({"bclp": {"epsilon": setting.epsilon, "p": 2.0, "q": 1.0}});
    let objective = Section::new("objective", bclp).read(OBJECTIVES)?;
    let objective = objective.make(&objective_input)?;
    let (name, params) = &setting.optimizer;
    let method = Section::new("optimizer", json!({ *name: params })).read(OPTIMIZERS)?;
    let mut optimizer = method.make()?;
    let mut problem = Problem::new(model, objective.as_ref(), &limits, &flag)?;
    let stop = Stop {
        iterations: setting.iterations,
        change: setting.change,
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
    let mut dose = model.new_dose()?;
    model.dose(&x, &mut dose, &flag)?;
    let dose = layout.volume_of(dose.as_slice());
    Ok(count(
        &dose,
        &target,
        &labels,
        response.as_ref(),
        setting.epsilon,
        outcome,
        seconds,
    ))
}

fn count(
    dose: &Volume<f32>,
    target: &Target,
    labels: &Volume<u8>,
    response: &dyn Response,
    epsilon: f64,
    outcome: Outcome,
    seconds: f64,
) -> Solved {
    let (mut counted, mut violating, mut beyond) = (0usize, 0usize, 0usize);
    let voxels = dose
        .values
        .iter()
        .zip(&target.inside.values)
        .zip(&labels.values);
    for ((&dose, &wanted), _) in voxels.filter(|(_, label)| **label != label::OUTSIDE) {
        let error = (f64::from(response.value(dose)) - f64::from(wanted)).abs();
        counted += 1;
        violating += usize::from(error > epsilon + 1e-6);
        beyond += usize::from(dose > 1.0);
    }
    Solved {
        outcome,
        seconds,
        violating: violating as f64 / counted as f64,
        beyond_one: beyond as f64 / counted as f64,
    }
}

fn head() {
    println!(
        "| run | ε | loss at the start | after 10 steps | loss | steps | ended by | outside the band, % | dose above 1, % | s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
}

/// What is run: on which image, at which ε, and which rows.
struct Wanted<'a> {
    image: &'a str,
    epsilon: Option<&'a String>,
    row: Option<&'a String>,
}

impl Wanted<'_> {
    fn holds(&self, name: &str, epsilon: f64) -> bool {
        let at = |wanted: &String| wanted == "all" || wanted.parse() == Ok(epsilon);
        self.epsilon.is_none_or(at) && self.row.is_none_or(|part| name.contains(part.as_str()))
    }
}

fn row(wanted: &Wanted<'_>, name: &str, setting: &Setting) -> Result<(), Error> {
    if !wanted.holds(name, setting.epsilon) {
        return Ok(());
    }
    let solved = solve(wanted.image, setting)?;
    let history = &solved.outcome.history;
    let at = |k: usize| history[k.min(history.len() - 1)].loss;
    passing(history, setting);
    let why = match solved.outcome.reason {
        StopReason::ZeroLoss => "loss 0",
        StopReason::Steady => "eq. 28",
        StopReason::Iterations => "limit",
        _ => "no progress",
    };
    println!(
        "| {name} | {} | {:.3} | {:.3} | {:.4e} | {} | {why} | {:.1} | {:.1} | {:.0} |",
        setting.epsilon,
        at(0),
        at(10),
        solved.outcome.loss,
        history.len() - 1,
        100.0 * solved.violating,
        100.0 * solved.beyond_one,
        solved.seconds
    );
    Ok(())
}

/// Where on the way the published loss is passed, and what eq. 28 compares with 0.1 % there.
fn passing(history: &[Row], setting: &Setting) {
    let Some((_, published)) = PUBLISHED.iter().find(|(e, _)| *e == setting.epsilon) else {
        return;
    };
    let Some(k) = history.iter().position(|r| r.loss <= *published) else {
        return;
    };
    let changes = history[k.saturating_sub(5)..=k].windows(2);
    let mean: f64 = changes.map(|w| (w[1].loss - w[0].loss).abs()).sum::<f64>() / 5.0;
    println!(
        "| {published} is passed at step {k}, where the mean change of five steps is {:.3} % | {} ||||||||",
        100.0 * mean / history[k].loss,
        setting.epsilon
    );
}

/// One thing changed at a time: all at ε = 0.05, and what moves the loss there at the other ε, too.
fn varied(wanted: &Wanted<'_>, voxels: usize) -> Result<(), Error> {
    println!("\n**One change at a time**, B = {STEEPNESS}\n");
    head();
    for (epsilon, all) in [(0.05, true), (0.1, false), (0.0, false)] {
        let base = Setting {
            epsilon,
            ..Setting::published(voxels)
        };
        for (name, setting) in variations(&base) {
            if all || wanted.row.is_some() || MOVING.contains(&name) {
                row(wanted, name, &setting)?;
            }
        }
        corners(&base);
    }
    Ok(())
}

/// Changes that are also tried at the other ε.
const MOVING: [&str; 4] = ["kernel line", "kernel linear", "L-BFGS", "1500 steps"];

/// What their sum gains from the voxels outside of the circle, where dose and target are 0.
fn corners(base: &Setting) {
    let inside = PI / 4.0 * (base.voxels as f64 - 1.0).powi(2);
    let count = (base.voxels as f64).powi(2) - inside;
    let response = 1.0 / (1.0 + (STEEPNESS / 2.0).exp());
    let sum = count * (response - base.epsilon).max(0.0).powi(2);
    println!(
        "| corners outside the circle add {sum:.2} to the square of the loss | {} ||||||||",
        base.epsilon
    );
}

fn variations(base: &Setting) -> Vec<(&'static str, Setting)> {
    let with = |change: &dyn Fn(&mut Setting)| {
        let mut setting = base.clone();
        change(&mut setting);
        setting
    };
    let step = |factor: f64| with(&|s| s.optimizer = ("bclp", json!({"step": factor * STEP})));
    let operator = |operator: Operator| with(&|s| s.operator = operator);
    let start = |start: Value| with(&|s| s.start = start.clone());
    let brightness = |factor: f32| with(&|s| s.brightness = factor);
    let detail = |more: f32| with(&|s| s.detail = more);
    let columns = |apart: f64| with(&|s| s.columns = apart);
    let gray = |map: fn(f32) -> f32| with(&|s| s.gray = map);
    vec![
        ("as published", base.clone()),
        ("kernel linear", operator(Operator::Kernel(Kernel::Linear))),
        ("kernel line", operator(Operator::Kernel(Kernel::Line))),
        ("kernel strip", operator(Operator::Kernel(Kernel::Strip))),
        ("traced in half voxels", operator(Operator::Traced)),
        ("step ÷ 10", step(0.1)),
        ("step × 0.5", step(0.5)),
        ("step × 0.7", step(0.7)),
        ("step × 2", step(2.0)),
        ("step × 10", step(10.0)),
        ("step × 100", step(100.0)),
        (
            "L-BFGS",
            with(&|s| {
                s.optimizer = ("lbfgs", json!({}));
                s.iterations = 300;
                s.change = 0.0;
            }),
        ),
        ("start × 0.5", brightness(0.5)),
        ("start × 0.75", brightness(0.75)),
        ("start × 1.25", brightness(1.25)),
        ("start × 1.4", brightness(1.4)),
        ("start × 1.5", brightness(1.5)),
        ("start × π/2", brightness(std::f32::consts::FRAC_PI_2)),
        ("start × 2", brightness(2.0)),
        ("start LSQR, 10", start(json!({"lsqr": {"iterations": 10}}))),
        (
            "start Shepp-Logan",
            start(json!({"fbp": {"scale": "analytic", "filter": "shepp_logan"}})),
        ),
        (
            "start cosine",
            start(json!({"fbp": {"scale": "analytic", "filter": "cosine"}})),
        ),
        (
            "start offset",
            start(json!({"fbp": {"scale": "fit", "negative": "offset"}})),
        ),
        ("start 0", start(json!("zero"))),
        ("start uniform", start(json!("uniform"))),
        (
            "start FBP, scale fitted",
            start(json!({"fbp": {"scale": "fit"}})),
        ),
        (
            "logistic beyond [0, 1], too",
            with(&|s| s.material = Material::Logistic),
        ),
        ("M = d", with(&|s| s.material = Material::Identity)),
        ("360 frames over 180°", with(&|s| s.arc = 180.0)),
        ("180 frames over 360°", with(&|s| s.frames = 180)),
        ("720 frames over 360°", with(&|s| s.frames = 720)),
        ("columns 1.02 voxels apart", columns(1.02)),
        ("columns 1.05 voxels apart", columns(1.05)),
        ("columns 1.1 voxels apart", columns(1.1)),
        ("columns √2 voxels apart", columns(SQRT_2)),
        ("350 frames over 360°", with(&|s| s.frames = 350)),
        ("half the voxels along an edge", with(&|s| s.voxels /= 2)),
        (
            "1500 steps",
            with(&|s| {
                s.iterations = 1500;
                s.change = 0.0;
            }),
        ),
        ("grays 0.1 to 0.9", gray(|v| 0.1 + 0.8 * v)),
        ("grays to the power 2.2", gray(|v| v.powf(2.2))),
        ("detail × 1.05", detail(0.05)),
        ("detail × 1.1", detail(0.1)),
        ("detail × 1.2", detail(0.2)),
        ("detail × 1.4", detail(0.4)),
    ]
}

pub(crate) fn study(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let argument = |n: usize, or: &str| arguments.get(n).cloned().unwrap_or_else(|| or.to_owned());
    let image = argument(0, "phantom");
    let voxels = argument(1, "512")
        .parse()
        .map_err(|_| Error::config("voxels", argument(1, ""), "a whole number"))?;
    let wanted = Wanted {
        image: &image,
        epsilon: arguments.get(2),
        row: arguments.get(3),
    };
    varied(&wanted, voxels)?;
    Ok(())
}
