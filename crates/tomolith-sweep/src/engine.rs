//! Runs side by side: which run is next, which events the caller sees, how a sweep stops, what it collects at the end.
//!
//! Each of the slots has a pool of threads and takes the first waiting run whose start is settled. Nothing of a run's result
//! depends on which slot takes it or when. A request to stop is passed on to every run at work.

use crate::pictures;
use crate::plan::{RUNS, SweepPlan, firsts, of_run};
use crate::table::{State, Table, failure, state};
use serde::Serialize;
use serde_json::{Map, Value, json};
use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use tomolith::io::npy::must_be_whole;
use tomolith::io::{make_folder, write_text};
use tomolith::job::{self, Document, Job, Leaves, RunCache, RunFolder, Silent, folder::TAKEN};
use tomolith::kind::table_of;
use tomolith::models::Work;
use tomolith::report::json::read as read_report;
use tomolith::text::one_line;
use tomolith::units::counted;
use tomolith::{Error, Result};

/// How often a request to stop is looked for, and how often a folder in which another process works.
const PAUSE: Duration = Duration::from_millis(100);
const BUSY: Duration = Duration::from_secs(1);

/// Something worth telling.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum SweepEvent {
    /// Every job was checked.
    Sweep {
        /// Runs of this process.
        runs: usize,
        /// Those that were finished before.
        finished: usize,
        /// How many work at a time.
        side_by_side: usize,
        /// Memory of each, MB.
        memory_mb: Option<u64>,
    },
    /// A run has ended.
    Run {
        /// Its number in the table, from 1.
        run: usize,
        /// Its values, for people.
        values: String,
        /// `done` or `failed`.
        state: &'static str,
        /// Its metrics, or why it failed.
        result: Value,
        /// Seconds that it took.
        seconds: f64,
        /// How many have ended, those of earlier calls included.
        ended: usize,
        /// Of how many.
        runs: usize,
        /// Seconds that the rest will take, if it goes on as fast.
        left_s: f64,
    },
}

/// Where events go.
pub trait Watch {
    /// Called for each event, from the calling thread.
    fn event(&mut self, event: &SweepEvent);
}

/// A share of the runs, for one of several machines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 1.
    pub number: usize,
    /// Of how many.
    pub shares: usize,
}

impl std::str::FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text
            .split_once('/')
            .and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match parts {
            Some((number, shares)) if (1..=shares).contains(&number) => {
                Ok(Shard { number, shares })
            }
            _ => Err("I/N with 1 ≤ I ≤ N, as in 3/16".to_owned()),
        }
    }
}

/// What a sweep came to.
#[derive(Clone, Debug, Serialize)]
pub struct SweepOutcome {
    /// Where results are.
    pub folder: PathBuf,
    /// All runs of the sweep.
    pub runs: usize,
    /// Those that have their numbers.
    pub done: usize,
    /// Those that failed.
    pub failed: usize,
    /// Those that have not been run.
    pub missing: usize,
    /// The best run: number, values, metrics. None where no run meets `best.where`; None of a share, which does not know the other runs.
    pub best: Option<BestRun>,
    /// Table, pictures, best job; empty for a share.
    pub files: Vec<PathBuf>,
    /// Metrics that no run has, and runs that were done again because files of theirs were damaged, one sentence each.
    pub warnings: Vec<String>,
    /// Whether this was a share of the runs.
    #[serde(skip)]
    is_share: bool,
}

/// The best run.
#[derive(Clone, Debug, Serialize)]
pub struct BestRun {
    /// Its number in the table, from 1.
    pub run: usize,
    /// Its values, for people.
    pub values: String,
    /// Its metrics.
    pub metrics: Map<String, Value>,
}

impl SweepOutcome {
    /// Whether no run failed or is missing, and one meets `best.where`; of a share, whether no run failed.
    #[must_use]
    pub fn is_met(&self) -> bool {
        self.failed == 0 && (self.is_share || self.missing == 0 && self.best.is_some())
    }
}

impl fmt::Display for SweepOutcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {} done", self.done, counted(self.runs, "run"))?;
        for (count, word) in [(self.failed, "failed"), (self.missing, "missing")] {
            if count > 0 {
                write!(f, ", {count} {word}")?;
            }
        }
        writeln!(f)?;
        match &self.best {
            Some(best) => {
                writeln!(f, "{:>12} {}", "best", best.values)?;
                for (name, value) in &best.metrics {
                    writeln!(f, "{:>12} {name} = {value}", "")?;
                }
            }
            None if self.is_share => {
                writeln!(f, "{:>12} collect all shares with --merge", "share")?
            }
            None => writeln!(
                f,
                "{:>12} none: no finished run has the number that ranks and meets best.where",
                "best"
            )?,
        }
        for file in &self.files {
            writeln!(f, "{:>12} {}", "wrote", file.display())?;
        }
        for text in &self.warnings {
            writeln!(f, "{:>12} {text}", "warning")?;
        }
        Ok(())
    }
}

/// How far a run is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum RunState {
    /// It is not of this process.
    Elsewhere,
    Waits,
    Works,
    Done,
    Failed,
}

/// What the slots share.
struct Board {
    turns: Vec<RunState>,
    /// For each run the first one with the same job, which is the one that is run.
    firsts: Vec<usize>,
    stop: bool,
}

/// What a slot tells.
enum Told {
    Ended {
        run: usize,
        state: State,
        seconds: f64,
    },
    Broken(Error),
}

/// Runs a sweep, or a share of it; what was finished before stays. Without a share all is collected at the end.
///
/// # Errors
/// [`Error::Canceled`], with checkpoints of the runs at work; [`Error::Io`]; [`Error::Config`] where the folder holds another sweep's
/// results. A run that
/// fails is noted, and the others go on.
pub fn run(
    plan: &SweepPlan,
    shard: Option<Shard>,
    watch: &mut dyn Watch,
    work: &Work,
) -> Result<SweepOutcome> {
    begin(plan)?;
    let mut turns = vec![RunState::Elsewhere; plan.runs.len()];
    let firsts = firsts(&plan.runs);
    let mut again = Vec::new();
    // A run comes after those that it may start from
    for i in own_runs(plan, shard) {
        if let Some(found) = damage(plan, i) {
            let values = plan.words(i);
            again.push(format!("run {} ({values}) is done again: {found}", i + 1));
        }
        let from = parents(plan, &firsts, i);
        let are_done = from.iter().all(|&parent| turns[parent] == RunState::Done);
        turns[i] = if are_done && is_ready(plan, i, &from) {
            RunState::Done
        } else {
            RunState::Waits
        };
    }
    let count = |wanted: RunState| turns.iter().filter(|turn| **turn == wanted).count();
    let (finished, waiting) = (count(RunState::Done), count(RunState::Waits));
    let mut clock = Clock {
        begin: Instant::now(),
        ended: finished,
        runs: finished + waiting,
        before: finished,
    };
    watch.event(&SweepEvent::Sweep {
        runs: clock.runs,
        finished,
        side_by_side: plan.side_by_side.min(waiting.max(1)),
        memory_mb: plan.share_mb,
    });
    work.set_patient(true);
    let ended = on_slots(plan, turns, watch, &mut clock, work);
    work.set_patient(false);
    ended?;
    let mut outcome = match shard {
        None => collect(plan)?,
        Some(_) => SweepOutcome {
            is_share: true,
            ..counted_up(plan, &Table::collect(plan)?)
        },
    };
    outcome.warnings.extend(again);
    Ok(outcome)
}

/// The folder of the results, which are this sweep's.
fn begin(plan: &SweepPlan) -> Result<()> {
    let folder = plan.folder();
    let runs = folder.join(RUNS);
    plan.sweep.claim(&folder)?;
    make_folder(&runs)
}

/// Collects what is there, runs of other folders of the same sweep first, and writes table, pictures and best job.
///
/// # Errors
/// [`Error::Io`]; [`Error::Config`] for a folder without runs of the sweep, and for results that are another sweep's.
pub fn merge(plan: &SweepPlan, others: &[PathBuf]) -> Result<SweepOutcome> {
    if others.is_empty() && !plan.folder().join(RUNS).is_dir() {
        return Err(Error::config(
            "--merge",
            format!("`{}` holds no runs", plan.folder().display()),
            "the folder of a sweep that was run, or shares of it: --merge DIR …",
        ));
    }
    begin(plan)?;
    for other in others {
        let runs = other.join(RUNS);
        let folder = |i: usize| runs.join(&plan.runs[i].id);
        let note = |i: usize| runs.join(format!("{}.failed.json", plan.runs[i].id));
        let is_there = |i: usize| folder(i).is_dir() || note(i).is_file();
        if !(0..plan.runs.len()).any(is_there) {
            let runs = if runs.is_dir() {
                "no run of this sweep"
            } else {
                "no runs"
            };
            return Err(Error::config(
                "--merge",
                format!("`{}` holds {runs}", other.display()),
                "a folder in which a share of this sweep was run, with the same files next to it",
            ));
        }
        for i in firsts(&plan.runs) {
            let (from, to, note) = (folder(i), plan.run_folder(i), note(i));
            if RunFolder::finished(&to).is_none() && RunFolder::finished(&from).is_some() {
                copy_whole(&from, &to)?;
            }
            if matches!(state(plan, i)?, State::Missing) && note.is_file() {
                fs::copy(&note, failure(plan, i)).map_err(|e| Error::io(&note, e))?;
            }
        }
    }
    collect(plan)
}

/// Copies a folder so that the copy is whole or not there.
fn copy_whole(from: &Path, to: &Path) -> Result<()> {
    if to.exists() {
        fs::remove_dir_all(to).map_err(|e| Error::io(to, e))?;
    }
    if let Some(parent) = to.parent() {
        fs::create_dir_all(parent).map_err(|e| Error::io(parent, e))?;
    }
    tomolith::io::write_folder_whole(to, |new| Ok(copy(from, new)?))
}

fn copy(from: &Path, to: &Path) -> std::io::Result<()> {
    for entry in fs::read_dir(from)? {
        let (entry, to) = entry.map(|e| (e.path(), to.join(e.file_name())))?;
        if entry.is_dir() {
            fs::create_dir(&to)?;
            copy(&entry, &to)?;
        } else {
            fs::copy(&entry, &to)?;
        }
    }
    Ok(())
}

/// Table, pictures and best job of what is there.
fn collect(plan: &SweepPlan) -> Result<SweepOutcome> {
    let table = Table::collect(plan)?;
    let folder = plan.folder();
    let mut outcome = counted_up(plan, &table);
    pictures::remove_outdated(plan, &folder);
    outcome.files.extend(table.write(&folder)?);
    outcome
        .files
        .extend(pictures::write(plan, &table, &folder)?);
    let file = folder.join("best.toml");
    match table.best {
        Some(i) => {
            let text = best_job(plan, &table, i)?;
            write_text(&file, &text)?;
            outcome.files.push(file);
        }
        // One of an earlier call would be wrong
        None => drop(fs::remove_file(&file)),
    }
    Ok(outcome)
}

fn counted_up(plan: &SweepPlan, table: &Table<'_>) -> SweepOutcome {
    let [done, failed, missing] = table.counts();
    let best = |i: usize| BestRun {
        run: i + 1,
        values: plan.words(i),
        metrics: plan
            .sweep
            .metrics
            .iter()
            .map(|m| (m.clone(), json!(table.metric(i, m))))
            .collect(),
    };
    SweepOutcome {
        folder: plan.folder(),
        runs: plan.runs.len(),
        done,
        failed,
        missing,
        best: table.best.map(best),
        files: Vec::new(),
        warnings: table.doubts(),
        is_share: false,
    }
}

/// The job of a run with every default, as a file that stands alone.
fn best_job(plan: &SweepPlan, table: &Table<'_>, i: usize) -> Result<String> {
    let job = plan
        .job(i)?
        .with_folder(&plan.folder().join("best"), "sweep");
    let mut spec = job.complete();
    spec.evaluate.surfaces |= plan.sweep.leaves_surfaces_out();
    if let Some(Value::String(file)) = spec.start.pointer_mut("/patterns/file")
        && let Ok(absolute) = std::path::absolute(job.base().join(&*file))
    {
        *file = absolute.to_string_lossy().into_owned();
    }
    let done = match table.counts()[0] {
        done if done == plan.runs.len() => String::new(),
        done => format!("{done} finished ones of "),
    };
    let mut comments = vec![format!(
        "The best of {done}{}: run {} ({}).",
        counted(plan.runs.len(), "run"),
        i + 1,
        plan.words(i)
    )];
    for metric in &plan.sweep.metrics {
        let value = table
            .metric(i, metric)
            .map_or("not defined".to_owned(), |v| v.to_string());
        comments.push(format!("{metric} = {value}"));
    }
    if !plan.runs[i].parents.is_empty() {
        comments.push(format!(
            "These are from a warm start, which {RUNS}/{}/job.toml makes again. This job starts as the job file says, and may end elsewhere.",
            plan.runs[i].id
        ));
    }
    // Names of cases and values of axes are any text, and must not leave their line
    let comment = |text: &String| format!("# {}\n", one_line(text));
    let comments: String = comments.iter().map(comment).collect();
    Ok(comments + &spec.to_toml()?)
}

/// The runs of a share, with those that they start from; of runs with one job the first.
fn own_runs(plan: &SweepPlan, shard: Option<Shard>) -> BTreeSet<usize> {
    let Shard { number, shares } = shard.unwrap_or(Shard {
        number: 1,
        shares: 1,
    });
    let count = plan.runs.len();
    let firsts = firsts(&plan.runs);
    // Neighbors stay together, so that few are run by several
    let share = (number - 1) * count / shares..number * count / shares;
    let mut runs = BTreeSet::new();
    for i in share {
        let mut next = vec![firsts[i]];
        while let Some(i) = next.pop() {
            if runs.insert(i) {
                next.extend(plan.runs[i].parents.iter().map(|&parent| firsts[parent]));
            }
        }
    }
    runs
}

/// The runs that a run starts from, if none of them fails: the first of those with the same job, each once.
fn parents(plan: &SweepPlan, firsts: &[usize], i: usize) -> Vec<usize> {
    let mut parents = Vec::new();
    for parent in plan.runs[i].parents.iter().map(|&parent| firsts[parent]) {
        if !parents.contains(&parent) {
            parents.push(parent);
        }
    }
    parents
}

/// Whether a run is finished, started from these runs, with what others need of it.
fn is_ready(plan: &SweepPlan, i: usize, from: &[usize]) -> bool {
    let folder = plan.run_folder(i);
    if RunFolder::finished(&folder).is_none() || damage(plan, i).is_some() {
        return false;
    }
    let has = |name: &str| folder.join(name).exists();
    let has_all = match plan.sweep.spec.keep {
        Leaves::Metrics => true,
        Leaves::Patterns => has(PATTERNS),
        Leaves::All => has(PATTERNS) && has("report.html"),
    };
    let is_cold = plan.sweep.spec.warm_start.is_none();
    has_all && (is_cold || started_from(&folder) == Some(ids(plan, from)))
}

/// What is damaged in the folder of a run that has ended: its report, or arrays that were cut off.
fn damage(plan: &SweepPlan, i: usize) -> Option<Error> {
    let folder = plan.run_folder(i);
    RunFolder::finished(&folder)?;
    let arrays = [PATTERNS, "dose.npy"].map(|name| folder.join(name));
    let mut arrays = arrays.iter().filter(|file| file.exists());
    let is_whole = |()| arrays.try_for_each(|file| must_be_whole(file));
    read_report(&folder).map(drop).and_then(is_whole).err()
}

fn ids(plan: &SweepPlan, runs: &[usize]) -> Vec<String> {
    runs.iter().map(|&run| plan.runs[run].id.clone()).collect()
}

/// The runs whose patterns a run of this folder started from, by the job that it left; none where that cannot be read.
fn started_from(folder: &Path) -> Option<Vec<String>> {
    let job = Document::read(&folder.join("job.toml")).ok()?;
    let patterns = job.root.pointer("/start/patterns");
    let run_of = |file: &Value| {
        let folder = Path::new(file.as_str()?).parent()?;
        Some(folder.file_name()?.to_string_lossy().into_owned())
    };
    let files = patterns.into_iter().flat_map(|patterns| {
        let others = patterns["or"].as_array().into_iter().flatten();
        std::iter::once(&patterns["file"]).chain(others)
    });
    files.map(run_of).collect()
}

const PATTERNS: &str = "patterns.npz";

/// How long it takes.
struct Clock {
    begin: Instant,
    ended: usize,
    runs: usize,
    before: usize,
}

impl Clock {
    fn left_s(&self) -> f64 {
        let here = (self.ended - self.before).max(1);
        self.begin.elapsed().as_secs_f64() / here as f64 * (self.runs - self.ended) as f64
    }
}

/// Lets the slots work, tells what they tell, and passes requests to stop on to them.
fn on_slots(
    plan: &SweepPlan,
    turns: Vec<RunState>,
    watch: &mut dyn Watch,
    clock: &mut Clock,
    work: &Work,
) -> Result<()> {
    let slots = plan.side_by_side.clamp(1, clock.runs.max(1));
    let board = Board {
        turns,
        firsts: firsts(&plan.runs),
        stop: false,
    };
    let (board, news) = (Mutex::new(board), Condvar::new());
    let works: Vec<Mutex<Arc<Work>>> = (0..slots)
        .map(|_| Mutex::new(Arc::new(Work::new())))
        .collect();
    let asked = |times: u32| {
        lock(&board).stop = true;
        news.notify_all();
        for work in &works {
            let work = lock(work);
            for _ in 0..times {
                work.cancel();
            }
        }
    };
    let mut broken = None;
    thread::scope(|scope| {
        let (tell, messages) = channel();
        for (slot, work) in works.iter().enumerate() {
            let threads = (plan.threads / slots + usize::from(slot < plan.threads % slots)).max(1);
            let (tell, board, news) = (tell.clone(), &board, &news);
            scope.spawn(move || {
                Slot {
                    plan,
                    board,
                    news,
                    work,
                    tell,
                }
                .take_runs(threads)
            });
        }
        drop(tell);
        let mut passed = 0;
        loop {
            let wanted = if work.is_canceled() {
                2
            } else {
                u32::from(work.is_stop_asked())
            };
            if wanted > passed {
                asked(wanted - passed);
                passed = wanted;
            }
            match messages.recv_timeout(PAUSE) {
                Ok(Told::Ended {
                    run,
                    state,
                    seconds,
                }) => watch.event(&ended(plan, clock, run, &state, seconds)),
                Ok(Told::Broken(error)) => {
                    broken.get_or_insert(error);
                    asked(2);
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => break,
            }
        }
    });
    match broken {
        Some(error) => Err(error),
        None if work.is_stop_asked() => Err(Error::Canceled),
        None => Ok(()),
    }
}

fn ended(
    plan: &SweepPlan,
    clock: &mut Clock,
    run: usize,
    state: &State,
    seconds: f64,
) -> SweepEvent {
    clock.ended += 1;
    let (word, result) = match state {
        State::Done(values) => {
            let values = values.iter().map(|v| json!(v));
            let pairs = plan.sweep.metrics.iter().cloned().zip(values);
            ("done", table_of(pairs).into())
        }
        State::Failed(message) => ("failed", json!(message)),
        State::Missing => ("missing", Value::Null),
    };
    SweepEvent::Run {
        run: run + 1,
        values: plan.words(run),
        state: word,
        result,
        seconds,
        ended: clock.ended,
        runs: clock.runs,
        left_s: clock.left_s(),
    }
}

/// A poisoned lock's content is still what it was.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// One of the places at which runs work.
struct Slot<'a> {
    plan: &'a SweepPlan,
    board: &'a Mutex<Board>,
    news: &'a Condvar,
    work: &'a Mutex<Arc<Work>>,
    tell: Sender<Told>,
}

impl Slot<'_> {
    fn take_runs(&self, threads: usize) {
        let pool = match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
            Ok(pool) => pool,
            Err(e) => {
                let error = Error::config(
                    "--threads",
                    e.to_string(),
                    "a number of threads this machine can start",
                );
                let _ = self.tell.send(Told::Broken(error));
                return;
            }
        };
        let mut cache = RunCache::default();
        while let Some((i, from)) = self.next() {
            let begin = Instant::now();
            let run = || pool.install(|| self.run_one(i, &from, &mut cache));
            let ran = catch_unwind(AssertUnwindSafe(run));
            let ran = ran.unwrap_or_else(|panic| {
                let text = panic
                    .downcast_ref::<String>()
                    .cloned()
                    .or_else(|| panic.downcast_ref::<&str>().map(|t| (*t).to_owned()));
                Err(Error::unsupported(
                    "this job",
                    format!("a fault of Tomolith: {}", text.unwrap_or_default()),
                ))
            });
            let message = self.settle(i, ran, begin.elapsed().as_secs_f64());
            let turn = match &message {
                Some(Told::Ended {
                    state: State::Done(_),
                    ..
                }) => RunState::Done,
                Some(_) => RunState::Failed,
                None => RunState::Waits,
            };
            lock(self.board).turns[i] = turn;
            self.news.notify_all();
            if let Some(message) = message {
                let _ = self.tell.send(message);
            }
        }
    }

    /// The first run that waits and whose start is settled, and the runs that it may start from. Waits for one; none when all have ended.
    fn next(&self) -> Option<(usize, Vec<usize>)> {
        let mut board = lock(self.board);
        loop {
            if board.stop || !board.turns.contains(&RunState::Waits) {
                return None;
            }
            let found = (0..board.turns.len())
                .filter(|&i| board.turns[i] == RunState::Waits)
                .find_map(|i| Some((i, self.start_of(i, &board)?)));
            if let Some((i, from)) = found {
                board.turns[i] = RunState::Works;
                *lock(self.work) = Arc::new(Work::new());
                return Some((i, from));
            }
            board = self
                .news
                .wait(board)
                .unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// What a run may start from: its neighbors that did not fail, and in place of the nearest one that failed, the neighbor of that one. None until this is settled.
    fn start_of(&self, i: usize, board: &Board) -> Option<Vec<usize>> {
        let parents = |i: usize| self.plan.runs[i].parents.iter().map(|&p| board.firsts[p]);
        let mut from = Vec::new();
        for (k, parent) in parents(i).enumerate() {
            let mut next = Some(parent);
            while let Some(run) = next {
                next = match board.turns[run] {
                    RunState::Done => {
                        if !from.contains(&run) {
                            from.push(run);
                        }
                        None
                    }
                    RunState::Failed => parents(run).next().filter(|_| k == 0),
                    _ => return None,
                };
            }
        }
        Some(from)
    }

    fn run_one(&self, i: usize, from: &[usize], cache: &mut RunCache) -> Result<State> {
        let work = Arc::clone(&lock(self.work));
        loop {
            // Another process may have finished it meanwhile
            if is_ready(self.plan, i, from) {
                return state(self.plan, i);
            }
            let job = self.job(i, from)?;
            let leaves = self.plan.sweep.spec.keep;
            match job::run_here(&job, true, leaves, cache, &mut Silent, &work) {
                Ok(_) => return state(self.plan, i),
                Err(Error::Unsupported { reason, .. }) if reason == TAKEN => {
                    thread::sleep(BUSY);
                    if work.is_stop_asked() {
                        return Err(Error::Canceled);
                    }
                }
                Err(error) => return Err(error),
            }
        }
    }

    fn job(&self, i: usize, from: &[usize]) -> Result<Job> {
        let job = self.plan.job(i)?.overwriting();
        let files: Vec<PathBuf> = from
            .iter()
            .map(|&run| self.plan.run_folder(run).join(PATTERNS))
            .collect();
        let Some((first, others)) = files.split_first() else {
            return Ok(job);
        };
        let wanted = || parents(self.plan, &lock(self.board).firsts, i);
        let continued = self.plan.runs[i].continues && from == wanted();
        let mut job = job.starting_from(first, others, continued)?;
        if let Some(iterations) = self
            .plan
            .sweep
            .spec
            .warm_start
            .and_then(|warm| warm.iterations)
        {
            job.spec.stop.iterations = iterations;
        }
        Ok(job)
    }

    /// Notes a failure; what there is to tell, nothing where the run was stopped.
    fn settle(&self, run: usize, ran: Result<State>, seconds: f64) -> Option<Told> {
        let note = failure(self.plan, run);
        match ran {
            Ok(state) => {
                let _ = fs::remove_file(&note);
                Some(Told::Ended {
                    run,
                    state,
                    seconds,
                })
            }
            Err(Error::Canceled) => None,
            Err(error) => {
                let error = of_run(error);
                let text = json!({ "values": self.plan.words(run), "message": error.to_string() })
                    .to_string();
                match write_text(&note, &text) {
                    Ok(()) => Some(Told::Ended {
                        run,
                        state: State::Failed(error.to_string()),
                        seconds,
                    }),
                    Err(error) => Some(Told::Broken(error)),
                }
            }
        }
    }
}

/// What a plan is about, for people.
impl fmt::Display for SweepPlan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let memory = self
            .share_mb
            .map_or(String::new(), |mb| format!(", {mb} MB each"));
        write!(
            f,
            "{}, {} at a time{memory}",
            counted(self.runs.len(), "run"),
            self.side_by_side
        )
    }
}
