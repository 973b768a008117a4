//! Every row of every family's table in one list: help pages, the schema and the defaults of a resolved job come from
//! here.

use super::document::TARGETS;
use crate::error::Error;
use crate::kind::{Kind, KindPage, NumberRange};
use crate::models::MODELS;
use crate::objective::OBJECTIVES;
use crate::objective::penalty::PENALTIES;
use crate::optics::phase::PHASES;
use crate::optics::projector::PROJECTORS;
use crate::optics::vial::VIALS;
use crate::optimize::OPTIMIZERS;
use crate::optimize::start::STARTS;
use crate::response::RESPONSES;
use crate::target::PHANTOMS;
use serde_json::Value;
use std::sync::OnceLock;

/// A family of kinds, as a job names it.
pub struct KindFamily {
    /// The key in a job file: `vial`, `objective`, …
    pub name: &'static str,
    /// One sentence.
    pub summary: &'static str,
    /// Its kinds.
    pub kinds: Vec<KindPage>,
}

fn family<B>(name: &'static str, summary: &'static str, table: &[Kind<B>]) -> KindFamily {
    KindFamily {
        name,
        summary,
        kinds: table.iter().map(|kind| kind.page(name)).collect(),
    }
}

/// Every family, with the schemas of its kinds; made once.
#[must_use]
pub fn families() -> &'static [KindFamily] {
    static FAMILIES: OnceLock<Vec<KindFamily>> = OnceLock::new();
    FAMILIES.get_or_init(every_family)
}

fn every_family() -> Vec<KindFamily> {
    vec![
        family("vial", "The vial around the resin", VIALS),
        family("projector", "The optics of the projector", PROJECTORS),
        family("resin.phase", "Where scattered light goes", PHASES),
        family("model", "How light becomes dose", MODELS),
        family("objective", "What is minimized", OBJECTIVES),
        family("penalties", "Penalties on the patterns", PENALTIES),
        family(
            "optimizer",
            "The method that minimizes the objective",
            OPTIMIZERS,
        ),
        family(
            "start",
            "The patterns that the optimizer starts from",
            STARTS,
        ),
        family("response", "The material's response to the dose", RESPONSES),
        family("target.phantom", "Parts by formula", PHANTOMS),
    ]
}

/// Names of the kinds of which the table at this key path has one; none where it has no kinds.
pub(crate) fn kinds_at(path: &str) -> Vec<&'static str> {
    // `light[0].projector` → `light.projector`, `objectives[1]` → `objective`
    let steps = path.split('.').map(|step| match step.split_once('[') {
        Some(("objectives", _)) => "objective",
        Some((list, _)) => list,
        None => step,
    });
    let key = steps.collect::<Vec<_>>().join(".");
    let is_at = |name: &str| {
        key.rsplit_once(name).is_some_and(|(before, after)| {
            after.is_empty() && (before.is_empty() || before.ends_with('.'))
        })
    };
    if is_at("target") {
        return TARGETS.to_vec();
    }
    let family = families().iter().find(|family| is_at(family.name));
    let kinds = family.map_or(&[][..], |family| &family.kinds);
    kinds.iter().map(|kind| kind.name).collect()
}

/// One parameter of a kind, for help pages.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Its key.
    pub name: String,
    /// Its type in a person's words.
    pub kind: String,
    /// Its default; None when it must be given or is optional without one.
    pub default: Option<Value>,
    /// Whether it must be given.
    pub required: bool,
    /// What it means.
    pub meaning: String,
}

/// The parameters of a kind, from its schema.
#[must_use]
pub fn parameters(page: &KindPage) -> Vec<Parameter> {
    let schema = page.schema.as_value();
    parameters_of(schema, schema)
}

/// The keys of a table's schema, whose definitions are in `root`.
pub(crate) fn parameters_of(schema: &Value, root: &Value) -> Vec<Parameter> {
    let required: Vec<&str> = schema["required"]
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
        .collect();
    let properties = schema["properties"].as_object();
    properties
        .into_iter()
        .flatten()
        .map(|(name, property)| Parameter {
            name: name.clone(),
            kind: type_words(property, root),
            default: property.get("default").filter(|d| !d.is_null()).cloned(),
            required: required.contains(&name.as_str()),
            meaning: property["description"]
                .as_str()
                .unwrap_or_default()
                .replace('\n', " "),
        })
        .collect()
}

/// `section` with the defaults of its kind written in: `{cylinder: {…}}` of the family `vial`.
#[must_use]
pub fn with_defaults(pages: &[KindPage], section: &Value) -> Value {
    let mut section = section.clone();
    if let Value::String(name) = &section {
        section = serde_json::json!({ name: {} });
    }
    for page in pages {
        let Some(Value::Object(given)) = section.get_mut(page.name) else {
            continue;
        };
        for parameter in parameters(page) {
            if let Some(default) = parameter.default {
                given.entry(parameter.name).or_insert(default);
            }
        }
    }
    section
}

/// Families whose kinds together are one method, so that a key may be looked for in the wrong one of them.
const METHOD: [&str; 2] = ["optimizer", "start"];

/// Adds to the refusal of an unknown key which other kinds do have it: a filter given to a method without one, for example.
pub(crate) fn known_elsewhere(error: Error) -> Error {
    let Error::Config {
        key,
        found,
        mut accepted,
        nearest,
        place,
    } = error
    else {
        return error;
    };
    let mut names = key.rsplitn(3, '.');
    if let (Some(name), Some(kind), Some(family)) = (names.next(), names.next(), names.next())
        && found == format!("unknown name `{name}`")
    {
        let owners = owners(family, name);
        if !owners.is_empty() {
            accepted = format!("{accepted}; `{kind}` has no `{name}`, these have: {owners}");
        }
    }
    Error::Config {
        key,
        found,
        accepted,
        nearest,
        place,
    }
}

/// The kinds of a family, or of a method's two, that have a parameter of this name.
fn owners(family: &str, parameter: &str) -> String {
    let related =
        |other: &str| other == family || [family, other].iter().all(|name| METHOD.contains(name));
    let mut owners = Vec::new();
    for family in families().iter().filter(|f| related(f.name)) {
        let has = |page: &&KindPage| parameters(page).iter().any(|p| p.name == parameter);
        let kinds = family.kinds.iter().filter(has);
        owners.extend(kinds.map(|page| format!("{}.{}", family.name, page.name)));
    }
    owners.join(", ")
}

/// The type of a property in a person's words.
fn type_words(property: &Value, root: &Value) -> String {
    let mut words = type_of(property, root);
    if let Some(range) = NumberRange::of(property) {
        words = format!("{words}, {}", range.words());
    }
    words
}

fn type_of(property: &Value, root: &Value) -> String {
    if let Some(name) = property["$ref"]
        .as_str()
        .and_then(|r| r.strip_prefix("#/$defs/"))
    {
        return if name == "Length" {
            "length".to_owned()
        } else {
            type_words(&root["$defs"][name], root)
        };
    }
    if let Some(value) = property.get("const") {
        return value.to_string();
    }
    for key in ["enum", "oneOf", "anyOf"] {
        if let Some(options) = property[key].as_array() {
            let mut words: Vec<String> = options
                .iter()
                .filter(|o| o["type"] != "null")
                .map(|o| {
                    if key == "enum" {
                        o.to_string()
                    } else {
                        type_words(o, root)
                    }
                })
                .collect();
            words.dedup();
            return words.join(" | ");
        }
    }
    let word = |t: &str| match t {
        "integer" => "whole number",
        "string" => "text",
        "boolean" => "true | false",
        "array" => "list",
        "object" => "table",
        _ => "number",
    };
    let is_list = |types: &Value| match types {
        Value::Array(types) => types.iter().any(|t| t == "array"),
        one => one == "array",
    };
    match &property["type"] {
        types if is_list(types) && property["items"].is_object() => {
            format!("list of {}", type_words(&property["items"], root))
        }
        Value::String(t) => word(t).to_owned(),
        Value::Array(types) => {
            let types: Vec<&str> = types
                .iter()
                .filter_map(Value::as_str)
                .filter(|t| *t != "null")
                .collect();
            types
                .iter()
                .map(|t| word(t))
                .collect::<Vec<_>>()
                .join(" | ")
        }
        _ => "any".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
    struct Params {
        /// Radius.
        inner_radius_mm: crate::units::Mm,
        /// Steps
        /// of it.
        #[serde(default = "seven")]
        steps: usize,
        #[serde(default)]
        limit: Option<f64>,
    }

    fn seven() -> usize {
        7
    }

    fn page() -> KindPage {
        let kind = Kind {
            name: "a",
            summary: "s",
            example: "",
            schema: crate::kind::schema_of::<Params>,
            build: (),
        };
        kind.page("vial")
    }

    #[test]
    fn parameters_come_from_the_schema() {
        let found = parameters(&page());
        let row = |name: &str| found.iter().find(|p| p.name == name).unwrap();
        assert_eq!(
            (
                row("inner_radius_mm").kind.as_str(),
                row("inner_radius_mm").required
            ),
            ("length", true)
        );
        assert_eq!(row("inner_radius_mm").meaning, "Radius.");
        assert_eq!(row("steps").meaning, "Steps of it.");
        assert_eq!(
            (row("steps").kind.as_str(), row("steps").default.clone()),
            ("whole number", Some(Value::from(7)))
        );
        assert_eq!(
            (
                row("limit").kind.as_str(),
                row("limit").default.clone(),
                row("limit").required
            ),
            ("number", None, false)
        );
    }

    #[test]
    fn defaults_are_written_in_and_what_was_given_stays() {
        let full = with_defaults(
            &[page()],
            &serde_json::json!({ "a": { "inner_radius_mm": 3 } }),
        );
        assert_eq!(
            full,
            serde_json::json!({ "a": { "inner_radius_mm": 3, "steps": 7 } })
        );
        let full = with_defaults(&[page()], &serde_json::json!({ "a": { "steps": 2 } }));
        assert_eq!(full, serde_json::json!({ "a": { "steps": 2 } }));
        assert_eq!(
            with_defaults(&[page()], &serde_json::json!("a")),
            serde_json::json!({ "a": { "steps": 7 } })
        );
    }
}
