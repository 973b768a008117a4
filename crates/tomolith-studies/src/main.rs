//! Studies behind the numbers of the book (docs/validation.md, docs/choices.md, docs/fidelity.md, …): each prints tables of one page.
//!
//!     cargo run --release -p tomolith-studies -- fidelity boat.stl
//!
//! Without a name it lists what there is. The papers' studies are jobs and sweeps in `papers/` (`tomolith reproduce`); here stands what no job can say:
//! models next to arrays of other programs, noise, growth, the evaluated prints of all defaults.
#![expect(clippy::print_stderr, reason = "a program says why it ends")]

mod cards;
mod fidelity;
mod flower;
mod growth;
mod reference_doses;
mod scatter_noise;
mod waves;

use std::error::Error;
use std::process::ExitCode;

type Study = fn(&[String]) -> Result<(), Box<dyn Error>>;

/// Name, what comes after it, what it measures, and the study.
const STUDIES: [(&str, &str, &str, Study); 7] = [
    (
        "cards",
        "CARD [MESH | -] [DIVISOR] [WORD]",
        "whole jobs, doses and adjoints on a graphics card beside the processor",
        cards::study,
    ),
    (
        "fidelity",
        "[BOAT] [TARGETS] [ROWS] [glass | matched]",
        "which patterns print best, on six targets",
        fidelity::study,
    ),
    (
        "flower",
        "[IMAGE | phantom] [VOXELS] [EPSILON | all] [ROW]",
        "the gray flower of BCLP",
        flower::study,
    ),
    (
        "growth",
        "[LARGEST] [FOLDER] | from FILE [FOLDER] | one MODEL N",
        "how time and memory of the dose models grow",
        growth::study,
    ),
    (
        "reference_doses",
        "FOLDER",
        "doses of fixed patterns beside those of Dr.TVAM",
        reference_doses::study,
    ),
    (
        "scatter_noise",
        "",
        "noise and time of the dose by Monte Carlo paths",
        scatter_noise::study,
    ),
    (
        "waves",
        "",
        "errors of the wave model's light by its sampling",
        waves::study,
    ),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let asked = arguments.first().map(String::as_str);
    let done = match STUDIES.iter().find(|(name, ..)| Some(*name) == asked) {
        Some((.., study)) => study(&arguments[1..]),
        None => Err(list().into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// What there is.
fn list() -> String {
    let line = |(name, rest, what, _): &(&str, &str, &str, Study)| {
        format!("\n    {name} {rest}\n        {what}")
    };
    let lines: String = STUDIES.iter().map(line).collect();
    format!("give the name of a study:{lines}")
}
