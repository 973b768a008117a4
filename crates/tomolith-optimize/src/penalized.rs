//! A problem with penalties on its patterns: gradient, searches and optimizers see the whole of it.

use crate::{Limits, OPTIMIZERS, Problem, Stop};
use serde_json::json;
use std::sync::Arc;
use tomolith_core::check::small::SmallModel;
use tomolith_core::check::{self, noise};
use tomolith_core::dose::{DoseModel, Work};
use tomolith_core::field::{Field, HostField};
use tomolith_core::kind::Section;
use tomolith_core::near;
use tomolith_core::response::Identity;
use tomolith_objective::Objective;
use tomolith_objective::check::of_ring;
use tomolith_objective::penalty::{PENALTIES, Penalties};

const LIMITS: Limits = Limits { min: 0.0, max: 2.0 };

fn objective(model: &SmallModel) -> Box<dyn Objective<HostField>> {
    of_ring(model, "threshold", json!({}), Arc::new(Identity))
}

fn penalties(model: &SmallModel, sparsity: f64, smoothness: f64) -> Penalties<HostField> {
    let build = |name: &str, json| {
        let row = PENALTIES.iter().find(|row| row.name == name).unwrap();
        (row.build)(&Section::new("penalties[0]", json))
            .unwrap()
            .make(model.patterns())
            .unwrap()
    };
    let sparse = build("sparsity", json!({"exponent": 4.0}));
    let smooth = build("smoothness", json!({"angles": 1.0}));
    Penalties::new(vec![(sparsity, sparse), (smoothness, smooth)]).unwrap()
}

fn problem<'a>(
    model: &'a SmallModel,
    objective: &'a dyn Objective<HostField>,
    [sparsity, smoothness]: [f64; 2],
    work: &'a Work,
) -> Problem<'a, HostField> {
    let problem = Problem::new(model, objective, &[LIMITS], work).unwrap();
    problem.with_penalties(penalties(model, sparsity, smoothness))
}

fn patterns(model: &SmallModel) -> HostField {
    let mut x = check::noisy_patterns(model, 3);
    x.scale(0.4);
    x.shift(0.5);
    x
}

#[test]
fn loss_and_gradient_are_those_of_the_sum() {
    let model = SmallModel::new(18, 12, 5);
    let (objective, work) = (objective(&model), Work::new());
    let mut problem = problem(&model, &*objective, [0.3, 0.2], &work);
    let mut x = patterns(&model);
    let at = problem.evaluate_at(&mut x).unwrap();
    let alone = objective.value(&at.dose);
    let expected = alone + penalties(&model, 0.3, 0.2).value(&x);
    assert!(expected > 1.1 * alone && (at.loss - expected).abs() < 1e-9 * expected);
    let mut gradient = x.zeros_like();
    problem.gradient(&x, &at, &mut gradient).unwrap();
    let direction = HostField::from_slice(&noise(8, x.len()));
    let mut loss = |h: f32| {
        let mut moved = x.clone();
        moved.axpy(h, &direction);
        problem.evaluate_at(&mut moved).unwrap().loss
    };
    let difference = (loss(1e-2) - loss(-1e-2)) / 2e-2;
    let slope = gradient.dot(&direction);
    near!(difference, slope, 2e-3 * slope.abs().max(1.0));
}

#[test]
fn a_search_ends_where_the_whole_sum_is_lowest() {
    let model = SmallModel::new(18, 12, 5);
    let (objective, work) = (objective(&model), Work::new());
    let mut problem = problem(&model, &*objective, [30.0, 2.0], &work);
    let mut x = patterns(&model);
    let mut at = problem.evaluate_at(&mut x).unwrap();
    let mut gradient = x.zeros_like();
    problem.gradient(&x, &at, &mut gradient).unwrap();
    let mut step = x.zeros_like();
    let sums = step.project_step(&x, &gradient, 1.0, problem.bounds(&x));
    let (from, before) = (x.clone(), at.loss);
    let found = problem.search(&mut x, &step, sums.slope, &mut at).unwrap();
    assert!(
        found.alpha > 0.0 && found.alpha < 1.0 && at.loss < before,
        "{found:?}"
    );
    // What it says is what there is
    let mut again = x.clone();
    let placed = problem.evaluate_at(&mut again).unwrap();
    near!(placed.loss, at.loss, 1e-6 * at.loss);
    // No other place on the segment is much lower
    for alpha in (1..20).map(|i| i as f32 / 20.0) {
        let mut there = from.clone();
        there.axpy(alpha, &step);
        let loss = problem.evaluate_at(&mut there).unwrap().loss;
        assert!(
            loss > at.loss - 0.02 * (before - at.loss),
            "{alpha}: {loss} below {}",
            at.loss
        );
    }
}

#[test]
fn every_optimizer_pays_for_light_and_for_roughness() {
    let model = SmallModel::new(18, 12, 5);
    let objective = objective(&model);
    let parts = [penalties(&model, 1.0, 0.0), penalties(&model, 0.0, 1.0)];
    for row in OPTIMIZERS {
        let method = (row.build)(&check::example(row)).unwrap();
        let needs = method.make().unwrap().requirements();
        if needs.unpenalized.is_some() {
            let flag = Work::new();
            let problem = problem(&model, &*objective, [1.0, 0.0], &flag);
            let refused = needs.check(&problem).unwrap_err().to_string();
            assert!(refused.contains("penalties"), "{}: {refused}", row.name);
            continue;
        }
        let work = |sparsity: f64, smoothness: f64| {
            let flag = Work::new();
            let mut problem = problem(&model, &*objective, [sparsity, smoothness], &flag);
            let mut optimizer = method.make().unwrap();
            let mut x = patterns(&model);
            let stop = Stop::after(25);
            crate::run(&mut problem, &mut *optimizer, &mut x, &stop, None, &mut []).unwrap();
            parts.each_ref().map(|part| part.value(&x))
        };
        let [plain, sparse, smooth] =
            [[0.0, 0.0], [10.0, 0.0], [0.0, 10.0]].map(|[a, b]| work(a, b));
        let left = [sparse[0] / plain[0], smooth[1] / plain[1]];
        assert!(left[0] < 0.8, "{}: sparsity {left:?}", row.name);
        // The raw step of bclp's example is too long for the curvature that this smoothness adds
        if row.name != "bclp" {
            assert!(left[1] < 0.5, "{}: smoothness {left:?}", row.name);
        }
    }
}
