//! `tomolith sweep` as it is typed: killed and called again, as a list of commands, and what it says.

use crate::bench::{Bench, contains, text_of};
use serde_json::Value;
use std::io::{BufRead, BufReader};
use std::process::Stdio;

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

fn bench() -> Bench {
    Bench::with(&[("job.toml", JOB), ("sweep.toml", SWEEP)])
}

impl Bench {
    fn table(&self, folder: &str) -> String {
        self.read(&format!("{folder}/table.csv"))
    }
}

#[test]
fn a_killed_sweep_called_again_is_an_uninterrupted_one() {
    let bench = bench();
    bench.done("sweep sweep.toml --output whole --quiet");
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
    let first = &bench.events(0, "sweep sweep.toml --output killed --json")[0];
    assert!(first["finished"].as_u64().unwrap() >= 1, "{first}");
    assert_eq!(bench.table("killed"), bench.table("whole"));
}

#[test]
fn the_commands_of_the_list_make_the_runs_that_merging_collects() {
    let sweep = format!("{SWEEP}[set]\n\"stop.iterations\" = 9\n");
    let bench = Bench::with(&[("job.toml", JOB), ("sweep.toml", &sweep)]);
    bench.done("sweep sweep.toml --output whole --quiet");
    let list = bench.stdout(0, "sweep sweep.toml --output out --list");
    assert_eq!(list.lines().count(), 5);
    assert!(list.ends_with("--keep metrics --resume\n"), "{list}");
    for line in list.lines() {
        bench.done(&format!(
            "{} --quiet",
            line.strip_prefix("tomolith ").unwrap()
        ));
    }
    bench.done("sweep sweep.toml --output out --merge --quiet");
    assert_eq!(bench.table("out"), bench.table("whole"));
    // No run has been made in the third share of another folder
    bench.done("sweep sweep.toml --output share --shard 1/3 --quiet");
    let text = bench.stdout(1, "sweep sweep.toml --output share --merge");
    assert!(text.starts_with("1 of 5 runs done, 4 missing"), "{text}");
    bench.done("run share/best.toml --quiet --keep metrics");
    assert!(
        bench.path("share/best/report.json").is_file()
            && !bench.path("share/best/dose.npy").exists()
    );
    // Folders of results that are given for a job
    for (folder, what) in [("share", "sweep"), ("share/best", "run")] {
        let (line, view) = (format!("run {folder}"), format!("`tomolith view {folder}`"));
        bench.refuse(
            &line,
            &[&format!("`{folder}` is the folder of a {what}"), &view],
        );
    }
}

#[test]
fn slips_are_refused_with_their_place_and_nothing_is_written() {
    let bench = bench();
    bench.write("bad.toml", &SWEEP.replace("ospw.lower", "ospw.lwer"));
    let parts = ["axes[0].key", "bad.toml:5:", "did you mean `lower`?"];
    bench.refuse("sweep bad.toml", &parts);
    bench.ended(2, "sweep sweep.toml --shard 4/3");
    bench.ended(2, "sweep sweep.toml --shard 1/3 --merge");
    bench.ended(2, "sweep nowhere.toml");
    assert!(!bench.path("out").exists());
    // No run meets what is asked: exit code 1, and no best job
    bench.write(
        "hard.toml",
        &format!("{SWEEP}[best]\nwhere = [\"optimization.pw > 5\"]\n"),
    );
    bench.says(
        1,
        "sweep hard.toml --output out",
        &["no finished run has the number that ranks and meets best.where"],
    );
    assert!(bench.path("out/table.csv").is_file() && !bench.path("out/best.toml").exists());
    let parts = ["folder: `out` holds the sweep", "(from --output out)"];
    let message = bench.says(2, "sweep sweep.toml --output out", &parts);
    assert!(!message.contains("sweep.toml:1:"), "{message}");
}

#[cfg(not(feature = "mpi"))]
#[test]
fn processes_of_a_launcher_are_told_that_each_does_all_and_shares_by_hand_are_not() {
    let bench = Bench::with(&[("job.toml", JOB), ("sweep.toml", SWEEP)]);
    let message_of = |line: &str| {
        let mut command = bench.command(line);
        let output = command.env("OMPI_COMM_WORLD_SIZE", "2").output().unwrap();
        assert!(output.status.success(), "{line}");
        String::from_utf8(output.stderr).unwrap()
    };
    let warning = "one of 2 processes of a launcher";
    assert!(message_of("run job.toml --toy").contains(warning));
    let whole = message_of("sweep sweep.toml");
    // Runs are told by what ranks them
    contains(&whole, "", &[warning, "  evaluation.iou "]);
    assert!(!message_of("sweep sweep.toml --shard 1/2").contains(warning));
}

#[test]
fn processes_of_a_launcher_that_would_write_the_same_files_are_refused() {
    let bench = Bench::with(&[("job.toml", JOB)]);
    for line in [
        "simulate job.toml --patterns nowhere.npz",
        "voxelize part.stl --pitch-mm 0.1 -o part.npy",
        "phantom gear --size-mm 2 --pitch-mm 0.5 -o gear.npy",
        "import config.json -o new.toml",
        "expose run --trade-off",
        "compare a b",
    ] {
        let mut command = bench.command(line);
        let output = command.env("OMPI_COMM_WORLD_SIZE", "2").output().unwrap();
        let message = text_of(2, line, &output);
        contains(&message, line, &["one of 2 processes of a launcher"]);
    }
}

#[test]
fn instructions_that_no_machine_has_are_refused() {
    let bench = Bench::with(&[("job.toml", JOB)]);
    let mut command = bench.command("check job.toml");
    let output = command.env("TOMOLITH_ISA", "AVX2").output().unwrap();
    let message = text_of(2, "", &output);
    contains(&message, "", &["TOMOLITH_ISA: found \"AVX2\"", "scalar"]);
}

#[test]
fn a_map_outlines_nothing_where_nothing_is_asked_of_the_best() {
    let bench = bench();
    let sweep = "job = \"job.toml\"\nmetrics = [\"evaluation.iou\"]\n\
                 [[axes]]\nkey = \"objective.ospw.lower\"\nvalues = [0.3, 0.5]\n\
                 [[axes]]\nkey = \"stop.iterations\"\nvalues = [1, 2]\n";
    let picture = |sweep: &str| {
        bench.write("map.toml", sweep.as_bytes());
        // Half of the runs are missing
        bench.done("sweep map.toml --output map --quiet --shard 1/2");
        bench.ended(1, "sweep map.toml --output map --quiet --merge");
        bench.read("map/evaluation.iou.svg")
    };
    let svg = picture(sweep);
    assert!(!svg.contains("outlined"), "{svg}");
    let asked = format!(
        "{sweep}[best]\nhighest = \"evaluation.iou\"\nwhere = [\"evaluation.iou > 0.1\"]\n"
    );
    assert!(picture(&asked).contains("outlined: feasible"));
}
