//! What the wave model saves against the published algorithm, and what that costs in accuracy: the tables of `docs/wave.md`.
//!
//! `cargo run --release -p tomolith --example waves -- errors | times [N …] | frame N [edge, mm …] | work | limit`
//!
//! The *twin* is the published algorithm, plainly: a window of twice the pattern, every plane of voxels by its own transform, the square, a
//! bilinear rotation (Wechsler et al. 2024, Algorithms 2 and 3), in f64 or f32, one thread. `errors` compares |ψ|² of random patterns of single
//! pixels before rotation; `times` gives seconds per gradient (a dose and a pullback) for N³ voxels and one frame, `work` its Fourier operations at the article's size; `limit` compares waves with
//! rays while everything grows.
#![expect(clippy::print_stdout, reason = "a bench prints its tables")]

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftNum, FftPlanner};
use std::f64::consts::TAU;
use std::sync::Arc;
use std::time::Instant;
use tomolith::Error;
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::parallel::{Light, Parallel};
use tomolith::models::wave::{Params, Wave};
use tomolith::models::{DoseModel, Run};
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;

/// 1/λ in resin of index 1.5 at 405 nm, 1/mm.
const WAVENUMBER: f64 = 1.5 / 405e-6;

/// What of the published cost is left out.
#[derive(Clone, Copy)]
struct Savings {
    /// One transform of the pattern, and sums in Fourier space, instead of one for every plane.
    one_transform: bool,
    /// Planes behind the focus only.
    mirror: bool,
    /// Window over pattern.
    window: f64,
    /// Part of the band over which it fades.
    soft_edge: f64,
}

/// The published algorithm.
struct Twin<T: FftNum> {
    n: usize,
    window: usize,
    pitch: f64,
    savings: Savings,
    forward: Arc<dyn Fft<T>>,
    inverse: Arc<dyn Fft<T>>,
    /// H·W of every plane, as the published program keeps them; none where few planes are asked for.
    kernels: Vec<Vec<Complex<T>>>,
}

impl<T: FftNum> Twin<T> {
    fn new(n: usize, pitch: f64, savings: Savings) -> Self {
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
            kernels: Vec::new(),
        }
    }

    fn with_kernels(mut self) -> Self {
        self.kernels = (0..self.n).map(|k| self.kernel(self.depth(k))).collect();
        self
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
                let (sin, cos) = (TAU * depth * square.sqrt()).sin_cos();
                let size = fade(a) * fade(b);
                Complex::new(Self::of(size * cos), Self::of(size * sin))
            })
            .collect()
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
    fn intensity(&self, x: &[T], depth: f64) -> Vec<T> {
        let field = self.field(x, None, &self.kernel(depth));
        self.cropped(&field, |v| v.norm_sqr())
    }

    /// Depth of plane k.
    fn depth(&self, k: usize) -> f64 {
        (k as f64 - (self.n as f64 - 1.0) / 2.0) * self.pitch
    }

    /// Planes that are computed.
    fn planes(&self) -> std::ops::Range<usize> {
        (if self.savings.mirror { self.n / 2 } else { 0 })..self.n
    }

    /// The four neighbours of a voxel in the frame of the light, and their weights.
    fn neighbours(&self, place: usize, (sin, cos): (f64, f64)) -> [(usize, usize, T); 4] {
        let n = self.n;
        let middle = (n as f64 - 1.0) / 2.0;
        let (x, y) = ((place % n) as f64 - middle, (place / n) as f64 - middle);
        let (d, u) = (middle - (x * cos + y * sin), middle + y * cos - x * sin);
        let (k, j) = (d.floor(), u.floor());
        let (a, b) = (d - k, u - j);
        let inside = |i: f64| (0.0..n as f64).contains(&i);
        [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)].map(|(dk, dj)| {
            let weight = (dk * a + (1.0 - dk) * (1.0 - a)) * (dj * b + (1.0 - dj) * (1.0 - b));
            if inside(k + dk) && inside(j + dj) {
                ((k + dk) as usize, (j + dj) as usize, Self::of(weight))
            } else {
                (0, 0, T::zero())
            }
        })
    }

    /// One frame's dose and pullback of a cotangent `[y][x][z]`; what they take, s.
    fn gradient(&self, x: &[T], cotangent: &[T], azimuth: f64) -> f64 {
        let begin = Instant::now();
        let n = self.n;
        let turn = azimuth.sin_cos();
        let mut spectrum = self.padded(x);
        self.transform(&self.forward, &mut spectrum);
        let spectrum = self.savings.one_transform.then_some(spectrum.as_slice());
        let mut volume = vec![T::zero(); n * n * n];
        for k in self.planes() {
            let field = self.field(x, spectrum, &self.kernels[k]);
            let light = self.cropped(&field, |v| v.norm_sqr());
            if self.savings.mirror {
                volume[(n - 1 - k) * n * n..][..n * n].copy_from_slice(&light);
            }
            volume[k * n * n..][..n * n].copy_from_slice(&light);
        }
        let mut dose = vec![T::zero(); n * n * n];
        let mut asked = vec![T::zero(); n * n * n];
        for place in 0..n * n {
            for (k, j, weight) in self.neighbours(place, turn) {
                for z in 0..n {
                    let (at, own) = ((k * n + j) * n + z, place * n + z);
                    dose[own] = dose[own] + weight * volume[at];
                    asked[at] = asked[at] + weight * cotangent[own];
                }
            }
        }
        let mut sum = vec![Complex::new(T::zero(), T::zero()); self.window * self.window];
        for k in self.planes() {
            let mut field = self.field(x, spectrum, &self.kernels[k]);
            let mut asked_here = asked[k * n * n..][..n * n].to_vec();
            if self.savings.mirror {
                for (a, b) in asked_here.iter_mut().zip(&asked[(n - 1 - k) * n * n..]) {
                    *a = *a + *b;
                }
            }
            let values = self.cropped(&field, |v| v);
            field.fill(Complex::new(T::zero(), T::zero()));
            let first = (self.window - n) / 2;
            for (i, (value, asked)) in values.iter().zip(&asked_here).enumerate() {
                field[(first + i / n) * self.window + first + i % n] = value.scale(*asked);
            }
            self.transform(&self.forward, &mut field);
            for (v, h) in field.iter_mut().zip(&self.kernels[k]) {
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
        std::hint::black_box((dose, self.cropped(&sum, |v| v.re)));
        begin.elapsed().as_secs_f64()
    }
}

/// Random amplitudes of single pixels, 0 or 1: the worst case of the notes.
fn random_pixels(len: usize) -> Vec<f64> {
    tomolith::check::model::noise(11, len)
        .iter()
        .map(|&v| f64::from(u8::from(v > 0.0)))
        .collect()
}

/// One frame from azimuth 0 onto n² pixels, and n³ voxels whose slices are `off` voxels beside the planes of the twin.
fn single(n: usize, pitch: f64, params: &Params, off: f64) -> Result<Wave, Error> {
    let light = Light::new(
        PatternGrid::full_turn(1, 0.0, n, n, pitch),
        Resin::pure_radon(1.5),
    );
    let vial = IndexMatched {
        radius_mm: pitch * n as f64,
    };
    let grid = VolumeGrid {
        center_mm: [off * pitch, 0.0, 0.0],
        ..VolumeGrid::centered([n, n, n], pitch)
    };
    Wave::new(&vial, vec![light], params, grid)
}

/// |ψ|² `[x][u][z]` at some depths of n³ voxels, `off` voxels beside their planes.
fn light_of_twin(n: usize, pitch: f64, savings: Savings, x: &[f64], off: f64) -> Vec<Vec<f64>> {
    let twin = Twin::<f64>::new(n, pitch, savings);
    let planes = (0..n).step_by(5);
    planes
        .map(|k| twin.intensity(x, twin.depth(k) - off * pitch))
        .collect()
}

/// The same by the model: light from +x, so depth falls with x.
fn light_of_model(model: &Wave, n: usize, x: &[f64]) -> Result<Vec<Vec<f64>>, Error> {
    let mut field = model.new_patterns()?;
    let values: Vec<f32> = x.iter().map(|&v| v as f32).collect();
    field.copy_from_host(&values);
    let mut dose = model.new_dose()?;
    model.dose(&field, &mut dose, &Run::new())?;
    let layout = &model.outputs()[0];
    let at = |k: usize, i: usize| f64::from(dose.as_slice()[layout.index(i % n, i / n, n - 1 - k)]);
    let planes = (0..n).step_by(5);
    Ok(planes
        .map(|k| (0..n * n).map(|i| at(k, i)).collect())
        .collect())
}

/// Relative L2, and the largest difference over the largest value.
fn distance(a: &[Vec<f64>], b: &[Vec<f64>]) -> [f64; 2] {
    let (mut error, mut square, mut worst, mut most) = (0.0, 0.0, 0.0f64, 0.0f64);
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        error += (a - b).powi(2);
        square += b * b;
        worst = worst.max((a - b).abs());
        most = most.max(b.abs());
    }
    [(error / square).sqrt(), worst / most]
}

/// |ψ|² of patterns of random pixels before rotation: the published window, and the model, against a window eight times as wide.
fn errors() -> Result<(), Error> {
    let n = 64;
    let wide = Savings {
        one_transform: true,
        mirror: false,
        window: 8.0,
        soft_edge: 0.25,
    };
    let x = random_pixels(n * n);
    println!("| edge, mm | edge of the band | window 2N against 8N: L2 | largest |");
    println!("|---|---|---|---|");
    for edge in EDGES {
        for soft_edge in [0.0, 0.25] {
            let pitch = edge / 550.0;
            let of = |window: f64| Savings {
                window,
                soft_edge,
                ..wide
            };
            let light = |window: f64| light_of_twin(n, pitch, of(window), &x, 0.3);
            let [l2, largest] = distance(&light(2.0), &light(8.0));
            println!("| {edge} | {soft_edge} | {l2:.1e} | {largest:.1e} |");
        }
    }
    println!("\n| edge, mm | asked | on planes: L2 | largest | between: L2 | largest | sampling |");
    println!("|---|---|---|---|---|---|---|");
    for edge in EDGES {
        // The pixels of the article, N = 550, of which a corner
        let pitch = edge / 550.0;
        for asked in [1e-2, 1e-3, 1e-4] {
            let params = Params {
                relative_error: asked,
                rotation_error: 1e-5,
                ..Params::default()
            };
            let mut found = Vec::new();
            let mut described = String::new();
            for off in [0.0, 0.5] {
                let model = single(n, pitch, &params, off)?;
                described = sampling_of(&model);
                let light = light_of_model(&model, n, &x)?;
                found.push(distance(&light, &light_of_twin(n, pitch, wide, &x, off)));
            }
            let [on, between] = [found[0], found[1]];
            println!(
                "| {edge} | {asked:.0e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {} |",
                on[0], on[1], between[0], between[1], described
            );
        }
    }
    Ok(())
}

/// Edges of the article's volumes, mm.
const EDGES: [f64; 3] = [0.1, 1.0, 10.0];

/// Seconds per gradient of one frame, on one thread.
fn times(sizes: &[usize]) -> Result<(), Error> {
    println!(
        "| N | edge, mm | as the published code | one transform | mirror | window tight | all three | Tomolith | code/Tomolith |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let pool = one_thread()?;
    for &n in sizes {
        for edge in [0.1, 1.0, 10.0] {
            let pitch = edge / n as f64;
            // Sideways travel of the steepest component on the axis, over the pattern
            let slope = 0.5 / pitch / (WAVENUMBER.powi(2) - (0.5 / pitch).powi(2)).max(0.0).sqrt();
            let tight = (1.0 + 0.5 * slope).min(2.0);
            let plain = Savings {
                one_transform: false,
                mirror: false,
                window: 2.0,
                soft_edge: 0.0,
            };
            let x: Vec<f32> = random_pixels(n * n).iter().map(|&v| v as f32).collect();
            let cotangent = tomolith::check::model::noise(5, n * n * n);
            let time = |savings: Savings| {
                Twin::<f32>::new(n, pitch, savings)
                    .with_kernels()
                    .gradient(&x, &cotangent, 0.4)
            };
            let one = Savings {
                one_transform: true,
                ..plain
            };
            let all = Savings {
                one_transform: true,
                mirror: true,
                window: tight,
                ..plain
            };
            let twins = [
                time(plain),
                time(one),
                time(Savings {
                    mirror: true,
                    ..plain
                }),
                time(Savings {
                    window: tight,
                    ..plain
                }),
                time(all),
            ];
            let (ours, _) = pool.install(|| ours(n, pitch))?;
            let shown: Vec<String> = twins.iter().map(|s| format!("{s:.3}")).collect();
            println!(
                "| {n} | {edge} | {} | {ours:.4} | {:.0} |",
                shown.join(" | "),
                twins[0] / ours
            );
        }
    }
    Ok(())
}

/// Seconds per frame of the model's dose and pullback, of a few frames, and operations of its Fourier transforms.
fn ours(n: usize, pitch: f64) -> Result<(f64, Wave), Error> {
    let frames = if n > 300 { 4 } else { 8 };
    let light = Light::new(
        PatternGrid::full_turn(frames, 0.4, n, n, pitch),
        Resin::pure_radon(1.5),
    );
    let vial = IndexMatched {
        radius_mm: 0.5 * pitch * n as f64,
    };
    let grid = VolumeGrid::centered([n, n, n], pitch);
    let model = Wave::new(&vial, vec![light], &Params::default(), grid)?;
    let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
    x.fill(1.0);
    let mut gradient = x.zeros_like();
    let run = Run::new();
    let mut least = f64::INFINITY;
    for _ in 0..2 {
        let begin = Instant::now();
        model.dose(&x, &mut dose, &run)?;
        model.pullback(&x, &dose, &mut gradient, &run)?;
        least = least.min(begin.elapsed().as_secs_f64() / frames as f64);
    }
    Ok((least, model))
}

/// Seconds of a dose and a pullback of one frame of N² pixels onto N³ voxels, one thread.
fn frame(arguments: &[String]) -> Result<(), Error> {
    let pool = one_thread()?;
    let numbers: Vec<f64> = arguments.iter().filter_map(|a| a.parse().ok()).collect();
    let (n, edges) = numbers.split_first().unwrap_or((&64.0, &EDGES));
    let edges = if edges.is_empty() { &EDGES } else { edges };
    println!("| N | edge, mm | seconds | Fourier operations | sampling |");
    println!("|---|---|---|---|---|");
    for edge in edges {
        let pitch = edge / n;
        let (seconds, model) = pool.install(|| ours(*n as usize, pitch))?;
        let operations = model.operations() / model.patterns()[0].grid.frames() as f64;
        println!(
            "| {n} | {edge} | {seconds:.4} | {operations:.2e} | {} |",
            sampling_of(&model)
        );
    }
    Ok(())
}

fn one_thread() -> Result<rayon::ThreadPool, Error> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.map_err(|e| Error::config("threads", e.to_string(), "one thread"))
}

/// What stands between the first and the last bracket of a model's description.
fn sampling_of(model: &Wave) -> String {
    let described = model.describe();
    let begin = described.find('(').map_or(0, |i| i + 1);
    let end = described.rfind(')').unwrap_or(described.len());
    described[begin..end].to_owned()
}

/// Fourier work of one gradient at N = 550 and 600 frames, against the published code: 6N transforms of (2N)² a frame.
fn work() -> Result<(), Error> {
    println!("| edge, mm | NA | published code, operations | Tomolith | ratio | sampling |");
    println!("|---|---|---|---|---|---|");
    let (n, frames) = (550, 600.0);
    let m = 2.0 * n as f64;
    let published = frames * 6.0 * n as f64 * 5.0 * m * m * (m * m).log2();
    for (edge, aperture) in [(0.1, None), (0.1, Some(0.3)), (1.0, None), (10.0, None)] {
        let params = Params {
            numerical_aperture: aperture,
            ..Params::default()
        };
        let pitch = edge / n as f64;
        let light = Light::new(
            PatternGrid::full_turn(1, 0.0, n, n, pitch),
            Resin::pure_radon(1.5),
        );
        let vial = IndexMatched {
            radius_mm: 0.5 * edge,
        };
        let grid = VolumeGrid::centered([n, n, n], pitch);
        let model = Wave::new(&vial, vec![light], &params, grid)?;
        let ours = frames * model.operations();
        println!(
            "| {edge} | {} | {published:.2e} | {ours:.2e} | {:.1} | {} |",
            aperture.map_or("–".to_owned(), |na| na.to_string()),
            published / ours,
            sampling_of(&model)
        );
    }
    Ok(())
}

/// The same patterns by waves and by rays while everything grows.
fn limit() -> Result<(), Error> {
    println!(
        "| edge, mm | pixel, µm | dose of waves against rays, relative L2 | the same, blurred over three voxels |"
    );
    println!("|---|---|---|---|");
    let n = 64;
    for edge in [0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0] {
        let pitch = edge / n as f64;
        let light = Light::new(
            PatternGrid::full_turn(60, 0.1, n, n, pitch),
            Resin::pure_radon(1.5),
        );
        let vial = IndexMatched {
            radius_mm: 0.5 * edge,
        };
        let grid = VolumeGrid::centered([n, n, n], pitch);
        let rays = Parallel::new(&vial, vec![light.clone()], grid.clone())?;
        let waves = Wave::new(&vial, vec![light], &Params::default(), grid.clone())?;
        // Random blocks of four by four pixels, lit or dark
        let mut energies = DoseModel::new_patterns(&rays)?;
        let blocks = random_pixels(60 * n * n / 16);
        for (i, value) in energies.as_mut_slice().iter_mut().enumerate() {
            *value = blocks[i / (4 * n) * (n / 4) + i % n / 4] as f32;
        }
        let mut amplitudes = energies.clone();
        for value in amplitudes.as_mut_slice() {
            *value = value.sqrt();
        }
        let run = Run::new();
        let dose_of =
            |model: &dyn DoseModel<Field = HostField>, x: &HostField| -> Result<Vec<f32>, Error> {
                let mut dose = model.new_dose()?;
                model.dose(x, &mut dose, &run)?;
                Ok(model.outputs()[0].volume_of(dose.as_slice()).values)
            };
        let (a, b) = (dose_of(&waves, &amplitudes)?, dose_of(&rays, &energies)?);
        println!(
            "| {edge} | {:.2} | {:.4} | {:.4} |",
            1e3 * pitch,
            difference(&a, &b),
            difference(&blurred(&a, n), &blurred(&b, n))
        );
    }
    Ok(())
}

fn difference(a: &[f32], b: &[f32]) -> f64 {
    let sum = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        a.iter()
            .zip(b)
            .map(|(&a, &b)| f(f64::from(a), f64::from(b)))
            .sum()
    };
    (sum(&|a, b| (a - b).powi(2)) / sum(&|_, b| b * b)).sqrt()
}

/// Means over 3 × 3 × 3 voxels, those at the faces left as they are.
fn blurred(values: &[f32], n: usize) -> Vec<f32> {
    let mut values = values.to_vec();
    for stride in [1, n, n * n] {
        let before = values.clone();
        for i in stride..values.len() - stride {
            values[i] = (before[i - stride] + before[i] + before[i + stride]) / 3.0;
        }
    }
    values
}

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let what = arguments.first().map_or("errors", String::as_str);
    let sizes: Vec<usize> = arguments
        .iter()
        .skip(1)
        .filter_map(|a| a.parse().ok())
        .collect();
    match what {
        "times" if sizes.is_empty() => times(&[64, 128]),
        "times" => times(&sizes),
        "frame" => frame(&arguments[1..]),
        "limit" => limit(),
        "work" => work(),
        _ => errors(),
    }
}
