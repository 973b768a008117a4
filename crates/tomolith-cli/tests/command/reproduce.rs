//! `tomolith reproduce` as it is typed: a study of two runs and a command, done again, and slips in its file.

use crate::bench::{Bench, contains, slipped};
use serde_json::Value;

/// A disc of 24 × 24 voxels, 24 frames.
const JOB: &str = r#"
target = { phantom = { cylinder = { size_mm = 1.2, height_mm = 0.1 } } }
grid = { shape = [24, 24, 1], pitch_mm = 0.1 }
resin = { refractive_index = 1.5, pure_radon = true }
vial = { index_matched = { radius_mm = 2.0 } }
light = [{ pixels = [24, 1], angles = { count = 24, arc_deg = 180.0 }, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
objective = { ospw = { lower = 0.5, upper = 0.9 } }
stop = { iterations = 8 }
evaluate = { refine = 1, sub_angles = 1 }
"#;

const SWEEP: &str = r#"
job = "job.toml"
[[axes]]
key = "objective.ospw.lower"
values = [0.3, 0.5, 0.7]
"#;

/// The published numbers are made up: one that is right, one that is wrong, one of a command, which is 1000/50 µm.
const STUDY: &str = r#"
title = "A disc"
paper = "Nobody, never"
[runs.map]
sweep = "sweep.toml"
quick = { axes = [{ key = "objective.ospw.lower", values = [0.3, 0.5] }] }
[runs.voxel]
command = ["analyze", "voxel", "--pixels", "100", "--fps", "1000", "--penetration-mm", "10", "--dose-time-s", "50", "--radius-mm", "1"]
writes = true
[[rows]]
quantity = "IoU"
where = "Table 1"
of = "map"
at = { lower = 0.5 }
metric = "optimization.iou"
published = 1
within = 0.5
[[rows]]
quantity = "the larger PW | of both"
where = "Fig. 2"
name = "wide"
of = "map"
metric = "optimization.pw"
over = ["lower < 0.6"]
take = "max"
published = 7
within_percent = 1
differs = "nobody, \"never\" measured it"
[[rows]]
quantity = "it is below 1"
where = "Fig. 2"
says = "yes"
holds = "wide < 1"
[[rows]]
quantity = "pixel, mm"
where = "S1"
of = "voxel"
metric = "at_radius.pixel_mm"
published = 0.02
within = 1e-9
[[rows]]
quantity = "IoU at 0.7"
where = "Table 1"
of = "map"
at = { lower = 0.7 }
metric = "optimization.iou"
published = 1
within = 0.5
[[rows]]
quantity = "weather"
where = "section 3"
says = "fair"
under_specified = "no place is named"
[[tables]]
title = "All of the map"
of = "map"
columns = [{ name = "own IoU", metric = "optimization.iou" }]
"#;

fn bench_of(study: &str) -> Bench {
    Bench::with(&[
        ("disc/job.toml", JOB),
        ("disc/sweep.toml", SWEEP),
        ("disc/study.toml", study),
    ])
}

#[test]
fn a_study_lays_published_numbers_beside_ours_and_goes_on_where_it_was() {
    let bench = bench_of(STUDY);
    // What it costs is said without any work
    let events = bench.events(0, "reproduce disc --quick --check --json");
    assert_eq!(
        (events.len(), events[0]["runs"][0]["runs"].as_u64()),
        (1, Some(2))
    );
    assert!(!bench.path("out").exists());
    let events = bench.events(0, "reproduce disc --quick --json");
    let rows = events[events.len() - 1]["rows"].as_array().unwrap();
    assert_eq!(rows[1]["published"], 7.0);
    assert_eq!(rows[5]["published"], "fair");
    let verdicts: Vec<&str> = rows
        .iter()
        .map(|row| row["verdict"].as_str().unwrap())
        .collect();
    let expected = [
        "reproduced",
        "differs",
        "reproduced",
        "reproduced",
        "not_compared",
        "under_specified",
    ];
    assert_eq!(verdicts, expected);
    let (table, csv) = (
        bench.read("out/papers/disc-quick/table.md"),
        bench.read("out/papers/disc-quick/table.csv"),
    );
    let parts = [
        "6 rows (quick size): 3 reproduced, 1 differs, 1 under-specified, 1 not compared.",
        "| the larger PW \\| of both | 7 | ",
        "| differs, because nobody, \"never\" measured it | Fig. 2 |",
        "| pixel, mm | 0.02 | 0.02 | × 1 | reproduced | S1 |",
        "| it is below 1 | yes | yes |  | reproduced | Fig. 2 |",
        "no run of this size has these values",
        "## All of the map\n\n| lower | own IoU |\n|---|---|\n| 0.3 | ",
        "![map/optimization.pw.svg](map/optimization.pw.svg)",
    ];
    contains(&table, "", &parts);
    contains(
        &csv,
        "",
        &["differs,\"nobody, \"\"never\"\" measured it\",Fig. 2\n"],
    );
    assert!(
        bench
            .path("out/papers/disc-quick/map/optimization.pw.svg")
            .is_file()
    );
    // Again: nothing is run, and the tables are the same
    let again = bench.events(0, "reproduce disc --quick --json");
    let sweep = again
        .iter()
        .find(|event| event["event"] == "sweep")
        .unwrap();
    assert_eq!(
        (sweep["runs"].as_u64(), sweep["finished"].as_u64()),
        (Some(2), Some(2))
    );
    assert_eq!(
        (table, csv),
        (
            bench.read("out/papers/disc-quick/table.md"),
            bench.read("out/papers/disc-quick/table.csv")
        )
    );
}

#[test]
fn a_difference_that_nobody_explains_and_a_command_that_fails_are_exit_code_1() {
    let study = STUDY.replace("differs = \"nobody, \\\"never\\\" measured it\"", "");
    let bench = bench_of(&study);
    let text = bench.stdout(1, "reproduce disc --quick --quiet --output a");
    assert_eq!(text, "");
    contains(
        &bench.read("a/table.md"),
        "",
        &["unexplained: another number, and the study does not say why"],
    );
    let bench = bench_of(&STUDY.replace("\"--pixels\", \"100\"", "\"--pixels\", \"0\""));
    bench.ended(1, "reproduce disc --quick --output a");
    contains(&bench.read("a/table.csv"), "", &["no number,"]);
}

#[test]
fn values_that_no_run_of_the_full_size_has_are_refused_and_a_quick_size_may_lack_them() {
    let slip = STUDY.replace("at = { lower = 0.7 }", "at = { lower = 0.77 }");
    let bench = bench_of(&slip);
    bench.refuse(
        "reproduce disc --check",
        &["rows[4].at", "no run has these values"],
    );
    bench.done("reproduce disc --quick --check --json");
}

/// A study is refused with these words, before any work and when only its cost is asked for.
fn refused(study: &str, parts: &[&str]) {
    assert_ne!(study, STUDY);
    for line in ["reproduce disc --quick", "reproduce disc --quick --check"] {
        let bench = bench_of(study);
        let message = bench.stdout(2, &format!("{line} --json"));
        let error: Value = serde_json::from_str(message.trim()).unwrap();
        let text = format!(
            "{error} {}:{}:",
            error["file"].as_str().unwrap_or(""),
            error["line"]
        );
        contains(&text, line, parts);
        assert!(!bench.path("out").exists(), "{study}");
    }
}

/// The study with another command.
fn with_command(words: &str, writes: bool) -> String {
    let (before, rest) = STUDY.split_once("command = [").unwrap();
    let (_, after) = rest.split_once("writes = true").unwrap();
    format!("{before}command = [{words}]\nwrites = {writes}{after}")
}

#[test]
fn commands_that_cannot_work_are_refused_before_any_work() {
    let simulate = |folder: &str| {
        format!("\"simulate\", \"job.toml\", \"--patterns\", \"{folder}/patterns.npz\"")
    };
    for (words, part) in [
        ("\"analyse\", \"voxel\"", "'analyse'"),
        (
            "\"analyze\", \"voxel\", \"--pixles\", \"100\"",
            "'--pixles' found; tip:",
        ),
        ("\"run\", \"job.toml\", \"--output\", \"a\"", "'--output"),
        (&simulate("{mapp[0]}"), "no run has this name"),
        (&simulate("{voxel}"), "`voxel` is a command"),
        (&simulate("{map[last]}"), "the index is no whole number"),
        (&simulate("{map}"), "a sweep of 2 runs"),
        (&simulate("{map[2]}"), "the last run is {map[1]}"),
        (
            "\"simulate\", \"job.toml\", \"--patterns\", \"{map[0]}/pattern.npz\"",
            "has no `pattern.npz`, only job.toml, report.json, history.csv, patterns.npz",
        ),
    ] {
        let parts = ["runs.voxel.command", "study.toml:8:", part];
        refused(&with_command(words, true), &parts);
    }
}

#[test]
fn figures_lay_the_histograms_of_runs_side_by_side() {
    let figure = |histogram: &str, run: &str| {
        format!(
            "{STUDY}\n[[figures]]\nname = \"doses\"\ntitle = \"Doses\"\nhistogram = \"{histogram}\"\npanels = [{{ of = \"{run}\" }}]\n"
        )
    };
    for (histogram, run, parts) in [
        (
            "optimization.iou",
            "map",
            ["figures[0].histogram", "is no histogram of report.json"],
        ),
        (
            "optimization.histogram",
            "voxel",
            [
                "figures[0].panels[0].of",
                "is no sweep or job of this study",
            ],
        ),
    ] {
        refused(&figure(histogram, run), &parts);
    }
    let bench = bench_of(&figure("optimization.histogram", "map"));
    bench.done("reproduce disc --quick --json");
    let picture = bench.read("out/papers/disc-quick/doses.svg");
    contains(&picture, "", &["lower = 0.3", "teal: part · orange: void"]);
    let table = bench.read("out/papers/disc-quick/table.md");
    assert!(table.contains("![doses.svg](doses.svg)"), "{table}");
    // No target of part and void has errors: no picture, and no fault
    let bench = bench_of(&figure("optimization.errors", "map"));
    bench.done("reproduce disc --quick --json");
    assert!(!bench.path("out/papers/disc-quick/doses.svg").exists());
}

#[test]
fn results_do_not_lie_among_files_of_the_study() {
    let bench = bench_of(STUDY);
    std::fs::create_dir(bench.path("map")).unwrap();
    std::fs::rename(bench.path("disc"), bench.path("map/disc")).unwrap();
    std::os::unix::fs::symlink(bench.path("map/disc"), bench.path("link")).unwrap();
    // The folder itself under other names; one whose folder for the run `map` holds the study
    for output in ["map/disc", "map/../map/disc/", "link", "."] {
        let line = format!("reproduce map/disc --quick --output {output}");
        for line in [format!("{line} --check"), line] {
            let message = bench.says(2, &line, &["--output: results in `"]);
            assert!(message.contains("map/disc/study.toml`"), "{message}");
        }
        assert!(!bench.path("map/disc/map").exists());
    }
    bench.done("reproduce map/disc --quick --output map/disc/results");
}

#[test]
fn a_command_leaves_no_files_in_the_folder_of_the_study() {
    let in_place = "leaves files in the folder of the study";
    for (words, writes, part) in [
        ("\"run\", \"job.toml\"", false, in_place),
        ("\"compare\", \"a\", \"b\"", false, in_place),
        (
            "\"analyze\", \"impulse\", \"--output\", \"a\"",
            false,
            in_place,
        ),
        ("\"compare\", \"a\", \"b\"", true, "writes a file"),
        ("\"kinds\"", true, "'--output'"),
    ] {
        refused(
            &with_command(words, writes),
            &["runs.voxel.", "study.toml:", part],
        );
    }
}

#[test]
fn a_command_is_left_out_with_the_run_whose_folder_it_reads() {
    let study = with_command(
        r#""simulate", "job.toml", "--patterns", "{map[0]}/patterns.npz""#,
        true,
    );
    let bench = bench_of(&study.replace("quick = { axes", "quick = { skip = true, axes"));
    let events = bench.events(0, "reproduce disc --quick --check --json");
    assert_eq!(
        events[0]["runs"][1]["left_out"],
        "needs run `map`: full size only"
    );
}

/// Read by [`slipped`](crate::bench::slipped).
const SLIPS: &str = r#"
# Keys of a row that contradict each other
- take = "max"
+ share_of = "lower < 0.5"
rows[1].metric … together with share_of

- metric = "optimization.pw"
+ share_of = "lower < 0.5"
rows[1].take … together with share_of

- over = ["lower < 0.6"]
+ over = []
+ best = true
rows[1].best … together with over

- says = "yes"
+ published = 1
rows[2].holds … together with published

  says = "fair"
+ best = true
rows[5].best … without of

  says = "fair"
+ within = 1
rows[5].within … without published

  says = "fair"
+ published = 1
rows[5].says … together with published

- says = "fair"
+ differs = "it rained"
rows[5].differs … together with under_specified

  sweep = "sweep.toml"
+ writes = true
runs.map.writes … without command

  writes = true
+ set = { a = 1 }
runs.voxel.set … together with command

  of = "voxel"
+ best = true
rows[3].best … together with of = \"voxel\", which is no sweep

# Names, numbers and values
- where = "S1"
+ were = "S1"
rows[3].were … study.toml:36: … where

- of = "voxel"
+ of = "voxels"
rows[3].of … study.toml:37: … map, voxel

- holds = "wide < 1"
+ holds = "width < 1"
rows[2].holds … line 33 … no earlier row is named `width`

- at = { lower = 0.7 }
+ at = { upper = 0.7 }
rows[4].at … line 45 … `upper` is no axis

- metric = "optimization.pw"
+ metric = "optimization.pww"
optimization.pww … rows[1].metric … did you mean `optimization.pw`

  title = "All of the map"
- of = "map"
+ of = "voxel"
tables[0].of … `voxel` is no sweep or job … map

- [runs.map]
+ [runs."../map"]
runs … a run named `../map` … letters, digits

- command = ["analyze", "voxel", "--pixels", "100", "--fps", "1000", "--penetration-mm", "10", "--dose-time-s", "50", "--radius-mm", "1"]
+ command = ["reproduce", ".", "--pixels", "100", "--fps", "1000", "--penetration-mm", "10", "--dose-time-s", "50", "--radius-mm", "1"]
runs.voxel.command … reproduces a study … line 8

- within = 0.5
+ within = -0.5
rows[0].within … found -0.5 … 0 or more

  published = 1
+ take = "max"
rows[0].take … without over … line

- at = { lower = 0.5 }
+ at = {}
rows[0].at … it says nothing of `lower` … a value for every axis

  sweep = "sweep.toml"
+ set = { "objective.ospw.uper" = 1 }
runs.map.set.objective.ospw.uper … study.toml … upper

  sweep = "sweep.toml"
+ set = { "evaluate.bit_depth" = 40, "output.rpm" = 0 }
runs.map.set.evaluate.bit_depth … runs.map.set.output.rpm … study.toml

- within = 1e-9
rows[3] … study.toml … a published number without a verdict
"#;

#[test]
fn slips_are_refused_with_file_and_line_before_any_work() {
    for slip in SLIPS.split("\n\n") {
        let (study, mut parts) = slipped(STUDY, "", slip);
        parts.push("study.toml");
        refused(&study, &parts);
    }
    bench_of(STUDY).ended(2, "reproduce nowhere");
}
