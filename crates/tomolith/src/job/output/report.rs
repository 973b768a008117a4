//! `report.json` and `report.html`: what a run found, in the words of the report.

use super::files::{Done, Headline};
use super::frames::{Shown, ShownLight};
use super::summary::{earlier, large};
use crate::error::Result;
use crate::grid::VolumeGrid;
use crate::io::csv::HistoryRow;
use crate::job::evaluate::in_time::InTime;
use crate::job::evaluate::light_paths::scene;
use crate::job::evaluate::property::Property;
use crate::job::optimize::Optimized;
use crate::job::optimize::gray_levels::sentence;
use crate::job::optimize::stage::goal_of;
use crate::job::output::folder::Leaves;
use crate::job::resolve::free_parameters::FoundResponse;
use crate::job::resolve::{ResolvedJob, Species};
use crate::kind::table_of;
use crate::metrics::print::PatternStats;
use crate::metrics::published::unit_systems::{Converted, UnitSystem};
use crate::metrics::surface::Deviation;
use crate::optics::resin::Resin;
use crate::report::{
    CeilingReport, LightReport, MapReport, MovieReport, ReportData, SpeciesReport, TimeReport,
    Timing, gap_sentence, write_html, write_json,
};
use crate::units::concise;
use serde_json::json;
use std::borrow::Cow;
use std::path::Path;

/// What to think of the numbers of a toy.
pub(super) const TOY: &str = "what it prints says little of what the job prints";

/// What was made on the way to the report.
pub(super) struct Made<'a> {
    pub(super) properties: &'a [Property],
    pub(super) movies: Vec<MovieReport>,
    pub(super) deviation: Option<Cow<'a, Deviation>>,
    pub(super) timings: Vec<Timing>,
    pub(super) models: Vec<(&'static str, String)>,
    /// What was left out.
    pub(super) warnings: Vec<String>,
}

/// The models that gave the doses, by purpose.
pub(super) fn models(done: &Done<'_>) -> Vec<(&'static str, String)> {
    let optimized = done.optimized.as_ref();
    let optimized = optimized.map(|optimized| ("optimization", optimized.model.clone()));
    let evaluated = ("evaluation", done.evaluated.model.clone());
    optimized.into_iter().chain([evaluated]).collect()
}

/// `report.json` and `report.html`.
pub(super) fn report(
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
        lights: lights(done, exposures.lights()),
        species: species(done, headline),
        bodies: evaluated.bodies.as_ref(),
        optimization: evaluated.first().optimization.as_ref(),
        objectives: &evaluated.objectives,
        published: published(done, exposures.lights())?,
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
    let wider = done
        .optimized
        .as_ref()
        .map_or(0, |optimized| optimized.wider);
    goal_of(species, wider).thresholds()
}

/// What every species prints; the only one of a job that names none has no name.
fn species<'a>(done: &'a Done<'_>, headline: &'a Headline) -> Vec<SpeciesReport<'a>> {
    let Done {
        resolved,
        evaluated,
        ..
    } = done;
    let judged = headline.exposures.iter().zip(&headline.limits);
    let prints = resolved.species.iter().zip(&evaluated.species);
    let mut reports = Vec::with_capacity(resolved.species.len());
    for (s, ((species, print), (exposure, limits))) in prints.zip(judged).enumerate() {
        let row = resolved.mixing.as_ref().map(|rows| &rows[s]);
        let (name, factors) = row.map_or(("", &[][..]), |(name, factors)| (name, factors));
        let light =
            |(light, &factor): (Option<&str>, &f64)| (light.unwrap_or_default().to_owned(), factor);
        reports.push(SpeciesReport {
            name,
            driven_by: resolved.names_of_lights().zip(factors).map(light).collect(),
            evaluation: &print.evaluation,
            labels: &print.fine.labels,
            response: &print.response,
            quantity: species.goal.quantity(),
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
    let resins = done.resolved.optics.lights.iter().map(|light| &light.resin);
    let of_light = |((shown, exposure), resin): ((_, &ShownLight), &Resin)| {
        // A schedule has dark times, too
        let time_s = exposure
            .budget
            .time_s
            .filter(|_| exposure.irradiance.is_none());
        let active_per_mm = resin.absorption_per_mm;
        (PatternStats::of([shown]).max, time_s, active_per_mm)
    };
    let lights = done
        .patterns
        .shown
        .iter()
        .zip(exposures)
        .zip(resins)
        .map(of_light);
    let brightest = lights.max_by(|a, b| a.0.total_cmp(&b.0));
    let (brightest, time_s, active_per_mm) = brightest.unwrap_or_default();
    let convert = |system: UnitSystem| {
        // Energies do not depend on the time
        let exposure_s = if system.needs_time() { time_s? } else { 1.0 };
        let pattern = f64::from(brightest) * critical / gel_dose;
        Some(system.convert(pattern, critical, active_per_mm, exposure_s))
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
    let evaluate = resolved.evaluation();
    let few = evaluate.has_few_levels().then_some(evaluate.bit_depth);
    let (found, levels) = (optimized.found.as_ref(), optimized.levels.as_ref());
    facts.extend(known([
        ("Lowest loss", outcome.gap().and_then(gap_sentence)),
        ("Process window", optimized.window.map(|w| w.sentence())),
        ("Response found", found.map(FoundResponse::sentence)),
        ("Machine", levels.map(|levels| sentence(few, &levels.gain))),
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
