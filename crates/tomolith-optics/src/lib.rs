//! Optics: what stands between a projector's pixel and the resin.

pub mod absorption_map;
pub mod edges;
pub mod exposure;
pub mod gradient;
pub mod interface;
pub mod light;
pub mod motion;
pub mod obstacle;
pub mod phase;
pub mod point_spread;
pub mod power_balance;
pub mod projector;
pub mod random;
pub mod resin;
pub mod space;
pub mod surface;
pub mod trace;
pub mod vial;
