//! Anybody's volumes: `.npy`, or one array of an `.npz`, of whatever number type, as f32 `[z, y, x]`.
//!
//! Read are f32, f64, whole numbers of 8 to 64 bits with and without sign, and bool (true is 1), in C or Fortran order; an
//! array of two dimensions is one slice. An `.npz` with several arrays needs the name of one: `results.npz:dose`.
//!
//! ```
//! use tomolith::io::array::read_any;
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("target.npy");
//! ndarray_npy::write_npy(&path, &ndarray::array![[true, false, true], [false, true, false]]).unwrap();
//! let (shape, values) = read_any(path.to_str().unwrap()).unwrap();
//! assert_eq!((shape, values), ([1, 2, 3], vec![1.0, 0.0, 1.0, 0.0, 1.0, 0.0]));
//! ```

use crate::error::{Error, Result, nearest_name};
use ndarray::ArrayD;
use ndarray_npy::{NpzReader, ReadNpyExt, ReadableElement};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

const ACCEPTED: &str =
    ".npy or .npz of f32, f64, whole numbers or bool in two dimensions [y, x] or three [z, y, x]";

fn bad(path: &Path, found: impl Into<String>) -> Error {
    Error::Format {
        path: path.to_owned(),
        found: found.into(),
        accepted: ACCEPTED.to_owned(),
    }
}

/// Reads `FILE.npy`, `FILE.npz` with one array, or `FILE.npz:NAME`: shape `[z, y, x]` and values, x fastest.
///
/// # Errors
/// [`Error::Io`] when the file cannot be opened; [`Error::Format`] when it holds no such array.
pub fn read_any(source: &str) -> Result<([usize; 3], Vec<f32>)> {
    let (path, name) = match source.rsplit_once(".npz:") {
        Some((stem, name)) => (format!("{stem}.npz"), Some(name)),
        None => (source.to_owned(), None),
    };
    let path = Path::new(&path);
    let source = Source::new(path, name)?;
    let array = source.read_as_any()?;
    let shape = match *array.shape() {
        [y, x] => [1, y, x],
        [z, y, x] => [z, y, x],
        _ => return Err(bad(path, format!("an array of shape {:?}", array.shape()))),
    };
    // Logical order, whatever the order in the file
    Ok((shape, array.iter().copied().collect()))
}

/// The array of an archive that is meant.
fn chosen(npz: &mut NpzReader<BufReader<File>>, path: &Path, name: Option<&str>) -> Result<String> {
    let names = npz.names().map_err(|e| bad(path, e.to_string()))?;
    let names: Vec<&str> = names
        .iter()
        .map(|name| name.trim_end_matches(".npy"))
        .collect();
    match (name, names.as_slice()) {
        (None, [only]) => Ok((*only).to_owned()),
        (Some(name), _) if names.contains(&name) => Ok(name.to_owned()),
        (asked, _) => {
            let asked = asked.map_or("no array is named".to_owned(), |name| {
                format!("no array `{name}`")
            });
            let near = name.and_then(|name| nearest_name(name, names.iter().copied()));
            Err(Error::Format {
                path: path.to_owned(),
                found: format!("{asked}; it holds {}", names.join(", ")),
                accepted: format!(
                    "FILE.npz:NAME, for example {}:{}",
                    path.display(),
                    near.or(names.first().copied()).unwrap_or("dose")
                ),
            })
        }
    }
}

/// An array in a file.
struct Source<'a> {
    path: &'a Path,
    /// Its name in an archive.
    name: Option<String>,
}

/// Reads an array whose elements have one type.
type Read = fn(&Source<'_>) -> Result<ArrayD<f32>, String>;

/// Every number type, the usual ones first.
const TYPES: [Read; 11] = [
    |s| s.read(|v: f32| v),
    |s| s.read(|v: f64| v as f32),
    |s| s.read(|v: u8| f32::from(v)),
    |s| s.read(|v: bool| f32::from(u8::from(v))),
    |s| s.read(|v: i8| f32::from(v)),
    |s| s.read(|v: u16| f32::from(v)),
    |s| s.read(|v: i16| f32::from(v)),
    |s| s.read(|v: u32| v as f32),
    |s| s.read(|v: i32| v as f32),
    |s| s.read(|v: u64| v as f32),
    |s| s.read(|v: i64| v as f32),
];

impl<'a> Source<'a> {
    fn new(path: &'a Path, name: Option<&str>) -> Result<Self> {
        let file = File::open(path).map_err(|e| Error::io(path, e))?;
        let is_npz = path
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("npz"));
        let name = if is_npz {
            let mut npz =
                NpzReader::new(BufReader::new(file)).map_err(|e| bad(path, e.to_string()))?;
            Some(chosen(&mut npz, path, name)?)
        } else {
            None
        };
        Ok(Source { path, name })
    }

    fn read<T: ReadableElement + Clone>(&self, to: fn(T) -> f32) -> Result<ArrayD<f32>, String> {
        let file = BufReader::new(File::open(self.path).map_err(|e| e.to_string())?);
        let array: ArrayD<T> = match &self.name {
            None => ArrayD::read_npy(file).map_err(|e| e.to_string())?,
            Some(name) => {
                let mut npz = NpzReader::new(file).map_err(|e| e.to_string())?;
                npz.by_name(name).map_err(|e| e.to_string())?
            }
        };
        Ok(array.mapv(to))
    }

    fn read_as_any(&self) -> Result<ArrayD<f32>> {
        let mut why = String::new();
        for read in TYPES {
            match read(self) {
                Ok(array) => return Ok(array),
                Err(error) => why = error,
            }
        }
        Err(bad(self.path, why))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::{Array1, Array3, ShapeBuilder};
    use ndarray_npy::{NpzWriter, write_npy};

    #[test]
    fn types_orders_and_names_are_understood() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| folder.path().join(name).display().to_string();
        let fortran = Array3::from_shape_fn((2, 3, 4).f(), |(z, y, x)| (z * 12 + y * 4 + x) as i64);
        write_npy(place("a.npy"), &fortran).unwrap();
        let expected: Vec<f32> = (0..24).map(|i| i as f32).collect();
        assert_eq!(
            read_any(&place("a.npy")).unwrap(),
            ([2, 3, 4], expected.clone())
        );
        let mut npz = NpzWriter::new_compressed(File::create(place("b.npz")).unwrap());
        npz.add_array("dose", &fortran.mapv(|v| v as f64)).unwrap();
        npz.add_array("mask", &fortran.mapv(|v| v > 3)).unwrap();
        npz.finish().unwrap();
        assert_eq!(read_any(&place("b.npz:dose")).unwrap().1, expected);
        assert_eq!(read_any(&place("b.npz:mask")).unwrap().1[3..5], [0.0, 1.0]);
        let message = read_any(&place("b.npz")).unwrap_err().to_string();
        assert!(
            message.contains("no array is named; it holds dose, mask"),
            "{message}"
        );
        let message = read_any(&place("b.npz:does")).unwrap_err().to_string();
        assert!(
            message.contains("no array `does`") && message.contains("b.npz:dose"),
            "{message}"
        );
    }

    #[test]
    fn what_is_no_volume_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| folder.path().join(name).display().to_string();
        write_npy(place("line.npy"), &Array1::<f32>::zeros(4)).unwrap();
        assert!(
            read_any(&place("line.npy"))
                .unwrap_err()
                .to_string()
                .contains("shape [4]")
        );
        std::fs::write(place("text.npy"), "no array").unwrap();
        assert!(matches!(
            read_any(&place("text.npy")),
            Err(Error::Format { .. })
        ));
        assert!(matches!(
            read_any(&place("none.npy")),
            Err(Error::Io { .. })
        ));
    }
}
