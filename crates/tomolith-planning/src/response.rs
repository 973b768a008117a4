//! Response of a material from measured pairs, ready for a job.
//!
//! **What it models** dose → conversion, modulus or index: the generalized logistic or the nearest table that never falls, both by
//! [`fit`], on linear or logarithmic axes.
//!
//! **Shape** `n` pairs in, a TOML table `[response.logistic]` or `[response.table]` out. **Limits** no kind of response has a logarithmic dose: such a
//! logistic becomes a table of 33 points over the measured doses.
//!
//! ```
//! use tomolith_planning::response::{Axes, ResponseFit};
//! let doses = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];
//! let modulus = doses.map(|d: f64| 10f64.powf(1.0 + 2.0 / (1.0 + (-6.0 * (d.log10() - 0.9)).exp())));
//! let pairs: Vec<[f64; 2]> = doses.iter().zip(modulus).map(|(d, m)| [*d, m]).collect();
//! let fit = ResponseFit::logistic(&pairs, Axes { log_dose: true, log_response: true }, false).unwrap();
//! let found = fit.logistic.as_ref().unwrap();
//! assert!((found.params.midpoint - 0.9).abs() < 1e-6 && (found.params.upper - 3.0).abs() < 1e-6);
//! assert!(fit.job_table().contains("[response.table]"));
//! ```

use std::sync::Arc;
use tomolith_core::error::{Error, Result};
use tomolith_core::response::curve::Curve;
use tomolith_core::response::fit::{self, LogisticFit};
use tomolith_core::response::table::{self, Beyond};
use tomolith_core::response::{Logistic, Response, Table, logistic};
use tomolith_core::units::concise;
use tomolith_report::plot::{Axis, Plot};

/// Points of a table that stands for a logistic on a logarithmic dose.
const SAMPLES: usize = 33;

/// Which axes are decimal logarithms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Axes {
    /// The dose.
    pub log_dose: bool,
    /// The response.
    pub log_response: bool,
}

impl Axes {
    fn dose(self, dose: f64) -> f64 {
        if self.log_dose { dose.log10() } else { dose }
    }

    fn response(self, response: f64) -> f64 {
        if self.log_response {
            response.log10()
        } else {
            response
        }
    }
}

/// A response that was fitted.
#[derive(Clone, Debug)]
pub struct ResponseFit {
    /// The axes it was fitted on.
    pub axes: Axes,
    /// The measured pairs as given.
    pub measured: Vec<[f64; 2]>,
    /// The logistic on these axes; None for a table.
    pub logistic: Option<LogisticFit>,
    /// The points of the table on these axes; None for a logistic.
    pub table: Option<Curve>,
    /// The one or the other as a job has it.
    response: Arc<dyn Response>,
    /// Root mean square of what is left, on the axis of the response.
    pub rms: f64,
}

impl ResponseFit {
    /// The logistic of least squares; `asymmetry` says whether ν is fitted.
    ///
    /// # Errors
    /// [`Error::Config`] for too few points, points that fall, and numbers without a logarithm on a logarithmic axis.
    pub fn logistic(measured: &[[f64; 2]], axes: Axes, asymmetry: bool) -> Result<Self> {
        let curve = on_axes(measured, axes)?;
        let fit = fit::logistic(&curve, asymmetry)?;
        Ok(ResponseFit {
            axes,
            measured: measured.to_vec(),
            response: Arc::new(Logistic::new(fit.params.clone())?),
            rms: fit.rms,
            logistic: Some(fit),
            table: None,
        })
    }

    /// The nearest table that never falls.
    ///
    /// # Errors
    /// As [`logistic`](Self::logistic).
    pub fn table(measured: &[[f64; 2]], log_response: bool) -> Result<Self> {
        let axes = Axes {
            log_dose: false,
            log_response,
        };
        let curve = on_axes(measured, axes)?;
        let level = curve.monotone();
        if level.responses[0] == level.responses[level.responses.len() - 1] {
            return Err(Error::config(
                "response",
                "a response that falls with dose or stays the same",
                "responses that rise with dose, noise apart",
            ));
        }
        let mut fit = ResponseFit {
            axes,
            measured: measured.to_vec(),
            rms: 0.0,
            logistic: None,
            response: Arc::new(Table::new(&level.doses, &level.responses, Beyond::Flat)?),
            table: Some(level),
        };
        let rest = |[dose, response]: &[f64; 2]| fit.at(*dose) - axes.response(*response);
        let squares: f64 = measured.iter().map(|pair| rest(pair).powi(2)).sum();
        fit.rms = (squares / measured.len() as f64).sqrt();
        Ok(fit)
    }

    /// Response, on its axis, to a dose as it was given.
    #[expect(clippy::cast_possible_truncation, reason = "responses are f32")]
    fn at(&self, dose: f64) -> f64 {
        f64::from(self.response.value(self.axes.dose(dose) as f32))
    }

    /// Width of the dose axis over which the logistic goes from 10 % to 90 % of its rise; None for a table.
    #[must_use]
    pub fn width_10_90(&self) -> Option<f64> {
        let LogisticFit { params: p, .. } = self.logistic.as_ref()?;
        let at = |height: f64| p.midpoint - (height.powf(-p.asymmetry) - 1.0).ln() / p.steepness;
        Some(at(0.9) - at(0.1))
    }

    /// What share of the logistic's rise lies below the lowest and below the highest measured dose; None for a table.
    #[must_use]
    pub fn measured_rise(&self) -> Option<[f64; 2]> {
        let LogisticFit { params: p, .. } = self.logistic.as_ref()?;
        Some(
            self.ends(0)
                .map(|dose| (self.at(dose) - p.lower) / (p.upper - p.lower)),
        )
    }

    /// The table for a job.
    #[must_use]
    pub fn job_table(&self) -> String {
        let mut text = String::from("# Fitted by `tomolith calibrate response`");
        if self.axes.log_response {
            text += ". The response is the decimal logarithm of what was measured: targets and bands are in these units";
        }
        let logistic = self.logistic.as_ref().filter(|_| !self.axes.log_dose);
        let (name, keys) = match (logistic, &self.table) {
            (Some(LogisticFit { params: p, .. }), _) => {
                let params = logistic::Params {
                    lower: six_digits(p.lower),
                    upper: six_digits(p.upper),
                    steepness: six_digits(p.steepness),
                    midpoint: six_digits(p.midpoint),
                    asymmetry: six_digits(p.asymmetry),
                };
                ("logistic", toml::to_string(&params))
            }
            (None, Some(table)) => ("table", table_of(&table.doses, &table.responses)),
            (None, None) => {
                let doses = self.sampled(SAMPLES);
                let responses: Vec<f64> = doses.iter().map(|dose| self.at(*dose)).collect();
                ("table", table_of(&doses, &responses))
            }
        };
        // Numbers and words are always TOML
        format!("{text}\n[response.{name}]\n{}", keys.unwrap_or_default())
    }

    /// Lowest and highest of the measured doses (0) or responses (1).
    fn ends(&self, column: usize) -> [f64; 2] {
        let values = || self.measured.iter().map(|pair| pair[column]);
        [
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        ]
    }

    /// Doses over the measured range, even on the axis.
    fn sampled(&self, count: usize) -> Vec<f64> {
        let [first, last] = self.ends(0);
        let (low, high) = (self.axes.dose(first), self.axes.dose(last));
        let at = |i: usize| {
            let dose = low + (high - low) * i as f64 / (count - 1) as f64;
            if self.axes.log_dose {
                10f64.powf(dose)
            } else {
                dose
            }
        };
        (0..count).map(at).collect()
    }

    /// Measured points and the response, on the axes of the fit.
    #[must_use]
    pub fn plot(&self) -> String {
        let ([first, last], [low, high]) = (self.ends(0), self.ends(1));
        let x = if self.axes.log_dose {
            Axis::log("dose", first, last)
        } else {
            Axis::linear("dose", first.min(0.0), last)
        };
        let y = if self.axes.log_response {
            Axis::log("response", low, high)
        } else {
            Axis::linear("response", low.min(0.0), 1.05 * high)
        };
        let mut plot = Plot::new(x, y);
        let back = |v: f64| {
            if self.axes.log_response {
                10f64.powf(v)
            } else {
                v
            }
        };
        let line: Vec<[f64; 2]> = self
            .sampled(200)
            .into_iter()
            .map(|d| [d, back(self.at(d))])
            .collect();
        plot.line(&line, "accent", "fit");
        plot.dots(&self.measured, "gel", "measured");
        plot.file("Response against dose")
    }
}

/// A number that was fitted: the digits beyond are noise.
fn six_digits(value: f64) -> f64 {
    concise(value).parse().unwrap_or(value)
}

/// The keys of a tabulated response.
fn table_of(doses: &[f64], responses: &[f64]) -> std::result::Result<String, toml::ser::Error> {
    let list = |values: &[f64]| values.iter().map(|value| six_digits(*value)).collect();
    toml::to_string(&table::Params {
        dose: list(doses),
        response: list(responses),
        file: None,
        beyond: Beyond::Flat,
    })
}

/// The points on other axes.
fn on_axes(measured: &[[f64; 2]], axes: Axes) -> Result<Curve> {
    for (column, key, log) in [
        (0, "dose", axes.log_dose),
        (1, "response", axes.log_response),
    ] {
        if let Some(pair) = measured.iter().find(|pair| log && pair[column] <= 0.0) {
            return Err(Error::config(
                key,
                format!("{} has no logarithm", concise(pair[column])),
                format!("numbers above 0 with --log-{key}, or no such option"),
            ));
        }
    }
    let map = |[dose, response]: &[f64; 2]| [axes.dose(*dose), axes.response(*response)];
    Curve::of_pairs(&measured.iter().map(map).collect::<Vec<_>>())
}
