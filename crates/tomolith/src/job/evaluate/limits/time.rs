//! Whether the print lasts longer than it need, or would be better if it lasted longer: what the brightest pixels say of that.
//!
//! **Rule** Of the prints of docs/fidelity.md below eight ceilings, those with at most 1 % of their light above half of the ceiling were as good below the half, and those with
//! more than 30 % there lost up to 0.03 in IoU against twice the ceiling. Between these the light does not show which it is. A run that searched for its ceiling knows more.

use crate::grid::Patterns;
use crate::job::evaluate::limits::{Limit, MetricKind};
use crate::job::optimize::Optimized;
use crate::job::resolve::ResolvedJob;
use crate::report::Cause;
use crate::report::number::significant;

/// Shares of the light above half of the brightest pixel, below which half would do and above which twice would be better.
const LITTLE: f64 = 0.01;
const MUCH: f64 = 0.3;

/// What a lower or a higher ceiling would change; None where it is not known. The cost in quality was not measured: it is 0.
pub(crate) fn of_ceiling(
    job: &ResolvedJob,
    optimized: &Optimized,
    kind: &MetricKind,
) -> Option<Limit> {
    if optimized.ceiling.is_some() {
        return None;
    }
    let (brightest, above) = above_half(&optimized.raw)?;
    let percent = significant(100.0 * above, 2);
    let key = job.showing().bound_key();
    let half = match job.showing().allowed_s() {
        Some(seconds) => seconds / 2.0,
        None => brightest / 2.0,
    };
    let half = significant(half, 3);
    let is_bounded = job.bounds().max.is_some();
    let advice = if above < LITTLE {
        let or = match is_bounded {
            true => ", or leave it out",
            false => "",
        };
        format!(
            "Only {percent} % of the light is what pixels shine beyond half of the brightest one: below such a ceiling the part prints about as well in half the time. Set `{key}` to {half}{or}."
        )
    } else if above > MUCH && is_bounded {
        format!(
            "{percent} % of the light is what pixels shine beyond half of the largest one: in a longer print the part may be better. Raise `{key}`."
        )
    } else {
        return None;
    };
    Some(Limit {
        cause: Cause::Time,
        measure: kind.name,
        loss: 0.0,
        key: key.to_owned(),
        advice,
    })
}

/// The brightest pixel, and the share of the light above half of it, each light's own.
fn above_half(lights: &[Patterns]) -> Option<(f64, f64)> {
    let mut sums = [0.0; 2];
    let mut brightest = 0.0f64;
    for light in lights {
        let most = light.values.iter().copied().fold(0.0f32, f32::max);
        brightest = brightest.max(f64::from(most));
        for &value in &light.values {
            sums[0] += f64::from((value - most / 2.0).max(0.0));
            sums[1] += f64::from(value);
        }
    }
    (sums[1] > 0.0).then(|| (brightest, sums[0] / sums[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::PatternGrid;

    #[test]
    fn light_above_half_of_the_brightest_pixel_is_counted_for_each_light() {
        let mut one = Patterns::dark(PatternGrid::full_turn(1, 0.0, 1, 4, 0.1));
        let mut other = one.clone();
        one.values = vec![1.0, 0.5, 0.25, 0.25];
        other.values = vec![0.1, 0.1, 0.1, 0.1];
        // ½ of 2 and 0.2 of 0.4
        let (brightest, share) = above_half(&[one, other]).unwrap();
        assert!(
            (share - 0.7 / 2.4).abs() < 1e-6 && brightest == 1.0,
            "{share}"
        );
        let dark = Patterns::dark(PatternGrid::full_turn(1, 0.0, 1, 4, 0.1));
        assert_eq!(above_half(&[dark]), None);
    }
}
