//! Slanted rays of all rows of a column: the ways of a [column ray](super::column_rays) that rises or falls.
//!
//! In each voxel (x, y) of the plane such rays rise by the same heights, so what they leave there lies in at most three slices,
//! and only the shares of these differ from row to row.
//!
//! # Equation
//! Heights count in slices. Row r enters the resin at s_r + h_r, s_r a whole number and 0 ≤ h_r < 1. On its way through a voxel of
//! the plane it then passes the heights from s_r + h_r + a to s_r + h_r + a + δ, δ ≤ 1, and leaves d there. With A = ⌊a⌋ and p = h_r + a − A:
//!
//! ```text
//! slice s_r + A       d·w₀,  w₀ = min(1, max(0, (1 − p)/δ))
//! slice s_r + A + 2   d·w₂,  w₂ = min(1, max(0, (p + δ − 2)/δ))
//! slice s_r + A + 1   what is left of d
//! ```
//! Beer–Lambert gives the part of the way that light passes first a little more: w₀ + β·w₀(1 − w₀) and w₂ − β·w₂(1 − w₂), with β = μ_t·s/2 for a way
//! s that rises, −μ_t·s/2 for one that falls.
//!
//! # Limits
//! β is the first term of a series: of a way whose light falls by a fraction ε, a share is wrong by 0.008·ε² at most, and the energy is right. Where ε may
//! exceed [`MOST_ABSORBED`] over a voxel pitch, rays are followed one by one.
//!
//! # Cost
//! Some fifteen operations a row and voxel of the plane, eight rows at a time with AVX2; the bits are those of the plain loop.
#![cfg_attr(
    target_arch = "x86_64",
    expect(unsafe_code, reason = "kernel file: run-time dispatch")
)]

use super::segment::Lattice;
use crate::parallel::kernel::Isa;
use std::array::from_fn;
use std::ops::Range;
use tomolith_optics::space::PathSegment;

/// Attenuation over a voxel pitch, at most.
pub(super) const MOST_ABSORBED: f64 = 0.1;

/// Slices that a way rises by, at least: what light of hardly any tilt is rounded up to.
const LEAST_SPAN: f32 = 1e-6;

/// `$f` as it is, or compiled for AVX2.
macro_rules! dispatch {
    ($isa:expr, $f:ident($($argument:expr),*)) => {
        match $isa {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX2 was detected (Isa values other than Scalar come from `available`).
            Isa::Avx512 | Isa::Avx2 => unsafe { avx2::$f($($argument),*) },
            _ => $f($($argument),*),
        }
    };
}

/// The rays of a column that begin in neighboring slices, or next to such.
pub(super) struct Slant {
    /// Slice in which the lowest row begins.
    pub(super) first: i32,
    /// h of the row that begins in each slice from that one on; 0 where none does.
    pub(super) heights: Vec<f32>,
    /// β of a way that rises by one slice.
    pub(super) bend: f32,
    pub(super) ways: Vec<Way>,
}

/// A way of equal rises through one voxel (x, y).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Way {
    pub(super) place: u32,
    pub(super) rise: f32,
    pub(super) span: f32,
    pub(super) deposit: f32,
}

/// How light of rows lies in the slices that a way rises through: p − h, 1/δ, β and what it leaves.
#[derive(Clone, Copy)]
struct Shape {
    rise: f32,
    steep: f32,
    bend: f32,
    deposit: f32,
}

impl Way {
    /// Whether no row reaches a third slice on it.
    fn is_short(self) -> bool {
        self.rise - self.rise.floor() + self.span <= 1.0
    }
}

/// The ways of a path segment through the plane, in the order of travel; each rises by one slice at most. `energy_mm2` as for
/// [`Lattice::segment`].
pub(super) fn ways(lattice: &Lattice, path: &PathSegment, energy_mm2: f64) -> Vec<Way> {
    let pitch = lattice.pitch();
    let direction = path.ray.direction.map(|v| v / pitch);
    let uptake = path.uptake;
    let density = uptake.active_per_mm * path.power * energy_mm2 / pitch.powi(3);
    let rate = uptake.attenuation_per_mm;
    let mut ways = Vec::with_capacity(lattice.counts[0] + lattice.counts[1]);
    let (mut at, mut power) = (0.0, density);
    // What light leaves on a way of such a length, and what goes on
    let mut pass = |length: f64| {
        let lost = -power * (-rate * length).exp_m1();
        let deposit = if rate == 0.0 {
            power * length
        } else {
            lost / rate
        };
        power -= lost;
        deposit
    };
    for_each_place(lattice, path, |place, from, to| {
        if from > at {
            pass(from - at);
        }
        at = to;
        let parts = (direction[2].abs() * (to - from)).ceil().max(1.0);
        let step = (to - from) / parts;
        for part in 0..parts as usize {
            let from = from + part as f64 * step;
            let (a, b) = (direction[2] * from, direction[2] * (from + step));
            ways.push(Way {
                place: place as u32,
                rise: a.min(b) as f32,
                span: ((a - b).abs() as f32).max(LEAST_SPAN),
                deposit: pass(step) as f32,
            });
        }
    });
    ways
}

/// Calls `visit(place, from, to)` for the voxels (x, y) that a path segment passes, with the way in mm where it enters and leaves them.
fn for_each_place(lattice: &Lattice, path: &PathSegment, mut visit: impl FnMut(usize, f64, f64)) {
    let from = lattice.place(path.ray.from);
    let counts = lattice.counts;
    let direction = path.ray.direction.map(|v| v / lattice.pitch());
    let (mut at, mut end) = (0.0f64, path.length);
    for i in 0..2 {
        let count = counts[i] as f64;
        if direction[i] == 0.0 {
            if !(0.0..count).contains(&from[i]) {
                return;
            }
            continue;
        }
        let faces = [-from[i] / direction[i], (count - from[i]) / direction[i]];
        at = at.max(faces[0].min(faces[1]));
        end = end.min(faces[0].max(faces[1]));
    }
    if at >= end {
        return;
    }
    let mut cell: [i64; 2] = from_fn(|i| {
        let cell = (from[i] + direction[i] * at).floor() as i64;
        cell.clamp(0, counts[i] as i64 - 1)
    });
    while at < end && (0..2).all(|i| (0..counts[i] as i64).contains(&cell[i])) {
        let face = |i: usize| match direction[i] {
            0.0 => f64::INFINITY,
            v => ((cell[i] + i64::from(v > 0.0)) as f64 - from[i]) / v,
        };
        let faces = [face(0), face(1)];
        let axis = usize::from(faces[1] < faces[0]);
        let next = faces[axis].min(end);
        if next > at {
            visit(cell[1] as usize * counts[0] + cell[0] as usize, at, next);
            at = next;
        }
        cell[axis] += if direction[axis] > 0.0 { 1 } else { -1 };
    }
}

impl Slant {
    /// The rays of rows that begin at these heights, in slices, none two in one: those that meet the grid, how many lie below them, and the
    /// lane of each. None where none does.
    pub(super) fn new(
        path: &PathSegment,
        pitch_mm: f64,
        ways: Vec<Way>,
        heights: impl Iterator<Item = f64>,
        slices: usize,
    ) -> Option<(Self, usize, Vec<u32>)> {
        let rises = || ways.iter().map(|way| f64::from(way.rise));
        let (lowest, highest) = (rises().reduce(f64::min)?, rises().reduce(f64::max)?);
        let mut heights = heights.peekable();
        let mut below = 0;
        while heights
            .next_if(|height| height + highest + 2.0 < 0.0)
            .is_some()
        {
            below += 1;
        }
        let first = heights.peek()?.floor();
        let (mut lanes, mut of_lanes) = (Vec::new(), Vec::new());
        for height in heights.take_while(|height| height + lowest < slices as f64) {
            let lane = (height.floor() - first) as usize;
            lanes.push(lane as u32);
            of_lanes.resize(lane + 1, 0.0);
            of_lanes[lane] = (height - height.floor()) as f32;
        }
        let rise = path.ray.direction[2];
        let rise = rise.abs().max(1e-9).copysign(rise);
        let slant = Slant {
            first: first as i32,
            heights: of_lanes,
            bend: (0.5 * path.uptake.attenuation_per_mm * pitch_mm / rise) as f32,
            ways,
        };
        (!lanes.is_empty()).then_some((slant, below, lanes))
    }

    /// Numbers that it consists of, in those of a way of level light.
    pub(super) fn numbers(&self) -> usize {
        2 * self.ways.len() + self.heights.len()
    }

    /// The ways through these places, which are whole lines of voxels along x: those follow each other.
    pub(super) fn ways_in(&self, places: &Range<u32>) -> &[Way] {
        let is_rising =
            self.ways.first().map(|way| way.place) <= self.ways.last().map(|way| way.place);
        let before = |place: u32| match is_rising {
            true => self.ways.partition_point(|way| way.place < place),
            false => self.ways.partition_point(|way| way.place >= place),
        };
        let [a, b] = [before(places.start), before(places.end)];
        &self.ways[a.min(b)..a.max(b)]
    }

    /// Room for [`add`](Self::add) and [`collect`](Self::collect).
    pub(super) fn room(&self) -> [Vec<f32>; 3] {
        [(); 3].map(|()| vec![0.0; self.heights.len() + 2])
    }

    /// A of a way, and its shape.
    fn on(&self, way: Way) -> (i32, Shape) {
        let whole = way.rise.floor();
        // A bound that only light which hardly rises reaches, whose span is rounded up
        let most = MOST_ABSORBED as f32;
        let bend = (self.bend * way.span).clamp(-most, most);
        let shape = Shape {
            rise: way.rise - whole,
            steep: 1.0 / way.span,
            bend,
            deposit: way.deposit,
        };
        (whole as i32, shape)
    }

    /// Lanes with a part in the slices 0 to `slices` of three that begin at `bottom`.
    fn in_grid(&self, bottom: i32, slices: usize) -> Range<usize> {
        let (count, end) = (self.heights.len() as i32, slices as i32 - bottom);
        let low = (-bottom - 2).clamp(0, count);
        low as usize..end.clamp(low, count) as usize
    }

    /// voxels += what rows of these values leave on a way
    pub(super) fn add(
        &self,
        isa: Isa,
        values: &[f32],
        way: Way,
        room: &mut [Vec<f32>; 3],
        voxels: &mut [f32],
    ) {
        let (whole, shape) = self.on(way);
        let bottom = self.first + whole;
        let lanes = self.in_grid(bottom, voxels.len());
        let end = (voxels.len() as i32 - bottom).max(0) as usize;
        let places = (-bottom).max(0) as usize..end.min(values.len() + 2);
        if places.is_empty() {
            return;
        }
        let first = (bottom + places.start as i32) as usize;
        let voxels = &mut voxels[first..first + places.len()];
        let [t0, t1, t2] = room;
        let low = &mut t0[lanes.clone()];
        let middle = &mut t1[lanes.start + 1..lanes.end + 1];
        let high = &mut t2[lanes.start + 2..lanes.end + 2];
        let (heights, values) = (&self.heights[lanes.clone()], &values[lanes]);
        if way.is_short() {
            dispatch!(isa, split(heights, values, shape, [low, middle]));
            dispatch!(isa, sum([t0, t1].map(|t| &t[places.clone()]), voxels));
        } else {
            dispatch!(isa, split(heights, values, shape, [low, middle, high]));
            dispatch!(isa, sum([t0, t1, t2].map(|t| &t[places.clone()]), voxels));
        }
    }

    /// lanes += what their rows collect on a way
    pub(super) fn collect(
        &self,
        isa: Isa,
        voxels: &[f32],
        way: Way,
        room: &mut [f32],
        lanes: &mut [f32],
    ) {
        let (whole, shape) = self.on(way);
        let bottom = self.first + whole;
        let range = self.in_grid(bottom, voxels.len());
        if range.is_empty() {
            return;
        }
        // The slices that these lanes reach, with zeros for those outside of the grid
        let room = &mut room[..range.len() + 2];
        let low = bottom + range.start as i32;
        let inside = (-low).max(0) as usize..((voxels.len() as i32 - low) as usize).min(room.len());
        room[..inside.start].fill(0.0);
        room[inside.end..].fill(0.0);
        let first = (low + inside.start as i32) as usize;
        room[inside.clone()].copy_from_slice(&voxels[first..first + inside.len()]);
        let count = range.len();
        let (heights, lanes) = (&self.heights[range.clone()], &mut lanes[range]);
        let [low, middle, high] = [0, 1, 2].map(|i| &room[i..i + count]);
        if way.is_short() {
            dispatch!(isa, join(heights, [low, middle], shape, lanes));
        } else {
            dispatch!(isa, join(heights, [low, middle, high], shape, lanes));
        }
    }
}

/// w₀ and w₂ of a row.
#[inline(always)]
fn shares(height: f32, shape: Shape) -> [f32; 2] {
    let Shape {
        rise, steep, bend, ..
    } = shape;
    let within = |share: f32| {
        let share = if share > 0.0 { share } else { 0.0 };
        if share < 1.0 { share } else { 1.0 }
    };
    let p = height + rise;
    let (low, high) = (within((1.0 - p) * steep), within((p - 2.0) * steep + 1.0));
    [
        low + bend * low * (1.0 - low),
        high - bend * high * (1.0 - high),
    ]
}

/// Parts: low, middle and, where rows reach it, high.
#[inline(always)]
fn split<const SLICES: usize>(
    heights: &[f32],
    values: &[f32],
    shape: Shape,
    parts: [&mut [f32]; SLICES],
) {
    let count = heights.len();
    let values = &values[..count];
    let parts = parts.map(|part| &mut part[..count]);
    for i in 0..count {
        let [w0, w2] = shares(heights[i], shape);
        let value = values[i] * shape.deposit;
        parts[0][i] = value * w0;
        if SLICES == 2 {
            parts[1][i] = value * (1.0 - w0);
        } else {
            parts[1][i] = value * (1.0 - w0 - w2);
            parts[2][i] = value * w2;
        }
    }
}

#[inline(always)]
fn sum<const SLICES: usize>(parts: [&[f32]; SLICES], out: &mut [f32]) {
    let parts = parts.map(|part| &part[..out.len()]);
    for i in 0..out.len() {
        out[i] += parts.iter().fold(0.0, |sum, part| sum + part[i]);
    }
}

#[inline(always)]
fn join<const SLICES: usize>(
    heights: &[f32],
    parts: [&[f32]; SLICES],
    shape: Shape,
    out: &mut [f32],
) {
    let count = out.len();
    let heights = &heights[..count];
    let parts = parts.map(|part| &part[..count]);
    for i in 0..count {
        let [w0, w2] = shares(heights[i], shape);
        let low = parts[0][i] * w0;
        out[i] += shape.deposit
            * if SLICES == 2 {
                low + parts[1][i] * (1.0 - w0)
            } else {
                low + parts[1][i] * (1.0 - w0 - w2) + parts[2][i] * w2
            };
    }
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    #[target_feature(enable = "avx2")]
    pub(super) fn split<const SLICES: usize>(
        heights: &[f32],
        values: &[f32],
        shape: super::Shape,
        parts: [&mut [f32]; SLICES],
    ) {
        super::split(heights, values, shape, parts);
    }

    #[target_feature(enable = "avx2")]
    pub(super) fn sum<const SLICES: usize>(parts: [&[f32]; SLICES], out: &mut [f32]) {
        super::sum(parts, out);
    }

    #[target_feature(enable = "avx2")]
    pub(super) fn join<const SLICES: usize>(
        heights: &[f32],
        parts: [&[f32]; SLICES],
        shape: super::Shape,
        out: &mut [f32],
    ) {
        super::join(heights, parts, shape, out);
    }
}
