//! The distance from a point to a triangle surface.
//!
//! A tree of boxes over the triangles, split at the median along the longest edge of the box of their centroids; the
//! nodes of a complete binary tree lie in one array. A query walks the nearer child first and leaves out boxes that
//! are farther than the best triangle so far. A bound from a neighboring point makes it start well. Exact up to f32.
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
use rayon::prelude::*;
use tomolith_core::dose::Run;

/// Triangles in a leaf, at most.
const LEAF: usize = 4;
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

    fn squared_distance(&self, p: Point) -> f32 {
        (0..3)
            .map(|i| (self.low[i] - p[i]).max(p[i] - self.high[i]).max(0.0))
            .map(|d| d * d)
            .sum()
    }
}

/// Triangles of a surface, ready for queries.
pub struct TriangleTree {
    /// Node i has the children 2i + 1 and 2i + 2; the last level are the leaves.
    boxes: Vec<Aabb>,
    triangles: Vec<[Point; 3]>,
    levels: u32,
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
        let mut triangles: Vec<[Point; 3]> = surface
            .triangles
            .par_iter()
            .map(|t| t.map(|corner| surface.corners[corner as usize]))
            .collect();
        let levels = triangles.len().div_ceil(LEAF).next_power_of_two().ilog2();
        sort(&mut triangles, levels, run);
        let mut tree = TriangleTree {
            boxes: vec![Aabb::EMPTY; (2 << levels) - 1],
            triangles,
            levels,
        };
        let leaves: Vec<Aabb> = (0..1usize << levels)
            .into_par_iter()
            .map(|leaf| {
                let mut bounds = Aabb::EMPTY;
                tree.leaf(leaf)
                    .iter()
                    .flatten()
                    .for_each(|p| bounds.add(*p));
                bounds
            })
            .collect();
        let first = (1 << levels) - 1;
        tree.boxes[first..].copy_from_slice(&leaves);
        for node in (0..first).rev() {
            tree.boxes[node] = tree.boxes[2 * node + 1].joined(tree.boxes[2 * node + 2]);
        }
        tree
    }

    fn leaf(&self, leaf: usize) -> &[[Point; 3]] {
        let n = self.triangles.len();
        let cut = |i: usize| (i * n) >> self.levels;
        &self.triangles[cut(leaf)..cut(leaf + 1)]
    }

    /// Distance from `p` to the nearest triangle, infinite when there is none. `bound` is a distance that is known not
    /// to be exceeded (or infinity).
    #[must_use]
    pub fn distance(&self, p: Point, bound: f32) -> f32 {
        if self.triangles.is_empty() {
            return f32::INFINITY;
        }
        // A little more than the bound, so that its rounding cannot hide the answer
        let mut best = bound * bound * 1.001 + f32::MIN_POSITIVE;
        let first_leaf = (1usize << self.levels) - 1;
        let mut stack = [(0usize, 0f32); 64];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let (mut node, distance) = stack[depth];
            if distance >= best {
                continue;
            }
            while node < first_leaf {
                let (left, right) = (2 * node + 1, 2 * node + 2);
                let (a, b) = (
                    self.boxes[left].squared_distance(p),
                    self.boxes[right].squared_distance(p),
                );
                let (near, far, to_near, to_far) = if a <= b {
                    (left, right, a, b)
                } else {
                    (right, left, b, a)
                };
                if to_far < best {
                    stack[depth] = (far, to_far);
                    depth += 1;
                }
                if to_near >= best {
                    break;
                }
                node = near;
            }
            if node >= first_leaf {
                for triangle in self.leaf(node - first_leaf) {
                    best = best.min(squared_distance(p, triangle));
                }
            }
        }
        best.sqrt()
    }
}

/// Brings triangles into the order of the leaves below a node that has `levels` levels below it.
fn sort(triangles: &mut [[Point; 3]], levels: u32, run: &Run) {
    let n = triangles.len();
    if levels == 0 || n < 2 || run.is_canceled() {
        return;
    }
    let mut bounds = Aabb::EMPTY;
    triangles.iter().for_each(|t| bounds.add(centroid(t)));
    let extent: Point = std::array::from_fn(|i| bounds.high[i] - bounds.low[i]);
    let axis = (0..3).fold(0, |a, b| if extent[b] > extent[a] { b } else { a });
    let middle = n / 2;
    triangles.select_nth_unstable_by(middle, |a, b| {
        centroid(a)[axis].total_cmp(&centroid(b)[axis])
    });
    let (low, high) = triangles.split_at_mut(middle);
    if n > PARALLEL {
        rayon::join(
            || sort(low, levels - 1, run),
            || sort(high, levels - 1, run),
        );
    } else {
        sort(low, levels - 1, run);
        sort(high, levels - 1, run);
    }
}

/// Three times the centroid.
fn centroid(t: &[Point; 3]) -> Point {
    std::array::from_fn(|i| t[0][i] + t[1][i] + t[2][i])
}

fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Squared distance from a point to a triangle: to its plane when the foot lies inside, else to the nearest side.
fn squared_distance(p: Point, triangle: &[Point; 3]) -> f32 {
    let [a, b, c] = *triangle;
    let (u, v, w) = (sub(b, a), sub(c, a), sub(p, a));
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let det = uu * vv - uv * uv;
    let (s, t) = (vv * wu - uv * wv, uu * wv - uv * wu);
    if det > 0.0 && s >= 0.0 && t >= 0.0 && s + t <= det {
        let (s, t) = (s / det, t / det);
        let off: Point = std::array::from_fn(|i| w[i] - s * u[i] - t * v[i]);
        return dot(off, off);
    }
    to_segment(p, a, b)
        .min(to_segment(p, b, c))
        .min(to_segment(p, c, a))
}

fn to_segment(p: Point, a: Point, b: Point) -> f32 {
    let (along, w) = (sub(b, a), sub(p, a));
    let length = dot(along, along);
    let t = if length > 0.0 {
        (dot(w, along) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let off: Point = std::array::from_fn(|i| w[i] - t * along[i]);
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

    #[test]
    fn the_tree_finds_what_a_search_of_all_triangles_finds() {
        for count in [1, 2, 3, 4, 5, 17, 1000] {
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
        }
    }

    #[test]
    fn no_triangles_are_infinitely_far_away() {
        let tree = TriangleTree::new(&Isosurface::default());
        assert_eq!(tree.distance([0.0; 3], f32::INFINITY), f32::INFINITY);
    }
}
