//! Writing NumPy arrays, alone or in an archive. Reading is in [`numbers`](super::numbers).
//!
//! An array is a header (`numpy.lib.format`, version 1: magic, version, length, a Python dictionary, padded so that the numbers begin at a
//! multiple of 64 bytes) and its numbers in C order and the byte order of this machine. An archive stores arrays, not compressed, in a zip file.

use bytemuck::NoUninit;
use std::io::{Result, Seek, Write};
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

/// Writes an array.
///
/// # Errors
/// Those of the file.
pub(super) fn write_array<T: Element>(
    file: &mut impl Write,
    shape: &[usize],
    values: &[T],
) -> Result<()> {
    file.write_all(&header(T::KIND, shape))?;
    file.write_all(bytemuck::cast_slice(values))
}

/// An `.npz` that is being written.
pub(super) struct ArchiveWriter<W: Write + Seek>(ZipWriter<W>);

impl<W: Write + Seek> ArchiveWriter<W> {
    pub(super) fn new(file: W) -> Self {
        ArchiveWriter(ZipWriter::new(file))
    }

    /// Adds an array.
    ///
    /// # Errors
    /// Those of the file.
    pub(super) fn add<T: Element>(
        &mut self,
        name: &str,
        shape: &[usize],
        values: &[T],
    ) -> Result<()> {
        self.start(name, size_of_val(values))?;
        write_array(&mut self.0, shape, values)
    }

    /// Adds an array of one text.
    ///
    /// # Errors
    /// Those of the file.
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
    ///
    /// # Errors
    /// Those of the file.
    pub(super) fn finish(self) -> Result<()> {
        self.0.finish()?;
        Ok(())
    }
}
