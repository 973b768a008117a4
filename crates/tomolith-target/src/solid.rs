//! A mesh as a shape.

use super::Shape;
use super::diagnosis::{Diagnosis, Repair, examine};
use super::placing::{Map, Placement};
use super::voxels::inside_fractions;
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::work::Work;
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
        Self::placed(file, &map, path, repair, &Work::new())
    }

    /// Places the mesh as part of a run, by a map that is known.
    pub(super) fn placed(
        file: MeshFile,
        map: &Map,
        path: &Path,
        repair: Repair,
        work: &Work,
    ) -> Result<Self> {
        let placed = |mut mesh: Mesh| {
            map.apply_to(&mut mesh);
            mesh
        };
        let mesh = placed(file.mesh);
        let bounds_mm = mesh.bounds();
        let (mesh, diagnosis) = examine(mesh, path, repair, work)?;
        let mut notes = file.notes;
        let mut negative = None;
        if !file.negative.triangles.is_empty() {
            let (mesh, found) = examine(placed(file.negative), path, repair, work)?;
            let sentences = found.sentences().into_iter();
            notes.extend(sentences.map(|sentence| format!("Negative volumes: {sentence}")));
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

    fn sample_under(&self, grid: &VolumeGrid, work: &Work) -> Result<Volume<f32>> {
        inside_fractions(&self.mesh, self.negative.as_ref(), grid, work)
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
