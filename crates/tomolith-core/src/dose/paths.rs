//! Random paths of scattered light as plain data, for a backend that draws them where its fields live.
//!
//! **Equation** Unscattered light is that of [`rays`](super::rays). Of light on a straight way of length L through resin, with the deposit `energy` per
//! cell of way where it begins and the attenuation μ per cell,
//!
//! ```text
//! energy′ = energy · albedo · (1 − e^(−μL))
//! ```
//!
//! is scattered. It goes on from a random point of the way, whose distance s has the density μ·e^(−μs)/(1 − e^(−μL)), in a random direction of the phase
//! function, up to the wall of the resin, behind which light is gone; and so on for so many orders. Where `energy′` is below `least`, light of that energy goes on in
//! its place, with the probability energy′/least (Russian roulette). Every such way leaves in the cells that it meets what a segment of a ray leaves in
//! voxels. With an interpolation I from cells to voxels and, where what both smear out is given back, a sharpening S (see
//! [`scattered`](super::scattered)):
//!
//! ```text
//! dose = unscattered + I S cells
//! ```
//! Source and discretization: the `monte_carlo` model of the crate of models.
//!
//! A backend draws from a stream of its own, so its matrix differs from the processor's as that of another seed does. One seed is one matrix.

use super::form::Masked;
use super::rays::RayGeometry;
use super::scattered::CellGrid;
use std::sync::Arc;

/// Where scattered light goes.
#[derive(Clone, Debug, PartialEq)]
pub enum PhaseForm {
    /// Henyey and Greenstein's phase function with this mean cosine; isotropic at 0.
    HenyeyGreenstein(f32),
    /// Cosines below which the parts 0, 1/n … 1 of the light go; linear in between.
    Table(Arc<[f32]>),
}

/// The wall at which light leaves the resin. Lengths are in cells; the place of the axis of the vial is x = y = 0, heights count from the lowest cell's face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResinWall {
    /// Whether it is a circle; else a square with faces normal to x and y.
    pub is_round: bool,
    /// Its radius, or half of its width.
    pub half: f32,
    /// Between which heights it stands; infinite where it has no end.
    pub ends: [f32; 2],
}

/// What is scattered out of one light.
#[derive(Clone, Debug)]
pub struct LightPaths {
    /// The part of what weakens light that is scattering.
    pub albedo: f32,
    /// Where it goes.
    pub phase: PhaseForm,
    /// Energy in cells below which light lives on by chance only.
    pub least: f32,
    /// Cells that all paths pass, about.
    pub updates: u64,
}

/// The geometry of a model.
#[derive(Clone, Debug)]
pub struct PathGeometry {
    /// Unscattered light, with the segments that miss the voxels.
    pub straight: Arc<RayGeometry>,
    /// One per light; None where it is not scattered.
    pub lights: Vec<Option<LightPaths>>,
    /// What surrounds the resin of all lights.
    pub wall: ResinWall,
    /// Cells on which scattered light is summed.
    pub cells: CellGrid,
    /// Voxels along the edge of a cell.
    pub edge: usize,
    /// The lowest corner of the cells: x and y from the axis of the vial, z from the lowest face of the voxels, in cells.
    pub corner: [f32; 3],
    /// Strength of the sharpening along x, y, z; None where what cells smear out is left as it is.
    pub sharpened: Option<[f32; 3]>,
    /// How often light is scattered at most.
    pub orders: usize,
    /// Which paths.
    pub seed: u64,
    /// Iterations of an optimization after which the next seed is taken, 0: never.
    pub renew: usize,
    /// The model, for people.
    pub summary: String,
}

/// A model of unscattered light and random paths of scattered light.
pub type PathForm = Masked<PathGeometry>;
