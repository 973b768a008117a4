//! Which pixels are unknowns: those that may be lit, and can help. All others stay dark.
//!
//! *Can help.* The adjoint of an indicator is positive exactly for the pixels that bring light to a voxel that is to be printed,
//! through whatever optics the model has (Nicolet et al. 2024 call the straight case a Radon filter); it says how much, too. With
//! `min_contribution` pixels that bring less than this share of what the best pixel of their light brings stay dark. A millionth of that is rounding: a pixel whose
//! edge meets that of the part brings nothing on one machine, and 10⁻¹⁵ on another.
//!
//! *Background.* Where a light has a smallest value above 0, pixels that miss the part have it, too: they are unknowns.
//!
//! *May be lit.* [`PixelMask`](tomolith_core::grid::PixelMask)s say so: a part of the projector, an image, corners of a vial, dead pixels of a machine.
//!
//! **Fields.** The unknowns of a (frame, column) are one run of rows, from the lowest to the highest that is chosen. Pixels between
//! them that are not are held dark ([`MaskedModel`](super::masked::MaskedModel)): they have no effect and no derivative.

use super::layout::{PatternLayout, PixelRun};
use super::{DoseModel, Work};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::Volume;
use tomolith_core::parallel::{InParallel, elements, table};
use tomolith_optics::light::{Light, Selection};

/// Share of what the best pixel of a light brings, up to which a pixel brings nothing.
const ROUNDING: f32 = 1e-6;

/// What pixels bring to the wanted voxels (file order `[z, y, x]`, any value but 0): the adjoint of an indicator. Of cut voxels the
/// inside cells are wanted.
///
/// # Errors
/// [`Error::Canceled`], [`Error::Shape`].
pub fn contributions(
    model: &dyn DoseModel<Field = HostField>,
    wanted: &Volume<u8>,
    work: &Work,
) -> Result<HostField> {
    let mut marked = model.new_dose()?;
    for layout in model.outputs() {
        if wanted.grid.shape != layout.grid.shape {
            return Err(Error::shape(
                "wanted voxels",
                layout.grid.shape,
                wanted.grid.shape,
            ));
        }
        let marks = layout.field_of(wanted);
        let mut mask = table(marks.len(), |i| f32::from(marks[i] != 0));
        if let Some(cells) = &layout.cells {
            cells.fill([0.0, 1.0], &mut mask);
        }
        marked.as_mut_slice()[layout.range()].copy_from_slice(&mask);
    }
    let mut seen = model.new_patterns()?;
    let dark = seen.zeros_like();
    model.pullback(&dark, &marked, &mut seen, work)?;
    Ok(seen)
}

/// Which pixels of these fields are chosen, given what each brings; None: all bring something.
#[must_use]
pub fn chosen(
    patterns: &[PatternLayout],
    selections: &[Selection],
    contributions: Option<&[f32]>,
) -> Vec<bool> {
    let mut chosen = Vec::with_capacity(patterns.iter().map(PatternLayout::len).sum());
    let brought = |i: usize| contributions.map_or(1.0, |all| all[i]);
    for (layout, selection) in patterns.iter().zip(selections) {
        let (rows, columns) = (layout.grid.rows, layout.grid.columns);
        let all = contributions.map_or(&[][..], |all| &all[layout.range()]);
        let nothing = ROUNDING * all.iter().copied().fold(0.0, f32::max);
        let of_run = |(slot, run): (usize, &PixelRun)| {
            let (bottom, first) = (run.bottom as usize, run.offset);
            (0..run.count as usize).map(move |i| {
                let at = [slot / columns, rows - 1 - bottom - i, slot % columns];
                let is_lit = brought(first + i) > nothing || selection.has_background;
                is_lit && selection.allows(at)
            })
        };
        let frames = layout
            .runs
            .chunks(columns)
            .enumerate()
            .par_map(|(frame, runs)| {
                let runs = (frame * columns..).zip(runs);
                runs.flat_map(of_run).collect::<Vec<bool>>()
            });
        frames
            .iter()
            .for_each(|frame| chosen.extend_from_slice(frame));
        if selection.min_contribution == 0.0 {
            continue;
        }
        // Of the pixels that may be lit the best one is the measure
        let range = layout.range();
        let light = chosen[range.clone()].iter().zip(range.clone());
        let best = light
            .map(|(&chosen, i)| if chosen { brought(i) } else { 0.0 })
            .fold(0.0, f32::max);
        let least = (f64::from(best) * selection.min_contribution) as f32;
        if least > 0.0 {
            let first = range.start;
            elements(&mut chosen[range], |i, chosen| {
                *chosen &= brought(first + i) >= least
            });
        }
    }
    chosen
}

/// For each light the rows `(bottom, count)` of each (frame, column), from the lowest to the highest that is chosen.
#[must_use]
pub fn rows_of(patterns: &[PatternLayout], chosen: &[bool]) -> Vec<Vec<(u32, u32)>> {
    let rows = |run: &PixelRun| {
        let pixels = &chosen[run.offset..][..run.count as usize];
        let first = pixels.iter().position(|&c| c);
        let last = pixels.iter().rposition(|&c| c);
        first
            .zip(last)
            .map_or((0, 0), |(a, b)| (run.bottom + a as u32, (b - a + 1) as u32))
    };
    let of_light = |layout: &PatternLayout| {
        let frames = layout.runs.chunks(layout.grid.columns.max(1));
        let frames = frames.par_map(|runs| runs.iter().map(rows).collect::<Vec<_>>());
        frames.concat()
    };
    patterns.iter().map(of_light).collect()
}

/// Where the active pixels of lights lie in a field.
pub(super) fn layouts(lights: &[Light]) -> Vec<PatternLayout> {
    let mut offset = 0;
    let layout = |light: &Light| {
        let layout = light.layout(offset);
        offset += layout.len();
        layout
    };
    lights.iter().map(layout).collect()
}

/// Makes the active rows of lights those of the chosen pixels; the pixels between them that stay dark all the same, in the order
/// of the field of these rows, where a selection asks for it.
pub(super) fn narrow(
    lights: &mut [Light],
    patterns: &[PatternLayout],
    contributions: Option<&[f32]>,
) -> Vec<bool> {
    let selections: Vec<Selection> = lights.iter().map(|l| l.selection.clone()).collect();
    let chosen = chosen(patterns, &selections, contributions);
    let rows = rows_of(patterns, &chosen);
    let mut dark = Vec::new();
    let any = selections.iter().any(Selection::is_any);
    for ((light, layout), rows) in lights.iter_mut().zip(patterns).zip(rows) {
        let is_any = light.selection.is_any();
        let runs = layout.runs.iter().zip(&rows);
        for (run, &(bottom, count)) in runs.filter(|(_, r)| any && r.1 > 0) {
            let first = run.offset + (bottom - run.bottom) as usize;
            let pixels = &chosen[first..first + count as usize];
            dark.extend(pixels.iter().map(|&chosen| is_any && !chosen));
        }
        light.active = Some(rows);
    }
    if dark.contains(&true) {
        dark
    } else {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matrix;
    use crate::parallel::Parallel;
    use crate::rays::{self, Optics};
    use crate::{Family, OpticalScene, Purpose, monte_carlo, planner, successive_orders};
    use std::sync::Arc;
    use tomolith_core::check;
    use tomolith_core::grid::{PatternGrid, PixelMask, VolumeGrid};
    use tomolith_optics::phase::{Scattering, rayleigh::Rayleigh};
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    const VIAL: IndexMatched = IndexMatched { radius_mm: 2.0 };

    fn light() -> Light {
        let pixels = PatternGrid::full_turn(5, 0.1, 12, 16, 0.1);
        Light::new(pixels, Resin::absorbing(1.48, 0.2))
    }

    /// Three rows at the bottom, and one pixel near the middle, may not be lit.
    fn mask() -> Arc<PixelMask> {
        Arc::new(PixelMask::new([1, 12, 16], |_, row, column| {
            row < 9 && [row, column] != [6, 8]
        }))
    }

    fn scene<'a>(lights: &'a [Light], optics: &'a [Optics]) -> OpticalScene<'a> {
        OpticalScene::new(&VIAL, lights, optics, Purpose::Optimize)
    }

    fn part(grid: &VolumeGrid) -> Volume<u8> {
        let mut part = Volume::filled(grid.clone(), 0u8);
        for iz in 1..6 {
            part.values[grid.index(iz, 4, 4)] = 1;
            part.values[grid.index(iz, 5, 4)] = 1;
        }
        part
    }

    #[test]
    #[ignore = "slow"]
    fn the_unknowns_of_every_model_are_those_that_may_be_lit_and_reach_the_part() {
        let grid = VolumeGrid::centered([8, 8, 8], 0.15);
        let part = part(&grid);
        let families: [(Family, bool); 4] = [
            (Arc::new(crate::parallel::Params::default()), false),
            (Arc::new(rays::Params::default()), false),
            (Arc::new(monte_carlo::Params::default()), true),
            (Arc::new(successive_orders::Params::default()), true),
        ];
        for (family, scatters) in families {
            let mut optics = [Optics::collimated(0.1)];
            let mut light = light();
            if scatters {
                light.resin.attenuation_per_mm = 0.5;
                optics[0].scattering = Some(Scattering::new(0.3, Rayleigh {}));
            }
            let planned = |light: Light| {
                let (lights, work) = (&[light], Work::new());
                let scene = scene(lights, &optics);
                planner::plan(Some(&family), scene, &grid, Some(&part), &work).unwrap()
            };
            let plain = planned(light.clone());
            light.selection.masks = vec![mask()];
            let masked = planned(light.clone());
            // The gradient of an even dose is what was there, and 0 where no pixel may be lit
            let gradient = |plan: &planner::ModelPlan| {
                let mut c = plan.model.new_dose().unwrap();
                c.fill(1.0);
                let x = check::adjoint(&plan.model, &c);
                plan.model.patterns()[0].patterns_of(x.as_slice())
            };
            let (before, after) = (gradient(&plain), gradient(&masked));
            let mut lost = 0;
            for (i, (&b, &a)) in before.values.iter().zip(&after.values).enumerate() {
                let (row, column) = (i / 16 % 12, i % 16);
                let expected = if mask().allows([0, row, column]) {
                    b
                } else {
                    0.0
                };
                assert!(
                    (a - expected).abs() <= 1e-6 * b.abs(),
                    "{family:?} {row} {column}"
                );
                lost += usize::from(b != a);
            }
            assert!(lost > 5, "{family:?}: {lost}");
            assert!(masked.model.patterns()[0].len() < plain.model.patterns()[0].len());
            // Light of a pixel that may not be lit has no effect
            let x = check::even_patterns(&masked.model, 1.0);
            assert_eq!(masked.dark.len(), x.len());
            let mut darkened = x.clone();
            super::super::masked::darken(darkened.as_mut_slice(), &masked.dark);
            assert_ne!(darkened.as_slice(), x.as_slice());
            let [whole, part] = [&x, &darkened].map(|x| check::dose(&masked.model, x));
            assert_eq!(whole.as_slice(), part.as_slice());
        }
    }

    #[test]
    fn pixels_of_a_stored_matrix_that_may_not_be_lit_stay_dark() {
        let grid = VolumeGrid::centered([8, 8, 8], 0.15);
        let all = Parallel::new(&VIAL, vec![light()], grid.clone()).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("matrix.npz");
        matrix::export(&all, &file, &Work::new()).unwrap();
        let optics = [Optics::collimated(0.1)];
        let mut light = light();
        light.selection.masks = vec![mask()];
        let family: Family = Arc::new(matrix::Params { file });
        let (scene, work) = (scene(std::slice::from_ref(&light), &optics), Work::new());
        let plan = planner::plan(Some(&family), scene, &grid, None, &work).unwrap();
        let mut c = plan.model.new_dose().unwrap();
        c.fill(1.0);
        let x = check::adjoint(&plan.model, &c);
        let gradient = plan.model.patterns()[0].patterns_of(x.as_slice());
        let mut lit = 0;
        for (i, &value) in gradient.values.iter().enumerate() {
            let may = mask().allows([0, i / 16 % 12, i % 16]);
            assert!(may || value == 0.0);
            lit += usize::from(value > 0.0);
        }
        assert!(lit > 200, "{lit}");
    }

    #[test]
    fn pixels_that_bring_less_than_their_share_of_the_best_one_stay_dark() {
        let grid = VolumeGrid::centered([8, 8, 8], 0.15);
        let part = part(&grid);
        let all = Parallel::new(&VIAL, vec![light()], grid.clone()).unwrap();
        let brought = contributions(&all, &part, &Work::new()).unwrap();
        let best = brought.as_slice().iter().copied().fold(0.0, f32::max);
        let mut lit = Vec::new();
        for least in [0.0, 0.3, 0.999] {
            let mut light = light();
            light.selection.min_contribution = least;
            let selections = [light.selection.clone()];
            let chosen = chosen(all.patterns(), &selections, Some(brought.as_slice()));
            for (&chosen, &brought) in chosen.iter().zip(brought.as_slice()) {
                let enough = brought > 1e-6 * best && f64::from(brought) >= least * f64::from(best);
                assert_eq!(chosen, enough);
            }
            lit.push(chosen.iter().filter(|c| **c).count());
        }
        assert!(lit[0] > lit[1] && lit[1] > lit[2] && lit[2] > 0, "{lit:?}");
    }
}
