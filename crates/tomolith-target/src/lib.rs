//! Targets: mesh, image or phantom → what each voxel should become.
//!
//! *What must it do, and who does it.* A [`Target`] is an inside fraction per voxel (1 part, 0 void, between at the
//! surface), or gray values to be reproduced. It can be sampled again on a finer grid: evaluation does that.
//!
//! | kind of shape | file |
//! |---|---|
//! | mesh: STL, OBJ, PLY, 3MF | [`MeshShape`], examined by [`diagnosis`], voxelized exactly |
//! | several meshes with roles | [`bodies`] |
//! | part by formula | [`phantom`] with its table [`PHANTOMS`] |
//! | gray image, drawn along z, or a stack of them | [`GrayImage`] |
//!
//! [`TargetSpec`] is the job's table `[target]`, [`build`] makes a shape of it, [`default_grid`] puts a grid round the
//! shape and [`voxelize`] fills it:
//!
//! ```
//! use tomolith_target::{Resolution, TargetSpec, build, default_grid, voxelize};
//! let spec: TargetSpec = toml::from_str("phantom = \"sphere\"\nsize_mm = 2.0").unwrap();
//! let shape = build(&spec, std::path::Path::new("."), "target").unwrap();
//! let grid = default_grid(shape.bounds_mm(), Resolution::Pitch(0.1)).unwrap();
//! let target = voxelize(&*shape, &spec.name(), &grid).unwrap();
//! let volume: f32 = target.inside.values.iter().sum::<f32>() * 0.1f32.powi(3);
//! assert!((volume / 4.18879 - 1.0).abs() < 1e-3); // 4/3·π, radius 1
//! ```

pub mod bodies;
pub mod clip;
pub mod diagnosis;
mod horizontal_faces;
mod image;
mod lines;
mod mesh_unit;
pub mod phantom;
mod placing;
mod region;
mod solid;
mod spec;
pub mod thin;
mod voxels;

pub use bodies::{Assembly, BodySpec, Role};
pub use diagnosis::{Diagnosis, Repair};
pub use horizontal_faces::HorizontalFaces;
pub use image::GrayImage;
pub use mesh_unit::{LONG_MM, MeshUnit};
pub use phantom::PHANTOMS;
pub use placing::{Map, Placement};
pub use region::{Resolution, default_grid};
pub use solid::MeshShape;
pub use spec::{TargetSpec, build, build_under, sampled, voxelize, voxelize_under};
pub use tomolith_core::target::{Target, label, label_columns, label_voxels};

use tomolith_core::error::Result;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::work::Work;
use tomolith_io::mesh::Mesh;

/// Something with a shape that can be sampled on any grid.
pub trait Shape: std::fmt::Debug + Send + Sync {
    /// Box `[low, high]`, each `[x, y, z]`, mm, in the resin frame.
    fn bounds_mm(&self) -> [[f64; 3]; 2];
    /// Fraction of each voxel that is inside, 0…1 (for gray images: the gray value).
    ///
    /// # Errors
    /// When the shape cannot be sampled; [`Error::Canceled`](tomolith_core::Error::Canceled).
    fn sample_under(&self, grid: &VolumeGrid, work: &Work) -> Result<Volume<f32>>;
    /// [`sample_under`](Self::sample_under), where nobody stops it or wants to know how far it is.
    ///
    /// # Errors
    /// When the shape cannot be sampled.
    fn sample(&self, grid: &VolumeGrid) -> Result<Volume<f32>> {
        self.sample_under(grid, &Work::new())
    }
    /// Whether values are gray (to be reproduced as they are) and not an inside fraction.
    fn is_gray(&self) -> bool {
        false
    }
    /// Of a shape made of pixels, their edge, mm: values change smoothly from one to the next.
    fn pixel_mm(&self) -> Option<f64> {
        None
    }
    /// Exact volume where known, mm³.
    fn volume_mm3(&self) -> Option<f64> {
        None
    }
    /// The bodies of a role, as a separate shape; what is printed is the shape itself.
    fn body(&self, role: Role) -> Option<&dyn Shape> {
        let _ = role;
        None
    }
    /// Its closed surfaces, mm, when it is made of meshes.
    fn meshes(&self) -> Vec<&Mesh> {
        Vec::new()
    }
    /// Of a shape by formula: distance to its surface, mm, or less; negative inside, growing by at most 1 per mm.
    fn distance_mm(&self, point: [f64; 3]) -> Option<f64> {
        let _ = point;
        None
    }
    /// Of an upright prism: the heights between which every level cut is the same, mm.
    fn upright_mm(&self) -> Option<[f64; 2]> {
        None
    }
    /// Things people should know (open edges, inverted shells, …), one sentence each.
    fn warnings(&self) -> Vec<String> {
        Vec::new()
    }
}
