//! A vial of any shape: meshes as outer and inner wall.
//!
//! # Model
//! The outer mesh holds the glass, the inner one the resin; rays are refracted at their triangles as they stand, so curved
//! walls want fine ones (a facet of width w on a wall of radius R turns its normal by up to w/2R). Files are in
//! millimeters times `scale`, in the frame of the vial: z is its axis.
//!
//! # Limits
//! Walls do not cross, and are closed but for their lower and upper ends: a wall that ends there in one level ring goes on along the axis
//! as far as light reaches. Other gaps are refused, and so is an inner wall with a vertex outside of the outer one. Light enters
//! through whatever faces it, the bottom and the caps too.

use super::{BuildVial, CrossSection, Medium, Vial, Wall, positive};
use crate::projector::Ray;
use crate::surface::{Net, Surface, meeting};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tomolith_core::error::{Error, Result};
use tomolith_core::kind::{Kind, Section, schema_of};
use tomolith_core::units::concise;
use tomolith_io::mesh::{Mesh, read_mesh};

/// See the [module page](self).
#[derive(Clone, Debug)]
pub struct MeshVial {
    outer: Surface,
    inner: Surface,
    refractive_index: f64,
    /// No vertex is farther from the axis, mm.
    reach_mm: f64,
    /// Radii of circles about the axis that fit into the walls at the height of the origin, mm.
    inscribed_mm: [f64; 2],
    /// Of its files.
    notes: Vec<String>,
}

impl MeshVial {
    /// A vial of two walls; `key` is the job's table.
    ///
    /// # Errors
    /// [`Error::Config`] for a wall that is open elsewhere than at its ends, walls that cross, an axis outside of the resin.
    pub fn new(outer: &Mesh, inner: &Mesh, refractive_index: f64, key: &str) -> Result<Self> {
        let far = |mesh: &Mesh| {
            mesh.vertices
                .iter()
                .flatten()
                .fold(0.0, |far, v| v.abs().max(far))
        };
        let size = f64::max(far(outer), far(inner));
        let wall = |mesh: &Mesh, end: f64, name: &str| {
            let key = format!("{key}.{name}");
            let mesh = closed(mesh, end * size, &key)?;
            let net = Net::new(&mesh, &key)?;
            Ok((mesh, Surface::Net(Arc::new(net))))
        };
        let [inner_end, outer_end] = OPEN_ENDS;
        let (outer, outside) = wall(outer, outer_end, "outer")?;
        let (inner, inside) = wall(inner, inner_end, "inner")?;
        let (outer, inner) = (&outer, &inner);
        let crossing = inner.vertices.iter().find(|&&v| !outside.contains(v));
        let crossing = crossing.or_else(|| outer.vertices.iter().find(|&&v| inside.contains(v)));
        if let Some(vertex) = crossing {
            let [x, y, z] = vertex.map(concise);
            return Err(Error::config(
                format!("{key}.inner"),
                format!("the walls cross: the vertex ({x}, {y}, {z}) mm lies on the wrong side"),
                "an inner wall within the outer one",
            ));
        }
        let triangles = |mesh: &Mesh| {
            (0..mesh.triangles.len())
                .map(|i| mesh.corners(i))
                .collect::<Vec<_>>()
        };
        let edge =
            meeting(triangles(inner), &outside).or_else(|| meeting(triangles(outer), &inside));
        if let Some(place) = edge {
            let [x, y, z] = place.map(concise);
            return Err(Error::config(
                format!("{key}.inner"),
                format!("the walls meet at ({x}, {y}, {z}) mm"),
                "an inner wall within the outer one",
            ));
        }
        if !inside.contains([0.0; 3]) {
            return Err(Error::config(
                format!("{key}.inner"),
                "the origin, the middle of the axis, is not in the resin",
                "walls round the axis z",
            ));
        }
        let far = |mesh: &Mesh| {
            mesh.vertices
                .iter()
                .map(|v| v[0].hypot(v[1]))
                .fold(0.0, f64::max)
        };
        Ok(MeshVial {
            reach_mm: far(outer).max(far(inner)),
            inscribed_mm: [inscribed(&outside), inscribed(&inside)],
            outer: outside,
            inner: inside,
            refractive_index,
            notes: Vec::new(),
        })
    }
}

/// Where open ends of the inner and the outer wall are closed, in lengths of the largest coordinate of both: beyond what light reaches.
const OPEN_ENDS: [f64; 2] = [20.0, 21.0];
/// Corners of an open end lie in one plane within this part of that length.
const LEVEL: f64 = 1e-6;
/// Directions in which the distance from the axis to a wall is looked up.
const LOOKS: u32 = 256;
/// How far from an edge the next line of sight goes: far less than from one line to the next.
const ASIDE: f64 = 1e-6;

/// Radius of a circle about the axis, at the height of the origin, that the wall does not enter.
fn inscribed(wall: &Surface) -> f64 {
    let look = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let ray = Ray::new([0.0; 3], [cos, sin, 0.0]);
        wall.leave(&ray).map(|crossing| crossing.distance)
    };
    let distance = |i: u32| {
        let angle = TAU * f64::from(i) / f64::from(LOOKS);
        // Rounding may lead a line along an edge between its triangles: then another one next to it
        let asides = [0.0, ASIDE, -ASIDE];
        asides.into_iter().find_map(|aside| look(angle + aside))
    };
    let distances = (0..LOOKS).map(|i| distance(i).unwrap_or(0.0));
    distances.fold(f64::INFINITY, f64::min) * (PI / f64::from(LOOKS)).cos()
}

/// A wall whose open ends, level rings that are the lowest or the highest of it, go on along the axis to ± `end_mm` and are closed there.
/// Refuses any other edge that is not shared by two triangles of one sense.
fn closed(mesh: &Mesh, end_mm: f64, key: &str) -> Result<Mesh> {
    let open = open_edges(mesh);
    let heights = mesh.vertices.iter().map(|v| v[2]);
    let [low, high] = [
        heights.clone().fold(f64::INFINITY, f64::min),
        heights.fold(f64::NEG_INFINITY, f64::max),
    ];
    let is_at = |vertex: u32, height: f64| {
        (mesh.vertices[vertex as usize][2] - height).abs() <= LEVEL * end_mm
    };
    let mut closed = mesh.clone();
    let mut left = open.len();
    for (height, end) in [(low, -end_mm), (high, end_mm)] {
        let ring = open
            .iter()
            .filter(|edge| edge.iter().all(|&v| is_at(v, height)));
        let ring: Vec<[u32; 2]> = ring.copied().collect();
        if ring.is_empty() || !is_one_ring(&ring) {
            continue;
        }
        left -= ring.len();
        let middle = closed.vertices.len() as u32;
        closed.vertices.push([0.0, 0.0, end]);
        let mut far = HashMap::new();
        for &[from, _] in &ring {
            let [x, y, _] = mesh.vertices[from as usize];
            far.insert(from, closed.vertices.len() as u32);
            closed.vertices.push([x, y, end]);
        }
        for [a, b] in ring {
            let (far_a, far_b) = (far[&a], far[&b]);
            closed
                .triangles
                .extend([[b, a, far_a], [b, far_a, far_b], [far_b, far_a, middle]]);
        }
    }
    if left > 0 {
        return Err(Error::config(
            key,
            format!("{left} edges are open, or join triangles of opposite sense"),
            "a closed mesh, or a tube that is open at its lower and upper end (light would leak through other gaps)",
        ));
    }
    Ok(closed)
}

/// Directed edges of triangles that no other triangle has the other way round.
fn open_edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let mut edges: HashMap<[u32; 2], i64> = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let (edge, sense) = if from < to {
                ([from, to], 1)
            } else {
                ([to, from], -1)
            };
            *edges.entry(edge).or_default() += sense;
        }
    }
    let mut open: Vec<[u32; 2]> = edges
        .into_iter()
        .filter(|(_, sum)| *sum != 0)
        .map(|([a, b], sum)| if sum > 0 { [a, b] } else { [b, a] })
        .collect();
    open.sort_unstable();
    open
}

/// Whether directed edges follow one another in one closed ring.
fn is_one_ring(edges: &[[u32; 2]]) -> bool {
    let next: HashMap<u32, u32> = edges.iter().map(|&[from, to]| (from, to)).collect();
    let mut at = edges[0][0];
    for steps in 1..=edges.len() {
        match next.get(&at) {
            Some(&to) => at = to,
            None => return false,
        }
        if at == edges[0][0] {
            return steps == edges.len();
        }
    }
    false
}

impl Vial for MeshVial {
    /// Circles that fit into the walls: what a look from above knows of them.
    fn walls(&self) -> Vec<Wall> {
        let [outer, inner] = self.inscribed_mm;
        vec![
            Wall {
                curve: CrossSection::Circle(outer),
                inside: Medium::Clear(self.refractive_index),
            },
            Wall {
                curve: CrossSection::Circle(inner),
                inside: Medium::Resin,
            },
        ]
    }

    fn surfaces(&self) -> Vec<(Surface, Medium)> {
        vec![
            (self.outer.clone(), Medium::Clear(self.refractive_index)),
            (self.inner.clone(), Medium::Resin),
        ]
    }

    fn notes(&self) -> &[String] {
        &self.notes
    }

    fn outer_radius_mm(&self) -> f64 {
        self.reach_mm
    }

    fn is_invariant(&self) -> bool {
        false
    }

    fn is_convex(&self) -> bool {
        false // not known
    }

    fn is_round(&self) -> bool {
        false
    }

    fn in_resin(&self, point: [f64; 3]) -> bool {
        self.inner.contains(point)
    }
}

/// Keys of `[vial.mesh]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Mesh file of the outer wall, relative to the job.
    pub outer: PathBuf,
    /// Mesh file of the wall of the resin, relative to the job.
    pub inner: PathBuf,
    /// Refractive index of the glass.
    #[schemars(range(min = 1.0, max = 4.0))]
    pub refractive_index: f64,
    /// Millimeters per unit of the files, > 0.
    #[serde(default = "one")]
    pub scale: f64,
}

fn one() -> f64 {
    1.0
}

/// Row of [`VIALS`](super::VIALS).
pub const KIND: Kind<BuildVial> = Kind {
    name: "mesh",
    summary: "Meshes as outer and inner wall, of any shape; tubes may be open at their ends.",
    example: "[vial.mesh]\nouter = \"cuvette-outer.stl\"\ninner = \"cuvette-inner.stl\"\nrefractive_index = 1.47\n",
    schema: schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        let scale = positive(section, "scale", params.scale)?;
        let mut notes = Vec::new();
        let mut wall = |file: &Path, key: &str| read(section, file, key, scale, &mut notes);
        let (outer, inner) = (wall(&params.outer, "outer")?, wall(&params.inner, "inner")?);
        let vial = MeshVial::new(&outer, &inner, params.refractive_index, &section.path)?;
        Ok(Box::new(MeshVial { notes, ..vial }))
    },
};

fn read(
    section: &Section,
    file: &Path,
    key: &str,
    scale: f64,
    notes: &mut Vec<String>,
) -> Result<Mesh> {
    let path = section.file(file);
    let key = format!("{}.{key}", section.path);
    let file = read_mesh(&path).and_then(|file| file.whole(&path));
    let file = file.map_err(|error| {
        Error::config(
            key.as_str(),
            error.to_string(),
            "a mesh file that can be read",
        )
    })?;
    notes.extend(file.notes.iter().map(|note| format!("{key}: {note}")));
    let mut mesh = file.mesh;
    for value in mesh.vertices.iter_mut().flatten() {
        *value *= scale;
    }
    Ok(mesh)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_io::mesh::samples::cuboid;

    fn vial(outer: &Mesh, inner: &Mesh) -> Result<MeshVial> {
        MeshVial::new(outer, inner, 1.47, "vial.mesh")
    }

    fn cuvette(inner: [f64; 3]) -> Result<MeshVial> {
        let outer = cuboid([-3.0, -3.0, -5.0], [3.0, 3.0, 5.0]);
        vial(&outer, &cuboid(inner.map(|v| -v), inner))
    }

    #[test]
    fn it_knows_where_the_resin_is_and_how_much_fits() {
        let vial = cuvette([2.5, 2.4, 4.0]).unwrap();
        assert!(vial.in_resin([2.4, 2.3, 3.9]) && !vial.in_resin([0.0, 0.0, 4.5]));
        let fits = vial.resin_wall().inscribed_radius();
        assert!((2.39..=2.4).contains(&fits), "{fits}");
        assert!((vial.outer_radius_mm() - 18f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn edges_that_a_look_runs_along_are_no_gaps() {
        let turned = |half: f64| {
            let mut mesh = cuboid([-half, -half, -5.0], [half, half, 5.0]);
            for [x, y, _] in &mut mesh.vertices {
                let side = std::f64::consts::FRAC_1_SQRT_2;
                [*x, *y] = [(*x - *y) * side, (*x + *y) * side];
            }
            mesh
        };
        let mut inner = turned(2.0);
        inner.vertices.iter_mut().for_each(|v| v[2] *= 0.8);
        let vial = vial(&turned(3.0), &inner).unwrap();
        let fits = vial.resin_wall().inscribed_radius();
        assert!((1.999..=2.0).contains(&fits), "{fits}");
    }

    /// A box without its caps.
    fn tube(half: f64, height: f64) -> Mesh {
        let mut mesh = cuboid([-half, -half, -height], [half, half, height]);
        let height = |v: u32| mesh.vertices[v as usize][2];
        let is_level = |t: &[u32; 3]| t.iter().all(|&v| height(v) == height(t[0]));
        let sides = mesh.triangles.iter().filter(|t| !is_level(t));
        mesh.triangles = sides.copied().collect();
        assert_eq!(mesh.triangles.len(), 8);
        mesh
    }

    #[test]
    fn tubes_that_are_open_at_their_ends_go_on_there() {
        let open = vial(&tube(3.0, 5.0), &tube(2.5, 5.0)).unwrap();
        let fits = open.resin_wall().inscribed_radius();
        assert!((2.49..=2.5).contains(&fits), "{fits}");
        assert!(open.in_resin([2.4, -2.4, 40.0]) && !open.in_resin([2.6, 0.0, 40.0]));
        // A cup: closed below, open above
        let cup = |half: f64, bottom: f64| {
            let mut mesh = cuboid([-half, -half, bottom], [half, half, 5.0]);
            let is_top = |t: &[u32; 3]| t.iter().all(|&v| mesh.vertices[v as usize][2] == 5.0);
            let sides = mesh.triangles.iter().filter(|t| !is_top(t));
            mesh.triangles = sides.copied().collect();
            mesh
        };
        let held = vial(&cup(3.0, -5.0), &cup(2.5, -4.0)).unwrap();
        assert!(held.in_resin([0.0, 0.0, 40.0]) && !held.in_resin([0.0, 0.0, -4.5]));
        // The same ring, but a gap beside
        let mut torn = tube(2.5, 5.0);
        torn.triangles.pop();
        let text = vial(&tube(3.0, 5.0), &torn).unwrap_err();
        assert!(text.to_string().contains("edges are open"), "{text}");
    }

    #[test]
    fn walls_that_cross_or_are_open_are_refused() {
        let text = cuvette([3.5, 2.0, 4.0]).unwrap_err().to_string();
        tomolith_core::contains!(text, "vial.mesh.inner", "cross");
        let outer = cuboid([-3.0; 3], [3.0; 3]);
        let inner = cuboid([-1.0; 3], [1.0; 3]);
        let refused = |inner: &Mesh| vial(&outer, inner).unwrap_err().to_string();
        let mut open = inner.clone();
        open.triangles.pop();
        assert!(refused(&open).contains("3 edges are open"));
        let elsewhere = cuboid([1.0; 3], [2.0; 3]);
        assert!(refused(&elsewhere).contains("origin"));
    }
}
