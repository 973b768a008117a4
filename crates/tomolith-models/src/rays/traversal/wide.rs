//! The walk in vectors of sixteen cells, for AVX-512.

use super::{OPAQUE, PHI, SLAB, Segment, THIN, Ways};
use crate::parallel::chains::avx512::exp16;
use std::arch::x86_64::*;
use std::ops::Range;

/// A segment, spread over vectors.
struct Spread {
    offset: [__m512; 2],
    slope: [__m512; 2],
    steep: [__m512; 2],
    low: __m512,
    high: __m512,
    enter: __m512,
    rate: __m512,
    energy: __m512,
    opaque: bool,
    thin: bool,
    /// Slope of b, of c is not 0: there are faces to cross.
    crosses: [bool; 2],
}

/// Where sixteen cells are, along one of the other two axes.
struct Side {
    /// Floats to the first voxel, and to the one behind the face.
    voxel: [__m512i; 2],
    /// Whether those lie in the grid.
    within: [__mmask16; 2],
    /// Where the face is crossed; at the end where none is.
    crossing: __m512,
}

#[target_feature(enable = "avx512f")]
#[inline]
fn spread(segment: &Segment) -> Spread {
    let all = _mm512_set1_ps;
    Spread {
        offset: segment.offset.map(|v| all(v)),
        slope: segment.slope.map(|v| all(v)),
        steep: segment.slope.map(|v| all(1.0 / v)),
        low: all(segment.low),
        high: all(segment.high),
        enter: all(segment.enter),
        rate: all(segment.rate),
        energy: all(segment.energy),
        opaque: segment.rate.abs() > OPAQUE,
        thin: segment.rate.abs() <= THIN,
        crosses: segment.slope.map(|v| v != 0.0),
    }
}

#[target_feature(enable = "avx512f")]
#[inline]
fn floor(x: __m512) -> __m512 {
    _mm512_roundscale_ps::<{ _MM_FROUND_TO_NEG_INF }>(x)
}

#[target_feature(enable = "avx512f")]
#[inline]
fn phi(x: __m512, thin: bool) -> __m512 {
    let series = |sum, &c: &f32| _mm512_fmadd_ps(sum, x, _mm512_set1_ps(c));
    let (high, low) = PHI.split_at(PHI.len() / 2);
    let sum = _mm512_setzero_ps();
    low.iter().fold(
        if thin {
            sum
        } else {
            high.iter().fold(sum, series)
        },
        series,
    )
}

/// What is left at `a` of what entered.
#[target_feature(enable = "avx512f")]
#[inline]
fn left(s: &Spread, a: __m512) -> __m512 {
    let depth = _mm512_mul_ps(s.rate, _mm512_sub_ps(a, s.enter));
    exp16(_mm512_min_ps(
        _mm512_sub_ps(_mm512_setzero_ps(), depth),
        _mm512_setzero_ps(),
    ))
}

/// The voxels between `begin` and `end` of each cell along axis `i` of the other two.
#[target_feature(enable = "avx512f")]
#[inline]
fn side(ways: Ways, s: &Spread, i: usize, begin: __m512, end: __m512) -> Side {
    let stride = _mm512_set1_epi32(ways.strides[i + 1]);
    let count = _mm512_set1_epi32(ways.counts[i + 1]);
    let at = |a| floor(_mm512_fmadd_ps(s.slope[i], a, s.offset[i]));
    let voxel = |place| _mm512_mullo_epi32(place, stride);
    // As unsigned numbers, negative ones are beyond any count
    let within = |place| _mm512_cmplt_epu32_mask(place, count);
    let first = at(begin);
    let place = _mm512_cvttps_epi32(first);
    if !s.crosses[i] {
        return Side {
            voxel: [voxel(place); 2],
            within: [within(place); 2],
            crossing: end,
        };
    }
    let last = at(end);
    let differs = _mm512_cmp_ps_mask::<_CMP_NEQ_OQ>(first, last);
    let face = _mm512_max_ps(first, last);
    let meets = _mm512_mul_ps(_mm512_sub_ps(face, s.offset[i]), s.steep[i]);
    let meets = _mm512_min_ps(_mm512_max_ps(meets, begin), end);
    let behind = _mm512_cvttps_epi32(last);
    Side {
        voxel: [voxel(place), voxel(behind)],
        within: [within(place), within(behind)],
        crossing: _mm512_mask_mov_ps(end, differs, meets),
    }
}

/// Calls `visit(lit, voxels, deposits)` for the pieces, at most three, in the cells from `first` on. Within a piece the
/// sixteen voxels differ: they lie in different cells of the major axis.
#[target_feature(enable = "avx512f")]
#[inline]
fn pieces(ways: Ways, first: f32, s: &Spread, mut visit: impl FnMut(__mmask16, __m512i, __m512)) {
    let ramp = _mm512_setr_ps(
        0., 1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 13., 14., 15.,
    );
    let cell = _mm512_add_ps(_mm512_set1_ps(first), ramp);
    let begin = _mm512_max_ps(s.low, cell);
    let end = _mm512_min_ps(s.high, _mm512_add_ps(cell, _mm512_set1_ps(1.0)));
    let lit = _mm512_cmp_ps_mask::<_CMP_GT_OQ>(end, begin);
    let along = _mm512_mullo_epi32(
        _mm512_cvttps_epi32(cell),
        _mm512_set1_epi32(ways.strides[0]),
    );
    let [b, c] = [0, 1].map(|i| side(ways, s, i, begin, end));
    let mut power = _mm512_mul_ps(s.energy, left(s, begin));
    let mut piece = |from, to, within: __mmask16, at_b, at_c| {
        let way = _mm512_sub_ps(to, from);
        let lit = _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(lit, way, _mm512_setzero_ps());
        if lit == 0 {
            return;
        }
        let deposit = if s.opaque {
            let lost = _mm512_sub_ps(left(s, from), left(s, to));
            _mm512_div_ps(_mm512_mul_ps(s.energy, lost), s.rate)
        } else {
            let x = _mm512_mul_ps(s.rate, way);
            _mm512_mul_ps(_mm512_mul_ps(power, way), phi(x, s.thin))
        };
        power = _mm512_fnmadd_ps(s.rate, deposit, power);
        let voxel = _mm512_add_epi32(along, _mm512_add_epi32(at_b, at_c));
        visit(lit & within, voxel, deposit);
    };
    // What comes first is where the first voxels of both are, what comes last where the last ones are
    let cut = _mm512_min_ps(b.crossing, c.crossing);
    piece(
        begin,
        cut,
        b.within[0] & c.within[0],
        b.voxel[0],
        c.voxel[0],
    );
    if s.crosses[0] && s.crosses[1] {
        let b_first = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(b.crossing, c.crossing);
        let behind = _mm512_max_ps(b.crossing, c.crossing);
        piece(
            cut,
            behind,
            b_first & b.within[1] & c.within[0] | !b_first & b.within[0] & c.within[1],
            _mm512_mask_mov_epi32(b.voxel[0], b_first, b.voxel[1]),
            _mm512_mask_mov_epi32(c.voxel[1], b_first, c.voxel[0]),
        );
        piece(
            behind,
            end,
            b.within[1] & c.within[1],
            b.voxel[1],
            c.voxel[1],
        );
    } else if s.crosses[0] || s.crosses[1] {
        piece(cut, end, b.within[1] & c.within[1], b.voxel[1], c.voxel[1]);
    }
}

/// # Safety
/// AVX-512F.
#[target_feature(enable = "avx512f")]
pub(super) unsafe fn for_each(
    ways: Ways,
    slab: usize,
    segment: &Segment,
    visit: &mut impl FnMut(usize, f32),
) {
    let spread = spread(segment);
    pieces(
        ways,
        (slab * SLAB) as f32,
        &spread,
        |lit, voxel, deposit| {
            let (mut voxels, mut deposits) = ([0i32; 16], [0.0f32; 16]);
            // SAFETY: sixteen numbers each.
            unsafe {
                _mm512_storeu_epi32(voxels.as_mut_ptr(), voxel);
                _mm512_storeu_ps(deposits.as_mut_ptr(), deposit);
            }
            for i in (0..16).filter(|i| lit >> i & 1 == 1) {
                visit(voxels[i] as usize, deposits[i]);
            }
        },
    );
}

/// # Safety
/// AVX-512F; all voxels of the grid lie behind `dose`, and nobody else touches those of this slab.
#[target_feature(enable = "avx512f")]
pub(super) unsafe fn add(ways: Ways, first: f32, segment: &Segment, value: f32, dose: *mut f32) {
    let mut spread = spread(segment);
    spread.energy = _mm512_mul_ps(spread.energy, _mm512_set1_ps(value));
    pieces(ways, first, &spread, |lit, voxel, deposit| {
        // SAFETY: lanes in `lit` are voxels of the grid, in this slab, and they differ.
        unsafe {
            let zero = _mm512_setzero_ps();
            let old = _mm512_mask_i32gather_ps::<4>(zero, lit, voxel, dose);
            let new = _mm512_add_ps(old, deposit);
            _mm512_mask_i32scatter_ps::<4>(dose, lit, voxel, new);
        }
    });
}

/// # Safety
/// AVX-512F; all voxels of the grid lie in `dose`.
#[target_feature(enable = "avx512f")]
pub(super) unsafe fn collect(
    ways: Ways,
    slabs: Range<usize>,
    segment: &Segment,
    dose: &[f32],
) -> f32 {
    let spread = spread(segment);
    let mut sum = _mm512_setzero_ps();
    for slab in slabs {
        pieces(
            ways,
            (slab * SLAB) as f32,
            &spread,
            |lit, voxel, deposit| {
                let zero = _mm512_setzero_ps();
                // SAFETY: lanes in `lit` are voxels of the grid.
                let values =
                    unsafe { _mm512_mask_i32gather_ps::<4>(zero, lit, voxel, dose.as_ptr()) };
                sum = _mm512_mask3_fmadd_ps(values, deposit, sum, lit);
            },
        );
    }
    _mm512_reduce_add_ps(sum)
}
