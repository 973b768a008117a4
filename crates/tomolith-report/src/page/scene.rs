//! What the page draws of a job's machine: walls of the vial, bodies in the light, and rays of some pixels, in the frame of the vial, in which the part
//! stands still. Light of a frame comes from its azimuth, counter-clockwise from +x seen from above.

use serde::Serialize;

/// A closed line in a horizontal cut, mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SceneOutline {
    /// What it is, for people.
    pub name: String,
    /// Its corners `[x, y]`, mm.
    pub points: Vec<[f64; 2]>,
}

/// The way of a pixel's middle ray.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LightPath {
    /// Where it bends, enters and leaves `[x, y, z]`, mm; the first lies before the vial.
    pub points: Vec<[f64; 3]>,
    /// Which of the points is the first in resin.
    pub resin_from: usize,
}

/// Rays of a frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FramePaths {
    /// Which frame, from 0.
    pub frame: usize,
    /// Where its light comes from, degrees.
    pub angle_deg: f64,
    /// Rays of some of its pixels.
    pub rays: Vec<LightPath>,
}

/// Rays of a light.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LightPaths {
    /// Name of the light; may be empty when there is only one.
    pub name: String,
    /// Some of its frames.
    pub frames: Vec<FramePaths>,
}

/// The machine of a job as a page draws it: in the frame of the vial, in which the part stands still; light of a frame comes from its azimuth,
/// counter-clockwise from +x seen from above.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Scene {
    /// Whether rays of any frame are those of another one, turned: every wall is a circle about the axis, and no body lies in the light.
    pub is_round: bool,
    /// Radius that every frame lights, mm.
    pub lit_radius_mm: Option<f64>,
    /// The sides of the target reach so far from the axis, mm.
    pub part_radius_mm: f64,
    /// Lowest and highest of the target, mm.
    pub z_mm: [f64; 2],
    /// Walls from outside to inside.
    pub walls: Vec<SceneOutline>,
    /// Rays.
    pub lights: Vec<LightPaths>,
    /// Bodies in the light.
    pub obstacles: Vec<SceneOutline>,
}
