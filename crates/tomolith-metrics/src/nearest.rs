//! The distance from a point to a triangle surface.
//!
//! A tree of boxes over the triangles, each split in four: at the median along the longest edge of the box of their
//! centroids, and both halves once more. The nodes of a complete tree lie in one array; the boxes of four children, and the
//! triangles of a leaf, have a lane each. A query walks the nearest child first and leaves out boxes that are farther than the
//! best triangle so far. A bound from a neighboring point makes it start well. Exact up to f32.
//!
//! ```
//! use tomolith_metrics::isosurface::Isosurface;
//! use tomolith_metrics::nearest::TriangleTree;
//! let surface = Isosurface { corners: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], triangles: vec![[0, 1, 2]] };
//! let tree = TriangleTree::new(&surface);
//! assert_eq!(tree.distance([0.2, 0.2, 0.5], f32::INFINITY), 0.5); // above its face
//! assert_eq!(tree.distance([-3.0, 4.0, 0.0], f32::INFINITY), 18f32.sqrt()); // nearest to the corner (0, 1, 0)
//! ```

use super::isosurface::Isosurface;
use tomolith_core::dose::Run;
use tomolith_core::parallel::{InParallel, table};
use wide::f32x4;

/// Triangles in a leaf, at most: one in each lane.
const LEAF: usize = 4;
/// Children of a node, as many.
const SPLIT: usize = 4;
/// Leaves that a thread fills in a row.
const LEAVES_AT_ONCE: usize = 1024;
/// Triangles from which on a split is done by two threads.
const PARALLEL: usize = 1 << 14;

type Point = [f32; 3];

#[derive(Clone, Copy)]
struct Aabb {
    low: Point,
    high: Point,
}

impl Aabb {
    const EMPTY: Aabb = Aabb {
        low: [f32::INFINITY; 3],
        high: [f32::NEG_INFINITY; 3],
    };

    fn add(&mut self, p: Point) {
        self.low = std::array::from_fn(|i| self.low[i].min(p[i]));
        self.high = std::array::from_fn(|i| self.high[i].max(p[i]));
    }

    fn joined(mut self, other: Aabb) -> Aabb {
        self.add(other.low);
        self.add(other.high);
        self
    }
}

/// The boxes of a node's children, coordinate by coordinate.
#[derive(Clone, Copy)]
struct Children {
    low: [f32x4; 3],
    high: [f32x4; 3],
}

impl Children {
    fn new(boxes: &[Aabb; SPLIT]) -> Self {
        let lanes = |of: &dyn Fn(&Aabb) -> f32| f32x4::new(boxes.each_ref().map(of));
        Children {
            low: [0, 1, 2].map(|axis| lanes(&|b| b.low[axis])),
            high: [0, 1, 2].map(|axis| lanes(&|b| b.high[axis])),
        }
    }

    /// Squared distances from a point to the boxes.
    fn squared_distances(&self, p: [f32x4; 3]) -> [f32; SPLIT] {
        let off = |axis: usize| {
            let outside = (self.low[axis] - p[axis]).fast_max(p[axis] - self.high[axis]);
            outside.fast_max(f32x4::ZERO)
        };
        let [x, y, z] = [off(0), off(1), off(2)];
        (x * x + y * y + z * z).to_array()
    }
}

/// Triangles of a surface, ready for queries.
pub struct TriangleTree {
    /// Node i has the children 4i + 1 to 4i + 4; behind the last node are the leaves.
    nodes: Vec<Children>,
    leaves: Vec<Leaf>,
}

/// The corners of as many triangles as there are lanes, coordinate by coordinate.
#[derive(Clone, Copy)]
struct Leaf([[f32x4; 3]; 3]);

impl Leaf {
    /// One to four triangles; the last one fills what lanes are left.
    fn new(triangles: &[[Point; 3]]) -> Self {
        let of = |corner: usize, axis: usize| {
            let last = triangles.len() - 1;
            std::array::from_fn(|lane: usize| triangles[lane.min(last)][corner][axis])
        };
        Leaf([0, 1, 2].map(|corner| [0, 1, 2].map(|axis| f32x4::new(of(corner, axis)))))
    }

    /// The smallest squared distance from a point to a triangle.
    fn squared_distance(&self, p: [f32x4; 3]) -> f32 {
        let [a, b, c] = self.0;
        let nearest = squared_distances(p, a, b, c).to_array();
        nearest.into_iter().fold(f32::INFINITY, f32::min)
    }
}

impl TriangleTree {
    /// Builds the tree.
    #[must_use]
    pub fn new(surface: &Isosurface) -> Self {
        Self::under(surface, &Run::new())
    }

    /// The same until the run is canceled: a tree that is not in order answers wrong.
    #[must_use]
    pub fn under(surface: &Isosurface, run: &Run) -> Self {
        let corners = |i: usize| surface.triangles[i].map(|c| surface.corners[c as usize]);
        let n = surface.triangles.len();
        let mut keys: Vec<Key> = table(n, |i| (centroid(corners(i)), i as u32));
        // Splits in two: an even number
        let levels = n
            .div_ceil(LEAF)
            .next_power_of_two()
            .ilog2()
            .next_multiple_of(2);
        sort(&mut keys, levels, run);
        let first = ((1usize << levels) - 1) / (SPLIT - 1);
        let mut boxes = vec![Aabb::EMPTY; first + (1 << levels)];
        let cut = |leaf: usize| (leaf * n) >> levels;
        let leaf = |leaf: usize, bounds: &mut Aabb| {
            let keys = &keys[cut(leaf)..cut(leaf + 1)];
            let mut triangles = [[[0.0; 3]; 3]; LEAF];
            for (triangle, key) in triangles.iter_mut().zip(keys) {
                *triangle = corners(key.1 as usize);
                triangle.iter().for_each(|&corner| bounds.add(corner));
            }
            Leaf::new(&triangles[..keys.len()])
        };
        let bounds = boxes[first..].chunks_mut(LEAVES_AT_ONCE).enumerate();
        let leaves = bounds.filter(|_| n > 0).par_map(|(chunk, bounds)| {
            let all = (chunk * LEAVES_AT_ONCE..).zip(bounds);
            all.map(|(i, bounds)| leaf(i, bounds))
                .collect::<Vec<Leaf>>()
        });
        let leaves = leaves.concat();
        let mut nodes = vec![Children::new(&[Aabb::EMPTY; SPLIT]); first];
        for node in (0..first).rev() {
            let children: [Aabb; SPLIT] = std::array::from_fn(|i| boxes[SPLIT * node + 1 + i]);
            boxes[node] = children.into_iter().fold(Aabb::EMPTY, Aabb::joined);
            nodes[node] = Children::new(&children);
        }
        TriangleTree { nodes, leaves }
    }

    /// Distance from `p` to the nearest triangle, infinite when there is none. `bound` is a distance that is known not
    /// to be exceeded (or infinity).
    #[must_use]
    pub fn distance(&self, p: Point, bound: f32) -> f32 {
        if self.leaves.is_empty() {
            return f32::INFINITY;
        }
        // A little more than the bound, so that its rounding cannot hide the answer
        let mut best = bound * bound * 1.001 + f32::MIN_POSITIVE;
        let lanes = p.map(f32x4::splat);
        let mut stack = [(0usize, 0f32); 64];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let (node, distance) = stack[depth];
            if distance >= best {
                continue;
            }
            let Some(children) = self.nodes.get(node) else {
                let leaf = &self.leaves[node - self.nodes.len()];
                best = best.min(leaf.squared_distance(lanes));
                continue;
            };
            // The nearest child comes on top
            let bottom = depth;
            let distances = children.squared_distances(lanes);
            for (child, distance) in (SPLIT * node + 1..).zip(distances) {
                if distance < best {
                    let mut at = depth;
                    while at > bottom && stack[at - 1].1 < distance {
                        stack[at] = stack[at - 1];
                        at -= 1;
                    }
                    stack[at] = (child, distance);
                    depth += 1;
                }
            }
        }
        best.sqrt()
    }
}

/// Three times a triangle's centroid, and its number.
type Key = (Point, u32);

/// Brings triangles into the order of the leaves below a node that has `levels` levels below it.
fn sort(keys: &mut [Key], levels: u32, run: &Run) {
    let n = keys.len();
    if levels == 0 || n < 2 || run.is_canceled() {
        return;
    }
    let mut bounds = Aabb::EMPTY;
    keys.iter().for_each(|key| bounds.add(key.0));
    let extent: Point = std::array::from_fn(|i| bounds.high[i] - bounds.low[i]);
    let axis = (0..3).fold(0, |a, b| if extent[b] > extent[a] { b } else { a });
    let middle = n / 2;
    keys.select_nth_unstable_by(middle, |a, b| a.0[axis].total_cmp(&b.0[axis]));
    let (low, high) = keys.split_at_mut(middle);
    if n > PARALLEL {
        [low, high]
            .into_iter()
            .par_each(|half| sort(half, levels - 1, run));
    } else {
        sort(low, levels - 1, run);
        sort(high, levels - 1, run);
    }
}

/// Three times the centroid.
fn centroid(t: [Point; 3]) -> Point {
    std::array::from_fn(|i| t[0][i] + t[1][i] + t[2][i])
}

fn sub(a: [f32x4; 3], b: [f32x4; 3]) -> [f32x4; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f32x4; 3], b: [f32x4; 3]) -> f32x4 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Squared distances from a point to triangles: to the plane where the foot lies inside, else to the nearest side.
fn squared_distances(p: [f32x4; 3], a: [f32x4; 3], b: [f32x4; 3], c: [f32x4; 3]) -> f32x4 {
    let (u, v, w) = (sub(b, a), sub(c, a), sub(p, a));
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let det = uu * vv - uv * uv;
    let (s, t) = (vv * wu - uv * wv, uu * wv - uv * wu);
    let zero = f32x4::ZERO;
    let inside = det.simd_gt(zero) & s.simd_ge(zero) & t.simd_ge(zero) & (s + t).simd_le(det);
    let (s, t) = (s / det, t / det);
    let off = std::array::from_fn(|i| w[i] - s * u[i] - t * v[i]);
    let to_sides = to_segments(p, a, b)
        .fast_min(to_segments(p, b, c))
        .fast_min(to_segments(p, c, a));
    inside.select(dot(off, off), to_sides)
}

fn to_segments(p: [f32x4; 3], a: [f32x4; 3], b: [f32x4; 3]) -> f32x4 {
    let (along, w) = (sub(b, a), sub(p, a));
    let length = dot(along, along);
    let zero = f32x4::ZERO;
    let part = (dot(w, along) / length).fast_max(zero).fast_min(f32x4::ONE);
    let t = length.simd_gt(zero).select(part, zero);
    let off = std::array::from_fn(|i| w[i] - t * along[i]);
    dot(off, off)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(state: &mut u64) -> f32 {
        *state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*state >> 40) as f32 / 16_777_216.0
    }

    /// The plain twin of [`squared_distances`], of a triangle.
    fn squared_distance(p: Point, triangle: &[Point; 3]) -> f32 {
        let sub = |a: Point, b: Point| -> Point { std::array::from_fn(|i| a[i] - b[i]) };
        let dot = |a: Point, b: Point| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let off = |w: Point, t: f32, along: Point| sub(w, along.map(|x| t * x));
        let [a, b, c] = *triangle;
        let to_segment = |a, b| {
            let (along, w) = (sub(b, a), sub(p, a));
            let length = dot(along, along);
            let t = match length > 0.0 {
                true => (dot(w, along) / length).clamp(0.0, 1.0),
                false => 0.0,
            };
            dot(off(w, t, along), off(w, t, along))
        };
        let (u, v, w) = (sub(b, a), sub(c, a), sub(p, a));
        let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
        let det = uu * vv - uv * uv;
        let (s, t) = (vv * wu - uv * wv, uu * wv - uv * wu);
        if det > 0.0 && s >= 0.0 && t >= 0.0 && s + t <= det {
            let off = off(off(w, s / det, u), t / det, v);
            return dot(off, off);
        }
        to_segment(a, b).min(to_segment(b, c)).min(to_segment(c, a))
    }

    #[test]
    fn the_tree_finds_what_a_search_of_all_triangles_finds() {
        for count in [1, 2, 3, 4, 5, 16, 17, 64, 65, 1000] {
            let mut state = count as u64;
            let corners: Vec<Point> = (0..3 * count)
                .map(|i| {
                    // Small triangles all over the place, some degenerate
                    let size = if i % 9 == 8 { 0.0 } else { 0.1 };
                    std::array::from_fn(|_| random(&mut state) * size + (i / 3 % 7) as f32 * 0.13)
                })
                .collect();
            let triangles = (0..count as u32)
                .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
                .collect();
            let surface = Isosurface { corners, triangles };
            let tree = TriangleTree::new(&surface);
            for _ in 0..200 {
                let p: Point = std::array::from_fn(|_| 2.0 * random(&mut state) - 0.5);
                let brute = surface
                    .triangles
                    .iter()
                    .map(|t| squared_distance(p, &t.map(|i| surface.corners[i as usize])))
                    .fold(f32::INFINITY, f32::min)
                    .sqrt();
                for bound in [f32::INFINITY, brute, 1.5 * brute] {
                    // Boxes are rounded, so a rival that is equal up to f32 may win
                    let found = tree.distance(p, bound);
                    assert!(
                        (found - brute).abs() <= 2e-7 * (1.0 + brute),
                        "{found} {brute}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_triangle_is_nearest_at_face_sides_and_corners() {
        let t = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
        for (p, expected) in [
            ([0.5, 0.5, -3.0], 9.0),
            ([1.0, -1.0, 0.0], 1.0),
            ([2.0, 2.0, 0.0], 2.0), // the long side's middle (1, 1, 0)
            ([3.0, -1.0, 1.0], 3.0),
            ([-1.0, -2.0, 2.0], 9.0),
        ] {
            assert!((squared_distance(p, &t) - expected).abs() < 1e-6, "{p:?}");
            let lanes = Leaf::new(&[t]).squared_distance(p.map(f32x4::splat));
            assert!((lanes - expected).abs() < 1e-6, "{p:?}");
        }
    }

    #[test]
    fn no_triangles_are_infinitely_far_away() {
        let tree = TriangleTree::new(&Isosurface::default());
        assert_eq!(tree.distance([0.0; 3], f32::INFINITY), f32::INFINITY);
    }
}
