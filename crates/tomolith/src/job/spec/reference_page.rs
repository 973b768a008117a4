//! One page with every key of a job file, made from the schema: `docs/job.md`, `tomolith schema --markdown`.
//!
//! ```
//! let page = tomolith::job::reference_page::markdown();
//! assert!(page.contains("| `stop.iterations` | whole number | 45 |"));
//! ```

use super::kinds::{KindFamily, Parameter, families, parameters, parameters_of};
use crate::job::spec::{JobSpec, VialCommon};
use crate::kind::schema_of;
use crate::objective::voxel_weights::Common;
use serde_json::Value;
use std::fmt::Write as _;

const HEAD: &str = "\
# Every key of a job file

Made by `tomolith schema --markdown`; a test keeps it in step. Lengths are numbers in mm, or text with a unit (\"50 um\"). A key
with a default may be left out. Tables of one kind are written `[vial.cylinder]`, or `vial = \"cylinder\"` where every parameter
has a default. `printer` and `resin` take the numbers of a profile by its name (`resin = \"sr399-tpo\"`, or `profile = \"sr399-tpo\"` beside keys that differ): `tomolith profiles`.
";

/// A table of a job that has no kinds: `[grid]`, `[[light]]`, ….
#[derive(Clone, Debug)]
pub struct TablePage {
    /// Its key.
    pub name: String,
    /// Whether a job has a list of them.
    pub is_list: bool,
    /// One sentence.
    pub summary: String,
    /// Its keys and those of the tables in it, each with its whole path.
    pub keys: Vec<Parameter>,
}

/// The tables of a job that have no kinds, in the order of the schema.
#[must_use]
pub fn tables() -> Vec<TablePage> {
    let root = schema_of::<JobSpec>().to_value();
    let families = families();
    let mut found = Vec::new();
    for one in parameters_of(&root, &root) {
        let property = &root["properties"][&one.name];
        let is_family = families.iter().any(|f| f.name == one.name);
        // What has kinds stands apart; `objectives` is the list of `objective`
        if is_family || one.name == "objectives" {
            continue;
        }
        let Some((table, is_list)) = table_of(property, &root) else {
            continue;
        };
        let mut keys = Vec::new();
        collect(table, &root, &format!("{}.", one.name), &mut keys);
        found.push(TablePage {
            name: one.name,
            is_list,
            summary: one.meaning,
            keys,
        });
    }
    found
}

/// The page.
#[must_use]
pub fn markdown() -> String {
    let mut page = HEAD.to_owned();
    page.push_str("\n## Tables\n");
    for table in tables() {
        let (open, close) = if table.is_list {
            ("[[", "]]")
        } else {
            ("[", "]")
        };
        let _ = write!(
            page,
            "\n### `{open}{}{close}`\n\n{}\n",
            table.name, table.summary
        );
        write_rows(&mut page, &table.keys);
    }
    page.push_str("\n## Kinds\n");
    for family in families() {
        write_family(&mut page, family);
    }
    page
}

fn write_family(page: &mut String, family: &KindFamily) {
    let _ = write!(page, "\n### `{}`\n\n{}.\n", family.name, family.summary);
    if family.name == "objective" {
        let common = schema_of::<Common>().to_value();
        let mut rows = Vec::new();
        collect(&common, &common, "", &mut rows);
        page.push_str("\nKeys of every entry of `[[objectives]]`, besides its kind:\n");
        write_rows(page, &rows);
    }
    if family.name == "vial" {
        let common = schema_of::<VialCommon>().to_value();
        let mut rows = Vec::new();
        collect(&common, &common, "", &mut rows);
        page.push_str("\nKeys of `[vial]`, besides its kind:\n");
        write_rows(page, &rows);
    }
    if family.name == "penalties" {
        page.push_str(
            "\nEvery entry of `[[penalties]]` needs its `weight`, λ, besides its kind.\n",
        );
    }
    for kind in &family.kinds {
        let _ = write!(page, "\n**`{}`** {}\n", kind.name, kind.summary);
        write_rows(page, &parameters(kind));
    }
}

/// The table that a key holds, if it holds one, and whether it is a list of them.
fn table_of<'s>(property: &'s Value, root: &'s Value) -> Option<(&'s Value, bool)> {
    if let Some(name) = property["$ref"].as_str() {
        let inner = root.pointer(name.strip_prefix('#')?)?;
        return table_of(inner, root);
    }
    if property["items"].is_object() {
        return Some((table_of(&property["items"], root)?.0, true));
    }
    if let Some([one, null]) = property["anyOf"].as_array().map(Vec::as_slice)
        && null["type"] == "null"
    {
        return table_of(one, root);
    }
    property["properties"]
        .is_object()
        .then_some((property, false))
}

/// The keys of a table and of the tables in it.
fn collect(table: &Value, root: &Value, before: &str, rows: &mut Vec<Parameter>) {
    for mut one in parameters_of(table, root) {
        let property = &table["properties"][&one.name];
        one.name = format!("{before}{}", one.name);
        match table_of(property, root) {
            Some((inner, list)) => {
                let before = format!("{}{}.", one.name, if list { "[]" } else { "" });
                collect(inner, root, &before, rows);
            }
            None => {
                let name = one.name.clone();
                rows.push(one);
                choices(property, root, &name, rows);
            }
        }
    }
}

/// The keys of which a table holds one, and what is in them.
fn choices(property: &Value, root: &Value, name: &str, rows: &mut Vec<Parameter>) {
    if let Some(target) = property["$ref"].as_str() {
        let target = target.strip_prefix('#').and_then(|path| root.pointer(path));
        return choices(target.unwrap_or(&Value::Null), root, name, rows);
    }
    let either = property["anyOf"].as_array().into_iter().flatten();
    either.for_each(|one| choices(one, root, name, rows));
    for one in property["oneOf"].as_array().into_iter().flatten() {
        for mut key in parameters_of(one, root) {
            let inner = &one["properties"][&key.name];
            key.name = format!("{name}.{}", key.name);
            key.required = false;
            let meaning = one["description"].as_str().unwrap_or_default();
            key.meaning = format!("One of these. {}", meaning.replace('\n', " "));
            let before = format!("{}.", key.name);
            let table = table_of(inner, root);
            rows.push(key);
            if let Some((table, _)) = table {
                collect(table, root, &before, rows);
            }
        }
    }
}

fn write_rows(page: &mut String, rows: &[Parameter]) {
    if rows.is_empty() {
        return;
    }
    page.push_str("\n| key | type | default | meaning |\n|---|---|---|---|\n");
    for row in rows {
        let default = match &row.default {
            Some(default) => default.to_string(),
            None if row.required => "required".to_owned(),
            None => "–".to_owned(),
        };
        let cells = [&row.kind, &default, &row.meaning].map(|text| text.replace('|', "\\|"));
        let _ = writeln!(page, "| `{}` | {} |", row.name, cells.join(" | "));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn the_page_in_docs_is_the_one_of_this_program() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/job.md");
        let written = std::fs::read_to_string(path).unwrap();
        assert!(
            written == markdown(),
            "docs/job.md is stale: tomolith schema --markdown > docs/job.md"
        );
    }

    #[test]
    fn every_table_and_every_kind_has_its_keys() {
        let page = markdown();
        assert!(page.contains("`surrounding_index`"));
        let keys = [
            "grid.pitch_mm",
            "light.angles",
            "printer.canvas",
            "inner_radius_mm",
            "weights.buffer_void_mm",
        ];
        for key in keys {
            assert!(page.contains(&format!("| `{key}` |")), "{key} is missing");
        }
        let curing = "material.photopolymer.networks[].curing.threshold.critical_dose_mj_per_mm3";
        assert!(page.contains(&format!("| `{curing}` |")));
        for kind in families().iter().flat_map(|f| &f.kinds) {
            assert!(page.contains(&format!("**`{}`** ", kind.name)));
        }
    }
}
