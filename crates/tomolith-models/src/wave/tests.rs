//! The wave model against direct sums in f64, closed forms, and itself.

use super::light::Propagation;
use super::*;
use crate::DoseModel;
use crate::PatternLayout;
use crate::Work;
use std::f64::consts::PI;
use tomolith_core::check;
use tomolith_core::check::noise;
use tomolith_core::field::Field;
use tomolith_core::grid::PatternGrid;
use tomolith_core::near;
use tomolith_fourier::Complex;
use tomolith_optics::resin::Resin;
use tomolith_optics::vial::index_matched::IndexMatched;

const VIAL: IndexMatched = IndexMatched { radius_mm: 0.02 };

/// Room for voxels of some tenths of a millimeter.
const WIDE: IndexMatched = IndexMatched { radius_mm: 10.0 };

/// Frames of 14 × 18 pixels of 0.8 µm: up to 13° on the axis of the frequencies, 18° in their corners.
fn light(frames: usize) -> Light {
    let mut light = Light::new(
        PatternGrid::full_turn(frames, 0.3, 14, 18, 0.8e-3),
        Resin::absorbing(1.5, 20.0),
    );
    light.pixels.offset_mm = [0.3e-3, -0.2e-3];
    light
}

/// 7 × 9 × 10 voxels of 0.8 µm, off the axis and off the rows.
fn grid() -> VolumeGrid {
    VolumeGrid::centered([7, 9, 10], 0.8e-3).about([0.5e-3, -0.3e-3, 0.15e-3])
}

fn settings(error: f64) -> Settings {
    Settings {
        relative_error: error,
        rotation_error: error,
        ..Params::default().settings()
    }
}

/// A focal plane that lies so far behind the axis.
fn focused(focus_mm: f64) -> Params {
    Params {
        focus_mm,
        ..Params::default()
    }
}

/// An aperture.
fn through(aperture: f64) -> Params {
    Params {
        numerical_aperture: Some(aperture),
        ..Params::default()
    }
}

type Precise = (WaveLight<f64, Coherent<f64>>, PatternLayout, DoseLayout);

/// A light in f64, with the layout of its patterns and of its dose.
fn precise(light: &Light, params: &Params, settings: Settings, grid: VolumeGrid) -> Precise {
    let layout = DoseLayout::new("dose", grid, 0);
    let vial = if light.resin.pure_radon { WIDE } else { VIAL };
    let settings = Settings {
        entrance: params.entrance,
        focus_mm: params.focus_mm,
        ..settings
    };
    let built = light_of(&vial, light, params, &settings, &layout, 0, 0).unwrap();
    (built, light.layout(0), layout)
}

fn amplitudes(seed: u64, len: usize) -> Vec<f64> {
    noise(seed, len).iter().map(|&v| f64::from(v)).collect()
}

fn dose_of((built, pixels, layout): &Precise, x: &[f64]) -> Vec<f64> {
    let mut dose = vec![0.0; layout.len()];
    let frames = 0..pixels.grid.frames();
    built
        .add_dose(pixels, frames, x, &mut dose, &Work::new())
        .unwrap();
    dose
}

/// |ψ|² at a place behind one frame: the sum over the frequencies of a window itself.
struct Direct {
    spectrum: Vec<(f64, f64, Complex<f64>)>,
    wavenumber: f64,
}

impl Direct {
    fn new(
        light: &Light,
        frame: usize,
        x: &[f64],
        padded: [usize; 2],
        aperture: Option<f64>,
        mode: [f64; 2],
    ) -> Self {
        // A quarter of the band fades as cos²
        let fade = |share: f64| {
            (0.5 * PI * ((share - 0.75) / 0.25).clamp(0.0, 1.0))
                .cos()
                .powi(2)
        };
        let pixels = &light.pixels;
        let layout = light.layout(0);
        let wavenumber = light.resin.refractive_index / (light.wavelength_nm * 1e-6);
        let [pu, pz] = pixels.pitch_mm;
        let half = padded.map(|n| n as i64 / 2);
        let window = [padded[0] as f64 * pu, padded[1] as f64 * pz];
        let mut spectrum = Vec::new();
        for fz in 1 - half[1]..half[1] {
            for fu in 1 - half[0]..half[0] {
                let (u, z) = (fu as f64 / window[0], fz as f64 / window[1]);
                let passes = fade(2.0 * pu * u.abs())
                    * fade(2.0 * pz * z.abs())
                    * aperture.map_or(1.0, |na| fade((u + mode[0]).hypot(z + mode[1]) / na));
                let mut sum = Complex::new(0.0, 0.0);
                for column in 0..pixels.columns {
                    let run = &layout.runs[frame * pixels.columns + column];
                    for i in 0..run.count as usize {
                        let row = pixels.rows - 1 - run.bottom as usize - i;
                        let phase = -TAU * (u * pixels.column_u(column) + z * pixels.row_z(row));
                        sum += Complex::from_polar(x[run.offset + i], phase);
                    }
                }
                // The mode's own phase across is not seen in |ψ|²
                spectrum.push((
                    u + mode[0],
                    z + mode[1],
                    passes * sum / (padded[0] * padded[1]) as f64,
                ));
            }
        }
        Direct {
            spectrum,
            wavenumber,
        }
    }

    fn intensity(&self, [d, u, z]: [f64; 3]) -> f64 {
        let k2 = self.wavenumber * self.wavenumber;
        let mut sum = Complex::new(0.0, 0.0);
        for &(fu, fz, value) in &self.spectrum {
            let w2 = k2 - fu * fu - fz * fz;
            let (along, fading) = if w2 > 0.0 {
                (w2.sqrt(), 1.0)
            } else {
                (0.0, (-TAU * d.abs() * (-w2).sqrt()).exp())
            };
            let phase = TAU * (along * d + fu * u + fz * z);
            sum += value * Complex::from_polar(fading, phase);
        }
        sum.norm_sqr()
    }
}

/// Where modes lie, as docs/wave.md says it.
fn modes_of_the_page(light: &Light, params: &Params) -> Vec<[f64; 2]> {
    let wavenumber = light.resin.refractive_index / (light.wavelength_nm * 1e-6);
    let most = wavenumber * params.etendue_deg.to_radians().sin();
    let rings = params
        .rings
        .filter(|_| params.etendue_deg > 0.0)
        .unwrap_or(0);
    let mut modes = vec![[0.0; 2]];
    for r in 1..=rings {
        let share = (1 + 3 * r * r) as f64 / (1 + 3 * rings * (rings + 1)) as f64;
        for i in 0..6 * r {
            let (sin, cos) = (TAU * i as f64 / (6 * r) as f64).sin_cos();
            let size = most * share.sqrt();
            modes.push([size * cos, size * sin]);
        }
    }
    modes
}

#[test]
fn dose_is_the_direct_sum_over_frequencies() {
    for (name, params, finer) in [
        ("plain", Params::default(), 1),
        ("aperture", through(0.2), 1),
        (
            "focus behind the axis, voxels of half the rows' distance",
            focused(2e-3),
            2,
        ),
        (
            "modes, through an aperture",
            Params {
                etendue_deg: 3.0,
                rings: Some(2),
                numerical_aperture: Some(0.2),
                ..Params::default()
            },
            1,
        ),
        (
            "absorption from a plane",
            Params {
                entrance: Entrance::Plane,
                ..Params::default()
            },
            1,
        ),
    ] {
        let light = light(3);
        let grid = if finer == 1 {
            grid()
        } else {
            grid().refined(finer)
        };
        let model = precise(&light, &params, settings(1e-4), grid.clone());
        let x = amplitudes(7, model.1.len());
        let dose = dose_of(&model, &x);
        let aperture = params.numerical_aperture.map(|na| na / 405e-6);
        let padded = model.0.propagation.windows().sampling.padded;
        let frames: Vec<Direct> = (0..3)
            .flat_map(|frame| {
                let modes = modes_of_the_page(&light, &params).into_iter();
                let direct = |mode| Direct::new(&light, frame, &x, padded, aperture, mode);
                modes.map(direct).collect::<Vec<_>>()
            })
            .collect();
        let modes = frames.len() / 3;
        let [nz, ny, nx] = grid.shape;
        let (mut error, mut square) = (0.0, 0.0);
        for place in (0..nz * ny * nx).step_by(3) {
            let (iz, iy, ix) = (place / (nx * ny), place / nx % ny, place % nx);
            let mut expected = 0.0;
            for (modes_of_frame, azimuth) in frames.chunks(modes).zip(&light.pixels.azimuths) {
                let (sin, cos) = azimuth.sin_cos();
                let d = -(grid.x(ix) * cos + grid.y(iy) * sin);
                let u = grid.y(iy) * cos - grid.x(ix) * sin;
                let enter = match params.entrance {
                    Entrance::Plane => -VIAL.radius_mm,
                    Entrance::Wall => -(VIAL.radius_mm.powi(2) - u * u).sqrt(),
                };
                let taken = 20.0 * (-20.0 * (d - enter)).exp();
                let at = [d - params.focus_mm, u, grid.z(iz)];
                let light: f64 = modes_of_frame.iter().map(|mode| mode.intensity(at)).sum();
                expected += taken * light / modes as f64;
            }
            let found = dose[model.2.index(iz, iy, ix)];
            error += (found - expected).powi(2);
            square += expected * expected;
        }
        // Errors asked for: 1e-4 along and 1e-4 across of light that fills the band, which this noise does
        let error = (error / square).sqrt();
        assert!(error < 3e-4, "{name}: {error}");
    }
}

/// 3 × 2 × 64 voxels of 0.8 µm along one frame's light: long enough for fields between depths, which `settings` takes wherever they are.
fn interpolating(settings: Settings) -> (Light, Precise) {
    let mut light = light(1);
    light.pixels.azimuths = vec![0.0];
    light.resin = Resin::pure_radon(1.5);
    let grid = VolumeGrid::centered([3, 2, 64], 0.8e-3).about([0.5e-3, 0.0, 0.0]);
    let eager = Settings {
        fields_cost: 1e-3,
        ..settings
    };
    let model = precise(&light, &Params::default(), eager, grid);
    (light, model)
}

#[test]
fn light_of_interpolated_fields_is_the_direct_sum() {
    let (light, model) = interpolating(settings(1e-4));
    let sampling = &model.0.propagation.windows().sampling;
    let fields = sampling.fields.as_ref().map(|fields| fields.depths.count);
    assert!(fields.is_some_and(|count| count < sampling.along.computed.count));
    let x = amplitudes(7, model.1.len());
    let dose = dose_of(&model, &x);
    let direct = Direct::new(&light, 0, &x, sampling.padded, None, [0.0; 2]);
    let grid = &model.2.grid;
    let (mut error, mut square) = (0.0, 0.0);
    for ix in 0..64 {
        let expected = direct.intensity([-grid.x(ix), grid.y(1), grid.z(1)]);
        error += (dose[model.2.index(1, 1, ix)] - expected).powi(2);
        square += expected * expected;
    }
    // As where no fields are interpolated
    let error = (error / square).sqrt();
    assert!(error < 3e-4, "{error}");
}

#[test]
fn the_gradient_of_interpolated_fields_is_exact() {
    let (_, model) = interpolating(settings(1e-2));
    assert!(model.0.propagation.windows().sampling.fields.is_some());
    let error = derivative_error(&model);
    assert!(error < 1e-12, "{error}");
}

/// The pullback against the central difference, which is exact for a quadratic whatever the step, relative to the doses.
fn derivative_error(model: &Precise) -> f64 {
    let (built, pixels, layout) = model;
    let (x, d) = (amplitudes(1, pixels.len()), amplitudes(2, pixels.len()));
    let cotangent = amplitudes(3, layout.len());
    let at = |s: f64| {
        let place: Vec<f64> = x.iter().zip(&d).map(|(x, d)| x + s * d).collect();
        let dose = dose_of(model, &place);
        dose.iter().zip(&cotangent).map(|(a, b)| a * b).sum::<f64>()
    };
    let (more, less) = (at(1.0), at(-1.0));
    let mut grad = vec![0.0; pixels.len()];
    let (frames, work) = (0..pixels.grid.frames(), Work::new());
    let pulled = built.pull_back(pixels, frames, &x, &cotangent, &mut grad, &work);
    pulled.unwrap();
    let slope: f64 = grad.iter().zip(&d).map(|(g, d)| g * d).sum();
    (slope - 0.5 * (more - less)).abs() / (more.abs() + less.abs())
}

#[test]
fn what_frames_at_work_take_is_what_is_reckoned() {
    for model in [
        precise(&light(2), &Params::default(), settings(1e-3), grid()),
        interpolating(settings(1e-3)).1,
    ] {
        let (built, pixels, layout) = &model;
        let x = amplitudes(1, pixels.len());
        let held = check::on_threads(1, || {
            let work = Work::new();
            let mut doses = [vec![0.0; layout.len()], vec![0.0; layout.len()]];
            let doses = doses.each_mut().map(Vec::as_mut_slice);
            built.add_along(pixels, [&x, &x], doses, &work).unwrap();
            let cotangent = vec![1.0; layout.len()];
            let mut grad = vec![0.0; pixels.len()];
            let frames = 0..pixels.grid.frames();
            let pulled = built.pull_back(pixels, frames, &x, &cotangent, &mut grad, &work);
            pulled.unwrap();
            built.kept_bytes()
        });
        let windows = built.propagation.windows();
        // Kernels and samples that are gathered together are not the scratches'
        let reckoned = windows.of_frame(layout.row, 2);
        let ratio = reckoned as f64 / held as f64;
        assert!((0.8..2.0).contains(&ratio), "{reckoned} {held}");
    }
}

#[test]
fn gradient_is_the_transpose_of_the_derivative_in_f64() {
    for params in [
        Params::default(),
        Params {
            numerical_aperture: Some(0.22),
            focus_mm: 1e-3,
            etendue_deg: 2.0,
            rings: Some(1),
            ..Params::default()
        },
        Params {
            band_limit: BandLimit::Tapered,
            ..Params::default()
        },
    ] {
        let model = precise(&light(3), &params, settings(1e-2), grid());
        let error = derivative_error(&model);
        assert!(error < 1e-12, "{params:?}: {error}");
    }
}

#[test]
fn the_model_of_a_job_is_an_exact_pair_in_f32() {
    for params in [
        Params::default(),
        Params {
            etendue_deg: 1.0,
            rings: Some(1),
            numerical_aperture: Some(0.2),
            ..Params::default()
        },
    ] {
        let lights = vec![light(3), light(2)];
        let waves = model(&VIAL, lights, &params, grid()).unwrap();
        let found = check::model::model(&waves, 4).unwrap();
        assert!(found.adjoint_error < 2e-6, "{found:?}");
    }
}

#[test]
fn the_field_before_the_focus_is_the_conjugate_of_that_behind_it() {
    let light = light(1);
    let x = amplitudes(5, light.layout(0).len());
    let direct = Direct::new(&light, 0, &x, [48; 2], None, [0.0; 2]);
    let mut worst = 0.0f64;
    for i in 0..20 {
        let t = f64::from(i) * 0.3e-3;
        let [before, behind] = [-1.0, 1.0].map(|s| direct.intensity([s * t, 0.4e-3 - t, 0.5 * t]));
        worst = worst.max((before / behind - 1.0).abs());
    }
    assert!(worst < 1e-12, "{worst}");
}

/// Fluence along one frame's light through the axis: `[depth][height]` of voxels, and the grid.
fn along_the_light(light: &Light, x: &[f64], params: &Params, grid: &VolumeGrid) -> Vec<f64> {
    let model = precise(light, params, settings(1e-4), grid.clone());
    let dose = dose_of(&model, x);
    model
        .2
        .volume_of(&dose.iter().map(|&v| v as f32).collect::<Vec<_>>())
        .values
        .iter()
        .map(|&v| f64::from(v))
        .collect()
}

/// Light from +x onto pixels of an edge `pitch`, and amplitudes by a function of u and z.
fn beam_from_x(
    rows: usize,
    columns: usize,
    pitch: f64,
    amplitude: impl Fn(f64, f64) -> f64,
) -> (Light, Vec<f64>) {
    let light = Light::new(
        PatternGrid::full_turn(1, 0.0, rows, columns, pitch),
        Resin::pure_radon(1.5),
    );
    let pixels = &light.pixels;
    let x = (0..columns)
        .flat_map(|c| (0..rows).map(move |i| (c, rows - 1 - i)))
        .map(|(c, row)| amplitude(pixels.column_u(c), pixels.row_z(row)))
        .collect();
    (light, x)
}

#[test]
fn a_gaussian_beam_widens_as_its_closed_form() {
    // Waist w₀ = 10 µm in resin: Rayleigh length π·w₀²/λ = 1.164 mm; fluence on the axis 1/(1 + (d/z_R)²) of the waist's
    let waist = 0.01;
    let (light, x) = beam_from_x(192, 96, 0.001, |u, z| {
        (-(u * u + z * z) / (waist * waist)).exp()
    });
    let rayleigh = PI * waist * waist / (405e-6 / 1.5);
    let grid = VolumeGrid::centered([2, 1, 121], 0.001).about([0.0, 0.0, 0.0005]);
    // Voxels 1 µm apart in a plane cannot reach a Rayleigh length: the focal plane moves instead
    for focus in [0.0, 0.5, 1.5, 3.0] {
        let params = focused(focus);
        let found = along_the_light(&light, &x, &params, &grid);
        for ix in [0, 40, 60, 120] {
            let depth = -grid.x(ix) - focus;
            let spread = 1.0 + (depth / rayleigh).powi(2);
            for (iz, z) in [(0, 0.0), (1, 0.001)] {
                let expected = (-2.0 * z * z / (waist * waist * spread)).exp() / spread;
                let found = found[iz * 121 + ix];
                assert!(
                    (found / expected - 1.0).abs() < 2e-4,
                    "{focus} {ix}: {found} {expected}"
                );
            }
        }
    }
}

#[test]
fn a_grating_repeats_itself_at_the_talbot_distance() {
    // Pixels of 2 µm, 4 of them a period p = 8 µm: 2·p²/λ = 0.474 mm; paraxial to (λ/p)² = 1e-3
    let period = 0.008;
    // Under a wide Gaussian, whose own Rayleigh lengths are 23 and 94 mm, so that no edge throws rings
    let envelope = |u: f64, z: f64| (-(u / 0.09).powi(2) - (z / 0.045).powi(2)).exp();
    let (light, x) = beam_from_x(128, 256, 0.002, |u, z| {
        envelope(u, z) * (0.5 + 0.5 * (TAU * u / period).cos())
    });
    let k = 1.5 / 405e-6f64;
    // Exactly: where the first order and the zeroth are in phase again
    let talbot = 1.0 / (k - (k * k - period.powi(-2)).sqrt());
    assert!((talbot / (2.0 * period * period * k) - 1.0).abs() < 1e-3);
    let grid = VolumeGrid::centered([2, 16, 1], 0.002);
    let at = |focus: f64| {
        let params = focused(focus);
        along_the_light(&light, &x, &params, &grid)
    };
    let (here, half, full) = (at(0.0), at(0.5 * talbot), at(talbot));
    for iy in 0..16 {
        let u = grid.y(iy);
        // (1 + cos)²/4, and half a period beside it half way
        let expected = (0.5 + 0.5 * (TAU * u / period).cos()).powi(2);
        let shifted = (0.5 - 0.5 * (TAU * u / period).cos()).powi(2);
        let size = envelope(u, 0.001).powi(2);
        for (found, expected) in [
            (here[iy], expected),
            (half[iy], shifted),
            (full[iy], expected),
        ] {
            // Orders walk apart by λ/p·d = 16 µm under the envelope: 1 − cosh-like terms of (16/90)²/2
            near!(found, size * expected, 0.02, "{u}: {found} {expected}");
        }
    }
}

#[test]
fn two_slits_interfere_with_the_spacing_of_young() {
    // Slits 16 µm apart, 4 mm before: fringes λ·L/s = 67.5 µm apart
    let (slit, distance) = (0.016, 4.0);
    // Each slit two pixels wide, and Gaussian along z
    let (light, x) = beam_from_x(64, 192, 0.002, |u, z| {
        f64::from(u8::from((u.abs() - slit / 2.0).abs() < 0.0011)) * (-(z / 0.022).powi(2)).exp()
    });
    let grid = VolumeGrid::centered([2, 101, 1], 0.002);
    let params = focused(distance);
    let found = along_the_light(&light, &x, &params, &grid);
    let fringe = 405e-6 / 1.5 * distance / slit;
    // In units of the middle: cos²(πu/fringe) times that of a slit's two pixels
    for iy in 0..101 {
        let pixels = (PI * grid.y(iy) / fringe * 0.002 / slit).cos();
        let expected = ((PI * grid.y(iy) / fringe).cos() * pixels).powi(2);
        let found = found[iy] / found[50];
        assert!((found - expected).abs() < 0.02, "{iy}: {found} {expected}");
    }
}

#[test]
fn energy_of_a_frame_is_the_same_at_all_depths() {
    let (light, x) = beam_from_x(24, 24, 0.001, |u, z| {
        (-(u * u + z * z) / 25e-6).exp() * (1.0 + 0.5 * (1500.0 * u).sin())
    });
    let grid = VolumeGrid::centered([64, 64, 3], 0.001);
    let mut energies = Vec::new();
    for focus in [0.0, 0.02, 0.1] {
        let params = focused(focus);
        let found = along_the_light(&light, &x, &params, &grid);
        energies.push(found.iter().skip(1).step_by(3).sum::<f64>());
    }
    let sent: f64 = x.iter().map(|a| a * a).sum();
    for energy in energies {
        assert!((energy / sent - 1.0).abs() < 1e-3, "{energy} {sent}");
    }
}

#[test]
fn dark_pixels_around_a_pattern_change_nothing() {
    // Pixels of 2 µm make an aperture of 0.1: a spot of a smaller one, or of light that comes from afar, is wider than the image
    let dose_with = |edge: usize, params: &Params| {
        let pixels = PatternGrid::full_turn(1, 0.0, edge, edge, 2e-3);
        let light = Light::new(pixels, Resin::pure_radon(1.5));
        let grid = VolumeGrid::centered([4, 14, 14], 2e-3);
        let model = precise(&light, params, settings(1e-4), grid);
        let mut x = vec![0.0; edge * edge];
        let first = (edge - 16) / 2;
        for (i, value) in amplitudes(3, 256).into_iter().enumerate() {
            x[(first + i / 16) * edge + first + i % 16] = value;
        }
        dose_of(&model, &x)
    };
    for (aperture, focus_mm) in [
        (Some(0.05), 0.0),
        (Some(0.03), 0.0),
        (Some(0.08), 0.0),
        (None, 0.0),
        (None, 1.0),
    ] {
        let params = Params {
            numerical_aperture: aperture,
            focus_mm,
            ..Params::default()
        };
        let (alone, amid) = (dose_with(16, &params), dose_with(96, &params));
        let square = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
        let off = square(&mut alone.iter().zip(&amid).map(|(a, b)| a - b));
        let error = (off / square(&mut amid.iter().copied())).sqrt();
        assert!(error < 1e-3, "{aperture:?} {focus_mm}: {error}");
    }
}

#[test]
fn what_is_deleted_lies_beyond_the_limits_of_matsushima_and_shimobaba() {
    let model = precise(&light(1), &Params::default(), settings(1e-2), grid());
    let propagation = &model.0.propagation;
    let windows = propagation.windows();
    let guard = windows.sampling.guard;
    let [bu, bz] = windows.sampling.band.map(|b| b as i64);
    let depth = 10.0 * guard[0];
    let mut spectrum = vec![Complex::new(1.0, 0.0); ((2 * bu + 1) * (2 * bz + 1)) as usize];
    propagation.limit_to(&propagation.modes[0], depth, &mut spectrum);
    // Their f_lim = 1/(λ√((2Δf·d)² + 1)), with Δf of a window of twice the guard, and their two ellipses
    let k = 1.5 / 405e-6f64;
    let limits = guard.map(|g| k / ((2.0 * depth / (2.0 * g)).powi(2) + 1.0).sqrt());
    let mut count = 0;
    let indices = (-bz..=bz).flat_map(|fz| (-bu..=bu).map(move |fu| [fu, fz]));
    for (value, index) in spectrum.iter().zip(indices) {
        let f = [0, 1].map(|i| index[i] as f64 / windows.window[i]);
        let within = (0..2).all(|i| (f[i] / limits[i]).powi(2) + (f[1 - i] / k).powi(2) <= 1.0);
        assert_eq!(value.re == 1.0, within, "{index:?}");
        count += usize::from(within);
    }
    assert!(
        count > spectrum.len() / 10 && count < spectrum.len() / 2,
        "{count}"
    );
}

#[test]
fn a_hundredth_of_the_pixels_aperture_still_gives_light() {
    let pixels = PatternGrid::full_turn(1, 0.0, 100, 100, 2e-3);
    let light = Light::new(pixels, Resin::pure_radon(1.5));
    let params = through(1.05e-3);
    let grid = VolumeGrid::centered([2, 6, 6], 2e-3);
    let model = precise(&light, &params, settings(1e-2), grid);
    let dose = dose_of(&model, &vec![1.0; 100 * 100]);
    // Spots as wide as the image: dimmer than the pattern, and alike all over the voxels
    let (low, high) = dose
        .iter()
        .filter(|d| **d > 0.0)
        .fold((f64::INFINITY, 0.0f64), |(l, h), &d| (l.min(d), h.max(d)));
    assert!(low > 0.01 && high < 1.0 && high / low < 1.1, "{low} {high}");
}

#[test]
fn half_a_turn_is_warned_of_where_the_other_half_is_another() {
    let warning_of = |resin: Resin, focus_mm: f64, arc: f64| {
        let mut light = light(8);
        light.resin = resin;
        light.pixels.frame_arc = arc / 8.0;
        let params = focused(focus_mm);
        must_fit(&[light], &params, &grid()).unwrap().join("; ")
    };
    let (clear, absorbing) = (Resin::pure_radon(1.5), Resin::absorbing(1.5, 20.0));
    assert_eq!(warning_of(clear, 0.0, PI), "");
    assert_eq!(warning_of(absorbing, 0.0, 2.0 * PI), "");
    assert!(warning_of(absorbing, 0.0, PI).contains("takes 20 per mm"));
    assert!(warning_of(clear, 0.01, PI).contains("0.01 mm off the axis"));
}

#[test]
fn numbers_that_contradict_each_other_are_refused_with_numbers_that_work() {
    let refused = |light: Light, params: &Params, grid: VolumeGrid| match model(
        &VIAL,
        vec![light],
        params,
        grid,
    ) {
        Err(Error::Config { key, accepted, .. }) => format!("{key}: {accepted}"),
        Err(other) => other.to_string(),
        Ok(model) => model.describe(),
    };
    let default = Params::default();
    let fine = Light::new(
        PatternGrid::full_turn(2, 0.0, 8, 8, 1e-4),
        Resin::pure_radon(1.5),
    );
    let small = VolumeGrid::centered([4, 4, 4], 1e-4);
    let found = refused(fine.clone(), &default, small.clone());
    assert!(
        found.starts_with("light[0].projector.collimated.pixel_pitch_mm: at least 0.000135 mm"),
        "{found}"
    );
    let found = refused(fine.clone(), &through(0.4), small.clone());
    assert!(found.starts_with("wave ("), "{found}");
    let found = refused(fine, &through(1.6), small);
    assert!(found.contains("below 1.5"), "{found}");
    let found = refused(light(2), &through(0.5), grid());
    assert!(found.contains("at most 0.35797"), "{found}");
    let found = refused(light(2), &default, VolumeGrid::centered([4, 4, 4], 0.5e-3));
    assert!(found.contains("0.000400 mm"), "{found}");
    let far = focused(1e6);
    let found = refused(light(2), &far, grid());
    assert!(
        found.starts_with("model.wave: a focal plane closer to the axis"),
        "{found}"
    );
    let mut bent = light(2);
    bent.surrounding_index = 1.0;
    let vial = tomolith_optics::vial::cylinder::Cylinder {
        outer_radius_mm: 9.0,
        inner_radius_mm: 8.0,
        refractive_index: 1.52,
    };
    let found = model(&vial, vec![bent], &default, grid()).err().unwrap();
    assert!(found.to_string().contains("refracts"), "{found}");
}

#[test]
fn the_dose_along_a_line_is_the_quadratic_that_is_stated() {
    let waves = model(&VIAL, vec![light(2)], &Params::default(), grid()).unwrap();
    let [mut x, d] = [1, 2].map(|seed| check::noisy_patterns(&waves, seed));
    let terms = waves.along(&x, &d, &Work::new()).unwrap().unwrap();
    let at_x = check::dose(&waves, &x);
    x.axpy(0.7, &d);
    let mut expected = check::dose(&waves, &x);
    let size = f64::from(expected.max_abs());
    expected.axpy(-1.0, &at_x);
    for (power, term) in (1..).zip(&terms) {
        expected.axpy(-0.7f32.powi(power), term);
    }
    assert!(f64::from(expected.max_abs()) < 1e-6 * size);
}
