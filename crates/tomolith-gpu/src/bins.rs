//! Pixels that are taken together to larger ones, and their transpose.
//!
//! Formula: [`tomolith_core::dose::scattered::Bins`]. Every pixel of a channel counts times the weight of its (frame, column).

use crate::device::{Buffer, Gpu};
use crate::field::GpuField;
use crate::mask::{IS_LIT, Mask};
use crate::passes::ENTRY;
use std::ops::Range;
use tomolith_core::dose::PatternLayout;
use tomolith_core::dose::scattered::{Bins, Share};

/// The bins of a light's pixels.
pub(crate) struct DeviceBins {
    /// Of each column, and of each row, of pixels the first bin and both parts; then of each of bins the first of its pixels and the one behind the last.
    columns: Buffer,
    rows: Buffer,
    /// Columns and rows of pixels.
    pixels: [usize; 2],
    /// Columns of bins, their lowest row, and rows.
    bins: [usize; 3],
    scale: f32,
    /// Of all channels.
    weights: Buffer,
    slots: usize,
}

/// The pixels of a light among those of all.
pub(crate) struct Pixels<'a> {
    pub(crate) field: &'a GpuField,
    /// [`table_of_runs`]
    pub(crate) runs: &'a Buffer,
    pub(crate) mask: &'a Mask,
}

/// Offset, lowest row, rows and frame of each column of pixels.
pub(crate) fn table_of_runs(gpu: &Gpu, layout: &PatternLayout) -> Buffer {
    let columns = layout.grid.columns.max(1);
    let of_runs = layout.runs.iter().enumerate();
    let table: Vec<[u32; 4]> = of_runs
        .map(|(i, run)| {
            [
                run.offset as u32,
                run.bottom,
                run.count,
                (i / columns) as u32,
            ]
        })
        .collect();
    gpu.upload(&table)
}

impl DeviceBins {
    /// Of pixels, the layout of their bins, and the weights of each channel.
    pub(crate) fn new(
        gpu: &Gpu,
        bins: &Bins,
        layout: &PatternLayout,
        weights: &[Vec<f32>],
    ) -> Self {
        let run = layout.runs.first().copied().unwrap_or_default();
        DeviceBins {
            columns: gpu.upload(&table(&bins.columns, layout.grid.columns)),
            rows: gpu.upload(&table(&bins.rows, layout.grid.rows)),
            pixels: [bins.columns.len(), bins.rows.len()],
            bins: [layout.grid.columns, run.bottom as usize, run.count as usize],
            scale: bins.scale,
            weights: gpu.upload(&weights.concat()),
            slots: weights.first().map_or(0, Vec::len),
        }
    }

    /// Bins of a frame.
    fn of_frame(&self) -> usize {
        self.bins[0] * self.bins[2]
    }

    /// What both kernels are told: of bins whose frames begin with this one, of pixels in this piece.
    fn parameters(
        &self,
        channel: usize,
        first_frame: usize,
        piece: &Range<usize>,
        pixels: &Pixels<'_>,
    ) -> Vec<u32> {
        let numbers = [
            self.pixels[0],
            self.pixels[1],
            self.bins[0],
            self.bins[1],
            self.bins[2],
            first_frame,
            piece.start,
            piece.end,
            channel * self.slots,
        ];
        let has_dark = u32::from(pixels.mask.has_dark);
        let scale = (self.scale * pixels.mask.factor).to_bits();
        (numbers.map(|n| n as u32).into_iter())
            .chain([has_dark, scale])
            .collect()
    }

    /// Bins of a channel, of all frames.
    pub(crate) fn fill(&self, gpu: &Gpu, channel: usize, pixels: &Pixels<'_>, bins: &GpuField) {
        for (bin_range, out) in bins.ranges().zip(bins.pieces()) {
            gpu.clear(out, 4 * bin_range.len() as u64);
            let first_frame = bin_range.start / self.of_frame().max(1);
            for (range, piece) in pixels.field.ranges().zip(pixels.field.pieces()) {
                let mut parameters = self.parameters(channel, first_frame, &range, pixels);
                parameters.push(bin_range.len() as u32);
                let buffers = [
                    out,
                    piece,
                    pixels.runs,
                    &self.columns,
                    &self.rows,
                    &self.weights,
                    &*pixels.mask.lit,
                ];
                gpu.run("fill bins", &fill, &parameters, &buffers, bin_range.len());
            }
        }
    }

    /// Pixels of some frames += transpose of [`fill`](Self::fill) on bins.
    pub(crate) fn add_back(
        &self,
        gpu: &Gpu,
        channel: usize,
        frames: &Range<usize>,
        bins: &GpuField,
        pixels: &Pixels<'_>,
    ) {
        for (bin_range, source) in bins.ranges().zip(bins.pieces()) {
            let of_frame = self.of_frame().max(1);
            let here = bin_range.start / of_frame..bin_range.end / of_frame;
            let frames = frames.start.max(here.start)..frames.end.min(here.end);
            if frames.is_empty() {
                continue;
            }
            for (range, piece) in pixels.field.ranges().zip(pixels.field.pieces()) {
                let mut parameters = self.parameters(channel, here.start, &range, pixels);
                let slots = frames.len() * self.pixels[0];
                parameters.extend([frames.start * self.pixels[0], slots].map(|n| n as u32));
                let buffers = [
                    piece,
                    source,
                    pixels.runs,
                    &self.columns,
                    &self.rows,
                    &self.weights,
                    &*pixels.mask.lit,
                ];
                let threads = slots * self.pixels[1];
                gpu.run("bins to pixels", &add_back, &parameters, &buffers, threads);
            }
        }
    }
}

/// The table of an axis, for shaders.
fn table(shares: &[Share], bins: usize) -> Vec<[u32; 4]> {
    let of_pixel = |share: &Share| {
        let [first, second] = share.parts.map(f32::to_bits);
        [share.bin, first, second, 0]
    };
    let of_bin = |bin: u32| {
        let first = shares.partition_point(|share| share.bin + 1 < bin);
        let end = shares.partition_point(|share| share.bin <= bin);
        [first as u32, end as u32, 0, 0]
    };
    let pixels = shares.iter().map(of_pixel);
    pixels.chain((0..bins as u32).map(of_bin)).collect()
}

fn head(fields: &str, written: &str, read: &str) -> String {
    format!(
        "struct Parameters {{
    columns: u32, rows: u32, bin_columns: u32, bottom: u32, bin_rows: u32, first_frame: u32,
    begin: u32, end: u32, weights: u32, has_dark: u32, scale: f32, {fields}
}}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read_write> {written}: array<f32>;
@group(0) @binding(2) var<storage, read> {read}: array<f32>;
// First element, lowest row, rows, frame
@group(0) @binding(3) var<storage, read> runs: array<vec4<u32>>;
@group(0) @binding(4) var<storage, read> of_columns: array<vec4<u32>>;
@group(0) @binding(5) var<storage, read> of_rows: array<vec4<u32>>;
@group(0) @binding(6) var<storage, read> weights: array<f32>;
@group(0) @binding(7) var<storage, read> lit: array<u32>;
{IS_LIT}"
    )
}

fn fill() -> String {
    let head = head("count: u32", "bins", "x");
    format!(
        "{head}
// The part of a pixel that a bin has
fn part(share: vec4<u32>, bin: u32) -> f32 {{
    return bitcast<f32>(select(share.z, share.y, share.x == bin));
}}
{ENTRY}
    let t = group * 256u + thread;
    if (t >= p.count) {{ return; }}
    let of_frame = p.bin_columns * p.bin_rows;
    let frame = p.first_frame + t / of_frame;
    let column = t % of_frame / p.bin_rows;
    let row = p.bottom + t % p.bin_rows;
    let columns = of_columns[p.columns + column];
    let rows = of_rows[p.rows + row];
    var sum = 0.0;
    for (var c = columns.x; c < columns.y; c++) {{
        let slot = frame * p.columns + c;
        let run = runs[slot];
        if (run.x < p.begin || run.x >= p.end) {{ continue; }}
        var of_column = 0.0;
        for (var r = max(rows.x, run.y); r < min(rows.y, run.y + run.z); r++) {{
            let element = run.x + r - run.y;
            if (is_lit(element)) {{ of_column += part(of_rows[r], row) * x[element - p.begin]; }}
        }}
        sum += part(of_columns[c], column) * weights[p.weights + slot] * of_column;
    }}
    bins[t] += p.scale * sum;
}}"
    )
}

fn add_back() -> String {
    let head = head("first_slot: u32, slots: u32", "x", "bins");
    format!(
        "{head}
// A column of bins from one side of a row
fn column_of(first: u32, row: vec4<u32>) -> f32 {{
    var sum = 0.0;
    if (row.y != 0u) {{ sum += bitcast<f32>(row.y) * bins[first + row.x - p.bottom]; }}
    if (row.z != 0u) {{ sum += bitcast<f32>(row.z) * bins[first + row.x + 1u - p.bottom]; }}
    return sum;
}}
{ENTRY}
    let t = group * 256u + thread;
    let slot = p.first_slot + t / p.rows;
    let r = t % p.rows;
    if (t / p.rows >= p.slots) {{ return; }}
    let run = runs[slot];
    if (run.x < p.begin || run.x >= p.end || r < run.y || r - run.y >= run.z) {{ return; }}
    let element = run.x + r - run.y;
    if (!is_lit(element)) {{ return; }}
    let row = of_rows[r];
    let column = of_columns[slot % p.columns];
    let first = ((run.w - p.first_frame) * p.bin_columns + column.x) * p.bin_rows;
    var sum = 0.0;
    if (column.y != 0u) {{ sum += bitcast<f32>(column.y) * column_of(first, row); }}
    if (column.z != 0u) {{ sum += bitcast<f32>(column.z) * column_of(first + p.bin_rows, row); }}
    x[element - p.begin] += p.scale * weights[p.weights + slot] * sum;
}}"
    )
}
