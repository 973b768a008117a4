//! Numbers of NumPy and NRRD files, whatever their type and order, as f32.
//!
//! Read are floats of 2, 4 and 8 bytes, whole numbers of 1 to 8 bytes with and without sign, and bool (true is 1), little or
//! big endian, in C or Fortran order (`numpy.lib.format`, versions 1 to 3). The error of a file that is cut off states the bytes that should
//! be there.
//!
//! Where a caller needs one array, it is that of an `.npy` or [`.nrrd`](super::nrrd), the only one of an `.npz`, or `FILE.npz:NAME`. Axes of length one
//! in addition to those that the caller needs do not count: `[z, y, x, 1]` is `[z, y, x]`.

use super::nrrd;
use std::fs::File;
use std::io::{BufReader, ErrorKind, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result, nearest_name};
use tomolith_core::files::open_regular;

/// An array in C order.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Numbers<T = f32> {
    pub(super) shape: Vec<usize>,
    pub(super) kind: Kind,
    pub(super) values: Vec<T>,
}

/// Type of the numbers in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Float(usize),
    Signed(usize),
    Unsigned(usize),
    Bool,
}

/// Longest header that is believed.
const LONGEST_HEADER: u64 = 1 << 20;

/// Most numbers of an array: what is larger is damaged, or fits into no memory.
const MOST_NUMBERS: usize = 1 << 34;

/// Whether a path names a file of numbers, or an array of one.
pub(super) fn is_array(path: &Path) -> bool {
    let (file, _) = file_and_name(path);
    is_archive(&file) || is_nrrd(&file) || ends_in(&file, "npy")
}

fn is_nrrd(file: &Path) -> bool {
    ends_in(file, "nrrd")
}

pub(super) fn ends_in(file: &Path, ending: &str) -> bool {
    let extension = file.extension();
    extension.is_some_and(|extension| extension.eq_ignore_ascii_case(ending))
}

/// Whether a file is an archive of arrays by its name.
pub(super) fn is_archive(file: &Path) -> bool {
    ends_in(file, "npz")
}

/// The file of `FILE.npz:NAME` and the name; of any other path the path.
pub(super) fn file_and_name(path: &Path) -> (PathBuf, Option<String>) {
    let text = path.to_string_lossy();
    match text.rsplit_once(".npz:") {
        Some((stem, name)) => (format!("{stem}.npz").into(), Some(name.to_owned())),
        None => (path.to_owned(), None),
    }
}

impl Numbers {
    /// Reads one array; see the [module page](self).
    pub(super) fn read(path: &Path, accepted: &str) -> Result<Self> {
        let (path, name) = file_and_name(path);
        if is_archive(&path) {
            let mut archive = Archive::open(&path, accepted)?;
            let name = archive.chosen(name.as_deref())?;
            return archive.numbers(&name);
        }
        let (file, length) = opened(&path)?;
        let numbers = match is_nrrd(&path) {
            true => nrrd::read(file),
            false => Self::parse(file, length),
        };
        numbers.map_err(|found| Error::format(&path, found, accepted))
    }

    /// The array with so many dimensions.
    pub(super) fn of_dimensions<const N: usize>(self) -> Result<([usize; N], Vec<f32>), String> {
        let mut shape = &self.shape[..];
        while let ([rest @ .., 1] | [1, rest @ ..], true) = (shape, shape.len() > N) {
            shape = rest;
        }
        match <[usize; N]>::try_from(shape) {
            Ok(shape) => Ok((shape, self.values)),
            Err(_) => Err(format!(
                "an array of {} dimensions, shape {}, instead of {N}",
                self.shape.len(),
                tuple(&self.shape)
            )),
        }
    }

    /// The array as `[z, y, x]`; one of two dimensions is one slice.
    pub(super) fn into_volume(mut self) -> Result<([usize; 3], Vec<f32>), String> {
        if self.shape.len() == 2 {
            self.shape.insert(0, 1);
        }
        self.of_dimensions()
    }

    /// The content of an `.npy` file of so many bytes.
    pub(super) fn parse(file: impl Read, length: u64) -> Result<Self, String> {
        Self::parse_as(file, length, Element::value)
    }
}

/// The content of an `.npy` file of whole numbers that are not negative.
pub(super) fn whole_numbers(content: &[u8]) -> Option<Vec<usize>> {
    let numbers = Numbers::parse_as(content, content.len() as u64, Element::integer).ok()?;
    let is_whole = matches!(numbers.kind, Kind::Signed(_) | Kind::Unsigned(_));
    let values = numbers.values.into_iter().map(|v| usize::try_from(v).ok());
    is_whole.then(|| values.collect())?
}

impl<T: Copy> Numbers<T> {
    fn parse_as(
        mut file: impl Read,
        length: u64,
        value: fn(Element, &[u8]) -> T,
    ) -> Result<Self, String> {
        let header = Header::read(&mut file)?;
        header.count_of(length)?;
        let mut values = header.element.read_as(&mut file, &header.shape, value)?;
        // An archive compares the checksum of an array at its end
        let end = file.read(&mut [0u8]);
        end.map_err(|e| format!("damaged: {e}"))?;
        if header.is_fortran {
            values = in_c_order(&header.shape, &values);
        }
        Ok(Numbers {
            shape: header.shape,
            kind: header.element.kind,
            values,
        })
    }
}

/// A shape as NumPy writes it.
pub(super) fn tuple(shape: &[usize]) -> String {
    let numbers: Vec<String> = shape.iter().map(usize::to_string).collect();
    let comma = if shape.len() == 1 { "," } else { "" };
    format!("({}{comma})", numbers.join(", "))
}

/// Values whose first index runs fastest, with the last one fastest.
fn in_c_order<T: Copy>(shape: &[usize], values: &[T]) -> Vec<T> {
    let mut index = vec![0; shape.len()];
    let mut place = 0;
    (0..values.len())
        .map(|_| {
            let value = values[place];
            let mut step = values.len();
            for (i, &n) in index.iter_mut().zip(shape).rev() {
                step /= n;
                *i += 1;
                place += step;
                if *i < n {
                    break;
                }
                place -= step * n;
                *i = 0;
            }
            value
        })
        .collect()
}

/// How one number is stored.
#[derive(Clone, Copy)]
pub(super) struct Element {
    pub(super) kind: Kind,
    pub(super) is_big_endian: bool,
}

impl Kind {
    pub(super) fn bytes(self) -> usize {
        match self {
            Kind::Float(bytes) | Kind::Signed(bytes) | Kind::Unsigned(bytes) => bytes,
            Kind::Bool => 1,
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
impl Element {
    /// `<f4`, `>i2`, `|b1`, …
    fn parse(text: &str) -> Option<Self> {
        let (order, kind) = text.split_at_checked(1)?;
        let (letter, bytes) = kind.split_at_checked(1)?;
        let bytes: usize = bytes.parse().ok()?;
        let kind = match (letter, bytes) {
            ("f", 2 | 4 | 8) => Kind::Float(bytes),
            ("i", 1 | 2 | 4 | 8) => Kind::Signed(bytes),
            ("u", 1 | 2 | 4 | 8) => Kind::Unsigned(bytes),
            ("b", 1) => Kind::Bool,
            _ => return None,
        };
        Some(Element {
            kind,
            is_big_endian: match order {
                "<" | "|" => false,
                ">" => true,
                _ => return None,
            },
        })
    }

    /// The numbers of an array of this shape.
    pub(super) fn read_all(self, file: impl Read, shape: &[usize]) -> Result<Vec<f32>, String> {
        self.read_as(file, shape, Element::value)
    }

    fn read_as<T>(
        self,
        mut file: impl Read,
        shape: &[usize],
        value: fn(Element, &[u8]) -> T,
    ) -> Result<Vec<T>, String> {
        let count = shape.iter().try_fold(1usize, |n, &m| n.checked_mul(m));
        let count = count.filter(|&count| count <= MOST_NUMBERS);
        let mut values = Vec::new();
        let Some(count) = count.filter(|&count| values.try_reserve_exact(count).is_ok()) else {
            return Err(format!(
                "an array {} that does not fit into memory ({MOST_NUMBERS} numbers at most)",
                tuple(shape)
            ));
        };
        let size = self.kind.bytes();
        let mut block = vec![0u8; size * count.clamp(1, 1 << 16)];
        let mut farthest = (0, 0.0);
        while values.len() < count {
            let now = &mut block[..size * (count - values.len()).min(1 << 16)];
            file.read_exact(now).map_err(|e| match e.kind() {
                ErrorKind::UnexpectedEof => {
                    format!("truncated: no {count} numbers of {size} bytes")
                }
                _ => format!("damaged: {e}"),
            })?;
            if self.kind == Kind::Float(8) {
                let doubles = now.chunks_exact(8).map(|b| f64::from_bits(self.word(b)));
                let finite = (values.len()..).zip(doubles).filter(|(_, v)| v.is_finite());
                farthest = finite.fold(farthest, |far, v| match v.1.abs() > f64::abs(far.1) {
                    true => v,
                    false => far,
                });
            }
            values.extend(now.chunks_exact(size).map(|bytes| value(self, bytes)));
        }
        Self::must_fit(farthest)?;
        Ok(values)
    }

    /// Refuses numbers of which the one farthest from 0 becomes infinite as f32, or 0 and so all of them.
    fn must_fit((place, farthest): (usize, f64)) -> Result<(), String> {
        let as_f32 = farthest as f32;
        match as_f32.is_finite() && (as_f32 != 0.0 || farthest == 0.0) {
            true => Ok(()),
            false => Err(format!(
                "the number farthest from 0 is {farthest:e} (at place {place}, from 0): arrays are read as f32, which has 0 and ±1e-45 to ±3.4e38"
            )),
        }
    }

    pub(super) fn word(self, bytes: &[u8]) -> u64 {
        match self.is_big_endian {
            true => bytes
                .iter()
                .fold(0, |word, &byte| word << 8 | u64::from(byte)),
            false => little_endian(bytes),
        }
    }

    /// The whole number of such a kind.
    pub(super) fn integer(self, bytes: &[u8]) -> i64 {
        // The sign goes to the top and comes back
        let unused = match self.kind {
            Kind::Signed(bytes) => 64 - 8 * bytes,
            _ => 0,
        };
        (self.word(bytes) << unused).cast_signed() >> unused
    }

    pub(super) fn value(self, bytes: &[u8]) -> f32 {
        let word = self.word(bytes);
        match self.kind {
            Kind::Float(2) => half(word as u16),
            Kind::Float(4) => f32::from_bits(word as u32),
            Kind::Float(_) => f64::from_bits(word) as f32,
            Kind::Signed(_) => self.integer(bytes) as f32,
            Kind::Unsigned(_) => word as f32,
            Kind::Bool => f32::from(u8::from(word != 0)),
        }
    }
}

/// The number of these bytes, the lowest first.
#[inline]
fn little_endian(bytes: &[u8]) -> u64 {
    let join = |word: u64, &byte: &u8| word << 8 | u64::from(byte);
    bytes.iter().rev().fold(0, join)
}

/// A float of 16 bits (IEEE 754 binary16): sign, 5 bits of exponent, 10 of fraction.
fn half(bits: u16) -> f32 {
    let fraction = f32::from(bits & 0x3ff);
    let size = match bits >> 10 & 0x1f {
        0 => fraction * 2f32.powi(-24),
        31 if fraction == 0.0 => f32::INFINITY,
        31 => f32::NAN,
        exponent => (1024.0 + fraction) * 2f32.powi(i32::from(exponent) - 25),
    };
    if bits >> 15 == 1 { -size } else { size }
}

/// A file and its length.
fn opened(path: &Path) -> Result<(BufReader<File>, u64)> {
    let file = open_regular(path)?;
    let length = file.metadata().map_err(|e| Error::io(path, e))?.len();
    Ok((BufReader::new(file), length))
}

/// What an `.npy` file says before its numbers.
pub(super) struct Header {
    element: Element,
    is_fortran: bool,
    shape: Vec<usize>,
    /// Bytes of all of it.
    length: u64,
}

impl Header {
    /// The header of an `.npy` file that is as long as it says.
    pub(super) fn read_file(path: &Path, accepted: &str) -> Result<Self> {
        let (mut file, length) = opened(path)?;
        let header = Header::read(&mut file);
        let header = header.and_then(|header| header.count_of(length).map(|_| header));
        header.map_err(|found| Error::format(path, found, accepted))
    }

    /// How many numbers follow in a file of so many bytes.
    fn count_of(&self, length: u64) -> Result<usize, String> {
        let count = self.shape.iter().try_fold(1usize, |n, &m| n.checked_mul(m));
        let size = self.element.kind.bytes();
        let bytes = count.and_then(|count| u64::try_from(count.checked_mul(size)?).ok());
        let (Some(count), Some(whole)) = (count, bytes.and_then(|b| b.checked_add(self.length)))
        else {
            return Err(format!("an array of shape {}", tuple(&self.shape)));
        };
        if whole == length {
            return Ok(count);
        }
        let what = match whole > length {
            true => "truncated",
            false => "more than an array",
        };
        Err(format!(
            "{what}: an array {} of {size} bytes a number takes {whole} bytes with its header, {length} are there",
            tuple(&self.shape)
        ))
    }

    fn read(file: &mut impl Read) -> Result<Self, String> {
        let mut start = Vec::new();
        let cut = |e: std::io::Error| format!("damaged: {e}");
        file.take(8).read_to_end(&mut start).map_err(cut)?;
        if start.get(..6) != Some(b"\x93NUMPY") {
            return Err(match start.get(..2) {
                None => "the file is empty".to_owned(),
                Some(b"PK") => "an .npz archive under another name: rename it to .npz".to_owned(),
                _ => format!("not a NumPy array: it begins with `{}`", beginning(&start)),
            });
        }
        // Version 1 has two bytes for the length of the text, later ones four
        let wide = start.get(6).is_some_and(|version| *version > 1);
        let mut length = Vec::new();
        file.take(if wide { 4 } else { 2 })
            .read_to_end(&mut length)
            .map_err(cut)?;
        let text_length = little_endian(&length);
        let mut text = Vec::new();
        file.take(text_length.min(LONGEST_HEADER))
            .read_to_end(&mut text)
            .map_err(cut)?;
        if (text.len() as u64) < text_length || text.is_empty() {
            return Err("truncated: it ends within its header".to_owned());
        }
        let length = (start.len() + length.len() + text.len()) as u64;
        Self::parse(&String::from_utf8_lossy(&text), length)
    }

    /// A Python dictionary of three entries.
    fn parse(text: &str, length: u64) -> Result<Self, String> {
        let damaged = || format!("a damaged header: {}", text.trim());
        let entry = |key: &str| {
            let after = text.split_once(&format!("'{key}':")).map(|(_, rest)| rest);
            after.map(str::trim_start).ok_or_else(damaged)
        };
        let descr = entry("descr")?;
        let quote = descr.chars().next().filter(|c| matches!(c, '\'' | '"'));
        let kind = quote.and_then(|quote| descr[1..].split(quote).next());
        let element = kind.and_then(Element::parse).ok_or_else(|| match kind {
            Some(kind) => format!("elements of type `{kind}`"),
            None => "elements of several fields".to_owned(),
        })?;
        let shape = entry("shape")?
            .strip_prefix('(')
            .and_then(|s| s.split_once(')'));
        let (shape, _) = shape.ok_or_else(damaged)?;
        let counts = shape.split(',').map(str::trim).filter(|n| !n.is_empty());
        let counts = counts.map(|n| n.trim_end_matches('L').parse());
        Ok(Header {
            element,
            is_fortran: entry("fortran_order")?.starts_with("True"),
            shape: counts.collect::<Result<_, _>>().map_err(|_| damaged())?,
            length,
        })
    }
}

/// The first bytes of a file as text.
fn beginning(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    text.chars().filter(|c| !c.is_control()).collect()
}

/// An `.npz` file.
pub(super) struct Archive {
    zip: zip::ZipArchive<BufReader<File>>,
    path: PathBuf,
    accepted: String,
}

impl Archive {
    /// Opens an archive; errors say `accepted`.
    pub(super) fn open(path: &Path, accepted: &str) -> Result<Self> {
        let file = open_regular(path)?;
        let zip = zip::ZipArchive::new(BufReader::new(file)).map_err(|error| {
            let found = no_archive(path).unwrap_or_else(|| format!("no .npz archive: {error}"));
            Error::format(path, found, accepted)
        })?;
        Ok(Archive {
            zip,
            path: path.to_owned(),
            accepted: accepted.to_owned(),
        })
    }

    /// Names of the arrays, in alphabetical order.
    pub(super) fn names(&self) -> Vec<String> {
        let names = self.zip.file_names();
        let mut names: Vec<String> = names
            .map(|n| n.trim_end_matches(".npy").to_owned())
            .collect();
        names.sort();
        names
    }

    /// The name of the array that the caller names, or of the only one.
    pub(super) fn chosen(&self, asked: Option<&str>) -> Result<String> {
        let names = self.names();
        let name = match (asked, &names[..]) {
            (None, [only]) => Some(only),
            (None, _) => None,
            (Some(asked), _) => names.iter().find(|name| *name == asked),
        };
        name.cloned().ok_or_else(|| {
            let asked_for = asked.map_or("no array is named".to_owned(), |name| {
                format!("no array `{name}`")
            });
            let known = names.iter().map(String::as_str);
            let near = asked.and_then(|asked| nearest_name(asked, known));
            let example = near.or(names.first().map(String::as_str)).unwrap_or("dose");
            let found = format!("{asked_for}; it holds {}", names.join(", "));
            let accepted = format!(
                "FILE.npz:NAME, for example {}:{example}",
                self.path.display()
            );
            Error::format(&self.path, found, &accepted)
        })
    }

    pub(super) fn numbers(&mut self, name: &str) -> Result<Numbers> {
        self.array(name, |array, length| Numbers::parse(array, length))
    }

    /// The content of an array by its name, header and all.
    pub(super) fn bytes(&mut self, name: &str) -> Result<Vec<u8>> {
        self.array(name, |array, _| {
            let mut bytes = Vec::new();
            let read = array.read_to_end(&mut bytes);
            read.map(|_| bytes).map_err(|e| e.to_string())
        })
    }

    fn array<T>(
        &mut self,
        name: &str,
        read: impl FnOnce(&mut dyn Read, u64) -> Result<T, String>,
    ) -> Result<T> {
        let file = format!("{name}.npy");
        let file = if self.zip.index_for_name(&file).is_some() {
            &file
        } else {
            name
        };
        let array = self.zip.by_name(file).map_err(|e| e.to_string());
        let array = array.and_then(|mut array| {
            let length = array.size();
            read(&mut array, length)
        });
        array.map_err(|found| Error::format(&self.path, format!("{name}: {found}"), &self.accepted))
    }
}

/// Why a file that begins like an archive is none: its arrays say where they end (APPNOTE.TXT, 4.3.7 and 4.5.3).
fn no_archive(path: &Path) -> Option<String> {
    let mut file = open_regular(path).ok()?;
    let length = file.metadata().ok()?.len();
    let mut at = 0;
    loop {
        let mut head = Vec::new();
        file.seek(SeekFrom::Start(at)).ok()?;
        (&mut file).take(30).read_to_end(&mut head).ok()?;
        let number = |from: usize, bytes: usize| head.get(from..from + bytes).map(little_endian);
        if at == 0 && head.get(..4) != Some(b"PK\x03\x04") {
            let start = beginning(&head[..head.len().min(8)]);
            return (!head.starts_with(b"PK")).then(|| match head.len() {
                0 => "the file is empty".to_owned(),
                _ if head.starts_with(b"\x89PNG") => {
                    "a PNG image; frames go into a folder, one file each".to_owned()
                }
                _ => format!("not an .npz archive: it begins with `{start}`"),
            });
        }
        if head.get(..4) != Some(b"PK\x03\x04") {
            return Some(format!(
                "truncated: the directory at the end of the archive is not whole, the file has {length} bytes"
            ));
        }
        let (Some(name_length), Some(extra_length)) = (number(26, 2), number(28, 2)) else {
            return Some(format!(
                "truncated: it ends at byte {length} before an array"
            ));
        };
        let mut rest = Vec::new();
        (&mut file)
            .take(name_length + extra_length)
            .read_to_end(&mut rest)
            .ok()?;
        let name = beginning(&rest[..rest.len().min(name_length as usize)]);
        let size = match number(18, 4)? {
            // Sizes beyond 4 GB, or of unknown length when they were written: two words of 8 bytes
            0xffff_ffff => rest
                .get(name_length as usize + 12..name_length as usize + 20)
                .map_or(0, little_endian),
            size => size,
        };
        let end = at + 30 + name_length + extra_length + size;
        if end > length {
            return Some(format!(
                "truncated: its array `{}` ends at byte {end}, the file has {length} bytes",
                name.trim_end_matches(".npy")
            ));
        }
        at = end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn npy(descr: &str, order: &str, shape: &str, data: &[u8]) -> Vec<u8> {
        let text =
            format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': ({shape}), }}");
        let text = format!("{text:<117}\n");
        [b"\x93NUMPY\x01\x00\x76\x00", text.as_bytes(), data].concat()
    }

    fn parse(bytes: &[u8]) -> Result<Numbers, String> {
        Numbers::parse(bytes, bytes.len() as u64)
    }

    #[test]
    fn every_type_and_byte_order_is_a_number() {
        for (descr, data, expected) in [
            ("<f4", &[0, 0, 0xc0, 0x3f][..], 1.5),
            (">f4", &[0x3f, 0xc0, 0, 0], 1.5),
            (">f8", &[0xbf, 0xf8, 0, 0, 0, 0, 0, 0], -1.5),
            ("<f2", &[0x00, 0xc1], -2.5),
            (">f2", &[0x3c, 0x00], 1.0),
            ("|u1", &[200], 200.0),
            ("|i1", &[0xff], -1.0),
            ("|b1", &[1], 1.0),
            ("<u2", &[1, 2], 513.0),
            (">u2", &[1, 2], 258.0),
            ("<i2", &[0xfe, 0xff], -2.0),
            (">i4", &[0xff, 0xff, 0xff, 0xfd], -3.0),
            ("<u4", &[0, 0, 0, 1], 16_777_216.0),
            (
                "<i8",
                &[0xfc, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff],
                -4.0,
            ),
            (">u8", &[0, 0, 0, 0, 0, 0, 1, 0], 256.0),
        ] {
            let found = parse(&npy(descr, "False", "1,", data)).unwrap();
            assert_eq!(found.values, [expected], "{descr}");
        }
        // Smallest, largest, infinite: 2⁻²⁴, 65504
        assert_eq!(half(1), 2f32.powi(-24));
        assert_eq!(half(0x7bff), 65504.0);
        assert_eq!(half(0xfc00), f32::NEG_INFINITY);
        assert!(half(0x7e00).is_nan());
        // What is small next to the largest number may become 0
        let doubles = |a: f64, b: f64| {
            let data = [a.to_le_bytes(), b.to_le_bytes()].concat();
            parse(&npy("<f8", "False", "2,", &data)).map(|found| found.values)
        };
        assert_eq!(doubles(1e-300, -0.5).unwrap(), [0.0, -0.5]);
        assert_eq!(doubles(0.0, -0.0).unwrap(), [0.0, 0.0]);
        assert!(doubles(f64::NAN, f64::INFINITY).is_ok());
        for (a, b, found) in [
            (0.5, -1e300, "is -1e300 (at place 1, from 0)"),
            (9e-300, 2e-300, "is 9e-300 (at place 0, from 0)"),
        ] {
            tomolith_core::contains!(doubles(a, b).unwrap_err(), found, "3.4e38");
        }
        for descr in ["<c8", "|O", "<f16", "<U4"] {
            let text = parse(&npy(descr, "False", "1,", &[0; 16])).unwrap_err();
            assert_eq!(text, format!("elements of type `{descr}`"));
        }
    }

    #[test]
    fn fortran_order_is_turned_round_in_any_dimension() {
        for shape in [vec![2, 3, 4], vec![3, 2], vec![5], vec![2, 1, 3, 2]] {
            let count: usize = shape.iter().product();
            // The element of index i, j, k has the value of its place in C order
            let mut data = vec![0; count];
            for (c, _) in (0..count).enumerate() {
                let (mut rest, mut place, mut step) = (c, 0, count);
                for (axis, &n) in shape.iter().enumerate() {
                    step /= n;
                    let before: usize = shape[..axis].iter().product();
                    place += rest / step * before;
                    rest %= step;
                }
                data[place] = c as u8;
            }
            let text = tuple(&shape);
            let found = parse(&npy("|u1", "True", text.trim_matches(['(', ')']), &data)).unwrap();
            let expected: Vec<f32> = (0..count).map(|c| c as f32).collect();
            assert_eq!(found.values, expected, "{text}");
        }
    }

    #[test]
    fn axes_of_length_one_beside_the_others_do_not_count() {
        for (shape, expected) in [
            ("2, 3, 4, 1", [2, 3, 4]),
            ("1, 2, 3, 4", [2, 3, 4]),
            ("1, 2, 12, 1", [1, 2, 12]),
            ("2, 12, 1", [2, 12, 1]),
        ] {
            let found = parse(&npy("|u1", "False", shape, &[7; 24])).unwrap();
            assert_eq!(found.into_volume().unwrap().0, expected, "{shape}");
        }
        let found = parse(&npy("|u1", "False", "2, 2, 2, 3", &[7; 24])).unwrap();
        let text = found.of_dimensions::<3>().unwrap_err();
        assert!(text.contains("shape (2, 2, 2, 3), instead of 3"), "{text}");
    }

    #[test]
    fn what_is_cut_off_is_told_with_its_bytes() {
        let whole = npy("<f4", "False", "2, 3", &[0; 24]);
        assert_eq!(parse(&whole).unwrap().shape, [2, 3]);
        let text = parse(&whole[..140]).unwrap_err();
        let expected = "truncated: an array (2, 3) of 4 bytes a number takes 152 bytes with its header, 140 are there";
        assert_eq!(text, expected);
        for (bytes, found) in [
            (&whole[..60], "within its header"),
            (b"", "empty"),
            (b"some text", "it begins with `some tex`"),
            (b"PK\x03\x04....", ".npz"),
            (&[&whole[..], &[0; 4]].concat(), "more than an array"),
            // A count beyond all memory is not reserved
            (
                &npy("<f4", "False", "999999999999, 999999", &[0; 4]),
                "999999999999",
            ),
        ] {
            tomolith_core::contains!(parse(bytes).unwrap_err(), found);
        }
    }

    #[test]
    fn an_array_that_is_not_what_was_written_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npz");
        let mut npz = ndarray_npy::NpzWriter::new(File::create(&path).unwrap());
        let ones = ndarray::Array1::<f32>::ones(100);
        npz.add_array("ones", &ones).unwrap();
        npz.finish().unwrap();
        let mut bytes = std::fs::read(&path).unwrap();
        let one = 1f32.to_le_bytes();
        let at = bytes.windows(4).position(|four| four == one).unwrap();
        let read = |bytes: &[u8]| {
            std::fs::write(&path, bytes).unwrap();
            Archive::open(&path, "")?.numbers("ones")
        };
        assert!(read(&bytes).is_ok());
        bytes[at + 1] ^= 1; // 1.0000305: the checksum alone can tell
        let text = read(&bytes).map(drop).unwrap_err().to_string();
        assert!(text.contains("ones: damaged: Invalid checksum"), "{text}");
    }

    #[test]
    fn a_truncated_archive_names_the_array_and_its_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npz");
        let mut npz = ndarray_npy::NpzWriter::new(File::create(&path).unwrap());
        let zeros = ndarray::Array1::<f32>::zeros(100);
        npz.add_array("first", &zeros).unwrap();
        npz.add_array("second", &zeros).unwrap();
        npz.finish().unwrap();
        let whole = std::fs::read(&path).unwrap();
        let found = |bytes: &[u8]| {
            std::fs::write(&path, bytes).unwrap();
            Archive::open(&path, "").map(drop).unwrap_err().to_string()
        };
        let text = found(&whole[..700]);
        tomolith_core::contains!(
            text,
            "its array `second` ends at byte ",
            "the file has 700 bytes"
        );
        tomolith_core::contains!(found(&whole[..300]), "array `first`");
        tomolith_core::contains!(
            found(&whole[..whole.len() - 10]),
            "truncated: the directory"
        );
        tomolith_core::contains!(found(b"no archive at all"), "it begins with `no archi`");
    }
}
