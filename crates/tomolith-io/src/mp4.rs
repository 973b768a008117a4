//! The frames as an H.264 movie, and the check of what a decoder makes of it.
//!
//! # What is written
//! MP4 with one H.264 track (OpenH264 through the crate `openh264`, put together by `muxide`). Every frame of the
//! sequence appears once, as a key frame of its own: nothing depends on the frame before, so a player may start, seek
//! and loop anywhere, and errors do not add up. The quantizer is 12, the lowest that OpenH264 accepts. All parts of one
//! movie are encoded independently in fixed groups, so the file does not depend on the number of threads.
//!
//! # Gray values
//! Levels are brought to 8 bits (0…255, rounded half up). The luma *is* the gray value: full range 0…255, and the
//! stream says so (`video_full_range_flag` = 1, BT.709); chroma is 128 everywhere. Squeezing into the limited range
//! 16…235 would merge 36 of 256 levels, that is errors up to half a level before any coding. A player that ignores
//! the flag shows everything below 16 as black and above 235 as white; the PNG frames are the reference then.
//!
//! # Size
//! H.264 at 4:2:0 needs even counts and OpenH264 at least 16 pixels: a row or column is added at the bottom or right
//! in black where needed ([`padded`]). Larger than 3840 × 2160 (or 2160 × 3840) is refused.
//!
//! # How good it is
//! [`check_movie`] reads the file back, decodes it and compares every pixel with the frames: largest and rms gray error, in levels of 0…255. Smooth patterns come out within ±2, full-contrast noise
//! within about ±6, rms 0.6.
//!
//! # Timing
//! Times are in units of 1/90,000 s and each frame's start is rounded on its own, so rounding does not add up. A movie of a single frame lasts one unit.
//!
//! ```
//! use tomolith_core::dose::Work;
//! use tomolith_core::grid::PatternGrid;
//! use tomolith_io::frames::FrameSet;
//! use tomolith_io::mp4::{check_movie, write_movie};
//! let grid = PatternGrid::full_turn(4, 0.0, 30, 31, 0.02);
//! let values: Vec<u16> = (0..grid.len()).map(|i| (i % 31 * 8) as u16).collect(); // a ramp from left to right
//! let set = FrameSet { light: None, grid: &grid, bits: 8, full_scale: 1.0, channel: None, values: &values };
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("ramp_12rpm.mp4");
//! write_movie(&path, &set, 60.0, &Work::new()).unwrap();
//! let check = check_movie(&path, &set, &Work::new()).unwrap();
//! assert_eq!((check.frames, check.width, check.height), (4, 32, 30)); // one black column was added
//! assert!((check.frame_rate - 60.0).abs() < 1e-6);
//! assert!(check.largest_error <= 6 && check.rms_error < 1.0);
//! ```

use super::frames::FrameSet;
use super::movie::h264::{each_image, groups, message_of};
use super::movie::track::Track;
use super::whole::{Refused, write_whole_under};
use muxide::api::{MuxerBuilder, VideoCodec};
use openh264::OpenH264API;
use openh264::encoder::{
    BitRate, Complexity, Encoder, EncoderConfig, FrameRate, IntraFramePeriod, QpRange,
    RateControlMode, VuiConfig,
};
use openh264::formats::{YUVBuffer, YUVSource};
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::parallel::InParallel;
use tomolith_core::work::{Steps, Work};

/// The lowest quantizer of OpenH264 (0 would be lossless, 51 is the coarsest).
const QUANTIZER: u8 = 12;

/// What a decoder makes of a movie.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct MovieCheck {
    /// Frames in the file.
    pub frames: usize,
    /// Frames a second, mean over the file.
    pub frame_rate: f64,
    /// Columns, padding included.
    pub width: usize,
    /// Rows, padding included.
    pub height: usize,
    /// Size of the file.
    pub bytes: u64,
    /// Largest |decoded − frame| over all pixels, in levels of 0…255.
    pub largest_error: u8,
    /// Root mean square of the same.
    pub rms_error: f64,
}

/// Writes the frames of one light as a movie; see the [module page](self).
///
/// # Errors
/// [`Error::Config`] for an impossible frame rate, [`Error::Unsupported`] for no frames or too large ones,
/// [`Error::Shape`], [`Error::Io`], [`Error::Format`] when the encoder refuses.
pub fn write_movie(path: &Path, set: &FrameSet<'_>, frame_rate: f64, work: &Work) -> Result<()> {
    set.check()?;
    if !(frame_rate.is_finite() && frame_rate > 0.0 && frame_rate <= 10_000.0) {
        return Err(Error::config(
            "output.rpm",
            format!("a movie of {frame_rate} frames a second"),
            "a rate > 0 and at most 10,000 frames a second",
        ));
    }
    let (width, height) = padded_size(set)?;
    let steps = work.steps(set.grid.frames());
    let groups: Vec<Vec<Vec<u8>>> = groups(set.grid.frames())
        .into_iter()
        .par_map(|group| encode(set, group, [width, height], frame_rate, &steps))
        .into_iter()
        .collect::<Result<_, String>>()
        .map_err(|message| {
            work.check()
                .err()
                .unwrap_or_else(|| refused(path, &message))
        })?;
    write_whole_under(path, &work.aside(), 0, |file| {
        let mux = |message: String| Refused::Io(std::io::Error::other(message));
        let mut muxer = MuxerBuilder::new(file)
            .video(VideoCodec::H264, width as u32, height as u32, frame_rate)
            .build()
            .map_err(|e| mux(e.to_string()))?;
        for (i, packet) in groups.iter().flatten().enumerate() {
            muxer
                .write_video(i as f64 / frame_rate, packet, true)
                .map_err(|e| mux(e.to_string()))?;
        }
        muxer.finish().map_err(|e| mux(e.to_string()))
    })
}

fn refused(path: &Path, found: &str) -> Error {
    Error::format(
        path,
        found,
        "frames that OpenH264 can encode, and the movie as it was written",
    )
}

/// Pixels of a movie along a side of frames with `n` pixels: even, at least 16.
#[must_use]
pub fn padded(n: usize) -> usize {
    n.next_multiple_of(2).max(16)
}

/// Columns and rows of a movie, at most what OpenH264 takes.
fn padded_size(set: &FrameSet<'_>) -> Result<(usize, usize)> {
    let (width, height) = (padded(set.grid.columns), padded(set.grid.rows));
    if set.grid.is_empty() || width.max(height) > 3840 || width.min(height) > 2160 {
        return Err(Error::unsupported(
            format!(
                "a movie of {} frames of {}×{} pixels",
                set.grid.frames(),
                set.grid.columns,
                set.grid.rows
            ),
            "H.264 movies need at least one frame and at most 3840×2160 or 2160×3840 pixels",
        ));
    }
    Ok((width, height))
}

/// One packet a frame.
fn encode(
    set: &FrameSet<'_>,
    group: std::ops::Range<usize>,
    [width, height]: [usize; 2],
    frame_rate: f64,
    steps: &Steps<'_>,
) -> Result<Vec<Vec<u8>>, String> {
    // The quantizer is fixed, so the bit rate decides nothing but the level that the stream claims to need
    let bits_a_second = (4.0 * (width * height) as f64 * frame_rate).clamp(1e5, 2e8);
    let config = EncoderConfig::new()
        .rate_control_mode(RateControlMode::Bufferbased)
        .qp(QpRange::new(QUANTIZER, QUANTIZER))
        .bitrate(BitRate::from_bps(bits_a_second as u32))
        .max_frame_rate(FrameRate::from_hz(frame_rate.clamp(1.0, 60.0) as f32))
        .intra_frame_period(IntraFramePeriod::from_num_frames(1))
        .complexity(Complexity::High)
        .skip_frames(false)
        .scene_change_detect(false)
        .adaptive_quantization(false)
        .background_detection(false)
        .num_threads(1)
        .vui(VuiConfig::bt709_full());
    let mut encoder =
        Encoder::with_api_config(OpenH264API::from_source(), config).map_err(|e| message_of(&e))?;
    // Three planes of a gray image in 4:2:0: luma, then chroma
    let (mut planes, columns) = (vec![128; width * height * 3 / 2], set.grid.columns);
    planes[..width * height].fill(0);
    group
        .map(|frame| {
            steps.add(1);
            if steps.is_canceled() {
                return Err("canceled".to_owned());
            }
            for (i, level) in set.levels(frame, 8).enumerate() {
                planes[i / columns * width + i % columns] = level as u8;
            }
            let packet = encoder
                .encode(&YUVBuffer::from_vec(planes.clone(), width, height))
                .map_err(|e| format!("OpenH264 refuses frame {frame} ({})", message_of(&e)))?
                .to_vec();
            if packet.is_empty() {
                return Err(format!("the encoder left out frame {frame}"));
            }
            Ok(packet)
        })
        .collect()
}

/// Reads a movie that [`write_movie`] wrote, decodes it and compares it with its frames.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] when the file is damaged, has another number or size of frames, or cannot be
/// decoded.
pub fn check_movie(path: &Path, set: &FrameSet<'_>, work: &Work) -> Result<MovieCheck> {
    set.check()?;
    let file = std::fs::read(path).map_err(|e| Error::io(path, e))?;
    let damaged = |message: &str| refused(path, message);
    let track = Track::find(&file).ok_or_else(|| damaged("no H.264 track can be found in it"))?;
    if track.samples.len() != set.grid.frames() {
        return Err(damaged(&format!(
            "{} frames instead of {}",
            track.samples.len(),
            set.grid.frames()
        )));
    }
    let size = padded_size(set)?;
    let steps = work.steps(track.samples.len());
    let sums: Vec<(u8, u64)> = groups(track.samples.len())
        .into_iter()
        .par_map(|group| compare(&track, group, set, size, &steps))
        .into_iter()
        .collect::<Result<_, String>>()
        .map_err(|message| work.check().err().unwrap_or_else(|| damaged(&message)))?;
    let squares: u64 = sums.iter().map(|s| s.1).sum();
    Ok(MovieCheck {
        frames: track.samples.len(),
        frame_rate: track.frame_rate(),
        width: size.0,
        height: size.1,
        bytes: file.len() as u64,
        largest_error: sums.iter().map(|s| s.0).max().unwrap_or(0),
        rms_error: (squares as f64 / set.grid.len() as f64).sqrt(),
    })
}

/// Largest error and sum of squared errors of a group of frames.
fn compare(
    track: &Track<'_>,
    group: std::ops::Range<usize>,
    set: &FrameSet<'_>,
    size: (usize, usize),
    steps: &Steps<'_>,
) -> Result<(u8, u64), String> {
    let (mut largest, mut squares) = (0, 0);
    each_image(track, group, |frame, image| {
        steps.add(1);
        if steps.is_canceled() {
            return Err("canceled".to_owned());
        }
        if image.dimensions() != size {
            return Err(format!("frame {frame} has {:?} pixels", image.dimensions()));
        }
        let (stride, columns) = (image.strides().0, set.grid.columns);
        for (i, level) in set.levels(frame, 8).enumerate() {
            let error = image.y()[i / columns * stride + i % columns].abs_diff(level as u8);
            largest = largest.max(error);
            squares += u64::from(error) * u64::from(error);
        }
        Ok(())
    })?;
    Ok((largest, squares))
}

#[cfg(test)]
mod tests {
    use super::super::frames::top_level;
    use super::super::movie::read_movie;
    use super::*;
    use tomolith_core::grid::PatternGrid;

    fn movie(
        frames: usize,
        rows: usize,
        columns: usize,
        bits: u32,
        level: impl Fn(usize, usize, usize) -> f64,
    ) -> (PatternGrid, Vec<u16>) {
        let grid = PatternGrid::full_turn(frames, 0.0, rows, columns, 0.02);
        let top = f64::from(top_level(bits));
        let mut values = Vec::with_capacity(grid.len());
        for k in 0..frames {
            for r in 0..rows {
                for c in 0..columns {
                    values.push((level(k, r, c).clamp(0.0, 1.0) * top).round() as u16);
                }
            }
        }
        (grid, values)
    }

    fn write_and_check(grid: &PatternGrid, bits: u32, values: &[u16], rate: f64) -> MovieCheck {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("m.mp4");
        let set = FrameSet::of(grid, bits, values);
        write_movie(&path, &set, rate, &Work::new()).unwrap();
        check_movie(&path, &set, &Work::new()).unwrap()
    }

    #[test]
    fn every_frame_comes_back_once_with_a_small_error() {
        // A blob that turns round, like a pattern; the whole range of gray is used
        let (grid, values) = movie(37, 61, 83, 12, |k, r, c| {
            let (x, y) = ((c as f64 - 41.0) / 20.0, (r as f64 - 30.0) / 20.0);
            let turn = k as f64 / 37.0 * std::f64::consts::TAU;
            (0.5 + 0.7 * (3.0 * x + turn).sin() * (2.0 * y).cos())
                * f64::from(u8::from(x * x + y * y < 2.0))
        });
        let check = write_and_check(&grid, 12, &values, 44.4);
        assert_eq!((check.frames, check.width, check.height), (37, 84, 62));
        assert!((check.frame_rate - 44.4).abs() < 44.4 * 1e-3, "{check:?}");
        assert!(
            check.largest_error >= 1 && check.largest_error <= 5,
            "{check:?}"
        );
        assert!(check.rms_error < 0.6, "{check:?}");
    }

    #[test]
    fn a_movie_is_read_back_in_order_without_its_padding() {
        let (grid, values) = movie(20, 17, 33, 8, |k, r, c| {
            (k * 5 + r * 4 + c * 2) as f64 / 255.0
        });
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("m.mp4");
        let set = FrameSet::of(&grid, 8, &values);
        write_movie(&path, &set, 30.0, &Work::new()).unwrap();
        let read = read_movie(&path, [20, 17, 33], None).unwrap();
        assert_eq!(read.shape, [20, 17, 33]);
        for (found, expected) in read.values.iter().zip(&values) {
            assert!(found.abs_diff(*expected) <= 4, "{found} {expected}");
        }
        assert!(read_movie(&path, [20, 17, 40], None).is_err());
    }

    #[test]
    fn black_and_white_stay_black_and_white() {
        // 0 and 255 lie outside of the limited range: they prove that the full range is kept
        for gray in [0.0, 1.0] {
            let (grid, values) = movie(3, 32, 32, 8, |_, _, _| gray);
            let check = write_and_check(&grid, 8, &values, 30.0);
            assert_eq!(check.largest_error, 0, "{gray}: {check:?}");
        }
    }

    #[test]
    fn an_error_of_one_frame_is_seen() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("m.mp4");
        let (grid, mut values) = movie(20, 32, 32, 8, |k, _, _| k as f64 / 20.0);
        let set = FrameSet::of(&grid, 8, &values);
        write_movie(&path, &set, 30.0, &Work::new()).unwrap();
        let checked = |values: &[u16]| {
            check_movie(&path, &FrameSet::of(&grid, 8, values), &Work::new()).unwrap()
        };
        assert!(checked(&values).largest_error <= 1);
        values[17 * 32 * 32 + 5] -= 100;
        let check = checked(&values);
        assert!((99..=101).contains(&check.largest_error), "{check:?}");
        values.rotate_left(32 * 32); // frames in another order
        assert!(checked(&values).rms_error > 10.0);
    }

    #[test]
    fn tiny_single_and_odd_movies_work() {
        for (frames, rows, columns) in [(1, 1, 1), (1, 17, 16), (2, 40, 15)] {
            let (grid, values) = movie(frames, rows, columns, 8, |_, r, _| r as f64 / 40.0);
            let check = write_and_check(&grid, 8, &values, 10.0);
            assert_eq!(check.frames, frames);
            assert!(
                frames == 1 || (check.frame_rate - 10.0).abs() < 1e-6,
                "{check:?}"
            );
            assert!(check.largest_error <= 5, "{check:?}");
        }
    }

    #[test]
    fn damaged_files_are_refused_and_nothing_panics() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("m.mp4");
        let (grid, values) = movie(3, 16, 16, 8, |_, r, c| (r * c) as f64 / 256.0);
        let set = FrameSet::of(&grid, 8, &values);
        write_movie(&path, &set, 30.0, &Work::new()).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        for cut in (0..bytes.len()).step_by(7) {
            std::fs::write(&path, &bytes[..cut]).unwrap();
            assert!(
                check_movie(&path, &set, &Work::new()).is_err(),
                "cut at {cut}"
            );
        }
        for i in 0..bytes.len().min(900) {
            let mut wrong = bytes.clone();
            wrong[i] ^= 0xff;
            let _ = Track::find(&wrong).map(|t| (0..3).map(|i| t.packet(i)).collect::<Vec<_>>());
        }
    }

    #[test]
    fn what_cannot_be_a_movie_is_refused() {
        let (grid, values) = movie(1, 16, 16, 8, |_, _, _| 0.5);
        let set = FrameSet::of(&grid, 8, &values);
        let path = Path::new("/nonexistent-folder/m.mp4");
        for rate in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(
                write_movie(path, &set, rate, &Work::new()),
                Err(Error::Config { .. })
            ));
        }
        let grid = PatternGrid::full_turn(1, 0.0, 2, 4000, 0.02);
        let set = FrameSet::of(&grid, 8, &[0; 8000]);
        assert!(matches!(
            write_movie(path, &set, 30.0, &Work::new()),
            Err(Error::Unsupported { .. })
        ));
    }
}
