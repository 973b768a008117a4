//! The unit systems of BCLP, supplementary table 3, and the way there from ours.
//!
//! | row | pattern g | operator | dose f |
//! |---|---|---|---|
//! | [`Volumetric`](UnitSystem::Volumetric) | areal dose, J/cm² | absorption coefficient, 1/cm | J/cm³ |
//! | [`VolumetricRate`](UnitSystem::VolumetricRate) | intensity, W/cm² | time × absorption coefficient, s/cm | J/cm³ |
//! | [`Areal`](UnitSystem::Areal) | areal dose, J/cm² | none | J/cm² |
//! | [`ArealRate`](UnitSystem::ArealRate) | intensity, W/cm² | time, s | J/cm² |
//!
//! Ours are the first row in mm and mJ: 1 mJ/mm² = 0.1 J/cm², 1 mJ/mm³ = 1 J/cm³, 1 per mm = 10 per cm. The time is that of
//! the whole exposure: an intensity is a mean over all frames, of which a pixel shines in one. **Source** Li et al.,
//! Additive Manufacturing 94 (2024) 104447, supplement S.9.
//!
//! ```
//! use tomolith_metrics::published::unit_systems::UnitSystem;
//! // 2 mJ/mm² within 10 s, absorbed with 0.1 per mm: 0.2 mJ/mm³ without attenuation
//! let row = UnitSystem::VolumetricRate.convert(2.0, 0.2, 0.1, 10.0);
//! assert!((row.pattern.0 - 0.02).abs() < 1e-15); // 0.2 J/cm² in 10 s
//! assert!((row.operator.0 - 10.0).abs() < 1e-12); // 10 s × 1 per cm
//! assert!((row.pattern.0 * row.operator.0 - row.dose.0).abs() < 1e-15); // 0.2 J/cm³
//! ```

use serde::Serialize;

/// A row of supplementary table 3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum UnitSystem {
    /// The first row, the paper's own.
    Volumetric,
    /// The second row.
    VolumetricRate,
    /// The third row.
    Areal,
    /// The fourth row.
    ArealRate,
}

/// A number and its unit.
pub type ValueAndUnit = (f64, &'static str);

/// A pattern value, a dose and what leads from one to the other, in the units of a system.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Converted {
    /// The system.
    pub system: UnitSystem,
    /// g
    pub pattern: ValueAndUnit,
    /// The factor in P and P*.
    pub operator: ValueAndUnit,
    /// f
    pub dose: ValueAndUnit,
}

impl UnitSystem {
    /// Every row, in the order of the table.
    pub const ALL: [UnitSystem; 4] = [
        UnitSystem::Volumetric,
        UnitSystem::VolumetricRate,
        UnitSystem::Areal,
        UnitSystem::ArealRate,
    ];

    /// Whether it counts light by the time that it shines.
    #[must_use]
    pub fn needs_time(self) -> bool {
        matches!(self, UnitSystem::VolumetricRate | UnitSystem::ArealRate)
    }

    /// A pattern value (mJ/mm²) and a dose (mJ/mm³) with the active species' absorption (1/mm, above 0) and the exposure
    /// (s, above 0).
    #[must_use]
    pub fn convert(
        self,
        pattern: f64,
        dose: f64,
        absorption_per_mm: f64,
        exposure_s: f64,
    ) -> Converted {
        let areal = 0.1 * pattern;
        let per_cm = 10.0 * absorption_per_mm;
        let (pattern, operator, dose) = match self {
            UnitSystem::Volumetric => ((areal, "J/cm²"), (per_cm, "1/cm"), (dose, "J/cm³")),
            UnitSystem::VolumetricRate => (
                (areal / exposure_s, "W/cm²"),
                (exposure_s * per_cm, "s/cm"),
                (dose, "J/cm³"),
            ),
            UnitSystem::Areal => ((areal, "J/cm²"), (1.0, ""), (dose / per_cm, "J/cm²")),
            UnitSystem::ArealRate => (
                (areal / exposure_s, "W/cm²"),
                (exposure_s, "s"),
                (dose / per_cm, "J/cm²"),
            ),
        };
        Converted {
            system: self,
            pattern,
            operator,
            dose,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;

    #[test]
    fn in_every_system_pattern_times_operator_is_the_dose() {
        // Without attenuation a pixel of 3 mJ/mm² gives 3·μ mJ/mm³
        for (mu, seconds) in [(0.05, 30.0), (0.3, 1.0), (1.0, 240.0)] {
            for system in UnitSystem::ALL {
                let row = system.convert(3.0, 3.0 * mu, mu, seconds);
                near!(row.pattern.0 * row.operator.0, row.dose.0, 1e-12, "{row:?}");
            }
        }
    }
}
