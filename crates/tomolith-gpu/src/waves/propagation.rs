//! Light of frames from the plane of their pixels to samples behind it, and back.
//!
//! Formula: [`tomolith_core::dose::waves`]; of a batch of frames the spectrum is computed once, then depth by depth its field ([`transforms`](crate::transforms)), and
//! |ψ|² of the depths whose fields are there. Fields wait in a ring, on the way back those that were multiplied in another. Transfer functions
//! are those of the depth before times a step, as on the processor, once for all frames of the batch.
//!
//! **Shapes** spectra `[frame][f_u][f_z]`, fields `[frame][lateral][z]`, samples `[frame][depth][lateral][row]`.

use super::kernels;
use crate::bins::table_of_runs;
use crate::device::{Buffer, Gpu};
use crate::field::GpuField;
use crate::mask::Mask;
use crate::transforms::{Lines, Transform};
use std::ops::Range;
use tomolith_core::dose::waves::{
    Comb, FieldTap, Interpolation, SparseRows, Transfer, WaveLight, WaveMode,
};
use tomolith_core::dose::{PatternLayout, Work};
use tomolith_core::error::Result;

/// How light of one light spreads.
pub(crate) struct DevicePropagation {
    gpu: Gpu,
    /// Offset, lowest row, rows and frame of each column of pixels.
    runs: Buffer,
    columns: usize,
    shifts: Buffer,
    band: [usize; 2],
    combs: [Comb; 2],
    /// Of the window, along u and z, there and back.
    image: [[Transform; 2]; 2],
    /// Of the samples.
    field: [[Transform; 2]; 2],
    modes: Vec<DeviceMode>,
    depths: usize,
    forth: Sums,
    back: Sums,
    closer: [Option<DeviceInterpolation>; 2],
    row: usize,
    is_linear: bool,
}

struct DeviceMode {
    weight: f32,
    transfer: DeviceTransfer,
}

enum DeviceTransfer {
    Steps {
        start: Buffer,
        step: Buffer,
        passing: Buffer,
    },
    /// As complex numbers.
    Each(Vec<Buffer>),
}

/// The last field of a sum, and its entries.
struct Sum {
    last: usize,
    entries: Range<usize>,
}

/// Sums of fields in a ring.
struct Sums {
    sums: Vec<Sum>,
    /// Place in the ring, and weights of the real and imaginary part.
    entries: Buffer,
    /// Fields in the ring.
    ring: usize,
}

struct DeviceInterpolation {
    /// First entries and entries, of closer samples and of the transpose.
    forth: [Buffer; 2],
    back: [Buffer; 2],
    /// Samples before and after.
    counts: [usize; 2],
}

/// The frames of a batch and where their pixels are.
pub(crate) struct Batch<'a> {
    pub(crate) frames: Range<usize>,
    /// The piece of a field that holds all of them, and its first element.
    pub(crate) piece: usize,
    pub(crate) begin: usize,
    pub(crate) mask: &'a Mask,
}

/// Where the lines of a transform lie: in pixels, or from a number of an array on.
#[derive(Clone, Copy)]
enum Place<'a> {
    Pixels(&'a Batch<'a>),
    From(usize),
}

/// Samples of a kind: what they hold of a field, or of two.
#[derive(Clone, Copy)]
enum Light {
    /// |ψ|², or Re ψ.
    Dose,
    /// 2·Re ψχ* and |χ|².
    Along,
    /// The field that they send back.
    Back,
}

/// A transfer function on its way from depth to depth.
struct Power<'a> {
    mode: &'a DeviceMode,
    values: Buffer,
}

impl DevicePropagation {
    pub(crate) fn new(
        gpu: &Gpu,
        light: &WaveLight,
        layout: &PatternLayout,
        row: usize,
        is_linear: bool,
    ) -> Self {
        let transforms = &light.transforms;
        let lengths = transforms.samples.map(|comb| comb.length);
        let both =
            |lengths: [usize; 2]| lengths.map(|n| [-1, 1].map(|sign| Transform::new(gpu, n, sign)));
        let counts = transforms.band.map(|b| 2 * b + 1);
        let modes = light.modes.iter();
        DevicePropagation {
            gpu: gpu.clone(),
            runs: table_of_runs(gpu, layout),
            columns: layout.grid.columns,
            shifts: gpu.upload(&transforms.shifts),
            band: transforms.band,
            combs: transforms.samples,
            image: both(transforms.padded),
            field: both(lengths),
            modes: modes
                .map(|mode| DeviceMode::new(gpu, mode, counts))
                .collect(),
            depths: light.back.len(),
            forth: Sums::new(gpu, &light.forth),
            back: Sums::new(gpu, &light.back),
            closer: (light.closer.each_ref()).map(|step| {
                step.as_ref()
                    .map(|step| DeviceInterpolation::new(gpu, step))
            }),
            row,
            is_linear,
        }
    }

    /// Frequencies along u and z.
    fn counts(&self) -> [usize; 2] {
        self.band.map(|b| 2 * b + 1)
    }

    fn frequencies(&self) -> usize {
        self.counts().iter().product()
    }

    /// Numbers of a field.
    fn of_field(&self) -> usize {
        self.combs[0].count * self.combs[1].count
    }

    /// Numbers of the samples that are computed.
    fn computed(&self) -> usize {
        self.forth.sums.len() * self.combs[0].count * self.row
    }

    /// Numbers of the samples after each interpolation, of a frame.
    fn interpolated(&self) -> [usize; 2] {
        let [width, depths] = [0, 1].map(|i| self.closer[i].as_ref().map(|step| step.counts[1]));
        let width = width.unwrap_or(self.combs[0].count) * self.row;
        let computed = self.forth.sums.len();
        [computed * width, depths.unwrap_or(computed) * width]
    }

    /// Bytes of a frame at work: of all arrays, and of the largest that a kernel sees at once.
    pub(crate) fn bytes(&self) -> [u64; 2] {
        let field = 8 * self.of_field();
        let [nu, nz] = self.counts();
        let mixed = 8 * (nu * self.combs[1].count).max(self.columns * nz);
        let spectrum = 8 * self.frequencies();
        let samples = (self.interpolated().into_iter()).chain([self.computed()]);
        let samples: Vec<usize> = samples.map(|n| 4 * n).collect();
        let rings = [&self.forth, &self.back].map(|sums| sums.ring * field);
        let all =
            2 * (samples.iter().sum::<usize>() + rings[0] + spectrum + mixed) + rings[1] + field;
        let largest = samples.into_iter().chain(rings).chain([spectrum, mixed]);
        [all as u64, largest.max().unwrap_or(0) as u64]
    }

    /// Numbers that are transformed for a depth of a frame.
    pub(crate) fn transformed(&self) -> usize {
        self.counts()[0] * self.combs[1].length + self.combs[1].count * self.combs[0].length
    }

    /// Transforms lines of an axis (0: u, 1: z), of the window or of samples, there (0) or back (1).
    fn transform(
        &self,
        transforms: &[[Transform; 2]; 2],
        [axis, way]: [usize; 2],
        kernel: &Lines,
        lines: usize,
        place: Place<'_>,
        buffers: &[&Buffer],
    ) {
        let transform = &transforms[axis][way];
        let [nu, nz] = self.counts();
        let comb = &self.combs[axis];
        let (begin, frame, has_dark, factor, first) = match place {
            Place::Pixels(b) => (b.begin, b.frames.start, b.mask.has_dark, b.mask.factor, 0),
            Place::From(first) => (0, 0, false, 0.0, first),
        };
        let numbers = [
            transform.length(),
            self.band[axis],
            comb.first,
            comb.stride,
            comb.count,
            nu,
            nz,
            self.columns,
            self.combs[0].count,
            self.combs[1].count,
            begin,
            frame * self.columns,
            first,
            usize::from(has_dark),
        ];
        let mut parameters = numbers.map(|n| n as u32).to_vec();
        parameters.push(factor.to_bits());
        transform.run(kernel, lines, &parameters, buffers);
    }

    pub(crate) fn spectra(&self, batch: &Batch<'_>, image: &GpuField) -> Buffer {
        let (frames, [_, nz]) = (batch.frames.len(), self.counts());
        let columns = self.gpu.buffer((8 * frames * self.columns * nz) as u64);
        self.transform(
            &self.image,
            [1, 0],
            &kernels::PIXELS_ALONG_Z,
            frames * self.columns,
            Place::Pixels(batch),
            &[
                &columns,
                &image.pieces()[batch.piece],
                &self.runs,
                &self.shifts,
                &batch.mask.lit,
            ],
        );
        let spectra = self.gpu.buffer((8 * frames * self.frequencies()) as u64);
        self.transform(
            &self.image,
            [0, 0],
            &kernels::PIXELS_ALONG_U,
            frames * nz,
            Place::From(0),
            &[&spectra, &columns],
        );
        spectra
    }

    /// Pixels of the frames of a batch = what their spectra are asked for.
    pub(crate) fn to_pixels(&self, spectra: &Buffer, batch: &Batch<'_>, grad: &GpuField) {
        let (frames, [_, nz]) = (batch.frames.len(), self.counts());
        let columns = self.gpu.buffer((8 * frames * self.columns * nz) as u64);
        self.transform(
            &self.image,
            [0, 1],
            &kernels::BACK_ALONG_U,
            frames * nz,
            Place::From(0),
            &[&columns, spectra],
        );
        self.transform(
            &self.image,
            [1, 1],
            &kernels::BACK_TO_PIXELS,
            frames * self.columns,
            Place::Pixels(batch),
            &[
                &grad.pieces()[batch.piece],
                &columns,
                &self.runs,
                &self.shifts,
                &batch.mask.lit,
            ],
        );
    }

    /// Between the transforms along z and u of fields.
    fn mixed(&self, frames: usize) -> Buffer {
        let numbers = frames * self.counts()[0] * self.combs[1].count;
        self.gpu.buffer((8 * numbers) as u64)
    }

    /// A place of a ring = fields of spectra at a depth.
    fn field(&self, frames: usize, spectra: &Buffer, power: &Buffer, ring: &Buffer, place: usize) {
        let mixed = self.mixed(frames);
        self.transform(
            &self.field,
            [1, 1],
            &kernels::FIELD_ALONG_Z,
            frames * self.counts()[0],
            Place::From(0),
            &[&mixed, spectra, power],
        );
        self.transform(
            &self.field,
            [0, 1],
            &kernels::FIELD_ALONG_U,
            frames * self.combs[1].count,
            Place::From(place * frames * self.of_field()),
            &[ring, &mixed],
        );
    }

    /// spectra += what fields at a depth send back
    fn field_back(&self, frames: usize, field: &Buffer, power: &Buffer, spectra: &Buffer) {
        let mixed = self.mixed(frames);
        self.transform(
            &self.field,
            [0, 0],
            &kernels::FIELD_BACK_ALONG_U,
            frames * self.combs[1].count,
            Place::From(0),
            &[&mixed, field],
        );
        self.transform(
            &self.field,
            [1, 0],
            &kernels::FIELD_BACK_ALONG_Z,
            frames * self.counts()[0],
            Place::From(0),
            &[spectra, &mixed, power],
        );
    }

    fn ring(&self, frames: usize, sums: &Sums) -> Buffer {
        let bytes = 8 * sums.ring * frames * self.of_field();
        self.gpu.buffer(bytes as u64)
    }

    /// Samples of the light of one image a frame: |ψ|².
    pub(crate) fn shine(&self, frames: usize, spectra: &Buffer, work: &Work) -> Result<Buffer> {
        let samples = self.dark(frames, self.computed());
        self.each_depth(frames, &[spectra], Light::Dose, &[&samples], work)?;
        Ok(samples)
    }

    /// Adds 2·Re ψχ* and |χ|² in the same way.
    pub(crate) fn shine_along(
        &self,
        frames: usize,
        spectra: [&Buffer; 2],
        work: &Work,
    ) -> Result<[Buffer; 2]> {
        let samples = [(); 2].map(|()| self.dark(frames, self.computed()));
        self.each_depth(frames, &spectra, Light::Along, &samples.each_ref(), work)?;
        Ok(samples)
    }

    fn dark(&self, frames: usize, numbers: usize) -> Buffer {
        self.gpu.zeros((4 * frames * numbers) as u64)
    }

    /// Adds light of every depth and mode to samples.
    fn each_depth(
        &self,
        frames: usize,
        spectra: &[&Buffer],
        light: Light,
        samples: &[&Buffer],
        work: &Work,
    ) -> Result<()> {
        let rings: Vec<Buffer> = spectra
            .iter()
            .map(|_| self.ring(frames, &self.forth))
            .collect();
        for mode in &self.modes {
            let (mut power, mut next) = (Power::new(self, mode), 0);
            for depth in 0..self.depths {
                self.check(work)?;
                let now = power.at(self, depth);
                for (spectra, ring) in spectra.iter().zip(&rings) {
                    self.field(frames, spectra, now, ring, depth % self.forth.ring);
                }
                while self.forth.is_ready(next, depth) {
                    let rings: Vec<&Buffer> = rings.iter().collect();
                    self.light(light, frames, next, mode, &rings, samples);
                    next += 1;
                }
                self.gpu.submit();
            }
        }
        Ok(())
    }

    /// What samples ask of the spectra of frames: the transpose of [`shine`](Self::shine) at these.
    pub(crate) fn send_back(
        &self,
        frames: usize,
        spectra: Option<&Buffer>,
        samples: &Buffer,
        work: &Work,
    ) -> Result<Buffer> {
        let sum = self.gpu.zeros((8 * frames * self.frequencies()) as u64);
        let (ring, sent) = (
            self.ring(frames, &self.forth),
            self.ring(frames, &self.back),
        );
        let field = self.gpu.buffer((8 * frames * self.of_field()) as u64);
        for mode in &self.modes {
            let [mut power, mut power_back] = [(); 2].map(|()| Power::new(self, mode));
            let (mut next, mut done) = (0, 0);
            for depth in 0..self.depths {
                self.check(work)?;
                if let Some(spectra) = spectra {
                    let now = power.at(self, depth);
                    self.field(frames, spectra, now, &ring, depth % self.forth.ring);
                }
                while self.forth.is_ready(next, depth) {
                    let others = [&sent, samples];
                    self.light(Light::Back, frames, next, mode, &[&ring], &others);
                    next += 1;
                    // As soon as all is there: the ring has no place for more
                    while done < self.depths && self.back.sums[done].last < next {
                        self.sum_of(frames, done, &sent, &field);
                        let now = power_back.at(self, done);
                        self.field_back(frames, &field, now, &sum);
                        done += 1;
                    }
                }
                self.gpu.submit();
            }
        }
        Ok(sum)
    }

    fn check(&self, work: &Work) -> Result<()> {
        work.check()?;
        self.gpu.check()
    }

    /// Light of a depth from fields in rings to samples; on the way back from samples and fields to what is sent.
    fn light(
        &self,
        light: Light,
        frames: usize,
        depth: usize,
        mode: &DeviceMode,
        rings: &[&Buffer],
        others: &[&Buffer],
    ) {
        let entries = &self.forth.sums[depth].entries;
        let numbers = [
            frames * self.of_field(),
            entries.start,
            entries.end,
            self.of_field(),
            self.combs[1].count,
            self.row,
            self.combs[0].count,
            self.forth.sums.len(),
            depth,
            depth % self.back.ring * frames * self.of_field(),
        ];
        let mut parameters: Vec<u32> = numbers.iter().map(|n| *n as u32).collect();
        parameters.push(mode.weight.to_bits());
        let mut buffers = others.to_vec();
        let (name, source): (_, fn() -> String) = match (light, self.is_linear) {
            (Light::Back, true) => ("light sent back", kernels::sent_of_light),
            (Light::Back, false) => ("waves sent back", kernels::sent_of_waves),
            (Light::Along, _) => ("waves of two images", kernels::two_waves),
            (Light::Dose, true) => ("light of fields", kernels::light),
            (Light::Dose, false) => ("light of waves", kernels::waves),
        };
        // Light that is sent back linearly asks no field
        if !(matches!(light, Light::Back) && self.is_linear) {
            buffers.push(&self.forth.entries);
            buffers.extend(rings);
        }
        let threads = frames * self.of_field();
        self.gpu.run(name, &source, &parameters, &buffers, threads);
    }

    /// `field` = what was sent back to a depth that is transformed.
    fn sum_of(&self, frames: usize, depth: usize, sent: &Buffer, field: &Buffer) {
        let entries = &self.back.sums[depth].entries;
        let numbers = [frames * self.of_field(), entries.start, entries.end];
        self.gpu.run(
            "sum of fields",
            &kernels::sum_of_fields,
            &numbers.map(|n| n as u32),
            &[field, &self.back.entries, sent],
            numbers[0],
        );
    }

    /// Closer samples.
    pub(crate) fn interpolate(&self, frames: usize, computed: Buffer) -> Buffer {
        let ([across, along], depths) = (&self.closer, self.forth.sums.len());
        let [between, last] = self.interpolated();
        let mut samples = computed;
        if let Some(step) = across {
            let (outer, between) = (frames * depths, frames * between);
            samples = self.rows(&step.forth, step.counts, outer, self.row, between, &samples);
        }
        if let Some(step) = along {
            let (inner, last) = (between / depths, frames * last);
            samples = self.rows(&step.forth, step.counts, frames, inner, last, &samples);
        }
        samples
    }

    pub(crate) fn interpolate_back(&self, frames: usize, last: Buffer) -> Buffer {
        let ([across, along], depths) = (&self.closer, self.forth.sums.len());
        let [between, _] = self.interpolated();
        let mut samples = last;
        if let Some(DeviceInterpolation { back, counts, .. }) = along {
            let (turned, inner) = ([counts[1], counts[0]], between / depths);
            samples = self.rows(back, turned, frames, inner, frames * between, &samples);
        }
        if let Some(DeviceInterpolation { back, counts, .. }) = across {
            let (turned, computed) = ([counts[1], counts[0]], frames * self.computed());
            let outer = frames * depths;
            samples = self.rows(back, turned, outer, self.row, computed, &samples);
        }
        samples
    }

    /// A sparse matrix times each of `outer` arrays of rows of `inner` numbers; `numbers` are in the result.
    fn rows(
        &self,
        [starts, entries]: &[Buffer; 2],
        [from, to]: [usize; 2],
        outer: usize,
        inner: usize,
        numbers: usize,
        source: &Buffer,
    ) -> Buffer {
        let out = self.gpu.buffer((4 * numbers) as u64);
        let parameters = [outer, inner / 4, from, to].map(|n| n as u32);
        self.gpu.run(
            "closer samples",
            &kernels::rows,
            &parameters,
            &[&out, source, starts, entries],
            numbers / 4,
        );
        self.gpu.submit();
        out
    }
}

impl DeviceMode {
    fn new(gpu: &Gpu, mode: &WaveMode, [nu, nz]: [usize; 2]) -> Self {
        // [f_z][f_u] → [f_u][f_z]
        let at = |t: usize| (t % nz) * nu + t / nz;
        let turned = |values: &[[f32; 2]]| {
            let values: Vec<[f32; 2]> = (0..nu * nz).map(|t| values[at(t)]).collect();
            gpu.upload(&values)
        };
        let transfer = match &mode.transfer {
            Transfer::Steps {
                start,
                step,
                passing,
            } => DeviceTransfer::Steps {
                start: turned(start),
                step: turned(step),
                passing: gpu.upload(passing),
            },
            Transfer::Each(depths) => DeviceTransfer::Each(
                (depths.iter())
                    .map(|values| turned(&values.iter().map(|v| [*v, 0.0]).collect::<Vec<_>>()))
                    .collect(),
            ),
        };
        DeviceMode {
            weight: mode.weight,
            transfer,
        }
    }
}

impl<'a> Power<'a> {
    fn new(propagation: &DevicePropagation, mode: &'a DeviceMode) -> Self {
        let bytes = match mode.transfer {
            DeviceTransfer::Steps { .. } => 8 * propagation.frequencies(),
            DeviceTransfer::Each(_) => 0,
        };
        Power {
            mode,
            values: propagation.gpu.buffer(bytes as u64),
        }
    }

    /// Brought on from the depth before.
    fn at(&mut self, propagation: &DevicePropagation, depth: usize) -> &Buffer {
        match &self.mode.transfer {
            DeviceTransfer::Each(depths) => &depths[depth],
            DeviceTransfer::Steps {
                start,
                step,
                passing,
            } => {
                let all = propagation.frequencies();
                let parameters = [all, propagation.counts()[1], depth].map(|n| n as u32);
                propagation.gpu.run(
                    "transfer function",
                    &kernels::transfer,
                    &parameters,
                    &[&self.values, start, step, passing],
                    all,
                );
                &self.values
            }
        }
    }
}

impl Sums {
    fn new(gpu: &Gpu, sums: &[Vec<FieldTap>]) -> Self {
        let fields = |taps: &[FieldTap]| {
            let fields = || taps.iter().map(|tap| tap.field as usize);
            [fields().min().unwrap_or(0), fields().max().unwrap_or(0)]
        };
        // A sum is taken once its last field, and those of all sums before, are there
        let mut there = 0;
        let waiting = sums.iter().map(|taps| {
            let [first, last] = fields(taps);
            there = last.max(there);
            there + 1 - first
        });
        let ring = waiting.max().unwrap_or(1);
        let mut entries: Vec<[u32; 4]> = Vec::new();
        let mut placed = |taps: &Vec<FieldTap>| {
            let begin = entries.len();
            entries.extend(taps.iter().map(|tap| {
                let [re, im] = tap.weights.map(f32::to_bits);
                [tap.field % ring as u32, re, im, 0]
            }));
            Sum {
                last: fields(taps)[1],
                entries: begin..entries.len(),
            }
        };
        Sums {
            sums: sums.iter().map(&mut placed).collect(),
            entries: gpu.upload(&entries),
            ring,
        }
    }

    /// Whether the fields of a sum are there, up to one of a depth.
    fn is_ready(&self, sum: usize, depth: usize) -> bool {
        self.sums.get(sum).is_some_and(|sum| sum.last <= depth)
    }
}

impl DeviceInterpolation {
    fn new(gpu: &Gpu, step: &Interpolation) -> Self {
        let upload = |rows: &SparseRows| {
            let entries: Vec<[u32; 2]> = (rows.entries.iter())
                .map(|&(column, weight)| [column, weight.to_bits()])
                .collect();
            [gpu.upload(&rows.starts), gpu.upload(&entries)]
        };
        DeviceInterpolation {
            forth: upload(&step.forth),
            back: upload(&step.back),
            counts: [&step.back, &step.forth].map(|rows| rows.starts.len() - 1),
        }
    }
}
