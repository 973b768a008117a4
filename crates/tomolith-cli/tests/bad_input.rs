//! Bad input ends before any heavy work with one clear message, exit code 2, and earlier outputs as they were.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// A job that works, small.
const JOB: &str = r#"[target]
phantom = "gear"
size_mm = 2.0

[grid]
pitch_mm = 0.1

[resin]
refractive_index = 1.5
absorption_per_mm = 0.05

[vial.cylinder]
inner_radius_mm = 3.0
outer_radius_mm = 3.5
refractive_index = 1.5

[[light]]
pixels = [48, 24]
angles = 30
projector.collimated = { pixel_pitch_mm = 0.1 }

[objective.threshold]
lower = 0.85
upper = 0.95

[stop]
iterations = 2

[output]
folder = "FOLDER"
"#;

/// A folder with a job and an earlier run.
struct Bench {
    temp: TempDir,
}

impl Bench {
    fn new() -> Self {
        let bench = Bench {
            temp: tempfile::tempdir().unwrap(),
        };
        let run = bench.run_folder();
        fs::create_dir_all(run.join("frames")).unwrap();
        let mark = "# A Tomolith run folder; this is its job with every default written out.\n";
        fs::write(run.join("job.toml"), mark).unwrap();
        fs::write(run.join("report.json"), "{\"earlier\": true}").unwrap();
        fs::write(run.join("frames/0000.png"), "earlier").unwrap();
        bench
    }

    fn path(&self, name: &str) -> PathBuf {
        self.temp.path().join(name)
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
        tomolith(&file, more)
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

/// What is wrong: text of the job, what stands there instead, what marks the line, parts of the message.
type Wrong = (
    &'static str,
    &'static str,
    &'static str,
    &'static [&'static str],
);

/// One row per kind of slip.
const WRONG: &[Wrong] = &[
    // Names
    (
        "iterations = 2",
        "iteratons = 2",
        "iteratons",
        &["stop.iteratons", "did you mean `iterations`?"],
    ),
    (
        "[resin]",
        "[resn]",
        "[resn]",
        &["resn", "did you mean `resin`?"],
    ),
    (
        "[vial.cylinder]",
        "[vial.cilinder]",
        "[vial.cil",
        &["vial.cilinder", "did you mean `cylinder`?", "index_matched"],
    ),
    (
        "[objective.threshold]",
        "[objective.treshold]",
        "[objective.tre",
        &["objective.treshold", "did you mean `threshold`?"],
    ),
    (
        "lower = 0.85",
        "lwer = 0.85",
        "lwer",
        &["objective.threshold.lwer", "did you mean `lower`?"],
    ),
    (
        "\"gear\"",
        "\"gaer\"",
        "\"gaer\"",
        &["target.phantom", "did you mean `gear`?"],
    ),
    (
        "[stop]",
        "[optimizer.lbfg]\n[stop]",
        "[optimizer.lbfg",
        &["optimizer.lbfg", "did you mean `lbfgs`?"],
    ),
    (
        "collimated",
        "colimated",
        "colimated",
        &["light[0].projector.colimated", "did you mean `collimated`?"],
    ),
    // Types and units
    (
        "iterations = 2",
        "iterations = \"two\"",
        "\"two\"",
        &["stop.iterations", "a whole number, 0 or more"],
    ),
    (
        "iterations = 2",
        "iterations = 2.5",
        "2.5",
        &["stop.iterations", "a whole number, 0 or more"],
    ),
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = \"0.1 kg\"\n\n",
        "kg",
        &["grid.pitch_mm", "unknown unit of length `kg`", "nm, um, mm"],
    ),
    (
        "inner_radius_mm = 3.0",
        "inner_radius_mm = true",
        "true",
        &["vial.cylinder.inner_radius_mm", "a length"],
    ),
    (
        "[48, 24]",
        "[48]",
        "[48]",
        &["light[0].pixels", "a list of 2"],
    ),
    ("[[light]]", "[light]", "[light]", &["light", "a list"]),
    // Numbers that cannot be
    (
        "0.05",
        "nan",
        "nan",
        &["resin.absorption_per_mm", "a finite number"],
    ),
    (
        "0.05",
        "inf",
        "inf",
        &["resin.absorption_per_mm", "a finite number"],
    ),
    (
        "0.05",
        "-0.05",
        "-0.05",
        &["resin.absorption_per_mm", "found -0.05"],
    ),
    (
        "0.05",
        "0",
        "per_mm = 0",
        &["resin.absorption_per_mm", "found 0", "pure_radon"],
    ),
    (
        "refractive_index = 1.5\nabs",
        "refractive_index = 0.5\nabs",
        "0.5",
        &["resin.refractive_index", "found 0.5"],
    ),
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = 0\n\n",
        "pitch_mm = 0\n",
        &["grid.pitch_mm", "found 0"],
    ),
    (
        "size_mm = 2.0",
        "size_mm = -2.0",
        "-2.0",
        &["target.size_mm", "-2"],
    ),
    (
        "angles = 30",
        "angles = 0",
        "angles = 0",
        &["light[0].angles", "found 0"],
    ),
    (
        "angles = 30",
        "angles = { list_deg = [] }",
        "list_deg",
        &["light[0].angles.list_deg", "an empty list", "azimuths"],
    ),
    (
        "inner_radius_mm = 3.0",
        "inner_radius_mm = 3.5",
        "inner_r",
        &["vial.cylinder.inner_radius_mm", "outer_radius_mm = 3.5"],
    ),
    // Bands
    (
        "lower = 0.85",
        "lower = 0.95",
        "lower",
        &["objective.threshold.lower", "0.95"],
    ),
    (
        "lower = 0.85",
        "lower = 1.85",
        "lower",
        &["objective.threshold.lower", "1.85"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\nceiling = 0.9",
        "ceiling",
        &["objective.threshold.ceiling", "0.9"],
    ),
    (
        "threshold]\nlower = 0.85\nupper = 0.95",
        "bclp]\nepsilon = -0.1",
        "epsilon",
        &["objective.bclp.epsilon", "-0.1"],
    ),
    // Numbers with which no loss is a number
    (
        "upper = 0.95",
        "upper = 0.95\nexponent = 1e30",
        "exponent",
        &["objective.threshold.exponent", "at most 100"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\nceiling = 1e38",
        "ceiling",
        &["objective.threshold.ceiling", "from -1e9 to 1e9"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\npart_weight = 1e300",
        "part_weight",
        &["objective.threshold.part_weight", "from 0 to 1e9"],
    ),
    (
        "[objective.threshold]",
        "[objective]\nweight = 1e300\n[objective.threshold]",
        "weight",
        &["objective.weight", "from 0 to 1e9"],
    ),
    (
        "[stop]",
        "[response.logistic]\nsteepness = 1e30\n[stop]",
        "steepness",
        &["response.logistic.steepness", "at most 1e6"],
    ),
    (
        "[stop]",
        "[bounds]\nmin = 1e30\n[stop]",
        "min = 1e30",
        &["bounds.min", "0 to 1e9 mJ/mm²"],
    ),
    (
        "[stop]",
        "[bounds]\nmax = 1e30\n[stop]",
        "max = 1e30",
        &["bounds.max", "from bounds.min = 0 to 1e9 mJ/mm²"],
    ),
    (
        "[stop]",
        "[checkpoint]\nevery_s = \"often\"\n[stop]",
        "often",
        &["checkpoint.every_s", "seconds above 0, or \"auto\""],
    ),
    // More than a machine holds
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = 0.0002\n\n",
        "pitch_mm = 0.0002",
        &["grid.pitch_mm", "memory", "MB needed", "MB available"],
    ),
    (
        "pixels = [48, 24]\nangles = 30",
        "pixels = [16000, 16000]\nangles = 1400",
        "pixels",
        &[
            "light[0].pixels",
            "memory",
            "MB needed",
            "fewer pixels or angles",
        ],
    ),
    // Responses and penalties
    (
        "threshold]\nlower = 0.85\nupper = 0.95",
        "pm]\nd_h = 1.4\nd_l = 0.7\n[response.logistic]\nupper = 1.0",
        "pm]",
        &["objective.pm", "1.4", "cannot reach"],
    ),
    (
        "[stop]",
        "[response.table]\ndose = [0, 1, 2]\nresponse = [0.0, 0.6, 0.5]\n[stop]",
        "response = ",
        &["response.table.response[2]", "0.5 after 0.6", "falls"],
    ),
    (
        "[stop]",
        "[response.logistic]\nupper = 0.97\n[stop]",
        "response",
        &["response", "no dose has the response 1", "0.97"],
    ),
    (
        "[stop]",
        "[[penalties]]\nsparsity = { exponent = 2 }\n[stop]",
        "penalties",
        &["penalties[0].weight", "missing"],
    ),
    // What does not fit
    (
        "size_mm = 2.0",
        "size_mm = 9.0",
        "[target]",
        &["target", "reaches 4.5", "the resin ends at 3"],
    ),
    (
        "[48, 24]",
        "[12, 24]",
        "[12, 24]",
        &["light[0].pixels", "sideways"],
    ),
    (
        "[48, 24]",
        "[48, 4]",
        "[48, 4]",
        &["light[0].pixels", "along the axis"],
    ),
    // The machine
    (
        "[stop]",
        "[printer]\nrpm = 3\n[stop]",
        "rpm = 3",
        &["printer.rpm", "unknown name"],
    ),
    (
        "[stop]",
        "[printer]\ncanvas = [40, 60]\n[stop]",
        "[40, 60]",
        &["printer.canvas", "need 48 × 24", "at least [48, 24]"],
    ),
    (
        "[stop]",
        "[printer]\ngrey_curve = [[0.0, 0.0], [0.5, 0.7], [1.0, 0.6]]\n[stop]",
        "grey_curve",
        &["printer.grey_curve", "not monotone"],
    ),
    (
        "[stop]",
        "[printer]\nflat_field = \"none.png\"\n[stop]",
        "flat_field",
        &["printer.flat_field", "none.png"],
    ),
    (
        "[stop]",
        "[printer]\nrefresh_hz = 4.0\n[stop]",
        "[output]",
        &["output.rpm", "5 frames a second", "at most 8 turns"],
    ),
    (
        "[stop]",
        "[printer]\ncopies_px = [[0, 0], [30, 0]]\n[stop]",
        "copies_px",
        &["printer.copies_px", "copies 1 and 2 overlap"],
    ),
    // What is planned
    (
        "0.05",
        "0.05\nscattering_per_mm = 1.0",
        "scatt",
        &["resin.scattering_per_mm", "not built yet"],
    ),
    (
        "0.05",
        "0.05\nphase.rayleigh = {}",
        "phase",
        &["resin.phase", "scattering is not in this version"],
    ),
    // Syntax
    (
        "iterations = 2",
        "iterations = 2\niterations = 3",
        "iterations = 3",
        &["duplicate key"],
    ),
    (
        "iterations = 2",
        "iterations = ",
        "iterations =",
        &["a job file in TOML"],
    ),
];

#[test]
fn every_slip_is_named_with_key_line_and_what_is_accepted() {
    let bench = Bench::new();
    let before = bench.earlier();
    for (from, to, mark, parts) in WRONG {
        assert!(JOB.contains(from), "{from:?} is not in the job");
        let job = JOB.replacen(from, to, 1);
        let line = 1 + job[..job.find(mark).unwrap()].matches('\n').count();
        let output = bench.tomolith(&job, &[]);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{to:?}: {message}");
        let place = format!("job.toml, line {line})");
        for part in parts.iter().copied().chain([place.as_str()]) {
            assert!(
                flat(&message).contains(part),
                "{to:?}: `{part}` is not in\n{message}"
            );
        }
        assert_eq!(bench.earlier(), before, "{to:?} changed earlier outputs");
    }
}

/// A message without the line breaks and the frame of its display.
fn flat(message: &str) -> String {
    let words = message.split_whitespace().filter(|word| *word != "│");
    words.collect::<Vec<_>>().join(" ")
}

#[test]
fn meshes_that_cannot_be_printed_are_refused() {
    let bench = Bench::new();
    let before = bench.earlier();
    let facet = |points: [[f32; 3]; 3]| {
        let vertices: String = points
            .iter()
            .map(|[x, y, z]| format!("vertex {x} {y} {z}\n"))
            .collect();
        format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    let flat_sheet = format!(
        "solid a\n{}{}endsolid a\n",
        facet([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        facet([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    );
    let mut truncated = vec![0u8; 80];
    truncated.extend(1000u32.to_le_bytes());
    truncated.extend([0u8; 70]);
    for (name, content) in [
        ("missing.stl", None),
        ("empty.stl", Some(Vec::new())),
        ("truncated.stl", Some(truncated)),
        ("flat.stl", Some(flat_sheet.into_bytes())),
        ("none.stl", Some(b"solid a\nendsolid a\n".to_vec())),
    ] {
        if let Some(content) = content {
            fs::write(bench.path(name), content).unwrap();
        }
        let output = bench.tomolith(
            &JOB.replace("phantom = \"gear\"", &format!("mesh = \"{name}\"")),
            &[],
        );
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name}: {message}");
        assert!(flat(&message).contains(name), "{name} is not in\n{message}");
        assert_eq!(bench.earlier(), before, "{name} changed earlier outputs");
    }
}

#[test]
fn a_folder_that_is_not_ours_is_left_alone() {
    let bench = Bench::new();
    let foreign = bench.path("thesis");
    fs::create_dir(&foreign).unwrap();
    fs::write(foreign.join("chapter.tex"), "mine").unwrap();
    let output = bench.tomolith(JOB, &["--output", &foreign.display().to_string()]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in ["output.folder", "not from a run", "(from --output /"] {
        assert!(flat(&message).contains(part), "{part}: {message}");
    }
    assert!(!message.contains("line"), "blamed on the file: {message}");
    assert_eq!(fs::read_dir(&foreign).unwrap().count(), 1);
}

#[test]
fn too_little_memory_is_said_with_the_estimate() {
    let bench = Bench::new();
    let before = bench.earlier();
    let output = bench.tomolith(JOB, &["--set", "grid.shape=[9000, 9000, 9000]"]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        flat(&message).contains("grid.shape: memory") && flat(&message).contains("MB needed"),
        "{message}"
    );
    assert_eq!(bench.earlier(), before);
}

#[test]
fn an_override_names_itself_and_json_errors_are_one_line() {
    let bench = Bench::new();
    let output = bench.tomolith(JOB, &["--set", "light.angles=0", "--json"]);
    assert_eq!(output.status.code(), Some(2));
    let line: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        (&line["event"], &line["key"]),
        (&"error".into(), &"light[0].angles".into())
    );
    assert!(
        line["found"]
            .as_str()
            .unwrap()
            .contains("--set light.angles=0"),
        "{line}"
    );
    let output = tomolith(&bench.path("nothing.toml"), &[]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("nothing.toml"));
}

#[test]
fn what_an_option_set_is_not_blamed_on_the_file() {
    let bench = Bench::new();
    for (option, key) in [
        ("light.pixels=[0,0]", "light[0].pixels[0]"),
        ("light.angles={list_deg=[]}", "light[0].angles.list_deg"),
        ("light.pixels=[12, 24]", "light[0].pixels"),
        ("target.size_mm=9", "target"),
        ("resin.phase.rayleigh={}", "resin.phase"),
    ] {
        let output = bench.tomolith(JOB, &["--set", option]);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{option}: {message}");
        let parts = [format!("× {key}: "), format!("(from --set {option})")];
        for part in parts {
            assert!(flat(&message).contains(&part), "{part}: {message}");
        }
        assert!(!message.contains("job.toml"), "{option}: {message}");
    }
}

#[test]
fn a_grey_image_has_an_objective_of_its_own_and_refuses_that_of_part_and_void() {
    let bench = Bench::new();
    let image = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/images/rings.png");
    let phantom = "phantom = \"gear\"";
    let grey = JOB.replace(
        phantom,
        &format!("image = \"{}\"\nheight_mm = 0.5", image.display()),
    );
    let line = 1 + grey[..grey.find("[objective").unwrap()]
        .matches('\n')
        .count();
    let output = bench.tomolith(&grey, &[]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in [
        "objective.threshold: ",
        "the target is grey",
        "l2, l1, dose_matching and bclp",
        &format!("job.toml, line {line})"),
    ] {
        assert!(flat(&message).contains(part), "{part}: {message}");
    }
    let default = grey.replace("[objective.threshold]\nlower = 0.85\nupper = 0.95\n", "");
    let output = bench.tomolith(&default, &["--quiet"]);
    assert_eq!(output.status.code(), Some(0));
    let resolved = fs::read_to_string(bench.run_folder().join("job.toml")).unwrap();
    assert!(resolved.contains("[objective.l2]"), "{resolved}");
}

#[test]
fn resuming_says_what_to_do_and_what_has_changed() {
    let bench = Bench::new();
    assert!(bench.tomolith(JOB, &["--quiet"]).status.success());
    let refused = |more: &[&str], parts: &[&str]| {
        let output = bench.tomolith(JOB, &[&["--resume"], more].concat());
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        for part in ["× --resume: leave it out to begin anew"]
            .iter()
            .chain(parts)
        {
            assert!(flat(&message).contains(part), "{part}: {message}");
        }
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
    let output = bench.tomolith(
        JOB,
        &[&more[..], &["--set", "objective.threshold.exponent=2"]].concat(),
    );
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
}

#[test]
fn a_simulation_never_mixes_with_a_run() {
    let bench = Bench::new();
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
    let output = simulate(&["--output", &run.display().to_string()]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    for part in ["output.folder", "holds a run", "(from --output"] {
        assert!(flat(&message).contains(part), "{part}: {message}");
    }
    assert!(simulate(&[]).status.success());
    assert!(bench.path("run-simulated/report.json").exists());
    assert!(!bench.path("run-simulated/history.csv").exists());
    assert!(simulate(&[]).status.success(), "over a simulation");
    assert_eq!(bench.earlier(), before);
}

/// A disk that is full in the middle of a file: one message, the file's, and nothing of the libraries behind it.
#[test]
#[cfg(unix)]
fn a_full_disk_ends_with_one_message() {
    let bench = Bench::new();
    assert!(bench.tomolith(JOB, &["--quiet"]).status.success());
    let before = bench.earlier();
    // Patterns take 277 kB, the checkpoint of the patterns alone less than 150 kB (blocks of 512 or 1024 bytes)
    let checkpoint = "--set checkpoint.contents=patterns";
    let line = format!(
        "trap '' XFSZ; ulimit -f 260; exec {} run {} --quiet {checkpoint}",
        env!("CARGO_BIN_EXE_tomolith"),
        bench.path("job.toml").display()
    );
    let output = Command::new("sh").args(["-c", &line]).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        flat(&message).contains("patterns.npz: File too large"),
        "{message}"
    );
    assert!(!message.contains("ZipWriter"), "{message}");
    // A matrix of some megabytes stops in the same place
    let line = format!(
        "trap '' XFSZ; ulimit -f 260; exec {} export-matrix {} --output {}",
        env!("CARGO_BIN_EXE_tomolith"),
        bench.path("job.toml").display(),
        bench.path("matrix.npz").display()
    );
    let output = Command::new("sh").args(["-c", &line]).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        flat(&message).contains("matrix.npz: File too large") && !message.contains("ZipWriter"),
        "{message}"
    );
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
