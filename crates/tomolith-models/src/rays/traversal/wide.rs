//! The walk in vectors of sixteen cells, for AVX-512.

use super::walk::{instructions, walk};
use super::{OPAQUE, PHI, SLAB, Segment, THIN, Ways};
use crate::parallel::chains::avx512::exp16 as exp;
use std::arch::x86_64::{
    __m512, __m512i, __mmask16, _CMP_GT_OQ, _CMP_NEQ_OQ, _MM_FROUND_TO_NEG_INF,
    _mm512_add_epi32 as add_whole, _mm512_add_ps as add, _mm512_cmp_ps_mask,
    _mm512_cmplt_epu32_mask, _mm512_cvttps_epi32 as whole, _mm512_div_ps as div,
    _mm512_fmadd_ps as fused, _mm512_fnmadd_ps as fused_less, _mm512_mask_blend_epi32,
    _mm512_mask_blend_ps, _mm512_mask_i32gather_ps, _mm512_mask_i32scatter_ps,
    _mm512_mask3_fmadd_ps, _mm512_max_ps as max, _mm512_min_ps as min, _mm512_mul_ps as mul,
    _mm512_mullo_epi32 as mul_whole, _mm512_reduce_add_ps, _mm512_roundscale_ps,
    _mm512_set1_epi32 as splat_whole, _mm512_set1_ps as splat, _mm512_setr_ps,
    _mm512_storeu_ps as store, _mm512_storeu_si512 as store_whole, _mm512_sub_ps as sub,
};
use std::ops::Range;

/// Cells of a vector.
const LANES: usize = 16;

instructions! { "avx512f":
    ramp() -> __m512 = _mm512_setr_ps(0., 1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 13., 14., 15.);
    floor(x: __m512) -> __m512 = _mm512_roundscale_ps::<{ _MM_FROUND_TO_NEG_INF }>(x);
    above(a: __m512, b: __m512) -> __mmask16 = _mm512_cmp_ps_mask::<_CMP_GT_OQ>(a, b);
    differ(a: __m512, b: __m512) -> __mmask16 = _mm512_cmp_ps_mask::<_CMP_NEQ_OQ>(a, b);
    // As unsigned numbers, negative ones are beyond any count
    within(place: __m512i, count: i32) -> __mmask16 = _mm512_cmplt_epu32_mask(place, splat_whole(count));
    both(a: __mmask16, b: __mmask16) -> __mmask16 = a & b;
    bits(mask: __mmask16) -> u32 = u32::from(mask);
    choose(mask: __mmask16, a: __m512, b: __m512) -> __m512 = _mm512_mask_blend_ps(mask, b, a);
    choose_whole(mask: __mmask16, a: __m512i, b: __m512i) -> __m512i = _mm512_mask_blend_epi32(mask, b, a);
    choose_mask(mask: __mmask16, a: __mmask16, b: __mmask16) -> __mmask16 = mask & a | !mask & b;
}

walk!("avx512f", __m512, __m512i, __mmask16);

/// Adds what a segment leaves in a slab, times a pixel's value.
///
/// # Safety
/// AVX-512F; all voxels of the grid lie behind `dose`, and nobody else touches those of this slab.
#[target_feature(enable = "avx512f")]
pub(super) unsafe fn add_slab(
    ways: Ways,
    slab: usize,
    segment: &Segment,
    value: f32,
    dose: *mut f32,
) {
    let first = (slab * SLAB) as f32;
    pieces(
        ways,
        first,
        &spread(segment, value),
        |lit, voxel, deposit| {
            // SAFETY: lanes in `lit` are voxels of the grid, in this slab, and they differ.
            unsafe {
                let old = _mm512_mask_i32gather_ps::<4>(splat(0.0), lit, voxel, dose);
                _mm512_mask_i32scatter_ps::<4>(dose, lit, voxel, add(old, deposit));
            }
        },
    );
}

/// Σ deposit · dose over the voxels of a segment in some slabs.
///
/// # Safety
/// AVX-512F; all voxels of the grid lie in `dose`.
#[target_feature(enable = "avx512f")]
pub(super) unsafe fn collect(
    ways: Ways,
    slabs: Range<usize>,
    segment: &Segment,
    dose: &[f32],
) -> f32 {
    let spread = spread(segment, 1.0);
    let (zero, dose) = (splat(0.0), dose.as_ptr());
    let mut sum = zero;
    for slab in slabs {
        pieces(
            ways,
            (slab * SLAB) as f32,
            &spread,
            |lit, voxel, deposit| {
                // SAFETY: lanes in `lit` are voxels of the grid.
                let values = unsafe { _mm512_mask_i32gather_ps::<4>(zero, lit, voxel, dose) };
                sum = _mm512_mask3_fmadd_ps(values, deposit, sum, lit);
            },
        );
    }
    _mm512_reduce_add_ps(sum)
}
