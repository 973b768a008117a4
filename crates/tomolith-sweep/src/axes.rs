//! Axes and the points of a sweep: all combinations that meet the conditions, or points that are drawn.
//!
//! A range `from … to` has the values from + i·step, or with a count the i-th of count, from + (to − from)·i/(count − 1) or
//! from·(to/from)^(i/(count − 1)), to twelve significant digits, so that 0.3 is 0.3. Draws come from SplitMix64 (Steele, Lea and Flood
//! 2014): the same points on every machine.

use crate::expression::Condition;
use crate::spec::{AxisSpec, CaseSpec, DrawSpec, RangeSpec, SampleSpec};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use tomolith::random::SplitMix;
use tomolith::units::{concise, duration};
use tomolith::{Error, Result};

/// Runs, at most; combinations that are looked at, at most.
pub const MOST_RUNS: usize = 100_000;
const MOST_COMBINATIONS: f64 = 1e7;
/// Draws for a point that meets the conditions, at most.
const TRIES: usize = 1000;
/// Names of the table's other columns.
const TAKEN: [&str; 5] = ["run", "state", "feasible", "error", "folder"];

/// What is swept.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) name: String,
    /// The key of the job; none where cases name theirs.
    key: Option<String>,
    /// Whether equal ratios are equally far apart.
    pub(crate) is_log: bool,
    kind: AxisKind,
}

#[derive(Clone, Debug)]
enum AxisKind {
    Values(Vec<Value>),
    Range(RangeSpec),
    Cases {
        names: Vec<Value>,
        cases: Vec<CaseSpec>,
    },
}

/// One point.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepPoint {
    /// A value per axis.
    pub values: Vec<Value>,
    /// Where it lies on each axis, 0 to 1.
    pub place: Vec<f64>,
    /// Its index on each axis; none for points that are drawn.
    pub index: Option<Vec<usize>>,
}

impl Axis {
    /// Checks an axis; `at` is its key path.
    pub(crate) fn new(spec: &AxisSpec, at: &str, is_drawn: bool) -> Result<Self> {
        let of_key = || spec.key.as_deref().map(last_part);
        let Some(name) = spec.name.clone().or_else(of_key) else {
            let accepted = "a key of the job with values; or a name and cases";
            return Err(Error::config(at, "neither key nor name", accepted));
        };
        let is_name = name.starts_with(|c: char| c.is_alphabetic() || c == '_')
            && name.chars().all(|c| c.is_alphanumeric() || c == '_');
        if !is_name || TAKEN.contains(&name.as_str()) {
            let accepted = format!(
                "letters, digits and `_`, and none of the table's {}",
                TAKEN.join(", ")
            );
            return Err(Error::config(
                format!("{at}.name"),
                format!("found {name:?}"),
                accepted,
            ));
        }
        let kind = match (&spec.values, &spec.linear, &spec.log, &spec.cases) {
            (Some(values), None, None, None) => AxisKind::Values(list(values, at)?),
            (None, Some(range), None, None) => {
                of_range(range, &format!("{at}.linear"), false, is_drawn)?
            }
            (None, None, Some(range), None) => {
                of_range(range, &format!("{at}.log"), true, is_drawn)?
            }
            (None, None, None, Some(cases)) => of_cases(cases, at)?,
            (None, None, None, None) => {
                let accepted = "values = […], linear = { from, to, step }, log = { from, to, count } or cases = [{ name, set }]";
                return Err(Error::config(at, "no values", accepted));
            }
            _ => {
                return Err(Error::config(
                    at,
                    "more than one of values, linear, log and cases",
                    "one of them",
                ));
            }
        };
        if spec.key.is_some() == spec.cases.is_some() {
            let (found, accepted) = match spec.cases {
                Some(_) => (
                    "found both a key and cases",
                    "cases alone, whose `set` names the keys",
                ),
                None => (
                    "the key is missing",
                    "a key of the job, such as \"objective.ospw.lower\"",
                ),
            };
            return Err(Error::config(format!("{at}.key"), found, accepted));
        }
        Ok(Axis {
            name,
            key: spec.key.clone(),
            is_log: spec.log.is_some(),
            kind,
        })
    }

    /// Its values; empty for a range that is drawn from.
    #[must_use]
    pub(crate) fn values(&self) -> &[Value] {
        match &self.kind {
            AxisKind::Values(values) => values,
            AxisKind::Range(_) => &[],
            AxisKind::Cases { names, .. } => names,
        }
    }

    /// A value of it as people read it: kinds of one name with what tells them apart.
    pub(crate) fn label(&self, value: &Value) -> String {
        let name = label(value);
        let alike = self.values().iter().filter(|other| label(other) == name);
        let others: Vec<_> = alike.map(leaves).collect();
        let mut words = vec![name];
        let apart = |leaf: &String| !others.iter().all(|leaves| leaves.contains(leaf));
        words.extend(leaves(value).into_iter().filter(apart));
        words.join(" ")
    }

    pub(crate) fn keys(&self) -> BTreeSet<&str> {
        match &self.kind {
            AxisKind::Cases { cases, .. } => {
                let keys = cases.iter().flat_map(|case| case.set.keys());
                keys.map(String::as_str).collect()
            }
            _ => self.key.iter().map(String::as_str).collect(),
        }
    }

    /// Those of them that every value sets.
    pub(crate) fn keys_of_all_values(&self) -> Vec<&str> {
        let keys = self.keys().into_iter();
        match &self.kind {
            AxisKind::Cases { cases, .. } => {
                let is_of_all = |key: &&str| cases.iter().all(|case| case.set.contains_key(*key));
                keys.filter(is_of_all).collect()
            }
            _ => keys.collect(),
        }
    }

    /// What a value of it sets in the job.
    pub(crate) fn settings<'a>(&'a self, value: &'a Value) -> Vec<(&'a str, &'a Value)> {
        match &self.kind {
            AxisKind::Cases { names, cases } => {
                let case = names.iter().position(|name| name == value);
                let set = case.into_iter().flat_map(|i| &cases[i].set);
                set.map(|(key, value)| (key.as_str(), value)).collect()
            }
            _ => self.key.iter().map(|key| (key.as_str(), value)).collect(),
        }
    }

    /// The key path of what sets a key of the job, below the axis'.
    pub(crate) fn path_of(&self, key: &str, is_set: impl Fn(&Value) -> bool) -> Option<String> {
        match &self.kind {
            AxisKind::Cases { cases, .. } => {
                let sets = |case: &CaseSpec| case.set.get(key).is_some_and(&is_set);
                let i = cases.iter().position(sets)?;
                Some(format!("cases[{i}].set.{key}"))
            }
            _ => (self.key.as_deref() == Some(key)).then(|| "key".to_owned()),
        }
    }

    /// The value at a part of the axis, 0 to below 1.
    pub(crate) fn drawn(&self, part: f64) -> Value {
        match &self.kind {
            AxisKind::Range(range) => number(between(range, self.is_log, part), range.whole),
            AxisKind::Values(values) | AxisKind::Cases { names: values, .. } => {
                let i = (part * values.len() as f64) as usize;
                values[i.min(values.len() - 1)].clone()
            }
        }
    }
}

/// Cases with names that differ.
fn of_cases(cases: &[CaseSpec], at: &str) -> Result<AxisKind> {
    if cases.is_empty() {
        let accepted = "at least one { name, set }";
        return Err(Error::config(
            format!("{at}.cases"),
            "an empty list",
            accepted,
        ));
    }
    for (i, case) in cases.iter().enumerate() {
        let at = format!("{at}.cases[{i}].name");
        let found = format!("found {:?}", case.name);
        if case.name.trim().is_empty() {
            return Err(Error::config(at, found, "a name"));
        }
        if cases[..i].iter().any(|other| other.name == case.name) {
            return Err(Error::config(
                at,
                format!("{found} once more"),
                "names that differ",
            ));
        }
    }
    Ok(AxisKind::Cases {
        names: cases.iter().map(|case| case.name.as_str().into()).collect(),
        cases: cases.to_vec(),
    })
}

/// A key's last name, without index.
pub(crate) fn last_part(key: &str) -> String {
    let last = key.rsplit('.').next().unwrap_or(key);
    last.split('[').next().unwrap_or(last).to_owned()
}

fn list(values: &[Value], at: &str) -> Result<Vec<Value>> {
    if values.is_empty() {
        return Err(Error::config(
            format!("{at}.values"),
            "an empty list: there is nothing to run",
            "at least one value",
        ));
    }
    for (i, value) in values.iter().enumerate() {
        if let Some(first) = values[..i].iter().position(|earlier| earlier == value) {
            return Err(Error::config(
                format!("{at}.values[{i}]"),
                format!("{value}, as values[{first}]: the same run twice"),
                "every value once",
            ));
        }
    }
    Ok(values.to_vec())
}

fn of_range(range: &RangeSpec, at: &str, is_log: bool, is_drawn: bool) -> Result<AxisKind> {
    let refuse = |key: &str, found: String, accepted: &str| {
        Err(Error::config(format!("{at}{key}"), found, accepted))
    };
    if is_log && !(range.from > 0.0 && range.to > 0.0) {
        return refuse(
            "",
            format!("from {} to {}", range.from, range.to),
            "both ends above 0: their ratio is divided",
        );
    }
    if is_drawn {
        return Ok(AxisKind::Range(range.clone()));
    }
    let count = match (range.step, range.count) {
        (None, Some(0)) => {
            return refuse(
                ".count",
                "found 0: there is nothing to run".to_owned(),
                "1 or more",
            );
        }
        (None, Some(1)) if range.from != range.to => {
            return refuse(
                ".count",
                format!("found 1, between {} and {}", range.from, range.to),
                "2 or more: both ends are included",
            );
        }
        (None, Some(count)) => count as f64,
        (Some(step), None) if !is_log => {
            let steps = (range.to - range.from) / step;
            // So small a step that their number is infinite leads there, too
            if step == 0.0 || steps.is_nan() || steps < 0.0 {
                return refuse(
                    ".step",
                    format!(
                        "found {step}, which does not lead from {} to {}",
                        range.from, range.to
                    ),
                    "a step toward `to`",
                );
            }
            (steps + 1e-9).floor() + 1.0
        }
        _ if is_log => return refuse("", "no count alone".to_owned(), "{ from, to, count }"),
        (step, _) => {
            let found = step.map_or("neither step nor count", |_| "both step and count");
            let accepted = "{ from, to, step } or { from, to, count }";
            return refuse("", found.to_owned(), accepted);
        }
    };
    if count > MOST_COMBINATIONS {
        return refuse(
            "",
            format!("more than {MOST_COMBINATIONS:.0} values"),
            &format!("{MOST_COMBINATIONS:.0} at most: a larger step, or a smaller count"),
        );
    }
    let value = |i: usize| match range.step {
        Some(step) => range.from + i as f64 * step,
        None => between(range, is_log, i as f64 / (count - 1.0).max(1.0)),
    };
    let values: Vec<f64> = (0..count as usize).map(|i| neat(value(i))).collect();
    let whole = range.whole
        || [range.from, range.to]
            .iter()
            .chain(&values)
            .all(|v| v.fract() == 0.0);
    let mut values: Vec<Value> = values.into_iter().map(|v| number(v, whole)).collect();
    values.dedup();
    Ok(AxisKind::Values(values))
}

fn between(range: &RangeSpec, is_log: bool, part: f64) -> f64 {
    if is_log {
        range.from * (range.to / range.from).powf(part)
    } else {
        range.from + (range.to - range.from) * part
    }
}

/// To twelve significant digits.
fn neat(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "casts of floats saturate; no key of a job is that large"
)]
fn number(value: f64, whole: bool) -> Value {
    if whole {
        Value::from(value.round() as i64)
    } else {
        Value::from(neat(value))
    }
}

/// The points of a sweep, in the order of its table.
/// Refuses conditions that no point meets, and too many points.
pub(crate) fn points(
    axes: &[Axis],
    when: &[Condition],
    sample: Option<SampleSpec>,
    one_s: OneRun<'_>,
) -> Result<Vec<SweepPoint>> {
    let count = combinations(axes, sample, one_s)?;
    let mut sieve = Sieve::new(axes, when);
    let points = match sample {
        None => grid(axes, &mut sieve, count, one_s)?,
        Some(SampleSpec::Random(draw)) => random(axes, draw, &mut sieve)?,
        Some(SampleSpec::LatinHypercube(draw)) => {
            let mut points = Vec::new();
            for point in hypercube(axes, draw) {
                if sieve.passes(&point)? {
                    points.push(point);
                }
            }
            points
        }
    };
    if points.is_empty() {
        let found = format!("all {} points are left out: {}", sieve.seen, sieve.words());
        return Err(Error::config(
            "when",
            found,
            "conditions that some points of the axes meet",
        ));
    }
    Ok(points)
}

/// The conditions that points must meet, and how many broke which of them.
struct Sieve<'a> {
    axes: &'a [Axis],
    when: &'a [Condition],
    /// For each condition, the points that it was the first to leave out.
    left_out: Vec<usize>,
    seen: usize,
}

impl<'a> Sieve<'a> {
    fn new(axes: &'a [Axis], when: &'a [Condition]) -> Self {
        Sieve {
            axes,
            when,
            left_out: vec![0; when.len()],
            seen: 0,
        }
    }

    /// Whether a point meets all conditions, in their order: one that follows may rely on those before it.
    /// Refuses one that divides by 0 at this point: it would leave the point out without a word.
    fn passes(&mut self, point: &SweepPoint) -> Result<bool> {
        self.seen += 1;
        let value_of = |name: &str| named(self.axes, point, name);
        for (i, condition) in self.when.iter().enumerate() {
            if let Some(value) = condition.undefined(&value_of) {
                let (text, at) = (&condition.text, words(self.axes, point));
                let found = format!("a side of {text:?} is {value} at {at}: it divides by 0");
                let accepted = "a comparison of finite numbers at every point; or a condition before it that leaves such points out";
                return Err(Error::config(format!("when[{i}]"), found, accepted));
            }
            if !condition.is_met(&value_of) {
                self.left_out[i] += 1;
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Which conditions left how many points out, those that left out most first.
    fn words(&self) -> String {
        let mut counts: Vec<(usize, &str)> = (self.left_out.iter().zip(self.when))
            .filter(|(count, _)| **count > 0)
            .map(|(count, condition)| (*count, condition.text.as_str()))
            .collect();
        counts.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
        let words = counts
            .iter()
            .map(|(count, text)| format!("{count} by {text:?}"));
        words.collect::<Vec<_>>().join(", ")
    }
}

/// The values of a point, for people.
pub(crate) fn words(axes: &[Axis], point: &SweepPoint) -> String {
    let words = axes.iter().zip(&point.values);
    words
        .map(|(axis, value)| format!("{} = {}", axis.name, axis.label(value)))
        .collect::<Vec<_>>()
        .join(", ")
}

/// How many combinations there are, before any condition; refuses more than can be looked at.
fn combinations(axes: &[Axis], sample: Option<SampleSpec>, one_s: OneRun<'_>) -> Result<f64> {
    let Some((key, draw)) = sample.map(SampleSpec::drawing) else {
        let count: f64 = axes.iter().map(|axis| axis.values().len() as f64).product();
        return match count > MOST_COMBINATIONS {
            true => Err(too_many(count, one_s)),
            false => Ok(count),
        };
    };
    let key = format!("sample.{key}.count");
    match draw.count {
        0 => Err(Error::config(
            key,
            "found 0: there is nothing to run",
            "1 or more",
        )),
        count if count > MOST_RUNS => {
            let accepted = format!("{MOST_RUNS} runs at most");
            Err(Error::config(key, counted(count as f64, one_s), accepted))
        }
        count => Ok(count as f64),
    }
}

/// Seconds of one run, where its job can be run.
pub(crate) type OneRun<'a> = &'a dyn Fn() -> Option<f64>;

fn too_many(count: f64, one_s: OneRun<'_>) -> Error {
    let accepted = format!(
        "{MOST_RUNS} runs at most: fewer or shorter axes, conditions in `when`, or a [sample]"
    );
    Error::config("axes", counted(count, one_s), accepted)
}

/// So many runs, and the time they would take.
fn counted(count: f64, one_s: OneRun<'_>) -> String {
    let (more_than, count) = match count > COUNTED {
        true => ("more than ", COUNTED),
        false => ("", count),
    };
    let time = one_s().map_or_else(String::new, |one| {
        format!(" of about {}: {}", duration(one), duration(count * one))
    });
    format!("{more_than}{count:.0} runs{time}")
}

/// Larger numbers of runs are not written out.
const COUNTED: f64 = 1e12;

/// The number of an axis at a point.
pub(crate) fn named(axes: &[Axis], point: &SweepPoint, name: &str) -> Option<f64> {
    let i = axes.iter().position(|axis| axis.name == name)?;
    point.values[i].as_f64()
}

/// All combinations, the last axis fastest.
fn grid(
    axes: &[Axis],
    sieve: &mut Sieve<'_>,
    count: f64,
    one_s: OneRun<'_>,
) -> Result<Vec<SweepPoint>> {
    let counts: Vec<usize> = axes.iter().map(|axis| axis.values().len()).collect();
    let mut index = vec![0; axes.len()];
    let mut points = Vec::new();
    loop {
        let parts = index
            .iter()
            .zip(&counts)
            .map(|(&i, &n)| i as f64 / (n as f64 - 1.0).max(1.0));
        let point = SweepPoint {
            values: axes
                .iter()
                .zip(&index)
                .map(|(axis, &i)| axis.values()[i].clone())
                .collect(),
            place: parts.collect(),
            index: Some(index.clone()),
        };
        if sieve.passes(&point)? {
            points.push(point);
        }
        if points.len() > MOST_RUNS {
            return Err(too_many(count, one_s));
        }
        let Some(turn) = (0..axes.len()).rev().find(|&i| index[i] + 1 < counts[i]) else {
            return Ok(points);
        };
        index[turn] += 1;
        index[turn + 1..].fill(0);
    }
}

fn drawn(axes: &[Axis], place: Vec<f64>) -> SweepPoint {
    SweepPoint {
        values: axes
            .iter()
            .zip(&place)
            .map(|(axis, &part)| axis.drawn(part))
            .collect(),
        place,
        index: None,
    }
}

fn random(axes: &[Axis], draw: DrawSpec, sieve: &mut Sieve<'_>) -> Result<Vec<SweepPoint>> {
    let mut source = SplitMix(draw.seed);
    let mut points = Vec::with_capacity(draw.count);
    for _ in 0..draw.count.saturating_mul(TRIES) {
        if points.len() == draw.count {
            return Ok(points);
        }
        let point = drawn(axes, axes.iter().map(|_| source.part()).collect());
        if sieve.passes(&point)? {
            points.push(point);
        }
    }
    let found = format!(
        "{} draws gave {} of {} points; left out: {}",
        sieve.seen,
        points.len(),
        draw.count,
        sieve.words()
    );
    if points.len() == draw.count {
        Ok(points)
    } else {
        Err(Error::config(
            "when",
            found,
            "conditions that leave fewer points out, narrower axes, or a smaller sample.random.count",
        ))
    }
}

/// One point in each of `count` equal parts of every axis, at a random place in it, the parts of each axis in an order of their own
/// (McKay, Beckman and Conover 1979).
fn hypercube(axes: &[Axis], draw: DrawSpec) -> Vec<SweepPoint> {
    let mut source = SplitMix(draw.seed);
    let columns: Vec<Vec<f64>> = axes
        .iter()
        .map(|_| {
            let mut parts: Vec<usize> = (0..draw.count).collect();
            for i in (1..parts.len()).rev() {
                let other = (source.part() * (i + 1) as f64) as usize;
                parts.swap(i, other.min(i));
            }
            parts
                .into_iter()
                .map(|part| (part as f64 + source.part()) / draw.count as f64)
                .collect()
        })
        .collect();
    (0..draw.count)
        .map(|i| drawn(axes, columns.iter().map(|column| column[i]).collect()))
        .collect()
}

/// A value as people read it; a kind by its name, without its parameters.
#[must_use]
pub(crate) fn label(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), concise),
        Value::Object(table) if table.is_empty() => "{}".to_owned(),
        Value::Object(table) => match kind(table) {
            Some(name) => name.to_owned(),
            None => leaves(value).join(" "),
        },
        other => other.to_string(),
    }
}

/// The name of a table that is a kind with its parameters.
fn kind(table: &Map<String, Value>) -> Option<&str> {
    let (name, parameters) = table.iter().next()?;
    (table.len() == 1 && parameters.is_object()).then_some(name)
}

/// What a table and those within it hold: `KEY=VALUE`.
fn leaves(table: &Value) -> Vec<String> {
    let mut all = Vec::new();
    for (key, value) in table.as_object().into_iter().flatten() {
        match value {
            Value::Object(_) => all.extend(leaves(value)),
            _ => all.push(format!("{key}={}", label(value))),
        }
    }
    all
}

#[cfg(test)]
mod tests;
