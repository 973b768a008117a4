//! Pixels that stay dark, and the factor of all light: the mask of a [form](tomolith_core::dose::form::Masked) on the card.

use crate::device::{Buffer, Gpu};
use std::sync::Arc;
use tomolith_core::dose::form::Masked;

#[derive(Clone)]
pub(crate) struct Mask {
    /// A bit per pixel that is not dark; one word where none is.
    pub(crate) lit: Arc<Buffer>,
    pub(crate) has_dark: bool,
    pub(crate) factor: f32,
}

/// Whether a pixel is not dark, of kernels with `p.has_dark` and the words of [`Mask::lit`] as `lit`.
pub(crate) const IS_LIT: &str = "
fn is_lit(element: u32) -> bool {
    return p.has_dark == 0u || ((lit[element / 32u] >> (element % 32u)) & 1u) == 1u;
}
";

impl Mask {
    pub(crate) fn new<G>(gpu: &Gpu, form: &Masked<G>) -> Self {
        let mut bits = vec![0u32; form.dark.len().div_ceil(32).max(1)];
        for (i, dark) in form.dark.iter().enumerate() {
            bits[i / 32] |= u32::from(!dark) << (i % 32);
        }
        Mask {
            lit: Arc::new(gpu.upload(&bits)),
            has_dark: !form.dark.is_empty(),
            factor: form.factor,
        }
    }
}
