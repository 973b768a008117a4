//! Profiles: machines and resins by name, so that a job need not repeat their numbers.
//!
//! ```toml
//! printer = "opencal"                                        # all keys of the profile
//! resin = { profile = "sr399-tpo", scattering_per_mm = 0.1 } # and some that differ
//! printer = "our-printer.toml"                               # a file of one's own, relative to the job, with the keys of the table; files that
//!                                                            # it names are relative to it
//! ```
//!
//! A job is read with the numbers of its profiles in place, and the `job.toml` of a run has these numbers alone, so that it runs anywhere and whatever
//! becomes of a profile.

use super::document::Document;
use super::job_files::make_absolute;
use crate::error::{Error, Result, nearest_name};
use crate::io::read_text;
use serde_json::{Map, Value, json};
use std::path::Path;

/// A profile that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Profile {
    /// The table of a job that it fills.
    pub table: &'static str,
    /// Its name in a job.
    pub name: &'static str,
    /// Its file: what it is and where its numbers come from, in comments, and its keys in TOML.
    pub text: &'static str,
}

/// Profiles that come with the program.
pub const PROFILES: [Profile; 4] = [
    Profile {
        table: "printer",
        name: "opencal",
        text: include_str!("../../../profiles/printer/opencal.toml"),
    },
    Profile {
        table: "printer",
        name: "vialux-v7001-1to1",
        text: include_str!("../../../profiles/printer/vialux-v7001-1to1.toml"),
    },
    Profile {
        table: "resin",
        name: "sr399-tpo",
        text: include_str!("../../../profiles/resin/sr399-tpo.toml"),
    },
    Profile {
        table: "resin",
        name: "sr399-tpo-tio2",
        text: include_str!("../../../profiles/resin/sr399-tpo-tio2.toml"),
    },
];

/// Tables that may name one.
pub(crate) const TABLES: [&str; 2] = ["printer", "resin"];

impl Profile {
    /// What it is: the first line of its file.
    #[must_use]
    pub fn summary(&self) -> &'static str {
        let first = self.text.lines().next().unwrap_or_default();
        first.trim_start_matches(['#', ' '])
    }
}

/// Makes a table of a name, so that other keys can be set in it.
pub(crate) fn open(root: &mut Value) {
    for table in TABLES {
        if let Some(value @ Value::String(_)) = root.get_mut(table) {
            *value = json!({ "profile": value.take() });
        }
    }
}

/// Puts the numbers of profiles in place of their names; keys of the job stand above those of the profile. Refuses a profile of the command line that changes
/// nothing, because the job's file has all of its keys; `is_option` says which keys come from there.
pub(crate) fn fill(root: &mut Value, base: &Path, is_option: impl Fn(&str) -> bool) -> Result<()> {
    open(root);
    for table in TABLES {
        let Some(value) = root.get_mut(table) else {
            continue;
        };
        let Some(name) = value
            .as_object_mut()
            .and_then(|keys| keys.remove("profile"))
        else {
            continue;
        };
        let given = value.as_object().cloned().unwrap_or_default();
        let Some(name) = name.as_str() else {
            let found = format!("found {name}");
            return Err(Error::config(
                format!("{table}.profile"),
                found,
                accepted(table),
            ));
        };
        let mut keys = keys_of(table, name, base)?;
        let is_of_file =
            |key: &String| given.contains_key(key) && !is_option(&format!("{table}.{key}"));
        if is_option(&format!("{table}.profile")) && keys.keys().all(is_of_file) {
            return Err(Error::config(
                format!("{table}.profile"),
                format!(
                    "the job has all keys of {name:?}, which stand above those of a profile: it would change nothing"
                ),
                format!(
                    "`--set {table}=\"{name}\"`, which takes the profile in place of the job's table"
                ),
            ));
        }
        keys.extend(given);
        *value = Value::Object(keys);
    }
    Ok(())
}

/// The keys of a profile: one that comes with the program, or a file of one's own.
fn keys_of(table: &str, name: &str, base: &Path) -> Result<Map<String, Value>> {
    let known = PROFILES.iter().filter(|profile| profile.table == table);
    if let Some(profile) = known.clone().find(|profile| profile.name == name) {
        return read(Path::new(name), profile.text.to_owned());
    }
    if Path::new(name)
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("toml"))
    {
        let path = base.join(name);
        let mut keys = read(&path, read_text(&path)?)?;
        // With its header, or as the table of a job
        let mut keys = match keys.remove(table) {
            Some(Value::Object(of_table)) => of_table,
            _ => keys,
        };
        let folder = path.parent().unwrap_or(Path::new("."));
        make_absolute(&mut keys, folder);
        return Ok(keys);
    }
    Err(Error::Config {
        key: table.to_owned(),
        found: format!("no profile has the name {name:?}"),
        accepted: accepted(table),
        nearest: nearest_name(name, known.map(|profile| profile.name)).map(str::to_owned),
        place: None,
    })
}

fn read(file: &Path, text: String) -> Result<Map<String, Value>> {
    match Document::toml(file, text)?.root {
        Value::Object(keys) => Ok(keys),
        _ => Ok(Map::new()),
    }
}

fn accepted(table: &str) -> String {
    let known = PROFILES.iter().filter(|profile| profile.table == table);
    let names: Vec<&str> = known.map(|profile| profile.name).collect();
    format!(
        "{}; a file `NAME.toml` with [{table}] or its keys; or the table itself",
        names.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use crate::job::tests::FULL;

    fn job(changes: &[&str], base: &Path) -> Result<Job> {
        let without = FULL.replace("[resin]\nrefractive_index = 1.4849\nabsorption_per_mm = 0.054\nattenuation_per_mm = 0.06\n", "");
        let document = Document::toml(base.join("a.toml"), without)?;
        let changes: Vec<String> = changes.iter().map(|&change| change.to_owned()).collect();
        Job::changed(document, &changes)
    }

    #[test]
    fn a_profile_fills_what_the_job_does_not_say() {
        let place = tempfile::tempdir().unwrap();
        let named = job(
            &["resin=\"sr399-tpo\"", "printer=\"opencal\""],
            place.path(),
        )
        .unwrap();
        assert_eq!(named.spec.resin.absorption_per_mm, Some(0.1148));
        assert_eq!(named.spec.printer.unwrap().canvas, Some([1920, 1080]));
        let changed = ["resin={ profile = \"sr399-tpo-tio2\", absorption_per_mm = 0.2 }"];
        let changed = job(&changed, place.path()).unwrap();
        let resin = &changed.spec.resin;
        assert_eq!(
            (resin.absorption_per_mm, resin.scattering_per_mm),
            (Some(0.2), 0.1707)
        );
        let set = ["resin=\"sr399-tpo\"", "resin.scattering_per_mm=0.5"];
        let set = job(&set, place.path()).unwrap().spec.resin;
        assert_eq!(
            (set.absorption_per_mm, set.scattering_per_mm),
            (Some(0.1148), 0.5)
        );
        // The written job has the numbers alone
        let text = changed.complete().to_toml().unwrap();
        assert!(
            !text.contains("profile") && text.contains("scattering_per_mm = 0.1707"),
            "{text}"
        );
        for header in ["", "[resin]\n"] {
            let text = format!("{header}absorption_per_mm = 0.3\n");
            std::fs::write(place.path().join("ours.toml"), text).unwrap();
            let from_file = job(&["resin=\"ours.toml\""], place.path()).unwrap();
            assert_eq!(from_file.spec.resin.absorption_per_mm, Some(0.3));
        }
    }

    #[test]
    fn files_that_a_profile_names_lie_beside_it() {
        let place = tempfile::tempdir().unwrap();
        let folder = place.path().join("machines");
        std::fs::create_dir(&folder).unwrap();
        let text = "gray_curve_file = \"curve.csv\"\n";
        std::fs::write(folder.join("ours.toml"), text).unwrap();
        let changes = ["resin=\"sr399-tpo\"", "printer=\"machines/ours.toml\""];
        let printer = job(&changes, place.path()).unwrap().spec.printer.unwrap();
        assert_eq!(printer.gray_curve_file, Some(folder.join("curve.csv")));
    }

    #[test]
    fn what_is_no_profile_is_refused_with_the_nearest() {
        let place = tempfile::tempdir().unwrap();
        std::fs::write(place.path().join("wrong.toml"), "absorbtion_per_mm = 0.3\n").unwrap();
        for (change, words) in [
            ("resin=\"sr399-tp\"", "did you mean `sr399-tpo`?"),
            ("resin={ profile = 3 }", "resin.profile"),
            ("resin=\"none.toml\"", "none.toml"),
            ("resin=\"wrong.toml\"", "absorbtion_per_mm"),
            ("printer=\"sr399-tpo\"", "opencal"),
        ] {
            let found = job(&["resin=\"sr399-tpo\"", change], place.path());
            let found = found.map(drop).unwrap_err().to_string();
            assert!(found.contains(words), "{change}: {found}");
        }
    }

    #[test]
    fn a_profile_of_the_command_line_changes_something() {
        let place = tempfile::tempdir().unwrap();
        std::fs::write(place.path().join("ours.toml"), "absorption_per_mm = 0.3\n").unwrap();
        let with = |options: &[&str]| {
            let text = "[resin]\nrefractive_index = 1.5\nabsorption_per_mm = 0.1\n";
            let mut document = Document::toml(place.path().join("job.toml"), text).unwrap();
            for option in options {
                document.set(option).unwrap();
            }
            let mut root = document.root.clone();
            fill(&mut root, place.path(), |key| {
                document.option(key).is_some()
            })
        };
        let named = "resin.profile=\"ours.toml\"";
        let refused = with(&[named]).unwrap_err().to_string();
        assert!(refused.contains("it would change nothing"), "{refused}");
        // Options are what the user asks for beside it
        with(&[named, "resin.absorption_per_mm=0.2"]).unwrap();
        with(&["resin=\"ours.toml\""]).unwrap();
    }

    #[test]
    fn every_profile_has_a_summary_a_source_and_keys_that_are_read() {
        for profile in PROFILES {
            assert!(profile.text.contains("\n# Source: "), "{}", profile.name);
            assert!(profile.summary().len() > 20, "{}", profile.name);
            let change = format!("{}=\"{}\"", profile.table, profile.name);
            job(&["resin=\"sr399-tpo\"", &change], Path::new("")).unwrap();
        }
    }
}
