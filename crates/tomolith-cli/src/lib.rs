//! The `tomolith` command: from a mesh to patterns that can be printed, and an honest report.
//!
//! [`main_with`] is the whole command: the program `tomolith` calls it, and so does the Python package, whose wheel brings the command along.
//!
//! Exit codes: 0 done · 1 ran, but the required quality was not met · 2 could not run · 130 canceled.

mod analyze;
mod answer;
mod arguments;
mod calibrate;
mod compare;
mod devices;
mod doctor;
mod export;
mod export_matrix;
mod expose;
mod help;
mod import;
#[cfg(target_os = "linux")]
mod large_pages;
mod metrics;
mod new;
mod ranks;
mod reproduce;
mod screen;
mod shell;
mod sweep;
mod trace;
mod trouble;
mod view;
mod voxelize;

use arguments::{
    Arguments, Command, JobArguments, JobChanges, Manner, PAGE, RunArguments, SimulateArguments,
    command_line, must_be_a_place, must_end_in,
};
use clap::FromArgMatches;
use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue};
use ranks::Ranks;
pub use reproduce::Itself;
use screen::{Screen, say};
use std::ffi::OsString;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};
use tomolith::io::{give_up, write_text};
use tomolith::job::{self, Document, Job, Leaves, RunFolder};
use tomolith::models::Work;
use tomolith::{Error, Result};
use view::Live;

/// Done.
const DONE: u8 = 0;
/// Ran, but the required quality was not met.
const NOT_MET: u8 = 1;
/// Could not run.
const REFUSED: u8 = 2;
/// Canceled by the user: 128 + SIGINT, as shells expect.
const CANCELED: u8 = 130;

/// Runs the command and returns its exit code. `words` is what was typed, from the name of the program on; `itself` starts the program anew, for studies that run
/// further commands.
#[must_use]
pub fn main_with(words: &[OsString], itself: &[OsString]) -> u8 {
    let code = match arguments(words) {
        Ok(arguments) => command(&arguments, itself),
        Err(code) => code,
    };
    // Nobody else does it where the process is not this program's
    screen::take(std::io::stdout().flush());
    match screen::unsaid() {
        // The output did not reach its reader
        Some(error) => {
            screen::mutter(&format!("error: standard output: {error}"));
            REFUSED
        }
        None => code,
    }
}

fn command(arguments: &Arguments, itself: &[OsString]) -> u8 {
    trouble::set_color(arguments.color);
    let ranks = match &arguments.command {
        Command::Run(_) => ranks::started(true),
        // A run that panics is a row of the table
        Command::Sweep(_) => ranks::started(false),
        _ => None,
    };
    remark_on_launcher(&arguments.command);
    let (manner, done) = match &arguments.command {
        Command::New(given) => (Manner::default(), new::new(given).map(|()| true)),
        Command::Run(given) => (given.manner, runs(given, ranks.as_ref())),
        Command::Simulate(given) => (given.manner, simulate(given)),
        Command::Print(given) => (given.manner, print(given)),
        Command::Check(given) => (given.manner, check(given)),
        Command::Sweep(given) => (given.manner, sweep(given, ranks.as_ref())),
        Command::Reproduce(given) => (given.manner, reproduce(given, itself)),
        Command::Kinds { family, name, json } => {
            let result = help::kinds(family.as_deref(), name.as_deref(), *json);
            (Manner::with_json(*json), result.map(|()| true))
        }
        Command::Profiles { name } => (
            Manner::default(),
            help::profiles(name.as_deref()).map(|()| true),
        ),
        Command::Schema { markdown } => (Manner::default(), help::schema(*markdown).map(|()| true)),
        Command::Doctor { json } => (Manner::with_json(*json), doctor::doctor(*json)),
        Command::Completions { shell } => {
            shell::completions(*shell);
            (Manner::default(), Ok(true))
        }
        Command::Man { folder } => (Manner::default(), shell::manual(folder).map(|()| true)),
        Command::Devices { json } => {
            devices::devices(*json);
            (Manner::default(), Ok(true))
        }
        Command::Voxelize(given) => {
            let manner = given.sampling.manner;
            quick("voxelize", manner, |work| voxelize::voxelize(given, work))
        }
        Command::Phantom(given) => {
            let manner = given.sampling.manner;
            quick("phantom", manner, |work| voxelize::phantom(given, work))
        }
        Command::Metrics(given) => quick("metrics", given.manner, |_| metrics::metrics(given)),
        Command::Export(given) => quick("export", given.manner, |work| export::export(given, work)),
        Command::ExportMatrix(given) => quick("export-matrix", given.manner, |work| {
            let job = read(&given.job, None)?;
            export_matrix::export_matrix(given, &job, work)
        }),
        Command::Trace(given) => quick("trace", given.manner, |work| {
            let job = read(&given.job, None)?;
            trace::run(given, &job, work)
        }),
        Command::Import(given) => quick("import", given.manner, |_| import::import(given)),
        Command::Calibrate(given) => {
            quick("calibrate", given.manner(), |_| calibrate::calibrate(given))
        }
        Command::Expose(given) => quick("expose", given.manner, |_| expose::expose(given)),
        Command::Analyze(given) => quick("analyze", given.manner(), |_| analyze::analyze(given)),
        Command::View(given) => {
            let work = cancel_on_ctrl_c(Manner {
                quiet: true,
                ..given.manner
            });
            (
                given.manner,
                ranks::must_be_alone("view")
                    .and_then(|()| view::view(given, &work))
                    .map(|()| true),
            )
        }
        Command::Compare(given) => quick("compare", given.manner, |_| compare::compare(given)),
    };
    let code = match done {
        Ok(true) => DONE,
        Ok(false) => NOT_MET,
        // Rank 0 speaks for all, but of what it does not know
        Err(Error::Rank { .. } | Error::Canceled) if ranks::is_silent(ranks.as_ref()) => DONE,
        Err(error) => {
            trouble::show(&error, manner.json);
            match error {
                Error::Canceled => CANCELED,
                _ => REFUSED,
            }
        }
    };
    // A launcher ends all ranks when one ends badly, and that is for rank 0 to tell
    if ranks::is_silent(ranks.as_ref()) {
        return DONE;
    }
    code
}

/// What was typed, or the end of the command: help and version are printed here, and slips of the keyboard.
fn arguments(words: &[OsString]) -> Result<Arguments, u8> {
    let is_json = words.iter().any(|word| word == "--json");
    let typed = command_line().try_get_matches_from(words);
    let typed = typed.and_then(|typed| Arguments::from_arg_matches(&typed));
    let typed = typed.map_err(without_escape);
    typed.map_err(|error| match error.print() {
        _ if error.use_stderr() && is_json => {
            let text = error.to_string();
            let text = text.strip_prefix("error: ").unwrap_or(&text);
            // Which arguments are meant may stand on lines of their own
            let lines = text.lines().take_while(|line| !line.is_empty());
            let message = lines.map(str::trim).collect::<Vec<_>>().join(" ");
            let line = serde_json::json!({ "event": "error", "message": message });
            screen::say(&line.to_string());
            REFUSED
        }
        printed if !error.use_stderr() => {
            screen::take(printed);
            DONE
        }
        _ => REFUSED,
    })
}

/// The error without the tip to pass an unknown option as a value: no job or run is named so.
fn without_escape(mut error: clap::Error) -> clap::Error {
    if let Some(ContextValue::StyledStrs(tips)) = error.remove(ContextKind::Suggested) {
        let is_escape = |tip: &StyledStr| tip.to_string().starts_with("to pass");
        let tips: Vec<_> = tips.into_iter().filter(|tip| !is_escape(tip)).collect();
        if !tips.is_empty() {
            error.insert(ContextKind::Suggested, ContextValue::StyledStrs(tips));
        }
    }
    error
}

/// A command that is met when it ends without an error. Asked to stop it ends where it looks for the request, or else shortly after,
/// wherever it is.
fn quick(
    name: &str,
    manner: Manner,
    action: impl FnOnce(&Work) -> Result<()>,
) -> (Manner, Result<bool>) {
    let work = Arc::new(Work::new());
    on_ctrl_c(&work, move |earlier| {
        if earlier == 0 {
            thread::spawn(move || {
                thread::sleep(LONGEST);
                end_here(manner);
            });
        }
    });
    let done = ranks::must_be_alone(name)
        .and_then(|()| prepare(manner))
        .and_then(|()| action(&work));
    (manner, done.map(|()| true))
}

/// How long a command without stages may take to end after a request to stop.
const LONGEST: Duration = Duration::from_millis(700);

/// Ends the process in the middle of its work; files keep what they held.
fn end_here(manner: Manner) -> ! {
    give_up();
    trouble::show(&Error::Canceled, manner.json);
    std::process::exit(i32::from(CANCELED))
}

/// Tells processes of a launcher that cannot share a run or a sweep; a share by hand is what it says.
fn remark_on_launcher(command: &Command) {
    let is_quiet = match command {
        Command::Run(given) => given.manner.quiet || given.manner.json,
        Command::Sweep(given) => given.manner.quiet || given.manner.json || given.is_part(),
        _ => true,
    };
    if let Some(text) = ranks::remark().filter(|_| !is_quiet) {
        screen::mutter(&text);
    }
}

/// `tomolith run`: whether all jobs met the quality that they require. For a job that cannot run it prints the error, and begins the next one.
fn runs(given: &RunArguments, ranks: Option<&Ranks>) -> Result<bool> {
    prepare(given.manner)?;
    let several = given.jobs.len() > 1;
    if several && given.output.is_some() {
        return Err(Error::config(
            "--output",
            format!("one folder for {} jobs", given.jobs.len()),
            "no --output with several jobs: each has its output.folder, or out/NAME",
        ));
    }
    if !given.open && given.address.is_set() {
        return Err(Error::config(
            "--port",
            "`--port` or `--no-browser` without `--open`",
            "both with `--open`, which serves a page",
        ));
    }
    if several && given.open {
        return Err(Error::config(
            "--open",
            format!("{} jobs", given.jobs.len()),
            "one job: a page shows one run while it goes on",
        ));
    }
    let manner = given.manner.of_rank(ranks);
    let work = match ranks {
        None => cancel_on_ctrl_c(manner),
        // Ranks that wait for each other end their steps together
        Some(_) => cancel_saying(manner, Work::with_patience(Duration::MAX), STOPPING_RANKS),
    };
    let (mut is_met, mut last) = (true, None);
    for (i, file) in given.jobs.iter().enumerate() {
        if several && !manner.quiet && !manner.json {
            let place = format!("{}/{}", i + 1, given.jobs.len());
            screen::mutter(&format!("{place:>12} {}", file.display()));
        }
        match run(file, given, ranks, &work) {
            Ok(met) => is_met &= met,
            Err(Error::Canceled) => return Err(Error::Canceled),
            Err(error) => {
                if let Some(earlier) = last.replace(error) {
                    trouble::show(&earlier, given.manner.json);
                }
            }
        }
    }
    match last {
        Some(error) => Err(error),
        None => Ok(is_met),
    }
}

/// One job: whether the required quality was met.
fn run(file: &Path, given: &RunArguments, ranks: Option<&Ranks>, work: &Arc<Work>) -> Result<bool> {
    let job = read_changed(file, &given.changes, given.output.as_deref());
    let job = job.map(|job| match given.overwrite {
        true => job.overwriting(),
        false => job,
    });
    let job = ranks::agreed(ranks, job);
    let (resume, leaves) = (given.resume, given.keep.into());
    if given.open {
        return watched(&job?, given, work);
    }
    let mut screen = Screen::new(given.manner.of_rank(ranks));
    let summary = match ranks {
        None => job::run_leaving(&job?, resume, leaves, &mut screen, work).map(Some),
        Some(ranks) => job::run_among(&job?, resume, leaves, ranks, &mut screen, work),
    };
    let summary = summary?;
    summary.iter().for_each(|summary| screen.finish(summary));
    Ok(summary.is_none_or(|summary| summary.is_met()))
}

/// One job on a page, which shows the result until the command is stopped.
fn watched(job: &Job, given: &RunArguments, work: &Arc<Work>) -> Result<bool> {
    ranks::must_be_alone("run --open")?;
    let mut live = Live::start(job, given.address, given.manner, work)?;
    let summary = job::run_leaving(job, given.resume, Leaves::All, &mut live, work);
    let summary = match summary {
        Ok(summary) => summary,
        Err(error) => {
            live.fail(&error);
            return Err(error);
        }
    };
    live.screen().finish(&summary);
    live.finish(&summary.folder, work)?;
    Ok(summary.is_met())
}

/// `tomolith simulate`: whether the required quality was met.
fn simulate(given: &SimulateArguments) -> Result<bool> {
    ranks::must_be_alone("simulate")?;
    prepare(given.manner)?;
    let job = read(&given.job, given.output.as_deref())?;
    let work = cancel_on_ctrl_c(given.manner);
    let mut screen = Screen::new(given.manner);
    let summary = job::simulate(&job, &given.patterns, &mut screen, &work)?;
    screen.finish(&summary);
    Ok(summary.is_met())
}

/// `tomolith print`: a simulation of a job with a schedule.
fn print(given: &SimulateArguments) -> Result<bool> {
    let job = read(&given.job, given.output.as_deref())?;
    if job.spec.schedule.is_none() {
        return Err(Error::config(
            "schedule",
            "the table is missing, so nothing says when which frame shines",
            "a table [schedule], for example with turns = 3; or `tomolith simulate`",
        ));
    }
    simulate(given)
}

/// `tomolith sweep`: whether no run failed, and one meets `best.where`.
fn sweep(given: &sweep::SweepArguments, ranks: Option<&Ranks>) -> Result<bool> {
    prepare(given.manner)?;
    let manner = given.manner.of_rank(ranks);
    let done = sweep::sweep(given, ranks, &cancel_on_ctrl_c(manner));
    if matches!(done, Err(Error::Canceled)) && !manner.quiet && !manner.json {
        screen::mutter(
            "the same command goes on with what is left; with --merge it makes the table of what is there",
        );
    }
    done
}

/// `tomolith reproduce`: whether every number is there and every difference explained.
fn reproduce(given: &reproduce::ReproduceArguments, itself: &[OsString]) -> Result<bool> {
    ranks::must_be_alone("reproduce")?;
    prepare(given.manner)?;
    reproduce::run(given, itself, &cancel_on_ctrl_c(given.manner))
}

/// `tomolith check`: always met when it ends without an error.
fn check(given: &arguments::CheckArguments) -> Result<bool> {
    prepare(given.manner)?;
    if let Some(file) = &given.picture {
        must_end_in("--picture", file, &PAGE)?;
        must_be_a_place("--picture", file)?;
    }
    let job = read(&given.job, None)?;
    let work = cancel_on_ctrl_c(given.manner);
    if let Some(file) = &given.picture {
        write_text(file, &job::picture(&job, &work)?.html())?;
    }
    // Its answer is one line of JSON
    let mut screen = if given.manner.json {
        Screen::silent()
    } else {
        Screen::new(given.manner)
    };
    let plan = job::check(&job, &mut screen, &work)?;
    screen::done(given.manner, &plan, || say(plan.to_string().trim_end()));
    Ok(true)
}

fn read(given: &JobArguments, output: Option<&Path>) -> Result<Job> {
    read_changed(&given.job, &given.changes, output)
}

/// A job file, or standard input, with what options change.
fn read_changed(file: &Path, changes: &JobChanges, output: Option<&Path>) -> Result<Job> {
    let device = changes.device.iter();
    let device = device.map(|name| format!("resources.device={}", serde_json::json!(name)));
    let set: Vec<String> = changes.set.iter().cloned().chain(device).collect();
    let mut job = match file.as_os_str() == "-" {
        true => Job::changed(Document::from_stdin()?, &set)?,
        false => {
            refuse_results(file)?;
            Job::read(file, &set)?
        }
    };
    if let Some(name) = &changes.device {
        let option = format!("--device {name}");
        job.document.overridden("resources.device", option);
    }
    if changes.toy {
        job = job.toy();
    }
    Ok(match output {
        Some(folder) => job.with_folder(folder, "--output"),
        None => job,
    })
}

/// Says what to do with a folder of results that is given for a job.
fn refuse_results(folder: &Path) -> Result<()> {
    let shown = folder.display();
    let (what, next) = if RunFolder::holds_a_run(folder) {
        (
            "run",
            format!(
                "`tomolith run {shown}/job.toml -o {shown} --resume` goes on with this run, `tomolith view {shown}` shows it, \
                 `tomolith expose {shown}` plans its exposure, `tomolith compare {shown} OTHER` sets it next to another"
            ),
        )
    } else if folder.join("sweep.json").is_file() {
        (
            "sweep",
            format!(
                "`tomolith view {shown}` shows its maps and runs, `tomolith sweep` with its sweep file goes on with it"
            ),
        )
    } else {
        return Ok(());
    };
    Err(Error::config(
        "JOB",
        format!("`{shown}` is the folder of a {what}"),
        format!("a job file; {next}"),
    ))
}

fn prepare(manner: Manner) -> Result<()> {
    let Some(threads) = manner.threads else {
        return Ok(());
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(threads))
        .build_global()
        .map_err(|e| {
            Error::config(
                "--threads",
                e.to_string(),
                "a number of threads this machine can start",
            )
        })
}

/// Requests to stop that follow each other within this time are one.
const ECHO: Duration = Duration::from_millis(300);

/// The line on the screen after a request to stop, by people or by a launcher.
const STOPPING: &str = "\nstopping: the iteration at hand is given 0.4 s";
const STOPPING_RANKS: &str = "\nasked to stop: ranks stop after this iteration. Where one of them has died the launcher ends the others, and \
    `--resume` goes on from the last checkpoint";

/// The first Ctrl-C asks the run to stop soon, the second at once, the third ends the process.
fn cancel_on_ctrl_c(manner: Manner) -> Arc<Work> {
    cancel_saying(manner, Work::new(), STOPPING)
}

/// Cancels on Ctrl-C, saying so in these words.
fn cancel_saying(manner: Manner, work: Work, stopping: &'static str) -> Arc<Work> {
    let work = Arc::new(work);
    let asked = Arc::clone(&work);
    on_ctrl_c(&work, move |earlier| {
        if earlier >= 2 {
            end_here(manner);
        }
        // An optimization may end its step first
        if !manner.quiet && !asked.is_canceled() {
            screen::mutter(stopping);
        }
    });
    work
}

/// Passes every Ctrl-C on to a run, and does something more with the number of those before it.
fn on_ctrl_c(work: &Arc<Work>, mut then: impl FnMut(u32) + Send + 'static) {
    let work = Arc::clone(work);
    let mut last: Option<Instant> = None;
    // Without a handler Ctrl-C still ends the process, only less cleanly
    let _ = ctrlc::set_handler(move || {
        // Shells and wrappers may deliver one request twice
        if last
            .replace(Instant::now())
            .is_none_or(|before| before.elapsed() >= ECHO)
        {
            then(work.cancel());
        }
    });
}
