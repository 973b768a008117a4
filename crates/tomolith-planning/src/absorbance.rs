//! Absorption and scattering of a resin from a spectrometer's absorbance, without and with scattering particles.
//!
//! **Equation** (A absorbance, L path through the resin, α albedo of the particles)
//!
//! ```text
//! A = A₀ + μ_t·L/ln 10              Beer and Lambert; A₀ = what the cuvette alone shows
//! μ_a = μ₁ + (1 − α)·(μ₂ − μ₁)      μ₁, μ₂: μ_t without and with particles
//! μ_s = α·(μ₂ − μ₁)
//! ```
//!
//! **Source** Nicolet et al. 2024, eqs. 22 and 23. Their eq. 23 multiplies 1 − α with μ₂ where eq. 22 gives μ₂ − μ₁; at α = 1, their case, both are the same.
//!
//! **Fit** least squares over all readings. With readings at two paths or more A₀ is fitted too, else it is 0: the spectrometer was zeroed with an
//! empty cuvette. **Limits** scattered light that still reaches the detector makes μ₂ too small.
//!
//! ```
//! use tomolith_planning::absorbance::{Attenuation, MediumFit};
//! let ten = std::f64::consts::LN_10;
//! let clear = Attenuation::fit("resin", &[[10.0, 1.3 / ten]]).unwrap(); // 0.13 per mm
//! let turbid = Attenuation::fit("with_particles", &[[5.0, 0.2 + 1.5 / ten], [10.0, 0.2 + 3.0 / ten]]).unwrap(); // 0.3 per mm
//! let medium = MediumFit::new(&clear, Some(&turbid), 0.9).unwrap();
//! assert!((medium.absorption.per_mm - (0.13 + 0.1 * 0.17)).abs() < 1e-12);
//! assert!((medium.scattering.unwrap().per_mm - 0.9 * 0.17).abs() < 1e-12);
//! assert!((turbid.cuvette.unwrap() - 0.2).abs() < 1e-9);
//! ```

use serde::Serialize;
use std::f64::consts::LN_10;
use tomolith_core::error::{Error, Result};
use tomolith_core::least_squares::minimize;
use tomolith_core::units::concise;
use tomolith_report::plot::{Axis, Plot};

/// A coefficient per length.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Coefficient {
    /// Napierian, 1/mm.
    pub per_mm: f64,
    /// Its standard error, where readings say one.
    pub error: Option<f64>,
}

/// What the readings of one liquid say.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Attenuation {
    /// μ_t.
    pub total: Coefficient,
    /// A₀, where there are several paths.
    pub cuvette: Option<f64>,
    /// Its standard error, where readings say one.
    pub cuvette_error: Option<f64>,
    /// Path in mm, absorbance.
    pub readings: Vec<[f64; 2]>,
}

impl Attenuation {
    /// Of pairs of path (mm) and absorbance; `column` names the absorbances in errors.
    ///
    /// # Errors
    /// [`Error::Config`] for no readings, a path that is not above 0, or readings that do not rise with the path.
    pub fn fit(column: &str, readings: &[[f64; 2]]) -> Result<Self> {
        let Some(&[first, _]) = readings.first() else {
            return Err(Error::config(
                column,
                "no readings",
                "an absorbance or more",
            ));
        };
        if let Some([path, _]) = readings.iter().find(|r| r[0] <= 0.0) {
            return Err(Error::refused("path_mm", path, "paths above 0 mm"));
        }
        let is_line = readings.iter().any(|r| (r[0] / first - 1.0).abs() > 1e-6);
        let start = vec![0.0; 1 + usize::from(is_line)];
        let found = minimize(&start, readings.len(), |theta, i, slopes| {
            let [path, absorbance] = readings[i];
            slopes.fill(1.0);
            slopes[0] = path / LN_10;
            theta[0] * slopes[0] + theta.get(1).unwrap_or(&0.0) - absorbance
        });
        let per_mm = found.parameters[0];
        if per_mm <= 0.0 {
            return Err(Error::config(
                column,
                format!("an attenuation of {} per mm", concise(per_mm)),
                "absorbances that rise with the path: decimal logarithms of what goes in over what comes out",
            ));
        }
        let errors = found.errors(0.0, readings.len());
        Ok(Attenuation {
            total: Coefficient {
                per_mm,
                error: errors.as_ref().map(|e| e[0]),
            },
            cuvette_error: errors.and_then(|e| e.get(1).copied()),
            cuvette: found.parameters.get(1).copied(),
            readings: readings.to_vec(),
        })
    }

    fn line(&self, longest: f64) -> [[f64; 2]; 2] {
        let at = |path: f64| {
            [
                path,
                self.cuvette.unwrap_or(0.0) + self.total.per_mm * path / LN_10,
            ]
        };
        [at(0.0), at(longest)]
    }
}

/// A resin as a job names it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MediumFit {
    /// μ_a.
    pub absorption: Coefficient,
    /// μ_s, of a resin with particles.
    pub scattering: Option<Coefficient>,
}

impl MediumFit {
    /// Eqs. 22 and 23: of a resin without and with particles of this albedo.
    ///
    /// # Errors
    /// [`Error::Config`] for an albedo outside 0 … 1, or particles that attenuate nothing.
    pub fn new(resin: &Attenuation, with: Option<&Attenuation>, albedo: f64) -> Result<Self> {
        if !(0.0..=1.0).contains(&albedo) {
            return Err(Error::refused("--albedo", albedo, "0 to 1"));
        }
        let clear = resin.total;
        let Some(turbid) = with.map(|w| w.total) else {
            return Ok(MediumFit {
                absorption: clear,
                scattering: None,
            });
        };
        let particles = turbid.per_mm - clear.per_mm;
        if particles <= 0.0 {
            return Err(Error::config(
                "with_particles",
                format!(
                    "an attenuation of {} per mm with particles, {} without",
                    concise(turbid.per_mm),
                    concise(clear.per_mm)
                ),
                "more attenuation with particles than without",
            ));
        }
        // Weights of the two independent measurements
        let error = |of_clear: f64, of_turbid: f64| {
            let parts = [(of_clear, clear.error), (of_turbid, turbid.error)];
            let known = parts.iter().filter(|(weight, _)| *weight != 0.0);
            known
                .map(|(weight, error)| error.map(|e| (weight * e).powi(2)))
                .sum::<Option<f64>>()
                .map(f64::sqrt)
        };
        Ok(MediumFit {
            absorption: Coefficient {
                per_mm: clear.per_mm + (1.0 - albedo) * particles,
                error: error(albedo, 1.0 - albedo),
            },
            scattering: Some(Coefficient {
                per_mm: albedo * particles,
                error: error(albedo, albedo),
            }),
        })
    }
}

/// Readings over the path, and the lines through them.
#[must_use]
pub fn plot(liquids: &[(&str, &Attenuation)]) -> String {
    let extent_of = |axis: usize| {
        let values = liquids.iter().flat_map(|(_, liquid)| &liquid.readings);
        1.1 * values.map(|r| r[axis]).fold(0.0, f64::max)
    };
    let (longest, highest) = (extent_of(0), extent_of(1));
    let mut plot = Plot::new(
        Axis::linear("path, mm", 0.0, longest),
        Axis::linear("absorbance", 0.0, highest),
    );
    for ((name, liquid), class) in liquids.iter().zip(["accent", "gel"]) {
        plot.line(&liquid.line(longest), class, name);
        plot.dots(&liquid.readings, class, "");
    }
    plot.file("Absorbance over the path")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// μ = ln 10·ΣLA/ΣL² through the origin, with s²·ln² 10/ΣL² as the square of its error.
    #[test]
    fn readings_of_one_path_have_the_error_of_their_mean() {
        let readings = [[10.0, 0.50], [10.0, 0.56], [10.0, 0.53]];
        let found = Attenuation::fit("resin", &readings).unwrap();
        assert!((found.total.per_mm - 0.053 * LN_10).abs() < 1e-12);
        let error = 0.003 / 3f64.sqrt() * LN_10; // 0.03 is the standard deviation of the three
        assert!((found.total.error.unwrap() - error).abs() < 1e-9);
        assert_eq!(found.cuvette, None);
        assert_eq!(
            Attenuation::fit("resin", &readings[..1])
                .unwrap()
                .total
                .error,
            None
        );
    }

    #[test]
    fn errors_add_as_those_of_two_independent_measurements() {
        let with_error = |per_mm, error| Attenuation {
            total: Coefficient { per_mm, error },
            cuvette: None,
            cuvette_error: None,
            readings: Vec::new(),
        };
        let (clear, turbid) = (with_error(0.1, Some(0.003)), with_error(0.3, Some(0.004)));
        let fit = |albedo| MediumFit::new(&clear, Some(&turbid), albedo).unwrap();
        let white = fit(1.0);
        assert_eq!(white.absorption, clear.total); // particles that only scatter change nothing of it
        assert!((white.scattering.unwrap().error.unwrap() - 0.005).abs() < 1e-12);
        let black = fit(0.0);
        assert!((black.absorption.per_mm - 0.3).abs() < 1e-12);
        assert!((black.absorption.error.unwrap() - 0.004).abs() < 1e-12);
        assert_eq!(black.scattering.unwrap().per_mm, 0.0);
        let unknown = MediumFit::new(&with_error(0.1, None), Some(&turbid), 1.0).unwrap();
        assert_eq!(unknown.scattering.unwrap().error, None);
    }
}
