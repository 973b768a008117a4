//! The scattered part of one light: straight light on cells, and what becomes of it.

use super::Params;
use super::bins::Bins;
use super::convolver::{Convolver, Kernel};
use super::far::Far;
use super::flight::{Flight, Pattern};
use super::harmonics::{Harmonic, coefficients};
use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::models::coarse::Coarse;
use crate::models::parallel::{Light, Parallel};
use crate::models::{DoseLayout, LinearOperator, Run};
use crate::optics::phase::Scattering;
use crate::optics::trace::Tracer;
use crate::optics::vial::Vial;
use realfft::num_complex::Complex;
use std::f64::consts::{FRAC_PI_2, PI};
use std::ops::Range;

/// A phase function by harmonics, its forward lobe folded into the straight light.
#[derive(Clone, Debug)]
pub(super) struct Folded {
    /// Part of the scattered light that counts as straight.
    pub(super) lobe: f64,
    /// Scattering that is left, 1/mm.
    pub(super) per_mm: f64,
    /// Scattering that counts as straight light, 1/mm.
    pub(super) straight_per_mm: f64,
    /// f_l for l = 0 …; f_0 = 1.
    pub(super) coefficients: Vec<f64>,
}

/// Degree at which phase functions are cut.
const DEGREE: usize = 3;
/// Coefficients below this are none.
const NOTHING: f64 = 1e-6;

impl Folded {
    pub(super) fn new(scattering: &Scattering) -> Self {
        let mut all = coefficients(scattering.phase.as_ref(), DEGREE + 1);
        let lobe = all.pop().filter(|&f| f > NOTHING).unwrap_or(0.0);
        let mut coefficients: Vec<f64> = all.iter().map(|f| (f - lobe) / (1.0 - lobe)).collect();
        while coefficients.last().is_some_and(|f| f.abs() < NOTHING) {
            coefficients.pop();
        }
        Folded {
            lobe,
            per_mm: (1.0 - lobe) * scattering.per_mm,
            straight_per_mm: lobe * scattering.per_mm,
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

/// One harmonic of the azimuth of straight light.
pub(super) struct Channel {
    pub(super) m: isize,
    /// cos mφ, or sin |m|φ for m < 0, of each (frame, column).
    weights: Vec<f32>,
    /// From its straight light to the dose of order 1.
    kernel: Kernel,
}

/// See the [module page](self).
pub(super) struct Glow {
    /// Where this light's pixels lie in a pattern field, and its frames among all.
    pixels: Range<usize>,
    frames: Range<usize>,
    bins: Bins,
    /// Straight light of bins on cells.
    straight: Parallel,
    channels: Vec<Channel>,
    convolver: Convolver,
    /// From the cells of order 1 to voxels.
    coarse: Coarse,
    far: Far,
}

impl Glow {
    pub(super) fn new(
        vial: &dyn Vial,
        light: Light,
        folded: &Folded,
        params: &Params,
        fine: &DoseLayout,
        (offset, first_frame): (usize, usize),
    ) -> Result<Self> {
        let edge = cell_edge(vial, folded, params);
        let (bins, binned) = Bins::new(&light, edge);
        let mu = light.resin.attenuation_per_mm;
        let cells = Cells::new(vial, (edge, mu), bins.heights_mm(), &fine.grid);
        cells.must_be_few()?;
        let layout = DoseLayout::new("dose", cells.grid.clone(), 0);
        let [nz, ny, nx] = cells.grid.shape;
        let convolver = Convolver::new([nx, ny, nz], layout.row);
        let flight = Flight {
            mu,
            edge: cells.grid.pitch_mm,
        };
        let azimuths = azimuths(vial, &light);
        let turns = orders_of_azimuth(folded);
        let patterns: Vec<Pattern> = turns.iter().map(|&m| order_one(folded, m)).collect();
        let octants = flight.octants(&patterns, [nx, ny, nz]);
        let channels = turns
            .into_iter()
            .zip(octants.iter().zip(&patterns))
            .map(|(m, (octant, pattern))| Channel {
                m,
                weights: azimuths.iter().map(|&phi| around(m, phi) as f32).collect(),
                kernel: convolver.kernel(octant, pattern.parities()),
            })
            .collect();
        let far = Far::new(vial, folded, mu, &layout, cells.factor, fine);
        let frames = first_frame..first_frame + light.pixels.frames();
        let len = light.layout(0).len();
        Ok(Glow {
            pixels: offset..offset + len,
            frames,
            straight: Parallel::new(vial, vec![binned], cells.grid.clone())?,
            bins,
            channels,
            convolver,
            coarse: Coarse::of_grid(cells.grid, fine),
            far,
        })
    }

    pub(super) fn updates(&self) -> u64 {
        self.channels.len() as u64 * LinearOperator::updates(&self.straight)
    }

    pub(super) fn describe(&self) -> String {
        format!(
            "cells of {:.3} mm, from order 2 on of {:.3} mm, {} orders",
            self.coarse.layout.grid.pitch_mm,
            self.far.edge_mm(),
            self.far.orders()
        )
    }

    /// dose += scattered light of these frames
    pub(super) fn add_forward(
        &self,
        frames: Range<usize>,
        x: &[f32],
        dose: &mut [f32],
        run: &Run,
    ) -> Result<()> {
        let first = self.frames.start;
        let own = frames.start.clamp(first, self.frames.end) - first
            ..frames.end.clamp(first, self.frames.end) - first;
        if own.is_empty() {
            return Ok(());
        }
        let x = &x[self.pixels.clone()];
        let mut once = vec![Complex::new(0.0, 0.0); self.convolver.len()];
        let mut sources = Vec::new();
        let mut weighted = LinearOperator::new_patterns(&self.straight)?;
        for channel in &self.channels {
            self.bins.fill(x, &channel.weights, weighted.as_mut_slice());
            let mut source = LinearOperator::new_dose(&self.straight)?;
            self.straight
                .add_forward(own.clone(), &weighted, &mut source, run)?;
            let spectrum = self.convolver.transform(source.as_slice());
            channel.kernel.add(&spectrum, false, &mut once);
            sources.push((channel.m, source));
        }
        let mut cells = vec![0.0; self.coarse.layout.len()];
        self.convolver.add_field(once, 1.0, &mut cells);
        self.coarse.spread(&cells, dose);
        self.far.add_forward(&sources, dose);
        Ok(())
    }

    /// grad += transpose of the scattered light on a cotangent
    pub(super) fn add_adjoint(&self, cotangent: &[f32], grad: &mut [f32], run: &Run) -> Result<()> {
        let mut cells = vec![0.0; self.coarse.layout.len()];
        self.coarse.gather(cotangent, &mut cells);
        let once = self.convolver.transform(&cells);
        let far = self.far.adjoint(cotangent);
        let grad = &mut grad[self.pixels.clone()];
        let mut own = LinearOperator::new_patterns(&self.straight)?;
        for channel in &self.channels {
            let mut sum = vec![Complex::new(0.0, 0.0); self.convolver.len()];
            channel.kernel.add(&once, true, &mut sum);
            let mut source = LinearOperator::new_dose(&self.straight)?;
            self.convolver.add_field(sum, 1.0, source.as_mut_slice());
            far.add_to(channel.m, source.as_mut_slice());
            self.straight.adjoint(&source, &mut own, run)?;
            self.bins.add_back(own.as_slice(), &channel.weights, grad);
        }
        Ok(())
    }
}

/// cos mφ, or sin |m|φ for m < 0.
fn around(m: isize, phi: f64) -> f64 {
    if m < 0 {
        (m.unsigned_abs() as f64 * phi).sin()
    } else {
        (m as f64 * phi).cos()
    }
}

/// Orders m of the azimuth that straight light normal to the axis has.
fn orders_of_azimuth(folded: &Folded) -> Vec<isize> {
    let mut orders: Vec<isize> = Vec::new();
    for harmonic in folded.harmonics() {
        if level(harmonic) != 0.0 && !orders.contains(&harmonic.m) {
            orders.push(harmonic.m);
        }
    }
    orders
}

/// A harmonic in the plane z = 0, over cos mφ or sin |m|φ.
pub(super) fn level(harmonic: Harmonic) -> f64 {
    if (harmonic.l + harmonic.m.unsigned_abs()) % 2 == 1 {
        return 0.0;
    }
    let phi = if harmonic.m < 0 {
        FRAC_PI_2 / harmonic.m.unsigned_abs() as f64
    } else {
        0.0
    };
    harmonic.at([phi.cos(), phi.sin(), 0.0])
}

/// What turns the straight dose of one order of the azimuth into the dose of light scattered once.
fn order_one(folded: &Folded, m: isize) -> Pattern {
    let zero = Harmonic { l: 0, m: 0 };
    let fluence = (4.0 * PI).sqrt() * folded.per_mm;
    let terms = folded
        .harmonics()
        .into_iter()
        .filter(|h| h.m == m && level(*h) != 0.0)
        .map(|h| (fluence * folded.coefficients[h.l] * level(h), zero, h));
    Pattern(terms.collect())
}

/// The azimuth of light in the resin, of each (frame, column); 0 where none arrives.
fn azimuths(vial: &dyn Vial, light: &Light) -> Vec<f64> {
    let tracer = Tracer::new(
        vial,
        light.resin,
        light.surrounding_index,
        light.polarisation,
    )
    .in_bath(light.bath);
    let pixels = &light.pixels;
    (0..pixels.frames() * pixels.columns)
        .map(|i| {
            let (frame, column) = (i / pixels.columns, i % pixels.columns);
            let path = tracer.trace(pixels.column_u(column), pixels.azimuths[frame]);
            path.legs
                .first()
                .map_or(0.0, |leg| leg.direction[1].atan2(leg.direction[0]))
        })
        .collect()
}

/// Edge of the cells of order 1, mm.
fn cell_edge(vial: &dyn Vial, folded: &Folded, params: &Params) -> f64 {
    let radius = vial.resin_wall().inscribed_radius();
    params.cell_mm.map_or_else(
        || (0.04 / folded.per_mm).clamp(radius / 32.0, radius / 12.0),
        |edge| edge.min(radius / 4.0),
    )
}

/// Most cells of order 1: their spectra, padded, take 32 bytes a cell each, and there are about ten.
const MOST_CELLS: usize = 1 << 24;

/// The cells of order 1, and how many of them make one of the later orders.
struct Cells {
    grid: VolumeGrid,
    factor: usize,
}

impl Cells {
    /// Cells over the resin, from below to above what is lit or wanted.
    fn new(
        vial: &dyn Vial,
        (edge, mu): (f64, f64),
        [lit_low, lit_high]: [f64; 2],
        fine: &VolumeGrid,
    ) -> Self {
        let radius = vial.resin_wall().inscribed_radius();
        // Later orders: a quarter of a millimetre at μ = 1, and 16 cells across
        let factor = ((0.25 / mu).min(radius / 8.0) / edge).floor().max(1.0) as usize;
        // Light that leaves the lit heights and comes back has rarely flown farther
        let margin = radius.min(1.0 / mu);
        let [low, high] = fine.bounds_mm();
        let (low, high) = (low[2].min(lit_low) - margin, high[2].max(lit_high) + margin);
        let count =
            |length: f64| (length / (edge * factor as f64)).ceil().max(2.0) as usize * factor;
        let across = count(2.0 * radius);
        Cells {
            grid: VolumeGrid {
                shape: [count(high - low), across, across],
                pitch_mm: edge,
                center_mm: [0.0, 0.0, (low + high) / 2.0],
            },
            factor,
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
            "model.orders.cell_mm",
            format!("{nz} × {ny} × {nx} cells of {} mm", self.grid.pitch_mm),
            format!("at most {MOST_CELLS} cells: about {edge} mm or more, or [model.scatter]"),
        ))
    }
}
