//! Numbers in the memory where the work happens.
//!
//! Optimisers, objectives and models talk about [`Field`]s only: flat vectors of f32 with f64 sums. [`HostField`] is the
//! one in this machine's memory; a device has its own. The meaning of an element (which pixel, which voxel) is in the
//! model's layouts.
//!
//! Sums run over fixed blocks whose partial results are added in order, so a number does not depend on how many threads
//! computed it.
//!
//! ```
//! use tomolith::field::{Field, HostField};
//! let mut x = HostField::zeros(3);
//! x.fill(2.0);
//! let mut y = x.clone();
//! y.axpy(0.5, &x); // 2 + 0.5·2 = 3
//! assert_eq!(x.dot(&y), 3.0 * 2.0 * 3.0); // three elements, 2·3 each
//! ```

use rayon::prelude::*;

/// Elements per block of a parallel loop: 256 kB of f32, a compromise between cache and scheduling.
pub const BLOCK: usize = 1 << 16;

/// A flat vector of f32 somewhere. All operations on two fields need equal lengths and panic otherwise
/// (a programming error, not a user's).
pub trait Field: Clone + Send + Sync {
    /// Number of elements.
    fn len(&self) -> usize;
    /// Whether there are no elements.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Zeros of the same length, in the same memory.
    fn zeros_like(&self) -> Self;
    /// Overwrites with `other`.
    fn copy_from(&mut self, other: &Self);
    /// Overwrites with one value.
    fn fill(&mut self, value: f32);
    /// Σ selfᵢ·otherᵢ, summed in f64.
    fn dot(&self, other: &Self) -> f64;
    /// √Σ selfᵢ², summed in f64.
    fn norm(&self) -> f64 {
        self.dot(self).sqrt()
    }
    /// self ← self + a·x
    fn axpy(&mut self, a: f32, x: &Self);
    /// self ← a·self
    fn scale(&mut self, a: f32);
    /// self ← min(max(self, lower), upper)
    fn clamp(&mut self, lower: f32, upper: f32);
    /// Largest |selfᵢ|; NaN if any element is NaN.
    fn max_abs(&self) -> f32;
    /// Copies to host memory.
    fn to_host(&self) -> Vec<f32>;
    /// Overwrites from host memory.
    fn copy_from_host(&mut self, values: &[f32]);
}

/// Sixteen floats on a 64-byte boundary: one cache line, one AVX-512 register.
#[derive(Clone, Copy, Debug, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(64))]
pub struct Lanes(pub [f32; 16]);

/// Lanes of f32 in one [`Lanes`].
pub const LANES: usize = 16;

/// A [`Field`] in host memory, starting on a 64-byte boundary.
#[derive(Clone, Debug, Default)]
pub struct HostField {
    lanes: Vec<Lanes>,
    len: usize,
}

impl HostField {
    /// `len` zeros.
    #[must_use]
    pub fn zeros(len: usize) -> Self {
        HostField {
            lanes: vec![Lanes::default(); len.div_ceil(LANES)],
            len,
        }
    }

    /// A copy of a slice.
    #[must_use]
    pub fn from_slice(values: &[f32]) -> Self {
        let mut field = HostField::zeros(values.len());
        field.as_mut_slice().copy_from_slice(values);
        field
    }

    /// The elements.
    #[must_use]
    pub fn as_slice(&self) -> &[f32] {
        &bytemuck::cast_slice(&self.lanes)[..self.len]
    }

    /// The elements, to change.
    #[must_use]
    pub fn as_mut_slice(&mut self) -> &mut [f32] {
        &mut bytemuck::cast_slice_mut(&mut self.lanes)[..self.len]
    }

    /// The elements sixteen at a time; what lies beyond the last element is padding, which nobody reads as a result.
    #[must_use]
    pub fn lanes(&self) -> &[Lanes] {
        &self.lanes
    }

    /// The elements sixteen at a time, to change; see [`lanes`](Self::lanes).
    #[must_use]
    pub fn lanes_mut(&mut self) -> &mut [Lanes] {
        &mut self.lanes
    }

    /// Σ over blocks of `f(block of self, block of other)`, in a fixed order.
    fn sum_blocks(&self, other: &Self, f: impl Fn(&[f32], &[f32]) -> f64 + Sync) -> f64 {
        assert_eq!(self.len, other.len, "fields of different length");
        let partial: Vec<f64> = self
            .as_slice()
            .par_chunks(BLOCK)
            .zip(other.as_slice().par_chunks(BLOCK))
            .map(|(a, b)| f(a, b))
            .collect();
        partial.iter().sum()
    }

    fn update_blocks(&mut self, other: &Self, f: impl Fn(&mut [f32], &[f32]) + Sync) {
        assert_eq!(self.len, other.len, "fields of different length");
        self.as_mut_slice()
            .par_chunks_mut(BLOCK)
            .zip(other.as_slice().par_chunks(BLOCK))
            .for_each(|(a, b)| f(a, b));
    }
}

/// Σ aᵢ·bᵢ in f64, with eight running sums so that it vectorises.
#[must_use]
pub fn dot_block(a: &[f32], b: &[f32]) -> f64 {
    let mut sums = [0.0f64; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let tail: f64 = a8
        .remainder()
        .iter()
        .zip(b8.remainder())
        .map(|(&x, &y)| f64::from(x) * f64::from(y))
        .sum();
    for (x, y) in a8.zip(b8) {
        for i in 0..8 {
            sums[i] += f64::from(x[i]) * f64::from(y[i]);
        }
    }
    sums.iter().sum::<f64>() + tail
}

impl Field for HostField {
    fn len(&self) -> usize {
        self.len
    }

    fn zeros_like(&self) -> Self {
        HostField::zeros(self.len)
    }

    fn copy_from(&mut self, other: &Self) {
        self.update_blocks(other, |a, b| a.copy_from_slice(b));
    }

    fn fill(&mut self, value: f32) {
        self.as_mut_slice()
            .par_chunks_mut(BLOCK)
            .for_each(|block| block.fill(value));
    }

    fn dot(&self, other: &Self) -> f64 {
        self.sum_blocks(other, dot_block)
    }

    fn axpy(&mut self, a: f32, x: &Self) {
        self.update_blocks(x, |y, x| {
            y.iter_mut().zip(x).for_each(|(y, &x)| *y += a * x)
        });
    }

    fn scale(&mut self, a: f32) {
        self.as_mut_slice()
            .par_chunks_mut(BLOCK)
            .for_each(|block| block.iter_mut().for_each(|v| *v *= a));
    }

    fn clamp(&mut self, lower: f32, upper: f32) {
        self.as_mut_slice()
            .par_chunks_mut(BLOCK)
            .for_each(|block| block.iter_mut().for_each(|v| *v = v.max(lower).min(upper)));
    }

    fn max_abs(&self) -> f32 {
        self.as_slice()
            .par_chunks(BLOCK)
            .map(|block| {
                block.iter().fold(0.0f32, |m, &v| {
                    if m.is_nan() || v.is_nan() {
                        f32::NAN
                    } else {
                        m.max(v.abs())
                    }
                })
            })
            .reduce(
                || 0.0,
                |a, b| {
                    if a.is_nan() || b.is_nan() {
                        f32::NAN
                    } else {
                        a.max(b)
                    }
                },
            )
    }

    fn to_host(&self) -> Vec<f32> {
        self.as_slice().to_vec()
    }

    fn copy_from_host(&mut self, values: &[f32]) {
        self.as_mut_slice().copy_from_slice(values);
    }
}
