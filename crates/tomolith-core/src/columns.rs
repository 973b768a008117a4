//! Tables of numbers in text files.
//!
//! [`read_pairs`] reads two columns; [`Columns`] reads tables with named columns, in which cells may be empty.
//!
//! ```
//! use tomolith_core::columns::Columns;
//! let table = Columns::parse("dose,cured\n1.5,0\n3, 1\n# a comment\n6,", "discs.csv".as_ref()).unwrap();
//! assert_eq!(table.pairs("dose", "cured").unwrap(), [[1.5, 0.0], [3.0, 1.0]]); // rows without a value are left out
//! ```

use crate::error::{Error, Result, nearest_name};
use crate::files::read_text;
use crate::units::counted;
use std::path::{Path, PathBuf};

/// All pairs of a file with two columns, which messages call `what` ("irradiance (mW/cm²) and time (s)"); a first line of words is a header.
///
/// # Errors
/// [`Error::Io`], [`Error::Format`] naming the line, or a header that has these columns the other way round or in other units.
pub fn read_pairs(path: &Path, what: &str) -> Result<Vec<[f64; 2]>> {
    let text = text_of(path)?;
    let refused = |found| {
        let accepted = "two numbers a line, with decimal points, and a comma, a semicolon, a tab or spaces between them";
        Error::format(path, found, format!("{accepted}: {what}"))
    };
    let table = Columns::parse(&text, path).map_err(|error| match error {
        Error::Format { found, .. } => refused(found),
        other => other,
    })?;
    if table.rows.is_empty() {
        return Err(refused("no line of numbers".to_owned()));
    }
    if let [first, second, ..] = &table.names[..]
        && is_swapped([first, second], what)
    {
        let found = format!("columns `{first}` and `{second}`, which have the other order");
        return Err(refused(found));
    }
    if let [first, second] = &table.names[..] {
        for (name, quantity) in [first, second].into_iter().zip(what.split(" and ")) {
            let mut kinds = UNITS.iter();
            let asked = kinds.find_map(|kind| Some((kind, unit_of(quantity, kind)?)));
            let found = asked.and_then(|(kind, asked)| Some((unit_of(name, kind)?, asked)));
            if let Some((unit, _)) = found.filter(|(unit, asked)| unit != asked) {
                return Err(refused(format!("column `{name}`, in {unit}")));
            }
        }
    }
    let pair = |(line, row): &(usize, Vec<Option<f64>>)| match row[..] {
        [Some(a), Some(b), ref rest @ ..] if rest.iter().all(Option::is_none) => Ok([a, b]),
        _ => {
            let numbers = counted(row.iter().flatten().count(), "number");
            Err(refused(format!(
                "line {line}: {numbers} in {}",
                counted(row.len(), "column")
            )))
        }
    };
    table.rows.iter().map(pair).collect()
}

/// Whether one of two columns has the name of the other quantity, and not that of its own.
fn is_swapped(names: [&str; 2], what: &str) -> bool {
    let quantities = what.split(" and ");
    let words: Vec<&str> = quantities.filter_map(|q| q.split(' ').next()).collect();
    let has = |name: usize, word: usize| {
        let word = words.get(word);
        word.is_some_and(|word| names[name].to_lowercase().contains(word))
    };
    (has(0, 1) && !has(0, 0)) || (has(1, 0) && !has(1, 1))
}

/// Units of one kind by which columns differ from table to table.
const UNITS: [&[&str]; 2] = [
    &["mW/cm²", "mW/mm²", "W/cm²", "W/m²", "mW/m²", "µW/cm²"],
    &["s", "ms", "min", "h"],
];

/// The unit of a kind that a name ends with: `time (min)`, `irradiance [mW/mm2]`, `irradiance_mw_per_mm2`.
fn unit_of(name: &str, kind: &[&'static str]) -> Option<&'static str> {
    let name = name.to_lowercase().replace("_per_", "/");
    let mut words = name.split([' ', '_', '(', ')', '[', ']', '"']);
    let last = words.rfind(|word| !word.is_empty())?;
    let plain = |unit: &str| {
        let unit = unit.to_lowercase().replace('²', "2");
        unit.replace(['µ', 'μ'], "u")
    };
    let last = plain(&last.replace('^', ""));
    kind.iter().copied().find(|unit| plain(unit) == last)
}

fn text_of(path: &Path) -> Result<String> {
    let is_no_table = |found: &str| Error::format(path, found, "a table as CSV text");
    if path.is_dir() {
        return Err(is_no_table("a folder"));
    }
    read_text(path)
}

/// A table with names.
#[derive(Clone, Debug)]
pub struct Columns {
    path: PathBuf,
    names: Vec<String>,
    /// With the number of their line.
    rows: Vec<(usize, Vec<Option<f64>>)>,
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
        let cells = |line: &str| -> Vec<String> {
            if line.contains([',', ';', '\t']) {
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
                Some(row) if row.iter().skip(names.len()).all(Option::is_none) => {
                    rows.push((*number, row));
                }
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
            .is_some_and(|i| self.rows.iter().any(|(_, row)| cell(row, i).is_some()))
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
        let both = |(_, row): &(_, Vec<_>)| Some([cell(row, a)?, cell(row, b)?]);
        Ok(self.rows.iter().filter_map(both).collect())
    }
}

fn cell(row: &[Option<f64>], column: usize) -> Option<f64> {
    row.get(column).copied().flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_read_however_they_are_parted() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pairs.csv");
        for text in [
            "0,1\n2,3",
            "\u{feff}value; light in mW\n0; 1 # dark\n\n2; 3;\n",
            "# measured\na, b\n0\t1\n  2   3\n",
        ] {
            std::fs::write(&file, text).unwrap();
            let found = read_pairs(&file, "value and light").unwrap();
            assert_eq!(found, [[0.0, 1.0], [2.0, 3.0]], "{text:?}");
        }
    }

    #[test]
    fn columns_in_other_units_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pairs.csv");
        let read = |names: &str| {
            std::fs::write(&file, format!("{names}\n1,2\n")).unwrap();
            read_pairs(&file, "irradiance (mW/cm²) and time (s)")
        };
        for names in [
            "irradiance_mw_per_cm2,time_s",
            "Irradiance [mW/cm^2], Time (s)",
            "irradiance in counts, time",
            "irradiance (mW/cm2) time (s)",
            "E_h,t_s",
        ] {
            assert_eq!(read(names).unwrap(), [[1.0, 2.0]], "{names}");
        }
        for (names, wrong) in [
            ("irradiance_mw_per_mm2,time_s", "in mW/mm²"),
            ("irradiance (W/m²),time", "in W/m²"),
            ("irradiance,time_min", "column `time_min`, in min"),
            ("irradiance,\"time (min)\"", "in min"),
        ] {
            let message = read(names).unwrap_err().to_string();
            crate::contains!(message, wrong, "irradiance (mW/cm²) and time (s)");
        }
    }

    #[test]
    fn what_is_no_table_of_pairs_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pairs.csv");
        for (text, wrong) in [
            ("0,0\n1,a", "line 2: `1,a`"),
            ("0 0\n\n1 2 3", "line 3: `1 2 3`"),
            ("0,0,1\n1,1,2", "line 1: 3 numbers in 3 columns"),
            ("0,0\n1,", "line 2: 1 number in 2 columns"),
            ("a,b\nc,d", "line 2: `c,d`"),
            ("0,0\n1,nan", "line 2: `1,nan`"),
            ("a,b", "no line of numbers"),
            (
                "Response, dose (mJ)\n1,2",
                "columns `Response` and `dose (mJ)`, which have the other order",
            ),
            ("x,dose\n1,2", "the other order"),
            ("", "an empty file"),
        ] {
            std::fs::write(&file, text).unwrap();
            let message = read_pairs(&file, "dose and response")
                .unwrap_err()
                .to_string();
            crate::contains!(message, "pairs.csv", wrong, "dose and response");
        }
        std::fs::write(&file, [0xff, 0xfe, 0]).unwrap();
        for (path, found) in [(file.as_path(), "not UTF-8"), (folder.path(), "a folder")] {
            let message = Columns::read(path).unwrap_err().to_string();
            crate::contains!(message, found);
        }
    }
}
