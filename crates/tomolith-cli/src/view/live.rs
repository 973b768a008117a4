//! A run that is watched while it goes on: what it says goes to the screen and to the page.

use super::server::Server;
use super::site::Site;
use super::{Address, tell};
use crate::arguments::Manner;
use crate::screen::Screen;
use serde_json::{Value, json};
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tomolith::Result;
use tomolith::job::{Event, Job, Progress, Snapshot, Wants};
use tomolith::models::Run;

/// Copies of the dose are taken at most this often.
const PAUSE: Duration = Duration::from_millis(1500);

/// See the [module page](self).
pub(crate) struct Live {
    screen: Screen,
    site: Arc<Site>,
    server: Server,
    last: Option<Instant>,
}

impl Live {
    /// Serves a page for a run of this job.
    ///
    /// # Errors
    /// [`tomolith::Error::Config`] for a port that is taken.
    pub(crate) fn start(
        job: &Job,
        address: Address,
        manner: Manner,
        cancel: &Arc<Run>,
    ) -> Result<Self> {
        let text = job.complete().to_toml()?;
        let site = Arc::new(Site::of_job(&job.spec.target.name(), &text, cancel));
        let server = Server::start(&site, address.port)?;
        tell(&server, address, manner);
        Ok(Live {
            screen: Screen::new(manner),
            site,
            server,
            last: None,
        })
    }

    /// What is shown on the screen.
    pub(crate) fn screen(&mut self) -> &mut Screen {
        &mut self.screen
    }

    /// Shows the finished run until the command is stopped.
    ///
    /// # Errors
    /// Those of reading the run folder.
    pub(crate) fn finish(self, folder: &Path, cancel: &Run) -> Result<()> {
        self.site.finish(folder)?;
        self.server.serve_until(cancel);
        Ok(())
    }

    /// Says that the run has ended without a result.
    pub(crate) fn fail(&self, message: &str) {
        self.site.fail(message);
    }
}

impl Progress for Live {
    fn event(&mut self, event: &Event) {
        self.screen.event(event);
        let told = match event {
            Event::Stage { name } => {
                json!({ "type": "stage", "run": 0, "name": name, "fraction": null })
            }
            Event::Part { done, left_s } => {
                json!({ "type": "part", "run": 0, "fraction": done, "left_s": left_s })
            }
            Event::Iteration {
                iteration,
                iterations,
                loss,
                projected_gradient,
                elapsed_s,
                ..
            } => {
                let row = json!({
                    "iteration": iteration, "loss": finite(*loss), "projected_gradient": projected_gradient.and_then(finite), "seconds": elapsed_s,
                });
                self.site.add_row(&row);
                json!({ "type": "iteration", "run": 0, "row": row, "iterations": iterations })
            }
            Event::Note { text } => json!({ "type": "note", "run": 0, "text": text }),
            Event::Warning { text } => json!({ "type": "warning", "run": 0, "text": text }),
        };
        self.site.tell(&told);
    }

    fn wants(&self) -> Wants {
        Wants {
            print: self.last.is_none_or(|last| last.elapsed() >= PAUSE),
            ..Wants::default()
        }
    }

    fn snapshot(&mut self, snapshot: Snapshot) {
        self.last = Some(Instant::now());
        for (i, print) in snapshot.print.iter().enumerate() {
            self.site
                .show(&format!("response{i}"), "dose", "response", print);
        }
        self.site
            .tell(&json!({ "type": "snapshot", "run": 0, "iteration": snapshot.iteration }));
    }
}

fn finite(value: f64) -> Option<Value> {
    serde_json::Number::from_f64(value).map(Value::Number)
}
