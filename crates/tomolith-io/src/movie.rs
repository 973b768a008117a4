//! Movies in: what this program or another one made of frames, back as levels.
//!
//! | file | read by |
//! |---|---|
//! | MP4 or QuickTime with H.264 (Baseline, Main or High, 4:2:0, 8 bits, no B-frames) | OpenH264 |
//! | QuickTime with PNG frames ([`write_lossless`]) | the reader of PNG frames |
//! | any other MP4, QuickTime, Matroska, WebM, AVI, MPEG, FLV, WMV, Ogg, GIF, APNG or Y4M: B-frames, 4:4:4, HEVC, VP9, AV1, MJPEG, FFV1, … | the program `ffmpeg`, where it is on the path |
//!
//! What a file is follows from its content, not from its name. Gray is the luma: full range 0…255, or 16…235 stretched to
//! it where the stream says nothing else. Of a colored movie the [channel](super::channel) that is asked for is taken, by `ffmpeg`
//! but for PNG frames; without, PNG frames alone may be colored, as their levels say which channel is lit. A movie has as many frames as the job, each of the job's
//! size or padded as H.264 needs it ([`padded`]); padding is cut off.
//!
//! ```
//! use tomolith_core::grid::PatternGrid;
//! use tomolith_io::frames::FrameSet;
//! use tomolith_io::movie::{check_lossless, read_movie, write_lossless};
//! let grid = PatternGrid::full_turn(4, 0.0, 3, 5, 0.02);
//! let values: Vec<u16> = (0..grid.len()).map(|i| i as u16 * 68).collect();
//! let set = FrameSet { light: None, grid: &grid, bits: 12, full_scale: 0.3, channel: None, values: &values };
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("part_10rpm.mov");
//! write_lossless(&path, &set, 24.0).unwrap();
//! assert_eq!(check_lossless(&path, &set).unwrap().largest_error, 0);
//! let read = read_movie(&path, [4, 3, 5], None).unwrap();
//! assert_eq!((read.bits, read.full_scale, read.values), (12, Some(0.3), values));
//! ```

mod ffmpeg;
pub(super) mod h264;
mod lossless;
#[cfg(test)]
mod tests;
pub(super) mod track;

use super::channel::Channel;
use super::frames::Frames;
use super::mp4::padded;
use h264::Stream;
pub use lossless::{check_lossless, write_lossless};
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::files::read_regular;
use track::{Codec, Track};

/// Endings of files that are taken for movies.
const ENDINGS: [&str; 18] = [
    "mp4", "m4v", "mov", "mkv", "webm", "avi", "ts", "mts", "m2ts", "mpg", "mpeg", "flv", "wmv",
    "asf", "ogv", "gif", "apng", "y4m",
];

/// Whether a file is a movie by its name.
#[must_use]
pub fn is_movie(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    ENDINGS.iter().any(|known| ending == **known)
}

/// Reads the levels of a movie of this shape, `[frame, row, column]`, of a colored one in this channel; see the [module page](self).
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] when the file is no movie, is damaged, has another number or size of frames, is colored where no channel is asked for, or can be
/// read by `ffmpeg` alone and there is none.
pub fn read_movie(path: &Path, shape: [usize; 3], channel: Option<Channel>) -> Result<Frames> {
    let file = read_regular(path)?;
    let what = if is_mp4(&file) {
        if let Some(missing) = track::missing(&file) {
            return Err(damaged(path, missing));
        }
        match read_built_in(&file, path, shape, channel)? {
            Ok(frames) => return Ok(frames),
            Err(what) => what,
        }
    } else {
        let mut others = OTHERS.iter();
        let found =
            others.find(|(_, marks)| marks.iter().all(|(at, bytes)| has(&file, *at, bytes)));
        let apng = is_apng(&file).then_some("an animated PNG (APNG)");
        let what = found.map(|(what, _)| *what).or(apng);
        what.ok_or_else(|| no_movie(path, &file))?.to_owned()
    };
    drop(file);
    ffmpeg::read(path, shape, channel).map_err(|trouble| match trouble {
        ffmpeg::Trouble::Said(found) => damaged(path, format!("{what}: {found}")),
        ffmpeg::Trouble::Missing => Error::format(path, format!(
                "{what}, which the program ffmpeg can read, but it is not installed (not on the PATH)"
            ), format!(
                "ffmpeg installed; or the frames as PNG files in a folder, on a machine that has it: mkdir frames && ffmpeg -i {} \
                 -pix_fmt gray frames/frame_%04d.png; or H.264 of 4:2:0 without B-frames: ffmpeg -i {0} -c:v libx264 -pix_fmt yuv420p \
                 -bf 0 -crf 5 new.mp4",
                path.display()
            )),
    })
}

/// What our own readers make of an MP4 or QuickTime file; where it is not theirs, what it holds.
fn read_built_in(
    file: &[u8],
    path: &Path,
    [frames, rows, columns]: [usize; 3],
    channel: Option<Channel>,
) -> Result<Result<Frames, String>> {
    let other = |what: &str| Ok(Err(what.to_owned()));
    let Some(track) = Track::find(file) else {
        return other("a movie whose index is of another kind");
    };
    let count = track.samples.len();
    if count == 0 {
        return other("a movie in fragments");
    }
    if count != frames && (track.is_in_order || count < frames) {
        return Err(damaged(path, format!("{count} frames instead of {frames}")));
    }
    if !track.is_upright {
        return other("a movie that is turned, mirrored or scaled when it is shown");
    }
    match &track.codec {
        Codec::Png => lossless::read(&track, path, [rows, columns], channel).map(Ok),
        Codec::Other(letters) => Ok(Err(named(*letters))),
        Codec::H264 { .. } => {
            let Some(stream) = Stream::of(&track) else {
                return other("H.264 with parameters that cannot be read");
            };
            must_fit(stream.size, [rows, columns]).map_err(|found| damaged(path, found))?;
            if let Some(what) = stream.unsupported(&track) {
                return Ok(Err(what));
            }
            match h264::luma(&track, &stream, [rows, columns]) {
                Ok((_, Some(_))) if channel.is_some() => other("colored H.264"),
                Ok((_, Some(frame))) => Err(damaged(path, colored(frame))),
                Ok((values, None)) => Ok(Ok(Frames {
                    shape: [frames, rows, columns],
                    bits: 8,
                    full_scale: None,
                    values,
                })),
                Err(found) => Ok(Err(format!(
                    "H.264 that OpenH264 does not decode ({found})"
                ))),
            }
        }
    }
}

/// Refuses frames of `[columns, rows]` that are neither of this size `[rows, columns]` nor padded from it.
fn must_fit([width, height]: [usize; 2], [rows, columns]: [usize; 2]) -> Result<(), String> {
    let fits = |found: usize, wanted: usize| (wanted..=padded(wanted)).contains(&found);
    if fits(width, columns) && fits(height, rows) {
        return Ok(());
    }
    Err(format!(
        "frames of {width} × {height} pixels instead of {columns} × {rows}"
    ))
}

/// Chroma of a gray picture is 128, give or take what coding leaves.
const GRAY: u8 = 128;
const CODING: u8 = 16;

/// What is wrong with a movie whose frame is colored.
fn colored(frame: usize) -> String {
    format!(
        "a colored picture in frame {frame}, and no printer.channel that says which color counts"
    )
}

/// A codec by its four letters (mp4ra.org).
fn named(letters: [u8; 4]) -> String {
    let name = match &letters {
        b"hvc1" | b"hev1" => "HEVC",
        b"avc3" => "H.264 with parameters in its frames",
        b"vp08" => "VP8",
        b"vp09" => "VP9",
        b"av01" => "AV1",
        b"mp4v" => "MPEG-4 Visual or Motion JPEG",
        b"jpeg" | b"mjpa" | b"mjpb" => "Motion JPEG",
        b"apch" | b"apcn" | b"apcs" | b"apco" | b"ap4h" | b"ap4x" => "ProRes",
        _ => "another codec",
    };
    format!(
        "{name} (`{}`)",
        String::from_utf8_lossy(&letters).trim_end()
    )
}

/// Bytes at places of a file.
type Marks = &'static [(usize, &'static [u8])];

/// Containers that only `ffmpeg` reads: what a file is that has all these bytes at these places.
const OTHERS: [(&str, Marks); 13] = [
    ("a Matroska or WebM file", &[(0, b"\x1a\x45\xdf\xa3")]),
    ("an AVI file", &[(0, b"RIFF"), (8, b"AVI ")]),
    ("a Flash video", &[(0, b"FLV\x01")]),
    (
        "a Windows Media file",
        &[(0, b"\x30\x26\xb2\x75\x8e\x66\xcf\x11")],
    ),
    ("an Ogg file", &[(0, b"OggS")]),
    ("a GIF file", &[(0, b"GIF8")]),
    ("a YUV4MPEG2 file", &[(0, b"YUV4MPEG2")]),
    ("an MPEG program stream", &[(0, b"\0\0\x01\xba")]),
    ("an MPEG video stream", &[(0, b"\0\0\x01\xb3")]),
    ("an MPEG-4 video stream", &[(0, b"\0\0\x01\xb0")]),
    ("an MPEG-4 video stream", &[(0, b"\0\0\x01\0")]),
    // Packets of 188 bytes that begin with 0x47, on Blu-ray discs after four bytes each
    ("an MPEG transport stream", &[(0, b"\x47"), (188, b"\x47")]),
    ("an MPEG transport stream", &[(4, b"\x47"), (196, b"\x47")]),
];

/// Whether a file has these bytes at a place.
fn has(file: &[u8], at: usize, bytes: &[u8]) -> bool {
    file.get(at..at + bytes.len()) == Some(bytes)
}

/// Whether a file is a PNG with a chunk `acTL` before its first picture.
fn is_apng(file: &[u8]) -> bool {
    let head = &file[..file.len().min(4096)];
    let kind = |letters: &[u8]| head.windows(4).position(|bytes| bytes == letters);
    has(file, 0, b"\x89PNG")
        && kind(b"acTL").is_some_and(|at| kind(b"IDAT").is_none_or(|data| at < data))
}

/// Whether a file is MP4 or QuickTime by its first box.
fn is_mp4(file: &[u8]) -> bool {
    const BOXES: [&[u8]; 7] = [
        b"ftyp", b"moov", b"mdat", b"free", b"skip", b"wide", b"pnot",
    ];
    BOXES.iter().any(|kind| has(file, 4, kind))
}

fn no_movie(path: &Path, file: &[u8]) -> Error {
    let start: String = String::from_utf8_lossy(&file[..file.len().min(16)])
        .chars()
        .filter(|c| !c.is_control())
        .collect();
    let found = if file.is_empty() {
        "the file is empty".to_owned()
    } else {
        format!("no movie: it begins with `{start}`")
    };
    Error::format(
        path,
        found,
        "a movie: MP4, QuickTime, Matroska, WebM, AVI, MPEG, FLV, WMV, Ogg, GIF, APNG or Y4M",
    )
}

fn damaged(path: &Path, found: String) -> Error {
    Error::format(
        path,
        found,
        "a whole movie with the frames of the job, one for each angle",
    )
}
