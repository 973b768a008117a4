//! How wide the window of a light must be.
//!
//! # Equations
//! At depth x a component has traveled t = x·f/w sideways, and D(x) is the largest distance of a voxel from a pixel: less at the ends of a round vial
//! than in its middle. A window of length P repeats what lies in it. What travels further than P/2 is deleted; so of a component
//! ```text
//! (t − P + D)⁺/L, t < P/2, comes back from the far side of the window and is seen,      (D − t)⁺/L, t > P/2, is missed
//! ```
//! L the length of the pattern. P = 2D leaves neither: the limit of Matsushima & Shimobaba, eq. 13 and 20 to 22. Of light that fills the band, few components
//! travel so far: the window is the smallest that, at every depth, loses and repeats no more power than the allowed error squared.
//!
//! # Source
//! Matsushima & Shimobaba, Opt. Express 17 (2009) 19662.

use super::beam::Spreading;

/// One side of the window: u, or z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Side {
    /// Distance of pixels, mm.
    pub(super) pitch: f64,
    pub(super) pixels: usize,
    /// First pixel, mm.
    pub(super) from: f64,
    pub(super) voxels: Span,
}

/// Where voxels lie along a side, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Span {
    /// Between these, at all depths.
    Between(f64, f64),
    /// In a disc about the axis, whose middle lies so far from the focal plane.
    Disc { radius: f64, focus: f64 },
}

impl Side {
    /// Lowest and highest voxel at a distance from the focal plane, before or behind it; at 0: at any distance.
    pub(super) fn voxels_at(&self, depth: f64) -> [f64; 2] {
        match self.voxels {
            Span::Between(low, high) => [low, high],
            Span::Disc { radius, .. } if depth == 0.0 => [-radius, radius],
            Span::Disc { radius, focus } => {
                let half = (radius * radius - (depth - focus.abs()).powi(2))
                    .max(0.0)
                    .sqrt();
                [-half, half]
            }
        }
    }

    fn last(&self) -> f64 {
        self.from + self.pitch * (self.pixels as f64 - 1.0)
    }

    /// The largest distance of a voxel from a pixel at a depth.
    pub(super) fn reach(&self, depth: f64) -> f64 {
        let [low, high] = self.voxels_at(depth);
        (self.last() - low).max(high - self.from)
    }

    /// What pixels and voxels span together.
    fn span(&self) -> f64 {
        let [low, high] = self.voxels_at(0.0);
        self.last().max(high) - self.from.min(low)
    }
}

/// Depths at which a window is tried.
const DEPTHS: i32 = 32;

/// Pixels of a window along one side, those of the guard included, that loses and repeats `error` of the light; `depths`: of the nearest and
/// the deepest voxel, mm.
pub(super) fn wide(
    beam: &dyn Spreading,
    i: usize,
    side: &Side,
    [nearest, deepest]: [f64; 2],
    error: f64,
) -> f64 {
    let slopes = beam.slopes(i);
    let at = |depth: f64| {
        let reach = side.reach(depth);
        // Not the middle of the band either: its end would ring
        narrowest(&slopes, side, depth, error).max(reach + beam.spreads(i, depth))
    };
    let share = |k: i32| f64::from(k) / f64::from(DEPTHS);
    let depths = (1..=DEPTHS).map(|k| nearest + (deepest - nearest) * share(k));
    (depths.map(at).fold(side.span(), f64::max) + beam.rings(i)) / side.pitch
}

/// The smallest window, mm, that is good enough at a depth; `slopes`: travel over depth, and share of the power.
fn narrowest(slopes: &[(f64, f64)], side: &Side, depth: f64, error: f64) -> f64 {
    let (reach, length) = (side.reach(depth), side.pitch * side.pixels as f64);
    let lost = |window: f64| -> f64 {
        let loss_of = |&(slope, power): &(f64, f64)| {
            let travel = slope * depth;
            power * (travel - window + reach).min(reach - travel).max(0.0) / length
        };
        slopes.iter().map(loss_of).sum()
    };
    let (mut low, mut high) = (reach, 2.0 * reach);
    for _ in 0..12 {
        let middle = 0.5 * (low + high);
        if lost(middle) > error * error {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// Operations of a Fourier transform, 5·n·log₂n.
pub(super) fn operations(n: f64) -> f64 {
    5.0 * n * n.log2()
}

/// The smallest number ≥ n without prime factors above 7.
pub(super) fn smooth(n: usize) -> usize {
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
