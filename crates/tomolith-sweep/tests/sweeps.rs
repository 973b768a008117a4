//! Whole sweeps of a job that takes a moment: what they come to does not depend on when, where and how often they were begun.

use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use tomolith::job::{self, Job, Leaves, Silent, run_leaving};
use tomolith::models::Work;
use tomolith::{Error, Result};
use tomolith_sweep::{Shard, Sweep, SweepEvent, SweepOutcome, SweepPlan, Watch, merge, run};

/// All these parts are in a text.
macro_rules! contains {
    ($text:expr, $($part:expr),+ $(,)?) => {
        $(assert!($text.contains($part), "{:?} is not in: {}", $part, $text);)+
    };
}

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

/// Six pairs.
const SWEEP: &str = r#"
job = "job.toml"
metrics = ["evaluation.pw", "optimization.pw", "history.loss", "history.iterations"]
when = ["lower < upper"]
[best]
highest = "optimization.pw"
[[axes]]
key = "objective.ospw.lower"
values = [0.3, 0.5, 0.7]
[[axes]]
key = "objective.ospw.upper"
linear = { from = 0.4, to = 0.8, step = 0.2 }
"#;

struct Bench(tempfile::TempDir);

impl Bench {
    fn new(sweep: &str) -> Self {
        let bench = Bench(tempfile::tempdir().unwrap());
        bench.write("job.toml", JOB);
        bench.write("sweep.toml", sweep);
        bench
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// The runs of a sweep file whose results go into a folder.
    fn planned(&self, file: &str, folder: &str) -> Result<SweepPlan> {
        let sweep = Sweep::read(&self.path(file))?;
        let sweep = sweep.with_folder(&self.path(folder), "--output");
        sweep.plan(2, &Work::new())
    }

    fn plan(&self, folder: &str) -> SweepPlan {
        self.planned("sweep.toml", folder).unwrap()
    }

    /// What is said of a sweep file that is refused.
    fn refused(&self, file: &str, folder: &str) -> String {
        self.planned(file, folder)
            .map(drop)
            .unwrap_err()
            .to_string()
    }

    /// A sweep from its begin to its end.
    fn whole(&self, folder: &str, side_by_side: usize) -> SweepOutcome {
        let mut plan = self.plan(folder);
        plan.side_by_side = side_by_side;
        begin(&plan).unwrap()
    }

    fn table(&self, folder: &str) -> String {
        self.read(&format!("{folder}/table.csv"))
    }

    /// `report.json` of every run, by its folder.
    fn reports(&self, folder: &str) -> BTreeMap<PathBuf, String> {
        let runs = fs::read_dir(self.path(folder).join("runs")).unwrap();
        let report = |path: PathBuf| {
            Some((
                path.clone(),
                fs::read_to_string(path.join("report.json")).ok()?,
            ))
        };
        runs.filter_map(|run| report(run.unwrap().path())).collect()
    }

    /// What a sweep file is refused with.
    fn refusal(&self, sweep: &str) -> String {
        self.write("bad.toml", sweep);
        self.refused("bad.toml", "bad")
    }
}

/// What was told; asks to stop after so many runs.
#[derive(Default)]
struct Told<'r> {
    events: Vec<SweepEvent>,
    stop_after: Option<(usize, Option<&'r Work>)>,
}

impl Watch for Told<'_> {
    fn event(&mut self, event: &SweepEvent) {
        self.events.push(event.clone());
        if let Some((count, Some(run))) = self.stop_after
            && self.events.len() > count
        {
            run.cancel();
        }
    }
}

/// All runs of a plan, of which nobody is told.
fn begin(plan: &SweepPlan) -> Result<SweepOutcome> {
    run(plan, None, &mut Told::default(), &Work::new())
}

/// A report without what two equal runs may differ in, and without movies, which a sweep does not make.
fn comparable(text: &str) -> Value {
    let mut report: Value = serde_json::from_str(text).unwrap();
    let map = report.as_object_mut().unwrap();
    map.retain(|key, _| key != "run" && key != "movies");
    report
}

#[test]
fn files_of_others_are_not_replaced() {
    let bench = Bench::new(SWEEP);
    fs::create_dir(bench.path("mine")).unwrap();
    bench.write("mine/best.toml", "mine");
    let plan = bench.plan("mine");
    let begun = begin(&plan);
    let text = begun.map(drop).unwrap_err().to_string();
    contains!(text, "holds files that are no results, such as `best.toml`");
    assert_eq!(fs::read(bench.path("mine/best.toml")).unwrap(), b"mine");
}

#[test]
fn damaged_runs_are_done_again_and_told() {
    let sweep = format!("keep = \"patterns\"\n{SWEEP}");
    let bench = Bench::new(&sweep);
    bench.whole("out", 2);
    let (table, reports) = (bench.table("out"), bench.reports("out"));
    let mut folders = reports.keys();
    let (first, second) = (folders.next().unwrap(), folders.next().unwrap());
    fs::write(first.join("report.json"), "{}").unwrap();
    let patterns = second.join("patterns.npz");
    let whole = fs::read(&patterns).unwrap();
    fs::write(&patterns, &whole[..whole.len() / 2]).unwrap();
    let outcome = bench.whole("out", 2);
    assert_eq!(
        (outcome.done, outcome.warnings.len()),
        (6, 2),
        "{:?}",
        outcome.warnings
    );
    for part in ["report.json: no `schema`", "patterns.npz: truncated"] {
        let warnings = outcome.warnings.iter().filter(|text| text.contains(part));
        assert_eq!(warnings.count(), 1, "{part}: {:?}", outcome.warnings);
    }
    assert_eq!(bench.table("out"), table);
    assert_eq!(fs::read(&patterns).unwrap(), whole);
    assert!(bench.whole("out", 2).warnings.is_empty());
}

#[test]
fn runs_as_good_as_the_best_one_are_told() {
    let bench = Bench::new(
        r#"
job = "job.toml"
metrics = ["evaluation.pw"]
best = { highest = "evaluation.pw" }
[[axes]]
key = "output.rpm"
values = [5, 6, 7]
"#,
    );
    let outcome = bench.whole("out", 1);
    assert_eq!(outcome.best.unwrap().run, 1);
    contains!(
        outcome.warnings[0],
        "2 other runs have the same evaluation.pw"
    );
}

#[test]
fn a_name_of_a_case_stays_a_comment_in_the_best_job() {
    let bench = Bench::new(
        r#"
job = "job.toml"
metrics = ["evaluation.pw"]
[[axes]]
name = "m"
cases = [{ name = "=x\n[motion]\ntilt_deg = 7.0 #", set = { "stop.iterations" = 3 } }]
"#,
    );
    bench.whole("out", 1);
    let best = bench.read("out/best.toml");
    let first = "# The best of 1 run: run 1 (m = =x\\n[motion]\\ntilt_deg = 7.0 #).\n";
    assert!(best.starts_with(first), "{best}");
    let job = job::Document::toml("best.toml", best).unwrap().root;
    assert_eq!(job["stop"]["iterations"], 3);
    assert_ne!(job["motion"]["tilt_deg"], 7.0);
    assert!(bench.table("out").contains("\"'=x\n[motion]"));
}

#[test]
fn side_by_side_gives_the_bits_of_one_after_the_other_and_of_a_single_run() {
    let bench = Bench::new(SWEEP);
    let outcome = bench.whole("two", 2);
    bench.whole("one", 1);
    let table = bench.table("two");
    assert_eq!(table, bench.table("one"));
    // 0.3 below three, 0.5 below two, 0.7 below one
    assert_eq!((outcome.done, table.lines().count()), (6, 7));
    let plan = bench.plan("two");
    let job = plan
        .job(3)
        .unwrap()
        .with_folder(&bench.path("single"), "test");
    job::run(&job, false, &mut Silent, &Work::new()).unwrap();
    let single = bench.read("single/report.json");
    let swept = fs::read_to_string(plan.run_folder(3).join("report.json")).unwrap();
    assert_eq!(comparable(&swept), comparable(&single));
    // Little is left of each
    let left = |folder: PathBuf| {
        let mut names: Vec<_> = fs::read_dir(folder)
            .unwrap()
            .map(|e| e.unwrap().file_name())
            .collect();
        names.sort();
        names
    };
    assert_eq!(
        left(plan.run_folder(0)),
        ["history.csv", "job.toml", "report.json"]
    );
    assert_eq!(
        left(bench.path("two")),
        [
            "best.toml",
            "evaluation.pw.svg",
            "history.iterations.svg",
            "history.loss.svg",
            "optimization.pw.svg",
            "runs",
            "sweep.json",
            "table.csv",
            "table.json"
        ]
    );
}

#[test]
fn the_best_job_is_the_one_with_the_highest_metric_and_gives_it_again() {
    let bench = Bench::new(SWEEP);
    let outcome = bench.whole("out", 2);
    let best = outcome.best.clone().unwrap();
    let table = bench.table("out");
    let column = |line: &str| line.split(',').nth(5).unwrap().parse::<f64>().unwrap();
    let all: Vec<f64> = table.lines().skip(1).map(column).collect();
    let highest = all.iter().copied().fold(f64::MIN, f64::max);
    assert_eq!(best.metrics["optimization.pw"].as_f64(), Some(highest));
    assert_eq!(all[best.run - 1], highest);
    let job = job::Job::read(&bench.path("out/best.toml"), &[]).unwrap();
    // The sweep collects no distances of surfaces, which its best job measures
    let mut without_surfaces = job.clone();
    without_surfaces.spec.evaluate.surfaces = false;
    assert_eq!(
        without_surfaces.identity().unwrap(),
        bench.plan("out").runs[best.run - 1].id
    );
    let summary = job::run(&job, false, &mut Silent, &Work::new()).unwrap();
    assert_eq!(summary.optimization.unwrap().pw, Some(highest));
    assert!(outcome.is_met() && outcome.to_string().contains(&best.values));
}

#[test]
fn a_sweep_that_was_stopped_goes_on_and_redoes_nothing() {
    let bench = Bench::new(SWEEP);
    bench.whole("whole", 2);
    let work = Work::new();
    let mut progress = Told {
        stop_after: Some((2, Some(&work))),
        ..Told::default()
    };
    let stopped = run(&bench.plan("stopped"), None, &mut progress, &work);
    assert!(matches!(stopped, Err(Error::Canceled)), "{stopped:?}");
    let before = bench.reports("stopped");
    assert!((2..6).contains(&before.len()), "{}", before.len());
    let mut progress = Told::default();
    run(&bench.plan("stopped"), None, &mut progress, &Work::new()).unwrap();
    assert_eq!(bench.table("stopped"), bench.table("whole"));
    let after = bench.reports("stopped");
    // Dates included: they are the same files
    assert!(before.iter().all(|(path, text)| after[path] == *text));
    assert_eq!(progress.events.len(), 1 + 6 - before.len());
    // A value more costs its own runs alone
    bench.write("sweep.toml", &SWEEP.replace("0.3, 0.5", "0.2, 0.3, 0.5"));
    let mut progress = Told::default();
    run(&bench.plan("stopped"), None, &mut progress, &Work::new()).unwrap();
    assert_eq!(progress.events.len(), 1 + 3);
}

#[test]
fn shares_of_other_machines_merged_are_the_whole() {
    let bench = Bench::new(SWEEP);
    bench.whole("whole", 2);
    let names = ["a", "b", "c", "d"];
    for (i, name) in names.into_iter().enumerate() {
        let shard = Some(Shard {
            number: i + 1,
            shares: names.len(),
        });
        let outcome = run(&bench.plan(name), shard, &mut Told::default(), &Work::new()).unwrap();
        assert!(
            outcome.done > 0 && outcome.done < 6 && outcome.files.is_empty() && outcome.is_met()
        );
    }
    let others = names.map(|name| bench.path(name));
    let half = merge(&bench.plan("merged"), &others[..2]).unwrap();
    assert_eq!((half.done, half.missing, half.is_met()), (3, 3, false));
    let all = merge(&bench.plan("merged"), &others).unwrap();
    assert_eq!((all.done, all.missing, all.is_met()), (6, 0, true));
    assert_eq!(bench.table("merged"), bench.table("whole"));
    fs::create_dir_all(bench.path("stranger/runs/0123456789abcdef")).unwrap();
    let never = merge(&bench.plan("never"), &[]).unwrap_err().to_string();
    assert!(never.starts_with("--merge: ") && never.contains("holds no runs"));
    assert!(!bench.path("never").exists());
    for (name, found) in [
        ("nowhere", "holds no runs"),
        ("stranger", "holds no run of this sweep"),
    ] {
        let message = merge(&bench.plan("merged"), &[bench.path(name)])
            .unwrap_err()
            .to_string();
        assert!(
            message.starts_with("--merge: ") && message.contains(found),
            "{message}"
        );
    }
}

#[test]
fn two_sweep_files_have_two_folders_and_a_file_that_moved_keeps_its_own() {
    let bench = Bench::new(SWEEP);
    bench.whole("out", 2);
    fs::copy(bench.path("sweep.toml"), bench.path("other.toml")).unwrap();
    let whole = |file: &str| {
        let plan = bench.planned(file, "out").unwrap();
        begin(&plan).map(drop)
    };
    let message = whole("other.toml").unwrap_err().to_string();
    contains!(
        message,
        "folder: ",
        "holds the sweep of",
        "sweep.toml",
        "--output DIR"
    );
    whole("sweep.toml").unwrap();
    // The same file with another axis is taken; its table replaces the one before, and finished runs stay
    let runs = || fs::read_dir(bench.path("out/runs")).unwrap().count();
    let before = runs();
    let changed = SWEEP.replace("[0.3, 0.5, 0.7]", "[0.2]");
    bench.write("sweep.toml", &changed);
    bench.whole("out", 2);
    assert!(bench.read("out/table.csv").lines().count() == 4 && runs() > before);
    fs::remove_file(bench.path("sweep.toml")).unwrap();
    whole("other.toml").unwrap();
}

#[test]
fn a_share_of_the_memory_that_holds_no_run_is_told_at_its_own_key() {
    let bench = Bench::new(SWEEP);
    let sweep_of = |gb: f64, side_by_side: usize| {
        format!("{SWEEP}[resources]\nmemory_gb = {gb}\nside_by_side = {side_by_side}\n")
    };
    // One run needs some 100 MB
    let message = bench.refusal(&sweep_of(0.11, 1000));
    contains!(
        message,
        "resources.side_by_side: 0 MB are left for each run, and one needs about",
        "at a time in 110 MB; or a larger resources.memory_gb"
    );
    bench.write("sweep.toml", &sweep_of(0.11, 1));
    bench.plan("out");
}

#[test]
fn a_run_that_fails_is_noted_and_tried_again() {
    let bench = Bench::new(SWEEP);
    bench.whole("whole", 2);
    let plan = bench.plan("out");
    // Somebody's file where a run wants to write, put there after the check
    let foreign = plan.run_folder(2).join("thesis.tex");
    fs::create_dir_all(foreign.parent().unwrap()).unwrap();
    fs::write(&foreign, "mine").unwrap();
    let outcome = begin(&plan).unwrap();
    assert_eq!((outcome.done, outcome.failed), (5, 1));
    assert!(!outcome.is_met());
    let table = bench.table("out");
    let line = table.lines().nth(3).unwrap();
    contains!(line, ",failed,", "holds files that are not from a run");
    fs::remove_file(&foreign).unwrap();
    let mut progress = Told::default();
    run(&plan, None, &mut progress, &Work::new()).unwrap();
    assert_eq!(progress.events.len(), 2);
    assert_eq!(bench.table("out"), bench.table("whole"));
}

#[test]
fn runs_that_started_elsewhere_are_done_again_when_their_own_start_is_there() {
    let warm = SWEEP.replace("[best]", "keep = \"patterns\"\n[warm_start]\n[best]");
    let bench = Bench::new(&warm);
    bench.whole("whole", 2);
    let plan = bench.plan("out");
    // The second run fails, and those after it start from the first in its place
    let foreign = plan.run_folder(1).join("thesis.tex");
    fs::create_dir_all(foreign.parent().unwrap()).unwrap();
    fs::write(&foreign, "mine").unwrap();
    let outcome = begin(&plan).unwrap();
    assert_eq!((outcome.done, outcome.failed), (5, 1));
    assert_ne!(bench.table("out"), bench.table("whole"));
    // As long as it fails they stay
    let before = bench.reports("out");
    begin(&plan).unwrap();
    assert_eq!(before, bench.reports("out"));
    fs::remove_file(&foreign).unwrap();
    begin(&plan).unwrap();
    assert_eq!(bench.table("out"), bench.table("whole"));
}

#[test]
fn a_damaged_report_is_made_anew_and_old_pictures_go() {
    let bench = Bench::new(SWEEP);
    bench.whole("whole", 2);
    let plan = bench.plan("out");
    begin(&plan).unwrap();
    fs::write(plan.run_folder(3).join("report.json"), "{\"eval").unwrap();
    let merged = merge(&plan, &[]).unwrap();
    assert_eq!((merged.done, merged.failed), (5, 1));
    let best = bench.read("out/best.toml");
    assert!(
        best.starts_with("# The best of 5 finished ones of 6 runs: "),
        "{best}"
    );
    begin(&plan).unwrap();
    assert_eq!(bench.table("out"), bench.table("whole"));
    let fewer = SWEEP.replace("\"history.loss\", ", "");
    bench.write("sweep.toml", &fewer);
    let picture = |name: &str| bench.path("out").join(name).exists();
    assert!(picture("history.loss.svg"));
    bench.whole("out", 2);
    assert!(!picture("history.loss.svg") && picture("optimization.pw.svg"));
}

/// The numbers of the rows of a table, by run.
fn rows(table: &str) -> Vec<Vec<f64>> {
    let number = |text: &str| text.parse().unwrap_or(f64::NAN);
    table
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(number).collect())
        .collect()
}

#[test]
fn warm_starts_reach_what_cold_ones_do_in_fewer_iterations_whatever_the_timing() {
    let sweep = SWEEP.replace(
        "[best]",
        "keep = \"patterns\"\n[set]\n\"stop.iterations\" = 150\n\"stop.change\" = 0\n[best]",
    );
    let bench = Bench::new(&sweep);
    bench.whole("cold", 2);
    bench.write(
        "sweep.toml",
        &format!("{sweep}\n[warm_start]\niterations = 70\n"),
    );
    bench.whole("warm", 2);
    bench.whole("one", 1);
    assert_eq!(bench.table("warm"), bench.table("one"));
    for number in 1..=2 {
        run(
            &bench.plan("shares"),
            Some(Shard { number, shares: 2 }),
            &mut Told::default(),
            &Work::new(),
        )
        .unwrap();
    }
    merge(&bench.plan("shares"), &[]).unwrap();
    assert_eq!(bench.table("warm"), bench.table("shares"));
    let (cold, warm) = (rows(&bench.table("cold")), rows(&bench.table("warm")));
    let initial = initial_losses(&bench, "cold");
    let (mut cold_steps, mut warm_steps) = (0.0, 0.0);
    for ((cold, warm), initial) in cold.iter().zip(&warm).zip(initial) {
        let [cold_loss, warm_loss] = [cold, warm].map(|row| row[6]);
        let near = (cold_loss - warm_loss).abs() <= (0.01 * cold_loss).max(1e-6 * initial);
        assert!(
            near,
            "loss {warm_loss} in place of {cold_loss}, {initial} at the start"
        );
        // Where a loss reaches 0 many patterns do, with windows of their own
        let is_unique = cold_loss > 1e-6 * initial;
        assert!(
            !is_unique || (cold[5] - warm[5]).abs() < 0.005,
            "PW {} in place of {}",
            warm[5],
            cold[5]
        );
        cold_steps += cold[7];
        warm_steps += warm[7];
    }
    assert!(
        warm_steps < 0.6 * cold_steps,
        "{warm_steps} of {cold_steps} iterations"
    );
    // A run a step ahead of its neighbors is its job, as any other
    let plan = bench.plan("warm");
    let ahead = plan.runs.iter().position(|run| run.continues).unwrap();
    let (folder, alone) = (plan.run_folder(ahead), bench.path("alone"));
    let job = Job::read(&folder.join("job.toml"), &[]).unwrap();
    let continued = job.document.root.pointer("/start/patterns/continued");
    assert_eq!(continued, Some(&Value::Bool(true)));
    let job = job.with_folder(&alone, "test");
    run_leaving(&job, false, Leaves::Patterns, &mut Silent, &Work::new()).unwrap();
    let patterns = |folder: &Path| fs::read(folder.join("patterns.npz")).unwrap();
    assert!(patterns(&folder) == patterns(&alone), "patterns differ");
}

#[test]
fn distances_of_surfaces_are_measured_where_they_are_collected() {
    let bench = Bench::new(SWEEP);
    let best = |folder: &str| bench.read(&format!("{folder}/best.toml"));
    bench.whole("without", 2);
    let with = SWEEP.replace("\"history.loss\"", "\"evaluation.surface_mean_mm\"");
    bench.write("sweep.toml", &with);
    bench.whole("with", 2);
    let [without, with] = ["without", "with"].map(|folder| {
        let reports = bench.reports(folder);
        reports
            .into_values()
            .map(|text| comparable(&text))
            .collect::<Vec<_>>()
    });
    // Folders are named by their jobs, which differ: the same six prints in another order
    let distance = |report: &Value| report["evaluation"]["surface_mean_mm"].clone();
    assert!(without.iter().all(|report| distance(report).is_null()));
    assert!(with.iter().all(|report| distance(report).is_number()));
    let numbers = |reports: &[Value]| {
        let number = |report: &Value| {
            let evaluation = &report["evaluation"];
            [
                &evaluation["pw"],
                &evaluation["iou"],
                &report["history"]["loss"],
            ]
            .map(Value::to_string)
        };
        reports
            .iter()
            .map(number)
            .collect::<std::collections::BTreeSet<_>>()
    };
    assert_eq!(numbers(&without), numbers(&with));
    assert!(
        best("without").contains("surfaces = true") && best("with").contains("surfaces = true")
    );
}

#[test]
fn a_case_is_one_value_of_an_axis_and_sets_several_keys() {
    let cases = r#"
job = "job.toml"
metrics = ["optimization.pw", "history.iterations"]
[best]
highest = "optimization.pw"
[[axes]]
name = "method"
cases = [
    { name = "as it is" },
    { name = "osmo", set = { optimizer = { osmo = {} }, objective = { osmo = {} }, "stop.iterations" = 3 } },
]
[[axes]]
key = "evaluate.bit_depth"
values = [8, 12]
"#;
    let bench = Bench::new(cases);
    let outcome = bench.whole("cases", 2);
    assert_eq!((outcome.runs, outcome.done), (4, 4));
    let rows = bench.table("cases");
    let rows: Vec<Vec<&str>> = rows
        .lines()
        .skip(1)
        .map(|row| row.split(',').collect())
        .collect();
    let columns = rows.iter().map(|row| (row[1], row[2], row[5]));
    assert_eq!(
        columns.collect::<Vec<_>>(),
        [
            ("as it is", "8", "8"),
            ("as it is", "12", "8"),
            ("osmo", "8", "3"),
            ("osmo", "12", "3")
        ]
    );
    for (from, to, expected) in [
        (
            "osmo = {} }, obj",
            "osmoo = {} }, obj",
            "axes[0].cases[1].set.optimizer",
        ),
        (
            "evaluate.bit_depth",
            "stop.iterations",
            "axes[1]: `stop.iterations` of axes[0] once more",
        ),
    ] {
        let message = bench.refusal(&cases.replace(from, to));
        assert!(message.contains(expected), "{message}");
    }
}

/// The loss before the first iteration of each run.
fn initial_losses(bench: &Bench, folder: &str) -> Vec<f64> {
    let plan = bench.plan(folder);
    // Without a warm start: the identities of the cold sweep
    let sweep = bench.read("sweep.toml");
    let cold = sweep.split("[warm_start]").next().unwrap().to_owned();
    bench.write("cold.toml", &cold);
    let cold = bench.planned("cold.toml", folder).unwrap();
    let first = |i: usize| {
        let history = fs::read_to_string(cold.run_folder(i).join("history.csv")).unwrap();
        history
            .lines()
            .nth(1)
            .unwrap()
            .split(',')
            .nth(1)
            .unwrap()
            .parse()
            .unwrap()
    };
    (0..plan.runs.len()).map(first).collect()
}

#[test]
fn no_list_has_warm_starts() {
    let bench = Bench::new(&format!("keep = \"all\"\n{SWEEP}\n[warm_start]\n"));
    let message = bench.plan("out").commands().unwrap_err().to_string();
    assert!(
        message.starts_with("--list: a list has no order"),
        "{message}"
    );
}

#[test]
fn a_sweep_that_cannot_be_is_refused_before_any_run() {
    let bench = Bench::new(SWEEP);
    let axis = |text: &str| format!("job = \"job.toml\"\n[[axes]]\n{text}\n");
    for (sweep, expected) in [
        (
            axis("key = \"objective.ospw.lwer\"\nvalues = [0.1]"),
            "axes[0].key: `objective.ospw.lwer`: … did you mean `lower`? … line 3",
        ),
        (
            axis("key = \"light[3].angles\"\nvalues = [12]"),
            "axes[0].key: … has 1 element",
        ),
        (
            axis("key = \"objective.ospw.lower\"\nvalues = []"),
            "axes[0].values: an empty list … line 4",
        ),
        (
            axis("key = \"stop.iterations\"\nlog = { from = 10, to = 90, count = 4 }"),
            "axes[0].key: `stop.iterations`: found 10.0 … accepted: a whole number, 0 or more (a range with whole = true rounds its values)",
        ),
        (
            axis(
                "key = \"stop.iterations\"\nlinear = { from = 0, to = 9 }\n[sample.random]\ncount = 2",
            ),
            "(a range with whole = true rounds its values)",
        ),
        (
            axis("kee = \"a\""),
            "axes[0].kee … did you mean `key`? … line 3",
        ),
        (
            SWEEP.replace("job = ", "# job = "),
            "job: the key is missing … job = \"job.toml\"",
        ),
        (
            format!("{SWEEP}[set]\n\"objective.ospw.lower\" = 0.4\n"),
            "axes[0]: `objective.ospw.lower` of this axis takes the place of `objective.ospw.lower` in [set] … bad.toml, line",
        ),
        (
            SWEEP.replace("lower < upper", "lowr < upper"),
            "when[0]: `lowr` is no axis … did you mean `lower`?",
        ),
        (
            SWEEP.replace("lower < upper", "lower upper"),
            "when[0]: `upper` where a comparison is due",
        ),
        (
            SWEEP.replace("when = [\"lower < upper\"]", ""),
            "axes[0].key: 3 of 9 jobs cannot run; the first is run 4 (lower = 0.5, upper = 0.4): … or leave such runs out with `when`",
        ),
        // Every key at fault, and what is wrong with some runs alone
        (
            SWEEP.replace("when = [\"lower < upper\"]", "")
                + "[set]\n\"evaluate.bit_depth\" = 40\n\"output.rpm\" = 0\n",
            "set.evaluate.bit_depth: … set.output.rpm: ",
        ),
        (
            SWEEP.replace("\"optimization.pw\"", "\"evaluation.pw\""),
            "metrics[1]: `evaluation.pw` again … each metric once",
        ),
        (
            SWEEP.replace("\"evaluation.pw\"", "\"evaluation.pww\""),
            "metrics[0]: `evaluation.pww` is in no report.json … did you mean `evaluation.pw`?",
        ),
        (
            format!("{SWEEP}[set]\n\"resources.memory_gb\" = 1\n"),
            "set.resources.memory_gb: … its share of the memory",
        ),
        (
            format!("guides = [\"5 = 5\"]\n{SWEEP}"),
            "guides[0]: no axis in \"5 = 5\"",
        ),
        (
            format!("guides = [\"lower 0.5\"]\n{SWEEP}"),
            "guides[0]: no `=` in \"lower 0.5\" … lower = 0.75*upper",
        ),
        (
            format!("guides = [\"lower = above\"]\n{SWEEP}"),
            "guides[0]: `above` is no axis … lower, upper",
        ),
        (SWEEP.replace("job.toml", "jb.toml"), "job: … jb.toml"),
        (
            SWEEP.replace("\"history.loss\"", "\"history.lost\""),
            "metrics[2]: `history.lost` is in no report.json … did you mean `history.loss`?",
        ),
        (
            format!("{SWEEP}[best]\n"),
            "file: duplicate key … bad.toml, line 13",
        ),
        (
            format!("{SWEEP}[warm_start]\n"),
            "warm_start: … keep = \"patterns\"",
        ),
        (
            format!("{SWEEP}[derived]\n\"objective.ospw.upper\" = \"lower + 0.1\"\n"),
            "derived.objective.ospw.upper: axes[1] sets this key, too",
        ),
        (
            format!("{SWEEP}[derived]\n\"bounds.max\" = \"1 / (lower - 0.3)\"\n"),
            "derived.bounds.max: inf at lower = 0.3",
        ),
        (
            format!("{SWEEP}[resources]\nside_by_side = 0\n"),
            "resources.side_by_side: found 0",
        ),
        (
            format!("{SWEEP}[[axes]]\nkey = \"objective.ospw.upper\"\nvalues = [1]\n"),
            "axes[2]: `upper` of axes[1] once more",
        ),
    ] {
        let message = bench.refusal(&sweep);
        for part in expected.split('…').map(str::trim) {
            assert!(message.contains(part), "{part} is not in: {message}");
        }
    }
    assert!(!bench.path("bad").exists());
}

#[test]
fn results_that_would_go_into_a_file_are_refused_before_work() {
    let bench = Bench::new(SWEEP);
    for folder in ["job.toml", "job.toml/results"] {
        let refused = bench.refused("sweep.toml", folder);
        assert!(
            refused.starts_with("folder: ") && refused.contains("job.toml` is a file"),
            "{refused}"
        );
    }
}

#[test]
fn a_folder_of_a_run_that_is_taken_is_blamed_and_no_axis() {
    let bench = Bench::new(SWEEP);
    let folder = bench.plan("out").run_folder(2);
    fs::create_dir_all(folder.parent().unwrap()).unwrap();
    fs::write(&folder, "mine").unwrap();
    let message = bench.refused("sweep.toml", "out");
    let start = format!(
        "folder: `{}` is no folder (from --output {}); accepted: for a run a new",
        folder.display(),
        bench.path("out").display()
    );
    assert!(message.starts_with(&start), "{message}");
    fs::create_dir(bench.path("other")).unwrap();
    bench.write("other/runs", "mine");
    let message = bench.refused("sweep.toml", "other");
    assert!(message.contains("other/runs` is a file"), "{message}");
}

#[test]
fn a_thousand_million_runs_are_refused_with_their_time() {
    let thousand = |(key, from): (&str, f64)| {
        format!("[[axes]]\nkey = \"{key}\"\nlinear = {{ from = {from}, to = 2, count = 1000 }}\n")
    };
    let keys = [
        ("objective.ospw.lower", 0.5),
        ("objective.ospw.upper", 0.9),
        ("objective.ospw.w", 0.0),
    ];
    let sweep = format!("job = \"job.toml\"\n{}", keys.map(thousand).concat());
    let message = Bench::new(SWEEP).refusal(&sweep);
    assert!(
        message.starts_with("axes: 1000000000 runs of about "),
        "{message}"
    );
    // How long one run takes is the machine's own; a thousand million of them never end today.
    assert!(
        message.contains(" days") || message.contains(" years"),
        "{message}"
    );
    assert!(message.contains("accepted: 100000 runs"), "{message}");
}

#[test]
fn a_job_that_is_wrong_by_itself_is_refused_at_its_own_line() {
    let bench = Bench::new(SWEEP);
    bench.write("job.toml", &JOB.replace("iterations", "iteratons"));
    let message = bench.refusal(SWEEP);
    assert!(
        message.starts_with("stop.iteratons: ")
            && message.contains(&format!("({}", bench.path("job.toml").display())),
        "{message}"
    );
}

#[test]
fn points_that_are_drawn_are_runs_like_others() {
    let sweep = r#"
job = "job.toml"
metrics = ["history.iterations", "evaluation.ver"]
[sample]
latin_hypercube = { count = 4, seed = 7 }
[derived]
"objective.ospw.w" = "(1 - lower)/10"
[[axes]]
key = "objective.ospw.lower"
linear = { from = 0.3, to = 0.6 }
[[axes]]
key = "stop.iterations"
log = { from = 2, to = 9, whole = true }
"#;
    let bench = Bench::new(sweep);
    let outcome = bench.whole("out", 2);
    assert_eq!(outcome.done, 4);
    let plan = bench.plan("out");
    for (i, row) in rows(&bench.table("out")).iter().enumerate() {
        let job = plan.job(i).unwrap();
        assert_eq!(job.spec.stop.iterations as f64, row[2]);
        assert!(row[4] <= row[2], "{row:?}");
        let w = job.spec.objective.as_ref().unwrap()["ospw"]["w"]
            .as_f64()
            .unwrap();
        assert!((w - (1.0 - row[1]) / 10.0).abs() < 1e-12);
    }
    let svg = bench.read("out/evaluation.ver.svg");
    assert!(svg.matches("<circle class=\"dot\"").count() == 8, "{svg}");
    assert!(Path::new(&outcome.folder).join("best.toml").is_file());
}

#[test]
fn prints_in_time_are_swept_as_any_other_run() {
    let bench = Bench::new(
        r#"
job = "job.toml"
metrics = ["time[0].best_s", "time[0].best_jaccard", "time[0].evaluation.iou", "time[0].ideal_exposure_s"]
[[axes]]
key = "schedule.seconds_per_turn"
values = [2.0, 6.0]
[best]
lowest = "time[0].best_s"
"#,
    );
    let schedule = r#"
schedule = { turns = 8, power = { energy_per_turn_mj_per_mm2 = 0.25 } }
[[material.photopolymer.networks]]
name = "resin"
curing = { threshold = { critical_dose_mj_per_mm3 = 0.5 } }
inhibitors = [{ capacity_mj_per_mm3 = 0.25, diffusion_mm2_per_s = 1e-4 }]
"#;
    bench.write("job.toml", &format!("{JOB}{schedule}"));
    bench.whole("a", 1);
    let table = bench.table("a");
    let mut rows = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().unwrap();
    let column = |name: &str| names.iter().position(|found| *found == name).unwrap();
    let rows: Vec<_> = rows.collect();
    let number = |row: usize, name: &str| rows[row][column(name)].parse::<f64>().unwrap();
    for row in [0, 1] {
        let (jaccard, iou) = (
            number(row, "time[0].best_jaccard"),
            number(row, "time[0].evaluation.iou"),
        );
        assert!(jaccard > 0.5 && (jaccard - iou).abs() < 1e-6, "{table}");
    }
    // The same energy in three times the time: oxygen that flows back makes it a little longer still
    let ratio = number(1, "time[0].best_s") / number(0, "time[0].best_s");
    assert!((2.5..4.0).contains(&ratio), "{table}");
}
