//! Chooses the dose model of a job, and says why.
//!
//! Like the planner of a Fourier-transform library: the cheapest model that is exact for the optics at hand. Today that
//! is [`Parallel`], and what it does not cover is refused with the reason; a job may ask for a stored matrix instead.

use super::matrix::MatrixModel;
use super::parallel::{Light, Parallel};
use super::{Choice, DoseModel, Run};
use crate::error::Result;
use crate::field::HostField;
use crate::grid::{Volume, VolumeGrid};
use crate::io::csr::Csr;
use crate::optics::vial::Vial;

/// A dose model, and why it was chosen.
pub struct Plan {
    /// The model.
    pub model: Box<dyn DoseModel<Field = HostField>>,
    /// One sentence for people.
    pub reason: String,
}

/// The model that a job asks for: collimated lights through a z-invariant vial, or a matrix for their pixels.
///
/// With `wanted` (file order `[z, y, x]`, not 0 where something is to be printed), only pixels whose light meets such a
/// voxel become unknowns; the others stay dark.
///
/// # Errors
/// As [`Parallel::new`], [`Csr::read`] and [`MatrixModel::new`]; [`Error::Cancelled`](crate::Error::Cancelled).
pub fn plan(
    choice: &Choice,
    vial: &dyn Vial,
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
