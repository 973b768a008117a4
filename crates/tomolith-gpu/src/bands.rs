//! The band loss of doses on the card.
//!
//! The formulas are those of [`tomolith_core::field::bands`], one element a thread: response, distances from one band or two, penalties, their
//! derivatives. A whole power is a product, any other `pow`. A response that is code of the host alone is taken as a table.

use crate::device::Buffer;
use crate::field::GpuField;
use crate::passes::{Operand, Pass};
use std::sync::Arc;
use tomolith_core::field::bands::CHORD;
use tomolith_core::field::{Band, BandKernel, BandLoss, Bands, Field as _};
use tomolith_core::response::ResponseForm;

/// [`BandKernel`] on a graphics card.
pub struct GpuBands {
    loss: Arc<BandLoss>,
    name: String,
    functions: String,
    /// How a body finds `t`, value and slope by the response, of a response `m`.
    find: String,
    data: Data,
    numbers: [[f32; 4]; 2],
}

/// Bands of the elements of the whole field; those that the loss is not for do not count.
enum Data {
    Labels {
        /// Four to a word.
        labels: Vec<Buffer>,
        table: Vec<Buffer>,
    },
    Shared {
        inside: GpuField,
        scale: Option<GpuField>,
        widen: Option<GpuField>,
    },
    Voxels {
        lower: GpuField,
        upper: GpuField,
        weight: GpuField,
    },
}

/// w·e^P of a response and its derivative by it. A NaN stays one.
const PENALTY: &str = "
fn is_nan(v: f32) -> bool { return (bitcast<u32>(v) & 0x7fffffffu) > 0x7f800000u; }
fn penalty(m: f32, low: f32, high: f32, w: f32) -> vec2<f32> {
    if (is_nan(m)) { return vec2(m, m); }
    let distance = max(m - high, 0.0) - max(low - m, 0.0);
    if (distance == 0.0 || w == 0.0) { return vec2(0.0); }
    let e = abs(distance);
    let way = select(1.0, -1.0, distance < 0.0);
    POWER
}
";

fn penalty(p: f64) -> (String, String) {
    let body = if p == 1.0 {
        "return vec2(w * e, w * way);".to_owned()
    } else if p.fract() == 0.0 && (2.0..=8.0).contains(&p) {
        let rise = vec!["e"; p as usize - 1].join(" * ");
        format!("let rise = {rise}; return vec2(w * rise * e, w * way * {p:?} * rise);")
    } else {
        let chord = if p < 1.0 { CHORD } else { 0.0 };
        format!(
            "let rise = pow(max(e, {chord:?}), {:?});
    let slope = select({p:?} * rise, rise, e < {chord:?});
    return vec2(w * rise * e, w * way * slope);",
            p - 1.0
        )
    };
    (format!("power {p}"), PENALTY.replace("POWER", &body))
}

/// M(d) and dM/dd as WGSL, and what its numbers are.
fn curve(loss: &BandLoss) -> (String, String, [[f32; 4]; 2]) {
    let none = [[0.0; 4]; 2];
    match loss.response().form() {
        ResponseForm::Identity => (
            "identity".to_owned(),
            "fn responded(d: f32) -> vec2<f32> { return vec2(d, 1.0); }".to_owned(),
            none,
        ),
        ResponseForm::Logistic(params) => {
            let [lower, range, steepness, midpoint, exponent] = [
                params.lower,
                params.upper - params.lower,
                params.steepness,
                params.midpoint,
                1.0 / params.asymmetry,
            ]
            .map(|v| v as f32);
            (
                "logistic".to_owned(),
                "fn responded(d: f32) -> vec2<f32> {
    let falling = exp(min(-p.b.z * (d - p.b.w), 87.0));
    let u = 1.0 / (1.0 + falling);
    let height = pow(u, p.c.x);
    return vec2(p.b.x + p.b.y * height, p.b.y * p.b.z * p.c.x * height * (falling * u));
}"
                .to_owned(),
                [
                    [lower, range, steepness, midpoint],
                    [exponent, 0.0, 0.0, 0.0],
                ],
            )
        }
        ResponseForm::Table(table) => tabulated(table.pieces(), table.lines()),
        ResponseForm::Code => {
            let response = loss.response();
            let pieces: Vec<[f32; 5]> = sampled(response);
            let ends = [SAMPLED.0, SAMPLED.1].map(|dose| {
                let (value, slope) = response.value_and_slope(dose);
                [dose, value, slope]
            });
            tabulated(&pieces, ends)
        }
    }
}

/// Between which doses a response of the host is sampled, and how often.
const SAMPLED: (f32, f32) = (0.0, 4.0);
const SAMPLES: usize = 512;

/// Cubics with the values and slopes of a response.
fn sampled(response: &dyn tomolith_core::response::Response) -> Vec<[f32; 5]> {
    let width = (SAMPLED.1 - SAMPLED.0) / SAMPLES as f32;
    let cubic = |i: usize| {
        let begin = SAMPLED.0 + i as f32 * width;
        let (y0, s0) = response.value_and_slope(begin);
        let (y1, s1) = response.value_and_slope(begin + width);
        let secant = (y1 - y0) / width;
        let c = (3.0 * secant - 2.0 * s0 - s1) / width;
        let d = (s0 + s1 - 2.0 * secant) / (width * width);
        [begin, y0, s0, c, d]
    };
    (0..SAMPLES).map(cubic).collect()
}

/// A table is part of the kernel: few numbers, found by halving.
fn tabulated(pieces: &[[f32; 5]], lines: [[f32; 3]; 2]) -> (String, String, [[f32; 4]; 2]) {
    let list = |text_of: &dyn Fn(&[f32; 5]) -> String| {
        pieces.iter().map(text_of).collect::<Vec<_>>().join(", ")
    };
    let n = pieces.len();
    let begins = list(&|piece| format!("{:?}", piece[0]));
    let cubics = list(&|[_, a, b, c, d]| format!("vec4({a:?}, {b:?}, {c:?}, {d:?})"));
    let text = format!(
        "const BEGINS = array<f32, {n}>({begins});
const CUBICS = array<vec4<f32>, {n}>({cubics});
fn line(d: f32, begin: f32, value: f32, slope: f32) -> vec2<f32> {{
    return vec2(clamp(value + slope * (d - begin), -3.4e38, 3.4e38), slope);
}}
fn responded(d: f32) -> vec2<f32> {{
    if (d < p.b.x) {{ return line(d, p.b.x, p.b.y, p.b.z); }}
    if (d > p.c.x) {{ return line(d, p.c.x, p.c.y, p.c.z); }}
    var begins = BEGINS;
    var cubics = CUBICS;
    var low = 0u;
    var high = {n}u;
    while (high - low > 1u) {{
        let middle = (low + high) / 2u;
        if (begins[middle] <= d) {{ low = middle; }} else {{ high = middle; }}
    }}
    let t = d - begins[low];
    let k = cubics[low];
    return vec2(((k.w * t + k.z) * t + k.y) * t + k.x, (3.0 * k.w * t + 2.0 * k.z) * t + k.y);
}}"
    );
    let [[b0, v0, s0], [b1, v1, s1]] = lines;
    let name = format!("table {:x}", fingerprint(text.as_bytes()));
    (name, text, [[b0, v0, s0, 0.0], [b1, v1, s1, 0.0]])
}

/// FNV-1a: tells the kernels of two tables apart.
fn fingerprint(bytes: &[u8]) -> u64 {
    let step = |hash: u64, &byte: &u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

fn band(at: &str, band: &Band) -> String {
    let number = |v: f32| match v {
        f32::INFINITY => "3.4e38".to_owned(),
        f32::NEG_INFINITY => "-3.4e38".to_owned(),
        other => format!("{other:?}"),
    };
    let [lower, upper, weight] = [band.lower, band.upper, band.weight].map(number);
    format!("const {at} = vec3<f32>({lower}, {upper}, {weight});")
}

/// A bound that is none, as a number that f32 holds.
fn finite(v: f32) -> f32 {
    v.clamp(-3.4e38, 3.4e38)
}

impl Data {
    /// Of the elements of a loss, in a field like this one; its name, constants, and how a body finds `t` of element i.
    fn of(loss: &BandLoss, like: &GpuField) -> (Self, [String; 3]) {
        let (elements, len) = (loss.elements(), like.len());
        let whole = |values: &[f32], beyond: f32| {
            let mut all = vec![beyond; len];
            let given = &values[..elements.len().min(values.len())];
            all[elements.start..][..given.len()].copy_from_slice(given);
            let mut field = like.scratch_like();
            field.copy_from_host(&all);
            field
        };
        match loss.bands() {
            Bands::Labels { labels, table } => {
                let free = (0..=255u8).find(|&label| table[usize::from(label)].weight == 0.0);
                let mut all = vec![free.unwrap_or(0); len.next_multiple_of(4)];
                all[elements.clone()].copy_from_slice(&labels[..elements.len()]);
                let of_piece = |range: std::ops::Range<usize>| {
                    like.gpu()
                        .upload(&all[range.start..range.end.next_multiple_of(4)])
                };
                let words: Vec<[f32; 4]> = table
                    .iter()
                    .map(|b| [finite(b.lower), finite(b.upper), b.weight, 0.0])
                    .collect();
                let table = |_| like.gpu().upload(&words);
                let data = Data::Labels {
                    labels: like.ranges().map(of_piece).collect(),
                    table: (0..like.pieces().len()).map(table).collect(),
                };
                let find = "let band = table[(labels[i / 4u] >> (8u * (i % 4u))) & 255u];
        let t = penalty(m, band.x, band.y, band.z);";
                (data, ["labels", "", find].map(str::to_owned))
            }
            Bands::Shared {
                inside,
                part,
                void,
                scale,
                widen,
            } => {
                let some =
                    |field: &Vec<f32>, beyond| (!field.is_empty()).then(|| whole(field, beyond));
                let (scale, widen) = (some(scale, 1.0), some(widen, 0.0));
                let of_scale = scale.as_ref().map_or("1.0", |_| "scale[i]");
                let of_widen = widen.as_ref().map_or("0.0", |_| "widen[i]");
                let (part, void) = (band("PART", part), band("VOID", void));
                let find = format!(
                    "let share = inside[i]; let factor = {of_scale}; let wide = {of_widen};
        var t = vec2(0.0);
        if (share >= 0.0) {{
            t = penalty(m, PART.x - wide, PART.y + wide, PART.z * (share * factor))
                + penalty(m, VOID.x - wide, VOID.y + wide, VOID.z * ((1.0 - share) * factor));
        }}"
                );
                let constants = format!("{part}\n{void}\n");
                let name = format!(
                    "shared {of_scale} {of_widen} {:x}",
                    fingerprint(constants.as_bytes())
                );
                let data = Data::Shared {
                    inside: whole(inside, -1.0),
                    scale,
                    widen,
                };
                (data, [name, constants, find])
            }
            Bands::Voxels {
                lower,
                upper,
                weight,
            } => {
                let finite = |values: &[f32]| values.iter().map(|&v| finite(v)).collect::<Vec<_>>();
                let data = Data::Voxels {
                    lower: whole(&finite(lower), 0.0),
                    upper: whole(&finite(upper), 0.0),
                    weight: whole(weight, 0.0),
                };
                let find = "let t = penalty(m, lower[i], upper[i], weight[i]);";
                (data, ["voxels", "", find].map(str::to_owned))
            }
        }
    }

    fn operands(&self) -> Vec<Operand<'_>> {
        match self {
            Data::Labels { labels, table } => vec![
                Operand::read("labels", labels).words(),
                Operand {
                    element: "vec4<f32>",
                    ..Operand::read("table", table)
                },
            ],
            Data::Shared {
                inside,
                scale,
                widen,
            } => {
                let mut operands = vec![Operand::read("inside", inside.pieces())];
                operands.extend(
                    scale
                        .iter()
                        .map(|field| Operand::read("scale", field.pieces())),
                );
                operands.extend(
                    widen
                        .iter()
                        .map(|field| Operand::read("widen", field.pieces())),
                );
                operands
            }
            Data::Voxels {
                lower,
                upper,
                weight,
            } => vec![
                Operand::read("lower", lower.pieces()),
                Operand::read("upper", upper.pieces()),
                Operand::read("weight", weight.pieces()),
            ],
        }
    }
}

impl GpuBands {
    /// Sums of a pass whose body begins with `d`, the dose of element i; `found` is value and slope there.
    fn pass<'a>(
        &'a self,
        what: &str,
        [dose, then]: [&str; 2],
        mut operands: Vec<Operand<'a>>,
        like: &GpuField,
        alpha: f32,
        count: usize,
    ) -> Vec<f64> {
        operands.extend(self.data.operands());
        let find = &self.find;
        let pass = Pass {
            name: &format!("bands {what} {}", self.name),
            functions: &self.functions,
            body: &format!(
                "let d = {dose};
        let response = responded(d);
        let m = response.x;
        {find}
        let found = vec2(t.x, t.y * response.y);
        s0 += found.x;
        {then}"
            ),
            numbers: [[alpha, 0.0, 0.0, 0.0], self.numbers[0], self.numbers[1]],
        };
        pass.sums(like.gpu(), &operands, like.lengths(), count)
    }
}

impl BandKernel<GpuField> for GpuBands {
    fn new(loss: &Arc<BandLoss>, like: &GpuField) -> Self {
        let (of_power, power) = penalty(loss.powers()[0]);
        let (of_curve, curve, numbers) = curve(loss);
        let (data, [of_data, constants, find]) = Data::of(loss, like);
        GpuBands {
            loss: loss.clone(),
            name: format!("{of_power} {of_curve} {of_data}"),
            functions: format!("{power}{curve}\n{constants}"),
            find,
            data,
            numbers,
        }
    }

    fn value(&self, dose: &GpuField) -> f64 {
        let operands = vec![Operand::read("dose", dose.pieces())];
        let sums = self.pass("value", ["dose[i]", ""], operands, dose, 0.0, 1);
        self.loss.loss(sums[0])
    }

    fn value_and_gradient(&self, dose: &GpuField, grad: &mut GpuField) -> f64 {
        let operands = vec![
            Operand::read("dose", dose.pieces()),
            Operand::written("grad", grad.pieces()),
        ];
        let body = ["dose[i]", "grad[i] = found.y;"];
        let sum = self.pass("gradient", body, operands, dose, 0.0, 1)[0];
        let slope = self.loss.loss_slope(sum);
        if slope != 1.0 {
            grad.scale(slope as f32);
        }
        self.loss.loss(sum)
    }

    fn slope_along(&self, dose: &GpuField, step: &GpuField, alpha: f32) -> (f64, f64) {
        let operands = vec![
            Operand::read("dose", dose.pieces()),
            Operand::read("step", step.pieces()),
        ];
        let body = ["dose[i] + p.a.x * step[i]", "s1 += found.y * step[i];"];
        let sums = self.pass("along", body, operands, dose, alpha, 2);
        let slope = self.loss.loss_slope(sums[0]);
        (self.loss.loss(sums[0]), slope * sums[1])
    }

    fn advance(&self, dose: &mut GpuField, step: &mut GpuField, alpha: f32) -> f64 {
        dose.axpy(alpha, step);
        self.value_and_gradient(dose, step)
    }
}
