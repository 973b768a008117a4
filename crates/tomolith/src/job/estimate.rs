//! What a job will cost: memory, disk and time, before any work.
//!
//! Memory counts the arrays the method needs. Time is the rates of this machine ([`benchmark`](super::benchmark)) times what the job
//! asks for ([`Work::cost`]). An optimization that ends before its last iteration takes less.

use super::benchmark::{CallRates, Rates};
use super::build::Optics;
use super::outcome::duration;
use crate::field::LANES;
use crate::grid::VolumeGrid;
use crate::models::layout::row_of;
use crate::models::rays::matrix_cache::{self, CachedEntries};
use crate::optics::light::Light;
use crate::optimize::levels;
use crate::units::counted;

/// Dose, its change along a step, gradient (4 bytes each), inside fraction (4), labels (1), response (4 while metrics run).
const BYTES_PER_VOXEL: f64 = 21.0;
/// Dose turning and standing, the second also as what is derived from it (4 bytes each), labels and what metrics need at a
/// time: 10 to 11 bytes measured at 512³ and 800³.
const BYTES_PER_FINE_VOXEL: f64 = 12.0;
/// Voxels that the light of a pixel meets in a plane of voxels.
const VOXELS_PER_PLANE: f64 = 1.7;
/// Raw, quantized and as levels.
const BYTES_PER_PIXEL: f64 = 10.0;
/// Weight, lower and upper end of the band, where they differ from voxel to voxel.
const BYTES_PER_VOXEL_OF_FIELDS: f64 = 12.0;
/// What a voxel takes of scattered light where absorption is a map, and that light in a call.
const BYTES_PER_VOXEL_THAT_GLOWS: f64 = 8.0;
/// A level of a machine's canvas.
const BYTES_PER_CANVAS_PIXEL: f64 = 2.0;
/// What every run needs: the program, the report, one movie frame, …: 35 to 80 measured for the smallest jobs.
const BASE_MB: f64 = 50.0;
/// Bytes of the print's triangles and of the tree that measures distances, per face of a cube of as many voxels as are
/// evaluated: 500 to 3000 measured.
const BYTES_PER_FACE: f64 = 1000.0;
/// Bytes of a triangle of a print that is rough: its corners, its place in the tree that measures distances, the distances.
const BYTES_PER_TRIANGLE: f64 = 200.0;
/// Compressed size of a pattern value in the npz, the frames and the movie, beside 8 bytes of raw values.
const BYTES_PER_PIXEL_ON_DISK: f64 = 10.0;
/// Bytes of dose.npy (4) and dose.vti (9: dose, target, label) per voxel, and some more.
const BYTES_PER_VOXEL_ON_DISK: f64 = 20.0;
/// Bytes of print.stl and print.ply per face of a cube of as many voxels as are evaluated: the part has about twelve triangles (50
/// and 22.5 bytes each) where the cube has one voxel's face on each of its six sides.
const BYTES_PER_FACE_ON_DISK: f64 = 870.0;
/// Bytes of print.stl per voxel that is evaluated, where noise makes the dose cross the threshold in most of them: 1.7 triangles measured.
const BYTES_PER_NOISY_VOXEL_ON_DISK: f64 = 100.0;
/// Pattern vectors of an optimizer beside its memory of 2m.
const VECTORS: usize = 4;
/// Forward and adjoint calls beside those of the iterations: the start, its dose, the raw patterns' dose.
const OTHER_CALLS: f64 = 4.0;
/// Models made to judge: on the job's voxels for raw and for written patterns, on finer ones standing and turning.
const MODELS: f64 = 4.0;
/// What measuring a voxel of a thinned copy costs, times so many: for each voxel of the finer grid the metrics standing and
/// turning, the published numbers and the surface's file, at half the price, as it has less surface for its voxels; for each of
/// the job's own the metrics and files; for each pixel a PNG, a movie, its check and the arrays.
const MEASURES_PER_FINE_VOXEL: f64 = 1.2;
const MEASURES_PER_VOXEL: f64 = 2.4;
const MEASURES_PER_PIXEL: f64 = 1.8;
/// The same for each pixel of a machine's canvas: PNG, movie, its check, `frames.npz`.
const MEASURES_PER_CANVAS_PIXEL: f64 = 0.18;
/// Seconds that scenarios may take, and share of the memory, before that is worth a warning.
const LONG_S: f64 = 600.0;
const LARGE_MEMORY: f64 = 0.25;
/// Dose and target of a scenario, as objectives with fields.
pub(super) const FIELDS_PER_SCENARIO: usize = 2;
/// Passes over the dose of an iteration, the line search's included.
const PASSES: f64 = 5.0;

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
    /// Pixels whose light can meet the target, of all lights.
    pub(crate) active_pixels: usize,
    /// All pixels of all lights.
    pub(crate) pixels: usize,
    /// Columns of all frames of all lights.
    pub(crate) columns: usize,
    /// Most rows of a light beside the grid, where the kernel may run along them.
    pub(crate) rows: Option<usize>,
    /// The optimizer's memory m.
    pub(crate) memory: usize,
    /// Objectives whose weights or bands differ from voxel to voxel.
    pub(crate) fields: usize,
    /// Pixels of all frames on the machine's canvases, 0 without a machine.
    pub(crate) canvas: usize,
    /// The walks of its rays that the model keeps where they are few.
    pub(crate) cached_entries: Option<CachedEntries>,
    /// What else the model keeps, bytes, 0 where that is too much.
    pub(crate) cached_bytes: Option<f64>,
    /// Whether voxels take their own part of scattered light.
    pub(crate) glows: bool,
    /// Bytes of a canvas pixel in `frames.npz`, 0 when it is not written.
    pub(crate) stacked: usize,
    /// Bytes of a voxel of the evaluation in `evaluation/`, 0 when it is not written.
    pub(crate) bytes_evaluated: usize,
    /// Whether the dose is drawn at random, which makes the surface rough.
    pub(crate) is_noisy: bool,
    /// Scenarios beside the job: as many models more.
    pub(crate) scenarios: usize,
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
            light.pixels.frames() * lit(0, across).min(columns) * lit(1, along).min(rows)
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
            canvas: 0,
            cached_entries: None,
            cached_bytes: None,
            glows: optics.scene().scatters() && optics.lights.iter().any(|l| l.map.is_some()),
            stacked: 0,
            bytes_evaluated: 0,
            is_noisy: false,
            scenarios: 0,
            working_mb: [0.0; 2],
        }
    }

    /// The same without scenarios.
    fn of_the_job_alone(&self) -> Self {
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
    fn models(&self) -> f64 {
        1.0 + self.scenarios as f64
    }

    /// Bytes of walks that are kept: about 1.7 voxels of every voxel plane that a pixel's light crosses.
    fn bytes_of_walks(&self) -> f64 {
        let planes = self.finest.shape.iter().copied().max().unwrap_or(0) as f64;
        let ways = self.cached_entries.map_or(0.0, |walks| walks.per_pixel);
        let entries = self.active_pixels as f64 * ways * VOXELS_PER_PLANE * planes;
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
    fn work(&self, factor: usize) -> f64 {
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

    /// Memory of the optimization, MB: of the voxels, of the pixels, of frames at work.
    pub(crate) fn optimization(&self) -> [f64; 3] {
        let vectors = (2 * self.memory + VECTORS) as f64;
        // Each scenario's model is shown a copy, one after the other
        let shown = if self.scenarios > 0 { 2.0 } else { 0.0 };
        let patterns = self.active_pixels as f64 * 4.0 * (vectors + shown);
        let per_voxel =
            BYTES_PER_VOXEL + self.fields as f64 * BYTES_PER_VOXEL_OF_FIELDS + self.glow();
        // One entry for each patch of voxels and each frame, at least: larger voxels save most of them
        let entries = self.models() * self.cached_bytes.unwrap_or_default();
        [
            (lanes(&self.finest) * per_voxel + self.of_rows() + entries) / 1e6,
            (self.models() * (self.scratch(1) + self.bytes_of_walks()) + patterns) / 1e6,
            self.working_mb[0],
        ]
    }

    /// Memory of the evaluation, MB: of the voxels, of the pixels, of frames at work.
    pub(crate) fn evaluation(&self) -> [f64; 3] {
        let patterns = self.pixels as f64 * BYTES_PER_PIXEL;
        [
            (self.lanes(self.refine) * (BYTES_PER_FINE_VOXEL + self.glow())
                + self.faces() * BYTES_PER_FACE)
                / 1e6,
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
            + checkpoint;
        (10.0 + bytes / 1e6) as u64
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

/// Rows of pixels beside a grid, of the light that has the most of them; None where the kernel does not run along rows.
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

/// What a job asks for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Work<'a> {
    pub(crate) extent: &'a Extent,
    /// The most iterations there will be.
    pub(crate) iterations: usize,
    /// Angles at which a frame of the optimization and of the evaluation is averaged.
    pub(crate) sub_angles: [f64; 2],
    /// Monte Carlo paths of the evaluation for each of the optimization, where light is followed along such.
    pub(crate) monte_carlo_paths: Option<usize>,
    /// Whether patterns are improved on few levels afterwards.
    pub(crate) levels: bool,
    /// Limit of the optimization's time, s.
    pub(crate) wall_s: Option<f64>,
}

/// How long it will take, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cost {
    /// The optimization, when no iteration is saved.
    pub(crate) optimization_s: f64,
    /// Everything else: sampling, evaluation, files.
    pub(crate) rest_s: f64,
}

/// Angles at which a frame is averaged, mean over the frames of all lights.
pub(crate) fn mean_sub_angles(lights: &[Light]) -> f64 {
    let frames = lights.iter().map(|light| light.pixels.frames());
    let angles = lights
        .iter()
        .map(|light| light.pixels.frames() * light.sub_angles);
    angles.sum::<usize>() as f64 / frames.sum::<usize>().max(1) as f64
}

impl Work<'_> {
    /// Dose calls of the evaluation.
    fn evaluation_s(&self, rates: &Rates) -> f64 {
        let refine = self.extent.refine;
        let CallRates {
            dose,
            updates_per_frame,
            ..
        } = rates.evaluating;
        let updates = updates_per_frame * self.extent.frames as f64;
        if let Some(more) = self.monte_carlo_paths {
            // On the job's voxels raw, written, and twice for the noise; on finer ones, which a path crosses more of,
            // standing and turning
            return more as f64 * (4.0 + 2.0 * refine as f64) * dose.seconds(updates);
        }
        // Raw and written on the job's voxels, standing and turning on finer ones
        let [own, turning] = self.sub_angles;
        let tried = self.extent.work(rates.evaluating_refine);
        let calls = 2.0 * own * self.extent.work(1) + (1.0 + turning) * self.extent.work(refine);
        4.0 * dose.begin_s + calls / tried * updates * dose.per_update_s
    }

    /// A dose of the evaluation, vial turning: that of a scenario.
    fn turning_s(&self, rates: &Rates) -> f64 {
        let CallRates {
            dose,
            updates_per_frame,
            ..
        } = rates.evaluating;
        let updates = updates_per_frame * self.extent.frames as f64;
        let share =
            self.extent.work(self.extent.refine) / self.extent.work(rates.evaluating_refine);
        dose.begin_s + self.sub_angles[1] * share * updates * dose.per_update_s
    }

    /// What scenarios cost, in words; whether it is much, with a budget of so many MB.
    pub(crate) fn of_scenarios(
        &self,
        rates: &Rates,
        budget_mb: Option<u64>,
    ) -> Option<(String, bool)> {
        let count = self.extent.scenarios;
        if count == 0 {
            return None;
        }
        let extent = &self.extent.of_the_job_alone();
        let alone = Work { extent, ..*self }.cost(rates);
        let all = self.cost(rates);
        let [seconds, alone_s] = [all, alone].map(|cost| cost.optimization_s + cost.rest_s);
        let [memory_mb, alone_mb] = [self.extent, extent].map(Extent::optimization_mb);
        let more_mb = memory_mb.saturating_sub(alone_mb);
        let text = format!(
            "{}: an iteration computes {} doses in place of one; with them the run takes {} in place of {}, its optimization {memory_mb} MB in place of {alone_mb} MB",
            counted(count, "scenario"),
            count + 1,
            duration(seconds),
            duration(alone_s)
        );
        let is_large =
            budget_mb.is_some_and(|budget| more_mb as f64 > LARGE_MEMORY * budget as f64);
        Some((text, seconds - alone_s > LONG_S || is_large))
    }

    /// Rates times work.
    pub(crate) fn cost(&self, rates: &Rates) -> Cost {
        let Work {
            extent, iterations, ..
        } = *self;
        let own = self.sub_angles[0];
        let (voxels, finer) = (extent.grid.len() as f64, extent.refine.pow(3) as f64);
        let frames = extent.frames as f64;
        let [model_s, first_s, dose_s, adjoint_s] = seconds(&rates.calls, frames);
        let [evaluate_s, ..] = seconds(&rates.evaluating, frames);
        let vectors = extent.active_pixels as f64 * rates.vector_s;
        // Finer voxels and more angles are more updates of a call; what begins it, and the pixels, are the same
        let of_levels =
            |all_s: f64, begin_s: f64| begin_s + extent.effort * (all_s - begin_s).max(0.0);
        let step_s = own
            * (rates.doses_per_step * of_levels(dose_s, rates.calls.dose.begin_s)
                + of_levels(adjoint_s, rates.calls.adjoint.begin_s))
            + extent.effort * PASSES * rates.objective_s
            + (4 * extent.memory + VECTORS) as f64 * vectors;
        let optimization_s = (iterations as f64 * step_s).min(self.wall_s.unwrap_or(f64::INFINITY))
            + extent.models() * (OTHER_CALLS * own * dose_s + first_s + model_s)
            + if self.levels {
                let [doses, adjoints] = levels::CALLS.map(|calls| calls as f64);
                own * (doses * dose_s + adjoints * adjoint_s)
            } else {
                0.0
            };
        let measures = voxels * (MEASURES_PER_FINE_VOXEL * finer + MEASURES_PER_VOXEL)
            + extent.pixels as f64 * MEASURES_PER_PIXEL
            + extent.canvas as f64 * MEASURES_PER_CANVAS_PIXEL;
        Cost {
            optimization_s,
            rest_s: (MODELS + extent.scenarios as f64) * evaluate_s
                + self.evaluation_s(rates)
                + extent.scenarios as f64 * self.turning_s(rates)
                + measures * rates.measuring_s
                + voxels * (finer + 1.0) * rates.sampling_s,
        }
    }
}

/// Seconds to make a model, of its first call beyond others, of a dose and of an adjoint.
fn seconds(rates: &CallRates, frames: f64) -> [f64; 4] {
    let updates = rates.updates_per_frame * frames;
    [rates.making, rates.first, rates.dose, rates.adjoint].map(|rate| rate.seconds(updates))
}

#[cfg(test)]
mod tests {
    use super::super::benchmark::CallRate;
    use super::*;

    fn extent() -> Extent {
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
            canvas: 0,
            cached_entries: None,
            cached_bytes: None,
            glows: false,
            stacked: 0,
            bytes_evaluated: 0,
            is_noisy: false,
            scenarios: 0,
            working_mb: [0.0; 2],
        }
    }

    fn rates() -> Rates {
        let rate = |begin_s, per_update_s| CallRate {
            begin_s,
            per_update_s,
        };
        Rates {
            model: String::new(),
            calls: CallRates {
                updates_per_frame: 100.0,
                making: rate(0.25, 1e-4),
                first: rate(0.05, 2e-3),
                dose: rate(0.5, 1e-3),
                adjoint: rate(0.1, 5e-4),
            },
            evaluating: CallRates {
                updates_per_frame: 200.0,
                making: rate(0.5, 1e-3),
                first: rate(7.0, 7.0),
                dose: rate(1.0, 1e-3),
                adjoint: rate(7.0, 7.0),
            },
            doses_per_step: 1.0,
            evaluating_refine: 1,
            objective_s: 0.01,
            vector_s: 1e-5,
            sampling_s: 1e-3,
            measuring_s: 2e-3,
        }
    }

    #[test]
    fn time_is_work_times_rates() {
        let extent = extent();
        let work = Work {
            extent: &extent,
            iterations: 7,
            sub_angles: [1.0, 4.0],
            monte_carlo_paths: None,
            levels: false,
            wall_s: None,
        };
        let cost = work.cost(&rates());
        // A dose: 30 frames of 100 updates at 1000/s, and ½ s = 3.5 s; an adjoint: at 2000/s, and 0.1 s. A step: both, 5
        // passes, 44 vectors of 500 pixels. The first dose takes 6.05 s more,
        // and making the model 0.55 s
        let step = 3.5 + 1.6 + 5.0 * 0.01 + 44.0 * 500.0 * 1e-5;
        assert!(
            (cost.optimization_s - (7.0 * step + 4.0 * 3.5 + 6.05 + 0.55)).abs() < 1e-9,
            "{cost:?}"
        );
        // A dose to judge by: 30 frames of 200 updates at 1000/s, 6 s, and 1 s to begin with; twice on the own voxels, standing and
        // turning (1 + 4 angles) on eight times as many: 4·1 + (2 + 5·8)·6 = 256 s. Making its model takes 6.5 s, four times; 1.2
        // measures of each fine voxel, 2.4 of the own grid's, 1.8 of each pixel; both grids sampled
        let measures = 1000.0 * (1.2 * 8.0 + 2.4) + 1.8 * 2000.0;
        let rest = 256.0 + measures * 2e-3 + 9.0 * 1000.0 * 1e-3 + 4.0 * 6.5;
        assert!((cost.rest_s - rest).abs() < 1e-9, "{cost:?}");
        // Monte Carlo paths: sixteen times as many, six times on the job's voxels' worth of four and two finer ones
        let paths = Work {
            monte_carlo_paths: Some(16),
            ..work
        }
        .cost(&rates());
        assert!((paths.rest_s - rest - (16.0 * 8.0 * 7.0 - 256.0)).abs() < 1e-9);
        // Averaged frames cost as many calls; a limit of the wall time cuts the iterations, not the rest
        let averaged = Work {
            sub_angles: [3.0, 4.0],
            ..work
        }
        .cost(&rates());
        assert!(
            (averaged.optimization_s - cost.optimization_s - 2.0 * (7.0 * 5.1 + 4.0 * 3.5)).abs()
                < 1e-9
        );
        // Three times the updates: of a dose 3 s, of an adjoint 1.5 s, and the passes over the dose; not what begins a call, nor the pixels
        let finer = Extent {
            effort: 3.0,
            ..extent.clone()
        };
        let finer = Work {
            extent: &finer,
            ..work
        }
        .cost(&rates());
        let more = finer.optimization_s - cost.optimization_s;
        assert!(
            (more - 7.0 * 2.0 * (3.0 + 1.5 + 0.05)).abs() < 1e-9,
            "{more}"
        );
        // A scenario: three times the effort and models of the optimization, and of the evaluation two models (6.5 s) and two doses on
        // the finer voxels, at 4 angles of 48 s and 1 s to begin with
        let scenarios = Extent {
            scenarios: 2,
            effort: 3.0,
            fields: 4,
            ..extent.clone()
        };
        let beside = Work {
            extent: &scenarios,
            ..work
        };
        let more = beside.cost(&rates());
        let begun = 2.0 * (4.0 * 3.5 + 6.05 + 0.55);
        assert!((more.optimization_s - finer.optimization_s - begun).abs() < 1e-9);
        assert!((more.rest_s - rest - 2.0 * (6.5 + 1.0 + 4.0 * 48.0)).abs() < 1e-9);
        let (text, is_much) = beside.of_scenarios(&rates(), Some(1000)).unwrap();
        assert!(
            text.starts_with("2 scenarios: an iteration computes 3 doses"),
            "{text}"
        );
        let long = Work {
            iterations: 100,
            ..beside
        };
        assert!(!is_much && long.of_scenarios(&rates(), None).unwrap().1);
        assert_eq!(work.of_scenarios(&rates(), None), None);
        let limited = Work {
            wall_s: Some(1.0),
            ..work
        }
        .cost(&rates());
        assert_eq!(
            (limited.optimization_s, limited.rest_s),
            (1.0 + 4.0 * 3.5 + 6.05 + 0.55, cost.rest_s)
        );
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
        assert_eq!(whole_mb([300.0, 4.5, 1.0]), 355);
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
            cached_entries: Some(CachedEntries::SINGLE),
            cached_bytes: None,
            ..extent.clone()
        };
        let walks = keeping.optimization()[1] - pixels;
        assert!((walks - 500.0 * 1.7 * 10.0 * 16.0 / 1e6).abs() < 1e-12);
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
    }
}
