//! Folders, overrides, resuming and disks.

use super::*;
use crate::bench::{contains, doubles};

#[test]
fn a_folder_that_is_not_ours_is_left_alone() {
    let bench = Bench::beside_a_run();
    let foreign = bench.path("thesis");
    fs::create_dir(&foreign).unwrap();
    fs::write(foreign.join("chapter.tex"), "mine").unwrap();
    let parts = ["output.folder", "not from a run", "(from --output /"];
    let folder = foreign.display().to_string();
    let message = bench.refused(JOB, &["--output", &folder], &parts);
    assert!(!message.contains("line"), "blamed on the file: {message}");
    assert_eq!(fs::read_dir(&foreign).unwrap().count(), 1);
    fs::create_dir(foreign.join("checkpoint")).unwrap();
    let parts = ["holds a checkpoint, but no job.toml that a run wrote"];
    bench.refused(JOB, &["--output", &folder], &parts);
}

#[test]
fn an_error_after_the_folder_was_taken_leaves_it_as_it_was() {
    let bench = Bench::beside_a_run();
    let before = bench.earlier();
    // One voxel of 2.5 mm is in the grid's middle, and less than half of it in the gear: known only when it is voxelized
    let late = ["--set", "grid.pitch_mm=2.5"];
    let new = bench.path("new").display().to_string();
    for more in [&late[..], &[&late[..], &["--output", &new]].concat()] {
        let blamed = "(from --set grid.pitch_mm=2.5)";
        let parts = ["grid.pitch_mm: no voxel of the grid is half filled", blamed];
        bench.refused(JOB, more, &parts);
    }
    assert_eq!(bench.earlier(), before);
    assert!(!bench.run_folder().join(".new").exists());
    assert!(!bench.path("new").exists());
}

#[test]
fn a_finished_run_of_another_job_is_replaced_only_when_asked() {
    let bench = Bench::beside_a_run();
    let before = bench.earlier();
    let file = bench.path("job.toml");
    fs::write(
        &file,
        JOB.replace("FOLDER", &bench.run_folder().display().to_string()),
    )
    .unwrap();
    let message = text_of(2, "", &tomolith(&file, &[]));
    let finished = "holds a finished run of another job";
    let parts = ["output.folder", finished, "cannot be read", "--overwrite"];
    contains(&message, "", &parts);
    assert_eq!(bench.earlier(), before);
    let overwrite = ["--quiet", "--overwrite"];
    assert!(tomolith(&file, &overwrite).status.success());
    // The same job again, however it is written
    let same = ["--quiet", "--set", "grid.pitch_mm=\"100 um\""];
    assert!(tomolith(&file, &same).status.success());
}

#[test]
fn too_little_memory_is_said_with_the_estimate() {
    let bench = Bench::beside_a_run();
    let job = JOB.replace(
        "pitch_mm = 0.1\n",
        "pitch_mm = 0.1\nshape = [9000, 9000, 9000]\n",
    );
    bench.refused_before_work(&job, &["grid.shape: memory", "MB needed"]);
}

#[test]
fn an_override_names_itself_and_json_errors_are_one_line() {
    let bench = Bench::beside_a_run();
    let output = bench.tomolith(JOB, &["--set", "light.angles=0", "--json"]);
    assert_eq!(output.status.code(), Some(2));
    let line: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&line["event"], &line["key"]),
        (&"error".into(), &"light[0].angles".into())
    );
    contains(
        line["found"].as_str().unwrap(),
        "",
        &["--set light.angles=0"],
    );
    let output = Command::new(env!("CARGO_BIN_EXE_tomolith"))
        .args(["simulate", "--json"])
        .output()
        .unwrap();
    let line: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let message = line["message"].as_str().unwrap();
    assert!(message.contains("--patterns <FILE>"), "{message}");
    let output = tomolith(&bench.path("nothing.toml"), &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("nothing.toml"));
}

#[test]
fn what_an_option_set_is_not_blamed_on_the_file() {
    let bench = Bench::beside_a_run();
    for (option, key) in [
        ("light.pixels=[0,0]", "light[0].pixels[0]"),
        ("light.angles={list_deg=[]}", "light[0].angles.list_deg"),
        ("light.pixels=[12, 24]", "light[0].pixels"),
        ("target.size_mm=9", "target"),
        (
            "resin.phase.henyey_greenstein.g=2",
            "resin.phase.henyey_greenstein.g",
        ),
    ] {
        let [error, from] = [format!("error: {key}: "), format!("(from --set {option})")];
        let message = bench.refused(JOB, &["--set", option], &[&error, &from]);
        assert!(!message.contains("job.toml"), "{option}: {message}");
    }
}

#[test]
fn resuming_notices_that_a_file_of_the_job_has_other_content() {
    let bench = Bench::beside_a_run();
    let job = JOB.replace("[stop]", "[response.table]\nfile = \"curve.csv\"\n[stop]");
    bench.write("curve.csv", "0 0\n0.5 0.4\n1 1\n");
    assert!(bench.tomolith(&job, &["--quiet"]).status.success());
    let resume = ["--resume", "--quiet"];
    assert!(bench.tomolith(&job, &resume).status.success());
    bench.write("curve.csv", "0 0\n0.5 0.6\n1 1\n");
    let changed = "the content of a file that the job names, have changed";
    bench.refused(&job, &resume, &[changed]);
}

#[test]
fn resuming_says_what_to_do_and_what_has_changed() {
    let bench = Bench::beside_a_run();
    assert!(bench.tomolith(JOB, &["--quiet"]).status.success());
    let refused = |more: &[&str], parts: &[&str]| {
        let advice = "error: --resume: leave it out to begin anew";
        let more = [&["--resume"], more].concat();
        bench.refused(JOB, &more, &[&[advice], parts].concat());
    };
    refused(
        &[
            "--set",
            "resin.absorption_per_mm=0.06",
            "--set",
            "light.rotation=counterclockwise",
        ],
        &[
            "resin.absorption_per_mm was 0.05, is 0.06",
            "light[0].rotation was \"clockwise\", is \"counterclockwise\"",
        ],
    );
    refused(
        &["--set", "target.size_mm=1.9"],
        &["target.size_mm was 2, is 1.9"],
    );
    refused(&["--set", "stop.iou=0.9"], &["stop.iou was"]);
    let file = bench.run_folder().join("checkpoint/state.safetensors");
    let whole = fs::read(&file).unwrap();
    let mut scribbled = whole.clone();
    scribbled[20..40].fill(b'x');
    for broken in [&whole[..100], &whole[..whole.len() - 1], &scribbled, &[]] {
        fs::write(&file, broken).unwrap();
        refused(&[], &["damaged checkpoint"]);
    }
    // What resuming does not depend on may change
    fs::write(&file, &whole).unwrap();
    let more = ["--resume", "--quiet", "--set", "stop.iterations=3"];
    let more = [&more[..], &["--set", "objective.threshold.part_weight=1"]].concat();
    text_of(0, "", &bench.tomolith(JOB, &more));
    let fewer = bench.tomolith(JOB, &["--resume", "--set", "stop.iterations=1"]);
    let fewer = String::from_utf8_lossy(&fewer.stdout);
    let why = "3 (the checkpoint had 2 more than `stop.iterations`";
    assert!(fewer.contains(why), "{fewer}");
}

#[test]
fn a_simulation_never_mixes_with_a_run() {
    let bench = Bench::beside_a_run();
    assert!(bench.tomolith(JOB, &["--quiet"]).status.success());
    let before = bench.earlier();
    let run = bench.run_folder();
    let simulate = |more: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_tomolith"))
            .arg("simulate")
            .arg(bench.path("job.toml"))
            .arg("--patterns")
            .arg(run.join("patterns.npz"))
            .arg("--quiet")
            .args(more)
            .output()
            .unwrap()
    };
    let message = text_of(2, "", &simulate(&["--output", &run.display().to_string()]));
    contains(
        &message,
        "",
        &["output.folder", "holds a run", "(from --output"],
    );
    assert!(simulate(&[]).status.success());
    assert!(bench.path("run-simulated/report.json").exists());
    assert!(!bench.path("run-simulated/history.csv").exists());
    assert!(simulate(&[]).status.success(), "over a simulation");
    assert_eq!(bench.earlier(), before);
}

impl Bench {
    /// What a command says that may write files of so many blocks, and must end with this code.
    #[cfg(unix)]
    fn on_small_disk(&self, blocks: u32, code: i32, line: &str) -> String {
        let command = env!("CARGO_BIN_EXE_tomolith");
        let line = format!("trap '' XFSZ; ulimit -f {blocks}; exec {command} {line}");
        let mut shell = Command::new("sh");
        shell.current_dir(self.temp.path()).args(["-c", &line]);
        text_of(code, &line, &shell.output().unwrap())
    }
}

/// A disk that is full in the middle of a file: one message, the file's, and nothing of the libraries behind it.
#[test]
#[cfg(unix)]
fn a_full_disk_ends_with_one_message() {
    let bench = Bench::beside_a_run();
    assert!(bench.tomolith(JOB, &["--quiet"]).status.success());
    let before = bench.earlier();
    // Patterns take 277 kB, the checkpoint of the patterns alone less than 150 kB (blocks of 512 or 1024 bytes)
    let checkpoint = "--set checkpoint.contents=patterns";
    let run = format!("run job.toml --quiet --overwrite {checkpoint}");
    let missing = "print and report of this run are missing";
    // A matrix of some megabytes stops in the same place
    let matrix = "export-matrix job.toml --output matrix.npz";
    let full = ".npz: it cannot be written: File too large";
    for (line, parts) in [
        (&*run, &["patterns.npz", full, missing][..]),
        (matrix, &["matrix.npz", full]),
    ] {
        let message = bench.on_small_disk(260, 2, line);
        contains(&message, line, parts);
        assert!(!message.contains("ZipWriter"), "{message}");
    }
    let unchanged = |files: Vec<(PathBuf, Vec<u8>)>| -> Vec<_> {
        let of_run = |path: &PathBuf| path.ends_with("job.toml") || path.ends_with("report.json");
        files.into_iter().filter(|(path, _)| of_run(path)).collect()
    };
    let now: Vec<_> = unchanged(bench.earlier())
        .into_iter()
        .filter(|(path, _)| !path.to_string_lossy().contains(".new"))
        .collect();
    assert_eq!(now, unchanged(before));
}

/// A file system without room for checkpoints: the run goes on and says so.
#[test]
#[cfg(unix)]
fn a_disk_that_is_full_during_the_optimization_is_a_warning() {
    let bench = Bench::beside_a_run();
    let file = bench.path("job.toml");
    fs::write(
        &file,
        JOB.replace("FOLDER", &bench.run_folder().display().to_string()),
    )
    .unwrap();
    // With thirty pairs a checkpoint takes 1.4 MB, the largest output 1.1 MB; the limit is 1.3 MB
    let settings = "--set stop.iterations=30 --set optimizer.lbfgs.memory=30 --set checkpoint.every_s=0.0001 \
                    --set objective.threshold.lower=0.99 --set objective.threshold.upper=1.0 --set evaluate.refine=2";
    let message = bench.on_small_disk(2600, 0, &format!("run job.toml --overwrite {settings}"));
    let warning = "no checkpoint can be written";
    assert_eq!(message.matches(warning).count(), 1, "{message}");
    let report = fs::read_to_string(bench.run_folder().join("report.json")).unwrap();
    contains(&report, "", &[warning]);
    let left = fs::read_dir(bench.run_folder().join("checkpoint")).unwrap();
    let names: Vec<_> = left.map(|entry| entry.unwrap().file_name()).collect();
    assert!(
        names.iter().all(|name| name == "state.safetensors"),
        "{names:?}"
    );
}

#[test]
fn a_checkpoint_belongs_to_the_dead_pixels_of_its_machine() {
    let bench = Bench::beside_a_run();
    let job = JOB.replace("[stop]", "[printer]\ndead_pixels = \"dead.npy\"\n[stop]");
    let with_dead = |pixel: usize, more: &[&str]| {
        let dead: Vec<f64> = (0..24 * 48)
            .map(|i| f64::from(u8::from(i == pixel)))
            .collect();
        bench.write("dead.npy", &doubles("24, 48", &dead));
        bench.tomolith(&job, &[&["--quiet"], more].concat())
    };
    let (one, another) = (12 * 48 + 24, 11 * 48 + 20);
    text_of(0, "", &with_dead(one, &[]));
    text_of(0, "", &with_dead(one, &["--resume"]));
    let answer = String::from_utf8_lossy(&with_dead(another, &["--resume"]).stderr).into_owned();
    assert!(
        answer.contains("what printer.dead_pixels leaves dark was"),
        "{answer}"
    );
}

#[test]
fn dead_pixels_that_leave_the_part_in_the_dark_are_blamed() {
    let bench = Bench::beside_a_run();
    bench.write("dead.npy", &doubles("24, 48", &[1.0; 24 * 48]));
    let job = JOB.replace("[stop]", "[printer]\ndead_pixels = \"dead.npy\"\n[stop]");
    let parts = [
        "error: printer.dead_pixels: the field reaches 0 mm sideways",
        "another map",
    ];
    bench.refused_before_work(&job, &parts);
}

#[test]
fn what_a_run_did_not_leave_is_named_with_its_option() {
    let bench = Bench::with(&[("job.toml", JOB)]);
    bench.done("run job.toml --output bare --keep metrics --quiet");
    bench.done("run job.toml --output light --keep patterns --quiet");
    let no_patterns = &["has no patterns: it was run with --keep metrics"];
    bench.refuse("export bare --output frames", no_patterns);
    bench.refuse("simulate job.toml --patterns bare --output s", no_patterns);
    let no_exposure = &["has no exposure.json: it was run with --keep metrics or patterns"];
    bench.refuse("expose light", no_exposure);
}

#[test]
fn an_option_that_there_is_not_is_not_taken_for_a_value() {
    let bench = Bench::with(&[("job.toml", JOB)]);
    let text = bench.says(2, "simulate job.toml --keep metrics", &["--keep"]);
    assert!(!text.contains("-- --keep"), "{text}");
    bench.says(2, "run job.toml --quite", &["--quiet"]);
}
