//! Passes over pairs of elements that go side by side: `first + k` of one field and `second + k` of another or of the same.
//!
//! A list of stretches is cut at the pieces of both fields. The pairs of two pieces are counted through; a group has 32 a thread of them, and its threads walk
//! along the stretches from the one that the group begins in. A body finds element `i` of the one field and `j` of the other, and the weight `w` of the stretch;
//! it may write element `i` or element `j` where no other pair of the same list has it.

use crate::device::{Buffer, Gpu, THREADS};
use crate::field::GpuField;
use crate::passes::{Combine, ENTRY, HEAD, Operand, Pass, Pending, declared, folded, sums_of};
use std::collections::BTreeMap;
use std::ops::Range;
use tomolith_core::field::costs::PixelPairs;

/// Pairs of a group.
const OF_GROUP: usize = 32 * THREADS as usize;

/// Stretches of two fields on a card.
pub(crate) struct Stretches {
    parts: Vec<Part>,
}

/// Those of two pieces.
struct Part {
    pieces: [usize; 2],
    /// First elements, how many pairs there are before, and the weight; one more after the last.
    stretches: Buffer,
    /// The stretch that each group begins in.
    begins: Buffer,
    pairs: usize,
}

/// What a body calls an array, the pieces of it, and whether its elements are those of `i` or of `j`.
pub(crate) type Side<'a> = (Operand<'a>, usize);

impl Stretches {
    pub(crate) fn new(
        gpu: &Gpu,
        [first, second]: [&GpuField; 2],
        pairs: impl IntoIterator<Item = PixelPairs>,
    ) -> Self {
        let ranges = [first, second].map(|field| field.ranges().collect::<Vec<_>>());
        let mut found: BTreeMap<[usize; 2], Vec<PixelPairs>> = BTreeMap::new();
        for mut rest in pairs {
            while rest.count > 0 {
                let at = [rest.first, rest.second];
                let pieces = [0, 1].map(|side| piece_of(&ranges[side], at[side]));
                let [a, b] = [0, 1].map(|side| &ranges[side][pieces[side]]);
                let left = (a.end - rest.first).min(b.end - rest.second);
                let count = rest.count.min(left);
                found.entry(pieces).or_default().push(PixelPairs {
                    first: rest.first - a.start,
                    second: rest.second - b.start,
                    count,
                    weight: rest.weight,
                });
                rest.first += count;
                rest.second += count;
                rest.count -= count;
            }
        }
        let parts = found.into_iter();
        Stretches {
            parts: parts
                .map(|(pieces, of_pieces)| Part::new(gpu, pieces, &of_pieces))
                .collect(),
        }
    }

    /// Does what the body of a pass says with all pairs.
    pub(crate) fn each(&self, gpu: &Gpu, pass: &Pass<'_>, sides: &[Side<'_>]) {
        let source = || {
            let (declared, functions) = (of_sides(sides), pass.functions);
            let walk = walk(pass.body);
            format!("{HEAD}{declared}{functions}{ENTRY}{walk}}}")
        };
        for part in &self.parts {
            let buffers = part.buffers(sides);
            let parameters = pass.parameters(part.pairs, [OF_GROUP as u32, 0, 0]);
            gpu.run_groups(pass.name, &source, &parameters, &buffers, part.groups());
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
        let all = self.parts.iter().map(Part::groups).sum::<u64>() as usize;
        let partial = gpu.buffer((all * sums * 4) as u64);
        let source = || {
            let (declared, walk) = (of_sides(sides), walk(pass.body));
            let binding = sides.len() + 3;
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
        for part in &self.parts {
            let mut buffers = part.buffers(sides);
            buffers.push(&partial);
            let groups = part.groups();
            let numbers = [OF_GROUP as u32, groups as u32, first];
            let parameters = pass.parameters(part.pairs, numbers);
            gpu.run_groups(pass.name, &source, &parameters, &buffers, groups);
            first += groups as u32;
        }
        folded(gpu, partial, all, sums, Combine::Sum)
    }
}

impl Part {
    fn new(gpu: &Gpu, pieces: [usize; 2], of_pieces: &[PixelPairs]) -> Self {
        let (mut words, mut begins, mut pairs) = (Vec::new(), Vec::new(), 0);
        for (k, part) in of_pieces.iter().enumerate() {
            let [first, second, before] = [part.first, part.second, pairs].map(|n| n as u32);
            words.push([first, second, before, (part.weight as f32).to_bits()]);
            pairs += part.count;
            while begins.len() * OF_GROUP < pairs {
                begins.push(k as u32);
            }
        }
        words.push([0, 0, pairs as u32, 0]);
        Part {
            pieces,
            stretches: gpu.upload(&words),
            begins: gpu.upload(&begins),
            pairs,
        }
    }

    fn groups(&self) -> u64 {
        self.pairs.div_ceil(OF_GROUP) as u64
    }

    fn buffers<'a>(&'a self, sides: &[Side<'a>]) -> Vec<&'a Buffer> {
        let of_side = |(operand, side): &Side<'a>| &operand.pieces[self.pieces[*side]];
        let own = [&self.stretches, &self.begins].into_iter();
        own.chain(sides.iter().map(of_side)).collect()
    }
}

/// The piece that has an element.
fn piece_of(ranges: &[Range<usize>], element: usize) -> usize {
    ranges.partition_point(|range| range.end <= element)
}

fn of_sides(sides: &[Side<'_>]) -> String {
    let own = "@group(0) @binding(1) var<storage, read> stretches: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read> begins: array<u32>;
";
    own.to_owned() + &declared(3, sides.iter().map(|(operand, _)| operand))
}

/// All pairs of a group.
fn walk(body: &str) -> String {
    format!(
        "let begin = group * p.chunk;
    let end = min(begin + p.chunk, p.n);
    var at = 0u;
    if (begin < p.n) {{ at = begins[group]; }}
    for (var pair = begin + thread; pair < end; pair += 256u) {{
        while (stretches[at + 1u].z <= pair) {{ at += 1u; }}
        let stretch = stretches[at];
        let i = stretch.x + pair - stretch.z;
        let j = stretch.y + pair - stretch.z;
        let w = bitcast<f32>(stretch.w);
        {body}
    }}
"
    )
}
