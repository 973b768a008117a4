//! Numbers in the memory where the work happens.
//!
//! Optimizers, objectives and models talk about [`Field`]s only: flat vectors of f32 with f64 sums. [`HostField`] is the
//! one in this machine's memory; a device has its own. The meaning of an element (which pixel, which voxel) is in the
//! model's layouts.
//!
//! Every operation has a name, and none takes code of the host. What an operation needs besides fields and numbers is plain data
//! that a backend compiles once, for where its fields live: [`Bounds`], [`BandLoss`] (bands, weights, response), [`PatternCost`].
//!
//! **What a backend implements**
//!
//! | type | what it is | made from |
//! |---|---|---|
//! | [`Field`] | the vector: copies, sums, steps, the formulas of methods | host values |
//! | [`Field::Bounds`] | bounds of the elements | [`Field::compile_bounds`] of [`Bounds`] |
//! | [`Field::Pairs`] | memory of a quasi-Newton method ([`Pairs`]) | compiled bounds |
//! | [`Field::Bands`] | the band loss and its derivatives ([`BandKernel`]) | [`BandLoss`] |
//! | [`Field::Costs`] | penalties on patterns ([`CostKernel`]) | [`PatternCost`] |
//! | [`Field::HalfRamp`] | a filter along rows of pixels ([`HalfRampKernel`]) | [`HalfRamp`] |
//! | [`Counter`] | ranges and histograms over labels | [`Field::counter`] |
//! | [`DoseModel`](crate::dose::DoseModel) | a model whose fields these are | |
//!
//! A pattern field may be one rank's share of the frames ([`HostField::shared`]): what these operations sum or compare is then that of all
//! ranks.
//!
//! That is all: problems, searches, optimizers, objectives, penalties and starts are generic over the field. A sum may differ from the
//! host's by rounding, but must be the same in every run. `tomolith-gpu` is a whole backend.
//!
//! Sums of the host run over fixed blocks ([`BLOCK`] elements, or the [pieces](Bounds::pieces) of bounds) whose partial results are
//! added in order, so a number does not depend on how many threads computed it. Within a block a product is an f64 and goes to
//! running sum i mod 8; these are added in order, then the sum of what is left beyond a multiple of eight.
//!
//! ```
//! use tomolith_core::field::{Field, HostField};
//! let mut x = HostField::zeros(3);
//! x.fill(2.0);
//! let mut y = x.clone();
//! y.axpy(0.5, &x); // 2 + 0.5·2 = 3
//! assert_eq!(x.dot(&y), 3.0 * 2.0 * 3.0); // three elements, 2·3 each
//! ```

pub mod bands;
pub mod costs;
pub mod counter;
pub(crate) mod group;
pub mod half_ramp;
mod pairs;
pub mod scratch;

use crate::dose::{Facts, Space};
use crate::error::Result;
use crate::parallel::InParallel;
use crate::ranks::Communicator;
pub use bands::{Band, BandKernel, BandLoss, Bands, HostBands};
pub use costs::{CostKernel, HostCosts, PatternCost};
pub use counter::Counter;
pub use half_ramp::{ColumnRun, HalfRamp, HalfRampKernel, HostHalfRamp};
pub use pairs::{Direction, DirectionSums, HostPairs, Latest, Pairs, PairsPart, Products};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// Elements per block of a parallel loop: 256 kB of f32, a compromise between cache and scheduling.
pub const BLOCK: usize = 1 << 16;

/// Bounds of the elements of a field: constant over pieces, of which a pattern field has one per light.
///
/// ```
/// use tomolith_core::field::Bounds;
/// let bounds = Bounds::uniform(100_000, 0.0, 1.0);
/// assert_eq!(bounds.len(), 100_000);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    blocks: Vec<BoundedBlock>,
}

/// Neighboring elements with the same bounds, at most [`BLOCK`] of them.
#[derive(Clone, Debug, PartialEq)]
struct BoundedBlock {
    len: usize,
    lower: f32,
    upper: f32,
}

impl Bounds {
    /// One pair of bounds for `len` elements.
    #[must_use]
    pub fn uniform(len: usize, lower: f32, upper: f32) -> Self {
        Bounds::of_pieces([(len, lower, upper)])
    }

    /// Pieces `(length, lower, upper)` one after the other.
    #[must_use]
    pub fn of_pieces(pieces: impl IntoIterator<Item = (usize, f32, f32)>) -> Self {
        let mut blocks = Vec::new();
        for (len, lower, upper) in pieces {
            for begin in (0..len).step_by(BLOCK) {
                let len = BLOCK.min(len - begin);
                blocks.push(BoundedBlock { len, lower, upper });
            }
        }
        Bounds { blocks }
    }

    /// Pieces (length, lower, upper), one after the other, none longer than [`BLOCK`]: those that sums of the host go by.
    pub fn pieces(&self) -> impl Iterator<Item = (usize, f32, f32)> + '_ {
        self.blocks.iter().map(|b| (b.len, b.lower, b.upper))
    }

    /// Number of elements.
    #[must_use]
    pub fn len(&self) -> usize {
        self.blocks.iter().map(|b| b.len).sum()
    }

    /// Whether there is no element.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    fn must_fit(&self, values: &[f32]) {
        let of_another_length = "a field of another length than its bounds";
        assert_eq!(values.len(), self.len(), "{of_another_length}");
    }

    /// The elements of some fields, block by block.
    fn split<'a, const N: usize>(
        &'a self,
        fields: [&'a HostField; N],
    ) -> impl Iterator<Item = (&'a BoundedBlock, [&'a [f32]; N])> {
        let mut fields = fields.map(HostField::as_slice);
        fields.iter().for_each(|values| self.must_fit(values));
        self.blocks.iter().map(move |b| {
            let of_block = |values: &mut &'a [f32]| values.split_off(..b.len);
            let parts = fields.each_mut().map(of_block);
            (b, parts.map(Option::unwrap_or_default))
        })
    }

    /// The elements of a field to change, and of others, block by block.
    fn split_mut<'a, const N: usize>(
        &'a self,
        field: &'a mut HostField,
        others: [&'a HostField; N],
    ) -> impl Iterator<Item = (&'a mut [f32], &'a BoundedBlock, [&'a [f32]; N])> {
        let mut values = field.as_mut_slice();
        self.must_fit(values);
        self.split(others).map(move |(b, others)| {
            let values = values.split_off_mut(..b.len).unwrap_or_default();
            (values, b, others)
        })
    }
}

/// Sums over a step p and a gradient g, taken in the pass that made the step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepSums {
    /// g·p, negative for a descent.
    pub slope: f64,
    /// p·p
    pub square: f64,
}

/// Sums over the secant of a step: y is the change of the gradient where the step p is not 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Secant {
    /// p·p
    pub pp: f64,
    /// p·y
    pub py: f64,
    /// y·y
    pub yy: f64,
}

/// Neighboring elements of one field, and as many of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stretch {
    /// The first of those that are written.
    pub to: usize,
    /// The first of those that are read.
    pub from: usize,
    /// How many.
    pub count: usize,
}

/// A flat vector of f32 somewhere. All operations on two fields need equal lengths and panic otherwise
/// (a programming error, not a user's).
pub trait Field: Clone + Send + Sync + 'static {
    /// Bounds of the elements of such fields.
    type Bounds: Send + Sync;
    /// The memory of a quasi-Newton method over such fields.
    type Pairs: Pairs<Self>;
    /// The band loss of doses in such fields.
    type Bands: BandKernel<Self>;
    /// Penalties on patterns in such fields.
    type Costs: CostKernel<Self>;
    /// A filter along the rows of pixels of such fields.
    type HalfRamp: HalfRampKernel<Self>;

    /// Number of elements.
    fn len(&self) -> usize;
    /// Whether there are no elements.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Zeros of the same length, in the same memory.
    fn zeros_like(&self) -> Self;
    /// Zeros as a model of these facts has them, in the same memory.
    fn zeros_of(&self, facts: &Facts<'_>, space: Space) -> Self;
    /// Overwrites with `other`.
    fn copy_from(&mut self, other: &Self);
    /// Overwrites with one value.
    fn fill(&mut self, value: f32);
    /// Overwrites some elements with 0.
    fn clear(&mut self, range: Range<usize>);
    /// Copies to host memory.
    fn to_host(&self) -> Vec<f32>;
    /// What counts the voxels of such doses where they live, by labels of its first elements; None where they are as well read in place.
    fn counter(&self, _labels: &[u8]) -> Option<Box<dyn Counter<Self>>> {
        None
    }
    /// Whether what was read of it is true: the memory that it lives in may be lost.
    ///
    /// # Errors
    /// [`Error::Device`](crate::Error::Device)
    fn check(&self) -> Result<()> {
        Ok(())
    }
    /// The bytes of the elements (f32), copied only where they live elsewhere.
    fn host_bytes(&self) -> Cow<'_, [u8]> {
        Cow::Owned(bytemuck::cast_slice(&self.to_host()).to_vec())
    }
    /// Overwrites elements from `begin` on with values from host memory.
    fn write(&mut self, begin: usize, values: &[f32]);
    /// Overwrites all elements from host memory.
    fn copy_from_host(&mut self, values: &[f32]) {
        assert_eq!(self.len(), values.len(), "a field of another length");
        self.write(0, values);
    }

    /// Σ selfᵢ·otherᵢ, summed in f64.
    fn dot(&self, other: &Self) -> f64;
    /// √Σ selfᵢ², summed in f64.
    fn norm(&self) -> f64 {
        self.dot(self).sqrt()
    }
    /// Largest |selfᵢ|; NaN if any element is NaN.
    fn max_abs(&self) -> f32;
    /// Largest selfᵢ where `marks` is not below 0, 0 at least; NaN if any of these elements is NaN.
    fn max_marked(&self, marks: &Self) -> f32;
    /// Smallest selfᵢ, 0 at most.
    fn lowest(&self) -> f32;

    /// self ← self + a·x
    fn axpy(&mut self, a: f32, x: &Self);
    /// self ← self + a·x in stretches that share no element of self (`adds`), or self ← a·x there; the rest of self stays as it is.
    fn set_stretches(&mut self, adds: bool, a: f32, x: &Self, stretches: &[Stretch]);
    /// self ← a·self
    fn scale(&mut self, a: f32);
    /// self ← self + a
    fn shift(&mut self, a: f32);
    /// self ← min(max(self, lower), upper)
    fn clamp(&mut self, lower: f32, upper: f32);
    /// selfᵢ ← selfᵢ·otherᵢ
    fn multiply(&mut self, other: &Self);
    /// selfᵢ ← 0 where `marks` is not above 0.
    fn keep_positive(&mut self, marks: &Self);
    /// self ← keep·self + (1 − keep)·x, a running mean.
    fn mix(&mut self, keep: f32, x: &Self);
    /// selfᵢ ← keep·selfᵢ + (1 − keep)·xᵢ², a running mean of squares.
    fn mix_squares(&mut self, keep: f32, x: &Self);
    /// selfᵢ ← selfᵢ/(√(factor·squaresᵢ) + epsilon)
    fn divide_by_roots(&mut self, squares: &Self, factor: f32, epsilon: f32);
    /// selfᵢ ← 1/(1 + e^((midpoint − selfᵢ)/width)) − targetᵢ, and 0 where the target is below 0.
    fn logistic_error(&mut self, target: &Self, midpoint: f32, width: f32);

    /// Brings bounds to where `self` lives; they are for fields of their own length.
    fn compile_bounds(&self, bounds: &Bounds) -> Self::Bounds;
    /// self ← P(self + a·step), P the projection onto the bounds.
    fn move_along(&mut self, step: &Self, a: f32, bounds: &Self::Bounds);
    /// self ← P(x − t·gradient) − x, the projected gradient step of length t.
    fn project_step(
        &mut self,
        x: &Self,
        gradient: &Self,
        t: f32,
        bounds: &Self::Bounds,
    ) -> StepSums;
    /// Brings every element to the nearest of so many levels (at least 2), even between its bounds; where there is no upper
    /// bound, the largest element takes its place.
    fn quantize(&mut self, levels: u32, bounds: &Self::Bounds);
    /// selfᵢ ← gradientᵢ where the bounds do not hold xᵢ, else 0: they do where it is at one and a descent would cross it.
    fn free_gradient(&mut self, x: &Self, gradient: &Self, bounds: &Self::Bounds);
    /// selfᵢ ← afterᵢ − beforeᵢ where the step is not 0, else 0.
    fn change_where_moved(&mut self, step: &Self, before: &Self, after: &Self);
    /// Secant sums of the step `self` between two gradients, one element after the other in a block.
    fn secant(&self, before: &Self, after: &Self) -> Secant;

    /// The sum over ranks of a number that each has, where this field is one rank's share ([`ranks`](crate::ranks)); else the number.
    fn total(&self, local: f64) -> f64 {
        local
    }
    /// Whether any rank says yes, where this field is one rank's share; else whether this process does.
    fn any(&self, yes: bool) -> bool {
        self.total(f64::from(u8::from(yes))) > 0.0
    }
}

/// Sixteen floats on a 64-byte boundary: one cache line, one AVX-512 register.
#[derive(Clone, Copy, Debug, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(64))]
pub struct Lanes(pub [f32; 16]);

/// Lanes of f32 in one [`Lanes`].
pub const LANES: usize = 16;

/// A [`Field`] in host memory, starting on a 64-byte boundary; all elements, or one rank's share of them.
#[derive(Clone, Debug, Default)]
pub struct HostField {
    lanes: Vec<Lanes>,
    len: usize,
    ranks: Option<Arc<dyn Communicator>>,
}

impl HostField {
    /// `len` zeros.
    #[must_use]
    pub fn zeros(len: usize) -> Self {
        let count = len.div_ceil(LANES);
        // Fresh memory comes page by page to the thread that writes first: many pages want many threads
        let lanes = if len > BLOCK {
            rayon::iter::repeat_n(Lanes::default(), count)
                .with_min_len(BLOCK / LANES)
                .collect()
        } else {
            vec![Lanes::default(); count]
        };
        HostField {
            lanes,
            len,
            ranks: None,
        }
    }

    /// A copy of a slice.
    #[must_use]
    pub fn from_slice(values: &[f32]) -> Self {
        let mut field = HostField::zeros(values.len());
        field.as_mut_slice().copy_from_slice(values);
        field
    }

    /// The same elements as one rank's share: sums and extremes are those of the elements of all ranks, and every rank asks for them.
    #[must_use]
    pub fn shared(mut self, ranks: Arc<dyn Communicator>) -> Self {
        self.ranks = Some(ranks);
        self
    }

    /// Sums over this rank's elements become those over all ranks'.
    pub(crate) fn add_up(&self, sums: &mut [f64]) {
        if let Some(ranks) = &self.ranks {
            ranks.all_reduce(sums);
        }
    }

    /// What blocks of this rank's elements found, block after block, summed over all ranks.
    fn totals<const N: usize>(&self, blocks: &[[f64; N]]) -> [f64; N] {
        let add = |sums: [f64; N], block: &[f64; N]| std::array::from_fn(|i| sums[i] + block[i]);
        let mut sums = blocks.iter().fold([0.0; N], add);
        self.add_up(&mut sums);
        sums
    }

    /// The largest of all ranks of a number that each has, where this field is one rank's share; else the number.
    #[must_use]
    pub fn largest(&self, local: f32) -> f32 {
        let ranks = self.ranks.as_ref();
        ranks.map_or(local, |ranks| ranks.largest(local))
    }

    /// The elements.
    #[must_use]
    pub fn as_slice(&self) -> &[f32] {
        &bytemuck::cast_slice(&self.lanes)[..self.len]
    }

    /// The elements, to change.
    #[must_use]
    pub fn as_mut_slice(&mut self) -> &mut [f32] {
        &mut bytemuck::cast_slice_mut(&mut self.lanes)[..self.len]
    }

    /// The elements sixteen at a time; what lies beyond the last element is padding, which nobody reads as a result.
    #[must_use]
    pub fn lanes(&self) -> &[Lanes] {
        &self.lanes
    }

    /// The elements sixteen at a time, to change; see [`lanes`](Self::lanes).
    #[must_use]
    pub fn lanes_mut(&mut self) -> &mut [Lanes] {
        &mut self.lanes
    }

    /// Σ over blocks of `f(block of self, block of other)`, in a fixed order. One function for all: what splits the work is compiled once.
    fn sum_blocks(&self, other: &Self, f: &(dyn Fn(&[f32], &[f32]) -> f64 + Sync)) -> f64 {
        assert_eq!(self.len, other.len, "fields of different length");
        let partial: Vec<f64> = self
            .as_slice()
            .chunks(BLOCK)
            .zip(other.as_slice().chunks(BLOCK))
            .par_map(|(a, b)| f(a, b));
        self.total(partial.iter().sum())
    }

    fn update_blocks(&mut self, other: &Self, f: &(dyn Fn(&mut [f32], &[f32]) + Sync)) {
        assert_eq!(self.len, other.len, "fields of different length");
        self.as_mut_slice()
            .chunks_mut(BLOCK)
            .zip(other.as_slice().chunks(BLOCK))
            .par_each(|(a, b)| f(a, b));
    }

    /// selfᵢ ← f(selfᵢ, otherᵢ): for what works on the host alone.
    pub fn zip_blocks(&mut self, other: &Self, f: impl Fn(f32, f32) -> f32 + Sync) {
        self.update_blocks(other, &|a, b| {
            a.iter_mut().zip(b).for_each(|(a, &b)| *a = f(*a, b));
        });
    }

    /// selfᵢ ← f(selfᵢ)
    fn map(&mut self, f: impl Fn(f32) -> f32 + Sync) {
        self.map_blocks(&|block| block.iter_mut().for_each(|v| *v = f(*v)));
    }

    fn map_blocks(&mut self, f: &(dyn Fn(&mut [f32]) + Sync)) {
        self.as_mut_slice().chunks_mut(BLOCK).par_each(f);
    }
}

/// `value` brought into the bounds; a NaN stays one, which `f32::clamp` would also do but not `max` and `min`.
#[inline(always)]
fn clamp(value: f32, lower: f32, upper: f32) -> f32 {
    let value = if value < lower { lower } else { value };
    if value > upper { upper } else { value }
}

/// The larger of two numbers, NaN if one of them is.
fn larger(a: f32, b: f32) -> f32 {
    if a.is_nan() || b.is_nan() {
        f32::NAN
    } else {
        a.max(b)
    }
}

/// Σ aᵢ·bᵢ in f64, with eight running sums so that it vectorizes.
#[must_use]
pub fn dot_block(a: &[f32], b: &[f32]) -> f64 {
    let mut sums = [0.0f64; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let tail: f64 = a8
        .remainder()
        .iter()
        .zip(b8.remainder())
        .map(|(&x, &y)| f64::from(x) * f64::from(y))
        .sum();
    for (x, y) in a8.zip(b8) {
        for i in 0..8 {
            sums[i] += f64::from(x[i]) * f64::from(y[i]);
        }
    }
    sums.iter().sum::<f64>() + tail
}

impl Field for HostField {
    type Bounds = Bounds;
    type Pairs = HostPairs;
    type Bands = HostBands;
    type Costs = HostCosts;
    type HalfRamp = HostHalfRamp;

    fn len(&self) -> usize {
        self.len
    }

    fn zeros_like(&self) -> Self {
        HostField {
            ranks: self.ranks.clone(),
            ..HostField::zeros(self.len)
        }
    }

    fn zeros_of(&self, facts: &Facts<'_>, space: Space) -> Self {
        facts.host_field(space)
    }

    fn set_stretches(&mut self, adds: bool, a: f32, x: &Self, stretches: &[Stretch]) {
        let (to, from) = (self.as_mut_slice(), x.as_slice());
        for part in stretches {
            let to = &mut to[part.to..][..part.count];
            let from = &from[part.from..][..part.count];
            let blocks = to.chunks_mut(BLOCK).zip(from.chunks(BLOCK));
            // The sum with 0 makes no −0
            let each = |(to, from): (&mut [f32], &[f32])| {
                for (to, &from) in to.iter_mut().zip(from) {
                    *to = if adds { *to } else { 0.0 } + a * from;
                }
            };
            match part.count > BLOCK {
                true => blocks.par_each(each),
                false => blocks.for_each(each),
            }
        }
    }

    fn total(&self, local: f64) -> f64 {
        let mut sum = [local];
        self.add_up(&mut sum);
        sum[0]
    }

    fn copy_from(&mut self, other: &Self) {
        self.update_blocks(other, &|a, b| a.copy_from_slice(b));
    }

    fn fill(&mut self, value: f32) {
        self.map_blocks(&|block| block.fill(value));
    }

    fn clear(&mut self, range: Range<usize>) {
        let blocks = self.as_mut_slice()[range].chunks_mut(BLOCK);
        blocks.par_each(|block| block.fill(0.0));
    }

    fn dot(&self, other: &Self) -> f64 {
        self.sum_blocks(other, &dot_block)
    }

    fn axpy(&mut self, a: f32, x: &Self) {
        self.update_blocks(x, &|y, x| {
            y.iter_mut().zip(x).for_each(|(y, &x)| *y += a * x)
        });
    }

    fn scale(&mut self, a: f32) {
        self.map(|v| v * a);
    }

    fn clamp(&mut self, lower: f32, upper: f32) {
        self.map(|v| v.max(lower).min(upper));
    }

    fn move_along(&mut self, step: &Self, a: f32, bounds: &Bounds) {
        let blocks = bounds.split_mut(self, [step]);
        blocks.par_each(|(x, b, [step])| {
            for (x, step) in x.iter_mut().zip(step) {
                *x = clamp(*x + a * step, b.lower, b.upper);
            }
        });
    }

    fn project_step(&mut self, x: &Self, gradient: &Self, t: f32, bounds: &Bounds) -> StepSums {
        let blocks = bounds.split_mut(self, [x, gradient]);
        let sums: Vec<[f64; 2]> = blocks.par_map(|(step, b, [x, gradient])| {
            for ((step, x), gradient) in step.iter_mut().zip(x).zip(gradient) {
                *step = clamp(x - t * gradient, b.lower, b.upper) - x;
            }
            [dot_block(gradient, step), dot_block(step, step)]
        });
        let [slope, square] = self.totals(&sums);
        StepSums { slope, square }
    }

    fn free_gradient(&mut self, x: &Self, gradient: &Self, bounds: &Bounds) {
        let blocks = bounds.split_mut(self, [x, gradient]);
        blocks.par_each(|(free, b, [x, gradient])| {
            // Both sides of every comparison, as vectors do: a branch per pixel is guessed wrong
            for ((free, &x), &g) in free.iter_mut().zip(x).zip(gradient) {
                let held = (x <= b.lower) & (g >= 0.0) | (x >= b.upper) & (g <= 0.0);
                *free = if held { 0.0 } else { g };
            }
        });
    }

    fn change_where_moved(&mut self, step: &Self, before: &Self, after: &Self) {
        assert_eq!(self.len, step.len, "fields of different length");
        assert_eq!(self.len, before.len, "fields of different length");
        assert_eq!(self.len, after.len, "fields of different length");
        self.as_mut_slice()
            .chunks_mut(BLOCK)
            .zip(step.as_slice().chunks(BLOCK))
            .zip(before.as_slice().chunks(BLOCK))
            .zip(after.as_slice().chunks(BLOCK))
            .par_each(|(((change, step), before), after)| {
                let gradients = before.iter().zip(after);
                for ((change, &step), (before, after)) in change.iter_mut().zip(step).zip(gradients)
                {
                    let difference = after - before;
                    *change = if step == 0.0 { 0.0 } else { difference };
                }
            });
    }

    fn secant(&self, before: &Self, after: &Self) -> Secant {
        assert_eq!(self.len, before.len, "fields of different length");
        assert_eq!(self.len, after.len, "fields of different length");
        let sums: Vec<[f64; 3]> = self
            .as_slice()
            .chunks(BLOCK)
            .zip(before.as_slice().chunks(BLOCK))
            .zip(after.as_slice().chunks(BLOCK))
            .par_map(|((step, before), after)| {
                let [mut pp, mut py, mut yy] = [0.0; 3];
                for ((&p, &before), &after) in step.iter().zip(before).zip(after) {
                    let y = if p == 0.0 {
                        0.0
                    } else {
                        f64::from(after) - f64::from(before)
                    };
                    let p = f64::from(p);
                    pp += p * p;
                    py += p * y;
                    yy += y * y;
                }
                [pp, py, yy]
            });
        let [pp, py, yy] = self.totals(&sums);
        Secant { pp, py, yy }
    }

    fn max_abs(&self) -> f32 {
        let blocks = self.as_slice().chunks(BLOCK);
        let largest = |block: &[f32]| block.iter().map(|v| v.abs()).fold(0.0, larger);
        self.largest(blocks.par_map(largest).into_iter().fold(0.0, larger))
    }

    fn max_marked(&self, marks: &Self) -> f32 {
        assert_eq!(self.len, marks.len, "fields of different length");
        let marked = |value: f32, mark: f32| if mark < 0.0 { 0.0 } else { value };
        let largest = (self.as_slice())
            .chunks(BLOCK)
            .zip(marks.as_slice().chunks(BLOCK))
            .par_map(|(a, b)| {
                a.iter()
                    .zip(b)
                    .map(|(&a, &b)| marked(a, b))
                    .fold(0.0, larger)
            });
        self.largest(largest.into_iter().fold(0.0, larger))
    }

    fn lowest(&self) -> f32 {
        let lowest = |block: &[f32]| block.iter().copied().fold(0.0, f32::min);
        let blocks = self.as_slice().chunks(BLOCK).par_map(lowest);
        -self.largest(-blocks.into_iter().fold(0.0, f32::min))
    }

    fn shift(&mut self, a: f32) {
        self.map(|v| v + a);
    }

    fn multiply(&mut self, other: &Self) {
        self.zip_blocks(other, |a, b| a * b);
    }

    fn keep_positive(&mut self, marks: &Self) {
        self.zip_blocks(marks, |v, mark| if mark > 0.0 { v } else { 0.0 });
    }

    fn mix(&mut self, keep: f32, x: &Self) {
        self.zip_blocks(x, |mean, x| keep * mean + (1.0 - keep) * x);
    }

    fn mix_squares(&mut self, keep: f32, x: &Self) {
        self.zip_blocks(x, |mean, x| keep * mean + (1.0 - keep) * x * x);
    }

    fn divide_by_roots(&mut self, squares: &Self, factor: f32, epsilon: f32) {
        self.zip_blocks(squares, |v, square| {
            v / ((square * factor).sqrt() + epsilon)
        });
    }

    fn logistic_error(&mut self, target: &Self, midpoint: f32, width: f32) {
        self.zip_blocks(target, |dose, target| {
            if target < 0.0 {
                0.0
            } else {
                1.0 / (1.0 + ((midpoint - dose) / width).exp()) - target
            }
        });
    }

    fn compile_bounds(&self, bounds: &Bounds) -> Bounds {
        bounds.clone()
    }

    #[expect(clippy::cast_precision_loss, reason = "at most 2¹⁶ levels")]
    fn quantize(&mut self, levels: u32, bounds: &Bounds) {
        let top = self.max_abs();
        let steps = levels.saturating_sub(1).max(1) as f32;
        bounds.split_mut(self, []).par_each(|(values, b, [])| {
            let upper = if b.upper.is_finite() { b.upper } else { top };
            let width = upper - b.lower;
            if width > 0.0 {
                for value in values {
                    let share = (clamp(*value, b.lower, upper) - b.lower) / width;
                    // Half goes up, as in the patterns that are written
                    let level = (share * steps + 0.5).floor() / steps;
                    *value = clamp(b.lower + level * width, b.lower, upper);
                }
            }
        });
    }

    fn to_host(&self) -> Vec<f32> {
        self.as_slice().to_vec()
    }

    fn host_bytes(&self) -> Cow<'_, [u8]> {
        Cow::Borrowed(bytemuck::cast_slice(self.as_slice()))
    }

    fn write(&mut self, begin: usize, values: &[f32]) {
        self.as_mut_slice()[begin..][..values.len()].copy_from_slice(values);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_even_between_the_bounds_and_half_goes_up() {
        let mut x = HostField::from_slice(&[-1.0, 0.0, 0.124, 0.125, 0.4, 0.99, 7.0]);
        // Five levels on [0, 1]
        x.quantize(5, &Bounds::uniform(7, 0.0, 1.0));
        assert_eq!(x.as_slice(), [0.0, 0.0, 0.0, 0.25, 0.5, 1.0, 1.0]);
        // One bit from ¼ to the largest element
        let mut x = HostField::from_slice(&[0.0, 1.0, 2.25, 1.2]);
        x.quantize(2, &Bounds::uniform(4, 0.25, f32::INFINITY));
        assert_eq!(x.as_slice(), [0.25, 0.25, 2.25, 0.25]);
    }

    #[test]
    fn what_is_no_number_is_not_lost_in_the_largest() {
        let x = HostField::from_slice(&[1.0, f32::NAN, 3.0]);
        assert!(x.max_abs().is_nan());
        let all = HostField::from_slice(&[0.0, 1.0, 0.0]);
        assert!(x.max_marked(&all).is_nan());
        let y = HostField::from_slice(&[1.0, -5.0, 3.0]);
        assert_eq!((y.max_marked(&all), y.lowest()), (3.0, -5.0));
        // What does not count may be anything
        let some = HostField::from_slice(&[0.0, -1.0, -1.0]);
        assert_eq!((x.max_marked(&some), y.max_marked(&some)), (1.0, 1.0));
    }

    /// The formulas that methods are made of, one element each, in numbers without rounding.
    #[test]
    fn the_formulas_of_methods_are_what_their_names_say() {
        let field_of = |values: &[f32]| HostField::from_slice(values);
        let after = |change: &dyn Fn(&mut HostField)| {
            let mut x = field_of(&[2.0, -4.0, 0.5]);
            change(&mut x);
            x.as_slice().to_vec()
        };
        let other = field_of(&[4.0, -1.0, 0.0]);
        assert_eq!(after(&|x| x.shift(1.0)), [3.0, -3.0, 1.5]);
        assert_eq!(after(&|x| x.multiply(&other)), [8.0, 4.0, 0.0]);
        assert_eq!(after(&|x| x.keep_positive(&other)), [2.0, 0.0, 0.0]);
        assert_eq!(after(&|x| x.mix(0.75, &other)), [2.5, -3.25, 0.375]);
        assert_eq!(after(&|x| x.mix_squares(0.75, &other)), [5.5, -2.75, 0.375]);
        // √(4·4) + 1 and √0 + 1
        let squares = field_of(&[4.0, 0.0, 0.0]);
        assert_eq!(
            after(&|x| x.divide_by_roots(&squares, 4.0, 1.0)),
            [0.4, -4.0, 0.5]
        );
        // ½ − 4 at the midpoint; what is marked does not count; 1/(1 + e) − 0 a width below the midpoint
        let found = after(&|x| x.logistic_error(&other, 2.0, 1.5));
        assert_eq!(found[..2], [-3.5, 0.0]);
        assert!((found[2] - 1.0 / (1.0 + std::f32::consts::E)).abs() < 1e-6);
        assert_eq!(after(&|x| x.write(1, &[7.0])), [2.0, 7.0, 0.5]);
    }
}
