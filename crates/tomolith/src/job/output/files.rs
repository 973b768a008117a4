//! The files of a run folder.

use super::folder::RunFolder;
use super::frames::{Shown, ShownLight};
use super::summary::{earlier, large};
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
use crate::job::evaluate::in_time::InTime;
use crate::job::evaluate::light_paths::scene;
use crate::job::evaluate::limits::limits;
use crate::job::evaluate::property::{Property, properties};
use crate::job::evaluate::{Evaluated, SpeciesPrint};
use crate::job::optimize::Optimized;
use crate::job::optimize::gray_levels::sentence;
use crate::job::optimize::stage::goal_of;
use crate::job::output::folder::Leaves;
use crate::job::progress::{Event, Progress, left_out};
use crate::job::resolve::free_parameters::FoundResponse;
use crate::job::resolve::{ResolvedJob, Species, Voxels};
use crate::job::spec::file_names::of_network;
use crate::job::spec::read::Job;
use crate::kind::table_of;
use crate::metrics::Evaluation;
use crate::metrics::isosurface::Isosurface;
use crate::metrics::print::{PatternStats, Print, surface_pieces};
use crate::metrics::published::unit_systems::{Converted, UnitSystem};
use crate::metrics::surface::Deviation;
use crate::models::Run;
use crate::optimize::{Row, relative_gradient};
use crate::report::{
    CeilingReport, ExposureWindow, LightReport, MapReport, MovieReport, OneExposure, PrintLimits,
    ReportData, SpeciesReport, TimeReport, Timing, gap_sentence, write_html, write_json,
    write_print,
};
use crate::units::concise;
use serde_json::json;
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
///
/// # Errors
/// [`Error::Io`](crate::Error::Io), and what a format cannot hold.
pub(crate) fn all(
    done: &Done<'_>,
    folder: &RunFolder,
    timings: Vec<Timing>,
    progress: &mut dyn Progress,
    run: &Run,
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
        .map(|(i, levels)| levels.frames(resolved.light_name(i)))
        .collect();
    let gel_dose = evaluated.gel_dose(resolved);
    let printers = resolved.printers.as_deref();
    let shown = Shown::new(resolved.showing(), printers, &frames, gel_dose)?;
    let overrun = shown.overrun(of_bound(resolved, &patterns.shown).is_some());
    if let Some(text) = overrun.clone() {
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
        Leaves::Patterns => write_patterns(&new.join("patterns.npz"), &pairs, run)?,
        Leaves::All => large_files(
            done,
            &new,
            (&pairs, &sets),
            &shown,
            &mut made,
            progress,
            run,
        )?,
    }
    made.warnings.extend(overrun);
    if done.leaves == Leaves::All {
        write_time(done, &new, progress, &mut made.warnings, run)?;
        run.check()?;
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
    run: &Run,
) -> Result<()> {
    let (resolved, voxels) = (&done.resolved, &done.voxels);
    let (first, properties) = (done.evaluated.first(), made.properties);
    let arrays = || -> Result<()> {
        write_patterns(&new.join("patterns.npz"), pairs, &run.part(0.2))?;
        let share = 0.05 / resolved.species.len() as f64;
        for (name, dose) in doses(done) {
            write_volume(&new.join(format!("{name}.npy")), dose, &run.part(share))?;
        }
        for property in properties {
            let file = new.join(format!("{}.npy", property.name));
            write_volume(&file, &property.values, &run.aside())?;
        }
        if resolved.output().evaluation {
            write_evaluation(first, &new.join("evaluation"), run)?;
        }
        write_volumes(done, properties, &new.join("volumes"), run)?;
        write_vti(
            &new.join("dose.vti"),
            &first.dose.grid,
            &[
                ("dose", Values::F32(&first.dose.values)),
                ("target", Values::F32(&voxels[0].target.inside.values)),
                ("label", Values::U8(&voxels[0].labels.values)),
            ],
            &run.part(0.1),
        )
    };
    // The large arrays go to the disk while frames, movies and the surface are made
    let (arrays, written) = std::thread::scope(|scope| {
        let arrays = scope.spawn(arrays);
        let written = shown.write(new, &resolved.name, sets, progress, &run.part(0.35));
        let written = written.and_then(|mut written| {
            let surface = print(resolved, first, new, run.part(0.15));
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
fn write_evaluation(print: &SpeciesPrint, folder: &Path, run: &Run) -> Result<()> {
    std::fs::create_dir(folder).map_err(|e| Error::io(folder, e))?;
    let fine = &print.fine;
    write_volume(&folder.join("response.npy"), &print.response, &run.aside())?;
    write_volume(
        &folder.join("target.npy"),
        &fine.target.inside,
        &run.aside(),
    )?;
    write_volume(&folder.join("labels.npy"), &fine.labels, &run.aside())
}

/// All arrays on the job's voxels, in each of the formats that the job names.
fn write_volumes(done: &Done<'_>, properties: &[Property], folder: &Path, run: &Run) -> Result<()> {
    let formats = &done.resolved.output().volumes;
    if formats.is_empty() {
        return Ok(());
    }
    std::fs::create_dir(folder).map_err(|e| Error::io(folder, e))?;
    let write = |name: &str, grid: &VolumeGrid, values: Values<'_>| {
        formats.iter().try_for_each(|format| {
            let path = folder.join(format!("{name}.{}", format.ending()));
            write_values(&path, name, grid, values, &run.aside())
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
/// What to think of the numbers of a toy.
const TOY: &str = "what it prints says little of what the job prints";

/// What was made on the way to the report.
struct Made<'a> {
    properties: &'a [Property],
    movies: Vec<MovieReport>,
    deviation: Option<Cow<'a, Deviation>>,
    timings: Vec<Timing>,
    models: Vec<(&'static str, String)>,
    /// What was left out.
    warnings: Vec<String>,
}

/// The models that gave the doses, by purpose.
fn models(done: &Done<'_>) -> Vec<(&'static str, String)> {
    let optimized = done.optimized.as_ref();
    let optimized = optimized.map(|optimized| ("optimization", optimized.model.clone()));
    let evaluated = ("evaluation", done.evaluated.model.clone());
    optimized.into_iter().chain([evaluated]).collect()
}

/// `report.json` and `report.html`.
fn report(
    done: &Done<'_>,
    folder: &Path,
    history: &[HistoryRow],
    made: Made<'_>,
    exposures: &Shown<'_>,
    headline: &Headline,
) -> Result<()> {
    let Done {
        job,
        resolved,
        evaluated,
        ..
    } = done;
    let first = evaluated.first();
    let found = done.optimized.as_ref().and_then(|o| o.found.as_ref());
    let found_ceiling = done.optimized.as_ref().and_then(|o| o.ceiling.as_ref());
    let found_ceiling = found_ceiling.map(|found| &found.report);
    let data = ReportData {
        part: &resolved.name,
        program: concat!("Tomolith ", env!("CARGO_PKG_VERSION")),
        created: &date(std::time::SystemTime::now()),
        is_toy: done.job.is_toy,
        facts: facts(done),
        models: made.models,
        exposure: headline.exposures.first().and_then(Option::as_ref),
        limits: &headline.limits[0],
        lights: lights(done, exposures.lights()),
        labels: &first.fine.labels,
        response: &first.response,
        inside: Some(&first.fine.target.inside),
        bodies: evaluated.bodies.as_ref(),
        window: window(done, resolved.first()),
        evaluation: &first.evaluation,
        optimization: first.optimization.as_ref(),
        objectives: &evaluated.objectives,
        published: published(done, exposures.lights())?,
        species: species(done, headline),
        one_exposure: headline.one_exposure.as_ref(),
        time: time(done),
        one_moment: evaluated.in_time.as_ref().and_then(InTime::together),
        maps: made.properties.iter().map(map).collect(),
        history,
        kept: done.optimized.as_ref().map(|o| o.outcome.kept),
        scenarios: evaluated.scenarios.as_ref(),
        found_window: done.optimized.as_ref().and_then(|o| o.window),
        found_response: found.map_or(&[], |found| found.values.as_slice()),
        gap: done.optimized.as_ref().and_then(|o| o.outcome.gap()),
        levels: done
            .optimized
            .as_ref()
            .and_then(|o| o.levels.as_ref())
            .map(|levels| levels.gain),
        ceiling: found_ceiling,
        deviation: made.deviation.as_deref(),
        movies: made.movies,
        scene: Some(&scene(resolved)),
        job_text: &job.complete().to_toml()?,
        notes: (resolved.notes.iter().cloned())
            .chain(found_ceiling.map(CeilingReport::sentence))
            .collect(),
        warnings: [
            done.warnings.as_slice(),
            &evaluated.warnings,
            &made.warnings,
        ]
        .concat(),
        timings: made.timings,
    };
    write_json(&folder.join("report.json"), &data)?;
    if done.leaves < Leaves::All {
        return Ok(());
    }
    write_html(&folder.join("report.html"), &data)
}

fn lights<'a>(done: &'a Done<'_>, exposures: &[ShownLight]) -> Vec<LightReport<'a>> {
    let shown = done.patterns.shown.iter().zip(exposures);
    let lights = done.resolved.optics.lights.iter();
    let named = lights.zip(done.resolved.names_of_lights());
    let mut reports = Vec::with_capacity(exposures.len());
    for ((patterns, exposure), (light, name)) in shown.zip(named) {
        reports.push(LightReport {
            name: name.unwrap_or(""),
            patterns,
            bits: exposure.bits,
            full_scale: exposure.white,
            wavelength_nm: Some(light.wavelength_nm),
            canvas: exposure.canvas,
            budget: exposure.budget,
            irradiance: exposure.irradiance,
        });
    }
    reports
}

/// The print in time of every network.
fn time<'a>(done: &'a Done<'_>) -> Vec<&'a TimeReport> {
    let in_time = done.evaluated.in_time.iter();
    let networks = in_time.flat_map(|in_time| &in_time.networks);
    networks.map(|network| &network.report).collect()
}

/// The files of the print in time: curves, when each voxel becomes solid, and a movie of the middle slice.
fn write_time(
    done: &Done<'_>,
    new: &Path,
    progress: &mut dyn Progress,
    warnings: &mut Vec<String>,
    run: &Run,
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
        write_volume(&file, &network.report.cure_times, &run.aside())?;
        if done.resolved.showing().has_movie() {
            let movie = network.write_movie(&new.join(format!("print{end}.mp4")), run);
            left_out(MOVIE_IN_TIME, movie, progress, warnings)?;
        }
    }
    Ok(())
}

fn map(property: &Property) -> MapReport<'_> {
    MapReport {
        name: &property.name,
        unit: &property.unit,
        is_logarithmic: property.is_logarithmic,
        values: &property.values,
    }
}

/// The thresholds of a species at the end of the optimization.
fn window(done: &Done<'_>, species: &Species) -> Option<[f64; 2]> {
    let wider = done.optimized.as_ref().map_or(0, |own| own.wider);
    goal_of(species, wider).thresholds()
}

/// What every species prints, where the job names some.
fn species<'a>(done: &'a Done<'_>, headline: &'a Headline) -> Vec<SpeciesReport<'a>> {
    let Done {
        resolved,
        evaluated,
        ..
    } = done;
    let Some(rows) = &resolved.mixing else {
        return Vec::new();
    };
    let said = headline.exposures.iter().zip(&headline.limits);
    let prints = resolved.species.iter().zip(&evaluated.species);
    let mut reports = Vec::with_capacity(rows.len());
    for (((name, row), (species, print)), (exposure, limits)) in rows.iter().zip(prints).zip(said) {
        let light =
            |(light, &factor): (Option<&str>, &f64)| (light.unwrap_or_default().to_owned(), factor);
        reports.push(SpeciesReport {
            name,
            driven_by: resolved.names_of_lights().zip(row).map(light).collect(),
            evaluation: &print.evaluation,
            labels: &print.fine.labels,
            response: &print.response,
            inside: &print.fine.target.inside,
            window: window(done, species),
            exposure: *exposure,
            limits,
        });
    }
    reports
}

/// Numbers as they were published, those of each slice, and the units of the publications.
fn published(
    done: &Done<'_>,
    exposures: &[ShownLight],
) -> Result<serde_json::Map<String, serde_json::Value>> {
    let evaluated = &done.evaluated;
    let mut map = table_of(evaluated.published.iter().map(|p| {
        let about = json!({
            "value": p.value, "unit": p.unit, "source": p.source, "note": p.note,
        });
        (p.name.clone(), about)
    }));
    map.insert("slices".to_owned(), json!(evaluated.slices));
    let rows = unit_systems(done, exposures)?;
    let more = [
        ("keep_dark", evaluated.keep_dark.map(|dark| json!(dark))),
        ("insert", evaluated.contact.map(|contact| json!(contact))),
        ("paths", evaluated.noise.map(|noise| json!(noise))),
        ("orders", evaluated.agreement.map(|found| json!(found))),
        ("unit_systems", (!rows.is_empty()).then(|| json!(rows))),
    ];
    map.extend(
        more.into_iter()
            .filter_map(|(key, value)| Some((key.to_owned(), value?))),
    );
    Ok(map)
}

/// The brightest pixel and the dose that turns the resin solid in the units of publications. Doses of a job are relative: these
/// are energies where the job says which dose the resin needs, and rates where it says how bright the machine is, too.
fn unit_systems(done: &Done<'_>, exposures: &[ShownLight]) -> Result<Vec<Converted>> {
    let resin = done.resolved.resin();
    let critical = resin.critical_dose_mj_per_mm3.filter(|_| !resin.pure_radon);
    let (Some(critical), Some(gel_dose)) = (critical, done.evaluated.gel_dose(&done.resolved))
    else {
        return Ok(Vec::new());
    };
    let of_light = |(shown, exposure): (_, &ShownLight)| {
        (PatternStats::of([shown]).max, exposure.budget.time_s)
    };
    let lights = done.patterns.shown.iter().zip(exposures).map(of_light);
    let brightest = lights.max_by(|a, b| a.0.total_cmp(&b.0));
    let (brightest, time_s) = brightest.unwrap_or_default();
    let convert = |system: UnitSystem| {
        // Energies do not depend on the time
        let exposure_s = if system.needs_time() { time_s? } else { 1.0 };
        let pattern = f64::from(brightest) * critical / gel_dose;
        Some(system.convert(pattern, critical, resin.active_per_mm(), exposure_s))
    };
    Ok(UnitSystem::ALL.into_iter().filter_map(convert).collect())
}

/// The voxels of the numbers, which are not those of `dose.npy`.
fn evaluated_on(grid: &VolumeGrid) -> String {
    let [nz, ny, nx] = grid.shape;
    format!(
        "{nx} × {ny} × {nz} voxels of {} µm: all numbers; dose.npy is on the voxels of the grid (output.evaluation = true writes these too)",
        concise(1e3 * grid.pitch_mm)
    )
}

/// Those facts that there are.
fn known<const N: usize>(
    facts: [(&'static str, Option<String>); N],
) -> impl Iterator<Item = (&'static str, String)> {
    let facts = facts.into_iter();
    facts.filter_map(|(name, text)| Some((name, text?)))
}

/// Short facts for the head of the page.
fn facts(done: &Done<'_>) -> Vec<(String, String)> {
    let Done {
        job,
        resolved,
        optimized,
        evaluated,
        source,
        ..
    } = done;
    let resin = resolved.resin();
    let [nz, ny, nx] = resolved.grid.shape;
    let mut facts = Vec::new();
    if job.is_toy {
        facts.push(("A toy", TOY.to_owned()));
    }
    facts.extend([
        ("Vial", resolved.optics.vial_kind.to_owned()),
        (
            "Resin",
            match resin.active_per_mm() {
                0.0 => format!("n {}, no absorption", resin.refractive_index),
                active => format!("n {}, μ {active} per mm", resin.refractive_index),
            },
        ),
        (
            "Grid",
            format!(
                "{nx} × {ny} × {nz} voxels of {} µm",
                concise(1e3 * resolved.grid.pitch_mm)
            ),
        ),
        (
            "Evaluated on",
            evaluated_on(&evaluated.first().fine.labels.grid),
        ),
        ("Frames", resolved.extent.frames.to_string()),
    ]);
    if let Some(optimized) = optimized {
        facts.extend(facts_of_optimization(resolved, optimized));
    }
    if let Some(source) = source {
        facts.push(("Patterns from", source.display().to_string()));
        facts.push(("Model", evaluated.model.clone()));
    }
    facts.extend(known([
        (
            "Scenarios",
            evaluated.scenarios.as_ref().map(|s| s.sentence()),
        ),
        (
            "Keep-dark body",
            evaluated.keep_dark.map(|dark| format!("gets {dark}")),
        ),
        (
            "Insert",
            evaluated.contact.map(|contact| contact.to_string()),
        ),
        (
            "Monte Carlo paths",
            evaluated.noise.map(|noise| noise.to_string()),
        ),
        (
            "Scattering by orders",
            evaluated.agreement.map(|found| found.to_string()),
        ),
    ]));
    facts
        .into_iter()
        .map(|(name, text)| (name.to_owned(), text))
        .collect()
}

/// How the patterns were found.
fn facts_of_optimization(
    resolved: &ResolvedJob,
    optimized: &Optimized,
) -> Vec<(&'static str, String)> {
    let outcome = &optimized.outcome;
    let seconds = outcome.counters.model_s.max(1e-9);
    let calls = outcome.counters.forward + outcome.counters.adjoint;
    let speed = large(calls as f64 * optimized.updates as f64 / seconds);
    let mut facts = vec![("Optimizer", resolved.method.name().to_owned())];
    let last = outcome.history.last().map_or(0, |row| row.iteration);
    if outcome.kept.iteration != last {
        facts.push(("Kept", earlier(outcome.kept, last)));
    }
    let bits = resolved.evaluation().bit_depth;
    let (found, levels) = (optimized.found.as_ref(), optimized.levels.as_ref());
    facts.extend(known([
        ("Lowest loss", outcome.gap().and_then(gap_sentence)),
        ("Process window", optimized.window.map(|w| w.sentence())),
        ("Response found", found.map(FoundResponse::sentence)),
        ("Levels", levels.map(|levels| sentence(bits, &levels.gain))),
    ]));
    facts.push(("Model", optimized.model.clone()));
    let what = "voxel-angle updates per second, with those that searches leave out";
    facts.push(("Speed", format!("{speed}{what}")));
    facts
}

/// Date and time, UTC.
fn date(now: std::time::SystemTime) -> String {
    let seconds = now
        .duration_since(std::time::UNIX_EPOCH)
        .map_or(0, |d| d.as_secs());
    let (days, minutes) = (seconds / 86_400, seconds % 86_400 / 60);
    // Counted from 1 March of the year 0 on, years end with the leap day, and 400 of them have 146,097 days
    let days = days + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    // From March on months have 31, 30, 31, 30, 31, 31, 30, … days: 153 each five
    let month = (5 * day + 2) / 153;
    format!(
        "{}-{:02}-{:02} {:02}:{:02} UTC",
        400 * era + year + month / 10,
        (month + 2) % 12 + 1,
        day - (153 * month + 2) / 5 + 1,
        minutes / 60,
        minutes % 60
    )
}

/// The predicted surface on all voxels of the evaluation, as `print.stl`; and the one that its distances are measured on, with how far it
/// is off, as `print.ply`, where there is a target to compare it with.
fn print<'a>(
    resolved: &ResolvedJob,
    first: &'a SpeciesPrint,
    folder: &Path,
    run: Run,
) -> Result<Option<Cow<'a, Deviation>>> {
    let (labels, response) = (&first.fine.labels, &first.response);
    let (threshold, writing) = (first.evaluation.gel_threshold, run.aside());
    write_stl_pieces(
        &folder.join("print.stl"),
        &format!("{}, predicted print", resolved.name),
        |put| {
            let Some(threshold) = threshold else {
                return Ok(());
            };
            let take = |piece: &Isosurface| put(&piece.corners, &piece.triangles);
            surface_pieces((labels, response), threshold, take, &run)
        },
        &writing,
    )?;
    let deviation = match (&first.deviation, threshold) {
        (_, None) => None,
        (Some(measured), _) => Some(Cow::Borrowed(measured)),
        (None, Some(threshold)) => {
            let print = Print::under(labels, response, run)?
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::{Duration, UNIX_EPOCH};

    #[test]
    fn dates_are_those_of_the_calendar() {
        let at = |seconds| date(UNIX_EPOCH + Duration::from_secs(seconds));
        assert_eq!(at(0), "1970-01-01 00:00 UTC");
        assert_eq!(at(951_782_400), "2000-02-29 00:00 UTC");
        assert_eq!(at(1_795_262_399), "2026-11-21 11:59 UTC");
    }
}
