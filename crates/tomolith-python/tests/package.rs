//! Runs the tests of the package, `test_*.py`, in Python on the library that was just built.
#![expect(clippy::print_stderr, reason = "says that it was skipped")]

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};
use tomolith::job::{Job, Silent};
use tomolith::work::Work;

/// The Python to run, which needs numpy: `TOMOLITH_PYTHON`, which must work, or `python3` where that has it.
fn python() -> Option<PathBuf> {
    if let Some(named) = env::var_os("TOMOLITH_PYTHON") {
        return Some(named.into());
    }
    let python = PathBuf::from("python3");
    let found = Command::new(&python).args(["-c", "import numpy"]).output();
    found
        .is_ok_and(|found| found.status.success())
        .then_some(python)
}

#[test]
fn python_gets_what_the_library_gives() {
    let Some(python) = python() else {
        return eprintln!(
            "skipped: python3 has no numpy (name one that has it in TOMOLITH_PYTHON)"
        );
    };
    let (crate_folder, folder) = (
        Path::new(env!("CARGO_MANIFEST_DIR")),
        tempfile::tempdir().unwrap(),
    );
    let package = folder.path().join("tomolith");
    fs::create_dir(&package).unwrap();
    for file in files(&crate_folder.join("python/tomolith")) {
        fs::copy(&file, package.join(file.file_name().unwrap())).unwrap();
    }
    let library = format!("{DLL_PREFIX}tomolith_native{DLL_SUFFIX}");
    let library = env::current_exe().unwrap().with_file_name(library);
    fs::copy(library, package.join("_native.abi3.so")).unwrap();
    // The job of the tests, run by the library, for Python to compare its own run with
    let run = folder.path().join("library");
    let job = Job::read(&crate_folder.join("tests/gear.json"), &[]).unwrap();
    let job = job.with_folder(&run, "folder");
    tomolith::job::run(&job, false, &mut Silent, &Work::new()).unwrap();
    let tests = Command::new(python)
        .args(["-m", "unittest", "discover", "--verbose"])
        .arg(crate_folder.join("tests"))
        .env("PYTHONPATH", folder.path())
        .env("TOMOLITH_LIBRARY_RUN", &run)
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&tests.stderr);
    assert!(tests.status.success(), "{message}");
    let tests = files(&crate_folder.join("tests")).into_iter();
    let tests = tests.filter(|file| file.extension().is_some_and(|ending| ending == "py"));
    let count = |file: PathBuf| {
        fs::read_to_string(file)
            .unwrap()
            .matches("def test_")
            .count()
    };
    let ran = format!("Ran {} tests", tests.map(count).sum::<usize>());
    assert!(message.contains(&ran), "{ran}: {message}");
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    let files = entries.map(|entry| entry.unwrap().path());
    files.filter(|path| path.is_file()).collect()
}
