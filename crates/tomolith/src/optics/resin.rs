//! The resin: what it does to light.
