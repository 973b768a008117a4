//! Fitted response: a curve through measured points that need not rise, for example a sheet of conversion against dose.
//!
//! **What it models.** `form = "logistic"`: the generalized logistic ([`logistic`](mod@super::logistic)) with the least sum of
//! squared distances to all measurements ([`crate::least_squares`]), from the curve's own quarter points. `form = "table"`: the
//! nearest curve that never falls ([`Curve::monotone`]), joined by the monotone cubic of [`table`].
//!
//! **Source** see the pages of both kinds.
//!
//! **Parameters** see [`Params`]. **Limits** a logistic needs five points, six with `asymmetry`; points that fall with dose
//! are refused. **Cost** that of the form; the fit itself is microseconds.
//!
//! ```
//! use tomolith_core::response::{curve::Curve, fit::logistic};
//! let doses: Vec<f64> = (0..=10).map(|i| 0.1 * f64::from(i)).collect();
//! let responses: Vec<f64> = doses.iter().map(|d| 0.1 + 0.8 / (1.0 + (-12.0 * (d - 0.4f64)).exp())).collect();
//! let found = logistic(&Curve::new(&doses, &responses).unwrap(), false).unwrap();
//! assert!((found.params.steepness - 12.0).abs() < 1e-6 && (found.params.midpoint - 0.4).abs() < 1e-8); // what the points were made of
//! assert!(found.rms < 1e-9);
//! ```

use super::curve::Curve;
use super::table::{self, Beyond, Table};
use super::{BuildResponse, Logistic, Response, logistic};
use crate::error::{Error, Result};
use crate::kind::Kind;
use crate::least_squares::{Minimum, minimize};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// What is laid through the points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FitForm {
    /// The generalized logistic of least squares.
    #[default]
    Logistic,
    /// The nearest table that never falls.
    Table,
}

/// The parameters of a fit.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Measured doses
    pub dose: Vec<f64>,
    /// Responses to them
    pub response: Vec<f64>,
    /// A file with two columns, dose and response, in place of the lists; relative to the job file
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// What is laid through them: "logistic" (default) or "table"
    pub form: FitForm,
    /// Whether the logistic's asymmetry ν is fitted too (default: ν = 1)
    pub asymmetry: bool,
}

/// A logistic response that was fitted.
#[derive(Clone, Debug)]
pub struct LogisticFit {
    /// The response.
    pub params: logistic::Params,
    /// Standard errors of lower, upper, steepness, midpoint and asymmetry (0 where ν is not fitted); None where the points do not fix
    /// every parameter.
    pub errors: Option<[f64; 5]>,
    /// Root mean square of what is left, over all measurements.
    pub rms: f64,
}

/// The logistic response nearest to all measurements of a curve.
///
/// # Errors
/// [`Error::Config`] for fewer points than parameters and one, or a curve that does not rise.
pub fn logistic(curve: &Curve, asymmetry: bool) -> Result<LogisticFit> {
    let unknowns = if asymmetry { 5 } else { 4 };
    let n = curve.doses.len();
    if n <= unknowns {
        return Err(Error::config(
            "dose",
            format!("found {n} doses"),
            format!("at least {} for a fit", unknowns + 1),
        ));
    }
    if curve.responses[n - 1] <= curve.responses[0] {
        return Err(falls(curve));
    }
    let minimum = least(curve, &start(&curve.monotone())[..unknowns]);
    let theta = full(&minimum.parameters);
    let [lower, upper, b, midpoint, v] = theta;
    if lower >= upper || !theta.iter().all(|v| v.is_finite()) {
        return Err(falls(curve));
    }
    let measurements = curve.counts.iter().sum::<f64>();
    let params = logistic::Params {
        lower,
        upper,
        steepness: b.exp(),
        midpoint,
        asymmetry: v.exp(),
    };
    let errors = minimum.errors(curve.scatter, measurements as usize);
    let errors = errors.map(|found| {
        let mut errors = [0.0; 5];
        errors[..unknowns].copy_from_slice(&found);
        // Of ln B and ln ν
        errors[2] *= params.steepness;
        errors[4] *= params.asymmetry;
        errors
    });
    Ok(LogisticFit {
        params,
        errors,
        rms: ((minimum.cost + curve.scatter) / measurements).sqrt(),
    })
}

/// The refusal of points through which no rising curve goes.
fn falls(curve: &Curve) -> Error {
    let (first, last) = (curve.responses[0], curve.responses[curve.doses.len() - 1]);
    Error::config(
        "response",
        format!("a response that falls with dose or stays the same: from {first} to {last}"),
        "responses that rise with dose, apart from noise",
    )
}

/// A, K, ln B, M and ln ν.
type Theta = [f64; 5];

/// From the ends of a rising curve and the doses of a quarter and three quarters of the way.
fn start(curve: &Curve) -> Theta {
    let n = curve.doses.len();
    let (low, high) = (curve.responses[0], curve.responses[n - 1]);
    let dose_at = |share: f64| {
        let wanted = low + share * (high - low);
        let k = curve
            .responses
            .partition_point(|&m| m < wanted)
            .clamp(1, n - 1);
        let rise = curve.responses[k] - curve.responses[k - 1];
        let part = if rise > 0.0 {
            (wanted - curve.responses[k - 1]) / rise
        } else {
            0.5
        };
        curve.doses[k - 1] + part * (curve.doses[k] - curve.doses[k - 1])
    };
    let width = (dose_at(0.75) - dose_at(0.25)).max(1e-6 * (curve.doses[n - 1] - curve.doses[0]));
    // Between the quarters B·d grows by 2·ln 3
    [low, high, (9f64.ln() / width).ln(), dose_at(0.5), 0.0]
}

/// Of four parameters or five: ν = 1 unless it is among them.
fn full(theta: &[f64]) -> Theta {
    let mut full = [0.0; 5];
    full[..theta.len()].copy_from_slice(theta);
    full
}

/// The parameters nearest to all measurements.
fn least(curve: &Curve, start: &[f64]) -> Minimum {
    minimize(start, curve.doses.len(), |theta, i, slopes| {
        let (value, by) = model(curve.doses[i], &full(theta));
        let weight = curve.counts[i].sqrt();
        slopes
            .iter_mut()
            .zip(by)
            .for_each(|(slope, by)| *slope = weight * by);
        weight * (value - curve.responses[i])
    })
}

/// Response and its derivatives by A, K, ln B, M and ln ν.
fn model(dose: f64, [a, k, ln_b, m, ln_v]: &Theta) -> (f64, Theta) {
    let (b, v) = (ln_b.exp(), ln_v.exp());
    let x = b * (dose - m);
    let u = 1.0 / (1.0 + (-x).exp());
    let height = u.powf(1.0 / v);
    let rise = (k - a) * height / v * (1.0 - u);
    let by_v = if u > 0.0 {
        -(k - a) * height * u.ln() / v
    } else {
        0.0
    };
    (
        a + (k - a) * height,
        [1.0 - height, height, rise * x, -rise * b, by_v],
    )
}

fn build(params: &Params, curve: &Curve) -> Result<Box<dyn Response>> {
    match params.form {
        FitForm::Logistic => Ok(Box::new(Logistic::new(
            logistic(curve, params.asymmetry)?.params,
        )?)),
        FitForm::Table => {
            let level = curve.monotone();
            if level.responses[0] == level.responses[level.doses.len() - 1] {
                return Err(falls(curve));
            }
            Ok(Box::new(Table::new(
                &level.doses,
                &level.responses,
                Beyond::Flat,
            )?))
        }
    }
}

/// The row of the table.
pub const KIND: Kind<BuildResponse> = Kind {
    name: "fit",
    summary: "measured response: a logistic or a monotone table fitted to points of dose and response",
    example: "[response.fit]\ndose = [0.0, 0.2, 0.4, 0.5, 0.6, 0.8, 1.0]\nresponse = [0.01, 0.05, 0.27, 0.5, 0.73, 0.95, 0.99]",
    schema: crate::kind::schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        let curve = match &params.file {
            None => Curve::new(&params.dose, &params.response),
            Some(_) if !params.dose.is_empty() || !params.response.is_empty() => Err(
                Error::config("file", "both a file and lists", "one of the two"),
            ),
            Some(file) => table::read(section, file),
        };
        curve
            .and_then(|curve| build(&params, &curve))
            .map_err(|e| e.under(&section.path))
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::{noise, refuses};
    use crate::near;
    use serde_json::json;

    fn points(params: &logistic::Params, jitter: f64) -> Curve {
        let doses: Vec<f64> = (0..60).map(|i| f64::from(i) / 40.0).collect();
        let responses: Vec<f64> = doses
            .iter()
            .zip(noise(4, 60))
            .map(|(d, e)| {
                let u = 1.0 / (1.0 + (-params.steepness * (d - params.midpoint)).exp());
                params.lower
                    + (params.upper - params.lower) * u.powf(1.0 / params.asymmetry)
                    + jitter * f64::from(e)
            })
            .collect();
        Curve::new(&doses, &responses).unwrap()
    }

    #[test]
    fn a_fit_finds_what_points_were_made_of() {
        for (lower, upper, steepness, midpoint, asymmetry) in [
            (0.0, 1.0, 10.0, 0.5, 1.0),
            (-0.2, 3.0, 25.0, 0.8, 1.0),
            (0.1, 0.9, 6.0, 0.6, 2.5),
            (0.0, 1.0, 8.0, 0.5, 0.4),
        ] {
            let made_of = logistic::Params {
                lower,
                upper,
                steepness,
                midpoint,
                asymmetry,
            };
            let fit = super::logistic(&points(&made_of, 0.0), asymmetry != 1.0).unwrap();
            let (found, rms) = (fit.params, fit.rms);
            for (a, b) in [
                (found.lower, lower),
                (found.upper, upper),
                (found.steepness, steepness),
                (found.midpoint, midpoint),
                (found.asymmetry, asymmetry),
            ] {
                near!(a, b, 1e-5 * (1.0 + b.abs()));
            }
            assert!(rms < 1e-8, "{rms}");
        }
    }

    #[test]
    fn with_noise_it_is_no_worse_than_the_truth() {
        let made_of = logistic::Params {
            asymmetry: 1.0,
            ..Default::default()
        };
        let curve = points(&made_of, 0.03);
        let fit = super::logistic(&curve, false).unwrap();
        let (found, rms) = (fit.params, fit.rms);
        let pairs = curve.doses.iter().zip(&curve.responses);
        let truth: f64 = pairs
            .map(|(d, m)| (m - 1.0 / (1.0 + (-10.0 * (d - 0.5)).exp())).powi(2))
            .sum();
        assert!(rms <= (truth / 60.0).sqrt() && rms > 0.01, "{rms}");
        // The truth is within three standard errors
        let errors = fit.errors.unwrap();
        for (found, truth, error) in [
            (found.lower, 0.0, errors[0]),
            (found.upper, 1.0, errors[1]),
            (found.steepness, 10.0, errors[2]),
            (found.midpoint, 0.5, errors[3]),
        ] {
            near!(found, truth, 3.0 * error, "{found} {truth} {error}");
        }
        assert!(errors[3] < 0.01 && errors[4] == 0.0, "{errors:?}");
        assert!(
            (found.midpoint - 0.5).abs() < 0.02 && (found.steepness - 10.0).abs() < 1.0,
            "{found:?}"
        );
    }

    #[test]
    fn a_dose_that_was_measured_thrice_counts_thrice() {
        let doses = [0.0, 0.3, 0.5, 0.5, 0.5, 0.7, 1.0];
        let responses = [0.0, 0.1, 0.4, 0.5, 0.9, 0.9, 1.0];
        let repeated = Curve::new(&doses, &responses).unwrap();
        // The same measurements at doses that differ by next to nothing are not averaged
        let apart: Vec<f64> = (0..7).map(|i| doses[i] + 1e-12 * i as f64).collect();
        let apart = Curve::new(&apart, &responses).unwrap();
        let [a, b] = [repeated, apart].map(|curve| super::logistic(&curve, false).unwrap());
        assert!((a.params.midpoint - b.params.midpoint).abs() < 1e-6);
        assert!((a.rms - b.rms).abs() < 1e-6, "{} {}", a.rms, b.rms);
        let errors = [a, b].map(|fit| fit.errors.unwrap()[3]);
        assert!((errors[0] / errors[1] - 1.0).abs() < 1e-3, "{errors:?}");
    }

    #[test]
    fn derivatives_are_those_of_the_model() {
        let theta = [0.1, 0.9, 2.0, 0.5, 0.4];
        for dose in [-0.3, 0.2, 0.5, 0.9, 2.0] {
            let slopes = model(dose, &theta).1;
            for i in 0..5 {
                let moved = |h: f64| {
                    let mut t = theta;
                    t[i] += h;
                    model(dose, &t).0
                };
                let difference = (moved(1e-6) - moved(-1e-6)) / 2e-6;
                near!(difference, slopes[i], 1e-8, "{i} at {dose}");
            }
        }
    }

    #[test]
    fn noise_in_a_table_is_levelled_and_a_falling_curve_refused() {
        let section = |json| crate::kind::Section::new("response.fit", json);
        let noisy =
            json!({"dose": [0, 1, 2, 3], "response": [0.0, 0.6, 0.4, 1.0], "form": "table"});
        let table = (KIND.build)(&section(noisy)).unwrap();
        assert!((table.value(1.5) - 0.5).abs() < 1e-6);
        assert_eq!(table.range(), [0.0, 1.0]);
        let falling = json!({"dose": [0, 1, 2, 3, 4, 5], "response": [5, 4, 3, 2, 1, 0]});
        refuses((KIND.build)(&section(falling)), "response.fit.response");
        let few = json!({"dose": [0, 1, 2], "response": [0, 1, 2]});
        refuses((KIND.build)(&section(few)), "response.fit.dose");
    }
}
