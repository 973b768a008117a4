//! The two scales in which a method that is published with normalized doses is reported.
//!
//! A normalized method divides every dose by the largest, so that its thresholds lie between 0 and 1. Its patterns are returned
//! at that scale: largest dose 1, thresholds as published. A comparison with a method that works with absolute doses is fair
//! only at a common scale; that of the mean dose in the part is the one used here.
//!
//! ```
//! use tomolith_optimize::PublishedScale;
//! use tomolith_core::target::label::{PART, VOID};
//! // two part voxels of mean 1.5 and one void voxel
//! let scale = PublishedScale::of(&[1.0, 2.0, 0.5], &[PART, PART, VOID]).unwrap();
//! assert_eq!((scale.largest, scale.part_mean), (2.0, 1.5));
//! assert!((scale.at_mean(0.5, 0.9) - 0.3).abs() < 1e-12); // a dose of 0.5 where the part has a mean of 0.9
//! ```

use tomolith_core::target::label;

/// Largest and mean dose, which two programs may divide by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PublishedScale {
    /// Largest dose of the voxels that count.
    pub largest: f64,
    /// Mean dose of the part.
    pub part_mean: f64,
}

impl PublishedScale {
    /// The scale of a dose; None when it has no part, or no dose.
    #[must_use]
    pub fn of(dose: &[f32], labels: &[u8]) -> Option<Self> {
        let (mut largest, mut sum, mut part) = (0.0f64, 0.0, 0u64);
        for (&dose, &label) in dose.iter().zip(labels) {
            let dose = f64::from(dose);
            if label != label::OUTSIDE {
                largest = largest.max(dose);
            }
            if label == label::PART {
                sum += dose;
                part += 1;
            }
        }
        (part > 0 && sum > 0.0).then(|| PublishedScale {
            largest,
            part_mean: sum / part as f64,
        })
    }

    /// A dose or threshold when the mean dose of the part is `mean`.
    #[must_use]
    pub fn at_mean(&self, value: f64, mean: f64) -> f64 {
        value * mean / self.part_mean
    }
}
