//! Dose models of light in strips, computed on the card.
//!
//! **Model** [`tomolith_core::dose::strips`]: what the `parallel` model of the processor gives of its geometry. Pixels are spread over the lanes of their
//! slot, multiplied with the entries of a chunk of views ([`entries`](crate::entries)), and added to the dose; the adjoint goes back the same way. What is
//! scattered out of this light is added by [`scattered`](crate::scattered).
//!
//! **Cost** per dose or adjoint: an entry is read once and used for all lanes of a row; lanes are read once an entry, mostly from the card's
//! caches. Memory in addition to fields: strips (48 bytes each), the lanes of a chunk, and 16 bytes an entry where entries are stored.

use crate::bins::{Pixels, table_of_runs};
use crate::device::{Buffer, Gpu};
use crate::entries::{Chunk, DeviceStrips, Product, RowsOf};
use crate::field::GpuField;
use crate::mask::Mask;
use crate::passes::ENTRY;
use crate::scattered::{DeviceScattered, voxels_of};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::scattered::ScatteredLight;
use tomolith_core::dose::strips::{LightStrips, StripForm, StripGeometry, Taps};
use tomolith_core::dose::{DoseLayout, DoseModel, Facts, PatternLayout, Space, Work, ZCoupling};
use tomolith_core::error::{Error, Result};

/// The geometry of a model on the card.
struct Geometry {
    strips: Arc<StripGeometry>,
    lights: Vec<DeviceLight>,
    /// Where entries are written that are not stored.
    scratch: Option<Buffer>,
    entry_bytes: u64,
    updates: u64,
    scattered: Vec<DeviceScattered>,
}

struct DeviceLight {
    strips: DeviceStrips,
    chunks: Vec<Chunk>,
    /// Offset, lowest row, rows and frame of each column of pixels.
    runs: Buffer,
    slot_of: Buffer,
    /// The columns of pixels of each slot.
    sources: Buffer,
    to_lanes: DeviceTaps,
    to_rows: DeviceTaps,
    spread: Option<[DeviceTaps; 2]>,
    lanes: usize,
    views: usize,
    columns: usize,
    frames: usize,
}

struct DeviceTaps {
    first: Buffer,
    weights: Buffer,
    taps: usize,
    count: usize,
}

impl DeviceTaps {
    fn new(gpu: &Gpu, taps: &Taps) -> Self {
        DeviceTaps {
            first: gpu.upload(&taps.first),
            weights: gpu.upload(&taps.weights.concat()),
            taps: taps.weights.len(),
            count: taps.first.len(),
        }
    }
}

/// A dose model whose fields are on a graphics card.
#[derive(Clone)]
pub(crate) struct GpuStrips {
    gpu: Gpu,
    geometry: Arc<Geometry>,
    mask: Mask,
}

impl Geometry {
    fn new(gpu: &Gpu, geometry: &Arc<StripGeometry>, work: &Work) -> Result<Self> {
        let mut lights = Vec::new();
        let mut pairs = 0;
        for (light, layout) in geometry.lights.iter().zip(&geometry.patterns) {
            let (device_light, of_light) = DeviceLight::new(gpu, geometry, light, layout)?;
            lights.push(device_light);
            pairs += of_light;
            work.check()?;
        }
        let chunks = || lights.iter().flat_map(|light| &light.chunks);
        let all: u64 = chunks().map(|chunk| 2 * chunk.bytes()).sum();
        let mut scratch = None;
        if all <= gpu.stored_bytes() {
            for light in &mut lights {
                for chunk in &mut light.chunks {
                    chunk.keep(gpu, &light.strips);
                }
            }
        } else {
            let largest = chunks().map(Chunk::bytes).max().unwrap_or(0);
            scratch = Some(gpu.buffer(largest));
        }
        let scattered_of = |light: &ScatteredLight| {
            let pixels = &geometry.patterns[light.light];
            DeviceScattered::new(gpu, light, pixels, geometry.output.row, work)
        };
        let scattered = geometry
            .scattered
            .iter()
            .map(scattered_of)
            .collect::<Result<Vec<_>>>()?;
        gpu.check()?;
        let of_scattered = scattered.iter().map(DeviceScattered::updates);
        Ok(Geometry {
            strips: geometry.clone(),
            lights,
            scratch,
            entry_bytes: all,
            updates: pairs * geometry.output.grid.shape[0] as u64 + of_scattered.sum::<u64>(),
            scattered,
        })
    }
}

impl DeviceLight {
    fn new(
        gpu: &Gpu,
        geometry: &StripGeometry,
        light: &LightStrips,
        layout: &PatternLayout,
    ) -> Result<(Self, u64)> {
        let lanes = light.to_lanes.first.len().div_ceil(4);
        let strips = DeviceStrips::new(gpu, geometry, light);
        let bytes_of_view = (light.columns * lanes * 16) as u64;
        let (chunks, pairs) = strips.chunks(gpu, light.views, bytes_of_view)?;
        let mut slot_of = vec![0u32; layout.runs.len()];
        for (slot, sides) in light.sources.iter().enumerate() {
            for run in sides.iter().flatten() {
                slot_of[*run as usize] = slot as u32;
            }
        }
        let sources: Vec<[u32; 2]> = (light.sources.iter())
            .map(|sides| sides.map(|run| run.unwrap_or(u32::MAX)))
            .collect();
        let spread = light.spread.as_ref();
        let device_light = DeviceLight {
            strips,
            chunks,
            runs: table_of_runs(gpu, layout),
            slot_of: gpu.upload(&slot_of),
            sources: gpu.upload(&sources),
            to_lanes: DeviceTaps::new(gpu, &light.to_lanes),
            to_rows: DeviceTaps::new(gpu, &light.to_rows),
            spread: spread.map(|taps| taps.each_ref().map(|taps| DeviceTaps::new(gpu, taps))),
            lanes,
            views: light.views,
            columns: layout.grid.columns,
            frames: layout.grid.frames(),
        };
        Ok((device_light, pairs))
    }

    /// Frames that light views of a chunk: some in a row, from each side.
    fn frames_of(&self, views: &Range<usize>) -> impl Iterator<Item = Range<usize>> {
        let (begin, end, count) = (views.start, views.end, self.views);
        (0..self.frames / count.max(1)).map(move |side| side * count + begin..side * count + end)
    }
}

impl GpuStrips {
    /// The model of a form on a card.
    /// Refuses a slice or a frame that does not fit a binding.
    pub(crate) fn new(gpu: &Gpu, form: &StripForm, work: &Work) -> Result<Self> {
        must_fit(gpu, &form.geometry)?;
        let geometry = gpu.shared(
            |geometry: &Geometry| Arc::ptr_eq(&geometry.strips, &form.geometry),
            || Geometry::new(gpu, &form.geometry, work),
        )?;
        Ok(GpuStrips {
            gpu: gpu.clone(),
            geometry,
            mask: Mask::new(gpu, form),
        })
    }

    /// The scattered part of a light, and the light's pixels in a field.
    fn scattered<'a>(
        &'a self,
        light: usize,
        field: &'a GpuField,
    ) -> impl Iterator<Item = (&'a DeviceScattered, Pixels<'a>)> {
        let of_light = move |scattered: &&DeviceScattered| scattered.light == light;
        let scattered = self.geometry.scattered.iter().filter(of_light);
        scattered.map(move |scattered| {
            let pixels = Pixels {
                field,
                runs: &self.geometry.lights[light].runs,
                mask: &self.mask,
            };
            (scattered, pixels)
        })
    }

    fn output(&self) -> &DoseLayout {
        &self.geometry.strips.output
    }

    /// Rows of voxels in each piece of a dose.
    fn voxels_of<'a>(
        &self,
        dose: &'a GpuField,
    ) -> impl Iterator<Item = (Range<usize>, &'a Buffer)> {
        let row = self.output().row;
        let ranges = dose.ranges().map(move |r| r.start / row..r.end / row);
        ranges.zip(dose.pieces())
    }

    /// Pixels of some frames → lanes of the slots of a chunk.
    fn expand(
        &self,
        light: &DeviceLight,
        chunk: &Chunk,
        frames: &Range<usize>,
        x: &GpuField,
        lanes: &Buffer,
    ) {
        let slots = chunk.views.len() * light.columns;
        self.gpu.clear(lanes, (16 * slots * light.lanes) as u64);
        for (range, piece) in x.ranges().zip(x.pieces()) {
            let parameters = [
                slots as u32,
                4 * light.lanes as u32,
                (chunk.views.start * light.columns) as u32,
                light.to_lanes.taps as u32,
                range.start as u32,
                range.end as u32,
                frames.start as u32,
                frames.end as u32,
                light.to_lanes.count as u32,
                u32::from(self.mask.has_dark),
                self.mask.factor.to_bits(),
            ];
            let taps = &light.to_lanes;
            let buffers = [
                lanes,
                piece,
                &light.runs,
                &light.sources,
                &taps.first,
                &taps.weights,
                &*self.mask.lit,
            ];
            let threads = 4 * slots * light.lanes;
            self.gpu
                .run("expand", &expand, &parameters, &buffers, threads);
        }
    }

    /// Lanes of the slots of a chunk → pixels of some frames.
    fn collect(
        &self,
        light: &DeviceLight,
        chunk: &Chunk,
        frames: &Range<usize>,
        lanes: &Buffer,
        grad: &GpuField,
    ) {
        let rows = light.to_rows.count.max(1);
        for span in light.frames_of(&chunk.views) {
            let span = span.start.max(frames.start)..span.end.min(frames.end);
            if span.is_empty() {
                continue;
            }
            for (range, piece) in grad.ranges().zip(grad.pieces()) {
                let runs = span.len() * light.columns;
                let parameters = [
                    runs as u32,
                    rows as u32,
                    (span.start * light.columns) as u32,
                    (chunk.views.start * light.columns) as u32,
                    range.start as u32,
                    range.end as u32,
                    light.to_rows.taps as u32,
                    light.to_lanes.count as u32,
                    4 * light.lanes as u32,
                    u32::from(self.mask.has_dark),
                    self.mask.factor.to_bits(),
                ];
                let taps = &light.to_rows;
                let buffers = [
                    piece,
                    lanes,
                    &light.runs,
                    &light.slot_of,
                    &taps.first,
                    &taps.weights,
                    &*self.mask.lit,
                ];
                self.gpu
                    .run("collect", &collect, &parameters, &buffers, runs * rows);
            }
        }
    }

    /// out += taps of source, row by row, of which each has so many numbers in `source`.
    fn resample(&self, taps: &DeviceTaps, out: &RowsOf<'_>, source: &RowsOf<'_>, sources: usize) {
        let rows = out.rows.len();
        let parameters = [
            rows as u32,
            taps.count as u32,
            4 * out.stride as u32,
            4 * source.stride as u32,
            taps.taps as u32,
            sources as u32,
        ];
        let buffers = [out.buffer, source.buffer, &taps.first, &taps.weights];
        let threads = rows * taps.count;
        self.gpu
            .run("resample", &resample, &parameters, &buffers, threads);
    }

    fn product<'a>(&'a self, light: &'a DeviceLight, chunk: &'a Chunk) -> Product<'a> {
        Product {
            strips: &light.strips,
            chunk,
            scratch: &self.geometry.scratch,
            lanes: light.lanes,
        }
    }

    /// Lanes of the largest chunk of a light.
    fn lanes_of(&self, light: &DeviceLight) -> Buffer {
        let slots = |chunk: &Chunk| chunk.views.len() * light.columns;
        let most = light.chunks.iter().map(slots).max().unwrap_or(0);
        self.gpu.buffer((16 * most * light.lanes) as u64)
    }

    fn add_light(
        &self,
        light: &DeviceLight,
        frames: &Range<usize>,
        x: &GpuField,
        dose: &GpuField,
        work: &Work,
    ) -> Result<()> {
        let lanes = self.lanes_of(light);
        let row = self.output().row;
        let rows = self.voxels_of(dose);
        let temporary: Vec<Option<Buffer>> = rows
            .map(|(voxels, _)| self.rows_buffer(light, voxels.len()))
            .collect();
        for chunk in self.chunks_of(light, frames) {
            work.check()?;
            self.gpu.check()?;
            let product = self.product(light, chunk);
            product.entries(&self.gpu, true);
            self.expand(light, chunk, frames, x, &lanes);
            let slots = chunk.views.len() * light.columns;
            let source = RowsOf::new(&lanes, 0..slots, light.lanes);
            for ((voxels, piece), temporary) in self.voxels_of(dose).zip(&temporary) {
                let stride = temporary.as_ref().map_or(row / 4, |_| light.lanes);
                let out = RowsOf::new(temporary.as_ref().unwrap_or(piece), voxels, stride);
                product.add(&self.gpu, true, &out, &source);
            }
        }
        if let Some([to_slices, _]) = &light.spread {
            for ((voxels, piece), temporary) in self.voxels_of(dose).zip(&temporary) {
                let Some(temporary) = temporary else { continue };
                let source = RowsOf::new(temporary, voxels.clone(), light.lanes);
                let out = RowsOf::new(piece, voxels, row / 4);
                self.resample(to_slices, &out, &source, light.to_lanes.count);
            }
        }
        Ok(())
    }

    /// Rows of lanes of so many voxels, dark, where lanes are not slices.
    fn rows_buffer(&self, light: &DeviceLight, voxels: usize) -> Option<Buffer> {
        light.spread.as_ref().map(|_| {
            let bytes = (16 * voxels * light.lanes) as u64;
            self.gpu.zeros(bytes)
        })
    }

    fn chunks_of<'a>(
        &self,
        light: &'a DeviceLight,
        frames: &'a Range<usize>,
    ) -> impl Iterator<Item = &'a Chunk> {
        light.chunks.iter().filter(move |chunk| {
            let mut ranges = light.frames_of(&chunk.views);
            ranges.any(|range| range.start < frames.end && frames.start < range.end)
        })
    }

    fn adjoint_light(
        &self,
        light: &DeviceLight,
        frames: &Range<usize>,
        cotangent: &GpuField,
        grad: &GpuField,
        work: &Work,
    ) -> Result<()> {
        let lanes = self.lanes_of(light);
        let row = self.output().row;
        let of_rows: Vec<Option<Buffer>> = (self.voxels_of(cotangent))
            .map(|(voxels, piece)| {
                let rows = self.rows_buffer(light, voxels.len())?;
                let [_, to_rows] = light.spread.as_ref()?;
                let out = RowsOf::new(&rows, voxels.clone(), light.lanes);
                let source = RowsOf::new(piece, voxels, row / 4);
                self.resample(to_rows, &out, &source, self.output().grid.shape[0]);
                Some(rows)
            })
            .collect();
        for chunk in self.chunks_of(light, frames) {
            work.check()?;
            self.gpu.check()?;
            let product = self.product(light, chunk);
            product.entries(&self.gpu, false);
            let slots = chunk.views.len() * light.columns;
            self.gpu.clear(&lanes, (16 * slots * light.lanes) as u64);
            let out = RowsOf::new(&lanes, 0..slots, light.lanes);
            for ((voxels, piece), of_rows) in self.voxels_of(cotangent).zip(&of_rows) {
                let stride = of_rows.as_ref().map_or(row / 4, |_| light.lanes);
                let source = RowsOf::new(of_rows.as_ref().unwrap_or(piece), voxels, stride);
                product.add(&self.gpu, false, &out, &source);
            }
            self.collect(light, chunk, frames, &lanes, grad);
        }
        Ok(())
    }
}

/// A binding must hold the lanes of a view and those of a few voxels.
fn must_fit(gpu: &Gpu, geometry: &StripGeometry) -> Result<()> {
    let of_lanes = |light: &LightStrips| 16 * light.to_lanes.first.len().div_ceil(4) as u64;
    let row = 4 * geometry.output.row as u64;
    let views = geometry
        .lights
        .iter()
        .map(|light| light.columns as u64 * of_lanes(light));
    let frames = geometry
        .patterns
        .iter()
        .map(|p| 4 * (p.grid.rows * p.grid.columns) as u64);
    let meetings = geometry
        .lights
        .iter()
        .map(|light| 4 * light.meetings.len() as u64);
    let strips = geometry
        .lights
        .iter()
        .map(|light| 48 * light.strips.len() as u64);
    let needed = views
        .chain(frames)
        .chain(meetings)
        .chain(strips)
        .chain([row])
        .max();
    let advice = "fewer angles, rows or columns";
    must_be_bound(gpu, needed.unwrap_or(0), advice)
}

/// A binding must hold so many bytes; `advice` takes fewer.
pub(crate) fn must_be_bound(gpu: &Gpu, needed: u64, advice: &str) -> Result<()> {
    let most = gpu.binding_bytes();
    if needed <= most {
        return Ok(());
    }
    Err(Error::Resources {
        what: format!(
            "memory that a kernel of {} sees at once",
            gpu.adapter().name
        ),
        needed_mb: needed.div_ceil(1_000_000),
        available_mb: Some(most / 1_000_000),
        advice: format!("use the processor (--device cpu), or {advice}"),
    })
}

impl GpuStrips {
    /// The elements of Aᵀ c of some frames.
    pub(crate) fn collect_frames(
        &self,
        frames: &Range<usize>,
        cotangent: &GpuField,
        grad: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        for (light, light_frames) in
            tomolith_core::dose::own_frames(&self.geometry.strips.patterns, frames)
        {
            let of_light = &self.geometry.lights[light];
            self.adjoint_light(of_light, &light_frames, cotangent, grad, work)?;
            for (scattered, pixels) in self.scattered(light, grad) {
                let voxels = voxels_of(cotangent, self.output().row);
                scattered.add_adjoint(&light_frames, &voxels, &pixels, work)?;
            }
        }
        self.gpu.submit();
        self.gpu.check()
    }
}

impl DoseModel for GpuStrips {
    type Field = GpuField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.geometry.strips.patterns,
            outputs: std::slice::from_ref(&self.geometry.strips.output),
            z_coupling: if self.geometry.scattered.is_empty() {
                ZCoupling::None
            } else {
                ZCoupling::Full
            },
            is_linear: true,
        }
    }

    fn new_field(&self, space: Space) -> Result<GpuField> {
        GpuField::of_space(
            &self.gpu,
            space,
            &self.geometry.strips.patterns,
            self.output(),
        )
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &GpuField,
        dose: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        for (light, light_frames) in
            tomolith_core::dose::own_frames(&self.geometry.strips.patterns, &frames)
        {
            self.add_light(&self.geometry.lights[light], &light_frames, x, dose, work)?;
            for (scattered, pixels) in self.scattered(light, x) {
                let voxels = voxels_of(dose, self.output().row);
                scattered.add(&light_frames, &pixels, &voxels, work)?;
            }
        }
        self.gpu.submit();
        self.gpu.check()
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &GpuField,
        cotangent: &GpuField,
        grad: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        self.collect_frames(&frames, cotangent, grad, work)
    }

    fn updates(&self) -> u64 {
        self.geometry.updates
    }

    fn describe(&self) -> String {
        let entries = if self.geometry.scratch.is_some() {
            "found anew"
        } else {
            "kept"
        };
        let place = self.gpu.with(self.geometry.entry_bytes, "weights");
        let straight = format!("parallel ({place}, {entries})");
        let scattered = self.geometry.scattered.iter();
        let scattered: Vec<&str> = scattered.map(|light| &*light.summary).collect();
        if scattered.is_empty() {
            return straight;
        }
        format!(
            "successive_orders ({straight}; scattered light on {})",
            scattered.join(" and ")
        )
    }
}

fn expand() -> String {
    format!(
        "{}\n{ENTRY}\n{}\n}}",
        include_str!("shaders/expand_bindings.wgsl"),
        include_str!("shaders/expand.wgsl")
    )
}

fn collect() -> String {
    format!(
        "{}\n{ENTRY}\n{}\n}}",
        include_str!("shaders/collect_bindings.wgsl"),
        include_str!("shaders/collect.wgsl")
    )
}

fn resample() -> String {
    format!(
        "struct Parameters {{ rows: u32, count: u32, out_stride: u32, stride: u32, taps: u32, sources: u32 }}
@group(0) @binding(0) var<uniform> p: Parameters;
@group(0) @binding(1) var<storage, read_write> out: array<f32>;
@group(0) @binding(2) var<storage, read> source: array<f32>;
@group(0) @binding(3) var<storage, read> first: array<u32>;
@group(0) @binding(4) var<storage, read> weights: array<f32>;
{ENTRY}
    let t = group * 256u + thread;
    let row = t / p.count;
    let i = t % p.count;
    if (row >= p.rows) {{ return; }}
    var sum = 0.0;
    for (var tap = 0u; tap < p.taps; tap++) {{
        let k = first[i] + tap;
        if (k < p.sources) {{ sum += weights[tap * p.count + i] * source[row * p.stride + k]; }}
    }}
    out[row * p.out_stride + i] += sum;
}}"
    )
}
