//! Sparsity: bright or lit pixels cost.
//!
//! **Equation** R = Σ_pixels |x|^M, ∂R/∂x = M·|x|^(M−1). M = 1 asks for few lit pixels (total light), M = 4 for no bright ones
//! (so that a projector needs less time), M below 1 for dark pixels.
//!
//! **Source** the sparsity term of Dr.TVAM (Nicolet et al. 2024), w_sp·Σ|x|^M with M = 4. There it is evaluated on the search
//! direction during line searches; here on the patterns themselves.
//!
//! **Parameters** see [`Params`]. **Limits** patterns are not negative, so the slope at 0 is that towards lit pixels; for M < 1
//! it would be infinite, and below [`CHORD`] |x|^M is replaced by its chord, as in [`band`](crate::band). A sum over
//! pixels: its size follows the number of frames and pixels. **Cost** one pass over the patterns.
//!
//! ```
//! use tomolith_core::field::{Field, HostField};
//! use tomolith_objective::penalty::{PatternPenalty, sparsity::Sparsity};
//! let x = HostField::from_slice(&[0.5, 0.0, 1.0]);
//! let mut gradient = x.zeros_like();
//! let value = Sparsity::new(2.0).unwrap().add_gradient(&x, 1.0, &mut gradient);
//! assert_eq!((value, gradient.as_slice()), (1.25, &[1.0, 0.0, 2.0][..])); // 0.25 + 1; slopes 2·x
//! ```

use super::{BuildPenalty, PatternPenalty};
use crate::band::CHORD;
use crate::preset::positive;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::error::Result;
use tomolith_core::field::{BLOCK, HostField};
use tomolith_core::kind::Kind;

/// The parameters of sparsity.
#[derive(Clone, Debug, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// M: power of the pixel values, above 0 (default 4)
    pub exponent: f64,
}

impl Default for Params {
    fn default() -> Self {
        Params { exponent: 4.0 }
    }
}

/// Σ |x|^M
#[derive(Clone, Copy, Debug)]
pub struct Sparsity {
    exponent: f64,
}

impl Sparsity {
    /// With this power.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) when it is not above 0.
    pub fn new(exponent: f64) -> Result<Self> {
        positive("exponent", exponent)?;
        Ok(Sparsity { exponent })
    }

    /// Term and slope of a pixel.
    #[inline]
    fn term(&self, x: f32) -> (f64, f64) {
        let (size, m) = (f64::from(x.abs()), self.exponent);
        let sign = if x < 0.0 { -1.0 } else { 1.0 };
        if m == 2.0 {
            return (size * size, 2.0 * f64::from(x));
        }
        let chord = f64::from(CHORD);
        if m < 1.0 && size < chord {
            let slope = chord.powf(m - 1.0);
            return (slope * size, sign * slope);
        }
        let rise = size.powf(m - 1.0);
        (rise * size, sign * m * rise)
    }
}

impl PatternPenalty<HostField> for Sparsity {
    fn value(&self, x: &HostField) -> f64 {
        let blocks = x.as_slice().par_chunks(BLOCK);
        let sums: Vec<f64> = blocks
            .map(|b| b.iter().map(|&x| self.term(x).0).sum())
            .collect();
        sums.iter().sum()
    }

    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn add_gradient(&self, x: &HostField, scale: f64, gradient: &mut HostField) -> f64 {
        let blocks = x
            .as_slice()
            .par_chunks(BLOCK)
            .zip(gradient.as_mut_slice().par_chunks_mut(BLOCK));
        let sums: Vec<f64> = blocks
            .map(|(x, gradient)| {
                let mut sum = 0.0;
                for (&x, g) in x.iter().zip(gradient) {
                    let (term, slope) = self.term(x);
                    sum += term;
                    *g += (scale * slope) as f32;
                }
                sum
            })
            .collect();
        sums.iter().sum()
    }

    fn slope_along(&self, x: &HostField, step: &HostField, alpha: f32) -> (f64, f64) {
        let blocks = x
            .as_slice()
            .par_chunks(BLOCK)
            .zip(step.as_slice().par_chunks(BLOCK));
        let sums: Vec<(f64, f64)> = blocks
            .map(|(x, step)| {
                x.iter()
                    .zip(step)
                    .fold((0.0, 0.0), |(sum, along), (&x, &p)| {
                        let (term, slope) = self.term(x + alpha * p);
                        (sum + term, along + slope * f64::from(p))
                    })
            })
            .collect();
        sums.iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1))
    }

    fn is_convex(&self) -> bool {
        self.exponent >= 1.0
    }
}

/// The row of the table.
pub const KIND: Kind<BuildPenalty> = Kind {
    name: "sparsity",
    summary: "bright pixels cost: the sum of |x| to a power",
    example: "[[penalties]]\nsparsity = { exponent = 4.0 }\nweight = 1e-3",
    schema: || schemars::schema_for!(Params),
    build: |section, _| {
        let params: Params = section.parse()?;
        let penalty = Sparsity::new(params.exponent).map_err(|e| e.under(&section.path))?;
        Ok(Box::new(penalty))
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::field::Field;

    #[test]
    fn below_one_the_chord_keeps_value_and_slope_a_pair() {
        let half = Sparsity::new(0.5).unwrap();
        let c = f64::from(CHORD);
        assert_eq!(half.term(0.0), (0.0, c.powf(-0.5)));
        assert!((half.term(CHORD).0 - c.sqrt()).abs() < 1e-12);
        let (term, slope) = half.term(CHORD / 2.0);
        assert!((term - slope * c / 2.0).abs() < 1e-12);
        assert_eq!(half.term(0.25), (0.5, 1.0));
        assert!(!half.is_convex());
    }

    #[test]
    fn the_total_light_has_the_slope_one_in_the_dark_too() {
        let x = HostField::zeros(3);
        let mut gradient = x.zeros_like();
        assert_eq!(
            Sparsity::new(1.0)
                .unwrap()
                .add_gradient(&x, 3.0, &mut gradient),
            0.0
        );
        assert_eq!(gradient.as_slice(), [3.0; 3]);
    }
}
