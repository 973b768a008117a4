//! The walk of a segment through voxels: the exact integral of Beer–Lambert over each cell it passes.
//!
//! # Equation
//! From p to q within a cell of the major axis, with rate κ: ∫ e^(−κ(a − enter)) da = e^(−κ(p − enter))·(q − p)·φ(κ(q − p)),
//! φ(x) = (1 − e^(−x))/x. In a cell of a the segment crosses at most one face of b and one of c; the two crossings cut it
//! into three pieces, each in one voxel. What the pieces take adds up to what the segment loses, since the next one
//! begins with what the last one left.
//!
//! # Cost
//! Sixteen cells of a at a time: three masked gathers (and scatters) and some sixty vector operations for 16 to 48 voxels
//! (AVX-512), or eight, and voxels one by one (AVX2); everywhere else the plain twin, cell by cell.
//!
//! # Numbers
//! Coordinates are f32, so a face is met to 1e-4 of a voxel at 1000 voxels; both directions of the model use the same numbers.
#![expect(
    unsafe_code,
    reason = "kernel file: gathers and shared slabs need intrinsics and pointers"
)]

#[cfg(target_arch = "x86_64")]
mod eight;
#[cfg(target_arch = "x86_64")]
mod walk;
#[cfg(target_arch = "x86_64")]
mod wide;

use super::segment::{Lattice, Segment, others};
use crate::parallel::kernel::Isa;
use tomolith_core::parallel::InParallel;

/// Cells of the major axis that one vector holds: the width of a slab.
pub(super) const SLAB: usize = 16;
/// Segments over less cells than this are walked cell by cell: most of sixteen lanes would be idle.
const SHORT: f32 = 2.5;
/// Above this attenuation per cell, differences of exponentials are exact enough and φ's series is not.
const OPAQUE: f32 = 0.5;
/// Up to this attenuation per cell the last four terms of φ's series give it to 1e-8.
#[cfg(target_arch = "x86_64")]
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
    /// Sixteen cells at a time.
    Wide,
    /// Eight.
    Eight,
    Plain,
}

impl Gait {
    /// That of the [instructions in use](Isa::in_use).
    pub(super) fn in_use() -> Self {
        match Isa::in_use() {
            Isa::Avx512 => Gait::Wide,
            Isa::Avx2 => Gait::Eight,
            _ => Gait::Plain,
        }
    }

    fn over(self, segment: &Segment) -> Self {
        let is_short = segment.high - segment.low < SHORT;
        match self {
            Gait::Eight if segment.rate.abs() > OPAQUE => Gait::Plain,
            _ if is_short => Gait::Plain,
            gait => gait,
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
            Gait::Wide => unsafe { wide::add_slab(ways, slab, segment, value, dose.0) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX2 and FMA were detected; the rest is the caller's promise.
            Gait::Eight => unsafe { eight::add_slab(ways, slab, segment, value, dose.0) },
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
        #[cfg(target_arch = "x86_64")]
        // SAFETY: AVX2 and FMA were detected; pieces lie in the dose, as asserted.
        Gait::Eight => unsafe { sum += eight::collect(ways, first..end, segment, dose) },
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
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX2 and FMA were detected.
            Gait::Eight => unsafe { eight::for_each(ways, slab, segment, &mut visit) },
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

/// The plain twin: calls `visit(voxel, deposit)` for every piece in a slab.
fn plain(ways: Ways, slab: usize, segment: &Segment, mut visit: impl FnMut(usize, f32)) {
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
