//! Errors as text: the line of the job underlined, what is accepted, the nearest name.

use crate::arguments::ColorWhen;
use crate::screen::say;
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::io::{IsTerminal, Write};
use std::sync::OnceLock;
use tomolith::Error;
use tomolith::error::{Place, key_or_file};
use tomolith::io::read_text;
use tomolith::text::printable;

/// What `--color` says.
static COLOR: OnceLock<ColorWhen> = OnceLock::new();

/// Takes what `--color` says.
pub(crate) fn set_color(when: ColorWhen) {
    let _ = COLOR.set(when);
}

fn is_colored() -> bool {
    match COLOR.get().copied().unwrap_or_default() {
        ColorWhen::Always => true,
        ColorWhen::Never => false,
        ColorWhen::Auto => {
            std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none()
        }
    }
}

/// Shows an error on standard error, or as a JSON line on standard output.
pub(crate) fn show(error: &Error, json: bool) {
    if json {
        say(&as_json(error).to_string());
        return;
    }
    let renderer = match is_colored() {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    let text = rendered(error, &renderer.decor_style(DecorStyle::Unicode));
    let _ = writeln!(std::io::stderr(), "{}", text.trim_end());
}

fn as_json(error: &Error) -> serde_json::Value {
    let mut line = serde_json::json!({ "event": "error", "message": error.to_string() });
    if let Error::Several(several) = error {
        line["errors"] = several.iter().map(as_json).collect();
    }
    if let Error::Config {
        key,
        found,
        accepted,
        nearest,
        place,
        ..
    } = error
    {
        line["key"] = key.as_str().into();
        line["found"] = found.as_str().into();
        line["accepted"] = accepted.as_str().into();
        line["nearest"] = nearest.clone().into();
        if let Some(place) = place {
            line["file"] = place.file.display().to_string().into();
            line["line"] = place.line.into();
        }
    }
    line
}

/// What is wrong, the line where it stands, and what helps.
fn rendered(error: &Error, renderer: &Renderer) -> String {
    if let Error::Several(several) = error {
        let each: Vec<String> = several
            .iter()
            .map(|error| rendered(error, renderer))
            .collect();
        return each.join("\n\n");
    }
    let Error::Config {
        key,
        found,
        accepted,
        nearest,
        place,
    } = error
    else {
        let title = printable(&error.to_string()).into_owned();
        return renderer.render(&[Group::with_title(Level::ERROR.primary_title(title))]);
    };
    let place = place.as_ref();
    let shown = place.and_then(|place| Some((place, text_of(place)?)));
    let mut title = format!("{}: {found}", key_or_file(key, place));
    if let (Some(place), None) = (place, &shown) {
        title.push_str(&format!(" ({}, line {})", place.file.display(), place.line));
    }
    let title = printable(&title);
    let mut group = Group::with_title(Level::ERROR.primary_title(&*title));
    let mut guess = nearest.as_ref().map(|n| format!("did you mean `{n}`?"));
    if let Some((place, text)) = shown {
        let label = guess.take().unwrap_or_else(|| "here".to_owned());
        let mark = AnnotationKind::Primary
            .span(place.span.clone())
            .label(label);
        let file = printable(&place.file.display().to_string()).into_owned();
        group = group.element(Snippet::source(text).path(file).annotation(mark));
    }
    let guess = guess.map_or_else(String::new, |guess| format!("{guess} "));
    let help = format!("{guess}accepted: {accepted}");
    let help = Level::HELP.message(printable(&help));
    renderer.render(&[group.element(help)])
}

/// The file that a place points into, where it still is as long as it was.
fn text_of(place: &Place) -> Option<String> {
    let text = read_text(&place.file).ok()?;
    text.get(place.span.clone()).is_some().then_some(text)
}
