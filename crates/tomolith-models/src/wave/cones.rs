//! Incoherent light that fills a cone and is focused in a plane: the linear counterpart of waves.
//!
//! # Equation
//! Light of a pixel fills the directions within θ of the axis evenly; at depth x behind the focal plane it lies on a disc of radius x·tan θ:
//! ```text
//! I(x) = F⁻¹[ T(f, x)·B(f)·F[E] ],     T = 2·J₁(ρ)/ρ,   ρ = 2π·|f|·|x|·tan θ,     B = b(f_u p)·b(f_z p),   b(s) = sinc(s)·cos²(πs/2)
//! ```
//! T is the transform of the disc, B that of a square pixel, faded up to where it is 0 for the first time, f = 1/p: twice the highest frequency of
//! patterns, whose transforms repeat. An edge overshoots by 0.6 %; cut at half that frequency it would by 9 %.
//!
//! # Source
//! T: the Fourier transform of a uniform disc, any text on optics (Goodman, *Introduction to Fourier Optics*, eq. 2-35); J₁: Bessel's integral.

use super::beam::{Spreading, fade, over_the_band};
use super::coherent::alone;
use super::light::{Propagation, SpreadingForm};
use super::lights::ModelPropagation;
use super::number::Number;
use super::spectrum::{Scratch, Windows, zero};
use super::taps::Signal;
use std::f64::consts::{PI, TAU};
use tomolith_core::dose::waves::{Transfer, WaveMode};
use tomolith_fourier::Complex;

/// Directions of the light of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cone {
    /// tan θ in resin.
    pub(super) slope: f64,
    /// Distance of pixels along u and z, mm.
    pub(super) pitch: [f64; 2],
}

impl Cone {
    /// B of a frequency.
    fn of_pixel(&self, f: [f64; 2]) -> f64 {
        let side = |i: usize| {
            let share = f[i] * self.pitch[i];
            let x = PI * share;
            let sinc = if x == 0.0 { 1.0 } else { x.sin() / x };
            sinc * fade(1.0, share.abs())
        };
        side(0) * side(1)
    }

    fn frequencies(&self) -> impl Iterator<Item = [f64; 2]> + Clone {
        let [u_most, z_most] = self.pitch.map(f64::recip);
        over_the_band().flat_map(move |z| over_the_band().map(move |u| [u * u_most, z * z_most]))
    }
}

impl Spreading for Cone {
    fn highest(&self, side: usize) -> f64 {
        self.pitch[side].recip()
    }

    fn slopes(&self, _side: usize) -> Vec<(f64, f64)> {
        vec![(self.slope, 1.0)]
    }

    fn depth_band(&self) -> f64 {
        self.slope * self.highest(0).hypot(self.highest(1))
    }

    /// A ray of slope s changes with f·s along the depth; a disc of slopes seen from its side is a half circle.
    fn along(&self) -> Signal {
        const SLOPES: i32 = 15;
        let lines = self.frequencies().flat_map(|f| {
            (0..SLOPES).map(move |i| {
                let share = (2.0 * f64::from(i) + 1.0) / f64::from(SLOPES) - 1.0;
                let weight = (1.0 - share * share).sqrt() * self.of_pixel(f).powi(2);
                (f[0].hypot(f[1]) * self.slope * share, weight)
            })
        });
        Signal::of_light(lines)
    }

    fn field(&self, _middle: f64) -> Option<Signal> {
        None
    }

    fn across(&self) -> Signal {
        let lines = self.frequencies().map(|f| (f[0], self.of_pixel(f).powi(2)));
        Signal::of_light(lines)
    }

    fn spreads(&self, _side: usize, depth: f64) -> f64 {
        self.slope * depth
    }

    fn rings(&self, side: usize) -> f64 {
        6.0 * self.pitch[side]
    }
}

/// J₁(ρ), by Bessel's integral (1/π)∫cos(t − ρ sin t)dt: the trapezoidal rule converges faster than any power for periodic
/// functions once its steps outnumber ρ.
fn bessel_1(rho: f64) -> f64 {
    let steps = 32 + 2 * rho.ceil() as usize;
    let at = |i: usize| {
        let t = TAU * i as f64 / steps as f64;
        (t - rho * t.sin()).cos()
    };
    (0..steps).map(at).sum::<f64>() / steps as f64
}

/// The transform of a disc of radius 1 and weight 1.
fn disc(rho: f64) -> f64 {
    if rho < 1e-4 {
        1.0 - rho * rho / 8.0
    } else {
        2.0 * bessel_1(rho) / rho
    }
}

/// [`disc`] in a table.
struct Disc(Vec<f64>);

impl Disc {
    /// Rows a unit of ρ: linear between them, right to 1/64²/8/4 = 8·10⁻⁶.
    const ROWS: f64 = 64.0;

    fn up_to(rho: f64) -> Self {
        let rows = (rho * Self::ROWS).ceil() as usize + 2;
        Disc((0..rows).map(|i| disc(i as f64 / Self::ROWS)).collect())
    }

    fn at(&self, rho: f64) -> f64 {
        let place = rho * Self::ROWS;
        let below = place as usize;
        let share = place - below as f64;
        self.0[below] + share * (self.0[below + 1] - self.0[below])
    }
}

pub(super) struct Cones<T: Number> {
    windows: Windows<T>,
    /// T·B of each depth.
    transfers: Vec<Vec<T>>,
}

impl<T: Number> Cones<T> {
    pub(super) fn new(windows: Windows<T>, cone: &Cone) -> Self {
        let sampling = &windows.sampling;
        let [bu, bz] = sampling.band.map(|b| b as i64);
        let depths = sampling.along.computed;
        let radius = |depth: usize| depths.at(depth) * cone.slope;
        let highest = cone.highest(0).hypot(cone.highest(1));
        let disc = Disc::up_to(TAU * highest * radius(depths.count));
        let transfer = |depth: usize| {
            let radius = radius(depth);
            let mut values = Vec::with_capacity(((2 * bu + 1) * (2 * bz + 1)) as usize);
            for fz in -bz..=bz {
                for fu in -bu..=bu {
                    let f = [fu as f64 / windows.window[0], fz as f64 / windows.window[1]];
                    let spread = disc.at(TAU * f[0].hypot(f[1]) * radius);
                    values.push(T::of(cone.of_pixel(f) * spread));
                }
            }
            values
        };
        Cones {
            transfers: (0..depths.count).map(transfer).collect(),
            windows,
        }
    }
}

impl ModelPropagation for Cones<f32> {
    const MODEL: &'static str = super::incoherent_cone::KIND.name;

    fn modes(&self) -> usize {
        1
    }

    fn form(&self) -> Option<SpreadingForm> {
        let mode = WaveMode {
            weight: 1.0,
            transfer: Transfer::Each(self.transfers.clone()),
        };
        Some((
            vec![mode],
            alone(self.windows.sampling.along.computed.count),
        ))
    }
}

impl<T: Number> Propagation<T> for Cones<T> {
    const IS_LINEAR: bool = true;

    fn windows(&self) -> &Windows<T> {
        &self.windows
    }

    fn shine(&self, scratch: &mut Scratch<T>, samples: &mut [T], row: usize) {
        for (depth, transfer) in self.transfers.iter().enumerate() {
            let Scratch { spectrum, here, .. } = &mut *scratch;
            for ((v, s), &t) in here.iter_mut().zip(spectrum).zip(transfer) {
                *v = s.scale(t);
            }
            let (here, parts) = scratch.split();
            self.windows.field(here, parts);
            let field = &scratch.field;
            let value = |i: usize| field[i].re;
            self.windows.add_at(depth, samples, row, T::one(), value);
        }
    }

    fn send_back(
        &self,
        samples: &[T],
        row: usize,
        scratch: &mut Scratch<T>,
        take: &mut dyn FnMut(usize, &[Complex<T>]),
    ) {
        let len = scratch.spectrum.len();
        scratch.sum.clear();
        scratch.sum.resize(len, zero());
        let mut back = vec![zero(); len];
        for (depth, transfer) in self.transfers.iter().enumerate() {
            scratch.field.fill(Complex::new(T::one(), T::zero()));
            self.windows
                .multiply_by(depth, samples, row, T::one(), &mut scratch.field);
            self.windows.field_back(&mut back, scratch.split().1);
            for ((sum, b), &t) in scratch.sum.iter_mut().zip(&back).zip(transfer) {
                *sum = *sum + b.scale(t);
            }
        }
        self.windows.transform_back(scratch, take);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bessel_and_disc_have_their_known_values() {
        // Abramowitz & Stegun, table 9.1; first zero 3.831706
        for (x, value) in [
            (1.0, 0.440_050_585_7),
            (5.0, -0.327_579_137_6),
            (20.0, 0.066_833_124_2),
        ] {
            assert!((bessel_1(x) - value).abs() < 1e-9);
        }
        assert!(disc(3.831_705_970_2).abs() < 1e-9);
        assert!((disc(1e-4) - disc(1.1e-4)).abs() < 1e-8);
        let table = Disc::up_to(30.0);
        for i in 0..3000 {
            let rho = f64::from(i) * 0.01;
            assert!((table.at(rho) - disc(rho)).abs() < 8e-6, "{rho}");
        }
    }
}
