//! Where the keys of a job in JSON stand.

use crate::error::{Error, Result};
use crate::job::spec::document::{Document, join};
use std::ops::Range;

/// Walks a JSON text that is known to be well-formed, to learn where its keys stand.
pub(crate) struct JsonPlaces<'t> {
    pub(crate) text: &'t str,
    pub(crate) at: usize,
    pub(crate) document: &'t mut Document,
}

impl JsonPlaces<'_> {
    fn peek(&mut self) -> u8 {
        let bytes = self.text.as_bytes();
        while bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        bytes.get(self.at).copied().unwrap_or(0)
    }

    /// Passes `,`, `:` and brackets.
    fn pass(&mut self) {
        self.peek();
        self.at += 1;
    }

    fn string(&mut self) -> Range<usize> {
        self.peek();
        let start = self.at;
        let mut escaped = false;
        for byte in &self.text.as_bytes()[(start + 1).min(self.text.len())..] {
            self.at += 1;
            match byte {
                b'"' if !escaped => break,
                b'\\' => escaped = !escaped,
                _ => escaped = false,
            }
        }
        self.at += 1;
        start..self.at.min(self.text.len())
    }

    pub(crate) fn value(&mut self, path: &str) -> Result<Range<usize>> {
        let first = self.peek();
        let start = self.at;
        match first {
            b'{' => self.object(path)?,
            b'[' => self.array(path)?,
            b'"' => {
                self.string();
            }
            _ => {
                let rest = &self.text[start..];
                self.at += rest
                    .find([',', '}', ']', ' ', '\n', '\r', '\t'])
                    .unwrap_or(rest.len());
            }
        }
        Ok(start..self.at)
    }

    fn object(&mut self, path: &str) -> Result<()> {
        let mut seen = std::collections::BTreeSet::new();
        self.pass();
        while self.peek() == b'"' {
            let key = self.string();
            let name: String = serde_json::from_str(&self.text[key.clone()]).unwrap_or_default();
            let inner = join(path, &name);
            if !seen.insert(name) {
                return Err(Error::Config {
                    key: inner,
                    found: "the key appears here a second time".to_owned(),
                    accepted: "each key once".to_owned(),
                    nearest: None,
                    place: Some(self.document.place(key)),
                });
            }
            self.pass();
            let value = self.value(&inner)?;
            self.document.remember(&inner, key, value);
            if self.peek() == b',' {
                self.pass();
            }
        }
        self.pass();
        Ok(())
    }

    fn array(&mut self, path: &str) -> Result<()> {
        self.pass();
        let mut index = 0;
        while !matches!(self.peek(), b']' | 0) {
            let inner = format!("{path}[{index}]");
            let value = self.value(&inner)?;
            self.document.remember(&inner, value.clone(), value);
            index += 1;
            if self.peek() == b',' {
                self.pass();
            }
        }
        self.pass();
        Ok(())
    }
}
