//! `calibrate` fits, `expose` and `analyze`: what they find, what they write, and bad input with one message.

use crate::bench::{Bench, JOB, contains};
use serde_json::Value;
use std::fs;

/// A data file of the examples.
fn example(name: &str) -> String {
    format!(
        "{}/../../examples/calibration/{name}",
        env!("CARGO_MANIFEST_DIR")
    )
}

fn near(value: &Value, expected: f64, tolerance: f64) {
    let found = value
        .as_f64()
        .unwrap_or_else(|| panic!("{value} is no number"));
    assert!(
        (found - expected).abs() <= tolerance,
        "{found} is not {expected}"
    );
}

#[test]
fn a_gray_curve_goes_from_the_power_meter_to_the_job() {
    let bench = Bench::new();
    let [uv, visible] = ["gray-uv.csv", "gray-visible.csv"].map(example);
    let found = bench.json(&format!("calibrate gray {uv} --output curve"));
    near(&found["line"]["coefficients"][1], 0.128_668, 5e-7);
    assert_eq!(found["warnings"].as_array().unwrap().len(), 1);
    assert!(bench.read("curve/gray_curve.svg").starts_with("<svg xmlns"));
    assert_eq!(bench.read("curve/gray_curve.csv").lines().count(), 257);
    bench.write(
        "job.toml",
        &format!("{JOB}[printer]\ngray_curve_file = \"curve/gray_curve.csv\"\n"),
    );
    bench.done("check job.toml --quiet");
    bench.says(
        0,
        &format!("calibrate gray {visible}"),
        &["usable from gray 86.1 to 239.1"],
    );
    // A reading that falls is warned of, and no polynomial is refused for it
    bench.write("noisy.csv", "0,0.2\n64,0.1\n128,2\n192,5\n255,10\n");
    let noisy = bench.json("calibrate gray noisy.csv");
    let expected = "falls from 0.2 to 0.1 between gray 0 and 64, by 1 % of white";
    assert!(noisy["warnings"].to_string().contains(expected), "{noisy}");
    bench.done("calibrate gray noisy.csv --form line --quiet");
    bench.write("falls.csv", "0,3\n128,4\n255,1\n");
    bench.write("negative.csv", "0,-0.5\n128,3\n255,4\n");
    // That it does not rise is told before the missing top
    bench.write("low.csv", "10,3\n30,2\n");
    bench.write("short.csv", "0,0\n200,3\n");
    bench.write("below.csv", "-20,-1\n128,3\n255,4\n");
    bench.write("one.csv", "128,3\n128,4\n");
    bench.write("words.csv", "gray,irradiance\n0,zero\n");
    bench.write("huge.csv", "0,0\n100,1e300\n255,1e308\n");
    bench.write("tiny.csv", "0,0\n100,1e-300\n255,1e-290\n");
    bench.refuse_each(&format!(
        "$ calibrate gray {visible} --form quadratic
        gray-visible.csv … usable from gray 86.15 to 239.06 … monotone
        $ calibrate gray falls.csv
        falls from 4 to 1 between gray 128 and 255 … usable from gray 0.00 to 128.00
        $ calibrate gray negative.csv
        a negative irradiance … from gray 128.00 to 255.00
        $ calibrate gray low.csv
        falls from 3 to 2 between gray 10 and 30 … no range of it is usable
        $ calibrate gray below.csv
        gray values from -20 to 255
        $ calibrate gray one.csv
        one.csv: gray value: found 1 different number
        $ calibrate gray short.csv
        --top … gray values from 0 to 200
        $ calibrate gray words.csv
        words.csv … line 2
        $ calibrate gray huge.csv
        huge.csv: irradiance: found 1e300 … 3.4e38
        $ calibrate gray tiny.csv
        tiny.csv: irradiance: found 1e-300 … 1.2e-38
        $ calibrate gray none.csv
        none.csv
        $ calibrate gray {uv} --output curve
        --output … is not empty
        $ calibrate gray {uv} --top 0
        --top"
    ));
    // A black point of 0 has no share to be off by
    bench.write("black.csv", "0,0\n128,4\n255,8.1\n");
    bench.says(0, "calibrate gray black.csv", &["off by up to 0 %, usable"]);
}

#[test]
fn a_response_goes_from_measured_pairs_to_a_table_for_the_job() {
    let bench = Bench::new();
    let stiffness = example("stiffness.csv");
    let found = bench.json(&format!(
        "calibrate response {stiffness} --log-response --output fit"
    ));
    near(&found["midpoint"]["value"], 11.0, 0.05);
    assert!(found["rms"].as_f64().unwrap() <= 0.135, "{found}");
    assert!(found["midpoint"]["error"].as_f64().unwrap() < 0.2);
    assert!(bench.read("fit/response.svg").contains("<circle"));
    // Nothing but the foot of the rise was measured
    bench.write(
        "foot.csv",
        "0,0.11\n1,0.15\n2,0.21\n3,0.3\n4,0.41\n5,0.55\n",
    );
    let found = bench.json("calibrate response foot.csv");
    let warnings = found["warnings"].to_string();
    assert!(warnings.contains("the measured doses cover"), "{found}");
    let loose = bench.json(&format!(
        "calibrate response {stiffness} --log-response --log-dose --asymmetry"
    ));
    let warnings = loose["warnings"].to_string();
    let expected = "do not fix steepness and asymmetry";
    assert!(warnings.contains(expected), "{loose}");
    // The table is taken by a job as it stands
    bench.write(
        "job.toml",
        &format!("{JOB}{}", bench.read("fit/response.toml")),
    );
    bench.done("check job.toml --quiet");
    for options in ["--form table", "--log-dose --log-response"] {
        let found = bench.json(&format!("calibrate response {stiffness} {options}"));
        contains(
            found["job_table"].as_str().unwrap(),
            "",
            &["[response.table]"],
        );
    }
    bench.write("falls.csv", "0 5\n1 4\n2 3\n3 2\n4 1\n5 0\n");
    bench.write("few.csv", "0,0\n1,1\n2,2\n");
    bench.write("three.csv", "0,0,1\n1,1,2\n");
    bench.refuse_each(
        "$ calibrate response falls.csv
        falls.csv … falls with dose
        $ calibrate response falls.csv --log-dose
        0 has no logarithm … --log-dose
        $ calibrate response few.csv
        found 3 doses … at least 5
        $ calibrate response three.csv
        two numbers a line, with decimal points … between them: dose and response
        $ calibrate response few.csv --form table --log-dose
        --form",
    );
}

#[test]
fn kinetics_fit_curing_times_and_say_when_light_never_cures() {
    let bench = Bench::new();
    let balls = example("balls-uv.csv");
    let found = bench.json(&format!("calibrate kinetics {balls} --at 20 --output fit"));
    near(&found["dose_spread"], 0.35, 0.005);
    for residual in found["residuals"].as_array().unwrap() {
        near(residual, 0.0, 0.05);
    }
    near(&found["time_s"], 435.0, 20.0);
    assert!(
        bench
            .read("fit/kinetics.csv")
            .starts_with("irradiance_mw_per_cm2,time_s")
    );
    let warnings = found["warnings"].to_string();
    let expected = [
        "within it, 0 is best",
        "do not fix the inhibitor that flows back: ",
    ];
    contains(&warnings, "", &expected);
    // A rate of 0.01 per s was put in
    bench.write(
        "bent.csv",
        "3.2,987.394\n3.5,848.172\n4,749.506\n5,575.548\n7,396.464\n10,273.4\n14,188.909\n20,137.267\n30,92.4286\n40,70.0598\n",
    );
    let expected = [
        "per s (68 %: 4.05·10⁻⁴ to 0.00143)",
        "do not fix the inhibitor that flows back and the cure and the order of the cure: ",
    ];
    bench.says(0, "calibrate kinetics bent.csv", &expected);
    bench.write("flat.csv", "1,50\n2,50\n4,50\n8,50\n16,50\n");
    let flat = bench.json("calibrate kinetics flat.csv");
    let expected = "do not fix the lowest irradiance and the inhibitor";
    assert!(flat["warnings"].to_string().contains(expected), "{flat}");
    bench.write("three.csv", "1,3\n2,2\n3,1\n");
    bench.write("one.csv", "1,3\n1,2\n");
    bench.refuse_each(&format!(
        "$ calibrate kinetics one.csv
        one.csv: irradiance (mW/cm²): found 1 different number
        $ calibrate kinetics {balls} --at 5
        --at … never cures … % of its inhibitor at most
        $ calibrate kinetics {balls} --at 20~mJ/cm2
        a dose per area … an irradiance is meant
        $ calibrate kinetics three.csv
        found 3 irradiances"
    ));
}

#[test]
fn a_spectrometer_gives_absorption_and_scattering() {
    let bench = Bench::new();
    // 0.12 and 0.31 per mm, with 0.04 of the cuvette: A = 0.04 + μ·L/ln 10
    let row = |path: f64| {
        let absorbance = |per_mm: f64| 0.04 + per_mm * path / std::f64::consts::LN_10;
        format!("{path},{},{}\n", absorbance(0.12), absorbance(0.31))
    };
    let head = "path_mm,resin,with_particles\n";
    let rows: String = [2.0, 5.0, 10.0].map(row).concat();
    bench.write("a.csv", &format!("{head}{rows}"));
    let found = bench.json("calibrate absorbance a.csv --output fit");
    near(&found["absorption"]["per_mm"], 0.12, 1e-9);
    near(&found["scattering"]["per_mm"], 0.19, 1e-9);
    near(&found["resin"]["cuvette"], 0.04, 1e-9);
    contains(
        &bench.read("fit/resin.toml"),
        "",
        &["scattering_per_mm = 0.19"],
    );
    assert!(bench.read("fit/absorbance.svg").starts_with("<svg xmlns"));
    // Particles that absorb a quarter of what they take: 0.12 + 0.25·0.19
    let found = bench.json("calibrate absorbance a.csv --albedo 0.75");
    near(&found["absorption"]["per_mm"], 0.1675, 1e-9);
    near(&found["scattering"]["per_mm"], 0.1425, 1e-9);

    bench.write("clear.csv", "path_mm,resin\n10,0.5\n10,0.52\n");
    let output = bench.expect(0, "calibrate absorbance clear.csv");
    assert!(
        output.contains("0.1174 ± 0.0023 per mm") && !output.contains("scattering"),
        "{output}"
    );
    bench.refuse_each(
        "$ calibrate absorbance clear.csv --albedo 1
        --albedo … with_particles
        $ calibrate absorbance a.csv --albedo 1.2
        --albedo … 1.2",
    );
    for (text, part) in [
        (
            "path_mm,resin,with_particles\n10,0.5,0.4\n",
            "more attenuation with particles",
        ),
        ("path_mm,resin,particles\n10,0.5,0.4\n", "`particles`"),
        ("path_mm,resin\n0,0.5\n", "above 0 mm"),
        ("path_mm,resin\n5,0.5\n10,0.4\n", "rise with the path"),
        ("path_mm,with_particles\n10,0.4\n", "no column `resin`"),
        ("path_mm,resin\n10,\n", "no readings"),
    ] {
        bench.write("bad.csv", text);
        bench.refuse("calibrate absorbance bad.csv", &["bad.csv", part]);
    }
    bench.write("dark.csv", "path_mm,resin\n10,3.4\n");
    // Columns swapped: 44 per mm, and a cuvette that gives light
    bench.write(
        "swapped.csv",
        "path_mm,resin\n0.147231,2\n0.303577,5\n0.564153,10\n",
    );
    for (file, parts) in [
        ("dark.csv", &["stray light"][..]),
        (
            "swapped.csv",
            &[
                "44.2 per mm (resin): ",
                "cuvette that shows −0.825",
                "are swapped",
            ],
        ),
    ] {
        let warnings = bench.json(&format!("calibrate absorbance {file}"))["warnings"].to_string();
        for part in parts {
            assert!(warnings.contains(part), "{warnings}");
        }
    }
    let warnings = &bench.json("calibrate absorbance a.csv")["warnings"];
    assert_eq!(warnings.as_array().unwrap().len(), 0, "{warnings}");
}

#[test]
fn discs_are_drawn_and_their_result_is_read() {
    let bench = Bench::new();
    let line = "calibrate discs --canvas 100 60 --pixel-pitch-mm 0.1 --irradiance 20 --from 10 --to 160 --grid 5 3";
    let found = bench.json(&format!("{line} --output print"));
    assert_eq!(found["discs"].as_array().unwrap().len(), 15);
    near(&found["discs"][14]["seconds"], 8.0, 1e-9);
    assert_eq!(
        fs::read_dir(bench.path("print/frames")).unwrap().count(),
        15
    );
    // Frames last as long as the discs need: in all as long as the last one
    let shown: f64 = bench
        .read("print/schedule.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(2).unwrap().parse::<f64>().unwrap())
        .sum();
    assert!((shown - 8.0).abs() < 1e-4, "{shown}");
    bench.refuse(
        "calibrate dose print/discs.csv",
        &["no results", "cured, depth_mm and diameter_mm"],
    );

    // Filled in: cured from the disc number 6 on (10·16^(6/14) = 32.8 mJ/cm²)
    let fill = |f: &dyn Fn(usize, f64) -> String| -> String {
        let text = bench.read("print/discs.csv");
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for (j, line) in lines.iter_mut().skip(1).enumerate() {
            let dose: f64 = line.split(',').nth(5).unwrap().parse().unwrap();
            *line = line.trim_end_matches(',').to_owned() + &f(j, dose);
        }
        lines.join("\n")
    };
    bench.write(
        "cured.csv",
        &fill(&|j, _| format!(",{},,", u8::from(j >= 6))),
    );
    let fit = bench.json("calibrate dose cured.csv --penetration-mm 2 --output dose");
    near(
        &fit["fit"]["critical_mj_per_cm2"],
        10.0 * 16f64.powf(5.5 / 14.0),
        0.01,
    );
    near(
        &fit["critical_dose_mj_per_mm3"],
        0.1 * 16f64.powf(5.5 / 14.0) / 2.0,
        1e-3,
    );
    contains(
        &bench.read("dose/resin.toml"),
        "",
        &["absorption_per_mm = 0.5"],
    );
    // Disc 4 cured, disc 8 did not
    bench.write(
        "apart.csv",
        &fill(&|j, _| format!(",{},,", u8::from(j >= 6 && j != 8 || j == 4))),
    );
    let found = bench.json("calibrate dose apart.csv");
    let dose = |j: i32| 10.0 * 16f64.powf(f64::from(j) / 14.0);
    near(&found["fit"]["bracket"][0], dose(4), 0.01);
    near(&found["fit"]["bracket"][1], dose(8), 0.01);
    let warnings = found["warnings"].to_string();
    assert!(warnings.contains("contradict each other"), "{found}");
    bench.write(
        "depth.csv",
        &fill(&|_, dose| {
            format!(
                ",,{},",
                if dose > 20.0 {
                    1.5 * (dose / 20.0).ln()
                } else {
                    0.0
                }
            )
        }),
    );
    let fit = bench.json("calibrate dose depth.csv");
    near(&fit["fit"]["critical_mj_per_cm2"], 20.0, 0.01);
    near(&fit["fit"]["length_mm"], 1.5, 0.001);
    // r₀ = 0.32 of the shorter edge of a field, 2 mm
    bench.write(
        "diameter.csv",
        &fill(&|_, dose| {
            format!(
                ",,,{}",
                if dose > 13.0 {
                    2.0 * (0.64 + 0.05 * (dose / 12.0 - 1.0).ln())
                } else {
                    0.0
                }
            )
        }),
    );
    let fit = bench.json("calibrate dose diameter.csv");
    near(&fit["fit"]["critical_mj_per_cm2"], 12.0, 0.05);
    near(&fit["fit"]["length_mm"], 0.05, 0.001);
    // Depths against what cured, and doses and depths that are swapped
    let head = "radius_mm,dose_mj_per_cm2,cured,depth_mm,diameter_mm";
    for (rows, warning) in [
        (
            "0.6,15,1,,\n0.6,40,1,1.0397,\n0.6,80,0,2.0794,\n0.6,160,1,3.1192,\n",
            "that depth_mm gives, at 15, 80 mJ/cm²",
        ),
        (
            "0.6,0.3,,24.4,\n0.6,1,,39,\n0.6,2,,75.9,\n0.6,3,,147.8,\n0.6,4,,287.8,\n",
            "of the penetration depth: look whether dose_mj_per_cm2 and depth_mm are swapped or in other units",
        ),
    ] {
        bench.write("odd.csv", &format!("{head}\n{rows}"));
        let fit = bench.json("calibrate dose odd.csv");
        assert!(fit["warnings"].to_string().contains(warning), "{fit}");
    }
    let unused = format!("calibrate dose {} --penetration-mm 5", example("discs.csv"));
    let unused = &bench.json(&unused)["warnings"];
    contains(&unused.to_string(), "", &["--penetration-mm 5 is not used"]);
    let fit = bench.json(&format!("calibrate dose {}", example("discs.csv")));
    assert_eq!(fit["warnings"].as_array().unwrap().len(), 0, "{fit}");
    near(&fit["fit"]["critical_mj_per_cm2"], 38.0, 2.0);
    near(&fit["fit"]["length_mm"], 2.4, 0.1);

    bench.write("all.csv", &fill(&|_, _| ",1,,".to_owned()));
    bench.write("none.csv", &fill(&|_, _| ",0,,".to_owned()));
    bench.write("both.csv", &fill(&|_, _| ",1,2,".to_owned()));
    let bare = "calibrate discs --pixel-pitch-mm 0.1 --irradiance 20 --from 10 --to 160";
    bench.refuse_each(&format!(
        "$ calibrate dose all.csv
        every disc cured … below 10 mJ/cm²
        $ calibrate dose none.csv
        no disc cured … above 160 mJ/cm²
        $ calibrate dose both.csv
        depth_mm: sizes that fall with the dose or stay the same
        $ calibrate dose cured.csv --penetration-mm 0
        --penetration-mm
        $ {line} --output print
        is not empty
        $ {bare} --output other
        --canvas"
    ));
    for (change, parts) in [
        ("--to 5", ["--from", "doses from 10 to 5"]),
        (
            "--from 10~mJ/cm3",
            ["a dose per volume", "a dose per area is meant"],
        ),
        ("--irradiance 0", ["--irradiance", "above 0"]),
        ("--grid 1 1", ["--grid", "4 to 100"]),
        ("--canvas 20 20", ["--canvas", "8 pixels or more"]),
        ("--pixel-pitch-mm -1", ["--pixel-pitch-mm", "found -1"]),
    ] {
        let key = change.split(' ').next().unwrap();
        let words: Vec<&str> = line.split(' ').collect();
        let at = words.iter().position(|word| *word == key).unwrap();
        let length = change.split(' ').count();
        let changed = [
            &words[..at],
            &change.split(' ').collect::<Vec<_>>(),
            &words[at + length..],
        ]
        .concat();
        bench.refuse(&format!("{} --output other", changed.join(" ")), &parts);
    }
    assert!(!bench.path("other").exists());
}

#[test]
fn a_run_is_planned_for_a_machine_and_a_resin() {
    let bench = Bench::new();
    bench.write("job.toml", JOB);
    bench.done("run job.toml --quiet --output a");
    // The budget of the run itself, with the same numbers
    bench.done("run job.toml --quiet --output b --set resin.critical_dose_mj_per_mm3=0.8 --set printer.peak_irradiance_mw_per_cm2=25");
    let report = bench.report("b");
    let budget = &report["lights"][0]["budget"];
    let b = &bench.json("expose b")["plan"];
    let a = &bench.json("expose a --irradiance 25 --critical-dose 0.8")["plan"];
    bench.write("other.toml", "pixel_pitch_mm = 0.5");
    let other = "expose a --printer other.toml --irradiance 25 --critical-dose 0.8";
    bench.refuse(
        other,
        &["--printer: pixels of 0.5 × 0.5 mm, and the frames of this run have pixels of"],
    );
    let time = budget["time_s"].as_f64().unwrap();
    for plan in [a, b] {
        near(&plan["continuous_s"], time, 2e-3 * time);
        near(
            &plan["energy_mj"],
            budget["energy_mj"].as_f64().unwrap(),
            3e-3 * time,
        );
        let turns = plan["turns"].as_f64().unwrap();
        assert_eq!(turns, (time / 6.0).ceil());
        near(&plan["time_s"], 6.0 * turns, 1e-9);
        near(&plan["duty"], time / (6.0 * turns), 2e-3);
        near(&plan["frame_rate_hz"], 4.0, 1e-9);
        near(
            &plan["window_s"]["low"],
            plan["time_s"].as_f64().unwrap() * plan["window_percent"]["low"].as_f64().unwrap()
                / 100.0,
            1e-6,
        );
    }
    // Units, power over the whole canvas (3.2 mm × 1.6 mm), and turns in place of a speed
    let units = &bench.json("expose a --irradiance 250~W/m² --critical-dose 0.8~J/cm3")["plan"];
    near(&units["time_s"], a["time_s"].as_f64().unwrap(), 1e-9);
    let power = "--power 1.28~mW --critical-dose 0.8";
    bench.refuse(
        &format!("expose a {power}"),
        &["--power: ", "printer.canvas"],
    );
    bench.done("run job.toml --quiet --output c --set printer.canvas=[32,16]");
    let power = &bench.json(&format!("expose c {power}"))["plan"];
    near(&power["continuous_s"], time, 2e-3 * time);
    let turns = &bench.json("expose a --irradiance 25 --critical-dose 0.8 --turns 3")["plan"];
    near(&turns["duty"], 1.0, 1e-9);
    near(&turns["rpm"], 180.0 / time, 2e-3 * 180.0 / time);
    let found = bench.json("expose b");
    let evaluation = &report["evaluation"];
    let pw = evaluation["pw"].as_f64().unwrap() / evaluation["gel_threshold"].as_f64().unwrap();
    near(&found["pw_percent"], 100.0 * pw, 1e-3);
    // No time prints all of the part and nothing else
    assert!(pw < 0.0 && found["pw_s"].is_null(), "{found}");
    bench.says(0, "expose b", &["nearly as good", "delivered light"]);
    // 24 frames a turn: 0.25 turns a minute are 0.1 frames a second
    let slow = "expose a --irradiance 25 --critical-dose 0.8 --rpm";
    for (rpm, is_slow) in [("0.24", true), ("0.25", false)] {
        let warnings = bench.json(&format!("{slow} {rpm}"))["warnings"].to_string();
        let part = "which players do not show evenly and `tomolith export` refuses: 0.25 turns";
        assert_eq!(warnings.contains(part), is_slow, "{warnings}");
    }

    bench.refuse_each(
        "$ expose a
        --irradiance … how bright the machine is
        $ expose a --irradiance 25
        --critical-dose … at which dose the resin gels
        $ expose a --irradiance 25 --critical-dose 80~mJ/cm2
        a dose per area, and a dose per volume is meant … penetration depth
        $ expose a --irradiance 25~mW --critical-dose 1
        a power, and an irradiance is meant
        $ expose a --irradiance 25~lux --critical-dose 1
        unknown unit `lux`
        $ expose a --irradiance -5 --critical-dose 1
        --irradiance … `-5`
        $ expose b --within-s 1
        1 s hold 0 whole turns … % of the dose at which the resin gels … whole turns … mW/cm² in a faster vial
        $ expose b --rpm 1000
        --rpm … 400 frames a second … the device shows 60
        $ expose b --rpm 0
        --rpm
        $ expose b --rpm 1e-300
        time to print … s in 1 turns … at most 10000000 s
        $ expose b --critical-dose 1e300
        time to print … at most 10000000 s
        $ expose b --light blue
        unknown light `blue`
        $ expose job.toml
        is a file, and no folder",
    );
    // The irradiance that is advised is enough
    let plan = &bench.json("expose a --irradiance 25 --critical-dose 0.8")["plan"];
    let (time, pass) = (
        plan["time_s"].as_f64().unwrap(),
        60.0 / plan["rpm"].as_f64().unwrap(),
    );
    let within = format!("--critical-dose 0.8 --within-s {}", time - 0.5 * pass);
    let message = bench.expect(2, &format!("expose a --irradiance 25 {within}"));
    let advised = message.split("irradiance from ").nth(1).unwrap();
    let advised = advised.split_whitespace().next().unwrap();
    bench.done(&format!("expose a --irradiance {advised} {within}"));
    fs::remove_dir_all(bench.path("a/frames")).unwrap();
    bench.refuse("expose a --irradiance 25 --critical-dose 1", &["frames"]);
}

#[test]
fn designs_are_analyzed() {
    let bench = Bench::new();
    let voxel = "analyze voxel --pixels 1024 --fps 60 --penetration-mm 12";
    let found = bench.json(&format!("{voxel} --dose-time-s 4 --output voxel"));
    let crossing = 12.0 * (std::f64::consts::PI * 1024.0 / 480.0).ln();
    near(&found["crossing_mm"], crossing, 1e-6);
    assert!(bench.read("voxel/voxel.svg").contains("R*"));
    // The same from a dose and a light: 0.8 mJ/mm³ over 0.25 mW/mm² in 12 mm are 38.4 s
    let other = bench.json(&format!("{voxel} --critical-dose 0.8 --irradiance 25"));
    near(
        &other["at_radius"]["curing_s"],
        38.4 * (8.0f64 / 12.0).exp(),
        1e-6,
    );
    bench.says(
        0,
        &format!("{voxel} --dose-time-s 4 --turn-deg-per-s 2"),
        &["not every angle is shown"],
    );
    // 3° a frame at 8 mm are 419 µm, a pixel is 16
    let fast = "analyze voxel --pixels 1000 --fps 60 --penetration-mm 10 --dose-time-s 100 --turn-deg-per-s 180";
    bench.says(0, fast, &["none: the angle step decides at every radius"]);

    let line = "analyze buildup --radius-mm 8 --penetration-mm 0.8";
    let found = bench.json(&format!(
        "{line} --dose-time-s 10 --seconds 50 --output buildup"
    ));
    near(&found["points"][2]["dose_s"], 18.575, 5e-4);
    near(&found["points"][2]["mean_rate"], 0.51596, 5e-6);
    near(&found["wall_over_axis"], 11_365.0, 1.0);
    assert_eq!(
        bench.read("buildup/buildup.csv").lines().next(),
        Some("time_s,dose_s_at_0,dose_s_at_0.5,dose_s_at_1")
    );
    // At rest r/R = ½ keeps e^(−κ/2) of the light, κ = 10
    let rest = bench.json(&format!("{line} --turn-deg-per-s 0 --seconds 50"));
    near(&rest["points"][1]["mean_rate"], (-5.0f64).exp(), 1e-9);
    near(&rest["points"][1]["dose_s"], 50.0 * (-5.0f64).exp(), 1e-7);
    assert!(rest["wall_over_axis"].is_null());

    let found = bench
        .json("analyze impulse --pixels 64 --width 5 --radius 0 --step-deg 3 --output impulse");
    let row = &found["fwhm"][0];
    near(&row[3], 6.4, 0.2);
    near(&row[5], 5.0, 0.6);
    assert!(bench.path("impulse/profile_0.svg").is_file());
    bench.refuse_each(&format!(
        "$ analyze impulse --width 0
        --width
        $ analyze impulse --radius 1.2
        --radius … whole post
        $ analyze impulse --pixels 4
        --pixels
        $ analyze impulse --pixels 16 --width 0.5 --radius 0.99
        --radius … no voxel of the disc holds a part of the post
        $ {voxel} --dose-time-s 0
        --dose-time-s
        $ {voxel} --critical-dose 1~mJ/cm2 --irradiance 2
        a dose per area
        $ {line} --at 1.5
        --at … found 1.5
        $ {line} --turn-deg-per-s -1
        --turn-deg-per-s
        $ {line} --dose-time-s 1e300
        --dose-time-s … at most 10000000 s
        $ {voxel} --dose-time-s 1e300
        --dose-time-s … at most 10000000 s"
    ));
}
