//! Tabulated response: a monotone cubic through measured points.
//!
//! **Equation** between two doses the cubic of [`monotone_cubic`](crate::monotone_cubic): value and slope are continuous, and
//! the curve rises wherever the table does. Beyond the table it goes on with the slope of its end (`beyond = "linear"`) or
//! stays where it is (`"flat"`, as in Li et al., supplement S.6; its gradient there is 0, and an optimizer gets no hint).
//!
//! **Source** Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300.
//!
//! **Parameters** see [`Params`]. Doses ascend, responses never fall; a measured table that is noisy goes through
//! [`fit`](super::fit). **Limits** the inverse of a flat stretch is its lowest dose. **Cost** a search in the table and a
//! cubic, about 10 ns per voxel.
//!
//! ```
//! use tomolith_core::response::{Response, Table, table::Beyond};
//! let table = Table::new(&[0.0, 0.5, 1.0], &[0.0, 0.2, 1.0], Beyond::Linear).unwrap();
//! assert_eq!(table.value(0.5), 0.2);
//! // secants 0.4 and 1.6, harmonic mean 0.64
//! assert!((table.value_and_slope(0.5).1 - 0.64).abs() < 1e-6);
//! assert!((table.inverse(0.2) - 0.5).abs() < 1e-6);
//! ```

use super::curve::Curve;
use super::{BuildResponse, Response, ResponseForm};
use crate::error::{Error, Result};
use crate::kind::{Kind, Section};
use crate::monotone_cubic::{coefficients, slopes, value_and_slope};
use crate::units::exact;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// What a tabulated response does beyond its table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Beyond {
    /// It goes on with the slope of its end.
    #[default]
    Linear,
    /// It stays where it is.
    Flat,
}

/// The parameters of a tabulated response.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Doses, ascending, at least two
    pub dose: Vec<f64>,
    /// Responses to them, never falling
    pub response: Vec<f64>,
    /// A file with two columns, dose and response, in place of the lists; relative to the job file
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<PathBuf>,
    /// Beyond the table: "linear" (default) or "flat"
    pub beyond: Beyond,
}

/// A monotone cubic through a table.
#[derive(Clone, Debug)]
pub struct Table {
    doses: Vec<f64>,
    responses: Vec<f64>,
    slopes: Vec<f64>,
    beyond: Beyond,
    /// Per interval, the cubic in dose minus its begin; first the begin.
    pieces: Vec<[f32; 5]>,
    /// Ends of all intervals but the last.
    ends: Vec<f32>,
}

impl Table {
    /// The curve through these points.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of the first dose that is not above the one before, or response that is below it.
    pub fn new(doses: &[f64], responses: &[f64], beyond: Beyond) -> Result<Self> {
        Curve::new(doses, responses)?;
        if let Some(i) = (1..doses.len()).find(|&i| doses[i] <= doses[i - 1]) {
            return Err(Error::config(
                format!("dose[{i}]"),
                format!("found {} after {}", exact(doses[i]), exact(doses[i - 1])),
                "doses in ascending order, none twice",
            ));
        }
        if let Some(i) = (1..doses.len()).find(|&i| responses[i] < responses[i - 1]) {
            return Err(Error::config(
                format!("response[{i}]"),
                format!(
                    "found {} after {}: the response falls with dose",
                    responses[i],
                    responses[i - 1]
                ),
                "a response that never falls; for noisy points use response.fit",
            ));
        }
        if responses[0] == responses[responses.len() - 1] {
            return Err(Error::config(
                "response",
                format!("found {} everywhere", exact(responses[0])),
                "a response that rises somewhere",
            ));
        }
        let slopes = slopes(doses, responses);
        Ok(Table {
            pieces: pieces(doses, responses, &slopes),
            ends: doses[1..doses.len() - 1]
                .iter()
                .map(|&d| narrow(d))
                .collect(),
            doses: doses.to_vec(),
            responses: responses.to_vec(),
            slopes,
            beyond,
        })
    }

    /// Per interval its first dose and the four coefficients of its cubic in the dose minus that, the constant first.
    #[must_use]
    pub fn pieces(&self) -> &[[f32; 5]] {
        &self.pieces
    }

    /// Dose, response and slope of the line that goes on before the first point, and beyond the last.
    #[must_use]
    pub fn lines(&self) -> [[f32; 3]; 2] {
        [0, self.last()].map(|end| self.line(end))
    }

    fn line(&self, end: usize) -> [f32; 3] {
        let slope = match self.beyond {
            Beyond::Linear => narrow(self.slopes[end]),
            Beyond::Flat => 0.0,
        };
        [narrow(self.doses[end]), narrow(self.responses[end]), slope]
    }

    fn last(&self) -> usize {
        self.doses.len() - 1
    }

    /// Response and slope beyond an end.
    fn past(&self, end: usize, dose: f32) -> (f32, f32) {
        let [begin, response, slope] = self.line(end);
        let value = response + slope * (dose - begin);
        (value.clamp(f32::MIN, f32::MAX), slope)
    }

    /// The place in an interval where the cubic has a value: bisection, refined by Newton's steps.
    fn solve(&self, k: usize, wanted: f64) -> f64 {
        let h = self.doses[k + 1] - self.doses[k];
        let at = |t: f64| {
            value_and_slope(
                h,
                [self.responses[k], self.responses[k + 1]],
                [self.slopes[k], self.slopes[k + 1]],
                t,
            )
        };
        let (mut low, mut high) = (0.0f64, h);
        let mut t = 0.5 * h;
        for _ in 0..60 {
            let (value, slope) = at(t);
            if value < wanted {
                low = t;
            } else {
                high = t;
            }
            let newton = t - (value - wanted) / slope;
            t = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
        }
        self.doses[k] + t
    }
}

#[expect(clippy::cast_possible_truncation, reason = "kernels work in f32")]
fn narrow(value: f64) -> f32 {
    value as f32
}

fn pieces(x: &[f64], y: &[f64], s: &[f64]) -> Vec<[f32; 5]> {
    (0..x.len() - 1)
        .map(|k| {
            let c = coefficients(x[k + 1] - x[k], [y[k], y[k + 1]], [s[k], s[k + 1]]).map(narrow);
            [narrow(x[k]), c[0], c[1], c[2], c[3]]
        })
        .collect()
}

impl Response for Table {
    fn value(&self, dose: f32) -> f32 {
        self.value_and_slope(dose).0
    }

    fn value_and_slope(&self, dose: f32) -> (f32, f32) {
        if dose < narrow(self.doses[0]) {
            return self.past(0, dose);
        }
        if dose > narrow(self.doses[self.last()]) {
            return self.past(self.last(), dose);
        }
        let [begin, c0, c1, c2, c3] = self.pieces[self.ends.partition_point(|&end| end <= dose)];
        let t = dose - begin;
        (
            ((c3 * t + c2) * t + c1) * t + c0,
            (3.0 * c3 * t + 2.0 * c2) * t + c1,
        )
    }

    fn inverse(&self, response: f32) -> f32 {
        let wanted = f64::from(response);
        let last = self.last();
        let past = |end: usize| {
            let slope = self.slopes[end];
            let beyond = if self.beyond == Beyond::Linear && slope > 0.0 {
                (wanted - self.responses[end]) / slope
            } else {
                0.0
            };
            narrow(self.doses[end] + beyond).clamp(f32::MIN, f32::MAX)
        };
        // In the precision of the question, so that a flat stretch has its lowest dose
        if response <= narrow(self.responses[0]) {
            return past(0);
        }
        if response > narrow(self.responses[last]) {
            return past(last);
        }
        let k = self.responses.partition_point(|&y| narrow(y) < response) - 1;
        narrow(self.solve(k, wanted))
    }

    fn form(&self) -> ResponseForm<'_> {
        ResponseForm::Table(self)
    }

    fn range(&self) -> [f64; 2] {
        let rises = |end: usize| self.beyond == Beyond::Linear && self.slopes[end] > 0.0;
        let last = self.last();
        [
            if rises(0) {
                f64::NEG_INFINITY
            } else {
                self.responses[0]
            },
            if rises(last) {
                f64::INFINITY
            } else {
                self.responses[last]
            },
        ]
    }
}

/// The file that a section names, read; errors name the key.
pub(super) fn read(section: &Section, file: &std::path::Path) -> Result<Curve> {
    Curve::read(&section.file(file)).map_err(|e| e.of_file("file"))
}

/// The row of the table.
pub const KIND: Kind<BuildResponse> = Kind {
    name: "table",
    summary: "measured response: a monotone cubic through points of dose and response",
    example: "[response.table]\ndose = [0.0, 0.3, 0.5, 0.7, 1.0]\nresponse = [0.0, 0.05, 0.5, 0.95, 1.0]",
    schema: crate::kind::schema_of::<Params>,
    build: |section| {
        let params: Params = section.parse()?;
        let table = match &params.file {
            None => Table::new(&params.dose, &params.response, params.beyond),
            Some(_) if !params.dose.is_empty() || !params.response.is_empty() => Err(
                Error::config("file", "both a file and lists", "one of the two"),
            ),
            Some(file) => {
                read(section, file).and_then(|c| Table::new(&c.doses, &c.responses, params.beyond))
            }
        };
        Ok(Box::new(table.map_err(|e| e.under(&section.path))?))
    },
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::refuses;
    use crate::near;
    use serde_json::json;

    #[test]
    fn a_line_stays_a_line() {
        let table = Table::new(
            &[0.0, 0.1, 0.5, 0.6, 2.0],
            &[1.0, 1.2, 2.0, 2.2, 5.0],
            Beyond::Linear,
        )
        .unwrap();
        for i in -10..50 {
            let dose = i as f32 * 0.07;
            let (value, slope) = table.value_and_slope(dose);
            assert!(
                (value - (1.0 + 2.0 * dose)).abs() < 1e-5 && (slope - 2.0).abs() < 1e-5,
                "{dose}: {value} {slope}"
            );
        }
        assert_eq!(table.range(), [f64::NEG_INFINITY, f64::INFINITY]);
    }

    /// A dense table of the logistic response is the logistic response: value, slope and inverse.
    #[test]
    fn a_table_of_a_known_curve_is_that_curve() {
        let known = super::super::Logistic::new(Default::default()).unwrap();
        let doses: Vec<f64> = (0..=200).map(|i| f64::from(i) * 0.005).collect();
        let exact = |d: f64| 1.0 / (1.0 + (-10.0 * (d - 0.5)).exp());
        let responses: Vec<f64> = doses.iter().map(|&d| exact(d)).collect();
        let table = Table::new(&doses, &responses, Beyond::Flat).unwrap();
        for i in 1..400 {
            let dose = i as f32 * 0.0025;
            let ((value, slope), (expected, rise)) =
                (table.value_and_slope(dose), known.value_and_slope(dose));
            near!(value, expected, 2e-6, "{dose}");
            assert!((slope - rise).abs() < 5e-3, "{dose}: {slope} {rise}");
            near!(table.inverse(expected), known.inverse(expected), 1e-5);
        }
        assert_eq!(table.value_and_slope(7.0), (exact(1.0) as f32, 0.0));
        assert_eq!(table.inverse(2.0), 1.0);
    }

    #[test]
    fn between_points_it_never_falls_and_flat_stretches_are_flat() {
        let table = Table::new(
            &[0.0, 0.2, 0.4, 0.5, 1.0],
            &[0.0, 0.1, 0.1, 0.9, 1.0],
            Beyond::Flat,
        )
        .unwrap();
        let values: Vec<f32> = (0..=1000).map(|i| table.value(i as f32 * 1e-3)).collect();
        assert!(values.windows(2).all(|w| w[1] >= w[0] - 1e-6));
        assert!(values[200..=400].iter().all(|v| (v - 0.1).abs() < 1e-6));
        near!(table.inverse(0.1), 0.2, 1e-6);
    }

    #[test]
    fn a_table_that_falls_is_refused_with_its_key() {
        let build = |json| (KIND.build)(&Section::new("response.table", json));
        let falls = json!({"dose": [0, 1, 2], "response": [0.0, 0.5, 0.4]});
        let text = build(falls).unwrap_err().to_string();
        let expected =
            "response.table.response[2]: found 0.4 after 0.5: the response falls with dose;";
        assert!(text.starts_with(expected), "{text}");
        for (json, key) in [
            (json!({"dose": [0, 2, 1], "response": [0, 1, 2]}), "dose[2]"),
            (json!({"dose": [0, 1], "response": [1, 1]}), "response"),
            (json!({"dose": [0, 1], "response": [1]}), "response"),
            (json!({}), "dose"),
            (json!({"file": "nowhere.csv"}), "file"),
        ] {
            refuses(build(json), &format!("response.table.{key}"));
        }
    }

    #[test]
    fn a_file_is_found_beside_the_job() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("m.csv"), "0,0\n1,2\n").unwrap();
        let section = Section::new("response.table", json!({"file": "m.csv"})).based(folder.path());
        assert_eq!((KIND.build)(&section).unwrap().value(0.25), 0.5);
    }
}
