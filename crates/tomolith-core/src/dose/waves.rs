//! Light that spreads from a focal plane, as plain data for a backend: patterns → light at samples behind the plane → voxels that turn.
//!
//! **Equation** A is the pattern of a frame on a window of [`padded`](Transforms::padded) pixels, F its Fourier transform, s the [`shifts`](Transforms::shifts);
//! of a mode m and a depth d the transfer function is H_md ([`Transfer`]). Samples repeat with the window; [`Comb`] says which of them are computed:
//!
//! ```text
//! Ψ       = s·F A                                            frequencies from −band to band along u and z
//! ψ_md    = F⁻¹[H_md·Ψ]                                      at the comb's samples along u and z
//! φ_mk    = Σ_d w_kd·ψ_md                                    w real, or for images of depths conjugating: FieldTap
//! I_k     = Σ_m w_m·|φ_mk|²,  or Re ψ of linear light
//! dose   += weight·Σ_k Σ_j c_k·b_j·(closer I)[k][j]          of every frame, at the voxel's place: Rotation
//! ```
//!
//! The pullback is the exact transpose of each line at Ψ. Source and discretization: the `wave` and `incoherent_cone` models of the crate of models.
//!
//! **Shapes** Spectra `[f_z][f_u]`, from −band on; samples `[depth][lateral][z]`.

use super::form::Masked;
use super::{DoseLayout, PatternLayout, ZCoupling};

/// Samples `first + i·stride` of a line that repeats after `length`, i < `count`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comb {
    /// Length of the transform.
    pub length: usize,
    /// The first sample.
    pub first: usize,
    /// From one to the next.
    pub stride: usize,
    /// How many.
    pub count: usize,
}

/// Fourier transforms of the frames of a light; of two numbers the first is along u, the second along z.
#[derive(Clone, Debug)]
pub struct Transforms {
    /// Pixels of the window.
    pub padded: [usize; 2],
    /// Highest frequency, in cycles per window: below half of `padded`, or of incoherent light below it.
    pub band: [usize; 2],
    /// Factor (real and imaginary part) of each frequency along z.
    pub shifts: Vec<[f32; 2]>,
    /// Samples that are computed.
    pub samples: [Comb; 2],
}

/// H of the depths at which fields are transformed.
#[derive(Clone, Debug)]
pub enum Transfer {
    /// H of the first depth is `start`, of each other that of the one before times `step`; then 0 for the u frequencies outside `passing`.
    Steps {
        /// Of each frequency.
        start: Vec<[f32; 2]>,
        /// Of each frequency.
        step: Vec<[f32; 2]>,
        /// `[depth][f_z]`: index of the first frequency along u that passes, and of the one behind the last.
        passing: Vec<[u32; 2]>,
    },
    /// Real, `[depth]`, of each frequency.
    Each(Vec<Vec<f32>>),
}

/// One mode of the light.
#[derive(Clone, Debug)]
pub struct WaveMode {
    /// Its part of the energy.
    pub weight: f32,
    /// How it spreads.
    pub transfer: Transfer,
}

/// A field in a sum of fields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldTap {
    /// Which.
    pub field: u32,
    /// Weights of its real and its imaginary part.
    pub weights: [f32; 2],
}

/// A sparse matrix, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SparseRows {
    /// First entry of each row, and the one behind the last.
    pub starts: Vec<u32>,
    /// Column and weight.
    pub entries: Vec<(u32, f32)>,
}

/// An interpolation and its transpose.
#[derive(Clone, Debug)]
pub struct Interpolation {
    /// Samples → closer samples.
    pub forth: SparseRows,
    /// Its transpose.
    pub back: SparseRows,
}

/// Weights of the samples around a place, tabulated over the way from one sample to the next, linear between the rows.
#[derive(Clone, Debug)]
pub struct PlaceTaps {
    /// Samples that are used: from 1 − taps/2 behind the place on.
    pub taps: usize,
    /// `[rows + 1][taps]` each; the second, third … for samples that begin 1, 2 … lower, where the others would lie behind `last`.
    pub tables: Vec<Vec<f32>>,
    /// Index of the last sample.
    pub last: usize,
    /// Whether places below the middle see the samples from the other end.
    pub is_turned: bool,
}

/// Places along one axis of the samples: `(mm − from)/step`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Place 0, mm.
    pub from: f64,
    /// Distance of samples, mm.
    pub step: f64,
    /// How many samples there are.
    pub count: usize,
}

/// Voxels that turn: at (X, Y) a frame of azimuth α is met at the depth d = −(X cos α + Y sin α) and at u = −X sin α + Y cos α. Samples along the depth
/// lie at |d − focus|; those with an index i below 0 are the samples −1 − i. The weight of a frame's light is
/// `active·e^(−attenuation·(d − entrance)⁺)`, the mean of several azimuths.
#[derive(Clone, Debug)]
pub struct Rotation {
    /// Azimuths, `sub_angles` of each frame.
    pub azimuths: Vec<f64>,
    /// Azimuths of a frame.
    pub sub_angles: usize,
    /// Whether a column of voxels `[y][x]` lies in the resin.
    pub in_resin: Vec<bool>,
    /// Depth of the focal plane, mm.
    pub focus: f64,
    /// Dose per fluence.
    pub active: f64,
    /// 1/mm.
    pub attenuation: f64,
    /// Radius of the resin, where light enters it at −√(radius² − u²); None: at the plane `entrance`.
    pub wall: Option<f64>,
    /// Depth of that plane, mm.
    pub entrance: f64,
    /// Samples along the depth, and their weights.
    pub along: (Axis, PlaceTaps),
    /// Lateral samples, and their weights.
    pub across: (Axis, PlaceTaps),
}

/// One light.
#[derive(Clone, Debug)]
pub struct WaveLight {
    /// Its Fourier transforms.
    pub transforms: Transforms,
    /// Its modes.
    pub modes: Vec<WaveMode>,
    /// Of each depth where light is wanted the fields that it is a sum of.
    pub forth: Vec<Vec<FieldTap>>,
    /// The transpose: of each depth that is transformed.
    pub back: Vec<Vec<FieldTap>>,
    /// Closer samples, along u and along the depth, in this order; None where they are those that are computed.
    pub closer: [Option<Interpolation>; 2],
    /// From samples to voxels.
    pub rotation: Rotation,
}

/// What models of the same light and voxels share.
#[derive(Clone, Debug)]
pub struct WaveGeometry {
    /// One per light.
    pub patterns: Vec<PatternLayout>,
    /// The voxels, at least two slices.
    pub output: DoseLayout,
    /// How far a row reaches along z.
    pub z_coupling: ZCoupling,
    /// Whether light is linear in the pixels: I = Re ψ.
    pub is_linear: bool,
    /// One per light.
    pub lights: Vec<WaveLight>,
    /// Voxels times frames.
    pub updates: u64,
    /// The model's name.
    pub model: &'static str,
    /// How it is sampled, for people.
    pub summary: String,
}

/// A model of waves.
pub type WaveForm = Masked<WaveGeometry>;
