use super::*;
use crate::{DoseModel, monte_carlo};
use std::sync::Arc;
use tomolith_core::check;
use tomolith_core::check::noise;
use tomolith_core::grid::{PatternGrid, Patterns, Volume};
use tomolith_core::near;
use tomolith_optics::motion::Motion;
use tomolith_optics::phase::henyey_greenstein::HenyeyGreenstein;
use tomolith_optics::phase::isotropic::Isotropic;
use tomolith_optics::phase::rayleigh::Rayleigh;
use tomolith_optics::phase::{Phase, Scattering};
use tomolith_optics::projector::Projector;
use tomolith_optics::projector::diverging::Diverging;
use tomolith_optics::projector::lens::Lens;
use tomolith_optics::projector::telecentric::Telecentric;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::cylinder::Cylinder;
use tomolith_optics::vial::double_tube::DoubleTube;
use tomolith_optics::vial::index_matched::IndexMatched;
use tomolith_optics::vial::square::Square;

const BATH: IndexMatched = IndexMatched { radius_mm: 3.0 };

fn light(frames: usize, rows: usize, columns: usize, pitch: f64, scattering: f64) -> Light {
    let pixels = PatternGrid::full_turn(frames, 0.3, rows, columns, pitch);
    let mut light = Light::new(pixels, Resin::absorbing(1.48, 0.13));
    light.resin.attenuation_per_mm = 0.13 + scattering;
    light
}

fn cells(cell_mm: Option<f64>) -> Params {
    Params {
        cell_mm,
        ..Params::default()
    }
}

/// Collimated light in a resin that scatters.
fn optics_of(phase: impl Phase + 'static, per_mm: f64) -> Optics {
    Optics {
        scattering: Some(Scattering::new(per_mm, phase)),
        ..clear()
    }
}

/// Collimated light in a resin that does not.
fn clear() -> Optics {
    Optics::collimated(0.125)
}

/// The same from cones of this sine of the half angle in air, in focus 0.5 mm before the axis.
fn telecentric(optics: &Optics, sine: f64) -> Optics {
    from(
        optics,
        Telecentric {
            pixel_pitch_mm: [0.125; 2],
            aperture_radius_mm: 40.0 * sine,
            working_distance_mm: 40.0,
            focus_mm: 0.5,
        },
    )
}

fn from(optics: &Optics, projector: impl Projector + 'static) -> Optics {
    Optics {
        projector: Arc::new(projector),
        ..optics.clone()
    }
}

fn dose(model: &dyn DoseModel<Field = HostField>, x: &[f32]) -> Volume<f32> {
    let mut field = model.new_patterns().unwrap();
    field.as_mut_slice().copy_from_slice(x);
    let dose = check::dose(model, &field);
    model.outputs()[0].volume_of(dose.as_slice())
}

/// Light that is not scattered, in the total attenuation.
fn unscattered(
    vial: &dyn Vial,
    lights: Vec<Light>,
    optics: &[Optics],
    params: &Params,
    grid: &VolumeGrid,
) -> OnVoxels {
    let (purpose, work) = (Purpose::Probe, Work::new());
    straight(vial, lights, optics, params, grid.clone(), purpose, &work).unwrap()
}

#[test]
#[ignore = "slow"]
fn every_vial_and_phase_is_an_exact_pair() {
    // Its loops are short: called from one of rayon's threads they take 9 s of processor, from outside 22
    rayon::scope(|_| pairs_of_every_vial_and_phase());
}

fn pairs_of_every_vial_and_phase() {
    let vials: [&dyn Vial; 3] = [
        &BATH,
        &Cylinder::new(2.8, 3.0, 1.5),
        &Square::new(5.0, 5.6, 1.5),
    ];
    for (i, vial) in vials.into_iter().enumerate() {
        let phases = [
            optics_of(Rayleigh {}, 0.2),
            optics_of(HenyeyGreenstein { g: 0.4 }, 0.2),
            optics_of(HenyeyGreenstein { g: -0.3 }, 0.2),
        ];
        for (j, scattering) in phases.into_iter().enumerate() {
            let grid = VolumeGrid::centered([9, 14, 13], 0.3);
            let params = cells(Some(0.6));
            // In turn, so that each vial and each phase meets both optics
            let scatters = match (i + j) % 2 {
                0 => telecentric(&scattering, 0.2),
                _ => scattering,
            };
            let lights = vec![light(5, 7, 11, 0.3, 0.2), light(3, 7, 11, 0.3, 0.0)];
            let both = [scatters, clear()];
            let model = model(vial, lights, &both, &params, grid).unwrap();
            let found =
                check::model::model(&model, 3).unwrap_or_else(|e| panic!("{vial:?} {both:?}: {e}"));
            assert!(found.adjoint_error < 1e-6, "{vial:?}: {found:?}");
        }
    }
}

#[test]
fn doses_of_all_purposes_agree_and_have_their_adjoint() {
    let vial = Cylinder::new(2.6, 3.0, 1.55);
    // Quarters of a turn of 8 frames repeat, those of 5 do not
    let lights = || vec![light(8, 7, 11, 0.3, 0.2), light(5, 7, 11, 0.3, 0.2)];
    let optics = [optics_of(Rayleigh {}, 0.2), optics_of(Rayleigh {}, 0.2)];
    let grid = VolumeGrid::centered([9, 14, 14], 0.3);
    let x: Vec<f32> = noise(5, 13 * 7 * 11).iter().map(|v| v.abs()).collect();
    let model_of = |purpose| {
        let (params, work) = (Params::default(), Work::new());
        model_for(
            &vial,
            lights(),
            &optics,
            &params,
            grid.clone(),
            purpose,
            &work,
        )
        .unwrap()
    };
    let expected = dose(&model_of(Purpose::Probe), &x);
    for purpose in [Purpose::Optimize, Purpose::Evaluate { refine: 1 }] {
        let model = model_of(purpose);
        let largest = difference(&dose(&model, &x), &expected).0;
        assert!(largest < 1e-6, "{purpose:?}: {largest}");
        let found = check::model::model(&model, 3).unwrap();
        assert!(found.adjoint_error < 1e-6, "{purpose:?}: {found:?}");
    }
}

/// What a half space of isotropic scatterers sends back of light that falls on it along its normal: 1 − H(1)·√(1 − albedo),
/// H from its integral equation (Chandrasekhar, *Radiative Transfer*, § 38).
fn plane_albedo(albedo: f64) -> f64 {
    const POINTS: usize = 400;
    let mu = |i: usize| (i as f64 + 0.5) / POINTS as f64;
    let mut h = vec![1.0; POINTS];
    let at = |h: &[f64], mu0: f64| {
        let sum: f64 = (0..POINTS).map(|i| mu(i) * h[i] / (mu0 + mu(i))).sum();
        1.0 / ((1.0 - albedo).sqrt() + albedo / 2.0 * sum / POINTS as f64)
    };
    for _ in 0..100 {
        h = (0..POINTS).map(|i| at(&h, mu(i))).collect();
    }
    1.0 - at(&h, 1.0) * (1.0 - albedo).sqrt()
}

#[test]
#[ignore = "slow"]
fn a_half_space_sends_back_what_chandrasekhar_computes() {
    // Four square beams on flat walls, 24 mm of resin at μ_t = 1 behind each
    let vial = Square::new(24.0, 24.2, 1.5);
    for albedo in [0.5, 0.8] {
        let expected = plane_albedo(albedo);
        let mut light = light(4, 4, 4, 0.5, 0.0);
        light.pixels = PatternGrid::full_turn(4, 0.0, 4, 4, 0.5);
        light.surrounding_index = 1.5;
        light.resin = Resin::absorbing(1.5, 1.0 - albedo);
        light.resin.attenuation_per_mm = 1.0;
        let grid = VolumeGrid::centered([60, 96, 96], 0.25);
        let isotropic = optics_of(Isotropic {}, albedo);
        let back = |edge: f64| {
            let params = cells(Some(edge));
            let one = std::slice::from_ref(&isotropic);
            let model = model(&vial, vec![light.clone()], one, &params, grid.clone()).unwrap();
            let dose = dose(&model, &vec![1.0; 4 * 16]);
            let sum: f64 = dose.values.iter().map(|&v| f64::from(v)).sum();
            1.0 - sum * 0.25f64.powi(3) / (4.0 * 16.0 * 0.25)
        };
        let (coarse, fine) = (back(0.5), back(0.25));
        near!(coarse, expected, 0.01 * expected);
        near!(fine, expected, 0.01 * expected);
    }
    // Chandrasekhar's table of H: H(1) = 1.2512 for an albedo of ½, computed here
    assert!((plane_albedo(0.5) - 0.1152).abs() < 1e-4);
}

/// Means over blocks of 4 × 4 × 4 voxels.
fn blocks(volume: &Volume<f32>) -> Vec<f64> {
    let [nz, ny, nx] = volume.grid.shape.map(|n| n / 4);
    let block = |i: usize| {
        let [z, y, x] = [i / (ny * nx), i / nx % ny, i % nx].map(|n| 4 * n);
        let voxel = |i: usize| f64::from(*volume.at(z + i / 16, y + i / 4 % 4, x + i % 4));
        (0..64).map(voxel).sum::<f64>() / 64.0
    };
    (0..nz * ny * nx).map(block).collect()
}

/// Root mean square and largest of the numbers.
fn size(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut squares, mut most, mut count) = (0.0, 0.0f64, 0.0);
    for number in numbers {
        squares += number * number;
        most = most.max(number.abs());
        count += 1.0;
    }
    (f64::sqrt(squares / count), most)
}

/// Root mean square and largest of the difference in blocks, over the mean dose.
fn difference(a: &Volume<f32>, b: &Volume<f32>) -> (f64, f64) {
    let (a, b) = (blocks(a), blocks(b));
    let mean = a.iter().sum::<f64>() / a.len() as f64;
    size(a.iter().zip(&b).map(|(a, b)| (a - b) / mean))
}

/// How far blocks are off those of two runs of Monte Carlo paths, over the mean dose: root mean square, without the noise of the paths (it is not in the
/// mean of the product, since they are independent), and the largest, off the mean of both.
fn off(found: &[f64], [one, two]: &[Vec<f64>; 2]) -> (f64, f64) {
    let mean = one.iter().sum::<f64>() / one.len() as f64;
    let each = |i: usize| [(found[i] - one[i]) / mean, (found[i] - two[i]) / mean];
    let products = (0..found.len()).map(|i| each(i).iter().product::<f64>());
    let rms = (products.sum::<f64>() / found.len() as f64).max(0.0).sqrt();
    let most = (0..found.len()).map(|i| (each(i).iter().sum::<f64>() / 2.0).abs());
    (rms, most.fold(0.0, f64::max))
}

/// The light that `whole` has and `straight` has not.
fn scattered(whole: &Volume<f32>, straight: &Volume<f32>) -> Volume<f32> {
    let both = whole.values.iter().zip(&straight.values);
    Volume::new(
        whole.grid.clone(),
        both.map(|(whole, straight)| whole - straight).collect(),
    )
}

/// A lens of f/3 that images onto the axis.
const LENS: Lens = Lens {
    pixel_pitch_mm: [0.125; 2],
    aperture_radius_mm: 5.0,
    distance_mm: 30.0,
    focus_distance_mm: 30.0,
};

/// Two bars of light: 24 frames of 32 columns of 8 pixels.
fn two_bars() -> Vec<f32> {
    let lit = |i: usize| (i / 8) % 16 < 8;
    (0..24 * 32 * 8)
        .map(|i| f32::from(u8::from(lit(i))))
        .collect()
}

#[test]
#[ignore = "slow"]
fn scattered_light_of_cones_and_tilted_light_is_that_of_monte_carlo_paths_where_it_is_bright_and_dark()
 {
    let glass = Cylinder::new(2.8, 3.0, 1.55);
    let square = Square::new(5.0, 5.6, 1.5);
    let grid = VolumeGrid::centered([16, 32, 32], 0.125);
    let (rayleigh, lobe) = (
        optics_of(Rayleigh {}, 0.3),
        optics_of(HenyeyGreenstein { g: 0.4 }, 0.3),
    );
    let aside = |tilt_rad: f64| Motion {
        tilt_rad,
        offset_mm: [0.3, -0.2],
        ..Motion::default()
    };
    let leaning = Optics {
        motion: aside(0.15),
        ..rayleigh.clone()
    };
    let cases: [(&dyn Vial, Optics); 9] = [
        // What cells cost any light
        (&glass, rayleigh.clone()),
        (&BATH, telecentric(&rayleigh, 0.1)),
        (&glass, telecentric(&rayleigh, 0.3)),
        (&glass, telecentric(&lobe, 0.1)),
        (&square, telecentric(&rayleigh, 0.1)),
        (&square, telecentric(&lobe, 0.3)),
        (&glass, from(&rayleigh, Diverging::new([0.125; 2], 30.0))),
        (&square, from(&rayleigh, LENS)),
        (&glass, leaning),
    ];
    for (vial, optics) in cases {
        let (lights, x, optics) = ([light(24, 8, 32, 0.125, 0.3)], two_bars(), [optics]);
        // The unscattered light of either has its own graininess: 4 rays a pixel by orders, as many as paths by these
        let by_paths = |seed: u64| {
            let params = monte_carlo::Params {
                paths_per_pixel: 48,
                smooth: 1,
                seed,
                ..Default::default()
            };
            let paths = monte_carlo::model(vial, &lights, &optics, &params, grid.clone()).unwrap();
            let straight = monte_carlo::straight(vial, &lights, &optics, &params, grid.clone());
            let whole = dose(&paths, &x);
            let scattered = scattered(&whole, &dose(&straight.unwrap(), &x));
            (blocks(&whole), blocks(&scattered))
        };
        let [(whole, first), (_, second)] = [1, 2].map(by_paths);
        let defaults = Params::default();
        let orders = model(vial, lights.to_vec(), &optics, &defaults, grid.clone()).unwrap();
        let straight = unscattered(vial, lights.to_vec(), &optics, &defaults, &grid);
        let found = scattered(&dose(&orders, &x), &dose(straight.model(), &x));
        let found = blocks(&found);
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let middle = mean(&whole);
        let [bright, dark]: [Vec<usize>; 2] = (0..whole.len())
            .partition::<Vec<_>, _>(|&i| whole[i] > middle)
            .into();
        let part: Vec<f64> = bright.iter().map(|&i| whole[i]).collect();
        // As the report: over the mean dose of the bright; of independent paths the noise is not in the mean of the product
        let rms = |chosen: &[usize]| {
            let product = |&i: &usize| (found[i] - first[i]) * (found[i] - second[i]);
            let products: Vec<f64> = chosen.iter().map(product).collect();
            mean(&products).max(0.0).sqrt() / mean(&part)
        };
        let (bright, dark) = (rms(&bright), rms(&dark));
        assert!(
            bright < 0.0065 && dark < 0.0045,
            "{optics:?}: {bright} {dark}"
        );
    }
}

#[test]
#[ignore = "slow"]
fn it_agrees_with_monte_carlo_paths_in_every_vial_and_phase() {
    let vials: [&dyn Vial; 3] = [
        &BATH,
        &Cylinder::new(2.8, 3.0, 1.55),
        &Square::new(5.0, 5.6, 1.5),
    ];
    let grid = VolumeGrid::centered([16, 32, 32], 0.125);
    for vial in vials {
        for (optics, allowed) in [
            (optics_of(Rayleigh {}, 0.3), 0.0035),
            (optics_of(Isotropic {}, 0.3), 0.0035),
            (optics_of(HenyeyGreenstein { g: 0.4 }, 0.3), 0.0075),
        ] {
            let optics = [optics];
            let light = light(24, 8, 32, 0.125, 0.3);
            let x = two_bars();
            let lights = [light];
            let by_paths = |seed: u64| {
                let params = monte_carlo::Params {
                    paths_per_pixel: 48,
                    smooth: 1,
                    seed,
                    ..Default::default()
                };
                let paths = monte_carlo::model(vial, &lights, &optics, &params, grid.clone());
                blocks(&dose(&paths.unwrap(), &x))
            };
            let paths = [1, 2].map(by_paths);
            let defaults = Params::default();
            let orders = model(vial, lights.to_vec(), &optics, &defaults, grid.clone()).unwrap();
            let (rms, most) = off(&blocks(&dose(&orders, &x)), &paths);
            assert!(
                rms < allowed && most < 0.025,
                "{vial:?} {optics:?}: {rms} {most}"
            );
        }
    }
}

#[test]
#[ignore = "slow"]
fn light_that_wanders_far_above_what_is_lit_comes_back() {
    // Scattered fifteen times before it is absorbed: with one free path of resin above and below 5.5 % of the dose would be missing
    let grid = VolumeGrid::centered([8, 16, 16], 0.25);
    let optics = [optics_of(Rayleigh {}, 1.5)];
    let mut light = light(24, 8, 32, 0.125, 1.5);
    light.resin.attenuation_per_mm = 1.6;
    let x = two_bars();
    let lights = [light];
    let params = monte_carlo::Params {
        paths_per_pixel: 64,
        smooth: 1,
        ..Default::default()
    };
    let paths = monte_carlo::model(&BATH, &lights, &optics, &params, grid.clone()).unwrap();
    let defaults = Params::default();
    let orders = model(&BATH, lights.to_vec(), &optics, &defaults, grid.clone()).unwrap();
    let [by_paths, by_orders] = [dose(&paths, &x), dose(&orders, &x)];
    let sum = |dose: &Volume<f32>| dose.values.iter().map(|&v| f64::from(v)).sum::<f64>();
    let ratio = sum(&by_orders) / sum(&by_paths);
    assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
}

#[test]
#[ignore = "slow"]
fn cones_without_an_opening_are_collimated_light() {
    let grid = VolumeGrid::centered([16, 32, 32], 0.125);
    let glass = Cylinder::new(2.8, 3.0, 1.55);
    for scattering in [
        optics_of(Rayleigh {}, 0.3),
        optics_of(HenyeyGreenstein { g: 0.4 }, 0.3),
    ] {
        let x: Vec<f32> = noise(5, 24 * 32 * 8).iter().map(|v| v.abs()).collect();
        let doses = |optics: &Optics, rays: usize| {
            let params = Params {
                rays_per_pixel: Some(rays),
                ..Params::default()
            };
            let light = || vec![light(24, 8, 32, 0.125, 0.3)];
            let one = std::slice::from_ref(optics);
            let whole = model(&glass, light(), one, &params, grid.clone()).unwrap();
            let straight = unscattered(&glass, light(), one, &params, &grid);
            scattered(&dose(&whole, &x), &dose(straight.model(), &x))
        };
        let expected = doses(&scattering, 1);
        // An opening too small to see, with rays that are sampled as in any cone
        let few = difference(&doses(&telecentric(&scattering, 1e-6), 4), &expected);
        let many = difference(&doses(&telecentric(&scattering, 1e-6), 64), &expected);
        assert!(few.0 < 1e-3 && many.0 < 3e-4, "{few:?} {many:?}");
    }
}

#[test]
#[ignore = "slow"]
fn smaller_cells_change_less_and_less() {
    let grid = VolumeGrid::centered([12, 24, 24], 0.125);
    let x = {
        let mut x = noise(4, 12 * 24 * 12);
        x.iter_mut().for_each(|v| *v = v.abs());
        x
    };
    let with = |edge: f64| {
        let params = cells(Some(edge));
        let light = light(12, 12, 24, 0.125, 0.3);
        let model = model(
            &BATH,
            vec![light],
            &[optics_of(Rayleigh {}, 0.3)],
            &params,
            grid.clone(),
        );
        dose(&model.unwrap(), &x)
    };
    let finest = with(0.0625);
    let [coarse, middle] = [0.375, 0.1875].map(|edge| difference(&with(edge), &finest).0);
    // Pixels of noise on cells of three by three pixels: the worst that patterns can be
    assert!(middle < 0.5 * coarse && coarse < 0.005, "{coarse} {middle}");
}

#[test]
fn what_it_does_not_cover_is_refused_with_the_reason() {
    let tube = DoubleTube::new([3.0, 2.8, 0.5, 0.4], [1.5, 1.5, 1.33]);
    let refused = |vial: &dyn Vial, shape: [usize; 3], scattering, cell_mm| {
        let grid = VolumeGrid::centered(shape, 0.3);
        let light = light(3, 4, 4, 0.3, 0.2);
        let params = cells(cell_mm);
        let model = model(vial, vec![light], &[scattering], &params, grid);
        model.err().unwrap().to_string()
    };
    let rayleigh = optics_of(Rayleigh {}, 0.2);
    assert!(refused(&tube, [4, 8, 8], rayleigh.clone(), None).contains("see each other"));
    assert!(refused(&BATH, [1, 8, 8], rayleigh.clone(), None).contains("single slice"));
    let peaked = optics_of(HenyeyGreenstein { g: 0.5 }, 0.2);
    assert!(refused(&BATH, [4, 8, 8], peaked, None).contains("forward peak"));
    // 6 mm across and high in cells of 1 µm: told what would do, before any array
    let many = refused(&BATH, [4, 8, 8], rayleigh, Some(1e-3));
    assert!(
        many.contains("model.successive_orders.cell_mm") && many.contains("0.036 mm or more"),
        "{many}"
    );
}

#[test]
#[ignore = "slow"]
fn pixels_three_times_as_high_beside_the_axis_are_three_equal_ones() {
    // Cells of 0.48 mm hold 4 columns, and 4 or 12 rows; light is made sharper by a thousandth less where its pixels are larger
    let scattering = optics_of(Rayleigh {}, 0.2);
    let grid = VolumeGrid::centered([12, 12, 12], 0.16);
    let params = cells(Some(0.49));
    let mut by_height = Vec::new();
    for factor in [1, 3] {
        let mut light = light(5, 36 / factor, 24, 0.12, 0.2);
        light.pixels.pitch_mm = [0.12, 0.04 * factor as f64];
        light.pixels.offset_mm = [0.06, 0.08];
        let values: Vec<f32> = (0..light.pixels.len())
            .map(|i| (factor * (i / 24 % (36 / factor)) / 3) as f32)
            .collect();
        let patterns = Patterns {
            grid: light.pixels.clone(),
            values,
        };
        let model = model(
            &BATH,
            vec![light],
            std::slice::from_ref(&scattering),
            &params,
            grid.clone(),
        )
        .unwrap();
        check::model::model(&model, 3).unwrap();
        let layout = &model.patterns()[0];
        let mut x = vec![0.0; layout.len()];
        layout.fill_field(&patterns, &mut x);
        by_height.push(dose(&model, &x).values);
    }
    let off = check::largest_difference(&by_height[1], &by_height[0]);
    assert!(off < 2e-3, "{off}");
}

#[test]
fn far_from_a_narrow_beam_voxels_hold_what_monte_carlo_paths_bring_them_at_the_wall_too() {
    let grid = VolumeGrid::centered([16, 26, 26], 0.25);
    let mut narrow = light(3, 4, 2, 0.25, 0.3);
    narrow.pixels.azimuths.truncate(1);
    let (sin, cos) = narrow.pixels.azimuths[0].sin_cos();
    let lights = [narrow];
    let optics = [optics_of(Rayleigh {}, 0.3)];
    let x = vec![1.0; 8];
    let params = monte_carlo::Params {
        paths_per_pixel: 4096,
        smooth: 1,
        ..Default::default()
    };
    let paths = monte_carlo::model(&BATH, &lights, &optics, &params, grid.clone()).unwrap();
    let defaults = Params::default();
    let orders = model(&BATH, lights.to_vec(), &optics, &defaults, grid.clone()).unwrap();
    let [by_paths, by_orders] = [dose(&paths, &x), dose(&orders, &x)];
    // Farther than 1 mm from the beam: sums over voxels that are all resin, and over those that the wall cuts
    let mut sums = [[0.0f64; 2]; 2];
    for i in 0..grid.len() {
        let (x, y) = (grid.x(i % 26), grid.y(i / 26 % 26));
        let corners = [
            (-0.125, -0.125),
            (-0.125, 0.125),
            (0.125, -0.125),
            (0.125, 0.125),
        ];
        let inside = (corners.iter()).filter(|(dx, dy)| (x + dx).hypot(y + dy) < 3.0);
        let place = match inside.count() {
            _ if (y * cos - x * sin).abs() < 1.0 => continue,
            0 => continue,
            4 => 0,
            _ => 1,
        };
        sums[place][0] += f64::from(by_orders.values[i]);
        sums[place][1] += f64::from(by_paths.values[i]);
    }
    let [whole, cut] = sums.map(|[orders, paths]| orders / paths - 1.0);
    // The paths' own noise is 1 %; doses of whole voxels at the wall would be 42 % too high
    assert!(whole.abs() < 0.03 && cut.abs() < 0.09, "{whole} {cut}");
}
