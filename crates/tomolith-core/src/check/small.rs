//! A small model for the checks: straight rays through a few slices, its matrix written down.

use crate::dose::{DoseLayout, DoseModel, Facts, PatternLayout, Quantity, Space, Work, ZCoupling};
use crate::error::Result;
use crate::field::HostField;
use crate::grid::{PatternGrid, Volume, VolumeGrid};
use crate::target::{Target, label, label_voxels};
use std::ops::Range;

/// Parallel light through `n`×`n` voxels, `slices` of them alike; linear interpolation between columns, mean over frames.
pub struct SmallModel {
    patterns: [PatternLayout; 1],
    outputs: [DoseLayout; 1],
    /// Per frame: (row of voxels, run of pixels, weight)
    entries: Vec<Vec<(usize, usize, f32)>>,
}

impl SmallModel {
    /// `n`×`n` voxels, `frames` frames of `n` columns.
    #[must_use]
    pub fn new(n: usize, frames: usize, slices: usize) -> Self {
        let grid = VolumeGrid::centered([slices, n, n], 1.0);
        let pixels = PatternGrid::full_turn(frames, 0.0, slices, n, 1.0);
        let entries = pixels
            .azimuths
            .iter()
            .map(|&azimuth| Self::frame(&grid, azimuth, 1.0 / frames as f32));
        let entries = entries.collect();
        let active = vec![(0, u32::try_from(slices).unwrap_or(u32::MAX)); frames * n];
        SmallModel {
            patterns: [PatternLayout::new(pixels, Quantity::Energy, 0, &active)],
            outputs: [DoseLayout::new("dose", grid, 0)],
            entries,
        }
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "small numbers, clipped"
    )]
    fn frame(grid: &VolumeGrid, azimuth: f64, weight: f32) -> Vec<(usize, usize, f32)> {
        let n = grid.shape[1];
        let mut entries = Vec::new();
        for iy in 0..n {
            for ix in 0..n {
                let u = -azimuth.sin() * grid.x(ix)
                    + azimuth.cos() * grid.y(iy)
                    + (n as f64 - 1.0) / 2.0;
                for column in [u.floor(), u.floor() + 1.0] {
                    let share = (1.0 - (u - column).abs()) as f32;
                    if share > 0.0 && (0.0..n as f64).contains(&column) {
                        entries.push((iy * n + ix, column as usize, share * weight));
                    }
                }
            }
        }
        entries
    }

    /// The layout of its dose.
    pub fn layout(&self) -> &DoseLayout {
        &self.outputs[0]
    }

    /// The matrix of one slice, `(pixel, weight)` per voxel, pixels frame by frame; and the number of pixels.
    pub fn matrix(&self) -> (Vec<Vec<(usize, f64)>>, usize) {
        let [_, ny, nx] = self.layout().grid.shape;
        let mut matrix = vec![Vec::new(); ny * nx];
        for (frame, entries) in self.entries.iter().enumerate() {
            for &(voxel, column, weight) in entries {
                matrix[voxel].push((frame * nx + column, f64::from(weight)));
            }
        }
        (matrix, self.entries.len() * nx)
    }

    /// A ring with three notches, and its labels within the inscribed circle.
    pub fn ring(&self) -> (Target, Volume<u8>) {
        let grid = self.layout().grid.clone();
        let n = grid.shape[1] as f64;
        let is_ring = |[x, y, _]: [f64; 3]| {
            let (x, y) = (x / n, y / n);
            let (radius, angle) = (x.hypot(y), y.atan2(x));
            (0.15..0.36).contains(&radius) && !(radius > 0.27 && (3.0 * angle).cos() > 0.8)
        };
        let target = Target {
            name: "ring".to_owned(),
            inside: Volume::from_fn(grid, |middle| f32::from(is_ring(middle))),
            gray: false,
        };
        let labels = label_voxels(&target, |[x, y, _]| x.hypot(y) < n / 2.0);
        debug_assert!(labels.values.contains(&label::PART));
        (target, labels)
    }
}

impl DoseModel for SmallModel {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: &self.outputs,
            z_coupling: ZCoupling::None,
            is_linear: true,
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        _: &Work,
    ) -> Result<()> {
        let [layout] = &self.outputs;
        let [pixels] = &self.patterns;
        let (slices, columns) = (layout.grid.shape[0], pixels.grid.columns);
        let (x, dose) = (x.as_slice(), dose.as_mut_slice());
        for frame in frames {
            for &(voxel, column, weight) in &self.entries[frame] {
                let from = pixels.runs[frame * columns + column].offset;
                for z in 0..slices {
                    dose[voxel * layout.row + z] += weight * x[from + z];
                }
            }
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        _: &Work,
    ) -> Result<()> {
        let [layout] = &self.outputs;
        let [pixels] = &self.patterns;
        let (slices, columns) = (layout.grid.shape[0], pixels.grid.columns);
        let (cotangent, grad) = (cotangent.as_slice(), grad.as_mut_slice());
        grad[pixels.elements_of(frames.clone())].fill(0.0);
        for frame in frames {
            for &(voxel, column, weight) in &self.entries[frame] {
                let to = pixels.runs[frame * columns + column].offset;
                for z in 0..slices {
                    grad[to + z] += weight * cotangent[voxel * layout.row + z];
                }
            }
        }
        Ok(())
    }

    fn updates(&self) -> u64 {
        self.entries
            .iter()
            .map(|entries| entries.len() as u64)
            .sum()
    }

    fn describe(&self) -> String {
        "a small matrix".to_owned()
    }
}
