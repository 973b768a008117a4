//! What a projector of few levels prints: rounded, diffused and optimised patterns, as docs/measured/levels.md has them.
//!
//! ```sh
//! cargo run --release -p tomolith --example levels -- gear 1,2,3
//! cargo run --release -p tomolith --example levels -- gyroid 1,2,3
//! cargo run --release -p tomolith --example levels -- boat.stl 1,2,3
//! ```
#![expect(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "an example prints its table and its use"
)]

use serde_json::{Value, json};
use std::path::Path;
use tomolith::Error;
use tomolith::exposure::quantise;
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
use tomolith::kind::Section;
use tomolith::metrics::evaluate;
use tomolith::metrics::print::Print;
use tomolith::models::parallel::Light;
use tomolith::models::planner::{self, Plan, Setup};
use tomolith::models::rays::Optics;
use tomolith::models::{Choice, DoseModel, PatternLayout, Run};
use tomolith::objective::{OBJECTIVES, Objective, ObjectiveInput};
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::{VIALS, Vial};
use tomolith::optimize::levels::improve;
use tomolith::optimize::start::{STARTS, StartInput};
use tomolith::optimize::{Limits, OPTIMIZERS, Problem, Stop, run};
use tomolith::response::Identity;
use tomolith::target::{
    self, Resolution, Shape, Target, TargetSpec, default_grid, label, label_columns,
};

/// A job: `examples/01-gear.toml`, `examples/02-gyroid.toml`, or a mesh of 6 mm in a glass vial.
struct Job {
    target: Value,
    pitch_mm: f64,
    resin: Resin,
    vial: Value,
    pixels: [usize; 2],
    angles: usize,
    objective: Value,
}

impl Job {
    fn of(name: &str) -> Self {
        let cylinder = |inner: f64, outer: f64, index: f64| json!({ "cylinder": { "inner_radius_mm": inner, "outer_radius_mm": outer, "refractive_index": index } });
        match name {
            "gear" => Job {
                target: json!({ "phantom": "gear", "size_mm": 6.0 }),
                pitch_mm: 0.056,
                resin: Resin::absorbing(1.4849, 0.054),
                vial: cylinder(7.6, 8.3, 1.58),
                pixels: [176, 64],
                angles: 180,
                objective: json!({ "threshold": {} }),
            },
            "gyroid" => Job {
                target: json!({ "phantom": "gyroid", "size_mm": 6.0 }),
                pitch_mm: 0.075,
                resin: Resin::absorbing(1.5, 0.1),
                vial: json!({ "index_matched": { "radius_mm": 6.0 } }),
                pixels: [160, 96],
                angles: 180,
                objective: json!({ "osmo": { "d_h": 0.9, "d_l": 0.85 } }),
            },
            mesh => Job {
                target: json!({ "mesh": mesh, "size_mm": 6.0 }),
                pitch_mm: 0.1,
                resin: Resin::absorbing(1.48, 0.1),
                vial: cylinder(5.0, 5.5, 1.52),
                pixels: [96, 64],
                angles: 120,
                objective: json!({ "threshold": { "surface": "fraction" } }),
            },
        }
    }

    fn light(&self, sub_angles: usize) -> Light {
        let [columns, rows] = self.pixels;
        let pixels = PatternGrid::full_turn(self.angles, 0.0, rows, columns, self.pitch_mm);
        Light {
            sub_angles,
            ..Light::new(pixels, self.resin)
        }
    }

    fn plan(
        &self,
        vial: &dyn Vial,
        sub_angles: usize,
        grid: &VolumeGrid,
        wanted: Option<&Volume<u8>>,
    ) -> Result<Plan, Error> {
        let setup = Setup {
            vial,
            optics: &[Optics::collimated(self.pitch_mm)],
            solid: None,
            asked_often: wanted.is_some(),
            dose_factor: 1.0,
            orders_off: None,
        };
        let light = vec![self.light(sub_angles)];
        planner::plan(
            &Choice::default(),
            setup,
            light,
            grid.clone(),
            wanted,
            &Run::new(),
        )
    }
}

/// The target on a grid, and which voxels are part and void.
fn voxels(shape: &dyn Shape, grid: &VolumeGrid) -> Result<(Target, Volume<u8>), Error> {
    let target = target::voxelise(shape, "part", grid)?;
    let labels = label_columns(&target, |_| true);
    Ok((target, labels))
}

/// Dose of patterns, in file order.
fn dose(
    model: &dyn DoseModel<Field = HostField>,
    patterns: &Patterns,
) -> Result<Volume<f32>, Error> {
    let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
    model.patterns()[0].fill_field(patterns, x.as_mut_slice());
    model.dose(&x, &mut dose, &Run::new())?;
    Ok(model.outputs()[0].volume_of(dose.as_slice()))
}

/// The levels of patterns that are cut at a full scale.
fn levels(patterns: &Patterns, full: f32, bits: u32) -> Result<Patterns, Error> {
    let mut cut = patterns.clone();
    cut.values.iter_mut().for_each(|v| *v = v.min(full));
    Ok(quantise(&cut, bits)?.patterns())
}

/// Carries the error of a pixel to the same pixel of the next frame; pixels that are no unknowns stay dark.
fn diffused(layout: &PatternLayout, patterns: &Patterns, full: f32, bits: u32) -> Patterns {
    let lit = layout.patterns_of(&vec![1.0; layout.range().end]);
    let top = ((1u32 << bits) - 1) as f32;
    let size = patterns.grid.rows * patterns.grid.columns;
    let mut carried = vec![0.0f32; size];
    let mut shown = patterns.clone();
    for (i, value) in shown.values.iter_mut().enumerate() {
        if lit.values[i] > 0.0 {
            let wanted = value.min(full) + carried[i % size];
            *value = (wanted / full * top).round().clamp(0.0, top) / top * full;
            carried[i % size] = (wanted - *value).clamp(-full, full);
        }
    }
    shown
}

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, bits] = arguments.as_slice() else {
        eprintln!("levels gear|gyroid|MESH 1,2,3");
        return Ok(());
    };
    let job = Job::of(name);
    let spec: TargetSpec = Section::new("target", job.target.clone()).parse()?;
    let shape = target::build(&spec, Path::new("."), "target")?;
    let grid = default_grid(shape.bounds_mm(), Resolution::Pitch(job.pitch_mm))?;
    let (row, section) = Section::new("vial", job.vial.clone()).kind(VIALS)?;
    let vial = (row.build)(&section)?;
    let (target, labels) = voxels(shape.as_ref(), &grid)?;
    let is_part = |&l: &u8| u8::from(l == label::PART);
    let wanted = Volume {
        grid: grid.clone(),
        values: labels.values.iter().map(is_part).collect(),
    };
    let plan = job.plan(vial.as_ref(), 1, &grid, Some(&wanted))?;
    let model = plan.model.as_ref();
    let layout = &model.patterns()[0];
    let input = ObjectiveInput {
        layout: &model.outputs()[0],
        labels: &labels,
        target: &target,
        response: std::sync::Arc::new(Identity),
    };
    let (row, section) = Section::new("objective", job.objective.clone()).kind(OBJECTIVES)?;
    let objective: Box<dyn Objective<HostField>> = (row.build)(&section, &input)?;
    let (row, section) = Section::new("start", json!("fbp")).kind(STARTS)?;
    let start = StartInput {
        model,
        target: &target,
        labels: &labels,
        response: &Identity,
        limits: &[Limits::default()],
    };
    let mut x = (row.build)(&section)?.patterns(&start, &Run::new())?;
    let limits = [Limits {
        max: f64::from(x.max_abs()),
        ..Limits::default()
    }];
    let flag = Run::new();
    let mut problem = Problem::new(model, objective.as_ref(), &limits, &flag)?;
    let (row, section) = Section::new("optimizer", json!("lbfgs")).kind(OPTIMIZERS)?;
    let stop = Stop::default();
    run(
        &mut problem,
        (row.build)(&section)?.as_mut(),
        &mut x,
        &stop,
        None,
        &mut [],
    )?;

    let finer = grid.refined(2);
    let (_, fine) = voxels(shape.as_ref(), &finer)?;
    let turning = job.plan(vial.as_ref(), 4, &finer, None)?;
    let judge = |name: &str, shown: &Patterns, more: String| -> Result<(), Error> {
        let dose = dose(turning.model.as_ref(), shown)?;
        let measures = evaluate(&Print::new(&fine, &dose)?).measures;
        let [iou, ver, pw] = ["iou", "ver", "pw"].map(|m| measures.get(m).unwrap_or(f64::NAN));
        println!("{name:>12} | {iou:.4} · {ver:.4} · {pw:+.3} {more}");
        Ok(())
    };
    let raw = layout.patterns_of(x.as_slice());
    judge("unrounded", &raw, String::new())?;
    let full = x.max_abs();
    for bits in bits.split(',').filter_map(|bits| bits.parse().ok()) {
        println!("{bits} bits");
        judge("rounded", &levels(&raw, full, bits)?, String::new())?;
        let mut best = (f64::INFINITY, 1.0, raw.clone());
        for scale in [1.0, 0.85, 0.7, 0.55, 0.45, 0.35, 0.25, 0.18] {
            let shown = diffused(layout, &raw, scale * full, bits);
            let (mut field, mut dose) = (model.new_patterns()?, model.new_dose()?);
            layout.fill_field(&shown, field.as_mut_slice());
            problem.dose(&field, &mut dose)?;
            let loss = objective.value(&dose);
            if loss < best.0 {
                best = (loss, scale, shown);
            }
        }
        judge("diffused", &best.2, format!("(scale {})", best.1))?;
        let mut shown = |asked: &HostField| {
            let levels = quantise(&layout.patterns_of(asked.as_slice()), bits)?;
            let mut shown = asked.zeros_like();
            layout.fill_field(&levels.patterns(), shown.as_mut_slice());
            Ok(shown)
        };
        let (asked, gain) = improve(&mut problem, &x, &mut shown)?;
        let shown = layout.patterns_of(shown(&asked)?.as_slice());
        judge("optimised", &shown, format!("({gain:?})"))?;
    }
    Ok(())
}
