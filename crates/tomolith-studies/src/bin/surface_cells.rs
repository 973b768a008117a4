//! Voxels, fractions and surface-aware cells on coarser and finer grids: figure 7 of Nicolet et al. 2024.
//!
//! Runs `examples/14-surface-cells.toml` once for every grid and every `surface`, judges the written patterns on a grid of 1024
//! voxels across (or fewer, the second argument), and prints a row of docs/measured/rays.md for each grid.
//!
//!     cargo run --release -p tomolith-studies --bin surface_cells -- 16,32,64,128 1024
//!
//! Run folders go to `out/surface-cells/`.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use std::path::Path;
use tomolith::Error;
use tomolith::job::{self, Job, Silent};
use tomolith::models::Run;

/// Edge of the grid, mm: the star and a tenth around it.
const EDGE_MM: f64 = 4.4;
/// How much finer the evaluation of a job is than its grid.
const REFINE: usize = 4;

fn main() -> Result<(), Error> {
    let mut arguments = std::env::args().skip(1);
    let counts = arguments.next().unwrap_or_else(|| "16,32,64".to_owned());
    let fine = number(&arguments.next().unwrap_or_else(|| "512".to_owned()))?;
    println!("| voxels | surface | IoU, own grid | IoU, {fine} across | PW, {fine} across | s |");
    println!("|---|---|---|---|---|---|");
    for count in counts.split(',') {
        let count = number(count)?;
        for surface in ["voxel", "fraction", "cells"] {
            let own = job(surface, count, 1)?;
            let run = job::run(&own, false, &mut Silent, &Run::new())?;
            // Judged by plain voxels, whatever they were made on
            let judge = job("voxel", fine / REFINE, REFINE)?;
            let patterns = run.folder.join("patterns.npz");
            let print = job::simulate(&judge, &patterns, &mut Silent, &Run::new())?;
            let of = |value: Option<f64>| value.map_or("–".to_owned(), |v| format!("{v:.4}"));
            println!(
                "| {count}² × {} | {surface} | {} | {} | {} | {:.0} |",
                count / 4,
                of(run.optimization.and_then(|q| q.iou)),
                of(print.standing.iou),
                of(print.standing.pw),
                run.seconds
            );
        }
    }
    Ok(())
}

/// The job on so many voxels across, judged on `refine` times as many.
fn job(surface: &str, count: usize, refine: usize) -> Result<Job, Error> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/14-surface-cells.toml");
    let overrides = [
        format!("objective.threshold.surface={surface}"),
        format!("grid.shape=[{count}, {count}, {}]", count / 4),
        format!("grid.pitch_mm={}", EDGE_MM / count as f64),
        format!("evaluate.refine={refine}"),
        "evaluate.sub_angles=1".to_owned(),
    ];
    let folder = format!("out/surface-cells/{count}-{surface}-{refine}");
    Ok(Job::read(&file, &overrides)?.with_folder(Path::new(&folder), "folder"))
}

fn number(text: &str) -> Result<usize, Error> {
    text.parse().map_err(|_| {
        Error::config(
            "surface_cells",
            format!("found {text}"),
            "whole numbers: grids, then the voxels across the judging grid",
        )
    })
}
