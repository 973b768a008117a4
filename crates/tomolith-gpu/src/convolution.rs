//! Convolutions of fields on cells, as products of Fourier transforms of zero-padded arrays.
//!
//! Many fields `[y][x][z]` lie one after the other and are transformed at once, axis by axis, to half spectra `[k_y][k_x][k_z]`
//! ([`transforms`](crate::transforms)). Zeros that pad a line are not stored, nor are results on the way back that no cell has.
//!
//! **Cost** memory: 32 bytes a cell and field, twice.

use crate::device::{Buffer, Gpu};
use crate::passes::ENTRY;
use crate::transforms::{Lines, Transform};
use tomolith_core::dose::scattered::OnCells;

/// Fields on cells of one size and the kernels that they meet.
pub(crate) struct Convolution {
    gpu: Gpu,
    /// Along y, x, z.
    cells: [usize; 3],
    padded: [usize; 3],
    row: usize,
    /// Along y, x, z, there and back.
    transforms: [[Transform; 2]; 3],
    /// Kernels that share a binding: the first of them, and the one behind the last.
    kernels: Vec<([usize; 2], Buffer)>,
    /// Of each (row, column) of the matrix of kernels: twice the number of its kernel, and 1 more where that is odd.
    pairs: Buffer,
    columns: usize,
}

/// Lines of one axis: `[outer][k][inner]`.
struct Axis {
    outer: usize,
    inner: usize,
    /// Numbers of a line, and those of its transform that are stored.
    counts: [usize; 2],
    /// Elements from one outer number to the next.
    strides: [usize; 2],
}

impl Convolution {
    /// Of fields on cells, with the matrix of their kernels: of each (row, column) the number of its kernel.
    pub(crate) fn new(gpu: &Gpu, on_cells: &OnCells, matrix: &[Vec<usize>]) -> Self {
        let [nz, ny, nx] = on_cells.grid.layout.grid.shape;
        let [px, py, pz] = on_cells.padded;
        let padded = [py, px, pz];
        let frequencies = Self::frequencies(on_cells.padded);
        let most = (gpu.binding_bytes() as usize / (4 * frequencies)).max(1);
        let upload = |(i, kernels): (usize, &[_])| {
            let values: Vec<&[f32]> = kernels.iter().map(values_of).collect();
            let first = i * most;
            let buffer = gpu.upload(&values.concat());
            ([first, first + kernels.len()], buffer)
        };
        let pair = |&kernel: &usize| 2 * kernel as u32 + u32::from(on_cells.kernels[kernel].is_odd);
        let pairs: Vec<u32> = matrix.iter().flatten().map(pair).collect();
        Convolution {
            gpu: gpu.clone(),
            cells: [ny, nx, nz],
            row: on_cells.grid.layout.row,
            transforms: padded.map(|n| [-1, 1].map(|sign| Transform::new(gpu, n, sign))),
            padded,
            kernels: on_cells
                .kernels
                .chunks(most)
                .enumerate()
                .map(upload)
                .collect(),
            pairs: gpu.upload(&pairs),
            columns: matrix.first().map_or(0, Vec::len),
        }
    }

    /// Elements of a half spectrum of an array of these lengths along x, y, z.
    fn frequencies([px, py, pz]: [usize; 3]) -> usize {
        px * py * (pz / 2 + 1)
    }

    /// Bytes of the largest array that `count` fields at once need in one binding.
    pub(crate) fn bytes(on_cells: &OnCells, count: usize) -> u64 {
        8 * (count * Self::frequencies(on_cells.padded)) as u64
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
        let along_z = Axis {
            outer: count * ny * nx,
            inner: 1,
            counts: [nz, half],
            strides: [self.row, half],
        };
        let along_x = Axis::complex(count * ny, half, [nx, px]);
        let along_y = Axis::complex(count, px * half, [ny, py]);
        let planes = self.pass(2, &FROM_FIELDS, &along_z, 8, fields);
        let planes = self.pass(1, &FORTH, &along_x, 8, &planes);
        self.pass(0, &FORTH, &along_y, 8, &planes)
    }

    fn fields_of(&self, spectra: Buffer, count: usize) -> Buffer {
        let ([ny, nx, nz], [py, px, _]) = (self.cells, self.padded);
        let half = self.half();
        let along_y = Axis::complex(count, px * half, [py, ny]);
        let along_x = Axis::complex(count * ny, half, [px, nx]);
        let along_z = Axis {
            outer: count * ny * nx,
            inner: 1,
            counts: [half, nz],
            strides: [half, self.row],
        };
        let planes = self.pass(0, &BACK, &along_y, 8, &spectra);
        let planes = self.pass(1, &BACK, &along_x, 8, &planes);
        self.pass(2, &TO_FIELDS, &along_z, 4, &planes)
    }

    /// Transforms the lines of an axis into a new array, of elements of so many bytes.
    fn pass(
        &self,
        axis: usize,
        (kernel, way): &(Lines, usize),
        lines: &Axis,
        element: usize,
        source: &Buffer,
    ) -> Buffer {
        let out = (self.gpu).buffer((element * lines.outer * lines.strides[1]) as u64);
        let [inputs, outputs] = lines.counts;
        let [stride, out_stride] = lines.strides;
        let n = self.padded[axis];
        let parameters = [lines.inner, inputs, outputs, stride, out_stride, n].map(|n| n as u32);
        self.transforms[axis][*way].run(
            kernel,
            lines.outer * lines.inner,
            &parameters,
            &[&out, source],
        );
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
        let frequencies = Self::frequencies([px, py, pz]);
        let sums = self.gpu.buffer((8 * outputs * frequencies) as u64);
        // A kernel of the opposite displacement is its transpose
        let sign: f32 = if is_transposed { -1.0 } else { 1.0 };
        for ([first, end], kernels) in &self.kernels {
            let parameters = [
                frequencies as u32,
                inputs as u32,
                outputs as u32,
                self.columns as u32,
                u32::from(is_transposed),
                *first as u32,
                *end as u32,
                sign.to_bits(),
            ];
            self.gpu.run(
                "products of spectra",
                &multiply,
                &parameters,
                &[&sums, spectra, kernels, &self.pairs],
                outputs * frequencies,
            );
        }
        sums
    }
}

fn values_of(kernel: &tomolith_core::dose::scattered::KernelSpectrum) -> &[f32] {
    &kernel.values
}

impl Axis {
    fn complex(outer: usize, inner: usize, [inputs, outputs]: [usize; 2]) -> Self {
        Axis {
            outer,
            inner,
            counts: [inputs, outputs],
            strides: [inputs * inner, outputs * inner],
        }
    }
}

/// Kernels of lines, and which way they go: 0 there, 1 back.
const FROM_FIELDS: (Lines, usize) = (
    Lines {
        name: "transform of fields",
        functions: || {
            let load =
                "if (i < p.inputs) { return vec2(source[at(line, i)], 0.0); } return vec2(0.0);";
            lines(["vec2<f32>", "f32"], load, "value")
        },
        are_neighbors: false,
    },
    0,
);
const FORTH: (Lines, usize) = (
    Lines {
        name: "transform",
        functions: complex_lines,
        are_neighbors: true,
    },
    0,
);
const BACK: (Lines, usize) = (
    Lines {
        name: "transform back",
        functions: complex_lines,
        are_neighbors: true,
    },
    1,
);
const TO_FIELDS: (Lines, usize) = (
    Lines {
        name: "transform to fields",
        functions: || {
            // The other half of the spectrum of a real line is its conjugate
            let load = "if (i < p.inputs) { return source[at(line, i)]; } return source[at(line, p.n - i)] * vec2(1.0, -1.0);";
            lines(["f32", "vec2<f32>"], load, "value.x")
        },
        are_neighbors: false,
    },
    1,
);

fn complex_lines() -> String {
    let load = "if (i < p.inputs) { return source[at(line, i)]; } return vec2(0.0);";
    lines(["vec2<f32>"; 2], load, "value")
}

/// Elements that are written and read, what number i of a line is, and what is stored of its transform.
fn lines([out, source]: [&str; 2], load: &str, stored: &str) -> String {
    format!(
        "struct Parameters {{ lines: u32, first: u32, inner: u32, inputs: u32, outputs: u32, stride: u32, out_stride: u32, n: u32 }}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(2) var<storage, read_write> out: array<{out}>;
@group(0) @binding(3) var<storage, read> source: array<{source}>;
fn at(line: u32, i: u32) -> u32 {{ return line / p.inner * p.stride + i * p.inner + line % p.inner; }}
fn load(line: u32, i: u32) -> vec2<f32> {{ {load} }}
fn store(line: u32, i: u32, value: vec2<f32>) {{
    if (i < p.outputs) {{ out[line / p.inner * p.out_stride + i * p.inner + line % p.inner] = {stored}; }}
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
