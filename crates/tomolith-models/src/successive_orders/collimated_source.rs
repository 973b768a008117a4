//! Collimated light normal to the axis as a source: one field for each order of its azimuth.
//!
//! All harmonics of one order m of the azimuth φ are cos mφ, or sin |m|φ, times a number in the plane of the light; so `parallel` with
//! patterns weighted by these serves them all, and those that are odd in z are 0.

use super::bins::Bins;
use super::harmonics::Harmonic;
use super::scattered_light::DeltaScaledPhase;
use super::unscattered_source::{Channel, UnscatteredSource};
use crate::Work;
use crate::parallel::Parallel;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;
use tomolith_core::dose::DoseModel;
use tomolith_core::dose::scattered::{self, LightOnCells};
use tomolith_core::dose::strips::StripForm;
use tomolith_core::error::Result;
use tomolith_core::field::HostField;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// See the [module page](self).
pub(super) struct CollimatedSource {
    bins: Bins,
    /// Light of bins on cells.
    parallel: Parallel,
    channels: Vec<Channel>,
    /// Of each channel cos mφ, or sin |m|φ for m < 0, of each (frame, column).
    weights: Vec<Vec<f32>>,
}

impl CollimatedSource {
    /// Of a light's pixels in bins, and the light of these on cells.
    pub(super) fn new(
        vial: &dyn Vial,
        light: &Light,
        bins: Bins,
        parallel: Parallel,
        delta_scaled: &DeltaScaledPhase,
    ) -> Self {
        let azimuths = azimuths(vial, light);
        let orders = orders_of_azimuth(delta_scaled);
        let of_column = |&m: &isize| azimuths.iter().map(|&phi| around(m, phi) as f32).collect();
        CollimatedSource {
            bins,
            parallel,
            weights: orders.iter().map(of_column).collect(),
            channels: orders.iter().map(|&m| channel(delta_scaled, m)).collect(),
        }
    }
}

impl UnscatteredSource for CollimatedSource {
    fn channels(&self) -> &[Channel] {
        &self.channels
    }

    fn fields(&self, frames: Range<usize>, x: &[f32], work: &Work) -> Result<Vec<HostField>> {
        let mut weighted = self.parallel.new_patterns()?;
        let rows = self.bins.in_rows(x);
        let of_channel = |weights: &Vec<f32>| {
            self.bins.fill(&rows, weights, weighted.as_mut_slice());
            let mut field = self.parallel.new_dose()?;
            self.parallel
                .dose_of(frames.clone(), &weighted, &mut field, work)?;
            Ok(field)
        };
        self.weights.iter().map(of_channel).collect()
    }

    fn add_adjoint(
        &self,
        frames: Range<usize>,
        fields: &[HostField],
        grad: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let mut patterns = self.parallel.new_patterns()?;
        let mut rows = self.bins.dark_rows();
        for (field, weights) in fields.iter().zip(&self.weights) {
            self.parallel
                .collect(frames.clone(), field, &mut patterns, work)?;
            (self.bins).add_back(frames.clone(), patterns.as_slice(), weights, &mut rows);
        }
        self.bins.add_rows(frames, &rows, grad);
        Ok(())
    }

    fn updates(&self) -> u64 {
        self.channels.len() as u64 * self.parallel.updates()
    }

    fn form(&self, _run: &Work) -> Result<Option<(scattered::Bins, LightOnCells)>> {
        let cells = StripForm::new(self.parallel.geometry());
        let light = LightOnCells::Strips(cells, self.weights.clone());
        Ok(Some((self.bins.form(), light)))
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

/// Orders m of the azimuth that light normal to the axis has.
fn orders_of_azimuth(delta_scaled: &DeltaScaledPhase) -> Vec<isize> {
    let mut orders: Vec<isize> = Vec::new();
    for harmonic in delta_scaled.harmonics() {
        if level(harmonic) != 0.0 && !orders.contains(&harmonic.m) {
            orders.push(harmonic.m);
        }
    }
    orders
}

/// What the unscattered light of one order of the azimuth tells.
fn channel(delta_scaled: &DeltaScaledPhase, m: isize) -> Channel {
    let harmonics = delta_scaled.harmonics().into_iter().filter(|h| h.m == m);
    let weighted = harmonics.map(|harmonic| (harmonic, level(harmonic)));
    Channel(weighted.filter(|&(_, weight)| weight != 0.0).collect())
}

/// A harmonic in the plane z = 0, over cos mφ or sin |m|φ.
fn level(harmonic: Harmonic) -> f64 {
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

/// The azimuth of light in the resin, of each (frame, column); 0 where none arrives.
fn azimuths(vial: &dyn Vial, light: &Light) -> Vec<f64> {
    let tracer = light.tracer(vial);
    let pixels = &light.pixels;
    (0..pixels.frames() * pixels.columns)
        .map(|i| {
            let (frame, column) = (i / pixels.columns, i % pixels.columns);
            let path = tracer.trace(pixels.column_u(column), pixels.azimuths[frame]);
            path.segments.first().map_or(0.0, |segment| {
                segment.direction[1].atan2(segment.direction[0])
            })
        })
        .collect()
}
