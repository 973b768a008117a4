//! `tomolith expose`: how a run's frames are to be shown so that the resin gels.

mod trade_off;

use crate::answer::{Answer, percent};
use crate::arguments::Manner;
use clap::Args;
use serde_json::Value;
use std::path::{Path, PathBuf};
use tomolith::error::above_zero;
use tomolith::exposure::{PrinterSpec, SLOWEST, is_too_slow};
use tomolith::io::read_text;
use tomolith::job::export::job_of_run;
use tomolith::job::{Angles, Job};
use tomolith::report::json::read as read_report;
use tomolith::report::number::significant;
use tomolith::units::concise;
use tomolith::{Error, Result};
use tomolith_planning::delivered::ShownFrames;
use tomolith_planning::plan::{ExposurePlan, Machine, Window};
use tomolith_planning::quantity::{IRRADIANCE, POWER, VOLUMETRIC_DOSE};

/// Images a second of a machine that the job does not name.
const REFRESH_HZ: f64 = 240.0;

/// Seconds of a print from which on resin does not keep still.
const LONG_S: f64 = 1800.0;

const EXAMPLES: &str = "\
Examples:
  tomolith expose out/09-printer --irradiance 25
  tomolith expose out/01-gear --trade-off                             # shorter prints, and what they lose
  tomolith expose out/01-gear --trade-off --row 3 --output faster.toml
  tomolith expose out/09-printer --power \"0.7 W\" --critical-dose \"0.8 J/cm3\" --turns 4
  tomolith expose out/01-gear --irradiance \"250 W/m2\" --critical-dose 0.8 --within-s 120
What is left out is taken from the run's job: printer.peak_irradiance_mw_per_cm2, resin.critical_dose_mj_per_mm3, output.rpm";

#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct ExposeArguments {
    /// Folder of a run
    run: PathBuf,
    /// TOML file with the table `printer` of the machine; that of the run when left out
    #[arg(long, value_name = "FILE")]
    printer: Option<PathBuf>,
    /// Which light, of several
    #[arg(long, value_name = "NAME")]
    light: Option<String>,
    /// Irradiance at white at the vial, mW/cm² (or with its unit)
    #[arg(long, value_name = "IRRADIANCE", conflicts_with = "power")]
    irradiance: Option<String>,
    /// Power at the vial with every pixel of printer.canvas white, mW (or with its unit)
    #[arg(long, value_name = "POWER")]
    power: Option<String>,
    /// Dose at which the resin gels, mJ/mm³ (or with its unit)
    #[arg(long, value_name = "DOSE")]
    critical_dose: Option<String>,
    /// Turns a minute
    #[arg(long, conflicts_with = "turns")]
    rpm: Option<f64>,
    /// Turns that the print takes, the light always on: the speed follows
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    turns: Option<u32>,
    /// Longest time that the print may take
    #[arg(long, value_name = "S")]
    within_s: Option<f64>,
    /// Show quality against time, as the run found it on pixels of twice the width, in place of a plan
    #[arg(long, conflicts_with_all = ["printer", "light", "irradiance", "power", "critical_dose", "rpm", "turns", "within_s"])]
    trade_off: bool,
    /// Write the job with the brightest pixel of this row of --trade-off
    #[arg(long, value_name = "ROW", requires_all = ["trade_off", "output"])]
    row: Option<usize>,
    /// Job file that --row writes; a new file
    #[arg(short, long, value_name = "FILE", requires = "row")]
    output: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) manner: Manner,
}

/// `exposure.json` of a run folder.
fn exposure_of(run: &Path) -> Result<Value> {
    let path = run.join("exposure.json");
    if !path.exists() {
        let run = run.display();
        let found =
            format!("`{run}` has no exposure.json: it was run with --keep metrics or patterns");
        return Err(Error::config("RUN", found, "a run that left all its files"));
    }
    serde_json::from_str(&read_text(&path)?)
        .map_err(|e| Error::format(path, e.to_string(), "the file of a run of Tomolith"))
}

fn missing(key: &str, what: &str, accepted: &str) -> Error {
    Error::config(key, format!("nothing says {what}"), accepted)
}

pub(crate) fn expose(given: &ExposeArguments) -> Result<()> {
    if given.trade_off {
        return trade_off::trade_off(given);
    }
    above_zero("--rpm", given.rpm.unwrap_or(1.0))?;
    above_zero("--within-s", given.within_s.unwrap_or(1.0))?;
    let job = job_of_run(&given.run, given.printer.as_deref(), &[])?;
    let i = light(given, &job)?;
    let printer = job.spec.printer_of(i).unwrap_or_default();
    let exposure = exposure_of(&given.run)?;
    if given.printer.is_some() {
        must_show(&printer, &exposure["lights"][i])?;
        let of_run = job_of_run(&given.run, None, &[])?;
        must_shine(&printer, &of_run.spec.printer_of(i).unwrap_or_default())?;
    }
    let shown = shown(given, &job, i, &printer, &exposure["lights"][i])?;
    let machine = machine(given, &job, &printer, &shown)?;
    let critical = critical_dose(given, &job)?;
    let report = read_report(&given.run)?;
    // Several species have one exposure, where a dose makes all of them solid
    let together = &report["one_exposure"];
    let reported_percent = report["exposure"]["reported_percent"].as_f64();
    let gel_dose = gel_dose(&report)?;
    let window = [together, &report["exposure"]].map(|exposure| &exposure["percent"]);
    let window = window.into_iter().find(|percent| percent.is_object());
    let window = window.map(|window| Window {
        low: window["low"].as_f64(),
        high: window["high"].as_f64(),
    });
    let Some(white) = shown
        .white
        .or_else(|| exposure["lights"][i]["white"].as_f64())
    else {
        return Err(Error::config(
            "RUN",
            "frames that do not say which pattern value white stands for",
            "frames of a run",
        ));
    };
    let angles = &job.spec.light[i].angles;
    let arc = match angles {
        Angles::Even { count, arc_deg, .. } => arc_deg.to_radians() / *count as f64,
        Angles::List(_) => 0.0,
    };
    let in_time = match (&job.spec.material, &job.spec.schedule) {
        (Some(_), _) => Some(
            "the job has a material in time, and this plan counts dose alone: what an inhibitor takes and where dose diffuses is left out. \
             Take times and energies from the job's print in time (tomolith run or print)",
        ),
        (None, Some(_)) => Some("this plan does not follow the schedule of the job"),
        (None, None) => None,
    };
    let plan = ExposurePlan::new(&shown, &machine, white, arc, critical, gel_dose, window)?;
    show(
        given,
        &machine,
        &shown,
        &plan,
        Remarks {
            windows: windows(&report, gel_dose),
            in_time,
            reported_percent: reported_percent.filter(|_| !together.is_object()),
            arc_deg: arc.to_degrees() * shown.sums.len() as f64,
            is_toy: report["is_toy"] == true,
        },
    );
    Ok(())
}

/// Dose at which the resin gels, mJ/mm³.
fn critical_dose(given: &ExposeArguments, job: &Job) -> Result<f64> {
    if let Some(text) = &given.critical_dose {
        return VOLUMETRIC_DOSE.parse("--critical-dose", text);
    }
    job.spec.resin.critical_dose_mj_per_mm3.ok_or_else(|| {
        let material = job.spec.material.as_ref();
        let has_networks = material.is_some_and(|m| m.photopolymer.is_some());
        missing(
            "--critical-dose",
            match has_networks {
                true => {
                    "at which dose the resin gels without inhibitors (each of its networks has one of its own)"
                }
                false => "at which dose the resin gels",
            },
            "a dose per volume, or resin.critical_dose_mj_per_mm3 in the job",
        )
    })
}

/// The relative dose at which the part of a run gels.
fn gel_dose(report: &Value) -> Result<f64> {
    // A gray target has no threshold of its own: that of its report belongs to the exposure that is reported
    let reported_percent = report["exposure"]["reported_percent"].as_f64();
    let of_gray = report["evaluation"]["gel_threshold"].as_f64();
    let of_gray = of_gray.map(|dose| dose * reported_percent.unwrap_or(100.0) / 100.0);
    let gel_doses = [
        report["one_exposure"]["gel_dose"].as_f64(),
        report["exposure"]["dose"]["best"].as_f64(),
        of_gray,
    ];
    let gel_dose = gel_doses.into_iter().flatten().next();
    gel_dose.filter(|dose| *dose > 0.0).ok_or_else(|| {
        let found = "its report names no dose at which the part gels: nothing prints, or the target is gray";
        Error::config("RUN", found, "a run that prints a part")
    })
}

/// Refuses a machine whose pixels are not those of the frames.
fn must_show(printer: &PrinterSpec, light: &Value) -> Result<()> {
    let number = |value: &Value| value.as_f64().unwrap_or_default();
    let pitch_mm = [0, 1].map(|k| number(&light["pixel_pitch_mm"][k]));
    let canvas = ["columns", "rows"].map(|key| number(&light[key]));
    let in_mm = |mm: [f64; 2]| format!("pixels of {} × {} mm", concise(mm[0]), concise(mm[1]));
    let in_pixels = |n: [f64; 2]| format!("{} × {} pixels", n[0], n[1]);
    let is_apart = |a: [f64; 2], b: [f64; 2]| (0..2).any(|k| (a[k] / b[k] - 1.0).abs() > 1e-6);
    let of_pitch =
        (printer.pixel_pitch_mm).map(|pitch| (pitch.0, pitch_mm, in_mm(pitch.0), in_mm(pitch_mm)));
    let of_canvas = printer.canvas.map(|canvas| canvas.map(|n| n as f64));
    let of_canvas = of_canvas.map(|own| (own, canvas, in_pixels(own), in_pixels(canvas)));
    for (own, of_frames, machine, frames) in of_pitch.into_iter().chain(of_canvas) {
        if is_apart(own, of_frames) {
            return Err(Error::config(
                "--printer",
                format!("{machine}, and the frames of this run have {frames}"),
                "the machine of the run; for another one, the folder that `tomolith simulate JOB --patterns RUN` writes for it",
            ));
        }
    }
    Ok(())
}

/// Keys of a machine that do not change the light of its frames, or are compared apart.
const OF_NO_LIGHT: [&str; 6] = [
    "canvas",
    "pixel_pitch_mm",
    "refresh_hz",
    "peak_irradiance_mw_per_cm2",
    "time_s",
    "stack",
];

/// Refuses a machine on which the frames of a run, made for another one, are other light; what its file leaves out counts as the run's.
fn must_shine(printer: &PrinterSpec, of_run: &PrinterSpec) -> Result<()> {
    let keys = |spec: &PrinterSpec| match serde_json::to_value(spec) {
        Ok(Value::Object(keys)) => keys,
        _ => serde_json::Map::new(),
    };
    let (of_run, default) = (keys(of_run), keys(&PrinterSpec::default()));
    for (key, value) in keys(printer) {
        let is_given = default.get(&key).unwrap_or(&Value::Null) != &value;
        let other = of_run.get(&key).unwrap_or(&Value::Null);
        if is_given && !OF_NO_LIGHT.contains(&key.as_str()) && !is_same(&value, other) {
            return Err(Error::config(
                "--printer",
                format!(
                    "its `{key}` is not that of the machine that the frames of this run were made for, so they are other light there"
                ),
                "the machine of the run; for another one, the folder that `tomolith export RUN --printer FILE` writes for it",
            ));
        }
    }
    Ok(())
}

/// Whether two values are equal, or name files of the same content.
fn is_same(a: &Value, b: &Value) -> bool {
    let content = |value: &Value| {
        let path = value.as_str().filter(|path| Path::new(path).is_file())?;
        std::fs::read(path).ok()
    };
    a == b || content(a).is_some_and(|content_of_a| content(b) == Some(content_of_a))
}

/// What a plan says besides its numbers.
struct Remarks {
    /// Process windows over the dose that gels, by the names of species.
    windows: Vec<(String, f64)>,
    /// What the plan leaves out of a job with a schedule or a material in time.
    in_time: Option<&'static str>,
    /// The exposure of the report's numbers, % of the best one.
    reported_percent: Option<f64>,
    /// What one pass of the frames covers.
    arc_deg: f64,
    /// Whether the run is a toy of its job.
    is_toy: bool,
}

/// Process windows as shares of the dose that gels, of each species where there are several; none of a response that is no dose, whose window gives
/// no time, and of a gray target, which has none.
fn windows(report: &Value, gel_dose: f64) -> Vec<(String, f64)> {
    let window_of = |name: &Value, one: &Value| {
        let exposure = &one["exposure"];
        let dose = &exposure["dose"]["best"];
        let is_dose = dose.is_number() && exposure["threshold"]["best"] == *dose;
        let pw = one["evaluation"]["pw"].as_f64().filter(|_| is_dose)?;
        Some((name.as_str().unwrap_or_default().to_owned(), pw / gel_dose))
    };
    match report["species"].as_array() {
        Some(species) if species.len() > 1 => species
            .iter()
            .filter_map(|one| window_of(&one["name"], one))
            .collect(),
        _ => window_of(&Value::Null, report).into_iter().collect(),
    }
}

/// Which of the job's lights is meant.
fn light(given: &ExposeArguments, job: &Job) -> Result<usize> {
    let lights = &job.spec.light;
    let names: Vec<&str> = lights
        .iter()
        .filter_map(|light| light.name.as_deref())
        .collect();
    match &given.light {
        None if lights.len() == 1 => Ok(0),
        None => Err(Error::config(
            "--light",
            format!("the run has {} lights", lights.len()),
            format!("one of them: {}", names.join(", ")),
        )),
        Some(wanted) => lights
            .iter()
            .position(|light| light.name.as_deref() == Some(wanted))
            .ok_or_else(|| {
                let accepted = if names.is_empty() {
                    "no such option: the run's only light has no name".to_owned()
                } else {
                    names.join(", ")
                };
                Error::config("--light", format!("unknown light `{wanted}`"), accepted)
            }),
    }
}

fn shown(
    given: &ExposeArguments,
    job: &Job,
    i: usize,
    printer: &PrinterSpec,
    light: &Value,
) -> Result<ShownFrames> {
    let frames = given.run.join("frames");
    let several = job.spec.light.len() > 1;
    let folder = match &job.spec.light[i].name {
        Some(name) if several => frames.join(name),
        _ => frames,
    };
    let pitch = &light["pixel_pitch_mm"];
    let Some(pitch) = pitch[0].as_f64().zip(pitch[1].as_f64()) else {
        return Err(Error::format(
            given.run.join("exposure.json"),
            "no pixel_pitch_mm",
            "the file of a run of Tomolith",
        ));
    };
    ShownFrames::read(&folder, printer, &job.base(), [pitch.0, pitch.1])
}

fn machine(
    given: &ExposeArguments,
    job: &Job,
    printer: &PrinterSpec,
    shown: &ShownFrames,
) -> Result<Machine> {
    let irradiance = match (&given.irradiance, &given.power) {
        (Some(text), _) => IRRADIANCE.parse("--irradiance", text)?,
        (None, Some(text)) => {
            let power = POWER.parse("--power", text)?;
            if printer.canvas.is_none() {
                return Err(Error::config(
                    "--power",
                    "nothing says how many pixels the device has among which its power is spread: the frames of this run are those of its patterns",
                    "printer.canvas = [columns, rows] in the job; --irradiance; or --printer FILE with the canvas that the frames were made for",
                ));
            }
            power / shown.white_cm2()
        }
        (None, None) => printer.peak_irradiance_mw_per_cm2.ok_or_else(|| {
            missing(
                "--irradiance",
                "how bright the machine is",
                "an irradiance, or --power, or printer.peak_irradiance_mw_per_cm2 in the job or, where it is given, in the profile of --printer",
            )
        })?,
    };
    Ok(Machine {
        irradiance,
        rpm: given.rpm.unwrap_or(job.spec.output.rpm),
        turns: given.turns.map(f64::from),
        refresh_hz: job
            .spec
            .printer
            .as_ref()
            .map_or(REFRESH_HZ, |printer| printer.refresh_hz),
        within_s: given.within_s,
    })
}

fn range(window: Window, unit: &str) -> String {
    let text = |value: Option<f64>, none: &str| {
        value.map_or_else(|| none.to_owned(), |v| significant(v, 4))
    };
    format!(
        "{} to {} {unit}",
        text(window.low, "any"),
        text(window.high, "any")
    )
}

fn show(
    given: &ExposeArguments,
    machine: &Machine,
    shown: &ShownFrames,
    plan: &ExposurePlan,
    remarks: Remarks,
) {
    let mut answer = Answer::default();
    if let Some(left_out) = remarks.in_time {
        answer.warn(left_out);
    }
    if remarks.is_toy {
        answer.warn("these are the frames of a toy of the job, with larger pixels and fewer angles: plan those of a whole run");
    }
    answer.number("irradiance at white", machine.irradiance, 4, "mW/cm²");
    let unit = "mJ/mm² of a frame over the print";
    answer.number("white", plan.white_mj_per_mm2, 4, unit);
    answer.number("time to print", plan.time_s, 4, "s");
    tell_turns(&mut answer, plan, remarks.arc_deg);
    if let Some(percent) =
        (remarks.reported_percent).filter(|percent| (percent - 100.0).abs() > 0.5)
    {
        let percent = significant(percent, 4);
        answer.line(
            "report",
            format!("its numbers are of {percent} % of this exposure, which is the best one"),
        );
    }
    tell_frames(&mut answer, shown, plan, remarks.arc_deg);
    warn_of_slow_movie(&mut answer, shown.sums.len(), plan);
    tell_windows(&mut answer, plan, &remarks.windows);
    if plan.rpm > 60.0 {
        answer.warn(format!(
            "{} turns a minute throw resin about: fewer turns are slower",
            significant(plan.rpm, 3)
        ));
    }
    if plan.turns < 3.0 && plan.time_s < 20.0 {
        answer.warn("in fewer than three turns the resin begins to gel from one side; a lower irradiance takes more turns");
    }
    if plan.time_s > LONG_S {
        answer.warn(format!(
            "the print takes {} h, and resin keeps still for minutes: look at the units of irradiance and critical dose, or use a brighter projector",
            significant(plan.time_s / 3600.0, 3)
        ));
    }
    answer.set("plan", plan);
    answer.set("irradiance_mw_per_cm2", machine.irradiance);
    answer.tell(given.manner);
}

/// Whether frames cover a whole turn.
fn is_whole(arc_deg: f64) -> bool {
    arc_deg > 360.0 - 1e-6
}

/// How often and how fast the vial turns.
fn tell_turns(answer: &mut Answer, plan: &ExposurePlan, arc_deg: f64) {
    let rpm = significant(plan.rpm, 4);
    let turns = match is_whole(arc_deg) {
        true if plan.turns_a_pass > 1.0 => format!(
            "{} at {rpm} a minute, in passes of {} turns, each with frames of its own",
            concise(plan.turns),
            concise(plan.turns_a_pass)
        ),
        true => format!("{} at {rpm} a minute", concise(plan.turns)),
        false => format!(
            "{} passes of {}°, one after the other, at the speed of {rpm} turns a minute",
            concise(plan.turns),
            significant(arc_deg, 4)
        ),
    };
    answer.line("turns", turns);
    if !is_whole(arc_deg) {
        answer.warn("the frames cover a part of a turn: each pass must begin at the same side of the vial. On a stage that turns on, the next pass comes from other sides; \
             give light.angles a whole turn for it, or bring the vial back in the dark, which takes longer than is counted here");
    }
}

/// What a frame gets, and all of them.
fn tell_frames(answer: &mut Answer, shown: &ShownFrames, plan: &ExposurePlan, arc_deg: f64) {
    answer.line(
        "light on for",
        format!("{} of each frame", percent(plan.duty)),
    );
    answer.line(
        "frames",
        format!(
            "{} a {}, {} a second, {} ms each",
            shown.sums.len(),
            if is_whole(arc_deg) && plan.turns_a_pass == 1.0 {
                "turn"
            } else {
                "pass"
            },
            significant(plan.frame_rate_hz, 4),
            significant(1e3 * plan.frame_s, 4)
        ),
    );
    let [mean, largest] = plan.frame_mj;
    answer.line(
        "energy of a frame",
        format!(
            "{} mJ, at most {} mJ",
            significant(mean, 3),
            significant(largest, 3)
        ),
    );
    answer.line(
        "delivered light",
        format!(
            "{} J, {} of what the device can give",
            significant(1e-3 * plan.energy_mj, 4),
            percent(plan.light_used)
        ),
    );
}

/// Warns of a speed at which `export` makes no movie.
fn warn_of_slow_movie(answer: &mut Answer, frames: usize, plan: &ExposurePlan) {
    if !is_too_slow(plan.frame_rate_hz, frames) {
        return;
    }
    let faster = SLOWEST / plan.frame_rate_hz;
    answer.warn(format!(
        "{} turns a minute make a movie of {} frames a second, which players do not show evenly and `tomolith export` refuses: \
         {} turns a minute (--rpm), or {} turns (--turns), are the least",
        significant(plan.rpm, 4),
        significant(plan.frame_rate_hz, 3),
        concise(plan.rpm * faster),
        concise((plan.turns * faster / plan.turns_a_pass - 1e-9).ceil() * plan.turns_a_pass)
    ));
}

/// Exposures nearly as good as the best, and process windows.
fn tell_windows(answer: &mut Answer, plan: &ExposurePlan, windows: &[(String, f64)]) {
    if let (Some(in_percent), Some(seconds)) = (plan.window_percent, plan.window_s) {
        answer.line(
            "nearly as good",
            format!(
                "{}, {} of the best exposure",
                range(seconds, "s"),
                range(in_percent, "%")
            ),
        );
    }
    for (name, pw) in windows {
        let comma = if name.is_empty() { "" } else { ", " };
        let long = match *pw >= 0.0 {
            true => format!("{} s", significant(pw * plan.time_s, 3)),
            false => "so no time prints all of the part and nothing else".to_owned(),
        };
        answer.line(
            "process window",
            format!(
                "{} of the gel dose, {long} (min in − max out{comma}{name})",
                percent(*pw)
            ),
        );
    }
    // The species with the smallest one decides
    let least = windows.iter().map(|(_, pw)| *pw).reduce(f64::min);
    if let Some(pw) = least {
        answer.set("pw_percent", 100.0 * pw);
        answer.set("pw_s", (pw >= 0.0).then_some(pw * plan.time_s));
    }
}
