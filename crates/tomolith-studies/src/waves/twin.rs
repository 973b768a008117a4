//! The published algorithm for light before it turns, plainly.
//!
//! Wechsler et al. 2024, Algorithm 2: a window around the pattern, every plane of voxels by a transform, the square. In f64, one thread.

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::f64::consts::TAU;
use std::sync::Arc;

/// 1/λ in resin of index 1.5 at 405 nm, 1/mm.
pub(super) const WAVENUMBER: f64 = 1.5 / 405e-6;

/// Light of n² pixels.
pub(super) struct Twin {
    pub(super) n: usize,
    window: usize,
    pub(super) pitch: f64,
    /// Part of the band over which it fades.
    soft_edge: f64,
    forward: Arc<dyn Fft<f64>>,
    inverse: Arc<dyn Fft<f64>>,
}

impl Twin {
    /// Of a window as many times as wide as the pattern (published: 2), and a band that fades over a part of it (published: 0).
    pub(super) fn new(n: usize, pitch: f64, window: f64, soft_edge: f64) -> Self {
        let smooth = |m: &usize| {
            let mut rest = *m;
            for p in [2, 3, 5, 7] {
                while rest.is_multiple_of(p) {
                    rest /= p;
                }
            }
            rest == 1
        };
        let least = (window * n as f64).ceil() as usize;
        let window = (least..).find(|m| m % 2 == 0 && smooth(m)).unwrap_or(2 * n);
        let mut plans = FftPlanner::new();
        Twin {
            n,
            window,
            pitch,
            soft_edge,
            forward: plans.plan_fft_forward(window),
            inverse: plans.plan_fft_inverse(window),
        }
    }

    /// A transform of a whole window.
    fn transform(&self, plan: &Arc<dyn Fft<f64>>, field: &mut [Complex<f64>]) {
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
    fn kernel(&self, depth: f64) -> Vec<Complex<f64>> {
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
                    return Complex::new(0.0, 0.0);
                }
                let edge = self.soft_edge.max(1e-9);
                let fade = |f: f64| {
                    let along = (2.0 * self.pitch * f.abs() - 1.0 + edge) / edge;
                    (0.25 * TAU * along.clamp(0.0, 1.0)).cos().powi(2)
                };
                Complex::from_polar(
                    fade(a) * fade(b),
                    TAU * depth * (square.sqrt() - WAVENUMBER),
                )
            })
            .collect()
    }

    /// |ψ|² `[u][z]` of a pattern `[u][z]` at a depth.
    pub(super) fn intensity(&self, x: &[f64], depth: f64) -> Vec<f64> {
        let (n, m) = (self.n, self.window);
        let first = (m - n) / 2;
        let place = |i: usize| (first + i / n) * m + first + i % n;
        let mut field = vec![Complex::new(0.0, 0.0); m * m];
        for (i, &value) in x.iter().enumerate() {
            field[place(i)].re = value;
        }
        self.transform(&self.forward, &mut field);
        let scale = 1.0 / (m * m) as f64;
        for (v, h) in field.iter_mut().zip(self.kernel(depth)) {
            *v = *v * h * scale;
        }
        self.transform(&self.inverse, &mut field);
        (0..n * n).map(|i| field[place(i)].norm_sqr()).collect()
    }

    pub(super) fn depth(&self, k: usize) -> f64 {
        (k as f64 - (self.n as f64 - 1.0) / 2.0) * self.pitch
    }
}
