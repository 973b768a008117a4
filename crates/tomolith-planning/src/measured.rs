//! Tables that were measured: CSV files in, CSV text out.
//!
//! [`read_pairs`] reads two columns; [`Columns`] reads tables with named columns, in which cells may be empty.
//!
//! ```
//! use tomolith_planning::measured::Columns;
//! let table = Columns::parse("dose,cured\n1.5,0\n3, 1\n# a comment\n6,", "discs.csv".as_ref()).unwrap();
//! assert_eq!(table.pairs("dose", "cured").unwrap(), [[1.5, 0.0], [3.0, 1.0]]); // rows without a value are left out
//! ```

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result, nearest_name};
use tomolith_core::response::curve::Curve;
use tomolith_core::units::counted;
use tomolith_io::{must_be_free, read_text, write_folder_whole};

/// All pairs of a file with two columns, which messages call `what`; a first line of words is a header.
///
/// # Errors
/// [`Error::Io`], [`Error::Format`] naming the line.
pub fn read_pairs(path: &Path, what: &str) -> Result<Vec<[f64; 2]>> {
    let text = text_of(path)?;
    let accepted = || format!("two numbers a line: {what}");
    let named = |error: Error| match error {
        Error::Format { path, found, .. } => Error::format(path, found, accepted()),
        other => other,
    };
    let table = Columns::parse(&text, path).map_err(named)?;
    let pairs: Vec<[f64; 2]> = table
        .rows
        .iter()
        .filter_map(|row| Some([cell(row, 0)?, cell(row, 1)?]))
        .collect();
    let whole = table.rows.iter().all(|row| row.len() == 2);
    if whole && pairs.len() == table.rows.len() && !pairs.is_empty() {
        return Ok(pairs);
    }
    let is_pair = |row: &[_]| row.len() == 2;
    let held = match table.rows.iter().find(|row| !is_pair(row)) {
        Some(row) => format!("a line of {}", counted(row.len(), "column")),
        None => format!("{} of {} lines hold numbers", pairs.len(), table.rows.len()),
    };
    Err(Error::format(path, held, accepted()))
}

/// The text of a table.
fn text_of(path: &Path) -> Result<String> {
    let is_no_table = |found: &str| Error::format(path, found, "a table as CSV text");
    if path.is_dir() {
        return Err(is_no_table("a folder"));
    }
    read_text(path)
}

/// Points by ascending first number, equal ones averaged.
///
/// # Errors
/// As [`Curve::new`].
pub fn curve(pairs: &[[f64; 2]]) -> Result<Curve> {
    let column = |c: usize| -> Vec<f64> { pairs.iter().map(|p| p[c]).collect() };
    Curve::new(&column(0), &column(1))
}

/// A table with names.
#[derive(Clone, Debug)]
pub struct Columns {
    path: PathBuf,
    names: Vec<String>,
    rows: Vec<Vec<Option<f64>>>,
}

impl Columns {
    /// The table of a file.
    ///
    /// # Errors
    /// [`Error::Io`], [`Error::Format`] naming the line.
    pub fn read(path: &Path) -> Result<Self> {
        Columns::parse(&text_of(path)?, path)
    }

    /// The table of a text: names first (none where the first line is numbers), cells parted by commas, semicolons or tabs, else by blanks; what
    /// follows a # is skipped.
    ///
    /// # Errors
    /// [`Error::Format`] naming the line.
    pub fn parse(text: &str, path: &Path) -> Result<Self> {
        let bad = |line: usize, found: String, accepted: String| {
            Error::format(path, format!("line {line}: {found}"), accepted)
        };
        let strip = |line: &'_ str| -> String {
            let line = line.split('#').next().unwrap_or_default();
            line.trim_start_matches('\u{feff}').trim().to_owned()
        };
        let lines: Vec<(usize, String)> = text
            .lines()
            .enumerate()
            .map(|(i, line)| (i + 1, strip(line)))
            .filter(|(_, line)| !line.is_empty())
            .collect();
        let Some((_, head)) = lines.first() else {
            return Err(bad(1, "an empty file".to_owned(), "a table".to_owned()));
        };
        let is_parted = head.contains([',', ';', '\t']);
        let cells = |line: &str| -> Vec<String> {
            if is_parted {
                let cells = line.split([',', ';', '\t']);
                cells.map(|cell| cell.trim().to_owned()).collect()
            } else {
                line.split_whitespace().map(str::to_owned).collect()
            }
        };
        let names = cells(head);
        let is_head = names.iter().all(|name| name.parse::<f64>().is_err());
        let lines = &lines[usize::from(is_head)..];
        let mut rows = Vec::new();
        for (number, line) in lines {
            let row: Option<Vec<Option<f64>>> = cells(line.as_str())
                .iter()
                .map(|cell| match cell.parse::<f64>() {
                    _ if cell.is_empty() => Some(None),
                    Ok(value) if value.is_finite() => Some(Some(value)),
                    _ => None,
                })
                .collect();
            match row {
                Some(row) if row.len() <= names.len() => rows.push(row),
                _ => {
                    let accepted = format!(
                        "finite numbers with a decimal point, at most {} a line: {head}",
                        names.len()
                    );
                    return Err(bad(*number, format!("`{line}`"), accepted));
                }
            }
        }
        Ok(Columns {
            path: path.to_owned(),
            names,
            rows,
        })
    }

    /// Refuses columns with other names than these.
    ///
    /// # Errors
    /// [`Error::Format`] for the first of them.
    pub fn only(&self, names: &[&str]) -> Result<()> {
        let other = self
            .names
            .iter()
            .find(|name| !names.contains(&name.as_str()));
        match other {
            None => Ok(()),
            Some(name) => Err(Error::format(
                self.path.clone(),
                format!("a column `{name}`"),
                format!("a first line with names: {}", names.join(", ")),
            )),
        }
    }

    /// Whether a column has a number anywhere.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.column(name)
            .is_some_and(|i| self.rows.iter().any(|row| cell(row, i).is_some()))
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|n| n == name)
    }

    /// Two columns, where a row has both.
    ///
    /// # Errors
    /// [`Error::Format`] for a column that is not there.
    pub fn pairs(&self, first: &str, second: &str) -> Result<Vec<[f64; 2]>> {
        let find = |name: &str| {
            self.column(name).ok_or_else(|| {
                let names = || self.names.iter().map(String::as_str);
                let guess = nearest_name(name, names())
                    .map(|near| format!(" (is `{near}` meant to be it?)"))
                    .unwrap_or_default();
                Error::format(
                    self.path.clone(),
                    format!("no column `{name}`{guess}"),
                    format!("a first line with names, `{name}` among them"),
                )
            })
        };
        let (a, b) = (find(first)?, find(second)?);
        let both = |row: &Vec<Option<f64>>| Some([cell(row, a)?, cell(row, b)?]);
        Ok(self.rows.iter().filter_map(both).collect())
    }
}

fn cell(row: &[Option<f64>], column: usize) -> Option<f64> {
    row.get(column).copied().flatten()
}

/// A table as text; what is not a number is an empty cell.
#[must_use]
pub fn csv(names: &[&str], rows: &[Vec<f64>]) -> String {
    let mut text = names.join(",") + "\n";
    for row in rows {
        let cells: Vec<String> = row
            .iter()
            .map(|value| {
                if value.is_finite() {
                    // Six digits: rounding noise is no measurement
                    tomolith_core::units::concise(*value)
                } else {
                    String::new()
                }
            })
            .collect();
        // Writing into a string cannot fail
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

/// Writes texts as files of a new folder, all of them or none.
///
/// # Errors
/// [`Error::Config`] (key `--output`) where the folder holds anything; [`Error::Io`].
pub fn write_folder(folder: &Path, files: &[(&str, String)]) -> Result<()> {
    must_be_free("--output", folder)?;
    if let Some(parent) = folder.parent() {
        std::fs::create_dir_all(parent).map_err(|e| Error::io(parent, e))?;
    }
    write_folder_whole(folder, |aside| {
        for (name, text) in files {
            std::fs::write(aside.join(name), text)?;
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_table_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let mesh = folder.path().join("part.stl");
        std::fs::write(&mesh, [0xff, 0xfe, 0]).unwrap();
        for (path, found) in [(mesh.as_path(), "not UTF-8"), (folder.path(), "a folder")] {
            let said = Columns::read(path).unwrap_err().to_string();
            assert!(said.contains(found), "{said}");
        }
    }
}
