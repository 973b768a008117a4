//! The one error type of the library.
//!
//! A variant carries values, not sentences: the program that shows it decides how. Errors of a job file start as
//! [`Error::Config`] with the key path only; the job reader adds the [`Place`] (file and line).

use crate::units::exact;
use std::path::PathBuf;

/// Position in a text file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file as the user named it.
    pub file: PathBuf,
    /// Line, counted from 1.
    pub line: usize,
    /// Byte range of the key or value in the file, for tools that underline it.
    pub span: std::ops::Range<usize>,
}

/// Everything that can go wrong, by what the caller can do about it.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A key of the job (or a parameter of the API) has a value that cannot be used.
    #[error("{}: {found}; accepted: {accepted}{}{}", key_or_file(key, place.as_ref()),
        nearest.as_ref().map(|n| format!("; did you mean `{n}`?")).unwrap_or_default(),
        place.as_ref().map(|p| format!(" ({}, line {})", p.file.display(), p.line)).unwrap_or_default())]
    Config {
        /// Dotted key path, for example `vial.cylinder.inner_radius_mm`.
        key: String,
        /// What was found, with the value.
        found: String,
        /// What would be accepted.
        accepted: String,
        /// The nearest accepted name, for misspelt keys and kinds.
        nearest: Option<String>,
        /// Where it stands, when it came from a file.
        place: Option<Place>,
    },
    /// An array has the wrong shape.
    #[error(
        "{what}: expected shape {expected:?}, found {found:?}{}",
        in_another_order(expected, found)
    )]
    Shape {
        /// Which array.
        what: String,
        /// The shape it must have.
        expected: Vec<usize>,
        /// The shape it has.
        found: Vec<usize>,
    },
    /// A mesh that cannot be used.
    #[error("mesh {}: {found}; accepted: {accepted}", path.display())]
    Mesh {
        /// The mesh file.
        path: PathBuf,
        /// What is wrong with it.
        found: String,
        /// What would be accepted.
        accepted: String,
    },
    /// A file could not be read or written.
    #[error("{}: {source}", path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// The message of the system.
        source: std::io::Error,
    },
    /// A file could be read but does not hold what it should.
    #[error("{}: {found}; accepted: {accepted}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// What was found in it.
        found: String,
        /// What would be accepted.
        accepted: String,
    },
    /// Memory or disk would not be enough.
    #[error("{what}: {needed_mb} MB needed, {}; {advice}",
        available_mb.map_or("but the system refused to allocate it".to_owned(), |mb| format!("{mb} MB available")))]
    Resources {
        /// `memory` or `disk`, and for what.
        what: String,
        /// The estimate in MB (10⁶ bytes).
        needed_mb: u64,
        /// What there is, in MB; None where the system does not say.
        available_mb: Option<u64>,
        /// What the user can do.
        advice: String,
    },
    /// A number became infinite or not-a-number.
    #[error("{what} became {value} at iteration {iteration}")]
    NonFinite {
        /// Which number.
        what: String,
        /// Its value.
        value: f64,
        /// The iteration, counted from 0 (the start).
        iteration: usize,
    },
    /// Two things that cannot be combined.
    #[error("{what} cannot be used here: {reason}")]
    Unsupported {
        /// What was asked for.
        what: String,
        /// Why it is refused.
        reason: String,
    },
    /// One of several processes that work on a job could not go on.
    #[error("rank {rank} could not go on, so all ranks stop: its output says why")]
    Rank {
        /// Which, from 0.
        rank: usize,
    },
    /// A graphics card is not there, or failed.
    #[error("graphics card {name}: {found}")]
    Device {
        /// The card, or the name that the job gives.
        name: String,
        /// What is wrong.
        found: String,
    },
    /// Several keys of a job are at fault.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Several(Vec<Error>),
    /// The user asked to stop.
    #[error("canceled")]
    Canceled,
}

impl Error {
    /// A [`Error::Config`] without place and nearest name.
    pub fn config(
        key: impl Into<String>,
        found: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Self {
        Error::Config {
            key: key.into(),
            found: found.into(),
            accepted: accepted.into(),
            nearest: None,
            place: None,
        }
    }

    /// An [`Error::Config`] of a value that was found at a key.
    pub fn refused(
        key: impl Into<String>,
        found: impl std::fmt::Display,
        accepted: impl Into<String>,
    ) -> Self {
        Error::config(key, format!("found {found}"), accepted)
    }

    /// An [`Error::Format`].
    pub fn format(
        path: impl Into<PathBuf>,
        found: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Self {
        Error::Format {
            path: path.into(),
            found: found.into(),
            accepted: accepted.into(),
        }
    }

    /// An [`Error::Unsupported`].
    pub fn unsupported(what: impl Into<String>, reason: impl Into<String>) -> Self {
        Error::Unsupported {
            what: what.into(),
            reason: reason.into(),
        }
    }

    /// An [`Error::Shape`].
    pub fn shape(
        what: impl Into<String>,
        expected: impl Into<Vec<usize>>,
        found: impl Into<Vec<usize>>,
    ) -> Self {
        Error::Shape {
            what: what.into(),
            expected: expected.into(),
            found: found.into(),
        }
    }

    /// An [`Error::Io`] for a path.
    pub fn io(path: impl Into<PathBuf>, source: std::io::Error) -> Self {
        Error::Io {
            path: path.into(),
            source,
        }
    }

    /// Whether a file could not be written because no more fits: the disk or a quota is full, or the file is as large as files may be.
    #[must_use]
    pub fn is_full_disk(&self) -> bool {
        use std::io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
        let kinds = [StorageFull, QuotaExceeded, FileTooLarge];
        matches!(self, Error::Io { source, .. } if kinds.contains(&source.kind()))
    }

    /// Adds a question to what an [`Error::Config`] would accept; other errors pass unchanged.
    #[must_use]
    pub fn asking(mut self, question: Option<&str>) -> Self {
        if let (Error::Config { accepted, .. }, Some(question)) = (&mut self, question) {
            accepted.push_str("; ");
            accepted.push_str(question);
        }
        self
    }

    /// The error for the key that named a file, where that file could not be read or does not hold what it should; other errors pass unchanged.
    #[must_use]
    pub fn of_file(self, key: impl Into<String>) -> Self {
        match self {
            Error::Format {
                path,
                found,
                accepted,
            } => Error::config(key, format!("{}: {found}", path.display()), accepted),
            Error::Mesh {
                path,
                found,
                accepted,
            } => Error::config(key, format!("mesh {}: {found}", path.display()), accepted),
            Error::Io { .. } => Error::config(key, self.to_string(), "a file that can be read"),
            other => other,
        }
    }

    /// Puts `prefix` before the key of a [`Error::Config`]; other errors pass unchanged.
    #[must_use]
    pub fn under(mut self, prefix: &str) -> Self {
        if let Error::Config { key, .. } = &mut self
            && !prefix.is_empty()
        {
            *key = if key.is_empty() {
                prefix.to_owned()
            } else {
                format!("{prefix}.{key}")
            };
        }
        self
    }
}

/// Refuses the number at a key unless it is in range.
///
/// # Errors
/// [`Error::Config`] with the number and what is accepted.
pub fn in_range(
    is_in: bool,
    key: impl Into<String>,
    value: impl std::fmt::LowerExp + std::fmt::Debug,
    accepted: impl Into<String>,
) -> Result<()> {
    match is_in {
        true => Ok(()),
        false => Err(Error::refused(key, exact(value), accepted)),
    }
}

/// Refuses a number at a key that is not finite and above 0.
///
/// # Errors
/// As [`in_range`].
pub fn above_zero(key: impl Into<String>, value: f64) -> Result<()> {
    let is_above = value.is_finite() && value > 0.0;
    in_range(is_above, key, value, "a finite number above 0")
}

/// The key, or what a message without one is about: the whole file, or the job where there is none.
#[must_use]
pub fn key_or_file<'a>(key: &'a str, place: Option<&Place>) -> &'a str {
    match (key, place) {
        ("", Some(_)) => "file",
        ("", None) => "job",
        (key, _) => key,
    }
}

/// The library's result.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Says that the axes of an array are those that are expected, in another order.
fn in_another_order(expected: &[usize], found: &[usize]) -> &'static str {
    let sorted = |shape: &[usize]| {
        let mut shape = shape.to_vec();
        shape.sort_unstable();
        shape
    };
    match expected != found && sorted(expected) == sorted(found) {
        true => ": its axes are in another order",
        false => "",
    }
}

/// Ends of names that are units.
const UNITS: [&str; 7] = ["_per_mm", "_mm", "_um", "_nm", "_deg", "_hz", "_s"];

/// The name among `names` that is nearest to `word`: the same with a unit, or near enough to be a slip of the keyboard.
///
/// ```
/// use tomolith_core::error::nearest_name;
/// let names = ["absorption_per_mm", "absorption_map"];
/// assert_eq!(nearest_name("absorption", names), Some("absorption_per_mm"));
/// assert_eq!(nearest_name("absorbtion", names), Some("absorption_per_mm"));
/// assert_eq!(nearest_name("absorbtion_map", names), Some("absorption_map"));
/// ```
#[must_use]
pub fn nearest_name<'a>(word: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let near = |name: &str| {
        let without_unit = UNITS.iter().find_map(|unit| name.strip_suffix(unit));
        let score = |name: &str| strsim::jaro_winkler(word, name);
        without_unit.map_or(0.0, score).max(score(name))
    };
    names
        .into_iter()
        .map(|name| (near(name), name))
        .filter(|(score, _)| *score > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}
