//! Warnings about evaluations whose numbers mean nothing.

use super::spec::JobSpec;
use crate::grid::Patterns;
use crate::metrics::Evaluation;
use crate::units::concise;

/// Warns of patterns that light nothing.
pub(super) fn of_light(shown: &[Patterns]) -> Option<String> {
    let is_dark = |patterns: &Patterns| patterns.values.iter().all(|&value| value == 0.0);
    shown.iter().all(is_dark).then(|| {
        "the patterns are dark everywhere, so there is no dose and nothing turns solid: use another [start], more \
         stop.iterations, or other thresholds of the objective"
            .to_owned()
    })
}

/// Warns of a threshold that all doses of part and void miss on the same side.
pub(super) fn of_threshold(spec: &JobSpec, evaluation: &Evaluation) -> Option<String> {
    let threshold = spec.evaluate.threshold?;
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
