//! Optics: what stands between a projector's pixel and the resin.

pub mod interface;
pub mod resin;
pub mod trace;
pub mod vial;
