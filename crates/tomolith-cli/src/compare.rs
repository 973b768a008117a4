//! `tomolith compare`: several runs on one page.

use crate::arguments::Manner;
use crate::screen::say;
use clap::Args;
use std::path::PathBuf;
use tomolith::Result;
use tomolith::report::compare::{compare_json, read_runs, write_compare};

const EXAMPLES: &str = "\
Examples:
  tomolith compare out/gear-lbfgs out/gear-osmo --output gear.html
  tomolith compare out/* --json";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct CompareArguments {
    /// Run folders
    #[arg(required = true)]
    runs: Vec<PathBuf>,
    /// The page
    #[arg(long, short, value_name = "FILE", default_value = "compare.html")]
    output: PathBuf,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

pub(crate) fn compare(given: &CompareArguments) -> Result<()> {
    let runs = read_runs(&given.runs)?;
    write_compare(&given.output, &runs)?;
    if given.manner.json {
        let mut line = compare_json(&runs);
        line["event"] = "done".into();
        line["page"] = given.output.display().to_string().into();
        say(&line.to_string());
    } else if !given.manner.quiet {
        say(&given.output.display().to_string());
    }
    Ok(())
}
