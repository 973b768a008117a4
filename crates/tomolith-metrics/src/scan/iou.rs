//! IoU over the threshold axis: its best value, the plateau round it, and where it is near.

use super::{Opened, Scan};
use crate::buckets::Counts;

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

/// Share of an IoU above which another is near it.
const NEAR: f64 = 0.95;

/// Length of what of a run of thresholds lies in [0, 1].
fn within_unit((from, to): &(f64, f64)) -> f64 {
    to.clamp(0.0, 1.0) - from.clamp(0.0, 1.0)
}

/// An IoU as a fraction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fraction {
    above: u64,
    below: u64,
}

impl Fraction {
    /// self − factor·other: its sign, with `factor` = num/den.
    fn compare(&self, other: &Fraction, num: u128, den: u128) -> std::cmp::Ordering {
        let left = den * u128::from(self.above) * u128::from(other.below);
        left.cmp(&(num * u128::from(other.above) * u128::from(self.below)))
    }

    /// Whether self > [`NEAR`]·other, exactly.
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

impl Scan<'_> {
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

    /// Buckets that may hold the best IoU, and those in which IoU may come near it or leave it, by either rule.
    pub(super) fn candidates(&self) -> Vec<usize> {
        let pieces = self.pieces(&Opened::new());
        // Attained for sure: below all values, and between any two buckets
        let exact = pieces.iter().filter(|p| p.closed.is_none()).map(|p| p.low);
        let between = self.buckets.iter().map(|b| self.iou(b.above));
        let at_least = best_of(&mut exact.chain(between));
        let at_most = best_of(&mut pieces.iter().map(|p| p.high));
        let Some((at_least, at_most)) = at_least.zip(at_most) else {
            return Vec::new();
        };
        let is_open = |p: &&Piece| {
            let may_be_best = p.high.compare(&at_least, 1, 1).is_ge();
            let may_be_edge = [Fraction::is_near, Fraction::is_hardly_below]
                .iter()
                .any(|rule| rule(&p.high, &at_least) && !rule(&p.low, &at_most));
            may_be_best || may_be_edge
        };
        let open = pieces.iter().filter(is_open);
        open.filter_map(|p| p.closed).collect()
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

    /// Length of {t in [0, 1]: IoU(t) > 0.95·best}; `None` when there is no part, or all such t lie above 1.
    #[must_use]
    pub fn length_near_best(&self) -> Option<f64> {
        let best = &self.settled()?;
        let runs = self.runs(best, Fraction::is_near);
        self.on_scale(&runs)
    }

    /// Length of {t in [0, 1]: IoU(t) > 0.95·`iou`}, of the best IoU of another print, to within the buckets of the scan at its ends; `None` when there is no part, or all such t lie above 1.
    #[must_use]
    pub fn length_near(&self, iou: f64) -> Option<f64> {
        let best = &self.settled()?;
        let runs = self.runs(best, |piece, _| piece.value() > NEAR * iou);
        self.on_scale(&runs)
    }

    /// The length of runs of thresholds on the dose scale 0…1; None where all of them and the best one lie above it.
    fn on_scale(&self, runs: &[(f64, f64)]) -> Option<f64> {
        let is_above = self.best_plateau().is_some_and(|best| best.from >= 1.0);
        let length: f64 = runs.iter().map(within_unit).sum();
        (length > 0.0 || !is_above).then_some(length)
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
}

fn best_of(ious: &mut dyn Iterator<Item = Fraction>) -> Option<Fraction> {
    ious.max_by(|a, b| a.compare(b, 1, 1))
}
