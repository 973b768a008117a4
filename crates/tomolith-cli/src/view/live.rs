//! A run that is watched while it goes on: what it says goes to the screen and to the page.

use super::server::Server;
use super::site::Site;
use super::{Address, tell};
use crate::arguments::Manner;
use crate::screen::Screen;
use serde_json::json;
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tomolith::grid::VolumeGrid;
use tomolith::job::{Event, Job, Progress, Snapshot, Wants};
use tomolith::models::Work;
use tomolith::optimize::MeasuredPrint;
use tomolith::report::page::{served_response, served_target};
use tomolith::{Error, Result};

/// Copies of the dose are taken at most this often.
const PAUSE: Duration = Duration::from_millis(1500);

/// What becomes of a run that is canceled.
const CANCELED: &str = "The run was canceled and the command has ended. The same command with `--resume` goes on from the checkpoint, where it has left one.";

/// See the [module page](self).
pub(crate) struct Live {
    screen: Screen,
    site: Arc<Site>,
    server: Server,
    last: Option<Instant>,
    /// The voxels whose target the page has.
    known: Option<VolumeGrid>,
}

impl Live {
    /// Serves a page for a run of this job.
    pub(crate) fn start(
        job: &Job,
        address: Address,
        manner: Manner,
        work: &Arc<Work>,
    ) -> Result<Self> {
        let text = job.complete().to_toml()?;
        let site = Arc::new(Site::of_job(&job.spec.target.name(), &text, work));
        let server = Server::start(&site, address.port)?;
        tell(&server, address, manner);
        Ok(Live {
            screen: Screen::new(manner),
            site,
            server,
            last: None,
            known: None,
        })
    }

    /// What is shown on the screen.
    pub(crate) fn screen(&mut self) -> &mut Screen {
        &mut self.screen
    }

    /// Shows the finished run until the command is stopped.
    pub(crate) fn finish(self, folder: &Path, work: &Work) -> Result<()> {
        self.site.finish(folder)?;
        self.server.serve_until(work);
        Ok(())
    }

    /// Tells pages that the run has ended without a result, and why.
    pub(crate) fn fail(self, error: &Error) {
        match error {
            Error::Canceled => self.site.fail("canceled", CANCELED),
            error => self.site.fail("failed", &error.to_string()),
        }
        self.server.end();
    }
}

impl Progress for Live {
    fn event(&mut self, event: &Event) {
        self.screen.event(event);
        let message = match event {
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
                forward_calls,
                adjoint_calls,
                print,
                elapsed_s,
                ..
            } => {
                let number_of =
                    |number: fn(&MeasuredPrint) -> Option<f64>| print.as_ref().and_then(number);
                let row = json!({
                    "iteration": iteration, "loss": loss, "projected_gradient": projected_gradient, "seconds": elapsed_s,
                    "forward_calls": forward_calls, "adjoint_calls": adjoint_calls, "iou": number_of(|print| print.iou), "process_window": number_of(|print| print.process_window),
                });
                self.site.add_row(&row);
                json!({ "type": "iteration", "run": 0, "row": row, "iterations": iterations })
            }
            Event::Note { text } => json!({ "type": "note", "run": 0, "text": text }),
            Event::Warning { text } => json!({ "type": "warning", "run": 0, "text": text }),
        };
        self.site.tell(&message);
    }

    fn wants(&self) -> Wants {
        let is_due = self.last.is_none_or(|last| last.elapsed() >= PAUSE);
        Wants {
            print: is_due,
            target: is_due,
            ..Wants::default()
        }
    }

    fn snapshot(&mut self, snapshot: Snapshot) {
        self.last = Some(Instant::now());
        let is_one = snapshot.target.len() == 1;
        for (i, (print, asked)) in snapshot.print.iter().zip(&snapshot.target).enumerate() {
            let name = Some(asked.species.as_str()).filter(|_| !is_one);
            if self.known.as_ref() != Some(&print.grid) {
                let (inside, labels) = (&asked.inside, &asked.labels);
                self.site.show(served_target(i, name, inside, labels));
                asked
                    .band
                    .into_iter()
                    .for_each(|band| self.site.set_band(band));
            }
            self.site
                .show(served_response(i, name, asked.quantity, print));
        }
        self.known = snapshot.print.first().map(|print| print.grid.clone());
        self.site
            .tell(&json!({ "type": "snapshot", "run": 0, "iteration": snapshot.iteration }));
    }
}
