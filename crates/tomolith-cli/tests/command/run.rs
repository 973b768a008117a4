//! Whole runs of the command, on a job that takes a moment.

use crate::bench::{Bench, contains};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader};
use std::iter;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

const JOB: &str = concat!(
    include_str!("gear.toml"),
    r#"[objective.threshold]

[stop]
iterations = 6
"#
);

fn bench() -> Bench {
    Bench::with(&[("job.toml", JOB)])
}

/// Files of a run folder that say when and how fast it was made.
const DATED: [&str; 4] = ["history.csv", "report.json", "report.html", "job.toml"];

/// Content of every file of a run folder that must not depend on when and how it was made.
fn bits(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for path in fs::read_dir(next).unwrap().map(|e| e.unwrap().path()) {
            let name = path.strip_prefix(folder).unwrap().display().to_string();
            if name.starts_with('.') || name == "checkpoint" || DATED.contains(&name.as_str()) {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else {
                files.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    files
}

/// The same files, and no others, with the same bits; the message names those that differ, without their content.
fn assert_same_bits(folder: &Path, expected: &BTreeMap<String, Vec<u8>>, when: &str) {
    let found = bits(folder);
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&found), names(expected), "{when}");
    let differ: Vec<_> = found
        .iter()
        .filter(|(name, content)| expected[*name] != **content)
        .map(|(name, _)| name)
        .collect();
    assert!(differ.is_empty(), "{when}: {differ:?} differ");
}

#[test]
fn a_run_leaves_everything_and_simulate_reproduces_its_numbers() {
    let bench = bench();
    let output = bench.stdout(0, "run job.toml");
    assert!(output.contains("written, turning"), "{output}");
    let run = bench.path("out/job");
    for name in ["job.toml", "history.csv", "report.json", "report.html"] {
        assert!(run.join(name).metadata().unwrap().len() > 100, "{name}");
    }
    assert!(!run.join(".new").exists() && !run.join(".lock").exists());
    let report = bench.report("out/job");
    assert!(report["optimization"]["iou"].as_f64().unwrap() > 0.9);
    assert!(report["evaluation"]["iou"].as_f64().unwrap() > 0.8);
    assert_eq!(report["evaluation"]["sub_angles"], 4);
    // The optimization counted the turning
    let has_turning = |report: &Value| {
        let mut limits = report["limits"].as_array().unwrap().iter();
        limits.any(|limit| limit["cause"] == "turning")
    };
    assert!(!has_turning(&report));

    // Relative doses are no energies, and say so
    assert_eq!(report["published"]["light_sent"]["unit"], "dose × mm³");
    assert!(report["published"]["unit_systems"].is_null());
    // Published numbers are found by keys that stay, whatever their definitions say
    let keys = report["published"].as_object().unwrap();
    let is_key = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    assert!(
        keys.keys().all(|key| key.chars().all(is_key)),
        "{:?}",
        keys.keys()
    );
    for key in ["bclp_l0_part_eps0", "pw_trimmed", "jaccard"] {
        assert!(keys[key]["note"].is_string(), "{key}");
    }
    // Which model it was can be read, and the job is still a job
    let models = &report["run"]["models"];
    assert!(
        models["optimization"]
            .as_str()
            .unwrap()
            .starts_with("parallel")
    );
    let job = fs::read_to_string(run.join("job.toml")).unwrap();
    for stage in ["optimization", "evaluation"] {
        let line = format!("# Model of the {stage}: parallel (");
        assert!(job.contains(&line), "{line} is not in\n{job}");
    }
    says_how_to_expose_and_what_limits(&report, &output);
    let ply = fs::read(run.join("print.ply")).unwrap();
    assert!(ply.windows(12).any(|w| w == b"deviation_um"));
    let place = &report["evaluation"]["farthest"];
    assert!(place["at_xyz_mm"][2].is_f64() && place["side"].is_string());

    let output = bench.stdout(
        0,
        "simulate job.toml --patterns out/job/patterns.npz --output again",
    );
    assert!(
        output.contains("unwritten, on the job's grid") && !output.contains("optimiz"),
        "{output}"
    );
    // A run folder stands for its patterns.npz
    bench.done("simulate job.toml --patterns out/job --output folder");
    assert_eq!(bench.report("folder")["evaluation"], report["evaluation"]);
    let again = bench.report("again");
    for section in ["evaluation", "optimization", "lights", "movies"] {
        assert_eq!(again[section], report[section], "{section}");
    }
    let written = bits(&run);
    assert!(
        written.contains_key("gear_10rpm.mp4") && written.len() == 30 + 7,
        "{:?}",
        written.keys()
    );
    assert_same_bits(&bench.path("again"), &written, "simulated");
    // One that did not may lose by it
    bench.done("simulate job.toml --patterns out/job --set light.sub_angles=1 --output still");
    assert!(has_turning(&bench.report("still")));

    // The resolved job runs identically, from another folder, and only there
    fs::create_dir(bench.path("elsewhere")).unwrap();
    fs::copy(run.join("job.toml"), bench.path("elsewhere/resolved.toml")).unwrap();
    bench.done("run elsewhere/resolved.toml --output resolved --threads 1");
    assert_same_bits(&bench.path("resolved"), &written, "the resolved job");
}

/// The best exposure and the limits of a print, in its report and on the screen.
fn says_how_to_expose_and_what_limits(report: &Value, output: &str) {
    let exposure = &report["exposure"];
    let number = |quantity: &str, end: &str| exposure[quantity][end].as_f64().unwrap();
    assert_eq!(exposure["measure"], "iou");
    assert_eq!(exposure["best"], report["evaluation"]["iou"]);
    assert_eq!(number("dose", "best"), number("threshold", "best"));
    for quantity in ["dose", "threshold", "percent"] {
        assert!(
            number(quantity, "low") < number(quantity, "best")
                && number(quantity, "best") < number(quantity, "high")
        );
    }
    let product = number("percent", "low") * number("dose", "high");
    assert!((product - 100.0 * number("dose", "best")).abs() < 1e-6);
    assert!(exposure["time_s"].is_null());
    // The curve of the report stays within 0.01 of its best between the ends
    for point in report["evaluation"]["iou_curve"].as_array().unwrap() {
        let [threshold, iou] = [0, 1].map(|i| point[i].as_f64().unwrap());
        if number("threshold", "low") <= threshold && threshold < number("threshold", "high") {
            assert!(
                iou >= exposure["best"].as_f64().unwrap() - 0.01 - 1e-9,
                "{point}"
            );
        }
    }
    let limits = report["limits"].as_array().unwrap();
    let losses: Vec<f64> = limits
        .iter()
        .map(|limit| limit["loss_in_iou"].as_f64().unwrap())
        .collect();
    assert!(
        losses.windows(2).all(|pair| pair[0] >= pair[1]),
        "{losses:?}"
    );
    let missing = 1.0 - report["evaluation"]["iou"].as_f64().unwrap();
    assert!((losses.iter().sum::<f64>() - missing).abs() < 1e-9);
    let key = limits[0]["key"].as_str().unwrap();
    let gels = "At the best exposure resin gels at a dose of ";
    contains(output, "", &["Predicted IoU ", &format!("`{key}`"), gels]);
    assert!(
        !report["warnings"].to_string().contains("Predicted IoU"),
        "said twice"
    );
}

#[test]
fn a_method_that_descends_no_loss_ends_with_its_best_print_and_says_so() {
    let bench = bench();
    // Steps too long for a low threshold: the loss falls from step 2 to 3, the print is best after the first
    let set = "--set optimizer.cal.learning_rate=0.5 --set optimizer.cal.momentum=0.5 --set optimizer.cal.d_h=0.4";
    let line = "iteration 1 of 6 (best IoU on the job's voxels)";
    let output = bench.stdout(0, &format!("run job.toml {set} --output best"));
    assert!(output.contains(line), "{output}");
    let report = bench.report("best");
    let iterate_of = |report: &Value| report["history"]["kept"].clone();
    let expected = serde_json::json!({ "iteration": 1, "by": "print" });
    assert_eq!(iterate_of(&report), expected);
    assert!(report["optimization"]["iou"].as_f64().unwrap() > 0.88);
    let page = bench.read("best/report.html");
    assert!(page.contains("iteration 1 of 6"));

    let output = bench.stdout(
        0,
        &format!("run job.toml {set} --set stop.keep=last --output last"),
    );
    assert!(!output.contains("kept"), "{output}");
    let report = bench.report("last");
    assert_eq!(iterate_of(&report)["iteration"], 6);
    assert!(report["optimization"]["iou"].as_f64().unwrap() < 0.8);
}

#[test]
fn few_bits_are_improved_on_their_levels_and_simulated_to_the_same_bits() {
    let bench = bench();
    let whole = "--set objective.threshold.surface=voxel";
    let run = |folder: &str, more: &str| {
        let output = bench.stdout(
            0,
            &format!(
                "run job.toml --json --set evaluate.bit_depth=1 {whole} {more} --output {folder}"
            ),
        );
        (output, bench.report(folder))
    };
    let (output, report) = run("few", "--set evaluate.levels=optimized");
    assert!(output.contains("bit depth 1: loss"), "{output}");
    let (_, rounded) = run("rounded", "--set evaluate.levels=rounded");
    assert!(rounded["levels"].is_null());
    let number = |v: &Value| v.as_f64().unwrap();
    let gain = &report["levels"];
    assert!(number(&gain["loss"]) < number(&gain["rounded_loss"]));
    assert!(number(&gain["loss"]) <= number(&gain["diffused_loss"]));
    contains(&output, "", &["by error diffusion over neighboring frames"]);
    assert!(number(&gain["calls"]) <= 78.0);
    assert_ne!(report["evaluation"], rounded["evaluation"]);
    // What the optimization reached is told apart from what is shown of it
    assert_eq!(report["optimization"], rounded["optimization"]);
    // The default is to improve, and more bits are rounded
    assert_eq!(run("default", "").1["levels"], *gain);
    bench.done("run job.toml --set evaluate.bit_depth=6 --output many");
    assert!(bench.report("many")["levels"].is_null());

    let simulate = |folder: &str, machine: &str| {
        let line = format!("simulate job.toml --set evaluate.bit_depth=1 {whole} {machine}");
        bench.done(&format!("{line} --patterns {folder} --output again"));
        let again = bench.report("again");
        let report = bench.report(folder);
        for section in ["evaluation", "lights"] {
            assert_eq!(again[section], report[section], "{folder}: {section}");
        }
    };
    simulate("few", "");
    // A machine with pixels of its own makes the same light of what it was asked for
    let machine = "--set printer.canvas=[60,30] --set printer.pixel_pitch_mm=0.08";
    let (output, report) = run("machine", machine);
    assert!(output.contains("bit depth 1: loss"), "{output}");
    let gain = &report["levels"];
    assert!(number(&gain["loss"]) < number(&gain["rounded_loss"]));
    simulate("machine", machine);
    // Of many bits where its pixels lie across those of the light
    let turned =
        "--set evaluate.bit_depth=8 --set printer.canvas=[60,30] --set printer.rotation_deg=3";
    let (output, report) = run("turned", turned);
    contains(&output, "", &["loss of what the machine's pixels show: "]);
    let gain = &report["levels"];
    assert!(number(&gain["loss"]) < 0.7 * number(&gain["rounded_loss"]));
    assert!(gain["diffused_loss"].is_null() && number(&gain["calls"]) <= 64.0);
    let even = "--set evaluate.bit_depth=8 --set printer.canvas=[60,30]";
    assert!(run("even", even).1["levels"].is_null());
    // Voxels wider than the machine's pixels see a gain where the print has none
    let job = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../examples/22-calibrate-resin.toml"
    );
    let coarse = "--toy --json --set printer.pixel_pitch_mm=0.084 --output coarse";
    let output = bench.stdout(0, &format!("run {job} {coarse}"));
    contains(
        &output,
        "",
        &["on finer voxels the print is worse, so the patterns stay as they were"],
    );
    assert!(bench.report("coarse")["levels"].is_null());
}

#[test]
fn doses_are_energies_where_the_resin_says_what_it_needs() {
    let bench = bench();
    let line = "run job.toml --quiet --set resin.critical_dose_mj_per_mm3=2";
    bench.done(&format!("{line} --output plain"));
    let machine = "--set printer.canvas=[48,24] --set printer.peak_irradiance_mw_per_cm2=100";
    bench.done(&format!("{line} {machine} --output machine"));
    for (folder, systems) in [("plain", 2), ("machine", 4)] {
        let report = bench.report(folder);
        let rows = report["published"]["unit_systems"].as_array().unwrap();
        assert_eq!(rows.len(), systems, "{folder}");
        // 2 mJ/mm³ are 2 J/cm³; the brightest pixel is the printer's white, in J/cm²
        assert_eq!(rows[0]["dose"], serde_json::json!([2.0, "J/cm³"]));
        let white = report["lights"][0]["budget"]["white_mj_per_mm2"]
            .as_f64()
            .unwrap();
        let brightest = rows[0]["pattern"][0].as_f64().unwrap();
        assert!(
            (10.0 * brightest / white - 1.0).abs() < 1e-5,
            "{brightest} {white}"
        );
    }
}

#[test]
fn a_job_in_json_is_the_same_job() {
    let bench = bench();
    let table: Value = toml::from_str(JOB).unwrap();
    bench.write("j.json", &table.to_string());
    bench.done("run job.toml --output a --quiet");
    bench.done("run j.json --output b --quiet");
    assert_same_bits(&bench.path("a"), &bits(&bench.path("b")), "JSON");
    // Overrides are the same as changes of the text
    bench.write("c.toml", &JOB.replace("iterations = 6", "iterations = 3"));
    bench.done("run c.toml --output c --quiet");
    bench.done("run job.toml --output d --quiet --set stop.iterations=3");
    assert_same_bits(&bench.path("c"), &bits(&bench.path("d")), "overrides");
    assert!(bits(&bench.path("c")) != bits(&bench.path("a")));
}

#[test]
fn a_quality_that_is_not_met_ends_with_one() {
    let bench = bench();
    let line = "run job.toml --set evaluate.require_iou=1.0";
    bench.says(1, line, &["NOT met"]);
    assert!(bench.path("out/job/report.html").exists());
    bench.done("run job.toml --overwrite --set evaluate.require_iou=0.5");
}

#[test]
#[ignore = "slow"]
fn every_species_must_have_the_quality_that_is_asked() {
    let bench = bench();
    let job = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../examples/20-two-colors.toml"
    );
    let mut line =
        format!("run {job} --output two --set grid.pitch_mm=0.15 --set stop.iterations=2");
    for light in ["light[0]", "light[1]"] {
        line += &format!(" --set {light}.angles=30 --set {light}.pixels=[42,6]");
        line += &format!(" --set {light}.projector.collimated.pixel_pitch_mm=0.15");
    }
    // The first species, acrylate, has an IoU above 0.98 here, the second one not
    let high = format!("{line} --set evaluate.require_iou=0.98");
    bench.says(1, &high, &["NOT met: epoxy 0."]);
    let low = format!("{line} --overwrite --set evaluate.require_iou=0.7");
    bench.says(0, &low, &["0.7000 met"]);
}

#[test]
fn json_lines_and_silence_are_kept() {
    let bench = bench();
    let events = bench.events(0, "run job.toml --json");
    let count_of = |name: &str| events.iter().filter(|e| e["event"] == name).count();
    assert!(
        count_of("stage") >= 4 && count_of("iteration") >= 2,
        "{events:?}"
    );
    assert_eq!(events.last().unwrap()["event"], "done");
    let losses: Vec<f64> = events.iter().filter_map(|e| e["loss"].as_f64()).collect();
    // Another ceiling of the pixels may cost next to nothing
    assert!(
        losses.windows(2).all(|pair| pair[1] <= 1.000001 * pair[0]),
        "{losses:?}"
    );
    let output = bench.command("run job.toml --quiet").output().unwrap();
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
}

/// A repeatable sequence of random numbers.
struct Random(u64);

impl Random {
    /// 0 … n − 1.
    fn below(&mut self, n: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 % n
    }
}

/// What a run is doing when it is killed.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Phase {
    /// Before the first iteration.
    Beginning,
    /// So many iterations after the last checkpoint; a checkpoint is written after nearly each one.
    Optimizing(u64),
    Evaluating,
    /// While files are written, or moved to their names.
    Writing,
}

/// Starts the command, kills it at a random moment of a phase, and tells whether it was still alive then.
#[cfg(unix)]
fn killed_in(bench: &Bench, line: &str, phase: Phase, random: &mut Random) -> bool {
    use std::os::unix::process::ExitStatusExt;
    let mut command = bench.command(line);
    command.stdout(Stdio::piped()).stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    let mut iterations = match phase {
        Phase::Optimizing(iterations) => iterations,
        _ => 0,
    };
    let mark = match phase {
        Phase::Beginning => "reading the job",
        Phase::Optimizing(_) => "\"iteration\"",
        Phase::Evaluating => "evaluating the written patterns",
        Phase::Writing => "\"writing\"",
    };
    for line in BufReader::new(child.stdout.take().unwrap()).lines() {
        if !line.unwrap_or_default().contains(mark) {
            continue;
        }
        if iterations == 0 {
            break;
        }
        iterations -= 1;
    }
    let longest_us = match phase {
        Phase::Beginning | Phase::Optimizing(_) => 8_000,
        Phase::Evaluating => 30_000,
        Phase::Writing => 60_000,
    };
    std::thread::sleep(Duration::from_micros(random.below(longest_us)));
    let _ = child.kill();
    child.wait().unwrap().signal() == Some(9)
}

/// One run, `kill −9` thirty times at random moments of every phase and resumed each time, on changing numbers of
/// threads: what is visible is whole at any moment, and the end has the bits of the uninterrupted run.
#[test]
#[ignore = "slow"]
#[cfg(unix)]
fn thirty_kills_leave_the_bits_of_the_uninterrupted_run() {
    let bench = bench();
    let job = "run job.toml --json --set stop.iterations=100 --set objective.threshold.upper=1.0 \
               --set objective.threshold.lower=0.99 --set checkpoint.every_s=0.0001";
    bench.done(&format!("{job} --output whole"));
    let whole = bits(&bench.path("whole"));
    for threads in [1, 2, 8] {
        let folder = format!("threads{threads}");
        bench.done(&format!("{job} --output {folder} --threads {threads}"));
        assert_same_bits(&bench.path(&folder), &whole, &folder);
    }

    let mut random = Random(0x5eed);
    let mut phases = vec![Phase::Beginning; 2];
    phases.extend((0..16).map(|_| Phase::Optimizing(1 + random.below(3))));
    phases.extend([Phase::Evaluating; 4]);
    phases.extend([Phase::Writing; 8]);
    assert_eq!(phases.len(), 30);
    let (mut runs, mut unpublished) = (0, 0);
    // And then until three of them met a folder that was being written, however fast the machine is
    let kills = phases.into_iter().chain(iter::repeat(Phase::Writing));
    for (kill, phase) in kills.enumerate() {
        if kill >= 30 && unpublished >= 3 {
            break;
        }
        loop {
            let threads = [1, 2, 8][random.below(3) as usize];
            let line = format!("{job} --output killed --resume --threads {threads}");
            runs += 1;
            assert!(
                runs < 200,
                "kill {kill} ({phase:?}): over before, or not yet writing; {unpublished} while the folder was written"
            );
            if killed_in(&bench, &line, phase, &mut random) {
                break;
            }
            // It was over before that moment: from the beginning
            fs::remove_dir_all(bench.path("killed")).unwrap();
        }
        unpublished += usize::from(bench.path("killed/.new/patterns.npz").exists());
        let killed = bench.path("killed");
        // A run killed before its first file has no folder yet
        let visible = if killed.exists() {
            bits(&killed)
        } else {
            BTreeMap::new()
        };
        for (name, content) in visible {
            assert!(content == whole[&name], "kill {kill} ({phase:?}): {name}");
        }
    }
    bench.done(&format!("{job} --output killed --resume"));
    assert_same_bits(&bench.path("killed"), &whole, "after 30 kills");
}

#[test]
#[cfg(unix)]
fn ctrl_c_ends_with_130_and_keeps_the_best() {
    let bench = bench();
    // Steps too short to get anywhere
    let line =
        "run job.toml --json --set stop.iterations=1000000 --set optimizer.gradient.step=1e-9";
    let mut command = bench.command(line);
    command.stdout(Stdio::piped()).stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
    let under_way = lines.find(|line| line.as_ref().unwrap().contains("\"iteration\""));
    assert!(under_way.is_some(), "no iteration was reported");
    let pid = child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-INT", &pid])
            .status()
            .unwrap()
            .success()
    );
    lines.for_each(drop);
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let run = bench.path("out/job");
    assert!(run.join("checkpoint/patterns.npz").exists());
    assert!(!run.join("report.json").exists());
}

#[test]
fn a_loss_that_is_no_number_stops_with_the_iteration() {
    let bench = bench();
    let line = "run job.toml --set objective.threshold.exponent=100 --set bounds.min=1e6";
    bench.refuse(line, &["at iteration 0"]);
    assert!(bench.path("out/job/checkpoint/patterns.npz").exists());
}

#[test]
fn several_lights_and_objectives_go_from_end_to_end() {
    let bench = bench();
    let light = JOB[JOB.find("[[light]]").unwrap()..JOB.find("[objective").unwrap()].trim();
    let second = light.replace(
        "angles = 30",
        "angles = { count = 20, start_deg = 3.0 }\nname = \"b\"\npolarization = \"p\"",
    );
    let text = JOB
        .replace(light, &format!("{light}\nname = \"a\"\n\n{second}"))
        .replace(
            "[objective.threshold]",
            "[[objectives]]\nthreshold = {}\n[[objectives]]\nweight = 0.5\nl2 = {}",
        );
    bench.write("two.toml", &text);
    bench.done("run two.toml");
    let run = bench.path("out/two");
    for name in [
        "frames/a/frame_0029.png",
        "frames/b/frame_0019.png",
        "gear_a_10rpm.mp4",
        "gear_b_10rpm.mp4",
    ] {
        assert!(run.join(name).exists(), "{name}");
    }
    bench.done("simulate two.toml --patterns out/two/patterns.npz --output again");
    let [report, again] = ["out/two", "again"].map(|folder| bench.report(folder));
    assert_eq!(again["evaluation"], report["evaluation"]);
    assert_eq!(report["lights"].as_array().unwrap().len(), 2);
    let line = "simulate two.toml --patterns out/two/patterns.npz --set light[1].angles=21";
    bench.refuse(line, &["expected shape [21, 24, 48], found [20, 24, 48]"]);
}

#[test]
#[ignore = "slow"]
fn no_light_reaches_a_body_that_is_to_stay_dark() {
    let bench = bench();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/11-bodies.toml");
    let job = fs::read_to_string(&example).unwrap();
    let meshes = example.parent().unwrap().join("meshes");
    let job = job.replace("\"meshes", &format!("\"{}", meshes.display()));
    bench.write("bodies.toml", &job);
    let settings = "--quiet --set grid.pitch_mm=0.1 --set stop.iterations=4 --set light[0].angles=36 \
                    --set evaluate.sub_angles=1 --set evaluate.refine=2";
    bench.done(&format!(
        "run bodies.toml {settings} --set output.folder=dark"
    ));
    let text = bench.read("bodies.toml");
    bench.write("plain.toml", &text.replace("keep-dark", "ignore"));
    bench.done(&format!(
        "run plain.toml {settings} --set output.folder=plain"
    ));
    // The largest dose in the pocket, x from −0.5 to 0.5 and y from 0.2 to 1.2 mm, a voxel from its faces, and
    // anywhere; dose.npy has voxels of 0.1 mm
    let doses = |folder: &str| {
        let file = bench.path(folder).join("dose.npy");
        let ([_, ny, nx], dose) = tomolith::io::npy::read_volume(&file).unwrap();
        let at = |i: usize, n: usize| (i as f64 - (n - 1) as f64 / 2.0) * 0.1;
        let (mut pocket, mut all) = (0.0f32, 0.0f32);
        for (i, &dose) in dose.iter().enumerate() {
            let (x, y) = (at(i % nx, nx), at(i / nx % ny, ny));
            all = all.max(dose);
            if x.abs() < 0.45 && (0.25..1.15).contains(&y) {
                pocket = pocket.max(dose);
            }
        }
        (pocket, all)
    };
    let (pocket, all) = doses("dark");
    assert!(all > 0.5 && pocket <= 1e-6 * all, "{pocket} of {all}");
    // What the body gets stands in the report; on the finer grid its faces are grazed by columns that miss the middle of the
    // coarser voxels
    let report = bench.report("dark");
    let dark = &report["published"]["keep_dark"];
    let number = |key: &str| dark[key].as_f64().unwrap();
    let part = number("part_mean");
    assert!(part > 0.5 && number("mean") < 0.01 * part, "{dark}");
    let page = bench.read("dark/report.html");
    assert!(page.contains("Keep-dark body"));
    let plain = bench.report("plain");
    assert!(plain["published"]["keep_dark"].is_null());
    let (pocket, all) = doses("plain");
    assert!(pocket > 0.05 * all, "{pocket} of {all}");
    // Scattered light goes everywhere, and decides nothing
    let settings = settings.replace("--quiet", "--set resin.scattering_per_mm=0.05");
    let line = format!("run bodies.toml {settings} --set output.folder=scattered");
    bench.says(0, &line, &["of the pixels stay dark"]);
}

/// The window widens only where no threshold is named, and a resolved job must name none either.
#[test]
fn the_job_of_a_run_whose_window_widened_makes_the_same_patterns() {
    let bench = bench();
    let job = r#"
        target = { phantom = { cylinder = { size_mm = 1.0, height_mm = 0.8 } } }
        grid = { pitch_mm = 0.1 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 3.0 } }
        light = [{ pixels = [64, 16], angles = 90, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        objective = { threshold = { surface = "voxel" } }
        stop.iterations = 60
        "#;
    bench.write("disc.toml", job);
    bench.says(
        0,
        "run disc.toml -o wide",
        &["from now on the void's threshold is 0.65"],
    );
    bench.done("run wide/job.toml -o again");
    assert_same_bits(&bench.path("again"), &bits(&bench.path("wide")), "again");
}

#[test]
#[ignore = "slow"]
fn scattered_light_of_cones_is_held_against_monte_carlo_paths() {
    let bench = bench();
    let cone = "light.projector={telecentric={pixel_pitch_mm=0.1,aperture_radius_mm=4.0,working_distance_mm=40.0}}";
    let line = format!(
        "run job.toml -o cone --set resin.scattering_per_mm=0.2 --set stop.iterations=3 --set {cone}"
    );
    bench.done(&line);
    let report = bench.report("cone");
    let models = report["run"]["models"].to_string();
    contains(&models, "", &["successive_orders (rays, 4 per pixel"]);
    let found = &report["published"]["orders"];
    let errors = ["part", "void"].map(|place| found[place].as_f64().unwrap());
    assert!(errors.iter().all(|error| *error < 0.02), "{found}");
    // What the noise of the paths hides is 0, but not everywhere
    assert!(errors.iter().any(|error| *error > 0.0), "{found}");
}

#[test]
fn check_tells_the_plan_and_changes_nothing() {
    let bench = bench();
    let parts = ["gear", "parallel", "memory", "time", "30 frames"];
    bench.says(0, "check job.toml", &parts);
    assert!(!bench.path("out").exists());
    let plan = bench.json("check job.toml");
    assert!(plan["memory_mb"].as_u64().unwrap() > 0 && plan["seconds"].as_f64().unwrap() > 0.0);
    let of_time = |bound: &str| {
        let output = bench.stdout(0, &format!("check job.toml --set {bound}"));
        let searches = output.contains("the run looks for the lowest ceiling of the pixels");
        let [iterations, time] =
            ["takes as long as some ", "N·M/t is at most about "].map(|before| {
                let after = output.split_once(before)?.1;
                after.split_once(' ')?.0.parse::<f64>().ok()
            });
        (searches, iterations.is_some_and(|n| n >= 1.0), time)
    };
    assert_eq!(of_time("bounds.ceiling=lowest"), (true, true, None));
    assert_eq!(of_time("bounds.ceiling=start"), (false, false, None));
    // The threshold objective asks for doses below 0.7 or above 0.9
    assert_eq!(of_time("bounds.max=0.2"), (false, false, Some(7.5)));
    // Light of ±1 mm enters a vial of index 1.5 in air: tangent up to 0.67 mm only
    let output = bench.stdout(0, "check job.toml --set light.pixels=[20,24]");
    assert!(output.contains("not lit from all sides"), "{output}");
}

#[test]
fn kinds_and_schema_name_every_kind() {
    let bench = bench();
    let kinds = bench.stdout(0, "kinds");
    let schema: Value = serde_json::from_str(&bench.stdout(0, "schema")).unwrap();
    let schema = schema.to_string();
    for family in tomolith::job::kinds::families() {
        for page in &family.kinds {
            assert!(
                kinds.contains(page.name),
                "{} is not in the list",
                page.name
            );
            assert!(
                schema.contains(&format!("\"{}\"", page.name)),
                "{} is not in the schema",
                page.name
            );
            let full = bench.stdout(0, &format!("kinds {} {}", family.name, page.name));
            let dotted = format!("{}.{}", family.name, page.name);
            assert_eq!(bench.stdout(0, &format!("kinds {dotted}")), full);
            for parameter in tomolith::job::kinds::parameters(page) {
                assert!(
                    full.contains(&parameter.name),
                    "{}.{}",
                    page.name,
                    parameter.name
                );
                assert!(
                    !parameter.meaning.is_empty(),
                    "{}.{} says nothing",
                    page.name,
                    parameter.name
                );
            }
        }
    }
    bench.refuse("kinds vail", &["did you mean `vial`?"]);
}

#[test]
#[ignore = "slow"]
fn every_example_is_sound() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut seen = 0;
    for entry in fs::read_dir(examples).unwrap().map(|e| e.unwrap().path()) {
        if entry.extension().is_some_and(|e| e == "toml") {
            let bench = bench();
            bench.done(&format!("check {} --toy", entry.display()));
            seen += 1;
        }
    }
    assert!(seen >= 6, "{seen} examples");
}

/// What is wrong without being refused is said while the command runs, and stands in the report.
#[test]
#[ignore = "slow"]
fn numbers_that_mean_little_come_with_a_warning() {
    let bench = bench();
    for (i, (settings, part)) in [
        (
            "--set light.angles=1",
            "light comes from one direction only",
        ),
        (
            "--set light.angles={list_deg=[0,90,360]}",
            "light comes from 2 directions only",
        ),
        (
            "--set evaluate.threshold=50",
            "evaluate.threshold = 50 is above every dose",
        ),
        (
            "--set start=zero --set stop.iterations=0",
            "the patterns are dark everywhere",
        ),
        (
            "--set bounds.max=1e-40 --set resin.absorption_per_mm=1e-9",
            "the patterns leave no dose in the part",
        ),
        (
            "--set light.projector.collimated.pixel_pitch_mm=200",
            "light[0]: a pixel is 200 mm wide, the part 2 mm",
        ),
        (
            "--set grid.shape=[10,10,10] --set grid.clip=true",
            "% of the part's volume: patterns, numbers and print",
        ),
        (
            "--set evaluate.refine=1",
            "evaluated on the job's own voxels",
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let output = bench.ended(0, &format!("run job.toml --output w{i} {settings}"));
        contains(&String::from_utf8_lossy(&output.stderr), settings, &[part]);
        let report = bench.report(&format!("w{i}"));
        if settings.contains("angles") {
            // The vial stands while the only frame is shown, or those of a list are
            assert_eq!(report["evaluation"]["sub_angles"], 1, "{settings}");
        }
        let warnings = report["warnings"].as_array().unwrap();
        let is_warned = warnings
            .iter()
            .any(|text| text.as_str().unwrap().contains(part));
        assert!(is_warned, "{settings}: {warnings:?}");
    }
    let plain = bench.ended(0, "run job.toml --output plain");
    let message = String::from_utf8_lossy(&plain.stderr);
    for part in [
        "direction",
        "evaluate.threshold",
        "dark everywhere",
        "no dose",
        "a pixel is",
        "volume",
        "own voxels",
    ] {
        assert!(!message.contains(part), "{part}: {message}");
    }
}

#[test]
fn a_worst_case_without_cases_is_told() {
    let bench = bench();
    let warning = "robust.of = \"worst\" changes nothing without a [[scenario]]";
    let output_of =
        |value: &str| bench.expect(0, &format!("check job.toml --set robust.of={value}"));
    assert!(output_of("worst").contains(warning) && !output_of("mean").contains("robust"));
}

#[test]
fn the_closing_lines_say_on_which_voxels() {
    let bench = bench();
    bench.says(
        0,
        "run job.toml --output a --set evaluate.refine=2",
        &["evaluated on 56 × 56 × 36 voxels of 0.05 mm, 2× finer than the job's"],
    );
    bench.says(
        0,
        "simulate job.toml --patterns a --output a-coarse --set evaluate.refine=1",
        &[
            "evaluated on voxels of 0.05 mm, this print is on voxels of 0.1 mm",
            "evaluate.refine = 2 gives",
        ],
    );
    bench.says(
        0,
        "run job.toml --output b --set evaluate.refine=1 --toy",
        &[
            "the job's own (evaluate.refine = 1)",
            "This is a toy of the job",
            "b/report.html",
        ],
    );
    let page = bench.read("b/report.html");
    assert!(page.contains(" on voxels of 300 µm: ") && page.contains("[\"A toy\","));
    let output = bench.stdout(0, "run job.toml --output d --toy --keep metrics");
    assert!(
        output.contains("d/report.json") && !output.contains("report.html"),
        "{output}"
    );
    let done = bench.json("run job.toml --output c --toy");
    assert_eq!(done["refine"], 2);
    let pitch = done["evaluation_pitch_mm"].as_f64().unwrap();
    assert!((pitch - 0.15).abs() < 1e-12, "{pitch}");
}

/// The grid lies on the rows of the pixels unless the job says otherwise, and everything that knows its place says the same.
#[test]
fn a_grid_that_moves_onto_the_rows_says_so() {
    let bench = bench();
    let origin = |folder: &str| {
        let bytes = fs::read(bench.path(folder).join("dose.vti")).unwrap();
        let text = String::from_utf8_lossy(&bytes[..400]).into_owned();
        let (_, origin) = text.split_once("Origin=\"").unwrap();
        let z = origin.split(['"', ' ']).nth(2).unwrap();
        z.parse::<f64>().unwrap()
    };
    let note = "the grid is moved up by 0.05 mm, so that a slice begins where a row of pixels does";
    // Eighteen slices lie on an even number of rows; on 25 rows they move by half of one
    for (folder, settings, place) in [
        ("even", "", 0.0),
        ("odd", "--set light.pixels=[48,25]", 0.05),
        (
            "left",
            "--set light.pixels=[48,25] --set grid.on_rows=false",
            0.0,
        ),
    ] {
        let run = bench.ended(0, &format!("run job.toml --output {folder} {settings}"));
        let message = String::from_utf8_lossy(&run.stderr);
        let check = bench.stdout(0, &format!("check job.toml {settings}"));
        for text in [&*message, &*check] {
            assert_eq!(text.contains(note), place != 0.0, "{folder}: {text}");
        }
        // The lowest of 18 slices stands 8.5 of them below the middle
        assert!(
            (origin(folder) + 0.85 - place).abs() < 1e-9,
            "{folder}: {}",
            origin(folder)
        );
        let report = bench.report(folder);
        let middle = report["evaluation"]["grid"]["center_xyz_mm"][2]
            .as_f64()
            .unwrap();
        assert!((middle - place).abs() < 1e-9, "{folder}: {middle}");
    }
}
