//! Gray images: PNG and TIFF as real numbers from 0 (black) to 1 (white).
//!
//! | format | what is read |
//! |---|---|
//! | PNG | 1, 2, 4, 8 and 16 bit; gray, RGB, palette; alpha is ignored |
//! | TIFF | first image, or all pages as a stack; 8, 16 and 32 bit integers, 32 and 64 bit floats (taken as they are, 0…1); gray or RGB, alpha is ignored |
//!
//! A stack is a folder of images, a pattern such as `slices/*.png`, or a TIFF of several pages. Files are taken in the order
//! of their names, numbers in them by value: `slice_2` before `slice_10`.
//!
//! Colors become luma, 0.2126·R + 0.7152·G + 0.0722·B (ITU-R BT.709), of the values as stored (no gamma is undone).

use std::io::Cursor;
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};

/// What [`read_gray`] reads, for error messages.
pub const ACCEPTED: &str = "a gray or color image: .png, .tif or .tiff";

/// Most pixels of an image: what is larger is damaged, or no target.
const MOST_PIXELS: u64 = 1 << 28;

/// A gray image.
#[derive(Clone, Debug, PartialEq)]
pub struct GrayPixels {
    /// Rows, the top one first.
    pub rows: usize,
    /// Columns.
    pub columns: usize,
    /// `[row, column]`, 0…1.
    pub values: Vec<f32>,
}

/// Reads an image file; the format follows from the extension, in upper or lower case.
///
/// # Errors
/// [`Error::Io`] when the file cannot be read; [`Error::Format`] when its extension is unknown, its content is damaged, or
/// a value is no number from 0 to 1.
pub fn read_gray(path: impl AsRef<Path>) -> Result<GrayPixels> {
    let path = path.as_ref();
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or_default();
    parser(extension, path)?;
    let bytes = std::fs::read(path).map_err(|e| Error::io(path, e))?;
    parse_gray(&bytes, extension, path)
}

/// Most pixels of a stack: what is larger does not fit into memory.
const MOST_PIXELS_OF_A_STACK: u64 = 1 << 32;

/// Reads a stack of images of one size: a folder, a pattern with `*` in its last part, or a TIFF of several pages. The
/// first slice of the list is the first file, or page.
///
/// # Errors
/// [`Error::Io`] when a folder or file cannot be read; [`Error::Format`] when there is no image, images differ in size, or
/// one cannot be used as in [`read_gray`].
pub fn read_stack(path: impl AsRef<Path>) -> Result<Vec<GrayPixels>> {
    let path = path.as_ref();
    match path.is_file() {
        true => read_pages(path),
        false => read_all(&stack_files(path)?, path),
    }
}

/// The files of a stack, as [`read_stack`] takes it, the first slice first.
///
/// # Errors
/// [`Error::Io`] when a folder cannot be read.
pub fn stack_files(path: &Path) -> Result<Vec<PathBuf>> {
    let name = path.file_name().and_then(|n| n.to_str());
    let name = name.unwrap_or_default();
    if path.is_dir() {
        images_in(path, "*")
    } else if name.contains('*') {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
        images_in(folder.unwrap_or(Path::new(".")), name)
    } else {
        Ok(vec![path.to_owned()])
    }
}

/// The images of a folder whose names match a pattern, in their order.
fn images_in(folder: &Path, pattern: &str) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|e| Error::io(folder, e))? {
        let path = entry.map_err(|e| Error::io(folder, e))?.path();
        let name = path
            .file_name()
            .and_then(|n| n.to_str())
            .unwrap_or_default();
        let extension = path
            .extension()
            .and_then(|e| e.to_str())
            .unwrap_or_default();
        let hidden = name.starts_with('.');
        if !hidden && path.is_file() && matches(name, pattern) && parser(extension, &path).is_ok() {
            found.push(path);
        }
    }
    found.sort_by_cached_key(|path| {
        let name = path.file_name().unwrap_or_default();
        natural(&name.to_string_lossy())
    });
    Ok(found)
}

/// Whether a name is the pattern, in which every `*` stands for any text.
fn matches(name: &str, pattern: &str) -> bool {
    let Some((start, rest)) = pattern.split_once('*') else {
        return name == pattern;
    };
    name.strip_prefix(start).is_some_and(|name| {
        let ends = name.char_indices().map(|(i, _)| i).chain([name.len()]);
        ends.into_iter().any(|i| matches(&name[i..], rest))
    })
}

/// A name as texts and numbers in turn, so that 2 comes before 10.
fn natural(name: &str) -> Vec<(String, u64)> {
    let mut key = vec![(String::new(), 0u64)];
    let mut digits = false;
    for c in name.chars() {
        let Some((text, number)) = key.last_mut() else {
            break;
        };
        match c.to_digit(10) {
            Some(digit) => *number = number.saturating_mul(10).saturating_add(digit.into()),
            None if digits => key.push((c.to_string(), 0)),
            None => text.push(c),
        }
        digits = c.is_ascii_digit();
    }
    key
}

fn read_all(files: &[PathBuf], stack: &Path) -> Result<Vec<GrayPixels>> {
    if files.is_empty() {
        return Err(not_a_stack(stack, "no image is there"));
    }
    let mut slices: Vec<GrayPixels> = Vec::with_capacity(files.len());
    for file in files {
        let slice = read_gray(file)?;
        push_slice(&mut slices, slice, file, &files[0])?;
    }
    Ok(slices)
}

/// The pages of a TIFF.
fn read_pages(path: &Path) -> Result<Vec<GrayPixels>> {
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or_default();
    if !matches!(extension.to_ascii_lowercase().as_str(), "tif" | "tiff") {
        return Err(not_a_stack(
            path,
            "neither a folder, nor a pattern, nor a TIFF",
        ));
    }
    let bytes = std::fs::read(path).map_err(|e| Error::io(path, e))?;
    let mut slices = Vec::new();
    let mut pages = open_tiff(&bytes).map_err(|found| bad(path, found))?;
    loop {
        let page = tiff_page(&mut pages).map_err(|found| bad(path, found))?;
        check_values(&page, path)?;
        push_slice(&mut slices, page, path, path)?;
        if !pages.more_images() {
            return Ok(slices);
        }
        pages.next_image().map_err(|e| bad(path, damaged_tiff(e)))?;
    }
}

fn push_slice(
    slices: &mut Vec<GrayPixels>,
    slice: GrayPixels,
    file: &Path,
    first: &Path,
) -> Result<()> {
    if let Some(other) = slices.first()
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
    if pixels > MOST_PIXELS_OF_A_STACK {
        return Err(not_a_stack(
            file,
            format!("a stack of more than {MOST_PIXELS_OF_A_STACK} pixels"),
        ));
    }
    slices.push(slice);
    Ok(())
}

fn not_a_stack(path: &Path, found: impl Into<String>) -> Error {
    Error::Format {
        path: path.to_owned(),
        found: found.into(),
        accepted: "a folder of .png or .tif images of one size, a pattern such as `slices/*.png`, or a .tif of several pages"
            .to_owned(),
    }
}

/// Reads an image from memory; `path` only names it in errors.
///
/// # Errors
/// [`Error::Format`] as in [`read_gray`].
pub fn parse_gray(bytes: &[u8], extension: &str, path: &Path) -> Result<GrayPixels> {
    let image = parser(extension, path)?(bytes).map_err(|found| bad(path, found))?;
    check_values(&image, path)?;
    Ok(image)
}

fn check_values(image: &GrayPixels, path: &Path) -> Result<()> {
    match image.values.iter().find(|v| !(0.0..=1.0).contains(*v)) {
        Some(value) => Err(bad(path, format!("a pixel of value {value}"))),
        None => Ok(()),
    }
}

type Parse = fn(&[u8]) -> Result<GrayPixels, String>;

fn parser(extension: &str, path: &Path) -> Result<Parse> {
    match extension.to_ascii_lowercase().as_str() {
        "png" => Ok(parse_png),
        "tif" | "tiff" => Ok(parse_tiff),
        other => Err(bad(path, format!("extension `.{other}` is not known"))),
    }
}

fn bad(path: &Path, found: impl Into<String>) -> Error {
    Error::Format {
        path: path.to_owned(),
        found: found.into(),
        accepted: format!("{ACCEPTED}, values from 0 to 1, at most {MOST_PIXELS} pixels"),
    }
}

/// Checks a size before memory is reserved for it.
fn check_size(columns: u32, rows: u32) -> Result<(), String> {
    let pixels = u64::from(columns) * u64::from(rows);
    if pixels == 0 || pixels > MOST_PIXELS {
        return Err(format!("an image of {columns} × {rows} pixels"));
    }
    Ok(())
}

fn parse_png(bytes: &[u8]) -> Result<GrayPixels, String> {
    let damaged = |e: png::DecodingError| format!("damaged PNG: {e}");
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let header = decoder.read_header_info().map_err(damaged)?;
    check_size(header.width, header.height)?;
    let mut reader = decoder.read_info().map_err(damaged)?;
    let size = reader
        .output_buffer_size()
        .ok_or("an image too large for memory")?;
    let mut buffer = vec![0; size];
    let frame = reader.next_frame(&mut buffer).map_err(damaged)?;
    let values = match frame.bit_depth {
        png::BitDepth::Sixteen => buffer[..frame.buffer_size()]
            .chunks_exact(2)
            .map(|pair| f32::from(u16::from_be_bytes([pair[0], pair[1]])) / 65535.0)
            .collect(),
        _ => buffer[..frame.buffer_size()]
            .iter()
            .map(|&v| f32::from(v) / 255.0)
            .collect::<Vec<_>>(),
    };
    gray(
        &values,
        frame.color_type.samples(),
        frame.width as usize,
        frame.height as usize,
    )
}

fn parse_tiff(bytes: &[u8]) -> Result<GrayPixels, String> {
    tiff_page(&mut open_tiff(bytes)?)
}

type Tiff<'a> = tiff::decoder::Decoder<Cursor<&'a [u8]>>;

fn damaged_tiff(e: tiff::TiffError) -> String {
    format!("damaged TIFF: {e}")
}

fn open_tiff(bytes: &[u8]) -> Result<Tiff<'_>, String> {
    let mut limits = tiff::decoder::Limits::default();
    limits.decoding_buffer_size = MOST_PIXELS as usize * 4;
    let decoder = Tiff::new(Cursor::new(bytes)).map_err(damaged_tiff)?;
    Ok(decoder.with_limits(limits))
}

/// The page at which a file stands.
fn tiff_page(decoder: &mut Tiff<'_>) -> Result<GrayPixels, String> {
    use tiff::decoder::DecodingResult;
    let damaged = damaged_tiff;
    let (columns, rows) = decoder.dimensions().map_err(damaged)?;
    check_size(columns, rows)?;
    let color = decoder.colortype().map_err(damaged)?;
    let samples = match color {
        tiff::ColorType::Gray(_) => 1,
        tiff::ColorType::GrayA(_) => 2,
        tiff::ColorType::RGB(_) => 3,
        tiff::ColorType::RGBA(_) => 4,
        tiff::ColorType::Multiband { num_samples, .. } => usize::from(num_samples),
        other => return Err(format!("a TIFF with colors {other:?}")),
    };
    let values: Vec<f32> = match decoder.read_image().map_err(damaged)? {
        DecodingResult::U8(v) => v.iter().map(|&v| f32::from(v) / 255.0).collect(),
        DecodingResult::U16(v) => v.iter().map(|&v| f32::from(v) / 65535.0).collect(),
        DecodingResult::U32(v) => v
            .iter()
            .map(|&v| (f64::from(v) / f64::from(u32::MAX)) as f32)
            .collect(),
        DecodingResult::F32(v) => v,
        DecodingResult::F64(v) => v.iter().map(|&v| v as f32).collect(),
        _ => return Err("a TIFF with signed, 64 bit or half-float samples".to_owned()),
    };
    gray(&values, samples, columns as usize, rows as usize)
}

/// Luma of interleaved samples: gray, gray and alpha, RGB, or RGB and alpha.
fn gray(values: &[f32], samples: usize, columns: usize, rows: usize) -> Result<GrayPixels, String> {
    if samples == 0 || values.len() != samples * rows * columns {
        return Err(format!(
            "{} samples for {columns} × {rows} pixels of {samples}",
            values.len()
        ));
    }
    // In f64, so that white stays white whatever the rounding of the three weights
    let luma = |pixel: &[f32]| match *pixel {
        [r, g, b, ..] => {
            (0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)) as f32
        }
        [gray, ..] => gray,
        [] => 0.0,
    };
    Ok(GrayPixels {
        rows,
        columns,
        values: values.chunks_exact(samples).map(luma).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn png_of(color: png::ColorType, depth: png::BitDepth, columns: u32, data: &[u8]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, columns, 1);
        encoder.set_color(color);
        encoder.set_depth(depth);
        encoder
            .write_header()
            .unwrap()
            .write_image_data(data)
            .unwrap();
        bytes
    }

    fn parse(bytes: &[u8], extension: &str) -> Vec<f32> {
        parse_gray(bytes, extension, Path::new("image"))
            .unwrap()
            .values
    }

    #[test]
    fn png_of_every_kind_is_real_valued() {
        use png::{BitDepth, ColorType};
        let gray = png_of(ColorType::Grayscale, BitDepth::Eight, 3, &[0, 51, 255]);
        assert_eq!(parse(&gray, "png"), [0.0, 0.2, 1.0]);
        let deep = png_of(
            ColorType::Grayscale,
            BitDepth::Sixteen,
            2,
            &[0x33, 0x33, 0, 1],
        );
        assert_eq!(parse(&deep, "PNG"), [0.2, 1.0 / 65535.0]);
        let alpha = png_of(
            ColorType::GrayscaleAlpha,
            BitDepth::Eight,
            2,
            &[51, 0, 255, 9],
        );
        assert_eq!(parse(&alpha, "png"), [0.2, 1.0]);
        let rgba = png_of(
            ColorType::Rgba,
            BitDepth::Eight,
            3,
            &[255, 0, 0, 0, 0, 255, 0, 1, 255, 255, 255, 2],
        );
        assert_eq!(parse(&rgba, "png"), [0.2126, 0.7152, 1.0]);
        let bits = png_of(ColorType::Grayscale, BitDepth::One, 3, &[0b0100_0000]);
        assert_eq!(parse(&bits, "png"), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn tiff_of_integers_and_floats() {
        use tiff::encoder::{TiffEncoder, colortype};
        let mut bytes = Cursor::new(Vec::new());
        TiffEncoder::new(&mut bytes)
            .unwrap()
            .write_image::<colortype::Gray16>(2, 1, &[13107, 65535])
            .unwrap();
        assert_eq!(parse(bytes.get_ref(), "tif"), [0.2, 1.0]);
        let mut bytes = Cursor::new(Vec::new());
        TiffEncoder::new(&mut bytes)
            .unwrap()
            .write_image::<colortype::Gray32Float>(2, 1, &[0.25, 1.5])
            .unwrap();
        let text = parse_gray(bytes.get_ref(), "tiff", Path::new("a.tiff"))
            .unwrap_err()
            .to_string();
        assert!(
            text.starts_with("a.tiff: a pixel of value 1.5; accepted: "),
            "{text}"
        );
        let mut bytes = Cursor::new(Vec::new());
        TiffEncoder::new(&mut bytes)
            .unwrap()
            .write_image::<colortype::RGB8>(1, 1, &[0, 255, 0])
            .unwrap();
        assert_eq!(parse(bytes.get_ref(), "tif"), [0.7152]);
    }

    #[test]
    fn stacks_are_read_in_the_order_of_their_numbers() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, columns: u32, gray: u8| {
            let data = vec![gray; columns as usize];
            let bytes = png_of(
                png::ColorType::Grayscale,
                png::BitDepth::Eight,
                columns,
                &data,
            );
            std::fs::write(folder.path().join(name), bytes).unwrap();
        };
        for (name, gray) in [
            ("s_10.png", 102),
            ("s_9.png", 51),
            ("s_1.png", 0),
            ("t_0.png", 255),
        ] {
            write(name, 2, gray);
        }
        std::fs::write(folder.path().join("notes.txt"), "no image").unwrap();
        let first = |stack: &[GrayPixels]| stack.iter().map(|s| s.values[0]).collect::<Vec<_>>();
        assert_eq!(
            first(&read_stack(folder.path()).unwrap()),
            [0.0, 0.2, 0.4, 1.0]
        );
        let pattern = folder.path().join("s_*.png");
        assert_eq!(first(&read_stack(&pattern).unwrap()), [0.0, 0.2, 0.4]);
        // One of another size
        write("s_11.png", 3, 0);
        let text = read_stack(&pattern).unwrap_err().to_string();
        assert!(
            text.contains("s_11.png: slice 4 has 3 × 1 pixels") && text.contains("2 × 1"),
            "{text}"
        );
        let none = read_stack(folder.path().join("x*.png"))
            .unwrap_err()
            .to_string();
        assert!(none.contains("no image is there"), "{none}");
        assert!(
            read_stack(folder.path().join("s_1.png"))
                .unwrap_err()
                .to_string()
                .contains("neither a folder")
        );
        assert!(matches!(
            read_stack(folder.path().join("none.tif")),
            Err(Error::Io { .. })
        ));
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
        let stack = read_stack(&path).unwrap();
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
    fn damage_is_named() {
        let whole = png_of(
            png::ColorType::Grayscale,
            png::BitDepth::Eight,
            3,
            &[0, 51, 255],
        );
        for cut in [0, 5, 20, 40, whole.len() / 2] {
            let text = parse_gray(&whole[..cut], "png", Path::new("a.png"))
                .unwrap_err()
                .to_string();
            assert!(text.starts_with("a.png: damaged PNG"), "{text}");
        }
        let mut huge = whole.clone();
        huge[16..20].copy_from_slice(&0x7fff_ffffu32.to_be_bytes());
        assert!(parse_gray(&huge, "png", Path::new("a.png")).is_err());
        assert!(
            parse_gray(&whole, "bmp", Path::new("a.bmp"))
                .unwrap_err()
                .to_string()
                .contains("`.bmp`")
        );
        assert!(parse_gray(b"II*\0\x08\0\0\0", "tif", Path::new("a.tif")).is_err());
    }

    #[test]
    fn mutated_bytes_end_in_an_image_or_an_error() {
        use crate::fuzz::{self, Random, mutate};
        let mut tiff = Cursor::new(Vec::new());
        tiff::encoder::TiffEncoder::new(&mut tiff)
            .unwrap()
            .write_image::<tiff::encoder::colortype::Gray16>(3, 2, &[1, 2, 3, 4, 5, 6])
            .unwrap();
        let png = png_of(
            png::ColorType::Grayscale,
            png::BitDepth::Eight,
            3,
            &[0, 51, 255],
        );
        let start = std::time::Instant::now();
        let (mut round, mut read) = (0, 0);
        while start.elapsed() < fuzz::time() / 2 {
            let mut random = Random(round);
            let (extension, whole) = [("png", &png), ("tif", tiff.get_ref())][random.below(2)];
            let mut bytes = whole.clone();
            mutate(&mut bytes, &mut random);
            let result =
                std::panic::catch_unwind(|| parse_gray(&bytes, extension, Path::new("image")));
            match result {
                Ok(image) => read += u64::from(image.is_ok()),
                Err(_) => panic!("{extension}, round {round}: the reader panicked"),
            }
            round += 1;
        }
        assert!(read > 0 && read < round, "{read} of {round} could be read");
    }
}
