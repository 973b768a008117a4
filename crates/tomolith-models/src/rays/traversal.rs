//! The walk of a segment through voxels: the exact integral of Beer–Lambert over each cell it passes.
//!
//! # Equation
//! From p to q within a cell of the major axis, with rate κ: ∫ e^(−κ(a − enter)) da = e^(−κ(p − enter))·(q − p)·φ(κ(q − p)),
//! φ(x) = (1 − e^(−x))/x. In a cell of a the segment crosses at most one face of b and one of c; the two crossings cut it
//! into three pieces, each in one voxel. What the pieces take adds up to what the segment loses, since the next one
//! begins with what the last one left.
//!
//! # Cost
//! Sixteen cells of a at a time: three masked gathers (and scatters) and some sixty vector operations for 16 to 48 voxels.
//! AVX-512; everywhere else the plain twin, cell by cell.
//!
//! # Numbers
//! Coordinates are f32, so a face is met to 1e-4 of a voxel at 1000 voxels; both directions of the model use the same numbers.
#![expect(
    unsafe_code,
    reason = "kernel file: gathers and shared slabs need intrinsics and pointers"
)]

use super::segment::{Lattice, Segment, others};
use tomolith_core::parallel::InParallel;

/// Cells of the major axis that one vector holds: the width of a slab.
pub(super) const SLAB: usize = 16;
/// Segments over less cells than this are walked cell by cell: most of sixteen lanes would be idle.
const SHORT: f32 = 2.5;
/// Above this attenuation per cell, differences of exponentials are exact enough and φ's series is not.
const OPAQUE: f32 = 0.5;
/// Up to this attenuation per cell the last four terms of φ's series give it to 1e-8.
const THIN: f32 = 0.03;

/// What a walk needs of the grid, for one major axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ways {
    /// Voxels along the major axis and the other two.
    pub(super) counts: [i32; 3],
    /// Floats from one voxel to the next along them.
    strides: [i32; 3],
}

impl Ways {
    pub(super) fn new(lattice: &Lattice, axis: usize) -> Self {
        let [b, c] = others(axis);
        Ways {
            counts: [axis, b, c].map(|i| lattice.counts[i] as i32),
            strides: [axis, b, c].map(|i| lattice.strides[i] as i32),
        }
    }

    /// Slabs across the major axis.
    fn slabs(&self) -> usize {
        (self.counts[0] as usize).div_ceil(SLAB)
    }
}

/// A dose that several tasks write at once, each in a slab of its own.
struct Shared(*mut f32);

// SAFETY: `add` gives every slab to one task, and `add_slab` writes only voxels of its slab.
unsafe impl Sync for Shared {}

/// How a walk is done: one per machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Gait {
    Wide,
    Plain,
}

impl Gait {
    pub(super) fn best() -> Self {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx512f") {
            return Gait::Wide;
        }
        Gait::Plain
    }
}

impl Gait {
    /// The walk for a segment.
    fn over(self, segment: &Segment) -> Self {
        if segment.high - segment.low < SHORT {
            Gait::Plain
        } else {
            self
        }
    }
}

/// Adds what segments of one major axis leave in the dose: their energy times the pixel's value in `x`. In every voxel
/// segments are summed in their order, on any number of threads.
pub(super) fn add(gait: Gait, ways: Ways, segments: &[Segment], x: &[f32], dose: &mut [f32]) {
    assert!(fits(ways, dose.len()), "a dose of another shape");
    let shared = Shared(dose.as_mut_ptr());
    let shared = &shared;
    (0..ways.slabs()).par_each(|slab| {
        // SAFETY: the voxels of the grid lie in `dose`, as just asserted, and this slab is this task's alone.
        unsafe { add_slab(gait, ways, slab, segments, x, shared) };
    });
}

/// # Safety
/// All voxels of the grid lie behind `dose`, and nobody else touches those of this slab meanwhile.
unsafe fn add_slab(
    gait: Gait,
    ways: Ways,
    slab: usize,
    segments: &[Segment],
    x: &[f32],
    dose: &Shared,
) {
    let first = (slab * SLAB) as f32;
    let within = |s: &&Segment| s.low < first + SLAB as f32 && s.high > first;
    for segment in segments.iter().filter(within) {
        let value = x[segment.pixel as usize];
        if value == 0.0 {
            continue;
        }
        match gait.over(segment) {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX-512F was detected; the rest is the caller's promise.
            Gait::Wide => unsafe { wide::add(ways, first, segment, value, dose.0) },
            _ => plain(ways, slab, segment, |voxel, deposit| {
                // SAFETY: the caller's promise.
                unsafe { *dose.0.add(voxel) += value * deposit };
            }),
        }
    }
}

/// Σ deposit · dose over all voxels of a segment.
pub(super) fn collect(gait: Gait, ways: Ways, segment: &Segment, dose: &[f32]) -> f32 {
    assert!(fits(ways, dose.len()), "a dose of another shape");
    let first = (segment.low.max(0.0) as usize) / SLAB;
    let end = (segment.high as usize / SLAB + 1).min(ways.slabs());
    let mut sum = 0.0f32;
    match gait.over(segment) {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: AVX-512F was detected; pieces lie in the dose, as asserted.
        Gait::Wide => unsafe { sum += wide::collect(ways, first..end, segment, dose) },
        _ => {
            for slab in first..end {
                plain(ways, slab, segment, |voxel, deposit| {
                    sum += deposit * dose[voxel]
                });
            }
        }
    }
    sum
}

/// Calls `visit(voxel, deposit)` for every piece of a segment.
pub(super) fn for_each(
    gait: Gait,
    ways: Ways,
    segment: &Segment,
    mut visit: impl FnMut(usize, f32),
) {
    let first = (segment.low.max(0.0) as usize) / SLAB;
    let end = (segment.high as usize / SLAB + 1).min(ways.slabs());
    for slab in first..end {
        match gait.over(segment) {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX-512F was detected.
            Gait::Wide => unsafe { wide::for_each(ways, slab, segment, &mut visit) },
            _ => plain(ways, slab, segment, &mut visit),
        }
    }
}

/// Whether the last voxel lies within so many floats.
fn fits(ways: Ways, len: usize) -> bool {
    let last: usize = (0..3)
        .map(|i| (ways.counts[i] - 1) as usize * ways.strides[i] as usize)
        .sum();
    last < len && i32::try_from(len).is_ok()
}

/// (1 − e^(−x))/x for |x| ≤ 0.5, to 1e-8.
fn phi(x: f32) -> f32 {
    PHI.iter().fold(0.0, |sum, &c| sum * x + c)
}

/// Coefficients of φ's series, (−1)^n/(n + 1)!, highest first.
const PHI: [f32; 8] = [
    -1.0 / 40320.0,
    1.0 / 5040.0,
    -1.0 / 720.0,
    1.0 / 120.0,
    -1.0 / 24.0,
    1.0 / 6.0,
    -0.5,
    1.0,
];

/// What is left at `a` of what entered.
fn left(segment: &Segment, a: f32) -> f32 {
    (-segment.rate * (a - segment.enter)).min(0.0).exp()
}

/// The plain twin: calls `visit(voxel, deposit)` for every piece in a slab. Compiled for AVX2, too, which rounds down in one instruction: the same
/// bits.
fn plain(ways: Ways, slab: usize, segment: &Segment, visit: impl FnMut(usize, f32)) {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        #[target_feature(enable = "avx2")]
        fn avx2(ways: Ways, slab: usize, segment: &Segment, visit: impl FnMut(usize, f32)) {
            walk(ways, slab, segment, visit);
        }
        // SAFETY: AVX2 was detected.
        return unsafe { avx2(ways, slab, segment, visit) };
    }
    walk(ways, slab, segment, visit);
}

#[inline(always)]
fn walk(ways: Ways, slab: usize, segment: &Segment, mut visit: impl FnMut(usize, f32)) {
    let end = ((slab + 1) * SLAB).min(ways.counts[0] as usize);
    for cell in slab * SLAB..end {
        let (begin, end) = (
            segment.low.max(cell as f32),
            segment.high.min(cell as f32 + 1.0),
        );
        if end <= begin {
            continue;
        }
        let along = |i: usize, a: f32| (segment.slope[i] * a + segment.offset[i]).floor();
        let cells: [[f32; 2]; 2] = std::array::from_fn(|i| [along(i, begin), along(i, end)]);
        // Where the faces of b and c are crossed; at the end when they are not
        let crossing: [f32; 2] = std::array::from_fn(|i| {
            let [before, after] = cells[i];
            if before == after {
                return end;
            }
            let face = before.max(after);
            ((face - segment.offset[i]) / segment.slope[i])
                .max(begin)
                .min(end)
        });
        let b_first = crossing[0] < crossing[1];
        let cuts = [
            begin,
            crossing[0].min(crossing[1]),
            crossing[0].max(crossing[1]),
            end,
        ];
        let places = [
            [cells[0][0], cells[1][0]],
            if b_first {
                [cells[0][1], cells[1][0]]
            } else {
                [cells[0][0], cells[1][1]]
            },
            [cells[0][1], cells[1][1]],
        ];
        let mut power = segment.energy * left(segment, begin);
        for (i, [b, c]) in places.into_iter().enumerate() {
            let way = cuts[i + 1] - cuts[i];
            let x = segment.rate * way;
            let deposit = if segment.rate.abs() > OPAQUE {
                let lost = left(segment, cuts[i]) - left(segment, cuts[i + 1]);
                segment.energy * lost / segment.rate
            } else {
                power * way * phi(x)
            };
            power -= segment.rate * deposit;
            let [b, c] = [b as i32, c as i32];
            if way > 0.0 && (0..ways.counts[1]).contains(&b) && (0..ways.counts[2]).contains(&c) {
                let voxel =
                    cell as i32 * ways.strides[0] + b * ways.strides[1] + c * ways.strides[2];
                visit(voxel as usize, deposit);
            }
        }
    }
}

#[cfg(target_arch = "x86_64")]
mod wide {
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
    fn pieces(
        ways: Ways,
        first: f32,
        s: &Spread,
        mut visit: impl FnMut(__mmask16, __m512i, __m512),
    ) {
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
    pub(super) unsafe fn add(
        ways: Ways,
        first: f32,
        segment: &Segment,
        value: f32,
        dose: *mut f32,
    ) {
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
}
