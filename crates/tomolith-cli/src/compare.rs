//! `tomolith compare`: several runs on one page.

use crate::arguments::{Manner, must_have_folder};
use crate::screen::say;
use clap::Args;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use tomolith::io::must_be_new;
use tomolith::report::compare::{compare_json, is_comparison, read_runs, write_compare};
use tomolith::{Error, Result};

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
    must_be_page("--output", &given.output)?;
    must_have_folder("--output", &given.output)?;
    if !is_comparison(&given.output) {
        must_be_new("--output", &given.output)?;
    }
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

/// Refuses a file that is not called a web page.
///
/// # Errors
/// [`Error::Config`].
pub(crate) fn must_be_page(option: &str, file: &Path) -> Result<()> {
    let is_page = |e: &OsStr| {
        ["html", "htm"]
            .iter()
            .any(|page| e.eq_ignore_ascii_case(page))
    };
    if file.extension().is_some_and(is_page) {
        return Ok(());
    }
    Err(Error::config(
        option,
        format!("`{}` has another ending", file.display()),
        "a file name ending in .html: the page is a web page",
    ))
}
