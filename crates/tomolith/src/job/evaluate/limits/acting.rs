//! What of the lights that act on a species may limit its print.

use crate::job::resolve::acting::Acting;
use crate::report::number::significant;

/// The coarsest pixels: the key of their size, and their light where there are several.
pub(crate) fn coarsest_pixels(kinds: &[&str], lights: &[Acting<'_>]) -> (String, Option<String>) {
    // The first of equal ones
    let area = |acting: &&Acting<'_>| acting.light.pixels.pixel_mm2();
    let coarsest = lights
        .iter()
        .rev()
        .max_by(|a, b| area(a).total_cmp(&area(b)));
    let index = coarsest.map_or(0, |acting| acting.index);
    let key = format!("light[{index}].projector.{}.pixel_pitch_mm", kinds[index]);
    let name = coarsest.and_then(|acting| acting.name);
    (key, name.map(str::to_owned))
}

/// How far the vial turns during a frame of each light that has arcs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Arcs {
    /// "2°", or "3° (violet) and 2° (uv)".
    pub(crate) text: String,
    /// The key of the widest.
    pub(crate) key: String,
}

impl Arcs {
    /// None where all lights have lists of angles.
    pub(crate) fn of(lights: &[Acting<'_>]) -> Option<Self> {
        let arc = |acting: &Acting<'_>| acting.light.pixels.frame_arc.to_degrees();
        let turning = || lights.iter().filter(|acting| arc(acting) > 0.0);
        let widest = turning().rev().max_by(|a, b| arc(a).total_cmp(&arc(b)))?;
        let text_of = |acting: &Acting<'_>| {
            let degrees = significant(arc(acting), 3);
            let name = acting.name.map(|name| format!(" ({name})"));
            format!("{degrees}°{}", name.unwrap_or_default())
        };
        Some(Arcs {
            text: turning().map(text_of).collect::<Vec<_>>().join(" and "),
            key: match widest.name {
                Some(_) => format!("light[{}].angles", widest.index),
                None => "light.angles".to_owned(),
            },
        })
    }
}
