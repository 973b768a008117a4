//! Counts of a dose over part and void on the card: its smallest and largest values, and a histogram.
//!
//! Whole numbers and comparisons, so that the print of a dose has the same numbers as on the host. Every group counts 16,384 elements in its shared
//! memory, and adds what it found to one table of 8 kB: that is all that leaves the card.

use crate::device::{Buffer, Gpu};
use crate::field::GpuField;
use crate::passes::{ENTRY, Operand, Pass, words};
use tomolith_core::field::counter::{BINS, Counter};
use tomolith_core::target::label::{OUTSIDE, PART, VOID};

/// Elements of a group.
const CHUNK: u32 = 1 << 14;

/// The label of element i; whether the bits are those of no number; and whole numbers in the order of the others.
const FUNCTIONS: &str = "
fn label_at(i: u32) -> u32 { return (labels[i / 4u] >> (8u * (i % 4u))) & 255u; }
fn is_nan(v: f32) -> bool { return (bitcast<u32>(v) & 0x7fffffffu) > 0x7f800000u; }
fn key(v: f32) -> u32 {
    let bits = bitcast<u32>(v);
    return select(bits | 0x80000000u, ~bits, (bits >> 31u) == 1u);
}
";

/// The inverse of a shader's `key`, which is 0 for no number at all.
fn value_of(key: u32) -> f32 {
    f32::from_bits(if key >> 31 == 1 {
        key & !(1 << 31)
    } else {
        !key
    })
}

/// Labels in the pieces of a field.
pub(crate) struct GpuCounter {
    gpu: Gpu,
    /// Four a word.
    labels: Vec<Buffer>,
}

impl GpuCounter {
    /// Labels of the first elements of such a field; the others do not count.
    pub(crate) fn new(labels: &[u8], like: &GpuField) -> Self {
        let of_piece = |range: std::ops::Range<usize>| {
            let [begin, end] = [range.start, range.end].map(|at| at.min(labels.len()));
            let mut padded = labels[begin..end].to_vec();
            padded.resize(range.len().next_multiple_of(4), OUTSIDE);
            like.gpu().upload(&padded)
        };
        GpuCounter {
            gpu: like.gpu().clone(),
            labels: like.ranges().map(of_piece).collect(),
        }
    }
}

impl Counter<GpuField> for GpuCounter {
    fn ranges(&self, values: &GpuField) -> [[f32; 2]; 2] {
        let body = format!(
            "let v = x[i];
        let label = label_at(i);
        if (!is_nan(v)) {{
            let k = key(v);
            if (label == {PART}u) {{ s0 = max(s0, ~k); s1 = max(s1, k); }}
            if (label == {VOID}u) {{ s2 = max(s2, ~k); s3 = max(s3, k); }}
        }}"
        );
        let pass = Pass {
            name: "ranges of part and void",
            functions: FUNCTIONS,
            body: &body,
            numbers: [[0.0; 4]; 3],
        };
        let operands = [
            Operand::read("x", values.pieces()),
            Operand::read("labels", &self.labels).words(),
        ];
        let keys = pass.mosts(&self.gpu, &operands, values.lengths(), 4);
        let end = |key: u32, none: f32| if key == 0 { none } else { value_of(key) };
        [0, 2].map(|k| {
            // The smallest value has the largest inverted key
            let low = if keys[k] == 0 { 0 } else { !keys[k] };
            [end(low, f32::INFINITY), end(keys[k + 1], f32::NEG_INFINITY)]
        })
    }

    fn counts(&self, values: &GpuField, low: f32, scale: f32) -> Vec<[u64; 2]> {
        let bytes = 8 * BINS as u64;
        let table = self.gpu.zeros(bytes);
        let pieces = values.pieces().iter().zip(&self.labels);
        for ((x, labels), &n) in pieces.zip(values.lengths()) {
            let parameters = [n as u32, low.to_bits(), scale.to_bits()];
            let groups = (n as u64).div_ceil(u64::from(CHUNK));
            let buffers = [x, labels, &table];
            let name = "histogram of part and void";
            self.gpu
                .run_groups(name, &histogram, &parameters, &buffers, groups);
        }
        let found = words(&self.gpu.read(&[(&table, bytes)]));
        let pairs = found.chunks(2).map(|bin| [bin[0], bin[1]].map(u64::from));
        pairs.collect()
    }
}

fn histogram() -> String {
    let (all, last) = (2 * BINS, BINS - 1);
    format!(
        "struct Parameters {{ n: u32, low: f32, scale: f32 }}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read> x: array<f32>;
@group(0) @binding(2) var<storage, read> labels: array<u32>;
@group(0) @binding(3) var<storage, read_write> table: array<atomic<u32>>;
var<workgroup> own: array<atomic<u32>, {all}>;
{FUNCTIONS}{ENTRY}
    for (var k = thread; k < {all}u; k += 256u) {{ atomicStore(&own[k], 0u); }}
    workgroupBarrier();
    let begin = group * {CHUNK}u;
    let end = min(begin + {CHUNK}u, p.n);
    for (var i = begin + thread; i < end; i += 256u) {{
        let label = label_at(i);
        if (label == {PART}u || label == {VOID}u) {{
            let place = (x[i] - p.low) * p.scale;
            let bin = select(u32(clamp(place, 0.0, {last}.0)), 0u, is_nan(place));
            atomicAdd(&own[2u * bin + u32(label == {VOID}u)], 1u);
        }}
    }}
    workgroupBarrier();
    for (var k = thread; k < {all}u; k += 256u) {{
        let found = atomicLoad(&own[k]);
        if (found > 0u) {{ atomicAdd(&table[k], found); }}
    }}
}}"
    )
}
