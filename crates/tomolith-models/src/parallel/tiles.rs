//! The one enumerator of (column, voxel, weight), tile by tile; dose and adjoint are its two visitors.
//!
//! In row r of the grid a strip covers the interval between its edges at the middle of the row. The energy that its
//! light leaves in the row is the difference of two exponentials, e^(−μ s₀) − e^(−μ s₁) = −e^(−μ s₀)·expm1(−μ(s₁−s₀)),
//! so what is deposited row by row adds up to what the ray loses, exactly. It is shared among the voxels of the row by
//! the length of the interval that each covers (the *distance-driven* kernel: De Man & Basu, Phys. Med. Biol. 49, 2463
//! (2004)), cut where the row's resin ends ([`walls`](super::walls)). Hence a pixel's energy is conserved, in the resin, and a uniform
//! light gives a uniform dose, both without any tuning.

use super::kernel::Entries;
use super::strips::{Beam, Major, Strip};
use super::uniform_strips::UniformStrips;
use super::walls::{ResinRow, Walls};
use std::ops::Range;

/// Edge of a tile of voxels in the plane.
pub(super) const TILE: usize = 16;

/// Edge of a block of neighboring tiles, in tiles.
pub(super) const BLOCK: usize = 2;

/// Voxels of the plane that one task works on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tile {
    /// First voxel `[x, y]`.
    pub(super) start: [usize; 2],
    /// Number of voxels `[x, y]`, at most [`TILE`] each.
    pub(super) size: [usize; 2],
}

impl Tile {
    /// All tiles of a plane of `nx`·`ny` voxels, block by block, so that neighbors follow each other. `about_middle`: laid out from the middle, so
    /// that a turn by right angles maps tiles onto tiles; both numbers are even then.
    pub(super) fn cover([nx, ny]: [usize; 2], about_middle: bool) -> Vec<Tile> {
        let [across, up] = [nx, ny].map(|n| spans(n, about_middle));
        let mut tiles: Vec<[usize; 2]> = (0..up.len())
            .flat_map(|y| (0..across.len()).map(move |x| [y, x]))
            .collect();
        tiles.sort_by_key(|at| (at.map(|i| i / BLOCK), *at));
        let tile = |[y, x]: [usize; 2]| Tile {
            start: [across[x].start, up[y].start],
            size: [across[x].len(), up[y].len()],
        };
        tiles.into_iter().map(tile).collect()
    }

    /// Whether a voxel `[x, y]` lies in it.
    pub(super) fn holds(&self, [x, y]: [usize; 2]) -> bool {
        let is_within = |i: usize, axis: usize| {
            (self.start[axis]..self.start[axis] + self.size[axis]).contains(&i)
        };
        is_within(x, 0) && is_within(y, 1)
    }
}

/// `n` voxels in spans of at most [`TILE`], from the first or from the middle on.
fn spans(n: usize, about_middle: bool) -> Vec<Range<usize>> {
    let first = if about_middle { n / 2 % TILE } else { 0 };
    let starts = (first > 0).then_some(0).into_iter();
    let starts = starts.chain((first..n).step_by(TILE));
    let span = |start: usize| {
        let end = if start < first { first } else { start + TILE };
        start..end.min(n)
    };
    starts.map(span).collect()
}

/// How light becomes dose along a way through resin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Deposit {
    /// Total attenuation, 1/mm.
    pub(super) attenuation: f64,
    /// Share of the attenuation that makes dose; in pure Radon mode, unused.
    pub(super) active_share: f64,
    /// Sum of fluence instead of absorbed energy.
    pub(super) pure_radon: bool,
}

impl Deposit {
    /// Deposit over `way` mm that begins `depth` mm behind the entry.
    pub(super) fn over(&self, depth: f64, way: f64) -> f64 {
        if self.pure_radon {
            way
        } else {
            -(-self.attenuation * way).exp_m1()
                * (-self.attenuation * depth).exp()
                * self.active_share
        }
    }

    /// Attenuation over one row: minus the logarithm of [`per_row`](Self::per_row).
    pub(super) fn log_per_row(&self, row_mm: f64) -> f64 {
        if self.pure_radon {
            0.0
        } else {
            self.attenuation * row_mm
        }
    }

    /// Factor from one full row to the next one downstream.
    fn per_row(&self, row_mm: f64) -> f64 {
        if self.pure_radon {
            1.0
        } else {
            (-self.attenuation * row_mm).exp()
        }
    }
}

/// Entries of one strip within a tile: a run of [`TileEntries`].
#[derive(Clone, Copy, Debug)]
pub(super) struct StripRun {
    pub(super) column: u32,
    pub(super) begin: u32,
    pub(super) end: u32,
}

/// Buffer of the enumerator: what a beam lights in a tile, strip after strip.
#[derive(Default)]
pub(super) struct TileEntries {
    /// Voxel and weight of each entry.
    pub(super) slots: Vec<u32>,
    pub(super) weights: Vec<f32>,
    pub(super) runs: Vec<StripRun>,
}

/// A strip seen from a tile: coordinates relative to the tile's corner.
pub(super) struct Local {
    /// Rows and voxels across of the tile.
    pub(super) rows: usize,
    pub(super) across: usize,
    /// Number of (row, across) within the tile is `row·row_step + across·across_step`: that of voxel (x, y) is `y·TILE + x`.
    pub(super) row_step: u32,
    pub(super) across_step: u32,
    /// First row and first voxel across of the tile on the grid.
    pub(super) origin: [f32; 2],
}

impl Local {
    pub(super) fn new(tile: &Tile, major: Major) -> Self {
        let (along, across) = major.axes();
        let step = [1, TILE as u32];
        Local {
            rows: tile.size[along],
            across: tile.size[across],
            row_step: step[along],
            across_step: step[across],
            origin: [tile.start[along] as f32, tile.start[across] as f32],
        }
    }

    /// Whether any strip within bounds may light the tile (never wrong when it says no): rounding keeps the order of sums
    /// and, as rows are not negative, of products.
    fn may_meet_any(&self, bounds: &Spans) -> bool {
        let rows = [self.origin[0], self.origin[0] + self.rows as f32];
        if bounds.span[1] <= rows[0] || bounds.span[0] >= rows[1] {
            return false;
        }
        let [low, high] =
            [0, 1].map(|end| rows.map(|t| bounds.offset[end] + bounds.slope[end] * t));
        high[0].max(high[1]) > self.origin[1]
            && low[0].min(low[1]) < self.origin[1] + self.across as f32
    }

    /// Whether a strip may light the tile (never wrong when it says no).
    fn may_meet(&self, strip: &Strip) -> bool {
        let (first, last) = (self.origin[0], self.origin[0] + self.rows as f32);
        if strip.span[1] <= first || strip.span[0] >= last {
            return false;
        }
        let at = |t: f32| strip.edges.map(|[offset, slope]| offset + slope * t);
        let ([a, b], [c, d]) = (at(first), at(last));
        let low = a.min(b).min(c).min(d);
        let high = a.max(b).max(c).max(d);
        high > self.origin[1] && low < self.origin[1] + self.across as f32
    }
}

/// What a beam does in a tile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Meeting {
    /// Strips that may light the tile, half-open.
    pub(super) first: u16,
    pub(super) end: u16,
    /// Whether they form a chain, with no resin wall within the tile.
    pub(super) chain: bool,
    /// Whether they are [`UniformStrips`](super::uniform_strips::UniformStrips) there.
    pub(super) uniform_strips: bool,
}

/// Neighboring strips that are tested together first for whether they meet a tile.
const TOGETHER: usize = 16;

/// Between which numbers all edges and spans of some neighboring strips lie: `[least, largest]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spans {
    offset: [f32; 2],
    slope: [f32; 2],
    span: [f32; 2],
}

impl Spans {
    /// No bounds.
    #[cfg(test)]
    pub(super) const OPEN: Spans = Spans {
        offset: [f32::NEG_INFINITY, f32::INFINITY],
        slope: [0.0; 2],
        span: [f32::NEG_INFINITY, f32::INFINITY],
    };

    /// Of a beam's strips, a few at a time.
    pub(super) fn of_beam(beam: &Beam) -> Vec<Spans> {
        let ends = [f32::INFINITY, f32::NEG_INFINITY];
        let add = |[low, high]: [f32; 2], value: f32| [low.min(value), high.max(value)];
        let of_some = |strips: &[Strip]| {
            let edges = || strips.iter().flat_map(|strip| strip.edges);
            Spans {
                offset: edges().map(|e| e[0]).fold(ends, add),
                slope: edges().map(|e| e[1]).fold(ends, add),
                span: strips.iter().flat_map(|s| s.span).fold(ends, add),
            }
        };
        beam.strips.chunks(TOGETHER).map(of_some).collect()
    }
}

/// How a beam, whose strips have these bounds, and a tile meet.
pub(super) fn meeting(
    beam: &Beam,
    bounds: &[Spans],
    uniform: Option<&UniformStrips>,
    walls: &Walls,
    tile: &Tile,
) -> Meeting {
    let local = Local::new(tile, beam.major);
    let meets = |strip: &Strip| local.may_meet(strip);
    let some = || {
        let strips = beam.strips.chunks(TOGETHER).zip(bounds).enumerate();
        strips.filter(|(_, (_, bounds))| local.may_meet_any(bounds))
    };
    let first =
        some().find_map(|(k, (strips, _))| Some(k * TOGETHER + strips.iter().position(meets)?));
    let last = some()
        .rev()
        .find_map(|(k, (strips, _))| Some(k * TOGETHER + strips.iter().rposition(meets)?));
    let (Some(first), Some(last)) = (first, last) else {
        return Meeting::default();
    };
    let end = last + 1;
    let chain = end - first <= MOST_IN_CHAIN
        && beam.has_columns()
        && beam.is_chain(first, end)
        && local.is_plain(&beam.strips[first..end], beam.major, walls);
    Meeting {
        first: first as u16,
        end: end as u16,
        chain,
        uniform_strips: chain && uniform.is_some_and(|uniform| uniform.holds(first..end)),
    }
}

/// Strips of a chain at most: their edges fill four registers of sixteen.
pub(super) const MOST_IN_CHAIN: usize = 63;
/// Narrowest strip of a chain, in voxels: then at most five cover a voxel.
pub(super) const NARROWEST_IN_CHAIN: f32 = 0.25;

impl Local {
    /// Whether these strips, in growing order, stay wide enough and meet no resin wall within the tile.
    fn is_plain(&self, strips: &[Strip], major: Major, walls: &Walls) -> bool {
        let (first, last) = (self.origin[0], self.origin[0] + self.rows as f32);
        let ends = [strips[0].edges[0], strips[strips.len() - 1].edges[1]];
        let are_plain = strips.iter().all(|strip| {
            let width = |t: f32| {
                let [low, high] = strip.edges.map(|[offset, slope]| offset + slope * t);
                high - low
            };
            strip.span[0] <= first
                && strip.span[1] >= last
                && width(first).min(width(last)) >= NARROWEST_IN_CHAIN
        });
        are_plain && walls.hold(self, major, ends)
    }
}

impl TileEntries {
    pub(super) fn of(&self, run: &StripRun) -> Entries<'_> {
        let range = run.begin as usize..run.end as usize;
        Entries {
            slots: &self.slots[range.clone()],
            weights: &self.weights[range],
        }
    }

    /// Appends what `strips` light in the tile, whose rows have so much resin; `keep` says which columns count.
    pub(super) fn add(
        &mut self,
        strips: &[Strip],
        local: &Local,
        resin_rows: &[ResinRow; TILE],
        deposit: &Deposit,
        keep: impl Fn(u32) -> bool,
    ) {
        for strip in strips {
            if !keep(strip.column) {
                continue;
            }
            let begin = self.slots.len() as u32;
            self.add_strip(strip, local, resin_rows, deposit);
            self.end_run(strip.column, begin);
        }
    }

    /// Closes the entries of one strip.
    pub(super) fn end_run(&mut self, column: u32, begin: u32) {
        let end = self.slots.len() as u32;
        if end > begin {
            self.runs.push(StripRun { column, begin, end });
        }
    }

    fn add_strip(
        &mut self,
        strip: &Strip,
        local: &Local,
        resin_rows: &[ResinRow; TILE],
        deposit: &Deposit,
    ) {
        let low = (strip.span[0] - local.origin[0]).max(0.0);
        let high = (strip.span[1] - local.origin[0]).min(local.rows as f32);
        if low >= high {
            return;
        }
        let (first, last) = (low as usize, (high.ceil() as usize).min(local.rows));
        let row_mm = f64::from(strip.row_mm);
        let [enter, leave] = strip.span.map(|t| f64::from(t - local.origin[0]));
        let depth = |from: f64, to: f64| if strip.upward { from - enter } else { leave - to } * row_mm;
        let energy_of = |from: f64, to: f64| {
            f64::from(strip.power) * deposit.over(depth(from, to), (to - from) * row_mm)
        };

        // Full rows form a geometric progression; only the rows where the resin begins or ends are short
        let full = f64::from(strip.power) * deposit.over(0.0, row_mm);
        let start = depth(first as f64, first as f64 + 1.0);
        let mut energy = if deposit.pure_radon {
            full
        } else {
            full * (-deposit.attenuation * start).exp()
        };
        let ratio = if strip.upward {
            deposit.per_row(row_mm)
        } else {
            1.0 / deposit.per_row(row_mm)
        };

        let at_row = local.origin[0];
        let [a, b] = strip
            .edges
            .map(|[offset, slope]| [offset + slope * at_row - local.origin[1], slope]);
        let across = local.across as f32;
        for (row, resin_row) in (first..last).zip(&resin_rows[first..last]) {
            let (from, to) = ((row as f32).max(low), (row as f32 + 1.0).min(high));
            let short = to - from < 1.0;
            let deposited = if short {
                energy_of(f64::from(from), f64::from(to))
            } else {
                energy
            } as f32;
            energy *= ratio;
            let middle = 0.5 * (from + to);
            let (m1, m2) = (a[0] + a[1] * middle, b[0] + b[1] * middle);
            let [left, right] = resin_row.within([m1.min(m2), m1.max(m2)]);
            let per_voxel = deposited / (right - left);
            let (left, right) = (left.max(0.0), right.min(across));
            if left >= right {
                continue;
            }
            let (i0, i1) = (left as usize, right.ceil() as usize);
            for i in i0..i1 {
                let cover = right.min(i as f32 + 1.0) - left.max(i as f32);
                self.push(local, [row, i], cover * per_voxel);
            }
        }
    }

    /// Appends a voxel `[row, across]` of the strip at hand.
    #[inline]
    pub(super) fn push(&mut self, local: &Local, [row, across]: [usize; 2], weight: f32) {
        let slot = row as u32 * local.row_step + across as u32 * local.across_step;
        self.slots.push(slot);
        self.weights.push(weight);
    }

    pub(super) fn clear(&mut self) {
        self.slots.clear();
        self.weights.clear();
        self.runs.clear();
    }
}
