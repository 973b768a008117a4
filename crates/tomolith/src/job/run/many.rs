//! What whoever runs many jobs asks of each: what identifies it, what it needs, how little a run may leave, and what it starts from.

use super::{How, resolved, stages};
use crate::error::{Error, Result};
use crate::job::dose::cache::RunCache;
use crate::job::output::folder::Leaves;
use crate::job::output::summary::Summary;
use crate::job::progress::Progress;
use crate::job::resolve::identity::{contents, hash, tables_of, take_files};
use crate::job::spec::read::{Job, with_every_default};
use crate::models::Work;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Requirements of a job, known before any work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JobRequirements {
    /// Memory of its largest stage, MB (10⁶ bytes).
    pub memory_mb: u64,
}

/// Reads the files of a job and refuses what `run` would refuse before sampling the target, its folder among it.
///
/// # Errors
/// As [`run`](fn@crate::job::run), for input that cannot be used.
pub fn requirements(job: &Job) -> Result<JobRequirements> {
    let extent = resolved(job, &Work::new())
        .map_err(|e| job.locate(e))?
        .extent;
    Ok(JobRequirements {
        memory_mb: extent.optimization_mb().max(extent.evaluation_mb()),
    })
}

/// Runs a job as [`run`](fn@crate::job::run) does and leaves only some of its outputs, in the calling thread and on the threads of its pool. The model
/// of an earlier run is taken over where it serves this job, too, which changes no result; this one's stands in its place afterwards.
///
/// # Errors
/// As [`run`](fn@crate::job::run).
pub fn run_here(
    job: &Job,
    resume: bool,
    leaves: Leaves,
    cache: &mut RunCache,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Summary> {
    let how = How {
        resume,
        leaves,
        ranks: None,
    };
    let summary = stages(job, how, cache, progress, work).map_err(|e| job.locate(e))?;
    Ok(summary.unwrap_or_else(|| unreachable!("a run alone is its first rank")))
}

/// Tables that change nothing of a result.
const ASIDE: [&str; 3] = ["output", "resources", "checkpoint"];

impl Job {
    /// What tells the job from others: a hash of its tables with every default, and of the files that they name. Where it is written, what
    /// it may use of the computer and how often it keeps a checkpoint are no part of it.
    ///
    /// # Errors
    /// [`Error::Io`] for a file that cannot be read.
    pub fn identity(&self) -> Result<String> {
        let base = self.base();
        let (mut spec, mut parts) = (self.spec.clone(), Vec::new());
        take_files(&mut spec.target, &base, &mut parts)?;
        let mut tables = tables_of(&spec, &ASIDE)?;
        parts.push(hash(tables.to_string().as_bytes()));
        if let Some(map) = tables.as_object_mut() {
            map.remove("target");
        }
        contents(&tables, &base, &mut parts)?;
        Ok(format!("{:016x}", hash(bytemuck::cast_slice(&parts))))
    }

    /// The same job from the patterns of an earlier run, as bright as suits its objective best, with the bounds that its own start gives it, so
    /// that it stays the same problem. `or`, `continued`: those of `start.patterns`.
    ///
    /// # Errors
    /// [`Error::Io`] for a path that cannot be made absolute.
    pub fn starting_from(
        mut self,
        patterns: &Path,
        or: &[PathBuf],
        continued: bool,
    ) -> Result<Self> {
        let absolute = |file: &Path| std::path::absolute(file).map_err(|e| Error::io(file, e));
        let mut start = with_every_default(self.spec.clone()).start;
        if let Some(Value::String(file)) = start.pointer_mut("/patterns/file") {
            *file = absolute(&self.base().join(&*file))?
                .to_string_lossy()
                .into_owned();
        }
        let file = absolute(patterns)?;
        let or = or
            .iter()
            .map(|file| absolute(file))
            .collect::<Result<Vec<_>>>()?;
        let mut patterns = json!({ "file": file, "bounds_as": start, "scaled": true });
        if !or.is_empty() {
            patterns["or"] = json!(or);
        }
        if continued {
            patterns["continued"] = json!(true);
        }
        self.spec.start = json!({ "patterns": patterns });
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{PatternGrid, Patterns};
    use crate::io::npy::{PatternPair, read_patterns, write_patterns};
    use crate::job::tests::{FULL, job_of};
    use crate::job::{Document, Silent};

    fn job(set: &[&str]) -> Job {
        job_of(FULL, set)
    }

    #[test]
    fn jobs_are_the_same_when_their_results_are() {
        let identity = job(&[]).identity().unwrap();
        for same in [
            "output.folder=elsewhere",
            "resources.memory_gb=3",
            "checkpoint.every_s=7",
            "start.fbp.negative=clip", // the default
        ] {
            assert_eq!(job(&[same]).identity().unwrap(), identity, "{same}");
        }
        for other in [
            "evaluate.bit_depth=7",
            "stop.iterations=41",
            "objective.threshold.lower=0.84",
        ] {
            assert_ne!(job(&[other]).identity().unwrap(), identity, "{other}");
        }
    }

    #[test]
    fn what_a_file_holds_is_part_of_the_job_and_not_where_it_lies() {
        let temp = tempfile::tempdir().unwrap();
        let identity_of = |folder: &str, text: &str| {
            let folder = temp.path().join(folder);
            std::fs::create_dir_all(&folder).unwrap();
            std::fs::write(folder.join("part.stl"), text).unwrap();
            let job_text = FULL.replacen("phantom = \"gear\"", "mesh = \"part.stl\"", 1);
            let document = Document::toml(folder.join("a.toml"), job_text).unwrap();
            Job::from_document(document).unwrap().identity().unwrap()
        };
        assert_eq!(identity_of("a", "solid"), identity_of("b", "solid"));
        assert_ne!(identity_of("a", "solid"), identity_of("c", "other"));

        // The slices of a stack, and files that a scenario or a list of starts names
        let folder = temp.path().join("d");
        std::fs::create_dir_all(&folder).unwrap();
        let identity_of = |file: &str, content: &str, target: &str, more: &str| {
            std::fs::write(folder.join(file), content).unwrap();
            let text = FULL.replacen("phantom = \"gear\"", target, 1) + more;
            let document = Document::toml(folder.join("a.toml"), text).unwrap();
            Job::from_document(document).unwrap().identity().unwrap()
        };
        let stack = "stack = \"slice*.png\"";
        assert_ne!(
            identity_of("slice1.png", "1", stack, ""),
            identity_of("slice1.png", "2", stack, "")
        );
        let gear = "phantom = \"gear\"";
        let scenario = "\n[[scenario]]\nset = { \"light[0].selection.mask\" = \"mask.npy\" }\n";
        assert_ne!(
            identity_of("mask.npy", "1", gear, scenario),
            identity_of("mask.npy", "2", gear, scenario)
        );
        let mut job = job(&[]).with_folder(&folder, "test");
        let of_starts = |job: &mut Job, content: &str| {
            let (first, other) = (folder.join("1.npz"), folder.join("2.npz"));
            std::fs::write(&first, "1").unwrap();
            std::fs::write(&other, content).unwrap();
            job.spec.start = json!({ "patterns": { "file": first, "or": [other] } });
            job.identity().unwrap()
        };
        assert_ne!(of_starts(&mut job, "2"), of_starts(&mut job, "3"));
    }

    #[test]
    fn a_job_from_given_patterns_keeps_the_bounds_of_its_own_start() {
        let temp = tempfile::tempdir().unwrap();
        let text = r#"
            target = { phantom = { sphere = {} }, size_mm = 1.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, pure_radon = true }
            vial = { index_matched = { radius_mm = 2.0 } }
            light = [{ pixels = [20, 14], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
            objective = { ospw = {} }
            stop = { iterations = 0 }
            evaluate = { refine = 1, sub_angles = 1 }
        "#;
        let file = temp.path().join("job.toml");
        std::fs::write(&file, text).unwrap();
        let original = Job::read(&file, &[]).unwrap();
        let raw = |job: &Job| {
            crate::job::run_leaving(job, false, Leaves::Patterns, &mut Silent, &Work::new())
                .unwrap();
            let arrays = read_patterns(&job.folder().join("patterns.npz")).unwrap();
            arrays[0].raw.clone().unwrap_or(arrays[0].shown.clone())
        };
        let brightest = |values: &[f32]| values.iter().copied().fold(0.0f32, f32::max);
        let at = |job: Job, name: &str| job.with_folder(&temp.path().join(name), "test");
        let start = raw(&at(original.clone(), "own"));
        let brighter = Patterns {
            grid: PatternGrid::full_turn(12, 0.0, 14, 20, 0.1),
            values: start.iter().map(|v| 3.0 * v).collect(),
        };
        let file = temp.path().join("brighter.npz");
        let pair = PatternPair {
            light: None,
            shown: &brighter,
            raw: None,
        };
        write_patterns(&file, &[pair], &Work::new()).unwrap();
        let job = original.clone();
        let given = at(original.starting_from(&file, &[], false).unwrap(), "given");
        let bound = brightest(&start);
        let found = brightest(&raw(&given));
        assert!(found <= bound && found > 0.1 * bound, "{found} of {bound}");
        let key = &given.spec.start["patterns"];
        assert!(key["bounds_as"]["fbp"].is_object(), "{key}");

        // Of two files the better one, as bright as suits it
        let mut better = at(job.clone(), "better");
        better.spec.stop.iterations = 10;
        let optimized = raw(&better);
        let good = better.folder().join("patterns.npz");
        let mut poor = brighter;
        poor.values.reverse();
        poor.values.iter_mut().for_each(|v| *v = 0.1 + 0.01 * *v);
        let worse = temp.path().join("worse.npz");
        let pair = PatternPair {
            light: None,
            shown: &poor,
            raw: None,
        };
        write_patterns(&worse, &[pair], &Work::new()).unwrap();
        let chosen = raw(&at(
            job.starting_from(&worse, &[good], false).unwrap(),
            "chosen",
        ));
        let factor = brightest(&chosen) / brightest(&optimized);
        let pairs = chosen.iter().zip(&optimized);
        let farthest = pairs
            .map(|(c, o)| (c - factor * o).abs())
            .fold(0.0f32, f32::max);
        assert!(
            farthest < 0.02 * bound,
            "{farthest} of {bound}, times {factor}"
        );
    }
}
