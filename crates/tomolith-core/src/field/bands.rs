//! The band loss: data, and the passes over a dose that it is computed with.
//!
//! A voxel is right while its response lies in a band [lower, upper]; outside, it costs its distance from the band, to a power.
//!
//! **Equation** with m = M(d) of the dose d and e = max(lower − m, m − upper, 0)
//!
//! ```text
//! L        = S^(q/p),   S = Σ_v w_v·e_v^p                         w inside the sum, no voxel volume
//! ∂L/∂d_v  = (q/p)·S^(q/p − 1) · w_v·p·e_v^(p−1) · sign · M′(d_v)  sign: −1 below the band, +1 above
//! ```
//!
//! [`BandLoss`] is all of it as plain data: bands and weights of the voxels, p and q, and the response
//! ([`ResponseForm`](crate::response::ResponseForm)). A [`BandKernel`] is what a backend makes of the data, and its passes; [`HostBands`] is that of
//! host memory. Sources and presets are in the crate of objectives.
//!
//! **Where the formula has no derivative.** At L = 0 the gradient is 0, also for q < p, where the factor S^(q/p − 1) is
//! infinite. For p < 1 the slope at the edge of the band is infinite; there e^p is replaced by its chord e·δ^(p−1) for
//! e < δ = [`CHORD`], so that value and gradient stay an exact pair and finite.
//!
//! **Order of sums** of the host: distances and terms in f32, those of 16 neighbors added in pairs (i and i + 8), these in eight
//! running sums of f64 over 512 elements; then all chunks of [`BLOCK`] elements, then all blocks.
//!
//! **Cost** one pass over dose and bands. Sixteen neighbors along z that share a label skip the table; for p = 1, 2 and the
//! identity response the pass is bound by memory (about 5 bytes read per voxel).

use super::group::Group;
use super::{BLOCK, Field, HostField, LANES, Lanes};
use crate::error::{Error, Result};
use crate::response::{Response, is_reached};
use crate::units::exact;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use wide::f32x8;

/// For powers below 1: below this distance the power is replaced by its chord.
pub const CHORD: f32 = 1e-4;

/// What a voxel's response should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Smallest response without penalty, −∞ for none.
    pub lower: f32,
    /// Largest response without penalty, +∞ for none.
    pub upper: f32,
    /// Weight inside the sum, 0 for a voxel that does not count.
    pub weight: f32,
}

impl Band {
    /// A band that costs nothing anywhere.
    pub const FREE: Band = Band {
        lower: f32::NEG_INFINITY,
        upper: f32::INFINITY,
        weight: 0.0,
    };

    /// `[lower, upper]` with a weight.
    #[must_use]
    pub fn new(lower: f32, upper: f32, weight: f32) -> Self {
        Band {
            lower,
            upper,
            weight,
        }
    }

    /// One value, weight 1.
    #[must_use]
    pub fn exactly(value: f32) -> Self {
        Band::new(value, value, 1.0)
    }

    /// `(−∞, upper]`, weight 1.
    #[must_use]
    pub fn below(upper: f32) -> Self {
        Band::new(f32::NEG_INFINITY, upper, 1.0)
    }

    /// `[lower, ∞)`, weight 1.
    #[must_use]
    pub fn above(lower: f32) -> Self {
        Band::new(lower, f32::INFINITY, 1.0)
    }

    /// The same band with another weight.
    #[must_use]
    pub fn weighing(mut self, weight: f32) -> Self {
        self.weight = weight;
        self
    }

    /// The same band, wider by `tolerance` on either side.
    #[must_use]
    pub fn widened(mut self, tolerance: f32) -> Self {
        self.lower -= tolerance;
        self.upper += tolerance;
        self
    }

    fn validate(&self) -> Result<()> {
        // Also refuses NaN
        if !(self.lower <= self.upper
            && self.lower < f32::INFINITY
            && self.upper > f32::NEG_INFINITY)
        {
            return Err(Error::config(
                "band",
                format!(
                    "lower {} and upper {}",
                    exact(self.lower),
                    exact(self.upper)
                ),
                "lower ≤ upper, neither a NaN",
            ));
        }
        if !(self.weight >= 0.0 && self.weight.is_finite()) {
            return Err(Error::config(
                "weight",
                format!("found {}", exact(self.weight)),
                "a finite number, 0 or above",
            ));
        }
        Ok(())
    }
}

/// The bands of all voxels, in the order of the model's dose field.
#[derive(Clone, Debug)]
pub enum Bands {
    /// A label per voxel and a band per label.
    Labels {
        /// One per element of the field.
        labels: Vec<u8>,
        /// One per label.
        table: Box<[Band; 256]>,
    },
    /// Every voxel is part and void at once, in shares s and 1 − s: the surface cuts through it.
    Shared {
        /// s per element of the field, negative where a voxel does not count.
        inside: Vec<f32>,
        /// Weighs s.
        part: Band,
        /// Weighs 1 − s.
        void: Band,
        /// Factor of both weights per element; empty for 1.
        scale: Vec<f32>,
        /// What both bands are widened by on either side, per element; empty for 0.
        widen: Vec<f32>,
    },
    /// A band per voxel; arrays may be shared, for lower = upper.
    Voxels {
        /// Per element of the field.
        lower: Arc<[f32]>,
        /// Per element of the field.
        upper: Arc<[f32]>,
        /// Per element of the field.
        weight: Arc<[f32]>,
    },
}

impl Bands {
    /// Bands for some labels; the others do not count.
    #[must_use]
    pub fn labels(labels: Vec<u8>, bands: &[(u8, Band)]) -> Self {
        let mut table = Box::new([Band::FREE; 256]);
        for &(label, band) in bands {
            table[usize::from(label)] = band;
        }
        Bands::Labels { labels, table }
    }

    fn len(&self) -> usize {
        match self {
            Bands::Labels { labels, .. } => labels.len(),
            Bands::Shared { inside, .. } => inside.len(),
            Bands::Voxels { lower, .. } => lower.len(),
        }
    }

    fn validate(&self) -> Result<()> {
        match self {
            Bands::Labels { table, .. } => table.iter().try_for_each(Band::validate),
            Bands::Shared { part, void, .. } => part.validate().and_then(|()| void.validate()),
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => {
                for (what, found) in [("upper", upper.len()), ("weight", weight.len())] {
                    if found != lower.len() {
                        return Err(Error::Shape {
                            what: format!("{what} of the bands"),
                            expected: vec![lower.len()],
                            found: vec![found],
                        });
                    }
                }
                (0..lower.len())
                    .into_par_iter()
                    .try_for_each(|i| Band::new(lower[i], upper[i], weight[i]).validate())
            }
        }
    }

    /// A band that counts and of which the response reaches nothing.
    fn out_of_reach(&self, response: &dyn Response) -> Option<Band> {
        let missed = |band: &Band| {
            let [lower, upper] = [band.lower, band.upper].map(f64::from);
            band.weight > 0.0 && !is_reached(response, lower, upper)
        };
        match self {
            Bands::Labels { table, .. } => table.iter().copied().find(missed),
            Bands::Shared {
                part, void, widen, ..
            } => {
                let widest = widen.iter().copied().fold(0.0, f32::max);
                let bands = [*part, *void].map(|band| band.widened(widest));
                bands.into_iter().find(missed)
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => (0..lower.len())
                .map(|i| Band::new(lower[i], upper[i], weight[i]))
                .find(missed),
        }
    }

    /// Weights times a factor and bands widened, per element; either may be empty for none.
    fn emphasized(self, scale: &[f32], widen: &[f32]) -> Self {
        let at = |field: &[f32], i: usize, none: f32| field.get(i).copied().unwrap_or(none);
        let each = |band: Band, i: usize| {
            band.widened(at(widen, i, 0.0))
                .weighing(band.weight * at(scale, i, 1.0))
        };
        match self {
            Bands::Shared {
                inside,
                part,
                void,
                scale: own,
                ..
            } => Bands::Shared {
                scale: match (own.is_empty(), scale.is_empty()) {
                    (true, _) => scale.to_vec(),
                    (_, true) => own,
                    _ => own.iter().zip(scale).map(|(a, b)| a * b).collect(),
                },
                inside,
                part,
                void,
                widen: widen.to_vec(),
            },
            Bands::Labels { labels, table } => {
                let bands: Vec<Band> = labels
                    .iter()
                    .enumerate()
                    .map(|(i, &label)| each(table[usize::from(label)], i))
                    .collect();
                Bands::voxels(&bands)
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => {
                let bands: Vec<Band> = (0..lower.len())
                    .map(|i| each(Band::new(lower[i], upper[i], weight[i]), i))
                    .collect();
                Bands::voxels(&bands)
            }
        }
    }

    fn voxels(bands: &[Band]) -> Self {
        Bands::Voxels {
            lower: bands.iter().map(|b| b.lower).collect(),
            upper: bands.iter().map(|b| b.upper).collect(),
            weight: bands.iter().map(|b| b.weight).collect(),
        }
    }

    /// Fills up to whole lanes with elements that do not count.
    fn pad(&mut self) -> Result<()> {
        let len = self.len().next_multiple_of(LANES);
        match self {
            Bands::Labels { labels, table } => {
                if labels.len() < len {
                    let free = (0..=255u8).find(|&l| table[usize::from(l)].weight == 0.0);
                    let free = free.ok_or_else(|| Error::Unsupported {
                        what: "a table in which all 256 labels count".to_owned(),
                        reason: "one is needed for elements that do not".to_owned(),
                    })?;
                    labels.resize(len, free);
                }
            }
            Bands::Shared {
                inside,
                scale,
                widen,
                ..
            } => {
                inside.resize(len, -1.0);
                for field in [scale, widen] {
                    if !field.is_empty() {
                        field.resize(len, 0.0);
                    }
                }
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => {
                for (array, value) in [(lower, 0.0), (upper, 0.0), (weight, 0.0)] {
                    if array.len() < len {
                        let mut longer = array.to_vec();
                        longer.resize(len, value);
                        *array = longer.into();
                    }
                }
            }
        }
        Ok(())
    }
}

/// A band loss as plain data; see the [module](self).
#[derive(Clone, Debug)]
pub struct BandLoss {
    elements: Range<usize>,
    bands: Bands,
    p: f64,
    q: f64,
    response: Arc<dyn Response>,
}

impl BandLoss {
    /// A loss on the `elements` of the model's dose field (see [`DoseLayout::range`]), which must begin at a multiple of 16;
    /// `bands` has one entry per element.
    ///
    /// # Errors
    /// [`Error::Config`] for p or q not above 0, lower > upper, a NaN or a negative weight; [`Error::Shape`].
    ///
    /// [`DoseLayout::range`]: crate::dose::DoseLayout::range
    pub fn new(
        elements: Range<usize>,
        mut bands: Bands,
        p: f64,
        q: f64,
        response: Arc<dyn Response>,
    ) -> Result<Self> {
        for (key, value) in [("p", p), ("q", q)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::config(
                    key,
                    format!("found {}", exact(value)),
                    "a finite number above 0",
                ));
            }
        }
        if bands.len() != elements.len() || !elements.start.is_multiple_of(LANES) {
            return Err(Error::Shape {
                what: "bands of the objective (beginning at a multiple of 16)".to_owned(),
                expected: vec![elements.start.next_multiple_of(LANES), elements.len()],
                found: vec![elements.start, bands.len()],
            });
        }
        bands.validate()?;
        bands.pad()?;
        Ok(BandLoss {
            elements,
            bands,
            p,
            q,
            response,
        })
    }

    /// The elements of the dose field that the bands are for; the first is a multiple of 16.
    #[must_use]
    pub fn elements(&self) -> Range<usize> {
        self.elements.clone()
    }

    /// The bands, in the order of the elements and filled up to whole lanes.
    #[must_use]
    pub fn bands(&self) -> &Bands {
        &self.bands
    }

    /// p, the power of the distances, and q, that of the norm.
    #[must_use]
    pub fn powers(&self) -> [f64; 2] {
        [self.p, self.q]
    }

    /// M, the response that the bands are for.
    #[must_use]
    pub fn response(&self) -> &dyn Response {
        self.response.as_ref()
    }

    /// Whether the loss is convex in the dose.
    #[must_use]
    pub fn is_convex(&self) -> bool {
        self.p >= 1.0 && self.q >= 1.0 && self.response.is_identity()
    }

    /// Multiplies weights and widens bands on either side, per element; either may be empty for none.
    ///
    /// # Errors
    /// [`Error::Shape`], [`Error::Config`] for a negative weight.
    pub fn set_voxel_weights(&mut self, weight: &[f32], tolerance: &[f32]) -> Result<()> {
        let n = self.elements.len();
        for (what, field) in [("weights", weight), ("tolerance", tolerance)] {
            if !field.is_empty() && field.len() != n {
                return Err(Error::Shape {
                    what: format!("{what} of the objective"),
                    expected: vec![n],
                    found: vec![field.len()],
                });
            }
        }
        if weight.is_empty() && tolerance.is_empty() {
            return Ok(());
        }
        let free = Bands::voxels(&[]);
        let bands = std::mem::replace(&mut self.bands, free);
        self.bands = bands.emphasized(weight, tolerance);
        self.bands.validate()?;
        self.bands.pad()
    }

    /// Refuses bands that the response cannot reach.
    ///
    /// # Errors
    /// [`Error::Config`] (without a key).
    pub fn must_be_reached(&self) -> Result<()> {
        // The identity reaches everything, and bands per voxel are many
        let Some(band) = (!self.response.is_identity())
            .then(|| self.bands.out_of_reach(self.response.as_ref()))
            .flatten()
        else {
            return Ok(());
        };
        let [low, high] = self.response.range().map(exact);
        let [lower, upper] = [band.lower, band.upper].map(exact);
        Err(Error::config(
            "",
            format!("the band from {lower} to {upper} lies outside the response's range"),
            format!("bands that meet the response's range, {low} to {high}"),
        ))
    }

    /// The groups of sixteen elements that count.
    fn groups(&self) -> Range<usize> {
        self.elements.start / LANES..self.elements.end.div_ceil(LANES)
    }

    /// L of S.
    #[must_use]
    pub fn loss(&self, sum: f64) -> f64 {
        if self.p == self.q {
            sum
        } else {
            sum.powf(self.q / self.p)
        }
    }

    /// dL/dS; 0 at S = 0, where it is infinite for q < p.
    #[must_use]
    pub fn loss_slope(&self, sum: f64) -> f64 {
        if self.p == self.q {
            1.0
        } else if sum == 0.0 {
            0.0
        } else {
            self.q / self.p * sum.powf(self.q / self.p - 1.0)
        }
    }

    /// S over a chunk of doses that begins at `group`; `slopes` becomes ∂S/∂d.
    #[inline]
    fn chunk(&self, group: usize, doses: &[Lanes], slopes: &mut [Lanes]) -> f64 {
        if self.response.is_identity() {
            return self.penalty(group, doses, slopes);
        }
        let mut responses = [Lanes::default(); CHUNK];
        let mut inner = [Lanes::default(); CHUNK];
        let responses = &mut responses[..doses.len()];
        responses.copy_from_slice(doses);
        for (response, inner) in responses.iter_mut().zip(&mut inner) {
            self.response.lanes(response, inner);
        }
        let sum = self.penalty(group, responses, slopes);
        for (slope, inner) in slopes.iter_mut().zip(&inner) {
            slope
                .0
                .iter_mut()
                .zip(&inner.0)
                .for_each(|(slope, inner)| *slope *= inner);
        }
        sum
    }

    /// S over a chunk of responses, and ∂S/∂m.
    fn penalty(&self, group: usize, responses: &[Lanes], slopes: &mut [Lanes]) -> f64 {
        if self.p == 2.0 {
            self.bands.sum(group, responses, slopes, Square)
        } else if self.p == 1.0 {
            self.bands.sum(group, responses, slopes, Distance)
        } else if self.p == 3.0 {
            self.bands.sum(group, responses, slopes, Whole::<3>)
        } else if self.p == 4.0 {
            self.bands.sum(group, responses, slopes, Whole::<4>)
        } else {
            self.bands.sum(group, responses, slopes, Power::new(self.p))
        }
    }
}

/// The passes of a band loss over doses, where the fields F live.
pub trait BandKernel<F>: Send + Sync {
    /// Brings the data to where `like` lives.
    fn new(loss: &Arc<BandLoss>, like: &F) -> Self;
    /// L(dose)
    fn value(&self, dose: &F) -> f64;
    /// L(dose), and ∂L/∂dose written over `grad`, 0 for elements that the loss is not for; the value equals
    /// [`value`](Self::value) bit for bit.
    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64;
    /// L of dose + α·step and its derivative by α.
    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64);
    /// dose ← dose + α·step, step ← ∂L/∂dose there; L there.
    fn advance(&self, dose: &mut F, step: &mut F, alpha: f32) -> f64;
}

/// [`BandKernel`] in host memory: the data as they are.
#[derive(Clone, Debug)]
pub struct HostBands(Arc<BandLoss>);

/// Groups of sixteen per inner chunk: what a chunk needs stays in the first cache.
const CHUNK: usize = 32;
/// Groups of sixteen per block of a parallel loop.
const GROUPS: usize = BLOCK / LANES;

/// Terms w·|r|^p and their derivatives, for signed distances r from the band.
trait Penalty: Copy + Sync {
    fn at(self, distance: f32x8, weight: f32x8) -> (f32x8, f32x8);
}

#[derive(Clone, Copy)]
struct Square;

impl Penalty for Square {
    #[inline(always)]
    fn at(self, distance: f32x8, weight: f32x8) -> (f32x8, f32x8) {
        let slope = weight * distance;
        (slope * distance, slope + slope)
    }
}

/// A whole power of 3 or more, by multiplications in place of `powf`.
#[derive(Clone, Copy)]
struct Whole<const P: u8>;

impl<const P: u8> Penalty for Whole<P> {
    #[inline(always)]
    fn at(self, distance: f32x8, weight: f32x8) -> (f32x8, f32x8) {
        let size = distance.abs();
        let rise = (3..P).fold(size, |rise, _| rise * size);
        let slope = weight * rise * distance;
        (slope * distance, slope * f32::from(P))
    }
}

#[derive(Clone, Copy)]
struct Distance;

impl Penalty for Distance {
    #[inline(always)]
    fn at(self, distance: f32x8, weight: f32x8) -> (f32x8, f32x8) {
        let zero = f32x8::ZERO;
        let rise = distance.simd_gt(zero) & weight;
        let fall = distance.simd_lt(zero) & weight;
        (weight * distance.abs(), rise - fall)
    }
}

#[derive(Clone, Copy)]
struct Power {
    p: f32,
    chord: f32,
}

impl Power {
    #[expect(clippy::cast_possible_truncation, reason = "kernels work in f32")]
    fn new(p: f64) -> Self {
        let chord = if p < 1.0 { CHORD } else { 0.0 };
        Power { p: p as f32, chord }
    }

    fn one(self, distance: f32, weight: f32) -> (f32, f32) {
        let e = distance.abs();
        if e == 0.0 || weight == 0.0 {
            return (weight * e, 0.0);
        }
        // `max` hides a NaN; the distance brings it back
        let rise = e.max(self.chord).powf(self.p - 1.0);
        let slope = if e < self.chord { rise } else { self.p * rise };
        (weight * rise * e, weight * slope.copysign(distance))
    }
}

impl Penalty for Power {
    fn at(self, distance: f32x8, weight: f32x8) -> (f32x8, f32x8) {
        let (distance, weight) = (distance.to_array(), weight.to_array());
        let terms: [(f32, f32); 8] = std::array::from_fn(|i| self.one(distance[i], weight[i]));
        (
            f32x8::from(terms.map(|t| t.0)),
            f32x8::from(terms.map(|t| t.1)),
        )
    }
}

/// Sixteen bands.
struct BandLanes {
    lower: Group,
    upper: Group,
    weight: Group,
}

impl BandLanes {
    /// One band for all.
    #[inline(always)]
    fn alike(band: &Band) -> Self {
        let all = |v: f32| Group([f32x8::splat(v); 2]);
        BandLanes {
            lower: all(band.lower),
            upper: all(band.upper),
            weight: all(band.weight),
        }
    }

    #[inline(always)]
    fn mixed(band: impl Fn(usize) -> Band) -> Self {
        let bands: [Band; LANES] = std::array::from_fn(band);
        BandLanes {
            lower: Group::of(&bands.map(|b| b.lower)),
            upper: Group::of(&bands.map(|b| b.upper)),
            weight: Group::of(&bands.map(|b| b.weight)),
        }
    }

    /// One band for all, its weight times shares and a scale, and wider.
    #[inline(always)]
    fn shared(band: &Band, shares: Group, scale: Option<&[f32]>, widen: Option<&[f32]>) -> Self {
        let alike = Self::alike(band);
        let read = |field: &[f32]| field.first_chunk().map(Group::of).unwrap_or_default();
        let weight = match scale.map(read) {
            Some(scale) => shares.zip(scale, |s, scale| s * scale),
            None => shares,
        };
        let widen = widen.map(read).unwrap_or_default();
        BandLanes {
            lower: alike.lower.zip(widen, |bound, by| bound - by),
            upper: alike.upper.zip(widen, |bound, by| bound + by),
            weight: alike.weight.zip(weight, |a, b| a * b),
        }
    }

    /// Adds the penalties of sixteen voxels to eight running sums; gives their derivatives.
    #[inline(always)]
    fn penalize(&self, m: Group, sums: &mut [f64; 8], penalty: impl Penalty) -> Group {
        let zero = f32x8::ZERO;
        let of_half = |half: usize| {
            let m = m.0[half];
            let above = (m - self.upper.0[half]).fast_max(zero);
            let below = (self.lower.0[half] - m).fast_max(zero);
            // The last term is 0, but not for a NaN, which the others may have lost
            penalty.at(above - below + m * zero, self.weight.0[half])
        };
        // One by one: `map` of an array would not be inlined
        let ((value0, slope0), (value1, slope1)) = (of_half(0), of_half(1));
        let values = (value0 + value1).to_array();
        for i in 0..8 {
            sums[i] += f64::from(values[i]);
        }
        Group([slope0, slope1])
    }
}

impl Bands {
    /// Σ of the penalties of a chunk that begins at `group`; overwrites `slopes`.
    fn sum(
        &self,
        group: usize,
        responses: &[Lanes],
        slopes: &mut [Lanes],
        penalty: impl Penalty,
    ) -> f64 {
        let mut sums = [0.0f64; 8];
        let range = group * LANES..(group + responses.len()) * LANES;
        let lanes = responses
            .iter()
            .map(|m| Group::of(&m.0))
            .zip(slopes.iter_mut());
        match self {
            Bands::Labels { labels, table } => {
                let labels = labels[range].as_chunks::<LANES>().0;
                for ((m, slope), labels) in lanes.zip(labels) {
                    let band = &table[usize::from(labels[0])];
                    *slope = if u128::from_le_bytes(*labels) != u128::from(labels[0]) * EVERY_BYTE {
                        let bands = BandLanes::mixed(|i| table[usize::from(labels[i])]);
                        Lanes(bands.penalize(m, &mut sums, penalty).to_array())
                    } else if band.weight != 0.0 {
                        Lanes(
                            BandLanes::alike(band)
                                .penalize(m, &mut sums, penalty)
                                .to_array(),
                        )
                    } else {
                        Lanes::default()
                    };
                }
            }
            Bands::Shared {
                inside,
                part,
                void,
                scale,
                widen,
            } => {
                let begin = range.start;
                let shares = inside[range].as_chunks::<LANES>().0;
                let plain = scale.is_empty() && widen.is_empty();
                for (k, ((m, slope), shares)) in lanes.zip(shares).enumerate() {
                    let alike = plain && *shares == [shares[0]; LANES];
                    let slopes = if alike && shares[0] < 0.0 {
                        Group::default()
                    } else if alike && shares[0] == 0.0 {
                        BandLanes::alike(void).penalize(m, &mut sums, penalty)
                    } else if alike && shares[0] == 1.0 {
                        BandLanes::alike(part).penalize(m, &mut sums, penalty)
                    } else {
                        let at = begin + k * LANES..begin + (k + 1) * LANES;
                        let [scale, widen] = [scale, widen].map(|field| field.get(at.clone()));
                        let (one, shares) = (f32x8::splat(1.0), Group::of(shares));
                        let counted = |s: f32x8, weight| s.simd_ge(f32x8::ZERO) & weight;
                        let parts =
                            BandLanes::shared(part, shares.map(|s| counted(s, s)), scale, widen);
                        let voids = BandLanes::shared(
                            void,
                            shares.map(|s| counted(s, one - s)),
                            scale,
                            widen,
                        );
                        let slopes = parts.penalize(m, &mut sums, penalty);
                        slopes.zip(voids.penalize(m, &mut sums, penalty), |a, b| a + b)
                    };
                    *slope = Lanes(slopes.to_array());
                }
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => {
                let [lower, upper, weight] =
                    [lower, upper, weight].map(|a| a[range.clone()].as_chunks::<LANES>().0);
                for (k, (m, slope)) in lanes.enumerate() {
                    let bands = BandLanes {
                        lower: Group::of(&lower[k]),
                        upper: Group::of(&upper[k]),
                        weight: Group::of(&weight[k]),
                    };
                    *slope = Lanes(bands.penalize(m, &mut sums, penalty).to_array());
                }
            }
        }
        sums.iter().sum()
    }
}

/// A 1 in every byte: times a byte, it is sixteen of them.
const EVERY_BYTE: u128 = u128::MAX / 255;

/// Sums of blocks, added in order: the result does not depend on how many threads there are.
fn in_order(partial: impl IndexedParallelIterator<Item = f64>) -> f64 {
    partial.collect::<Vec<f64>>().iter().sum()
}

/// dose ← dose + α·step
#[inline]
fn move_by(dose: &mut [Lanes], step: &[Lanes], alpha: f32) {
    for (dose, step) in dose.iter_mut().zip(step) {
        dose.0
            .iter_mut()
            .zip(&step.0)
            .for_each(|(dose, step)| *dose += alpha * step);
    }
}

impl BandKernel<HostField> for HostBands {
    fn new(loss: &Arc<BandLoss>, _: &HostField) -> Self {
        HostBands(loss.clone())
    }

    fn value(&self, dose: &HostField) -> f64 {
        let blocks = dose.lanes()[self.0.groups()].par_chunks(GROUPS).enumerate();
        self.0.loss(in_order(blocks.map(|(b, block)| {
            let mut slopes = [Lanes::default(); CHUNK];
            let mut sum = 0.0;
            for (c, dose) in block.chunks(CHUNK).enumerate() {
                sum += self
                    .0
                    .chunk(b * GROUPS + c * CHUNK, dose, &mut slopes[..dose.len()]);
            }
            sum
        })))
    }

    fn value_and_gradient(&self, dose: &HostField, grad: &mut HostField) -> f64 {
        assert_eq!(dose.len(), grad.len(), "fields of different length");
        if self.0.elements.len() < grad.len() {
            grad.fill(0.0);
        }
        let blocks = dose.lanes()[self.0.groups()]
            .par_chunks(GROUPS)
            .zip(grad.lanes_mut()[self.0.groups()].par_chunks_mut(GROUPS))
            .enumerate();
        let sum = in_order(blocks.map(|(b, (dose, grad))| {
            let chunks = dose.chunks(CHUNK).zip(grad.chunks_mut(CHUNK)).enumerate();
            let sum =
                chunks.map(|(c, (dose, grad))| self.0.chunk(b * GROUPS + c * CHUNK, dose, grad));
            sum.sum()
        }));
        self.0.finish(sum, grad)
    }

    fn slope_along(&self, dose: &HostField, step: &HostField, alpha: f32) -> (f64, f64) {
        assert_eq!(dose.len(), step.len(), "fields of different length");
        let sums: Vec<(f64, f64)> = dose.lanes()[self.0.groups()]
            .par_chunks(GROUPS)
            .zip(step.lanes()[self.0.groups()].par_chunks(GROUPS))
            .enumerate()
            .map(|(b, (dose, step))| {
                let (mut m, mut slopes) = ([Lanes::default(); CHUNK], [Lanes::default(); CHUNK]);
                let (mut sum, mut slope) = (0.0, 0.0);
                for (c, (dose, step)) in dose.chunks(CHUNK).zip(step.chunks(CHUNK)).enumerate() {
                    let n = dose.len();
                    m[..n].copy_from_slice(dose);
                    move_by(&mut m[..n], step, alpha);
                    sum += self
                        .0
                        .chunk(b * GROUPS + c * CHUNK, &m[..n], &mut slopes[..n]);
                    slope += dot(&slopes[..n], step);
                }
                (sum, slope)
            })
            .collect();
        let (sum, slope) = sums.iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
        (self.0.loss(sum), self.0.loss_slope(sum) * slope)
    }

    fn advance(&self, dose: &mut HostField, step: &mut HostField, alpha: f32) -> f64 {
        if self.0.elements.len() < dose.len() {
            dose.axpy(alpha, step);
            return self.value_and_gradient(dose, step);
        }
        assert_eq!(dose.len(), step.len(), "fields of different length");
        let blocks = dose.lanes_mut()[self.0.groups()]
            .par_chunks_mut(GROUPS)
            .zip(step.lanes_mut()[self.0.groups()].par_chunks_mut(GROUPS))
            .enumerate();
        let sum = in_order(blocks.map(|(b, (dose, step))| {
            let chunks = dose
                .chunks_mut(CHUNK)
                .zip(step.chunks_mut(CHUNK))
                .enumerate();
            let sum = chunks.map(|(c, (dose, step))| {
                move_by(dose, step, alpha);
                self.0.chunk(b * GROUPS + c * CHUNK, dose, step)
            });
            sum.sum()
        }));
        self.0.finish(sum, step)
    }
}

impl BandLoss {
    /// From S and ∂S/∂d to L and ∂L/∂d.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn finish(&self, sum: f64, grad: &mut HostField) -> f64 {
        let slope = self.loss_slope(sum);
        if slope != 1.0 {
            grad.scale(slope as f32);
        }
        self.loss(sum)
    }
}

/// Σ aᵢ·bᵢ of a chunk: products in f32, the sum in f64.
#[inline]
fn dot(a: &[Lanes], b: &[Lanes]) -> f64 {
    let mut sums = [0.0f64; 8];
    for (a, b) in a.iter().zip(b) {
        let products = Group::of(&a.0).products(Group::of(&b.0)).to_array();
        for i in 0..8 {
            sums[i] += f64::from(products[i]);
        }
    }
    sums.iter().sum()
}
