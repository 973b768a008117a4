//! A card for the tests: a real one, else a software adapter; None where this machine has neither.
#![expect(clippy::print_stderr, reason = "a skipped test says so")]

use tomolith_gpu::{Asked, Gpu};

/// Bindings of a few rows, so that every field has several pieces.
pub(crate) const SMALL: u64 = 64 << 10;

pub(crate) fn gpu(most: u64) -> Option<Gpu> {
    let named = |name| Gpu::with_bindings(&Asked::Named(name), most);
    let found = Gpu::with_bindings(&Asked::Any, most).or_else(|_| named("llvmpipe"));
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
