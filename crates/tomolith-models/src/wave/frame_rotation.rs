//! From samples of the light of every frame to voxels that turn, and back.
//!
//! # Equation
//! A voxel at (X, Y) lies at depth d = −(X cos α + Y sin α) along the light of azimuth α and at u = −X sin α + Y cos α across it:
//! ```text
//! dose(X, Y, z) += a·e^(−μ_t·way) Σ_k Σ_j c_k(|d − d₀|/h − ½)·b_j(u)·I[k][j][z]
//! ```
//! with the weights of [`Taps`](super::taps::Taps) along and across. Depths are mirrored about the focal plane d₀: |ψ(−x)|² = |ψ(x)|² for real patterns.
//! Dose and pullback enumerate the same entries, the first by voxel, the second sorted by sample.

use super::number::Number;
use super::resample::mirrored;
use super::sampling::Sampling;
use super::spectrum::Windows;
use super::{Entrance, Settings};
use std::ops::Range;
use tomolith_core::dose::waves::{Axis, Rotation};
use tomolith_core::grid::VolumeGrid;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// Voxels along an edge of a tile.
pub(super) const TILE: usize = 16;

/// The turning voxels of one light.
pub(super) struct FrameRotation {
    pub(super) data: Rotation,
    x: Vec<f64>,
    y: Vec<f64>,
}

/// What one frame brings to the voxels of a tile.
#[derive(Default)]
pub(super) struct TileEntries<T> {
    /// Voxel columns (iy·nx + ix) that are lit.
    pub(super) voxels: Vec<u32>,
    /// First entry of each, and the end.
    pub(super) starts: Vec<u32>,
    pub(super) slots: Vec<u32>,
    pub(super) weights: Vec<T>,
    along: Vec<f64>,
    across: Vec<f64>,
}

impl FrameRotation {
    pub(super) fn new<T: Number>(
        vial: &dyn Vial,
        light: &Light,
        grid: &VolumeGrid,
        in_resin: Vec<bool>,
        settings: &Settings,
        windows: &Windows<T>,
    ) -> Self {
        let (pixels, sub_angles) = (&light.pixels, light.sub_angles);
        let [_, ny, nx] = grid.shape;
        let within = |sub: usize| (sub as f64 + 0.5) / sub_angles as f64 - 0.5;
        let azimuths = pixels.azimuths.iter();
        let (resin, wall) = (light.resin.uptake(), vial.resin_wall());
        let Sampling { along, across, .. } = &windows.sampling;
        let depths = along.last();
        let places = Axis {
            from: depths.at(0),
            step: depths.step,
            count: depths.count,
        };
        let data = Rotation {
            azimuths: azimuths
                .flat_map(|a| (0..sub_angles).map(move |sub| a + within(sub) * pixels.frame_arc))
                .collect(),
            sub_angles,
            in_resin,
            focus: settings.focus_mm,
            active: resin.active_per_mm,
            attenuation: resin.attenuation_per_mm,
            wall: (wall.as_circle()).filter(|_| settings.entrance == Entrance::Wall),
            entrance: -wall.inscribed_radius(),
            along: (places, along.taps.form()),
            across: (windows.last, across.taps.form()),
        };
        FrameRotation {
            data,
            x: (0..nx).map(|i| grid.x(i)).collect(),
            y: (0..ny).map(|i| grid.y(i)).collect(),
        }
    }

    /// Dose of a fluence of 1 at a depth and a lateral place, mm.
    fn dose(&self, depth: f64, u: f64) -> f64 {
        let data = &self.data;
        if data.attenuation == 0.0 {
            return data.active;
        }
        let at_wall = |r: f64| -(r * r - u * u).max(0.0).sqrt();
        let enter = data.wall.map_or(data.entrance, at_wall);
        data.active * (-data.attenuation * (depth - enter).max(0.0)).exp()
    }

    /// Columns of voxels in the resin.
    pub(super) fn columns(&self) -> usize {
        self.data.in_resin.iter().filter(|r| **r).count()
    }

    /// Enumerates what a frame brings to a tile; its sample [k][j] is slot `first + k·width + j`.
    pub(super) fn enumerate<T: Number>(
        &self,
        frame: usize,
        first: usize,
        xs: Range<usize>,
        ys: Range<usize>,
        sampling: &Sampling,
        entries: &mut TileEntries<T>,
    ) {
        entries.voxels.clear();
        entries.starts.clear();
        entries.slots.clear();
        entries.weights.clear();
        let data = &self.data;
        let subs = frame * data.sub_angles..(frame + 1) * data.sub_angles;
        let turns: Vec<(f64, f64)> = data.azimuths[subs].iter().map(|a| a.sin_cos()).collect();
        let share = 1.0 / data.sub_angles as f64;
        let (depths, lateral) = (sampling.along.last(), data.across.0);
        for iy in ys {
            for ix in xs.clone() {
                let column = iy * self.x.len() + ix;
                if !data.in_resin[column] {
                    continue;
                }
                entries.voxels.push(column as u32);
                entries.starts.push(entries.slots.len() as u32);
                for &(sin, cos) in &turns {
                    let depth = -(self.x[ix] * cos + self.y[iy] * sin);
                    let u = self.y[iy] * cos - self.x[ix] * sin;
                    let weight = share * self.dose(depth, u);
                    let place = depths.place((depth - data.focus).abs());
                    let k0 = sampling.along.taps.at(place, &mut entries.along);
                    let place = (u - lateral.from) / lateral.step;
                    let j0 = sampling.across.taps.at(place, &mut entries.across);
                    for (k, a) in (k0..).zip(&entries.along) {
                        let row = first + mirrored(k) * lateral.count;
                        for (j, b) in (j0..).zip(&entries.across) {
                            entries.slots.push((row as i64 + j) as u32);
                            entries.weights.push(T::of(weight * a * b));
                        }
                    }
                }
            }
        }
        entries.starts.push(entries.slots.len() as u32);
    }
}

/// The same entries by sample.
#[derive(Default)]
pub(super) struct Sorted<T> {
    /// Samples that are met.
    pub(super) samples: Vec<u32>,
    pub(super) starts: Vec<u32>,
    pub(super) voxels: Vec<u32>,
    pub(super) weights: Vec<T>,
    counts: Vec<u32>,
}

impl<T: Number> Sorted<T> {
    /// Counting sort; voxels of a sample keep their order.
    pub(super) fn sort(&mut self, entries: &TileEntries<T>) {
        self.samples.clear();
        self.starts.clear();
        let Some((&low, &high)) = entries.slots.iter().min().zip(entries.slots.iter().max()) else {
            self.starts.push(0);
            return;
        };
        self.counts.clear();
        self.counts.resize((high - low) as usize + 1, 0);
        for &slot in &entries.slots {
            self.counts[(slot - low) as usize] += 1;
        }
        let mut next = 0;
        for (i, count) in self.counts.iter_mut().enumerate() {
            if *count > 0 {
                self.samples.push(low + i as u32);
                self.starts.push(next);
            }
            next += std::mem::replace(count, next);
        }
        self.starts.push(next);
        self.voxels.resize(next as usize, 0);
        self.weights.resize(next as usize, T::zero());
        for (i, &voxel) in entries.voxels.iter().enumerate() {
            for e in entries.starts[i] as usize..entries.starts[i + 1] as usize {
                let at = &mut self.counts[(entries.slots[e] - low) as usize];
                self.voxels[*at as usize] = voxel;
                self.weights[*at as usize] = entries.weights[e];
                *at += 1;
            }
        }
    }
}
