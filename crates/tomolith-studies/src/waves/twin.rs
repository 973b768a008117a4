//! The published algorithm, plainly, and with each saving alone.
//!
//! Wechsler et al. 2024, Algorithms 2 and 3: a window of twice the pattern, every plane of voxels by its own transform, the square, a bilinear
//! rotation. In f64 or f32, one thread.

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftNum, FftPlanner};
use std::cell::OnceCell;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use std::time::Instant;

/// 1/λ in resin of index 1.5 at 405 nm, 1/mm.
pub(super) const WAVENUMBER: f64 = 1.5 / 405e-6;

/// How light in the frame of the projector becomes the dose of voxels that have turned.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Gather {
    /// A volume of all planes, turned into another one, which is added: as published.
    Volumes,
    /// Voxels read planes, and none of these volumes is made.
    Planes,
    /// One pass over the voxels for each depth that is computed, weighted with its polynomial at the voxel's own depth.
    Basis,
}

/// What is different from the published algorithm.
#[derive(Clone, Copy)]
pub(super) struct Savings {
    /// One transform of the pattern, and sums in Fourier space, instead of one for every plane.
    pub(super) one_transform: bool,
    /// Planes behind the focus only.
    pub(super) mirror: bool,
    /// Window over pattern.
    pub(super) window: f64,
    /// Light at so many Chebyshev nodes of the depth, and polynomials between them, instead of all planes.
    pub(super) nodes: Option<usize>,
    pub(super) gather: Gather,
    /// Part of the band over which it fades.
    pub(super) soft_edge: f64,
    /// Phases as 2π·x·w in f32, instead of 2π·x·(w − 1/λ) in f64.
    pub(super) whole_phase: bool,
}

impl Savings {
    /// None of them.
    pub(super) const NONE: Savings = Savings {
        one_transform: false,
        mirror: false,
        window: 2.0,
        nodes: None,
        gather: Gather::Volumes,
        soft_edge: 0.0,
        whole_phase: false,
    };
}

/// The published algorithm.
pub(super) struct Twin<T: FftNum> {
    n: usize,
    window: usize,
    pitch: f64,
    savings: Savings,
    forward: Arc<dyn Fft<T>>,
    inverse: Arc<dyn Fft<T>>,
    /// H·W of every depth that is computed, as the published program keeps them.
    kernels: OnceCell<Vec<Vec<Complex<T>>>>,
}

impl<T: FftNum> Twin<T> {
    pub(super) fn new(n: usize, pitch: f64, savings: Savings) -> Self {
        let smooth = |m: &usize| {
            let mut rest = *m;
            for p in [2, 3, 5, 7] {
                while rest.is_multiple_of(p) {
                    rest /= p;
                }
            }
            rest == 1
        };
        let least = (savings.window * n as f64).ceil() as usize;
        let window = (least..).find(|m| m % 2 == 0 && smooth(m)).unwrap_or(2 * n);
        let mut plans = FftPlanner::new();
        Twin {
            n,
            window,
            pitch,
            savings,
            forward: plans.plan_fft_forward(window),
            inverse: plans.plan_fft_inverse(window),
            kernels: OnceCell::new(),
        }
    }

    fn kernels(&self) -> &[Vec<Complex<T>>] {
        let of_all = || self.depths().iter().map(|&d| self.kernel(d)).collect();
        self.kernels.get_or_init(of_all)
    }

    fn of(value: f64) -> T {
        T::from_f64(value).unwrap_or_else(T::zero)
    }

    /// A transform of a whole window.
    fn transform(&self, plan: &Arc<dyn Fft<T>>, field: &mut [Complex<T>]) {
        let m = self.window;
        plan.process(field);
        for i in 0..m {
            for j in 0..i {
                field.swap(i * m + j, j * m + i);
            }
        }
        plan.process(field);
    }

    /// H·W of a depth, as the transform leaves frequencies (transposed or not is the same).
    fn kernel(&self, depth: f64) -> Vec<Complex<T>> {
        let m = self.window;
        let length = m as f64 * self.pitch;
        let limit = WAVENUMBER / ((2.0 * depth / length).powi(2) + 1.0).sqrt();
        let frequency = |i: usize| {
            let i = if i < m.div_ceil(2) {
                i as f64
            } else {
                i as f64 - m as f64
            };
            i / length
        };
        (0..m * m)
            .map(|i| {
                let (a, b) = (frequency(i % m), frequency(i / m));
                let ellipse =
                    |a: f64, b: f64| (a / limit).powi(2) + (b / WAVENUMBER).powi(2) <= 1.0;
                let square = WAVENUMBER * WAVENUMBER - a * a - b * b;
                let is_nyquist = i % m == m / 2 || i / m == m / 2;
                if square <= 0.0 || is_nyquist || !ellipse(a, b) || !ellipse(b, a) {
                    return Complex::new(T::zero(), T::zero());
                }
                let edge = self.savings.soft_edge.max(1e-9);
                let fade = |f: f64| {
                    let along = (2.0 * self.pitch * f.abs() - 1.0 + edge) / edge;
                    (0.25 * TAU * along.clamp(0.0, 1.0)).cos().powi(2)
                };
                let (sin, cos) = self.phase(depth, square.sqrt()).sin_cos();
                let size = fade(a) * fade(b);
                Complex::new(Self::of(size * cos), Self::of(size * sin))
            })
            .collect()
    }

    #[expect(clippy::cast_possible_truncation, reason = "what f32 makes of it")]
    fn phase(&self, depth: f64, w: f64) -> f64 {
        if self.savings.whole_phase {
            f64::from(TAU as f32 * depth as f32 * w as f32)
        } else {
            TAU * depth * (w - WAVENUMBER)
        }
    }

    /// A pattern `[u][z]` in the middle of its window.
    fn padded(&self, x: &[T]) -> Vec<Complex<T>> {
        let (n, m) = (self.n, self.window);
        let mut field = vec![Complex::new(T::zero(), T::zero()); m * m];
        let first = (m - n) / 2;
        for u in 0..n {
            for z in 0..n {
                field[(first + u) * m + first + z].re = x[u * n + z];
            }
        }
        field
    }

    fn cropped<R>(&self, field: &[Complex<T>], value: impl Fn(Complex<T>) -> R) -> Vec<R> {
        let (n, m) = (self.n, self.window);
        let first = (m - n) / 2;
        (0..n * n)
            .map(|i| value(field[(first + i / n) * m + first + i % n]))
            .collect()
    }

    /// ψ at a depth, in the whole window.
    fn field(
        &self,
        x: &[T],
        spectrum: Option<&[Complex<T>]>,
        kernel: &[Complex<T>],
    ) -> Vec<Complex<T>> {
        let mut field = match spectrum {
            Some(spectrum) => spectrum.to_vec(),
            None => {
                let mut field = self.padded(x);
                self.transform(&self.forward, &mut field);
                field
            }
        };
        let scale = Self::of(1.0 / (self.window * self.window) as f64);
        for (v, h) in field.iter_mut().zip(kernel) {
            *v = *v * h * scale;
        }
        self.transform(&self.inverse, &mut field);
        field
    }

    /// |ψ|² `[u][z]` at a depth.
    pub(super) fn intensity(&self, x: &[T], depth: f64) -> Vec<T> {
        let field = self.field(x, None, &self.kernel(depth));
        self.cropped(&field, |v| v.norm_sqr())
    }

    /// |ψ|² `[k][u][z]` of all planes, of which few may be computed.
    pub(super) fn light(&self, x: &[T]) -> Vec<T> {
        self.spread(&self.computed(x, self.spectrum(x).as_deref()))
    }

    /// Depth of plane k.
    pub(super) fn depth(&self, k: usize) -> f64 {
        (k as f64 - (self.n as f64 - 1.0) / 2.0) * self.pitch
    }

    /// Depths that are computed.
    fn depths(&self) -> Vec<f64> {
        let (all, first) = match self.savings.nodes {
            Some(count) => (count, 0),
            None if self.savings.mirror => (self.n, self.n / 2),
            None => (self.n, 0),
        };
        let depth = |i: usize| match self.savings.nodes {
            Some(count) => -self.depth(0) * chebyshev(count, i).0,
            None => self.depth(i),
        };
        let own = first..if self.savings.nodes.is_some() && self.savings.mirror {
            all.div_ceil(2)
        } else {
            all
        };
        own.map(depth).collect()
    }

    /// Which of the depths that are computed light at a place along the depth is made of, in planes from the first, and their weights.
    fn nodes_at(&self, place: f64) -> Option<impl Iterator<Item = (usize, T)>> {
        let count = self.savings.nodes?;
        let (middle, is_mirrored) = ((self.n as f64 - 1.0) / 2.0, self.savings.mirror);
        let own = move |node: usize| match is_mirrored {
            true => node.min(count - 1 - node),
            false => node,
        };
        let parts = barycentric(count, place / middle - 1.0);
        Some(parts.map(move |(node, weight)| (own(node), Self::of(weight))))
    }

    /// What plane k is made of: depths that are computed, and weights.
    fn parts(&self, k: usize) -> Vec<(usize, T)> {
        match self.nodes_at(k as f64) {
            Some(parts) => parts.collect(),
            None if self.savings.mirror => vec![(k.max(self.n - 1 - k) - self.n / 2, T::one())],
            None => vec![(k, T::one())],
        }
    }

    /// All planes from the depths that were computed.
    fn spread(&self, light: &[Vec<T>]) -> Vec<T> {
        let (n, size) = (self.n, self.n * self.n);
        let mut volume = vec![T::zero(); n * size];
        for (k, plane) in volume.chunks_exact_mut(size).enumerate() {
            for (node, weight) in self.parts(k) {
                for (to, &from) in plane.iter_mut().zip(&light[node]) {
                    *to = *to + weight * from;
                }
            }
        }
        volume
    }

    /// The transpose of [`spread`](Self::spread).
    fn gathered(&self, volume: &[T], depths: usize) -> Vec<Vec<T>> {
        let size = self.n * self.n;
        let mut light = vec![vec![T::zero(); size]; depths];
        for (k, plane) in volume.chunks_exact(size).enumerate() {
            for (node, weight) in self.parts(k) {
                for (to, &from) in light[node].iter_mut().zip(plane) {
                    *to = *to + weight * from;
                }
            }
        }
        light
    }

    /// Where a place in the frame of the light, x along it and y across, in voxels from the axis, lies among planes and columns.
    fn place(&self, [x, y]: [f64; 2], (sin, cos): (f64, f64)) -> [f64; 2] {
        let middle = (self.n as f64 - 1.0) / 2.0;
        [middle - (x * cos + y * sin), middle + y * cos - x * sin]
    }

    /// Planes and columns about that place, and their weights.
    pub(super) fn neighbors(&self, at: [f64; 2], turn: (f64, f64)) -> [(usize, usize, f64); 4] {
        let [d, u] = self.place(at, turn);
        let (planes, columns) = (self.pair(d), self.pair(u));
        [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(a, b)| {
            let ((k, of_plane), (j, of_column)) = (planes[a], columns[b]);
            (k, j, of_plane * of_column)
        })
    }

    /// Both indices about a place, and their weights, 0 outside.
    fn pair(&self, place: f64) -> [(usize, f64); 2] {
        let (first, off) = (place.floor(), place - place.floor());
        [(first, 1.0 - off), (first + 1.0, off)].map(|(i, weight)| {
            let is_inside = (0.0..self.n as f64).contains(&i);
            if is_inside {
                (i as usize, weight)
            } else {
                (0, 0.0)
            }
        })
    }

    /// Depth, column and weight of everything that column `place` of voxels reads, of the depths that are computed.
    fn entries(&self, place: usize, turn: (f64, f64)) -> Vec<(usize, usize, T)> {
        let middle = (self.n as f64 - 1.0) / 2.0;
        let at = [place % self.n, place / self.n].map(|i| i as f64 - middle);
        let nodes = match self.savings.gather {
            Gather::Basis => self.nodes_at(self.place(at, turn)[0]),
            Gather::Planes | Gather::Volumes => None,
        };
        let Some(nodes) = nodes else {
            let read = |(k, j, weight): (usize, usize, f64)| {
                let parts = self.parts(k).into_iter();
                parts.map(move |(node, part)| (node, j, Self::of(weight) * part))
            };
            return (self.neighbors(at, turn).into_iter())
                .flat_map(read)
                .collect();
        };
        let columns = self.pair(self.place(at, turn)[1]);
        nodes
            .flat_map(|(node, part)| columns.map(|(j, of)| (node, j, Self::of(of) * part)))
            .collect()
    }

    /// dose `[y][x][z]` += light of the depths that are computed
    fn add_dose(&self, light: &[Vec<T>], turn: (f64, f64), dose: &mut [T]) {
        let n = self.n;
        if self.savings.gather == Gather::Volumes {
            let volume = self.spread(light);
            let mut turned = vec![T::zero(); n * n * n];
            self.rotate(turn, |own, at, weight| {
                for z in 0..n {
                    turned[own + z] = turned[own + z] + weight * volume[at + z];
                }
            });
            for (to, from) in dose.iter_mut().zip(turned) {
                *to = *to + from;
            }
            return;
        }
        for (place, dose) in dose.chunks_exact_mut(n).enumerate() {
            for (node, j, weight) in self.entries(place, turn) {
                let from = &light[node][j * n..][..n];
                for (to, &from) in dose.iter_mut().zip(from) {
                    *to = *to + weight * from;
                }
            }
        }
    }

    /// What a cotangent `[y][x][z]` asks of the light of the depths that are computed.
    fn ask(&self, cotangent: &[T], depths: usize, turn: (f64, f64)) -> Vec<Vec<T>> {
        let n = self.n;
        if self.savings.gather == Gather::Volumes {
            let mut asked = vec![T::zero(); n * n * n];
            self.rotate(turn, |own, at, weight| {
                for z in 0..n {
                    asked[at + z] = asked[at + z] + weight * cotangent[own + z];
                }
            });
            return self.gathered(&asked, depths);
        }
        let mut asked = vec![vec![T::zero(); n * n]; depths];
        for (place, cotangent) in cotangent.chunks_exact(n).enumerate() {
            for (node, j, weight) in self.entries(place, turn) {
                let to = &mut asked[node][j * n..][..n];
                for (to, &from) in to.iter_mut().zip(cotangent) {
                    *to = *to + weight * from;
                }
            }
        }
        asked
    }

    /// All voxel columns of a volume that has turned, those of the planes that each is made of, and their weights.
    fn rotate(&self, turn: (f64, f64), mut take: impl FnMut(usize, usize, T)) {
        let n = self.n;
        let middle = (n as f64 - 1.0) / 2.0;
        for place in 0..n * n {
            let at = [place % n, place / n].map(|i| i as f64 - middle);
            for (k, j, weight) in self.neighbors(at, turn) {
                take(place * n, (k * n + j) * n, Self::of(weight));
            }
        }
    }

    /// The spectrum of a pattern, where one is enough.
    fn spectrum(&self, x: &[T]) -> Option<Vec<Complex<T>>> {
        self.savings.one_transform.then(|| {
            let mut spectrum = self.padded(x);
            self.transform(&self.forward, &mut spectrum);
            spectrum
        })
    }

    /// |ψ|² at the depths that are computed.
    fn computed(&self, x: &[T], spectrum: Option<&[Complex<T>]>) -> Vec<Vec<T>> {
        let kernels = self.kernels().iter();
        kernels
            .map(|kernel| self.cropped(&self.field(x, spectrum, kernel), |v| v.norm_sqr()))
            .collect()
    }

    /// One frame's dose `[y][x][z]`.
    pub(super) fn dose(&self, x: &[T], azimuth: f64) -> Vec<T> {
        let light = self.computed(x, self.spectrum(x).as_deref());
        let mut dose = vec![T::zero(); self.n.pow(3)];
        self.add_dose(&light, azimuth.sin_cos(), &mut dose);
        dose
    }

    /// One frame's dose and pullback of a cotangent `[y][x][z]`; what they take in all, and what of it their turning, s.
    pub(super) fn gradient(&self, x: &[T], cotangent: &[T], azimuth: f64) -> [f64; 2] {
        let mut dose = vec![T::zero(); self.n.pow(3)];
        self.kernels();
        let begin = Instant::now();
        let turn = azimuth.sin_cos();
        let spectrum = self.spectrum(x);
        let light = self.computed(x, spectrum.as_deref());
        let lit = Instant::now();
        self.add_dose(&light, turn, &mut dose);
        let asked = self.ask(cotangent, light.len(), turn);
        let turning = lit.elapsed().as_secs_f64();
        let sum = self.pull_back(x, spectrum.as_deref(), &asked);
        std::hint::black_box((dose, self.cropped(&sum, |v| v.re)));
        [begin.elapsed().as_secs_f64(), turning]
    }

    /// What the light of the depths that are computed asks of the pixels.
    fn pull_back(
        &self,
        x: &[T],
        spectrum: Option<&[Complex<T>]>,
        asked: &[Vec<T>],
    ) -> Vec<Complex<T>> {
        let (n, first) = (self.n, (self.window - self.n) / 2);
        let mut sum = vec![Complex::new(T::zero(), T::zero()); self.window * self.window];
        for (kernel, asked) in self.kernels().iter().zip(asked) {
            let mut field = self.field(x, spectrum, kernel);
            let values = self.cropped(&field, |v| v);
            field.fill(Complex::new(T::zero(), T::zero()));
            for (i, (value, asked)) in values.iter().zip(asked).enumerate() {
                field[(first + i / n) * self.window + first + i % n] = value.scale(*asked);
            }
            self.transform(&self.forward, &mut field);
            for (v, h) in field.iter_mut().zip(kernel) {
                *v = *v * h.conj();
            }
            if !self.savings.one_transform {
                self.transform(&self.inverse, &mut field);
            }
            for (s, v) in sum.iter_mut().zip(&field) {
                *s = *s + *v;
            }
        }
        if self.savings.one_transform {
            self.transform(&self.inverse, &mut sum);
        }
        sum
    }
}

/// A Chebyshev node of the first kind from −1 to 1, and its barycentric weight.
fn chebyshev(count: usize, i: usize) -> (f64, f64) {
    let angle = PI * (2 * i + 1) as f64 / (2 * count) as f64;
    let sign = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
    (angle.cos(), sign * angle.sin())
}

/// Weights of the nodes at a place (Berrut & Trefethen, SIAM Review 46 (2004) 501, eq. 4.2).
fn barycentric(count: usize, place: f64) -> impl Iterator<Item = (usize, f64)> {
    let raw: Vec<f64> = (0..count)
        .map(|i| {
            let (node, weight) = chebyshev(count, i);
            let off = place - node;
            // On a node its weight outgrows all others
            weight / (off.abs().max(1e-12) * if off < 0.0 { -1.0 } else { 1.0 })
        })
        .collect();
    let sum: f64 = raw.iter().sum();
    raw.into_iter().map(move |weight| weight / sum).enumerate()
}
