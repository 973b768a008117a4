use super::*;
use crate::diffusion::Scheme;
use crate::fixtures::{domain_of, network, oxygen, photopolymer, wandering};
use crate::mixing::Mixing;
use crate::photopolymer::{Curing, Inhibitor, Network, Params, Photopolymer};
use crate::schedule::Turns;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use tomolith_core::check;
use tomolith_core::check::small::SmallModel;
use tomolith_core::check::taylor::Remainders;
use tomolith_core::dose::{Facts, Renewal, Space, ZCoupling, frames_of};
use tomolith_core::field::Field;

fn small() -> SmallModel {
    SmallModel::new(9, 12, 3)
}

fn positive(len: usize, seed: u64) -> HostField {
    let noise = check::noise(seed, len);
    HostField::from_slice(&noise.iter().map(|v| 0.2 + v.abs()).collect::<Vec<_>>())
}

fn bits(field: &HostField) -> Vec<u32> {
    field.as_slice().iter().map(|v| v.to_bits()).collect()
}

/// Smooth consumption, a rate law, D that falls: everything that has a derivative.
fn in_time(lights: usize) -> Printing {
    let oxygen = Inhibitor {
        cured_diffusion: if lights == 1 { 0.2 } else { 1.0 },
        half_saturation: Some(0.1),
        ..oxygen(0.3, 0.03)
    };
    let first = Network {
        inhibitors: vec![oxygen],
        gel_width: 1.0,
        bleaching_mm3_per_mj: 0.1,
        ..Network::new(
            "a",
            Curing::RateLaw {
                rate_per_s: 2.0,
                exponent: 0.7,
                gel_conversion: 0.3,
            },
        )
    };
    let second = wandering(0.4, 0.01);
    let (networks, mixing, scheme) = if lights == 1 {
        (vec![first], Mixing::identity(1), Scheme::Faces)
    } else {
        let mixing = Mixing::new(vec![vec![1.0, 0.2], vec![0.1, 0.9]]).unwrap();
        (vec![first, second], mixing, Scheme::Spectral)
    };
    let params = Params::new(networks).diffusing_by(scheme);
    let domain = domain_of(&small());
    let material = Photopolymer::new(params, mixing, domain).unwrap();
    // Every turn of the first has patterns of its own: 12 frames
    let all = [
        Turns {
            dark_between_s: 1.0,
            own_patterns: true,
            ..Turns::new(6, 3.0, 2.0)
        },
        Turns {
            duty: 0.6,
            ..Turns::new(12, 5.0, 1.3)
        },
    ];
    let schedule = Schedule::of_turns(&all[..lights]).unwrap();
    let optics = (0..lights)
        .map(|_| Box::new(small()) as Box<Model>)
        .collect();
    Printing::new(optics, schedule, material, Some(0.6)).unwrap()
}

#[test]
fn the_gradient_through_time_passes_a_taylor_test() {
    // Cosine transforms round off more: the second ends where f32 ends it
    for (lights, decades) in [(1, 2), (2, 1)] {
        let printing = in_time(lights);
        let work = Work::new();
        let x = positive(printing.new_patterns().unwrap().len(), 1);
        let mut d = x.zeros_like();
        d.copy_from_host(&check::noise(2, d.len()));
        // Of one sign, so that terms of second order do not cancel; padding is 0 in every cure
        let c = positive(printing.new_dose().unwrap().len(), 3);
        let value = |e: f32| {
            let (mut y, mut dose) = (x.clone(), printing.new_dose().unwrap());
            y.axpy(e, &d);
            printing.dose(&y, &mut dose, &work).unwrap();
            dose.dot(&c)
        };
        let mut grad = x.zeros_like();
        grad.fill(f32::NAN);
        printing.pullback(&x, &c, &mut grad, &work).unwrap();
        let exact = grad.dot(&d);
        let left = Remainders::over(decades, 0.1, &value, exact);
        assert!((left.order() - 2.0).abs() < 0.05, "{lights}: {left:?}");
        let is_second = |order: &f64| (1.8..2.2).contains(order);
        assert!(left.orders().iter().all(is_second), "{lights}: {left:?}");
        // A slope that is off by a hundredth shows
        let off = Remainders::over(decades, 0.1, &value, 1.01 * exact);
        assert!(!off.orders().iter().all(is_second), "{lights}: {off:?}");
    }
}

#[test]
fn the_gradient_of_some_frames_is_that_part_of_the_whole() {
    let work = Work::new();
    for printing in [1, 2].map(in_time) {
        let x = positive(printing.new_patterns().unwrap().len(), 7);
        let c = positive(printing.new_dose().unwrap().len(), 8);
        let mut whole = x.zeros_like();
        printing.pullback(&x, &c, &mut whole, &work).unwrap();
        let all = frames_of(printing.patterns());
        for frames in [0..1, 3..8, all - 1..all, all / 2 - 2..all / 2 + 3, 5..5] {
            let (mut part, mut expected) = (x.zeros_like(), x.zeros_like());
            part.fill(-7.5);
            expected.fill(-7.5);
            printing
                .pullback_of(frames.clone(), &x, &c, &mut part, &work)
                .unwrap();
            for (range, _) in elements_of(printing.patterns(), &frames) {
                expected.as_mut_slice()[range.clone()].copy_from_slice(&whole.as_slice()[range]);
            }
            assert_eq!(bits(&part), bits(&expected), "{frames:?} of {all}");
        }
    }
}

/// A model that counts the frames it pulls back.
struct Counting(SmallModel, Arc<AtomicUsize>);

impl DoseModel for Counting {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        self.0.facts()
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        self.0.new_field(space)
    }

    fn updates(&self) -> u64 {
        self.0.updates()
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        self.0.renewal()
    }

    fn describe(&self) -> String {
        self.0.describe()
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        self.0.dose_of(frames, x, dose, work)
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        c: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        self.1.fetch_add(frames.len(), Ordering::Relaxed);
        self.0.pullback_of(frames, x, c, grad, work)
    }
}

#[test]
fn the_way_back_asks_for_the_frames_that_shine_and_no_others() {
    let counted = Arc::new(AtomicUsize::new(0));
    let material = photopolymer(network(vec![oxygen(1.0, 0.0)], 0.4), domain_of(&small()));
    let optics: Vec<Box<Model>> = vec![Box::new(Counting(small(), Arc::clone(&counted)))];
    let schedule = Schedule::of_turns(&[Turns::new(12, 6.0, 1.0)]).unwrap();
    let printing = Printing::new(optics, schedule, material, Some(0.5)).unwrap();
    let x = positive(printing.new_patterns().unwrap().len(), 1);
    let c = positive(printing.new_dose().unwrap().len(), 2);
    let (mut grad, work) = (x.zeros_like(), Work::new());
    let blocks = printing.blocks.len();
    printing.pullback(&x, &c, &mut grad, &work).unwrap();
    // A block a frame: 12 frames, where the whole gradient of every block would take 144
    assert_eq!((blocks, counted.swap(0, Ordering::Relaxed)), (12, 12));
    printing
        .pullback_of(4..5, &x, &c, &mut grad, &work)
        .unwrap();
    assert_eq!(counted.load(Ordering::Relaxed), 1);
}

#[test]
fn outputs_are_overwritten_and_bits_do_not_depend_on_threads() {
    let printing = in_time(1);
    let work = Work::new();
    let x = positive(printing.new_patterns().unwrap().len(), 5);
    let results_on = |threads: usize, before: f32| {
        tomolith_core::check::on_threads(threads, || {
            let (mut dose, mut grad) = (printing.new_dose().unwrap(), x.zeros_like());
            dose.fill(before);
            grad.fill(before);
            printing.dose(&x, &mut dose, &work).unwrap();
            printing.pullback(&x, &dose, &mut grad, &work).unwrap();
            (bits(&dose), bits(&grad))
        })
    };
    let one = results_on(1, 0.0);
    assert!(one == results_on(2, f32::NAN) && one == results_on(8, 7.0));
}

#[test]
fn what_needs_a_sum_over_frames_is_refused() {
    let printing = in_time(1);
    let (x, work) = (printing.new_patterns().unwrap(), Work::new());
    assert!(printing.along(&x, &x, &work).unwrap().is_none());
    assert!(!printing.is_linear() && printing.z_coupling() == ZCoupling::Full);
    let mut dose = printing.new_dose().unwrap();
    let refused = printing.dose_of(0..2, &x, &mut dose, &work);
    assert!(matches!(refused, Err(Error::Unsupported { .. })));
}

#[test]
fn lights_that_do_not_fit_are_named() {
    let schedule = Schedule::of_turns(&[Turns::new(11, 1.0, 1.0)]).unwrap();
    let material = photopolymer(network(Vec::new(), 0.5), domain_of(&small()));
    let optics: Vec<Box<Model>> = vec![Box::new(small())];
    let Err(Error::Config { key, found, .. }) = Printing::new(optics, schedule, material, None)
    else {
        panic!("it was accepted")
    };
    assert!(
        key == "light[0].frames" && found.contains("11") && found.contains("12"),
        "{found}"
    );
}
