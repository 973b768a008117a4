//! What light passes from the projectors to the resin, as families of models see it.

use super::family::Purpose;
use super::monte_carlo;
use super::parallel;
use super::rays::{self, Optics, Rays};
use std::sync::Arc;
use tomolith_core::dose::Accelerator;
use tomolith_core::error::Result;
use tomolith_core::grid::VolumeGrid;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;
use tomolith_target::Shape;

/// What light passes from the projectors to the resin, and what its dose is for.
#[derive(Clone, Copy)]
pub struct OpticalScene<'a> {
    /// The vial.
    pub vial: &'a dyn Vial,
    /// The lights.
    pub lights: &'a [Light],
    /// What stands between each light's pixels and the vial.
    pub optics: &'a [Optics],
    /// The shape whose surface cuts voxels into cells; None: whole voxels.
    pub solid: Option<&'a Arc<dyn Shape>>,
    /// What the doses are for.
    pub purpose: Purpose,
    /// What every dose is multiplied by: 1, or the factor of another program's doses.
    pub dose_factor: f64,
    /// What a model probe found against families that are only [compared with](crate::ModelFamily::compared_with) exact ones; None: nothing.
    pub probe_failed: Option<&'static str>,
    /// Where models are computed that have a form for it; None: the processor.
    pub accelerator: Option<&'a dyn Accelerator>,
}

/// Why whole voxels are not enough.
pub(crate) const CUT: &str = "the target's surface cuts voxels into cells";

impl<'a> OpticalScene<'a> {
    /// Whole voxels, on the processor.
    #[must_use]
    pub fn new(
        vial: &'a dyn Vial,
        lights: &'a [Light],
        optics: &'a [Optics],
        purpose: Purpose,
    ) -> Self {
        OpticalScene {
            vial,
            lights,
            optics,
            solid: None,
            purpose,
            dose_factor: 1.0,
            probe_failed: None,
            accelerator: None,
        }
    }

    /// The scene with other pixels of its lights.
    #[must_use]
    pub fn lit_by<'b>(self, lights: &'b [Light]) -> OpticalScene<'b>
    where
        'a: 'b,
    {
        OpticalScene { lights, ..self }
    }

    /// Whether light is scattered anywhere.
    #[must_use]
    pub fn scatters(&self) -> bool {
        self.optics.iter().any(Optics::scatters)
    }

    /// What scatters light; None where nothing does.
    #[must_use]
    pub fn scatterer(&self) -> Option<&'static str> {
        self.scatters().then(|| {
            if self.optics.iter().any(|o| o.scattering.is_some()) {
                "the resin scatters"
            } else {
                "a diffuse body scatters light"
            }
        })
    }

    /// That the projector's light has a measured spread, for models whose light has one already; None without.
    pub(crate) fn point_spread(&self) -> Option<&'static str> {
        let is_spread = |light: &Light| light.point_spread.is_some();
        (self.lights.iter().any(is_spread))
            .then_some("light.psf spreads light, and this model's light is spread already")
    }

    /// Why light does not stay in the slice that it comes in, the same way in all slices; None when it does, and nothing scatters it.
    #[must_use]
    pub fn beyond_slices(&self) -> Option<&'static str> {
        self.scatterer()
            .or_else(|| self.unscattered_beyond_slices())
    }

    /// Why unscattered light does not stay in the slice that it comes in; None when it does.
    pub(crate) fn unscattered_beyond_slices(&self) -> Option<&'static str> {
        if !self.vial.is_invariant() {
            Some("the vial changes along z")
        } else if let Some(reason) = self.optics.iter().find_map(Optics::beyond_level) {
            Some(reason)
        } else if self.optics.iter().any(|o| !o.obstacles.is_empty()) {
            Some("bodies stand in the light")
        } else if self.solid.is_some() {
            Some(CUT)
        } else {
            let mut lights = self.lights.iter();
            lights.find_map(|light| parallel::beyond(light, self.vial))
        }
    }

    /// Rays of its light with default parameters.
    pub(crate) fn rays(&self, grid: &VolumeGrid) -> Result<Rays> {
        let (vial, lights, optics) = (self.vial, self.lights, self.optics);
        if self.scatters() {
            monte_carlo::model(
                vial,
                lights,
                optics,
                &monte_carlo::Params::default(),
                grid.clone(),
            )
        } else {
            let params = rays::Params::default();
            Rays::new(vial, lights.to_vec(), optics, &params, grid.clone())
        }
    }
}
