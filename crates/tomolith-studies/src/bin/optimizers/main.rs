//! Every optimizer and objective on six targets, and the claims of Pellizzon et al.: the tables of `docs/measured/optimizers.md`.
//!
//! ```text
//! cargo run --release -p tomolith-studies --bin optimizers -- WHAT …
//!     claim [PART METHOD]                                OSPW(0) against OSMO on disc, dog-bones, chart
//!     gyroid [EDGE WALL FRAMES STEPS METHOD]             four penalties and OSMO, 198 slices, 1500 steps
//!     every [TARGET …] [boat.stl] [points.csv]           every optimizer on six targets
//!     objectives [TARGET …] [boat.stl]                   every objective with lbfgs
//!     draw points.csv picture.svg                        loss against seconds
//!     coarse [VOXELS STEPS]                              what coarser levels save
//! ```
//!
//! Doses of different methods have different scales (some are divided by their largest value), so numbers are also taken after
//! scaling the dose to a mean of 0.9 in the part; the loss is OSPW(0) at (0.7, 0.9) there. Seconds are processor time of all
//! threads, so that what else the machine does counts little.
#![expect(clippy::print_stdout, reason = "a bench prints its tables")]

mod case;
mod claim;
mod clock;
mod every;
mod picture;

use case::{Method, Origin, Track};
use serde_json::json;
use std::path::Path;
use std::time::Instant;
use tomolith::Error;
use tomolith::optimize::start::given::Given;

/// Seconds to a loss, from the job's start and from coarser levels.
fn coarse(n: usize, iterations: usize) -> Result<(), Error> {
    let levels = [
        every::gyroid(n / 4)?,
        every::gyroid(n / 2)?,
        every::gyroid(n)?,
    ];
    let method = Method::new("", ("lbfgs", json!({})), ("ospw", json!({})));
    let track = |iterations| Track {
        iterations,
        ..Track::default()
    };
    let solve = |level: usize, origin, steps| {
        levels[level].solve(&method, origin, f64::INFINITY, track(steps))
    };
    let plain = solve(2, Origin::Row("fbp"), iterations)?;
    let begin = Instant::now();
    let first = Given(solve(0, Origin::Row("fbp"), 20)?.patterns);
    let second = Given(solve(1, Origin::Given(&first), 20)?.patterns);
    let before = begin.elapsed().as_secs_f64();
    let fine = solve(2, Origin::Given(&second), iterations)?;
    println!("\ngyroid {n}³; {before:.1} s on the coarser levels, 20 steps each\n");
    println!(
        "| loss of plain step | s | coarse-to-fine step at that loss | s, coarser levels included |"
    );
    println!("|---|---|---|---|");
    for row in plain.outcome.history.iter().step_by(5) {
        let reached = fine.outcome.history.iter().find(|r| r.loss <= row.loss);
        let (step, seconds) = reached.map_or(("–".to_owned(), "–".to_owned()), |r| {
            (
                r.iteration.to_string(),
                format!("{:.1}", before + r.seconds),
            )
        });
        println!(
            "| {:.4} at {} | {:.1} | {step} | {seconds} |",
            row.loss, row.iteration, row.seconds
        );
    }
    Ok(())
}

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let word = |i: usize| arguments.get(i).map(String::as_str);
    let number = |i: usize, default: usize| word(i).and_then(|a| a.parse().ok()).unwrap_or(default);
    let file = |end: &str| {
        let found = arguments.iter().find(|a| a.ends_with(end));
        found.map(|a| Path::new(a.as_str()))
    };
    let names: Vec<&str> = (1..arguments.len())
        .filter_map(word)
        .filter(|a| !a.contains('.'))
        .collect();
    match word(0) {
        Some("claim") => claim::flat(word(1), word(2)),
        Some("gyroid") => {
            let wall = word(2).and_then(|a| a.parse().ok()).unwrap_or(0.095);
            claim::volume(
                number(1, 198),
                wall,
                number(3, 180),
                number(4, 1500),
                word(5),
            )
        }
        Some("every") => every::optimizers(file(".stl"), &names, file(".csv")),
        Some("objectives") => every::objectives(file(".stl"), &names, 200),
        Some("draw") => every::draw(
            file(".csv").unwrap_or(Path::new("points.csv")),
            file(".svg").unwrap_or(Path::new("picture.svg")),
        ),
        Some("coarse") => coarse(number(1, 128), number(2, 40)),
        _ => {
            println!(
                "claim, gyroid, every, objectives, draw or coarse: see the head of this program"
            );
            Ok(())
        }
    }
}
