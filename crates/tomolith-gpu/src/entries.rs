//! The matrix of strips on the card: found there, and multiplied with lanes.
//!
//! A *chunk* is the views whose entries fit a binding. Its matrix is there twice, each time as rows of (column, weight): the voxels' rows with
//! slots as columns, and the slots' rows with voxels as columns. Both are found from the strips by the same formula
//! ([`tomolith_core::dose::strips`]), so dose and adjoint are the same matrix but for the rounding of a weight. A pass counts the entries of
//! every row, the host adds the counts up, and another pass writes them. Entries are stored where memory allows; else only the counts are, and every
//! call writes the entries anew.

use crate::device::{Buffer, Gpu, THREADS};
use crate::passes::ENTRY;
use std::ops::Range;
use std::sync::OnceLock;
use tomolith_core::dose::strips::{LightStrips, StripGeometry};
use tomolith_core::error::Result;

/// The strips of one light on the card, and what says where they are.
pub(crate) struct DeviceStrips {
    strips: Buffer,
    beams: Buffer,
    meetings: Buffer,
    resin_rows: Buffer,
    tiles: Buffer,
    tile_count: usize,
    beam_count: usize,
    /// First beam of each view.
    beams_of: Vec<u32>,
    /// Strips of the slots, in their order, with their axis; and the first of each slot.
    by_slot: Buffer,
    slots: Buffer,
    is_pure_radon: bool,
    columns: usize,
    voxels: [usize; 2],
}

pub(crate) struct Rows {
    count: usize,
    /// First entry of each row, and the one behind the last.
    starts: Buffer,
    entries: Option<Buffer>,
    total: u64,
}

/// Some neighboring views of a light and their matrix.
pub(crate) struct Chunk {
    pub(crate) views: Range<usize>,
    by_voxel: Rows,
    /// Found when the first adjoint asks for it: an evaluation never does.
    by_slot: OnceLock<Rows>,
    /// Whether entries are stored.
    keeps: bool,
}

const ENTRY_BYTES: u64 = 8;

#[derive(Clone, Copy, PartialEq)]
enum Axis {
    Voxels,
    Slots,
}

impl DeviceStrips {
    pub(crate) fn new(gpu: &Gpu, geometry: &StripGeometry, light: &LightStrips) -> Self {
        let beams: Vec<[u32; 4]> = (light.beams.iter())
            .map(|beam| {
                let first_slot = beam.view * light.columns as u32;
                [
                    beam.strips[0],
                    first_slot,
                    u32::from(beam.along_y),
                    beam.view,
                ]
            })
            .collect();
        let beams_of = (0..=light.views as u32)
            .map(|view| light.beams.partition_point(|beam| beam.view < view) as u32)
            .collect();
        let (by_slot, slots) = strips_of_slots(light);
        let tiles: Vec<[u32; 4]> = (geometry.tiles.iter())
            .map(|tile| [tile.start[0], tile.start[1], tile.size[0], tile.size[1]])
            .collect();
        let [_, ny, nx] = geometry.output.grid.shape;
        DeviceStrips {
            strips: gpu.upload(&light.strips),
            beams: gpu.upload(&beams),
            meetings: gpu.upload(&light.meetings),
            resin_rows: gpu.upload(&light.resin_rows.concat()),
            tiles: gpu.upload(&tiles),
            tile_count: tiles.len(),
            beam_count: beams.len(),
            beams_of,
            by_slot: gpu.upload(&by_slot),
            slots: gpu.upload(&slots),
            is_pure_radon: light.is_pure_radon,
            columns: light.columns,
            voxels: [nx, ny],
        }
    }

    /// Cuts the views into chunks, of which no buffer is larger than a binding, and counts their entries; also the pairs of voxel and beam.
    pub(crate) fn chunks(
        &self,
        gpu: &Gpu,
        views: usize,
        bytes_of_view: u64,
    ) -> Result<(Vec<Chunk>, u64)> {
        let most = gpu.binding_bytes();
        let [nx, ny] = self.voxels;
        // A voxel meets some three strips of a view
        let guess = (3 * ENTRY_BYTES * (nx * ny) as u64)
            .max(bytes_of_view)
            .max(1);
        let mut step = ((most / guess) as usize).clamp(1, views.max(1));
        let (mut chunks, mut pairs) = (Vec::new(), 0);
        let mut begin = 0;
        while begin < views {
            gpu.check()?;
            let range = begin..(begin + step).min(views);
            let (by_voxel, lit) = self.counted(gpu, &range, Axis::Voxels);
            // Those of the slots are as many, but for the rounding of weights to 0
            if by_voxel.bytes() > most / 100 * 99 && range.len() > 1 {
                step = range.len().div_ceil(2);
                continue;
            }
            begin = range.end;
            pairs += lit;
            chunks.push(Chunk {
                views: range,
                by_voxel,
                by_slot: OnceLock::new(),
                keeps: false,
            });
        }
        Ok((chunks, pairs))
    }

    fn row_count(&self, views: &Range<usize>, axis: Axis) -> usize {
        match axis {
            Axis::Voxels => self.voxels[0] * self.voxels[1],
            Axis::Slots => views.len() * self.columns,
        }
    }

    fn counted(&self, gpu: &Gpu, views: &Range<usize>, axis: Axis) -> (Rows, u64) {
        let count = self.row_count(views, axis);
        let counts = gpu.buffer(8 * count as u64);
        self.pass(gpu, views, axis, &[&counts]);
        let found: Vec<u32> =
            bytemuck::pod_collect_to_vec(&gpu.read(&[(&counts, 8 * count as u64)]));
        let mut starts = Vec::with_capacity(count + 1);
        let (mut total, mut pairs) = (0u64, 0u64);
        for row in found.chunks_exact(2) {
            starts.push(total as u32);
            total += u64::from(row[0]);
            pairs += u64::from(row[1]);
        }
        starts.push(total as u32);
        let rows = Rows {
            count,
            starts: gpu.upload(&starts),
            entries: None,
            total,
        };
        (rows, pairs)
    }

    /// Writes the entries of some views, and stores them.
    fn keep(&self, gpu: &Gpu, views: &Range<usize>, axis: Axis, rows: &mut Rows) {
        let into = gpu.buffer(rows.bytes());
        self.written(gpu, views, axis, rows, &into);
        rows.entries = Some(into);
    }

    /// Writes the entries of a chunk's voxels or slots.
    fn written(&self, gpu: &Gpu, views: &Range<usize>, axis: Axis, rows: &Rows, into: &Buffer) {
        self.pass(gpu, views, axis, &[&rows.starts, into]);
    }

    /// Counts entries, or writes them where there are two buffers.
    fn pass(&self, gpu: &Gpu, views: &Range<usize>, axis: Axis, out: &[&Buffer]) {
        let writes = out.len() == 2;
        let [nx, ny] = self.voxels;
        let first_slot = views.start * self.columns;
        let beams = [views.start, views.end].map(|view| self.beams_of[view]);
        let rows = self.row_count(views, axis);
        let pure = u32::from(self.is_pure_radon);
        let parameters = [
            beams[0],
            beams[1],
            self.beam_count as u32,
            first_slot as u32,
            nx as u32,
            ny as u32,
            pure,
            self.tile_count as u32,
            rows as u32,
        ];
        let mut buffers = vec![&self.strips, &self.resin_rows];
        let (name, threads) = match axis {
            Axis::Voxels => {
                buffers.extend([&self.beams, &self.meetings, &self.tiles]);
                ("voxels", self.tile_count * THREADS as usize)
            }
            Axis::Slots => {
                buffers.extend([&self.by_slot, &self.slots]);
                ("slots", rows)
            }
        };
        buffers.extend(out);
        let name = format!(
            "{} entries of {name}",
            if writes { "write" } else { "count" }
        );
        gpu.run(
            &name,
            &|| source(axis, writes),
            &parameters,
            &buffers,
            threads,
        );
        gpu.submit();
    }
}

/// Of each slot its strips, each with its axis, and the first of each slot.
fn strips_of_slots(light: &LightStrips) -> (Vec<[u32; 2]>, Vec<u32>) {
    let slots = light.views * light.columns;
    let mut starts = vec![0u32; slots + 1];
    let each = || {
        light.beams.iter().flat_map(|beam| {
            let strips = beam.strips[0]..beam.strips[1];
            strips.map(move |i| {
                let strip = &light.strips[i as usize];
                let slot = beam.view as usize * light.columns + strip.column as usize;
                (slot, [i, u32::from(beam.along_y)])
            })
        })
    };
    for (slot, _) in each() {
        starts[slot + 1] += 1;
    }
    for i in 1..starts.len() {
        starts[i] += starts[i - 1];
    }
    let mut next = starts.clone();
    let mut by_slot = vec![[0u32; 2]; light.strips.len()];
    for (slot, entry) in each() {
        by_slot[next[slot] as usize] = entry;
        next[slot] += 1;
    }
    (by_slot, starts)
}

/// Products with the rows of a chunk.
pub(crate) struct Product<'a> {
    pub(crate) strips: &'a DeviceStrips,
    pub(crate) chunk: &'a Chunk,
    /// Where entries are written that are not stored.
    pub(crate) scratch: &'a Option<Buffer>,
    /// Vectors of four lanes.
    pub(crate) lanes: usize,
}

/// A piece of an array of rows of lanes: its buffer, its first row and the one behind its last, and vectors of four from row to row.
pub(crate) struct RowsOf<'a> {
    pub(crate) buffer: &'a Buffer,
    pub(crate) rows: Range<usize>,
    pub(crate) stride: usize,
}

impl<'a> RowsOf<'a> {
    pub(crate) fn new(buffer: &'a Buffer, rows: Range<usize>, stride: usize) -> Self {
        RowsOf {
            buffer,
            rows,
            stride,
        }
    }
}

/// Entries of a submission, times vectors of lanes: below 100 ms on a small card.
const MOST_PRODUCTS: u64 = 1 << 31;

impl Product<'_> {
    /// Makes the entries of voxels or slots ready.
    pub(crate) fn entries(&self, gpu: &Gpu, of_voxels: bool) {
        let axis = if of_voxels { Axis::Voxels } else { Axis::Slots };
        let rows = self.rows(gpu, of_voxels);
        if let (None, Some(into)) = (&rows.entries, self.scratch) {
            self.strips
                .written(gpu, &self.chunk.views, axis, rows, into);
        }
    }

    fn rows(&self, gpu: &Gpu, of_voxels: bool) -> &Rows {
        let chunk = self.chunk;
        if of_voxels {
            return &chunk.by_voxel;
        }
        chunk.by_slot.get_or_init(|| {
            let (mut rows, _) = self.strips.counted(gpu, &chunk.views, Axis::Slots);
            if chunk.keeps {
                self.strips.keep(gpu, &chunk.views, Axis::Slots, &mut rows);
            }
            rows
        })
    }

    /// out += rows·source, of the rows of a piece of `out` and the columns in a piece of the source.
    pub(crate) fn add(&self, gpu: &Gpu, of_voxels: bool, out: &RowsOf<'_>, source: &RowsOf<'_>) {
        let rows = self.rows(gpu, of_voxels);
        let Some(entries) = rows.entries.as_ref().or(self.scratch.as_ref()) else {
            return;
        };
        // Long products are cut, so that a submission ends soon
        let per_row = rows.total / rows.count.max(1) as u64 + 1;
        let together = (MOST_PRODUCTS / (per_row * self.lanes as u64)).max(1) as usize;
        for begin in out.rows.clone().step_by(together) {
            let count = together.min(out.rows.end - begin);
            let parameters = [
                count as u32,
                self.lanes as u32,
                begin as u32,
                (begin - out.rows.start) as u32,
                out.stride as u32,
                source.stride as u32,
                source.rows.start as u32,
                source.rows.end as u32,
            ];
            let buffers = [out.buffer, source.buffer, &rows.starts, entries];
            let threads = count * self.lanes;
            gpu.run("product", &product, &parameters, &buffers, threads);
            gpu.submit();
        }
    }
}

impl Chunk {
    /// Bytes of the entries of its voxels, and somewhat more than those of its slots.
    pub(crate) fn bytes(&self) -> u64 {
        self.by_voxel.bytes() / 99 * 100
    }

    pub(crate) fn keep(&mut self, gpu: &Gpu, strips: &DeviceStrips) {
        self.keeps = true;
        strips.keep(gpu, &self.views, Axis::Voxels, &mut self.by_voxel);
    }
}

impl Rows {
    fn bytes(&self) -> u64 {
        ENTRY_BYTES * self.total
    }
}

fn product() -> String {
    format!(
        "struct Parameters {{ rows: u32, lanes: u32, first: u32, place: u32, out_stride: u32, stride: u32, begin: u32, end: u32 }}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read_write> out: array<vec4<f32>>;
@group(0) @binding(2) var<storage, read> source: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read> starts: array<u32>;
@group(0) @binding(4) var<storage, read> entries: array<vec2<u32>>;
{ENTRY}
    let t = group * 256u + thread;
    let row = t / p.lanes;
    let lane = t % p.lanes;
    if (row >= p.rows) {{ return; }}
    let to = (p.place + row) * p.out_stride + lane;
    let end = starts[p.first + row + 1u];
    var sum = out[to];
    for (var e = starts[p.first + row]; e < end; e++) {{
        let entry = entries[e];
        if (entry.x >= p.begin && entry.x < p.end) {{
            sum += bitcast<f32>(entry.y) * source[(entry.x - p.begin) * p.stride + lane];
        }}
    }}
    out[to] = sum;
}}"
    )
}

/// What a strip gives to a row of voxels, and to a voxel of it.
const WEIGHTS: &str = include_str!("shaders/strip_weights.wgsl");

fn source(axis: Axis, writes: bool) -> String {
    let (bindings, body) = match axis {
        Axis::Voxels => (
            include_str!("shaders/voxel_bindings.wgsl"),
            include_str!("shaders/entries_of_voxels.wgsl"),
        ),
        Axis::Slots => (
            include_str!("shaders/slot_bindings.wgsl"),
            include_str!("shaders/entries_of_slots.wgsl"),
        ),
    };
    let first = if axis == Axis::Voxels { 6 } else { 5 };
    let outputs = if writes {
        format!(
            "@group(0) @binding({first}) var<storage, read> starts: array<u32>;
@group(0) @binding({}) var<storage, read_write> entries: array<vec2<u32>>;
var<private> next: u32;
fn begin(row: u32) {{ next = starts[row]; }}
fn emit(column: u32, weight: f32) {{ entries[next] = vec2(column, bitcast<u32>(weight)); next++; }}
fn end_beam(is_met: bool) {{}}
fn finish(row: u32) {{}}",
            first + 1
        )
    } else {
        format!(
            "@group(0) @binding({first}) var<storage, read_write> counts: array<vec2<u32>>;
var<private> counted: vec2<u32>;
fn begin(row: u32) {{ counted = vec2(0u); }}
fn emit(column: u32, weight: f32) {{ counted.x++; }}
fn end_beam(is_met: bool) {{ if (is_met) {{ counted.y++; }} }}
fn finish(row: u32) {{ counts[row] = counted; }}"
        )
    };
    format!("{bindings}\n{WEIGHTS}\n{outputs}\n{ENTRY}\n{body}\n}}")
}
