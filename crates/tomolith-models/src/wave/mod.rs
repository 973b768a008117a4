//! The `wave` dose model: coherent light, by the band-limited angular spectrum.
//!
//! # Model
//! The unknown is the amplitude a ≥ 0 of each pixel, the square root of its areal dose: files and frames hold energy. A pattern is the
//! field in the focal plane; it spreads before and behind it as a scalar wave in resin, and the light of all frames adds up incoherently.
//! With `etendue_deg` the light of a frame is itself a sum of modes, plane waves within a cone that carry the pattern.
//!
//! # Equation
//! ```text
//! dose(X, Y, z) = μ_a Σ_φ e^(−μ_t·way) Σ_m w_m |ψ_φm(d, u, z)|²,      ψ_φm(d) = F⁻¹[W(d)·H(d, f + f_m)·pupil(f + f_m)·F a_φ]
//! H(d, f) = e^(2πi d √(λ⁻² − f²)),     λ = λ₀/n,     d = −(X cos φ + Y sin φ) − focus,     u = −X sin φ + Y cos φ
//! ```
//! F(a + αδ) is a quadratic in α, so searches along a line are exact; dose and gradient store no volume per frame.
//!
//! # Source
//! Wechsler et al. 2024, eqs. 2 to 4 and Algorithms 2 and 3; Matsushima & Shimobaba 2009 (band limit). What is saved against the published
//! algorithm, with its errors: docs/wave.md and docs/validation.md.
//!
//! # Shapes
//! Patterns and dose as everywhere. Rows of pixels must be voxels apart, or a whole multiple or fraction of it.
//!
//! # Limits
//! Scalar, one index: an index-matched vial, no scattering, no bodies, collimated light normal to the axis. Light of one frame does not
//! interfere with that of another. x = 0 is a stationary point: starts must be positive.
//!
//! # Cost
//! Per frame 1 + K Fourier transforms for a dose, 2 + 2K for a pullback and 2 + 2K for a search, K the number of depths on one side of the focal plane; then
//! taps along × taps across multiply-adds per voxel. Memory: K planes of samples per frame at work and thread.
//!
//! # Example
//! A slit of two pixels, 4 µm, spreads: at 0.2 mm from the focus its middle holds what Fraunhofer says.
//! ```
//! use tomolith_core::field::{Field, HostField};
//! use tomolith_core::grid::{PatternGrid, VolumeGrid};
//! use tomolith_models::{DoseModel, Work, wave::{self, Params}};
//! use tomolith_optics::light::Light;
//! use tomolith_optics::{resin::Resin, vial::index_matched::IndexMatched};
//! let light = Light::new(PatternGrid::full_turn(1, 0.0, 64, 128, 0.002), Resin::pure_radon(1.5));
//! let vial = IndexMatched { radius_mm: 1.0 };
//! // Voxels of 2 µm along x, the direction of the light, through the middle of the slit
//! let grid = VolumeGrid::centered([2, 1, 201], 0.002);
//! let model = wave::model(&vial, vec![light], &Params::default(), grid).unwrap();
//! let mut x = model.new_patterns().unwrap();
//! x.as_mut_slice()[63 * 64..65 * 64].fill(1.0); // columns 63 and 64, all rows
//! let mut dose = model.new_dose().unwrap();
//! model.dose(&x, &mut dose, &Work::new()).unwrap();
//! let dose = model.outputs()[0].volume_of(dose.as_slice());
//! // For a long slit of fluence 1: width²/(λ·distance) = 16/(0.27·200) = 0.296
//! let far = *dose.at(0, 0, 0);
//! assert!((far - 0.296).abs() < 0.01, "{far}");
//! ```

mod beam;
mod coherent;
mod cones;
mod depth_interpolation;
mod frame_rotation;
pub mod incoherent_cone;
mod lattice;
mod light;
mod lights;
mod memory;
mod number;
mod resample;
mod sampling;
mod spectrum;
mod taps;
#[cfg(test)]
mod tests;
mod window;

use super::{
    Capabilities, Cost, DoseLayout, HostModel, MakeFamily, ModelFamily, ModelInput, ModelKind,
    OpticalScene, Purpose, Quantity, TimedBy,
};
use beam::{Beam, Spreading};
pub use coherent::BandLimit;
use coherent::{Coherent, Mode};
use light::WaveLight;
use lights::{Lights, affordable_windows, heights_of};
pub use lights::{WaveModel, beyond};
use number::Number;
use sampling::FIELDS_COST;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, SQRT_2, TAU};
use std::sync::Arc;
use tomolith_core::dose::form::Form;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::kind::{Section, schema_of};
use tomolith_core::units::{concise, exact};
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// Where the resin begins to absorb.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Entrance {
    /// At its round wall.
    #[default]
    Wall,
    /// At a plane normal to the light that touches the wall; the article's touches the volume.
    Plane,
}

tomolith_core::keys! {
    /// Keys of `[model.wave]`.
    #[derive(PartialEq)]
    pub struct Params {
        /// Error of the intensity between the depths that are computed, relative to light that fills the band.
        #[schemars(range(min = 1e-6, max = 0.1))]
        pub relative_error: f64 = 1e-3,
        /// Error of the intensity between lateral samples, for light that fills the band.
        #[schemars(range(min = 1e-6, max = 0.5))]
        pub rotation_error: f64 = 0.03,
        /// Numerical aperture of the projector's lens: patterns are limited to what it passes. From λ₀/(2·image), below which its spots are
        /// wider than the image, to the refractive index; no limit when left out.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub numerical_aperture: Option<f64>,
        /// Share of the frequency band over which it fades; 0: cut sharply, as published.
        #[schemars(range(min = 0.0, max = 1.0))]
        pub soft_edge: f64 = 0.25,
        /// Distance of the focal plane behind the axis, along the light, mm.
        pub focus_mm: f64 = 0.0,
        /// How frequencies are cut that the window cannot hold: they would return from its far side.
        pub band_limit: BandLimit = BandLimit::Hard,
        /// Where the resin begins to absorb.
        pub entrance: Entrance = Entrance::Wall,
        /// Half angle of the cone of modes in resin, degrees.
        #[schemars(range(min = 0.0, max = 10.0))]
        pub etendue_deg: f64 = 0.0,
        /// Rings of modes about the middle one: 7, 19, 37 … modes; 2 when left out. Only with an étendue.
        #[schemars(range(min = 1, max = 6))]
        pub rings: Option<usize>,
    }
}

impl Params {
    fn settings(&self) -> Settings {
        Settings {
            model: "model.wave",
            relative_error: self.relative_error,
            rotation_error: self.rotation_error,
            entrance: self.entrance,
            focus_mm: self.focus_mm,
            fields_cost: FIELDS_COST,
        }
    }
}

/// Row of [`MODELS`](super::MODELS).
pub const KIND: ModelKind = ModelKind {
    name: "wave",
    summary: "Coherent light in an index-matched vial: band-limited angular spectrum, amplitudes as unknowns.",
    example: "[model.wave]\nrelative_error = 1e-3\nnumerical_aperture = 0.05\n",
    schema: schema_of::<Params>,
    build: MakeFamily {
        read: |section| Ok(Arc::new(params_of(section)?)),
        unasked: None,
    },
};

impl ModelFamily for Params {
    fn name(&self) -> &'static str {
        KIND.name
    }

    fn capabilities(&self) -> Capabilities {
        Capabilities {
            linear_instead: Some("[model.incoherent_cone] is the linear relative of waves"),
            has_surrogate: true,
            timed_by: TimedBy::Frames,
            is_along_frames: true,
            ..Capabilities::default()
        }
    }

    fn unsupported(&self, scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Option<&'static str> {
        let beyond = || beyond(scene.vial, scene.lights);
        let spread = scene.point_spread();
        scene.beyond_slices().or(spread).or_else(beyond)
    }

    fn check(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Result<Vec<String>> {
        must_fit(scene.lights, self, grid)
    }

    fn cost(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Result<Cost> {
        let is_optimized = scene.purpose == Purpose::Optimize;
        Ok(Cost {
            working_bytes: working_bytes(scene.vial, scene.lights, self, grid, is_optimized)?,
            ..Cost::default()
        })
    }

    fn build(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        let (lights, grid) = (input.scene.lights.to_vec(), input.grid.clone());
        Ok(Box::new(model(input.scene.vial, lights, self, grid)?))
    }

    fn form(&self, input: &ModelInput<'_>) -> Result<Option<Form>> {
        let (lights, grid) = (input.scene.lights.to_vec(), input.grid.clone());
        Ok(model(input.scene.vial, lights, self, grid)?.data())
    }
}

fn params_of(section: &Section) -> Result<Params> {
    let params: Params = section.parse()?;
    if let Some(rings) = params.rings.filter(|_| params.etendue_deg == 0.0) {
        let accepted = "no such key, or rings of modes that have an angle: `etendue_deg` above 0";
        return Err(section.refused("rings", rings, accepted));
    }
    Ok(params)
}

/// How errors are shared among the parts of the sampling.
#[derive(Clone, Copy, Debug)]
struct Settings {
    /// Key of the model.
    model: &'static str,
    relative_error: f64,
    rotation_error: f64,
    entrance: Entrance,
    focus_mm: f64,
    /// How much longer a frame takes with interpolated fields than their operations say.
    fields_cost: f64,
}

/// The model of an index-matched vial, its lights and the voxels where dose is wanted.
///
/// # Errors
/// [`Error::Config`] for pixels, voxels, wavelength and aperture that contradict each other, with the numbers that would work;
/// [`Error::Unsupported`] where a vial or a light is [`beyond`] it.
pub fn model(
    vial: &dyn Vial,
    lights: Vec<Light>,
    params: &Params,
    grid: VolumeGrid,
) -> Result<impl WaveModel + use<>> {
    let settings = params.settings();
    let build = |light: &Light, layout: &DoseLayout, which, first_frame| {
        light_of(vial, light, params, &settings, layout, which, first_frame)
    };
    let mut lights = Lights::new(settings.model, vial, lights, grid, build)?;
    for patterns in &mut lights.patterns {
        patterns.quantity = Quantity::Amplitude;
    }
    Ok(lights)
}

/// Bytes that frames at work take in addition to patterns and a dose, in an optimization or in one dose.
fn working_bytes(
    vial: &dyn Vial,
    lights: &[Light],
    params: &Params,
    grid: &VolumeGrid,
    is_optimized: bool,
) -> Result<usize> {
    // Along a line two at a time
    let doses = if is_optimized { 2 } else { 1 };
    let settings = params.settings();
    let of_light = |(i, light): (usize, &Light)| {
        let beam = beam_of(i, light, params)?;
        // H of every mode, and where it begins
        let modes = modes_of(&beam, params).len();
        let windows = affordable_windows(vial, light, &beam, &settings, grid, modes)?;
        Ok(windows.working_bytes(grid, doses, 2 * modes))
    };
    lights.iter().enumerate().map(of_light).sum()
}

/// Refuses pixels, voxels, wavelength and aperture that contradict each other, before any work; returns the notes on those that do not.
fn must_fit(lights: &[Light], params: &Params, grid: &VolumeGrid) -> Result<Vec<String>> {
    let mut warnings = Vec::new();
    for (i, light) in lights.iter().enumerate() {
        heights_of(light.pixels.pitch_mm[1], grid)?;
        let beam = beam_of(i, light, params)?;
        let half_wave = 0.5 / beam.depth_band();
        if grid.pitch_mm > half_wave {
            warnings.push(format!(
                "light[{i}]: waves change along the light within {} mm, and voxels of {} mm do not show it: \
                 grid.pitch_mm at most that, or a smaller model.wave.numerical_aperture",
                concise(half_wave),
                exact(grid.pitch_mm)
            ));
        }
        warnings.extend(half_a_turn(i, light, params.focus_mm));
    }
    Ok(warnings)
}

/// What to say of half a turn where the other half would not bring the same light.
fn half_a_turn(which: usize, light: &Light, focus_mm: f64) -> Option<String> {
    let arc = light.pixels.frame_arc.abs() * light.pixels.frames() as f64;
    let attenuation = light.resin.uptake().attenuation_per_mm;
    let why = match (focus_mm == 0.0, attenuation == 0.0) {
        (true, true) => return None,
        (false, _) => format!("its focal plane lies {} mm off the axis", exact(focus_mm)),
        (true, false) => format!("the resin takes {} per mm of it", exact(attenuation)),
    };
    ((arc - PI).abs() < 1e-6).then(|| {
        format!(
            "light[{which}]: half a turn lights the part from one side, and from the other it would not be the same, for {why}: \
             light.angles.arc_deg = 360 lights it from all sides"
        )
    })
}

/// A light of the wave model, of either kind of number.
fn light_of<T: Number>(
    vial: &dyn Vial,
    light: &Light,
    params: &Params,
    settings: &Settings,
    layout: &DoseLayout,
    which: usize,
    first_frame: usize,
) -> Result<WaveLight<T, Coherent<T>>> {
    let beam = beam_of(which, light, params)?;
    let propagate =
        |windows| Coherent::new(windows, beam, params.band_limit, modes_of(&beam, params));
    lights::turning(vial, light, &beam, settings, layout, first_frame, propagate)
}

/// Wavelength and aperture of a light, checked against its pixels; `which` of the lights it is.
fn beam_of(which: usize, light: &Light, params: &Params) -> Result<Beam> {
    let vacuum_mm = light.wavelength_nm * 1e-6;
    let index = light.resin.refractive_index;
    let wavenumber = index / vacuum_mm;
    let pitch = light.pixels.pitch_mm[0].min(light.pixels.pitch_mm[1]);
    let most = vacuum_mm / (2.0 * pitch);
    if let Some(na) = params.numerical_aperture {
        if na >= index {
            return Err(Error::config(
                "model.wave.numerical_aperture",
                format!("found {na} in a resin of index {index}, with pixels of {pitch} mm"),
                format!("below {}", concise(index.min(most * SQRT_2))),
            ));
        }
        let edge = |i: usize, count: usize| light.pixels.pitch_mm[i] * count as f64;
        let edge = edge(0, light.pixels.columns).min(edge(1, light.pixels.rows).max(pitch));
        let least = 0.5 * vacuum_mm / edge.max(pitch * 4.0);
        if na < least {
            return Err(Error::config(
                "model.wave.numerical_aperture",
                format!(
                    "found {na}, which makes spots wider than the image of {} mm",
                    concise(edge)
                ),
                format!("at least {}", concise(least)),
            ));
        }
        if na > most * SQRT_2 {
            // In the corners of their band
            let corner = most * SQRT_2;
            return Err(Error::config(
                "model.wave.numerical_aperture",
                format!(
                    "found {na}, but pixels of {pitch} mm make at most {corner:.5} at {} nm",
                    light.wavelength_nm
                ),
                format!(
                    "at most {corner:.5}, pixels of at most {:.6} mm, or no such key",
                    vacuum_mm / (SQRT_2 * na)
                ),
            ));
        }
    } else if most >= index {
        return Err(Error::config(
            format!("light[{which}].projector.collimated.pixel_pitch_mm"),
            format!(
                "pixels of {pitch} mm are finer than half a wavelength in resin ({:.6} mm): what they show does not travel",
                0.5 / wavenumber
            ),
            format!(
                "at least {:.6} mm, or `model.wave.numerical_aperture` below {index}",
                0.5 / wavenumber
            ),
        ));
    }
    Ok(Beam {
        wavenumber,
        aperture: params.numerical_aperture.map(|na| na / vacuum_mm),
        tilt: wavenumber * params.etendue_deg.to_radians().sin(),
        soft_edge: params.soft_edge,
        nyquist: light.pixels.pitch_mm.map(|mm| 0.5 / mm),
    })
}

/// The modes of a light: one, or rings of equal areas. Each has its opposite, so that their sum is the same before and behind the focal
/// plane.
fn modes_of(beam: &Beam, params: &Params) -> Vec<Mode> {
    let mut modes = vec![Mode {
        frequency: [0.0; 2],
        weight: 1.0,
    }];
    if beam.tilt == 0.0 {
        return modes;
    }
    let rings = params.rings.unwrap_or(2);
    let count = 1 + 3 * rings * (rings + 1);
    for ring in 1..=rings {
        let (inner, outer) = (1 + 3 * ring * (ring - 1), 1 + 3 * ring * (ring + 1));
        // Where half of the ring's area lies within
        let share = 0.5 * (inner + outer) as f64 / count as f64;
        for i in 0..6 * ring {
            let (sin, cos) = (TAU * i as f64 / (6 * ring) as f64).sin_cos();
            let size = beam.tilt * share.sqrt();
            modes.push(Mode {
                frequency: [size * cos, size * sin],
                weight: 1.0,
            });
        }
    }
    for mode in &mut modes {
        mode.weight = 1.0 / count as f64;
    }
    modes
}
