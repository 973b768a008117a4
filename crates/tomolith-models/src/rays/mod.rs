//! The `rays` dose model: light of any direction through any vial, as rays and exact line integrals.
//!
//! # Model
//! Every pixel sends a fixed set of rays: points of its area and of the projector's aperture. Each is traced through walls
//! and obstacles ([`SpaceTracer`]); what it leaves in a voxel is the integral of Beer–Lambert over the way through it. Vials,
//! tilted axes, cones and obstacles differ only in the tracer; dose and adjoint are two visitors of the same walk.
//!
//! # Equation
//! With n rays per pixel of area A, segments of power P (per emitted power) that enter the resin at 0:
//!
//! ```text
//! forward   dose(v) = Σ_pixels x · A/(n·V) Σ_rays Σ_segments P · (μ_a/μ_t) · (e^(−μ_t·s_in) − e^(−μ_t·s_out))
//! adjoint   grad(pixel) = Σ_v (∂dose(v)/∂x(pixel)) · c(v)
//! ```
//! s_in, s_out: way in the resin at which the segment enters and leaves voxel v. In pure Radon mode μ_a (1 − …)/μ_t is s_out − s_in.
//!
//! # Source
//! Nicolet et al. 2024, § 4 (rays from the projector, deterministic absorption along them); voxel walk: `traversal.rs`.
//!
//! # Limits
//! A point ray per sample: where voxels are smaller than the distance of rays, dose is grainy; the energy is right.
//!
//! # Cost
//! About 1.7 voxels per ray and voxel plane; collimated light through what is the same at all heights: a ray per column (`column_rays.rs`). Where a round vial turns about its own axis, rays are traced
//! once for all frames; elsewhere they are traced again in every call, so memory does not grow with their number. Where
//! what all pixels leave is at most 2.1 GB, a model that is [`cached`](Rays::cached) stores it: `matrix_cache.rs`.
//!
//! # Example
//! A pixel through an index-matched cylinder leaves 1 − e^(−2μR) of its energy:
//! ```
//! use tomolith_core::field::{Field, HostField};
//! use tomolith_core::grid::{PatternGrid, VolumeGrid};
//! use tomolith_models::{DoseModel, Work, rays::{Optics, Params, Rays}};
//! use tomolith_optics::light::Light;
//! use tomolith_optics::{resin::Resin, vial::index_matched::IndexMatched};
//! let pixels = PatternGrid::full_turn(3, 0.0, 1, 1, 0.1);
//! let light = Light::new(pixels, Resin::absorbing(1.5, 0.1));
//! let grid = VolumeGrid::centered([4, 50, 50], 0.1);
//! let vial = IndexMatched { radius_mm: 2.0 };
//! let model = Rays::new(&vial, vec![light], &[Optics::collimated(0.1)], &Params::default(), grid).unwrap();
//! let mut x = model.new_patterns().unwrap();
//! x.fill(1.0);
//! let mut dose = model.new_dose().unwrap();
//! model.dose(&x, &mut dose, &Work::new()).unwrap();
//! let absorbed: f32 = dose.as_slice().iter().sum::<f32>() * 0.1f32.powi(3); // mJ
//! let sent = 3.0 * 0.1 * 0.1; // three frames of one pixel of 1 mJ/mm²
//! assert!((absorbed / sent - (1.0 - (-0.4f32).exp())).abs() < 1e-4); // the rays at ±0.025 mm run 4 mm less 6e-4
//! ```

pub mod accumulation;
mod batch;
mod column_rays;
mod form;
pub mod matrix_cache;
mod path_form;
mod scatter_grid;
mod segment;
mod slanted;
pub mod solid;
mod source;
mod traversal;
pub(crate) mod weighted;

use crate::{
    Capabilities, Cost, DoseLayout, DoseModel, HostModel, MakeFamily, ModelFamily, ModelInput,
    ModelKind, OpticalScene, PatternLayout, Purpose, Refines, TimedBy, Work, ZCoupling, own_frames,
};
use accumulation::Accumulation;
use column_rays::{ColumnRay, ColumnRaysCache};
use matrix_cache::{CachedEntries, RayMatrixCache};
use scatter_grid::ScatterGrid;
use segment::{Lattice, Segment};
use solid::Solid;
use source::Source;
use std::ops::Range;
use std::sync::{Arc, OnceLock};
use tomolith_core::dose::form::Form;
use tomolith_core::dose::{Facts, Renewal, Space};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{HostField, LANES};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::kind::schema_of;
use tomolith_optics::light::Light;
use tomolith_optics::motion::Motion;
use tomolith_optics::obstacle::{BodyMaterial, Obstacle};
use tomolith_optics::phase::Scattering;
use tomolith_optics::power_balance::PowerBalance;
use tomolith_optics::projector::Projector;
use tomolith_optics::projector::collimated::Collimated;
use tomolith_optics::space::{PathSegment, SpaceTracer, TraceLimits};
use tomolith_optics::vial::Vial;
use traversal::Gait;

tomolith_core::keys! {
    /// Keys of `[model.rays]`.
    #[derive(PartialEq)]
    pub struct Params {
        /// Rays of a pixel in a frame: as many heights and places across, heights differ from column to column; one is the middle ray.
        #[schemars(range(min = 1, max = 4096))]
        pub rays_per_pixel: usize = 4,
        /// How energy is accumulated along a ray: "integral", "simple" or { ratio = { majorant_per_mm = 10.0 } }.
        pub accumulation: Accumulation = Accumulation::Integral,
        /// Whether light reflected at walls is followed.
        pub reflections: bool = false,
        /// Reflected rays below this part of the emitted power are dropped.
        #[schemars(range(min = 1e-9, max = 0.1))]
        pub least_power: f64 = TraceLimits::default().least_power,
    }
}

/// Row of [`MODELS`](super::MODELS).
pub const KIND: ModelKind = ModelKind {
    name: "rays",
    summary: "Rays of any direction through any vial: cones, tilted axes, meshes, obstacles, reflections.",
    example: "[model.rays]\nrays_per_pixel = 4\n",
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
            refines: Refines::Cells,
            ..Capabilities::default()
        }
    }

    fn unsupported(&self, scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Option<&'static str> {
        scene.scatterer()
    }

    fn instead(&self) -> &'static str {
        "[model.monte_carlo], or no [model]"
    }

    fn cost(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Result<Cost> {
        let walks = || Rays::cached_entries(scene, self, grid);
        Ok(Cost {
            cached_entries: (scene.purpose == Purpose::Optimize).then(walks),
            ..Cost::default()
        })
    }

    fn build(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        let model = self.model(input)?;
        Ok(Box::new(match input.scene.purpose {
            Purpose::Optimize => model.cached(),
            _ => model,
        }))
    }

    fn form(&self, input: &ModelInput<'_>) -> Result<Option<Form>> {
        self.model(input)?.to_form(input.work)
    }

    fn rays(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Option<Result<Rays>> {
        let lights = scene.lights.to_vec();
        Some(Rays::new(
            scene.vial,
            lights,
            scene.optics,
            self,
            grid.clone(),
        ))
    }
}

impl Params {
    /// The model for the purpose of the scene.
    fn model(&self, input: &ModelInput<'_>) -> Result<Rays> {
        let OpticalScene { vial, optics, .. } = input.scene;
        let mut params = self.clone();
        if let Purpose::Evaluate { refine } = input.scene.purpose {
            params.rays_per_pixel *= refine * refine;
        }
        let lights = input.scene.lights.to_vec();
        let model = Rays::new(vial, lights, optics, &params, input.grid.clone())?;
        Ok(input.with_cells(model))
    }
}

/// What stands between a light's pixels and the vial.
#[derive(Clone, Debug)]
pub struct Optics {
    /// Which rays a pixel sends.
    pub projector: Arc<dyn Projector>,
    /// How the vial moves before it.
    pub motion: Motion,
    /// What stands in the light.
    pub obstacles: Vec<Obstacle>,
    /// What scatters in the resin, at this light's wavelength.
    pub scattering: Option<Scattering>,
}

impl Optics {
    /// Parallel light on a vial that only turns.
    #[must_use]
    pub fn collimated(pixel_pitch_mm: f64) -> Self {
        Optics {
            projector: Arc::new(Collimated {
                pixel_pitch_mm: [pixel_pitch_mm; 2],
            }),
            motion: Motion::default(),
            obstacles: Vec::new(),
            scattering: None,
        }
    }

    /// The same light on an axis that is tilted by this angle.
    #[must_use]
    pub fn tilted(mut self, tilt_rad: f64) -> Self {
        self.motion.tilt_rad = tilt_rad;
        self
    }

    /// Whether the light of all rows goes the same way, one above the other.
    fn is_alike_along_z(&self) -> bool {
        self.projector.is_collimated() && self.obstacles.is_empty()
    }

    /// Whether the axis of its light is normal to the vial's.
    fn is_level(&self) -> bool {
        self.motion.tilt_rad == 0.0
    }

    /// Why its light is not collimated, normal to the axis of a vial that turns about it; None when it is.
    #[must_use]
    pub fn beyond_level(&self) -> Option<&'static str> {
        if !self.projector.is_collimated() {
            Some("light is not collimated")
        } else if self.motion.tilt_rad != 0.0 {
            Some("light is not normal to the axis")
        } else if !self.motion.is_symmetric() {
            Some("the vial does not turn about its own axis")
        } else {
            None
        }
    }

    /// Whether light goes on in random directions anywhere.
    #[must_use]
    pub fn scatters(&self) -> bool {
        let diffuse = |body: &Obstacle| matches!(body.material, BodyMaterial::Diffuse { .. });
        self.scattering.is_some() || self.obstacles.iter().any(diffuse)
    }

    /// The same where light that is scattered is lost.
    #[must_use]
    pub fn without_scattering(&self) -> Self {
        let mut clear = self.clone();
        clear.scattering = None;
        for body in &mut clear.obstacles {
            if let BodyMaterial::Diffuse { .. } = body.material {
                body.material = BodyMaterial::Black;
            }
        }
        clear
    }
}

/// Whether light that nothing scatters goes the same way in all slices.
fn are_alike_along_z(vial: &dyn Vial, lights: &[Light], optics: &[Optics]) -> bool {
    let is_flat = |light: &Light| light.map.as_ref().is_none_or(|map| map.is_flat());
    vial.is_invariant() && optics.iter().all(Optics::is_alike_along_z) && lights.iter().all(is_flat)
}

/// Whether the rays of all rows of a column are followed together: where light goes the same way in all slices, and is slanted only where a voxel
/// takes little of it (`slanted.rs`).
fn are_in_columns(vial: &dyn Vial, lights: &[Light], optics: &[Optics], pitch_mm: f64) -> bool {
    let takes_little = |(light, optics): (&Light, &Optics)| {
        let most = light.map.as_ref().map_or(0.0, |map| map.most_per_mm());
        let most = most.max(light.resin.attenuation_per_mm) * pitch_mm;
        optics.is_level() || most <= slanted::MOST_ABSORBED
    };
    are_alike_along_z(vial, lights, optics) && lights.iter().zip(optics).all(takes_little)
}

/// How a pixel's light is followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Emission {
    pub(super) rays_per_pixel: usize,
    pub(super) accumulation: Accumulation,
    pub(super) limits: TraceLimits,
    /// None: unscattered light only.
    pub(super) scattered: Option<Scattered>,
}

/// How scattered light is followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scattered {
    /// Seed of the random numbers.
    pub(super) seed: u64,
    /// Voxels along an edge of the cells on which it is summed.
    pub(super) smooth: usize,
    /// Whether what cells smear out is given back.
    pub(super) is_sharp: bool,
    /// Iterations of an optimization after which other paths are drawn; 0: never.
    pub(super) renew: usize,
}

/// See the [module page](self).
pub struct Rays {
    sources: Vec<Source>,
    patterns: Vec<PatternLayout>,
    output: DoseLayout,
    lattice: Lattice,
    /// Where scattered light is summed.
    scatter_grid: Option<ScatterGrid>,
    /// What cuts voxels into cells.
    solid: Option<Arc<Solid>>,
    gait: Gait,
    /// Whether light stays in the slice that it comes in, the same way in all slices.
    is_level: bool,
    /// Whether rays are followed for all rows of a column at once, where that gives the same.
    by_rows: bool,
    accumulation: Accumulation,
    /// Iterations after which other paths are drawn; 0: never.
    renew: usize,
    updates: OnceLock<u64>,
    /// Whether traced rays are stored where they are few.
    caches: bool,
    /// They, once it is known.
    cache: OnceLock<Option<RayMatrixCache>>,
    cached_column_rays: OnceLock<Option<ColumnRaysCache>>,
}

impl Rays {
    /// The model of a vial, its lights with their optics, and the voxels where dose is wanted.
    ///
    /// # Errors
    /// [`Error::Config`] when there is nothing to light or nothing that absorbs; [`Error::Unsupported`] for a map where nothing
    /// absorbs, a kernel of pure Radon or a resin that scatters.
    pub fn new(
        vial: &dyn Vial,
        lights: Vec<Light>,
        optics: &[Optics],
        params: &Params,
        grid: VolumeGrid,
    ) -> Result<Self> {
        if optics.iter().any(Optics::scatters) {
            return Err(Error::unsupported(
                "model.rays",
                "light is scattered; use [model.monte_carlo], or leave [model] out",
            ));
        }
        let emission = Emission {
            rays_per_pixel: params.rays_per_pixel,
            accumulation: params.accumulation,
            limits: TraceLimits {
                reflections: params.reflections,
                least_power: params.least_power,
                ..TraceLimits::default()
            },
            scattered: None,
        };
        Self::build(vial, &lights, optics, &emission, grid)
    }

    /// The model of unscattered light, or of light and what is scattered out of it.
    pub(super) fn build(
        vial: &dyn Vial,
        lights: &[Light],
        optics: &[Optics],
        emission: &Emission,
        grid: VolumeGrid,
    ) -> Result<Self> {
        if grid.is_empty() {
            return Err(Error::config(
                "grid",
                format!("shape {:?} [z, y, x]", grid.shape),
                "at least one voxel",
            ));
        }
        let output = DoseLayout::new("dose", grid, 0);
        let (mut sources, mut patterns) = (Vec::new(), Vec::new());
        let mut offset = 0;
        for (light, optics) in lights.iter().zip(optics) {
            light.check()?;
            refuse(light, optics)?;
            let of_map = light.map.as_ref().map_or(0.0, |map| map.most_per_mm());
            let most = light.resin.attenuation_per_mm.max(of_map);
            if let Some(found) = emission.accumulation.trouble(most) {
                return Err(Error::config(
                    "model.rays.accumulation",
                    found,
                    "\"integral\", or a majorant of at least the attenuation",
                ));
            }
            let tracer = SpaceTracer::new(
                vial,
                light.resin,
                light.surrounding_index,
                light.polarization,
                emission.limits,
            )
            .in_bath(light.bath)
            .in_map(light.map.clone())
            .in_scattering(optics.scattering.clone())
            .with_obstacles(optics.obstacles.clone());
            let is_round = vial.is_round() && optics.obstacles.is_empty() && light.map.is_none();
            let layout = light.layout(offset);
            offset += layout.len();
            sources.push(Source::new(
                light,
                Arc::clone(&optics.projector),
                optics.motion,
                emission,
                tracer,
                is_round,
            ));
            patterns.push(layout);
        }
        if u32::try_from(offset).is_err() || i32::try_from(output.len()).is_err() {
            return Err(Error::unsupported(
                "model.rays",
                format!(
                    "{offset} pixels and {} voxels; at most 2^32 active pixels and 2^31 voxels",
                    output.grid.len()
                ),
            ));
        }
        let of_scattered =
            |scattered: Scattered| ScatterGrid::new(vial, lights, optics, &output, &scattered);
        let scatter_grid = emission.scattered.map(of_scattered);
        Ok(Rays {
            lattice: Lattice::new(&output),
            scatter_grid,
            solid: None,
            is_level: are_alike_along_z(vial, lights, optics)
                && optics.iter().all(Optics::is_level)
                && emission.scattered.is_none(),
            by_rows: are_in_columns(vial, lights, optics, output.grid.pitch_mm)
                && emission.scattered.is_none(),
            sources,
            patterns,
            output,
            gait: Gait::in_use(),
            accumulation: emission.accumulation,
            renew: emission.scattered.map_or(0, |scattered| scattered.renew),
            updates: OnceLock::new(),
            caches: false,
            cache: OnceLock::new(),
            cached_column_rays: OnceLock::new(),
        })
    }

    /// Caches what every pixel, or all rows of a column, leave in every voxel from the first call on, where that is at most 2.1 GB; not where
    /// light is scattered. Worth it for more than one or two doses.
    #[must_use]
    pub fn cached(mut self) -> Self {
        self.caches = self.scatter_grid.is_none();
        self
    }

    /// The stored rays; None where none are.
    fn cache(&self, work: &Work) -> Result<Option<&RayMatrixCache>> {
        if self.caches && !self.has_column_rays() && self.cache.get().is_none() {
            // Whoever comes first; all would find the same
            let _ = self
                .cache
                .set(RayMatrixCache::of(self, matrix_cache::MOST, work)?);
        }
        Ok(self.cache.get().and_then(Option::as_ref))
    }

    /// The stored column rays of all lights; None where none are.
    fn cached_column_rays(&self, work: &Work) -> Result<Option<&ColumnRaysCache>> {
        if self.caches && self.has_column_rays() && self.cached_column_rays.get().is_none() {
            let most = matrix_cache::MOST * matrix_cache::BYTES / column_rays::BYTES[0];
            let _ = self
                .cached_column_rays
                .set(ColumnRaysCache::of(self, most, work)?);
        }
        Ok(self.cached_column_rays.get().and_then(Option::as_ref))
    }

    /// The rays with two doses in every voxel that a solid cuts; it must have been made for the model's grid.
    ///
    /// # Panics
    /// When the solid was made for another grid.
    #[must_use]
    pub fn with_cells(mut self, solid: Arc<Solid>) -> Self {
        let layout = DoseLayout::new("dose", self.output.grid.clone(), 0);
        assert!(solid.fits(&layout.grid), "a solid on another grid");
        self.output = layout.with_cells(Arc::clone(solid.cells()));
        self.solid = Some(solid);
        self
    }

    /// Uses the plain kernel, and follows every ray by itself; for tests and benches.
    #[must_use]
    pub fn plain(mut self) -> Self {
        self.gait = Gait::Plain;
        self.by_rows = false;
        self
    }

    /// Whether rays are followed for all rows of a column at once.
    fn has_column_rays(&self) -> bool {
        self.by_rows
            && self.solid.is_none()
            && self.accumulation == Accumulation::Integral
            && self.output.row.is_multiple_of(LANES)
    }

    /// What [`cached`](Self::cached) stores of a scene, if it stores anything.
    pub(super) fn cached_entries(
        scene: &OpticalScene<'_>,
        params: &Params,
        grid: &VolumeGrid,
    ) -> CachedEntries {
        let (lights, optics) = (scene.lights, scene.optics);
        let in_columns = are_in_columns(scene.vial, lights, optics, grid.pitch_mm)
            && scene.solid.is_none()
            && params.accumulation == Accumulation::Integral
            && grid.shape[0] > 1;
        if !in_columns {
            return CachedEntries::of_pixels(lights, params.rays_per_pixel, grid);
        }
        let (mut columns, mut pixels, mut rays) = (0, 0, 0);
        for light in lights {
            let layout = light.layout(0);
            columns += layout.runs.iter().filter(|run| run.count > 0).count();
            pixels += layout.len();
            rays = rays.max(params.rays_per_pixel * light.sub_angles.max(1));
        }
        let per_update = columns as f64 / pixels.max(1) as f64
            * column_rays::BYTES[usize::from(!optics.iter().all(Optics::is_level))] as f64
            / matrix_cache::BYTES as f64;
        CachedEntries {
            per_pixel: matrix_cache::CROSSED * per_update * rays as f64,
            per_update,
        }
    }

    /// Where the power of a frame of a light goes, mean over its pixels.
    #[must_use]
    pub fn balance(&self, light: usize, frame: usize) -> PowerBalance {
        self.sources[light].balance(frame)
    }

    /// What becomes of one pixel's light (row counted from below): segments of its middle ray, and the mean balance of its rays.
    #[must_use]
    pub fn trace(
        &self,
        light: usize,
        frame: usize,
        column: usize,
        row: usize,
    ) -> (Vec<PathSegment>, PowerBalance) {
        self.sources[light].trace_pixel(frame, column, row)
    }
}

/// What this model has no formula for.
fn refuse(light: &Light, optics: &Optics) -> Result<()> {
    let unsupported = |what: &str, reason: &str| Err(Error::unsupported(what, reason));
    if light.map.is_some() && light.resin.pure_radon {
        return unsupported("resin.absorption_map", "in pure Radon nothing absorbs");
    }
    if let (Some(map), Some(scattering)) = (&light.map, &optics.scattering) {
        map.must_hold(scattering.per_mm)?;
    }
    Ok(())
}

impl Renewal<HostField> for Rays {
    /// Draws other paths, whatever the patterns are.
    fn renew(&self, iteration: usize, _x: &HostField, _run: &Work) -> Result<bool> {
        let round = (iteration.saturating_sub(1) / self.renew) as u64;
        let renewed: Vec<bool> = self.sources.iter().map(|s| s.renew(round)).collect();
        Ok(renewed.contains(&true))
    }
}

impl DoseModel for Rays {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: std::slice::from_ref(&self.output),
            z_coupling: if self.is_level {
                ZCoupling::None
            } else {
                ZCoupling::Full
            },
            is_linear: true,
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let x = x.as_slice();
        let dose = dose.as_mut_slice();
        // Energies outside and inside of the solid, where there is one
        let voxels = self.output.voxels();
        let mut split = self
            .solid
            .as_ref()
            .map(|_| [(); 2].map(|()| vec![0.0; voxels]));
        let cache = self.cache(work)?;
        for (light, light_frames) in own_frames(&self.patterns, &frames) {
            if let Some(cache) = cache {
                let pixels = self.patterns[light].elements_of(light_frames);
                match &mut split {
                    None => cache.add(0, x, &pixels, &mut dose[..voxels]),
                    Some([outside, inside]) => {
                        cache.add(0, x, &pixels, outside);
                        cache.add(voxels, x, &pixels, inside);
                    }
                }
                continue;
            }
            if self.has_column_rays() {
                let dose = &mut dose[..voxels];
                let is_lit = |pixel: usize| x[pixel] != 0.0;
                self.for_each_sheets(light, light_frames, is_lit, work, |column_rays| {
                    column_rays::add(column_rays, &self.output, x, dose);
                })?;
                continue;
            }
            let mut cells = self.scatter_grid.as_ref().map(ScatterGrid::cells);
            let is_lit = |pixel: usize| x[pixel] != 0.0;
            self.for_each_chunk(light, light_frames, is_lit, work, |lit| {
                match &mut split {
                    None => self.add(&self.lattice, &lit.straight, x, dose),
                    Some([outside, inside]) => {
                        self.add(&self.lattice, &lit.straight, x, outside);
                        self.add(&self.lattice, &lit.inside, x, inside);
                    }
                }
                if let (Some(scatter_grid), Some(cells)) = (&self.scatter_grid, &mut cells) {
                    self.add(&scatter_grid.lattice, &lit.scattered, x, cells);
                }
            })?;
            if let (Some(scatter_grid), Some(cells)) = (&self.scatter_grid, &cells) {
                scatter_grid.add(light, cells, self.solid.as_deref(), dose);
            }
        }
        if let (Some(solid), Some([outside, inside])) = (&self.solid, &split) {
            solid.cells().add([outside, inside], dose);
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let (c, grad) = (cotangent.as_slice(), grad.as_mut_slice());
        let split = self.solid.as_ref().map(|solid| solid.cells().collect(c));
        let cache = self.cache(work)?;
        let sides = cache.and(split.as_ref()).map(|sides| sides.concat());
        for (light, light_frames) in own_frames(&self.patterns, &frames) {
            let pixels = self.patterns[light].elements_of(light_frames.clone());
            if let Some(cache) = cache {
                cache.collect(sides.as_deref().unwrap_or(c), &pixels, grad);
                continue;
            }
            grad[pixels].fill(0.0);
            if self.has_column_rays() {
                let all = |_| true;
                self.for_each_sheets(light, light_frames, all, work, |column_rays| {
                    column_rays::collect(column_rays, &self.output, c, grad);
                })?;
                continue;
            }
            let scatter_grid = self.scatter_grid.as_ref();
            let scatter_grid = scatter_grid.map(|scatter_grid| {
                (
                    scatter_grid,
                    scatter_grid.collect(light, c, self.solid.as_deref()),
                )
            });
            let all = |_| true;
            self.for_each_chunk(light, light_frames, all, work, |lit| {
                match &split {
                    None => self.collect(&self.lattice, &lit.straight, c, grad),
                    Some([outside, inside]) => {
                        self.collect(&self.lattice, &lit.straight, outside, grad);
                        self.collect(&self.lattice, &lit.inside, inside, grad);
                    }
                }
                if let Some((scatter_grid, cells)) = &scatter_grid {
                    self.collect(&scatter_grid.lattice, &lit.scattered, cells, grad);
                }
            })?;
        }
        Ok(())
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        (self.renew > 0).then_some(self as _)
    }

    /// Voxels that all segments pass: planes of each axis they cross, summed.
    fn updates(&self) -> u64 {
        if let Ok(Some(cache)) = self.cache(&Work::new()) {
            return cache.updates();
        }
        *self.updates.get_or_init(|| {
            let mut total = 0.0;
            for (light, layout) in self.patterns.iter().enumerate() {
                for pairs in self.chunks(light, 0..layout.grid.frames()) {
                    if self.has_column_rays() {
                        let column_rays = self.column_rays(light, pairs, |_| true);
                        total += column_rays.iter().map(ColumnRay::updates).sum::<f64>();
                        continue;
                    }
                    let lit = self.bundles(light, pairs, |_| true);
                    let bundles = lit.straight.iter().chain(&lit.inside).chain(&lit.scattered);
                    total += bundles.flatten().map(Segment::passed).sum::<f64>();
                }
            }
            total as u64
        })
    }

    fn describe(&self) -> String {
        let rays = self.sources.first().map_or(0, Source::rays);
        let cells = self.solid.as_ref().map_or(String::new(), |solid| {
            format!(", {} voxels cut by the surface", solid.cells().len())
        });
        let (name, how) = match self.sources.iter().any(Source::is_scattering) {
            true => (
                "monte_carlo",
                "Monte Carlo paths of scattered light and exact line integrals",
            ),
            false => ("rays", "exact line integrals"),
        };
        format!("{name}, {rays} per pixel and frame, {how}{cells}")
    }
}

#[cfg(test)]
mod tests;
