//! Waves and incoherent cones on a card beside those of the processor.

use crate::common::{SMALL, gpu};
use crate::portable::assert_portable;
use crate::scene::{assert_doses_and_pullbacks, assert_near, noise_of, pullback, some_dark};
use std::collections::BTreeMap;
use tomolith_core::check;
use tomolith_core::dose::form::Form;
use tomolith_core::dose::waves::{Transfer, WaveLight};
use tomolith_core::dose::{Accelerator, Quantity, Work};
use tomolith_core::error::Error;
use tomolith_core::field::Field;
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_gpu::{Gpu, model_on};
use tomolith_models::HostModel;
use tomolith_models::masked::MaskedModel;
use tomolith_models::wave::{self, Entrance, Params, WaveModel, incoherent_cone};
use tomolith_optics::light::Light;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::index_matched::IndexMatched;

const VIAL: IndexMatched = IndexMatched { radius_mm: 0.02 };

/// Room for voxels of some tenths of a millimeter.
const WIDE: IndexMatched = IndexMatched { radius_mm: 10.0 };

/// A model of the processor.
struct Case {
    name: &'static str,
    host: HostModel,
    form: Form,
    /// The smallest bindings that it fits.
    binding: u64,
}

/// Frames of 14 × 18 pixels of 0.8 µm, not all of them active.
fn light(frames: usize) -> Light {
    let pixels = PatternGrid::full_turn(frames, 0.3, 14, 18, 0.8e-3);
    let mut light = Light::new(pixels, Resin::absorbing(1.5, 20.0));
    light.pixels.offset_mm = [0.3e-3, -0.2e-3];
    let work = |i: usize| ((i % 3) as u32, (11 - i % 4) as u32);
    light.active = Some((0..frames * 18).map(work).collect());
    light
}

/// The same in resin that takes nothing.
fn clear(frames: usize) -> Light {
    Light {
        resin: Resin::pure_radon(1.5),
        ..light(frames)
    }
}

/// 7 × 9 × 10 voxels of 0.8 µm, off the axis and off the rows.
fn grid() -> VolumeGrid {
    VolumeGrid::centered([7, 9, 10], 0.8e-3).about([0.5e-3, -0.3e-3, 0.15e-3])
}

impl Case {
    fn new(name: &'static str, host: impl WaveModel + 'static, binding: u64) -> Self {
        Case {
            name,
            form: host.data().unwrap(),
            host: Box::new(host),
            binding,
        }
    }
}

fn waves(name: &'static str, lights: Vec<Light>, params: &Params, grid: VolumeGrid) -> Case {
    let vial = if grid.shape[2] > 40 { WIDE } else { VIAL };
    let host = wave::model(&vial, lights, params, grid).unwrap();
    Case::new(name, host, 1 << 20)
}

fn cases() -> Vec<Case> {
    let plain = Params::default();
    let turning = Light {
        sub_angles: 3,
        ..light(4)
    };
    let focused = |focus_mm| Params {
        focus_mm,
        numerical_aperture: Some(0.2),
        ..Params::default()
    };
    let modes = Params {
        etendue_deg: 3.0,
        rings: Some(1),
        entrance: Entrance::Plane,
        ..Params::default()
    };
    let exact = Params {
        relative_error: 1e-4,
        ..Params::default()
    };
    let coarse = Params {
        relative_error: 0.1,
        rotation_error: 0.5,
        numerical_aperture: Some(0.1),
        ..Params::default()
    };
    let large = Light::new(
        PatternGrid::full_turn(3, 0.2, 20, 64, 1.6e-3),
        Resin::absorbing(1.5, 5.0),
    );
    let long = VolumeGrid::centered([3, 2, 64], 0.8e-3).about([0.5e-3, 0.0, 0.0]);
    let cone = incoherent_cone::Params {
        half_angle_deg: 8.0,
        focus_mm: 1e-3,
        ..incoherent_cone::Params::default()
    };
    let cones = incoherent_cone::model(&VIAL, vec![light(3), clear(2)], &cone, grid());
    vec![
        waves("plain, turning frames", vec![turning], &plain, grid()),
        waves(
            "voxels of half the rows",
            vec![light(3)],
            &focused(2e-3),
            grid().refined(2),
        ),
        waves("a far focal plane", vec![light(3)], &focused(0.1), grid()),
        waves(
            "modes, two lights",
            vec![light(3), clear(2)],
            &modes,
            grid(),
        ),
        waves("fields between depths", vec![clear(3)], &exact, long),
        waves(
            "closer samples both ways",
            vec![large],
            &plain,
            VolumeGrid::centered([16, 60, 60], 1.6e-3),
        ),
        // Several pieces of patterns and of the dose, batches of a few frames
        Case {
            binding: 16 << 10,
            ..waves(
                "pieces",
                vec![light(40)],
                &coarse,
                VolumeGrid::centered([2, 24, 24], 0.8e-3),
            )
        },
        Case::new("cones, two lights", cones.unwrap(), SMALL),
    ]
}

impl Case {
    /// The model on a card, with fields of the host.
    fn on(&self, gpu: &Gpu) -> HostModel {
        let model = gpu.model(&self.form, &Work::new());
        let model = model.unwrap_or_else(|e| panic!("{}: {e}", self.name));
        model.unwrap()
    }
}

#[test]
fn cases_have_all_that_a_form_may_have() {
    let lights = |case: Case| match &case.form {
        Form::Waves(form) => form.geometry.lights.clone(),
        other => panic!("{}: {other:?}", case.name),
    };
    let lights: Vec<WaveLight> = cases().into_iter().flat_map(lights).collect();
    let some = |what: &str, has: &dyn Fn(&WaveLight) -> bool| {
        assert!(lights.iter().any(has), "no light has {what}");
    };
    some("fields between depths", &|l| l.back.len() < l.forth.len());
    some("closer samples across", &|l| l.closer[0].is_some());
    some("closer samples along", &|l| l.closer[1].is_some());
    some("modes", &|l| l.modes.len() > 1);
    some("sub-angles", &|l| l.rotation.sub_angles > 1);
    some("samples seen from both ends", &|l| {
        l.rotation.along.1.is_turned
    });
    some("attenuation from a plane", &|l| l.rotation.wall.is_none());
    some("real transfer functions", &|l| {
        matches!(l.modes[0].transfer, Transfer::Each(_))
    });
}

#[test]
fn doses_pullbacks_and_lines_are_those_of_the_processor() {
    for case in cases() {
        let Some(gpu) = gpu(case.binding) else { return };
        let (name, work) = (case.name, Work::new());
        let models = [&case.host, &case.on(&gpu)];
        let [x, d] = [1, 2].map(|seed| check::noisy_patterns(&**models[0], seed));
        let alike = |found: &[f32], expected: &[f32]| assert_near(found, expected, 1e-5, name);
        assert_doses_and_pullbacks(models.map(|model| &**model), &x, 1..3, alike);
        let [expected, found] = models.map(|model| model.along(&x, &d, &work).unwrap().unwrap());
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(&expected) {
            alike(found.as_slice(), expected.as_slice());
        }
    }
}

#[test]
fn the_pullback_is_the_derivative_and_the_line_is_exact() {
    for case in cases() {
        let Some(gpu) = gpu(case.binding) else { return };
        let model = case.on(&gpu);
        let [x, d] = [1, 2].map(|seed| check::noisy_patterns(&*model, seed));
        let cotangent = noise_of(model.outputs(), 3);
        let at = |step: f32| {
            let mut place = x.clone();
            place.axpy(step, &d);
            check::dose(&*model, &place)
        };
        // The central difference of a quadratic is its slope, whatever the step
        let [less, here, more] = [-1.0, 0.0, 1.0].map(at);
        let slope = pullback(&*model, &x, &cotangent).dot(&d);
        let difference = 0.5 * (more.dot(&cotangent) - less.dot(&cotangent));
        let size = more.norm() * cotangent.norm();
        let error = (slope - difference).abs() / size;
        assert!(
            error < 1e-6,
            "{}: {slope} {difference} of {size}",
            case.name
        );
        let terms = model.along(&x, &d, &Work::new()).unwrap().unwrap();
        let mut sum = here;
        terms.iter().for_each(|term| sum.axpy(1.0, term));
        assert_near(sum.as_slice(), more.as_slice(), 2e-6, case.name);
    }
}

#[test]
fn dark_pixels_and_a_factor_are_those_of_the_masked_model() {
    for case in cases().into_iter().step_by(7) {
        let Some(gpu) = gpu(case.binding) else { return };
        let pixels = case.host.new_patterns().unwrap().len();
        let dark = some_dark(pixels);
        // The factor of amplitudes, or of energies
        let is_amplitude = case.host.quantity() == Quantity::Amplitude;
        let form = case
            .form
            .masked(&dark, if is_amplitude { 0.7 } else { 0.49 });
        let host: HostModel = Box::new(MaskedModel::new(case.host, dark, 0.49));
        let card = gpu.model(&form, &Work::new()).unwrap().unwrap();
        let x = check::noisy_patterns(&*host, 1);
        let cotangent = noise_of(host.outputs(), 2);
        let alike = |found: &[f32], expected: &[f32]| assert_near(found, expected, 1e-5, case.name);
        assert_doses_and_pullbacks([&*host, &*card], &x, 1..3, alike);
        let found = pullback(&*card, &x, &cotangent);
        // The same bits again, of another model of the form with fields of the card
        let again = model_on(&gpu, &form, &Work::new()).unwrap();
        let mut there = again.new_patterns().unwrap();
        there.copy_from_host(x.as_slice());
        let bits = |v: &[f32]| v.iter().map(|v| v.to_bits()).collect::<Vec<u32>>();
        let dose = check::dose(&*again, &there).to_host();
        assert_eq!(bits(&dose), bits(check::dose(&*card, &x).as_slice()));
        assert_eq!(
            bits(pullback(&*card, &x, &cotangent).as_slice()),
            bits(found.as_slice())
        );
    }
}

#[test]
fn kernels_are_those_of_other_interfaces_too() {
    let mut sources = BTreeMap::new();
    for case in cases() {
        let Some(gpu) = gpu(case.binding) else { return };
        let model = case.on(&gpu);
        let x = check::noisy_patterns(&*model, 1);
        let dose = check::dose(&*model, &x);
        pullback(&*model, &x, &dose);
        model.along(&x, &x, &Work::new()).unwrap();
        sources.extend(gpu.sources());
    }
    assert!(sources.len() > 50, "{}", sources.len());
    assert_portable(&sources);
}

#[test]
fn a_frame_that_no_binding_holds_is_refused() {
    let case = &cases()[5];
    let Some(gpu) = gpu(SMALL) else { return };
    let refused = gpu.model(&case.form, &Work::new()).err().unwrap();
    assert!(matches!(refused, Error::Resources { .. }), "{refused}");
    assert!(refused.to_string().contains("--device cpu"), "{refused}");
}
