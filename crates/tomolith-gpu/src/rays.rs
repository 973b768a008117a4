//! Dose models of rays, computed on the card.
//!
//! **Model** [`tomolith_core::dose::rays`]: what the `rays` model of the processor gives of its light. A thread follows the segments of one pixel from voxel to
//! voxel, with the formulas of the processor (`rays/traversal` of the crate of models). Dose and adjoint are two visitors of the same walk, so they are one matrix.
//! What is scattered out of these rays is added by [`scattered`](crate::scattered), whose light on cells is that of rays weighted by a harmonic of their direction. Light inside of a surface that cuts voxels goes to the inside cells; what an element has is then multiplied by one over its share.
//!
//! **Sums** The adjoint sums along the rays of its pixel, in their order. In the dose many rays meet in a voxel at once, and sums of f32 would depend on
//! their order. So deposits are whole multiples of a unit, added to 64 bits a voxel by two atomic sums of 32 (the upper one only where the lower carries):
//! the same bits in every run. The unit is a power of two, 2⁻³⁰ of the largest deposit that any pixel could leave, to twice that. A deposit is rounded by
//! half a unit and 2³³ of them fit, so nothing overflows, and a dose of n deposits is wrong by some √n·2⁻³¹ of the largest.
//!
//! **Cost** two sums and some sixty operations for a voxel that a segment passes; segments (40 bytes each) are read once a dose, from the caches
//! where all frames share them. Memory in addition to fields: segments, 8 bytes a voxel during a dose, and as many with cells.

use crate::bins::{Pixels, table_of_runs};
use crate::device::{Buffer, Gpu};
use crate::field::GpuField;
use crate::mask::{IS_LIT, Mask};
use crate::passes::{ENTRY, Operand, Pass};
use crate::scattered::{DeviceScattered, voxels_of};
use crate::strips::must_be_bound;
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::rays::{LightRays, RayForm, RayGeometry, RaySegment};
use tomolith_core::dose::scattered::{DirectionHarmonic, ScatteredLight};
use tomolith_core::dose::{DoseLayout, DoseModel, Facts, PatternLayout, Space, Work, own_frames};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;

/// Voxels that the rays of a submission pass, about: below 100 ms on a small card.
const MOST_PASSED: u64 = 1 << 27;
/// Rounds of its loops that a thread may take: Mesa's software adapter ends it after 65,535, and says nothing. A voxel takes four.
const MOST_ROUNDS: usize = 1 << 15;
const ROUNDS: usize = 4;

/// The geometry of a model on the card.
pub(crate) struct Geometry {
    data: Arc<RayGeometry>,
    lights: Vec<DeviceLight>,
    bytes: u64,
    /// The largest of a segment, for a pixel of value 1.
    energy: f32,
    /// The element of each voxel that takes the light inside of a surface; nothing where none cuts voxels.
    inside: Buffer,
    /// One over the share of its voxel that each element has, where any are cut.
    weights: Option<GpuField>,
    scattered: Vec<DeviceScattered>,
}

struct DeviceLight {
    /// Offset, lowest row, rows and frame of each column of pixels.
    runs: Buffer,
    /// Turns of all frames, one at least.
    turns: usize,
    /// Those of a frame.
    exposures: usize,
    is_shared: bool,
    /// Rows of pixels in a column, and segments of a pixel in a frame, at most.
    rows: usize,
    deepest: usize,
    chunks: Vec<Chunk>,
}

/// The segments of some columns: of every frame where all frames share them, else counted through all frames.
struct Chunk {
    columns: Range<usize>,
    /// The first pixel with segments here, and behind the turns the first segment of each.
    first_pixel: usize,
    starts: Buffer,
    segments: Buffer,
}

/// A dose model whose fields are on a graphics card.
pub(crate) struct GpuRays {
    gpu: Gpu,
    geometry: Arc<Geometry>,
    mask: Mask,
}

impl Geometry {
    fn new(gpu: &Gpu, data: &Arc<RayGeometry>, work: &Work) -> Result<Self> {
        let segments = || data.lights.iter().flat_map(|light| &light.segments);
        let bytes = (segments().count() * size_of::<RaySegment>()) as u64;
        must_be_stored(gpu, bytes)?;
        let mut lights = Vec::new();
        for (light, layout) in data.lights.iter().zip(&data.patterns) {
            work.check()?;
            let frame = 4 * (layout.grid.rows * layout.grid.columns) as u64;
            must_be_bound(gpu, frame, "fewer rows or columns")?;
            lights.push(DeviceLight::new(gpu, light, layout)?);
        }
        let energy = segments().fold(0.0f32, |most, segment| most.max(segment.energy.abs()));
        let (mut inside, mut weights) = (Vec::new(), None);
        if let Some(cells) = &data.output.cells {
            must_be_bound(gpu, 4 * data.output.voxels() as u64, "fewer voxels")?;
            inside.extend(0..data.output.voxels() as u32);
            for (cell, (voxel, _)) in (inside.len() as u32..).zip(cells.iter()) {
                inside[voxel] = cell;
            }
            let mut field = GpuField::for_dose(gpu, &data.output);
            let shares = cells.shares(data.output.len());
            field.copy_from_host(&shares.iter().map(|s| s.recip()).collect::<Vec<f32>>());
            weights = Some(field);
        }
        let scattered = |light: &ScatteredLight| {
            let pixels = &data.patterns[light.light];
            DeviceScattered::new(gpu, light, pixels, data.output.row, work)
        };
        let scattered = data.scattered.iter().map(scattered);
        let scattered = scattered.collect::<Result<_>>()?;
        gpu.check()?;
        Ok(Geometry {
            data: data.clone(),
            lights,
            bytes,
            energy,
            inside: gpu.upload(&inside),
            weights,
            scattered,
        })
    }
}

/// Segments are stored between calls.
fn must_be_stored(gpu: &Gpu, bytes: u64) -> Result<()> {
    let most = gpu.stored_bytes();
    if bytes <= most {
        return Ok(());
    }
    Err(Error::Resources {
        what: format!("memory for rays on {}", gpu.adapter().name),
        needed_mb: bytes.div_ceil(1_000_000),
        available_mb: Some(most / 1_000_000),
        advice:
            "use the processor (--device cpu), or fewer angles, pixels or model.rays.rays_per_pixel"
                .to_owned(),
    })
}

impl DeviceLight {
    fn new(gpu: &Gpu, light: &LightRays, layout: &PatternLayout) -> Result<Self> {
        let still = vec![[1.0, 0.0]];
        let turns = light.turns.as_ref().unwrap_or(&still);
        let exposures = (turns.len() / layout.grid.frames().max(1)).max(1);
        Ok(DeviceLight {
            runs: table_of_runs(gpu, layout),
            turns: turns.len(),
            exposures,
            is_shared: light.turns.is_some(),
            deepest: exposures
                * light
                    .starts
                    .windows(2)
                    .map(|pair| pair[1] - pair[0])
                    .max()
                    .unwrap_or(0) as usize,
            rows: (layout.runs.iter())
                .map(|run| run.count as usize)
                .max()
                .unwrap_or(0),
            chunks: chunks(gpu, light, turns, layout)?,
        })
    }

    /// The slots of a chunk that belong to some frames.
    fn slots(&self, chunk: &Chunk, frames: &Range<usize>, columns: usize) -> Range<usize> {
        let columns_here = &chunk.columns;
        if self.is_shared {
            return frames.start * columns_here.len()..frames.end * columns_here.len();
        }
        let of_frames = frames.start * columns..frames.end * columns;
        columns_here.start.max(of_frames.start)..columns_here.end.min(of_frames.end)
    }
}

/// Columns of pixels in chunks whose segments fit a binding.
fn chunks(
    gpu: &Gpu,
    light: &LightRays,
    turns: &[[f32; 2]],
    layout: &PatternLayout,
) -> Result<Vec<Chunk>> {
    let (rows, all) = match light.turns {
        Some(_) => (Some(layout.grid.rows), layout.grid.columns),
        None => (None, layout.runs.len()),
    };
    let pixels = |columns: Range<usize>| match rows {
        Some(rows) => columns.start * rows..columns.end * rows,
        None => {
            let elements = layout.elements_of_columns(columns);
            elements.start - layout.offset..elements.end - layout.offset
        }
    };
    let segments = |columns: Range<usize>| {
        let Range { start, end } = pixels(columns);
        light.starts[start] as usize..light.starts[end] as usize
    };
    let bytes = |columns: Range<usize>| {
        let starts = 4 * (2 * turns.len() + pixels(columns.clone()).len() + 1);
        starts.max(segments(columns).len() * size_of::<RaySegment>()) as u64
    };
    let (mut chunks, mut begin) = (Vec::new(), 0);
    while begin < all {
        must_be_bound(gpu, bytes(begin..begin + 1), "fewer rays per pixel")?;
        // The most columns that fit
        let fitting =
            (begin + 1..all).take_while(|&end| bytes(begin..end + 1) <= gpu.binding_bytes());
        let columns = begin..begin + 1 + fitting.count();
        let (segments, pixels) = (segments(columns.clone()), pixels(columns.clone()));
        let mut starts: Vec<u32> = turns.as_flattened().iter().map(|v| v.to_bits()).collect();
        let from_first = |start: &u32| start - segments.start as u32;
        starts.extend(
            light.starts[pixels.start..=pixels.end]
                .iter()
                .map(from_first),
        );
        begin = columns.end;
        chunks.push(Chunk {
            columns,
            first_pixel: pixels.start,
            starts: gpu.upload(&starts),
            segments: gpu.upload(&light.segments[segments]),
        });
    }
    Ok(chunks)
}

/// Fields that light goes between: pieces of patterns and of voxels (or cells).
pub(crate) struct Walk<'a> {
    pub(crate) name: &'static str,
    pub(crate) source: &'a dyn Fn() -> String,
    pub(crate) patterns: &'a GpuField,
    /// The voxels, and x and y of their lowest corner, in voxels from the axis of the vial.
    pub(crate) output: &'a DoseLayout,
    pub(crate) corner: [f32; 2],
    /// One or two buffers of each piece of a dose.
    pub(crate) voxels: Vec<(Range<usize>, Vec<&'a Buffer>)>,
    /// Of the values of pixels.
    pub(crate) scale: f32,
    /// Whether what pixels get is added to what they have.
    pub(crate) adds: bool,
    /// What binding 5 is, and the numbers behind those of all kernels.
    pub(crate) table: &'a Buffer,
    pub(crate) numbers: Vec<u32>,
    /// Voxels that all light passes, about: what submissions are cut by.
    pub(crate) updates: u64,
    /// Ways through the voxels, or cells, that the light of a segment takes, about.
    pub(crate) ways: usize,
}

impl GpuRays {
    /// The model of a form on a card.
    /// Refuses rays that do not fit the card, and a column or a frame that does not fit a binding.
    pub(crate) fn new(gpu: &Gpu, form: &RayForm, work: &Work) -> Result<Self> {
        let geometry = gpu.shared(
            |known: &Geometry| Arc::ptr_eq(&known.data, &form.geometry),
            || Geometry::new(gpu, &form.geometry, work),
        )?;
        Ok(GpuRays {
            gpu: gpu.clone(),
            geometry,
            mask: Mask::new(gpu, form),
        })
    }

    /// Follows the rays of some frames of a light.
    pub(crate) fn follow(
        &self,
        light: usize,
        frames: &Range<usize>,
        walk: &Walk<'_>,
        work: &Work,
    ) -> Result<()> {
        let layout = &self.geometry.data.patterns[light];
        let (device, all) = (
            &self.geometry.lights[light],
            layout.runs.len().max(1) as u64,
        );
        let most = (MOST_PASSED / (walk.updates / all + 1)).max(1) as usize;
        for chunk in &device.chunks {
            let slots = device.slots(chunk, frames, layout.grid.columns);
            for first in slots.clone().step_by(most) {
                work.check()?;
                self.gpu.check()?;
                let together = first..slots.end.min(first + most);
                self.follow_slots(light, chunk, &together, walk);
                self.gpu.submit();
            }
        }
        Ok(())
    }

    /// The largest energy of a segment, for a pixel of value 1.
    pub(crate) fn brightest(&self) -> f32 {
        self.mask.factor * self.geometry.energy
    }

    pub(crate) fn factor(&self) -> f32 {
        self.mask.factor
    }

    /// What models of this geometry store of it.
    pub(crate) fn stored_bytes(&self) -> u64 {
        self.geometry.bytes
    }

    /// A walk of unscattered light between patterns, whose values count `scale` times, and voxels.
    fn walk<'a>(
        &'a self,
        name: &'static str,
        source: &'a dyn Fn() -> String,
        patterns: &'a GpuField,
        voxels: Vec<(Range<usize>, Vec<&'a Buffer>)>,
        scale: f32,
        harmonic: Option<&DirectionHarmonic>,
    ) -> Walk<'a> {
        let data = &self.geometry.data;
        let numbers = |harmonic: &DirectionHarmonic| {
            [
                harmonic.degree as u32,
                harmonic.order as i32 as u32,
                harmonic.scale.to_bits(),
            ]
        };
        Walk {
            name,
            source,
            patterns,
            output: &data.output,
            corner: data.corner,
            voxels,
            scale,
            adds: false,
            table: &self.geometry.inside,
            numbers: harmonic.map(numbers).into_iter().flatten().collect(),
            updates: data.updates,
            ways: 1,
        }
    }

    /// dose += unscattered light of some frames, of each ray the part that a harmonic of its direction says.
    pub(crate) fn add(
        &self,
        frames: &Range<usize>,
        x: &GpuField,
        dose: &mut GpuField,
        harmonic: Option<&DirectionHarmonic>,
        work: &Work,
    ) -> Result<()> {
        let energy = x.max_abs() * self.brightest();
        if energy == 0.0 {
            return self.gpu.check();
        }
        let unit = unit_of(energy);
        let zeros = || GpuField::of_lengths(&self.gpu, dose.lengths().to_vec());
        let (low, high) = (zeros(), zeros());
        let words = low.pieces().iter().zip(high.pieces());
        let voxels = dose.ranges().zip(words);
        let voxels = voxels.map(|(range, (low, high))| (range, vec![low, high]));
        let name = match harmonic {
            None => "dose of rays",
            Some(_) => "dose of weighted rays",
        };
        let source = || adding(&on_voxels(harmonic.is_some()));
        let walk = self.walk(name, &source, x, voxels.collect(), 1.0 / unit, harmonic);
        self.follow_all(frames, &walk, work)?;
        add_sums([&low, &high], unit, self.geometry.weights.as_ref(), dose);
        self.gpu.submit();
        self.gpu.check()
    }

    /// Pixels of some frames = transpose of [`add`](Self::add)
    pub(crate) fn collect(
        &self,
        frames: &Range<usize>,
        cotangent: &GpuField,
        grad: &mut GpuField,
        harmonic: Option<&DirectionHarmonic>,
        work: &Work,
    ) -> Result<()> {
        let in_cells = self.geometry.weights.as_ref().map(|weights| {
            let mut weighted = cotangent.clone();
            weighted.multiply(weights);
            weighted
        });
        let cotangent = in_cells.as_ref().unwrap_or(cotangent);
        let pieces = cotangent.ranges().zip(cotangent.pieces());
        let voxels = pieces.map(|(range, piece)| (range, vec![piece]));
        let name = match harmonic {
            None => "adjoint of rays",
            Some(_) => "adjoint of weighted rays",
        };
        let source = || collecting(&on_voxels(harmonic.is_some()));
        let walk = self.walk(name, &source, grad, voxels.collect(), 1.0, harmonic);
        self.follow_all(frames, &walk, work)?;
        self.gpu.check()
    }

    /// What is scattered out of the lights of some frames, with the light's own frames and pixels.
    fn scattered<'a>(
        &'a self,
        frames: &'a Range<usize>,
        field: &'a GpuField,
    ) -> impl Iterator<Item = (&'a DeviceScattered, Range<usize>, Pixels<'a>)> {
        let lights = own_frames(&self.geometry.data.patterns, frames);
        lights.flat_map(move |(light, light_frames)| {
            let of_light = self
                .geometry
                .scattered
                .iter()
                .filter(move |s| s.light == light);
            of_light.map(move |scattered| {
                let pixels = Pixels {
                    field,
                    runs: &self.geometry.lights[light].runs,
                    mask: &self.mask,
                };
                (scattered, light_frames.clone(), pixels)
            })
        })
    }

    /// Follows the rays of some frames, counted through all lights.
    fn follow_all(&self, frames: &Range<usize>, walk: &Walk<'_>, work: &Work) -> Result<()> {
        let mut lights = own_frames(&self.geometry.data.patterns, frames);
        lights.try_for_each(|(light, frames)| self.follow(light, &frames, walk, work))
    }

    /// Follows the rays of some slots between all pieces.
    fn follow_slots(&self, light: usize, chunk: &Chunk, slots: &Range<usize>, walk: &Walk<'_>) {
        let device = &self.geometry.lights[light];
        let layout = &self.geometry.data.patterns[light];
        let (output, corner) = (walk.output, walk.corner);
        let (columns, first_column, image_rows) = match device.is_shared {
            true => (chunk.columns.len(), chunk.columns.start, layout.grid.rows),
            false => (layout.grid.columns, 0, 0),
        };
        let across = output.grid.shape.into_iter().max().unwrap_or(1);
        let most = (MOST_ROUNDS / (ROUNDS * walk.ways * across)).max(1);
        let frames = slots.start / columns..slots.end.div_ceil(columns);
        let elements = layout.elements_of(frames);
        let [nz, ny, nx] = output.grid.shape;
        let plane = (nx * output.row).max(1);
        let places = walk.patterns.ranges().zip(walk.patterns.pieces());
        for (range, piece) in places {
            if range.start >= elements.end || elements.start >= range.end {
                continue;
            }
            let parts = (0..device.deepest.max(1)).step_by(most);
            let parts =
                parts.flat_map(|first| walk.voxels.iter().map(move |voxels| (first, voxels)));
            for (k, (first_segment, (voxels, buffers))) in parts.enumerate() {
                // The grid between the lowest and the highest y of the piece, all of it for cells
                let has_cells = voxels.end > output.voxels();
                let low = if has_cells { 0 } else { voxels.start / plane };
                let lines = low..voxels.end.div_ceil(plane).min(ny);
                let first = lines.start * plane;
                let numbers = [
                    slots.len(),
                    device.rows,
                    slots.start,
                    columns,
                    first_column,
                    layout.grid.columns,
                    image_rows,
                    layout.offset + chunk.first_pixel,
                    device.exposures,
                    usize::from(device.is_shared) * device.exposures,
                    range.start,
                    range.end,
                    voxels.start - first,
                    voxels.end - first,
                    nx,
                    lines.len(),
                    nz,
                    output.row,
                    usize::from(self.mask.has_dark),
                    usize::from(walk.adds || k > 0),
                    2 * device.turns,
                    first,
                    first_segment,
                    first_segment + most,
                ];
                let numbers = numbers.map(|n| n as u32).into_iter();
                let low_y = corner[1] + lines.start as f32;
                let scales = [corner[0], low_y, walk.scale * self.mask.factor];
                let numbers = numbers.chain(scales.map(f32::to_bits));
                let parameters: Vec<u32> = numbers.chain(walk.numbers.iter().copied()).collect();
                let mut all = vec![
                    &chunk.segments,
                    &chunk.starts,
                    &device.runs,
                    &*self.mask.lit,
                    walk.table,
                    piece,
                ];
                all.extend(buffers);
                let threads = slots.len() * device.rows;
                self.gpu
                    .run(walk.name, walk.source, &parameters, &all, threads);
            }
        }
    }
}

/// The unit of deposits of segments none of which has a larger energy; NaN where that is no number.
pub(crate) fn unit_of(energy: f32) -> f32 {
    // A cell of the major axis is passed on at most the diagonal of a voxel
    let most = energy * 3f32.sqrt();
    // Far above the smallest number: its inverse is one, too
    let exponent = most.log2().ceil().max(-90.0);
    if most.is_finite() {
        (exponent - 30.0).exp2()
    } else {
        f32::NAN
    }
}

impl DoseModel for GpuRays {
    type Field = GpuField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.geometry.data.patterns,
            outputs: std::slice::from_ref(&self.geometry.data.output),
            z_coupling: self.geometry.data.z_coupling,
            is_linear: true,
        }
    }

    fn new_field(&self, space: Space) -> Result<GpuField> {
        let RayGeometry {
            patterns, output, ..
        } = &*self.geometry.data;
        GpuField::of_space(&self.gpu, space, patterns, output)
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &GpuField,
        dose: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        self.add(&frames, x, dose, None, work)?;
        let voxels = voxels_of(dose, self.geometry.data.output.row);
        for (scattered, frames, pixels) in self.scattered(&frames, x) {
            scattered.add(&frames, &pixels, &voxels, work)?;
        }
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
        self.collect(&frames, cotangent, grad, None, work)?;
        let voxels = voxels_of(cotangent, self.geometry.data.output.row);
        for (scattered, frames, pixels) in self.scattered(&frames, grad) {
            scattered.add_adjoint(&frames, &voxels, &pixels, work)?;
        }
        self.gpu.check()
    }

    fn updates(&self) -> u64 {
        let scattered = self.geometry.scattered.iter();
        self.geometry.data.updates + scattered.map(DeviceScattered::updates).sum::<u64>()
    }

    fn describe(&self) -> String {
        let place = self.gpu.with(self.stored_bytes(), "rays");
        format!("{} ({place})", self.geometry.data.summary)
    }
}
/// dose += sums of 64 bits, in this unit and times weights where there are any
pub(crate) fn add_sums(
    [low, high]: [&GpuField; 2],
    unit: f32,
    weights: Option<&GpuField>,
    dose: &GpuField,
) {
    let mut operands = vec![
        Operand::written("y", dose.pieces()),
        Operand::read("low_words", low.pieces()).words(),
        Operand::read("high_words", high.pieces()).words(),
    ];
    let mut pass = Pass {
        name: "sums of rays",
        functions: SUM,
        body: "y[i] += p.a.x * sum(low_words[i], high_words[i]);",
        numbers: [[unit, 0.0, 0.0, 0.0], [0.0; 4], [0.0; 4]],
    };
    if let Some(weights) = weights {
        operands.push(Operand::read("weights", weights.pieces()));
        pass.name = "sums of rays in cells";
        pass.body = "y[i] += p.a.x * weights[i] * sum(low_words[i], high_words[i]);";
    }
    pass.each(dose.gpu(), &operands, dose.lengths());
}

/// A sum of 64 bits as a number.
const SUM: &str = "
fn sum(low: u32, high: u32) -> f32 {
    let is_negative = high >= 0x80000000u;
    let a = select(low, ~low + 1u, is_negative);
    let b = select(high, ~high + u32(low == 0u), is_negative);
    let size = f32(b) * 4294967296.0 + f32(a);
    return select(size, -size, is_negative);
}
";

/// What all kernels have, with `numbers` behind their parameters, and `follow` and `reach` of a light.
pub(crate) fn head(numbers: &str, light: &str) -> String {
    format!(
        "struct Parameters {{
    slots: u32, rows: u32, first_slot: u32, columns: u32,
    first_column: u32, all_columns: u32, image_rows: u32, first_pixel: u32,
    turns: u32, turn_step: u32, begin: u32, end: u32,
    low: u32, high: u32, nx: u32, ny: u32,
    nz: u32, row: u32, has_dark: u32, adds: u32,
    first_start: u32, first_voxel: u32, first_segment: u32, end_segment: u32, corner_x: f32, corner_y: f32, scale: f32,
    {numbers}
}}
@group(0) @binding(0) var<uniform> p: Parameters;
{}{IS_LIT}{light}",
        include_str!("shaders/rays.wgsl")
    )
}

/// Unscattered light on voxels and cells; weighted by a harmonic of its direction, or all of it.
fn on_voxels(is_weighted: bool) -> String {
    let (numbers, part) = match is_weighted {
        true => (HARMONIC, WEIGHTED),
        false => ("", EVEN),
    };
    let light = format!(
        "
// Elements that light inside of a surface is left in, of each voxel
@group(0) @binding(5) var<storage, read> inside: array<u32>;
var<private> is_inside: bool;
fn reach(found: u32, deposit: f32) {{
    var element = found;
    if (is_inside) {{ element = inside[p.first_voxel + element] - p.first_voxel; }}
    if (element >= p.low && element < p.high) {{ visit(element - p.low, deposit); }}
}}
{part}
fn follow(own: Segment, element: u32, path: u32) {{
    is_inside = own.energy < 0.0;
    walk(Segment(own.at, own.rate, own.along, part(own.along) * abs(own.energy), own.span));
}}
"
    );
    head(numbers, &light)
}

/// All of a segment.
const EVEN: &str = "fn part(along: vec3<f32>) -> f32 { return 1.0; }";

/// The part that a [harmonic](DirectionHarmonic) of its direction says, which is no more than 1 of it; its numbers.
const HARMONIC: &str = "degree: u32, order: i32, norm: f32";
const WEIGHTED: &str = "
fn part(along: vec3<f32>) -> f32 {
    let order = u32(abs(p.order));
    var around = vec2(1.0, 0.0);
    var value = p.norm;
    for (var i = 0u; i < order; i++) {
        around = vec2(around.x * along.x - around.y * along.y, around.y * along.x + around.x * along.y);
        value *= f32(2u * i + 1u);
    }
    // Legendre's function by upward recursion
    var below = 0.0;
    for (var k = order + 1u; k <= p.degree; k++) {
        let next = (f32(2u * k - 1u) * along.z * value - f32(k + order - 1u) * below) / f32(k - order);
        below = value;
        value = next;
    }
    return value * select(around.x, around.y, p.order < 0);
}";

/// The kernel that adds up what light leaves.
pub(crate) fn adding(head: &str) -> String {
    format!(
        "{head}
@group(0) @binding(6) var<storage, read> x: array<f32>;
@group(0) @binding(7) var<storage, read_write> low_words: array<atomic<u32>>;
@group(0) @binding(8) var<storage, read_write> high_words: array<atomic<u32>>;
var<private> value: f32;
fn visit(i: u32, deposit: f32) {{
    let units = i32(round(value * deposit));
    if (units == 0) {{ return; }}
    let word = bitcast<u32>(units);
    let before = atomicAdd(&low_words[i], word);
    let carry = u32(before > 0xffffffffu - word) - u32(units < 0);
    if (carry != 0u) {{ atomicAdd(&high_words[i], carry); }}
}}
{ENTRY}
    let found = pixel(group * 256u + thread);
    if (found.element == 0xffffffffu) {{ return; }}
    if (!is_lit(found.element)) {{ return; }}
    value = p.scale * x[found.element - p.begin];
    if (value != 0.0) {{ follow_all(found); }}
}}"
    )
}

/// The kernel that collects what light meets.
pub(crate) fn collecting(head: &str) -> String {
    format!(
        "{head}
@group(0) @binding(6) var<storage, read_write> gradient: array<f32>;
@group(0) @binding(7) var<storage, read> c: array<f32>;
var<private> sum: f32;
fn visit(i: u32, deposit: f32) {{ sum += deposit * c[i]; }}
{ENTRY}
    let found = pixel(group * 256u + thread);
    if (found.element == 0xffffffffu) {{ return; }}
    sum = 0.0;
    if (is_lit(found.element)) {{ follow_all(found); }}
    let i = found.element - p.begin;
    gradient[i] = select(0.0, gradient[i], p.adds == 1u) + p.scale * sum;
}}"
    )
}
