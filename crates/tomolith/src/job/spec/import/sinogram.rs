//! Sinograms of VAMToolbox as patterns.
//!
//! Its arrays are `[u, angle, z]`, z upward, u along (−sin θ, cos θ) of the first two axes of its volume (its projectors on a processor; those on
//! a graphics card turn the part by 90°). Ours are `[angle, row, column]`, row 0 at the top: u is the column, and z turned over the row.

use crate::error::{Error, Result};
use crate::grid::{PatternGrid, Patterns};
use crate::io::npy::read_sinogram;
use std::path::Path;
use tomolith_core::parallel::table;

/// The patterns of a sinogram that was saved as `.npy`.
///
/// # Errors
/// [`Error::Io`](crate::Error::Io), [`Error::Format`](crate::Error::Format) for a file that is no array of three dimensions, or is empty, or holds a value below 0 or that is not finite.
pub fn sinogram(theirs: &Path) -> Result<Patterns> {
    let ([columns, frames, rows], values) = read_sinogram(theirs)?;
    if let Some(i) = values.iter().position(|v| !(v.is_finite() && *v >= 0.0)) {
        let place = [i / (frames * rows), i / rows % frames, i % rows];
        let found = format!("{} at {place:?}, as [u, angle, z]", values[i]);
        return Err(Error::format(theirs, found, "finite values ≥ 0"));
    }
    let grid = PatternGrid::full_turn(frames, 0.0, rows, columns, 1.0);
    let size = (rows * columns).max(1);
    let turned = table(values.len(), |i| {
        let (frame, row, column) = (i / size, i / columns % rows, i % columns);
        values[(column * frames + frame) * rows + rows - 1 - row]
    });
    Ok(Patterns {
        values: turned,
        ..Patterns::dark(grid)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Volume, VolumeGrid};
    use crate::io::npy::write_volume;
    use crate::models::Work;

    #[test]
    fn a_value_that_is_no_light_is_refused_where_it_stands() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("sinogram.npy");
        let values = vec![0.0, 0.5, 1.0, -0.25, 0.0, 0.0];
        let volume = Volume::new(VolumeGrid::centered([2, 1, 3], 1.0), values);
        write_volume(&file, &volume, &Work::new()).unwrap();
        let refused = sinogram(&file).unwrap_err().to_string();
        assert!(refused.contains("-0.25 at [1, 0, 0]"), "{refused}");
        for (shape, expected) in [
            (&[0, 18, 12][..], "no values: shape [0, 18, 12]"),
            (&[18, 12], "[u, angle, z]"),
        ] {
            let zeros = ndarray::ArrayD::<f32>::zeros(shape);
            ndarray_npy::write_npy(&file, &zeros).unwrap();
            let refused = sinogram(&file).unwrap_err().to_string();
            assert!(refused.contains(expected), "{refused}");
        }
    }

    #[test]
    fn a_value_of_a_sinogram_is_that_of_its_frame_row_and_column() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("sinogram.npy");
        // 5 places along u, 3 angles, 4 heights; every value says where it stands
        let volume = Volume {
            grid: VolumeGrid::centered([5, 3, 4], 1.0),
            values: (0..60u16)
                .map(|i| f32::from(i / 12 * 100 + i / 4 % 3 * 10 + i % 4))
                .collect(),
        };
        write_volume(&file, &volume, &Work::new()).unwrap();
        let patterns = sinogram(&file).unwrap();
        assert_eq!(
            [
                patterns.grid.frames(),
                patterns.grid.rows,
                patterns.grid.columns
            ],
            [3, 4, 5]
        );
        let at = |frame: usize, row: usize, column: usize| {
            patterns.values[(frame * 4 + row) * 5 + column]
        };
        // Row 0 is the highest z
        assert_eq!(at(2, 0, 4), 423.0);
        assert_eq!(at(0, 3, 1), 100.0);
        assert_eq!(at(1, 1, 3), 312.0);
    }
}
