//! `tomolith export` and `tomolith calibrate`: frames for a machine.

use crate::arguments::Manner;
use crate::screen::{Screen, say};
use clap::Args;
use serde_json::json;
use std::path::PathBuf;
use tomolith::exposure::{CALIBRATIONS, Calibration, PrinterSpec};
use tomolith::grid::PatternGrid;
use tomolith::job::Job;
use tomolith::job::export::{Exported, calibrate as of_job, draw, export as of_run, job_of_run};
use tomolith::report::number::significant;
use tomolith::{Error, Result};

const EXPORT: &str = "\
Examples:
  tomolith export out/01-gear --printer opencal.toml --output gear-opencal
  tomolith export out/01-gear --set printer.flip_horizontal=true --set output.rpm=12 --output gear-12
Nothing is optimised or simulated again: `tomolith simulate` on the frames says what they print";

const CALIBRATE: &str = "\
Examples:
  tomolith calibrate --canvas 1920 1080 --output calibration
  tomolith calibrate --job examples/09-printer.toml siemens_star axis_lines --output calibration
Frames: border, checkerboard, crosshair, grey_steps, siemens_star, axis_lines, orientation";

#[derive(Debug, Args)]
#[command(after_help = EXPORT)]
pub(crate) struct ExportArguments {
    /// Folder of a run
    run: PathBuf,
    /// TOML file with the table `printer` of the machine; that of the run when left out
    #[arg(long, value_name = "FILE")]
    printer: Option<PathBuf>,
    /// Change a key of the run's job: `--set output.rpm=12` (repeatable)
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// New folder for frames, movie and exposure.json
    #[arg(long, short, value_name = "DIR")]
    output: PathBuf,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

#[derive(Debug, Args)]
#[command(after_help = CALIBRATE)]
pub(crate) struct CalibrateArguments {
    /// Frames to draw; all of them when left out
    frames: Vec<String>,
    /// Job whose `printer` table and light the frames are drawn for
    #[arg(long, value_name = "JOB", conflicts_with = "canvas")]
    job: Option<PathBuf>,
    /// Pixels of the device, without a job
    #[arg(long, num_args = 2, value_names = ["COLUMNS", "ROWS"], required_unless_present = "job")]
    canvas: Option<Vec<usize>>,
    /// Bit depth, without a job
    #[arg(long, default_value_t = 8)]
    bits: u32,
    /// New folder for the frames, NAME.png each
    #[arg(long, short, value_name = "DIR")]
    output: PathBuf,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

/// `tomolith export`.
pub(crate) fn export(given: &ExportArguments) -> Result<()> {
    let job = job_of_run(&given.run, given.printer.as_deref(), &given.set)?;
    let mut screen = Screen::new(given.manner);
    let exported = of_run(&job, &given.run, &given.output, &mut screen)?;
    drop(screen);
    if given.manner.json {
        let mut line = serde_json::to_value(&exported).unwrap_or_default();
        line["event"] = "done".into();
        say(&line.to_string());
    } else if !given.manner.quiet {
        show(&exported);
    }
    Ok(())
}

fn show(exported: &Exported) {
    for light in &exported.lights {
        let [columns, rows] = light.canvas;
        let name = light.name.as_deref().unwrap_or("frames");
        say(&format!(
            "{name:>14} {} of {columns} × {rows} pixels",
            light.frames
        ));
        if let (Some(movie), Some(rate)) = (&light.movie, light.frame_rate) {
            say(&format!(
                "{:>14} {movie}, {} frames a second",
                "movie",
                significant(rate, 5)
            ));
        }
        let budget = &light.budget;
        for (name, value, unit) in [
            ("time to print", budget.time_s, "s"),
            ("turns", budget.turns, ""),
            ("energy per turn", budget.energy_per_turn_mj, "mJ"),
            ("light used", Some(100.0 * budget.light_used), "%"),
        ] {
            if let Some(value) = value {
                say(&format!("{name:>16} {} {unit}", significant(value, 3)));
            }
        }
    }
    say(&format!("{:>14} {}", "written", exported.folder.display()));
}

/// `tomolith calibrate`.
pub(crate) fn calibrate(given: &CalibrateArguments) -> Result<()> {
    let names: Vec<&str> = match given.frames.as_slice() {
        [] => CALIBRATIONS
            .iter()
            .map(|calibration| calibration.0)
            .collect(),
        asked => asked.iter().map(String::as_str).collect(),
    };
    let files = match (&given.job, &given.canvas) {
        (Some(job), _) => of_job(&Job::read(job, &[])?, &names, &given.output)?,
        (None, Some(canvas)) => {
            let spec = PrinterSpec {
                canvas: Some([canvas[0], canvas[1]]),
                ..PrinterSpec::default()
            };
            spec.ranges()?;
            // The patterns fill the device; a pixel is the unit of length
            let field = PatternGrid::full_turn(1, 0.0, canvas[1], canvas[0], 1.0);
            let calibration = Calibration::new(&spec, &field, given.bits).map_err(|e| match e {
                Error::Config {
                    key,
                    found,
                    accepted,
                    ..
                } if key == "bit_depth" => Error::config("--bits", found, accepted),
                other => other,
            })?;
            draw(&calibration, &names, &given.output)?
        }
        (None, None) => {
            return Err(Error::config(
                "--canvas",
                "neither a job nor a canvas",
                "one of the two",
            ));
        }
    };
    if given.manner.json {
        say(&json!({ "event": "done", "files": files }).to_string());
    } else if !given.manner.quiet {
        files
            .iter()
            .for_each(|file| say(&file.display().to_string()));
    }
    Ok(())
}
