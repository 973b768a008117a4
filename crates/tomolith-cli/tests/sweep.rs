//! `tomolith sweep` as it is typed: killed and called again, as a list of commands, and what it says.

use serde_json::Value;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// Runs of some tenths of a second whose checkpoints are always new.
const JOB: &str = r#"
target = { phantom = "gear", size_mm = 3.0 }
grid = { pitch_mm = 0.1 }
resin = { refractive_index = 1.5, absorption_per_mm = 0.05 }
vial = { index_matched = { radius_mm = 4.0 } }
light = [{ pixels = [40, 16], angles = 36, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
objective = { ospw = { lower = 0.5, upper = 0.9 } }
stop = { iterations = 12 }
evaluate = { refine = 1, sub_angles = 1 }
checkpoint = { every_s = 0.001 }
"#;

const SWEEP: &str = r#"
job = "job.toml"
metrics = ["optimization.pw", "evaluation.pw", "history.loss"]
[[axes]]
key = "objective.ospw.lower"
linear = { from = 0.3, to = 0.7, step = 0.1 }
"#;

struct Bench(tempfile::TempDir);

impl Bench {
    fn new() -> Self {
        let bench = Bench(tempfile::tempdir().unwrap());
        fs::write(bench.path("job.toml"), JOB).unwrap();
        fs::write(bench.path("sweep.toml"), SWEEP).unwrap();
        bench
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, line: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tomolith"));
        command
            .current_dir(self.0.path())
            .args(line.split_whitespace());
        command
    }

    fn expect(&self, code: i32, line: &str) -> Output {
        let output = self.command(line).output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{line}: {message}");
        output
    }

    fn table(&self, folder: &str) -> String {
        fs::read_to_string(self.path(folder).join("table.csv")).unwrap()
    }
}

#[test]
fn a_killed_sweep_called_again_is_an_uninterrupted_one() {
    let bench = Bench::new();
    bench.expect(0, "sweep sweep.toml --output whole --quiet");
    let mut child = bench
        .command("sweep sweep.toml --output killed --json --threads 2")
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let mut events = lines.map(|line| serde_json::from_str::<Value>(&line.unwrap()).unwrap());
    assert_eq!(events.next().unwrap()["event"], "sweep");
    assert_eq!(events.next().unwrap()["event"], "run");
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!bench.path("killed/table.csv").exists());
    let output = bench.expect(0, "sweep sweep.toml --output killed --json");
    let text = String::from_utf8(output.stdout).unwrap();
    let first: Value = serde_json::from_str(text.lines().next().unwrap()).unwrap();
    assert!(first["finished"].as_u64().unwrap() >= 1, "{first}");
    assert_eq!(bench.table("killed"), bench.table("whole"));
}

#[test]
fn the_commands_of_the_list_make_the_runs_that_merging_collects() {
    let bench = Bench::new();
    bench.expect(0, "sweep sweep.toml --output whole --quiet");
    let list = String::from_utf8(
        bench
            .expect(0, "sweep sweep.toml --output out --list")
            .stdout,
    )
    .unwrap();
    assert_eq!(list.lines().count(), 5);
    for line in list.lines() {
        bench.expect(
            0,
            &format!("{} --quiet", line.strip_prefix("tomolith ").unwrap()),
        );
    }
    bench.expect(0, "sweep sweep.toml --output out --merge --quiet");
    assert_eq!(bench.table("out"), bench.table("whole"));
    // No run has been made in the third share of another folder
    bench.expect(0, "sweep sweep.toml --output share --shard 1/3 --quiet");
    let output = bench.expect(0, "sweep sweep.toml --output share --merge");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("1 of 5 runs done, 4 missing"), "{text}");
    bench.expect(0, "run share/best.toml --quiet --keep metrics");
    assert!(
        bench.path("share/best/report.json").is_file()
            && !bench.path("share/best/dose.npy").exists()
    );
}

#[test]
fn slips_are_refused_with_their_place_and_nothing_is_written() {
    let bench = Bench::new();
    fs::write(
        bench.path("bad.toml"),
        SWEEP.replace("ospw.lower", "ospw.lwer"),
    )
    .unwrap();
    let message = String::from_utf8(bench.expect(2, "sweep bad.toml").stderr).unwrap();
    for part in ["axes[0].key", "bad.toml, line 5", "did you mean `lower`?"] {
        assert!(message.contains(part), "{part} is not in: {message}");
    }
    bench.expect(2, "sweep sweep.toml --shard 4/3");
    bench.expect(2, "sweep sweep.toml --shard 1/3 --merge");
    bench.expect(2, "sweep nowhere.toml");
    assert!(!bench.path("out").exists());
    // No run meets what is asked: exit code 1, and no best job
    fs::write(
        bench.path("hard.toml"),
        format!("{SWEEP}[best]\nwhere = [\"optimization.pw > 5\"]\n"),
    )
    .unwrap();
    let text = String::from_utf8(bench.expect(1, "sweep hard.toml --output out").stdout).unwrap();
    assert!(text.contains("no run meets best.where"), "{text}");
    assert!(bench.path("out/table.csv").is_file() && !bench.path("out/best.toml").exists());
}
