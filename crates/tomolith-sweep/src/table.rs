//! What the runs of a sweep came to, collected from their folders: one row a run, as CSV and as Parquet.
//!
//! Columns: `run` (counted from 1), the axes, `state` (`done`, `failed`, `missing`), the metrics, `feasible`, `error`, `folder`. Numbers are as
//! short as they can be read back exactly; what is not defined is empty (null in Parquet).

use crate::axes::named;
use crate::metric;
use crate::plan::{RUNS, SweepPlan};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tomolith::io::whole::Refused;
use tomolith::io::{read_text, write_whole};
use tomolith::job::RunFolder;
use tomolith::report::SCHEMA;
use tomolith::{Error, Result};

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

/// A column's content.
enum Column {
    Number(Vec<Option<f64>>),
    Count(Vec<i64>),
    Flag(Vec<Option<bool>>),
    Text(Vec<Option<String>>),
}

impl<'p> Table<'p> {
    /// Reads what is in the folders of the runs.
    ///
    /// # Errors
    /// [`Error::Format`] for a report that cannot be read, or has no such number.
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
        let of = |name: &str| {
            named(&sweep.axes, &self.plan.runs[i].point, name).or_else(|| self.metric(i, name))
        };
        matches!(self.states[i], State::Done(_))
            && sweep.best.conditions.iter().all(|c| c.is_met(&of))
    }

    /// Metrics that no run has of those that are done, and why the first of them has not.
    pub(crate) fn doubts(&self) -> Vec<String> {
        let done: Vec<usize> = (0..self.states.len())
            .filter(|&i| matches!(self.states[i], State::Done(_)))
            .collect();
        let Some(&first) = done.first() else {
            return Vec::new();
        };
        let report = report(&self.plan.run_folder(first)).unwrap_or_default();
        let is_empty = |path: &&String| done.iter().all(|&i| self.metric(i, path).is_none());
        let doubt = |path: &String| match metric::number(&report, path) {
            Err(why) => format!("{why}: its column is empty"),
            Ok(_) => format!("`{path}` is not defined in any run: its column is empty"),
        };
        let metrics = self.plan.sweep.metrics.iter();
        metrics.filter(is_empty).map(doubt).collect()
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

    fn columns(&self) -> Vec<(String, Column)> {
        let (plan, runs) = (self.plan, self.plan.runs.len());
        let mut columns = vec![("run".to_owned(), Column::Count((1..=runs as i64).collect()))];
        for (a, axis) in plan.sweep.axes.iter().enumerate() {
            let values = || plan.runs.iter().map(|run| &run.point.values[a]);
            let column = if values().all(Value::is_number) {
                Column::Number(values().map(Value::as_f64).collect())
            } else {
                let text = |value: &Value| {
                    value
                        .as_str()
                        .map_or_else(|| value.to_string(), str::to_owned)
                };
                Column::Text(values().map(|v| Some(text(v))).collect())
            };
            columns.push((axis.name.clone(), column));
        }
        let words = self.states.iter().map(|state| match state {
            State::Done(_) => "done",
            State::Failed(_) => "failed",
            State::Missing => "missing",
        });
        columns.push((
            "state".to_owned(),
            Column::Text(words.map(|w| Some(w.to_owned())).collect()),
        ));
        for path in &plan.sweep.metrics {
            columns.push((
                path.clone(),
                Column::Number((0..runs).map(|i| self.metric(i, path)).collect()),
            ));
        }
        let is_done = |i: usize| matches!(self.states[i], State::Done(_));
        let feasible = (0..runs).map(|i| is_done(i).then(|| self.is_feasible(i)));
        columns.push(("feasible".to_owned(), Column::Flag(feasible.collect())));
        let errors = self.states.iter().map(|state| match state {
            State::Failed(message) => Some(message.clone()),
            _ => None,
        });
        columns.push(("error".to_owned(), Column::Text(errors.collect())));
        let folders = plan
            .runs
            .iter()
            .map(|run| Some(format!("{RUNS}/{}", run.id)));
        columns.push(("folder".to_owned(), Column::Text(folders.collect())));
        columns
    }

    /// Writes `table.csv` and `table.parquet`.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub(crate) fn write(&self, folder: &Path) -> Result<Vec<PathBuf>> {
        let columns = self.columns();
        let files = [folder.join("table.csv"), folder.join("table.parquet")];
        write_whole(&files[0], |file| {
            Ok(file.write_all(csv(&columns).as_bytes())?)
        })?;
        write_whole(&files[1], |file| {
            write_parquet(file, &columns).map_err(|e| Refused::Io(std::io::Error::other(e)))
        })?;
        Ok(files.to_vec())
    }
}

/// Where it is noted that a run failed.
pub(crate) fn failure(plan: &SweepPlan, i: usize) -> PathBuf {
    let mut path = plan.run_folder(i).into_os_string();
    path.push(".failed.json");
    path.into()
}

/// The report of a run.
///
/// # Errors
/// [`Error::Io`]; [`Error::Format`] for one that is none.
pub(crate) fn report(folder: &Path) -> Result<Value> {
    let path = folder.join("report.json");
    let text = read_text(&path)?;
    let refused = |found: String| Error::Format {
        path: path.clone(),
        found,
        accepted: "the report of a run".to_owned(),
    };
    let report: Value = serde_json::from_str(&text).map_err(|e| refused(e.to_string()))?;
    match report["schema"].as_str() {
        Some(SCHEMA) => Ok(report),
        Some(other) => Err(refused(format!("a report of the schema {other}"))),
        None => Err(refused("no report".to_owned())),
    }
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
    let report = match report(&folder) {
        Ok(report) => report,
        // The next call makes it anew
        Err(error) => return Ok(State::Failed(error.to_string())),
    };
    // A number that there is not is empty, as one that is not defined; Table::doubts tells of it
    let number = |path: &String| metric::number(&report, path).ok().flatten();
    Ok(State::Done(plan.sweep.metrics.iter().map(number).collect()))
}

fn csv(columns: &[(String, Column)]) -> String {
    let mut text = columns
        .iter()
        .map(|(name, _)| field(name))
        .collect::<Vec<_>>()
        .join(",");
    text.push('\n');
    let rows = columns.first().map_or(0, |(_, column)| column.len());
    for i in 0..rows {
        let line: Vec<String> = columns.iter().map(|(_, column)| column.text(i)).collect();
        text.push_str(&line.join(","));
        text.push('\n');
    }
    text
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

impl Column {
    fn len(&self) -> usize {
        match self {
            Column::Number(values) => values.len(),
            Column::Count(values) => values.len(),
            Column::Flag(values) => values.len(),
            Column::Text(values) => values.len(),
        }
    }

    fn text(&self, i: usize) -> String {
        match self {
            Column::Number(values) => values[i].map(|v| v.to_string()).unwrap_or_default(),
            Column::Count(values) => values[i].to_string(),
            Column::Flag(values) => values[i].map(|v| v.to_string()).unwrap_or_default(),
            Column::Text(values) => values[i].as_deref().map(field).unwrap_or_default(),
        }
    }

    fn field(&self, name: &str) -> Result<Type, ParquetError> {
        let (physical, logical, repetition) = match self {
            Column::Number(_) => (Physical::DOUBLE, None, Repetition::OPTIONAL),
            Column::Count(_) => (Physical::INT64, None, Repetition::REQUIRED),
            Column::Flag(_) => (Physical::BOOLEAN, None, Repetition::OPTIONAL),
            Column::Text(_) => (
                Physical::BYTE_ARRAY,
                Some(LogicalType::String),
                Repetition::OPTIONAL,
            ),
        };
        Type::primitive_type_builder(name, physical)
            .with_repetition(repetition)
            .with_logical_type(logical)
            .build()
    }
}

fn write_parquet<W: Write + Send>(
    file: W,
    columns: &[(String, Column)],
) -> Result<(), ParquetError> {
    let fields = columns
        .iter()
        .map(|(name, column)| column.field(name).map(Arc::new))
        .collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("sweep")
        .with_fields(fields)
        .build()?;
    let mut writer =
        SerializedFileWriter::new(file, Arc::new(schema), Arc::new(WriterProperties::new()))?;
    let mut group = writer.next_row_group()?;
    for (_, column) in columns {
        match column {
            Column::Number(values) => put::<DoubleType, _>(&mut group, values)?,
            Column::Count(values) => put::<Int64Type, _>(
                &mut group,
                &values.iter().copied().map(Some).collect::<Vec<_>>(),
            )?,
            Column::Flag(values) => put::<BoolType, _>(&mut group, values)?,
            Column::Text(values) => {
                let bytes: Vec<_> = values
                    .iter()
                    .map(|v| v.as_deref().map(ByteArray::from))
                    .collect();
                put::<ByteArrayType, _>(&mut group, &bytes)?;
            }
        }
    }
    group.close()?;
    writer.close()?;
    Ok(())
}

/// Writes the next column: the values that are there, and which are.
fn put<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[Option<T::T>],
) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else {
        return Err(ParquetError::General(
            "more columns than the schema has".to_owned(),
        ));
    };
    let levels: Vec<i16> = values.iter().map(|v| i16::from(v.is_some())).collect();
    let there: Vec<T::T> = values.iter().flatten().cloned().collect();
    column
        .typed::<T>()
        .write_batch(&there, Some(&levels), None)?;
    column.close()
}

#[cfg(test)]
mod tests {
    use super::*;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;

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
    fn both_tables_hold_the_same() {
        let columns = [
            ("run".to_owned(), Column::Count(vec![1, 2])),
            (
                "evaluation.pw".to_owned(),
                Column::Number(vec![Some(0.1 + 0.2), None]),
            ),
            ("feasible".to_owned(), Column::Flag(vec![Some(true), None])),
            (
                "error".to_owned(),
                Column::Text(vec![None, Some("a, \"b\"".to_owned())]),
            ),
        ];
        assert_eq!(
            csv(&columns),
            "run,evaluation.pw,feasible,error\n1,0.30000000000000004,true,\n2,,,\"a, \"\"b\"\"\"\n"
        );
        let temp = tempfile::tempdir().unwrap();
        let path = temp.path().join("t.parquet");
        write_parquet(std::fs::File::create(&path).unwrap(), &columns).unwrap();
        let reader = SerializedFileReader::new(std::fs::File::open(&path).unwrap()).unwrap();
        let rows: Vec<_> = reader
            .get_row_iter(None)
            .unwrap()
            .map(Result::unwrap)
            .collect();
        assert_eq!(
            (
                rows[0].get_long(0).unwrap(),
                rows[0].get_double(1).unwrap(),
                rows[0].get_bool(2).unwrap()
            ),
            (1, 0.1 + 0.2, true)
        );
        assert!(rows[1].get_double(1).is_err() && rows[0].get_string(3).is_err());
        assert_eq!(rows[1].get_string(3).unwrap(), "a, \"b\"");
    }
}
