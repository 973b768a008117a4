//! Sparsity: bright or lit pixels cost.
//!
//! **Equation** R = Σ_pixels |x|^M, ∂R/∂x = M·|x|^(M−1). M = 1 asks for few lit pixels (total light), M = 4 for no bright ones
//! (so that a projector needs less time), M below 1 for dark pixels.
//!
//! **Source** the sparsity term of Dr.TVAM (Nicolet et al. 2024), w_sp·Σ|x|^M with M = 4. There it is evaluated on the search
//! direction during line searches; here on the patterns themselves.
//!
//! **Parameters** see [`Params`]. **Limits** patterns are not negative, so the slope at 0 is that toward lit pixels; for M < 1
//! it would be infinite, and close to 0 |x|^M is [replaced by its chord](tomolith_core::field::costs). A sum over
//! pixels: its size follows the number of frames and pixels. **Cost** one pass over the patterns.
//!
//! ```
//! use tomolith_core::field::{Field, HostField};
//! use tomolith_objective::penalty::{Penalties, sparsity::sparsity};
//! let x = HostField::from_slice(&[0.5, 0.0, 1.0]);
//! let mut gradient = x.zeros_like();
//! let penalty = Penalties::new(vec![(1.0, sparsity(2.0)?)])?;
//! let value = penalty.add_gradient(&x, 1.0, &mut gradient);
//! assert_eq!((value, gradient.as_slice()), (1.25, &[1.0, 0.0, 2.0][..])); // 0.25 + 1; slopes 2·x
//! # Ok::<(), tomolith_core::Error>(())
//! ```

use super::{BuildPenalty, MakePenalty, read};
use crate::preset::HIGHEST_POWER;
use tomolith_core::dose::PatternLayout;
use tomolith_core::error::Result;
use tomolith_core::field::PatternCost;
use tomolith_core::kind::{Kind, check_ranges, schema_of};

tomolith_core::keys! {
    /// The parameters of sparsity.
    pub struct Params {
        /// M: power of the pixel values
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = HIGHEST_POWER))]
        pub exponent: f64 = 4.0,
    }
}

/// Σ |x|^M
///
/// # Errors
/// [`Error::Config`](tomolith_core::Error::Config) when M is not above 0.
pub fn sparsity(exponent: f64) -> Result<PatternCost> {
    check_ranges("", &Params { exponent })?;
    Ok(PatternCost::Power { exponent })
}

/// The row of the table.
pub const KIND: Kind<BuildPenalty> = Kind {
    name: "sparsity",
    summary: "sum of |x| to a power: penalizes bright pixels",
    example: "[[penalties]]\nsparsity = { exponent = 4.0 }\nweight = 1e-3",
    schema: schema_of::<Params>,
    build: read::<Params>,
};

impl MakePenalty for Params {
    fn make(&self, _: &[PatternLayout]) -> Result<PatternCost> {
        sparsity(self.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::alone;
    use super::*;
    use tomolith_core::field::{Field, HostField};

    #[test]
    fn the_total_light_has_the_slope_one_in_the_dark_too() {
        let x = HostField::zeros(3);
        let mut gradient = x.zeros_like();
        let penalty = alone(sparsity(1.0).unwrap());
        assert_eq!(penalty.add_gradient(&x, 3.0, &mut gradient), 0.0);
        assert_eq!(gradient.as_slice(), [3.0; 3]);
    }
}
