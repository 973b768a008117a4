//! A run on several ranks, which share the frames of every light.

use super::{How, stages};
use crate::error::{Error, Result};
use crate::job::dose::cache::RunCache;
use crate::job::dose::in_time::diffuses;
use crate::job::output::folder::Leaves;
use crate::job::output::summary::Summary;
use crate::job::progress::{Progress, watched};
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::optics::Optics;
use crate::job::spec::read::Job;
use crate::models::Work;
use crate::ranks::Communicator;
use std::sync::Arc;

/// Runs a job as [`run_leaving`](crate::job::run_leaving) does, on several ranks that all call this; the summary is rank 0's. Requests to stop are
/// shared, so that all ranks stop after the same step: the patience of their runs must have no end
/// (`Work::with_patience(Duration::MAX)`), as one that breaks into its step leaves the others waiting.
///
/// # Errors
/// As [`run`](fn@crate::job::run); [`Error::Config`] for what cannot be shared, and for fewer frames than ranks, before any work; [`Error::Rank`] where another
/// rank could not go on.
pub fn run_among(
    job: &Job,
    resume: bool,
    leaves: Leaves,
    ranks: &Arc<dyn Communicator>,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Option<Summary>> {
    watched(progress, work, |progress| {
        let how = How {
            resume,
            leaves,
            ranks: Some(ranks),
        };
        let cache = &mut RunCache::default();
        stages(job, how, cache, progress, work).map_err(|e| job.locate(e))
    })
}

/// Refuses what cannot be shared.
fn must_fit(resolved: &ResolvedJob, ranks: &dyn Communicator) -> Result<()> {
    let size = ranks.size();
    for (i, light) in resolved.optics.lights.iter().enumerate() {
        let fewest = resolved
            .levels
            .iter()
            .map(|level| level.lights[i].pixels.frames());
        let frames = fewest.min().unwrap_or(light.pixels.frames());
        if frames < size {
            return Err(Error::config(
                format!("light[{i}].angles"),
                format!("{frames} angles for {size} ranks: each needs one at least"),
                format!("{size} angles or more, or fewer ranks (mpirun -n {frames})"),
            ));
        }
    }
    let scenarios = resolved.scenarios.iter().map(|scenario| &scenario.optics);
    let all: Vec<&Optics> = std::iter::once(&resolved.optics).chain(scenarios).collect();
    let families = all.iter().map(|optics| optics.family(&resolved.grid));
    let families = families.collect::<Result<Vec<_>>>()?;
    let mut lights = all.iter().flat_map(|optics| &optics.lights);
    let has_heights = resolved
        .schedule()
        .is_some_and(|schedule| schedule.level_heights);
    for (key, is_there, found, accepted) in [
        (
            "schedule",
            resolved.is_optimized_in_time() || has_heights,
            "patterns optimized in time",
            "no [schedule], or one that only the evaluation follows",
        ),
        (
            "material.diffusion",
            diffuses(resolved),
            "a dose that diffuses from frame to frame, in the order of all frames",
            "no [material.diffusion]",
        ),
        (
            "evaluate.levels",
            resolved.evaluation().improves_levels(),
            "patterns improved on few levels",
            "\"rounded\"",
        ),
        (
            "penalties",
            resolved.method.penalizes_frames(),
            "a penalty between frames",
            "smoothness with angles = 0",
        ),
        (
            "light.selection.min_contribution",
            lights.any(|light| light.selection.min_contribution > 0.0),
            "a comparison of all pixels",
            "0",
        ),
        (
            "model",
            families
                .iter()
                .any(|family| family.monte_carlo_paths().is_some()),
            "Monte Carlo paths, which would be others in a share",
            "a model without Monte Carlo paths",
        ),
        (
            "model",
            families
                .iter()
                .any(|family| family.capabilities().is_stored),
            "a stored matrix, which holds all frames",
            "another model",
        ),
    ] {
        if is_there {
            let found = format!("{found}, on {size} ranks");
            return Err(Error::config(key, found, accepted));
        }
    }
    Ok(())
}

impl ResolvedJob {
    /// Refuses what the ranks cannot share, where there are several.
    pub(crate) fn must_be_shared(&self) -> Result<()> {
        match &self.ranks {
            Some(ranks) => must_fit(self, ranks.as_ref()),
            None => Ok(()),
        }
    }

    /// The same job as one rank's; refuses what cannot be shared.
    pub(crate) fn among(mut self, ranks: &Arc<dyn Communicator>) -> Result<Self> {
        must_fit(&self, ranks.as_ref())?;
        self.ranks = Some(Arc::clone(ranks));
        Ok(self)
    }
}
