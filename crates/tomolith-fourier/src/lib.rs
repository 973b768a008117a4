//! Fourier and cosine transforms of single precision, compiled once for all crates.
//!
//! `rustfft`, `realfft` and `rustdct` are generic over the number: every crate that makes a plan compiles all their kernels anew, some 2 MB of
//! code and a minute of work each time. The functions here are not generic, so that this happens in one place.
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
pub use rustdct::TransformType2And3;
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
pub fn cosine(length: usize) -> Arc<dyn TransformType2And3<f32>> {
    rustdct::DctPlanner::new().plan_dct2(length)
}
