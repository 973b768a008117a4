//! Whether a run may take the place of the one that its folder holds.

use super::folder::RunFolder;
use crate::error::{Error, Result};
use crate::job::resolve::identity::tables_of;
use crate::job::spec::JobSpec;
use crate::job::spec::document::Document;
use crate::job::spec::read::Job;
use crate::optimize::checkpoint::differences;

/// Tables in which two jobs may differ.
const ASIDE: [&str; 2] = ["output", "resources"];
/// Differences that a message names.
const NAMED: usize = 3;

/// Refuses to replace a finished run of another job, unless the user asks for it or goes on from its checkpoint. Jobs are the same
/// when their resolved tables are, but for `[output]` and `[resources]`; a toy of a job gives way to the job.
pub(crate) fn must_be_same(job: &Job, resume: bool) -> Result<()> {
    let folder = job.folder();
    let goes_on = resume && folder.join("checkpoint").exists();
    if job.overwrite || goes_on {
        return Ok(());
    }
    let Some(file) = RunFolder::finished(&folder) else {
        return Ok(());
    };
    let was = Document::read(&file).and_then(|text| JobSpec::from_document(&text));
    let changes = match was {
        Ok(was) => {
            let tables = |spec: &JobSpec| tables_of(spec, &ASIDE).unwrap_or_default();
            let was = tables(&was);
            let changed = |job: &Job| {
                let mut found = Vec::new();
                differences("", &was, &tables(&job.complete()), &mut found);
                found
            };
            let found = changed(job);
            if found.is_empty() || changed(&job.clone().toy()).is_empty() {
                return Ok(());
            }
            named(&found)
        }
        Err(_) => "its job.toml is of another version or cannot be read".to_owned(),
    };
    Err(job.locate(Error::config(
        "output.folder",
        format!(
            "`{}` holds a finished run of another job: {changes}",
            folder.display()
        ),
        "another folder (--output DIR), or --overwrite to replace that run",
    )))
}

/// The first differences, and how many more there are.
fn named(found: &[String]) -> String {
    let (first, rest) = found.split_at(found.len().min(NAMED));
    let first = first.join(", ");
    match rest.len() {
        0 => first,
        n => format!("{first}, and {n} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::{FULL, job_of};
    use std::fs;

    fn job(folder: &std::path::Path, change: &str) -> Job {
        job_of(FULL, &[change]).with_folder(folder, "--output")
    }

    #[test]
    fn a_finished_run_is_replaced_by_its_own_job_only() {
        let temp = tempfile::tempdir().unwrap();
        let path = temp.path().join("run");
        let (first, other) = (
            job(&path, "output.rpm=10"),
            job(&path, "stop.iterations=41"),
        );
        let text = first.complete().to_toml().unwrap();
        must_be_same(&other, false).unwrap();
        // Nothing is finished while there is no report
        let folder = RunFolder::open(&path, &text).unwrap();
        fs::write(folder.new_files().join("report.json"), "{}").unwrap();
        must_be_same(&other, false).unwrap();
        folder.publish().unwrap();
        must_be_same(&first, false).unwrap();
        // What is written where is not the job
        must_be_same(&job(&path, "output.rpm=8"), false).unwrap();
        let message = must_be_same(&other, false).unwrap_err().to_string();
        tomolith_core::contains!(
            message,
            "finished run of another job: stop.iterations was 40, is 41",
            "--overwrite"
        );
        must_be_same(&other.clone().overwriting(), false).unwrap();
        // A toy replaces no run of its job, and is replaced by one
        let toy = must_be_same(&first.clone().toy(), false).unwrap_err();
        tomolith_core::contains!(
            toy.to_string(),
            "grid.pitch_mm was 0.05, is 0.15, and 6 more"
        );
        let toy = first.clone().toy().complete().to_toml().unwrap();
        fs::write(path.join("job.toml"), toy).unwrap();
        must_be_same(&first, false).unwrap();
        assert!(must_be_same(&other, false).is_err());
        // Without a checkpoint there is nothing to go on from
        assert!(must_be_same(&other, true).is_err());
        fs::create_dir(path.join("checkpoint")).unwrap();
        must_be_same(&other, true).unwrap();
        fs::write(
            path.join("job.toml"),
            "# A Tomolith run folder; this is its job with every default written out.\n",
        )
        .unwrap();
        assert!(
            must_be_same(&first, false).is_err(),
            "a job that cannot be read"
        );
    }
}
