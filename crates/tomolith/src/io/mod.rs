//! Formats in and out.

pub mod image;
pub mod mesh;
