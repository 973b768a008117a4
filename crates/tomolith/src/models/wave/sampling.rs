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
//! 2D (docs/wave.md). Distances of samples along and across the light follow from the [`Taps`] that interpolate them, for light that fills the band
//! evenly: the fewest that keep to the errors asked for. Where that saves time, closer samples are interpolated from those that are computed, and
//! voxels from few of them. The depths lie at (k + ½) steps, their mirror images on the other side of the focal plane.
//!
//! # Source
//! Matsushima & Shimobaba, Opt. Express 17 (2009) 19662.

use super::Settings;
use super::taps::{OVERHANG, Signal, Taps};
use crate::units::concise;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

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
    /// Depths on one side of the focal plane, at (k + ½) steps; each stands for its mirror image, too.
    pub(super) along: Ladder,
    /// Samples of the window along u.
    pub(super) across: Ladder,
}

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
    /// Largest sideways travel over depth along u or z.
    fn steepest(&self, side: usize) -> f64;
    /// How light changes along the depth.
    fn along(&self) -> Signal;
    /// How it changes along u.
    fn across(&self) -> Signal;
    /// Largest sideways travel over depth of frequencies along this side alone.
    fn straightest(&self, side: usize) -> f64;
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
        let count = over_the_band().count().pow(2) as f64;
        over_the_band().flat_map(move |z| {
            over_the_band().map(move |u| {
                let f = [u * self.nyquist[0], z * self.nyquist[1]];
                (f, self.passes(f, mode).powi(2) / count)
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

    /// Largest frequency of light along the depth.
    pub(super) fn depth_band(&self) -> f64 {
        let corner = [0, 1].map(|side| self.highest(side) + self.tilt);
        let most = corner[0].hypot(corner[1]);
        self.lag([
            self.aperture.map_or(most, |aperture| most.min(aperture)),
            0.0,
        ])
    }
}

impl Spreading for Beam {
    fn highest(&self, side: usize) -> f64 {
        let nyquist = self.nyquist[side];
        self.aperture
            .map_or(nyquist, |na| nyquist.min(na + self.tilt))
    }

    /// Of f_side/w, ∞ where some components do not travel.
    fn steepest(&self, side: usize) -> f64 {
        let [own, other] = [side, 1 - side].map(|side| self.highest(side) + self.tilt);
        let (mut along, mut square) = (own, own * own + other * other);
        if let Some(aperture) = self.aperture {
            along = along.min(aperture);
            square = square.min(aperture.powi(2));
        }
        let w = self.wavenumber.powi(2) - square;
        if w > 0.0 {
            along / w.sqrt()
        } else {
            f64::INFINITY
        }
    }

    /// Phases run with w − 1/λ, those of the mean with that of its mode.
    fn along(&self) -> Signal {
        let mode = self.widest_mode();
        let lag = move |f: [f64; 2]| self.lag([f[0] + mode[0], f[1] + mode[1]]);
        let mean = lag([0.0; 2]);
        Signal::of_square(self.power().map(|(f, power)| (lag(f) - mean, power)))
    }

    fn across(&self) -> Signal {
        Signal::of_square(self.power().map(|(f, power)| (f[0], power)))
    }

    fn straightest(&self, side: usize) -> f64 {
        let own = self.highest(side) + self.tilt;
        let own = self.aperture.map_or(own, |aperture| own.min(aperture));
        own / (self.wavenumber.powi(2) - own * own).max(0.0).sqrt()
    }

    /// A soft edge of the band ends them; those of a hard one never end.
    fn rings(&self, side: usize) -> f64 {
        let pixels = if self.soft_edge > 0.0 {
            3.0 / self.soft_edge
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

/// Numbers of taps that are tried: from what is transformed, and from what was interpolated to lie closer.
const TAPS: [usize; 4] = [4, 6, 8, 10];
const CLOSE_TAPS: [usize; 3] = [2, 4, 6];

/// Time of a multiplication and addition of rows over that of an operation of a Fourier transform: 5.5 to 6.5 and 7·10⁹ of them a second and
/// core were measured, of 550 voxels a row.
const ROW_COST: f64 = 1.2;

/// Samples that light is computed at, and those that voxels are interpolated from.
#[derive(Clone, Debug)]
pub(super) struct Ladder {
    /// Distance of the samples that are computed, mm.
    pub(super) step: f64,
    /// Their number.
    pub(super) count: usize,
    /// Closer samples, interpolated from those: their distance, mm, number and weights.
    pub(super) closer: Option<(f64, usize, Taps)>,
    /// Interpolation of voxels from the last of them.
    pub(super) taps: Taps,
}

impl Ladder {
    /// Distance and number of the samples that voxels are interpolated from.
    pub(super) fn last(&self) -> (f64, usize) {
        self.closer
            .as_ref()
            .map_or((self.step, self.count), |(step, count, _)| (*step, *count))
    }
}

/// Steps, numbers and taps that are weighed against each other.
#[derive(Clone, Copy, Debug)]
struct Rungs {
    step: f64,
    count: usize,
    taps: usize,
    closer: Option<(f64, usize, usize)>,
}

impl Rungs {
    /// Taps that a voxel is interpolated from.
    fn last_taps(&self) -> usize {
        self.closer.map_or(self.taps, |(_, _, taps)| taps)
    }

    fn last_count(&self) -> usize {
        self.closer.map_or(self.count, |(_, count, _)| count)
    }

    fn built(&self, signal: &Signal, has_end: bool) -> Ladder {
        let end = |count: usize| has_end.then_some(count as i64 - 1);
        let from_computed = Taps::new(self.taps, signal, self.step, end(self.count));
        let (closer, taps) = match self.closer {
            None => (None, from_computed),
            Some((step, count, taps)) => (
                Some((step, count, from_computed)),
                Taps::new(taps, signal, step, end(count)),
            ),
        };
        Ladder {
            step: self.step,
            count: self.count,
            closer,
            taps,
        }
    }
}

/// The fewest depths (k + ½) steps, up to the deepest voxel, that hold light with such an error; their distance.
fn fewest(taps: usize, signal: &Signal, deepest: f64, error: f64) -> (f64, usize) {
    let step = |count: usize| deepest / (count as f64 - 0.5 + OVERHANG);
    let holds = |count: usize| Taps::error_in_disc(taps, signal, step(count), count) <= error;
    let mut enough = taps / 2;
    while !holds(enough) && (enough as f64) < MOST_SAMPLES {
        enough *= 2;
    }
    let mut short = enough / 2;
    while enough - short.max(taps / 2 - 1) > 1 {
        let middle = usize::midpoint(enough, short.max(taps / 2 - 1));
        if holds(middle) {
            enough = middle;
        } else {
            short = middle;
        }
    }
    (step(enough), enough)
}

/// Pixels along an edge of the window at most, and depths times pixels of the window: what a frame is computed at.
const MOST_PIXELS: usize = 16384;
const MOST_SAMPLES: f64 = 2e10;

/// All ways to sample the depths.
fn ways_along(signal: &Signal, deepest: f64, error: f64) -> Vec<Rungs> {
    let mut ways = Vec::new();
    let close = CLOSE_TAPS.map(|taps| (taps, fewest(taps, signal, deepest, error * FRAC_1_SQRT_2)));
    for taps in TAPS {
        let (step, count) = fewest(taps, signal, deepest, error);
        let rungs = Rungs {
            step,
            count,
            taps,
            closer: None,
        };
        ways.push(rungs);
        let (step, count) = fewest(taps, signal, deepest, error * FRAC_1_SQRT_2);
        for (close_taps, (close_step, close_count)) in close {
            if close_count > count && close_taps < taps {
                ways.push(Rungs {
                    step,
                    count,
                    taps,
                    closer: Some((close_step, close_count, close_taps)),
                });
            }
        }
    }
    ways
}

/// All ways to sample a window of some length, of which voxels need a part; `band`: frequencies that must be held.
fn ways_across(signal: &Signal, [window, part]: [f64; 2], band: usize, error: f64) -> Vec<Rungs> {
    let most = window / (2 * band + 2) as f64;
    let computed = |taps: usize, error: f64| {
        let step = Taps::widest(taps, signal, error, most);
        smooth((window / step - 1e-6).ceil() as usize)
    };
    let mut ways = Vec::new();
    let close = CLOSE_TAPS.map(|taps| {
        let step = Taps::widest(taps, signal, error * FRAC_1_SQRT_2, most);
        (taps, step)
    });
    for taps in TAPS {
        let count = computed(taps, error);
        ways.push(Rungs {
            step: window / count as f64,
            count,
            taps,
            closer: None,
        });
        let count = computed(taps, error * FRAC_1_SQRT_2);
        let step = window / count as f64;
        for (close_taps, close_step) in close {
            if close_step < step && close_taps < taps {
                let close_count = (part / close_step).ceil() as usize + close_taps + 1;
                ways.push(Rungs {
                    step,
                    count,
                    taps,
                    closer: Some((close_step, close_count, close_taps)),
                });
            }
        }
    }
    ways
}

/// What a sampling has to serve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Needs {
    /// Largest distance of a voxel from the focal plane, mm.
    pub(super) deepest: f64,
    /// Columns of voxels, and voxels of a column.
    pub(super) voxels: [usize; 2],
    /// Samples of a window along z.
    pub(super) high: f64,
}

impl Sampling {
    /// The quickest sampling with the errors that the settings allow; what is too much of it.
    pub(super) fn new(
        beam: &dyn Spreading,
        sides: [&Side; 2],
        needs: &Needs,
        settings: &Settings,
    ) -> Result<Self, String> {
        let wide = [0, 1].map(|i| wide(beam, i, sides[i], needs.deepest));
        if wide.iter().any(|n| *n > MOST_PIXELS as f64) {
            let [u, z] = wide.map(concise);
            return Err(format!("light needs a window of {u} × {z} pixels"));
        }
        let padded = wide.map(|n| 2 * smooth((0.5 * n).ceil() as usize));
        let guard = [0, 1].map(|i| padded[i] as f64 * sides[i].pitch - sides[i].reach());
        let band = [0, 1].map(|i| {
            // Nothing passes at the highest frequency itself
            let highest = beam.highest(i) * padded[i] as f64 * sides[i].pitch;
            ((highest - 1e-6).ceil() as usize - 1).max(1)
        });
        let (along, across) = (beam.along(), beam.across());
        let width = padded[0] as f64 * sides[0].pitch;
        let part = sides[0].voxels[1] - sides[0].voxels[0];
        let ways = ways_across(&across, [width, part], band[0], settings.rotation_error);
        let ways_along = ways_along(&along, needs.deepest, settings.relative_error);
        let pairs = ways_along
            .iter()
            .flat_map(|a| ways.iter().map(move |b| (a, b)));
        let cost = |(a, b): &(&Rungs, &Rungs)| cost(a, b, part, band[0], padded[1], needs);
        let (a, b) = pairs
            .min_by(|a, b| cost(a).total_cmp(&cost(b)))
            .unwrap_or((&ways_along[0], &ways[0]));
        let samples = padded.iter().fold(a.count as f64, |all, n| all * *n as f64);
        if samples > MOST_SAMPLES {
            let [u, z] = padded;
            return Err(format!(
                "light needs {} depths of {u} × {z} pixels",
                a.count
            ));
        }
        Ok(Sampling {
            padded,
            guard,
            band,
            along: a.built(&along, true),
            across: b.built(&across, false),
        })
    }
}

/// Time of a dose and a pullback of a frame, in operations of Fourier transforms.
fn cost(
    along: &Rungs,
    across: &Rungs,
    part: f64,
    band: usize,
    padded_z: usize,
    needs: &Needs,
) -> f64 {
    let [columns, heights] = needs.voxels;
    let high = needs.high * padded_z as f64;
    let of_depth =
        (2 * band + 1) as f64 * operations(high) + heights as f64 * operations(across.count as f64);
    let width = (part / across.step)
        .max(across.last_count() as f64 * f64::from(u8::from(across.closer.is_some())));
    let mut rows = (columns * along.last_taps() * across.last_taps()) as f64;
    if across.closer.is_some() {
        rows += (along.count * across.last_count() * across.taps) as f64;
    }
    if along.closer.is_some() {
        rows += along.last_count() as f64 * width * along.taps as f64;
    }
    3.0 * along.count as f64 * of_depth + 2.0 * ROW_COST * rows * heights as f64
}

/// Operations of a Fourier transform, 5·n·log₂n.
pub(super) fn operations(n: f64) -> f64 {
    5.0 * n * n.log2()
}

/// Pixels of a window along one side, those of the guard included.
fn wide(beam: &dyn Spreading, i: usize, side: &Side, deepest: f64) -> f64 {
    let reach = side.reach();
    let travel = deepest * beam.steepest(i);
    // What travels further than all voxels is deleted, but not the middle of the band: its end would ring
    let guard = travel.min(reach).max(deepest * beam.straightest(i));
    (side.span().max(reach + guard) + beam.rings(i)) / side.pitch
}

/// The smallest number ≥ n without prime factors above 7.
fn smooth(n: usize) -> usize {
    let is_smooth = |&m: &usize| {
        let mut rest = m;
        for p in [2, 3, 5, 7] {
            while rest.is_multiple_of(p) {
                rest /= p;
            }
        }
        rest == 1
    };
    (n.max(2)..).find(is_smooth).unwrap_or(n)
}
