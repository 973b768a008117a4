//! The `monte_carlo` dose model: rays in a resin that scatters, by frozen Monte Carlo paths.
//!
//! # Model
//! Unscattered light is followed as by [`rays`](super::rays), exactly. Along each segment of it the part that is scattered goes on
//! from one random point in a random direction, and so on ([`SpaceTracer`](tomolith_optics::space::SpaceTracer)); every segment
//! leaves its expected absorption in all the voxels it passes. Points and directions are frozen by (seed, frame, pixel,
//! path, event): a seed is one matrix, of which dose and adjoint are an exact pair. Another seed is another matrix.
//!
//! # Equation
//! dose(v) = Σ x·A/(n·V) Σ_paths Σ_segments P·(μ_a/μ_t)·(e^(−μ_t·s_in) − e^(−μ_t·s_out)), μ_t = μ_a + μ_s + what else absorbs;
//! a segment of length L hands on the power P·(μ_s/μ_t)·(1 − e^(−μ_t·L)). Its mean over seeds is the volume rendering equation.
//!
//! # Resin that differs from place to place
//! With an absorption map the terms of a segment are those of its pieces in the cells, with their μ_a and μ_t; with an index that changes
//! with the radius segments are the chords of curves ([`optics::space`](tomolith_optics::space)). μ_s is the same everywhere.
//! Where there is a map and `smooth` > 1, cells hold fluence instead of energy, and a voxel takes the map's mean over it.
//!
//! # Source
//! Nicolet et al. 2024, § 4.2 (path sampling, expected absorption along segments).
//!
//! # Limits
//! Noise falls with the square root of the number of paths. What is reported is simulated with another seed, sixteen times as many
//! paths and cells half as large, so that a pattern that fits its own noise, or what cells smooth away, shows.
//!
//! Scattered light is smoothed over cells of `smooth` voxels, which takes structure of a few cells away. In what is reported
//! `models/cell_blur.rs` brings most of it back; an optimization goes without, as the noise of its few paths would grow by 1.4 and costs more.
//! Near a wall some scattered light lies beyond the resin (1 % of the absorbed energy in a vial of 32 voxels across), where it counts
//! nowhere.
//!
//! # Cost
//! Paths are traced again in every call, so memory does not grow with their number. On a graphics card they are drawn there, from other random numbers
//! ([`tomolith_core::dose::paths`]).
//!
//! # Example
//! A pixel of light through 4 mm of a resin that scatters: e^(−4.4) of it passes untouched, and much more leaves scattered.
//! ```
//! use std::sync::Arc;
//! use tomolith_core::grid::{PatternGrid, VolumeGrid};
//! use tomolith_models::{rays::Optics, monte_carlo};
//! use tomolith_optics::light::Light;
//! use tomolith_optics::phase::{Scattering, isotropic::Isotropic};
//! use tomolith_optics::{resin::Resin, vial::index_matched::IndexMatched};
//! let mut light = Light::new(PatternGrid::full_turn(1, 0.0, 1, 1, 0.1), Resin::absorbing(1.5, 0.1));
//! light.resin.attenuation_per_mm = 1.1;
//! let mut optics = Optics::collimated(0.1);
//! optics.scattering = Some(Scattering { per_mm: 1.0, phase: Arc::new(Isotropic {}) });
//! let params = monte_carlo::Params { paths_per_pixel: 64, ..Default::default() };
//! let vial = IndexMatched { radius_mm: 2.0 };
//! let model = monte_carlo::model(&vial, &[light], &[optics], &params, VolumeGrid::centered([8, 8, 8], 0.5)).unwrap();
//! let balance = model.balance(0, 0);
//! assert!((balance.total() - 1.0).abs() < 1e-12);
//! assert!(balance.transmitted > 10.0 * (-4.4f64).exp());
//! ```

use super::rays::accumulation::Accumulation;
use super::rays::{Emission, Optics, Rays, Scattered};
use super::{
    Capabilities, Family, HostModel, MakeFamily, ModelFamily, ModelInput, ModelKind,
    MonteCarloPaths, OpticalScene, Purpose, TimedBy,
};
use std::borrow::Cow;
use std::sync::Arc;
use tomolith_core::dose::form::Form;
use tomolith_core::error::Result;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::kind::schema_of;
use tomolith_optics::light::Light;
use tomolith_optics::space::TraceLimits;
use tomolith_optics::vial::Vial;

tomolith_core::keys! {
    /// Keys of `[model.monte_carlo]`.
    #[derive(PartialEq)]
    pub struct Params {
        /// Paths of a pixel in a frame.
        #[schemars(range(min = 1, max = 4096))]
        pub paths_per_pixel: usize = 4,
        /// How energy is accumulated along a path: "integral", "simple" or { ratio = { majorant_per_mm = 10.0 } }.
        pub accumulation: Accumulation = Accumulation::Integral,
        /// Seed of the random numbers: which paths.
        pub seed: u64 = 1,
        /// Iterations of an optimization after which new paths are drawn; 0: never.
        #[schemars(range(min = 0, max = 10_000))]
        pub renew: usize = 10,
        /// Share of the emitted power below which a path may end by Russian roulette.
        #[schemars(range(min = 1e-6, max = 0.5))]
        pub least_power: f64 = 0.05,
        /// Whether light reflected at walls is followed.
        pub reflections: bool = false,
        /// Largest number of scattering events of a path.
        #[schemars(range(min = 0, max = 1000))]
        pub orders: usize = 64,
        /// Edge, in voxels, of the cells on which scattered light is summed; it is interpolated between them. Half of it for what is reported.
        #[schemars(range(min = 1, max = 32))]
        pub smooth: usize = 4,
        /// Whether what cells smear out is given back, for 1.4 times the noise: what a judgment does, which has paths enough.
        #[serde(skip)]
        pub is_sharp: bool = false,
    }
}

/// Paths of the judgment for each of the optimization.
const EVALUATING: usize = 16;

/// What makes a model: [`model`] or [`straight`].
type Make = fn(&dyn Vial, &[Light], &[Optics], &Params, VolumeGrid) -> Result<Rays>;

impl Params {
    fn for_purpose(&self, scene: &OpticalScene<'_>) -> Cow<'_, Self> {
        match scene.purpose {
            Purpose::Evaluate { refine } => Cow::Owned(self.for_evaluation(refine)),
            _ => Cow::Borrowed(self),
        }
    }

    /// What [`model`] or [`straight`] makes of these parameters.
    fn made(&self, input: &ModelInput<'_>, make: Make) -> Result<Rays> {
        let scene = input.scene;
        let model = make(
            scene.vial,
            scene.lights,
            scene.optics,
            self,
            input.grid.clone(),
        )?;
        Ok(input.with_cells(model))
    }

    /// What a result is evaluated by, on voxels `refine` times as fine: independent paths, sixteen times as many, on cells half as large that give
    /// back what they smear out, so that what the optimization's cells smooth away shows like noise does.
    fn for_evaluation(&self, refine: usize) -> Self {
        Params {
            paths_per_pixel: EVALUATING * self.paths_per_pixel,
            seed: !self.seed,
            smooth: (self.smooth * refine).div_ceil(2),
            is_sharp: true,
            ..self.clone()
        }
    }
}

/// Row of [`MODELS`](super::MODELS).
pub const KIND: ModelKind = ModelKind {
    name: "monte_carlo",
    summary: "Scattering by Monte Carlo paths, fixed during an optimization, with their exact adjoint.",
    example: "[model.monte_carlo]\npaths_per_pixel = 4\n",
    schema: schema_of::<Params>,
    build: MakeFamily {
        read: |section| Ok(Arc::new(section.parse::<Params>()?)),
        unasked: Some(|| Arc::new(Params::default())),
    },
};

impl ModelFamily for Params {
    fn name(&self) -> &'static str {
        KIND.name
    }

    fn capabilities(&self) -> Capabilities {
        Capabilities {
            timed_by: TimedBy::Pixels,
            is_traced: true,
            has_cells: true,
            ..Capabilities::default()
        }
    }

    fn unsupported(&self, _scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Option<&'static str> {
        None
    }

    fn build(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        Ok(Box::new(self.for_purpose(&input.scene).made(input, model)?))
    }

    fn form(&self, input: &ModelInput<'_>) -> Result<Option<Form>> {
        let params = self.for_purpose(&input.scene);
        let (model, straight) = (params.made(input, model)?, params.made(input, straight)?);
        let (lights, optics) = (input.scene.lights, input.scene.optics);
        model.to_path_form(&straight, lights, optics, &limits(&params), input.work)
    }

    fn unscattered(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        Ok(Box::new(self.made(input, straight)?))
    }

    fn unscattered_form(&self, input: &ModelInput<'_>) -> Result<Option<Form>> {
        self.made(input, straight)?.to_form(input.work)
    }

    fn rays(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Option<Result<Rays>> {
        let (lights, optics) = (scene.lights, scene.optics);
        Some(model(scene.vial, lights, optics, self, grid.clone()))
    }

    fn monte_carlo_paths(&self) -> Option<MonteCarloPaths> {
        // Seeds of evaluations count up where those of optimizations count down
        let redrawn: Family = Arc::new(Params {
            seed: self.seed.wrapping_sub(1),
            ..self.clone()
        });
        Some(MonteCarloPaths {
            optimizing: self.paths_per_pixel,
            evaluating: self.for_evaluation(1).paths_per_pixel,
            redrawn,
        })
    }

    fn despite(&self, cheaper: &str, scene: &OpticalScene<'_>) -> String {
        match scene.scatterer() {
            None => "as the job names it; nothing scatters".to_owned(),
            Some(reason) => {
                format!("{reason}; as the job names it; [model.{cheaper}] covers it without noise")
            }
        }
    }
}

/// The model of a vial, its lights with their optics, and the voxels where dose is wanted.
///
/// # Errors
/// As [`Rays::new`].
pub fn model(
    vial: &dyn Vial,
    lights: &[Light],
    optics: &[Optics],
    params: &Params,
    grid: VolumeGrid,
) -> Result<Rays> {
    let scattered = Scattered {
        seed: params.seed,
        smooth: params.smooth,
        is_sharp: params.is_sharp,
        renew: params.renew,
    };
    Rays::build(
        vial,
        lights,
        optics,
        &emission(params, Some(scattered)),
        grid,
    )
}

/// The unscattered light of [`model`] alone.
pub(crate) fn straight(
    vial: &dyn Vial,
    lights: &[Light],
    optics: &[Optics],
    params: &Params,
    grid: VolumeGrid,
) -> Result<Rays> {
    let whole = Params {
        accumulation: Accumulation::Integral,
        ..params.clone()
    };
    Rays::build(vial, lights, optics, &emission(&whole, None), grid)
}

fn emission(params: &Params, scattered: Option<Scattered>) -> Emission {
    Emission {
        rays_per_pixel: params.paths_per_pixel,
        accumulation: params.accumulation,
        limits: limits(params),
        scattered,
    }
}

fn limits(params: &Params) -> TraceLimits {
    TraceLimits {
        reflections: params.reflections,
        least_power: params.least_power,
        orders: params.orders,
        ..TraceLimits::default()
    }
}
