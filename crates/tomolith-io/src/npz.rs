//! Writing NumPy arrays, alone or in an archive. Reading is in [`numbers`](super::numbers).
//!
//! An array is a header (`numpy.lib.format`, version 1: magic, version, length, a Python dictionary, padded so that the numbers begin at a
//! multiple of 64 bytes) and its numbers in C order and the byte order of this machine. An archive stores arrays, not compressed, in a zip file.

use bytemuck::NoUninit;
use std::io::{Error, ErrorKind, Result, Seek, SeekFrom, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// A number that NumPy knows.
pub trait Element: NoUninit {
    /// Its type in NumPy, without the byte order: `f4`.
    const KIND: &'static str;
}

macro_rules! elements {
    ($($number:ty: $kind:literal),*) => {
        $(impl Element for $number {
            const KIND: &'static str = $kind;
        })*
    };
}

elements!(u8: "u1", u16: "u2", i32: "i4", i64: "i8", f32: "f4", f64: "f8");

/// What stands before the numbers of an array; `kind` is such as `f4`, or `S3` for a text of three bytes.
pub(super) fn header(kind: &str, shape: &[usize]) -> Vec<u8> {
    let order = match kind {
        "u1" => '|',
        _ if kind.starts_with('S') => '|',
        _ if cfg!(target_endian = "big") => '>',
        _ => '<',
    };
    let shape = super::numbers::tuple(shape);
    let text = format!("{{'descr': '{order}{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    // Magic, version and length take ten bytes, the last byte is the end of a line
    let length = (10 + text.len() + 1).next_multiple_of(64) - 10;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(format!("{text:<0$}\n", length - 1).as_bytes());
    bytes
}

pub(super) fn write_array<T: Element>(
    file: &mut impl Write,
    shape: &[usize],
    values: &[T],
) -> Result<()> {
    file.write_all(&header(T::KIND, shape))?;
    file.write_all(bytemuck::cast_slice(values))
}

/// Remembers the first error of a file and takes everything after it without writing.
///
/// A zip writer that is dropped after an error tries once more and complains on standard error, where a library has
/// nothing to say.
struct Sink<W> {
    inner: W,
    failed: Option<Error>,
    position: u64,
    length: u64,
}

impl<W: Write + Seek> Sink<W> {
    /// Does something with the file, unless it has failed before.
    fn attempt(&mut self, act: impl FnOnce(&mut W) -> Result<()>) {
        if self.failed.is_none() {
            self.failed = act(&mut self.inner).err();
        }
    }
}

impl<W: Write + Seek> Write for Sink<W> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        self.attempt(|file| file.write_all(bytes));
        self.position += bytes.len() as u64;
        self.length = self.length.max(self.position);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<()> {
        self.attempt(W::flush);
        Ok(())
    }
}

impl<W: Write + Seek> Seek for Sink<W> {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        let from_start = match to {
            SeekFrom::Start(place) => Some(place),
            SeekFrom::Current(by) => self.position.checked_add_signed(by),
            SeekFrom::End(by) => self.length.checked_add_signed(by),
        };
        let place = from_start.ok_or(ErrorKind::InvalidInput)?;
        self.attempt(|file| file.seek(SeekFrom::Start(place)).map(drop));
        self.position = place;
        Ok(place)
    }
}

/// An `.npz` that is being written; its errors are those of [`finish`](Self::finish).
pub(super) struct ArchiveWriter<W: Write + Seek>(ZipWriter<Sink<W>>);

impl<W: Write + Seek> ArchiveWriter<W> {
    pub(super) fn new(file: W) -> Self {
        ArchiveWriter(ZipWriter::new(Sink {
            inner: file,
            failed: None,
            position: 0,
            length: 0,
        }))
    }

    pub(super) fn add<T: Element>(
        &mut self,
        name: &str,
        shape: &[usize],
        values: &[T],
    ) -> Result<()> {
        self.start(name, size_of_val(values))?;
        write_array(&mut self.0, shape, values)
    }

    pub(super) fn add_text(&mut self, name: &str, text: &str) -> Result<()> {
        self.start(name, text.len())?;
        self.0
            .write_all(&header(&format!("S{}", text.len()), &[]))?;
        self.0.write_all(text.as_bytes())
    }

    fn start(&mut self, name: &str, bytes: usize) -> Result<()> {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .large_file(bytes >= u32::MAX as usize / 2);
        Ok(self.0.start_file(format!("{name}.npy"), options)?)
    }

    /// Writes the list of arrays at the end.
    pub(super) fn finish(self) -> Result<()> {
        let sink = self.0.finish()?;
        sink.failed.map_or(Ok(()), Err)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    /// A disk with room for so many bytes.
    struct Small(Cursor<Vec<u8>>, usize);

    impl Write for Small {
        fn write(&mut self, bytes: &[u8]) -> Result<usize> {
            if self.0.get_ref().len() + bytes.len() > self.1 {
                return Err(ErrorKind::StorageFull.into());
            }
            self.0.write(bytes)
        }
        fn flush(&mut self) -> Result<()> {
            Ok(())
        }
    }

    impl Seek for Small {
        fn seek(&mut self, to: SeekFrom) -> Result<u64> {
            self.0.seek(to)
        }
    }

    #[test]
    fn a_zip_on_a_full_disk_ends_with_the_first_error_and_without_a_word() {
        let write = |room: usize| {
            let mut disk = Small(Cursor::default(), room);
            let mut npz = ArchiveWriter::new(&mut disk);
            npz.add("patterns", &[4, 5, 6], &[1.0f32; 120]).unwrap();
            let failed = npz.finish().err().map(|e| e.kind());
            (failed, disk.0.into_inner())
        };
        let (failed, whole) = write(usize::MAX);
        assert!(failed.is_none() && whole.starts_with(b"PK"));
        let mut npz = ndarray_npy::NpzReader::new(Cursor::new(whole.clone())).unwrap();
        let array: ndarray::Array3<f32> = npz.by_name("patterns").unwrap();
        assert_eq!(array, ndarray::Array3::<f32>::ones((4, 5, 6)));
        for room in [0, 10, whole.len() / 2, whole.len() - 1] {
            assert_eq!(write(room).0, Some(ErrorKind::StorageFull), "{room}");
        }
    }
}
