//! Which pixels of a light may be lit: a part of the projector, an image, corners of a vial, dead pixels of a machine.
//!
//! ```
//! use tomolith_core::grid::{PatternGrid, PixelMask};
//! let pixels = PatternGrid::full_turn(2, 0.0, 3, 4, 0.1);
//! let crop = PixelMask::new([1, 3, 4], |_, row, column| row < 2 && column != 1);
//! let [low, high] = crop.field_mm(&pixels);
//! assert!((low[0] + 0.2).abs() < 1e-12 && (low[1] + 0.05).abs() < 1e-12); // the lowest row is out
//! assert!((high[0] - 0.2).abs() < 1e-12 && (high[1] - 0.15).abs() < 1e-12);
//! ```

use super::PatternGrid;
use crate::parallel::table;

/// Pixels that may be lit, `[frame, row, column]`; an axis of length 1 stands for all frames, rows or columns.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelMask {
    shape: [usize; 3],
    open: Vec<bool>,
}

impl PixelMask {
    /// The pixels that `open(frame, row, column)` chooses, row 0 = top.
    #[must_use]
    pub fn new(
        shape: [usize; 3],
        open: impl Fn(usize, usize, usize) -> bool + Sync + Send,
    ) -> Self {
        let [frames, rows, columns] = shape;
        let at = |i: usize| open(i / (rows * columns), i / columns % rows, i % columns);
        PixelMask {
            shape,
            open: table(frames * rows * columns, at),
        }
    }

    /// Whether a pixel may be lit.
    ///
    /// # Panics
    /// When the mask is not for a light with such a pixel.
    #[must_use]
    pub fn allows(&self, at: [usize; 3]) -> bool {
        let [frame, row, column] =
            std::array::from_fn(|axis| if self.shape[axis] == 1 { 0 } else { at[axis] });
        self.open[(frame * self.shape[1] + row) * self.shape[2] + column]
    }

    /// Whether each may be lit, in the order of patterns.
    #[must_use]
    pub fn as_slice(&self) -> &[bool] {
        &self.open
    }

    /// Whether every pixel may be lit.
    #[must_use]
    pub fn is_open(&self) -> bool {
        !self.open.contains(&false)
    }

    /// Whether it is the same in all frames.
    #[must_use]
    pub fn is_still(&self) -> bool {
        self.shape[0] == 1
    }

    /// Lowest and highest corner [u, z] of the pixels that may be lit in some frame, mm; inverted when there is none.
    #[must_use]
    pub fn field_mm(&self, pixels: &PatternGrid) -> [[f64; 2]; 2] {
        let half = pixels.pitch_mm.map(|pitch| pitch / 2.0);
        let mut field = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for row in 0..pixels.rows {
            for column in 0..pixels.columns {
                if (0..self.shape[0]).any(|frame| self.allows([frame, row, column])) {
                    let middle = [pixels.column_u(column), pixels.row_z(row)];
                    for axis in 0..2 {
                        field[0][axis] = field[0][axis].min(middle[axis] - half[axis]);
                        field[1][axis] = field[1][axis].max(middle[axis] + half[axis]);
                    }
                }
            }
        }
        field
    }

    /// The mask of every `step`-th frame.
    #[must_use]
    pub fn every(&self, step: usize) -> Self {
        let [frames, rows, columns] = self.shape;
        PixelMask::new(
            [frames.div_ceil(step), rows, columns],
            |frame, row, column| self.allows([frame * step, row, column]),
        )
    }

    /// The mask of these frames.
    #[must_use]
    pub fn of_frames(&self, chosen: &[usize]) -> Self {
        let [_, rows, columns] = self.shape;
        PixelMask::new([chosen.len(), rows, columns], |frame, row, column| {
            self.allows([chosen[frame], row, column])
        })
    }

    /// The mask for pixels `factor` times as large about the same middle, as many as `rows` and `columns`: they may be lit where one
    /// of these may, whose middle lies in them.
    #[must_use]
    pub fn coarser(&self, factor: usize, rows: usize, columns: usize) -> Self {
        let within = |i: usize, n: usize, m: usize| {
            let from_middle = (i as f64 - (n as f64 - 1.0) / 2.0) / factor as f64;
            (from_middle + m as f64 / 2.0).floor() as usize
        };
        let [frames, fine_rows, fine_columns] = self.shape;
        let rows = if fine_rows == 1 { 1 } else { rows };
        let columns = if fine_columns == 1 { 1 } else { columns };
        let mut open = vec![false; frames * rows * columns];
        for (i, _) in self.open.iter().enumerate().filter(|(_, open)| **open) {
            let row = within(i / fine_columns % fine_rows, fine_rows, rows);
            let column = within(i % fine_columns, fine_columns, columns);
            let frame = i / (fine_rows * fine_columns);
            open[(frame * rows + row) * columns + column] = true;
        }
        PixelMask {
            shape: [frames, rows, columns],
            open,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coarser_mask_lies_over_the_finer_one() {
        // 7 rows in 4, 10 columns in 5: rows 0 | 1 2 | 3 4 | 5 6 have their middles in one each
        let fine = PixelMask::new([4, 7, 10], |frame, row, column| {
            frame % 2 == 0 && row == 3 && column < 3
        });
        let coarse = fine.coarser(2, 4, 5).every(2);
        let open: Vec<[usize; 3]> = (0..2 * 4 * 5)
            .map(|i| [i / 20, i / 5 % 4, i % 5])
            .filter(|&at| coarse.allows(at))
            .collect();
        assert_eq!(open, [[0, 2, 0], [0, 2, 1], [1, 2, 0], [1, 2, 1]]);
    }
}
