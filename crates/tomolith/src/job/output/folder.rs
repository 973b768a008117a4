//! The run folder: ours alone, and changed only when everything new is there.
//!
//! New files are written to `.new/` inside the folder; [`RunFolder::publish`] moves them to their names at the end, so a
//! run that fails or is killed leaves earlier outputs as they were. A folder is known to be ours by its `job.toml`.
//!
//! A run that fails takes back what it laid there: its new files, its lock, and a folder that holds nothing else. What stays is a
//! checkpoint, which `--resume` goes on from, with the job that it belongs to.

use crate::error::{Error, Result};
use crate::io::read_text;
use crate::job::spec::file_names::{OUTPUTS, OUTPUTS_NAMED};
use crate::optimize::checkpoint::CHECKPOINT as STATE;
use crate::text::one_line;
use serde::Deserialize;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

/// What a run leaves in its folder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Leaves {
    /// Numbers: `job.toml`, `report.json`, `history.csv`.
    Metrics,
    /// And `patterns.npz`.
    Patterns,
    /// Everything.
    #[default]
    All,
}

impl Leaves {
    /// As `--keep` takes it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Leaves::Metrics => "metrics",
            Leaves::Patterns => "patterns",
            Leaves::All => "all",
        }
    }
}

/// Why a folder is refused in which another process works.
pub const TAKEN: &str = "another run is working in it";
/// First line of the `job.toml` of a run folder.
const MARK: &str = "# A Tomolith run folder; this is its job with every default written out.\n";
/// Published last: they say that the rest is complete.
const LAST: [&str; 2] = ["report.json", JOB];
/// What only an optimization leaves.
const RUN: [&str; 2] = ["history.csv", CHECKPOINT];
const CHECKPOINT: &str = "checkpoint";
const JOB: &str = "job.toml";
const NEW: &str = ".new";
const OLD: &str = ".old-";
const LOCK: &str = ".lock";
/// What names the folder.
const KEY: &str = "output.folder";

/// A folder that holds, or will hold, the outputs of one run. Locked while the value lives.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    /// Whether this run made the folder.
    is_made: bool,
    /// Whether this run marked it as one of ours, which its outputs or a checkpoint must bear out.
    is_marked: bool,
    _lock: fs::File,
}

/// What is wrong with a folder that outputs should go to, which a key names. A full disk stays one: there may be room later.
pub(crate) fn unusable(key: &str, path: &Path, what: &str, source: std::io::Error) -> Error {
    let found = format!("`{}` {what} ({source})", path.display());
    let error = Error::io(path, source);
    if error.is_full_disk() {
        return error;
    }
    let accepted = "a folder that can be made and written to";
    Error::config(key, found, accepted)
}

/// The lock of a folder, held by this process.
fn locked(path: &Path) -> Result<fs::File> {
    let file = path.join(LOCK);
    let not_lockable = |e| unusable(KEY, path, "holds a `.lock` that cannot be locked", e);
    loop {
        must_be_no_link(path)?;
        // Nothing is cut off, should a link come between
        let opened = fs::OpenOptions::new()
            .write(true)
            .create(true)
            .truncate(false)
            .open(&file);
        let lock = opened.map_err(|e| unusable(KEY, path, "cannot be written to", e))?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(fs::TryLockError::WouldBlock) => {
                return Err(Error::Unsupported {
                    what: format!("output.folder `{}`", path.display()),
                    reason: TAKEN.to_owned(),
                });
            }
            Err(fs::TryLockError::Error(e)) => return Err(not_lockable(e)),
        }
        let of_handle = lock.metadata().map_err(not_lockable)?;
        // One that ended meanwhile took its file with it: what is locked is no longer there
        if fs::symlink_metadata(&file).is_ok_and(|now| is_one_file(&now, &of_handle)) {
            return Ok(lock);
        }
    }
}

#[cfg(unix)]
fn is_one_file(a: &fs::Metadata, b: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

/// Where files have no numbers, the times at which they were made tell them apart.
#[cfg(not(unix))]
fn is_one_file(a: &fs::Metadata, b: &fs::Metadata) -> bool {
    a.created().ok() == b.created().ok()
}

/// Refuses a folder whose lock or checkpoint is a link: what is written there would end up elsewhere.
fn must_be_no_link(path: &Path) -> Result<()> {
    let is_link = |name: &&&str| path.join(name).is_symlink();
    match [LOCK, CHECKPOINT].iter().find(is_link) {
        None => Ok(()),
        Some(name) => Err(Error::config(
            KEY,
            format!("`{}` is a symbolic link", path.join(name).display()),
            "a folder that holds `.lock` and `checkpoint` itself; remove the link",
        )),
    }
}

impl RunFolder {
    /// Whether a run may write here: the folder is missing, empty, or a run folder.
    ///
    /// # Errors
    /// [`Error::Config`] for `output.folder` when it holds something else or is no folder.
    pub fn check(path: &Path) -> Result<()> {
        let refuse = |found: String| {
            Err(Error::config(
                KEY,
                found,
                "a new folder, an empty one, or one that a run of Tomolith made",
            ))
        };
        if !path.exists() {
            return Ok(());
        }
        if !path.is_dir() {
            return refuse(format!("`{}` is no folder", path.display()));
        }
        must_be_no_link(path)?;
        let ours = read_text(path.join(JOB)).is_ok_and(|text| text.starts_with(MARK));
        let mut entries =
            fs::read_dir(path).map_err(|e| unusable(KEY, path, "cannot be looked into", e))?;
        let is_foreign =
            |entry: fs::DirEntry| entry.file_name() != LOCK && entry.file_name() != NEW;
        if ours || !entries.any(|entry| entry.is_ok_and(is_foreign)) {
            return Ok(());
        }
        let what = match path.join(CHECKPOINT).is_dir() {
            true => {
                "holds a checkpoint, but no job.toml that a run wrote: it is missing or was changed"
            }
            false => "holds files that are not from a run",
        };
        refuse(format!("`{}` {what}", path.display()))
    }

    /// The job of the run that has ended here; None where none has.
    #[must_use]
    pub fn finished(path: &Path) -> Option<PathBuf> {
        let is_finished = LAST.iter().all(|name| path.join(name).is_file());
        is_finished.then(|| path.join(JOB))
    }

    /// Whether an optimization has left its outputs here: a simulation would mix with them.
    #[must_use]
    pub fn holds_a_run(path: &Path) -> bool {
        RUN.iter().any(|name| path.join(name).exists())
    }

    /// Takes the folder for this process; a new one is made and marked with the resolved job.
    ///
    /// # Errors
    /// As [`check`](Self::check); [`Error::Unsupported`] when another process is running in it; [`Error::Io`].
    pub fn open(path: &Path, resolved_job: &str) -> Result<Self> {
        Self::check(path)?;
        let is_made = !path.exists();
        fs::create_dir_all(path).map_err(|e| unusable(KEY, path, "cannot be made", e))?;
        let not_writable = |e| unusable(KEY, path, "cannot be written to", e);
        let lock = locked(path)?;
        let mut folder = RunFolder {
            path: path.to_owned(),
            is_made,
            is_marked: false,
            _lock: lock,
        };
        let new = folder.new_files();
        folder.remove_leftovers()?;
        fs::create_dir(&new).map_err(not_writable)?;
        folder.write_job(resolved_job)?;
        if !path.join(JOB).exists() {
            folder.is_marked = true;
            folder.move_in(JOB)?;
            folder.write_job(resolved_job)?;
        }
        Ok(folder)
    }

    /// The folder.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Where new files are written until they are published.
    #[must_use]
    pub fn new_files(&self) -> PathBuf {
        self.path.join(NEW)
    }

    /// Where checkpoints are.
    #[must_use]
    pub fn checkpoint(&self) -> PathBuf {
        Self::checkpoint_in(&self.path)
    }

    /// Whether a run folder holds a checkpoint, from which a run may go on.
    #[must_use]
    pub fn holds_a_checkpoint(path: &Path) -> bool {
        Self::checkpoint_in(path).join(STATE).is_file()
    }

    /// Where those of a run folder are.
    pub(crate) fn checkpoint_in(path: &Path) -> PathBuf {
        path.join(CHECKPOINT)
    }

    /// Moves all new files to their names, in the place of earlier ones. What an earlier run left and this one does not is removed: it would
    /// pass for this one's. The earlier report goes first, so that a folder that is left half-way is no finished run.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn publish(mut self) -> Result<()> {
        let new = self.new_files();
        let entries = fs::read_dir(&new).map_err(|e| Error::io(&new, e))?;
        let mut names: Vec<String> = entries
            .filter_map(|e| e.ok().map(|e| e.file_name().to_string_lossy().into_owned()))
            .collect();
        names.sort_by_key(|name| {
            (
                LAST.iter()
                    .position(|last| last == name)
                    .map_or(0, |i| i + 1),
                name.clone(),
            )
        });
        let outdated = self.outputs(&names)?;
        let report = self.path.join(LAST[0]);
        if report.exists() {
            fs::remove_file(&report).map_err(|e| Error::io(&report, e))?;
        }
        for old in outdated {
            let removed = match old.is_dir() {
                true => fs::remove_dir_all(&old),
                false => fs::remove_file(&old),
            };
            removed.map_err(|e| Error::io(&old, e))?;
        }
        // From here on there are outputs, which the mark belongs to
        self.is_marked = false;
        names.iter().try_for_each(|name| self.move_in(name))
    }

    /// Outputs of an earlier run that are not among these names.
    fn outputs(&self, names: &[String]) -> Result<Vec<PathBuf>> {
        let report = read_text(self.path.join(LAST[0])).unwrap_or_default();
        let report: Value = serde_json::from_str(&report).unwrap_or_default();
        let properties = report["properties"].as_array().into_iter().flatten();
        let properties: Vec<String> = properties
            .filter_map(|property| Some(format!("{}.npy", property["name"].as_str()?)))
            .collect();
        let is_named = |name: &str| {
            let mut all = OUTPUTS_NAMED.iter();
            all.any(|(begin, end)| name.starts_with(begin) && name.ends_with(end))
        };
        let entries = fs::read_dir(&self.path).map_err(|e| Error::io(&self.path, e))?;
        let outdated = entries.flatten().filter(|entry| {
            let name = entry.file_name().to_string_lossy().into_owned();
            let is_output = OUTPUTS.contains(&name.as_str()) || is_named(&name);
            (is_output || properties.contains(&name)) && !names.contains(&name)
        });
        Ok(outdated.map(|entry| entry.path()).collect())
    }

    /// What a killed run left behind.
    fn remove_leftovers(&self) -> Result<()> {
        for entry in fs::read_dir(&self.path)
            .map_err(|e| Error::io(&self.path, e))?
            .flatten()
        {
            let name = entry.file_name();
            if name == NEW || name.to_string_lossy().starts_with(OLD) {
                fs::remove_dir_all(entry.path()).map_err(|e| Error::io(entry.path(), e))?;
            }
        }
        Ok(())
    }

    fn write_job(&self, resolved_job: &str) -> Result<()> {
        let path = self.new_files().join(JOB);
        fs::write(&path, format!("{MARK}{resolved_job}")).map_err(|e| Error::io(&path, e))
    }

    /// Says in the job file to come, as comments, what a job does not name: by which models it was computed.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn describe(&self, resolved_job: &str, models: &[(&str, String)]) -> Result<()> {
        let lines: String = models
            .iter()
            .map(|(stage, model)| format!("# Model of the {stage}: {}\n", one_line(model)))
            .collect();
        self.write_job(&format!("{lines}{resolved_job}"))
    }

    /// Whether nothing is left that a later run could use: no outputs, no checkpoint.
    fn is_bare(&self) -> bool {
        let Ok(entries) = fs::read_dir(&self.path) else {
            return false;
        };
        let is_ours =
            |entry: fs::DirEntry| [JOB, LOCK].iter().any(|name| entry.file_name() == *name);
        entries.into_iter().all(|entry| entry.is_ok_and(is_ours))
    }

    /// Puts one new file or folder in the place of the old one.
    fn move_in(&self, name: &str) -> Result<()> {
        let (from, to) = (self.new_files().join(name), self.path.join(name));
        if to.is_dir() {
            let old = self.path.join(format!("{OLD}{name}"));
            fs::rename(&to, &old).map_err(|e| Error::io(&to, e))?;
            fs::rename(&from, &to).map_err(|e| Error::io(&to, e))?;
            return fs::remove_dir_all(&old).map_err(|e| Error::io(&old, e));
        }
        fs::rename(&from, &to).map_err(|e| Error::io(&to, e))
    }
}

/// Takes back what a run that failed laid in the folder. What cannot be removed is left: the error that ended the run is the one
/// to be reported, and the next run removes it.
impl Drop for RunFolder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(self.new_files());
        if self.is_marked && self.is_bare() {
            let _ = fs::remove_file(self.path.join(JOB));
        }
        let _ = fs::remove_file(self.path.join(LOCK));
        if self.is_made {
            // Refused by the system where anything is in it
            let _ = fs::remove_dir(&self.path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &Path) -> Vec<std::ffi::OsString> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_run_that_fails_leaves_nothing_but_its_checkpoint() {
        let temp = tempfile::tempdir().unwrap();
        let path = temp.path().join("run");
        let fails = |checkpoint: bool| {
            let folder = RunFolder::open(&path, "job").unwrap();
            fs::write(folder.new_files().join("dose.npy"), "half").unwrap();
            if checkpoint {
                fs::create_dir(folder.checkpoint()).unwrap();
            }
        };
        let names = || names_in(&path);
        fails(false);
        assert!(!path.exists());
        // Somebody's empty folder stays, empty
        fs::create_dir(&path).unwrap();
        fails(false);
        assert!(names().is_empty());
        fails(true);
        assert_eq!(names(), ["checkpoint", "job.toml"]);
        RunFolder::open(&path, "again").unwrap().publish().unwrap();
        fails(false);
        assert_eq!(names(), ["checkpoint", "job.toml"]);
    }

    #[test]
    fn a_lock_or_checkpoint_that_is_a_link_is_refused() {
        let temp = tempfile::tempdir().unwrap();
        let path = temp.path().join("run");
        let victim = temp.path().join("victim.txt");
        fs::write(&victim, "precious").unwrap();
        fs::create_dir(&path).unwrap();
        for (name, to) in [(LOCK, &victim), (CHECKPOINT, &temp.path().to_owned())] {
            let link = path.join(name);
            std::os::unix::fs::symlink(to, &link).unwrap();
            for error in [
                RunFolder::check(&path).unwrap_err(),
                RunFolder::open(&path, "job").unwrap_err(),
            ] {
                let text = error.to_string();
                tomolith_core::contains!(text, name, "symbolic link");
            }
            assert!(link.is_symlink());
            fs::remove_file(&link).unwrap();
        }
        assert_eq!(fs::read_to_string(&victim).unwrap(), "precious");
    }

    #[test]
    fn the_job_tells_the_models_and_is_still_a_job() {
        let temp = tempfile::tempdir().unwrap();
        let path = temp.path().join("run");
        let folder = RunFolder::open(&path, "a = 1\n").unwrap();
        folder
            .describe(
                "a = 1\n",
                &[("evaluation", "rays: light is not collimated".to_owned())],
            )
            .unwrap();
        folder.publish().unwrap();
        RunFolder::check(&path).unwrap();
        let text = fs::read_to_string(path.join(JOB)).unwrap();
        assert!(text.contains("# Model of the evaluation: rays: light is not collimated\na = 1\n"));
    }

    #[test]
    fn only_new_empty_and_own_folders_are_taken() {
        let temp = tempfile::tempdir().unwrap();
        RunFolder::check(&temp.path().join("new")).unwrap();
        RunFolder::check(temp.path()).unwrap();
        let file = temp.path().join("thesis.tex");
        fs::write(&file, "mine").unwrap();
        let message = RunFolder::open(temp.path(), "").unwrap_err().to_string();
        assert!(
            message.starts_with("output.folder: ") && message.contains("not from a run"),
            "{message}"
        );
        assert!(RunFolder::check(&file).is_err());
        let message = RunFolder::open(&file.join("run"), "").unwrap_err();
        let message = message.to_string();
        let parts = [
            "output.folder: `",
            "thesis.tex/run` cannot be made",
            "can be made and written to",
        ];
        assert!(parts.iter().all(|part| message.contains(part)), "{message}");
        fs::write(temp.path().join("job.toml"), "[target]\n").unwrap();
        assert!(
            RunFolder::check(temp.path()).is_err(),
            "any job.toml is taken for a run folder"
        );
    }

    #[test]
    fn outputs_change_only_when_published() {
        let temp = tempfile::tempdir().unwrap();
        let path = temp.path().join("a/run");
        let run = |job: &str, frames: &str| {
            let folder = RunFolder::open(&path, job).unwrap();
            fs::create_dir(folder.new_files().join("frames")).unwrap();
            fs::write(folder.new_files().join("frames/0.png"), frames).unwrap();
            fs::write(folder.new_files().join(format!("{job}.mp4")), frames).unwrap();
            folder
        };
        let read = |name: &str| fs::read_to_string(path.join(name)).ok();
        run("one", "1").publish().unwrap();
        assert_eq!(read("frames/0.png").as_deref(), Some("1"));
        let second = run("two", "2");
        tomolith_core::contains!(
            RunFolder::open(&path, "three").unwrap_err().to_string(),
            "another run"
        );
        drop(second); // killed
        assert_eq!(read("frames/0.png").as_deref(), Some("1"));
        assert!(read("job.toml").unwrap().ends_with("one"));
        run("two", "2").publish().unwrap();
        assert_eq!(read("frames/0.png").as_deref(), Some("2"));
        assert!(read("job.toml").unwrap().ends_with("two"));
        assert_eq!(
            (read("one.mp4"), read("two.mp4").as_deref()),
            (None, Some("2"))
        );
        // What the next run does not leave would pass for its own; somebody's notes stay
        for name in [
            "patterns.npz",
            "dose_b.npy",
            "strength.npy",
            "notes.txt",
            "mine.npy",
        ] {
            fs::write(path.join(name), "old").unwrap();
        }
        let report = r#"{"properties": [{"name": "strength"}]}"#;
        fs::write(path.join("report.json"), report).unwrap();
        RunFolder::open(&path, "three").unwrap().publish().unwrap();
        assert_eq!(names_in(&path), ["job.toml", "mine.npy", "notes.txt"]);
        assert!(!path.join(".new").exists() && !path.join(".lock").exists());
    }
}
