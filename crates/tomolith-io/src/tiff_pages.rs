//! TIFF of several pages: volumes for ImageJ, Fiji and whatever reads images, lengths in mm.
//!
//! A slice is a page, the bottom one first, its top row +y: as [`slices`](super::slices) reads them again. Numbers are floats of 32 bits or bytes, not compressed.
//!
//! ImageJ takes lengths from the description of the first page: `spacing` of the slices, `unit`, and the pixel that lies on the origin. It reads the first page alone, and
//! all slices from where its numbers begin, so they lie in a row and the pages' directories after them. Beyond 4 GB the file is a BigTIFF, which ImageJ opens through
//! Bio-Formats (part of Fiji).
//!
//! Sources: Adobe, "TIFF 6.0"; the ImageJ metadata as `ij/io/TiffDecoder` and `ij/io/FileSaver` define them.

use super::volume::{Values, tidy};
use super::whole::{Refused, write_whole_under};
use std::fmt::Write as _;
use std::io::{Error as IoError, Seek, Write};
use std::path::Path;
use tiff::TiffError;
use tiff::encoder::{
    DirectoryEncoder, Rational, TiffEncoder, TiffKind, TiffKindBig, TiffKindStandard, TiffValue,
};
use tiff::tags::Tag;
use tomolith_core::error::Result;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::units::exact;
use tomolith_core::work::Work;

/// Bytes up to which places in a file fit into 32 bits, less what directories take.
const MOST_STANDARD: usize = (u32::MAX - (1 << 26)) as usize;

/// Writes values that fit the grid.
pub(super) fn write(path: &Path, grid: &VolumeGrid, values: Values<'_>, work: &Work) -> Result<()> {
    write_whole_under(path, work, values.bytes(), |file| {
        let written = match values.bytes() > MOST_STANDARD {
            true => pages::<_, TiffKindBig>(file, grid, values),
            false => pages::<_, TiffKindStandard>(file, grid, values),
        };
        written.map_err(|error| {
            Refused::Io(match error {
                TiffError::IoError(error) => error,
                other => IoError::other(other),
            })
        })
    })
}

fn pages<W: Write + Seek, K: TiffKind>(
    file: W,
    grid: &VolumeGrid,
    values: Values<'_>,
) -> Result<(), TiffError>
where
    K::OffsetType: TiffValue,
{
    let mut tiff = TiffEncoder::<W, K>::new_generic(file)?;
    let [nz, ny, nx] = grid.shape;
    let bytes = (values.bytes() / nz.max(1)) as u64;
    let mut start = 0;
    for z in 0..nz {
        let mut page = tiff.image_directory()?;
        if z == 0 {
            start = match values {
                Values::F32(values) => upright(&mut page, values, [ny, nx])?,
                Values::U8(values) => upright(&mut page, values, [ny, nx])?,
            };
            let text = description(grid, values);
            page.write_tag(Tag::ImageDescription, &text[..])?;
        }
        let (bits, format) = match values {
            Values::F32(_) => (32u16, 3u16),
            Values::U8(_) => (8, 1),
        };
        page.write_tag(Tag::ImageWidth, u32::try_from(nx)?)?;
        page.write_tag(Tag::ImageLength, u32::try_from(ny)?)?;
        page.write_tag(Tag::RowsPerStrip, u32::try_from(ny)?)?;
        page.write_tag(Tag::BitsPerSample, bits)?;
        page.write_tag(Tag::SampleFormat, format)?;
        page.write_tag(Tag::SamplesPerPixel, 1u16)?;
        // Not compressed; 0 is black
        page.write_tag(Tag::Compression, 1u16)?;
        page.write_tag(Tag::PhotometricInterpretation, 1u16)?;
        page.write_tag(
            Tag::StripOffsets,
            K::convert_offset(start + z as u64 * bytes)?,
        )?;
        page.write_tag(Tag::StripByteCounts, K::convert_offset(bytes)?)?;
        page.write_tag(Tag::XResolution, per_mm(grid.pitch_mm))?;
        page.write_tag(Tag::YResolution, per_mm(grid.pitch_mm))?;
        // Per what the description says
        page.write_tag(Tag::ResolutionUnit, 1u16)?;
        page.finish()?;
    }
    Ok(())
}

/// Writes all slices one after the other, rows from +y down; where the first one begins.
fn upright<T, W: Write + Seek, K: TiffKind>(
    page: &mut DirectoryEncoder<'_, W, K>,
    values: &[T],
    [ny, nx]: [usize; 2],
) -> Result<u64, TiffError>
where
    [T]: TiffValue,
    T: Clone,
{
    let mut start = None;
    let mut slice = Vec::with_capacity(ny * nx);
    for upside_down in values.chunks_exact((ny * nx).max(1)) {
        slice.clear();
        for row in upside_down.rchunks_exact(nx) {
            slice.extend_from_slice(row);
        }
        let place = page.write_data(&slice[..])?;
        start.get_or_insert(place);
    }
    Ok(start.unwrap_or_default())
}

/// What ImageJ reads.
fn description(grid: &VolumeGrid, values: Values<'_>) -> String {
    let [nz, ny, _] = grid.shape;
    let [low, high] = match values {
        Values::F32(values) => range(values.iter().copied()),
        Values::U8(values) => range(values.iter().map(|&v| f32::from(v))),
    };
    let pixels = |mm: f64, pitch_mm: f64| exact(tidy(mm / pitch_mm));
    let mut text = format!("ImageJ=1.54f\nimages={nz}\nslices={nz}\nunit=mm\nloop=false\n");
    for (key, value) in [
        ("spacing", exact(tidy(grid.height_mm))),
        ("min", exact(low)),
        ("max", exact(high)),
        ("xorigin", pixels(-grid.x(0), grid.pitch_mm)),
        ("yorigin", pixels(grid.y(ny.max(1) - 1), grid.pitch_mm)),
        ("zorigin", pixels(-grid.z(0), grid.height_mm)),
    ] {
        // Writing into a string cannot fail
        let _ = writeln!(text, "{key}={value}");
    }
    text
}

/// The least and the largest finite number, of which black and white are made.
fn range(values: impl Iterator<Item = f32>) -> [f32; 2] {
    let finite = values.filter(|v| v.is_finite());
    let range = finite.fold(None, |range, v| {
        let [low, high] = range.unwrap_or([v, v]);
        Some([v.min(low), v.max(high)])
    });
    range.unwrap_or_default()
}

/// Pixels of a mm, with as many digits of the pitch as fit.
#[expect(clippy::cast_possible_truncation, reason = "at most u32::MAX")]
fn per_mm(pitch_mm: f64) -> Rational {
    let fits = |n: &u32| f64::from(*n) * pitch_mm <= f64::from(u32::MAX);
    let n = (0..10).rev().map(|digits| 10u32.pow(digits)).find(fits);
    let n = n.unwrap_or(1);
    Rational {
        n,
        d: (f64::from(n) * pitch_mm).round().max(1.0) as u32,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::slices::read_stack;
    use std::io::Cursor;
    use tiff::decoder::{Decoder, DecodingResult};

    fn grid() -> VolumeGrid {
        VolumeGrid::centered([2, 3, 5], 0.25).about([1.0, 2.0, 3.0])
    }

    /// Values from 0 to 1 that all differ.
    fn dose() -> Vec<f32> {
        (0..30).map(|i| i as f32 / 29.0).collect()
    }

    #[test]
    fn pages_are_upright_slices_that_lie_in_a_row() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("dose.tif");
        write(&path, &grid(), Values::F32(&dose()), &Work::new()).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        let mut pages = Decoder::new(Cursor::new(&bytes)).unwrap();
        let text = pages.get_tag_ascii_string(Tag::ImageDescription).unwrap();
        for line in [
            "images=2",
            "spacing=0.25",
            "unit=mm",
            "xorigin=-2",
            "yorigin=9",
            "zorigin=-11.5",
            "max=1",
        ] {
            assert!(text.lines().any(|l| l == line), "{line}: {text}");
        }
        let start = pages.get_tag_u64(Tag::StripOffsets).unwrap();
        let DecodingResult::F32(first) = pages.read_image().unwrap() else {
            panic!("no floats");
        };
        // Row 2 is +y, the top
        assert_eq!(first[..5], dose()[10..15]);
        pages.next_image().unwrap();
        assert_eq!(pages.get_tag_u64(Tag::StripOffsets).unwrap(), start + 60);
        assert!(!pages.more_images());
        let stack = read_stack(&path).unwrap().slices;
        assert_eq!((stack.len(), &stack[1].values[10..]), (2, &dose()[15..20]));
    }

    #[test]
    fn labels_of_odd_size_and_large_files_have_the_same_numbers() {
        let labels: Vec<u8> = (0..30).collect();
        let mut bytes = Cursor::new(Vec::new());
        pages::<_, TiffKindBig>(&mut bytes, &grid(), Values::U8(&labels)).unwrap();
        assert_eq!(bytes.get_ref()[2], 43, "a BigTIFF");
        let mut pages = Decoder::new(Cursor::new(bytes.get_ref())).unwrap();
        pages.next_image().unwrap();
        let DecodingResult::U8(second) = pages.read_image().unwrap() else {
            panic!("no bytes");
        };
        assert_eq!(second[..6], [25, 26, 27, 28, 29, 20]);
    }

    #[test]
    fn pixels_of_a_mm_have_the_digits_of_the_pitch() {
        for (pitch, n, d) in [
            (0.05, 1_000_000_000, 50_000_000),
            (1.0 / 3.0, 1_000_000_000, 333_333_333),
            (12.5, 100_000_000, 1_250_000_000),
            (1e12, 1, u32::MAX),
        ] {
            let found = per_mm(pitch);
            assert_eq!((found.n, found.d), (n, d), "{pitch}");
        }
    }
}
