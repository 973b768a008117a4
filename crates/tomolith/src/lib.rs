//! Tomolith computes the light patterns of tomographic volumetric additive manufacturing (TVAM) and predicts what they
//! print.
//!
//! ```text
//! min over x        L( M( F(x) ) )  +  Σ λᵢ Rᵢ(x)          subject to   x_min ≤ x ≤ x_max
//!
//! x  patterns        one image per angle and light          target/   what should be printed
//! F  dose model      patterns → absorbed dose               models/ on optics/
//! M  response        dose → what the material does          response/
//! L  band objective  response against the target            objective/
//! ```
//!
//! Rooms and floors are in ARCHITECTURE.md, conventions in docs/conventions.md.

pub mod check;
pub mod error;
pub mod exposure;
pub mod field;
pub mod grid;
pub mod io;
pub mod job;
pub mod kind;
pub mod metrics;
pub mod models;
pub mod objective;
pub mod optics;
pub mod optimize;
pub mod report;
pub mod response;
mod run;
pub mod target;
pub mod units;

pub use error::{Error, Place, Result};
