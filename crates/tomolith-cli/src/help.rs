//! `tomolith kinds` and `tomolith schema`: the tables of the library, printed.

use crate::screen::say;
use serde_json::{Value, json};
use tomolith::error::nearest_name;
use tomolith::job::kinds::{KindFamily, Parameter, families, parameters};
use tomolith::job::profiles::PROFILES;
use tomolith::job::reference_page::{TablePage, tables};
use tomolith::kind::KindPage;
use tomolith::{Error, Result};

/// Every kind and table, those of a family or table, or one kind.
pub(crate) fn kinds(family: Option<&str>, name: Option<&str>, json: bool) -> Result<()> {
    let (all, tables) = (families(), tables());
    let Some(wanted) = family else {
        let pages = all.iter().flat_map(|f| &f.kinds).map(as_json);
        match json {
            true => say(&pages.collect::<Value>().to_string()),
            false => list(all, &tables),
        }
        return Ok(());
    };
    if let Some(table) = tables.iter().find(|table| table.name == wanted) {
        if let Some(name) = name {
            return Err(Error::config(
                "kinds",
                format!("`{name}` of the table `{wanted}`, which has keys and no kinds"),
                "the name of the table alone",
            ));
        }
        say(&match json {
            true => keys_as_json(table).to_string(),
            false => keys(table),
        });
        return Ok(());
    }
    // `vial.cylinder`, as a job writes it
    let (wanted, name) = match wanted.rsplit_once('.') {
        Some((family, kind)) if name.is_none() && all.iter().any(|f| f.name == family) => {
            (family, Some(kind))
        }
        _ => (wanted, name),
    };
    let names = all
        .iter()
        .map(|f| f.name)
        .chain(tables.iter().map(|t| t.name.as_str()));
    let names: Vec<&str> = names.collect();
    let family = all.iter().find(|f| f.name == wanted);
    let family = family.ok_or_else(|| unknown("kinds", "family or table", wanted, &names))?;
    if let Some(wanted) = name {
        let names: Vec<&str> = family.kinds.iter().map(|k| k.name).collect();
        let page = family.kinds.iter().find(|k| k.name == wanted);
        let page = page.ok_or_else(|| unknown("kinds", "kind", wanted, &names))?;
        say(&match json {
            true => as_json(page).to_string(),
            false => full(page),
        });
    } else if json {
        let pages = family.kinds.iter().map(as_json);
        say(&pages.collect::<Value>().to_string());
    } else {
        say(&format!("{}: {}", family.name, family.summary));
        family.kinds.iter().for_each(|page| say(&full(page)));
        say("");
    }
    Ok(())
}

/// All families with their kinds, and all tables, a line each.
fn list(families: &[KindFamily], tables: &[TablePage]) {
    let kinds = families.iter().flat_map(|family| &family.kinds);
    let names = kinds.map(|page| page.name.len());
    let wide = names
        .chain(tables.iter().map(|table| table.name.len()))
        .max()
        .unwrap_or_default();
    for family in families {
        say(&format!("{}: {}", family.name, family.summary));
        for page in &family.kinds {
            say(&format!("  {:<wide$}  {}", page.name, page.summary));
        }
        say("");
    }
    say("Tables:");
    for table in tables {
        let summary = table.summary.split(". ").next().unwrap_or_default();
        say(&format!(
            "  {:<wide$}  {}",
            table.name,
            summary.trim_end_matches('.')
        ));
    }
    say("");
    say(
        "`tomolith kinds FAMILY` shows the parameters of its kinds, `tomolith kinds FAMILY KIND` those of one, `tomolith kinds TABLE` the keys of a table",
    );
}

fn keys(table: &TablePage) -> String {
    let (open, close) = if table.is_list {
        ("[[", "]]")
    } else {
        ("[", "]")
    };
    let title = format!("{open}{}{close}: {}", table.name, table.summary);
    format!("{title}\n\n{}\n", rows(&table.keys, 2))
}

fn keys_as_json(table: &TablePage) -> Value {
    let key = |key: &Parameter| json!({ "name": key.name, "type": key.kind, "default": key.default, "required": key.required, "meaning": key.meaning });
    let keys: Value = table.keys.iter().map(key).collect();
    json!({ "table": table.name, "is_list": table.is_list, "summary": table.summary, "keys": keys })
}

/// All profiles, a line each, or the text of one.
pub(crate) fn profiles(name: Option<&str>) -> Result<()> {
    let Some(wanted) = name else {
        for profile in PROFILES {
            let named = format!("{} = \"{}\"", profile.table, profile.name);
            say(&format!("{named:<32}  {}", profile.summary()));
        }
        say(
            "\n`tomolith profiles NAME` prints one with its source. A file NAME.toml next to a job is one, too: printer = \"NAME.toml\"",
        );
        return Ok(());
    };
    let names: Vec<&str> = PROFILES.iter().map(|profile| profile.name).collect();
    let profile = PROFILES.iter().find(|profile| profile.name == wanted);
    let profile = profile.ok_or_else(|| unknown("profiles", "profile", wanted, &names))?;
    say(profile.text.trim_end());
    Ok(())
}

/// The JSON Schema of a job, or a page of all its keys.
pub(crate) fn schema(markdown: bool) -> Result<()> {
    if markdown {
        say(tomolith::job::reference_page::markdown().trim_end());
    } else {
        say(&format!("{:#}", tomolith::job::schema::schema()));
    }
    Ok(())
}

fn unknown(command: &str, what: &str, wanted: &str, names: &[&str]) -> Error {
    Error::Config {
        key: command.to_owned(),
        found: format!("unknown {what} `{wanted}`"),
        accepted: names.join(", "),
        nearest: nearest_name(wanted, names.iter().copied()).map(str::to_owned),
        place: None,
    }
}

/// A kind with its parameters and an example.
fn full(page: &KindPage) -> String {
    let example = page.example.lines().map(|line| format!("      | {line}"));
    let example: Vec<String> = example.collect();
    let parameters = rows(&parameters(page), 6);
    format!(
        "\n  {}: {}\n{parameters}\n\n{}",
        page.name,
        page.summary,
        example.join("\n")
    )
}

/// Parameters in columns, behind so many blanks.
fn rows(parameters: &[Parameter], indent: usize) -> String {
    let rows = parameters.iter().map(|p| {
        let cells = [p.name.clone(), p.kind.clone(), presence(p)];
        (cells, p.meaning.as_str())
    });
    let rows: Vec<([String; 3], &str)> = rows.collect();
    let width = |column: usize| {
        let cells = rows.iter().map(|(cells, _)| cells[column].chars().count());
        cells.max().unwrap_or(0)
    };
    let [a, b, c] = [width(0), width(1), width(2)];
    let line = |([name, kind, presence], meaning): &([String; 3], &str)| {
        format!(
            "{:indent$}{name:<a$}  {kind:<b$}  {presence:<c$}  {meaning}",
            ""
        )
    };
    rows.iter().map(line).collect::<Vec<_>>().join("\n")
}

fn presence(parameter: &Parameter) -> String {
    match &parameter.default {
        Some(default) => format!("= {default}"),
        None if parameter.required => "required".to_owned(),
        None => "optional".to_owned(),
    }
}

fn as_json(page: &KindPage) -> serde_json::Value {
    serde_json::json!({
        "family": page.family, "name": page.name, "summary": page.summary, "example": page.example,
        "schema": page.schema.as_value(),
    })
}
