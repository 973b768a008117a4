//! Measured curves: two columns, dose and response.
//!
//! A file is a table of [two columns](read_pairs). Rows are sorted by dose; equal doses are averaged.
//!
//! ```
//! use tomolith_core::response::curve::Curve;
//! let curve = Curve::of_pairs(&[[0.2, 0.25], [0.0, 0.0], [0.4, 0.125]]).unwrap();
//! assert_eq!(curve.doses, [0.0, 0.2, 0.4]);
//! // 0.25 and 0.125 fall with dose: the nearest curve that does not has their mean
//! assert_eq!(curve.monotone().responses, [0.0, 0.1875, 0.1875]);
//! ```

use crate::columns::read_pairs;
use crate::error::{Error, Result, in_range};
use crate::units::counted;
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
                in_range(false, format!("{key}[{i}]"), list[i], "a finite number")?;
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
                counted(curve.doses.len(), "different number"),
                "at least two different ones",
            ));
        }
        Ok(curve)
    }

    /// Pairs of dose and response in any order.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of_pairs(pairs: &[[f64; 2]]) -> Result<Self> {
        let column = |c: usize| -> Vec<f64> { pairs.iter().map(|pair| pair[c]).collect() };
        Curve::new(&column(0), &column(1))
    }

    /// The points of a file with two columns.
    ///
    /// # Errors
    /// As [`read_pairs`]; [`Error::Format`] for what [`new`](Self::new) refuses.
    pub fn read(path: &Path) -> Result<Self> {
        let pairs = read_pairs(path, "dose and response")?;
        Curve::of_pairs(&pairs).map_err(|e| match e {
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
