//! `tomolith reproduce`: the numbers of a paper beside ours.

use crate::arguments::Manner;
use crate::screen::{mutter, say};
use crate::sweep::Board;
use clap::Args;
use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};
use std::io::Read;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::{self, available_parallelism};
use std::time::Duration;
use tomolith::models::Run;
use tomolith::{Error, Result};
use tomolith_sweep::{Host, Study, StudyCost, SweepPlan, Watch, duration, reproduce};

const EXAMPLES: &str = "\
Examples:
  tomolith reproduce papers/dual-color            every number of the paper, in seconds
  tomolith reproduce papers/tvam-aid --quick      a coarse map, in minutes
  tomolith reproduce papers/bclp --check          only what it would cost

The same command again goes on with what is left. Exit codes: 0 every difference is explained, 1 a difference is not,
or a number is missing, 2 could not run, 130 canceled";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct ReproduceArguments {
    /// Folder of a study, with its study.toml
    study: PathBuf,
    /// A size that ends in minutes on two cores
    #[arg(long)]
    quick: bool,
    /// Only say what it would cost
    #[arg(long)]
    check: bool,
    /// Folder of the results, in place of out/papers/NAME
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

pub(crate) fn run(given: &ReproduceArguments, cancel: &Run) -> Result<bool> {
    let study = Study::read(&given.study, given.quick)?;
    let output = given.output.clone().unwrap_or_else(|| study.output());
    let own = || available_parallelism().map_or(1, usize::from);
    let threads = given.manner.threads.map_or_else(own, usize::from);
    let mut typed = Typed {
        manner: given.manner,
        cancel,
    };
    if given.check {
        typed.begins(&study.costs(&output, threads, cancel)?);
        return Ok(true);
    }
    let found = reproduce(&study, &output, threads, &mut typed, cancel)?;
    if given.manner.json {
        let mut line = json!(found);
        line["event"] = "done".into();
        say(&line.to_string());
    } else if !given.manner.quiet {
        say(found.to_string().trim_end());
    }
    Ok(found.is_met())
}

/// A study that was typed.
struct Typed<'r> {
    manner: Manner,
    cancel: &'r Run,
}

impl Host for Typed<'_> {
    fn begins(&mut self, costs: &[StudyCost]) {
        let seconds: f64 = costs.iter().map(|cost| cost.seconds).sum();
        if self.manner.json {
            let line = json!({ "event": "study", "runs": costs, "seconds": seconds });
            say(&line.to_string());
        } else if !self.manner.quiet {
            costs
                .iter()
                .for_each(|cost| mutter(&format!("{:>12} {cost}", "")));
            mutter(&format!(
                "{:>12} about {} in all",
                "Cost",
                duration(seconds)
            ));
        }
    }

    fn watch(&mut self, name: &str, plan: &SweepPlan) -> Box<dyn Watch> {
        if !self.manner.json && !self.manner.quiet {
            mutter(&format!("{:>12} {name}", "Run"));
        }
        Box::new(Board::new(self.manner, plan).named(name))
    }

    fn command(&mut self, words: &[String], folder: &Path) -> Result<Value> {
        let own = std::env::current_exe().map_err(|e| Error::io(Path::new("tomolith"), e))?;
        let mut command = Command::new(own);
        command.current_dir(folder).args(words).arg("--json");
        if let Some(threads) = self.manner.threads {
            command.args(["--threads", &threads.to_string()]);
        }
        // In a group of its own: Ctrl-C at a terminal is passed on once, and not told twice
        let child = (command.process_group(0).stdin(Stdio::null()))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn();
        let done = child.and_then(|child| ended(child, self.cancel));
        let done = done.map_err(|e| Error::io(folder, e))?;
        let text = String::from_utf8_lossy(&done.stdout);
        let answer = text
            .lines()
            .last()
            .and_then(|line| serde_json::from_str::<Value>(line).ok());
        match (done.status.code(), answer) {
            (Some(0 | 1), Some(answer)) => Ok(answer),
            (Some(130), _) => Err(Error::Canceled),
            (_, answer) => Err(Error::Unsupported {
                what: format!("tomolith {}", words.join(" ")),
                reason: answer
                    .and_then(|answer| answer["message"].as_str().map(str::to_owned))
                    .unwrap_or_else(|| String::from_utf8_lossy(&done.stderr).trim().to_owned()),
            }),
        }
    }
}

/// How often a request to stop is looked for while a command works.
const PAUSE: Duration = Duration::from_millis(50);

/// What a command said until it ended; a request to stop is passed on to it once.
fn ended(mut child: Child, cancel: &Run) -> std::io::Result<Output> {
    let (out, err) = (child.stdout.take(), child.stderr.take());
    thread::scope(|scope| {
        let out = scope.spawn(|| all_of(out));
        let err = scope.spawn(|| all_of(err));
        let mut was_told = false;
        let status = loop {
            if let Some(status) = child.try_wait()? {
                break status;
            }
            if cancel.is_stop_asked() && !was_told {
                was_told = true;
                kill_process(Pid::from_child(&child), Signal::TERM)?;
            }
            thread::sleep(PAUSE);
        };
        let of = |said: thread::ScopedJoinHandle<'_, std::io::Result<Vec<u8>>>| {
            said.join().unwrap_or_else(|_| Ok(Vec::new()))
        };
        Ok(Output {
            status,
            stdout: of(out)?,
            stderr: of(err)?,
        })
    })
}

fn all_of(pipe: Option<impl Read>) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    match pipe {
        Some(mut pipe) => pipe.read_to_end(&mut bytes).map(|_| bytes),
        None => Ok(bytes),
    }
}
