//! What keeps a print from being perfect, one cause at a time, with the key that changes it.

use serde::ser::{Serialize, SerializeMap, Serializer};

/// Why a print is worse than the target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Cause {
    /// The optimization does not see inside of its voxels.
    Grid,
    /// Patterns are written with gray levels, on the pixels of a machine.
    Levels,
    /// The vial turns during each frame.
    Turning,
    /// The light: pixels, frames, what they can do at all.
    Optics,
    /// The optimization ended while its loss was still falling.
    Iterations,
    /// Horizontal faces of the part lie within rows of pixels.
    Ends,
    /// The exposure of `evaluate.threshold` is not the best one.
    Exposure,
    /// The brightest pixel, which says how long the print takes.
    Time,
}

/// One cause.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// Which.
    pub cause: Cause,
    /// What it costs was measured in: `iou` or `rms_error`.
    pub measure: &'static str,
    /// By how much it makes the print worse; below 0: better. Of `iterations`: at most.
    pub loss: f64,
    /// The key to change.
    pub key: String,
    /// What was found, and what to do.
    pub advice: String,
}

/// As `{cause, loss_in_iou, key, advice}`, or `loss_in_rms_error`.
impl Serialize for Limit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(4))?;
        map.serialize_entry("cause", &self.cause)?;
        map.serialize_entry(&format!("loss_in_{}", self.measure), &self.loss)?;
        map.serialize_entry("key", &self.key)?;
        map.serialize_entry("advice", &self.advice)?;
        map.end()
    }
}

/// All causes that were measured.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct PrintLimits {
    /// What spoils the print, of which its numbers do not know, in a sentence.
    pub spoiled: Option<String>,
    /// All of it in one line.
    pub sentence: String,
    /// The largest loss first.
    pub causes: Vec<Limit>,
}
