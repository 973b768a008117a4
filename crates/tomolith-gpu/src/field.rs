//! Vectors of f32 on the card.
//!
//! A field is cut into pieces, each at most as large as a binding and a whole number of rows of lanes. The formulas are those of
//! [`Field`]; sums are in f32 on the card and in f64 on the host ([`passes`](crate::passes)), so they differ from the host's by about 1e-7 of the sum of
//! magnitudes, and are the same in every run on one card and driver.

use crate::bands::GpuBands;
use crate::costs::GpuCosts;
use crate::counter::GpuCounter;
use crate::device::{Buffer, Gpu};
use crate::half_ramp::GpuHalfRamp;
use crate::pairs::GpuPairs;
use crate::passes::{Operand, Pass};
use crate::stretches::Stretches;
use std::borrow::Cow;
use std::ops::Range;
use tomolith_core::dose::{DoseLayout, Facts, PatternLayout, Space};
use tomolith_core::error::Result;
use tomolith_core::field::costs::PixelPairs;
use tomolith_core::field::{Bounds, Counter, Field, Secant, StepSums, Stretch};

/// A [`Field`] on a graphics card.
pub struct GpuField {
    gpu: Gpu,
    pieces: Vec<Buffer>,
    lengths: Vec<usize>,
    len: usize,
}

/// Bounds of the elements of a field on the card.
pub struct GpuBounds {
    gpu: Gpu,
    lengths: Vec<usize>,
    limits: Limits,
}

enum Limits {
    /// Lower and upper bound of all elements.
    Alike([f32; 2]),
    Each {
        lower: GpuField,
        upper: GpuField,
    },
}

/// The largest of an ordered bit pattern is the largest number; a NaN is larger than all.
const KEYS: &str = "
fn is_nan(v: f32) -> bool { return (bitcast<u32>(v) & 0x7fffffffu) > 0x7f800000u; }
fn key(v: f32) -> u32 { return select(select(0u, bitcast<u32>(v), v > 0.0), 0x7fc00000u, is_nan(v)); }
";

/// A value brought into bounds; a NaN stays one. Compilers take a selection by comparison for the instruction that drops it.
pub(crate) const CLAMP: &str = "
fn clamped(v: f32, low: f32, high: f32) -> f32 {
    if ((bitcast<u32>(v) & 0x7fffffffu) > 0x7f800000u) { return v; }
    return min(max(v, low), high);
}
";

impl GpuField {
    /// `len` zeros, in pieces of whole rows of so many elements.
    pub(crate) fn zeros(gpu: &Gpu, len: usize, row: usize) -> Self {
        let mut field = Self::uninitialized(gpu, len, row);
        field.clear(0..len);
        field
    }

    fn uninitialized(gpu: &Gpu, len: usize, row: usize) -> Self {
        let row = row.max(1);
        // Packed elements: a piece is a whole number of words of four labels
        let step = if row.is_multiple_of(4) { row } else { 4 * row };
        let most = gpu.binding_bytes() as usize / 4;
        let piece = (most / step * step).max(step);
        let mut lengths: Vec<usize> = (0..len)
            .step_by(piece)
            .map(|begin| piece.min(len - begin))
            .collect();
        if lengths.is_empty() {
            lengths.push(0);
        }
        Self::of_pieces(gpu, lengths)
    }

    fn of_pieces(gpu: &Gpu, lengths: Vec<usize>) -> Self {
        GpuField {
            gpu: gpu.clone(),
            pieces: lengths.iter().map(|&n| gpu.buffer(4 * n as u64)).collect(),
            len: lengths.iter().sum(),
            lengths,
        }
    }

    /// Zeros for the doses of a layout and what lies before it.
    #[must_use]
    pub fn for_dose(gpu: &Gpu, layout: &DoseLayout) -> Self {
        Self::zeros(gpu, layout.offset + layout.len(), layout.row)
    }

    /// Zeros as patterns or as a dose of a model.
    pub(crate) fn of_space(
        gpu: &Gpu,
        space: Space,
        patterns: &[PatternLayout],
        output: &DoseLayout,
    ) -> Result<Self> {
        let field = match space {
            Space::Dose => Self::for_dose(gpu, output),
            Space::Patterns => Self::of_lengths(gpu, pieces_of_frames(gpu, patterns)),
        };
        gpu.check().map(|()| field)
    }

    /// Zeros in pieces of these lengths.
    pub(crate) fn of_lengths(gpu: &Gpu, lengths: Vec<usize>) -> Self {
        let mut field = Self::of_pieces(gpu, lengths);
        field.clear(0..field.len);
        field
    }

    /// Elements of any content, in the same pieces.
    pub(crate) fn scratch_like(&self) -> Self {
        Self::of_pieces(&self.gpu, self.lengths.clone())
    }

    /// Its pieces and their bytes.
    fn parts(&self) -> Vec<(&Buffer, u64)> {
        let pieces = self.pieces.iter().zip(&self.lengths);
        pieces.map(|(piece, &n)| (piece, 4 * n as u64)).collect()
    }

    /// Copies to host memory that is there.
    pub(crate) fn read_into(&self, values: &mut [f32]) {
        self.gpu
            .read_into(&self.parts(), bytemuck::cast_slice_mut(values));
    }

    /// The card.
    #[must_use]
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    pub(crate) fn pieces(&self) -> &[Buffer] {
        &self.pieces
    }

    /// Elements of each piece.
    pub(crate) fn lengths(&self) -> &[usize] {
        &self.lengths
    }

    /// First element and length of each piece.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        let mut begin = 0;
        self.lengths.iter().map(move |&n| {
            let range = begin..begin + n;
            begin = range.end;
            range
        })
    }

    fn must_match(&self, other: &GpuField) {
        assert!(self.gpu.is(&other.gpu), "fields of two graphics cards");
        assert_eq!(self.lengths, other.lengths, "fields of different length");
    }

    /// y ← formula of `y[i]`, `x[i]` and the numbers.
    fn update(&mut self, name: &str, body: &str, others: &[&GpuField], a: [f32; 4]) {
        others.iter().for_each(|other| self.must_match(other));
        let pass = Pass {
            name,
            functions: CLAMP,
            body,
            numbers: [a, [0.0; 4], [0.0; 4]],
        };
        let names = ["x", "z", "w"];
        let mut operands = vec![Operand::written("y", &self.pieces)];
        let reads = names.into_iter().zip(others);
        operands.extend(reads.map(|(name, other)| Operand::read(name, &other.pieces)));
        pass.each(&self.gpu, &operands, &self.lengths);
    }

    /// Sums over elements of `x[i]` and those of others.
    fn sums(&self, name: &str, body: &str, others: &[&GpuField], count: usize) -> Vec<f64> {
        others.iter().for_each(|other| self.must_match(other));
        let pass = Pass {
            name,
            functions: "",
            body,
            numbers: [[0.0; 4]; 3],
        };
        let names = ["z", "w"];
        let mut operands = vec![Operand::read("x", &self.pieces)];
        let reads = names.into_iter().zip(others);
        operands.extend(reads.map(|(name, other)| Operand::read(name, &other.pieces)));
        pass.sums(&self.gpu, &operands, &self.lengths, count)
    }

    fn most(&self, name: &str, body: &str, others: &[&GpuField]) -> f32 {
        others.iter().for_each(|other| self.must_match(other));
        let pass = Pass {
            name,
            functions: KEYS,
            body,
            numbers: [[0.0; 4]; 3],
        };
        let mut operands = vec![Operand::read("x", &self.pieces)];
        operands.extend(others.iter().map(|other| Operand::read("z", &other.pieces)));
        f32::from_bits(pass.most(&self.gpu, &operands, &self.lengths))
    }
}

impl Clone for GpuField {
    fn clone(&self) -> Self {
        let mut copy = self.scratch_like();
        copy.copy_from(self);
        copy
    }
}

impl GpuBounds {
    /// The operands of a pass and how its body finds `low` and `high` of element i; numbers go to `p.c`.
    pub(crate) fn operands(&self) -> (Vec<Operand<'_>>, &'static str, [f32; 4]) {
        match &self.limits {
            Limits::Alike([lower, upper]) => (
                Vec::new(),
                "let low = p.c.x; let high = p.c.y;",
                [*lower, *upper, 0.0, 0.0],
            ),
            Limits::Each { lower, upper } => (
                vec![
                    Operand::read("lower", &lower.pieces),
                    Operand::read("upper", &upper.pieces),
                ],
                "let low = lower[i]; let high = upper[i];",
                [0.0; 4],
            ),
        }
    }

    /// Of a kernel's name: bounds that are alike have another source.
    pub(crate) fn suffix(&self) -> &'static str {
        match self.limits {
            Limits::Alike(_) => "alike",
            Limits::Each { .. } => "each",
        }
    }

    /// A field with such bounds, of any content.
    pub(crate) fn new_field(&self) -> GpuField {
        GpuField::of_pieces(&self.gpu, self.lengths.clone())
    }
}

/// `y` and other fields with bounds; what a step along them does.
struct Bounded<'a> {
    name: &'a str,
    body: &'a str,
    reads: &'a [(&'static str, &'a GpuField)],
    a: [f32; 4],
}

impl GpuField {
    fn bounded(&mut self, call: &Bounded<'_>, bounds: &GpuBounds, count: usize) -> Vec<f64> {
        let (of_bounds, find, c) = bounds.operands();
        let mut operands = vec![Operand::written("y", &self.pieces)];
        let reads = call.reads.iter();
        operands.extend(reads.map(|(name, field)| Operand::read(name, &field.pieces)));
        operands.extend(of_bounds);
        let pass = Pass {
            name: &format!("{} {}", call.name, bounds.suffix()),
            functions: CLAMP,
            body: &format!("{find} {}", call.body),
            numbers: [call.a, [0.0; 4], c],
        };
        if count > 0 {
            return pass.sums(&self.gpu, &operands, &self.lengths, count);
        }
        pass.each(&self.gpu, &operands, &self.lengths);
        Vec::new()
    }
}

/// Lengths of pieces of a pattern field: whole frames, each piece no larger than a binding.
fn pieces_of_frames(gpu: &Gpu, patterns: &[PatternLayout]) -> Vec<usize> {
    let most = gpu.binding_bytes() as usize / 4;
    let mut lengths = vec![0];
    for layout in patterns {
        let columns = layout.grid.columns.max(1);
        for runs in layout.runs.chunks(columns) {
            let frame: usize = runs.iter().map(|run| run.count as usize).sum();
            let last = lengths.len() - 1;
            if lengths[last] + frame > most {
                lengths.push(0);
            }
            let last = lengths.len() - 1;
            lengths[last] += frame;
        }
    }
    lengths
}

impl Field for GpuField {
    type Bounds = GpuBounds;
    type Pairs = GpuPairs;
    type Bands = GpuBands;
    type Costs = GpuCosts;
    type HalfRamp = GpuHalfRamp;

    fn len(&self) -> usize {
        self.len
    }

    fn zeros_like(&self) -> Self {
        let mut field = self.scratch_like();
        field.clear(0..self.len);
        field
    }

    fn zeros_of(&self, facts: &Facts<'_>, space: Space) -> Self {
        match (space, facts.outputs.last()) {
            (Space::Dose, Some(output)) => Self::for_dose(&self.gpu, output),
            (Space::Dose, None) => Self::zeros(&self.gpu, 0, 1),
            (Space::Patterns, _) => {
                Self::of_lengths(&self.gpu, pieces_of_frames(&self.gpu, facts.patterns))
            }
        }
    }

    fn set_stretches(&mut self, adds: bool, a: f32, x: &Self, stretches: &[Stretch]) {
        assert!(self.gpu.is(&x.gpu), "fields of two graphics cards");
        let pairs = stretches.iter().map(|part| PixelPairs {
            first: part.to,
            second: part.from,
            count: part.count,
            weight: 1.0,
        });
        let both = Stretches::new(&self.gpu, [self, x], pairs);
        let (name, body) = match adds {
            true => ("add stretches", "y[i] += p.a.x * x[j];"),
            false => ("set stretches", "y[i] = p.a.x * x[j];"),
        };
        let pass = Pass {
            name,
            functions: "",
            body,
            numbers: [[a, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4]],
        };
        let sides = [
            (Operand::written("y", &self.pieces), 0),
            (Operand::read("x", &x.pieces), 1),
        ];
        both.each(&self.gpu, &pass, &sides);
    }

    fn clear(&mut self, elements: Range<usize>) {
        for (range, piece) in self.ranges().zip(&self.pieces) {
            let begin = range.start.max(elements.start);
            let end = range.end.min(elements.end);
            if begin < end {
                let [begin, count] = [begin - range.start, end - begin].map(|n| 4 * n as u64);
                self.gpu.clear_part(piece, begin, count);
            }
        }
    }

    fn copy_from(&mut self, other: &Self) {
        self.must_match(other);
        for ((to, from), &n) in self.pieces.iter().zip(&other.pieces).zip(&self.lengths) {
            self.gpu.copy(from, to, 4 * n as u64);
        }
    }

    fn fill(&mut self, value: f32) {
        if value.to_bits() == 0 {
            return self.clear(0..self.len);
        }
        self.update("fill", "y[i] = p.a.x;", &[], [value, 0.0, 0.0, 0.0]);
    }

    fn to_host(&self) -> Vec<f32> {
        let mut values = vec![0.0; self.len];
        self.read_into(&mut values);
        values
    }

    fn counter(&self, labels: &[u8]) -> Option<Box<dyn Counter<Self>>> {
        Some(Box::new(GpuCounter::new(labels, self)))
    }

    fn check(&self) -> Result<()> {
        self.gpu.check()
    }

    fn host_bytes(&self) -> Cow<'_, [u8]> {
        Cow::Owned(self.gpu.read(&self.parts()))
    }

    fn write(&mut self, begin: usize, values: &[f32]) {
        for (range, piece) in self.ranges().zip(&self.pieces) {
            let from = range.start.max(begin);
            let end = range.end.min(begin + values.len());
            if from < end {
                let part = &values[from - begin..end - begin];
                let at = 4 * (from - range.start) as u64;
                self.gpu.write(piece, at, bytemuck::cast_slice(part));
            }
        }
    }

    fn dot(&self, other: &Self) -> f64 {
        self.sums("dot", "s0 += x[i] * z[i];", &[other], 1)[0]
    }

    fn max_abs(&self) -> f32 {
        self.most("max_abs", "s0 = max(s0, key(abs(x[i])));", &[])
    }

    fn max_marked(&self, marks: &Self) -> f32 {
        let body = "if (!(z[i] < 0.0)) { s0 = max(s0, key(x[i])); }";
        self.most("max_marked", body, &[marks])
    }

    fn lowest(&self) -> f32 {
        let body = "if (!is_nan(x[i])) { s0 = max(s0, key(-x[i])); }";
        -self.most("lowest", body, &[])
    }

    fn axpy(&mut self, a: f32, x: &Self) {
        self.update("axpy", "y[i] += p.a.x * x[i];", &[x], [a, 0.0, 0.0, 0.0]);
    }

    fn scale(&mut self, a: f32) {
        self.update("scale", "y[i] = p.a.x * y[i];", &[], [a, 0.0, 0.0, 0.0]);
    }

    fn shift(&mut self, a: f32) {
        self.update("shift", "y[i] = y[i] + p.a.x;", &[], [a, 0.0, 0.0, 0.0]);
    }

    fn clamp(&mut self, lower: f32, upper: f32) {
        let body = "y[i] = clamped(y[i], p.a.x, p.a.y);";
        self.update("clamp", body, &[], [lower, upper, 0.0, 0.0]);
    }

    fn multiply(&mut self, other: &Self) {
        self.update("multiply", "y[i] = y[i] * x[i];", &[other], [0.0; 4]);
    }

    fn keep_positive(&mut self, marks: &Self) {
        let body = "y[i] = select(0.0, y[i], x[i] > 0.0);";
        self.update("keep_positive", body, &[marks], [0.0; 4]);
    }

    fn mix(&mut self, keep: f32, x: &Self) {
        let body = "y[i] = p.a.x * y[i] + (1.0 - p.a.x) * x[i];";
        self.update("mix", body, &[x], [keep, 0.0, 0.0, 0.0]);
    }

    fn mix_squares(&mut self, keep: f32, x: &Self) {
        let body = "y[i] = p.a.x * y[i] + (1.0 - p.a.x) * x[i] * x[i];";
        self.update("mix_squares", body, &[x], [keep, 0.0, 0.0, 0.0]);
    }

    fn divide_by_roots(&mut self, squares: &Self, factor: f32, epsilon: f32) {
        let body = "y[i] = y[i] / (sqrt(x[i] * p.a.x) + p.a.y);";
        self.update(
            "divide_by_roots",
            body,
            &[squares],
            [factor, epsilon, 0.0, 0.0],
        );
    }

    fn logistic_error(&mut self, target: &Self, midpoint: f32, width: f32) {
        let body = "let wanted = x[i];
        y[i] = select(1.0 / (1.0 + exp((p.a.x - y[i]) / p.a.y)) - wanted, 0.0, wanted < 0.0);";
        self.update(
            "logistic_error",
            body,
            &[target],
            [midpoint, width, 0.0, 0.0],
        );
    }

    fn compile_bounds(&self, bounds: &Bounds) -> GpuBounds {
        assert_eq!(self.len, bounds.len(), "bounds of another length");
        let mut pieces = bounds.pieces().map(|(_, lower, upper)| [lower, upper]);
        let first = pieces.next().unwrap_or([0.0, f32::INFINITY]);
        let limits = if pieces.all(|piece| piece == first) {
            Limits::Alike(first)
        } else {
            let field = |side: fn([f32; 2]) -> f32| {
                let runs = bounds.pieces();
                let values =
                    runs.flat_map(|(n, low, high)| std::iter::repeat_n(side([low, high]), n));
                let mut field = self.scratch_like();
                field.copy_from_host(&values.collect::<Vec<f32>>());
                field
            };
            Limits::Each {
                lower: field(|[low, _]| low),
                upper: field(|[_, high]| high),
            }
        };
        GpuBounds {
            gpu: self.gpu.clone(),
            lengths: self.lengths.clone(),
            limits,
        }
    }

    fn move_along(&mut self, step: &Self, a: f32, bounds: &GpuBounds) {
        self.must_match(step);
        let call = Bounded {
            name: "move_along",
            body: "y[i] = clamped(y[i] + p.a.x * step[i], low, high);",
            reads: &[("step", step)],
            a: [a, 0.0, 0.0, 0.0],
        };
        self.bounded(&call, bounds, 0);
    }

    fn project_step(&mut self, x: &Self, gradient: &Self, t: f32, bounds: &GpuBounds) -> StepSums {
        self.must_match(x);
        self.must_match(gradient);
        let call = Bounded {
            name: "project_step",
            body: "let g = gradient[i];
            let step = clamped(x[i] - p.a.x * g, low, high) - x[i];
            y[i] = step; s0 += g * step; s1 += step * step;",
            reads: &[("x", x), ("gradient", gradient)],
            a: [t, 0.0, 0.0, 0.0],
        };
        let sums = self.bounded(&call, bounds, 2);
        StepSums {
            slope: sums[0],
            square: sums[1],
        }
    }

    fn quantize(&mut self, levels: u32, bounds: &GpuBounds) {
        let top = self.max_abs();
        let steps = levels.saturating_sub(1).max(1) as f32;
        let call = Bounded {
            name: "quantize",
            // An upper bound that is not finite has the bits of infinity
            body: "let above = select(high, p.a.y, bitcast<u32>(high) == 0x7f800000u);
            let width = above - low;
            if (width > 0.0) {
                let share = (clamped(y[i], low, above) - low) / width;
                let level = floor(share * p.a.x + 0.5) / p.a.x;
                y[i] = clamped(low + level * width, low, above);
            }",
            reads: &[],
            a: [steps, top, 0.0, 0.0],
        };
        self.bounded(&call, bounds, 0);
    }

    fn free_gradient(&mut self, x: &Self, gradient: &Self, bounds: &GpuBounds) {
        self.must_match(x);
        self.must_match(gradient);
        let call = Bounded {
            name: "free_gradient",
            body: "let g = gradient[i];
            let held = (x[i] <= low && g >= 0.0) || (x[i] >= high && g <= 0.0);
            y[i] = select(g, 0.0, held);",
            reads: &[("x", x), ("gradient", gradient)],
            a: [0.0; 4],
        };
        self.bounded(&call, bounds, 0);
    }

    fn change_where_moved(&mut self, step: &Self, before: &Self, after: &Self) {
        let body = "y[i] = select(w[i] - z[i], 0.0, x[i] == 0.0);";
        self.update("change_where_moved", body, &[step, before, after], [0.0; 4]);
    }

    fn secant(&self, before: &Self, after: &Self) -> Secant {
        let body = "let q = x[i];
        let y = select(w[i] - z[i], 0.0, q == 0.0);
        s0 += q * q; s1 += q * y; s2 += y * y;";
        let sums = self.sums("secant", body, &[before, after], 3);
        Secant {
            pp: sums[0],
            py: sums[1],
            yy: sums[2],
        }
    }
}
