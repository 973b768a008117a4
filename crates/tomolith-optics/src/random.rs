//! Random numbers that are frozen: a stream depends on its words alone, not on who draws first.
//!
//! [`SplitMix`] over a state that the words of a path (seed, frame, pixel, ray) are mixed
//! into. A dose model that draws from such streams is one fixed matrix for a seed.
//!
//! ```
//! use tomolith_optics::random::Stream;
//! let draw = |words| Stream::new(words).uniform();
//! assert_eq!(draw([1, 2, 3, 4]), draw([1, 2, 3, 4])); // the same path, the same numbers
//! assert_ne!(draw([1, 2, 3, 4]), draw([2, 2, 3, 4])); // another seed, others
//! ```

use tomolith_core::random::{STEP, SplitMix, mixed};

/// See the [module page](self).
#[derive(Clone, Copy, Debug)]
pub struct Stream(SplitMix);

impl Stream {
    /// The stream of a path.
    #[must_use]
    pub fn new(words: [u64; 4]) -> Self {
        let state = |state, &word: &u64| mixed(state ^ word.wrapping_add(STEP));
        Stream(SplitMix(words.iter().fold(0, state)))
    }

    /// The next number, in (0, 1).
    pub fn uniform(&mut self) -> f64 {
        ((self.0.bits() >> 12) as f64 + 0.5) / (1u64 << 52) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighboring_streams_are_uniform_and_do_not_know_of_each_other() {
        // First draws of 20000 neighboring paths: mean ½, variance 1/12, no correlation from one to the next
        let draws: Vec<f64> = (0..20_000)
            .map(|i| Stream::new([7, 0, i, 0]).uniform() - 0.5)
            .collect();
        let mean = |f: &dyn Fn(usize) -> f64| (0..19_999).map(f).sum::<f64>() / 19_999.0;
        let five_sigma = 5.0 / 12f64.sqrt() / 20_000f64.sqrt();
        assert!(mean(&|i| draws[i]).abs() < five_sigma);
        assert!((mean(&|i| draws[i].powi(2)) - 1.0 / 12.0).abs() < five_sigma);
        assert!(mean(&|i| draws[i] * draws[i + 1]).abs() < five_sigma / 2.0);
    }
}
