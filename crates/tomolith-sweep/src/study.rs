//! A study of a paper, typed: what is run, and the published numbers that it is compared with; docs/papers/README.md is its page for people.

use crate::commands;
use crate::expression::{Condition, Expression};
use crate::figures::{self, FigureSpec};
use crate::file::Sweep;
use crate::metric;
use crate::plan::SweepPlan;
use crate::reproduce::is_at;
use crate::spec::{AxisSpec, SweepSpec};
use serde::Deserialize;
use serde_json::{Map, Value};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use tomolith::job::{Document, Leaves};
use tomolith::kind::Section;
use tomolith::{Error, Result};

/// The file of a study in its folder.
const FILE: &str = "study.toml";

/// A whole study file.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StudySpec {
    /// What is studied.
    pub(crate) title: String,
    /// Who published it, and where.
    pub(crate) paper: String,
    /// What a reader must know before the table.
    #[serde(default)]
    pub(crate) about: String,
    /// What `--quick` makes smaller.
    #[serde(default)]
    pub(crate) quick: String,
    /// What is run, by name.
    pub(crate) runs: BTreeMap<String, RunSpec>,
    /// Numbers, in the order of the table.
    pub(crate) rows: Vec<RowSpec>,
    /// All runs of sweeps, below that table.
    #[serde(default)]
    pub(crate) tables: Vec<TableSpec>,
    /// Histograms of several runs side by side.
    #[serde(default)]
    pub(crate) figures: Vec<FigureSpec>,
}

/// The runs of a sweep, one a line.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TableSpec {
    /// What stands above it.
    pub(crate) title: String,
    /// A name of `runs`, of a sweep or a job.
    pub(crate) of: String,
    /// Its columns behind those of the axes.
    pub(crate) columns: Vec<ColumnSpec>,
}

/// A number of each run.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ColumnSpec {
    /// What stands above it.
    pub(crate) name: String,
    /// The number of the report.
    pub(crate) metric: String,
}

/// One thing that is run: exactly one of `sweep`, `job` and `command`.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct RunSpec {
    /// A sweep file, relative to the study.
    pub(crate) sweep: Option<PathBuf>,
    /// A job file, relative to the study.
    pub(crate) job: Option<PathBuf>,
    /// What would be typed after `tomolith`, in the study's folder.
    pub(crate) command: Option<Vec<String>>,
    /// Whether the command takes `--output`.
    pub(crate) writes: bool,
    /// Keys of the job.
    pub(crate) set: Map<String, Value>,
    /// What `--quick` changes.
    pub(crate) quick: QuickSpec,
    /// Files without which it cannot run, relative to the study.
    pub(crate) needs: Vec<PathBuf>,
    /// Where they come from.
    pub(crate) needs_from: String,
}

impl RunSpec {
    /// A key that says nothing of what is run, what is found, and what is accepted.
    fn unheard(&self) -> Option<(&'static str, &'static str, &'static str)> {
        let quick = &self.quick;
        let keys = [
            ("set", !self.set.is_empty()),
            ("quick.set", !quick.set.is_empty()),
            ("quick.axes", !quick.axes.is_empty()),
        ];
        if self.command.is_none() {
            let accepted = "the key of a command; sweeps and jobs have their folder";
            return self
                .writes
                .then_some(("writes", "without command", accepted));
        }
        let (key, _) = keys.into_iter().find(|(_, is_given)| *is_given)?;
        let accepted = "keys of a job among the words, \"--set\", \"KEY=VALUE\"; or a run with a job or a sweep";
        Some((key, "together with command", accepted))
    }
}

/// What `--quick` changes.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct QuickSpec {
    /// Leaves it out.
    pub(crate) skip: bool,
    /// Keys of the job.
    pub(crate) set: Map<String, Value>,
    /// Axes with other values, by their keys.
    pub(crate) axes: Vec<AxisSpec>,
}

/// One number of the table.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RowSpec {
    pub(crate) quantity: String,
    /// Where it stands in the paper.
    #[serde(rename = "where")]
    pub(crate) place: String,
    /// Its name in `value` and `holds` of later rows.
    pub(crate) name: Option<String>,
    pub(crate) published: Option<f64>,
    /// What is published, where that is no number.
    pub(crate) says: Option<String>,
    /// Where ours comes from: a name of `runs`.
    pub(crate) of: Option<String>,
    /// The number of its report, or an axis of the best run.
    pub(crate) metric: Option<String>,
    /// The run of a sweep with these values.
    pub(crate) at: Option<Map<String, Value>>,
    /// The best run of a sweep.
    #[serde(default)]
    pub(crate) best: bool,
    /// All runs of a sweep that meet these conditions.
    pub(crate) over: Option<Vec<String>>,
    /// What is taken of them.
    pub(crate) take: Option<Take>,
    /// Of which of them the share is taken.
    pub(crate) share_of: Option<String>,
    /// Arithmetic on earlier rows.
    pub(crate) value: Option<String>,
    /// A comparison of earlier rows.
    pub(crate) holds: Option<String>,
    /// Reproduced within this difference.
    pub(crate) within: Option<f64>,
    /// Reproduced within this difference in per cent of the published number.
    pub(crate) within_percent: Option<f64>,
    /// Why ours is another number.
    pub(crate) differs: Option<String>,
    /// What the paper leaves open.
    pub(crate) under_specified: Option<String>,
    /// Says nothing about the published number at the quick size.
    #[serde(default)]
    pub(crate) full_size: bool,
}

/// Keys of a row of which one would go unheard, and what is accepted.
const APART: [(&str, &str, &str); 11] = [
    ("value", "of", "one source: of, value or holds"),
    ("holds", "of", "one source: of, value or holds"),
    ("holds", "value", "one source: of, value or holds"),
    (
        "holds",
        "published",
        "holds with says; or value with published and a tolerance",
    ),
    ("says", "published", "published, a number; or says, words"),
    (
        "metric",
        "share_of",
        "metric with take; or share_of alone, whose comparison names its numbers",
    ),
    (
        "take",
        "share_of",
        "take of a metric; or share_of, the share of runs",
    ),
    ("best", "at", "one of best and at"),
    (
        "best",
        "over",
        "best for one run; or over with take or share_of",
    ),
    ("within", "within_percent", "one of them"),
    (
        "differs",
        "under_specified",
        "differs where ours is another number; or under_specified where the paper leaves something open",
    ),
];

/// Keys of a row that say nothing without another one, and what is accepted.
const TOGETHER: [(&str, &str, &str); 8] = [
    ("metric", "of", "of = \"NAME\", a run"),
    ("at", "of", "of = \"NAME\", a run"),
    ("best", "of", "of = \"NAME\", a run"),
    ("over", "of", "of = \"NAME\", a run"),
    ("take", "over", "over = [conditions], or [] for all"),
    ("share_of", "over", "over = [conditions], or [] for all"),
    ("within", "published", "published = a number"),
    ("within_percent", "published", "published = a number"),
];

/// Whether a row, as it is written, says something at a key.
fn has(row: &Value, key: &str) -> bool {
    row.get(key).is_some_and(|value| *value != false)
}

/// A key of a row that contradicts another one or lacks it, what is found, and what is accepted.
fn at_odds(row: &Value) -> Option<(&'static str, String, &'static str)> {
    let together = |&(key, other, accepted): &(&'static str, &'static str, &'static str)| {
        let are_both = has(row, key) && has(row, other);
        are_both.then(|| (key, format!("together with {other}"), accepted))
    };
    let without = |&(key, other, accepted): &(&'static str, &'static str, &'static str)| {
        let is_alone = has(row, key) && !has(row, other);
        is_alone.then(|| (key, format!("without {other}"), accepted))
    };
    let apart = APART.iter().find_map(together);
    apart.or_else(|| TOGETHER.iter().find_map(without))
}

/// A path without links and `..`, as far as it exists.
fn resolved(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let real = |there: &Path| {
        Some(
            there
                .canonicalize()
                .ok()?
                .join(path.strip_prefix(there).ok()?),
        )
    };
    path.ancestors()
        .find_map(real)
        .unwrap_or_else(|| path.clone())
}

/// What is taken of many runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Take {
    /// The least.
    Min,
    /// The largest.
    Max,
    /// Their mean.
    Mean,
}

/// A study that was read and checked.
#[derive(Clone, Debug)]
pub struct Study {
    pub(crate) folder: PathBuf,
    pub(crate) spec: StudySpec,
    pub(crate) is_quick: bool,
    pub(crate) document: Document,
}

impl Study {
    /// Reads `study.toml` of a folder; the path of the file itself will do, too.
    ///
    /// # Errors
    /// [`Error::Config`] with key path, file and line; [`Error::Io`].
    pub fn read(folder: &Path, is_quick: bool) -> Result<Self> {
        let is_its_file = folder.is_file() && folder.file_name().is_some_and(|name| name == FILE);
        let folder = match folder.parent().filter(|_| is_its_file) {
            Some(parent) if parent.as_os_str().is_empty() => Path::new("."),
            Some(parent) => parent,
            None => folder,
        };
        let file = folder.join(FILE);
        if !file.is_file() {
            let found = format!("there is no `{}`", file.display());
            return Err(Error::config(
                "FOLDER",
                found,
                "the folder of a study, such as papers/bclp",
            ));
        }
        let document = Document::read(&file)?;
        let read = || {
            let spec = Section::new("", document.root.clone()).parse_unranged::<StudySpec>()?;
            check(&spec, &document.root)?;
            Ok(Study {
                folder: folder.to_owned(),
                spec,
                is_quick,
                document: document.clone(),
            })
        };
        read().map_err(|e| document.locate(e))
    }

    /// Where results go by default.
    #[must_use]
    pub fn output(&self) -> PathBuf {
        let name = std::path::absolute(&self.folder)
            .ok()
            .and_then(|folder| Some(folder.file_name()?.to_owned()))
            .unwrap_or_else(|| "study".into());
        let mut name = name.to_string_lossy().into_owned();
        if self.is_quick {
            name.push_str("-quick");
        }
        Path::new("out").join("papers").join(name)
    }

    /// Refuses a folder of results that would replace files of the study: one that holds such a file, or whose folders of runs do.
    pub(crate) fn must_spare_its_files(
        &self,
        output: &Path,
        plans: &BTreeMap<&str, &SweepPlan>,
    ) -> Result<()> {
        let runs = self.spec.runs.values();
        let of_runs = runs.flat_map(|run| run.sweep.iter().chain(&run.job).chain(&run.needs));
        let files = std::iter::once(Path::new(FILE)).chain(of_runs.map(PathBuf::as_path));
        let files = files.map(|file| self.folder.join(file));
        let jobs = plans.values().map(|plan| plan.sweep.base.file.clone());
        let results = resolved(output);
        let is_hit = |file: &PathBuf| {
            let file = resolved(file);
            let of_run = |name: &String| file.starts_with(results.join(name));
            file.parent() == Some(results.as_path()) || self.spec.runs.keys().any(of_run)
        };
        let Some(file) = files.chain(jobs).find(is_hit) else {
            return Ok(());
        };
        Err(Error::config(
            "--output",
            format!(
                "results in `{}` would lie among files of the study: `{}`",
                output.display(),
                file.display()
            ),
            "a folder of its own, such as out/papers/NAME",
        ))
    }

    /// Why a thing is not run, where it is not.
    pub(crate) fn left_out(&self, run: &RunSpec) -> Option<String> {
        if self.is_quick && run.quick.skip {
            return Some("full size only".to_owned());
        }
        let missing = run
            .needs
            .iter()
            .find(|file| !self.folder.join(file).is_file());
        if let Some(file) = missing {
            let (place, from) = (self.folder.join(file), run.needs_from.trim());
            return Some(format!("needs `{}`: {from}", place.display()));
        }
        run.reads().find_map(|name| {
            let why = self.left_out(self.spec.runs.get(name)?)?;
            Some(format!("needs run `{name}`: {why}"))
        })
    }

    /// The sweep of a run that is no command, with the numbers that rows take from it.
    pub(crate) fn sweep(&self, name: &str, run: &RunSpec, output: &Path) -> Result<Option<Sweep>> {
        let adapt = |spec: &mut SweepSpec| self.adapt(name, run, spec);
        let sweep = match (&run.sweep, &run.job) {
            (Some(file), _) => Sweep::read_adapted(&self.folder.join(file), &adapt)?,
            (_, Some(file)) => Sweep::of_job(&self.folder.join(file), &adapt)?,
            _ => return Ok(None),
        };
        Ok(Some(sweep.with_folder(&output.join(name), "reproduce")))
    }

    /// An error about a key that the study sets, at its place in the study.
    pub(crate) fn at_own_key(&self, name: &str, run: &RunSpec, mut error: Error) -> Error {
        if let Error::Several(several) = error {
            let several = several.into_iter();
            return Error::Several(several.map(|one| self.at_own_key(name, run, one)).collect());
        }
        let Error::Config { key, place, .. } = &mut error else {
            return error;
        };
        let Some(set) = key.strip_prefix("set.") else {
            return error;
        };
        let full_key = match self.is_quick && run.quick.set.contains_key(set) {
            true => format!("runs.{name}.quick.set.{set}"),
            false if run.set.contains_key(set) => format!("runs.{name}.set.{set}"),
            false => return error,
        };
        (*key, *place) = (full_key, None);
        self.document.locate(error)
    }

    /// Refuses rows that name what is no axis of their sweep, or values that no run of the full size has, before any work.
    pub(crate) fn must_have_axes(&self, plans: &BTreeMap<&str, &SweepPlan>) -> Result<()> {
        for (i, row) in self.spec.rows.iter().enumerate() {
            let Some(plan) = row.of.as_deref().and_then(|name| plans.get(name)) else {
                continue;
            };
            let sweep = &plan.sweep;
            let names: Vec<&str> = sweep.axes.iter().map(|axis| axis.name.as_str()).collect();
            let refuse = |key: &str, name: &str| {
                let key = format!("rows[{i}].{key}");
                let error = Error::config(
                    key,
                    format!("`{name}` is no axis of the sweep"),
                    names.join(", "),
                );
                Err(self.document.locate(error))
            };
            if let Some(name) = row
                .at
                .iter()
                .flat_map(Map::keys)
                .find(|name| !names.contains(&name.as_str()))
            {
                return refuse("at", name);
            }
            let open = |axis: &&crate::axes::Axis| {
                let is_named = row
                    .at
                    .as_ref()
                    .is_some_and(|at| at.contains_key(&axis.name));
                !is_named && axis.values().len() > 1
            };
            let is_named = row.at.is_some() || row.over.is_some() || row.best;
            if !is_named && sweep.axes.iter().any(|axis| axis.values().len() > 1) {
                return Err(self.document.locate(Error::config(
                    format!("rows[{i}]"),
                    "a number of a sweep, and not of which run",
                    "at with a value for every axis, best = true, or over with take or share_of",
                )));
            }
            if row.at.is_some()
                && row.over.is_none()
                && let Some(axis) = sweep.axes.iter().find(open)
            {
                return Err(self.document.locate(Error::config(
                    format!("rows[{i}].at"),
                    format!("several runs have these values: it says nothing of `{}`", axis.name),
                    "a value for every axis; or over = [] with take, for all that have these values",
                )));
            }
            // A quick size may leave values out
            let has = |at: &&Map<String, Value>| (0..plan.runs.len()).any(|r| is_at(plan, r, at));
            if !self.is_quick && row.at.as_ref().is_some_and(|at| !has(&at)) {
                return Err(self.document.locate(Error::config(
                    format!("rows[{i}].at"),
                    "no run has these values",
                    "values of the axes, as they stand in the table of the sweep",
                )));
            }
            for text in row.over.iter().flatten() {
                let condition = text.parse::<Condition>().ok();
                let unknown =
                    |name: &&str| !names.contains(name) && !sweep.metrics.iter().any(|m| m == name);
                if let Some(name) = condition.iter().flat_map(Condition::names).find(unknown) {
                    return refuse("over", name);
                }
            }
        }
        Ok(())
    }

    fn adapt(&self, name: &str, run: &RunSpec, spec: &mut SweepSpec) -> Result<()> {
        let quick = self.is_quick.then_some(&run.quick);
        let set = [Some(&run.set), quick.map(|quick| &quick.set)];
        for (key, value) in set.into_iter().flatten().flatten() {
            spec.set.insert(key.clone(), value.clone());
        }
        for axis in quick.map_or(&[][..], |quick| &quick.axes) {
            let of_key = spec
                .axes
                .iter_mut()
                .find(|full_axis| axis.replaces(full_axis));
            let Some(full_axis) = of_key else {
                let key = axis.key.as_ref().or(axis.name.as_ref());
                let found = format!(
                    "the quick size of run `{name}` names the axis `{}`",
                    key.map_or("", String::as_str)
                );
                let accepted = "the key of an axis of the sweep; of one with cases its name";
                return Err(Error::config("axes", found, accepted));
            };
            let name = axis.name.clone().or(full_axis.name.take());
            *full_axis = AxisSpec {
                name,
                ..axis.clone()
            };
        }
        let mut runs = self.spec.runs.values();
        let is_read = runs.any(|run| run.reads().any(|read| read == name));
        if is_read && spec.keep == Leaves::Metrics {
            spec.keep = Leaves::Patterns;
        }
        let is_axis =
            |path: &String, spec: &SweepSpec| spec.axes.iter().any(|axis| axis.is_named(path));
        for (key, path) in self.numbers_of(name) {
            if !spec.metrics.contains(&path) && !is_axis(&path, spec) {
                metric::must_exist(&path, &key).map_err(|e| self.document.locate(e))?;
                spec.metrics.push(path);
            }
        }
        Ok(())
    }

    /// The numbers of reports that rows and tables take from a run, each with the key that asks for it.
    fn numbers_of(&self, name: &str) -> Vec<(String, String)> {
        let mut numbers = Vec::new();
        for (i, row) in self.spec.rows.iter().enumerate() {
            if row.of.as_deref() != Some(name) {
                continue;
            }
            let metric = row.metric.iter().map(|path| ("metric", path.clone()));
            let share = row.share_of.as_ref();
            let share = share.and_then(|text| text.parse::<Condition>().ok());
            let names = share.iter().flat_map(Condition::names);
            let names = names.map(|path| ("share_of", path.to_owned()));
            let named = |(key, path): (&str, String)| (format!("rows[{i}].{key}"), path);
            numbers.extend(metric.chain(names).map(named));
        }
        for (i, table) in self.spec.tables.iter().enumerate() {
            let columns = table
                .columns
                .iter()
                .enumerate()
                .filter(|_| table.of == name);
            let key = |k: usize| format!("tables[{i}].columns[{k}].metric");
            numbers.extend(columns.map(|(k, column)| (key(k), column.metric.clone())));
        }
        numbers
    }
}

fn check(spec: &StudySpec, written: &Value) -> Result<()> {
    for (name, run) in &spec.runs {
        let is_plain = |c: char| c.is_alphanumeric() || "_-".contains(c);
        if name.is_empty() || !name.chars().all(is_plain) {
            return Err(Error::config(
                "runs",
                format!("a run named `{name}`"),
                "letters, digits, `_` and `-`: it is the name of its folder",
            ));
        }
        let first = run
            .command
            .as_ref()
            .map(|words| words.first().map(String::as_str));
        if matches!(first, Some(None | Some("reproduce"))) {
            return Err(Error::config(
                format!("runs.{name}.command"),
                "no command, or one that reproduces a study",
                "what is typed after `tomolith`, such as [\"analyze\", \"buildup\", …]",
            ));
        }
        let kinds = [
            run.sweep.is_some(),
            run.job.is_some(),
            run.command.is_some(),
        ];
        if kinds.into_iter().filter(|is| *is).count() != 1 {
            let accepted = "exactly one of sweep, job and command";
            return Err(Error::config(
                format!("runs.{name}"),
                "none, or several",
                accepted,
            ));
        }
        if let Some((key, found, accepted)) = run.unheard() {
            return Err(Error::config(format!("runs.{name}.{key}"), found, accepted));
        }
    }
    commands::check(spec)?;
    figures::check(spec)?;
    let mut named = BTreeSet::new();
    for (i, row) in spec.rows.iter().enumerate() {
        let at = format!("rows[{i}]");
        if let Some((key, found, accepted)) = at_odds(&written["rows"][i]) {
            return Err(Error::config(format!("{at}.{key}"), found, accepted));
        }
        check_row(spec, row, &at, &named)?;
        named.extend(row.name.as_deref());
    }
    for (i, table) in spec.tables.iter().enumerate() {
        let run = spec.runs.get(&table.of);
        if run.is_none_or(|run| run.command.is_some()) {
            let sweeps = spec.runs.iter().filter(|(_, run)| run.command.is_none());
            let names: Vec<&str> = sweeps.map(|(name, _)| name.as_str()).collect();
            let found = format!("`{}` is no sweep or job of this study", table.of);
            return Err(Error::config(
                format!("tables[{i}].of"),
                found,
                names.join(", "),
            ));
        }
    }
    Ok(())
}

/// A row has one source, and a verdict that is computed or explained.
fn check_row(spec: &StudySpec, row: &RowSpec, at: &str, named: &BTreeSet<&str>) -> Result<()> {
    let refuse = |key: &str, found: String, accepted: &str| {
        let at = if key.is_empty() {
            at.to_owned()
        } else {
            format!("{at}.{key}")
        };
        Err(Error::config(at, found, accepted))
    };
    if let Some(run) = &row.of {
        if !spec.runs.contains_key(run) {
            let names: Vec<&str> = spec.runs.keys().map(String::as_str).collect();
            return refuse("of", format!("unknown run `{run}`"), &names.join(", "));
        }
        if row.metric.is_none() && row.share_of.is_none() {
            return refuse("metric", "none".to_owned(), "a number of the run's report");
        }
        let of_many = [
            ("at", row.at.is_some()),
            ("best", row.best),
            ("over", row.over.is_some()),
        ];
        let of_many = of_many.into_iter().find(|(_, is_given)| *is_given);
        if let (Some((key, _)), None) = (of_many, &spec.runs[run].sweep) {
            let found = format!("together with of = \"{run}\", which is no sweep");
            return refuse(key, found, "a run with a sweep; without it the only run");
        }
    }
    let mut names = Vec::new();
    let (value, holds) = (row.value.as_ref(), row.holds.as_ref());
    match (
        value.map(|text| text.parse::<Expression>()),
        holds.map(|text| text.parse::<Condition>()),
    ) {
        (Some(Err(found)), _) => {
            return refuse("value", found, "arithmetic on names of earlier rows");
        }
        (_, Some(Err(found))) => return refuse("holds", found, "a comparison of earlier rows"),
        (Some(Ok(value)), _) => names.extend(value.names().into_iter().map(str::to_owned)),
        (_, Some(Ok(holds))) => names.extend(holds.names().into_iter().map(str::to_owned)),
        _ => {}
    }
    if let Some(name) = names.iter().find(|name| !named.contains(name.as_str())) {
        let key = if value.is_some() { "value" } else { "holds" };
        return refuse(
            key,
            format!("no earlier row is named `{name}`"),
            "names of earlier rows",
        );
    }
    let conditions = row.over.iter().flatten().map(|text| ("over", text));
    for (key, text) in conditions.chain(row.share_of.iter().map(|text| ("share_of", text))) {
        if let Err(found) = text.parse::<Condition>() {
            return refuse(key, found, "a comparison, such as \"lower >= 0.75*upper\"");
        }
    }
    for (key, most) in [
        ("within", row.within),
        ("within_percent", row.within_percent),
    ] {
        if let Some(most) = most.filter(|most| !(*most >= 0.0 && most.is_finite())) {
            return refuse(key, format!("found {most}"), "0 or more");
        }
    }
    if let Some(name) = row.name.as_deref().filter(|name| named.contains(name)) {
        return refuse("name", format!("`{name}` once more"), "a name of its own");
    }
    if row.over.is_some() && row.take.is_none() && row.share_of.is_none() {
        return refuse(
            "over",
            "neither take nor share_of".to_owned(),
            "take = \"min\", \"max\" or \"mean\", or share_of",
        );
    }
    let is_computed = row.within.is_some() || row.within_percent.is_some() || row.holds.is_some();
    let is_explained = row.differs.is_some() || row.under_specified.is_some();
    if row.published.is_some() && !is_computed && !is_explained {
        return refuse(
            "",
            "a published number without a verdict".to_owned(),
            "within, within_percent, differs or under_specified",
        );
    }
    Ok(())
}
