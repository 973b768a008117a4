//! Patterns of a job on the few levels of its projector.

use super::device::Written;
use super::progress::{Event, Progress};
use super::scene::Scene;
use super::spec::{EvaluateSpec, Levelling};
use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::Patterns;
use crate::models::PatternLayout;
use crate::optimize::Problem;
use crate::optimize::levels::{self, Gain};

/// The most bits at which patterns are improved on their levels; with more, rounding costs next to nothing (docs/measured/levels.md).
const MOST_BITS: u32 = 5;

/// What the machine is asked for, and what that brings.
pub(crate) struct Levelled {
    pub(crate) asked: Vec<Patterns>,
    pub(crate) gain: Gain,
}

/// Whether a job's patterns are improved on their levels.
pub(super) fn asked(evaluate: &EvaluateSpec) -> bool {
    evaluate.bit_depth <= MOST_BITS && evaluate.levels == Levelling::Optimized
}

/// Improves patterns on the levels that the job's machine shows; None where the job rounds plainly, or has many levels.
///
/// # Errors
/// As [`levels::improve`] and [`Written::of_raw`].
pub(super) fn improve(
    scene: &Scene,
    problem: &mut Problem<HostField>,
    x: &HostField,
    progress: &mut dyn Progress,
) -> Result<Option<Levelled>> {
    let evaluate = &scene.spec.evaluate;
    if !asked(evaluate) {
        return Ok(None);
    }
    let lights = problem.model().patterns();
    let mut shown = |asked: &HostField| {
        let written = Written::of_raw(patterns(lights, asked), scene)?;
        let mut x = asked.zeros_like();
        for (light, shown) in lights.iter().zip(&written.shown) {
            light.fill_field(shown, x.as_mut_slice());
        }
        Ok(x)
    };
    let (asked, gain) = levels::improve(problem, x, &mut shown)?;
    progress.event(&Event::Note {
        text: sentence(evaluate.bit_depth, &gain),
    });
    Ok(Some(Levelled {
        asked: patterns(lights, &asked),
        gain,
    }))
}

/// Images of all lights.
pub(super) fn patterns(lights: &[PatternLayout], x: &HostField) -> Vec<Patterns> {
    let lights = lights.iter();
    lights
        .map(|light| light.patterns_of(x.as_slice()))
        .collect()
}

/// What was done, for people.
pub(crate) fn sentence(bits: u32, gain: &Gain) -> String {
    let Gain {
        rounded_loss,
        loss,
        scale,
        steps,
        calls,
    } = gain;
    if loss < rounded_loss {
        format!(
            "bit depth {bits}: loss {loss:.4e} on its levels, {rounded_loss:.4e} by plain rounding ({steps} steps, {calls} model calls; full scale \
             {scale:.2} of the brightest pixel)"
        )
    } else {
        format!(
            "bit depth {bits}: loss {loss:.4e} by plain rounding, which {steps} steps did not improve ({calls} model calls)"
        )
    }
}
