//! Pixels that spread their light over their neighbors before it enters the vial: F(Bx), with the derivative Bᵀ·F′(Bx)ᵀ, which
//! [`MaskedModel`](super::masked::MaskedModel) makes of a model F.
//!
//! B is the [`PointSpread`] of each light, frame by frame: linear, so a line polynomial of F stays one. F has more active pixels than the
//! patterns: all that their light is spread to.
//!
//! **Limits** Patterns of energy: amplitudes of waves do not add up so. Light that is spread beyond the image is lost.
//!
//! **Cost** of a frame: its active pixels times those of the spread, as sums along z.

use super::{PatternLayout, ZCoupling, own_frames};
use std::ops::Range;
use std::sync::Arc;
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;
use tomolith_optics::point_spread::PointSpread;

/// The same lights with every pixel active that light is spread to.
pub(crate) fn widened(lights: &[Light]) -> Vec<Light> {
    let wide = |light: &Light| {
        let mut wide = light.clone();
        if let (Some(spread), Some(active)) = (&light.point_spread, &light.active) {
            let size = [light.pixels.columns, light.pixels.rows];
            let frames = active.chunks(size[0].max(1));
            wide.active = Some(
                frames
                    .flat_map(|frame| dilated(frame, spread, size))
                    .collect(),
            );
        }
        wide
    };
    lights.iter().map(wide).collect()
}

/// Active rows `(bottom, count)` of the columns of a frame, and those that a spread reaches from them.
fn dilated(
    active: &[(u32, u32)],
    spread: &PointSpread,
    [columns, rows]: [usize; 2],
) -> Vec<(u32, u32)> {
    let reach = spread.reach();
    let run_of = |column: usize| {
        let near = column.saturating_sub(reach[0])..(column + reach[0] + 1).min(columns);
        let lit = || active[near.clone()].iter().filter(|run| run.1 > 0);
        let bottom = lit().map(|run| run.0).min();
        let top = lit().map(|run| run.0 + run.1).max();
        bottom.zip(top).map_or((0, 0), |(bottom, top)| {
            let bottom = bottom.saturating_sub(reach[1] as u32);
            let top = (top + reach[1] as u32).min(rows as u32);
            (bottom, top - bottom)
        })
    };
    (0..columns).map(run_of).collect()
}

/// B of every light; see the [module page](self).
pub(crate) struct Spreads {
    /// Of the patterns before they are spread.
    pub(crate) patterns: Vec<PatternLayout>,
    /// One per light; None: every pixel keeps its light.
    lights: Vec<Option<Arc<PointSpread>>>,
}

impl Spreads {
    /// Those of the lights, for their patterns.
    pub(crate) fn new(patterns: Vec<PatternLayout>, lights: &[Light]) -> Self {
        let lights = lights.iter().map(|light| light.point_spread.clone());
        Spreads {
            patterns,
            lights: lights.collect(),
        }
    }

    /// How far light reaches along z from its row, before and in a model.
    pub(crate) fn z_reach(&self, model: ZCoupling) -> ZCoupling {
        let of_light = |(layout, spread): (&PatternLayout, &Option<Arc<PointSpread>>)| {
            let rows = spread.as_ref().map_or(0, |spread| spread.reach()[1]);
            rows as f64 * layout.grid.pitch_mm[1]
        };
        let lights = self.patterns.iter().zip(&self.lights);
        let reach = lights.map(of_light).fold(0.0, f64::max);
        match model {
            ZCoupling::None if reach == 0.0 => ZCoupling::None,
            ZCoupling::None => ZCoupling::Halo(reach),
            ZCoupling::Halo(inner) => ZCoupling::Halo(inner + reach),
            ZCoupling::Full => ZCoupling::Full,
        }
    }

    /// to ← B·from of some frames, `lit` the layouts of patterns that are spread; or Bᵀ·from where the sign is −1: the same sums with the spread
    /// turned about its middle.
    pub(crate) fn carry(
        &self,
        frames: &Range<usize>,
        lit: &[PatternLayout],
        from: &[f32],
        to: &mut [f32],
        sign: isize,
    ) {
        for (light, light_frames) in own_frames(&self.patterns, frames) {
            let (plain, lit) = (&self.patterns[light], &lit[light]);
            let (source, sink) = if sign > 0 { (plain, lit) } else { (lit, plain) };
            let elements = sink.elements_of(light_frames.clone());
            let Some(spread) = &self.lights[light] else {
                to[elements].copy_from_slice(&from[source.elements_of(light_frames)]);
                continue;
            };
            let images = sink.split_frames(light_frames, &mut to[elements]);
            images.into_iter().par_each(|(frame, image)| {
                let carried = Carried {
                    source,
                    sink,
                    spread,
                    sign,
                };
                carried.frame(frame, from, image);
            });
        }
    }

    /// What to add to the description of a model.
    pub(crate) fn describe(&self) -> String {
        let text_of = |spread: &Arc<PointSpread>| {
            let [columns, rows] = spread.reach().map(|n| 2 * n + 1);
            format!(", spread over {columns} × {rows} pixels")
        };
        self.lights.iter().flatten().map(text_of).collect()
    }
}

/// The light of one image on its way to another.
struct Carried<'a> {
    source: &'a PatternLayout,
    sink: &'a PatternLayout,
    spread: &'a PointSpread,
    sign: isize,
}

impl Carried<'_> {
    /// Fills the elements of one frame.
    fn frame(&self, frame: usize, from: &[f32], image: &mut [f32]) {
        image.fill(0.0);
        let columns = self.sink.grid.columns;
        let reach = self.spread.reach()[0] as isize;
        let mut rest = image;
        for column in 0..columns {
            let count = self.sink.runs[frame * columns + column].count as usize;
            let pixels;
            (pixels, rest) = rest.split_at_mut(count);
            for along in -reach..=reach {
                let Some(other) = column.checked_add_signed(-along) else {
                    continue;
                };
                if other < columns {
                    self.column(
                        [frame * columns + column, frame * columns + other],
                        along,
                        from,
                        pixels,
                    );
                }
            }
        }
    }

    /// Adds what the light of one column brings to another, so many columns further.
    fn column(&self, [to, other]: [usize; 2], along: isize, from: &[f32], pixels: &mut [f32]) {
        let (sink, source) = (self.sink.runs[to], self.source.runs[other]);
        let lit = &from[source.offset..][..source.count as usize];
        let reach = self.spread.reach()[1] as isize;
        // Where the first lit row lies among the rows of the other column, which count upward
        let begin = source.bottom as isize - sink.bottom as isize;
        for up in -reach..=reach {
            let share = self.spread.at(-self.sign * up, self.sign * along);
            let first = begin + up;
            let (skipped, at) = ((-first).max(0) as usize, first.max(0) as usize);
            let (Some(lit), Some(pixels)) = (lit.get(skipped..), pixels.get_mut(at..)) else {
                continue;
            };
            for (sum, value) in pixels.iter_mut().zip(lit) {
                *sum += share * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planner::{ModelPlan, plan};
    use crate::rays::Optics;
    use crate::{DoseModel, OpticalScene, Purpose, Work};
    use tomolith_core::check;
    use tomolith_core::field::Field;
    use tomolith_core::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    /// Lopsided, so that up and down, left and right, B and Bᵀ differ: `[row][column]`.
    const SHARES: [f32; 15] = [
        1.0, 2.0, 3.0, 0.0, 0.0, //
        0.0, 4.0, 9.0, 2.0, 1.0, //
        0.0, 0.0, 3.0, 0.0, 5.0,
    ];

    fn lights() -> Vec<Light> {
        let plain = |frames, columns| {
            let pixels = PatternGrid::full_turn(frames, 0.1, 12, columns, 0.1);
            Light::new(pixels, Resin::absorbing(1.48, 0.2))
        };
        let spread = PointSpread::new([5, 3], &SHARES).unwrap();
        let spreading = Light {
            point_spread: Some(Arc::new(spread)),
            ..plain(6, 16)
        };
        vec![plain(4, 14), spreading]
    }

    fn planned(lights: &[Light], wanted: Option<&Volume<u8>>) -> ModelPlan {
        let optics = [Optics::collimated(0.1), Optics::collimated(0.1)];
        let vial = IndexMatched { radius_mm: 2.0 };
        let scene = OpticalScene::new(&vial, lights, &optics, Purpose::Optimize);
        plan(None, scene, &grid(), wanted, &Work::new()).unwrap()
    }

    fn grid() -> VolumeGrid {
        VolumeGrid::centered([8, 8, 8], 0.15)
    }

    fn wanted() -> Volume<u8> {
        let mut wanted = Volume::filled(grid(), 0u8);
        for iz in 2..6 {
            wanted.values[grid().index(iz, 4, 3)] = 1;
        }
        wanted
    }

    /// The spread by its definition on whole images.
    fn spread_images(patterns: &Patterns) -> Patterns {
        let sum: f32 = SHARES.iter().sum();
        let mut lit = Patterns::dark(patterns.grid.clone());
        let [_, rows, columns] = patterns.grid.shape().map(|n| n as isize);
        for (i, sum_here) in lit.values.iter_mut().enumerate() {
            let i = i as isize;
            let (frame, row, column) = (i / (rows * columns), i / columns % rows, i % columns);
            for (k, share) in SHARES.iter().enumerate() {
                let from = [row - (k as isize / 5 - 1), column - (k as isize % 5 - 2)];
                if (0..rows).contains(&from[0]) && (0..columns).contains(&from[1]) {
                    let from = (frame * rows + from[0]) * columns + from[1];
                    *sum_here += share / sum * patterns.values[from as usize];
                }
            }
        }
        lit
    }

    #[test]
    fn the_dose_is_that_of_patterns_spread_by_the_image_as_it_stands() {
        let lights = lights();
        let plain = |light: &Light| Light {
            point_spread: None,
            ..light.clone()
        };
        let plain: Vec<Light> = lights.iter().map(plain).collect();
        // Unknowns that reach the part alone; the light that spreads to their neighbors must not get lost
        let (blurred, plain) = (planned(&lights, Some(&wanted())), planned(&plain, None));
        let (blurred, plain) = (blurred.model, plain.model);
        let mut x = check::noisy_patterns(&blurred, 3);
        x.as_mut_slice().iter_mut().for_each(|v| *v = v.abs());
        let mut y = plain.new_patterns().unwrap();
        assert!(x.len() < y.len() / 2);
        for (i, (lit, all)) in blurred.patterns().iter().zip(plain.patterns()).enumerate() {
            let images = lit.patterns_of(x.as_slice());
            let images = if i == 1 {
                spread_images(&images)
            } else {
                images
            };
            all.fill_field(&images, y.as_mut_slice());
        }
        let (found, expected) = (check::dose(&blurred, &x), check::dose(&plain, &y));
        let (found, expected) = (found.as_slice(), expected.as_slice());
        assert!(check::difference(found, expected) < 1e-5);
        for (lit, all) in blurred.patterns().iter().zip(plain.patterns()) {
            all.fill_field(&lit.patterns_of(x.as_slice()), y.as_mut_slice());
        }
        let unspread = check::dose(&plain, &y);
        assert!(check::difference(unspread.as_slice(), expected) > 0.05);
    }

    #[test]
    fn it_is_an_exact_pair() {
        let wanted = wanted();
        for wanted in [None, Some(&wanted)] {
            let model = planned(&lights(), wanted).model;
            check::model::model(&model, 5).unwrap();
            assert!(model.describe().contains("spread over 5 × 3 pixels"));
        }
    }
}
