//! Random numbers that are frozen: a stream depends on its words alone, not on who draws first.
//!
//! splitmix64 (Steele, Lea & Flood, OOPSLA 2014) over a state that the words of a path (seed, frame, pixel, ray) are mixed
//! into. A dose model that draws from such streams is one fixed matrix for a seed.
//!
//! ```
//! use tomolith_optics::random::Stream;
//! let draw = |words| Stream::new(words).uniform();
//! assert_eq!(draw([1, 2, 3, 4]), draw([1, 2, 3, 4])); // the same path, the same numbers
//! assert_ne!(draw([1, 2, 3, 4]), draw([2, 2, 3, 4])); // another seed, others
//! ```

/// See the [module page](self).
#[derive(Clone, Copy, Debug)]
pub struct Stream(u64);

impl Stream {
    /// The stream of a path.
    #[must_use]
    pub fn new(words: [u64; 4]) -> Self {
        Stream(
            words
                .iter()
                .fold(0, |state, &word| mixed(state ^ word.wrapping_add(STEP))),
        )
    }

    /// The next number, in (0, 1).
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(STEP);
        ((mixed(self.0) >> 12) as f64 + 0.5) / (1u64 << 52) as f64
    }
}

/// 2⁶⁴ divided by the golden ratio.
const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
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
