//! The `incoherent_cone` dose model: rays whose light fills a cone, in an index-matched vial.
//!
//! # Model
//! The linear relative of [`wave`](super): every pixel's light comes from all directions within `half_angle_deg` (in resin), in focus in a
//! plane, so that it lies on a disc elsewhere: the étendue of an incoherent projector. It couples heights, over the depth times the tangent.
//!
//! # Equation
//! ```text
//! dose(X, Y, z) = μ_a Σ_φ e^(−μ_t·way)·(E_φ ∗ disc(|d|·tan θ) ∗ pixel)(u, z)
//! ```
//! with d, u and the way of the middle ray as in the model `wave`.
//!
//! # Source
//! Geometrical optics; the transform of a disc: Goodman, *Introduction to Fourier Optics*, eq. 2-35.
//!
//! # Limits
//! As `wave`: an index-matched vial, no scattering, no bodies. All rays of a cone take the way of its middle one through the resin. Pixels
//! have soft edges (`cones`): next to a sharp edge light overshoots by 0.6 %, also below 0.
//!
//! # Cost
//! As `wave`, with a pullback that costs as much as a dose.
//!
//! # Example
//! Half a millimeter from the focal plane a cone of 2° has spread over a disc of 17.5 µm radius:
//! ```
//! use tomolith_core::field::HostField;
//! use tomolith_core::grid::{PatternGrid, VolumeGrid};
//! use tomolith_models::{DoseModel, Work, wave::incoherent_cone::{self, Params}};
//! use tomolith_optics::light::Light;
//! use tomolith_optics::{resin::Resin, vial::index_matched::IndexMatched};
//! let light = Light::new(PatternGrid::full_turn(1, 0.0, 65, 65, 0.002), Resin::pure_radon(1.5));
//! let params = Params { half_angle_deg: 2.0, focus_mm: -0.5, ..Params::default() };
//! let vial = IndexMatched { radius_mm: 1.0 };
//! let model = incoherent_cone::model(&vial, vec![light], &params, VolumeGrid::centered([65, 65, 1], 0.002)).unwrap();
//! let mut x = model.new_patterns().unwrap();
//! x.as_mut_slice()[32 * 65 + 32] = 1.0; // the pixel in the middle
//! let mut dose = model.new_dose().unwrap();
//! model.dose(&x, &mut dose, &Work::new()).unwrap();
//! let dose = model.outputs()[0].volume_of(dose.as_slice());
//! let disc = 3.14159 * 17.46f32.powi(2) / 4.0; // its area in pixels of 4 µm²
//! assert!((dose.at(32, 32, 0) * disc - 1.0).abs() < 0.05);
//! assert!((dose.values.iter().sum::<f32>() - 1.0).abs() < 1e-3); // nothing is lost
//! ```

use super::cones::{Cone, Cones};
use super::lights::{Lights, WaveModel, affordable_windows, beyond, heights_of, turning};
use super::sampling::FIELDS_COST;
use super::{Entrance, Settings};
use crate::{
    Capabilities, Cost, DoseLayout, HostModel, MakeFamily, ModelFamily, ModelInput, ModelKind,
    OpticalScene, TimedBy,
};
use std::sync::Arc;
use tomolith_core::dose::form::Form;
use tomolith_core::error::Result;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::kind::schema_of;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

tomolith_core::keys! {
    /// Keys of `[model.incoherent_cone]`.
    #[derive(PartialEq)]
    pub struct Params {
        /// Half angle of the cone in resin, degrees.
        #[schemars(range(min = 0.0, max = 30.0))]
        pub half_angle_deg: f64 = 1.0,
        /// Distance of the focal plane behind the axis, along the light, mm.
        pub focus_mm: f64 = 0.0,
        /// Where the resin begins to absorb.
        pub entrance: Entrance = Entrance::Wall,
        /// Error of light between the depths that are computed.
        #[schemars(range(min = 1e-6, max = 0.1))]
        pub relative_error: f64 = 1e-3,
        /// Error of light between lateral samples.
        #[schemars(range(min = 1e-6, max = 0.5))]
        pub rotation_error: f64 = 0.03,
    }
}

impl Params {
    fn settings(&self) -> Settings {
        Settings {
            model: "model.incoherent_cone",
            relative_error: self.relative_error,
            rotation_error: self.rotation_error,
            entrance: self.entrance,
            focus_mm: self.focus_mm,
            fields_cost: FIELDS_COST,
        }
    }

    fn cone(&self, light: &Light) -> Cone {
        Cone {
            slope: self.half_angle_deg.to_radians().tan(),
            pitch: light.pixels.pitch_mm,
        }
    }
}

/// Row of [`MODELS`](crate::MODELS).
pub const KIND: ModelKind = ModelKind {
    name: "incoherent_cone",
    summary: "Incoherent light that fills a cone and is focused in a plane, in an index-matched vial (étendue of the projector).",
    example: "[model.incoherent_cone]\nhalf_angle_deg = 1.0\n",
    schema: schema_of::<Params>,
    build: MakeFamily {
        read: |section| Ok(Arc::new(section.parse::<Params>()?)),
        unasked: None,
    },
};

impl ModelFamily for Params {
    fn name(&self) -> &'static str {
        KIND.name
    }

    fn capabilities(&self) -> Capabilities {
        Capabilities {
            has_surrogate: true,
            timed_by: TimedBy::Frames,
            is_along_frames: true,
            fills: true,
            ..Capabilities::default()
        }
    }

    fn unsupported(&self, scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Option<&'static str> {
        let beyond = || beyond(scene.vial, scene.lights);
        let spread = scene.point_spread();
        scene.beyond_slices().or(spread).or_else(beyond)
    }

    /// Refuses voxels that do not lie on the rows of pixels.
    fn check(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Result<Vec<String>> {
        for light in scene.lights {
            heights_of(light.pixels.pitch_mm[1], grid)?;
        }
        Ok(Vec::new())
    }

    fn cost(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Result<Cost> {
        Ok(Cost {
            working_bytes: working_bytes(scene.vial, scene.lights, self, grid)?,
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

/// Bytes that frames at work take in addition to patterns and doses.
fn working_bytes(
    vial: &dyn Vial,
    lights: &[Light],
    params: &Params,
    grid: &VolumeGrid,
) -> Result<usize> {
    let settings = params.settings();
    let of_light = |light: &Light| {
        let windows = affordable_windows(vial, light, &params.cone(light), &settings, grid, 1)?;
        // A real number for every frequency and depth
        let kernels = windows.sampling.transformed().count.div_ceil(2);
        Ok(windows.working_bytes(grid, 1, kernels))
    };
    lights.iter().map(of_light).sum()
}

/// The model of an index-matched vial, its lights and the voxels where dose is wanted.
///
/// # Errors
/// [`Error::Config`](tomolith_core::Error::Config) where rows of pixels and of voxels do not fit;
/// [`Error::Unsupported`](tomolith_core::Error::Unsupported) where a vial or a light is [`beyond`] it.
pub fn model(
    vial: &dyn Vial,
    lights: Vec<Light>,
    params: &Params,
    grid: VolumeGrid,
) -> Result<impl WaveModel + use<>> {
    let settings = &params.settings();
    let build = |light: &Light, layout: &DoseLayout, _, first| {
        let cone = params.cone(light);
        let propagate = |windows| Cones::new(windows, &cone);
        turning(vial, light, &cone, settings, layout, first, propagate)
    };
    Lights::new(settings.model, vial, lights, grid, build)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DoseModel;
    use crate::parallel::Parallel;
    use tomolith_core::check;
    use tomolith_core::field::Field;
    use tomolith_core::grid::PatternGrid;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    const VIAL: IndexMatched = IndexMatched { radius_mm: 2.0 };

    fn light(frames: usize) -> Light {
        let pixels = PatternGrid::full_turn(frames, 0.2, 20, 24, 0.05);
        Light::new(pixels, Resin::absorbing(1.5, 0.3))
    }

    #[test]
    fn it_is_an_exact_linear_pair() {
        let params = Params {
            half_angle_deg: 5.0,
            focus_mm: 0.1,
            ..Params::default()
        };
        let grid = VolumeGrid::centered([20, 18, 16], 0.05);
        let cones = model(&VIAL, vec![light(3), light(2)], &params, grid).unwrap();
        let found = check::model::model(&cones, 3).unwrap();
        assert!(found.adjoint_error < 2e-6, "{found:?}");
    }

    #[test]
    fn without_an_angle_it_is_the_parallel_model() {
        // A smooth pattern, so that what pixels and voxels are made of does not matter
        let grid = VolumeGrid::centered([20, 20, 20], 0.05);
        let light = light(7);
        let params = Params {
            half_angle_deg: 0.0,
            ..Params::default()
        };
        let spread = model(&VIAL, vec![light.clone()], &params, grid.clone()).unwrap();
        let parallel = Parallel::new(&VIAL, vec![light.clone()], grid).unwrap();
        let mut x = spread.new_patterns().unwrap();
        for (i, value) in x.as_mut_slice().iter_mut().enumerate() {
            let (u, z) = (
                light.pixels.column_u(i / 20 % 24),
                light.pixels.row_z(19 - i % 20),
            );
            *value = (-(u * u + z * z) / (2.0 * 0.15f64.powi(2))).exp() as f32;
        }
        let dose =
            |model: &dyn DoseModel<Field = tomolith_core::field::HostField>| check::dose(model, &x);
        let (a, b) = (dose(&spread), dose(&parallel));
        let mut off = a.clone();
        off.axpy(-1.0, &b);
        let error = off.norm() / b.norm();
        // Both average over a pixel; `parallel` also over a voxel: 0.05²/24 of the curvature 2/0.15² each
        assert!(error < 0.012, "{error}");
    }
}
