//! `tomolith compare`: several runs on one page.

use crate::arguments::{Manner, PAGE, must_end_in, must_have_folder};
use crate::screen::{done, say};
use clap::Args;
use std::path::PathBuf;
use tomolith::Result;
use tomolith::io::must_be_new;
use tomolith::report::compare::{compare_json, is_comparison, read_runs, write_compare};

const EXAMPLES: &str = "\
Examples:
  tomolith compare out/gear-lbfgs out/gear-osmo --output gear.html
  tomolith compare out/gear-* --json";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct CompareArguments {
    /// Folders of `run` and `simulate`; the page says under each name whether it is an optimization or a simulation
    #[arg(required = true)]
    runs: Vec<PathBuf>,
    /// The page: a new file, or an earlier comparison
    #[arg(long, short, value_name = "FILE", default_value = "compare.html")]
    output: PathBuf,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

pub(crate) fn compare(given: &CompareArguments) -> Result<()> {
    must_end_in("--output", &given.output, &PAGE)?;
    must_have_folder("--output", &given.output)?;
    if !is_comparison(&given.output) {
        must_be_new("--output", &given.output)?;
    }
    let runs = read_runs(&given.runs)?;
    write_compare(&given.output, &runs)?;
    let page = given.output.display().to_string();
    let mut found = compare_json(&runs);
    found["page"] = page.as_str().into();
    done(given.manner, found, || say(&page));
    Ok(())
}
