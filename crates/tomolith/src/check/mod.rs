//! Public properties that every model, objective and optimiser must have.
//!
//! Each check returns what is wrong in one sentence. Every row of every table is enrolled by the tests of its family.

pub mod model;
mod objective;
mod optimizer;
#[cfg(test)]
mod penalised;
pub(crate) mod small;

pub use objective::objective;
pub use optimizer::{Build, optimizer};

/// Numbers between −1 and 1 that look random and are the same everywhere.
pub(crate) fn noise(len: usize, seed: u32) -> Vec<f32> {
    let mut state = seed.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / 8_388_608.0 - 1.0
    };
    (0..len).map(|_| next()).collect()
}
