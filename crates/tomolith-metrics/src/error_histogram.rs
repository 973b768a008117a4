//! Voxels of a gray target over the error m − f of their response, and whether they gather at the edges of the band.
//!
//! Bins are of one width for all prints, so that those of different runs compare: 800 from −1 to 1; from −10 to 10, −100 to 100, … where an
//! error is larger than 1. Both edges of a band of half width ε = 0.05, 0.1, 0.2, … are edges of bins.
//!
//! ```text
//! band_edge_peak = max(n(−1), n(0)) / max(n(−3), n(2))      n(k) = #{ ε + k·w ≤ |m − f| < ε + (k + 1)·w }
//! ```
//!
//! with w = 0.01 (a two-hundredth of the range): as many voxels on the better filled side of the band's edges as one step farther inside or outside,
//! whichever is more. An optimization that leaves a voxel alone once it is within the band gathers voxels there (Li et al., Additive
//! Manufacturing 94 (2024) 104447, section 3.4.2, which sees such peaks at ε = 0.2 and 0.1 and gives no number). Not defined for ε below 3·w:
//! the edges of so narrow a band cannot be distinguished from the errors about 0, which are the most frequent.
//!
//! ```
//! use tomolith_metrics::error_histogram::ErrorHistogram;
//! // Ten voxels just within a band of 0.1, two at 0.075, one at 0.125
//! let mut counts = vec![[0; 2]; 800];
//! (counts[439], counts[430], counts[450]) = ([10, 0], [2, 0], [0, 1]);
//! let errors = ErrorHistogram { reach: 1.0, counts };
//! assert_eq!(errors.band_edge_peak(0.1), Some(5.0));
//! assert_eq!(errors.band_edge_peak(0.0), None);
//! ```

use super::Measure;
use super::buckets::class;
use rayon::prelude::*;
use tomolith_core::field::BLOCK;

/// Bins from −reach to reach.
const BINS: usize = 800;
/// Windows at the edges of the band, of the whole range.
const WINDOWS: f64 = 200.0;
/// Share by which a band of three windows may miss their width.
const ROUNDING: f64 = 1e-9;

/// Voxels of part (f ≥ ½) and void over the error of the response.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorHistogram {
    /// Errors are from −reach to reach: 1, or the power of ten that holds them all.
    pub reach: f64,
    /// Bright and dark voxels per bin, all of equal width.
    pub counts: Vec<[u64; 2]>,
}

impl ErrorHistogram {
    /// Counts voxels that count, of which no error is larger than `largest`.
    pub(super) fn of(labels: &[u8], response: &[f32], wanted: &[f32], largest: f64) -> Self {
        let powers = std::iter::successors(Some(1.0), |reach| Some(10.0 * reach));
        // Responses are finite, so that some power holds them
        let reach = powers.into_iter().find(|reach| *reach >= largest);
        let reach = reach.unwrap_or(f64::MAX);
        let empty = || vec![[0; 2]; BINS];
        let counts = labels
            .par_chunks(BLOCK)
            .zip(response.par_chunks(BLOCK))
            .zip(wanted.par_chunks(BLOCK))
            .fold(empty, |counts, ((labels, response), wanted)| {
                counted(counts, labels, response, wanted, reach)
            })
            .reduce(empty, joined);
        ErrorHistogram { reach, counts }
    }

    /// See the [module page](self); `None` where there is nothing to compare with.
    #[must_use]
    pub fn band_edge_peak(&self, half_width: f64) -> Measure {
        let window = 2.0 * self.reach / WINDOWS;
        if half_width < 3.0 * window * (1.0 - ROUNDING) {
            return None;
        }
        let at = |k: f64| {
            let ends = [half_width + k * window, half_width + (k + 1.0) * window];
            self.within(ends) + self.within([-ends[1], -ends[0]])
        };
        let background = at(-3.0).max(at(2.0));
        (background > 0.0).then(|| at(-1.0).max(at(0.0)) / background)
    }

    /// Voxels between two errors; a bin that an end divides counts by its part.
    fn within(&self, ends: [f64; 2]) -> f64 {
        let bins = self.counts.len() as f64;
        let [low, high] = ends.map(|end| (end + self.reach) / (2.0 * self.reach) * bins);
        let part = |(i, n): (usize, &[u64; 2])| {
            let (from, to) = (low.max(i as f64), high.min((i + 1) as f64));
            (to - from).max(0.0) * (n[0] + n[1]) as f64
        };
        self.counts.iter().enumerate().map(part).sum()
    }
}

/// Counts with those of a block of voxels.
fn counted(
    mut counts: Vec<[u64; 2]>,
    labels: &[u8],
    response: &[f32],
    wanted: &[f32],
    reach: f64,
) -> Vec<[u64; 2]> {
    for ((&label, &m), &f) in labels.iter().zip(response).zip(wanted) {
        let Some(class) = class(label) else {
            continue;
        };
        let bin = (f64::from(m) - f64::from(f) + reach) / (2.0 * reach) * BINS as f64;
        counts[(bin.max(0.0) as usize).min(BINS - 1)][class] += 1;
    }
    counts
}

fn joined(mut all: Vec<[u64; 2]>, more: Vec<[u64; 2]>) -> Vec<[u64; 2]> {
    for (sum, counts) in all.iter_mut().zip(more) {
        *sum = [sum[0] + counts[0], sum[1] + counts[1]];
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn histogram(errors: &[f32]) -> ErrorHistogram {
        let wanted = vec![0.0; errors.len()];
        let largest = errors.iter().fold(0.0f32, |most, e| most.max(e.abs()));
        ErrorHistogram::of(&vec![PART; errors.len()], errors, &wanted, largest.into())
    }

    #[test]
    fn every_voxel_that_counts_is_in_the_bin_of_its_error() {
        let n = 2 * BLOCK + 4;
        let labels: Vec<u8> = (0..n).map(|i| [OUTSIDE, VOID, PART][i % 3]).collect();
        let response: Vec<f32> = (0..n).map(|i| [9.0, 0.25, 0.876][i % 3]).collect();
        let histogram = ErrorHistogram::of(&labels, &response, &vec![0.5; n], 0.376);
        let third = (n / 3) as u64;
        // (−0.25 + 1)/2·800 and (0.376 + 1)/2·800
        assert_eq!(histogram.counts[300], [0, third]);
        assert_eq!(histogram.counts[550], [third, 0]);
        let all: u64 = histogram.counts.iter().flatten().sum();
        assert_eq!(all, 2 * third);
    }

    #[test]
    fn errors_above_one_widen_the_range_and_the_ends_belong_to_it() {
        let histogram = histogram(&[1.0, -1.0, 30.0, -100.0]);
        assert_eq!(histogram.reach, 100.0);
        assert_eq!(histogram.counts[0], [1, 0]);
        assert_eq!(super::tests::histogram(&[1.0, -1.0]).counts[799], [1, 0]);
    }

    #[test]
    fn an_even_spread_has_no_peak_and_its_end_at_the_edge_neither() {
        let even: Vec<f32> = (0..40_000).map(|i| i as f32 / 20_000.0 - 1.0).collect();
        let peak = histogram(&even).band_edge_peak(0.2).unwrap();
        assert!((peak - 1.0).abs() < 0.02, "{peak}");
        // All within ±0.2: nothing outside, and no more at the edge than inside
        let within: Vec<f32> = even.iter().map(|e| 0.2 * e).collect();
        let peak = histogram(&within).band_edge_peak(0.2).unwrap();
        assert!((peak - 1.0).abs() < 0.02, "{peak}");
        let gathered = [vec![-0.199f32; 2000], within].concat();
        let peak = histogram(&gathered).band_edge_peak(0.2).unwrap();
        assert!(peak > 1.9, "{peak}");
        assert_eq!(histogram(&[0.0]).band_edge_peak(0.2), None);
        assert!(histogram(&even).band_edge_peak(0.03).is_some());
        assert_eq!(histogram(&even).band_edge_peak(0.029), None);
    }
}
