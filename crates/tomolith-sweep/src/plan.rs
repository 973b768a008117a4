//! From a sweep file to its runs: every job read and checked, its identity, its share of the memory, where it starts.

use crate::axes::{self, Axis, RUNS_TOO_MANY, SweepPoint, label, mixed, named};
use crate::expression::{Condition, Expression};
use crate::metric;
use crate::spec::{KeepSpec, SweepSpec};
use rayon::prelude::*;
use serde_json::{Map, Value};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use tomolith::job::resources::memory_budget_mb;
use tomolith::job::{self, Document, Job, RunFolder, Silent};
use tomolith::kind::Section;
use tomolith::metrics::surface_deviation::{HAUSDORFF, MEAN, P95};
use tomolith::models::Run;
use tomolith::{Error, Result};

/// Runs whose time is estimated, at most.
const ESTIMATES: usize = 3;

/// A sweep file that was read.
#[derive(Clone, Debug)]
pub struct Sweep {
    document: Document,
    pub(crate) spec: SweepSpec,
    pub(crate) axes: Vec<Axis>,
    when: Vec<Condition>,
    derived: Vec<(String, Expression)>,
    pub(crate) best: Best,
    /// All that is collected: those that are asked for, then what the best needs.
    pub(crate) metrics: Vec<String>,
    base: Document,
}

/// Which run is the best.
#[derive(Clone, Debug)]
pub(crate) struct Best {
    pub(crate) metric: String,
    pub(crate) is_highest: bool,
    pub(crate) conditions: Vec<Condition>,
}

/// A run.
#[derive(Clone, Debug)]
pub struct Planned {
    /// Where it lies.
    pub point: SweepPoint,
    /// Its identity, the name of its folder.
    pub id: String,
    /// The runs that it may start from, nearest first.
    pub parents: Vec<usize>,
}

/// All runs of a sweep, checked.
#[derive(Clone, Debug)]
pub struct SweepPlan {
    pub(crate) sweep: Sweep,
    /// The runs, in the order of the table.
    pub runs: Vec<Planned>,
    /// How many work at a time.
    pub side_by_side: usize,
    /// Threads of them all.
    pub threads: usize,
    /// Memory of one, MB; none where neither job nor system say.
    pub share_mb: Option<u64>,
}

impl Sweep {
    /// Reads a sweep file and its job file.
    ///
    /// # Errors
    /// [`Error::Config`] with key path, file and line; [`Error::Io`].
    pub fn read(file: &Path) -> Result<Self> {
        Self::read_adapted(file, &|_| Ok(()))
    }

    /// Reads a sweep file that is changed before it is used.
    ///
    /// # Errors
    /// As [`read`](Self::read); those of the change.
    pub(crate) fn read_adapted(
        file: &Path,
        adapt: &dyn Fn(&mut SweepSpec) -> Result<()>,
    ) -> Result<Self> {
        let document = Document::read(file)?;
        let read = || {
            let root = document.root.as_object().cloned().unwrap_or_default();
            if root.contains_key("target") && !root.contains_key("axes") {
                return Err(Error::config(
                    "target",
                    "a job where a sweep is read",
                    "a sweep file: job = \"job.toml\" and at least one table [[axes]]; `tomolith run` runs a job",
                ));
            }
            let mut spec = Section::new("", Value::Object(root)).parse::<SweepSpec>()?;
            if spec.axes.is_empty() {
                return Err(Error::config(
                    "axes",
                    "there is none",
                    "at least one table [[axes]] with a key and values",
                ));
            }
            adapt(&mut spec)?;
            Self::of_spec(&document, spec)
        };
        read().map_err(|e| document.locate(e))
    }

    /// A job as a sweep of one run.
    ///
    /// # Errors
    /// As [`read`](Self::read); those of the change.
    pub(crate) fn of_job(
        file: &Path,
        adapt: &dyn Fn(&mut SweepSpec) -> Result<()>,
    ) -> Result<Self> {
        let document = Document::read(file)?;
        let mut spec = SweepSpec::of_job(file.file_name().unwrap_or_default().into());
        adapt(&mut spec)?;
        Self::of_spec(&document, spec).map_err(|e| document.locate(e))
    }

    fn of_spec(document: &Document, spec: SweepSpec) -> Result<Self> {
        let axes = (spec.axes.iter().enumerate())
            .map(|(i, axis)| Axis::new(axis, &format!("axes[{i}]"), spec.sample.is_some()))
            .collect::<Result<Vec<_>>>()?;
        for (i, axis) in axes.iter().enumerate() {
            if let Some(other) = axes[..i]
                .iter()
                .position(|a| a.name == axis.name || !a.keys().is_disjoint(&axis.keys()))
            {
                let same = axes[other].keys();
                let mut names = std::iter::once(axis.name.as_str()).chain(axis.keys());
                let twice = names.find(|name| *name == axes[other].name || same.contains(name));
                let found = format!("`{}` of axes[{other}] once more", twice.unwrap_or_default());
                return Err(Error::config(
                    format!("axes[{i}]"),
                    found,
                    "another key, and a `name` of its own",
                ));
            }
        }
        let when = conditions(&spec.when, "when")?;
        for (i, condition) in when.iter().enumerate() {
            must_be_numbers(&axes, &condition.names(), &format!("when[{i}]"))?;
        }
        let derived = (spec.derived.iter())
            .map(|(key, text)| {
                let sets_it = |axis: &Axis| axis.keys().contains(&key.as_str());
                if let Some(i) = axes.iter().position(sets_it) {
                    let found = format!("axes[{i}] sets this key, too");
                    let accepted = "a key that no axis sets; or an axis with a `name` and cases";
                    return Err(Error::config(format!("derived.{key}"), found, accepted));
                }
                let expression = expression(text, &format!("derived.{key}"), &axes)?;
                Ok((key.clone(), expression))
            })
            .collect::<Result<_>>()?;
        let best = best(&spec, &axes)?;
        let mut metrics = spec.metrics.clone();
        for (i, path) in metrics.iter().enumerate() {
            metric::must_exist(path, &format!("metrics[{i}]"))?;
        }
        let asked = best.conditions.iter().flat_map(Condition::names);
        for path in std::iter::once(best.metric.as_str()).chain(asked) {
            if !metrics.iter().any(|m| m == path) && !axes.iter().any(|axis| axis.name == path) {
                metrics.push(path.to_owned());
            }
        }
        must_be_shares(&spec)?;
        let folder = document.file.parent().unwrap_or(Path::new(""));
        let base = Document::read(&folder.join(&spec.job)).map_err(|e| match e {
            Error::Io { path, source } => Error::config(
                "job",
                format!("{}: {source}", path.display()),
                "a job file, relative to the sweep file",
            ),
            other => other,
        })?;
        Ok(Sweep {
            document: document.clone(),
            spec,
            axes,
            when,
            derived,
            best,
            metrics,
            base,
        })
    }

    /// The same sweep with another folder for its results.
    #[must_use]
    pub fn with_folder(mut self, folder: &Path) -> Self {
        self.spec.folder = Some(folder.to_owned());
        self
    }

    /// Where results go.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        let name = || {
            self.document
                .file
                .file_stem()
                .map_or_else(|| "sweep".into(), PathBuf::from)
        };
        self.spec
            .folder
            .clone()
            .unwrap_or_else(|| Path::new("out").join(name()))
    }

    /// The job file, and what is changed in it at a point: `KEY=VALUE`.
    #[must_use]
    pub fn changes(&self, point: &SweepPoint) -> (&Path, Vec<String>) {
        let set = self
            .spec
            .set
            .iter()
            .map(|(key, value)| self.change(key, value));
        let swept = self
            .axes
            .iter()
            .zip(&point.values)
            .flat_map(|(axis, value)| axis.settings(value))
            .map(|(key, value)| self.change(key, value));
        let derived = self.derived.iter().filter_map(|(key, expression)| {
            let value = expression.value(&|name| named(&self.axes, point, name))?;
            Some(self.change(key, &number(value)))
        });
        let without = self.leaves_surfaces_out();
        let without = without.then(|| "evaluate.surfaces=false".to_owned());
        let changes = without.into_iter().chain(set).chain(swept).chain(derived);
        (&self.base.file, changes.collect())
    }

    /// Whether runs need not measure distances of surfaces, since they leave numbers alone of which these are none, and the job does not ask for them.
    pub(crate) fn leaves_surfaces_out(&self) -> bool {
        let of_surfaces = [MEAN.name, P95.name, HAUSDORFF.name, "farthest"];
        let is_one = |path: &String| of_surfaces.iter().any(|name| path.contains(name));
        self.spec.keep != KeepSpec::All
            && !self.metrics.iter().any(is_one)
            && self.base.root.pointer("/evaluate/surfaces").is_none()
    }

    /// A target's file is given relative to the sweep file.
    fn change(&self, key: &str, value: &Value) -> String {
        let is_file = ["target.mesh", "target.image", "target.stack"].contains(&key);
        let folder = self.document.file.parent().unwrap_or(Path::new(""));
        match value
            .as_str()
            .filter(|_| is_file)
            .map(|file| std::path::absolute(folder.join(file)))
        {
            Some(Ok(file)) => format!("{key}={}", inline(&Value::from(file.to_string_lossy()))),
            _ => format!("{key}={}", inline(value)),
        }
    }

    /// The job at a point, which starts as the job file says.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub fn job(&self, point: &SweepPoint) -> Result<Job> {
        let mut document = self.base.clone();
        for assignment in self.changes(point).1 {
            document.set(&assignment)?;
        }
        Job::from_document(document)
    }

    /// The values of a point, for people.
    #[must_use]
    pub fn words(&self, point: &SweepPoint) -> String {
        let words = self.axes.iter().zip(&point.values);
        words
            .map(|(axis, value)| format!("{} = {}", axis.name, label(value)))
            .collect::<Vec<_>>()
            .join(", ")
    }

    /// Reads and checks every job, and settles where each starts and what it may use of so many threads.
    ///
    /// # Errors
    /// [`Error::Config`] for conditions that leave nothing, for more runs than can be, and for jobs that cannot run, before any does;
    /// [`Error::Canceled`].
    pub fn plan(self, threads: usize, cancel: &Run) -> Result<SweepPlan> {
        let folder = self.folder();
        if let Some(file) = folder.ancestors().find(|path| path.is_file()) {
            let found = format!("`{}` is a file", file.display());
            let error = Error::config("folder", found, "a folder, or a name where none is yet");
            return Err(self.document.locate(error));
        }
        if RunFolder::finished(&folder).is_some() {
            let found = format!("`{}` is the folder of a run", folder.display());
            let error = Error::config("folder", found, "the folder of a sweep, or a new name");
            return Err(self.document.locate(error));
        }
        let points = self.points(cancel).map_err(|e| self.document.locate(e))?;
        let given = self.spec.resources.memory_gb;
        let of_job = self
            .base
            .root
            .pointer("/resources/memory_gb")
            .and_then(Value::as_f64);
        let budget_mb = memory_budget_mb(given.or(of_job));
        let wanted = self.spec.resources.side_by_side;
        let first_mb = budget_mb.map(|mb| mb / wanted.unwrap_or(1) as u64);
        let checked: Vec<Result<(String, u64)>> = points
            .par_iter()
            .map(|point| self.check(point, first_mb, cancel))
            .collect();
        if checked
            .iter()
            .any(|one| matches!(one, Err(Error::Canceled)))
        {
            return Err(Error::Canceled);
        }
        let mut sound = Vec::with_capacity(points.len());
        let mut refused = Vec::new();
        for (i, one) in checked.into_iter().enumerate() {
            match one {
                Ok(one) => sound.push(one),
                Err(error) => refused.push((i, error)),
            }
        }
        if let Some((first, error)) = refused.first_mut() {
            let error = std::mem::replace(error, Error::Canceled);
            let (first, count) = (*first, refused.len());
            return Err(self
                .document
                .locate(self.refused(&points, first, error, count)));
        }
        let largest_mb = sound.iter().map(|(_, mb)| *mb).max().unwrap_or(1).max(1);
        let holds = budget_mb.map_or(usize::MAX, |mb| (mb / largest_mb) as usize);
        let side_by_side = wanted.unwrap_or(threads.min(holds)).clamp(1, points.len());
        let runs = self.settle(points, sound.into_iter().map(|(id, _)| id).collect());
        Ok(SweepPlan {
            sweep: self,
            runs,
            side_by_side,
            threads,
            share_mb: budget_mb.map(|mb| mb / side_by_side.max(wanted.unwrap_or(1)) as u64),
        })
    }

    /// The points; where they are too many, with the time they would take.
    fn points(&self, cancel: &Run) -> Result<Vec<SweepPoint>> {
        let counted = axes::combinations(&self.axes, self.spec.sample);
        let points = counted.and_then(|_| axes::points(&self.axes, &self.when, self.spec.sample));
        points.map_err(|error| match error {
            Error::Config {
                key,
                found,
                accepted,
                nearest,
                place,
            } if found.ends_with(RUNS_TOO_MANY) => {
                let count: f64 = found
                    .split(' ')
                    .next()
                    .and_then(|n| n.parse().ok())
                    .unwrap_or(0.0);
                let found = match self.seconds(cancel) {
                    Some(one) => format!(
                        "{found} of about {}: {}",
                        duration(one),
                        duration(count * one)
                    ),
                    None => found,
                };
                Error::Config {
                    key,
                    found,
                    accepted,
                    nearest,
                    place,
                }
            }
            other => other,
        })
    }

    /// How long one run takes, where the first point's job can be run.
    fn seconds(&self, cancel: &Run) -> Option<f64> {
        let values: Vec<Value> = self.axes.iter().map(|axis| axis.drawn(0.0)).collect();
        let point = SweepPoint {
            place: vec![0.0; values.len()],
            values,
            index: None,
        };
        let plan = job::check(&self.job(&point).ok()?, &mut Silent, cancel).ok()?;
        Some(plan.seconds)
    }

    /// Identity and memory of a job that can run.
    fn check(
        &self,
        point: &SweepPoint,
        memory_mb: Option<u64>,
        cancel: &Run,
    ) -> Result<(String, u64)> {
        if cancel.is_stop_asked() {
            return Err(Error::Canceled);
        }
        for (key, expression) in &self.derived {
            let value = expression.value(&|name| named(&self.axes, point, name));
            if let Some(value) = value.filter(|value| !value.is_finite()) {
                return Err(Error::config(
                    format!("derived.{key}"),
                    format!("{value} at {}", self.words(point)),
                    "a finite number in every run; leave others out with `when`",
                ));
            }
        }
        let mut job = self.job(point)?;
        job.spec.resources.memory_gb = memory_mb.map(gigabytes);
        let id = job.identity()?;
        let folder = self.folder().join(RUNS).join(&id);
        let needs = job::needs(&job.with_folder(&folder, "sweep"))?;
        Ok((id, needs.memory_mb))
    }

    /// Says which jobs cannot run, and why the first cannot; at the key of the sweep that is at fault.
    fn refused(&self, points: &[SweepPoint], first: usize, error: Error, count: usize) -> Error {
        let text = error.to_string();
        let (key, detail) = match &error {
            Error::Config { key, found, .. } => (
                self.at_fault(key, found),
                text.split(" (from --set ")
                    .next()
                    .unwrap_or(&text)
                    .to_owned(),
            ),
            _ => (None, text.clone()),
        };
        let is_all = count == points.len();
        match (error, key) {
            // The job file itself is at fault
            (error, None) if is_all => error,
            (
                Error::Config {
                    key: own,
                    accepted,
                    nearest,
                    found,
                    ..
                },
                Some(key),
            ) if is_all => {
                let found = found
                    .split(" (from --set ")
                    .next()
                    .unwrap_or(&found)
                    .to_owned();
                let found = match own.starts_with("--set ") {
                    true => found,
                    false => format!("`{own}`: {found}"),
                };
                Error::Config {
                    key,
                    found,
                    accepted,
                    nearest,
                    place: None,
                }
            }
            (error, key) => {
                let accepted = match error {
                    Error::Config { accepted, .. } => {
                        format!("in every run {accepted}; or leave such runs out with `when`")
                    }
                    _ => "values that make sound jobs; leave others out with `when`".to_owned(),
                };
                let runs = format!(
                    "{count} of {} jobs cannot run; the first is run {} ({})",
                    points.len(),
                    first + 1,
                    self.words(&points[first])
                );
                Error::config(
                    key.unwrap_or_else(|| "axes".to_owned()),
                    format!("{runs}: {detail}"),
                    accepted,
                )
            }
        }
    }

    /// The key of the sweep that set a key of the job which is at fault.
    fn at_fault(&self, key: &str, found: &str) -> Option<String> {
        let assignment = match key.strip_prefix("--set ") {
            Some(assignment) => assignment,
            None => found.split_once(" (from --set ")?.1,
        };
        let set = assignment.split('=').next()?;
        let is_set = |value: &Value| {
            let rest = assignment.strip_prefix(self.change(set, value).as_str());
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(')'))
        };
        let of_axis = self.axes.iter().enumerate().find_map(|(i, axis)| {
            let path = axis.path_of(set, is_set)?;
            Some(format!("axes[{i}].{path}"))
        });
        let of_derived = || {
            self.spec
                .derived
                .contains_key(set)
                .then(|| format!("derived.{set}"))
        };
        of_axis.or_else(of_derived).or_else(|| {
            self.spec
                .set
                .contains_key(set)
                .then(|| format!("set.{set}"))
        })
    }

    /// The runs, each with those that it may start from.
    fn settle(&self, points: Vec<SweepPoint>, ids: Vec<String>) -> Vec<Planned> {
        let parents = match self.spec.warm_start {
            Some(_) => parents(&points, self.axes.len()),
            None => vec![Vec::new(); points.len()],
        };
        let mut runs: Vec<Planned> = Vec::with_capacity(points.len());
        for ((point, id), parents) in points.into_iter().zip(ids).zip(parents) {
            let id = (parents.iter()).fold(id, |id, &from| self.warm_id(&id, &runs[from].id));
            runs.push(Planned { point, id, parents });
        }
        runs
    }

    /// The identity of a job that starts from another's patterns.
    fn warm_id(&self, own: &str, from: &str) -> String {
        let number = |id: &str| u64::from_str_radix(id, 16).unwrap_or(0);
        let iterations = self
            .spec
            .warm_start
            .and_then(|warm| warm.iterations)
            .map_or(u64::MAX, |n| n as u64);
        format!(
            "{:016x}",
            mixed(number(own) ^ mixed(number(from) ^ mixed(iterations ^ SCALED)))
        )
    }
}

impl SweepPlan {
    /// Seconds that the runs take which are not finished, on all cores: the mean of a few that are spread over the table, times their number.
    ///
    /// # Errors
    /// As [`job::check`].
    pub(crate) fn seconds(&self, cancel: &Run) -> Result<f64> {
        let left: Vec<usize> = (0..self.runs.len())
            .filter(|&i| RunFolder::finished(&self.run_folder(i)).is_none())
            .collect();
        let asked = left.len().min(ESTIMATES);
        let mut seconds = 0.0;
        for k in 0..asked {
            let job = self.job(left[k * left.len() / asked])?;
            seconds += job::check(&job, &mut Silent, cancel)?.seconds / asked as f64;
        }
        Ok(seconds * left.len() as f64)
    }

    /// Where results go.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        self.sweep.folder()
    }

    /// The folder of a run.
    #[must_use]
    pub fn run_folder(&self, i: usize) -> PathBuf {
        self.folder().join(RUNS).join(&self.runs[i].id)
    }

    /// A run's values, for people.
    #[must_use]
    pub fn words(&self, i: usize) -> String {
        self.sweep.words(&self.runs[i].point)
    }

    /// A run's job, with its folder and its share of the memory, which starts as the job file says.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub fn job(&self, i: usize) -> Result<Job> {
        let mut job = self
            .sweep
            .job(&self.runs[i].point)?
            .with_folder(&self.run_folder(i), "sweep");
        job.spec.resources.memory_gb = self.share_mb.map(gigabytes);
        Ok(job)
    }

    /// One command a run, in the order of the table, for a shell.
    ///
    /// # Errors
    /// [`Error::Config`] for warm starts: a list has no order.
    pub fn commands(&self) -> Result<Vec<String>> {
        if self.sweep.spec.warm_start.is_some() {
            let accepted = "--shard I/N, which keeps the order; or a sweep without [warm_start]";
            return Err(Error::config(
                "--list",
                "a list has no order, and with [warm_start] a run needs the one that it starts from",
                accepted,
            ));
        }
        let command = |i: usize| {
            let (job, changes) = self.sweep.changes(&self.runs[i].point);
            let mut words = vec![
                "tomolith".to_owned(),
                "run".to_owned(),
                quoted(&job.to_string_lossy()),
            ];
            let share = self
                .share_mb
                .map(|mb| format!("resources.memory_gb={}", gigabytes(mb)));
            for change in changes.iter().chain(&share) {
                words.extend(["--set".to_owned(), quoted(change)]);
            }
            let folder = quoted(&self.run_folder(i).to_string_lossy());
            words.extend([
                "--output".to_owned(),
                folder,
                "--keep".to_owned(),
                self.sweep.spec.keep.word().to_owned(),
                "--resume".to_owned(),
            ]);
            words.join(" ")
        };
        Ok((0..self.runs.len()).map(command).collect())
    }
}

/// Runs whose starts were not scaled have other identities.
const SCALED: u64 = 1 << 63;

/// Folder of the runs in the sweep's.
pub(crate) const RUNS: &str = "runs";
const ARITHMETIC: &str = "arithmetic on numbers and names of axes, such as \"1 - upper\"";
const COMPARISON: &str = "a comparison, such as \"lower < upper\"";

/// A whole number without a point, for keys that count.
fn number(value: f64) -> Value {
    const EXACT: f64 = (1u64 << 53) as f64;
    if value.fract() == 0.0 && value.abs() < EXACT {
        Value::from(value as i64)
    } else {
        Value::from(value)
    }
}

fn gigabytes(mb: u64) -> f64 {
    mb as f64 / 1e3
}

fn conditions(texts: &[String], at: &str) -> Result<Vec<Condition>> {
    let parse = |(i, text): (usize, &String)| {
        text.parse().map_err(|found| {
            Error::config(
                format!("{at}[{i}]"),
                format!("{found} in {text:?}"),
                COMPARISON,
            )
        })
    };
    texts.iter().enumerate().map(parse).collect()
}

fn expression(text: &str, at: &str, axes: &[Axis]) -> Result<Expression> {
    let expression: Expression = text
        .parse()
        .map_err(|found| Error::config(at, found, ARITHMETIC))?;
    must_be_numbers(axes, &expression.names(), at)?;
    Ok(expression)
}

/// Refuses names that are no axes, or axes of something else than numbers.
fn must_be_numbers(axes: &[Axis], names: &[&str], at: &str) -> Result<()> {
    for name in names {
        let known = || axes.iter().map(|axis| axis.name.as_str());
        let Some(axis) = axes.iter().find(|axis| axis.name == *name) else {
            return Err(Error::Config {
                key: at.to_owned(),
                found: format!("`{name}` is no axis"),
                accepted: format!(
                    "numbers and names of axes: {}",
                    known().collect::<Vec<_>>().join(", ")
                ),
                nearest: tomolith::error::nearest_name(name, known()).map(str::to_owned),
                place: None,
            });
        };
        if let Some(value) = axis.values().iter().find(|value| !value.is_number()) {
            return Err(Error::config(
                at,
                format!("`{name}` has the value {value}"),
                "axes whose values are numbers",
            ));
        }
    }
    Ok(())
}

fn best(spec: &SweepSpec, axes: &[Axis]) -> Result<Best> {
    let (metric, is_highest, key) = match (&spec.best.highest, &spec.best.lowest) {
        (Some(_), Some(_)) => {
            return Err(Error::config(
                "best.lowest",
                "both highest and lowest",
                "one of them",
            ));
        }
        (None, Some(metric)) => (metric.clone(), false, "best.lowest"),
        (Some(metric), None) => (metric.clone(), true, "best.highest"),
        (None, None) => ("evaluation.iou".to_owned(), true, "best"),
    };
    metric::must_exist(&metric, key)?;
    let conditions = conditions(&spec.best.conditions, "best.where")?;
    for (i, condition) in conditions.iter().enumerate() {
        for name in condition.names() {
            if axes.iter().any(|axis| axis.name == name) {
                must_be_numbers(axes, &[name], &format!("best.where[{i}]"))?;
            } else {
                metric::must_exist(name, &format!("best.where[{i}]"))?;
            }
        }
    }
    Ok(Best {
        metric,
        is_highest,
        conditions,
    })
}

/// Refuses shares of nothing, and warm starts without patterns.
fn must_be_shares(spec: &SweepSpec) -> Result<()> {
    if spec.resources.side_by_side == Some(0) {
        return Err(Error::config(
            "resources.side_by_side",
            "found 0",
            "1 or more",
        ));
    }
    if let Some(gb) = spec
        .resources
        .memory_gb
        .filter(|gb| !(gb.is_finite() && *gb > 0.0))
    {
        return Err(Error::config(
            "resources.memory_gb",
            format!("found {gb}"),
            "GB, above 0",
        ));
    }
    if spec.warm_start.is_some() && spec.keep == KeepSpec::Metrics {
        let accepted = "keep = \"patterns\" or \"all\"";
        return Err(Error::config(
            "warm_start",
            "runs start from patterns, but keep is \"metrics\"",
            accepted,
        ));
    }
    Ok(())
}

/// For each point so many of those before it, the nearest first; of equally near ones the first.
fn parents(points: &[SweepPoint], count: usize) -> Vec<Vec<usize>> {
    let apart = |a: &SweepPoint, b: &SweepPoint| {
        let squares = a.place.iter().zip(&b.place).map(|(a, b)| (a - b).powi(2));
        // Rounding of places must not choose among equals
        (squares.sum::<f64>() * 1e9).round()
    };
    let nearest = |i: usize| {
        let mut nearest: Vec<(f64, usize)> = Vec::with_capacity(count + 1);
        for j in 0..i {
            let distance = apart(&points[i], &points[j]);
            let at = nearest.partition_point(|(other, _)| *other <= distance);
            if at < count {
                nearest.insert(at, (distance, j));
                nearest.truncate(count);
            }
        }
        nearest.into_iter().map(|(_, j)| j).collect()
    };
    (0..points.len()).into_par_iter().map(nearest).collect()
}

/// For each run the first one with the same job.
pub(crate) fn firsts(runs: &[Planned]) -> Vec<usize> {
    let mut seen = HashMap::new();
    runs.iter()
        .enumerate()
        .map(|(i, run)| *seen.entry(run.id.as_str()).or_insert(i))
        .collect()
}

/// A value as TOML in one line.
fn inline(value: &Value) -> String {
    match value {
        Value::Array(list) => format!(
            "[{}]",
            list.iter().map(inline).collect::<Vec<_>>().join(", ")
        ),
        Value::Object(map) => inline_table(map),
        // Its escapes are TOML's, too
        other => other.to_string(),
    }
}

fn inline_table(map: &Map<String, Value>) -> String {
    let entry = |(key, value): (&String, &Value)| {
        format!("{} = {}", Value::from(key.as_str()), inline(value))
    };
    format!(
        "{{ {} }}",
        map.iter().map(entry).collect::<Vec<_>>().join(", ")
    )
}

/// A word for a shell.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,+:@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

/// Seconds, minutes, hours, days or years.
pub fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 0.1 => format!("{:.0} ms", 1e3 * s),
        s if s < 10.0 => format!("{s:.1} s"),
        s if s < 100.0 => format!("{s:.0} s"),
        s if s < 6e3 => format!("{:.0} min", s / 60.0),
        s if s < 172_800.0 => format!("{:.1} h", s / 3600.0),
        s if s < 6.3e7 => format!("{:.0} days", s / 86_400.0),
        s => format!("{:.0} years", s / 31_557_600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(place: &[f64]) -> SweepPoint {
        SweepPoint {
            values: Vec::new(),
            place: place.to_vec(),
            index: None,
        }
    }

    #[test]
    fn a_run_starts_from_its_nearest_neighbor_before_it() {
        let third = 1.0 / 3.0;
        let points = [
            [0.0, 0.0],
            [0.0, third],
            [third, 0.0],
            [third, third],
            [1.0, 0.0],
            [2.0 * third, third],
        ]
        .map(|p| at(&p));
        // (⅓, ⅓) is as far from (0, ⅓) as from (⅓, 0): the first of both
        assert_eq!(
            parents(&points, 1),
            [vec![], vec![0], vec![0], vec![1], vec![2], vec![3]]
        );
        assert_eq!(
            parents(&points, 2),
            [
                vec![],
                vec![0],
                vec![0, 1],
                vec![1, 2],
                vec![2, 3],
                vec![3, 2]
            ]
        );
    }

    #[test]
    fn values_and_words_survive_toml_and_the_shell() {
        let value = serde_json::json!({ "ospw": { "w": 0.5, "a b": ["x\"y", true, 1e-7] } });
        let mut document = Document::toml("a.toml", "objective = 1").unwrap();
        document
            .set(&format!("objective={}", inline(&value)))
            .unwrap();
        assert_eq!(document.root["objective"], value);
        assert_eq!(quoted("out/a-b=1"), "out/a-b=1");
        assert_eq!(quoted("it's {}"), "'it'\\''s {}'");
        assert_eq!(
            [0.008, 3.0, 4e3, 1e5, 3e9].map(duration),
            ["8 ms", "3.0 s", "67 min", "27.8 h", "95 years"]
        );
    }
}
