//! `[co_optimize]`: parameters of the response that are found together with the patterns.
//!
//! Any parameter of `[response.KIND]` that is a number can be one. Trials read the response's own table with other values in it, so that what a kind
//! accepts is stated in one place: the kind's. The method is in [`free_response`](crate::optimize::free_response).

use super::goal::{Goal, response};
use super::method::Method;
use crate::error::{Error, Result};
use crate::field::Field;
use crate::job::spec::JobSpec;
use crate::job::spec::kinds::parameters;
use crate::kind::Section;
use crate::objective::{Objective, Sum};
use crate::optimize::{FreeParameter, FreeResponse};
use crate::report::number::significant;
use crate::response::{RESPONSES, Response};
use crate::units::exact;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;

/// The table's key.
const TABLE: &str = "co_optimize";

/// The unknown parameters of a job's response.
#[derive(Clone, Debug)]
pub(crate) struct FreeParameters {
    /// `response.KIND` with the parameters as the job has them.
    section: Section,
    /// The kind's name.
    kind: &'static str,
    parameters: Vec<FreeParameter>,
    tolerance: f64,
}

/// A response that was found.
#[derive(Clone, Debug)]
pub(crate) struct FoundResponse {
    pub(crate) values: Vec<(String, f64)>,
    pub(crate) response: Arc<dyn Response>,
}

impl FreeParameters {
    /// Those of a job; None where it has none.
    /// Refuses a parameter that the response does not have, and a range that is none or that it does not accept.
    pub(crate) fn of(spec: &JobSpec, base: &Path) -> Result<Option<Self>> {
        let Some(given) = &spec.co_optimize else {
            return Ok(None);
        };
        let section = Section::new("response", spec.response.clone()).based(base);
        let (row, section) = section.kind(RESPONSES)?;
        let known = parameters(&row.page("response"));
        // The words of a number are followed by those of its range
        let is_number = |kind: &str| kind.split(',').next() == Some("number");
        let known = known.iter().filter(|p| is_number(&p.kind));
        let known: Vec<(&str, Option<f64>)> = known
            .map(|p| (p.name.as_str(), p.default.as_ref().and_then(Value::as_f64)))
            .collect();
        let mut found = Vec::with_capacity(given.response.len());
        for (name, range) in &given.response {
            let Some((_, default)) = known.iter().find(|(known, _)| known == name) else {
                return Err(no_such(row.name, name, &known));
            };
            let start = section.value.get(name).and_then(Value::as_f64).or(*default);
            found.push(FreeParameter {
                name: name.clone(),
                range: *range,
                start: start.unwrap_or(range[0]),
            });
        }
        let free = FreeParameters {
            section,
            kind: row.name,
            parameters: found,
            tolerance: given.tolerance,
        };
        free.must_be_ranges()?;
        Ok(Some(free))
    }

    /// Refuses ranges that are none, or that the response does not accept.
    fn must_be_ranges(&self) -> Result<()> {
        for parameter in &self.parameters {
            let checked = parameter.validate();
            checked.map_err(|e| e.under("response").under(TABLE))?;
        }
        // What a response accepts of one parameter may depend on another: all ends of all ranges
        for ends in 0..1usize << self.parameters.len() {
            let value = |(i, p): (usize, &FreeParameter)| p.range[ends >> i & 1];
            let values: Vec<f64> = self.parameters.iter().enumerate().map(value).collect();
            self.respond(&values).map_err(|e| self.at_range(e))?;
        }
        Ok(())
    }

    /// Blames the range of a parameter that the response blames.
    fn at_range(&self, mut error: Error) -> Error {
        if let Error::Config { key, found, .. } = &mut error {
            let name = key.rsplit('.').next().unwrap_or_default();
            let parameter = self.parameters.iter().find(|p| p.name == name);
            let name = parameter.map_or(String::new(), |p| format!(".{}", p.name));
            *key = format!("{TABLE}.response{name}");
            *found = format!("at an end of the ranges: {found}");
        }
        error
    }

    pub(crate) fn respond(&self, values: &[f64]) -> Result<Arc<dyn Response>> {
        let mut parameters = self.section.value.clone();
        for (parameter, value) in self.parameters.iter().zip(values) {
            parameters[&parameter.name] = (*value).into();
        }
        let tables = Section::new("response", serde_json::json!({ self.kind: parameters }));
        response(&tables)
    }

    /// An objective whose response has these unknowns.
    pub(crate) fn objective<F: Field>(&self, sum: Sum<F>) -> Result<FreeResponse<'_, F>> {
        let objective: Box<dyn Objective<F>> = Box::new(sum);
        let respond = Box::new(|values: &[f64]| self.respond(values));
        FreeResponse::new(objective, self.parameters.clone(), respond, self.tolerance)
            .map_err(|e| e.under(TABLE))
    }

    /// The response that an optimization found; None where it found none.
    pub(crate) fn found(&self, values: &[f64]) -> Result<Option<FoundResponse>> {
        if values.len() != self.parameters.len() {
            return Ok(None);
        }
        let names = self.parameters.iter().map(|p| p.name.clone());
        Ok(Some(FoundResponse {
            values: names.zip(values.iter().copied()).collect(),
            response: self.respond(values)?,
        }))
    }

    /// The response that the run whose `report.json` this is found; None where it has no such parameters.
    pub(crate) fn found_by(&self, report: &Value) -> Result<Option<FoundResponse>> {
        let parameters = self.parameters.iter();
        let values = parameters.map(|p| report["response"][&p.name].as_f64());
        match values.collect::<Option<Vec<f64>>>() {
            Some(values) => self.found(&values),
            None => Ok(None),
        }
    }

    /// That a parameter was found at an end of its range: the best one may lie beyond.
    pub(crate) fn at_ends(&self, found: &FoundResponse) -> Vec<String> {
        let pairs = self.parameters.iter().zip(&found.values);
        let at_end = pairs.filter(|(p, (_, value))| p.range.contains(value));
        at_end
            .map(|(p, (name, value))| {
                format!(
                    "co_optimize.response.{name}: the best value found is an end of the range, {}; a wider range than {} to {} may do better",
                    exact(*value),
                    exact(p.range[0]),
                    exact(p.range[1])
                )
            })
            .collect()
    }
}

impl FoundResponse {
    pub(crate) fn sentence(&self) -> String {
        let word = |(name, value): &(String, f64)| format!("{name} {}", significant(*value, 4));
        let words: Vec<String> = self.values.iter().map(word).collect();
        words.join(", ")
    }

    /// The parameters as lines of a job, each after `#`.
    pub(crate) fn comments(&self, free: &FreeParameters) -> String {
        let line = |(name, value): &(String, f64)| {
            format!(
                "# Found with the patterns: response.{}.{name} = {value}\n",
                free.kind
            )
        };
        self.values.iter().map(line).collect()
    }
}

/// A parameter that the response does not have.
fn no_such(kind: &str, name: &str, known: &[(&str, Option<f64>)]) -> Error {
    let names = || known.iter().map(|(name, _)| *name);
    Error::Config {
        key: format!("{TABLE}.response.{name}"),
        found: format!("[response.{kind}] has no parameter `{name}` that is a number"),
        accepted: if known.is_empty() {
            "a response with such parameters, as [response.logistic] (steepness, midpoint, …)"
                .to_owned()
        } else {
            names().collect::<Vec<_>>().join(", ")
        },
        nearest: crate::error::nearest_name(name, names()).map(str::to_owned),
        place: None,
    }
}

/// Refuses methods and objectives that a response that moves does not reach.
pub(crate) fn must_be_minimized(goal: &Goal, method: &Method) -> Result<()> {
    if method.free.is_none() {
        return Ok(());
    }
    if method.normalizes || method.needs_target() {
        return Err(Error::config(
            TABLE,
            format!(
                "optimizer.{} follows a rule of its own and not the loss, which tells how good a response is",
                method.name()
            ),
            "a method that descends the loss: lbfgs, gradient, adam, bclp",
        ));
    }
    let objective = goal.common().find(|(_, common)| common.response.is_some());
    match objective {
        Some((path, _)) => Err(Error::config(
            format!("{path}.response"),
            "an objective with a response, in a job with [co_optimize], which changes the response of the job",
            "only one of the two",
        )),
        None => Ok(()),
    }
}
