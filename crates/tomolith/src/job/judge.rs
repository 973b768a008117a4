//! The judgement of patterns: their dose is simulated again and measured.
//!
//! Both `run` and `simulate` end here, with the patterns that stand in `patterns.npz`, so that they report the same
//! numbers to the last bit.

use super::progress::{Event, Progress};
use super::scene::{Scene, Voxels};
use crate::error::Result;
use crate::field::BLOCK;
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::metrics::print::{PatternStats, Print};
use crate::metrics::{Evaluation, evaluate};
use crate::models::parallel::Light;
use crate::models::{Run, planner};
use rayon::prelude::*;

/// What patterns are worth.
pub(crate) struct Judged {
    /// Written patterns, turning vial, finer grid: the headline.
    pub(crate) evaluation: Evaluation,
    /// The same with the vial standing still during each frame.
    pub(crate) standing: Evaluation,
    /// Raw patterns on the optimisation's own grid, when there are raw ones.
    pub(crate) optimisation: Option<Evaluation>,
    /// Dose of the headline, averaged to the optimisation's voxels.
    pub(crate) dose: Volume<f32>,
    /// The target on the finer grid.
    pub(crate) fine: Voxels,
    /// Response of the headline on the finer grid.
    pub(crate) response: Volume<f32>,
}

/// Simulates and measures patterns, per light: the written ones, and the raw ones they were made from.
///
/// # Errors
/// [`Error::Cancelled`](crate::Error::Cancelled), [`Error::NonFinite`](crate::Error::NonFinite), and what the model
/// refuses.
pub(crate) fn judge(
    scene: &Scene,
    voxels: &Voxels,
    shown: &[Patterns],
    raw: Option<&[Patterns]>,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Judged> {
    let optimisation = match raw {
        None => None,
        Some(raw) => {
            let lights = scene.optics.lights.clone();
            let dose = dose(scene, lights, &scene.grid, raw, cancel)?;
            let response = scene.responses(dose)?;
            let evaluation = measure(scene, voxels, &response, raw)?;
            Some(evaluation.with_sub_angles(scene.spec.light[0].sub_angles))
        }
    };
    let sub_angles = scene.spec.evaluate.sub_angles;
    let grid = scene.fine_grid();
    let [nz, ny, nx] = grid.shape;
    let text = format!(
        "evaluating on {nx} × {ny} × {nz} voxels: standing still, and turning ({sub_angles} angles per frame)"
    );
    progress.event(&Event::Note { text });
    let fine = scene.voxels(&grid)?;
    let response = scene.responses(dose(
        scene,
        scene.optics.lights_turning(1),
        &grid,
        shown,
        cancel,
    )?)?;
    let standing = measure(scene, &fine, &response, shown)?;
    drop(response);
    let turning = dose(
        scene,
        scene.optics.lights_turning(sub_angles),
        &grid,
        shown,
        cancel,
    )?;
    let mean = averaged(&turning, &scene.grid);
    let response = scene.responses(turning)?;
    let evaluation = measure(scene, &fine, &response, shown)?.with_sub_angles(sub_angles);
    Ok(Judged {
        evaluation,
        standing,
        optimisation,
        dose: mean,
        fine,
        response,
    })
}

/// Dose of patterns on a grid.
fn dose(
    scene: &Scene,
    mut lights: Vec<Light>,
    grid: &VolumeGrid,
    patterns: &[Patterns],
    cancel: &Run,
) -> Result<Volume<f32>> {
    for (light, patterns) in lights.iter_mut().zip(patterns) {
        light.active = Some(lit_rows(patterns));
    }
    let model = planner::plan(
        &scene.optics.model,
        scene.optics.vial.as_ref(),
        lights,
        grid.clone(),
        None,
        cancel,
    )?
    .model;
    let mut x = model.new_patterns()?;
    for (layout, patterns) in model.patterns().iter().zip(patterns) {
        layout.fill_field(patterns, x.as_mut_slice());
    }
    let mut dose = model.new_dose()?;
    model.dose(&x, &mut dose, cancel)?;
    drop(x);
    Ok(model.outputs()[0].volume_of(dose.as_slice()))
}

/// Rows from the lowest to the highest that is not dark, per (frame, column): `(bottom, count)`.
fn lit_rows(patterns: &Patterns) -> Vec<(u32, u32)> {
    let (rows, columns) = (patterns.grid.rows, patterns.grid.columns);
    (0..patterns.grid.frames())
        .into_par_iter()
        .flat_map_iter(|frame| {
            let image = patterns.frame(frame);
            (0..columns).map(move |column| {
                let lit = |&up: &usize| image[(rows - 1 - up) * columns + column] != 0.0;
                let (first, last) = ((0..rows).find(lit), (0..rows).rev().find(lit));
                first
                    .zip(last)
                    .map_or((0, 0), |(a, b)| (a as u32, (b - a + 1) as u32))
            })
        })
        .collect()
}

/// The numbers of a print.
fn measure(
    scene: &Scene,
    voxels: &Voxels,
    response: &Volume<f32>,
    patterns: &[Patterns],
) -> Result<Evaluation> {
    let mut print = Print::new(&voxels.labels, response)?
        .with_inside(&voxels.target.inside)?
        .with_patterns(PatternStats::of(patterns));
    if let Some(threshold) = scene.spec.evaluate.threshold {
        print = print.with_threshold(threshold)?;
    }
    Ok(evaluate(&print))
}

/// Means over the fine voxels of each coarse one.
fn averaged(fine: &Volume<f32>, grid: &VolumeGrid) -> Volume<f32> {
    let [_, ny, nx] = grid.shape;
    let factor = fine.grid.shape[0] / grid.shape[0].max(1);
    let mut values = vec![0.0f32; grid.len()];
    values
        .par_chunks_mut((nx * ny).max(1))
        .enumerate()
        .for_each(|(iz, slice)| {
            for (i, value) in slice.iter_mut().enumerate() {
                let (iy, ix) = (i / nx, i % nx);
                let mut sum = 0.0f64;
                for z in iz * factor..(iz + 1) * factor {
                    for y in iy * factor..(iy + 1) * factor {
                        let row = &fine.values[fine.grid.index(z, y, ix * factor)..][..factor];
                        sum += row.iter().map(|&v| f64::from(v)).sum::<f64>();
                    }
                }
                *value = (sum / factor.pow(3) as f64) as f32;
            }
        });
    Volume {
        grid: grid.clone(),
        values,
    }
}

impl Scene {
    /// What the material makes of a dose.
    ///
    /// # Errors
    /// As [`response`](Scene::response).
    pub(crate) fn responses(&self, mut dose: Volume<f32>) -> Result<Volume<f32>> {
        let response = self.response()?;
        if !response.is_identity() {
            dose.values.par_chunks_mut(BLOCK).for_each(|block| {
                block
                    .iter_mut()
                    .for_each(|value| *value = response.value(*value))
            });
        }
        Ok(dose)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::PatternGrid;

    #[test]
    fn fine_voxels_are_averaged_where_they_belong() {
        let grid = VolumeGrid::centered([1, 2, 3], 0.2);
        let fine = grid.refined(2);
        let values = (0..fine.len())
            .map(|i| (i / 6 % 4 / 2 * 10 + i % 6 / 2) as f32)
            .collect();
        let mean = averaged(&Volume { grid: fine, values }, &grid);
        assert_eq!(mean.values, [0.0, 1.0, 2.0, 10.0, 11.0, 12.0]);
    }

    #[test]
    fn lit_rows_span_all_light_from_below() {
        let mut patterns = Patterns::dark(PatternGrid::full_turn(1, 0.0, 4, 2, 0.1));
        patterns.values[2] = 1.0; // row 1, column 0: two rows above the lowest
        patterns.values[6] = 1.0; // row 3, column 0: the lowest
        assert_eq!(lit_rows(&patterns), [(0, 3), (0, 0)]);
    }
}
