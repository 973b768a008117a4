//! The walk in vectors of eight cells, for AVX2, which writes voxels one by one.
//!
//! Segments that lose much within a cell (`OPAQUE`) take the plain twin.

use super::{PHI, SLAB, Segment, THIN, Ways};
use std::arch::x86_64::*;
use std::f32::consts::{LN_2, LOG2_E};
use std::ops::Range;

/// Cells of a vector.
const LANES: usize = 8;

/// Where eight cells are, along one of the other two axes.
struct Side {
    /// Floats to the first voxel, and to the one behind the face.
    voxel: [__m256i; 2],
    /// Whether those lie in the grid.
    within: [__m256i; 2],
    /// Where the face is crossed; at the end where none is.
    crossing: __m256,
}

/// e^x for x ≤ 0 to 2e-7; below −87, where f32 ends, that of −87.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn exp8(x: __m256) -> __m256 {
    let all = |v| _mm256_set1_ps(v);
    let x = _mm256_max_ps(x, all(-87.0));
    let whole = _mm256_cvtps_epi32(_mm256_mul_ps(x, all(LOG2_E)));
    let f = _mm256_fnmadd_ps(_mm256_cvtepi32_ps(whole), all(LN_2), x);
    let mut sum = all(1.0 / 720.0);
    for c in [1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0] {
        sum = _mm256_fmadd_ps(sum, f, all(c));
    }
    let power = _mm256_slli_epi32::<23>(_mm256_add_epi32(whole, _mm256_set1_epi32(127)));
    _mm256_mul_ps(sum, _mm256_castsi256_ps(power))
}

#[target_feature(enable = "avx2,fma")]
#[inline]
fn phi8(x: __m256, thin: bool) -> __m256 {
    let terms = if thin {
        &PHI[PHI.len() / 2..]
    } else {
        &PHI[..]
    };
    let mut sum = _mm256_setzero_ps();
    for &c in terms {
        sum = _mm256_fmadd_ps(sum, x, _mm256_set1_ps(c));
    }
    sum
}

/// The voxels between `begin` and `end` of each cell along axis `i` of the other two.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn side(ways: Ways, s: &Segment, i: usize, begin: __m256, end: __m256) -> Side {
    let (slope, offset) = (_mm256_set1_ps(s.slope[i]), _mm256_set1_ps(s.offset[i]));
    let at = |a| _mm256_floor_ps(_mm256_fmadd_ps(slope, a, offset));
    let (first, last) = (at(begin), at(end));
    let face = _mm256_max_ps(first, last);
    let meets = _mm256_mul_ps(
        _mm256_sub_ps(face, offset),
        _mm256_set1_ps(1.0 / s.slope[i]),
    );
    let meets = _mm256_min_ps(_mm256_max_ps(meets, begin), end);
    let same = _mm256_cmp_ps::<_CMP_EQ_OQ>(first, last);
    let stride = _mm256_set1_epi32(ways.strides[i + 1]);
    let most = _mm256_set1_epi32(ways.counts[i + 1] - 1);
    let places = [first, last].map(|place| _mm256_cvttps_epi32(place));
    Side {
        voxel: places.map(|place| _mm256_mullo_epi32(place, stride)),
        // As unsigned numbers, negative ones are beyond any count
        within: places.map(|place| _mm256_cmpeq_epi32(_mm256_max_epu32(place, most), most)),
        crossing: _mm256_blendv_ps(meets, end, same),
    }
}

/// Calls `visit(lit, voxels, deposits)` for the pieces, at most three, in the cells from `first` on; bits of `lit` say which count.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn pieces(ways: Ways, first: usize, s: &Segment, mut visit: impl FnMut(i32, __m256i, __m256)) {
    let all = |v| _mm256_set1_ps(v);
    let (zero, rate) = (_mm256_setzero_ps(), all(s.rate));
    let cell = _mm256_add_epi32(
        _mm256_set1_epi32(first as i32),
        _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7),
    );
    let along = _mm256_mullo_epi32(cell, _mm256_set1_epi32(ways.strides[0]));
    let cell = _mm256_cvtepi32_ps(cell);
    let begin = _mm256_max_ps(all(s.low), cell);
    let end = _mm256_min_ps(all(s.high), _mm256_add_ps(cell, all(1.0)));
    let lit = _mm256_cmp_ps::<_CMP_GT_OQ>(end, begin);
    if _mm256_movemask_ps(lit) == 0 {
        return;
    }
    let thin = s.rate.abs() <= THIN;
    let [b, c] = [0, 1].map(|i| side(ways, s, i, begin, end));
    let depth = _mm256_mul_ps(rate, _mm256_sub_ps(begin, all(s.enter)));
    let left = exp8(_mm256_min_ps(_mm256_sub_ps(zero, depth), zero));
    let mut power = _mm256_mul_ps(all(s.energy), left);
    let mut piece = |from, to, [at_b, at_c]: [__m256i; 2], within: __m256i| {
        let way = _mm256_sub_ps(to, from);
        let passes = _mm256_and_ps(lit, _mm256_cmp_ps::<_CMP_GT_OQ>(way, zero));
        if _mm256_movemask_ps(passes) == 0 {
            return;
        }
        let passes = _mm256_and_ps(passes, _mm256_castsi256_ps(within));
        let x = _mm256_mul_ps(rate, way);
        let deposit = _mm256_mul_ps(_mm256_mul_ps(power, way), phi8(x, thin));
        power = _mm256_fnmadd_ps(rate, deposit, power);
        let voxel = _mm256_add_epi32(along, _mm256_add_epi32(at_b, at_c));
        visit(_mm256_movemask_ps(passes), voxel, deposit);
    };
    // What comes first is where the first voxels of both are, what comes last where the last ones are
    let cut = _mm256_min_ps(b.crossing, c.crossing);
    let behind = _mm256_max_ps(b.crossing, c.crossing);
    let b_first = _mm256_cmp_ps::<_CMP_LT_OQ>(b.crossing, c.crossing);
    let b_first = _mm256_castps_si256(b_first);
    let after_b = |pair: [__m256i; 2]| _mm256_blendv_epi8(pair[0], pair[1], b_first);
    let before_c = |pair: [__m256i; 2]| _mm256_blendv_epi8(pair[1], pair[0], b_first);
    let both = |b, c| _mm256_and_si256(b, c);
    piece(
        begin,
        cut,
        [b.voxel[0], c.voxel[0]],
        both(b.within[0], c.within[0]),
    );
    piece(
        cut,
        behind,
        [after_b(b.voxel), before_c(c.voxel)],
        both(after_b(b.within), before_c(c.within)),
    );
    piece(
        behind,
        end,
        [b.voxel[1], c.voxel[1]],
        both(b.within[1], c.within[1]),
    );
}

/// Voxel and deposit of every piece in a slab.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn each_piece(ways: Ways, slab: usize, segment: &Segment, mut visit: impl FnMut(usize, f32)) {
    for half in 0..SLAB / LANES {
        pieces(
            ways,
            slab * SLAB + half * LANES,
            segment,
            |mut lit, voxel, deposit| {
                let (mut voxels, mut deposits) = ([0i32; LANES], [0.0f32; LANES]);
                // SAFETY: eight numbers each.
                unsafe {
                    _mm256_storeu_si256(voxels.as_mut_ptr().cast(), voxel);
                    _mm256_storeu_ps(deposits.as_mut_ptr(), deposit);
                }
                while lit != 0 {
                    let k = lit.trailing_zeros() as usize % LANES;
                    visit(voxels[k] as usize, deposits[k]);
                    lit &= lit - 1;
                }
            },
        );
    }
}

/// Calls `visit(voxel, deposit)` for every piece in a slab.
///
/// # Safety
/// AVX2 and FMA.
#[target_feature(enable = "avx2,fma")]
pub(super) unsafe fn for_each(
    ways: Ways,
    slab: usize,
    segment: &Segment,
    visit: &mut impl FnMut(usize, f32),
) {
    each_piece(ways, slab, segment, visit);
}

/// Adds what a segment leaves in a slab, times a pixel's value.
///
/// # Safety
/// AVX2 and FMA; all voxels of the grid lie behind `dose`, and nobody else touches those of this slab.
#[target_feature(enable = "avx2,fma")]
pub(super) unsafe fn add(ways: Ways, slab: usize, segment: &Segment, value: f32, dose: *mut f32) {
    let bright = Segment {
        energy: segment.energy * value,
        ..*segment
    };
    each_piece(ways, slab, &bright, |voxel, deposit| {
        // SAFETY: the voxels of pieces lie in the grid, in this slab.
        unsafe { *dose.add(voxel) += deposit };
    });
}

/// Σ deposit · dose over the voxels of a segment in some slabs.
///
/// # Safety
/// AVX2 and FMA; all voxels of the grid lie in `dose`.
#[target_feature(enable = "avx2,fma")]
pub(super) unsafe fn collect(
    ways: Ways,
    slabs: Range<usize>,
    segment: &Segment,
    dose: &[f32],
) -> f32 {
    let mut sum = 0.0;
    for slab in slabs {
        each_piece(ways, slab, segment, |voxel, deposit| {
            // SAFETY: the voxels of pieces lie in the grid.
            sum += unsafe { dose.get_unchecked(voxel) } * deposit;
        });
    }
    sum
}
