//! The ramp filter of patterns, defined once: along the columns of every row, with one of five windows.
//!
//! **Equation** a row b of n columns becomes, with the band-limited ramp h in cycles per column and i, j = 0 … n − 1,
//!
//! ```text
//! b'(i) = 2·Σ_j h(i − j)·b(j),     h(0) = ¼,   h(k) = −1/(πk)² for odd k,   0 for even k ≠ 0
//! ```
//!
//! whose transform is 2·|f| up to f = ½, multiplied by the window W(f):
//!
//! | window | W(f) |
//! |---|---|
//! | `ram_lak` | 1 |
//! | `shepp_logan` | sin(πf)/(πf) |
//! | `cosine` | cos(πf) |
//! | `hamming` | 0.54 + 0.46·cos(2πf) |
//! | `hann` | ½ + ½·cos(2πf) |
//!
//! With `none` rows stay as they are (gain 1, as the ramp has at f = ½). The filter of the kernel's samples, not |f| on a
//! grid of frequencies, is what keeps the mean right: rows are padded to more than twice their length, so that the sum above
//! is exact for even and for odd n, at f = 0 too.
//!
//! **Inversion** for a full or half turn of N frames and a model whose voxel gets the share φ of a pixel's light in each frame,
//! F(x) = d is solved, up to attenuation, by x = π/(2Nφ²)·h³/(p²q)·R Fᵀ d with this filter R ([`Projection::inverse`]): h is the edge of
//! a voxel, p and q are the distances of columns and of rows, since Fᵀ sums voxels over the area p·q of a pixel, and the ramp counts
//! in columns. φ is measured on the projection itself: Σ Fᵀd = N·φ·Σ d. For a homogeneous resin φ holds the factor α of Li et al., so that 1/φ² is
//! their α⁻²; where α is a map [`start::fbp`](crate::start::fbp) has it.
//!
//! **Source** Kak and Slaney, Principles of Computerized Tomographic Imaging (1988), eq. 3.61; Li et al. (2024), eqs. 2, SE.11
//! and SE.12. **Cost** two transforms of a row of 2 to 4 times its length each; one array of all pixels.
//!
//! ```
//! use tomolith_core::grid::{PatternGrid, Patterns};
//! use tomolith_optimize::filter::{Filter, filter_rows};
//! let mut patterns = Patterns::dark(PatternGrid::full_turn(1, 0.0, 1, 3, 1.0));
//! patterns.values = vec![0.0, 1.0, 0.0];
//! filter_rows(&mut patterns, Filter::RamLak)?;
//! assert!((patterns.values[1] - 0.5).abs() < 1e-6); // 2·¼
//! assert!((patterns.values[0] + 0.202_642).abs() < 1e-6); // −2/π²
//! # Ok::<(), tomolith_core::Error>(())
//! ```

use super::Problem;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::sync::Arc;
use tomolith_core::dose::PatternLayout;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;
use tomolith_core::grid::Patterns;
use tomolith_core::parallel::{InParallel, elements};
use tomolith_fourier::{Complex, ComplexToReal, FftError, RealToComplex};

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

/// A dose field seen from the pixels, Fᵀ d, with what is needed to undo it.
pub struct Projection<F> {
    /// Fᵀ d, filtered or not.
    pub patterns: F,
    /// φ: what share of a pixel's light a voxel gets in a frame, on average over d.
    pub share: f64,
    frames: f64,
}

impl<F: Field> Projection<F> {
    /// Of Fᵀ d, filtered and multiplied by V/(p²q) for voxels of the volume V; pixels that are no unknowns count as dark.
    ///
    /// # Errors
    /// [`Error::Config`] when no light meets d.
    pub fn filtered(
        mut patterns: F,
        lights: &[PatternLayout],
        wanted: &F,
        filter: Filter,
        voxel_mm3: f64,
    ) -> Result<Self> {
        let sum = |field: &F| {
            let mut ones = field.zeros_like();
            ones.fill(1.0);
            field.dot(&ones)
        };
        let local: usize = lights.iter().map(|light| light.grid.frames()).sum();
        let frames = patterns.total(local as f64);
        let share = sum(&patterns) / (frames * sum(wanted));
        if !(share.is_finite() && share > 0.0) {
            return Err(Error::config(
                "light",
                "no light meets the target",
                "pixels that cover the target, and a resin and a bath that let light reach it (absorption_per_mm)",
            ));
        }
        if filter != Filter::None {
            let mut values = patterns.to_host();
            for light in lights {
                let mut patterns = light.patterns_of(&values);
                filter_rows(&mut patterns, filter)?;
                let [p, q] = light.grid.pitch_mm;
                let factor = (voxel_mm3 / (p * p * q)) as f32;
                elements(&mut patterns.values, |_, v| *v *= factor);
                light.fill_field(&patterns, &mut values);
            }
            patterns.copy_from_host(&values);
        }
        Ok(Projection {
            patterns,
            share,
            frames,
        })
    }

    /// c = π/(2Nφ²): the filtered projection times c has the dose d, negative values included.
    #[must_use]
    pub fn inverse(&self) -> f64 {
        PI / (2.0 * self.frames * self.share.powi(2))
    }
}

/// The projection of the problem's target, below-zero marks taken as 0; one adjoint call.
/// Refuses a problem without a target.
pub(super) fn target_projection<F: Field>(
    problem: &mut Problem<F>,
    filter: Filter,
    x: &F,
) -> Result<Projection<F>> {
    let mut wanted = problem.target()?.clone();
    wanted.clamp(0.0, f32::INFINITY);
    let mut patterns = x.zeros_like();
    problem.project(x, &wanted, &mut patterns)?;
    let model = problem.model();
    let (lights, voxel_mm3) = (model.patterns(), model.grid().voxel_mm3());
    Projection::filtered(patterns, lights, &wanted, filter, voxel_mm3)
}

/// Filters every row along its columns.
///
/// # Errors
/// None that a user could cause.
pub fn filter_rows(patterns: &mut Patterns, filter: Filter) -> Result<()> {
    let columns = patterns.grid.columns;
    if patterns.values.is_empty() || filter == Filter::None {
        return Ok(());
    }
    let ramp = Ramp::new(columns, filter);
    let frames = patterns.values.chunks_mut(patterns.grid.rows * columns);
    let filtered = frames.par_map_with(
        || ramp.buffers(),
        |buffers, frame| {
            let mut rows = frame
                .chunks_mut(columns)
                .filter(|row| row.iter().any(|&v| v != 0.0));
            rows.try_for_each(|row| ramp.apply(row, buffers))
        },
    );
    filtered.into_iter().collect()
}

/// A filter for rows of one length.
struct Ramp {
    forward: Arc<dyn RealToComplex<f32>>,
    inverse: Arc<dyn ComplexToReal<f32>>,
    /// Factor per frequency, the normalization of the transforms included.
    response: Vec<f32>,
}

type Buffers = (Vec<f32>, Vec<Complex<f32>>);

impl Ramp {
    #[expect(clippy::cast_possible_truncation, reason = "patterns are f32")]
    fn new(columns: usize, filter: Filter) -> Self {
        let padded = (2 * columns).next_power_of_two();
        let factor = |(k, ramp): (usize, f64)| {
            let window = window(filter, k as f64 / padded as f64);
            (2.0 * ramp * window / padded as f64) as f32
        };
        let response = ramp_spectrum(padded).enumerate().map(factor).collect();
        let (forward, inverse) = tomolith_fourier::real(padded);
        Ramp {
            forward,
            inverse,
            response,
        }
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

/// The Fourier transform of the ramp's kernel, 1/4 in the middle and −1/(πn)² at odd n, on `padded` places: frequencies 0 to `padded / 2`.
fn ramp_spectrum(padded: usize) -> impl Iterator<Item = f64> {
    let cosines: Vec<f64> = (0..padded)
        .map(|j| (2.0 * PI * j as f64 / padded as f64).cos())
        .collect();
    let odd = (1..padded / 2).step_by(2);
    let kernel: Vec<_> = odd.map(|n| (n, (PI * n as f64).powi(-2))).collect();
    (0..=padded / 2).map(move |k| {
        let terms = kernel.iter().map(|&(n, v)| cosines[k * n % padded] * v);
        0.25 - 2.0 * terms.sum::<f64>()
    })
}

/// The plans made the buffers, so this does not happen; a library does not panic over it either.
fn wrong_length(error: FftError) -> Error {
    Error::unsupported("the Fourier transform of a row", error.to_string())
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
    use crate::reference::ramp;
    use tomolith_core::check;
    use tomolith_core::dose::{DoseModel, Work};
    use tomolith_core::field::HostField;
    use tomolith_core::grid::{PatternGrid, Volume, VolumeGrid};
    use tomolith_core::near;
    use tomolith_models::parallel::Parallel;
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

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
    fn the_filtered_projection_has_the_dose_whatever_the_pitches_are() {
        // A smooth blob, the same at all heights, on voxels of 0.1 mm
        let grid = VolumeGrid::centered([4, 24, 24], 0.1);
        let blob = |[x, y, _]: [f64; 3]| (-(x * x + y * y) / 0.3).exp() as f32;
        let wanted = Volume::from_fn(grid.clone(), blob);
        for pitch in [[0.1, 0.1], [0.05, 0.1], [0.1, 0.04], [0.15, 0.05]] {
            let count = |mm: f64, pitch: f64| (mm / pitch).round() as usize;
            let pixels = PatternGrid {
                pitch_mm: pitch,
                ..PatternGrid::full_turn(60, 0.0, count(0.4, pitch[1]), count(3.0, pitch[0]), 1.0)
            };
            let light = Light::new(pixels, Resin::pure_radon(1.5));
            let vial = IndexMatched { radius_mm: 30.0 };
            let model = Parallel::new(&vial, vec![light], grid.clone()).unwrap();
            let lights = model.patterns();
            let field = HostField::from_slice(&model.outputs()[0].field_of(&wanted));
            let mut x = model.new_patterns().unwrap();
            let at = x.zeros_like();
            model.pullback(&at, &field, &mut x, &Work::new()).unwrap();
            let filter = Filter::RamLak;
            let projection = Projection::filtered(x, lights, &field, filter, grid.voxel_mm3());
            let projection = projection.unwrap();
            let inverse = projection.inverse();
            let mut x = projection.patterns;
            x.scale(inverse as f32);
            let dose = check::dose(&model, &x);
            let dose = model.outputs()[0].volume_of(dose.as_slice());
            let [found, expected] = [&dose, &wanted].map(|volume| *volume.at(2, 12, 12));
            near!(found / expected, 1.0, 0.05, "{pitch:?}: {found} {expected}");
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
            let expected = -4.0 / (PI * PI * (4.0 * n * n - 1.0));
            // The window acts on the sampled ramp, theirs on the ideal one: equal to the ringing of 33 samples
            near!(f64::from(*value), expected, 4e-3, "at {n}: {value}");
        }
    }

    #[test]
    fn hann_is_the_mean_of_neighbors() {
        // ½ + ½·cos(2πf) is the kernel (¼, ½, ¼)
        let (bare, hann) = (filtered(Filter::RamLak), filtered(Filter::Hann));
        for i in 1..32 {
            let expected = 0.25 * bare[i - 1] + 0.5 * bare[i] + 0.25 * bare[i + 1];
            assert!((hann[i] - expected).abs() < 1e-6);
        }
    }

    #[test]
    fn rows_of_even_and_odd_length_follow_the_sum_and_so_does_their_mean() {
        for n in [1, 2, 15, 16, 17, 31, 32, 33] {
            let noise = tomolith_core::check::noise(7, n);
            // A constant row is where a wrong zero frequency shows
            for row in [vec![1.0f32; n], noise] {
                let mut patterns = Patterns::dark(PatternGrid::full_turn(1, 0.0, 1, n, 1.0));
                patterns.values.copy_from_slice(&row);
                filter_rows(&mut patterns, Filter::RamLak).unwrap();
                let row: Vec<f64> = row.iter().map(|&v| f64::from(v)).collect();
                for (found, expected) in patterns.values.iter().zip(ramp(&row, n)) {
                    near!(f64::from(*found), expected, 2e-6, "{n} columns: {found}");
                }
            }
        }
    }
}
