//! Which pixels can help: those whose light meets a voxel that is to be printed.
//!
//! The adjoint of an indicator is positive exactly for the pixels that bring light there, through whatever optics the
//! model has (Nicolet et al. 2024 call the straight case a Radon filter). All others are no unknowns and stay dark.

use super::layout::PixelRun;
use super::{DoseModel, Run};
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::Volume;

/// For each light the rows `(bottom, count)`, per (frame, column), whose light meets a voxel of `wanted` (file order
/// `[z, y, x]`, any value but 0): the run from the lowest to the highest such row. Of cut voxels the inside cells are wanted.
///
/// # Errors
/// [`Error::Cancelled`], [`Error::Shape`].
pub fn useful_rows(
    model: &dyn DoseModel<Field = HostField>,
    wanted: &Volume<u8>,
    run: &Run,
) -> Result<Vec<Vec<(u32, u32)>>> {
    let layout = &model.outputs()[0];
    if wanted.grid.shape != layout.grid.shape {
        return Err(Error::Shape {
            what: "wanted voxels".into(),
            expected: layout.grid.shape.to_vec(),
            found: wanted.grid.shape.to_vec(),
        });
    }
    let mut mask: Vec<f32> = layout
        .field_of(wanted)
        .iter()
        .map(|&w| f32::from(w != 0))
        .collect();
    if let Some(cells) = &layout.cells {
        cells.fill([0.0, 1.0], &mut mask);
    }
    let mut seen = model.new_patterns()?;
    let dark = seen.zeros_like();
    model.pullback(&dark, &HostField::from_slice(&mask), &mut seen, run)?;
    let useful = |run: &PixelRun| {
        let values = &seen.as_slice()[run.offset..][..run.count as usize];
        let first = values.iter().position(|&v| v > 0.0);
        let last = values.iter().rposition(|&v| v > 0.0);
        first
            .zip(last)
            .map_or((0, 0), |(a, b)| (run.bottom + a as u32, (b - a + 1) as u32))
    };
    Ok(model
        .patterns()
        .iter()
        .map(|p| p.runs.iter().map(useful).collect())
        .collect())
}
