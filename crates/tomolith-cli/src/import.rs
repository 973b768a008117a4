//! `tomolith import`: a job of another program as ours.

use crate::arguments::Manner;
use crate::screen::say;
use clap::Args;
use serde_json::json;
use std::io::Write;
use std::path::PathBuf;
use tomolith::io::write_whole;
use tomolith::{Error, Result, job};

const EXAMPLES: &str = "\
Examples:
  tomolith import config.json --output job.toml
  tomolith run job.toml
Files that the job names keep their paths: write the new job into the folder of the old one.";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct ImportArguments {
    /// Job of Dr.TVAM, JSON
    theirs: PathBuf,
    /// Job file to write, TOML
    #[arg(long, short, value_name = "TOML")]
    output: PathBuf,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

pub(crate) fn import(given: &ImportArguments) -> Result<()> {
    if given.output.exists() {
        return Err(Error::config(
            "--output",
            format!("`{}` is there already", given.output.display()),
            "a new file",
        ));
    }
    let text = std::fs::read_to_string(&given.theirs)
        .map_err(|source| Error::io(&given.theirs, source))?;
    let named = |error| match error {
        Error::Unsupported { what, reason } => Error::Unsupported {
            what: format!("{}: {what}", given.theirs.display()),
            reason,
        },
        other => other,
    };
    let ours = job::import(&text).map_err(named)?;
    write_whole(&given.output, |file| {
        Ok(file.write_all(ours.text.as_bytes())?)
    })?;
    if given.manner.json {
        say(&json!({ "event": "done", "file": given.output, "notes": ours.notes }).to_string());
    } else if !given.manner.quiet {
        for note in &ours.notes {
            say(&format!("note: {note}"));
        }
        say(&format!("job in {}", given.output.display()));
    }
    Ok(())
}
