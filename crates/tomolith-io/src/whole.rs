//! Files and folders that appear whole or not at all.
//!
//! A file is written aside in the same folder under a hidden name, brought to the disk, then renamed over its place.
//! Whatever stops the program meanwhile, the place holds the old content or the new one. What is left aside
//! (`.NAME.PID-N.partial`) by a killed program can be deleted; a program that ends itself in the middle of its work first calls
//! [`give_up`].
//!
//! ```
//! use std::io::Write;
//! use tomolith_io::write_whole;
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("history.csv");
//! write_whole(&path, |file| Ok(file.write_all(b"iteration\n")?)).unwrap();
//! assert_eq!(std::fs::read(&path).unwrap(), b"iteration\n");
//! ```

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{BufWriter, ErrorKind, Seek, SeekFrom, Write};
use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use tomolith_core::error::{Error, Result};
use tomolith_core::text::file_name;
use tomolith_core::work::{Steps, Work};

/// Reason why the content of a file could not be written: the system's, or the format's.
#[derive(Debug)]
pub enum Refused {
    /// The system refused; [`write_whole`] adds the path.
    Io(std::io::Error),
    /// Another error, passed on unchanged.
    Other(Error),
}

impl From<std::io::Error> for Refused {
    fn from(error: std::io::Error) -> Self {
        Refused::Io(error)
    }
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        Refused::Other(error)
    }
}

impl Refused {
    fn at(self, path: &Path) -> Error {
        match self {
            Refused::Io(source) => not_made(path, "written", &source),
            Refused::Other(error) => error,
        }
    }
}

/// What the system says of a place that cannot be made or written.
fn not_made(path: &Path, what: &str, source: &std::io::Error) -> Error {
    let text = format!("it cannot be {what}: {source}");
    Error::io(path, std::io::Error::new(source.kind(), text))
}

/// Makes a folder, and those that it lies in, where they are not there.
///
/// # Errors
/// [`Error::Io`] with the path.
pub fn make_folder(path: &Path) -> Result<()> {
    fs::create_dir_all(path).map_err(|e| not_made(path, "made", &e))
}

/// Writes a file through `write` so that `path` holds the whole of it, or what it held before.
///
/// # Errors
/// [`Error::Io`] with the path, or what `write` returned; `path` is then as it was.
pub fn write_whole<T>(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<Watched<'_>>) -> Result<T, Refused>,
) -> Result<T> {
    write_whole_under(path, &Work::new(), 0, write)
}

/// Writes a text.
///
/// # Errors
/// [`Error::Io`] with the path; `path` is then as it was.
pub fn write_text(path: &Path, text: &str) -> Result<()> {
    write_whole(path, |file| Ok(file.write_all(text.as_bytes())?))
}

/// As [`write_whole`], as a part of a run, which is done after so many bytes.
///
/// # Errors
/// As [`write_whole`]; [`Error::Canceled`], with `path` as it was.
pub fn write_whole_under<T>(
    path: &Path,
    work: &Work,
    bytes: usize,
    write: impl FnOnce(&mut BufWriter<Watched<'_>>) -> Result<T, Refused>,
) -> Result<T> {
    let aside = aside(path)?;
    let written = (|| {
        let watched = Watched {
            file: File::create(&*aside)?,
            steps: work.steps(bytes),
            waiting: 0,
        };
        let mut file = BufWriter::with_capacity(1 << 20, watched);
        let result = write(&mut file)?;
        file.flush()?;
        file.get_ref().file.sync_all()?;
        drop(file);
        fs::rename(&*aside, path)?;
        Ok(result)
    })();
    written.map_err(|refused: Refused| {
        // The first error is the one to report; a leftover does no harm
        let _ = fs::remove_file(&*aside);
        work.check().err().unwrap_or_else(|| refused.at(path))
    })
}

/// Refuses a place for a new file where something is, even a link that leads nowhere; `option` names the place.
///
/// # Errors
/// [`Error::Config`].
pub fn must_be_new(option: &str, path: &Path) -> Result<()> {
    match path.symlink_metadata() {
        Err(e) if e.kind() == ErrorKind::NotFound => Ok(()),
        // A name that is too long, for one
        Err(e) => Err(Error::io(path, e)),
        Ok(_) => {
            let found = format!("`{}` is there already", path.display());
            Err(Error::config(option, found, "a new file"))
        }
    }
}

/// Refuses a place for a new folder where anything is but an empty folder; `option` names the place.
///
/// # Errors
/// [`Error::Config`].
pub fn must_be_free(option: &str, folder: &Path) -> Result<()> {
    let is_free = match fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(_) => folder.symlink_metadata().is_err(),
    };
    if is_free {
        return Ok(());
    }
    let what = match folder.is_dir() {
        true => "is not empty",
        false => "is no folder",
    };
    Err(Error::config(
        option,
        format!("`{}` {what}", folder.display()),
        "a folder that does not exist yet, or an empty one",
    ))
}

/// Bytes that are handed to the system at a time, and that may wait for the disk: a request to stop waits for no more.
const AT_A_TIME: usize = 4 << 20;
const WAITING: usize = 32 << 20;

/// A file being written; writing fails as soon as its run is canceled.
#[derive(Debug)]
pub struct Watched<'r> {
    file: File,
    steps: Steps<'r>,
    /// Bytes that may not be on the disk yet.
    waiting: usize,
}

impl Write for Watched<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.steps.is_canceled() {
            return Err(std::io::Error::other("canceled"));
        }
        let written = self.file.write(&bytes[..bytes.len().min(AT_A_TIME)])?;
        self.steps.add(written);
        self.waiting += written;
        if self.waiting >= WAITING {
            self.file.sync_data()?;
            self.waiting = 0;
        }
        Ok(written)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.flush()
    }
}

impl Seek for Watched<'_> {
    fn seek(&mut self, to: SeekFrom) -> std::io::Result<u64> {
        self.file.seek(to)
    }
}

/// Fills a folder through `fill` so that `path` holds the whole of it, or what it held before. Between taking away an
/// old folder and putting the new one in its place there is a moment with neither.
///
/// # Errors
/// [`Error::Io`] with the path, or what `fill` returned; `path` is then as it was.
pub fn write_folder_whole<T>(
    path: &Path,
    fill: impl FnOnce(&Path) -> Result<T, Refused>,
) -> Result<T> {
    // The old content is nobody's to remove before the new one is there
    let (new, old) = (aside(path)?, hidden(path)?);
    let written = (|| {
        fs::create_dir(&*new)?;
        let result = fill(&new)?;
        if path.exists() {
            fs::rename(path, &old)?;
        }
        if let Err(error) = fs::rename(&*new, path) {
            let _ = fs::rename(&old, path);
            return Err(error.into());
        }
        if old.exists() {
            fs::remove_dir_all(&old)?;
        }
        Ok(result)
    })();
    written.map_err(|refused: Refused| {
        let _ = fs::remove_dir_all(&*new);
        refused.at(path)
    })
}

/// What this program has aside, or None after it gave up.
static ASIDE: Mutex<Option<BTreeSet<PathBuf>>> = Mutex::new(Some(BTreeSet::new()));

fn asides() -> MutexGuard<'static, Option<BTreeSet<PathBuf>>> {
    ASIDE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes whatever other threads are writing: each of those files holds what it held before. The program must end at once, and can
/// write nothing any more.
pub fn give_up() {
    for path in asides().take().into_iter().flatten() {
        // What cannot be removed does no harm
        let _ = fs::remove_file(&path).or_else(|_| fs::remove_dir_all(&path));
    }
}

/// A hidden name that nobody else uses, known to [`give_up`].
struct Aside(PathBuf);

impl Deref for Aside {
    type Target = Path;

    fn deref(&self) -> &Path {
        &self.0
    }
}

impl Drop for Aside {
    fn drop(&mut self) {
        if let Some(known) = asides().as_mut() {
            known.remove(&self.0);
        }
    }
}

/// A hidden name next to `path` to write to.
fn aside(path: &Path) -> Result<Aside> {
    let aside = hidden(path)?;
    let mut known = asides();
    known.as_mut().ok_or(Error::Canceled)?.insert(aside.clone());
    Ok(Aside(aside))
}

/// A hidden name next to `path` that no other writer uses.
fn hidden(path: &Path) -> Result<PathBuf> {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let none = || std::io::Error::new(ErrorKind::InvalidInput, "this path has no file name");
    let name = path.file_name().ok_or_else(|| Error::io(path, none()))?;
    // Of a long name the beginning: the hidden one must not be longer than a system takes
    let hidden = format!(
        ".{}.{}-{}.partial",
        file_name(&name.to_string_lossy(), '_'),
        std::process::id(),
        COUNT.fetch_add(1, Ordering::Relaxed)
    );
    Ok(path.with_file_name(hidden))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_writer_that_fails_leaves_the_old_file_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_whole(&path, |f| Ok(f.write_all(b"old")?)).unwrap();
        let failed = write_whole::<()>(&path, |f| {
            f.write_all(b"half of the n")?;
            Err(std::io::Error::other("disk full").into())
        });
        assert!(matches!(failed, Err(Error::Io { path: p, .. }) if p == path));
        assert_eq!(fs::read(&path).unwrap(), b"old");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn nothing_is_seen_before_the_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_whole(&path, |f| {
            f.write_all(&vec![7; 3 << 20])?; // more than the buffer: some of it is on the disk already
            assert!(!path.exists());
            Ok(())
        })
        .unwrap();
        assert_eq!(fs::metadata(&path).unwrap().len(), 3 << 20);
    }

    #[test]
    fn a_folder_is_replaced_as_a_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("frames");
        let fill = |names: &'static [&'static str]| {
            move |f: &Path| {
                for name in names {
                    fs::write(f.join(name), name)?;
                }
                Ok(())
            }
        };
        write_folder_whole(&path, fill(&["a", "b", "c"])).unwrap();
        write_folder_whole(&path, fill(&["d"])).unwrap();
        let failed = write_folder_whole::<()>(&path, |f| {
            fs::write(f.join("e"), "e")?;
            Err(std::io::Error::other("stop").into())
        });
        assert!(failed.is_err());
        let names: Vec<_> = fs::read_dir(&path)
            .unwrap()
            .map(|e| e.unwrap().file_name())
            .collect();
        assert_eq!(names, ["d"]);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn what_is_there_is_not_a_place_for_something_new() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        must_be_new("--output", &at("new")).unwrap();
        must_be_free("--output", &at("new")).unwrap();
        must_be_free("--output", folder.path()).unwrap();
        fs::write(at("mine"), "mine").unwrap();
        std::os::unix::fs::symlink("nowhere", at("link")).unwrap();
        for name in ["mine", "link"] {
            let text = must_be_new("--output", &at(name)).unwrap_err().to_string();
            assert!(text.contains("is there already"), "{text}");
            let text = must_be_free("--output", &at(name)).unwrap_err().to_string();
            assert!(text.contains("is no folder"), "{text}");
        }
        assert!(must_be_free("--output", folder.path()).is_err());
    }

    #[test]
    fn names_are_as_long_as_the_system_takes() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(format!("{}.txt", "ü".repeat(125)));
        must_be_new("--output", &path).unwrap();
        write_whole(&path, |f| Ok(f.write_all(b"content")?)).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"content");
        let text = must_be_new("--output", &folder.path().join("n".repeat(256)));
        assert!(matches!(text, Err(Error::Io { .. })));
    }

    #[test]
    fn a_missing_folder_is_named() {
        let path = Path::new("/nonexistent-folder/a.txt");
        let error = write_whole(path, |_| Ok(())).unwrap_err();
        assert!(
            (error.to_string()).starts_with("/nonexistent-folder/a.txt: it cannot be written: "),
            "{error}"
        );
    }
}
