//! Patterns of a job on the few levels of its projector.

use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::Patterns;
use crate::job::dose::written::Written;
use crate::job::progress::{Event, Progress};
use crate::job::resolve::ResolvedJob;
use crate::models::PatternLayout;
use crate::optimize::Problem;
use crate::optimize::levels::{self, Gain};

/// The input of the machine, and the light that it gives for it.
pub(crate) struct Levelled {
    pub(crate) asked: Vec<Patterns>,
    pub(crate) gain: Gain,
}

/// Improves patterns on the levels that the job's machine shows; None where the job rounds plainly, or has many levels.
pub(crate) fn improve(
    job: &ResolvedJob,
    problem: &mut Problem<HostField>,
    x: &HostField,
    progress: &mut dyn Progress,
) -> Result<Option<Levelled>> {
    let evaluate = job.evaluation();
    if !evaluate.improves_levels() {
        return Ok(None);
    }
    let lights = problem.model().patterns();
    let mut shown = |asked: &HostField| {
        let written = Written::of_raw(patterns(lights, asked), job)?;
        let mut x = asked.zeros_like();
        for (light, shown) in lights.iter().zip(&written.shown) {
            light.fill_field(shown, x.as_mut_slice());
        }
        Ok(x)
    };
    let (asked, gain) = levels::improve(problem, x, &mut shown, evaluate.bit_depth)?;
    progress.event(&Event::Note {
        text: sentence(evaluate.bit_depth, &gain),
    });
    Ok(Some(Levelled {
        asked: patterns(lights, &asked),
        gain,
    }))
}

pub(crate) fn patterns(lights: &[PatternLayout], x: &HostField) -> Vec<Patterns> {
    let lights = lights.iter();
    lights
        .map(|light| light.patterns_of(x.as_slice()))
        .collect()
}

/// What was done, for people.
pub(crate) fn sentence(bits: u32, gain: &Gain) -> String {
    let Gain {
        rounded_loss,
        diffused_loss,
        loss,
        scale,
        steps,
        calls,
    } = gain;
    let diffused = diffused_loss.map_or_else(String::new, |loss| {
        format!(", {loss:.4e} by error diffusion over neighboring frames")
    });
    if loss < rounded_loss {
        let way = match diffused_loss.is_some_and(|diffused| diffused <= *loss) {
            true => "the least, by error diffusion",
            false => "on its levels",
        };
        format!(
            "bit depth {bits}: loss {loss:.4e} {way}; {rounded_loss:.4e} by plain rounding{diffused} ({steps} steps, {calls} model calls; full scale \
             {scale:.2} of the brightest pixel)"
        )
    } else {
        format!(
            "bit depth {bits}: loss {loss:.4e} by plain rounding, which {steps} steps did not improve{diffused} ({calls} model calls)"
        )
    }
}
