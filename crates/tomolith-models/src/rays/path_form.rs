//! Unscattered light and random paths of what is scattered, as data that a backend computes elsewhere: see [`tomolith_core::dose::paths`].
//!
//! **Limits** Paths whose last surface is the wall of the resin: a round or square vial, with or without ends, in whose even resin nothing stands and whose
//! reflections are not followed. Voxels that no surface cuts; energy along exact line integrals.

use super::form::Wanted;
use super::{Accumulation, Optics, Rays, batch};
use crate::{DoseModel, Work};
use std::f64::consts::PI;
use std::sync::Arc;
use tomolith_core::dose::form::{Form, Masked};
use tomolith_core::dose::paths::{LightPaths, PathGeometry, PhaseForm, ResinWall};
use tomolith_core::error::Result;
use tomolith_optics::light::Light;
use tomolith_optics::phase::Phase;
use tomolith_optics::space::TraceLimits;
use tomolith_optics::vial::CrossSection;

/// Intervals of the inverse of a distribution, and steps of the angle in which it is summed up: the latter resolve a lobe of 0.1°.
const INTERVALS: usize = 1 << 12;
const STEPS: usize = 1 << 16;

/// Rays whose paths are followed to count the cells that they pass.
const COUNTED: usize = 2 * batch::CHUNK;

impl Rays {
    /// The form of a model of scattered light, whose unscattered light is `straight`; None where what is scattered is more than a form says.
    pub(crate) fn to_path_form(
        &self,
        straight: &Rays,
        lights: &[Light],
        optics: &[Optics],
        limits: &TraceLimits,
        work: &Work,
    ) -> Result<Option<Form>> {
        let is_plain = self.accumulation == Accumulation::Integral && self.solid.is_none();
        let seed = self.sources.first().and_then(|source| source.first_seed());
        let (Some(grid), Some(seed), Some((curve, ends)), true) =
            (&self.scatter_grid, seed, self.last_wall(), is_plain)
        else {
            return Ok(None);
        };
        let half = curve.as_circle().or(curve.as_square());
        let (Some((cells, sharpened)), Some(half)) = (grid.form(), half) else {
            return Ok(None);
        };
        let Some(geometry) = straight.geometry(Wanted::All, work)? else {
            return Ok(None);
        };
        let pitch = cells.layout.grid.pitch_mm;
        let [x, y] = grid.lattice.corner();
        let [low, lowest] =
            [&self.output, &cells.layout].map(|layout| layout.grid.bounds_mm()[0][2]);
        let edge = (pitch / self.output.grid.pitch_mm).round() as usize;
        let mut of_lights = Vec::new();
        for (i, (light, optics)) in lights.iter().zip(optics).enumerate() {
            let total = light.resin.attenuation_per_mm;
            let scattering = optics.scattering.as_ref().filter(|s| s.per_mm > 0.0);
            let paths = scattering.filter(|_| total > 0.0).map(|scattering| {
                let active = light.resin.uptake().active_per_mm;
                let emitted = active * self.area(i) / pitch.powi(2);
                LightPaths {
                    albedo: (scattering.per_mm / total) as f32,
                    phase: form_of(scattering.phase.as_ref()),
                    least: (limits.least_power * emitted) as f32,
                    updates: self.cells_passed(i),
                }
            });
            of_lights.push(paths);
            work.check()?;
        }
        Ok(Some(Form::Paths(Masked::new(PathGeometry {
            straight: Arc::new(geometry),
            lights: of_lights,
            wall: ResinWall {
                is_round: curve.as_circle().is_some(),
                half: (half / pitch) as f32,
                ends: ends.map(|z| ((z - lowest) / pitch) as f32),
            },
            edge,
            corner: [x, y, ((lowest - low) / pitch) as f32],
            cells,
            sharpened,
            orders: limits.orders,
            seed,
            renew: self.renew,
            summary: self.describe(),
        }))))
    }

    /// The wall at which light of every source leaves the resin for ever.
    fn last_wall(&self) -> Option<(CrossSection, [f64; 2])> {
        let mut walls = self.sources.iter().map(|source| source.tracer.last_wall());
        let first = walls.next()??;
        walls.all(|wall| wall == Some(first)).then_some(first)
    }

    /// About how many cells the paths of all frames of a light pass.
    fn cells_passed(&self, light: usize) -> u64 {
        let layout = &self.patterns[light];
        let rays = (layout.len() * self.sources[light].rays()).max(1);
        let step = rays.div_ceil(COUNTED).min(layout.runs.len()).max(1);
        let (mut passed, mut pixels) = (0.0, 0);
        for pair in (0..layout.runs.len()).step_by(step) {
            let bundles = self.bundles(light, pair..pair + 1, |_| true);
            let segments = bundles.scattered.iter().flatten();
            passed += segments.map(super::Segment::passed).sum::<f64>();
            pixels += layout.runs[pair].count as usize;
        }
        (passed * layout.len() as f64 / pixels.max(1) as f64) as u64
    }
}

/// A phase function as data.
fn form_of(phase: &dyn Phase) -> PhaseForm {
    match phase.henyey_greenstein() {
        Some(g) => PhaseForm::HenyeyGreenstein(g as f32),
        None => PhaseForm::Table(inverse(phase).into()),
    }
}

/// The cosines below which the parts 0, 1/n … 1 of the light go.
fn inverse(phase: &dyn Phase) -> Vec<f32> {
    let angle = |i: f64| PI * (1.0 - i / STEPS as f64);
    let mut below = vec![0.0];
    for i in 0..STEPS {
        let middle = angle(i as f64 + 0.5);
        below.push(below[i] + phase.density(middle.cos()) * middle.sin());
    }
    let whole = below[STEPS];
    let cosine = |k: usize| {
        let wanted = whole * k as f64 / INTERVALS as f64;
        let i = below.partition_point(|&sum| sum < wanted).clamp(1, STEPS);
        let (low, high) = (below[i - 1], below[i]);
        let part = if high > low {
            (wanted - low) / (high - low)
        } else {
            0.0
        };
        angle((i - 1) as f64 + part).cos() as f32
    };
    (0..=INTERVALS).map(cosine).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::near;
    use tomolith_optics::phase::{henyey_greenstein::HenyeyGreenstein, rayleigh::Rayleigh};

    #[test]
    fn a_table_of_a_phase_function_has_its_cosines() {
        // Rayleigh's distribution of the cosine c is ½ + ⅜(c + c³/3)
        for (k, &c) in inverse(&Rayleigh {}).iter().enumerate() {
            let c = f64::from(c);
            near!(
                0.5 + 0.375 * (c + c.powi(3) / 3.0),
                k as f64 / INTERVALS as f64,
                1e-6,
                "{k}"
            );
        }
        // With straight lines between its places, a narrow lobe keeps its mean cosine
        for g in [-0.5, 0.9, 0.99] {
            let table = inverse(&HenyeyGreenstein { g });
            let pairs = table.windows(2).map(|c| f64::from(c[0] + c[1]) / 2.0);
            near!(
                pairs.sum::<f64>() / INTERVALS as f64,
                g,
                1e-3 * (1.0 - g.abs()),
                "{g}"
            );
        }
        assert_eq!(
            form_of(&HenyeyGreenstein { g: 0.3 }),
            PhaseForm::HenyeyGreenstein(0.3)
        );
    }
}
