//! `tomolith import`: a job or a sinogram of another program as ours.

use crate::arguments::{Manner, must_end_in};
use crate::screen::{self, say};
use clap::Args;
use serde_json::json;
use std::path::{Component, Path, PathBuf};
use tomolith::io::mesh::read_mesh;
use tomolith::io::npy::{PatternPair, write_patterns};
use tomolith::io::{must_be_new, read_text, write_text};
use tomolith::models::Work;
use tomolith::{Error, Result, job};

const EXAMPLES: &str = "\
Examples:
  tomolith import config.json --output job.toml
  tomolith run job.toml
  tomolith import sinogram.npy --output patterns.npz
  tomolith simulate job.toml --patterns patterns.npz
Files that the job names are looked for from the current folder, from the job's and from those above; the new job names them
relative to itself.";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct ImportArguments {
    /// Job of Dr.TVAM, JSON; or a sinogram of VAMToolbox, [u, angle, z] in a .npy file
    theirs: PathBuf,
    /// File to write: the job, TOML; of a sinogram the patterns, .npz
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

pub(crate) fn import(given: &ImportArguments) -> Result<()> {
    must_be_new("--output", &given.output)?;
    let is_array = |ending: &std::ffi::OsStr| ending.eq_ignore_ascii_case("npy");
    if given.theirs.extension().is_some_and(is_array) {
        must_end_in("--output", &given.output, &["npz"])?;
        let patterns = job::sinogram(&given.theirs)?;
        let pair = PatternPair {
            light: None,
            shown: &patterns,
            raw: None,
        };
        write_patterns(&given.output, &[pair], &Work::new())?;
        let note = "angles are those of the job that the patterns are simulated with; sinograms of a graphics card belong to a part turned by 90°";
        return done(given, "patterns", &[note.to_owned()]);
    }
    let text = read_text(&given.theirs)?;
    let named = |error| match error {
        Error::Unsupported { what, reason } => {
            Error::unsupported(format!("{}: {what}", given.theirs.display()), reason)
        }
        other => other,
    };
    let folder = |file: &Path| {
        let parent = file
            .parent()
            .filter(|parent| !parent.as_os_str().is_empty());
        let parent = parent.unwrap_or(Path::new("."));
        std::fs::canonicalize(parent).map_err(|source| Error::io(parent, source))
    };
    let [from, to] = [folder(&given.theirs)?, folder(&given.output)?];
    let path = |file: &str| placed(file, &from, &to);
    let bounds = |file: &str| bounds_of(&to.join(path(file)));
    let files = job::ImportFiles {
        path: &path,
        bounds: &bounds,
    };
    let ours = job::import(&text, &files).map_err(named)?;
    write_text(&given.output, &ours.text)?;
    done(given, "job", &ours.notes)
}

/// Says what was written, and what people should know of it.
fn done(given: &ImportArguments, what: &str, notes: &[String]) -> Result<()> {
    let found = json!({ "file": given.output, "notes": notes });
    screen::done(given.manner, found, || {
        for note in notes {
            say(&format!("note: {note}"));
        }
        say(&format!("{what} in {}", given.output.display()));
    });
    Ok(())
}

/// The path of a file of a job in the folder `from` as a job in the folder `to` names it; unchanged where there is no such file.
fn placed(file: &str, from: &Path, to: &Path) -> String {
    let here = std::env::current_dir();
    let folders = here.iter().map(PathBuf::as_path).chain(from.ancestors());
    let found = folders
        .map(|folder| folder.join(file))
        .filter(|_| Path::new(file).is_relative())
        .find_map(|path| std::fs::canonicalize(path).ok());
    match found.and_then(|path| relative(&path, to)) {
        Some(path) => path.display().to_string(),
        None => file.to_owned(),
    }
}

/// The box of a mesh; None where there is none to read.
fn bounds_of(file: &Path) -> Option<[[f64; 3]; 2]> {
    let mesh = read_mesh(file).ok()?.mesh;
    let corner = |pick: fn(f64, f64) -> f64, from: f64| {
        let least = |i: usize| mesh.vertices.iter().map(|v| v[i]).fold(from, pick);
        std::array::from_fn(least)
    };
    let bounds = [
        corner(f64::min, f64::INFINITY),
        corner(f64::max, f64::NEG_INFINITY),
    ];
    (!mesh.triangles.is_empty()).then_some(bounds)
}

/// A path seen from a folder; None where the two have nothing in common.
fn relative(path: &Path, folder: &Path) -> Option<PathBuf> {
    let shared = path
        .components()
        .zip(folder.components())
        .take_while(|(a, b)| a == b)
        .count();
    let up = folder
        .components()
        .skip(shared)
        .map(|_| Component::ParentDir);
    let down = path.components().skip(shared);
    (shared > 0).then(|| up.chain(down).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_relative_to_the_new_job() {
        let folder = tempfile::tempdir().unwrap();
        let root = std::fs::canonicalize(folder.path()).unwrap();
        let jobs = root.join("tests/files");
        std::fs::create_dir_all(&jobs).unwrap();
        std::fs::write(jobs.join("part.ply"), "").unwrap();
        // Beside their job, or as seen from a folder above
        for file in ["part.ply", "tests/files/part.ply"] {
            assert_eq!(placed(file, &jobs, &jobs), "part.ply");
            let path = Path::new("tests").join("files").join("part.ply");
            assert_eq!(Path::new(&placed(file, &jobs, &root)), path);
        }
        let elsewhere = Path::new("..").join("files").join("part.ply");
        assert_eq!(
            Path::new(&placed("part.ply", &jobs, &root.join("tests/new"))),
            elsewhere
        );
        assert_eq!(placed("none.ply", &jobs, &root), "none.ply");
    }
}
