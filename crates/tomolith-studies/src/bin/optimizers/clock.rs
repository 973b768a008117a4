//! Processor time of this process: what other programs on the machine take does not count.

use std::time::Instant;

/// Runs from its making; what happens between [`pause`](Clock::pause) and [`resume`](Clock::resume) is left out.
pub(crate) struct Clock {
    counted: f64,
    since: f64,
    begin: Instant,
}

impl Clock {
    pub(crate) fn new() -> Self {
        let begin = Instant::now();
        Clock {
            counted: 0.0,
            since: now(begin),
            begin,
        }
    }

    /// Stops, and says the seconds so far, those of all threads added.
    pub(crate) fn pause(&mut self) -> f64 {
        self.counted += now(self.begin) - self.since;
        self.counted
    }

    pub(crate) fn resume(&mut self) {
        self.since = now(self.begin);
    }
}

/// Nanoseconds that each thread ran, as Linux counts them; elsewhere the time on the wall.
fn now(begin: Instant) -> f64 {
    cpu_seconds().unwrap_or_else(|| begin.elapsed().as_secs_f64())
}

fn cpu_seconds() -> Option<f64> {
    let threads = std::fs::read_dir("/proc/self/task").ok()?;
    let nanoseconds = threads.map(|thread| {
        let text = std::fs::read_to_string(thread.ok()?.path().join("schedstat")).ok()?;
        text.split(' ').next()?.parse::<u64>().ok()
    });
    Some(nanoseconds.sum::<Option<u64>>()? as f64 / 1e9)
}
