//! The scattered part of one light: unscattered light on cells, and what becomes of it.

use super::bins::Bins;
use super::collimated_source::CollimatedSource;
use super::convolver::{self, Convolver};
use super::divergent_source::DivergentSource;
use super::free_flight::{FreeFlightKernel, Pattern};
use super::harmonics::{Harmonic, coefficients};
use super::higher_orders::{HigherOrders, on_cells, resin_of};
use super::unscattered_source::{Channel, UnscatteredSource};
use super::{Params, by_rays};
use crate::cell_blur::{CellBlur, Sharpen, full_cells};
use crate::coarse::Coarse;
use crate::parallel::{Kernel, Parallel};
use crate::rays::Optics;
use crate::{DoseLayout, Purpose, Work};
use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::dose::scattered;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::grid::VolumeGrid;
use tomolith_fourier::Complex;
use tomolith_optics::light::Light;
use tomolith_optics::phase::Scattering;
use tomolith_optics::vial::Vial;

/// A phase function by harmonics, its forward lobe folded into the unscattered light.
#[derive(Clone, Debug)]
pub(super) struct DeltaScaledPhase {
    /// Part of the scattered light that counts as unscattered.
    pub(super) forward_fraction: f64,
    /// Scattering that is left, 1/mm.
    pub(super) per_mm: f64,
    /// Scattering that counts as unscattered light, 1/mm.
    pub(super) straight_per_mm: f64,
    /// f_l for l = 0 …; f_0 = 1.
    pub(super) coefficients: Vec<f64>,
}

/// Degree at which phase functions are cut.
const DEGREE: usize = 3;
/// Coefficients below this are none.
const NOTHING: f64 = 1e-6;

impl DeltaScaledPhase {
    pub(super) fn new(scattering: &Scattering) -> Self {
        let mut all = coefficients(scattering.phase.as_ref(), DEGREE + 1);
        let forward_fraction = all.pop().filter(|&f| f > NOTHING).unwrap_or(0.0);
        let mut coefficients: Vec<f64> = all
            .iter()
            .map(|f| (f - forward_fraction) / (1.0 - forward_fraction))
            .collect();
        while coefficients.last().is_some_and(|f| f.abs() < NOTHING) {
            coefficients.pop();
        }
        DeltaScaledPhase {
            forward_fraction,
            per_mm: (1.0 - forward_fraction) * scattering.per_mm,
            straight_per_mm: forward_fraction * scattering.per_mm,
            coefficients,
        }
    }

    /// The harmonics that scattered light has, 00 first.
    pub(super) fn harmonics(&self) -> Vec<Harmonic> {
        let has = |l: usize| self.coefficients[l].abs() >= NOTHING;
        (0..self.coefficients.len())
            .filter(|&l| has(l))
            .flat_map(|l| (-(l as isize)..=l as isize).map(move |m| Harmonic { l, m }))
            .collect()
    }
}

pub(super) struct ScatteringLight<'a> {
    /// Which light it is, where its pixels lie in a pattern field, and its frames among all.
    pub(super) number: usize,
    pub(super) pixels: Range<usize>,
    pub(super) frames: Range<usize>,
    pub(super) light: Light,
    /// None where `parallel` follows it.
    pub(super) cone: Option<&'a Optics>,
    pub(super) delta_scaled: DeltaScaledPhase,
}

/// See the [module page](self).
pub(super) struct ScatteredLight {
    /// Which light it is, where its pixels lie in a pattern field, and its frames among all.
    light: usize,
    pixels: Range<usize>,
    frames: Range<usize>,
    /// Unscattered light on cells.
    straight: Box<dyn UnscatteredSource>,
    /// For unscattered light as a source, and what voxels see of order 1.
    given: Sharpen,
    seen: Sharpen,
    /// Of each of its fields: to the dose of order 1.
    kernels: Vec<convolver::Kernel>,
    convolver: Convolver,
    /// From the cells of order 1 to voxels.
    coarse: Coarse,
    higher: HigherOrders,
}

impl ScatteredLight {
    pub(super) fn new(
        vial: &dyn Vial,
        scattering: ScatteringLight<'_>,
        params: &Params,
        fine: &DoseLayout,
        purpose: Purpose,
        work: &Work,
    ) -> Result<Self> {
        let (light, delta_scaled) = (&scattering.light, &scattering.delta_scaled);
        let edges = cell_edges(vial, delta_scaled, params);
        let (bins, binned) = Bins::new(light, edges[0]);
        let rays = |optics| by_rays(vial, vec![binned.clone()], &[optics], params, &fine.grid);
        let rays = scattering.cone.cloned().map(rays).transpose()?;
        let lit = rays.as_ref();
        let lit = lit.map_or_else(|| bins.heights_mm(), |rays| rays.heights_mm());
        let cells = Cells::new(vial, &scattering, edges, lit, &fine.grid);
        cells.must_be_few()?;
        let layout = DoseLayout::new("dose", cells.grid.clone(), 0);
        let [nz, ny, nx] = cells.grid.shape;
        let convolver = Convolver::new([nx, ny, nz], layout.row);
        let free_flight = FreeFlightKernel {
            mu: light.resin.attenuation_per_mm,
            edge: cells.grid.pitch_mm,
        };
        let of_bins = bins.blur();
        let straight: Box<dyn UnscatteredSource> = match rays {
            Some(rays) => Box::new(DivergentSource::new(
                bins,
                rays.on(cells.grid.clone()),
                delta_scaled,
            )),
            None => {
                let (lights, kernel, grid) = (vec![binned], Kernel::default(), cells.grid.clone());
                let parallel = Parallel::for_purpose(vial, lights, kernel, grid, purpose, work)?;
                let source = CollimatedSource::new(vial, light, bins, parallel, delta_scaled);
                Box::new(source)
            }
        };
        let channels = straight.channels();
        let patterns: Vec<Pattern> = channels
            .iter()
            .map(|c| order_one(delta_scaled, c))
            .collect();
        let octants = free_flight.octants(&patterns, [nx, ny, nz], work)?;
        let kernels = octants.iter().zip(&patterns);
        let kernels = kernels.map(|(octant, p)| {
            work.check()?;
            Ok(convolver.kernel(octant, p.parities()))
        });
        let kernels = kernels.collect::<Result<_>>()?;
        let is_full = full_cells(&layout, |at| vial.in_resin(at));
        let (mean, line) = (
            CellBlur::mean(free_flight.edge),
            CellBlur::interpolation(free_flight.edge),
        );
        let shares = Arc::new(resin_of(vial, &fine.grid));
        let coarse = |grid| Coarse::of_grid(grid, fine).with_shares(Arc::clone(&shares));
        let later = coarse(cells.of_later_orders());
        Ok(ScatteredLight {
            given: Sharpen::new(&layout, &is_full, of_bins + mean + mean),
            seen: Sharpen::new(&layout, &is_full, mean + line),
            kernels,
            higher: HigherOrders::new(vial, &scattering, channels, of_bins, &cells, later, work)?,
            straight,
            convolver,
            coarse: coarse(cells.grid),
            light: scattering.number,
            pixels: scattering.pixels,
            frames: scattering.frames,
        })
    }

    pub(super) fn updates(&self) -> u64 {
        self.straight.updates()
    }

    pub(super) fn describe(&self) -> String {
        format!(
            "cells of {:.3} mm, from order 2 on of {:.3} mm, {} orders",
            self.coarse.layout.grid.pitch_mm,
            self.higher.edge_mm(),
            self.higher.orders()
        )
    }

    /// What is scattered out of this light, one of several, as data; None where its unscattered light has no such form.
    pub(super) fn form(&self, work: &Work) -> Result<Option<scattered::ScatteredLight>> {
        let (Some((bins, source)), Some(shares)) =
            (self.straight.form(work)?, self.coarse.shares.clone())
        else {
            return Ok(None);
        };
        let sharpen = [&self.given, &self.seen];
        Ok(Some(scattered::ScatteredLight {
            light: self.light,
            bins,
            source,
            shares,
            once: on_cells(&self.coarse, &self.convolver, sharpen, &self.kernels),
            later: self.higher.form(),
            summary: self.describe(),
        }))
    }

    /// Which of this light's frames are among these of all lights.
    fn local_frames(&self, frames: &Range<usize>) -> Range<usize> {
        let Range { start, end } = self.frames;
        frames.start.clamp(start, end) - start..frames.end.clamp(start, end) - start
    }

    /// dose += scattered light of these frames
    pub(super) fn add_forward(
        &self,
        frames: Range<usize>,
        x: &[f32],
        dose: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let local = self.local_frames(&frames);
        if local.is_empty() {
            return Ok(());
        }
        let sources = self.straight.fields(local, &x[self.pixels.clone()], work)?;
        let mut once = vec![Complex::new(0.0, 0.0); self.convolver.len()];
        for (kernel, source) in self.kernels.iter().zip(&sources) {
            let spectrum = self.convolver.transform(&self.given.of(source.as_slice()));
            kernel.add(&spectrum, false, &mut once);
        }
        let mut cells = vec![0.0; self.coarse.layout.len()];
        self.convolver.add_field(once, &mut cells);
        self.coarse.spread(&self.seen.of(&cells), dose);
        self.higher.add_forward(&sources, dose, work)
    }

    /// grad += transpose of the scattered light of these frames on a cotangent
    pub(super) fn add_adjoint(
        &self,
        frames: &Range<usize>,
        cotangent: &[f32],
        grad: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let local = self.local_frames(frames);
        if local.is_empty() {
            return Ok(());
        }
        let mut cells = vec![0.0; self.coarse.layout.len()];
        self.coarse.gather(cotangent, &mut cells);
        let once = self.convolver.transform(&self.seen.of(&cells));
        let higher = self.higher.adjoint(cotangent, work)?;
        let source = |(channel, kernel): (usize, &convolver::Kernel)| {
            let mut sum = vec![Complex::new(0.0, 0.0); self.convolver.len()];
            kernel.add(&once, true, &mut sum);
            let mut cells = vec![0.0; self.coarse.layout.len()];
            self.convolver.add_field(sum, &mut cells);
            let mut source = HostField::zeros(cells.len());
            source
                .as_mut_slice()
                .copy_from_slice(&self.given.of(&cells));
            higher.add_to(channel, source.as_mut_slice());
            source
        };
        let sources: Vec<HostField> = self.kernels.iter().enumerate().map(source).collect();
        let grad = &mut grad[self.pixels.clone()];
        self.straight.add_adjoint(local, &sources, grad, work)
    }
}

/// What turns a field of unscattered light into the dose of light scattered once.
fn order_one(delta_scaled: &DeltaScaledPhase, Channel(terms): &Channel) -> Pattern {
    let zero = Harmonic { l: 0, m: 0 };
    let fluence = (4.0 * PI).sqrt() * delta_scaled.per_mm;
    let scattered = |&(h, weight): &(Harmonic, f64)| {
        let strength = fluence * delta_scaled.coefficients[h.l] * weight;
        (strength, zero, h)
    };
    Pattern(terms.iter().map(scattered).collect())
}

/// Edges of the cells of order 1, mm: in use, and where a job asks for none.
fn cell_edges(vial: &dyn Vial, delta_scaled: &DeltaScaledPhase, params: &Params) -> [f64; 2] {
    let radius = vial.resin_wall().inscribed_radius();
    let usual = (0.04 / delta_scaled.per_mm).clamp(radius / 32.0, radius / 12.0);
    let usual = usual.min(0.2 / delta_scaled.per_mm);
    let asked = params.cell_mm.map(|edge| edge.min(radius / 4.0));
    [asked.unwrap_or(usual), usual]
}

/// Cells of order 1 along an edge of one of the later orders: as long as 0.4 mm at μ = 1, and 20 of them across, but no more than where
/// the job names no edge, so that smaller cells are smaller in all orders.
fn cells_of_later_orders([edge, usual]: [f64; 2], mu: f64, radius: f64) -> usize {
    let longest = (0.4 / mu).min(radius / 10.0);
    let count = |edge: f64| (longest / edge).floor().max(1.0);
    count(edge).min(count(usual)) as usize
}

/// How far above and below what is lit or wanted light may go and come back, mm.
///
/// Diffusion in a cylinder decays along z as e^(−κz), κ² = 3μ_a(μ_a + μ_s′) + (2.4/R)², μ_s′ = μ_s(1 − f₁). Five lengths, fewer where much
/// light is absorbed before it is scattered again: 0.1 to 0.3 % of the dose are missing (docs/validation.md).
fn margin_mm(delta_scaled: &DeltaScaledPhase, mu: f64, radius: f64) -> f64 {
    const LENGTHS: f64 = 5.0;
    /// First zero of the Bessel function J₀.
    const ZERO: f64 = 2.405;
    let turned =
        delta_scaled.per_mm * (1.0 - delta_scaled.coefficients.get(1).copied().unwrap_or(0.0));
    let absorbed = (mu - delta_scaled.per_mm).max(0.0);
    let decay = 3.0 * absorbed * (absorbed + turned) + (ZERO / radius).powi(2);

    LENGTHS * (delta_scaled.per_mm / mu).powi(2) / decay.sqrt()
}

/// Most cells of order 1: their spectra, padded, take 32 bytes a cell each, and there are about ten, in cones up to twenty, and twenty-one more of
/// later orders where these have cells as small: 5 GB.
const MOST_CELLS: usize = 1 << 22;

/// The cells of order 1, and how many of them make one of the later orders.
pub(super) struct Cells {
    pub(super) grid: VolumeGrid,
    pub(super) factor: usize,
}

impl Cells {
    /// Cells over the resin, from below to above what is lit or wanted.
    fn new(
        vial: &dyn Vial,
        scattering: &ScatteringLight<'_>,
        edges: [f64; 2],
        [lit_low, lit_high]: [f64; 2],
        fine: &VolumeGrid,
    ) -> Self {
        let radius = vial.resin_wall().inscribed_radius();
        let (edge, mu) = (edges[0], scattering.light.resin.attenuation_per_mm);
        let factor = cells_of_later_orders(edges, mu, radius);
        let margin = margin_mm(&scattering.delta_scaled, mu, radius);
        let [low, high] = fine.bounds_mm();
        let (low, high) = (low[2].min(lit_low) - margin, high[2].max(lit_high) + margin);
        let count =
            |length: f64| (length / (edge * factor as f64)).ceil().max(2.0) as usize * factor;
        let across = count(2.0 * radius);
        Cells {
            grid: VolumeGrid {
                shape: [count(high - low), across, across],
                pitch_mm: edge,
                height_mm: edge,
                center_mm: [0.0, 0.0, (low + high) / 2.0],
            },
            factor,
        }
    }

    /// The larger cells of later orders.
    fn of_later_orders(&self) -> VolumeGrid {
        let edge = self.grid.pitch_mm * self.factor as f64;
        VolumeGrid {
            shape: self.grid.shape.map(|n| n / self.factor),
            pitch_mm: edge,
            height_mm: edge,
            center_mm: self.grid.center_mm,
        }
    }

    /// Refuses more cells than a machine can hold.
    fn must_be_few(&self) -> Result<()> {
        let [nz, ny, nx] = self.grid.shape;
        let found = nz.saturating_mul(ny).saturating_mul(nx);
        if found <= MOST_CELLS {
            return Ok(());
        }
        let edge = self.grid.pitch_mm * (found as f64 / MOST_CELLS as f64).cbrt();
        let edge = (edge * 1e3).ceil() / 1e3;
        Err(Error::config(
            "model.successive_orders.cell_mm",
            format!("{nz} × {ny} × {nx} cells of {} mm", self.grid.pitch_mm),
            format!("at most {MOST_CELLS} cells: about {edge} mm or more, or [model.monte_carlo]"),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smaller_cells_are_smaller_in_all_orders() {
        // Of its own 0.125 mm cells, a vial of 3.75 mm has later ones of 0.375 mm
        let later = |edge: f64| edge * cells_of_later_orders([edge, 0.125], 0.3, 3.75) as f64;
        assert_eq!(later(0.125), 0.375);
        assert_eq!(later(0.0625), 0.1875);
        // Larger ones never exceed that
        assert_eq!((later(0.25), later(0.1875)), (0.25, 0.375));
    }
}
