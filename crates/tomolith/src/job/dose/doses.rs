//! Doses of given patterns, one after the other.
//!
//! The model of a dose serves the next one where light and voxels are the same.

use super::cache::EvaluationModel;
use crate::error::Result;
use crate::field::HostField;
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::job::dose::species::planned;
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::optics::Optics;
use crate::models::masked::MaskedModel;
use crate::models::rays;
use crate::models::scenarios::SharedModel;
use crate::models::{DoseModel, Family, OpticalScene, Purpose, Work};
use crate::optics::light::{Light, Selection};
use std::sync::Arc;
use tomolith_core::parallel::table;

/// How patterns are exposed: on which voxels, and over how many angles of a frame.
#[derive(Clone)]
pub(crate) struct Exposed {
    grid: VolumeGrid,
    lights: Vec<Light>,
}

impl Exposed {
    pub(crate) fn new(grid: &VolumeGrid, lights: Vec<Light>) -> Self {
        Exposed {
            grid: grid.clone(),
            lights,
        }
    }
}

impl PartialEq for Exposed {
    /// Of one job.
    fn eq(&self, other: &Self) -> bool {
        let angles = |exposed: &Self| -> Vec<usize> {
            exposed
                .lights
                .iter()
                .map(|light| light.sub_angles)
                .collect()
        };
        self.grid == other.grid && angles(self) == angles(other)
    }
}

/// What gives the doses of a job's patterns, by the model of the evaluation.
pub(crate) struct Doses<'a> {
    job: &'a ResolvedJob,
    optics: &'a Optics,
    /// Per light, the rows that may be lit.
    lit: Vec<LitRows>,
    last: Option<(Exposed, SharedModel, String)>,
    /// A model that is there already, for what it has the doses of.
    evaluation_model: Option<&'a EvaluationModel>,
}

/// Rows from the lowest to the highest that is not dark, per (frame, column): `(bottom, count)`.
pub(crate) type LitRows = Vec<(u32, u32)>;
/// Doses of all species, and the notes on the model.
pub(crate) type Simulated = (Vec<Volume<f32>>, String);

impl<'a> Doses<'a> {
    /// In the light of the job or of one of its scenarios.
    pub(crate) fn new(job: &'a ResolvedJob, optics: &'a Optics) -> Self {
        Doses {
            job,
            optics,
            lit: Vec::new(),
            last: None,
            evaluation_model: None,
        }
    }

    /// Takes a model that exists already, where it has these doses.
    pub(crate) fn by(self, evaluation_model: Option<&'a EvaluationModel>) -> Self {
        Doses {
            evaluation_model,
            ..self
        }
    }

    /// Says which patterns, per light, will be shown: models leave out what is dark in all of them.
    pub(crate) fn will_show(&mut self, patterns: &[&[Patterns]]) {
        let lights = patterns.first().map_or(0, |lights| lights.len());
        self.lit = (0..lights)
            .filter_map(|i| {
                let rows = patterns.iter().map(|lights| lit_rows(&lights[i]));
                rows.reduce(joined)
            })
            .collect();
        self.last = None;
    }

    /// Lets go of the model of the last dose.
    pub(crate) fn forget(&mut self) {
        self.last = None;
    }

    /// Doses of patterns.
    pub(crate) fn of(
        &mut self,
        exposed: &Exposed,
        patterns: &[Patterns],
        work: &Work,
    ) -> Result<Simulated> {
        let last = self.last.take().filter(|(last, ..)| last == exposed);
        let (_, model, reason) = match last {
            Some(last) => self.last.insert(last),
            None => {
                let (model, reason) = self.made(exposed, &work.part(0.1))?;
                self.last.insert((exposed.clone(), model, reason))
            }
        };
        let doses = simulated(model.as_ref(), patterns, work)?;
        Ok((doses, reason.clone()))
    }

    fn made(&self, exposed: &Exposed, making: &Work) -> Result<(SharedModel, String)> {
        if let Some(evaluation_model) = self
            .evaluation_model
            .filter(|model| model.gives(exposed, &self.lit))
        {
            return Ok((
                Arc::clone(&evaluation_model.model),
                evaluation_model.reason.clone(),
            ));
        }
        let refine = (self.job.grid.pitch_mm / exposed.grid.pitch_mm).round();
        let purpose = Purpose::Evaluate {
            refine: refine.max(1.0) as usize,
        };
        let lights = lit_alone(exposed.lights.clone(), self.lit.clone());
        let (job, optics) = (self.job, self.optics);
        let (family, grid) = (optics.model.as_ref(), &exposed.grid);
        let (model, reason) = made(family, purpose, job, optics, &lights, grid, making)?;
        Ok((Arc::new(model), reason))
    }
}

/// Dose of the first species from patterns on the job's voxels by a family for a purpose, the vial standing still.
pub(crate) fn standing_by(
    family: Option<&Family>,
    purpose: Purpose,
    job: &ResolvedJob,
    patterns: &[Patterns],
    work: &Work,
) -> Result<Volume<f32>> {
    let exposed = Exposed::new(&job.grid, job.optics.lights_standing());
    let mut doses = doses_by(family, purpose, job, &exposed, patterns, work)?;
    Ok(doses.swap_remove(0))
}

/// Doses of all species by a family for a purpose.
pub(crate) fn doses_by(
    family: Option<&Family>,
    purpose: Purpose,
    job: &ResolvedJob,
    exposed: &Exposed,
    patterns: &[Patterns],
    work: &Work,
) -> Result<Vec<Volume<f32>>> {
    let lit = patterns.iter().map(lit_rows).collect();
    let lights = lit_alone(exposed.lights.clone(), lit);
    let (optics, grid) = (&job.optics, &exposed.grid);
    let making = &work.part(0.1);
    let (model, _) = made(family, purpose, job, optics, &lights, grid, making)?;
    simulated(&model, patterns, work)
}

/// Doses of all species by light that is not scattered, the vial standing still: less than all of it.
pub(crate) fn unscattered(
    job: &ResolvedJob,
    grid: &VolumeGrid,
    patterns: &[Patterns],
    work: &Work,
) -> Result<Vec<Volume<f32>>> {
    let paths = job.optics.paths.iter();
    let clear: Vec<_> = paths.map(rays::Optics::without_scattering).collect();
    let lit = patterns.iter().map(lit_rows).collect();
    let lights = lit_alone(job.optics.lights_standing(), lit);
    let scene = OpticalScene {
        optics: &clear,
        lights: &lights,
        accelerator: None,
        ..job.optics.scene()
    };
    let plan = planned(job, None, scene, grid, None, &work.part(0.1))?;
    simulated(&plan.model, patterns, work)
}

/// Lights of which only these rows are lit.
fn lit_alone(mut lights: Vec<Light>, lit: Vec<LitRows>) -> Vec<Light> {
    for (light, lit) in lights.iter_mut().zip(lit) {
        light.active = Some(lit);
        light.selection = Selection::default();
    }
    lights
}

/// The model of a family (the cheapest that is exact, where none is named), and the notes on it.
fn made(
    family: Option<&Family>,
    purpose: Purpose,
    job: &ResolvedJob,
    optics: &Optics,
    lights: &[Light],
    grid: &VolumeGrid,
    making: &Work,
) -> Result<(MaskedModel, String)> {
    let scene = OpticalScene {
        lights,
        purpose,
        ..optics.scene()
    };
    let plan = planned(job, family, scene, grid, None, making)?;
    Ok((plan.model, plan.reason))
}

/// Doses of all species.
fn simulated(
    model: &dyn DoseModel<Field = HostField>,
    patterns: &[Patterns],
    work: &Work,
) -> Result<Vec<Volume<f32>>> {
    let mut x = model.new_patterns()?;
    for (layout, patterns) in model.patterns().iter().zip(patterns) {
        layout.fill_field(patterns, x.as_mut_slice());
    }
    let mut field = model.new_dose()?;
    model.dose(&x, &mut field, &work.part(0.85))?;
    drop(x);
    let outputs = model.outputs().iter();
    Ok(outputs
        .map(|output| output.volume_of(field.as_slice()))
        .collect())
}

/// Rows from the lowest to the highest that is not dark, per (frame, column): `(bottom, count)`.
pub(crate) fn lit_rows(patterns: &Patterns) -> LitRows {
    let (rows, columns) = (patterns.grid.rows, patterns.grid.columns);
    table(patterns.grid.frames() * columns, |i| {
        let (image, column) = (patterns.frame(i / columns), i % columns);
        let lit = |&up: &usize| image[(rows - 1 - up) * columns + column] != 0.0;
        let (first, last) = ((0..rows).find(lit), (0..rows).rev().find(lit));
        first
            .zip(last)
            .map_or((0, 0), |(a, b)| (a as u32, (b - a + 1) as u32))
    })
}

/// Rows that are lit in one of two.
fn joined(mut all: LitRows, other: LitRows) -> LitRows {
    for (rows, (bottom, count)) in all.iter_mut().zip(other) {
        if rows.1 == 0 {
            *rows = (bottom, count);
        } else if count > 0 {
            let low = rows.0.min(bottom);
            *rows = (low, (rows.0 + rows.1).max(bottom + count) - low);
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::PatternGrid;
    use crate::job::tests::job_of;

    #[test]
    fn lit_rows_span_all_light_from_below() {
        let mut patterns = Patterns::dark(PatternGrid::full_turn(1, 0.0, 4, 2, 0.1));
        patterns.values[2] = 1.0; // row 1, column 0: two rows above the lowest
        patterns.values[6] = 1.0; // row 3, column 0: the lowest
        assert_eq!(lit_rows(&patterns), [(0, 3), (0, 0)]);
    }

    #[test]
    fn rows_of_two_patterns_span_both() {
        let rows = vec![(0, 2), (0, 0), (3, 1), (0, 0)];
        let others = vec![(4, 1), (2, 2), (0, 0), (0, 0)];
        assert_eq!(joined(rows, others), [(0, 5), (2, 2), (3, 1), (0, 0)]);
    }

    #[test]
    fn a_model_that_serves_two_patterns_gives_the_doses_of_each_alone() {
        let text = r#"
            target = { phantom = { sphere = {} }, size_mm = 1.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, pure_radon = true }
            vial = { index_matched = { radius_mm = 2.0 } }
            light = [{ pixels = [20, 14], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        "#;
        let job = ResolvedJob::under(&job_of(text, &[]), &Work::new()).unwrap();
        let lights = &job.optics.lights;
        let lit = |is_lit: &dyn Fn(usize) -> bool| {
            let mut patterns = Patterns::dark(lights[0].pixels.clone());
            for (i, value) in patterns.values.iter_mut().enumerate() {
                *value = if is_lit(i) { 0.1 + (i % 7) as f32 } else { 0.0 };
            }
            vec![patterns]
        };
        let all = [
            lit(&|i| i % 3 != 0),
            lit(&|i| i / 20 % 14 > 9 && i % 2 == 0),
        ];
        for sub_angles in [1, 3] {
            let exposed = Exposed::new(&job.grid, job.optics.lights_turning(&[sub_angles]));
            let mut both = Doses::new(&job, &job.optics);
            both.will_show(&[&all[0], &all[1]]);
            for patterns in &all {
                let mut alone = Doses::new(&job, &job.optics);
                alone.will_show(&[patterns]);
                let [a, b] = [&mut both, &mut alone]
                    .map(|doses| doses.of(&exposed, patterns, &Work::new()).unwrap().0);
                assert!(a[0].values.iter().any(|&v| v > 0.0));
                assert_eq!(a, b);
            }
        }
    }
}
