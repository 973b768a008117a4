//! Light of any directions as a source: one field for each harmonic, by rays that are weighted by their direction in the resin.
//!
//! Without a gradient of the index a ray keeps its direction in the resin, so the moment a of its light is its dose times Y_a of
//! that direction: rays are traced once for all a, and walked once for each.

use super::bins::Bins;
use super::harmonics::Harmonic;
use super::scattered_light::DeltaScaledPhase;
use super::unscattered_source::{Channel, UnscatteredSource};
use crate::Work;
use crate::rays::Rays;
use crate::rays::weighted::Weight;
use std::ops::Range;
use tomolith_core::dose::DoseModel;
use tomolith_core::dose::rays::RayForm;
use tomolith_core::dose::scattered::{self, LightOnCells};
use tomolith_core::error::Result;
use tomolith_core::field::HostField;

/// See the [module page](self).
pub(super) struct DivergentSource {
    bins: Bins,
    /// Light of bins on cells.
    rays: Rays,
    harmonics: Vec<Harmonic>,
    channels: Vec<Channel>,
    weights: Vec<Box<Weight>>,
    /// 1 for each (frame, column): bins of pixels as bright as these.
    even: Vec<f32>,
}

impl DivergentSource {
    /// Of a light's pixels in bins, and the rays of these on cells.
    pub(super) fn new(bins: Bins, rays: Rays, delta_scaled: &DeltaScaledPhase) -> Self {
        let harmonics = delta_scaled.harmonics();
        let even = vec![1.0; bins.slots()];
        let channel = |&harmonic| Channel(vec![(harmonic, 1.0)]);
        DivergentSource {
            channels: harmonics.iter().map(channel).collect(),
            weights: harmonics
                .iter()
                .map(|&harmonic| -> Box<Weight> {
                    let norm = harmonic.norm();
                    Box::new(move |direction| norm * harmonic.form(direction))
                })
                .collect(),
            harmonics,
            bins,
            rays,
            even,
        }
    }
}

impl UnscatteredSource for DivergentSource {
    fn channels(&self) -> &[Channel] {
        &self.channels
    }

    fn fields(&self, frames: Range<usize>, x: &[f32], work: &Work) -> Result<Vec<HostField>> {
        let mut binned = self.rays.new_patterns()?;
        let rows = self.bins.in_rows(x);
        self.bins.fill(&rows, &self.even, binned.as_mut_slice());
        let dark = |_| self.rays.new_dose();
        let mut fields: Vec<HostField> = (self.channels.iter()).map(dark).collect::<Result<_>>()?;
        self.rays
            .add_weighted(frames, &binned, &self.weights, &mut fields, work)?;
        Ok(fields)
    }

    fn add_adjoint(
        &self,
        frames: Range<usize>,
        fields: &[HostField],
        grad: &mut [f32],
        work: &Work,
    ) -> Result<()> {
        let mut patterns = self.rays.new_patterns()?;
        self.rays
            .collect_weighted(frames.clone(), fields, &self.weights, &mut patterns, work)?;
        let mut rows = self.bins.dark_rows();
        (self.bins).add_back(frames.clone(), patterns.as_slice(), &self.even, &mut rows);
        self.bins.add_rows(frames, &rows, grad);
        Ok(())
    }

    fn updates(&self) -> u64 {
        self.channels.len() as u64 * self.rays.updates()
    }

    fn form(&self, work: &Work) -> Result<Option<(scattered::Bins, LightOnCells)>> {
        let harmonics = self.harmonics.iter().map(|harmonic| harmonic.to_form());
        let harmonics = harmonics.collect();
        let light = |rays| LightOnCells::Rays(RayForm::new(rays), harmonics);
        Ok(self
            .rays
            .in_grid(work)?
            .map(light)
            .map(|light| (self.bins.form(), light)))
    }
}
