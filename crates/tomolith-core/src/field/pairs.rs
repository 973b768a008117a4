//! Pairs of steps and gradient changes, and the two passes over them that a quasi-Newton method needs.
//!
//! A pair is (s, z): the change s of x in a step, and z = P·y, where y is the change of the gradient where x moved (y is 0 elsewhere, so a
//! pair knows the curvature of the face it was taken on) and P a symmetric positive matrix, the method's first guess of the inverse
//! curvature ([`half_ramp`](super::half_ramp)). y itself is needed only while its pair is the newest. On the host both are stored in 16 bits (bf16, rounded to nearest): what is rounded
//! is the *memory* of curvature, the products are those of the rounded pairs, and trials showed the same convergence as f32 to
//! within the difference of one iteration; it halves the bytes that such a method is bound by.
//!
//! **Layout** Blocks of the [`Bounds`], in each groups of 16 elements, in each a cache line per slot: 16 s and 16 z. So a
//! pass is one stream through memory, whatever the number of slots. A bit per slot and group tells whether the line holds
//! anything but zeros: stretches that the bounds have held since long cost nothing.
//!
//! **Cost** per element with m pairs: [`record`](Pairs::record) reads 20 + 4(m − 1) bytes and writes 4;
//! [`direction`](Pairs::direction) reads 12 + 4m and writes 4. Memory: 4m bytes per element, as m pattern fields.

use super::group::{Group, total};
use super::{Bounds, Field, HostField, LANES};
use crate::error::Result;
use crate::parallel::InParallel;
use std::borrow::Cow;
use wide::{f32x8, u32x8};

/// What [`Pairs::record`] looks at: the newest step, from x − α·step to x.
pub struct Latest<'a, F> {
    /// Place x after the step.
    pub x: &'a F,
    /// Direction of the step.
    pub step: &'a F,
    /// α, how far it was followed.
    pub alpha: f32,
    /// Gradient after the step.
    pub gradient: &'a F,
    /// y, how the gradient changed where x moved.
    pub change: &'a F,
    /// z = P·y
    pub image: &'a F,
}

/// Products of every slot j with the newest s and y, and with the free gradient g: the gradient of the pixels that the bounds do not
/// hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Products {
    /// s_j·y
    pub s_y: Vec<f64>,
    /// z_j·y
    pub z_y: Vec<f64>,
    /// s_j·g
    pub s_g: Vec<f64>,
    /// z_j·g
    pub z_g: Vec<f64>,
    /// s·s of the newest pair.
    pub s_s: f64,
    /// y·y of the newest pair.
    pub y_y: f64,
}

/// A direction d = −scale·P·g + Σ_j (s_j·along_s + z_j·along_z) over the free pixels, g the free gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct Direction {
    /// Factor of P·g.
    pub scale: f32,
    /// Length of the projected gradient step with which the direction is compared.
    pub length: f32,
    /// Factors of the s_j, 0 for slots not in use.
    pub along_s: Vec<f32>,
    /// Factors of the z_j, 0 for slots not in use.
    pub along_z: Vec<f32>,
    /// How much further than d the feasible segment should reach.
    pub stretch: f32,
}

/// Sums over a direction brought into the bounds, and over the projected gradient step of its length.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DirectionSums {
    /// g·p of p = clip(x + stretch·d) − x, `clip` bringing into the bounds
    pub slope: f64,
    /// p·p
    pub square: f64,
    /// g·r of r = clip(x − length·g) − x
    pub gradient_slope: f64,
    /// r·r
    pub gradient_square: f64,
}

/// A part of what [`Pairs`] store.
pub struct PairsPart<'a> {
    /// Its name.
    pub name: &'static str,
    /// How many bytes.
    pub len: usize,
    /// The bytes, fetched on first use.
    pub bytes: Box<dyn Fn() -> Cow<'a, [u8]> + 'a>,
}

impl<'a> PairsPart<'a> {
    /// Bytes that are at hand.
    fn of(name: &'static str, bytes: &'a [u8]) -> Self {
        PairsPart {
            name,
            len: bytes.len(),
            bytes: Box::new(move || Cow::Borrowed(bytes)),
        }
    }
}

/// The memory of a quasi-Newton method: a fixed number of slots, each for one pair.
pub trait Pairs<F: Field>: Send + Sync + Sized {
    /// Empty slots for fields with these bounds; at most [`MAX_MEMORY`](Self::MAX_MEMORY).
    fn new(slots: usize, bounds: &F::Bounds) -> Self;
    /// Largest number of slots.
    const MAX_MEMORY: usize;
    /// Writes the newest pair into a slot, and takes all products in the same pass.
    fn record(&mut self, slot: usize, latest: &Latest<F>, bounds: &F::Bounds) -> Products;
    /// out ← clip(x + stretch·d) − x, brought into the bounds; `image` is P·g of the free gradient.
    fn direction(
        &self,
        direction: &Direction,
        x: &F,
        gradient: &F,
        image: &F,
        bounds: &F::Bounds,
        out: &mut F,
    ) -> DirectionSums;
    /// What is stored, for a checkpoint.
    fn parts(&self) -> Vec<PairsPart<'_>>;
    /// Takes back what [`parts`](Self::parts) gave; `read` fills a buffer with the part of a name.
    ///
    /// # Errors
    /// Those of `read`.
    fn restore(&mut self, read: &mut dyn FnMut(&str, &mut [u8]) -> Result<()>) -> Result<()>;
}

/// A bit per slot in a word.
const MAX_SLOTS: usize = 30;

/// Groups of sixteen per chunk: what a chunk needs stays in the first cache.
const CHUNK: usize = 32;

/// Sixteen s and sixteen z, in bf16: one cache line.
#[derive(Clone, Copy, Debug, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(64))]
struct Line {
    s: Packed,
    z: Packed,
}

/// Sixteen numbers in bf16: word i holds number i in its lower half and number i + 8 in its upper one, so that packing and
/// unpacking are shifts and masks of whole words.
type Packed = [u32; 8];

/// [`Pairs`] in host memory.
#[derive(Clone, Debug)]
pub struct HostPairs {
    slots: usize,
    /// `[chunk][group][slot]`, the chunks of all blocks
    lines: Vec<Line>,
    /// Per group a bit per slot: the line holds something. Lines of cleared bits are stale.
    live: Vec<u32>,
    /// Chunks of each block.
    chunks: Vec<usize>,
}

/// Rounds to the nearest bf16, ties to even; in the upper half of each word, rubbish in the lower one.
#[inline(always)]
fn rounded(values: f32x8) -> u32x8 {
    let bits: u32x8 = bytemuck::cast(values);
    bits + u32x8::splat(0x7fff) + ((bits >> 16u32) & u32x8::splat(1))
}

const UPPER: u32 = 0xffff_0000;

#[inline(always)]
fn packed(values: Group) -> Packed {
    let [lower, upper] = values.0.map(rounded);
    ((lower >> 16u32) | (upper & u32x8::splat(UPPER))).to_array()
}

#[inline(always)]
fn unpacked(words: &Packed) -> Group {
    let words = u32x8::from(*words);
    Group([
        bytemuck::cast(words << 16u32),
        bytemuck::cast(words & u32x8::splat(UPPER)),
    ])
}

/// Lower and upper bound of the pixels of a block.
#[derive(Clone, Copy)]
struct Limits {
    lower: f32x8,
    upper: f32x8,
}

impl Limits {
    fn new(lower: f32, upper: f32) -> Self {
        Limits {
            lower: f32x8::splat(lower),
            upper: f32x8::splat(upper),
        }
    }

    /// All bits where the bounds hold a pixel: it is at one, and descending would cross it.
    #[inline(always)]
    fn holds(self, x: f32x8, gradient: f32x8) -> f32x8 {
        let zero = f32x8::ZERO;
        (x.simd_le(self.lower) & gradient.simd_ge(zero))
            | (x.simd_ge(self.upper) & gradient.simd_le(zero))
    }

    /// Brings into the bounds; a NaN stays one.
    #[inline(always)]
    fn clamp(self, x: f32x8) -> f32x8 {
        let x = x.simd_lt(self.lower).bitselect(self.lower, x);
        x.simd_gt(self.upper).bitselect(self.upper, x)
    }
}

/// The numbers where a mask has no bits, 0 where it has all.
#[inline(always)]
fn without(values: f32x8, mask: f32x8) -> f32x8 {
    mask.bitselect(f32x8::ZERO, values)
}

/// The elements of a block in groups of sixteen, the last filled up with zeros.
struct Groups<'a> {
    full: &'a [[f32; LANES]],
    last: [f32; LANES],
}

impl<'a> Groups<'a> {
    fn of(values: &'a [f32]) -> Self {
        let (full, rest) = values.as_chunks::<LANES>();
        let mut last = [0.0; LANES];
        last[..rest.len()].copy_from_slice(rest);
        Groups { full, last }
    }

    #[inline(always)]
    fn at(&self, i: usize) -> Group {
        Group::of(self.full.get(i).unwrap_or(&self.last))
    }
}

impl Products {
    fn zeros(slots: usize) -> Self {
        let zeros = vec![0.0; slots];
        Products {
            s_y: zeros.clone(),
            z_y: zeros.clone(),
            s_g: zeros.clone(),
            z_g: zeros,
            s_s: 0.0,
            y_y: 0.0,
        }
    }

    fn add(&mut self, other: &Products) {
        for (mine, other) in [
            (&mut self.s_y, &other.s_y),
            (&mut self.z_y, &other.z_y),
            (&mut self.s_g, &other.s_g),
            (&mut self.z_g, &other.z_g),
        ] {
            mine.iter_mut().zip(other).for_each(|(a, b)| *a += b);
        }
        self.s_s += other.s_s;
        self.y_y += other.y_y;
    }

    /// Those of all ranks that have a share of a field.
    fn of_all_ranks(mut self, share: &HostField) -> Self {
        let mut lists = [&mut self.s_y, &mut self.z_y, &mut self.s_g, &mut self.z_g];
        let mut sums = lists.each_ref().map(|list| list.as_slice()).concat();
        sums.extend([self.s_s, self.y_y]);
        share.add_up(&mut sums);
        let slots = lists[0].len();
        for (list, sums) in lists.iter_mut().zip(sums.chunks(slots.max(1))) {
            list.copy_from_slice(&sums[..slots]);
        }
        [self.s_s, self.y_y] = [sums[4 * slots], sums[4 * slots + 1]];
        self
    }
}

/// The pairs of one block of the bounds.
struct Block<L, A> {
    slots: usize,
    lines: L,
    live: A,
}

impl HostPairs {
    fn blocks_mut(&mut self) -> impl Iterator<Item = Block<&mut [Line], &mut [u32]>> {
        let slots = self.slots;
        let (mut lines, mut live) = (&mut self.lines[..], &mut self.live[..]);
        self.chunks.iter().map(move |chunks| {
            let of_lines = chunks * slots * CHUNK;
            Block {
                slots,
                lines: lines.split_off_mut(..of_lines).unwrap_or_default(),
                live: live.split_off_mut(..chunks * CHUNK).unwrap_or_default(),
            }
        })
    }

    fn blocks(&self) -> impl Iterator<Item = Block<&[Line], &[u32]>> {
        let (slots, mut begin) = (self.slots, 0);
        self.chunks.iter().map(move |chunks| {
            let range = begin * CHUNK..(begin + chunks) * CHUNK;
            begin += chunks;
            Block {
                slots,
                lines: &self.lines[range.start * slots..range.end * slots],
                live: &self.live[range],
            }
        })
    }
}

/// What [`Pairs::record`] looks at, in one block.
struct LatestBlock<'a> {
    x: Groups<'a>,
    step: Groups<'a>,
    gradient: Groups<'a>,
    change: Groups<'a>,
    image: Groups<'a>,
    alpha: f32x8,
    bounds: Limits,
}

/// The newest pair in a group.
struct Newest {
    /// Whether there is anything to store.
    any: bool,
    y: Group,
    /// The gradient of the free pixels.
    free: Group,
    s_s: f32x8,
    y_y: f32x8,
}

impl LatestBlock<'_> {
    /// Group `at` of the newest pair, written to `line` unless it is nothing but zeros.
    #[inline(always)]
    fn newest(&self, at: usize, line: &mut Line) -> Newest {
        let (x, gradient, step) = (self.x.at(at), self.gradient.at(at), self.step.at(at));
        let free = x.zip(gradient, |x, g| without(g, self.bounds.holds(x, g)));
        let (y, z) = (self.change.at(at), self.image.at(at));
        let s = step.map(|v| self.alpha * v);
        // −0 is stored as 0 would be, and a NaN is not lost
        let any = s.any_bits() || z.any_bits();
        if any {
            line.s = packed(s);
            line.z = packed(z);
        }
        let s = unpacked(&line.s);
        Newest {
            any,
            y,
            free,
            s_s: if any { s.products(s) } else { f32x8::ZERO },
            y_y: y.products(y),
        }
    }
}

impl Block<&mut [Line], &mut [u32]> {
    fn record(self, len: usize, slot: usize, fields: &LatestBlock) -> Products {
        let slots = self.slots;
        let groups = len.div_ceil(LANES);
        let mut products = Products::zeros(slots);
        let chunks = self
            .lines
            .chunks_mut(slots * CHUNK)
            .zip(self.live.chunks_mut(CHUNK));
        for (chunk, (lines, live)) in chunks.enumerate() {
            let mut sums = [[f32x8::ZERO; 4]; MAX_SLOTS];
            let (mut s_s, mut y_y) = (f32x8::ZERO, f32x8::ZERO);
            for g in 0..CHUNK.min(groups - chunk * CHUNK) {
                let lines = &mut lines[g * slots..][..slots];
                let newest = fields.newest(chunk * CHUNK + g, &mut lines[slot]);
                s_s += newest.s_s;
                y_y += newest.y_y;
                live[g] = live[g] & !(1 << slot) | u32::from(newest.any) << slot;
                if !newest.y.any_bits() && !newest.free.any_bits() {
                    continue;
                }
                for (slot, (line, [s_y, z_y, s_g, z_g])) in lines.iter().zip(&mut sums).enumerate()
                {
                    if live[g] >> slot & 1 != 0 {
                        let (s, z) = (unpacked(&line.s), unpacked(&line.z));
                        *s_y += s.products(newest.y);
                        *z_y += z.products(newest.y);
                        *s_g += s.products(newest.free);
                        *z_g += z.products(newest.free);
                    }
                }
            }
            products.s_s += total(s_s);
            products.y_y += total(y_y);
            for (slot, sums) in sums[..slots].iter().enumerate() {
                let [s_y, z_y, s_g, z_g] = sums.map(total);
                products.s_y[slot] += s_y;
                products.z_y[slot] += z_y;
                products.s_g[slot] += s_g;
                products.z_g[slot] += z_g;
            }
        }
        products
    }
}

/// Where [`Pairs::direction`] starts from, in one block.
struct DirectionBlock<'a> {
    x: Groups<'a>,
    gradient: Groups<'a>,
    image: Groups<'a>,
    bounds: Limits,
}

impl DirectionBlock<'_> {
    /// clip(x + d) − x
    #[inline(always)]
    fn projected(&self, x: Group, d: Group) -> Group {
        x.zip(d, |x, d| self.bounds.clamp(x + d) - x)
    }
}

impl Block<&[Line], &[u32]> {
    fn direction(
        self,
        direction: &Direction,
        fields: &DirectionBlock,
        out: &mut [f32],
    ) -> [f64; 4] {
        let slots = self.slots;
        let mut sums = [0.0; 4];
        let [scale, length, stretch] =
            [-direction.scale, -direction.length, direction.stretch].map(f32x8::splat);
        let splat = |factors: &[f32]| factors.iter().map(|&v| f32x8::splat(v)).collect::<Vec<_>>();
        let (along_s, along_z) = (splat(&direction.along_s), splat(&direction.along_z));
        let chunks = self
            .lines
            .chunks(slots * CHUNK)
            .zip(self.live.chunks(CHUNK));
        for ((chunk, (lines, live)), out) in chunks.enumerate().zip(out.chunks_mut(CHUNK * LANES)) {
            let [
                mut slope,
                mut square,
                mut gradient_slope,
                mut gradient_square,
            ] = [f32x8::ZERO; 4];
            for (g, out) in out.chunks_mut(LANES).enumerate() {
                let x = fields.x.at(chunk * CHUNK + g);
                let gradient = fields.gradient.at(chunk * CHUNK + g);
                let held = x.zip(gradient, |x, g| fields.bounds.holds(x, g));
                if (held.0[0] & held.0[1]).all() {
                    out.fill(0.0);
                    continue;
                }
                let projected = fields.projected(x, gradient.map(|g| length * g));
                let mut d = fields.image.at(chunk * CHUNK + g).map(|v| scale * v);
                for (slot, line) in lines[g * slots..][..slots].iter().enumerate() {
                    if live[g] >> slot & 1 != 0 {
                        let (a, b) = (along_s[slot], along_z[slot]);
                        let pair = unpacked(&line.s).zip(unpacked(&line.z), |s, z| a * s + b * z);
                        d = d.zip(pair, |d, pair| d + pair);
                    }
                }
                let step = fields
                    .projected(x, d.map(|d| stretch * d))
                    .zip(held, without);
                // What is no element lies below its bound, but goes nowhere
                let [projected, step] = match out.len() {
                    LANES => [projected, step],
                    len => [projected, step].map(|group| group.first(len)),
                };
                let values: [f32; LANES] = bytemuck::cast(step.0);
                out.copy_from_slice(&values[..out.len()]);
                slope += gradient.products(step);
                square += step.products(step);
                gradient_slope += gradient.products(projected);
                gradient_square += projected.products(projected);
            }
            let of_chunk = [slope, square, gradient_slope, gradient_square].map(total);
            sums = std::array::from_fn(|i| sums[i] + of_chunk[i]);
        }
        sums
    }
}

impl Pairs<HostField> for HostPairs {
    const MAX_MEMORY: usize = MAX_SLOTS;

    fn new(slots: usize, bounds: &Bounds) -> Self {
        assert!(slots <= MAX_SLOTS, "more slots than bits");
        let chunks: Vec<usize> = bounds
            .blocks
            .iter()
            .map(|b| b.len.div_ceil(LANES).div_ceil(CHUNK))
            .collect();
        let all: usize = chunks.iter().sum();
        HostPairs {
            slots,
            lines: bytemuck::zeroed_vec(all * slots * CHUNK),
            live: vec![0; all * CHUNK],
            chunks,
        }
    }

    fn record(&mut self, slot: usize, latest: &Latest<HostField>, bounds: &Bounds) -> Products {
        let slots = self.slots;
        let Latest {
            x,
            step,
            gradient,
            change,
            image,
            alpha,
        } = *latest;
        let fields = bounds.split([x, step, gradient, change, image]);
        let products: Vec<Products> = self.blocks_mut().zip(fields).par_map(|(block, (b, f))| {
            let [x, step, gradient, change, image] = f.map(Groups::of);
            let fields = LatestBlock {
                x,
                step,
                gradient,
                change,
                image,
                alpha: f32x8::splat(alpha),
                bounds: Limits::new(b.lower, b.upper),
            };
            block.record(b.len, slot, &fields)
        });
        let mut sum = Products::zeros(slots);
        products.iter().for_each(|block| sum.add(block));
        sum.of_all_ranks(latest.x)
    }

    fn direction(
        &self,
        direction: &Direction,
        x: &HostField,
        gradient: &HostField,
        image: &HostField,
        bounds: &Bounds,
        out: &mut HostField,
    ) -> DirectionSums {
        let blocks = self
            .blocks()
            .zip(bounds.split_mut(out, [x, gradient, image]));
        let sums: Vec<[f64; 4]> = blocks.par_map(|(block, (out, b, fields))| {
            let [x, gradient, image] = fields.map(Groups::of);
            let fields = DirectionBlock {
                x,
                gradient,
                image,
                bounds: Limits::new(b.lower, b.upper),
            };
            block.direction(direction, &fields, out)
        });
        let [slope, square, gradient_slope, gradient_square] = x.totals(&sums);
        DirectionSums {
            slope,
            square,
            gradient_slope,
            gradient_square,
        }
    }

    fn parts(&self) -> Vec<PairsPart<'_>> {
        vec![
            PairsPart::of("pairs", bytemuck::cast_slice(&self.lines)),
            PairsPart::of("live", bytemuck::cast_slice(&self.live)),
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
    use crate::near;

    /// What is left of a number that was stored.
    fn stored(value: f32) -> f32 {
        let group: [f32; LANES] = bytemuck::cast(unpacked(&packed(Group::of(&[value; LANES]))).0);
        assert!(group.iter().all(|v| v.to_bits() == group[0].to_bits()));
        group[0]
    }

    fn is_held(x: f32, gradient: f32, lower: f32, upper: f32) -> bool {
        (x <= lower && gradient >= 0.0) || (x >= upper && gradient <= 0.0)
    }

    /// Numbers between −1 and 1 that look random.
    fn noise(len: usize, seed: u32) -> HostField {
        HostField::from_slice(&crate::check::noise(u64::from(seed), len))
    }

    #[test]
    fn rounding_goes_to_the_nearest_sixteen_bits() {
        for value in [0.0, -0.0, 1.0, -2.5, 0.333_333_3, 1e-30, -7e20] {
            let back = stored(value);
            let off = (back - value).abs();
            assert!(off <= value.abs() / 256.0, "{value} became {back}");
        }
        // Halfway between 1 and 1 + 2⁻⁷: to even
        assert_eq!(stored(1.0 + 2f32.powi(-8)), 1.0);
        assert_eq!(stored(1.0 + 3.0 * 2f32.powi(-8)), 1.0 + 2f32.powi(-6));
    }

    #[test]
    fn lanes_beyond_the_last_element_are_no_part_of_the_sums() {
        let bounds = Bounds::of_pieces([(17, 0.1, 0.5)]);
        let pairs = HostPairs::new(1, &bounds);
        let direction = Direction {
            scale: 1.0,
            length: 1.0,
            along_s: vec![0.0],
            along_z: vec![0.0],
            stretch: 1.0,
        };
        let mut x = HostField::zeros(17);
        x.fill(0.25);
        let mut gradient = x.zeros_like();
        gradient.as_mut_slice()[16] = 0.125;
        let mut out = x.zeros_like();
        let sums = pairs.direction(&direction, &x, &gradient, &gradient, &bounds, &mut out);
        let squares = [sums.square, sums.gradient_square];
        assert_eq!((squares, sums.slope), ([0.125 * 0.125; 2], -0.125 * 0.125));
    }

    /// Against sums written down one element at a time; two lights, lengths that are no multiples of anything.
    #[test]
    fn both_passes_agree_with_plain_sums() {
        let lens = [70_003usize, 1_017];
        let len = lens[0] + lens[1];
        let bounds = Bounds::of_pieces([(lens[0], 0.0, 0.8), (lens[1], 0.1, 0.5)]);
        let limits = |i: usize| if i < lens[0] { (0.0, 0.8) } else { (0.1, 0.5) };
        let slots = 3;
        let mut pairs = HostPairs::new(slots, &bounds);
        let mut y = vec![0.0f64; len];
        let (mut kept_s, mut kept_z) = (
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
                if (i / 40 + round as usize).is_multiple_of(3) {
                    *v = 0.0;
                }
            }
            let (before, after) = (noise(len, round + 21), noise(len, round + 31));
            let mut change = x.zeros_like();
            change.change_where_moved(&step, &before, &after);
            // Any field may be P·y
            let image = noise(len, round + 41);
            let slot = round as usize % slots;
            let latest = Latest {
                x: &x,
                step: &step,
                alpha: 0.7,
                gradient: &after,
                change: &change,
                image: &image,
            };
            products = pairs.record(slot, &latest, &bounds);
            for i in 0..len {
                let (x, step) = (x.as_slice()[i], step.as_slice()[i]);
                let (before, after) = (before.as_slice()[i], after.as_slice()[i]);
                kept_s[slot][i] = f64::from(stored(0.7 * step));
                kept_z[slot][i] = f64::from(stored(image.as_slice()[i]));
                y[i] = if step == 0.0 {
                    0.0
                } else {
                    f64::from(after - before)
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
                (products.s_y[j], dot(&kept_s[j], &y)),
                (products.z_y[j], dot(&kept_z[j], &y)),
                (products.s_g[j], dot(&kept_s[j], &free)),
                (products.z_g[j], dot(&kept_z[j], &free)),
            ] {
                near!(found, expected, tolerance, "slot {j}");
            }
        }
        assert!((products.s_s - dot(&kept_s[newest], &kept_s[newest])).abs() < tolerance);
        assert!((products.y_y - dot(&y, &y)).abs() < tolerance);

        let direction = Direction {
            scale: 0.3,
            length: 0.2,
            along_s: vec![0.5, -0.2, 0.1],
            along_z: vec![0.05, 0.1, -0.3],
            stretch: 1.5,
        };
        let mut out = x.zeros_like();
        let image = noise(len, 51);
        let sums = pairs.direction(&direction, &x, &gradient, &image, &bounds, &mut out);
        let (mut slope, mut gradient_slope) = (0.0, 0.0);
        for i in 0..len {
            let (lower, upper) = limits(i);
            let (x, g) = (x.as_slice()[i], gradient.as_slice()[i]);
            let mut d = -0.3 * f64::from(image.as_slice()[i]);
            let short = (x - 0.2 * g).clamp(lower, upper) - x;
            gradient_slope += f64::from(short) * f64::from(g);
            for j in 0..slots {
                d += f64::from(direction.along_s[j]) * kept_s[j][i]
                    + f64::from(direction.along_z[j]) * kept_z[j][i];
            }
            let end =
                (f64::from(x) + 1.5 * d).clamp(f64::from(lower), f64::from(upper)) - f64::from(x);
            let expected = if is_held(x, g, lower, upper) {
                0.0
            } else {
                end
            };
            let found = f64::from(out.as_slice()[i]);
            near!(found, expected, 1e-5, "element {i}");
            slope += expected * f64::from(g);
        }
        assert!((sums.slope - slope).abs() < tolerance);
        assert!((sums.gradient_slope - gradient_slope).abs() < tolerance);

        let mut copy = HostPairs::new(slots, &bounds);
        let parts = pairs.parts();
        let mut read = |name: &str, bytes: &mut [u8]| {
            let part = parts.iter().find(|part| part.name == name).unwrap();
            bytes.copy_from_slice(&(part.bytes)());
            Ok(())
        };
        copy.restore(&mut read).unwrap();
        let mut again = x.zeros_like();
        assert_eq!(
            copy.direction(&direction, &x, &gradient, &image, &bounds, &mut again),
            sums
        );
        assert_eq!(again.as_slice(), out.as_slice());
    }
}
