//! A card for the tests: a real one, else a software adapter; None where this machine has neither.
#![expect(clippy::print_stderr, reason = "a skipped test says so")]

use tomolith_gpu::{Asked, Gpu};

/// Bindings of a few rows, so that every field has several pieces.
pub(crate) const SMALL: u64 = 64 << 10;

pub(crate) fn gpu(most: u64) -> Option<Gpu> {
    smaller(most, u64::MAX)
}

/// The same with so much memory.
pub(crate) fn smaller(most: u64, memory: u64) -> Option<Gpu> {
    let named = |name| Gpu::smaller(&Asked::Named(name), most, memory);
    let found = Gpu::smaller(&Asked::Any, most, memory).or_else(|_| named("llvmpipe"));
    match found {
        Ok(gpu) => Some(gpu),
        Err(error) => {
            assert!(
                std::env::var_os("TOMOLITH_NEEDS_GPU").is_none(),
                "TOMOLITH_NEEDS_GPU is set, but {error}"
            );
            eprintln!("skipped: {error}");
            None
        }
    }
}
