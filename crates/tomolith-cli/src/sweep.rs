//! `tomolith sweep`: many runs of one job.

use crate::arguments::Manner;
use crate::ranks::{Ranks, agreed};
use crate::screen::{done, mutter, new_bar, say};
use clap::Args;
use indicatif::ProgressBar;
use std::io::IsTerminal;
use std::path::PathBuf;
use std::thread::available_parallelism;
use tomolith::models::Work;
use tomolith::report::number::significant;
use tomolith::units::{counted, duration};
use tomolith::{Error, Result};
use tomolith_sweep::{Shard, Sweep, SweepEvent, SweepOutcome, SweepPlan, Watch, merge, run};

const EXAMPLES: &str = "\
Examples:
  tomolith sweep examples/sweeps/threshold-map.toml  table, maps and best job in out/threshold-map
  tomolith sweep sweep.toml --shard 3/16             the third of 16 shares, for one of 16 machines
  tomolith sweep sweep.toml --merge                  table and maps of what is there
  tomolith sweep sweep.toml --list | parallel -j 4   the runs as ordinary commands
  mpirun -n 4 tomolith sweep sweep.toml              a share each, where this was built with MPI

The same command again goes on with what is left. Exit codes: 0 done, 1 a run failed or is missing, or
none meets best.where, 2 could not run, 130 canceled";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct SweepArguments {
    /// Sweep file, TOML or JSON
    sweep: PathBuf,
    /// Folder of the results, in place of `folder`
    #[arg(long, short, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Only print the runs as commands, one a line
    #[arg(long, conflicts_with_all = ["shard", "merge"])]
    list: bool,
    /// Only this share of the runs
    #[arg(long, value_name = "I/N", conflicts_with = "merge")]
    shard: Option<Shard>,
    /// Only collect what is there, and runs of the same sweep in other folders
    #[arg(long, value_name = "DIR", num_args = 0..)]
    merge: Option<Vec<PathBuf>>,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

pub(crate) fn sweep(given: &SweepArguments, ranks: Option<&Ranks>, work: &Work) -> Result<bool> {
    let plan = planned(given, ranks, work);
    let plan = agreed(ranks, plan)?;
    if given.list {
        plan.commands()?.iter().for_each(|command| say(command));
        return Ok(true);
    }
    let manner = given.manner.of_rank(ranks);
    let mut board = Board::new(manner, &plan);
    let outcome = match (&given.merge, ranks) {
        (Some(others), _) => merge(&plan, others)?,
        (None, None) => {
            tell_cost(&plan, given, work)?;
            run(&plan, given.shard, &mut board, work)?
        }
        (None, Some(ranks)) => {
            let (number, shares) = (ranks.rank() + 1, ranks.size());
            let outcome = run(&plan, Some(Shard { number, shares }), &mut board, work);
            agreed(Some(ranks), outcome)?;
            if !ranks.is_first() {
                return Ok(true);
            }
            merge(&plan, &[])?
        }
    };
    finish(&outcome, manner);
    Ok(outcome.is_met())
}

/// Sweeps that take longer than this say so before they begin, s.
const LONG_S: f64 = 3600.0;

/// Says what a long sweep will take: its runs, and the time that `tomolith check` reckons for a few of them, times their number.
fn tell_cost(plan: &SweepPlan, given: &SweepArguments, work: &Work) -> Result<()> {
    if given.manner.quiet {
        return Ok(());
    }
    let (runs, seconds) = (plan.runs.len(), plan.seconds(work)?);
    match cost(runs, given.shard, seconds) {
        Some((_, line)) if given.manner.json => say(&line.to_string()),
        Some((words, _)) => mutter(&format!("{:>12} {words}", "Cost")),
        None => {}
    }
    Ok(())
}

/// The cost of a long sweep or of a share of it, for people and as a line of JSON; none of a short one.
fn cost(runs: usize, shard: Option<Shard>, seconds: f64) -> Option<(String, serde_json::Value)> {
    let shares = shard.map_or(1.0, |shard| shard.shares as f64);
    let seconds = seconds / shares;
    let share = shard.map_or_else(String::new, |shard| {
        format!(", of which this is share {}/{}", shard.number, shard.shares)
    });
    let words = format!(
        "{}{share}: about {} for those that are not finished, where each takes all its iterations on this machine as busy as it is",
        counted(runs, "run"),
        duration(seconds)
    );
    let line = serde_json::json!({ "event": "cost", "runs": runs, "seconds": seconds });
    (seconds >= LONG_S).then_some((words, line))
}

impl SweepArguments {
    /// Whether it is a share by hand, or only collects or lists.
    pub(crate) fn is_part(&self) -> bool {
        self.list || self.shard.is_some() || self.merge.is_some()
    }
}

fn planned(given: &SweepArguments, ranks: Option<&Ranks>, work: &Work) -> Result<SweepPlan> {
    if let Some(ranks) = ranks.filter(|_| given.is_part()) {
        return Err(Error::config(
            "--list, --shard, --merge",
            format!("{} ranks, which take the shares themselves", ranks.size()),
            "none of them under mpirun",
        ));
    }
    let mut sweep = Sweep::read(&given.sweep)?;
    if !given.manner.quiet && !given.manner.json && !given.list {
        mutter(&format!("{:>12} its jobs", "Reading"));
    }
    if let Some(folder) = &given.output {
        sweep = sweep.with_folder(folder, "--output");
    }
    let available = || available_parallelism().map_or(1, usize::from);
    let threads = given.manner.threads.map_or_else(available, usize::from);
    let processes = ranks.map_or(1, |ranks| ranks.beside());
    sweep.beside(processes).plan(threads, work)
}

fn finish(outcome: &SweepOutcome, manner: Manner) {
    done(manner, outcome, || say(outcome.to_string().trim_end()));
    if manner.quiet && !manner.json && !outcome.is_met() {
        let text = outcome.to_string();
        let why = text.lines().next().unwrap_or_default();
        mutter(&format!(
            "error: {why}; {} has the table",
            outcome.folder.display()
        ));
    }
}

/// Where the runs of a sweep are shown: a bar on a terminal, a line a run elsewhere, JSON lines, or nothing.
pub(crate) struct Board {
    manner: Manner,
    bar: Option<ProgressBar>,
    about: String,
    /// Runs of the whole sweep.
    all: usize,
    /// The metric by which runs are ranked.
    ranked_by: String,
    /// The name in its study.
    name: Option<String>,
}

impl Board {
    pub(crate) fn new(manner: Manner, plan: &SweepPlan) -> Self {
        Board {
            manner,
            bar: None,
            about: plan.to_string(),
            all: plan.runs.len(),
            ranked_by: plan.ranked_by().to_owned(),
            name: None,
        }
    }

    /// For a run of a study, whose JSON lines name it.
    pub(crate) fn named(mut self, name: &str) -> Self {
        self.name = Some(name.to_owned());
        self
    }
}

impl Watch for Board {
    fn event(&mut self, event: &SweepEvent) {
        if self.manner.quiet {
            return;
        }
        if self.manner.json {
            let mut line = serde_json::to_value(event).unwrap_or_default();
            if let Some(name) = &self.name {
                line["of"] = name.as_str().into();
            }
            say(&line.to_string());
            return;
        }
        match event {
            SweepEvent::Sweep { runs, finished, .. } => {
                let of_process = match *runs == self.all {
                    true => String::new(),
                    false => format!(" of the {runs} of this process"),
                };
                mutter(&format!(
                    "{:>12} {}; {finished}{of_process} finished before",
                    "", self.about
                ));
                if std::io::stderr().is_terminal() {
                    let bar = new_bar(
                        *runs as u64,
                        "{pos:>7}/{len} {bar:30.cyan} {percent:>3} %  {msg}",
                    );
                    bar.set_position(*finished as u64);
                    self.bar = Some(bar);
                }
            }
            SweepEvent::Run {
                run,
                values,
                state,
                result,
                seconds,
                ended,
                runs,
                left_s,
            } => {
                let left = duration(*left_s);
                let message = || result.as_str().map_or(result.to_string(), str::to_owned);
                let failed = (*state == "failed").then(message);
                match (&self.bar, failed) {
                    (Some(bar), failed) => {
                        if let Some(message) = failed {
                            bar.suspend(|| {
                                mutter(&format!(
                                    "{:>12} run {run} ({values}): {message}",
                                    "Failed"
                                ));
                            });
                        }
                        bar.set_position(*ended as u64);
                        bar.set_message(format!("{left} left"));
                    }
                    (None, failed) => mutter(&format!(
                        "{ended:>7}/{runs}  run {run}: {values}  {}  {seconds:.1} s, {left} left",
                        failed.map_or_else(|| self.number(result), |why| format!("failed: {why}"))
                    )),
                }
            }
        }
    }
}

impl Board {
    /// The number by which runs are ranked, for the line of a run.
    fn number(&self, result: &serde_json::Value) -> String {
        let name = &self.ranked_by;
        match &result[name] {
            serde_json::Value::Null => format!("{name} not defined"),
            value => match value.as_f64() {
                Some(number) => format!("{name} {}", significant(number, 4)),
                None => format!("{name} {value}"),
            },
        }
    }
}

impl Drop for Board {
    fn drop(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_of_hours_says_so_before_it_begins() {
        let (words, line) = cost(325, None, 43_200.0).unwrap();
        let expected = "325 runs: about 12.0 h for those that are not finished";
        assert!(words.starts_with(expected), "{words}");
        assert_eq!(
            (line["event"].as_str(), line["runs"].as_u64()),
            (Some("cost"), Some(325))
        );
        let shard = Some(Shard {
            number: 3,
            shares: 4,
        });
        let (words, _) = cost(325, shard, 43_200.0).unwrap();
        assert!(
            words.starts_with("325 runs, of which this is share 3/4: about 3.0 h"),
            "{words}"
        );
        assert!(cost(325, None, 3599.0).is_none());
    }
}
