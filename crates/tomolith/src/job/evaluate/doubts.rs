//! Warnings about evaluations whose numbers mean nothing.

use crate::grid::Patterns;
use crate::job::resolve::ResolvedJob;
use crate::metrics::Evaluation;
use crate::units::{concise, exact};

/// Warns of patterns that light nothing.
pub(crate) fn of_light(shown: &[Patterns]) -> Option<String> {
    let is_dark = |patterns: &Patterns| patterns.values.iter().all(|&value| value == 0.0);
    shown.iter().all(is_dark).then(|| {
        "the patterns are dark everywhere, so there is no dose and nothing turns solid: give others, or make them anew with \
         another [start], more stop.iterations, or other thresholds of the objective"
            .to_owned()
    })
}

/// Warns of patterns whose light leaves no dose in the part.
pub(crate) fn of_dose(evaluation: &Evaluation, shown: &[Patterns]) -> Option<String> {
    let is_lit = of_light(shown).is_none();
    let most = evaluation.part?.max;
    (is_lit && most == 0.0).then(|| {
        "the patterns leave no dose in the part, so nothing of it turns solid: look at resin.absorption_per_mm and bounds.max, and at \
         where the light goes (`tomolith trace`)"
            .to_owned()
    })
}

/// Share of the pixels that shine above which a bound, and not the objective, says how bright they are.
const HELD: f64 = 0.9;
/// Bits from which patterns have levels enough to tell.
const GRAY_BITS: u32 = 6;

/// Warns of patterns that an upper bound of the job holds nearly everywhere.
pub(crate) fn of_bound(job: &ResolvedJob, shown: &[Patterns]) -> Option<String> {
    let largest = job.bounds().max?;
    let depth = job.evaluation().bit_depth;
    if job.bounds().bits.unwrap_or(depth).min(depth) < GRAY_BITS {
        return None;
    }
    let values = || shown.iter().flat_map(|patterns| &patterns.values);
    let shining = values().filter(|value| **value > 0.0).count();
    let held = values()
        .filter(|value| f64::from(**value) >= 0.999 * largest)
        .count();
    (shining > 0 && held as f64 > HELD * shining as f64).then(|| {
        let largest = concise(largest);
        let bound = match job.showing().allowed_s() {
            Some(seconds) => format!("{largest}, as bright as printer.time_s = {} lets them be", exact(seconds)),
            None => format!("bounds.max = {largest}"),
        };
        format!(
            "{:.0} % of the pixels that shine are at {bound}: this bound says how large the dose is, and not the objective; raise it, or leave it out",
            100.0 * held as f64 / shining as f64,
        )
    })
}

/// Warns of patterns that their lower bound holds nearly everywhere: a background of so much light is what prints.
pub(crate) fn of_background(job: &ResolvedJob, shown: &[Patterns]) -> Option<String> {
    let least = job.bounds().min;
    let values = || shown.iter().flat_map(|patterns| &patterns.values);
    let lit = values().filter(|value| **value > 0.0).count();
    let held = values()
        .filter(|value| **value > 0.0 && f64::from(**value) <= 1.001 * least)
        .count();
    (least > 0.0 && held as f64 > HELD * lit as f64).then(|| {
        format!(
            "{:.0} % of the pixels are at bounds.min = {}: so much light goes through the void, too; lower it, if the projector can be darker",
            100.0 * held as f64 / lit as f64,
            concise(least)
        )
    })
}

/// Warns of a threshold that all doses of part and void miss on the same side.
pub(crate) fn of_threshold(job: &ResolvedJob, evaluation: &Evaluation) -> Option<String> {
    let threshold = job.evaluation().threshold?;
    let spreads = || [evaluation.part, evaluation.void].into_iter().flatten();
    let highest = spreads().map(|s| f64::from(s.max)).reduce(f64::max)?;
    let lowest = spreads().map(|s| f64::from(s.min)).reduce(f64::min)?;
    let advice = "use a threshold between the doses of void and part, or leave the key out for the one with the best IoU";
    let at = concise(threshold);
    if threshold > highest {
        let highest = concise(highest);
        Some(format!(
            "evaluate.threshold = {at} is above every dose (the highest is {highest}), so nothing turns solid: {advice}"
        ))
    } else if threshold < lowest {
        let lowest = concise(lowest);
        Some(format!(
            "evaluate.threshold = {at} is below every dose (the lowest is {lowest}), so everything turns solid: {advice}"
        ))
    } else {
        None
    }
}
