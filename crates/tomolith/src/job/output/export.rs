//! A run for another machine: its patterns through another `[printer]`, without a new optimization.

use super::folder::{RunFolder, unusable};
use crate::error::{Error, Result};
use crate::exposure::{Budget, Calibration, PrinterSpec, Quantized, quantize};
use crate::io::frames::{FrameSet, write_picture};
use crate::io::{must_be_free, read_text, write_folder_whole};
use crate::job::dose::written;
use crate::job::output::frames::Shown;
use crate::job::progress::{Event, Progress, stage, watched};
use crate::job::resolve::goal::response;
use crate::job::resolve::machine::Showing;
use crate::job::resolve::optics::Optics;
use crate::job::resolve::refinement::described;
use crate::job::resolve::resources::require;
use crate::job::resolve::{ResolvedJob, machine};
use crate::job::spec::document::{Document, is_within};
use crate::job::spec::file_names::of_lights;
use crate::job::spec::profiles::PROFILES;
use crate::job::spec::read::Job;
use crate::kind::Section;
use crate::models::{DoseModel, Family, Work, matrix, planner};
use crate::units::counted;
use serde::Serialize;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// What was exported.
#[derive(Clone, Debug, Serialize)]
pub struct Exported {
    /// The folder.
    pub folder: PathBuf,
    /// One per light.
    pub lights: Vec<ExportedLight>,
}

/// One light of an export.
#[derive(Clone, Debug, Serialize)]
pub struct ExportedLight {
    /// Its name, when there are several.
    pub name: Option<String>,
    /// Columns and rows of the device.
    pub canvas: [usize; 2],
    /// Frames.
    pub frames: usize,
    /// The movie; none for a list of angles.
    pub movie: Option<String>,
    /// Its frames a second.
    pub frame_rate: Option<f64>,
    /// Time, energy and use of the light.
    pub budget: Budget,
}

/// What an export reads of a job: all else is in the patterns.
const READ: [&str; 6] = [
    "printer",
    "output.rpm",
    "output.movie",
    "evaluate.bit_depth",
    "target.name",
    "resin.critical_dose_mj_per_mm3",
];

/// Refuses an override that would change nothing.
fn must_be_read(assignment: &str) -> Result<()> {
    let key = assignment.split('=').next().unwrap_or_default().trim();
    if key == assignment.trim() || READ.iter().any(|read| is_within(key, read)) {
        return Ok(());
    }
    Err(Error::config(
        format!("--set {assignment}"),
        format!("an export does not read `{key}`: the patterns are those of the run"),
        format!(
            "keys of [printer], and {}; `tomolith run` and `tomolith simulate` read all keys",
            READ[1..].join(", ")
        ),
    ))
}

/// The job of a run folder, with the `[printer]` of another file when one is given, and overrides.
///
/// # Errors
/// As [`Job::read`]; [`Error::Config`] when the folder is no run, the file holds no `[printer]`, or an override is of a key that
/// an export does not read.
pub fn job_of_run(run: &Path, printer: Option<&Path>, overrides: &[String]) -> Result<Job> {
    overrides.iter().try_for_each(|set| must_be_read(set))?;
    let file = run.join("job.toml");
    if !file.is_file() {
        let what = match run.is_file() {
            true => "is a file, and no folder",
            false => "holds no job.toml",
        };
        return Err(Error::config(
            "RUN",
            format!("`{}` {what}", run.display()),
            "the folder of a run of Tomolith",
        ));
    }
    if RunFolder::finished(run).is_none() {
        return Err(Error::config(
            "RUN",
            format!("no run has ended in `{}`", run.display()),
            "a finished run; `tomolith run JOB --resume` goes on with one that was stopped",
        ));
    }
    let mut document = Document::read(&file)?;
    let has_profile = |folder: &Path| {
        PROFILES
            .iter()
            .any(|profile| folder == Path::new(profile.name))
    };
    if let Some(folder) = printer.filter(|path| path.is_dir() && !has_profile(path)) {
        let found = format!("`{}` is a folder", folder.display());
        let accepted = "a machine by name (`tomolith profiles`), or a TOML file with a table [printer], or with its keys";
        return Err(Error::config("--printer", found, accepted));
    }
    let is_name = |name: &&Path| name.extension().is_none() && !name.is_file();
    let profile = printer.filter(is_name).and_then(Path::to_str);
    if let (Some(name), Value::Object(root)) = (profile, &mut document.root) {
        root.insert("printer".to_owned(), name.into());
        document.overridden("printer", format!("--printer {name}"));
    } else if let Some(machine) = printer {
        let other = Document::read(machine)?;
        let is_job = other.root.get("target").is_some();
        let keys = other.root.get("printer");
        let table = keys.or(Some(&other.root).filter(|_| !is_job));
        let table = table.cloned().ok_or_else(|| {
            Error::config(
                "--printer",
                format!("{} holds no [printer]", machine.display()),
                "a TOML file with a table [printer], or with its keys",
            )
        })?;
        let spec = Section::new("printer", table).parse::<PrinterSpec>();
        let mut spec = spec.map_err(|e| other.locate(e))?;
        let base = machine.parent().map(Path::to_owned).unwrap_or_default();
        for file in spec.files_mut() {
            let here = base.join(&*file);
            *file = std::path::absolute(&here).unwrap_or(here);
        }
        spec.ranges().map_err(|e| other.locate(e))?;
        if let Value::Object(root) = &mut document.root {
            let table = serde_json::to_value(&spec)
                .map_err(|e| Error::config("printer", e.to_string(), "a table"))?;
            root.insert("printer".to_owned(), table);
        }
        document.overridden("printer", format!("--printer {}", machine.display()));
    }
    overrides
        .iter()
        .try_for_each(|assignment| document.set(assignment))?;
    Job::from_document(document)
}

/// Writes frames, movie and `exposure.json` of a run's patterns for the machine of `job` into a new folder.
///
/// # Errors
/// As [`Printer::new`](crate::exposure::Printer::new); [`Error::Config`] when the folder is not empty; [`Error::Canceled`].
pub fn export(
    job: &Job,
    run: &Path,
    folder: &Path,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Exported> {
    must_be_free("--output", folder)?;
    let spec = &job.spec;
    let optics = Optics::new(spec, &job.base()).map_err(|e| job.locate(e))?;
    let printers =
        machine::printers(spec, &job.base(), &optics.lights).map_err(|e| job.locate(e))?;
    let names = of_lights(spec);
    if !run.join("patterns.npz").is_file() {
        return Err(written::without_patterns("RUN", run));
    }
    let (shown, raw) = written::wanted_of(&run.join("patterns.npz"), &optics, &names, work)?;
    let (wanted, bits) = (raw.unwrap_or(shown), spec.evaluate.bit_depth);
    work.check()?;
    if let Some(text) = rounded_anew(run, bits) {
        progress.event(&Event::Warning { text });
    }
    let frames: Vec<Quantized> = match &printers {
        Some(printers) => written::exposed(printers, &wanted, bits)?,
        None => wanted
            .iter()
            .map(|wanted| quantize(wanted, bits))
            .collect::<Result<_>>()?,
    };
    for text in printers
        .iter()
        .flatten()
        .flat_map(|printer| printer.notes().to_vec())
    {
        progress.event(&Event::Warning { text });
    }
    let showing = Showing::of(spec);
    let sets: Vec<FrameSet<'_>> = frames
        .iter()
        .zip(&names)
        .enumerate()
        .map(|(i, (frames, name))| frames.frames(*name, showing.channel(i)))
        .collect();
    let gel_dose = gel_dose(job, run, progress)?;
    let shown = Shown::new(showing, printers.as_deref(), &frames, gel_dose)?;
    for text in shown.warnings(false) {
        progress.event(&Event::Warning { text });
    }
    let part = spec.target.name();
    make_parent(folder)?;
    let written = write_folder_whole(folder, |aside| {
        Ok(shown.write(aside, &part, &sets, progress, work)?)
    })?;
    let lights = sets.iter().zip(shown.lights()).zip(written.movies);
    let lights = lights.map(|((set, light), movie)| ExportedLight {
        name: set.light.map(str::to_owned),
        canvas: [set.grid.columns, set.grid.rows],
        frames: set.grid.frames(),
        frame_rate: movie.as_ref().map(|movie| movie.check.frame_rate),
        movie: movie.map(|movie| movie.file),
        budget: light.budget,
    });
    Ok(Exported {
        lights: lights.collect(),
        folder: folder.to_owned(),
    })
}

/// What to say of frames with fewer levels than the run was evaluated with.
fn rounded_anew(run: &Path, bits: u32) -> Option<String> {
    let judged = Document::read(&run.join("job.toml")).ok()?;
    let judged = judged.root.pointer("/evaluate/bit_depth")?.as_u64()?;
    (u64::from(bits) < judged).then(|| {
        format!(
            "the patterns are rounded anew, to {}, where the run was evaluated with {judged}: these frames print something else than its report says, in another time. \
             `tomolith simulate JOB --patterns FRAMES --set evaluate.bit_depth={bits}` tells what; `tomolith run` with that key improves patterns on few levels",
            counted(bits as usize, "bit")
        )
    })
}

/// The dose at which the run's print is solid, from its report; says where nothing of it ever is.
fn gel_dose(job: &Job, run: &Path, progress: &mut dyn Progress) -> Result<Option<f64>> {
    let path = run.join("report.json");
    let text = read_text(&path)?;
    let report: Value = serde_json::from_str(&text)
        .map_err(|e| Error::format(&path, e.to_string(), "the report of a run"))?;
    if !report["schema"].is_string() {
        return Err(Error::format(&path, "no `schema`", "the report of a run"));
    }
    for (is_so, text) in [
        (
            report["is_toy"] == true,
            "these are the frames of a toy of the job, whose pixels are three times as large: for a machine, run the job without `--toy`",
        ),
        (
            report["evaluation"]["part"]["max"].as_f64() == Some(0.0),
            "the patterns of this run leave no dose in the part: these frames print nothing",
        ),
    ] {
        if is_so {
            let text = text.to_owned();
            progress.event(&Event::Warning { text });
        }
    }
    let together = &report["one_exposure"]["gel_dose"];
    if together.is_f64() {
        return Ok(together.as_f64());
    }
    let Some(threshold) = report["evaluation"]["gel_threshold"].as_f64() else {
        return Ok(None);
    };
    let section = Section::new("response", job.spec.response.clone());
    let response = response(&section.based(&job.base()))?;
    Ok(Some(f64::from(response.inverse(threshold as f32))))
}

/// Bytes that an entry of a matrix takes while it is collected and sorted.
const BYTES_PER_ENTRY: f64 = 36.0;

/// Writes the dose model of a job on its own grid as SciPy's CSR `.npz`; returns rows, columns and entries.
///
/// # Errors
/// As a run, before any work; [`Error::Config`] for a job that is too large; [`Error::Unsupported`] for a model that is
/// not linear; [`Error::Canceled`].
pub fn matrix(
    job: &Job,
    path: &Path,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<[usize; 3]> {
    watched(progress, work, |progress| {
        matrix_stages(job, path, progress, work)
    })
}

fn matrix_stages(
    job: &Job,
    path: &Path,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<[usize; 3]> {
    stage(progress, work, "reading the job");
    let resolved = ResolvedJob::under(job, work)?;
    let family = resolved.optics.family(&resolved.grid)?;
    must_be_linear(&family).map_err(|e| job.locate(e))?;
    let asked = resolved.optics.model.as_ref();
    // The vial turns as it does for the optimization
    let lights = &resolved.levels[resolved.levels.len() - 1].lights;
    let scene = resolved.optics.scene().lit_by(lights);
    let plan = planner::plan(asked, scene, &resolved.grid, None, work)?;
    if !family.capabilities().is_stored {
        let text = format!("the dose on {}", described(&resolved.grid, lights));
        progress.event(&Event::Note { text });
    }
    let entries = if family.capabilities().fills {
        let (voxels, pixels) = (resolved.grid.len() as f64, resolved.extent.pixels as f64);
        let text = format!(
            "light that spreads reaches every voxel from every pixel: {:.2e} entries",
            voxels * pixels
        );
        progress.event(&Event::Note { text });
        voxels * pixels
    } else {
        plan.model.updates() as f64
    };
    let needed_mb = (entries * BYTES_PER_ENTRY / 1e6) as u64;
    require(
        "grid.pitch_mm",
        "memory for the matrix",
        needed_mb,
        resolved.memory_budget_mb(),
        "fewer voxels, pixels or angles; try `--toy`",
    )?;
    progress.event(&Event::Note { text: plan.reason });
    for text in left_out_of_matrix(&resolved) {
        progress.event(&Event::Warning { text });
    }
    let lighting = stage(progress, work, "lighting every pixel");
    matrix::export(&plan.model, path, &lighting)
}

/// What of a job's dose its matrix leaves out.
fn left_out_of_matrix(job: &ResolvedJob) -> Vec<String> {
    let rows = job.rows().unwrap_or_default();
    let mut weights = rows.iter().flat_map(|(_, weights)| weights);
    let weighs = weights.any(|weight| *weight != 1.0).then(|| {
        "the matrix has the dose of all lights together; for the dose of a species multiply the columns of each light by what `species.driven_by` gives it".to_owned()
    });
    let diffuses = job.diffusion().is_some().then(|| {
        "the matrix has the dose as it is written; that it diffuses (material.diffusion) comes on top".to_owned()
    });
    weighs.into_iter().chain(diffuses).collect()
}

/// Refuses models that no matrix stands for.
fn must_be_linear(family: &Family) -> Result<()> {
    match family.capabilities().linear_instead {
        None => Ok(()),
        Some(instead) => Err(Error::config(
            format!("model.{}", family.name()),
            "the dose is not linear in the patterns, and a matrix is",
            format!("another model, or none; {instead}"),
        )),
    }
}

/// Draws calibration frames for the machine of a job (each light has its own folder, when there are several).
///
/// # Errors
/// As [`Calibration::new`] and [`Calibration::draw`]; [`Error::Config`] when the folder is not empty.
pub fn calibrate(job: &Job, names: &[&str], folder: &Path) -> Result<Vec<PathBuf>> {
    let optics = Optics::new(&job.spec, &job.base()).map_err(|e| job.locate(e))?;
    let several = of_lights(&job.spec);
    let mut written = Vec::new();
    must_be_free("--output", folder)?;
    for (i, (light, name)) in optics.lights.iter().zip(several).enumerate() {
        let printer = job.spec.printer_of(i).unwrap_or_default();
        let calibration = Calibration::new(&printer, &light.pixels, job.spec.evaluate.bit_depth)
            .map_err(|e| job.locate(e))?;
        let place = name.map_or_else(|| folder.to_owned(), |name| folder.join(name));
        written.extend(draw(&calibration, names, &place)?);
    }
    Ok(written)
}

/// Draws frames of these names, each `NAME.png`, into a new folder.
///
/// # Errors
/// As [`Calibration::draw`]; [`Error::Io`].
pub fn draw(calibration: &Calibration, names: &[&str], folder: &Path) -> Result<Vec<PathBuf>> {
    if let Some(twice) = (1..names.len()).find(|&i| names[..i].contains(&names[i])) {
        let found = format!("`{}` twice", names[twice]);
        return Err(Error::config("calibration", found, "each frame once"));
    }
    let drawn = names
        .iter()
        .map(|name| calibration.draw(name))
        .collect::<Result<Vec<_>>>()?;
    must_be_free("--output", folder)?;
    make_parent(folder)?;
    write_folder_whole(folder, |aside| {
        for (name, frame) in names.iter().zip(&drawn) {
            let file = aside.join(format!("{name}.png"));
            write_picture(&file, &frame.frames(None, calibration.channel()))?;
        }
        Ok(())
    })?;
    Ok(names
        .iter()
        .map(|name| folder.join(format!("{name}.png")))
        .collect())
}

fn make_parent(folder: &Path) -> Result<()> {
    let parent = folder.parent().unwrap_or(Path::new(""));
    std::fs::create_dir_all(parent).map_err(|e| unusable("--output", parent, "cannot be made", e))
}
