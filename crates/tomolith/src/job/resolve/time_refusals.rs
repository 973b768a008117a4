//! What a print in time cannot be: schedules and materials that are refused before any work, each at its key.

use super::goal::Goal;
use super::material::material;
use super::schedule::schedule;
use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::job::spec::species::Row;
use crate::job::spec::{Against, JobSpec, LightSpec, MaterialSpec, ScheduleSpec};
use crate::units::exact;
use tomolith_material::domain::Domain;
use tomolith_material::photopolymer::{Inhibitor, Network, Photopolymer};
use tomolith_material::print::{default_step_s, exceeded_limit_s};
use tomolith_material::schedule::Schedule;

/// Checks material and schedule before any work.
pub(crate) fn must_fit(spec: &JobSpec) -> Result<()> {
    let Some(given) = &spec.schedule else {
        return match &spec.material {
            Some(_) => Err(Error::config(
                "schedule",
                "a [material] without a schedule is never lit",
                "a table [schedule], for example with turns = 3",
            )),
            None => Ok(()),
        };
    };
    let dose = given.optimize == Against::Dose;
    if let Some(material) = &spec.material {
        must_be_one(material, dose)?;
    }
    if spec.multiresolution.is_some() && spec.shows_every_frame() {
        return Err(Error::config(
            "multiresolution",
            "coarse levels leave out every other frame, but this schedule needs them all",
            "no [multiresolution] with schedule.optimize = \"frozen\" or \"exact\", or with material.diffusion",
        ));
    }
    must_tell_turns_apart(spec, given)?;
    if given.level_heights && spec.evaluate.improves_levels() {
        return Err(Error::config(
            "schedule.level_heights",
            "patterns on few levels are not made brighter row by row",
            "evaluate.levels = \"rounded\", or level_heights = false",
        ));
    }
    must_be_times(given, &schedule(spec)?)?;
    let mixing = spec.mixing()?;
    let mut domain = Domain::new(VolumeGrid::centered([1, 1, 1], 0.1));
    if spec
        .material
        .as_ref()
        .is_some_and(|material| material.air_on_top)
    {
        domain = domain.with_air_on_top();
    }
    let material = material(spec, mixing.as_deref(), domain)?;
    must_have_thresholds(&material, given)?;
    let rows = mixing.as_deref().unwrap_or_default();
    must_be_in_order(spec, rows)?;
    must_have_inhibitors(spec, rows, given)?;
    must_begin_as_the_resin(spec)
}

/// Refuses steps that do not cut the print, and a simulation that is not done.
fn must_be_times(given: &ScheduleSpec, schedule: &Schedule) -> Result<()> {
    if let Some(step_s) = given.step_s {
        let checked = schedule.must_cut(step_s);
        checked.map_err(|e| e.under("schedule"))?;
    }
    if given.optimize == Against::Frozen && given.rounds == 0 {
        return Err(Error::config(
            "schedule.rounds",
            "found 0: nothing would say what inhibitors take",
            "at least 1 with optimize = \"frozen\"; or optimize = \"dose\"",
        ));
    }
    Ok(())
}

/// Refuses networks whose dose depends on the power where a dose is what counts.
fn must_have_thresholds(material: &Photopolymer, given: &ScheduleSpec) -> Result<()> {
    let (key, accepted) = if given.level_heights {
        (
            "schedule.level_heights",
            "false, or a threshold of the dose",
        )
    } else if given.optimize == Against::Frozen {
        (
            "schedule.optimize",
            "\"exact\" or \"dose\", or a threshold of the dose",
        )
    } else {
        return Ok(());
    };
    let names = material.species();
    let mut names = names.iter().enumerate();
    match names.find(|(s, _)| material.requirement(*s).is_none()) {
        Some((_, name)) => Err(Error::config(
            key,
            format!(
                "{name} cures by a rate law with an exponent below 1: the dose at which it gels depends on the power"
            ),
            accepted,
        )),
        None => Ok(()),
    }
}

/// Refuses shading whose absorption before the cure is not that of the resin: patterns are evaluated in the one, and printed in the other.
fn must_begin_as_the_resin(spec: &JobSpec) -> Result<()> {
    for (i, shading) in spec.shading().iter().enumerate() {
        let at = |key: &str| format!("material.photopolymer.shading[{i}].{key}");
        let resin = spec.resin_of(shading.light);
        if resin.absorption_map.is_some() {
            return Err(Error::config(
                at("light"),
                "resin.absorption_map says how this light is absorbed, and shading says it again",
                "one of the two",
            ));
        }
        let Some(absorption) = resin.absorption_per_mm else {
            continue;
        };
        let scattered = absorption + resin.scattering_per_mm;
        let attenuation = resin.attenuation_per_mm.unwrap_or(scattered);
        for (key, [before, _], wanted) in [
            ("active_per_mm", shading.active_per_mm, absorption),
            (
                "attenuation_per_mm",
                shading.attenuation_per_mm,
                attenuation,
            ),
        ] {
            if (before - wanted).abs() > 1e-6 * wanted {
                return Err(Error::config(
                    at(key),
                    format!("begins with {}", exact(before)),
                    format!(
                        "{} first, as the resin has it before it cures",
                        exact(wanted)
                    ),
                ));
            }
        }
    }
    Ok(())
}

/// Refuses surface-aware cells where patterns are optimized against what diffuses or is used up between voxels.
pub(crate) fn must_be_whole(spec: &JobSpec, goal: &Goal) -> Result<()> {
    let material = spec.material.as_ref();
    let against = spec.schedule.as_ref().map(|given| given.optimize);
    let found = if material.is_some_and(|material| material.diffusion.is_some()) {
        "cells, and material.diffusion, which knows whole voxels only"
    } else if against.is_some_and(|against| against != Against::Dose) {
        "cells, and schedule.optimize, which knows whole voxels only"
    } else {
        return Ok(());
    };
    match goal.cells_key() {
        Some(key) => Err(Error::config(key, found, "\"voxel\" or \"fraction\"")),
        None => Ok(()),
    }
}

/// Refuses a material that is none or two, and what no dose diffuses with.
fn must_be_one(material: &MaterialSpec, optimizes_dose: bool) -> Result<()> {
    match (&material.photopolymer, &material.diffusion) {
        (Some(_), None) => return Ok(()),
        (None, Some(_)) => {}
        (first, _) => {
            let found = if first.is_some() { "two" } else { "none" };
            return Err(Error::config(
                "material",
                format!("{found} of photopolymer and diffusion"),
                "one of the two",
            ));
        }
    }
    if material.air_on_top {
        return Err(Error::config(
            "material.air_on_top",
            "air, and no inhibitor that it would hold",
            "false with material.diffusion, or inhibitors in material.photopolymer.networks",
        ));
    }
    if !optimizes_dose {
        return Err(Error::config(
            "schedule.optimize",
            "a dose that diffuses is what \"dose\" is optimized against",
            "\"dose\" with material.diffusion",
        ));
    }
    Ok(())
}

/// Refuses networks that have the names of species in another order: a network is that of the species at its place.
fn must_be_in_order(spec: &JobSpec, rows: &[Row]) -> Result<()> {
    for (s, (network, (species, _))) in spec.networks().iter().zip(rows).enumerate() {
        if network.name != *species && rows.iter().any(|(name, _)| *name == network.name) {
            return Err(Error::config(
                format!("material.photopolymer.networks[{s}].name"),
                format!("`{}`, in the place of species `{species}`", network.name),
                "networks in the order of the species, one for each",
            ));
        }
    }
    Ok(())
}

/// Refuses what asks for an inhibitor where there is none.
fn must_have_inhibitors(spec: &JobSpec, rows: &[Row], given: &ScheduleSpec) -> Result<()> {
    let (material, networks) = (spec.material.as_ref(), spec.networks());
    let has_air = material.is_some_and(|material| material.air_on_top);
    let stays_empty = |s: usize, inhibitor: &Inhibitor| {
        let is_made = rows
            .get(s)
            .is_some_and(|(_, row)| row.iter().any(|&m| m < 0.0));
        inhibitor.initial.is_none() && !is_made && !(has_air && inhibitor.from_air)
    };
    let takes_nothing = |(s, network): (usize, &Network)| {
        network
            .inhibitors
            .iter()
            .all(|inhibitor| stays_empty(s, inhibitor))
            && network.dose_diffusion_mm2_per_s == 0.0
            && network.bleaching_mm3_per_mj == 0.0
    };
    if given.optimize == Against::Frozen && networks.iter().enumerate().all(takes_nothing) {
        let is_bare = networks.iter().all(|network| network.inhibitors.is_empty());
        let none = match is_bare {
            true => "no network has an inhibitor",
            false => "every inhibitor is 0 from beginning to end",
        };
        return Err(Error::config(
            "schedule.optimize",
            format!("\"frozen\", and {none}: there is nothing to freeze"),
            "\"dose\", or inhibitors in material.photopolymer.networks",
        ));
    }
    for (s, (name, row)) in rows.iter().enumerate() {
        let inhibits = row.iter().position(|&factor| factor < 0.0);
        let has_none = networks.get(s).is_none_or(|n| n.inhibitors.is_empty());
        if let Some(light) = inhibits.filter(|_| has_none) {
            let light = spec.light[light].name.as_deref().unwrap_or("light");
            return Err(Error::config(
                format!("material.photopolymer.networks[{s}].inhibitors"),
                format!(
                    "none, and {light} inhibits {name}: in the print in time it would do nothing"
                ),
                "an inhibitor that this light makes, with initial = { even = 0.0 } where there is none in the dark",
            ));
        }
    }
    Ok(())
}

/// Refuses separate patterns for every turn where all turns are alike.
fn must_tell_turns_apart(spec: &JobSpec, given: &ScheduleSpec) -> Result<()> {
    if !given.own_patterns {
        return Ok(());
    }
    let diffuses = spec
        .material
        .as_ref()
        .is_some_and(|material| material.diffusion.is_some());
    if given.optimize != Against::Exact && !diffuses {
        return Err(Error::config(
            "schedule.own_patterns",
            "against the dose, and with the inhibitor frozen, all turns are worth the same",
            "optimize = \"exact\" or material.diffusion with it",
        ));
    }
    if given.turns != given.turns.round() {
        return Err(Error::config(
            "schedule.turns",
            format!("found {}, each with own_patterns", exact(given.turns)),
            "a whole number",
        ));
    }
    if let Some(i) = spec.light.iter().position(|light| light.turns.is_some()) {
        return Err(Error::config(
            format!("light[{i}].turns"),
            "turns of its own, with patterns of their own for every turn of schedule.turns",
            "schedule.turns for all lights, or schedule.own_patterns = false",
        ));
    }
    let broken = |light: &LightSpec| light.angles.turn_after_turn(1).is_none();
    match spec.light.iter().position(broken) {
        Some(i) => Err(Error::config(
            format!("light[{i}].angles.arc_deg"),
            "turns with patterns of their own need a whole turn",
            "360, or list_deg",
        )),
        None => Ok(()),
    }
}

/// Refuses a step of time that is not stable on these voxels, and a print of more stable steps than can be taken.
pub(crate) fn must_be_stable(spec: &JobSpec, grid: &VolumeGrid) -> Result<()> {
    let Some(given) = &spec.schedule else {
        return Ok(());
    };
    let mut domain = Domain::new(grid.clone());
    if spec.material.as_ref().is_some_and(|m| m.air_on_top) {
        domain = domain.with_air_on_top();
    }
    let material = material(spec, spec.mixing()?.as_deref(), domain)?;
    let Some(step_s) = given.step_s else {
        return must_be_few(spec, &material, &schedule(spec)?);
    };
    match exceeded_limit_s(&material, step_s) {
        None => Ok(()),
        Some(limit) => Err(Error::config(
            "schedule.step_s",
            format!(
                "found {step_s} s, but diffusion through the faces of voxels is stable up to {limit} s only"
            ),
            "a shorter step, larger voxels (grid.pitch_mm), or material.photopolymer.diffusion = \"spectral\"",
        )),
    }
}

/// Refuses a print that the steps which the program chooses would cut into too many: because of what diffuses fast, or of what takes long.
fn must_be_few(spec: &JobSpec, material: &Photopolymer, schedule: &Schedule) -> Result<()> {
    let step_s = default_step_s(material, schedule);
    let Err(Error::Config { accepted, .. }) = schedule.must_cut(step_s) else {
        return Ok(());
    };
    let (print_s, most) = (schedule.end_s(), material.longest_step_s());
    let (key, found, instead) = if most == step_s {
        let (key, fastest) = fastest(spec);
        let found = format!(
            "found {} mm²/s: on these voxels steps are stable up to {most:.2e} s, for a print of {} s",
            exact(fastest),
            exact(print_s)
        );
        let instead = "slower diffusion, larger voxels (grid.pitch_mm), or material.photopolymer.diffusion = \"spectral\"";
        (key, found, instead)
    } else {
        let (key, value) = longest(spec);
        let found = format!(
            "found {} s, for a print of {} s in steps of {} s",
            exact(value),
            exact(print_s),
            exact(step_s)
        );
        (key, found, "a shorter print, or a longer schedule.step_s")
    };
    Err(Error::config(key, found, format!("{accepted}: {instead}")))
}

/// The key of what diffuses fastest through the faces of voxels, mm²/s.
fn fastest(spec: &JobSpec) -> (String, f64) {
    let rates_of = |(s, network): (usize, &Network)| {
        let at = format!("material.photopolymer.networks[{s}]");
        let dose = network.dose_diffusion_mm2_per_s;
        let inhibitors = network.inhibitors.iter().enumerate();
        let inhibitors = inhibitors.map(|(i, inhibitor)| {
            let key = format!("{at}.inhibitors[{i}].diffusion_mm2_per_s");
            (key, inhibitor.diffusion_mm2_per_s)
        });
        let dose = std::iter::once((format!("{at}.dose_diffusion_mm2_per_s"), dose));
        dose.chain(inhibitors).collect::<Vec<_>>()
    };
    let all = spec.networks().iter().enumerate().flat_map(rates_of);
    let fastest = all.max_by(|a, b| a.1.total_cmp(&b.1));
    fastest.unwrap_or_else(|| ("material.photopolymer".to_owned(), 0.0))
}

/// The key of the schedule that takes most of the print, s.
fn longest(spec: &JobSpec) -> (String, f64) {
    let given = spec.schedule.clone().unwrap_or_default();
    let turn_s = given.seconds_per_turn.unwrap_or(60.0 / spec.output.rpm);
    let turns = spec.light.iter().filter_map(|light| light.turns);
    let turns = turns.fold(given.turns, f64::max);
    let parts = [
        ("turns", turns, turns * turn_s),
        ("dark_before_s", given.dark_before_s, given.dark_before_s),
        (
            "dark_between_s",
            given.dark_between_s,
            given.dark_between_s * turns,
        ),
        ("dark_after_s", given.dark_after_s, given.dark_after_s),
    ];
    let longest = parts.into_iter().max_by(|a, b| a.2.total_cmp(&b.2));
    let (key, value, _) = longest.unwrap_or(parts[0]);
    (format!("schedule.{key}"), value)
}
