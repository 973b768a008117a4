//! All frames as one array: `frames.npz`, as the memories of fast light modulators (ALP and the like) take them.
//!
//! | array | type | meaning |
//! |---|---|---|
//! | `frames` | u8 up to 8 bits, else u16, `[frame, row, column]` | levels on the full scale of the type: 255 or 65535 is white |
//! | `bits` | i64, one number | the bit depth that the levels stand for |
//! | `full_scale` | f64, one number | the pattern value of white, mJ/mm² (relative like all doses) |
//! | `azimuth_rad` | f64, per frame | from where the light of the frame arrives in the resin frame |
//! | `pitch_mm` | f64, one number, or [right, up] where they differ | size of a pixel at the vial |
//!
//! With several lights every name ends in `_` and the name of the light. In Python `numpy.load("frames.npz")["frames"]` is
//! ready to be sent.
//!
//! ```
//! use tomolith_core::dose::Work;
//! use tomolith_core::grid::PatternGrid;
//! use tomolith_io::frames::FrameSet;
//! use tomolith_io::stack::{read_stack, write_stack};
//! let grid = PatternGrid::full_turn(2, 0.0, 1, 2, 0.1);
//! let set = FrameSet { light: None, grid: &grid, bits: 4, full_scale: 3.0, channel: None, values: &[0, 1, 7, 15] };
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("frames.npz");
//! write_stack(&path, &[set], &Work::new()).unwrap();
//! let read = read_stack(&path, None).unwrap();
//! assert_eq!((read.shape, read.bits, read.full_scale), ([2, 1, 2], 4, Some(3.0)));
//! assert_eq!(read.values, [0, 1, 7, 15]);
//! ```

use super::frames::{FrameSet, Frames, rescale};
use super::npz::ArchiveWriter;
use super::numbers::{Archive, Kind};
use super::whole::write_whole_under;
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::work::Work;

fn name_of(what: &str, light: Option<&str>) -> String {
    light.map_or_else(|| what.to_owned(), |light| format!("{what}_{light}"))
}

/// Writes the frames of all lights; see the [module page](self).
///
/// # Errors
/// [`Error::Shape`] when levels and grid do not fit, [`Error::Io`].
pub fn write_stack(path: &Path, lights: &[FrameSet<'_>], work: &Work) -> Result<()> {
    for set in lights {
        set.check()?;
    }
    write_whole_under(path, work, 0, |file| {
        let mut npz = ArchiveWriter::new(file);
        for set in lights {
            let name = |what| name_of(what, set.light);
            let shape = set.grid.shape();
            let depth = if set.bits > 8 { 16 } else { 8 };
            let levels = set
                .values
                .iter()
                .map(|&level| rescale(level, set.bits, depth));
            if depth == 8 {
                let levels: Vec<u8> = levels.map(|level| level as u8).collect();
                npz.add(&name("frames"), &shape, &levels)?;
            } else {
                npz.add(&name("frames"), &shape, &levels.collect::<Vec<u16>>())?;
            }
            npz.add(&name("bits"), &[1], &[i64::from(set.bits)])?;
            npz.add(&name("full_scale"), &[1], &[f64::from(set.full_scale)])?;
            let azimuths = &set.grid.azimuths;
            npz.add(&name("azimuth_rad"), &[azimuths.len()], azimuths)?;
            let pitch = set.grid.square_pitch_mm();
            let pitch = pitch.map_or_else(|| set.grid.pitch_mm.to_vec(), |pitch| vec![pitch]);
            npz.add(&name("pitch_mm"), &[pitch.len()], &pitch)?;
        }
        Ok(npz.finish()?)
    })
}

/// Reads the frames of one light.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] when the file is no such stack or holds no frames
/// of this light.
pub fn read_stack(path: &Path, light: Option<&str>) -> Result<Frames> {
    const ACCEPTED: &str =
        "an .npz with `frames`, u8 or u16 [frame, row, column], and its `bits` and `full_scale`";
    let mut npz = Archive::open(path, ACCEPTED)?;
    let name = name_of("frames", light);
    let frames = npz.numbers(&name)?;
    let refuse = |found: String| Error::format(path, format!("{name}: {found}"), ACCEPTED);
    let Kind::Unsigned(bytes @ 1..=2) = frames.kind else {
        return Err(refuse("numbers of another type".to_owned()));
    };
    let depth = 8 * bytes as u32;
    let (shape, values) = frames.of_dimensions().map_err(refuse)?;
    let mut number = |what| {
        let numbers = npz.numbers(&name_of(what, light)).ok()?;
        numbers.values.first().copied()
    };
    let bits = number("bits").map(|bits| bits as u32);
    let bits = bits.filter(|bits| (1..=depth).contains(bits));
    let bits = bits.unwrap_or(depth);
    let level = |&level: &f32| rescale(level as u16, depth, bits);
    Ok(Frames {
        shape,
        bits,
        full_scale: number("full_scale"),
        values: values.iter().map(level).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frames::top_level;
    use ndarray::Array3;
    use ndarray_npy::NpzReader;
    use std::fs::File;
    use tomolith_core::grid::PatternGrid;

    #[test]
    fn stacks_of_several_lights_and_depths_come_back() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frames.npz");
        let grid = PatternGrid::full_turn(5, 0.0, 3, 7, 0.1);
        let levels = |bits| -> Vec<u16> {
            let level = |i: usize| (i * 37) as u16 % (top_level(bits) + 1);
            (0..grid.len()).map(level).collect()
        };
        let (blue, uv) = (levels(8), levels(12));
        let lights = [("blue", 8, &blue), ("uv", 12, &uv)].map(|(name, bits, values)| FrameSet {
            light: Some(name),
            full_scale: 0.3,
            ..FrameSet::of(&grid, bits, values)
        });
        write_stack(&path, &lights, &Work::new()).unwrap();
        let read = read_stack(&path, Some("uv")).unwrap();
        assert_eq!((read.bits, read.shape, &read.values), (12, [5, 3, 7], &uv));
        assert_eq!(read.full_scale, Some(0.3));
        assert_eq!(read_stack(&path, Some("blue")).unwrap().values, blue);
        let text = read_stack(&path, None).unwrap_err().to_string();
        assert!(text.contains("frames"), "{text}");
        // What a reader in another language sees
        let mut npz = NpzReader::new(File::open(&path).unwrap()).unwrap();
        let bytes: Array3<u8> = npz.by_name("frames_blue").unwrap();
        assert!(bytes.iter().map(|&b| u16::from(b)).eq(blue));
    }
}
