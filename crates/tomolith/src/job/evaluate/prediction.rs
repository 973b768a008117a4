//! What patterns of any origin print, measured as a run does it.

use crate::error::{Error, Result};
use crate::grid::Patterns;
use crate::job::dose::written::Written;
use crate::job::evaluate::in_time::{InTime, TimeSummary};
use crate::job::evaluate::{Origin, evaluate_patterns};
use crate::job::progress::Silent;
use crate::job::resolve::ResolvedJob;
use crate::metrics::Evaluation;
use crate::models::Work;
use crate::report::OneExposure;

/// What patterns print.
#[derive(Clone, Debug)]
pub struct Prediction {
    /// The print of the dose of a turn, measured.
    pub evaluation: Evaluation,
    /// The prints of all species by their names, the first one's again; empty where there is one.
    pub species: Vec<(String, Evaluation)>,
    /// What they become at one exposure, where there are several.
    pub one_exposure: Option<OneExposure>,
    /// What each network becomes over time, where the job has a schedule; else empty.
    pub in_time: Vec<TimeSummary>,
}

impl ResolvedJob {
    /// What patterns (of each light) print, measured as `tomolith run` does; with the response of the job, where a run with `co_optimize` finds another.
    ///
    /// # Errors
    /// [`Error::Shape`] for patterns of another size, [`Error::NonFinite`], [`Error::Canceled`].
    pub fn evaluate(&self, patterns: &[Patterns], work: &Work) -> Result<Prediction> {
        let lights = self.lights();
        if patterns.len() != lights.len() {
            return Err(Error::Shape {
                what: "patterns of each light".to_owned(),
                expected: vec![lights.len()],
                found: vec![patterns.len()],
            });
        }
        for (patterns, light) in patterns.iter().zip(lights) {
            let [expected, found] = [&light.pixels, &patterns.grid].map(|grid| grid.shape());
            if expected != found || patterns.values.len() != patterns.grid.len() {
                return Err(Error::Shape {
                    what: "patterns [frame, row, column]".to_owned(),
                    expected: expected.to_vec(),
                    found: found.to_vec(),
                });
            }
        }
        let written = Written::of_raw(patterns.to_vec(), self)?;
        let shown = &written.shown;
        let voxels = self.own_voxels(work)?;
        let evaluated =
            evaluate_patterns(self, voxels, shown, Origin::default(), &mut Silent, work)?;
        let in_time = evaluated.in_time.as_ref().map(InTime::summary);
        let is_several = self.species.len() > 1;
        let named = self.species.iter().zip(&evaluated.species);
        let named = named.filter(|_| is_several).map(|(species, print)| {
            let name = species.name.clone().unwrap_or_default();
            (name, print.evaluation.clone())
        });
        Ok(Prediction {
            evaluation: evaluated.first().evaluation.clone(),
            species: named.collect(),
            one_exposure: evaluated.one_exposure,
            in_time: in_time.unwrap_or_default(),
        })
    }
}
