//! Light that is scattered out of light in strips or rays, as plain data for a backend.
//!
//! **Equation** Of channel k the light of [`bins`](ScatteredLight::bins) on cells is c_k: in strips a pixel counts times the channel's weight of its (frame, column), and
//! a ray times the channel's [harmonic](DirectionHarmonic) of its direction.
//! S is a [sharpening](OnCells::sharpened), K a convolution of fields on cells, I an interpolation from cells to voxels, times the part of a voxel that is resin:
//!
//! ```text
//! dose += I₁ S₁ Σ_k K₁_k S₁′ c_k                                   scattered once
//! m₁    = K · T S₂′ R c                                            T: channels → moments, R: means over `factor`³ cells
//! m_n+1 = K · (σ ρ S₂″ m_n)                                        σ of a moment, ρ the part of a cell that is resin
//! dose += I₂ S₂ Σ_{n≥1} w_n · (moment 0 of m_n+1)                  scattered n + 1 times
//! ```
//!
//! S adds to a cell, for each neighbor along an axis with the strength a, a·(own − neighbor), where both cells are all resin. Source and discretization: the
//! `successive_orders` model of the crate of models.

use super::DoseLayout;
use super::rays::RayForm;
use super::strips::StripForm;
use std::sync::Arc;

/// Two neighboring bins share a pixel along an axis; the second has what the first leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The first.
    pub bin: u32,
    /// Part of either.
    pub parts: [f32; 2],
}

/// Pixels that are taken together to larger ones.
#[derive(Clone, Debug)]
pub struct Bins {
    /// Of each column of pixels.
    pub columns: Vec<Share>,
    /// Of each row of pixels, from below.
    pub rows: Vec<Share>,
    /// Value of a bin per value of a pixel that lies in it.
    pub scale: f32,
}

/// The Fourier transform of a kernel, divided by the number of elements of the padded array.
#[derive(Clone, Debug)]
pub struct KernelSpectrum {
    /// `[k_y][k_x][k_z]`, k_z to half the padded length: the real part of an even kernel, the imaginary of an odd one.
    pub values: Vec<f32>,
    /// Which of both.
    pub is_odd: bool,
}

/// Cells of one size among voxels.
#[derive(Clone, Debug)]
pub struct CellGrid {
    /// The cells.
    pub layout: DoseLayout,
    /// Whether each element of the layout is a cell that is all resin.
    pub is_full: Arc<Vec<bool>>,
    /// Along x, y, z, of each voxel: the cell below its middle, and the weight of the next one.
    pub places: [Vec<(usize, f32)>; 3],
}

/// Fields on cells of one size.
#[derive(Clone, Debug)]
pub struct OnCells {
    /// The cells.
    pub grid: CellGrid,
    /// Elements along x, y, z of the arrays that are transformed: zeros behind the cells keep light from coming round.
    pub padded: [usize; 3],
    /// Strengths along x, y, z of the sharpenings: of unscattered light as a source, of what voxels see.
    pub sharpened: [[f32; 3]; 2],
    /// Of order 1 one a channel; of later orders one a pair of moments a ≤ b, row by row.
    pub kernels: Vec<KernelSpectrum>,
}

/// A moment of scattered light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// What the resin sends on of it, 1/mm.
    pub scattered: f32,
    /// The channel that it has of unscattered light, and its part of it; None where it has none.
    pub channel: Option<(usize, f32)>,
}

/// Light that is scattered twice or more.
#[derive(Clone, Debug)]
pub struct LaterOrders {
    /// Its cells, as large as those of order 1 or larger.
    pub cells: OnCells,
    /// Cells of order 1 along an edge of one of these.
    pub factor: usize,
    /// Strengths of the sharpening between orders.
    pub between: [f32; 3],
    /// Part of each (y, x) of cells that is resin.
    pub resin: Vec<f32>,
    /// The moments, that of the fluence first.
    pub moments: Vec<Moment>,
    /// Weight of the fluence moment of each order.
    pub weights: Vec<f32>,
}

/// A real spherical harmonic of a unit direction (x, y, z): `scale` · P_l^|m|(z)/(1 − z²)^(|m|/2) times the real part of (x + iy)^|m|, or, for m < 0, the
/// imaginary one. No direction has more than 1 of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionHarmonic {
    /// l.
    pub degree: usize,
    /// m.
    pub order: isize,
    /// The norm, and √2 where m is not 0.
    pub scale: f32,
}

/// Light of bins on cells, a field of each channel.
#[derive(Clone, Debug)]
pub enum LightOnCells {
    /// Strips, with the weight of each (frame, column) of pixels for each channel.
    Strips(StripForm, Vec<Vec<f32>>),
    /// Rays, with the harmonic of each channel.
    Rays(RayForm, Vec<DirectionHarmonic>),
}

impl LightOnCells {
    /// How many fields there are.
    #[must_use]
    pub fn channels(&self) -> usize {
        match self {
            LightOnCells::Strips(_, weights) => weights.len(),
            LightOnCells::Rays(_, harmonics) => harmonics.len(),
        }
    }
}

/// What is scattered out of one light.
#[derive(Clone, Debug)]
pub struct ScatteredLight {
    /// Which light.
    pub light: usize,
    /// Its pixels in bins.
    pub bins: Bins,
    /// Their light, on the cells of order 1.
    pub source: LightOnCells,
    /// Part of each (y, x) of voxels that is resin.
    pub shares: Arc<Vec<f32>>,
    /// Cells of light that is scattered once.
    pub once: OnCells,
    /// Light that is scattered twice or more.
    pub later: LaterOrders,
    /// Cells and orders, for people.
    pub summary: String,
}
