//! Patterns of a job as its projector shows them: on few levels, or on pixels that are not those of the light.

use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::Patterns;
use crate::job::dose::written::Written;
use crate::job::resolve::ResolvedJob;
use crate::models::PatternLayout;
use crate::optimize::Problem;
use crate::optimize::levels::{self, Gain};

/// The input of the machine, and the light that it gives for it.
pub(crate) struct Levelled {
    pub(crate) asked: Vec<Patterns>,
    pub(crate) gain: Gain,
}

/// How much of patterns a machine of many levels changes, in the norm, from where on they are improved on its pixels. The 8 bits of
/// example 01 change 0.3 %.
const CHANGED: f64 = 0.03;

/// Improves patterns as the job's machine shows them; None where the job rounds plainly, or its many levels on even pixels lose next to nothing.
pub(crate) fn improve(
    job: &ResolvedJob,
    problem: &mut Problem<HostField>,
    x: &HostField,
) -> Result<Option<Levelled>> {
    let evaluate = job.evaluation();
    let on_pixels = job.may_improve_pixels();
    if !evaluate.improves_levels() && !on_pixels {
        return Ok(None);
    }
    let lights = problem.model().patterns();
    let mut shown = |asked: &HostField| shown(job, lights, patterns(lights, asked));
    if !evaluate.improves_levels() {
        let mut change = shown(x)?;
        change.axpy(-1.0, x);
        if change.norm() <= CHANGED * x.norm() {
            return Ok(None);
        }
    }
    let few = evaluate.has_few_levels().then_some(evaluate.bit_depth);
    let (asked, gain) = levels::improve(problem, x, &mut shown, few)?;
    if few.is_none() && gain.steps == 0 {
        return Ok(None);
    }
    Ok(Some(Levelled {
        asked: patterns(lights, &asked),
        gain,
    }))
}

/// What the job's machine shows of patterns, as a field.
pub(crate) fn shown(
    job: &ResolvedJob,
    lights: &[PatternLayout],
    asked: Vec<Patterns>,
) -> Result<HostField> {
    let written = Written::of_raw(asked, job)?;
    let mut x = HostField::zeros(lights.iter().map(PatternLayout::len).sum());
    for (light, shown) in lights.iter().zip(&written.shown) {
        light.fill_field(shown, x.as_mut_slice());
    }
    Ok(x)
}

pub(crate) fn patterns(lights: &[PatternLayout], x: &HostField) -> Vec<Patterns> {
    let lights = lights.iter();
    lights
        .map(|light| light.patterns_of(x.as_slice()))
        .collect()
}

/// What was done, for people; `few`: the bits of a machine of few levels.
pub(crate) fn sentence(few: Option<u32>, gain: &Gain) -> String {
    let Gain {
        rounded_loss,
        diffused_loss,
        loss,
        scale,
        steps,
        calls,
    } = gain;
    let Some(bits) = few else {
        let way = match loss < rounded_loss {
            true => format!("lowered it from {rounded_loss:.4e} to {loss:.4e}"),
            false => format!("did not lower it from {rounded_loss:.4e}"),
        };
        return format!(
            "loss of what the machine's pixels show: {steps} steps {way} ({calls} model calls)"
        );
    };
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
