//! Penalties on patterns that live on the card.
//!
//! Powers are summed there, in f32. Differences of neighbors ([`PatternCost::Differences`]) are computed on the host, with a copy of the patterns there and of
//! the gradient back: no method needs them by default.

use crate::field::GpuField;
use crate::passes::{Operand, Pass};
use std::sync::Arc;
use tomolith_core::field::bands::CHORD;
use tomolith_core::field::{CostKernel, Field as _, HostCosts, HostField, PatternCost};

/// [`CostKernel`] on a graphics card.
pub struct GpuCosts {
    cost: Arc<PatternCost>,
    host: HostCosts,
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

fn on_host(x: &GpuField) -> HostField {
    HostField::from_slice(&x.to_host())
}

impl CostKernel<GpuField> for GpuCosts {
    fn new(cost: &Arc<PatternCost>, _: &GpuField) -> Self {
        GpuCosts {
            cost: cost.clone(),
            host: HostCosts::new(cost, &HostField::zeros(0)),
        }
    }

    fn value(&self, x: &GpuField) -> f64 {
        let PatternCost::Power { exponent } = *self.cost else {
            return self.host.value(&on_host(x));
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
        let PatternCost::Power { exponent } = *self.cost else {
            let mut sum = on_host(gradient);
            let value = self.host.add_gradient(&on_host(x), scale, &mut sum);
            gradient.copy_from_host(sum.as_slice());
            return value;
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
        let PatternCost::Power { exponent } = *self.cost else {
            return self.host.slope_along(&on_host(x), &on_host(step), alpha);
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
