//! Sparse matrices: SciPy's `.npz` of a CSR array (`scipy.sparse.save_npz`), read and written.
//!
//! The file holds `format` ("csr"), `shape` [rows, columns], `indptr` (rows + 1 numbers), `indices` (column of each entry)
//! and `data`. Reading takes int32 and int64 indices, f32 and f64 values (kept as f32), compressed or not; writing stores
//! f32 values, uncompressed. Entries of a row come back in growing order of columns, equal ones added.
//!
//! ```
//! use tomolith_io::csr::Csr;
//! let folder = tempfile::tempdir().unwrap();
//! let path = folder.path().join("matrix.npz");
//! // [[0, 2], [0, 0], [1, 3]]
//! let matrix = Csr { columns: 2, starts: vec![0, 1, 1, 3], indices: vec![1, 0, 1], values: vec![2.0, 1.0, 3.0] };
//! matrix.write(&path).unwrap();
//! assert_eq!(Csr::read(&path).unwrap(), matrix);
//! assert_eq!(matrix.transposed().row(1).collect::<Vec<_>>(), [(0, 2.0), (2, 3.0)]);
//! ```

use super::npz::ArchiveWriter;
use super::numbers::{Archive, Kind, Numbers, whole_numbers};
use super::whole::write_whole;
use std::path::Path;
use tomolith_core::error::{Error, Result};

/// What a file must hold.
const ACCEPTED: &str =
    "an .npz of scipy.sparse.save_npz with a CSR matrix (use .tocsr() before saving)";

/// A sparse matrix, row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Csr {
    /// Number of columns.
    pub columns: usize,
    /// First entry of each row, and the number of entries at the end: rows + 1 numbers.
    pub starts: Vec<usize>,
    /// Column of each entry, growing within a row.
    pub indices: Vec<u32>,
    /// Value of each entry.
    pub values: Vec<f32>,
}

impl Csr {
    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Number of stored entries.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.values.len()
    }

    /// Columns and values of a row.
    ///
    /// # Panics
    /// When there is no such row.
    pub fn row(&self, row: usize) -> impl Iterator<Item = (u32, f32)> + Clone {
        let range = self.starts[row]..self.starts[row + 1];
        let columns = self.indices[range.clone()].iter().copied();
        columns.zip(self.values[range].iter().copied())
    }

    /// From entries `(row, column, value)` in any order; entries of one place are added.
    ///
    /// # Panics
    /// When an entry lies outside.
    #[must_use]
    pub fn from_entries(rows: usize, columns: usize, entries: &[(u32, u32, f32)]) -> Self {
        let is_within = |&(_, column, _): &(u32, u32, f32)| (column as usize) < columns;
        assert!(entries.iter().all(is_within), "entry outside the matrix");
        let mut matrix = Self::sorted(rows, columns, entries.iter().copied());
        matrix.tidy();
        matrix
    }

    /// From entries, which stay in their order within a row.
    fn sorted(
        rows: usize,
        columns: usize,
        entries: impl Iterator<Item = (u32, u32, f32)> + Clone,
    ) -> Self {
        let mut starts = vec![0usize; rows + 1];
        entries
            .clone()
            .for_each(|(row, ..)| starts[row as usize + 1] += 1);
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let (mut next, count) = (starts.clone(), starts[rows]);
        let (mut indices, mut values) = (vec![0; count], vec![0.0; count]);
        for (row, column, value) in entries {
            let to = &mut next[row as usize];
            (indices[*to], values[*to]) = (column, value);
            *to += 1;
        }
        Csr {
            columns,
            starts,
            indices,
            values,
        }
    }

    /// Rows become columns.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let turned = |row: usize| {
            self.row(row)
                .map(move |(column, value)| (column, row as u32, value))
        };
        Self::sorted(self.columns, self.rows(), (0..self.rows()).flat_map(turned))
    }

    /// Sorts the entries of every row and adds those of one place.
    fn tidy(&mut self) {
        let is_tidy = |row: usize| {
            self.indices[self.starts[row]..self.starts[row + 1]].is_sorted_by(|a, b| a < b)
        };
        if (0..self.rows()).all(is_tidy) {
            return;
        }
        let (mut starts, mut indices, mut values) = (vec![0], Vec::new(), Vec::<f32>::new());
        for row in 0..self.rows() {
            let mut entries: Vec<(u32, f32)> = self.row(row).collect();
            entries.sort_by_key(|entry| entry.0);
            let begin = indices.len();
            for (column, value) in entries {
                if indices.len() > begin && indices.last() == Some(&column) {
                    if let Some(last) = values.last_mut() {
                        *last += value;
                    }
                } else {
                    indices.push(column);
                    values.push(value);
                }
            }
            starts.push(indices.len());
        }
        (self.starts, self.indices, self.values) = (starts, indices, values);
    }

    /// Writes the matrix; see the [module page](self).
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn write(&self, path: &Path) -> Result<()> {
        write_whole(path, |file| {
            let mut npz = ArchiveWriter::new(file);
            npz.add_text("format", "csr")?;
            npz.add("shape", &[2], &[self.rows() as i64, self.columns as i64])?;
            // SciPy wants both of one type: int32 where that is enough
            if i32::try_from(self.entries().max(self.columns)).is_ok() {
                let starts: Vec<i32> = self.starts.iter().map(|&s| s as i32).collect();
                let indices: Vec<i32> = self.indices.iter().map(|&i| i as i32).collect();
                npz.add("indptr", &[starts.len()], &starts)?;
                npz.add("indices", &[indices.len()], &indices)?;
            } else {
                let starts: Vec<i64> = self.starts.iter().map(|&s| s as i64).collect();
                let indices: Vec<i64> = self.indices.iter().map(|&i| i64::from(i)).collect();
                npz.add("indptr", &[starts.len()], &starts)?;
                npz.add("indices", &[indices.len()], &indices)?;
            }
            npz.add("data", &[self.values.len()], &self.values)?;
            Ok(npz.finish()?)
        })
    }

    /// Reads a matrix; see the [module page](self).
    ///
    /// # Errors
    /// [`Error::Io`] when it cannot be opened; [`Error::Format`] when it is no such file, or not a valid matrix of finite
    /// numbers.
    pub fn read(path: &Path) -> Result<Self> {
        let bad = |found: String| Error::format(path, found, ACCEPTED);
        let mut npz = Archive::open(path, ACCEPTED)?;
        let mut bytes = |name: &str| npz.bytes(name);
        let format = text_of_npy(&bytes("format")?);
        if format != "csr" {
            return Err(bad(format!("a sparse matrix of format {format:?}")));
        }
        let mut whole = |name: &str| -> Result<Vec<usize>> {
            whole_numbers(&bytes(name)?).ok_or_else(|| bad(format!("no {name}")))
        };
        let (shape, starts, indices) = (whole("shape")?, whole("indptr")?, whole("indices")?);
        let data = bytes("data")?;
        let values = Numbers::parse(&data[..], data.len() as u64).ok();
        let values = values
            .filter(|numbers| matches!(numbers.kind, Kind::Float(4 | 8)))
            .map(|numbers| numbers.values)
            .ok_or_else(|| bad("data that is neither f32 nor f64".to_owned()))?;
        let [rows, columns] = shape[..] else {
            return Err(bad(format!("shape {shape:?}")));
        };
        let is_valid = starts.len() == rows + 1
            && starts.first() == Some(&0)
            && starts.is_sorted()
            && starts.last() == Some(&values.len())
            && indices.len() == values.len()
            && indices.iter().all(|&i| i < columns)
            && u32::try_from(columns).is_ok();
        if !is_valid {
            return Err(bad(format!(
                "{rows} × {columns} with {} row starts, {} indices and {} values that do not fit together",
                starts.len(),
                indices.len(),
                values.len()
            )));
        }
        if let Some(i) = values.iter().position(|v| !v.is_finite()) {
            let row = starts.partition_point(|&start| start <= i) - 1;
            return Err(bad(format!(
                "an entry {} in row {row}, column {}",
                values[i], indices[i]
            )));
        }
        let mut matrix = Csr {
            columns,
            starts,
            indices: indices.into_iter().map(|i| i as u32).collect(),
            values,
        };
        matrix.tidy();
        Ok(matrix)
    }
}

/// The text of a `.npy` of one string: of bytes, or of 4-byte characters.
fn text_of_npy(bytes: &[u8]) -> String {
    let header = bytes
        .get(8..10)
        .map_or(0, |l| usize::from(u16::from_le_bytes([l[0], l[1]])) + 10);
    let content = bytes.get(header..).unwrap_or_default();
    let letters = content.iter().filter(|b| b.is_ascii_alphanumeric());
    letters.map(|&b| char::from(b)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::npz::header;

    #[test]
    fn entries_in_any_order_make_the_matrix_and_its_transpose() {
        let entries = [(2, 1, 3.0), (0, 1, 1.5), (2, 0, 1.0), (0, 1, 0.5)];
        let matrix = Csr::from_entries(3, 2, &entries);
        assert_eq!(matrix.starts, [0, 1, 1, 3]);
        assert_eq!(matrix.row(0).collect::<Vec<_>>(), [(1, 2.0)]);
        assert_eq!(matrix.row(2).collect::<Vec<_>>(), [(0, 1.0), (1, 3.0)]);
        assert_eq!(matrix.transposed().transposed(), matrix);
    }

    #[test]
    fn another_format_and_broken_matrices_are_refused() {
        type Change = fn(&mut Csr);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("m.npz");
        let good = Csr::from_entries(2, 3, &[(0, 2, 1.0), (1, 0, -2.0)]);
        let breaks: [(Change, &str); 3] = [
            (|m| m.columns = 2, "2 × 2 with 3 row starts"),
            (|m| m.starts = vec![0, 2, 1], "do not fit together"),
            (
                |m| m.values[1] = f32::NAN,
                "an entry NaN in row 1, column 0",
            ),
        ];
        for (change, found) in breaks {
            let mut matrix = good.clone();
            change(&mut matrix);
            matrix.write(&path).unwrap();
            tomolith_core::contains!(Csr::read(&path).unwrap_err().to_string(), found);
        }
        assert_eq!(
            text_of_npy(&[header("S3", &[]), b"csc".to_vec()].concat()),
            "csc"
        );
        std::fs::write(&path, b"no zip at all").unwrap();
        assert!(matches!(Csr::read(&path), Err(Error::Format { .. })));
    }
}
