//! The resin: what it does to light.
//!
//! Active absorption μ_a (what makes dose), total attenuation μ_t ≥ μ_a (what weakens the beam) and scattering are three
//! numbers, Napierian, per mm: a beam falls by e^(−μ_t·L) over a length L.

use super::gradient::IndexGradient;

/// What resin takes of light that passes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uptake {
    /// Total attenuation, 1/mm.
    pub attenuation_per_mm: f64,
    /// Dose per fluence: μ_a in 1/mm, or 1 in pure Radon mode.
    pub active_per_mm: f64,
}

/// Optical properties of the resin at one wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resin {
    /// Refractive index, > 0; on the axis where it changes.
    pub refractive_index: f64,
    /// How the index changes with the distance from the axis; None: it is the same everywhere.
    pub gradient: Option<IndexGradient>,
    /// Active absorption μ_a, 1/mm, > 0 unless `pure_radon`.
    pub absorption_per_mm: f64,
    /// Total attenuation μ_t, 1/mm, ≥ μ_a.
    pub attenuation_per_mm: f64,
    /// Dose is the plain sum of fluence, no μ at all (the Radon convention of the literature).
    pub pure_radon: bool,
}

impl Resin {
    /// A resin in which only the active species absorbs.
    #[must_use]
    pub fn absorbing(refractive_index: f64, absorption_per_mm: f64) -> Self {
        Resin {
            refractive_index,
            gradient: None,
            absorption_per_mm,
            attenuation_per_mm: absorption_per_mm,
            pure_radon: false,
        }
    }

    /// Dose = Σ fluence.
    #[must_use]
    pub fn pure_radon(refractive_index: f64) -> Self {
        Resin {
            refractive_index,
            gradient: None,
            absorption_per_mm: 0.0,
            attenuation_per_mm: 0.0,
            pure_radon: true,
        }
    }

    /// What it takes of light.
    #[must_use]
    pub fn uptake(&self) -> Uptake {
        Uptake {
            attenuation_per_mm: self.attenuation_per_mm,
            active_per_mm: if self.pure_radon {
                1.0
            } else {
                self.absorption_per_mm
            },
        }
    }
}
