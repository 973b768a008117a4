//! What the commands that plan and calibrate found: lines for people, an object for programs, files where a folder is named.

use crate::arguments::Manner;
use crate::screen::{done, mutter, say};
use clap::Args;
use serde_json::{Value, json};
use std::path::PathBuf;
use tomolith::Result;
use tomolith::report::number::significant;
use tomolith_planning::measured::write_folder;

/// Where files of an answer go, and how it is told.
#[derive(Debug, Args)]
pub(crate) struct Files {
    /// New folder for tables (CSV, TOML) and plots (SVG)
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

/// What was found: lines of a name and a value for people, an object for programs.
#[derive(Default)]
pub(crate) struct Answer {
    lines: Vec<(String, String)>,
    warnings: Vec<String>,
    object: serde_json::Map<String, Value>,
}

impl Answer {
    pub(crate) fn line(&mut self, name: &str, text: impl Into<String>) {
        self.lines.push((name.to_owned(), text.into()));
    }

    /// A line of a number with so many digits.
    pub(crate) fn number(&mut self, name: &str, value: f64, digits: usize, unit: &str) {
        self.line(name, format!("{} {unit}", significant(value, digits)));
    }

    /// A line of a range.
    pub(crate) fn range(&mut self, name: &str, ends: [f64; 2], digits: usize, unit: &str) {
        let [low, high] = ends.map(|value| significant(value, digits));
        self.line(name, format!("{low} to {high} {unit}"));
    }

    pub(crate) fn warn(&mut self, text: impl Into<String>) {
        self.warnings.push(text.into());
    }

    pub(crate) fn set(&mut self, key: &str, value: impl serde::Serialize) {
        self.object.insert(key.to_owned(), json!(value));
    }

    /// Writes files where a folder is named, and says what was found.
    pub(crate) fn finish(mut self, to: &Files, files: &[(&str, String)]) -> Result<()> {
        if let Some(folder) = &to.output {
            write_folder(folder, files)?;
            let names: Vec<&str> = files.iter().map(|file| file.0).collect();
            self.line(
                "written",
                format!("{} in {}", names.join(", "), folder.display()),
            );
            self.set("folder", folder);
            self.set("files", names);
        }
        self.tell(to.manner);
        Ok(())
    }

    pub(crate) fn tell(mut self, manner: Manner) {
        let warnings = std::mem::take(&mut self.warnings);
        self.set("warnings", &warnings);
        done(manner, self.object, || {
            warnings
                .iter()
                .for_each(|text| mutter(&format!("{:>22} {text}", "warning")));
            self.lines
                .iter()
                .for_each(|(name, text)| say(&format!("{name:>22} {text}")));
        });
    }
}

/// A value with its error, where it has one.
pub(crate) fn with_error(value: f64, error: Option<f64>) -> String {
    match error.filter(|error| *error > 0.0) {
        Some(error) => format!("{} ± {}", significant(value, 4), significant(error, 2)),
        None => significant(value, 4),
    }
}

pub(crate) fn percent(share: f64) -> String {
    format!("{} %", significant(100.0 * share, 3))
}
