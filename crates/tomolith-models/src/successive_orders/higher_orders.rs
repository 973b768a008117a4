//! Light that was scattered twice or more, on large cells.

use super::convolver::{Convolver, Kernel, Spectrum};
use super::free_flight::{FreeFlightKernel, Pattern};
use super::harmonics::Harmonic;
use super::scattered_light::{Cells, ScatteringLight};
use super::unscattered_source::Channel;
use crate::cell_blur::{CellBlur, Sharpen, full_cells};
use crate::coarse::Coarse;
use crate::{DoseLayout, Work};
use std::sync::Arc;
use tomolith_core::dose::scattered::{LaterOrders, Moment, OnCells};
use tomolith_core::error::Result;
use tomolith_core::field::HostField;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::{lines, table};
use tomolith_fourier::Complex;
use tomolith_optics::vial::Vial;

/// Orders are summed until one adds less than this part of all.
const ENOUGH: f64 = 1e-3;
/// Orders that are summed at most.
const MOST: usize = 64;

/// See the [module page](self).
pub(super) struct HigherOrders {
    /// Cells of order 1.
    near: DoseLayout,
    /// Cells of order 1 along an edge of one here.
    factor: usize,
    convolver: Convolver,
    /// From these cells to voxels.
    coarse: Coarse,
    moments: Vec<Moment>,
    /// Of each pair of moments a ≤ b, row by row.
    kernels: Vec<Kernel>,
    /// Part of each (y, x) of cells that is resin.
    resin: Vec<f32>,
    /// For unscattered light as a source, light from cell to cell, and what voxels see.
    given: Sharpen,
    between: Sharpen,
    seen: Sharpen,
    /// The orders 2 … that are summed, with their weights: 1, and for the last that of a geometric series.
    weights: Vec<f32>,
}

/// Fields of all moments.
type Moments = Vec<Vec<f32>>;

impl HigherOrders {
    /// For a light that the resin scatters, whose order 1 is on `cells`; `coarse` brings later orders to voxels. `channels` tell the unscattered light, and
    /// `of_bins` is how far its bins blur it.
    pub(super) fn new(
        vial: &dyn Vial,
        scattering: &ScatteringLight<'_>,
        channels: &[Channel],
        of_bins: CellBlur,
        cells: &Cells,
        coarse: Coarse,
        work: &Work,
    ) -> Result<Self> {
        let (delta_scaled, grid) = (&scattering.delta_scaled, &coarse.layout.grid);
        let [nz, ny, nx] = grid.shape;
        let convolver = Convolver::new([nx, ny, nz], coarse.layout.row);
        let free_flight = FreeFlightKernel {
            mu: scattering.light.resin.attenuation_per_mm,
            edge: grid.pitch_mm,
        };
        let harmonics = delta_scaled.harmonics();
        let moment = |&harmonic: &Harmonic| {
            // μ_s·f_l, and what of it a channel of unscattered light tells
            let scattered = (delta_scaled.per_mm * delta_scaled.coefficients[harmonic.l]) as f32;
            let weight_of = |(i, channel): (usize, &Channel)| {
                let weight = channel.weight(harmonic)?;
                Some((i, scattered * weight as f32))
            };
            Moment {
                scattered,
                channel: channels.iter().enumerate().find_map(weight_of),
            }
        };
        let moments: Vec<Moment> = harmonics.iter().map(moment).collect();
        let mut patterns = Vec::new();
        for (i, &a) in harmonics.iter().enumerate() {
            for &b in &harmonics[i..] {
                patterns.push(Pattern(vec![(1.0, a, b)]));
            }
        }
        let octants = free_flight.octants(&patterns, [nx, ny, nz], work)?;
        let kernels = octants.iter().zip(&patterns);
        let kernels = kernels.map(|(octant, p)| {
            work.check()?;
            Ok(convolver.kernel(octant, p.parities()))
        });
        let kernels = kernels.collect::<Result<_>>()?;
        let resin = resin_of(vial, grid);
        let (mean, line) = (
            CellBlur::mean(free_flight.edge),
            CellBlur::interpolation(free_flight.edge),
        );
        let is_full = full_cells(&coarse.layout, |at| vial.in_resin(at));
        let sharpen = |blur| Sharpen::new(&coarse.layout, &is_full, blur);
        let mut higher = HigherOrders {
            near: DoseLayout::new("dose", cells.grid.clone(), 0),
            factor: cells.factor,
            given: sharpen(of_bins + mean + mean),
            between: sharpen(mean + mean),
            seen: sharpen(mean + line),
            resin,
            coarse,
            moments,
            kernels,
            convolver,
            weights: Vec::new(),
        };
        higher.weights = higher.count_orders(work)?;
        Ok(higher)
    }

    /// These orders as data.
    pub(super) fn form(&self) -> LaterOrders {
        let sharpen = [&self.given, &self.seen];
        LaterOrders {
            cells: on_cells(&self.coarse, &self.convolver, sharpen, &self.kernels),
            factor: self.factor,
            between: self.between.strength(),
            resin: self.resin.clone(),
            moments: self.moments.clone(),
            weights: self.weights.iter().map(|w| w * FLUENCE).collect(),
        }
    }

    pub(super) fn edge_mm(&self) -> f64 {
        self.coarse.layout.grid.pitch_mm
    }

    /// Orders that are summed one by one.
    pub(super) fn orders(&self) -> usize {
        self.weights.len() + 1
    }

    /// How many orders even light in the whole resin needs, and the weight of each.
    fn count_orders(&self, work: &Work) -> Result<Vec<f32>> {
        let mut moments = self.dark();
        self.for_each_line(&mut moments[0], |resin, line| line.fill(resin));
        let size = |moments: &Moments| moments[0].iter().map(|&v| f64::from(v)).sum::<f64>();
        let (mut before, mut sum) = (size(&moments), 0.0);
        let mut weights = Vec::new();
        loop {
            moments = self.scatter(&moments, work)?;
            let now = size(&moments);
            sum += now;
            let ratio = (now / before).clamp(0.0, 0.99);
            let is_last = now < ENOUGH * sum || weights.len() + 1 == MOST;
            if is_last {
                weights.push((1.0 / (1.0 - ratio)) as f32);
                return Ok(weights);
            }
            weights.push(1.0);
            before = now;
        }
    }

    fn dark(&self) -> Moments {
        vec![vec![0.0; self.coarse.layout.len()]; self.moments.len()]
    }

    fn kernel(&self, a: usize, b: usize) -> &Kernel {
        let (low, high) = (a.min(b), a.max(b));
        let row: usize = (0..low).map(|i| self.moments.len() - i).sum();
        &self.kernels[row + high - low]
    }

    /// Calls `change` with the resin's part and the cells of each (y, x).
    fn for_each_line(&self, field: &mut [f32], change: impl Fn(f32, &mut [f32]) + Sync) {
        lines(field, self.coarse.layout.row, |i, line| {
            change(self.resin[i], line)
        });
    }

    fn no_spectrum(&self) -> Spectrum {
        vec![Complex::new(0.0, 0.0); self.convolver.len()]
    }

    /// Free flight of what these sources send out; the first `count` moments of where it arrives.
    fn fly(&self, sources: &[Spectrum], count: usize, work: &Work) -> Result<Moments> {
        (0..count)
            .map(|a| {
                work.check()?;
                let mut sum = self.no_spectrum();
                for (b, source) in sources.iter().enumerate() {
                    self.kernel(a, b).add(source, false, &mut sum);
                }
                let mut field = vec![0.0; self.coarse.layout.len()];
                self.convolver.add_field(sum, &mut field);
                Ok(field)
            })
            .collect()
    }

    /// The next order: light is scattered by the resin and flies on.
    fn scatter(&self, moments: &[Vec<f32>], work: &Work) -> Result<Moments> {
        self.fly(&self.emitted(moments, work)?, self.moments.len(), work)
    }

    /// Spectra of what the resin sends out in this light.
    fn emitted(&self, moments: &[Vec<f32>], work: &Work) -> Result<Vec<Spectrum>> {
        moments
            .iter()
            .zip(&self.moments)
            .map(|(field, moment)| {
                work.check()?;
                let mut field = self.between.of(field);
                self.for_each_line(&mut field, |resin, line| {
                    line.iter_mut().for_each(|v| *v *= resin * moment.scattered);
                });
                Ok(self.convolver.transform(&field))
            })
            .collect()
    }

    fn scatter_back(&self, moments: &[Vec<f32>], work: &Work) -> Result<Moments> {
        let mut back = self.fly_back(moments, work)?;
        for (field, moment) in back.iter_mut().zip(&self.moments) {
            self.for_each_line(field, |resin, line| {
                line.iter_mut().for_each(|v| *v *= resin * moment.scattered);
            });
            *field = self.between.of(field);
        }
        Ok(back)
    }

    /// Transpose of free flight, from the moments given (all, or the first alone).
    fn fly_back(&self, moments: &[Vec<f32>], work: &Work) -> Result<Moments> {
        let spectra: Vec<Spectrum> = moments
            .iter()
            .map(|field| self.convolver.transform(field))
            .collect();
        (0..self.moments.len())
            .map(|b| {
                work.check()?;
                let mut sum = self.no_spectrum();
                for (a, spectrum) in spectra.iter().enumerate() {
                    self.kernel(a, b).add(spectrum, true, &mut sum);
                }
                let mut field = vec![0.0; self.coarse.layout.len()];
                self.convolver.add_field(sum, &mut field);
                Ok(field)
            })
            .collect()
    }

    /// dose += light scattered twice or more, of these fields of unscattered light
    pub(super) fn add_forward(
        &self,
        sources: &[HostField],
        dose: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let fields: Vec<Vec<f32>> = (sources.iter())
            .map(|source| self.given.of(&self.restrict(source.as_slice())))
            .collect();
        let spectra: Vec<Spectrum> = self
            .moments
            .iter()
            .map(|moment| {
                let Some((channel, weight)) = moment.channel else {
                    return self.no_spectrum();
                };
                let field: Vec<f32> = fields[channel].iter().map(|v| weight * v).collect();
                self.convolver.transform(&field)
            })
            .collect();
        let mut moments = self.fly(&spectra, self.moments.len(), work)?;
        let mut sum = vec![0.0; self.coarse.layout.len()];
        for (i, &weight) in self.weights.iter().enumerate() {
            let is_last = i + 1 == self.weights.len();
            let count = if is_last { 1 } else { self.moments.len() };
            moments = self.fly(&self.emitted(&moments, work)?, count, work)?;
            let weight = weight * FLUENCE;
            sum.iter_mut()
                .zip(&moments[0])
                .for_each(|(sum, value)| *sum += weight * value);
        }
        self.coarse.spread(&self.seen.of(&sum), dose);
        Ok(())
    }

    /// Transpose of [`add_forward`](Self::add_forward): what each field of unscattered light gets.
    pub(super) fn adjoint(&self, cotangent: &[f32], work: &Work) -> Result<Back<'_>> {
        let mut cells = vec![0.0; self.coarse.layout.len()];
        self.coarse.gather(cotangent, &mut cells);
        let mut cells = self.seen.of(&cells);
        cells.iter_mut().for_each(|v| *v *= FLUENCE);
        // The last order has one moment that counts
        let mut moments = vec![vec![0.0; cells.len()]];
        for &weight in self.weights.iter().rev() {
            moments[0]
                .iter_mut()
                .zip(&cells)
                .for_each(|(v, cell)| *v += weight * cell);
            moments = self.scatter_back(&moments, work)?;
        }
        Ok(Back {
            higher: self,
            moments: self.fly_back(&moments, work)?,
        })
    }

    /// Means over the cells of order 1 in each cell here.
    fn restrict(&self, near: &[f32]) -> Vec<f32> {
        let mut field = vec![0.0; self.coarse.layout.len()];
        let (row, near_row) = (self.coarse.layout.row, self.near.row);
        let [nz, _, nx] = self.coarse.layout.grid.shape;
        let near_nx = self.near.grid.shape[2];
        let (k, share) = (self.factor, 1.0 / (self.factor.pow(3)) as f32);
        lines(&mut field, row, |i, line| {
            let (y, x) = (i / nx, i % nx);
            for dy in 0..k {
                for dx in 0..k {
                    let from = ((k * y + dy) * near_nx + k * x + dx) * near_row;
                    let near = &near[from..from + k * nz];
                    for (sum, values) in line.iter_mut().zip(near.chunks_exact(k)) {
                        *sum += share * values.iter().sum::<f32>();
                    }
                }
            }
        });
        field
    }

    /// Transpose of [`restrict`](Self::restrict), added.
    fn add_prolonged(&self, field: &[f32], near: &mut [f32]) {
        let (row, near_row) = (self.coarse.layout.row, self.near.row);
        let [nz, _, nx] = self.coarse.layout.grid.shape;
        let near_nx = self.near.grid.shape[2];
        let (k, share) = (self.factor, 1.0 / (self.factor.pow(3)) as f32);
        lines(near, near_row, |i, near| {
            let (y, x) = (i / near_nx / k, i % near_nx / k);
            let line = &field[(y * nx + x) * row..][..nz];
            for (values, value) in near.chunks_exact_mut(k).zip(line) {
                values.iter_mut().for_each(|v| *v += share * value);
            }
        });
    }
}

/// Cells of one size as data, with the sharpenings of sources and of what voxels see.
pub(super) fn on_cells(
    coarse: &Coarse,
    convolver: &Convolver,
    [given, seen]: [&Sharpen; 2],
    kernels: &[Kernel],
) -> OnCells {
    OnCells {
        grid: coarse.form(Arc::clone(given.is_full())),
        padded: convolver.padded(),
        sharpened: [given.strength(), seen.strength()],
        kernels: kernels
            .iter()
            .map(|kernel| convolver.form(kernel))
            .collect(),
    }
}

/// Fluence per moment 00: √(4π).
const FLUENCE: f32 = 3.544_907_7;

/// What comes back from light scattered twice or more.
pub(super) struct Back<'a> {
    higher: &'a HigherOrders,
    moments: Moments,
}

impl Back<'_> {
    /// Adds what belongs to one channel.
    pub(super) fn add_to(&self, channel: usize, near: &mut [f32]) {
        let higher = self.higher;
        let mut sum = vec![0.0; higher.coarse.layout.len()];
        for (moment, field) in higher.moments.iter().zip(&self.moments) {
            if let Some((_, weight)) = moment.channel.filter(|(source, _)| *source == channel) {
                sum.iter_mut()
                    .zip(field)
                    .for_each(|(sum, value)| *sum += weight * value);
            }
        }
        higher.add_prolonged(&higher.given.of(&sum), near);
    }
}

/// Part of each (y, x) of cells or voxels that is resin, by 8 × 8 points; the resin is convex.
pub(super) fn resin_of(vial: &dyn Vial, grid: &VolumeGrid) -> Vec<f32> {
    const POINTS: usize = 8;
    let [_, ny, nx] = grid.shape;
    let at = |i: usize| ((i as f64 + 0.5) / POINTS as f64 - 0.5) * grid.pitch_mm;
    let half = grid.pitch_mm / 2.0;
    table(ny * nx, |i| {
        let (x, y) = (grid.x(i % nx), grid.y(i / nx));
        let corners = [(-half, -half), (-half, half), (half, -half), (half, half)];
        if (corners.iter()).all(|(dx, dy)| vial.in_resin([x + dx, y + dy, 0.0])) {
            return 1.0;
        }
        let inside = (0..POINTS * POINTS)
            .filter(|j| vial.in_resin([x + at(j % POINTS), y + at(j / POINTS), 0.0]))
            .count();
        inside as f32 / (POINTS * POINTS) as f32
    })
}
