//! Rows of the tables of kinds: the row is the registration.
//!
//! A family (vials, objectives, optimizers, …) is a trait and a static table of [`Kind`]s. A row enrols its kind in job
//! files, in `tomolith kinds`, in the JSON schema and in the family's tests. In a job a kind is an externally tagged
//! table, `[family.kind]`, so that an error can name the very key.

mod located;
mod ranges;

use self::located::{Failure, Fault};
pub use self::ranges::{NumberRange, check_ranges};
use crate::error::{Error, Result, in_range, nearest_name};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};
use std::path::{Path, PathBuf};

/// One table of a job file, and the key path that led to it.
#[derive(Clone, Debug)]
pub struct Section {
    /// Dotted key path, for error messages.
    pub path: String,
    /// The content.
    pub value: Value,
    /// The folder that its relative paths begin in; empty for the current one.
    base: PathBuf,
    /// A section of its kind that works, for messages; empty where it is of no kind.
    example: &'static str,
    /// Keys that may stand beside its kind and were taken out of it, for messages.
    siblings: &'static [&'static str],
}

impl Section {
    /// A section at a path.
    pub fn new(path: impl Into<String>, value: Value) -> Self {
        Section {
            path: path.into(),
            value,
            base: PathBuf::new(),
            example: "",
            siblings: &[],
        }
    }

    /// The same section, from which these keys, which may stand beside its kind, were taken.
    #[must_use]
    pub fn without(mut self, siblings: &'static [&'static str]) -> Self {
        self.siblings = siblings;
        self
    }

    /// The same section, its relative paths beginning in a folder.
    #[must_use]
    pub fn based(mut self, folder: &Path) -> Self {
        folder.clone_into(&mut self.base);
        self
    }

    /// A section within this one, at a key; its paths begin in the same folder.
    #[must_use]
    pub fn within(&self, key: &str, value: Value) -> Self {
        Section::new(format!("{}.{key}", self.path), value).based(&self.base)
    }

    /// Path of a file that the section names.
    #[must_use]
    pub fn file(&self, path: &Path) -> PathBuf {
        self.base.join(path)
    }

    /// The error of a value that a key of this section may not have.
    pub fn refused(
        &self,
        key: &str,
        found: impl std::fmt::Display,
        accepted: impl Into<String>,
    ) -> Error {
        let key = format!("{}.{key}", self.path);
        Error::refused(key, found, accepted)
    }

    /// Refuses the number of a key unless it is in range.
    ///
    /// # Errors
    /// [`Error::Config`] with the number and what is accepted.
    pub fn in_range(&self, is_in: bool, key: &str, value: f64, accepted: &str) -> Result<()> {
        in_range(is_in, key, value, accepted).map_err(|e| e.under(&self.path))
    }

    /// Reads the section into a parameter struct (use `#[serde(deny_unknown_fields)]` on it); its numbers are in the ranges that its schema states.
    ///
    /// # Errors
    /// [`Error::Config`] with the key path of the offending key, and the nearest accepted name for a misspelt one.
    pub fn parse<T: DeserializeOwned + JsonSchema>(&self) -> Result<T> {
        let schema = schema_of::<T>();
        let schema = schema.as_value();
        ranges::check(&self.path, &self.value, schema, schema)?;
        self.parse_unranged()
    }

    /// [`parse`](Self::parse) of a type without a schema, whose numbers have no ranges.
    ///
    /// # Errors
    /// As [`parse`](Self::parse).
    pub fn parse_unranged<T: DeserializeOwned>(&self) -> Result<T> {
        located::read(&self.value).map_err(|failure| self.unread(&failure))
    }

    /// The error of a value that could not be read. For all types alike: compiled once.
    fn unread(&self, failure: &Failure) -> Error {
        let value = failure.value(&self.value);
        let mut error = config_error(&self.path, failure, value);
        if let Error::Config {
            key,
            found,
            accepted,
            ..
        } = &mut error
            && found == MISSING
            && let Some(line) = self.example_of(key)
        {
            *accepted = format!("a value, for example `{line}`");
        }
        error
    }

    /// The line of the example that gives a key.
    fn example_of(&self, key: &str) -> Option<&'static str> {
        let name = key.rsplit('.').next()?;
        let gives = |line: &&str| line.split('=').next().is_some_and(|key| key.trim() == name);
        self.example.lines().find(gives).map(str::trim)
    }

    /// Reads what a section names: the object of its kind, or what makes one.
    ///
    /// # Errors
    /// As [`kind`](Self::kind); [`Error::Config`] with the key of a parameter.
    pub fn read<T>(&self, table: &[Kind<Read<T>>]) -> Result<T> {
        let (kind, inner) = self.kind(table)?;
        (kind.build)(&inner)
    }

    /// The single kind named in an externally tagged table, and its section: `{cylinder = {…}}` → `("cylinder", {…})`.
    ///
    /// # Errors
    /// [`Error::Config`] when the section does not hold exactly one table, or the kind is not in `table`.
    pub fn kind<'k, B: 'k>(
        &self,
        table: impl IntoIterator<Item = &'k Kind<B>>,
    ) -> Result<(&'k Kind<B>, Section)> {
        let rows: Vec<&Kind<B>> = table.into_iter().collect();
        let names: Vec<&str> = rows.iter().map(|kind| kind.name).collect();
        let (index, mut inner) = self.named(&names)?;
        let row = rows[index];
        inner.example = row.example;
        Ok((row, inner))
    }

    /// Which of these names the section has, and its section. For all families alike: compiled once.
    fn named(&self, names: &[&'static str]) -> Result<(usize, Section)> {
        let accepted = || names.join(", ");
        if let Some((key, name)) = self.value.as_object().and_then(|map| tag(map, names)) {
            return Err(Error::config(
                format!("{}.{key}", self.path),
                format!("found {name:?}: a kind is no key, but a table"),
                format!("[{}.{name}], with the keys of the kind in it", self.path),
            ));
        }
        let (name, value) = match &self.value {
            Value::String(name) => (name, Value::Object(serde_json::Map::new())),
            Value::Object(map) if map.len() == 1 => {
                let (name, value) = map.iter().next().ok_or(Error::Canceled)?;
                (name, value.clone())
            }
            Value::Object(map) if map.is_empty() => {
                return Err(Error::config(
                    &self.path,
                    "no kind is named",
                    format!("one of {}", accepted()),
                ));
            }
            Value::Object(map) => {
                if let Some(word) = self.misspelt(map, names) {
                    let key = format!("{}.{word}", self.path);
                    return Err(unknown(key, word, self.siblings));
                }
                let found = map.keys().cloned().collect::<Vec<_>>().join(", ");
                return Err(Error::config(
                    &self.path,
                    format!("more than one entry ({found})"),
                    format!("exactly one of {}", accepted()),
                ));
            }
            other => {
                return Err(Error::refused(
                    &self.path,
                    other,
                    format!(
                        "a table [{}.KIND] with KIND one of {}",
                        self.path,
                        accepted()
                    ),
                ));
            }
        };
        let index = names.iter().position(|known| known == name);
        let index = index.ok_or_else(|| {
            let key = format!("{}.{name}", self.path);
            Error::Config {
                found: format!("unknown kind `{name}`"),
                key,
                accepted: accepted(),
                nearest: nearest_name(name, names.iter().copied()).map(str::to_owned),
                place: None,
            }
        })?;
        Ok((index, self.within(name, value)))
    }

    /// The first of the other keys where one names a kind: none of those that may stand beside it.
    fn misspelt<'v>(&self, map: &'v Map<String, Value>, names: &[&str]) -> Option<&'v str> {
        let is_kind = |key: &&String| names.contains(&key.as_str());
        let kinds = map.keys().filter(is_kind).count();
        let mut others = map.keys().filter(|key| !is_kind(key));
        let word = others.next()?;
        (kinds == 1 && !self.siblings.is_empty()).then_some(word)
    }
}

/// The key by which a table names its kind as other programs do: `kind = "cylinder"`.
fn tag<'v>(map: &'v Map<String, Value>, names: &[&str]) -> Option<(&'static str, &'v str)> {
    ["kind", "type"].into_iter().find_map(|key| {
        let name = map.get(key)?.as_str()?;
        names.contains(&name).then_some((key, name))
    })
}

/// What stands in the place of one of several names: what a table holds, and how many of the names it may.
fn unnamed(value: Option<&Value>, names: &[&str]) -> (String, String) {
    let names = names.join(", ");
    let (found, accepted) = match value {
        Some(Value::Object(table)) if table.is_empty() => (
            "an empty table".to_owned(),
            format!("exactly one of {names}"),
        ),
        Some(Value::Object(table)) => {
            let keys: Vec<&str> = table.keys().map(String::as_str).collect();
            let found = format!("a table with {}", keys.join(" and "));
            (found, format!("exactly one of {names}"))
        }
        Some(Value::Array(_)) => ("a list".to_owned(), names),
        Some(other) => (other.to_string(), names),
        None => ("nothing".to_owned(), names),
    };
    (format!("found {found}"), accepted)
}

/// The keys of a table of a job, each with its default; an `Option` without one is None, and is not written then. The struct reads and writes
/// such tables, refuses keys that it does not have, and has a schema.
///
/// ```
/// tomolith_core::keys! {
///     /// Parameters of a gear.
///     #[derive(PartialEq)]
///     pub struct Params {
///         /// Number of teeth (4 to 500)
///         pub teeth: u32 = 12,
///         /// Diameter of the bore, mm
///         pub bore_mm: Option<f64>,
///     }
/// }
/// assert_eq!(Params::default(), Params { teeth: 12, bore_mm: None });
/// ```
#[macro_export]
macro_rules! keys {
    // The fields and the defaults of the keys that were read, and the rest
    (@ $about:tt [$($fields:tt)*] [$($defaults:tt)*]
        $(#[$of_key:meta])* $shown:vis $key:ident: Option<$type:ty>, $($rest:tt)*) => {
        $crate::keys!(@ $about
            [$($fields)* $(#[$of_key])* #[serde(skip_serializing_if = "Option::is_none")] $shown $key: Option<$type>,]
            [$($defaults)* $key: None,] $($rest)*);
    };
    (@ $about:tt [$($fields:tt)*] [$($defaults:tt)*]
        $(#[$of_key:meta])* $shown:vis $key:ident: $type:ty = $default:expr, $($rest:tt)*) => {
        $crate::keys!(@ $about
            [$($fields)* $(#[$of_key])* $shown $key: $type,] [$($defaults)* $key: $default,] $($rest)*);
    };
    (@ [$(#[$about:meta])* $seen:vis $name:ident] [$($fields:tt)*] [$($defaults:tt)*]) => {
        $(#[$about])*
        #[derive(Clone, Debug, ::serde::Serialize, ::serde::Deserialize, ::schemars::JsonSchema)]
        #[serde(default, deny_unknown_fields)]
        $seen struct $name { $($fields)* }

        impl Default for $name {
            fn default() -> Self {
                $name { $($defaults)* }
            }
        }
    };
    ($(#[$about:meta])* $seen:vis struct $name:ident { $($keys:tt)* }) => {
        $crate::keys!(@ [$(#[$about])* $seen $name] [] [] $($keys)*);
    };
}

/// What is found where a key is missing.
pub const MISSING: &str = "the key is missing";

/// What other programs and papers call a key, and the names that it may have here, the likeliest first.
const SYNONYMS: [(&str, &[&str]); 18] = [
    ("ior", &["refractive_index"]),
    ("n", &["refractive_index"]),
    ("index", &["refractive_index"]),
    ("mu", &["absorption_per_mm"]),
    ("mu_a", &["absorption_per_mm"]),
    ("mu_t", &["attenuation_per_mm"]),
    ("mu_s", &["scattering_per_mm"]),
    ("extinction", &["attenuation_per_mm"]),
    ("penetration_depth_mm", &["absorption_per_mm"]),
    ("depth_mm", &["absorption_per_mm"]),
    ("diameter", &["inner_radius_mm", "radius_mm"]),
    ("diameter_mm", &["inner_radius_mm", "radius_mm"]),
    ("radius", &["inner_radius_mm", "radius_mm"]),
    ("cw", &["clockwise"]),
    ("ccw", &["counterclockwise"]),
    ("anticlockwise", &["counterclockwise"]),
    ("kind", &["phantom"]),
    ("type", &["phantom"]),
];

/// The name that a word stands for among those that are known.
fn synonym<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let (_, names) = SYNONYMS.iter().find(|(other, _)| *other == word)?;
    let mut found = names
        .iter()
        .filter_map(|name| known.iter().find(|key| *key == name));
    found.next().copied()
}

/// What makes a dose per area one per volume.
macro_rules! per_volume {
    () => {
        "E mJ/cm² at the face of a resin with the penetration depth D mm are E/(100·D) mJ/mm³ there"
    };
}

/// Why the number of a key is not that of another key which differs in its unit; None for keys that differ otherwise.
fn other_unit(word: &str, name: &str) -> Option<&'static str> {
    if word.ends_with("depth_mm") && name == "absorption_per_mm" {
        return Some(
            "its inverse is meant; light that falls to 1/e over D mm is absorbed with 1/D per mm",
        );
    }
    if word.contains("diameter") && name.contains("radius") {
        return Some("half of it is meant");
    }
    let (what, unit) = word.split_once("_per_")?;
    let (same, meant) = name.split_once("_per_")?;
    if what != same || unit == meant {
        return None;
    }
    Some(match (unit, meant) {
        ("cm2" | "mm2", "mm3") if what.ends_with("_mj") => {
            concat!(
                "a dose per area, and one per volume is meant; ",
                per_volume!()
            )
        }
        ("cm2", "mm2") => "another unit: 1 per cm² is 0.01 per mm²",
        ("mm2", "cm2") => "another unit: 1 per mm² is 100 per cm²",
        _ => "another unit",
    })
}

/// The [`Error::Config`] of a value (None: one that is not there) within a section at a path.
fn config_error(path: &str, failure: &Failure, value: Option<&Value>) -> Error {
    let inner = failure.path();
    let mut key = match (path.is_empty(), inner.is_empty()) {
        (_, true) => path.to_owned(),
        (true, _) => inner,
        _ => format!("{path}.{inner}"),
    };
    let within = |word: &str| match key.is_empty() {
        true => word.to_owned(),
        false => format!("{key}.{word}"),
    };
    let (found, accepted) = match &failure.fault {
        Fault::Unknown { word, known } => {
            // An unknown name in a table is a key of it, and else the value itself
            let in_table = value.is_none_or(Value::is_object);
            if in_table && key.rsplit('.').next() != Some(word) {
                key = within(word);
            }
            return unknown(key, word, known);
        }
        Fault::Missing(word) => {
            let accepted = "a value; docs/job.md and `tomolith kinds` list what is accepted";
            return Error::config(within(word), MISSING, accepted);
        }
        Fault::Unnamed { names } => unnamed(value, names),
        Fault::Unfit { found, expected } => {
            let accepted = match (value, expected.as_str()) {
                (Some(Value::Object(_)), "a sequence") => {
                    format!("a list, whose tables are written [[{key}]]")
                }
                (Some(Value::String(_)), "f64" | "f32") => number_of(&key).to_owned(),
                _ => in_words(expected),
            };
            (format!("found {found}"), accepted)
        }
        Fault::Other(message) => match message.split_once("; accepted: ") {
            Some((found, accepted)) => (found.to_owned(), accepted.to_owned()),
            None => (message.clone(), "see `tomolith schema`".to_owned()),
        },
    };
    Error::config(key, found, accepted)
}

/// The error of a name that is none of those that are known.
fn unknown(key: String, word: &str, known: &[&str]) -> Error {
    let near = || nearest_name(word, known.iter().copied());
    let nearest = synonym(word, known).or_else(near);
    let unit = nearest.and_then(|name| other_unit(word, name));
    Error::Config {
        found: match unit {
            Some(unit) => format!("unknown name `{word}`: {unit}"),
            None => format!("unknown name `{word}`"),
        },
        key,
        accepted: match known {
            [] => "nothing: this table has no keys".to_owned(),
            known => known.join(", "),
        },
        nearest: nearest.map(str::to_owned),
        place: None,
    }
}

/// What is expected where a number was written as text, most often with a unit.
fn number_of(key: &str) -> &'static str {
    if key.ends_with("_mj_per_mm3") {
        concat!("a number without a unit, in mJ/mm³; ", per_volume!())
    } else if key.contains("_per_") {
        "a number without a unit: the key names it"
    } else {
        "a number"
    }
}

/// What serde expects, without the names of Rust's types.
fn in_words(expected: &str) -> String {
    let words = match expected {
        "usize" | "u64" | "u32" | "u16" | "u8" => "a whole number, 0 or more",
        "i64" | "i32" => "a whole number",
        "f64" | "f32" => "a number",
        "a string" | "str" | "path string" => "text in quotes",
        "a boolean" => "true or false",
        "a sequence" => "a list",
        "a map" | "map" => "a table",
        other if other.starts_with("struct ") => "a table",
        other if other.starts_with("an array of length ") => {
            return other.replace("an array of length ", "a list of ");
        }
        other => other,
    };
    words.to_owned()
}

/// How a row reads its section.
pub type Read<T> = fn(&Section) -> Result<T>;

/// A row of a family's table.
pub struct Kind<B> {
    /// Its name in job files.
    pub name: &'static str,
    /// One sentence.
    pub summary: &'static str,
    /// A section of a job file that works, in TOML.
    pub example: &'static str,
    /// The JSON schema of its parameters: names, types, defaults and meaning (from the doc comments).
    pub schema: fn() -> Schema,
    /// Reads one from its section: the object, or what makes one where that needs more than parameters.
    pub build: B,
}

impl<B> std::fmt::Debug for Kind<B> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// A table of JSON. (`collect` would sort the entries first, by code that is compiled anew for every iterator.)
pub fn table_of(entries: impl Iterator<Item = (String, Value)>) -> Map<String, Value> {
    let mut table = Map::new();
    for (key, value) in entries {
        table.insert(key, value);
    }
    table
}

/// The schema of parameters, with its title and what it refers to: what `schemars::schema_for!` gives, which is compiled anew for every type.
#[must_use]
pub fn schema_of<P: JsonSchema>() -> Schema {
    with_definitions(P::json_schema, &P::schema_name())
}

fn with_definitions(make: fn(&mut SchemaGenerator) -> Schema, title: &str) -> Schema {
    let mut generator = SchemaGenerator::default();
    let mut schema = make(&mut generator);
    let object = schema.ensure_object();
    object.entry("title").or_insert_with(|| title.into());
    if let Some(language) = &generator.settings().meta_schema {
        object.insert("$schema".to_owned(), language.as_ref().into());
    }
    let definitions = generator.take_definitions(true);
    if !definitions.is_empty() {
        object.insert("$defs".to_owned(), definitions.into());
    }
    schema
}

/// A kind without its builder: what help pages and schemas need.
pub struct KindPage {
    /// The family, as the key in a job file: `vial`, `objective`, …
    pub family: &'static str,
    /// Its name.
    pub name: &'static str,
    /// One sentence.
    pub summary: &'static str,
    /// A section of a job file that works, in TOML.
    pub example: &'static str,
    /// The JSON schema of its parameters.
    pub schema: Schema,
}

impl<B> Kind<B> {
    /// The help page of this row.
    pub fn page(&self, family: &'static str) -> KindPage {
        KindPage {
            family,
            name: self.name,
            summary: self.summary,
            example: self.example,
            schema: (self.schema)(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_schema_is_that_of_schemars() {
        #[derive(JsonSchema)]
        struct Inner(#[expect(dead_code, reason = "its schema is all that counts")] f64);
        /// Two of another type.
        #[derive(JsonSchema)]
        #[expect(dead_code, reason = "its schema is all that counts")]
        struct Outer {
            one: Inner,
            more: Option<Vec<Inner>>,
        }
        assert_eq!(schema_of::<Outer>(), schemars::schema_for!(Outer));
        assert_eq!(schema_of::<bool>(), schemars::schema_for!(bool));
    }

    #[derive(Debug, serde::Deserialize, JsonSchema)]
    #[serde(deny_unknown_fields)]
    struct Stop {
        iterations: usize,
    }

    #[test]
    fn a_misspelt_key_is_named_with_its_neighbor() {
        let section = Section::new("stop", json!({ "iteratons": 3 }));
        assert_eq!(
            section.parse::<Stop>().unwrap_err().to_string(),
            "stop.iteratons: unknown name `iteratons`; accepted: iterations; did you mean `iterations`?"
        );
    }

    #[derive(Debug, Default, serde::Deserialize, JsonSchema)]
    #[serde(default, deny_unknown_fields)]
    struct Doses {
        critical_dose_mj_per_mm3: f64,
        peak_mw_per_mm2: f64,
        radius_mm: f64,
    }

    #[test]
    fn a_key_of_another_unit_is_not_only_misspelt() {
        for (key, why) in [
            ("critical_dose_mj_per_cm2", Some("a dose per area")),
            ("peak_mw_per_cm2", Some("1 per cm² is 0.01 per mm²")),
            ("peak_mw_per_m2", Some("another unit")),
            ("diameter_mm", Some("half of it is meant")),
            ("peak_mv_per_mm2", None),
        ] {
            let section = Section::new("resin", json!({ key: 80.0 }));
            let Err(Error::Config { found, nearest, .. }) = section.parse::<Doses>() else {
                panic!("{key} was accepted")
            };
            assert!(nearest.is_some(), "{key}");
            let is_explained = why.is_some_and(|why| found.contains(why));
            assert_eq!(is_explained, why.is_some(), "{key}: {found}");
            assert_eq!(found == format!("unknown name `{key}`"), why.is_none());
        }
        let section = Section::new("resin", json!({}));
        let doses = section.parse::<Doses>().unwrap();
        assert_eq!(doses.critical_dose_mj_per_mm3, doses.peak_mw_per_mm2);
    }

    #[derive(Debug, serde::Deserialize, JsonSchema)]
    #[serde(rename_all = "lowercase")]
    enum Direction {
        Up,
        Down,
    }

    #[derive(Debug, serde::Deserialize, JsonSchema)]
    #[serde(deny_unknown_fields)]
    struct Route {
        #[serde(rename = "ways")]
        _ways: Vec<Direction>,
        #[serde(rename = "size", default)]
        _size: [f64; 2],
    }

    #[test]
    fn what_is_accepted_is_said_in_words_of_a_job() {
        let text = |value| {
            let section = Section::new("route", value);
            section.parse::<Route>().unwrap_err().to_string()
        };
        for (value, expected) in [
            (
                json!({ "ways": ["up", 3] }),
                "route.ways[1]: found 3; accepted: up, down",
            ),
            (
                json!({ "ways": [{}] }),
                "route.ways[0]: found an empty table; accepted: exactly one of up, down",
            ),
            (
                json!({ "ways": [{ "up": 1, "down": 2 }] }),
                "route.ways[0]: found a table with down and up; accepted: exactly one of up, down",
            ),
            (
                json!({ "ways": 1e30 }),
                "route.ways: found 1e30; accepted: a list",
            ),
            (
                json!({ "ways": [], "size": [1.0, 2.0, 3.0] }),
                "route.size: found a list of 3; accepted: a list of 2",
            ),
            (
                json!({ "ways": [], "size": [] }),
                "route.size: found an empty list; accepted: a list of 2",
            ),
        ] {
            assert_eq!(text(value), expected);
        }
    }

    #[test]
    fn a_misspelt_key_beside_a_kind_is_no_second_kind() {
        let kind = |name| Kind {
            name,
            summary: "",
            example: "",
            schema: schema_of::<bool>,
            build: (),
        };
        let rows = [kind("fixed"), kind("free")];
        let text = |value| {
            let section = Section::new("stop", value).without(&["weight", "region"]);
            section.kind(&rows).unwrap_err().to_string()
        };
        assert_eq!(
            text(json!({ "fixed": {}, "wieght": 1 })),
            "stop.wieght: unknown name `wieght`; accepted: weight, region; did you mean `weight`?"
        );
        let both = text(json!({ "fixed": {}, "free": {} }));
        assert!(both.starts_with("stop: more than one entry"), "{both}");
    }

    #[test]
    fn a_missing_key_of_a_kind_is_shown_as_in_its_example() {
        static ROWS: &[Kind<()>] = &[Kind {
            name: "fixed",
            summary: "",
            example: "[stop.fixed]\niterations = 40",
            schema: schema_of::<bool>,
            build: (),
        }];
        let section = Section::new("stop", json!("fixed"));
        let (_, inner) = section.kind(ROWS).unwrap();
        assert_eq!(
            inner.parse::<Stop>().unwrap_err().to_string(),
            "stop.fixed.iterations: the key is missing; accepted: a value, for example `iterations = 40`"
        );
    }

    #[test]
    fn a_missing_key_and_a_wrong_type_are_named() {
        for (value, expected) in [
            (json!({}), "stop.iterations: the key is missing"),
            (
                json!({ "iterations": "many" }),
                "stop.iterations: found \"many\"; accepted: a whole number",
            ),
        ] {
            let text = Section::new("stop", value).parse::<Stop>().unwrap_err();
            let text = text.to_string();
            assert!(text.starts_with(expected), "{text}");
        }
        let section = Section::new("stop", json!({ "iterations": 4 }));
        assert_eq!(section.parse::<Stop>().unwrap().iterations, 4);
    }
}
