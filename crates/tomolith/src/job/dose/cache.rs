//! What a run hands to the next one in the same process: its target on voxels, its dose model, and the start that bounds its pixels.
//!
//! One model serves optimization and evaluation where both use the same voxels and angles and the family has the same doses for both
//! ([`evaluates_alike`](crate::models::ModelFamily::evaluates_alike)). The next run reuses it if its job differs in nothing that a model reads. Results are
//! the same to the bit.
//!
//! **Memory.** The model stands in place of the evaluation's, and is dropped before another is built. Targets of more than `MOST_VOXELS` are sampled anew:
//! at that size sampling takes little of a run.

use super::doses::{Exposed, LitRows};
use crate::error::Result;
use crate::field::{Field, HostField};
use crate::job::resolve::identity::{contents, hash, of_voxels};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::models::scenarios::SharedModel;
use crate::models::{PatternLayout, Work};
use crate::optics::light::Light;
use crate::target::Target;
use serde_json::json;

/// Tables that no model reads.
const UNREAD: [&str; 8] = [
    "objective",
    "optimizer",
    "start",
    "bounds",
    "stop",
    "checkpoint",
    "output",
    "resources",
];

/// Voxels of the largest target that is cached: 4 MB of shares.
const MOST_VOXELS: usize = 1 << 20;

/// What a run hands to the next one in the same process; empty at first.
#[derive(Default)]
pub struct RunCache {
    model: Option<(u64, EvaluationModel)>,
    targets: Option<(u64, Vec<Target>)>,
    start: Option<(u64, BoundingStart)>,
}

/// The start whose largest pixel bounds those of a run that begins elsewhere, and its dose where the run ends at a part of its loss.
pub(crate) struct BoundingStart {
    pub(crate) patterns: HostField,
    pub(crate) dose: Option<HostField>,
}

/// Model that gives the doses of an optimization and those that evaluate it.
#[derive(Clone)]
pub(crate) struct EvaluationModel {
    exposed: Exposed,
    pub(crate) model: SharedModel,
    /// Which model, and why.
    pub(crate) reason: String,
}

impl RunCache {
    /// Takes out the model that this key stands for; another one is let go.
    pub(crate) fn take(&mut self, key: Option<u64>) -> Option<EvaluationModel> {
        let (last_key, model) = self.model.take()?;
        (Some(last_key) == key).then_some(model)
    }

    /// Keeps a model of these voxels and lights under its job's key.
    pub(crate) fn put(
        &mut self,
        key: Option<u64>,
        exposed: Exposed,
        model: &SharedModel,
        reason: &str,
    ) {
        self.model = key.map(|key| {
            let evaluation_model = EvaluationModel {
                exposed,
                model: SharedModel::clone(model),
                reason: reason.to_owned(),
            };
            (key, evaluation_model)
        });
    }

    /// The parts of a job on its grid: the cached ones where they are the same; else samples and caches them.
    pub(crate) fn targets(&mut self, resolved: &ResolvedJob, work: &Work) -> Result<Vec<Target>> {
        if resolved.grid.len() > MOST_VOXELS {
            self.targets = None;
            return resolved.sampled(&resolved.grid, work);
        }
        let key = resolved.identity_of_parts()?;
        let targets = match self.targets.take_if(|(last_key, _)| *last_key == key) {
            Some((_, targets)) => targets,
            None => resolved.sampled(&resolved.grid, work)?,
        };
        self.targets = Some((key, targets.clone()));
        Ok(targets)
    }

    /// Takes out the start that this key stands for.
    pub(crate) fn take_start(&mut self, key: Option<u64>) -> Option<BoundingStart> {
        let (last_key, start) = self.start.take()?;
        (Some(last_key) == key).then_some(start)
    }

    /// Caches a start under its key, where it is no larger than the largest cached target.
    pub(crate) fn put_start(&mut self, key: Option<u64>, start: BoundingStart) {
        let dose = start.dose.as_ref().map_or(0, Field::len);
        let is_small = start.patterns.len().max(dose) <= MOST_VOXELS;
        self.start = key.filter(|_| is_small).map(|key| (key, start));
    }

    pub(crate) fn evaluation_model(&self) -> Option<&EvaluationModel> {
        self.model.as_ref().map(|(_, model)| model)
    }
}

impl EvaluationModel {
    /// Whether it has the doses of patterns that are lit in these rows.
    pub(crate) fn gives(&self, exposed: &Exposed, lit: &[LitRows]) -> bool {
        let shows = |(layout, lit): (&PatternLayout, &LitRows)| {
            layout.runs.iter().zip(lit).all(|(run, &(bottom, count))| {
                count == 0 || run.bottom <= bottom && bottom + count <= run.bottom + run.count
            })
        };
        let layouts = self.model.patterns();
        self.exposed == *exposed && layouts.len() == lit.len() && layouts.iter().zip(lit).all(shows)
    }
}

/// What a job's model is known by, where one model serves optimization and evaluation; None where it does not.
pub(crate) fn key(resolved: &ResolvedJob, voxels: &Voxels) -> Result<Option<u64>> {
    if !is_evaluated_alike(resolved)? {
        return Ok(None);
    }
    let tables = resolved.tables(&UNREAD)?;
    let mut parts = vec![hash(tables.to_string().as_bytes())];
    parts.extend(of_voxels(voxels));
    contents(&tables, &resolved.base, &mut parts)?;
    Ok(Some(hash(bytemuck::cast_slice(&parts))))
}

/// What the start that bounds a run's pixels is known by, with the key of its model.
pub(crate) fn start_key(model: u64, job: &ResolvedJob) -> Result<u64> {
    let tables = job.tables(&[])?;
    let bounds_as = tables.pointer("/start/patterns/bounds_as");
    let has_part = job.stop().relative_loss.is_some();
    let read = json!([bounds_as, tables["bounds"], has_part]).to_string();
    Ok(hash(bytemuck::cast_slice(&[model, hash(read.as_bytes())])))
}

/// Whether one model serves optimization and evaluation.
fn is_evaluated_alike(resolved: &ResolvedJob) -> Result<bool> {
    let [level] = resolved.levels.as_slice() else {
        return Ok(false);
    };
    let is_joined = resolved.ranks.is_some()
        || resolved.mixing.is_some()
        || resolved.first().has_cells
        || !resolved.scenarios.is_empty()
        || resolved.is_optimized_in_time()
        || super::in_time::diffuses(resolved);
    let fine = resolved.fine_grid();
    let exposed = Exposed::new(&level.grid, level.lights.clone());
    let is_own = |lights| Exposed::new(&fine, lights) == exposed;
    let evaluated = resolved.optics.lights_turning(&resolved.evaluated_angles);
    let is_plain = |(level, light): (&Light, &Light)| {
        level.pixels == light.pixels && !light.selection.is_any() && light.point_spread.is_none()
    };
    let mut lights = level.lights.iter().zip(&resolved.optics.lights);
    if is_joined
        || resolved.grid != fine
        || ![resolved.optics.lights_standing(), evaluated]
            .into_iter()
            .all(is_own)
        || !lights.all(is_plain)
    {
        return Ok(false);
    }
    let optics = resolved.optimizing().lit_by(&level.lights);
    let family = resolved.optics.family(&level.grid)?;
    Ok(family.evaluates_alike(&optics, &level.grid))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::{Job, Leaves, RunFolder, Silent, run_here};
    use std::path::Path;

    /// A disc of one slice, evaluated as it is optimized.
    const PLANE: &str = r#"
        target = { phantom = { cylinder = { size_mm = 1.6, height_mm = 0.1 } } }
        grid = { shape = [24, 24, 1], pitch_mm = 0.1, region = "cylinder" }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [24, 1], angles = 30, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        objective = { ospw = { lower = 0.7, upper = 0.9 } }
        optimizer = { lbfgs = {} }
        stop = { iterations = 6 }
        evaluate = { refine = 1, sub_angles = 1 }
    "#;

    /// Runs the job with changes and this cache; its report without times, and its patterns.
    fn ran(cache: &mut RunCache, changes: &[&str], folder: &Path) -> (serde_json::Value, Vec<u8>) {
        let file = folder.join("job.toml");
        std::fs::write(&file, PLANE).unwrap();
        let changes: Vec<String> = changes.iter().map(|&change| change.to_owned()).collect();
        let job = Job::read(&file, &changes).unwrap();
        let job = job.with_folder(&folder.join("run"), "test").overwriting();
        run_here(
            &job,
            false,
            Leaves::Patterns,
            cache,
            &mut Silent,
            &Work::new(),
        )
        .unwrap();
        let read = |name| std::fs::read(folder.join("run").join(name)).unwrap();
        let mut report: serde_json::Value = serde_json::from_slice(&read("report.json")).unwrap();
        let tables = report.as_object_mut().unwrap();
        tables.retain(|key, _| key != "run");
        assert!(RunFolder::finished(&folder.join("run")).is_some());
        (report, read("patterns.npz"))
    }

    #[test]
    fn a_run_by_the_model_of_another_is_the_same_run() {
        let folder = tempfile::tempdir().unwrap();
        let mut cache = RunCache::default();
        let changes = ["objective.ospw.lower=0.4", "optimizer={ fista = {} }"];
        ran(&mut cache, &changes, folder.path());
        let model = |cache: &RunCache| {
            cache
                .evaluation_model()
                .map(|evaluation| SharedModel::clone(&evaluation.model))
        };
        let first = model(&cache).unwrap();
        let again = ran(&mut cache, &[], folder.path());
        let second = model(&cache).unwrap();
        assert!(std::sync::Arc::ptr_eq(&first, &second));
        let alone = ran(&mut RunCache::default(), &[], folder.path());
        assert!(again == alone, "a report or patterns differ");
        // Another part, and a vial that absorbs more
        let smaller = ["target.phantom.cylinder.size_mm=1.4"];
        let alone = ran(&mut RunCache::default(), &smaller, folder.path());
        let after = ran(&mut cache, &smaller, folder.path());
        assert!(after == alone, "a report or patterns differ");
        ran(&mut cache, &["resin.absorption_per_mm=0.2"], folder.path());
        assert!(!std::sync::Arc::ptr_eq(&first, &model(&cache).unwrap()));
    }

    #[test]
    fn a_run_bounded_by_the_start_of_another_is_the_same_run() {
        let folder = tempfile::tempdir().unwrap();
        let mut cache = RunCache::default();
        ran(&mut cache, &[], folder.path());
        let first = folder.path().join("first.npz");
        std::fs::copy(folder.path().join("run/patterns.npz"), &first).unwrap();
        let start = |bounds_as: &str| {
            let file = first.display();
            format!(
                "start={{ patterns = {{ file = \"{file}\", scaled = true, bounds_as = {bounds_as} }} }}"
            )
        };
        let fbp = start("{ fbp = {} }");
        let changes = ["stop.relative_loss=1e-6", &fbp, "objective.ospw.lower=0.6"];
        let alone = ran(&mut RunCache::default(), &changes, folder.path());
        ran(&mut cache, &changes[..2], folder.path());
        assert!(cache.start.is_some());
        assert!(ran(&mut cache, &changes, folder.path()) == alone);
        // Another start bounds otherwise
        let clipped = start("{ fbp = { negative = \"offset\" } }");
        let changes = [changes[0], &clipped];
        let alone = ran(&mut RunCache::default(), &changes, folder.path());
        assert!(ran(&mut cache, &changes, folder.path()) == alone);
    }

    #[test]
    fn nothing_is_kept_where_patterns_are_judged_otherwise() {
        let folder = tempfile::tempdir().unwrap();
        for change in [
            "evaluate.refine=2",
            "evaluate.sub_angles=2",
            "grid.shape=[24, 24, 2]",
            "light[0].selection={ columns = [2, 20] }",
        ] {
            let mut cache = RunCache::default();
            ran(&mut cache, &[change], folder.path());
            assert!(cache.evaluation_model().is_none(), "{change}");
        }
    }
}
