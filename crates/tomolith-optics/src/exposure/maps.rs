//! Maps of a device: one number per pixel from an image or an array.

use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_io::image::read_gray;
use tomolith_io::npy::read_matrix;

/// `[rows, columns]` and values of a `.npy` array of two dimensions, or of a gray image.
pub(crate) fn read_plane(path: &Path) -> Result<([usize; 2], Vec<f32>)> {
    let extension = path.extension();
    if extension.is_some_and(|e| e.eq_ignore_ascii_case("npy")) {
        return read_matrix(path);
    }
    let image = read_gray(path)?;
    Ok(([image.rows, image.columns], image.values))
}

/// A map of this size `[columns, rows]`, row 0 on top: finite numbers, 0 or more; `as_what` has that size.
///
/// # Errors
/// [`Error`] with the file and what is wrong with it.
pub fn read_map(path: &Path, size: [usize; 2], as_what: &str) -> Result<Vec<f32>> {
    let ([rows, columns], values) = read_plane(path)?;
    let bad = |found: String| {
        Error::format(
            path,
            found,
            format!(
                "a map of {} × {} numbers, 0 or more, as the {as_what}",
                size[0], size[1]
            ),
        )
    };
    if [columns, rows] != size {
        return Err(bad(format!("{columns} × {rows} pixels")));
    }
    match values.iter().position(|v| !(v.is_finite() && *v >= 0.0)) {
        Some(i) => Err(bad(format!(
            "{} in row {}, column {}",
            values[i],
            i / columns,
            i % columns
        ))),
        None => Ok(values),
    }
}
