//! Filtered back-projection, in the printer's direction: the ramp-filtered adjoint of the wanted dose.
//!
//! **Equation** with the adjoint Fᵀ, the ramp filter R along the columns of every row, and d = M⁻¹(target)
//!
//! ```text
//! x = c · max(R Fᵀ d, 0)          or, negative = "offset",  x = c · (R Fᵀ d − min R Fᵀ d)
//! R = |f|·W(f), f in cycles per column, 0…½:
//!     ram_lak W = 1 · shepp_logan sin(πf)/(πf) · cosine cos(πf) · hamming 0.54 + 0.46·cos(2πf) · hann ½ + ½·cos(2πf)
//! ```
//!
//! c makes the dose of the part right (least squares, one forward call). `none` leaves the adjoint unfiltered.
//!
//! **Source** Kak and Slaney, Principles of Computerized Tomographic Imaging (1988), eq. 3.61: the ramp is the transform of the
//! band-limited kernel (¼, −1/(πn)² for odd n, 0 for even n), which keeps the mean right, and rows are padded with as many zeros.
//! Li et al. (2024), eqs. 2 and 3, for its use as a start.
//!
//! **Parameters** see [`Params`]. **Limits** linear models only. **Cost** one adjoint and one forward call, transforms of
//! 2×columns per row, one array of all pixels.

use super::{BuildStart, Start, StartInput};
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::Patterns;
use crate::kind::Kind;
use crate::models::Run;
use rayon::prelude::*;
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::sync::Arc;

/// The window of the ramp filter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Filter {
    /// The bare ramp: sharpest.
    #[default]
    RamLak,
    /// The ramp times sin(πf)/(πf).
    SheppLogan,
    /// The ramp times cos(πf).
    Cosine,
    /// The ramp times 0.54 + 0.46·cos(2πf).
    Hamming,
    /// The ramp times ½ + ½·cos(2πf): softest.
    Hann,
    /// No filter.
    None,
}

/// What becomes of negative values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Negative {
    /// They become 0.
    #[default]
    Clip,
    /// All values are raised until the smallest is 0.
    Offset,
}

/// The parameters of filtered back-projection.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Window of the ramp filter: "ram_lak" (default), "shepp_logan", "cosine", "hamming", "hann", or "none" for no filter
    pub filter: Filter,
    /// What becomes of negative values: "clip" (default) or "offset"
    pub negative: Negative,
}

/// Filtered back-projection.
#[derive(Clone, Debug)]
pub struct Fbp(pub Params);

/// The row of the table.
pub const KIND: Kind<BuildStart> = Kind {
    name: "fbp",
    summary: "filtered back-projection: the ramp-filtered adjoint of the target",
    example: "[start.fbp]\nfilter = \"ram_lak\"\nnegative = \"clip\"",
    schema: || schemars::schema_for!(Params),
    build: |section| Ok(Box::new(Fbp(section.parse()?))),
};

impl Start for Fbp {
    fn patterns(&self, input: &StartInput, run: &Run) -> Result<HostField> {
        input.require_linear("fbp")?;
        let wanted = input.wanted_dose()?;
        let mut x = input.model.new_patterns()?;
        input
            .model
            .pullback(&x.zeros_like(), &wanted, &mut x, run)?;
        for light in input.model.patterns() {
            let mut patterns = light.patterns_of(x.as_slice());
            if self.0.filter != Filter::None {
                filter_rows(&mut patterns, self.0.filter)?;
            }
            light.fill_field(&patterns, x.as_mut_slice());
        }
        if run.is_cancelled() {
            return Err(Error::Cancelled);
        }
        let lowest = match self.0.negative {
            Negative::Clip => 0.0,
            Negative::Offset => x.as_slice().par_iter().copied().reduce(|| 0.0, f32::min),
        };
        x.as_mut_slice()
            .par_iter_mut()
            .for_each(|v| *v = (*v - lowest).max(0.0));
        input.scaled(x, &wanted, run)
    }
}

/// Filters every row along its columns.
fn filter_rows(patterns: &mut Patterns, filter: Filter) -> Result<()> {
    let columns = patterns.grid.columns;
    if patterns.values.is_empty() {
        return Ok(());
    }
    let ramp = Ramp::new(columns, filter)?;
    patterns.values.par_chunks_mut(columns).try_for_each_init(
        || ramp.buffers(),
        |buffers, row| {
            if row.iter().all(|&v| v == 0.0) {
                Ok(())
            } else {
                ramp.apply(row, buffers)
            }
        },
    )
}

/// A filter for rows of one length.
struct Ramp {
    forward: Arc<dyn RealToComplex<f32>>,
    inverse: Arc<dyn ComplexToReal<f32>>,
    /// Factor per frequency, the normalisation of the transforms included.
    response: Vec<f32>,
}

type Buffers = (Vec<f32>, Vec<Complex<f32>>);

impl Ramp {
    #[expect(clippy::cast_possible_truncation, reason = "patterns are f32")]
    fn new(columns: usize, filter: Filter) -> Result<Self> {
        let padded = (2 * columns).next_power_of_two();
        let mut kernel = vec![0.0f64; padded];
        kernel[0] = 0.25;
        for n in (1..padded / 2).step_by(2) {
            kernel[n] = -1.0 / (PI * n as f64).powi(2);
            kernel[padded - n] = kernel[n];
        }
        let transform = RealFftPlanner::<f64>::new().plan_fft_forward(padded);
        let mut spectrum = transform.make_output_vec();
        transform
            .process(&mut kernel, &mut spectrum)
            .map_err(wrong_length)?;
        let response = spectrum.iter().enumerate().map(|(k, ramp)| {
            let window = window(filter, k as f64 / padded as f64);
            (ramp.re * window / padded as f64) as f32
        });
        let response = response.collect();
        let mut planner = RealFftPlanner::<f32>::new();
        let (forward, inverse) = (
            planner.plan_fft_forward(padded),
            planner.plan_fft_inverse(padded),
        );
        Ok(Ramp {
            forward,
            inverse,
            response,
        })
    }

    fn buffers(&self) -> Buffers {
        (
            self.forward.make_input_vec(),
            self.forward.make_output_vec(),
        )
    }

    fn apply(&self, row: &mut [f32], (padded, spectrum): &mut Buffers) -> Result<()> {
        padded.fill(0.0);
        padded[..row.len()].copy_from_slice(row);
        self.forward
            .process(padded, spectrum)
            .map_err(wrong_length)?;
        spectrum
            .iter_mut()
            .zip(&self.response)
            .for_each(|(value, factor)| *value *= factor);
        self.inverse
            .process(spectrum, padded)
            .map_err(wrong_length)?;
        row.copy_from_slice(&padded[..row.len()]);
        Ok(())
    }
}

/// The plans made the buffers, so this does not happen; a library does not panic over it either.
fn wrong_length(error: realfft::FftError) -> Error {
    Error::Unsupported {
        what: "the Fourier transform of a row".to_owned(),
        reason: error.to_string(),
    }
}

/// W at a frequency in cycles per column, 0…½.
fn window(filter: Filter, f: f64) -> f64 {
    match filter {
        Filter::RamLak | Filter::None => 1.0,
        Filter::SheppLogan if f == 0.0 => 1.0,
        Filter::SheppLogan => (PI * f).sin() / (PI * f),
        Filter::Cosine => (PI * f).cos(),
        Filter::Hamming => 0.54 + 0.46 * (2.0 * PI * f).cos(),
        Filter::Hann => 0.5 + 0.5 * (2.0 * PI * f).cos(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::PatternGrid;

    fn filtered(filter: Filter) -> Vec<f32> {
        let mut patterns = Patterns::dark(PatternGrid::full_turn(2, 0.0, 3, 33, 1.0));
        // One bright pixel in the middle of a row
        patterns.values[(3 + 1) * 33 + 16] = 1.0;
        filter_rows(&mut patterns, filter).unwrap();
        assert!(
            patterns.values[..4 * 33].iter().all(|&v| v == 0.0),
            "rows mix"
        );
        patterns.values[4 * 33..5 * 33].to_vec()
    }

    #[test]
    fn an_impulse_becomes_the_band_limited_kernel() {
        for (i, value) in filtered(Filter::RamLak).iter().enumerate() {
            let n = i as f64 - 16.0;
            let expected = match (i + 16) % 2 {
                0 if i == 16 => 0.25,
                0 => 0.0,
                _ => -1.0 / (PI * n).powi(2),
            };
            assert!(
                (f64::from(*value) - expected).abs() < 1e-6,
                "at {n}: {value} instead of {expected}"
            );
        }
    }

    #[test]
    fn shepp_and_logan_s_kernel_is_theirs() {
        // Kak and Slaney, eq. 3.71 in our units: 2/(π²(1 − 4n²)) / 2² … their filter sampled at distance 1
        for (i, value) in filtered(Filter::SheppLogan)
            .iter()
            .enumerate()
            .skip(8)
            .take(17)
        {
            let n = i as f64 - 16.0;
            let expected = -2.0 / (PI * PI * (4.0 * n * n - 1.0));
            // The window acts on the sampled ramp, theirs on the ideal one: equal to the ringing of 33 samples
            assert!(
                (f64::from(*value) - expected).abs() < 2e-3,
                "at {n}: {value} instead of {expected}"
            );
        }
    }

    #[test]
    fn hann_is_the_mean_of_neighbours() {
        // ½ + ½·cos(2πf) is the kernel (¼, ½, ¼)
        let (bare, hann) = (filtered(Filter::RamLak), filtered(Filter::Hann));
        for i in 1..32 {
            let expected = 0.25 * bare[i - 1] + 0.5 * bare[i] + 0.25 * bare[i + 1];
            assert!((hann[i] - expected).abs() < 1e-6);
        }
    }
}
