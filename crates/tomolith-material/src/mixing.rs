//! The mixing matrix: which light drives which network, and how strongly.
//!
//! **Equation** r_s = Σ_λ M_sλ q_λ, with q the absorbed power of a light (mW/mm³). Dual cure: acrylate (M_aV, M_aU), epoxy (0, M_eU). A negative entry
//! is an antagonist, as of 365 nm on a resin that 405 nm cures: (α, −1).
//!
//! ```
//! use tomolith_material::mixing::Mixing;
//! let dual = Mixing::new(vec![vec![1.0, 0.2], vec![0.0, 1.0]]).unwrap();
//! assert_eq!((dual.species(), dual.lights()), (2, 2));
//! let dark = Mixing::new(vec![vec![1.0, 0.0], vec![0.5, 0.0]]).unwrap_err();
//! assert!(dark.to_string().starts_with("mixing: light 1 drives nothing"));
//! ```

use tomolith_core::error::{Error, Result};
use tomolith_core::units::exact;

/// See the [module page](self).
#[derive(Clone, Debug, PartialEq)]
pub struct Mixing {
    rows: Vec<Vec<f32>>,
}

impl Mixing {
    /// One network per row, one light per column.
    ///
    /// # Errors
    /// [`Error::Config`] (key `mixing…`) for no rows, rows of different length, numbers that are not finite, a network that no light drives
    /// forward, or a light that drives nothing.
    pub fn new(rows: Vec<Vec<f64>>) -> Result<Self> {
        let lights = rows.first().map_or(0, Vec::len);
        if lights == 0 {
            return Err(Error::config(
                "mixing",
                "an empty matrix",
                "one row per network, one number per light in each",
            ));
        }
        for (s, row) in rows.iter().enumerate() {
            let refuse = |found: String, accepted: String| {
                Err(Error::config(format!("mixing[{s}]"), found, accepted))
            };
            if row.len() != lights {
                return refuse(
                    format!("{} numbers", row.len()),
                    format!("{lights}, as many as in the first row"),
                );
            }
            if let Some(bad) = row.iter().find(|v| v.is_nan() || v.abs() > 1e9) {
                return refuse(
                    format!("found {}", exact(*bad)),
                    "finite numbers up to 1e9".to_owned(),
                );
            }
            if !row.iter().any(|&v| v > 0.0) {
                return refuse(
                    "no number is above 0, so that no light cures it".to_owned(),
                    "at least one number above 0".to_owned(),
                );
            }
        }
        if let Some(light) = (0..lights).find(|&l| rows.iter().all(|row| row[l] == 0.0)) {
            return Err(Error::config(
                "mixing",
                format!("light {light} drives nothing: its column is 0"),
                "a number other than 0 in every column",
            ));
        }
        let row = |row: Vec<f64>| row.into_iter().map(|v| v as f32).collect();
        Ok(Mixing {
            rows: rows.into_iter().map(row).collect(),
        })
    }

    /// As many networks as lights, each driven by its own.
    #[must_use]
    pub fn identity(lights: usize) -> Self {
        let row = |s: usize| (0..lights).map(|l| f32::from(u8::from(l == s))).collect();
        Mixing {
            rows: (0..lights).map(row).collect(),
        }
    }

    /// Number of networks.
    #[must_use]
    pub fn species(&self) -> usize {
        self.rows.len()
    }

    /// Number of lights.
    #[must_use]
    pub fn lights(&self) -> usize {
        self.rows[0].len()
    }

    /// What each light is worth to a network.
    #[must_use]
    pub fn row(&self, species: usize) -> &[f32] {
        &self.rows[species]
    }

    /// The light that alone drives a network, and with the weight 1.
    #[must_use]
    pub fn only(&self, species: usize) -> Option<usize> {
        let row = self.row(species);
        let light = row.iter().position(|&m| m == 1.0)?;
        let alone = row.iter().enumerate().all(|(l, &m)| l == light || m == 0.0);
        alone.then_some(light)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::refused;

    #[test]
    fn antagonists_are_fine_and_what_cannot_cure_is_not() {
        let m = Mixing::new(vec![vec![2.0, -1.0]]).unwrap();
        assert_eq!((m.row(0), m.only(0)), ([2.0, -1.0].as_slice(), None));
        assert_eq!(Mixing::identity(3).only(2), Some(2));
        for (rows, key) in [
            (vec![], "mixing"),
            (vec![vec![1.0], vec![1.0, 2.0]], "mixing[1]"),
            (vec![vec![f64::NAN]], "mixing[0]"),
            (vec![vec![-1.0, 0.0]], "mixing[0]"),
            (vec![vec![1.0, 0.0], vec![0.5, 0.0]], "mixing"),
        ] {
            assert_eq!(refused(Mixing::new(rows))[0], key);
        }
    }
}
