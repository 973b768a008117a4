//! Quantities of job files that may carry a unit.
//!
//! A key names its unit (`inner_radius_mm`); a plain number is in that unit, and a string may say another one:
//!
//! ```
//! use tomolith_core::units::Mm;
//! let a: Mm = serde_json::from_str("8.0").unwrap();
//! let b: Mm = serde_json::from_str("\"0.8 cm\"").unwrap();
//! assert_eq!(a.0, 8.0); // a number is in millimeters, the unit in the key
//! assert!((b.0 - a.0).abs() < 1e-12); // 0.8 cm = 8 mm
//! assert!(serde_json::from_str::<Mm>("\"8 kg\"").is_err());
//! ```

use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

/// A number as it stands in a job, for messages: every digit that was written, however large or small it is.
///
/// ```
/// use tomolith_core::units::exact;
/// assert_eq!([0.054, 2.0, 1.0000001, 1e300].map(exact), ["0.054", "2", "1.0000001", "1e300"]);
/// ```
#[must_use]
pub fn exact(value: impl fmt::LowerExp + fmt::Debug) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// A length or volume that was computed, for messages: six significant digits at most, so that a part of micrometers has some
/// and one of 10³⁰⁰ mm has not three hundred.
///
/// ```
/// use tomolith_core::units::concise;
/// assert_eq!([0.1 + 0.2, 7.6, 1.0 / 3.0, 1.25e-9, -2e300].map(concise), ["0.3", "7.6", "0.333333", "1.25e-9", "-2e300"]);
/// assert_eq!(concise(-0.0), "0");
/// ```
#[must_use]
pub fn concise(value: f64) -> String {
    // Adding zero turns −0 into 0
    exact(format!("{value:.5e}").parse().unwrap_or(value) + 0.0)
}

/// The number at the beginning of a text, None where there is none, and the unit behind it.
///
/// ```
/// use tomolith_core::units::number_and_unit;
/// assert_eq!(number_and_unit("1e3 m"), (Some(1000.0), "m"));
/// assert_eq!(number_and_unit("1em"), (Some(1.0), "em")); // the e of an exponent has a number behind it
/// ```
#[must_use]
pub fn number_and_unit(text: &str) -> (Option<f64>, &str) {
    let is_exponent = |i: usize, c: char| {
        let behind = |n: char| n.is_ascii_digit() || n == '-' || n == '+';
        matches!(c, 'e' | 'E') && text[i + 1..].starts_with(behind)
    };
    let unit = text
        .char_indices()
        .find(|&(i, c)| c.is_alphabetic() && !is_exponent(i, c));
    let (number, unit) = text.split_at(unit.map_or(text.len(), |(i, _)| i));
    (number.trim().parse().ok(), unit.trim())
}

/// A length in millimeters: a finite number, or a string such as `"8 mm"`, `"13.7 um"`, `"0.8 cm"`, `"405 nm"`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Default, Serialize)]
#[serde(transparent)]
pub struct Mm(pub f64);

/// As it was written, with its unit: `8 mm`, `1e300 mm`.
impl fmt::Display for Mm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} mm", exact(self.0))
    }
}

impl Mm {
    fn parse(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let (number, unit) = number_and_unit(text);
        let value = number
            .ok_or_else(|| format!("`{text}` is not a length; accepted: a number in mm, or \"8 mm\", \"13.7 um\", \"0.8 cm\""))?;
        let factor = match unit {
            "" | "mm" => 1.0,
            "um" | "µm" | "μm" => 1e-3,
            "nm" => 1e-6,
            "cm" => 10.0,
            "m" => 1000.0,
            "in" | "inch" => 25.4,
            other => {
                return Err(format!(
                    "unknown unit of length `{other}`; accepted: nm, um, mm, cm, m, in"
                ));
            }
        };
        let mm = value * factor;
        if mm.is_finite() {
            Ok(Mm(mm))
        } else {
            Err(format!("`{text}` is not finite"))
        }
    }
}

/// Distances of columns and of rows, mm: one length for square pixels, or both.
///
/// ```
/// use tomolith_core::units::Pitch;
/// let square: Pitch = serde_json::from_str("\"20 um\"").unwrap();
/// let flat: Pitch = serde_json::from_str("[0.04, \"20 um\"]").unwrap();
/// assert_eq!((square.0, flat.0), ([0.02, 0.02], [0.04, 0.02]));
/// assert!(serde_json::from_str::<Pitch>("[0.04]").is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pitch(pub [f64; 2]);

impl Serialize for Pitch {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let [columns, rows] = self.0;
        if columns == rows {
            Mm(columns).serialize(serializer)
        } else {
            self.0.serialize(serializer)
        }
    }
}

impl<'de> Deserialize<'de> for Pitch {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = serde_json::Value::deserialize(deserializer)?;
        let lengths = if value.is_array() {
            serde_json::from_value::<[Mm; 2]>(value)
        } else {
            serde_json::from_value::<Mm>(value).map(|pitch| [pitch; 2])
        };
        let lengths = lengths.map_err(serde::de::Error::custom)?;
        Ok(Pitch(lengths.map(|mm| mm.0)))
    }
}

impl schemars::JsonSchema for Pitch {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Pitch".into()
    }
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let one = generator.subschema_for::<Mm>();
        schemars::json_schema!({
            "description": "One length for square pixels, or [column pitch, row pitch]",
            "anyOf": [one, { "type": "array", "items": one, "minItems": 2, "maxItems": 2 }]
        })
    }
}

impl<'de> Deserialize<'de> for Mm {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl serde::de::Visitor<'_> for Visitor {
            type Value = Mm;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a length: a number in mm, or a string such as \"8 mm\" or \"13.7 um\"")
            }
            fn visit_f64<E: serde::de::Error>(self, v: f64) -> Result<Mm, E> {
                if v.is_finite() {
                    Ok(Mm(v))
                } else {
                    Err(E::custom("a length must be finite"))
                }
            }
            #[expect(clippy::cast_precision_loss, reason = "lengths are small numbers")]
            fn visit_i64<E: serde::de::Error>(self, v: i64) -> Result<Mm, E> {
                Ok(Mm(v as f64))
            }
            #[expect(clippy::cast_precision_loss, reason = "lengths are small numbers")]
            fn visit_u64<E: serde::de::Error>(self, v: u64) -> Result<Mm, E> {
                Ok(Mm(v as f64))
            }
            fn visit_str<E: serde::de::Error>(self, v: &str) -> Result<Mm, E> {
                Mm::parse(v).map_err(E::custom)
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

impl schemars::JsonSchema for Mm {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Length".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A length: a number in mm, or a string with a unit (nm, um, mm, cm, m, in)",
            "type": ["number", "string"]
        })
    }
}

/// A time for people: from milliseconds to years.
///
/// ```
/// use tomolith_core::units::duration;
/// let times = [0.008, 3.0, 4e3, 1e5, 3e9].map(duration);
/// assert_eq!(times, ["8 ms", "3.0 s", "67 min", "27.8 h", "95 years"]);
/// ```
#[must_use]
pub fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 0.1 => format!("{:.0} ms", 1e3 * s),
        s if s < 10.0 => format!("{s:.1} s"),
        s if s < 100.0 => format!("{s:.0} s"),
        s if s < 6e3 => format!("{:.0} min", s / 60.0),
        s if s < 172_800.0 => format!("{:.1} h", s / 3600.0),
        s if s < 6.3e7 => format!("{:.0} days", s / 86_400.0),
        s => format!("{:.0} years", s / 31_557_600.0),
    }
}

/// A number of things.
///
/// ```
/// use tomolith_core::units::counted;
/// assert_eq!([1, 3].map(|n| counted(n, "frame")), ["1 frame", "3 frames"]);
/// ```
#[must_use]
pub fn counted(count: usize, thing: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{plural}")
}
