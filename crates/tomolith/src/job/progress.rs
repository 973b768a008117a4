//! What a run says while it works. The library never prints: a [`Progress`] does, in its own way.

use crate::error::{Error, Result};
use crate::grid::{Patterns, Volume};
use crate::models::Work;
use crate::optimize::MeasuredPrint;
use serde::Serialize;
use std::io::ErrorKind;
use std::panic::resume_unwind;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

/// Something worth telling.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum Event {
    /// A stage of the run begins: reading the target, optimizing, evaluating, …
    Stage {
        /// Its name, for people.
        name: String,
    },
    /// A choice that was made: the model and why, the grid, …
    Note {
        /// One sentence.
        text: String,
    },
    /// Something that may be wrong.
    Warning {
        /// One sentence.
        text: String,
    },
    /// An iteration of the optimizer has ended.
    Iteration {
        /// Counted from 1; 0 is the start.
        iteration: usize,
        /// The most there will be.
        iterations: usize,
        /// The loss.
        loss: f64,
        /// Norm of the projected gradient, relative to the first; none at the start.
        projected_gradient: Option<f64>,
        /// Calls of the model so far: doses, and their adjoints.
        forward_calls: u64,
        /// See there.
        adjoint_calls: u64,
        /// IoU and process window of the print at this iteration; they are measured now and then.
        #[serde(flatten)]
        print: Option<MeasuredPrint>,
        /// Seconds since the optimization began.
        elapsed_s: f64,
        /// Voxel-angle updates per second of model time; voxels that a search leaves out because they cannot cost anything count, too.
        updates_per_s: f64,
    },
    /// Part of a long stage is done.
    Part {
        /// How much, 0 to 1.
        done: f64,
        /// Seconds that the rest will take, if it goes on as fast.
        left_s: Option<f64>,
    },
}

/// Copies that an observer asks for while a run goes on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wants {
    /// The patterns of every light.
    pub patterns: bool,
    /// The dose of every species.
    pub dose: bool,
    /// The response of every species: what the material makes of its dose.
    pub print: bool,
    /// What is asked of every species, on the voxels of its response.
    pub target: bool,
}

impl Wants {
    /// Whether the observer wants any copy.
    #[must_use]
    pub fn any(self) -> bool {
        self.patterns || self.dose || self.print || self.target
    }
}

/// Copies of what a run has at this moment; lists that the observer does not want are empty.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// The iteration, 0 for the start; None for the written patterns while the vial turns, which are evaluated.
    pub iteration: Option<usize>,
    /// Per light.
    pub patterns: Vec<Patterns>,
    /// Per species, on the voxels of the optimization; of the written patterns on those of the job.
    pub dose: Vec<Volume<f32>>,
    /// Per species, on the voxels of the optimization; of the written patterns on those of the evaluation.
    pub print: Vec<Volume<f32>>,
    /// Per species, on the voxels of `print`.
    pub target: Vec<SpeciesTarget>,
}

/// What is asked of a species.
#[derive(Clone, Debug)]
pub struct SpeciesTarget {
    /// Its name; empty where it is the only one.
    pub species: String,
    /// The share of each voxel that is part, or its gray value.
    pub inside: Volume<f32>,
    /// What each voxel counts as ([`label`](crate::target::label)).
    pub labels: Volume<u8>,
    /// What its print is called: `dose`, or `response` where the material has one of its own.
    pub quantity: &'static str,
    /// Half width of the band around gray values; None for a target of part and void.
    pub band: Option<f64>,
}

/// Observer of a run; a closure is one that hears every event.
pub trait Progress {
    /// Called for each event, in order, from the thread that runs the job.
    fn event(&mut self, event: &Event);

    /// Which copies to take at the next iteration, and of what is evaluated in the end. The run calls this after every event; one of several ranks takes no copies.
    fn wants(&self) -> Wants {
        Wants::default()
    }

    /// Called with the copies of [`wants`](Self::wants), after the event of their iteration.
    fn snapshot(&mut self, snapshot: Snapshot) {
        drop(snapshot);
    }
}

impl<F: FnMut(&Event)> Progress for F {
    fn event(&mut self, event: &Event) {
        self(event);
    }
}

/// Discards all events.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn event(&mut self, _: &Event) {}
}

/// What a run can do without: where it cannot be made, it is left out with a warning that says what to change.
///
/// # Errors
/// [`Error::Canceled`]; [`Error::Io`] of the system, such as a full disk.
pub(crate) fn left_out<T>(
    [what, advice]: [&str; 2],
    made: Result<T>,
    progress: &mut dyn Progress,
    warnings: &mut Vec<String>,
) -> Result<Option<T>> {
    let error = match made {
        Ok(made) => return Ok(Some(made)),
        Err(error) => error,
    };
    let found = match &error {
        Error::Canceled => return Err(error),
        Error::Io { source, .. } if source.kind() != ErrorKind::Other => return Err(error),
        // Its file has a name that it will never have
        Error::Format { found, .. } => found.clone(),
        other => other.to_string(),
    };
    let text = format!("{what} is left out: {found}; {advice}");
    warnings.push(text.clone());
    progress.event(&Event::Warning { text });
    Ok(None)
}

/// How often a stage tells how far it is.
const PAUSE: Duration = Duration::from_millis(200);
/// A stage tells what is left from this share on, and after this time: earlier it would guess.
const KNOWN: f64 = 0.02;
const SEEN: Duration = Duration::from_secs(1);

/// Does `action` in a separate thread, while this one reports how far the current stage is. The events of the work are also sent
/// from this thread, and the work waits for that.
pub(crate) fn watched<T: Send>(
    progress: &mut dyn Progress,
    work: &Work,
    action: impl FnOnce(&mut dyn Progress) -> Result<T> + Send,
) -> Result<T> {
    thread::scope(|scope| {
        let (tell, events) = channel();
        let (answer, heard) = channel();
        let wants = progress.wants();
        let worker = scope.spawn(move || action(&mut Relay { tell, heard, wants }));
        let mut gauge = Gauge::new();
        loop {
            match events.recv_timeout(PAUSE) {
                Ok(news) => {
                    match news {
                        News::Event(event) => {
                            gauge.follow(&event, progress);
                            progress.event(&event);
                        }
                        News::Snapshot(snapshot) => progress.snapshot(*snapshot),
                    }
                    // Nobody waits when the work has panicked
                    let _ = answer.send(progress.wants());
                }
                Err(RecvTimeoutError::Timeout) => gauge.tell(work.done(), progress),
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
        let result = worker.join().unwrap_or_else(|panic| resume_unwind(panic));
        if result.is_ok() {
            gauge.end(progress);
        }
        result
    })
}

/// What the work tells.
enum News {
    Event(Event),
    Snapshot(Box<Snapshot>),
}

/// Brings events and copies to the thread that tells them, and back what the observer wants next.
struct Relay {
    tell: Sender<News>,
    heard: Receiver<Wants>,
    wants: Wants,
}

impl Relay {
    fn bring(&mut self, news: News) {
        if self.tell.send(news).is_ok()
            && let Ok(wants) = self.heard.recv()
        {
            self.wants = wants;
        }
    }
}

impl Progress for Relay {
    fn event(&mut self, event: &Event) {
        self.bring(News::Event(event.clone()));
    }

    fn wants(&self) -> Wants {
        self.wants
    }

    fn snapshot(&mut self, snapshot: Snapshot) {
        self.bring(News::Snapshot(Box::new(snapshot)));
    }
}

/// How far the stage at hand is.
struct Gauge {
    begin: Instant,
    /// The share that was reported last, 0 before the first report.
    done: f64,
    /// An optimization tells its iterations instead.
    iterates: bool,
}

impl Gauge {
    fn new() -> Self {
        Gauge {
            begin: Instant::now(),
            done: 0.0,
            iterates: false,
        }
    }

    fn follow(&mut self, event: &Event, progress: &mut dyn Progress) {
        match event {
            Event::Stage { .. } => {
                self.end(progress);
                *self = Gauge::new();
            }
            Event::Iteration { .. } => self.iterates = true,
            _ => {}
        }
    }

    fn tell(&mut self, done: f64, progress: &mut dyn Progress) {
        if self.iterates || done <= self.done {
            return;
        }
        self.done = done;
        let elapsed = self.begin.elapsed();
        let is_known = done >= KNOWN && elapsed >= SEEN;
        let left_s = is_known.then(|| elapsed.as_secs_f64() * (1.0 - done) / done);
        progress.event(&Event::Part { done, left_s });
    }

    /// Ends a stage of which a part has been reported.
    fn end(&mut self, progress: &mut dyn Progress) {
        if self.done > 0.0 {
            self.tell(1.0, progress);
        }
    }
}

/// Begins a stage; what it returns is the whole of it.
pub(crate) fn stage(progress: &mut dyn Progress, work: &Work, name: &str) -> Work {
    let stage = work.stage();
    let name = name.to_owned();
    progress.event(&Event::Stage { name });
    stage
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_tell_how_far_they_are_from_the_callers_thread_and_end_whole() {
        let (work, mut recorded) = (Work::new(), Vec::new());
        let mut record = |event: &Event| recorded.push(event.clone());
        let name = |name: &str| Event::Stage {
            name: name.to_owned(),
        };
        let result = watched(&mut record, &work, |progress| {
            for stage in ["a", "b"] {
                let part = work.stage();
                progress.event(&name(stage));
                let steps = part.steps(4);
                for _ in 0..4 {
                    thread::sleep(PAUSE.mul_f64(1.3));
                    steps.add(1);
                }
            }
            Ok(7)
        });
        assert_eq!(result.unwrap(), 7);
        let stages: Vec<&[Event]> = recorded
            .split(|e| matches!(e, Event::Stage { .. }))
            .collect();
        assert_eq!(stages.len(), 3);
        for stage in &stages[1..] {
            let done: Vec<f64> = (stage.iter())
                .map(|event| match event {
                    Event::Part { done, .. } => *done,
                    other => panic!("{other:?}"),
                })
                .collect();
            assert!(done.len() > 2 && done.is_sorted(), "{done:?}");
            assert_eq!(done.last(), Some(&1.0));
        }
    }

    #[test]
    fn a_panic_of_the_work_is_the_callers() {
        let work =
            || -> Result<()> { watched(&mut Silent, &Work::new(), |_| panic!("of the work")) };
        let panic = std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)).unwrap_err();
        assert_eq!(panic.downcast_ref(), Some(&"of the work"));
    }
}
