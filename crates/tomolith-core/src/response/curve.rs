//! Measured curves: two columns, dose and response.
//!
//! A text file with a pair of numbers per line, separated by a comma, semicolon, tab or blanks; a first line of words is a
//! header, `#` begins a comment. Rows are sorted by dose; equal doses are averaged.
//!
//! ```
//! use tomolith_core::response::curve::Curve;
//! let curve = Curve::parse("dose;conversion\n0.2; 0.25\n0; 0 # dark\n0.4; 0.125").unwrap();
//! assert_eq!(curve.doses, [0.0, 0.2, 0.4]);
//! // 0.25 and 0.125 fall with dose: the nearest curve that does not has their mean
//! assert_eq!(curve.monotone().responses, [0.0, 0.1875, 0.1875]);
//! ```

use crate::error::{Error, Result};
use crate::files::read_text;
use crate::units::{counted, exact};
use std::path::Path;

/// Points of a measured response, by ascending dose, no dose twice.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Doses, in the units of the job.
    pub doses: Vec<f64>,
    /// What the material did.
    pub responses: Vec<f64>,
    /// How many measurements each point is the mean of.
    pub(super) counts: Vec<f64>,
    /// Sum of squares of all measurements about the mean of their dose.
    pub(super) scatter: f64,
}

impl Curve {
    /// Points in any order.
    ///
    /// # Errors
    /// [`Error::Config`] (key `dose` or `response`) for lists of different length, fewer than two doses, or numbers that
    /// are not finite.
    pub fn new(doses: &[f64], responses: &[f64]) -> Result<Self> {
        if doses.len() != responses.len() {
            return Err(Error::config(
                "response",
                format!("{} responses for {} doses", responses.len(), doses.len()),
                "lists of equal length",
            ));
        }
        for (key, list) in [("dose", doses), ("response", responses)] {
            if let Some(i) = list.iter().position(|v| !v.is_finite()) {
                return Err(Error::refused(
                    format!("{key}[{i}]"),
                    exact(list[i]),
                    "a finite number",
                ));
            }
        }
        let mut rows: Vec<(f64, f64)> = doses
            .iter()
            .copied()
            .zip(responses.iter().copied())
            .collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut curve = Curve {
            doses: Vec::new(),
            responses: Vec::new(),
            counts: Vec::new(),
            scatter: 0.0,
        };
        for rows in rows.chunk_by(|a, b| a.0 == b.0) {
            curve.doses.push(rows[0].0);
            let mean = rows.iter().map(|r| r.1).sum::<f64>() / rows.len() as f64;
            curve.responses.push(mean);
            curve.counts.push(rows.len() as f64);
            curve.scatter += rows.iter().map(|r| (r.1 - mean).powi(2)).sum::<f64>();
        }
        if curve.doses.len() < 2 {
            return Err(Error::refused(
                "dose",
                counted(curve.doses.len(), "different dose"),
                "at least two",
            ));
        }
        Ok(curve)
    }

    /// The points of a text.
    ///
    /// # Errors
    /// [`Error::Config`] naming the line.
    pub fn parse(text: &str) -> Result<Self> {
        let (mut doses, mut responses) = (Vec::new(), Vec::new());
        let mut is_first = true;
        for (i, line) in text.lines().enumerate() {
            let line = line
                .split('#')
                .next()
                .unwrap_or_default()
                .trim()
                .trim_start_matches('\u{feff}');
            if line.is_empty() {
                continue;
            }
            let separators = |c: char| c == ',' || c == ';' || c.is_whitespace();
            let cells: Vec<&str> = line
                .split(separators)
                .filter(|cell| !cell.is_empty())
                .collect();
            let numbers: Vec<f64> = cells.iter().filter_map(|cell| cell.parse().ok()).collect();
            match numbers[..] {
                [dose, response] if cells.len() == 2 => {
                    doses.push(dose);
                    responses.push(response);
                }
                [] if is_first => {}
                _ => {
                    return Err(Error::config(
                        format!("line {}", i + 1),
                        format!("found {line:?}"),
                        "two numbers, dose and response",
                    ));
                }
            }
            is_first = false;
        }
        Curve::new(&doses, &responses)
    }

    /// The points of a file.
    ///
    /// # Errors
    /// [`Error::Io`], and [`Error::Format`] naming the line.
    pub fn read(path: &Path) -> Result<Self> {
        let text = read_text(path)?;
        Curve::parse(&text).map_err(|e| match e {
            Error::Config {
                key,
                found,
                accepted,
                ..
            } => Error::format(path, format!("{key}: {found}"), accepted),
            other => other,
        })
    }

    /// The curve nearest to this one, in least squares, that never falls (pool adjacent violators: de Leeuw, Hornik and
    /// Mair, J. Stat. Softw. 32 (2009) 5).
    #[must_use]
    pub fn monotone(&self) -> Self {
        // Sum, weight and length of each pool
        let mut pools: Vec<(f64, f64, usize)> = Vec::new();
        for (&response, &count) in self.responses.iter().zip(&self.counts) {
            let mut pool = (response * count, count, 1);
            while let Some(&(sum, weight, len)) = pools.last() {
                if sum / weight <= pool.0 / pool.1 {
                    break;
                }
                pool = (pool.0 + sum, pool.1 + weight, pool.2 + len);
                pools.pop();
            }
            pools.push(pool);
        }
        let level =
            |&(sum, weight, len): &(f64, f64, usize)| std::iter::repeat_n(sum / weight, len);
        Curve {
            responses: pools.iter().flat_map(level).collect(),
            ..self.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_hold_no_pair_are_named() {
        for (text, wrong) in [
            ("0,0\n1,a", "line 2"),
            ("0 0\n\n1 2 3", "line 3"),
            ("0,0", "dose"),
            ("a,b\nc,d", "line 2"),
            ("0,0\n1,nan", "response[1]"),
        ] {
            let Err(Error::Config { key, .. }) = Curve::parse(text) else {
                panic!("{text:?} was accepted")
            };
            assert_eq!(key, wrong, "{text:?}");
        }
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("curve.csv");
        std::fs::write(&file, "dose,response\n0,0\nx").unwrap();
        let text = Curve::read(&file).unwrap_err().to_string();
        crate::contains!(text, "curve.csv", "line 3");
    }

    #[test]
    fn the_monotone_curve_is_the_nearest_of_all() {
        let doses: Vec<f64> = (0..6).map(f64::from).collect();
        let responses = [0.0, 0.4, 0.2, 0.6, 0.5, 1.0];
        let found = Curve::new(&doses, &responses).unwrap().monotone().responses;
        let expected = [0.0, 0.3, 0.3, 0.55, 0.55, 1.0];
        assert!(
            found
                .iter()
                .zip(expected)
                .all(|(a, b)| (a - b).abs() < 1e-12),
            "{found:?}"
        );
        // Equal doses are one point that counts twice: (0.4·2 + 0.1)/3
        let curve = Curve::new(&[0.0, 1.0, 1.0, 2.0], &[0.0, 0.3, 0.5, 0.1]).unwrap();
        let found = curve.monotone().responses;
        assert!(
            found[0] == 0.0 && found[1..].iter().all(|v| (v - 0.3).abs() < 1e-12),
            "{found:?}"
        );
    }
}
