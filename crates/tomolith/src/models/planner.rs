//! Chooses the dose model of a job, and says why.
//!
//! Like the planner of a Fourier-transform library: the cheapest model that is exact for the optics at hand. Today there
//! is one, [`Parallel`]; what it does not cover is refused with the reason.

use super::parallel::{Light, Parallel};
use super::{DoseModel, Run};
use crate::error::Result;
use crate::field::HostField;
use crate::grid::{Volume, VolumeGrid};
use crate::optics::vial::Vial;

/// A dose model, and why it was chosen.
pub struct Plan {
    /// The model.
    pub model: Box<dyn DoseModel<Field = HostField>>,
    /// One sentence for people.
    pub reason: String,
}

/// The model for collimated lights through a z-invariant vial.
///
/// With `wanted` (file order `[z, y, x]`, not 0 where something is to be printed), only pixels whose light meets such a
/// voxel become unknowns; the others stay dark.
///
/// # Errors
/// As [`Parallel::new`]; [`Error::Cancelled`](crate::Error::Cancelled).
pub fn plan(
    vial: &dyn Vial,
    mut lights: Vec<Light>,
    grid: VolumeGrid,
    wanted: Option<&Volume<u8>>,
    run: &Run,
) -> Result<Plan> {
    let mut model = Parallel::new(vial, lights.clone(), grid.clone())?;
    if let Some(wanted) = wanted {
        let rows = model.useful_rows(wanted, run)?;
        for (light, rows) in lights.iter_mut().zip(rows) {
            light.active = Some(rows);
        }
        model = Parallel::new(vial, lights, grid)?;
    }
    let reason = format!(
        "{}: collimated light and a vial that does not change along z, so one slice's geometry serves all heights",
        DoseModel::describe(&model)
    );
    Ok(Plan {
        model: Box::new(model),
        reason,
    })
}
