//! Uniform strips: beams of evenly spaced straight strips, for a single slice.
//!
//! A single slice has no z to walk along, so lanes run over sixteen voxels of a row (dose) or sixteen strips (adjoint).
//! Where light is straight, strip edges are evenly spaced in every row of voxels, and both
//! directions are a few instructions per sixteen lanes. With the strip coordinate τ (edges at integers), voxel i of a row
//! covers [τ₀ + s·i, τ₀ + s·(i + 1)), and what a strip leaves in a row splits into a number per strip and one per row,
//! E(j, r) = factor(j)·row(r), because the exponentials do:
//!
//! ```text
//! dose      dose(i) += row · Σ_j |[τ₀ + s·i, τ₀ + s·(i + 1)) ∩ [j, j + 1)| · factor(j)·x(j)
//! adjoint   g(j)    += row · s·(I(e(j + 1)) − I(e(j))),   e(j) = (j − τ₀)/s,   I(e) = ∫₀ᵉ c
//! ```
//! The integral of the cotangent c over a row is piecewise linear, so it is two table look-ups in registers.
#![cfg_attr(
    target_arch = "x86_64",
    expect(
        unsafe_code,
        reason = "kernel file: registers and run-time dispatch need intrinsics"
    )
)]

use super::kernel::Isa;
use super::strips::{Beam, Major};
use super::tiles::{Deposit, TILE, Tile};
use std::ops::Range;
use tomolith_core::grid::{PatternGrid, VolumeGrid};

/// Zeros before the first and behind the last strip of a source: windows of a tile that meets any strip stay within.
pub(super) const PAD: usize = 64;
/// Strips that a tile may meet at most: two registers.
const MOST: f64 = 31.0;
/// Largest exponent of a factor: f32 keeps its digits.
const LARGEST_EXPONENT: f64 = 40.0;
/// Edges that are this close (voxels) to their place are regular.
const REGULAR: f64 = 1e-3;

/// Voxels of a tile, lanes along the minor axis of a beam: `[row · TILE + across]`.
pub(super) type Square = [f32; TILE * TILE];

/// A beam of evenly spaced strips, numbered in growing order of the minor coordinate, missing ones included.
#[derive(Clone, Debug)]
pub(super) struct UniformStrips {
    /// Strip coordinate at minor coordinate 0 in the middle of row 0, its growth per voxel, and per row.
    first: f64,
    per_voxel: f64,
    per_row: f64,
    /// Whether strips run against the columns.
    reversed: bool,
    /// What a strip leaves in the grid's middle row.
    factor: Vec<f32>,
    /// What the first row of each tile gets of that, and the rows behind it.
    tile_rows: Vec<f32>,
    powers: [f32; TILE],
    /// Strips of the beam that lie at their evenly spaced places.
    regular: Range<usize>,
}

impl UniformStrips {
    /// None where strips are too fine for two registers, or light too strongly absorbed for single precision.
    pub(super) fn new(
        beam: &Beam,
        pixels: &PatternGrid,
        grid: &VolumeGrid,
        deposit: &Deposit,
    ) -> Option<Self> {
        let [offset, per_mm, slope] = beam.minor(grid);
        let pitch = pixels.pitch_mm[0];
        let per_voxel = 1.0 / (per_mm.abs() * pitch);
        // Strip coordinate of the ray through the axis
        let axis = pixels.columns as f64 / 2.0 - per_mm.signum() * pixels.offset_mm[0] / pitch;
        let uniform = UniformStrips {
            first: axis - (offset + 0.5 * slope) * per_voxel,
            per_voxel,
            per_row: -slope * per_voxel,
            reversed: per_mm < 0.0,
            factor: vec![0.0; pixels.columns],
            tile_rows: Vec::new(),
            powers: [1.0; TILE],
            regular: 0..0,
        };
        let edge = TILE as f64;
        if edge * per_voxel + (edge - 1.0) * uniform.per_row.abs() + 2.0 > MOST {
            return None;
        }
        let rows = grid.shape[if beam.major == Major::X { 2 } else { 1 }];
        uniform.with_strips(beam, rows, slope, deposit)
    }

    fn with_strips(
        mut self,
        beam: &Beam,
        rows: usize,
        slope: f64,
        deposit: &Deposit,
    ) -> Option<Self> {
        let strip = beam.strips.first()?;
        let fading = deposit.log_per_row(f64::from(strip.row_mm));
        if fading * rows as f64 > LARGEST_EXPONENT {
            return None;
        }
        let sign = if strip.upward { -1.0 } else { 1.0 };
        let middle = (rows / 2) as f64;
        let of_row = |row: usize| (sign * fading * (row as f64 - middle)).exp() as f32;
        self.tile_rows = (0..rows).step_by(TILE).map(of_row).collect();
        self.powers = std::array::from_fn(|i| (sign * fading * i as f64).exp() as f32);
        let last = self.factor.len() - 1;
        let mut is_regular = Vec::with_capacity(beam.strips.len());
        for (i, strip) in beam.strips.iter().enumerate() {
            let column = strip.column as usize;
            let number = if self.reversed { last - column } else { column };
            let enter = f64::from(beam.columns.enter[i]);
            let depth = if strip.upward {
                middle - enter
            } else {
                enter - middle - 1.0
            };
            let full = f64::from(beam.columns.full[i]);
            self.factor[number] = (full * (-fading * depth).exp()) as f32;
            let is_at = |edge: [f32; 2], number: usize| {
                // Row 0 has its middle at 0.5
                let place = f64::from(edge[0]) + 0.5 * slope;
                let expected = (number as f64 - self.first) / self.per_voxel;
                (place - expected).abs() < REGULAR && (f64::from(edge[1]) - slope).abs() < 1e-6
            };
            is_regular.push(is_at(strip.edges[0], number) && is_at(strip.edges[1], number + 1));
        }
        let begin = is_regular.iter().position(|&r| r)?;
        let count = is_regular[begin..].iter().take_while(|&&r| r).count();
        self.regular = begin..begin + count;
        Some(self)
    }

    /// Whether these strips of the beam lie at their evenly spaced places.
    pub(super) fn holds(&self, strips: Range<usize>) -> bool {
        self.regular.start <= strips.start && strips.end <= self.regular.end
    }

    /// Floats of the source of so many columns, with the zeros on both sides.
    pub(super) fn stride(columns: usize) -> usize {
        columns + 2 * PAD
    }

    /// Pixel values of a frame → what strips leave, in their order; `source` has [`stride`](Self::stride) floats.
    pub(super) fn fill(&self, values: &[f32], source: &mut [f32]) {
        source.fill(0.0);
        let inner = &mut source[PAD..PAD + values.len()];
        let scaled = |(to, (&value, &factor)): (&mut f32, (&f32, &f32))| *to = value * factor;
        if self.reversed {
            let values = values.iter().rev().zip(&self.factor);
            inner.iter_mut().zip(values).for_each(scaled);
        } else {
            let values = values.iter().zip(&self.factor);
            inner.iter_mut().zip(values).for_each(scaled);
        }
    }

    /// Transpose of [`fill`](Self::fill); adds to `values`.
    pub(super) fn collect(&self, source: &[f32], values: &mut [f32]) {
        let last = values.len() - 1;
        let inner = &source[PAD..PAD + values.len()];
        for (i, (&g, &factor)) in inner.iter().zip(&self.factor).enumerate() {
            values[if self.reversed { last - i } else { i }] += g * factor;
        }
    }

    fn rows(&self, tile: &Tile, major: Major) -> Rows {
        let (along, across) = major.axes();
        let [row, voxel] = [tile.start[along], tile.start[across]];
        let start = self.first + self.per_row * row as f64 + self.per_voxel * voxel as f64;
        let of_tile = self.tile_rows[row / TILE];
        Rows {
            count: tile.size[along],
            start,
            per_row: self.per_row,
            per_voxel: self.per_voxel,
            factor: self.powers.map(|power| of_tile * power),
        }
    }

    /// Adds the light of a source to the voxels of a tile.
    pub(super) fn add_dose(
        &self,
        isa: Isa,
        tile: &Tile,
        major: Major,
        source: &[f32],
        out: &mut Square,
    ) {
        let rows = self.rows(tile, major);
        match isa {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX-512F was detected (Isa values other than Scalar come from `available`).
            Isa::Avx512 => unsafe { x86::dose(&rows, source, out) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX2 and FMA were detected, as above.
            Isa::Avx2 => unsafe { x86::dose_avx2(&rows, source, out) },
            _ => plain_dose(&rows, source, out),
        }
    }

    /// Adds what the cotangent of a tile gives to the strips of `source`.
    pub(super) fn add_adjoint(
        &self,
        isa: Isa,
        tile: &Tile,
        major: Major,
        integrals: &Integrals,
        source: &mut [f32],
    ) {
        let rows = self.rows(tile, major);
        match isa {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX-512F was detected (Isa values other than Scalar come from `available`).
            Isa::Avx512 => unsafe { x86::adjoint(&rows, integrals, source) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX2 and FMA were detected, as above.
            Isa::Avx2 => unsafe { x86::adjoint_avx2(&rows, integrals, source) },
            _ => plain_adjoint(&rows, integrals, source),
        }
    }
}

/// The rows of a tile, as uniform strips cross them.
struct Rows {
    count: usize,
    /// Strip coordinate of the first voxel's lower face in the first row, its growth per row and per voxel.
    start: f64,
    per_row: f64,
    per_voxel: f64,
    /// Share of the strips' factors that each row gets.
    factor: [f32; TILE],
}

impl Rows {
    /// For each row the first strip, and how far into it the first voxel begins.
    #[inline(always)] // with the instructions of the path that asks
    fn begins(&self) -> ([i32; TILE], [f32; TILE]) {
        let (mut strips, mut parts) = ([0; TILE], [0.0; TILE]);
        for row in 0..TILE {
            let at = self.start + self.per_row * row as f64;
            let strip = at.floor();
            strips[row] = strip as i32;
            parts[row] = (at - strip) as f32;
        }
        (strips, parts)
    }

    /// The first strip that any row meets, and for each row the place (voxels) of that strip's lower edge.
    #[inline(always)]
    fn edges(&self) -> (i32, [f32; TILE]) {
        let last = self.start + self.per_row * (self.count - 1) as f64;
        let first = self.start.min(last).floor();
        let width = 1.0 / self.per_voxel;
        let place = |row: usize| ((first - self.start - self.per_row * row as f64) * width) as f32;
        (first as i32, std::array::from_fn(place))
    }
}

/// Where a window of 32 strips begins in a padded source.
///
/// # Panics
/// When it does not lie within.
fn window(source_len: usize, first: i32) -> usize {
    let at = first + PAD as i32;
    assert!(
        at >= 0 && at as usize + 32 <= source_len,
        "tile outside the uniform strips"
    );
    at as usize
}

/// The plain twin of the dose.
fn plain_dose(rows: &Rows, source: &[f32], out: &mut Square) {
    let (strips, parts) = rows.begins();
    let width = rows.per_voxel as f32;
    for row in 0..rows.count {
        let at = window(source.len(), strips[row]);
        let window = &source[at..at + 32];
        let factor = rows.factor[row];
        let out = &mut out[row * TILE..(row + 1) * TILE];
        for (lane, out) in out.iter_mut().enumerate() {
            let begin = parts[row] + lane as f32 * width;
            let strip = begin as usize;
            let first = (1.0 - (begin - strip as f32)).min(width);
            let second = (width - first).min(1.0);
            let sum = first * window[strip & 31]
                + second * window[(strip + 1) & 31]
                + (width - first - second) * window[(strip + 2) & 31];
            *out += factor * sum;
        }
    }
}

/// The plain twin of the adjoint.
fn plain_adjoint(rows: &Rows, integrals: &Integrals, source: &mut [f32]) {
    let (first, places) = rows.edges();
    let at = window(source.len(), first);
    let width = (1.0 / rows.per_voxel) as f32;
    let mut sums = [0.0f32; 32];
    for (row, place) in places.iter().enumerate().take(rows.count) {
        let range = row * TILE..(row + 1) * TILE;
        let (value, constant) = (&integrals.value[range.clone()], &integrals.constant[range]);
        let factor = rows.factor[row] * rows.per_voxel as f32;
        let mut integral = [0.0f32; 33];
        for (lane, integral) in integral.iter_mut().enumerate() {
            let edge = (place + lane as f32 * width).clamp(0.0, TILE as f32);
            let voxel = (edge as usize).min(TILE - 1);
            *integral = edge * value[voxel] + constant[voxel];
        }
        for (lane, sum) in sums.iter_mut().enumerate() {
            *sum += factor * (integral[lane + 1] - integral[lane]);
        }
    }
    for (to, sum) in source[at..at + 32].iter_mut().zip(sums) {
        *to += sum;
    }
}

/// A tile's cotangent c, and what makes its integral along rows: ∫₀ᵉ c = c(i)·e + constant(i) in voxel i.
#[derive(Clone)]
pub(super) struct Integrals {
    pub(super) value: Square,
    pub(super) constant: Square,
}

impl Default for Integrals {
    fn default() -> Self {
        Integrals {
            value: [0.0; TILE * TILE],
            constant: [0.0; TILE * TILE],
        }
    }
}

impl Integrals {
    /// Finds the integrals after `value` was set.
    pub(super) fn integrate(&mut self) {
        let rows = self.value.chunks_exact(TILE);
        for (values, constants) in rows.zip(self.constant.chunks_exact_mut(TILE)) {
            let mut before = 0.0;
            for (i, (&value, constant)) in values.iter().zip(constants).enumerate() {
                *constant = before - i as f32 * value;
                before += value;
            }
        }
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Integrals, Rows, Square, TILE, window};
    #[cfg(doc)]
    use super::{plain_adjoint, plain_dose};
    use std::arch::x86_64::*;

    #[target_feature(enable = "avx2,fma")]
    fn half_ramp(first: f32) -> __m256 {
        let ramp = _mm256_setr_ps(0., 1., 2., 3., 4., 5., 6., 7.);
        _mm256_add_ps(ramp, _mm256_set1_ps(first))
    }

    /// See [`plain_dose`]; eight lanes at a time.
    #[target_feature(enable = "avx2,fma")]
    pub(super) fn dose_avx2(rows: &Rows, source: &[f32], out: &mut Square) {
        if rows.per_voxel <= 1.0 {
            dose_of_halves::<2>(rows, source, out);
        } else {
            dose_of_halves::<3>(rows, source, out);
        }
    }

    #[target_feature(enable = "avx2,fma")]
    fn dose_of_halves<const TAPS: usize>(rows: &Rows, source: &[f32], out: &mut Square) {
        let (strips, parts) = rows.begins();
        let one = _mm256_set1_ps(1.0);
        let width = _mm256_set1_ps(rows.per_voxel as f32);
        let lanes = [0.0, 8.0].map(|first| half_ramp(first));
        for (row, out) in out.chunks_exact_mut(TILE).enumerate().take(rows.count) {
            let at = window(source.len(), strips[row]);
            let factor = _mm256_set1_ps(rows.factor[row]);
            for (lanes, out) in lanes.iter().zip(out.chunks_exact_mut(8)) {
                let begin = _mm256_fmadd_ps(*lanes, width, _mm256_set1_ps(parts[row]));
                let strip = _mm256_cvttps_epi32(begin);
                let into = _mm256_sub_ps(begin, _mm256_cvtepi32_ps(strip));
                // Eight voxels and their taps meet sixteen strips at most, as `MOST` is 31
                let first = _mm256_cvtsi256_si32(strip);
                let within = _mm256_sub_epi32(strip, _mm256_set1_epi32(first));
                let mut cover = _mm256_min_ps(_mm256_sub_ps(one, into), width);
                let mut left = width;
                let mut sum = _mm256_setzero_ps();
                for tap in 0..TAPS {
                    let value = look_half(sixteen(source, at + first as usize + tap), within);
                    sum = _mm256_fmadd_ps(cover, value, sum);
                    left = _mm256_sub_ps(left, cover);
                    cover = _mm256_min_ps(left, one);
                }
                // SAFETY: `out` has eight floats.
                unsafe {
                    let before = _mm256_loadu_ps(out.as_ptr());
                    _mm256_storeu_ps(out.as_mut_ptr(), _mm256_fmadd_ps(factor, sum, before));
                }
            }
        }
    }

    /// Entries `i` (0 to 15) of a table of two registers.
    #[target_feature(enable = "avx2,fma")]
    fn look_half(table: &[f32; 16], i: __m256i) -> __m256 {
        // SAFETY: sixteen floats.
        let [low, high] = unsafe {
            [
                _mm256_loadu_ps(table.as_ptr()),
                _mm256_loadu_ps(table.as_ptr().add(8)),
            ]
        };
        let upper = _mm256_castsi256_ps(_mm256_cmpgt_epi32(i, _mm256_set1_epi32(7)));
        _mm256_blendv_ps(
            _mm256_permutevar8x32_ps(low, i),
            _mm256_permutevar8x32_ps(high, i),
            upper,
        )
    }

    /// The upper seven lanes of `a`, and the lowest of `b` behind them.
    #[target_feature(enable = "avx2,fma")]
    fn shifted_half(a: __m256, b: __m256) -> __m256 {
        let middle = _mm256_permute2f128_ps::<0x21>(a, b);
        _mm256_castsi256_ps(_mm256_alignr_epi8::<4>(
            _mm256_castps_si256(middle),
            _mm256_castps_si256(a),
        ))
    }

    /// See [`plain_adjoint`]; eight lanes at a time.
    #[target_feature(enable = "avx2,fma")]
    pub(super) fn adjoint_avx2(rows: &Rows, integrals: &Integrals, source: &mut [f32]) {
        let (first, places) = rows.edges();
        let at = window(source.len(), first);
        let width = _mm256_set1_ps((1.0 / rows.per_voxel) as f32);
        let (zero, end) = (_mm256_setzero_ps(), _mm256_set1_ps(TILE as f32));
        let last = _mm256_set1_epi32(TILE as i32 - 1);
        let lanes = [0.0, 8.0, 16.0, 24.0].map(|first| _mm256_mul_ps(half_ramp(first), width));
        let mut sums = [zero; 4];
        for (row, place) in places.iter().enumerate().take(rows.count) {
            let value = sixteen(&integrals.value, row * TILE);
            let constant = sixteen(&integrals.constant, row * TILE);
            let place = _mm256_set1_ps(*place);
            let integral = |lanes: __m256| {
                let edge = _mm256_add_ps(lanes, place);
                let edge = _mm256_min_ps(_mm256_max_ps(edge, zero), end);
                let voxel = _mm256_min_epi32(_mm256_cvttps_epi32(edge), last);
                _mm256_fmadd_ps(edge, look_half(value, voxel), look_half(constant, voxel))
            };
            let factor = _mm256_set1_ps(rows.factor[row] * rows.per_voxel as f32);
            let mut here = integral(lanes[0]);
            for (i, sum) in sums.iter_mut().enumerate() {
                // The last strip has no edge behind it: at most 31 strips meet a tile, so it holds nothing
                let next = match lanes.get(i + 1) {
                    Some(&lanes) => integral(lanes),
                    None => _mm256_permutevar8x32_ps(here, _mm256_set1_epi32(7)),
                };
                let between = _mm256_sub_ps(shifted_half(here, next), here);
                *sum = _mm256_fmadd_ps(factor, between, *sum);
                here = next;
            }
        }
        for (to, sum) in source[at..at + 32].chunks_exact_mut(8).zip(sums) {
            // SAFETY: `to` has eight floats.
            unsafe {
                let before = _mm256_loadu_ps(to.as_ptr());
                _mm256_storeu_ps(to.as_mut_ptr(), _mm256_add_ps(before, sum));
            }
        }
    }

    #[target_feature(enable = "avx512f")]
    fn ramp() -> __m512 {
        _mm512_setr_ps(
            0., 1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 13., 14., 15.,
        )
    }

    /// Reads sixteen values.
    #[target_feature(enable = "avx512f")]
    fn load(values: &[f32; 16]) -> __m512 {
        // SAFETY: sixteen floats.
        unsafe { _mm512_loadu_ps(values.as_ptr()) }
    }

    /// Sixteen values from `at` on.
    fn sixteen(values: &[f32], at: usize) -> &[f32; 16] {
        values[at..]
            .first_chunk()
            .unwrap_or_else(|| unreachable!("windows lie within their arrays"))
    }

    /// See [`plain_dose`].
    #[target_feature(enable = "avx512f")]
    pub(super) fn dose(rows: &Rows, source: &[f32], out: &mut Square) {
        if rows.per_voxel <= 1.0 {
            dose_of_taps::<2>(rows, source, out);
        } else {
            dose_of_taps::<3>(rows, source, out);
        }
    }

    #[target_feature(enable = "avx512f")]
    fn dose_of_taps<const TAPS: usize>(rows: &Rows, source: &[f32], out: &mut Square) {
        let (strips, parts) = rows.begins();
        let (one, next) = (_mm512_set1_ps(1.0), _mm512_set1_epi32(1));
        let width = _mm512_set1_ps(rows.per_voxel as f32);
        let lanes = _mm512_mul_ps(ramp(), width);
        for (row, out) in out.chunks_exact_mut(TILE).enumerate().take(rows.count) {
            let at = window(source.len(), strips[row]);
            let low = load(sixteen(source, at));
            let high = load(sixteen(source, at + 16));
            let begin = _mm512_add_ps(lanes, _mm512_set1_ps(parts[row]));
            let mut strip = _mm512_cvttps_epi32(begin);
            let into = _mm512_sub_ps(begin, _mm512_cvtepi32_ps(strip));
            let mut cover = _mm512_min_ps(_mm512_sub_ps(one, into), width);
            let mut left = width;
            let mut sum = _mm512_setzero_ps();
            for tap in 0..TAPS {
                let value = _mm512_permutex2var_ps(low, strip, high);
                sum = _mm512_fmadd_ps(cover, value, sum);
                if tap + 1 < TAPS {
                    left = _mm512_sub_ps(left, cover);
                    cover = if tap + 2 < TAPS {
                        _mm512_min_ps(left, one)
                    } else {
                        left
                    };
                    strip = _mm512_add_epi32(strip, next);
                }
            }
            // SAFETY: `out` has sixteen floats.
            unsafe {
                let before = _mm512_loadu_ps(out.as_ptr());
                let factor = _mm512_set1_ps(rows.factor[row]);
                _mm512_storeu_ps(out.as_mut_ptr(), _mm512_fmadd_ps(factor, sum, before));
            }
        }
    }

    /// See [`plain_adjoint`].
    #[target_feature(enable = "avx512f")]
    pub(super) fn adjoint(rows: &Rows, integrals: &Integrals, source: &mut [f32]) {
        let (first, places) = rows.edges();
        let at = window(source.len(), first);
        let width = _mm512_set1_ps((1.0 / rows.per_voxel) as f32);
        let low_lanes = _mm512_mul_ps(ramp(), width);
        let high_lanes = _mm512_fmadd_ps(_mm512_set1_ps(16.0), width, low_lanes);
        let (zero, end) = (_mm512_setzero_ps(), _mm512_set1_ps(TILE as f32));
        let last = _mm512_set1_epi32(TILE as i32 - 1);
        let mut sums = [zero; 2];
        for (row, place) in places.iter().enumerate().take(rows.count) {
            let value = load(sixteen(&integrals.value, row * TILE));
            let constant = load(sixteen(&integrals.constant, row * TILE));
            let place = _mm512_set1_ps(*place);
            let integral = |lanes: __m512| {
                let edge = _mm512_add_ps(lanes, place);
                let edge = _mm512_min_ps(_mm512_max_ps(edge, zero), end);
                let voxel = _mm512_min_epi32(_mm512_cvttps_epi32(edge), last);
                _mm512_fmadd_ps(
                    edge,
                    _mm512_permutexvar_ps(voxel, value),
                    _mm512_permutexvar_ps(voxel, constant),
                )
            };
            let (low, high) = (integral(low_lanes), integral(high_lanes));
            let factor = _mm512_set1_ps(rows.factor[row] * rows.per_voxel as f32);
            let shifted = |a: __m512, b: __m512| {
                _mm512_castsi512_ps(_mm512_alignr_epi32::<1>(
                    _mm512_castps_si512(b),
                    _mm512_castps_si512(a),
                ))
            };
            // The last lane has no edge behind it: at most 31 strips meet a tile, so it holds nothing
            let top = shifted(high, _mm512_permutexvar_ps(last, high));
            sums[0] = _mm512_fmadd_ps(factor, _mm512_sub_ps(shifted(low, high), low), sums[0]);
            sums[1] = _mm512_fmadd_ps(factor, _mm512_sub_ps(top, high), sums[1]);
        }
        for (to, sum) in source[at..at + 32].chunks_exact_mut(16).zip(sums) {
            // SAFETY: `to` has sixteen floats.
            unsafe {
                let before = _mm512_loadu_ps(to.as_ptr());
                _mm512_storeu_ps(to.as_mut_ptr(), _mm512_add_ps(before, sum));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::noise;
    use tomolith_core::near;

    /// Rows of a tile at some angle: every tap and both directions of the strips' slope occur.
    fn rows(per_voxel: f64, per_row: f64) -> Rows {
        Rows {
            count: 13,
            start: 20.3,
            per_row,
            per_voxel,
            factor: std::array::from_fn(|i| 0.9f32.powi(i as i32)),
        }
    }

    #[test]
    fn every_path_equals_the_overlap_of_intervals_and_the_adjoint_its_transpose() {
        for (per_voxel, per_row) in [(0.8, 0.6), (0.3, -0.2), (1.25, 0.5), (1.0, 0.0)] {
            let rows = rows(per_voxel, per_row);
            let source = noise(1, 60 + 2 * PAD);
            let mut expected = [0.0f64; TILE * TILE];
            for (i, out) in expected.iter_mut().enumerate().take(rows.count * TILE) {
                let (row, voxel) = (i / TILE, i % TILE);
                let begin = rows.start + per_row * row as f64 + per_voxel * voxel as f64;
                for strip in 0..60 {
                    let strip_begin = f64::from(strip);
                    let cover = (begin + per_voxel).min(strip_begin + 1.0) - begin.max(strip_begin);
                    *out += cover.max(0.0)
                        * f64::from(source[PAD + strip as usize])
                        * f64::from(rows.factor[row]);
                }
            }
            let mut integrals = Integrals::default();
            integrals.value.copy_from_slice(&noise(2, TILE * TILE));
            integrals.integrate();
            for isa in Isa::available() {
                let mut out = [0.0; TILE * TILE];
                let mut grad = vec![0.0; source.len()];
                match isa {
                    #[cfg(target_arch = "x86_64")]
                    // SAFETY: the instruction sets were detected.
                    Isa::Avx512 => unsafe {
                        x86::dose(&rows, &source, &mut out);
                        x86::adjoint(&rows, &integrals, &mut grad);
                    },
                    #[cfg(target_arch = "x86_64")]
                    // SAFETY: as above.
                    Isa::Avx2 => unsafe {
                        x86::dose_avx2(&rows, &source, &mut out);
                        x86::adjoint_avx2(&rows, &integrals, &mut grad);
                    },
                    _ => {
                        plain_dose(&rows, &source, &mut out);
                        plain_adjoint(&rows, &integrals, &mut grad);
                    }
                }
                for (found, expected) in out.iter().zip(&expected).take(rows.count * TILE) {
                    near!(f64::from(*found), expected, 3e-6, "{isa:?} {per_voxel}");
                }
                let product = |a: &[f32], b: &[f32]| -> f64 {
                    a.iter()
                        .zip(b)
                        .map(|(&a, &b)| f64::from(a) * f64::from(b))
                        .sum()
                };
                let len = rows.count * TILE;
                let (forward, backward) = (
                    product(&out[..len], &integrals.value[..len]),
                    product(&source, &grad),
                );
                near!(forward, backward, 2e-5, "{isa:?} {per_voxel}");
            }
        }
    }
}
