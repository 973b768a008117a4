//! A mesh as a shape.

use super::Shape;
use super::diagnosis::{Diagnosis, Repair, examine};
use super::placing::{Map, Placement};
use super::voxels::inside_fractions;
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::run::Run;
use tomolith_io::mesh::{Mesh, MeshFile};

/// A placed mesh: closed, outward, in mm.
#[derive(Clone, Debug)]
pub struct MeshShape {
    mesh: Mesh,
    /// What is taken out of it.
    negative: Option<Mesh>,
    /// What people should know of the file.
    notes: Vec<String>,
    bounds_mm: [[f64; 3]; 2],
    diagnosis: Diagnosis,
}

impl MeshShape {
    /// Places and examines a mesh; `path` names it in errors, `section` the job's table. Its triangles must share vertices
    /// where they meet, as those of files do ([`Mesh::welded`]). Flaws are repaired as far as [`Repair`] goes.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) for a bad placement, [`Error::Mesh`](tomolith_core::Error::Mesh) when the mesh
    /// encloses no volume or cannot be repaired.
    pub fn new(
        file: impl Into<MeshFile>,
        placement: &Placement,
        path: &Path,
        section: &str,
        repair: Repair,
    ) -> Result<Self> {
        let file = file.into();
        let map = placement.map(&file.mesh.vertices, 0.0, section)?;
        Self::placed(file, &map, path, repair, &Run::new())
    }

    /// The same as part of a run, with a map that is known.
    pub(super) fn placed(
        file: MeshFile,
        map: &Map,
        path: &Path,
        repair: Repair,
        run: &Run,
    ) -> Result<Self> {
        let placed = |mut mesh: Mesh| {
            map.apply_to(&mut mesh);
            mesh
        };
        let mesh = placed(file.mesh);
        let bounds_mm = mesh.bounds();
        let (mesh, diagnosis) = examine(mesh, path, repair, run)?;
        let mut notes = file.notes;
        let mut negative = None;
        if !file.negative.triangles.is_empty() {
            let (mesh, found) = examine(placed(file.negative), path, repair, run)?;
            let sentences = found.sentences().into_iter();
            notes.extend(sentences.map(|said| format!("Negative volumes: {said}")));
            negative = Some(mesh);
        }
        Ok(MeshShape {
            mesh,
            negative,
            notes,
            bounds_mm,
            diagnosis,
        })
    }

    /// What was found in the mesh.
    #[must_use]
    pub fn diagnosis(&self) -> &Diagnosis {
        &self.diagnosis
    }

    /// The placed mesh, closed and outward, mm; what is taken out of it is not.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }
}

impl Shape for MeshShape {
    fn bounds_mm(&self) -> [[f64; 3]; 2] {
        self.bounds_mm
    }

    fn sample_under(&self, grid: &VolumeGrid, run: &Run) -> Result<Volume<f32>> {
        inside_fractions(&self.mesh, self.negative.as_ref(), grid, run)
    }

    /// Known when the winding number is 0 or 1 everywhere; shells that overlap have a union, which has no simple formula.
    fn volume_mm3(&self) -> Option<f64> {
        let is_known = self.negative.is_none() && self.diagnosis.is_simple();
        is_known.then(|| self.diagnosis.signed_volume_mm3())
    }

    fn meshes(&self) -> Vec<&Mesh> {
        match self.negative {
            None => vec![&self.mesh],
            Some(_) => Vec::new(), // the surface of a difference is not known
        }
    }

    fn warnings(&self) -> Vec<String> {
        let mut all = self.notes.clone();
        all.extend(self.diagnosis.sentences());
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_io::mesh::parse_mesh;
    use tomolith_io::mesh::samples::{ball, cuboid, files, inverted, model, package, together};

    fn voxels(bytes: &[u8], extension: &str) -> Volume<f32> {
        let path = Path::new("part");
        let mesh = parse_mesh(bytes, extension, path).unwrap().mesh;
        let shape =
            MeshShape::new(mesh, &Placement::default(), path, "target", Repair::Safe).unwrap();
        shape
            .sample(&VolumeGrid::centered([24, 26, 28], 0.11))
            .unwrap()
    }

    /// A ball with an off-center cavity, in coordinates that f32 can hold.
    fn part() -> Mesh {
        let cavity = inverted(cuboid([-0.25, -0.5, 0.125], [0.5, 0.375, 0.625]));
        let mut mesh = together(&[ball([0.0; 3], 1.25, 3), cavity]);
        for value in mesh.vertices.iter_mut().flatten() {
            *value = f64::from(*value as f32);
        }
        mesh
    }

    #[test]
    fn every_format_gives_the_same_voxels() {
        let part = part();
        let files = files(&part);
        let first = voxels(&files[0].2, files[0].1);
        let volume: f32 = first.values.iter().sum::<f32>() * 0.11f32.powi(3);
        assert!((f64::from(volume) / part.signed_volume() - 1.0).abs() < 1e-5);
        for (kind, extension, bytes) in &files[1..] {
            assert_eq!(voxels(bytes, extension), first, "{extension} {kind}");
        }
    }

    #[test]
    fn items_of_a_package_are_placed_in_its_unit() {
        // In inches, a quarter turn about z (x → y) and 1 inch along z; a second copy as it is
        let build =
            r#"<item objectid="1" transform="0 1 0 -1 0 0 0 0 1 0 0 1"/><item objectid="1"/>"#;
        let part = part();
        let scaled = |mesh: &Mesh, place: fn([f64; 3]) -> [f64; 3]| {
            let mut mesh = mesh.clone();
            mesh.vertices
                .iter_mut()
                .for_each(|v| *v = place(*v).map(|v| 25.4 * v));
            mesh
        };
        let turned = scaled(&part, |[x, y, z]| [-y, x, z + 1.0]);
        let expected = together(&[turned, scaled(&part, |p| p)]).welded();
        let bytes = package(model("inch", &part, "", build));
        let found = parse_mesh(&bytes, "3mf", Path::new("part")).unwrap().mesh;
        assert_eq!(found.triangles, expected.triangles);
        for (a, b) in found.vertices.iter().zip(&expected.vertices) {
            assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-12), "{a:?} {b:?}");
        }
    }
}
