//! Graphics cards as the command names, refuses and uses them.
#![cfg(feature = "gpu")]

use crate::bench::{Bench, contains};

const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");

/// A job of the examples, typed to be run on a device; results go to a folder.
fn run(job: &str, device: &str, folder: &str, more: &str) -> String {
    let device = device.replace(' ', "~");
    format!("run {EXAMPLES}/{job}.toml --toy --quiet --device {device} --output {folder} {more}")
}

/// The first card as `--device` takes it: a real one, or the software adapter; None where there is none.
fn card(bench: &Bench) -> Option<String> {
    let found = bench.json("devices");
    let name = found["devices"][0]["name"].as_str();
    assert!(
        name.is_some() || std::env::var_os("TOMOLITH_NEEDS_GPU").is_none(),
        "TOMOLITH_NEEDS_GPU is set, and there is no card"
    );
    name.map(|name| format!("gpu:{name}"))
}

/// A number of the evaluations on the card and on the processor.
fn both(bench: &Bench, number: &str) -> [f64; 2] {
    let number_of = |folder: &str| bench.report(folder)["evaluation"][number].as_f64();
    ["card", "processor"].map(|folder| number_of(folder).unwrap())
}

/// Runs a job on both; numbers of their evaluations differ by less, and the report names the model on the card.
fn prints_alike(bench: &Bench, [job, model]: [&str; 2], more: &str, number: &str, most: f64) {
    let Some(device) = card(bench) else { return };
    bench.done(&run(job, &device, "card", more));
    bench.done(&run(job, "cpu", "processor", more));
    let [card, processor] = both(bench, number);
    assert!((card - processor).abs() < most, "{card} {processor}");
    let text = bench.report("card").to_string();
    assert!(text.contains(model), "{text}");
}

#[test]
fn a_card_that_is_not_there_is_refused_with_what_there_is() {
    let bench = Bench::with(&[]);
    for (device, expected) in [
        (
            "gpu:no such card",
            "graphics card gpu:no such card: no such graphics card; this machine shows",
        ),
        ("tpu", "resources.device: found \"tpu\" (from --device tpu)"),
        ("gpu:", "resources.device: found \"gpu:\""),
    ] {
        let line = run("01-gear", device, "run", "");
        let refused = bench.ended(2, &line);
        let text = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(text.contains(expected), "{text}");
        assert!(!bench.path("run").exists());
    }
}

#[test]
fn a_job_for_any_card_says_that_the_processor_computes_it() {
    let bench = Bench::with(&[]);
    let devices = bench.json("devices");
    let is_real = |device: &serde_json::Value| device["is_software"] == false;
    if devices["devices"].as_array().unwrap().iter().any(is_real) {
        return;
    }
    bench.done(&run("01-gear", "auto", "auto", "--set stop.iterations=2"));
    let text = bench.report("auto").to_string();
    assert!(
        text.contains("no graphics card was found, so the processor computes"),
        "{text}"
    );
}

#[test]
fn a_card_prints_what_the_processor_prints_and_resumes_to_the_bit() {
    let bench = Bench::with(&[]);
    let Some(device) = card(&bench) else { return };
    let line = format!(
        "check {EXAMPLES}/01-gear.toml --toy --device {}",
        device.replace(' ', "~")
    );
    let text = bench.stdout(0, &line);
    // In software it may take too long to be tried to its end
    let says = "the start of the optimization takes ";
    contains(&text, "", &[says, " MB of the "]);
    let (six, ten) = ("--set stop.iterations=6", "--set stop.iterations=10");
    let goes_on = format!("{ten} --resume");
    let parallel = ["01-gear", "parallel (on "];
    prints_alike(&bench, parallel, ten, "iou", 1e-3);
    bench.done(&run("01-gear", &device, "resumed", six));
    // Another device has another memory of the steps
    let refused = bench.ended(2, &run("01-gear", "cpu", "resumed", &goes_on));
    let text = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(text.contains("resources.device"), "{text}");
    bench.done(&run("01-gear", &device, "resumed", &goes_on));
    let patterns = |name: &str| std::fs::read(bench.path(name).join("patterns.npz")).unwrap();
    assert!(patterns("resumed") == patterns("card"));
}

#[test]
fn tilted_cones_and_waves_print_on_a_card_what_they_print_on_the_processor() {
    for model in [
        ["12-tilted-cone", "exact line integrals (on "],
        ["17-waves", "wave (on "],
    ] {
        let five = "--set stop.iterations=5";
        prints_alike(&Bench::with(&[]), model, five, "iou", 1e-3);
    }
}

#[test]
fn species_scenarios_and_differences_of_pixels_are_optimized_on_a_card() {
    let smooth = "penalties=[{smoothness={angles=0.5},weight=1e-3}]";
    let five = format!("--set stop.iterations=5 --set {smooth}");
    for model in [
        [
            "20-two-colors",
            "2 species by 2 lights, each alone: parallel (on ",
        ],
        ["25-robust", "parallel (on "],
    ] {
        let bench = Bench::with(&[]);
        prints_alike(&bench, model, &five, "iou", 1e-3);
        if bench.path("card").exists() {
            let text = bench.report("card").to_string();
            assert!(!text.contains("runs on the processor"), "{text}");
        }
    }
}

#[test]
fn light_that_scatters_prints_on_a_card_what_it_prints_on_the_processor() {
    let model = ["13-scattering", "successive_orders (parallel (on "];
    // Cells as large as they may be: software takes long for small ones
    let five = "--set stop.iterations=5 --set model.successive_orders.cell_mm=1.9";
    // How far doses in the part are spread: 0.07. Iterations carry on what registers round: with AVX-512 the processor differs by 4e-5, with AVX2 by 6e-8
    prints_alike(&Bench::with(&[]), model, five, "cv", 2e-4);
}

#[test]
fn random_paths_on_a_card_print_what_the_processor_prints_and_resume_to_the_bit() {
    let bench = Bench::with(&[]);
    let Some(device) = card(&bench) else { return };
    // Other paths from the fifth and from the ninth iteration on
    let often = "--set model.monte_carlo.renew=4 --set stop.iterations=";
    let (six, ten) = (format!("{often}6"), format!("{often}10"));
    let job = "15-scattering-cone";
    let paths = "monte_carlo, 4 per pixel and frame, Monte Carlo paths of scattered light and exact line integrals (on ";
    prints_alike(&bench, [job, paths], &ten, "iou", 0.02);
    let [on_card, on_processor] = both(&bench, "cv");
    // From seed to seed it differs by 5 % on either
    let ratio = on_card / on_processor;
    assert!((ratio - 1.0).abs() < 0.1, "{ratio}");
    // Its first paths are those of the sixth iteration again
    bench.done(&run(job, &device, "resumed", &six));
    let goes_on = format!("{ten} --resume");
    bench.done(&run(job, &device, "resumed", &goes_on));
    let patterns = |name: &str| std::fs::read(bench.path(name).join("patterns.npz")).unwrap();
    assert!(patterns("resumed") == patterns("card"));
}
