//! Chains: strips side by side that share edges, where geometry is a vector operation.
//!
//! Nearly every (tile, beam) is a *chain*: neighboring columns, common edges, no resin wall within the tile. There the
//! enumerator of [`tiles`](super::tiles) becomes arithmetic on sixteen rows (for a strip) or sixteen voxels (for a row) at a
//! time, with the very same formulas, so that dose and adjoint stay one matrix. AVX-512 only; other machines and all
//! other tiles take the plain way.
#![cfg_attr(
    target_arch = "x86_64",
    expect(
        unsafe_code,
        reason = "kernel file: vector arithmetic needs intrinsics"
    )
)]
#![cfg_attr(
    not(target_arch = "x86_64"),
    expect(unused, reason = "only kernels of AVX-512 read chains")
)]

use super::strips::{Beam, Columns};
#[cfg(doc)]
use super::tiles::NARROWEST_IN_CHAIN;
use super::tiles::{Local, TILE, TileEntries};
use super::uniform_strips::{Integrals, Square};

/// A chain of strips of one beam, seen from a tile.
#[derive(Clone, Copy)]
pub(super) struct Chain<'a> {
    pub(super) columns: &'a Columns,
    /// First strip, and number of strips.
    pub(super) first: usize,
    pub(super) count: usize,
    pub(super) upward: bool,
    /// Column number of the first strip.
    pub(super) column: u32,
}

impl<'a> Chain<'a> {
    pub(super) fn new(beam: &'a Beam, first: usize, end: usize) -> Self {
        Chain {
            columns: &beam.columns,
            first,
            count: end - first,
            upward: beam.strips[first].upward,
            column: beam.strips[first].column,
        }
    }

    /// Pixel columns of the strips, in their order.
    pub(super) fn columns_of_pixels(&self) -> impl Iterator<Item = usize> + use<> {
        let (first, step) = (i64::from(self.column), i64::from(self.columns.step));
        (0..self.count as i64).map(move |i| (first + step * i) as usize)
    }
}

/// Floats of two registers: among so many neighbors one instruction looks up sixteen.
pub(super) const LOOKED_UP: usize = 32;

/// Proof that this machine has AVX-512F.
#[derive(Clone, Copy, Debug)]
pub(super) struct Avx512(());

#[cfg_attr(
    not(target_arch = "x86_64"),
    expect(unused_variables, reason = "no such machine")
)]
impl Avx512 {
    /// None where it was not detected.
    pub(super) fn detect() -> Option<Self> {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx512f") {
            return Some(Avx512(()));
        }
        None
    }

    /// out[i] += weights[i] · source[first[i] + tap]; `near` promises that sixteen neighbors of `first` lie within [`LOOKED_UP`]
    /// elements from the first of them on.
    ///
    /// # Panics
    /// When an index, where they are near plus [`LOOKED_UP`], lies outside `source`, or lengths differ.
    pub(super) fn add_gathered(
        self,
        out: &mut [f32],
        weights: &[f32],
        source: &[f32],
        first: &[u32],
        tap: usize,
        near: bool,
    ) {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: `self` proves that AVX-512F was detected.
        unsafe {
            avx512::add_gathered(out, weights, source, first, tap, near);
        }
    }

    /// Appends what a chain lights in a tile, strip after strip; `keep` says which columns count.
    pub(super) fn add_chain(
        self,
        chain: &Chain,
        local: &Local,
        keep: impl Fn(u32) -> bool,
        out: &mut TileEntries,
    ) {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: `self` proves that AVX-512F was detected.
        unsafe {
            avx512::add_chain(chain, local, keep, out);
        }
    }

    pub(super) fn find_taps(self, taps: &mut Taps, chain: &Chain, local: &Local) {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: `self` proves that AVX-512F was detected.
        unsafe {
            taps.find(chain, local);
        }
    }

    /// Adds to the voxels of a tile's single slice, `[row][across]` of the chain, what the taps bring of the pixels in
    /// `window`.
    pub(super) fn add_taps(
        self,
        taps: &Taps,
        rows: usize,
        window: &[f32; WINDOW],
        out: &mut Square,
    ) {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: `self` proves that AVX-512F was detected.
        unsafe {
            avx512::add_taps(taps, rows, window, out);
        }
    }

    /// What the cotangent of a tile's single slice gives to the strips of a chain.
    pub(super) fn chain_adjoint(
        self,
        chain: &Chain,
        local: &Local,
        integrals: &Integrals,
    ) -> [f32; WINDOW] {
        let mut sums = [0.0; WINDOW];
        #[cfg(target_arch = "x86_64")]
        // SAFETY: `self` proves that AVX-512F was detected.
        unsafe {
            avx512::chain_adjoint(chain, local, integrals, &mut sums);
        }
        sums
    }
}

/// Strips of a chain as vectors: at most 63, and one more edge.
pub(super) const WINDOW: usize = 64;

/// Strips that cover a voxel at most: the narrowest of a chain are [`NARROWEST_IN_CHAIN`] wide.
const MOST_TAPS: usize = 5;

/// For each voxel of a tile: the first strip of a chain that covers some of it, and the weights of it and the next.
#[derive(Clone)]
pub(super) struct Taps {
    /// Strips that cover a voxel, at most; at least two, the second perhaps of no weight.
    taps: usize,
    /// The first strip of a voxel, counted from that of the chain.
    strip: [i32; TILE * TILE],
    weight: [[f32; TILE * TILE]; MOST_TAPS],
}

impl Default for Taps {
    fn default() -> Self {
        Taps {
            taps: 2,
            strip: [0; TILE * TILE],
            weight: [[0.0; TILE * TILE]; MOST_TAPS],
        }
    }
}

#[cfg(target_arch = "x86_64")]
pub(crate) mod avx512 {
    use super::super::tiles::{Local, MOST_IN_CHAIN, TILE, TileEntries};
    use super::super::uniform_strips::{Integrals, Square};
    use super::{Chain, LOOKED_UP, MOST_TAPS, Taps, WINDOW};
    use std::arch::x86_64::*;

    /// See [`Avx512::add_gathered`](super::Avx512::add_gathered).
    #[target_feature(enable = "avx512f")]
    pub(super) fn add_gathered(
        out: &mut [f32],
        weights: &[f32],
        source: &[f32],
        first: &[u32],
        tap: usize,
        near: bool,
    ) {
        let highest = first.iter().fold(0, |m, &i| m.max(i)) as usize;
        let behind = if near { LOOKED_UP } else { 1 };
        assert!(out.len() == weights.len() && out.len() == first.len());
        assert!(highest + tap + behind <= source.len() && source.len() < i32::MAX as usize);
        let from = source[tap..].as_ptr();
        for ((out, weights), first) in out
            .chunks_mut(16)
            .zip(weights.chunks(16))
            .zip(first.chunks(16))
        {
            let n = out.len();
            let mask: __mmask16 = if n == 16 { 0xffff } else { (1 << n) - 1 };
            // SAFETY: masked loads and stores touch the n elements of the chunks; gathered indices, and the elements behind the
            // first of them where they are near, were checked above.
            unsafe {
                let index = _mm512_maskz_loadu_epi32(mask, first.as_ptr().cast());
                let values = if near {
                    let window = from.add(first[0] as usize);
                    let place = _mm512_sub_epi32(index, _mm512_set1_epi32(first[0] as i32));
                    let (low, high) = (_mm512_loadu_ps(window), _mm512_loadu_ps(window.add(16)));
                    _mm512_permutex2var_ps(low, place, high)
                } else {
                    _mm512_mask_i32gather_ps::<4>(_mm512_setzero_ps(), mask, index, from)
                };
                let weight = _mm512_maskz_loadu_ps(mask, weights.as_ptr());
                let sum =
                    _mm512_fmadd_ps(weight, values, _mm512_maskz_loadu_ps(mask, out.as_ptr()));
                _mm512_mask_storeu_ps(out.as_mut_ptr(), mask, sum);
            }
        }
    }

    /// e^x for x ≤ 0 to 2e-7, sixteen at a time.
    #[target_feature(enable = "avx512f")]
    pub(crate) fn exp16(x: __m512) -> __m512 {
        let scaled = _mm512_mul_ps(x, _mm512_set1_ps(std::f32::consts::LOG2_E));
        let whole = _mm512_roundscale_ps::<{ _MM_FROUND_TO_NEAREST_INT }>(scaled);
        let f = _mm512_fnmadd_ps(whole, _mm512_set1_ps(std::f32::consts::LN_2), x);
        let term = |sum, c| _mm512_fmadd_ps(sum, f, _mm512_set1_ps(c));
        let mut sum = _mm512_set1_ps(1.0 / 720.0);
        for c in [1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0] {
            sum = term(sum, c);
        }
        _mm512_scalef_ps(sum, whole)
    }

    /// 1/x to 2e-7, cheaper than a division: an estimate of 14 bits and one step of Newton's.
    #[target_feature(enable = "avx512f")]
    fn inverse(x: __m512) -> __m512 {
        let estimate = _mm512_rcp14_ps(x);
        let error = _mm512_fnmadd_ps(x, estimate, _mm512_set1_ps(1.0));
        _mm512_fmadd_ps(estimate, error, estimate)
    }

    /// Reads sixteen values from `at` on.
    #[target_feature(enable = "avx512f")]
    fn load(values: &[f32], at: usize) -> __m512 {
        let window = &values[at..at + 16];
        // SAFETY: the window has sixteen floats.
        unsafe { _mm512_loadu_ps(window.as_ptr()) }
    }

    #[target_feature(enable = "avx512f")]
    fn store(to: &mut [f32], at: usize, values: __m512) {
        let window = &mut to[at..at + 16];
        // SAFETY: the window has sixteen floats.
        unsafe { _mm512_storeu_ps(window.as_mut_ptr(), values) }
    }

    #[target_feature(enable = "avx512f")]
    fn ramp() -> __m512 {
        _mm512_setr_ps(
            0., 1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 13., 14., 15.,
        )
    }

    /// Deposit of strips `at..at + 16` in the tile's first row.
    #[target_feature(enable = "avx512f")]
    fn first_row(chain: &Chain, local: &Local, at: usize) -> __m512 {
        let c = chain.columns;
        let (enter, per_row) = (load(&c.enter, at), load(&c.per_row, at));
        let row = _mm512_set1_ps(local.origin[0]);
        let depth = if chain.upward {
            _mm512_sub_ps(row, enter)
        } else {
            _mm512_sub_ps(enter, _mm512_add_ps(row, _mm512_set1_ps(1.0)))
        };
        let decay = exp16(_mm512_fnmadd_ps(per_row, depth, _mm512_setzero_ps()));
        _mm512_mul_ps(load(&c.full, at), decay)
    }

    /// See [`Avx512::add_chain`](super::Avx512::add_chain).
    #[target_feature(enable = "avx512f")]
    pub(super) fn add_chain(
        chain: &Chain,
        local: &Local,
        keep: impl Fn(u32) -> bool,
        out: &mut TileEntries,
    ) {
        let c = chain.columns;
        let mut energy = [0.0f32; MOST_IN_CHAIN + 1];
        for at in (0..chain.count).step_by(16) {
            store(&mut energy, at, first_row(chain, local, chain.first + at));
        }
        let middle = _mm512_add_ps(ramp(), _mm512_set1_ps(local.origin[0] + 0.5));
        let rows: __mmask16 = if local.rows == 16 {
            0xffff
        } else {
            (1 << local.rows) - 1
        };
        let beyond = _mm512_set1_ps(local.across as f32);
        let slot_of_row = _mm512_mullo_epi32(
            _mm512_cvttps_epi32(ramp()),
            _mm512_set1_epi32(local.row_step as i32),
        );
        let step = _mm512_set1_epi32(local.across_step as i32);
        let one = _mm512_set1_epi32(1);
        let direction = if chain.upward { -1.0 } else { 1.0 };
        // Strips of straight light all weaken alike
        let mut per_row = 0.0;
        let mut decay = _mm512_set1_ps(1.0);
        // Every edge cuts a voxel of a row at most
        let most = local.rows * (local.across + chain.count + 1) + 16;
        out.slots.reserve(most);
        out.weights.reserve(most);
        for (i, &energy) in energy.iter().enumerate().take(chain.count) {
            let column = (chain.column as i32 + c.step * i as i32) as u32;
            if !keep(column) {
                continue;
            }
            let at = chain.first + i;
            let edge = |at: usize| {
                let offset = _mm512_set1_ps(c.offset[at] - local.origin[1]);
                _mm512_fmadd_ps(_mm512_set1_ps(c.slope[at]), middle, offset)
            };
            let (left, right) = (edge(at), edge(at + 1));
            if c.per_row[at] != per_row {
                per_row = c.per_row[at];
                decay = exp16(_mm512_mul_ps(ramp(), _mm512_set1_ps(direction * per_row)));
            }
            let deposit = _mm512_mul_ps(_mm512_set1_ps(energy), decay);
            let density = _mm512_mul_ps(deposit, inverse(_mm512_sub_ps(right, left)));
            let left = _mm512_max_ps(left, _mm512_setzero_ps());
            let right = _mm512_min_ps(right, beyond);
            let mut voxel = _mm512_roundscale_ps::<{ _MM_FROUND_TO_ZERO }>(left);
            let begin = out.slots.len() as u32;
            let mut across = _mm512_cvttps_epi32(voxel);
            loop {
                let next = _mm512_add_ps(voxel, _mm512_set1_ps(1.0));
                let cover = _mm512_sub_ps(_mm512_min_ps(right, next), _mm512_max_ps(left, voxel));
                let lit = _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(rows, cover, _mm512_setzero_ps());
                let slot = _mm512_add_epi32(slot_of_row, _mm512_mullo_epi32(across, step));
                append(out, lit, slot, _mm512_mul_ps(cover, density));
                if _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(rows, right, next) == 0 {
                    break;
                }
                across = _mm512_add_epi32(across, one);
                voxel = next;
            }
            out.end_run(column, begin);
        }
    }

    /// Appends the chosen lanes to the entries, which have room for sixteen more.
    #[target_feature(enable = "avx512f")]
    fn append(out: &mut TileEntries, chosen: __mmask16, slots: __m512i, weights: __m512) {
        let len = out.slots.len();
        let count = chosen.count_ones() as usize;
        assert!(len + 16 <= out.slots.capacity() && len + 16 <= out.weights.capacity());
        // SAFETY: there are sixteen places behind `len` in both, and `count` ≤ 16 of them are then initialized.
        unsafe {
            let slots = _mm512_maskz_compress_epi32(chosen, slots);
            let weights = _mm512_maskz_compress_ps(chosen, weights);
            _mm512_storeu_epi32(out.slots.as_mut_ptr().add(len).cast(), slots);
            _mm512_storeu_ps(out.weights.as_mut_ptr().add(len), weights);
            out.slots.set_len(len + count);
            out.weights.set_len(len + count);
        }
    }

    impl Taps {
        /// See [`Avx512::find_taps`](super::Avx512::find_taps).
        #[target_feature(enable = "avx512f")]
        pub(in super::super) fn find(&mut self, chain: &Chain, local: &Local) {
            self.taps = 2;
            // Two registers hold 32 edges, four 64
            if chain.count < 32 {
                self.find_among::<2>(chain, local);
            } else {
                self.find_among::<4>(chain, local);
            }
        }

        #[target_feature(enable = "avx512f")]
        fn find_among<const H: usize>(&mut self, chain: &Chain, local: &Local) {
            let c = chain.columns;
            let parts: [usize; H] = std::array::from_fn(|h| chain.first + 16 * h);
            let sign = _mm512_set1_ps(if chain.upward { -1.0 } else { 1.0 });
            let mut energy = parts.map(|at| first_row(chain, local, at));
            let ratio = parts.map(|at| exp16(_mm512_mul_ps(load(&c.per_row, at), sign)));
            let slope = parts.map(|at| load(&c.slope, at));
            let corner = _mm512_set1_ps(local.origin[1]);
            let offset = parts.map(|at| _mm512_sub_ps(load(&c.offset, at), corner));
            let edges = |row: f32| -> [__m512; H] {
                let middle = _mm512_set1_ps(local.origin[0] + row + 0.5);
                std::array::from_fn(|h| _mm512_fmadd_ps(slope[h], middle, offset[h]))
            };
            // Edges are nearly evenly spaced: their mean distance is good for a guess
            let middle = edges(0.5 * local.rows as f32);
            let count = _mm512_set1_epi32(chain.count as i32);
            let span = _mm512_sub_ps(look(middle, count), look(middle, _mm512_setzero_si512()));
            let strips = Strips {
                per_voxel: _mm512_mul_ps(_mm512_cvtepi32_ps(count), inverse(span)),
                last: _mm512_sub_epi32(count, _mm512_set1_epi32(1)),
                inside: if local.across == 16 {
                    0xffff
                } else {
                    (1 << local.across) - 1
                },
            };
            for row in 0..local.rows {
                let edge = edges(row as f32);
                let density: [__m512; H] = std::array::from_fn(|h| {
                    let next = shift(edge[h], edge[(h + 1).min(H - 1)]);
                    _mm512_mul_ps(energy[h], inverse(_mm512_sub_ps(next, edge[h])))
                });
                self.find_row(row, edge, density, &strips);
                energy = std::array::from_fn(|h| _mm512_mul_ps(energy[h], ratio[h]));
            }
        }

        #[target_feature(enable = "avx512f")]
        #[inline]
        fn find_row<const H: usize>(
            &mut self,
            row: usize,
            edge: [__m512; H],
            density: [__m512; H],
            strips: &Strips,
        ) {
            let &Strips { last, inside, .. } = strips;
            let (zero, one) = (_mm512_setzero_si512(), _mm512_set1_epi32(1));
            let low = ramp();
            let high = _mm512_add_ps(low, _mm512_set1_ps(1.0));
            // Guess the strip, then step up or down until it fits
            let begin = _mm512_broadcastss_ps(_mm512_castps512_ps128(edge[0]));
            let guess = _mm512_mul_ps(_mm512_sub_ps(low, begin), strips.per_voxel);
            let guess = _mm512_min_epi32(_mm512_cvttps_epi32(guess), last);
            let mut strip = _mm512_max_epi32(guess, zero);
            let mut lower = look(edge, strip);
            let mut upper = look(edge, _mm512_add_epi32(strip, one));
            for _ in 0..MOST_IN_CHAIN {
                let not_last = _mm512_mask_cmplt_epi32_mask(inside, strip, last);
                let not_first = _mm512_mask_cmpgt_epi32_mask(inside, strip, zero);
                let above = _mm512_mask_cmp_ps_mask::<_CMP_LE_OQ>(not_last, upper, low);
                let below = _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(not_first, lower, low);
                if above | below == 0 {
                    break;
                }
                strip = _mm512_mask_add_epi32(strip, above, strip, one);
                strip = _mm512_mask_sub_epi32(strip, below, strip, one);
                lower = look(edge, strip);
                upper = look(edge, _mm512_add_epi32(strip, one));
            }
            let at = row * TILE;
            let to = &mut self.strip[at..at + 16];
            // SAFETY: sixteen numbers.
            unsafe {
                _mm512_storeu_epi32(to.as_mut_ptr(), _mm512_maskz_mov_epi32(inside, strip));
            }
            let mut from = _mm512_max_ps(low, lower);
            let mut lit: __mmask16 = inside;
            for tap in 0..MOST_TAPS {
                if tap >= self.taps {
                    // Rows before this one had no such tap
                    self.weight[tap][..at].fill(0.0);
                    self.taps = tap + 1;
                }
                let cover = _mm512_sub_ps(_mm512_min_ps(upper, high), from);
                lit = _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(lit, cover, _mm512_setzero_ps());
                let weight = _mm512_maskz_mul_ps(lit, cover, look(density, strip));
                store(&mut self.weight[tap], at, weight);
                // Voxels that reach beyond the strip
                let inner = _mm512_mask_cmplt_epi32_mask(inside, strip, last);
                lit = _mm512_mask_cmp_ps_mask::<_CMP_LT_OQ>(inner, upper, high);
                if lit == 0 {
                    for weights in &mut self.weight[tap + 1..self.taps.max(tap + 1)] {
                        store(weights, at, _mm512_setzero_ps());
                    }
                    break;
                }
                from = upper;
                strip = _mm512_add_epi32(strip, one);
                upper = look(edge, _mm512_add_epi32(strip, one));
            }
        }
    }

    /// What finding taps needs to know of a chain in every row.
    struct Strips {
        /// Mean number of strips per voxel, and number of the last strip.
        per_voxel: __m512,
        last: __m512i,
        /// Voxels of a row that are in the tile.
        inside: __mmask16,
    }

    /// Entries `i` (below 16·H) of a table in registers.
    #[target_feature(enable = "avx512f")]
    fn look<const H: usize>(table: [__m512; H], i: __m512i) -> __m512 {
        let low = _mm512_permutex2var_ps(table[0], i, table[1]);
        if H == 2 {
            return low;
        }
        let high = _mm512_permutex2var_ps(table[H - 2], i, table[H - 1]);
        let upper = _mm512_test_epi32_mask(i, _mm512_set1_epi32(32));
        _mm512_mask_mov_ps(low, upper, high)
    }

    /// Values one place further up, `last`'s lowest coming in at the top.
    #[target_feature(enable = "avx512f")]
    fn shift(values: __m512, last: __m512) -> __m512 {
        _mm512_castsi512_ps(_mm512_alignr_epi32::<1>(
            _mm512_castps_si512(last),
            _mm512_castps_si512(values),
        ))
    }

    /// See [`Avx512::add_taps`](super::Avx512::add_taps).
    #[target_feature(enable = "avx512f")]
    pub(super) fn add_taps(taps: &Taps, rows: usize, window: &[f32; WINDOW], out: &mut Square) {
        let table: [__m512; 4] = std::array::from_fn(|i| load(window, 16 * i));
        for at in (0..rows * TILE).step_by(TILE) {
            let strips = &taps.strip[at..at + 16];
            // SAFETY: sixteen numbers.
            let mut strip = unsafe { _mm512_loadu_epi32(strips.as_ptr()) };
            let mut sum = load(out, at);
            for weights in &taps.weight[..taps.taps] {
                sum = _mm512_fmadd_ps(load(weights, at), look(table, strip), sum);
                strip = _mm512_add_epi32(strip, _mm512_set1_epi32(1));
            }
            store(out, at, sum);
        }
    }

    /// See [`Avx512::chain_adjoint`](super::Avx512::chain_adjoint).
    #[target_feature(enable = "avx512f")]
    pub(super) fn chain_adjoint(
        chain: &Chain,
        local: &Local,
        integrals: &Integrals,
        sums: &mut [f32; WINDOW],
    ) {
        if chain.count < 32 {
            chain_adjoint_in::<2>(chain, local, integrals, sums);
        } else {
            chain_adjoint_in::<4>(chain, local, integrals, sums);
        }
    }

    /// A strip gets its density in each row times the integral of the cotangent between its edges.
    #[target_feature(enable = "avx512f")]
    fn chain_adjoint_in<const H: usize>(
        chain: &Chain,
        local: &Local,
        integrals: &Integrals,
        sums: &mut [f32; WINDOW],
    ) {
        let c = chain.columns;
        let parts: [usize; H] = std::array::from_fn(|h| chain.first + 16 * h);
        let sign = _mm512_set1_ps(if chain.upward { -1.0 } else { 1.0 });
        let mut energy = parts.map(|at| first_row(chain, local, at));
        let ratio = parts.map(|at| exp16(_mm512_mul_ps(load(&c.per_row, at), sign)));
        let slope = parts.map(|at| load(&c.slope, at));
        let corner = _mm512_set1_ps(local.origin[1]);
        let offset = parts.map(|at| _mm512_sub_ps(load(&c.offset, at), corner));
        let (zero, end) = (_mm512_setzero_ps(), _mm512_set1_ps(TILE as f32));
        let last = _mm512_set1_epi32(TILE as i32 - 1);
        let mut total = [zero; H];
        for row in 0..local.rows {
            let value = load(&integrals.value, row * TILE);
            let constant = load(&integrals.constant, row * TILE);
            let middle = _mm512_set1_ps(local.origin[0] + row as f32 + 0.5);
            let edge: [__m512; H] =
                std::array::from_fn(|h| _mm512_fmadd_ps(slope[h], middle, offset[h]));
            let integral = edge.map(|edge| {
                let edge = _mm512_min_ps(_mm512_max_ps(edge, zero), end);
                let voxel = _mm512_min_epi32(_mm512_cvttps_epi32(edge), last);
                let (value, constant) = (
                    _mm512_permutexvar_ps(voxel, value),
                    _mm512_permutexvar_ps(voxel, constant),
                );
                _mm512_fmadd_ps(edge, value, constant)
            });
            for h in 0..H {
                let next = (h + 1).min(H - 1);
                let width = _mm512_sub_ps(shift(edge[h], edge[next]), edge[h]);
                let between = _mm512_sub_ps(shift(integral[h], integral[next]), integral[h]);
                let density = _mm512_mul_ps(energy[h], inverse(width));
                total[h] = _mm512_fmadd_ps(density, between, total[h]);
                energy[h] = _mm512_mul_ps(energy[h], ratio[h]);
            }
        }
        for (h, total) in total.into_iter().enumerate() {
            store(sums, 16 * h, total);
        }
    }
}
