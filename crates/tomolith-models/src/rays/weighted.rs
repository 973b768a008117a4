//! Unscattered light by direction: the dose of rays that are weighted by a function of their direction in the resin.

use super::Rays;
use super::batch::Bundles;
use super::segment::{Lattice, Segment};
use crate::{DoseLayout, Work, own_frames};
use std::ops::Range;
use tomolith_core::error::Result;
use tomolith_core::field::HostField;
use tomolith_core::grid::VolumeGrid;

/// Of a unit direction (x, y, z) of light in the resin, as the vial sees it.
pub(crate) type Weight = dyn Fn([f64; 3]) -> f64 + Send + Sync;

impl Rays {
    /// doses[i] += the unscattered light of these frames, every ray times weights[i]; without cells of a solid.
    pub(crate) fn add_weighted(
        &self,
        frames: Range<usize>,
        x: &HostField,
        weights: &[Box<Weight>],
        doses: &mut [HostField],
        work: &Work,
    ) -> Result<()> {
        let x = x.as_slice();
        for (light, light_frames) in own_frames(&self.patterns, &frames) {
            let is_lit = |pixel: usize| x[pixel] != 0.0;
            self.for_each_chunk(light, light_frames, is_lit, work, |lit| {
                for (weight, dose) in weights.iter().zip(&mut *doses) {
                    let bundles = weighted(&lit.straight, weight);
                    self.add(&self.lattice, &bundles, x, dose.as_mut_slice());
                }
            })?;
        }
        Ok(())
    }

    /// grad = transpose of [`add_weighted`](Self::add_weighted), in the elements of these frames
    pub(crate) fn collect_weighted(
        &self,
        frames: Range<usize>,
        cotangents: &[HostField],
        weights: &[Box<Weight>],
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let grad = grad.as_mut_slice();
        for (light, light_frames) in own_frames(&self.patterns, &frames) {
            grad[self.patterns[light].elements_of(light_frames.clone())].fill(0.0);
            let all = |_| true;
            self.for_each_chunk(light, light_frames, all, work, |lit| {
                for (weight, c) in weights.iter().zip(cotangents) {
                    let bundles = weighted(&lit.straight, weight);
                    self.collect(&self.lattice, &bundles, c.as_slice(), grad);
                }
            })?;
        }
        Ok(())
    }

    /// The same rays on another grid; without cells of a solid.
    pub(crate) fn on(mut self, grid: VolumeGrid) -> Self {
        self.output = DoseLayout::new("dose", grid, 0);
        self.lattice = Lattice::new(&self.output);
        self
    }

    /// Lowest and highest height (mm) that the light of the lowest and highest pixels of any column reaches in the resin.
    pub(crate) fn heights_mm(&self) -> [f64; 2] {
        let mut heights = [f64::INFINITY, f64::NEG_INFINITY];
        for (source, layout) in self.sources.iter().zip(&self.patterns) {
            let columns = layout.grid.columns;
            for (pair, run) in layout.runs.iter().enumerate().filter(|(_, r)| r.count > 0) {
                for row in [run.bottom, run.bottom + run.count - 1] {
                    source.for_each_path_segment(
                        pair / columns,
                        pair % columns,
                        row as usize,
                        |segment| {
                            for z in [segment.ray.from[2], segment.ray.at(segment.length)[2]] {
                                heights = [heights[0].min(z), heights[1].max(z)];
                            }
                        },
                    );
                }
            }
        }
        heights
    }
}

/// The same segments with their energies times a weight.
fn weighted(bundles: &Bundles, weight: &Weight) -> Bundles {
    std::array::from_fn(|axis| {
        let of_segment = |segment: &Segment| Segment {
            energy: segment.energy * weight(segment.direction(axis)) as f32,
            ..*segment
        };
        bundles[axis].iter().map(of_segment).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rays::{Optics, Params};
    use tomolith_core::check;
    use tomolith_core::dose::DoseModel;
    use tomolith_core::field::Field;
    use tomolith_core::grid::PatternGrid;
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    #[test]
    fn a_weight_sees_the_direction_of_the_light_from_every_side() {
        let grid = VolumeGrid::centered([10, 12, 12], 0.25);
        let vial = IndexMatched { radius_mm: 2.0 };
        // Steps along x, y and z
        for (tilt_rad, azimuth) in [(0.3, 0.4), (0.3, 1.9), (-0.9, 3.5), (0.9, 5.1f64)] {
            let pixels = PatternGrid {
                azimuths: vec![azimuth],
                ..PatternGrid::full_turn(1, 0.0, 1, 1, 0.5)
            };
            let optics = Optics::collimated(0.5).tilted(tilt_rad);
            let light = Light::new(pixels, Resin::absorbing(1.5, 0.1));
            let params = Params::default();
            let rays = Rays::new(&vial, vec![light], &[optics], &params, grid.clone())
                .unwrap()
                .plain();
            let x = check::even_patterns(&rays, 1.0);
            let mut weights: Vec<Box<Weight>> = vec![Box::new(|_| 1.0)];
            for axis in 0..3 {
                weights.push(Box::new(move |direction| direction[axis]));
            }
            let work = Work::new();
            let mut plain = rays.new_dose().unwrap();
            let mut doses = vec![plain.clone(); 4];
            rays.add_weighted(0..1, &x, &weights, &mut doses, &work)
                .unwrap();
            rays.dose_of(0..1, &x, &mut plain, &work).unwrap();
            assert_eq!(plain.as_slice(), doses[0].as_slice());
            let (sin, cos) = tilt_rad.sin_cos();
            let direction = [-cos * azimuth.cos(), -cos * azimuth.sin(), -sin];
            for (axis, expected) in direction.into_iter().enumerate() {
                let found = plain.dot(&doses[1 + axis]) / plain.dot(&plain);
                assert!((found - expected).abs() < 1e-5, "{azimuth}: {axis} {found}");
            }
            let mut grad = rays.new_patterns().unwrap();
            rays.collect_weighted(0..1, &doses, &weights, &mut grad, &work)
                .unwrap();
            let norm: f64 = doses.iter().map(|dose| dose.dot(dose)).sum();
            let found = f64::from(grad.as_slice()[0]);
            assert!((found / norm - 1.0).abs() < 1e-5, "{found} {norm}");
        }
    }
}
