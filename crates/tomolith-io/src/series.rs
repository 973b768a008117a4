//! Numbered files of a folder, in the order of their numbers: `slice_2` before `slice_10`.
//!
//! Hidden files, such as those that macOS writes next to others (`._01.png`), belong to no series. Names that leave the order
//! or the place of a file in doubt are refused: a number twice (`1.png` and `01.png`), decimals of several lengths (`0.5` and
//! `0.25`), a gap, files of several series in one folder.
//!
//! ```
//! use std::path::Path;
//! use tomolith_io::series::numbered_files;
//! let folder = tempfile::tempdir().unwrap();
//! for name in ["10.png", "9.png", "._9.png", "notes.txt"] {
//!     std::fs::write(folder.path().join(name), "").unwrap();
//! }
//! let files = numbered_files(folder.path(), "*", &["png"]).unwrap();
//! assert_eq!(files, ["9.png", "10.png"].map(|name| folder.path().join(name)));
//! ```

use std::path::{Path, PathBuf};
use tomolith_core::error::{Error, Result};

/// The files of a folder whose names match a pattern, in which every `*` stands for any text, and have one of these
/// extensions in upper or lower case.
///
/// # Errors
/// [`Error::Io`] when the folder cannot be read; [`Error::Format`] when the names leave the order in doubt.
pub fn numbered_files(folder: &Path, pattern: &str, extensions: &[&str]) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(|e| Error::io(folder, e))? {
        let path = entry.map_err(|e| Error::io(folder, e))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let extension = path.extension().unwrap_or_default();
        let is_wanted = extensions.iter().any(|e| extension.eq_ignore_ascii_case(e))
            && !name.starts_with('.')
            && matches(&name, pattern)
            && path.is_file();
        if is_wanted {
            found.push((pieces(&path), path));
        }
    }
    found.sort();
    let pairs = found.windows(2).map(|pair| (&pair[0], &pair[1]));
    let doubt = pairs
        .filter_map(|((a, first), (b, second))| Some((doubt(a, b)?, first, second)))
        .next();
    if let Some((doubt, first, second)) = doubt {
        return Err(ambiguous(folder, doubt, first, second));
    }
    if let Some((first, second)) = gap(&found) {
        return Err(ambiguous(folder, "a number is missing", first, second));
    }
    Ok(found.into_iter().map(|(_, path)| path).collect())
}

fn ambiguous(folder: &Path, doubt: &str, first: &Path, second: &Path) -> Error {
    let name = |path: &Path| {
        let name = path.file_name().unwrap_or_default();
        name.to_string_lossy().into_owned()
    };
    Error::format(
        folder,
        format!("`{}`, then `{}`: {doubt}", name(first), name(second)),
        "the files of one series, numbered in equal steps such as 1, 2, … 12 or 001, 002, … 012; move other images elsewhere",
    )
}

/// Whether a name is the pattern, in which every `*` stands for any text.
fn matches(name: &str, pattern: &str) -> bool {
    let Some((start, rest)) = pattern.split_once('*') else {
        return name == pattern;
    };
    name.strip_prefix(start).is_some_and(|name| {
        let ends = name.char_indices().map(|(i, _)| i).chain([name.len()]);
        ends.into_iter().any(|i| matches(&name[i..], rest))
    })
}

/// A text of a name and the number after it. The order of numbers is that of their lengths, then of their digits.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Piece {
    text: String,
    /// Digits without leading zeros.
    length: usize,
    number: String,
    leading_zeros: usize,
}

/// The stem of a file as texts and numbers in turn.
fn pieces(path: &Path) -> Vec<Piece> {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let mut rest = &*stem;
    let mut pieces = Vec::new();
    while !rest.is_empty() {
        let (text, after) = rest.split_at(
            rest.find(|c: char| c.is_ascii_digit())
                .unwrap_or(rest.len()),
        );
        let end = after.find(|c: char| !c.is_ascii_digit());
        let (digits, after) = after.split_at(end.unwrap_or(after.len()));
        let number = digits.trim_start_matches('0');
        pieces.push(Piece {
            text: text.to_owned(),
            length: number.len(),
            number: number.to_owned(),
            leading_zeros: digits.len() - number.len(),
        });
        rest = after;
    }
    pieces
}

/// Why it is not certain which of two names that follow each other comes first, or whether they belong together.
fn doubt(a: &[Piece], b: &[Piece]) -> Option<&'static str> {
    let texts = |pieces: &[Piece]| pieces.iter().map(|p| p.text.clone()).collect::<Vec<_>>();
    if texts(a) != texts(b) {
        return Some("names of two series");
    }
    let mut pairs = a.iter().zip(b);
    if pairs.clone().all(|(a, b)| a.number == b.number) {
        return Some("the same number twice");
    }
    let digits = |piece: &Piece| piece.length + piece.leading_zeros;
    let are_decimals = |(a, b): (&Piece, &Piece)| a.text == "." && digits(a) != digits(b);
    pairs.any(are_decimals).then_some("decimals of two lengths")
}

/// The files on either side of the first gap in numbers that alone tell the names apart.
fn gap(files: &[(Vec<Piece>, PathBuf)]) -> Option<(&Path, &Path)> {
    let (first, _) = files.first()?;
    let varies = |i: &usize| {
        files
            .iter()
            .any(|(pieces, _)| pieces[*i].number != first[*i].number)
    };
    let mut varying = (0..first.len()).filter(varies);
    let (column, None) = (varying.next()?, varying.next()) else {
        return None;
    };
    let step = |pair: &[(Vec<Piece>, PathBuf)]| {
        let [low, high] = [0, 1].map(|i| format!("0{}", pair[i].0[column].number).parse::<u128>());
        high.ok()?.checked_sub(low.ok()?)
    };
    let steps: Vec<u128> = files.windows(2).map(step).collect::<Option<_>>()?;
    let usual = steps.iter().min()?;
    let at = steps.iter().position(|step| step != usual)?;
    Some((&files[at].1, &files[at + 1].1))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names in their order, or the doubt.
    fn ordered(names: &[&str]) -> Result<Vec<String>, String> {
        let folder = tempfile::tempdir().unwrap();
        for name in names {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        let files =
            numbered_files(folder.path(), "*", &["png", "tif"]).map_err(|e| e.to_string())?;
        let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
        Ok(files.iter().map(name).collect())
    }

    #[test]
    fn numbers_count_by_their_values() {
        let names = ["10.png", "9.png", "11.PNG"];
        assert_eq!(ordered(&names).unwrap(), ["9.png", "10.png", "11.PNG"]);
        let names = ["a_100_z.tif", "a_020_z.tif", "a_0060_z.tif"];
        let expected = ["a_020_z.tif", "a_0060_z.tif", "a_100_z.tif"];
        assert_eq!(ordered(&names).unwrap(), expected);
        // Numbers that no integer of the machine holds
        let names = [
            "1000000000000000000000000000000000000000001.png",
            "1000000000000000000000000000000000000000000.png",
        ];
        assert_eq!(ordered(&names).unwrap(), [names[1], names[0]]);
        // Two numbers that vary together
        let names = ["f_2_az_20.5.png", "f_10_az_99.0.png", "f_1_az_10.0.png"];
        assert_eq!(ordered(&names).unwrap(), [names[2], names[0], names[1]]);
        assert_eq!(ordered(&["one.png"]).unwrap(), ["one.png"]);
        assert!(ordered(&[]).unwrap().is_empty());
    }

    #[test]
    fn what_systems_leave_is_skipped() {
        let left = ["01.png", "._01.png", ".DS_Store", "Thumbs.db"];
        assert_eq!(ordered(&left).unwrap(), ["01.png"]);
    }

    #[test]
    fn an_order_in_doubt_is_refused() {
        for (names, doubt) in [
            (&["1.png", "01.png"][..], "`01.png`: the same number twice"),
            (&["1.png", "1.tif"], "the same number twice"),
            (&["a_0.5.png", "a_0.25.png"], "decimals of two lengths"),
            (&["a_1.png", "b_1.png"], "names of two series"),
            (
                &["1.png", "2.png", "4.png"],
                "`2.png`, then `4.png`: a number is missing",
            ),
        ] {
            let text = ordered(names).unwrap_err();
            assert!(text.contains(doubt), "{names:?}: {text}");
        }
    }
}
