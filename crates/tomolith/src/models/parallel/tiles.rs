//! The one enumerator of (column, voxel, weight), tile by tile; dose and adjoint are its two visitors.
//!
//! In row r of the grid a strip covers the interval between its edges at the middle of the row. The energy that its
//! light leaves in the row is the difference of two exponentials, e^(−μ s₀) − e^(−μ s₁) = −e^(−μ s₀)·expm1(−μ(s₁−s₀)),
//! so what is deposited row by row adds up to what the ray loses, exactly. It is shared among the voxels of the row by
//! the length of the interval that each covers (the *distance-driven* kernel: De Man & Basu, Phys. Med. Biol. 49, 2463
//! (2004)). Hence a pixel's energy is conserved and a uniform light gives a uniform dose, both without any tuning.

use super::strips::{Beam, Major, Strip};

/// Edge of a tile of voxels in the plane.
pub(super) const TILE: usize = 16;

/// Voxels of the plane that one task works on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tile {
    /// First voxel `[x, y]`.
    pub(super) start: [usize; 2],
    /// Number of voxels `[x, y]`, at most [`TILE`] each.
    pub(super) size: [usize; 2],
}

impl Tile {
    /// All tiles of a plane of `nx`·`ny` voxels, row by row.
    pub(super) fn cover(nx: usize, ny: usize) -> Vec<Tile> {
        let mut tiles = Vec::new();
        for y in (0..ny).step_by(TILE) {
            for x in (0..nx).step_by(TILE) {
                tiles.push(Tile {
                    start: [x, y],
                    size: [TILE.min(nx - x), TILE.min(ny - y)],
                });
            }
        }
        tiles
    }
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
    fn over(&self, depth: f64, way: f64) -> f64 {
        if self.pure_radon {
            way
        } else {
            -(-self.attenuation * way).exp_m1()
                * (-self.attenuation * depth).exp()
                * self.active_share
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

/// Weight of one voxel, or of one column: `slot` says which row of lanes.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub(super) struct Entry {
    pub(super) slot: u32,
    pub(super) weight: f32,
}

/// Entries of one strip within a tile: a run of [`TileEntries::entries`].
#[derive(Clone, Copy, Debug)]
pub(super) struct StripRun {
    pub(super) column: u32,
    pub(super) begin: u32,
    pub(super) end: u32,
}

/// Buffer of the enumerator: what a beam lights in a tile, strip after strip.
#[derive(Default)]
pub(super) struct TileEntries {
    /// `slot` is the voxel.
    pub(super) entries: Vec<Entry>,
    pub(super) runs: Vec<StripRun>,
}

/// How voxels of a tile are numbered: voxel (x, y) of the tile is `first + y·per_y + x`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slots {
    pub(super) first: u32,
    pub(super) per_y: u32,
}

impl Slots {
    /// Numbers within the tile.
    pub(super) const WITHIN_TILE: Slots = Slots {
        first: 0,
        per_y: TILE as u32,
    };

    /// Numbers within a plane of `nx` voxels a row.
    pub(super) fn within_plane(tile: &Tile, nx: usize) -> Self {
        Slots {
            first: (tile.start[1] * nx + tile.start[0]) as u32,
            per_y: nx as u32,
        }
    }
}

/// A strip seen from a tile: coordinates relative to the tile's corner.
struct Local {
    /// Rows and voxels across of the tile.
    rows: usize,
    across: usize,
    /// Slot of (row, across) is `first_slot + row·row_step + across·across_step`.
    first_slot: u32,
    row_step: u32,
    across_step: u32,
    /// First row and first voxel across of the tile on the grid.
    origin: [f32; 2],
}

impl Local {
    fn new(tile: &Tile, major: Major, slots: Slots) -> Self {
        let (along, across) = if major == Major::X { (0, 1) } else { (1, 0) };
        let step = [1, slots.per_y];
        Local {
            rows: tile.size[along],
            across: tile.size[across],
            first_slot: slots.first,
            row_step: step[along],
            across_step: step[across],
            origin: [tile.start[along] as f32, tile.start[across] as f32],
        }
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

/// The first and last strip of a beam that may light a tile, as a half-open range.
pub(super) fn strips_of(beam: &Beam, tile: &Tile) -> (u16, u16) {
    let local = Local::new(tile, beam.major, Slots::WITHIN_TILE);
    let meets = |strip: &Strip| local.may_meet(strip);
    let first = beam.strips.iter().position(meets);
    let last = beam.strips.iter().rposition(meets);
    match (first, last) {
        (Some(first), Some(last)) => (first as u16, last as u16 + 1),
        _ => (0, 0),
    }
}

/// Narrower strips are spread over this width, in voxels: at a fold the edges cross.
const NARROWEST: f32 = 1e-4;

impl TileEntries {
    /// Appends what `strips` light in the tile.
    pub(super) fn add(
        &mut self,
        strips: &[Strip],
        major: Major,
        (tile, slots): (&Tile, Slots),
        deposit: &Deposit,
        keep: impl Fn(u32) -> bool,
    ) {
        let local = Local::new(tile, major, slots);
        for strip in strips {
            if !keep(strip.column) {
                continue;
            }
            let begin = self.entries.len() as u32;
            self.add_strip(strip, &local, deposit);
            let end = self.entries.len() as u32;
            if end > begin {
                self.runs.push(StripRun {
                    column: strip.column,
                    begin,
                    end,
                });
            }
        }
    }

    fn add_strip(&mut self, strip: &Strip, local: &Local, deposit: &Deposit) {
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
        for row in first..last {
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
            let (mut left, mut right) = (m1.min(m2), m1.max(m2));
            if right - left < NARROWEST {
                (left, right) = (left - 0.5 * NARROWEST, right + 0.5 * NARROWEST);
            }
            let per_voxel = deposited / (right - left);
            let (left, right) = (left.max(0.0), right.min(across));
            if left >= right {
                continue;
            }
            let base = local.first_slot + row as u32 * local.row_step;
            let (i0, i1) = (left as usize, right.ceil() as usize);
            for i in i0..i1 {
                let cover = right.min(i as f32 + 1.0) - left.max(i as f32);
                self.entries.push(Entry {
                    slot: base + i as u32 * local.across_step,
                    weight: cover * per_voxel,
                });
            }
        }
    }

    pub(super) fn clear(&mut self) {
        self.entries.clear();
        self.runs.clear();
    }
}
