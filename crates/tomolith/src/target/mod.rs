//! Targets: mesh, image or phantom → what each voxel should become.
//!
//! *What must it do, and who does it.* A [`Target`] is an inside fraction per voxel (1 part, 0 void, between at the
//! surface), or grey values to be reproduced. It can be asked for again on a finer grid: evaluation does that.
//!
//! | kind of shape | file |
//! |---|---|
//! | mesh: STL, OBJ, PLY, 3MF | [`MeshShape`], examined by [`diagnosis`], voxelised exactly |
//! | several meshes with roles | [`bodies`] |
//! | part by formula | [`phantom`] with its table [`PHANTOMS`] |
//! | grey image, drawn along z, or a stack of them | [`GreyImage`] |
//!
//! [`TargetSpec`] is the job's table `[target]`, [`build`] makes a shape of it, [`default_grid`] puts a grid round the
//! shape and [`voxelise`] fills it:
//!
//! ```
//! use tomolith::target::{Resolution, TargetSpec, build, default_grid, voxelise};
//! let spec: TargetSpec = toml::from_str("phantom = \"sphere\"\nsize_mm = 2.0").unwrap();
//! let shape = build(&spec, std::path::Path::new("."), "target").unwrap();
//! let grid = default_grid(shape.bounds_mm(), Resolution::Pitch(0.1)).unwrap();
//! let target = voxelise(&*shape, &spec.name(), &grid).unwrap();
//! let volume: f32 = target.inside.values.iter().sum::<f32>() * 0.1f32.powi(3);
//! assert!((volume / 4.18879 - 1.0).abs() < 1e-3); // 4/3·π, radius 1
//! ```

pub mod bodies;
mod boxes;
pub mod diagnosis;
mod image;
mod lines;
mod mesh_unit;
pub mod phantom;
mod placing;
mod region;
mod solid;
mod spec;
mod voxels;

pub use bodies::{Assembly, BodySpec, Role};
pub use diagnosis::{Diagnosis, Repair};
pub use image::GreyImage;
pub use mesh_unit::MeshUnit;
pub use phantom::PHANTOMS;
pub use placing::{Map, Placement};
pub use region::{Resolution, default_grid};
pub use solid::MeshShape;
pub(crate) use spec::sampled;
pub use spec::{TargetSpec, build, voxelise, voxelise_under};

use crate::error::Result;
use crate::grid::{Volume, VolumeGrid};
use crate::io::mesh::Mesh;
use crate::run::Run;
use rayon::prelude::*;

/// Something with a shape that can be sampled on any grid.
pub trait Shape: std::fmt::Debug + Send + Sync {
    /// Box `[low, high]`, each `[x, y, z]`, mm, in the resin frame.
    fn bounds_mm(&self) -> [[f64; 3]; 2];
    /// Fraction of each voxel that is inside, 0…1 (for grey images: the grey value).
    ///
    /// # Errors
    /// When the shape cannot be sampled; [`Error::Cancelled`](crate::Error::Cancelled).
    fn sample_under(&self, grid: &VolumeGrid, run: &Run) -> Result<Volume<f32>>;
    /// The same where nobody stops it or wants to know how far it is.
    ///
    /// # Errors
    /// When the shape cannot be sampled.
    fn sample(&self, grid: &VolumeGrid) -> Result<Volume<f32>> {
        self.sample_under(grid, &Run::new())
    }
    /// Whether values are grey (to be reproduced as they are) and not an inside fraction.
    fn is_grey(&self) -> bool {
        false
    }
    /// Exact volume where known, mm³.
    fn volume_mm3(&self) -> Option<f64> {
        None
    }
    /// The bodies of a role, as a shape of their own; what is printed is the shape itself.
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

/// A shape sampled on a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// Name of the part, for files and titles.
    pub name: String,
    /// Inside fraction, or grey values when `grey`.
    pub inside: Volume<f32>,
    /// Whether the values are grey values to be reproduced.
    pub grey: bool,
}

impl Target {
    /// Whether a voxel is part: its inside fraction is at least one half.
    #[must_use]
    pub fn is_part(&self, index: usize) -> bool {
        self.inside.values[index] >= 0.5
    }
}

/// Labels of voxels: a byte each.
pub mod label {
    /// Outside the resin or the region that counts: weight 0, in no metric.
    pub const OUTSIDE: u8 = 0;
    /// Must stay liquid.
    pub const VOID: u8 = 1;
    /// Must turn solid.
    pub const PART: u8 = 2;
}

/// Labels every voxel: part where the inside fraction is at least one half, void elsewhere, [`label::OUTSIDE`] where
/// `counts([x, y, z])` (mm, voxel centre) is false.
pub fn label_voxels(target: &Target, counts: impl Fn([f64; 3]) -> bool + Sync) -> Volume<u8> {
    let grid = &target.inside.grid;
    let nx = grid.shape[2];
    label_slices(target, |iz, i| {
        counts([grid.x(i % nx), grid.y(i / nx), grid.z(iz)])
    })
}

/// As [`label_voxels`], where the same columns of voxels count at every height: each is asked for once.
pub fn label_columns(target: &Target, counts: impl Fn([f64; 2]) -> bool + Sync) -> Volume<u8> {
    let grid = &target.inside.grid;
    let [_, ny, nx] = grid.shape;
    let plane: Vec<bool> = (0..nx * ny)
        .into_par_iter()
        .map(|i| counts([grid.x(i % nx), grid.y(i / nx)]))
        .collect();
    label_slices(target, |_, i| plane[i])
}

/// Labels by slice, and by voxel of the slice.
fn label_slices(target: &Target, counts: impl Fn(usize, usize) -> bool + Sync) -> Volume<u8> {
    let grid = &target.inside.grid;
    let [_, ny, nx] = grid.shape;
    let mut values = vec![label::OUTSIDE; grid.len()];
    if !values.is_empty() {
        values
            .par_chunks_mut(nx * ny)
            .enumerate()
            .for_each(|(iz, slice)| {
                for (i, value) in slice.iter_mut().enumerate() {
                    if counts(iz, i) {
                        *value = if target.is_part(iz * nx * ny + i) {
                            label::PART
                        } else {
                            label::VOID
                        };
                    }
                }
            });
    }
    Volume {
        grid: grid.clone(),
        values,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VolumeGrid;

    #[test]
    fn columns_are_labelled_as_their_voxels_are() {
        let grid = VolumeGrid::centered([3, 5, 7], 0.1);
        let values = (0..grid.len()).map(|i| (i % 4) as f32 / 3.0).collect();
        let target = Target {
            inside: Volume { grid, values },
            name: String::new(),
            grey: false,
        };
        let counts = |x: f64, y: f64| x.hypot(y) < 0.25;
        let labels = label_columns(&target, |[x, y]| counts(x, y));
        assert_eq!(labels, label_voxels(&target, |[x, y, _]| counts(x, y)));
        let of = |wanted| labels.values.iter().filter(|l| **l == wanted).count();
        assert!(
            [label::OUTSIDE, label::VOID, label::PART]
                .map(of)
                .iter()
                .all(|n| *n > 3)
        );
    }
}
