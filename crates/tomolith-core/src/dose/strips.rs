//! A dose model as plain data, for a backend that computes it where its fields live: light that runs in strips, the same in all slices,
//! and what is scattered out of it ([`scattered`](super::scattered)).
//!
//! **Equation** For a voxel with the coordinates (r, a) along and across a beam, in voxels, the weight of a strip is
//!
//! ```text
//! [from, to] = [r, r + 1] ∩ span                    the lit piece of the voxel's row
//! energy     = base·(1 − e^(−κ·(to − from)))·e^(−κ·depth)      depth from the entry to where the piece begins, κ: per_row
//!            = base·(to − from)                     in pure Radon
//! [l, h]     = edges at the middle of the piece, in order, brought into the resin of the row (ResinRow)
//! weight     = energy·|[a, a + 1] ∩ [l, h]| / (h − l)
//! ```
//!
//! Dose and adjoint are the two products with the matrix of these weights, slice by slice; [`Taps`] bring rows of pixels to the lanes of the
//! products and these to slices. Source and discretization: the `parallel` model of the crate of models.
//!
//! **Shapes** A *slot* is a column of a view, `view·columns + column`; a view is a frame, or two frames that see the plane along the same lines.

use super::form::Masked;
use super::scattered::ScatteredLight;
use super::{DoseLayout, PatternLayout};

/// A bundle of light on the grid of a plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Strip {
    /// Offset and slope of the coordinate across, as a function of that along, of either edge.
    pub edges: [[f32; 2]; 2],
    /// The lit piece of the coordinate along.
    pub span: [f32; 2],
    /// See the [module](self).
    pub base: f32,
    /// κ: attenuation over one row.
    pub per_row: f32,
    /// Column of pixels.
    pub column: u32,
    /// 1 where light travels toward larger rows, else 0.
    pub upward: u32,
    /// 1 where a pixel of the column is active, else 0.
    pub is_lit: u32,
    /// Nothing.
    pub padding: u32,
}

/// The strips of one direction of light with one major axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// First strip, and the one behind the last.
    pub strips: [u32; 2],
    /// Its view.
    pub view: u32,
    /// Whether rows are counted along y, not x.
    pub along_y: bool,
}

/// A rectangle of voxels `[x, y]`, of at most 16 by 16.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tile {
    /// First voxel.
    pub start: [u32; 2],
    /// Number of voxels.
    pub size: [u32; 2],
}

/// Where a row of voxels holds resin, in voxels across.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct ResinRow {
    /// Between these there is resin.
    pub outer: [f32; 2],
    /// Between these there is none; the first is larger than the second where there is no such place.
    pub core: [f32; 2],
}

/// Elements as weighted sums of neighboring others: `out[i] = Σ_t weights[t][i]·source[first[i] + t]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Taps {
    /// The first source of each element.
    pub first: Vec<u32>,
    /// Weights, tap-major; a source beyond the last has weight 0.
    pub weights: Vec<Vec<f32>>,
}

/// The strips of one light.
#[derive(Clone, Debug)]
pub struct LightStrips {
    /// Of all beams.
    pub strips: Vec<Strip>,
    /// In the order of their views.
    pub beams: Vec<Beam>,
    /// First strip of a beam that may light a tile, counted from the beam's first, and the one behind the last: `[tile][beam]`.
    pub meetings: Vec<[u16; 2]>,
    /// How many views.
    pub views: usize,
    /// Columns of a view.
    pub columns: usize,
    /// The column of pixels (counted through all frames) that lights a slot, from either side; None where there is no such side.
    pub sources: Vec<[Option<u32>; 2]>,
    /// Whether light is not weakened.
    pub is_pure_radon: bool,
    /// The resin of each row along x, then of each row along y.
    pub resin_rows: [Vec<ResinRow>; 2],
    /// Rows of pixels → lanes.
    pub to_lanes: Taps,
    /// Lanes → rows of pixels.
    pub to_rows: Taps,
    /// Lanes → slices, and slices → lanes; None where lanes are slices.
    pub spread: Option<[Taps; 2]>,
}

/// The geometry of a model.
#[derive(Clone, Debug)]
pub struct StripGeometry {
    /// One per light.
    pub patterns: Vec<PatternLayout>,
    /// The voxels.
    pub output: DoseLayout,
    /// Tiles that together are the plane.
    pub tiles: Vec<Tile>,
    /// One per light.
    pub lights: Vec<LightStrips>,
    /// What is scattered out of them; none where nothing scatters.
    pub scattered: Vec<ScatteredLight>,
}

/// A model of strips.
pub type StripForm = Masked<StripGeometry>;
