//! Progress: a bar on a terminal, plain lines elsewhere, JSON lines, or nothing.

use crate::arguments::Manner;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{ErrorKind, IsTerminal, Write};
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use tomolith::job::summary::large;
use tomolith::job::{Event, Progress, Summary};
use tomolith::text::printable;

/// Plain lines: at most one iteration per this time.
const PAUSE: Duration = Duration::from_secs(2);

/// Why standard output takes no more: the first error that is not a reader who has gone.
static REFUSED: OnceLock<std::io::Error> = OnceLock::new();

/// Writes a line to standard output; a closed pipe is the reader's business. Names of parts and files steer no terminal.
pub(crate) fn say(line: &str) {
    if let Err(error) = writeln!(std::io::stdout(), "{}", printable(line))
        && error.kind() != ErrorKind::BrokenPipe
    {
        let _ = REFUSED.set(error);
    }
}

/// Tells why something that was said did not arrive; None when all of it did.
pub(crate) fn unsaid() -> Option<&'static std::io::Error> {
    REFUSED.get()
}

/// Writes a line to standard error, which nobody may be reading.
pub(crate) fn mutter(line: &str) {
    let _ = writeln!(std::io::stderr(), "{}", printable(line));
}

enum Style {
    Quiet,
    Json { is_quiet: bool },
    Plain { last: Option<Instant> },
    Bar { bar: Option<ProgressBar> },
}

/// Where progress is shown.
pub(crate) struct Screen {
    style: Style,
    start: Instant,
}

impl Screen {
    pub(crate) fn new(manner: Manner) -> Self {
        let style = match manner {
            Manner { json: true, .. } => Style::Json {
                is_quiet: manner.quiet,
            },
            Manner { quiet: true, .. } => Style::Quiet,
            _ if std::io::stderr().is_terminal() => Style::Bar { bar: None },
            _ => Style::Plain { last: None },
        };
        Screen {
            style,
            start: Instant::now(),
        }
    }

    /// Nothing but what is said elsewhere.
    pub(crate) fn silent() -> Self {
        Screen {
            style: Style::Quiet,
            start: Instant::now(),
        }
    }

    /// The end of the command.
    pub(crate) fn finish(&mut self, summary: &Summary) {
        self.clear();
        match self.style {
            Style::Json { .. } => {
                let mut line = serde_json::to_value(summary).unwrap_or_default();
                line["event"] = "done".into();
                say(&line.to_string());
            }
            Style::Quiet => {}
            Style::Plain { .. } | Style::Bar { .. } => {
                say(summary.to_string().trim_end());
                mutter(&format!(
                    "{:>12} in {:.1} s",
                    "Done",
                    self.start.elapsed().as_secs_f64()
                ));
            }
        }
    }

    fn clear(&mut self) {
        if let Style::Bar { bar } = &mut self.style
            && let Some(bar) = bar.take()
        {
            bar.finish_and_clear();
        }
    }
}

impl Progress for Screen {
    fn event(&mut self, event: &Event) {
        if !matches!(event, Event::Iteration { .. } | Event::Part { .. }) {
            self.clear();
        }
        if let (Style::Plain { last }, Event::Stage { .. }) = (&mut self.style, event) {
            *last = None;
        }
        match (&mut self.style, event) {
            (Style::Quiet | Style::Json { is_quiet: true }, _) => {}
            (Style::Json { .. }, event) => say(&serde_json::to_string(event).unwrap_or_default()),
            (_, Event::Stage { name }) => mutter(&format!(
                "{:>12} {:.1} s  {name}",
                "",
                self.start.elapsed().as_secs_f64()
            )),
            (_, Event::Note { text }) => mutter(&format!("{:>12} {text}", "")),
            (_, Event::Warning { text }) => mutter(&format!("{:>12} {text}", "warning")),
            (Style::Plain { last }, Event::Part { done, left_s }) => {
                // A short stage needs no line, and one that is over tells itself by the next
                let is_due = last.get_or_insert_with(Instant::now).elapsed() >= PAUSE;
                if let (true, Some(left)) = (is_due && *done < 1.0, left_s) {
                    *last = Some(Instant::now());
                    mutter(&format!(
                        "{:>12} {:3.0} %  {left:.0} s left",
                        "",
                        100.0 * done
                    ));
                }
            }
            (Style::Bar { bar }, Event::Part { done, left_s }) => {
                let bar =
                    bar.get_or_insert_with(|| new_bar(1000, "{bar:40} {percent:>3} %  {msg}"));
                bar.set_position((done * 1000.0) as u64);
                let left = left_s.map(|left| format!("{left:.0} s left"));
                bar.set_message(left.unwrap_or_default());
            }
            (
                Style::Bar { bar },
                Event::Iteration {
                    iteration,
                    iterations,
                    loss,
                    updates_per_s,
                    ..
                },
            ) => {
                let template = "{pos:>7}/{len} {bar:30.cyan} {msg}  eta {eta}";
                let bar = bar.get_or_insert_with(|| new_bar(*iterations as u64, template));
                bar.set_position(*iteration as u64);
                bar.set_message(format!(
                    "loss {loss:.4e}  {}updates/s",
                    large(*updates_per_s)
                ));
            }
            (
                Style::Plain { last },
                Event::Iteration {
                    iteration,
                    iterations,
                    loss,
                    projected_gradient,
                    elapsed_s,
                    updates_per_s,
                },
            ) => {
                if iteration < iterations && last.is_some_and(|last| last.elapsed() < PAUSE) {
                    return;
                }
                *last = Some(Instant::now());
                let left = elapsed_s / (*iteration).max(1) as f64 * (iterations - iteration) as f64;
                let gradient = projected_gradient.map_or("–".to_owned(), |g| format!("{g:.1e}"));
                mutter(&format!(
                    "{:>12} {iteration:>4}/{iterations}  loss {loss:.4e}  gradient {gradient}  \
                     {}updates/s  {left:.0} s left",
                    "",
                    large(*updates_per_s),
                ));
            }
        }
    }
}

pub(crate) fn new_bar(length: u64, template: &str) -> ProgressBar {
    let style =
        ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(length).with_style(style)
}

impl Drop for Screen {
    fn drop(&mut self) {
        self.clear();
    }
}
