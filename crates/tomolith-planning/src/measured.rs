//! What is measured as CSV text, and folders of texts.

use std::fmt::Write as _;
use std::path::Path;
use tomolith_core::error::Result;
use tomolith_io::{make_folder, must_be_free, write_folder_whole};

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
/// [`Error::Config`](tomolith_core::Error::Config) (key `--output`) where the folder holds anything;
/// [`Error::Io`](tomolith_core::Error::Io).
pub fn write_folder(folder: &Path, files: &[(&str, String)]) -> Result<()> {
    must_be_free("--output", folder)?;
    if let Some(parent) = folder.parent() {
        make_folder(parent)?;
    }
    write_folder_whole(folder, |aside| {
        for (name, text) in files {
            std::fs::write(aside.join(name), text)?;
        }
        Ok(())
    })
}
