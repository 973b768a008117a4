//! Lines along x through a closed mesh: where they cross it, and in which direction.
//!
//! A plane at height z cuts every triangle that reaches from below z to z or above (`a.z ≤ z < b.z` for its edges) in one
//! segment; a line at y in that plane meets the segment when `start.y ≤ y < end.y`. Both rules are half open and both
//! ends of a segment are computed once per *edge* (from its lower to its higher vertex index), so the two triangles of an
//! edge agree to the last bit: lines through vertices and edges count once, and the winding number of a closed mesh
//! returns to zero on every line, whatever rounding does to the places of the crossings.

use std::borrow::Cow;
use std::ops::Range;
use tomolith_core::grid::VolumeGrid;
use tomolith_io::mesh::Mesh;

/// How often a negative volume counts: more often than shells of a part lie in each other.
const NEGATIVE: i32 = 1 << 20;

/// A mesh in voxel units of a grid: the grid covers 0…nx, 0…ny, 0…nz. Where negative volumes are taken out of it, the
/// winding number is far below zero.
pub(super) struct Scaled<'a> {
    vertices: Vec<[f64; 3]>,
    triangles: Cow<'a, [[u32; 3]]>,
    /// Triangles of the part; those of negative volumes follow.
    part: usize,
    z_ranges: Vec<[f32; 2]>,
}

impl<'a> Scaled<'a> {
    pub(super) fn new(mesh: &'a Mesh, negative: Option<&Mesh>, grid: &VolumeGrid) -> Self {
        let [low, _] = grid.bounds_mm();
        let to_voxels = |p: &[f64; 3]| std::array::from_fn(|i| (p[i] - low[i]) / grid.pitch_mm);
        let mut vertices: Vec<[f64; 3]> = mesh.vertices.iter().map(to_voxels).collect();
        let mut triangles = Cow::Borrowed(&mesh.triangles[..]);
        if let Some(negative) = negative {
            let first = vertices.len() as u32;
            vertices.extend(negative.vertices.iter().map(to_voxels));
            let shifted = negative.triangles.iter().map(|t| t.map(|v| v + first));
            triangles.to_mut().extend(shifted);
        }
        let z_ranges = triangles
            .iter()
            .map(|t| {
                let z = t.map(|v| vertices[v as usize][2]);
                let (low, high) = (z[0].min(z[1]).min(z[2]), z[0].max(z[1]).max(z[2]));
                // Rounded outwards: a triangle may be looked at in vain, but not be missed
                [(low as f32).next_down(), (high as f32).next_up()]
            })
            .collect();
        Scaled {
            vertices,
            triangles,
            part: mesh.triangles.len(),
            z_ranges,
        }
    }

    pub(super) fn corners(&self, triangle: u32) -> [[f64; 3]; 3] {
        self.triangles[triangle as usize].map(|v| self.vertices[v as usize])
    }

    /// Whether the triangle belongs to a negative volume.
    pub(super) fn is_negative(&self, triangle: u32) -> bool {
        triangle as usize >= self.part
    }

    /// Heights between which a triangle lies, rounded outwards.
    pub(super) fn z_range(&self, triangle: u32) -> [f64; 2] {
        self.z_ranges[triangle as usize].map(f64::from)
    }

    /// Triangles that reach into low…high, in their order.
    pub(super) fn between(&self, low: f64, high: f64) -> Vec<u32> {
        (0..self.z_ranges.len() as u32)
            .filter(|&t| {
                let [bottom, top] = self.z_range(t);
                bottom <= high && top >= low
            })
            .collect()
    }
}

/// A line enters (`step` = 1) or leaves (−1) a shell at `x`, going to +x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Crossing {
    pub(super) line: u32,
    pub(super) x: f64,
    pub(super) step: i32,
}

/// The crossings of many lines in one plane; keeps its memory from plane to plane.
#[derive(Default)]
pub(super) struct Lines {
    crossings: Vec<Crossing>,
}

impl Lines {
    /// Casts the lines `y(i)`, i in `range`, in the plane `z`; `y` must grow with i, by equal steps.
    pub(super) fn cast(
        &mut self,
        mesh: &Scaled,
        triangles: &[u32],
        z: f64,
        y: impl Fn(usize) -> f64,
        range: Range<usize>,
    ) {
        self.crossings.clear();
        let (first, step) = (y(0), y(1) - y(0));
        for &t in triangles {
            let Some([start, end, direction]) = segment(mesh, t, z) else {
                continue;
            };
            let weight = if mesh.is_negative(t) { -NEGATIVE } else { 1 };
            // The estimate may be off by rounding; the half-open rule decides
            let guess = ((start[0] - first) / step).floor().max(range.start as f64) as usize;
            for line in guess.saturating_sub(1).max(range.start)..range.end {
                let at = y(line);
                if at < start[0] {
                    continue;
                }
                if at >= end[0] {
                    break;
                }
                let share = (at - start[0]) / (end[0] - start[0]);
                self.crossings.push(Crossing {
                    line: line as u32,
                    x: start[1] + share * (end[1] - start[1]),
                    step: direction[0] as i32 * weight,
                });
            }
        }
        self.crossings
            .sort_unstable_by(|a, b| a.line.cmp(&b.line).then(a.x.total_cmp(&b.x)));
    }

    /// Hands out the crossings of every line that has some, sorted along x.
    pub(super) fn for_each_line(&self, mut visit: impl FnMut(usize, &[Crossing])) {
        for crossings in self.crossings.chunk_by(|a, b| a.line == b.line) {
            visit(crossings[0].line as usize, crossings);
        }
    }
}

/// Where the plane cuts a triangle: `[y, x]` of both ends in the order of y, and the step of a line that crosses it.
fn segment(mesh: &Scaled, triangle: u32, z: f64) -> Option<[[f64; 2]; 3]> {
    let [a, b, c] = mesh.triangles[triangle as usize];
    let (mut rising, mut falling) = (None, None);
    for (from, to) in [(a, b), (b, c), (c, a)] {
        let (below, above) = (
            mesh.vertices[from as usize][2] <= z,
            mesh.vertices[to as usize][2] > z,
        );
        if below == above {
            let crossing = edge_at(mesh, from.min(to), from.max(to), z);
            if below {
                rising = Some(crossing);
            } else {
                falling = Some(crossing);
            }
        }
    }
    let (up, down) = (rising?, falling?);
    // Counter-clockwise seen from outside: when the edge at higher y goes up, the outside looks to +x and the line leaves
    if down[0] < up[0] {
        Some([down, up, [-1.0, 0.0]])
    } else {
        Some([up, down, [1.0, 0.0]])
    }
}

/// `[y, x]` of an edge at height z, computed from the lower to the higher vertex index.
fn edge_at(mesh: &Scaled, low: u32, high: u32, z: f64) -> [f64; 2] {
    let (a, b) = (mesh.vertices[low as usize], mesh.vertices[high as usize]);
    let share = (z - a[2]) / (b[2] - a[2]);
    [1, 0].map(|axis| a[axis] + share * (b[axis] - a[axis]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_io::mesh::samples::{ball, cuboid};

    /// The crossings of a line at y in the plane z.
    fn crossings(mesh: &Mesh, z: f64, y: f64) -> Vec<(f64, i32)> {
        let grid = VolumeGrid::centered([1; 3], 1.0).about([0.5; 3]);
        let scaled = Scaled::new(mesh, None, &grid);
        let all = scaled.between(z, z);
        let (mut lines, mut found) = (Lines::default(), Vec::new());
        lines.cast(&scaled, &all, z, |i| y + i as f64, 0..1);
        lines.for_each_line(|_, c| found = c.iter().map(|c| (c.x, c.step)).collect());
        found
    }

    #[test]
    fn lines_through_edges_and_corners_of_a_box_count_once() {
        let mesh = cuboid([0.0; 3], [2.0, 4.0, 4.0]);
        // On the bottom plane, the diagonals, an edge, the middle; on the far edges and beyond: half open
        for (z, y, hit) in [
            (0.0, 0.0, true),
            (0.0, 1.0, true),
            (2.0, 2.0, true),
            (1.0, 3.0, true),
            (4.0, 1.0, false),
            (1.0, 4.0, false),
            (-1.0, 1.0, false),
        ] {
            let expected = [(0.0, 1), (2.0, -1)];
            let expected = if hit { &expected[..] } else { &[] };
            assert_eq!(crossings(&mesh, z, y), expected, "y = {y}, z = {z}");
        }
    }

    #[test]
    fn the_winding_number_returns_to_zero_on_every_line() {
        let mesh = ball([0.0; 3], 1.0, 2);
        // Lines through all vertices, and through all middles of edges
        let mut places: Vec<[f64; 2]> = mesh.vertices.iter().map(|v| [v[1], v[2]]).collect();
        for t in 0..mesh.triangles.len() {
            let [a, b, _] = mesh.corners(t);
            places.push([(a[1] + b[1]) / 2.0, (a[2] + b[2]) / 2.0]);
        }
        for [y, z] in places {
            let found = crossings(&mesh, z, y);
            let winding: i32 = found.iter().map(|(_, step)| step).sum();
            assert_eq!(winding, 0, "y = {y}, z = {z}: {found:?}");
        }
    }
}
