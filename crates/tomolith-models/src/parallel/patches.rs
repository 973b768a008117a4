//! Columns and patches of 2 × 2 voxels: `out[i][z] += Σ weight[i] · source[slot][z]`, and its transpose.
//!
//! A pixel is wider than a voxel, so most columns that light a voxel light its neighbors, too. What is read of a column serves four voxels, which are
//! held in registers: a multiply-add takes a third of the reads of one that serves a single voxel ([`kernel`](super::kernel)). Paths are chosen at
//! run time as there.
#![cfg_attr(
    target_arch = "x86_64",
    expect(
        unsafe_code,
        reason = "kernel file: registers and run-time dispatch need intrinsics"
    )
)]

use super::block_sparsity::LENGTHS;
use super::kernel::{Block, Isa};
use std::ops::Range;
use tomolith_core::field::LANES;

/// Voxels of a patch, row by row.
pub(super) const VOXELS: usize = 4;

/// A column's slot, and what it counts in the voxels of a patch.
pub(super) type ColumnEntry = (u32, [f32; VOXELS]);

/// What columns bring to the patches of a tile, patch by patch.
#[derive(Default)]
pub(super) struct Patches {
    slots: Vec<u32>,
    weights: Vec<[f32; VOXELS]>,
    /// First entry of each patch, and where the last one's end; empty where there are no entries.
    starts: Vec<u32>,
    /// One more than the highest slot.
    rows: u32,
}

impl Patches {
    /// All patches one after the other.
    pub(super) fn new(patches: &[Vec<ColumnEntry>]) -> Self {
        let of_patch = |sum: &mut u32, patch: &Vec<_>| {
            *sum += patch.len() as u32;
            Some(*sum)
        };
        let ends = patches.iter().scan(0, of_patch);
        let starts: Vec<u32> = std::iter::once(0).chain(ends).collect();
        if starts.last() == Some(&0) {
            return Patches::default();
        }
        // Their number is known: vectors that grow would take twice the time
        let count = starts.last().map_or(0, |&count| count as usize);
        let (mut slots, mut weights) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for &(slot, of_slot) in patches.iter().flatten() {
            slots.push(slot);
            weights.push(of_slot);
        }
        Patches {
            rows: slots.iter().fold(0, |rows, &slot| rows.max(slot + 1)),
            weights,
            slots,
            starts,
        }
    }

    /// One more than the highest slot; 0 where there are no entries.
    pub(super) fn rows(&self) -> usize {
        self.rows as usize
    }

    /// How many entries there are.
    #[cfg(test)]
    pub(super) fn len(&self) -> usize {
        self.slots.len()
    }

    pub(super) fn slots(&self) -> &[u32] {
        &self.slots
    }

    /// Slot and weights of those entries of a patch that are of a range of slots; slots of a patch rise.
    pub(super) fn of_slots(
        &self,
        patch: usize,
        slots: Range<u32>,
    ) -> impl Iterator<Item = (u32, &[f32; VOXELS])> + Clone {
        let entries = match self.starts.get(patch..=patch + 1) {
            Some(starts) => starts[0] as usize..starts[1] as usize,
            None => 0..0,
        };
        let place =
            |slot: u32| entries.start + self.slots[entries.clone()].partition_point(|&s| s < slot);
        let entries = place(slots.start)..place(slots.end);
        self.slots[entries.clone()]
            .iter()
            .copied()
            .zip(&self.weights[entries])
    }

    /// All entries of a patch, for rows that are counted from `first` on; None where there are none.
    pub(super) fn of(&self, patch: usize, first: u32) -> Option<PatchEntries<'_>> {
        let [start, end] = [0, 1].map(|i| self.starts.get(patch + i).map(|&start| start as usize));
        let entries = start?..end?;
        (!entries.is_empty()).then(|| PatchEntries {
            first,
            rows: self.rows,
            slots: &self.slots[entries.clone()],
            weights: &self.weights[entries],
            chosen: None,
        })
    }
}

/// Columns that light a patch: row `slots[i] − first` counts `weights[i]` in its voxels.
#[derive(Clone, Copy)]
pub(super) struct PatchEntries<'a> {
    first: u32,
    /// Above all slots.
    rows: u32,
    slots: &'a [u32],
    weights: &'a [[f32; VOXELS]],
    /// Which of them count, where not all do: indices below their number.
    chosen: Option<&'a [u32]>,
}

impl<'a> PatchEntries<'a> {
    /// Those whose slot `keep` wants, kept in `chosen`.
    pub(super) fn choose(self, chosen: &'a mut Vec<u32>, keep: impl Fn(u32) -> bool) -> Self {
        if chosen.len() < self.slots.len() {
            chosen.resize(self.slots.len(), 0);
        }
        let mut count = 0;
        for (i, &slot) in self.slots.iter().enumerate() {
            // Written either way: no branch to guess
            chosen[count] = i as u32;
            count += usize::from(keep(slot));
        }
        PatchEntries {
            chosen: Some(&chosen[..count]),
            ..self
        }
    }

    /// Whether none counts.
    pub(super) fn is_empty(&self) -> bool {
        self.chosen.is_some_and(<[u32]>::is_empty)
    }

    /// Row and weights of those that count, in order.
    fn each(&self, mut see: impl FnMut(usize, &[f32; VOXELS])) {
        let row = |slot: u32| slot.wrapping_sub(self.first) as usize;
        match self.chosen {
            None => (self.slots.iter().zip(self.weights))
                .for_each(|(&slot, weights)| see(row(slot), weights)),
            Some(chosen) => (chosen.iter().map(|&i| i as usize))
                .for_each(|i| see(row(self.slots[i]), &self.weights[i])),
        }
    }

    /// Refuses rows outside of so many.
    fn check(&self, rows: usize) {
        if self.first == 0 && self.rows as usize <= rows {
            return;
        }
        let mut highest = None;
        self.each(|row, _| highest = highest.max(Some(row)));
        assert!(
            highest.is_none_or(|highest| highest < rows),
            "slot outside the rows"
        );
    }
}

/// Vectors of 16 lanes in a short and in a long block at most, where rows stand for so many parts of the turn. With AVX2 24 lanes are summed at a time, so that
/// long blocks gain little, and in blocks of three the columns of a group of views and the voxels of a tile stay in a second-level cache of 512 kB, as processors
/// without AVX-512 have it. Rows of several parts are short, and stay there anyway.
pub(super) fn block_lengths(isa: Isa, parts: usize) -> [usize; 2] {
    match isa {
        Isa::Avx2 if parts == 1 => [3; 2],
        _ => LENGTHS,
    }
}

/// Asks for the lines of the cache that lanes lie in: they are read soon.
#[cfg_attr(not(target_arch = "x86_64"), expect(unused_variables))]
pub(super) fn prefetch(lanes: &[f32]) {
    #[cfg(target_arch = "x86_64")]
    for line in lanes.chunks(LANES) {
        // SAFETY: nothing is read; every x86-64 has the instruction.
        unsafe {
            use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
            _mm_prefetch::<_MM_HINT_T0>(line.as_ptr().cast());
        }
    }
}

/// out[i] += Σ weight[i] · source[slot], over the lanes of the block. `out` holds the block's lanes only; `source` whole rows.
///
/// # Panics
/// When a slot lies outside `source` or an `out` is too short.
pub(super) fn gather(
    isa: Isa,
    mut out: [&mut [f32]; VOXELS],
    source: &[f32],
    entries: PatchEntries,
    block: Block,
) {
    assert!(block.first + block.count <= block.row);
    assert!(out.iter().all(|out| out.len() >= block.count * LANES));
    entries.check(source.len() / (block.row * LANES));
    match isa {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: AVX-512F was detected (Isa values other than Scalar come from `available`); slots and block lie inside the slices, as just
        // asserted.
        Isa::Avx512 => unsafe { x86::gather(out.map(<[f32]>::as_mut_ptr), source, entries, block) },
        #[cfg(target_arch = "x86_64")]
        // SAFETY: AVX2 and FMA were detected, as above.
        Isa::Avx2 => unsafe {
            x86::gather_avx2(out.map(<[f32]>::as_mut_ptr), source, entries, block)
        },
        Isa::Neon => gather_plain::<true>(&mut out, source, entries, block),
        _ => gather_plain::<false>(&mut out, source, entries, block),
    }
}

/// rows[slot] += Σᵢ weight[i] · values[i], over the lanes of the block: the transpose of [`gather`]. `values` hold the block's lanes only;
/// `rows` are whole.
///
/// # Panics
/// When a slot lies outside `rows` or one of `values` is too short.
pub(super) fn spread(
    isa: Isa,
    rows: &mut [f32],
    values: [&[f32]; VOXELS],
    entries: PatchEntries,
    block: Block,
) {
    assert!(block.first + block.count <= block.row);
    assert!(values.iter().all(|v| v.len() >= block.count * LANES));
    entries.check(rows.len() / (block.row * LANES));
    match isa {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: as in `gather`.
        Isa::Avx512 => unsafe { x86::spread(rows, values.map(<[f32]>::as_ptr), entries, block) },
        #[cfg(target_arch = "x86_64")]
        // SAFETY: AVX2 and FMA were detected, as above.
        Isa::Avx2 => unsafe { x86::spread_avx2(rows, values.map(<[f32]>::as_ptr), entries, block) },
        Isa::Neon => spread_plain::<true>(rows, values, entries, block),
        _ => spread_plain::<false>(rows, values, entries, block),
    }
}

/// sum + a·b; fused where every machine of the path can.
#[inline(always)]
fn add<const FUSED: bool>(a: f32, b: f32, sum: f32) -> f32 {
    if FUSED {
        a.mul_add(b, sum)
    } else {
        sum + a * b
    }
}

/// The plain twin of [`gather`].
#[inline(always)]
fn gather_plain<const FUSED: bool>(
    out: &mut [&mut [f32]; VOXELS],
    source: &[f32],
    entries: PatchEntries,
    block: Block,
) {
    for v in 0..block.count {
        let mut sums = [[0.0; LANES]; VOXELS];
        for (sum, out) in sums.iter_mut().zip(out.iter()) {
            sum.copy_from_slice(&out[v * LANES..][..LANES]);
        }
        entries.each(|slot, weights| {
            let column = &source[(slot * block.row + block.first + v) * LANES..][..LANES];
            for (sum, &weight) in sums.iter_mut().zip(weights) {
                for (sum, &value) in sum.iter_mut().zip(column) {
                    *sum = add::<FUSED>(weight, value, *sum);
                }
            }
        });
        for (sum, out) in sums.iter().zip(out.iter_mut()) {
            out[v * LANES..][..LANES].copy_from_slice(sum);
        }
    }
}

/// The plain twin of [`spread`].
#[inline(always)]
fn spread_plain<const FUSED: bool>(
    rows: &mut [f32],
    values: [&[f32]; VOXELS],
    entries: PatchEntries,
    block: Block,
) {
    for v in 0..block.count {
        let of_voxel = values.map(|values| &values[v * LANES..][..LANES]);
        entries.each(|slot, weights| {
            let column = &mut rows[(slot * block.row + block.first + v) * LANES..][..LANES];
            for (values, &weight) in of_voxel.iter().zip(weights) {
                for (sum, &value) in column.iter_mut().zip(*values) {
                    *sum = add::<FUSED>(weight, value, *sum);
                }
            }
        });
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::super::kernel::with_count;
    use super::{Block, LANES, PatchEntries, VOXELS};
    use std::arch::x86_64::*;

    /// Registers of a block in pieces of at most `held`, nearly equal: first and number.
    fn pieces(count: usize, held: usize) -> impl Iterator<Item = (usize, usize)> {
        let parts = count.div_ceil(held);
        (0..parts).map(move |i| {
            let (first, end) = (i * count / parts, (i + 1) * count / parts);
            (first, end - first)
        })
    }

    /// Both directions in registers of `$width` floats; of each voxel `$held` are held at most, as many as the last `$k`.
    macro_rules! kernels {
        ($features:literal, $register:ident, $width:literal, $held:literal, [$($k:literal)*],
         $load:ident, $store:ident, $splat:ident, $add:ident,
         $gather:ident, $gather_piece:ident, $spread:ident, $spread_piece:ident) => {
            /// # Safety
            /// The features; slots inside `source`, the block inside rows and every `out`.
            #[target_feature(enable = $features)]
            pub(super) unsafe fn $gather(
                out: [*mut f32; VOXELS],
                source: &[f32],
                entries: PatchEntries,
                block: Block,
            ) {
                for (first, count) in pieces(block.count * LANES / $width, $held) {
                    // SAFETY: bounds are the caller's promise.
                    unsafe {
                        let base = source.as_ptr().add(block.first * LANES + first * $width);
                        let out = out.map(|out| out.add(first * $width));
                        let stride = block.row * LANES;
                        with_count!(count, $gather_piece, (out, base, stride, entries), [$($k)*]);
                    }
                }
            }

            /// # Safety
            /// As for all pieces together.
            #[target_feature(enable = $features)]
            #[inline]
            unsafe fn $gather_piece<const N: usize>(
                out: [*mut f32; VOXELS],
                base: *const f32,
                stride: usize,
                entries: PatchEntries,
            ) {
                // SAFETY: bounds are the caller's promise.
                unsafe {
                    let mut sums: [[$register; N]; VOXELS] =
                        out.map(|out| std::array::from_fn(|v| $load(out.add(v * $width))));
                    let mut add = |i: usize| {
                        let row = (*entries.slots.get_unchecked(i) - entries.first) as usize;
                        let from = base.add(row * stride);
                        let weights = entries.weights.get_unchecked(i);
                        let column: [$register; N] =
                            std::array::from_fn(|v| $load(from.add(v * $width)));
                        for (sums, &weight) in sums.iter_mut().zip(weights) {
                            let weight = $splat(weight);
                            for (sum, &value) in sums.iter_mut().zip(&column) {
                                *sum = $add(weight, value, *sum);
                            }
                        }
                    };
                    match entries.chosen {
                        None => {
                            for i in 0..entries.slots.len() {
                                add(i);
                            }
                        }
                        Some(chosen) => {
                            for &i in chosen {
                                add(i as usize);
                            }
                        }
                    }
                    for (sums, out) in sums.iter().zip(out) {
                        for (v, &sum) in sums.iter().enumerate() {
                            $store(out.add(v * $width), sum);
                        }
                    }
                }
            }

            /// # Safety
            /// The features; slots inside `rows`, the block inside rows and all `values`.
            #[target_feature(enable = $features)]
            pub(super) unsafe fn $spread(
                rows: &mut [f32],
                values: [*const f32; VOXELS],
                entries: PatchEntries,
                block: Block,
            ) {
                for (first, count) in pieces(block.count * LANES / $width, $held) {
                    // SAFETY: bounds are the caller's promise.
                    unsafe {
                        let base = rows.as_mut_ptr().add(block.first * LANES + first * $width);
                        let values = values.map(|values| values.add(first * $width));
                        let stride = block.row * LANES;
                        with_count!(count, $spread_piece, (base, values, stride, entries), [$($k)*]);
                    }
                }
            }

            /// # Safety
            /// As for all pieces together.
            #[target_feature(enable = $features)]
            #[inline]
            unsafe fn $spread_piece<const N: usize>(
                base: *mut f32,
                values: [*const f32; VOXELS],
                stride: usize,
                entries: PatchEntries,
            ) {
                // SAFETY: bounds are the caller's promise.
                unsafe {
                    let values: [[$register; N]; VOXELS] =
                        values.map(|from| std::array::from_fn(|v| $load(from.add(v * $width))));
                    let add = |i: usize| {
                        let row = (*entries.slots.get_unchecked(i) - entries.first) as usize;
                        let to = base.add(row * stride);
                        let weights = entries.weights.get_unchecked(i);
                        let mut sums: [$register; N] =
                            std::array::from_fn(|v| $load(to.add(v * $width)));
                        for (values, &weight) in values.iter().zip(weights) {
                            let weight = $splat(weight);
                            for (sum, &value) in sums.iter_mut().zip(values) {
                                *sum = $add(weight, value, *sum);
                            }
                        }
                        for (v, &sum) in sums.iter().enumerate() {
                            $store(to.add(v * $width), sum);
                        }
                    };
                    match entries.chosen {
                        None => {
                            for i in 0..entries.slots.len() {
                                add(i);
                            }
                        }
                        Some(chosen) => {
                            for &i in chosen {
                                add(i as usize);
                            }
                        }
                    }
                }
            }
        };
    }

    // Of 32 registers four voxels hold 24
    kernels!(
        "avx512f", __m512, 16, 6, [1 2 3 4 5 6],
        _mm512_loadu_ps, _mm512_storeu_ps, _mm512_set1_ps, _mm512_fmadd_ps,
        gather, gather_wide, spread, spread_wide
    );
    // Of 16 they hold twelve; a column and a weight fill the rest
    kernels!(
        "avx2,fma", __m256, 8, 3, [1 2 3],
        _mm256_loadu_ps, _mm256_storeu_ps, _mm256_set1_ps, _mm256_fmadd_ps,
        gather_avx2, gather_half, spread_avx2, spread_half
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::noise;

    const ROW: usize = 20;

    /// Rows of lanes, values of the voxels, and the columns of a patch.
    fn given(count: usize) -> (Vec<f32>, Vec<f32>, Vec<ColumnEntry>) {
        let weights = noise(3, 4 * VOXELS);
        let weights = weights.as_chunks().0.iter().copied();
        (
            noise(1, 5 * ROW * LANES),
            noise(2, VOXELS * count * LANES),
            [3, 0, 1, 4].into_iter().zip(weights).collect(),
        )
    }

    /// The columns that count: all but the first slot, or all.
    fn lit(columns: &[ColumnEntry], all: bool) -> Vec<ColumnEntry> {
        let counts = |column: &&ColumnEntry| all || column.0 != 0;
        columns.iter().filter(counts).copied().collect()
    }

    /// For every path, block, and all columns or some: rows and voxels, and what both directions make of them.
    fn on_every_path(see: impl Fn(Block, bool, [&[f32]; 2], [&[f32]; 2])) {
        let counts = [1, 2, 5, 6, 7, 13, 16];
        let cases = counts.into_iter().flat_map(|n| [(n, true), (n, false)]);
        for isa in Isa::available() {
            for (count, all) in cases.clone() {
                let (rows, values, columns) = given(count);
                let patches = Patches::new(&[Vec::new(), columns]);
                let mut chosen = Vec::new();
                let mut entries = patches.of(1, 0).unwrap();
                if !all {
                    entries = entries.choose(&mut chosen, |slot| slot != 0);
                }
                let block = Block {
                    row: ROW,
                    first: ROW - count.max(4),
                    count,
                };
                let mut gathered = values.clone();
                let mut parts = gathered.chunks_mut(count * LANES);
                let out = [(); VOXELS].map(|()| parts.next().unwrap());
                gather(isa, out, &rows, entries, block);
                let mut summed = rows.clone();
                let of_voxel = |i| &values[i * count * LANES..(i + 1) * count * LANES];
                spread(isa, &mut summed, [0, 1, 2, 3].map(of_voxel), entries, block);
                see(block, all, [&rows, &values], [&summed, &gathered]);
            }
        }
    }

    #[test]
    fn every_path_is_the_sum_written_out() {
        on_every_path(|block, all, [rows, values], [summed, gathered]| {
            let lit = lit(&given(block.count).2, all);
            let lanes = block.count * LANES;
            let place = |slot: u32, lane| (slot as usize * ROW + block.first) * LANES + lane;
            for lane in 0..lanes {
                for i in 0..VOXELS {
                    let sum: f32 = (lit.iter())
                        .map(|(slot, weights)| weights[i] * rows[place(*slot, lane)])
                        .sum();
                    let at = i * lanes + lane;
                    assert!((gathered[at] - values[at] - sum).abs() < 1e-5);
                }
                for (slot, weights) in &lit {
                    let sum: f32 = (0..VOXELS)
                        .map(|i| weights[i] * values[i * lanes + lane])
                        .sum();
                    let at = place(*slot, lane);
                    assert!((summed[at] - rows[at] - sum).abs() < 1e-5);
                }
            }
            // What is left out, and lanes outside of the block, stay as they are
            if !all {
                let left_out = place(0, 0)..place(0, lanes);
                assert_eq!(summed[left_out.clone()], rows[left_out]);
            }
            assert_eq!(summed[..block.first * LANES], rows[..block.first * LANES]);
        });
    }

    #[test]
    fn a_patch_without_entries_has_none() {
        assert!(Patches::new(&[Vec::new(), Vec::new()]).of(1, 0).is_none());
        let patches = Patches::new(&[vec![(7, [1.0; VOXELS])], Vec::new()]);
        assert_eq!((patches.rows(), patches.len()), (8, 1));
        assert!(patches.of(0, 0).is_some() && patches.of(1, 0).is_none());
    }

    /// Spreads a column of slot 1 to a single row, counted from `first` on.
    fn spread_beyond(first: u32) {
        let patches = Patches::new(&[vec![(1, [1.0; VOXELS])]]);
        let block = Block {
            row: 1,
            first: 0,
            count: 1,
        };
        spread(
            Isa::in_use(),
            &mut [0.0; 16],
            [&[0.0; 16]; VOXELS],
            patches.of(0, first).unwrap(),
            block,
        );
    }

    #[test]
    #[should_panic(expected = "slot outside")]
    fn a_slot_before_the_rows_is_refused() {
        spread_beyond(2);
    }

    #[test]
    #[should_panic(expected = "slot outside")]
    fn a_slot_after_the_rows_is_refused() {
        spread_beyond(0);
    }
}
