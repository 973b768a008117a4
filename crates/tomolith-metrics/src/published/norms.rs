//! The band error in the norms of BCLP.
//!
//! **Equation** over the voxels of a region whose response leaves its band, V = {|M(d) − f_T| > ε},
//!
//! ```text
//! E_v = |M(d_v) − f_T,v| − ε_v
//! p → 0   (q = p)  Σ_V 1            p = 1  (q = 1)  Σ_V E          (per voxel: a voxel's volume is 1)
//! p → ∞   (q = 1)  max_V E          p = 2  (q = 1)  (Σ_V E²)^½
//! ```
//!
//! **Source** Li et al., Additive Manufacturing 94 (2024) 104447, supplement S.8, eq. SE.19. For 0 < p < ∞ the same is an
//! objective, `bclp`.

use super::super::buckets::runs;
use tomolith_core::field::BLOCK;
use tomolith_core::grid::Volume;
use tomolith_core::parallel::InParallel;
use tomolith_core::response::Response;
use tomolith_core::target::label;

/// What the response should be in each voxel.
#[derive(Clone, Copy, Debug)]
pub(super) struct TargetBand<'a> {
    pub(super) target: &'a Volume<f32>,
    pub(super) labels: &'a Volume<u8>,
    /// Whether it is the target's own values; else 1 in the part and 0 in the void.
    pub(super) gray: bool,
}

impl TargetBand<'_> {
    fn value(&self, i: usize) -> f64 {
        if self.gray {
            f64::from(self.target.values[i])
        } else {
            f64::from(u8::from(self.labels.values[i] == label::PART))
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct BandError {
    pub(super) voxels: u64,
    /// Those out of their band: p → 0.
    pub(super) violated: u64,
    /// p = 1
    pub(super) l1: f64,
    /// p = 2
    pub(super) l2: f64,
    /// p → ∞
    pub(super) largest: f64,
}

impl BandError {
    /// Both together; `l2` of all three are sums of squares.
    fn and(self, other: BandError) -> BandError {
        BandError {
            voxels: self.voxels + other.voxels,
            violated: self.violated + other.violated,
            l1: self.l1 + other.l1,
            l2: self.l2 + other.l2,
            largest: self.largest.max(other.largest),
        }
    }

    /// Counts a voxel whose response is so far beyond its band (below 0: within), without a branch to guess.
    fn add(&mut self, error: f64) {
        let is_out = error > ROUNDING;
        let error = if is_out { error } else { 0.0 };
        self.voxels += 1;
        self.violated += u64::from(is_out);
        self.l1 += error;
        self.l2 += error * error;
        self.largest = if error > self.largest {
            error
        } else {
            self.largest
        };
    }

    fn joined<'b>(blocks: impl Iterator<Item = &'b BandError>) -> BandError {
        let total = blocks.fold(BandError::default(), |a, b| a.and(*b));
        BandError {
            l2: total.l2.sqrt(),
            ..total
        }
    }
}

/// The band errors with two tolerances, `[tolerance][all, part, void]`, in one pass.
pub(super) fn band_errors(
    dose: &Volume<f32>,
    band: TargetBand<'_>,
    tolerances: [f64; 2],
    response: &dyn Response,
) -> [[BandError; 3]; 2] {
    let is_identity = response.is_identity();
    let blocks = dose.values.chunks(BLOCK).enumerate();
    let blocks: Vec<[[BandError; 3]; 2]> = blocks.par_map(|(b, block)| {
        let begin = b * BLOCK;
        let mut sums = [[BandError::default(); 2]; 2];
        for (class, run) in runs(&band.labels.values[begin..][..block.len()]) {
            let mut errors = sums[class];
            for i in run {
                let value = match is_identity {
                    true => block[i],
                    false => response.value(block[i]),
                };
                let off = (f64::from(value) - band.value(begin + i)).abs();
                for (error, tolerance) in errors.iter_mut().zip(tolerances) {
                    error.add(off - tolerance);
                }
            }
            sums[class] = errors;
        }
        let [part, void] = sums;
        [0, 1].map(|tolerance| {
            let (part, void) = (part[tolerance], void[tolerance]);
            [part.and(void), part, void]
        })
    });
    std::array::from_fn(|tolerance| {
        std::array::from_fn(|region| {
            BandError::joined(blocks.iter().map(|b| &b[tolerance][region]))
        })
    })
}

/// Doses are f32: a response on the edge of its band is within it.
const ROUNDING: f64 = 1e-7;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::row;
    use tomolith_core::response::{Identity, Logistic};
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn norms_by_hand() {
        let labels = row(&[PART, PART, VOID, VOID, OUTSIDE]);
        let target = row(&[1.0, 1.0, 0.0, 0.0, 1.0]);
        let dose = row(&[0.5, 1.25, 0.25, 0.0, 9.0]);
        let band = TargetBand {
            target: &target,
            labels: &labels,
            gray: false,
        };
        let [[error, part, void], [exact, ..]] = band_errors(&dose, band, [0.125, 0.0], &Identity);
        // 0.375, 0.125, 0.125 out of their bands
        assert_eq!((error.voxels, error.violated), (4, 3));
        assert!((error.l1 - 0.625).abs() < 1e-12);
        assert!((error.l2 - (0.375f64.powi(2) + 2.0 * 0.125f64.powi(2)).sqrt()).abs() < 1e-12);
        assert_eq!(error.largest, 0.375);
        assert_eq!((part.violated, void.violated), (2, 1));
        assert!((part.l1 + void.l1 - error.l1).abs() < 1e-12);
        assert_eq!((exact.violated, exact.l1), (3, 1.0));
    }

    #[test]
    fn gray_targets_and_responses_are_measured_in_units_of_the_response() {
        let labels = row(&[PART, VOID]);
        let target = row(&[0.7, 0.3]);
        let response = Logistic::new(Default::default()).unwrap();
        let dose = row(&[response.inverse(0.7), 0.5]);
        let band = TargetBand {
            target: &target,
            labels: &labels,
            gray: true,
        };
        let [_, [error, ..]] = band_errors(&dose, band, [0.1, 0.0], &response);
        // The first is where it should be, the second responds with 0.5
        assert!(
            (error.l1 - 0.2).abs() < 1e-6 && (error.largest - 0.2).abs() < 1e-6,
            "{error:?}"
        );
    }

    #[test]
    fn errors_of_many_blocks_are_those_of_their_voxels() {
        let n = 3 * BLOCK / 2;
        let labels: Vec<u8> = (0..n).map(|i| [PART, VOID, OUTSIDE][i % 3]).collect();
        let values: Vec<f32> = (0..n).map(|i| (i * 7919 % 1009) as f32 / 1009.0).collect();
        let (labels, dose) = (row(&labels), row(&values));
        let band = TargetBand {
            target: &dose,
            labels: &labels,
            gray: false,
        };
        let errors_of = |wanted: u8, target: f64| {
            let pairs = dose.values.iter().zip(&labels.values);
            let pairs = pairs.filter(|(_, label)| **label == wanted);
            let errors = pairs.map(|(&dose, _)| (f64::from(dose) - target).abs() - 0.125);
            errors.filter(|error| *error > ROUNDING).collect::<Vec<_>>()
        };
        let [[all, part, void], _] = band_errors(&dose, band, [0.125, 0.0], &Identity);
        for (found, expected) in [(part, errors_of(PART, 1.0)), (void, errors_of(VOID, 0.0))] {
            assert!(expected.len() > 1000);
            assert_eq!(found.violated, expected.len() as u64);
            assert!((found.l1 / expected.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
        assert_eq!(all.violated, part.violated + void.violated);
    }
}
