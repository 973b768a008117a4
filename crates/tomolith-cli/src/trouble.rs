//! Errors as text: the line of the job underlined, what is accepted, the nearest name.

use crate::screen::say;
use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, NamedSource, SourceCode};
use std::fmt;
use std::io::{IsTerminal, Write};
use tomolith::Error;
use tomolith::error::key_or_file;

/// Columns of a terminal that does not say.
const WIDTH: usize = 110;

/// Shows an error on standard error, or as a JSON line on standard output.
pub(crate) fn show(error: &Error, json: bool) {
    if json {
        say(&as_json(error).to_string());
        return;
    }
    let theme = if std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none() {
        GraphicalTheme::unicode()
    } else {
        GraphicalTheme::unicode_nocolor()
    };
    let handler = GraphicalReportHandler::new_themed(theme)
        .with_width(WIDTH)
        .with_context_lines(1);
    let mut text = String::new();
    if handler
        .render_report(&mut text, &Trouble::new(error))
        .is_err()
    {
        text = error.to_string();
    }
    let _ = writeln!(std::io::stderr(), "{}", text.trim_end());
}

fn as_json(error: &Error) -> serde_json::Value {
    let mut line = serde_json::json!({ "event": "error", "message": error.to_string() });
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

/// An error with the text it points into.
#[derive(Debug)]
struct Trouble<'e> {
    error: &'e Error,
    source: Option<NamedSource<String>>,
}

impl<'e> Trouble<'e> {
    fn new(error: &'e Error) -> Self {
        let source = match error {
            Error::Config {
                place: Some(place), ..
            } => std::fs::read_to_string(&place.file)
                .ok()
                .filter(|text| place.span.end <= text.len())
                .map(|text| NamedSource::new(place.file.display().to_string(), text)),
            _ => None,
        };
        Trouble { error, source }
    }
}

impl fmt::Display for Trouble<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.error {
            Error::Config {
                key, found, place, ..
            } => {
                f.write_str(key_or_file(key, place.as_ref()))?;
                write!(f, ": {found}")?;
                match place {
                    Some(place) => write!(f, " ({}, line {})", place.file.display(), place.line),
                    None => Ok(()),
                }
            }
            other => other.fmt(f),
        }
    }
}

impl std::error::Error for Trouble<'_> {}

impl miette::Diagnostic for Trouble<'_> {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        match self.error {
            Error::Config {
                accepted, nearest, ..
            } => {
                let guess = nearest
                    .as_ref()
                    .map(|n| format!("did you mean `{n}`? "))
                    .unwrap_or_default();
                Some(Box::new(format!("{guess}accepted: {accepted}")))
            }
            _ => None,
        }
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.source.as_ref().map(|source| source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let Error::Config {
            place: Some(place),
            nearest,
            ..
        } = self.error
        else {
            return None;
        };
        let text = nearest
            .as_ref()
            .map_or("here".to_owned(), |name| format!("did you mean `{name}`?"));
        let span = (place.span.start, place.span.len());
        Some(Box::new(std::iter::once(LabeledSpan::new_with_span(
            Some(text),
            span,
        ))))
    }
}
