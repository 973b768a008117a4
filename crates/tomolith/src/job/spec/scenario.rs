//! What a scenario sets otherwise: the tables of the job with its keys in place, and which of its keys an error is of.

use super::document::{is_within, put};
use super::{profiles, validate};
use crate::error::{Error, Result};
use crate::job::spec::{JobSpec, ScenarioSpec, with_example};
use crate::kind::Section;
use serde_json::{Map, Value};
use std::path::Path;

/// Tables that a scenario may change.
const TABLES: [&str; 5] = ["vial", "resin", "light", "motion", "bath"];

impl JobSpec {
    /// The same tables with some keys set otherwise; `base` is where their files begin.
    /// Refuses a key of another table, one set twice, an unknown one, and one beyond its range.
    pub(crate) fn changed(&self, set: &Map<String, Value>, base: &Path) -> Result<JobSpec> {
        let mut root = self.to_value()?;
        let mut seen: Vec<String> = Vec::new();
        for (key, value) in set {
            each_leaf(key, value, &mut |key, value| {
                let table = key.split(['.', '[']).next().unwrap_or_default();
                if !TABLES.contains(&table) {
                    let accepted = format!("a key of {}", TABLES.join(", "));
                    let found = "no key that a scenario may change";
                    return Err(Error::config(key, found, accepted));
                }
                if seen.iter().any(|other| other == key) {
                    let found = "set twice: with dots in its name, and in a table";
                    return Err(Error::config(key, found, "once"));
                }
                seen.push(key.to_owned());
                let put = put(&mut root, key, value.clone());
                put.map_err(|[found, accepted]| Error::config(key, found, accepted))?;
                Ok(())
            })?;
        }
        profiles::fill(&mut root, base, |_| false)?;
        let spec: JobSpec = Section::new("", root).parse().map_err(with_example)?;
        validate::tables(&spec)?;
        Ok(spec)
    }
}

/// Refuses scenarios that change nothing, and names that say nothing.
pub(crate) fn must_be_told_apart(spec: &JobSpec) -> Result<()> {
    let mut names = vec!["", "the job"];
    for (i, scenario) in spec.scenario.iter().enumerate() {
        if scenario.set.is_empty() {
            return Err(Error::config(
                format!("scenario[{i}].set"),
                "no key: the job once more",
                format!("keys of {}, and their values here", TABLES.join(", ")),
            ));
        }
        let Some(name) = scenario.name.as_deref() else {
            continue;
        };
        if names.contains(&name.trim()) {
            return Err(Error::config(
                format!("scenario[{i}].name"),
                format!("found \"{name}\""),
                "a name that neither the job nor another scenario has",
            ));
        }
        names.push(name.trim());
    }
    Ok(())
}

/// Names the key of a scenario that caused an error of its job; if several could have, all keys that the scenario sets.
pub(crate) fn at_scenario(i: usize, scenario: &ScenarioSpec, error: Error) -> Error {
    let Error::Config {
        key,
        found,
        accepted,
        nearest,
        ..
    } = error
    else {
        return error;
    };
    let key = key.as_str();
    let mut set = Vec::new();
    let mut remember = |key: &str, _: &Value| {
        set.push(key.to_owned());
        Ok(())
    };
    let all = scenario.set.iter();
    for (key, value) in all {
        let _ = each_leaf(key, value, &mut remember);
    }
    // The first of a list needs no index
    let same = |path: &str| path.replace("[0]", "");
    let leads =
        |set_key: &&String| is_within(&same(key), &same(set_key)) || is_within(set_key, key);
    let (suffix, found) = match (set.iter().find(leads), set.as_slice()) {
        (Some(set_key), _) if is_within(key, set_key) => (format!(".{key}"), found),
        (Some(set_key), _) => (format!(".{set_key}"), found),
        (None, _) if key.is_empty() => (String::new(), found),
        (None, [set_key]) => (format!(".{set_key}"), format!("`{key}`: {found}")),
        (None, _) => (String::new(), format!("`{key}`: {found}")),
    };
    let name = scenario.name.as_ref();
    Error::Config {
        key: format!("scenario[{i}].set{suffix}"),
        found: name.map_or_else(|| found.clone(), |name| format!("in \"{name}\", {found}")),
        accepted,
        nearest,
        place: None,
    }
}

/// Keys with dots in them and tables in tables say the same.
fn each_leaf(
    key: &str,
    value: &Value,
    with: &mut impl FnMut(&str, &Value) -> Result<()>,
) -> Result<()> {
    match value.as_object() {
        None => with(key, value),
        Some(table) => table
            .iter()
            .try_for_each(|(inner, value)| each_leaf(&format!("{key}.{inner}"), value, with)),
    }
}
