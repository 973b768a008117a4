//! Optics: what stands between a projector's pixel and the resin.
pub mod resin;
