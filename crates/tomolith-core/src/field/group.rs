//! Sixteen numbers at a time, in the widest registers of the machine the program was built for.
//!
//! Written with a vector type because compilers turn loops over small arrays into shuffles; the same bits on every machine:
//! products are rounded before they are added.

use super::LANES;
use wide::{f32x8, u32x8};

/// Sixteen numbers, as the arithmetic units take them.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Group(pub(crate) [f32x8; 2]);

impl Group {
    #[inline(always)]
    /// Sixteen floats as two registers.
    pub(crate) fn of(values: &[f32; LANES]) -> Self {
        let halves = values.as_chunks::<8>().0;
        Group([f32x8::from(halves[0]), f32x8::from(halves[1])])
    }

    #[inline(always)]
    /// One formula for all.
    pub(crate) fn map(self, f: impl Fn(f32x8) -> f32x8) -> Self {
        Group([f(self.0[0]), f(self.0[1])])
    }

    #[inline(always)]
    /// One formula for all pairs.
    pub(crate) fn zip(self, other: Self, f: impl Fn(f32x8, f32x8) -> f32x8) -> Self {
        Group([f(self.0[0], other.0[0]), f(self.0[1], other.0[1])])
    }

    /// The first `len` numbers, and zeros after them.
    #[inline(always)]
    pub(crate) fn first(self, len: usize) -> Self {
        let mut values = self.to_array();
        values[len..].fill(0.0);
        Group::of(&values)
    }

    /// Whether any bit is set in any of the numbers.
    #[inline(always)]
    pub(crate) fn any_bits(self) -> bool {
        let bits: u32x8 = bytemuck::cast(self.0[0] | self.0[1]);
        bits.simd_ne(u32x8::ZERO).any()
    }

    /// The products with another group, two of them added.
    #[inline(always)]
    pub(crate) fn products(self, other: Self) -> f32x8 {
        self.0[0] * other.0[0] + self.0[1] * other.0[1]
    }

    #[inline(always)]
    /// The floats again.
    pub(crate) fn to_array(self) -> [f32; LANES] {
        bytemuck::cast(self.0)
    }
}

/// The sum of eight running sums, in f64.
pub(crate) fn total(sums: f32x8) -> f64 {
    sums.to_array().iter().map(|&v| f64::from(v)).sum()
}
