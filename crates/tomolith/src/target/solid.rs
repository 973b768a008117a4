//! A mesh as a shape.

use super::Shape;
use super::diagnosis::{Diagnosis, examine};
use super::placing::Placement;
use super::voxels::inside_fractions;
use crate::error::Result;
use crate::grid::{Volume, VolumeGrid};
use crate::io::mesh::Mesh;
use std::path::Path;

/// A placed mesh: closed, outward, in mm.
#[derive(Clone, Debug)]
pub struct MeshShape {
    mesh: Mesh,
    bounds_mm: [[f64; 3]; 2],
    diagnosis: Diagnosis,
}

impl MeshShape {
    /// Places and examines a mesh; `path` names it in errors, `section` the job's table. Its triangles must share vertices
    /// where they meet, as those of files do ([`Mesh::welded`]).
    ///
    /// # Errors
    /// [`Error::Config`](crate::Error::Config) for a bad placement, [`Error::Mesh`](crate::Error::Mesh) when the mesh
    /// encloses no volume.
    pub fn new(mut mesh: Mesh, placement: &Placement, path: &Path, section: &str) -> Result<Self> {
        let map = placement.map(&mesh.vertices, 0.0, section)?;
        map.apply_to(&mut mesh);
        let bounds_mm = mesh.bounds();
        let (mesh, diagnosis) = examine(mesh, path)?;
        Ok(MeshShape {
            mesh,
            bounds_mm,
            diagnosis,
        })
    }

    /// What was found in the mesh.
    #[must_use]
    pub fn diagnosis(&self) -> &Diagnosis {
        &self.diagnosis
    }

    /// The placed mesh, closed and outward, mm.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }
}

impl Shape for MeshShape {
    fn bounds_mm(&self) -> [[f64; 3]; 2] {
        self.bounds_mm
    }

    fn sample(&self, grid: &VolumeGrid) -> Result<Volume<f32>> {
        inside_fractions(&self.mesh, grid)
    }

    /// Known when the winding number is 0 or 1 everywhere; shells that overlap have a union, which has no simple formula.
    fn volume_mm3(&self) -> Option<f64> {
        self.diagnosis
            .is_simple()
            .then(|| self.diagnosis.signed_volume_mm3())
    }

    fn warnings(&self) -> Vec<String> {
        self.diagnosis.sentences()
    }
}
