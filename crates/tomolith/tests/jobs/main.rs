//! Whole jobs, as another program runs them: stopped and resumed, on several ranks, in time, in two colors. One program, so that it is linked once.

mod bclp_orderings;
mod co_optimize;
mod drawn;
mod foreign_model;
mod in_time;
mod layers;
mod light_in_time;
mod peers;
mod print_time;
mod ranks;
mod resume;
mod two_colors;
mod two_machines;

use serde_json::Value;
use std::path::{Path, PathBuf};
use tomolith::Result;
use tomolith::job::{Document, Event, Job, Progress, Summary, run};
use tomolith::models::Work;

/// A job of this text with keys set otherwise.
fn job_of(text: &str, changes: &[impl AsRef<str>]) -> Result<Job> {
    let changes: Vec<String> = changes.iter().map(|c| c.as_ref().to_owned()).collect();
    Job::changed(Document::toml("job.toml", text)?, &changes)
}

/// What sets the target of a job to an image of the examples.
fn image(key: &str, name: &str) -> String {
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/images");
    format!("{key}=\"{examples}/{name}\"")
}

/// A ball of 1.2 mm in a resin whose critical dose is known, without light.
const BALL: &str = r#"
    target = { phantom = { sphere = {} }, size_mm = 1.2 }
    grid = { pitch_mm = 0.1 }
    resin = { refractive_index = 1.5, absorption_per_mm = 0.1, critical_dose_mj_per_mm3 = 0.5 }
    vial = { index_matched = { radius_mm = 1.0 } }
    evaluate = { refine = 1, sub_angles = 1 }
"#;

/// What lights it from 12 sides.
const LIGHT: &str = r#"
    light = [{ pixels = [20, 16], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
"#;

/// Asks a run to stop after an iteration.
struct StopAfter<'r>(usize, &'r Work);

impl Progress for StopAfter<'_> {
    fn event(&mut self, event: &Event) {
        if matches!(event, Event::Iteration { iteration, .. } if *iteration == self.0) {
            self.1.cancel();
        }
    }
}

/// Columns of the history of a run, row by row.
fn history<const N: usize>(folder: &Path, names: [&str; N]) -> Vec<[String; N]> {
    let text = std::fs::read_to_string(folder.join("history.csv")).unwrap();
    let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = rows.next().unwrap();
    let columns = names.map(|name| head.iter().position(|other| *other == name).unwrap());
    rows.map(|row| columns.map(|column| row[column].to_owned()))
        .collect()
}

fn losses(folder: &Path) -> Vec<f64> {
    let rows = history(folder, ["loss"]).into_iter();
    rows.map(|[loss]| loss.parse().unwrap()).collect()
}

/// A finished run; its folder goes with it.
struct Finished {
    place: tempfile::TempDir,
    summary: Summary,
}

impl Finished {
    fn run(job: Job, progress: &mut dyn Progress) -> Self {
        let place = tempfile::tempdir().unwrap();
        let job = job.with_folder(&place.path().join("run"), "--output");
        let summary = run(&job, false, progress, &Work::new()).unwrap();
        Finished { place, summary }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.place.path().join("run").join(name)
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap()
    }

    fn report(&self) -> Value {
        serde_json::from_str(&self.read("report.json")).unwrap()
    }
}
