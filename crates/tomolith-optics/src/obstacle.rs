//! What stands in the light: bodies that take it away, bend it or send it elsewhere.
//!
//! # Model
//! | kind | what it does to a ray that meets it |
//! |---|---|
//! | black | ends it |
//! | dielectric (index) | refracts it, in and out; nothing absorbs inside |
//! | mirror | reflects it without loss |
//! | metal (complex index) | reflects what Fresnel's formulas say, absorbs the rest |
//! | diffuse (reflectance) | sends that share back by Lambert's law, in random directions (`monte_carlo` only) |
//!
//! A body may reach through a wall of the vial: it takes the place of wall and resin.

use super::surface::Surface;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a body does to light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum BodyMaterial {
    /// Ends every ray.
    #[default]
    Black,
    /// Reflects everything.
    Mirror,
    /// Reflects by its complex index n + ik; smooth.
    Metal {
        /// n, > 0.
        refractive_index: f64,
        /// k, 0 or above.
        extinction_coefficient: f64,
    },
    /// Sends light back in all directions, as Lambert's law has it.
    Diffuse {
        /// Share that is sent back, 0 to 1.
        reflectance: f64,
    },
    /// Refracts; clear.
    Dielectric {
        /// Refractive index, > 0.
        refractive_index: f64,
    },
}

/// A body in the light.
#[derive(Clone, Debug)]
pub struct Obstacle {
    /// Its shape, in the frame of the vial.
    pub surface: Surface,
    /// What it is made of.
    pub material: BodyMaterial,
}
