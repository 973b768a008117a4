//! Metrics.
pub mod isosurface;
pub mod nearest;
pub mod scan;
