//! What the runs of a sweep came to, collected from their folders: one row a run, as CSV and as JSON.
//!
//! Columns: `run` (counted from 1), the axes, `state` (`done`, `failed`, `missing`), the metrics, `feasible`, `error`, `folder`. Numbers are as
//! short as they can be read back exactly; what is not defined is empty.

use crate::axes::named;
use crate::metric;
use crate::plan::{RUNS, SweepPlan};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tomolith::Result;
use tomolith::io::{read_text, write_text};
use tomolith::job::RunFolder;
use tomolith::report::json::read as read_report;
use tomolith::units::counted;

/// What `table.json` says that it is.
pub const TABLE_SCHEMA: &str = "tomolith.sweep-table/1";

/// What became of a run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum State {
    /// It has its numbers.
    Done(Vec<Option<f64>>),
    /// It could not be run.
    Failed(String),
    /// It has not been run.
    Missing,
}

/// The rows of a sweep.
#[derive(Clone, Debug)]
pub(crate) struct Table<'p> {
    plan: &'p SweepPlan,
    /// One per run.
    pub(crate) states: Vec<State>,
    /// The best run: of those that are done and meet all conditions.
    pub(crate) best: Option<usize>,
}

impl<'p> Table<'p> {
    /// Reads what is in the folders of the runs.
    /// Refuses a report that cannot be read, or has no such number.
    pub(crate) fn collect(plan: &'p SweepPlan) -> Result<Self> {
        let states = (0..plan.runs.len())
            .map(|i| state(plan, i))
            .collect::<Result<Vec<_>>>()?;
        let mut table = Table {
            plan,
            states,
            best: None,
        };
        let best = &plan.sweep.best;
        let ranked = |i: usize| {
            table
                .metric(i, &best.metric)
                .map(|v| if best.is_highest { v } else { -v })
        };
        let able = (0..plan.runs.len()).filter(|&i| table.is_feasible(i));
        // The first of equal ones
        table.best = able
            .filter_map(|i| Some((i, ranked(i)?)))
            .reduce(|a, b| if b.1 > a.1 { b } else { a })
            .map(|(i, _)| i);
        Ok(table)
    }

    /// A metric of a run, where it has it.
    pub(crate) fn metric(&self, i: usize, path: &str) -> Option<f64> {
        let place = self.plan.sweep.metrics.iter().position(|m| m == path)?;
        match &self.states[i] {
            State::Done(values) => values[place],
            _ => None,
        }
    }

    /// Whether a run is done and meets every condition of the best.
    pub(crate) fn is_feasible(&self, i: usize) -> bool {
        let sweep = &self.plan.sweep;
        let value_of = |name: &str| {
            named(&sweep.axes, &self.plan.runs[i].point, name).or_else(|| self.metric(i, name))
        };
        matches!(self.states[i], State::Done(_))
            && sweep.best.conditions.iter().all(|c| c.is_met(&value_of))
    }

    /// Metrics that no run has of those that are done, and why the first of them has not.
    pub(crate) fn doubts(&self) -> Vec<String> {
        let done: Vec<usize> = (0..self.states.len())
            .filter(|&i| matches!(self.states[i], State::Done(_)))
            .collect();
        let Some(&first) = done.first() else {
            return Vec::new();
        };
        let report = read_report(&self.plan.run_folder(first)).unwrap_or_default();
        let is_empty = |path: &&String| done.iter().all(|&i| self.metric(i, path).is_none());
        let doubt = |path: &String| match metric::number(&report, path) {
            Err(why) => format!("{why}: its column is empty"),
            Ok(_) => format!("`{path}` is not defined in any run: its column is empty"),
        };
        let metrics = self.plan.sweep.metrics.iter();
        let doubts = metrics.filter(is_empty).map(doubt);
        doubts.chain(self.equals()).collect()
    }

    /// Runs that are as good as the best one.
    fn equals(&self) -> Option<String> {
        let metric = &self.plan.sweep.best.metric;
        let most = self.metric(self.best?, metric)?;
        let is_equal = |i: &usize| self.is_feasible(*i) && self.metric(*i, metric) == Some(most);
        let others = (0..self.states.len())
            .filter(is_equal)
            .count()
            .saturating_sub(1);
        (others > 0).then(|| {
            format!(
                "{} have the same {metric} as the run that is called best, which is the first of them: rank by another number, or exclude some by best.where",
                counted(others, "other run")
            )
        })
    }

    /// How many runs are done, failed, missing.
    pub(crate) fn counts(&self) -> [usize; 3] {
        let count =
            |wanted: fn(&State) -> bool| self.states.iter().filter(|state| wanted(state)).count();
        [
            count(|s| matches!(s, State::Done(_))),
            count(|s| matches!(s, State::Failed(_))),
            count(|s| matches!(s, State::Missing)),
        ]
    }

    fn csv(&self) -> String {
        let sweep = &self.plan.sweep;
        let axes = sweep.axes.iter().map(|axis| axis.name.as_str());
        let metrics = sweep.metrics.iter().map(String::as_str);
        let header = ["run"].into_iter().chain(axes).chain(["state"]);
        let header = header.chain(metrics).chain(["feasible", "error", "folder"]);
        let rows = (0..self.plan.runs.len()).map(|i| self.row(i));
        let mut text = String::new();
        for row in [header.map(field).collect()].into_iter().chain(rows) {
            text += &row.join(",");
            text.push('\n');
        }
        text
    }

    /// The fields of a run.
    fn row(&self, i: usize) -> Vec<String> {
        let run = &self.plan.runs[i];
        let (state, error) = match &self.states[i] {
            State::Done(_) => ("done", ""),
            State::Failed(message) => ("failed", message.as_str()),
            State::Missing => ("missing", ""),
        };
        let number = |path| self.metric(i, path).map(|v| v.to_string());
        let feasible = (state == "done").then(|| self.is_feasible(i).to_string());
        let mut row = vec![(i + 1).to_string()];
        row.extend(run.point.values.iter().map(value_field));
        row.push(state.to_owned());
        let metrics = self.plan.sweep.metrics.iter();
        row.extend(metrics.map(|path| number(path).unwrap_or_default()));
        row.push(feasible.unwrap_or_default());
        row.push(field(error));
        row.push(format!("{RUNS}/{}", run.id));
        row
    }

    /// The same rows with their numbers, for the page.
    fn json(&self) -> Value {
        let sweep = &self.plan.sweep;
        let row = |i: usize| {
            let run = &self.plan.runs[i];
            let (state, why) = match &self.states[i] {
                State::Done(_) => ("done", None),
                State::Failed(message) => ("failed", Some(message.as_str())),
                State::Missing => ("missing", None),
            };
            let metrics = sweep.metrics.iter().map(|path| json!(self.metric(i, path)));
            let values: Vec<Value> = run.point.values.iter().cloned().chain(metrics).collect();
            let feasible = (state == "done").then(|| self.is_feasible(i));
            json!({ "id": run.id, "values": values, "state": state, "feasible": feasible, "why": why })
        };
        let axes: Vec<&str> = sweep.axes.iter().map(|axis| axis.name.as_str()).collect();
        json!({
            "schema": TABLE_SCHEMA,
            "axes": axes,
            "metrics": sweep.metrics,
            "rows": (0..self.plan.runs.len()).map(row).collect::<Vec<_>>(),
            "best": self.best,
        })
    }

    /// Writes `table.csv` and `table.json`.
    pub(crate) fn write(&self, folder: &Path) -> Result<[PathBuf; 2]> {
        let json = format!("{:#}\n", self.json());
        let write = |(name, text): (&str, String)| {
            let path = folder.join(name);
            write_text(&path, &text)?;
            Ok(path)
        };
        Ok([
            write(("table.csv", self.csv()))?,
            write(("table.json", json))?,
        ])
    }
}

/// Where it is noted that a run failed.
pub(crate) fn failure(plan: &SweepPlan, i: usize) -> PathBuf {
    let mut path = plan.run_folder(i).into_os_string();
    path.push(".failed.json");
    path.into()
}

/// What a run's folder holds.
pub(crate) fn state(plan: &SweepPlan, i: usize) -> Result<State> {
    let folder = plan.run_folder(i);
    if RunFolder::finished(&folder).is_none() {
        let noted = read_text(failure(plan, i)).ok();
        let noted = noted.and_then(|text| serde_json::from_str::<Value>(&text).ok());
        let message = noted.and_then(|value| value["message"].as_str().map(str::to_owned));
        return Ok(message.map_or(State::Missing, State::Failed));
    }
    let report = match read_report(&folder) {
        Ok(report) => report,
        // The next call makes it anew
        Err(error) => return Ok(State::Failed(error.to_string())),
    };
    // A number that there is not is empty, as one that is not defined; Table::doubts tells of it
    let number = |path: &String| metric::number(&report, path).ok().flatten();
    Ok(State::Done(plan.sweep.metrics.iter().map(number).collect()))
}

/// An axis' value as a field.
fn value_field(value: &Value) -> String {
    match value {
        Value::Number(number) => number.as_f64().map(|v| v.to_string()).unwrap_or_default(),
        Value::String(text) => field(text),
        other => field(&other.to_string()),
    }
}

/// A field of RFC 4180. A text that spreadsheets would take for a formula begins with an apostrophe.
pub(crate) fn field(text: &str) -> String {
    let is_formula =
        text.starts_with(['=', '+', '-', '@', '\t', '\r']) && text.parse::<f64>().is_err();
    let text = if is_formula {
        format!("'{text}")
    } else {
        text.to_owned()
    };
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn no_field_is_a_formula() {
        assert_eq!(field("=1+1"), "'=1+1");
        assert_eq!(field("@SUM(1,2)"), "\"'@SUM(1,2)\"");
        assert_eq!(
            ["-1.5e-3", "+2", "a-b", ""].map(field),
            ["-1.5e-3", "+2", "a-b", ""]
        );
    }

    #[test]
    fn values_of_axes_are_as_short_as_they_can_be_read_back() {
        let values = [
            json!(0.1 + 0.2),
            json!(3.0),
            json!("a, \"b\""),
            json!([1, "x"]),
        ];
        assert_eq!(
            values.map(|value| value_field(&value)),
            [
                "0.30000000000000004",
                "3",
                "\"a, \"\"b\"\"\"",
                "\"[1,\"\"x\"\"]\""
            ]
        );
    }
}
