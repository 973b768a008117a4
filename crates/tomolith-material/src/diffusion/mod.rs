//! Diffusion of what moves: inhibitors, initiator, dose.
//!
//! Two schemes: [`faces`] of voxels (any walls, air, a D that changes; a longest step), and [`spectral`] (exact for an even D in a box, any step).

pub mod faces;
pub mod spectral;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How diffusion is stepped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Scheme {
    /// Flux through the six faces of each voxel, explicit in time.
    #[default]
    Faces,
    /// Cosine modes, exact in time; Strang splitting with the reaction.
    Spectral,
}
