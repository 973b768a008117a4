//! Views: frames that see the plane along the same lines.
//!
//! In pure Radon, light through an index-matched vial is the same along a line whichever way it runs. A frame and the one
//! from the opposite side (azimuth + π) then light the same voxels with the same weights, their columns reversed, if these lie
//! evenly about the axis. They are one *view*: the dose of both is that of the sum of their pixels, and one adjoint serves both. Geometry, lanes and kernels
//! know views only; what a beam calls its frame is its view. Everywhere else a view is a frame.

use super::is_straight;
use std::f64::consts::{PI, TAU};
use std::ops::Range;
use tomolith_core::grid::PatternGrid;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// How the frames of one light are views.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Views {
    pub(super) frames: usize,
    columns: usize,
    /// Whether frame k + frames/2 is the opposite of frame k, for all k.
    paired: bool,
}

/// Some views, and the sides from which they are seen.
pub(super) struct SeenViews {
    pub(super) views: Range<usize>,
    pub(super) sides: Range<usize>,
}

/// Directions nearer than this, rad, are one.
pub(super) const SAME: f64 = 1e-9;

impl Views {
    pub(super) fn of(vial: &dyn Vial, light: &Light) -> Self {
        let azimuths = &light.pixels.azimuths;
        let (first, second) = azimuths.split_at(azimuths.len() / 2);
        let is_opposite = |(a, b): (&f64, &f64)| {
            let turn = (b - a).rem_euclid(TAU);
            (turn - PI).abs() < SAME
        };
        let about_axis = light.pixels.offset_mm[0] == 0.0;
        let reversible = about_axis
            && light.resin.pure_radon
            && light.bath.is_none()
            && is_straight(vial, light);
        Views {
            frames: azimuths.len(),
            columns: light.pixels.columns,
            paired: reversible
                && first.len() == second.len()
                && first.iter().zip(second).all(is_opposite),
        }
    }

    pub(super) fn count(&self) -> usize {
        if self.paired {
            self.frames / 2
        } else {
            self.frames
        }
    }

    /// The pixels of the frames that stand for the views.
    pub(super) fn pixels(&self, all: &PatternGrid) -> PatternGrid {
        let mut pixels = all.clone();
        pixels.azimuths.truncate(self.count());
        pixels
    }

    /// Slot (view and column) that a pixel column of a frame lights.
    pub(super) fn slot(&self, frame: usize, column: usize) -> usize {
        let (view, side) = (frame % self.count(), frame / self.count());
        let column = if side == 0 {
            column
        } else {
            self.columns - 1 - column
        };
        view * self.columns + column
    }

    /// All views, from all sides.
    pub(super) fn all(&self) -> SeenViews {
        SeenViews {
            views: 0..self.count(),
            sides: self.sides(),
        }
    }

    /// A range of frames as ranges of views.
    pub(super) fn of_frames(&self, frames: Range<usize>) -> Vec<SeenViews> {
        let count = self.count();
        if self.paired && frames == (0..self.frames) {
            return vec![self.all()];
        }
        let sides = self.frames / count.max(1);
        (0..sides)
            .map(|side| {
                let local = |f: usize| f.saturating_sub(side * count).min(count);
                SeenViews {
                    views: local(frames.start)..local(frames.end),
                    sides: side..side + 1,
                }
            })
            .filter(|seen| !seen.views.is_empty())
            .collect()
    }

    /// The frames that see these views from these sides: all of both, or one side.
    pub(super) fn frames_of(&self, SeenViews { views, sides }: &SeenViews) -> Range<usize> {
        let count = self.count();
        sides.start * count + views.start..(sides.end - 1) * count + views.end
    }

    /// The pixel column (counted through all frames) that lights a slot from one side.
    pub(super) fn pixel_column(&self, slot: usize, side: usize) -> usize {
        let (view, column) = (slot / self.columns, slot % self.columns);
        let column = if side == 0 {
            column
        } else {
            self.columns - 1 - column
        };
        (view + side * self.count()) * self.columns + column
    }

    /// Sides from which every view is seen.
    pub(super) fn sides(&self) -> Range<usize> {
        0..1 + usize::from(self.paired)
    }
}
