//! Volumes of other programs: `.npy`, `.nrrd`, the pages of a TIFF, or one array of an `.npz`, of any number type, as f32 `[z, y, x]`.
//!
//! Read are floats of 16, 32 and 64 bits, whole numbers of 8 to 64 bits with and without sign, and bool (true is 1), little or
//! big endian, in C or Fortran order; an array of two dimensions is one slice. Pages of a TIFF are slices from the bottom, their top row +y. An `.npz` with several arrays needs the name of one: `results.npz:dose`.
//!
//! ```
//! use tomolith_io::array::read_any;
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("target.npy");
//! ndarray_npy::write_npy(&path, &ndarray::array![[true, false, true], [false, true, false]]).unwrap();
//! let (shape, values) = read_any(path.to_str().unwrap()).unwrap();
//! assert_eq!((shape, values), ([1, 2, 3], vec![1.0, 0.0, 1.0, 0.0, 1.0, 0.0]));
//! ```

use super::numbers::Numbers;
use super::slices::{is_tiff, read_volume};
use std::path::Path;
use tomolith_core::error::{Error, Result};

const ACCEPTED: &str = ".npy, .nrrd, .tif or .npz of floats, whole numbers or bool in two dimensions [y, x] or three [z, y, x]";

/// Reads `FILE.npy`, `FILE.nrrd`, `FILE.tif`, `FILE.npz` with one array, or `FILE.npz:NAME`: shape `[z, y, x]` and values, x fastest.
///
/// # Errors
/// [`Error::Io`] when the file cannot be opened; [`Error::Format`] when it holds no
/// such array.
pub fn read_any(source: &str) -> Result<([usize; 3], Vec<f32>)> {
    let path = Path::new(source);
    if is_tiff(path) {
        return read_volume(path);
    }
    let volume = Numbers::read(path, ACCEPTED)?.into_volume();
    volume.map_err(|found| Error::format(path, found, ACCEPTED))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::{Array1, Array3, ShapeBuilder};
    use ndarray_npy::{NpzWriter, write_npy};
    use std::fs::File;

    #[test]
    fn types_orders_and_names_are_understood() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| folder.path().join(name).display().to_string();
        let fortran = Array3::from_shape_fn((2, 3, 4).f(), |(z, y, x)| (z * 12 + y * 4 + x) as i64);
        write_npy(place("a.npy"), &fortran).unwrap();
        let expected: Vec<f32> = (0..24).map(|i| i as f32).collect();
        let found = read_any(&place("a.npy")).unwrap();
        assert_eq!(found, ([2, 3, 4], expected.clone()));
        write_npy(
            place("flat.npy"),
            &ndarray::array![[true, false], [false, true]],
        )
        .unwrap();
        let found = read_any(&place("flat.npy")).unwrap();
        assert_eq!(found, ([1, 2, 2], vec![1.0, 0.0, 0.0, 1.0]));
        let mut npz = NpzWriter::new_compressed(File::create(place("b.npz")).unwrap());
        npz.add_array("dose", &fortran.mapv(|v| v as f64)).unwrap();
        npz.add_array("mask", &fortran.mapv(|v| v > 3)).unwrap();
        npz.finish().unwrap();
        assert_eq!(read_any(&place("b.npz:dose")).unwrap().1, expected);
        assert_eq!(read_any(&place("b.npz:mask")).unwrap().1[3..5], [0.0, 1.0]);
        let message = read_any(&place("b.npz")).unwrap_err().to_string();
        tomolith_core::contains!(message, "no array is named; it holds dose, mask");
        let message = read_any(&place("b.npz:does")).unwrap_err().to_string();
        tomolith_core::contains!(message, "no array `does`", "b.npz:dose");
    }

    #[test]
    fn formats_of_other_programs_are_the_numbers_that_were_written() {
        use crate::volume::{Values, write_values};
        use tomolith_core::grid::VolumeGrid;
        use tomolith_core::work::Work;
        let folder = tempfile::tempdir().unwrap();
        let grid = VolumeGrid::centered([2, 3, 4], 0.1);
        let dose: Vec<f32> = (0..24).map(|i| i as f32 - 3.5).collect();
        let labels: Vec<u8> = (0..24).map(|i| i % 3).collect();
        let expected: Vec<f32> = labels.iter().map(|&label| f32::from(label)).collect();
        for ending in ["npy", "nrrd", "tif"] {
            let read = |values| {
                let path = folder.path().join(format!("a.{ending}"));
                write_values(&path, "a", &grid, values, &Work::new()).unwrap();
                read_any(path.to_str().unwrap()).unwrap()
            };
            assert_eq!(read(Values::F32(&dose)), ([2, 3, 4], dose.clone()));
            assert_eq!(read(Values::U8(&labels)), ([2, 3, 4], expected.clone()));
        }
    }

    #[test]
    fn what_is_no_volume_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| folder.path().join(name).display().to_string();
        write_npy(place("line.npy"), &Array1::<f32>::zeros(4)).unwrap();
        std::fs::write(place("text.npy"), "no array").unwrap();
        let refused = |name: &str| read_any(&place(name)).unwrap_err();
        tomolith_core::contains!(refused("line.npy").to_string(), "shape (4,)");
        assert!(matches!(refused("text.npy"), Error::Format { .. }));
        assert!(matches!(refused("none.npy"), Error::Io { .. }));
    }
}
