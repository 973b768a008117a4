//! The JSON Schema of a whole job, with the parameters of every kind of every family.
//!
//! ```
//! let schema = tomolith::job::schema::schema();
//! assert!(schema["properties"]["stop"].is_object());
//! ```

use super::kinds::{KindFamily, families};
use super::profiles::{PROFILES, TABLES};
use crate::job::spec::{JobSpec, VialCommon};
use crate::kind::{KindPage, schema_of};
use crate::objective::voxel_weights::Common;
use serde_json::{Map, Value, json};

/// The schema of a job file.
#[must_use]
pub fn schema() -> Value {
    let mut root = schema_of::<JobSpec>().to_value();
    root["title"] = json!("Tomolith job");
    let mut definitions = root["$defs"].as_object().cloned().unwrap_or_default();
    for family in families() {
        let description = root["properties"][family.name]["description"].clone();
        let mut options = one_of(family, &mut definitions);
        if !description.is_null() {
            options["description"] = description;
        }
        match family.name {
            "projector" => drop(definitions.insert("ProjectorSpec".to_owned(), options)),
            "target.phantom" => {
                definitions["TargetSpec"]["properties"]["phantom"] = options;
            }
            "resin.phase" => definitions["ResinSpec"]["properties"]["phase"] = options,
            "vial" => drop(definitions.insert("VialSpec".to_owned(), options)),
            "objective" => {
                root["properties"]["objectives"]["items"] = options.clone();
                root["properties"]["objective"] = options;
            }
            "penalties" => root["properties"]["penalties"]["items"] = options,
            name => root["properties"][name] = options,
        }
    }
    for (table, definition) in TABLES.into_iter().zip(["PrinterSpec", "ResinSpec"]) {
        let names = PROFILES.iter().filter(|profile| profile.table == table);
        let names: Vec<&str> = names.map(|profile| profile.name).collect();
        let words = format!("A profile: {}, or a file NAME.toml", names.join(", "));
        let profile = json!({ "type": "string", "description": words, "examples": names });
        definitions[definition]["properties"]["profile"] = profile.clone();
        let description = root["properties"][table]["description"].clone();
        root["properties"][table] = json!({
            "description": description, "anyOf": [profile, { "$ref": format!("#/$defs/{definition}") }],
        });
    }
    root["$defs"] = Value::Object(definitions);
    root
}

/// Exactly one kind of a family, as an externally tagged table.
fn one_of(family: &KindFamily, definitions: &mut Map<String, Value>) -> Value {
    let tables = family
        .kinds
        .iter()
        .map(|page| {
            let prefix = format!("{}_{}_", page.family, page.name);
            let mut schema = page.schema.clone().to_value();
            if let Some(map) = schema.as_object_mut() {
                map.remove("$schema");
                map.remove("title");
                map.insert("description".to_owned(), json!(page.summary));
                if let Some(Value::Object(inner)) = map.remove("$defs") {
                    for (name, mut definition) in inner {
                        rename(&mut definition, &prefix);
                        definitions.insert(format!("{prefix}{name}"), definition);
                    }
                }
            }
            rename(&mut schema, &prefix);
            let mut properties = Map::new();
            match family.name {
                "vial" => {
                    let common = schema_of::<VialCommon>().to_value();
                    properties.extend(common_properties(common, "vial_", definitions));
                }
                "objective" => {
                    let common = schema_of::<Common>().to_value();
                    properties.extend(common_properties(common, "objectives_", definitions));
                }
                "penalties" => drop(properties.insert("weight".to_owned(), json!({ "type": "number" }))),
                _ => {}
            }
            properties.insert(page.name.to_owned(), schema);
            json!({
                "type": "object", "properties": properties, "required": [page.name], "additionalProperties": false
            })
        });
    // A kind whose parameters all have defaults may be written as text
    let has_defaults = |page: &&KindPage| page.schema.get("required").is_none();
    let names: Vec<&str> = family
        .kinds
        .iter()
        .filter(has_defaults)
        .map(|page| page.name)
        .collect();
    let text = (!names.is_empty()).then(|| json!({ "type": "string", "enum": names }));
    json!({ "oneOf": tables.chain(text).collect::<Vec<_>>() })
}

/// What every kind of a family may have besides its own keys; its definitions move to the job's, under a prefix.
fn common_properties(
    mut schema: Value,
    prefix: &str,
    definitions: &mut Map<String, Value>,
) -> Map<String, Value> {
    for (name, mut definition) in schema["$defs"].as_object().cloned().unwrap_or_default() {
        rename(&mut definition, prefix);
        definitions.insert(format!("{prefix}{name}"), definition);
    }
    let mut properties = schema["properties"].take();
    rename(&mut properties, prefix);
    properties.as_object().cloned().unwrap_or_default()
}

/// References of a kind's own schema, moved to the job's definitions.
fn rename(schema: &mut Value, prefix: &str) {
    match schema {
        Value::Object(map) => {
            for (key, value) in map.iter_mut() {
                match value {
                    Value::String(reference) if key == "$ref" => {
                        if let Some(name) = reference.strip_prefix("#/$defs/") {
                            *reference = format!("#/$defs/{prefix}{name}");
                        }
                    }
                    other => rename(other, prefix),
                }
            }
        }
        Value::Array(list) => list.iter_mut().for_each(|value| rename(value, prefix)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn references(schema: &Value, found: &mut Vec<String>) {
        match schema {
            Value::Object(map) => {
                if let Some(Value::String(reference)) = map.get("$ref") {
                    found.push(reference.clone());
                }
                map.values().for_each(|value| references(value, found));
            }
            Value::Array(list) => list.iter().for_each(|value| references(value, found)),
            _ => {}
        }
    }

    #[test]
    fn every_kind_is_in_and_every_reference_leads_somewhere() {
        let schema = schema();
        let text = schema.to_string();
        for family in families() {
            for page in &family.kinds {
                assert!(
                    text.contains(&format!("\"required\":[\"{}\"]", page.name)),
                    "{} is missing",
                    page.name
                );
            }
        }
        let mut found = Vec::new();
        references(&schema, &mut found);
        assert!(!found.is_empty());
        for reference in found {
            let path = reference.strip_prefix('#').unwrap();
            assert!(schema.pointer(path).is_some(), "{reference} leads nowhere");
        }
    }
}
