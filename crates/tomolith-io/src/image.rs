//! Gray images: PNG and TIFF as real numbers from 0 (black) to 1 (white).
//!
//! | format | what is read |
//! |---|---|
//! | PNG | 1, 2, 4, 8 and 16 bit; gray, RGB, palette; alpha is ignored |
//! | TIFF | one page, or several as a stack (see [`slices`](super::slices)); integers of 1 to 64 bits, floats of 16 to 64 bits (taken as they are, 0…1); gray or RGB, alpha is ignored |
//!
//! Colors become luma, 0.2126·R + 0.7152·G + 0.0722·B (ITU-R BT.709), of the values as stored (no gamma is undone).
//! An image of several bits a sample that stores nothing but 0 and 1 is a mask: its 1 is white.

use super::slices::{Slices, Stored};
use std::io::{BufRead, Cursor, Seek};
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::files::read_regular;

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
    let stored = read_stored(path.as_ref())?;
    let mut slices = Slices::of(vec![stored]).slices;
    Ok(slices.swap_remove(0))
}

/// Reads an image file as it is stored.
pub(super) fn read_stored(path: &Path) -> Result<Stored> {
    if path.is_dir() {
        return Err(bad(
            path,
            "a folder, whose images are a stack of slices (`target.stack`)",
        ));
    }
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    parser(&extension, path)?;
    parse_gray(&read_regular(path)?, &extension, path)
}

/// Reads an image from memory; `path` only names it in errors.
fn parse_gray(bytes: &[u8], extension: &str, path: &Path) -> Result<Stored> {
    let image = parser(extension, path)?(bytes).map_err(|found| bad(path, found))?;
    check_values(&image, path)?;
    Ok(image)
}

pub(super) fn check_values(image: &Stored, path: &Path) -> Result<()> {
    let mut values = image.pixels.values.iter();
    match values.find(|v| !(0.0..=1.0).contains(*v)) {
        Some(value) => {
            let found = format!("a pixel of value {value}");
            Err(Error::format(path, found, "values from 0 to 1"))
        }
        None => Ok(()),
    }
}

type Parse = fn(&[u8]) -> Result<Stored, String>;

pub(super) const EXTENSIONS: [&str; 3] = ["png", "tif", "tiff"];

fn parser(extension: &str, path: &Path) -> Result<Parse> {
    match extension.to_ascii_lowercase().as_str() {
        "png" => Ok(parse_png),
        "tif" | "tiff" => Ok(parse_tiff),
        "apng" => Err(bad(path, "an animated PNG (APNG), which is a movie")),
        "" => Err(bad(path, "a name without an extension")),
        other => Err(bad(path, format!("extension `.{other}` is not known"))),
    }
}

pub(super) fn bad(path: &Path, found: impl Into<String>) -> Error {
    Error::format(
        path,
        found,
        format!("{ACCEPTED}, values from 0 to 1, at most {MOST_PIXELS} pixels"),
    )
}

/// Checks a size before memory is reserved for it.
fn check_size(columns: u32, rows: u32) -> Result<(), String> {
    let pixels = u64::from(columns) * u64::from(rows);
    if pixels == 0 || pixels > MOST_PIXELS {
        return Err(format!("an image of {columns} × {rows} pixels"));
    }
    Ok(())
}

fn parse_png(bytes: &[u8]) -> Result<Stored, String> {
    let damaged = |e: png::DecodingError| format!("damaged PNG: {e}");
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let header = decoder.read_header_info().map_err(damaged)?;
    check_size(header.width, header.height)?;
    // The step of an image with a palette is that of its colors
    let bits = match header.color_type {
        png::ColorType::Indexed => 8,
        _ => header.bit_depth as u32,
    };
    let mut reader = decoder.read_info().map_err(damaged)?;
    if let Some(animation) = reader.info().animation_control() {
        let frames = animation.num_frames;
        return Err(format!(
            "an animated PNG (APNG) of {frames} frames, which is a movie"
        ));
    }
    let (frame, numbers) = png_samples(&mut reader).map_err(damaged)?;
    let white = top(frame.bit_depth as u32);
    let values = scaled(numbers.into_iter().map(f64::from), white);
    let pixels = gray(
        &values,
        frame.color_type.samples(),
        frame.width as usize,
        frame.height as usize,
    )?;
    Ok(Stored::new(pixels, top(bits)))
}

/// The numbers of an image, of 8 or of 16 bits.
pub(super) fn png_samples<R: BufRead + Seek>(
    reader: &mut png::Reader<R>,
) -> Result<(png::OutputInfo, Vec<u16>), png::DecodingError> {
    let size = reader.output_buffer_size();
    let mut bytes = vec![0; size.ok_or(png::DecodingError::LimitsExceeded)?];
    let frame = reader.next_frame(&mut bytes)?;
    bytes.truncate(frame.buffer_size());
    let pair = |pair: &[u8]| u16::from_be_bytes([pair[0], pair[1]]);
    let numbers = match frame.bit_depth {
        png::BitDepth::Sixteen => bytes.chunks_exact(2).map(pair).collect(),
        _ => bytes.iter().map(|&v| u16::from(v)).collect(),
    };
    Ok((frame, numbers))
}

/// The largest number of so many bits.
fn top(bits: u32) -> f64 {
    2f64.powi(bits as i32) - 1.0
}

/// Numbers as shares of the one that is white.
#[expect(clippy::cast_possible_truncation, reason = "pixels are f32")]
fn scaled(numbers: impl Iterator<Item = f64>, white: f64) -> Vec<f32> {
    numbers.map(|v| (v / white) as f32).collect()
}

fn parse_tiff(bytes: &[u8]) -> Result<Stored, String> {
    let mut decoder = open_tiff(bytes)?;
    let page = tiff_page(&mut decoder)?;
    let mut pages = 1;
    while decoder.more_images() {
        decoder.next_image().map_err(damaged_tiff)?;
        pages += 1;
    }
    match pages {
        1 => Ok(page),
        _ => Err(format!(
            "a TIFF of {pages} pages, which is a stack of slices (`target.stack`)"
        )),
    }
}

pub(super) type Tiff<'a> = tiff::decoder::Decoder<Cursor<&'a [u8]>>;

pub(super) fn damaged_tiff(e: tiff::TiffError) -> String {
    match e {
        tiff::TiffError::UnsupportedError(e) => format!("a TIFF of another kind: {e}"),
        e => format!("damaged TIFF: {e}"),
    }
}

pub(super) fn open_tiff(bytes: &[u8]) -> Result<Tiff<'_>, String> {
    let mut limits = tiff::decoder::Limits::default();
    limits.decoding_buffer_size = MOST_PIXELS as usize * 4;
    let decoder = Tiff::new(Cursor::new(bytes)).map_err(damaged_tiff)?;
    Ok(decoder.with_limits(limits))
}

/// The page at which a file stands.
pub(super) fn tiff_page(decoder: &mut Tiff<'_>) -> Result<Stored, String> {
    use tiff::decoder::DecodingResult as Read;
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
    let (columns, rows) = (columns as usize, rows as usize);
    let bits = u32::from(color.bit_depth());
    if !bits.is_power_of_two() {
        return Err(format!("a TIFF of {bits} bits a sample"));
    }
    let (unsigned, signed) = (top(bits), top(bits - 1).max(1.0));
    let (values, white) = match decoder.read_image().map_err(damaged)? {
        Read::U8(bytes) if bits < 8 => {
            let numbers = unpacked(&bytes, bits, samples * columns);
            (scaled(numbers.map(f64::from), unsigned), unsigned)
        }
        Read::U8(v) => (scaled(v.into_iter().map(f64::from), unsigned), unsigned),
        Read::U16(v) => (scaled(v.into_iter().map(f64::from), unsigned), unsigned),
        Read::U32(v) => (scaled(v.into_iter().map(f64::from), unsigned), unsigned),
        Read::U64(v) => (scaled(v.into_iter().map(|v| v as f64), unsigned), unsigned),
        Read::I8(v) => (scaled(v.into_iter().map(f64::from), signed), signed),
        Read::I16(v) => (scaled(v.into_iter().map(f64::from), signed), signed),
        Read::I32(v) => (scaled(v.into_iter().map(f64::from), signed), signed),
        Read::I64(v) => (scaled(v.into_iter().map(|v| v as f64), signed), signed),
        Read::F16(v) => (v.into_iter().map(|v| v.to_f32()).collect(), 1.0),
        Read::F32(v) => (v, 1.0),
        Read::F64(v) => (scaled(v.into_iter(), 1.0), 1.0),
    };
    let mut stored = Stored::new(gray(&values, samples, columns, rows)?, white);
    if bits == 1 && is_array_of_bools(decoder) {
        stored.pixels.values.iter_mut().for_each(|v| *v = 1.0 - *v);
    }
    Ok(stored)
}

/// Numbers of fewer than 8 bits, the first one highest in its byte; every row of so many begins with a new byte.
fn unpacked(bytes: &[u8], bits: u32, in_row: usize) -> impl Iterator<Item = u8> {
    let in_byte = (8 / bits) as usize;
    let rows = bytes.chunks(in_row.div_ceil(in_byte).max(1));
    rows.flat_map(move |row| {
        (0..in_row.min(row.len() * in_byte)).map(move |i| {
            let shift = 8 - bits * (i % in_byte + 1) as u32;
            row[i / in_byte] >> shift & ((1u16 << bits) - 1) as u8
        })
    })
}

/// Whether tifffile wrote a page of bits that names 0 as white: so it stores arrays of bools, whose true is 1, and reads them
/// back without a look at the colors.
fn is_array_of_bools(decoder: &mut Tiff<'_>) -> bool {
    use tiff::tags::Tag;
    let color = decoder.find_tag_unsigned(Tag::PhotometricInterpretation);
    let writer = decoder.get_tag_ascii_string(Tag::Software);
    matches!(color, Ok(Some(0u16))) && writer.is_ok_and(|name| name.starts_with("tifffile"))
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
fn png_of(color: png::ColorType, depth: png::BitDepth, columns: u32, data: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, columns, 1);
    encoder.set_color(color);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(data).unwrap();
    drop(writer);
    bytes
}

/// A PNG of one row of 8 bits.
#[cfg(test)]
pub(super) fn gray_png(row: &[u8]) -> Vec<u8> {
    let columns = row.len() as u32;
    png_of(
        png::ColorType::Grayscale,
        png::BitDepth::Eight,
        columns,
        row,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use tiff::encoder::colortype::{self, ColorType};
    use tiff::encoder::{TiffEncoder, TiffValue};

    /// A TIFF of so many columns.
    fn tiff_of<C: ColorType>(columns: u32, data: &[C::Inner]) -> Vec<u8>
    where
        [C::Inner]: TiffValue,
    {
        let mut file = Cursor::new(Vec::new());
        let rows = (data.len() / C::SAMPLE_FORMAT.len()) as u32 / columns;
        let mut encoder = TiffEncoder::new(&mut file).unwrap();
        encoder.write_image::<C>(columns, rows, data).unwrap();
        file.into_inner()
    }

    fn parse(bytes: &[u8], extension: &str) -> Vec<f32> {
        let stored = parse_gray(bytes, extension, Path::new("image")).unwrap();
        stored.pixels.values
    }

    fn refused(bytes: &[u8], extension: &str) -> String {
        let stored = parse_gray(bytes, extension, Path::new("image"));
        stored.unwrap_err().to_string()
    }

    #[test]
    fn png_of_every_kind_is_real_valued() {
        use png::{BitDepth, ColorType};
        for (color, depth, columns, data, expected) in [
            (
                ColorType::Grayscale,
                BitDepth::Eight,
                3,
                &[0, 51, 255][..],
                &[0.0, 0.2, 1.0][..],
            ),
            (
                ColorType::Grayscale,
                BitDepth::Sixteen,
                2,
                &[51, 51, 0, 1],
                &[0.2, 1.0 / 65535.0],
            ),
            (
                ColorType::GrayscaleAlpha,
                BitDepth::Eight,
                2,
                &[51, 0, 255, 9],
                &[0.2, 1.0],
            ),
            (
                ColorType::Rgba,
                BitDepth::Eight,
                2,
                &[255, 0, 0, 0, 255, 255, 255, 2],
                &[0.2126, 1.0],
            ),
            (ColorType::Rgb, BitDepth::Eight, 1, &[0, 255, 0], &[0.7152]),
            (
                ColorType::Grayscale,
                BitDepth::One,
                3,
                &[0b0100_0000],
                &[0.0, 1.0, 0.0],
            ),
        ] {
            let bytes = png_of(color, depth, columns, data);
            assert_eq!(parse(&bytes, "PNG"), expected);
        }
    }

    #[test]
    fn tiff_of_integers_and_floats() {
        let integers = tiff_of::<colortype::Gray16>(2, &[13107, 65535]);
        assert_eq!(parse(&integers, "tif"), [0.2, 1.0]);
        let colors = tiff_of::<colortype::RGB8>(1, &[0, 255, 0]);
        assert_eq!(parse(&colors, "TIFF"), [0.7152]);
        let text = refused(&tiff_of::<colortype::Gray32Float>(2, &[0.25, 1.5]), "tiff");
        assert!(
            text.starts_with("image: a pixel of value 1.5; accepted: "),
            "{text}"
        );
    }

    #[test]
    fn damage_is_named() {
        let whole = gray_png(&[0, 51, 255]);
        for cut in [0, 5, 20, 40, whole.len() / 2] {
            let text = refused(&whole[..cut], "png");
            assert!(text.starts_with("image: damaged PNG"), "{text}");
        }
        let mut huge = whole.clone();
        huge[16..20].copy_from_slice(&0x7fff_ffffu32.to_be_bytes());
        refused(&huge, "png");
        assert!(refused(&whole, "apng").contains("animated PNG"));
        assert!(refused(&whole, "bmp").contains("`.bmp`"));
        refused(b"II*\0\x08\0\0\0", "tif");
        assert!(refused(&whole, "").contains("without an extension"));
    }

    #[test]
    fn several_pages_and_folders_are_no_image() {
        let mut file = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut file).unwrap();
        for gray in [0, 255] {
            let page = encoder.write_image::<colortype::Gray8>(1, 1, &[gray]);
            page.unwrap();
        }
        let text = refused(&file.into_inner(), "tif");
        tomolith_core::contains!(text, "a TIFF of 2 pages", "target.stack");
        let folder = tempfile::tempdir().unwrap();
        let text = read_gray(folder.path()).unwrap_err().to_string();
        tomolith_core::contains!(text, ": a folder", "target.stack");
    }

    #[test]
    fn mutated_bytes_end_in_an_image_or_an_error() {
        use tomolith_core::check::fuzz::{mutate, rounds};
        let tiff = tiff_of::<colortype::Gray16>(3, &[1, 2, 3, 4, 5, 6]);
        let files = [("png", gray_png(&[0, 51, 255])), ("tif", tiff)];
        let [read, all] = rounds(0.5, |random| {
            let (extension, whole) = &files[random.below(2)];
            let mut bytes = whole.clone();
            mutate(&mut bytes, random);
            parse_gray(&bytes, extension, Path::new("image")).is_ok()
        });
        assert!(read > 0 && read < all, "{read} of {all} could be read");
    }
}
