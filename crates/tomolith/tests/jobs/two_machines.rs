//! Two lights with a gray curve, a brightness and an exposure time of their own.

use crate::{BALL, Finished, job_of};
use serde_json::Value;
use tomolith::Error;
use tomolith::io::channel::Channel;
use tomolith::job::{Job, ResolvedJob, Silent};

const MACHINES: &str = r#"
    light = [
        { name = "violet", pixels = [20, 16], angles = 12, turns = 9, projector = { collimated = { pixel_pitch_mm = 0.1 } }, printer = { peak_irradiance_mw_per_cm2 = 46.2, gray_curve = [[0.0, 0.0], [0.5, 0.3], [1.0, 1.0]] } },
        { name = "uv", pixels = [20, 16], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.1 } } },
    ]
    stop = { iterations = 2 }
    printer = { peak_irradiance_mw_per_cm2 = 325.3 }
    schedule = { seconds_per_turn = 5.0, turns = 12, power = { irradiance_mw_per_mm2 = 0.1 }, snapshots = 1 }
"#;

fn job(changes: &[&str]) -> Result<Job, Error> {
    job_of(&[BALL, MACHINES].concat(), changes)
}

fn report(changes: &[&str]) -> Value {
    Finished::run(job(changes).unwrap(), &mut Silent).report()
}

#[test]
fn each_light_has_its_own_brightness_and_its_own_turns() {
    let report = report(&[]);
    let number_of = |light: usize, what: &str| {
        report["lights"][light]
            .pointer(what)
            .and_then(Value::as_f64)
            .unwrap()
    };
    let peaks = [0, 1].map(|light| number_of(light, "/irradiance/peak_mw_per_cm2"));
    assert_eq!(peaks, [46.2, 325.3]);
    assert_eq!(
        [0, 1].map(|light| number_of(light, "/budget/turns")),
        [9.0, 12.0]
    );
    // The print ends with the light that is shown longer; a white pixel gets 0.1 mW/mm² for 1/12 of each turn of 5 s
    for (light, turns) in [(0, 9.0), (1, 12.0)] {
        assert!((number_of(light, "/budget/time_s") - 5.0 * turns).abs() < 1e-9);
        let white = number_of(light, "/full_scale") * 0.1 * turns * 5.0 / 12.0;
        assert!((number_of(light, "/budget/white_mj_per_mm2") / white - 1.0).abs() < 1e-6);
    }
}

#[test]
fn a_gray_curve_belongs_to_its_light() {
    let spec = job(&[]).unwrap().spec;
    let curves = [0, 1].map(|light| spec.printer_of(light).unwrap().gray_curve);
    assert!(
        curves[0]
            .as_ref()
            .is_some_and(|curve| curve[1] == [0.5, 0.3])
    );
    assert_eq!(curves[1], None);
}

#[test]
fn each_light_may_have_its_own_channel() {
    let channels = |changes: &[&str]| {
        let spec = job(changes).unwrap().spec;
        [0, 1].map(|light| spec.printer_of(light).unwrap().channel)
    };
    assert_eq!(channels(&[]), [None, None]);
    let blue = "printer.channel=blue";
    assert_eq!(channels(&[blue]), [Some(Channel::Blue); 2]);
    let red = "light[1].printer.channel=red";
    assert_eq!(
        channels(&[blue, red]),
        [Some(Channel::Blue), Some(Channel::Red)]
    );
    assert_eq!(channels(&[red]), [None, Some(Channel::Red)]);
}

#[test]
fn what_a_light_says_wrongly_of_its_machine_is_named_as_its_own() {
    let falls = "light[0].printer.gray_curve=[[0.0, 0.0], [0.5, 0.7], [1.0, 0.6]]";
    for (changes, key) in [
        (&[falls][..], "light[0].printer.gray_curve"),
        (
            &["light[0].printer.peak_irradiance_mw_per_cm2=-1"],
            "light[0].printer.peak_irradiance_mw_per_cm2",
        ),
        (&["light[0].turns=0"], "light[0].turns"),
    ] {
        let found = job(changes).and_then(|job| ResolvedJob::new(&job).map(drop));
        match found.unwrap_err() {
            Error::Config { key: found, .. } => assert!(found.starts_with(key), "{found}"),
            other => panic!("{other}"),
        }
    }
}
