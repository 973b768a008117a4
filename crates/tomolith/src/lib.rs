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
//! Crates are in ARCHITECTURE.md, conventions in docs/conventions.md.

pub mod job;

pub use tomolith_core::{
    Error, Place, Result, columns, dose, error, field, grid, kind, parallel, random, ranks,
    response, text, units, work,
};
#[cfg(feature = "gpu")]
pub use tomolith_gpu as gpu;
pub use tomolith_io as io;
pub use tomolith_metrics as metrics;
pub use tomolith_models as models;
pub use tomolith_objective as objective;
pub use tomolith_optics as optics;
pub use tomolith_optics::exposure;
pub use tomolith_optimize as optimize;
pub use tomolith_report as report;
pub use tomolith_target as target;

/// Properties that every model, objective and method must have.
pub mod check {
    pub use tomolith_core::check::*;
    pub use tomolith_objective::check::objective;
    pub use tomolith_optimize::check::optimizer;
}
