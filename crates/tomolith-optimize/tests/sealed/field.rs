//! A field whose memory is no slice of floats: the complement of each element's bits, the last element first.
//!
//! Every operation works on this memory, element by element on one thread; sums go in the order that the host's state.

use super::bands::SealedBands;
use super::costs::SealedCosts;
use super::half_ramp::SealedHalfRamp;
use super::pairs::SealedPairs;
use std::ops::Range;
use tomolith_core::field::{BLOCK, Bounds, Field, Secant, StepSums};

/// The field.
#[derive(Clone)]
pub(crate) struct SealedField {
    memory: Vec<u32>,
}

impl SealedField {
    pub(crate) fn of(values: &[f32]) -> Self {
        let mut field = SealedField {
            memory: vec![0; values.len()],
        };
        field.write(0, values);
        field
    }

    /// Element i.
    pub(crate) fn at(&self, i: usize) -> f32 {
        f32::from_bits(!self.memory[self.memory.len() - 1 - i])
    }

    pub(crate) fn set(&mut self, i: usize, value: f32) {
        let last = self.memory.len() - 1;
        self.memory[last - i] = !value.to_bits();
    }

    fn change(&mut self, f: impl Fn(usize, f32) -> f32) {
        for i in 0..self.len() {
            self.set(i, f(i, self.at(i)));
        }
    }

    fn blocks(&self) -> impl Iterator<Item = Range<usize>> + use<> {
        let len = self.len();
        (0..len)
            .step_by(BLOCK)
            .map(move |begin| begin..len.min(begin + BLOCK))
    }

    /// Σ of products in a block: eight running sums, then what is left.
    fn dot_in(&self, other: &Self, block: Range<usize>) -> f64 {
        let product = |i: usize| f64::from(self.at(i)) * f64::from(other.at(i));
        let whole = block.start + block.len() / 8 * 8;
        let mut sums = [0.0f64; 8];
        for i in block.start..whole {
            sums[(i - block.start) % 8] += product(i);
        }
        let rest: f64 = (whole..block.end).map(product).sum();
        sums.iter().sum::<f64>() + rest
    }
}

/// Bounds of a piece of the elements.
#[derive(Clone, Copy)]
pub(crate) struct Piece {
    pub(crate) begin: usize,
    pub(crate) len: usize,
    pub(crate) lower: f32,
    pub(crate) upper: f32,
}

impl Piece {
    pub(crate) fn elements(&self) -> Range<usize> {
        self.begin..self.begin + self.len
    }

    /// Whether the bounds hold an element: it is at one, and a descent would cross it.
    pub(crate) fn holds(&self, x: f32, gradient: f32) -> bool {
        (x <= self.lower && gradient >= 0.0) || (x >= self.upper && gradient <= 0.0)
    }

    pub(crate) fn clamp(&self, value: f32) -> f32 {
        if value < self.lower {
            self.lower
        } else if value > self.upper {
            self.upper
        } else {
            value
        }
    }
}

/// NaN if either is.
fn larger(a: f32, b: f32) -> f32 {
    if a.is_nan() || b.is_nan() {
        f32::NAN
    } else {
        a.max(b)
    }
}

impl Field for SealedField {
    type Bounds = Vec<Piece>;
    type Pairs = SealedPairs;
    type Bands = SealedBands;
    type Costs = SealedCosts;
    type HalfRamp = SealedHalfRamp;

    fn len(&self) -> usize {
        self.memory.len()
    }

    fn zeros_like(&self) -> Self {
        SealedField {
            memory: vec![!0; self.len()],
        }
    }

    fn copy_from(&mut self, other: &Self) {
        self.change(|i, _| other.at(i));
    }

    fn fill(&mut self, value: f32) {
        self.change(|_, _| value);
    }

    fn to_host(&self) -> Vec<f32> {
        (0..self.len()).map(|i| self.at(i)).collect()
    }

    fn write(&mut self, begin: usize, values: &[f32]) {
        for (i, &value) in values.iter().enumerate() {
            self.set(begin + i, value);
        }
    }

    fn dot(&self, other: &Self) -> f64 {
        let sums: Vec<f64> = self.blocks().map(|b| self.dot_in(other, b)).collect();
        sums.iter().sum()
    }

    fn max_abs(&self) -> f32 {
        (0..self.len()).map(|i| self.at(i).abs()).fold(0.0, larger)
    }

    fn max_marked(&self, marks: &Self) -> f32 {
        (0..self.len())
            .filter(|&i| marks.at(i) >= 0.0)
            .map(|i| self.at(i))
            .fold(0.0, larger)
    }

    fn lowest(&self) -> f32 {
        (0..self.len()).map(|i| self.at(i)).fold(0.0, f32::min)
    }

    fn axpy(&mut self, a: f32, x: &Self) {
        self.change(|i, v| v + a * x.at(i));
    }

    fn scale(&mut self, a: f32) {
        self.change(|_, v| v * a);
    }

    fn shift(&mut self, a: f32) {
        self.change(|_, v| v + a);
    }

    fn clamp(&mut self, lower: f32, upper: f32) {
        self.change(|_, v| v.max(lower).min(upper));
    }

    fn multiply(&mut self, other: &Self) {
        self.change(|i, v| v * other.at(i));
    }

    fn keep_positive(&mut self, marks: &Self) {
        self.change(|i, v| if marks.at(i) > 0.0 { v } else { 0.0 });
    }

    fn mix(&mut self, keep: f32, x: &Self) {
        self.change(|i, v| keep * v + (1.0 - keep) * x.at(i));
    }

    fn mix_squares(&mut self, keep: f32, x: &Self) {
        self.change(|i, v| keep * v + (1.0 - keep) * x.at(i) * x.at(i));
    }

    fn divide_by_roots(&mut self, squares: &Self, factor: f32, epsilon: f32) {
        self.change(|i, v| v / ((squares.at(i) * factor).sqrt() + epsilon));
    }

    fn logistic_error(&mut self, target: &Self, midpoint: f32, width: f32) {
        self.change(|i, v| match target.at(i) {
            target if target < 0.0 => 0.0,
            target => 1.0 / (1.0 + ((midpoint - v) / width).exp()) - target,
        });
    }

    fn compile_bounds(&self, bounds: &Bounds) -> Vec<Piece> {
        let mut begin = 0;
        let piece = |(len, lower, upper)| {
            begin += len;
            Piece {
                begin: begin - len,
                len,
                lower,
                upper,
            }
        };
        bounds.pieces().map(piece).collect()
    }

    fn move_along(&mut self, step: &Self, a: f32, bounds: &Vec<Piece>) {
        for piece in bounds {
            for i in piece.elements() {
                self.set(i, piece.clamp(self.at(i) + a * step.at(i)));
            }
        }
    }

    fn project_step(&mut self, x: &Self, gradient: &Self, t: f32, bounds: &Vec<Piece>) -> StepSums {
        let mut sums = StepSums::default();
        for piece in bounds {
            for i in piece.elements() {
                self.set(i, piece.clamp(x.at(i) - t * gradient.at(i)) - x.at(i));
            }
            sums.slope += gradient.dot_in(self, piece.elements());
            sums.square += self.dot_in(self, piece.elements());
        }
        sums
    }

    fn quantize(&mut self, levels: u32, bounds: &Vec<Piece>) {
        let top = self.max_abs();
        let steps = (levels - 1).max(1) as f32;
        for &piece in bounds {
            let upper = if piece.upper.is_finite() {
                piece.upper
            } else {
                top
            };
            let (piece, width) = (Piece { upper, ..piece }, upper - piece.lower);
            for i in piece.elements().filter(|_| width > 0.0) {
                let share = (piece.clamp(self.at(i)) - piece.lower) / width;
                let level = (share * steps + 0.5).floor() / steps;
                self.set(i, piece.clamp(piece.lower + level * width));
            }
        }
    }

    fn free_gradient(&mut self, x: &Self, gradient: &Self, bounds: &Vec<Piece>) {
        for piece in bounds {
            for i in piece.elements() {
                let g = gradient.at(i);
                self.set(i, if piece.holds(x.at(i), g) { 0.0 } else { g });
            }
        }
    }

    fn change_where_moved(&mut self, step: &Self, before: &Self, after: &Self) {
        self.change(|i, _| {
            if step.at(i) == 0.0 {
                0.0
            } else {
                after.at(i) - before.at(i)
            }
        });
    }

    fn secant(&self, before: &Self, after: &Self) -> Secant {
        let mut all = Secant::default();
        for block in self.blocks() {
            let mut sums = Secant::default();
            for i in block {
                let p = f64::from(self.at(i));
                let change = f64::from(after.at(i)) - f64::from(before.at(i));
                let y = if p == 0.0 { 0.0 } else { change };
                sums.pp += p * p;
                sums.py += p * y;
                sums.yy += y * y;
            }
            all.pp += sums.pp;
            all.py += sums.py;
            all.yy += sums.yy;
        }
        all
    }
}
