//! `tomolith reproduce`: the numbers of a paper next to ours.

use crate::arguments::{Manner, command_line};
use crate::screen::{done, mutter, say};
use crate::sweep::Board;
use clap::{ArgMatches, Args};
use serde_json::{Value, json};
use std::ffi::OsString;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::{self, available_parallelism};
use std::time::Duration;
use tomolith::models::Work;
use tomolith::units::duration;
use tomolith::{Error, Result};
use tomolith_sweep::{Host, Study, StudyCost, SweepPlan, Watch, reproduce};

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

pub(crate) fn run(given: &ReproduceArguments, itself: &[OsString], work: &Work) -> Result<bool> {
    let study = Study::read(&given.study, given.quick)?;
    let output = given.output.clone().unwrap_or_else(|| study.output());
    let available = || available_parallelism().map_or(1, usize::from);
    let threads = given.manner.threads.map_or_else(available, usize::from);
    let mut typed = Typed {
        manner: given.manner,
        itself: Itself {
            program: itself,
            threads: given.manner.threads.map(usize::from),
            work,
        },
    };
    if !given.manner.json && !given.manner.quiet {
        let what = "reads every job of the study and times its first iterations";
        mutter(&format!("{:>12} {what}", "Check"));
    }
    if given.check {
        let costs = study.costs(&output, threads, &typed, work)?;
        typed.begins(&costs);
        return Ok(true);
    }
    let found = reproduce(&study, &output, threads, &mut typed, work)?;
    done(given.manner, &found, || say(found.to_string().trim_end()));
    Ok(found.is_met())
}

/// Commands that leave a folder of files whether they are given `--output` or not.
const ALWAYS: [&str; 4] = ["run", "simulate", "print", "sweep"];
const WRITES: &str =
    "writes = true and no --output among its words: then its files are among the results";
const HELP: &str = "what can be typed after `tomolith`: see `tomolith --help`";

/// What is wrong with words, without how to use the command.
fn first_words(error: &clap::Error) -> String {
    let text = error.to_string();
    let parts = text
        .split("\n\n")
        .take_while(|part| !part.contains("Usage:"));
    let parts = parts.map(|part| part.split_whitespace().collect::<Vec<_>>().join(" "));
    let text = parts.collect::<Vec<_>>().join("; ");
    text.strip_prefix("error: ").unwrap_or(&text).to_owned()
}

/// The command that was typed, of commands in commands, and what it was given.
fn innermost<'a>(
    mut command: &'a clap::Command,
    mut given: &'a ArgMatches,
) -> (&'a clap::Command, &'a ArgMatches) {
    while let Some((name, inner)) = given.subcommand() {
        command = command.find_subcommand(name).unwrap_or(command);
        given = inner;
    }
    (command, given)
}

/// A study that was typed.
struct Typed<'r> {
    manner: Manner,
    itself: Itself<'r>,
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

    fn watch(&mut self, name: &str, plan: &SweepPlan) -> Box<dyn Watch + '_> {
        if !self.manner.json && !self.manner.quiet {
            mutter(&format!("{:>12} {name}", "Run"));
        }
        Box::new(Board::new(self.manner, plan).named(name))
    }

    fn must_be_command(&self, words: &[String], writes: bool) -> Result<()> {
        self.itself.must_be_command(words, writes)
    }

    fn command(&mut self, words: &[String], folder: &Path) -> Result<Value> {
        self.itself.command(words, folder)
    }
}

/// This command in a separate process, as studies run it: how it is started, its threads, and what ends it.
#[derive(Clone, Copy, Debug)]
pub struct Itself<'r> {
    /// The program, and words before those of the command.
    pub program: &'r [OsString],
    /// Threads of the command; None for all cores.
    pub threads: Option<usize>,
    /// What ends it.
    pub work: &'r Work,
}

impl Itself<'_> {
    /// How a command speaks and works.
    fn manner_words(&self) -> Vec<String> {
        let threads = self.threads.map(|n| format!("--threads={n}"));
        ["--json".to_owned()].into_iter().chain(threads).collect()
    }

    /// Refuses words that are no command, and such whose files would be among those of the study; see [`Host::must_be_command`].
    ///
    /// # Errors
    /// [`Error::Config`].
    pub fn must_be_command(&self, words: &[String], writes: bool) -> Result<()> {
        let mut all = command_line();
        let output = ["--output", "DIR"].into_iter().filter(|_| writes);
        let line = ["tomolith"].into_iter();
        let line = line.chain(words.iter().map(String::as_str)).chain(output);
        let line = line.map(str::to_owned).chain(self.manner_words());
        let typed = all.try_get_matches_from_mut(line);
        let typed = typed.map_err(|error| Error::config("command", first_words(&error), HELP))?;
        let (command, given) = innermost(&all, &typed);
        let refuse = |found: &str, accepted| {
            let found = format!("`tomolith {}` {found}", words.join(" "));
            Err(Error::config("writes", found, accepted))
        };
        let output = command.get_arguments().find(|arg| arg.get_id() == "output");
        let is_folder = |arg: &clap::Arg| {
            let names = arg.get_value_names().unwrap_or_default();
            names.iter().any(|name| name == "DIR")
        };
        let has_output = || matches!(given.try_get_raw("output"), Ok(Some(_)));
        match writes {
            true if !output.is_some_and(is_folder) => {
                refuse("writes a file", "a command whose --output is a folder")
            }
            false if has_output() || ALWAYS.contains(&command.get_name()) => {
                refuse("leaves files in the folder of the study", WRITES)
            }
            _ => Ok(()),
        }
    }

    /// Runs a command in a folder; what it says at its end. See [`Host::command`].
    ///
    /// # Errors
    /// [`Error::Canceled`]; [`Error::Unsupported`] with what the command says where it fails; [`Error::Io`].
    pub fn command(&self, words: &[String], folder: &Path) -> Result<Value> {
        let [program, first @ ..] = self.program else {
            return Err(Error::unsupported("a command", "no program is named"));
        };
        let mut command = Command::new(program);
        command.current_dir(folder).args(first).args(words);
        command.args(self.manner_words());
        // In a separate process group: Ctrl-C at a terminal reaches the command once, not twice
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let child = (command.stdin(Stdio::null()))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn();
        let done = child.and_then(|child| ended(child, self.work));
        let done = done.map_err(|e| Error::io(folder, e))?;
        let text = String::from_utf8_lossy(&done.stdout);
        let answer = text
            .lines()
            .last()
            .and_then(|line| serde_json::from_str::<Value>(line).ok());
        match (done.status.code(), answer) {
            (Some(0 | 1), Some(answer)) => Ok(answer),
            (Some(130), _) => Err(Error::Canceled),
            (_, answer) => Err(Error::unsupported(
                format!("tomolith {}", words.join(" ")),
                answer
                    .and_then(|answer| answer["message"].as_str().map(str::to_owned))
                    .unwrap_or_else(|| String::from_utf8_lossy(&done.stderr).trim().to_owned()),
            )),
        }
    }
}

/// How often a request to stop is looked for while a command works.
const PAUSE: Duration = Duration::from_millis(50);

/// What a command printed until it ended; a request to stop is passed on to it once.
fn ended(mut child: Child, work: &Work) -> std::io::Result<Output> {
    let (out, err) = (child.stdout.take(), child.stderr.take());
    thread::scope(|scope| {
        let out = scope.spawn(|| all_of(out));
        let err = scope.spawn(|| all_of(err));
        let mut was_told = false;
        let status = loop {
            if let Some(status) = child.try_wait()? {
                break status;
            }
            if work.is_stop_asked() && !was_told {
                was_told = true;
                ask_to_stop(&mut child)?;
            }
            thread::sleep(PAUSE);
        };
        let bytes_of = |reader: thread::ScopedJoinHandle<'_, std::io::Result<Vec<u8>>>| {
            reader.join().unwrap_or_else(|_| Ok(Vec::new()))
        };
        Ok(Output {
            status,
            stdout: bytes_of(out)?,
            stderr: bytes_of(err)?,
        })
    })
}

#[cfg(unix)]
fn ask_to_stop(child: &mut Child) -> std::io::Result<()> {
    use rustix::process::{Pid, Signal, kill_process};
    Ok(kill_process(Pid::from_child(child), Signal::TERM)?)
}

/// Without signals it is ended.
#[cfg(not(unix))]
fn ask_to_stop(child: &mut Child) -> std::io::Result<()> {
    child.kill()
}

fn all_of(pipe: Option<impl Read>) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    match pipe {
        Some(mut pipe) => pipe.read_to_end(&mut bytes).map(|_| bytes),
        None => Ok(bytes),
    }
}
