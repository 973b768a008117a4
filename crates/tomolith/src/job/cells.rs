//! Jobs with surface-aware cells: which objective asks for them, and whether the rest of the job can have them.

use super::spec::JobSpec;
use crate::error::{Error, Result};
use crate::kind::Section;
use crate::models::Family;
use crate::models::rays::solid::Solid;
use crate::objective::OBJECTIVES;
use crate::objective::voxel_weights::Common;
use crate::optimize::OPTIMIZERS;
use crate::target::Shape;

/// What cells need, in arrays per voxel of an objective with fields: energies on either side, and bands of their own.
pub(super) const FIELDS: usize = 2;

/// The key that asks for cells, when there is one.
///
/// # Errors
/// [`Error::Config`] for an objective that is none.
pub(super) fn key(spec: &JobSpec) -> Result<Option<String>> {
    for section in spec.objectives()? {
        let (_, section) = Common::split(section)?;
        let (_, inner) = section.kind(OBJECTIVES)?;
        if inner.value.get("surface").is_some_and(|s| s == "cells") {
            return Ok(Some(format!("{}.surface", inner.path)));
        }
    }
    Ok(None)
}

/// Refuses cells of a target without a surface, and beside a model or a method that knows whole voxels only.
///
/// # Errors
/// [`Error::Config`] with the key that asks for cells.
pub(super) fn must_fit(spec: &JobSpec, shape: &dyn Shape, model: Option<&Family>) -> Result<()> {
    let Some(key) = key(spec)? else {
        return Ok(());
    };
    let (kind, optimizer) = Section::new("optimizer", spec.optimizer.clone()).kind(OPTIMIZERS)?;
    let method = (kind.build)(&optimizer)?;
    let whole_voxels = match model.filter(|model| !model.capabilities().has_cells) {
        Some(model) => Some(format!("[model.{}]", model.name())),
        None if method.requirements().target.is_some() => {
            Some(format!("[optimizer.{}]", kind.name))
        }
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
