//! The process window itself: the widest gap between part and void, up to a share of outliers.
//!
//! **What it models.** Other objectives ask for two thresholds and leave it to a sweep to find which; here both thresholds are unknowns
//! and the gap between them is what is maximized, so that one run takes the place of the map. The scale of the doses is fixed by the
//! part's upper end, which is 1.
//!
//! **Equation** s is the share of a voxel that is part (0 or 1 with `surface = "voxel"`), N = Σs and N' = Σ(1 − s), ν is `outliers`; νN and νN'
//! are at least one voxel
//!
//! ```text
//! A  = max over u  u − 1/(2νN)·Σ s·h(u − m)             mean of the lowest doses of the part, 2ν of it
//! B  = min over l  l + 1/(2νN')·Σ (1 − s)·h(m − l)      mean of the highest doses of the void, 2ν of it
//! R  = min over t  t + 1/(νN)·Σ s·h(m − t)  −  A'       mean of the highest doses of the part − mean A' of its lowest, ν of it each
//! L  = 1 − (A − B) + 1/(2νN)·Σ s·h(m − 1) + 20·h(R − ipdr + ρ)                             ρ for τ in A', R and the last h
//! h(e) = 0 for e ≤ 0,  e²/2τ for e < τ,  e − τ/2 beyond            τ is `softness`, ρ is ipdr/10, at most τ
//! ```
//!
//! The process window of trimmed regions is the dose below which lies νN of the part, minus that above which lies νN' of the void. These quantiles are
//! not convex. Means of tails are: with τ → 0 A and B are conditional values at risk. Their tails hold twice the share that is left out, because the
//! mean of a tail whose doses are evenly spread is the quantile in its middle. Means of tails of ν alone follow the farthest doses, and lead to
//! narrower windows. The third term lets at most the share 2ν of the part exceed 1. For doses of the identity response L is convex, so that a duality
//! gap bounds every A − B that any patterns reach.
//!
//! The last term is an exact penalty, which makes `ipdr` a bound: from R = ipdr on it costs 20 for each unit, more than the window that a
//! wider range brings, so that the optimum lies within (its cost begins ρ before the bound, where it takes the place of a multiplier up to
//! 20). Tail means hold what they are means of: the dose range without ν of the part at either end is at most R + ρ. What was reached is
//! [`FoundWindow::range`].
//!
//! `measure = "gamma"` counts the outliers of the void in voxels of the part (νN in place of νN'): an error of
//! ν in the IoU is then the same at either threshold, and the window is the range of thresholds whose IoU is about 1 − ν or more. Γ asks for 0.95 of the
//! best IoU, which is 1 − ν with ν = 1 − 0.95·IoU: 0.05 for a perfect print, 0.1 for one of IoU 0.95.
//!
//! **Source** tail means by an extra unknown: Rockafellar and Uryasev, Journal of Risk 2 (2000) 21, eqs. 4 and 5; a margin whose outliers
//! are a share ν: Schölkopf, Smola, Williamson and Bartlett, Neural Computation 12 (2000) 1207; process window and dose range, trimmed:
//! Pellizzon et al., arXiv 2602.12178, eqs. 10 and 11 and section 2.1; Γ: Nicolet et al. (2024), table 2; exact penalties: Nocedal and
//! Wright, Numerical Optimization (2006), theorem 17.3. The form of L is ours.
//!
//! **Derivative** u, l and t are at their optimum, so ∂L/∂m follows with all held: −1/(νN)·s·h'(u − m) and so on.
//!
//! **Parameters** see [`Params`]. **Limits** weights per voxel count, tolerances do not: there is no band to widen. A gray target has no
//! part. Regions of different exposure have no common window. **Cost** a pass over doses and shares for each trial of u and l, which
//! begin where the last ones ended: about two passes of 8 bytes per voxel, with twice the work where there is a bound of the range. Doses on a device are copied to the host.

use super::preset::{Shares, SurfaceHandling};
use super::{
    BoxedObjective, BuildObjective, MakeObjective, Objective, ObjectiveInput, VoxelWeights, read,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicI64, Ordering};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{BLOCK, Field};
use tomolith_core::kind::{Kind, check_ranges, schema_of};
use tomolith_core::parallel::{InParallel, elements};
use tomolith_core::response::Response;
use tomolith_core::units::exact;

/// With more than this at either end what is left of the part says little of it.
const MOST_OUTLIERS: f64 = 0.25;

/// What outliers are counted in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum WindowMeasure {
    /// A share of either region, as in trimmed process windows.
    #[default]
    Pw,
    /// A share of the part, also in the void, as in IoU and Γ.
    Gamma,
}

tomolith_core::keys! {
    /// The parameters of the process window.
    pub struct Params {
        /// What outliers are counted in: "pw", a share of either region, or "gamma", a share of the part in both
        pub measure: WindowMeasure = WindowMeasure::Pw,
        /// Share ν of voxels that may lie on the wrong side (default 0.05; 0.1 with `measure = "gamma"`); 0.02 is two voxels in a hundred
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = MOST_OUTLIERS))]
        pub outliers: Option<f64>,
        /// Bound of the dose range in the part without the outliers at either end (default: none)
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1.0))]
        pub ipdr: Option<f64>,
        /// Dose τ by which a voxel may be wrong before it costs in full
        #[schemars(range(min = 0.001, max = 1.0))]
        pub softness: f64 = 0.1,
        /// How voxels cut by the surface are weighed: "fraction", "voxel", or "cells" with a dose on either side
        pub surface: SurfaceHandling = SurfaceHandling::Fraction,
    }
}

impl Params {
    /// ν
    fn outliers(&self) -> f64 {
        self.outliers.unwrap_or(match self.measure {
            WindowMeasure::Pw => 0.05,
            WindowMeasure::Gamma => 0.1,
        })
    }
}

/// What it is called in a job.
pub const NAME: &str = "process_window";

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: NAME,
        summary: "the widest process window itself, up to a share of outliers, within a bound of the dose range in the part",
        example: "[objective.process_window]\noutliers = 0.05\nipdr = 0.3",
        schema: schema_of::<Params>,
        build: |section| read(section, |params: &Params| Ok(params.clone())),
    }
}

impl<F: Field> MakeObjective<F> for Params {
    fn make(&self, input: &ObjectiveInput) -> BoxedObjective<F> {
        check_ranges("", self)?;
        let shares = Shares::new(self.surface, input, input.labels)?;
        let (elements, response) = (input.layout.range(), Arc::clone(&input.response));
        let objective = ProcessWindow::new(elements, shares, self.clone(), response)?;
        Ok(Box::new(objective))
    }

    fn surface(&self) -> SurfaceHandling {
        self.surface
    }

    fn seeks_window(&self) -> bool {
        true
    }
}

/// Thresholds are looked for between neighbors of this distance, in units of the response.
const GRID: f64 = 1.0 / (1 << 20) as f64;
/// The response that the part's upper end has.
const CEILING: f64 = 1.0;
/// Price of a dose range above its bound, per unit of process window: more than any range is worth that was met.
const PRICE: f64 = 20.0;
/// Voxels in a tail, per voxel that is left out.
const TAIL: f64 = 2.0;
/// Softness of the dose range, of its bound.
const SOFTNESS_OF_RANGE: f64 = 0.1;
/// Halvings of a range of doses until its ends are one.
const HALVINGS: usize = 48;
/// Passes over the voxels after which a threshold is taken as it is.
const MOST_PASSES: usize = 100;
/// Elements that are written at a time.
const PORTION: usize = 16 * BLOCK;

/// h and its derivative.
fn hinge(excess: f64, softness: f64) -> (f64, f64) {
    if excess <= 0.0 {
        (0.0, 0.0)
    } else if excess < softness {
        (0.5 * excess * excess / softness, excess / softness)
    } else {
        (excess - 0.5 * softness, 1.0)
    }
}

/// The process window as an objective; see the [module](self).
struct ProcessWindow {
    elements: Range<usize>,
    shares: Shares,
    params: Params,
    response: Arc<dyn Response>,
    /// νN and νN'.
    left_out: [f64; 2],
    /// 2νN and 2νN', less where that is half of a region.
    tails: [f64; 2],
    /// Where the thresholds were last, on the grid: where the next search begins. What it finds does not depend on it.
    last: [AtomicI64; 4],
}

/// Tails: the low end of the part and the high end of the void; both ends of the part once more, for the bound of its range; what exceeds the
/// ceiling, whose threshold is given.
const TAILS: usize = 5;
const LOW: usize = 0;
const VOID: usize = 1;
const RANGE: [usize; 2] = [2, 3];
const ABOVE: usize = 4;

/// Sums over one tail at two neighboring thresholds.
#[derive(Clone, Copy, Debug, Default)]
struct Tail {
    /// Σ w·h at the lower one.
    excess: f64,
    /// Σ w·h'
    counts: [f64; 2],
    /// Σ w·h'·(change of the value)
    changes: [f64; 2],
}

impl Tail {
    /// Adds a voxel of weight w, whose value lies below the lower threshold by `below`.
    fn add(&mut self, w: f64, below: f64, change: f64, softness: f64) {
        let next = hinge(below + GRID, softness).1;
        if next > 0.0 {
            let (excess, slope) = hinge(below, softness);
            self.excess += w * excess;
            self.counts[0] += w * slope;
            self.counts[1] += w * next;
            self.changes[0] += w * slope * change;
            self.changes[1] += w * next * change;
        }
    }

    fn plus(mut self, other: &Tail) -> Self {
        self.excess += other.excess;
        for i in 0..2 {
            self.counts[i] += other.counts[i];
            self.changes[i] += other.changes[i];
        }
        self
    }
}

/// A search for the threshold below which a tail counts as much as it may.
struct Search {
    goal: f64,
    /// Its count is below the goal at `low` and not at `high`.
    low: i64,
    high: i64,
    at: i64,
    jump: i64,
}

impl Search {
    fn new(goal: f64, at: i64) -> Self {
        Search {
            goal,
            low: -(1 << 60),
            high: 1 << 60,
            at,
            jump: 1 << 16,
        }
    }

    /// Whether the threshold lies between `at` and its neighbor; if not, `at` is nearer to it.
    #[expect(clippy::cast_possible_truncation, reason = "clamped to the bracket")]
    fn is_there(&mut self, counts: [f64; 2], passes: usize) -> bool {
        let [count, next] = counts;
        let mut jump = self.jump;
        if count >= self.goal {
            self.high = self.at;
            jump = -jump;
        } else if next < self.goal {
            self.low = self.at + 1;
        } else {
            return true;
        }
        self.jump = (4 * self.jump).min(1 << 60);
        let newton = ((self.goal - count) / (next - count)).floor();
        let inside = |at: i64| at >= self.low && at < self.high;
        let middle = self.low + (self.high - self.low) / 2;
        let is_bracketed = self.low > -(1 << 60) && self.high < 1 << 60;
        self.at = if is_bracketed && passes > 12 {
            middle
        } else if newton.is_finite() && newton.abs() < 1e15 && inside(self.at + newton as i64) {
            self.at + newton as i64
        } else if is_bracketed || !inside(self.at + jump) {
            middle
        } else {
            self.at + jump
        };
        false
    }

    /// The threshold and its tail mean, with the mean's change.
    fn mean(&self, tail: &Tail) -> Mean {
        let Tail {
            excess,
            counts: [count, next],
            changes,
        } = *tail;
        let share = (self.goal - count) / (next - count);
        let share = if share.is_finite() { share } else { 0.0 };
        let beyond = share * GRID;
        let threshold = self.at as f64 * GRID + beyond;
        let excess = excess + beyond * (count + 0.5 * share * (next - count));
        Mean {
            threshold,
            value: threshold - excess / self.goal,
            change: (changes[0] + share * (changes[1] - changes[0])) / self.goal,
        }
    }
}

/// The mean of a tail.
#[derive(Clone, Copy)]
struct Mean {
    threshold: f64,
    value: f64,
    change: f64,
}

/// Loss of the process window: L, its change, and what the gradient is made of.
struct WindowLoss {
    loss: f64,
    change: f64,
    /// u and −l; those of the range, the upper one negative.
    thresholds: [f64; 4],
    /// 20·h': what the dose range costs.
    price_of_range: f64,
}

/// The exact process window of doses without the share `outliers`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FoundWindow {
    /// Share ν of the part that is left out at either end; of the void as much, or with "gamma" as many voxels.
    pub outliers: f64,
    /// The soft thresholds [l, u] that the objective found.
    pub thresholds: [f64; 2],
    /// All of the part but the outliers lies above.
    pub part_above: f64,
    /// All of the part but the outliers lies below.
    pub part_below: f64,
    /// All of the void but the outliers lies below.
    pub void_below: f64,
    /// `part_above` − `void_below`.
    pub window: f64,
    /// `part_below` − `part_above`.
    pub range: f64,
    /// The bound of the range, `ipdr`.
    pub ipdr: Option<f64>,
}

impl FoundWindow {
    /// In words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let bound = self.ipdr;
        let bound = bound.map_or_else(String::new, |ipdr| format!(" (bound {})", exact(ipdr)));
        format!(
            "without {} % of outliers the part lies above {:.4} and the void below {:.4}: process window {:.4}, dose range {:.4}{bound}; the thresholds found are {:.4} and {:.4}",
            exact(100.0 * self.outliers),
            self.part_above,
            self.void_below,
            self.window,
            self.range,
            self.thresholds[0],
            self.thresholds[1],
        )
    }

    /// What to say where the dose range is above its bound.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let ipdr = self.ipdr.filter(|ipdr| self.range > *ipdr)?;
        Some(format!(
            "the dose range in the part is {:.4}, above its bound ipdr = {}: no patterns that were found reach it. Allow more iterations \
             (stop.iterations), or a larger ipdr",
            self.range,
            exact(ipdr)
        ))
    }
}

impl ProcessWindow {
    fn new(
        elements: Range<usize>,
        shares: Shares,
        params: Params,
        response: Arc<dyn Response>,
    ) -> Result<Self> {
        let mut objective = ProcessWindow {
            elements,
            shares,
            params,
            response,
            left_out: [0.0; 2],
            tails: [0.0; 2],
            last: [0.8, -0.6, 0.8, -0.9].map(|start: f64| AtomicI64::new((start / GRID) as i64)),
        };
        objective.count()?;
        Ok(objective)
    }

    /// How much of either region counts.
    fn count(&mut self) -> Result<()> {
        let [part, void] = self.shares.totals();
        for (what, total) in [("part", part), ("void", void)] {
            if total <= 0.0 {
                return Err(Error::unsupported(
                    "a process window",
                    format!(
                        "no voxel of the {what} counts; regions, weights and targets that leave some of part and void"
                    ),
                ));
            }
        }
        let outliers = self.params.outliers();
        // Less than a voxel has no tail
        let at_least_one = |voxels: f64, whole: f64| voxels.max(1.0).min(0.5 * whole);
        let of_part = at_least_one(outliers * part, part);
        let of_void = match self.params.measure {
            WindowMeasure::Pw => at_least_one(outliers * void, void),
            WindowMeasure::Gamma => at_least_one(outliers * part, void),
        };
        self.left_out = [of_part, of_void];
        self.tails =
            [(of_part, part), (of_void, void)].map(|(out, whole)| (TAIL * out).min(0.5 * whole));
        Ok(())
    }

    /// ρ where the range is bounded.
    fn softness_of_range(&self) -> Option<f64> {
        let softness_of = |ipdr: f64| (SOFTNESS_OF_RANGE * ipdr).clamp(0.001, self.params.softness);
        self.params.ipdr.map(softness_of)
    }

    /// Thresholds that are looked for.
    fn searched(&self) -> usize {
        if self.params.ipdr.is_some() { 4 } else { 2 }
    }

    /// Sums over the tails at their thresholds, and over what exceeds the ceiling; `at` gives response and change of an element.
    fn pass(
        &self,
        at: &(impl Fn(usize) -> [f64; 2] + Sync),
        thresholds: [i64; 4],
    ) -> [Tail; TAILS] {
        let [part, void, low, high] = thresholds.map(|k| k as f64 * GRID);
        let (softness, of_range) = (self.params.softness, self.softness_of_range());
        let blocks = (0..self.elements.len()).step_by(BLOCK);
        let sums = blocks.par_map(|begin| {
            let mut tails = [Tail::default(); TAILS];
            for i in begin..(begin + BLOCK).min(self.elements.len()) {
                let Some([w_part, w_void]) = self.shares.weights(i) else {
                    continue;
                };
                let [m, change] = at(i);
                if w_part > 0.0 {
                    tails[LOW].add(w_part, part - m, change, softness);
                    tails[ABOVE].add(w_part, m - CEILING, change, softness);
                    if let Some(softness) = of_range {
                        tails[RANGE[0]].add(w_part, low - m, change, softness);
                        tails[RANGE[1]].add(w_part, high + m, -change, softness);
                    }
                }
                if w_void > 0.0 {
                    tails[VOID].add(w_void, void + m, -change, softness);
                }
            }
            tails
        });
        let none = [Tail::default(); TAILS];
        sums.iter().fold(none, |all, more| {
            std::array::from_fn(|i| all[i].plus(&more[i]))
        })
    }

    /// L and its change where `at` says what the elements have.
    fn find(&self, at: impl Fn(usize) -> [f64; 2] + Sync) -> WindowLoss {
        let ([of_part, of_void], [left_out, _]) = (self.tails, self.left_out);
        let goals = [of_part, of_void, left_out, left_out];
        let mut searches: [Search; 4] =
            std::array::from_fn(|i| Search::new(goals[i], self.last[i].load(Ordering::Relaxed)));
        let count = self.searched();
        let mut tails = [Tail::default(); TAILS];
        for passes in 0..MOST_PASSES {
            tails = self.pass(&at, searches.each_ref().map(|search| search.at));
            let mut are_there = true;
            for (search, tail) in searches.iter_mut().zip(&tails).take(count) {
                are_there &= search.is_there(tail.counts, passes);
            }
            if are_there {
                break;
            }
        }
        for (last, search) in self.last.iter().zip(&searches) {
            last.store(search.at, Ordering::Relaxed);
        }
        let means: [Mean; 4] = std::array::from_fn(|i| searches[i].mean(&tails[i]));
        let [part, void, low, high] = means;
        let (above, price) = (&tails[ABOVE], 1.0 / of_part);
        let (mut range, mut price_of_range) = (0.0, 0.0);
        if let Some((ipdr, softness)) = self.params.ipdr.zip(self.softness_of_range()) {
            // The mean of the lowest −m is less that of the highest m
            let beyond = -high.value - low.value - ipdr + softness;
            let (cost, slope) = hinge(beyond, softness);
            (range, price_of_range) = (PRICE * cost, PRICE * slope);
        }
        WindowLoss {
            loss: CEILING - part.value - void.value + price * above.excess + range,
            change: price * above.changes[0]
                - part.change
                - void.change
                - if price_of_range > 0.0 {
                    price_of_range * (low.change + high.change)
                } else {
                    0.0
                },
            thresholds: means.map(|mean| mean.threshold),
            price_of_range,
        }
    }

    /// Response of a dose, and its slope.
    fn response(&self, dose: f32) -> [f64; 2] {
        if self.response.is_identity() {
            return [f64::from(dose), 1.0];
        }
        let (value, slope) = self.response.value_and_slope(dose);
        [f64::from(value), f64::from(slope)]
    }

    fn at(&self, dose: &[f32]) -> WindowLoss {
        let dose = &dose[self.elements.clone()];
        self.find(|i| [self.response(dose[i])[0], 0.0])
    }

    /// ∂L/∂dose of an element.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn gradient(&self, found: &WindowLoss, i: usize, dose: f32) -> f32 {
        let Some([w_part, w_void]) = self.shares.weights(i) else {
            return 0.0;
        };
        let ([m, slope], [part, void, low, high]) = (self.response(dose), found.thresholds);
        let count = |excess: f64| hinge(excess, self.params.softness).1;
        let ([tail, tail_of_void], [left_out, _]) = (self.tails, self.left_out);
        let mut of_part = (count(m - CEILING) - count(part - m)) / tail;
        if let Some(softness) = self
            .softness_of_range()
            .filter(|_| found.price_of_range > 0.0)
        {
            let count = |excess: f64| hinge(excess, softness).1;
            of_part += found.price_of_range * (count(high + m) - count(low - m)) / left_out;
        }
        let of_void = count(void + m) / tail_of_void;
        (slope * (w_part * of_part + w_void * of_void)) as f32
    }

    /// The largest v below which lies at most the weight that is left out, of the part (0) or the void (1), where each element has `at`.
    fn end(&self, region: usize, at: impl Fn(usize) -> f64 + Sync) -> f64 {
        let weight = |i: usize| self.shares.weights(i).map_or(0.0, |w| w[region]);
        let blocks = (0..self.elements.len()).step_by(BLOCK);
        let block_of = |begin: usize| begin..(begin + BLOCK).min(self.elements.len());
        let ends = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let of_blocks = blocks.clone().par_map(|begin| {
            let counted = block_of(begin).filter(|i| weight(*i) > 0.0);
            counted.map(|i| [at(i); 2]).fold(none, ends)
        });
        let [mut low, mut high] = of_blocks.into_iter().fold(none, ends);
        // Blocks are added in one order
        let below = |middle: f64| -> f64 {
            let sums = blocks.clone().par_map(|begin| {
                let below = block_of(begin).filter(|i| at(*i) < middle);
                below.map(weight).sum::<f64>()
            });
            sums.iter().sum()
        };
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if below(middle) <= self.left_out[region] {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }
}

/// The elements of a field in host memory.
fn host<F: Field>(field: &F) -> Cow<'_, [f32]> {
    match field.host_bytes() {
        Cow::Borrowed(bytes) => Cow::Borrowed(bytemuck::cast_slice(bytes)),
        Cow::Owned(bytes) => Cow::Owned(bytemuck::pod_collect_to_vec(&bytes)),
    }
}

impl<F: Field> Objective<F> for ProcessWindow {
    fn value(&self, dose: &F) -> f64 {
        self.at(&host(dose)).loss
    }

    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64 {
        let dose = host(dose);
        let found = self.at(&dose);
        grad.fill(0.0);
        let mut portion = vec![0.0f32; PORTION.min(self.elements.len())];
        for begin in (0..self.elements.len()).step_by(PORTION) {
            let len = PORTION.min(self.elements.len() - begin);
            let place = self.elements.start + begin;
            elements(&mut portion[..len], |i, g| {
                *g = self.gradient(&found, begin + i, dose[place + i]);
            });
            grad.write(place, &portion[..len]);
        }
        found.loss
    }

    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64) {
        let (dose, step) = (host(dose), host(step));
        let [dose, step] = [&dose, &step].map(|field| &field[self.elements.clone()]);
        let found = self.find(|i| {
            let [m, slope] = self.response(dose[i] + alpha * step[i]);
            [m, slope * f64::from(step[i])]
        });
        (found.loss, found.change)
    }

    fn is_convex(&self) -> bool {
        self.response.is_identity()
    }

    fn is_mean(&self) -> bool {
        true
    }

    fn window(&self, dose: &F) -> Option<FoundWindow> {
        let dose = host(dose);
        let found = self.at(&dose);
        let dose = &dose[self.elements.clone()];
        let response = |i: usize| self.response(dose[i])[0];
        let part_above = self.end(LOW, response);
        let part_below = -self.end(LOW, |i| -response(i));
        let void_below = -self.end(VOID, |i| -response(i));
        Some(FoundWindow {
            outliers: self.params.outliers(),
            thresholds: [-found.thresholds[VOID], found.thresholds[LOW]],
            part_above,
            part_below,
            void_below,
            window: part_above - void_below,
            range: part_below - part_above,
            ipdr: self.params.ipdr,
        })
    }

    fn set_response(&mut self, response: &Arc<dyn Response>) -> Result<()> {
        self.response = Arc::clone(response);
        Ok(())
    }

    fn set_voxel_weights(&mut self, voxel_weights: &VoxelWeights) -> Result<()> {
        if !voxel_weights.tolerance.is_empty() {
            let found = "a tolerance of process_window, which has no bands to widen";
            let accepted = "no tolerance; region and weights count";
            return Err(Error::config("tolerance", found, accepted));
        }
        self.shares.scale(&voxel_weights.weight);
        self.count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;
    use tomolith_core::check::{noise, refuses};
    use tomolith_core::field::HostField;
    use tomolith_core::near;
    use tomolith_core::response::Identity;

    fn window(inside: &[f32], params: Params) -> ProcessWindow {
        let shares = Shares::of(inside.to_vec());
        ProcessWindow::new(0..inside.len(), shares, params, Arc::new(Identity)).unwrap()
    }

    /// The mean of the `count` lowest values; the last of them counts for what is left.
    fn lowest(mut values: Vec<f64>, count: f64) -> f64 {
        values.sort_by(f64::total_cmp);
        let mut left = count;
        let mut sum = 0.0;
        for value in values {
            let taken = left.min(1.0);
            sum += taken * value;
            left -= taken;
        }
        sum / count
    }

    #[test]
    fn the_loss_is_that_of_sorted_tails() {
        let inside: Vec<f32> = (0..400).map(|i| f32::from(i % 4 == 0)).collect();
        let dose: Vec<f32> = noise(3, 400).iter().map(|v| 0.5 + 0.4 * v).collect();
        for (measure, of_void) in [
            (WindowMeasure::Pw, 0.033 * 300.0),
            (WindowMeasure::Gamma, 3.3),
        ] {
            let params = Params {
                measure,
                outliers: Some(0.033),
                softness: 0.001,
                ..Params::default()
            };
            let region = |s: f32, sign: f64| -> Vec<f64> {
                let doses = dose.iter().zip(&inside).filter(|(_, inside)| **inside == s);
                doses.map(|(d, _)| sign * f64::from(*d)).collect()
            };
            let a = lowest(region(1.0, 1.0), 2.0 * 3.3);
            let b = -lowest(region(0.0, -1.0), 2.0 * of_void);
            let field = HostField::from_slice(&dose);
            let loss = Objective::<HostField>::value(&window(&inside, params), &field);
            // The softness rounds a tail's corner by half of itself
            near!(loss, (1.0 - a + b), 1e-3, "{measure:?}: {loss}, {a} {b}");
        }
    }

    #[test]
    fn a_dose_range_and_a_ceiling_cost_what_the_equation_says() {
        // Half of the part at 0.7, half at 1: a range of 0.3
        let inside: Vec<f32> = (0..100).map(|i| f32::from(i < 50)).collect();
        let loss_of = |low: f32, high: f32, ipdr: Option<f64>| {
            let params = Params {
                ipdr,
                softness: 0.001,
                ..Params::default()
            };
            let part = |i: usize| if i.is_multiple_of(2) { low } else { high };
            let dose = inside.iter().enumerate().map(|(i, s)| s * part(i));
            let dose: Vec<f32> = dose.collect();
            Objective::<HostField>::value(&window(&inside, params), &HostField::from_slice(&dose))
        };
        let costs = |ipdr| loss_of(0.7, 1.0, Some(ipdr)) - loss_of(0.7, 1.0, None);
        assert!((costs(0.2) - PRICE * 0.1).abs() < 0.03, "{}", costs(0.2));
        assert_eq!(costs(0.31), 0.0);
        // Twice the dose is twice the range, wherever it lies
        let doubled = loss_of(1.4, 2.0, Some(0.2)) - loss_of(1.4, 2.0, None);
        assert!((doubled - PRICE * 0.4).abs() < 0.03, "{doubled}");
        // 0.1 above the ceiling costs 0.1/2ν and widens the window by 0.1; the hinge's corner takes half its softness, 0.01 in all
        let above = loss_of(1.1, 1.1, None) - loss_of(1.0, 1.0, None);
        let wanted = (0.1 - 0.0005) / (2.0 * Params::default().outliers()) - 0.1;
        assert!((above - wanted).abs() < 1e-6, "{above}");
    }

    #[test]
    fn gradients_are_derivatives_with_every_key_and_any_beginning() {
        let inside: Vec<f32> = noise(1, 3000)
            .iter()
            .map(|v| (0.5 + 0.9 * v).clamp(0.0, 1.0))
            .collect();
        let dose: Vec<f32> = noise(2, 3000)
            .iter()
            .zip(&inside)
            .map(|(v, s)| 0.3 + 0.5 * s + 0.35 * v)
            .collect();
        let dose = HostField::from_slice(&dose);
        for measure in [WindowMeasure::Pw, WindowMeasure::Gamma] {
            for ipdr in [None, Some(0.3)] {
                let params = Params {
                    measure,
                    ipdr,
                    outliers: Some(0.05),
                    softness: 0.2,
                    ..Params::default()
                };
                let used = window(&inside, params.clone());
                check::objective(&used, &dose).unwrap();
                // A search that begins elsewhere ends at the same bits
                let fresh = window(&inside, params);
                for (last, start) in fresh.last.iter().zip([5 << 20, -(7 << 22), -9, 1 << 21]) {
                    last.store(start, Ordering::Relaxed);
                }
                let losses = [&used, &fresh].map(|o| Objective::<HostField>::value(o, &dose));
                assert_eq!(losses[0].to_bits(), losses[1].to_bits());
            }
        }
    }

    #[test]
    fn the_window_is_told_without_outliers_of_which_there_is_one_at_least() {
        // Ten voxels of the part at 0.5, 0.55, …, 0.95, ten of the void at 0, 0.05, …, 0.45
        let inside: Vec<f32> = (0..20).map(|i| f32::from(i >= 10)).collect();
        let dose: Vec<f32> = (0..20).map(|i| 0.05 * i as f32).collect();
        let window_of = |outliers, ipdr| {
            let params = Params {
                outliers: Some(outliers),
                ipdr,
                softness: 0.001,
                ..Params::default()
            };
            let objective = window(&inside, params);
            Objective::<HostField>::window(&objective, &HostField::from_slice(&dose)).unwrap()
        };
        // One voxel is left out at every end, of 0.01 as of 0.1; of 0.25 two, and half of a third that counts
        for (outliers, low, high, void) in [
            (0.01, 0.55, 0.9, 0.4),
            (0.1, 0.55, 0.9, 0.4),
            (0.25, 0.6, 0.85, 0.35),
        ] {
            let found = window_of(outliers, Some(0.3));
            for (found, expected) in [
                (found.part_above, low),
                (found.part_below, high),
                (found.void_below, void),
                (found.window, low - void),
                (found.range, high - low),
            ] {
                near!(found, expected, 1e-6, "{outliers}");
            }
        }
        let found = window_of(0.1, Some(0.3));
        // Two voxels are in its tail
        assert!((found.thresholds[1] - 0.55).abs() < 2e-3, "{found:?}");
        let text = found.sentence();
        tomolith_core::contains!(text, "10 % of outliers", "0.3500 (bound 0.3)");
        assert!(
            found
                .warning()
                .is_some_and(|text| text.contains("ipdr = 0.3"))
        );
        assert_eq!(window_of(0.1, Some(0.4)).warning(), None);
    }

    #[test]
    fn what_cannot_be_a_window_is_refused() {
        for (params, key) in [
            (
                Params {
                    outliers: Some(0.0),
                    ..Params::default()
                },
                "outliers",
            ),
            (
                Params {
                    ipdr: Some(-0.1),
                    ..Params::default()
                },
                "ipdr",
            ),
            (
                Params {
                    softness: f64::NAN,
                    ..Params::default()
                },
                "softness",
            ),
        ] {
            refuses(check_ranges("", &params), key);
        }
        let shares = Shares::of(vec![1.0; 8]);
        let only = ProcessWindow::new(0..8, shares, Params::default(), Arc::new(Identity));
        assert!(matches!(only.map(drop), Err(Error::Unsupported { .. })));
    }
}
