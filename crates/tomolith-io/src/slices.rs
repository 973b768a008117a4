//! Gray slices: images, arrays and pages of a file that are read together.
//!
//! A stack is a folder of images or a pattern such as `slices/*.png`, in the order of the numbers in their names (see
//! [`series`](super::series)); a TIFF of several pages; or an array `[z, y, x]` (`.npy`, `.nrrd`, `.npz` with one array, or
//! `FILE.npz:NAME`), whose index 0 is the most negative coordinate. Numbers of an array are what they are in an image: bool 0
//! or 1, floats 0…1, 8 and 16 bits without sign up to their white.
//!
//! Where images or an array of several bits hold nothing but 0 and 1, they are a mask, whose 1 is white: so programs store
//! arrays of bools. A [note](Slices::note) says so.
//!
//! ```
//! use tomolith_io::slices::read_stack;
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("mask.npy");
//! ndarray_npy::write_npy(&path, &ndarray::array![[[0u8, 1], [0, 0]]]).unwrap();
//! let stack = read_stack(&path).unwrap();
//! // Row 0 of a slice is the top, +y: the last one of the array
//! assert_eq!(stack.slices[0].values, [0.0, 0.0, 0.0, 1.0]);
//! assert!(stack.note.unwrap().contains("read as a mask"));
//! ```

use super::image::{
    EXTENSIONS, GrayPixels, bad, check_values, damaged_tiff, open_tiff, read_stored, tiff_page,
};
use super::numbers::{Kind, Numbers, file_and_name, is_array};
use super::series::numbered_files;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};
use tomolith_core::files::read_regular;
use tomolith_core::units::exact;

/// Slices, the first one at the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Slices {
    /// All of one size.
    pub slices: Vec<GrayPixels>,
    /// What people should know of how they were read.
    pub note: Option<String>,
}

/// An image, and the number that is stored for white.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stored {
    pub(super) pixels: GrayPixels,
    white: f64,
}

impl Stored {
    pub(super) fn new(pixels: GrayPixels, white: f64) -> Self {
        Stored { pixels, white }
    }
}

impl Slices {
    /// Slices with their white, which is 1 in masks.
    pub(super) fn of(stored: Vec<Stored>) -> Self {
        let largest = |slice: &Stored| slice.pixels.values.iter().copied().fold(0.0, f32::max);
        // Number 1 as a share of white
        let one = |slice: &Stored| (1.0 / slice.white) as f32;
        let is_mask = stored.iter().any(|slice| largest(slice) > 0.0)
            && stored
                .iter()
                .all(|slice| slice.white > 1.0 && largest(slice) <= one(slice));
        let note = is_mask.then(|| {
            let white = exact(stored[0].white);
            format!("the largest value in it is 1 of {white}: it is read as a mask of 0 and 1")
        });
        let mut slices: Vec<GrayPixels> = stored.into_iter().map(|slice| slice.pixels).collect();
        if is_mask {
            let values = slices.iter_mut().flat_map(|slice| &mut slice.values);
            values.for_each(|v| *v = f32::from(u8::from(*v > 0.0)));
        }
        Slices { slices, note }
    }
}

/// Reads an image as the only slice.
///
/// # Errors
/// As [`read_gray`](super::image::read_gray).
pub fn read_image(path: &Path) -> Result<Slices> {
    Ok(Slices::of(vec![read_stored(path)?]))
}

/// Most pixels of a stack: what is larger does not fit into memory.
const MOST_PIXELS: u64 = 1 << 32;

/// Reads a stack; see the [module page](self).
///
/// # Errors
/// [`Error::Io`] when a folder or file cannot be read; [`Error::Format`] when there is no image, images differ in size, their
/// order is in doubt, or one cannot be used as in [`read_gray`](super::image::read_gray).
pub fn read_stack(path: &Path) -> Result<Slices> {
    let stored = if is_array(path) {
        read_array(path)?
    } else if path.is_file() {
        read_pages(path)?
    } else if !path.exists() && !is_pattern(path) {
        let missing = std::io::Error::new(ErrorKind::NotFound, "no such folder or file");
        return Err(Error::io(path, missing));
    } else {
        read_all(&stack_files(path)?, path)?
    };
    Ok(Slices::of(stored))
}

/// The files of a stack, as [`read_stack`] takes it, the first slice first.
///
/// # Errors
/// [`Error::Io`] when a folder cannot be read; [`Error::Format`] when the order of its files is in doubt.
pub fn stack_files(path: &Path) -> Result<Vec<PathBuf>> {
    if path.is_dir() {
        numbered_files(path, "*", &EXTENSIONS)
    } else if is_array(path) {
        Ok(vec![file_and_name(path).0])
    } else if is_pattern(path) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
        numbered_files(folder.unwrap_or(Path::new(".")), &name, &EXTENSIONS)
    } else {
        Ok(vec![path.to_owned()])
    }
}

fn is_pattern(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.contains('*')
}

/// An array `[z, y, x]`.
fn read_array(path: &Path) -> Result<Vec<Stored>> {
    const ACCEPTED: &str = "an array [z, y, x] of bool, masks of 0 and 1, floats from 0 to 1, or 8 or 16 bits without sign";
    let numbers = Numbers::read(path, ACCEPTED)?;
    let largest = numbers.values.iter().copied().fold(0.0, f32::max);
    let white = match numbers.kind {
        Kind::Float(_) | Kind::Bool => 1.0,
        Kind::Unsigned(bytes @ 1..=2) => 2f64.powi(8 * bytes as i32) - 1.0,
        // Without a white that is agreed on, 1 is it
        Kind::Signed(_) | Kind::Unsigned(_) => 1.0,
    };
    let refuse = |found: String| Error::format(path, found, ACCEPTED);
    if white == 1.0 && largest > 1.0 {
        return Err(refuse(format!("a value of {}", exact(largest))));
    }
    let ([_, rows, columns], values) = numbers.into_volume().map_err(&refuse)?;
    if rows * columns == 0 || values.len() as u64 > MOST_PIXELS {
        return Err(refuse(format!("an array of {} numbers", values.len())));
    }
    let slice = |values: &[f32]| {
        let upright = values.chunks(columns).rev().flatten();
        let values = upright.map(|&v| (f64::from(v) / white) as f32).collect();
        let stored = Stored::new(
            GrayPixels {
                rows,
                columns,
                values,
            },
            white,
        );
        check_values(&stored, path).map(|()| stored)
    };
    values.chunks(rows * columns).map(slice).collect()
}

fn read_all(files: &[PathBuf], stack: &Path) -> Result<Vec<Stored>> {
    if files.is_empty() {
        return Err(not_a_stack(stack, "no image is there"));
    }
    let mut slices: Vec<Stored> = Vec::with_capacity(files.len());
    for file in files {
        push_slice(&mut slices, read_stored(file)?, file, &files[0])?;
    }
    Ok(slices)
}

fn read_pages(path: &Path) -> Result<Vec<Stored>> {
    if !is_tiff(path) {
        let found = "neither a folder, nor a pattern, nor a TIFF, nor an array";
        return Err(not_a_stack(path, found));
    }
    let pages = tiff_pages(path)?;
    pages.iter().try_for_each(|page| check_values(page, path))?;
    Ok(pages)
}

/// Whether a file is a TIFF by its name.
pub(super) fn is_tiff(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default();
    let is_it = |tiff: &&str| extension.eq_ignore_ascii_case(tiff);
    ["tif", "tiff"].iter().any(is_it)
}

/// The pages of a TIFF as an array `[z, y, x]` of the numbers that are stored.
pub(super) fn read_volume(path: &Path) -> Result<([usize; 3], Vec<f32>)> {
    let pages = tiff_pages(path)?;
    let size = |page: &Stored| [page.pixels.rows, page.pixels.columns];
    let [rows, columns] = pages.first().map_or([0; 2], size);
    let mut values = Vec::with_capacity(pages.len() * rows * columns);
    for Stored { pixels, white } in &pages {
        let stored = |&share: &f32| match *white {
            1.0 => share,
            white => (f64::from(share) * white).round() as f32,
        };
        values.extend(pixels.values.rchunks(columns).flatten().map(stored));
    }
    Ok(([pages.len(), rows, columns], values))
}

fn tiff_pages(path: &Path) -> Result<Vec<Stored>> {
    let bytes = read_regular(path)?;
    let mut slices = Vec::new();
    let mut pages = open_tiff(&bytes).map_err(|found| bad(path, found))?;
    loop {
        let page = tiff_page(&mut pages).map_err(|found| bad(path, found))?;
        push_slice(&mut slices, page, path, path)?;
        if !pages.more_images() {
            return Ok(slices);
        }
        pages.next_image().map_err(|e| bad(path, damaged_tiff(e)))?;
    }
}

fn push_slice(slices: &mut Vec<Stored>, stored: Stored, file: &Path, first: &Path) -> Result<()> {
    let slice = &stored.pixels;
    if let Some(Stored { pixels: other, .. }) = slices.first()
        && (other.rows, other.columns) != (slice.rows, slice.columns)
    {
        let found = format!(
            "slice {} has {} × {} pixels, the first one ({}) {} × {}",
            slices.len() + 1,
            slice.columns,
            slice.rows,
            first.display(),
            other.columns,
            other.rows
        );
        return Err(not_a_stack(file, found));
    }
    let pixels = (slices.len() as u64 + 1) * (slice.rows * slice.columns) as u64;
    if pixels > MOST_PIXELS {
        return Err(not_a_stack(
            file,
            format!("a stack of more than {MOST_PIXELS} pixels"),
        ));
    }
    slices.push(stored);
    Ok(())
}

fn not_a_stack(path: &Path, found: impl Into<String>) -> Error {
    Error::format(
        path,
        found,
        "a folder of .png or .tif images of one size, a pattern such as `slices/*.png`, a .tif of several pages, or an array [z, y, x] (.npy, .nrrd, .npz)",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::gray_png;
    use std::io::Cursor;

    #[test]
    fn stacks_are_read_in_the_order_of_their_numbers() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, columns: usize, gray: u8| {
            std::fs::write(folder.path().join(name), gray_png(&vec![gray; columns])).unwrap();
        };
        for (name, gray) in [
            ("s_10.png", 102),
            ("s_9.png", 51),
            ("s_8.png", 0),
            ("s_11.png", 255),
        ] {
            write(name, 2, gray);
        }
        std::fs::write(folder.path().join("notes.txt"), "no image").unwrap();
        let first = |path: &Path| -> Vec<f32> {
            let stack = read_stack(path).unwrap();
            stack.slices.iter().map(|s| s.values[0]).collect()
        };
        assert_eq!(first(folder.path()), [0.0, 0.2, 0.4, 1.0]);
        let pattern = folder.path().join("s_1*.png");
        assert_eq!(first(&pattern), [0.4, 1.0]);
        // One of another size
        write("s_12.png", 3, 0);
        let text = read_stack(&pattern).unwrap_err().to_string();
        tomolith_core::contains!(text, "s_12.png: slice 3 has 3 × 1 pixels", "2 × 1");
        let none = |name: &str| read_stack(&folder.path().join(name)).unwrap_err();
        tomolith_core::contains!(none("x*.png").to_string(), "no image is there");
        tomolith_core::contains!(none("s_9.png").to_string(), "neither a folder");
        assert!(matches!(none("none.tif"), Error::Io { .. }));
        tomolith_core::contains!(none("nowhere").to_string(), "no such folder");
    }

    #[test]
    fn pages_of_a_tiff_are_slices() {
        use tiff::encoder::{TiffEncoder, colortype};
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("stack.tif");
        let write = |pages: &[(u32, Vec<u8>)]| {
            let mut file = Cursor::new(Vec::new());
            let mut encoder = TiffEncoder::new(&mut file).unwrap();
            for (columns, page) in pages {
                encoder
                    .write_image::<colortype::Gray8>(*columns, 1, page)
                    .unwrap();
            }
            std::fs::write(&path, file.into_inner()).unwrap();
        };
        write(&[(2, vec![0, 51]), (2, vec![102, 153]), (2, vec![204, 255])]);
        let stack = read_stack(&path).unwrap().slices;
        let values: Vec<&[f32]> = stack.iter().map(|s| &s.values[..]).collect();
        assert_eq!(values, [[0.0, 0.2], [0.4, 0.6], [0.8, 1.0]]);
        write(&[(2, vec![0, 51]), (1, vec![102])]);
        let text = read_stack(&path).unwrap_err().to_string();
        assert!(text.contains("slice 2 has 1 × 1 pixels"), "{text}");
        let whole = std::fs::read(&path).unwrap();
        std::fs::write(&path, &whole[..whole.len() / 2]).unwrap();
        assert!(read_stack(&path).is_err());
    }

    #[test]
    fn a_stack_of_0_and_1_is_a_mask_and_says_so() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, row: &[u8]| {
            std::fs::write(folder.path().join(name), gray_png(row)).unwrap();
        };
        write("1.png", &[0, 0, 0]);
        write("2.png", &[1, 0, 1]);
        let stack = read_stack(folder.path()).unwrap();
        assert_eq!(stack.slices[0].values, [0.0; 3]);
        assert_eq!(stack.slices[1].values, [1.0, 0.0, 1.0]);
        let note = stack.note.unwrap();
        assert!(note.contains("1 of 255") && note.contains("mask"), "{note}");
        // One gray value, and 1 is dark
        write("3.png", &[0, 2, 0]);
        let stack = read_stack(folder.path()).unwrap();
        assert_eq!((stack.slices[1].values[0], stack.note), (1.0 / 255.0, None));
    }

    /// A TIFF of one strip of bits, as other programs write it.
    fn tiff_of_bits(
        [columns, rows]: [u16; 2],
        photometric: u16,
        software: &str,
        bits: &[u8],
    ) -> Vec<u8> {
        use tiff::encoder::TiffEncoder;
        use tiff::tags::Tag;
        let mut file = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut file).unwrap();
        let mut page = encoder.image_directory().unwrap();
        let place = page.write_data(bits).unwrap() as u32;
        for (tag, value) in [
            (Tag::ImageWidth, columns),
            (Tag::ImageLength, rows),
            (Tag::BitsPerSample, 1),
            (Tag::Compression, 1),
            (Tag::PhotometricInterpretation, photometric),
            (Tag::RowsPerStrip, rows),
        ] {
            page.write_tag(tag, value).unwrap();
        }
        page.write_tag(Tag::StripOffsets, place).unwrap();
        page.write_tag(Tag::StripByteCounts, bits.len() as u32)
            .unwrap();
        page.write_tag(Tag::Software, software).unwrap();
        page.finish().unwrap();
        file.into_inner()
    }

    #[test]
    fn bits_of_a_tiff_are_black_and_white() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mask.tif");
        let read = |photometric, software| {
            // Rows of 11 pixels end within a byte
            let bits = [0b1010_0000, 0b0010_0000, 0b0000_0001, 0b1100_0000];
            std::fs::write(&path, tiff_of_bits([11, 2], photometric, software, &bits)).unwrap();
            let stack = read_stack(&path).unwrap();
            assert_eq!(stack.note, None);
            stack.slices[0].values.clone()
        };
        let ones = [0, 2, 10, 18, 19, 20];
        let expected: Vec<f32> = (0..22)
            .map(|i| f32::from(u8::from(ones.contains(&i))))
            .collect();
        let inverted: Vec<f32> = expected.iter().map(|v| 1.0 - v).collect();
        assert_eq!(read(1, "a scanner"), expected);
        assert_eq!(read(0, "a scanner"), inverted);
        // It stores bools with 0 as white, and means 1 by true
        assert_eq!(read(0, "tifffile.py"), expected);
    }

    #[test]
    fn arrays_are_stacks_whose_rows_count_from_minus_y() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npy");
        let first = |stack: Slices| stack.slices[0].values.clone();
        // [z, y, x] = [2, 2, 2]
        let bits = [true, false, false, false, true, true, true, true];
        let shape = (2, 2, 2);
        let mask = ndarray::Array3::from_shape_vec(shape, bits.to_vec()).unwrap();
        let ones = mask.mapv(i64::from);
        let floats = mask.mapv(|v| f64::from(u8::from(v)));
        let expected = [0.0, 0.0, 1.0, 0.0];
        let is_read = || assert_eq!(first(read_stack(&path).unwrap()), expected);
        ndarray_npy::write_npy(&path, &mask)
            .map(|()| is_read())
            .unwrap();
        assert_eq!(read_stack(&path).unwrap().note, None);
        let bytes = mask.mapv(|v| u8::from(v) * 255);
        ndarray_npy::write_npy(&path, &bytes)
            .map(|()| is_read())
            .unwrap();
        ndarray_npy::write_npy(&path, &ones)
            .map(|()| is_read())
            .unwrap();
        ndarray_npy::write_npy(&path, &floats)
            .map(|()| is_read())
            .unwrap();
        ndarray_npy::write_npy(&path, &mask.mapv(u8::from))
            .map(|()| is_read())
            .unwrap();
        tomolith_core::contains!(read_stack(&path).unwrap().note.unwrap(), "read as a mask");
        // Whole numbers of many bits have no white
        ndarray_npy::write_npy(&path, &ones.mapv(|v| 200 * v)).unwrap();
        let text = read_stack(&path).unwrap_err().to_string();
        assert!(text.contains("a value of 200"), "{text}");
        let archive = folder.path().join("a.npz");
        let mut npz = ndarray_npy::NpzWriter::new(std::fs::File::create(&archive).unwrap());
        npz.add_array("dose", &floats).unwrap();
        npz.add_array("target", &mask).unwrap();
        npz.finish().unwrap();
        let text = read_stack(&archive).unwrap_err().to_string();
        assert!(text.contains("it holds dose, target"), "{text}");
        let named = folder.path().join("a.npz:target");
        assert_eq!(first(read_stack(&named).unwrap()), expected);
        assert_eq!(stack_files(&named).unwrap(), [archive]);
    }
}
