//! Sine and cosine of whole turns, for surfaces made of waves, which need millions of them.

use std::f64::consts::TAU;

/// Adding and subtracting it rounds a number to the nearest whole one, up to 2⁵¹.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// sin 2πv and cos 2πv to 4e-9, for |v| < 2⁴⁹: Taylor's series on an eighth of a turn,
/// with products only.
#[inline]
pub(super) fn wave(v: f64) -> (f64, f64) {
    let shifted = 4.0 * v + ROUND;
    let t = TAU * (v - 0.25 * (shifted - ROUND));
    let s = t * t;
    let sin = t
        * (1.0
            - s * (1.0 / 6.0)
                * (1.0 - s * (1.0 / 20.0) * (1.0 - s * (1.0 / 42.0) * (1.0 - s * (1.0 / 72.0)))));
    let cos = 1.0
        - s * 0.5
            * (1.0
                - s * (1.0 / 12.0)
                    * (1.0
                        - s * (1.0 / 30.0) * (1.0 - s * (1.0 / 56.0) * (1.0 - s * (1.0 / 90.0)))));
    // The lowest bits of the shifted number count the quarters; choosing by bits spares guesses of branches
    let quarters = shifted.to_bits();
    let (sin, cos) = if quarters & 1 == 0 {
        (sin, cos)
    } else {
        (cos, sin)
    };
    let flip = |value: f64, quarters: u64| f64::from_bits(value.to_bits() ^ (quarters & 2) << 62);
    (flip(sin, quarters), flip(cos, quarters + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_sine_and_the_cosine() {
        for i in -5000..5000 {
            let v = f64::from(i) * 7.3e-4;
            let ((sin, cos), (s, c)) = (wave(v), (TAU * v).sin_cos());
            assert!((sin - s).abs() < 4e-9 && (cos - c).abs() < 4e-9, "{v}");
        }
    }
}
