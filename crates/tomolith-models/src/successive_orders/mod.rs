//! The `successive_orders` dose model: a resin that scatters, without random numbers.
//!
//! # Model
//! Unscattered light is `parallel`, or `rays` where it is not collimated and normal to the axis, with the total attenuation. What is
//! scattered out of it is followed order by order as a convolution with the kernel of free flight, on cells much larger than voxels.
//! Light that leaves the resin does not come back.
//!
//! # Equation
//! ```text
//! dose = A x + I₁·K₁·c(x) + I₂·Σ_{n≥2} K^n·c(x)
//! ```
//! A: [`Parallel`] or [`Rays`]. c: moments of the unscattered light on cells: of collimated light by [`Parallel`] with patterns weighted by
//! cos mφ and sin mφ (`collimated_source.rs`), of any other by [`Rays`] whose rays are weighted by harmonics of their direction in the resin
//! (`divergent_source.rs`). K: free flight and scattering (`free_flight.rs`). I₁, I₂: interpolation from the cells of order 1 and of later orders to
//! voxels.
//!
//! # Source
//! docs/scattering.md, eqs. 1 and 2; Chandrasekhar, *Radiative Transfer* (1950), ch. I; forward lobes: Wiscombe, J. Atmos. Sci. 34
//! (1977) 1408.
//!
//! # Limits
//! A vial that is the same at all heights and whose even resin fills a circle or a square; no bodies; no reflections at
//! walls; at most 3 % of the scattered light in a forward lobe beyond degree 3 (Henyey–Greenstein to g = 0.41). Errors against Monte Carlo paths: docs/validation.md.
//!
//! # Cost
//! Beside `parallel`: the same on 1/100 to 1/1000 of the voxels, for every harmonic (three for Rayleigh), and Fourier transforms of the
//! cells of the resin, padded: four of the fine ones, about sixty of the coarse ones. Beside `rays`: one walk of the larger pixels'
//! rays through cells for every harmonic, six for Rayleigh and 16 for degree 3, with all rays traced anew in every call.
//!
//! # Example
//! In a resin that scatters, some light reaches heights that no pixel lights:
//! ```
//! use std::sync::Arc;
//! use tomolith_core::field::{Field, HostField};
//! use tomolith_core::grid::{PatternGrid, VolumeGrid};
//! use tomolith_models::{DoseModel, Work, successive_orders, rays::Optics};
//! use tomolith_optics::light::Light;
//! use tomolith_optics::phase::{Scattering, rayleigh::Rayleigh};
//! use tomolith_optics::{resin::Resin, vial::index_matched::IndexMatched};
//! let mut light = Light::new(PatternGrid::full_turn(8, 0.0, 2, 16, 0.25), Resin::absorbing(1.5, 0.1));
//! light.resin.attenuation_per_mm = 0.3;
//! let scattering = Scattering { per_mm: 0.2, phase: Arc::new(Rayleigh {}) };
//! let optics = Optics { scattering: Some(scattering), ..Optics::collimated(0.25) };
//! let vial = IndexMatched { radius_mm: 3.0 };
//! let grid = VolumeGrid::centered([16, 8, 8], 0.25);
//! let model = successive_orders::model(&vial, vec![light], &[optics], &successive_orders::Params::default(), grid).unwrap();
//! let mut x = model.new_patterns().unwrap();
//! x.fill(1.0);
//! let mut dose = model.new_dose().unwrap();
//! model.dose(&x, &mut dose, &Work::new()).unwrap();
//! let dose = model.outputs()[0].volume_of(dose.as_slice());
//! let (lit, dark) = (*dose.at(8, 4, 4), *dose.at(0, 4, 4)); // pixels reach ±0.25 mm, these lie at 0.125 and −1.875 mm
//! assert!(dark > 0.005 * lit && dark < 0.05 * lit);
//! ```

mod bins;
mod collimated_source;
mod convolver;
mod divergent_source;
mod free_flight;
mod harmonics;
mod higher_orders;
mod scattered_light;
mod unscattered_source;

use super::monte_carlo;
use super::parallel::{self, Parallel};
use super::rays::matrix_cache::CachedEntries;
use super::rays::{self, Optics, Rays};
use super::scene::CUT;
use super::{
    Capabilities, Cost, DoseLayout, DoseModel, Family, HostModel, MakeFamily, ModelFamily,
    ModelInput, ModelKind, OpticalScene, Purpose, Work, ZCoupling,
};
use scattered_light::{DeltaScaledPhase, ScatteredLight, ScatteringLight};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::form::{Form, Masked};
use tomolith_core::dose::rays::RayGeometry;
use tomolith_core::dose::strips::StripGeometry;
use tomolith_core::dose::{Facts, Space};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::kind::schema_of;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

tomolith_core::keys! {
    /// Keys of `[model.successive_orders]`.
    #[derive(PartialEq)]
    pub struct Params {
        /// Edge of the cells for light scattered once, mm; the larger cells of later orders scale with it. When left out, 0.04/μ_s,
        /// between 1/32 and 1/12 of the resin's radius and at most 0.2/μ_s.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub cell_mm: Option<f64>,
        /// Rays of a pixel in a frame, and of the larger ones that light cells, where light is not collimated and normal to the axis;
        /// 4 when left out.
        #[schemars(range(min = 1, max = 4096))]
        pub rays_per_pixel: Option<usize>,
    }
}

impl Params {
    /// Rays of a pixel in a frame.
    pub fn rays(&self) -> usize {
        self.rays_per_pixel.unwrap_or(4)
    }
}

/// Row of [`MODELS`](super::MODELS).
pub const KIND: ModelKind = ModelKind {
    name: "successive_orders",
    summary: "Scattering by successive orders in an even resin: convolutions instead of Monte Carlo paths.",
    example: "[model.successive_orders]\ncell_mm = 0.2\n",
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
            is_traced: true,
            ..Capabilities::default()
        }
    }

    fn unsupported(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Option<&'static str> {
        if scene.solid.is_some() {
            return Some(CUT);
        }
        beyond(scene.vial, scene.lights, scene.optics, grid).or(scene.probe_failed)
    }

    fn cost(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Result<Cost> {
        Ok(match scene.purpose {
            Purpose::Optimize if scene.unscattered_beyond_slices().is_some() => Cost {
                cached_entries: Some(CachedEntries::of_pixels(scene.lights, self.rays(), grid)),
                ..Cost::default()
            },
            // Those of the cells are few
            Purpose::Optimize => parallel::stored(scene, grid),
            Purpose::Evaluate { .. } | Purpose::Probe => Cost::default(),
        })
    }

    fn build(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        let model = self.model(input, input.scene.purpose)?;
        Ok(Box::new(match input.scene.purpose {
            Purpose::Optimize => model.cached(),
            _ => model,
        }))
    }

    fn form(&self, input: &ModelInput<'_>) -> Result<Option<Form>> {
        // All views, not those of the first part of a turn alone
        self.model(input, Purpose::Probe)?.to_form(input.work)
    }

    fn unscattered_form(&self, input: &ModelInput<'_>) -> Result<Option<Form>> {
        if input.scene.unscattered_beyond_slices().is_none() {
            return parallel::Params::default().form(input);
        }
        let OpticalScene {
            vial,
            lights,
            optics,
            ..
        } = input.scene;
        by_rays(vial, lights.to_vec(), optics, self, input.grid)?.to_form(input.work)
    }

    fn unscattered(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        if input.scene.unscattered_beyond_slices().is_none() {
            return parallel::Params::default().unscattered(input);
        }
        let OpticalScene {
            vial,
            lights,
            optics,
            ..
        } = input.scene;
        let rays = by_rays(vial, lights.to_vec(), optics, self, input.grid)?;
        Ok(Box::new(rays))
    }

    fn compared_with(&self) -> Option<fn(usize, u64) -> Family> {
        Some(|paths_per_pixel, seed| {
            Arc::new(monte_carlo::Params {
                paths_per_pixel,
                smooth: 1,
                seed,
                ..monte_carlo::Params::default()
            })
        })
    }
}

impl Params {
    /// The model for the purpose of the scene, whose collimated light finds its entries as for this one.
    fn model(&self, input: &ModelInput<'_>, finding: Purpose) -> Result<SuccessiveOrders> {
        let OpticalScene { vial, optics, .. } = input.scene;
        let mut params = self.clone();
        if let Purpose::Evaluate { refine } = input.scene.purpose {
            params.rays_per_pixel = Some(params.rays() * refine * refine);
        }
        let lights = input.scene.lights.to_vec();
        let (grid, work) = (input.grid.clone(), input.work);
        model_for(vial, lights, optics, &params, grid, finding, work)
    }
}

/// See the [module page](self).
pub struct SuccessiveOrders {
    straight: OnVoxels,
    /// Of each light that is scattered.
    scattered_lights: Vec<ScatteredLight>,
}

/// Unscattered light on voxels.
enum OnVoxels {
    Collimated(Box<Parallel>),
    Divergent(Box<Rays>),
}

impl OnVoxels {
    fn model(&self) -> &dyn DoseModel<Field = HostField> {
        match self {
            OnVoxels::Collimated(parallel) => parallel.as_ref(),
            OnVoxels::Divergent(rays) => rays.as_ref(),
        }
    }
}

/// Largest part of scattered light that may count as unscattered: above, the dose is more than 1 % off (docs/validation.md).
const MAX_FORWARD_FRACTION: f64 = 0.03;

/// The model of a vial, its lights with their optics, and the voxels where dose is wanted.
///
/// # Errors
/// As [`Parallel::new`] and [`Rays::new`]; [`Error::Unsupported`] where [`beyond`] says why.
pub fn model(
    vial: &dyn Vial,
    lights: Vec<Light>,
    optics: &[Optics],
    params: &Params,
    grid: VolumeGrid,
) -> Result<SuccessiveOrders> {
    let (purpose, work) = (Purpose::Probe, Work::new());
    model_for(vial, lights, optics, params, grid, purpose, &work)
}

/// The [`model`] for a purpose, of a run that may be canceled while its kernels are computed.
fn model_for(
    vial: &dyn Vial,
    mut lights: Vec<Light>,
    optics: &[Optics],
    params: &Params,
    grid: VolumeGrid,
    purpose: Purpose,
    work: &Work,
) -> Result<SuccessiveOrders> {
    if let Some(reason) = beyond(vial, &lights, optics, &grid) {
        return Err(Error::unsupported(
            "model.successive_orders",
            format!("{reason}; use [model.monte_carlo]"),
        ));
    }
    let layout = DoseLayout::new("dose", grid.clone(), 0);
    let mut scattered = Vec::new();
    let (mut offset, mut first_frame) = (0, 0);
    for (number, (light, optics)) in lights.iter_mut().zip(optics).enumerate() {
        let pixels = offset..offset + light.layout(0).len();
        let frames = first_frame..first_frame + light.pixels.frames();
        (offset, first_frame) = (pixels.end, frames.end);
        if let Some(scattering) = &optics.scattering {
            let delta_scaled = DeltaScaledPhase::new(scattering);
            light.resin.attenuation_per_mm -= delta_scaled.straight_per_mm;
            scattered.push(ScatteringLight {
                number,
                pixels,
                frames,
                light: light.clone(),
                cone: Some(optics).filter(|optics| optics.beyond_level().is_some()),
                delta_scaled,
            });
        }
    }
    let straight = straight(vial, lights, optics, params, grid, purpose, work)?;
    let scattered_lights = scattered
        .into_iter()
        .map(|light| ScatteredLight::new(vial, light, params, &layout, purpose, work))
        .collect::<Result<_>>()?;
    Ok(SuccessiveOrders {
        straight,
        scattered_lights,
    })
}

/// The light that is not scattered, in the total attenuation of each light's resin.
fn straight(
    vial: &dyn Vial,
    lights: Vec<Light>,
    optics: &[Optics],
    params: &Params,
    grid: VolumeGrid,
    purpose: Purpose,
    work: &Work,
) -> Result<OnVoxels> {
    if optics.iter().all(|o| o.beyond_level().is_none()) {
        let kernel = parallel::Kernel::default();
        let model = Parallel::for_purpose(vial, lights, kernel, grid, purpose, work)?;
        return Ok(OnVoxels::Collimated(Box::new(model)));
    }
    let rays = by_rays(vial, lights, optics, params, &grid)?;
    Ok(OnVoxels::Divergent(Box::new(rays)))
}

/// Rays of light that is not scattered.
fn by_rays(
    vial: &dyn Vial,
    lights: Vec<Light>,
    optics: &[Optics],
    params: &Params,
    grid: &VolumeGrid,
) -> Result<Rays> {
    let clear = |optics: &Optics| Optics {
        scattering: None,
        ..optics.clone()
    };
    let optics: Vec<Optics> = optics.iter().map(clear).collect();
    let params = rays::Params {
        rays_per_pixel: params.rays(),
        ..rays::Params::default()
    };
    Rays::new(vial, lights, &optics, &params, grid.clone())
}

/// The reason why the model does not support a vial and its lights; None when it does.
#[must_use]
pub fn beyond(
    vial: &dyn Vial,
    lights: &[Light],
    optics: &[Optics],
    grid: &VolumeGrid,
) -> Option<&'static str> {
    let scattering = optics.iter().filter_map(|o| o.scattering.as_ref());
    let mut delta_scaled = scattering.map(DeltaScaledPhase::new);
    if !vial.is_invariant() {
        Some("the vial changes along z")
    } else if optics.iter().any(|o| !o.obstacles.is_empty()) {
        Some("bodies stand in the light")
    } else if let Some(reason) = lights.iter().find_map(|l| parallel::beyond(l, vial)) {
        Some(reason)
    } else if lights.iter().any(|light| light.map.is_some()) {
        Some("the absorption changes across the plane")
    } else if delta_scaled.any(|f| f.forward_fraction > MAX_FORWARD_FRACTION) {
        Some("too much of the scattered light goes into a narrow forward peak")
    } else if !vial.is_convex() {
        Some("not all points of the resin see each other along straight lines")
    } else if grid.shape[0] == 1 {
        Some("a single slice does not show how far light scatters along z")
    } else {
        None
    }
}

impl SuccessiveOrders {
    /// Keeps the walks of rays on voxels where they are few, as [`Rays::cached`].
    #[must_use]
    pub fn cached(mut self) -> Self {
        if let OnVoxels::Divergent(rays) = self.straight {
            self.straight = OnVoxels::Divergent(Box::new(rays.cached()));
        }
        self
    }

    /// The model as data; None where there are too many rays.
    fn to_form(&self, work: &Work) -> Result<Option<Form>> {
        let of_light = |light: &ScatteredLight| light.form(work).transpose();
        let of_lights = self.scattered_lights.iter().map_while(of_light);
        let scattered = of_lights.collect::<Result<Vec<_>>>()?;
        if scattered.len() < self.scattered_lights.len() {
            return Ok(None);
        }
        Ok(match &self.straight {
            OnVoxels::Collimated(parallel) => Some(Form::Strips(Masked::new(StripGeometry {
                scattered,
                ..parallel.geometry()
            }))),
            OnVoxels::Divergent(rays) => rays.in_grid(work)?.map(|geometry| {
                Form::Rays(Masked::new(RayGeometry {
                    scattered,
                    z_coupling: ZCoupling::Full,
                    summary: self.describe(),
                    ..geometry
                }))
            }),
        })
    }
}

impl DoseModel for SuccessiveOrders {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            z_coupling: ZCoupling::Full,
            ..self.straight.model().facts()
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        self.straight.model().new_field(space)
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let straight = self.straight.model();
        straight.dose_of(frames.clone(), x, dose, work)?;
        for scattered_light in &self.scattered_lights {
            scattered_light.add_forward(frames.clone(), x.as_slice(), dose.as_mut_slice(), work)?;
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let straight = self.straight.model();
        straight.pullback_of(frames.clone(), x, cotangent, grad, work)?;
        let (c, grad) = (cotangent.as_slice(), grad.as_mut_slice());
        for scattered_light in &self.scattered_lights {
            scattered_light.add_adjoint(&frames, c, grad, work)?;
        }
        Ok(())
    }

    fn updates(&self) -> u64 {
        self.straight.model().updates()
            + self
                .scattered_lights
                .iter()
                .map(ScatteredLight::updates)
                .sum::<u64>()
    }

    fn describe(&self) -> String {
        let of_light: Vec<String> = self
            .scattered_lights
            .iter()
            .map(ScatteredLight::describe)
            .collect();
        format!(
            "successive_orders ({}; scattered light on {})",
            self.straight.model().describe(),
            of_light.join(" and ")
        )
    }
}

#[cfg(test)]
mod tests;
