//! Random paths of scattered light on a card beside those of the processor.

use crate::common::{SMALL, gpu, smaller};
use crate::scene::{
    Case, assert_near, assert_one_matrix, assert_portable_kernels, assert_too_large, cone, glass,
    pixels, scattering, square, with_dark_ends,
};
use tomolith_core::check;
use tomolith_core::dose::form::Form;
use tomolith_core::dose::{Accelerator, DoseLayout, Work};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_core::units::Mm;
use tomolith_gpu::{Gpu, model_on};
use tomolith_models::monte_carlo::{self, Params};
use tomolith_models::rays::accumulation::Accumulation;
use tomolith_models::rays::{Optics, Rays};
use tomolith_models::{HostModel, Purpose};
use tomolith_optics::light::Light;
use tomolith_optics::phase::Phase;
use tomolith_optics::phase::henyey_greenstein::HenyeyGreenstein;
use tomolith_optics::phase::isotropic::Isotropic;
use tomolith_optics::phase::rayleigh::Rayleigh;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::double_tube::DoubleTube;
use tomolith_optics::vial::ended::{End, Ended};
use tomolith_optics::vial::index_matched::IndexMatched;

/// What scatters, 1/mm, in resin that absorbs 0.1/mm.
const MILK: f64 = 0.6;

fn light(frames: usize) -> Light {
    let mut light = Light::new(pixels(frames), Resin::absorbing(1.48, 0.1));
    light.resin.attenuation_per_mm += MILK;
    with_dark_ends(light)
}

/// Level light, scattered by such resin.
fn milk(phase: impl Phase + 'static) -> Optics {
    scattering(phase, MILK)
}

fn cases() -> Vec<Case<Params>> {
    let case = |name, vial, optics| {
        let grid = VolumeGrid::centered([18, 25, 26], 0.09);
        let (params, lights) = (Params::default(), vec![light(4)]);
        Case {
            purpose: Purpose::Optimize,
            ..Case::new(name, params, vial, lights, vec![optics], grid)
        }
    };
    let foggy = Optics {
        projector: cone().projector,
        ..milk(Isotropic {})
    };
    let plate = End {
        z_mm: Mm(-0.6),
        thickness_mm: Mm(0.2),
    };
    let lid = End {
        z_mm: Mm(0.7),
        thickness_mm: Mm(0.0),
    };
    let ended = Ended::new(glass(), Some(plate), Some(lid)).unwrap();
    let matched = || Box::new(IndexMatched { radius_mm: 1.7 });
    let clear = Light {
        resin: Resin::absorbing(1.48, 0.3),
        ..light(3)
    };
    vec![
        case(
            "forward light in glass",
            glass(),
            milk(HenyeyGreenstein { g: 0.7 }),
        ),
        case("a cone", matched(), foggy),
        Case {
            lights: vec![Light {
                sub_angles: 3,
                ..light(4)
            }],
            ..case(
                "turning frames of a square vial",
                square(),
                milk(Rayleigh {}),
            )
        },
        case(
            "a vial with ends",
            Box::new(ended),
            milk(HenyeyGreenstein { g: -0.3 }),
        ),
        Case {
            lights: vec![light(3), clear, light(2)],
            optics: vec![
                milk(Rayleigh {}).tilted(0.1),
                Optics::collimated(0.1),
                milk(Isotropic {}),
            ],
            ..case(
                "three lights, one of them clear",
                matched(),
                Optics::collimated(0.1),
            )
        },
        Case {
            purpose: Purpose::Evaluate { refine: 1 },
            params: Params {
                paths_per_pixel: 1,
                least_power: 0.3,
                ..Params::default()
            },
            ..case("sharpened cells", glass(), milk(Rayleigh {}))
        },
    ]
}

impl Case<Params> {
    fn card(&self, gpu: &Gpu, params: &Params) -> HostModel {
        let form = self.form_of(params).unwrap();
        gpu.model(&form, &Work::new()).unwrap().unwrap()
    }

    fn seeded(&self, seed: u64) -> Params {
        Params {
            seed,
            ..self.params.clone()
        }
    }
}

/// A card with bindings that hold the cells of a case, but not its voxels.
fn small() -> Option<Gpu> {
    gpu(SMALL)
}

#[test]
fn dose_and_adjoint_on_the_card_are_one_matrix_of_a_seed() {
    for case in cases() {
        let Some(gpu) = small() else { return };
        let dark = case.some_dark();
        let model_of = |seed| {
            let form = case.form_of(&case.seeded(seed)).unwrap().masked(&dark, 0.7);
            model_on(&gpu, &form, &Work::new()).unwrap()
        };
        let model = &*model_of(1);
        let [x, dose] = assert_one_matrix(model, &dark, 1e-6, case.name);
        // The same bits of a model that is made again; another seed is another matrix
        assert_eq!(check::dose(&*model_of(1), &x).to_host(), dose.to_host());
        assert_ne!(check::dose(&*model_of(2), &x).to_host(), dose.to_host());
    }
}

#[test]
fn unscattered_light_is_that_of_the_processor() {
    let Some(gpu) = small() else { return };
    for case in cases() {
        let params = Params {
            orders: 0,
            ..case.params.clone()
        };
        let (host, card) = (case.host_of(&params), case.card(&gpu, &params));
        assert_eq!(card.patterns(), host.patterns());
        let x = check::noisy_patterns(&*host, 1);
        let [expected, found] = [&host, &card].map(|model| check::dose(&**model, &x));
        assert_near(found.as_slice(), expected.as_slice(), 5e-5, case.name);
        let difference = check::difference(found.as_slice(), expected.as_slice());
        assert!(difference < 1e-5, "{}: {difference}", case.name);
    }
}

/// Sums of a dose with weights that even, odd, flat and steep errors of scattered light change.
fn moments(case: &Case<Params>, dose: &HostField) -> Vec<f64> {
    let grid = &case.grid;
    let volume = DoseLayout::new("dose", grid.clone(), 0).volume_of(dose.as_slice());
    let mut sums = vec![0.0; 5];
    let [nz, ny, nx] = grid.shape;
    for (i, value) in volume.values.iter().enumerate() {
        let (x, y, z) = (grid.x(i % nx), grid.y(i / nx % ny), grid.z(i / nx / ny));
        let weights = [
            1.0,
            f64::from(u8::from(x.hypot(y) < 0.8)),
            f64::from(u8::from(z.abs() > 0.25 * nz as f64 * grid.pitch_mm)),
            1.0 + x,
            1.0 + (4.0 * y).cos(),
        ];
        let pairs = sums.iter_mut().zip(weights);
        pairs.for_each(|(sum, weight)| *sum += weight * f64::from(*value));
    }
    sums
}

/// Mean and its standard deviation of moments of scattered light, from several seeds.
fn scattered(
    case: &Case<Params>,
    seeds: u64,
    model: &dyn Fn(&Params) -> HostModel,
) -> Vec<[f64; 2]> {
    let x = check::even_patterns(&*case.host_of(&case.params), 1.0);
    let moments_of = |params: &Params| moments(case, &check::dose(&*model(params), &x));
    let straight = moments_of(&Params {
        orders: 0,
        ..case.params.clone()
    });
    let all: Vec<Vec<f64>> = (1..=seeds)
        .map(|seed| moments_of(&case.seeded(seed)))
        .collect();
    let count = seeds as f64;
    let mean_of = |i: usize| {
        let values = || all.iter().map(|sums| sums[i] - straight[i]);
        let mean = values().sum::<f64>() / count;
        let squares: f64 = values().map(|v| (v - mean).powi(2)).sum();
        [mean, (squares / (count - 1.0) / count).sqrt()]
    };
    (0..straight.len()).map(mean_of).collect()
}

#[test]
fn scattered_light_is_that_of_the_processor_within_the_noise_of_both() {
    /// Of either.
    const SEEDS: u64 = 12;
    let Some(gpu) = gpu(128 << 20) else { return };
    for case in cases() {
        let host = scattered(&case, SEEDS, &|params| case.host_of(params));
        let card = scattered(&case, SEEDS, &|params| case.card(&gpu, params));
        for (i, ([expected, a], [found, b])) in host.into_iter().zip(card).enumerate() {
            let (noise, name) = (a.hypot(b), case.name);
            let what = format!("{name}, {i}: {found} ± {b} in place of {expected} ± {a}");
            assert!((found - expected).abs() < 3.0 * noise, "{what}");
            // An error of 2 % would be found
            assert!(3.0 * noise < 0.02 * expected, "{what}");
        }
    }
}

#[test]
fn what_paths_leave_in_all_of_the_resin_is_what_the_balance_says() {
    let Some(gpu) = gpu(128 << 20) else { return };
    let mut case = cases().swap_remove(3);
    // Even light through the middle of a vial that ends within the grid
    case.lights[0].pixels = PatternGrid::full_turn(3, 0.2, 3, 3, 0.2);
    case.lights[0].active = None;
    case.grid = VolumeGrid::centered([30, 44, 44], 0.1);
    let params = Params {
        paths_per_pixel: 1024,
        smooth: 1,
        ..case.params.clone()
    };
    let (vial, lights, optics) = (&*case.vial, &case.lights, &case.optics);
    let rays: Rays = monte_carlo::model(vial, lights, optics, &params, case.grid.clone()).unwrap();
    let card = case.card(&gpu, &params);
    let dose = check::dose(&*card, &check::even_patterns(&*card, 1.0));
    let left: f64 = dose.as_slice().iter().map(|&v| f64::from(v)).sum();
    let sent = 3.0 * 9.0 * 0.04;
    let frames = (0..3).map(|frame| rays.balance(0, frame).absorbed);
    let expected = frames.sum::<f64>() / 3.0;
    let found = left * 1e-3 / sent;
    // 27 648 paths, whose parts absorbed are spread by less than 0.2
    assert!(
        (found - expected).abs() < 3.0 * 0.2 / 27_648f64.sqrt() * 2f64.sqrt(),
        "{found} {expected}"
    );
}

#[test]
fn paths_are_drawn_anew_and_are_the_same_again_in_the_same_round() {
    let Some(gpu) = small() else { return };
    let case = &cases()[0];
    let params = |seed, renew| Params {
        renew,
        ..case.seeded(seed)
    };
    let model = case.card(&gpu, &params(u64::from(u32::MAX), 2));
    let x = check::even_patterns(&*model, 1.0);
    let first = check::dose(&*model, &x);
    let renewal = model.renewal().unwrap();
    let renew = |iteration| renewal.renew(iteration, &x, &Work::new()).unwrap();
    assert!(!renew(2) && renew(3) && !renew(4));
    let second = check::dose(&*model, &x);
    assert_ne!(first.as_slice(), second.as_slice());
    // The next seed, with a carry
    let next = case.card(&gpu, &params(1 << 32, 0));
    assert_eq!(check::dose(&*next, &x).as_slice(), second.as_slice());
    assert!(next.renewal().is_none());
    assert!(renew(1));
    assert_eq!(check::dose(&*model, &x).as_slice(), first.as_slice());
}

/// Every kernel of paths, in the languages of Metal and DX12.
#[test]
fn kernels_are_those_of_other_interfaces_too() {
    let Some(gpu) = small() else { return };
    let form = |case: Case<Params>| case.form_of(&case.params).unwrap();
    let forms: Vec<Form> = cases().into_iter().map(form).collect();
    let names = ["dose of paths", "sums of rays", "adjoint of paths"];
    assert_portable_kernels(&gpu, &forms, &names);
}

#[test]
fn what_is_no_number_leaves_no_number() {
    let Some(gpu) = gpu(128 << 20) else { return };
    let model = cases()[0].card(&gpu, &cases()[0].params);
    for bad in [f32::NAN, f32::INFINITY] {
        let mut x = check::even_patterns(&*model, 1.0);
        x.as_mut_slice()[77] = bad;
        let dose = check::dose(&*model, &x);
        assert!(dose.as_slice().iter().any(|v| !v.is_finite()));
    }
}

#[test]
fn what_does_not_fit_is_refused_and_what_a_form_cannot_say_has_none() {
    let case = &cases()[0];
    let Some(small) = smaller(SMALL, 1 << 16) else {
        return;
    };
    assert_too_large(&small, &case.form_of(&case.params).unwrap());
    let fine = Params {
        smooth: 1,
        ..case.params.clone()
    };
    let Some(tight) = gpu(16 << 10) else { return };
    assert_too_large(&tight, &case.form_of(&fine).unwrap());
    for params in [
        Params {
            accumulation: Accumulation::Simple,
            ..case.params.clone()
        },
        Params {
            reflections: true,
            ..case.params.clone()
        },
    ] {
        assert!(case.form_of(&params).is_none());
    }
    let tube = Case {
        vial: Box::new(DoubleTube::new([1.6, 1.5, 0.7, 0.6], [1.5, 1.5, 1.33])),
        ..cases().swap_remove(0)
    };
    assert!(tube.form_of(&tube.params).is_none());
}
