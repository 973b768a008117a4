//! The distance from a point to a triangle surface.
//!
//! A [tree of boxes](tomolith_core::boxes) finds the triangles; those of a leaf have a lane each. A bound from a neighboring point makes a query
//! start well. Exact up to f32.
//!
//! ```
//! use tomolith_core::work::Work;
//! use tomolith_metrics::isosurface::Isosurface;
//! use tomolith_metrics::nearest::TriangleTree;
//! let surface = Isosurface { corners: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], triangles: vec![[0, 1, 2]] };
//! let tree = TriangleTree::new(&surface, &Work::new());
//! assert_eq!(tree.distance([0.2, 0.2, 0.5], f32::INFINITY), 0.5); // above its face
//! assert_eq!(tree.distance([-3.0, 4.0, 0.0], f32::INFINITY), 18f32.sqrt()); // nearest to the corner (0, 1, 0)
//! ```

use super::isosurface::Isosurface;
use tomolith_core::boxes::{AlignedBox, BoxTree, LEAF};
use tomolith_core::work::Work;
use wide::f32x4;

type Point = [f32; 3];

/// Triangles of a surface, ready for queries.
pub struct TriangleTree {
    tree: BoxTree,
    leaves: Vec<Leaf>,
}

/// The corners of as many triangles as there are lanes, coordinate by coordinate.
#[derive(Clone, Copy)]
struct Leaf([[f32x4; 3]; 3]);

impl Leaf {
    /// One to four triangles; the last one fills what lanes are left.
    fn new(triangles: &[[Point; 3]]) -> Self {
        let lanes_of = |corner: usize, axis: usize| {
            let last = triangles.len() - 1;
            std::array::from_fn(|lane: usize| triangles[lane.min(last)][corner][axis])
        };
        Leaf([0, 1, 2].map(|corner| [0, 1, 2].map(|axis| f32x4::new(lanes_of(corner, axis)))))
    }

    /// The smallest squared distance from a point to a triangle.
    fn squared_distance(&self, p: [f32x4; 3]) -> f32 {
        let [a, b, c] = self.0;
        let nearest = squared_distances(p, a, b, c).to_array();
        nearest.into_iter().fold(f32::INFINITY, f32::min)
    }
}

impl TriangleTree {
    /// Builds the tree. One that was not ready when the run was canceled answers wrong.
    #[must_use]
    pub fn new(surface: &Isosurface, work: &Work) -> Self {
        let corners = |i: u32| surface.triangles[i as usize].map(|c| surface.corners[c as usize]);
        let leaf = |items: &[u32]| {
            let mut triangles = [[[0.0; 3]; 3]; LEAF];
            let mut bounds = AlignedBox::EMPTY;
            for (triangle, &item) in triangles.iter_mut().zip(items) {
                *triangle = corners(item);
                triangle.iter().for_each(|&corner| bounds.add(corner));
            }
            (bounds, Leaf::new(&triangles[..items.len()]))
        };
        let count = surface.triangles.len();
        let (tree, leaves) = BoxTree::of_small(count, |i| centroid(corners(i)), leaf, work);
        TriangleTree { tree, leaves }
    }

    /// Distance from `p` to the nearest triangle, infinite when there is none. `bound` is a distance that is known not
    /// to be exceeded (or infinity).
    #[must_use]
    pub fn distance(&self, p: Point, bound: f32) -> f32 {
        if self.leaves.is_empty() {
            return f32::INFINITY;
        }
        // A little more than the bound, so that its rounding cannot hide the answer
        let bound = bound * bound * 1.001 + f32::MIN_POSITIVE;
        let lanes = p.map(f32x4::splat);
        let leaf = |i: usize| self.leaves[i].squared_distance(lanes);
        self.tree.near(p, bound, leaf).sqrt()
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
    use tomolith_core::check::random;
    use tomolith_core::near;

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
            let mut random = random(count as u64);
            let corners: Vec<Point> = (0..3 * count)
                .map(|i| {
                    // Small triangles all over the place, some degenerate
                    let size = if i % 9 == 8 { 0.0 } else { 0.1 };
                    std::array::from_fn(|_| random() * size + (i / 3 % 7) as f32 * 0.13)
                })
                .collect();
            let triangles = (0..count as u32)
                .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
                .collect();
            let surface = Isosurface { corners, triangles };
            let tree = TriangleTree::new(&surface, &Work::new());
            for _ in 0..200 {
                let p: Point = std::array::from_fn(|_| 2.0 * random() - 0.5);
                let brute = surface
                    .triangles
                    .iter()
                    .map(|t| squared_distance(p, &t.map(|i| surface.corners[i as usize])))
                    .fold(f32::INFINITY, f32::min)
                    .sqrt();
                for bound in [f32::INFINITY, brute, 1.5 * brute] {
                    // Boxes are rounded, so a rival that is equal up to f32 may win
                    let found = tree.distance(p, bound);
                    near!(found, brute, 2e-7 * (1.0 + brute), "{found} {brute}");
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
        let tree = TriangleTree::new(&Isosurface::default(), &Work::new());
        assert_eq!(tree.distance([0.0; 3], f32::INFINITY), f32::INFINITY);
    }
}
