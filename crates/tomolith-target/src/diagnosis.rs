//! What is wrong with a mesh, in words, and the mesh made closed and outward.
//!
//! A solid is what lies where the winding number is positive. That needs a closed surface that looks outward, so a mesh
//! goes through these steps, and [`Diagnosis::sentences`] reports every change:
//!
//! 1. **Doubles**: vertices on the two sides of a crack (1e-5 of the diagonal) are welded when that closes edges; copies of
//!    triangles, and walls without thickness, are dropped.
//! 2. **Orientation**: neighbors that disagree (an edge used twice in the same direction) are turned, the minority of a
//!    patch to the majority.
//! 3. **Holes**: edges without a partner are closed by a fan to the middle of their loop. That closes flat holes exactly,
//!    and small ones (1 % of the surface) plausibly.
//! 4. **Inside out**: a shell of negative volume inside a solid is a cavity and stays. One that lies in no solid is
//!    turned, and with it all shells that lie in it: a mirrored part keeps its cavities.
//! 5. **Crossings**: [edges that run through triangles](Crossings), of their own shell or of another, are counted and the
//!    deepest is located; surfaces that touch, or lie in each other, do not cross.
//! 6. **Overlap**: lines on a lattice of 256 along the longer of y and z look for winding numbers above 1 (shells that
//!    intersect or lie in each other: their union counts) or below 0 (surfaces that pass through themselves; such
//!    places count as outside). It measures overlaps that are thicker than 1/256 of the part.
//!
//! A large hole that is not flat, or a surface with one side only (a Möbius strip), cannot be repaired but by a guess:
//! such a mesh is refused unless [`Repair::Force`] asks for it. A mesh without volume is always refused.

mod crossings;
mod edges;
mod holes;
mod overlaps;
mod shells;
mod tidy;

pub use crossings::Crossings;
use crossings::find_crossings;
use edges::{Edges, agree};
use holes::close;
use overlaps::find_overlaps;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
pub(super) use shells::components;
use shells::turn_bodies;
use std::path::Path;
use tidy::{drop_doubles, weld_cracks};
use tomolith_core::error::{Error, Result};
use tomolith_core::units::{concise, counted};
use tomolith_core::vector::{dot, minus};
use tomolith_core::work::Work;
use tomolith_io::mesh::Mesh;

/// A mesh counts as flat when its volume is below this share of area × diagonal: 10⁴ times the rounding of the sum.
const FLAT: f64 = 1e-12;

/// How far repairs of a mesh may go.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Repair {
    /// Repair what can be repaired safely, refuse the rest.
    #[default]
    Safe,
    /// Close any hole and go on, whatever comes out.
    Force,
}

/// What was found in a mesh; lengths in mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// Triangles of the file.
    pub triangles: usize,
    /// Vertices that were welded to others across a crack.
    pub welded_vertices: usize,
    /// Triangles that were dropped as copies of others.
    pub copied_triangles: usize,
    /// Triangles that were dropped because they stood back to back.
    pub back_to_back_triangles: usize,
    /// Edges of one triangle only.
    pub open_edges: usize,
    /// A point on an open edge.
    pub open_at: Option<[f64; 3]>,
    /// Holes that were closed by a fan.
    pub holes: usize,
    /// Those of them that are neither flat nor small.
    pub guessed_holes: usize,
    /// The middle of one.
    pub guessed_hole_at: Option<[f64; 3]>,
    /// Edges of three or more triangles.
    pub non_manifold_edges: usize,
    /// A point on such an edge.
    pub non_manifold_at: Option<[f64; 3]>,
    /// Edges whose two triangles disagree about the outside.
    pub inconsistent_edges: usize,
    /// Triangles that were turned to agree with their neighbors.
    pub turned_triangles: usize,
    /// Edges that still disagree then: the surface has one side only.
    pub one_sided_edges: usize,
    /// Whether all shells were inside out.
    pub inside_out: bool,
    /// Volume of every shell after all repairs, cavities negative, mm³.
    pub shell_volumes_mm3: Vec<f64>,
    /// Shells that were inside out and were turned: a point on each.
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
        let mut sentences = Vec::new();
        if self.welded_vertices > 0 {
            sentences.push(format!(
                "The surface had cracks: {} vertices were welded to others next to them.",
                self.welded_vertices
            ));
        }
        if self.copied_triangles > 0 {
            sentences.push(format!(
                "{} triangles occurred more than once; the copies were dropped.",
                self.copied_triangles
            ));
        }
        if self.back_to_back_triangles > 0 {
            sentences.push(format!(
                "{} triangles stood back to back, walls without thickness; they were dropped.",
                self.back_to_back_triangles
            ));
        }
        if let Some(at) = self.open_at {
            sentences.push(format!(
                "The mesh is open: {} edges have one triangle only, the first near {}; {} {} closed by flat fans.",
                self.open_edges,
                place(at),
                self.holes,
                if self.holes == 1 { "hole was" } else { "holes were" },
            ));
        }
        if self.one_sided_edges > 0 || self.guessed_holes > 0 {
            sentences.push(format!(
                "Repaired by a guess, as target.repair = \"force\" asks: {}.",
                self.guesses().join("; ")
            ));
        }
        if let Some(at) = self.non_manifold_at {
            sentences.push(format!(
                "{} edges belong to more than two triangles, the first near {}: shells that touch, or doubled faces.",
                self.non_manifold_edges,
                place(at)
            ));
        }
        if self.inconsistent_edges > 0 {
            sentences.push(format!(
                "Neighboring triangles disagree about the outside at {}; {} {} turned.",
                counted(self.inconsistent_edges, "edge"),
                counted(self.turned_triangles, "triangle"),
                if self.turned_triangles == 1 {
                    "was"
                } else {
                    "were"
                },
            ));
        }
        if self.inside_out {
            sentences.push(
                "The whole mesh was inside out (negative volume); all triangles were turned."
                    .into(),
            );
        } else if let Some(&at) = self.turned_shells_at.first() {
            sentences.push(format!(
                "{} of {} shells belong to bodies that were inside out, the first near {}; they were turned.",
                self.turned_shells_at.len(),
                self.shell_volumes_mm3.len(),
                place(at)
            ));
        }
        sentences.extend(self.about_shells());
        sentences.extend(self.about_itself());
        sentences
    }

    /// What no repair can set right but by a guess.
    fn guesses(&self) -> Vec<String> {
        let mut what = Vec::new();
        if let Some(at) = self.guessed_hole_at {
            what.push(format!(
                "{} of its {} holes are neither flat nor small, the first near {}",
                self.guessed_holes,
                self.holes,
                place(at)
            ));
        }
        if self.one_sided_edges > 0 {
            what.push(format!(
                "its surface has one side only (neighbors disagree about the outside at {} edges, whichever way they \
                 are turned)",
                self.one_sided_edges
            ));
        }
        what
    }

    /// Shells that intersect or lie in each other.
    fn about_shells(&self) -> Option<String> {
        let mut what = Vec::new();
        if let Some(at) = self.shell_crossings.at {
            let times = counted(self.shell_crossings.count, "time");
            let near = place(at);
            what.push(format!(
                "intersect (edges run through triangles {times}, the deepest near {near})"
            ));
        }
        if let Some(at) = self.overlap_at {
            what.push(format!(
                "overlap or lie in each other over about {} mm³, the longest stretch near {}",
                concise(self.overlap_mm3),
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
                "edges run {} through triangles of their own shell, the deepest near {}",
                counted(self.own_crossings.count, "time"),
                place(at)
            ));
        }
        if let Some(at) = self.negative_at {
            what.push(format!(
                "about {} mm³ near {} lie inside out and count as outside",
                concise(self.negative_mm3),
                place(at)
            ));
        }
        (!what.is_empty())
            .then(|| format!("The surface passes through itself: {}.", what.join("; ")))
    }
}

fn place(at: [f64; 3]) -> String {
    let [x, y, z] = at.map(concise);
    format!("({x}, {y}, {z}) mm of the placed part")
}

/// Examines a mesh and makes it closed and outward.
/// Refuses one that encloses no volume, and one that cannot be repaired safely unless the caller forces it.
pub(super) fn examine(
    mut mesh: Mesh,
    path: &Path,
    repair: Repair,
    work: &Work,
) -> Result<(Mesh, Diagnosis)> {
    let mut found = Diagnosis {
        triangles: mesh.triangles.len(),
        ..Diagnosis::default()
    };
    found.welded_vertices = weld_cracks(&mut mesh);
    work.check()?;
    drop_doubles(&mut mesh, &mut found);
    work.check()?;
    let edges = Edges::new(&mesh);
    edges.count(&mesh, &mut found);
    if found.inconsistent_edges > 0 {
        found.turned_triangles = agree(&mut mesh, &edges);
        found.one_sided_edges = Edges::new(&mesh).inconsistent();
    }
    work.check()?;
    close(&mut mesh, &mut found);
    let guesses = found.guesses();
    if repair == Repair::Safe && !guesses.is_empty() {
        return Err(Error::Mesh {
            path: path.to_owned(),
            found: guesses.join("; "),
            accepted: "a closed mesh, or holes that are flat or at most 1 % of its surface; target.repair = \"force\" (`voxelize --repair force`) \
                       closes them by flat fans all the same"
                .to_owned(),
        });
    }
    work.check()?;
    turn_bodies(&mut mesh, &mut found);
    let [low, high] = mesh.bounds();
    let diagonal = dot(minus(high, low), minus(high, low)).sqrt();
    let volume = found.signed_volume_mm3();
    if volume <= FLAT * mesh.area() * diagonal {
        return Err(Error::Mesh {
            path: path.to_owned(),
            found: format!(
                "its {} triangles enclose no volume ({} mm³)",
                found.triangles,
                concise(volume)
            ),
            accepted: "a closed surface around a volume".to_owned(),
        });
    }
    [found.own_crossings, found.shell_crossings] = find_crossings(&mesh, work)?;
    find_overlaps(&mesh, &mut found, work);
    work.check().map(|()| (mesh, found))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;
    use tomolith_io::mesh::samples::{ball, cuboid, inverted, together};

    fn found(mesh: Mesh) -> (Mesh, Diagnosis) {
        examine(mesh, Path::new("test"), Repair::Safe, &Work::new()).unwrap()
    }

    fn refused(mesh: Mesh) -> String {
        let result = examine(mesh, Path::new("a.stl"), Repair::Safe, &Work::new());
        result.unwrap_err().to_string()
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
        let sentences = diagnosis.sentences();
        tomolith_core::contains!(sentences[0], "4 edges", ", 3) mm");
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
            near!(volume, expected, 1e-9, "{:?}", diagnosis.shell_volumes_mm3);
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
        near!(diagnosis.overlap_mm3, 1.0, 0.03);
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
        // The apex of a pyramid pulled down through its base: from the corners of the base to the outer apex 8, by those of a square in it to the inner one 9
        let square = |low: f64, high: f64| {
            [[low, low], [high, low], [high, high], [low, high]].map(|[x, y]| [x, y, 0.0])
        };
        let apexes = [[2.0, 2.0, 2.0], [2.0, 2.0, 3.0]];
        let sides = (0..4).flat_map(|i| {
            let [i, j] = [i, (i + 1) % 4];
            [
                [i, j, 8],
                [i, i + 4, j + 4],
                [i, j + 4, j],
                [i + 4, 9, j + 4],
            ]
        });
        let mesh = Mesh {
            vertices: [&square(0.0, 4.0)[..], &square(1.0, 3.0), &apexes].concat(),
            triangles: sides.collect(),
        };
        let (_, diagnosis) = found(mesh);
        assert_eq!(diagnosis.open_edges, 0);
        // At height z the outer pyramid is 2·(2 − z) wide, the inner 2·(1 − z/3): from z = 1.5 on, 1 wide there, the inner
        // lies outside: a tip 1.5 high less one 0.5 high
        near!(diagnosis.negative_mm3, (1.5 - 0.5) / 3.0, 2e-3);
        assert!(diagnosis.own_crossings.count > 0 && !diagnosis.is_simple());
        let sentences = diagnosis.sentences();
        assert_eq!(sentences.len(), 1, "{sentences:?}");
        tomolith_core::contains!(sentences[0], "passes through itself");
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
        tomolith_core::contains!(diagnosis.sentences()[0], "(1, 1, 0.5) mm");
        assert!((diagnosis.signed_volume_mm3() - 2.0).abs() < 1e-12);
        let cube = cuboid([0.0; 3], [1.0; 3]);
        let (after, diagnosis) = found(together(&[cube.clone(), cube.clone()]).welded());
        assert_eq!(after, cube.welded());
        let sentences = diagnosis.sentences().concat();
        tomolith_core::contains!(sentences, "12 triangles occurred more than once");
    }

    #[test]
    fn bodies_that_share_a_face_are_one_whichever_way_each_looks() {
        let pair = [
            cuboid([0.0; 3], [2.0; 3]),
            cuboid([2.0, 0.0, 0.0], [4.0, 2.0, 2.0]),
        ];
        for turned in 0..4 {
            let bodies: Vec<Mesh> = (pair.iter().cloned().enumerate())
                .map(|(i, body)| match turned >> i & 1 {
                    0 => body,
                    _ => inverted(body),
                })
                .collect();
            let (mesh, diagnosis) = found(together(&bodies).welded());
            assert!((mesh.signed_volume() - 16.0).abs() < 1e-12, "{turned}");
            let sentences = diagnosis.sentences();
            assert!(diagnosis.is_simple(), "{turned}: {sentences:?}");
        }
    }

    #[test]
    fn what_only_a_guess_repairs_is_refused_unless_forced() {
        // A third of a ball is missing: its rim is not flat
        let mut half = ball([0.0; 3], 1.0, 3);
        let corners: Vec<[[f64; 3]; 3]> =
            (0..half.triangles.len()).map(|t| half.corners(t)).collect();
        let mut keep = corners
            .iter()
            .map(|c| c.iter().all(|[x, y, _]| *x < 0.5 || *y < 0.1));
        half.triangles.retain(|_| keep.next().unwrap());
        let text = refused(half.clone());
        tomolith_core::contains!(text, "neither flat nor small", "target.repair");
        let forced = examine(half, Path::new("a.stl"), Repair::Force, &Work::new());
        let (_, diagnosis) = forced.unwrap();
        assert_eq!(diagnosis.guessed_holes, 1);
        tomolith_core::contains!(diagnosis.sentences().concat(), "Repaired by a guess");
        // A Möbius strip of seven quads, glued to a ball elsewhere so that there is a volume
        let n = 7;
        let mut strip = Mesh::default();
        for i in 0..n {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(n);
            for side in [-0.3, 0.3] {
                let (s, c) = (angle / 2.0).sin_cos();
                let r = 2.0 + side * c;
                strip
                    .vertices
                    .push([r * angle.cos(), r * angle.sin(), side * s]);
            }
        }
        for i in 0..n as u32 {
            let [a, b] = [2 * i, 2 * i + 1];
            let [c, d] = if i + 1 < n as u32 {
                [a + 2, b + 2]
            } else {
                [1, 0]
            };
            strip.triangles.extend([[a, c, b], [b, c, d]]);
        }
        let with_ball = together(&[strip, ball([9.0, 0.0, 0.0], 1.0, 2)]);
        tomolith_core::contains!(refused(with_ball), "one side only");
    }

    #[test]
    fn flat_meshes_are_refused() {
        let mut sheet = cuboid([0.0; 3], [1.0, 2.0, 0.0]);
        tomolith_core::contains!(refused(sheet.clone()), "enclose no volume (0 mm³)");
        tomolith_core::contains!(refused(inverted(sheet.clone())), "(0 mm³)");
        sheet.triangles.truncate(2);
        assert!(refused(sheet.welded()).starts_with("mesh a.stl: its "));
        // A thin plate is no sheet
        found(cuboid([0.0; 3], [10.0, 10.0, 1e-5]));
    }
}
