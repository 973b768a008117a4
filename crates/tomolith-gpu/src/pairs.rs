//! The memory of a quasi-Newton method on the card.
//!
//! A slot is one word per element, s in its lower and z in its upper half, in bf16 as on the host ([`tomolith_core::field::Pairs`]).
//! **Cost** per element with m pairs: [`record`](Pairs::record) reads 20 + 16m bytes and writes 4; [`direction`](Pairs::direction) reads 20 + 6m and
//! writes 8 + 2m. Memory: 4m bytes.

use crate::field::{CLAMP, GpuBounds, GpuField};
use crate::passes::{Operand, Pass, finish_sums};
use std::borrow::Cow;
use tomolith_core::error::Result;
use tomolith_core::field::{
    Direction, DirectionSums, Field as _, Latest, Pairs, PairsPart, Products,
};

/// Slots that one pass combines.
const TOGETHER: usize = 4;

/// [`Pairs`] on a graphics card.
pub struct GpuPairs {
    /// Of each slot the words, as f32 that nobody reads as such.
    slots: Vec<GpuField>,
}

/// s and z of a word, and back.
const PACK: &str = "
fn half(v: f32) -> u32 { let bits = bitcast<u32>(v); return bits + 0x7fffu + ((bits >> 16u) & 1u); }
fn packed(s: f32, z: f32) -> u32 { return (half(s) >> 16u) | (half(z) & 0xffff0000u); }
fn s_of(word: u32) -> f32 { return bitcast<f32>(word << 16u); }
fn z_of(word: u32) -> f32 { return bitcast<f32>(word & 0xffff0000u); }
";

/// What its memory is called in a checkpoint: that of the host has another order.
const PART: &str = "pairs of a card";

impl GpuPairs {
    /// Of all slots.
    fn bytes(&self) -> usize {
        self.slots.iter().map(|slot| 4 * slot.len()).sum()
    }

    /// Writes the newest pair; the sums s·s and y·y.
    fn store(&self, slot: usize, latest: &Latest<GpuField>) -> [f64; 2] {
        let pass = Pass {
            name: "pairs store",
            functions: PACK,
            body: "let word = packed(p.a.x * step[i], image[i]);
            pair[i] = word;
            let s = s_of(word);
            let y = change[i];
            s0 += s * s; s1 += y * y;",
            numbers: [[latest.alpha, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4]],
        };
        let operands = [
            Operand::written("pair", self.slots[slot].pieces()).words(),
            Operand::read("step", latest.step.pieces()),
            Operand::read("image", latest.image.pieces()),
            Operand::read("change", latest.change.pieces()),
        ];
        let sums = pass.sums(latest.x.gpu(), &operands, latest.x.lengths(), 2);
        [sums[0], sums[1]]
    }
}

impl Pairs<GpuField> for GpuPairs {
    const MAX_MEMORY: usize = 30;

    fn new(slots: usize, bounds: &GpuBounds) -> Self {
        let slot = || bounds.new_field().zeros_like();
        GpuPairs {
            slots: (0..slots).map(|_| slot()).collect(),
        }
    }

    fn record(&mut self, slot: usize, latest: &Latest<GpuField>, bounds: &GpuBounds) -> Products {
        let [s_s, y_y] = self.store(slot, latest);
        let (of_bounds, find, c) = bounds.operands();
        let pass = Pass {
            name: &format!("pairs products {}", bounds.suffix()),
            functions: PACK,
            body: &format!(
                "{find}
            let s = s_of(pair[i]);
            let z = z_of(pair[i]);
            let y = change[i];
            let g = gradient[i];
            let held = (x[i] <= low && g >= 0.0) || (x[i] >= high && g <= 0.0);
            let free = select(g, 0.0, held);
            s0 += s * y; s1 += z * y; s2 += s * free; s3 += z * free;"
            ),
            numbers: [[0.0; 4], [0.0; 4], c],
        };
        let of_slot = |pair: &GpuField| {
            let mut operands = vec![
                Operand::read("pair", pair.pieces()).words(),
                Operand::read("x", latest.x.pieces()),
                Operand::read("gradient", latest.gradient.pieces()),
                Operand::read("change", latest.change.pieces()),
            ];
            operands.extend(of_bounds.iter().map(|o| Operand::read(o.name, o.pieces)));
            pass.begin_sums(latest.x.gpu(), &operands, latest.x.lengths(), 4)
        };
        let pending: Vec<_> = self.slots.iter().map(of_slot).collect();
        let sums = finish_sums(latest.x.gpu(), &pending);
        let sums_of = |k: usize| sums.iter().map(|row| row[k]).collect();
        Products {
            s_y: sums_of(0),
            z_y: sums_of(1),
            s_g: sums_of(2),
            z_g: sums_of(3),
            s_s,
            y_y,
        }
    }

    fn direction(
        &self,
        direction: &Direction,
        x: &GpuField,
        gradient: &GpuField,
        image: &GpuField,
        bounds: &GpuBounds,
        out: &mut GpuField,
    ) -> DirectionSums {
        out.copy_from(image);
        out.scale(-direction.scale);
        let factors = direction.along_s.iter().zip(&direction.along_z);
        let used: Vec<(&GpuField, [f32; 2])> = (self.slots.iter().zip(factors))
            .map(|(slot, (&a, &b))| (slot, [a, b]))
            .filter(|(_, factors)| *factors != [0.0; 2])
            .collect();
        for some in used.chunks(TOGETHER) {
            add_pairs(out, some);
        }
        let (of_bounds, find, c) = bounds.operands();
        let pass = Pass {
            name: &format!("pairs direction {}", bounds.suffix()),
            functions: CLAMP,
            body: &format!(
                "{find}
            let g = gradient[i];
            let at = x[i];
            let held = (at <= low && g >= 0.0) || (at >= high && g <= 0.0);
            let short = clamped(at - p.a.x * g, low, high) - at;
            let step = select(clamped(at + p.a.y * out[i], low, high) - at, 0.0, held);
            out[i] = step;
            s0 += g * step; s1 += step * step; s2 += g * short; s3 += short * short;"
            ),
            numbers: [[direction.length, direction.stretch, 0.0, 0.0], [0.0; 4], c],
        };
        let mut operands = vec![
            Operand::written("out", out.pieces()),
            Operand::read("x", x.pieces()),
            Operand::read("gradient", gradient.pieces()),
        ];
        operands.extend(of_bounds);
        let sums = pass.sums(x.gpu(), &operands, x.lengths(), 4);
        DirectionSums {
            slope: sums[0],
            square: sums[1],
            gradient_slope: sums[2],
            gradient_square: sums[3],
        }
    }

    fn parts(&self) -> Vec<PairsPart<'_>> {
        vec![PairsPart {
            name: PART,
            len: self.bytes(),
            bytes: Box::new(|| {
                let slots: Vec<_> = self.slots.iter().map(|slot| slot.host_bytes()).collect();
                Cow::Owned(slots.concat())
            }),
        }]
    }

    fn restore(&mut self, read: &mut dyn FnMut(&str, &mut [u8]) -> Result<()>) -> Result<()> {
        let mut bytes = vec![0; self.bytes()];
        read(PART, &mut bytes)?;
        let mut rest = &bytes[..];
        for slot in &self.slots {
            for (piece, &n) in slot.pieces().iter().zip(slot.lengths()) {
                let (part, others) = rest.split_at(4 * n);
                slot.gpu().write(piece, 0, part);
                rest = others;
            }
        }
        Ok(())
    }
}

/// d ← d + Σ (a·s + b·z) of a few slots
fn add_pairs(d: &mut GpuField, some: &[(&GpuField, [f32; 2])]) {
    const NAMES: [&str; TOGETHER] = ["pair0", "pair1", "pair2", "pair3"];
    const AXES: [&str; TOGETHER] = ["x", "y", "z", "w"];
    let mut numbers = [[0.0; 4]; 3];
    let mut body = "var sum = d[i];".to_owned();
    let mut operands = vec![Operand::written("d", d.pieces())];
    for (k, (slot, [a, b])) in some.iter().enumerate() {
        (numbers[0][k], numbers[1][k]) = (*a, *b);
        operands.push(Operand::read(NAMES[k], slot.pieces()).words());
        let (pair, axis) = (NAMES[k], AXES[k]);
        body += &format!("sum += p.a.{axis} * s_of({pair}[i]) + p.b.{axis} * z_of({pair}[i]);");
    }
    body += "d[i] = sum;";
    let pass = Pass {
        name: &format!("pairs add {}", some.len()),
        functions: PACK,
        body: &body,
        numbers,
    };
    pass.each(d.gpu(), &operands, d.lengths());
}
