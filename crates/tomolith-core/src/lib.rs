//! What everything of Tomolith stands on: grids, fields, errors, files, tables of numbers, kinds, units, vectors and trees of boxes, dose models as a trait, material responses, least squares, ranks and run control.
//!
//! Users find all of it in the crate `tomolith`; whoever writes a dose model, or fields in the memory of a device, needs this crate alone.

pub mod boxes;
pub mod check;
pub mod columns;
pub mod dose;
pub mod error;
pub mod field;
pub mod files;
pub mod grid;
pub mod kind;
pub mod least_squares;
pub mod monotone_cubic;
pub mod parallel;
pub mod random;
pub mod ranks;
pub mod response;
pub mod target;
pub mod text;
pub mod units;
pub mod vector;
pub mod work;

pub use error::{Error, Place, Result};
