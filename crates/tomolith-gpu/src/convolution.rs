//! Convolutions of fields on cells, as products of Fourier transforms of zero-padded arrays.
//!
//! Many fields `[y][x][z]` lie one after the other and are transformed at once, axis by axis, to half spectra `[k_y][k_x][k_z]`. An axis is
//! transformed by its definition,
//!
//! ```text
//! out_j = Σ_k in_k·e^(∓2πi·jk/n)
//! ```
//! since lines are short (cells are large: n is rarely above 200), half of the inputs are zeros that are left out, as is half of the results on the way
//! back, and the sums of a line keep one order.
//!
//! **Cost** for N³ cells about 20·N⁴ multiplications a field and direction. Memory: 32 bytes a cell and field, twice.

use crate::device::{Buffer, Gpu, THREADS};
use crate::passes::ENTRY;
use std::f64::consts::PI;
use tomolith_core::dose::scattered::OnCells;

/// Fields on cells of one size and the kernels that they meet.
pub(crate) struct Convolution {
    gpu: Gpu,
    /// Along y, x, z.
    cells: [usize; 3],
    padded: [usize; 3],
    row: usize,
    /// cos and sin of 2π·i/n along y, x, z.
    tables: [Buffer; 3],
    /// Kernels that share a binding: the first of them, and the one behind the last.
    kernels: Vec<([usize; 2], Buffer)>,
    /// Of each (row, column) of the matrix of kernels: twice the number of its kernel, and 1 more where that is odd.
    pairs: Buffer,
    columns: usize,
}

/// How a kernel reads or writes the lines of an axis.
#[derive(Clone, Copy, PartialEq)]
enum Numbers {
    /// Fields, whose z lines are padded to rows.
    Real,
    Complex,
}

/// Lines of one axis: `[outer][k][inner]`.
struct Lines {
    outer: usize,
    inner: usize,
    inputs: usize,
    outputs: usize,
    /// Elements from one outer number to the next.
    strides: [usize; 2],
    from: Numbers,
    to: Numbers,
}

/// Products of a dispatch at most: below 100 ms on a small card.
const MOST_PRODUCTS: usize = 1 << 29;
/// A dispatch of more products than these is submitted by itself.
const MOST_TOGETHER: usize = 1 << 26;

impl Convolution {
    /// Of fields on cells, with the matrix of their kernels: of each (row, column) the number of its kernel.
    pub(crate) fn new(gpu: &Gpu, of: &OnCells, matrix: &[Vec<usize>]) -> Self {
        let [nz, ny, nx] = of.layout.grid.shape;
        let [px, py, pz] = of.padded;
        let padded = [py, px, pz];
        let own = Self::frequencies(of.padded);
        let most = (gpu.binding_bytes() as usize / (4 * own)).max(1);
        let upload = |(i, kernels): (usize, &[_])| {
            let values: Vec<&[f32]> = kernels.iter().map(values_of).collect();
            let first = i * most;
            let buffer = gpu.upload(bytemuck::cast_slice(&values.concat()));
            ([first, first + kernels.len()], buffer)
        };
        let pair = |&kernel: &usize| 2 * kernel as u32 + u32::from(of.kernels[kernel].is_odd);
        let pairs: Vec<u32> = matrix.iter().flatten().map(pair).collect();
        Convolution {
            gpu: gpu.clone(),
            cells: [ny, nx, nz],
            row: of.layout.row,
            tables: padded.map(|n| gpu.upload(bytemuck::cast_slice(&turns(n)))),
            padded,
            kernels: of.kernels.chunks(most).enumerate().map(upload).collect(),
            pairs: gpu.upload(bytemuck::cast_slice(&pairs)),
            columns: matrix.first().map_or(0, Vec::len),
        }
    }

    /// Elements of a half spectrum of an array of these lengths along x, y, z.
    fn frequencies([px, py, pz]: [usize; 3]) -> usize {
        px * py * (pz / 2 + 1)
    }

    /// Bytes of the largest array that `count` fields at once need in one binding.
    pub(crate) fn bytes(of: &OnCells, count: usize) -> u64 {
        8 * (count * Self::frequencies(of.padded)) as u64
    }

    /// The matrix of kernels, or its transpose, times `inputs` fields: as many new ones as asked for, of rows that follow each other.
    pub(crate) fn apply(
        &self,
        fields: &Buffer,
        [inputs, outputs]: [usize; 2],
        is_transposed: bool,
    ) -> Buffer {
        let spectra = self.transform(fields, inputs);
        let products = self.multiply(&spectra, [inputs, outputs], is_transposed);
        self.fields_of(products, outputs)
    }

    fn half(&self) -> usize {
        self.padded[2] / 2 + 1
    }

    fn transform(&self, fields: &Buffer, count: usize) -> Buffer {
        let ([ny, nx, nz], [py, px, _]) = (self.cells, self.padded);
        let half = self.half();
        let along_z = Lines {
            outer: count * ny * nx,
            inner: 1,
            inputs: nz,
            outputs: half,
            strides: [self.row, half],
            from: Numbers::Real,
            to: Numbers::Complex,
        };
        let along_x = Lines::complex(count * ny, half, [nx, px]);
        let along_y = Lines::complex(count, px * half, [ny, py]);
        let planes = self.pass(2, &along_z, -1.0, fields);
        let planes = self.pass(1, &along_x, -1.0, &planes);
        self.pass(0, &along_y, -1.0, &planes)
    }

    fn fields_of(&self, spectra: Buffer, count: usize) -> Buffer {
        let ([ny, nx, nz], [py, px, _]) = (self.cells, self.padded);
        let half = self.half();
        let along_y = Lines::complex(count, px * half, [py, ny]);
        let along_x = Lines::complex(count * ny, half, [px, nx]);
        let along_z = Lines {
            outer: count * ny * nx,
            inner: 1,
            inputs: half,
            outputs: nz,
            strides: [half, self.row],
            from: Numbers::Complex,
            to: Numbers::Real,
        };
        let planes = self.pass(0, &along_y, 1.0, &spectra);
        let planes = self.pass(1, &along_x, 1.0, &planes);
        self.pass(2, &along_z, 1.0, &planes)
    }

    /// Transforms the lines of an axis into a new array.
    fn pass(&self, axis: usize, lines: &Lines, sign: f32, source: &Buffer) -> Buffer {
        let element = if lines.to == Numbers::Real { 4 } else { 8 };
        let out = (self.gpu).buffer((element * lines.outer * lines.strides[1]) as u64);
        let products = lines.inner * lines.inputs * lines.outputs;
        let together = (MOST_PRODUCTS / products).max(1);
        for begin in (0..lines.outer).step_by(together) {
            let count = together.min(lines.outer - begin);
            let parameters = [
                count as u32,
                begin as u32,
                lines.inner as u32,
                lines.inputs as u32,
                lines.outputs as u32,
                lines.strides[0] as u32,
                lines.strides[1] as u32,
                self.padded[axis] as u32,
                sign.to_bits(),
            ];
            let groups = (count * lines.inner * lines.outputs).div_ceil(THREADS as usize);
            let (from, to) = (lines.from, lines.to);
            self.gpu.run(
                lines.name(),
                &|| transform(from, to),
                &parameters,
                &[&out, source, &self.tables[axis]],
                groups as u64,
            );
            if count * products > MOST_TOGETHER {
                self.gpu.submit();
            }
        }
        out
    }

    /// Spectra times kernels.
    fn multiply(
        &self,
        spectra: &Buffer,
        [inputs, outputs]: [usize; 2],
        is_transposed: bool,
    ) -> Buffer {
        let [py, px, pz] = self.padded;
        let own = Self::frequencies([px, py, pz]);
        let sums = self.gpu.buffer((8 * outputs * own) as u64);
        // A kernel of the opposite displacement is its transpose
        let sign: f32 = if is_transposed { -1.0 } else { 1.0 };
        for ([first, end], kernels) in &self.kernels {
            let parameters = [
                own as u32,
                inputs as u32,
                outputs as u32,
                self.columns as u32,
                u32::from(is_transposed),
                *first as u32,
                *end as u32,
                sign.to_bits(),
            ];
            let groups = (outputs * own).div_ceil(THREADS as usize);
            self.gpu.run(
                "products of spectra",
                &multiply,
                &parameters,
                &[&sums, spectra, kernels, &self.pairs],
                groups as u64,
            );
        }
        sums
    }
}

fn values_of(kernel: &tomolith_core::dose::scattered::KernelSpectrum) -> &[f32] {
    &kernel.values
}

impl Lines {
    fn complex(outer: usize, inner: usize, [inputs, outputs]: [usize; 2]) -> Self {
        Lines {
            outer,
            inner,
            inputs,
            outputs,
            strides: [inputs * inner, outputs * inner],
            from: Numbers::Complex,
            to: Numbers::Complex,
        }
    }

    fn name(&self) -> &'static str {
        match (self.from, self.to) {
            (Numbers::Real, _) => "transform of fields",
            (_, Numbers::Real) => "transform to fields",
            _ => "transform",
        }
    }
}

/// cos and sin of 2π·i/n.
fn turns(n: usize) -> Vec<[f32; 2]> {
    let turn = |i: usize| {
        let (sin, cos) = (2.0 * PI * i as f64 / n as f64).sin_cos();
        [cos as f32, sin as f32]
    };
    (0..n).map(turn).collect()
}

fn transform(from: Numbers, to: Numbers) -> String {
    let element = |numbers| match numbers {
        Numbers::Real => "f32",
        Numbers::Complex => "vec2<f32>",
    };
    let (source, out) = (element(from), element(to));
    let (value, sum) = match (from, to) {
        (Numbers::Real, _) => ("vec2(source[at], 0.0)", "sum"),
        (_, Numbers::Complex) => ("source[at]", "sum"),
        // Of a half spectrum every frequency but the first and the last stands for two
        (_, Numbers::Real) => (
            "source[at] * select(2.0, 1.0, k == 0u || k + 1u == p.inputs)",
            "sum.x",
        ),
    };
    format!(
        "struct Parameters {{ count: u32, first: u32, inner: u32, inputs: u32, outputs: u32, stride: u32, out_stride: u32, n: u32, sign: f32 }}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read_write> out: array<{out}>;
@group(0) @binding(2) var<storage, read> source: array<{source}>;
@group(0) @binding(3) var<storage, read> turns: array<vec2<f32>>;
{ENTRY}
    let t = group * 256u + thread;
    let inner = t % p.inner;
    let j = t / p.inner % p.outputs;
    let number = t / (p.inner * p.outputs);
    if (number >= p.count) {{ return; }}
    let outer = p.first + number;
    var at = outer * p.stride + inner;
    var turn = 0u;
    var sum = vec2(0.0);
    for (var k = 0u; k < p.inputs; k++) {{
        let value = {value};
        let w = vec2(turns[turn].x, p.sign * turns[turn].y);
        sum += vec2(value.x * w.x - value.y * w.y, value.y * w.x + value.x * w.y);
        at += p.inner;
        turn += j;
        if (turn >= p.n) {{ turn -= p.n; }}
    }}
    out[outer * p.out_stride + j * p.inner + inner] = {sum};
}}"
    )
}

fn multiply() -> String {
    format!(
        "struct Parameters {{ n: u32, inputs: u32, outputs: u32, columns: u32, is_transposed: u32, first: u32, end: u32, sign: f32 }}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read_write> sums: array<vec2<f32>>;
@group(0) @binding(2) var<storage, read> spectra: array<vec2<f32>>;
@group(0) @binding(3) var<storage, read> kernels: array<f32>;
@group(0) @binding(4) var<storage, read> pairs: array<u32>;
{ENTRY}
    let t = group * 256u + thread;
    if (t >= p.outputs * p.n) {{ return; }}
    let i = t % p.n;
    let a = t / p.n;
    var sum = vec2(0.0);
    if (p.first > 0u) {{ sum = sums[t]; }}
    for (var b = 0u; b < p.inputs; b++) {{
        let pair = pairs[select(a * p.columns + b, b * p.columns + a, p.is_transposed == 1u)];
        let kernel = pair / 2u;
        if (kernel < p.first || kernel >= p.end) {{ continue; }}
        let k = kernels[(kernel - p.first) * p.n + i];
        let v = spectra[b * p.n + i];
        sum += k * select(v, p.sign * vec2(-v.y, v.x), pair % 2u == 1u);
    }}
    sums[t] = sum;
}}"
    )
}
