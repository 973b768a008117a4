//! A sweep file: read, its axes, conditions and metrics checked, and the job at each point.

use crate::axes::{Axis, SweepPoint, named, words};
use crate::expression::{Condition, Expression};
use crate::metric;
use crate::spec::SweepSpec;
use serde_json::Value;
use std::path::{Path, PathBuf};
use tomolith::job::{Document, Job, Leaves};
use tomolith::kind::Section;
use tomolith::metrics::surface_deviation::{HAUSDORFF, MEAN, P95};
use tomolith::{Error, Result};

/// A sweep file that was read.
#[derive(Clone, Debug)]
pub struct Sweep {
    pub(crate) document: Document,
    pub(crate) spec: SweepSpec,
    pub(crate) axes: Vec<Axis>,
    pub(crate) when: Vec<Condition>,
    pub(crate) derived: Vec<(String, Expression)>,
    pub(crate) best: Best,
    /// Lines over the maps, as they are written, with both sides of their equations.
    pub(crate) guides: Vec<(String, [Expression; 2])>,
    /// All metrics that are collected: those of `metrics`, then those that `[best]` needs.
    pub(crate) metrics: Vec<String>,
    pub(crate) base: Document,
    /// Processes that share this machine's memory.
    pub(crate) neighbors: usize,
}

/// Which run is the best.
#[derive(Clone, Debug)]
pub(crate) struct Best {
    pub(crate) metric: String,
    pub(crate) is_highest: bool,
    pub(crate) conditions: Vec<Condition>,
}

impl Sweep {
    /// The sweep as that of one of so many processes on this machine, which share its memory where nobody says how much each has.
    #[must_use]
    pub fn beside(mut self, processes: usize) -> Self {
        self.neighbors = processes.max(1);
        self
    }

    /// Reads a sweep file and its job file.
    ///
    /// # Errors
    /// [`Error::Config`] with key path, file and line; [`Error::Io`].
    pub fn read(file: &Path) -> Result<Self> {
        Self::read_adapted(file, &|_| Ok(()))
    }

    /// Reads a sweep file that is changed before it is used.
    pub(crate) fn read_adapted(
        file: &Path,
        adapt: &dyn Fn(&mut SweepSpec) -> Result<()>,
    ) -> Result<Self> {
        if file.is_dir() {
            let accepted = "a sweep file in TOML or JSON";
            return Err(Error::format(file, "a folder", accepted));
        }
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
            if !root.contains_key("job") {
                return Err(Error::config(
                    "job",
                    "the key is missing: a sweep does not say what it runs",
                    "job = \"job.toml\", the job whose keys the axes set, relative to the sweep file",
                ));
            }
            let mut spec = Section::new("", Value::Object(root)).parse_unranged::<SweepSpec>()?;
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
        must_be_of_the_job(&spec, &axes)?;
        must_be_heard(&spec, &axes)?;
        let best = best(&spec, &axes)?;
        let guides = guides(&spec, &axes)?;
        let mut metrics = spec.metrics.clone();
        for (i, path) in metrics.iter().enumerate() {
            metric::must_exist(path, &format!("metrics[{i}]"))?;
            if metrics[..i].contains(path) {
                let found = format!("`{path}` again");
                return Err(Error::config(
                    format!("metrics[{i}]"),
                    found,
                    "each metric once",
                ));
            }
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
            guides,
            metrics,
            base,
            neighbors: 1,
        })
    }

    /// The same sweep with another folder for its results, named by an option of the command line.
    #[must_use]
    pub fn with_folder(mut self, folder: &Path, option: &str) -> Self {
        let option = format!("{option} {}", folder.display());
        self.document.overridden("folder", option);
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
        self.spec.keep != Leaves::All
            && !self.metrics.iter().any(is_one)
            && self.base.root.pointer("/evaluate/surfaces").is_none()
    }

    /// A target's file is given relative to the sweep file.
    pub(crate) fn change(&self, key: &str, value: &Value) -> String {
        let is_file = ["target.mesh", "target.image", "target.stack"].contains(&key);
        let folder = self.document.file.parent().unwrap_or(Path::new(""));
        let file = value.as_str().filter(|_| is_file);
        match file.map(|file| std::path::absolute(folder.join(file))) {
            Some(Ok(file)) => Document::assignment(key, &Value::from(file.to_string_lossy())),
            _ => Document::assignment(key, value),
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
        words(&self.axes, point)
    }
}

const ARITHMETIC: &str = "arithmetic on numbers and names of axes, such as \"1 - upper\"";
const EQUATION: &str = "an equation in names of the first two axes, such as \"lower = 0.75*upper\"";
const COMPARISON: &str = "a comparison, such as \"lower < upper\"";

/// A whole number without a point, for keys that count, and without what rounding leaves of a formula.
fn number(value: f64) -> Value {
    const EXACT: f64 = (1u64 << 53) as f64;
    let whole = value.round();
    if (value - whole).abs() <= 1e-12 * value.abs() && value.abs() < EXACT {
        Value::from(whole as i64)
    } else {
        Value::from(value)
    }
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

/// Refuses keys that the sweep itself gives each run, and keys that are set twice.
fn must_be_of_the_job(spec: &SweepSpec, axes: &[Axis]) -> Result<()> {
    let of_axes = axes.iter().enumerate().flat_map(|(i, axis)| {
        let keys = axis.keys().into_iter();
        keys.map(move |key| (format!("axes[{i}]"), key))
    });
    let of_set = spec
        .set
        .keys()
        .map(|key| (format!("set.{key}"), key.as_str()));
    let of_derived = spec.derived.keys();
    let of_derived = of_derived.map(|key| (format!("derived.{key}"), key.as_str()));
    for (at, key) in of_axes.chain(of_set).chain(of_derived) {
        if [
            "output.folder",
            "resources.memory_gb",
            "output",
            "resources",
        ]
        .contains(&key)
        {
            return Err(Error::config(
                at,
                format!("`{key}`: the sweep gives each run its folder and its share of the memory"),
                "a key that changes results; `folder`, `keep` and [resources] of the sweep file",
            ));
        }
        if at.starts_with("derived.") && spec.set.contains_key(key) {
            let found = format!("`set` has `{key}`, too");
            return Err(Error::config(at, found, "one of them"));
        }
    }
    Ok(())
}

/// Refuses keys of `set` that an axis sets anew in every run.
fn must_be_heard(spec: &SweepSpec, axes: &[Axis]) -> Result<()> {
    for (i, axis) in axes.iter().enumerate() {
        for axis_key in axis.keys_of_all_values() {
            let is_within = |key: &&String| {
                let rest = key.strip_prefix(axis_key);
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
            };
            if let Some(key) = spec.set.keys().find(is_within) {
                let found =
                    format!("`{axis_key}` of this axis takes the place of `{key}` in [set]");
                let accepted = "one of them: the axis, or the key in [set]";
                return Err(Error::config(format!("axes[{i}]"), found, accepted));
            }
        }
    }
    Ok(())
}

/// The lines over the maps, which lie in the plane of the first two axes.
fn guides(spec: &SweepSpec, axes: &[Axis]) -> Result<Vec<(String, [Expression; 2])>> {
    let guide = |(i, text): (usize, &String)| {
        let at = format!("guides[{i}]");
        if axes.len() < 2 || spec.sample.is_some() {
            let found = "no map: it needs two axes that are crossed";
            return Err(Error::config(
                at,
                found,
                "a sweep of two axes or more, without [sample]",
            ));
        }
        let Some((left, right)) = text.split_once('=') else {
            return Err(Error::config(at, format!("no `=` in {text:?}"), EQUATION));
        };
        let side = |text: &str| expression(text, &at, &axes[..2]);
        let sides = [side(left)?, side(right)?];
        if sides.iter().all(|side| side.names().is_empty()) {
            return Err(Error::config(at, format!("no axis in {text:?}"), EQUATION));
        }
        Ok((text.clone(), sides))
    };
    spec.guides.iter().enumerate().map(guide).collect()
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
        return Err(Error::refused("resources.memory_gb", gb, "GB, above 0"));
    }
    if spec.warm_start.is_some() && spec.keep == Leaves::Metrics {
        let accepted = "keep = \"patterns\" or \"all\"";
        return Err(Error::config(
            "warm_start",
            "runs start from patterns, but keep is \"metrics\"",
            accepted,
        ));
    }
    Ok(())
}
