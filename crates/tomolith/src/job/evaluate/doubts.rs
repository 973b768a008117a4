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
/// That share from which the bound costs a print more than its pixels do: the gear of example 01 has 0.982 where half of its pixels are at the bound, 0.974 where 62 % are, and 0.986 without it.
const MOST: f64 = 0.5;
/// Bits from which patterns have levels enough to tell.
const GRAY_BITS: u32 = 6;

/// The first light of whose shining pixels an upper bound of the job holds more than a share, and what share it holds.
fn held(job: &ResolvedJob, shown: &[Patterns], more_than: f64) -> Option<(usize, f64)> {
    let depth = job.evaluation().bit_depth;
    if job.bounds().bits.unwrap_or(depth).min(depth) < GRAY_BITS {
        return None;
    }
    let of_light = |(i, patterns): (usize, &Patterns)| {
        let largest = job.bounds_of(i).1?;
        let shining = patterns.values.iter().filter(|value| **value > 0.0);
        let [all, held] = shining.fold([0.0, 0.0], |[all, held], value| {
            let is_held = f64::from(*value) >= 0.999 * largest;
            [all + 1.0, held + f64::from(u8::from(is_held))]
        });
        (held > more_than * all).then(|| (i, held / all))
    };
    shown.iter().enumerate().find_map(of_light)
}

/// The key of the upper bound that holds most shining pixels of a light; None where none does.
pub(crate) fn held_by(job: &ResolvedJob, shown: &[Patterns]) -> Option<String> {
    held(job, shown, MOST).map(|(i, _)| job.bound_key_of(i))
}

/// Warns of patterns that an upper bound of the job holds nearly everywhere.
pub(crate) fn of_bound(job: &ResolvedJob, shown: &[Patterns]) -> Option<String> {
    let (i, share) = held(job, shown, HELD)?;
    let (key, largest) = (job.bound_key_of(i), concise(job.bounds_of(i).1?));
    let bound = match job.showing().allowed_s() {
        Some(seconds) if key == "printer.time_s" => {
            format!(
                "{largest}, as bright as printer.time_s = {} lets them be",
                exact(seconds)
            )
        }
        _ => format!("{key} = {largest}"),
    };
    Some(format!(
        "{:.0} % of the pixels that shine are at {bound}: this bound says how large the dose is, and not the objective; raise it, or leave it out",
        100.0 * share,
    ))
}

/// Warns of patterns that their lower bound holds nearly everywhere: a background of so much light is what prints.
pub(crate) fn of_background(job: &ResolvedJob, shown: &[Patterns]) -> Option<String> {
    let of_light = |(i, patterns): (usize, &Patterns)| {
        let least = job.bounds_of(i).0;
        let lit = patterns.values.iter().filter(|value| **value > 0.0);
        let [all, held] = lit.fold([0.0, 0.0], |[all, held], value| {
            let is_held = f64::from(*value) <= 1.001 * least;
            [all + 1.0, held + f64::from(u8::from(is_held))]
        });
        (least > 0.0 && held > HELD * all).then(|| {
            format!(
                "{:.0} % of the pixels are at bounds.min = {}: so much light goes through the void, too; lower it, if the projector can be darker",
                100.0 * held / all,
                concise(least)
            )
        })
    };
    shown.iter().enumerate().find_map(of_light)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::job_of;
    use crate::models::Work;

    #[test]
    fn the_bound_that_holds_a_light_is_named() {
        let text = r#"
            target = { phantom = { sphere = {} }, size_mm = 1.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 2.0 } }
            light = [{ pixels = [4, 1], angles = 1, projector = { collimated = { pixel_pitch_mm = 0.5 } } }]
        "#;
        let key_of = |changes: &[&str], values: [f32; 4]| {
            let job = ResolvedJob::under(&job_of(text, changes), &Work::new()).unwrap();
            let patterns = Patterns {
                grid: job.optics.lights[0].pixels.clone(),
                values: values.to_vec(),
            };
            let key = held_by(&job, std::slice::from_ref(&patterns));
            let warning = of_bound(&job, &[patterns]);
            assert!(
                key.as_ref()
                    .is_none_or(|key| warning.is_none_or(|text| text.contains(key)))
            );
            key
        };
        let at_bound = [0.0, 0.5, 0.5, 0.5];
        assert_eq!(key_of(&[], at_bound), None);
        let both = |key: &str| key_of(&["bounds.max=0.5", key], at_bound);
        assert_eq!(both("bounds.min=0").as_deref(), Some("bounds.max"));
        assert_eq!(
            both("light.bounds.max=0.5").as_deref(),
            Some("light[0].bounds.max")
        );
        assert_eq!(both("light.bounds.max=0.7"), None);
        // Two of three are most; half of them is not
        let most = key_of(&["bounds.max=0.5"], [0.0, 0.1, 0.5, 0.5]);
        assert_eq!(most.as_deref(), Some("bounds.max"));
        assert_eq!(key_of(&["bounds.max=0.5"], [0.1, 0.2, 0.5, 0.5]), None);
    }
}
