//! What keys must be to one another, before any work. The range of a single number stands at its key, and is checked where the job is read
//! ([`NumberRange`](crate::kind::NumberRange)).

use super::angles::MOST_FRAMES;
use super::file_names;
use crate::error::{Error, Result, in_range};
use crate::exposure::movie::FASTEST;
use crate::exposure::{PrinterSpec, shown_rate};
use crate::job::spec::species::at_species;
use crate::job::spec::{
    Angles, BoundsSpec, DoseConvention, JobSpec, LightPrinterSpec, LightSpec, OutputSpec,
    ResinSpec, SelectionSpec,
};
use crate::units::{Mm, exact};
use std::collections::BTreeSet;

/// Fastest turn of a vial, 1/min.
const MOST_RPM: f64 = 1000.0;
/// Strongest absorption, 1/mm: light is gone within a hundredth of a millimeter.
const MOST_ABSORPTION: f64 = 100.0;
/// Weakest absorption, 1/mm: doses of far less are indistinguishable from 0.
const LEAST_ABSORPTION: f64 = 1e-9;

/// Checks the tables.
///
/// # Errors
/// [`Error::Config`] with key path, value and what is accepted; the place is added by
/// [`Document::locate`](crate::job::Document::locate).
pub fn tables(spec: &JobSpec) -> Result<()> {
    resin(&spec.resin)?;
    for i in 0..spec.light.len() {
        resin(&spec.resin_of(i)).map_err(|e| e.under(&format!("light[{i}]")))?;
    }
    lights(&spec.light)?;
    species(spec)?;
    bounds_and_stop(spec)?;
    output(spec)?;
    printer(spec)
}

/// The machine, and whether it can show the frames as fast as they follow each other.
fn printer(spec: &JobSpec) -> Result<()> {
    let refresh_hz = match &spec.printer {
        None => FASTEST,
        Some(printer) => {
            printer.ranges()?;
            printer.refresh_hz
        }
    };
    for (i, light) in spec.light.iter().enumerate() {
        match spec.printer_of(i) {
            Some(printer) => printer
                .ranges()
                .and_then(|()| printer.must_hold(spec.evaluate.bit_depth))
                .map_err(|e| spec.at_printer_of(i, e))?,
            None if light.printer != LightPrinterSpec::default() => {
                return Err(Error::config(
                    format!("light[{i}].printer"),
                    "what the machine is to this light, in a job without a machine",
                    "a table [printer] in the job, which may be empty",
                ));
            }
            None => {}
        }
        let in_time = [
            ("turns", light.turns.is_some()),
            ("power", light.power.is_some()),
        ];
        for (key, _) in in_time.iter().filter(|(_, is_given)| *is_given) {
            if spec.schedule.is_none() {
                return Err(Error::config(
                    format!("light[{i}].{key}"),
                    "a key of the print in time, in a job without a schedule",
                    "a table [schedule] in the job",
                ));
            }
        }
        if let Angles::Even { count, arc_deg, .. } = light.angles {
            shown_rate(spec.output.rpm, count, arc_deg.to_radians(), refresh_hz)
                .map_err(|e| at_speed(spec, i, e))?;
        }
    }
    let time_s = spec.printer.as_ref().and_then(|printer| printer.time_s);
    if time_s.is_some() && spec.schedule.is_some() {
        return Err(Error::config(
            "printer.time_s",
            "a time beside [schedule], whose turns say how long the print takes",
            "only one of the two",
        ));
    }
    let mut printers = (0..spec.light.len()).filter_map(|i| spec.printer_of(i));
    if let Some(time_s) = time_s
        && printers.any(|printer| printer.peak_irradiance_mw_per_cm2.is_none())
    {
        return Err(Error::config(
            "printer.time_s",
            format!("{} s without a peak irradiance", exact(time_s)),
            "also printer.peak_irradiance_mw_per_cm2, or leave this key out",
        ));
    }
    if time_s.is_some() && spec.resin.critical_dose_mj_per_mm3.is_none() {
        return Err(Error::config(
            "printer.time_s",
            "a time without the dose that the resin needs",
            "also resin.critical_dose_mj_per_mm3, or leave this key out",
        ));
    }
    Ok(())
}

/// Blames a movie that cannot be shown on the key that the job sets: the speed, the device, else the frames of the light.
fn at_speed(spec: &JobSpec, i: usize, mut error: Error) -> Error {
    let device = spec.printer.as_ref().map(|printer| printer.refresh_hz);
    let schedule = spec.schedule.as_ref();
    if let Error::Config { key, .. } = &mut error
        && schedule.is_some_and(|table| table.seconds_per_turn.is_some())
    {
        "schedule.seconds_per_turn".clone_into(key);
    } else if let Error::Config { key, .. } = &mut error
        && spec.output.rpm == OutputSpec::default().rpm
    {
        *key = match device {
            Some(hz) if hz != PrinterSpec::default().refresh_hz => "printer.refresh_hz".to_owned(),
            _ => format!("light[{i}].angles"),
        };
    }
    error
}

fn resin(resin: &ResinSpec) -> Result<()> {
    absorption(resin)?;
    if let Some(attenuation) = resin.attenuation_per_mm {
        // What the absorption is worth with `pure_radon`, which does not use it, is still no more than the attenuation
        let least = resin.absorption_per_mm.unwrap_or(0.0) + resin.scattering_per_mm.max(0.0);
        let accepted = format!(
            "a number of at least resin.absorption_per_mm + resin.scattering_per_mm = {least}, in 1/mm"
        );
        in_range(
            attenuation >= least && attenuation.is_finite(),
            "resin.attenuation_per_mm",
            attenuation,
            accepted,
        )?;
    }
    if resin.scattering_per_mm > 0.0 && resin.pure_radon {
        return Err(Error::config(
            "resin.scattering_per_mm",
            format!(
                "found {} together with resin.pure_radon = true",
                resin.scattering_per_mm
            ),
            "0, or an absorption in place of pure_radon",
        ));
    }
    if resin.critical_dose_mj_per_mm3.is_some() && resin.dose_convention != DoseConvention::Energy {
        return Err(Error::config(
            "resin.critical_dose_mj_per_mm3",
            "found together with resin.dose_convention = \"drtvam\", whose doses are no energies",
            "resin.dose_convention = \"energy\"",
        ));
    }
    Ok(())
}

fn absorption(resin: &ResinSpec) -> Result<()> {
    let key = "resin.absorption_per_mm";
    let range = LEAST_ABSORPTION..=MOST_ABSORPTION;
    let accepted = format!(
        "{LEAST_ABSORPTION:e} to {MOST_ABSORPTION} per mm, or resin.pure_radon = true for the plain sum of fluence"
    );
    match resin.absorption_per_mm {
        None | Some(0.0) if resin.pure_radon => Ok(()),
        None => Err(Error::config(key, "the key is missing", accepted)),
        Some(0.0) => {
            let found = "found 0: a resin that absorbs nothing gets no dose";
            Err(Error::config(key, found, accepted))
        }
        Some(absorption) => in_range(range.contains(&absorption), key, absorption, accepted),
    }
}

fn lights(lights: &[LightSpec]) -> Result<()> {
    if lights.is_empty() {
        return Err(Error::config(
            "light",
            "no light",
            "at least one table [[light]]",
        ));
    }
    let mut names = BTreeSet::new();
    for (i, one) in lights.iter().enumerate() {
        light(one).map_err(|e| e.under(&format!("light[{i}]")))?;
        let key = format!("light[{i}].name");
        if let Some(name) = &one.name {
            file_name(&key, name)?;
        }
        match &one.name {
            None if lights.len() > 1 => {
                return Err(Error::config(
                    key,
                    "the key is missing",
                    "a name, because there are several lights",
                ));
            }
            Some(name) if lights.len() > 1 && (name == "raw" || name.starts_with("raw_")) => {
                return Err(Error::config(
                    key,
                    format!(
                        "found {name:?}, as patterns.npz names what was wanted: `patterns_raw`, `patterns_raw_<light>`"
                    ),
                    "a name that is not raw and does not begin with raw_",
                ));
            }
            name => {
                if !names.insert(name.as_deref().map(str::to_ascii_lowercase)) {
                    return Err(Error::config(
                        key,
                        format!(
                            "found \"{}\" a second time",
                            name.as_deref().unwrap_or_default()
                        ),
                        "names that differ",
                    ));
                }
            }
        }
    }
    Ok(())
}

/// The objectives of every species, their names, and who drives them.
fn species(spec: &JobSpec) -> Result<()> {
    spec.objectives()?;
    for (s, species) in spec.species.iter().enumerate() {
        file_name(&format!("species[{s}].name"), &species.name)?;
        spec.of_species(s)
            .objectives()
            .map_err(|e| at_species(spec, s, e))?;
    }
    for (i, property) in spec.property.iter().enumerate() {
        file_name(&format!("property[{i}].name"), &property.name)?;
    }
    spec.mixing()?;
    file_names::must_differ(spec)?;
    co_optimized(spec)
}

fn light(light: &LightSpec) -> Result<()> {
    for (i, Mm(mm)) in light.offset_mm.into_iter().enumerate() {
        let accepted = "a length, -1000 to 1000 mm";
        in_range(mm.abs() <= 1000.0, format!("offset_mm[{i}]"), mm, accepted)?;
    }
    selection(light).map_err(|e| e.under("selection"))?;
    match &light.angles {
        Angles::List(list) if !(1..=MOST_FRAMES).contains(&list.len()) => {
            let found = match list.len() {
                0 => "found an empty list".to_owned(),
                n => format!("found a list of {n}"),
            };
            let accepted = format!("1 to {MOST_FRAMES} azimuths in degrees, one per frame");
            Err(Error::config("angles.list_deg", found, accepted))
        }
        _ => Ok(()),
    }
}

fn selection(light: &LightSpec) -> Result<()> {
    let SelectionSpec { columns, rows, .. } = &light.selection;
    for (key, range, all) in [
        ("columns", columns, light.pixels[0]),
        ("rows", rows, light.pixels[1]),
    ] {
        match *range {
            Some([first, count]) if count == 0 || first.saturating_add(count) > all => {
                return Err(Error::config(
                    key,
                    format!("found [{first}, {count}], but there are {all}"),
                    format!("the first, from 0, and a count of at least 1, within the {all}"),
                ));
            }
            _ => {}
        }
    }
    Ok(())
}

fn bounds_and_stop(spec: &JobSpec) -> Result<()> {
    let BoundsSpec { min, max, .. } = spec.bounds;
    optional(max, |max| above("bounds.max", max, "bounds.min", min))?;
    for (i, light) in spec.light.iter().enumerate() {
        let key = |name: &str| format!("light[{i}].bounds.{name}");
        let least = light.bounds.min.unwrap_or(min);
        let from = match light.bounds.min {
            Some(_) => key("min"),
            None => "bounds.min".to_owned(),
        };
        optional(light.bounds.max, |most| {
            above(&key("max"), most, &from, least)
        })?;
        optional(max.filter(|_| light.bounds.max.is_none()), |most| {
            let accepted = format!("less than bounds.max = {most}");
            in_range(least < most, &from, least, accepted)
        })?;
    }
    let stop = &spec.stop;
    // 0 is never; less than these would be, too
    for (key, part, least) in [
        ("stop.gap", stop.gap, 1e-6),
        ("stop.relative_loss", stop.relative_loss, 1e-12),
    ] {
        let part = part.unwrap_or_default();
        let accepted = format!("0: never; or {least:e} to 0.99");
        in_range(part == 0.0 || part >= least, key, part, accepted)?;
    }
    if let (Some(after), None) = (stop.change_after, stop.change) {
        return Err(Error::config(
            "stop.change_after",
            format!("{after}, but stop.change is not set"),
            "both stop.change and stop.change_after, or neither",
        ));
    }
    Ok(())
}

fn output(spec: &JobSpec) -> Result<()> {
    if spec.output.rpm > MOST_RPM {
        // Turns of the schedule are those of the movie
        let key = "schedule.seconds_per_turn";
        let accepted = format!("at most {MOST_RPM} turns per minute");
        return Err(Error::refused(key, exact(spec.output.rpm), accepted));
    }
    let folder = spec.output.folder.as_deref();
    if folder.is_some_and(|folder| folder.as_os_str().is_empty()) {
        return Err(Error::config(
            "output.folder",
            "found an empty path",
            "a folder",
        ));
    }
    Ok(())
}

/// Refuses names that cannot be part of the name of a file.
fn file_name(key: &str, name: &str) -> Result<()> {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    let is_in = (1..=64).contains(&name.len()) && name.chars().all(is_plain);
    let accepted = "1 to 64 letters, digits, - and _ (it is part of file names)";
    match is_in {
        true => Ok(()),
        false => Err(Error::config(key, format!("found {name:?}"), accepted)),
    }
}

fn optional(value: Option<f64>, check: impl Fn(f64) -> Result<()>) -> Result<()> {
    value.map_or(Ok(()), check)
}

/// The largest value of pixels, which some room must lie below.
fn above(key: &str, value: f64, least_key: &str, least: f64) -> Result<()> {
    let accepted = format!("more than {least_key} = {least}");
    in_range(value > least, key, value, accepted)
}

/// Refuses tables of the job that do not go with unknowns of the response.
fn co_optimized(spec: &JobSpec) -> Result<()> {
    let Some(unknowns) = &spec.co_optimize else {
        return Ok(());
    };
    if unknowns.response.is_empty() {
        return Err(Error::config(
            "co_optimize.response",
            "no parameter",
            "one or more with their ranges, for example steepness = [10.0, 150.0]; or leave [co_optimize] out",
        ));
    }
    let time_s = spec.printer.as_ref().and_then(|printer| printer.time_s);
    for (key, is_there, found) in [
        (
            "species",
            !spec.species.is_empty(),
            "several species, each with a response, in a job with [co_optimize], which changes one response",
        ),
        (
            "printer.time_s",
            time_s.is_some(),
            "the largest pixel follows from the dose at which the resin turns solid, which [co_optimize] moves",
        ),
    ] {
        if is_there {
            return Err(Error::config(key, found, "only one of the two"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::{FULL, document_of};

    #[test]
    fn a_good_job_passes_and_each_bad_number_is_named() {
        let check = |changes: &[&str]| {
            let spec = JobSpec::from_document(&document_of(FULL, changes));
            spec.and_then(|spec| tables(&spec))
        };
        check(&[]).unwrap();
        check(&["resin.absorption_per_mm=0", "resin.pure_radon=true"]).unwrap();
        // Never, as where they are left out
        let never = ["stop.change=0", "stop.gap=0", "stop.projected_gradient=0"];
        check(&never).unwrap();
        // With the key that is blamed where it is another one than that which is set, and with what else is said
        let slips = r#"
            grid.pitch_mm=0
            grid.pitch_mm="-1 mm"
            grid.shape=[4, 0, 4] → grid.shape[1]
            resin.refractive_index=0.9
            resin.absorption_per_mm=0
            resin.absorption_per_mm=1e300
            resin.absorption_per_mm=1e-30 → resin.absorption_per_mm → 1e-9 to 100 per mm
            resin.absorption_per_mm=-0.1
            resin.attenuation_per_mm=0.01
            resin.dose_convention="watts"
            resin.scattering_per_mm=-0.1 → resin.scattering_per_mm → 1/mm
            resin.critical_dose_mj_per_mm3=0
            vial.surrounding_index=0
            bath={ absorption_per_mm = -0.1, radius_mm = 20 } → bath.absorption_per_mm
            bath={ absorption_per_mm = 0.1, radius_mm = 0 } → bath.radius_mm
            light=[]
            light.name=a/b → light[0].name
            light=[{ name = "a", pixels = [8, 8], angles = 8, projector = { collimated = { pixel_pitch_mm = 0.1 } } }, { name = "raw_a", pixels = [8, 8], angles = 8, projector = { collimated = { pixel_pitch_mm = 0.1 } } }] → light[1].name
            light.wavelength_nm=0.405 → light[0].wavelength_nm
            light.pixels=[0, 5] → light[0].pixels[0]
            light.angles=0 → light[0].angles
            light.angles.arc_deg=0 → light[0].angles.arc_deg
            light.angles.arc_deg=720 → light[0].angles.arc_deg
            light.angles={ list_deg = [] } → light[0].angles.list_deg → an empty list
            light.sub_angles=0 → light[0].sub_angles
            bounds.min=-1
            bounds.min=1e30 → bounds.min → 0 to 1e9
            light[0].bounds.max=0
            light[0].bounds.min=9
            bounds.max=1e30 → bounds.max → above 0, at most 1e9
            bounds.min=5 → bounds.max
            bounds={ min = 0.01, max = 0.01 } → bounds.max
            light[0].bounds={ min = 3.0 } → light[0].bounds.min
            bounds.bits=0 → bounds.bits → 1 to 16
            multiresolution.levels=9
            bounds.bits=17
            stop.iterations="two" → stop.iterations → a whole number, 0 or more
            stop.iterations=2.5 → stop.iterations → a whole number, 0 or more
            stop.change=-1
            stop.change_after=9
            stop.gap=1e-9
            stop.relative_loss=1
            stop.iou=1.5
            stop.wall_s=0
            stop.projected_gradient=-1
            checkpoint.every_s=0
            evaluate.bit_depth=17 → evaluate.bit_depth → 1 to 16
            evaluate.refine=0
            grid.refine=0
            grid.refine=33
            evaluate.trim_percent=50
            evaluate.require_iou=99
            evaluate.require_in_band=-1
            evaluate.threshold=0
            output.rpm=0
            output.rpm=90
            output.rpm=0.03
            printer.quarter_turns=4
            printer.canvas=[0, 9] → printer.canvas[0]
            printer.refresh_hz=20
            light.angles=7200 → light[0].angles
            printer.time_s=60
            printer={ time_s = 60.0, peak_irradiance_mw_per_cm2 = 5.0 } → printer.time_s
            printer.gray_curve=[[0.0, 0.0], [0.5, 0.6], [1.0, 0.5]]
            output.folder=""
            objectives=[{ l2 = {} }]
        "#;
        for slip in slips.trim().lines().map(str::trim) {
            let mut parts = slip.split(" → ");
            let change = parts.next().unwrap();
            let key = parts.next().or(change.split('=').next()).unwrap();
            let error = check(&[change]).expect_err(change);
            let blames = matches!(&error, Error::Config { key: found, .. } if found == key);
            assert!(blames, "{change}: {error:?}");
            tomolith_core::contains!(error.to_string(), parts.next().unwrap_or_default());
        }
    }
}
