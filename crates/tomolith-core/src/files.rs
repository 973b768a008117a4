//! Opening files that others name: regular files only.
//!
//! A device such as `/dev/zero` never ends and a FIFO waits for a writer, so both are refused before a byte is read. Every
//! reader opens its input here.
//!
//! ```
//! use tomolith_core::files::read_regular;
//! let folder = tempfile::tempdir().unwrap();
//! let text = read_regular(folder.path()).unwrap_err().to_string();
//! assert!(text.ends_with("is a folder, not a regular file"), "{text}");
//! ```

use super::error::{Error, Result};
use std::fs::{File, FileType, metadata};
use std::io::{ErrorKind, Read as _};
use std::path::Path;

/// Opens a regular file, or a link to one, for reading.
///
/// # Errors
/// [`Error::Io`] when there is no such file, it cannot be opened, or is a folder, a device, a FIFO or a socket.
pub fn open_regular(path: impl AsRef<Path>) -> Result<File> {
    let path = path.as_ref();
    let refused = |e| Error::io(path, e);
    // Before opening, which waits where a FIFO has no writer; and after, in case the name changed hands meanwhile
    refuse_special(metadata(path).map_err(refused)?.file_type()).map_err(refused)?;
    let file = File::open(path).map_err(refused)?;
    refuse_special(file.metadata().map_err(refused)?.file_type()).map_err(refused)?;
    Ok(file)
}

/// The content of a regular file.
///
/// # Errors
/// As [`open_regular`]; [`Error::Io`] when it cannot be read, or memory does not hold it.
pub fn read_regular(path: impl AsRef<Path>) -> Result<Vec<u8>> {
    let path = path.as_ref();
    let refused = |e| Error::io(path, e);
    let mut file = open_regular(path)?;
    let size = file.metadata().map_err(refused)?.len();
    let mut bytes = Vec::new();
    bytes
        .try_reserve_exact(usize::try_from(size).unwrap_or(usize::MAX))
        .map_err(|e| refused(std::io::Error::new(ErrorKind::OutOfMemory, e)))?;
    file.read_to_end(&mut bytes).map_err(refused)?;
    Ok(bytes)
}

/// The content of a regular file of at most so many megabytes.
///
/// # Errors
/// As [`read_regular`]; [`Error::Format`] for a larger one, before it is read.
pub fn read_at_most(path: impl AsRef<Path>, most_mb: u64) -> Result<Vec<u8>> {
    let path = path.as_ref();
    let size = metadata(path).map_err(|e| Error::io(path, e))?.len();
    if size > most_mb * 1_000_000 {
        return Err(Error::format(
            path,
            format!("a file of {:.1} MB", size as f64 / 1e6),
            format!("a file of {most_mb} MB at most"),
        ));
    }
    read_regular(path)
}

/// Largest file that is read as a text.
const MOST_TEXT_MB: u64 = 256;

/// The text of a regular file.
///
/// # Errors
/// As [`read_at_most`]; [`Error::Format`] for bytes that are not UTF-8.
pub fn read_text(path: impl AsRef<Path>) -> Result<String> {
    let path = path.as_ref();
    let bytes = read_at_most(path, MOST_TEXT_MB)?;
    String::from_utf8(bytes).map_err(|_| {
        Error::format(
            path,
            "bytes that are not UTF-8 text",
            "a text file in UTF-8",
        )
    })
}

fn refuse_special(kind: FileType) -> std::io::Result<()> {
    if kind.is_file() {
        return Ok(());
    }
    let (error, what) = if kind.is_dir() {
        (ErrorKind::IsADirectory, "a folder")
    } else {
        (ErrorKind::InvalidInput, "a device, a FIFO or a socket")
    };
    let text = format!("is {what}, not a regular file");
    Err(std::io::Error::new(error, text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regular_files_and_links_to_them_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        assert!(matches!(read_regular(&path), Err(Error::Io { .. })));
        std::fs::write(&path, b"content").unwrap();
        assert_eq!(read_regular(&path).unwrap(), b"content");
        #[cfg(unix)]
        {
            let link = folder.path().join("b");
            std::os::unix::fs::symlink(&path, &link).unwrap();
            assert_eq!(read_regular(&link).unwrap(), b"content");
        }
    }

    #[test]
    fn a_file_that_is_too_large_is_refused_by_its_size() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let file = File::create(&path).unwrap();
        file.set_len(3_000_000).unwrap();
        assert_eq!(read_at_most(&path, 3).unwrap().len(), 3_000_000);
        let text = read_at_most(&path, 2).unwrap_err().to_string();
        assert!(
            text.ends_with("a file of 3.0 MB; accepted: a file of 2 MB at most"),
            "{text}"
        );
        // Far more than is read as a text
        file.set_len(1 << 40).unwrap();
        assert!(read_text(&path).is_err());
        std::fs::write(&path, [0xff]).unwrap();
        assert!(
            read_text(&path)
                .unwrap_err()
                .to_string()
                .contains("not UTF-8")
        );
    }

    #[test]
    #[cfg(unix)]
    fn devices_fifos_and_links_to_them_are_refused_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let (fifo, link) = (folder.path().join("fifo"), folder.path().join("link"));
        let made = std::process::Command::new("mkfifo").arg(&fifo).status();
        assert!(made.unwrap().success());
        std::os::unix::fs::symlink("/dev/zero", &link).unwrap();
        for path in [&fifo, &link] {
            let text = open_regular(path).unwrap_err().to_string();
            assert!(text.contains("a device, a FIFO or a socket"), "{text}");
        }
    }
}
