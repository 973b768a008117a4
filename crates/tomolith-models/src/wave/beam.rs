//! How light spreads behind a plane of pixels, as far as its sampling must know.
//!
//! # Equations
//! Lateral frequencies f lie within the pixels' Nyquist limit and, with a numerical aperture, within NA/λ₀. The band fades toward its end ([`fade`]):
//! with a hard end every pixel is ringed without end, and |ψ|² depends on the window, by 4 % in one of twice the pattern (docs/validation.md). Along the depth a
//! component runs with w = √(λ⁻² − f²), and sideways by f/w.

use super::taps::Signal;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// Wavelength and aperture in the resin, and the pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Beam {
    /// 1/λ in the resin, 1/mm.
    pub(super) wavenumber: f64,
    /// NA/λ₀, 1/mm; None: all that the pixels can make.
    pub(super) aperture: Option<f64>,
    /// Frequency of the widest mode, 1/mm.
    pub(super) tilt: f64,
    /// Part of the band over which it fades.
    pub(super) soft_edge: f64,
    /// Largest frequency of the pixels along u and z, 1/mm.
    pub(super) nyquist: [f64; 2],
}

/// What a sampling must know of light.
pub(super) trait Spreading {
    /// Lateral frequency along u or z from which on nothing passes: at most twice that of the pixels.
    fn highest(&self, side: usize) -> f64;
    /// Sideways travel over depth along u or z, and the share of the power that does so.
    fn slopes(&self, side: usize) -> Vec<(f64, f64)>;
    /// Largest frequency of light along the depth.
    fn depth_band(&self) -> f64;
    /// How light changes along the depth.
    fn along(&self) -> Signal;
    /// How its field does, turned back by a frequency along the depth; None unless ψ(−x) is the conjugate of ψ(x).
    fn field(&self, middle: f64) -> Option<Signal>;
    /// How it changes along u.
    fn across(&self) -> Signal;
    /// How far to one side light of frequencies along this side alone spreads by a depth, mm.
    fn spreads(&self, side: usize, depth: f64) -> f64;
    /// How far around a pixel its light rings along u or z, mm.
    fn rings(&self, side: usize) -> f64;
}

/// What passes of a frequency at a share of its limit: all, then less as cos² over `soft_edge`, nothing from the limit on.
pub(super) fn fade(soft_edge: f64, share: f64) -> f64 {
    if share >= 1.0 - 1e-9 {
        0.0
    } else if share <= 1.0 - soft_edge {
        1.0
    } else {
        let along = (share - 1.0 + soft_edge) / soft_edge;
        (0.5 * PI * along).cos().powi(2)
    }
}

/// Frequencies from −1 to 1 that a band is summed over along each side.
pub(super) fn over_the_band() -> impl Iterator<Item = f64> + Clone {
    const HALF: i32 = 64;
    (-HALF..HALF).map(|i| (f64::from(i) + 0.5) / f64::from(HALF))
}

impl Beam {
    /// What passes of a frequency of the pattern in a mode: the pixels limit its own, the lens that of the mode as well.
    pub(super) fn passes(&self, f: [f64; 2], mode: [f64; 2]) -> f64 {
        let across = (f[0] + mode[0]).hypot(f[1] + mode[1]);
        let by_lens =
            (self.aperture).map_or(1.0, |aperture| fade(self.soft_edge, across / aperture));
        let by_pixels = [0, 1].map(|i| fade(self.soft_edge, f[i].abs() / self.nyquist[i]));
        by_lens * by_pixels[0] * by_pixels[1]
    }

    /// Frequencies of the pattern and the power that passes of each, in the widest mode, as parts of white noise of power 1.
    fn power(&self) -> impl Iterator<Item = ([f64; 2], f64)> + Clone {
        let mode = self.widest_mode();
        // A small aperture leaves little of the pixels' band
        let range = [0, 1].map(|side| self.highest(side));
        let area = range[0] * range[1] / (self.nyquist[0] * self.nyquist[1]);
        let share = area / over_the_band().count().pow(2) as f64;
        over_the_band().flat_map(move |z| {
            over_the_band().map(move |u| {
                let f = [u * range[0], z * range[1]];
                (f, self.passes(f, mode).powi(2) * share)
            })
        })
    }

    fn widest_mode(&self) -> [f64; 2] {
        [self.tilt * FRAC_1_SQRT_2; 2]
    }

    /// 1/λ − w of a frequency that travels, without the difference of large numbers.
    fn lag(&self, f: [f64; 2]) -> f64 {
        let square = (f[0] * f[0] + f[1] * f[1]).min(self.wavenumber.powi(2));
        square / (self.wavenumber + (self.wavenumber.powi(2) - square).sqrt())
    }
}

impl Spreading for Beam {
    fn highest(&self, side: usize) -> f64 {
        let nyquist = self.nyquist[side];
        self.aperture
            .map_or(nyquist, |na| nyquist.min(na + self.tilt))
    }

    /// Of f_side/w; what does not travel arrives nowhere.
    fn slopes(&self, side: usize) -> Vec<(f64, f64)> {
        let mode = self.widest_mode();
        let traveling = self.power().filter_map(|(f, power)| {
            let f = [f[0] + mode[0], f[1] + mode[1]];
            let square = self.wavenumber.powi(2) - f[0] * f[0] - f[1] * f[1];
            (square > 0.0 && power > 0.0).then(|| (f[side].abs() / square.sqrt(), power))
        });
        let mut slopes: Vec<(f64, f64)> = traveling.collect();
        let all: f64 = slopes.iter().map(|slope| slope.1).sum();
        for slope in &mut slopes {
            slope.1 /= all;
        }
        slopes
    }

    fn depth_band(&self) -> f64 {
        let corner = [0, 1].map(|side| self.highest(side) + self.tilt);
        let most = corner[0].hypot(corner[1]);
        self.lag([
            self.aperture.map_or(most, |aperture| most.min(aperture)),
            0.0,
        ])
    }

    /// Phases run with w − 1/λ, those of the mean with that of its mode.
    fn along(&self) -> Signal {
        let mode = self.widest_mode();
        let lag = move |f: [f64; 2]| self.lag([f[0] + mode[0], f[1] + mode[1]]);
        let mean = lag([0.0; 2]);
        Signal::of_square(self.power().map(|(f, power)| (lag(f) - mean, power)))
    }

    /// Patterns are smooth more often than not, and their light lies at the very end of the band, where interpolation errs most.
    fn field(&self, middle: f64) -> Option<Signal> {
        const SMOOTH: f64 = 0.125;
        const WEIGHT: f64 = 100.0;
        let lines = |share: f64, weight: f64| {
            let line = move |(f, power): ([f64; 2], f64)| {
                (self.lag(f.map(|f| f * share)) - middle, weight * power)
            };
            self.power().map(line)
        };
        let (all, smooth) = (lines(1.0, 1.0), lines(SMOOTH, WEIGHT));
        (self.tilt == 0.0).then(|| Signal::of_field(all, smooth))
    }

    fn across(&self) -> Signal {
        Signal::of_square(self.power().map(|(f, power)| (f[0], power)))
    }

    /// The end of the band casts a shadow whose edge is two √(λ·depth) wide.
    fn spreads(&self, side: usize, depth: f64) -> f64 {
        let highest = self.highest(side) + self.tilt;
        let highest = self
            .aperture
            .map_or(highest, |aperture| highest.min(aperture));
        let slope = highest
            / (self.wavenumber.powi(2) - highest * highest)
                .max(0.0)
                .sqrt();
        depth * slope + 2.0 * (depth / self.wavenumber).sqrt()
    }

    /// A soft edge of the band ends them; those of a hard one never end.
    fn rings(&self, side: usize) -> f64 {
        let pixels = if self.soft_edge > 0.0 {
            4.0 / self.soft_edge
        } else {
            2.0
        };
        // Half a period of the highest frequency: a pixel, or the spot of the lens
        let narrowest = self
            .aperture
            .unwrap_or(f64::INFINITY)
            .min(self.nyquist[side]);
        pixels * 0.5 / narrowest
    }
}
