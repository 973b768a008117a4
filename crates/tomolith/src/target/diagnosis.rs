//! What is wrong with a mesh, in words, and the mesh made closed and outward.
//!
//! A solid is what lies where the winding number is positive. That needs a closed surface that looks outward, so a mesh
//! goes through six steps, and every change is said in [`Diagnosis::sentences`]:
//!
//! 1. **Orientation**: neighbours that disagree (an edge used twice in the same direction) are turned, the minority of a
//!    patch to the majority.
//! 2. **Holes**: edges without a partner are closed by a fan to the middle of their loop. That closes flat holes exactly
//!    and others plausibly.
//! 3. **Inside out**: with negative volume as a whole, all triangles are turned.
//! 4. **Shells**: a shell of negative volume inside another shell is a cavity and stays; one that lies in no shell is
//!    turned.
//! 5. **Crossings**: [edges that run through triangles](Crossings), of their own shell or of another, are counted and the
//!    deepest is located; surfaces that touch, or lie in each other, do not cross.
//! 6. **Overlap**: lines on a lattice of 256 along the longer of y and z look for winding numbers above 1 (shells that
//!    intersect or lie in each other: their union counts) or below 0 (surfaces that pass through themselves; such
//!    places count as outside). It measures overlaps that are thicker than 1/256 of the part.

mod crossings;
mod edges;
mod holes;
mod overlaps;
mod shells;

use crate::error::{Error, Result};
use crate::io::mesh::{Mesh, dot, minus};
pub use crossings::Crossings;
use crossings::find_crossings;
use edges::{Edges, agree, turn};
use holes::close;
use overlaps::find_overlaps;
use shells::turn_lone_shells;
use std::path::Path;

/// A mesh counts as flat when its volume is below this share of area × diagonal: 10⁴ times the rounding of the sum.
const FLAT: f64 = 1e-12;

/// What was found in a mesh; lengths in mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// Triangles, without those that close holes.
    pub triangles: usize,
    /// Edges of one triangle only.
    pub open_edges: usize,
    /// A point on an open edge.
    pub open_at: Option<[f64; 3]>,
    /// Holes that were closed by a fan.
    pub holes: usize,
    /// Edges of three or more triangles.
    pub non_manifold_edges: usize,
    /// A point on such an edge.
    pub non_manifold_at: Option<[f64; 3]>,
    /// Edges whose two triangles disagree about the outside.
    pub inconsistent_edges: usize,
    /// Triangles that were turned to agree with their neighbours.
    pub turned_triangles: usize,
    /// Whether the whole mesh was inside out.
    pub inside_out: bool,
    /// Volume of every shell after all repairs, cavities negative, mm³.
    pub shell_volumes_mm3: Vec<f64>,
    /// Shells that were inside out on their own and were turned: a point on each.
    pub turned_shells_at: Vec<[f64; 3]>,
    /// Edges that run through a triangle of their own shell.
    pub own_crossings: Crossings,
    /// Edges that run through a triangle of another shell.
    pub shell_crossings: Crossings,
    /// Volume where the winding number is 2 or more, mm³.
    pub overlap_mm3: f64,
    /// A point there.
    pub overlap_at: Option<[f64; 3]>,
    /// Volume where the winding number is negative, mm³.
    pub negative_mm3: f64,
    /// A point there.
    pub negative_at: Option<[f64; 3]>,
}

impl Diagnosis {
    /// Sum over the shells, cavities subtracted, mm³.
    #[must_use]
    pub fn signed_volume_mm3(&self) -> f64 {
        self.shell_volumes_mm3.iter().sum()
    }

    /// Whether the winding number was seen to be 0 or 1 everywhere, and no surface crosses another.
    #[must_use]
    pub fn is_simple(&self) -> bool {
        let crossings = self.own_crossings.count + self.shell_crossings.count;
        crossings == 0 && self.overlap_at.is_none() && self.negative_at.is_none()
    }

    /// One sentence for each thing that people should know; empty for a sound mesh.
    #[must_use]
    pub fn sentences(&self) -> Vec<String> {
        let mut said = Vec::new();
        if let Some(at) = self.open_at {
            said.push(format!(
                "The mesh is open: {} edges have one triangle only, the first near {}; {} {} closed by flat fans.",
                self.open_edges,
                place(at),
                self.holes,
                if self.holes == 1 { "hole was" } else { "holes were" },
            ));
        }
        if let Some(at) = self.non_manifold_at {
            said.push(format!(
                "{} edges belong to more than two triangles, the first near {}: shells that touch, or doubled faces.",
                self.non_manifold_edges,
                place(at)
            ));
        }
        if self.inconsistent_edges > 0 {
            said.push(format!(
                "Neighbouring triangles disagree about the outside at {} edges; {} triangles were turned.",
                self.inconsistent_edges, self.turned_triangles
            ));
        }
        if self.inside_out {
            said.push(
                "The whole mesh was inside out (negative volume); all triangles were turned."
                    .into(),
            );
        }
        if let Some(&at) = self.turned_shells_at.first() {
            said.push(format!(
                "{} of {} shells were inside out and lie in no other shell, the first near {}; they were turned.",
                self.turned_shells_at.len(),
                self.shell_volumes_mm3.len(),
                place(at)
            ));
        }
        said.extend(self.about_shells());
        said.extend(self.about_itself());
        said
    }

    /// Shells that intersect or lie in each other.
    fn about_shells(&self) -> Option<String> {
        let mut what = Vec::new();
        if let Some(at) = self.shell_crossings.at {
            let times = self.shell_crossings.count;
            let near = place(at);
            what.push(format!(
                "intersect (edges run through triangles {times} times, the deepest near {near})"
            ));
        }
        if let Some(at) = self.overlap_at {
            what.push(format!(
                "overlap or lie in each other over about {:.3} mm³, the longest stretch near {}",
                self.overlap_mm3,
                place(at)
            ));
        }
        let union = "their union is printed";
        (!what.is_empty()).then(|| format!("Shells {}; {union}.", what.join(" and ")))
    }

    /// Surfaces that pass through themselves.
    fn about_itself(&self) -> Option<String> {
        let mut what = Vec::new();
        if let Some(at) = self.own_crossings.at {
            what.push(format!(
                "edges run {} times through triangles of their own shell, the deepest near {}",
                self.own_crossings.count,
                place(at)
            ));
        }
        if let Some(at) = self.negative_at {
            what.push(format!(
                "about {:.3} mm³ near {} lie inside out and count as outside",
                self.negative_mm3,
                place(at)
            ));
        }
        (!what.is_empty())
            .then(|| format!("The surface passes through itself: {}.", what.join("; ")))
    }
}

fn place([x, y, z]: [f64; 3]) -> String {
    format!("({x:.3}, {y:.3}, {z:.3}) mm")
}

/// Examines a mesh and makes it closed and outward.
///
/// # Errors
/// [`Error::Mesh`] when it encloses no volume.
pub(super) fn examine(mut mesh: Mesh, path: &Path) -> Result<(Mesh, Diagnosis)> {
    let mut found = Diagnosis {
        triangles: mesh.triangles.len(),
        ..Diagnosis::default()
    };
    let edges = Edges::new(&mesh);
    edges.count(&mesh, &mut found);
    if found.inconsistent_edges > 0 {
        found.turned_triangles = agree(&mut mesh, &edges);
    }
    found.holes = close(&mut mesh);
    if mesh.signed_volume() < 0.0 {
        found.inside_out = true;
        mesh.triangles.iter_mut().for_each(turn);
    }
    turn_lone_shells(&mut mesh, &mut found);
    let [low, high] = mesh.bounds();
    let diagonal = dot(minus(high, low), minus(high, low)).sqrt();
    let volume = found.signed_volume_mm3();
    if volume <= FLAT * mesh.area() * diagonal {
        return Err(Error::Mesh {
            path: path.to_owned(),
            found: format!(
                "its {} triangles enclose no volume ({volume:e} mm³)",
                found.triangles
            ),
            accepted: "a closed surface round a volume".to_owned(),
        });
    }
    [found.own_crossings, found.shell_crossings] = find_crossings(&mesh);
    find_overlaps(&mesh, &mut found);
    Ok((mesh, found))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::mesh::samples::{ball, cuboid, inverted, together};

    fn found(mesh: Mesh) -> (Mesh, Diagnosis) {
        examine(mesh, Path::new("test")).unwrap()
    }

    #[test]
    fn sound_meshes_are_left_alone() {
        for mesh in [cuboid([0.0; 3], [1.0, 2.0, 3.0]), ball([1.0; 3], 2.0, 3)] {
            let (after, diagnosis) = found(mesh.clone());
            assert_eq!(after, mesh);
            assert_eq!(diagnosis.sentences(), Vec::<String>::new());
            assert_eq!(diagnosis.shell_volumes_mm3.len(), 1);
        }
    }

    #[test]
    fn a_hole_is_said_and_closed() {
        let mut mesh = cuboid([0.0; 3], [1.0, 2.0, 3.0]);
        mesh.triangles.drain(2..4); // the top, z = 3
        let (after, diagnosis) = found(mesh);
        assert_eq!((diagnosis.open_edges, diagnosis.holes), (4, 1));
        assert!((after.signed_volume() - 6.0).abs() < 1e-12);
        let said = diagnosis.sentences();
        assert!(
            said[0].contains("4 edges") && said[0].contains("3.000) mm"),
            "{said:?}"
        );
        assert!(diagnosis.is_simple());
    }

    #[test]
    fn turned_triangles_are_turned_back() {
        let mut mesh = ball([0.0; 3], 1.0, 3);
        let exact = mesh.signed_volume();
        for t in [5, 6, 300, 301, 302, 1000] {
            mesh.triangles[t].swap(0, 1);
        }
        let (after, diagnosis) = found(mesh);
        assert_eq!(diagnosis.turned_triangles, 6);
        assert!((after.signed_volume() - exact).abs() < 1e-12);
        assert!(diagnosis.sentences()[0].contains("6 triangles were turned"));
    }

    #[test]
    fn inside_out_meshes_and_shells_are_turned_and_cavities_kept() {
        let (_, diagnosis) = found(inverted(cuboid([0.0; 3], [1.0; 3])));
        assert!(diagnosis.inside_out && (diagnosis.signed_volume_mm3() - 1.0).abs() < 1e-12);
        let outer = cuboid([0.0; 3], [4.0; 3]);
        let cavity = inverted(cuboid([1.0; 3], [2.0; 3]));
        let lone = inverted(cuboid([6.0; 3], [8.0; 3]));
        let (_, diagnosis) = found(together(&[outer, cavity, lone]));
        let expected = [64.0, -1.0, 8.0];
        for (volume, expected) in diagnosis.shell_volumes_mm3.iter().zip(expected) {
            assert!(
                (volume - expected).abs() < 1e-9,
                "{:?}",
                diagnosis.shell_volumes_mm3
            );
        }
        assert_eq!(diagnosis.turned_shells_at, [[6.0; 3]]);
        assert_eq!(diagnosis.sentences().len(), 1);
        // A part that is mostly such shells is not inside out as a whole
        assert!(!diagnosis.inside_out);
    }

    #[test]
    fn overlaps_are_measured_and_located() {
        let (_, diagnosis) = found(together(&[
            cuboid([0.0; 3], [2.0; 3]),
            cuboid([1.0, 1.0, 1.0], [3.0, 3.0, 3.0]),
        ]));
        assert!(
            (diagnosis.overlap_mm3 - 1.0).abs() < 0.03,
            "{}",
            diagnosis.overlap_mm3
        );
        let at = diagnosis.overlap_at.unwrap();
        assert!(at.iter().all(|v| (1.0..=2.0).contains(v)), "{at:?}");
        assert!(diagnosis.sentences()[0].contains("their union is printed"));
        assert!(diagnosis.shell_crossings.count > 0 && diagnosis.own_crossings.count == 0);
        // Shells that touch do not overlap
        let (_, diagnosis) = found(together(&[
            cuboid([0.0; 3], [2.0; 3]),
            cuboid([2.0, 0.0, 0.0], [3.0, 2.0, 2.0]),
        ]));
        assert!(diagnosis.is_simple() && diagnosis.sentences().is_empty());
    }

    #[test]
    fn a_surface_through_itself_is_said() {
        // The apex of a pyramid pulled down through its base
        let mesh = Mesh {
            vertices: vec![
                [0.0, 0.0, 0.0],
                [4.0, 0.0, 0.0],
                [4.0, 4.0, 0.0],
                [0.0, 4.0, 0.0],
                [2.0, 2.0, 2.0],
                [1.0, 1.0, 0.0],
                [3.0, 1.0, 0.0],
                [3.0, 3.0, 0.0],
                [1.0, 3.0, 0.0],
                [2.0, 2.0, 3.0],
            ],
            triangles: vec![
                [0, 1, 4],
                [1, 2, 4],
                [2, 3, 4],
                [3, 0, 4],
                [0, 5, 6],
                [0, 6, 1],
                [1, 6, 7],
                [1, 7, 2],
                [2, 7, 8],
                [2, 8, 3],
                [3, 8, 5],
                [3, 5, 0],
                [5, 9, 6],
                [6, 9, 7],
                [7, 9, 8],
                [8, 9, 5],
            ],
        };
        let (_, diagnosis) = found(mesh);
        assert_eq!(diagnosis.open_edges, 0);
        // At height z the outer pyramid is 2·(2 − z) wide, the inner 2·(1 − z/3): from z = 1.5 on, 1 wide there, the inner
        // lies outside: a tip 1.5 high less one 0.5 high
        let exact = (1.5 - 0.5) / 3.0;
        assert!(
            (diagnosis.negative_mm3 - exact).abs() < 2e-3,
            "{} {exact}",
            diagnosis.negative_mm3
        );
        assert!(diagnosis.own_crossings.count > 0 && !diagnosis.is_simple());
        let said = diagnosis.sentences();
        assert!(
            said.len() == 1 && said[0].contains("passes through itself"),
            "{said:?}"
        );
    }

    #[test]
    fn doubled_faces_and_edges_of_many_triangles_are_said() {
        let touching = together(&[
            cuboid([0.0; 3], [1.0; 3]),
            cuboid([1.0, 1.0, 0.0], [2.0, 2.0, 1.0]),
        ])
        .welded();
        let (_, diagnosis) = found(touching);
        assert_eq!(diagnosis.non_manifold_edges, 1);
        assert!(
            diagnosis.sentences()[0].contains("(1.000, 1.000, 0.500) mm"),
            "{:?}",
            diagnosis.sentences()
        );
        assert!((diagnosis.signed_volume_mm3() - 2.0).abs() < 1e-12);
    }

    #[test]
    fn flat_meshes_are_refused() {
        let mut sheet = cuboid([0.0; 3], [1.0, 2.0, 0.0]);
        let refused = |mesh: Mesh| examine(mesh, Path::new("a.stl")).unwrap_err().to_string();
        assert!(refused(sheet.clone()).contains("enclose no volume"));
        sheet.triangles.truncate(2);
        assert!(refused(sheet.welded()).starts_with("mesh a.stl: its "));
        // A thin plate is no sheet
        found(cuboid([0.0; 3], [10.0, 10.0, 1e-5]));
    }
}
