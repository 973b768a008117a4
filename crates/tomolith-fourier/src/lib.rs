//! Fourier and cosine transforms of single precision, compiled once for all crates.
//!
//! `rustfft` and `realfft` are generic over the number: every crate that makes a plan compiles all their kernels anew, more than 1 MB of
//! code and many seconds of work each time. The functions here are not generic, so that this happens in one place. Kernels for processors
//! with SSE but without AVX (before 2013) are left out: they would double that work.
//! Transforms are not normalized: there and back multiplies by the length (by half of it for [`cosine`]).
//!
//! ```
//! use tomolith_fourier::{Complex, complex};
//!
//! let [forward, inverse] = complex(4);
//! let mut values = [1.0, 2.0, 3.0, 4.0].map(|re| Complex::new(re, 0.0f32));
//! forward.process(&mut values);
//! assert_eq!(values[0], Complex::new(10.0, 0.0)); // the sum
//! inverse.process(&mut values);
//! assert_eq!(values[3].re, 16.0); // the fourth value times the length
//! ```

use std::sync::Arc;

pub use realfft::num_complex::Complex;
pub use realfft::{ComplexToReal, FftError, RealToComplex};
pub use rustfft::{Fft, FftNum};

/// Transforms of `length` complex numbers: exp(−2πi jk/n), and back with the other sign.
#[must_use]
pub fn complex(length: usize) -> [Arc<dyn Fft<f32>>; 2] {
    let mut plans = rustfft::FftPlanner::new();
    [
        plans.plan_fft_forward(length),
        plans.plan_fft_inverse(length),
    ]
}

/// A transform from real numbers to half a spectrum, and the one back.
pub type RealPair = (Arc<dyn RealToComplex<f32>>, Arc<dyn ComplexToReal<f32>>);

/// Transforms of `length` real numbers to `length / 2 + 1` frequencies, and back.
#[must_use]
pub fn real(length: usize) -> RealPair {
    let mut plans = realfft::RealFftPlanner::new();
    (
        plans.plan_fft_forward(length),
        plans.plan_fft_inverse(length),
    )
}

/// Cosine transforms of `length` numbers: DCT-II, and DCT-III, which is its inverse times `length / 2`.
#[must_use]
pub fn cosine(length: usize) -> Cosine {
    let [fft, _] = complex(length);
    let turn = |k: usize| {
        let angle = -std::f64::consts::PI * k as f64 / (2 * length) as f64;
        Complex::new(angle.cos() as f32, angle.sin() as f32)
    };
    Cosine {
        turns: (0..length).map(turn).collect(),
        fft,
    }
}

/// Cosine transforms of one length, each by one Fourier transform of that length.
///
/// **Source** J. Makhoul, IEEE Trans. Acoust. Speech Signal Process. 28, 27–34 (1980): with the even samples in order and then the odd ones in
/// reverse, v, the DCT-II is Re(e^(−iπk/2n)·FFT(v)_k).
///
/// ```
/// let cosine = tomolith_fourier::cosine(2);
/// let mut values = [1.0, 3.0];
/// let mut scratch = cosine.scratch();
/// cosine.forward(&mut values, &mut scratch);
/// assert_eq!(values[0], 4.0); // the sum
/// assert!((values[1] + 2f32.sqrt()).abs() < 1e-6); // (1 − 3)·cos(π/4)
/// cosine.inverse(&mut values, &mut scratch);
/// assert!((values[1] - 3.0).abs() < 1e-6); // times 2/2
/// ```
#[derive(Clone)]
pub struct Cosine {
    fft: Arc<dyn Fft<f32>>,
    /// e^(−iπk/2n).
    turns: Vec<Complex<f32>>,
}

impl Cosine {
    /// Numbers that are transformed.
    #[must_use]
    #[expect(
        clippy::len_without_is_empty,
        reason = "a length of a transform, not a collection"
    )]
    pub fn len(&self) -> usize {
        self.turns.len()
    }

    /// Memory for [`forward`](Self::forward) and [`inverse`](Self::inverse), to be used again and again.
    #[must_use]
    pub fn scratch(&self) -> Vec<Complex<f32>> {
        vec![Complex::default(); self.len() + self.fft.get_inplace_scratch_len()]
    }

    /// DCT-II in place: Σ_j x_j cos(πk(j + ½)/n).
    ///
    /// # Panics
    /// When `values` is not of this length, or `scratch` not what [`scratch`](Self::scratch) makes.
    pub fn forward(&self, values: &mut [f32], scratch: &mut [Complex<f32>]) {
        let (spectrum, scratch) = self.parts(values, scratch);
        for (to, from) in (0..values.len()).step_by(2).enumerate() {
            spectrum[to] = values[from].into();
        }
        for (to, from) in (1..values.len()).step_by(2).enumerate() {
            spectrum[values.len() - 1 - to] = values[from].into();
        }
        self.fft.process_with_scratch(spectrum, scratch);
        for ((value, entry), turn) in values.iter_mut().zip(spectrum).zip(&self.turns) {
            *value = entry.re * turn.re - entry.im * turn.im;
        }
    }

    /// DCT-III in place: x_0/2 + Σ_k x_k cos(πk(j + ½)/n).
    ///
    /// # Panics
    /// When `values` is not of this length, or `scratch` not what [`scratch`](Self::scratch) makes.
    pub fn inverse(&self, values: &mut [f32], scratch: &mut [Complex<f32>]) {
        let (spectrum, scratch) = self.parts(values, scratch);
        spectrum[0] = (values[0] * 0.5).into();
        for k in 1..values.len() {
            spectrum[k] = Complex::new(values[k], values[values.len() - k]) * self.turns[k] * 0.5;
        }
        self.fft.process_with_scratch(spectrum, scratch);
        for (from, to) in (0..values.len()).step_by(2).enumerate() {
            values[to] = spectrum[from].re;
        }
        for (from, to) in (1..values.len()).step_by(2).enumerate() {
            values[to] = spectrum[values.len() - 1 - from].re;
        }
    }

    /// What is transformed, and what the Fourier transform needs.
    fn parts<'a>(
        &self,
        values: &[f32],
        scratch: &'a mut [Complex<f32>],
    ) -> (&'a mut [Complex<f32>], &'a mut [Complex<f32>]) {
        assert_eq!(values.len(), self.len(), "numbers to transform");
        scratch.split_at_mut(self.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cosine_transforms_are_their_sums() {
        for n in 1..40 {
            let values: Vec<f32> = (0..n).map(|i| ((i * i + 3) % 11) as f32 - 4.0).collect();
            let angle =
                |k: usize, j: usize| std::f64::consts::PI * k as f64 * (j as f64 + 0.5) / n as f64;
            let cosine = cosine(n);
            let mut scratch = cosine.scratch();
            let mut found = values.clone();
            cosine.forward(&mut found, &mut scratch);
            for (k, found) in found.iter().enumerate() {
                let sum: f64 = (0..n)
                    .map(|j| f64::from(values[j]) * angle(k, j).cos())
                    .sum();
                assert!((f64::from(*found) - sum).abs() < 1e-4, "DCT-II, {n}, {k}");
            }
            let mut found = values.clone();
            cosine.inverse(&mut found, &mut scratch);
            for (j, found) in found.iter().enumerate() {
                let sum: f64 = (1..n)
                    .map(|k| f64::from(values[k]) * angle(k, j).cos())
                    .sum();
                let sum = sum + 0.5 * f64::from(values[0]);
                assert!((f64::from(*found) - sum).abs() < 1e-4, "DCT-III, {n}, {j}");
            }
        }
    }
}
