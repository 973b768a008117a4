//! Gray curve of a machine from a power meter's table.
//!
//! **What it models** the irradiance of each gray value: a monotone cubic through the points ([`Table`]), or the line or quadratic of least squares
//! (Wang et al. 2022, Note 1). Where readings fall, the cubic goes through the nearest ones that never do ([`Curve::monotone`]). A curve is usable where it is
//! above 0 and rises.
//!
//! **Parameters** gray values 0 … `top`, irradiances in any unit. **Shape** [`GrayCurve::points`] are 256 pairs (value, irradiance), value = gray/top, for
//! `printer.gray_curve_file`. **Limits** white (`top`) must have been measured; below the lowest gray value the curve goes to 0 at gray 0.
//!
//! ```
//! use tomolith_planning::gray::{CurveForm, GrayCurve, Polynomial};
//! use tomolith_core::response::curve::Curve;
//! let table = Curve::new(&[0.0, 128.0, 255.0], &[0.1, 2.0, 9.0]).unwrap();
//! let curve = GrayCurve::new(&table, 255.0, CurveForm::Monotone).unwrap();
//! assert!((curve.at(128.0) - 2.0).abs() < 1e-6 && curve.at(60.0) < 2.0);
//! // 3x − x²/2 is 0 at 0, and falls above 3
//! let arch = Polynomial { coefficients: vec![0.0, 3.0, -0.5] };
//! assert_eq!(arch.usable(5.0), Some([0.0, 3.0]));
//! ```

use crate::measured::csv;
use serde::Serialize;
use tomolith_core::error::{Error, Result};
use tomolith_core::least_squares::minimize;
use tomolith_core::response::curve::Curve;
use tomolith_core::response::table::Beyond;
use tomolith_core::response::{Response, Table};
use tomolith_core::units::concise;
use tomolith_report::number::significant;
use tomolith_report::plot::{Axis, Plot};

/// What is laid through the points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum CurveForm {
    /// A monotone cubic through every point, or through the nearest points that never fall.
    #[default]
    Monotone,
    /// The line of least squares.
    Line,
    /// The quadratic of least squares.
    Quadratic,
}

/// c₀ + c₁x + c₂x², of degree 1 or 2.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Polynomial {
    /// c₀, c₁ and, for a quadratic, c₂.
    pub coefficients: Vec<f64>,
}

impl Polynomial {
    /// The one of a degree (1 or 2) with the least sum of squares.
    ///
    /// # Errors
    /// [`Error::Config`] for fewer points than coefficients.
    pub fn fit(table: &Curve, degree: usize) -> Result<Self> {
        let n = table.doses.len();
        if n <= degree {
            return Err(Error::config(
                "gray value",
                format!("found {n} gray values"),
                format!("at least {} for this form", degree + 1),
            ));
        }
        // Powers of numbers up to 1 keep the equations apart
        let scale = table.doses.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let scale = if scale > 0.0 { scale } else { 1.0 };
        let found = minimize(&vec![0.0; degree + 1], n, |c, i, slopes| {
            let x = table.doses[i] / scale;
            let mut power = 1.0;
            let mut value = 0.0;
            for (slope, c) in slopes.iter_mut().zip(c) {
                *slope = power;
                value += c * power;
                power *= x;
            }
            value - table.responses[i]
        });
        let unscaled = found.parameters.iter().enumerate();
        Ok(Polynomial {
            coefficients: unscaled.map(|(i, c)| c / scale.powi(i as i32)).collect(),
        })
    }

    /// Its value.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        self.coefficients
            .iter()
            .rev()
            .fold(0.0, |sum, c| sum * x + c)
    }

    /// Fit over measured, minus 1, of each point of a table.
    #[must_use]
    pub fn residuals(&self, table: &Curve) -> Vec<f64> {
        let pairs = table.doses.iter().zip(&table.responses);
        pairs.map(|(x, y)| self.at(*x) / y - 1.0).collect()
    }

    /// The part of [0, top] in which it is not below 0 and rises; None where there is none.
    #[must_use]
    pub fn usable(&self, top: f64) -> Option<[f64; 2]> {
        let c = |i: usize| self.coefficients.get(i).copied().unwrap_or(0.0);
        let (c0, c1, c2) = (c(0), c(1), c(2));
        let (mut low, mut high) = (0.0f64, top);
        if c2 == 0.0 {
            if c1 <= 0.0 {
                return None;
            }
            low = low.max(-c0 / c1);
        } else {
            let vertex = -c1 / (2.0 * c2);
            let square = c1 * c1 - 4.0 * c2 * c0;
            if c2 < 0.0 {
                high = high.min(vertex);
            } else {
                low = low.max(vertex);
            }
            if square > 0.0 {
                // Where it rises through 0
                low = low.max((-c1 + square.sqrt()) / (2.0 * c2));
            } else if c2 < 0.0 {
                return None;
            }
        }
        (low < high).then_some([low, high])
    }

    /// As text, highest power first.
    #[must_use]
    pub fn text(&self) -> String {
        let powers = ["", " x", " x²"];
        let largest = self.coefficients.iter().fold(0.0f64, |m, c| m.max(c.abs()));
        let terms = self.coefficients.iter().enumerate().rev();
        // What rounding leaves of a coefficient that is 0 is no number for people
        terms
            .filter(|(_, c)| c.abs() > 1e-15 * largest)
            .map(|(i, c)| format!("{}{}", concise(*c), powers[i]))
            .collect::<Vec<_>>()
            .join(" + ")
            .replace("+ -", "− ")
    }
}

/// The part of a measured table that is not negative and rises: the stretch with the largest rise.
fn usable_points(table: &Curve) -> Option<[f64; 2]> {
    let (x, y) = (&table.doses, &table.responses);
    let mut best: Option<(f64, [f64; 2])> = None;
    let mut first = 0;
    for i in 0..x.len() {
        if y[i] < 0.0 || (i > first && y[i] < y[i - 1]) {
            first = if y[i] < 0.0 { i + 1 } else { i };
        } else if i > first {
            let rise = y[i] - y[first];
            if rise > 0.0 && best.is_none_or(|(b, _)| rise > b) {
                best = Some((rise, [x[first], x[i]]));
            }
        }
    }
    best.map(|(_, range)| range)
}

enum Through {
    Points(Table),
    Polynomial(Polynomial),
}

/// The curve of a machine.
pub struct GrayCurve {
    top: f64,
    through: Through,
    /// What people should know, a sentence each.
    pub notes: Vec<String>,
}

impl GrayCurve {
    /// The curve through a table of gray values (0 … top) and irradiances.
    ///
    /// # Errors
    /// [`Error::Config`] (key `gray value` or `irradiance`) when the table is negative or falls by more than a twentieth of white, when the form is negative or falls between 0 and
    /// top, with the range that is usable; when white was not measured.
    pub fn new(table: &Curve, top: f64, form: CurveForm) -> Result<Self> {
        // A machine's table has single precision, and sums of squares need some room
        let is_held = |v: &&f64| **v == 0.0 || (**v as f32).is_normal();
        if let Some(value) = table.responses.iter().find(|v| !is_held(v)) {
            return Err(Error::refused(
                "irradiance",
                concise(*value),
                "0, and numbers from 1.2e-38 to 3.4e38",
            ));
        }
        let (first, last) = (table.doses[0], table.doses[table.doses.len() - 1]);
        let level = table.monotone();
        // Irradiances of gray values that cannot be say nothing
        if first >= 0.0 {
            check_points(table, &level)?;
        }
        if first < 0.0 || last != top {
            return Err(Error::config(
                "gray value",
                format!("gray values from {} to {}", concise(first), concise(last)),
                format!(
                    "gray values from 0 or more to white, which is {} (--top says another)",
                    concise(top)
                ),
            ));
        }
        let mut notes = Vec::new();
        let through = match form {
            CurveForm::Monotone => {
                if first > 0.0 {
                    notes.push(format!(
                        "below gray {} nothing was measured: the curve goes to 0 at gray 0",
                        concise(first)
                    ));
                }
                notes.extend(falls(table, &level));
                Through::Points(points(&level)?)
            }
            CurveForm::Line => Through::Polynomial(Polynomial::fit(table, 1)?),
            CurveForm::Quadratic => Through::Polynomial(Polynomial::fit(table, 2)?),
        };
        if let Through::Polynomial(polynomial) = &through {
            let usable = polynomial.usable(top);
            match usable {
                Some([low, high]) if high == top => {
                    if low > 0.0 {
                        notes.push(format!(
                            "below gray {low:.2} the fit is negative or does not rise, and is taken as even"
                        ));
                    }
                }
                _ => {
                    return Err(unusable(
                        &format!("the fit {}", polynomial.text()),
                        usable,
                        &format!("{RISING}; the form `monotone` follows every table that does"),
                    ));
                }
            }
        }
        Ok(GrayCurve {
            top,
            through,
            notes,
        })
    }

    /// Irradiance of a gray value.
    #[must_use]
    pub fn at(&self, gray: f64) -> f64 {
        match &self.through {
            Through::Points(table) => f64::from(table.value(gray as f32)),
            Through::Polynomial(polynomial) => polynomial.at(gray).max(0.0),
        }
    }

    /// Pairs (value, irradiance) for a `[printer]`: 256 values from 0 to 1, less those at which nothing rises.
    #[must_use]
    pub fn points(&self) -> Vec<[f64; 2]> {
        let mut points: Vec<[f64; 2]> = Vec::new();
        for i in 0..=255 {
            let value = f64::from(i) / 255.0;
            let irradiance = self.at(value * self.top);
            if points.last().is_none_or(|last| irradiance > last[1]) {
                points.push([value, irradiance]);
            }
        }
        if let Some(last) = points.last_mut() {
            last[0] = 1.0;
        }
        points
    }

    /// The file for `printer.gray_curve_file`.
    #[must_use]
    pub fn file(&self, unit: &str) -> String {
        let rows: Vec<Vec<f64>> = self.points().iter().map(|p| p.to_vec()).collect();
        csv(&["# value", unit], &rows)
    }

    /// The curve, its points and the fits of least squares.
    #[must_use]
    pub fn plot(&self, table: &Curve, fits: &[(&str, &Polynomial)]) -> String {
        let most = table.responses.iter().copied().fold(0.0, f64::max);
        let mut plot = Plot::new(
            Axis::linear("gray value", 0.0, self.top),
            Axis::linear("irradiance, mW/cm²", 0.0, 1.05 * most),
        );
        let sampled = |f: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            let at = |i: i32| f64::from(i) / 255.0 * self.top;
            (0..=255).map(|i| [at(i), f(at(i))]).collect()
        };
        for (i, (name, polynomial)) in fits.iter().enumerate() {
            let line: Vec<[f64; 2]> = sampled(&|x| polynomial.at(x));
            let line: Vec<[f64; 2]> = line.into_iter().filter(|p| p[1] >= 0.0).collect();
            plot.line(&line, ["still", "void"][i % 2], name);
        }
        plot.line(&sampled(&|x| self.at(x)), "accent", "curve");
        let measured: Vec<[f64; 2]> = pairs(table);
        plot.dots(&measured, "gel", "measured");
        plot.file("Irradiance against gray value")
    }
}

fn pairs(table: &Curve) -> Vec<[f64; 2]> {
    let pairs = table.doses.iter().zip(&table.responses);
    pairs.map(|(x, y)| [*x, *y]).collect()
}

fn points(table: &Curve) -> Result<Table> {
    let mut all = pairs(table);
    if all[0][0] > 0.0 {
        all.insert(0, [0.0; 2]);
    }
    let column = |c: usize| -> Vec<f64> { all.iter().map(|p| p[c]).collect() };
    Table::new(&column(0), &column(1), Beyond::Flat)
}

/// Largest fall from one reading to the next that may be noise, as a part of white.
const NOISE: f64 = 0.05;

/// Where readings fall most from one gray value to the next: the second of both, and by which part of white; None where they never do.
fn worst_fall(table: &Curve, level: &Curve) -> Option<(usize, f64)> {
    let y = &table.responses;
    let white = level.responses[y.len() - 1];
    let falls = (1..y.len()).map(|i| (i, (y[i - 1] - y[i]) / white));
    falls
        .filter(|(_, fall)| *fall > 0.0)
        .max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Refuses a table that is negative, that falls by more than noise, or that does not rise.
fn check_points(table: &Curve, level: &Curve) -> Result<()> {
    let (x, y) = (&table.doses, &table.responses);
    let worst = worst_fall(table, level).filter(|(_, fall)| *fall > NOISE);
    let found = if let Some(i) = y.iter().position(|v| *v < 0.0) {
        format!(
            "a negative irradiance, {} at gray {}",
            concise(y[i]),
            concise(x[i])
        )
    } else if y.iter().all(|v| *v == y[0]) {
        "the same irradiance everywhere".to_owned()
    } else if let Some((i, _)) = worst {
        format!(
            "the irradiance falls from {} to {} between gray {} and {}",
            concise(y[i - 1]),
            concise(y[i]),
            concise(x[i - 1]),
            concise(x[i])
        )
    } else {
        return Ok(());
    };
    Err(unusable(&found, usable_points(table), RISING))
}

/// Where readings fall from one gray value to the next, and by how much; None where they never do.
fn falls(table: &Curve, level: &Curve) -> Option<String> {
    let (x, y) = (&table.doses, &table.responses);
    let (worst, share) = worst_fall(table, level)?;
    let most = match (1..y.len()).filter(|&i| y[i] < y[i - 1]).count() {
        1 => String::new(),
        count => format!(", the largest of {count} falls"),
    };
    Some(format!(
        "the irradiance falls from {} to {} between gray {} and {}, by {} % of white{most}: the curve goes through the nearest irradiances that never fall; \
         measure there again if that is more than your meter's noise",
        concise(y[worst - 1]),
        concise(y[worst]),
        concise(x[worst - 1]),
        concise(x[worst]),
        significant(100.0 * share, 2)
    ))
}

/// What a table must be.
const RISING: &str = "irradiances that are not negative and rise with the gray value";

fn unusable(what: &str, usable: Option<[f64; 2]>, accepted: &str) -> Error {
    let range = match usable {
        Some([low, high]) => format!("it is usable from gray {low:.2} to {high:.2}"),
        None => "no range of it is usable".to_owned(),
    };
    Error::config(
        "irradiance",
        format!("{what}: not a rising curve from black to white; {range}"),
        accepted,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Dark readings of a projector with gamma 2.2, off by up to 0.5 mW/cm².
    #[test]
    fn a_noisy_reading_is_warned_of_and_leaves_the_table_usable() {
        let gray = [0.0, 17.0, 34.0, 51.0, 68.0, 153.0, 255.0];
        let table = Curve::new(&gray, &[0.0, 0.67, 0.99, 0.45, 2.26, 13.0, 40.0]).unwrap();
        let curve = GrayCurve::new(&table, 255.0, CurveForm::Monotone).unwrap();
        assert!((curve.at(34.0) - 0.72).abs() < 1e-6 && (curve.at(17.0) - 0.67).abs() < 1e-6);
        let [note] = &curve.notes[..] else {
            panic!("{:?}", curve.notes);
        };
        let place = "falls from 0.99 to 0.45 between gray 34 and 51, by 1.4 % of white: ";
        assert!(note.contains(place), "{note}");
        // What must rise of a polynomial is the fit
        for form in [CurveForm::Line, CurveForm::Quadratic] {
            assert!(GrayCurve::new(&table, 255.0, form).is_ok(), "{form:?}");
        }
    }
}
