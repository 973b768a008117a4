//! Patterns at the projector's bit depth.
//!
//! # Equation
//! With b bits and the full scale s = max x, over all frames of one light,
//!
//! ```text
//! q = ⌊ x/s · (2^b − 1) + ½ ⌋        x̂ = q/(2^b − 1) · s
//! ```
//!
//! (rounded half up, in f64; x̂ is then rounded to f32). The written patterns are x̂, and everything that is reported is
//! computed from x̂, so that numbers and files belong together. |x̂ − x| ≤ s/(2·(2^b − 1)) up to the rounding of f32.
//!
//! # Parameters
//! `bits` 1…16. Several lights are quantized each with a full scale of its own.
//!
//! # Example
//! Two bits have the levels 0, 1/3, 2/3 and 1 of the full scale 3; a half is rounded up:
//! ```
//! use tomolith_optics::exposure::quantize;
//! use tomolith_core::grid::{PatternGrid, Patterns};
//! let grid = PatternGrid::full_turn(1, 0.0, 1, 4, 0.02);
//! let patterns = Patterns { grid, values: vec![0.0, 1.4, 1.5, 3.0] };
//! let quantized = quantize(&patterns, 2).unwrap();
//! assert_eq!(quantized.values, [0, 1, 2, 3]); // 1.5/3·3 + ½ = 2: up
//! assert_eq!(quantized.patterns().values, [0.0, 1.0, 2.0, 3.0]);
//! ```

use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::field::BLOCK;
use tomolith_core::grid::{PatternGrid, Patterns};
use tomolith_core::parallel::{InParallel, table};
use tomolith_io::channel::Channel;
use tomolith_io::frames::{FrameSet, top_level};

/// Patterns of one light as whole numbers 0…2^bits − 1, array order `[angle, row, column]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantized {
    /// Which pixel is where.
    pub grid: PatternGrid,
    /// Bit depth, 1…16.
    pub bits: u32,
    /// The pattern value of the highest level, mJ/mm²; 0 when all is dark.
    pub full_scale: f32,
    /// One level per pixel, column fastest.
    pub values: Vec<u16>,
}

/// Rounds patterns to `bits` bits; see the [module page](self).
///
/// # Errors
/// [`Error::Config`] when `bits` is not 1…16; [`Error::NonFinite`] when a value is negative, infinite or not a number.
pub fn quantize(patterns: &Patterns, bits: u32) -> Result<Quantized> {
    check(patterns, bits)?;
    let largest = |block: &[f32]| block.iter().copied().fold(0.0, f32::max);
    let blocks = patterns.values.chunks(BLOCK).par_map(largest);
    let full_scale = blocks.into_iter().fold(0.0, f32::max);
    let mut values = vec![0; patterns.values.len()];
    if full_scale > 0.0 {
        let top = f64::from(top_level(bits));
        values
            .chunks_mut(BLOCK)
            .zip(patterns.values.chunks(BLOCK))
            .par_each(|(levels, block)| {
                for (level, &value) in levels.iter_mut().zip(block) {
                    let scaled = f64::from(value) / f64::from(full_scale) * top + 0.5;
                    *level = scaled.floor() as u16;
                }
            });
    }
    Ok(Quantized {
        grid: patterns.grid.clone(),
        bits,
        full_scale,
        values,
    })
}

/// Refuses a bit depth that no level fits into.
pub(super) fn check_bits(bits: u32) -> Result<()> {
    let is_in = (1..=16).contains(&bits);
    in_range(is_in, "bit_depth", bits, "a whole number 1…16")
}

/// Whether patterns can be brought to a bit depth.
pub(super) fn check(patterns: &Patterns, bits: u32) -> Result<()> {
    check_bits(bits)?;
    let wrong = |block: &[f32]| {
        block
            .iter()
            .copied()
            .find(|v| !(v.is_finite() && *v >= 0.0))
    };
    let blocks = patterns.values.chunks(BLOCK).par_map(wrong);
    if let Some(value) = blocks.into_iter().flatten().next() {
        return Err(Error::NonFinite {
            what: "a pattern value to be quantized".to_owned(),
            value: f64::from(value),
            iteration: 0,
        });
    }
    Ok(())
}

impl Quantized {
    /// The patterns that these levels stand for: q/(2^bits − 1)·full_scale.
    #[must_use]
    pub fn patterns(&self) -> Patterns {
        let top = f64::from(top_level(self.bits));
        let scale = f64::from(self.full_scale);
        Patterns {
            grid: self.grid.clone(),
            values: table(self.values.len(), |i| {
                (f64::from(self.values[i]) / top * scale) as f32
            }),
        }
    }

    /// Sum over all pixels of each frame of level over highest level.
    #[must_use]
    pub fn sums(&self) -> Vec<f64> {
        let top = f64::from(top_level(self.bits));
        let pixels = (self.grid.rows * self.grid.columns).max(1);
        let sum = |frame: &[u16]| frame.iter().map(|&q| u64::from(q)).sum::<u64>() as f64 / top;
        self.values.chunks(pixels).par_map(sum)
    }

    /// A view of these levels for writers of frames and movies, gray or in a channel of color images.
    #[must_use]
    pub fn frames<'a>(&'a self, light: Option<&'a str>, channel: Option<Channel>) -> FrameSet<'a> {
        FrameSet {
            light,
            grid: &self.grid,
            bits: self.bits,
            full_scale: self.full_scale,
            channel,
            values: &self.values,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::refuses;

    fn patterns(values: Vec<f32>) -> Patterns {
        Patterns {
            grid: PatternGrid::full_turn(1, 0.0, 1, values.len(), 0.1),
            values,
        }
    }

    #[test]
    fn quantizing_twice_changes_nothing_at_any_depth() {
        let values: Vec<f32> = (0..3000)
            .map(|i| (i as f32 * 0.7312).sin().abs() * 0.037)
            .collect();
        for bits in 1..=16 {
            let once = quantize(&patterns(values.clone()), bits).unwrap();
            let twice = quantize(&once.patterns(), bits).unwrap();
            assert_eq!(once, twice, "{bits} bits");
            assert_eq!(once.patterns(), twice.patterns());
        }
    }

    #[test]
    fn the_error_is_half_a_level_and_no_less() {
        let values: Vec<f32> = (0..=1000).map(|i| i as f32 / 1000.0).collect();
        for bits in [1u32, 4, 8] {
            let out = quantize(&patterns(values.clone()), bits)
                .unwrap()
                .patterns();
            let worst = values
                .iter()
                .zip(&out.values)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f32::max);
            let half = 0.5 / f32::from(top_level(bits));
            assert!(
                worst <= half * 1.0001 && worst > half * 0.7,
                "{bits}: {worst}"
            );
        }
    }

    #[test]
    fn dark_patterns_stay_dark_and_bad_values_are_refused() {
        let dark = quantize(&patterns(vec![0.0; 4]), 8).unwrap();
        assert_eq!(
            (dark.full_scale, dark.patterns().values),
            (0.0, vec![0.0; 4])
        );
        for bad in [f32::NAN, f32::INFINITY, -1e-9] {
            let refused = quantize(&patterns(vec![0.0, bad]), 8);
            assert!(matches!(refused, Err(Error::NonFinite { .. })));
        }
        for bits in [0, 17] {
            refuses(quantize(&patterns(vec![1.0]), bits), "bit_depth");
        }
    }
}
