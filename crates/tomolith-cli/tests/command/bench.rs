//! A folder in which commands are typed.

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
    /// A folder with the gear's job.
    pub(crate) fn new() -> Self {
        Self::with(&[("job.toml", JOB)])
    }

    /// A folder with these files.
    pub(crate) fn with(files: &[(&str, &str)]) -> Self {
        let bench = Bench {
            temp: tempfile::tempdir().unwrap(),
        };
        for (name, text) in files {
            bench.write(name, text);
        }
        bench
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.temp.path().join(name)
    }

    /// Writes a file, in folders that it makes.
    pub(crate) fn write(&self, name: &str, content: &(impl AsRef<[u8]> + ?Sized)) {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    pub(crate) fn report(&self, folder: &str) -> Value {
        serde_json::from_str(&self.read(&format!("{folder}/report.json"))).unwrap()
    }

    /// A line, typed in the folder; `~` stands for a blank in a word.
    pub(crate) fn command(&self, line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tomolith"));
        let words = line.split_whitespace().map(|word| word.replace('~', " "));
        command.current_dir(self.temp.path()).args(words);
        command
    }

    /// A line that must end with this code.
    pub(crate) fn ended(&self, code: i32, line: &str) -> Output {
        let output = self.command(line).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{line}: {message}");
        output
    }

    /// The standard output of a line that must end with this code.
    pub(crate) fn stdout(&self, code: i32, line: &str) -> String {
        String::from_utf8(self.ended(code, line).stdout).unwrap()
    }

    /// A line typed with these programs alone on the path.
    pub(crate) fn output(&self, line: &str, programs: &Path) -> Output {
        self.command(line).env("PATH", programs).output().unwrap()
    }

    /// What a line said that must end with a code, on a machine without other programs.
    pub(crate) fn expect(&self, code: i32, line: &str) -> String {
        text_of(code, line, &self.output(line, &self.path("nothing")))
    }

    /// A line that must do its work.
    pub(crate) fn done(&self, line: &str) {
        self.expect(0, line);
    }

    /// What a line said that must end with a code, with all these parts in it.
    pub(crate) fn says(&self, code: i32, line: &str, parts: &[&str]) -> String {
        let text = self.expect(code, line);
        contains(&text, line, parts);
        text
    }

    /// A refusal: one message with all these parts.
    pub(crate) fn refuse(&self, line: &str, parts: &[&str]) {
        let text = self.says(2, line, parts);
        let is_one = text.contains("error: ") && text.matches("accepted:").count() <= 1;
        assert!(is_one, "{line}: {text}");
    }

    /// Refusals: lines behind `$`, and what is said of each behind it, with … where words are left out.
    pub(crate) fn refuse_each(&self, transcript: &str) {
        for refusal in transcript.split("$ ").skip(1) {
            let (line, expected) = refusal.split_once('\n').unwrap();
            let parts: Vec<&str> = expected.split('…').map(str::trim).collect();
            self.refuse(line, &parts);
        }
    }

    /// The lines of JSON of a line that must end with this code.
    pub(crate) fn events(&self, code: i32, line: &str) -> Vec<Value> {
        let text = self.stdout(code, line);
        text.lines()
            .map(|line| serde_json::from_str(line).unwrap())
            .collect()
    }

    /// The last line of a command with `--json`.
    pub(crate) fn json(&self, line: &str) -> Value {
        let text = self.expect(0, &format!("{line} --json"));
        let value: Value = serde_json::from_str(text.trim().lines().last().unwrap()).unwrap();
        assert_eq!(value["event"], "done", "{line}");
        value
    }
}

/// All that a line said, which must have ended with a code; without line breaks and frames, unless it is JSON.
pub(crate) fn text_of(code: i32, line: &str, output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stdout).into_owned()
        + &String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{line}: {text}");
    if text.starts_with('{') {
        return text;
    }
    let words = text.split_whitespace().filter(|word| *word != "│");
    words.collect::<Vec<_>>().join(" ")
}

/// All these parts are in what a line said.
pub(crate) fn contains(text: &str, line: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "{line}: `{part}` is not in: {text}");
    }
}

/// A text with a slip, and the parts of what is said of it.
///
/// A slip is lines that are taken out of the text (`- `) and put in (`+ `), behind lines that stay (`  `) or else before a line, and what is said, with …
/// where words are left out. Lines that begin with `# ` are remarks.
pub(crate) fn slipped<'s>(text: &str, line: &str, slip: &'s str) -> (String, Vec<&'s str>) {
    let starts = |line: &str, marks: &[&str]| marks.iter().any(|mark| line.starts_with(mark));
    let [mut before, mut after] = ["- ", "+ "].map(|mark| {
        let lines = slip.lines().filter(|line| starts(line, &[mark, "  "]));
        lines
            .map(|line| format!("{}\n", &line[2..]))
            .collect::<String>()
    });
    if before.is_empty() {
        before += line;
        after += line;
    }
    assert!(text.contains(&before), "{before:?} is not in the text");
    let expected = slip
        .lines()
        .filter(|line| !starts(line, &["- ", "+ ", "  ", "# "]));
    let parts = expected.flat_map(|line| line.split('…')).map(str::trim);
    let parts = parts.filter(|part| !part.is_empty());
    (text.replacen(&before, &after, 1), parts.collect())
}

pub(crate) fn npy(descr: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let text = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({shape}), }}");
    let text = format!("{text:<117}\n");
    [b"\x93NUMPY\x01\x00\x76\x00", text.as_bytes(), data].concat()
}

/// An `.npy` file of f64.
pub(crate) fn doubles(shape: &str, values: &[f64]) -> Vec<u8> {
    let bytes = values.iter().flat_map(|v| v.to_le_bytes());
    npy("<f8", shape, &bytes.collect::<Vec<u8>>())
}
