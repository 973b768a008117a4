//! The commands of the first minute: a new job, what the machine can do, shells, manuals, what a job can hold.

use crate::bench::{Bench, JOB, contains};
use serde_json::Value;
use std::io::Write;
use std::path::Path;
use std::process::Stdio;
use tomolith::job::{Document, Job};

#[test]
fn a_new_job_holds_what_was_said_and_runs() {
    let bench = Bench::with(&[]);
    let line = "new part.toml --part sphere --size-mm 2 --radius-mm 3 --wall-mm 0.5 --pixel-mm 0.1 --angles 40 --wavelength-nm 405 --index 1.48 --depth-mm 10";
    bench.says(0, line, &["tomolith run part.toml"]);
    let job = Job::read(&bench.path("part.toml"), &[]).unwrap();
    let vial = &job.spec.vial.kind["cylinder"];
    assert_eq!(vial["outer_radius_mm"].as_f64(), Some(3.5));
    assert_eq!(job.spec.resin.absorption_per_mm, Some(0.1));
    // The box of a sphere of 2 mm, across its corners 1.48 times as wide before light is bent into the resin, and eight pixels more
    assert_eq!(job.spec.light[0].pixels, [50, 28]);
    let checked = bench.json("check part.toml");
    assert_eq!(checked["frames"], 40);
    assert!(!checked.to_string().contains("reaches only"), "{checked}");
    // Nothing is written over
    bench.refuse(line, &["part.toml"]);
    bench.done("new named.toml --resin sr399-tpo --printer opencal");
    let named = Job::read(&bench.path("named.toml"), &[]).unwrap().spec;
    assert_eq!(named.resin.absorption_per_mm, Some(0.1148));
    assert_eq!(named.printer.unwrap().canvas, Some([1920, 1080]));
    // The text alone
    let text = bench.stdout(0, "new - --part gyroid");
    let spec = Job::from_document(Document::toml("a.toml", text).unwrap())
        .unwrap()
        .spec;
    assert_eq!(spec.target.phantom.unwrap(), "gyroid");
}

#[test]
fn a_new_job_moves_the_light_to_the_flat_faces_of_the_part() {
    let bench = Bench::with(&[]);
    // A roof 1.06 mm high: its base lies at −0.53 mm, rows of 0.05 mm end at −0.55
    let corners = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0.5 1.06\nv 2 0.5 1.06\n";
    let faces = "f 1 4 3 2\nf 1 2 6 5\nf 3 4 5 6\nf 1 5 4\nf 2 3 6\n";
    bench.write("roof.obj", &format!("{corners}{faces}"));
    bench.done("new roof.toml --part roof.obj");
    let job = Job::read(&bench.path("roof.toml"), &[]).unwrap();
    assert_eq!(job.spec.light[0].offset_mm.map(|mm| mm.0), [0.0, 0.02]);
    let warned = |options: &str| {
        let checked = bench.json(&format!("check roof.toml {options}"));
        checked["warnings"].to_string().contains("rows of pixels")
    };
    assert!(!warned("") && warned("--set light[0].offset_mm=[0,0]"));
}

#[test]
fn a_new_job_that_cannot_be_is_refused_and_not_written() {
    let bench = Bench::with(&[]);
    for (line, words) in [
        ("new a.toml --part gaer", "did you mean `gear`?"),
        ("new a.toml --part none.stl", "--part: none.stl"),
        ("new a.toml --radius-mm 1", "--size-mm, --radius-mm: target"),
        ("new - --index 0.9", "--index: resin.refractive_index"),
        ("new a.toml --depth-mm 0", "--depth-mm"),
        ("new a.toml --pixel-mm nan", "--pixel-mm"),
        ("new a.toml --angles 0", "--angles"),
        // No voxel is half filled
        (
            "new a.toml --pixel-mm 2",
            "--size-mm, --pixel-mm: target: no voxel",
        ),
        (
            "new a.toml --size-mm 0.05",
            "--size-mm, --pixel-mm: target: no",
        ),
        ("new none/a.toml", "there is no folder"),
    ] {
        bench.refuse(line, &[words]);
        assert!(!bench.path("a.toml").exists(), "{line}");
    }
}

#[test]
fn the_doctor_finds_closed_forms() {
    let bench = Bench::with(&[]);
    let found = bench.json("doctor");
    assert_eq!(found["is_right"], true, "{found}");
    let checks = found["checks"].as_array().unwrap();
    assert_eq!(checks.len(), 3);
    bench.says(0, "doctor", &["instructions", "right: "]);
    // What a run plans with is no part of what is free
    let memory = found["machine"]["memory"].as_str().unwrap();
    if cfg!(target_os = "linux") {
        let parts = ["a run plans with ", " (80 % of this computer's memory); "];
        contains(memory, "doctor", &parts);
    }
}

#[test]
fn shells_and_manuals_know_every_command() {
    let bench = Bench::with(&[]);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let line = format!("completions {shell}");
        bench.says(0, &line, &["voxelize", "doctor"]);
    }
    bench.done("man pages");
    let page = bench.read("pages/tomolith-run.1");
    assert!(page.contains("resume"), "{page}");
}

#[test]
fn a_job_comes_from_standard_input() {
    let bench = Bench::with(&[]);
    let piped = |line: &str, text: &str| {
        let mut child = bench
            .command(line)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child
            .stdin
            .take()
            .unwrap()
            .write_all(text.as_bytes())
            .unwrap();
        let output = child.wait_with_output().unwrap();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        (output.status.code(), message, output.stdout)
    };
    let (code, message, _) = piped("run - -o out --quiet", JOB);
    assert_eq!(code, Some(0), "{message}");
    assert!(bench.path("out/report.html").exists());
    let (code, _, found) = piped("check - --json", JOB);
    let found: Value = serde_json::from_slice(&found).unwrap();
    assert_eq!((code, &found["frames"]), (Some(0), &Value::from(24)));
    let (code, message, _) = piped("check -", &JOB.replace("iterations", "iteratons"));
    assert_eq!(code, Some(2));
    contains(&message, "", &["stdin.toml, line 16", "did you mean"]);
}

#[test]
fn several_jobs_run_one_after_the_other_and_one_that_cannot_does_not_end_them() {
    let wrong = JOB.replace("1.5", "0.5");
    let bench = Bench::with(&[("a.toml", JOB), ("b.toml", &wrong), ("c.toml", JOB)]);
    bench.refuse(
        "run a.toml b.toml c.toml --keep metrics",
        &["refractive_index"],
    );
    for (name, is_there) in [("a", true), ("b", false), ("c", true)] {
        let report = format!("out/{name}/report.json");
        assert_eq!(bench.path(&report).exists(), is_there, "{name}");
    }
    bench.refuse(
        "run a.toml c.toml -o out",
        &["--output: one folder for 2 jobs"],
    );
    // A run folder is no job, and says what to do with it
    bench.refuse("run out/a", &["out/a/job.toml -o out/a --resume"]);
}

#[test]
fn tables_have_pages_like_families() {
    let bench = Bench::with(&[]);
    bench.says(0, "kinds printer", &["[printer]:", "printer.canvas"]);
    let stop = bench.stdout(0, "kinds stop --json");
    let stop: Value = serde_json::from_str(&stop).unwrap();
    let keys = stop["keys"].as_array().unwrap();
    let iterations = keys.iter().find(|key| key["name"] == "stop.iterations");
    assert_eq!(iterations.unwrap()["default"], 45);
    bench.refuse("kinds printr", &["did you mean `printer`?"]);
}

#[test]
fn errors_are_colored_where_that_is_asked_for() {
    let bench = Bench::with(&[]);
    let is_colored = |line: &str| bench.ended(2, line).stderr.contains(&0x1b);
    assert!(is_colored("check none.toml --color always"));
    assert!(!is_colored("check none.toml --color never"));
    // Nobody reads a pipe in color
    assert!(!is_colored("check none.toml"));
}

#[test]
fn the_schema_in_docs_is_the_one_of_this_program_and_examples_name_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let bench = Bench::with(&[]);
    let written = std::fs::read_to_string(root.join("docs/job.schema.json")).unwrap();
    assert!(
        written == bench.stdout(0, "schema"),
        "docs/job.schema.json is stale: tomolith schema > docs/job.schema.json"
    );
    for entry in std::fs::read_dir(root.join("examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|end| end == "toml") {
            let text = std::fs::read_to_string(&path).unwrap();
            let names = text.starts_with("#:schema ../docs/job.schema.json\n");
            assert!(names, "{}", path.display());
        }
    }
}

#[test]
fn profiles_are_listed_and_printed() {
    let bench = Bench::with(&[]);
    let all = ["printer = \"opencal\"", "resin = \"sr399-tpo\""];
    bench.says(0, "profiles", &all);
    let one = ["# Source: ", "absorption_per_mm = 0.1148"];
    bench.says(0, "profiles sr399-tpo", &one);
    bench.refuse("profiles opncal", &["did you mean `opencal`?"]);
}
