//! `[resin]`: what the material is to light.

use crate::job::spec::kind;
use crate::optics::gradient;
use crate::units::Mm;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::PathBuf;

tomolith_core::keys! {
    /// The resin at the light's wavelength.
    pub struct ResinSpec {
        /// Refractive index.
        #[schemars(range(min = 1.0, max = 4.0))]
        pub refractive_index: f64 = 1.5,
        /// Napierian absorption of the active species, 1e-9 to 100 per mm: what makes dose. Required, except with `pure_radon`, which does not use it.
        pub absorption_per_mm: Option<f64>,
        /// Total Napierian attenuation, 1/mm; absorption + scattering when left out.
        pub attenuation_per_mm: Option<f64>,
        /// Refractive index that changes with the distance from the axis; from 1 to 4 everywhere in the resin.
        pub gradient: Option<gradient::Params>,
        /// Absorption that changes from place to place.
        pub absorption_map: Option<MapSpec>,
        /// Napierian scattering, 1/mm; a part of the total attenuation.
        #[schemars(range(min = 0.0))]
        pub scattering_per_mm: f64 = 0.0,
        /// Phase function of the scattering, `[resin.phase.KIND]`.
        pub phase: Value = kind("rayleigh"),
        /// Dose is the plain sum of fluence, with no absorption at all (the Radon convention of the literature).
        pub pure_radon: bool = false,
        /// Definition of dose: "energy" (default), absorbed per volume, or "drtvam", that times (n_surrounding/n_resin)², as in Dr.TVAM.
        pub dose_convention: DoseConvention = DoseConvention::Energy,
        /// Dose at which the resin turns solid, mJ/mm³; ties the relative dose to exposure.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        pub critical_dose_mj_per_mm3: Option<f64>,
    }
}

/// What a dose counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DoseConvention {
    /// Absorbed energy per volume, Σ over the frames.
    #[default]
    Energy,
    /// Dr.TVAM's: (n_surrounding/n_resin)² of it, which its refracted light carries; for comparisons side by side.
    Drtvam,
}

/// Absorption per cell, centered on the axis; beyond the cells the resin has its plain numbers. Files are `.npy` of any number type, 1/mm:
/// 2D [y, x], the same at all heights, or 3D [z, y, x], centered on z = 0; row 0 = most negative y, level 0 = lowest.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MapSpec {
    /// Absorption of the active species, which makes dose.
    pub absorption: PathBuf,
    /// Total attenuation; absorption + `resin.scattering_per_mm` when left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub attenuation: Option<PathBuf>,
    /// Edge of a cell.
    pub pitch_mm: Mm,
}

impl ResinSpec {
    /// Absorption of the active species, 1/mm: 0 for the plain sum of fluence.
    #[must_use]
    pub fn active_per_mm(&self) -> f64 {
        self.absorption_per_mm
            .filter(|_| !self.pure_radon)
            .unwrap_or(0.0)
    }
}
