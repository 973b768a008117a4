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
use std::path::PathBuf;
use tomolith::Result;
use tomolith::job::{Document, Job, Progress, Summary, run};
use tomolith::models::Run;

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

/// A finished run; its folder goes with it.
struct Finished {
    place: tempfile::TempDir,
    summary: Summary,
}

impl Finished {
    fn run(job: Job, progress: &mut dyn Progress) -> Self {
        let place = tempfile::tempdir().unwrap();
        let job = job.with_folder(&place.path().join("run"), "--output");
        let summary = run(&job, false, progress, &Run::new()).unwrap();
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
