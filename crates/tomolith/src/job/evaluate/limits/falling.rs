//! Whether the loss function was still falling when the optimization ended.

use crate::optimize::{Row, StopReason};
use crate::report::number::significant;
use crate::units::counted;
use std::fmt;

/// A loss function that fell by more than this share over the last quarter of the iterations had not come to rest.
const STILL_FALLING: f64 = 0.01;

/// By which share a loss function fell over the last quarter of the iterations.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Fall {
    /// 1 − the last loss / the one before these iterations.
    pub share: f64,
    /// How many iterations these are.
    pub last: usize,
    /// How many there were.
    pub all: usize,
}

impl Fall {
    /// None for a history too short, and where the loss rose: thresholds that moved, or a method that does not descend it.
    pub(crate) fn of(history: &[Row]) -> Option<Self> {
        let end = history.last()?;
        let last = end.iteration.div_ceil(4);
        let before = history
            .iter()
            .find(|row| row.iteration == end.iteration - last)?;
        let share = 1.0 - end.loss / before.loss;
        let all = end.iteration;
        // Where no step lowered the loss, the history says nothing about more steps
        let has_fallen = end.loss < history.first()?.loss;
        (last > 0 && share >= 0.0 && has_fallen).then_some(Fall { share, last, all })
    }

    /// Whether more iterations would hardly lower the loss.
    #[must_use]
    pub fn has_converged(&self) -> bool {
        self.share <= STILL_FALLING
    }
}

impl fmt::Display for Fall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let not = if self.has_converged() { "" } else { "not " };
        let percent = significant(100.0 * self.share, 2);
        let last = match self.last {
            1 => "iteration".to_owned(),
            many => counted(many, "iteration"),
        };
        write!(
            f,
            "{not}converged: the loss fell by {percent} % in the last {last}"
        )
    }
}

/// A loss function that was still falling when the optimization ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Falling {
    pub(crate) fall: Fall,
    /// The key of the limit that was reached.
    pub(crate) key: &'static str,
}

impl Falling {
    pub(crate) fn of(reason: StopReason, history: &[Row]) -> Option<Self> {
        let key = match reason {
            StopReason::Iterations => "stop.iterations",
            StopReason::WallTime => "stop.wall_s",
            _ => return None,
        };
        let fall = Fall::of(history)?;
        (!fall.has_converged()).then_some(Falling { fall, key })
    }
}
