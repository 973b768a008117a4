//! The inner loop: `out[z] += Σ weight · source[slot][z]` over a block of z lanes.
//!
//! Dose and adjoint both end here. A block of up to 16 × 16 lanes is held in registers while the sources
//! stream by; per entry and 16 lanes that is one load and one fused multiply-add. The path is chosen at run time
//! (AVX-512, AVX2 + FMA, NEON, plain); `TOMOLITH_ISA` = `avx512`, `avx2`, `neon` or `scalar` forces one.
#![expect(
    unsafe_code,
    reason = "kernel file: registers and run-time dispatch need intrinsics"
)]

use std::sync::OnceLock;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::LANES;

/// Vectors of 16 lanes that a block has at most.
pub(crate) const MAX_BLOCK: usize = 16;

/// Weighted rows of lanes: `slots[i]` counts `weights[i]` times.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entries<'a> {
    pub(crate) slots: &'a [u32],
    pub(crate) weights: &'a [f32],
}

impl Entries<'_> {
    fn iter(&self) -> impl Iterator<Item = (usize, f32)> {
        self.slots
            .iter()
            .zip(self.weights)
            .map(|(&slot, &weight)| (slot as usize, weight))
    }
}

/// Rows of lanes: `row` vectors of 16 floats each, of which a block `first..first + count` is used.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    pub(crate) row: usize,
    pub(crate) first: usize,
    pub(crate) count: usize,
}

/// An instruction set that this program has a path for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Isa {
    /// 16 floats a register, x86-64.
    Avx512,
    /// 8 floats a register with fused multiply-add, x86-64.
    Avx2,
    /// 4 floats a register, 64-bit Arm.
    Neon,
    /// What every machine has.
    Scalar,
}

impl Isa {
    /// The paths this machine can run, best first.
    #[must_use]
    pub fn available() -> Vec<Isa> {
        let mut found = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            if std::arch::is_x86_feature_detected!("avx512f") {
                found.push(Isa::Avx512);
            }
            if std::arch::is_x86_feature_detected!("avx2")
                && std::arch::is_x86_feature_detected!("fma")
            {
                found.push(Isa::Avx2);
            }
        }
        #[cfg(target_arch = "aarch64")]
        found.push(Isa::Neon);
        found.push(Isa::Scalar);
        found
    }

    /// The path in use: the best one, or the one that `TOMOLITH_ISA` names.
    #[must_use]
    pub fn in_use() -> Isa {
        static CHOICE: OnceLock<Isa> = OnceLock::new();
        *CHOICE.get_or_init(|| Isa::asked().unwrap_or(Isa::available()[0]))
    }

    /// The path that `TOMOLITH_ISA` names, or the best one where it names none.
    ///
    /// # Errors
    /// [`Error::Config`] for a name that is none of this machine's.
    pub fn asked() -> Result<Isa> {
        let available = Isa::available();
        let asked = std::env::var_os("TOMOLITH_ISA").unwrap_or_default();
        if asked.is_empty() {
            return Ok(available[0]);
        }
        let named = available.iter().find(|isa| asked == isa.name());
        named.copied().ok_or_else(|| {
            let names: Vec<&str> = available.iter().map(|isa| isa.name()).collect();
            Error::config(
                "TOMOLITH_ISA",
                format!("found {asked:?}"),
                format!(
                    "{}, which this machine has; or nothing, for the first of them",
                    names.join(", ")
                ),
            )
        })
    }

    /// Its name, as in `TOMOLITH_ISA`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Isa::Avx512 => "avx512",
            Isa::Avx2 => "avx2",
            Isa::Neon => "neon",
            Isa::Scalar => "scalar",
        }
    }
}

/// out += Σ weight · source[slot], over the lanes of the block. `out` holds the block's lanes only; `source` whole rows.
///
/// # Panics
/// When a slot lies outside `source` or `out` is too short: the check is one comparison per entry.
pub(crate) fn accumulate(
    isa: Isa,
    out: &mut [f32],
    source: &[f32],
    entries: Entries,
    block: Block,
) {
    let Block { row, first, count } = block;
    assert!(count <= MAX_BLOCK && first + count <= row && out.len() >= count * LANES);
    let rows = source.len() / (row * LANES);
    let highest = match isa {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: AVX-512F was detected (Isa values other than Scalar come from `available`).
        Isa::Avx512 => unsafe { x86::highest(entries.slots) },
        _ => highest(entries.slots),
    };
    assert!(
        (highest as usize) < rows || entries.slots.is_empty(),
        "slot outside the source"
    );
    match isa {
        #[cfg(target_arch = "x86_64")]
        // SAFETY: AVX-512F was detected, as above; slots and block lie inside the slices, as just asserted.
        Isa::Avx512 => unsafe { x86::avx512(out, source, entries, block) },
        #[cfg(target_arch = "x86_64")]
        // SAFETY: as above, AVX2 and FMA.
        Isa::Avx2 => unsafe { x86::avx2(out, source, entries, block) },
        #[cfg(target_arch = "aarch64")]
        // SAFETY: NEON is part of the architecture; bounds as above.
        Isa::Neon => unsafe { arm::neon(out, source, entries, block) },
        _ => scalar(out, source, entries, block),
    }
}

/// out[i] += weights[i] · source[first[i] + tap], eight at a time with AVX2, to the bits of the plain sum. The first of eight neighbors is the lowest, and the
/// others lie within sixteen elements from it on.
///
/// # Panics
/// Without AVX2; when sixteen elements from a first one on reach beyond `source`, or lengths differ.
pub(super) fn add_looked_up(
    out: &mut [f32],
    weights: &[f32],
    source: &[f32],
    first: &[u32],
    tap: usize,
) {
    assert!(out.len() == weights.len() && out.len() == first.len());
    #[cfg(target_arch = "x86_64")]
    {
        assert!(std::arch::is_x86_feature_detected!("avx2"), "no AVX2");
        // SAFETY: AVX2 was detected.
        unsafe { x86::add_looked_up(out, weights, source, first, tap) }
    }
    #[cfg(not(target_arch = "x86_64"))]
    unreachable!("no AVX2: {tap} {}", source.len());
}

/// The highest slot, 0 when there is none.
#[inline]
fn highest(slots: &[u32]) -> u32 {
    slots.iter().fold(0, |m, &slot| m.max(slot))
}

/// The plain twin.
fn scalar(out: &mut [f32], source: &[f32], entries: Entries, block: Block) {
    let lanes = block.count * LANES;
    for (slot, weight) in entries.iter() {
        let from = (slot * block.row + block.first) * LANES;
        for (o, s) in out[..lanes].iter_mut().zip(&source[from..from + lanes]) {
            *o += weight * s;
        }
    }
}

/// Calls `$f::<N>` with N = `$n`, one of `$k`.
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
macro_rules! with_count {
    ($n:expr, $f:ident, $args:tt, [$($k:literal)*]) => {
        match $n { $($k => with_count!(! $f, $k, $args),)* _ => {} }
    };
    (! $f:ident, $k:literal, ($($arg:expr),*)) => { $f::<$k>($($arg),*) };
}
#[cfg(target_arch = "x86_64")]
pub(super) use with_count;

/// A path in registers of `$width` floats; of a block `$held` vectors are held at a time, as many as the last `$k`.
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64"))]
macro_rules! path {
    ($features:literal, $register:ident, $width:literal, $held:literal, [$($k:literal)*],
     $load:ident, $store:ident, $splat:ident, $add:expr, $path:ident, $piece:ident) => {
        /// # Safety
        /// The features; slots inside `source`, the block inside rows and `out`.
        #[target_feature(enable = $features)]
        pub(super) unsafe fn $path(out: &mut [f32], source: &[f32], entries: Entries, block: Block) {
            let Block { row, first, count } = block;
            for begin in (0..count).step_by($held) {
                let n = (count - begin).min($held);
                // SAFETY: bounds are the caller's promise.
                unsafe {
                    let base = source.as_ptr().add((first + begin) * LANES);
                    let to = out.as_mut_ptr().add(begin * LANES);
                    with_count!(n, $piece, (to, base, row * LANES, entries), [$($k)*]);
                }
            }
        }

        /// # Safety
        /// As for all pieces together.
        #[target_feature(enable = $features)]
        #[inline]
        unsafe fn $piece<const N: usize>(
            to: *mut f32,
            base: *const f32,
            stride: usize,
            entries: Entries,
        ) {
            let place = |v: usize, i: usize| v * LANES + i * $width;
            // SAFETY: bounds are the caller's promise.
            unsafe {
                let mut sums: [[$register; LANES / $width]; N] = std::array::from_fn(|v| {
                    std::array::from_fn(|i| $load(to.add(place(v, i))))
                });
                for (slot, weight) in entries.iter() {
                    let weight = $splat(weight);
                    let from = base.add(slot * stride);
                    for (v, sums) in sums.iter_mut().enumerate() {
                        for (i, sum) in sums.iter_mut().enumerate() {
                            *sum = $add(weight, $load(from.add(place(v, i))), *sum);
                        }
                    }
                }
                for (v, sums) in sums.iter().enumerate() {
                    for (i, sum) in sums.iter().enumerate() {
                        $store(to.add(place(v, i)), *sum);
                    }
                }
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Block, Entries, LANES};
    use std::arch::x86_64::*;

    /// [`highest`](super::highest), sixteen at a time: the common instruction set has no maximum of integers.
    #[target_feature(enable = "avx512f")]
    pub(super) fn highest(slots: &[u32]) -> u32 {
        super::highest(slots)
    }

    path!(
        "avx512f", __m512, 16, 16, [1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16],
        _mm512_loadu_ps, _mm512_storeu_ps, _mm512_set1_ps, _mm512_fmadd_ps, avx512, wide
    );
    // Six vectors of 16 lanes fill twelve of the sixteen registers
    path!(
        "avx2,fma", __m256, 8, 6, [1 2 3 4 5 6],
        _mm256_loadu_ps, _mm256_storeu_ps, _mm256_set1_ps, _mm256_fmadd_ps, avx2, half
    );

    /// See [`add_looked_up`](super::add_looked_up).
    #[target_feature(enable = "avx2")]
    pub(super) fn add_looked_up(
        out: &mut [f32],
        weights: &[f32],
        source: &[f32],
        first: &[u32],
        tap: usize,
    ) {
        let (eights, rest) = out.as_chunks_mut::<8>();
        let (of_eights, of_rest) = weights.as_chunks::<8>();
        let (firsts, firsts_of_rest) = first.as_chunks::<8>();
        for ((out, weights), first) in eights.iter_mut().zip(of_eights).zip(firsts) {
            let window = &source[first[0] as usize + tap..][..16];
            // SAFETY: the window has sixteen floats, and all others eight.
            unsafe {
                let place = _mm256_sub_epi32(
                    _mm256_loadu_si256(first.as_ptr().cast()),
                    _mm256_set1_epi32(first[0] as i32),
                );
                let [low, high] = [0, 8].map(|i| _mm256_loadu_ps(window.as_ptr().add(i)));
                let is_high = _mm256_cmpgt_epi32(place, _mm256_set1_epi32(7));
                let value = _mm256_blendv_ps(
                    _mm256_permutevar8x32_ps(low, place),
                    _mm256_permutevar8x32_ps(high, place),
                    _mm256_castsi256_ps(is_high),
                );
                let term = _mm256_mul_ps(_mm256_loadu_ps(weights.as_ptr()), value);
                let sum = _mm256_add_ps(_mm256_loadu_ps(out.as_ptr()), term);
                _mm256_storeu_ps(out.as_mut_ptr(), sum);
            }
        }
        for ((out, weight), first) in rest.iter_mut().zip(of_rest).zip(firsts_of_rest) {
            *out += weight * source[*first as usize + tap];
        }
    }
}

#[cfg(target_arch = "aarch64")]
mod arm {
    use super::{Block, Entries, LANES};
    use std::arch::aarch64::*;

    path!(
        "neon", float32x4_t, 4, 6, [1 2 3 4 5 6],
        vld1q_f32, vst1q_f32, vdupq_n_f32, |weight, value, sum| vfmaq_f32(sum, weight, value),
        neon, quads
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_path_equals_the_plain_twin() {
        let row = 20;
        let source: Vec<f32> = (0..row * LANES * 5)
            .map(|i| ((i * 7919) % 1000) as f32 / 999.0 - 0.4)
            .collect();
        let slots: Vec<u32> = (0..9).map(|i| (i * 3) % 5).collect();
        let weights: Vec<f32> = (0..9).map(|i| 0.1 * i as f32 - 0.3).collect();
        let entries = Entries {
            slots: &slots,
            weights: &weights,
        };
        for isa in Isa::available() {
            for count in 1..=MAX_BLOCK {
                let block = Block {
                    row,
                    first: 20 - count.max(4),
                    count,
                };
                let mut plain = vec![0.25f32; count * LANES];
                let mut fast = plain.clone();
                scalar(&mut plain, &source, entries, block);
                accumulate(isa, &mut fast, &source, entries, block);
                for (p, f) in plain.iter().zip(&fast) {
                    assert!((p - f).abs() <= 1e-6, "{isa:?} {count}: {p} {f}");
                }
            }
        }
    }

    #[test]
    #[should_panic(expected = "slot outside")]
    fn a_slot_outside_the_source_is_refused() {
        let entries = Entries {
            slots: &[1],
            weights: &[1.0],
        };
        accumulate(
            Isa::in_use(),
            &mut [0.0; 16],
            &[0.0; 16],
            entries,
            Block {
                row: 1,
                first: 0,
                count: 1,
            },
        );
    }
}
