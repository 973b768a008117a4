//! What a job will cost: memory, disk and time, before any work.
//!
//! Memory counts the arrays the method needs. Time is the rates of this machine ([`benchmark`](crate::job::run::benchmark)) times what the job
//! asks for ([`Demand::cost`]). An optimization that ends before its last iteration takes less.

use super::optics::Optics;
use super::refinement;
use crate::field::LANES;
use crate::grid::VolumeGrid;
use crate::models::layout::row_of;
use crate::models::rays::matrix_cache::{self, CachedEntries};
use crate::optics::light::Light;

/// Dose, its change along a step, gradient (4 bytes each), inside fraction (4), labels (1), response (4 while metrics run).
const BYTES_PER_VOXEL: f64 = 21.0;
/// Dose as the model orders it and as an array, or the latter and what is derived from it (4 bytes each), labels and what metrics
/// need at a time: 10 to 11 bytes measured at 512³ and 800³.
const BYTES_PER_FINE_VOXEL: f64 = 12.0;
/// Raw, quantized and as levels.
const BYTES_PER_PIXEL: f64 = 10.0;
/// Weight, lower and upper end of the band, where they differ from voxel to voxel.
const BYTES_PER_VOXEL_OF_FIELDS: f64 = 12.0;
/// What a voxel takes of scattered light where absorption is a map, and that light in a call.
const BYTES_PER_VOXEL_THAT_GLOWS: f64 = 8.0;
/// A level of a machine's canvas.
const BYTES_PER_CANVAS_PIXEL: f64 = 2.0;
/// What every run needs: the program, the report, one movie frame, small arrays that the allocator has not given back, …: 60 to 110 measured for jobs
/// of less than 10⁷ voxels.
const BASE_MB: f64 = 100.0;
/// Bytes of the print's triangles and of the tree that measures distances, per face of a cube of as many voxels as are
/// evaluated: 500 to 3000 measured.
const BYTES_PER_FACE: f64 = 1000.0;
/// Bytes of a triangle of a print that is rough: its corners, its place in the tree that measures distances, the distances.
const BYTES_PER_TRIANGLE: f64 = 200.0;
/// Compressed size of a pattern value in the npz, the frames and the movie, in addition to 8 bytes of raw values.
const BYTES_PER_PIXEL_ON_DISK: f64 = 10.0;
/// The page holds up to 15 MB; the rest of what every run leaves is small.
const BASE_ON_DISK_MB: f64 = 16.0;
/// Bytes of dose.npy (4) and dose.vti (9: dose, target, label) per voxel, and some more.
const BYTES_PER_VOXEL_ON_DISK: f64 = 20.0;
/// Bytes of print.stl and print.ply per face of a cube of as many voxels as are evaluated: the part has about twelve triangles (50
/// and 22.5 bytes each) where the cube has one voxel's face on each of its six sides.
const BYTES_PER_FACE_ON_DISK: f64 = 870.0;
/// Bytes of print.stl per voxel that is evaluated, where noise makes the dose cross the threshold in most of them: 1.7 triangles measured.
const BYTES_PER_NOISY_VOXEL_ON_DISK: f64 = 100.0;
/// Pattern vectors of an optimizer in addition to its memory of 2m.
pub(crate) const VECTORS: usize = 4;
/// Dose and target of a scenario, as objectives with fields.
pub(crate) const FIELDS_PER_SCENARIO: usize = 2;
/// The extent of the problem, known before anything is built.
#[derive(Clone, Debug)]
pub(crate) struct Extent {
    /// The job's voxels.
    pub(crate) grid: VolumeGrid,
    /// The finest voxels of the optimization.
    pub(crate) finest: VolumeGrid,
    /// What its iterations cost, relative to as many on the job's voxels with frames that stand still.
    pub(crate) effort: f64,
    /// How many times finer the evaluation is.
    pub(crate) refine: usize,
    /// Frames of all lights.
    pub(crate) frames: usize,
    /// Pixels whose light can meet the target or is a background, of all lights.
    pub(crate) active_pixels: usize,
    /// All pixels of all lights.
    pub(crate) pixels: usize,
    /// Columns of all frames of all lights.
    pub(crate) columns: usize,
    /// Rows of pixels at the heights of the grid, of the light that has the most of them; None where the kernel does not run along rows.
    pub(crate) rows: Option<usize>,
    /// The optimizer's memory m.
    pub(crate) memory: usize,
    /// Objectives whose weights or bands differ from voxel to voxel.
    pub(crate) fields: usize,
    /// How many times finer than the optimization's the voxels are on which ceilings are judged, at most.
    pub(crate) judged_finer: usize,
    /// The same without a memory budget.
    pub(crate) judged_finer_asked: usize,
    /// Volumes of the job's voxels that a print in time takes in the evaluation, 0 without one.
    pub(crate) in_time: usize,
    /// Pixels of all frames on the machine's canvases, 0 without a machine.
    pub(crate) canvas: usize,
    /// The traced rays that the model stores where they are few.
    pub(crate) cached_entries: Option<CachedEntries>,
    /// What else the model stores, bytes, 0 where that is too much.
    pub(crate) cached_bytes: Option<f64>,
    /// Whether each voxel takes its part of the scattered light.
    pub(crate) glows: bool,
    /// Bytes of a canvas pixel in `frames.npz`, 0 when it is not written.
    pub(crate) stacked: usize,
    /// Bytes of a voxel of the evaluation in `evaluation/`, 0 when it is not written.
    pub(crate) bytes_evaluated: usize,
    /// Bytes of a voxel of the job in `volumes/`, 0 when it is not written.
    pub(crate) bytes_of_volumes: usize,
    /// Whether the dose is drawn at random, which makes the surface rough.
    pub(crate) is_noisy: bool,
    /// Scenarios in addition to the job: as many models more.
    pub(crate) scenarios: usize,
    /// Prints that are evaluated side by side.
    pub(crate) species: usize,
    /// Memory of frames at work, MB: in the optimization, and in the evaluation.
    pub(crate) working_mb: [f64; 2],
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
        let active = |light: &Light| {
            let [across, along] = light.pixels.pitch_mm;
            let field = light.selection.field_mm(&light.pixels);
            let lit = |axis: usize, pitch: f64| {
                ((field[1][axis] - field[0][axis]) / pitch).round() as usize
            };
            // Refraction lets a narrower bundle fill the same part
            let columns = (2.0 * radius / across).ceil() as usize + 1;
            let (sin, cos) = optics.tilt_rad().abs().sin_cos();
            let seen = (high[2] - low[2]) * cos + 2.0 * radius * sin;
            let rows = (seen / along).ceil() as usize + 1;
            let most = match light.selection.has_background {
                true => [usize::MAX; 2],
                false => [columns, rows],
            };
            light.pixels.frames() * lit(0, across).min(most[0]) * lit(1, along).min(most[1])
        };
        Extent {
            grid: grid.clone(),
            finest: grid.clone(),
            effort: 1.0,
            refine,
            frames: optics.lights.iter().map(|l| l.pixels.frames()).sum(),
            active_pixels: optics.lights.iter().map(active).sum(),
            pixels: optics.lights.iter().map(|l| l.pixels.len()).sum(),
            columns: optics
                .lights
                .iter()
                .map(|l| l.pixels.frames() * l.pixels.columns)
                .sum(),
            rows: rows_beside(optics, grid),
            memory,
            fields: 0,
            judged_finer: 1,
            judged_finer_asked: 1,
            in_time: 0,
            canvas: 0,
            cached_entries: None,
            cached_bytes: None,
            glows: optics.scene().scatters() && optics.lights.iter().any(|l| l.map.is_some()),
            stacked: 0,
            bytes_evaluated: 0,
            bytes_of_volumes: 0,
            is_noisy: false,
            scenarios: 0,
            species: 1,
            working_mb: [0.0; 2],
        }
    }

    /// The extent without scenarios.
    pub(crate) fn of_the_job_alone(&self) -> Self {
        Extent {
            scenarios: 0,
            effort: self.effort / self.models(),
            fields: self
                .fields
                .saturating_sub(FIELDS_PER_SCENARIO * self.scenarios),
            ..self.clone()
        }
    }

    /// Models of the optimization.
    pub(crate) fn models(&self) -> f64 {
        1.0 + self.scenarios as f64
    }

    /// Bytes of stored rays.
    fn bytes_of_walks(&self) -> f64 {
        let planes = self.finest.shape.iter().copied().max().unwrap_or(0) as f64;
        let per_plane = self.cached_entries.map_or(0.0, |rays| rays.per_pixel);
        let entries = self.active_pixels as f64 * per_plane * planes;
        let most = matrix_cache::MOST as f64;
        // It may turn out less than estimated
        if entries <= 2.0 * most {
            entries.min(most) * matrix_cache::BYTES as f64
        } else {
            0.0
        }
    }

    /// Bytes of a voxel for scattered light.
    fn glow(&self) -> f64 {
        if self.glows {
            BYTES_PER_VOXEL_THAT_GLOWS
        } else {
            0.0
        }
    }

    /// Floats of a row that the kernel runs along, on voxels so many times finer: slices, or rows of pixels where they are fewer.
    fn row(&self, factor: usize) -> usize {
        let slices = row_of(self.grid.shape[0] * factor);
        self.rows
            .map_or(slices, |rows| slices.min(row_of(rows).max(LANES)))
    }

    /// What the kernel runs along, in all columns of voxels.
    pub(crate) fn work(&self, factor: usize) -> f64 {
        let [_, ny, nx] = self.grid.shape.map(|n| n * factor);
        (self.row(factor) * ny * nx) as f64
    }

    fn lanes(&self, factor: usize) -> f64 {
        lanes(&self.grid.refined(factor))
    }

    /// Faces of one side of a cube of as many voxels as are evaluated.
    fn faces(&self) -> f64 {
        (self.grid.len() as f64 * self.refine.pow(3) as f64).powf(2.0 / 3.0)
    }

    /// Bytes of the pixels brought to the heights of the kernel, which the model keeps between calls.
    fn scratch(&self, factor: usize) -> f64 {
        (self.columns * self.row(factor) * 4) as f64
    }

    /// Bytes of the cotangent brought to the rows of pixels.
    fn of_rows(&self) -> f64 {
        let along_rows = self.work(1) < self.lanes(1);
        f64::from(u8::from(along_rows)) * self.work(1) * 4.0
    }

    /// Bytes of the finer voxels on which ceilings are judged.
    fn of_judged(&self) -> f64 {
        let judged = refinement::judged(&self.finest, self.judged_finer);
        let prints = self.species as f64;
        f64::from(u8::from(judged != self.finest)) * lanes(&judged) * prints * BYTES_PER_FINE_VOXEL
    }

    /// Memory of the optimization, MB: of the voxels, of the pixels, of frames at work.
    pub(crate) fn optimization(&self) -> [f64; 3] {
        let vectors = (2 * self.memory + VECTORS) as f64;
        // Each scenario's model is shown a copy, one after the other
        let shown = if self.scenarios > 0 { 2.0 } else { 0.0 };
        let patterns = self.active_pixels as f64 * 4.0 * (vectors + shown);
        let per_voxel = self.species as f64 * BYTES_PER_VOXEL
            + self.fields as f64 * BYTES_PER_VOXEL_OF_FIELDS
            + self.glow();
        // One entry for each patch of voxels and each frame, at least: larger voxels save most of them
        let entries = self.models() * self.cached_bytes.unwrap_or_default();
        [
            (lanes(&self.finest) * per_voxel + self.of_rows() + entries + self.of_judged()) / 1e6,
            (self.models() * (self.scratch(1) + self.bytes_of_walks()) + patterns) / 1e6,
            self.working_mb[0],
        ]
    }

    /// Memory of the evaluation, MB: of the voxels, of the pixels, of frames at work.
    pub(crate) fn evaluation(&self) -> [f64; 3] {
        let patterns = self.pixels as f64 * BYTES_PER_PIXEL;
        // Scenarios are measured one after the other, beside the job's prints
        let prints = self.species + usize::from(self.scenarios > 0);
        let per_voxel = prints as f64 * BYTES_PER_FINE_VOXEL + self.glow();
        let in_time = self.lanes(1) * self.in_time as f64 * BYTES_PER_VOXEL_OF_FIELDS;
        [
            (self.lanes(self.refine) * per_voxel + self.faces() * BYTES_PER_FACE + in_time) / 1e6,
            (self.scratch(self.refine) + patterns) / 1e6 + self.canvas_mb(),
            self.working_mb[1],
        ]
    }

    /// Triangles of a surface that the evaluation has memory for: the planned ones, and as many as the rest of the budget holds.
    pub(crate) fn most_triangles(&self, budget_mb: Option<u64>) -> usize {
        let Some(budget_mb) = budget_mb else {
            return usize::MAX;
        };
        let rest = 1e6 * (budget_mb as f64 - self.evaluation().iter().sum::<f64>() - BASE_MB);
        let bytes = rest.max(0.0) + self.faces() * BYTES_PER_FACE;
        (bytes / BYTES_PER_TRIANGLE) as usize
    }

    /// Memory of the levels of all canvases, which are made to be written, MB.
    pub(crate) fn canvas_mb(&self) -> f64 {
        self.canvas as f64 * BYTES_PER_CANVAS_PIXEL / 1e6
    }

    /// Memory of the optimization, MB.
    pub(crate) fn optimization_mb(&self) -> u64 {
        whole_mb(self.optimization())
    }

    /// Memory of the evaluation, MB.
    pub(crate) fn evaluation_mb(&self) -> u64 {
        whole_mb(self.evaluation())
    }

    /// Size of the run folder, MB.
    pub(crate) fn disk_mb(&self) -> u64 {
        let voxels = self.grid.len() as f64;
        let fine = voxels * self.refine.pow(3) as f64;
        let surface = self.faces() * BYTES_PER_FACE_ON_DISK
            + f64::from(u8::from(self.is_noisy)) * fine * BYTES_PER_NOISY_VOXEL_ON_DISK;
        let checkpoint = self.active_pixels as f64 * 4.0 * (2 * self.memory + VECTORS) as f64;
        let bytes = voxels * BYTES_PER_VOXEL_ON_DISK
            + surface
            + self.pixels as f64 * BYTES_PER_PIXEL_ON_DISK
            + (self.canvas * self.stacked) as f64
            + fine * self.bytes_evaluated as f64
            + voxels * self.bytes_of_volumes as f64
            + checkpoint;
        (BASE_ON_DISK_MB + bytes / 1e6) as u64
    }
}

/// Elements of a dose field.
fn lanes(grid: &VolumeGrid) -> f64 {
    let [nz, ny, nx] = grid.shape;
    (row_of(nz) * ny * nx) as f64
}

/// Memory of a stage with what every run needs, MB.
pub(crate) fn whole_mb(parts: [f64; 3]) -> u64 {
    (BASE_MB + parts.iter().sum::<f64>()) as u64
}

/// Rows of pixels at the heights of a grid, of the light that has the most of them; None where the kernel does not run along rows.
fn rows_beside(optics: &Optics, grid: &VolumeGrid) -> Option<usize> {
    let [bottom, top] = grid.bounds_mm().map(|corner| corner[2]);
    let rows = |light: &Light| {
        let [low, high] = light.pixels.field_mm().map(|corner| corner[1]);
        let height = high.min(top) - low.max(bottom);
        (height / light.pixels.pitch_mm[1]).ceil().max(0.0) as usize
    };
    let cost = optics
        .family(grid)
        .and_then(|family| family.cost(&optics.scene(), grid));
    let along_rows = cost.is_ok_and(|cost| cost.runs_along_rows);
    let most = || optics.lights.iter().map(rows).max();
    along_rows.then(most).flatten()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn extent() -> Extent {
        Extent {
            grid: VolumeGrid::centered([10, 10, 10], 0.1),
            finest: VolumeGrid::centered([10, 10, 10], 0.1),
            effort: 1.0,
            refine: 2,
            frames: 30,
            active_pixels: 500,
            pixels: 2000,
            columns: 600,
            rows: None,
            memory: 10,
            fields: 0,
            judged_finer: 1,
            judged_finer_asked: 1,
            in_time: 0,
            canvas: 0,
            cached_entries: None,
            cached_bytes: None,
            glows: false,
            stacked: 0,
            bytes_evaluated: 0,
            bytes_of_volumes: 0,
            is_noisy: false,
            scenarios: 0,
            species: 1,
            working_mb: [0.0; 2],
        }
    }

    #[test]
    fn memory_is_that_of_the_arrays() {
        let extent = extent();
        let lanes = row_of(10) as f64 * 100.0;
        let [voxels, pixels, _] = extent.optimization();
        assert!((voxels - lanes * 21.0 / 1e6).abs() < 1e-12);
        let scratch = 600.0 * row_of(10) as f64 * 4.0;
        // 2m + 4 = 24 vectors of f32
        assert!((pixels - (scratch + 500.0 * 4.0 * 24.0) / 1e6).abs() < 1e-12);
        assert_eq!(whole_mb([300.0, 4.5, 1.0]), 405);
        // Six rows of pixels: one vector, as ten slices need; of the three that forty need
        let along_rows = Extent {
            rows: Some(6),
            ..extent.clone()
        };
        assert_eq!(
            [1, 4].map(|f| along_rows.work(f) / extent.lanes(f)),
            [1.0, 1.0 / 3.0]
        );
        // 500 pixels of 10 voxel planes
        let keeping = Extent {
            cached_entries: Some(CachedEntries {
                per_pixel: 1.5,
                per_update: 1.0,
            }),
            cached_bytes: None,
            ..extent.clone()
        };
        let walks = keeping.optimization()[1] - pixels;
        assert!((walks - 500.0 * 1.5 * 10.0 * 16.0 / 1e6).abs() < 1e-12);
        // Two objectives with fields, and 4·10⁶ pixels of canvas that also go to a stack of two bytes each
        let larger = Extent {
            fields: 2,
            canvas: 4_000_000,
            stacked: 2,
            bytes_evaluated: 0,
            ..extent.clone()
        };
        assert!((larger.optimization()[0] - lanes * 45.0 / 1e6).abs() < 1e-12);
        assert!((larger.evaluation()[1] - extent.evaluation()[1] - 8.0).abs() < 1e-12);
        let glowing = Extent {
            glows: true,
            ..extent.clone()
        };
        assert!((glowing.optimization()[0] - lanes * 29.0 / 1e6).abs() < 1e-12);
        assert_eq!(larger.disk_mb(), extent.disk_mb() + 8);
        // 125 000 voxels, which triangles run through
        let [noisy, even] = [true, false].map(|is_noisy| Extent {
            grid: VolumeGrid::centered([50; 3], 0.1),
            refine: 1,
            is_noisy,
            ..extent.clone()
        });
        let more = noisy.disk_mb() - even.disk_mb();
        assert!((12..=13).contains(&more), "{more} MB");
        let with_volumes = Extent {
            bytes_of_volumes: 40,
            ..even.clone()
        };
        assert_eq!(with_volumes.disk_mb(), even.disk_mb() + 5);
    }
}
