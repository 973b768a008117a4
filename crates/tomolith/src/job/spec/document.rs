//! The text of a job: TOML or JSON → one tree of values that remembers where each key stands.
//!
//! ```
//! use tomolith::job::Document;
//! let mut job = Document::toml("part.toml", "[stop]\niterations = 40\n").unwrap();
//! let wrong = tomolith::Error::config("stop.iterations", "found 40", "something else");
//! // The key stands in the second line of the file:
//! assert!(job.locate(wrong).to_string().ends_with("(part.toml, line 2)"));
//! job.set("stop.iterations=10").unwrap();
//! assert_eq!(job.root["stop"]["iterations"], 10);
//! ```
//!
//! JSON has the same keys. Duplicate keys, dates and numbers that are not finite are refused in both. Key paths are
//! dotted, elements of lists are counted from 0: `light[0].pixels[1]`.

use super::profiles;
use crate::error::{Error, Place, Result};
use crate::io::mesh::is_mesh;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};
use tomolith_core::files::read_at_most;

use json_places::JsonPlaces;
use key_path::replaced_by;
pub(crate) use key_path::{at, is_within, join, parent, put};

mod json_places;
mod key_path;

/// Largest file that is read as a job.
const MOST_MB: u64 = 8;

/// A job's text, its values, and where they stand.
#[derive(Clone, Debug)]
pub struct Document {
    /// The file as the user named it.
    pub file: PathBuf,
    /// Its content.
    pub text: String,
    /// All values, overrides included.
    pub root: Value,
    /// Whether people can look up a line of the text.
    is_file: bool,
    places: BTreeMap<String, Range<usize>>,
    /// Key path → the option of the command line that set it, as it was typed.
    overrides: BTreeMap<String, String>,
}

/// What a target can be; a job names one of them.
pub(crate) const TARGETS: [&str; 5] = ["mesh", "phantom", "image", "stack", "body"];

impl Document {
    /// Reads a file: JSON when its name ends in `.json`, TOML otherwise.
    ///
    /// # Errors
    /// [`Error::Io`] when it cannot be read; [`Error::Config`] with file and line when it is no TOML or JSON.
    pub fn read(file: &Path) -> Result<Self> {
        if file.is_dir() {
            let job = file.join("job.toml");
            let accepted = if job.is_file() {
                format!("a job file, such as {}", job.display())
            } else {
                "a job file in TOML or JSON".to_owned()
            };
            return Err(Error::Format {
                path: file.to_owned(),
                found: "a folder".to_owned(),
                accepted,
            });
        }
        if file.is_file() && is_mesh(file) {
            let mesh = file.display();
            return Err(Error::Format {
                path: file.to_owned(),
                found: "a mesh".to_owned(),
                accepted: format!(
                    "a job file; `tomolith new job.toml --part {mesh}` writes one that prints the mesh"
                ),
            });
        }
        let bytes = read_at_most(file, MOST_MB)?;
        Self::from_bytes(file, bytes)
    }

    /// Reads standard input: JSON where it begins with a brace, TOML otherwise. In messages it is `stdin.toml` or `stdin.json`.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn from_stdin() -> Result<Self> {
        let input = Path::new("standard input");
        let most = MOST_MB * 1_000_000;
        let mut bytes = Vec::new();
        std::io::stdin()
            .take(most + 1)
            .read_to_end(&mut bytes)
            .map_err(|e| Error::io(input, e))?;
        if bytes.len() as u64 > most {
            return Err(Error::Format {
                path: input.to_owned(),
                found: format!("more than {MOST_MB} MB"),
                accepted: "a job in TOML or JSON".to_owned(),
            });
        }
        let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace());
        let name = if first == Some(&b'{') {
            "stdin.json"
        } else {
            "stdin.toml"
        };
        Self::from_bytes(Path::new(name), bytes)
    }

    /// The content of a file whose name says which language it is in.
    ///
    /// # Errors
    /// [`Error::Config`] with file and line when it is no TOML or JSON in UTF-8.
    pub fn from_bytes(file: &Path, bytes: Vec<u8>) -> Result<Self> {
        let text = String::from_utf8(bytes).map_err(|e| {
            let good = e.utf8_error().valid_up_to();
            let line = 1 + e.as_bytes()[..good].iter().filter(|&&b| b == b'\n').count();
            Error::Config {
                key: String::new(),
                found: "bytes that are not UTF-8 text".to_owned(),
                accepted: "TOML or JSON, encoded in UTF-8".to_owned(),
                nearest: None,
                place: Some(Place {
                    file: file.to_owned(),
                    line,
                    span: good..good,
                }),
            }
        })?;
        let is_json = file
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("json"));
        if is_json {
            Self::json(file, text)
        } else {
            Self::toml(file, text)
        }
    }

    /// A job in TOML; `file` is only used in messages.
    ///
    /// # Errors
    /// [`Error::Config`] with line and span: syntax, a key twice, a date, a number that is not finite.
    pub fn toml(file: impl Into<PathBuf>, text: impl Into<String>) -> Result<Self> {
        let mut document = Document::empty(file.into(), text.into());
        let text = document.text.clone();
        let table = toml::de::DeTable::parse(&text).map_err(|e| {
            document.syntax(
                e.span().unwrap_or(0..0),
                e.message(),
                "TOML, with each key once",
            )
        })?;
        document.root = document.toml_table(table.get_ref(), "")?;
        Ok(document)
    }

    /// A job in JSON; `file` is only used in messages.
    ///
    /// # Errors
    /// [`Error::Config`] with line and span: syntax, a key twice.
    pub fn json(file: impl Into<PathBuf>, text: impl Into<String>) -> Result<Self> {
        let mut document = Document::empty(file.into(), text.into());
        document.root = serde_json::from_str(&document.text).map_err(|e| {
            let at = document.offset(e.line(), e.column());
            document.syntax(at..at, &e.to_string(), "JSON, with each key once")
        })?;
        if !document.root.is_object() {
            return Err(document.syntax(
                0..0,
                "a JSON value that is not an object",
                "an object {…} with the keys of a job",
            ));
        }
        let text = document.text.clone();
        let mut walk = JsonPlaces {
            text: &text,
            at: 0,
            document: &mut document,
        };
        walk.value("")?;
        Ok(document)
    }

    /// Tables that a program made, as JSON. Messages name keys and no line, since no file holds the text; `file` says what the job is called, and
    /// where its paths begin.
    ///
    /// # Errors
    /// As [`json`](Self::json), without a place.
    pub fn tables(file: impl Into<PathBuf>, text: impl Into<String>) -> Result<Self> {
        let mut document = Document::json(file, text).map_err(|mut error| {
            if let Error::Config { place, .. } = &mut error {
                *place = None;
            }
            error
        })?;
        document.places.clear();
        document.is_file = false;
        Ok(document)
    }

    /// Sets one key, as `--set` does: `stop.iterations=10`, `light[0].angles=360`, `output.folder=out/b`.
    ///
    /// The value is read as TOML, and as a plain string when it is none. A list with one element needs no index. A kind of
    /// which a job has one (`vial.square={…}`, `target.mesh=part.stl`) takes the place of the job's.
    ///
    /// # Errors
    /// [`Error::Config`] that names the override.
    pub fn set(&mut self, assignment: &str) -> Result<()> {
        // The job names a profile and sets a key as well
        profiles::open(&mut self.root);
        let option = format!("--set {assignment}");
        let no = |found: &str, accepted: &str| Err(Error::config(&option, found, accepted));
        let refuse = |found| {
            let accepted = "KEY=VALUE with a dotted key, for example stop.iterations=10";
            no(found, accepted)
        };
        let Some((key, text)) = assignment.split_once('=') else {
            return refuse("no `=` in it");
        };
        let value = match self.override_value(text.trim()) {
            Ok(value) => value,
            Err(Misread::Lines) => return refuse("more than one line"),
            Err(Misread::Value { found, accepted }) => return no(&found, &accepted),
        };
        match put(&mut self.root, key.trim(), value) {
            Ok(path) => {
                self.forget_replaced(&path);
                self.overridden(&path, option);
                Ok(())
            }
            Err([found, accepted]) => no(&found, &accepted),
        }
    }

    /// What [`Document::set`] takes to give a key a value: TOML in one line, where null, of which TOML has none, stays a word that is refused.
    ///
    /// ```
    /// use tomolith::job::Document;
    /// let value = serde_json::json!({ "ospw": { "w": 0.5, "a b": ["x\"y", true, 1e-7] } });
    /// let mut job = Document::toml("part.toml", "").unwrap();
    /// job.set(&Document::assignment("objective", &value)).unwrap();
    /// assert_eq!(job.root["objective"], value);
    /// ```
    #[must_use]
    pub fn assignment(key: &str, value: &Value) -> String {
        format!("{key}={}", in_line(value))
    }

    /// Remembers that a key comes from an option of the command line: what the file says there is no longer at fault.
    pub fn overridden(&mut self, path: &str, option: String) {
        self.places.retain(|key, _| !is_within(key, path));
        self.overrides.retain(|key, _| !is_within(key, path));
        self.overrides.insert(path.to_owned(), option);
    }

    /// The option of the command line that set a key, if any.
    #[must_use]
    pub fn option(&self, path: &str) -> Option<&str> {
        self.overrides.get(path).map(String::as_str)
    }

    /// The option that set a key or, for a table or list, something in it.
    fn option_for(&self, path: &str) -> Option<&String> {
        let within = |key: &&String| !path.is_empty() && is_within(key, path);
        let inner = self.overrides.keys().find(within)?;
        self.overrides.get(inner)
    }

    /// Forgets where keys stood whose place a kind of the command line took; makes the file of a target relative to the current folder.
    fn forget_replaced(&mut self, path: &str) {
        let Some((family, is_replaced)) = replaced_by(path) else {
            return;
        };
        if (family == "target" || family.ends_with(".target"))
            && !path.ends_with(".phantom")
            && let Some(Value::String(file)) = at(&mut self.root, path)
            && let Ok(absolute) = std::path::absolute(&*file)
        {
            *file = absolute.to_string_lossy().into_owned();
        }
        let is_gone = |key: &str| {
            let key = key
                .strip_prefix(family)
                .and_then(|key| key.strip_prefix('.'));
            key.is_some_and(|key| is_replaced(key.split(['.', '[']).next().unwrap_or(key)))
        };
        self.places.retain(|key, _| !is_gone(key));
        self.overrides.retain(|key, _| !is_gone(key));
    }

    /// Adds file, line and span to an [`Error::Config`] whose key (or a part of it) stands in this document; names the
    /// option of the command line instead when that is where the value came from. Other errors, and those about options
    /// themselves (`--resume`), pass unchanged.
    #[must_use]
    pub fn locate(&self, mut error: Error) -> Error {
        let Error::Config {
            key, found, place, ..
        } = &mut error
        else {
            return error;
        };
        if place.is_some() || key.starts_with("--") {
            return error;
        }
        // An error that names its option, or its place, stays as it is
        let mut name = |option: &str| {
            let from = format!(" (from {option})");
            if !found.ends_with(&from) {
                found.push_str(&from);
            }
        };
        if let Some(option) = self.option_for(key) {
            name(option);
            return error;
        }
        let mut path = key.as_str();
        loop {
            if let Some(option) = self.overrides.get(path) {
                name(option);
                break;
            }
            if let Some(span) = self.places.get(path) {
                *place = Some(self.place(span.clone()));
                found.push_str(&self.with_options(key, path));
                break;
            }
            if path.is_empty() {
                *place = self.is_file.then(|| self.place(0..0));
                break;
            }
            path = parent(path);
        }
        error
    }

    /// What the command line says of a table that is blamed: anything may be the reason why it does not fit the rest of the job,
    /// and what is in it why a key is missing there.
    fn with_options(&self, key: &str, path: &str) -> String {
        let is_table = self.places.keys().any(|k| k != path && is_within(k, path));
        let options = self.overrides.iter();
        // Where results go and what they may take is no reason
        let is_aside = |k: &str| {
            ["output", "resources", "checkpoint"]
                .iter()
                .any(|t| is_within(k, t))
        };
        let options = options.filter(|(k, _)| is_table && !is_aside(k));
        let options = options.filter(|(k, _)| key == path || is_within(k, path));
        let options: Vec<&str> = options.map(|(_, option)| option.as_str()).collect();
        if options.is_empty() {
            return String::new();
        }
        format!(" (with {})", options.join(", "))
    }

    fn empty(file: PathBuf, text: String) -> Self {
        Document {
            file,
            text,
            root: Value::Null,
            is_file: true,
            places: BTreeMap::new(),
            overrides: BTreeMap::new(),
        }
    }

    fn place(&self, span: Range<usize>) -> Place {
        let start = span.start.min(self.text.len());
        let line = 1 + self.text.as_bytes()[..start]
            .iter()
            .filter(|&&b| b == b'\n')
            .count();
        Place {
            file: self.file.clone(),
            line,
            span,
        }
    }

    fn syntax(&self, span: Range<usize>, found: &str, accepted: &str) -> Error {
        Error::Config {
            key: String::new(),
            found: found.to_owned(),
            accepted: accepted.to_owned(),
            nearest: None,
            place: Some(self.place(span)),
        }
    }

    /// Byte offset of line and column (both counted from 1, as `serde_json` does).
    fn offset(&self, line: usize, column: usize) -> usize {
        let before: usize = self
            .text
            .split_inclusive('\n')
            .take(line.saturating_sub(1))
            .map(str::len)
            .sum();
        (before + column.saturating_sub(1)).min(self.text.len())
    }

    /// Remembers where `key = value` stands: the whole of it when it is on one line, the key alone otherwise.
    fn remember(&mut self, path: &str, key: Range<usize>, value: Range<usize>) {
        let whole = key.start.min(value.start)..key.end.max(value.end);
        let one_line = self
            .text
            .get(whole.clone())
            .is_some_and(|t| !t.contains('\n'));
        let span = if one_line && value.start >= key.start {
            whole
        } else {
            key
        };
        self.places.entry(path.to_owned()).or_insert(span);
    }

    fn toml_table(&mut self, table: &toml::de::DeTable<'_>, path: &str) -> Result<Value> {
        let mut map = Map::new();
        for (key, value) in table {
            let inner = join(path, key.get_ref());
            self.remember(&inner, key.span(), value.span());
            let value = self.toml_value(value, &inner)?;
            map.insert(key.get_ref().to_string(), value);
        }
        Ok(Value::Object(map))
    }

    fn toml_value(
        &mut self,
        value: &toml::Spanned<toml::de::DeValue<'_>>,
        path: &str,
    ) -> Result<Value> {
        use toml::de::DeValue;
        let refuse = |found: String, accepted: &str| {
            Err(Error::Config {
                key: path.to_owned(),
                found,
                accepted: accepted.to_owned(),
                nearest: None,
                place: Some(self.place(value.span())),
            })
        };
        match value.get_ref() {
            DeValue::String(text) => Ok(Value::String(text.to_string())),
            DeValue::Boolean(flag) => Ok(Value::Bool(*flag)),
            DeValue::Integer(number) => {
                match i64::from_str_radix(number.as_str(), number.radix()) {
                    Ok(number) => Ok(Value::from(number)),
                    Err(_) => refuse(
                        format!("found {}", number.as_str()),
                        "a whole number of at most 63 bits",
                    ),
                }
            }
            DeValue::Float(number) => match number
                .as_str()
                .parse::<f64>()
                .ok()
                .and_then(serde_json::Number::from_f64)
            {
                Some(number) => Ok(Value::Number(number)),
                None => refuse(format!("found {}", number.as_str()), "a finite number"),
            },
            DeValue::Datetime(date) => refuse(
                format!("found the date {date}"),
                "a number, text, a list or a table",
            ),
            DeValue::Array(list) => {
                let mut values = Vec::with_capacity(list.len());
                for (i, element) in list.iter().enumerate() {
                    let inner = format!("{path}[{i}]");
                    self.remember(&inner, element.span(), element.span());
                    values.push(self.toml_value(element, &inner)?);
                }
                Ok(Value::Array(values))
            }
            DeValue::Table(table) => self.toml_table(table, path),
        }
    }

    /// The value of an override: TOML when it is some, text otherwise.
    fn override_value(&self, text: &str) -> Result<Value, Misread> {
        let document = match Document::toml("--set", format!("value = {text}")) {
            Ok(document) => document,
            // NaN and dates are TOML, but no value of a job
            Err(Error::Config {
                found, accepted, ..
            }) if toml::de::DeValue::parse(text).is_ok() => {
                return Err(Misread::Value { found, accepted });
            }
            Err(_) => return Ok(Value::String(text.to_owned())),
        };
        match document.root {
            Value::Object(mut map) if map.len() == 1 => Ok(map.remove("value").unwrap_or_default()),
            _ => Err(Misread::Lines),
        }
    }
}

/// Why an override has no value.
enum Misread {
    Lines,
    Value { found: String, accepted: String },
}

/// A value as TOML in one line.
fn in_line(value: &Value) -> String {
    match value {
        Value::Array(list) => {
            let list: Vec<String> = list.iter().map(in_line).collect();
            format!("[{}]", list.join(", "))
        }
        Value::Object(table) => {
            let entry = |(key, value): (&String, &Value)| {
                format!("{} = {}", Value::from(key.as_str()), in_line(value))
            };
            let entries: Vec<String> = table.iter().map(entry).collect();
            format!("{{ {} }}", entries.join(", "))
        }
        // Its escapes are TOML's, too
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::JobSpec;
    use tomolith_core::check::fuzz::{mutate, rounds};

    const JOB: &str = "title = \"a\"\n\n[vial.cylinder]\ninner_radius_mm = 7.6\n\n[[light]]\nangles = 300\n[[light]]\nangles = { count = 4 }\n";

    fn line_of(document: &Document, key: &str) -> usize {
        match document.locate(Error::config(key, "", "")) {
            Error::Config {
                place: Some(place), ..
            } => place.line,
            other => panic!("no place: {other}"),
        }
    }

    #[test]
    fn a_key_with_dots_in_it_is_the_key_that_a_path_means() {
        let text = "[[scenario]]\nset = { \"motion.offset_mm\" = [0.1, 0.0] }\n";
        let mut document = Document::toml("a.toml", text).unwrap();
        document
            .set("scenario[0].set.motion.offset_mm=[0.3, 0.0]")
            .unwrap();
        let set = document.root.pointer("/scenario/0/set").unwrap();
        assert_eq!(*set, serde_json::json!({ "motion.offset_mm": [0.3, 0.0] }));
    }

    #[test]
    fn every_key_has_its_line_and_a_missing_one_that_of_its_table() {
        let document = Document::toml("a.toml", JOB).unwrap();
        assert_eq!(line_of(&document, "vial.cylinder.inner_radius_mm"), 4);
        assert_eq!(line_of(&document, "vial.cylinder.outer_radius_mm"), 3);
        assert_eq!(line_of(&document, "light[0].angles"), 7);
        assert_eq!(line_of(&document, "light[1].angles.count"), 9);
        assert_eq!(line_of(&document, "grid.pitch_mm"), 1);
        let Error::Config {
            place: Some(place), ..
        } = document.locate(Error::config("vial.cylinder.inner_radius_mm", "", ""))
        else {
            panic!("no place")
        };
        assert_eq!(&JOB[place.span], "inner_radius_mm = 7.6");
    }

    #[test]
    fn json_has_the_same_values_and_its_own_lines() {
        let text = "{\"title\": \"a\",\n \"vial\": {\"cylinder\": {\n  \"inner_radius_mm\": 7.6}},\n \"light\": [{\"angles\": 300},\n {\"angles\": {\"count\": 4}}]}";
        let json = Document::json("a.json", text).unwrap();
        assert_eq!(json.root, Document::toml("a.toml", JOB).unwrap().root);
        assert_eq!(line_of(&json, "vial.cylinder.inner_radius_mm"), 3);
        assert_eq!(line_of(&json, "light[1].angles.count"), 5);
        let text = Document::json("a.json", "{\"a\": 1,\n\"b\": \"\\\\\", \"a\": 2}")
            .unwrap_err()
            .to_string();
        assert!(
            text.starts_with("a: the key appears here a second time")
                && text.ends_with("(a.json, line 2)"),
            "{text}"
        );
        let text = Document::json("a.json", "{\n\"a\": }")
            .unwrap_err()
            .to_string();
        assert!(text.ends_with("(a.json, line 2)"), "{text}");
    }

    #[test]
    fn tables_without_a_file_have_no_lines() {
        let mut tables = Document::tables("a.json", "{\"grid\": {\"pitch_mm\": 1.0}}").unwrap();
        let message =
            |of: &Document, key: &str| of.locate(Error::config(key, "found x", "y")).to_string();
        for key in ["grid.pitch_mm", "vial", ""] {
            let located = message(&tables, key);
            assert!(!located.contains("a.json"), "{located}");
        }
        tables.set("grid.pitch_mm=2.0").unwrap();
        assert!(message(&tables, "grid.pitch_mm").contains("(from --set grid.pitch_mm=2.0)"));
        let refused = Document::tables("a.json", "{\"a\": 1, \"a\": 2}").unwrap_err();
        assert!(!refused.to_string().contains("line"), "{refused}");
    }

    #[test]
    fn what_no_job_can_hold_is_refused_with_its_key_and_line() {
        for (text, start) in [
            (
                "\n[a]\nb = nan",
                "a.b: found nan; accepted: a finite number (j.toml, line 3)",
            ),
            (
                "a = [1, inf]",
                "a[1]: found inf; accepted: a finite number (j.toml, line 1)",
            ),
            (
                "a = 1e999",
                "a: found 1e999; accepted: a finite number (j.toml, line 1)",
            ),
            ("a = 2026-11-21", "a: found the date 2026-11-21"),
            ("a = 1\na = 2", "file: duplicate key"),
            ("a = ", "file: "),
        ] {
            let message = Document::toml("j.toml", text).unwrap_err().to_string();
            assert!(message.starts_with(start), "{text:?}: {message}");
        }
        let error =
            Document::from_bytes(Path::new("j.toml"), b"a = 1\nb = \"\xff\"".to_vec()).unwrap_err();
        assert!(error.to_string().ends_with("(j.toml, line 2)"), "{error}");
    }

    #[test]
    fn overrides_are_typed_and_name_themselves() {
        let mut document = Document::toml("a.toml", JOB).unwrap();
        document.root["light"].as_array_mut().unwrap().pop();
        for assignment in [
            "stop.iterations=10",
            "grid.pitch_mm=0.5 mm",
            "light.angles={ count = 3 }",
            "light[0].pixels=[4, 5]",
            "target.phantom=gear",
        ] {
            document.set(assignment).unwrap();
        }
        assert_eq!(document.root["stop"]["iterations"], 10);
        assert_eq!(document.root["grid"]["pitch_mm"], "0.5 mm");
        assert_eq!(document.root["light"][0]["angles"]["count"], 3);
        assert_eq!(document.root["light"][0]["pixels"][1], 5);
        assert_eq!(document.root["target"]["phantom"], "gear");
        let message = document
            .locate(Error::config("light[0].pixels", "found 4", "more"))
            .to_string();
        tomolith_core::contains!(message, "from --set light[0].pixels=[4, 5]");
        // What is inside an overridden list, and what an override changed inside a table, is not blamed on the file
        for (key, option) in [
            ("light[0].pixels[1]", "(from --set light[0].pixels=[4, 5])"),
            (
                "light[0].angles.count",
                "(from --set light.angles={ count = 3 })",
            ),
            ("grid", "(from --set grid.pitch_mm=0.5 mm)"),
        ] {
            let located = document.locate(Error::config(key, "x", "y"));
            let message = located.to_string();
            // Located once, whoever locates it again
            assert_eq!(document.locate(located).to_string(), message);
            assert_eq!(message, format!("{key}: x {option}; accepted: y"));
        }
        assert_eq!(line_of(&document, "vial.cylinder"), 3);
        for (wrong, end) in [
            (
                "light[7].angles=3",
                "`light` has 1 element; accepted: `light[0]`, the first one",
            ),
            (
                "scenario[0].name=3",
                "`scenario` has 0 elements; accepted: a whole list: scenario=[…]",
            ),
            (
                "title.x=3",
                "`title` is \"a\", not a table; accepted: a key of a table",
            ),
        ] {
            let message = document.set(wrong).unwrap_err().to_string();
            assert_eq!(message, format!("--set {wrong}: {end}"));
        }
        for wrong in [
            "stop.iterations",
            "=3",
            "a..b=3",
            "title.x=3",
            "light[7].angles=3",
            "a=nan",
            "a[x]=1",
            "a=1\nb=2",
        ] {
            let message = document.set(wrong).unwrap_err().to_string();
            assert!(message.starts_with(&format!("--set {wrong}")), "{message}");
        }
        assert!(
            document
                .set(&format!("{}=1", vec!["a"; 5000].join(".")))
                .is_err()
        );
    }

    #[test]
    fn a_kind_of_the_command_line_takes_the_place_of_the_files() {
        let text = "response = \"identity\"\n[vial]\nsurrounding_index = 1.4\n[vial.cylinder]\ninner_radius_mm = 7.6\n\
                    [[light]]\nprojector.lens = {}\n[target]\nphantom = \"gear\"\n\
                    [[objectives]]\nweight = 2\nl2 = {}\n[[species]]\ntarget.phantom = {}\n";
        let mut document = Document::toml("a.toml", text).unwrap();
        for assignment in [
            "vial.square={ inner_width_mm = 9 }",
            "light[0].projector.collimated={}",
            "response.logistic={}",
            "target.phantom.gyroid={ cells = 2 }",
            "objectives[0].threshold={}",
            "species[0].target.mesh=/part.stl",
        ] {
            document.set(assignment).unwrap();
        }
        let expected = serde_json::json!({
            "response": { "logistic": {} },
            "vial": { "surrounding_index": 1.4, "square": { "inner_width_mm": 9 } },
            "light": [{ "projector": { "collimated": {} } }],
            "target": { "phantom": { "gyroid": { "cells": 2 } } },
            "objectives": [{ "weight": 2, "threshold": {} }],
            "species": [{ "target": { "mesh": "/part.stl" } }],
        });
        assert_eq!(document.root, expected);
        // A table that does not fit the rest, or lacks a key, may do so for what the command line says
        let message_of = |key| document.locate(Error::config(key, "x", "y")).to_string();
        assert!(message_of("light").contains("x (from --set light[0].projector"));
        let mut document = Document::toml("a.toml", text).unwrap();
        document.set("grid.pitch_mm=50").unwrap();
        let message_of = |key| document.locate(Error::config(key, "x", "y")).to_string();
        assert!(message_of("target").contains("x (with --set grid.pitch_mm=50)"));
        assert!(!message_of("target.height_mm").contains("--set"));
        assert!(!message_of("target.phantom").contains("--set"));
    }

    #[test]
    fn deep_nesting_does_not_overflow_the_stack() {
        for (open, close) in [("[", "]"), ("{a=", "}"), ("{\"a\":", "}")] {
            let deep = format!("{}1{}", open.repeat(100_000), close.repeat(100_000));
            assert!(Document::toml("j.toml", format!("x = {deep}")).is_err());
            assert!(Document::json("j.json", deep).is_err());
        }
        assert!(Document::toml("j.toml", format!("{} = 1", vec!["a"; 100_000].join("."))).is_err());
        assert!(Document::toml("j.toml", format!("[{}]", vec!["a"; 100_000].join("."))).is_err());
    }

    /// Mutated bytes of real jobs: an error or a job, never a panic. `TOMOLITH_FUZZ_SECONDS` makes it longer.
    #[test]
    fn hostile_bytes_never_panic() {
        let json =
            serde_json::to_string_pretty(&Document::toml("a.toml", JOB).unwrap().root).unwrap();
        let full = crate::job::tests::FULL;
        let seeds = [("a.toml", full), ("a.toml", JOB), ("a.json", &json)];
        let [read, tried] = rounds(1.0, |random| {
            let (file, text) = seeds[random.below(seeds.len())];
            let mut bytes = text.as_bytes().to_vec();
            mutate(&mut bytes, random);
            let document = Document::from_bytes(Path::new(file), bytes);
            let spec = document.as_ref().map(JobSpec::from_document);
            drop(spec.map(|spec| spec.map_err(|e| e.to_string())));
            document.is_ok()
        });
        assert!(
            tried > 100 && read > 0 && read < tried,
            "tried {tried}, read {read}"
        );
    }
}
