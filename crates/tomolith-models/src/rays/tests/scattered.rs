//! Rays in a resin that scatters.

use super::*;
use crate::monte_carlo;
use tomolith_core::near;

/// A cube of resin's worth of voxels in a ball of light: all that is scattered is deposited or leaves.
#[test]
fn a_scattering_resin_is_an_exact_pair_whose_energy_is_accounted_for() {
    let smooth = monte_carlo::Params::default().smooth;
    let (mut light, optics, mut params) = milk(&light(4, 5, 9, 0.2), None, smooth);
    params.paths_per_pixel = 8;
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let build = |params: &monte_carlo::Params, light: &Light, grid: &VolumeGrid| {
        let (light, optics) = (std::slice::from_ref(light), std::slice::from_ref(&optics));
        monte_carlo::model(&GLASS, light, optics, params, grid.clone()).unwrap()
    };
    let model = build(&params, &light, &grid);
    let found = check::model::model(&model, 3).unwrap();
    assert!(found.adjoint_error < 1e-6, "{found:?}");
    // Both kernels walk the same paths
    let x = check::even_patterns(&model, 1.0);
    let plain = dose(&build(&params, &light, &grid).plain(), &x);
    let wide = dose(&model, &x);
    assert!(check::largest_difference(&plain.values, &wide.values) < 1e-4);
    // Another seed is another matrix with the same mean
    let other = monte_carlo::Params {
        seed: 2,
        ..params.clone()
    };
    let other = dose(&build(&other, &light, &grid), &x);
    assert_ne!(other, wide);
    let sum = |v: &Volume<f32>| v.values.iter().map(|&v| f64::from(v)).sum::<f64>();
    assert!((sum(&other) / sum(&wide) - 1.0).abs() < 0.02);
    // Reflections at the glass: still a pair, and more of the light stays in the resin
    let mirrored = monte_carlo::Params {
        reflections: true,
        ..params.clone()
    };
    let mirrored = build(&mirrored, &light, &grid);
    let found = check::model::model(&mirrored, 4).unwrap();
    assert!(found.adjoint_error < 1e-6, "{found:?}");
    let balance = mirrored.balance(0, 0);
    assert!((balance.total() - 1.0).abs() < 1e-9, "{balance:?}");
    assert!(balance.reflected == 0.0 && balance.absorbed > 1.02 * model.balance(0, 0).absorbed);
    // Paths are drawn anew after two iterations, and are the same again in the same round
    let renewed = monte_carlo::Params {
        renew: 2,
        ..params.clone()
    };
    let renewed = build(&renewed, &light, &grid);
    let renewal = renewed.renewal().unwrap();
    let renew = |iteration| renewal.renew(iteration, &x, &Work::new()).unwrap();
    assert!(!renew(2) && renew(3));
    let second = dose(&renewed, &x);
    assert!(second != wide && (sum(&second) / sum(&wide) - 1.0).abs() < 0.02);
    assert!(renew(1));
    assert_eq!(dose(&renewed, &x), wide);
    // In a grid that holds all the resin and the cells around it, dose is what the balance says was absorbed
    light.pixels = PatternGrid::full_turn(1, 0.2, 3, 3, 0.2);
    let tall = VolumeGrid::centered([150, 44, 44], 0.1);
    let model = build(&params, &light, &tall);
    let x = check::even_patterns(&model, 1.0);
    let active = sum(&dose(&model, &x)) * 1e-3 / (9.0 * 0.04);
    let balance = model.balance(0, 0);
    assert!((balance.total() - 1.0).abs() < 1e-9);
    near!(active / balance.absorbed, 1.0, 2e-3, "{active} {balance:?}");
}

/// Scattering of the resins below, 1/mm.
const SCATTERED: f64 = 0.8;

/// Light, its optics and paths in a resin that scatters; `map`: its active absorption, given by cell.
fn milk(
    light: &Light,
    map: Option<([usize; 3], f64, Vec<f32>)>,
    smooth: usize,
) -> (Light, Optics, monte_carlo::Params) {
    use tomolith_optics::phase::{Scattering, rayleigh::Rayleigh};
    let mut light = light.clone();
    light.resin.attenuation_per_mm = light.resin.absorption_per_mm + SCATTERED;
    light.map = map.map(|(shape, pitch_mm, active)| {
        let total = active.iter().map(|a| a + SCATTERED as f32).collect();
        Arc::new(AbsorptionMap::new(shape, pitch_mm, active, total).unwrap())
    });
    let mut optics = Optics::collimated(light.pixels.pitch_mm[0]);
    optics.scattering = Some(Scattering::new(SCATTERED, Rayleigh {}));
    let params = monte_carlo::Params {
        smooth,
        ..monte_carlo::Params::default()
    };
    (light, optics, params)
}

#[test]
#[ignore = "slow"]
fn a_resin_that_scatters_and_differs_from_place_to_place_is_an_exact_pair() {
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let [solid, _] = solids(&grid);
    let patches: Vec<f32> = (0..60).map(|i| 0.1 + 0.05 * (i * 7 % 13) as f32).collect();
    let tube = ended().pop();
    for vial in [Box::new(GLASS) as Box<dyn Vial>].into_iter().chain(tube) {
        for smooth in [1, 3] {
            for (shape, pitch_mm, values) in [
                ([3, 4, 5], 0.5, patches.clone()),
                ([1, 4, 5], 0.6, patches[..20].to_vec()),
            ] {
                let map = Some((shape, pitch_mm, values));
                let (mut light, mut optics, mut params) = milk(&light(3, 3, 7, 0.25), map, smooth);
                params.reflections = smooth == 1;
                params.is_sharp = shape[0] > 1;
                optics.motion.tilt_rad = 0.1;
                light.resin.gradient = Some(IndexGradient {
                    quadratic_per_mm2: -0.05,
                    quartic_per_mm4: 0.0,
                    step_mm: 0.2,
                });
                let model = || {
                    let (lights, optics) = ([light.clone()], [optics.clone()]);
                    monte_carlo::model(vial.as_ref(), &lights, &optics, &params, grid.clone())
                        .unwrap()
                };
                for model in [model(), model().with_cells(Arc::clone(&solid))] {
                    let found = check::model::model(&model, 3).unwrap();
                    assert!(found.adjoint_error < 1e-6, "{vial:?} {smooth}: {found:?}");
                    let balance = model.balance(0, 0);
                    assert!((balance.total() - 1.0).abs() < 1e-9, "{balance:?}");
                }
            }
        }
    }
}

#[test]
fn an_even_map_in_a_resin_that_scatters_changes_nothing() {
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    for smooth in [1, 4] {
        let dose_of = |map| {
            let (light, optics, params) = milk(&light(4, 5, 9, 0.2), map, smooth);
            lit(&monte_carlo::model(&GLASS, &[light], &[optics], &params, grid.clone()).unwrap())
        };
        let (plain, mapped) = (
            dose_of(None),
            dose_of(Some(([3, 4, 5], 0.5, vec![0.3; 60]))),
        );
        let off = check::largest_difference(&mapped.values, &plain.values);
        assert!(off < 2e-6, "{smooth}: {off}");
    }
}

#[test]
fn scattered_light_leaves_what_the_map_takes_of_it_on_either_side_of_a_face() {
    // The resin takes 0.05 per mm below x = 0 and 0.6 above, in the middle of cells of four voxels
    let grid = VolumeGrid::centered([150, 44, 44], 0.1);
    let light = light(6, 3, 15, 0.2);
    let planes_of = |smooth: usize| {
        let map = Some(([1, 1, 2], 10.0, vec![0.05, 0.6]));
        let (light, optics, mut params) = milk(&light, map, smooth);
        params.paths_per_pixel = 64;
        let (lights, optics) = ([light], [optics]);
        let model = monte_carlo::model(&GLASS, &lights, &optics, &params, grid.clone()).unwrap();
        let straight = monte_carlo::straight(&GLASS, &lights, &optics, &params, grid.clone());
        let (all, straight) = (lit(&model), lit(&straight.unwrap()));
        let energy: f64 = all.values.iter().map(|&v| f64::from(v)).sum::<f64>() * 1e-3;
        let frames = (0..6).map(|frame| model.balance(0, frame).absorbed);
        let balance = energy / (45.0 * 0.04 * frames.sum::<f64>());
        // Scattered light by planes of x
        let mut planes = [0.0; 44];
        for (i, (all, straight)) in all.values.iter().zip(&straight.values).enumerate() {
            planes[i % 44] += f64::from(all - straight);
        }
        (planes, balance)
    };
    let (exact, whole) = planes_of(1);
    assert!((whole - 1.0).abs() < 1e-3, "{whole}");
    // The dose leaps by what is taken; fluence falls by a tenth in the tenth of a millimeter between these planes
    let leap = exact[22] / exact[21] / 12.0;
    assert!((0.8..1.0).contains(&leap), "{leap} {exact:?}");
    for (smooth, allowed) in [(2, 0.04), (4, 0.08)] {
        let (planes, balance) = planes_of(smooth);
        // Cells reach beyond the wall, where the map goes on
        assert!((balance - 1.0).abs() < 2e-2, "{balance}");
        let error = |x: usize| (planes[x] / exact[x] - 1.0).abs();
        let worst = (12..32).map(error).fold(0.0, f64::max);
        assert!(worst < allowed, "{smooth}: {worst} {exact:?} {planes:?}");
    }
}

#[test]
fn what_cells_smear_out_comes_back_on_either_side_of_the_edge_of_a_pattern() {
    // Rows below z = 0 are lit: scattered light falls off about the edge. Cells of 0.4 mm where a free path is 0.9 mm
    let grid = VolumeGrid::centered([48, 40, 40], 0.1);
    let light = light(12, 24, 20, 0.2);
    let profile_of = |smooth: usize| {
        let (light, optics, mut params) = milk(&light, None, smooth);
        params.paths_per_pixel = 64;
        params.is_sharp = true;
        let (lights, optics) = ([light], [optics]);
        let model = monte_carlo::model(&GLASS, &lights, &optics, &params, grid.clone()).unwrap();
        let straight =
            monte_carlo::straight(&GLASS, &lights, &optics, &params, grid.clone()).unwrap();
        let mut x = model.new_patterns().unwrap();
        for (i, x) in x.as_mut_slice().iter_mut().enumerate() {
            *x = f32::from(u8::from(i % 24 < 12));
        }
        let (all, straight) = (dose(&model, &x), dose(&straight, &x));
        // Scattered light by planes of z
        let mut planes = [0.0; 48];
        for (i, (all, straight)) in all.values.iter().zip(&straight.values).enumerate() {
            planes[i / 1600] += f64::from(all - straight);
        }
        planes
    };
    // 0.003 and 0.010; with what cells smear out 0.017 on the larger ones
    let exact = profile_of(1);
    let most = exact.into_iter().fold(0.0, f64::max);
    for (smooth, allowed) in [(2, 0.004), (4, 0.012)] {
        let smoothed = profile_of(smooth);
        let square = |z: usize| ((smoothed[z] - exact[z]) / most).powi(2);
        let rms = ((8..40).map(square).sum::<f64>() / 32.0).sqrt();
        assert!(rms < allowed, "{smooth}: {rms}");
    }
}

#[test]
fn scattered_light_is_an_exact_pair_with_cells_too() {
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let [solid, _] = solids(&grid);
    let whole = |smooth| {
        let (light, optics, params) = milk(&light(4, 7, 11, 0.2), None, smooth);
        monte_carlo::model(&GLASS, &[light], &[optics], &params, grid.clone()).unwrap()
    };
    for smooth in [1, 3] {
        let mut x = whole(smooth).new_patterns().unwrap();
        x.fill(1.0);
        let expected = dose(&whole(smooth), &x);
        let model = whole(smooth).with_cells(Arc::clone(&solid));
        let found = check::model::model(&model, 3).unwrap();
        assert!(found.adjoint_error < 1e-6, "{found:?}");
        let mean = dose(&model, &x);
        assert!(check::largest_difference(&mean.values, &expected.values) < 1e-6);
    }
}
