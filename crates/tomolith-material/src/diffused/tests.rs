use super::*;
use crate::domain::Domain;
use crate::fixtures::{apart, domain_of, even, photopolymer, wandering};
use crate::mixing::Mixing;
use crate::photopolymer::{Params, Photopolymer};
use crate::schedule::Turns;
use crate::{diffusion::Scheme, print};
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use tomolith_core::check;
use tomolith_core::check::small::SmallModel;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::near;

const D: f64 = 1e-4;

fn rate(period_mm: f64) -> f64 {
    D * (TAU / period_mm).powi(2)
}

#[test]
fn multipliers_of_even_light_are_the_closed_form() {
    let even = [even(40.0)];
    for (period, expected) in [(0.1, 0.063), (0.2, 0.248), (0.5, 0.741), (1.0, 0.925)] {
        let found = left_of(rate(period), &even);
        assert!((found - expected).abs() < 5e-4, "{period} mm: {found}");
    }
    assert_eq!(left_of(0.0, &even), 1.0);
    // Cut anywhere it is the same
    let cut = [(30.0, 10.0, 0.25), (0.0, 30.0, 0.75)].map(|(before_s, seconds, share)| Span {
        before_s,
        seconds,
        share,
    });
    assert!((left_of(rate(0.2), &cut) - left_of(rate(0.2), &even)).abs() < 1e-14);
}

#[test]
fn the_sum_over_turns_converges_to_even_light() {
    for (turns, expected) in [(1, 0.139), (2, 0.212), (4, 0.239), (8, 0.246)] {
        let flash = |n: usize| Span {
            before_s: 40.0 - (n as f64 + 0.5) * 40.0 / turns as f64,
            seconds: 0.0,
            share: 1.0 / turns as f64,
        };
        let found = left_of(rate(0.2), &(0..turns).map(flash).collect::<Vec<_>>());
        assert!((found - expected).abs() < 5e-4, "{turns} turns: {found}");
    }
}

#[test]
fn a_point_lit_evenly_has_variance_dt() {
    let domain = Domain::new(VolumeGrid::centered([1, 48, 48], 0.05));
    let mut spot = domain.zeros();
    let g = domain.grid().clone();
    // A wide spot, so that the voxels do not count
    for i in 0..48 * 48 {
        let r2 = g.x(i % 48).powi(2) + g.y(i / 48).powi(2);
        spot.as_mut_slice()[i] = (-r2 / 0.02).exp() as f32;
    }
    let moments = |v: &HostField| {
        let v = v.as_slice();
        let mass: f64 = v.iter().map(|v| f64::from(*v)).sum();
        let square = |i: usize| f64::from(v[i]) * g.x(i % 48).powi(2);
        (mass, (0..v.len()).map(square).sum::<f64>() / mass)
    };
    let (mass, before) = moments(&spot);
    let spectral = Spectral::new(domain.layout());
    let modes = Modes::of(&spectral, |k2| left_of(D * k2, &[even(120.0)]));
    spectral.multiply(spot.as_mut_slice(), &modes);
    let (after, variance) = moments(&spot);
    assert!((after / mass - 1.0).abs() < 1e-6);
    near!((variance - before) / (D * 120.0), 1.0, 2e-3);
}

/// Light that is even over 40 s; the small model's voxels are 1 mm, and this D matters there.
fn diffused<M: DoseModel<Field = HostField> + ?Sized>(model: Box<M>) -> Diffused<M> {
    let frames = frames_of(model.patterns());
    Diffused::of_spans(model, 0.02, &[(0..frames, vec![even(40.0)])]).unwrap()
}

#[test]
fn it_is_an_exact_pair_with_one_arc_and_with_many() {
    let small = || Box::new(SmallModel::new(9, 12, 3));
    check::model::model(&diffused(small()), 1).unwrap();
    let schedule = Schedule::of_turns(&[Turns::new(12, 10.0, 3.5)]).unwrap();
    for arcs in [1, 5, 12] {
        let model = Diffused::of_schedule(small(), 0.02, &schedule, arcs).unwrap();
        check::model::model(&model, 3).unwrap();
        // Searches know that it is linear
        let work = Work::new();
        let x = check::noisy_patterns(&model, 8);
        let dose = check::dose(&model, &x);
        let terms = model.along(&x, &x, &work).unwrap().unwrap();
        let off = apart(&dose, &terms[0]);
        assert!(terms.len() == 1 && off < 1e-5, "{off}");
    }
    let boxed: Box<dyn DoseModel<Field = HostField>> = small();
    check::model::model(&diffused(boxed), 5).unwrap();
}

/// How far a dose in so many arcs is from the print in time, after so many turns.
fn off_the_print(turns: f64, arcs: usize) -> f64 {
    let model = SmallModel::new(11, 12, 1);
    let turns = Turns {
        dark_after_s: 3.0,
        ..Turns::new(12, 12.0, turns)
    };
    let schedule = Schedule::of_turns(&[turns]).unwrap();
    let mut x = model.new_patterns().unwrap();
    let noise = check::noise(3, x.len());
    x.copy_from_host(&noise.iter().map(|v| v.abs()).collect::<Vec<_>>());
    let params = Params::new(vec![wandering(1.0, 0.02)]).diffusing_by(Scheme::Spectral);
    let domain = domain_of(&model);
    let material = Photopolymer::new(params, Mixing::identity(1), domain).unwrap();
    let light = print::LightSource::new(&model, &x);
    let mut printing = print::PrintRun::new(&material, &schedule, vec![light]).unwrap();
    let state = printing
        .run(&Work::new(), &mut |_| ControlFlow::Continue(()))
        .unwrap();
    let printed = &state.volumes[material.readout(0).volume];
    let model = Box::new(SmallModel::new(11, 12, 1));
    let diffused = Diffused::of_schedule(model, 0.02, &schedule, arcs).unwrap();
    let mut dose = check::dose(&diffused, &x);
    dose.axpy(-1.0, printed);
    dose.norm() / printed.norm()
}

#[test]
fn arcs_of_single_frames_are_the_print_of_a_dose_that_wanders() {
    let [exact, rough] = [12, 1].map(|arcs| off_the_print(2.0, arcs));
    assert!(exact < 1e-4, "{exact}");
    assert!(rough > 10.0 * exact, "{rough} {exact}");
}

#[test]
fn frames_that_a_broken_turn_shows_once_more_count_more() {
    let exact = off_the_print(1.5, 12);
    assert!(exact < 1e-4, "{exact}");
    // Arcs end where the last turn does
    let model = Box::new(SmallModel::new(11, 12, 1));
    let schedule = Schedule::of_turns(&[Turns::new(12, 12.0, 1.5)]).unwrap();
    let diffused = Diffused::of_schedule(model, 0.02, &schedule, 1).unwrap();
    let frames: Vec<_> = diffused.arcs.iter().map(|arc| arc.frames.clone()).collect();
    assert_eq!(frames, [0..6, 6..12]);
    let model = Box::new(SmallModel::new(11, 12, 1));
    let schedule = Schedule::of_turns(&[Turns::new(12, 12.0, 0.5)]).unwrap();
    let refused = Diffused::of_schedule(model, 0.02, &schedule, 1)
        .err()
        .unwrap();
    tomolith_core::contains!(
        refused.to_string(),
        "some of its frames are never shown, such as frame 6"
    );
}

#[test]
fn what_a_wall_within_the_box_would_hold_back_goes_on_into_it() {
    // Resin up to a wall in the middle of the box, lit evenly: √(DT) is 0.25 mm
    let (diffusion, seconds, steps) = (5e-4, 125.0, 250);
    let grid = VolumeGrid::centered([1, 1, 60], 0.1);
    let resin = Volume {
        values: (0..60).map(|i| i < 30).collect(),
        grid: grid.clone(),
    };
    let walled = Domain::new(grid).with_walls(&resin).unwrap();
    let dose = walled.even(1.0);
    let material = photopolymer(wandering(1.0, diffusion), walled.clone());
    let mut state = material.start().unwrap();
    let light = walled.even(1.0 / steps as f32);
    for _ in 0..steps {
        let step_s = seconds / f64::from(steps);
        material
            .step(&mut state, &[light.as_slice()], step_s)
            .unwrap();
    }
    let stepped = &state.volumes[material.readout(0).volume];
    let spectral = Spectral::new(walled.layout());
    let spans = [even(seconds)];
    let modes = Modes::of(&spectral, |k2| left_of(diffusion * k2, &spans));
    let mut boxed = dose.clone();
    spectral.multiply(boxed.as_mut_slice(), &modes);
    // 1 − ½·[(1 + 2a²)·erfc(a) − (2a/√π)·e^(−a²)], a = distance/(2√(DT))
    for (from_wall, expected) in [(0.05, 0.603), (0.25, 0.860), (0.55, 0.980), (0.75, 0.996)] {
        let value_of = |field: &HostField| {
            let i = 29 - (from_wall / 0.1) as usize;
            f64::from(field.as_slice()[walled.layout().index(0, 0, i)])
        };
        assert!(
            (value_of(stepped) - 1.0).abs() < 1e-4,
            "{}",
            value_of(stepped)
        );
        near!(value_of(&boxed), expected, 3e-3, "{from_wall} mm");
    }
}
