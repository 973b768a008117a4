//! A job as objects for a loop of one's own: model, objective, start and bounds.

use crate::error::Result;
use crate::field::{Bounds, HostField};
use crate::grid::{Patterns, Volume};
use crate::job::optimize::Stage;
use crate::job::progress::Silent;
use crate::job::resolve::ResolvedJob;
use crate::models::Work;
use crate::models::scenarios::SharedModel;
use crate::objective::Sum;
use crate::objective::penalty::Penalties;
use crate::optimize::{Limits, problem};
use crate::target::Target;

/// What an optimizer needs.
pub struct Task {
    /// F, on the finest voxels of the optimization.
    pub model: SharedModel,
    /// L, of that dose.
    pub objective: Sum<HostField>,
    /// R, the price of patterns by themselves.
    pub penalties: Penalties<HostField>,
    /// Where the job begins.
    pub start: HostField,
    /// The bounds of each light's pixels.
    pub limits: Vec<Limits>,
    /// The target on the same voxels, of the first species.
    pub target: Target,
    /// Which of them are part, void, or do not count ([`label`](crate::target::label)).
    pub labels: Volume<u8>,
    /// At how many angles of each frame the dose is averaged, for each light.
    pub sub_angles: Vec<usize>,
}

impl ResolvedJob {
    /// Model, objective, start and bounds.
    ///
    /// # Errors
    /// [`Error::Config`](crate::Error::Config) where the model does not fit, [`Error::Canceled`](crate::Error::Canceled).
    pub fn task(&self, work: &Work) -> Result<Task> {
        let [.., level] = self.levels.as_slice() else {
            unreachable!("a job has a level")
        };
        let stage = Stage::new(self, self.own_voxels(work)?, level, None, &mut Silent, work)?;
        let start = stage.start(self.method.start.as_ref(), work)?;
        Ok(Task {
            sub_angles: level.lights.iter().map(|light| light.sub_angles).collect(),
            limits: stage.limits(&start),
            penalties: self.method.penalties(stage.model.patterns())?,
            objective: stage.objective(0)?,
            start,
            target: stage.voxels[0].target.clone(),
            labels: stage.voxels[0].labels.clone(),
            model: stage.model,
        })
    }
}

impl Task {
    /// The images in a field of patterns, per light.
    #[must_use]
    pub fn patterns(&self, x: &HostField) -> Vec<Patterns> {
        crate::job::optimize::gray_levels::patterns(self.model.patterns(), x)
    }

    /// The bounds of every element of such a field.
    ///
    /// # Errors
    /// [`Error::Config`](crate::Error::Config) for limits that are no range.
    pub fn bounds(&self) -> Result<Bounds> {
        problem::bounds(self.model.patterns(), &self.limits)
    }
}
