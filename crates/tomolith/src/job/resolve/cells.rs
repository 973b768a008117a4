//! Jobs with surface-aware cells: which objective asks for them, and whether the rest of the job can have them.

use super::goal::Goal;
use super::method::Method;
use crate::error::{Error, Result};
use crate::models::Family;
use crate::models::rays::solid::Solid;
use crate::target::Shape;

/// What cells need, in arrays per voxel of an objective with fields: energies on either side, and bands for each cell.
pub(crate) const FIELDS: usize = 2;

/// Refuses cells of a target without a surface, and with a model or a method that knows whole voxels only.
pub(crate) fn must_fit(
    goal: &Goal,
    method: &Method,
    shape: &dyn Shape,
    model: Option<&Family>,
) -> Result<()> {
    let Some(key) = goal.cells_key() else {
        return Ok(());
    };
    let whole_voxels = match model.filter(|model| !model.capabilities().has_cells) {
        Some(model) => Some(format!("[model.{}]", model.name())),
        None if method.needs_target() => Some(format!("[optimizer.{}]", method.name())),
        None => None,
    };
    let (found, accepted) = if !Solid::has_surface(shape) {
        (
            "cells, but the target is an image: it has no surface".to_owned(),
            "\"voxel\" or \"fraction\"; a mesh or a phantom has a surface",
        )
    } else if let Some(other) = whole_voxels {
        (
            format!("cells, but {other} has whole voxels only"),
            "\"voxel\" or \"fraction\", or leave that table out",
        )
    } else {
        return Ok(());
    };
    Err(Error::config(key, found, accepted))
}
