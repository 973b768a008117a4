//! H.264 through OpenH264: frames of 8 bits at 4:2:0 that are shown in the order in which they lie in the file.
//!
//! OpenH264 guesses the order of B-frames; a wrong guess would be a wrong print, so they are left to another program.
//! What a stream holds is read from its sequence parameter set (Rec. ITU-T H.264, 7.3.2.1.1 and E.1.1).

use super::track::{Codec, Track};
use super::{CODING, GRAY};
use openh264::decoder::{DecodedYUV, Decoder};
use openh264::formats::YUVSource;
use std::ops::Range;
use tomolith_core::parallel::InParallel;

/// Frames that one encoder or decoder handles; fixed, so that results do not depend on the number of threads.
const GROUP: usize = 16;

/// Frames that are encoded or decoded together.
pub(crate) fn groups(frames: usize) -> Vec<Range<usize>> {
    (0..frames)
        .step_by(GROUP)
        .map(|first| first..frames.min(first + GROUP))
        .collect()
}

/// What OpenH264 says, without its remarks on backtraces.
pub(crate) fn message_of(error: &openh264::Error) -> String {
    let text = error.to_string();
    text.split(". Backtraces")
        .next()
        .unwrap_or(&text)
        .to_owned()
}

/// Decodes frames that follow each other, the first one a key frame.
pub(crate) fn each_image(
    track: &Track<'_>,
    group: Range<usize>,
    mut see: impl FnMut(usize, &DecodedYUV<'_>) -> Result<(), String>,
) -> Result<(), String> {
    let mut decoder = Decoder::new().map_err(|e| message_of(&e))?;
    let mut next = group.start;
    for frame in group.clone() {
        let packet = track
            .packet(frame)
            .ok_or_else(|| format!("frame {frame} is cut off"))?;
        let image = decoder
            .decode(&packet)
            .map_err(|e| format!("frame {frame}: {}", message_of(&e)))?;
        if let Some(image) = image {
            see(next, &image)?;
            next += 1;
        }
    }
    for image in decoder.flush_remaining().map_err(|e| message_of(&e))? {
        see(next, &image)?;
        next += 1;
    }
    if next == group.end {
        return Ok(());
    }
    Err(format!(
        "frames {} to {} came out as {} images",
        group.start,
        group.end - 1,
        next - group.start
    ))
}

/// The luma of all frames, `[frame, row, column]`, of each the given rows and columns from the top left, black 0 and white 255; and the
/// first frame that is colored.
pub(super) fn luma(
    track: &Track<'_>,
    stream: &Stream,
    [rows, columns]: [usize; 2],
) -> Result<(Vec<u16>, Option<usize>), String> {
    let gray: Vec<u16> = (0..=u8::MAX).map(|luma| stream.gray(luma)).collect();
    let decode = |group: Range<usize>| {
        let mut levels = Vec::with_capacity(group.len() * rows * columns);
        let mut colored = None;
        each_image(track, group, |frame, image| {
            let (width, height) = image.dimensions();
            if width < columns || height < rows {
                return Err(format!("frame {frame} has {width} × {height} pixels"));
            }
            for row in image.y().chunks(image.strides().0).take(rows) {
                levels.extend(row[..columns].iter().map(|&luma| gray[usize::from(luma)]));
            }
            let (_, of_u, of_v) = image.strides();
            let is_colored = |(plane, stride): (&[u8], usize)| {
                let mut lines = plane.chunks(stride).take(rows.div_ceil(2));
                lines.any(|line| {
                    let shown = &line[..columns.div_ceil(2).min(line.len())];
                    shown.iter().any(|chroma| chroma.abs_diff(GRAY) > CODING)
                })
            };
            if colored.is_none()
                && [(image.u(), of_u), (image.v(), of_v)]
                    .into_iter()
                    .any(is_colored)
            {
                colored = Some(frame);
            }
            Ok(())
        })?;
        Ok((levels, colored))
    };
    let frames = track.samples.len();
    let groups = if track.every_frame_is_a_key {
        groups(frames)
    } else {
        std::iter::once(0..frames).collect()
    };
    let (levels, colored): (Vec<Vec<u16>>, Vec<Option<usize>>) = groups
        .into_iter()
        .par_map(decode)
        .into_iter()
        .collect::<Result<Vec<_>, String>>()?
        .into_iter()
        .unzip();
    Ok((levels.concat(), colored.into_iter().flatten().min()))
}

/// What a stream is, by its sequence parameter set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stream {
    profile: u64,
    /// 0 gray, 1 4:2:0, 2 4:2:2, 3 4:4:4.
    chroma: u64,
    bits: u64,
    is_interlaced: bool,
    /// Columns and rows that are shown.
    pub(super) size: [usize; 2],
    is_full_range: bool,
}

/// Profiles whose parameter sets tell chroma and bits.
const TELLING: [u64; 13] = [100, 110, 122, 244, 44, 83, 86, 118, 128, 138, 139, 134, 135];

impl Stream {
    /// The stream of a track of H.264.
    pub(super) fn of(track: &Track<'_>) -> Option<Self> {
        let Codec::H264 { parameter_sets, .. } = &track.codec else {
            return None;
        };
        let is_sequence = |unit: &&&[u8]| unit.first().is_some_and(|head| head & 31 == 7);
        Self::parse(parameter_sets.iter().find(is_sequence)?)
    }

    fn parse(unit: &[u8]) -> Option<Self> {
        let mut bits = Bits::new(unit.get(1..)?);
        let profile = bits.take(8)?;
        bits.take(16)?; // constraints, level
        bits.code()?;
        let (mut chroma, mut depth) = (1, 8);
        if TELLING.contains(&profile) {
            chroma = bits.code()?;
            if chroma == 3 {
                bits.take(1)?;
            }
            depth = 8 + bits.code()?;
            bits.code()?;
            bits.take(1)?;
            if bits.flag()? {
                bits.skip_scaling(if chroma == 3 { 12 } else { 8 })?;
            }
        }
        bits.code()?; // frame numbers
        match bits.code()? {
            0 => drop(bits.code()?),
            1 => {
                bits.take(1)?;
                bits.code()?;
                bits.code()?;
                for _ in 0..bits.code().filter(|n| *n < 256)? {
                    bits.code()?;
                }
            }
            _ => {}
        }
        bits.code()?; // reference frames
        bits.take(1)?;
        let blocks = [bits.code()? + 1, bits.code()? + 1];
        let is_interlaced = !bits.flag()?;
        if is_interlaced {
            bits.take(1)?;
        }
        bits.take(1)?;
        let mut crop = [0; 4];
        if bits.flag()? {
            for side in &mut crop {
                *side = bits.code()?;
            }
        }
        let size = cropped(blocks, crop, chroma, is_interlaced)?;
        let is_full_range = bits.full_range().unwrap_or(false);
        Some(Stream {
            profile,
            chroma,
            bits: depth,
            is_interlaced,
            size,
            is_full_range,
        })
    }

    /// Why OpenH264 cannot decode it.
    pub(super) fn unsupported(&self, track: &Track<'_>) -> Option<String> {
        let profile = match self.profile {
            66 => "Baseline",
            77 => "Main",
            88 => "Extended",
            100 => "High",
            110 => "High 10",
            122 => "High 4:2:2",
            244 => "High 4:4:4 Predictive",
            _ => "of an unusual profile",
        };
        let chroma = ["gray", "4:2:0", "4:2:2", "4:4:4"].get(self.chroma as usize);
        let what = if !matches!(self.profile, 66 | 77 | 100) || self.chroma > 1 || self.bits != 8 {
            format!(
                "{} of {} bits",
                chroma.unwrap_or(&"of unknown colors"),
                self.bits
            )
        } else if self.is_interlaced {
            "interlaced".to_owned()
        } else if !track.is_in_order {
            "with B-frames or an edited beginning".to_owned()
        } else {
            return None;
        };
        Some(format!("H.264 {profile}, {what}"))
    }

    /// The gray value of a luma: black 16 and white 235 in the limited range.
    fn gray(&self, luma: u8) -> u16 {
        if self.is_full_range {
            return u16::from(luma);
        }
        let above = u32::from(luma.clamp(16, 235)) - 16;
        ((above * 510 + 219) / 438) as u16
    }
}

/// Columns and rows of a picture of macroblocks, less what is cropped at the left, right, top and bottom.
fn cropped(
    blocks: [u64; 2],
    crop: [u64; 4],
    chroma: u64,
    is_interlaced: bool,
) -> Option<[usize; 2]> {
    let rows = if is_interlaced { 2 } else { 1 };
    let across = if matches!(chroma, 1 | 2) { 2 } else { 1 };
    let down = rows * if chroma == 1 { 2 } else { 1 };
    let size = |blocks: u64, step: u64, [a, b]: [u64; 2]| {
        let pixels = blocks.checked_mul(16)?;
        let off = a.checked_add(b)?.checked_mul(step)?;
        usize::try_from(pixels.checked_sub(off)?).ok()
    };
    Some([
        size(blocks[0], across, [crop[0], crop[1]])?,
        size(blocks[1].checked_mul(rows)?, down, [crop[2], crop[3]])?,
    ])
}

/// Bits of a unit, without the bytes that keep start codes out of it.
struct Bits {
    bytes: Vec<u8>,
    at: usize,
}

impl Bits {
    fn new(unit: &[u8]) -> Self {
        let mut bytes: Vec<u8> = Vec::with_capacity(unit.len());
        let mut zeros = 0;
        for &byte in unit {
            if zeros >= 2 && byte == 3 {
                zeros = 0;
                continue;
            }
            zeros = if byte == 0 { zeros + 1 } else { 0 };
            bytes.push(byte);
        }
        Bits { bytes, at: 0 }
    }

    fn take(&mut self, count: usize) -> Option<u64> {
        (0..count).try_fold(0, |value, _| {
            let byte = self.bytes.get(self.at / 8)?;
            let bit = byte >> (7 - self.at % 8) & 1;
            self.at += 1;
            Some(value << 1 | u64::from(bit))
        })
    }

    fn flag(&mut self) -> Option<bool> {
        self.take(1).map(|bit| bit == 1)
    }

    /// An Exp-Golomb code (9.1): as many bits after the first 1 as there are zeros before it.
    fn code(&mut self) -> Option<u64> {
        let mut zeros = 0;
        while !self.flag()? {
            zeros += 1;
            if zeros > 32 {
                return None;
            }
        }
        Some((1 << zeros) - 1 + self.take(zeros)?)
    }

    /// A signed one: 1, −1, 2, −2, …
    fn signed(&mut self) -> Option<i64> {
        let code = i64::try_from(self.code()?).ok()?;
        Some(if code % 2 == 1 {
            (code + 1) / 2
        } else {
            -(code / 2)
        })
    }

    /// Passes scaling lists (7.3.2.1.1.1).
    fn skip_scaling(&mut self, lists: usize) -> Option<()> {
        for list in 0..lists {
            if !self.flag()? {
                continue;
            }
            let (mut last, mut next) = (8, 8);
            for _ in 0..if list < 6 { 16 } else { 64 } {
                if next != 0 {
                    next = (last + self.signed()?).rem_euclid(256);
                }
                last = if next == 0 { last } else { next };
            }
        }
        Some(())
    }

    /// Whether luma uses all values, when the stream says so.
    fn full_range(&mut self) -> Option<bool> {
        if !self.flag()? {
            return None;
        }
        if self.flag()? && self.take(8)? == 255 {
            self.take(32)?;
        }
        if self.flag()? {
            self.take(1)?;
        }
        if !self.flag()? {
            return None;
        }
        self.take(3)?;
        self.flag()
    }
}
