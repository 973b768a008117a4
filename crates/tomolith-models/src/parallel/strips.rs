//! From a vial to strips: what one pixel column of one frame lights in the plane.
//!
//! A *strip* is the part of a column's light that runs through resin in one smooth bundle: two edge rays (straight lines
//! in the resin, whatever the walls did to them before), the piece of the way where it is lit, and its power. All that
//! refraction does is in the edges: where a wall focuses, the strip is narrower, so the same power makes more dose
//! (du/dt of the refracted bundle), and where rays cross (the fold beyond n_s·R_o/n_r) two strips cover the same voxel.
//! A column that meets a corner or the rim of an inner tube is cut there into several strips.

use super::tiles::Deposit;
use std::f64::consts::TAU;
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_core::parallel::InParallel;
use tomolith_optics::trace::{PlanarPath, Tracer};

/// A straight line in the resin frame, mm.
#[derive(Clone, Copy, Debug)]
struct Line {
    from: [f64; 2],
    direction: [f64; 2],
}

impl Line {
    fn turned(self, sin: f64, cos: f64) -> Self {
        let turn = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
        Line {
            from: turn(self.from),
            direction: turn(self.direction),
        }
    }
}

/// One smooth bundle of a column, before it is laid on a grid.
#[derive(Clone, Copy, Debug)]
struct Bundle {
    column: u32,
    edges: [Line; 2],
    middle: Line,
    length: f64,
    /// Emitted width times power that arrives: energy per mm of height for a pattern value of 1.
    power: f64,
}

/// Which grid axis a strip runs along: rows are counted along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Major {
    X,
    Y,
}

impl Major {
    /// Numbers of the axis along strips and of the one across them.
    pub(super) fn axes(self) -> (usize, usize) {
        match self {
            Major::X => (0, 1),
            Major::Y => (1, 0),
        }
    }
}

/// A strip on a grid. Along the major axis, row r covers [r, r + 1); across it, voxel i covers [i, i + 1).
#[derive(Clone, Copy, Debug)]
pub(super) struct Strip {
    pub(super) column: u32,
    /// Whether light travels toward larger rows.
    pub(super) upward: bool,
    /// Edges: offset and slope of the minor coordinate as a function of the major one.
    pub(super) edges: [[f32; 2]; 2],
    /// The lit piece of the major axis.
    pub(super) span: [f32; 2],
    /// Energy per height for a pattern value of 1, as dose of one voxel (divided by its area), mm⁻¹.
    pub(super) power: f32,
    /// Way through one row, mm.
    pub(super) row_mm: f32,
}

/// All strips of one frame (and one sub-angle) with one major axis.
#[derive(Clone, Debug)]
pub(super) struct Beam {
    /// Frame of the pattern grid.
    pub(super) frame: u32,
    /// Where its light comes from, rad.
    pub(super) azimuth: f64,
    pub(super) major: Major,
    /// In order of growing minor coordinate where they do not cross.
    pub(super) strips: Vec<Strip>,
    /// The same strips by component, for vectors over strips.
    pub(super) columns: Columns,
}

/// Components of the strips of a beam, padded by [`PADDING`] so that a vector may read beyond the last.
#[derive(Clone, Debug, Default)]
pub(super) struct Columns {
    /// Offset and slope of the lower edge; the next strip's is this one's upper edge wherever `is_chain`.
    pub(super) offset: Vec<f32>,
    pub(super) slope: Vec<f32>,
    /// Deposit of a full row right behind the entry.
    pub(super) full: Vec<f32>,
    /// Attenuation over one row.
    pub(super) per_row: Vec<f32>,
    /// Where light enters the resin, in rows, seen in the direction of travel.
    pub(super) enter: Vec<f32>,
    /// Growth of the column number from strip to strip, where strips form a chain: +1 or −1.
    pub(super) step: i32,
}

/// Entries behind the last strip in [`Columns`].
pub(super) const PADDING: usize = 65;

/// Strips of every frame of one light; each frame is the mean of `sub_angles` positions within its arc.
pub(super) fn beams(
    tracer: &Tracer,
    is_round: bool,
    pixels: &PatternGrid,
    sub_angles: usize,
    grid: &VolumeGrid,
    deposit: &Deposit,
) -> Vec<Beam> {
    // A round vial looks the same from everywhere: trace it once
    let shared = is_round.then(|| bundles(tracer, pixels, 0.0));
    let weight = 1.0 / sub_angles as f64;
    pixels
        .azimuths
        .iter()
        .enumerate()
        .par_map(|(frame, &azimuth)| {
            let mut beams = Vec::with_capacity(2 * sub_angles);
            for sub in 0..sub_angles {
                let within = (sub as f64 + 0.5) / sub_angles as f64 - 0.5;
                let angle = azimuth + within * pixels.frame_arc;
                let (traced, turn) = match &shared {
                    Some(_) => (None, angle),
                    None => (Some(bundles(tracer, pixels, angle)), 0.0),
                };
                let list = traced.as_ref().or(shared.as_ref()).map_or(&[][..], |v| v);
                let laid = lay(frame as u32, list, turn, weight, grid, deposit);
                beams.extend(laid.into_iter().map(|mut beam| {
                    beam.azimuth = angle;
                    beam
                }));
            }
            beams
        })
        .concat()
}

/// Traces every column of a frame and cuts it into smooth bundles.
fn bundles(tracer: &Tracer, pixels: &PatternGrid, azimuth: f64) -> Vec<Bundle> {
    let mut bundles = Vec::with_capacity(pixels.columns);
    for column in 0..pixels.columns {
        let u = pixels.column_u(column);
        let half = pixels.pitch_mm[0] / 2.0;
        cut(
            tracer,
            azimuth,
            column as u32,
            u - half,
            u + half,
            &mut bundles,
        );
    }
    bundles
}

/// Rays are traced this fraction of a column inside its edges, so that both see the same walls as its middle.
const INSET: f64 = 1e-7;
/// Pieces of a column narrower than this fraction of it carry nothing worth a strip.
const NARROWEST: f64 = 1e-6;

/// Adds the bundles of the light between `low` and `high`; cuts where the rays' way changes class.
fn cut(tracer: &Tracer, azimuth: f64, column: u32, low: f64, high: f64, out: &mut Vec<Bundle>) {
    let inset = INSET * (high - low);
    let trace = |u: f64| tracer.trace(u, azimuth);
    let (a, b) = (trace(low + inset), trace(high - inset));
    let middle = trace((low + high) / 2.0);
    if a.class == b.class && a.class == middle.class {
        push(tracer, azimuth, column, [low, high], [&a, &middle, &b], out);
        return;
    }
    // Bisect for the first change of class between the low edge and the first differing sample
    let (mut same, mut other) = if a.class == middle.class {
        ((low + high) / 2.0, high - inset)
    } else {
        (low + inset, (low + high) / 2.0)
    };
    while other - same > NARROWEST * (high - low).max(1e-9) * 1e-3 {
        let half = (same + other) / 2.0;
        if trace(half).class == a.class {
            same = half;
        } else {
            other = half;
        }
    }
    let pixel = (high - low).max(1e-12);
    if same - low > NARROWEST * pixel {
        let (mid, end) = (
            trace((low + same) / 2.0),
            trace(same - INSET * (same - low)),
        );
        if mid.class == a.class && end.class == a.class {
            push(tracer, azimuth, column, [low, same], [&a, &mid, &end], out);
        } else {
            cut(tracer, azimuth, column, low, same, out);
        }
    }
    if high - other > NARROWEST * pixel {
        cut(tracer, azimuth, column, other, high, out);
    }
}

/// Nodes and weights on (−1, 1): u = sin θ, Gauss's rule of eight points over θ. Ways end in a square root where rays graze a wall, which
/// is smooth in θ.
const NODES: [(f64, f64); 8] = {
    const HALF: [(f64, f64); 4] = [
        (0.284_167_923_901_928_74, 0.546_216_104_904_208_2),
        (0.734_889_938_755_432_3, 0.334_189_396_145_489_65),
        (0.949_425_384_298_818_8, 0.109_682_471_335_215_37),
        (0.998_055_213_850_506_8, 0.009_912_027_615_086_584),
    ];
    let mut rule = [(0.0, 0.0); 8];
    let mut i = 0;
    while i < 4 {
        rule[i] = HALF[i];
        rule[7 - i] = (-HALF[i].0, HALF[i].1);
        i += 1;
    }
    rule
};

/// Adds one bundle per segment. Its power is such that its middle ray leaves what all rays between `low` and `high` leave
/// together: near the rim of the resin their ways differ much.
fn push(
    tracer: &Tracer,
    azimuth: f64,
    column: u32,
    [low, high]: [f64; 2],
    [a, middle, b]: [&PlanarPath; 3],
    out: &mut Vec<Bundle>,
) {
    let half = (high - low) / 2.0;
    let samples = NODES.map(|(node, weight)| {
        (
            tracer.trace((low + high) / 2.0 + node * half, azimuth),
            weight * half,
        )
    });
    for (i, segment) in middle.segments.iter().enumerate() {
        let (Some(at_a), Some(at_b)) = (a.segments.get(i), b.segments.get(i)) else {
            continue;
        };
        let segments = samples
            .iter()
            .filter_map(|(path, weight)| path.segments.get(i).map(|segment| (segment, weight)));
        let left: f64 = segments
            .map(|(segment, weight)| segment.power * tracer.deposit(segment.length) * weight)
            .sum();
        out.push(Bundle {
            column,
            edges: [at_a, at_b].map(|edge| Line {
                from: edge.from,
                direction: edge.direction,
            }),
            middle: Line {
                from: segment.from,
                direction: segment.direction,
            },
            length: segment.length,
            power: left / tracer.deposit(segment.length),
        });
    }
}

impl Beam {
    /// `[offset, per_mm, slope]`: the minor coordinate of the ray at u in row r is offset + u·per_mm + r·slope, voxels.
    pub(super) fn minor(&self, grid: &VolumeGrid) -> [f64; 3] {
        let (along, across) = self.major.axes();
        let (sin, cos) = self.azimuth.sin_cos();
        let (direction, sideways) = ([-cos, -sin], [-sin, cos]);
        let (low, h) = (grid.bounds_mm()[0], grid.pitch_mm);
        let slope = direction[across] / direction[along];
        let offset = (slope * low[along] - low[across]) / h;
        let per_mm = (sideways[across] - slope * sideways[along]) / h;
        [offset, per_mm, slope]
    }

    /// Orders the strips, joins edges that neighbors share, and fills [`Columns`].
    fn finish(&mut self, deposit: &Deposit) {
        let strips = &mut self.strips;
        let (first, last) = (strips[0].edges[0][0], strips[strips.len() - 1].edges[0][0]);
        self.columns.step = 1;
        if last < first {
            strips.reverse();
            strips.iter_mut().for_each(|strip| strip.edges.swap(0, 1));
            self.columns.step = -1;
        }
        for i in 1..strips.len() {
            let (below, above) = (strips[i - 1].edges[1], strips[i].edges[0]);
            if (below[0] - above[0]).abs() < JOIN && (below[1] - above[1]).abs() < JOIN * 1e-3 {
                strips[i - 1].edges[1] = above;
            }
        }
        let component = |f: &dyn Fn(&Strip) -> f32| {
            let mut values: Vec<f32> = strips.iter().map(f).collect();
            values.resize(strips.len() + PADDING, 0.0);
            values
        };
        let row_mm = |s: &Strip| f64::from(s.row_mm);
        self.columns.offset = component(&|s| s.edges[0][0]);
        self.columns.slope = component(&|s| s.edges[0][1]);
        self.columns.full =
            component(&|s| (f64::from(s.power) * deposit.over(0.0, row_mm(s))) as f32);
        self.columns.per_row = component(&|s| deposit.log_per_row(row_mm(s)) as f32);
        self.columns.enter = component(&|s| if s.upward { s.span[0] } else { s.span[1] });
        // The upper edge of the last strip, where a chain ends
        let n = strips.len();
        let [offset, slope] = strips[n - 1].edges[1];
        (self.columns.offset[n], self.columns.slope[n]) = (offset, slope);
    }

    /// Whether [`Columns`] is filled: the kernels of pure Radon do without.
    pub(super) fn has_columns(&self) -> bool {
        !self.columns.offset.is_empty()
    }

    /// Whether strips `first..end` are neighbors of one column each, that share edges and travel the same way.
    pub(super) fn is_chain(&self, first: usize, end: usize) -> bool {
        let [offset, slope] = self.strips[end - 1].edges[1];
        let closed = self.columns.offset[end] == offset && self.columns.slope[end] == slope;
        closed
            && self.strips[first..end].windows(2).all(|pair| {
                pair[0].edges[1] == pair[1].edges[0]
                    && pair[0].upward == pair[1].upward
                    && pair[1].column as i32 - pair[0].column as i32 == self.columns.step
            })
    }
}

/// Edges nearer than this, in voxels, are one edge: rays are traced a little inside their column.
const JOIN: f32 = 1e-3;

/// Lays bundles, turned by `turn`, on a grid: one beam per major axis that occurs.
fn lay(
    frame: u32,
    bundles: &[Bundle],
    turn: f64,
    weight: f64,
    grid: &VolumeGrid,
    deposit: &Deposit,
) -> Vec<Beam> {
    let (sin, cos) = turn.rem_euclid(TAU).sin_cos();
    let mut beams = [Major::X, Major::Y].map(|major| Beam {
        frame,
        azimuth: turn,
        major,
        strips: Vec::new(),
        columns: Columns::default(),
    });
    for bundle in bundles {
        let middle = bundle.middle.turned(sin, cos);
        let major = if middle.direction[0].abs() > middle.direction[1].abs() {
            Major::X
        } else {
            Major::Y
        };
        let strip = strip(
            bundle,
            middle,
            bundle.edges.map(|e| e.turned(sin, cos)),
            major,
            weight,
            grid,
        );
        beams[usize::from(major == Major::Y)].strips.extend(strip);
    }
    let mut beams: Vec<Beam> = beams
        .into_iter()
        .filter(|beam| !beam.strips.is_empty())
        .collect();
    beams.iter_mut().for_each(|beam| beam.finish(deposit));
    beams
}

fn strip(
    bundle: &Bundle,
    middle: Line,
    edges: [Line; 2],
    major: Major,
    weight: f64,
    grid: &VolumeGrid,
) -> Option<Strip> {
    let (along, across) = major.axes();
    let low = grid.bounds_mm()[0];
    let h = grid.pitch_mm;
    let edges = edges.map(|line| {
        let slope = line.direction[across] / line.direction[along];
        let offset = line.from[across] - slope * (line.from[along] - low[along]);
        [((offset - low[across]) / h) as f32, slope as f32]
    });
    let per_mm = middle.direction[along] / h;
    let start = (middle.from[along] - low[along]) / h;
    let end = start + bundle.length * per_mm;
    let finite = edges.iter().flatten().all(|v| v.is_finite());
    finite.then_some(Strip {
        column: bundle.column,
        upward: per_mm > 0.0,
        edges,
        span: [start.min(end) as f32, start.max(end) as f32],
        power: (bundle.power * weight / (h * h)) as f32,
        row_mm: (1.0 / per_mm.abs()) as f32,
    })
}
