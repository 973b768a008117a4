//! How finely the wave of a light is sampled: window, depths, lateral samples.
//!
//! # Equations
//! Lateral frequencies f lie within the pixels' Nyquist limit and, with a numerical aperture, within NA/λ₀. A component travels
//! sideways by |x|·f/w at depth x, w = √(λ⁻² − f²). A window of length P repeats what lies in it, so nothing that comes back
//! from its far side reaches the voxels as long as
//! ```text
//! P ≥ D + g,        D = largest distance of a voxel from a pixel, sideways,        g = max |x|·f/w        (at most D)
//! ```
//! and what would travel further than P − D is deleted: for P = 2D this is the limit of Matsushima & Shimobaba, eq. 13 and 20 to 22.
//! The band fades towards its end ([`fade`]): with a hard end every pixel is ringed without end, and |ψ|² depends on the window, by 4 % in one of
//! 2D (docs/wave.md). Along the depth |ψ|² has frequencies up to ΔF = w_max − w_min, sideways up to twice those of the field; distances of the samples follow from
//! the [`Taps`] that interpolate them.
//!
//! # Source
//! Matsushima & Shimobaba, Opt. Express 17 (2009) 19662; the bound of the depth's frequencies: docs/wave.md.

use super::Settings;
use super::taps::Taps;
use std::f64::consts::PI;

/// One side of the window: u, or z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Side {
    /// Distance of pixels, mm.
    pub(super) pitch: f64,
    /// Number of pixels.
    pub(super) pixels: usize,
    /// First pixel, mm.
    pub(super) from: f64,
    /// Lowest and highest voxel, mm.
    pub(super) voxels: [f64; 2],
}

impl Side {
    /// The largest distance of a voxel from a pixel.
    fn reach(&self) -> f64 {
        let last = self.from + self.pitch * (self.pixels as f64 - 1.0);
        (last - self.voxels[0]).max(self.voxels[1] - self.from)
    }

    /// What pixels and voxels span together.
    fn span(&self) -> f64 {
        let last = self.from + self.pitch * (self.pixels as f64 - 1.0);
        last.max(self.voxels[1]) - self.from.min(self.voxels[0])
    }
}

/// Depths and window of one light; lengths in mm.
#[derive(Clone, Debug)]
pub(super) struct Sampling {
    /// Pixels along u and z, those of the guard included.
    pub(super) padded: [usize; 2],
    /// How far a component may travel sideways before it is deleted.
    pub(super) guard: [f64; 2],
    /// Highest frequency kept, in cycles per window: the indices run from −band to band.
    pub(super) band: [usize; 2],
    /// Distance of the depths.
    pub(super) step: f64,
    /// Number of depths: 0, step, 2·step …, each standing for both sides of the focal plane.
    pub(super) depths: usize,
    /// Interpolation between depths.
    pub(super) along: Taps,
    /// Samples of the window along u.
    pub(super) fine: usize,
    /// Interpolation between them.
    pub(super) across: Taps,
}

/// Wavelength and aperture in the resin.
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
}

/// What a sampling must know of light.
pub(super) trait Spreading {
    /// Largest lateral frequency along one side, for pixels of this distance.
    fn highest(&self, pitch: f64) -> f64;
    /// Largest sideways travel over depth, for these largest frequencies along a side and across it.
    fn steepest(&self, highest: [f64; 2]) -> f64;
    /// Largest frequency of the light along the depth.
    fn depth_band(&self, highest: [f64; 2]) -> f64;
    /// Largest lateral frequency of the light, over that of the field: 2 for squares, 1 for the light itself.
    fn powers(&self) -> f64;
    /// Part of the band over which it fades.
    fn soft_edge(&self) -> f64;
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

impl Spreading for Beam {
    fn highest(&self, pitch: f64) -> f64 {
        let nyquist = 0.5 / pitch;
        self.aperture
            .map_or(nyquist, |na| nyquist.min(na + self.tilt))
    }

    /// Of f_side/w, ∞ where some components do not travel.
    fn steepest(&self, [own, other]: [f64; 2]) -> f64 {
        let (mut side, mut square) = (
            own + self.tilt,
            (own + self.tilt).powi(2) + (other + self.tilt).powi(2),
        );
        if let Some(aperture) = self.aperture {
            side = side.min(aperture);
            square = square.min(aperture.powi(2));
        }
        let w = self.wavenumber.powi(2) - square;
        if w > 0.0 {
            side / w.sqrt()
        } else {
            f64::INFINITY
        }
    }

    /// w_max − w_min
    fn depth_band(&self, highest: [f64; 2]) -> f64 {
        let mut square: f64 = highest.iter().map(|f| (f + self.tilt).powi(2)).sum();
        if let Some(aperture) = self.aperture {
            square = square.min(aperture.powi(2));
        }
        let w = (self.wavenumber.powi(2) - square).max(0.0).sqrt();
        // As 1/λ − w, without the difference of large numbers
        square.min(self.wavenumber.powi(2)) / (self.wavenumber + w)
    }

    fn powers(&self) -> f64 {
        2.0
    }

    fn soft_edge(&self) -> f64 {
        self.soft_edge
    }
}

/// Numbers of taps that are tried.
const TAPS: [usize; 4] = [4, 6, 8, 10];

impl Sampling {
    /// The cheapest sampling with the errors that the settings allow; `deepest`: largest distance of a voxel from the focal plane.
    pub(super) fn new(
        beam: &dyn Spreading,
        [u, z]: [&Side; 2],
        deepest: f64,
        settings: &Settings,
    ) -> Self {
        let highest = [beam.highest(u.pitch), beam.highest(z.pitch)];
        let side = |own: &Side, frequencies: [f64; 2]| {
            let reach = own.reach();
            let travel = deepest * beam.steepest(frequencies);
            // A soft edge of the band ends the rings around what a pixel lights after some pixels; those of a hard one never end
            let rings = if beam.soft_edge() > 0.0 {
                3.0 / beam.soft_edge()
            } else {
                2.0
            };
            let needed = own.span().max(reach + travel.min(reach)) / own.pitch;
            smooth_even((needed + rings).ceil() as usize)
        };
        let padded = [side(u, highest), side(z, [highest[1], highest[0]])];
        let guard = [
            padded[0] as f64 * u.pitch - u.reach(),
            padded[1] as f64 * z.pitch - z.reach(),
        ];
        let band = |i: usize, pitch: f64| {
            let most = (padded[i] - 1) / 2;
            ((highest[i] * padded[i] as f64 * pitch) as usize).clamp(1, most)
        };
        let band = [band(0, u.pitch), band(1, z.pitch)];
        let depth_band = beam.depth_band(highest);
        let (mut best, mut least) = (None, f64::INFINITY);
        for taps in TAPS {
            let widest = Taps::widest_band(taps, settings.relative_error);
            let step = (widest / depth_band).min(deepest.max(u.pitch));
            let depths = (deepest / step).ceil() as usize + taps / 2;
            // A depth costs about as much as twenty taps of all voxels of a frame
            let cost = depths as f64 + 0.05 * (taps * settings.lateral_taps) as f64 * 4.0;
            if cost < least {
                (best, least) = (Some((taps, step, depths)), cost);
            }
        }
        let (taps, step, depths) = best.unwrap_or((4, deepest, 3));
        let along = Taps::new(taps, depth_band * step);
        let taps = settings.lateral_taps;
        let widest = Taps::widest_band(taps, settings.rotation_error);
        let frequencies = beam.powers() * band[0] as f64;
        let fine = smooth_even((frequencies / widest).ceil() as usize);
        let fine = fine.max(smooth_even(2 * band[0] + 2));
        let across = Taps::new(taps, frequencies / fine as f64);
        Sampling {
            padded,
            guard,
            band,
            step,
            depths,
            along,
            fine,
            across,
        }
    }
}

/// The smallest even number ≥ n without prime factors above 7.
fn smooth_even(n: usize) -> usize {
    let smooth = |&m: &usize| {
        let mut rest = m;
        for p in [2, 3, 5, 7] {
            while rest.is_multiple_of(p) {
                rest /= p;
            }
        }
        rest == 1
    };
    (n.max(2).next_multiple_of(2)..)
        .step_by(2)
        .find(smooth)
        .unwrap_or(n)
}
