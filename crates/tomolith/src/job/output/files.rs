//! The files of a run folder.

use super::folder::RunFolder;
use super::frames::Shown;
use super::report::{Made, TOY, models, report};
use crate::error::{Error, Result};
use crate::grid::{Volume, VolumeGrid};
use crate::io::csv::{HistoryRow, write_history};
use crate::io::frames::FrameSet;
use crate::io::npy::{PatternPair, write_patterns, write_volume};
use crate::io::stl::write_stl_pieces;
use crate::io::volume::{Values, write_values};
use crate::io::vti::write_vti;
use crate::io::write_text;
use crate::job::dose::written::Written;
use crate::job::evaluate::doubts::of_bound;
use crate::job::evaluate::limits::limits;
use crate::job::evaluate::property::{Property, properties};
use crate::job::evaluate::{Evaluated, SpeciesPrint};
use crate::job::optimize::Optimized;
use crate::job::output::folder::Leaves;
use crate::job::progress::{Event, Progress, left_out};
use crate::job::resolve::{ResolvedJob, Species, Voxels};
use crate::job::spec::file_names::of_network;
use crate::job::spec::read::Job;
use crate::metrics::Evaluation;
use crate::metrics::isosurface::Isosurface;
use crate::metrics::print::{Print, surface_pieces};
use crate::metrics::surface::Deviation;
use crate::models::Work;
use crate::optimize::{Row, relative_gradient};
use crate::report::{ExposureWindow, OneExposure, PrintLimits, Timing, write_print};
use crate::units::concise;
use std::borrow::Cow;
use std::panic::resume_unwind;
use std::path::Path;

/// Everything there is at the end of a run.
pub(crate) struct Done<'a> {
    pub(crate) job: &'a Job,
    pub(crate) resolved: ResolvedJob,
    pub(crate) voxels: Vec<Voxels>,
    pub(crate) patterns: Written,
    pub(crate) evaluated: Evaluated,
    /// None for a simulation.
    pub(crate) optimized: Option<Optimized>,
    /// Where the patterns of a simulation came from.
    pub(crate) source: Option<&'a Path>,
    /// Which files the caller wants.
    pub(crate) leaves: Leaves,
    pub(crate) warnings: Vec<String>,
}

/// Writes everything to the folder's new files; what a run says first.
pub(crate) fn all(
    done: &Done<'_>,
    folder: &RunFolder,
    timings: Vec<Timing>,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Headline> {
    let Done {
        resolved,
        patterns,
        evaluated,
        ..
    } = done;
    let new = folder.new_files();
    let pairs: Vec<PatternPair<'_>> = patterns
        .shown
        .iter()
        .enumerate()
        .map(|(i, shown)| PatternPair {
            light: resolved.light_name(i),
            shown,
            raw: patterns.raw.as_ref().map(|raw| &raw[i]),
        })
        .collect();
    let frames = patterns.frames(resolved)?;
    let sets: Vec<FrameSet<'_>> = frames
        .iter()
        .enumerate()
        .map(|(i, levels)| levels.frames(resolved.light_name(i), resolved.showing().channel(i)))
        .collect();
    let gel_dose = evaluated.gel_dose(resolved);
    let printers = resolved.printers.as_deref();
    let shown = Shown::new(resolved.showing(), printers, &frames, gel_dose)?;
    let of_time = shown.warnings(of_bound(resolved, &patterns.shown).is_some());
    for text in of_time.clone() {
        progress.event(&Event::Warning { text });
    }
    let properties = properties(resolved, evaluated);
    let mut made = Made {
        properties: &properties,
        movies: Vec::new(),
        deviation: None,
        timings,
        models: models(done),
        warnings: Vec::new(),
    };
    match done.leaves {
        Leaves::Metrics => {}
        Leaves::Patterns => write_patterns(&new.join("patterns.npz"), &pairs, work)?,
        Leaves::All => large_files(
            done,
            &new,
            (&pairs, &sets),
            &shown,
            &mut made,
            progress,
            work,
        )?,
    }
    made.warnings.extend(of_time);
    if done.leaves == Leaves::All {
        write_time(done, &new, progress, &mut made.warnings, work)?;
        work.check()?;
    }
    let history = done.optimized.as_ref().map(history).unwrap_or_default();
    if !history.is_empty() {
        write_history(&new.join("history.csv"), &history)?;
    }
    folder.describe(&described(done)?, &made.models)?;
    let headline = Headline::of(done, &shown)?;
    report(done, &new, &history, made, &shown, &headline)?;
    Ok(headline)
}

/// Patterns, volumes, frames, movies and the surface of the print.
fn large_files<'a>(
    done: &'a Done<'_>,
    new: &Path,
    (pairs, sets): (&[PatternPair<'_>], &[FrameSet<'_>]),
    shown: &Shown<'_>,
    made: &mut Made<'a>,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<()> {
    let (resolved, voxels) = (&done.resolved, &done.voxels);
    let (first, properties) = (done.evaluated.first(), made.properties);
    let arrays = || -> Result<()> {
        write_patterns(&new.join("patterns.npz"), pairs, &work.part(0.2))?;
        let share = 0.05 / resolved.species.len() as f64;
        for (name, dose) in doses(done) {
            write_volume(&new.join(format!("{name}.npy")), dose, &work.part(share))?;
        }
        for property in properties {
            let file = new.join(format!("{}.npy", property.name));
            write_volume(&file, &property.values, &work.aside())?;
        }
        if resolved.output().evaluation {
            write_evaluation(first, &new.join("evaluation"), work)?;
        }
        write_volumes(done, properties, &new.join("volumes"), work)?;
        write_vti(
            &new.join("dose.vti"),
            &first.dose.grid,
            &[
                ("dose", Values::F32(&first.dose.values)),
                ("target", Values::F32(&voxels[0].target.inside.values)),
                ("label", Values::U8(&voxels[0].labels.values)),
            ],
            &work.part(0.1),
        )
    };
    // The large arrays go to the disk while frames, movies and the surface are made
    let (arrays, written) = std::thread::scope(|scope| {
        let arrays = scope.spawn(arrays);
        let written = shown.write(new, &resolved.name, sets, progress, &work.part(0.35));
        let written = written.and_then(|mut written| {
            let surface = print(resolved, first, new, work.part(0.15));
            let warnings = &mut written.warnings;
            let deviation = left_out(SURFACE, surface, progress, warnings)?;
            Ok((written, deviation.flatten()))
        });
        (arrays.join().unwrap_or_else(|p| resume_unwind(p)), written)
    });
    arrays?;
    let (written, deviation) = written?;
    made.movies = written.movies.into_iter().flatten().collect();
    made.deviation = deviation;
    made.warnings = written.warnings;
    Ok(())
}

/// What the report's numbers are of.
fn write_evaluation(print: &SpeciesPrint, folder: &Path, work: &Work) -> Result<()> {
    std::fs::create_dir(folder).map_err(|e| Error::io(folder, e))?;
    let fine = &print.fine;
    write_volume(&folder.join("response.npy"), &print.response, &work.aside())?;
    write_volume(
        &folder.join("target.npy"),
        &fine.target.inside,
        &work.aside(),
    )?;
    write_volume(&folder.join("labels.npy"), &fine.labels, &work.aside())
}

/// All arrays on the job's voxels, in each of the formats that the job names.
fn write_volumes(
    done: &Done<'_>,
    properties: &[Property],
    folder: &Path,
    work: &Work,
) -> Result<()> {
    let formats = &done.resolved.output().volumes;
    if formats.is_empty() {
        return Ok(());
    }
    std::fs::create_dir(folder).map_err(|e| Error::io(folder, e))?;
    let write = |name: &str, grid: &VolumeGrid, values: Values<'_>| {
        formats.iter().try_for_each(|format| {
            let path = folder.join(format!("{name}.{}", format.ending()));
            write_values(&path, name, grid, values, &work.aside())
        })
    };
    let Voxels { target, labels, .. } = &done.voxels[0];
    let target = std::iter::once(("target".to_owned(), &target.inside));
    let properties = properties.iter().map(|p| (p.name.clone(), &p.values));
    for (name, volume) in doses(done).chain(target).chain(properties) {
        write(&name, &volume.grid, Values::F32(&volume.values))?;
    }
    write("label", &labels.grid, Values::U8(&labels.values))
}

/// The doses of all species, by the names of their files: that of the first is `dose`.
fn doses<'a>(done: &'a Done<'_>) -> impl Iterator<Item = (String, &'a Volume<f32>)> {
    let species = done.resolved.species.iter().zip(&done.evaluated.species);
    species.enumerate().map(|(s, (named, print))| {
        let name = named.name.as_deref().filter(|_| s > 0);
        let file = name.map_or("dose".to_owned(), |name| format!("dose_{name}"));
        (file, &print.dose)
    })
}

/// The job with every default written out, after the parameters of the response that it found.
fn described(done: &Done<'_>) -> Result<String> {
    let found = done.optimized.as_ref().and_then(|o| o.found.as_ref());
    let found = done.resolved.method.free.as_ref().zip(found);
    let found = found.map_or_else(String::new, |(free, found)| found.comments(free));
    Ok(format!("{found}{}", done.job.complete().to_toml()?))
}

/// What a run says first: on its page, in `report.json`, on the screen.
pub(crate) struct Headline {
    /// Over which exposures the print is nearly as good, of every species.
    pub(crate) exposures: Vec<Option<ExposureWindow>>,
    /// The exposure of several species together.
    pub(crate) one_exposure: Option<OneExposure>,
    /// What it loses, and where, of every species.
    pub(crate) limits: Vec<PrintLimits>,
}

impl Headline {
    fn of(done: &Done<'_>, shown: &Shown<'_>) -> Result<Self> {
        let (resolved, evaluated) = (&done.resolved, &done.evaluated);
        // One light after the other. A schedule says itself how long it takes, and its print when to stop
        let times = shown.lights().iter().map(|light| light.budget.time_s);
        let times = times.sum::<Option<f64>>();
        let own_s = times.filter(|_| resolved.schedule().is_none());
        let gel_dose = evaluated.gel_dose(resolved);
        let rate = gel_dose.zip(own_s);
        let window = |(species, print): (&Species, &SpeciesPrint)| {
            let (response, evaluation) = (&species.goal.response, &print.evaluation);
            let dose = |threshold: f64| f64::from(response.inverse(threshold as f32));
            // A resin that gels at a higher dose takes less of the same light
            let time_s = rate
                .zip(evaluation.gel_threshold)
                .map(|((run, seconds), threshold)| seconds * (run / dose(threshold)));
            ExposureWindow::new(evaluation, response.as_ref(), time_s)
        };
        let one_exposure = evaluated.one_exposure.clone();
        let mut limits = limits(
            resolved,
            evaluated,
            done.optimized.as_ref(),
            done.job.is_toy,
        );
        for (limits, print) in limits.iter_mut().zip(&evaluated.species) {
            limits.sentence += &on_voxels(&print.evaluation, resolved.extent.refine);
            if done.job.is_toy && !limits.sentence.contains(" toy ") {
                limits.sentence += &format!(" This is a toy of the job: {TOY}.");
            }
        }
        Ok(Headline {
            exposures: (resolved.species.iter().zip(&evaluated.species))
                .map(window)
                .collect(),
            one_exposure: one_exposure.map(|one| match rate {
                Some((dose, seconds)) => one.in_time(dose, seconds),
                None => one,
            }),
            limits,
        })
    }
}

/// On which voxels a print has no error: none is seen that is smaller than they are.
fn on_voxels(evaluation: &Evaluation, refine: usize) -> String {
    if evaluation
        .measures
        .get("iou")
        .is_none_or(|iou| iou < NO_ERROR)
    {
        return String::new();
    }
    let pitch = concise(evaluation.grid.pitch_mm);
    match refine {
        1 => format!(
            " The IoU is that of the job's own voxels of {pitch} mm; finer ones may show errors (`evaluate.refine`)."
        ),
        _ => format!(" The IoU is that of voxels of {pitch} mm."),
    }
}

/// What a run can do without, and what may help.
const SURFACE: [&str; 2] = ["the surface of the print", "dose.npy has the dose"];
const MOVIE_IN_TIME: [&str; 2] = [
    "the movie of the print in time",
    "output.movie = \"none\" writes none; time.csv and cure_time.npy have the numbers",
];
/// IoU that is shown as 1.000.
const NO_ERROR: f64 = 0.9995;
/// The files of the print in time: curves, when each voxel becomes solid, and a movie of the middle slice.
fn write_time(
    done: &Done<'_>,
    new: &Path,
    progress: &mut dyn Progress,
    warnings: &mut Vec<String>,
    work: &Work,
) -> Result<()> {
    let Some(in_time) = &done.evaluated.in_time else {
        return Ok(());
    };
    for network in &in_time.networks {
        let end = match in_time.networks.len() {
            1 => String::new(),
            _ => of_network(&network.report.name),
        };
        let text = network.report.csv();
        write_text(&new.join(format!("time{end}.csv")), &text)?;
        let file = new.join(format!("cure_time{end}.npy"));
        write_volume(&file, &network.report.cure_times, &work.aside())?;
        if done.resolved.showing().has_movie() {
            let movie = network.write_movie(&new.join(format!("print{end}.mp4")), work);
            left_out(MOVIE_IN_TIME, movie, progress, warnings)?;
        }
    }
    Ok(())
}

/// The predicted surface on all voxels of the evaluation, as `print.stl`; and the one that its distances are measured on, with how far it
/// is off, as `print.ply`, where there is a target to compare it with.
fn print<'a>(
    resolved: &ResolvedJob,
    first: &'a SpeciesPrint,
    folder: &Path,
    work: Work,
) -> Result<Option<Cow<'a, Deviation>>> {
    let (labels, response) = (&first.fine.labels, &first.response);
    let (threshold, writing) = (first.evaluation.gel_threshold, work.aside());
    write_stl_pieces(
        &folder.join("print.stl"),
        &format!("{}, predicted print", resolved.name),
        |put| {
            let Some(threshold) = threshold else {
                return Ok(());
            };
            let take = |piece: &Isosurface| put(&piece.corners, &piece.triangles);
            surface_pieces(labels, response, threshold, take, &work)
        },
        &writing,
    )?;
    let deviation = match (&first.deviation, threshold) {
        (_, None) => None,
        (Some(measured), _) => Some(Cow::Borrowed(measured)),
        (None, Some(threshold)) => {
            let print = Print::under(labels, response, work)?
                .with_most_triangles(resolved.most_triangles())
                .with_inside(&first.fine.target.inside)?
                .with_target_surface(&first.fine.surface)
                .with_threshold(threshold)?;
            print.deviation().map(Cow::Owned)
        }
    };
    if let Some(deviation) = &deviation {
        write_print(&folder.join("print.ply"), &resolved.name, deviation)?;
    }
    Ok(deviation)
}

fn history(optimized: &Optimized) -> Vec<HistoryRow> {
    let rows = &optimized.outcome.history;
    let names = optimized.found.iter().flat_map(|found| &found.values);
    let names: Vec<&String> = names.map(|(name, _)| name).collect();
    let response = |row: &Row| {
        let found = names.iter().zip(&row.response);
        found
            .map(|(name, value)| ((*name).clone(), *value))
            .collect()
    };
    let line = |row: &Row| HistoryRow {
        iteration: row.iteration,
        loss: row.loss,
        projected_gradient: relative_gradient(rows, row),
        step: row.step,
        forward_calls: row.forward as usize,
        adjoint_calls: row.adjoint as usize,
        seconds: row.seconds,
        iou: row.print.and_then(|print| print.iou),
        process_window: row.print.and_then(|print| print.process_window),
        response: response(row),
    };
    rows.iter().map(line).collect()
}
