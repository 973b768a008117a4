//! Quantities with units, as they are typed: a dose per area is no dose per volume.
//!
//! ```
//! use tomolith_planning::quantity::{AREAL_DOSE, IRRADIANCE, POWER, VOLUMETRIC_DOSE};
//! assert_eq!(VOLUMETRIC_DOSE.parse("--critical-dose", "0.8 J/cm3").unwrap(), 0.8); // = mJ/mm³
//! assert_eq!(IRRADIANCE.parse("--irradiance", "250 W/m²").unwrap(), 25.0); // mW/cm²
//! assert_eq!(POWER.parse("--power", "1.5 W").unwrap(), 1500.0); // mW
//! assert_eq!(AREAL_DOSE.parse("--from", "7").unwrap(), 7.0); // mJ/cm²
//! let error = VOLUMETRIC_DOSE.parse("--critical-dose", "80 mJ/cm2").unwrap_err().to_string();
//! assert!(error.contains("a dose per area"));
//! ```

use tomolith_core::error::{Error, Result};
use tomolith_core::units::number_and_unit;

/// What a number can be, and the units it may have.
#[derive(Debug)]
pub struct UnitFamily {
    name: &'static str,
    /// Units and their size in that of plain numbers, which is the first.
    units: &'static [(&'static str, f64)],
    /// Advice for each other quantity that may be meant by mistake.
    advice: &'static str,
}

/// Energy per volume, mJ/mm³.
pub const VOLUMETRIC_DOSE: UnitFamily = UnitFamily {
    name: "a dose per volume",
    units: &[
        ("mJ/mm3", 1.0),
        ("J/cm3", 1.0),
        ("mJ/cm3", 1e-3),
        ("J/m3", 1e-6),
        ("MJ/m3", 1.0),
    ],
    advice: "a resin gels at an energy per volume; a dose per area E at its face is E/(penetration depth) there: 80 mJ/cm² at 10 mm \
             are 0.08 mJ/mm³",
};

/// Energy per area, mJ/cm².
pub const AREAL_DOSE: UnitFamily = UnitFamily {
    name: "a dose per area",
    units: &[
        ("mJ/cm2", 1.0),
        ("J/cm2", 1e3),
        ("mJ/mm2", 100.0),
        ("J/m2", 0.1),
    ],
    advice: "what a disc is lit with is an energy per area",
};

/// Power per area, mW/cm².
pub const IRRADIANCE: UnitFamily = UnitFamily {
    name: "an irradiance",
    units: &[
        ("mW/cm2", 1.0),
        ("W/cm2", 1e3),
        ("mW/mm2", 100.0),
        ("W/m2", 0.1),
    ],
    advice: "an irradiance is a power per area",
};

/// Power, mW.
pub const POWER: UnitFamily = UnitFamily {
    name: "a power",
    units: &[("mW", 1.0), ("W", 1e3), ("uW", 1e-3)],
    advice: "a power has no area: an irradiance goes to --irradiance",
};

const ALL: [&UnitFamily; 4] = [&VOLUMETRIC_DOSE, &AREAL_DOSE, &IRRADIANCE, &POWER];

impl UnitFamily {
    /// The number of a text in the first unit; `key` names it in errors.
    ///
    /// # Errors
    /// [`Error::Config`] for what is no number above 0, an unknown unit, or the unit of something else.
    pub fn parse(&self, key: &str, text: &str) -> Result<f64> {
        let accepted = || {
            let units: Vec<&str> = self.units.iter().map(|u| u.0).collect();
            format!(
                "{} above 0, in {} ({} without a unit)",
                self.name,
                units.join(", "),
                units[0]
            )
        };
        let plain = text
            .replace('²', "2")
            .replace('³', "3")
            .replace(['µ', 'μ'], "u");
        let (number, unit) = number_and_unit(&plain);
        let refuse = |found: String, accepted: String| Err(Error::config(key, found, accepted));
        let value = match number {
            Some(value) if value.is_finite() && value > 0.0 => value,
            _ => return refuse(format!("found `{text}`"), accepted()),
        };
        if unit.is_empty() {
            return Ok(value);
        }
        if let Some((_, size)) = self.units.iter().find(|(name, _)| *name == unit) {
            return Ok(value * size);
        }
        let is_other = |other: &&&UnitFamily| other.units.iter().any(|(name, _)| *name == unit);
        match ALL.iter().find(is_other) {
            Some(other) => refuse(
                format!("`{text}` is {}, and {} is meant", other.name, self.name),
                format!("{}: {}", accepted(), self.advice),
            ),
            None => refuse(format!("unknown unit `{unit}`"), accepted()),
        }
    }
}
