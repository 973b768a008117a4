//! What long work carries along: a way to be stopped, and a gauge of how much is done.

use crate::error::{Error, Result};
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// The whole of a stage on the gauge.
const WHOLE: u64 = 1 << 52;

/// What long work carries along: a way to be stopped, and a gauge of how much of the stage at hand is done.
///
/// Work is cut into [`part`](Work::part)s, each with its share of the whole, and counted in [`steps`](Work::steps) where a part
/// is not cut further. Parts may run side by side. What a part did not count is done when it is dropped, so the gauge never
/// falls, and a stage that ends has filled it.
///
/// An optimization is *patient*: the first request ends it after the step at hand, so that nothing is lost, unless that takes
/// longer than [`PATIENCE`](Work::PATIENCE); then, or at a second request, the step is broken into.
///
/// ```
/// use tomolith_core::dose::Work;
/// let work = Work::new();
/// let stage = work.stage();
/// let reading = stage.part(0.5);
/// let steps = reading.steps(4);
/// steps.add(1);
/// assert_eq!(work.done(), 0.125); // a quarter of one half
/// drop(reading);
/// assert_eq!(work.done(), 0.5);
/// work.cancel();
/// assert!(stage.check().is_err());
/// ```
#[derive(Debug)]
pub struct Work {
    signal: Arc<Signal>,
    gauge: Arc<AtomicU64>,
    /// Of the gauge: how much this part is, and how much of it is done or given to its parts.
    share: u64,
    used: AtomicU64,
}

#[derive(Debug)]
struct Signal {
    requests: AtomicU32,
    /// When the first request came.
    first: OnceLock<Instant>,
    patient: AtomicBool,
    patience: Duration,
}

impl Default for Work {
    fn default() -> Self {
        Work::with_patience(Work::PATIENCE)
    }
}

impl Work {
    /// How long the first request waits for the end of what is done patiently.
    pub const PATIENCE: Duration = Duration::from_millis(400);

    /// Work without a request to stop.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Work whose first request waits so long for the end of what is done patiently.
    #[must_use]
    pub fn with_patience(patience: Duration) -> Self {
        Work {
            signal: Arc::new(Signal {
                requests: AtomicU32::new(0),
                first: OnceLock::new(),
                patient: AtomicBool::new(false),
                patience,
            }),
            gauge: Arc::default(),
            share: WHOLE,
            used: AtomicU64::new(0),
        }
    }

    /// Requests a stop of everything that carries this work; returns the number of earlier requests.
    pub fn cancel(&self) -> u32 {
        self.signal.first.get_or_init(Instant::now);
        self.signal.requests.fetch_add(1, Ordering::Relaxed)
    }

    /// Whether a stop was requested.
    #[must_use]
    pub fn is_stop_asked(&self) -> bool {
        self.signal.requests.load(Ordering::Relaxed) > 0
    }

    /// Whether work must stop now, in the middle of what it does.
    #[must_use]
    pub fn is_canceled(&self) -> bool {
        match self.signal.requests.load(Ordering::Relaxed) {
            0 => false,
            1 if self.signal.patient.load(Ordering::Relaxed) => self.patience_left().is_zero(),
            _ => true,
        }
    }

    /// How long what is done patiently may still take; without a request as long as with one that comes now.
    #[must_use]
    pub fn patience_left(&self) -> Duration {
        let waited = self
            .signal
            .first
            .get()
            .map_or(Duration::ZERO, Instant::elapsed);
        self.signal.patience.saturating_sub(waited)
    }

    /// Refuses to go on when work must stop now.
    ///
    /// # Errors
    /// [`Error::Canceled`].
    pub fn check(&self) -> Result<()> {
        if self.is_canceled() {
            Err(Error::Canceled)
        } else {
            Ok(())
        }
    }

    /// Whether the first request may wait for the end of the step at hand.
    pub fn set_patient(&self, patient: bool) {
        self.signal.patient.store(patient, Ordering::Relaxed);
    }

    /// The whole of a new stage: the gauge begins at 0.
    #[must_use]
    pub fn stage(&self) -> Work {
        self.gauge.store(0, Ordering::Relaxed);
        self.of_share(WHOLE)
    }

    /// A part of this work, as large a share of it as that; what the parts before it have left at most.
    #[must_use]
    pub fn part(&self, share: f64) -> Work {
        let wanted = (self.share as f64 * share.clamp(0.0, 1.0)).round() as u64;
        self.of_share(self.take(wanted))
    }

    /// Work that is watched, but no part of what is done.
    #[must_use]
    pub fn aside(&self) -> Work {
        self.of_share(0)
    }

    /// Counts this work in so many equal steps.
    #[must_use]
    pub fn steps(&self, count: usize) -> Steps<'_> {
        Steps {
            work: self,
            count: count as u64,
            done: AtomicU64::new(0),
        }
    }

    /// How much of the stage at hand is done, 0 to 1.
    #[must_use]
    pub fn done(&self) -> f64 {
        self.gauge.load(Ordering::Relaxed).min(WHOLE) as f64 / WHOLE as f64
    }

    fn of_share(&self, share: u64) -> Work {
        Work {
            signal: Arc::clone(&self.signal),
            gauge: Arc::clone(&self.gauge),
            share,
            used: AtomicU64::new(0),
        }
    }

    /// Takes so much of the share, or what is left of it.
    fn take(&self, wanted: u64) -> u64 {
        let take = |used: u64| Some((used + wanted).min(self.share));
        let before = self
            .used
            .fetch_update(Ordering::Relaxed, Ordering::Relaxed, take);
        wanted.min(self.share - before.unwrap_or(self.share))
    }

    fn tell(&self, wanted: u64) {
        let share = self.take(wanted);
        self.gauge.fetch_add(share, Ordering::Relaxed);
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.tell(self.share);
    }
}

/// Steps of a piece of work, counted from any thread.
#[derive(Debug)]
pub struct Steps<'r> {
    work: &'r Work,
    count: u64,
    done: AtomicU64,
}

impl Steps<'_> {
    /// Some more are done.
    pub fn add(&self, steps: usize) {
        let before = self.done.fetch_add(steps as u64, Ordering::Relaxed);
        let place = |done: u64| {
            let share = u128::from(self.work.share) * u128::from(done.min(self.count));
            (share / u128::from(self.count.max(1))) as u64
        };
        self.work.tell(place(before + steps as u64) - place(before));
    }

    /// Whether work must stop now.
    #[must_use]
    pub fn is_canceled(&self) -> bool {
        self.work.is_canceled()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rayon::prelude::*;

    #[test]
    fn parts_side_by_side_fill_the_gauge_without_a_step_back() {
        let work = Work::new();
        for _ in 0..2 {
            let stage = work.stage();
            assert_eq!(work.done(), 0.0);
            let parts = [stage.part(0.3), stage.part(0.5), stage.part(0.9)];
            let last = AtomicU64::new(0);
            parts.par_iter().enumerate().for_each(|(i, part)| {
                let steps = part.steps(1000 + i);
                (0..1000).into_par_iter().for_each(|_| {
                    let before = last.load(Ordering::Acquire);
                    steps.add(1);
                    let now = work.done().to_bits();
                    assert!(now >= before, "the gauge fell");
                    last.fetch_max(now, Ordering::Release);
                });
            });
            assert!(work.done() > 0.99 && work.done() < 1.0);
            drop((parts, stage));
            assert_eq!(work.done(), 1.0);
        }
    }

    #[test]
    fn patience_ends_by_itself_or_with_a_second_request() {
        let canceled = |patience: Duration, requests: usize| {
            let work = Work::with_patience(patience);
            work.set_patient(true);
            for _ in 0..requests {
                work.cancel();
            }
            (work.is_stop_asked(), work.is_canceled())
        };
        assert_eq!(canceled(Duration::ZERO, 0), (false, false));
        assert_eq!(canceled(Duration::ZERO, 1), (true, true));
        assert_eq!(canceled(Duration::MAX, 1), (true, false));
        assert_eq!(canceled(Duration::MAX, 2), (true, true));
        // Whoever is not patient stops at once
        let work = Work::with_patience(Duration::MAX);
        work.cancel();
        assert!(work.is_canceled());
    }

    #[test]
    fn what_is_not_counted_is_done_at_the_end_and_nothing_twice() {
        let work = Work::new();
        let stage = work.stage();
        drop(stage.part(0.25));
        assert_eq!(work.done(), 0.25);
        drop(stage.aside());
        assert_eq!(work.done(), 0.25);
        let steps = stage.steps(2);
        steps.add(5); // more than there are
        assert_eq!(work.done(), 1.0);
        assert_eq!(stage.part(0.5).share, 0);
        drop(stage);
        assert_eq!(work.done(), 1.0);
    }
}
