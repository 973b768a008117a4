//! Jobs whose response has unknown parameters: what they find is in every file of the run, and the print is evaluated with it.

use crate::{StopAfter, image, job_of};
use serde_json::Value;
use std::path::Path;
use tomolith::Error;
use tomolith::check::on_threads;
use tomolith::job::{self, Document, Job, Silent};
use tomolith::models::Work;

const JOB: &str = r#"
    target = { size_mm = 1.2, height_mm = 0.02 }
    grid = { pitch_mm = 0.04, refine = 1, shape = [32, 32, 1] }
    resin = { refractive_index = 1.5, absorption_per_mm = 1e-4 }
    vial = { index_matched = { radius_mm = 1.0 } }
    light = [{ pixels = [32, 1], angles = 40, projector = { collimated = { pixel_pitch_mm = 0.04 } } }]
    response = { logistic = { steepness = 10.0 } }
    co_optimize = { response = { steepness = [5.0, 60.0], midpoint = [0.3, 0.7] } }
    objectives = [{ bclp = { epsilon = 0.02 } }]
    stop = { iterations = 12 }
    evaluate = { refine = 1 }
"#;

fn read(changes: &[&str], folder: &Path) -> Result<Job, Error> {
    let image = image("target.image", "rings.png");
    let job = job_of(JOB, &[&[&*image], changes].concat())?;
    Ok(job.with_folder(folder, "--output"))
}

fn report(folder: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(folder.join("report.json")).unwrap()).unwrap()
}

fn text(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap()
}

#[test]
fn what_was_found_is_in_every_file_and_judges_the_print() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("own");
    let job = read(&[], &folder).unwrap();
    let summary = job::run(&job, false, &mut Silent, &Work::new()).unwrap();
    let found = report(&folder);
    let [steepness, midpoint] =
        ["steepness", "midpoint"].map(|name| found["response"][name].as_f64().unwrap());
    assert!(summary.to_string().contains("response found midpoint 0."));
    // The table, and the run's own job
    let history = text(&folder.join("history.csv"));
    let mut lines = history.lines();
    let first = lines.next().unwrap();
    assert!(first.ends_with(",process_window,response.midpoint,response.steepness"));
    let last = lines.next_back().unwrap();
    assert!(
        last.ends_with(&format!(",{midpoint},{steepness}")),
        "{last}"
    );
    let toml = text(&folder.join("job.toml"));
    let line = format!("# Found with the patterns: response.logistic.steepness = {steepness}\n");
    assert!(toml.contains(&line), "{toml}");
    assert!(text(&folder.join("report.html")).contains("Response found"));
    // The same patterns, judged under a job that has the found numbers for its response, print the same
    let fixed = place.path().join("fixed");
    let mut document = Document::toml("again.toml", &toml).unwrap();
    document.root.as_object_mut().unwrap().remove("co_optimize");
    for change in [
        format!("response.logistic.steepness={steepness}"),
        format!("response.logistic.midpoint={midpoint}"),
    ] {
        document.set(&change).unwrap();
    }
    let same = Job::from_document(document)
        .unwrap()
        .with_folder(&fixed, "--output");
    job::simulate(&same, &folder, &mut Silent, &Work::new()).unwrap();
    assert_eq!(report(&fixed)["evaluation"], found["evaluation"]);
    // And so under the run's own job, which takes them from the run
    let again = place.path().join("again");
    let own_job = Document::toml("own.toml", &toml).unwrap();
    let own_job = Job::from_document(own_job)
        .unwrap()
        .with_folder(&again, "--output");
    job::simulate(&own_job, &folder, &mut Silent, &Work::new()).unwrap();
    assert_eq!(report(&again)["evaluation"], found["evaluation"]);
    // Patterns alone do not say which response they are for
    let alone = place.path().join("alone");
    let lone = place.path().join("lone.npz");
    std::fs::copy(folder.join("patterns.npz"), &lone).unwrap();
    let own_job = own_job.with_folder(&alone, "--output");
    job::simulate(&own_job, &lone, &mut Silent, &Work::new()).unwrap();
    assert_ne!(report(&alone)["evaluation"], found["evaluation"]);
    tomolith_core::contains!(report(&alone)["notes"].to_string(), "without [co_optimize]");
    // The run's own job makes the same numbers again
    let rerun = place.path().join("rerun");
    let own_job = own_job.with_folder(&rerun, "--output");
    job::run(&own_job, false, &mut Silent, &Work::new()).unwrap();
    assert_eq!(report(&rerun)["response"], found["response"]);
    assert_eq!(report(&rerun)["evaluation"], found["evaluation"]);
}

/// Rows of the history but the seconds.
fn rows(folder: &Path) -> Vec<Vec<String>> {
    let history = text(&folder.join("history.csv"));
    let row = |line: &str| {
        let cells = line.split(',').enumerate();
        let compared = cells.filter(|(column, _)| *column != 6);
        compared.map(|(_, cell)| cell.to_owned()).collect()
    };
    history.lines().map(row).collect()
}

#[test]
fn a_run_that_was_cut_off_or_has_other_threads_has_the_same_bits() {
    let place = tempfile::tempdir().unwrap();
    let whole = place.path().join("whole");
    let job = read(&[], &whole).unwrap();
    job::run(&job, false, &mut Silent, &Work::new()).unwrap();
    for stop_after in [1, 6] {
        let cut = place.path().join(format!("cut-{stop_after}"));
        let job = read(&[], &cut).unwrap();
        let work = Work::new();
        let stopped = job::run(&job, false, &mut StopAfter(stop_after, &work), &work);
        assert!(matches!(stopped, Err(Error::Canceled)));
        job::run(&job, true, &mut Silent, &Work::new()).unwrap();
        assert_eq!(rows(&cut), rows(&whole), "after {stop_after}");
        assert_eq!(report(&cut)["response"], report(&whole)["response"]);
    }
    for threads in [1, 3] {
        let folder = place.path().join(format!("threads-{threads}"));
        let job = read(&[], &folder).unwrap();
        let work = || job::run(&job, false, &mut Silent, &Work::new());
        on_threads(threads, work).unwrap();
        assert_eq!(rows(&folder), rows(&whole), "{threads} threads");
    }
}

#[test]
fn a_single_value_of_the_range_does_worse() {
    let place = tempfile::tempdir().unwrap();
    let loss = |name: &str, changes: &[&str]| {
        let folder = place.path().join(name);
        let job = read(changes, &folder).unwrap();
        job::run(&job, false, &mut Silent, &Work::new()).unwrap();
        report(&folder)["history"]["loss"].as_f64().unwrap()
    };
    let found = loss("found", &[]);
    for (i, steepness) in [5, 15, 60].into_iter().enumerate() {
        let change = format!("response.logistic.steepness={steepness}");
        let one = "co_optimize={ response = { midpoint = [0.4999, 0.5001] } }";
        let fixed = loss(&i.to_string(), &[&change, one]);
        assert!(found <= 1.01 * fixed, "{steepness}: {found} {fixed}");
    }
}

#[test]
fn what_cannot_be_an_unknown_is_refused_before_work() {
    let place = tempfile::tempdir().unwrap();
    let refused = |changes: &[&str]| {
        let folder = place.path().join("never");
        let job = read(changes, &folder);
        let checked = job.and_then(|job| job::check(&job, &mut Silent, &Work::new()).map(drop));
        checked.unwrap_err().to_string()
    };
    let slips = r#"
        co_optimize.response={ steepnes = [5.0, 60.0] } → co_optimize.response.steepnes: … steepness
        response="identity" → co_optimize.response.midpoint: … [response.logistic]
        co_optimize.response.steepness=[60.0, 5.0] → co_optimize.response.steepness: found [60 … the first below the second
        co_optimize.response.steepness=[0.0, 5.0] → co_optimize.response.steepness: … a number, above 0
        co_optimize.response={ lower = [0.0, 2.0] } → co_optimize.response.lower: … lower < upper
        co_optimize.response.steepness=[5.0] → co_optimize.response.steepness
        co_optimize.response={} → co_optimize.response: … steepness = [
        co_optimize.tolerance=0 → co_optimize.tolerance: found 0 … 0.25
        co_optimize.speed=1 → co_optimize.speed … tolerance
        objectives=[{ bclp = {}, response = "identity" }] → objectives[0].response: … only one of the two
        printer={ time_s = 30.0 } → printer.time_s: … only one of the two
    "#;
    for slip in slips.trim().lines() {
        let (change, expected) = slip.split_once(" → ").unwrap();
        let message = refused(&[change.trim()]);
        for part in expected.split('…') {
            tomolith_core::contains!(message, part.trim());
        }
    }
    let message = refused(&[
        "optimizer={ cal = {} }",
        "target={ phantom = \"gear\", size_mm = 1.0 }",
        "objectives=[{ threshold = {} }]",
    ]);
    tomolith_core::contains!(message, "co_optimize: optimizer.cal", "lbfgs");
}
