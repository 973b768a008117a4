//! A cubic through points that never falls where the points do not: tabulated responses and gray curves.
//!
//! **Equation** between two places x_k, x_k+1 the cubic with the values of the points and with slopes s_k; from secants δ and widths h
//!
//! ```text
//! inside  s_k = (w₁ + w₂)/(w₁/δ_k−1 + w₂/δ_k),  w₁ = 2h_k + h_k−1,  w₂ = h_k + 2h_k−1;   0 where a secant is 0
//! ends    s₀  = ((2h₀ + h₁)·δ₀ − h₀·δ₁)/(h₀ + h₁), brought into [0, 3δ₀]
//! ```
//!
//! **Source** Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300 ("PCHIP").
//!
//! ```
//! use tomolith_core::monotone_cubic::{slopes, value_and_slope};
//! let slopes = slopes(&[0.0, 0.5, 1.0], &[0.0, 0.2, 1.0]);
//! assert!((slopes[1] - 0.64).abs() < 1e-12); // secants 0.4 and 1.6, harmonic mean 0.64
//! let (value, slope) = value_and_slope(0.5, [0.2, 1.0], [slopes[1], slopes[2]], 0.5);
//! assert!((value - 1.0).abs() < 1e-12 && (slope - slopes[2]).abs() < 1e-12);
//! ```

/// Slopes at the points (x, y): two or more, x ascending, y never falling.
#[must_use]
pub fn slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    let secants: Vec<f64> = y
        .windows(2)
        .zip(&h)
        .map(|(w, h)| (w[1] - w[0]) / h)
        .collect();
    let n = x.len();
    if n == 2 {
        return vec![secants[0]; 2];
    }
    // Secants are not negative
    let end = |h0: f64, h1: f64, d0: f64, d1: f64| {
        (((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)).clamp(0.0, 3.0 * d0)
    };
    let inner = (1..n - 1).map(|k| {
        let (before, after) = (secants[k - 1], secants[k]);
        if before == 0.0 || after == 0.0 {
            return 0.0;
        }
        let (w1, w2) = (2.0 * h[k] + h[k - 1], h[k] + 2.0 * h[k - 1]);
        (w1 + w2) / (w1 / before + w2 / after)
    });
    let first = end(h[0], h[1], secants[0], secants[1]);
    let last = end(h[n - 2], h[n - 3], secants[n - 2], secants[n - 3]);
    std::iter::once(first)
        .chain(inner)
        .chain(std::iter::once(last))
        .collect()
}

/// The cubic over [0, h] with these values and slopes at its ends: its coefficients, the constant first.
#[must_use]
pub fn coefficients(h: f64, y: [f64; 2], s: [f64; 2]) -> [f64; 4] {
    let secant = (y[1] - y[0]) / h;
    [
        y[0],
        s[0],
        (3.0 * secant - 2.0 * s[0] - s[1]) / h,
        (s[0] + s[1] - 2.0 * secant) / (h * h),
    ]
}

/// Its value and slope at t of [0, h].
#[must_use]
pub fn value_and_slope(h: f64, y: [f64; 2], s: [f64; 2], t: f64) -> (f64, f64) {
    let [c0, c1, c2, c3] = coefficients(h, y, s);
    (
        ((c3 * t + c2) * t + c1) * t + c0,
        (3.0 * c3 * t + 2.0 * c2) * t + c1,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values and slopes of an independent implementation's formulas by hand: d = 0, 1, 3, 4 and m = 0, 1, 2, 6.
    #[test]
    fn slopes_by_hand() {
        // h = 1, 2, 1; secants 1, ½, 4
        let found = slopes(&[0.0, 1.0, 3.0, 4.0], &[0.0, 1.0, 2.0, 6.0]);
        let first = (4.0 * 1.0 - 1.0 * 0.5) / 3.0; // (2·1 + 2)·1 − 1·½ over 3
        let second = 9.0 / (5.0 / 1.0 + 4.0 / 0.5); // w₁ = 2·2 + 1, w₂ = 2 + 2·1
        let third = 9.0 / (4.0 / 0.5 + 5.0 / 4.0); // w₁ = 2·1 + 2, w₂ = 1 + 2·2
        let last = (4.0 * 4.0 - 1.0 * 0.5) / 3.0;
        for (found, expected) in found.iter().zip([first, second, third, last]) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }
}
