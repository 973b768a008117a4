//! The command under `mpirun`. Needs `--features mpi`, an MPI library, and Linux to find a rank among the processes.
#![cfg(all(feature = "mpi", target_os = "linux"))]

use crate::bench::Bench;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tomolith::io::npy::read_patterns;

const JOB: &str = concat!(
    include_str!("gear.toml"),
    "[objective.threshold]\n[stop]\niterations = 6\n"
);

const SWEEP: &str = r#"
job = "job.toml"
metrics = ["history.loss", "evaluation.iou"]
[[axes]]
key = "objective.threshold.lower"
values = [0.6, 0.7, 0.8]
"#;

/// None where no launcher is installed: the test is then skipped.
fn bench() -> Option<Bench> {
    Command::new("mpirun").arg("--version").output().ok()?;
    Some(Bench::with(&[("job.toml", JOB), ("sweep.toml", SWEEP)]))
}

impl Bench {
    /// The command on so many ranks.
    fn on_ranks(&self, count: usize, line: &str) -> Command {
        let mut command = Command::new("mpirun");
        command
            .current_dir(self.temp.path())
            // Test machines are small, and often containers
            .args(["--allow-run-as-root", "--oversubscribe", "-n"])
            .args([&count.to_string(), env!("CARGO_BIN_EXE_tomolith")])
            .args(line.split_whitespace());
        command
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn raw(folder: &Path) -> Vec<f32> {
    let arrays = read_patterns(&folder.join("patterns.npz")).unwrap();
    arrays
        .into_iter()
        .flat_map(|array| array.raw.unwrap())
        .collect()
}

#[test]
fn two_ranks_leave_the_folder_that_a_process_leaves() {
    let Some(bench) = bench() else { return };
    // L-BFGS widens what other orders of sums begin, a plain gradient does not
    let keys = "--set optimizer.gradient={}";
    let alone = bench
        .command(&format!("run job.toml {keys} --quiet -o alone"))
        .output()
        .unwrap();
    let line = format!("run job.toml {keys} --json -o shared");
    let shared = bench.on_ranks(2, &line).output().unwrap();
    assert_eq!(
        alone.status.code(),
        shared.status.code(),
        "{}",
        text(&shared.stderr)
    );
    // One rank speaks
    let output = text(&shared.stdout);
    assert_eq!(output.matches("\"event\":\"done\"").count(), 1, "{output}");
    assert!(output.contains("2 ranks"), "{output}");
    let names = |folder: &str| {
        let entries = fs::read_dir(bench.path(folder)).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    assert_eq!(names("alone"), names("shared"));
    let [alone, shared] = ["alone", "shared"].map(|name| raw(&bench.path(name)));
    let top = alone.iter().copied().fold(0.0, f32::max);
    for (one, other) in alone.iter().zip(&shared) {
        assert!((one - other).abs() < 1e-5 * top, "{one} {other}");
    }
}

#[test]
fn fewer_angles_than_ranks_are_refused_once_and_before_work() {
    let Some(bench) = bench() else { return };
    let refused = bench
        .on_ranks(3, "run job.toml --set light.angles=2 -o out")
        .output()
        .unwrap();
    assert_eq!(refused.status.code(), Some(2));
    let message = text(&refused.stderr);
    assert_eq!(
        message.matches("2 angles for 3 ranks").count(),
        1,
        "{message}"
    );
    assert!(!bench.path("out").exists());
    let refused = bench
        .on_ranks(2, "sweep sweep.toml --shard 1/2")
        .output()
        .unwrap();
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("--shard"));
}

#[test]
fn ranks_take_shares_of_a_sweep_and_leave_its_table() {
    let Some(bench) = bench() else { return };
    let alone = bench
        .command("sweep sweep.toml --quiet -o alone")
        .output()
        .unwrap();
    let shared = bench
        .on_ranks(2, "sweep sweep.toml -o shared")
        .output()
        .unwrap();
    assert_eq!(
        alone.status.code(),
        shared.status.code(),
        "{}",
        text(&shared.stderr)
    );
    let output = text(&shared.stdout);
    assert_eq!(output.matches("3 of 3 runs done").count(), 1, "{output}");
    let table = |name: &str| bench.read(&format!("{name}/table.csv"));
    assert_eq!(table("alone"), table("shared"));
}

/// The process of a rank whose command line names this folder.
fn process_of(rank: usize, folder: &str) -> Option<String> {
    let entries = fs::read_dir("/proc").ok()?;
    let is_rank = |path: &Path| {
        let read = |name: &str| fs::read(path.join(name)).map(|bytes| text(&bytes));
        let (Ok(words), Ok(variables)) = (read("cmdline"), read("environ")) else {
            return false;
        };
        let variable = format!("OMPI_COMM_WORLD_RANK={rank}");
        words.contains(folder) && variables.split('\0').any(|v| v == variable)
    };
    let found = entries.flatten().find(|entry| is_rank(&entry.path()))?;
    Some(found.file_name().to_string_lossy().into_owned())
}

#[test]
fn a_rank_that_dies_ends_the_job_and_leaves_a_checkpoint_to_go_on_from() {
    let Some(bench) = bench() else { return };
    let folder = bench.path("killed").display().to_string();
    let line = "run job.toml --set stop.iterations=100000 --set stop.change=0 --set checkpoint.every_s=0.05 -o";
    let mut command = bench.on_ranks(2, &format!("{line} {folder}"));
    let mut job = command
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let checkpoint = bench.path("killed/checkpoint/state.safetensors");
    let begin = Instant::now();
    while !checkpoint.exists() && begin.elapsed() < Duration::from_secs(60) {
        sleep(Duration::from_millis(20));
    }
    let process = process_of(1, &folder).expect("rank 1 is at work");
    let killed = Command::new("kill")
        .args(["-9", &process])
        .status()
        .unwrap();
    assert!(killed.success());
    let ended = job.wait().unwrap();
    assert!(!ended.success());
    let mut message = String::new();
    std::io::Read::read_to_string(&mut job.stderr.take().unwrap(), &mut message).unwrap();
    assert!(message.contains("rank 1"), "{message}");
    let resumed = bench
        .command("run job.toml --resume -o killed")
        .output()
        .unwrap();
    let message = text(&resumed.stderr);
    assert_eq!(resumed.status.code(), Some(0), "{message}");
    assert!(message.contains("resuming after iteration"), "{message}");
}
