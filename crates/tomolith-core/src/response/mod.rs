//! Responses: dose → what the material does.
//!
//! *What must it do, and who does it.* A [`Response`] is M of the one equation, voxel by voxel. Bands, metrics and
//! thresholds are in units of the response.

pub mod curve;
pub mod fit;
pub mod identity;
pub mod logistic;
pub mod table;

use crate::error::{Error, Result};
use crate::field::Lanes;
use crate::kind::{Kind, Section};
pub use identity::Identity;
pub use logistic::Logistic;
pub use table::Table;

/// What a response is as data, for a backend that computes it where its fields live.
#[derive(Clone, Copy, Debug)]
pub enum ResponseForm<'a> {
    /// M(d) = d
    Identity,
    /// The formula of [`logistic`] with these parameters.
    Logistic(&'a logistic::Params),
    /// A cubic between two doses, a line beyond the first and the last.
    Table(&'a Table),
    /// Known as code of the host only: a backend that cannot call it takes a table of [`Response::value_and_slope`].
    Code,
}

/// A scalar, increasing map of the dose.
pub trait Response: std::fmt::Debug + Send + Sync {
    /// M(d)
    fn value(&self, dose: f32) -> f32;
    /// M(d) and dM/dd
    fn value_and_slope(&self, dose: f32) -> (f32, f32);
    /// The dose d with M(d) = m; m outside the range of M is first brought to the nearest value inside.
    fn inverse(&self, response: f32) -> f32;
    /// Smallest and largest response, limits included: what a band can ask for.
    fn range(&self) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }
    /// What it is as data.
    fn form(&self) -> ResponseForm<'_> {
        ResponseForm::Code
    }
    /// Whether M(d) = d, so that kernels may skip it.
    fn is_identity(&self) -> bool {
        matches!(self.form(), ResponseForm::Identity)
    }
    /// Sixteen voxels at once: replaces doses by responses and writes the slopes. Overridden where a loop without calls
    /// is faster; the numbers are those of [`value_and_slope`](Self::value_and_slope).
    fn lanes(&self, doses: &mut Lanes, slopes: &mut Lanes) {
        for (dose, slope) in doses.0.iter_mut().zip(&mut slopes.0) {
            (*dose, *slope) = self.value_and_slope(*dose);
        }
    }
}

/// Share of a range by which something may lie beyond it: a curve that was fitted ends at 0.9997 and not at 1.
const SLACK: f64 = 0.01;

/// Whether some dose has a response between two values, or nearly so.
#[must_use]
pub fn is_reached(response: &dyn Response, lower: f64, upper: f64) -> bool {
    let [low, high] = response.range();
    let slack = Some(SLACK * (high - low)).filter(|s| s.is_finite());
    let slack = slack.unwrap_or(0.0);
    lower <= high + slack && upper >= low - slack
}

/// The dose with which a material responds as wanted.
///
/// # Errors
/// [`Error::Config`] (without a key) when no dose does.
#[expect(clippy::cast_possible_truncation, reason = "a dose is f32")]
pub fn dose_for(response: &dyn Response, wanted: f64) -> Result<f32> {
    if is_reached(response, wanted, wanted) {
        return Ok(response.inverse(wanted as f32));
    }
    let [low, high] = response.range();
    Err(Error::config(
        "",
        format!("the start needs a dose with the response {wanted}, but no dose gives it"),
        format!(
            "a response that reaches it (this one goes from {low} to {high}), or a start that does not need it: \
             [start.zero], [start.patterns]"
        ),
    ))
}

/// Builds a response from its section.
pub type BuildResponse = fn(&Section) -> Result<Box<dyn Response>>;

/// Every response.
pub static RESPONSES: &[Kind<BuildResponse>] =
    &[identity::KIND, logistic::KIND, table::KIND, fit::KIND];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;
    use crate::near;

    fn examples() -> Vec<Box<dyn Response>> {
        RESPONSES
            .iter()
            .map(|row| (row.build)(&check::example(row)).unwrap())
            .collect()
    }

    #[test]
    fn every_slope_is_the_derivative() {
        for response in examples() {
            for i in -20..40 {
                let dose = i as f32 * 0.05 + 0.013;
                let h = 4e-3;
                let difference = (f64::from(response.value(dose + h))
                    - f64::from(response.value(dose - h)))
                    / f64::from((dose + h) - (dose - h));
                let (value, slope) = response.value_and_slope(dose);
                assert_eq!(value, response.value(dose), "{response:?} at {dose}");
                assert!(
                    (difference - f64::from(slope)).abs() < 1e-3 * (1.0 + f64::from(slope)),
                    "{response:?} at {dose}: slope {slope}, differences {difference}"
                );
            }
        }
    }

    #[test]
    fn every_inverse_leads_back_and_extremes_stay_finite() {
        for response in examples() {
            for i in 1..40 {
                let dose = i as f32 * 0.025;
                let back = response.inverse(response.value(dose));
                near!(back, dose, 1e-4, "{response:?}: {dose} came back as {back}");
            }
            for dose in [-1e30, -1e3, 0.0, 1e3, 1e30, f32::MAX, f32::MIN] {
                let (value, slope) = response.value_and_slope(dose);
                assert!(
                    value.is_finite() && slope.is_finite(),
                    "{response:?} at {dose}"
                );
                assert!(
                    response.inverse(dose).is_finite(),
                    "{response:?}: inverse of {dose}"
                );
            }
            assert!(
                response.value(f32::NAN).is_nan(),
                "{response:?} hides a NaN"
            );
        }
    }

    #[test]
    fn a_response_is_asked_for_what_it_reaches_only() {
        let params = logistic::Params {
            lower: 0.1,
            upper: 0.9,
            ..Default::default()
        };
        let response = Logistic::new(params).unwrap();
        assert!((dose_for(&response, 0.5).unwrap() - 0.5).abs() < 1e-6);
        // The slack is 0.008
        for (lower, upper, reached) in [
            (0.0, 0.2, true),
            (f64::NEG_INFINITY, 0.05, false),
            (0.905, 1.0, true),
            (0.92, f64::INFINITY, false),
        ] {
            assert_eq!(
                is_reached(&response, lower, upper),
                reached,
                "{lower} {upper}"
            );
        }
        let Err(Error::Config { accepted, .. }) = dose_for(&response, 1.0) else {
            panic!("it was asked for 1")
        };
        assert!(accepted.contains("from 0.1 to 0.9"), "{accepted}");
        assert_eq!(dose_for(&Identity, 7.0).unwrap(), 7.0);
    }

    #[test]
    fn lanes_are_the_scalar_numbers() {
        for response in examples() {
            let mut values = Lanes(std::array::from_fn(|i| i as f32 * 0.2 - 1.0));
            let doses = values;
            let mut slopes = Lanes::default();
            response.lanes(&mut values, &mut slopes);
            for i in 0..16 {
                assert_eq!(
                    (values.0[i], slopes.0[i]),
                    response.value_and_slope(doses.0[i])
                );
            }
        }
    }
}
