//! A transform as 3MF writes it.

use tomolith_core::vector::{cross, dot};

/// A row vector (x, y, z, 1) times four rows of three numbers.
#[derive(Clone, Copy)]
pub(super) struct Place([[f64; 3]; 4]);

impl Place {
    /// Twelve numbers, row by row.
    pub(super) fn read(text: &str) -> Option<Self> {
        let numbers: Result<Vec<f64>, _> = text.split_whitespace().map(str::parse).collect();
        let numbers: [f64; 12] = numbers.ok()?.try_into().ok()?;
        Some(Place(
            [0, 3, 6, 9].map(|at| [numbers[at], numbers[at + 1], numbers[at + 2]]),
        ))
    }

    pub(super) fn scaled(s: f64) -> Self {
        Place([[s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s], [0.0; 3]])
    }

    /// First this, then `next`.
    pub(super) fn then(&self, next: &Place) -> Place {
        let mut rows = self
            .0
            .map(|row| std::array::from_fn(|c| (0..3).map(|k| row[k] * next.0[k][c]).sum::<f64>()));
        for (value, shift) in rows[3].iter_mut().zip(next.0[3]) {
            *value += shift;
        }
        Place(rows)
    }

    pub(super) fn apply(&self, p: [f64; 3]) -> [f64; 3] {
        let [a, b, c, shift] = self.0;
        std::array::from_fn(|i| p[0] * a[i] + p[1] * b[i] + p[2] * c[i] + shift[i])
    }

    /// Whether it turns a surface inside out.
    pub(super) fn mirrors(&self) -> bool {
        let [a, b, c, _] = self.0;
        dot(a, cross(b, c)) < 0.0
    }
}
