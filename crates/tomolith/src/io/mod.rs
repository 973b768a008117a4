//! Formats in and out.

#[cfg(test)]
pub(crate) mod fuzz;
pub mod image;
pub mod mesh;
