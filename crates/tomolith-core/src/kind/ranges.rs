//! Ranges of numbers, as the schema of a table states them: `#[schemars(range(min = 1.0, max = 4.0))]` at a field, or
//! `#[schemars(extend("exclusiveMinimum" = 0.0))]`. They are checked where a section is read, stand in the reference and guide editors.

use super::schema_of;
use crate::error::{Error, Result};
use crate::units::{Mm, exact};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

/// Units by the ends of keys; the first that fits.
const UNITS: [(&str, &str); 12] = [
    ("mm2_per_s", "mm²/s"),
    ("_per_s", "1/s"),
    ("_mj_per_mm3", "mJ/mm³"),
    ("_mm3_per_mj", "mm³/mJ"),
    ("_per_mm", "1/mm"),
    ("_mm", "mm"),
    ("_nm", "nm"),
    ("_deg", "degrees"),
    ("_percent", "percent"),
    ("_hz", "Hz"),
    ("_gb", "GB"),
    ("_s", "s"),
];

/// The numbers that a key may have.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NumberRange {
    /// `minimum` and `exclusiveMinimum`.
    least: Option<f64>,
    above: Option<f64>,
    /// `maximum` and `exclusiveMaximum`.
    most: Option<f64>,
    below: Option<f64>,
    is_whole: bool,
}

impl NumberRange {
    /// Of the schema of a key; None where it states no range.
    #[must_use]
    pub fn of(schema: &Value) -> Option<Self> {
        let end = |name: &str| schema[name].as_f64();
        let range = NumberRange {
            least: end("minimum"),
            above: end("exclusiveMinimum"),
            most: end("maximum"),
            below: end("exclusiveMaximum"),
            is_whole: holds(&schema["type"], "integer"),
        };
        let has_ends = NumberRange {
            is_whole: false,
            ..range
        } != NumberRange::default();
        // Whole numbers are not negative anyway
        let is_any_count = range.is_whole && range.least == Some(0.0) && range.most.is_none();
        (has_ends && !is_any_count).then_some(range)
    }

    /// Whether a value is a number beyond the range. In the place of a whole number anything else is, too, so that the message has the range.
    fn refuses(&self, value: &Value) -> bool {
        match (self.is_whole, number_of(value)) {
            _ if value.is_null() => false,
            (false, number) => number.is_some_and(|number| !self.contains(number)),
            (true, number) => !is_whole(value) || number.is_none_or(|n| !self.contains(n)),
        }
    }

    fn contains(&self, value: f64) -> bool {
        self.least.is_none_or(|least| value >= least)
            && self.above.is_none_or(|above| value > above)
            && self.most.is_none_or(|most| value <= most)
            && self.below.is_none_or(|below| value < below)
    }

    /// In words: `1 to 16`, `above 0`, `above 0, at most 360`.
    #[must_use]
    pub fn words(&self) -> String {
        if let (Some(least), Some(most)) = (self.least, self.most) {
            return format!("{} to {}", brief(least), brief(most));
        }
        let low = self.least.map(|least| format!("{} or more", brief(least)));
        let low = low.or_else(|| self.above.map(|above| format!("above {}", brief(above))));
        let high = self.most.map(|most| format!("at most {}", brief(most)));
        let high = high.or_else(|| self.below.map(|below| format!("below {}", brief(below))));
        let both: Vec<String> = low.into_iter().chain(high).collect();
        both.join(", ")
    }

    /// What a key accepts: `a whole number, 1 to 16`, `a number in mm, above 0`.
    fn accepted(&self, key: &str) -> String {
        let last = key.rsplit('.').next().unwrap_or_default();
        let name = last.split('[').next().unwrap_or_default();
        let unit = UNITS.iter().find(|(end, _)| name.ends_with(end));
        let unit = unit.map_or_else(String::new, |(_, unit)| format!(" in {unit}"));
        let what = if self.is_whole {
            "whole number"
        } else {
            "number"
        };
        format!("a {what}{unit}, {}", self.words())
    }
}

/// An end of a range: `0.25`, `16384`, `1e9`.
fn brief(value: f64) -> String {
    match value.abs() >= 1e6 {
        true => format!("{value:e}"),
        false => exact(value),
    }
}

/// Whether a `type` is, or has among others, this one.
fn holds(types: &Value, name: &str) -> bool {
    types == name
        || types
            .as_array()
            .is_some_and(|all| all.iter().any(|listed| listed == name))
}

/// Refuses the first number of a table that is beyond the range of its key or not finite, the table at `path` of a job. Keys that are None are not
/// written, as with [`keys!`](crate::keys).
///
/// # Errors
/// [`Error::Config`] with the key.
pub fn check_ranges<T: Serialize + JsonSchema>(path: &str, table: &T) -> Result<()> {
    let unwritten = |e: serde_json::Error| Error::refused(path, e, "a table");
    let value = serde_json::to_value(table).map_err(unwritten)?;
    must_be_finite(path, &value)?;
    let schema = schema_of::<T>();
    check(path, &value, schema.as_value(), schema.as_value())
}

/// The path of a key of the table at a path.
fn within(path: &str, key: &str) -> String {
    let dot = if path.is_empty() { "" } else { "." };
    format!("{path}{dot}{key}")
}

/// Refuses null: what is written of a number that is not finite.
fn must_be_finite(path: &str, value: &Value) -> Result<()> {
    match value {
        Value::Null => Err(Error::refused(path, "no finite number", "a finite number")),
        Value::Object(table) => {
            (table.iter()).try_for_each(|(key, value)| must_be_finite(&within(path, key), value))
        }
        Value::Array(list) => (list.iter().enumerate())
            .try_for_each(|(i, value)| must_be_finite(&format!("{path}[{i}]"), value)),
        _ => Ok(()),
    }
}

/// Refuses the first number of a value that is beyond the range of its key; `root` has the definitions.
pub(super) fn check(path: &str, value: &Value, schema: &Value, root: &Value) -> Result<()> {
    if let Some(range) = NumberRange::of(schema).filter(|range| range.refuses(value)) {
        let found = match value.as_f64() {
            Some(number) if !range.is_whole => exact(number),
            _ => value.to_string(),
        };
        return Err(Error::refused(path, found, range.accepted(path)));
    }
    if let Some(target) = schema["$ref"].as_str().and_then(|at| at.strip_prefix('#')) {
        let target = root.pointer(target).unwrap_or(&Value::Null);
        check(path, value, target, root)?;
    }
    for name in ["anyOf", "oneOf"] {
        let options = schema[name].as_array().into_iter().flatten();
        for option in options.filter(|option| may_be(value, option)) {
            check(path, value, option, root)?;
        }
    }
    match value {
        Value::Object(table) => table.iter().try_for_each(|(key, value)| {
            let inner = schema["properties"].get(key);
            let inner = inner.or_else(|| schema.get("additionalProperties"));
            let at = || within(path, key);
            inner.map_or(Ok(()), |schema| check(&at(), value, schema, root))
        }),
        Value::Array(list) => list.iter().enumerate().try_for_each(|(i, value)| {
            check(&format!("{path}[{i}]"), value, &schema["items"], root)
        }),
        _ => Ok(()),
    }
}

fn is_whole(value: &Value) -> bool {
    value.is_u64() || value.is_i64()
}

/// Whether a value is of one of several forms: a table has keys of that form alone, a whole number is one.
fn may_be(value: &Value, form: &Value) -> bool {
    if holds(&form["type"], "integer") {
        return is_whole(value);
    }
    let (Some(table), Some(known)) = (value.as_object(), form["properties"].as_object()) else {
        return true;
    };
    table.keys().all(|key| known.contains_key(key))
}

/// The number, or the length in mm that a text gives.
fn number_of(value: &Value) -> Option<f64> {
    match value {
        Value::String(_) => serde_json::from_value(value.clone())
            .ok()
            .map(|mm: Mm| mm.0),
        _ => value.as_f64(),
    }
}

#[cfg(test)]
mod tests {
    use super::check_ranges;
    use crate::kind::Section;
    use crate::units::Mm;
    use schemars::JsonSchema;
    use serde::Deserialize;
    use serde_json::json;
    use std::collections::BTreeMap;

    #[derive(Deserialize, JsonSchema)]
    #[expect(dead_code, reason = "only read")]
    struct Table {
        #[schemars(range(min = 1, max = 16))]
        bits: Option<u8>,
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        height_mm: Option<Mm>,
        #[schemars(inner(range(min = -1.0, max = 1.0)))]
        offset_mm: Option<[f64; 2]>,
        either: Option<Either>,
        #[serde(default)]
        inner: BTreeMap<String, Inner>,
    }

    crate::keys! {
        /// A table that a program makes.
        struct Made {
            #[schemars(range(min = 0.0))]
            time_s: Option<f64>,
            places: Vec<[f64; 2]> = Vec::new(),
        }
    }

    #[test]
    fn a_table_that_a_program_makes_has_finite_numbers_in_their_ranges() {
        let refusal_at = |path, time_s, place| {
            let places = vec![[0.0, place]];
            let checked = check_ranges(path, &Made { time_s, places });
            checked.err().map(|error| error.to_string())
        };
        let refusal = |time_s, place| refusal_at("made", time_s, place);
        for time_s in [-1.0, f64::NAN] {
            let text = refusal_at("", Some(time_s), 0.0).unwrap();
            assert!(text.starts_with("time_s: found"), "{text}");
        }
        assert_eq!(refusal(Some(1.0), -3.0), None);
        assert_eq!(refusal(None, 0.0), None);
        let found = |time_s, place, key: &str| {
            let text = refusal(time_s, place).unwrap();
            assert!(text.starts_with(key), "{text}");
        };
        found(Some(-1.0), 0.0, "made.time_s: found -1");
        found(Some(f64::NAN), 0.0, "made.time_s: found no finite number");
        found(
            None,
            f64::INFINITY,
            "made.places[0][1]: found no finite number",
        );
    }

    #[derive(Deserialize, JsonSchema)]
    struct Inner {
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 360.0))]
        #[expect(dead_code, reason = "only read")]
        arc_deg: f64,
    }

    #[derive(Deserialize, JsonSchema)]
    #[serde(untagged)]
    #[expect(dead_code, reason = "only read")]
    enum Either {
        Count(#[schemars(range(min = 2))] u32),
        Even {
            #[schemars(range(max = 9.0))]
            count: f64,
        },
        List {
            #[schemars(inner(range(max = 5.0)))]
            list: Vec<f64>,
        },
    }

    #[test]
    fn numbers_beyond_the_range_of_their_key_are_refused_wherever_they_are() {
        let refusal = |value: serde_json::Value| {
            let read = Section::new("table", value).parse::<Table>();
            read.err().map(|error| error.to_string())
        };
        for value in [
            json!({}),
            json!({"bits": 1, "height_mm": "3 um", "offset_mm": [-1.0, 1.0]}),
            json!({"either": 2, "inner": {"a": {"arc_deg": 360}}}),
            json!({"either": {"count": 1.0}}),
            json!({"either": {"list": [-7.0, 4.9]}, "height_mm": 1e-9}),
        ] {
            assert_eq!(refusal(value.clone()), None, "{value}");
        }
        for (value, message) in [
            (
                json!({"bits": 17}),
                "table.bits: found 17; accepted: a whole number, 1 to 16",
            ),
            (
                json!({"bits": -1}),
                "table.bits: found -1; accepted: a whole number, 1 to 16",
            ),
            (
                json!({"bits": 2.5}),
                "table.bits: found 2.5; accepted: a whole number, 1 to 16",
            ),
            (
                json!({"bits": "two"}),
                "table.bits: found \"two\"; accepted: a whole number, 1 to 16",
            ),
            (
                json!({"height_mm": "-2 um"}),
                "table.height_mm: found \"-2 um\"; accepted: a number in mm, above 0",
            ),
            (
                json!({"height_mm": 0}),
                "table.height_mm: found 0; accepted: a number in mm, above 0",
            ),
            (
                json!({"offset_mm": [0.0, 1.5]}),
                "table.offset_mm[1]: found 1.5; accepted: a number in mm, -1 to 1",
            ),
            (
                json!({"either": 1}),
                "table.either: found 1; accepted: a whole number, 2 or more",
            ),
            (
                json!({"either": {"count": 9.5}}),
                "table.either.count: found 9.5; accepted: a number, at most 9",
            ),
            (
                json!({"either": {"list": [1.0, 5.5]}}),
                "table.either.list[1]: found 5.5; accepted: a number, at most 5",
            ),
            (
                json!({"inner": {"a": {"arc_deg": 0.0}}}),
                "table.inner.a.arc_deg: found 0; accepted: a number in degrees, above 0, at most 360",
            ),
        ] {
            assert_eq!(refusal(value).as_deref(), Some(message));
        }
    }
}
