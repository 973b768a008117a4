//! Doses, adjoints, losses and whole optimizations of models of parallel light.

use crate::common::{SMALL, gpu, smaller};
use crate::portable::assert_portable;
use crate::scene::{
    Case, assert_doses_and_pullbacks, assert_near, assert_one_matrix, scattering, with_dark_ends,
};
use std::collections::BTreeMap;
use std::sync::Arc;
use tomolith_core::check;
use tomolith_core::dose::form::Form;
use tomolith_core::dose::{Accelerator, DoseModel, Work};
use tomolith_core::field::Field;
use tomolith_core::grid::{PatternGrid, Volume, VolumeGrid};
use tomolith_core::kind::{Kind, Section};
use tomolith_core::response::{Identity, Response};
use tomolith_core::target::{Target, label_voxels};
use tomolith_gpu::model_on;
use tomolith_models::rays::Optics;
use tomolith_models::{Family, HostModel, parallel, successive_orders};
use tomolith_objective::{ObjectiveInput, objectives};
use tomolith_optics::light::Light;
use tomolith_optics::phase::Phase;
use tomolith_optics::phase::henyey_greenstein::HenyeyGreenstein;
use tomolith_optics::phase::rayleigh::Rayleigh;
use tomolith_optics::projector::telecentric::Telecentric;
use tomolith_optics::random::Stream;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::Vial;
use tomolith_optics::vial::cylinder::Cylinder;
use tomolith_optics::vial::double_tube::DoubleTube;
use tomolith_optics::vial::index_matched::IndexMatched;
use tomolith_optimize::start::starts;
use tomolith_optimize::{Limits, Problem, StartInput, Stop, optimizers};

fn cases() -> Vec<Case<Family>> {
    let matched = || Box::new(IndexMatched { radius_mm: 1.6 }) as Box<dyn Vial>;
    let glass = || -> Box<dyn Vial> { Box::new(Cylinder::new(1.3, 1.6, 1.58)) };
    let tube = Box::new(DoubleTube::new([1.6, 1.5, 0.7, 0.6], [1.5, 1.5, 1.33]));
    let absorbing = Resin::absorbing(1.4849, 0.4);
    let pixels = |frames, rows, columns| PatternGrid::full_turn(frames, 0.1, rows, columns, 0.1);
    let light = |pixels, resin| with_dark_ends(Light::new(pixels, resin));
    let grid = |nz| VolumeGrid::centered([nz, 31, 32], 0.09);
    let turning = Light {
        sub_angles: 3,
        ..light(pixels(9, 30, 34), absorbing)
    };
    let clear = |lights: &[Light]| vec![Optics::collimated(0.1); lights.len()];
    let straight = |name, vial, lights: Vec<Light>, grid| {
        let (params, optics) = (Arc::new(parallel::Params::default()), clear(&lights));
        Case::new(name, params as Family, vial, lights, optics, grid)
    };
    vec![
        straight(
            "pure Radon, frames in pairs",
            matched(),
            vec![light(pixels(12, 26, 40), Resin::pure_radon(1.5))],
            grid(24),
        ),
        straight(
            "absorbing, slices finer than rows",
            matched(),
            vec![light(pixels(10, 14, 36), absorbing)],
            VolumeGrid::centered([70, 31, 32], 0.02),
        ),
        straight("glass, turning frames", glass(), vec![turning], grid(27)),
        // Several pieces of patterns, of the dose and of the kernels of later orders
        Case {
            params: orders(0.4),
            optics: vec![scattering(Rayleigh {}, 0.15)],
            binding: 128 << 10,
            ..straight(
                "scattered light",
                matched(),
                vec![light(pixels(76, 16, 36), absorbing)],
                VolumeGrid::centered([20, 33, 34], 0.09),
            )
        },
        straight(
            "a tube in a tube, two lights",
            tube,
            vec![
                light(pixels(7, 26, 36), absorbing),
                light(pixels(5, 22, 30), absorbing),
            ],
            grid(20),
        ),
        // Kernels of all parities, later orders on larger cells, and a light that is not scattered
        Case {
            params: Arc::new(successive_orders::Params::default()),
            optics: vec![Optics::collimated(0.1), scattering(Forward, 0.7)],
            binding: 8 << 20,
            ..straight(
                "scattered light of the second of two, on small cells in glass",
                glass(),
                vec![
                    light(pixels(5, 22, 30), absorbing),
                    light(pixels(7, 6, 36), Resin::absorbing(1.4849, 3.0)),
                ],
                VolumeGrid::centered([6, 29, 30], 0.09),
            )
        },
        // Harmonics of all degrees, and pixels of a level light beside those of a tilted one
        Case {
            params: orders(0.4),
            optics: vec![Optics {
                projector: Arc::new(Telecentric {
                    pixel_pitch_mm: [0.1; 2],
                    aperture_radius_mm: 3.0,
                    working_distance_mm: 20.0,
                    focus_mm: 0.1,
                }),
                ..scattering(HenyeyGreenstein { g: 0.4 }, 0.15)
            }],
            binding: 1 << 20,
            ..straight(
                "scattered light of a cone",
                glass(),
                vec![light(pixels(11, 16, 36), absorbing)],
                VolumeGrid::centered([20, 33, 34], 0.09),
            )
        },
        Case {
            params: orders(0.4),
            optics: vec![
                scattering(Rayleigh {}, 0.15),
                scattering(Rayleigh {}, 0.2).tilted(0.2),
            ],
            binding: 1 << 20,
            ..straight(
                "scattered light of a level and a tilted light",
                matched(),
                vec![
                    light(pixels(5, 16, 36), absorbing),
                    light(pixels(6, 14, 30), absorbing),
                ],
                VolumeGrid::centered([20, 33, 34], 0.09),
            )
        },
    ]
}

fn orders(cell_mm: f64) -> Family {
    Arc::new(successive_orders::Params {
        cell_mm: Some(cell_mm),
        ..successive_orders::Params::default()
    })
}

/// More light goes on than comes back: moments of degree 1, whose kernels are odd, and no others.
#[derive(Debug)]
struct Forward;

impl Phase for Forward {
    fn density(&self, cosine: f64) -> f64 {
        0.5 + 0.4 * cosine
    }

    fn draw(&self, _: &mut Stream) -> f64 {
        unreachable!("orders draw nothing")
    }
}

impl Case<Family> {
    fn host(&self) -> HostModel {
        self.host_of(&*self.params)
    }

    fn form(&self) -> Form {
        self.form_of(&*self.params).unwrap()
    }

    /// How near doses of both are, and how exact a pair is on a card: rays are sums in another order, from other coordinates (`rays.rs`).
    fn tolerances(&self) -> (f32, f64) {
        match self.form() {
            Form::Strips(_) => (5e-6, 2e-7),
            _ => (5e-5, 1e-6),
        }
    }
}

#[test]
fn doses_and_adjoints_are_those_of_the_processor() {
    // Small bindings; entries that are kept, and entries that are found anew
    for (most, memory) in [(SMALL, u64::MAX), (128 << 20, u64::MAX), (SMALL, 1 << 16)] {
        for case in cases() {
            let Some(gpu) = smaller(most.max(case.binding), memory) else {
                return;
            };
            let (host, form) = (case.host(), case.form());
            if memory == 1 << 16 && !matches!(form, Form::Strips(_)) {
                continue;
            }
            let card = gpu.model(&form, &Work::new()).unwrap().unwrap();
            if let Form::Strips(_) = form {
                let keeps_weights = card.describe().contains("weights, kept");
                assert_eq!(keeps_weights, memory > 1 << 16, "{}", card.describe());
            }
            let (near, _) = case.tolerances();
            let mut x = check::noisy_patterns(&*host, 1);
            x.as_mut_slice().iter_mut().for_each(|v| *v = v.abs());
            assert_doses_and_pullbacks([&*host, &*card], &x, 2..5, |found, expected| {
                assert_near(found, expected, near, case.name);
            });
        }
    }
}

#[test]
fn dose_and_adjoint_on_the_card_are_one_matrix() {
    for case in cases() {
        let Some(gpu) = gpu(case.binding) else { return };
        let dark = case.some_dark();
        let form = case.form().masked(&dark, 0.7);
        let model = &*model_on(&gpu, &form, &Work::new()).unwrap();
        let [_, dose] = assert_one_matrix(model, &dark, case.tolerances().1, case.name);
        assert!(dose.norm() > 0.0);
    }
}

/// The start, the objective and twelve steps of the default method, on the host and on the card.
fn solved<F: Field>(model: &dyn DoseModel<Field = F>) -> (Vec<f32>, Vec<f64>) {
    let grid = model.grid().clone();
    let half = 0.5 * grid.pitch_mm * grid.shape[1] as f64;
    let ring = |[x, y, _]: [f64; 3]| {
        let from_middle = (x.hypot(y) / half - 0.5).abs();
        (1.5 - from_middle / 0.1).clamp(0.0, 1.0) as f32
    };
    let target = Target {
        name: "ring".to_owned(),
        inside: Volume::from_fn(grid, ring),
        gray: false,
    };
    let labels = label_voxels(&target, |[x, y, _]| x.hypot(y) < 0.8 * half);
    let limits = vec![
        Limits {
            min: 0.0,
            max: 40.0
        };
        model.patterns().len()
    ];
    let response: std::sync::Arc<dyn Response> = std::sync::Arc::new(Identity);
    let input = ObjectiveInput {
        layout: &model.outputs()[0],
        labels: &labels,
        target: &target,
        response: response.clone(),
    };
    fn row<B>(rows: &'static [Kind<B>], name: &str) -> &'static Kind<B> {
        rows.iter().find(|row| row.name == name).unwrap()
    }
    let empty = |key: &str| Section::new(key, serde_json::json!({}));
    let objective = (row(objectives::<F>(), "threshold").build)(&empty("objective")).unwrap();
    let objective = objective.make(&input).unwrap();
    let start = StartInput::new(model, &target, &labels, &limits);
    let work = Work::new();
    let of_start = (row(starts::<F>(), "fbp").build)(&empty("start")).unwrap();
    let mut x = of_start
        .patterns(&start, &work)
        .unwrap_or_else(|e| panic!("{}: {e}", model.describe()));
    let mut problem = Problem::new(model, &*objective, &limits, &work).unwrap();
    let method = (row(optimizers::<F>(), "lbfgs").build)(&empty("optimizer")).unwrap();
    let stop = Stop::after(12);
    let mut method = method.make().unwrap();
    let outcome = tomolith_optimize::run(&mut problem, &mut *method, &mut x, &stop, None, &mut []);
    let losses = outcome
        .unwrap()
        .history
        .iter()
        .map(|row| row.loss)
        .collect();
    (x.to_host(), losses)
}

/// Every kernel that an optimization runs, in the languages of Metal and DX12.
#[test]
fn kernels_are_those_of_other_interfaces_too() {
    let mut sources = BTreeMap::new();
    // One has no kernels of its own, and takes long in software
    for (_, case) in cases().into_iter().enumerate().filter(|(i, _)| *i != 5) {
        let Some(gpu) = gpu(case.binding) else { return };
        let model = model_on(&gpu, &case.form(), &Work::new()).unwrap();
        solved(&*model);
        sources.extend(gpu.sources());
    }
    assert!(sources.len() > 25, "{}", sources.len());
    assert_portable(&sources);
}

#[test]
fn a_whole_optimization_goes_the_way_of_the_processor() {
    for case in cases().into_iter().take(4) {
        let Some(gpu) = gpu(case.binding) else { return };
        let (_, expected) = solved(&*case.host());
        let model = model_on(&gpu, &case.form(), &Work::new()).unwrap();
        let (_, found) = solved(&*model);
        assert!(
            expected[12] < 0.7 * expected[0],
            "{}: {expected:?}",
            case.name
        );
        // Rounding grows from step to step, but both get as far
        for (step, tolerance) in [(0, 1e-5), (1, 1e-4), (12, 0.1)] {
            let (found, expected) = (found[step], expected[step]);
            let error = (found - expected).abs() / expected;
            assert!(
                error < tolerance,
                "{}: {found} instead of {expected} after {step}",
                case.name
            );
        }
    }
}
