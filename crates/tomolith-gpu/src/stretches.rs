//! Passes over pairs of elements that go side by side: `first + k` of one field and `second + k` of another or of the same.
//!
//! A pair of stretches is cut at the pieces of both fields, and into chunks of at most 32 elements a thread: one group each. A body finds element `i` of
//! the one field and `j` of the other, and the weight `w` of the stretch; it may write element `i` or element `j` where no other pair of the same list has it.

use crate::device::{Buffer, Gpu, THREADS};
use crate::field::GpuField;
use crate::passes::{Combine, ENTRY, HEAD, Operand, Pass, Pending, declared, folded, sums_of};
use std::collections::BTreeMap;
use std::ops::Range;

/// Elements of a chunk.
const LONGEST: usize = 32 * THREADS as usize;

/// First elements, how many, and the weight.
pub(crate) struct Pairs {
    pub(crate) first: usize,
    pub(crate) second: usize,
    pub(crate) count: usize,
    pub(crate) weight: f32,
}

/// Stretches of two fields on a card.
pub(crate) struct Chunks {
    /// The piece of each field, the chunks, and how many.
    parts: Vec<([usize; 2], Buffer, usize)>,
}

/// What a body calls an array, the pieces of it, and whether its elements are those of `i` or of `j`.
pub(crate) type Side<'a> = (Operand<'a>, usize);

impl Chunks {
    pub(crate) fn new(
        gpu: &Gpu,
        [first, second]: [&GpuField; 2],
        pairs: impl IntoIterator<Item = Pairs>,
    ) -> Self {
        let ranges = [first, second].map(|field| field.ranges().collect::<Vec<_>>());
        let mut found: BTreeMap<[usize; 2], Vec<[u32; 4]>> = BTreeMap::new();
        for mut rest in pairs {
            while rest.count > 0 {
                let at = [rest.first, rest.second];
                let pieces = [0, 1].map(|side| piece_of(&ranges[side], at[side]));
                let [a, b] = [0, 1].map(|side| &ranges[side][pieces[side]]);
                let left = (a.end - rest.first).min(b.end - rest.second);
                let count = rest.count.min(left).min(LONGEST);
                found.entry(pieces).or_default().push([
                    (rest.first - a.start) as u32,
                    (rest.second - b.start) as u32,
                    count as u32,
                    rest.weight.to_bits(),
                ]);
                rest.first += count;
                rest.second += count;
                rest.count -= count;
            }
        }
        let part = |(pieces, chunks): ([usize; 2], Vec<[u32; 4]>)| {
            (pieces, gpu.upload(&chunks), chunks.len())
        };
        Chunks {
            parts: found.into_iter().map(part).collect(),
        }
    }

    /// Does what the body of a pass says with all pairs.
    pub(crate) fn each(&self, gpu: &Gpu, pass: &Pass<'_>, sides: &[Side<'_>]) {
        let source = || {
            let (declared, functions) = (of_sides(sides), pass.functions);
            let walk = walk(pass.body);
            format!("{HEAD}{declared}{functions}{ENTRY}{walk}}}")
        };
        for (pieces, chunks, count) in &self.parts {
            let buffers = buffers(chunks, *pieces, sides);
            let parameters = pass.parameters(*count, [0; 3]);
            gpu.run_groups(pass.name, &source, &parameters, &buffers, *count as u64);
        }
    }

    /// The same with sums `s0`, `s1`, … up to `sums` of them.
    pub(crate) fn begin_sums(
        &self,
        gpu: &Gpu,
        pass: &Pass<'_>,
        sides: &[Side<'_>],
        sums: usize,
    ) -> Pending {
        let all: usize = self.parts.iter().map(|(_, _, count)| count).sum();
        let partial = gpu.buffer((all * sums * 4) as u64);
        let source = || {
            let (declared, walk) = (of_sides(sides), walk(pass.body));
            let binding = sides.len() + 2;
            sums_of(
                &declared,
                binding,
                pass.functions,
                &walk,
                sums,
                Combine::Sum,
            )
        };
        let mut first = 0;
        for (pieces, chunks, count) in &self.parts {
            let mut buffers = buffers(chunks, *pieces, sides);
            buffers.push(&partial);
            let parameters = pass.parameters(*count, [0, *count as u32, first]);
            gpu.run_groups(pass.name, &source, &parameters, &buffers, *count as u64);
            first += *count as u32;
        }
        folded(gpu, partial, all, sums, Combine::Sum)
    }
}

/// The piece that has an element.
fn piece_of(ranges: &[Range<usize>], element: usize) -> usize {
    ranges.partition_point(|range| range.end <= element)
}

fn of_sides(sides: &[Side<'_>]) -> String {
    let chunks = "@group(0) @binding(1) var<storage, read> chunks: array<vec4<u32>>;\n";
    chunks.to_owned() + &declared(2, sides.iter().map(|(operand, _)| operand))
}

fn buffers<'a>(chunks: &'a Buffer, pieces: [usize; 2], sides: &[Side<'a>]) -> Vec<&'a Buffer> {
    let of_side = |(operand, side): &Side<'a>| &operand.pieces[pieces[*side]];
    std::iter::once(chunks)
        .chain(sides.iter().map(of_side))
        .collect()
}

/// All pairs of a group's chunk.
fn walk(body: &str) -> String {
    format!(
        "var chunk = vec4<u32>(0u);
    if (group < p.n) {{ chunk = chunks[group]; }}
    let w = bitcast<f32>(chunk.w);
    for (var k = thread; k < chunk.z; k += 256u) {{
        let i = chunk.x + k;
        let j = chunk.y + k;
        {body}
    }}
"
    )
}
