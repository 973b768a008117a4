//! The band loss on the host: eight voxels at a time, one penalty for each pair of powers.

use super::super::group::Group;
use super::super::{BLOCK, Field, HostField, LANES, Lanes};
use super::{Band, BandKernel, BandLoss, Bands, CHORD};
use crate::parallel::InParallel;
use std::sync::Arc;
use wide::f32x8;

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

    /// One band for those that count.
    #[inline(always)]
    fn counted(band: &Band, counted: Group) -> Self {
        let alike = Self::alike(band);
        BandLanes {
            weight: counted.zip(alike.weight, |counted, weight| counted & weight),
            ..alike
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
        // Most voxels keep their bands or do not count; a NaN does neither
        let is_kept = |half: usize| {
            let m = m.0[half];
            m.simd_ge(self.lower.0[half]) & m.simd_le(self.upper.0[half])
        };
        let is_left_out =
            |half: usize| self.weight.0[half].simd_eq(zero) & m.0[half].simd_eq(m.0[half]);
        let inside = [is_kept(0), is_kept(1)];
        if (inside[0] & inside[1]).all()
            || ((inside[0] | is_left_out(0)) & (inside[1] | is_left_out(1))).all()
        {
            return Group::default();
        }
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

/// The share of sixteen voxels, 1 or at most 0, and a mask of those that count, where all that do have the same; a column's last lanes are often
/// padding.
#[inline(always)]
fn whole(shares: &[f32; LANES]) -> Option<(f32, Group)> {
    let (first, zero) = (f32x8::splat(shares[0]), f32x8::ZERO);
    let counted = Group::of(shares).map(|s| s.simd_ge(zero));
    let alike = Group::of(shares).map(|s| s.simd_eq(first) | s.simd_lt(zero));
    let is_whole = shares[0] <= 0.0 || shares[0] == 1.0;
    (is_whole && (alike.0[0] & alike.0[1]).all()).then_some((shares[0], counted))
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
                    let whole = if plain { whole(shares) } else { None };
                    let slopes = if let Some((share, counted)) = whole {
                        let band = if share == 1.0 { part } else { void };
                        BandLanes::counted(band, counted).penalize(m, &mut sums, penalty)
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
        let blocks = dose.lanes()[self.0.groups()].chunks(GROUPS).enumerate();
        let sums = blocks.par_map(|(b, block)| {
            let mut slopes = [Lanes::default(); CHUNK];
            let mut sum = 0.0;
            for (c, dose) in block.chunks(CHUNK).enumerate() {
                sum += self
                    .0
                    .chunk(b * GROUPS + c * CHUNK, dose, &mut slopes[..dose.len()]);
            }
            sum
        });
        self.0.loss(sums.iter().sum())
    }

    fn value_and_gradient(&self, dose: &HostField, grad: &mut HostField) -> f64 {
        assert_eq!(dose.len(), grad.len(), "fields of different length");
        if self.0.elements.len() < grad.len() {
            grad.fill(0.0);
        }
        let blocks = dose.lanes()[self.0.groups()]
            .chunks(GROUPS)
            .zip(grad.lanes_mut()[self.0.groups()].chunks_mut(GROUPS))
            .enumerate();
        let sums = blocks.par_map(|(b, (dose, grad))| {
            let chunks = dose.chunks(CHUNK).zip(grad.chunks_mut(CHUNK)).enumerate();
            let sum =
                chunks.map(|(c, (dose, grad))| self.0.chunk(b * GROUPS + c * CHUNK, dose, grad));
            sum.sum()
        });
        self.0.finish(sums.iter().sum(), grad)
    }

    fn slope_along(&self, dose: &HostField, step: &HostField, alpha: f32) -> (f64, f64) {
        assert_eq!(dose.len(), step.len(), "fields of different length");
        let sums: Vec<(f64, f64)> = dose.lanes()[self.0.groups()]
            .chunks(GROUPS)
            .zip(step.lanes()[self.0.groups()].chunks(GROUPS))
            .enumerate()
            .par_map(|(b, (dose, step))| {
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
            });
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
            .chunks_mut(GROUPS)
            .zip(step.lanes_mut()[self.0.groups()].chunks_mut(GROUPS))
            .enumerate();
        let sums = blocks.par_map(|(b, (dose, step))| {
            let chunks = dose
                .chunks_mut(CHUNK)
                .zip(step.chunks_mut(CHUNK))
                .enumerate();
            let sum = chunks.map(|(c, (dose, step))| {
                move_by(dose, step, alpha);
                self.0.chunk(b * GROUPS + c * CHUNK, dose, step)
            });
            sum.sum()
        });
        self.0.finish(sums.iter().sum(), step)
    }
}

impl BandLoss {
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
