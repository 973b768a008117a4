//! Jobs with a schedule: minutes and millijoules, what a printer can show, and every method against the print in time.

use crate::{BALL, Finished, LIGHT, job_of, losses};
use serde_json::Value;
use tomolith::job::{Event, Job, Silent, Summary, run};
use tomolith::models::Work;
use tomolith::optimize::OPTIMIZERS;

const TIME: &str = r#"
    stop = { iterations = 4 }
    schedule = { seconds_per_turn = 5.0, turns = 8, duty = 0.5, power = { energy_per_turn_mj_per_mm2 = 0.25 }, snapshots = 2 }
    [[material.photopolymer.networks]]
    name = "resin"
    curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } }
    inhibitors = [{ capacity_mj_per_mm3 = 0.25, diffusion_mm2_per_s = 1e-4 }]
"#;

fn job(changes: &[&str]) -> Job {
    job_of(&[BALL, LIGHT, TIME].concat(), changes).unwrap()
}

/// Summary, report, page and warnings of a run.
fn ran(changes: &[&str]) -> (Summary, Value, String, Vec<String>) {
    let mut warnings = Vec::new();
    let mut hear = |event: &Event| {
        if let Event::Warning { text } = event {
            warnings.push(text.clone());
        }
    };
    let run = Finished::run(job(changes), &mut hear);
    let (report, page) = (run.report(), run.read("report.html"));
    (run.summary, report, page, warnings)
}

#[test]
fn a_schedule_says_how_long_and_how_bright_the_light_is() {
    let (summary, report, page, warnings) =
        ran(&["printer={ peak_irradiance_mw_per_cm2 = 1000.0 }"]);
    let number = |pointer: &str| report.pointer(pointer).and_then(Value::as_f64).unwrap();
    // Eight turns of 5 s, half of them lit: a pattern value of 1 is 0.1 mW/mm² per 0.25 mJ/mm² and 12 frames
    assert!((number("/lights/0/budget/time_s") - 40.0).abs() < 1e-9);
    assert_eq!(number("/lights/0/budget/turns"), 8.0);
    let white = number("/lights/0/full_scale");
    let unit = 0.25 / (5.0 / 12.0 * 0.5);
    let irradiance = number("/lights/0/irradiance/white_mw_per_cm2");
    assert!((irradiance / (100.0 * white * unit) - 1.0).abs() < 1e-6);
    // What the curve ends with is what the light sends in all
    let sent = report
        .pointer("/time/0/curves/sent_mj")
        .and_then(Value::as_array)
        .unwrap();
    let all = number("/lights/0/budget/energy_mj");
    assert!((sent[sent.len() - 1].as_f64().unwrap() / all - 1.0).abs() < 1e-4);
    let (best, at) = (number("/time/0/best_mj"), number("/time/0/best_s"));
    // Frames of a ball are alike: energy goes with the time
    tomolith_core::near!(best / all, at / 40.0, 0.05, "after {at}");
    // The dose alone has no clock of its own beside that of the schedule
    assert!(report.pointer("/exposure/time_s").unwrap().is_null());
    assert!(page.contains("peak_mw_per_cm2") && page.contains("have been sent to the vial"));
    assert!(
        !warnings
            .iter()
            .any(|text| text.contains("the schedule needs"))
    );
    let text = summary.to_string();
    assert!(text.contains("mJ sent to the vial"), "{text}");
    // The job evaluates each frame at one angle
    let row = "written, one angle a frame";
    assert!(text.contains(row) && !text.contains("turning"), "{text}");
}

#[test]
fn a_printer_that_is_too_dark_for_the_schedule_is_named() {
    let (.., page, warnings) = ran(&["printer={ peak_irradiance_mw_per_cm2 = 1.0 }"]);
    let found = warnings
        .iter()
        .find(|text| text.contains("the schedule needs"));
    let text = found.unwrap();
    tomolith_core::contains!(
        text,
        "light[0]",
        "peak_irradiance_mw_per_cm2",
        "schedule.seconds_per_turn"
    );
    assert!(page.contains("the schedule needs"));
}

#[test]
fn every_method_optimizes_a_print_in_time_or_says_why_not() {
    let methods = [
        ("lbfgs", "lbfgs"),
        ("gradient", "gradient"),
        ("adam", "{ adam = { step = 0.05 } }"),
        ("pm", "pm"),
        ("bclp", "{ bclp = { step = 0.005 } }"),
        ("fista", "fista"),
        ("osmo", "osmo"),
        ("cal", "cal"),
    ];
    let is_listed = methods.len() == OPTIMIZERS.len();
    assert!(is_listed, "a new optimizer is tried here, too");
    for (name, method) in methods {
        let method = match method.starts_with('{') {
            true => format!("optimizer={method}"),
            false => format!("optimizer={method:?}"),
        };
        let job = job(&[
            &method,
            "schedule.optimize=\"exact\"",
            "schedule.step_s=4.0",
        ]);
        let folder = tempfile::tempdir().unwrap();
        let run_folder = folder.path().join("run");
        let job = job.with_folder(&run_folder, "--output");
        let done = run(&job, false, &mut Silent, &Work::new());
        if ["fista", "osmo", "cal"].contains(&name) {
            let text = done.unwrap_err().to_string();
            tomolith_core::contains!(text, "a print in time (schedule.optimize)");
            for other in ["lbfgs", "gradient", "adam", "pm", "bclp"] {
                assert!(text.contains(other), "{name}: {text}");
            }
            assert!(!run_folder.exists(), "{name}: refused before any work");
            continue;
        }
        done.unwrap();
        let losses = losses(&run_folder);
        let lowest = losses.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(lowest < 0.8 * losses[0], "{name}: {losses:?}");
    }
}
