//! From a sweep file to its runs: every job read and checked, its identity, its share of the memory, where it starts.

use crate::axes::{self, SweepPoint, named};
use crate::file::Sweep;
use serde_json::Value;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use tomolith::io::{make_folder, read_text, write_text};
use tomolith::job::resources::memory_budget_mb;
use tomolith::job::{self, Job, RunFolder, Silent};
use tomolith::models::Work;
use tomolith::parallel::InParallel;
use tomolith::random::mixed;
use tomolith::{Error, Result};

/// Runs whose time is estimated, at most.
const ESTIMATES: usize = 3;

/// Errors that are shown, at most.
const MOST_ERRORS: usize = 20;

/// Why some of the runs cannot be.
struct Refusal {
    /// What the first of them met.
    error: Error,
    first: usize,
    /// How many there are.
    count: usize,
}

/// Notes why a run cannot be. The same key that should be the same, whatever the numbers, is one reason.
fn note(refusals: &mut Vec<Refusal>, run: usize, error: Error) {
    let same = reason(&error);
    match refusals
        .iter_mut()
        .find(|known| reason(&known.error) == same)
    {
        Some(known) => known.count += 1,
        None => refusals.push(Refusal {
            error,
            first: run,
            count: 1,
        }),
    }
}

fn reason(error: &Error) -> (Option<String>, String) {
    let (key, words) = match error {
        Error::Config { key, accepted, .. } => (Some(key.clone()), accepted.clone()),
        other => (None, other.to_string()),
    };
    (
        key,
        words.replace(|c: char| c.is_ascii_digit() || c == '.', ""),
    )
}

/// A run.
#[derive(Clone, Debug)]
pub struct Planned {
    /// Where it lies.
    pub point: SweepPoint,
    /// Its identity, the name of its folder.
    pub id: String,
    /// The runs that it may start from, nearest first.
    pub parents: Vec<usize>,
    /// Whether the last of them is there for the step from it to the one before, which leads from the nearest to this run.
    pub continues: bool,
}

/// All runs of a sweep, checked.
#[derive(Clone, Debug)]
pub struct SweepPlan {
    pub(crate) sweep: Sweep,
    /// The runs, in the order of the table.
    pub runs: Vec<Planned>,
    /// How many work at a time.
    pub side_by_side: usize,
    /// Threads of them all.
    pub threads: usize,
    /// Memory of one, MB; none where neither job nor system say.
    pub share_mb: Option<u64>,
}

impl Sweep {
    /// Reads and checks every job, and settles where each starts and what it may use of so many threads.
    ///
    /// # Errors
    /// [`Error::Config`] for conditions that leave nothing, for more runs than can be, and for jobs that cannot run, before any does;
    /// [`Error::Canceled`].
    pub fn plan(self, threads: usize, work: &Work) -> Result<SweepPlan> {
        self.must_be_a_folder()
            .map_err(|e| self.document.locate(e))?;
        let points = self.points(work).map_err(|e| self.document.locate(e))?;
        let given = self.spec.resources.memory_gb;
        let of_job = self
            .base
            .root
            .pointer("/resources/memory_gb")
            .and_then(Value::as_f64);
        let budget_mb = match given.or(of_job) {
            None => memory_budget_mb(None).map(|mb| mb / self.neighbors as u64),
            given => memory_budget_mb(given),
        };
        let wanted = self.spec.resources.side_by_side;
        let first_mb = budget_mb.map(|mb| mb / wanted.unwrap_or(1) as u64);
        let checked: Vec<Result<(String, u64)>> = points
            .iter()
            .par_map(|point| self.check(point, first_mb, budget_mb, work));
        if checked
            .iter()
            .any(|one| matches!(one, Err(Error::Canceled)))
        {
            return Err(Error::Canceled);
        }
        let mut sound = Vec::with_capacity(points.len());
        let mut refusals: Vec<Refusal> = Vec::new();
        for (run, one) in checked.into_iter().enumerate() {
            match one {
                Ok(one) => sound.push(one),
                Err(Error::Several(several)) => {
                    several
                        .into_iter()
                        .for_each(|error| note(&mut refusals, run, error));
                }
                Err(error) => note(&mut refusals, run, error),
            }
        }
        let refusals = refusals.into_iter().take(MOST_ERRORS);
        let locate = |refusal| self.document.locate(self.refused(&points, refusal));
        let mut errors: Vec<Error> = refusals.map(locate).collect();
        match errors.len() {
            0 => {}
            1 => return Err(errors.remove(0)),
            _ => return Err(Error::Several(errors)),
        }
        let largest_mb = sound.iter().map(|(_, mb)| *mb).max().unwrap_or(1).max(1);
        let holds = budget_mb.map_or(usize::MAX, |mb| (mb / largest_mb) as usize);
        let side_by_side = wanted.unwrap_or(threads.min(holds)).clamp(1, points.len());
        let runs = self.settle(points, sound.into_iter().map(|(id, _)| id).collect());
        Ok(SweepPlan {
            sweep: self,
            runs,
            side_by_side,
            threads,
            share_mb: budget_mb.map(|mb| mb / side_by_side.max(wanted.unwrap_or(1)) as u64),
        })
    }

    /// Refuses a folder that is a file or holds a run.
    fn must_be_a_folder(&self) -> Result<()> {
        let folder = self.folder();
        let refuse = |found, accepted| Err(Error::config("folder", found, accepted));
        let runs = folder.join(RUNS);
        if let Some(file) = runs.ancestors().find(|path| path.is_file()) {
            let found = format!("`{}` is a file", file.display());
            return refuse(found, "a folder, or a name where none is yet");
        }
        if RunFolder::finished(&folder).is_some() {
            let found = format!("`{}` is the folder of a run", folder.display());
            return refuse(found, "the folder of a sweep, or a new name");
        }
        Ok(())
    }

    /// The sweep file whose results a folder holds, where that is another one and still there.
    fn other_owner(&self, folder: &Path) -> Option<PathBuf> {
        let noted: Value = serde_json::from_str(&read_text(folder.join(OWNER)).ok()?).ok()?;
        let file = PathBuf::from(noted["sweep"].as_str()?);
        let is_other = file.canonicalize().ok()? != self.document.file.canonicalize().ok()?;
        is_other.then_some(file)
    }

    /// Notes in the folder of the results whose they are; refuses those of another sweep, and a folder of something else.
    pub(crate) fn claim(&self, folder: &Path) -> Result<()> {
        must_be_made_for_results("folder", folder, OWNER).map_err(|e| self.document.locate(e))?;
        if let Some(other) = self.other_owner(folder) {
            let (folder, other) = (folder.display(), other.display());
            let found = format!("`{folder}` holds the sweep of `{other}`");
            let accepted = "a folder of its own: --output DIR, or `folder` in the sweep file";
            return Err(self
                .document
                .locate(Error::config("folder", found, accepted)));
        }
        make_folder(folder)?;
        let file = &self.document.file;
        let file = std::path::absolute(file).unwrap_or_else(|_| file.clone());
        let text = serde_json::json!({ "sweep": file }).to_string();
        write_text(&folder.join(OWNER), &text)
    }

    /// The points; where they are too many, with the time they would take.
    fn points(&self, work: &Work) -> Result<Vec<SweepPoint>> {
        let one_s = || self.seconds(work);
        axes::points(&self.axes, &self.when, self.spec.sample, &one_s)
    }

    /// How long one run takes, where the first point's job can be run.
    fn seconds(&self, work: &Work) -> Option<f64> {
        let values: Vec<Value> = self.axes.iter().map(|axis| axis.drawn(0.0)).collect();
        let point = SweepPoint {
            place: vec![0.0; values.len()],
            values,
            index: None,
        };
        let plan = job::check(&self.job(&point).ok()?, &mut Silent, work).ok()?;
        Some(plan.seconds)
    }

    /// Identity and memory of a job that can run with its share of the budget.
    fn check(
        &self,
        point: &SweepPoint,
        share_mb: Option<u64>,
        budget_mb: Option<u64>,
        work: &Work,
    ) -> Result<(String, u64)> {
        if work.is_stop_asked() {
            return Err(Error::Canceled);
        }
        for (key, expression) in &self.derived {
            let value = expression.value(&|name| named(&self.axes, point, name));
            if let Some(value) = value.filter(|value| !value.is_finite()) {
                return Err(Error::config(
                    format!("derived.{key}"),
                    format!("{value} at {}", self.words(point)),
                    "a finite number in every run; leave others out with `when`",
                ));
            }
        }
        let job = self.job(point)?;
        let id = job.identity()?;
        let mut job = job.with_folder(&self.folder().join(RUNS).join(&id), "sweep");
        let mut requirements_with = |mb: Option<u64>| {
            job.spec.resources.memory_gb = mb.map(gigabytes);
            job::requirements(&job)
        };
        let requirements = requirements_with(share_mb).map_err(|error| {
            let alone = share_mb.zip(budget_mb).filter(|(share, all)| share < all);
            match alone
                .and_then(|(share, all)| Some((share, all, requirements_with(Some(all)).ok()?)))
            {
                Some((share, all, requirements)) => {
                    too_many_at_a_time(share, all, requirements.memory_mb)
                }
                None => error,
            }
        })?;
        Ok((id, requirements.memory_mb))
    }

    /// Says which jobs cannot run for a reason, and why the first cannot; at the key of the sweep that is at fault.
    fn refused(&self, points: &[SweepPoint], refusal: Refusal) -> Error {
        let Refusal {
            mut error,
            first,
            count,
        } = refusal;
        // It names its run, and the key of the sweep
        if matches!(&error, Error::Config { key, .. } if key.starts_with("derived.")) {
            return error;
        }
        // No axis is at fault where the folder of a run is
        if let Error::Config {
            key,
            found,
            accepted,
            ..
        } = &error
            && key == "output.folder"
        {
            let found = without_option(found);
            return Error::config("folder", found, format!("for a run {accepted}"));
        }
        let text = error.to_string();
        let key = match &error {
            Error::Config { key, found, .. } => self.at_fault(key, found),
            _ => None,
        };
        if let (Error::Config { accepted, .. }, Some(key)) = (&mut error, &key)
            && accepted.starts_with(WHOLE)
            && self.is_of_range(key, &points[first])
        {
            accepted.push_str(" (a range with whole = true rounds its values)");
        }
        let is_all = count == points.len();
        match (error, key) {
            // The job file itself is at fault
            (error, None) if is_all => of_run(error),
            (
                Error::Config {
                    key: blamed,
                    accepted,
                    nearest,
                    found,
                    ..
                },
                Some(key),
            ) if is_all => {
                let found = without_option(&found).to_owned();
                let found = match blamed.starts_with("--set ") {
                    true => found,
                    false => format!("`{blamed}`: {found}"),
                };
                Error::Config {
                    key,
                    found,
                    accepted,
                    nearest,
                    place: None,
                }
            }
            (error, key) => {
                let accepted = match error {
                    Error::Config { accepted, .. } => {
                        format!("in every run {accepted}; or leave such runs out with `when`")
                    }
                    _ => "values that make sound jobs; leave others out with `when`".to_owned(),
                };
                let runs = format!(
                    "{count} of {} jobs cannot run; the first is run {} ({})",
                    points.len(),
                    first + 1,
                    self.words(&points[first])
                );
                Error::config(
                    key.unwrap_or_else(|| "axes".to_owned()),
                    format!("{runs}: {}", without_option(&text)),
                    accepted,
                )
            }
        }
    }

    /// Whether a key is that of an axis with a range, which has no whole number at a point.
    fn is_of_range(&self, key: &str, point: &SweepPoint) -> bool {
        let values = self.spec.axes.iter().zip(&point.values).enumerate();
        let mut ranges = values.filter(|(_, (axis, value))| {
            value.is_f64() && (axis.linear.is_some() || axis.log.is_some())
        });
        ranges.any(|(i, _)| key == format!("axes[{i}].key"))
    }

    /// The key of the sweep that set a key of the job which is at fault.
    fn at_fault(&self, key: &str, found: &str) -> Option<String> {
        let assignment = match key.strip_prefix("--set ") {
            Some(assignment) => assignment,
            None => {
                let mut parts = OPTIONS.iter().filter_map(|from| found.split_once(from));
                parts.next()?.1
            }
        };
        let set = assignment.split('=').next()?;
        let is_set = |value: &Value| {
            let rest = assignment.strip_prefix(self.change(set, value).as_str());
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(')'))
        };
        let of_axis = self.axes.iter().enumerate().find_map(|(i, axis)| {
            let path = axis.path_of(set, is_set)?;
            Some(format!("axes[{i}].{path}"))
        });
        let of_derived = || {
            self.spec
                .derived
                .contains_key(set)
                .then(|| format!("derived.{set}"))
        };
        of_axis.or_else(of_derived).or_else(|| {
            self.spec
                .set
                .contains_key(set)
                .then(|| format!("set.{set}"))
        })
    }

    /// The runs, each with those that it may start from.
    fn settle(&self, points: Vec<SweepPoint>, ids: Vec<String>) -> Vec<Planned> {
        let parents = match self.spec.warm_start {
            Some(_) => parents(&points, self.axes.len()),
            None => vec![(Vec::new(), false); points.len()],
        };
        let mut runs: Vec<Planned> = Vec::with_capacity(points.len());
        for ((point, id), (parents, continues)) in points.into_iter().zip(ids).zip(parents) {
            let id = (parents.iter()).fold(id, |id, &from| self.warm_id(&id, &runs[from].id));
            runs.push(Planned {
                point,
                id,
                parents,
                continues,
            });
        }
        runs
    }

    /// The identity of a job that starts from another's patterns.
    fn warm_id(&self, id: &str, from: &str) -> String {
        let number = |id: &str| u64::from_str_radix(id, 16).unwrap_or(0);
        let iterations = self
            .spec
            .warm_start
            .and_then(|warm| warm.iterations)
            .map_or(u64::MAX, |n| n as u64);
        format!(
            "{:016x}",
            mixed(number(id) ^ mixed(number(from) ^ mixed(iterations ^ STARTS)))
        )
    }
}

impl SweepPlan {
    /// Seconds that the runs take which are not finished, on all cores: the mean of a few that are spread over the table, times their number.
    ///
    /// # Errors
    /// As [`job::check`].
    pub fn seconds(&self, work: &Work) -> Result<f64> {
        let left: Vec<usize> = (0..self.runs.len())
            .filter(|&i| RunFolder::finished(&self.run_folder(i)).is_none())
            .collect();
        let asked = left.len().min(ESTIMATES);
        let mut seconds = 0.0;
        for k in 0..asked {
            let job = self.job(left[k * left.len() / asked])?;
            seconds += job::check(&job, &mut Silent, work)?.seconds / asked as f64;
        }
        Ok(seconds * left.len() as f64)
    }

    /// The metric by which the best run is chosen.
    #[must_use]
    pub fn ranked_by(&self) -> &str {
        &self.sweep.best.metric
    }

    /// Where results go.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        self.sweep.folder()
    }

    /// The folder of a run.
    #[must_use]
    pub fn run_folder(&self, i: usize) -> PathBuf {
        self.folder().join(RUNS).join(&self.runs[i].id)
    }

    /// A run's values, for people.
    #[must_use]
    pub fn words(&self, i: usize) -> String {
        self.sweep.words(&self.runs[i].point)
    }

    /// A run's job, with its folder and its share of the memory, which starts as the job file says.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub fn job(&self, i: usize) -> Result<Job> {
        let mut job = self
            .sweep
            .job(&self.runs[i].point)?
            .with_folder(&self.run_folder(i), "sweep");
        job.spec.resources.memory_gb = self.share_mb.map(gigabytes);
        Ok(job)
    }

    /// One command a run, in the order of the table, for a shell.
    ///
    /// # Errors
    /// [`Error::Config`] for warm starts: a list has no order.
    pub fn commands(&self) -> Result<Vec<String>> {
        if self.sweep.spec.warm_start.is_some() {
            let accepted = "--shard I/N, which keeps the order; or a sweep without [warm_start]";
            return Err(Error::config(
                "--list",
                "a list has no order, and with [warm_start] a run needs the one that it starts from",
                accepted,
            ));
        }
        let command = |i: usize| {
            let (job, changes) = self.sweep.changes(&self.runs[i].point);
            let mut words = vec![
                "tomolith".to_owned(),
                "run".to_owned(),
                quoted(&job.to_string_lossy()),
            ];
            let share = self
                .share_mb
                .map(|mb| format!("resources.memory_gb={}", gigabytes(mb)));
            for change in changes.iter().chain(&share) {
                words.extend(["--set".to_owned(), quoted(change)]);
            }
            let folder = quoted(&self.run_folder(i).to_string_lossy());
            words.extend([
                "--output".to_owned(),
                folder,
                "--keep".to_owned(),
                self.sweep.spec.keep.name().to_owned(),
                "--resume".to_owned(),
            ]);
            words.join(" ")
        };
        Ok((0..self.runs.len()).map(command).collect())
    }
}

/// How what is accepted begins where a key takes whole numbers.
const WHOLE: &str = "a whole number";

/// How an error names the option of the command line that set a key, or set something that conflicts with it.
const OPTIONS: [&str; 2] = [" (from --set ", " (with --set "];

/// What was found, without the option that it is from: one of an axis, or the folder of a run.
fn without_option(found: &str) -> &str {
    let starts = OPTIONS.into_iter().chain([" (from sweep "]);
    let start = starts.filter_map(|from| found.find(from)).min();
    &found[..start.unwrap_or(found.len())]
}

/// An error of a run's job without the options that set its keys: nobody typed them.
pub(crate) fn of_run(mut error: Error) -> Error {
    if let Error::Config { key, found, .. } = &mut error {
        *found = without_option(found).to_owned();
        if let Some(assignment) = key.strip_prefix("--set ") {
            *key = assignment.split('=').next().unwrap_or_default().to_owned();
        }
    }
    error
}

/// Runs whose starts were chosen otherwise have other identities: scaled (1 << 63), continued.
const STARTS: u64 = 3 << 62;

/// Says whose results a folder holds.
const OWNER: &str = "sweep.json";

/// Refuses a folder that holds something, and neither the file that says whose results it holds nor runs alone.
pub(crate) fn must_be_made_for_results(key: &str, folder: &Path, owner: &str) -> Result<()> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<_> = entries.map(|entry| entry.file_name()).collect();
    names.sort();
    match names.iter().find(|name| **name != RUNS) {
        Some(other) if !names.iter().any(|name| *name == owner) => {
            let (folder, other) = (folder.display(), other.to_string_lossy());
            let found = format!("`{folder}` holds files that are no results, such as `{other}`");
            Err(Error::config(key, found, "a new folder, or an empty one"))
        }
        _ => Ok(()),
    }
}

/// Folder of the runs in the sweep's.
pub(crate) const RUNS: &str = "runs";

fn gigabytes(mb: u64) -> f64 {
    mb as f64 / 1e3
}

/// A run that the whole budget holds, and its share does not.
fn too_many_at_a_time(share_mb: u64, budget_mb: u64, needs_mb: u64) -> Error {
    let most = (budget_mb / needs_mb.max(1)).max(1);
    Error::config(
        "resources.side_by_side",
        format!("{share_mb} MB are left for each run, and one needs about {needs_mb} MB"),
        format!("up to {most} at a time in {budget_mb} MB; or a larger resources.memory_gb"),
    )
}
/// Runs that another may start from, and whether the last of them is only there for a step; see [`Planned`].
type Parents = (Vec<usize>, bool);

/// For each point so many of those before it, the nearest first; of equally near ones the first. One more follows where a point before it lies as far from
/// the last of them as this one lies from the nearest, in the same direction.
fn parents(points: &[SweepPoint], count: usize) -> Vec<Parents> {
    let nearest = |i: usize| {
        let mut nearest: Vec<(f64, usize)> = Vec::with_capacity(count + 1);
        for j in 0..i {
            let distance = apart(&points[i].place, &points[j].place);
            let at = nearest.partition_point(|(other, _)| *other <= distance);
            if at < count {
                nearest.insert(at, (distance, j));
                nearest.truncate(count);
            }
        }
        let mut parents: Vec<usize> = nearest.into_iter().map(|(_, j)| j).collect();
        let step = step_to(points, i, &parents);
        if let Some([from, to]) = step {
            parents.retain(|&parent| parent != to);
            parents.extend([to, from]);
        }
        (parents, step.is_some())
    };
    (0..points.len()).par_map(nearest)
}

/// A parent other than the nearest, where there is one, and the point from which the step to it is that from the nearest to the point.
fn step_to(points: &[SweepPoint], i: usize, parents: &[usize]) -> Option<[usize; 2]> {
    let place = |j: usize| points[j].place.as_slice();
    let (&nearest, others) = parents.split_first()?;
    let step = |&to: &usize| {
        let places = place(to).iter().zip(place(nearest)).zip(place(i));
        let begin: Vec<f64> = places
            .map(|((to, near), here)| to - (here - near))
            .collect();
        let from = (0..i).find(|&from| apart(place(from), &begin) == 0.0)?;
        Some([from, to])
    };
    let ends = if others.is_empty() { parents } else { others };
    let length = |&[from, _]: &[usize; 2]| apart(place(from), place(i));
    let steps = ends.iter().filter_map(step);
    steps.min_by(|a, b| length(a).total_cmp(&length(b)))
}

/// The square of a distance.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
    // Rounding of places must not choose among equals
    (squares.sum::<f64>() * 1e9).round()
}

/// For each run the first one with the same job.
pub(crate) fn firsts(runs: &[Planned]) -> Vec<usize> {
    let mut seen = HashMap::new();
    runs.iter()
        .enumerate()
        .map(|(i, run)| *seen.entry(run.id.as_str()).or_insert(i))
        .collect()
}
/// A word for a shell.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=,+:@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(place: &[f64]) -> SweepPoint {
        SweepPoint {
            values: Vec::new(),
            place: place.to_vec(),
            index: None,
        }
    }

    #[test]
    fn a_run_starts_from_its_nearest_neighbor_before_it() {
        let third = 1.0 / 3.0;
        let points = [
            [0.0, 0.0],
            [0.0, third],
            [third, 0.0],
            [third, third],
            [1.0, 0.0],
            [2.0 * third, third],
        ]
        .map(|p| at(&p));
        // (⅓, ⅓) is as far from (0, ⅓) as from (⅓, 0): the first of both
        let alone = |runs: &[usize]| (runs.to_vec(), false);
        let begun = [&[][..], &[0], &[0], &[1], &[2]].map(alone);
        assert_eq!(parents(&points, 1)[..5], begun);
        let steps = [
            alone(&[]),
            alone(&[0]),
            alone(&[0, 1]),
            // From (⅓, 0) by the step from (0, 0) to (0, ⅓)
            (vec![1, 2, 0], true),
            alone(&[2, 3]),
            // From (⅓, ⅓) on, as far as from (0, 0) to (⅓, 0)
            (vec![3, 2, 0], true),
        ];
        assert_eq!(parents(&points, 2), steps);
        // Along one axis a step like the last one
        let line = [0.0, 0.25, 0.5, 1.0].map(|place| at(&[place]));
        let ahead = |to, from| (vec![to, from], true);
        let along = [alone(&[]), alone(&[0]), ahead(1, 0), ahead(2, 0)];
        assert_eq!(parents(&line, 1), along);
    }

    #[test]
    fn an_error_of_a_run_tells_no_option_that_nobody_typed() {
        let message = |key: &str, found: &str| of_run(Error::config(key, found, "3")).to_string();
        assert_eq!(
            message("grid.pitch_mm", "found 2 (from --set grid.pitch_mm=2)"),
            "grid.pitch_mm: found 2; accepted: 3"
        );
        assert_eq!(
            message("target", "too large (with --set grid.pitch_mm=50)"),
            "target: too large; accepted: 3"
        );
        assert_eq!(
            message("--set light[3].angles=12", "has 1 element"),
            "light[3].angles: has 1 element; accepted: 3"
        );
    }

    #[test]
    fn words_survive_the_shell() {
        assert_eq!(quoted("out/a-b=1"), "out/a-b=1");
        assert_eq!(quoted("it's {}"), "'it'\\''s {}'");
    }
}
