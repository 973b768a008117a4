//! `tomolith kinds` and `tomolith schema`: the tables of the library, printed.

use crate::screen::say;
use tomolith::error::nearest_name;
use tomolith::job::kinds::{KindFamily, Parameter, families, parameters};
use tomolith::kind::KindPage;
use tomolith::{Error, Result};

/// Every kind, every kind of a family, or one kind.
pub(crate) fn kinds(family: Option<&str>, name: Option<&str>, json: bool) -> Result<()> {
    let all = families();
    let chosen: Vec<&KindFamily> = match family {
        None => all.iter().collect(),
        Some(wanted) => vec![find("family", wanted, all, |f| f.name)?],
    };
    if let (Some(wanted), [family]) = (name, chosen.as_slice()) {
        let page = find("kind", wanted, &family.kinds, |k| k.name)?;
        say(&if json {
            as_json(page).to_string()
        } else {
            full(page)
        });
        return Ok(());
    }
    if json {
        let list: Vec<_> = chosen.iter().flat_map(|f| &f.kinds).map(as_json).collect();
        say(&serde_json::Value::Array(list).to_string());
        return Ok(());
    }
    for one in chosen {
        say(&format!("{}: {}", one.name, one.summary));
        for page in &one.kinds {
            if family.is_some() {
                say(&full(page));
            } else {
                say(&format!("  {:<16} {}", page.name, page.summary));
            }
        }
        say("");
    }
    if family.is_none() {
        say(
            "`tomolith kinds FAMILY` shows the parameters, `tomolith kinds FAMILY KIND` those of one kind",
        );
    }
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

fn find<'t, T>(
    what: &str,
    wanted: &str,
    list: &'t [T],
    name: impl Fn(&T) -> &'static str,
) -> Result<&'t T> {
    list.iter().find(|one| name(one) == wanted).ok_or_else(|| {
        let names: Vec<&str> = list.iter().map(&name).collect();
        Error::Config {
            key: "kinds".to_owned(),
            found: format!("unknown {what} `{wanted}`"),
            accepted: names.join(", "),
            nearest: nearest_name(wanted, names.iter().copied()).map(str::to_owned),
            place: None,
        }
    })
}

/// A kind with its parameters and an example.
fn full(page: &KindPage) -> String {
    let mut lines = vec![String::new(), format!("  {}: {}", page.name, page.summary)];
    let rows: Vec<[String; 4]> = parameters(page)
        .iter()
        .map(|p| {
            [
                p.name.clone(),
                p.kind.clone(),
                presence(p),
                p.meaning.clone(),
            ]
        })
        .collect();
    let width = |column: usize| {
        rows.iter()
            .map(|row| row[column].chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths = [width(0), width(1), width(2)];
    for [name, kind, presence, meaning] in &rows {
        let [a, b, c] = widths;
        lines.push(format!(
            "      {name:<a$}  {kind:<b$}  {presence:<c$}  {meaning}"
        ));
    }
    lines.push(String::new());
    lines.extend(page.example.lines().map(|line| format!("      | {line}")));
    lines.join("\n")
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
