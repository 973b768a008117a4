//! `tomolith export`: frames for a machine.

use crate::arguments::Manner;
use crate::screen::{Screen, done, say};
use clap::Args;
use std::path::PathBuf;
use tomolith::Result;
use tomolith::job::export::{Exported, export as of_run, job_of_run};
use tomolith::models::Work;
use tomolith::report::number::significant;

const EXPORT: &str = "\
Examples:
  tomolith export out/01-gear --printer opencal --output gear-opencal
  tomolith export out/01-gear --set printer.flip_horizontal=true --set output.rpm=12 --output gear-12
Patterns are not optimized or simulated again; `tomolith simulate` on the frames predicts what they print";

#[derive(Debug, Args)]
#[command(after_help = EXPORT)]
pub(crate) struct ExportArguments {
    /// Folder of a run
    run: PathBuf,
    /// A machine by name (`tomolith profiles`), or a TOML file with its table `printer`; that of the run when left out
    #[arg(long, value_name = "PROFILE|FILE")]
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

pub(crate) fn export(given: &ExportArguments, work: &Work) -> Result<()> {
    let job = job_of_run(&given.run, given.printer.as_deref(), &given.set)?;
    let mut screen = Screen::new(given.manner);
    let exported = of_run(&job, &given.run, &given.output, &mut screen, work)?;
    drop(screen);
    done(given.manner, &exported, || show(&exported));
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
