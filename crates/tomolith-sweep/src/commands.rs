//! Commands of a study: the folders of runs that their words name, checked before any work, and filled in after it.

use crate::plan::SweepPlan;
use crate::study::{RunSpec, Study, StudySpec};
use std::collections::BTreeMap;
use tomolith::job::Leaves;
use tomolith::{Error, Result};

/// A folder that a word names: `{NAME}` is that of a job, `{NAME[2]}` that of a sweep's third run.
struct Reference<'w> {
    /// What stands between the braces.
    text: &'w str,
    name: &'w str,
    index: Option<&'w str>,
    /// What follows the folder, up to what no file's name has.
    file: Option<&'w str>,
}

impl<'w> Reference<'w> {
    fn new(text: &'w str, after: &'w str) -> Self {
        let indexed = text.strip_suffix(']').and_then(|rest| rest.split_once('['));
        let (name, index) = indexed.map_or((text, None), |(name, index)| (name, Some(index)));
        let file = after.strip_prefix('/').map(|file| {
            let ends = |c: char| c.is_whitespace() || "\"'{},;:=".contains(c);
            file.split(ends).next().unwrap_or_default()
        });
        Reference {
            text,
            name,
            index,
            file: file.filter(|file| !file.is_empty()),
        }
    }

    /// A file that the folder of a run which leaves so much never holds, and those that it holds.
    fn missing(&self, keep: Leaves) -> Option<(&'w str, String)> {
        let left: &[&str] = match keep {
            Leaves::Metrics => &LEFT[..3],
            Leaves::Patterns => &LEFT,
            // What a whole run folder holds depends on its job
            Leaves::All => return None,
        };
        let file = self.file.filter(|file| !left.contains(file))?;
        Some((file, left.join(", ")))
    }

    /// Which run; none where the index is no number.
    fn run(&self) -> Option<usize> {
        self.index.map_or(Some(0), |index| index.parse().ok())
    }
}

/// The files of a run that leaves numbers and patterns; without patterns all but the last.
const LEFT: [&str; 4] = ["job.toml", "report.json", "history.csv", "patterns.npz"];

/// The references of a word. Braces of inline tables, which are empty or hold `=`, are none.
fn references(word: &str) -> impl Iterator<Item = Reference<'_>> {
    let within = word.split('{').skip(1);
    let within = within.filter_map(|rest| rest.split_once('}'));
    let named = within.filter(|(text, _)| !text.trim().is_empty() && !text.contains('='));
    named.map(|(text, after)| Reference::new(text, after))
}

impl RunSpec {
    /// The names of the runs whose folders its command reads.
    pub(crate) fn reads(&self) -> impl Iterator<Item = &str> {
        let words = self.command.iter().flatten();
        words.flat_map(|word| references(word).map(|reference| reference.name))
    }
}

/// Refuses words that name the folder of no job and no sweep. Commands work last, side by side with none, so that none reads another's folder.
pub(crate) fn check(spec: &StudySpec) -> Result<()> {
    each(spec, |reference| match spec.runs.get(reference.name) {
        None => Err("no run has this name".to_owned()),
        Some(run) if run.command.is_some() => {
            let name = reference.name;
            Err(format!(
                "`{name}` is a command, and a command reads no other one's folder"
            ))
        }
        Some(_) if reference.run().is_none() => Err("the index is no whole number".to_owned()),
        Some(_) => Ok(()),
    })
    .map_err(|(at, found)| {
        let runs = spec.runs.iter().filter(|(_, run)| run.command.is_none());
        let names: Vec<&str> = runs.map(|(name, _)| name.as_str()).collect();
        let accepted = "the folder of a job, {NAME}, or of a run of a sweep, {NAME[0]}";
        Error::config(at, found, format!("{accepted}: {}", names.join(", ")))
    })
}

impl Study {
    /// Refuses words that name a run which its sweep does not have, at this size.
    pub(crate) fn must_have_runs(&self, plans: &BTreeMap<&str, &SweepPlan>) -> Result<()> {
        each(&self.spec, |reference| {
            let Some(plan) = plans.get(reference.name) else {
                return Ok(());
            };
            let count = plan.runs.len();
            if let Some((file, left)) = reference.missing(plan.sweep.spec.keep) {
                return Err(format!(
                    "its folder has no `{file}`, only {left} (keep = \"all\" in the sweep leaves more)"
                ));
            }
            match reference.index {
                None if count > 1 => Err(format!("a sweep of {count} runs, and not which of them")),
                _ if reference.run().is_some_and(|run| run < count) => Ok(()),
                _ => Err(format!("the last run is {{{}[{}]}}", reference.name, count - 1)),
            }
        })
        .map_err(|(at, found)| {
            let accepted = "a run of this size, counted from 0; or quick = { skip = true } where the quick size has none such";
            self.document.locate(Error::config(at, found, accepted))
        })
    }

    /// An error about a command, whose key is one of the command's run, at its place in the study.
    pub(crate) fn at_command(&self, name: &str, mut error: Error) -> Error {
        if let Error::Config { key, .. } = &mut error {
            *key = format!("runs.{name}.{key}");
        }
        self.document.locate(error)
    }
}

/// Looks at every reference of every command; the key and the words of the first that is not sound.
fn each(
    spec: &StudySpec,
    look: impl Fn(&Reference<'_>) -> Result<(), String>,
) -> Result<(), (String, String)> {
    for (name, run) in &spec.runs {
        for (k, word) in run.command.iter().flatten().enumerate() {
            for reference in references(word) {
                look(&reference).map_err(|found| {
                    let at = format!("runs.{name}.command[{k}]");
                    (at, format!("`{{{}}}`: {found}", reference.text))
                })?;
            }
        }
    }
    Ok(())
}

/// The words of a command with the folders that they name.
pub(crate) fn filled_in(words: &[String], plans: &BTreeMap<&str, &SweepPlan>) -> Vec<String> {
    let fill = |word: &String| {
        let mut filled = word.clone();
        for reference in references(word) {
            if let (Some(plan), Some(run)) = (plans.get(reference.name), reference.run()) {
                let folder = plan.run_folder(run);
                let folder = std::path::absolute(&folder).unwrap_or(folder);
                let braces = format!("{{{}}}", reference.text);
                filled = filled.replace(&braces, &folder.to_string_lossy());
            }
        }
        filled
    };
    words.iter().map(fill).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn braces_of_inline_tables_name_no_run() {
        let names = |word: &'static str| {
            let found = references(word).map(|reference| (reference.name, reference.run()));
            found.collect::<Vec<_>>()
        };
        assert_eq!(names("model={wave={error=1e-3,other=0.03}}"), []);
        assert_eq!(names("objective={l2={}}"), []);
        assert_eq!(names("{rays[2]}/job.toml"), [("rays", Some(2))]);
        let files = |word: &'static str| {
            let found = references(word).map(|reference| reference.missing(Leaves::Patterns));
            found
                .map(|missing| missing.map(|(file, _)| file))
                .collect::<Vec<_>>()
        };
        assert_eq!(files("{a}/patterns.npz {b}"), [None, None]);
        assert_eq!(
            files("start={patterns={file=\"{a}/pattern.npz\"}}"),
            [Some("pattern.npz")]
        );
        assert_eq!(
            names("target={mesh=\"{a-b}/x.stl\"} {c[d]}"),
            [("a-b", Some(0)), ("c", None)]
        );
    }
}
