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
//!    a threshold or a rank that is asked for lie in here?) are counted once more by their low 10 bits: one bin is one f32
//!    value, and nothing remains open. What was opened is kept for later questions.
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

use super::buckets::{
    Bucket, Counts, FINE, FINE_BITS, Share, class, count_share, key, shares, value_of,
};
use super::spread::{Spread, Sums, spread};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};
use tomolith_core::dose::Run;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::BLOCK;

/// Open buckets that are counted in one pass, at most: 32 MB per thread.
const OPEN_AT_ONCE: usize = 4096;

/// An interval [from, to) of thresholds over which IoU does not change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plateau {
    /// Lower end, included.
    pub from: f64,
    /// Upper end, not included.
    pub to: f64,
    /// IoU on it.
    pub iou: f64,
}

impl Plateau {
    /// Its middle.
    #[must_use]
    pub fn middle(&self) -> f64 {
        0.5 * (self.from + self.to)
    }
}

/// An IoU as a fraction.
#[derive(Clone, Copy, Debug)]
struct Fraction {
    above: u64,
    below: u64,
}

impl Fraction {
    /// self − factor·other: its sign, with `factor` = num/den.
    fn compare(&self, other: &Fraction, num: u128, den: u128) -> std::cmp::Ordering {
        let left = den * u128::from(self.above) * u128::from(other.below);
        left.cmp(&(num * u128::from(other.above) * u128::from(self.below)))
    }

    /// Whether self > 0.95·other.
    fn is_near(&self, other: &Fraction) -> bool {
        self.compare(other, 19, 20).is_gt()
    }

    /// Whether self ≥ other − 0.01.
    fn is_hardly_below(&self, other: &Fraction) -> bool {
        let whole = [self.above, self.below, other.above, other.below];
        let [a, b, c, d] = whole.map(i128::from);
        100 * a * d >= (100 * c - d) * b
    }

    fn value(&self) -> f64 {
        if self.below == 0 {
            0.0
        } else {
            self.above as f64 / self.below as f64
        }
    }
}

/// A piece [from, to) of the threshold axis, and bounds of IoU on it (equal ones: exact).
struct Piece {
    from: f64,
    to: f64,
    low: Fraction,
    high: Fraction,
    /// Position in the list of buckets, when the piece lies inside a bucket that was not opened.
    closed: Option<usize>,
}

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
    run: Run,
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
        Self::under(labels, response, Run::new())
    }

    /// The same as a part of a run. When that is canceled later, numbers that are asked for mean nothing.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::Canceled`].
    pub fn under(labels: &'a [u8], response: &'a [f32], run: Run) -> Result<Self> {
        if labels.len() != response.len() {
            return Err(Error::Shape {
                what: "labels and response".to_owned(),
                expected: vec![labels.len()],
                found: vec![response.len()],
            });
        }
        let pass = run.part(PASS);
        let steps = pass.steps(labels.len().div_ceil(BLOCK));
        let parts: Vec<Share> = shares(labels.len())
            .into_par_iter()
            .map(|share| count_share(&labels[share.clone()], &response[share], &steps))
            .collect();
        run.check()?;
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
            run,
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

    /// Looks at the buckets of some thresholds and ranks `(class, rank)` in one pass, with those of the best IoU: questions
    /// about them cost nothing afterwards.
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

    /// IoU of {response > threshold} with the part, `None` when there is no part.
    #[must_use]
    pub fn iou_at(&self, threshold: f64) -> Option<f64> {
        self.part()?;
        Some(self.iou(self.count_above(threshold)).value())
    }

    fn iou(&self, above: Counts) -> Fraction {
        Fraction {
            above: above[0],
            below: self.totals()[0] + above[1],
        }
    }

    /// Thresholds start here.
    fn lowest_threshold(&self) -> f64 {
        let smallest = self
            .spread
            .iter()
            .flatten()
            .map(|s| s.min)
            .fold(f32::INFINITY, f32::min);
        f64::from(smallest.min(0.0))
    }

    /// The threshold axis from the lowest allowed threshold upwards, cut into pieces.
    fn pieces(&self, opened: &Opened) -> Vec<Piece> {
        let start = self.lowest_threshold();
        let exact = |from: f64, to: f64, above: Counts| {
            let iou = self.iou(above);
            Piece {
                from: from.max(start),
                to,
                low: iou,
                high: iou,
                closed: None,
            }
        };
        let mut pieces = Vec::new();
        let mut end = start;
        for (i, bucket) in self.buckets.iter().enumerate() {
            pieces.push(exact(end, bucket.start(), bucket.up_from_here()));
            end = bucket.end();
            let Some(values) = opened.get(&i) else {
                pieces.push(Piece {
                    from: bucket.start().max(start),
                    to: end,
                    low: self.iou([bucket.above[0], bucket.up_from_here()[1]]),
                    high: self.iou([bucket.up_from_here()[0], bucket.above[1]]),
                    closed: Some(i),
                });
                continue;
            };
            let mut above = bucket.up_from_here();
            let mut from = bucket.start();
            for &(value, counts) in values {
                pieces.push(exact(from, f64::from(value), above));
                above = [above[0] - counts[0], above[1] - counts[1]];
                from = f64::from(value);
            }
            pieces.push(exact(from, end, above));
        }
        pieces.push(exact(end, f64::INFINITY, [0, 0]));
        pieces.retain(|p| p.to > p.from);
        pieces
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
            let pass = self.run.part(PASS);
            let steps = pass.steps(self.labels.len().div_ceil(BLOCK));
            let tables: Vec<Vec<[u32; 2]>> = shares(self.labels.len())
                .into_par_iter()
                .map(|share| {
                    let mut table = vec![[0u32; 2]; wanted.len() * FINE];
                    let blocks = self.labels[share.clone()]
                        .chunks(BLOCK)
                        .zip(self.response[share].chunks(BLOCK))
                        .take_while(|_| !steps.is_canceled())
                        .inspect(|_| steps.add(1));
                    for (&label, &value) in blocks.flat_map(|(l, r)| l.iter().zip(r)) {
                        let Some(class) = class(label) else { continue };
                        let key = key(value);
                        let place = (key >> FINE_BITS).wrapping_sub(first) as usize;
                        let slot = slots.get(place).copied().unwrap_or(u32::MAX);
                        if slot != u32::MAX {
                            table[slot as usize * FINE + key as usize % FINE][class] += 1;
                        }
                    }
                    table
                })
                .collect();
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

    /// The best IoU, of pieces that are cut finely enough for it to be exact.
    fn settled(&self) -> Option<Fraction> {
        *self.settled.get_or_init(|| self.settle())
    }

    fn settle(&self) -> Option<Fraction> {
        let part = self.part()?;
        self.look_at(&[f64::from(part.min)], &[]);
        let pieces = self.pieces(&self.opened());
        best_of(&mut pieces.iter().filter(|p| p.closed.is_none()).map(|p| p.low))
    }

    /// Buckets that may hold the best IoU.
    fn candidates(&self) -> Vec<usize> {
        let pieces = self.pieces(&Opened::new());
        // Attained for sure: below all values, and between any two buckets
        let exact = pieces.iter().filter(|p| p.closed.is_none()).map(|p| p.low);
        let between = self.buckets.iter().map(|b| self.iou(b.above));
        let Some(at_least) = best_of(&mut exact.chain(between)) else {
            return Vec::new();
        };
        pieces
            .iter()
            .filter(|p| p.high.compare(&at_least, 1, 1).is_ge())
            .filter_map(|p| p.closed)
            .collect()
    }

    /// The longest plateau of the best IoU; `None` when there is no part, or no threshold prints any of it.
    #[must_use]
    pub fn best_plateau(&self) -> Option<Plateau> {
        let best = &self.settled()?;
        if best.above == 0 {
            return None;
        }
        let mut longest: Option<Plateau> = None;
        let mut current: Option<Plateau> = None;
        for piece in self.pieces(&self.opened()) {
            if piece.closed.is_some() || piece.low.compare(best, 1, 1).is_ne() {
                current = None;
                continue;
            }
            let run = Plateau {
                from: current.map_or(piece.from, |c| c.from),
                to: piece.to,
                iou: best.value(),
            };
            current = Some(run);
            if longest.is_none_or(|l| run.to - run.from > l.to - l.from) {
                longest = Some(run);
            }
        }
        longest
    }

    /// Length of {t in [0, 1]: IoU(t) > 0.95·best}; `None` when there is no part.
    #[must_use]
    pub fn length_near_best(&self) -> Option<f64> {
        let best = &self.settled()?;
        let runs = self.runs(best, Fraction::is_near);
        let length = |(from, to): &(f64, f64)| to.clamp(0.0, 1.0) - from.clamp(0.0, 1.0);
        Some(runs.iter().map(length).sum())
    }

    /// The thresholds [from, to) round the best one over which IoU is at least its best − 0.01, with the best IoU; `None` as for
    /// [`best_plateau`](Self::best_plateau). No upper end where the best IoU itself is at most 0.01.
    #[must_use]
    pub fn round_best(&self) -> Option<Plateau> {
        let plateau = self.best_plateau()?;
        let runs = self.runs(&self.settled()?, Fraction::is_hardly_below);
        let middle = plateau.middle();
        let is_round = |(from, to): &(f64, f64)| *from <= middle && middle < *to;
        let (from, to) = runs.into_iter().find(is_round)?;
        Some(Plateau {
            from,
            to,
            iou: plateau.iou,
        })
    }

    /// Runs [from, to) of thresholds whose IoU is near the best one. Neighboring pieces are joined, so that rounding does not
    /// add up.
    fn runs(
        &self,
        best: &Fraction,
        is_near: impl Fn(&Fraction, &Fraction) -> bool,
    ) -> Vec<(f64, f64)> {
        self.open_edges(best);
        let mut runs: Vec<(f64, f64)> = Vec::new();
        let mut was_near = false;
        for piece in self.pieces(&self.opened()) {
            let near = is_near(&piece.low, best);
            match runs.last_mut() {
                Some(run) if near && was_near => run.1 = piece.to,
                _ if near => runs.push((piece.from, piece.to)),
                _ => {}
            }
            was_near = near;
        }
        runs
    }

    /// Looks at the buckets in which IoU comes near its best or leaves it, by either rule, in one pass.
    fn open_edges(&self, best: &Fraction) {
        let is_edge = |p: &Piece| {
            [Fraction::is_near, Fraction::is_hardly_below]
                .iter()
                .any(|rule| rule(&p.high, best) && !rule(&p.low, best))
        };
        let pieces = self.pieces(&self.opened());
        let edges = pieces.iter().filter(|p| is_edge(p));
        self.open(&edges.filter_map(|p| p.closed).collect::<Vec<_>>());
    }

    /// IoU at about `samples` thresholds from the lowest allowed one to the largest response: pairs of a threshold and
    /// the exact IoU there, ascending.
    #[must_use]
    pub fn curve(&self, samples: usize) -> Vec<[f64; 2]> {
        let Some(last) = self.buckets.last() else {
            return Vec::new();
        };
        if self.part().is_none() || samples < 2 {
            return Vec::new();
        }
        let (low, high) = (self.lowest_threshold(), last.end());
        let mut curve: Vec<[f64; 2]> = Vec::with_capacity(samples);
        for i in 0..samples {
            let wanted = low + (high - low) * i as f64 / (samples - 1) as f64;
            // Ends of buckets are thresholds at which the counts are exact
            let at = self.buckets.partition_point(|b| b.end() <= wanted);
            let point = match self.buckets.get(at) {
                Some(bucket) if bucket.start() <= wanted => {
                    [bucket.end(), self.iou(bucket.above).value()]
                }
                Some(bucket) => [wanted, self.iou(bucket.up_from_here()).value()],
                None => [wanted, 0.0],
            };
            if curve.last().is_none_or(|p| p[0] < point[0]) {
                curve.push(point);
            }
        }
        curve
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

fn best_of(ious: &mut dyn Iterator<Item = Fraction>) -> Option<Fraction> {
    ious.max_by(|a, b| a.compare(b, 1, 1))
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
mod tests {
    use super::*;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    /// Everything by sorting: pieces of the threshold axis with their IoU as a fraction.
    fn brute_pieces(labels: &[u8], response: &[f32]) -> Vec<(f64, f64, u128, u128)> {
        let counted: Vec<(f32, u8)> = response
            .iter()
            .copied()
            .zip(labels.iter().copied())
            .filter(|(_, l)| *l != OUTSIDE)
            .collect();
        let mut values: Vec<f64> = counted.iter().map(|c| f64::from(c.0)).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        let parts = counted.iter().filter(|c| c.1 == PART).count() as u128;
        let start = values[0].min(0.0);
        let mut edges = vec![start];
        edges.extend(values.iter().filter(|v| **v > start));
        edges.push(f64::INFINITY);
        edges
            .windows(2)
            .map(|e| {
                let above = |l: u8| {
                    counted
                        .iter()
                        .filter(|c| c.1 == l && f64::from(c.0) > e[0])
                        .count() as u128
                };
                (e[0], e[1], above(PART), parts + above(VOID))
            })
            .collect()
    }

    fn brute_best(pieces: &[(f64, f64, u128, u128)]) -> Option<Plateau> {
        let best = pieces.iter().max_by(|a, b| (a.2 * b.3).cmp(&(b.2 * a.3)))?;
        let is_best = |p: &(f64, f64, u128, u128)| p.2 * best.3 == best.2 * p.3;
        if best.2 == 0 {
            return None;
        }
        let mut longest: Option<Plateau> = None;
        for group in pieces
            .chunk_by(|a, b| is_best(a) && is_best(b))
            .filter(|g| is_best(&g[0]))
        {
            let run = Plateau {
                from: group[0].0,
                to: group[group.len() - 1].1,
                iou: best.2 as f64 / best.3 as f64,
            };
            if longest.is_none_or(|l| run.to - run.from > l.to - l.from) {
                longest = Some(run);
            }
        }
        longest
    }

    fn brute_length(pieces: &[(f64, f64, u128, u128)]) -> f64 {
        let best = pieces
            .iter()
            .max_by(|a, b| (a.2 * b.3).cmp(&(b.2 * a.3)))
            .unwrap();
        pieces
            .iter()
            .filter(|p| 20 * p.2 * best.3 > 19 * best.2 * p.3)
            .map(|p| p.1.clamp(0.0, 1.0) - p.0.clamp(0.0, 1.0))
            .sum()
    }

    /// The run of pieces round a threshold whose IoU is at least the best − 1/100.
    fn brute_round(pieces: &[(f64, f64, u128, u128)], best: &Plateau) -> (f64, f64) {
        let top = pieces.iter().max_by(|a, b| (a.2 * b.3).cmp(&(b.2 * a.3)));
        let (above, below) = top.map(|p| (p.2, p.3)).unwrap();
        let is_near =
            |p: &(f64, f64, u128, u128)| 100 * p.2 * below + below * p.3 >= 100 * above * p.3;
        let of_best = pieces.iter().position(|p| p.0 == best.from).unwrap();
        let before = pieces[..of_best].iter().rev().take_while(|p| is_near(p));
        let after = pieces[of_best..].iter().take_while(|p| is_near(p));
        let from = before.last().map_or(best.from, |p| p.0);
        (from, after.last().unwrap().1)
    }

    struct Dice(u64);
    impl Dice {
        fn next(&mut self) -> f32 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 40) as f32 / 16_777_216.0
        }
    }

    /// Responses of many kinds: overlapping, separated, few values, tiny steps, negative, constant.
    fn cases() -> Vec<(Vec<u8>, Vec<f32>)> {
        let mut cases = Vec::new();
        for seed in 0..240u64 {
            let mut dice = Dice(seed);
            let n = 1 + (dice.next() * 120.0) as usize;
            let kind = seed % 8;
            let mut labels = Vec::new();
            let mut response = Vec::new();
            for _ in 0..n {
                let label = [OUTSIDE, VOID, VOID, PART, PART][(dice.next() * 5.0) as usize];
                let shift = f32::from(label) * 0.2;
                labels.push(label);
                response.push(match kind {
                    0 => dice.next() + shift,
                    1 => f32::from(label) + 0.3 * dice.next(),
                    2 => (dice.next() * 5.0).floor() / 4.0,
                    // All in a few buckets: only the low bits differ
                    3 => f32::from_bits(0.75f32.to_bits() + (dice.next() * 3000.0) as u32),
                    4 => dice.next() - 0.7 + shift,
                    5 => 0.5,
                    6 => {
                        if label == OUTSIDE {
                            f32::NAN
                        } else {
                            -dice.next()
                        }
                    }
                    _ => {
                        (dice.next() * 3.0).floor() * if dice.next() < 0.5 { 0.0 } else { -0.0 }
                            + (dice.next() * 2.0).floor()
                    }
                });
            }
            cases.push((labels, response));
        }
        cases
    }

    #[test]
    fn best_plateau_and_window_are_those_of_a_full_sort() {
        let mut seen = [0; 3];
        for (labels, response) in cases() {
            let scan = Scan::new(&labels, &response).unwrap();
            if !labels.contains(&PART) {
                assert_eq!((scan.best_plateau(), scan.length_near_best()), (None, None));
                seen[0] += 1;
                continue;
            }
            let pieces = brute_pieces(&labels, &response);
            let best = brute_best(&pieces);
            assert_eq!(scan.best_plateau(), best, "{labels:?} {response:?}");
            seen[if best.is_some() { 1 } else { 2 }] += 1;
            let round = scan.round_best();
            assert_eq!(round.is_some(), best.is_some());
            if let (Some(round), Some(best)) = (round, best) {
                let expected = brute_round(&pieces, &best);
                assert_eq!((round.from, round.to), expected, "{labels:?} {response:?}");
                assert_eq!(round.iou, best.iou);
            }
            if best.is_some() {
                let (a, b) = (scan.length_near_best().unwrap(), brute_length(&pieces));
                assert!((a - b).abs() < 1e-12, "{a} {b}");
            }
        }
        assert!(seen[0] > 0 && seen[1] > 150, "{seen:?}");
    }

    #[test]
    fn a_hundredth_below_the_best_is_still_round_it() {
        // 100 part voxels: without the weakest IoU is 99/100, which counts; without the two weakest 98/100, which does not
        let labels: Vec<u8> = [VOID].into_iter().chain([PART; 100]).collect();
        let mut response = vec![0.9f32; 101];
        response[..3].copy_from_slice(&[0.25, 0.5, 0.625]);
        let round = Scan::new(&labels, &response).unwrap().round_best().unwrap();
        // Below 0.25 the void gels too: 100/101 is within a hundredth of 1
        assert_eq!((round.from, round.to, round.iou), (0.0, 0.625, 1.0));
        // Two void voxels at 0.75: 100/102 is the best, 99/102 near it, 98/102 is not, and 98/100 beyond 0.75 is near again
        let labels = [[VOID; 2].as_slice(), &[PART; 100]].concat();
        let mut response = vec![0.9f32; 102];
        response[..4].copy_from_slice(&[0.75, 0.75, 0.5, 0.625]);
        let round = Scan::new(&labels, &response).unwrap().round_best().unwrap();
        assert_eq!((round.from, round.to), (0.0, 0.625));
    }

    #[test]
    fn a_dark_part_is_not_printed_by_any_threshold() {
        let scan = Scan::new(&[PART, PART, VOID], &[0.0, -0.0, 0.0]).unwrap();
        assert_eq!(
            (scan.best_plateau(), scan.length_near_best()),
            (None, Some(0.0))
        );
        // With negative responses too, the lowest threshold prints all that is above the lowest value
        let scan = Scan::new(&[PART, VOID], &[-0.5, -1.5]).unwrap();
        assert_eq!(
            scan.best_plateau(),
            Some(Plateau {
                from: -1.5,
                to: -0.5,
                iou: 1.0
            })
        );
    }

    #[test]
    fn the_curve_is_exact_where_it_is_given() {
        for (labels, response) in cases() {
            let scan = Scan::new(&labels, &response).unwrap();
            let curve = scan.curve(50);
            assert_eq!(curve.is_empty(), !labels.contains(&PART));
            for [t, iou] in curve {
                assert_eq!(Some(iou), scan.iou_at(t), "{t}");
            }
        }
    }

    #[test]
    fn spreads_are_those_of_the_definition() {
        for (labels, response) in cases() {
            let scan = Scan::new(&labels, &response).unwrap();
            for (label, spread) in [(PART, scan.part()), (VOID, scan.void())] {
                let values: Vec<f64> = labels
                    .iter()
                    .zip(&response)
                    .filter(|(l, _)| **l == label)
                    .map(|(_, v)| f64::from(*v))
                    .collect();
                let Some(spread) = spread else {
                    assert!(values.is_empty());
                    continue;
                };
                let n = values.len() as f64;
                let mean = values.iter().sum::<f64>() / n;
                let deviation = (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n).sqrt();
                assert_eq!(spread.count, values.len() as u64);
                assert!(
                    (spread.mean - mean).abs() < 1e-12
                        && (spread.deviation - deviation).abs() < 1e-9
                );
                assert_eq!(
                    f64::from(spread.min),
                    values.iter().copied().fold(f64::INFINITY, f64::min)
                );
            }
        }
    }

    #[test]
    fn many_blocks_give_the_same_numbers_for_any_number_of_threads() {
        let n = 5 * BLOCK + 777;
        let mut dice = Dice(5);
        let labels: Vec<u8> = (0..n)
            .map(|i| if i % 3 == 0 { PART } else { VOID })
            .collect();
        let response: Vec<f32> = labels
            .iter()
            .map(|l| 0.3 * f32::from(*l) + 0.5 * dice.next())
            .collect();
        let run = |threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| {
                let scan = Scan::new(&labels, &response).unwrap();
                (
                    scan.part(),
                    scan.void(),
                    scan.best_plateau(),
                    scan.length_near_best(),
                    scan.curve(99),
                    scan.histogram([0.0, 1.0], 10),
                )
            })
        };
        let one = run(1);
        assert_eq!(one, run(3));
        assert_eq!(
            one.5.iter().map(|c| c[0]).sum::<u64>(),
            n.div_ceil(3) as u64
        );
        // t = 0.65: 9/10 of the part above, 3/10... the part lies in [0.6, 1.1), the void in [0.3, 0.8)
        let mut values: Vec<(f32, u8)> = response
            .iter()
            .copied()
            .zip(labels.iter().copied())
            .collect();
        values.sort_by(|a, b| b.0.total_cmp(&a.0));
        let (mut a, mut b, mut best) = (0u64, 0u64, 0.0f64);
        let total = n.div_ceil(3) as f64;
        for group in values.chunk_by(|x, y| x.0 == y.0) {
            a += group.iter().filter(|v| v.1 == PART).count() as u64;
            b += group.iter().filter(|v| v.1 == VOID).count() as u64;
            best = best.max(a as f64 / (total + b as f64));
        }
        assert_eq!(one.2.unwrap().iou, best);
    }

    #[test]
    fn numbers_that_are_not_finite_count_only_inside() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            let error = Scan::new(&[PART, VOID], &[1.0, bad]).err();
            assert!(matches!(error, Some(Error::NonFinite { .. })));
            assert!(Scan::new(&[PART, OUTSIDE], &[1.0, bad]).is_ok());
        }
        assert!(matches!(Scan::new(&[PART], &[]), Err(Error::Shape { .. })));
    }
}
