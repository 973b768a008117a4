//! The band error in the norms of BCLP, over any region, with any tolerance.
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
//! objective, [`bclp`](crate::objective::bclp).

use crate::field::BLOCK;
use crate::grid::Volume;
use crate::response::Response;
use crate::target::label;
use rayon::prelude::*;

/// Over which voxels a norm is taken: the indicator function w of S.8.
#[derive(Clone, Copy, Debug)]
pub enum Region<'a> {
    /// Part and void.
    All,
    /// The part.
    Part,
    /// The void.
    Void,
    /// Part and void voxels where the mask is true, array order.
    Mask(&'a [bool]),
}

/// What the response should be: f_T ± ε per voxel.
#[derive(Clone, Copy, Debug)]
pub struct Band<'a> {
    target: &'a Volume<f32>,
    labels: &'a Volume<u8>,
    grey: bool,
    tolerance: Tolerance<'a>,
}

#[derive(Clone, Copy, Debug)]
enum Tolerance<'a> {
    Uniform(f64),
    Field(&'a [f32]),
}

impl<'a> Band<'a> {
    /// ± `epsilon` around 1 in the part and 0 in the void, or around the target's own values when it is `grey`.
    #[must_use]
    pub fn around(
        target: &'a Volume<f32>,
        labels: &'a Volume<u8>,
        grey: bool,
        epsilon: f64,
    ) -> Self {
        Band {
            target,
            labels,
            grey,
            tolerance: Tolerance::Uniform(epsilon),
        }
    }

    /// The same with a tolerance per voxel, array order.
    #[must_use]
    pub fn with_tolerance(mut self, epsilon: &'a [f32]) -> Self {
        self.tolerance = Tolerance::Field(epsilon);
        self
    }

    fn value(&self, i: usize) -> f64 {
        if self.grey {
            f64::from(self.target.values[i])
        } else {
            f64::from(u8::from(self.labels.values[i] == label::PART))
        }
    }

    fn epsilon(&self, i: usize) -> f64 {
        match self.tolerance {
            Tolerance::Uniform(epsilon) => epsilon,
            Tolerance::Field(field) => f64::from(field[i]),
        }
    }
}

/// Norms of a band error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BandError {
    /// Voxels of the region.
    pub voxels: u64,
    /// Those out of their band: p → 0.
    pub violated: u64,
    /// p = 1
    pub l1: f64,
    /// p = 2
    pub l2: f64,
    /// p → ∞
    pub largest: f64,
}

/// The band error of a dose over a region. All arrays are of the same voxels.
///
/// # Panics
/// When they have different lengths.
#[must_use]
pub fn band_error(
    dose: &Volume<f32>,
    band: &Band<'_>,
    region: Region<'_>,
    response: &dyn Response,
) -> BandError {
    let labels = &band.labels.values;
    let counts = |i: usize| match region {
        Region::All => labels[i] == label::PART || labels[i] == label::VOID,
        Region::Part => labels[i] == label::PART,
        Region::Void => labels[i] == label::VOID,
        Region::Mask(mask) => mask[i] && (labels[i] == label::PART || labels[i] == label::VOID),
    };
    let blocks: Vec<BandError> = dose
        .values
        .par_chunks(BLOCK)
        .enumerate()
        .map(|(b, block)| {
            let mut sum = BandError::default();
            for (k, &d) in block.iter().enumerate() {
                let i = b * BLOCK + k;
                if !counts(i) {
                    continue;
                }
                let error = (f64::from(response.value(d)) - band.value(i)).abs() - band.epsilon(i);
                sum.voxels += 1;
                if error > ROUNDING {
                    sum.violated += 1;
                    sum.l1 += error;
                    sum.l2 += error * error;
                    sum.largest = sum.largest.max(error);
                }
            }
            sum
        })
        .collect();
    let mut total = blocks.iter().fold(BandError::default(), |a, b| BandError {
        voxels: a.voxels + b.voxels,
        violated: a.violated + b.violated,
        l1: a.l1 + b.l1,
        l2: a.l2 + b.l2,
        largest: a.largest.max(b.largest),
    });
    total.l2 = total.l2.sqrt();
    total
}

/// Doses are f32: a response on the edge of its band is within it.
const ROUNDING: f64 = 1e-7;

/// The largest Jaccard index of {dose > t} with the part over some thresholds; voxels outside the region that counts
/// are void.
pub(super) fn largest_index(
    dose: &Volume<f32>,
    labels: &Volume<u8>,
    thresholds: impl Iterator<Item = f64>,
) -> f64 {
    let thresholds: Vec<f64> = thresholds.collect();
    // Voxels whose dose lies between two thresholds, of the part and of the rest
    let cells = dose
        .values
        .par_chunks(BLOCK)
        .zip(labels.values.par_chunks(BLOCK))
        .map(|(dose, labels)| {
            let mut cells = vec![[0u64; 2]; thresholds.len() + 1];
            for (&d, &l) in dose.iter().zip(labels) {
                let passed = thresholds.partition_point(|&t| f64::from(d) > t);
                cells[passed][usize::from(l != label::PART)] += 1;
            }
            cells
        })
        .reduce(
            || vec![[0; 2]; thresholds.len() + 1],
            |a, b| {
                a.iter()
                    .zip(&b)
                    .map(|(a, b)| [a[0] + b[0], a[1] + b[1]])
                    .collect()
            },
        );
    let part: u64 = cells.iter().map(|c| c[0]).sum();
    let (mut above, mut best) = ([0u64; 2], 0.0f64);
    for cell in cells[1..].iter().rev() {
        above = [above[0] + cell[0], above[1] + cell[1]];
        best = best.max(above[0] as f64 / (part + above[1]) as f64);
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VolumeGrid;
    use crate::response::{Identity, Logistic};
    use crate::target::label::{OUTSIDE, PART, VOID};

    fn volume<T: Clone>(values: &[T]) -> Volume<T> {
        Volume {
            grid: VolumeGrid::centered([1, 1, values.len()], 0.5),
            values: values.to_vec(),
        }
    }

    #[test]
    fn norms_by_hand() {
        let labels = volume(&[PART, PART, VOID, VOID, OUTSIDE]);
        let target = volume(&[1.0, 1.0, 0.0, 0.0, 1.0]);
        let dose = volume(&[0.5, 1.25, 0.25, 0.0, 9.0]);
        let band = Band::around(&target, &labels, false, 0.125);
        let error = band_error(&dose, &band, Region::All, &Identity);
        // 0.375, 0.125, 0.125 out of their bands
        assert_eq!((error.voxels, error.violated), (4, 3));
        assert!((error.l1 - 0.625).abs() < 1e-12);
        assert!((error.l2 - (0.375f64.powi(2) + 2.0 * 0.125f64.powi(2)).sqrt()).abs() < 1e-12);
        assert_eq!(error.largest, 0.375);
        let part = band_error(&dose, &band, Region::Part, &Identity);
        let void = band_error(&dose, &band, Region::Void, &Identity);
        assert_eq!((part.violated, void.violated), (2, 1));
        assert!((part.l1 + void.l1 - error.l1).abs() < 1e-12);
        let mask = [false, true, false, true, true];
        assert_eq!(
            band_error(&dose, &band, Region::Mask(&mask), &Identity).l1,
            0.125
        );
        // A field of tolerances: only the first voxel is out of its band
        let field = [0.25f32, 0.25, 0.25, 0.0, 0.0];
        let error = band_error(&dose, &band.with_tolerance(&field), Region::All, &Identity);
        assert_eq!((error.violated, error.l1), (1, 0.25));
    }

    #[test]
    fn grey_targets_and_responses_are_measured_in_units_of_the_response() {
        let labels = volume(&[PART, VOID]);
        let target = volume(&[0.7, 0.3]);
        let response = Logistic::new(Default::default()).unwrap();
        let dose = volume(&[response.inverse(0.7), 0.5]);
        let band = Band::around(&target, &labels, true, 0.0);
        let error = band_error(&dose, &band, Region::All, &response);
        // The first is where it should be, the second responds with 0.5
        assert!(
            (error.l1 - 0.2).abs() < 1e-6 && (error.largest - 0.2).abs() < 1e-6,
            "{error:?}"
        );
    }

    #[test]
    fn an_index_over_given_thresholds_is_that_of_the_definition() {
        let labels = volume(&[PART, PART, VOID, VOID, OUTSIDE]);
        let dose = volume(&[0.9, 0.6, 0.7, 0.1, 0.8]);
        let at = |t: f64| largest_index(&dose, &labels, std::iter::once(t));
        assert_eq!(
            [at(0.0), at(0.5), at(0.65), at(0.85), at(0.9)],
            [0.4, 0.5, 0.25, 0.5, 0.0]
        );
        assert_eq!(
            largest_index(&dose, &labels, [0.0, 0.5, 0.65, 0.85].into_iter()),
            0.5
        );
    }
}
