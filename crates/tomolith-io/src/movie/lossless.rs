//! The frames as a movie without loss: PNG files in a QuickTime file (`.mov`).
//!
//! Each frame is the PNG file of [`frames`](crate::frames), with its bits, white and azimuth, so the levels come back
//! bit for bit at any depth; players that build on FFmpeg (mpv) show it, VLC with `--deinterlace=0`. The file is a QuickTime file as in Apple's
//! *QuickTime File Format*: `ftyp`, `mdat` with one frame after the other, `moov` with one track of `png `.

use super::track::{Codec, Track};
use super::{damaged, must_fit};
use crate::channel::Channel;
use crate::frames::{FrameSet, Frames, Trouble, decode, encode, together};
use crate::mp4::MovieCheck;
use crate::whole::write_whole;
use std::io::{Cursor, Seek, SeekFrom, Write};
use std::path::Path;
use tomolith_core::error::{Error, Result};
use tomolith_core::parallel::InParallel;

/// Units of time in a second, as in [`mp4`](crate::mp4).
const TIMESCALE: f64 = 90_000.0;
/// Frames that are compressed together, before they are written.
const GROUP: usize = 64;

/// Writes the frames of one light as a lossless movie.
///
/// # Errors
/// [`Error::Shape`], [`Error::Io`]; [`Error::Unsupported`] for frames beyond 65,535 pixels or a movie too long for its clock.
pub fn write_lossless(path: &Path, set: &FrameSet<'_>, frame_rate: f64) -> Result<()> {
    set.check()?;
    let refuse = |reason: &str| Error::unsupported(format!("the movie {}", path.display()), reason);
    let size = [set.grid.columns, set.grid.rows].map(u16::try_from);
    let [Ok(columns), Ok(rows)] = size else {
        return Err(refuse(
            "a QuickTime file has at most 65,535 columns and rows",
        ));
    };
    let starts = (0..=set.grid.frames()).map(|i| (i as f64 / frame_rate * TIMESCALE).round());
    let starts: Vec<f64> = starts.collect();
    if starts.iter().any(|start| *start > f64::from(u32::MAX)) {
        return Err(refuse("it would last longer than 13 hours"));
    }
    write_whole(path, |file| {
        file.write_all(&boxed(b"ftyp", &[b"qt  \x20\x05\x03\x00qt  "]))?;
        let place = file.stream_position()?;
        file.write_all(b"\0\0\0\x01mdat\0\0\0\0\0\0\0\0")?;
        let mut sizes = Vec::with_capacity(set.grid.frames());
        let frames: Vec<usize> = (0..set.grid.frames()).collect();
        for group in frames.chunks(GROUP) {
            let images: Vec<Vec<u8>> = group
                .iter()
                .par_map(|&frame| {
                    let mut image = Vec::new();
                    encode(&mut image, set, frame).map(|()| image)
                })
                .into_iter()
                .collect::<std::io::Result<_>>()?;
            for image in images {
                file.write_all(&image)?;
                sizes.push(image.len() as u32);
            }
        }
        let end = file.stream_position()?;
        file.write_all(&index([columns, rows], &starts, &sizes, place + 16))?;
        file.seek(SeekFrom::Start(place + 8))?;
        Ok(file.write_all(&(end - place).to_be_bytes())?)
    })
}

/// A box: its size, its type, its content.
fn boxed(kind: &[u8; 4], content: &[&[u8]]) -> Vec<u8> {
    let length: usize = content.iter().map(|part| part.len()).sum();
    let mut bytes = ((8 + length) as u32).to_be_bytes().to_vec();
    bytes.extend(kind);
    content.iter().for_each(|part| bytes.extend(*part));
    bytes
}

/// Numbers of 32 bits in a row.
fn words(numbers: &[u32]) -> Vec<u8> {
    numbers.iter().flat_map(|n| n.to_be_bytes()).collect()
}

/// The box `moov`: one track of PNG files that lie one after the other from `first` on.
fn index([columns, rows]: [u16; 2], starts: &[f64], sizes: &[u32], first: u64) -> Vec<u8> {
    const ONE: u32 = 1 << 16;
    let matrix = [ONE, 0, 0, 0, ONE, 0, 0, 0, 1 << 30];
    let count = sizes.len() as u32;
    let clock = TIMESCALE as u32;
    let length = starts.last().copied().unwrap_or(0.0) as u32;

    // Entry of the sample description: 72 dots an inch, one frame a sample, 24 bits of color, no table of colors
    let mut entry = words(&[0, 1, 0, 0, 0, 0]);
    entry.extend([columns, rows].map(u16::to_be_bytes).as_flattened());
    entry.extend(words(&[72 << 16, 72 << 16, 0]));
    entry.extend([0, 1]);
    entry.extend([0; 32]);
    entry.extend([0, 24, 0xff, 0xff]);
    let entry = boxed(b"png ", &[&entry]);

    let steps = starts.windows(2).map(|pair| (pair[1] - pair[0]) as u32);
    let mut runs: Vec<[u32; 2]> = Vec::new();
    for step in steps {
        match runs.last_mut() {
            Some([n, last]) if *last == step => *n += 1,
            _ => runs.push([1, step]),
        }
    }
    let table = boxed(
        b"stbl",
        &[
            &boxed(b"stsd", &[&words(&[0, 1]), &entry]),
            &boxed(
                b"stts",
                &[&words(&[0, runs.len() as u32]), &words(runs.as_flattened())],
            ),
            &boxed(b"stsc", &[&words(&[0, 1, 1, count, 1])]),
            &boxed(b"stsz", &[&words(&[0, 0, count]), &words(sizes)]),
            &boxed(b"co64", &[&words(&[0, 1]), &first.to_be_bytes()]),
        ],
    );
    let here = boxed(b"url ", &[&words(&[1])]);
    let data = boxed(b"dinf", &[&boxed(b"dref", &[&words(&[0, 1]), &here])]);
    let view = boxed(b"vmhd", &[&words(&[1, 0, 0])]);
    let handler = boxed(b"hdlr", &[&[0; 4], b"mhlrvide", &[0; 13]]);
    let media = boxed(
        b"mdia",
        &[
            &boxed(b"mdhd", &[&words(&[0, 0, 0, clock, length, 0])]),
            &handler,
            &boxed(b"minf", &[&view, &data, &table]),
        ],
    );
    let size = words(&[u32::from(columns) << 16, u32::from(rows) << 16]);
    let shown = words(&[0xf, 0, 0, 1, 0, length, 0, 0, 0, 0]);
    let track = boxed(b"tkhd", &[&shown, &words(&matrix), &size]);
    let movie = words(&[0, 0, 0, clock, length, ONE, 0x100 << 16, 0, 0]);
    boxed(
        b"moov",
        &[
            &boxed(
                b"mvhd",
                &[&movie, &words(&matrix), &words(&[0, 0, 0, 0, 0, 0, 2])],
            ),
            &boxed(b"trak", &[&track, &media]),
        ],
    )
}

/// The frames of a track of PNG files.
pub(super) fn read(
    track: &Track<'_>,
    path: &Path,
    size: [usize; 2],
    channel: Option<Channel>,
) -> Result<Frames> {
    let images = (track.samples.iter().enumerate())
        .par_map(|(i, sample)| {
            decode(Cursor::new(sample), channel).map_err(|trouble| match trouble {
                Trouble::Io(source) => Error::io(path, source),
                Trouble::Said(found) => damaged(path, format!("frame {i}: {found}")),
            })
        })
        .into_iter()
        .collect::<Result<_>>()?;
    let frames = together(images, |_| path.to_owned())?;
    must_fit([frames.shape[2], frames.shape[1]], size).map_err(|found| damaged(path, found))?;
    Ok(frames)
}

/// Reads a movie of [`write_lossless`] back and compares it with its frames: every level must be the same.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] when it is damaged or a level differs.
pub fn check_lossless(path: &Path, set: &FrameSet<'_>) -> Result<MovieCheck> {
    let file = std::fs::read(path).map_err(|e| Error::io(path, e))?;
    let track = Track::find(&file).filter(|track| track.codec == Codec::Png);
    let track = track.ok_or_else(|| damaged(path, "no track of PNG frames".to_owned()))?;
    let [count, rows, columns] = set.grid.shape();
    let found = read(&track, path, [rows, columns], set.channel)?;
    if found.shape[0] != count || found.bits != set.bits || found.values != set.values {
        let found = "frames that are not those that were written".to_owned();
        return Err(damaged(path, found));
    }
    Ok(MovieCheck {
        frames: count,
        frame_rate: track.frame_rate(),
        width: columns,
        height: rows,
        bytes: file.len() as u64,
        largest_error: 0,
        rms_error: 0.0,
    })
}
