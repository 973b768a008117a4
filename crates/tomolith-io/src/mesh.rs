//! Triangle meshes: STL, OBJ, PLY and 3MF in.
//!
//! | extension | what is read |
//! |---|---|
//! | `stl` | ASCII (several solids too) and binary; the file's length decides |
//! | `obj` | vertices and faces; polygons are cut into triangle fans, everything else is skipped |
//! | `ply` | ASCII, binary little and big endian; `vertex` with x, y, z and `face` or `tristrips` with a list of indices |
//! | `3mf` | the build: items, components and their transforms, in the unit of the file; negative volumes of slicers |
//!
//! Lengths come out in the file's numbers (3MF: in mm). Equal vertices are welded to one, triangles with two equal
//! corners are dropped. Counts in headers are checked against the bytes that are there before anything is reserved, so a
//! damaged or hostile file ends in an error, not in a crash.
//!
//! ```
//! use std::path::Path;
//! use tomolith_io::mesh::parse_mesh;
//! let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
//! let mesh = parse_mesh(text.as_bytes(), "obj", Path::new("corner.obj")).unwrap().mesh;
//! assert_eq!(mesh.vertices.len(), 4);
//! assert!((mesh.signed_volume() - 1.0 / 6.0).abs() < 1e-15); // a corner cut off a unit cube: 1·1·1/6
//! ```

mod obj;
mod ply;
pub mod samples;
mod stl;
#[cfg(test)]
mod tests;
mod text;
mod threemf;

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};
use tomolith_core::files::read_regular;
use tomolith_core::vector::{cross, dot, minus};

/// What [`read_mesh`] reads, for error messages.
pub const ACCEPTED: &str =
    "a mesh file: .stl (ASCII or binary), .obj, .ply (ASCII or binary) or .3mf";

/// Largest coordinate that is believed, in the file's unit: beyond it products of three lengths lose all digits.
const LARGEST_COORDINATE: f64 = 1e9;

/// Triangles on shared vertices; counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Points `[x, y, z]`.
    pub vertices: Vec<[f64; 3]>,
    /// Three indices into `vertices` per triangle.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The corners of triangle `index`.
    ///
    /// # Panics
    /// When there is no such triangle, or it names a vertex that is not there.
    #[must_use]
    pub fn corners(&self, index: usize) -> [[f64; 3]; 3] {
        self.triangles[index].map(|v| self.vertices[v as usize])
    }

    /// Lowest and highest corner `[x, y, z]` of the box round all vertices; infinite and reversed without vertices.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for vertex in &self.vertices {
            for axis in 0..3 {
                low[axis] = low[axis].min(vertex[axis]);
                high[axis] = high[axis].max(vertex[axis]);
            }
        }
        [low, high]
    }

    /// Volume by the divergence theorem: positive when closed and counter-clockwise seen from outside.
    ///
    /// Taken from the middle of the box, so that an offset costs no digits.
    #[must_use]
    pub fn signed_volume(&self) -> f64 {
        let [low, high] = self.bounds();
        let middle: [f64; 3] = std::array::from_fn(|i| (low[i] + high[i]) / 2.0);
        (0..self.triangles.len())
            .map(|t| {
                let [a, b, c] = self.corners(t).map(|p| minus(p, middle));
                dot(a, cross(b, c))
            })
            .sum::<f64>()
            / 6.0
    }

    /// Area of all triangles.
    #[must_use]
    pub fn area(&self) -> f64 {
        (0..self.triangles.len())
            .map(|t| {
                let [a, b, c] = self.corners(t);
                let normal = cross(minus(b, a), minus(c, a));
                dot(normal, normal).sqrt() / 2.0
            })
            .sum()
    }

    /// A mesh of triangles given by their corners; equal corners share a vertex.
    pub fn of_corners(triangles: impl Iterator<Item = [[f64; 3]; 3]>) -> Mesh {
        let mut welder = Welder::default();
        triangles.for_each(|corners| welder.push(corners));
        welder.mesh
    }

    /// One vertex per place: equal vertices become one, triangles with two equal corners and unused vertices go.
    #[must_use]
    pub fn welded(&self) -> Mesh {
        Mesh::of_corners((0..self.triangles.len()).map(|t| self.corners(t)))
    }
}

/// Collects triangles given by their corners.
#[derive(Default)]
struct Welder {
    mesh: Mesh,
    known: HashMap<[u64; 3], u32>,
}

impl Welder {
    fn push(&mut self, corners: [[f64; 3]; 3]) {
        let triangle = corners.map(|corner| self.vertex(corner));
        if triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0] {
            self.mesh.triangles.push(triangle);
        }
    }

    fn vertex(&mut self, point: [f64; 3]) -> u32 {
        // Adding zero turns −0 into +0, which have different bits
        let point = point.map(|v| v + 0.0);
        let next = u32::try_from(self.mesh.vertices.len()).unwrap_or(u32::MAX);
        let index = *self.known.entry(point.map(f64::to_bits)).or_insert(next);
        if index == next {
            self.mesh.vertices.push(point);
        }
        index
    }
}

/// What a mesh file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshFile {
    /// The surface of what is there.
    pub mesh: Mesh,
    /// The surface of what is taken out of it: negative volumes of slicers; empty in most files.
    pub negative: Mesh,
    /// What people should know of the file, one sentence each.
    pub notes: Vec<String>,
}

impl MeshFile {
    /// The mesh, where nothing is taken out of the surface; `path` names the file in errors.
    ///
    /// # Errors
    /// [`Error::Mesh`] where there are negative volumes.
    pub fn whole(self, path: &Path) -> Result<Self> {
        if self.negative.triangles.is_empty() {
            return Ok(self);
        }
        let found = "negative volumes are taken out of it";
        Err(bad(path, found, "a mesh that is whole by itself"))
    }
}

impl From<Mesh> for MeshFile {
    fn from(mesh: Mesh) -> Self {
        MeshFile {
            mesh,
            ..MeshFile::default()
        }
    }
}

/// Reads a mesh file; the format follows from the extension, in upper or lower case.
///
/// # Errors
/// [`Error::Io`] when the file cannot be read; [`Error::Mesh`] when its extension is unknown or its content is no mesh:
/// empty, truncated, damaged, with a coordinate that is no number, an index to a missing vertex, or no area at all.
pub fn read_mesh(path: impl AsRef<Path>) -> Result<MeshFile> {
    let path = path.as_ref();
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or_default();
    format_of(extension, path)?;
    let bytes = read_regular(path)?;
    parse_mesh(&bytes, extension, path)
}

/// Reads a mesh from memory; `path` only names it in errors.
///
/// # Errors
/// [`Error::Mesh`] as in [`read_mesh`].
pub fn parse_mesh(bytes: &[u8], extension: &str, path: &Path) -> Result<MeshFile> {
    let parse = format_of(extension, path)?;
    let mut collector = Collector {
        path,
        read: 0,
        mesh: Welder::default(),
        negative: Welder::default(),
        notes: Vec::new(),
    };
    if bytes.is_empty() {
        return Err(collector.refusal("the file is empty", ACCEPTED));
    }
    parse(bytes, &mut collector)?;
    check_whole(&collector)?;
    Ok(MeshFile {
        mesh: collector.mesh.mesh,
        negative: collector.negative.mesh,
        notes: collector.notes,
    })
}

/// Whether a file's name is that of a mesh.
#[must_use]
pub fn is_mesh(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str());
    extension.is_some_and(|extension| format_of(extension, path).is_ok())
}

type Parse = fn(&[u8], &mut Collector) -> Result<()>;

fn format_of(extension: &str, path: &Path) -> Result<Parse> {
    match extension.to_ascii_lowercase().as_str() {
        "stl" => Ok(stl::parse),
        "obj" => Ok(obj::parse),
        "ply" => Ok(ply::parse),
        "3mf" => Ok(threemf::parse),
        "" => Err(bad(path, "the name has no extension", ACCEPTED)),
        other => Err(bad(
            path,
            format!("extension `.{other}` is not known"),
            ACCEPTED,
        )),
    }
}

/// Collects what a file holds.
struct Collector<'a> {
    path: &'a Path,
    /// Triangles so far.
    read: usize,
    mesh: Welder,
    negative: Welder,
    notes: Vec<String>,
}

impl Collector<'_> {
    fn triangle(&mut self, corners: [[f64; 3]; 3]) -> Result<()> {
        self.check(corners)?;
        self.mesh.push(corners);
        Ok(())
    }

    /// A triangle of what is taken out.
    fn negative(&mut self, corners: [[f64; 3]; 3]) -> Result<()> {
        self.check(corners)?;
        self.negative.push(corners);
        Ok(())
    }

    /// Cuts a polygon into triangles round its first corner.
    fn fan(&mut self, corners: &[[f64; 3]]) -> Result<()> {
        let mut pairs = corners.windows(2).skip(1);
        pairs.try_for_each(|pair| self.triangle([corners[0], pair[0], pair[1]]))
    }

    fn note(&mut self, sentence: String) {
        self.notes.push(sentence);
    }

    fn refusal(&self, found: impl Into<String>, accepted: impl Into<String>) -> Error {
        bad(self.path, found, accepted)
    }

    fn check(&mut self, corners: [[f64; 3]; 3]) -> Result<()> {
        self.read += 1;
        let is_bad = |v: &&f64| !v.is_finite() || v.abs() > LARGEST_COORDINATE;
        match corners.iter().flatten().find(is_bad) {
            None => Ok(()),
            Some(value) => Err(self.refusal(
                format!(
                    "triangle {} has a corner with coordinate {value}",
                    self.read
                ),
                format!("finite coordinates up to ±{LARGEST_COORDINATE:e}"),
            )),
        }
    }
}

fn check_whole(collector: &Collector) -> Result<()> {
    let (mesh, read, path) = (&collector.mesh.mesh, collector.read, collector.path);
    if read == 0 {
        return Err(bad(path, "there is no triangle in it", ACCEPTED));
    }
    if mesh.vertices.len() >= u32::MAX as usize {
        return Err(bad(
            path,
            "too many vertices",
            "fewer than 4 294 967 295 vertices",
        ));
    }
    let area = mesh.area();
    if mesh.triangles.is_empty() || area <= 0.0 {
        return Err(bad(
            path,
            format!("its {read} triangles have no area"),
            "a closed surface around a volume",
        ));
    }
    Ok(())
}

fn bad(path: &Path, found: impl Into<String>, accepted: impl Into<String>) -> Error {
    Error::Mesh {
        path: PathBuf::from(path),
        found: found.into(),
        accepted: accepted.into(),
    }
}
