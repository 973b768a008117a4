//! IoU and process window of a dose in two passes, for the history of an optimization.
//!
//! The IoU is the best over 1024 thresholds, evenly spread from the smallest to the largest response: never more than the
//! best over all thresholds ([`scan`](super::scan)), and attained by a threshold. The process window is exact.
//!
//! **Cost** two passes over labels (1 byte) and response (4 bytes), about 2 ns a voxel on two cores; no memory to speak of.
//!
//! ```
//! use tomolith_metrics::quick::quick;
//! use tomolith_core::target::label::{OUTSIDE, PART, VOID};
//! let found = quick(&[PART, PART, VOID, VOID, OUTSIDE], &[0.9, 0.7, 0.2, 0.8, 9.0]).unwrap();
//! assert!((found.iou - 2.0 / 3.0).abs() < 1e-12); // between 0.2 and 0.7: both part voxels and one of the void
//! assert!((found.process_window.unwrap() + 0.1).abs() < 1e-6); // 0.7 − 0.8
//! ```

use super::buckets::{class, shares};
use tomolith_core::field::counter::{BINS, Counter};
use tomolith_core::field::{BLOCK, LANES};
use tomolith_core::parallel::InParallel;
use tomolith_core::target::label;

/// Smallest and largest response of part and void.
type Ranges = [[f32; 2]; 2];
/// Part and void voxels per bin.
type Table = Vec<[u64; 2]>;

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quick {
    /// The best IoU.
    pub iou: f64,
    /// The process window; None without void.
    pub process_window: Option<f64>,
    /// Both numbers are the same for any void below this response: the lower one of the best threshold and the largest response of the void.
    pub lowest: f32,
}

/// Best IoU, and process window where there is void; `None` without part, or when a response is no finite number.
#[must_use]
pub fn quick(labels: &[u8], response: &[f32]) -> Option<Quick> {
    let counts = |low, scale| counts(labels, response, low, scale);
    measured(ranges(labels, response), counts)
}

/// [`quick`] of a response that lives elsewhere: the same numbers, to the last bit.
#[must_use]
pub fn quick_of<F>(counter: &dyn Counter<F>, response: &F) -> Option<Quick> {
    let counts = |low, scale| counter.counts(response, low, scale);
    measured(counter.ranges(response), counts)
}

fn measured([part, void]: Ranges, counts: impl FnOnce(f32, f32) -> Table) -> Option<Quick> {
    let (low, high) = (part[0].min(void[0]), part[1].max(void[1]));
    if part[0] > part[1] || !(low.is_finite() && high.is_finite()) {
        return None;
    }
    let scale = if high > low {
        BINS as f32 / (high - low)
    } else {
        0.0
    };
    let table = counts(low, scale);
    let parts: u64 = table.iter().map(|bin| bin[0]).sum();
    let mut above = [0, 0];
    let (mut best, mut of_best) = (0.0f64, BINS);
    for (i, bin) in table.iter().enumerate().rev() {
        above = [above[0] + bin[0], above[1] + bin[1]];
        let iou = above[0] as f64 / (parts + above[1]) as f64;
        if iou > best {
            (best, of_best) = (iou, i);
        }
    }
    let has_void = void[0] <= void[1];
    Some(Quick {
        iou: best,
        process_window: has_void.then(|| f64::from(part[0]) - f64::from(void[1])),
        lowest: (low + (high - low) * (of_best as f32 / BINS as f32)).min(void[1]),
    })
}

fn ranges(labels: &[u8], response: &[f32]) -> Ranges {
    let empty = [[f32::INFINITY, f32::NEG_INFINITY]; 2];
    let blocks = labels
        .chunks(BLOCK)
        .zip(response.chunks(BLOCK))
        .par_map(|(labels, values)| {
            // Sixteen at a time
            let (labels, last_labels) = labels.as_chunks::<LANES>();
            let (values, last_values) = values.as_chunks::<LANES>();
            let mut lanes = empty.map(|class| class.map(|value| [value; LANES]));
            for (labels, values) in labels.iter().zip(values) {
                widen(&mut lanes, labels, values);
            }
            widen(&mut lanes, last_labels, last_values);
            let of_lane = |i: usize| [0, 1].map(|class: usize| lanes[class].map(|side| side[i]));
            (0..LANES).map(of_lane).fold(empty, join)
        });
    blocks.into_iter().fold(empty, join)
}

fn join(a: Ranges, b: Ranges) -> Ranges {
    [0, 1].map(|c| [a[c][0].min(b[c][0]), a[c][1].max(b[c][1])])
}

/// Widens the ranges of each lane by a voxel.
#[inline(always)]
fn widen(lanes: &mut [[[f32; LANES]; 2]; 2], labels: &[u8], values: &[f32]) {
    for ([low, high], class) in lanes.iter_mut().zip([label::PART, label::VOID]) {
        let lanes = low.iter_mut().zip(high).zip(labels.iter().zip(values));
        for ((low, high), (&label, &value)) in lanes {
            // No branches, and not `min` and `max`, which look for numbers that are none
            let is_own = label == class;
            *low = if is_own & (value < *low) { value } else { *low };
            *high = if is_own & (value > *high) {
                value
            } else {
                *high
            };
        }
    }
}

fn counts(labels: &[u8], response: &[f32], low: f32, scale: f32) -> Table {
    let empty = || vec![[0; 2]; BINS];
    let tables = shares(labels.len()).into_iter().par_map(|share| {
        let mut table: Table = empty();
        for (&label, &value) in labels[share.clone()].iter().zip(&response[share]) {
            if let Some(class) = class(label) {
                // Rising with the value, so that the bins from one up are all above a threshold
                let bin = ((value - low) * scale) as usize;
                table[bin.min(BINS - 1)][class] += 1;
            }
        }
        table
    });
    tables.into_iter().fold(empty(), |mut a, b| {
        for (a, b) in a.iter_mut().zip(b) {
            *a = [a[0] + b[0], a[1] + b[1]];
        }
        a
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::Scan;
    use tomolith_core::check::random;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn it_is_at_most_the_exact_one_and_close_to_it() {
        for seed in 1..20u64 {
            let n = 20_000;
            let mut dice = random(seed);
            let labels: Vec<u8> = (0..n)
                .map(|_| [OUTSIDE, VOID, PART][(dice() * 3.0) as usize])
                .collect();
            let response: Vec<f32> = labels
                .iter()
                .map(|l| 0.4 * f32::from(*l) + dice())
                .collect();
            let scan = Scan::new(&labels, &response).unwrap();
            let found = quick(&labels, &response).unwrap();
            let (iou, exact) = (found.iou, scan.best_plateau().unwrap().iou);
            assert!(iou <= exact && iou > exact - 2e-3, "{iou} {exact}");
            let (part, void) = (scan.part().unwrap(), scan.void().unwrap());
            assert_eq!(
                found.process_window,
                Some(f64::from(part.min) - f64::from(void.max))
            );
        }
    }

    #[test]
    fn without_part_or_numbers_there_is_none() {
        assert_eq!(quick(&[VOID], &[1.0]), None);
        assert_eq!(quick(&[PART], &[f32::INFINITY]), None);
        let alone = quick(&[PART, OUTSIDE], &[0.5, f32::NAN]).unwrap();
        assert_eq!((alone.iou, alone.process_window), (1.0, None));
    }
}
