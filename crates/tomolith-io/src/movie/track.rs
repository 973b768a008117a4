//! The video track of an MP4 or QuickTime file: what its frames are coded in, and where each lies.
//!
//! Boxes as in ISO/IEC 14496-12 (`moov`, `trak`, `stbl`, …), the H.264 configuration as in ISO/IEC 14496-15 (`avcC`).

/// What the frames are coded in.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Codec<'a> {
    /// Units of H.264, each after its length in so many bytes; parameter sets separately.
    H264 {
        parameter_sets: Vec<&'a [u8]>,
        length_size: usize,
    },
    /// Each frame a PNG file.
    Png,
    /// Something else, by the four letters of its sample entry.
    Other([u8; 4]),
}

/// The first video track of a file.
pub(crate) struct Track<'a> {
    pub(crate) codec: Codec<'a>,
    /// Frames as they lie in the file, in the order of decoding.
    pub(crate) samples: Vec<&'a [u8]>,
    /// Whether a player shows pictures as they are stored, neither turned nor mirrored.
    pub(crate) is_upright: bool,
    /// Whether every frame can be decoded alone.
    pub(crate) every_frame_is_a_key: bool,
    /// Whether frames are shown in the order of decoding, all of them.
    pub(crate) is_in_order: bool,
    timescale: u32,
    duration: u64,
}

/// Big-endian number of `N` bytes at an offset.
fn number<const N: usize>(bytes: &[u8], at: usize) -> Option<u64> {
    let bytes = bytes.get(at..at.checked_add(N)?)?;
    Some(bytes.iter().fold(0, |sum, &b| sum << 8 | u64::from(b)))
}

fn word(bytes: &[u8], at: usize) -> Option<usize> {
    number::<4>(bytes, at).and_then(|n| usize::try_from(n).ok())
}

/// Bytes before the content of the first box, and of the whole box.
fn extent(bytes: &[u8]) -> Option<(usize, usize)> {
    Some(match number::<4>(bytes, 0)? {
        0 => (8, bytes.len()),
        1 => (16, usize::try_from(number::<8>(bytes, 8)?).ok()?),
        size => (8, usize::try_from(size).ok()?),
    })
}

/// The boxes of `bytes`, each with its type, as far as they are whole.
fn children(mut bytes: &[u8]) -> impl Iterator<Item = (&[u8], &[u8])> {
    std::iter::from_fn(move || {
        let (head, size) = extent(bytes)?;
        let (kind, content) = (bytes.get(4..8)?, bytes.get(head..size)?);
        bytes = &bytes[size..];
        Some((kind, content))
    })
}

/// Whether a player shows pictures as they are stored, by the header of their track.
fn is_upright(header: &[u8]) -> Option<bool> {
    const ONE: u64 = 1 << 16;
    let at = if header.first()? == &1 { 52 } else { 40 };
    let turned = [0, 1, 3, 4].map(|i| number::<4>(header, at + 4 * i));
    Some(turned == [ONE, 0, 0, ONE].map(Some))
}

/// The content of the first box of a type among the boxes of `bytes`.
fn child<'a>(bytes: &'a [u8], kind: &[u8; 4]) -> Option<&'a [u8]> {
    children(bytes).find(|(k, _)| k == kind).map(|(_, c)| c)
}

fn descend<'a>(bytes: &'a [u8], kinds: &[&[u8; 4]]) -> Option<&'a [u8]> {
    kinds
        .iter()
        .try_fold(bytes, |bytes, kind| child(bytes, kind))
}

/// What is missing at the end of a file, when its boxes say that there should be more.
pub(super) fn missing(file: &[u8]) -> Option<String> {
    let mut at = 0;
    let mut has_index = false;
    while at < file.len() {
        let rest = &file[at..];
        let Some((_, size)) = extent(rest).filter(|(head, size)| size >= head) else {
            return Some(format!(
                "truncated: a box begins {} bytes before the end",
                rest.len()
            ));
        };
        let kind = String::from_utf8_lossy(rest.get(4..8).unwrap_or_default());
        if size > rest.len() {
            return Some(format!(
                "truncated: the box `{kind}` should have {size} bytes, {} are there",
                rest.len()
            ));
        }
        has_index |= matches!(&*kind, "moov" | "moof");
        at += size;
    }
    let why =
        "no box `moov`, which lists the frames: the file was not finished, or its end is missing";
    (!has_index).then(|| why.to_owned())
}

impl<'a> Track<'a> {
    pub(crate) fn find(file: &'a [u8]) -> Option<Self> {
        let tracks = children(child(file, b"moov")?).filter(|(kind, _)| kind == b"trak");
        let handler =
            |track| descend(track, &[b"mdia", b"hdlr"]).and_then(|handler| handler.get(8..12));
        let track = tracks
            .map(|(_, t)| t)
            .find(|t| handler(t) == Some(b"vide"))?;
        let media = child(track, b"mdia")?;
        let header = child(media, b"mdhd")?;
        let timescale = word(header, if header.first()? == &1 { 20 } else { 12 })?;
        let table = descend(media, &[b"minf", b"stbl"])?;
        let codec = codec(child(table, b"stsd")?)?;
        let sizes = sample_sizes(child(table, b"stsz")?, file.len())?;
        let chunks = chunk_offsets(table)?;
        let samples = place_samples(file, child(table, b"stsc")?, &chunks, &sizes)?;
        let times = child(table, b"stts")?;
        let duration = (0..word(times, 4)?).try_fold(0u64, |sum, i| {
            let (count, delta) = (
                number::<4>(times, 8 + 8 * i)?,
                number::<4>(times, 12 + 8 * i)?,
            );
            sum.checked_add(count.checked_mul(delta)?)
        })?;
        let keys = child(table, b"stss").map(|keys| word(keys, 4));
        Some(Track {
            is_upright: is_upright(child(track, b"tkhd")?)?,
            every_frame_is_a_key: keys.is_none_or(|keys| keys == Some(samples.len())),
            is_in_order: is_in_order(table, track).unwrap_or(false),
            codec,
            samples,
            timescale: u32::try_from(timescale).ok()?,
            duration,
        })
    }

    pub(crate) fn frame_rate(&self) -> f64 {
        self.samples.len() as f64 * f64::from(self.timescale) / self.duration.max(1) as f64
    }

    /// Frame `i` of H.264 as the decoder takes it: parameter sets and units, each after a start code.
    pub(crate) fn packet(&self, i: usize) -> Option<Vec<u8>> {
        const START: [u8; 4] = [0, 0, 0, 1];
        let Codec::H264 {
            parameter_sets,
            length_size,
        } = &self.codec
        else {
            return None;
        };
        let mut rest = *self.samples.get(i)?;
        let mut packet = Vec::with_capacity(rest.len() + 64);
        for set in parameter_sets {
            packet.extend(START);
            packet.extend(*set);
        }
        while !rest.is_empty() {
            let length = rest
                .get(..*length_size)?
                .iter()
                .fold(0usize, |sum, &b| sum << 8 | usize::from(b));
            let unit = rest.get(*length_size..length_size.checked_add(length)?)?;
            packet.extend(START);
            packet.extend(unit);
            rest = &rest[length_size + length..];
        }
        Some(packet)
    }
}

/// The codec of a sample description: version, count, then entries; that of H.264 has 78 bytes before its own boxes.
fn codec(descriptions: &[u8]) -> Option<Codec<'_>> {
    let (kind, entry) = children(descriptions.get(8..)?).next()?;
    Some(match kind {
        b"avc1" => {
            let config = child(entry.get(78..)?, b"avcC")?;
            Codec::H264 {
                length_size: usize::from(config.get(4)? & 3) + 1,
                parameter_sets: parameter_sets(config)?,
            }
        }
        b"png " => Codec::Png,
        other => Codec::Other(other.try_into().ok()?),
    })
}

/// Whether no frame is shown earlier or later than its neighbors in the file (`ctts`: one delay for all), and no edit
/// (`elst`) leaves out the beginning.
fn is_in_order(table: &[u8], track: &[u8]) -> Option<bool> {
    let mut delay = 0;
    if let Some(delays) = child(table, b"ctts") {
        delay = number::<4>(delays, 12)?;
        for i in 0..word(delays, 4)? {
            if number::<4>(delays, 12 + 8 * i)? != delay {
                return Some(false);
            }
        }
    }
    let Some(edits) = descend(track, &[b"edts", b"elst"]) else {
        return Some(true);
    };
    let (long, nothing) = (edits.first()? == &1, [u64::from(u32::MAX), u64::MAX]);
    for i in 0..word(edits, 4)? {
        let start = if long {
            number::<8>(edits, 16 + 20 * i)?
        } else {
            number::<4>(edits, 12 + 12 * i)?
        };
        if start > delay && !nothing.contains(&start) {
            return Some(false);
        }
    }
    Some(true)
}

/// Sequence and picture parameter sets of an `avcC` box.
fn parameter_sets(config: &[u8]) -> Option<Vec<&[u8]>> {
    let mut sets = Vec::new();
    let mut at = 5;
    for mask in [0x1f, 0xff] {
        let count = config.get(at)? & mask;
        at += 1;
        for _ in 0..count {
            let length = usize::try_from(number::<2>(config, at)?).ok()?;
            sets.push(config.get(at + 2..at + 2 + length)?);
            at += 2 + length;
        }
    }
    Some(sets)
}

fn sample_sizes(table: &[u8], file: usize) -> Option<Vec<usize>> {
    let (fixed, count) = (word(table, 4)?, word(table, 8)?);
    if fixed == 0 {
        // One number a sample must be there, which bounds the count
        table.get(12..12usize.checked_add(count.checked_mul(4)?)?)?;
    } else if count.checked_mul(fixed)? > file {
        return None;
    }
    (0..count)
        .map(|i| {
            if fixed > 0 {
                Some(fixed)
            } else {
                word(table, 12 + 4 * i)
            }
        })
        .collect()
}

fn chunk_offsets(table: &[u8]) -> Option<Vec<usize>> {
    if let Some(short) = child(table, b"stco") {
        return (0..word(short, 4)?)
            .map(|i| word(short, 8 + 4 * i))
            .collect();
    }
    let long = child(table, b"co64")?;
    (0..word(long, 4)?)
        .map(|i| number::<8>(long, 8 + 8 * i).and_then(|n| usize::try_from(n).ok()))
        .collect()
}

/// Samples lie one after the other in chunks; `stsc` says how many lie in each.
fn place_samples<'a>(
    file: &'a [u8],
    runs: &[u8],
    chunks: &[usize],
    sizes: &[usize],
) -> Option<Vec<&'a [u8]>> {
    let count = word(runs, 4)?;
    let mut samples = Vec::with_capacity(sizes.len());
    let mut run = 0;
    for (chunk, &start) in chunks.iter().enumerate() {
        while run + 1 < count && word(runs, 8 + 12 * (run + 1))? <= chunk + 1 {
            run += 1;
        }
        let mut at = start;
        for _ in 0..word(runs, 8 + 12 * run + 4)? {
            let Some(&size) = sizes.get(samples.len()) else {
                return Some(samples);
            };
            samples.push(file.get(at..at.checked_add(size)?)?);
            at += size;
        }
    }
    (samples.len() == sizes.len()).then_some(samples)
}
