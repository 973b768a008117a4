//! Chooses the dose model of a job, and says why.
//!
//! Like the planner of a Fourier-transform library: the cheapest model that is exact for the optics at hand. [`Parallel`]
//! where light is collimated, normal to the axis, and the vial the same at all heights; else [`Rays`]. Where the resin scatters,
//! [`orders`] under the same conditions, else [`scatter`]. A job may ask for one
//! of them, or for a stored matrix; what a model does not cover is refused with the reason.

use super::matrix::{self, MatrixModel};
use super::parallel::{Light, Parallel};
use super::rays::solid::Solid;
use super::rays::{self, Optics, Rays};
use super::selection::useful_rows;
use super::{Choice, DoseModel, Run, orders, scatter};
use crate::error::{Error, Result};
use crate::field::HostField;
use crate::grid::{Volume, VolumeGrid};
use crate::io::csr::Csr;
use crate::optics::phase::Scattering;
use crate::optics::vial::Vial;
use crate::target::Shape;
use std::borrow::Cow;
use std::sync::Arc;

/// A dose model, and why it was chosen.
pub struct Plan {
    /// The model.
    pub model: Box<dyn DoseModel<Field = HostField>>,
    /// One sentence for people.
    pub reason: String,
}

/// What light passes from the projectors to the resin.
#[derive(Clone, Copy)]
pub struct Setup<'a> {
    /// The vial.
    pub vial: &'a dyn Vial,
    /// What stands between each light's pixels and the vial.
    pub optics: &'a [Optics],
    /// The shape whose surface cuts voxels into cells; None: whole voxels.
    pub solid: Option<&'a Arc<dyn Shape>>,
}

/// How light becomes dose: what was asked for, or the cheapest that is exact.
enum Way<'a> {
    Stored(&'a matrix::Params),
    Optical(Optical<'a>),
}

/// Of the models that follow light through optics.
enum Optical<'a> {
    Parallel,
    Rays(Cow<'a, rays::Params>),
    Scatter(Cow<'a, scatter::Params>),
    Orders(Cow<'a, orders::Params>),
}

impl Setup<'_> {
    /// Refuses a model that does not cover these optics; to be called before any work.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of the model, or of the absorption map that rays do not know.
    pub fn must_be_covered(
        &self,
        choice: &Choice,
        lights: &[Light],
        grid: &VolumeGrid,
    ) -> Result<()> {
        self.way(choice, lights, grid).map(drop)
    }

    fn way<'a>(&self, choice: &'a Choice, lights: &[Light], grid: &VolumeGrid) -> Result<Way<'a>> {
        let refused =
            |key: &str, found: &str, accepted: &str| Err(Error::config(key, found, accepted));
        let other = "another model, or no [model] for the cheapest that is exact";
        let way = match (choice, self.beyond_parallel()) {
            (Choice::Matrix(_), _) if self.solid.is_some() => {
                return refused("model.matrix", "a stored matrix knows whole voxels", other);
            }
            (Choice::Matrix(params), _) => return Ok(Way::Stored(params)),
            (Choice::Parallel(_), Some(reason)) => return refused("model.parallel", reason, other),
            (Choice::Rays(_), _) if self.scatters() => {
                let accepted = "[model.scatter], or no [model]";
                return refused("model.rays", "the resin scatters", accepted);
            }
            (Choice::Rays(params), _) => Optical::Rays(Cow::Borrowed(params)),
            (Choice::Scatter(params), _) => Optical::Scatter(Cow::Borrowed(params)),
            (Choice::Orders(params), _) => match self.beyond_orders(lights, grid) {
                Some(reason) => return refused("model.orders", reason, other),
                None => Optical::Orders(Cow::Borrowed(params)),
            },
            (Choice::Cheapest, _) if self.scatters() => {
                if self.beyond_orders(lights, grid).is_none() {
                    Optical::Orders(Cow::default())
                } else {
                    Optical::Scatter(Cow::default())
                }
            }
            (Choice::Cheapest, Some(_)) => Optical::Rays(Cow::default()),
            (Choice::Parallel(_) | Choice::Cheapest, None) => Optical::Parallel,
        };
        let is_traced = !matches!(way, Optical::Parallel);
        if is_traced && lights.iter().any(|light| light.map.is_some()) {
            return refused(
                "resin.map",
                "rays know one absorption for all the resin",
                "resin.absorption_per_mm, or optics that [model.parallel] covers",
            );
        }
        Ok(Way::Optical(way))
    }

    /// Whether light is scattered anywhere.
    #[must_use]
    pub fn scatters(&self) -> bool {
        self.optics.iter().any(|o| o.scattering.is_some())
    }

    /// What scatters each light.
    fn scattering(&self) -> Vec<Option<Scattering>> {
        self.optics.iter().map(|o| o.scattering.clone()).collect()
    }

    /// Why [`Parallel`] does not cover it; None when it does.
    #[must_use]
    pub fn beyond_parallel(&self) -> Option<&'static str> {
        if self.scatters() {
            Some("the resin scatters")
        } else {
            self.beyond_straight()
        }
    }

    /// Why [`orders`] does not cover it with these lights on this grid; None when it does.
    #[must_use]
    pub fn beyond_orders(&self, lights: &[Light], grid: &VolumeGrid) -> Option<&'static str> {
        self.beyond_straight()
            .or_else(|| orders::beyond(self.vial, lights, &self.scattering(), grid))
    }

    /// Why [`Parallel`] does not cover its straight light.
    fn beyond_straight(&self) -> Option<&'static str> {
        let any = |f: &dyn Fn(&Optics) -> bool| self.optics.iter().any(f);
        if !self.vial.is_invariant() {
            Some("the vial changes along z")
        } else if any(&|o| !o.projector.is_collimated()) {
            Some("light is not collimated")
        } else if any(&|o| o.motion.tilt_rad != 0.0) {
            Some("light is not normal to the axis")
        } else if any(&|o| !o.motion.is_symmetric()) {
            Some("the vial does not turn about its own axis")
        } else if any(&|o| !o.obstacles.is_empty()) {
            Some("bodies stand in the light")
        } else if self.solid.is_some() {
            Some("the target's surface cuts voxels into cells")
        } else {
            None
        }
    }
}

/// The model that a job asks for.
///
/// With `wanted` (file order `[z, y, x]`, not 0 where something is to be printed), only pixels whose light meets such a
/// voxel become unknowns; the others stay dark.
///
/// # Errors
/// As [`Parallel::new`], [`Rays::new`], [`orders::model`], [`Solid::new`], [`Csr::read`] and [`MatrixModel::new`]; [`Error::Config`] for
/// optics that the model asked for does not cover; [`Error::Cancelled`].
pub fn plan(
    choice: &Choice,
    setup: Setup<'_>,
    mut lights: Vec<Light>,
    grid: VolumeGrid,
    wanted: Option<&Volume<u8>>,
    run: &Run,
) -> Result<Plan> {
    let way = match setup.way(choice, &lights, &grid)? {
        Way::Stored(params) => return stored(params, lights, grid),
        Way::Optical(way) => way,
    };
    let solid = setup.solid.map(|shape| Solid::new(shape, &grid));
    let solid = solid.transpose()?.map(Arc::new);
    let mut model = optical(&way, setup, lights.clone(), grid.clone(), solid.as_ref())?;
    if let Some(wanted) = wanted {
        let rows = useful_rows(model.as_ref(), wanted, run)?;
        for (light, rows) in lights.iter_mut().zip(rows) {
            light.active = Some(rows);
        }
        model = optical(&way, setup, lights, grid, solid.as_ref())?;
    }
    let why = match (choice, setup.beyond_parallel()) {
        (Choice::Rays(_), None) => {
            "as asked; [model.parallel] covers these optics too and is faster"
        }
        (_, Some(reason)) => reason,
        (_, None) => {
            "collimated light and a vial that does not change along z, so one slice's geometry serves all heights"
        }
    };
    Ok(Plan {
        reason: format!("{}: {why}", model.describe()),
        model,
    })
}

/// A stored matrix as a model.
fn stored(matrix: &matrix::Params, lights: Vec<Light>, grid: VolumeGrid) -> Result<Plan> {
    let pixels = lights.into_iter().map(|light| light.pixels).collect();
    let model = MatrixModel::new(&Csr::read(&matrix.file)?, pixels, grid)?;
    Ok(Plan {
        reason: format!(
            "{} from {}",
            DoseModel::describe(&model),
            matrix.file.display()
        ),
        model: Box::new(model),
    })
}

/// A model of the optics, not a stored one.
fn optical(
    way: &Optical<'_>,
    setup: Setup<'_>,
    lights: Vec<Light>,
    grid: VolumeGrid,
    solid: Option<&Arc<Solid>>,
) -> Result<Box<dyn DoseModel<Field = HostField>>> {
    let boxed = |model: Rays| -> Box<dyn DoseModel<Field = HostField>> {
        match solid {
            Some(solid) => Box::new(model.with_cells(Arc::clone(solid))),
            None => Box::new(model),
        }
    };
    let rays = |params: &_| {
        let (vial, optics) = (setup.vial, setup.optics);
        Rays::new(vial, lights.clone(), optics, params, grid.clone()).map(boxed)
    };
    let scatter =
        |params| scatter::model(setup.vial, &lights, setup.optics, params, grid.clone()).map(boxed);
    match way {
        Optical::Scatter(params) => scatter(params),
        Optical::Orders(params) => {
            let scattering = setup.scattering();
            let model = orders::model(setup.vial, lights, &scattering, params, grid)?;
            Ok(Box::new(model))
        }
        Optical::Rays(params) => rays(params),
        Optical::Parallel => Ok(Box::new(Parallel::new(setup.vial, lights, grid)?)),
    }
}
