//! Volumes for other programs: one array a file, in the format that the ending of its name says.
//!
//! | ending | format | opened by |
//! |---|---|---|
//! | `.npy` | NumPy `[z, y, x]`; lengths are not in it | Python, Julia, MATLAB |
//! | `.vti` | VTK image data ([`vti`]) | ParaView, VisIt |
//! | `.nrrd` | NRRD | 3D Slicer, ITK |
//! | `.tif`, `.tiff` | pages of a TIFF | ImageJ, Fiji |
//! | `.zarr` | OME-Zarr 0.5, a folder | napari, neuroglancer |
//!
//! ```
//! use tomolith_core::dose::Work;
//! use tomolith_core::grid::VolumeGrid;
//! use tomolith_io::volume::{Values, write_values};
//! let folder = tempfile::tempdir().unwrap();
//! let grid = VolumeGrid::centered([1, 2, 3], 0.5);
//! for file in ["dose.npy", "dose.vti", "dose.nrrd", "dose.tif", "dose.ome.zarr"] {
//!     let path = folder.path().join(file);
//!     write_values(&path, "dose", &grid, Values::F32(&[0.0; 6]), &Work::new()).unwrap();
//!     assert!(path.exists());
//! }
//! ```

use super::npz::write_array;
use super::whole::write_whole_under;
use super::{nrrd, ome_zarr, tiff_pages, vti};
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::work::Work;

/// Endings of the names of volumes, for messages.
pub const ENDINGS: &str = ".npy, .vti, .nrrd, .tif or .ome.zarr";

/// Values of one array, `[z, y, x]`, x fastest.
#[derive(Clone, Copy, Debug)]
pub enum Values<'a> {
    /// Doses and fractions.
    F32(&'a [f32]),
    /// Labels.
    U8(&'a [u8]),
}

impl Values<'_> {
    fn len(&self) -> usize {
        match self {
            Values::F32(v) => v.len(),
            Values::U8(v) => v.len(),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        match self {
            Values::F32(v) => size_of_val(*v),
            Values::U8(v) => v.len(),
        }
    }

    /// The numbers, little endian.
    pub(super) fn write(&self, file: &mut impl std::io::Write) -> std::io::Result<()> {
        match self {
            Values::U8(values) => file.write_all(values),
            Values::F32(values) if cfg!(target_endian = "little") => {
                file.write_all(bytemuck::cast_slice(values))
            }
            Values::F32(values) => values
                .iter()
                .try_for_each(|v| file.write_all(&v.to_le_bytes())),
        }
    }

    /// Refuses values that are not as many as the grid has voxels.
    pub(super) fn must_fit(&self, grid: &VolumeGrid, name: &str, path: &Path) -> Result<()> {
        if self.len() == grid.len() {
            return Ok(());
        }
        let what = format!("{name} for {}", path.display());
        Err(Error::shape(what, grid.shape, vec![self.len()]))
    }
}

/// A format of volumes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VolumeFileFormat {
    /// NumPy.
    Npy,
    /// VTK image data.
    Vti,
    /// NRRD.
    Nrrd,
    /// TIFF of several pages.
    Tiff,
    /// OME-Zarr.
    OmeZarr,
}

impl VolumeFileFormat {
    /// The format of a name; None for endings that no format has.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match &ending[..] {
            "npy" => Some(VolumeFileFormat::Npy),
            "vti" => Some(VolumeFileFormat::Vti),
            "nrrd" => Some(VolumeFileFormat::Nrrd),
            "tif" | "tiff" => Some(VolumeFileFormat::Tiff),
            "zarr" => Some(VolumeFileFormat::OmeZarr),
            _ => None,
        }
    }
}

/// Writes an array on a grid; the ending of the path chooses the format.
///
/// # Errors
/// [`Error::Format`] for another ending, [`Error::Shape`] when values and grid do not fit, [`Error::Io`], [`Error::Canceled`].
pub fn write_values(
    path: &Path,
    name: &str,
    grid: &VolumeGrid,
    values: Values<'_>,
    work: &Work,
) -> Result<()> {
    values.must_fit(grid, name, path)?;
    let another = || Error::format(path, "another ending", ENDINGS);
    match VolumeFileFormat::of(path).ok_or_else(another)? {
        VolumeFileFormat::Npy => write_whole_under(path, work, values.bytes(), |file| {
            Ok(match values {
                Values::F32(values) => write_array(file, &grid.shape, values),
                Values::U8(values) => write_array(file, &grid.shape, values),
            }?)
        }),
        VolumeFileFormat::Vti => vti::write_vti(path, grid, &[(name, values)], work),
        VolumeFileFormat::Nrrd => nrrd::write(path, name, grid, values, work),
        VolumeFileFormat::Tiff => tiff_pages::write(path, grid, values, work),
        VolumeFileFormat::OmeZarr => ome_zarr::write(path, name, grid, values, work),
    }
}

/// A length in mm without the last digits that arithmetic leaves: twelve are a picometer of a meter.
pub(super) fn tidy(mm: f64) -> f64 {
    format!("{mm:.11e}").parse().unwrap_or(mm) + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_no_digits_of_arithmetic() {
        let tidied = [-1.7249999999999999, -0.0, 0.1 + 0.2].map(|mm| format!("{}", tidy(mm)));
        assert_eq!(tidied, ["-1.725", "0", "0.3"]);
    }

    #[test]
    fn an_array_of_another_size_or_a_name_of_another_ending_is_refused() {
        let (folder, work) = (tempfile::tempdir().unwrap(), Work::new());
        let grid = VolumeGrid::centered([2, 2, 2], 1.0);
        let write =
            |file, values| write_values(&folder.path().join(file), "dose", &grid, values, &work);
        for file in ["a.npy", "a.vti", "a.nrrd", "a.tif", "a.ome.zarr"] {
            let error = write(file, Values::F32(&[0.0])).unwrap_err();
            assert!(matches!(error, Error::Shape { .. }), "{file}: {error}");
            write(file, Values::F32(&[0.0; 8])).unwrap();
            assert!(folder.path().join(file).exists());
        }
        let error = write("a.mha", Values::U8(&[0; 8])).unwrap_err().to_string();
        tomolith_core::contains!(error, "a.mha: another ending; accepted: .npy");
    }
}
