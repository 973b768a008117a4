//! Passes over elements: one formula for all, with sums or without.
//!
//! A pass has operands, each an array of the card cut into the same pieces, and a body in WGSL for element `i`. A pass with sums adds to
//! `s0`, `s1`, …: 32 terms a thread one after the other, the threads of a group in pairs, and what comes back (64 kB at most) on the host, in f64 and
//! in one order. Rounding of so many short sums in f32 averages out: on 10⁸ terms of one sign the relative error is near 1e-9.

use crate::device::{Buffer, Gpu, THREADS};
use std::fmt::Write;

/// An array that a pass reads or writes.
pub(crate) struct Operand<'a> {
    /// What the body calls it.
    pub(crate) name: &'static str,
    /// Its elements in WGSL: `f32`, `u32`, …
    pub(crate) element: &'static str,
    pub(crate) is_written: bool,
    pub(crate) pieces: &'a [Buffer],
}

impl<'a> Operand<'a> {
    pub(crate) fn read(name: &'static str, pieces: &'a [Buffer]) -> Self {
        Operand {
            name,
            element: "f32",
            is_written: false,
            pieces,
        }
    }

    pub(crate) fn written(name: &'static str, pieces: &'a [Buffer]) -> Self {
        Operand {
            is_written: true,
            ..Self::read(name, pieces)
        }
    }

    pub(crate) fn words(self) -> Self {
        Operand {
            element: "u32",
            ..self
        }
    }
}

/// A formula over elements.
pub(crate) struct Pass<'a> {
    /// Of the kernel; a name stands for one source.
    pub(crate) name: &'a str,
    pub(crate) functions: &'a str,
    /// What is done with element `i`; `p.a`, `p.b`, `p.c` are the numbers.
    pub(crate) body: &'a str,
    pub(crate) numbers: [[f32; 4]; 3],
}

/// How numbers of a pass are combined.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Combine {
    /// Sums of f32.
    Sum,
    /// The largest of u32.
    Most,
}

impl Combine {
    fn number(self) -> &'static str {
        match self {
            Combine::Sum => "f32",
            Combine::Most => "u32",
        }
    }

    fn expression(self, a: &str, b: &str) -> String {
        match self {
            Combine::Sum => format!("{a} + {b}"),
            Combine::Most => format!("max({a}, {b})"),
        }
    }
}

/// Elements of a group in a pass with sums: 32 a thread.
const CHUNK: u32 = 32 * THREADS;
/// Numbers that come back at most: 64 kB.
const MOST_BACK: usize = 16 << 10;

/// Parameters of every pass, and the number of an element's group.
pub(crate) const HEAD: &str = "
struct Parameters { n: u32, chunk: u32, groups: u32, first: u32, a: vec4<f32>, b: vec4<f32>, c: vec4<f32> }
@group(0) @binding(0) var<uniform> p: Parameters;
";

/// The entry of a kernel: `group` is its number, `thread` that within the group.
pub(crate) const ENTRY: &str = "
@compute @workgroup_size(256)
fn main(@builtin(workgroup_id) group_at: vec3<u32>, @builtin(num_workgroups) group_count: vec3<u32>, @builtin(local_invocation_index) thread: u32) {
    let group = group_at.y * group_count.x + group_at.x;
";

/// Declares arrays, from a binding on.
pub(crate) fn declared<'a>(
    first: u32,
    operands: impl IntoIterator<Item = &'a Operand<'a>>,
) -> String {
    let mut text = String::new();
    for (binding, operand) in (first..).zip(operands) {
        let access = if operand.is_written {
            "read_write"
        } else {
            "read"
        };
        let Operand { name, element, .. } = operand;
        let _ = writeln!(
            text,
            "@group(0) @binding({binding}) var<storage, {access}> {name}: array<{element}>;"
        );
    }
    text
}

impl Pass<'_> {
    pub(crate) fn parameters(&self, n: usize, [chunk, groups, first]: [u32; 3]) -> Vec<u32> {
        let head = [n as u32, chunk, groups, first];
        let numbers = self.numbers.as_flattened().iter().map(|v| v.to_bits());
        head.into_iter().chain(numbers).collect()
    }

    /// Does it with all elements; `lengths` are those of the pieces.
    pub(crate) fn each(&self, gpu: &Gpu, operands: &[Operand<'_>], lengths: &[usize]) {
        let source = || {
            let (functions, body) = (self.functions, self.body);
            let declared = declared(1, operands);
            format!(
                "{HEAD}{declared}{functions}{ENTRY}
    let i = group * 256u + thread;
    if (i >= p.n) {{ return; }}
    {body}
}}"
            )
        };
        for (k, &n) in lengths.iter().enumerate() {
            let buffers: Vec<&Buffer> = operands.iter().map(|o| &o.pieces[k]).collect();
            let parameters = self.parameters(n, [0; 3]);
            gpu.run(self.name, &source, &parameters, &buffers, n);
        }
    }

    /// Does it with all elements and sums `s0`, `s1`, … up to `count` of them.
    pub(crate) fn sums(
        &self,
        gpu: &Gpu,
        operands: &[Operand<'_>],
        lengths: &[usize],
        count: usize,
    ) -> Vec<f64> {
        let pending = self.begin_sums(gpu, operands, lengths, count);
        finish_sums(gpu, &[pending]).swap_remove(0)
    }

    /// Begins the sums, without waiting for them.
    pub(crate) fn begin_sums(
        &self,
        gpu: &Gpu,
        operands: &[Operand<'_>],
        lengths: &[usize],
        count: usize,
    ) -> Pending {
        self.begin(gpu, operands, lengths, count, Combine::Sum)
    }

    /// Does it with all elements; the largest `s0`.
    pub(crate) fn most(&self, gpu: &Gpu, operands: &[Operand<'_>], lengths: &[usize]) -> u32 {
        self.mosts(gpu, operands, lengths, 1)[0]
    }

    /// Does it with all elements; the largest `s0`, `s1`, … up to `count` of them.
    pub(crate) fn mosts(
        &self,
        gpu: &Gpu,
        operands: &[Operand<'_>],
        lengths: &[usize],
        count: usize,
    ) -> Vec<u32> {
        let Pending { buffer, rows, .. } = self.begin(gpu, operands, lengths, count, Combine::Most);
        let found = words(&gpu.read(&[(&buffer, 4 * (rows * count) as u64)]));
        let most_of = |k: usize| found.iter().skip(k).step_by(count).copied().max();
        (0..count).map(|k| most_of(k).unwrap_or(0)).collect()
    }

    fn begin(
        &self,
        gpu: &Gpu,
        operands: &[Operand<'_>],
        lengths: &[usize],
        count: usize,
        how: Combine,
    ) -> Pending {
        let of_piece = |n: &usize| n.div_ceil(CHUNK as usize);
        let all: usize = lengths.iter().map(of_piece).sum();
        let partial = gpu.buffer((all * count * 4) as u64);
        let source = || self.source_of_sums(operands, count, how);
        let mut first = 0;
        for (k, n) in lengths.iter().enumerate() {
            let mut buffers: Vec<&Buffer> = operands.iter().map(|o| &o.pieces[k]).collect();
            buffers.push(&partial);
            let groups = of_piece(n);
            let parameters = self.parameters(*n, [CHUNK, groups as u32, first]);
            gpu.run_groups(self.name, &source, &parameters, &buffers, groups as u64);
            first += groups as u32;
        }
        folded(gpu, partial, all, count, how)
    }

    fn source_of_sums(&self, operands: &[Operand<'_>], count: usize, how: Combine) -> String {
        let walk = format!(
            "let begin = group * p.chunk;
    let end = min(begin + p.chunk, p.n);
    for (var i = begin + thread; i < end; i += 256u) {{
        {}
    }}
",
            self.body
        );
        let binding = operands.len() + 1;
        let declared = declared(1, operands);
        sums_of(&declared, binding, self.functions, &walk, count, how)
    }
}

/// The kernel of a pass with sums: `walk` goes through what a group has, the sums of the group come at a binding.
pub(crate) fn sums_of(
    declared: &str,
    binding: usize,
    functions: &str,
    walk: &str,
    count: usize,
    how: Combine,
) -> String {
    let number = how.number();
    let mut text = format!("{HEAD}{declared}");
    let _ = writeln!(
        text,
        "@group(0) @binding({binding}) var<storage, read_write> partial: array<{number}>;"
    );
    for k in 0..count {
        let _ = writeln!(text, "var<workgroup> shared{k}: array<{number}, 256>;");
    }
    text += functions;
    text += ENTRY;
    for k in 0..count {
        let _ = writeln!(text, "var s{k} = {number}(0);");
    }
    text += walk;
    for k in 0..count {
        let _ = writeln!(text, "shared{k}[thread] = s{k};");
    }
    text += "for (var half = 128u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if (thread < half) {\n";
    for k in 0..count {
        let shared = format!("shared{k}[thread]");
        let both = how.expression(&shared, &format!("shared{k}[thread + half]"));
        let _ = writeln!(text, "{shared} = {both};");
    }
    text += "}
    }
    if (thread == 0u && group < p.groups) {\n";
    for k in 0..count {
        let _ = writeln!(
            text,
            "partial[(p.first + group) * {count}u + {k}u] = shared{k}[0];"
        );
    }
    text + "}\n}\n"
}

/// Partial sums of so many groups, as few as may come back.
pub(crate) fn folded(
    gpu: &Gpu,
    partial: Buffer,
    all: usize,
    count: usize,
    how: Combine,
) -> Pending {
    let rows = MOST_BACK / count;
    if all <= rows {
        return Pending {
            buffer: partial,
            rows: all,
            count,
        };
    }
    let together = all.div_ceil(rows);
    let rows = all.div_ceil(together);
    let folded = gpu.buffer((rows * count * 4) as u64);
    let numbers = [all, together, count, rows].map(|v| v as u32);
    gpu.run(
        &format!("fold {}", how.number()),
        &|| fold(how),
        &numbers,
        &[&partial, &folded],
        rows * count,
    );
    Pending {
        buffer: folded,
        rows,
        count,
    }
}

/// Partial sums on the card.
pub(crate) struct Pending {
    buffer: Buffer,
    rows: usize,
    count: usize,
}

/// The sums of several passes, which come back together.
pub(crate) fn finish_sums(gpu: &Gpu, pending: &[Pending]) -> Vec<Vec<f64>> {
    let bytes = |pass: &Pending| 4 * pass.rows * pass.count;
    let parts: Vec<(&Buffer, u64)> = (pending.iter())
        .map(|pass| (&pass.buffer, bytes(pass) as u64))
        .collect();
    let found = gpu.read(&parts);
    let mut rest = &found[..];
    let of_pass = |pass: &Pending| {
        let (numbers, others) = rest.split_at(bytes(pass));
        rest = others;
        let mut sums = vec![0.0; pass.count];
        for numbers in words(numbers).chunks(pass.count) {
            for (sum, &bits) in sums.iter_mut().zip(numbers) {
                *sum += f64::from(f32::from_bits(bits));
            }
        }
        sums
    };
    pending.iter().map(of_pass).collect()
}

/// Rows of numbers → fewer rows.
fn fold(how: Combine) -> String {
    let number = how.number();
    let both = how.expression("s", "partial[row * p.count + k]");
    format!(
        "struct Parameters {{ all: u32, together: u32, count: u32, rows: u32 }}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read> partial: array<{number}>;
@group(0) @binding(2) var<storage, read_write> folded: array<{number}>;
{ENTRY}
    let i = group * 256u + thread;
    if (i >= p.rows * p.count) {{ return; }}
    let begin = i / p.count * p.together;
    let k = i % p.count;
    var s = {number}(0);
    for (var row = begin; row < min(begin + p.together, p.all); row++) {{ s = {both}; }}
    folded[i] = s;
}}"
    )
}

pub(crate) fn words(bytes: &[u8]) -> Vec<u32> {
    bytemuck::pod_collect_to_vec(bytes)
}
