//! NumPy arrays: `.npy` volumes and the `.npz` of patterns.
//!
//! Volumes are f32 `[z, y, x]`, patterns f32 `[angle, row, column]`, C order, little endian. `patterns.npz` holds, for
//! one light, `patterns` (what the projector shows, dequantized) and `patterns_raw` (before quantization); for several
//! lights `patterns_<light>` and `patterns_raw_<light>`. The arrays are stored, not compressed.
//!
//! That is what is written. Read are floats of 2, 4 and 8 bytes, whole numbers and bool, little and big endian, in C and
//! Fortran order, stored or compressed. Patterns of other programs may be the only array of an `.npz`, under any name.
//!
//! ```
//! use tomolith_core::dose::Work;
//! use tomolith_core::grid::{PatternGrid, Patterns};
//! use tomolith_io::npy::{PatternPair, read_patterns, write_patterns};
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("patterns.npz");
//! let shown = Patterns::dark(PatternGrid::full_turn(3, 0.0, 2, 4, 0.1));
//! write_patterns(&path, &[PatternPair { light: None, shown: &shown, raw: Some(&shown) }], &Work::new()).unwrap();
//! let read = read_patterns(&path).unwrap();
//! assert_eq!((read[0].shape, read[0].light.as_deref()), ([3, 2, 4], None));
//! ```

pub use super::npz::Element;
use super::npz::{ArchiveWriter, write_array};
use super::numbers::{Archive, Header, Numbers, ends_in, is_archive};
use super::whole::write_whole_under;
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Patterns, Volume};
use tomolith_core::work::Work;

/// The patterns of one light, to be written.
#[derive(Clone, Copy, Debug)]
pub struct PatternPair<'a> {
    /// Name of the light, when there are several.
    pub light: Option<&'a str>,
    /// What the projector shows: quantized, as pattern values.
    pub shown: &'a Patterns,
    /// Before quantization.
    pub raw: Option<&'a Patterns>,
}

/// The patterns of one light, read back.
#[derive(Clone, Debug, PartialEq)]
pub struct PatternArrays {
    /// Name of the light, when there are several.
    pub light: Option<String>,
    /// `[frames, rows, columns]`.
    pub shape: [usize; 3],
    /// What the projector shows.
    pub shown: Vec<f32>,
    /// Before quantization, when the file holds it.
    pub raw: Option<Vec<f32>>,
}

fn must_fit(path: &Path, shape: [usize; 3], values: usize) -> Result<()> {
    if shape.iter().product::<usize>() == values {
        return Ok(());
    }
    let what = path.display().to_string();
    Err(Error::shape(what, shape, vec![values]))
}

/// Writes a volume as `.npy`, `[z, y, x]`.
///
/// # Errors
/// [`Error::Io`], or [`Error::Shape`] when values and grid do not fit.
pub fn write_volume<T: Element>(path: &Path, volume: &Volume<T>, work: &Work) -> Result<()> {
    let (shape, values) = (volume.grid.shape, &volume.values[..]);
    must_fit(path, shape, values.len())?;
    write_whole_under(path, work, size_of_val(values), |file| {
        Ok(write_array(file, &shape, values)?)
    })
}

/// Reads an `.npy` volume `[z, y, x]`: its shape and values as f32.
///
/// # Errors
/// [`Error::Io`] when it cannot be opened, [`Error::Format`] when it is no 3D array of numbers.
pub fn read_volume(path: &Path) -> Result<([usize; 3], Vec<f32>)> {
    read_dimensions(path, "a 3D .npy array [z, y, x] of numbers")
}

/// Reads a sinogram of VAMToolbox, an `.npy` array `[u, angle, z]`: its shape and values as f32.
///
/// # Errors
/// [`Error::Io`] when it cannot be opened, [`Error::Format`] when it is no such array, or has no values.
pub fn read_sinogram(path: &Path) -> Result<([usize; 3], Vec<f32>)> {
    let accepted = "a 3D .npy array [u, angle, z] of numbers";
    let (shape, values) = read_dimensions(path, accepted)?;
    if values.is_empty() {
        return Err(Error::format(
            path,
            format!("no values: shape {shape:?}"),
            accepted,
        ));
    }
    Ok((shape, values))
}

/// Reads a 2D `.npy` array `[row, column]`: its shape and values as f32.
///
/// # Errors
/// [`Error::Io`] when it cannot be opened, [`Error::Format`] when it is no such array.
pub fn read_matrix(path: &Path) -> Result<([usize; 2], Vec<f32>)> {
    read_dimensions(path, "a 2D .npy array [row, column] of numbers")
}

fn read_dimensions<const N: usize>(path: &Path, accepted: &str) -> Result<([usize; N], Vec<f32>)> {
    let numbers = Numbers::read(path, accepted)?;
    numbers
        .of_dimensions()
        .map_err(|found| Error::format(path, found, accepted))
}

/// Reads a 2D or 3D `.npy` array: its shape `[level, row, column]`, one level for 2D, and values as f32.
///
/// # Errors
/// [`Error::Io`] when it cannot be opened, [`Error::Format`] when it is no such array.
pub fn read_levels(path: &Path) -> Result<([usize; 3], Vec<f32>)> {
    let accepted = "a 2D or 3D .npy array of numbers";
    let volume = Numbers::read(path, accepted)?.into_volume();
    volume.map_err(|found| Error::format(path, found, accepted))
}

/// Refuses a file that was cut off: an `.npy` of another length than its header says, an `.npz` without its end.
///
/// # Errors
/// [`Error::Io`] when it cannot be opened, [`Error::Format`] when it is not whole.
pub fn must_be_whole(path: &Path) -> Result<()> {
    let accepted = "a whole .npy or .npz file";
    match is_archive(path) {
        true => Archive::open(path, accepted).map(drop),
        false => Header::read_file(path, accepted).map(drop),
    }
}

fn array_name(kind: &str, light: Option<&str>) -> String {
    light.map_or_else(|| kind.to_owned(), |light| format!("{kind}_{light}"))
}

/// Writes `patterns.npz`; see the [module page](self).
///
/// # Errors
/// [`Error::Io`] or [`Error::Shape`].
pub fn write_patterns(path: &Path, lights: &[PatternPair<'_>], work: &Work) -> Result<()> {
    let arrays = lights.iter().flat_map(|pair| [Some(pair.shown), pair.raw]);
    let bytes = arrays.flatten().map(|p| size_of_val(&p.values[..])).sum();
    write_whole_under(path, work, bytes, |file| {
        let mut npz = ArchiveWriter::new(file);
        for pair in lights {
            for (kind, patterns) in [("patterns", Some(pair.shown)), ("patterns_raw", pair.raw)] {
                let Some(patterns) = patterns else { continue };
                let shape = patterns.grid.shape();
                must_fit(path, shape, patterns.values.len())?;
                npz.add(&array_name(kind, pair.light), &shape, &patterns.values)?;
            }
        }
        Ok(npz.finish()?)
    })
}

/// What [`read_patterns`] reads, for error messages.
const PATTERNS: &str = "an .npz with a 3D array `patterns` [angle, row, column] of numbers, or one `patterns_<light>` per light; or an .npy, or .npz with one array, of one light";

/// Reads `patterns.npz`: one entry per light, in the order of their names; or the one array of an `.npy`. Numbers of any
/// type are taken as they are, in mJ/mm².
///
/// # Errors
/// [`Error::Io`] when it cannot be opened; [`Error::Format`] when it is no such file, holds no patterns, or holds
/// values that are negative or not finite.
pub fn read_patterns(path: &Path) -> Result<Vec<PatternArrays>> {
    if ends_in(path, "npy") {
        let (shape, shown) = values_of(Numbers::read(path, PATTERNS)?, path, "the array")?;
        return Ok(vec![PatternArrays {
            light: None,
            shape,
            shown,
            raw: None,
        }]);
    }
    let mut npz = Archive::open(path, PATTERNS)?;
    let names = npz.names();
    let mut lights = Vec::new();
    for name in &names {
        let light = match name.strip_prefix("patterns") {
            _ if names.len() == 1 && !name.starts_with("patterns_") => None,
            Some("") => None,
            // A light named `raw` would be mistaken for the values before quantization
            Some(rest) if rest != "_raw" && !rest.starts_with("_raw_") => rest.strip_prefix('_'),
            _ => continue,
        };
        let (shape, shown) = values_of(npz.numbers(name)?, path, name)?;
        let raw_name = array_name("patterns_raw", light);
        let mut raw = None;
        if names.contains(&raw_name) {
            let (raw_shape, values) = values_of(npz.numbers(&raw_name)?, path, &raw_name)?;
            if raw_shape != shape {
                let what = format!("{}: {raw_name}", path.display());
                return Err(Error::shape(what, shape, raw_shape));
            }
            raw = Some(values);
        }
        lights.push(PatternArrays {
            light: light.map(str::to_owned),
            shape,
            shown,
            raw,
        });
    }
    if lights.is_empty() {
        let found = match names.is_empty() {
            true => "no arrays".to_owned(),
            false => format!("the arrays {}", names.join(", ")),
        };
        return Err(Error::format(path, found, PATTERNS));
    }
    Ok(lights)
}

/// Where the element with this number lies in a C-ordered array, `[2, 0, 7]`.
///
/// ```
/// assert_eq!(tomolith_io::npy::place_of(23, &[2, 3, 4]), "[1, 2, 3]");
/// ```
#[must_use]
pub fn place_of(element: usize, shape: &[usize]) -> String {
    let mut rest = element;
    let mut place: Vec<String> = shape
        .iter()
        .rev()
        .map(|&length| {
            let at = rest % length.max(1);
            rest /= length.max(1);
            at.to_string()
        })
        .collect();
    place.reverse();
    format!("[{}]", place.join(", "))
}

/// The values of patterns, which must be finite and 0 or above.
fn values_of(numbers: Numbers, path: &Path, name: &str) -> Result<([usize; 3], Vec<f32>)> {
    let (shape, values) = numbers
        .of_dimensions()
        .map_err(|found| Error::format(path, format!("{name}: {found}"), PATTERNS))?;
    if let Some(i) = values.iter().position(|v| !(v.is_finite() && *v >= 0.0)) {
        let at = place_of(i, &shape);
        let found = format!(
            "{name} holds {} at {at}, as [angle, row, column]",
            values[i]
        );
        return Err(Error::format(path, found, "finite values ≥ 0"));
    }
    Ok((shape, values))
}

#[cfg(test)]
mod tests {
    use super::*;
    use ndarray::{Array3, ShapeBuilder};
    use ndarray_npy::NpzWriter;
    use std::fs::File;
    use tomolith_core::check::noise;
    use tomolith_core::grid::{PatternGrid, VolumeGrid};

    fn random_patterns(seed: u64, frames: usize) -> Patterns {
        let mut patterns = Patterns::dark(PatternGrid::full_turn(frames, 0.0, 4, 5, 0.1));
        let light = noise(seed, patterns.values.len()).into_iter();
        patterns.values = light.map(f32::abs).collect();
        patterns
    }

    fn pair<'a>(
        light: Option<&'a str>,
        shown: &'a Patterns,
        raw: Option<&'a Patterns>,
    ) -> PatternPair<'a> {
        PatternPair { light, shown, raw }
    }

    /// An archive of one array.
    fn write_npz<S, D>(path: &Path, name: &str, array: &ndarray::ArrayBase<S, D>)
    where
        S: ndarray::Data<Elem: ndarray_npy::WritableElement>,
        D: ndarray::Dimension,
    {
        let mut npz = NpzWriter::new(File::create(path).unwrap());
        npz.add_array(name, array).unwrap();
        npz.finish().unwrap();
    }

    #[test]
    fn a_volume_comes_back_bit_for_bit_in_c_order() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("dose.npy");
        let grid = VolumeGrid::centered([2, 3, 4], 0.1);
        let values: Vec<f32> = (0..24).map(|i| (i as f32).sqrt()).collect();
        let volume = Volume { grid, values };
        write_volume(&path, &volume, &Work::new()).unwrap();
        let read = read_volume(&path).unwrap();
        assert_eq!(read, (volume.grid.shape, volume.values));
        let bytes = std::fs::read(&path).unwrap();
        assert_eq!(&bytes[..6], b"\x93NUMPY");
        let header = String::from_utf8_lossy(&bytes[..128]);
        tomolith_core::contains!(header, "'<f4'", "'fortran_order': False");
        assert!(header.contains("(2, 3, 4)"), "{header}");
        // Element [1, 2, 3] is the last one in the file
        assert_eq!(bytes[bytes.len() - 4..], 23f32.sqrt().to_le_bytes());
    }

    #[test]
    fn patterns_of_one_and_of_several_lights_come_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("patterns.npz");
        let [a, b, c] =
            [(1, 3), (2, 3), (3, 2)].map(|(seed, frames)| random_patterns(seed, frames));
        let come_back = |pairs: &[PatternPair]| {
            write_patterns(&path, pairs, &Work::new()).unwrap();
            read_patterns(&path).unwrap()
        };
        let read = come_back(&[pair(None, &a, Some(&b))]);
        assert_eq!((read.len(), &read[0].light), (1, &None));
        assert_eq!(
            (&read[0].shown, &read[0].raw),
            (&a.values, &Some(b.values.clone()))
        );
        let read = come_back(&[pair(Some("blue"), &a, Some(&b)), pair(Some("uv"), &c, None)]);
        let lights: Vec<_> = read.iter().map(|l| l.light.as_deref()).collect();
        assert_eq!(lights, [Some("blue"), Some("uv")]);
        assert_eq!(read[1].shape, [2, 4, 5]);
        assert_eq!((&read[1].shown, read[1].raw.as_ref()), (&c.values, None));
    }

    #[test]
    fn patterns_of_other_programs_may_be_f64_in_either_order() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.npz");
        let write = |array: &Array3<f64>| write_npz(&path, "patterns", array);
        let value = |(i, j, k)| (i * 12 + j * 4 + k) as f64 / 3.0;
        write(&Array3::from_shape_fn((2, 3, 4), value));
        let read = read_patterns(&path).unwrap();
        let expected: Vec<f32> = (0..24).map(|i| (f64::from(i) / 3.0) as f32).collect();
        assert_eq!((read[0].shape, &read[0].shown), ([2, 3, 4], &expected));
        write(&Array3::from_shape_fn((2, 3, 4).f(), value));
        assert_eq!(read_patterns(&path).unwrap()[0].shown, expected);
        // Beyond f32 there is no value to be shown
        for (value, message) in [
            (1e300, "patterns: the number farthest from 0 is 1e300"),
            (f64::INFINITY, "patterns holds inf"),
        ] {
            write(&Array3::from_elem((1, 1, 1), value));
            let text = read_patterns(&path).unwrap_err().to_string();
            assert!(text.contains(message), "{text}");
        }
        write_npz(&path, "patterns", &ndarray::Array2::<i32>::zeros((1, 1)));
        let text = read_patterns(&path).unwrap_err().to_string();
        tomolith_core::contains!(
            text,
            "patterns: an array of 2 dimensions, shape (1, 1), instead of 3"
        );
    }

    #[test]
    fn the_only_array_of_an_archive_is_the_patterns() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.npz");
        let value = |(i, j, k, _)| (i * 12 + j * 4 + k) as f64;
        write_npz(
            &path,
            "arr_0",
            &ndarray::Array4::from_shape_fn((2, 3, 4, 1), value),
        );
        let read = read_patterns(&path).unwrap();
        let [
            PatternArrays {
                light,
                shape,
                shown,
                ..
            },
        ] = &read[..]
        else {
            panic!("{read:?}");
        };
        assert_eq!((light, shape, shown[23]), (&None, &[2, 3, 4], 23.0));
    }

    #[test]
    fn a_file_that_was_cut_off_is_not_whole() {
        let folder = tempfile::tempdir().unwrap();
        let [volume, patterns] = ["dose.npy", "patterns.npz"].map(|name| folder.path().join(name));
        ndarray_npy::write_npy(&volume, &Array3::<f32>::zeros((2, 3, 4))).unwrap();
        let values = random_patterns(1, 3);
        let pairs = [pair(None, &values, None)];
        write_patterns(&patterns, &pairs, &Work::new()).unwrap();
        for path in [volume, patterns] {
            must_be_whole(&path).unwrap();
            let file = File::options().write(true).open(&path).unwrap();
            file.set_len(file.metadata().unwrap().len() - 1).unwrap();
            let text = must_be_whole(&path).unwrap_err().to_string();
            assert!(text.contains("truncated"), "{text}");
        }
    }

    #[test]
    fn what_holds_no_patterns_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.npz");
        assert!(matches!(read_patterns(&path), Err(Error::Io { .. })));
        std::fs::write(&path, b"no zip").unwrap();
        assert!(matches!(read_patterns(&path), Err(Error::Format { .. })));
        let mut npz = NpzWriter::new(File::create(&path).unwrap());
        let one = Array3::<f32>::zeros((1, 1, 1));
        npz.add_array("dose", &one).unwrap();
        npz.add_array("mask", &one).unwrap();
        npz.finish().unwrap();
        let text = read_patterns(&path).unwrap_err().to_string();
        assert!(text.contains("the arrays dose, mask"), "{text}");
        let mut values = Array3::<f32>::zeros((1, 2, 2));
        values[[0, 1, 0]] = f32::NAN;
        write_npz(&path, "patterns", &values);
        let text = read_patterns(&path).unwrap_err().to_string();
        let message = "patterns holds NaN at [0, 1, 0], as [angle, row, column]";
        assert!(text.contains(message), "{text}");
    }
}
