//! Penalties on patterns that live on the card: powers, and differences of neighbors, with sums in f32 there.

use crate::field::GpuField;
use crate::passes::{Operand, Pass, finish_sums};
use crate::stretches::Stretches;
use std::sync::Arc;
use tomolith_core::field::bands::CHORD;
use tomolith_core::field::costs::{FramePairs, PixelPairs};
use tomolith_core::field::{CostKernel, PatternCost};

/// [`CostKernel`] on a graphics card.
pub enum GpuCosts {
    /// Σ |x|^M
    Power(f64),
    /// Σ w·φ(xᵢ − xⱼ)
    Differences(Differences),
}

/// Pairs of pixels in lists of which none has a pixel twice on one side.
pub struct Differences {
    lists: Vec<Stretches>,
    edge: Option<f64>,
}

/// |x|^M and its derivative; `p.b.x` is M, `p.b.y` says whether M is 2, `p.b.z` is where the chord ends (0: no chord).
const POWER: &str = "
fn power(x: f32) -> vec2<f32> {
    let size = abs(x);
    if (p.b.y > 0.0) { return vec2(size * size, 2.0 * x); }
    let way = select(1.0, -1.0, x < 0.0);
    if (size < p.b.z) { let slope = p.b.w; return vec2(slope * size, way * slope); }
    if (p.b.x == 1.0) { return vec2(size, way); }
    let rise = select(pow(size, p.b.x - 1.0), 0.0, size == 0.0);
    return vec2(rise * size, way * p.b.x * rise);
}
";

fn numbers(exponent: f64, a: [f32; 4]) -> [[f32; 4]; 3] {
    let m = exponent as f32;
    let chord = if exponent < 1.0 { CHORD } else { 0.0 };
    let of_chord = chord.powf(m - 1.0);
    let slope = if chord > 0.0 { of_chord } else { 0.0 };
    [
        a,
        [m, f32::from(u8::from(exponent == 2.0)), chord, slope],
        [0.0; 4],
    ]
}

/// φ and its derivative; `p.b.x` is δ, `p.b.y` says whether there is one. Beyond a million of δ the root is the ratio itself, whose square may overflow.
const DIFFERENCE: &str = "
fn difference(apart: f32) -> vec2<f32> {
    if (p.b.y == 0.0) { return vec2(0.5 * apart * apart, apart); }
    let share = abs(apart) / p.b.x;
    let root = select(sqrt(share * share + 1.0), share, share > 1e6);
    return vec2(apart * apart / (1.0 + root), apart / root);
}
";

impl Differences {
    fn new(frames: &[FramePairs], edge: Option<f64>, like: &GpuField) -> Self {
        let is_above = |pairs: &&PixelPairs| pairs.second == pairs.first + 1;
        let inside = || frames.iter().flat_map(|frame| &frame.inside);
        let above: Vec<_> = inside().filter(is_above).collect();
        let beside: Vec<_> = inside().filter(|pairs| !is_above(pairs)).collect();
        let onward: Vec<_> = frames.iter().flat_map(|frame| &frame.onward).collect();
        let list = |pairs: Vec<&PixelPairs>| {
            Stretches::new(like.gpu(), [like, like], pairs.into_iter().copied())
        };
        Differences {
            lists: [above, beside, onward].map(list).into(),
            edge,
        }
    }

    fn numbers(&self, a: f32) -> [[f32; 4]; 3] {
        let edge = self.edge.map_or(0.0, |edge| edge as f32);
        let edge = edge.max(f32::MIN_POSITIVE);
        let has_edge = f32::from(u8::from(self.edge.is_some()));
        [[a, 0.0, 0.0, 0.0], [edge, has_edge, 0.0, 0.0], [0.0; 4]]
    }

    fn sums(&self, x: &GpuField, pass: &Pass<'_>, sides: &[(Operand<'_>, usize)]) -> [f64; 2] {
        let gpu = x.gpu();
        let pending = (self.lists.iter()).map(|list| list.begin_sums(gpu, pass, sides, 2));
        let found = finish_sums(gpu, &pending.collect::<Vec<_>>());
        found
            .iter()
            .fold([0.0; 2], |all, sums| [all[0] + sums[0], all[1] + sums[1]])
    }

    fn value(&self, x: &GpuField) -> f64 {
        let pass = Pass {
            name: "differences",
            functions: DIFFERENCE,
            body: "s0 += w * difference(x[i] - z[j]).x;",
            numbers: self.numbers(0.0),
        };
        let sides = [
            (Operand::read("x", x.pieces()), 0),
            (Operand::read("z", x.pieces()), 1),
        ];
        self.sums(x, &pass, &sides)[0]
    }

    fn add_gradient(&self, x: &GpuField, scale: f64, gradient: &mut GpuField) {
        // A pixel is first of one pair of a list at most, and second of one
        let bodies = [
            (
                "differences first",
                "g[i] += p.a.x * w * difference(x[i] - z[j]).y;",
            ),
            (
                "differences second",
                "g[j] -= p.a.x * w * difference(x[i] - z[j]).y;",
            ),
        ];
        for list in &self.lists {
            for (side, (name, body)) in bodies.into_iter().enumerate() {
                let pass = Pass {
                    name,
                    functions: DIFFERENCE,
                    body,
                    numbers: self.numbers(scale as f32),
                };
                let sides = [
                    (Operand::written("g", gradient.pieces()), side),
                    (Operand::read("x", x.pieces()), 0),
                    (Operand::read("z", x.pieces()), 1),
                ];
                list.each(x.gpu(), &pass, &sides);
            }
        }
    }

    fn slope_along(&self, x: &GpuField, step: &GpuField, alpha: f32) -> (f64, f64) {
        let pass = Pass {
            name: "differences along",
            functions: DIFFERENCE,
            body: "let steps = d[i] - e[j];
            let found = difference(x[i] - z[j] + p.a.x * steps);
            s0 += w * found.x; s1 += w * found.y * steps;",
            numbers: self.numbers(alpha),
        };
        let sides = [
            (Operand::read("x", x.pieces()), 0),
            (Operand::read("d", step.pieces()), 0),
            (Operand::read("z", x.pieces()), 1),
            (Operand::read("e", step.pieces()), 1),
        ];
        self.sums(x, &pass, &sides).into()
    }
}

impl CostKernel<GpuField> for GpuCosts {
    fn new(cost: &Arc<PatternCost>, like: &GpuField) -> Self {
        match &**cost {
            PatternCost::Power { exponent } => GpuCosts::Power(*exponent),
            PatternCost::Differences { frames, edge } => {
                GpuCosts::Differences(Differences::new(frames, *edge, like))
            }
        }
    }

    fn value(&self, x: &GpuField) -> f64 {
        let exponent = match self {
            GpuCosts::Power(exponent) => *exponent,
            GpuCosts::Differences(differences) => return differences.value(x),
        };
        let pass = Pass {
            name: "power",
            functions: POWER,
            body: "s0 += power(x[i]).x;",
            numbers: numbers(exponent, [0.0; 4]),
        };
        pass.sums(x.gpu(), &[Operand::read("x", x.pieces())], x.lengths(), 1)[0]
    }

    fn add_gradient(&self, x: &GpuField, scale: f64, gradient: &mut GpuField) -> f64 {
        let exponent = match self {
            GpuCosts::Power(exponent) => *exponent,
            GpuCosts::Differences(differences) => {
                differences.add_gradient(x, scale, gradient);
                return differences.value(x);
            }
        };
        let pass = Pass {
            name: "power gradient",
            functions: POWER,
            body: "let found = power(x[i]); gradient[i] += p.a.x * found.y; s0 += found.x;",
            numbers: numbers(exponent, [scale as f32, 0.0, 0.0, 0.0]),
        };
        let operands = [
            Operand::written("gradient", gradient.pieces()),
            Operand::read("x", x.pieces()),
        ];
        pass.sums(x.gpu(), &operands, x.lengths(), 1)[0]
    }

    fn slope_along(&self, x: &GpuField, step: &GpuField, alpha: f32) -> (f64, f64) {
        let exponent = match self {
            GpuCosts::Power(exponent) => *exponent,
            GpuCosts::Differences(differences) => return differences.slope_along(x, step, alpha),
        };
        let pass = Pass {
            name: "power along",
            functions: POWER,
            body: "let found = power(x[i] + p.a.x * step[i]); s0 += found.x; s1 += found.y * step[i];",
            numbers: numbers(exponent, [alpha, 0.0, 0.0, 0.0]),
        };
        let operands = [
            Operand::read("x", x.pieces()),
            Operand::read("step", step.pieces()),
        ];
        let sums = pass.sums(x.gpu(), &operands, x.lengths(), 2);
        (sums[0], sums[1])
    }
}
