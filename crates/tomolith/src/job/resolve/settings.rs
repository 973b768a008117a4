//! What the layers after this one read of a job's tables.

use super::ResolvedJob;
use super::identity::tables_of;
use super::remarks::few_angles;
use super::resources::memory_budget_mb;
use crate::error::Result;
use crate::job::spec::file_names::of_lights;
use crate::job::spec::{
    BoundsSpec, DoseConvention, EvaluateSpec, OutputSpec, ResinSpec, ScheduleSpec, StopSpec,
};
use crate::optimize::checkpoint;
use serde_json::Value;

impl ResolvedJob {
    /// All tables but some, with every default written out.
    pub(crate) fn tables(&self, without: &[&str]) -> Result<Value> {
        tables_of(&self.spec, without)
    }

    /// When the optimization ends.
    pub(crate) fn stop(&self) -> &StopSpec {
        &self.spec.stop
    }

    /// Mean change of the loss at which the optimization ends where the job names none; 0: never. A print in time is looked at anew on the way, and from patterns
    /// that are good already the loss changes little while the print still does.
    pub(crate) fn steady(&self) -> f64 {
        if self.is_optimized_in_time() || self.method.start.is_given() {
            return 0.0;
        }
        self.method.steady()
    }

    /// The bounds of the pixels of all lights.
    pub(crate) fn bounds(&self) -> &BoundsSpec {
        &self.spec.bounds
    }

    /// The bounds of the pixels of a light: the least value, and the largest, where the job names one.
    pub(crate) fn bounds_of(&self, light: usize) -> (f64, Option<f64>) {
        let (of_light, all) = (&self.spec.light[light].bounds, &self.spec.bounds);
        (of_light.min.unwrap_or(all.min), of_light.max.or(all.max))
    }

    /// The key of a light's largest value.
    pub(crate) fn bound_key_of(&self, light: usize) -> String {
        match self.spec.light[light].bounds.max {
            Some(_) => format!("light[{light}].bounds.max"),
            None => self.showing().bound_key().to_owned(),
        }
    }

    /// When checkpoints are written.
    pub(crate) fn checkpoint(&self) -> &checkpoint::Params {
        &self.spec.checkpoint
    }

    /// Whether the dose of a species is the light that its voxels absorb, and no fluence or weighted sum.
    pub(crate) fn is_absorbed(&self, species: usize) -> bool {
        let factors = self.mixing.as_ref().map(|rows| &rows[species].1);
        let are_sums = self
            .optics
            .lights
            .iter()
            .any(|light| light.resin.pure_radon);
        let is_energy = self.spec.resin.dose_convention == DoseConvention::Energy;
        is_energy && !are_sums && factors.is_none_or(|row| row.iter().all(|factor| *factor == 1.0))
    }

    /// How patterns are written and evaluated.
    pub(crate) fn evaluation(&self) -> &EvaluateSpec {
        &self.spec.evaluate
    }

    /// What is written.
    pub(crate) fn output(&self) -> &OutputSpec {
        &self.spec.output
    }

    /// The resin that lights see which do not name another.
    pub(crate) fn resin(&self) -> &ResinSpec {
        &self.spec.resin
    }

    /// The print in time; None without one.
    pub(crate) fn schedule(&self) -> Option<&ScheduleSpec> {
        self.spec.schedule.as_ref()
    }

    /// Whether the job sets coarser levels (`[multiresolution]`).
    pub(crate) fn has_coarse_levels(&self) -> bool {
        self.spec.multiresolution.is_some()
    }

    /// Memory that the job may plan with, MB; None where that is not known.
    pub(crate) fn memory_budget_mb(&self) -> Option<u64> {
        memory_budget_mb(self.spec.resources.memory_gb)
    }

    pub(crate) fn names_of_lights(&self) -> impl Iterator<Item = Option<&str>> {
        self.spec.light.iter().map(|light| light.name.as_deref())
    }

    /// The names of the lights for files: none when there is only one.
    pub(crate) fn light_names(&self) -> Vec<Option<&str>> {
        of_lights(&self.spec)
    }

    /// The name of a light for files: none when there is only one.
    pub(crate) fn light_name(&self, light: usize) -> Option<&str> {
        self.light_names()[light]
    }

    /// Whether light comes from too few sides for any part.
    pub(crate) fn has_few_angles(&self) -> bool {
        few_angles(&self.spec).is_some()
    }

    /// Whether the job says at how many angles of a frame the optimization looks.
    pub(crate) fn has_own_sub_angles(&self) -> bool {
        self.spec
            .light
            .iter()
            .any(|light| light.sub_angles.is_some())
    }
}
