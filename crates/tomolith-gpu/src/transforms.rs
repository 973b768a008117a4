//! Fourier transforms of many lines at once, of any length.
//!
//! ```text
//! out_k = Σ_i in_i·e^(±2πi·ik/n),        n = r₁·r₂ …
//! ```
//!
//! **Method** Stockham: every stage of radix r takes n/r sums of r numbers, each r-th of the line apart, to places that are in order after the last stage.
//! Lines of up to [`IN_GROUP`] numbers are transformed in the memory of a group, several in one group where they are short. Longer ones are split, n = n₁·n₂: transforms of
//! length n₁ of numbers that lie n₂ apart, turned by e^(±2πi·ck/n), then those of length n₂ (Cooley and Tukey, 1965). A kernel says in WGSL how
//! numbers are read and written, so that padding, selection and multiplication cost no pass of their own.
//!
//! **Source** Stockham's form: Van Loan, *Computational Frameworks for the Fast Fourier Transform*, 1.7. Radices 4, 2, 3, 5, 7; other primes by their sums.
//!
//! **Accuracy** relative to the largest element 3·10⁻⁷ up to a length of 5000: roots of unity come from a table that the host makes in f64.

use crate::device::{Buffer, Gpu};
use crate::passes::ENTRY;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Numbers in the memory of a group: the 16 KiB that WebGPU guarantees.
const IN_GROUP: usize = 2048;
/// Numbers that a dispatch transforms at most: below 100 ms on a small card.
const MOST_NUMBERS: usize = 1 << 26;
/// A dispatch of more numbers than these is submitted by itself.
const MOST_TOGETHER: usize = 1 << 23;
/// Threads of a group.
const THREADS: usize = crate::device::THREADS as usize;

/// Transforms of one length and direction.
pub(crate) struct Transform {
    gpu: Gpu,
    length: usize,
    /// +1 or −1: of the exponent.
    sign: i32,
    /// Its two factors where it does not fit the memory of a group.
    split: Option<[usize; 2]>,
    /// e^(2πi·k/n)
    turns: Buffer,
}

pub(crate) struct Lines {
    pub(crate) name: &'static str,
    /// Declarations of `struct Parameters`, which begins with `lines: u32, first: u32`, of `p`, and of the buffers from binding 2 on; then
    /// `fn load(line: u32, i: u32) -> vec2<f32>` and `fn store(line: u32, i: u32, value: vec2<f32>)`.
    pub(crate) functions: fn() -> String,
    /// Whether neighboring lines, not neighboring numbers of a line, lie next to each other.
    pub(crate) are_neighbors: bool,
}

/// A part of a split transform: where its numbers come from and go to.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Whole,
    First,
    Second,
}

impl Transform {
    pub(crate) fn new(gpu: &Gpu, length: usize, sign: i32) -> Self {
        let turn = |k: usize| {
            let (sin, cos) = (TAU * k as f64 / length as f64).sin_cos();
            [cos as f32, sin as f32]
        };
        let turns: Vec<[f32; 2]> = (0..length).map(turn).collect();
        Transform {
            gpu: gpu.clone(),
            length,
            sign,
            split: (length > IN_GROUP).then(|| factors(length)),
            turns: gpu.upload(&turns),
        }
    }

    pub(crate) fn length(&self) -> usize {
        self.length
    }

    /// Whether a line of this length can be transformed.
    pub(crate) fn holds(length: usize) -> bool {
        length > 1 && (length <= IN_GROUP || factors(length).iter().all(|n| *n <= IN_GROUP))
    }

    /// Transforms `count` lines. `parameters` are those of the kernel behind `lines` and `first`.
    pub(crate) fn run(
        &self,
        kernel: &Lines,
        count: usize,
        parameters: &[u32],
        buffers: &[&Buffer],
    ) {
        let bound = self.gpu.binding_bytes() as usize / 8;
        let most = self.split.map_or(MOST_NUMBERS, |_| MOST_NUMBERS.min(bound));
        let together = (most / self.length).max(1);
        for first in (0..count).step_by(together) {
            let lines = together.min(count - first);
            let place = [lines as u32, first as u32];
            let parameters: Vec<u32> = place.iter().chain(parameters).copied().collect();
            let mut all = vec![&self.turns];
            all.extend(buffers);
            if let Some([n1, n2]) = self.split {
                let between = self.gpu.buffer((8 * lines * self.length) as u64);
                all.push(&between);
                self.part(kernel, Part::First, n1, lines * n2, &parameters, &all);
                self.part(kernel, Part::Second, n2, lines * n1, &parameters, &all);
            } else {
                self.part(kernel, Part::Whole, self.length, lines, &parameters, &all);
            }
            if lines * self.length > MOST_TOGETHER {
                self.gpu.submit();
            }
        }
    }

    /// Transforms of `length` numbers, `lines` of them.
    fn part(
        &self,
        kernel: &Lines,
        part: Part,
        length: usize,
        lines: usize,
        parameters: &[u32],
        buffers: &[&Buffer],
    ) {
        let which = match part {
            Part::Whole => "",
            Part::First => " first",
            Part::Second => " second",
        };
        let name = format!("{} {}{which}", kernel.name, self.length);
        let source = || self.source(kernel, part, length, buffers.len());
        let groups = lines.div_ceil(IN_GROUP / length);
        self.gpu
            .run_groups(&name, &source, parameters, buffers, groups as u64);
    }

    /// How many lines a part has, what number `i` of one is, and what becomes of number `i` of its transform.
    fn access(&self, part: Part) -> [String; 3] {
        let [n1, n2] = self.split.unwrap_or([1, 1]);
        let n = self.length;
        match part {
            Part::Whole => [
                "p.lines".to_owned(),
                "load(p.first + line, i)".to_owned(),
                "store(p.first + line, i, value);".to_owned(),
            ],
            Part::First => [
                format!("p.lines * {n2}u"),
                format!("load(p.first + line / {n2}u, i * {n2}u + line % {n2}u)"),
                format!(
                    "let c = line % {n2}u; between[line / {n2}u * {n}u + i * {n2}u + c] = product(value, turn(c * i));"
                ),
            ],
            Part::Second => [
                format!("p.lines * {n1}u"),
                format!("between[line * {n2}u + i]"),
                format!("store(p.first + line / {n1}u, line % {n1}u + {n1}u * i, value);"),
            ],
        }
    }

    /// What a part declares in addition, and what it never does: no part has so many lines, but so both have the bindings of the whole kernel.
    fn bindings(part: Part, buffers: usize) -> [String; 2] {
        let unused = match part {
            Part::Whole => return [const { String::new() }; 2],
            Part::First => "store(0u, 0u, vec2(0.0));",
            Part::Second => "numbers[0] = load(0u, 0u);",
        };
        [
            format!(
                "@group(0) @binding({buffers}) var<storage, read_write> between: array<vec2<f32>>;"
            ),
            format!("if (p.lines == 0xffffffffu) {{ {unused} }}"),
        ]
    }

    fn source(&self, kernel: &Lines, part: Part, length: usize, buffers: usize) -> String {
        let lines = IN_GROUP / length;
        let all = lines * length;
        let [count, load, store] = self.access(part);
        let [between, unused] = Self::bindings(part, buffers);
        let place = if kernel.are_neighbors || part == Part::First {
            format!("let in_group = e % {lines}u; let i = e / {lines}u;")
        } else {
            format!("let in_group = e / {length}u; let i = e % {length}u;")
        };
        let functions = (kernel.functions)();
        let sign = if self.sign > 0 { "" } else { "-" };
        let mut text = format!(
            "{functions}
{between}
@group(0) @binding(1) var<storage, read> turns: array<vec2<f32>>;
var<workgroup> numbers: array<vec2<f32>, {all}>;
fn product(a: vec2<f32>, b: vec2<f32>) -> vec2<f32> {{ return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }}
fn turn(k: u32) -> vec2<f32> {{ let t = turns[k]; return vec2(t.x, {sign}t.y); }}
{ENTRY}
    {unused}
    for (var e = thread; e < {all}u; e += 256u) {{
        {place}
        let line = group * {lines}u + in_group;
        var value = vec2(0.0);
        if (line < {count}) {{ value = {load}; }}
        numbers[in_group * {length}u + i] = value;
    }}
    workgroupBarrier();
"
        );
        let mut done = 1;
        for radix in radices(length) {
            self.stage(&mut text, length, lines, radix, done);
            done *= radix;
        }
        let _ = write!(
            text,
            "    for (var e = thread; e < {all}u; e += 256u) {{
        {place}
        let line = group * {lines}u + in_group;
        if (line < {count}) {{ let value = numbers[in_group * {length}u + i]; {store} }}
    }}
}}"
        );
        text
    }

    /// A stage of one radix, after stages whose radices have the product `done`.
    fn stage(&self, text: &mut String, length: usize, lines: usize, radix: usize, done: usize) {
        let of_line = length / radix;
        let sums = lines * of_line;
        let rounds = sums.div_ceil(THREADS);
        for b in 0..rounds {
            for q in 0..radix {
                let _ = writeln!(text, "    var v{b}_{done}_{q} = vec2(0.0);");
            }
        }
        let guard = |b: usize| {
            let is_full = (b + 1) * THREADS <= sums;
            let begin = b * THREADS;
            let head = if is_full {
                "{".to_owned()
            } else {
                format!("if (thread + {begin}u < {sums}u) {{")
            };
            format!(
                "    {head} let t = thread + {begin}u; let base = t / {of_line}u * {length}u; let j = t % {of_line}u;"
            )
        };
        // Numbers of turns of the whole table
        let scale = self.length / (done * radix);
        for b in 0..rounds {
            let _ = writeln!(text, "{}", guard(b));
            for q in 0..radix {
                let number = format!("numbers[base + j + {}u]", q * of_line);
                // The first stage turns nothing; alone it must name the table, which would else have no binding
                let is_turned = q > 0 && (done > 1 || radix == length);
                let value = if is_turned {
                    format!("product({number}, turn(j % {done}u * {}u))", q * scale)
                } else {
                    number
                };
                let _ = writeln!(text, "    v{b}_{done}_{q} = {value};");
            }
            let _ = writeln!(text, "    }}");
        }
        text.push_str("    workgroupBarrier();\n");
        for b in 0..rounds {
            let _ = writeln!(text, "{}", guard(b));
            let _ = writeln!(
                text,
                "    let to = base + j / {done}u * {}u + j % {done}u;",
                done * radix
            );
            let values: Vec<String> = (0..radix).map(|q| format!("v{b}_{done}_{q}")).collect();
            for (q, sum) in self.sums(text, &values).into_iter().enumerate() {
                let _ = writeln!(text, "    numbers[to + {}u] = {sum};", q * done);
            }
            let _ = writeln!(text, "    }}");
        }
        text.push_str("    workgroupBarrier();\n");
    }

    /// The transform of so few numbers, written out: Σ_q v_q·e^(±2πi·qk/r) for every k.
    fn sums(&self, text: &mut String, v: &[String]) -> Vec<String> {
        let radix = v.len();
        if radix == 2 {
            return vec![
                format!("{} + {}", v[0], v[1]),
                format!("{} - {}", v[0], v[1]),
            ];
        }
        let sign = if self.sign > 0 { 1.0 } else { -1.0 };
        if radix == 4 {
            let [a, b, c, d] = [&v[0], &v[1], &v[2], &v[3]];
            let _ = writeln!(
                text,
                "    let even = {a} + {c}; let odd = {a} - {c}; let more = {b} + {d};
    let less = {sign:?} * vec2({d}.y - {b}.y, {b}.x - {d}.x);"
            );
            return ["even + more", "odd + less", "even - more", "odd - less"]
                .map(str::to_owned)
                .to_vec();
        }
        // Of v_q and v_(r−q) the cosines go with the sum, the sines with the difference
        let half = radix / 2;
        for q in 1..=half {
            let (a, b) = (&v[q], &v[radix - q]);
            let _ = writeln!(
                text,
                "    let s{q} = {a} + {b}; let d{q} = vec2({b}.y - {a}.y, {a}.x - {b}.x);"
            );
        }
        for k in 1..=half {
            let (mut even, mut odd) = (v[0].clone(), "vec2(0.0)".to_owned());
            for q in 1..=half {
                let (sin, cos) = (TAU * (q * k % radix) as f64 / radix as f64).sin_cos();
                let _ = write!(even, " + {:?} * s{q}", cos as f32);
                let _ = write!(odd, " + {:?} * d{q}", (sign * sin) as f32);
            }
            let _ = writeln!(text, "    let even{k} = {even}; let odd{k} = {odd};");
        }
        let all: Vec<String> = (1..=half).map(|q| format!("s{q}")).collect();
        let mut sums = vec![format!("{} + {}", v[0], all.join(" + "))];
        sums.extend((1..radix).map(|k| {
            if k <= half {
                format!("even{k} + odd{k}")
            } else {
                format!("even{0} - odd{0}", radix - k)
            }
        }));
        sums
    }
}

/// The radices of a length, those of the first stages first.
fn radices(length: usize) -> Vec<usize> {
    let (mut rest, mut found) = (length, Vec::new());
    let mut radix = 4;
    while rest > 1 {
        if rest.is_multiple_of(radix) {
            found.push(radix);
            rest /= radix;
        } else {
            radix = match radix {
                4 => 2,
                2 => 3,
                odd => odd + 2,
            };
        }
    }
    found
}

/// Two factors of a length, as near to each other as can be.
fn factors(length: usize) -> [usize; 2] {
    let root = length.isqrt();
    let small = (1..=root)
        .rev()
        .find(|n| length.is_multiple_of(*n))
        .unwrap_or(1);
    [length / small, small]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device::Asked;
    use tomolith_core::check::noise;

    fn plain() -> String {
        "struct Parameters { lines: u32, first: u32, n: u32 }
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(2) var<storage, read_write> out: array<vec2<f32>>;
@group(0) @binding(3) var<storage, read> source: array<vec2<f32>>;
fn load(line: u32, i: u32) -> vec2<f32> { return source[line * p.n + i]; }
fn store(line: u32, i: u32, value: vec2<f32>) { out[line * p.n + i] = value; }"
            .to_owned()
    }

    /// Transforms of a few lines, and the sums of their definition in f64.
    fn both(gpu: &Gpu, kernel: &Lines, length: usize, sign: i32) -> [Vec<f64>; 2] {
        let lines = 3 + IN_GROUP / length.min(IN_GROUP);
        let numbers = noise(length as u64, 2 * lines * length);
        let [out, source] = [(); 2].map(|()| gpu.upload(&numbers));
        let transform = Transform::new(gpu, length, sign);
        transform.run(kernel, lines, &[length as u32], &[&out, &source]);
        let found = gpu.read(&[(&out, 4 * numbers.len() as u64)]);
        let found: Vec<f32> = bytemuck::pod_collect_to_vec(&found);
        // The first line and the last
        let (mut seen, mut expected) = (Vec::new(), Vec::new());
        for line in [0, lines - 1] {
            let range = 2 * line * length..2 * (line + 1) * length;
            seen.extend(found[range.clone()].iter().map(|v| f64::from(*v)));
            for k in 0..length {
                let (mut re, mut im) = (0.0, 0.0);
                for (i, value) in numbers[range.clone()].chunks_exact(2).enumerate() {
                    let turn = TAU * (i * k % length) as f64 / length as f64;
                    let (sin, cos) = (f64::from(sign) * turn).sin_cos();
                    let [a, b] = [value[0], value[1]].map(f64::from);
                    re += a * cos - b * sin;
                    im += a * sin + b * cos;
                }
                expected.extend([re, im]);
            }
        }
        [seen, expected]
    }

    #[test]
    fn lines_of_all_lengths_have_the_sums_of_their_definition() {
        let named = |_| Gpu::open(&Asked::Named("llvmpipe"));
        let Ok(gpu) = Gpu::open(&Asked::Any).or_else(named) else {
            return;
        };
        let kernel = |are_neighbors| Lines {
            name: if are_neighbors { "neighbors" } else { "plain" },
            functions: plain,
            are_neighbors,
        };
        let short = [2, 3, 4, 5, 7, 26, 60, 343, 550, 2048];
        let long = [2058, 5000];
        for (i, length) in short.into_iter().chain(long).enumerate() {
            let sign = if i % 2 == 0 { 1 } else { -1 };
            let kernel = kernel(i % 3 == 0);
            let name = Lines {
                name: if sign > 0 { kernel.name } else { "inverse" },
                ..kernel
            };
            let [found, expected] = both(&gpu, &name, length, sign);
            gpu.check().unwrap();
            let most = expected.iter().fold(0.0f64, |m, v| m.max(v.abs()));
            let pairs = found.iter().zip(&expected);
            let error = pairs.fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(error < 1e-6 * most, "{length}: {error} of {most}");
        }
        assert!(Transform::holds(5000) && !Transform::holds(1) && !Transform::holds(2053));
    }
}
