//! `tomolith trace`: follows the light of single pixels.

use crate::arguments::{JobArguments, Manner, must_be_a_place};
use crate::screen::say;
use crate::voxelize::{Kind, write_volume};
use clap::Args;
use serde_json::json;
use std::path::PathBuf;
use tomolith::Result;
use tomolith::job::Job;
use tomolith::job::trace::{Pixel, Traced, trace};
use tomolith::models::Work;

const EXAMPLES: &str = "\
Examples:
  tomolith trace job.toml --pixel 0,100,50                   power balance and path of one pixel
  tomolith trace job.toml --pixel 0,20,50 --pixel 0,180,50 --output light.png
  tomolith trace job.toml --light 1 --pixel 12,0,0 --json
A pixel is frame,column,row; in arrays of patterns [angle, row, column] it is patterns[frame, row, column]";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct TraceArguments {
    #[command(flatten)]
    pub(crate) job: JobArguments,
    /// The pixel: frame, column and row from the top, each from 0 (repeatable)
    #[arg(long, value_name = "FRAME,COLUMN,ROW", required = true, value_parser = pixel)]
    pixel: Vec<[usize; 3]>,
    /// Which light, from 0
    #[arg(long, default_value_t = 0)]
    light: usize,
    /// Dose of these pixels at a value of 1: .npy [z, y, x], .vti, .nrrd, .tif, .ome.zarr, or .png of all slices, brightest = white.
    /// It is that of a few rays, whatever model the job has: against `parallel` a voxel may differ by half, the sum does not
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

fn pixel(text: &str) -> std::result::Result<[usize; 3], String> {
    let numbers: Vec<usize> = text
        .split(',')
        .map(|part| part.trim().parse().map_err(|_| ()))
        .collect::<std::result::Result<_, ()>>()
        .map_err(|()| "three whole numbers: frame,column,row".to_owned())?;
    numbers
        .try_into()
        .map_err(|_| "three whole numbers: frame,column,row".to_owned())
}

pub(crate) fn run(given: &TraceArguments, job: &Job, work: &Work) -> Result<()> {
    let kind = given.output.as_deref().map(Kind::of).transpose()?;
    if let Some(path) = &given.output {
        must_be_a_place("--output", path)?;
    }
    let pixels: Vec<Pixel> = given
        .pixel
        .iter()
        .map(|&[frame, column, row]| Pixel {
            light: given.light,
            frame,
            column,
            row,
        })
        .collect();
    let (traced, mut dose) = trace(job, &pixels, work).map_err(|e| job.locate(e))?;
    for one in &traced {
        if given.manner.json {
            say(&json!({ "event": "traced", "result": one }).to_string());
        } else if !given.manner.quiet {
            say(&in_words(one));
        }
    }
    if let (Some(kind), Some(path)) = (kind, &given.output) {
        if kind == Kind::Picture {
            let largest = dose.values.iter().copied().fold(0.0, f32::max);
            let scale = if largest > 0.0 { 1.0 / largest } else { 1.0 };
            dose.values.iter_mut().for_each(|v| *v *= scale);
        }
        write_volume(path, kind, "dose", &dose, work)?;
        if !given.manner.json && !given.manner.quiet {
            say(&format!("dose in {}", path.display()));
        }
    }
    Ok(())
}

fn in_words(traced: &Traced) -> String {
    let pixel = traced.pixel;
    let mut text = format!(
        "light {}, frame {}, column {}, row {}",
        pixel.light, pixel.frame, pixel.column, pixel.row
    );
    for segment in &traced.segments {
        let [a, b] =
            [segment.from_mm, segment.to_mm].map(|[x, y, z]| format!("({x:.3}, {y:.3}, {z:.3})"));
        text += &format!(
            "\n  in resin from {a} to {b} mm, power {:.4}",
            segment.power
        );
    }
    let account = &traced.account;
    for (what, share) in [
        ("absorbed", account.absorbed),
        ("in the bath", account.bath),
        ("reflected", account.reflected),
        ("transmitted", account.transmitted),
        ("missed the resin", account.missed),
        ("blocked", account.blocked),
        ("given up", account.dropped),
    ] {
        if share > 0.0 {
            text += &format!("\n  {what} {:.2} %", 100.0 * share);
        }
    }
    if let Some(paths) = traced.paths {
        let within = 50.0 / (paths as f64).sqrt();
        text += &format!(
            "\n  mean of {paths} Monte Carlo paths: the standard error of a share is at most {within:.1} percentage points. \
             For another number: --set 'model={{monte_carlo={{paths_per_pixel=N}}}}'"
        );
    }
    text
}
