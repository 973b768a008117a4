//! Where the power of light goes, for every tracer.

use serde::Serialize;

/// Power balance of a ray; all parts add up to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PowerBalance {
    /// Taken by the resin, active or not.
    pub absorbed: f64,
    /// Taken by a bath before the vial.
    pub bath: f64,
    /// Reflected at walls and not followed.
    pub reflected: f64,
    /// Left the vial after it had passed resin.
    pub transmitted: f64,
    /// Never met resin.
    pub missed: f64,
    /// Ended at a black body.
    pub blocked: f64,
    /// Given up as too weak; what Russian roulette adds to others is taken off.
    pub dropped: f64,
    /// Given up at a limit: too many interfaces, or scattered too often.
    pub cut: f64,
}

impl PowerBalance {
    /// Sum of all entries.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.absorbed
            + self.bath
            + self.reflected
            + self.transmitted
            + self.missed
            + self.blocked
            + self.dropped
            + self.cut
    }

    /// Adds another balance, `share` times.
    pub fn add(&mut self, other: &PowerBalance, share: f64) {
        self.absorbed += share * other.absorbed;
        self.bath += share * other.bath;
        self.reflected += share * other.reflected;
        self.transmitted += share * other.transmitted;
        self.missed += share * other.missed;
        self.blocked += share * other.blocked;
        self.dropped += share * other.dropped;
        self.cut += share * other.cut;
    }
}
