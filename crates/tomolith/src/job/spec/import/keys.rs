//! A table of the other program's job, whose keys are taken one by one: what is left at the end is noted by name.

use crate::error::{Error, Result, nearest_name};
use serde_json::{Map, Value};

/// Keys of a table that are still to be mapped.
pub(crate) struct Keys {
    path: String,
    left: Map<String, Value>,
    known: Vec<&'static str>,
}

/// A count that is written with a point.
fn whole(value: &Value) -> Option<u64> {
    let number = value.as_f64()?;
    let is_whole = number.fract() == 0.0 && (0.0..1e15).contains(&number);
    is_whole.then_some(number as u64)
}

impl Keys {
    pub(crate) fn new(path: &str, value: Value) -> Result<Self> {
        match value {
            Value::Object(mut left) => {
                // `null` is what a key is there when it is left out
                left.retain(|_, value| !value.is_null());
                Ok(Keys {
                    path: path.to_owned(),
                    left,
                    known: Vec::new(),
                })
            }
            other => Err(Error::config(path, format!("found {other}"), "a table")),
        }
    }

    pub(crate) fn key(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    pub(crate) fn take(&mut self, key: &'static str) -> Option<Value> {
        self.known.push(key);
        self.left.remove(key)
    }

    pub(crate) fn wrong<T>(
        &self,
        key: &str,
        found: impl std::fmt::Display,
        accepted: &str,
    ) -> Result<T> {
        Err(Error::config(
            self.key(key),
            format!("found {found}"),
            accepted,
        ))
    }

    pub(crate) fn needed<T>(&self, key: &str, found: Option<T>) -> Result<T> {
        match found {
            Some(value) => Ok(value),
            None => Err(Error::config(
                self.key(key),
                "the key is missing",
                "a job of Dr.TVAM, in which this key has a value",
            )),
        }
    }

    pub(crate) fn number(&mut self, key: &'static str) -> Result<Option<f64>> {
        match self.take(key) {
            None => Ok(None),
            Some(value) => match value.as_f64() {
                Some(number) => Ok(Some(number)),
                None => self.wrong(key, value, "a number"),
            },
        }
    }

    pub(crate) fn number_or(&mut self, key: &'static str, default: f64) -> Result<f64> {
        Ok(self.number(key)?.unwrap_or(default))
    }

    pub(crate) fn need_number(&mut self, key: &'static str) -> Result<f64> {
        let number = self.number(key)?;
        self.needed(key, number)
    }

    /// A length, an index or an exponent.
    pub(crate) fn positive_or(&mut self, key: &'static str, default: f64) -> Result<f64> {
        let number = self.number_or(key, default)?;
        match number > 0.0 && number.is_finite() {
            true => Ok(number),
            false => self.wrong(key, number, "a number > 0"),
        }
    }

    pub(crate) fn need_positive(&mut self, key: &'static str) -> Result<f64> {
        match self.left.contains_key(key) {
            true => self.positive_or(key, 1.0),
            false => self.needed(key, None),
        }
    }

    pub(crate) fn count(&mut self, key: &'static str, default: u64) -> Result<u64> {
        match self.take(key) {
            None => Ok(default),
            Some(value) => match value.as_u64().or_else(|| whole(&value)) {
                Some(count) => Ok(count),
                None => self.wrong(key, value, "a whole number"),
            },
        }
    }

    pub(crate) fn flag(&mut self, key: &'static str, default: bool) -> Result<bool> {
        match self.take(key) {
            None => Ok(default),
            Some(Value::Bool(flag)) => Ok(flag),
            Some(other) => self.wrong(key, other, "true or false"),
        }
    }

    pub(crate) fn text(&mut self, key: &'static str) -> Result<Option<String>> {
        match self.take(key) {
            None => Ok(None),
            Some(Value::String(text)) => Ok(Some(text)),
            Some(other) => self.wrong(key, other, "a text"),
        }
    }

    pub(crate) fn need_text(&mut self, key: &'static str) -> Result<String> {
        let text = self.text(key)?;
        self.needed(key, text)
    }

    pub(crate) fn table(&mut self, key: &'static str) -> Result<Option<Keys>> {
        let path = self.key(key);
        self.take(key).map(|v| Keys::new(&path, v)).transpose()
    }

    pub(crate) fn need_table(&mut self, key: &'static str) -> Result<Keys> {
        let table = self.table(key)?;
        self.needed(key, table)
    }

    /// Keys that mean nothing here; a switch that is off gets no note.
    pub(crate) fn leave_out(&mut self, keys: &[&'static str], why: &str, notes: &mut Vec<String>) {
        let mut found = Vec::new();
        for key in keys {
            if self.take(key).is_some_and(|value| value != false) {
                found.push(self.key(key));
            }
        }
        if !found.is_empty() {
            let are = if found.len() == 1 { "is" } else { "are" };
            notes.push(format!("{} {are} left out: {why}", found.join(", ")));
        }
    }

    /// Switches that must be off, as they are when they are left out.
    pub(crate) fn must_be_off(&mut self, keys: &[&'static str]) -> Result<()> {
        for key in keys {
            if let Some(value) = self.take(key).filter(|value| *value != false) {
                return self.wrong(key, value, "false, as when it is left out");
            }
        }
        Ok(())
    }

    /// Notes what is left: keys that Dr.TVAM does not read.
    pub(crate) fn finish(self, notes: &mut Vec<String>) {
        for key in self.left.keys() {
            let hint = nearest_name(key, self.known.iter().copied())
                .map_or_else(String::new, |name| format!("; did you mean `{name}`?"));
            notes.push(format!(
                "{} is left out: Dr.TVAM does not read it{hint}",
                self.key(key)
            ));
        }
    }
}
