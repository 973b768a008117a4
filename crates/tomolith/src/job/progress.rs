//! What a run says while it works. The library never prints: a [`Progress`] does, in its own way.

use serde::Serialize;

/// Something worth telling.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum Event {
    /// A stage of the run begins: reading the target, optimising, evaluating, …
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
    /// An iteration of the optimiser has ended.
    Iteration {
        /// Counted from 1; 0 is the start.
        iteration: usize,
        /// The most there will be.
        iterations: usize,
        /// The loss.
        loss: f64,
        /// Norm of the projected gradient, relative to the first; none at the start.
        projected_gradient: Option<f64>,
        /// Seconds since the optimisation began.
        elapsed_s: f64,
        /// Voxel-angle updates per second of model time.
        updates_per_s: f64,
    },
    /// Part of a long stage is done.
    Part {
        /// How much, 0 to 1.
        done: f64,
    },
}

/// Where the events of a run go.
pub trait Progress {
    /// Called for each event, in order, from the thread that runs the job.
    fn event(&mut self, event: &Event);
}

/// Tells nobody.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn event(&mut self, _: &Event) {}
}
