use super::*;
use crate::check;
use crate::field::Field;
use crate::grid::{PatternGrid, Patterns, Volume};
use crate::io::mesh::samples::{ball, cuboid};
use crate::kind::Section;
use crate::models::DoseModel;
use crate::models::parallel::Parallel;
use crate::optics::absorption_map::AbsorptionMap;
use crate::optics::gradient::Gradient;
use crate::optics::obstacle::Material;
use crate::optics::projector::diverging::Diverging;
use crate::optics::projector::telecentric::Telecentric;
use crate::optics::resin::Resin;
use crate::optics::surface::{Net, Surface};
use crate::optics::vial::cylinder::Cylinder;
use crate::optics::vial::double_tube::DoubleTube;
use crate::optics::vial::ended::{End, Ended};
use crate::optics::vial::index_matched::IndexMatched;
use crate::optics::vial::square::Square;
use crate::target::phantom::Phantom;
use crate::target::{MeshShape, Placement, Repair, Shape};

const GLASS: Cylinder = Cylinder {
    inner_radius_mm: 1.6,
    outer_radius_mm: 1.8,
    refractive_index: 1.54,
};

fn vials() -> Vec<Box<dyn Vial>> {
    vec![
        Box::new(IndexMatched { radius_mm: 1.7 }),
        Box::new(GLASS),
        Box::new(Square {
            inner_width_mm: 3.0,
            outer_width_mm: 3.4,
            refractive_index: 1.5,
        }),
        Box::new(DoubleTube {
            radii_mm: [1.9, 1.7, 0.5, 0.4],
            outer_refractive_index: 1.5,
            inner_refractive_index: 1.52,
            core_refractive_index: 1.33,
        }),
    ]
}

/// Vials with a plate below and a free surface above.
fn ended() -> Vec<Box<dyn Vial>> {
    let end = |z_mm, thickness_mm| Some(End { z_mm, thickness_mm });
    vials()
        .into_iter()
        .map(|vial| {
            let plate = if vial.walls().len() > 1 { 0.2 } else { 0.0 };
            let ended = Ended::new(vial, end(-0.5, plate), end(0.7, 0.0)).unwrap();
            Box::new(ended) as Box<dyn Vial>
        })
        .collect()
}

fn optics() -> Vec<(&'static str, Optics)> {
    let plain = Optics::collimated(0.2);
    let leaning = Motion {
        tilt_rad: 0.12,
        ..Motion::default()
    };
    let aside = Motion {
        offset_mm: [0.1, -0.05],
        wobble_mm: 0.03,
        wobble_phase_rad: 0.4,
        ..Motion::default()
    };
    let cone = Telecentric {
        pixel_pitch_mm: [0.2; 2],
        aperture_radius_mm: 2.0,
        working_distance_mm: 20.0,
        focus_mm: 0.1,
    };
    let body = Surface::Net(Arc::new(
        Net::new(&cuboid([0.1, 0.6, -0.4], [0.4, 0.8, 0.3]), "mesh").unwrap(),
    ));
    let with = |material| Optics {
        obstacles: vec![Obstacle {
            surface: body.clone(),
            material,
        }],
        ..plain.clone()
    };
    vec![
        ("collimated", plain.clone()),
        (
            "tilted",
            Optics {
                motion: leaning,
                ..plain.clone()
            },
        ),
        (
            "off axis",
            Optics {
                motion: aside,
                ..plain.clone()
            },
        ),
        (
            "telecentric",
            Optics {
                projector: Arc::new(cone),
                ..plain.clone()
            },
        ),
        (
            "diverging, tilted",
            Optics {
                projector: Arc::new(Diverging::new([0.2; 2], 12.0)),
                motion: leaning,
                ..plain.clone()
            },
        ),
        ("black body", with(Material::Black)),
        (
            "clear body",
            with(Material::Dielectric {
                refractive_index: 1.6,
            }),
        ),
        ("mirror", with(Material::Mirror)),
    ]
}

fn light(frames: usize, rows: usize, columns: usize, pitch_mm: f64) -> Light {
    let mut light = Light::new(
        PatternGrid::full_turn(frames, 0.2, rows, columns, pitch_mm),
        Resin::absorbing(1.48, 0.3),
    );
    light.surrounding_index = 1.0;
    light
}

fn rays(vial: &dyn Vial, light: Light, optics: &Optics, params: &Params, grid: VolumeGrid) -> Rays {
    Rays::new(
        vial,
        vec![light],
        std::slice::from_ref(optics),
        params,
        grid,
    )
    .unwrap()
}

fn dose(model: &dyn DoseModel<Field = HostField>, x: &HostField) -> Volume<f32> {
    let mut dose = model.new_dose().unwrap();
    model.dose(x, &mut dose, &Run::new()).unwrap();
    model.outputs()[0].volume_of(dose.as_slice())
}

#[test]
fn every_vial_with_every_optics_is_an_exact_pair() {
    for vial in vials().into_iter().chain(ended()) {
        for (name, optics) in optics() {
            for reflections in [false, true] {
                let params = Params {
                    rays_per_pixel: Some(3),
                    reflections,
                    least_power: 0.02,
                    ..Params::default()
                };
                let grid = VolumeGrid::centered([9, 14, 13], 0.2);
                let model = rays(vial.as_ref(), light(5, 7, 11, 0.2), &optics, &params, grid);
                let found = check::model::model(&model, 3)
                    .unwrap_or_else(|e| panic!("{vial:?} {name} {reflections}: {e}"));
                assert!(found.adjoint_error < 1e-6, "{vial:?} {name}: {found:?}");
            }
        }
    }
}

#[test]
fn a_resin_that_differs_from_place_to_place_is_an_exact_pair() {
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let values: Vec<f32> = (0..60).map(|i| 0.1 + 0.05 * (i * 7 % 13) as f32).collect();
    let map = AbsorptionMap::new([3, 4, 5], 0.5, values.clone(), values).unwrap();
    for vial in [Box::new(GLASS) as Box<dyn Vial>]
        .into_iter()
        .chain(ended())
    {
        for (name, optics) in optics() {
            let mut light = light(5, 7, 11, 0.2);
            light.map = Some(Arc::new(map.clone()));
            light.resin.gradient = Some(Gradient {
                quadratic_per_mm2: -0.05,
                quartic_per_mm4: 0.0,
                step_mm: 0.1,
            });
            let model = rays(
                vial.as_ref(),
                light,
                &optics,
                &Params::default(),
                grid.clone(),
            );
            let found =
                check::model::model(&model, 3).unwrap_or_else(|e| panic!("{vial:?} {name}: {e}"));
            assert!(found.adjoint_error < 1e-6, "{vial:?} {name}: {found:?}");
        }
    }
}

#[test]
fn a_map_on_the_voxels_is_what_parallel_says_and_an_even_one_changes_nothing() {
    let vial = IndexMatched { radius_mm: 1.7 };
    let grid = VolumeGrid::centered([4, 16, 16], 0.15);
    let of = |map: Option<AbsorptionMap>| {
        let mut light = light(6, 6, 24, 0.13);
        light.map = map.map(Arc::new);
        let params = Params {
            rays_per_pixel: Some(1024),
            ..Params::default()
        };
        let optics = Optics::collimated(0.13);
        let parallel = Parallel::new(&vial, vec![light.clone()], grid.clone()).unwrap();
        let mut x = DoseModel::new_patterns(&parallel).unwrap();
        let values: Vec<f32> = (0..x.len()).map(|i| 1.0 + (i as f32 * 0.1).sin()).collect();
        x.copy_from_host(&values);
        let rays = rays(&vial, light, &optics, &params, grid.clone());
        [dose(&parallel, &x), dose(&rays, &x)]
    };
    let difference = |a: &Volume<f32>, b: &Volume<f32>| {
        let pairs = || a.values.iter().zip(&b.values);
        let squares: f64 = pairs().map(|(a, b)| f64::from(a - b).powi(2)).sum();
        (squares / pairs().map(|(a, _)| f64::from(*a).powi(2)).sum::<f64>()).sqrt()
    };
    let map = |value: &dyn Fn(usize) -> f32| {
        let values: Vec<f32> = (0..16 * 16).map(value).collect();
        AbsorptionMap::new([1, 16, 16], 0.15, values.clone(), values).unwrap()
    };
    let patches = map(&|i| if (i / 4 + i / 64) % 2 == 0 { 0.1 } else { 0.7 });
    let [parallel, rays] = of(Some(patches));
    let [_, plain] = of(None);
    let (apart, changed) = (difference(&parallel, &rays), difference(&plain, &rays));
    // Without a map the two models are 0.015 apart at this pitch
    assert!(apart < 0.02 && changed > 0.3, "{apart} {changed}");
    let [_, even] = of(Some(map(&|_| 0.3)));
    assert!(difference(&plain, &even) < 1e-5);
}

/// Every cell of every ray by an independent walk in f64: sorted crossings of all planes.
fn brute_force(model: &Rays, x: &[f32]) -> Vec<f64> {
    brute_force_where(model, x, |_, _| true)
}

/// The same of those pieces of legs whose middle (mm along the leg) counts; legs are cut where they cross the ball, too.
fn brute_force_where(model: &Rays, x: &[f32], counts: impl Fn(&Leg, f64) -> bool) -> Vec<f64> {
    let layout = &model.outputs[0];
    let grid = &layout.grid;
    let low = grid.bounds_mm()[0];
    let mut dose = vec![0.0; grid.len()];
    let patterns = &model.patterns[0];
    let (columns, h) = (patterns.grid.columns, grid.pitch_mm);
    let area = patterns.grid.pixel_mm2() / model.sources[0].rays() as f64;
    for (pair, run) in patterns.runs.iter().enumerate() {
        for i in 0..run.count as usize {
            let value = f64::from(x[run.offset + i]);
            let row = run.bottom as usize + i;
            model.sources[0].for_each_leg(pair / columns, pair % columns, row, |leg| {
                let mut cuts = vec![0.0, leg.length];
                for axis in 0..3 {
                    let planes = [grid.shape[2], grid.shape[1], grid.shape[0]][axis];
                    for plane in 0..=planes {
                        let at = low[axis] + plane as f64 * h;
                        let t = (at - leg.ray.from[axis]) / leg.ray.direction[axis];
                        if t > 0.0 && t < leg.length {
                            cuts.push(t);
                        }
                    }
                }
                let ball = chord(leg.ray.from, leg.ray.direction);
                let within = ball.into_iter().flatten();
                cuts.extend(within.filter(|t| (0.0..leg.length).contains(t)));
                cuts.sort_by(f64::total_cmp);
                for cut in cuts.windows(2) {
                    let at = (cut[0] + cut[1]) / 2.0;
                    let middle = leg.ray.at(at);
                    let cell: [f64; 3] =
                        std::array::from_fn(|i| ((middle[i] - low[i]) / h).floor());
                    let inside = (0..3).all(|i| {
                        let n = [grid.shape[2], grid.shape[1], grid.shape[0]][i];
                        (0.0..n as f64).contains(&cell[i])
                    });
                    if inside && counts(&leg, at) {
                        let left = |t: f64| (-leg.uptake.attenuation_per_mm * t).exp();
                        let [x, y, z] = cell.map(|c| c as usize);
                        dose[grid.index(z, y, x)] +=
                            value * area * leg.power * leg.uptake.active_per_mm
                                / leg.uptake.attenuation_per_mm
                                * (left(cut[0]) - left(cut[1]))
                                / h.powi(3);
                    }
                }
            });
        }
    }
    dose
}

#[test]
fn both_kernels_equal_a_brute_force_walk_in_f64() {
    let grid = VolumeGrid {
        center_mm: [0.03, -0.02, 0.05],
        ..VolumeGrid::centered([19, 23, 37], 0.1)
    };
    for attenuation in [0.3, 9.0] {
        for (name, optics) in optics() {
            let mut light = light(7, 5, 9, 0.23);
            light.resin.attenuation_per_mm = attenuation;
            let params = Params::default();
            for is_plain in [false, true] {
                let mut model = rays(&GLASS, light.clone(), &optics, &params, grid.clone());
                if is_plain {
                    model = model.plain();
                }
                let mut x = LinearOperator::new_patterns(&model).unwrap();
                let values = check::model::noise(1, x.len());
                x.copy_from_host(&values.iter().map(|v| v.abs()).collect::<Vec<_>>());
                let (exact, found) = (brute_force(&model, x.as_slice()), dose(&model, &x));
                let largest = exact.iter().copied().fold(0.0, f64::max);
                for (a, b) in exact.iter().zip(&found.values) {
                    let error = (a - f64::from(*b)).abs() / largest;
                    assert!(error < 2e-5, "{name}, plain {is_plain}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn with_many_rays_it_is_what_parallel_says() {
    // What is left is the error of `parallel` itself at this pitch: see docs/validation.md
    let bounds = [0.015, 0.015, 0.015, 0.06];
    let square = ([0.13, 0.13], [0.0, 0.0]);
    // Pixels that are not square, beside the axis
    let flat = ([0.13, 0.09], [0.21, -0.1]);
    let mut cases: Vec<_> = vials()
        .into_iter()
        .zip(bounds)
        .map(|c| (c, square))
        .collect();
    cases.extend(vials().into_iter().zip([0.02; 2]).map(|c| (c, flat)));
    for ((vial, left), (pitch_mm, offset_mm)) in cases {
        let mut light = light(6, 8, 24, 0.13);
        (light.pixels.pitch_mm, light.pixels.offset_mm) = (pitch_mm, offset_mm);
        let grid = VolumeGrid::centered([6, 16, 16], 0.15);
        let parallel = Parallel::new(vial.as_ref(), vec![light.clone()], grid.clone()).unwrap();
        let mut x = DoseModel::new_patterns(&parallel).unwrap();
        let values: Vec<f32> = (0..x.len()).map(|i| 1.0 + (i as f32 * 0.1).sin()).collect();
        x.copy_from_host(&values);
        let expected = dose(&parallel, &x);
        let difference = |count: usize| {
            let params = Params {
                rays_per_pixel: Some(count),
                ..Params::default()
            };
            let optics = Optics::collimated(0.13);
            let model = rays(vial.as_ref(), light.clone(), &optics, &params, grid.clone());
            let found = dose(&model, &x);
            let square = |f: &dyn Fn(f64, f64) -> f64| {
                let pairs = expected.values.iter().zip(&found.values);
                pairs
                    .map(|(&a, &b)| f(a.into(), b.into()).powi(2))
                    .sum::<f64>()
            };
            (square(&|a, b| a - b) / square(&|a, _| a)).sqrt()
        };
        let (few, many) = (difference(4), difference(1024));
        assert!(many < left && few < left + 0.06, "{vial:?}: {few} {many}");
    }
}

#[test]
fn what_is_absorbed_is_what_the_account_says() {
    let grid = VolumeGrid::centered([40, 40, 40], 0.1);
    for (name, optics) in optics() {
        let light = light(1, 3, 3, 0.2);
        let model = rays(&GLASS, light, &optics, &Params::default(), grid.clone());
        let mut x = LinearOperator::new_patterns(&model).unwrap();
        x.fill(1.0);
        let sent = 9.0 * 0.2 * 0.2;
        let absorbed: f64 = dose(&model, &x)
            .values
            .iter()
            .map(|&v| f64::from(v))
            .sum::<f64>()
            * 1e-3;
        let account = model.account(0, 0);
        assert!((account.total() - 1.0).abs() < 1e-9, "{name}: {account:?}");
        assert!(
            (absorbed / sent - account.absorbed).abs() < 1e-4,
            "{name}: {} {account:?}",
            absorbed / sent
        );
    }
}

#[test]
fn a_frame_of_a_tilted_axis_is_the_level_frame_of_a_resin_that_leans() {
    // Light of one frame from above, in an index-matched medium of no absorption: its centroid leans by the tilt
    let tilt: f64 = 0.25;
    let motion = Motion {
        tilt_rad: tilt,
        ..Motion::default()
    };
    let optics = Optics {
        motion,
        ..Optics::collimated(0.1)
    };
    let mut light = light(1, 1, 1, 0.1);
    light.pixels.azimuths = vec![0.0];
    light.resin = Resin::pure_radon(1.5);
    let grid = VolumeGrid::centered([80, 11, 41], 0.05);
    let params = Params {
        rays_per_pixel: Some(1024),
        ..Params::default()
    };
    let model = rays(
        &IndexMatched { radius_mm: 5.0 },
        light,
        &optics,
        &params,
        grid.clone(),
    );
    let mut x = LinearOperator::new_patterns(&model).unwrap();
    x.fill(1.0);
    let dose = dose(&model, &x);
    let height = |ix: usize| {
        let (mut sum, mut weight) = (0.0, 0.0);
        for iz in 0..80 {
            for iy in 0..11 {
                let value = f64::from(*dose.at(iz, iy, ix));
                sum += value * grid.z(iz);
                weight += value;
            }
        }
        (sum / weight, weight)
    };
    for ix in [3, 20, 37] {
        let (z, weight) = height(ix);
        assert!((z - grid.x(ix) * tilt.tan()).abs() < 1e-3, "{ix}: {z}");
        // A slice of the beam: area over cos(tilt), per voxel area
        assert!((weight * 0.05 * 0.05 * tilt.cos() / 0.01 - 1.0).abs() < 1e-4);
    }
}

/// A cube of resin's worth of voxels in a ball of light: all that is scattered is deposited or leaves.
#[test]
fn a_scattering_resin_is_an_exact_pair_whose_energy_is_accounted_for() {
    use crate::models::scatter;
    use crate::optics::phase::{Scattering, rayleigh::Rayleigh};
    let mut light = light(4, 5, 9, 0.2);
    light.resin.attenuation_per_mm = 0.3 + 0.8;
    let mut optics = Optics::collimated(0.2);
    optics.scattering = Some(Scattering {
        per_mm: 0.8,
        phase: Arc::new(Rayleigh {}),
    });
    let params = scatter::Params {
        paths_per_pixel: 8,
        ..scatter::Params::default()
    };
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let build = |params: &scatter::Params, light: &Light, grid: &VolumeGrid| {
        let (light, optics) = (std::slice::from_ref(light), std::slice::from_ref(&optics));
        scatter::model(&GLASS, light, optics, params, grid.clone()).unwrap()
    };
    let model = build(&params, &light, &grid);
    let found = check::model::model(&model, 3).unwrap();
    assert!(found.adjoint_error < 1e-6, "{found:?}");
    // Both kernels walk the same paths
    let mut x = LinearOperator::new_patterns(&model).unwrap();
    x.fill(1.0);
    let plain = dose(&build(&params, &light, &grid).plain(), &x);
    let wide = dose(&model, &x);
    let largest = wide.values.iter().copied().fold(0.0, f32::max);
    for (a, b) in plain.values.iter().zip(&wide.values) {
        assert!((a - b).abs() < 1e-4 * largest, "{a} {b}");
    }
    // Another seed is another matrix with the same mean
    let other = scatter::Params {
        seed: 2,
        ..params.clone()
    };
    let other = dose(&build(&other, &light, &grid), &x);
    assert_ne!(other, wide);
    let sum = |v: &Volume<f32>| v.values.iter().map(|&v| f64::from(v)).sum::<f64>();
    assert!((sum(&other) / sum(&wide) - 1.0).abs() < 0.02);
    // Reflections at the glass: still a pair, and more of the light stays in the resin
    let mirrored = build(
        &scatter::Params {
            reflections: true,
            ..params.clone()
        },
        &light,
        &grid,
    );
    let found = check::model::model(&mirrored, 4).unwrap();
    assert!(found.adjoint_error < 1e-6, "{found:?}");
    let account = mirrored.account(0, 0);
    assert!((account.total() - 1.0).abs() < 1e-9, "{account:?}");
    assert!(account.reflected == 0.0 && account.absorbed > 1.02 * model.account(0, 0).absorbed);
    // Paths are drawn anew after two iterations, and are the same again in the same round
    let renewed = build(
        &scatter::Params {
            renew: 2,
            ..params.clone()
        },
        &light,
        &grid,
    );
    assert!(!LinearOperator::renew(&renewed, 2) && LinearOperator::renew(&renewed, 3));
    let second = dose(&renewed, &x);
    assert!(second != wide && (sum(&second) / sum(&wide) - 1.0).abs() < 0.02);
    assert!(LinearOperator::renew(&renewed, 1));
    assert_eq!(dose(&renewed, &x), wide);
    // In a grid that holds all the resin and the cells around it, dose is what the account says was absorbed
    light.pixels = PatternGrid::full_turn(1, 0.2, 3, 3, 0.2);
    let tall = VolumeGrid::centered([150, 44, 44], 0.1);
    let model = build(&params, &light, &tall);
    let mut x = LinearOperator::new_patterns(&model).unwrap();
    x.fill(1.0);
    let active = sum(&dose(&model, &x)) * 1e-3 / (9.0 * 0.04);
    let account = model.account(0, 0);
    assert!((account.total() - 1.0).abs() < 1e-9);
    assert!(
        (active / account.absorbed - 1.0).abs() < 2e-3,
        "{active} {account:?}"
    );
}

/// Scattering of the resins below, 1/mm.
const SCATTERED: f64 = 0.8;

/// Light, its optics and paths in a resin that scatters; `map`: its active absorption, given by cell.
fn milk(
    light: &Light,
    map: Option<([usize; 3], f64, Vec<f32>)>,
    smooth: usize,
) -> (Light, Optics, crate::models::scatter::Params) {
    use crate::optics::phase::{Scattering, rayleigh::Rayleigh};
    let mut light = light.clone();
    light.resin.attenuation_per_mm = light.resin.absorption_per_mm + SCATTERED;
    light.map = map.map(|(shape, pitch_mm, active)| {
        let total = active.iter().map(|a| a + SCATTERED as f32).collect();
        Arc::new(AbsorptionMap::new(shape, pitch_mm, active, total).unwrap())
    });
    let mut optics = Optics::collimated(light.pixels.pitch_mm[0]);
    optics.scattering = Some(Scattering {
        per_mm: SCATTERED,
        phase: Arc::new(Rayleigh {}),
    });
    let params = crate::models::scatter::Params {
        smooth,
        ..crate::models::scatter::Params::default()
    };
    (light, optics, params)
}

#[test]
fn a_resin_that_scatters_and_differs_from_place_to_place_is_an_exact_pair() {
    use crate::models::scatter;
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
                let (mut light, mut optics, mut params) = milk(&light(4, 5, 9, 0.2), map, smooth);
                params.reflections = smooth == 1;
                optics.motion.tilt_rad = 0.1;
                light.resin.gradient = Some(Gradient {
                    quadratic_per_mm2: -0.05,
                    quartic_per_mm4: 0.0,
                    step_mm: 0.2,
                });
                let model = || {
                    let (lights, optics) = ([light.clone()], [optics.clone()]);
                    scatter::model(vial.as_ref(), &lights, &optics, &params, grid.clone()).unwrap()
                };
                for model in [model(), model().with_cells(Arc::clone(&solid))] {
                    let found = check::model::model(&model, 3).unwrap();
                    assert!(found.adjoint_error < 1e-6, "{vial:?} {smooth}: {found:?}");
                    let account = model.account(0, 0);
                    assert!((account.total() - 1.0).abs() < 1e-9, "{account:?}");
                }
            }
        }
    }
}

/// The dose of even patterns.
fn lit(model: &Rays) -> Volume<f32> {
    let mut x = LinearOperator::new_patterns(model).unwrap();
    x.fill(1.0);
    dose(model, &x)
}

#[test]
fn an_even_map_in_a_resin_that_scatters_changes_nothing() {
    use crate::models::scatter;
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    for smooth in [1, 4] {
        let of = |map| {
            let (light, optics, params) = milk(&light(4, 5, 9, 0.2), map, smooth);
            lit(&scatter::model(&GLASS, &[light], &[optics], &params, grid.clone()).unwrap())
        };
        let (plain, mapped) = (of(None), of(Some(([3, 4, 5], 0.5, vec![0.3; 60]))));
        let most = plain.values.iter().copied().fold(0.0, f32::max);
        for (a, b) in plain.values.iter().zip(&mapped.values) {
            assert!((a - b).abs() < 2e-6 * most, "{smooth}: {a} {b}");
        }
    }
}

#[test]
fn scattered_light_leaves_what_the_map_takes_of_it_on_either_side_of_a_face() {
    use crate::models::scatter;
    // The resin takes 0.05 per mm below x = 0 and 0.6 above, in the middle of cells of four voxels
    let grid = VolumeGrid::centered([150, 44, 44], 0.1);
    let light = light(6, 3, 15, 0.2);
    let of = |smooth: usize| {
        let map = Some(([1, 1, 2], 10.0, vec![0.05, 0.6]));
        let (light, optics, mut params) = milk(&light, map, smooth);
        params.paths_per_pixel = 64;
        let (lights, optics) = ([light], [optics]);
        let model = scatter::model(&GLASS, &lights, &optics, &params, grid.clone()).unwrap();
        let straight = scatter::straight(&GLASS, &lights, &optics, &params, grid.clone());
        let (all, straight) = (lit(&model), lit(&straight.unwrap()));
        let energy: f64 = all.values.iter().map(|&v| f64::from(v)).sum::<f64>() * 1e-3;
        let frames = (0..6).map(|frame| model.account(0, frame).absorbed);
        let balance = energy / (45.0 * 0.04 * frames.sum::<f64>());
        // Scattered light by planes of x
        let mut planes = [0.0; 44];
        for (i, (all, straight)) in all.values.iter().zip(&straight.values).enumerate() {
            planes[i % 44] += f64::from(all - straight);
        }
        (planes, balance)
    };
    let (exact, whole) = of(1);
    assert!((whole - 1.0).abs() < 1e-3, "{whole}");
    // The dose leaps by what is taken; fluence falls by a tenth in the tenth of a millimetre between these planes
    let leap = exact[22] / exact[21] / 12.0;
    assert!((0.8..1.0).contains(&leap), "{leap} {exact:?}");
    for (smooth, allowed) in [(2, 0.04), (4, 0.08)] {
        let (planes, balance) = of(smooth);
        // Cells reach beyond the wall, where the map goes on
        assert!((balance - 1.0).abs() < 2e-2, "{balance}");
        let error = |x: usize| (planes[x] / exact[x] - 1.0).abs();
        let worst = (12..32).map(error).fold(0.0, f64::max);
        assert!(worst < allowed, "{smooth}: {worst} {exact:?} {planes:?}");
    }
}

#[test]
fn what_cells_smear_out_comes_back_on_either_side_of_the_edge_of_a_pattern() {
    use crate::models::scatter;
    // Rows below z = 0 are lit: scattered light falls off about the edge. Cells of 0.4 mm where a free path is 0.9 mm
    let grid = VolumeGrid::centered([48, 40, 40], 0.1);
    let light = light(12, 24, 20, 0.2);
    let of = |smooth: usize| {
        let (light, optics, mut params) = milk(&light, None, smooth);
        params.paths_per_pixel = 64;
        let (lights, optics) = ([light], [optics]);
        let model = scatter::model(&GLASS, &lights, &optics, &params, grid.clone()).unwrap();
        let straight = scatter::straight(&GLASS, &lights, &optics, &params, grid.clone()).unwrap();
        let mut x = LinearOperator::new_patterns(&model).unwrap();
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
    let exact = of(1);
    let most = exact.into_iter().fold(0.0, f64::max);
    for (smooth, allowed) in [(2, 0.004), (4, 0.012)] {
        let smoothed = of(smooth);
        let square = |z: usize| ((smoothed[z] - exact[z]) / most).powi(2);
        let rms = ((8..40).map(square).sum::<f64>() / 32.0).sqrt();
        assert!(rms < allowed, "{smooth}: {rms}");
    }
}

/// A ball beside the middle, and a mesh of it.
fn solids(grid: &VolumeGrid) -> [Arc<Solid>; 2] {
    let placement = Placement {
        offset_mm: BALL,
        ..Placement::default()
    };
    let section = Section::new(
        "target.phantom",
        serde_json::json!({"sphere": {"size_mm": 1.0}}),
    );
    let form: Arc<dyn Shape> = Arc::new(Phantom::build(&section, &placement, "target").unwrap());
    let net = MeshShape::new(
        ball([0.0; 3], 0.5, 3),
        &placement,
        std::path::Path::new("ball"),
        "target",
        Repair::Safe,
    );
    let net: Arc<dyn Shape> = Arc::new(net.unwrap());
    [form, net].map(|shape| Arc::new(Solid::new(&shape, grid).unwrap()))
}

const BALL: [f64; 3] = [0.12, -0.07, 0.04];

#[test]
fn every_vial_with_every_optics_is_an_exact_pair_with_cells_too() {
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    for solid in solids(&grid) {
        assert!(solid.cells().len() > 50);
        for vial in vials() {
            for (name, optics) in optics() {
                let params = Params {
                    rays_per_pixel: Some(3),
                    reflections: true,
                    least_power: 0.02,
                    ..Params::default()
                };
                let light = light(5, 7, 11, 0.2);
                let model = rays(vial.as_ref(), light, &optics, &params, grid.clone())
                    .with_cells(Arc::clone(&solid));
                let found = check::model::model(&model, 3)
                    .unwrap_or_else(|e| panic!("{vial:?} {name}: {e}"));
                assert!(found.adjoint_error < 1e-6, "{vial:?} {name}: {found:?}");
            }
        }
    }
}

#[test]
fn walks_that_are_kept_are_those_that_are_walked() {
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let [ball, _] = solids(&grid);
    for (name, optics) in optics() {
        for solid in [None, Some(&ball)] {
            let build = || {
                let (light, params) = (light(5, 7, 11, 0.2), Params::default());
                let model = rays(&GLASS, light, &optics, &params, grid.clone());
                match solid {
                    Some(solid) => model.with_cells(Arc::clone(solid)),
                    None => model,
                }
            };
            let (walked, kept) = (build(), build().keeping());
            check::model::model(&kept, 3).unwrap();
            assert!(walked.kept(&Run::new()).unwrap().is_none());
            let (run, has_sheets) = (Run::new(), walked.has_sheets());
            assert_eq!(kept.kept(&run).unwrap().is_none(), has_sheets, "{name}");
            let sheets = kept.kept_sheets(&run).unwrap();
            assert_eq!(sheets.is_some(), has_sheets, "{name}");
            let mut x = LinearOperator::new_patterns(&kept).unwrap();
            x.copy_from_host(&check::model::noise(1, x.len()));
            // Some of the frames only, on top of what is there
            let some = |model: &Rays| {
                let mut dose = LinearOperator::new_dose(model).unwrap();
                dose.fill(0.5);
                model.add_forward(1..4, &x, &mut dose, &Run::new()).unwrap();
                dose.as_slice().to_vec()
            };
            let back = |model: &Rays| {
                let mut c = LinearOperator::new_dose(model).unwrap();
                c.copy_from_host(&check::model::noise(2, c.len()));
                let mut grad = LinearOperator::new_patterns(model).unwrap();
                model.adjoint(&c, &mut grad, &Run::new()).unwrap();
                grad.as_slice().to_vec()
            };
            for [a, b] in [[some(&walked), some(&kept)], [back(&walked), back(&kept)]] {
                let largest = a.iter().fold(0.0f32, |m, v| m.max(v.abs()));
                for (a, b) in a.iter().zip(&b) {
                    assert!((a - b).abs() < 1e-5 * largest, "{name}: {a} {b}");
                }
            }
            assert!(kept::Kept::of(&walked, 100, &run).unwrap().is_none());
            assert!(KeptSheets::of(&walked, 100, &run).unwrap().is_none());
        }
    }
}

#[test]
fn rows_that_are_followed_together_leave_what_single_rays_leave() {
    // Twenty slices, two vectors of lanes; the pixels reach beyond the grid. No height is that of a face, where rounding decides
    let grid = VolumeGrid {
        center_mm: [0.03, -0.02, 0.413],
        ..VolumeGrid::centered([20, 17, 18], 0.1)
    };
    let mut light = light(5, 18, 11, 0.16);
    light.sub_angles = 2;
    light.pixels.frame_arc = 0.3;
    light.active = Some(
        (0..55)
            .map(|i| (i % 4, [18, 9, 2, 14][i as usize % 4] - i % 4))
            .collect(),
    );
    let patches = (0..20)
        .map(|i| 0.1 + 0.05 * (i * 7 % 13) as f32)
        .collect::<Vec<_>>();
    let map = AbsorptionMap::new([1, 4, 5], 0.5, patches.clone(), patches).unwrap();
    let mapped = Light {
        map: Some(Arc::new(map)),
        ..light.clone()
    };
    let aside = optics().remove(2).1;
    for vial in vials() {
        for (light, reflections) in [(&light, true), (&mapped, false)] {
            let params = Params {
                rays_per_pixel: Some(3),
                reflections,
                ..Params::default()
            };
            let build = || rays(vial.as_ref(), light.clone(), &aside, &params, grid.clone());
            let (together, single) = (build(), build().plain());
            assert!(together.has_sheets() && !single.has_sheets());
            let found = check::model::model(&together, 3).unwrap();
            assert!(found.adjoint_error < 1e-6, "{vial:?}: {found:?}");
            let mut x = LinearOperator::new_patterns(&single).unwrap();
            x.copy_from_host(&check::model::noise(1, x.len()));
            let mut c = LinearOperator::new_dose(&single).unwrap();
            c.copy_from_host(&check::model::noise(2, c.len()));
            let both = [&together, &single].map(|model| {
                let mut grad = LinearOperator::new_patterns(model).unwrap();
                model.adjoint(&c, &mut grad, &Run::new()).unwrap();
                (dose(model, &x).values, grad.as_slice().to_vec())
            });
            let [(a, of_a), (b, of_b)] = &both;
            for (a, b) in [(a, b), (of_a, of_b)] {
                let largest = a.iter().fold(0.0f32, |m, v| m.max(v.abs()));
                for (a, b) in a.iter().zip(b) {
                    assert!((a - b).abs() < 2e-6 * largest, "{vial:?}: {a} {b}");
                }
            }
            let [a, b] = [&together, &single].map(|m| LinearOperator::updates(m) as f64);
            assert!((a / b - 1.0).abs() < 1e-4, "{vial:?}: {a} {b}");
        }
    }
}

#[test]
fn light_that_may_leave_its_slice_couples_slices() {
    let grid = VolumeGrid::centered([8; 3], 0.2);
    for (name, optics) in optics() {
        let model = rays(
            &GLASS,
            light(3, 5, 9, 0.2),
            &optics,
            &Params::default(),
            grid.clone(),
        );
        let is_apart = matches!(LinearOperator::z_coupling(&model), ZCoupling::None);
        assert_eq!(
            is_apart,
            ["collimated", "off axis"].contains(&name),
            "{name}"
        );
    }
    // The walls of a mesh may lean, ends may bend light
    for vial in ended() {
        let optics = Optics::collimated(0.2);
        let light = light(3, 5, 9, 0.2);
        let model = rays(
            vial.as_ref(),
            light,
            &optics,
            &Params::default(),
            grid.clone(),
        );
        assert!(matches!(
            LinearOperator::z_coupling(&model),
            ZCoupling::Full
        ));
    }
}

/// Where a ray enters and leaves the ball, by its equation.
fn chord(from: [f64; 3], direction: [f64; 3]) -> Option<[f64; 2]> {
    let p: [f64; 3] = std::array::from_fn(|i| from[i] - BALL[i]);
    let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| a[i] * b[i]).sum::<f64>();
    let (half, rest) = (dot(p, direction), dot(p, p) - 0.25);
    let root = (half * half - rest).sqrt();
    root.is_finite().then_some([-half - root, -half + root])
}

#[test]
fn energies_of_cells_equal_a_brute_force_walk_and_add_up_to_the_plain_dose() {
    let grid = VolumeGrid {
        center_mm: [0.03, -0.02, 0.05],
        ..VolumeGrid::centered([11, 13, 12], 0.17)
    };
    let [solid, _] = solids(&grid);
    for attenuation in [0.3, 9.0] {
        for (name, optics) in optics() {
            let mut light = light(7, 9, 15, 0.13);
            light.resin.attenuation_per_mm = attenuation;
            for is_plain in [false, true] {
                let params = Params::default();
                let mut whole = rays(&GLASS, light.clone(), &optics, &params, grid.clone());
                if is_plain {
                    whole = whole.plain();
                }
                let mut x = LinearOperator::new_patterns(&whole).unwrap();
                let values = check::model::noise(1, x.len());
                x.copy_from_host(&values.iter().map(|v| v.abs()).collect::<Vec<_>>());
                let expected = dose(&whole, &x);
                let inside = brute_force_where(&whole, x.as_slice(), |leg, t| {
                    chord(leg.ray.from, leg.ray.direction).is_some_and(|[a, b]| a < t && t < b)
                });
                let model = whole.with_cells(Arc::clone(&solid));
                let mut field = LinearOperator::new_dose(&model).unwrap();
                DoseModel::dose(&model, &x, &mut field, &Run::new()).unwrap();
                let layout = &model.outputs[0];
                let mean = layout.volume_of(field.as_slice());
                let largest = f64::from(expected.values.iter().copied().fold(0.0, f32::max));
                for (a, b) in expected.values.iter().zip(&mean.values) {
                    let error = f64::from((a - b).abs()) / largest;
                    assert!(error < 1e-6, "{name}, plain {is_plain}: {error:e}");
                }
                let cells = &field.as_slice()[layout.voxels()..];
                for ((voxel, (_, s)), cell) in layout
                    .cut_voxels()
                    .into_iter()
                    .zip(solid.cells().iter())
                    .zip(cells)
                {
                    let error = (inside[voxel] - f64::from(s * cell)).abs() / largest;
                    assert!(error < 2e-5, "{name}, plain {is_plain}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn even_light_gives_both_cells_of_a_voxel_the_same_dose() {
    let grid = VolumeGrid::centered([6, 7, 7], 0.2);
    let mut light = light(40, 24, 32, 0.1);
    light.resin = Resin::pure_radon(1.48);
    let vial = IndexMatched { radius_mm: 1.7 };
    let params = Params {
        rays_per_pixel: Some(100),
        ..Params::default()
    };
    for solid in solids(&grid) {
        let model = rays(
            &vial,
            light.clone(),
            &Optics::collimated(0.1),
            &params,
            grid.clone(),
        )
        .with_cells(Arc::clone(&solid));
        let mut x = LinearOperator::new_patterns(&model).unwrap();
        x.fill(1.0);
        let mut field = LinearOperator::new_dose(&model).unwrap();
        DoseModel::dose(&model, &x, &mut field, &Run::new()).unwrap();
        let (voxels, cells) = field.as_slice().split_at(model.outputs[0].voxels());
        // Forty frames of fluence 1
        let mut worst = 0.0f32;
        for ((voxel, s), inside) in solid.cells().iter().zip(cells) {
            for (share, dose) in [(1.0 - s, voxels[voxel]), (s, *inside)] {
                worst = worst.max((dose / 40.0 - 1.0).abs() * share);
            }
        }
        assert!(worst < 4e-3, "{worst}");
    }
}

#[test]
fn slices_that_fall_between_rows_are_lit_evenly() {
    // A row of 0.1 mm has 16 rays: at four heights they would give a slice of 0.0716 mm two or three, which is 30 % off
    let grid = VolumeGrid::centered([20, 20, 20], 0.0716);
    let mut light = light(40, 24, 32, 0.1);
    light.resin = Resin::pure_radon(1.48);
    let vial = IndexMatched { radius_mm: 1.7 };
    let params = Params {
        rays_per_pixel: Some(16),
        ..Params::default()
    };
    let model = rays(&vial, light, &Optics::collimated(0.1), &params, grid);
    let even = lit(&model);
    for (z, slice) in even.values.chunks_exact(400).enumerate() {
        let mean = slice.iter().sum::<f32>() / 400.0 / 40.0;
        assert!((mean - 1.0).abs() < 0.01, "slice {z}: {mean}");
    }
}

#[test]
fn scattered_light_is_an_exact_pair_with_cells_too() {
    use crate::models::scatter;
    use crate::optics::phase::{Scattering, rayleigh::Rayleigh};
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let [solid, _] = solids(&grid);
    let mut light = light(4, 7, 11, 0.2);
    light.resin.attenuation_per_mm = 0.6;
    let mut optics = Optics::collimated(0.2);
    optics.scattering = Some(Scattering {
        phase: Arc::new(Rayleigh {}),
        per_mm: 0.3,
    });
    let whole = |smooth| {
        let params = scatter::Params {
            smooth,
            ..scatter::Params::default()
        };
        scatter::model(
            &GLASS,
            &[light.clone()],
            &[optics.clone()],
            &params,
            grid.clone(),
        )
        .unwrap()
    };
    for smooth in [1, 3] {
        let mut x = LinearOperator::new_patterns(&whole(smooth)).unwrap();
        x.fill(1.0);
        let expected = dose(&whole(smooth), &x);
        let model = whole(smooth).with_cells(Arc::clone(&solid));
        let found = check::model::model(&model, 3).unwrap();
        assert!(found.adjoint_error < 1e-6, "{found:?}");
        let mean = dose(&model, &x);
        let largest = expected.values.iter().copied().fold(0.0, f32::max);
        for (a, b) in expected.values.iter().zip(&mean.values) {
            assert!((a - b).abs() < 1e-6 * largest);
        }
    }
}

#[test]
fn an_image_beside_the_axis_is_a_part_of_a_larger_one_for_every_optics() {
    // 7 columns and 5 rows, two columns to the right and one row up: the last of 11 columns, the highest of 7 rows
    let large = PatternGrid {
        pitch_mm: [0.2, 0.26],
        ..PatternGrid::full_turn(3, 0.2, 7, 11, 0.2)
    };
    let small = PatternGrid {
        rows: 5,
        columns: 7,
        offset_mm: [0.4, 0.26],
        ..large.clone()
    };
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let params = Params::default();
    let values: Vec<f32> = (0..small.len())
        .map(|i| 1.0 + (i as f32 * 0.7).sin())
        .collect();
    let given = Patterns {
        values,
        grid: small.clone(),
    };
    let mut within = Patterns::dark(large);
    for (i, &value) in given.values.iter().enumerate() {
        let (frame, row, column) = (i / 35, i / 7 % 5, i % 7);
        within.values[(frame * 7 + row) * 11 + column + 4] = value;
    }
    for vial in vials() {
        for (name, optics) in optics() {
            let [a, b] = [&given, &within].map(|patterns| {
                let light = Light {
                    pixels: patterns.grid.clone(),
                    ..light(1, 1, 1, 0.2)
                };
                let model = rays(vial.as_ref(), light, &optics, &params, grid.clone());
                let mut x = LinearOperator::new_patterns(&model).unwrap();
                model.patterns[0].fill_field(patterns, x.as_mut_slice());
                if patterns.grid == small {
                    check::model::model(&model, 3).unwrap();
                }
                dose(&model, &x)
            });
            let most = a.values.iter().copied().fold(0.0, f32::max);
            for (a, b) in a.values.iter().zip(&b.values) {
                assert!(
                    most > 0.0 && (a - b).abs() < 2e-6 * most,
                    "{vial:?} {name}: {a} {b}"
                );
            }
        }
    }
}

#[test]
fn pixels_that_are_not_square_leave_the_energy_of_their_area() {
    let grid = VolumeGrid::centered([40, 40, 40], 0.1);
    for (name, optics) in optics() {
        let mut light = light(1, 3, 3, 0.2);
        light.pixels.pitch_mm = [0.3, 0.12];
        light.pixels.offset_mm = [-0.2, 0.1];
        let model = rays(&GLASS, light, &optics, &Params::default(), grid.clone());
        let mut x = LinearOperator::new_patterns(&model).unwrap();
        x.fill(1.0);
        let dose = dose(&model, &x);
        let absorbed: f64 = dose.values.iter().map(|&v| f64::from(v)).sum::<f64>() * 1e-3;
        let (sent, account) = (9.0 * 0.3 * 0.12, model.account(0, 0));
        assert!(
            (absorbed / sent - account.absorbed).abs() < 1e-4,
            "{name}: {} {account:?}",
            absorbed / sent
        );
    }
}
