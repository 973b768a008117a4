use super::*;
use crate::fixtures::{domain_of, network, oxygen, photopolymer, refused};
use crate::mixing::Mixing;
use crate::photopolymer::{Params, Photopolymer};
use crate::print::{LightSource, PrintRun};
use crate::schedule::{Power, Schedule, Turns};
use std::ops::ControlFlow;
use tomolith_core::check::{self, small::SmallModel};
use tomolith_core::dose::{DoseModel, Work};
use tomolith_core::near;

/// A checkerboard of cells of `cell` voxels within the inscribed circle: half of it is part, by symmetry.
fn checkerboard(model: &SmallModel, cell: usize) -> Volume<u8> {
    let grid = model.layout().grid.clone();
    let n = grid.shape[1];
    let mut labels = Volume::filled(grid.clone(), label::OUTSIDE);
    for (i, l) in labels.values.iter_mut().enumerate() {
        let (iy, ix) = (i / n, i % n);
        if grid.x(ix).hypot(grid.y(iy)) < n as f64 / 2.0 - 1.0 {
            let even = (iy / cell + ix / cell).is_multiple_of(2);
            *l = if even { label::PART } else { label::VOID };
        }
    }
    labels
}

/// Non-negative patterns from some steps of projected descent on the squared error.
fn patterns(model: &SmallModel, labels: &Volume<u8>) -> HostField {
    let target = Volume::new(
        labels.grid.clone(),
        labels
            .values
            .iter()
            .map(|l| f32::from(u8::from(*l == label::PART)))
            .collect(),
    );
    let target = HostField::from_slice(&model.layout().field_of(&target));
    let work = Work::new();
    let mut x = model.new_patterns().unwrap();
    let mut dose = model.new_dose().unwrap();
    let mut grad = x.zeros_like();
    for _ in 0..30 {
        model.dose(&x, &mut dose, &work).unwrap();
        dose.axpy(-1.0, &target);
        model.pullback(&x, &dose, &mut grad, &work).unwrap();
        x.axpy(-0.3, &grad);
        x.clamp(0.0, 1e3);
    }
    x
}

/// Prints patterns of lights that are alike, in steps of at most so many seconds where that is given.
fn watch(
    curves: &mut Curves,
    material: &Photopolymer,
    schedule: &Schedule,
    model: &SmallModel,
    x: &HostField,
    step_s: Option<f64>,
) {
    let lights = schedule.frames().iter().map(|_| LightSource::new(model, x));
    let mut print = PrintRun::new(material, schedule, lights.collect()).unwrap();
    if let Some(step_s) = step_s {
        print = print.with_step_s(step_s).unwrap();
    }
    let mut observer = |moment: &Moment| {
        curves.watch(moment);
        ControlFlow::Continue(())
    };
    print.run(&Work::new(), &mut observer).unwrap();
}

#[test]
fn a_checkerboard_goes_through_three_phases_with_one_best_moment() {
    let model = SmallModel::new(48, 72, 1);
    let labels = checkerboard(&model, 8);
    let x = patterns(&model, &labels);
    let material = photopolymer(network(vec![oxygen(0.2, 0.0)], 0.5), domain_of(&model));
    // One turn of 72 s leaves what the patterns are made for; ten cure everything
    let turns = Turns {
        power: Power::EnergyPerTurn(1.0),
        ..Turns::new(72, 72.0, 10.0)
    };
    let schedule = Schedule::of_turns(&[turns]).unwrap();
    let mut curves = Curves::new(&material, 0, &labels)
        .unwrap()
        .with_cure_times(&material)
        .with_snapshots(&[60.0, 0.0]);
    watch(&mut curves, &material, &schedule, &model, &x, None);
    let points = curves.points();
    assert_eq!(points.len(), 721);
    // Induction: nothing gels, the dose grows evenly
    let phases = curves.phases();
    let (first, best) = (
        phases.induction_end_s.unwrap(),
        phases.curing_end_s.unwrap(),
    );
    assert!(
        first > 20.0 && best > first + 10.0 && best < 150.0,
        "{phases:?}"
    );
    let slope = |p: &CurvePoint| p.imbued_mj / p.seconds;
    let induction: Vec<&CurvePoint> = points
        .iter()
        .filter(|p| p.seconds > 0.0 && p.seconds < first)
        .collect();
    assert!(
        induction
            .iter()
            .all(|p| p.jaccard == 0.0 && p.contribution_mj == 0.0)
    );
    // A frame of a checkerboard takes more or less of it than another; half turns are alike
    let even = slope(points.last().unwrap());
    for p in induction {
        let off = (slope(p) / even - 1.0).abs();
        let most = if (p.seconds - 36.0).abs() < 1e-6 {
            1e-5
        } else {
            0.13
        };
        assert!(off < most, "{p:?}: {off}");
    }
    // Curing: one rise, one fall, to the part's share of one half
    let top = curves.best().unwrap();
    assert!(top.jaccard > 0.6 && top.seconds == best, "{top:?}");
    for pair in points.windows(2) {
        let rises = pair[1].jaccard - pair[0].jaccard;
        assert!(
            if pair[1].seconds <= best {
                rises > -0.01
            } else {
                rises < 0.01
            },
            "{pair:?}"
        );
    }
    let end = points.last().unwrap();
    assert_eq!((end.jaccard, end.gelled), (0.5, [1.0, 1.0]));
    // All solid: every millijoule counts
    assert!((end.contribution_mj / end.imbued_mj - 1.0).abs() < 1e-12);
    // (0.5 + 0.2) mJ/mm³ of every voxel of the part
    let part = labels.values.iter().filter(|l| **l == label::PART).count() as f64;
    assert!((curves.requirement_mj().unwrap() / (0.7 * part) - 1.0).abs() < 1e-6);
    let IdealExposure::At(ideal) = curves.ideal_exposure() else {
        panic!("{:?}", curves.ideal_exposure())
    };
    assert!(ideal > first && ideal < best + 60.0, "{ideal} {best}");
    // The printed contrast has no number once all voxels have a third of the largest dose
    let late = points.iter().find(|p| p.seconds > 200.0).unwrap();
    assert!(late.dose[0] > late.dose[1] / 3.0 && late.printed_contrast.is_nan());
    assert!((0.05..1.0).contains(&late.contrast), "{late:?}");
    let early = points.iter().find(|p| p.seconds > 15.0).unwrap();
    assert!(early.dose[0] < early.dose[1] / 3.0 && early.printed_contrast > 0.0);
    // Cure times agree with what is gelled, snapshots with the moment
    let times = curves.cure_times(&material).unwrap();
    let gelled = times.values.iter().zip(&labels.values);
    let gelled = gelled
        .filter(|(t, l)| **l != label::OUTSIDE && **t <= best as f32)
        .count() as f64;
    let [in_part, in_void] = top.gelled;
    let void = labels.values.iter().filter(|l| **l == label::VOID).count() as f64;
    near!(gelled - in_part * part, in_void * void, 0.5, "{gelled}");
    let moments: Vec<f64> = curves.snapshots().iter().map(|s| s.0).collect();
    assert_eq!(moments, [0.0, 60.0]);
}

#[test]
fn contrast_repeats_with_every_turn_until_something_cures() {
    let model = SmallModel::new(24, 36, 1);
    let labels = checkerboard(&model, 4);
    let x = patterns(&model, &labels);
    let material = photopolymer(network(Vec::new(), 1e6), domain_of(&model));
    let schedule = Schedule::of_turns(&[Turns::new(36, 36.0, 3.0)]).unwrap();
    let mut curves = Curves::new(&material, 0, &labels).unwrap();
    watch(&mut curves, &material, &schedule, &model, &x, None);
    let at = |seconds: f64| {
        let near = |p: &&CurvePoint| (p.seconds - seconds).abs() < 1e-6;
        curves.points().iter().find(near).unwrap().contrast
    };
    // Whole turns have the same contrast; within a turn it is another
    assert!((at(36.0) - at(108.0)).abs() < 1e-5);
    assert!((at(36.0) - at(9.0)).abs() > 0.05, "{}", at(9.0));
    let phases = curves.phases();
    assert_eq!((phases.induction_end_s, phases.curing_end_s), (None, None));
    let IdealExposure::NotReached(share) = curves.ideal_exposure() else {
        panic!()
    };
    // What the part has absorbed: a mean of its doses
    let [least, most] = curves.points().last().unwrap().dose;
    let mean = 1e6 * share;
    assert!(mean > least && mean <= most, "{least} {mean} {most}");
}

#[test]
fn cure_times_are_interpolated_within_a_block() {
    let model = SmallModel::new(5, 4, 1);
    let material = photopolymer(network(Vec::new(), 1.0), domain_of(&model));
    let x = check::even_patterns(&model, 1.0);
    // The middle gets 1 mJ/mm³ per turn of 8 s, evenly: 1.25 turns in all
    let turns = Turns {
        power: Power::EnergyPerTurn(1.0),
        ..Turns::new(4, 8.0, 1.25)
    };
    let schedule = Schedule::of_turns(&[turns]).unwrap();
    let mut labels = Volume::filled(model.layout().grid.clone(), label::PART);
    labels.values[0] = label::OUTSIDE;
    for step in [0.3, 2.0, 5.0] {
        let mut curves = Curves::new(&material, 0, &labels)
            .unwrap()
            .with_cure_times(&material);
        watch(&mut curves, &material, &schedule, &model, &x, Some(step));
        let times = curves.cure_times(&material).unwrap().values;
        assert!((times[12] - 8.0).abs() < 1e-4, "{step}: {}", times[12]);
        // What is first solid is so within a step, and the ideal exposure not before it
        let first = times[1..].iter().copied().fold(f32::INFINITY, f32::min);
        assert_eq!(curves.phases().induction_end_s, Some(f64::from(first)));
        let IdealExposure::At(ideal) = curves.ideal_exposure() else {
            panic!("{:?}", curves.ideal_exposure())
        };
        assert!(ideal >= f64::from(first), "{ideal} {first}");
    }
}

#[test]
fn antagonists_do_not_count_as_imbued() {
    let model = SmallModel::new(5, 4, 1);
    let mixing = Mixing::new(vec![vec![1.0, -2.0]]).unwrap();
    let params = Params::new(vec![network(Vec::new(), 1.0)]);
    let material = Photopolymer::new(params, mixing, domain_of(&model)).unwrap();
    let x = check::even_patterns(&model, 1.0);
    // The antagonist shines in the second half only
    let late = Turns {
        dark_before_s: 4.0,
        ..Turns::new(4, 4.0, 1.0)
    };
    let schedule = Schedule::of_turns(&[Turns::new(4, 8.0, 1.0), late]).unwrap();
    let labels = Volume::filled(model.layout().grid.clone(), label::PART);
    let mut curves = Curves::new(&material, 0, &labels).unwrap();
    watch(&mut curves, &material, &schedule, &model, &x, None);
    let middle = curves.points().iter().find(|p| p.seconds >= 4.0).unwrap();
    let end = curves.points().last().unwrap();
    assert_eq!(middle.imbued_mj, end.imbued_mj);
}

#[test]
fn what_cannot_be_watched_is_named() {
    let model = SmallModel::new(5, 4, 1);
    let material = photopolymer(network(Vec::new(), 1.0), domain_of(&model));
    let labels = Volume::filled(model.layout().grid.clone(), label::VOID);
    let [key, _] = refused(Curves::new(&material, 0, &labels));
    assert_eq!(key, "target");
}
