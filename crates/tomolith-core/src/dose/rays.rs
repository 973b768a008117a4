//! Rays as plain data, for a backend that computes a dose model where its fields live: straight pieces of light of any direction in resin.
//!
//! **Equation** A pixel of value x whose light has the deposit `energy` per voxel of way where it enters, and the attenuation `rate`, leaves
//!
//! ```text
//! x · energy · ∫ e^(−rate·s) ds        s: the way of the segment within the voxel, in voxels, counted from where light enters the resin
//! ```
//!
//! and the adjoint collects with the same weights. Source and discretization: the `rays` model of the crate of models.
//!
//! Where a surface cuts voxels ([`cells`](super::cells)), segments end at it. With the share s of its voxel that an element of a dose has (1 of a whole
//! voxel), it gets 1/s of what is left there. What is scattered out of this light is added: [`scattered`](super::scattered).
//!
//! **Shapes** Where frames see the vial alike, a light has the segments of one image, which every exposure turns about the axis; else each active pixel has
//! its own. An *exposure* is a frame, or one of the angles that a frame is averaged over.

use super::form::Masked;
use super::scattered::ScatteredLight;
use super::{DoseLayout, PatternLayout, ZCoupling};

/// A straight piece of a ray in resin. Lengths are in voxels.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct RaySegment {
    /// The point of its line that is nearest to the axis of the vial: x and y from there, z from the lowest face of the grid.
    pub nearest: [f32; 3],
    /// Attenuation.
    pub rate: f32,
    /// Unit direction.
    pub direction: [f32; 3],
    /// Deposit right behind its begin, for a pixel of value 1; negative of a segment inside of the surface that cuts voxels.
    pub energy: f32,
    /// Where it begins, in the resin, and ends: the way from `nearest` on.
    pub span: [f32; 2],
}

/// The segments of one light.
#[derive(Clone, Debug)]
pub struct LightRays {
    /// In the order of pixels.
    pub segments: Vec<RaySegment>,
    /// First segment of each pixel, and the one behind the last. With turns, pixels are those of an image, column by column from its lowest row; else
    /// the active ones, in the order of their elements.
    pub starts: Vec<u32>,
    /// Cosine and sine of the azimuths that each frame turns the segments to, frame by frame; None: pixels of every frame have segments of their own.
    pub turns: Option<Vec<[f32; 2]>>,
}

/// The geometry of a model.
#[derive(Clone, Debug)]
pub struct RayGeometry {
    /// One per light.
    pub patterns: Vec<PatternLayout>,
    /// The voxels.
    pub output: DoseLayout,
    /// x and y of the lowest corner of the grid, in voxels from the axis of the vial.
    pub corner: [f32; 2],
    /// One per light.
    pub lights: Vec<LightRays>,
    /// What is scattered out of them order by order, one a light that is.
    pub scattered: Vec<ScatteredLight>,
    /// How far a row reaches along z.
    pub z_coupling: ZCoupling,
    /// Voxels that all segments pass; none of scattered light.
    pub updates: u64,
    /// The model, for people.
    pub summary: String,
}

/// A model of rays.
pub type RayForm = Masked<RayGeometry>;
