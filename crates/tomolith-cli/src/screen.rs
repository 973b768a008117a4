//! Progress: a bar on a terminal, plain lines elsewhere, JSON lines, or nothing.

use crate::arguments::Manner;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::io::{ErrorKind, IsTerminal, Write};
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use tomolith::job::summary::large;
use tomolith::job::{Event, Progress, Summary};
use tomolith::text::printable;

/// Plain lines: at most one in this time, for every tenth of a stage, or after so long without one.
const PAUSE: Duration = Duration::from_secs(2);
const TENTH: f64 = 0.1;
const SILENCE: Duration = Duration::from_secs(60);

/// Why standard output takes no more: the first error that is not a reader who has gone.
static REFUSED: OnceLock<std::io::Error> = OnceLock::new();

/// Writes a line to standard output; a closed pipe is the reader's business. Names of parts and files steer no terminal.
pub(crate) fn say(line: &str) {
    take(writeln!(std::io::stdout(), "{}", printable(line)));
}

/// Notes why standard output took no more.
pub(crate) fn take(written: std::io::Result<()>) {
    if let Err(error) = written
        && error.kind() != ErrorKind::BrokenPipe
    {
        let _ = REFUSED.set(error);
    }
}

/// Why some of the output did not reach the screen; None when all of it did.
pub(crate) fn unsaid() -> Option<&'static std::io::Error> {
    REFUSED.get()
}

/// Writes a line to standard error, which nobody may be reading.
pub(crate) fn mutter(line: &str) {
    let _ = writeln!(std::io::stderr(), "{}", printable(line));
}

/// The end of a command: what it found as a line of JSON, or in words, or nothing.
pub(crate) fn done(manner: Manner, found: impl Serialize, words: impl FnOnce()) {
    if manner.json {
        say_json(found);
    } else if !manner.quiet {
        words();
    }
}

fn say_json(found: impl Serialize) {
    let mut line = serde_json::to_value(found).unwrap_or_default();
    line["event"] = "done".into();
    say(&line.to_string());
}

enum Style {
    Quiet,
    Json { is_quiet: bool },
    Plain { last: Option<Line> },
    Bar { bar: Option<ProgressBar> },
}

/// A plain line: when it was written, and how much of the stage was done.
#[derive(Clone, Copy)]
struct Line {
    at: Instant,
    done: f64,
}

impl Line {
    fn now(done: f64) -> Self {
        Line {
            at: Instant::now(),
            done,
        }
    }

    /// Whether another line is worth writing, so that the log of a long run stays short.
    fn is_old(self, done: f64) -> bool {
        let age = self.at.elapsed();
        age >= SILENCE || age >= PAUSE && done >= self.done + TENTH
    }
}

/// Where progress is shown.
pub(crate) struct Screen {
    style: Style,
    start: Instant,
    /// The first iteration of the stage that was shown, and its time: what is left is reckoned from there.
    first: Option<(usize, f64)>,
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
            first: None,
        }
    }

    /// No lines of progress.
    pub(crate) fn silent() -> Self {
        Screen {
            style: Style::Quiet,
            start: Instant::now(),
            first: None,
        }
    }

    /// The end of the command.
    pub(crate) fn finish(&mut self, summary: &Summary) {
        self.clear();
        match self.style {
            Style::Json { .. } => say_json(summary),
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

    /// Time that the rest of the iterations takes at the mean pace since the first one, s; None before there is one.
    fn left_s(&mut self, event: &Event) -> Option<f64> {
        let Event::Iteration {
            iteration,
            iterations,
            elapsed_s,
            ..
        } = event
        else {
            if matches!(event, Event::Stage { .. }) {
                self.first = None;
            }
            return None;
        };
        let (first, begin_s) = *self.first.get_or_insert((*iteration, *elapsed_s));
        let pace = (elapsed_s - begin_s) / iteration.checked_sub(first).filter(|n| *n > 0)? as f64;
        Some(pace * iterations.saturating_sub(*iteration) as f64)
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
        let left = self.left_s(event);
        let left = left.map_or_else(String::new, |left| format!("  {left:.0} s left"));
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
                let is_due = last.get_or_insert_with(|| Line::now(0.0)).is_old(*done);
                if let (true, Some(left)) = (is_due && *done < 1.0, left_s) {
                    *last = Some(Line::now(*done));
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
                let template = "{pos:>7}/{len} {bar:30.cyan} {msg}";
                let bar = bar.get_or_insert_with(|| new_bar(*iterations as u64, template));
                bar.set_position(*iteration as u64);
                bar.set_message(format!(
                    "loss {loss:.4e}  {}updates/s{left}",
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
                    updates_per_s,
                    ..
                },
            ) => {
                let done = *iteration as f64 / (*iterations).max(1) as f64;
                if iteration < iterations && last.is_some_and(|last| !last.is_old(done)) {
                    return;
                }
                *last = Some(Line::now(done));
                let gradient = projected_gradient.map_or("–".to_owned(), |g| format!("{g:.1e}"));
                mutter(&format!(
                    "{:>12} {iteration:>4}/{iterations}  loss {loss:.4e}  gradient {gradient}  \
                     {}updates/s{left}",
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_is_the_mean_pace_times_the_rest() {
        let mut screen = Screen::silent();
        let at = |iteration: usize, elapsed_s: f64| Event::Iteration {
            iteration,
            iterations: 20,
            loss: 1.0,
            projected_gradient: None,
            forward_calls: 1,
            adjoint_calls: 1,
            print: None,
            elapsed_s,
            updates_per_s: 1.0,
        };
        // The start takes 7 s, an iteration 2 s
        assert_eq!(screen.left_s(&at(0, 7.0)), None);
        assert_eq!(screen.left_s(&at(1, 9.0)), Some(38.0));
        assert_eq!(screen.left_s(&at(5, 17.0)), Some(30.0));
        // A stage begins anew
        let name = "evaluating".to_owned();
        assert_eq!(screen.left_s(&Event::Stage { name }), None);
        assert_eq!(screen.left_s(&at(3, 100.0)), None);
    }

    #[test]
    fn a_log_has_a_line_for_every_tenth() {
        let line = Line {
            at: Instant::now() - PAUSE,
            done: 0.3,
        };
        assert!(!line.is_old(0.35) && line.is_old(0.41));
        assert!(!Line::now(0.0).is_old(0.9));
    }
}
