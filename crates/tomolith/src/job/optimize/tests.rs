use super::start::starting_patterns;
use super::watch::{idle, is_measured};
use crate::field::HostField;
use crate::io::npy::{PatternPair, write_patterns};
use crate::job::evaluate::{Origin, evaluate_patterns};
use crate::job::optimize::*;
use crate::job::tests::job_of;
use crate::models::{DoseModel, planner};
use crate::optimize::Row;
use crate::report::{CeilingPoint, CeilingQuality};

#[test]
fn a_run_that_stayed_at_its_start_says_so() {
    let history = |losses: &[f64]| -> Vec<Row> {
        let row = |(iteration, &loss): (usize, &f64)| Row {
            loss,
            ..Row::at(iteration)
        };
        losses.iter().enumerate().map(row).collect()
    };
    assert_eq!(idle(&history(&[2.0, 3.0, 1.9]), false, None), None);
    assert_eq!(idle(&history(&[2.0]), false, Some(4)), None);
    assert_eq!(idle(&history(&[0.0, 0.0]), false, None), None);
    let message = idle(&history(&[2.0, 2.0, 2.5]), false, Some(4)).unwrap();
    assert!(message.contains("bounds.bits = 4"), "{message}");
    // Row 0 of a method with a start and a scale of its own says nothing of its steps
    assert_eq!(idle(&history(&[2.0, 9.0, 9.5]), true, None), None);
    assert!(idle(&history(&[2.0, 9.0, 9.0]), true, None).is_some());
    assert_eq!(idle(&history(&[2.0]), true, None), None);
}

/// A job whose light spreads: its voxels, its models, and where it begins.
fn started(model: &str) -> (Voxels, planner::ModelPlan, HostField) {
    let text = format!(
        r#"
        target = {{ phantom = {{ sphere = {{}} }}, size_mm = 0.02 }}
        grid = {{ pitch_mm = 0.001 }}
        resin = {{ refractive_index = 1.5, pure_radon = true }}
        vial = {{ index_matched = {{ radius_mm = 0.02 }} }}
        light = [{{ wavelength_nm = 405, pixels = [36, 24], angles = 24,
            projector = {{ collimated = {{ pixel_pitch_mm = 0.001 }} }} }}]
        model = {model}
        objective = {{ threshold = {{ lower = 0.7, upper = 0.9 }} }}
        optimizer = {{ lbfgs = {{}} }}
        stop = {{ iterations = 1 }}
        "#
    );
    let job = job_of(&text, &[]);
    let resolved = ResolvedJob::under(&job, &Work::new()).unwrap();
    let mut voxels = resolved.voxels(&resolved.grid, &Work::new()).unwrap();
    let (asked, wanted) = (resolved.optics.model.as_ref(), voxels[0].wanted());
    let (optics, run) = (resolved.optimizing(), Work::new());
    let plan = planner::plan(asked, optics, &resolved.grid, Some(&wanted), &run).unwrap();
    let (model, straight) = (&plan.model as _, plan.surrogate.as_deref());
    let start = resolved.method.start.as_ref();
    let x = starting_patterns(&resolved, &voxels, model, straight, start, &run).unwrap();
    (voxels.remove(0), plan, x)
}

fn in_part(model: &dyn DoseModel<Field = HostField>, x: &HostField, voxels: &Voxels) -> Vec<f64> {
    let dose = crate::check::dose(model, x);
    let dose = model.outputs()[0].volume_of(dose.as_slice());
    let all = dose.values.iter().zip(&voxels.labels.values);
    let part = all.filter(|(_, label)| **label == crate::target::label::PART);
    part.map(|(dose, _)| f64::from(*dose)).collect()
}

/// Σd / Σd²: 1 where no other factor brings doses nearer to 1.
fn factor(doses: &[f64]) -> f64 {
    doses.iter().sum::<f64>() / doses.iter().map(|d| d * d).sum::<f64>()
}

#[test]
fn a_start_of_waves_brings_the_dose_that_is_wanted_whatever_the_pupil_takes() {
    for model in ["{ wave = {} }", "{ wave = { numerical_aperture = 0.02 } }"] {
        let (voxels, plan, x) = started(model);
        let found = factor(&in_part(&plan.model, &x, &voxels));
        assert!((found - 1.0).abs() < 1e-5, "{model}: {found}");
        let mut energies = x.clone();
        for value in energies.as_mut_slice() {
            *value *= *value;
        }
        let straight = plan.surrogate.as_deref().unwrap();
        let rays = factor(&in_part(straight, &energies, &voxels));
        let off = (rays - 1.0).abs();
        // What fades of the pixels' band is little; a narrow pupil takes more
        assert!(
            if model.contains("aperture") {
                off > 0.1
            } else {
                off < 0.1
            },
            "{rays}"
        );
    }
}

#[test]
fn a_start_of_light_that_spreads_is_that_of_straight_light_in_energies() {
    let (voxels, plan, x) = started("{ incoherent_cone = { half_angle_deg = 0.5 } }");
    let straight = plan.surrogate.as_deref().unwrap();
    let [spread, rays] = [&plan.model as _, straight].map(|m| factor(&in_part(m, &x, &voxels)));
    assert!((rays - 1.0).abs() < 1e-5, "{rays}");
    // Roots of energies would be off by several times
    assert!((spread - 1.0).abs() < 0.1, "{spread}");
}

#[test]
fn measured_iterations_thin_out_evenly() {
    let measured = |last: usize| (0..=last).filter(|&i| is_measured(i)).collect::<Vec<_>>();
    assert_eq!(
        measured(40),
        [
            0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40
        ]
    );
    assert!(measured(10).len() >= 10);
    assert_eq!(measured(1024).len(), 1 + 8 + 4 * 7);
}

/// A gear in a matched vial, its job and voxels.
fn gear(more: &str) -> (ResolvedJob, Vec<Voxels>) {
    gear_until("iterations = 20", more)
}

/// The same with an end of its own.
fn gear_until(stop: &str, more: &str) -> (ResolvedJob, Vec<Voxels>) {
    let text = format!(
        r#"
        target = {{ phantom = {{ gear = {{}} }}, size_mm = 2.0 }}
        grid = {{ pitch_mm = 0.05 }}
        resin = {{ refractive_index = 1.5, absorption_per_mm = 0.1 }}
        vial = {{ index_matched = {{ radius_mm = 2.0 }} }}
        light = [{{ pixels = [48, 24], angles = 48, projector = {{ collimated = {{ pixel_pitch_mm = 0.05 }} }} }}]
        stop = {{ {stop} }}
        {more}
        "#
    );
    let resolved = ResolvedJob::under(&job_of(&text, &[]), &Work::new()).unwrap();
    let voxels = resolved.voxels(&resolved.grid, &Work::new()).unwrap();
    (resolved, voxels)
}

/// What an optimization below a share of the brightest pixel of the start comes to, and the share that it is raised to.
fn raised_from(share: f64) -> (usize, f64, f64) {
    let (resolved, voxels) = gear("");
    let (run, silent) = (Work::new(), &mut crate::job::progress::Silent);
    let mut found = ceiling::find(&resolved, &voxels, &run).unwrap().unwrap();
    // As a checkpoint holds it, also where a print had no surface
    let mut blank = found.report.points[0].clone();
    blank.qualities[0].surface_mean_mm = None;
    found.report.points.push(blank);
    let stored = serde_json::to_string(&found).unwrap();
    let again: FoundCeiling = serde_json::from_str(&stored).unwrap();
    assert_eq!(again.report, found.report);
    assert_eq!(serde_json::to_string(&again).unwrap(), stored);
    // The search has not tried the ceilings of this test
    found.report.points.truncate(1);
    found.report.chosen = None;
    let level = resolved.levels.last().unwrap();
    let stage = Stage::new(&resolved, &voxels, level, None, silent, &run).unwrap();
    let start = resolved.method.start.as_ref();
    let mut x = stage.start(start, &run).unwrap();
    let highest = stage.limits(&x);
    let mut bounds = highest.clone();
    bounds[0].max *= share;
    start::clip(&mut x, stage.model.patterns(), &bounds).unwrap();
    let sofar = &mut stage::SoFar::default();
    let around = stage::Around {
        until: level.until,
        wider: 0,
        change: 0.0,
        bounds: &bounds,
        checkpoints: None,
        sofar,
        progress: silent,
        work: &run,
    };
    let outcome = stage.run(&mut x, around);
    let ended = finest::Ended {
        x: &mut x,
        bounds: &mut bounds,
        highest: &highest,
        outcome: outcome.unwrap(),
    };
    let found_one = &mut found;
    let outcome = finest::settle(&stage, ended, found_one, sofar, silent, &run).unwrap();
    let by = found.report.finest.as_ref().unwrap().changed_by;
    let warns = found.report.warning().is_some();
    assert_eq!(warns, by > 1.0);
    let last = outcome.history.last().unwrap().iteration;
    (last, by, bounds[0].max / highest[0].max)
}

#[test]
fn a_ceiling_rises_where_it_costs_quality_on_the_finest_level_and_falls_where_it_has_slack() {
    let (last, by, share) = raised_from(0.1);
    // Two doubles
    assert!(last > 20 && (share - 0.4).abs() < 1e-9, "{last} {share}");
    assert_eq!(by, 4.0);
    let lower = std::f64::consts::FRAC_1_SQRT_2;
    assert_eq!(raised_from(1.0), (28, lower, lower));
    assert_eq!(raised_from(0.5), (20, 1.0, 0.5));
    let (last, by, _) = raised_from(0.3);
    assert_eq!((last, by), (28, std::f64::consts::SQRT_2));
}

#[test]
fn ceilings_of_whole_voxels_are_judged_as_the_evaluation_does_and_begin_with_the_start() {
    let whole = "objective = { threshold = { surface = \"voxel\" } }\nevaluate = { refine = 2, sub_angles = 1 }";
    let (resolved, voxels) = gear(whole);
    let (run, silent) = (Work::new(), &mut crate::job::progress::Silent);
    let level = resolved.levels.last().unwrap();
    let stage = Stage::new(&resolved, &voxels, level, None, silent, &run).unwrap();
    let mut x = stage.start(resolved.method.start.as_ref(), &run).unwrap();
    let judged = stage.qualities(&x, false, &[], &run).unwrap();
    let patterns = stage.patterns(&mut x);
    let print = evaluate_patterns(
        &resolved,
        &voxels,
        &patterns,
        Origin::default(),
        silent,
        &run,
    )
    .unwrap();
    let evaluated = print.first().evaluation.measures.get("iou").unwrap();
    assert!(
        (judged[0].iou.unwrap() - evaluated).abs() < 1e-9,
        "{judged:?} {evaluated}"
    );
    let own = gear(&whole.replace("refine = 2", "refine = 1"));
    let on_own = Stage::new(&own.0, &own.1, level, None, silent, &run).unwrap();
    let on_own = on_own.qualities(&x, false, &[], &run).unwrap();
    assert!(on_own[0].iou > judged[0].iou, "{on_own:?} {judged:?}");
    let goes_on = |stop: &str, more: &str| ceiling::may_begin_elsewhere(&gear_until(stop, more).0);
    assert!(!goes_on("iterations = 30", whole) && goes_on("iterations = 29", whole));
    assert!(goes_on("iterations = 30", ""));
}

#[test]
fn a_ceiling_that_the_coarser_level_refused_by_far_is_not_tried_again() {
    let (few, voxels) = gear("");
    let (resolved, _) = gear_until("iterations = 30", "");
    let mut found = (ceiling::find(&few, &voxels, &Work::new()).unwrap()).unwrap();
    let lower = std::f64::consts::FRAC_1_SQRT_2;
    let point = |factor: f64, lost: f64| CeilingPoint {
        factor,
        qualities: vec![CeilingQuality {
            iou: Some(1.0 - lost),
            ver: Some(0.0),
            surface_mean_mm: None,
            gamma: Some(10.0),
        }],
    };
    for (lost, is_tried) in [(0.0039, true), (0.0041, false)] {
        let tried = [(1.0, 0.0), (0.5, 0.0), (0.25, 0.02), (0.5 * lower, lost)];
        found.report.points = tried.map(|(factor, lost)| point(factor, lost)).into();
        found.report.chosen = Some(1);
        assert_eq!(found.may_become(lower, &resolved), is_tried, "{lost}");
        assert!(found.may_become(lower, &few));
    }
    found.report.points.truncate(3);
    assert!(found.may_become(lower, &resolved));
}

/// What the optimization of a job comes to, with checkpoints in a folder.
fn optimized((resolved, voxels): (ResolvedJob, Vec<Voxels>), folder: &Path) -> Optimized {
    let plan = CheckpointPlan {
        folder,
        resume: false,
        keeps_end: false,
    };
    let (cache, silent) = (&mut RunCache::default(), &mut crate::job::progress::Silent);
    optimize(&resolved, &voxels, plan, cache, silent, &Work::new()).unwrap()
}

#[test]
fn an_optimization_ends_where_its_loss_hardly_changes() {
    let place = tempfile::tempdir().unwrap();
    // A window that the gear's light does not reach: its loss has a floor above 0
    let more = "objective = { threshold = { lower = 0.85, upper = 0.9 } }\nbounds = { ceiling = \"start\" }";
    let history = |stop: &str, more: &str| {
        let outcome = optimized(gear_until(stop, more), place.path()).outcome;
        (outcome.reason, outcome.history)
    };
    let (reason, ended) = history("iterations = 200", more);
    assert_eq!(reason, StopReason::Steady);
    let losses: Vec<f64> = ended.iter().rev().take(6).map(|row| row.loss).collect();
    let change = losses
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).abs())
        .sum::<f64>()
        / 5.0;
    assert!(
        change <= 0.0005 * losses[0] && ended.len() < 201,
        "{losses:?}"
    );
    // Asked to, it goes on the same way; other methods do so by themselves
    let further = format!("iterations = {}", ended.len() + 2);
    let (reason, all) = history(&format!("{further}, change = 0"), more);
    assert_eq!(reason, StopReason::Iterations);
    let losses = |rows: &[Row]| -> Vec<f64> { rows.iter().map(|row| row.loss).collect() };
    assert_eq!(losses(&all[..ended.len()]), losses(&ended));
    let by_gradient = format!("{more}\noptimizer = {{ gradient = {{}} }}");
    assert_eq!(history(&further, &by_gradient).0, StopReason::Iterations);
    // So do runs from earlier patterns
    let file = place.path().join("earlier.npz");
    let earlier = optimized(gear_until("iterations = 0", more), place.path());
    let pair = PatternPair {
        light: None,
        shown: &earlier.raw[0],
        raw: None,
    };
    write_patterns(&file, &[pair], &Work::new()).unwrap();
    let from_file = format!("{more}\nstart = {{ patterns = {{ file = {file:?} }} }}");
    let steady = [more, &from_file].map(|more| gear(more).0.steady());
    assert_eq!(steady, [0.0005, 0.0]);
}

#[test]
fn files_of_any_brightness_begin_alike_where_they_are_scaled() {
    let place = tempfile::tempdir().unwrap();
    let of_start = "bounds = { ceiling = \"start\" }";
    let done = optimized(gear_until("iterations = 8", of_start), place.path());
    let brightest = done.raw[0].values.iter().copied().fold(0.0, f32::max);
    let begins = |factor: f32, bounds: &str| {
        let file = place.path().join("scaled.npz");
        let mut patterns = done.raw[0].clone();
        patterns.values.iter_mut().for_each(|v| *v *= factor);
        let pair = PatternPair {
            light: None,
            shown: &patterns,
            raw: None,
        };
        write_patterns(&file, &[pair], &Work::new()).unwrap();
        let start = format!("start = {{ patterns = {{ file = {file:?}, scaled = true }} }}");
        let job = gear_until("iterations = 0", &format!("{bounds}\n{start}"));
        optimized(job, place.path()).outcome.history[0].loss
    };
    let loss = begins(1.0, "");
    let bound = format!("bounds = {{ max = {} }}", 2.0 * brightest);
    for (factor, bounds) in [(0.1, ""), (100.0, bound.as_str()), (0.1, &bound)] {
        tomolith_core::near!(begins(factor, bounds) / loss, 1.0, 1e-3);
    }
}

#[test]
fn an_optimization_goes_on_from_the_search_for_its_ceiling() {
    let place = tempfile::tempdir().unwrap();
    let first = |more: &str| {
        let done = optimized(gear(more), place.path());
        let brightest = done.raw[0].values.iter().copied().fold(0.0, f32::max);
        let history = done.outcome.history;
        assert!(history.last().unwrap().iteration >= 20);
        (history[0].iteration, brightest)
    };
    let (iteration, brightest) = first("");
    let (of_start, brightest_of_start) = first("bounds = { ceiling = \"start\" }");
    assert_eq!((iteration, of_start), (2, 0));
    assert!(
        brightest < 0.8 * brightest_of_start,
        "{brightest} {brightest_of_start}"
    );
}

#[test]
fn a_finer_level_below_a_ceiling_is_bounded_as_its_own_start_would_bound_it() {
    let (resolved, voxels) = gear("multiresolution = { levels = 1 }");
    let (place, run) = (tempfile::tempdir().unwrap(), Work::new());
    let plan = CheckpointPlan {
        folder: place.path(),
        resume: false,
        keeps_end: false,
    };
    let (cache, silent) = (&mut RunCache::default(), &mut crate::job::progress::Silent);
    let (checkpoints, _) = open_checkpoints(&resolved, &voxels, plan, silent).unwrap();
    let search = Search::begin(&resolved, &voxels, checkpoints, None, cache, silent, &run);
    let mut search = search.unwrap();
    assert_eq!(resolved.levels.len(), 2);
    for (i, level) in resolved.levels.iter().enumerate() {
        let stage = search.stage(i, level).unwrap();
        let makes_start = search.start(i, level, &stage).unwrap().is_some();
        assert_eq!(makes_start, i == 0);
        let start = stage.start(resolved.method.start.as_ref(), &run).unwrap();
        let ratio = search.highest[0].max / stage.limits(&start)[0].max;
        // Twice as many frames: half the light of each
        assert!((0.7..1.4).contains(&ratio), "level {i}: {ratio}");
    }
}
