//! Triangles that pass through each other.
//!
//! Surfaces cross where an edge of one runs through a triangle of the other. The edge p–q runs through triangle T when p
//! and q lie on different sides of T's plane and the point between them lies in T, all by more than [`TOUCH`] of the
//! mesh's diagonal: shells that touch up to the rounding of their files do not cross. Where the point lies on a side of
//! T, that side's two triangles decide together, as a wedge: p must lie on one side of it and q on the other. So an edge
//! through the diagonal of a flat face counts, and two boxes that share a face do not.
//!
//! Crossings exactly at a vertex, and sheets that lie in each other without an edge through a triangle, are left to the
//! [lattice of lines](super::overlaps). Cost: one walk down a tree of boxes per edge; 60 000 triangles take 0.1 s.

use super::edges::Edges;
use super::shells::Groups;
use tomolith_core::boxes::{AlignedBox, BoxTree};
use tomolith_core::error::Result;
use tomolith_core::parallel::InParallel;
use tomolith_core::vector::{cross, dot, minus};
use tomolith_core::work::Work;
use tomolith_io::mesh::Mesh;

/// How far surfaces may run into each other and still only touch, as a share of the mesh's diagonal: a hundred times the
/// rounding of coordinates in f32, a tenth of a micrometer in a part of 10 mm.
const TOUCH: f64 = 1e-5;

/// Edges that run through triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Crossings {
    /// How many pairs of an edge and a triangle.
    pub count: usize,
    /// Where the nearer end of the edge lies deepest behind the triangle, mm.
    pub at: Option<[f64; 3]>,
    depth: f64,
}

impl Crossings {
    fn add(&mut self, at: [f64; 3], depth: f64) {
        self.count += 1;
        if depth > self.depth {
            (self.at, self.depth) = (Some(at), depth);
        }
    }

    fn join(&mut self, other: &Crossings) {
        self.count += other.count;
        if other.depth > self.depth {
            (self.at, self.depth) = (other.at, other.depth);
        }
    }
}

/// Edges through triangles of their own shell, and of other shells.
pub(super) fn find_crossings(mesh: &Mesh, work: &Work) -> Result<[Crossings; 2]> {
    let edges = Edges::new(mesh);
    work.check()?;
    let search = Search::new(mesh, &edges, work);
    work.check()?;
    let mut shells = Groups::of_shells(mesh);
    let shell: Vec<u32> = (0..mesh.vertices.len() as u32)
        .map(|v| shells.of(v))
        .collect();
    let pairs: Vec<[u32; 2]> = edges
        .iter()
        .map(|sides| [sides[0].low, sides[0].high])
        .collect();
    let blocks: Vec<[Crossings; 2]> = pairs.chunks(1024).par_map(|pairs| {
        let mut found = [Crossings::default(); 2];
        if work.is_canceled() {
            return found;
        }
        for &edge in pairs {
            search.for_each_crossing(edge, |triangle, at, depth| {
                let other = shell[mesh.triangles[triangle as usize][0] as usize];
                found[usize::from(other != shell[edge[0] as usize])].add(at, depth);
            });
        }
        found
    });
    let mut total = [Crossings::default(); 2];
    for block in &blocks {
        total[0].join(&block[0]);
        total[1].join(&block[1]);
    }
    work.check().map(|()| total)
}

/// A plane: unit normal, and its product with a point of the plane.
type Plane = ([f64; 3], f64);

struct Search<'a> {
    mesh: &'a Mesh,
    edges: &'a Edges,
    tree: BoxTree,
    /// None for triangles without a height.
    planes: Vec<Option<Plane>>,
    touch: f64,
}

impl<'a> Search<'a> {
    fn new(mesh: &'a Mesh, edges: &'a Edges, work: &Work) -> Self {
        let [low, high] = mesh.bounds();
        let touch = TOUCH * dot(minus(high, low), minus(high, low)).sqrt();
        let boxes: Vec<AlignedBox> = (0..mesh.triangles.len())
            .map(|t| AlignedBox::around(mesh.corners(t), touch))
            .collect();
        let planes = (0..mesh.triangles.len())
            .map(|t| plane(mesh.corners(t), touch))
            .collect();
        Search {
            mesh,
            edges,
            tree: BoxTree::of(&boxes, work),
            planes,
            touch,
        }
    }

    /// Hands out the triangles that an edge runs through, with the place and the depth of its nearer end.
    fn for_each_crossing(&self, edge: [u32; 2], mut found: impl FnMut(u32, [f64; 3], f64)) {
        let ends = edge.map(|v| self.mesh.vertices[v as usize]);
        let [from, to] = ends;
        self.tree.along(from, minus(to, from), 1.0, |places| {
            for &t in &self.tree.order()[places] {
                let corners = self.mesh.triangles[t as usize];
                if !corners.contains(&edge[0])
                    && !corners.contains(&edge[1])
                    && let Some((at, depth)) = self.crossing(ends, t)
                {
                    found(t, at, depth);
                }
            }
            f64::INFINITY
        });
    }

    fn crossing(&self, [p, q]: [[f64; 3]; 2], triangle: u32) -> Option<([f64; 3], f64)> {
        let plane = self.planes[triangle as usize].as_ref()?;
        let [dp, dq] = [p, q].map(|end| above(plane, end));
        if !self.apart(dp, dq) {
            return None;
        }
        let share = dp / (dp - dq);
        let at = std::array::from_fn(|i| p[i] + share * (q[i] - p[i]));
        let corners = self.mesh.corners(triangle as usize);
        let mut on_side = None;
        for i in 0..3 {
            let (from, to) = (corners[i], corners[(i + 1) % 3]);
            let along = minus(to, from);
            let inward = cross(plane.0, along);
            let inside = dot(minus(at, from), inward) / dot(along, along).sqrt();
            if inside < -self.touch {
                return None;
            }
            if inside <= self.touch && on_side.replace(i).is_some() {
                return None; // at a corner
            }
        }
        match on_side {
            Some(side) if !self.through_wedge([p, q], triangle, side) => None,
            _ => Some((at, dp.abs().min(dq.abs()))),
        }
    }

    /// Whether two heights over a plane are of opposite sign and more than a touch.
    fn apart(&self, a: f64, b: f64) -> bool {
        a * b < 0.0 && a.abs().min(b.abs()) > self.touch
    }

    /// Whether the ends lie on different sides of the two triangles that meet in a side of this one. Of the two, the one
    /// with the lower number counts.
    fn through_wedge(&self, ends: [[f64; 3]; 2], triangle: u32, side: usize) -> bool {
        let corners = self.mesh.triangles[triangle as usize];
        let [first, second] = self.edges.of(corners[side], corners[(side + 1) % 3]) else {
            return false;
        };
        let other = first.triangle.max(second.triangle);
        if other == triangle {
            return false;
        }
        let [Some(one), Some(two)] = [triangle, other].map(|t| self.planes[t as usize].as_ref())
        else {
            return false;
        };
        let tip = self.mesh.triangles[other as usize]
            .into_iter()
            .find(|v| !corners.contains(v));
        let ridge = tip.is_none_or(|v| above(one, self.mesh.vertices[v as usize]) <= 0.0);
        let [p, q] = ends.map(|end| {
            let heights = [above(one, end), above(two, end)];
            let clear = heights.iter().all(|h| h.abs() > self.touch);
            let [a, b] = heights.map(|h| h < 0.0);
            clear.then_some(if ridge { a && b } else { a || b })
        });
        matches!((p, q), (Some(p), Some(q)) if p != q)
    }
}

fn above((normal, offset): &Plane, point: [f64; 3]) -> f64 {
    dot(*normal, point) - offset
}

/// The plane of a triangle whose heights are more than a touch: that of a sliver is anybody's guess.
fn plane([a, b, c]: [[f64; 3]; 3], touch: f64) -> Option<Plane> {
    let sides = [minus(b, a), minus(c, b), minus(a, c)];
    let normal = cross(sides[0], sides[1]);
    let double_area = dot(normal, normal).sqrt();
    let longest = sides.iter().map(|s| dot(*s, *s)).fold(0.0, f64::max).sqrt();
    (double_area > touch * longest).then(|| {
        let unit = normal.map(|v| v / double_area);
        (unit, dot(unit, a))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::placing::turned;
    use tomolith_io::mesh::samples::{ball, cuboid, together};

    fn crossings_of(mesh: &Mesh) -> [Crossings; 2] {
        find_crossings(mesh, &Work::new()).unwrap()
    }

    /// Coordinates as an STL file keeps them.
    fn rounded(mut mesh: Mesh) -> Mesh {
        for value in mesh.vertices.iter_mut().flatten() {
            *value = f64::from(*value as f32);
        }
        mesh
    }

    #[test]
    fn shells_that_touch_or_lie_in_each_other_do_not_cross_whichever_way_they_are_turned() {
        let big = cuboid([0.0; 3], [2.0; 3]);
        for other in [
            cuboid([2.0, 0.0, 0.0], [3.0, 2.0, 2.0]),   // face to face
            cuboid([2.0, -1.0, -1.0], [3.0, 3.0, 3.0]), // a larger face
            cuboid([2.0, 0.5, 0.3], [3.0, 2.5, 1.0]),   // a face that sticks out
            cuboid([2.0, 2.0, -1.0], [3.0, 3.0, 3.0]),  // edge to edge
            cuboid([0.5; 3], [1.5; 3]),
            cuboid([0.0, 0.5, 0.5], [1.0; 3]), // inside, on a face
        ] {
            for angles in [[0.0; 3], [31.0, -17.0, 66.0], [90.0, 45.0, 10.0]] {
                let mesh = turned(together(&[big.clone(), other.clone()]), angles);
                for mesh in [mesh.welded(), rounded(mesh)] {
                    let found = crossings_of(&mesh);
                    assert_eq!(found.map(|c| c.count), [0, 0], "{angles:?}: {found:?}");
                }
            }
        }
    }

    #[test]
    fn shells_that_run_into_each_other_cross_where_their_edges_pass_through_faces() {
        // A square rod through two opposite faces of a cube
        let rod = cuboid([0.5, 0.6, -1.0], [1.3, 1.2, 3.0]);
        let mesh = together(&[cuboid([0.0; 3], [2.0; 3]), rod]);
        let [itself, other] = crossings_of(&mesh);
        assert_eq!(itself.count, 0);
        // 4 edges and 4 diagonals of the rod through bottom and top, and their diagonals through two sides of the rod
        assert_eq!(other.count, 2 * 8 + 2 * 2);
        let [x, y, z] = other.at.unwrap();
        assert!((0.5..=1.3).contains(&x) && (0.6..=1.2).contains(&y) && (z == 0.0 || z == 2.0));
    }

    #[test]
    fn an_edge_through_the_diagonal_of_a_face_counts_whichever_way_it_is_turned() {
        // Three edges of each cube meet a face of the other on its diagonal
        let mesh = together(&[cuboid([0.0; 3], [2.0; 3]), cuboid([1.0; 3], [3.0; 3])]);
        let [itself, other] = crossings_of(&mesh);
        assert_eq!(itself.count, 0);
        assert!(other.count >= 6, "{other:?}");
        let alone = turned(mesh, [10.0, 20.0, 30.0]);
        assert_eq!(crossings_of(&alone)[1].count, other.count);
        let at = other.at.unwrap();
        assert!(at.iter().all(|v| (1.0..=2.0).contains(v)), "{at:?}");
    }

    #[test]
    fn a_dent_that_comes_out_on_the_other_side_is_found_and_located() {
        // One vertex of a fine ball pulled through the opposite side: far too thin for the lattice of lines
        let mut mesh = ball([0.0; 3], 1.0, 4);
        assert_eq!(crossings_of(&mesh).map(|c| c.count), [0, 0]);
        let top = (0..mesh.vertices.len())
            .max_by(|&a, &b| mesh.vertices[a][2].total_cmp(&mesh.vertices[b][2]))
            .unwrap();
        mesh.vertices[top][2] = -1.2;
        let [itself, other] = crossings_of(&mesh);
        assert!(itself.count >= 5, "{itself:?}");
        assert_eq!(other.count, 0);
        let [x, y, z] = itself.at.unwrap();
        assert!(x.hypot(y) < 0.1 && (z + 1.0).abs() < 0.01, "{itself:?}");
    }

    #[test]
    fn less_than_a_touch_is_no_crossing() {
        let pair = |gap: f64| {
            let low = cuboid([0.0; 3], [1.0; 3]);
            together(&[low, cuboid([0.2, 0.3, 1.0 + gap], [0.7, 0.8, 2.0])])
        };
        // The diagonal is 2.45: a touch is 2.45e-5
        assert_eq!(crossings_of(&pair(-2e-5))[1].count, 0);
        assert!(crossings_of(&pair(-3e-5))[1].count >= 4);
    }
}
