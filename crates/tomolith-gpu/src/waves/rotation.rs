//! Samples of the light of frames → voxels that turn, and back.
//!
//! Formula: [`tomolith_core::dose::waves::Rotation`]. Both ways are gathers with one function for the weights, so they are one matrix: a voxel sums over the
//! samples that it sees; a sample sums over the voxels of the two strips, along and across, that may see it, row by row of voxels. Every element is one
//! thread's sum in one order.
//!
//! **Accuracy** Places of samples are affine in the indices of voxels. They are computed as whole numbers of 2⁻¹⁴ sample and an f32 rest below
//! 1000 of these, so a place of many thousand samples is right to 1e-8.
//!
//! **Cost** a thread has 16 voxels of a column, or 16 heights of a sample, and finds the weights for all of them.

use crate::device::{Buffer, Gpu};
use crate::passes::ENTRY;
use std::ops::Range;
use tomolith_core::dose::DoseLayout;
use tomolith_core::dose::waves::{Axis, PlaceTaps, Rotation};

/// Parts of a sample that a place is a whole number rotation.
const PARTS: f64 = 16384.0;
/// Products of four lanes in a dispatch at most: below 100 ms on a small card.
const MOST_PRODUCTS: usize = 1 << 30;
/// Lanes of a thread.
const LANES: usize = 16;

/// The turning voxels of one light.
pub(crate) struct DeviceRotation {
    gpu: Gpu,
    /// Of each azimuth the places of voxels: four vectors, see `met`.
    turns: Buffer,
    in_resin: Buffer,
    /// Weights along and across.
    tables: [Buffer; 2],
    /// Parameters that are the same for all frames.
    parameters: Vec<u32>,
    sub_angles: usize,
    columns: usize,
    row: usize,
    /// Depths and lateral samples.
    samples: [usize; 2],
    /// Samples that a voxel sees.
    taps: usize,
}

/// The frames of a batch: the first of the light's, and how many.
pub(crate) type Frames = Range<usize>;

impl DeviceRotation {
    pub(crate) fn new(gpu: &Gpu, rotation: &Rotation, output: &DoseLayout) -> Self {
        let grid = &output.grid;
        let [_, ny, nx] = grid.shape;
        let [along, across] = [&rotation.along, &rotation.across];
        let focus = rotation.focus;
        let turns: Vec<[u32; 16]> = (rotation.azimuths.iter())
            .map(|azimuth| {
                let (sin, cos) = azimuth.sin_cos();
                let (x, y, pitch) = (grid.x(0), grid.y(0), grid.pitch_mm);
                // Along: (d − focus)/step; the first sample comes off once the sign is gone
                let depth = [-(x * cos + y * sin) - focus, -pitch * cos, -pitch * sin];
                let u = [y * cos - x * sin - across.0.from, -pitch * sin, pitch * cos];
                let depth = depth.map(|mm| parts(mm / along.0.step));
                let u = u.map(|mm| parts(mm / across.0.step));
                let words = |all: [(i32, f32); 3], more: [f64; 2]| {
                    let more = more.map(|v| (v as f32).to_bits());
                    let [a, b, c] = all.map(|p| p.0 as u32);
                    let [d, e, f] = all.map(|p| p.1.to_bits());
                    [a, b, c, more[0], d, e, f, more[1]]
                };
                let mut all = [0; 16];
                all[..8].copy_from_slice(&words(depth, [cos, sin]));
                all[8..].copy_from_slice(&words(u, [0.0; 2]));
                all
            })
            .collect();
        let in_resin: Vec<u32> = rotation.in_resin.iter().map(|r| u32::from(*r)).collect();
        DeviceRotation {
            gpu: gpu.clone(),
            turns: gpu.upload(&turns),
            in_resin: gpu.upload(&in_resin),
            tables: [along, across].map(|(_, taps)| gpu.upload(&taps.tables.concat())),
            parameters: parameters(rotation, output),
            sub_angles: rotation.sub_angles,
            columns: nx * ny,
            row: output.row,
            samples: [along.0.count, across.0.count],
            taps: along.1.taps * across.1.taps,
        }
    }

    /// Whether places are small enough for whole parts of 32 bits.
    pub(crate) fn holds(rotation: &Rotation, output: &DoseLayout) -> bool {
        let grid = &output.grid;
        let [_, ny, nx] = grid.shape;
        let farthest = |first: f64, last: f64| first.abs().max(last.abs());
        let reach = farthest(grid.x(0), grid.x(nx - 1)).hypot(farthest(grid.y(0), grid.y(ny - 1)));
        let [along, across] = [&rotation.along.0, &rotation.across.0];
        let places = [
            (reach + rotation.focus.abs()) / along.step,
            (reach + across.from.abs()) / across.step,
        ];
        places
            .iter()
            .all(|place| place * PARTS < f64::from(i32::MAX) / 2.0)
    }

    /// Bytes of the largest array that all frames share.
    pub(crate) fn bytes(rotation: &Rotation) -> u64 {
        let turns = 64 * rotation.azimuths.len();
        turns.max(4 * rotation.in_resin.len()) as u64
    }

    /// Rows of samples of a frame.
    pub(crate) fn rows(&self) -> usize {
        self.samples[0] * self.samples[1]
    }

    /// Voxels of a piece of the dose += samples of frames.
    pub(crate) fn gather(
        &self,
        frames: &Frames,
        samples: &Buffer,
        columns: &Range<usize>,
        dose: &Buffer,
    ) {
        let of_column = frames.len() * self.sub_angles * self.taps * self.row / 4;
        let together = (MOST_PRODUCTS / of_column).max(1);
        for first in columns.clone().step_by(together) {
            let count = together.min(columns.end - first);
            let parameters = self.parameters_of([first, count], columns, frames);
            let buffers = self.buffers(dose, samples);
            self.run("light to voxels", &gather, &parameters, &buffers, count);
        }
    }

    /// Samples of frames += what the voxels of a piece ask of them.
    pub(crate) fn ask(
        &self,
        frames: &Frames,
        samples: &Buffer,
        columns: &Range<usize>,
        cotangent: &Buffer,
    ) {
        let rows = frames.len() * self.rows();
        // Half of the voxels that are looked at see the sample
        let of_row = 2 * self.columns * self.sub_angles * self.taps / self.rows().max(1) + 1;
        let together = (MOST_PRODUCTS / (of_row * self.row / 4).max(1)).max(1);
        for first in (0..rows).step_by(together) {
            let count = together.min(rows - first);
            let parameters = self.parameters_of([first, count], columns, frames);
            let buffers = self.buffers(samples, cotangent);
            self.run("voxels to light", &ask, &parameters, &buffers, count);
        }
    }

    fn parameters_of(
        &self,
        [first, count]: [usize; 2],
        columns: &Range<usize>,
        frames: &Frames,
    ) -> Vec<u32> {
        let place = [
            first,
            count,
            columns.start,
            columns.end,
            frames.start,
            frames.len(),
        ];
        let place = place.into_iter().map(|n| n as u32);
        place.chain(self.parameters.iter().copied()).collect()
    }

    fn buffers<'a>(&'a self, written: &'a Buffer, read: &'a Buffer) -> [&'a Buffer; 6] {
        let [along, across] = &self.tables;
        [written, read, &self.turns, &self.in_resin, along, across]
    }

    fn run(
        &self,
        name: &str,
        source: &dyn Fn() -> String,
        parameters: &[u32],
        buffers: &[&Buffer],
        rows: usize,
    ) {
        self.gpu
            .run(name, source, parameters, buffers, rows * self.row / LANES);
        self.gpu.submit();
    }
}

/// A place, or a way, in samples: whole parts of a sample, and the rest in parts.
fn parts(samples: f64) -> (i32, f32) {
    let whole = (samples * PARTS).round();
    (whole as i32, (samples * PARTS - whole) as f32)
}

fn parameters(rotation: &Rotation, output: &DoseLayout) -> Vec<u32> {
    let grid = &output.grid;
    let [_, ny, nx] = grid.shape;
    let taps_of = |(axis, taps): &(Axis, PlaceTaps)| {
        [
            axis.count,
            taps.taps,
            taps.tables.len() - 1,
            taps.last,
            usize::from(taps.is_turned),
        ]
    };
    let rows = rotation.along.1.tables[0].len() / rotation.along.1.taps - 1;
    let whole = [nx, ny, output.row / LANES, rotation.sub_angles, rows];
    let whole = whole
        .into_iter()
        .chain(taps_of(&rotation.along))
        .chain(taps_of(&rotation.across));
    let start = rotation.along.0.from / rotation.along.0.step;
    let (start_parts, start_rest) = parts(start);
    let numbers = [
        grid.x(0),
        grid.y(0),
        grid.pitch_mm,
        rotation.active / rotation.sub_angles as f64,
        rotation.attenuation,
        rotation.wall.unwrap_or(-1.0),
        rotation.entrance,
        start,
    ];
    whole
        .map(|n| n as u32)
        .chain(numbers.map(|v| (v as f32).to_bits()))
        .chain([start_parts as u32, start_rest.to_bits()])
        .collect()
}

/// Bindings, and what both kernels share.
fn head(written: &str, read: &str) -> String {
    format!(
        "struct Parameters {{
    first: u32, count: u32, begin: u32, end: u32, frame: u32, frames: u32,
    nx: u32, ny: u32, lanes: u32, subs: u32, rows: u32,
    depths: u32, along_taps: i32, along_lower: i32, along_last: i32, along_turned: u32,
    width: u32, across_taps: i32, across_lower: i32, across_last: i32, across_turned: u32,
    x: f32, y: f32, pitch: f32, active_part: f32, attenuation: f32, wall: f32, entrance: f32, start: f32,
    start_parts: i32, start_rest: f32
}}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read_write> {written}: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> {read}: array<vec4<f32>>;
// Of an azimuth: parts along for voxel 0, a step along x, along y, and cos; rests of these, and sin; the same across
@group(0) @binding(3) var<storage, read> turns: array<vec4<u32>>;
@group(0) @binding(4) var<storage, read> in_resin: array<u32>;
@group(0) @binding(5) var<storage, read> table_along: array<f32>;
@group(0) @binding(6) var<storage, read> table_across: array<f32>;
{}",
        include_str!("../shaders/places.wgsl")
    )
}

fn gather() -> String {
    format!(
        "{}{ENTRY}{}\n}}",
        head("dose", "samples"),
        include_str!("../shaders/light_to_voxels.wgsl")
    )
}

fn ask() -> String {
    format!(
        "{}{ENTRY}{}\n}}",
        head("samples", "cotangent"),
        include_str!("../shaders/voxels_to_light.wgsl")
    )
}
