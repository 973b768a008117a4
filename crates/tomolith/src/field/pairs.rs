//! Pairs of steps and gradient changes, and the two passes over them that a quasi-Newton method needs.
//!
//! A pair is (s, y): the change of x in a step, and that of the gradient where x moved (y is 0 elsewhere, so a pair knows the
//! curvature of the face it was taken on). On the host both are stored in 16 bits (bf16, rounded to nearest): what is rounded
//! is the *memory* of curvature, the products are those of the rounded pairs, and trials showed the same convergence as f32 to
//! within the difference of one iteration; it halves the bytes that such a method is bound by.
//!
//! **Layout** Blocks of the [`Bounds`], in each chunks of 512 elements, in each the slots one after the other, in each one cache
//! line per 16 elements: 16 s and 16 y. A bit per slot and 16 elements tells whether the line holds anything but zeros: pixels
//! that the bounds have held since long cost nothing.
//!
//! **Cost** per element with m pairs: [`record`](Pairs::record) reads 16 + 4(m − 1) bytes and writes 4;
//! [`direction`](Pairs::direction) reads 8 + 4m and writes 4. Memory: 4m bytes per element, as m pattern fields.

use super::{Bounds, HostField, LANES};
use crate::error::Result;
use rayon::prelude::*;
use std::borrow::Cow;

/// What [`Pairs::record`] looks at: the newest step, from x − α·step to x.
pub struct Latest<'a, F> {
    /// Place x after the step.
    pub x: &'a F,
    /// Direction of the step.
    pub step: &'a F,
    /// α, how far it was followed.
    pub alpha: f32,
    /// Gradient before the step.
    pub before: &'a F,
    /// Gradient after the step.
    pub after: &'a F,
}

/// Products of every slot j with the newest pair (s, y) and with the free gradient g: the gradient of the pixels that the
/// bounds do not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Products {
    /// s_j·y
    pub s_y: Vec<f64>,
    /// y_j·y
    pub y_y: Vec<f64>,
    /// s_j·g
    pub s_g: Vec<f64>,
    /// y_j·g
    pub y_g: Vec<f64>,
    /// s·s of the newest pair.
    pub s_s: f64,
}

/// A direction d = −scale·g + Σ_j (s_j·along_s + y_j·along_y) over the free pixels, g the free gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct Direction {
    /// Factor of the gradient.
    pub scale: f32,
    /// Factors of the s_j, 0 for slots not in use.
    pub along_s: Vec<f32>,
    /// Factors of the y_j, 0 for slots not in use.
    pub along_y: Vec<f32>,
    /// How much further than d the feasible segment should reach.
    pub stretch: f32,
}

/// Sums over a direction brought into the bounds, and over the projected gradient step of length `scale` beside it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DirectionSums {
    /// g·p of p = P(x + stretch·d) − x
    pub slope: f64,
    /// p·p
    pub square: f64,
    /// g·r of r = P(x − scale·g) − x
    pub gradient_slope: f64,
    /// r·r
    pub gradient_square: f64,
}

/// The memory of a quasi-Newton method: a fixed number of slots, each for one pair.
pub trait Pairs<F>: Send + Sync + Sized {
    /// Empty slots for fields with these bounds; at most [`MAX_MEMORY`](Self::MAX_MEMORY).
    fn new(slots: usize, bounds: &Bounds) -> Self;
    /// Largest number of slots.
    const MAX_MEMORY: usize = 30;
    /// Writes the newest pair into a slot, and takes all products in the same pass.
    fn record(&mut self, slot: usize, latest: &Latest<F>, bounds: &Bounds) -> Products;
    /// out ← P(x + stretch·d) − x
    fn direction(
        &self,
        direction: &Direction,
        x: &F,
        gradient: &F,
        bounds: &Bounds,
        out: &mut F,
    ) -> DirectionSums;
    /// Names and bytes of what is stored, for a checkpoint.
    fn parts(&self) -> Vec<(&'static str, Cow<'_, [u8]>)>;
    /// Takes back what [`parts`](Self::parts) gave; `read` fills a buffer with the part of a name.
    ///
    /// # Errors
    /// Those of `read`.
    fn restore(&mut self, read: &mut dyn FnMut(&str, &mut [u8]) -> Result<()>) -> Result<()>;
}

/// Groups of sixteen per chunk: what a chunk needs stays in the first cache.
const CHUNK: usize = 32;

/// Sixteen s and sixteen y, in bf16: one cache line.
#[derive(Clone, Copy, Debug, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(64))]
struct Line {
    s: [u16; LANES],
    y: [u16; LANES],
}

type Group = [f32; LANES];

/// [`Pairs`] in host memory.
#[derive(Clone, Debug)]
pub struct HostPairs {
    slots: usize,
    /// `[chunk][slot][group]`, the chunks of all blocks
    lines: Vec<Line>,
    /// Per group a bit per slot: the line holds something. Lines of cleared bits are stale.
    live: Vec<u32>,
    /// Chunks of each block.
    chunks: Vec<usize>,
}

/// bf16 nearest to a number; ties to even.
#[inline(always)]
fn rounded(value: f32) -> u16 {
    let bits = value.to_bits();
    #[expect(clippy::cast_possible_truncation, reason = "16 bits are left")]
    let upper = (bits.wrapping_add(0x7fff + ((bits >> 16) & 1)) >> 16) as u16;
    upper
}

#[inline(always)]
fn widened(value: u16) -> f32 {
    f32::from_bits(u32::from(value) << 16)
}

/// Σ aᵢ·bᵢ onto eight running sums.
#[inline(always)]
fn add_products(sums: &mut [f32; 8], a: &Group, b: &Group) {
    for i in 0..8 {
        sums[i] += a[i] * b[i];
    }
    for i in 0..8 {
        sums[i] += a[i + 8] * b[i + 8];
    }
}

fn total(sums: &[f32; 8]) -> f64 {
    sums.iter().map(|&v| f64::from(v)).sum()
}

/// Whether the bounds hold a pixel: it is at one, and descending would cross it.
#[inline(always)]
fn is_held(x: f32, gradient: f32, lower: f32, upper: f32) -> bool {
    (x <= lower && gradient >= 0.0) | (x >= upper && gradient <= 0.0)
}

/// A field's group `i`, filled up with zeros at the end of a block.
#[inline(always)]
fn group(values: &[f32], i: usize) -> Group {
    let begin = i * LANES;
    match values.get(begin..begin + LANES) {
        Some(full) => std::array::from_fn(|i| full[i]),
        None => std::array::from_fn(|i| values.get(begin + i).copied().unwrap_or(0.0)),
    }
}

impl Products {
    fn zeros(slots: usize) -> Self {
        let zeros = vec![0.0; slots];
        Products {
            s_y: zeros.clone(),
            y_y: zeros.clone(),
            s_g: zeros.clone(),
            y_g: zeros,
            s_s: 0.0,
        }
    }

    fn add(&mut self, other: &Products) {
        for (mine, other) in [
            (&mut self.s_y, &other.s_y),
            (&mut self.y_y, &other.y_y),
            (&mut self.s_g, &other.s_g),
            (&mut self.y_g, &other.y_g),
        ] {
            mine.iter_mut().zip(other).for_each(|(a, b)| *a += b);
        }
        self.s_s += other.s_s;
    }
}

/// The fields of one block.
struct LatestBlock<'a> {
    x: &'a [f32],
    step: &'a [f32],
    before: &'a [f32],
    after: &'a [f32],
    alpha: f32,
    lower: f32,
    upper: f32,
}

/// The pairs of one block of the bounds.
struct BlockMut<'a> {
    slots: usize,
    lines: &'a mut [Line],
    live: &'a mut [u32],
}

/// The pairs of one block of the bounds.
struct BlockRef<'a> {
    slots: usize,
    lines: &'a [Line],
    live: &'a [u32],
}

impl HostPairs {
    fn blocks_mut(&mut self) -> Vec<BlockMut<'_>> {
        let slots = self.slots;
        let (mut lines, mut live) = (&mut self.lines[..], &mut self.live[..]);
        let block = |&chunks: &usize| BlockMut {
            slots,
            lines: lines
                .split_off_mut(..chunks * slots * CHUNK)
                .unwrap_or_default(),
            live: live.split_off_mut(..chunks * CHUNK).unwrap_or_default(),
        };
        self.chunks.iter().map(block).collect()
    }

    fn blocks(&self) -> Vec<BlockRef<'_>> {
        let slots = self.slots;
        let (mut lines, mut live) = (&self.lines[..], &self.live[..]);
        let block = |&chunks: &usize| BlockRef {
            slots,
            lines: lines
                .split_off(..chunks * slots * CHUNK)
                .unwrap_or_default(),
            live: live.split_off(..chunks * CHUNK).unwrap_or_default(),
        };
        self.chunks.iter().map(block).collect()
    }
}

impl BlockMut<'_> {
    fn record(self, slot: usize, fields: &LatestBlock) -> Products {
        let slots = self.slots;
        let mut products = Products::zeros(slots);
        let chunks = self
            .lines
            .chunks_mut(slots * CHUNK)
            .zip(self.live.chunks_mut(CHUNK));
        for (chunk, (lines, live)) in chunks.enumerate() {
            let mut y = [Group::default(); CHUNK];
            let mut free = [Group::default(); CHUNK];
            let mut busy = 0u32;
            for g in 0..CHUNK {
                let at = chunk * CHUNK + g;
                if at * LANES >= fields.x.len() {
                    break;
                }
                let line = &mut lines[slot * CHUNK + g];
                let (moved, s_s) = fields.newest(at, line, &mut y[g], &mut free[g]);
                products.s_s += f64::from(s_s);
                live[g] = if moved {
                    live[g] | 1 << slot
                } else {
                    live[g] & !(1 << slot)
                };
                let gradient = free[g].iter().fold(0, |bits, v| bits | v.to_bits() << 1) != 0;
                busy |= u32::from(moved | gradient) << g;
            }
            for (slot, lines) in lines.chunks(CHUNK).enumerate() {
                let mut sums = [[0.0f32; 8]; 4];
                for g in 0..CHUNK {
                    if busy >> g & live[g] >> slot & 1 == 0 {
                        continue;
                    }
                    let old_s = lines[g].s.map(widened);
                    let old_y = lines[g].y.map(widened);
                    add_products(&mut sums[0], &old_s, &y[g]);
                    add_products(&mut sums[1], &old_y, &y[g]);
                    add_products(&mut sums[2], &old_s, &free[g]);
                    add_products(&mut sums[3], &old_y, &free[g]);
                }
                products.s_y[slot] += total(&sums[0]);
                products.y_y[slot] += total(&sums[1]);
                products.s_g[slot] += total(&sums[2]);
                products.y_g[slot] += total(&sums[3]);
            }
        }
        products
    }
}

impl BlockRef<'_> {
    fn direction(
        self,
        direction: &Direction,
        fields: &DirectionBlock,
        out: &mut [f32],
    ) -> DirectionSums {
        let slots = self.slots;
        let mut sums = DirectionSums::default();
        let chunks = self
            .lines
            .chunks(slots * CHUNK)
            .zip(self.live.chunks(CHUNK));
        for (chunk, (lines, live)) in chunks.enumerate() {
            let mut partial = [[0.0f32; 8]; 4];
            for g in 0..CHUNK {
                let at = chunk * CHUNK + g;
                if at * LANES >= out.len() {
                    break;
                }
                let end = out.len().min((at + 1) * LANES);
                let out = &mut out[at * LANES..end];
                let x = group(fields.x, at);
                let gradient = group(fields.gradient, at);
                let held: [bool; LANES] =
                    std::array::from_fn(|i| is_held(x[i], gradient[i], fields.lower, fields.upper));
                if held.iter().all(|&h| h) {
                    out.fill(0.0);
                    continue;
                }
                let mut d: Group = gradient.map(|g| -direction.scale * g);
                let projected: Group = std::array::from_fn(|i| {
                    super::clamp(x[i] + d[i], fields.lower, fields.upper) - x[i]
                });
                for slot in 0..slots {
                    if live[g] >> slot & 1 == 0 {
                        continue;
                    }
                    let line = &lines[slot * CHUNK + g];
                    let (a, b) = (direction.along_s[slot], direction.along_y[slot]);
                    for i in 0..LANES {
                        d[i] += a * widened(line.s[i]) + b * widened(line.y[i]);
                    }
                }
                let step: Group = std::array::from_fn(|i| {
                    let end =
                        super::clamp(x[i] + direction.stretch * d[i], fields.lower, fields.upper);
                    if held[i] { 0.0 } else { end - x[i] }
                });
                out.copy_from_slice(&step[..out.len()]);
                add_products(&mut partial[0], &gradient, &step);
                add_products(&mut partial[1], &step, &step);
                add_products(&mut partial[2], &gradient, &projected);
                add_products(&mut partial[3], &projected, &projected);
            }
            sums.slope += total(&partial[0]);
            sums.square += total(&partial[1]);
            sums.gradient_slope += total(&partial[2]);
            sums.gradient_square += total(&partial[3]);
        }
        sums
    }
}

impl LatestBlock<'_> {
    /// Writes group `at` of the newest pair, as stored, into `line` and `y`, and the free gradient into `free`. Returns whether
    /// anything moved, and s·s.
    #[inline(always)]
    fn newest(&self, at: usize, line: &mut Line, y: &mut Group, free: &mut Group) -> (bool, f32) {
        let x = group(self.x, at);
        let after = group(self.after, at);
        for i in 0..LANES {
            let held = is_held(x[i], after[i], self.lower, self.upper);
            free[i] = if held { 0.0 } else { after[i] };
        }
        let step = group(self.step, at);
        let s = step.map(|v| rounded(self.alpha * v));
        // Without the sign: −0 is no move either
        if s.iter().fold(0, |bits, v| bits | v << 1) == 0 {
            return (false, 0.0);
        }
        let before = group(self.before, at);
        let change: [u16; LANES] = std::array::from_fn(|i| {
            if step[i] == 0.0 {
                0
            } else {
                rounded(after[i] - before[i])
            }
        });
        *line = Line { s, y: change };
        *y = change.map(widened);
        let s = s.map(widened);
        let mut sums = [0.0; 8];
        add_products(&mut sums, &s, &s);
        (true, sums.iter().sum())
    }
}

/// The fields of one block.
struct DirectionBlock<'a> {
    x: &'a [f32],
    gradient: &'a [f32],
    lower: f32,
    upper: f32,
}

impl Pairs<HostField> for HostPairs {
    fn new(slots: usize, bounds: &Bounds) -> Self {
        assert!(
            slots <= <Self as Pairs<HostField>>::MAX_MEMORY,
            "more slots than bits"
        );
        let chunks: Vec<usize> = bounds
            .blocks
            .iter()
            .map(|b| b.len.div_ceil(LANES).div_ceil(CHUNK))
            .collect();
        let all: usize = chunks.iter().sum();
        HostPairs {
            slots,
            lines: vec![Line::default(); all * slots * CHUNK],
            live: vec![0; all * CHUNK],
            chunks,
        }
    }

    fn record(&mut self, slot: usize, latest: &Latest<HostField>, bounds: &Bounds) -> Products {
        let slots = self.slots;
        let products: Vec<Products> = self
            .blocks_mut()
            .into_par_iter()
            .zip(&bounds.blocks)
            .zip(bounds.split(latest.x.as_slice()))
            .zip(bounds.split(latest.step.as_slice()))
            .zip(bounds.split(latest.before.as_slice()))
            .zip(bounds.split(latest.after.as_slice()))
            .map(|(((((block, bounds), x), step), before), after)| {
                let (alpha, lower, upper) = (latest.alpha, bounds.lower, bounds.upper);
                block.record(
                    slot,
                    &LatestBlock {
                        x,
                        step,
                        before,
                        after,
                        alpha,
                        lower,
                        upper,
                    },
                )
            })
            .collect();
        products
            .iter()
            .fold(Products::zeros(slots), |mut sum, block| {
                sum.add(block);
                sum
            })
    }

    fn direction(
        &self,
        direction: &Direction,
        x: &HostField,
        gradient: &HostField,
        bounds: &Bounds,
        out: &mut HostField,
    ) -> DirectionSums {
        let sums: Vec<DirectionSums> = self
            .blocks()
            .into_par_iter()
            .zip(&bounds.blocks)
            .zip(bounds.split(x.as_slice()))
            .zip(bounds.split(gradient.as_slice()))
            .zip(bounds.split_mut(out.as_mut_slice()))
            .map(|((((block, bounds), x), gradient), out)| {
                let (lower, upper) = (bounds.lower, bounds.upper);
                block.direction(
                    direction,
                    &DirectionBlock {
                        x,
                        gradient,
                        lower,
                        upper,
                    },
                    out,
                )
            })
            .collect();
        sums.iter()
            .fold(DirectionSums::default(), |a, b| DirectionSums {
                slope: a.slope + b.slope,
                square: a.square + b.square,
                gradient_slope: a.gradient_slope + b.gradient_slope,
                gradient_square: a.gradient_square + b.gradient_square,
            })
    }

    fn parts(&self) -> Vec<(&'static str, Cow<'_, [u8]>)> {
        vec![
            ("pairs", Cow::Borrowed(bytemuck::cast_slice(&self.lines))),
            ("live", Cow::Borrowed(bytemuck::cast_slice(&self.live))),
        ]
    }

    fn restore(&mut self, read: &mut dyn FnMut(&str, &mut [u8]) -> Result<()>) -> Result<()> {
        read("pairs", bytemuck::cast_slice_mut(&mut self.lines))?;
        read("live", bytemuck::cast_slice_mut(&mut self.live))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Field;

    /// Numbers between −1 and 1 that look random.
    fn noise(len: usize, seed: u32) -> HostField {
        let mut state = seed.wrapping_mul(747_796_405) | 1;
        let values: Vec<f32> = (0..len)
            .map(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (state >> 8) as f32 / 8_388_608.0 - 1.0
            })
            .collect();
        HostField::from_slice(&values)
    }

    #[test]
    fn rounding_goes_to_the_nearest_sixteen_bits() {
        for value in [0.0, -0.0, 1.0, -2.5, 3.141_592_7, 1e-30, -7e20] {
            let back = widened(rounded(value));
            assert!(
                (back - value).abs() <= value.abs() / 256.0,
                "{value} became {back}"
            );
        }
        // Halfway between 1 and 1 + 2⁻⁷: to even
        assert_eq!(widened(rounded(1.0 + 2f32.powi(-8))), 1.0);
        assert_eq!(
            widened(rounded(1.0 + 3.0 * 2f32.powi(-8))),
            1.0 + 2f32.powi(-6)
        );
    }

    /// Both passes against sums written down one element at a time; two lights, lengths that are no multiples of anything.
    #[test]
    fn both_passes_agree_with_plain_sums() {
        let lens = [70_003usize, 1_017];
        let len = lens[0] + lens[1];
        let bounds = Bounds::of_pieces([(lens[0], 0.0, 0.8), (lens[1], 0.1, 0.5)]);
        let limits = |i: usize| if i < lens[0] { (0.0, 0.8) } else { (0.1, 0.5) };
        let slots = 3;
        let mut pairs = HostPairs::new(slots, &bounds);
        let (mut kept_s, mut kept_y) = (
            vec![vec![0.0f64; len]; slots],
            vec![vec![0.0f64; len]; slots],
        );
        let mut products = Products::zeros(slots);
        let (mut x, mut free) = (HostField::zeros(len), vec![0.0f64; len]);
        let mut gradient = HostField::zeros(len);
        for round in 0..5u32 {
            x = noise(len, round + 1);
            let zero = x.zeros_like();
            x.move_along(&zero, 0.0, &bounds);
            let mut step = noise(len, round + 11);
            for (i, v) in step.as_mut_slice().iter_mut().enumerate() {
                // Long stretches that do not move
                if (i / 40 + round as usize) % 3 == 0 {
                    *v = 0.0;
                }
            }
            let (before, after) = (noise(len, round + 21), noise(len, round + 31));
            let slot = round as usize % slots;
            let latest = Latest {
                x: &x,
                step: &step,
                alpha: 0.7,
                before: &before,
                after: &after,
            };
            products = pairs.record(slot, &latest, &bounds);
            for i in 0..len {
                let (x, step) = (x.as_slice()[i], step.as_slice()[i]);
                let (before, after) = (before.as_slice()[i], after.as_slice()[i]);
                kept_s[slot][i] = f64::from(widened(rounded(0.7 * step)));
                kept_y[slot][i] = if step == 0.0 {
                    0.0
                } else {
                    f64::from(widened(rounded(after - before)))
                };
                let (lower, upper) = limits(i);
                free[i] = if is_held(x, after, lower, upper) {
                    0.0
                } else {
                    f64::from(after)
                };
            }
            gradient = after;
        }
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let newest = 4 % slots;
        let tolerance = 1e-5 * len as f64;
        for j in 0..slots {
            for (found, expected) in [
                (products.s_y[j], dot(&kept_s[j], &kept_y[newest])),
                (products.y_y[j], dot(&kept_y[j], &kept_y[newest])),
                (products.s_g[j], dot(&kept_s[j], &free)),
                (products.y_g[j], dot(&kept_y[j], &free)),
            ] {
                assert!(
                    (found - expected).abs() < tolerance,
                    "slot {j}: {found} instead of {expected}"
                );
            }
        }
        assert!((products.s_s - dot(&kept_s[newest], &kept_s[newest])).abs() < tolerance);

        let direction = Direction {
            scale: 0.3,
            along_s: vec![0.5, -0.2, 0.1],
            along_y: vec![0.05, 0.1, -0.3],
            stretch: 1.5,
        };
        let mut out = x.zeros_like();
        let sums = pairs.direction(&direction, &x, &gradient, &bounds, &mut out);
        let mut slope = 0.0;
        for i in 0..len {
            let (lower, upper) = limits(i);
            let (x, g) = (x.as_slice()[i], gradient.as_slice()[i]);
            let mut d = -0.3 * f64::from(g);
            for j in 0..slots {
                d += f64::from(direction.along_s[j]) * kept_s[j][i]
                    + f64::from(direction.along_y[j]) * kept_y[j][i];
            }
            let end =
                (f64::from(x) + 1.5 * d).clamp(f64::from(lower), f64::from(upper)) - f64::from(x);
            let expected = if is_held(x, g, lower, upper) {
                0.0
            } else {
                end
            };
            let found = f64::from(out.as_slice()[i]);
            assert!(
                (found - expected).abs() < 1e-5,
                "element {i}: {found} instead of {expected}"
            );
            slope += expected * f64::from(g);
        }
        assert!((sums.slope - slope).abs() < tolerance);

        let mut copy = HostPairs::new(slots, &bounds);
        let parts = pairs.parts();
        let mut read = |name: &str, bytes: &mut [u8]| {
            let (_, part) = parts.iter().find(|(part, _)| *part == name).unwrap();
            bytes.copy_from_slice(part);
            Ok(())
        };
        copy.restore(&mut read).unwrap();
        let mut again = x.zeros_like();
        assert_eq!(
            copy.direction(&direction, &x, &gradient, &bounds, &mut again),
            sums
        );
        assert_eq!(again.as_slice(), out.as_slice());
    }
}
