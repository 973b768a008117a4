//! What can be typed.

use crate::analyze::AnalyzeArguments;
use crate::calibrate::CalibrateArguments;
use crate::compare::CompareArguments;
use crate::export::ExportArguments;
use crate::export_matrix::MatrixArguments;
use crate::expose::ExposeArguments;
use crate::import::ImportArguments;
use crate::metrics::MetricsArguments;
use crate::new::NewArguments;
use crate::ranks::{self, Ranks};
use crate::reproduce::ReproduceArguments;
use crate::sweep::SweepArguments;
use crate::trace::TraceArguments;
use crate::view::{Address, ViewArguments};
use crate::voxelize::{PhantomArguments, VoxelizeArguments};
use clap::{Arg, Args, CommandFactory, Parser, Subcommand, ValueEnum};
use std::path::{Path, PathBuf};
use tomolith::io::must_be_new;
use tomolith::job::Leaves;
use tomolith::{Error, Result};

const EXAMPLES: &str = "\
Examples:
  tomolith new gear.toml                            a job, with comments, to begin with
  tomolith run examples/01-gear.toml                patterns and report in out/01-gear
  tomolith run gear.toml --set stop.iterations=10   change one key for this run
  tomolith check gear.toml                          is it sound, and what will it cost?
  tomolith simulate gear.toml --patterns old.npz    what do these patterns print?
  tomolith print examples/19-print-in-time.toml --patterns old.npz    when is it solid?
  tomolith kinds vial                               every vial with its parameters
  tomolith schema > job.schema.json                 for editors that complete TOML
  tomolith export out/01-gear --output gear-frames  frames and movie for a machine
  tomolith compare out/01-gear out/02-gyroid        runs side by side on one page
  tomolith sweep examples/sweeps/threshold-map.toml many runs, one table, maps
  tomolith reproduce papers/dual-color              the numbers of a paper next to ours

Exit codes: 0 done, 1 asked quality not met, 2 could not run, 130 canceled";

/// The command line. Its options take negative numbers: whoever reads one says what it accepts.
pub(crate) fn command_line() -> clap::Command {
    fn with_negative_numbers(command: clap::Command) -> clap::Command {
        let option = |arg: Arg| {
            let is_option = !arg.is_positional() && arg.get_action().takes_values();
            arg.allow_negative_numbers(is_option)
        };
        command
            .mut_args(option)
            .mut_subcommands(with_negative_numbers)
    }
    with_negative_numbers(Arguments::command())
}

/// Computes light patterns for tomographic volumetric printing, and predicts what they print.
#[derive(Debug, Parser)]
#[command(name = "tomolith", version, after_help = EXAMPLES, arg_required_else_help = true)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
    /// When errors are colored
    #[arg(long, global = true, value_enum, value_name = "WHEN", default_value_t = ColorWhen::Auto, hide_possible_values = false)]
    pub(crate) color: ColorWhen,
}

/// When errors are colored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColorWhen {
    /// On a terminal, unless NO_COLOR is set
    #[default]
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Write a commented job: part, vial, projector and resin from options, or asked for
    New(NewArguments),
    /// Run jobs: target → patterns → predicted print → report
    Run(RunArguments),
    /// Predict what given patterns print: those of an earlier run, or of another program
    Simulate(SimulateArguments),
    /// Simulate given patterns and print them in time: when what is solid, and when to stop; the job needs a table `schedule`
    Print(SimulateArguments),
    /// Run a job with many values of its keys: a table, maps, the best job
    Sweep(SweepArguments),
    /// Run the study of a paper: its numbers next to ours, with a verdict for each
    Reproduce(ReproduceArguments),
    /// Check a job without running it: plan, memory, time, warnings
    Check(CheckArguments),
    /// List what a job can choose from (vials, objectives, optimizers, …) and the keys of its tables
    #[command(
        after_help = "Examples:\n  tomolith kinds                 all families and tables\n  tomolith kinds vial            every vial with its parameters\n  tomolith kinds vial cylinder   one of them\n  tomolith kinds printer         the keys of a table"
    )]
    Kinds {
        /// Only this family or table, for example `vial` or `printer`
        family: Option<String>,
        /// Only this kind, for example `cylinder`
        name: Option<String>,
        /// As JSON
        #[arg(long)]
        json: bool,
    },
    /// List the machines and resins that a job can name, or print one
    #[command(
        after_help = "Examples:\n  tomolith profiles\n  tomolith profiles opencal\n  tomolith profiles sr399-tpo > ours.toml     and in a job: resin = \"ours.toml\""
    )]
    Profiles {
        /// Only this one
        name: Option<String>,
    },
    /// Print the JSON Schema of a job file
    #[command(
        after_help = "Examples:\n  tomolith schema > job.schema.json     for editors: `#:schema job.schema.json` in the first line of a job\n  tomolith schema --markdown            the page of all keys"
    )]
    Schema {
        /// Print tables of all keys (Markdown) instead of the schema
        #[arg(long)]
        markdown: bool,
    },
    /// What this machine has, and whether the program computes on it what closed forms say: ten seconds
    #[command(
        after_help = "Examples:\n  tomolith doctor\n  TOMOLITH_ISA=scalar tomolith doctor     with other instructions"
    )]
    Doctor {
        /// As JSON
        #[arg(long)]
        json: bool,
    },
    /// Print the completions of a shell
    #[command(
        after_help = "Example:\n  tomolith completions bash > ~/.local/share/bash-completion/completions/tomolith"
    )]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Write a manual page of every command into a folder
    #[command(after_help = "Example:\n  tomolith man ~/.local/share/man/man1 && man tomolith-run")]
    Man {
        /// The folder
        folder: PathBuf,
    },
    /// List the graphics cards that `--device` can name
    #[command(after_help = "Examples:\n  tomolith devices\n  tomolith run gear.toml --device gpu")]
    Devices {
        /// As JSON
        #[arg(long)]
        json: bool,
    },
    /// Turn a mesh into voxels: .npy, .vti, .nrrd, .tif, .ome.zarr or .png
    Voxelize(VoxelizeArguments),
    /// Turn a phantom (a part given by a formula) into voxels: .npy, .vti, .nrrd, .tif, .ome.zarr or .png
    Phantom(PhantomArguments),
    /// Compute every metric of the report, and every published one, for any dose and target
    Metrics(MetricsArguments),
    /// Write frames and movie of a run for another machine
    Export(ExportArguments),
    /// Write the dose model of a small job as a sparse matrix for SciPy
    ExportMatrix(MatrixArguments),
    /// Follow the light of single pixels: its path, where its power goes, its dose
    Trace(TraceArguments),
    /// Translate a job of Dr.TVAM into a Tomolith job
    Import(ImportArguments),
    /// Draw calibration frames for a machine, or fit what was measured: gray curve, response, kinetics, a print of discs
    Calibrate(CalibrateArguments),
    /// Plan the exposure of a run: power and critical dose → time, turns, duty, energy
    Expose(ExposeArguments),
    /// What a printer and a resin allow: voxel size, build-up of dose, impulse response
    Analyze(AnalyzeArguments),
    /// Look into runs in the browser: planes, threshold, surfaces, patterns, several runs side by side
    View(ViewArguments),
    /// Put several runs side by side on one page
    Compare(CompareArguments),
}

#[derive(Debug, Args)]
pub(crate) struct JobArguments {
    /// Job file, TOML or JSON; `-` reads standard input
    pub(crate) job: PathBuf,
    #[command(flatten)]
    pub(crate) changes: JobChanges,
}

/// What options change of a job.
#[derive(Debug, Args)]
pub(crate) struct JobChanges {
    /// Run a coarse version: a third of the resolution (down to a sixth, so that images have 80 pixels across), few angles, few iterations. Its print is poor; the file's evaluate.require_iou and require_in_band do not count
    #[arg(long)]
    pub(crate) toy: bool,
    /// Change a key: `--set stop.iterations=10 --set light.angles=360` (repeatable); a kind, `vial.square={…}`, takes the place of the job's
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) set: Vec<String>,
    /// Where doses are computed, in place of `resources.device`: cpu, gpu, gpu:NAME or auto
    #[arg(long, value_name = "DEVICE")]
    pub(crate) device: Option<String>,
}

/// How the command speaks and works.
#[derive(Clone, Copy, Debug, Default, Args)]
pub(crate) struct Manner {
    /// Say nothing but errors
    #[arg(long, short)]
    pub(crate) quiet: bool,
    /// One JSON object per line on standard output, errors included
    #[arg(long)]
    pub(crate) json: bool,
    /// Threads to use, 1 to 256; all cores when left out. Results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=256))]
    pub(crate) threads: Option<u16>,
}

impl Manner {
    /// As usual, but for `--json`.
    pub(crate) fn with_json(json: bool) -> Self {
        Manner {
            json,
            ..Manner::default()
        }
    }

    /// This manner, or silence on a rank that does not speak.
    pub(crate) fn of_rank(self, ranks: Option<&Ranks>) -> Self {
        let speaks = !ranks::is_silent(ranks);
        Manner {
            quiet: self.quiet || !speaks,
            json: self.json && speaks,
            ..self
        }
    }
}

#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  tomolith run gear.toml                          patterns and report in out/gear\n  tomolith run gear.toml --toy                    a quick look\n  tomolith run gear.toml --resume --set stop.iterations=90\n  tomolith run jobs/*.toml                        one after the other\n  tomolith new - --part gyroid | tomolith run - -o out/gyroid"
)]
pub(crate) struct RunArguments {
    /// Job files, TOML or JSON, run one after the other; `-` reads standard input
    #[arg(required = true, value_name = "JOB")]
    pub(crate) jobs: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) changes: JobChanges,
    /// Run folder, in place of `output.folder`
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// Continue from the checkpoint in the run folder
    #[arg(long)]
    pub(crate) resume: bool,
    /// Replace a finished run of another job in the run folder
    #[arg(long)]
    pub(crate) overwrite: bool,
    /// What the run leaves
    #[arg(long, value_enum, default_value_t = Keep::All)]
    pub(crate) keep: Keep,
    /// Show the run in the browser while it goes on, and then its result, until Ctrl-C
    #[arg(long, conflicts_with = "keep")]
    pub(crate) open: bool,
    #[command(flatten)]
    pub(crate) address: Address,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

/// What a run leaves.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Keep {
    /// job.toml, report.json, history.csv
    Metrics,
    /// And patterns.npz
    Patterns,
    /// Everything
    All,
}

impl From<Keep> for Leaves {
    fn from(keep: Keep) -> Self {
        match keep {
            Keep::Metrics => Leaves::Metrics,
            Keep::Patterns => Leaves::Patterns,
            Keep::All => Leaves::All,
        }
    }
}

#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  tomolith simulate gear.toml --patterns out/gear/patterns.npz\n  tomolith simulate gear.toml --patterns frames/ --set resin.absorption_per_mm=0.1\n  tomolith print slow.toml --patterns out/slow/patterns.npz      needs [schedule]: how many turns, how long"
)]
pub(crate) struct SimulateArguments {
    #[command(flatten)]
    pub(crate) job: JobArguments,
    /// The patterns: `patterns.npz` of a run folder; or what a machine shows: a folder of frames, `frames.npz`, a movie
    #[arg(long, value_name = "FILE")]
    pub(crate) patterns: PathBuf,
    /// Run folder, in place of `output.folder`
    #[arg(long, short, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  tomolith check gear.toml\n  tomolith check gear.toml --json | jq .seconds\n  tomolith check gear.toml --picture gear.html      vial, part and rays in the browser"
)]
pub(crate) struct CheckArguments {
    #[command(flatten)]
    pub(crate) job: JobArguments,
    /// Write a page that shows vial, part, lit radius and rays: a new file ending in .html
    #[arg(long, value_name = "FILE")]
    pub(crate) picture: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

/// Refuses a place for a new file in a folder that is not there, or where something is, before the work for it is done.
pub(crate) fn must_be_a_place(option: &str, output: &Path) -> Result<()> {
    must_have_folder(option, output)?;
    must_be_new(option, output)
}

/// Refuses a file to be written into a folder that is not there.
pub(crate) fn must_have_folder(option: &str, output: &Path) -> Result<()> {
    let folder = output.parent().filter(|f| !f.as_os_str().is_empty());
    match folder {
        Some(folder) if !folder.is_dir() => Err(Error::config(
            option,
            format!("there is no folder `{}`", folder.display()),
            "a file in a folder that exists",
        )),
        _ => Ok(()),
    }
}

/// Refuses a file whose name has none of these endings, the first of which an error names.
pub(crate) fn must_end_in(option: &str, file: &Path, endings: &[&str]) -> Result<()> {
    let extension = file.extension().unwrap_or_default();
    if endings
        .iter()
        .any(|end| extension.eq_ignore_ascii_case(end))
    {
        return Ok(());
    }
    Err(Error::config(
        option,
        format!("`{}` has another ending", file.display()),
        format!("a file name ending in .{}", endings[0]),
    ))
}

/// What names of files of web pages end in.
pub(crate) const PAGE: [&str; 2] = ["html", "htm"];

/// An error about a key as one about the option that gives it: `evaluate.trim_percent` → `--trim-percent`.
pub(crate) fn as_option(mut error: Error) -> Error {
    if let Error::Config { key, .. } = &mut error {
        let name = key.rsplit('.').next().unwrap_or_default();
        *key = format!("--{}", name.replace('_', "-"));
    }
    error
}
