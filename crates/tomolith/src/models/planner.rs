//! Chooses the dose model of a job, and says why.
//!
//! Like the planner of a Fourier-transform library: the cheapest model that is exact for the optics at hand. [`Parallel`]
//! where light is collimated, normal to the axis, and the vial the same at all heights; else [`Rays`]. Where the resin scatters,
//! [`orders`] under the same conditions, else [`scatter`]. A job may ask for one
//! of them, or for a stored matrix; what a model does not cover is refused with the reason.

use super::matrix::MatrixModel;
use super::parallel::{Light, Parallel};
use super::rays::{Optics, Rays};
use super::selection::useful_rows;
use super::{Choice, DoseModel, Run, orders, scatter};
use crate::error::{Error, Result};
use crate::field::HostField;
use crate::grid::{Volume, VolumeGrid};
use crate::io::csr::Csr;
use crate::optics::phase::Scattering;
use crate::optics::vial::Vial;

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
}

impl Setup<'_> {
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
/// As [`Parallel::new`], [`Rays::new`], [`Csr::read`] and [`MatrixModel::new`]; [`Error::Unsupported`] for optics that the
/// model asked for does not cover; [`Error::Cancelled`].
pub fn plan(
    choice: &Choice,
    setup: Setup<'_>,
    mut lights: Vec<Light>,
    grid: VolumeGrid,
    wanted: Option<&Volume<u8>>,
    run: &Run,
) -> Result<Plan> {
    if let Choice::Matrix(matrix) = choice {
        let pixels = lights.into_iter().map(|light| light.pixels).collect();
        let model = MatrixModel::new(&Csr::read(&matrix.file)?, pixels, grid)?;
        return Ok(Plan {
            reason: format!(
                "{} from {}",
                DoseModel::describe(&model),
                matrix.file.display()
            ),
            model: Box::new(model),
        });
    }
    let mut model = optical(choice, setup, lights.clone(), grid.clone())?;
    if let Some(wanted) = wanted {
        let rows = useful_rows(model.as_ref(), wanted, run)?;
        for (light, rows) in lights.iter_mut().zip(rows) {
            light.active = Some(rows);
        }
        model = optical(choice, setup, lights, grid)?;
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

/// A model of the optics, not a stored one.
fn optical(
    choice: &Choice,
    setup: Setup<'_>,
    lights: Vec<Light>,
    grid: VolumeGrid,
) -> Result<Box<dyn DoseModel<Field = HostField>>> {
    let rays = |params| {
        Rays::new(
            setup.vial,
            lights.clone(),
            setup.optics,
            params,
            grid.clone(),
        )
    };
    let scatter = |params| scatter::model(setup.vial, &lights, setup.optics, params, grid.clone());
    let orders = |params| {
        let scattering = setup.scattering();
        orders::model(
            setup.vial,
            lights.clone(),
            &scattering,
            params,
            grid.clone(),
        )
    };
    match (choice, setup.beyond_parallel()) {
        (Choice::Scatter(params), _) => Ok(Box::new(scatter(params)?)),
        (Choice::Orders(params), _) => match setup.beyond_straight() {
            Some(reason) => Err(Error::Unsupported {
                what: "model.orders".into(),
                reason: format!("{reason}; use [model.scatter], or leave [model] out"),
            }),
            None => Ok(Box::new(orders(params)?)),
        },
        (Choice::Cheapest, _) if setup.scatters() => {
            if setup.beyond_orders(&lights, &grid).is_none() {
                Ok(Box::new(orders(&orders::Params::default())?))
            } else {
                Ok(Box::new(scatter(&scatter::Params::default())?))
            }
        }
        (Choice::Rays(params), _) => Ok(Box::new(rays(params)?)),
        (Choice::Cheapest, Some(_)) => Ok(Box::new(rays(&super::rays::Params::default())?)),
        (Choice::Parallel(_), Some(reason)) => Err(Error::Unsupported {
            what: "model.parallel".into(),
            reason: format!("{reason}; leave [model] out, or name another"),
        }),
        (_, None) => Ok(Box::new(Parallel::new(setup.vial, lights, grid)?)),
        (Choice::Matrix(_), Some(_)) => unreachable!("a stored matrix needs no optics"),
    }
}
