//! Graphics cards as the command names, refuses and uses them.
#![cfg(feature = "gpu")]

use std::path::Path;
use std::process::{Command, Output};

const GEAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/01-gear.toml");
const CONE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../examples/12-tilted-cone.toml"
);
const WAVES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/17-waves.toml");
const SCATTERING: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../examples/13-scattering.toml"
);

const PATHS: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../examples/15-scattering-cone.toml"
);

fn tomolith(arguments: &[&str]) -> Output {
    let command = env!("CARGO_BIN_EXE_tomolith");
    Command::new(command).args(arguments).output().unwrap()
}

/// The part of a name of a card: a real one, or the software adapter; None where there is none.
fn card() -> Option<String> {
    let found = tomolith(&["devices", "--json"]);
    let line: serde_json::Value = serde_json::from_slice(&found.stdout).unwrap();
    let name = line["devices"][0]["name"].as_str().map(str::to_owned);
    assert!(
        name.is_some() || std::env::var_os("TOMOLITH_NEEDS_GPU").is_none(),
        "TOMOLITH_NEEDS_GPU is set, and there is no card"
    );
    name
}

fn run(job: &str, device: &str, folder: &Path, more: &[&str]) -> Output {
    let folder = folder.to_str().unwrap();
    let mut arguments = vec!["run", job, "--toy", "--quiet", "--device", device];
    arguments.extend(["--output", folder]);
    arguments.extend(more);
    tomolith(&arguments)
}

fn done(output: &Output) {
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}");
}

fn report(folder: &Path) -> serde_json::Value {
    serde_json::from_str(&std::fs::read_to_string(folder.join("report.json")).unwrap()).unwrap()
}

/// A number of the evaluations of two runs.
fn both(number: &str, runs: [&Path; 2]) -> [f64; 2] {
    runs.map(|run| report(run)["evaluation"][number].as_f64().unwrap())
}

#[test]
fn a_card_that_is_not_there_is_refused_with_what_there_is() {
    let folder = tempfile::tempdir().unwrap();
    for (device, expected) in [
        (
            "gpu:no such card",
            "graphics card gpu:no such card: no such graphics card; this machine shows",
        ),
        ("tpu", "resources.device: found \"tpu\""),
        ("gpu:", "resources.device: found \"gpu:\""),
    ] {
        let refused = run(GEAR, device, &folder.path().join("run"), &[]);
        let text = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert_eq!(refused.status.code(), Some(2), "{text}");
        assert!(text.contains(expected), "{text}");
        assert!(!folder.path().join("run").exists());
    }
}

#[test]
fn a_card_prints_what_the_processor_prints_and_resumes_to_the_bit() {
    let Some(name) = card() else { return };
    let device = format!("gpu:{name}");
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let steps = |n: u32| format!("stop.iterations={n}");
    let (six, ten) = (steps(6), steps(10));
    let arguments = ["check", GEAR, "--toy", "--device", &device];
    let checked = tomolith(&arguments);
    done(&checked);
    let text = String::from_utf8_lossy(&checked.stdout).into_owned();
    // In software it may take too long to be tried to its end
    let says = "the start of the optimization takes ";
    assert!(
        text.contains(says) && text.contains(" MB of the "),
        "{text}"
    );
    done(&run(GEAR, &device, &at("card"), &["--set", &ten]));
    done(&run(GEAR, "cpu", &at("processor"), &["--set", &ten]));
    let [card, processor] = both("iou", [&at("card"), &at("processor")]);
    assert!((card - processor).abs() < 1e-3, "{card} {processor}");
    assert!(report(&at("card")).to_string().contains("parallel (on "));
    done(&run(GEAR, &device, &at("resumed"), &["--set", &six]));
    // Another device has another memory of the steps
    let refused = run(GEAR, "cpu", &at("resumed"), &["--set", &ten, "--resume"]);
    let text = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(2), "{text}");
    assert!(text.contains("resources.device"), "{text}");
    done(&run(
        GEAR,
        &device,
        &at("resumed"),
        &["--set", &ten, "--resume"],
    ));
    let patterns = |name: &str| std::fs::read(at(name).join("patterns.npz")).unwrap();
    assert!(patterns("resumed") == patterns("card"));
}

#[test]
fn tilted_cones_and_waves_print_on_a_card_what_they_print_on_the_processor() {
    let Some(name) = card() else { return };
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let five = ["--set", "stop.iterations=5", "--overwrite"];
    for (job, model) in [(CONE, "exact line integrals (on "), (WAVES, "wave (on ")] {
        done(&run(job, &format!("gpu:{name}"), &at("card"), &five));
        done(&run(job, "cpu", &at("processor"), &five));
        let [card, processor] = both("iou", [&at("card"), &at("processor")]);
        assert!((card - processor).abs() < 1e-3, "{card} {processor}");
        let text = report(&at("card")).to_string();
        assert!(text.contains(model), "{text}");
    }
}

#[test]
fn light_that_scatters_prints_on_a_card_what_it_prints_on_the_processor() {
    let Some(name) = card() else { return };
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    // Cells as large as they may be: software takes long for small ones
    let cells = "model.successive_orders.cell_mm=1.9";
    let five = ["--set", "stop.iterations=5", "--set", cells];
    done(&run(SCATTERING, &format!("gpu:{name}"), &at("card"), &five));
    done(&run(SCATTERING, "cpu", &at("processor"), &five));
    // How far doses in the part are spread: 0.07
    let [card, processor] = both("cv", [&at("card"), &at("processor")]);
    assert!((card - processor).abs() < 1e-5, "{card} {processor}");
    let text = report(&at("card")).to_string();
    assert!(text.contains("successive_orders (parallel (on "), "{text}");
}

#[test]
fn random_paths_on_a_card_print_what_the_processor_prints_and_resume_to_the_bit() {
    let Some(name) = card() else { return };
    let device = format!("gpu:{name}");
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    // Other paths from the fifth and from the ninth iteration on
    let steps = |n: u32| format!("stop.iterations={n}");
    let (six, ten) = (steps(6), steps(10));
    let often = ["--set", "model.monte_carlo.renew=4", "--set"];
    let set = |n| [&often[..], &[n]].concat();
    done(&run(PATHS, &device, &at("card"), &set(&ten)));
    done(&run(PATHS, "cpu", &at("processor"), &set(&ten)));
    let [card, processor] = both("iou", [&at("card"), &at("processor")]);
    assert!((card - processor).abs() < 0.02, "{card} {processor}");
    let [card, processor] = both("cv", [&at("card"), &at("processor")]);
    // From seed to seed it differs by 5 % on either
    assert!((card / processor - 1.0).abs() < 0.1, "{card} {processor}");
    let text = report(&at("card")).to_string();
    assert!(
        text.contains("monte_carlo, 4 per pixel and frame, Monte Carlo paths of scattered light and exact line integrals (on "),
        "{text}"
    );
    // Its first paths are those of the sixth iteration again
    done(&run(PATHS, &device, &at("resumed"), &set(&six)));
    let more = [&set(&ten)[..], &["--resume"]].concat();
    done(&run(PATHS, &device, &at("resumed"), &more));
    let patterns = |name: &str| std::fs::read(at(name).join("patterns.npz")).unwrap();
    assert!(patterns("resumed") == patterns("card"));
}
