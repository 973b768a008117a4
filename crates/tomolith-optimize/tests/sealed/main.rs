//! A second kind of field, written outside the library against its public names: the same jobs, the same bits.
//!
//! A model of the host is wrapped, so that both kinds of field see the same matrix. Operations of a backend of its own are compared with the
//! host's in `crates/tomolith-gpu/tests`.

mod field;
mod model;

use field::SealedField;
use model::SealedModel;
use serde_json::{Value, json};
use std::path::Path;
use std::sync::Arc;
use tomolith_core::check::small::SmallModel;
use tomolith_core::check::{example, noise};
use tomolith_core::dose::{DoseModel, LinearOperator, PatternLayout, Run};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::{PatternGrid, Volume, VolumeGrid};
use tomolith_core::kind::{Kind, Section};
use tomolith_core::response::table::{Beyond, Table};
use tomolith_core::response::{Identity, Logistic, Response};
use tomolith_core::target::{Target, label_voxels};
use tomolith_models::parallel::Parallel;
use tomolith_objective::penalty::{Penalties, penalties};
use tomolith_objective::{Objective, ObjectiveInput, Sum, VoxelWeights, objectives};
use tomolith_optics::light::Light;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::index_matched::IndexMatched;
use tomolith_optimize::checkpoint::{self, Checkpoints};
use tomolith_optimize::start::starts;
use tomolith_optimize::{Limits, Outcome, Problem, StartInput, Stop, optimizers, run};

/// What is printed.
struct Part {
    target: Target,
    labels: Volume<u8>,
}

impl Part {
    fn ring(model: &SmallModel) -> Self {
        let (target, labels) = model.ring();
        Part { target, labels }
    }

    fn objective_input<'a, F: Field>(
        &'a self,
        model: &'a dyn DoseModel<Field = F>,
        response: Arc<dyn Response>,
    ) -> ObjectiveInput<'a> {
        ObjectiveInput {
            layout: &model.outputs()[0],
            labels: &self.labels,
            target: &self.target,
            response,
        }
    }
}

fn row<B>(rows: &'static [Kind<B>], name: &str) -> &'static Kind<B> {
    rows.iter().find(|row| row.name == name).unwrap()
}

/// A field of these values, where the model's are.
fn field<F: Field>(like: &F, values: &[f32]) -> F {
    let mut field = like.zeros_like();
    field.copy_from_host(values);
    field
}

fn bits(values: &[f32]) -> Vec<u32> {
    values.iter().map(|v| v.to_bits()).collect()
}

/// What a job says, the field apart.
struct Job<'a> {
    objective: (&'a str, Value),
    penalties: bool,
    start: &'a str,
    optimizer: (&'a str, Value),
    bits: Option<u32>,
    limits: Limits,
    steps: usize,
}

/// Patterns, dose and history of a job: start, objective, penalties, optimizer and loop, all made for the field F.
fn solve<F: Field>(
    model: &dyn DoseModel<Field = F>,
    part: &Part,
    job: &Job,
    checkpoints: Option<&mut Checkpoints>,
) -> (Vec<f32>, Outcome) {
    let (flag, limits) = (Run::new(), [job.limits]);
    let (name, json) = &job.objective;
    let input = part.objective_input(model, Arc::new(Identity));
    let section = Section::new("objective", json.clone());
    let objective = (row(objectives::<F>(), name).build)(&section)
        .unwrap()
        .make(&input)
        .unwrap();
    let of_patterns = penalties::<F>().iter().filter(|_| job.penalties);
    let of_patterns = of_patterns.map(|row| {
        let penalty = (row.build)(&example(row)).unwrap();
        let penalty = penalty.make(model.patterns()).unwrap();
        (0.3, penalty)
    });
    let of_patterns = Penalties::new(of_patterns.collect()).unwrap();
    let input = StartInput {
        model,
        target: &part.target,
        labels: &part.labels,
        response: &Identity,
        limits: &limits,
        absorption: None,
    };
    let start = row(starts::<F>(), job.start);
    let start = (start.build)(&Section::new("start", json!({}))).unwrap();
    let mut x = start.patterns(&input, &flag).unwrap();
    let mut problem = Problem::new(model, &*objective, &limits, &flag)
        .unwrap()
        .with_penalties(of_patterns)
        .with_bits(job.bits)
        .unwrap()
        .with_target(input.target_field().unwrap())
        .with_edges(input.edge_field().unwrap());
    let (name, json) = &job.optimizer;
    let section = Section::new("optimizer", json.clone());
    let mut optimizer = (row(optimizers::<F>(), name).build)(&section)
        .unwrap()
        .make()
        .unwrap();
    let stop = Stop {
        iterations: job.steps,
        ..Stop::default()
    };
    let outcome = run(
        &mut problem,
        &mut *optimizer,
        &mut x,
        &stop,
        checkpoints,
        &mut [],
    );
    (x.to_host(), outcome.unwrap())
}

/// Solves a job with either field and compares all bits; the outcome.
fn same<M: DoseModel<Field = HostField>>(what: &str, model: M, part: &Part, job: &Job) -> Outcome {
    let (x, host) = solve(&model, part, job, None);
    let (y, sealed) = solve(&SealedModel(model), part, job, None);
    let rows = |outcome: &Outcome| {
        let row = |r: &tomolith_optimize::Row| {
            let calls = (r.iteration, r.forward, r.adjoint);
            let norm = r.projected_gradient.map(f64::to_bits);
            (calls, r.loss.to_bits(), norm, r.step.map(f64::to_bits))
        };
        outcome.history.iter().map(row).collect::<Vec<_>>()
    };
    assert_eq!(rows(&host), rows(&sealed), "{what}: another history");
    assert_eq!(bits(&x), bits(&y), "{what}: other patterns");
    host
}

fn default_job<'a>() -> Job<'a> {
    Job {
        objective: ("threshold", json!({})),
        penalties: false,
        start: "fbp",
        optimizer: ("lbfgs", json!({})),
        bits: None,
        limits: Limits::default(),
        steps: 12,
    }
}

#[test]
fn a_job_on_the_parallel_model_has_the_same_bits() {
    let grid = VolumeGrid::centered([9, 24, 24], 0.1);
    let mut inside = Volume::filled(grid.clone(), 0.0f32);
    for (i, value) in inside.values.iter_mut().enumerate() {
        // A tube whose bore is off the axis, its surface in tenths
        let (x, y) = (grid.x(i % 24), grid.y(i / 24 % 24));
        let wall = (0.8 - x.hypot(y)).min((x - 0.2).hypot(y) - 0.25);
        *value = (0.5 + wall / 0.1).clamp(0.0, 1.0) as f32;
    }
    let target = Target {
        name: "tube".to_owned(),
        inside,
        gray: false,
    };
    let labels = label_voxels(&target, |[x, y, _]| x.hypot(y) < 1.1);
    let part = Part { target, labels };
    let pixels = PatternGrid::full_turn(40, 0.0, 9, 26, 0.1);
    let light = Light::new(pixels, Resin::pure_radon(1.5));
    let vial = IndexMatched { radius_mm: 3.0 };
    let model = Parallel::new(&vial, vec![light], grid).unwrap();
    let job = Job {
        steps: 20,
        ..default_job()
    };
    let outcome = same("parallel", model, &part, &job);
    // It did something
    let first = outcome.history[0].loss;
    assert!(outcome.loss < 0.3 * first, "{first} {}", outcome.loss);
}

#[test]
fn every_optimizer_has_the_same_bits() {
    for row in optimizers::<HostField>() {
        let section = example(row);
        let made = (row.build)(&section).unwrap().make().unwrap();
        let (needs, normalizes) = (made.requirements(), made.normalizes());
        for bits in [None, Some(5)] {
            if bits.is_some() && needs.continuous.is_some() {
                continue;
            }
            let model = SmallModel::new(18, 15, 5);
            let part = Part::ring(&model);
            let max = if normalizes { f64::INFINITY } else { 1.3 };
            let job = Job {
                penalties: needs.unpenalized.is_none() && row.name != "bclp",
                optimizer: (row.name, section.value.clone()),
                limits: Limits { min: 0.0, max },
                bits,
                ..default_job()
            };
            let outcome = same(row.name, model, &part, &job);
            assert!(outcome.history.len() > 5, "{}: {outcome:?}", row.name);
        }
    }
    // What the examples leave out
    for (name, json) in [
        ("osmo", json!({"edges": true})),
        ("bclp", json!({"step": 1.0, "alternate": true})),
        ("gradient", json!({"step": 0.5, "momentum": 0.5})),
    ] {
        let model = SmallModel::new(18, 15, 5);
        let part = Part::ring(&model);
        let job = Job {
            optimizer: (name, json),
            ..default_job()
        };
        same(name, model, &part, &job);
    }
}

#[test]
fn every_start_has_the_same_bits() {
    for row in starts::<HostField>() {
        if row.name == "patterns" {
            // Reads a file, and copies what it holds
            continue;
        }
        let model = SmallModel::new(18, 15, 5);
        let part = Part::ring(&model);
        let job = Job {
            start: row.name,
            limits: Limits { min: 0.1, max: 0.8 },
            steps: 0,
            ..default_job()
        };
        same(row.name, model, &part, &job);
    }
}

/// Value and gradient, slope along a step, and what ends a search: all that an objective gives.
fn asked<F: Field>(objective: &dyn Objective<F>, like: &F) -> (Vec<f64>, Vec<f32>) {
    let values: Vec<f32> = noise(5, like.len()).iter().map(|v| 0.6 + 0.8 * v).collect();
    let (mut dose, mut step) = (field(like, &values), field(like, &noise(9, like.len())));
    let mut gradient = like.zeros_like();
    let value = objective.value_and_gradient(&dose, &mut gradient);
    let (there, slope) = objective.slope_along(&dose, &step, 0.3);
    let plain = objective.value(&dose);
    let advanced = objective.advance(&mut dose, &mut step, 0.3);
    let fields = [gradient, dose, step].map(|field| field.to_host());
    (vec![value, there, slope, plain, advanced], fields.concat())
}

#[test]
fn every_objective_has_the_same_bits() {
    let model = SmallModel::new(18, 2, 21);
    let part = Part::ring(&model);
    let table = Table::new(&[0.0, 0.4, 0.7, 1.1], &[0.0, 0.2, 0.7, 1.0], Beyond::Linear);
    let responses: [Arc<dyn Response>; 3] = [
        Arc::new(Identity),
        Arc::new(table.unwrap()),
        Arc::new(Logistic::new(Default::default()).unwrap()),
    ];
    let len = model.layout().len();
    let voxel_weights = VoxelWeights {
        weight: noise(3, len).iter().map(|v| 1.0 + v).collect(),
        tolerance: noise(4, len).iter().map(|v| 0.05 * (1.0 + v)).collect(),
    };
    // A process window has no bands that could be wider
    let without_tolerance = VoxelWeights {
        weight: voxel_weights.weight.clone(),
        tolerance: Vec::new(),
    };
    let dose = LinearOperator::new_dose(&model).unwrap();
    let sealed = SealedField(dose.clone());
    for (i, row) in objectives::<HostField>().iter().enumerate() {
        for response in &responses {
            for (surface, is_emphasized) in [
                ("voxel", false),
                ("fraction", false),
                ("fraction", true),
                ("voxel", true),
            ] {
                let input = part.objective_input(&model, response.clone());
                let mut section = example(row);
                section.value["surface"] = surface.into();
                if row.name == "threshold" && surface == "fraction" {
                    section.value["exponent"] = 4.0.into();
                }
                let mut host = (row.build)(&section).unwrap().make(&input).unwrap();
                let mut other = (objectives::<SealedField>()[i].build)(&section)
                    .unwrap()
                    .make(&input)
                    .unwrap();
                if is_emphasized {
                    let emphasis = match row.name {
                        "process_window" => &without_tolerance,
                        _ => &voxel_weights,
                    };
                    host.set_voxel_weights(emphasis).unwrap();
                    other.set_voxel_weights(emphasis).unwrap();
                }
                let what = format!("{} {surface} {is_emphasized} {response:?}", row.name);
                let (a, b) = (asked(&*host, &dose), asked(&*other, &sealed));
                assert_eq!(a.0, b.0, "{what}");
                assert!(a.1 == b.1, "{what}: other gradients");
            }
        }
    }
}

/// A sum of objectives needs a field between, and its bits are those of the host, too.
#[test]
fn a_sum_of_objectives_has_the_same_bits() {
    fn sum<F: Field>(part: &Part, model: &SmallModel, like: &F) -> (Vec<f64>, Vec<f32>) {
        let input = part.objective_input(model, Arc::new(Identity));
        let part = |name: &str, weight: f64| {
            let section = Section::new("objective", json!({}));
            let objective = (row(objectives::<F>(), name).build)(&section)
                .unwrap()
                .make(&input)
                .unwrap();
            (weight, objective)
        };
        let parts = vec![part("threshold", 0.7), part("bclp", 0.2), part("l1", 0.1)];
        asked(&Sum::new(parts).unwrap(), like)
    }
    let model = SmallModel::new(18, 2, 21);
    let part = Part::ring(&model);
    let dose = LinearOperator::new_dose(&model).unwrap();
    let sealed = SealedField(dose.clone());
    let (a, b) = (sum(&part, &model, &dose), sum(&part, &model, &sealed));
    assert_eq!(a.0, b.0);
    assert!(a.1 == b.1);
}

#[test]
fn every_penalty_has_the_same_bits() {
    fn asked<F: Field>(
        section: &Section,
        kind: usize,
        lights: &[PatternLayout],
        like: &F,
    ) -> (Vec<f64>, Vec<f32>) {
        let penalty = (penalties::<F>()[kind].build)(section).unwrap();
        let penalty = penalty.make(lights).unwrap();
        let (x, step) = (
            field(like, &noise(3, like.len())),
            field(like, &noise(9, like.len())),
        );
        let mut gradient = field(like, &noise(11, like.len()));
        let value = penalty.add_gradient(&x, 2.0, &mut gradient);
        let (there, slope) = penalty.slope_along(&x, &step, 0.4);
        (
            vec![value, penalty.value(&x), there, slope],
            gradient.to_host(),
        )
    }
    let model = SmallModel::new(18, 15, 5);
    let x = LinearOperator::new_patterns(&model).unwrap();
    let sealed = SealedField(x.clone());
    let lights = DoseModel::patterns(&model);
    for (kind, json) in [
        (0, json!({"exponent": 0.5})),
        (0, json!({"exponent": 2.0})),
        (0, json!({})),
        (1, json!({"angles": 0.5})),
        (1, json!({"edge": 0.2})),
    ] {
        let section = Section::new("penalties[0]", json.clone());
        let a = asked(&section, kind, lights, &x);
        let b = asked(&section, kind, lights, &sealed);
        assert_eq!(a.0, b.0, "{json}");
        assert_eq!(bits(&a.1), bits(&b.1), "{json}");
    }
}

#[test]
fn a_run_that_is_cut_off_goes_on_from_its_checkpoint() {
    let model = SmallModel::new(18, 15, 5);
    let part = Part::ring(&model);
    let model = SealedModel(model);
    let job = |steps: usize| Job {
        steps,
        ..default_job()
    };
    let whole = solve(&model, &part, &job(12), None).0;
    let folder = tempfile::tempdir().unwrap();
    let parts = [7, 12].map(|steps| {
        let mut checkpoints = checkpoints(folder.path());
        solve(&model, &part, &job(steps), Some(&mut checkpoints)).0
    });
    assert_ne!(bits(&parts[0]), bits(&whole));
    assert_eq!(bits(&parts[1]), bits(&whole));
}

fn checkpoints(folder: &Path) -> Checkpoints {
    Checkpoints::new(folder, 42, &checkpoint::Params::default()).unwrap()
}

#[test]
fn a_sealed_model_passes_the_check_of_models() {
    tomolith_core::check::model::model(&SealedModel(SmallModel::new(9, 12, 3)), 1).unwrap();
}
