//! What a job will cost: memory, disk and time, before any work.
//!
//! Memory counts the arrays the method needs. Time is measured: one forward and one adjoint call of a small model with
//! the job's own optics, scaled by the number of voxel-angle updates.

use super::build::Optics;
use crate::error::Result;
use crate::field::{Field, HostField};
use crate::grid::VolumeGrid;
use crate::models::layout::row_of;
use crate::models::{Choice, Run, planner};
use std::time::Instant;

/// Dose, its change along a step, gradient (4 bytes each), inside fraction (4), labels (1), response (4 while metrics run).
const BYTES_PER_VOXEL: f64 = 21.0;
/// Dose turning and standing, dose in file order, inside fraction (4 bytes each), labels and distances.
const BYTES_PER_FINE_VOXEL: f64 = 21.0;
/// Raw, quantised and as levels.
const BYTES_PER_PIXEL: f64 = 10.0;
/// What every run needs: the program, the report, one movie frame, …
const BASE_MB: f64 = 60.0;
/// Compressed size of a pattern value in the npz, the frames and the movie, beside 8 bytes of raw values.
const BYTES_PER_PIXEL_ON_DISK: f64 = 10.0;
/// Bytes of dose.npy (4) and dose.vti (9: dose, target, label) per voxel, and some for the surface.
const BYTES_PER_VOXEL_ON_DISK: f64 = 20.0;
/// Measuring a print, above all the distances of surfaces: seconds per voxel of the finer grid.
const MEASURE_S: f64 = 1.5e-7;
/// Pattern vectors of an optimiser beside its memory of 2m.
const VECTORS: usize = 4;
/// Frames, and voxels along an edge, of the small model that is timed.
const TRIAL_FRAMES: usize = 16;
const TRIAL_EDGE: usize = 96;

/// The extent of the problem, known before anything is built.
#[derive(Clone, Debug)]
pub(crate) struct Extent {
    /// Voxels.
    pub(crate) grid: VolumeGrid,
    /// How many times finer the evaluation is.
    pub(crate) refine: usize,
    /// Frames of all lights.
    pub(crate) frames: usize,
    /// Pixels whose light can meet the target, of all lights.
    pub(crate) active_pixels: usize,
    /// All pixels of all lights.
    pub(crate) pixels: usize,
    /// Columns of all frames of all lights.
    pub(crate) columns: usize,
    /// The optimiser's memory m.
    pub(crate) memory: usize,
}

impl Extent {
    /// For a target with this box.
    pub(crate) fn new(
        optics: &Optics,
        grid: &VolumeGrid,
        [low, high]: [[f64; 3]; 2],
        refine: usize,
        memory: usize,
    ) -> Self {
        let corner = f64::hypot(high[0].max(-low[0]), high[1].max(-low[1]));
        let radius = corner.min(optics.vial.resin_wall().inscribed_radius());
        let active = |light: &crate::models::parallel::Light| {
            let pitch = light.pixels.pitch_mm;
            // Refraction lets a narrower bundle fill the same part
            let columns = (2.0 * radius / pitch).ceil() as usize + 1;
            let rows = ((high[2] - low[2]) / pitch).ceil() as usize + 1;
            light.pixels.frames() * light.pixels.columns.min(columns) * light.pixels.rows.min(rows)
        };
        Extent {
            grid: grid.clone(),
            refine,
            frames: optics.lights.iter().map(|l| l.pixels.frames()).sum(),
            active_pixels: optics.lights.iter().map(active).sum(),
            pixels: optics.lights.iter().map(|l| l.pixels.len()).sum(),
            columns: optics
                .lights
                .iter()
                .map(|l| l.pixels.frames() * l.pixels.columns)
                .sum(),
            memory,
        }
    }

    fn lanes(&self, factor: usize) -> f64 {
        let [nz, ny, nx] = self.grid.shape.map(|n| n * factor);
        (row_of(nz) * ny * nx) as f64
    }

    /// Bytes of the pixels brought to the voxels' heights, which the model keeps between calls.
    fn scratch(&self, factor: usize) -> f64 {
        (self.columns * row_of(self.grid.shape[0] * factor) * 4) as f64
    }

    /// Memory of the optimisation, MB.
    pub(crate) fn optimisation_mb(&self) -> u64 {
        let vectors = (2 * self.memory + VECTORS) as f64;
        let patterns = self.active_pixels as f64 * 4.0 * vectors;
        let bytes = self.lanes(1) * BYTES_PER_VOXEL + self.scratch(1) + patterns;
        (BASE_MB + bytes / 1e6) as u64
    }

    /// Memory of the evaluation, MB.
    pub(crate) fn evaluation_mb(&self) -> u64 {
        let patterns = self.pixels as f64 * BYTES_PER_PIXEL;
        let bytes =
            self.lanes(self.refine) * BYTES_PER_FINE_VOXEL + self.scratch(self.refine) + patterns;
        (BASE_MB + bytes / 1e6) as u64
    }

    /// Time to measure the evaluation's prints, standing still and turning, s.
    pub(crate) fn measure_s(&self) -> f64 {
        2.0 * (self.grid.len() * self.refine.pow(3)) as f64 * MEASURE_S
    }

    /// Size of the run folder, MB.
    pub(crate) fn disk_mb(&self) -> u64 {
        let voxels = self.grid.len() as f64;
        let checkpoint = self.active_pixels as f64 * 4.0 * (2 * self.memory + VECTORS) as f64;
        let bytes = voxels * BYTES_PER_VOXEL_ON_DISK
            + self.pixels as f64 * BYTES_PER_PIXEL_ON_DISK
            + checkpoint;
        (10.0 + bytes / 1e6) as u64
    }
}

/// How fast this machine is with these optics.
#[derive(Clone, Debug)]
pub(crate) struct Speed {
    /// Which model.
    pub(crate) model: String,
    /// Updates per second.
    pub(crate) updates_per_s: f64,
    /// Updates of one dose call over voxels times frames: what masks leave.
    pub(crate) lit: f64,
}

/// Times a small model: few frames, a coarse grid of the same extent.
///
/// # Errors
/// As the planner; [`Error::Cancelled`](crate::Error::Cancelled).
pub(crate) fn speed(optics: &Optics, grid: &VolumeGrid, run: &Run) -> Result<Speed> {
    let longest = grid.shape.iter().copied().max().unwrap_or(1);
    let factor = longest.div_ceil(TRIAL_EDGE);
    let small = VolumeGrid {
        shape: grid.shape.map(|n| n.div_ceil(factor)),
        pitch_mm: grid.pitch_mm * factor as f64,
        center_mm: grid.center_mm,
    };
    let mut lights = optics.lights_turning(1);
    for light in &mut lights {
        let step = light.pixels.frames().div_ceil(TRIAL_FRAMES);
        light.pixels.azimuths = light
            .pixels
            .azimuths
            .iter()
            .copied()
            .step_by(step)
            .collect();
        light.pixels.rows = light.pixels.rows.div_ceil(factor);
        light.pixels.columns = light.pixels.columns.div_ceil(factor);
        light.pixels.pitch_mm *= factor as f64;
    }
    let frames: usize = lights.iter().map(|l| l.pixels.frames()).sum();
    // A matrix is known for its own pixels only: what the geometry would take stands for it
    let choice = Choice::default();
    let plan = planner::plan(
        &choice,
        optics.vial.as_ref(),
        lights,
        small.clone(),
        None,
        run,
    )?;
    let model = plan.model;
    let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
    x.fill(1.0);
    let once = |x: &mut HostField, dose: &mut HostField| -> Result<f64> {
        let start = Instant::now();
        model.dose(x, dose, run)?;
        model.pullback(&x.clone(), dose, x, run)?;
        Ok(start.elapsed().as_secs_f64())
    };
    once(&mut x, &mut dose)?; // caches and threads wake up
    x.fill(1.0);
    let seconds = once(&mut x, &mut dose)?.max(1e-6);
    let updates = model.updates() as f64;
    let lit = updates / (frames * small.len()).max(1) as f64;
    Ok(Speed {
        model: plan.reason,
        updates_per_s: 2.0 * updates / seconds,
        lit,
    })
}
