//! A folder with a small job, in which commands are typed.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A gear that takes a moment.
pub(crate) const JOB: &str = r#"[target]
phantom = "gear"
size_mm = 2.0
[grid]
pitch_mm = 0.1
[resin]
refractive_index = 1.5
absorption_per_mm = 0.05
[vial.index_matched]
radius_mm = 3.0
[[light]]
pixels = [32, 16]
angles = 24
projector.collimated = { pixel_pitch_mm = 0.1 }
[stop]
iterations = 4
"#;

pub(crate) struct Bench {
    pub(crate) temp: tempfile::TempDir,
}

impl Bench {
    /// A folder with the job.
    pub(crate) fn new() -> Self {
        let bench = Bench {
            temp: tempfile::tempdir().unwrap(),
        };
        bench.write("job.toml", JOB);
        bench
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.temp.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, content: &(impl AsRef<[u8]> + ?Sized)) {
        fs::write(self.path(name), content).unwrap();
    }

    /// A line, typed in the folder with these programs alone on its path; `~` stands for a blank in a word.
    pub(crate) fn output(&self, line: &str, programs: &Path) -> Output {
        Command::new(env!("CARGO_BIN_EXE_tomolith"))
            .current_dir(self.temp.path())
            .env("PATH", programs)
            .args(line.split(' ').map(|word| word.replace('~', " ")))
            .output()
            .unwrap()
    }

    /// What a line said that must end with a code, on a machine without other programs.
    pub(crate) fn expect(&self, code: i32, line: &str) -> String {
        said(code, line, &self.output(line, &self.path("nothing")))
    }

    /// The last line of a command with `--json`.
    pub(crate) fn json(&self, line: &str) -> Value {
        let said = self.expect(0, &format!("{line} --json"));
        let value: Value = serde_json::from_str(said.trim().lines().last().unwrap()).unwrap();
        assert_eq!(value["event"], "done", "{line}");
        value
    }
}

/// All that a line said, which must have ended with a code; without line breaks and frames, unless it is JSON.
pub(crate) fn said(code: i32, line: &str, output: &Output) -> String {
    let said = String::from_utf8_lossy(&output.stdout).into_owned()
        + &String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{line}: {said}");
    if said.starts_with('{') {
        return said;
    }
    let words = said.split_whitespace().filter(|word| *word != "│");
    words.collect::<Vec<_>>().join(" ")
}
