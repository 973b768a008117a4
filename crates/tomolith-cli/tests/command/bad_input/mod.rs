//! Bad input ends before any heavy work with one clear message, exit code 2, and earlier outputs as they were.

mod combinations;
mod folders;
mod slips;
mod targets;

use crate::bench::{Bench, contains, slipped, text_of};
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
        contains(&text_of(2, job, &output), job, parts);
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

/// The line of a job at which a slip is blamed: that of the key with which a message begins, or the first one that is not the job's where it names no key.
fn blamed(job: &str, message: &str) -> usize {
    let key = message.split([':', ' ']).next().unwrap();
    let names = key.split('.').filter_map(|name| name.split('[').next());
    let mut place = None;
    for name in names {
        let from = place.unwrap_or(0);
        let Some(further) = job[from..].find(name) else {
            break;
        };
        place = Some(from + further);
    }
    let same = || job.lines().zip(JOB.lines()).take_while(|(a, b)| a == b);
    let before = place.map_or_else(
        || same().count(),
        |place| job[..place].matches('\n').count(),
    );
    1 + before
}

#[test]
fn every_slip_is_named_with_key_line_and_what_is_accepted() {
    let bench = Bench::beside_a_run();
    let before = bench.earlier();
    let slips = [slips::WRONG, combinations::WRONG].into_iter();
    for slip in slips.flat_map(|all| all.split("\n\n")) {
        let (job, mut parts) = slipped(JOB, "[stop]\n", slip);
        let place = format!("job.toml:{}:", blamed(&job, parts[0]));
        parts.push(&place);
        bench.refused(&job, &[], &parts);
        assert_eq!(bench.earlier(), before, "{slip} changed earlier outputs");
    }
}
