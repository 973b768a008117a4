//! Bad input ends before any heavy work with one clear message, exit code 2, and earlier outputs as they were.

mod combinations;
mod folders;
mod slips;
mod targets;

use crate::bench::{Bench, contains, said};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A job that works, small.
const JOB: &str = concat!(
    include_str!("../gear.toml"),
    r#"[objective.threshold]
lower = 0.85
upper = 0.95

[stop]
iterations = 2

[output]
folder = "FOLDER"
"#
);

/// A folder with an earlier run beside the job.
impl Bench {
    fn beside_a_run() -> Self {
        let bench = Bench::with(&[]);
        let run = bench.run_folder();
        fs::create_dir_all(run.join("frames")).unwrap();
        let mark = "# A Tomolith run folder; this is its job with every default written out.\n";
        fs::write(run.join("job.toml"), mark).unwrap();
        fs::write(run.join("report.json"), "{\"earlier\": true}").unwrap();
        fs::write(run.join("frames/0000.png"), "earlier").unwrap();
        bench
    }

    fn run_folder(&self) -> PathBuf {
        self.path("run")
    }

    /// Every file under the run folder with its content.
    fn earlier(&self) -> Vec<(PathBuf, Vec<u8>)> {
        let mut files = Vec::new();
        let mut folders = vec![self.run_folder()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
                if entry.is_dir() {
                    folders.push(entry);
                } else {
                    files.push((entry.clone(), fs::read(&entry).unwrap()));
                }
            }
        }
        files.sort();
        files
    }

    fn tomolith(&self, job: &str, more: &[&str]) -> Output {
        let file = self.path("job.toml");
        fs::write(
            &file,
            job.replace("FOLDER", &self.run_folder().display().to_string()),
        )
        .unwrap();
        // The earlier run is of no job that could be compared
        tomolith(&file, &[more, &["--overwrite"]].concat())
    }

    /// The message of a job that must be refused with exit code 2 and all of `parts` in it.
    fn refused(&self, job: &str, more: &[&str], parts: &[&str]) -> String {
        let output = self.tomolith(job, more);
        contains(&said(2, job, &output), job, parts);
        String::from_utf8(output.stderr).unwrap()
    }

    /// The same, and earlier outputs are as they were.
    fn refused_before_work(&self, job: &str, parts: &[&str]) {
        let before = self.earlier();
        self.refused(job, &[], parts);
        assert_eq!(self.earlier(), before, "{parts:?} changed earlier outputs");
    }
}

fn tomolith(job: &Path, more: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tomolith"))
        .arg("run")
        .arg(job)
        .args(more)
        .output()
        .unwrap()
}

#[test]
fn every_slip_is_named_with_key_line_and_what_is_accepted() {
    let bench = Bench::beside_a_run();
    let before = bench.earlier();
    for (from, to, mark, parts) in slips::WRONG.iter().chain(combinations::WRONG) {
        assert!(JOB.contains(from), "{from:?} is not in the job");
        let job = JOB.replacen(from, to, 1);
        let line = 1 + job[..job.find(mark).unwrap()].matches('\n').count();
        let place = format!("job.toml:{line}:");
        bench.refused(&job, &[], &[*parts, &[place.as_str()]].concat());
        assert_eq!(bench.earlier(), before, "{to:?} changed earlier outputs");
    }
}
