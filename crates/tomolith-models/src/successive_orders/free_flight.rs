//! The kernel of free flight between cells.
//!
//! Light that starts evenly in a cell with the angular weight Y_b reaches another cell, n cells away, with the moment
//!
//! ```text
//! K_ab(n) = ∫ Λ(d/h − n) · e^(−μ|d|)/d² · Y_a(d̂) Y_b(d̂) d³d,     Λ(t) = Π max(0, 1 − |t_i|)
//! ```
//! (means over both cells: their displacements d are spread over a cube of edge 2h with the weight Λ). Cubes that touch d = 0 are
//! integrated in polar coordinates, where the pole is gone; the next ones by Gauss's rule between the kinks of Λ; the others by
//! three points an axis, which have the moments of Λ up to the fifth. Beyond [`DARK`] lengths of attenuation the kernel is 0.

use super::harmonics::Harmonic;
use crate::Work;
use std::f64::consts::PI;
use tomolith_core::error::Result;
use tomolith_core::parallel::InParallel;

/// A sum of products of harmonics with one parity: Σ weight · Y_a · Y_b.
#[derive(Clone, Debug)]
pub(super) struct Pattern(pub(super) Vec<(f64, Harmonic, Harmonic)>);

impl Pattern {
    /// Signs under a turn of x, of y, of z; the same for all its products.
    pub(super) fn parities(&self) -> [f64; 3] {
        let Some(&(_, a, b)) = self.0.first() else {
            return [1.0; 3];
        };
        let (a, b) = (a.parities(), b.parities());
        std::array::from_fn(|i| a[i] * b[i])
    }
}

/// Free flight on cells of one size.
#[derive(Clone, Copy, Debug)]
pub(super) struct FreeFlightKernel {
    /// Attenuation, 1/mm.
    pub(super) mu: f64,
    /// Edge of a cell, mm.
    pub(super) edge: f64,
}

/// Lengths of attenuation after which light counts as gone: 2·10⁻⁹ of it is left.
const DARK: f64 = 20.0;

/// A point of a quadrature: a direction, and what arrives from it.
type Node = ([f64; 3], f64);

impl FreeFlightKernel {
    /// K of every pattern for displacements of 0, 1, … cells along x, y, z; array order `[y][x][z]`.
    pub(super) fn octants(
        self,
        patterns: &[Pattern],
        [nx, ny, nz]: [usize; 3],
        work: &Work,
    ) -> Result<Vec<Vec<f32>>> {
        let sums = Sums::new(patterns);
        let polar = polar_directions();
        let lit = |n: [usize; 3]| {
            let cells = n.iter().map(|&n| (n * n) as f64).sum::<f64>().sqrt();
            // Nearest displacements of two cells: half a diagonal of each less
            self.mu * self.edge * (cells - 3.0f64.sqrt()) < DARK
        };
        // Of each line along z the cells that are lit, pattern by pattern
        let lines: Vec<Vec<f32>> = (0..nx * ny).par_map(|i| {
            if work.is_canceled() {
                return Vec::new();
            }
            let place = |z: usize| [i % nx, i / nx, z];
            let cells = (0..nz).map(place).take_while(|&n| lit(n));
            let values = cells.flat_map(|n| {
                if n.into_iter().max() <= Some(1) {
                    sums.over(&self.near_pole(n, &polar))
                } else {
                    sums.over(&self.far_from_pole(n))
                }
            });
            values.collect()
        });
        work.check()?;
        let of_pattern = |p: usize| {
            let mut octant = vec![0.0; nx * ny * nz];
            for (line, values) in octant.chunks_mut(nz).zip(&lines) {
                let values = values.iter().skip(p).step_by(patterns.len());
                line.iter_mut()
                    .zip(values)
                    .for_each(|(k, &value)| *k = value);
            }
            octant
        };
        Ok((0..patterns.len()).map(of_pattern).collect())
    }

    /// The points of cells that do not touch.
    fn far_from_pole(self, n: [usize; 3]) -> Vec<Node> {
        let near = n.into_iter().max().unwrap_or(0);
        let rule: &[(f64, f64)] = if near <= 3 { &GAUSS } else { &MOMENTS };
        let mut nodes = Vec::with_capacity(rule.len().pow(3));
        for &(x, wx) in rule {
            for &(y, wy) in rule {
                for &(z, wz) in rule {
                    let t = [n[0] as f64 + x, n[1] as f64 + y, n[2] as f64 + z];
                    let square = t.iter().map(|v| v * v).sum::<f64>();
                    let length = square.sqrt();
                    let left = (-self.mu * self.edge * length).exp();
                    let arrives = self.edge * wx * wy * wz * left / square;
                    nodes.push((t.map(|v| v / length), arrives));
                }
            }
        }
        nodes
    }

    /// The weights in polar coordinates about d = 0: there 1/d² is gone.
    fn near_pole(self, n: [usize; 3], directions: &[Node]) -> Vec<Node> {
        let along = |&(direction, solid): &Node| {
            let mut cuts = vec![0.0];
            for (d, n) in direction.iter().zip(n) {
                // Kinks of Λ: where t_i is n − 1, n, n + 1
                let kinks = [n as f64 - 1.0, n as f64, n as f64 + 1.0].map(|at| at / d);
                cuts.extend(kinks.into_iter().filter(|&t| t > 0.0 && t < 4.0));
            }
            cuts.sort_by(f64::total_cmp);
            let mut sum = 0.0;
            for piece in cuts.windows(2) {
                let (middle, half) = ((piece[0] + piece[1]) / 2.0, (piece[1] - piece[0]) / 2.0);
                for (x, weight) in GAUSS_5 {
                    let t = middle + half * x;
                    let spread: f64 = (0..3)
                        .map(|i| (1.0 - (t * direction[i] - n[i] as f64).abs()).max(0.0))
                        .product();
                    sum += half * weight * spread * (-self.mu * self.edge * t).exp();
                }
            }
            (direction, self.edge * solid * sum)
        };
        let nodes = directions.iter().map(along);
        nodes.filter(|&(_, arrives)| arrives != 0.0).collect()
    }
}

/// Sums over points for many patterns at once: every harmonic is evaluated once, and its norm never again.
struct Sums {
    harmonics: Vec<Harmonic>,
    /// Of each pattern: weight times both norms, and places of its two harmonics.
    patterns: Vec<Vec<(f64, usize, usize)>>,
}

impl Sums {
    fn new(patterns: &[Pattern]) -> Self {
        let mut harmonics: Vec<Harmonic> = Vec::new();
        let mut place = |harmonic: Harmonic| {
            let found = harmonics.iter().position(|&h| h == harmonic);
            found.unwrap_or_else(|| {
                harmonics.push(harmonic);
                harmonics.len() - 1
            })
        };
        let patterns = patterns
            .iter()
            .map(|pattern| {
                let terms = pattern.0.iter();
                terms
                    .map(|&(weight, a, b)| (weight * a.norm() * b.norm(), place(a), place(b)))
                    .collect()
            })
            .collect();
        Sums {
            harmonics,
            patterns,
        }
    }

    fn over(&self, nodes: &[Node]) -> Vec<f32> {
        let mut sums = vec![0.0; self.patterns.len()];
        let mut values = vec![0.0; self.harmonics.len()];
        for &(direction, arrives) in nodes {
            for (value, harmonic) in values.iter_mut().zip(&self.harmonics) {
                *value = harmonic.form(direction);
            }
            for (sum, terms) in sums.iter_mut().zip(&self.patterns) {
                let product =
                    |&(weight, a, b): &(f64, usize, usize)| weight * values[a] * values[b];
                *sum += arrives * terms.iter().map(product).sum::<f64>();
            }
        }
        sums.into_iter().map(|sum| sum as f32).collect()
    }
}

/// Directions over the sphere with their solid angles; none along an axis.
fn polar_directions() -> Vec<Node> {
    const RINGS: usize = 96;
    const AROUND: usize = 2 * RINGS;
    let mut nodes = Vec::with_capacity(RINGS * AROUND);
    for ring in 0..RINGS {
        // Equal steps of z: rings of equal solid angle
        let z = 2.0 * (ring as f64 + 0.5) / RINGS as f64 - 1.0;
        let across = (1.0 - z * z).sqrt();
        for k in 0..AROUND {
            let phi = 2.0 * PI * (k as f64 + 0.5) / AROUND as f64;
            let solid = 4.0 * PI / (RINGS * AROUND) as f64;
            nodes.push(([across * phi.cos(), across * phi.sin(), z], solid));
        }
    }
    nodes
}

/// Gauss–Legendre, five points on [−1, 1].
const GAUSS_5: [(f64, f64); 5] = [
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// Four points of Gauss's rule on either side of the kink, with Λ in the weights.
const GAUSS: [(f64, f64); 8] = kinked();

const fn kinked() -> [(f64, f64); 8] {
    const HALF: [(f64, f64); 4] = [
        (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
        (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
        (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
        (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
    ];
    let mut rule = [(0.0, 0.0); 8];
    let mut i = 0;
    while i < 4 {
        let (x, weight) = HALF[i];
        rule[2 * i] = (x, weight * (1.0 - x));
        rule[2 * i + 1] = (-x, weight * (1.0 - x));
        i += 1;
    }
    rule
}

/// Λ has the variance 1/6 and the fourth moment 1/15: points 0 and ±√(2/5), weights 7/12 and 5/24.
const MOMENTS: [(f64, f64); 3] = [
    (0.0, 7.0 / 12.0),
    (0.632_455_532_033_675_9, 5.0 / 24.0),
    (-0.632_455_532_033_675_9, 5.0 / 24.0),
];

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::error::Error;

    fn harmonic(l: usize, m: isize) -> Harmonic {
        Harmonic { l, m }
    }

    /// Sum over all displacements, from the octant.
    fn sum_over_all(octant: &[f32], [nx, ny, nz]: [usize; 3]) -> f64 {
        let twice = |i: usize| if i == 0 { 1.0 } else { 2.0 };
        let mut sum = 0.0;
        for y in 0..ny {
            for x in 0..nx {
                for z in 0..nz {
                    let value = f64::from(octant[(y * nx + x) * nz + z]);
                    sum += twice(x) * twice(y) * twice(z) * value;
                }
            }
        }
        sum
    }

    #[test]
    fn all_of_the_light_of_a_cell_arrives_somewhere() {
        // Y_00² = 1/4π, so that the sum over all cells is ∫ e^(−μR)/(4πR²) d³R = 1/μ
        let free_flight = FreeFlightKernel {
            mu: 2.0,
            edge: 0.25,
        };
        let even = Pattern(vec![(1.0, harmonic(0, 0), harmonic(0, 0))]);
        let counts = [28; 3]; // 7 mm: e^−14 is left
        let sum = sum_over_all(
            &free_flight.octants(&[even], counts, &Work::new()).unwrap()[0],
            counts,
        );
        assert!((sum * 2.0 - 1.0).abs() < 3e-4, "{sum}");
        // As much with the weight Y_20² · 4π/5-fold mean 1: ∫ Y_20² dΩ = 1
        let lobes = Pattern(vec![(1.0, harmonic(2, 0), harmonic(2, 0))]);
        let sum = sum_over_all(
            &free_flight.octants(&[lobes], counts, &Work::new()).unwrap()[0],
            counts,
        );
        assert!((sum * 2.0 - 1.0).abs() < 3e-4, "{sum}");
        // Different harmonics cancel
        let mixed = Pattern(vec![(1.0, harmonic(0, 0), harmonic(2, 0))]);
        let sum = sum_over_all(
            &free_flight.octants(&[mixed], counts, &Work::new()).unwrap()[0],
            counts,
        );
        assert!(sum.abs() * 2.0 < 3e-4, "{sum}");
    }

    #[test]
    fn far_cells_see_a_point_and_the_cell_itself_its_mean_chord() {
        let free_flight = FreeFlightKernel { mu: 0.3, edge: 0.2 };
        let even = Pattern(vec![(1.0, harmonic(0, 0), harmonic(0, 0))]);
        let octant = &free_flight
            .octants(std::slice::from_ref(&even), [12, 1, 1], &Work::new())
            .unwrap()[0];
        let distance: f64 = 11.0 * 0.2;
        let point = 0.2f64.powi(3) * (-0.3 * distance).exp() / (4.0 * PI * distance * distance);
        assert!((f64::from(octant[11]) / point - 1.0).abs() < 5e-3);
        // Without attenuation the mean of 1/(4πd²) over pairs of points of a unit cube is 0.4472(14) by independent sampling
        let clear = FreeFlightKernel {
            mu: 1e-9,
            edge: 1.0,
        };
        let mean = f64::from(clear.octants(&[even], [1, 1, 1], &Work::new()).unwrap()[0][0]);
        assert!((mean - 0.4472).abs() < 0.003, "{mean}");
    }

    #[test]
    fn light_ends_where_nothing_of_it_is_left_and_a_canceled_run_ends_at_once() {
        let dense = FreeFlightKernel { mu: 5.0, edge: 0.5 };
        let even = [Pattern(vec![(1.0, harmonic(0, 0), harmonic(0, 0))])];
        // 2.5 lengths a cell: the tenth begins 8.3 cells away, 20.7 lengths
        let octant = &dense.octants(&even, [12, 1, 1], &Work::new()).unwrap()[0];
        assert!(
            octant[9] > 0.0 && octant[9] < 1e-9 * octant[0],
            "{octant:?}"
        );
        assert_eq!(octant[10..], [0.0; 2]);
        let work = Work::new();
        work.cancel();
        let ended = dense.octants(&even, [12, 1, 1], &work);
        assert!(matches!(ended, Err(Error::Canceled)));
    }
}
