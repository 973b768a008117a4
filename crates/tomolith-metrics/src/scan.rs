//! Counts of part and void voxels above any threshold, exact and without sorting.
//!
//! # What it is for
//! With a(t) and b(t) the part and void voxels whose response is above t, and N the part voxels,
//!
//! ```text
//! IoU(t) = a(t) / (N + b(t))
//! ```
//!
//! It changes only at values of the response. Sorting 5·10⁸ values to find its maximum is out of question, so:
//!
//! 1. One pass counts part and void voxels in 2²² buckets, the top 22 bits of the f32 (ordered like the numbers). In the
//!    gaps between buckets IoU is then exact, and inside a bucket it is bounded by the counts before and after it.
//! 2. Buckets whose bounds leave a question open (can the best IoU be in here? does it cross 0.95 of the best, or the best − 0.01, here? does
//!    a threshold or a rank that the caller needs lie in here?) are counted once more by their low 10 bits: one bin is one f32
//!    value, and nothing remains open. Later questions reuse the bins that were opened.
//!
//! Everything is whole numbers compared as fractions, so the result is exact and does not depend on the order.
//!
//! # Thresholds
//! Allowed are t ≥ min(0, smallest response): a print needs dose. A plateau is the longest interval of t over which IoU
//! has its best value; of several the longest counts (of equally long ones the lowest), and its middle is the best
//! threshold.
//!
//! # Cost
//! Two passes over response and labels, each about a second for 10⁹ voxels on two cores, and 32 MB per thread; one more for
//! each later question, or list of them, about buckets that are still closed.
//!
//! # Example
//! Part voxels 0.9 and 0.7, void voxels 0.2 and 0.8:
//! ```
//! use tomolith_metrics::scan::Scan;
//! use tomolith_core::target::label::{PART, VOID};
//! let scan = Scan::new(&[PART, PART, VOID, VOID], &[0.9, 0.7, 0.2, 0.8]).unwrap();
//! let best = scan.best_plateau().unwrap();
//! assert!((best.iou - 2.0 / 3.0).abs() < 1e-12); // t in [0.2, 0.7): both part voxels and one void voxel
//! assert_eq!((best.from, best.to), (0.2f32 as f64, 0.7f32 as f64));
//! assert_eq!(scan.count_above(0.75), [1, 1]); // 0.9 of the part, 0.8 of the void
//! ```

mod iou;

use super::buckets::{
    Bucket, Counts, FINE, FINE_BITS, Share, class, count_share, key, runs, shares, value_of,
};
use super::spread::{Spread, Sums, spread};
use iou::Fraction;
pub use iou::Plateau;
use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use tomolith_core::dose::Work;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::BLOCK;
use tomolith_core::parallel::InParallel;

/// Open buckets that are counted in one pass, at most: 32 MB per thread.
const OPEN_AT_ONCE: usize = 4096;

/// The values of an opened bucket, ascending, with their counts.
type Opened = BTreeMap<usize, Vec<(f32, Counts)>>;

/// A response with its labels, counted.
pub struct Scan<'a> {
    labels: &'a [u8],
    response: &'a [f32],
    buckets: Vec<Bucket>,
    spread: [Option<Spread>; 2],
    opened: Mutex<Opened>,
    settled: OnceLock<Option<Fraction>>,
    work: Work,
}

/// Share of the work that one pass over all voxels is.
const PASS: f64 = 0.2;

impl<'a> Scan<'a> {
    /// Counts. Labels and response belong to the same voxels.
    ///
    /// # Errors
    /// [`Error::Shape`] when they differ in length; [`Error::NonFinite`] when the response of a part or void voxel is
    /// not finite.
    pub fn new(labels: &'a [u8], response: &'a [f32]) -> Result<Self> {
        Self::under(labels, response, Work::new())
    }

    /// [`new`](Self::new) as a part of a run. When that is canceled later, its answers mean nothing.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::Canceled`].
    pub fn under(labels: &'a [u8], response: &'a [f32], work: Work) -> Result<Self> {
        if labels.len() != response.len() {
            return Err(Error::shape(
                "labels and response",
                vec![labels.len()],
                vec![response.len()],
            ));
        }
        let pass = work.part(PASS);
        let steps = pass.steps(labels.len().div_ceil(BLOCK));
        let parts: Vec<Share> = shares(labels.len())
            .into_iter()
            .par_map(|share| count_share(&labels[share.clone()], &response[share], &steps));
        work.check()?;
        drop(pass);
        let blocks: Vec<[Sums; 2]> = parts.iter().flat_map(|p| p.1.iter().copied()).collect();
        if blocks
            .iter()
            .flatten()
            .any(|s| !s.sum.is_finite() || !s.squares.is_finite())
        {
            return Err(not_finite(labels, response));
        }
        let mut scan = Scan {
            labels,
            response,
            buckets: Vec::new(),
            spread: [0, 1].map(|c| spread(&blocks, c)),
            opened: Mutex::new(Opened::new()),
            settled: OnceLock::new(),
            work,
        };
        // Only tops between the smallest and the largest value can be filled
        let top = |value: f32| (key(value) >> FINE_BITS) as usize;
        let lowest = scan.spread.iter().flatten().map(|s| top(s.min)).min();
        let highest = scan.spread.iter().flatten().map(|s| top(s.max)).max();
        let range = lowest.unwrap_or(0)..highest.map_or(0, |h| h + 1);
        let mut above = [0, 0];
        for top in range.rev() {
            let mut counts = [0, 0];
            for (table, _) in &parts {
                let cell = table[top];
                counts = [
                    counts[0] + u64::from(cell[0]),
                    counts[1] + u64::from(cell[1]),
                ];
            }
            if counts != [0, 0] {
                scan.buckets.push(Bucket {
                    top: top as u32,
                    counts,
                    above,
                });
                above = [above[0] + counts[0], above[1] + counts[1]];
            }
        }
        scan.buckets.reverse();
        Ok(scan)
    }

    /// Response of the part voxels, `None` when there are none.
    #[must_use]
    pub fn part(&self) -> Option<Spread> {
        self.spread[0]
    }

    /// Response of the void voxels, `None` when there are none.
    #[must_use]
    pub fn void(&self) -> Option<Spread> {
        self.spread[1]
    }

    /// Number of part and void voxels.
    #[must_use]
    pub fn totals(&self) -> [u64; 2] {
        self.spread.map(|s| s.map_or(0, |s| s.count))
    }

    /// Part and void voxels whose response is above a threshold.
    #[must_use]
    pub fn count_above(&self, threshold: f64) -> [u64; 2] {
        let (at, is_within) = self.bucket_at(threshold);
        let Some(bucket) = self.buckets.get(at).filter(|_| !threshold.is_nan()) else {
            return [0, 0];
        };
        if !is_within {
            return bucket.up_from_here();
        }
        self.open(&[at]);
        let opened = self.opened();
        let above = opened[&at]
            .iter()
            .filter(|(value, _)| f64::from(*value) > threshold);
        above.fold(bucket.above, |sum, (_, counts)| {
            [sum[0] + counts[0], sum[1] + counts[1]]
        })
    }

    /// The first bucket that does not lie below a threshold, and whether the threshold lies in it.
    fn bucket_at(&self, threshold: f64) -> (usize, bool) {
        let at = self.buckets.partition_point(|b| b.end() <= threshold);
        let within = self.buckets.get(at).is_some_and(|b| b.start() <= threshold);
        (at, within)
    }

    /// The value of a rank, 0 = the smallest, among the part's voxels (`class` 0) or the void's (1); `None` when there are
    /// not that many.
    pub(super) fn value_at(&self, class: usize, rank: u64) -> Option<f32> {
        let at = self.bucket_of(class, rank)?;
        self.open(&[at]);
        let above = self.buckets[at].above[class];
        let mut below = self.totals()[class] - above - self.buckets[at].counts[class];
        let opened = self.opened();
        let found = opened[&at].iter().find(|(_, counts)| {
            below += counts[class];
            below > rank
        });
        found.map(|(value, _)| *value)
    }

    /// The bucket that a rank falls into.
    fn bucket_of(&self, class: usize, rank: u64) -> Option<usize> {
        let total = self.totals()[class];
        let at = self
            .buckets
            .partition_point(|b| total - b.above[class] <= rank);
        (rank < total).then_some(at)
    }

    /// Looks at the buckets of some thresholds and ranks `(class, rank)` in one pass, with those of the best IoU and round it:
    /// questions about them cost nothing afterwards.
    pub(super) fn look_at(&self, thresholds: &[f64], ranks: &[(usize, u64)]) {
        let places = thresholds.iter().map(|&t| self.bucket_at(t));
        let of_thresholds = places.filter(|(_, within)| *within).map(|(at, _)| at);
        let of_ranks = ranks
            .iter()
            .filter_map(|&(c, rank)| self.bucket_of(c, rank));
        let mut wanted: Vec<usize> = of_thresholds.chain(of_ranks).collect();
        wanted.extend(self.candidates());
        self.open(&wanted);
    }

    /// What was counted value by value so far.
    fn opened(&self) -> MutexGuard<'_, Opened> {
        self.opened.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Counts the values of some buckets one by one, those that are still closed.
    fn open(&self, wanted: &[usize]) {
        let mut opened = self.opened();
        let mut wanted: Vec<usize> = wanted
            .iter()
            .copied()
            .filter(|at| !opened.contains_key(at))
            .collect();
        wanted.sort_unstable();
        wanted.dedup();
        for wanted in wanted.chunks(OPEN_AT_ONCE) {
            // Open buckets are close together, so a table between the outermost of them is small
            let (Some(&first), Some(&last)) = (wanted.first(), wanted.last()) else {
                continue;
            };
            let (first, last) = (self.buckets[first].top, self.buckets[last].top);
            let mut slots = vec![u32::MAX; (last - first) as usize + 1];
            for (slot, &i) in wanted.iter().enumerate() {
                slots[(self.buckets[i].top - first) as usize] = slot as u32;
            }
            let pass = self.work.part(PASS);
            let steps = pass.steps(self.labels.len().div_ceil(BLOCK));
            let tables: Vec<Vec<[u32; 2]>> =
                shares(self.labels.len()).into_iter().par_map(|share| {
                    let mut table = vec![[0u32; 2]; wanted.len() * FINE];
                    let blocks = self.labels[share.clone()]
                        .chunks(BLOCK)
                        .zip(self.response[share].chunks(BLOCK))
                        .take_while(|_| !steps.is_canceled())
                        .inspect(|_| steps.add(1));
                    for (labels, values) in blocks {
                        for (class, run) in runs(labels) {
                            for key in values[run].iter().map(|&value| key(value)) {
                                let place = (key >> FINE_BITS).wrapping_sub(first) as usize;
                                let slot = slots.get(place).copied().unwrap_or(u32::MAX);
                                if slot != u32::MAX {
                                    table[slot as usize * FINE + key as usize % FINE][class] += 1;
                                }
                            }
                        }
                    }
                    table
                });
            for (slot, &i) in wanted.iter().enumerate() {
                let top = self.buckets[i].top << FINE_BITS;
                let values = (0..FINE)
                    .map(|low| {
                        let cells = tables.iter().map(|t| t[slot * FINE + low]);
                        let counts = cells.fold([0, 0], |sum: Counts, cell| {
                            [sum[0] + u64::from(cell[0]), sum[1] + u64::from(cell[1])]
                        });
                        (value_of(top | low as u32), counts)
                    })
                    .filter(|(_, counts)| *counts != [0, 0])
                    .collect();
                opened.insert(i, values);
            }
        }
    }

    /// Voxels of part and void in `bins` equal bins over `range`; values beyond go into the first and last bin. A value
    /// is placed by its top 22 bits, that is within 1/8192 of itself.
    #[must_use]
    pub fn histogram(&self, range: [f64; 2], bins: usize) -> Vec<[u64; 2]> {
        let mut counts = vec![[0, 0]; bins];
        let width = (range[1] - range[0]) / bins as f64;
        if bins == 0 || width.is_nan() || width <= 0.0 {
            return counts;
        }
        for bucket in &self.buckets {
            let place = (0.5 * (bucket.start() + bucket.end()) - range[0]) / width;
            let bin = &mut counts[(place.max(0.0) as usize).min(bins - 1)];
            *bin = [bin[0] + bucket.counts[0], bin[1] + bucket.counts[1]];
        }
        counts
    }
}

fn not_finite(labels: &[u8], response: &[f32]) -> Error {
    let found = labels
        .iter()
        .zip(response)
        .find(|(label, value)| class(**label).is_some() && !value.is_finite());
    Error::NonFinite {
        what: "the response of a voxel".to_owned(),
        value: found.map_or(f64::NAN, |(_, value)| f64::from(*value)),
        iteration: 0,
    }
}

#[cfg(test)]
mod tests;
