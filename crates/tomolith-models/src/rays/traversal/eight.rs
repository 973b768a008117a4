//! The walk in vectors of eight cells, for AVX2, which writes voxels one by one.
//!
//! Segments that lose much within a cell (`OPAQUE`) take the plain twin.

use super::walk::{instructions, walk};
use super::{OPAQUE, PHI, SLAB, Segment, THIN, Ways};
use std::arch::x86_64::{
    __m256, __m256i, _CMP_GT_OQ, _CMP_NEQ_OQ, _mm256_add_epi32 as add_whole, _mm256_add_ps as add,
    _mm256_and_ps as both, _mm256_blendv_ps, _mm256_castps_si256, _mm256_castsi256_ps,
    _mm256_cmp_ps, _mm256_cmpeq_epi32, _mm256_cvtepi32_ps, _mm256_cvtps_epi32,
    _mm256_cvttps_epi32 as whole, _mm256_div_ps as div, _mm256_floor_ps as floor,
    _mm256_fmadd_ps as fused, _mm256_fnmadd_ps as fused_less, _mm256_max_epu32,
    _mm256_max_ps as max, _mm256_min_ps as min, _mm256_movemask_ps, _mm256_mul_ps as mul,
    _mm256_mullo_epi32 as mul_whole, _mm256_set1_epi32 as splat_whole, _mm256_set1_ps as splat,
    _mm256_setr_ps, _mm256_slli_epi32, _mm256_storeu_ps as store,
    _mm256_storeu_si256 as store_whole, _mm256_sub_ps as sub,
};
use std::f32::consts::{LN_2, LOG2_E};
use std::ops::Range;

/// Cells of a vector.
const LANES: usize = 8;

instructions! { "avx2,fma":
    ramp() -> __m256 = _mm256_setr_ps(0., 1., 2., 3., 4., 5., 6., 7.);
    above(a: __m256, b: __m256) -> __m256 = _mm256_cmp_ps::<_CMP_GT_OQ>(a, b);
    differ(a: __m256, b: __m256) -> __m256 = _mm256_cmp_ps::<_CMP_NEQ_OQ>(a, b);
    // As unsigned numbers, negative ones are beyond any count
    is_at_most(a: __m256i, most: __m256i) -> __m256i = _mm256_cmpeq_epi32(_mm256_max_epu32(a, most), most);
    within(place: __m256i, count: i32) -> __m256 = _mm256_castsi256_ps(is_at_most(place, splat_whole(count - 1)));
    bits(mask: __m256) -> u32 = _mm256_movemask_ps(mask) as u32;
    choose(mask: __m256, a: __m256, b: __m256) -> __m256 = _mm256_blendv_ps(b, a, mask);
    choose_mask(mask: __m256, a: __m256, b: __m256) -> __m256 = choose(mask, a, b);
    choose_whole(mask: __m256, a: __m256i, b: __m256i) -> __m256i =
        _mm256_castps_si256(choose(mask, _mm256_castsi256_ps(a), _mm256_castsi256_ps(b)));
}

walk!("avx2,fma", __m256, __m256i, __m256);

/// e^x for x ≤ 0 to 2e-7; below −87, where f32 ends, that of −87.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn exp(x: __m256) -> __m256 {
    let x = max(x, splat(-87.0));
    let whole = _mm256_cvtps_epi32(mul(x, splat(LOG2_E)));
    let f = fused_less(_mm256_cvtepi32_ps(whole), splat(LN_2), x);
    let mut sum = splat(1.0 / 720.0);
    for c in [1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0] {
        sum = fused(sum, f, splat(c));
    }
    let power = _mm256_slli_epi32::<23>(add_whole(whole, splat_whole(127)));
    mul(sum, _mm256_castsi256_ps(power))
}

/// Adds what a segment leaves in a slab, times a pixel's value.
///
/// # Safety
/// AVX2 and FMA; all voxels of the grid lie behind `dose`, and nobody else touches those of this slab.
#[target_feature(enable = "avx2,fma")]
pub(super) unsafe fn add_slab(
    ways: Ways,
    slab: usize,
    segment: &Segment,
    value: f32,
    dose: *mut f32,
) {
    each_piece(ways, slab, &spread(segment, value), |voxel, deposit| {
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
    let (mut sum, spread) = (0.0, spread(segment, 1.0));
    for slab in slabs {
        each_piece(ways, slab, &spread, |voxel, deposit| {
            // SAFETY: the voxels of pieces lie in the grid.
            sum += unsafe { dose.get_unchecked(voxel) } * deposit;
        });
    }
    sum
}
