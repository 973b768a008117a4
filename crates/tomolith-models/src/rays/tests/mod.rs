use super::*;
use crate::DoseModel;
use crate::parallel::Parallel;
use tomolith_core::check;
use tomolith_core::field::Field;
use tomolith_core::grid::{PatternGrid, Patterns, Volume};
use tomolith_core::kind::Section;
use tomolith_core::units::Mm;
use tomolith_io::mesh::samples::{ball, cuboid};
use tomolith_optics::absorption_map::AbsorptionMap;
use tomolith_optics::gradient::IndexGradient;
use tomolith_optics::obstacle::BodyMaterial;
use tomolith_optics::projector::diverging::Diverging;
use tomolith_optics::projector::telecentric::Telecentric;
use tomolith_optics::resin::Resin;
use tomolith_optics::surface::{Net, Surface};
use tomolith_optics::vial::cylinder::Cylinder;
use tomolith_optics::vial::double_tube::DoubleTube;
use tomolith_optics::vial::ended::{End, Ended};
use tomolith_optics::vial::index_matched::IndexMatched;
use tomolith_optics::vial::square::Square;
use tomolith_target::phantom::Phantom;
use tomolith_target::{MeshShape, Placement, Repair, Shape};

mod cells;
mod scattered;

const GLASS: Cylinder = Cylinder::new(1.6, 1.8, 1.54);

fn vials() -> Vec<Box<dyn Vial>> {
    vec![
        Box::new(IndexMatched { radius_mm: 1.7 }),
        Box::new(GLASS),
        Box::new(Square::new(3.0, 3.4, 1.5)),
        Box::new(DoubleTube::new([1.9, 1.7, 0.5, 0.4], [1.5, 1.52, 1.33])),
    ]
}

/// Vials with a plate below and a free surface above.
fn ended() -> Vec<Box<dyn Vial>> {
    let end = |z_mm, thickness_mm| {
        let [z_mm, thickness_mm] = [z_mm, thickness_mm].map(Mm);
        Some(End { z_mm, thickness_mm })
    };
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
    let aside = Motion {
        offset_mm: [0.1, -0.05],
        axis_runout_mm: 0.03,
        axis_runout_rad: 0.4,
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
        ("tilted", plain.clone().tilted(0.12)),
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
                ..plain.clone().tilted(0.12)
            },
        ),
        ("black body", with(BodyMaterial::Black)),
        (
            "clear body",
            with(BodyMaterial::Dielectric {
                refractive_index: 1.6,
            }),
        ),
        ("mirror", with(BodyMaterial::Mirror)),
        (
            "metal",
            with(BodyMaterial::Metal {
                refractive_index: 0.5,
                extinction_coefficient: 4.8,
            }),
        ),
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
    let dose = check::dose(model, x);
    model.outputs()[0].volume_of(dose.as_slice())
}

/// The dose of even patterns.
fn lit(model: &Rays) -> Volume<f32> {
    let x = check::even_patterns(model, 1.0);
    dose(model, &x)
}

#[test]
fn every_vial_with_every_optics_is_an_exact_pair() {
    for vial in vials().into_iter().chain(ended()) {
        for (name, optics) in optics() {
            for reflections in [false, true] {
                let params = Params {
                    rays_per_pixel: 3,
                    reflections,
                    least_power: 0.02,
                    ..Params::default()
                };
                let grid = VolumeGrid::centered([9, 14, 13], 0.2);
                let model = rays(vial.as_ref(), light(3, 5, 7, 0.3), &optics, &params, grid);
                let found = check::model::model(&model, 3)
                    .unwrap_or_else(|e| panic!("{vial:?} {name} {reflections}: {e}"));
                assert!(found.adjoint_error < 1e-6, "{vial:?} {name}: {found:?}");
            }
        }
    }
}

#[test]
#[ignore = "slow"]
fn a_resin_that_differs_from_place_to_place_is_an_exact_pair() {
    let grid = VolumeGrid::centered([9, 14, 13], 0.2);
    let values: Vec<f32> = (0..60).map(|i| 0.1 + 0.05 * (i * 7 % 13) as f32).collect();
    let map = AbsorptionMap::new([3, 4, 5], 0.5, values.clone(), values).unwrap();
    for vial in [Box::new(GLASS) as Box<dyn Vial>]
        .into_iter()
        .chain(ended())
    {
        for (name, optics) in optics() {
            let mut light = light(3, 5, 7, 0.3);
            light.map = Some(Arc::new(map.clone()));
            light.resin.gradient = Some(IndexGradient {
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
    let doses_of = |map: Option<AbsorptionMap>| {
        let mut light = light(6, 6, 24, 0.13);
        light.map = map.map(Arc::new);
        let params = Params {
            rays_per_pixel: 1024,
            ..Params::default()
        };
        let optics = Optics::collimated(0.13);
        let parallel = Parallel::new(&vial, vec![light.clone()], grid.clone()).unwrap();
        let mut x = parallel.new_patterns().unwrap();
        let values: Vec<f32> = (0..x.len()).map(|i| 1.0 + (i as f32 * 0.1).sin()).collect();
        x.copy_from_host(&values);
        let rays = rays(&vial, light, &optics, &params, grid.clone());
        [dose(&parallel, &x), dose(&rays, &x)]
    };
    let difference = |a: &Volume<f32>, b: &Volume<f32>| check::difference(&b.values, &a.values);
    let map = |value: &dyn Fn(usize) -> f32| {
        let values: Vec<f32> = (0..16 * 16).map(value).collect();
        AbsorptionMap::new([1, 16, 16], 0.15, values.clone(), values).unwrap()
    };
    let patches = map(&|i| if (i / 4 + i / 64) % 2 == 0 { 0.1 } else { 0.7 });
    let [parallel, rays] = doses_of(Some(patches));
    let [_, plain] = doses_of(None);
    let (apart, changed) = (difference(&parallel, &rays), difference(&plain, &rays));
    // Without a map the two models are 0.015 apart at this pitch
    assert!(apart < 0.02 && changed > 0.3, "{apart} {changed}");
    let [_, even] = doses_of(Some(map(&|_| 0.3)));
    assert!(difference(&plain, &even) < 1e-5);
}

/// Every cell of every ray by an independent walk in f64: sorted crossings of all planes.
fn brute_force(model: &Rays, x: &[f32]) -> Vec<f64> {
    brute_force_where(model, x, |_, _| true)
}

/// The same of those pieces of segments whose middle (mm along the segment) counts; segments are cut where they cross the ball, too.
fn brute_force_where(
    model: &Rays,
    x: &[f32],
    counts: impl Fn(&PathSegment, f64) -> bool,
) -> Vec<f64> {
    let layout = &model.output;
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
            model.sources[0].for_each_path_segment(
                pair / columns,
                pair % columns,
                row,
                |segment| {
                    let mut cuts = vec![0.0, segment.length];
                    for axis in 0..3 {
                        let planes = [grid.shape[2], grid.shape[1], grid.shape[0]][axis];
                        for plane in 0..=planes {
                            let at = low[axis] + plane as f64 * h;
                            let t = (at - segment.ray.from[axis]) / segment.ray.direction[axis];
                            if t > 0.0 && t < segment.length {
                                cuts.push(t);
                            }
                        }
                    }
                    let ball = chord(segment.ray.from, segment.ray.direction);
                    let within = ball.into_iter().flatten();
                    cuts.extend(within.filter(|t| (0.0..segment.length).contains(t)));
                    cuts.sort_by(f64::total_cmp);
                    for cut in cuts.windows(2) {
                        let at = (cut[0] + cut[1]) / 2.0;
                        let middle = segment.ray.at(at);
                        let cell: [f64; 3] =
                            std::array::from_fn(|i| ((middle[i] - low[i]) / h).floor());
                        let inside = (0..3).all(|i| {
                            let n = [grid.shape[2], grid.shape[1], grid.shape[0]][i];
                            (0.0..n as f64).contains(&cell[i])
                        });
                        if inside && counts(&segment, at) {
                            let left = |t: f64| (-segment.uptake.attenuation_per_mm * t).exp();
                            let [x, y, z] = cell.map(|c| c as usize);
                            dose[grid.index(z, y, x)] +=
                                value * area * segment.power * segment.uptake.active_per_mm
                                    / segment.uptake.attenuation_per_mm
                                    * (left(cut[0]) - left(cut[1]))
                                    / h.powi(3);
                        }
                    }
                },
            );
        }
    }
    dose
}

#[test]
fn both_kernels_equal_a_brute_force_walk_in_f64() {
    let grid = VolumeGrid::centered([19, 23, 37], 0.1).about([0.03, -0.02, 0.05]);
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
                let mut x = model.new_patterns().unwrap();
                let values = check::noise(1, x.len());
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
        let mut x = parallel.new_patterns().unwrap();
        let values: Vec<f32> = (0..x.len()).map(|i| 1.0 + (i as f32 * 0.1).sin()).collect();
        x.copy_from_host(&values);
        let expected = dose(&parallel, &x);
        let difference = |count: usize| {
            let params = Params {
                rays_per_pixel: count,
                ..Params::default()
            };
            let optics = Optics::collimated(0.13);
            let model = rays(vial.as_ref(), light.clone(), &optics, &params, grid.clone());
            let found = dose(&model, &x);
            check::difference(&found.values, &expected.values)
        };
        let (few, many) = (difference(4), difference(1024));
        assert!(many < left && few < left + 0.06, "{vial:?}: {few} {many}");
    }
}

#[test]
fn what_is_absorbed_is_what_the_account_says() {
    let grid = VolumeGrid::centered([40, 40, 40], 0.1);
    // Pixels that are square, and others beside the axis
    for (pitch_mm, offset_mm) in [([0.2; 2], [0.0; 2]), ([0.3, 0.12], [-0.2, 0.1])] {
        for (name, optics) in optics() {
            let mut light = light(1, 3, 3, 0.2);
            (light.pixels.pitch_mm, light.pixels.offset_mm) = (pitch_mm, offset_mm);
            let model = rays(&GLASS, light, &optics, &Params::default(), grid.clone());
            let dose = dose(&model, &check::even_patterns(&model, 1.0));
            let absorbed: f64 = dose.values.iter().map(|&v| f64::from(v)).sum::<f64>() * 1e-3;
            let share = absorbed / (9.0 * pitch_mm[0] * pitch_mm[1]);
            let balance = model.balance(0, 0);
            assert!((balance.total() - 1.0).abs() < 1e-9, "{name}: {balance:?}");
            let off = (share - balance.absorbed).abs();
            assert!(off < 1e-4, "{name}: {share} {balance:?}");
        }
    }
}

#[test]
fn a_frame_of_a_tilted_axis_is_the_level_frame_of_a_resin_that_leans() {
    // Light of one frame from above, in an index-matched medium of no absorption: its centroid leans by the tilt
    let tilt: f64 = 0.25;
    let optics = Optics::collimated(0.1).tilted(tilt);
    let mut light = light(1, 1, 1, 0.1);
    light.pixels.azimuths = vec![0.0];
    light.resin = Resin::pure_radon(1.5);
    let grid = VolumeGrid::centered([80, 11, 41], 0.05);
    let params = Params {
        rays_per_pixel: 1024,
        ..Params::default()
    };
    let model = rays(
        &IndexMatched { radius_mm: 5.0 },
        light,
        &optics,
        &params,
        grid.clone(),
    );
    let x = check::even_patterns(&model, 1.0);
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
            let (walked, cached) = (build(), build().cached());
            check::model::model(&cached, 3).unwrap();
            assert!(walked.cache(&Work::new()).unwrap().is_none());
            let (work, has_column_rays) = (Work::new(), walked.has_column_rays());
            assert_eq!(
                cached.cache(&work).unwrap().is_none(),
                has_column_rays,
                "{name}"
            );
            let column_rays = cached.cached_column_rays(&work).unwrap();
            assert_eq!(column_rays.is_some(), has_column_rays, "{name}");
            let x = check::noisy_patterns(&cached, 1);
            // Some of the frames only, on top of what is there
            let some = |model: &Rays| {
                let mut dose = model.new_dose().unwrap();
                dose.fill(0.5);
                model.dose_of(1..4, &x, &mut dose, &Work::new()).unwrap();
                dose.as_slice().to_vec()
            };
            let back = |model: &Rays| {
                let mut c = model.new_dose().unwrap();
                c.copy_from_host(&check::noise(2, c.len()));
                let grad = check::adjoint(model, &c);
                grad.as_slice().to_vec()
            };
            for [a, b] in [
                [some(&walked), some(&cached)],
                [back(&walked), back(&cached)],
            ] {
                let off = check::largest_difference(&b, &a);
                assert!(off < 1e-5, "{name}: {off}");
            }
            assert!(
                matrix_cache::RayMatrixCache::of(&walked, 100, &work)
                    .unwrap()
                    .is_none()
            );
            assert!(ColumnRaysCache::of(&walked, 100, &work).unwrap().is_none());
        }
    }
}

#[test]
fn rows_that_are_followed_together_leave_what_single_rays_leave() {
    // Twenty slices, two vectors of lanes; the pixels reach beyond the grid. No height is that of a face, where rounding decides
    let grid = VolumeGrid::centered([20, 17, 18], 0.1).about([0.03, -0.02, 0.413]);
    let mut light = light(5, 18, 11, 0.15);
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
    let level = optics().remove(2).1;
    // Half a row higher than a slice: two classes. Rays rise and fall, and the last runs rather along the axis than across
    let tilted = |tilt_rad| level.clone().tilted(tilt_rad);
    let ways = [level.clone(), tilted(0.3), tilted(-0.2), tilted(1.2)];
    for (vial, optics) in vials()
        .iter()
        .flat_map(|vial| ways.iter().map(move |way| (vial, way)))
    {
        let tilt_rad = optics.motion.tilt_rad;
        for (light, reflections) in [(&light, true), (&mapped, false)] {
            let params = Params {
                rays_per_pixel: 3,
                reflections,
                ..Params::default()
            };
            let build = || rays(vial.as_ref(), light.clone(), optics, &params, grid.clone());
            let (together, single) = (build(), build().plain());
            assert!(together.has_column_rays() && !single.has_column_rays());
            let found = check::model::model(&together, 3).unwrap();
            assert!(
                found.adjoint_error < 1e-6,
                "{vial:?}, {tilt_rad}: {found:?}"
            );
            let x = check::noisy_patterns(&single, 1);
            let mut c = single.new_dose().unwrap();
            c.copy_from_host(&check::noise(2, c.len()));
            let both = [&together, &single].map(|model| {
                let grad = check::adjoint(model, &c);
                (dose(model, &x).values, grad.as_slice().to_vec())
            });
            let [(a, of_a), (b, of_b)] = &both;
            for (a, b) in [(a, b), (of_a, of_b)] {
                let off = check::largest_difference(b, a);
                // Slanted: the second order of the shares (slanted.rs) over the longest way that rises by a slice, √3 of a voxel
                let most = if light.map.is_some() { 0.7 } else { 0.3 };
                let fraction: f32 = most * 0.1 * 3f32.sqrt();
                let exact = match tilt_rad {
                    0.0 => 2e-6,
                    _ => 5e-6 + 0.008 * fraction.powi(2),
                };
                assert!(off < exact, "{vial:?}, {tilt_rad}: {off}");
            }
            if tilt_rad == 0.0 {
                let [a, b] = [&together, &single].map(|m| m.updates() as f64);
                assert!((a / b - 1.0).abs() < 1e-4, "{vial:?}: {a} {b}");
            }
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
        let is_apart = matches!(model.z_coupling(), ZCoupling::None);
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
        assert!(matches!(model.z_coupling(), ZCoupling::Full));
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
fn slices_that_fall_between_rows_are_lit_evenly() {
    // A row of 0.1 mm has 16 rays: at four heights they would give a slice of 0.0716 mm two or three, which is 30 % off
    let grid = VolumeGrid::centered([20, 20, 20], 0.0716);
    let mut light = light(40, 24, 32, 0.1);
    light.resin = Resin::pure_radon(1.48);
    let vial = IndexMatched { radius_mm: 1.7 };
    let params = Params {
        rays_per_pixel: 16,
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
                let mut x = model.new_patterns().unwrap();
                model.patterns[0].fill_field(patterns, x.as_mut_slice());
                if patterns.grid == small {
                    check::model::model(&model, 3).unwrap();
                }
                dose(&model, &x)
            });
            let off = check::largest_difference(&b.values, &a.values);
            assert!(off < 2e-6, "{vial:?} {name}: {off}");
        }
    }
}

#[test]
fn light_of_hardly_any_tilt_is_level_light() {
    // Rows begin 5e-7 of a slice below a face, where the shares of a way change over the least span
    let grid = VolumeGrid::centered([16, 17, 18], 0.1).about([0.0, 0.0, 0.05 + 5e-8]);
    for tilt_rad in [1e-13, 1e-10, -1e-8] {
        let optics = Optics::collimated(0.1).tilted(tilt_rad);
        let params = Params {
            rays_per_pixel: 1,
            ..Params::default()
        };
        let dose_of = |optics: &Optics| {
            let model = rays(&GLASS, light(3, 18, 11, 0.1), optics, &params, grid.clone());
            assert!(model.has_column_rays());
            lit(&model)
        };
        let (tilted, level) = (dose_of(&optics), dose_of(&Optics::collimated(0.1)));
        // A share may lie in the next slice, and no row leaves less than nothing or more than it has
        let most = level.values.iter().copied().fold(0.0, f32::max);
        assert!(
            tilted
                .values
                .iter()
                .all(|&v| (0.0..=1.001 * most).contains(&v))
        );
        let [a, b] = [&tilted, &level].map(|volume| volume.values.iter().sum::<f32>());
        assert!((a / b - 1.0).abs() < 0.07, "{tilt_rad}: {a} {b}");
    }
}
