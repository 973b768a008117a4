//! Frames as PNG files, `frames/frame_0000.png` and so on: gray, or RGB with their levels in one [channel](super::channel).
//!
//! Up to 8 bits are stored in 8-bit files, more in 16-bit files. A level q of b bits is stored on the file's own scale,
//! v = q·(2^c − 1)/(2^b − 1) rounded half up (c = 8 or 16), so that white is the full scale in any viewer; q comes back
//! exactly. Each file states in text chunks `tomolith:bits`, `tomolith:full_scale` (the pattern value of white,
//! mJ/mm², as the shortest text that reads back exactly), `tomolith:azimuth_rad` and `tomolith:pitch_mm`.
//! Row 0 of the image is the top (+z), columns grow along (−sin α, cos α, 0).
//!
//! Frames of other programs may be stored as RGB or with a palette, where all colors are gray or the light is in one
//! channel, and with opacity, which does not count. Their names are numbered in any way: `1.png` to `12.png`, `01.png` to `12.png`.
//!
//! With one light the files lie in the folder itself, with several in a sub-folder per light. The folder appears whole.
//!
//! ```
//! use tomolith_core::dose::Work;
//! use tomolith_core::grid::PatternGrid;
//! use tomolith_io::frames::{FrameSet, read_frames, write_frames};
//! let grid = PatternGrid::full_turn(2, 0.0, 1, 2, 0.1);
//! let set = FrameSet { light: None, grid: &grid, bits: 4, full_scale: 3.0, channel: None, values: &[0, 1, 7, 15] };
//! let folder = tempfile::tempdir().unwrap();
//! let frames = folder.path().join("frames");
//! write_frames(&frames, &[set], &Work::new()).unwrap();
//! let read = read_frames(&frames, None).unwrap();
//! assert_eq!((read.shape, read.bits, read.full_scale), ([2, 1, 2], 4, Some(3.0)));
//! assert_eq!(read.values, [0, 1, 7, 15]); // stored as 0, 17, 119, 255: 255/15 = 17 times as much
//! ```

use super::channel::{Channel, Lit, gray_of};
use super::image::png_samples;
use super::series::numbered_files;
use super::whole::{Refused, write_folder_whole, write_whole};
use std::fs::{self, File};
use std::io::{BufRead, BufReader, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};
use tomolith_core::files::open_regular;
use tomolith_core::grid::PatternGrid;
use tomolith_core::parallel::InParallel;
use tomolith_core::units::exact;
use tomolith_core::work::Work;

/// The highest level of a bit depth, 2^bits − 1.
#[must_use]
pub fn top_level(bits: u32) -> u16 {
    u16::try_from((1u32 << bits.min(16)) - 1).unwrap_or(u16::MAX)
}

/// A level of `from` bits on a scale of `to` bits, rounded half up; exactly undone by the way back when `to` is not
/// smaller.
#[must_use]
pub fn rescale(level: u16, from: u32, to: u32) -> u16 {
    let (top, new_top) = (u64::from(top_level(from)), u64::from(top_level(to)));
    let scaled = (2 * u64::from(level) * new_top + top) / (2 * top);
    u16::try_from(scaled).unwrap_or(u16::MAX)
}

/// The frames of one light, to be written.
#[derive(Clone, Copy, Debug)]
pub struct FrameSet<'a> {
    /// Name of the light, when there are several.
    pub light: Option<&'a str>,
    /// Which pixel is where.
    pub grid: &'a PatternGrid,
    /// Bit depth, 1…16.
    pub bits: u32,
    /// The pattern value of the highest level, mJ/mm².
    pub full_scale: f32,
    /// The channel of color images that shows the levels; images are gray without.
    pub channel: Option<Channel>,
    /// Levels 0…2^bits − 1, `[angle, row, column]`.
    pub values: &'a [u16],
}

impl FrameSet<'_> {
    /// The levels of one frame, `[row, column]`, on a scale of `bits` bits.
    pub fn levels(&self, frame: usize, bits: u32) -> impl Iterator<Item = u16> {
        let size = self.grid.rows * self.grid.columns;
        let from = self.bits;
        self.values[frame * size..(frame + 1) * size]
            .iter()
            .map(move |&level| rescale(level, from, bits))
    }

    /// Whether levels and grid fit.
    pub(crate) fn check(&self) -> Result<()> {
        if self.values.len() == self.grid.len() {
            return Ok(());
        }
        Err(Error::shape(
            "levels of frames",
            self.grid.shape(),
            vec![self.values.len()],
        ))
    }
}

#[cfg(test)]
impl<'a> FrameSet<'a> {
    /// Frames of the only light, with a white of 1 mJ/mm².
    pub(crate) fn of(grid: &'a PatternGrid, bits: u32, values: &'a [u16]) -> Self {
        FrameSet {
            light: None,
            grid,
            bits,
            full_scale: 1.0,
            channel: None,
            values,
        }
    }
}

/// Frames read back.
#[derive(Clone, Debug, PartialEq)]
pub struct Frames {
    /// `[frames, rows, columns]`.
    pub shape: [usize; 3],
    /// Bit depth of the levels: as stated in the files, else the depth of the files.
    pub bits: u32,
    /// The pattern value of the highest level, when the files state it.
    pub full_scale: Option<f32>,
    /// Levels 0…2^bits − 1, `[angle, row, column]`.
    pub values: Vec<u16>,
}

/// Writes all frames of all lights into `folder`; a light without name goes into the folder itself.
///
/// # Errors
/// [`Error::Shape`] when levels and grid do not fit, [`Error::Io`]; `folder` is then as it was.
pub fn write_frames(folder: &Path, lights: &[FrameSet<'_>], work: &Work) -> Result<()> {
    let frames = work.steps(lights.iter().map(|set| set.grid.frames()).sum());
    for set in lights {
        set.check()?;
    }
    write_folder_whole(folder, |aside| {
        for set in lights {
            let place = set
                .light
                .map_or_else(|| aside.to_owned(), |name| aside.join(name));
            fs::create_dir_all(&place)?;
            let write = |frame: usize| -> Result<(), Refused> {
                work.check()?;
                frames.add(1);
                let path = place.join(format!("frame_{frame:04}.png"));
                Ok(write_frame(&path, set, frame)?)
            };
            let written = (0..set.grid.frames()).par_map(write);
            written.into_iter().collect::<Result<(), Refused>>()?;
        }
        Ok(())
    })
}

/// Writes the first frame of a set as a file.
///
/// # Errors
/// As [`write_frames`].
pub fn write_picture(path: &Path, set: &FrameSet<'_>) -> Result<()> {
    set.check()?;
    write_whole(path, |file| Ok(encode(file, set, 0)?))
}

fn write_frame(path: &Path, set: &FrameSet<'_>, frame: usize) -> std::io::Result<()> {
    encode(BufWriter::new(File::create(path)?), set, frame)
}

/// One frame as a PNG file.
pub(super) fn encode(file: impl Write, set: &FrameSet<'_>, frame: usize) -> std::io::Result<()> {
    let grid = set.grid;
    let wide = set.bits > 8;
    let mut encoder = png::Encoder::new(file, grid.columns as u32, grid.rows as u32);
    encoder.set_color(match set.channel {
        Some(_) => png::ColorType::Rgb,
        None => png::ColorType::Grayscale,
    });
    encoder.set_depth(if wide {
        png::BitDepth::Sixteen
    } else {
        png::BitDepth::Eight
    });
    encoder.set_compression(png::Compression::Fast);
    let [u, z] = grid.pitch_mm;
    let pitch = grid
        .square_pitch_mm()
        .map_or_else(|| format!("{u} {z}"), |pitch| pitch.to_string());
    for (key, text) in [
        ("bits", set.bits.to_string()),
        ("full_scale", set.full_scale.to_string()),
        ("azimuth_rad", grid.azimuths[frame].to_string()),
        ("pitch_mm", pitch),
    ] {
        encoder.add_text_chunk(format!("tomolith:{key}"), text)?;
    }
    let mut writer = encoder.write_header()?;
    let levels = set.levels(frame, if wide { 16 } else { 8 });
    let numbers: Vec<u16> = match set.channel {
        Some(channel) => levels.flat_map(|level| channel.color(level)).collect(),
        None => levels.collect(),
    };
    let bytes: Vec<u8> = if wide {
        numbers.into_iter().flat_map(u16::to_be_bytes).collect()
    } else {
        numbers.into_iter().map(|v| v as u8).collect()
    };
    writer.write_image_data(&bytes)?;
    writer.finish()?;
    Ok(())
}

/// Reads the frames of one light: all `*.png` of a folder, in the order of [their numbers](super::series). Of colored ones it
/// takes `channel`, else the only one that is lit.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] when there is no frame, their order is in doubt, a file is no PNG of the same size, depth and
/// scale as the first one, or nothing says which channel of its light counts.
pub fn read_frames(folder: &Path, channel: Option<Channel>) -> Result<Frames> {
    let paths = numbered_files(folder, "*", &["png"])?;
    let images: Vec<Image> = paths
        .iter()
        .par_map(|path| read_frame(path, channel))
        .into_iter()
        .collect::<Result<_>>()?;
    if images.is_empty() {
        return Err(format_error(folder, "no frame"));
    }
    together(images, |i| paths[i].clone())
}

/// Frames that are alike as one array; `place` names the file of one of them.
pub(super) fn together(images: Vec<Image>, place: impl Fn(usize) -> PathBuf) -> Result<Frames> {
    let first = images.first().map(Image::kind).unwrap_or_default();
    if let Some(odd) = images.iter().position(|image| image.kind() != first) {
        let found = format!(
            "{}; the first frame has {}",
            images[odd].words(),
            images[0].words()
        );
        return Err(format_error(&place(odd), &found));
    }
    one_light(&images).map_err(|(odd, found)| format_error(&place(odd), &found))?;
    let ([rows, columns], bits, full_scale) = first;
    Ok(Frames {
        shape: [images.len(), rows, columns],
        bits,
        full_scale,
        values: images.into_iter().flat_map(|image| image.values).collect(),
    })
}

/// Refuses frames with light in different channels, and frames with none in the channel that was asked for.
fn one_light(images: &[Image]) -> Result<(), (usize, String)> {
    let lights = || {
        images
            .iter()
            .enumerate()
            .filter_map(|(i, image)| Some((i, image.lit?)))
    };
    let counts = |(_, lit): &(usize, Lit)| !matches!(lit, Lit::Without(_));
    match (lights().find(counts), lights().next()) {
        (Some((_, first)), _) => match lights().filter(counts).find(|(_, lit)| *lit != first) {
            Some((odd, lit)) => Err((odd, format!("{lit}; the first lit frame has {first}"))),
            None => Ok(()),
        },
        (None, Some((without, lit))) => Err((without, lit.to_string())),
        (None, None) => Ok(()),
    }
}

fn format_error(path: &Path, found: &str) -> Error {
    Error::format(
        path,
        found,
        "PNG frames of one size and bit depth, gray or with light in one channel; of several, the one that printer.channel names",
    )
}

pub(super) struct Image {
    size: [usize; 2],
    bits: u32,
    full_scale: Option<f32>,
    lit: Option<Lit>,
    values: Vec<u16>,
}

impl Image {
    /// What all frames must have in common: rows and columns, bits, white.
    fn kind(&self) -> ([usize; 2], u32, Option<f32>) {
        (self.size, self.bits, self.full_scale)
    }

    fn words(&self) -> String {
        let [rows, columns] = self.size;
        let white = self.full_scale.map_or_else(
            || "no stated white".to_owned(),
            |white| format!("white {}", exact(white)),
        );
        format!("{columns} × {rows} pixels of {} bits, {white}", self.bits)
    }
}

fn read_frame(path: &Path, channel: Option<Channel>) -> Result<Image> {
    let file = open_regular(path)?;
    decode(BufReader::new(file), channel).map_err(|trouble| match trouble {
        Trouble::Io(source) => Error::io(path, source),
        Trouble::Said(found) => format_error(path, &found),
    })
}

/// Why there is no frame.
pub(super) enum Trouble {
    Io(std::io::Error),
    Said(String),
}

impl From<png::DecodingError> for Trouble {
    fn from(error: png::DecodingError) -> Self {
        match error {
            png::DecodingError::IoError(source) => Trouble::Io(source),
            other => Trouble::Said(other.to_string()),
        }
    }
}

/// A PNG file as a frame.
pub(super) fn decode(
    file: impl BufRead + Seek,
    channel: Option<Channel>,
) -> Result<Image, Trouble> {
    let mut decoder = png::Decoder::new(file);
    // Palettes become colors, and fewer than 8 bits become 8
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info()?;
    if let Some(animation) = reader.info().animation_control() {
        let frames = animation.num_frames;
        return Err(Trouble::Said(format!(
            "an animated PNG (APNG) of {frames} frames"
        )));
    }
    let (shape, samples) = png_samples(&mut reader)?;
    reader.finish()?;
    let depth = shape.bit_depth as u32;
    let (values, lit) =
        gray_of(&samples, shape.color_type.samples(), channel).map_err(|(channels, at)| {
            let (row, column) = (at / shape.width as usize, at % shape.width as usize);
            let place = format!("the first colored pixel is in row {row}, column {column}");
            Trouble::Said(format!("light in {channels} ({place})"))
        })?;
    let text = |key: &str| {
        reader
            .info()
            .uncompressed_latin1_text
            .iter()
            .find(|chunk| chunk.keyword == format!("tomolith:{key}"))
            .map(|chunk| chunk.text.as_str())
    };
    let bits = text("bits")
        .and_then(|t| t.parse().ok())
        .filter(|bits| (1..=depth).contains(bits))
        .unwrap_or(depth);
    Ok(Image {
        size: [shape.height as usize, shape.width as usize],
        bits,
        full_scale: text("full_scale")
            .and_then(|t| t.parse().ok())
            .filter(|s: &f32| s.is_finite() && *s >= 0.0),
        lit,
        values: values
            .into_iter()
            .map(|v| rescale(v, depth, bits))
            .collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn waves(bits: u32) -> (PatternGrid, Vec<u16>) {
        let grid = PatternGrid::full_turn(11, 0.3, 7, 9, 0.02);
        let top = f32::from(top_level(bits));
        let level = |i: usize| ((0.5 + 0.5 * (i as f32 * 0.37).sin()) * top).round() as u16;
        let values = (0..grid.len()).map(level).collect();
        (grid, values)
    }

    #[test]
    fn levels_and_scale_come_back_bit_for_bit_at_any_depth() {
        let folder = tempfile::tempdir().unwrap();
        for bits in [1, 4, 8, 10, 12, 16] {
            let (grid, values) = waves(bits);
            let set = FrameSet {
                full_scale: 0.1234,
                ..FrameSet::of(&grid, bits, &values)
            };
            let place = folder.path().join("frames");
            write_frames(&place, &[set], &Work::new()).unwrap();
            let read = read_frames(&place, None).unwrap();
            assert_eq!(read.shape, [11, 7, 9]);
            assert_eq!((read.bits, read.full_scale), (bits, Some(0.1234)));
            assert_eq!(read.values, values, "{bits} bits");
            assert!(place.join("frame_0010.png").is_file());
        }
    }

    /// The numbers of a written frame, and how they are stored.
    fn stored(path: &Path) -> (png::ColorType, png::BitDepth, Vec<u8>) {
        let file = BufReader::new(File::open(path).unwrap());
        let mut reader = png::Decoder::new(file).read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let shape = reader.next_frame(&mut bytes).unwrap();
        (shape.color_type, shape.bit_depth, bytes)
    }

    #[test]
    fn a_channel_holds_the_levels_and_the_others_are_black() {
        let folder = tempfile::tempdir().unwrap();
        let (gray, colored) = (folder.path().join("gray"), folder.path().join("colored"));
        for bits in [1, 8] {
            let (grid, mut values) = waves(bits);
            values[..7 * 9].fill(0); // a dark frame has no channel
            let set = FrameSet::of(&grid, bits, &values);
            write_frames(&gray, &[set], &Work::new()).unwrap();
            let (kind, depth, levels) = stored(&gray.join("frame_0003.png"));
            assert_eq!(
                (kind, depth),
                (png::ColorType::Grayscale, png::BitDepth::Eight)
            );
            for (place, channel) in Channel::ALL.into_iter().enumerate() {
                let channel = Some(channel);
                let set = FrameSet { channel, ..set };
                write_frames(&colored, &[set], &Work::new()).unwrap();
                let (kind, depth, numbers) = stored(&colored.join("frame_0003.png"));
                assert_eq!((kind, depth), (png::ColorType::Rgb, png::BitDepth::Eight));
                for (pixel, level) in numbers.chunks(3).zip(&levels) {
                    let mut expected = [0; 3];
                    expected[place] = *level;
                    assert_eq!(pixel, expected);
                }
                let frames = read_frames(&gray, None).unwrap();
                assert_eq!(frames.values, values);
                for asked in [None, channel] {
                    assert_eq!(read_frames(&colored, asked).unwrap(), frames);
                    assert_eq!(read_frames(&gray, asked).unwrap(), frames);
                }
                let other = Channel::ALL[(place + 1) % 3];
                let text = read_frames(&colored, Some(other)).unwrap_err().to_string();
                let found = format!("light, but none of it {}", other.name());
                tomolith_core::contains!(text, "frame_0001.png", &found, "printer.channel");
            }
        }
    }

    #[test]
    fn of_light_in_several_channels_the_one_that_is_asked_for_counts() {
        let folder = tempfile::tempdir().unwrap();
        let save = |name: &str, pixels: [[u8; 3]; 2]| {
            let file = File::create(folder.path().join(name)).unwrap();
            let mut encoder = png::Encoder::new(file, 2, 1);
            encoder.set_color(png::ColorType::Rgb);
            let mut writer = encoder.write_header().unwrap();
            writer.write_image_data(pixels.as_flattened()).unwrap();
        };
        let read = |asked| read_frames(folder.path(), asked).map(|frames| frames.values);
        let refused = || read(None).unwrap_err().to_string();
        save("1.png", [[0, 0, 0], [9, 0, 5]]);
        save("2.png", [[0, 0, 7], [0, 0, 0]]);
        let place = "1.png: light in red and blue (the first colored pixel is in row 0, column 1)";
        tomolith_core::contains!(refused(), place, "accepted: PNG frames");
        assert_eq!(read(Some(Channel::Red)).unwrap(), [0, 9, 0, 0]);
        assert_eq!(read(Some(Channel::Blue)).unwrap(), [0, 5, 7, 0]);
        // One channel in each, but not the same
        save("1.png", [[0, 0, 0], [9, 0, 0]]);
        let found = "2.png: blue light; the first lit frame has red light";
        tomolith_core::contains!(refused(), found);
        save("2.png", [[7, 7, 7], [0, 0, 0]]);
        tomolith_core::contains!(refused(), "2.png: gray light");
        assert_eq!(read(Some(Channel::Red)).unwrap(), [0, 9, 7, 0]);
    }

    #[test]
    fn several_lights_have_folders_of_their_own() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("frames");
        let (grid, values) = waves(8);
        let lights = [("blue", 1.0), ("uv", 3.0)].map(|(name, full_scale)| FrameSet {
            light: Some(name),
            full_scale,
            ..FrameSet::of(&grid, 8, &values)
        });
        write_frames(&place, &lights, &Work::new()).unwrap();
        let uv = read_frames(&place.join("uv"), None).unwrap();
        assert_eq!(uv.full_scale, Some(3.0));
        assert_eq!(
            read_frames(&place.join("blue"), None).unwrap().values,
            values
        );
    }

    #[test]
    fn odd_frames_out_and_truncated_files_are_named() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, bits: u32| {
            let (place, (grid, values)) = (folder.path().join(name), waves(bits));
            let set = FrameSet::of(&grid, bits, &values);
            write_frames(&place, &[set], &Work::new()).unwrap();
            place
        };
        let place = write("frames", 8);
        let third = place.join("frame_0003.png");
        let bytes = fs::read(&third).unwrap();
        fs::write(&third, &bytes[..bytes.len() / 2]).unwrap();
        let text = read_frames(&place, None).unwrap_err().to_string();
        assert!(text.contains("frame_0003.png"), "{text}");
        fs::copy(write("other", 12).join("frame_0003.png"), &third).unwrap();
        let text = read_frames(&place, None).unwrap_err().to_string();
        tomolith_core::contains!(text, "frame_0003.png", "12 bits");
        let empty = folder.path().join("empty");
        fs::create_dir(&empty).unwrap();
        assert!(matches!(
            read_frames(&empty, None),
            Err(Error::Format { .. })
        ));
    }

    #[test]
    fn a_finer_scale_can_be_undone() {
        for bits in 1..=16 {
            for to in bits..=16 {
                for level in 0..=top_level(bits) {
                    assert_eq!(rescale(rescale(level, bits, to), to, bits), level);
                }
            }
        }
        assert_eq!(rescale(255, 8, 16), 65535);
        // 255/15 = 17 times as much
        assert_eq!(
            [0, 1, 7, 15].map(|level| rescale(level, 4, 8)),
            [0, 17, 119, 255]
        );
    }
}
