//! Doses and adjoints of rays on a card beside those of the processor.

use crate::common::{SMALL, gpu, smaller};
use crate::scene::{
    Case, assert_doses_and_pullbacks, assert_near, assert_one_matrix, assert_portable_kernels,
    assert_too_large, cone, glass, pixels, square, with_dark_ends,
};
use std::sync::Arc;
use tomolith_core::check;
use tomolith_core::dose::form::Form;
use tomolith_core::dose::{Accelerator, DoseModel, Work};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_core::kind::Section;
use tomolith_gpu::model_on;
use tomolith_models::rays::accumulation::Accumulation;
use tomolith_models::rays::{Optics, Params, Rays};
use tomolith_optics::absorption_map::AbsorptionMap;
use tomolith_optics::light::Light;
use tomolith_optics::motion::Motion;
use tomolith_optics::projector::diverging::Diverging;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::index_matched::IndexMatched;
use tomolith_target::phantom::Phantom;
use tomolith_target::{Placement, Shape};

/// Bindings of all voxels of a case, but not of its cells.
const CELLS: u64 = 84 << 10;

/// A full turn of frames whose pixels are not all active.
fn light(frames: usize, absorption_per_mm: f64) -> Light {
    let resin = Resin::absorbing(1.48, absorption_per_mm);
    with_dark_ends(Light::new(pixels(frames), resin))
}

fn ball() -> Arc<dyn Shape> {
    let sphere = serde_json::json!({"sphere": {"size_mm": 1.3}});
    let placement = Placement {
        offset_mm: [0.12, -0.07, 0.04],
        ..Placement::default()
    };
    let section = Section::new("target.phantom", sphere);
    Arc::new(Phantom::build(&section, &placement, "target").unwrap())
}

fn cases() -> Vec<Case<Params>> {
    let case = |name, vial, light, optics| {
        let grid = VolumeGrid::centered([18, 25, 26], 0.09);
        let params = Params::default();
        Case::new(name, params, vial, vec![light], vec![optics], grid)
    };
    let off_axis = Optics {
        motion: Motion {
            offset_mm: [0.1, -0.05],
            axis_runout_mm: 0.03,
            axis_runout_rad: 0.4,
            ..Motion::default()
        },
        ..Optics::collimated(0.1)
    };
    let diverging = Optics {
        projector: Arc::new(Diverging::new([0.1; 2], 12.0)),
        ..Optics::collimated(0.1)
    };
    let clear = Light {
        resin: Resin::pure_radon(1.48),
        ..light(4, 0.3)
    };
    let turning = Light {
        sub_angles: 3,
        ..light(5, 0.3)
    };
    let values: Vec<f32> = (0..60).map(|i| 0.1 + 0.05 * (i * 7 % 13) as f32).collect();
    let map = AbsorptionMap::new([3, 4, 5], 0.5, values.clone(), values).unwrap();
    let uneven = Light {
        map: Some(Arc::new(map)),
        ..light(4, 0.3)
    };
    let mut aside = VolumeGrid::centered([18, 25, 26], 0.09);
    aside.center_mm = [0.2, -0.1, 0.15];
    vec![
        case("a cone in glass", glass(), light(7, 0.3), cone()),
        case(
            "tilted light",
            glass(),
            light(5, 0.2),
            Optics::collimated(0.1).tilted(0.12),
        ),
        case(
            "a square vial",
            square(),
            light(5, 0.3),
            Optics::collimated(0.1),
        ),
        case("level light off the axis", glass(), light(5, 0.3), off_axis),
        Case {
            grid: aside,
            ..case(
                "turning frames, voxels aside",
                glass(),
                turning,
                diverging.clone().tilted(0.12),
            )
        },
        Case {
            params: Params {
                reflections: true,
                ..Params::default()
            },
            ..case(
                "reflections in a square vial",
                square(),
                light(3, 0.3),
                cone(),
            )
        },
        Case {
            lights: vec![light(4, 0.3), clear],
            optics: vec![diverging, cone().tilted(0.05)],
            ..case(
                "two lights",
                Box::new(IndexMatched { radius_mm: 1.7 }),
                light(1, 0.3),
                cone(),
            )
        },
        Case {
            solid: Some(ball()),
            binding: CELLS,
            ..case("surface cells", glass(), light(4, 0.3), cone())
        },
        case("an absorption map", glass(), uneven, cone()),
        // More than half of the light is left in a voxel
        case("dense resin", square(), light(4, 9.0), cone()),
        Case {
            grid: VolumeGrid::centered([1, 25, 26], 0.09),
            ..case("a single slice", glass(), light(5, 0.3), cone())
        },
    ]
}

impl Case<Params> {
    /// Every ray by itself: those of columns share the shares of slices, which are right to 1e-5.
    fn host(&self) -> Rays {
        let lights = self.lights.clone();
        let grid = self.grid.clone();
        let rays = Rays::new(&*self.vial, lights, &self.optics, &self.params, grid);
        let rays = rays.unwrap().plain();
        match self.with(|input| input.cells.clone()) {
            Some(cells) => rays.with_cells(cells),
            None => rays,
        }
    }

    fn form(&self) -> Form {
        self.form_of(&self.params).unwrap()
    }
}

/// In the mean within 1e-5, and 3e-5 where cells are small parts of voxels. A face along which a ray hardly slants is crossed δ/slope early or late, where coordinates are wrong by δ: on the processor
/// 1e-6 of a voxel in these grids, too; so single values may differ by more.
fn assert_alike(found: &[f32], expected: &[f32], case: &Case<Params>) {
    assert_near(found, expected, 5e-5, case.name);
    let difference = check::difference(found, expected);
    let allowed = if case.solid.is_some() { 3e-5 } else { 1e-5 };
    assert!(difference < allowed, "{}: {difference}", case.name);
}

#[test]
fn doses_and_adjoints_are_those_of_the_processor() {
    // Small bindings, and those that every card has
    for most in [SMALL, 128 << 20] {
        for case in cases() {
            let Some(gpu) = gpu(most.max(case.binding)) else {
                return;
            };
            let host: &dyn DoseModel<Field = HostField> = &case.host();
            let card = gpu.model(&case.form(), &Work::new()).unwrap().unwrap();
            let card = &*card;
            assert_eq!(card.patterns(), host.patterns());
            let updates = card.updates() as f64 / host.updates() as f64;
            assert!((updates - 1.0).abs() < 1e-3, "{}: {updates}", case.name);
            // Of either sign, as a search has them
            let (noisy, even) = (
                check::noisy_patterns(host, 1),
                check::even_patterns(host, 1.0),
            );
            for x in [noisy, even] {
                assert_doses_and_pullbacks([host, card], &x, 1..3, |found, expected| {
                    assert_alike(found, expected, &case);
                });
            }
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
        assert_one_matrix(model, &dark, 1e-6, case.name);
    }
}

/// What the largest pixel is does not matter to the dose of others: a deposit is rounded to 2⁻³⁰ of the largest.
#[test]
fn a_faint_pixel_beside_a_bright_one_has_its_dose() {
    let Some(gpu) = gpu(128 << 20) else { return };
    let case = &cases()[0];
    let model = &*model_on(&gpu, &case.form(), &Work::new()).unwrap();
    let mut values = vec![0.0; model.new_patterns().unwrap().len()];
    let dose = |values: &[f32]| {
        let mut x = model.new_patterns().unwrap();
        x.copy_from_host(values);
        check::dose(model, &x).to_host()
    };
    values[250] = 1.0;
    let bright = dose(&values);
    values[1270] = 1e-3;
    let both = dose(&values);
    values[250] = 0.0;
    let faint = dose(&values);
    let left: Vec<f32> = both.iter().zip(&bright).map(|(a, b)| a - b).collect();
    // f32 next to a dose of the bright one
    assert_near(&left, &faint, 3e-4, "faint");
}

/// Mesa's software adapter ends a thread that takes too long, without a word.
#[test]
fn every_ray_of_a_pixel_with_many_is_followed() {
    let Some(gpu) = gpu(128 << 20) else { return };
    let mut case = cases().swap_remove(0);
    case.params.rays_per_pixel = 4096;
    case.lights[0].pixels = PatternGrid::full_turn(2, 0.1, 2, 2, 0.1);
    case.lights[0].active = None;
    let host: &dyn DoseModel<Field = HostField> = &case.host();
    let card = gpu.model(&case.form(), &Work::new()).unwrap().unwrap();
    let x = check::even_patterns(host, 1.0);
    assert_doses_and_pullbacks([host, &*card], &x, 1..2, |found, expected| {
        assert_alike(found, expected, &case);
    });
}

#[test]
fn what_is_no_number_leaves_no_number() {
    let Some(gpu) = gpu(128 << 20) else { return };
    let model = &*model_on(&gpu, &cases()[0].form(), &Work::new()).unwrap();
    for bad in [f32::NAN, f32::INFINITY] {
        let mut values = vec![1.0; model.new_patterns().unwrap().len()];
        values[77] = bad;
        let mut x = model.new_patterns().unwrap();
        x.copy_from_host(&values);
        let dose = check::dose(model, &x).to_host();
        assert!(dose.iter().any(|v| !v.is_finite()));
    }
}

/// Every kernel of rays, in the languages of Metal and DX12.
#[test]
fn kernels_are_those_of_other_interfaces_too() {
    let Some(gpu) = gpu(CELLS) else { return };
    let forms: Vec<Form> = cases().iter().map(|case| case.form()).collect();
    let names = ["dose of rays", "sums of rays in cells", "adjoint of rays"];
    assert_portable_kernels(&gpu, &forms, &names);
}

#[test]
fn what_does_not_fit_is_refused_and_what_is_random_has_no_form() {
    let case = &cases()[0];
    let Some(small) = smaller(SMALL, 1 << 16) else {
        return;
    };
    assert_too_large(&small, &case.form());
    let random = Params {
        accumulation: Accumulation::Simple,
        ..Params::default()
    };
    assert!(case.form_of(&random).is_none());
}
