//! A print that takes longer than `printer.time_s` allows.

use crate::{BALL, Finished, LIGHT, job_of};
use serde_json::Value;
use tomolith::job::Silent;

const PRINTER: &str = r#"
    stop = { iterations = 2 }
    printer = { peak_irradiance_mw_per_cm2 = 10.0, time_s = 40.0 }
"#;

/// The report of the job with a change.
fn report(change: &str) -> Value {
    report_of(&[change])
}

fn report_of(changes: &[&str]) -> Value {
    let job = job_of(&[BALL, LIGHT, PRINTER].concat(), changes);
    Finished::run(job.unwrap(), &mut Silent).report()
}

#[test]
fn a_print_that_takes_longer_than_allowed_is_warned_of() {
    let text = "the print takes";
    // The resin gels at the threshold that the bound was made for
    let fits = report("evaluate.threshold=0.8");
    let seconds = |report: &Value| {
        let time = report.pointer("/lights/0/budget/time_s").unwrap();
        time.as_f64().unwrap()
    };
    assert!(seconds(&fits) <= 40.0 * 1.005, "{}", seconds(&fits));
    assert!(!fits.to_string().contains(text));
    // Wide apart: their middle lies far above the dose at which this print is best
    let late = report("objective={ threshold = { lower = 0.2, upper = 2.5, ceiling = 3.0 } }");
    assert!(seconds(&late) > 41.0, "{}", seconds(&late));
    let warnings = late.to_string();
    tomolith_core::contains!(warnings, "s where printer.time_s allows 40 s");
    // One half of the device gives 60 % of the other: what the bound allows there takes as much longer
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("flat.npy");
    let flat = ndarray::Array2::from_shape_fn((16, 20), |(_, u)| if u < 10 { 1.0 } else { 0.6 });
    ndarray_npy::write_npy(&file, &flat).unwrap();
    let machine = format!("printer.flat_field={:?}", file.display().to_string());
    let dimmed = report_of(&["evaluate.threshold=0.8", &machine]);
    tomolith_core::near!(seconds(&dimmed), 40.0 / 0.6, 0.5);
    let dimmed = dimmed.to_string();
    tomolith_core::contains!(
        dimmed,
        "printer.flat_field dims pixels to 60 %",
        "set printer.time_s = 24"
    );
    // All that the machine has is too little: no shorter time helps, and no bound that the job does not name
    let dark = report("printer.time_s=2");
    // A fifth more than even light takes
    let enough = format!("Set printer.time_s = {:.1}, or", 1.2 * seconds(&dark));
    let dark = dark.to_string();
    tomolith_core::contains!(
        dark,
        "though nearly all pixels that shine are as bright as they may be. Light that even",
        &enough,
        "as bright as printer.time_s = 2 lets",
        "raise `printer.time_s`"
    );
    assert!(!dark.contains("bounds.max ="), "{dark}");
}

#[test]
fn a_print_of_few_turns_is_warned_of() {
    let text = "turns of the vial: it ends within a turn";
    let at = |rpm: &str| report_of(&["evaluate.threshold=0.8", rpm]).to_string();
    // A little less than 40 s: 180 s at one turn a minute are three turns
    let warned = at("output.rpm=1");
    tomolith_core::contains!(warned, text, " for three whole turns");
    let (_, rpm) = warned.split_once("Set output.rpm = ").unwrap();
    let (rpm, _) = rpm.split_once(' ').unwrap();
    assert!((4.5..5.0).contains(&rpm.parse::<f64>().unwrap()), "{rpm}");
    assert!(!at(&format!("output.rpm={rpm}")).contains(text));
}

#[test]
fn a_print_of_hours_is_warned_of() {
    let at = |power: &str| {
        let power = format!("printer.peak_irradiance_mw_per_cm2={power}");
        report_of(&["printer.time_s=1e6", &power]).to_string()
    };
    let text = " h, and resin keeps still for minutes";
    assert!(at("0.001").contains(text) && !at("10").contains(text));
}

#[test]
fn lights_that_follow_each_other_share_the_time() {
    let light = |name: &str, peak: f64| {
        format!(
            "{{ name = \"{name}\", pixels = [24, 20], angles = 24, projector = {{ collimated = {{ pixel_pitch_mm = 0.1 }} }}, printer = {{ peak_irradiance_mw_per_cm2 = {peak} }} }}"
        )
    };
    let bound = |lights: &[String]| {
        let lights = format!("light=[{}]", lights.join(", "));
        let changes = [
            lights.as_str(),
            "printer={ time_s = 40.0 }",
            "evaluate.threshold=0.8",
        ];
        let job = job_of(&[BALL, PRINTER].concat(), &changes).unwrap();
        let plan = tomolith::job::check(&job, &mut Silent, &tomolith::work::Work::new()).unwrap();
        let mut notes = plan.notes.iter();
        let note = notes.find_map(|note| note.split_once("the brightest pixel gives "));
        let (value, _) = note.unwrap().1.split_once(':').unwrap();
        value.parse::<f64>().unwrap()
    };
    let [bright, dim] = [light("a", 20.0), light("b", 10.0)];
    let alone = [&bright, &dim].map(|light| bound(std::slice::from_ref(light)));
    // The time of a pixel is its value over the irradiance, light after light
    let together = bound(&[bright, dim]);
    let expected = 1.0 / (1.0 / alone[0] + 1.0 / alone[1]);
    assert!(
        (together / expected - 1.0).abs() < 1e-3,
        "{together} {alone:?}"
    );
}
