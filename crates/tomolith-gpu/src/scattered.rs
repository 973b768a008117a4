//! Light that is scattered, computed on the card.
//!
//! **Model** [`tomolith_core::dose::scattered`], the `successive_orders` model of the processor as data. Unscattered light on cells is a [`GpuStrips`] or a [`GpuRays`] of the
//! bins, all else are fields on cells ([`cells`](crate::cells), [`convolution`](crate::convolution)). All moments of an order are done at once; every element
//! is one thread's sum in one order, so dose and adjoint have the same bits in every run.

use crate::bins::{DeviceBins, Pixels};
use crate::cells::{DeviceCells, Matrix};
use crate::convolution::Convolution;
use crate::device::{Buffer, Gpu};
use crate::field::GpuField;
use crate::rays::GpuRays;
use crate::strips::{GpuStrips, must_be_bound};
use std::borrow::Cow;
use std::ops::Range;
use tomolith_core::dose::scattered::{
    DirectionHarmonic, LaterOrders, LightOnCells, OnCells, ScatteredLight,
};
use tomolith_core::dose::{DoseModel, PatternLayout, Work};
use tomolith_core::error::Result;

/// What is scattered out of one light.
pub(crate) struct DeviceScattered {
    gpu: Gpu,
    pub(crate) light: usize,
    pub(crate) summary: String,
    bins: DeviceBins,
    source: DeviceSource,
    channels: usize,
    /// Part of each (y, x) of voxels that is resin.
    shares: Buffer,
    once: DeviceOnCells,
    later: DeviceOrders,
}

/// Light of bins on cells.
enum DeviceSource {
    Strips(GpuStrips),
    Rays(GpuRays, Vec<DirectionHarmonic>),
}

impl DeviceSource {
    fn model(&self) -> &dyn DoseModel<Field = GpuField> {
        match self {
            DeviceSource::Strips(strips) => strips,
            DeviceSource::Rays(rays, _) => rays,
        }
    }

    /// The light of bins on cells, of a channel.
    fn light(
        &self,
        channel: usize,
        frames: &Range<usize>,
        bins: &GpuField,
        work: &Work,
    ) -> Result<GpuField> {
        let mut light = self.model().new_dose()?;
        match self {
            DeviceSource::Strips(strips) => {
                strips.dose_of(frames.clone(), bins, &mut light, work)?
            }
            DeviceSource::Rays(rays, harmonics) => {
                let weighted = Some(&harmonics[channel]);
                rays.add(frames, bins, &mut light, weighted, work)?;
            }
        }
        Ok(light)
    }

    /// Bins of some frames = transpose of [`light`](Self::light).
    fn collect(
        &self,
        channel: usize,
        frames: &Range<usize>,
        light: &GpuField,
        bins: &mut GpuField,
        work: &Work,
    ) -> Result<()> {
        match self {
            DeviceSource::Strips(strips) => strips.collect_frames(frames, light, bins, work),
            DeviceSource::Rays(rays, harmonics) => {
                rays.collect(frames, light, bins, Some(&harmonics[channel]), work)
            }
        }
    }
}

/// Fields on cells of one size, and the kernels that they meet.
struct DeviceOnCells {
    cells: DeviceCells,
    /// Of unscattered light as a source, of what voxels see.
    sharpened: [[f32; 3]; 2],
    convolution: Convolution,
}

impl DeviceOnCells {
    fn new(gpu: &Gpu, on_cells: &OnCells, matrix: &[Vec<usize>], row: usize) -> Self {
        DeviceOnCells {
            cells: DeviceCells::new(gpu, &on_cells.grid, row),
            sharpened: on_cells.sharpened,
            convolution: Convolution::new(gpu, on_cells, matrix),
        }
    }
}

/// Light that is scattered twice or more.
struct DeviceOrders {
    on: DeviceOnCells,
    factor: usize,
    between: [f32; 3],
    /// Part of each (y, x) of cells that is resin.
    resin: Buffer,
    /// What the resin sends on of each moment, 1/mm.
    scattered: Buffer,
    /// Channels → moments, moments → channels, and the weight of each order.
    numbers: Buffer,
    channels: usize,
    moments: usize,
    orders: usize,
}

/// The pieces of a dose, each with its columns of voxels.
pub(crate) type Voxels<'a> = [(Range<usize>, &'a Buffer)];

/// They, of rows of so many elements.
pub(crate) fn voxels_of(dose: &GpuField, row: usize) -> Vec<(Range<usize>, &Buffer)> {
    let columns = dose
        .ranges()
        .map(|range| range.start / row..range.end / row);
    columns.zip(dose.pieces()).collect()
}

impl DeviceScattered {
    /// Of a light that has these pixels on a card; `row` is that of voxels.
    pub(crate) fn new(
        gpu: &Gpu,
        scattered: &ScatteredLight,
        pixels: &PatternLayout,
        row: usize,
        work: &Work,
    ) -> Result<Self> {
        let slots = pixels.runs.len();
        must_be_bound(
            gpu,
            largest(scattered, slots),
            "a larger model.successive_orders.cell_mm",
        )?;
        let channels = scattered.source.channels();
        let (source, layout, weights) = match &scattered.source {
            LightOnCells::Strips(form, weights) => {
                let source = DeviceSource::Strips(GpuStrips::new(gpu, form, work)?);
                (source, &form.geometry.patterns[0], Cow::Borrowed(weights))
            }
            LightOnCells::Rays(form, harmonics) => {
                let rays = GpuRays::new(gpu, form, work)?;
                // Rays are weighted instead
                let even = vec![vec![1.0; slots]; channels];
                let source = DeviceSource::Rays(rays, harmonics.clone());
                (source, &form.geometry.patterns[0], Cow::Owned(even))
            }
        };
        let matrix = [(0..channels).collect()];
        Ok(DeviceScattered {
            gpu: gpu.clone(),
            light: scattered.light,
            summary: scattered.summary.clone(),
            bins: DeviceBins::new(gpu, &scattered.bins, layout, &weights),
            source,
            channels,
            shares: gpu.upload(&scattered.shares),
            once: DeviceOnCells::new(gpu, &scattered.once, &matrix, row),
            later: DeviceOrders::new(gpu, &scattered.later, channels, row),
        })
    }

    /// Cells that are lit by bins, of all channels.
    pub(crate) fn updates(&self) -> u64 {
        self.channels as u64 * self.source.model().updates()
    }

    /// dose += scattered light of some frames
    pub(crate) fn add(
        &self,
        frames: &Range<usize>,
        pixels: &Pixels<'_>,
        dose: &Voxels<'_>,
        work: &Work,
    ) -> Result<()> {
        let [given, seen] = self.once.sharpened;
        let bins = self.source.model().new_patterns()?;
        let sources = self.once.cells.fields(self.channels);
        let means = self.later.on.cells.fields(self.channels);
        for channel in 0..self.channels {
            self.bins.fill(&self.gpu, channel, pixels, &bins);
            let light = self.source.light(channel, frames, &bins, work)?;
            let light = &light.pieces()[0];
            self.once
                .cells
                .sharpen(given, 1, (light, 0), (&sources, channel));
            let (near, to) = ((&self.once.cells, light), (&means, channel));
            self.later.on.cells.restrict(near, self.later.factor, to);
        }
        let arrived = self
            .once
            .convolution
            .apply(&sources, [self.channels, 1], false);
        let arrived = self.once.cells.sharper(seen, &arrived);
        self.spread(&self.once.cells, &arrived, dose);
        let arrived = self.later.forward(&means, work)?;
        self.spread(&self.later.on.cells, &arrived, dose);
        Ok(())
    }

    /// Pixels of some frames += transpose of [`add`](Self::add) on a cotangent
    pub(crate) fn add_adjoint(
        &self,
        frames: &Range<usize>,
        cotangent: &Voxels<'_>,
        pixels: &Pixels<'_>,
        work: &Work,
    ) -> Result<()> {
        let [given, seen] = self.once.sharpened;
        let arrived = self.gathered(&self.once.cells, cotangent);
        let arrived = self.once.cells.sharper(seen, &arrived);
        let sources = self
            .once
            .convolution
            .apply(&arrived, [1, self.channels], true);
        let arrived = self.gathered(&self.later.on.cells, cotangent);
        let means = self.later.adjoint(&arrived, work)?;
        let mut bins = self.source.model().new_patterns()?;
        for channel in 0..self.channels {
            let light = self.source.model().new_dose()?;
            let near = &light.pieces()[0];
            self.once
                .cells
                .sharpen(given, 1, (&sources, channel), (near, 0));
            let (from, near) = ((&means, channel), (&self.once.cells, near));
            self.later.on.cells.prolong(from, self.later.factor, near);
            self.source
                .collect(channel, frames, &light, &mut bins, work)?;
            self.bins
                .add_back(&self.gpu, channel, frames, &bins, pixels);
        }
        Ok(())
    }

    fn spread(&self, cells: &DeviceCells, field: &Buffer, dose: &Voxels<'_>) {
        for piece in dose {
            cells.spread(field, &self.shares, piece);
        }
    }

    fn gathered(&self, cells: &DeviceCells, voxels: &Voxels<'_>) -> Buffer {
        let field = cells.dark(1);
        for piece in voxels {
            cells.gather(&field, &self.shares, piece);
        }
        field
    }
}

impl DeviceOrders {
    fn new(gpu: &Gpu, later: &LaterOrders, channels: usize, row: usize) -> Self {
        let moments = later.moments.len();
        // Kernels of pairs a ≤ b, row by row
        let row_of = |a: usize| (0..a).map(|i| moments - i).sum::<usize>();
        let kernel = |a: usize, b: usize| row_of(a.min(b)) + a.abs_diff(b);
        let of_row = |a| (0..moments).map(|b| kernel(a, b)).collect();
        let matrix: Vec<Vec<usize>> = (0..moments).map(of_row).collect();
        let mut numbers = vec![0.0; 2 * moments * channels];
        for (m, moment) in later.moments.iter().enumerate() {
            if let Some((channel, weight)) = moment.channel {
                numbers[m * channels + channel] = weight;
                numbers[(channels + channel) * moments + m] = weight;
            }
        }
        numbers.extend(&later.weights);
        let scattered: Vec<f32> = later
            .moments
            .iter()
            .map(|moment| moment.scattered)
            .collect();
        DeviceOrders {
            on: DeviceOnCells::new(gpu, &later.cells, &matrix, row),
            factor: later.factor,
            between: later.between,
            resin: gpu.upload(&later.resin),
            scattered: gpu.upload(&scattered),
            numbers: gpu.upload(&numbers),
            channels,
            moments,
            orders: later.weights.len(),
        }
    }

    fn matrix(&self, first: usize, [rows, columns]: [usize; 2]) -> Matrix<'_> {
        Matrix {
            buffer: &self.numbers,
            first,
            rows,
            columns,
        }
    }

    fn weight(&self, order: usize) -> Matrix<'_> {
        self.matrix(2 * self.moments * self.channels + order, [1, 1])
    }

    /// What voxels see, of the channels of unscattered light on these cells.
    fn forward(&self, means: &Buffer, work: &Work) -> Result<Buffer> {
        let (cells, convolution) = (&self.on.cells, &self.on.convolution);
        let [given, seen] = self.on.sharpened;
        let (channels, count) = (self.channels, self.moments);
        let sources = cells.fields(channels);
        cells.sharpen(given, channels, (means, 0), (&sources, 0));
        let sent = cells.fields(count);
        cells.mix(&self.matrix(0, [count, channels]), &sources, &sent, false);
        let mut moments = convolution.apply(&sent, [count, count], false);
        let sum = cells.dark(1);
        for order in 0..self.orders {
            work.check()?;
            cells.gpu().check()?;
            cells.sharpen(self.between, count, (&moments, 0), (&sent, 0));
            cells.scale(count, &sent, &self.scattered, &self.resin);
            // Of the last order only the fluence is wanted
            let wanted = if order + 1 == self.orders { 1 } else { count };
            moments = convolution.apply(&sent, [count, wanted], false);
            cells.mix(&self.weight(order), &moments, &sum, true);
        }
        Ok(cells.sharper(seen, &sum))
    }

    /// Transpose of [`forward`](Self::forward).
    fn adjoint(&self, arrived: &Buffer, work: &Work) -> Result<Buffer> {
        let (cells, convolution) = (&self.on.cells, &self.on.convolution);
        let [given, seen] = self.on.sharpened;
        let (channels, count) = (self.channels, self.moments);
        let arrived = cells.sharper(seen, arrived);
        let moments = cells.dark(count);
        // Of the last order only the fluence is there
        let mut there = 1;
        for order in (0..self.orders).rev() {
            work.check()?;
            cells.gpu().check()?;
            cells.mix(&self.weight(order), &arrived, &moments, true);
            let sent = convolution.apply(&moments, [there, count], true);
            cells.scale(count, &sent, &self.scattered, &self.resin);
            cells.sharpen(self.between, count, (&sent, 0), (&moments, 0));
            there = count;
        }
        let sent = convolution.apply(&moments, [there, count], true);
        let sources = cells.fields(channels);
        let back = self.matrix(channels * count, [channels, count]);
        cells.mix(&back, &sent, &sources, false);
        let means = cells.fields(channels);
        cells.sharpen(given, channels, (&sources, 0), (&means, 0));
        Ok(means)
    }
}

/// Bytes of the largest array that a kernel sees at once, where a light has so many columns of pixels in all frames.
fn largest(scattered: &ScatteredLight, slots: usize) -> u64 {
    let (channels, moments) = (scattered.source.channels(), scattered.later.moments.len());
    let spectra = [
        (&scattered.once, channels),
        (&scattered.later.cells, moments.max(channels)),
    ];
    let of_spectra = spectra.map(|(cells, count)| {
        let fields = 4 * (count * cells.grid.layout.len()) as u64;
        fields.max(Convolution::bytes(cells, count))
    });
    let others = [channels * slots, scattered.shares.len()].map(|n| 4 * n as u64);
    of_spectra.into_iter().chain(others).max().unwrap_or(0)
}
