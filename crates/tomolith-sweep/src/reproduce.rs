//! A study run and compared with what is published: one table, the pictures of its sweeps.
//!
//! The sweeps do the work, so that finished runs are never redone and a killed study goes on. Here their numbers are only set next to the
//! published ones. A verdict is computed where the study states a tolerance or a comparison; elsewhere the study says why.

use crate::axes::label;
use crate::commands::filled_in;
use crate::engine::{self, Watch};
use crate::expression::{Condition, Expression};
use crate::metric;
use crate::plan::{SweepPlan, must_be_made_for_results};
use crate::study::{ColumnSpec, RowSpec, RunSpec, Study, Take};
use crate::table::{State, Table, field};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::fmt::{self, Write as _};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use tomolith::io::{make_folder, read_text, write_text, write_whole};
use tomolith::models::Work;
use tomolith::report::number::significant;
use tomolith::units::{counted, duration};
use tomolith::{Error, Result};

/// Whoever has a study run: shows it, and runs commands.
pub trait Host {
    /// Called once, when every job was checked and before any work.
    fn begins(&mut self, costs: &[StudyCost]);
    /// Who watches a sweep.
    fn watch(&mut self, name: &str, plan: &SweepPlan) -> Box<dyn Watch + '_>;
    /// Refuses words that cannot be typed after `tomolith`, and files that they would leave where `writes` does not say so: at the key `command`
    /// or `writes`.
    ///
    /// # Errors
    /// [`Error::Config`].
    fn must_be_command(&self, words: &[String], writes: bool) -> Result<()>;
    /// Runs what would be typed after `tomolith` in a folder; its answer as JSON.
    ///
    /// # Errors
    /// As the command.
    fn command(&mut self, words: &[String], folder: &Path) -> Result<Value>;
}

/// What a thing that is run will cost.
#[derive(Clone, Debug, Serialize)]
pub struct StudyCost {
    /// Its name in the study.
    pub name: String,
    /// Its runs; none for a command.
    pub runs: Option<usize>,
    /// About how long those take that are not finished, by the clock and with all cores, s.
    pub seconds: f64,
    /// Why it is left out.
    pub left_out: Option<String>,
}

impl fmt::Display for StudyCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.left_out, self.runs) {
            (Some(why), _) => write!(f, "{}: left out, {why}", self.name),
            (None, Some(runs)) => {
                let time = duration(self.seconds);
                write!(f, "{}: {}, about {time}", self.name, counted(runs, "run"))
            }
            (None, None) => write!(f, "{}: a command, seconds", self.name),
        }
    }
}

/// What a comparison came to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "verdict", content = "because", rename_all = "snake_case")]
pub enum Verdict {
    /// Within the tolerance that the study states, or as it is compared.
    Reproduced,
    /// Another number, and why.
    Differs(String),
    /// The paper leaves something open, which the study has chosen.
    UnderSpecified(String),
    /// Ours is there, and nothing to compare it with.
    NotCompared(String),
    /// Another number, and the study does not say why.
    Unexplained,
    /// There is none of ours.
    Missing(String),
}

impl Verdict {
    /// The verdict, and what follows it.
    fn parts(&self) -> (&'static str, &str) {
        match self {
            Verdict::Reproduced => ("reproduced", ""),
            Verdict::Differs(why) => ("differs", why),
            Verdict::UnderSpecified(why) => ("under-specified", why),
            Verdict::NotCompared(why) => ("not compared", why),
            Verdict::Unexplained => (
                "unexplained",
                "another number, and the study does not say why",
            ),
            Verdict::Missing(why) => ("no number", why),
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.parts() {
            (verdict, "") => f.write_str(verdict),
            (verdict @ ("differs" | "under-specified"), why) => {
                write!(f, "{verdict}, because {why}")
            }
            (verdict, why) => write!(f, "{verdict}: {why}"),
        }
    }
}

/// What a paper says; in JSON a number, words or null.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum PublishedValue {
    /// A number.
    Number(f64),
    /// Words.
    Words(String),
    /// Nothing: a row that later ones compare.
    Nothing,
}

impl fmt::Display for PublishedValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PublishedValue::Number(number) => f.write_str(&significant(*number, 4)),
            PublishedValue::Words(words) => f.write_str(words),
            PublishedValue::Nothing => f.write_str("–"),
        }
    }
}

/// A row of the table.
#[derive(Clone, Debug, Serialize)]
pub struct StudyRow {
    /// What it is.
    pub quantity: String,
    /// What is published.
    pub published: PublishedValue,
    /// Ours.
    pub ours: Option<f64>,
    /// Ours over the published number, where that is not 0.
    pub ratio: Option<f64>,
    /// Ours less the published number.
    pub difference: Option<f64>,
    /// What the comparison came to.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// Where it stands in the paper.
    pub place: String,
    /// Whether ours is a yes or no.
    #[serde(skip)]
    is_truth: bool,
}

impl StudyRow {
    fn ours_text(&self) -> String {
        match self.ours {
            None => "–".to_owned(),
            Some(ours) if self.is_truth => if ours == 0.0 { "no" } else { "yes" }.to_owned(),
            Some(ours) => significant(ours, 4),
        }
    }

    fn compared_text(&self) -> String {
        match (self.ratio, self.difference) {
            (Some(ratio), _) => format!("× {}", significant(ratio, 3)),
            (None, Some(difference)) => {
                let sign = if difference > 0.0 { "+" } else { "" };
                format!("{sign}{}", significant(difference, 3))
            }
            _ => String::new(),
        }
    }
}

/// A study's table.
#[derive(Clone, Debug, Serialize)]
pub struct Reproduction {
    /// Where results are.
    pub folder: PathBuf,
    /// Rows in the order of the study.
    pub rows: Vec<StudyRow>,
    /// Tables of whole sweeps, as Markdown.
    #[serde(skip)]
    tables: Vec<String>,
    /// Pictures of its sweeps and commands.
    pub figures: Vec<PathBuf>,
    /// The table, as Markdown and CSV.
    pub files: Vec<PathBuf>,
}

impl Reproduction {
    /// Whether every number is there and every difference explained.
    #[must_use]
    pub fn is_met(&self) -> bool {
        let is_open =
            |row: &StudyRow| matches!(row.verdict, Verdict::Unexplained | Verdict::Missing(_));
        !self.rows.iter().any(is_open)
    }

    /// How often each verdict was given, in words.
    #[must_use]
    pub fn counts(&self) -> String {
        let words = [
            "reproduced",
            "differs",
            "unexplained",
            "under-specified",
            "not compared",
            "no number",
        ];
        let count = |word: &str| {
            self.rows
                .iter()
                .filter(|row| row.verdict.parts().0 == word)
                .count()
        };
        let counts = words.map(|word| (count(word), word));
        let shown = counts.iter().filter(|(count, _)| *count > 0);
        shown
            .map(|(count, word)| format!("{count} {word}"))
            .collect::<Vec<_>>()
            .join(", ")
    }
}

impl fmt::Display for Reproduction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for row in &self.rows {
            let (quantity, published) = (&row.quantity, &row.published);
            let ours = row.ours_text();
            writeln!(f, "{quantity} · {published} · {ours} · {}", row.verdict)?;
        }
        writeln!(
            f,
            "{:>12} {}",
            counted(self.rows.len(), "row"),
            self.counts()
        )?;
        for file in &self.files {
            writeln!(f, "{:>12} {}", "wrote", file.display())?;
        }
        Ok(())
    }
}

/// Result of a thing that was run.
enum RunResult {
    Sweep(Box<SweepPlan>),
    Answer(Value),
    /// Left out by choice, or not able to.
    Nothing(Verdict),
}

/// Runs a study and writes `table.md` and `table.csv` into the folder of its results, next to a folder for each run.
///
/// # Errors
/// [`Error::Config`] for sweeps and jobs that cannot run, before any does; [`Error::Canceled`]; [`Error::Io`]. A run or a command that fails
/// leaves rows without a number.
pub fn reproduce(
    study: &Study,
    output: &Path,
    threads: usize,
    host: &mut dyn Host,
    work: &Work,
) -> Result<Reproduction> {
    let mut results = plans(study, output, threads, host, work)?;
    host.begins(&costs(study, &results, work)?);
    make_folder(output)?;
    let owner = serde_json::json!({ "study": study.folder }).to_string();
    write_text(&output.join(OWNER), &owner)?;
    let mut figures = Vec::new();
    for (name, plan) in &results {
        if let RunResult::Sweep(plan) = plan {
            let mut watch = host.watch(name, plan);
            figures.extend(engine::run(plan, None, watch.as_mut(), work)?.files);
        }
    }
    // Commands may read what jobs left
    for (name, run) in &study.spec.runs {
        let (Some(words), None) = (&run.command, study.left_out(run)) else {
            continue;
        };
        let words = filled_in(words, &planned(&results));
        let (answer, files) = command(study, run, &words, &output.join(name), host)?;
        results.insert(name.clone(), answer);
        figures.extend(files);
    }
    figures.retain(|file| file.extension().is_some_and(|e| e == "svg"));
    figures.extend(crate::figures::write(study, &planned(&results), output)?);
    let rows = rows(study, &results)?;
    let mut all = Reproduction {
        folder: output.to_owned(),
        rows,
        tables: tables(study, &results)?,
        figures,
        files: Vec::new(),
    };
    let tables = [
        ("table.md", markdown(study, &all)),
        ("table.csv", csv(&all.rows)),
    ];
    for (name, text) in tables {
        let file = output.join(name);
        write_text(&file, &text)?;
        all.files.push(file);
    }
    Ok(all)
}

/// Every sweep and job, read and checked, and every command.
fn plans(
    study: &Study,
    output: &Path,
    threads: usize,
    host: &dyn Host,
    work: &Work,
) -> Result<BTreeMap<String, RunResult>> {
    for (name, run) in &study.spec.runs {
        if let Some(words) = &run.command {
            let is_one = host.must_be_command(words, run.writes);
            is_one.map_err(|e| study.at_command(name, e))?;
        }
    }
    let plan = |(name, run): (&String, &RunSpec)| {
        let result = match study.left_out(run) {
            Some(why) => RunResult::Nothing(Verdict::NotCompared(why)),
            None => match study.sweep(name, run, output)? {
                Some(sweep) => {
                    let plan = sweep.plan(threads, work);
                    let plan = plan.map_err(|e| study.at_own_key(name, run, e))?;
                    RunResult::Sweep(Box::new(plan))
                }
                None => RunResult::Nothing(Verdict::Missing("not run yet".to_owned())),
            },
        };
        Ok((name.clone(), result))
    };
    let results = study
        .spec
        .runs
        .iter()
        .map(plan)
        .collect::<Result<BTreeMap<_, _>>>()?;
    study.must_have_axes(&planned(&results))?;
    study.must_have_runs(&planned(&results))?;
    study.must_spare_its_files(output, &planned(&results))?;
    must_be_made_for_results("--output", output, OWNER)?;
    Ok(results)
}

/// The plans of sweeps and jobs, by the names of their runs.
fn planned(results: &BTreeMap<String, RunResult>) -> BTreeMap<&str, &SweepPlan> {
    let of_sweeps = results.iter().filter_map(|(name, result)| match result {
        RunResult::Sweep(plan) => Some((name.as_str(), plan.as_ref())),
        _ => None,
    });
    of_sweeps.collect()
}

impl Study {
    /// What a study will cost.
    ///
    /// # Errors
    /// As [`reproduce`], before any work.
    pub fn costs(
        &self,
        output: &Path,
        threads: usize,
        host: &dyn Host,
        work: &Work,
    ) -> Result<Vec<StudyCost>> {
        costs(self, &plans(self, output, threads, host, work)?, work)
    }
}

fn costs(
    study: &Study,
    results: &BTreeMap<String, RunResult>,
    work: &Work,
) -> Result<Vec<StudyCost>> {
    let cost = |(name, result): (&String, &RunResult)| {
        let (runs, seconds) = match result {
            RunResult::Sweep(plan) => (Some(plan.runs.len()), plan.seconds(work)?),
            _ => (None, 0.0),
        };
        Ok(StudyCost {
            name: name.clone(),
            runs,
            seconds,
            left_out: study.left_out(&study.spec.runs[name]),
        })
    };
    results.iter().map(cost).collect()
}

/// Says of which study a folder holds the results.
const OWNER: &str = "study.json";

/// In a folder that a command wrote: its words.
const COMMAND: &str = "command.json";

/// A command's answer (the report of the folder that it writes, where it writes one), and its pictures.
fn command(
    study: &Study,
    run: &RunSpec,
    words: &[String],
    folder: &Path,
    host: &mut dyn Host,
) -> Result<(RunResult, Vec<PathBuf>)> {
    let mut words = words.to_vec();
    if run.writes {
        let absolute = std::path::absolute(folder).map_err(|e| Error::io(folder, e))?;
        if folder.join(COMMAND).is_file() {
            std::fs::remove_dir_all(folder).map_err(|e| Error::io(folder, e))?;
        }
        words.extend(["--output".to_owned(), absolute.display().to_string()]);
    }
    let answer = match host.command(&words, &study.folder) {
        Ok(answer) => answer,
        Err(Error::Canceled) => return Err(Error::Canceled),
        Err(error) => {
            return Ok((
                RunResult::Nothing(Verdict::Missing(error.to_string())),
                Vec::new(),
            ));
        }
    };
    if !run.writes {
        return Ok((RunResult::Answer(answer), Vec::new()));
    }
    // What a later call may replace
    let bytes = serde_json::to_vec(&words).unwrap_or_default();
    write_whole(&folder.join(COMMAND), |out| Ok(out.write_all(&bytes)?))?;
    let report = read_text(folder.join("report.json")).ok();
    let report = report.and_then(|text| serde_json::from_str(&text).ok());
    let entries = std::fs::read_dir(folder).map_err(|e| Error::io(folder, e))?;
    let mut files: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .collect();
    files.sort();
    Ok((RunResult::Answer(report.unwrap_or(answer)), files))
}

/// The runs of the sweeps that the study lays out whole.
fn tables(study: &Study, results: &BTreeMap<String, RunResult>) -> Result<Vec<String>> {
    let mut tables = Vec::new();
    for spec in &study.spec.tables {
        let RunResult::Sweep(plan) = &results[&spec.of] else {
            continue;
        };
        let table = Table::collect(plan)?;
        let axes = plan.sweep.axes.iter().map(|axis| axis.name.as_str());
        let heads: Vec<&str> = (axes.chain(spec.columns.iter().map(|c| c.name.as_str()))).collect();
        let mut text = format!("## {}\n\n{}", spec.title, markdown_head(&heads));
        for (i, run) in plan.runs.iter().enumerate() {
            let number = |column: &ColumnSpec| {
                let number = table.metric(i, &column.metric);
                number.map_or_else(|| "–".to_owned(), |number| significant(number, 3))
            };
            let values = plan.sweep.axes.iter().zip(&run.point.values);
            let values = values.map(|(axis, value)| axis.label(value));
            let cells: Vec<String> = values.chain(spec.columns.iter().map(number)).collect();
            let _ = writeln!(text, "| {} |", cells.join(" | "));
        }
        tables.push(text);
    }
    Ok(tables)
}

fn rows(study: &Study, results: &BTreeMap<String, RunResult>) -> Result<Vec<StudyRow>> {
    let mut tables = BTreeMap::new();
    for (name, plan) in planned(results) {
        tables.insert(name, Table::collect(plan)?);
    }
    let mut named: BTreeMap<&str, f64> = BTreeMap::new();
    let mut rows = Vec::new();
    for row in &study.spec.rows {
        let ours = ours(row, study.is_quick, results, &tables, &named);
        if let (Some(name), Ok(ours)) = (&row.name, &ours) {
            named.insert(name, *ours);
        }
        rows.push(compared(row, ours, study.is_quick));
    }
    Ok(rows)
}

/// Our number, or why there is none.
fn ours(
    row: &RowSpec,
    is_quick: bool,
    results: &BTreeMap<String, RunResult>,
    tables: &BTreeMap<&str, Table<'_>>,
    named: &BTreeMap<&str, f64>,
) -> Result<f64, Verdict> {
    let number_of = |name: &str| named.get(name).copied();
    let missing = |why: &str| Verdict::Missing(why.to_owned());
    // Rows without a number state the reason; rows that follow from them have none either
    let unknown = || Verdict::NotCompared("an earlier row has no number".to_owned());
    let parsed = |text: &String| text.parse::<Condition>().ok();
    if let Some(value) = &row.value {
        let value = value.parse::<Expression>().ok();
        let value = value
            .and_then(|value| value.value(&number_of))
            .ok_or_else(unknown)?;
        return match value.is_finite() {
            true => Ok(value),
            false => Err(missing("not a finite number")),
        };
    }
    if let Some(holds) = row.holds.as_ref().and_then(parsed) {
        if holds.names().iter().any(|name| number_of(name).is_none()) {
            return Err(unknown());
        }
        return Ok(f64::from(u8::from(holds.is_met(&number_of))));
    }
    let Some(name) = &row.of else {
        return Err(
            explained(row).unwrap_or_else(|| Verdict::NotCompared("not computed".to_owned()))
        );
    };
    let metric = row.metric.as_deref().unwrap_or_default();
    match &results[name] {
        RunResult::Nothing(verdict) => Err(verdict.clone()),
        RunResult::Answer(answer) => match metric::number(answer, metric) {
            Ok(number) => number.ok_or_else(|| missing("not defined")),
            Err(why) => Err(Verdict::Missing(why)),
        },
        RunResult::Sweep(plan) => of_sweep(row, is_quick, plan, &tables[name.as_str()], metric),
    }
}

fn of_sweep(
    row: &RowSpec,
    is_quick: bool,
    plan: &SweepPlan,
    table: &Table<'_>,
    metric: &str,
) -> Result<f64, Verdict> {
    let missing = |why: &str| Err(Verdict::Missing(why.to_owned()));
    let number = |i: usize, name: &str| {
        crate::axes::named(&plan.sweep.axes, &plan.runs[i].point, name)
            .or_else(|| table.metric(i, name))
    };
    if let Some(over) = &row.over {
        let conditions: Vec<Condition> = over.iter().filter_map(|text| text.parse().ok()).collect();
        let is_there = |i: &usize| row.at.as_ref().is_none_or(|at| is_at(plan, *i, at));
        // A run without numbers counts where its axes alone do not leave it out
        let of_axes =
            |i: usize, name: &str| crate::axes::named(&plan.sweep.axes, &plan.runs[i].point, name);
        let leaves_out = |i: usize| {
            conditions.iter().any(|c| {
                c.names().iter().all(|name| of_axes(i, name).is_some())
                    && !c.is_met(&|name| of_axes(i, name))
            })
        };
        let failed = (0..plan.runs.len())
            .filter(is_there)
            .filter(|&i| !matches!(table.states[i], State::Done(_)) && !leaves_out(i));
        let failed = failed.count();
        if failed > 0 {
            return missing(&format!("{} failed", counted(failed, "run")));
        }
        let meets = |i: &usize| {
            is_there(i)
                && conditions
                    .iter()
                    .all(|c| c.is_met(&|name| number(*i, name)))
        };
        let among: Vec<usize> = (0..plan.runs.len()).filter(meets).collect();
        return of_many(row, &among, metric, &number)
            .map_or_else(|| missing("no run meets the conditions"), Ok);
    }
    let i = match &row.at {
        Some(at) => (0..plan.runs.len()).find(|&i| is_at(plan, i, at)),
        None if row.best => table.best,
        None => Some(0).filter(|_| plan.runs.len() == 1),
    };
    let Some(i) = i else {
        return match row.at {
            Some(_) if is_quick => Err(Verdict::NotCompared(
                "no run of this size has these values".to_owned(),
            )),
            Some(_) => missing("no run has the values of `at`"),
            None => missing("no run is the best, or none is named"),
        };
    };
    match (&table.states[i], number(i, metric)) {
        (State::Failed(why), _) => Err(Verdict::Missing(failed_run(plan, i, why))),
        (_, Some(number)) => Ok(number),
        (_, None) => missing("not defined"),
    }
}

/// Why a run of a sweep failed, and which it is; a job has only one.
fn failed_run(plan: &SweepPlan, i: usize, why: &str) -> String {
    match plan.words(i) {
        values if values.is_empty() => why.to_owned(),
        values => format!("run {} ({values}) failed: {why}", i + 1),
    }
}

/// The share of some runs, or what is taken of their metric.
fn of_many(
    row: &RowSpec,
    among: &[usize],
    metric: &str,
    number: &dyn Fn(usize, &str) -> Option<f64>,
) -> Option<f64> {
    if let Some(share) = row
        .share_of
        .as_ref()
        .and_then(|text| text.parse::<Condition>().ok())
    {
        let met = among
            .iter()
            .filter(|&&i| share.is_met(&|name| number(i, name)))
            .count();
        return (!among.is_empty()).then(|| met as f64 / among.len() as f64);
    }
    let values = among.iter().filter_map(|&i| number(i, metric));
    match row.take? {
        Take::Min => values.reduce(f64::min),
        Take::Max => values.reduce(f64::max),
        Take::Mean => {
            let (sum, count) = values.fold((0.0, 0.0), |(sum, count), v| (sum + v, count + 1.0));
            (count > 0.0).then(|| sum / count)
        }
    }
}

/// Whether a run has these values, numbers to 9 digits.
pub(crate) fn is_at(plan: &SweepPlan, i: usize, at: &Map<String, Value>) -> bool {
    let axes = &plan.sweep.axes;
    at.iter().all(|(name, wanted)| {
        let place = axes.iter().position(|axis| axis.name == *name);
        place.is_some_and(|a| {
            let value = &plan.runs[i].point.values[a];
            match (value.as_f64(), wanted.as_f64()) {
                (Some(value), Some(wanted)) => {
                    (value - wanted).abs() <= 1e-9 * wanted.abs().max(1e-300)
                }
                _ => value == wanted || label(value) == label(wanted),
            }
        })
    })
}

fn compared(row: &RowSpec, ours: Result<f64, Verdict>, is_quick: bool) -> StudyRow {
    let ours_number = ours.as_ref().ok().copied();
    let pair = ours_number.zip(row.published);
    let words = || row.says.clone().map(PublishedValue::Words);
    let published = row.published.map(PublishedValue::Number).or_else(words);
    StudyRow {
        quantity: row.quantity.clone(),
        published: published.unwrap_or(PublishedValue::Nothing),
        ours: ours_number,
        ratio: pair
            .filter(|(_, published)| *published != 0.0)
            .map(|(ours, published)| ours / published),
        difference: pair.map(|(ours, published)| ours - published),
        verdict: ours.map_or_else(|why| why, |ours| verdict(row, ours, is_quick)),
        place: row.place.clone(),
        is_truth: row.holds.is_some(),
    }
}

/// What the study says of a number that is not the published one.
fn explained(row: &RowSpec) -> Option<Verdict> {
    let differs = row.differs.clone().map(Verdict::Differs);
    differs.or_else(|| row.under_specified.clone().map(Verdict::UnderSpecified))
}

fn verdict(row: &RowSpec, ours: f64, is_quick: bool) -> Verdict {
    if row.full_size && is_quick {
        return Verdict::NotCompared("full size only".to_owned());
    }
    let differences = row.published.map(|published| (ours - published, published));
    let tolerance = |(_, published): (f64, f64)| {
        let relative = row
            .within_percent
            .map(|percent| 0.01 * percent * published.abs());
        // Rounding of the last digit is no difference
        row.within
            .or(relative)
            .map(|tolerance| tolerance * (1.0 + 1e-9) + 1e-12)
    };
    let is_near = differences.and_then(|pair| tolerance(pair).map(|most| pair.0.abs() <= most));
    let is_met = is_near.or_else(|| row.holds.as_ref().map(|_| ours != 0.0));
    let explained = || explained(row);
    match is_met {
        Some(true) => Verdict::Reproduced,
        Some(false) => explained().unwrap_or(Verdict::Unexplained),
        None => {
            explained().unwrap_or_else(|| Verdict::NotCompared("no published number".to_owned()))
        }
    }
}

const COLUMNS: [&str; 6] = [
    "quantity",
    "published",
    "ours",
    "ours / published",
    "verdict",
    "where",
];

fn markdown_head(names: &[&str]) -> String {
    let line = "---|".repeat(names.len());
    format!("| {} |\n|{line}\n", names.join(" | "))
}

fn markdown(study: &Study, all: &Reproduction) -> String {
    let spec = &study.spec;
    let size = if study.is_quick {
        "quick size"
    } else {
        "full size"
    };
    let mut text = format!("# {}\n\n{}\n\n", spec.title, spec.paper);
    for paragraph in [
        spec.about.trim(),
        if study.is_quick {
            spec.quick.trim()
        } else {
            ""
        },
    ] {
        if !paragraph.is_empty() {
            let _ = write!(text, "{paragraph}\n\n");
        }
    }
    let _ = write!(
        text,
        "{} ({size}): {}.\n\n",
        counted(all.rows.len(), "row"),
        all.counts()
    );
    text.push_str(&markdown_head(&COLUMNS));
    for row in &all.rows {
        let verdict = row.verdict.to_string();
        let cells = [
            &row.quantity,
            &row.published.to_string(),
            &row.ours_text(),
            &row.compared_text(),
            &verdict,
            &row.place,
        ];
        let cells = cells.map(|cell| {
            cell.replace('|', "\\|")
                .split_whitespace()
                .collect::<Vec<_>>()
                .join(" ")
        });
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    for table in &all.tables {
        let _ = write!(text, "\n{table}");
    }
    for figure in &all.figures {
        let path = figure.strip_prefix(&all.folder).unwrap_or(figure);
        let path = path.to_string_lossy().replace('\\', "/");
        let _ = write!(text, "\n![{path}]({path})\n");
    }
    text
}

fn csv(rows: &[StudyRow]) -> String {
    let mut text = "quantity,published,ours,ratio,difference,verdict,because,where\n".to_owned();
    let number = |value: Option<f64>| value.map(|v| v.to_string()).unwrap_or_default();
    for row in rows {
        let (verdict, because) = row.verdict.parts();
        let published = match &row.published {
            PublishedValue::Number(number) => number.to_string(),
            PublishedValue::Words(words) => field(words),
            PublishedValue::Nothing => String::new(),
        };
        let cells = [
            field(&row.quantity),
            published,
            number(row.ours),
            number(row.ratio),
            number(row.difference),
            verdict.to_owned(),
            field(because),
            field(&row.place),
        ];
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}
