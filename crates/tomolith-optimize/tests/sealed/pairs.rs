//! Pairs of a quasi-Newton method beside a sealed field: 16 bits a number, as on the host, one element after the other.

use super::field::{Piece, SealedField};
use std::borrow::Cow;
use tomolith_core::error::Result;
use tomolith_core::field::{
    Direction, DirectionSums, Field as _, Latest, Pairs, PairsPart, Products,
};

/// Elements whose products are added two by two, eight apart.
const GROUP: usize = 16;
/// Elements that eight running sums of f32 are for.
const CHUNK: usize = 32 * GROUP;

/// The memory.
pub(crate) struct SealedPairs {
    slots: usize,
    /// `[element][slot]`: s and z, the upper halves of their bits.
    pairs: Vec<[u16; 2]>,
}

/// The nearest number with 16 bits.
fn rounded(value: f32) -> u16 {
    let bits = value.to_bits();
    (bits.wrapping_add(0x7fff).wrapping_add(bits >> 16 & 1) >> 16) as u16
}

fn full(half: u16) -> f32 {
    f32::from_bits(u32::from(half) << 16)
}

/// Eight running sums of the products of a chunk, and their sum.
#[derive(Clone, Copy, Default)]
struct Sums([f32; 8]);

impl Sums {
    /// Adds the products of a group.
    fn add(&mut self, a: &[f32; GROUP], b: &[f32; GROUP]) {
        for (i, sum) in self.0.iter_mut().enumerate() {
            *sum += a[i] * b[i] + a[i + 8] * b[i + 8];
        }
    }

    fn total(&self) -> f64 {
        self.0.iter().map(|&v| f64::from(v)).sum()
    }
}

/// The chunks of a piece, each as the first elements of its groups.
fn chunks(piece: &Piece) -> Vec<Vec<usize>> {
    let groups: Vec<usize> = piece.elements().step_by(GROUP).collect();
    groups
        .chunks(CHUNK / GROUP)
        .map(<[usize]>::to_vec)
        .collect()
}

/// A group's elements, 0 beyond the end of the piece.
fn group(piece: &Piece, begin: usize, of: impl Fn(usize) -> f32) -> [f32; GROUP] {
    let end = piece.elements().end;
    std::array::from_fn(|i| if begin + i < end { of(begin + i) } else { 0.0 })
}

impl SealedPairs {
    fn pair(&self, piece: &Piece, begin: usize, slot: usize) -> [[f32; GROUP]; 2] {
        [0, 1].map(|which| {
            group(piece, begin, |i| {
                full(self.pairs[i * self.slots + slot][which])
            })
        })
    }
}

impl Pairs<SealedField> for SealedPairs {
    const MAX_MEMORY: usize = 30;

    fn new(slots: usize, bounds: &Vec<Piece>) -> Self {
        let len: usize = bounds.iter().map(|piece| piece.len).sum();
        SealedPairs {
            slots,
            pairs: vec![[0; 2]; len * slots],
        }
    }

    fn record(
        &mut self,
        slot: usize,
        latest: &Latest<SealedField>,
        bounds: &Vec<Piece>,
    ) -> Products {
        let slots = self.slots;
        for i in 0..latest.x.len() {
            let (s, z) = (latest.alpha * latest.step.at(i), latest.image.at(i));
            self.pairs[i * slots + slot] = [rounded(s), rounded(z)];
        }
        let mut products = Products {
            s_y: vec![0.0; slots],
            z_y: vec![0.0; slots],
            s_g: vec![0.0; slots],
            z_g: vec![0.0; slots],
            s_s: 0.0,
            y_y: 0.0,
        };
        for piece in bounds {
            let mut of_piece = Products {
                s_s: 0.0,
                y_y: 0.0,
                ..products.clone()
            };
            for sums in [
                &mut of_piece.s_y,
                &mut of_piece.z_y,
                &mut of_piece.s_g,
                &mut of_piece.z_g,
            ] {
                sums.fill(0.0);
            }
            for chunk in chunks(piece) {
                let [mut s_s, mut y_y] = [Sums::default(); 2];
                let mut sums = vec![[Sums::default(); 4]; slots];
                for begin in chunk {
                    let free = group(piece, begin, |i| {
                        let g = latest.gradient.at(i);
                        if piece.holds(latest.x.at(i), g) {
                            0.0
                        } else {
                            g
                        }
                    });
                    let y = group(piece, begin, |i| latest.change.at(i));
                    let [newest, _] = self.pair(piece, begin, slot);
                    s_s.add(&newest, &newest);
                    y_y.add(&y, &y);
                    for (j, [s_y, z_y, s_g, z_g]) in sums.iter_mut().enumerate() {
                        let [s, z] = self.pair(piece, begin, j);
                        s_y.add(&s, &y);
                        z_y.add(&z, &y);
                        s_g.add(&s, &free);
                        z_g.add(&z, &free);
                    }
                }
                of_piece.s_s += s_s.total();
                of_piece.y_y += y_y.total();
                for (j, sums) in sums.iter().enumerate() {
                    let [s_y, z_y, s_g, z_g] = sums.map(|sums| sums.total());
                    of_piece.s_y[j] += s_y;
                    of_piece.z_y[j] += z_y;
                    of_piece.s_g[j] += s_g;
                    of_piece.z_g[j] += z_g;
                }
            }
            products.s_s += of_piece.s_s;
            products.y_y += of_piece.y_y;
            for j in 0..slots {
                products.s_y[j] += of_piece.s_y[j];
                products.z_y[j] += of_piece.z_y[j];
                products.s_g[j] += of_piece.s_g[j];
                products.z_g[j] += of_piece.z_g[j];
            }
        }
        products
    }

    fn direction(
        &self,
        direction: &Direction,
        x: &SealedField,
        gradient: &SealedField,
        image: &SealedField,
        bounds: &Vec<Piece>,
        out: &mut SealedField,
    ) -> DirectionSums {
        let mut all = DirectionSums::default();
        for piece in bounds {
            let mut of_piece = DirectionSums::default();
            for chunk in chunks(piece) {
                let [mut slope, mut square, mut g_slope, mut g_square] = [Sums::default(); 4];
                for begin in chunk {
                    let (x, g) = (
                        group(piece, begin, |i| x.at(i)),
                        group(piece, begin, |i| gradient.at(i)),
                    );
                    let mut d = group(piece, begin, |i| image.at(i)).map(|v| -direction.scale * v);
                    let to = |d: &[f32; GROUP]| -> [f32; GROUP] {
                        std::array::from_fn(|i| piece.clamp(x[i] + d[i]) - x[i])
                    };
                    let projected = to(&g.map(|g| -direction.length * g));
                    for j in 0..self.slots {
                        let [s, z] = self.pair(piece, begin, j);
                        let (a, b) = (direction.along_s[j], direction.along_z[j]);
                        d = std::array::from_fn(|i| d[i] + (a * s[i] + b * z[i]));
                    }
                    let mut step = to(&d.map(|d| direction.stretch * d));
                    let held: [bool; GROUP] = std::array::from_fn(|i| piece.holds(x[i], g[i]));
                    for (i, step) in step.iter_mut().enumerate() {
                        *step = if held[i] { 0.0 } else { *step };
                        if begin + i < piece.elements().end {
                            out.set(begin + i, *step);
                        }
                    }
                    // A group that the bounds hold whole counts for nothing
                    if held.contains(&false) {
                        slope.add(&g, &step);
                        square.add(&step, &step);
                        g_slope.add(&g, &projected);
                        g_square.add(&projected, &projected);
                    }
                }
                of_piece.slope += slope.total();
                of_piece.square += square.total();
                of_piece.gradient_slope += g_slope.total();
                of_piece.gradient_square += g_square.total();
            }
            all.slope += of_piece.slope;
            all.square += of_piece.square;
            all.gradient_slope += of_piece.gradient_slope;
            all.gradient_square += of_piece.gradient_square;
        }
        all
    }

    fn parts(&self) -> Vec<PairsPart<'_>> {
        let bytes = || {
            let halves = self.pairs.iter().flatten();
            Cow::Owned(halves.flat_map(|half| half.to_le_bytes()).collect())
        };
        vec![PairsPart {
            name: "sealed",
            len: self.pairs.len() * 4,
            bytes: Box::new(bytes),
        }]
    }

    fn restore(&mut self, read: &mut dyn FnMut(&str, &mut [u8]) -> Result<()>) -> Result<()> {
        let mut bytes = vec![0; self.pairs.len() * 4];
        read("sealed", &mut bytes)?;
        for (pair, bytes) in self.pairs.iter_mut().zip(bytes.chunks_exact(4)) {
            *pair = [0, 2].map(|i| u16::from_le_bytes([bytes[i], bytes[i + 1]]));
        }
        Ok(())
    }
}
